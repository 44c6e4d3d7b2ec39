var<private> infinity_bits_0 : u32 = 2139095040u;
@binding(27) @group(0) var<storage, read_write> cell_keys_0 : array<atomic<u32>>;

@binding(28) @group(0) var<storage, read_write> cell_rows_0 : array<vec4<u32>>;

struct RealTimeParams_std140_0
{
    @align(16) eye_0 : vec3<f32>,
    @align(4) view_angle_0 : f32,
    @align(16) before_eye_0 : vec3<f32>,
    @align(4) number_0 : u32,
    @align(16) before_corner_0 : vec3<f32>,
    @align(4) candidates_0 : u32,
    @align(16) before_pixel_x_0 : vec3<f32>,
    @align(4) flags_0 : u32,
    @align(16) before_pixel_y_0 : vec3<f32>,
    @align(4) most_paths_0 : f32,
    @align(16) before_lens_x_0 : vec3<f32>,
    @align(4) before_blades_0 : u32,
    @align(16) before_lens_y_0 : vec3<f32>,
    @align(4) cell_samples_0 : f32,
    @align(16) before_place_0 : vec3<f32>,
    @align(4) motions_0 : u32,
    @align(16) before_rows_0 : array<vec4<f32>, i32(3)>,
    @align(16) before_origin_0 : vec3<f32>,
    @align(4) pixels_0 : u32,
    @align(16) slots_0 : u32,
    @align(4) cells_0 : u32,
    @align(8) squares_0 : u32,
    @align(4) again_0 : u32,
    @align(16) exposure_0 : f32,
    @align(4) curve_0 : u32,
    @align(8) share_0 : f32,
    @align(4) padding_0 : u32,
};

@binding(24) @group(0) var<uniform> real_time_0 : RealTimeParams_std140_0;
struct FrameParams_std140_0
{
    @align(16) eye_1 : vec3<f32>,
    @align(4) width_0 : u32,
    @align(16) corner_0 : vec3<f32>,
    @align(4) height_0 : u32,
    @align(16) pixel_x_0 : vec3<f32>,
    @align(4) lens_0 : u32,
    @align(16) pixel_y_0 : vec3<f32>,
    @align(4) sky_0 : u32,
    @align(16) region_0 : vec4<u32>,
    @align(16) max_bounces_0 : u32,
    @align(4) is_transparent_0 : u32,
    @align(8) first_sample_0 : u32,
    @align(4) seed_0 : u32,
    @align(16) sky_nadir_0 : vec3<f32>,
    @align(4) sky_brightness_0 : f32,
    @align(16) sky_zenith_0 : vec3<f32>,
    @align(4) light_intensity_0 : f32,
    @align(16) sun_direction_0 : vec3<f32>,
    @align(4) sun_one_minus_cos_theta_max_0 : f32,
    @align(16) sun_tangent_0 : vec3<f32>,
    @align(4) sun_sin_radius_0 : f32,
    @align(16) sun_bitangent_0 : vec3<f32>,
    @align(4) sun_irradiance_0 : f32,
    @align(16) sun_radiance_0 : vec3<f32>,
    @align(4) sun_pdf_0 : f32,
    @align(16) lens_x_0 : vec3<f32>,
    @align(4) light_node_count_0 : u32,
    @align(16) lens_y_0 : vec3<f32>,
    @align(4) blades_0 : u32,
    @align(16) sky_turned_0 : vec2<f32>,
    @align(8) sky_edge_0 : u32,
    @align(4) sky_irradiance_0 : f32,
    @align(16) emitter_intensity_0 : f32,
    @align(4) bounce_limits_0 : u32,
    @align(8) clamp_indirect_0 : f32,
    @align(4) instance_count_0 : u32,
    @align(16) planes_0 : array<vec4<f32>, i32(12)>,
    @align(16) plane_count_0 : u32,
    @align(4) cuts_cast_shadows_0 : u32,
    @align(8) clear_shadows_0 : u32,
    @align(4) hides_sun_disc_0 : u32,
    @align(16) ground_material_0 : u32,
    @align(4) catcher_sun_share_0 : f32,
    @align(8) catcher_cube_share_0 : f32,
    @align(4) grid_spacing_0 : u32,
    @align(16) edge_color_0 : vec3<f32>,
    @align(4) edge_width_0 : f32,
    @align(16) grid_color_0 : vec3<f32>,
    @align(4) grid_width_0 : f32,
};

@binding(9) @group(0) var<uniform> params_0 : FrameParams_std140_0;
@binding(25) @group(0) var<storage, read_write> memory_rows_0 : array<vec4<u32>>;

@binding(26) @group(0) var<storage, read_write> scratch_0 : array<vec2<u32>>;

@binding(29) @group(0) var<storage, read> motions_1 : array<vec4<f32>>;

@binding(12) @group(0) var<storage, read_write> picture_0 : array<vec2<u32>>;

@binding(15) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

struct Dispatch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) count_0 : u32,
    @align(8) samples_0 : u32,
    @align(4) samples_target_0 : u32,
    @align(16) padding_1 : vec3<u32>,
    @align(4) sequence_0 : u32,
};

@binding(16) @group(0) var<uniform> dispatch_0 : Dispatch_std140_0;
fn is_inside_0( at_0 : vec2<i32>) -> bool
{
    var _S1 : bool;
    if((all((at_0 >= vec2<i32>(i32(0))))))
    {
        _S1 = (at_0.x) < i32(params_0.width_0);
    }
    else
    {
        _S1 = false;
    }
    if(_S1)
    {
        _S1 = (at_0.y) < i32(params_0.height_0);
    }
    else
    {
        _S1 = false;
    }
    return _S1;
}

fn index_of_0( at_1 : vec2<u32>) -> u32
{
    return at_1.y * params_0.width_0 + at_1.x;
}

fn scratch_row_0( row_0 : u32,  index_0 : u32) -> vec2<u32>
{
    return scratch_0[row_0 * real_time_0.slots_0 + index_0];
}

fn numbers_0( row_1 : u32,  index_1 : u32) -> vec2<f32>
{
    return (bitcast<vec2<f32>>((scratch_row_0(row_1, index_1))));
}

fn mean_down_0( row_2 : u32,  at_2 : vec2<i32>,  reach_0 : i32) -> vec2<f32>
{
    var _S2 : vec2<f32> = vec2<f32>(0.0f);
    var dy_0 : i32 = - reach_0;
    var sum_0 : vec2<f32> = _S2;
    var count_1 : f32 = 0.0f;
    for(;;)
    {
        if(dy_0 <= reach_0)
        {
        }
        else
        {
            break;
        }
        var other_0 : vec2<i32> = at_2 + vec2<i32>(i32(0), dy_0);
        if(!is_inside_0(other_0))
        {
            dy_0 = dy_0 + i32(1);
            continue;
        }
        var count_2 : f32 = count_1 + 1.0f;
        sum_0 = sum_0 + numbers_0(row_2, index_of_0(vec2<u32>(other_0)));
        count_1 = count_2;
        dy_0 = dy_0 + i32(1);
    }
    return sum_0 / vec2<f32>(count_1);
}

fn low_half_0( word_0 : u32) -> f32
{
    return unpack2x16float(word_0).x;
}

fn high_half_0( word_1 : u32) -> f32
{
    return unpack2x16float(word_1).y;
}

fn color_in_0( row_3 : u32,  index_2 : u32) -> vec4<f32>
{
    var words_0 : vec2<u32> = scratch_row_0(row_3, index_2);
    var _S3 : u32 = words_0.x;
    var _S4 : u32 = words_0.y;
    return vec4<f32>(low_half_0(_S3), high_half_0(_S3), low_half_0(_S4), high_half_0(_S4));
}

fn trusted_light_0( at_3 : vec2<i32>,  noisy_0 : vec3<f32>) -> vec3<f32>
{
    var mean_0 : vec2<f32> = mean_down_0(u32(3), at_3, i32(4));
    return noisy_0 + (color_in_0(u32(0), index_of_0(vec2<u32>(at_3))).xyz - noisy_0) * vec3<f32>(min(1.20000004768371582f * mean_0.y / max(mean_0.x, 1.00000000317107685e-30f), 1.0f));
}

fn set_scratch_row_0( row_4 : u32,  index_3 : u32,  value_0 : vec2<u32>)
{
    scratch_0[row_4 * real_time_0.slots_0 + index_3] = value_0;
    return;
}

fn set_numbers_0( row_5 : u32,  index_4 : u32,  value_1 : vec2<f32>)
{
    set_scratch_row_0(row_5, index_4, (bitcast<vec2<u32>>((value_1))));
    return;
}

fn compare_across_0( at_4 : vec2<i32>)
{
    var _S5 : vec2<f32> = vec2<f32>(0.0f);
    var dx_0 : i32 = i32(-4);
    var sum_1 : vec2<f32> = _S5;
    var count_3 : f32 = 0.0f;
    for(;;)
    {
        if(dx_0 <= i32(4))
        {
        }
        else
        {
            break;
        }
        var other_1 : vec2<i32> = at_4 + vec2<i32>(dx_0, i32(0));
        if(!is_inside_0(other_1))
        {
            dx_0 = dx_0 + i32(1);
            continue;
        }
        var count_4 : f32 = count_3 + 1.0f;
        sum_1 = sum_1 + numbers_0(u32(6), index_of_0(vec2<u32>(other_1)));
        count_3 = count_4;
        dx_0 = dx_0 + i32(1);
    }
    set_numbers_0(u32(3), index_of_0(vec2<u32>(at_4)), sum_1 / vec2<f32>(count_3));
    return;
}

fn memory_row_0( row_6 : u32,  index_5 : u32) -> vec4<u32>
{
    return memory_rows_0[row_6 * real_time_0.pixels_0 + index_5];
}

var<private> WAVELET_THRESHOLD_0 : array<f32, i32(2)> = array<f32, i32(2)>( 4.0f, 1.60000002384185791f );
fn details_0( at_5 : vec2<i32>,  level_0 : i32) -> vec3<f32>
{
    var index_6 : u32 = index_of_0(vec2<u32>(at_5));
    var _S6 : u32 = u32((level_0 & (i32(1))));
    var fine_0 : vec3<f32> = color_in_0(_S6, index_6).xyz;
    var coarse_0 : vec3<f32> = color_in_0(u32(((level_0 + i32(1)) & (i32(1)))), index_6).xyz;
    var _S7 : vec2<f32> = vec2<f32>(0.0f);
    var dy_1 : i32 = i32(-1);
    var sum_2 : vec2<f32> = _S7;
    for(;;)
    {
        if(dy_1 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_1 : i32 = i32(-1);
        var sum_3 : vec2<f32> = sum_2;
        for(;;)
        {
            if(dx_1 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_2 : vec2<i32> = at_5 + vec2<i32>(dx_1, dy_1);
            if(is_inside_0(other_2))
            {
                sum_3 = sum_3 + numbers_0(u32(5) + _S6, index_of_0(vec2<u32>(other_2)));
            }
            dx_1 = dx_1 + i32(1);
        }
        dy_1 = dy_1 + i32(1);
        sum_2 = sum_3;
    }
    if((low_half_0(memory_row_0(u32(1), index_6).x)) < 1.5f)
    {
        dy_1 = i32(0);
    }
    else
    {
        dy_1 = i32(1);
    }
    return (fine_0 - coarse_0) * vec3<f32>(max(1.0f - WAVELET_THRESHOLD_0[dy_1] * sum_2.y / max(sum_2.x, 1.00000000317107685e-30f), 0.0f));
}

fn luminance_0( color_0 : vec3<f32>) -> f32
{
    return color_0.x * 0.2125999927520752f + color_0.y * 0.71520000696182251f + color_0.z * 0.07220000028610229f;
}

fn halves_0( low_0 : f32,  high_0 : f32) -> u32
{
    return pack2x16float(clamp(vec2<f32>(low_0, high_0), vec2<f32>(-65504.0f), vec2<f32>(65504.0f)));
}

fn set_color_0( row_7 : u32,  index_7 : u32,  color_1 : vec4<f32>)
{
    set_scratch_row_0(row_7, index_7, vec2<u32>(halves_0(color_1.x, color_1.y), halves_0(color_1.z, color_1.w)));
    return;
}

fn end_levels_0( at_6 : vec2<i32>)
{
    var index_8 : u32 = index_of_0(vec2<u32>(at_6));
    var smooth_0 : vec3<f32> = color_in_0(u32(1), index_8).xyz + (color_in_0(u32(2), index_8).xyz + details_0(at_6, i32(4)));
    var own_0 : vec2<f32> = numbers_0(u32(4), index_8);
    var step_0 : f32 = luminance_0(smooth_0) - own_0.y;
    set_color_0(u32(0), index_8, vec4<f32>(smooth_0, 0.0f));
    set_numbers_0(u32(6), index_8, vec2<f32>(step_0 * step_0, own_0.x));
    return;
}

struct Center_0
{
     normal_0 : vec3<f32>,
     place_0 : vec3<f32>,
     is_covered_0 : bool,
     normal_scale_0 : f32,
     place_scale_0 : f32,
     least_0 : f32,
};

fn normal_in_0( word_2 : u32) -> vec3<f32>
{
    return vec3<f32>(vec3<i32>((i32((word_2 << (u32(22)))) >> (u32(22))), (i32((word_2 << (u32(12)))) >> (u32(22))), (i32((word_2 << (u32(2)))) >> (u32(22))))) * vec3<f32>(0.00195694714784622f);
}

fn dot_product_0( a_0 : vec3<f32>,  b_0 : vec3<f32>) -> f32
{
    return a_0.x * b_0.x + a_0.y * b_0.y + a_0.z * b_0.z;
}

fn length_squared_0( vector_0 : vec3<f32>) -> f32
{
    return dot_product_0(vector_0, vector_0);
}

fn center_of_0( index_9 : u32) -> Center_0
{
    var surface_0 : vec4<u32> = memory_row_0(u32(0), index_9);
    var shaded_0 : vec4<u32> = memory_row_0(u32(1), index_9);
    var center_0 : Center_0;
    var _S8 : u32 = surface_0.w;
    var _S9 : vec3<f32> = normal_in_0(_S8);
    center_0.normal_0 = _S9;
    center_0.place_0 = (bitcast<vec3<f32>>((surface_0.xyz)));
    center_0.is_covered_0 = ((_S8 & (u32(1073741824)))) != u32(0);
    center_0.normal_scale_0 = 1.0f / (0.40000000596046448f + max(1.0f - length_squared_0(_S9), 0.0f));
    center_0.place_scale_0 = 1.0f / (12.0f + high_half_0(shaded_0.y));
    center_0.least_0 = 0.20000000298023224f / max(low_half_0(shaded_0.x), 1.0f);
    return center_0;
}

fn Center_alike_0( this_0 : Center_0,  index_10 : u32) -> f32
{
    var surface_1 : vec4<u32> = memory_row_0(u32(0), index_10);
    var _S10 : bool;
    if(!this_0.is_covered_0)
    {
        _S10 = true;
    }
    else
    {
        _S10 = (((surface_1.w) & (u32(1073741824)))) == u32(0);
    }
    if(_S10)
    {
        return 0.0f;
    }
    var distance_0 : f32 = dot_product_0(this_0.normal_0, (bitcast<vec3<f32>>((surface_1.xyz))) - this_0.place_0);
    var _S11 : f32 = max(1.0f - length_squared_0(this_0.normal_0 - normal_in_0(surface_1.w)) * this_0.normal_scale_0, 0.0f);
    var _S12 : f32 = max(1.0f - distance_0 * distance_0 * this_0.place_scale_0, 0.0f);
    return _S11 * _S11 * _S12 * _S12 + this_0.least_0;
}

fn smooth_light_0( at_7 : vec2<i32>)
{
    var index_11 : u32 = index_of_0(vec2<u32>(at_7));
    var own_1 : vec4<f32> = color_in_0(u32(0), index_11);
    var _S13 : vec4<f32> = color_in_0(u32(2), index_11);
    var kept_0 : vec4<f32> = _S13;
    var paths_0 : f32 = low_half_0(memory_row_0(u32(1), index_11).x);
    var _S14 : vec3<f32> = _S13.xyz + details_0(at_7, i32(3));
    kept_0.x = _S14.x;
    kept_0.y = _S14.y;
    kept_0.z = _S14.z;
    var fall_0 : f32;
    if(paths_0 < 7.5f)
    {
        fall_0 = 0.80000001192092896f;
    }
    else
    {
        fall_0 = 0.60000002384185791f;
    }
    kept_0[i32(3)] = max(kept_0.w * fall_0, min(kept_0.w, 2.5f));
    set_color_0(u32(2), index_11, kept_0);
    var _S15 : Center_0 = center_of_0(index_11);
    var middle_0 : f32;
    if(paths_0 < 31.5f)
    {
        middle_0 = 0.5f;
    }
    else
    {
        middle_0 = 0.60000002384185791f;
    }
    var _S16 : vec2<f32> = vec2<f32>(middle_0, 0.5f * (1.0f - middle_0));
    var _S17 : vec3<f32> = own_1.xyz;
    var own_luminance_0 : f32 = luminance_0(_S17);
    var _S18 : f32 = own_1.w;
    var own_variance_0 : f32 = _S18 * _S18;
    var square_0 : f32 = kept_0.w * kept_0.w;
    var _S19 : f32 = square_0 * (own_variance_0 + 9.99999997475242708e-07f * own_luminance_0 * own_luminance_0 + 9.999999960041972e-13f);
    if(paths_0 < 3.5f)
    {
        fall_0 = 0.0f;
    }
    else
    {
        fall_0 = square_0 * (0.20000000298023224f / paths_0);
    }
    var own_weight_0 : f32 = middle_0 * middle_0;
    var _S20 : vec3<f32> = _S17 * vec3<f32>(own_weight_0);
    var _S21 : f32 = own_variance_0 * (own_weight_0 * own_weight_0);
    var dy_2 : i32 = i32(-1);
    var color_2 : vec3<f32> = _S20;
    var variance_0 : f32 = _S21;
    var weights_0 : f32 = own_weight_0;
    for(;;)
    {
        if(dy_2 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_2 : i32 = i32(-1);
        var color_3 : vec3<f32> = color_2;
        var variance_1 : f32 = variance_0;
        var weights_1 : f32 = weights_0;
        for(;;)
        {
            if(dx_2 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_3 : vec2<i32> = at_7 + ((vec2<i32>(dx_2, dy_2) << (vec2<u32>(u32(4)))));
            var _S22 : bool;
            if(dx_2 == i32(0))
            {
                _S22 = dy_2 == i32(0);
            }
            else
            {
                _S22 = false;
            }
            var _S23 : bool;
            if(_S22)
            {
                _S23 = true;
            }
            else
            {
                _S23 = !is_inside_0(other_3);
            }
            if(_S23)
            {
                dx_2 = dx_2 + i32(1);
                continue;
            }
            var beside_0 : u32 = index_of_0(vec2<u32>(other_3));
            var light_0 : vec4<f32> = color_in_0(u32(0), beside_0);
            var _S24 : vec3<f32> = light_0.xyz;
            var difference_0 : f32 = luminance_0(_S24) - own_luminance_0;
            var _S25 : f32 = light_0.w;
            var _S26 : f32 = max(1.0f - difference_0 * difference_0 / (_S19 + fall_0 * (_S25 * _S25)), 0.0f);
            var weight_0 : f32 = _S16[abs(dx_2)] * _S16[abs(dy_2)] * Center_alike_0(_S15, beside_0) * _S26 * _S26;
            var variance_2 : f32 = variance_1 + weight_0 * weight_0 * _S25 * _S25;
            var weights_2 : f32 = weights_1 + weight_0;
            color_3 = color_3 + _S24 * vec3<f32>(weight_0);
            variance_1 = variance_2;
            weights_1 = weights_2;
            dx_2 = dx_2 + i32(1);
        }
        dy_2 = dy_2 + i32(1);
        color_2 = color_3;
        variance_0 = variance_1;
        weights_0 = weights_1;
    }
    var over_0 : f32 = 1.0f / weights_0;
    var color_4 : vec3<f32> = color_2 * vec3<f32>(over_0);
    var variance_3 : f32 = variance_0 * (over_0 * over_0);
    set_color_0(u32(1), index_11, vec4<f32>(color_4, sqrt(variance_3)));
    var detail_0 : f32 = luminance_0(_S17 - color_4);
    set_numbers_0(u32(5), index_11, vec2<f32>(detail_0 * detail_0, max(own_variance_0 * (1.0f - 2.0f * own_weight_0 * over_0) + variance_3, 0.0f)));
    return;
}

fn smooth_light_1( at_8 : vec2<i32>)
{
    var index_12 : u32 = index_of_0(vec2<u32>(at_8));
    var own_2 : vec4<f32> = color_in_0(u32(1), index_12);
    var _S27 : vec4<f32> = color_in_0(u32(2), index_12);
    var kept_1 : vec4<f32> = _S27;
    var paths_1 : f32 = low_half_0(memory_row_0(u32(1), index_12).x);
    var _S28 : vec3<f32> = _S27.xyz + details_0(at_8, i32(2));
    kept_1.x = _S28.x;
    kept_1.y = _S28.y;
    kept_1.z = _S28.z;
    var fall_1 : f32;
    if(paths_1 < 7.5f)
    {
        fall_1 = 0.80000001192092896f;
    }
    else
    {
        fall_1 = 0.60000002384185791f;
    }
    kept_1[i32(3)] = max(kept_1.w * fall_1, min(kept_1.w, 2.5f));
    set_color_0(u32(2), index_12, kept_1);
    var _S29 : Center_0 = center_of_0(index_12);
    var middle_1 : f32;
    if(paths_1 < 31.5f)
    {
        middle_1 = 0.5f;
    }
    else
    {
        middle_1 = 0.60000002384185791f;
    }
    var _S30 : vec2<f32> = vec2<f32>(middle_1, 0.5f * (1.0f - middle_1));
    var _S31 : vec3<f32> = own_2.xyz;
    var own_luminance_1 : f32 = luminance_0(_S31);
    var _S32 : f32 = own_2.w;
    var own_variance_1 : f32 = _S32 * _S32;
    var square_1 : f32 = kept_1.w * kept_1.w;
    var _S33 : f32 = square_1 * (own_variance_1 + 9.99999997475242708e-07f * own_luminance_1 * own_luminance_1 + 9.999999960041972e-13f);
    if(paths_1 < 3.5f)
    {
        fall_1 = 0.0f;
    }
    else
    {
        fall_1 = square_1 * (0.20000000298023224f / paths_1);
    }
    var own_weight_1 : f32 = middle_1 * middle_1;
    var _S34 : vec3<f32> = _S31 * vec3<f32>(own_weight_1);
    var _S35 : f32 = own_variance_1 * (own_weight_1 * own_weight_1);
    var dy_3 : i32 = i32(-1);
    var color_5 : vec3<f32> = _S34;
    var variance_4 : f32 = _S35;
    var weights_3 : f32 = own_weight_1;
    for(;;)
    {
        if(dy_3 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_3 : i32 = i32(-1);
        var color_6 : vec3<f32> = color_5;
        var variance_5 : f32 = variance_4;
        var weights_4 : f32 = weights_3;
        for(;;)
        {
            if(dx_3 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_4 : vec2<i32> = at_8 + ((vec2<i32>(dx_3, dy_3) << (vec2<u32>(u32(3)))));
            var _S36 : bool;
            if(dx_3 == i32(0))
            {
                _S36 = dy_3 == i32(0);
            }
            else
            {
                _S36 = false;
            }
            var _S37 : bool;
            if(_S36)
            {
                _S37 = true;
            }
            else
            {
                _S37 = !is_inside_0(other_4);
            }
            if(_S37)
            {
                dx_3 = dx_3 + i32(1);
                continue;
            }
            var beside_1 : u32 = index_of_0(vec2<u32>(other_4));
            var light_1 : vec4<f32> = color_in_0(u32(1), beside_1);
            var _S38 : vec3<f32> = light_1.xyz;
            var difference_1 : f32 = luminance_0(_S38) - own_luminance_1;
            var _S39 : f32 = light_1.w;
            var _S40 : f32 = max(1.0f - difference_1 * difference_1 / (_S33 + fall_1 * (_S39 * _S39)), 0.0f);
            var weight_1 : f32 = _S30[abs(dx_3)] * _S30[abs(dy_3)] * Center_alike_0(_S29, beside_1) * _S40 * _S40;
            var variance_6 : f32 = variance_5 + weight_1 * weight_1 * _S39 * _S39;
            var weights_5 : f32 = weights_4 + weight_1;
            color_6 = color_6 + _S38 * vec3<f32>(weight_1);
            variance_5 = variance_6;
            weights_4 = weights_5;
            dx_3 = dx_3 + i32(1);
        }
        dy_3 = dy_3 + i32(1);
        color_5 = color_6;
        variance_4 = variance_5;
        weights_3 = weights_4;
    }
    var over_1 : f32 = 1.0f / weights_3;
    var color_7 : vec3<f32> = color_5 * vec3<f32>(over_1);
    var variance_7 : f32 = variance_4 * (over_1 * over_1);
    set_color_0(u32(0), index_12, vec4<f32>(color_7, sqrt(variance_7)));
    var detail_1 : f32 = luminance_0(_S31 - color_7);
    set_numbers_0(u32(6), index_12, vec2<f32>(detail_1 * detail_1, max(own_variance_1 * (1.0f - 2.0f * own_weight_1 * over_1) + variance_7, 0.0f)));
    return;
}

fn smooth_light_2( at_9 : vec2<i32>)
{
    var index_13 : u32 = index_of_0(vec2<u32>(at_9));
    var own_3 : vec4<f32> = color_in_0(u32(0), index_13);
    var _S41 : vec4<f32> = color_in_0(u32(2), index_13);
    var kept_2 : vec4<f32> = _S41;
    var paths_2 : f32 = low_half_0(memory_row_0(u32(1), index_13).x);
    var _S42 : vec3<f32> = _S41.xyz + details_0(at_9, i32(1));
    kept_2.x = _S42.x;
    kept_2.y = _S42.y;
    kept_2.z = _S42.z;
    var fall_2 : f32;
    if(paths_2 < 7.5f)
    {
        fall_2 = 0.80000001192092896f;
    }
    else
    {
        fall_2 = 0.60000002384185791f;
    }
    kept_2[i32(3)] = max(kept_2.w * fall_2, min(kept_2.w, 2.5f));
    set_color_0(u32(2), index_13, kept_2);
    var _S43 : Center_0 = center_of_0(index_13);
    var middle_2 : f32;
    if(paths_2 < 31.5f)
    {
        middle_2 = 0.5f;
    }
    else
    {
        middle_2 = 0.60000002384185791f;
    }
    var _S44 : vec2<f32> = vec2<f32>(middle_2, 0.5f * (1.0f - middle_2));
    var _S45 : vec3<f32> = own_3.xyz;
    var own_luminance_2 : f32 = luminance_0(_S45);
    var _S46 : f32 = own_3.w;
    var own_variance_2 : f32 = _S46 * _S46;
    var square_2 : f32 = kept_2.w * kept_2.w;
    var _S47 : f32 = square_2 * (own_variance_2 + 9.99999997475242708e-07f * own_luminance_2 * own_luminance_2 + 9.999999960041972e-13f);
    if(paths_2 < 3.5f)
    {
        fall_2 = 0.0f;
    }
    else
    {
        fall_2 = square_2 * (0.20000000298023224f / paths_2);
    }
    var own_weight_2 : f32 = middle_2 * middle_2;
    var _S48 : vec3<f32> = _S45 * vec3<f32>(own_weight_2);
    var _S49 : f32 = own_variance_2 * (own_weight_2 * own_weight_2);
    var dy_4 : i32 = i32(-1);
    var color_8 : vec3<f32> = _S48;
    var variance_8 : f32 = _S49;
    var weights_6 : f32 = own_weight_2;
    for(;;)
    {
        if(dy_4 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_4 : i32 = i32(-1);
        var color_9 : vec3<f32> = color_8;
        var variance_9 : f32 = variance_8;
        var weights_7 : f32 = weights_6;
        for(;;)
        {
            if(dx_4 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_5 : vec2<i32> = at_9 + ((vec2<i32>(dx_4, dy_4) << (vec2<u32>(u32(2)))));
            var _S50 : bool;
            if(dx_4 == i32(0))
            {
                _S50 = dy_4 == i32(0);
            }
            else
            {
                _S50 = false;
            }
            var _S51 : bool;
            if(_S50)
            {
                _S51 = true;
            }
            else
            {
                _S51 = !is_inside_0(other_5);
            }
            if(_S51)
            {
                dx_4 = dx_4 + i32(1);
                continue;
            }
            var beside_2 : u32 = index_of_0(vec2<u32>(other_5));
            var light_2 : vec4<f32> = color_in_0(u32(0), beside_2);
            var _S52 : vec3<f32> = light_2.xyz;
            var difference_2 : f32 = luminance_0(_S52) - own_luminance_2;
            var _S53 : f32 = light_2.w;
            var _S54 : f32 = max(1.0f - difference_2 * difference_2 / (_S47 + fall_2 * (_S53 * _S53)), 0.0f);
            var weight_2 : f32 = _S44[abs(dx_4)] * _S44[abs(dy_4)] * Center_alike_0(_S43, beside_2) * _S54 * _S54;
            var variance_10 : f32 = variance_9 + weight_2 * weight_2 * _S53 * _S53;
            var weights_8 : f32 = weights_7 + weight_2;
            color_9 = color_9 + _S52 * vec3<f32>(weight_2);
            variance_9 = variance_10;
            weights_7 = weights_8;
            dx_4 = dx_4 + i32(1);
        }
        dy_4 = dy_4 + i32(1);
        color_8 = color_9;
        variance_8 = variance_9;
        weights_6 = weights_7;
    }
    var over_2 : f32 = 1.0f / weights_6;
    var color_10 : vec3<f32> = color_8 * vec3<f32>(over_2);
    var variance_11 : f32 = variance_8 * (over_2 * over_2);
    set_color_0(u32(1), index_13, vec4<f32>(color_10, sqrt(variance_11)));
    var detail_2 : f32 = luminance_0(_S45 - color_10);
    set_numbers_0(u32(5), index_13, vec2<f32>(detail_2 * detail_2, max(own_variance_2 * (1.0f - 2.0f * own_weight_2 * over_2) + variance_11, 0.0f)));
    return;
}

fn smooth_light_3( at_10 : vec2<i32>)
{
    var index_14 : u32 = index_of_0(vec2<u32>(at_10));
    var own_4 : vec4<f32> = color_in_0(u32(1), index_14);
    var _S55 : vec4<f32> = color_in_0(u32(2), index_14);
    var kept_3 : vec4<f32> = _S55;
    var paths_3 : f32 = low_half_0(memory_row_0(u32(1), index_14).x);
    var _S56 : vec3<f32> = _S55.xyz + details_0(at_10, i32(0));
    kept_3.x = _S56.x;
    kept_3.y = _S56.y;
    kept_3.z = _S56.z;
    var fall_3 : f32;
    if(paths_3 < 7.5f)
    {
        fall_3 = 0.80000001192092896f;
    }
    else
    {
        fall_3 = 0.60000002384185791f;
    }
    kept_3[i32(3)] = max(kept_3.w * fall_3, min(kept_3.w, 2.5f));
    set_color_0(u32(2), index_14, kept_3);
    var _S57 : Center_0 = center_of_0(index_14);
    var middle_3 : f32;
    if(paths_3 < 31.5f)
    {
        middle_3 = 0.5f;
    }
    else
    {
        middle_3 = 0.60000002384185791f;
    }
    var _S58 : vec2<f32> = vec2<f32>(middle_3, 0.5f * (1.0f - middle_3));
    var _S59 : vec3<f32> = own_4.xyz;
    var own_luminance_3 : f32 = luminance_0(_S59);
    var _S60 : f32 = own_4.w;
    var own_variance_3 : f32 = _S60 * _S60;
    var square_3 : f32 = kept_3.w * kept_3.w;
    var _S61 : f32 = square_3 * (own_variance_3 + 9.99999997475242708e-07f * own_luminance_3 * own_luminance_3 + 9.999999960041972e-13f);
    if(paths_3 < 3.5f)
    {
        fall_3 = 0.0f;
    }
    else
    {
        fall_3 = square_3 * (0.20000000298023224f / paths_3);
    }
    var own_weight_3 : f32 = middle_3 * middle_3;
    var _S62 : vec3<f32> = _S59 * vec3<f32>(own_weight_3);
    var _S63 : f32 = own_variance_3 * (own_weight_3 * own_weight_3);
    var dy_5 : i32 = i32(-1);
    var color_11 : vec3<f32> = _S62;
    var variance_12 : f32 = _S63;
    var weights_9 : f32 = own_weight_3;
    for(;;)
    {
        if(dy_5 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_5 : i32 = i32(-1);
        var color_12 : vec3<f32> = color_11;
        var variance_13 : f32 = variance_12;
        var weights_10 : f32 = weights_9;
        for(;;)
        {
            if(dx_5 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_6 : vec2<i32> = at_10 + ((vec2<i32>(dx_5, dy_5) << (vec2<u32>(u32(1)))));
            var _S64 : bool;
            if(dx_5 == i32(0))
            {
                _S64 = dy_5 == i32(0);
            }
            else
            {
                _S64 = false;
            }
            var _S65 : bool;
            if(_S64)
            {
                _S65 = true;
            }
            else
            {
                _S65 = !is_inside_0(other_6);
            }
            if(_S65)
            {
                dx_5 = dx_5 + i32(1);
                continue;
            }
            var beside_3 : u32 = index_of_0(vec2<u32>(other_6));
            var light_3 : vec4<f32> = color_in_0(u32(1), beside_3);
            var _S66 : vec3<f32> = light_3.xyz;
            var difference_3 : f32 = luminance_0(_S66) - own_luminance_3;
            var _S67 : f32 = light_3.w;
            var _S68 : f32 = max(1.0f - difference_3 * difference_3 / (_S61 + fall_3 * (_S67 * _S67)), 0.0f);
            var weight_3 : f32 = _S58[abs(dx_5)] * _S58[abs(dy_5)] * Center_alike_0(_S57, beside_3) * _S68 * _S68;
            var variance_14 : f32 = variance_13 + weight_3 * weight_3 * _S67 * _S67;
            var weights_11 : f32 = weights_10 + weight_3;
            color_12 = color_12 + _S66 * vec3<f32>(weight_3);
            variance_13 = variance_14;
            weights_10 = weights_11;
            dx_5 = dx_5 + i32(1);
        }
        dy_5 = dy_5 + i32(1);
        color_11 = color_12;
        variance_12 = variance_13;
        weights_9 = weights_10;
    }
    var over_3 : f32 = 1.0f / weights_9;
    var color_13 : vec3<f32> = color_11 * vec3<f32>(over_3);
    var variance_15 : f32 = variance_12 * (over_3 * over_3);
    set_color_0(u32(0), index_14, vec4<f32>(color_13, sqrt(variance_15)));
    var detail_3 : f32 = luminance_0(_S59 - color_13);
    set_numbers_0(u32(6), index_14, vec2<f32>(detail_3 * detail_3, max(own_variance_3 * (1.0f - 2.0f * own_weight_3 * over_3) + variance_15, 0.0f)));
    return;
}

fn smooth_light_4( at_11 : vec2<i32>)
{
    var index_15 : u32 = index_of_0(vec2<u32>(at_11));
    var own_5 : vec4<f32> = color_in_0(u32(0), index_15);
    var kept_4 : vec4<f32> = color_in_0(u32(2), index_15);
    var paths_4 : f32 = low_half_0(memory_row_0(u32(1), index_15).x);
    var _S69 : Center_0 = center_of_0(index_15);
    var middle_4 : f32;
    if(paths_4 < 31.5f)
    {
        middle_4 = 0.5f;
    }
    else
    {
        middle_4 = 0.60000002384185791f;
    }
    var _S70 : vec2<f32> = vec2<f32>(middle_4, 0.5f * (1.0f - middle_4));
    var _S71 : vec3<f32> = own_5.xyz;
    var own_luminance_4 : f32 = luminance_0(_S71);
    var _S72 : f32 = own_5.w;
    var own_variance_4 : f32 = _S72 * _S72;
    var _S73 : f32 = kept_4.w;
    var square_4 : f32 = _S73 * _S73;
    var _S74 : f32 = square_4 * (own_variance_4 + 9.99999997475242708e-07f * own_luminance_4 * own_luminance_4 + 9.999999960041972e-13f);
    var _S75 : f32;
    if(paths_4 < 3.5f)
    {
        _S75 = 0.0f;
    }
    else
    {
        _S75 = square_4 * (0.20000000298023224f / paths_4);
    }
    var own_weight_4 : f32 = middle_4 * middle_4;
    var _S76 : vec3<f32> = _S71 * vec3<f32>(own_weight_4);
    var _S77 : f32 = own_variance_4 * (own_weight_4 * own_weight_4);
    var dy_6 : i32 = i32(-1);
    var color_14 : vec3<f32> = _S76;
    var variance_16 : f32 = _S77;
    var weights_12 : f32 = own_weight_4;
    for(;;)
    {
        if(dy_6 <= i32(1))
        {
        }
        else
        {
            break;
        }
        var dx_6 : i32 = i32(-1);
        var color_15 : vec3<f32> = color_14;
        var variance_17 : f32 = variance_16;
        var weights_13 : f32 = weights_12;
        for(;;)
        {
            if(dx_6 <= i32(1))
            {
            }
            else
            {
                break;
            }
            var other_7 : vec2<i32> = at_11 + ((vec2<i32>(dx_6, dy_6) << (vec2<u32>(u32(0)))));
            var _S78 : bool;
            if(dx_6 == i32(0))
            {
                _S78 = dy_6 == i32(0);
            }
            else
            {
                _S78 = false;
            }
            var _S79 : bool;
            if(_S78)
            {
                _S79 = true;
            }
            else
            {
                _S79 = !is_inside_0(other_7);
            }
            if(_S79)
            {
                dx_6 = dx_6 + i32(1);
                continue;
            }
            var beside_4 : u32 = index_of_0(vec2<u32>(other_7));
            var light_4 : vec4<f32> = color_in_0(u32(0), beside_4);
            var _S80 : vec3<f32> = light_4.xyz;
            var difference_4 : f32 = luminance_0(_S80) - own_luminance_4;
            var _S81 : f32 = light_4.w;
            var _S82 : f32 = max(1.0f - difference_4 * difference_4 / (_S74 + _S75 * (_S81 * _S81)), 0.0f);
            var weight_4 : f32 = _S70[abs(dx_6)] * _S70[abs(dy_6)] * Center_alike_0(_S69, beside_4) * _S82 * _S82;
            var variance_18 : f32 = variance_17 + weight_4 * weight_4 * _S81 * _S81;
            var weights_14 : f32 = weights_13 + weight_4;
            color_15 = color_15 + _S80 * vec3<f32>(weight_4);
            variance_17 = variance_18;
            weights_13 = weights_14;
            dx_6 = dx_6 + i32(1);
        }
        dy_6 = dy_6 + i32(1);
        color_14 = color_15;
        variance_16 = variance_17;
        weights_12 = weights_13;
    }
    var over_4 : f32 = 1.0f / weights_12;
    var color_16 : vec3<f32> = color_14 * vec3<f32>(over_4);
    var variance_19 : f32 = variance_16 * (over_4 * over_4);
    set_color_0(u32(1), index_15, vec4<f32>(color_16, sqrt(variance_19)));
    var detail_4 : f32 = luminance_0(_S71 - color_16);
    set_numbers_0(u32(5), index_15, vec2<f32>(detail_4 * detail_4, max(own_variance_4 * (1.0f - 2.0f * own_weight_4 * over_4) + variance_19, 0.0f)));
    return;
}

var<private> SPLINE_0 : array<f32, i32(3)> = array<f32, i32(3)>( 0.375f, 0.25f, 0.0625f );
@id(0) override IS_EXACT_0 : bool = true;

fn place_of_check_0( cell_0 : u32) -> u32
{
    return u32(16) + cell_0;
}

fn cell_row_0( row_8 : u32,  cell_1 : u32) -> vec4<u32>
{
    return cell_rows_0[row_8 * u32(262144) + cell_1];
}

fn set_cell_row_0( row_9 : u32,  cell_2 : u32,  value_2 : vec4<u32>)
{
    cell_rows_0[row_9 * u32(262144) + cell_2] = value_2;
    return;
}

fn share_of_0( count_5 : u32,  room_0 : u32) -> u32
{
    var _S83 : u32;
    if(count_5 <= room_0)
    {
        _S83 = u32(4294967295);
    }
    else
    {
        var _S84 : u32 = u32(4294967295) / count_5;
        _S83 = _S84 * room_0;
    }
    return _S83;
}

struct Key_0
{
     instance_0 : u32,
     face_and_level_0 : u32,
     cube_0 : vec3<i32>,
};

fn Key_x24init_0( instance_1 : u32,  face_and_level_1 : u32,  cube_1 : vec3<i32>) -> Key_0
{
    var _S85 : Key_0;
    _S85.instance_0 = instance_1;
    _S85.face_and_level_0 = face_and_level_1;
    _S85.cube_0 = cube_1;
    return _S85;
}

fn pcg4d_0( words_1 : vec4<u32>) -> vec4<u32>
{
    var _S86 : vec4<u32> = words_1 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S86;
    v_0[i32(0)] = v_0[i32(0)] + _S86.y * _S86.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S87 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S87;
    v_0[i32(0)] = v_0[i32(0)] + _S87.y * _S87.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn Key_hash_0( this_1 : Key_0) -> vec2<u32>
{
    return pcg4d_0(vec4<u32>(vec3<u32>(this_1.cube_0), this_1.instance_0 * u32(61) + this_1.face_and_level_0)).xy;
}

fn place_of_chosen_0( number_1 : u32) -> u32
{
    return u32(524304) + number_1;
}

fn choose_cell_0( cell_3 : u32)
{
    var _S88 : u32 = atomicLoad(&(cell_keys_0[place_of_check_0(cell_3)]));
    if(_S88 == u32(0))
    {
        return;
    }
    var _S89 : vec4<u32> = cell_row_0(u32(0), cell_3);
    var light_5 : vec4<u32> = _S89;
    if((bitcast<f32>((_S89.w))) > (real_time_0.cell_samples_0))
    {
        light_5[i32(3)] = (bitcast<u32>((real_time_0.cell_samples_0)));
        set_cell_row_0(u32(0), cell_3, light_5);
    }
    var face_0 : vec4<u32> = cell_row_0(u32(1), cell_3);
    if((((face_0.z) & (u32(1048575)))) == u32(0))
    {
        return;
    }
    var new_cells_0 : u32 = atomicLoad(&(cell_keys_0[u32(0)]));
    var old_cells_0 : u32 = atomicLoad(&(cell_keys_0[u32(1)]));
    var old_cells_1 : u32;
    var new_cells_1 : u32;
    if((real_time_0.cell_samples_0) == 0.0f)
    {
        var new_cells_2 : u32 = new_cells_0 + old_cells_0;
        old_cells_1 = u32(0);
        new_cells_1 = new_cells_2;
    }
    else
    {
        old_cells_1 = old_cells_0;
        new_cells_1 = new_cells_0;
    }
    var share_1 : u32;
    if((bitcast<f32>((light_5.w))) == 0.0f)
    {
        var _S90 : u32 = share_of_0(new_cells_1, u32(65536));
        share_1 = _S90;
    }
    else
    {
        var _S91 : u32 = share_of_0(old_cells_1, u32(65536) - min(new_cells_1, u32(65536)));
        share_1 = _S91;
    }
    if((pcg4d_0(vec4<u32>(Key_hash_0(Key_x24init_0(face_0.x, face_0.y, vec3<i32>(cell_row_0(u32(2), cell_3).xyz))).x, real_time_0.number_0, u32(1), ((params_0.seed_0) ^ (u32(1540483477))))).x) > share_1)
    {
        return;
    }
    var number_2 : u32 = atomicAdd(&(cell_keys_0[u32(2)]), u32(1));
    atomicStore(&(cell_keys_0[place_of_chosen_0(number_2)]), cell_3);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn choose_cells(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    choose_cell_0(id_0.x);
    return;
}

fn place_of_asked_0( cell_4 : u32) -> u32
{
    return u32(262160) + cell_4;
}

fn is_normal_0( exponent_0 : u32) -> bool
{
    return (exponent_0 - u32(1)) < u32(254);
}

fn nearest_quotient_0( dividend_0 : u32,  divisor_0 : u32,  guess_0 : u32) -> u32
{
    var rest_0 : i32 = i32(((dividend_0 << (u32(23)))) - guess_0 * divisor_0);
    var units_0 : i32 = i32(floor(f32(rest_0) * (1.0f / f32(divisor_0)) + 0.5f));
    var _S92 : i32 = i32(divisor_0);
    var _S93 : i32 = i32(2) * (rest_0 - units_0 * _S92);
    return guess_0 + u32(units_0 + (i32(_S93 > _S92) - i32(_S93 < (- _S92))));
}

fn divide_0( a_1 : f32,  b_1 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_1 / b_1;
    }
    var _S94 : u32 = (bitcast<u32>((a_1)));
    var exponent_a_0 : u32 = (((_S94 >> (u32(23)))) & (u32(255)));
    var _S95 : u32 = (bitcast<u32>((b_1)));
    var exponent_b_0 : u32 = (((_S95 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S94 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S95 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_1 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S96 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S96 = true;
    }
    else
    {
        _S96 = !is_normal_0(exponent_b_0);
    }
    if(_S96)
    {
        _S96 = true;
    }
    else
    {
        _S96 = !is_normal_0(exponent_1);
    }
    if(_S96)
    {
        return a_1 / b_1;
    }
    return (bitcast<f32>(((((((_S94 ^ (_S95))) & (u32(2147483648)))) | ((((exponent_1 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn end_cell_0( cell_5 : u32)
{
    var _S97 : u32 = place_of_check_0(cell_5);
    var _S98 : u32 = atomicLoad(&(cell_keys_0[_S97]));
    if(_S98 == u32(0))
    {
        return;
    }
    var _S99 : u32 = place_of_asked_0(cell_5);
    var asked_0 : u32 = atomicLoad(&(cell_keys_0[_S99]));
    var face_1 : vec4<u32> = cell_row_0(u32(1), cell_5);
    var found_0 : vec4<u32> = cell_row_0(u32(3), cell_5);
    var light_6 : vec4<u32> = cell_row_0(u32(0), cell_5);
    var light_7 : vec4<u32>;
    if((found_0.w) != u32(0))
    {
        var _S100 : f32 = min((bitcast<f32>((light_6.w))) + 1.0f, 128.0f);
        var known_0 : vec3<f32> = (bitcast<vec3<f32>>((light_6.xyz)));
        var step_1 : vec3<f32> = (bitcast<vec3<f32>>((found_0.xyz))) - known_0;
        var _S101 : vec4<u32> = vec4<u32>((bitcast<vec3<u32>>((known_0 + vec3<f32>(divide_0(step_1.x, _S100), divide_0(step_1.y, _S100), divide_0(step_1.z, _S100))))), (bitcast<u32>((_S100))));
        set_cell_row_0(u32(3), cell_5, vec4<u32>(vec4<i32>(i32(0))));
        light_7 = _S101;
    }
    else
    {
        light_7 = light_6;
    }
    var before_0 : u32 = ((face_1.z) >> (u32(20)));
    var _S102 : u32;
    if(before_0 == u32(0))
    {
        _S102 = u32(0);
    }
    else
    {
        _S102 = before_0 - u32(1);
    }
    var _S103 : u32 = max(_S102, (asked_0 >> (u32(20))));
    var code_0 : u32 = (asked_0 & (u32(1048575)));
    face_1[i32(2)] = (((_S103 << (u32(20)))) | (code_0));
    if(_S103 == u32(0))
    {
        atomicStore(&(cell_keys_0[_S97]), u32(0));
        light_7 = vec4<u32>(vec4<i32>(i32(0)));
    }
    else
    {
        if(code_0 != u32(0))
        {
            if((bitcast<f32>((light_7.w))) == 0.0f)
            {
                _S102 = u32(0);
            }
            else
            {
                _S102 = u32(1);
            }
            var _S104 : u32 = atomicAdd(&(cell_keys_0[_S102]), u32(1));
        }
    }
    atomicStore(&(cell_keys_0[_S99]), u32(0));
    set_cell_row_0(u32(0), cell_5, light_7);
    set_cell_row_0(u32(1), cell_5, face_1);
    return;
}

fn place_of_known_0( place_1 : u32) -> u32
{
    return u32(786448) + place_1;
}

fn place_of_found_0( place_2 : u32) -> u32
{
    return place_of_known_0(place_2) + u32(131072);
}

fn update_visibility_0( place_3 : u32)
{
    var _S105 : u32 = place_of_known_0(place_3);
    var known_1 : u32 = atomicLoad(&(cell_keys_0[_S105]));
    var _S106 : u32 = place_of_found_0(place_3);
    var found_1 : u32 = atomicLoad(&(cell_keys_0[_S106]));
    if(found_1 == u32(0))
    {
        return;
    }
    var _S107 : u32 = ((known_1 >> (u32(16)))) + ((found_1 >> (u32(16))));
    var rays_0 : u32 = ((known_1 & (u32(65535)))) + ((found_1 & (u32(65535))));
    var arrived_0 : u32 = _S107;
    for(;;)
    {
        if(rays_0 > u32(255))
        {
        }
        else
        {
            break;
        }
        var arrived_1 : u32 = (arrived_0 >> (u32(1)));
        rays_0 = (rays_0 >> (u32(1)));
        arrived_0 = arrived_1;
    }
    atomicStore(&(cell_keys_0[_S105]), (((arrived_0 << (u32(16)))) | (rays_0)));
    atomicStore(&(cell_keys_0[_S106]), u32(0));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn end_cells(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S108 : u32 = id_1.x;
    end_cell_0(_S108);
    if(_S108 < u32(131072))
    {
        update_visibility_0(_S108);
    }
    return;
}

fn squares_1() -> vec2<u32>
{
    var _S109 : vec2<u32> = vec2<u32>(u32(5));
    var _S110 : vec2<u32> = (vec2<u32>(params_0.width_0, params_0.height_0) + _S109 - vec2<u32>(u32(1))) / _S109;
    return _S110;
}

fn place_of_square_0( list_0 : u32,  square_5 : u32) -> u32
{
    var count_6 : vec2<u32> = squares_1();
    return u32(4) * real_time_0.pixels_0 + list_0 * count_6.x * count_6.y + square_5;
}

fn changes_around_0( at_12 : vec2<i32>,  reach_1 : i32) -> vec4<f32>
{
    var _S111 : vec2<i32> = vec2<i32>(squares_1());
    var _S112 : vec4<f32> = vec4<f32>(0.0f);
    var _S113 : i32 = at_12.y;
    var y_0 : i32 = max(_S113 - reach_1, i32(0));
    var sum_4 : vec4<f32> = _S112;
    for(;;)
    {
        if(y_0 <= (min(_S113 + reach_1, _S111.y - i32(1))))
        {
        }
        else
        {
            break;
        }
        var _S114 : i32 = at_12.x;
        var x_0 : i32 = max(_S114 - reach_1, i32(0));
        var sum_5 : vec4<f32> = sum_4;
        for(;;)
        {
            var _S115 : i32 = _S111.x;
            if(x_0 <= (min(_S114 + reach_1, _S115 - i32(1))))
            {
            }
            else
            {
                break;
            }
            var square_6 : u32 = u32(y_0 * _S115 + x_0);
            var before_1 : vec4<f32> = (bitcast<vec4<f32>>((memory_rows_0[place_of_square_0(((real_time_0.number_0 - u32(1)) & (u32(1))), square_6)])));
            var now_0 : vec4<f32> = (bitcast<vec4<f32>>((memory_rows_0[place_of_square_0(u32(2), square_6)])));
            var _S116 : vec3<f32> = now_0.xyz;
            if((sqrt(length_squared_0(_S116 - before_1.xyz))) <= (2.0f * (1.0f + real_time_0.view_angle_0 / f32(params_0.height_0) * sqrt(length_squared_0(_S116 - real_time_0.before_place_0)))))
            {
                var _S117 : f32 = before_1.w;
                var _S118 : f32 = now_0.w;
                sum_5 = sum_5 + vec4<f32>(_S117, _S118, abs(_S118 - _S117), max(_S118, _S117));
            }
            x_0 = x_0 + i32(1);
        }
        y_0 = y_0 + i32(1);
        sum_4 = sum_5;
    }
    return sum_4;
}

@compute
@workgroup_size(64, 1, 1)
fn compare_found(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    var count_7 : vec2<u32> = squares_1();
    var _S119 : u32 = id_2.x;
    var _S120 : u32 = count_7.x;
    if(_S119 >= (_S120 * count_7.y))
    {
        return;
    }
    var _S121 : u32 = _S119 % _S120;
    var _S122 : i32 = i32(_S121);
    var _S123 : u32 = _S119 / _S120;
    var at_13 : vec2<i32> = vec2<i32>(_S122, i32(_S123));
    var changes_0 : vec4<f32> = changes_around_0(at_13, i32(1));
    var changes_1 : vec4<f32>;
    if((changes_0.w) <= 0.0f)
    {
        changes_1 = changes_around_0(at_13, i32(4));
    }
    else
    {
        changes_1 = changes_0;
    }
    var _S124 : f32 = changes_1.w;
    var share_2 : f32;
    if(_S124 > 0.0f)
    {
        share_2 = min(changes_1.z / _S124, 1.0f);
    }
    else
    {
        share_2 = 0.0f;
    }
    var _S125 : f32 = changes_1.x;
    memory_rows_0[place_of_square_0(u32(3), _S119)] = vec4<u32>((bitcast<u32>((share_2))), (bitcast<u32>((1.0f - clamp((share_2 - 0.5f) / 0.25f, 0.0f, 1.0f) * (max(_S125 - changes_1.y, 0.0f) / max(_S125, 1.00000000317107685e-30f))))), u32(0), u32(0));
    return;
}

fn pixel_of_thread_0( thread_0 : u32) -> vec2<u32>
{
    var tiles_0 : u32 = (params_0.width_0 + u32(7)) / u32(8);
    var tile_0 : u32 = thread_0 / u32(64);
    var in_tile_0 : u32 = (thread_0 & (u32(63)));
    var row_10 : u32 = tile_0 / tiles_0;
    return vec2<u32>((tile_0 - row_10 * tiles_0) * u32(8) + ((in_tile_0 & (u32(7)))), row_10 * u32(8) + ((in_tile_0 >> (u32(3)))));
}

@compute
@workgroup_size(64, 1, 1)
fn doubt(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    var at_14 : vec2<u32> = pixel_of_thread_0(id_3.x);
    if(is_inside_0(vec2<i32>(at_14)))
    {
        var index_16 : u32 = index_of_0(at_14);
        var square_7 : vec2<u32> = at_14 / vec2<u32>(u32(5));
        var change_0 : vec2<f32> = (bitcast<vec2<f32>>((memory_rows_0[place_of_square_0(u32(3), square_7.y * squares_1().x + square_7.x)].xy)));
        var _S126 : vec4<u32> = memory_row_0(u32(1), index_16);
        var row_11 : vec4<u32> = _S126;
        var _S127 : u32 = _S126.x;
        var paths_5 : f32 = low_half_0(_S127);
        var next_0 : f32 = 1.0f / (paths_5 + 1.0f);
        row_11[i32(0)] = halves_0(min(paths_5, 1.0f / (next_0 + (1.0f - next_0) * change_0.x) - 1.0f), high_half_0(_S127));
        memory_rows_0[real_time_0.pixels_0 + index_16] = row_11;
        var _S128 : vec4<u32> = memory_row_0(u32(2), index_16);
        var lit_0 : vec4<u32> = _S128;
        var _S129 : vec3<u32> = (bitcast<vec3<u32>>(((bitcast<vec3<f32>>((_S128.xyz))) * vec3<f32>(change_0.y))));
        lit_0.x = _S129.x;
        lit_0.y = _S129.y;
        lit_0.z = _S129.z;
        memory_rows_0[u32(2) * real_time_0.pixels_0 + index_16] = lit_0;
    }
    return;
}

struct Sample_0
{
     direct_0 : vec3<f32>,
     light_8 : vec3<f32>,
     is_shown_0 : bool,
     albedo_0 : vec3<f32>,
     normal_1 : vec3<f32>,
     place_4 : vec3<f32>,
     instance_2 : u32,
};

fn Sample_x24init_0( direct_1 : vec3<f32>,  light_9 : vec3<f32>,  is_shown_1 : bool,  albedo_1 : vec3<f32>,  normal_2 : vec3<f32>,  place_5 : vec3<f32>,  instance_3 : u32) -> Sample_0
{
    var _S130 : Sample_0;
    _S130.direct_0 = direct_1;
    _S130.light_8 = light_9;
    _S130.is_shown_0 = is_shown_1;
    _S130.albedo_0 = albedo_1;
    _S130.normal_1 = normal_2;
    _S130.place_4 = place_5;
    _S130.instance_2 = instance_3;
    return _S130;
}

fn no_sample_0() -> Sample_0
{
    var _S131 : vec3<f32> = vec3<f32>(0.0f);
    return Sample_x24init_0(_S131, _S131, false, _S131, _S131, _S131, u32(4294967294));
}

fn has_0( flag_0 : u32) -> bool
{
    return (((real_time_0.flags_0) & (flag_0))) != u32(0);
}

fn traces_0( at_15 : vec2<i32>) -> bool
{
    var _S132 : bool;
    if(!has_0(u32(128)))
    {
        _S132 = true;
    }
    else
    {
        _S132 = (((u32(at_15.x + at_15.y) + real_time_0.number_0) & (u32(1)))) == u32(0);
    }
    return _S132;
}

fn load_sample_0( index_17 : u32) -> Sample_0
{
    var b_2 : vec2<u32> = scratch_row_0(u32(1), index_17);
    var d_0 : vec2<f32> = (bitcast<vec2<f32>>((scratch_row_0(u32(3), index_17))));
    var g_0 : vec2<u32> = scratch_row_0(u32(6), index_17);
    var sample_0 : Sample_0;
    sample_0.light_8 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(0), index_17)))), (bitcast<f32>((b_2.x))));
    sample_0.instance_2 = b_2.y;
    sample_0.direct_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(2), index_17)))), d_0.x);
    sample_0.place_4 = vec3<f32>(d_0.y, (bitcast<vec2<f32>>((scratch_row_0(u32(4), index_17)))));
    sample_0.albedo_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(5), index_17)))), (bitcast<f32>((g_0.x))));
    var _S133 : u32 = g_0.y;
    sample_0.normal_1 = normal_in_0(_S133);
    sample_0.is_shown_0 = ((_S133 & (u32(1073741824)))) != u32(0);
    return sample_0;
}

fn neighbour_0( which_0 : u32) -> vec2<i32>
{
    var side_0 : i32;
    if(((which_0 & (u32(2)))) != u32(0))
    {
        side_0 = i32(1);
    }
    else
    {
        side_0 = i32(-1);
    }
    var _S134 : vec2<i32>;
    if(((which_0 & (u32(1)))) != u32(0))
    {
        _S134 = vec2<i32>(i32(0), side_0);
    }
    else
    {
        _S134 = vec2<i32>(side_0, i32(0));
    }
    return _S134;
}

fn sample_at_0( at_16 : vec2<i32>) -> Sample_0
{
    var _S135 : Sample_0 = no_sample_0();
    if(traces_0(at_16))
    {
        return load_sample_0(index_of_0(vec2<u32>(at_16)));
    }
    var sample_1 : Sample_0 = _S135;
    var turn_0 : u32 = u32(0);
    for(;;)
    {
        var _S136 : bool;
        if(turn_0 < u32(4))
        {
            _S136 = !sample_1.is_shown_0;
        }
        else
        {
            _S136 = false;
        }
        if(_S136)
        {
        }
        else
        {
            break;
        }
        var beside_5 : vec2<i32> = at_16 + neighbour_0(turn_0 + real_time_0.number_0 / u32(2));
        if(is_inside_0(beside_5))
        {
            sample_1 = load_sample_0(index_of_0(vec2<u32>(beside_5)));
        }
        turn_0 = turn_0 + u32(1);
    }
    return sample_1;
}

struct Lit_0
{
     paths_6 : f32,
     light_10 : vec3<f32>,
     shaded_1 : vec3<f32>,
     moments_0 : vec3<f32>,
};

fn Lit_x24init_0( paths_7 : f32,  light_11 : vec3<f32>,  shaded_2 : vec3<f32>,  moments_1 : vec3<f32>) -> Lit_0
{
    var _S137 : Lit_0;
    _S137.paths_6 = paths_7;
    _S137.light_10 = light_11;
    _S137.shaded_1 = shaded_2;
    _S137.moments_0 = moments_1;
    return _S137;
}

fn not_lit_0() -> Lit_0
{
    var _S138 : vec3<f32> = vec3<f32>(0.0f);
    return Lit_x24init_0(0.0f, _S138, _S138, _S138);
}

fn is_mover_0( instance_4 : u32) -> bool
{
    var _S139 : bool;
    if(instance_4 < (real_time_0.motions_0))
    {
        _S139 = (motions_1[u32(4) * instance_4 + u32(3)].x) != 0.0f;
    }
    else
    {
        _S139 = false;
    }
    return _S139;
}

fn shows_mover_0( sample_2 : Sample_0) -> bool
{
    var _S140 : bool;
    if((real_time_0.motions_0) != u32(0))
    {
        if((sample_2.instance_2) == u32(4294967295))
        {
            _S140 = true;
        }
        else
        {
            _S140 = is_mover_0(sample_2.instance_2);
        }
    }
    else
    {
        _S140 = false;
    }
    return _S140;
}

struct Wanted_0
{
     is_shown_2 : bool,
     place_6 : vec3<f32>,
     normal_3 : vec3<f32>,
     tolerance_0 : f32,
};

fn Wanted_x24init_0( is_shown_3 : bool,  place_7 : vec3<f32>,  normal_4 : vec3<f32>,  tolerance_1 : f32) -> Wanted_0
{
    var _S141 : Wanted_0;
    _S141.is_shown_2 = is_shown_3;
    _S141.place_6 = place_7;
    _S141.normal_3 = normal_4;
    _S141.tolerance_0 = tolerance_1;
    return _S141;
}

struct CameraFrame_0
{
     lens_1 : u32,
     eye_2 : vec3<f32>,
     corner_1 : vec3<f32>,
     pixel_x_1 : vec3<f32>,
     pixel_y_1 : vec3<f32>,
     lens_x_1 : vec3<f32>,
     lens_y_1 : vec3<f32>,
     blades_1 : u32,
};

fn CameraFrame_x24init_0( lens_2 : u32,  eye_3 : vec3<f32>,  corner_2 : vec3<f32>,  pixel_x_2 : vec3<f32>,  pixel_y_2 : vec3<f32>,  lens_x_2 : vec3<f32>,  lens_y_2 : vec3<f32>,  blades_2 : u32) -> CameraFrame_0
{
    var _S142 : CameraFrame_0;
    _S142.lens_1 = lens_2;
    _S142.eye_2 = eye_3;
    _S142.corner_1 = corner_2;
    _S142.pixel_x_1 = pixel_x_2;
    _S142.pixel_y_1 = pixel_y_2;
    _S142.lens_x_1 = lens_x_2;
    _S142.lens_y_1 = lens_y_2;
    _S142.blades_1 = blades_2;
    return _S142;
}

@id(5) override LENS_0 : u32 = u32(0);

struct Perspective_0
{
     eye_4 : vec3<f32>,
     corner_3 : vec3<f32>,
     pixel_x_3 : vec3<f32>,
     pixel_y_3 : vec3<f32>,
};

fn Perspective_x24init_0( eye_5 : vec3<f32>,  corner_4 : vec3<f32>,  pixel_x_4 : vec3<f32>,  pixel_y_4 : vec3<f32>) -> Perspective_0
{
    var _S143 : Perspective_0;
    _S143.eye_4 = eye_5;
    _S143.corner_3 = corner_4;
    _S143.pixel_x_3 = pixel_x_4;
    _S143.pixel_y_3 = pixel_y_4;
    return _S143;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_0 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_1 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S144 : Axes_0;
    _S144.forward_0 = forward_1;
    _S144.right_0 = right_1;
    _S144.up_0 = up_1;
    return _S144;
}

struct ThinLens_0
{
     perspective_0 : Perspective_0,
     lens_x_3 : vec3<f32>,
     lens_y_3 : vec3<f32>,
     blades_3 : u32,
};

fn ThinLens_x24init_0( perspective_1 : Perspective_0,  lens_x_4 : vec3<f32>,  lens_y_4 : vec3<f32>,  blades_4 : u32) -> ThinLens_0
{
    var _S145 : ThinLens_0;
    _S145.perspective_0 = perspective_1;
    _S145.lens_x_3 = lens_x_4;
    _S145.lens_y_3 = lens_y_4;
    _S145.blades_3 = blades_4;
    return _S145;
}

fn concentric_0( square_8 : vec2<f32>) -> vec2<f32>
{
    var a_2 : f32 = 2.0f * square_8.x - 1.0f;
    var b_3 : f32 = 2.0f * square_8.y - 1.0f;
    var _S146 : bool;
    if(a_2 == 0.0f)
    {
        _S146 = b_3 == 0.0f;
    }
    else
    {
        _S146 = false;
    }
    if(_S146)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_2)) > (abs(b_3));
    var radius_0 : f32;
    if(is_across_0)
    {
        radius_0 = a_2;
    }
    else
    {
        radius_0 = b_3;
    }
    var turns_0 : f32;
    if(is_across_0)
    {
        turns_0 = divide_0(b_3, a_2) * 0.125f;
    }
    else
    {
        turns_0 = 0.25f - divide_0(a_2, b_3) * 0.125f;
    }
    if(radius_0 < 0.0f)
    {
        turns_0 = turns_0 + 0.5f;
    }
    var _S147 : f32 = abs(radius_0);
    if(turns_0 < 0.0f)
    {
        radius_0 = turns_0 + 1.0f;
    }
    else
    {
        radius_0 = turns_0;
    }
    return vec2<f32>(_S147, radius_0);
}

fn sincos_turns_0( turns_1 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_1 * 4.0f + 0.5f);
    var x_1 : f32 = (turns_1 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_1 * x_1;
    var sin_0 : f32 = x_1 + x_1 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
    var cos_0 : f32 = 1.0f + xx_0 * (-0.5f + xx_0 * (0.0416666679084301f + xx_0 * (-0.00138888892251998f + xx_0 * (0.00002480158764229f + xx_0 * -2.75573199814971304e-07f))));
    switch((quadrant_0 & (i32(3))))
    {
    case i32(0):
        {
            return vec2<f32>(sin_0, cos_0);
        }
    case i32(1):
        {
            return vec2<f32>(cos_0, - sin_0);
        }
    case i32(2):
        {
            return vec2<f32>(- sin_0, - cos_0);
        }
    default :
        {
            return vec2<f32>(- cos_0, sin_0);
        }
    }
}

fn place_in_aperture_0( blades_5 : u32,  lens_3 : vec2<f32>) -> vec2<f32>
{
    var radius_turns_0 : vec2<f32> = concentric_0(lens_3);
    var radius_1 : f32 = radius_turns_0.x;
    if(blades_5 == u32(0))
    {
        var sin_cos_0 : vec2<f32> = sincos_turns_0(radius_turns_0.y);
        return vec2<f32>(radius_1 * sin_cos_0.y, radius_1 * sin_cos_0.x);
    }
    var count_8 : f32 = f32(blades_5);
    var scaled_0 : f32 = radius_turns_0.y * count_8;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_5 - u32(1)));
    var share_3 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_8));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_8));
    var _S148 : f32 = from_0.y;
    var _S149 : f32 = from_0.x;
    return vec2<f32>(_S148 + (to_0.y - _S148) * share_3, _S149 + (to_0.x - _S149) * share_3) * vec2<f32>(radius_1);
}

fn nearest_root_0( mantissa_0 : u32,  guess_1 : u32) -> u32
{
    var rest_1 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_1) / f32(u32(2) * guess_1) + 0.5f));
    var _S150 : i32 = i32(guess_1);
    var root_0 : i32 = _S150 + units_1;
    var rest_2 : i32 = rest_1 - units_1 * (_S150 + root_0);
    return u32(root_0 + i32(rest_2 > root_0) - i32(rest_2 <= (- root_0)));
}

fn square_root_0( value_3 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_3);
    }
    var _S151 : u32 = (bitcast<u32>((value_3)));
    var exponent_2 : u32 = (_S151 >> (u32(23)));
    if(!is_normal_0(exponent_2))
    {
        return sqrt(value_3);
    }
    var mantissa_1 : u32 = (((((_S151 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_2) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_1, u32(sqrt(f32(mantissa_1) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn normalize_vector_0( vector_1 : vec3<f32>) -> vec3<f32>
{
    return vector_1 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_1))));
}

struct Ray_0
{
     origin_0 : vec3<f32>,
     t_min_0 : f32,
     direction_0 : vec3<f32>,
     t_max_0 : f32,
};

fn Ray_x24init_0( origin_1 : vec3<f32>,  t_min_1 : f32,  direction_1 : vec3<f32>,  t_max_1 : f32) -> Ray_0
{
    var _S152 : Ray_0;
    _S152.origin_0 = origin_1;
    _S152.t_min_0 = t_min_1;
    _S152.direction_0 = direction_1;
    _S152.t_max_0 = t_max_1;
    return _S152;
}

fn ray_from_0( origin_2 : vec3<f32>,  direction_2 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_2, 0.0f, direction_2, (bitcast<f32>(infinity_bits_0)));
}

fn ThinLens_ray_0( this_2 : ThinLens_0,  position_0 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var place_8 : vec2<f32> = place_in_aperture_0(this_2.blades_3, lens_4);
    var offset_0 : vec3<f32> = this_2.lens_x_3 * vec3<f32>(place_8.x) + this_2.lens_y_3 * vec3<f32>(place_8.y);
    return ray_from_0(this_2.perspective_0.eye_4 + offset_0, normalize_vector_0(this_2.perspective_0.corner_3 + this_2.perspective_0.pixel_x_3 * vec3<f32>(position_0.x) + this_2.perspective_0.pixel_y_3 * vec3<f32>(position_0.y) - offset_0));
}

struct Orthographic_0
{
     corner_5 : vec3<f32>,
     pixel_x_5 : vec3<f32>,
     pixel_y_5 : vec3<f32>,
     forward_2 : vec3<f32>,
};

fn Orthographic_x24init_0( corner_6 : vec3<f32>,  pixel_x_6 : vec3<f32>,  pixel_y_6 : vec3<f32>,  forward_3 : vec3<f32>) -> Orthographic_0
{
    var _S153 : Orthographic_0;
    _S153.corner_5 = corner_6;
    _S153.pixel_x_5 = pixel_x_6;
    _S153.pixel_y_5 = pixel_y_6;
    _S153.forward_2 = forward_3;
    return _S153;
}

fn Orthographic_ray_0( this_3 : Orthographic_0,  position_1 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_3.corner_5 + this_3.pixel_x_5 * vec3<f32>(position_1.x) + this_3.pixel_y_5 * vec3<f32>(position_1.y), this_3.forward_2);
}

struct Panorama_0
{
     eye_6 : vec3<f32>,
     axes_0 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_7 : vec3<f32>,  axes_1 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S154 : Panorama_0;
    _S154.eye_6 = eye_7;
    _S154.axes_0 = axes_1;
    _S154.inverse_size_0 = inverse_size_1;
    _S154.half_eye_distance_0 = half_eye_distance_1;
    return _S154;
}

fn Panorama_ray_0( this_4 : Panorama_0,  position_2 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_2.y * this_4.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_1 : f32;
    if(is_right_eye_0)
    {
        side_1 = this_4.half_eye_distance_0;
    }
    else
    {
        side_1 = - this_4.half_eye_distance_0;
    }
    var latitude_1 : f32;
    if(is_right_eye_0)
    {
        latitude_1 = latitude_0 - 1.0f;
    }
    else
    {
        latitude_1 = latitude_0;
    }
    var longitude_0 : vec2<f32> = sincos_turns_0(position_2.x * this_4.inverse_size_0.x);
    var height_1 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S155 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S156 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_4.eye_6 + (this_4.axes_0.forward_0 * _S156 - this_4.axes_0.right_0 * _S155) * vec3<f32>(side_1), normalize_vector_0((vec3<f32>(0) - this_4.axes_0.forward_0 * _S155 + this_4.axes_0.right_0 * _S156) * vec3<f32>(height_1.x) + this_4.axes_0.up_0 * vec3<f32>(height_1.y)));
}

struct Fisheye_0
{
     eye_8 : vec3<f32>,
     axes_2 : Axes_0,
     middle_5 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_9 : vec3<f32>,  axes_3 : Axes_0,  middle_6 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S157 : Fisheye_0;
    _S157.eye_8 = eye_9;
    _S157.axes_2 = axes_3;
    _S157.middle_5 = middle_6;
    _S157.turns_per_pixel_0 = turns_per_pixel_1;
    return _S157;
}

fn Fisheye_ray_0( this_5 : Fisheye_0,  position_3 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    var x_2 : f32 = position_3.x - this_5.middle_5.x;
    var y_1 : f32 = position_3.y - this_5.middle_5.y;
    var radius_2 : f32 = square_root_0(x_2 * x_2 + y_1 * y_1);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(min(radius_2 * this_5.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_2 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_1.x, radius_2);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_5.eye_8, normalize_vector_0(this_5.axes_2.forward_0 * vec3<f32>(sin_cos_1.y) + this_5.axes_2.right_0 * vec3<f32>((x_2 * scale_0)) - this_5.axes_2.up_0 * vec3<f32>((y_1 * scale_0))));
}

fn Perspective_ray_0( this_6 : Perspective_0,  position_4 : vec2<f32>,  lens_8 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_6.eye_4, normalize_vector_0(this_6.corner_3 + this_6.pixel_x_3 * vec3<f32>(position_4.x) + this_6.pixel_y_3 * vec3<f32>(position_4.y)));
}

fn CameraFrame_ray_0( this_7 : CameraFrame_0,  position_5 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_7.eye_2, this_7.corner_1, this_7.pixel_x_1, this_7.pixel_y_1);
    var axes_4 : Axes_0 = Axes_x24init_0(this_7.corner_1, this_7.pixel_x_1, this_7.pixel_y_1);
    switch(this_7.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_7.lens_x_1, this_7.lens_y_1, this_7.blades_1), position_5, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_7.corner_1, this_7.pixel_x_1, this_7.pixel_y_1, this_7.lens_x_1), position_5, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_7.eye_2, axes_4, this_7.lens_x_1.xy, this_7.lens_x_1.z), position_5, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_7.eye_2, axes_4, this_7.lens_x_1.xy, this_7.lens_x_1.z), position_5, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_5, lens_sample_0);
        }
    }
}

fn cubic_weights_0( t_0 : f32) -> vec4<f32>
{
    var tt_0 : f32 = t_0 * t_0;
    var ttt_0 : f32 = tt_0 * t_0;
    var _S158 : f32 = 3.0f * ttt_0;
    return vec4<f32>(0.5f) * vec4<f32>(2.0f * tt_0 - ttt_0 - t_0, _S158 - 5.0f * tt_0 + 2.0f, 4.0f * tt_0 - _S158 + t_0, ttt_0 - tt_0);
}

fn shown_in_0( word_3 : u32) -> vec3<f32>
{
    return vec3<f32>((vec3<u32>(word_3, (word_3 >> (u32(9))), (word_3 >> (u32(18)))) & (vec3<u32>(u32(511))))) * vec3<f32>((bitcast<f32>((((u32(103) + ((word_3 >> (u32(27))))) << (u32(23)))))));
}

fn word_of_0( color_17 : vec3<f32>) -> u32
{
    var _S159 : vec3<f32> = clamp(color_17, vec3<f32>(0.0f), vec3<f32>(65408.0f));
    var _S160 : i32 = max(i32(((bitcast<u32>((max(max(_S159.x, _S159.y), _S159.z)))) >> (u32(23)))) - i32(126), i32(-15));
    var parts_0 : vec3<u32> = min(vec3<u32>(_S159 * vec3<f32>((bitcast<f32>(((u32(i32(136) - _S160) << (u32(23))))))) + vec3<f32>(0.5f)), vec3<u32>(vec3<i32>(i32(511))));
    return max(((((((parts_0.x) | ((((parts_0.y) << (u32(9))))))) | ((((parts_0.z) << (u32(18))))))) | (((u32(_S160 + i32(15)) << (u32(27)))))), u32(134217728));
}

fn shown_at_0( corner_7 : vec2<i32>,  across_0 : vec4<f32>,  down_0 : vec4<f32>) -> u32
{
    var _S161 : vec3<f32> = vec3<f32>(0.0f);
    var place_9 : i32 = i32(0);
    var sum_6 : vec3<f32> = _S161;
    for(;;)
    {
        if(place_9 < i32(16))
        {
        }
        else
        {
            break;
        }
        var _S162 : i32 = (place_9 & (i32(3)));
        var _S163 : i32 = (place_9 >> (u32(2)));
        var _S164 : vec2<i32> = vec2<i32>(i32(1));
        var word_4 : u32 = memory_row_0(u32(3), index_of_0(vec2<u32>(clamp(corner_7 + vec2<i32>(_S162, _S163) - _S164, vec2<i32>(i32(0)), vec2<i32>(i32(params_0.width_0), i32(params_0.height_0)) - _S164)))).w;
        if(word_4 == u32(0))
        {
            return u32(0);
        }
        var sum_7 : vec3<f32> = sum_6 + shown_in_0(word_4) * vec3<f32>((across_0[_S162] * down_0[_S163]));
        place_9 = place_9 + i32(1);
        sum_6 = sum_7;
    }
    return word_of_0(sum_6);
}

fn shows_0( wanted_0 : Wanted_0,  index_18 : u32) -> bool
{
    var surface_2 : vec4<u32> = memory_row_0(u32(0), index_18);
    var word_5 : u32 = memory_row_0(u32(1), index_18).y;
    if(!wanted_0.is_shown_2)
    {
        return (low_half_0(word_5)) < 0.44600000977516174f;
    }
    var _S165 : u32 = surface_2.w;
    var normal_5 : vec3<f32> = normal_in_0(_S165);
    var distance_1 : f32 = abs(dot_product_0(wanted_0.normal_3, (bitcast<vec3<f32>>((surface_2.xyz))) - wanted_0.place_6));
    var tolerance_2 : f32 = wanted_0.tolerance_0 + 2.0f * sqrt(high_half_0(word_5));
    var cosine_0 : f32 = dot_product_0(wanted_0.normal_3, normal_5);
    var _S166 : bool;
    if(((_S165 & (u32(1073741824)))) != u32(0))
    {
        _S166 = distance_1 <= tolerance_2;
    }
    else
    {
        _S166 = false;
    }
    if(_S166)
    {
        _S166 = cosine_0 >= (0.5f * sqrt(length_squared_0(normal_5)));
    }
    else
    {
        _S166 = false;
    }
    return _S166;
}

fn pixel_before_0( wanted_1 : Wanted_0,  at_17 : vec2<i32>) -> u32
{
    if(!is_inside_0(at_17))
    {
        return real_time_0.pixels_0;
    }
    var index_19 : u32 = index_of_0(vec2<u32>(at_17));
    var _S167 : u32;
    if(shows_0(wanted_1, index_19))
    {
        _S167 = index_19;
    }
    else
    {
        _S167 = real_time_0.pixels_0;
    }
    return _S167;
}

fn Lit_products_0( this_8 : Lit_0,  kept_5 : vec3<f32>) -> vec3<f32>
{
    var l_0 : f32 = luminance_0(this_8.light_10);
    var a_3 : f32 = luminance_0(kept_5);
    return vec3<f32>(l_0 * l_0, l_0 * a_3, a_3 * a_3);
}

fn lit_of_0( paths_8 : f32,  light_12 : vec3<f32>,  words_2 : vec3<u32>) -> Lit_0
{
    var _S168 : u32 = words_2.x;
    var _S169 : u32 = words_2.y;
    var _S170 : Lit_0 = Lit_x24init_0(paths_8, light_12, vec3<f32>(low_half_0(_S168), high_half_0(_S168), low_half_0(_S169)), vec3<f32>(0.0f));
    var lit_1 : Lit_0 = _S170;
    var _S171 : u32 = words_2.z;
    lit_1.moments_0 = Lit_products_0(_S170, lit_1.shaded_1) * (vec3<f32>(1.0f) + vec3<f32>(high_half_0(_S169), low_half_0(_S171), high_half_0(_S171)));
    return lit_1;
}

fn load_lit_0( index_20 : u32) -> Lit_0
{
    var shaded_3 : vec4<u32> = memory_row_0(u32(1), index_20);
    var light_13 : vec4<u32> = memory_row_0(u32(2), index_20);
    return lit_of_0(low_half_0(shaded_3.x), (bitcast<vec3<f32>>((light_13.xyz))), vec3<u32>(shaded_3.z, shaded_3.w, light_13.w));
}

fn add_weighed_0( sum_8 : ptr<function, Lit_0>,  lit_2 : Lit_0,  weight_5 : f32)
{
    (*sum_8).paths_6 = (*sum_8).paths_6 + lit_2.paths_6 * weight_5;
    var _S172 : vec3<f32> = vec3<f32>(weight_5);
    (*sum_8).light_10 = (*sum_8).light_10 + lit_2.light_10 * _S172;
    (*sum_8).shaded_1 = (*sum_8).shaded_1 + lit_2.shaded_1 * _S172;
    (*sum_8).moments_0 = (*sum_8).moments_0 + lit_2.moments_0 * _S172;
    return;
}

fn min_element_0( vector_2 : vec3<f32>) -> f32
{
    return min(min(vector_2.x, vector_2.y), vector_2.z);
}

fn cubic_0( wanted_2 : Wanted_0,  corner_8 : vec2<i32>,  across_1 : vec4<f32>,  down_1 : vec4<f32>,  lit_3 : ptr<function, Lit_0>) -> bool
{
    (*lit_3) = not_lit_0();
    var INFINITY_0 : f32 = (bitcast<f32>(infinity_bits_0));
    var is_whole_0 : bool = true;
    var least_1 : f32 = INFINITY_0;
    var place_10 : i32 = i32(0);
    for(;;)
    {
        var _S173 : bool;
        if(place_10 < i32(16))
        {
            _S173 = is_whole_0;
        }
        else
        {
            _S173 = false;
        }
        if(_S173)
        {
        }
        else
        {
            break;
        }
        var _S174 : i32 = (place_10 & (i32(3)));
        var _S175 : i32 = (place_10 >> (u32(2)));
        var step_2 : vec2<i32> = vec2<i32>(_S174, _S175);
        var _S176 : f32 = across_1[_S174] * down_1[_S175];
        if(_S176 == 0.0f)
        {
            place_10 = place_10 + i32(1);
            continue;
        }
        var index_21 : u32 = pixel_before_0(wanted_2, corner_8 + step_2 - vec2<i32>(i32(1)));
        var is_whole_1 : bool = index_21 != (real_time_0.pixels_0);
        var least_2 : f32;
        if(is_whole_1)
        {
            var other_8 : Lit_0 = load_lit_0(index_21);
            add_weighed_0(&((*lit_3)), other_8, _S176);
            least_2 = min(least_1, other_8.paths_6);
        }
        else
        {
            least_2 = least_1;
        }
        is_whole_0 = is_whole_1;
        least_1 = least_2;
        place_10 = place_10 + i32(1);
    }
    (*lit_3).paths_6 = max((*lit_3).paths_6, least_1);
    var _S177 : f32 = min(min(min_element_0((*lit_3).light_10), min_element_0((*lit_3).shaded_1)), min_element_0((*lit_3).moments_0));
    if(is_whole_0)
    {
        is_whole_0 = _S177 >= 0.0f;
    }
    else
    {
        is_whole_0 = false;
    }
    return is_whole_0;
}

fn linear_mean_0( wanted_3 : Wanted_0,  corner_9 : vec2<i32>,  share_4 : vec2<f32>,  lit_4 : ptr<function, Lit_0>) -> bool
{
    (*lit_4) = not_lit_0();
    var place_11 : u32 = u32(0);
    var weights_15 : f32 = 0.0f;
    for(;;)
    {
        if(place_11 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S178 : i32 = i32((place_11 & (u32(1))));
        var _S179 : i32 = i32((place_11 >> (u32(1))));
        var index_22 : u32 = pixel_before_0(wanted_3, corner_9 + vec2<i32>(_S178, _S179));
        if(index_22 != (real_time_0.pixels_0))
        {
            var _S180 : f32;
            if(_S178 == i32(0))
            {
                _S180 = 1.0f - share_4.x;
            }
            else
            {
                _S180 = share_4.x;
            }
            var _S181 : f32;
            if(_S179 == i32(0))
            {
                _S181 = 1.0f - share_4.y;
            }
            else
            {
                _S181 = share_4.y;
            }
            var weight_6 : f32 = _S180 * _S181;
            add_weighed_0(&((*lit_4)), load_lit_0(index_22), weight_6);
            weights_15 = weights_15 + weight_6;
        }
        place_11 = place_11 + u32(1);
    }
    var scale_1 : f32 = 1.0f / max(weights_15, 9.99999968265522539e-21f);
    (*lit_4).paths_6 = (*lit_4).paths_6 * scale_1;
    var _S182 : vec3<f32> = vec3<f32>(scale_1);
    (*lit_4).light_10 = (*lit_4).light_10 * _S182;
    (*lit_4).shaded_1 = (*lit_4).shaded_1 * _S182;
    (*lit_4).moments_0 = (*lit_4).moments_0 * _S182;
    return weights_15 >= 0.01999999955296516f;
}

fn nearest_0( wanted_4 : Wanted_0,  at_18 : vec2<f32>) -> Lit_0
{
    var least_3 : f32 = (bitcast<f32>(infinity_bits_0));
    var best_0 : u32 = real_time_0.pixels_0;
    var place_12 : i32 = i32(0);
    for(;;)
    {
        if(place_12 < i32(9))
        {
        }
        else
        {
            break;
        }
        var pixel_0 : vec2<i32> = vec2<i32>(floor(at_18)) + vec2<i32>(place_12 % i32(3), place_12 / i32(3)) - vec2<i32>(i32(1));
        var way_0 : vec2<f32> = vec2<f32>(pixel_0) + vec2<f32>(0.5f) - at_18;
        var distance_2 : f32 = dot(way_0, way_0);
        var index_23 : u32 = pixel_before_0(wanted_4, pixel_0);
        var _S183 : bool;
        if(index_23 != (real_time_0.pixels_0))
        {
            _S183 = distance_2 < (least_3 - 0.00100000004749745f);
        }
        else
        {
            _S183 = false;
        }
        if(_S183)
        {
            least_3 = distance_2;
            best_0 = index_23;
        }
        place_12 = place_12 + i32(1);
    }
    if(best_0 == (real_time_0.pixels_0))
    {
        return not_lit_0();
    }
    return load_lit_0(best_0);
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, params_0.eye_1, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0, params_0.lens_x_0, params_0.lens_y_0, params_0.blades_0);
}

fn lit_before_0( sample_3 : Sample_0,  pixel_1 : vec2<u32>,  shown_0 : ptr<function, u32>) -> Lit_0
{
    (*shown_0) = u32(0);
    var wanted_5 : Wanted_0 = Wanted_x24init_0(sample_3.is_shown_0, sample_3.place_4, sample_3.normal_1, 0.0f);
    var _S184 : vec2<f32> = vec2<f32>(0.5f);
    var ray_0 : Ray_0 = CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(pixel_1) + _S184, vec2<f32>(0.5f));
    var along_0 : f32;
    if(sample_3.is_shown_0)
    {
        along_0 = dot_product_0(ray_0.direction_0, sample_3.place_4 - ray_0.origin_0) / length_squared_0(ray_0.direction_0);
    }
    else
    {
        along_0 = 1.0e+07f;
    }
    var middle_7 : vec3<f32> = ray_0.origin_0 + ray_0.direction_0 * vec3<f32>(along_0);
    var distance_3 : f32 = sqrt(length_squared_0(sample_3.place_4 - real_time_0.eye_0));
    var pixel_width_0 : f32 = real_time_0.view_angle_0 / f32(params_0.height_0);
    if(sample_3.is_shown_0)
    {
        along_0 = pixel_width_0 * distance_3;
    }
    else
    {
        along_0 = 0.0f;
    }
    wanted_5.tolerance_0 = 1.5f + along_0;
    var is_seen_0 : bool;
    if(sample_3.is_shown_0)
    {
        is_seen_0 = (sample_3.instance_2) < (real_time_0.motions_0);
    }
    else
    {
        is_seen_0 = false;
    }
    var middle_8 : vec3<f32>;
    if(is_seen_0)
    {
        var row_12 : u32 = u32(4) * sample_3.instance_2;
        var place_13 : vec4<f32> = vec4<f32>(sample_3.place_4, 1.0f);
        var between_0 : vec4<f32> = vec4<f32>(middle_7, 1.0f);
        var normal_6 : vec4<f32> = vec4<f32>(sample_3.normal_1, 0.0f);
        var _S185 : u32 = row_12 + u32(1);
        var _S186 : u32 = row_12 + u32(2);
        wanted_5.place_6 = vec3<f32>(dot(motions_1[row_12], place_13), dot(motions_1[_S185], place_13), dot(motions_1[_S186], place_13));
        var _S187 : vec3<f32> = vec3<f32>(dot(motions_1[row_12], between_0), dot(motions_1[_S185], between_0), dot(motions_1[_S186], between_0));
        var turned_0 : vec3<f32> = vec3<f32>(dot(motions_1[row_12], normal_6), dot(motions_1[_S185], normal_6), dot(motions_1[_S186], normal_6));
        wanted_5.normal_3 = turned_0 / vec3<f32>(max(sqrt(length_squared_0(turned_0)), 9.99999968265522539e-21f));
        middle_8 = _S187;
    }
    else
    {
        middle_8 = middle_7;
    }
    var way_1 : vec3<f32> = middle_8 - real_time_0.before_origin_0;
    var _S188 : f32 = dot_product_0(real_time_0.before_rows_0[i32(2)].xyz, way_1);
    var is_seen_1 : bool = has_0(u32(32));
    var _S189 : vec2<f32> = vec2<f32>(dot_product_0(real_time_0.before_rows_0[i32(0)].xyz, way_1), dot_product_0(real_time_0.before_rows_0[i32(1)].xyz, way_1));
    var at_19 : vec2<f32>;
    if(has_0(u32(64)))
    {
        if(is_seen_1)
        {
            is_seen_0 = _S188 > 9.99999997475242708e-07f;
        }
        else
        {
            is_seen_0 = false;
        }
        at_19 = _S189 / vec2<f32>(max(_S188, 9.99999997475242708e-07f));
    }
    else
    {
        is_seen_0 = is_seen_1;
        at_19 = _S189;
    }
    if(!is_seen_0)
    {
        is_seen_0 = true;
    }
    else
    {
        is_seen_0 = (any(((abs(at_19)) > vec2<f32>(1.0e+06f))));
    }
    if(is_seen_0)
    {
        return not_lit_0();
    }
    var middle_of_pixel_0 : vec2<f32> = floor(at_19) + _S184;
    var at_20 : vec2<f32> = select(at_19, middle_of_pixel_0, (abs(at_19 - middle_of_pixel_0)) <= vec2<f32>(0.00100000004749745f));
    var _S190 : vec2<f32> = at_20 - _S184;
    var corner_10 : vec2<f32> = floor(_S190);
    var share_5 : vec2<f32> = _S190 - corner_10;
    var across_2 : vec4<f32> = cubic_weights_0(share_5.x);
    var down_2 : vec4<f32> = cubic_weights_0(share_5.y);
    if(is_inside_0(vec2<i32>(floor(at_20))))
    {
        (*shown_0) = shown_at_0(vec2<i32>(corner_10), across_2, down_2);
    }
    var _S191 : vec2<i32> = vec2<i32>(corner_10);
    var lit_5 : Lit_0;
    var _S192 : bool = cubic_0(wanted_5, _S191, across_2, down_2, &(lit_5));
    if(_S192)
    {
        return lit_5;
    }
    var _S193 : bool = linear_mean_0(wanted_5, _S191, share_5, &(lit_5));
    if(!_S193)
    {
        lit_5 = nearest_0(wanted_5, at_20);
    }
    lit_5.paths_6 = min(lit_5.paths_6, 8.0f);
    return lit_5;
}

fn Lit_beyond_0( this_9 : Lit_0,  kept_6 : vec3<f32>) -> vec3<f32>
{
    var products_0 : vec3<f32> = Lit_products_0(this_9, kept_6);
    var _S194 : vec3<f32> = vec3<f32>(1.00000000317107685e-30f);
    return select(vec3<f32>(0.0f), min(this_9.moments_0 / max(products_0, _S194), vec3<f32>(60000.0f)) - vec3<f32>(1.0f), products_0 > _S194);
}

fn words_of_0( lit_6 : Lit_0) -> vec3<u32>
{
    var first_1 : u32 = halves_0(lit_6.shaded_1.x, lit_6.shaded_1.y);
    var last_0 : f32 = low_half_0(halves_0(lit_6.shaded_1.z, 0.0f));
    var beyond_0 : vec3<f32> = Lit_beyond_0(lit_6, vec3<f32>(low_half_0(first_1), high_half_0(first_1), last_0));
    return vec3<u32>(first_1, halves_0(last_0, beyond_0.x), halves_0(beyond_0.y, beyond_0.z));
}

fn store_known_0( index_24 : u32,  lit_7 : Lit_0,  shown_1 : u32)
{
    var words_3 : vec3<u32> = words_of_0(lit_7);
    set_scratch_row_0(u32(7), index_24, vec2<u32>(halves_0(lit_7.light_10.x, lit_7.light_10.y), halves_0(lit_7.light_10.z, lit_7.paths_6)));
    set_scratch_row_0(u32(8), index_24, words_3.xy);
    set_scratch_row_0(u32(9), index_24, vec2<u32>(words_3.z, shown_1));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn reproject(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    var at_21 : vec2<u32> = pixel_of_thread_0(id_4.x);
    var _S195 : vec2<i32> = vec2<i32>(at_21);
    if(is_inside_0(_S195))
    {
        var index_25 : u32 = index_of_0(at_21);
        var sample_4 : Sample_0 = sample_at_0(_S195);
        var shown_2 : u32 = u32(0);
        var lit_8 : Lit_0 = not_lit_0();
        var _S196 : bool;
        if(has_0(u32(2048)))
        {
            _S196 = (((memory_row_0(u32(0), index_25).w) & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S196 = false;
        }
        if(_S196)
        {
            _S196 = !shows_mover_0(sample_4);
        }
        else
        {
            _S196 = false;
        }
        if(_S196)
        {
            lit_8.paths_6 = -1.0f;
        }
        else
        {
            var _S197 : Lit_0 = lit_before_0(sample_4, at_21, &(shown_2));
            lit_8 = _S197;
        }
        store_known_0(index_25, lit_8, shown_2);
    }
    return;
}

struct Memory_0
{
     lit_9 : Lit_0,
     looks_0 : f32,
     direct_2 : vec3<f32>,
     albedo_2 : vec3<f32>,
     normal_7 : vec3<f32>,
     place_14 : vec3<f32>,
     roughness_0 : f32,
     coverage_0 : f32,
     shown_3 : u32,
     is_at_rest_0 : bool,
};

fn Memory_x24init_0( lit_10 : Lit_0,  looks_1 : f32,  direct_3 : vec3<f32>,  albedo_3 : vec3<f32>,  normal_8 : vec3<f32>,  place_15 : vec3<f32>,  roughness_1 : f32,  coverage_1 : f32,  shown_4 : u32,  is_at_rest_1 : bool) -> Memory_0
{
    var _S198 : Memory_0;
    _S198.lit_9 = lit_10;
    _S198.looks_0 = looks_1;
    _S198.direct_2 = direct_3;
    _S198.albedo_2 = albedo_3;
    _S198.normal_7 = normal_8;
    _S198.place_14 = place_15;
    _S198.roughness_0 = roughness_1;
    _S198.coverage_0 = coverage_1;
    _S198.shown_3 = shown_4;
    _S198.is_at_rest_0 = is_at_rest_1;
    return _S198;
}

fn nothing_known_0() -> Memory_0
{
    var _S199 : vec3<f32> = vec3<f32>(0.0f);
    return Memory_x24init_0(not_lit_0(), 0.0f, _S199, _S199, _S199, _S199, 0.0f, 0.0f, u32(0), false);
}

fn load_memory_0( index_26 : u32) -> Memory_0
{
    var surface_3 : vec4<u32> = memory_row_0(u32(0), index_26);
    var shaded_4 : vec4<u32> = memory_row_0(u32(1), index_26);
    var seen_0 : vec4<u32> = memory_row_0(u32(3), index_26);
    var memory_0 : Memory_0;
    memory_0.lit_9 = load_lit_0(index_26);
    memory_0.looks_0 = high_half_0(shaded_4.x);
    var _S200 : u32 = seen_0.x;
    var _S201 : u32 = seen_0.y;
    memory_0.direct_2 = vec3<f32>(low_half_0(_S200), high_half_0(_S200), low_half_0(_S201));
    var _S202 : u32 = seen_0.z;
    memory_0.albedo_2 = vec3<f32>(high_half_0(_S201), low_half_0(_S202), high_half_0(_S202));
    var _S203 : u32 = surface_3.w;
    memory_0.normal_7 = normal_in_0(_S203);
    memory_0.place_14 = (bitcast<vec3<f32>>((surface_3.xyz)));
    var _S204 : u32 = shaded_4.y;
    memory_0.roughness_0 = high_half_0(_S204);
    memory_0.coverage_0 = low_half_0(_S204);
    memory_0.shown_3 = seen_0.w;
    memory_0.is_at_rest_0 = ((_S203 & (u32(2147483648)))) != u32(0);
    return memory_0;
}

fn Memory_look_anew_0( this_10 : ptr<function, Memory_0>)
{
    (*this_10).looks_0 = 0.0f;
    (*this_10).coverage_0 = 0.0f;
    (*this_10).roughness_0 = 0.0f;
    (*this_10).is_at_rest_0 = false;
    return;
}

fn load_known_0( index_27 : u32) -> Lit_0
{
    var light_14 : vec2<u32> = scratch_row_0(u32(7), index_27);
    var _S205 : u32 = light_14.y;
    var _S206 : u32 = light_14.x;
    return lit_of_0(high_half_0(_S205), vec3<f32>(low_half_0(_S206), high_half_0(_S206), low_half_0(_S205)), vec3<u32>(scratch_row_0(u32(8), index_27), scratch_row_0(u32(9), index_27).x));
}

fn memory_before_0( index_28 : u32) -> Memory_0
{
    var memory_1 : Memory_0 = nothing_known_0();
    if(!has_0(u32(4)))
    {
        return memory_1;
    }
    if(has_0(u32(16)))
    {
        memory_1 = load_memory_0(index_28);
        if(!has_0(u32(8)))
        {
            Memory_look_anew_0(&(memory_1));
        }
        return memory_1;
    }
    memory_1.lit_9 = load_known_0(index_28);
    if((memory_1.lit_9.paths_6) == -1.0f)
    {
        return load_memory_0(index_28);
    }
    memory_1.shown_3 = scratch_row_0(u32(9), index_28).y;
    return memory_1;
}

fn normal_steps_0( normal_9 : vec3<f32>) -> vec3<f32>
{
    return floor(clamp(normal_9, vec3<f32>(-1.0f), vec3<f32>(1.0f)) * vec3<f32>(511.0f) + vec3<f32>(0.50099998712539673f));
}

fn in_ten_bits_0( normal_10 : vec3<f32>) -> vec3<f32>
{
    return normal_steps_0(normal_10) * vec3<f32>(0.00195694714784622f);
}

fn Memory_look_0( this_11 : ptr<function, Memory_0>,  sample_5 : Sample_0)
{
    var _S207 : f32 = (*this_11).looks_0 + 1.0f;
    (*this_11).looks_0 = _S207;
    var share_6 : f32 = 1.0f / _S207;
    var _S208 : vec3<f32> = vec3<f32>(share_6);
    (*this_11).direct_2 = (*this_11).direct_2 + (sample_5.direct_0 - (*this_11).direct_2) * _S208;
    (*this_11).albedo_2 = (*this_11).albedo_2 + (sample_5.albedo_0 - (*this_11).albedo_2) * _S208;
    if(!sample_5.is_shown_0)
    {
        (*this_11).coverage_0 = (*this_11).coverage_0 - (*this_11).coverage_0 * share_6;
        return;
    }
    var covered_0 : f32 = (*this_11).coverage_0 * ((*this_11).looks_0 - 1.0f) + 1.0f;
    (*this_11).coverage_0 = covered_0 * share_6;
    var of_covered_0 : f32 = 1.0f / covered_0;
    var before_2 : vec3<f32> = (*this_11).place_14;
    var _S209 : vec3<f32> = vec3<f32>(of_covered_0);
    (*this_11).normal_7 = in_ten_bits_0((*this_11).normal_7 + (sample_5.normal_1 - (*this_11).normal_7) * _S209);
    (*this_11).place_14 = (*this_11).place_14 + (sample_5.place_4 - (*this_11).place_14) * _S209;
    if(covered_0 > 1.0f)
    {
        var along_1 : f32 = dot_product_0((*this_11).normal_7, sample_5.place_4 - before_2);
        (*this_11).roughness_0 = (*this_11).roughness_0 + (along_1 * along_1 / max(length_squared_0((*this_11).normal_7), 9.99999997475242708e-07f) * (1.0f - of_covered_0) - (*this_11).roughness_0) * of_covered_0;
    }
    return;
}

fn Lit_add_0( this_12 : ptr<function, Lit_0>,  found_2 : vec3<f32>,  albedo_4 : vec3<f32>,  most_0 : f32)
{
    var _S210 : f32 = min((*this_12).paths_6 + 1.0f, most_0);
    (*this_12).paths_6 = _S210;
    var l_1 : f32 = luminance_0(found_2);
    var a_4 : f32 = luminance_0(albedo_4);
    var _S211 : vec3<f32> = vec3<f32>((1.0f / _S210));
    (*this_12).light_10 = (*this_12).light_10 + (found_2 - (*this_12).light_10) * _S211;
    (*this_12).shaded_1 = (*this_12).shaded_1 + (albedo_4 - (*this_12).shaded_1) * _S211;
    (*this_12).moments_0 = (*this_12).moments_0 + (vec3<f32>(l_1 * l_1, l_1 * a_4, a_4 * a_4) - (*this_12).moments_0) * _S211;
    return;
}

fn Memory_add_0( this_13 : ptr<function, Memory_0>,  sample_6 : Sample_0,  most_1 : f32)
{
    Memory_look_0(&((*this_13)), sample_6);
    var _S212 : Lit_0 = (*this_13).lit_9;
    Lit_add_0(&(_S212), sample_6.light_8, sample_6.albedo_0, most_1);
    (*this_13).lit_9 = _S212;
    return;
}

fn packed_normal_0( normal_11 : vec3<f32>) -> u32
{
    var _S213 : vec3<i32> = vec3<i32>(normal_steps_0(normal_11));
    return (((((u32(_S213.x) & (u32(1023)))) | (((((u32(_S213.y) & (u32(1023)))) << (u32(10))))))) | (((((u32(_S213.z) & (u32(1023)))) << (u32(20))))));
}

fn store_memory_0( index_29 : u32,  memory_2 : Memory_0)
{
    var pixels_1 : u32 = real_time_0.pixels_0;
    var words_4 : vec3<u32> = words_of_0(memory_2.lit_9);
    var _S214 : u32 = packed_normal_0(memory_2.normal_7);
    var _S215 : u32;
    if((memory_2.coverage_0) > 0.0f)
    {
        _S215 = u32(1073741824);
    }
    else
    {
        _S215 = u32(0);
    }
    var _S216 : u32 = (_S214 | (_S215));
    if(memory_2.is_at_rest_0)
    {
        _S215 = u32(2147483648);
    }
    else
    {
        _S215 = u32(0);
    }
    memory_rows_0[index_29] = vec4<u32>((bitcast<vec3<u32>>((memory_2.place_14))), (_S216 | (_S215)));
    memory_rows_0[pixels_1 + index_29] = vec4<u32>(halves_0(memory_2.lit_9.paths_6, memory_2.looks_0), halves_0(memory_2.coverage_0, memory_2.roughness_0), words_4.x, words_4.y);
    memory_rows_0[u32(2) * pixels_1 + index_29] = vec4<u32>((bitcast<vec3<u32>>((memory_2.lit_9.light_10))), words_4.z);
    memory_rows_0[u32(3) * pixels_1 + index_29] = vec4<u32>(halves_0(memory_2.direct_2.x, memory_2.direct_2.y), halves_0(memory_2.direct_2.z, memory_2.albedo_2.x), halves_0(memory_2.albedo_2.y, memory_2.albedo_2.z), memory_2.shown_3);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn remember_others(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    var at_22 : vec2<u32> = pixel_of_thread_0(id_5.x);
    var _S217 : vec2<i32> = vec2<i32>(at_22);
    var _S218 : bool;
    if(is_inside_0(_S217))
    {
        _S218 = !traces_0(_S217);
    }
    else
    {
        _S218 = false;
    }
    if(_S218)
    {
        var index_30 : u32 = index_of_0(at_22);
        var memory_3 : Memory_0 = memory_before_0(index_30);
        var is_lit_0 : bool = (memory_3.lit_9.paths_6) > 0.0f;
        if(!is_lit_0)
        {
            _S218 = true;
        }
        else
        {
            if(has_0(u32(8)))
            {
                _S218 = true;
            }
            else
            {
                _S218 = memory_3.is_at_rest_0;
            }
            _S218 = !_S218;
        }
        if(_S218)
        {
            var which_1 : u32 = u32(0);
            for(;;)
            {
                if(which_1 < u32(4))
                {
                }
                else
                {
                    break;
                }
                var beside_6 : vec2<i32> = _S217 + neighbour_0(which_1);
                if(!is_inside_0(beside_6))
                {
                    which_1 = which_1 + u32(1);
                    continue;
                }
                var sample_7 : Sample_0 = load_sample_0(index_of_0(vec2<u32>(beside_6)));
                if(is_lit_0)
                {
                    Memory_look_0(&(memory_3), sample_7);
                }
                else
                {
                    Memory_add_0(&(memory_3), sample_7, real_time_0.most_paths_0);
                }
                which_1 = which_1 + u32(1);
            }
            store_memory_0(index_30, memory_3);
        }
    }
    return;
}

fn sum_9( channels_0 : vec3<f32>) -> f32
{
    return channels_0.x + channels_0.y + channels_0.z;
}

fn Lit_irradiance_0( this_14 : Lit_0) -> vec3<f32>
{
    return (this_14.light_10 + vec3<f32>((0.00300000002607703f * sum_9(this_14.light_10) / max(sum_9(this_14.shaded_1), 0.00030000001424924f)))) / (this_14.shaded_1 + vec3<f32>(0.00300000002607703f));
}

fn Lit_variance_0( this_15 : Lit_0) -> f32
{
    var albedo_5 : f32 = luminance_0(this_15.shaded_1) + 0.00300000002607703f;
    var ratio_0 : f32 = luminance_0(Lit_irradiance_0(this_15));
    return max(this_15.moments_0.x - 2.0f * ratio_0 * this_15.moments_0.y + ratio_0 * ratio_0 * this_15.moments_0.z, 0.0f) / (albedo_5 * albedo_5 * max(this_15.paths_6 - 1.0f, 0.5f));
}

fn variance_around_0( at_23 : vec2<i32>,  center_1 : Center_0) -> f32
{
    var dy_7 : i32 = i32(-3);
    var sum_10 : f32 = 0.0f;
    var squares_2 : f32 = 0.0f;
    var weights_16 : f32 = 0.0f;
    for(;;)
    {
        if(dy_7 <= i32(3))
        {
        }
        else
        {
            break;
        }
        var dx_7 : i32 = i32(-3);
        var sum_11 : f32 = sum_10;
        var squares_3 : f32 = squares_2;
        var weights_17 : f32 = weights_16;
        for(;;)
        {
            if(dx_7 <= i32(3))
            {
            }
            else
            {
                break;
            }
            var other_9 : vec2<i32> = at_23 + vec2<i32>(dx_7, dy_7);
            if(!is_inside_0(other_9))
            {
                dx_7 = dx_7 + i32(1);
                continue;
            }
            var index_31 : u32 = index_of_0(vec2<u32>(other_9));
            var weight_7 : f32 = Center_alike_0(center_1, index_31);
            var light_15 : f32 = luminance_0(Lit_irradiance_0(load_lit_0(index_31)));
            var _S219 : f32 = weight_7 * light_15;
            var squares_4 : f32 = squares_3 + _S219 * light_15;
            var weights_18 : f32 = weights_17 + weight_7;
            sum_11 = sum_11 + _S219;
            squares_3 = squares_4;
            weights_17 = weights_18;
            dx_7 = dx_7 + i32(1);
        }
        dy_7 = dy_7 + i32(1);
        sum_10 = sum_11;
        squares_2 = squares_3;
        weights_16 = weights_17;
    }
    var scale_2 : f32 = 1.0f / max(weights_16, 9.99999968265522539e-21f);
    return max(squares_2 * scale_2 - sum_10 * scale_2 * sum_10 * scale_2, 0.0f);
}

fn begin_filter_0( at_24 : vec2<i32>)
{
    var index_32 : u32 = index_of_0(vec2<u32>(at_24));
    var lit_11 : Lit_0 = load_lit_0(index_32);
    var color_18 : vec3<f32> = Lit_irradiance_0(lit_11);
    var own_6 : f32 = Lit_variance_0(lit_11);
    var own_7 : f32;
    if((lit_11.paths_6) < 3.5f)
    {
        var around_0 : f32 = variance_around_0(at_24, center_of_0(index_32));
        if((lit_11.paths_6) < 1.5f)
        {
            own_7 = around_0;
        }
        else
        {
            own_7 = 0.5f * (around_0 + own_6);
        }
    }
    else
    {
        own_7 = own_6;
    }
    set_color_0(u32(0), index_32, vec4<f32>(color_18, 0.0f));
    set_numbers_0(u32(4), index_32, vec2<f32>(own_7, luminance_0(color_18)));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_begin(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    var _S220 : vec2<u32> = pixel_of_thread_0(id_6.x);
    var _S221 : vec2<i32> = vec2<i32>(_S220);
    if(is_inside_0(_S221))
    {
        begin_filter_0(_S221);
    }
    return;
}

fn mean_around_0( row_13 : u32,  at_25 : vec2<i32>,  step_3 : i32) -> vec2<f32>
{
    var _S222 : Center_0 = center_of_0(index_of_0(vec2<u32>(at_25)));
    var _S223 : vec2<f32> = vec2<f32>(0.0f);
    var dy_8 : i32 = i32(-2);
    var sum_12 : vec2<f32> = _S223;
    var weights_19 : f32 = 0.0f;
    for(;;)
    {
        if(dy_8 <= i32(2))
        {
        }
        else
        {
            break;
        }
        var dx_8 : i32 = i32(-2);
        var sum_13 : vec2<f32> = sum_12;
        var weights_20 : f32 = weights_19;
        for(;;)
        {
            if(dx_8 <= i32(2))
            {
            }
            else
            {
                break;
            }
            var other_10 : vec2<i32> = at_25 + vec2<i32>(dx_8, dy_8) * vec2<i32>(step_3);
            if(!is_inside_0(other_10))
            {
                dx_8 = dx_8 + i32(1);
                continue;
            }
            var index_33 : u32 = index_of_0(vec2<u32>(other_10));
            var weight_8 : f32 = SPLINE_0[abs(dx_8)] * SPLINE_0[abs(dy_8)] * Center_alike_0(_S222, index_33);
            var weights_21 : f32 = weights_20 + weight_8;
            sum_13 = sum_13 + numbers_0(row_13, index_33) * vec2<f32>(weight_8);
            weights_20 = weights_21;
            dx_8 = dx_8 + i32(1);
        }
        dy_8 = dy_8 + i32(1);
        sum_12 = sum_13;
        weights_19 = weights_20;
    }
    return sum_12 / vec2<f32>(max(weights_19, 9.99999968265522539e-21f));
}

fn compare_around_0( at_26 : vec2<i32>)
{
    var index_34 : u32 = index_of_0(vec2<u32>(at_26));
    var around_1 : vec2<f32> = mean_around_0(u32(4), at_26, i32(1));
    var difference_5 : f32 = numbers_0(u32(4), index_34).y - around_1.y;
    set_numbers_0(u32(5), index_34, vec2<f32>(around_1.x, difference_5 * difference_5));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_compare(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    var _S224 : vec2<u32> = pixel_of_thread_0(id_7.x);
    var _S225 : vec2<i32> = vec2<i32>(_S224);
    if(is_inside_0(_S225))
    {
        compare_around_0(_S225);
    }
    return;
}

fn estimate_noise_0( at_27 : vec2<i32>)
{
    var index_35 : u32 = index_of_0(vec2<u32>(at_27));
    var own_8 : f32 = numbers_0(u32(4), index_35).x;
    var color_19 : vec4<f32> = color_in_0(u32(0), index_35);
    color_19[i32(3)] = sqrt(max(own_8, mean_around_0(u32(5), at_27, i32(2)).x));
    set_color_0(u32(0), index_35, color_19);
    var _S226 : vec2<f32> = vec2<f32>(0.0f);
    var dx_9 : i32 = i32(-8);
    var sum_14 : vec2<f32> = _S226;
    var count_9 : f32 = 0.0f;
    for(;;)
    {
        if(dx_9 <= i32(8))
        {
        }
        else
        {
            break;
        }
        var other_11 : vec2<i32> = at_27 + vec2<i32>(dx_9, i32(0));
        if(!is_inside_0(other_11))
        {
            dx_9 = dx_9 + i32(1);
            continue;
        }
        var beside_7 : u32 = index_of_0(vec2<u32>(other_11));
        var count_10 : f32 = count_9 + 1.0f;
        sum_14 = sum_14 + vec2<f32>(numbers_0(u32(5), beside_7).y, numbers_0(u32(4), beside_7).x);
        count_9 = count_10;
        dx_9 = dx_9 + i32(1);
    }
    set_numbers_0(u32(3), index_35, sum_14 / vec2<f32>(count_9));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_noise(@builtin(global_invocation_id) id_8 : vec3<u32>)
{
    var _S227 : vec2<u32> = pixel_of_thread_0(id_8.x);
    var _S228 : vec2<i32> = vec2<i32>(_S227);
    if(is_inside_0(_S228))
    {
        estimate_noise_0(_S228);
    }
    return;
}

fn set_tolerance_0( at_28 : vec2<i32>)
{
    var index_36 : u32 = index_of_0(vec2<u32>(at_28));
    var mean_1 : vec2<f32> = mean_down_0(u32(3), at_28, i32(8));
    var excess_0 : f32 = mean_1.x / max(mean_1.y, 1.00000000317107685e-30f);
    set_color_0(u32(2), index_36, vec4<f32>(0.0f, 0.0f, 0.0f, clamp(10.0f / max(excess_0 * excess_0, 9.99999997475242708e-07f), 2.5f, 7.0f * (1.0f + 13.0f / max(low_half_0(memory_row_0(u32(1), index_36).x), 1.0f)))));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_tolerance(@builtin(global_invocation_id) id_9 : vec3<u32>)
{
    var _S229 : vec2<u32> = pixel_of_thread_0(id_9.x);
    var _S230 : vec2<i32> = vec2<i32>(_S229);
    if(is_inside_0(_S230))
    {
        set_tolerance_0(_S230);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_level_0(@builtin(global_invocation_id) id_10 : vec3<u32>)
{
    var _S231 : vec2<u32> = pixel_of_thread_0(id_10.x);
    var _S232 : vec2<i32> = vec2<i32>(_S231);
    if(is_inside_0(_S232))
    {
        smooth_light_4(_S232);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_level_1(@builtin(global_invocation_id) id_11 : vec3<u32>)
{
    var _S233 : vec2<u32> = pixel_of_thread_0(id_11.x);
    var _S234 : vec2<i32> = vec2<i32>(_S233);
    if(is_inside_0(_S234))
    {
        smooth_light_3(_S234);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_level_2(@builtin(global_invocation_id) id_12 : vec3<u32>)
{
    var _S235 : vec2<u32> = pixel_of_thread_0(id_12.x);
    var _S236 : vec2<i32> = vec2<i32>(_S235);
    if(is_inside_0(_S236))
    {
        smooth_light_2(_S236);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_level_3(@builtin(global_invocation_id) id_13 : vec3<u32>)
{
    var _S237 : vec2<u32> = pixel_of_thread_0(id_13.x);
    var _S238 : vec2<i32> = vec2<i32>(_S237);
    if(is_inside_0(_S238))
    {
        smooth_light_1(_S238);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_level_4(@builtin(global_invocation_id) id_14 : vec3<u32>)
{
    var _S239 : vec2<u32> = pixel_of_thread_0(id_14.x);
    var _S240 : vec2<i32> = vec2<i32>(_S239);
    if(is_inside_0(_S240))
    {
        smooth_light_0(_S240);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_end(@builtin(global_invocation_id) id_15 : vec3<u32>)
{
    var _S241 : vec2<u32> = pixel_of_thread_0(id_15.x);
    var _S242 : vec2<i32> = vec2<i32>(_S241);
    if(is_inside_0(_S242))
    {
        end_levels_0(_S242);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_across(@builtin(global_invocation_id) id_16 : vec3<u32>)
{
    var _S243 : vec2<u32> = pixel_of_thread_0(id_16.x);
    var _S244 : vec2<i32> = vec2<i32>(_S243);
    if(is_inside_0(_S244))
    {
        compare_across_0(_S244);
    }
    return;
}

fn radiance_of_0( memory_4 : Memory_0,  irradiance_0 : vec3<f32>) -> vec3<f32>
{
    var shown_5 : vec3<f32> = irradiance_0 * (memory_4.albedo_2 + vec3<f32>(0.00300000002607703f));
    var shown_6 : vec3<f32> = shown_5 - vec3<f32>((0.00300000002607703f * sum_9(shown_5) / (max(sum_9(memory_4.albedo_2), 0.00030000001424924f) + 0.00899999961256981f)));
    if((memory_4.coverage_0) > 0.0f)
    {
        return max(memory_4.direct_2 + shown_6, vec3<f32>(0.0f));
    }
    return memory_4.direct_2 + memory_4.lit_9.light_10;
}

@compute
@workgroup_size(64, 1, 1)
fn filter_picture(@builtin(global_invocation_id) id_17 : vec3<u32>)
{
    var _S245 : vec2<u32> = pixel_of_thread_0(id_17.x);
    var _S246 : vec2<i32> = vec2<i32>(_S245);
    if(is_inside_0(_S246))
    {
        var index_37 : u32 = index_of_0(vec2<u32>(_S246));
        var memory_5 : Memory_0 = load_memory_0(index_37);
        set_color_0(u32(2), index_37, vec4<f32>(radiance_of_0(memory_5, trusted_light_0(_S246, Lit_irradiance_0(memory_5.lit_9))), 0.0f));
    }
    return;
}

fn is_kept_0( index_38 : u32) -> bool
{
    if((((memory_row_0(u32(0), index_38).w) & (u32(2147483648)))) == u32(0))
    {
        return false;
    }
    var _S247 : bool;
    if(has_0(u32(2048)))
    {
        _S247 = (high_half_0(memory_row_0(u32(1), index_38).x)) > 4.0f;
    }
    else
    {
        _S247 = false;
    }
    return _S247;
}

fn ycocg_0( color_20 : vec3<f32>) -> vec3<f32>
{
    var _S248 : f32 = color_20.x;
    var _S249 : f32 = 0.5f * color_20.y;
    var _S250 : f32 = color_20.z;
    return vec3<f32>(0.25f * _S248 + _S249 + 0.25f * _S250, 0.5f * (_S248 - _S250), _S249 - 0.25f * (_S248 + _S250));
}

fn antialiased_0( at_29 : vec2<i32>,  word_6 : u32) -> vec3<f32>
{
    var index_39 : u32 = index_of_0(vec2<u32>(at_29));
    var now_1 : vec3<f32> = color_in_0(u32(2), index_39).xyz;
    var _S251 : bool;
    if(word_6 == u32(0))
    {
        _S251 = true;
    }
    else
    {
        _S251 = (real_time_0.share_0) >= 1.0f;
    }
    if(_S251)
    {
        return now_1;
    }
    var history_0 : vec3<f32> = shown_in_0(word_6);
    if(is_kept_0(index_39))
    {
        return history_0 + (now_1 - history_0) * vec3<f32>(0.5f);
    }
    var _S252 : vec3<f32> = vec3<f32>(0.0f);
    var place_16 : i32 = i32(0);
    var sum_15 : vec3<f32> = _S252;
    var squares_5 : vec3<f32> = _S252;
    var count_11 : f32 = 0.0f;
    for(;;)
    {
        if(place_16 < i32(9))
        {
        }
        else
        {
            break;
        }
        var other_12 : vec2<i32> = at_29 + vec2<i32>(place_16 % i32(3), place_16 / i32(3)) - vec2<i32>(i32(1));
        if(!is_inside_0(other_12))
        {
            place_16 = place_16 + i32(1);
            continue;
        }
        var color_21 : vec3<f32> = ycocg_0(color_in_0(u32(2), index_of_0(vec2<u32>(other_12))).xyz);
        var squares_6 : vec3<f32> = squares_5 + color_21 * color_21;
        var count_12 : f32 = count_11 + 1.0f;
        sum_15 = sum_15 + color_21;
        squares_5 = squares_6;
        count_11 = count_12;
        place_16 = place_16 + i32(1);
    }
    var mean_2 : vec3<f32> = sum_15 / vec3<f32>(count_11);
    var reach_2 : vec3<f32> = vec3<f32>(1.5f) * sqrt(max(squares_5 / vec3<f32>(count_11) - mean_2 * mean_2, _S252));
    var shown_7 : vec3<f32> = clamp(ycocg_0(history_0), mean_2 - reach_2, mean_2 + reach_2);
    var shown_8 : vec3<f32> = shown_7 + (ycocg_0(now_1) - shown_7) * vec3<f32>(real_time_0.share_0);
    var _S253 : f32 = shown_8.x;
    var _S254 : f32 = shown_8.y;
    var _S255 : f32 = shown_8.z;
    return max(vec3<f32>(_S253 + _S254 - _S255, _S253 + _S255, _S253 - _S254 - _S255), _S252);
}

fn half_of_0( value_4 : f32) -> u32
{
    var bits_0 : u32 = (bitcast<u32>((clamp(value_4, -65504.0f, 65504.0f))));
    var exponent_3 : i32 = i32((((bits_0 >> (u32(23)))) & (u32(255)))) - i32(112);
    var mantissa_2 : u32 = (bits_0 & (u32(8388607)));
    var magnitude_0 : u32;
    if(exponent_3 >= i32(1))
    {
        magnitude_0 = (((u32(exponent_3) << (u32(10)))) | (((mantissa_2 >> (u32(13))))));
    }
    else
    {
        if(exponent_3 >= i32(-10))
        {
            magnitude_0 = (((mantissa_2 | (u32(8388608)))) >> (u32(i32(14) - exponent_3)));
        }
        else
        {
            magnitude_0 = u32(0);
        }
    }
    return (((((bits_0 >> (u32(16)))) & (u32(32768)))) | (magnitude_0));
}

@compute
@workgroup_size(64, 1, 1)
fn show_picture(@builtin(global_invocation_id) id_18 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var _S256 : u32 = id_18.x;
    var _S257 : vec2<u32> = pixel_of_thread_0(_S256);
    var _S258 : vec2<i32> = vec2<i32>(_S257);
    if(is_inside_0(_S258))
    {
        var index_40 : u32 = index_of_0(vec2<u32>(_S258));
        var radiance_0 : vec3<f32>;
        if(has_0(u32(256)))
        {
            radiance_0 = antialiased_0(_S258, memory_row_0(u32(3), index_40).w);
        }
        else
        {
            var memory_6 : Memory_0 = load_memory_0(index_40);
            radiance_0 = radiance_of_0(memory_6, Lit_irradiance_0(memory_6.lit_9));
        }
        memory_rows_0[u32(3) * real_time_0.pixels_0 + index_40][i32(3)] = word_of_0(radiance_0);
        picture_0[index_40] = vec2<u32>(((half_of_0(radiance_0.x)) | ((((half_of_0(radiance_0.y)) << (u32(16)))))), ((half_of_0(radiance_0.z)) | ((((memory_row_0(u32(1), index_40).y) << (u32(16)))))));
    }
    if(thread_1 == u32(0))
    {
        if(_S256 == u32(0))
        {
            atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        }
        var _S259 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

