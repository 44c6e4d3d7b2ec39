@binding(27) @group(0) var<storage, read_write> cell_keys_0 : array<atomic<u32>>;

@binding(28) @group(0) var<storage, read_write> cell_rows_0 : array<vec4<u32>>;

struct FrameParams_std140_0
{
    @align(16) eye_0 : vec3<f32>,
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
struct RealTimeParams_std140_0
{
    @align(16) eye_1 : vec3<f32>,
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
};

@binding(24) @group(0) var<uniform> real_time_0 : RealTimeParams_std140_0;
struct Transform_std430_0
{
    @align(4) x_axis_0 : array<f32, i32(3)>,
    @align(4) y_axis_0 : array<f32, i32(3)>,
    @align(4) z_axis_0 : array<f32, i32(3)>,
    @align(4) translation_0 : array<f32, i32(3)>,
};

struct PackedInstance_std430_0
{
    @align(4) grid_from_world_0 : Transform_std430_0,
    @align(4) world_from_grid_0 : Transform_std430_0,
    @align(4) grid_0 : u32,
    @align(4) scene_instance_0 : u32,
    @align(4) light_leaf_0 : u32,
};

@binding(4) @group(0) var<storage, read> instances_0 : array<PackedInstance_std430_0>;

@binding(17) @group(0) var<storage, read> top_light_node_rows_0 : array<vec4<u32>>;

struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

@binding(21) @group(0) var<storage, read_write> pages_0 : array<u32>;

@binding(8) @group(0) var<storage, read> light_node_rows_0 : array<vec4<u32>>;

@binding(0) @group(0) var<storage, read> cells_0 : array<u32>;

@binding(7) @group(0) var<storage, read> emitter_rows_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read> material_rows_0 : array<vec4<u32>>;

struct InstanceNode_std430_0
{
    @align(4) min_0 : array<f32, i32(3)>,
    @align(4) index_0 : u32,
    @align(4) max_0 : array<f32, i32(3)>,
    @align(4) is_leaf_0 : u32,
};

@binding(5) @group(0) var<storage, read> instance_nodes_0 : array<InstanceNode_std430_0>;

struct PackedGrid_std430_0
{
    @align(4) origin_0 : array<i32, i32(3)>,
    @align(4) top_shift_0 : u32,
    @align(4) top_size_0 : array<i32, i32(3)>,
    @align(4) top_offset_0 : u32,
    @align(4) min_1 : array<i32, i32(3)>,
    @align(4) voxels_0 : array<u32, i32(2)>,
    @align(4) max_1 : array<i32, i32(3)>,
    @align(4) material_bits_0 : u32,
};

@binding(3) @group(0) var<storage, read> grids_0 : array<PackedGrid_std430_0>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

@binding(26) @group(0) var<storage, read_write> scratch_0 : array<vec2<u32>>;

@binding(25) @group(0) var<storage, read_write> memory_rows_0 : array<vec4<u32>>;

@id(6) override SKY_0 : u32 = u32(0);

struct Sample_0
{
     direct_0 : vec3<f32>,
     light_0 : vec3<f32>,
     is_shown_0 : bool,
     albedo_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     place_0 : vec3<f32>,
     instance_0 : u32,
};

struct Sampler_0
{
     seed_1 : u32,
     pixel_0 : u32,
     sample_0 : u32,
};

struct Selection_0
{
     sun_0 : f32,
     sky_1 : f32,
     emitters_0 : f32,
};

struct Inside_0
{
     instance_1 : u32,
     voxel_0 : vec3<i32>,
     material_0 : u32,
};

struct Path_0
{
     sampler_0 : Sampler_0,
     bounce_0 : u32,
     event_0 : u32,
     kinds_0 : u32,
     scattered_0 : u32,
     beta_0 : vec3<f32>,
     pdf_1 : f32,
     normal_1 : vec3<f32>,
     selection_0 : Selection_0,
     passed_t_0 : f32,
     inside_0 : Inside_0,
     is_clipped_0 : bool,
};

struct Ray_0
{
     origin_1 : vec3<f32>,
     t_min_0 : f32,
     direction_0 : vec3<f32>,
     t_max_0 : f32,
};

struct Walker_0
{
     path_0 : Path_0,
     ray_0 : Ray_0,
     is_shadow_ray_0 : bool,
     light_1 : vec3<f32>,
     direction_1 : vec3<f32>,
     path_origin_0 : vec3<f32>,
     shadow_inside_0 : Inside_0,
     boundaries_0 : u32,
     relocates_0 : bool,
     path_relocates_0 : bool,
     way_0 : f32,
     has_shown_0 : bool,
     asks_cache_0 : bool,
     life_0 : u32,
};

fn Sample_x24init_0( direct_1 : vec3<f32>,  light_2 : vec3<f32>,  is_shown_1 : bool,  albedo_1 : vec3<f32>,  normal_2 : vec3<f32>,  place_1 : vec3<f32>,  instance_2 : u32) -> Sample_0
{
    var _S1 : Sample_0;
    _S1.direct_0 = direct_1;
    _S1.light_0 = light_2;
    _S1.is_shown_0 = is_shown_1;
    _S1.albedo_0 = albedo_1;
    _S1.normal_0 = normal_2;
    _S1.place_0 = place_1;
    _S1.instance_0 = instance_2;
    return _S1;
}

fn no_sample_0() -> Sample_0
{
    var _S2 : vec3<f32> = vec3<f32>(0.0f);
    return Sample_x24init_0(_S2, _S2, false, _S2, _S2, _S2, u32(4294967295));
}

struct Hit_0
{
     t_0 : f32,
     instance_3 : u32,
     voxel_1 : vec3<i32>,
     face_0 : u32,
};

@id(1) override IS_SINGLE_0 : bool = false;

struct LocalRay_0
{
     origin_2 : vec3<f32>,
     direction_2 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_1 : f32,
     t_max_1 : f32,
     is_valid_0 : bool,
};

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn Transform_direction_0( _S3 : u32,  _S4 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S3].grid_from_world_0.x_axis_0) * vec3<f32>(_S4.x) + vector_of_0(instances_0[_S3].grid_from_world_0.y_axis_0) * vec3<f32>(_S4.y) + vector_of_0(instances_0[_S3].grid_from_world_0.z_axis_0) * vec3<f32>(_S4.z);
}

fn Transform_point_0( _S5 : u32,  _S6 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S5, _S6) + vector_of_0(instances_0[_S5].grid_from_world_0.translation_0);
}

@id(0) override IS_EXACT_0 : bool = true;

fn is_normal_0( exponent_0 : u32) -> bool
{
    return (exponent_0 - u32(1)) < u32(254);
}

fn nearest_quotient_0( dividend_0 : u32,  divisor_0 : u32,  guess_0 : u32) -> u32
{
    var rest_0 : i32 = i32(((dividend_0 << (u32(23)))) - guess_0 * divisor_0);
    var units_0 : i32 = i32(floor(f32(rest_0) * (1.0f / f32(divisor_0)) + 0.5f));
    var _S7 : i32 = i32(divisor_0);
    var _S8 : i32 = i32(2) * (rest_0 - units_0 * _S7);
    return guess_0 + u32(units_0 + (i32(_S8 > _S7) - i32(_S8 < (- _S7))));
}

fn divide_0( a_0 : f32,  b_0 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_0 / b_0;
    }
    var _S9 : u32 = (bitcast<u32>((a_0)));
    var exponent_a_0 : u32 = (((_S9 >> (u32(23)))) & (u32(255)));
    var _S10 : u32 = (bitcast<u32>((b_0)));
    var exponent_b_0 : u32 = (((_S10 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S9 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S10 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_1 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S11 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S11 = true;
    }
    else
    {
        _S11 = !is_normal_0(exponent_b_0);
    }
    if(_S11)
    {
        _S11 = true;
    }
    else
    {
        _S11 = !is_normal_0(exponent_1);
    }
    if(_S11)
    {
        return a_0 / b_0;
    }
    return (bitcast<f32>(((((((_S9 ^ (_S10))) & (u32(2147483648)))) | ((((exponent_1 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn reciprocal_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_0.x), divide_0(1.0f, vector_0.y), divide_0(1.0f, vector_0.z));
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn local_ray_0( _S12 : Ray_0,  _S13 : u32) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_3 : vec3<f32>;
    var origin_3 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S14 : vec3<f32> = Transform_point_0(_S13, _S12.origin_1);
        direction_3 = Transform_direction_0(_S13, _S12.direction_0);
        origin_3 = _S14;
    }
    else
    {
        direction_3 = _S12.direction_0;
        origin_3 = _S12.origin_1;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_3)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S15 : vec3<f32> = select(direction_3, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_2 = _S15;
    local_0.inverse_0 = select(reciprocal_0(select(direction_3, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_2 = select(origin_3, floor(origin_3) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S15));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_0.origin_2)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((_S12.t_min_0) >= 0.0f)
    {
        is_segment_0 = (_S12.t_min_0) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S12.t_min_0) <= (_S12.t_max_0);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_1 = _S12.t_min_0;
    local_0.t_max_1 = _S12.t_max_0;
    if(moves_0)
    {
        moves_0 = is_near_0;
    }
    else
    {
        moves_0 = false;
    }
    if(moves_0)
    {
        moves_0 = is_segment_0;
    }
    else
    {
        moves_0 = false;
    }
    local_0.is_valid_0 = moves_0;
    return local_0;
}

fn Hit_x24init_0( t_1 : f32,  instance_4 : u32,  voxel_2 : vec3<i32>,  face_1 : u32) -> Hit_0
{
    var _S16 : Hit_0;
    _S16.t_0 = t_1;
    _S16.instance_3 = instance_4;
    _S16.voxel_1 = voxel_2;
    _S16.face_0 = face_1;
    return _S16;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

struct Walk_0
{
     ray_1 : LocalRay_0,
     origin_4 : vec3<f32>,
     offset_0 : vec3<i32>,
     speed_1 : vec3<f32>,
     inverse_1 : vec3<f32>,
     grid_origin_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     mirror_0 : vec3<i32>,
     t_end_0 : f32,
};

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn Walk_mirrored_plane_0( this_0 : Walk_0,  plane_0 : vec3<i32>) -> vec3<i32>
{
    return ((plane_0 ^ ((this_0.mirror_0)))) - this_0.mirror_0;
}

fn min_abs_direction_0() -> f32
{
    var _S17 : f32;
    if(IS_EXACT_0)
    {
        _S17 = 0.0f;
    }
    else
    {
        _S17 = 1.00000004581370497e-18f;
    }
    return _S17;
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

fn LocalRay_tolerance_0( this_1 : LocalRay_0,  low_0 : vec3<i32>,  high_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_1.origin_2) + (vec3<f32>(max(abs(low_0), abs(high_0))) + vec3<f32>(1.0f))) * vec3<f32>(5.36441802978515625e-07f), vec3<f32>(-1.0f), (this_1.direction_2) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_2 : LocalRay_0) -> f32
{
    return min(this_2.t_max_1 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S18 : LocalRay_0,  _S19 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_1 = _S18;
    walk_0.grid_origin_0 = cell_of_0(grids_0[_S19].origin_0);
    var is_negative_0 : vec3<bool> = (_S18.direction_2) < vec3<f32>(0.0f);
    var _S20 : vec3<i32> = vec3<i32>(i32(0));
    walk_0.mirror_0 = select(_S20, vec3<i32>(i32(-1)), is_negative_0);
    var _S21 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S21 = Walk_mirrored_plane_0(walk_0, walk_0.grid_origin_0);
    }
    else
    {
        _S21 = _S20;
    }
    walk_0.offset_0 = _S21;
    var origin_5 : vec3<f32>;
    if(IS_EXACT_0)
    {
        origin_5 = _S18.origin_2;
    }
    else
    {
        origin_5 = _S18.origin_2 - vec3<f32>(walk_0.grid_origin_0);
    }
    walk_0.origin_4 = select(origin_5, (vec3<f32>(0) - origin_5), is_negative_0);
    walk_0.speed_1 = max(abs(_S18.direction_2), vec3<f32>(min_abs_direction_0()));
    if(IS_EXACT_0)
    {
        origin_5 = abs(_S18.inverse_0);
    }
    else
    {
        origin_5 = vec3<f32>(1.0f) / walk_0.speed_1;
    }
    walk_0.inverse_1 = origin_5;
    var top_shift_1 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_1 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_1 = grids_0[_S19].top_shift_0;
    }
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S18, walk_0.grid_origin_0, walk_0.grid_origin_0 + (((cell_of_0(grids_0[_S19].top_size_0)) << (vec3<u32>(top_shift_1)))));
    walk_0.t_end_0 = LocalRay_t_end_0(_S18);
    return walk_0;
}

fn Walk_mirrored_0( this_3 : Walk_0,  voxel_3 : vec3<i32>) -> vec3<i32>
{
    return (voxel_3 ^ ((this_3.mirror_0)));
}

fn halves_0( value_0 : f32) -> vec2<f32>
{
    var high_1 : f32 = (bitcast<f32>((((bitcast<u32>((value_0))) & (u32(4294963200))))));
    return vec2<f32>(high_1, value_0 - high_1);
}

fn exact_product_0( a_1 : f32,  b_1 : f32) -> vec2<f32>
{
    var product_0 : f32 = a_1 * b_1;
    if(!IS_EXACT_0)
    {
        return vec2<f32>(product_0, 0.0f);
    }
    var a_parts_0 : vec2<f32> = halves_0(a_1);
    var b_parts_0 : vec2<f32> = halves_0(b_1);
    var _S22 : f32 = a_parts_0.x;
    var _S23 : f32 = b_parts_0.x;
    var _S24 : f32 = b_parts_0.y;
    var _S25 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S22 * _S23 - product_0 + _S22 * _S24 + _S25 * _S23 + _S25 * _S24);
}

fn exact_start_voxel_0( ray_2 : LocalRay_0) -> vec3<i32>
{
    var way_1 : vec2<f32> = exact_product_0(ray_2.t_min_1, ray_2.direction_2[u32(0)]);
    var _S26 : f32 = way_1.x;
    var sum_0 : f32 = ray_2.origin_2[u32(0)] + _S26;
    var part_0 : f32 = sum_0 - ray_2.origin_2[u32(0)];
    var low_1 : f32 = ray_2.origin_2[u32(0)] - (sum_0 - part_0) + (_S26 - part_0) + way_1.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_4 : vec3<i32>;
    var _S27 : i32 = i32(whole_0);
    var _S28 : bool;
    if(sum_0 == whole_0)
    {
        _S28 = low_1 < 0.0f;
    }
    else
    {
        _S28 = false;
    }
    voxel_4[u32(0)] = _S27 - i32(_S28);
    var way_2 : vec2<f32> = exact_product_0(ray_2.t_min_1, ray_2.direction_2[u32(1)]);
    var _S29 : f32 = way_2.x;
    var sum_1 : f32 = ray_2.origin_2[u32(1)] + _S29;
    var part_1 : f32 = sum_1 - ray_2.origin_2[u32(1)];
    var low_2 : f32 = ray_2.origin_2[u32(1)] - (sum_1 - part_1) + (_S29 - part_1) + way_2.y;
    var whole_1 : f32 = floor(sum_1);
    var _S30 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S28 = low_2 < 0.0f;
    }
    else
    {
        _S28 = false;
    }
    voxel_4[u32(1)] = _S30 - i32(_S28);
    var way_3 : vec2<f32> = exact_product_0(ray_2.t_min_1, ray_2.direction_2[u32(2)]);
    var _S31 : f32 = way_3.x;
    var sum_2 : f32 = ray_2.origin_2[u32(2)] + _S31;
    var part_2 : f32 = sum_2 - ray_2.origin_2[u32(2)];
    var low_3 : f32 = ray_2.origin_2[u32(2)] - (sum_2 - part_2) + (_S31 - part_2) + way_3.y;
    var whole_2 : f32 = floor(sum_2);
    var _S32 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S28 = low_3 < 0.0f;
    }
    else
    {
        _S28 = false;
    }
    voxel_4[u32(2)] = _S32 - i32(_S28);
    return voxel_4;
}

fn Walk_start_voxel_0( this_4 : Walk_0) -> vec3<i32>
{
    var start_0 : vec3<f32> = clamp(this_4.ray_1.origin_2 + this_4.ray_1.direction_2 * vec3<f32>(this_4.ray_1.t_min_1), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_4, vec3<i32>(floor(start_0)) - this_4.grid_origin_0);
    }
    var nearest_0 : vec3<f32> = round(start_0);
    var from_nearest_0 : vec3<f32> = start_0 - nearest_0;
    var _S33 : bool;
    if((this_4.ray_1.t_min_1) > 0.0f)
    {
        _S33 = (any(((abs(from_nearest_0)) <= (this_4.tolerance_0))));
    }
    else
    {
        _S33 = false;
    }
    if(_S33)
    {
        return Walk_mirrored_0(this_4, exact_start_voxel_0(this_4.ray_1) - this_4.grid_origin_0);
    }
    return Walk_mirrored_0(this_4, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_4.grid_origin_0);
}

fn Walk_crossings_0( this_5 : Walk_0,  planes_1 : vec3<i32>) -> vec3<f32>
{
    return (vec3<f32>(planes_1 + this_5.offset_0) - this_5.origin_4) * this_5.inverse_1;
}

struct Crossing_0
{
     distance_0 : f32,
     distance_low_0 : f32,
     speed_2 : f32,
     axis_0 : u32,
};

fn Crossing_x24init_0( distance_1 : f32,  distance_low_1 : f32,  speed_3 : f32,  axis_1 : u32) -> Crossing_0
{
    var _S34 : Crossing_0;
    _S34.distance_0 = distance_1;
    _S34.distance_low_0 = distance_low_1;
    _S34.speed_2 = speed_3;
    _S34.axis_0 = axis_1;
    return _S34;
}

fn crossing_of_0( ray_3 : LocalRay_0,  axis_2 : u32,  plane_1 : i32) -> Crossing_0
{
    var sign_0 : f32;
    if((ray_3.direction_2[axis_2]) < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var at_0 : f32 = f32(plane_1);
    var difference_0 : f32 = at_0 - ray_3.origin_2[axis_2];
    var part_3 : f32 = difference_0 - at_0;
    return Crossing_x24init_0(difference_0 * sign_0, (at_0 - (difference_0 - part_3) - (ray_3.origin_2[axis_2] + part_3)) * sign_0, abs(ray_3.direction_2[axis_2]), axis_2);
}

fn Crossing_is_before_0( this_6 : Crossing_0,  other_0 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_6.distance_0, other_0.speed_2);
    var theirs_0 : vec2<f32> = exact_product_0(other_0.distance_0, this_6.speed_2);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_6.distance_low_0 * other_0.speed_2;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_0.distance_low_0 * this_6.speed_2;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S35 : bool;
    if(difference_1 < 0.0f)
    {
        _S35 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S35 = (this_6.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S35 = false;
        }
    }
    return _S35;
}

fn leave_box_0( ray_4 : LocalRay_0,  voxel_5 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_1 : vec3<i32>) -> vec3<i32>
{
    var _S36 : vec3<f32>;
    var _S37 : f32;
    var _S38 : bool;
    var is_crossed_0 : bool;
    var first_0 : Crossing_0;
    var _S39 : f32;
    var _S40 : bool;
    var _S41 : f32;
    var _S42 : bool;
    var plane_2 : i32;
    var _S43 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S36 = ray_4.direction_2;
                _S37 = ray_4.direction_2[u32(0)];
                var _S44 : bool = (ray_4.direction_2[u32(0)]) == 0.0f;
                _S38 = _S44;
                if(_S44)
                {
                    first_0 = _S43;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_4, u32(0), exit_0[u32(0)]);
                if((_S43.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_0, _S43);
                }
                if(is_crossed_0)
                {
                    first_0 = crossing_0;
                }
                else
                {
                    first_0 = _S43;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S39 = _S36[u32(1)];
                var _S45 : bool = (_S36[u32(1)]) == 0.0f;
                _S40 = _S45;
                if(_S45)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_4, u32(1), exit_0[u32(1)]);
                if((first_0.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_1, first_0);
                }
                if(is_crossed_0)
                {
                    first_0 = crossing_1;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S41 = _S36[u32(2)];
                var _S46 : bool = (_S36[u32(2)]) == 0.0f;
                _S42 = _S46;
                if(_S46)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_4, u32(2), exit_0[u32(2)]);
                if((first_0.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_2, first_0);
                }
                if(is_crossed_0)
                {
                    first_0 = crossing_2;
                }
                break;
            }
            break;
        }
        break;
    }
    var arrival_0 : vec3<i32> = voxel_5;
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if(_S38)
                {
                    break;
                }
                var _S47 : bool = u32(0) == (first_0.axis_0);
                if(_S47)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_4, u32(0), nearest_1[u32(0)]), first_0);
                }
                if(_S47)
                {
                    plane_2 = exit_0[u32(0)];
                }
                else
                {
                    plane_2 = nearest_1[u32(0)];
                }
                arrival_0[u32(0)] = plane_2 - i32(is_crossed_0 == (_S37 < 0.0f));
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S40)
                {
                    break;
                }
                var _S48 : bool = u32(1) == (first_0.axis_0);
                if(_S48)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_4, u32(1), nearest_1[u32(1)]), first_0);
                }
                if(_S48)
                {
                    plane_2 = exit_0[u32(1)];
                }
                else
                {
                    plane_2 = nearest_1[u32(1)];
                }
                arrival_0[u32(1)] = plane_2 - i32(is_crossed_0 == (_S39 < 0.0f));
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S42)
                {
                    break;
                }
                var _S49 : bool = u32(2) == (first_0.axis_0);
                if(_S49)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_4, u32(2), nearest_1[u32(2)]), first_0);
                }
                if(_S49)
                {
                    plane_2 = exit_0[u32(2)];
                }
                else
                {
                    plane_2 = nearest_1[u32(2)];
                }
                arrival_0[u32(2)] = plane_2 - i32(is_crossed_0 == (_S41 < 0.0f));
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn Walk_arrive_0( this_7 : Walk_0,  voxel_6 : vec3<i32>,  t_2 : f32,  is_axis_0 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_0 : vec3<f32> = this_7.origin_4 + this_7.speed_1 * vec3<f32>(t_2);
    if(IS_EXACT_0)
    {
        var position_1 : vec3<f32> = clamp(position_0, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_2 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_2;
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_0, (abs(from_nearest_1)) <= (this_7.tolerance_0)))))))
        {
            return max(Walk_mirrored_0(this_7, leave_box_0(this_7.ray_1, Walk_mirrored_0(this_7, voxel_6) + this_7.grid_origin_0, Walk_mirrored_plane_0(this_7, exit_1) + this_7.grid_origin_0, Walk_mirrored_plane_0(this_7, vec3<i32>(nearest_2))) - this_7.grid_origin_0), voxel_6);
        }
        return select(vec3<i32>(nearest_2) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f)) - this_7.offset_0, exit_1, is_axis_0);
    }
    return max(vec3<i32>(floor(position_0)), select(voxel_6, exit_1, is_axis_0));
}

fn Walk_enter_rounded_0( this_8 : Walk_0,  voxel_7 : ptr<function, vec3<i32>>,  near_0 : vec3<i32>,  far_0 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_7) < near_0;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_8.speed_1) <= vec3<f32>(min_abs_direction_0()), is_before_0)))))
        {
            return false;
        }
        var t_3 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_8, near_0), is_before_0);
        var t_last_0 : f32 = max_element_0(t_3);
        if(t_last_0 > (this_8.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_3.x) == t_last_0;
        var _S50 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S50)
        {
            is_y_0 = (t_3.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S51 : bool;
        if(_S50)
        {
            _S51 = !is_y_0;
        }
        else
        {
            _S51 = false;
        }
        var is_axis_1 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S51);
        (*voxel_7) = Walk_arrive_0(this_8, (*voxel_7), t_last_0, is_axis_1, select(vec3<i32>(i32(1073741823)), near_0, is_axis_1));
    }
    return (all(((*voxel_7) < far_0)));
}

fn min_element_0( vector_2 : vec3<f32>) -> f32
{
    return min(min(vector_2.x, vector_2.y), vector_2.z);
}

fn Walk_leave_rounded_0( this_9 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_4 : vec3<f32> = Walk_crossings_0(this_9, exit_2);
    var t_first_0 : f32 = min_element_0(t_4);
    if(t_first_0 >= (this_9.t_end_0))
    {
        return false;
    }
    (*voxel_8) = max(exit_2 - vec3<i32>(ceil((t_4 - vec3<f32>(t_first_0)) * this_9.speed_1)), (*voxel_8));
    return true;
}

fn Walk_leave_0( this_10 : Walk_0,  voxel_9 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S52 : bool = Walk_leave_rounded_0(this_10, &((*voxel_9)), exit_3);
        return _S52;
    }
    var t_5 : vec3<f32> = Walk_crossings_0(this_10, exit_3);
    var t_first_1 : f32 = min_element_0(t_5);
    if(t_first_1 > (this_10.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = (t_5.x) == t_first_1;
    var _S53 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S53)
    {
        is_y_1 = (t_5.y) == t_first_1;
    }
    else
    {
        is_y_1 = false;
    }
    var back_0 : vec3<f32> = (t_5 - vec3<f32>(t_first_1)) * this_10.speed_1;
    var nearest_3 : vec3<f32> = round(back_0);
    var from_nearest_2 : vec3<f32> = back_0 - nearest_3;
    var planes_2 : vec3<i32> = exit_3 - vec3<i32>(min(nearest_3, vec3<f32>(4.194304e+06f)));
    var _S54 : vec3<i32> = planes_2 - vec3<i32>(from_nearest_2 > vec3<f32>(0.0f));
    var _S55 : vec3<bool> = (abs(from_nearest_2)) <= (this_10.tolerance_0);
    var _S56 : bool;
    if(_S53)
    {
        _S56 = !is_y_1;
    }
    else
    {
        _S56 = false;
    }
    var arrival_1 : vec3<i32>;
    if((any((select(vec3<bool>(false), !vec3<bool>(is_x_1, is_y_1, _S56), _S55)))))
    {
        arrival_1 = Walk_mirrored_0(this_10, leave_box_0(this_10.ray_1, Walk_mirrored_0(this_10, (*voxel_9)) + this_10.grid_origin_0, Walk_mirrored_plane_0(this_10, exit_3) + this_10.grid_origin_0, Walk_mirrored_plane_0(this_10, planes_2) + this_10.grid_origin_0) - this_10.grid_origin_0);
    }
    else
    {
        arrival_1 = _S54;
    }
    (*voxel_9) = select(max(arrival_1, (*voxel_9)), (*voxel_9), (this_10.speed_1) == vec3<f32>(0.0f));
    return true;
}

fn Walk_enter_0( this_11 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  low_4 : vec3<i32>,  high_2 : vec3<i32>) -> bool
{
    var _S57 : bool;
    var is_mirrored_0 : vec3<bool> = (this_11.mirror_0) != vec3<i32>(i32(0));
    var near_1 : vec3<i32> = select(low_4, (vec3<i32>(0) - high_2), is_mirrored_0);
    var far_1 : vec3<i32> = select(high_2, (vec3<i32>(0) - low_4), is_mirrored_0);
    if(!IS_EXACT_0)
    {
        var _S58 : bool = Walk_enter_rounded_0(this_11, &((*voxel_10)), near_1, far_1);
        return _S58;
    }
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
            _S57 = (any(((*voxel_10) < near_1)));
        }
        else
        {
            _S57 = false;
        }
        var _S59 : bool;
        if(_S57)
        {
            _S59 = (all(((*voxel_10) < far_1)));
        }
        else
        {
            _S59 = false;
        }
        if(_S59)
        {
        }
        else
        {
            break;
        }
        var _S60 : bool = Walk_leave_0(this_11, &((*voxel_10)), select(far_1, near_1, (*voxel_10) < near_1));
        if(!_S60)
        {
            return false;
        }
        axis_3 = axis_3 + u32(1);
    }
    if((all(((*voxel_10) >= near_1))))
    {
        _S57 = (all(((*voxel_10) < far_1)));
    }
    else
    {
        _S57 = false;
    }
    return _S57;
}

fn LocalRay_octant_0( this_12 : LocalRay_0) -> u32
{
    return (((u32((this_12.direction_2.x) < 0.0f) | (((u32((this_12.direction_2.y) < 0.0f) << (u32(1))))))) | (((u32((this_12.direction_2.z) < 0.0f) << (u32(2))))));
}

fn flip_of_0( octant_0 : u32) -> u32
{
    return ((((((octant_0 & (u32(1)))) | (((((octant_0 & (u32(2)))) << (u32(1))))))) | (((((octant_0 & (u32(4)))) << (u32(2))))))) * u32(3);
}

fn dot_cells_0( a_2 : vec3<i32>,  b_2 : vec3<i32>) -> i32
{
    return a_2.x * b_2.x + a_2.y * b_2.y + a_2.z * b_2.z;
}

fn ahead_of_0( mirror_1 : vec3<i32>) -> u32
{
    var bits_0 : vec3<u32> = (vec3<u32>(~mirror_1) & (vec3<u32>(u32(31), u32(992), u32(31744))));
    return ((((bits_0.x) | ((bits_0.y)))) | ((bits_0.z)));
}

@id(12) override HAS_PAGES_0 : bool = false;

var<private> is_page_missing_0 : bool;

fn word_in_pages_0( index_1 : u32,  first_1 : u32) -> u32
{
    var page_0 : u32 = first_1 + ((index_1 >> (u32(10))));
    var mark_0 : u32 = u32(8) + pages_0[i32(0)] + page_0;
    if(pages_0[mark_0] == u32(0))
    {
        pages_0[mark_0] = u32(1);
    }
    var slot_0 : u32 = pages_0[u32(8) + page_0];
    var _S61 : bool;
    if(is_page_missing_0)
    {
        _S61 = true;
    }
    else
    {
        _S61 = slot_0 == u32(0);
    }
    is_page_missing_0 = _S61;
    return (((slot_0 << (u32(10)))) | (((index_1 & (u32(1023))))));
}

fn place_of_cell_0( index_2 : u32) -> u32
{
    var _S62 : u32;
    if(HAS_PAGES_0)
    {
        var _S63 : u32 = word_in_pages_0(index_2, u32(0));
        _S62 = _S63;
    }
    else
    {
        _S62 = index_2;
    }
    return _S62;
}

fn cell_word_0( index_3 : u32) -> u32
{
    var _S64 : u32 = place_of_cell_0(index_3);
    return cells_0[_S64];
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

fn waits_for_pages_0() -> bool
{
    var _S65 : bool;
    if(HAS_PAGES_0)
    {
        _S65 = is_page_missing_0;
    }
    else
    {
        _S65 = false;
    }
    return _S65;
}

@id(11) override CELLS_SKIP_0 : bool = false;

fn skip_distance_0( cell_1 : u32,  octant_1 : u32) -> u32
{
    var code_0 : u32 = (((cell_1 >> ((u32(3) * octant_1)))) & (u32(7)));
    var _S66 : u32;
    if(code_0 < u32(2))
    {
        _S66 = code_0 + u32(1);
    }
    else
    {
        _S66 = ((u32(3) + ((code_0 & (u32(1))))) << ((((code_0 >> (u32(1)))) - u32(1))));
    }
    return _S66;
}

fn extents_0( cell_2 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_2 & (ahead_0))) | (((((cell_2 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_3 : u32) -> u32
{
    var _S67 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S67 = u32(8388607);
    }
    else
    {
        _S67 = u32(2147483647);
    }
    return ((cell_3 & (_S67))) * u32(2);
}

fn blocks_of_cell_0( cell_4 : u32) -> u32
{
    return (((cell_4 >> (u32(23)))) & (u32(255)));
}

fn place_of_brick_0( index_4 : u32) -> u32
{
    var _S68 : u32;
    if(HAS_PAGES_0)
    {
        var _S69 : u32 = word_in_pages_0(index_4, pages_0[i32(1)]);
        _S68 = _S69;
    }
    else
    {
        _S68 = index_4;
    }
    return _S68;
}

fn brick_word_0( index_5 : u32) -> u32
{
    var _S70 : u32 = place_of_brick_0(index_5);
    return bricks_0[_S70];
}

fn blocks_of_record_0( record_0 : u32) -> u32
{
    var _S71 : u32 = brick_word_0(record_0);
    return (_S71 & (u32(255)));
}

fn empty_around_0( record_1 : u32,  blocks_0 : u32,  voxel_11 : vec3<i32>,  octant_2 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_11.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_11.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_11.z) & (i32(4))))))) ^ (octant_2));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_0 : u32 = ((cell_in_node_0(voxel_11, u32(0))) ^ (flip_0));
    var half_0 : u32 = brick_word_0(record_1 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_0 >> (u32(5)))));
    if(((((half_0 >> (((bit_0 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S72 : i32;
    if(((((half_0 >> (((bit_0 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S72 = i32(1);
    }
    else
    {
        _S72 = i32(0);
    }
    return u32(_S72);
}

fn Walk_leave_1( this_13 : Walk_0,  voxel_12 : ptr<function, vec3<i32>>,  exit_4 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S73 : bool = Walk_leave_rounded_0(this_13, &((*voxel_12)), exit_4);
        return _S73;
    }
    var t_6 : vec3<f32> = Walk_crossings_0(this_13, exit_4);
    var t_first_2 : f32 = min_element_0(t_6);
    if(t_first_2 > (this_13.t_end_0))
    {
        return false;
    }
    var is_x_2 : bool = (t_6.x) == t_first_2;
    var _S74 : bool = !is_x_2;
    var is_y_2 : bool;
    if(_S74)
    {
        is_y_2 = (t_6.y) == t_first_2;
    }
    else
    {
        is_y_2 = false;
    }
    var back_1 : vec3<f32> = (t_6 - vec3<f32>(t_first_2)) * this_13.speed_1;
    var nearest_4 : vec3<f32> = round(back_1);
    var from_nearest_3 : vec3<f32> = back_1 - nearest_4;
    var planes_3 : vec3<i32> = exit_4 - vec3<i32>(min(nearest_4, vec3<f32>(4.194304e+06f)));
    var _S75 : vec3<i32> = planes_3 - vec3<i32>(from_nearest_3 > vec3<f32>(0.0f));
    var _S76 : vec3<bool> = (abs(from_nearest_3)) <= (this_13.tolerance_0);
    var _S77 : bool;
    if(_S74)
    {
        _S77 = !is_y_2;
    }
    else
    {
        _S77 = false;
    }
    var arrival_2 : vec3<i32>;
    if((any((select(vec3<bool>(false), !vec3<bool>(is_x_2, is_y_2, _S77), _S76)))))
    {
        arrival_2 = Walk_mirrored_0(this_13, leave_box_0(this_13.ray_1, Walk_mirrored_0(this_13, (*voxel_12)) + this_13.grid_origin_0, Walk_mirrored_plane_0(this_13, exit_4) + this_13.grid_origin_0, Walk_mirrored_plane_0(this_13, planes_3) + this_13.grid_origin_0) - this_13.grid_origin_0);
    }
    else
    {
        arrival_2 = _S75;
    }
    (*voxel_12) = select(max(arrival_2, (*voxel_12)), (*voxel_12), (this_13.speed_1) == vec3<f32>(0.0f));
    return true;
}

fn first_voxel_0( _S78 : u32,  _S79 : Walk_0,  _S80 : ptr<function, vec3<i32>>) -> bool
{
    var _S81 : Walk_0 = _S79;
    var _S82 : vec3<i32> = vec3<i32>(i32(0));
    (*_S80) = _S82;
    var voxel_13 : vec3<i32> = Walk_start_voxel_0(_S79);
    var _S83 : bool = Walk_enter_0(_S79, &(voxel_13), cell_of_0(grids_0[_S78].min_1) - _S81.grid_origin_0, cell_of_0(grids_0[_S78].max_1) - _S81.grid_origin_0);
    if(!_S83)
    {
        return false;
    }
    var octant_3 : u32 = LocalRay_octant_0(_S81.ray_1);
    var _S84 : u32 = flip_of_0(octant_3);
    var top_shift_2 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_2 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_2 = grids_0[_S78].top_shift_0;
    }
    var top_size_1 : vec3<i32> = cell_of_0(grids_0[_S78].top_size_0);
    var _S85 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S85, _S85 * top_size_1.y);
    var _S86 : i32 = i32(grids_0[_S78].top_offset_0) - dot_cells_0((stride_0 & ((_S81.mirror_0))), vec3<i32>(i32(1)));
    var _S87 : vec3<i32> = Walk_mirrored_plane_0(_S81, stride_0);
    var _S88 : u32 = ahead_of_0(_S81.mirror_0);
    var end_0 : vec3<i32> = select((top_size_1 << (vec3<u32>(top_shift_2))), _S82, (_S81.mirror_0) != _S82);
    if(!IS_EXACT_0)
    {
        _S81.t_end_0 = min(_S81.t_end_0, min_element_0(Walk_crossings_0(_S81, end_0)));
    }
    var is_found_0 : bool = false;
    for(;;)
    {
        var _S89 : bool;
        if(IS_EXACT_0)
        {
            _S89 = (any((voxel_13 >= end_0)));
        }
        else
        {
            _S89 = false;
        }
        if(_S89)
        {
            break;
        }
        var cell_5 : u32 = cell_word_0(u32(_S86 + dot_cells_0(_S87, (voxel_13 >> (vec3<u32>(top_shift_2))))));
        var cell_6 : u32;
        var shift_1 : u32;
        var is_found_1 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_5 & (u32(2147483648)))) != u32(0))
            {
                var _S90 : u32 = cell_word_0(((cell_5 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_13, u32(3))) ^ (_S84))));
                cell_6 = _S90;
                shift_1 = u32(3);
            }
            else
            {
                cell_6 = cell_5;
                shift_1 = top_shift_2;
            }
        }
        else
        {
            cell_6 = cell_5;
            shift_1 = top_shift_2;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_1 = shift_1 > u32(3);
                }
                else
                {
                    is_found_1 = false;
                }
                var _S91 : bool;
                if(is_found_1)
                {
                    _S91 = ((cell_6 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S91 = false;
                }
                if(_S91)
                {
                }
                else
                {
                    break;
                }
                var shift_2 : u32 = shift_1 - u32(2);
                var _S92 : u32 = cell_word_0(((cell_6 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_13, shift_2)) ^ (_S84))));
                cell_6 = _S92;
                shift_1 = shift_2;
            }
        }
        if(waits_for_pages_0())
        {
            break;
        }
        var exit_5 : vec3<i32>;
        if(((cell_6 & (u32(2147483648)))) == u32(0))
        {
            if(CELLS_SKIP_0)
            {
                exit_5 = vec3<i32>((i32(skip_distance_0(cell_6, octant_3)) - i32(1)));
            }
            else
            {
                exit_5 = extents_0(cell_6, _S88);
            }
            exit_5 = ((voxel_13 | (vec3<i32>((((i32(1) << (shift_1))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_5 << (vec3<u32>(shift_1))));
            is_found_1 = is_found_0;
        }
        else
        {
            var record_2 : u32 = record_of_cell_0(cell_6);
            var blocks_1 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_1 = blocks_of_cell_0(cell_6);
            }
            else
            {
                var _S93 : u32 = blocks_of_record_0(record_2);
                blocks_1 = _S93;
            }
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_13, octant_3, _S84);
            var is_found_2 : bool = low_bits_0 == u32(4294967295);
            if(is_found_2)
            {
                is_found_0 = is_found_2;
                break;
            }
            exit_5 = ((voxel_13 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_1 = is_found_2;
        }
        var _S94 : bool = Walk_leave_1(_S81, &(voxel_13), exit_5);
        if(!_S94)
        {
            is_found_0 = is_found_1;
            break;
        }
        is_found_0 = is_found_1;
    }
    (*_S80) = Walk_mirrored_0(_S81, voxel_13) + _S81.grid_origin_0;
    return is_found_0;
}

fn Ray_x24init_0( origin_6 : vec3<f32>,  t_min_2 : f32,  direction_4 : vec3<f32>,  t_max_2 : f32) -> Ray_0
{
    var _S95 : Ray_0;
    _S95.origin_1 = origin_6;
    _S95.t_min_0 = t_min_2;
    _S95.direction_0 = direction_4;
    _S95.t_max_0 = t_max_2;
    return _S95;
}

fn ray_of_walk_0( walk_1 : Walk_0,  ray_5 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (walk_1.mirror_0) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_1.origin_4, (vec3<f32>(0) - walk_1.origin_4), is_mirrored_1) + vec3<f32>(walk_1.grid_origin_0), ray_5.t_min_0, select(walk_1.speed_1, (vec3<f32>(0) - walk_1.speed_1), is_mirrored_1), ray_5.t_max_0);
}

fn hit_of_0( ray_6 : LocalRay_0,  voxel_14 : vec3<i32>,  instance_5 : u32) -> Hit_0
{
    var _S96 : vec3<f32>;
    var _S97 : bool;
    var last_0 : Crossing_0;
    var _S98 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S96 = ray_6.direction_2;
                if((ray_6.direction_2[u32(0)]) == 0.0f)
                {
                    last_0 = _S98;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_6, u32(0), voxel_14[u32(0)] + i32((ray_6.direction_2[u32(0)]) < 0.0f));
                if((_S98.axis_0) == u32(3))
                {
                    _S97 = true;
                }
                else
                {
                    _S97 = !Crossing_is_before_0(crossing_3, _S98);
                }
                if(_S97)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S98;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S99 : vec3<f32> = _S96;
                if((_S96[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_6, u32(1), voxel_14[u32(1)] + i32((_S99[u32(1)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S97 = true;
                }
                else
                {
                    _S97 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S97)
                {
                    last_0 = crossing_4;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S100 : vec3<f32> = _S96;
                if((_S96[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_6, u32(2), voxel_14[u32(2)] + i32((_S100[u32(2)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S97 = true;
                }
                else
                {
                    _S97 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S97)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S101 : Crossing_0 = last_0;
    var is_negative_1 : bool = (_S96[last_0.axis_0]) < 0.0f;
    var t_7 : f32 = (f32(voxel_14[last_0.axis_0] + i32(is_negative_1)) - ray_6.origin_2[last_0.axis_0]) * ray_6.inverse_0[last_0.axis_0];
    var _S102 : f32;
    if(t_7 > (ray_6.t_min_1))
    {
        _S102 = t_7;
    }
    else
    {
        _S102 = ray_6.t_min_1;
    }
    return Hit_x24init_0(_S102, instance_5, voxel_14, u32(2) * _S101.axis_0 + u32(is_negative_1));
}

fn hit_of_walk_0( walk_2 : Walk_0,  voxel_15 : vec3<i32>,  instance_6 : u32) -> Hit_0
{
    var t_8 : vec3<f32> = Walk_crossings_0(walk_2, Walk_mirrored_0(walk_2, voxel_15 - walk_2.grid_origin_0));
    var last_1 : f32 = max_element_0(t_8);
    var _S103 : i32;
    if((t_8.z) == last_1)
    {
        _S103 = i32(2);
    }
    else
    {
        if((t_8.y) == last_1)
        {
            _S103 = i32(1);
        }
        else
        {
            _S103 = i32(0);
        }
    }
    var axis_4 : u32 = u32(_S103);
    return Hit_x24init_0(max(last_1, walk_2.ray_1.t_min_1), instance_6, voxel_15, u32(2) * axis_4 + u32((walk_2.mirror_0[axis_4]) != i32(0)));
}

fn hit_in_0( instance_7 : u32,  ray_7 : ptr<function, Ray_0>) -> Hit_0
{
    var _S104 : LocalRay_0 = local_ray_0((*ray_7), instance_7);
    if(!_S104.is_valid_0)
    {
        return miss_0();
    }
    var _S105 : Walk_0 = walk_of_0(_S104, instances_0[instance_7].grid_0);
    var voxel_16 : vec3<i32>;
    var _S106 : bool = first_voxel_0(instances_0[instance_7].grid_0, _S105, &(voxel_16));
    var _S107 : bool;
    if(IS_SINGLE_0)
    {
        _S107 = !IS_EXACT_0;
    }
    else
    {
        _S107 = false;
    }
    if(_S107)
    {
        (*ray_7) = ray_of_walk_0(_S105, (*ray_7));
    }
    if(!_S106)
    {
        return miss_0();
    }
    var hit_0 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_0 = hit_of_0(_S104, voxel_16, instance_7);
    }
    else
    {
        hit_0 = hit_of_walk_0(_S105, voxel_16, instance_7);
    }
    if((hit_0.t_0) > ((*ray_7).t_max_0))
    {
        return miss_0();
    }
    return hit_0;
}

fn entry_0( _S108 : u32,  _S109 : Ray_0,  _S110 : vec3<f32>) -> f32
{
    var low_5 : vec3<f32> = (vector_of_0(instance_nodes_0[_S108].min_0) - _S109.origin_1) * _S110;
    var high_3 : vec3<f32> = (vector_of_0(instance_nodes_0[_S108].max_0) - _S109.origin_1) * _S110;
    var _S111 : f32 = max(_S109.t_min_0, max_element_0(min(low_5, high_3)));
    var _S112 : f32;
    if(_S111 <= (min(_S109.t_max_0, min_element_0(max(low_5, high_3)))))
    {
        _S112 = _S111;
    }
    else
    {
        _S112 = (bitcast<f32>((u32(2139095040))));
    }
    return _S112;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool,  end_1 : u32) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S113 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S113;
    }
    var ray_8 : Ray_0 = (*given_0);
    var nearest_5 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_5;
    }
    var is_zero_1 : vec3<bool> = !((abs(ray_8.direction_0)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S114 : vec3<f32> = select(reciprocal_0(select(ray_8.direction_0, vec3<f32>(1.0f), is_zero_1)), vec3<f32>(3.4028234663852886e+38f), is_zero_1);
    var stack_0 : array<u32, i32(32)>;
    var index_6 : u32 = u32(0);
    var nearest_6 : Hit_0 = nearest_5;
    var depth_0 : u32 = u32(0);
    for(;;)
    {
        var depth_1 : u32;
        var is_reached_0 : bool;
        if((instance_nodes_0[index_6].is_leaf_0) != u32(0))
        {
            var _S115 : Hit_0 = hit_in_0(instance_nodes_0[index_6].index_0, &(ray_8));
            var _S116 : Hit_0 = nearest_6;
            if((_S115.t_0) < (nearest_6.t_0))
            {
                is_reached_0 = true;
            }
            else
            {
                if((_S115.t_0) == (_S116.t_0))
                {
                    is_reached_0 = (_S115.instance_3) < (nearest_6.instance_3);
                }
                else
                {
                    is_reached_0 = false;
                }
            }
            var nearest_7 : Hit_0;
            if(is_reached_0)
            {
                ray_8.t_max_0 = _S115.t_0;
                if(is_any_enough_0)
                {
                    return _S115;
                }
                nearest_7 = _S115;
            }
            else
            {
                nearest_7 = nearest_6;
            }
            nearest_6 = nearest_7;
            depth_1 = depth_0;
        }
        else
        {
            var _S117 : u32 = index_6 + u32(1);
            var _S118 : f32 = entry_0(_S117, ray_8, _S114);
            var _S119 : u32 = instance_nodes_0[index_6].index_0;
            var _S120 : f32 = entry_0(instance_nodes_0[index_6].index_0, ray_8, _S114);
            var _S121 : bool = _S118 <= _S120;
            if(_S121)
            {
                index_6 = _S117;
            }
            else
            {
                index_6 = _S119;
            }
            var far_2 : u32;
            if(_S121)
            {
                far_2 = _S119;
            }
            else
            {
                far_2 = _S117;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S118, _S120)) < INFINITY_0)
            {
                var _S122 : u32 = depth_0 + u32(1);
                stack_0[depth_0] = far_2;
                depth_1 = _S122;
            }
            else
            {
                depth_1 = depth_0;
            }
            if((min(_S118, _S120)) < INFINITY_0)
            {
                depth_0 = depth_1;
                continue;
            }
        }
        is_reached_0 = false;
        depth_0 = depth_1;
        for(;;)
        {
            var _S123 : bool;
            if(depth_0 > u32(0))
            {
                _S123 = !is_reached_0;
            }
            else
            {
                _S123 = false;
            }
            if(_S123)
            {
            }
            else
            {
                break;
            }
            var depth_2 : u32 = depth_0 - u32(1);
            is_reached_0 = (entry_0(stack_0[depth_2], ray_8, _S114)) < (bitcast<f32>((u32(2139095040))));
            index_6 = stack_0[depth_2];
            depth_0 = depth_2;
        }
        if(!is_reached_0)
        {
            break;
        }
    }
    return nearest_6;
}

fn WalkTracer_trace_0( ray_9 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    var _S124 : Hit_0 = visit_0(&((*ray_9)), is_any_enough_1, u32(0));
    return _S124;
}

fn hit_of_ray_0( sampler_1 : Sampler_0,  ray_10 : ptr<function, Ray_0>,  is_shadow_ray_1 : bool,  path_1 : ptr<function, Path_0>,  shadow_inside_1 : ptr<function, Inside_0>,  relocates_1 : ptr<function, bool>,  path_relocates_1 : ptr<function, bool>,  beyond_0 : ptr<function, u32>) -> Hit_0
{
    (*beyond_0) = u32(4294967295);
    var _S125 : Hit_0 = WalkTracer_trace_0(&((*ray_10)), is_shadow_ray_1);
    return _S125;
}

fn Hit_is_miss_0( this_14 : Hit_0) -> bool
{
    return (this_14.instance_3) == u32(4294967295);
}

fn ray_from_0( origin_7 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_7, 0.0f, direction_5, (bitcast<f32>((u32(2139095040)))));
}

struct NextRays_0
{
     origin_8 : vec3<f32>,
     path_origin_1 : vec3<f32>,
     shadow_inside_2 : Inside_0,
     relocates_2 : bool,
     path_relocates_2 : bool,
     direction_6 : vec3<f32>,
     has_shadow_ray_0 : bool,
     shadow_direction_0 : vec3<f32>,
     shadow_t_max_0 : f32,
     light_3 : vec3<f32>,
     is_same_0 : bool,
};

fn Inside_x24init_0( instance_8 : u32,  voxel_17 : vec3<i32>,  material_1 : u32) -> Inside_0
{
    var _S126 : Inside_0;
    _S126.instance_1 = instance_8;
    _S126.voxel_0 = voxel_17;
    _S126.material_0 = material_1;
    return _S126;
}

fn in_air_0() -> Inside_0
{
    return Inside_x24init_0(u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn NextRays_x24init_0( origin_9 : vec3<f32>,  path_origin_2 : vec3<f32>,  shadow_inside_3 : Inside_0,  relocates_3 : bool,  path_relocates_3 : bool,  direction_7 : vec3<f32>,  has_shadow_ray_1 : bool,  shadow_direction_1 : vec3<f32>,  shadow_t_max_1 : f32,  light_4 : vec3<f32>,  is_same_1 : bool) -> NextRays_0
{
    var _S127 : NextRays_0;
    _S127.origin_8 = origin_9;
    _S127.path_origin_1 = path_origin_2;
    _S127.shadow_inside_2 = shadow_inside_3;
    _S127.relocates_2 = relocates_3;
    _S127.path_relocates_2 = path_relocates_3;
    _S127.direction_6 = direction_7;
    _S127.has_shadow_ray_0 = has_shadow_ray_1;
    _S127.shadow_direction_0 = shadow_direction_1;
    _S127.shadow_t_max_0 = shadow_t_max_1;
    _S127.light_3 = light_4;
    _S127.is_same_0 = is_same_1;
    return _S127;
}

fn no_rays_0() -> NextRays_0
{
    var _S128 : vec3<f32> = vec3<f32>(0.0f);
    return NextRays_x24init_0(_S128, _S128, in_air_0(), false, false, _S128, false, _S128, 0.0f, _S128, false);
}

fn weighs_apart_0() -> bool
{
    return false;
}

fn Path_is_counted_0( this_15 : Path_0) -> bool
{
    var _S129 : bool;
    if(weighs_apart_0())
    {
        _S129 = (this_15.pdf_1) < 0.0f;
    }
    else
    {
        _S129 = false;
    }
    return _S129;
}

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_3 : vec3<f32>,
};

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_4 : vec3<f32>) -> Receiver_0
{
    var _S130 : Receiver_0;
    _S130.point_0 = point_1;
    _S130.normal_3 = normal_4;
    return _S130;
}

fn Path_receiver_0( this_16 : Path_0,  ray_11 : Ray_0) -> Receiver_0
{
    return Receiver_x24init_0(ray_11.origin_1, this_16.normal_1);
}

fn Inside_is_in_0( this_17 : Inside_0) -> bool
{
    return false;
}

fn Path_dimension_medium_0( this_18 : Path_0) -> u32
{
    return u32(2147483648) + this_18.event_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S131 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S131;
    v_0[i32(0)] = v_0[i32(0)] + _S131.y * _S131.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S132 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S132;
    v_0[i32(0)] = v_0[i32(0)] + _S132.y * _S132.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn unit_float_0( words_1 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_1 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_independent_0( this_19 : Sampler_0,  dimension_0 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_19.pixel_0, this_19.sample_0, dimension_0, this_19.seed_1)));
}

struct PackedMaterial_0
{
     base_color_0 : array<f32, i32(3)>,
     roughness_0 : f32,
     emission_0 : array<f32, i32(3)>,
     metallic_0 : f32,
     transmission_0 : f32,
     ior_0 : f32,
     specular_0 : f32,
     anisotropy_0 : f32,
     absorption_0 : array<f32, i32(3)>,
     scattering_0 : f32,
};

fn material_of_index_0( index_7 : u32) -> PackedMaterial_0
{
    var _S133 : u32 = u32(4) * index_7;
    var a_3 : vec4<u32> = material_rows_0[_S133];
    var b_3 : vec4<u32> = material_rows_0[_S133 + u32(1)];
    var c_0 : vec4<u32> = material_rows_0[_S133 + u32(2)];
    var d_0 : vec4<u32> = material_rows_0[_S133 + u32(3)];
    var material_2 : PackedMaterial_0;
    var _S134 : f32 = (bitcast<f32>((a_3.y)));
    var _S135 : f32 = (bitcast<f32>((a_3.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((a_3.x)));
    material_2.base_color_0[i32(1)] = _S134;
    material_2.base_color_0[i32(2)] = _S135;
    var _S136 : f32 = (bitcast<f32>((b_3.y)));
    var _S137 : f32 = (bitcast<f32>((b_3.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((b_3.x)));
    material_2.emission_0[i32(1)] = _S136;
    material_2.emission_0[i32(2)] = _S137;
    var _S138 : f32 = (bitcast<f32>((d_0.y)));
    var _S139 : f32 = (bitcast<f32>((d_0.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((d_0.x)));
    material_2.absorption_0[i32(1)] = _S138;
    material_2.absorption_0[i32(2)] = _S139;
    material_2.roughness_0 = (bitcast<f32>((a_3.w)));
    material_2.metallic_0 = (bitcast<f32>((b_3.w)));
    material_2.transmission_0 = (bitcast<f32>((c_0.x)));
    material_2.ior_0 = (bitcast<f32>((c_0.y)));
    material_2.specular_0 = (bitcast<f32>((c_0.z)));
    material_2.anisotropy_0 = (bitcast<f32>((c_0.w)));
    material_2.scattering_0 = (bitcast<f32>((d_0.w)));
    return material_2;
}

fn logarithm_0( x_0 : f32) -> f32
{
    var bits_1 : u32 = (bitcast<u32>((x_0)));
    var _S140 : u32 = (bits_1 & (u32(8388607)));
    var is_upper_0 : bool = _S140 > u32(3474675);
    var power_0 : i32 = i32((bits_1 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S141 : u32;
    if(is_upper_0)
    {
        _S141 = u32(1056964608);
    }
    else
    {
        _S141 = u32(1065353216);
    }
    var mantissa_0 : f32 = (bitcast<f32>(((_S140 | (_S141)))));
    var s_0 : f32 = divide_0(mantissa_0 - 1.0f, mantissa_0 + 1.0f);
    var ss_0 : f32 = s_0 * s_0;
    var _S142 : f32 = f32(power_0);
    return _S142 * 0.693359375f + (_S142 * -0.00021219444170129f + s_0 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_0 : PackedMaterial_0,  u_0 : f32) -> f32
{
    var _S143 : f32;
    if((medium_0.scattering_0) > 0.0f)
    {
        _S143 = divide_0(- logarithm_0(1.0f - u_0), medium_0.scattering_0);
    }
    else
    {
        _S143 = (bitcast<f32>((u32(2139095040))));
    }
    return _S143;
}

fn grid_direction_0( instance_9 : u32,  direction_8 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(instance_9, direction_8);
}

fn dot_product_0( a_4 : vec3<f32>,  b_4 : vec3<f32>) -> f32
{
    return a_4.x * b_4.x + a_4.y * b_4.y + a_4.z * b_4.z;
}

fn length_squared_0( vector_3 : vec3<f32>) -> f32
{
    return dot_product_0(vector_3, vector_3);
}

fn nearest_root_0( mantissa_1 : u32,  guess_1 : u32) -> u32
{
    var rest_1 : i32 = i32(((mantissa_1 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_1) / f32(u32(2) * guess_1) + 0.5f));
    var _S144 : i32 = i32(guess_1);
    var root_0 : i32 = _S144 + units_1;
    var rest_2 : i32 = rest_1 - units_1 * (_S144 + root_0);
    return u32(root_0 + i32(rest_2 > root_0) - i32(rest_2 <= (- root_0)));
}

fn square_root_0( value_1 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_1);
    }
    var _S145 : u32 = (bitcast<u32>((value_1)));
    var exponent_2 : u32 = (_S145 >> (u32(23)));
    if(!is_normal_0(exponent_2))
    {
        return sqrt(value_1);
    }
    var mantissa_2 : u32 = (((((_S145 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_2) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_2, u32(sqrt(f32(mantissa_2) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn Inside_voxels_per_t_0( this_20 : Inside_0,  ray_12 : Ray_0) -> f32
{
    return square_root_0(length_squared_0(grid_direction_0(this_20.instance_1, ray_12.direction_0)));
}

fn scattering_t_0( path_2 : Path_0,  inside_1 : Inside_0,  ray_13 : Ray_0) -> f32
{
    return divide_0(free_path_0(material_of_index_0(inside_1.material_0), Sampler_independent_0(path_2.sampler_0, Path_dimension_medium_0(path_2)).x), Inside_voxels_per_t_0(inside_1, ray_13));
}

fn exponential_0( x_1 : f32) -> f32
{
    if(x_1 < -87.0f)
    {
        return 0.0f;
    }
    var power_1 : i32 = i32(x_1 * 1.4426950216293335f - 0.5f);
    var k_0 : f32 = f32(power_1);
    var r_0 : f32 = x_1 - k_0 * 0.693359375f - k_0 * -0.00021219444170129f;
    return (1.0f + r_0 * (1.0f + r_0 * (0.5f + r_0 * (0.1666666716337204f + r_0 * (0.0416666679084301f + r_0 * (0.00833333376795053f + r_0 * (0.00138888892251998f + r_0 * 0.0001984127011383f))))))) * (bitcast<f32>(((u32(i32(127) + power_1) << (u32(23))))));
}

fn attenuation_0( medium_1 : PackedMaterial_0,  voxels_1 : f32) -> vec3<f32>
{
    var sigma_0 : vec3<f32> = vector_of_0(medium_1.absorption_0);
    return vec3<f32>(exponential_0(- (sigma_0.x * voxels_1)), exponential_0(- (sigma_0.y * voxels_1)), exponential_0(- (sigma_0.z * voxels_1)));
}

fn absorb_0( path_3 : ptr<function, Path_0>,  inside_2 : Inside_0,  ray_14 : Ray_0,  t_9 : f32)
{
    (*path_3).beta_0 = (*path_3).beta_0 * attenuation_0(material_of_index_0(inside_2.material_0), t_9 * Inside_voxels_per_t_0(inside_2, ray_14));
    return;
}

fn Environment_to_map_0( d_1 : vec3<f32>) -> vec3<f32>
{
    var sin_0 : f32 = params_0.sky_turned_0.x;
    var cos_0 : f32 = params_0.sky_turned_0.y;
    var _S146 : f32 = d_1.x;
    var _S147 : f32 = d_1.y;
    return vec3<f32>(_S146 * cos_0 - _S147 * sin_0, _S146 * sin_0 + _S147 * cos_0, d_1.z);
}

fn quarter_turns_0( x_2 : f32,  y_0 : f32) -> f32
{
    var _S148 : f32 = min(x_2, y_0);
    var _S149 : f32 = max(x_2, y_0);
    var ratio_0 : f32;
    if(_S149 > 0.0f)
    {
        ratio_0 = divide_0(_S148, _S149);
    }
    else
    {
        ratio_0 = 0.0f;
    }
    var s_1 : f32 = ratio_0 * ratio_0;
    var turns_0 : f32 = ratio_0 * (0.63661932945251465f + s_1 * (-0.21218447387218475f + s_1 * (0.12698377668857574f + s_1 * (-0.08854507654905319f + s_1 * (0.06138415634632111f + s_1 * (-0.03559486567974091f + s_1 * (0.01391837373375893f + s_1 * -0.00258121290244162f)))))));
    if(y_0 > x_2)
    {
        ratio_0 = 1.0f - turns_0;
    }
    else
    {
        ratio_0 = turns_0;
    }
    return ratio_0;
}

fn square_of_0( direction_9 : vec3<f32>) -> vec2<f32>
{
    var size_0 : vec3<f32> = abs(direction_9);
    var _S150 : f32 = size_0.x;
    var _S151 : f32 = size_0.y;
    var radius_0 : f32 = square_root_0(divide_0(_S150 * _S150 + _S151 * _S151, 1.0f + size_0.z));
    var v_1 : f32 = quarter_turns_0(_S150, _S151) * radius_0;
    var u_1 : f32 = radius_0 - v_1;
    var is_below_1 : bool = (direction_9.z) < 0.0f;
    var u_2 : f32;
    if(is_below_1)
    {
        u_2 = 1.0f - v_1;
    }
    else
    {
        u_2 = u_1;
    }
    var v_2 : f32;
    if(is_below_1)
    {
        v_2 = 1.0f - u_1;
    }
    else
    {
        v_2 = v_1;
    }
    if((direction_9.x) < 0.0f)
    {
        u_2 = - u_2;
    }
    if((direction_9.y) < 0.0f)
    {
        v_2 = - v_2;
    }
    return vec2<f32>(u_2 * 0.5f + 0.5f, v_2 * 0.5f + 0.5f);
}

fn Environment_place_of_0( direction_10 : vec3<f32>) -> vec2<f32>
{
    return square_of_0(Environment_to_map_0(direction_10)) * vec2<f32>(f32(params_0.sky_edge_0));
}

fn Environment_index_of_0( x_3 : i32,  y_1 : i32) -> u32
{
    var last_2 : i32 = i32(params_0.sky_edge_0) - i32(1);
    var is_beside_0 : bool;
    if(x_3 < i32(0))
    {
        is_beside_0 = true;
    }
    else
    {
        is_beside_0 = x_3 > last_2;
    }
    var _S152 : i32;
    if(is_beside_0)
    {
        _S152 = last_2 - y_1;
    }
    else
    {
        _S152 = y_1;
    }
    var _S153 : i32;
    if(is_beside_0)
    {
        _S153 = clamp(x_3, i32(0), last_2);
    }
    else
    {
        _S153 = x_3;
    }
    var is_beyond_0 : bool;
    if(_S152 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S152 > last_2;
    }
    if(is_beyond_0)
    {
        _S153 = last_2 - _S153;
    }
    if(is_beyond_0)
    {
        _S152 = clamp(_S152, i32(0), last_2);
    }
    return u32(_S152 * i32(params_0.sky_edge_0) + _S153);
}

fn Environment_texel_radiance_0( x_4 : i32,  y_2 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_4, y_2)].radiance_0);
}

fn Environment_radiance_at_0( place_2 : vec2<f32>) -> vec3<f32>
{
    var _S154 : vec2<f32> = place_2 - vec2<f32>(0.5f);
    var corner_1 : vec2<f32> = floor(_S154);
    var beyond_1 : vec2<f32> = _S154 - corner_1;
    var x_5 : i32 = i32(corner_1.x);
    var y_3 : i32 = i32(corner_1.y);
    var _S155 : f32 = beyond_1.x;
    var _S156 : vec3<f32> = vec3<f32>((1.0f - _S155));
    var _S157 : i32 = x_5 + i32(1);
    var _S158 : vec3<f32> = vec3<f32>(_S155);
    var _S159 : i32 = y_3 + i32(1);
    var _S160 : f32 = beyond_1.y;
    return (Environment_texel_radiance_0(x_5, y_3) * _S156 + Environment_texel_radiance_0(_S157, y_3) * _S158) * vec3<f32>((1.0f - _S160)) + (Environment_texel_radiance_0(x_5, _S159) * _S156 + Environment_texel_radiance_0(_S157, _S159) * _S158) * vec3<f32>(_S160);
}

fn Environment_radiance_0( direction_11 : vec3<f32>) -> vec3<f32>
{
    return Environment_radiance_at_0(Environment_place_of_0(direction_11));
}

struct Gradient_0
{
     nadir_0 : vec3<f32>,
     zenith_0 : vec3<f32>,
};

fn Gradient_x24init_0( nadir_1 : vec3<f32>,  zenith_1 : vec3<f32>) -> Gradient_0
{
    var _S161 : Gradient_0;
    _S161.nadir_0 = nadir_1;
    _S161.zenith_0 = zenith_1;
    return _S161;
}

fn Gradient_radiance_0( this_21 : Gradient_0,  direction_12 : vec3<f32>) -> vec3<f32>
{
    return this_21.nadir_0 + (this_21.zenith_0 - this_21.nadir_0) * vec3<f32>((0.5f * (direction_12.z + 1.0f)));
}

fn Sky_radiance_0( direction_13 : vec3<f32>) -> vec3<f32>
{
    if(SKY_0 == u32(1))
    {
        return Environment_radiance_0(direction_13) * vec3<f32>(params_0.sky_brightness_0);
    }
    return Gradient_radiance_0(Gradient_x24init_0(params_0.sky_nadir_0, params_0.sky_zenith_0), direction_13) * vec3<f32>(params_0.sky_brightness_0);
}

fn Sky_le_0( direction_14 : vec3<f32>) -> vec3<f32>
{
    return Sky_radiance_0(direction_14);
}

fn Path_selection_at_0( this_22 : Path_0,  last_3 : Receiver_0) -> Selection_0
{
    return this_22.selection_0;
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S162 : bool;
    if(SKY_0 == u32(1))
    {
        _S162 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S162 = false;
    }
    return _S162;
}

fn Environment_pdf_0( direction_15 : vec3<f32>) -> f32
{
    var place_3 : vec2<f32> = Environment_place_of_0(direction_15);
    var last_4 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_3.x), last_4), min(i32(place_3.y), last_4))].pdf_0;
}

fn Sky_pdf_0( direction_16 : vec3<f32>) -> f32
{
    var _S163 : f32;
    if(SKY_0 == u32(1))
    {
        _S163 = Environment_pdf_0(direction_16);
    }
    else
    {
        _S163 = 0.0f;
    }
    return _S163;
}

fn Lights_sky_pdf_0( selection_1 : Selection_0,  direction_17 : vec3<f32>) -> f32
{
    var _S164 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S164 = Sky_pdf_0(direction_17) * selection_1.sky_1;
    }
    else
    {
        _S164 = 0.0f;
    }
    return _S164;
}

fn power_heuristic_0( own_0 : f32,  other_1 : f32) -> f32
{
    var ratio_1 : f32 = divide_0(other_1, own_0);
    return divide_0(1.0f, 1.0f + ratio_1 * ratio_1);
}

fn mis_weight_0( bounce_pdf_0 : f32,  light_pdf_0 : f32) -> f32
{
    var _S165 : bool;
    if(bounce_pdf_0 == 0.0f)
    {
        _S165 = true;
    }
    else
    {
        _S165 = light_pdf_0 == 0.0f;
    }
    if(_S165)
    {
        return 1.0f;
    }
    return power_heuristic_0(bounce_pdf_0, light_pdf_0);
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn SunDisc_is_visible_0() -> bool
{
    return (params_0.hides_sun_disc_0) == u32(0);
}

fn Path_is_straight_0( this_23 : Path_0) -> bool
{
    var _S166 : bool;
    if((this_23.bounce_0) == u32(0))
    {
        _S166 = (this_23.pdf_1) == 0.0f;
    }
    else
    {
        _S166 = false;
    }
    if(_S166)
    {
        _S166 = (all(((this_23.normal_1) == vec3<f32>(0.0f))));
    }
    else
    {
        _S166 = false;
    }
    return _S166;
}

fn SunDisc_contains_0( direction_18 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_18 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_le_0( direction_19 : vec3<f32>) -> vec3<f32>
{
    var _S167 : vec3<f32>;
    if(SunDisc_contains_0(direction_19))
    {
        _S167 = params_0.sun_radiance_0;
    }
    else
    {
        _S167 = vec3<f32>(0.0f);
    }
    return _S167;
}

fn SunDisc_pdf_0( direction_20 : vec3<f32>) -> f32
{
    var _S168 : f32;
    if(SunDisc_contains_0(direction_20))
    {
        _S168 = params_0.sun_pdf_0;
    }
    else
    {
        _S168 = 0.0f;
    }
    return _S168;
}

fn Lights_sun_pdf_0( selection_2 : Selection_0,  direction_21 : vec3<f32>) -> f32
{
    var _S169 : f32;
    if(has_sun_0())
    {
        _S169 = SunDisc_pdf_0(direction_21) * selection_2.sun_0;
    }
    else
    {
        _S169 = 0.0f;
    }
    return _S169;
}

fn Path_events_0( this_24 : Path_0) -> u32
{
    return this_24.bounce_0;
}

fn Path_dimension_scatter_0( this_25 : Path_0) -> u32
{
    return u32(1) + u32(2) * Path_events_0(this_25);
}

fn owen_of_reversed_0( reversed_0 : u32,  seed_2 : u32) -> u32
{
    var word_0 : u32 = reversed_0 + seed_2;
    var word_1 : u32 = (word_0 ^ ((word_0 * u32(1817228412))));
    var word_2 : u32 = (word_1 ^ ((word_1 * u32(3090095698))));
    var word_3 : u32 = (word_2 ^ ((word_2 * u32(3350193720))));
    return reverseBits((word_3 ^ ((word_3 * u32(2367878886)))));
}

fn scrambled_sobol_0( sample_1 : u32,  order_0 : u32,  seeds_0 : vec2<u32>) -> vec2<u32>
{
    var index_8 : u32 = owen_of_reversed_0(reverseBits(sample_1), order_0);
    var binomial_0 : u32 = (index_8 ^ (((((index_8 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_8, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_26 : Sampler_0,  dimension_1 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_2 : vec4<u32> = pcg4d_0(vec4<u32>(this_26.pixel_0, dimension_1, this_26.seed_1, which_0));
    return scrambled_sobol_0(this_26.sample_0, words_2.x, words_2.yz);
}

fn Sampler_stratified_0( this_27 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_27, dimension_2, u32(1)), Sampler_pair_0(this_27, dimension_2, u32(2))));
}

fn find_brick_0( _S170 : u32,  _S171 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S171 >> (vec3<u32>(grids_0[_S170].top_shift_0)));
    var _S172 : u32 = cell_word_0(grids_0[_S170].top_offset_0 + u32((top_0.z * grids_0[_S170].top_size_0[i32(1)] + top_0.y) * grids_0[_S170].top_size_0[i32(0)] + top_0.x));
    var cell_7 : u32 = _S172;
    var shift_3 : u32 = grids_0[_S170].top_shift_0;
    for(;;)
    {
        var _S173 : bool;
        if(shift_3 > u32(3))
        {
            _S173 = ((cell_7 & (u32(2147483648)))) != u32(0);
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
        var shift_4 : u32 = shift_3 - u32(2);
        var _S174 : u32 = cell_word_0(((cell_7 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S171, shift_4));
        cell_7 = _S174;
        shift_3 = shift_4;
    }
    return record_of_cell_0(cell_7);
}

fn rank_in_brick_0( record_3 : u32,  relative_1 : vec3<i32>) -> u32
{
    var header_0 : u32 = brick_word_0(record_3);
    var bit_1 : u32 = cell_in_node_0(relative_1, u32(0));
    var present_before_0 : u32 = countOneBits((header_0 & ((((u32(1) << (((((u32(((((relative_1.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_1.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_1.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_9 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_9 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S175 : u32 = u32(2) * index_9;
        var _S176 : u32 = brick_word_0(record_3 + u32(2) + _S175);
        var _S177 : u32 = countOneBits(_S176);
        var _S178 : u32 = brick_word_0(record_3 + u32(3) + _S175);
        var rank_1 : u32 = rank_0 + (_S177 + countOneBits(_S178));
        index_9 = index_9 + u32(1);
        rank_0 = rank_1;
    }
    var _S179 : u32 = u32(2) * present_before_0;
    var low_6 : u32 = brick_word_0(record_3 + u32(2) + _S179);
    if(bit_1 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_6 & ((((u32(1) << (bit_1))) - u32(1)))));
    }
    else
    {
        var _S180 : u32 = countOneBits(low_6);
        var _S181 : u32 = brick_word_0(record_3 + u32(3) + _S179);
        rank_0 = rank_0 + (_S180 + countOneBits((_S181 & ((((u32(1) << ((bit_1 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_10 : u32) -> u32
{
    var _S182 : u32;
    if(HAS_PAGES_0)
    {
        var _S183 : u32 = word_in_pages_0(index_10, pages_0[i32(2)]);
        _S182 = _S183;
    }
    else
    {
        _S182 = index_10;
    }
    return _S182;
}

fn material_word_0( index_11 : u32) -> u32
{
    var _S184 : u32 = place_of_material_0(index_11);
    return brick_materials_0[_S184];
}

fn read_bits_0( start_1 : u32,  position_2 : u32,  count_0 : u32) -> u32
{
    if(count_0 == u32(0))
    {
        return u32(0);
    }
    var word_4 : u32 = start_1 + ((position_2 >> (u32(5))));
    var shift_5 : u32 = (position_2 & (u32(31)));
    var _S185 : u32 = material_word_0(word_4);
    var bits_2 : u32 = (_S185 >> (shift_5));
    var bits_3 : u32;
    if((shift_5 + count_0) > u32(32))
    {
        var _S186 : u32 = material_word_0(word_4 + u32(1));
        bits_3 = (bits_2 | (((_S186 << ((u32(32) - shift_5))))));
    }
    else
    {
        bits_3 = bits_2;
    }
    return (bits_3 & ((((u32(1) << (count_0))) - u32(1))));
}

fn material_at_0( _S187 : u32,  _S188 : vec3<i32>) -> u32
{
    var _S189 : u32 = find_brick_0(_S187, _S188);
    var header_1 : u32 = brick_word_0(_S189);
    var rank_2 : u32 = rank_in_brick_0(_S189, _S188);
    var index_bits_0 : u32 = (((header_1 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_1 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S187].material_bits_0;
    var start_2 : u32 = brick_word_0(_S189 + u32(1));
    var index_12 : u32 = read_bits_0(start_2, palette_count_0 * grids_0[_S187].material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_12;
    }
    var _S190 : u32 = read_bits_0(start_2, index_12 * entry_bits_0, entry_bits_0);
    return _S190;
}

fn material_of_0( hit_1 : Hit_0) -> PackedMaterial_0
{
    var _S191 : u32 = material_at_0(instances_0[hit_1.instance_3].grid_0, hit_1.voxel_1 - cell_of_0(grids_0[instances_0[hit_1.instance_3].grid_0].origin_0));
    return material_of_index_0(_S191);
}

fn material_met_0( path_4 : Path_0,  hit_2 : Hit_0,  beyond_2 : u32) -> PackedMaterial_0
{
    var _S192 : PackedMaterial_0 = material_of_0(hit_2);
    return _S192;
}

fn emitted_0( material_3 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_3.emission_0) * vec3<f32>(params_0.emitter_intensity_0);
}

fn EmitterTree_le_0( material_4 : PackedMaterial_0) -> vec3<f32>
{
    return emitted_0(material_4);
}

fn luminance_0( color_0 : vec3<f32>) -> f32
{
    return color_0.x * 0.2125999927520752f + color_0.y * 0.71520000696182251f + color_0.z * 0.07220000028610229f;
}

struct Aim_0
{
     is_met_0 : bool,
     direction_22 : vec3<f32>,
     hit_3 : Hit_0,
     luminance_1 : f32,
};

fn Aim_x24init_0( is_met_1 : bool,  direction_23 : vec3<f32>,  hit_4 : Hit_0,  luminance_2 : f32) -> Aim_0
{
    var _S193 : Aim_0;
    _S193.is_met_0 = is_met_1;
    _S193.direction_22 = direction_23;
    _S193.hit_3 = hit_4;
    _S193.luminance_1 = luminance_2;
    return _S193;
}

struct LightSample_0
{
     ray_15 : Ray_0,
     cos_theta_0 : f32,
     radiance_1 : vec3<f32>,
     pdf_2 : f32,
};

fn LightSample_x24init_0( ray_16 : Ray_0,  cos_theta_1 : f32,  radiance_2 : vec3<f32>,  pdf_3 : f32) -> LightSample_0
{
    var _S194 : LightSample_0;
    _S194.ray_15 = ray_16;
    _S194.cos_theta_0 = cos_theta_1;
    _S194.radiance_1 = radiance_2;
    _S194.pdf_2 = pdf_3;
    return _S194;
}

fn no_light_0() -> LightSample_0
{
    var _S195 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S195, 0.0f, _S195, 0.0f), 0.0f, _S195, 0.0f);
}

fn sincos_turns_0( turns_1 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_1 * 4.0f + 0.5f);
    var x_6 : f32 = (turns_1 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_6 * x_6;
    var sin_1 : f32 = x_6 + x_6 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
    var cos_1 : f32 = 1.0f + xx_0 * (-0.5f + xx_0 * (0.0416666679084301f + xx_0 * (-0.00138888892251998f + xx_0 * (0.00002480158764229f + xx_0 * -2.75573199814971304e-07f))));
    switch((quadrant_0 & (i32(3))))
    {
    case i32(0):
        {
            return vec2<f32>(sin_1, cos_1);
        }
    case i32(1):
        {
            return vec2<f32>(cos_1, - sin_1);
        }
    case i32(2):
        {
            return vec2<f32>(- sin_1, - cos_1);
        }
    default :
        {
            return vec2<f32>(- cos_1, sin_1);
        }
    }
}

fn with_slack_0( receiver_0 : Receiver_0,  cos_2 : f32) -> f32
{
    return cos_2;
}

fn SunDisc_sample_0( receiver_1 : Receiver_0,  u_3 : vec4<f32>,  sample_2 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_3.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_1 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_0 : vec2<f32> = sincos_turns_0(u_3.w);
    var direction_24 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_1 * sin_cos_0.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_1 * sin_cos_0.x)));
    var cos_theta_2 : f32 = with_slack_0(receiver_1, dot_product_0(receiver_1.normal_3, direction_24));
    (*sample_2) = LightSample_x24init_0(ray_from_0(receiver_1.point_0, direction_24), cos_theta_2, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_2 > 0.0f;
}

struct ChosenDirection_0
{
     direction_25 : vec3<f32>,
     radiance_3 : vec3<f32>,
     pdf_4 : f32,
};

fn ChosenDirection_x24init_0( direction_26 : vec3<f32>,  radiance_4 : vec3<f32>,  pdf_5 : f32) -> ChosenDirection_0
{
    var _S196 : ChosenDirection_0;
    _S196.direction_25 = direction_26;
    _S196.radiance_3 = radiance_4;
    _S196.pdf_4 = pdf_5;
    return _S196;
}

fn direction_of_0( square_0 : vec2<f32>) -> vec3<f32>
{
    var u_4 : f32 = square_0.x * 2.0f - 1.0f;
    var v_3 : f32 = square_0.y * 2.0f - 1.0f;
    var _S197 : f32 = abs(u_4);
    var _S198 : f32 = abs(v_3);
    var height_1 : f32 = 1.0f - (_S197 + _S198);
    var radius_2 : f32 = 1.0f - abs(height_1);
    var turns_2 : f32;
    if(radius_2 > 0.0f)
    {
        turns_2 = (divide_0(_S198 - _S197, radius_2) + 1.0f) * 0.125f;
    }
    else
    {
        turns_2 = 0.0f;
    }
    var sin_cos_1 : vec2<f32> = sincos_turns_0(turns_2);
    var _S199 : f32 = radius_2 * radius_2;
    var across_0 : f32 = radius_2 * square_root_0(2.0f - _S199);
    var x_7 : f32 = sin_cos_1.y * across_0;
    var y_4 : f32 = sin_cos_1.x * across_0;
    var z_0 : f32 = 1.0f - _S199;
    if(u_4 < 0.0f)
    {
        turns_2 = - x_7;
    }
    else
    {
        turns_2 = x_7;
    }
    var _S200 : f32;
    if(v_3 < 0.0f)
    {
        _S200 = - y_4;
    }
    else
    {
        _S200 = y_4;
    }
    var _S201 : f32;
    if(height_1 < 0.0f)
    {
        _S201 = - z_0;
    }
    else
    {
        _S201 = z_0;
    }
    return vec3<f32>(turns_2, _S200, _S201);
}

fn Environment_to_world_0( d_2 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S202 : f32 = d_2.x;
    var _S203 : f32 = d_2.y;
    return vec3<f32>(_S202 * cos_3 + _S203 * sin_2, _S203 * cos_3 - _S202 * sin_2, d_2.z);
}

fn Environment_choose_0( u_5 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S204 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S204, _S204, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S205 : f32 = u_5.x * edge_0;
    var _S206 : f32 = edge_0 - 1.0f;
    var _S207 : f32 = min(floor(_S205), _S206);
    var own_1 : u32 = u32(_S207) * params_0.sky_edge_0 + u32(min(floor(u_5.y * edge_0), _S206));
    var index_13 : u32;
    if((u_5.z) < (environment_0[own_1].threshold_0))
    {
        index_13 = own_1;
    }
    else
    {
        index_13 = environment_0[own_1].alias_0;
    }
    var pdf_6 : f32 = environment_0[index_13].pdf_0;
    if((environment_0[index_13].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S208 : u32 = index_13 % params_0.sky_edge_0;
    var _S209 : f32 = f32(_S208);
    var _S210 : u32 = index_13 / params_0.sky_edge_0;
    var place_4 : vec2<f32> = vec2<f32>(_S209, f32(_S210)) + vec2<f32>(min(_S205 - _S207, 1.0f), u_5.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_4 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_4), pdf_6);
    return true;
}

fn Sky_sample_0( receiver_2 : Receiver_0,  u_6 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S211 : bool;
    if(SKY_0 != u32(1))
    {
        _S211 = true;
    }
    else
    {
        var _S212 : bool = Environment_choose_0(u_6, &(chosen_1));
        _S211 = !_S212;
    }
    if(_S211)
    {
        return false;
    }
    var cos_theta_3 : f32 = dot_product_0(receiver_2.normal_3, chosen_1.direction_25);
    (*sample_3) = LightSample_x24init_0(ray_from_0(receiver_2.point_0, chosen_1.direction_25), cos_theta_3, chosen_1.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_4);
    return cos_theta_3 > 0.0f;
}

struct Descent_0
{
     node_0 : u32,
     index_14 : u32,
     count_1 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
     is_far_0 : bool,
};

fn Descent_x24init_0( node_1 : u32,  index_15 : u32,  count_2 : u32,  weight_1 : f32,  total_1 : f32,  choice_1 : f32,  is_far_1 : bool) -> Descent_0
{
    var _S213 : Descent_0;
    _S213.node_0 = node_1;
    _S213.index_14 = index_15;
    _S213.count_1 = count_2;
    _S213.weight_0 = weight_1;
    _S213.total_0 = total_1;
    _S213.choice_0 = choice_1;
    _S213.is_far_0 = is_far_1;
    return _S213;
}

struct LightNode_0
{
     min_2 : array<f32, i32(3)>,
     index_16 : u32,
     max_2 : array<f32, i32(3)>,
     count_3 : u32,
     power_2 : array<f32, i32(6)>,
     parent_0 : u32,
     root_1 : u32,
};

fn light_node_of_0( a_5 : vec4<u32>,  b_5 : vec4<u32>,  c_1 : vec4<u32>,  d_3 : vec4<u32>) -> LightNode_0
{
    var node_2 : LightNode_0;
    var _S214 : f32 = (bitcast<f32>((a_5.y)));
    var _S215 : f32 = (bitcast<f32>((a_5.z)));
    node_2.min_2[i32(0)] = (bitcast<f32>((a_5.x)));
    node_2.min_2[i32(1)] = _S214;
    node_2.min_2[i32(2)] = _S215;
    node_2.index_16 = a_5.w;
    var _S216 : f32 = (bitcast<f32>((b_5.y)));
    var _S217 : f32 = (bitcast<f32>((b_5.z)));
    node_2.max_2[i32(0)] = (bitcast<f32>((b_5.x)));
    node_2.max_2[i32(1)] = _S216;
    node_2.max_2[i32(2)] = _S217;
    node_2.count_3 = b_5.w;
    var _S218 : f32 = (bitcast<f32>((c_1.y)));
    var _S219 : f32 = (bitcast<f32>((c_1.z)));
    var _S220 : f32 = (bitcast<f32>((c_1.w)));
    var _S221 : f32 = (bitcast<f32>((d_3.x)));
    var _S222 : f32 = (bitcast<f32>((d_3.y)));
    node_2.power_2[i32(0)] = (bitcast<f32>((c_1.x)));
    node_2.power_2[i32(1)] = _S218;
    node_2.power_2[i32(2)] = _S219;
    node_2.power_2[i32(3)] = _S220;
    node_2.power_2[i32(4)] = _S221;
    node_2.power_2[i32(5)] = _S222;
    node_2.parent_0 = d_3.z;
    node_2.root_1 = d_3.w;
    return node_2;
}

fn top_light_node_0( index_17 : u32) -> LightNode_0
{
    var _S223 : u32 = u32(4) * index_17;
    return light_node_of_0(top_light_node_rows_0[_S223], top_light_node_rows_0[_S223 + u32(1)], top_light_node_rows_0[_S223 + u32(2)], top_light_node_rows_0[_S223 + u32(3)]);
}

fn TopLights_node_0( index_18 : u32) -> LightNode_0
{
    return top_light_node_0(index_18);
}

fn Descent_at_0( this_28 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_3 : LightNode_0 = TopLights_node_0(root_2);
    (*this_28).node_0 = root_2;
    (*this_28).index_14 = node_3.index_16;
    (*this_28).count_1 = node_3.count_3;
    (*this_28).is_far_0 = false;
    return;
}

struct View_0
{
     importance_0 : f32,
     is_far_2 : bool,
};

fn length_bound_0( absolute_0 : vec3<f32>) -> f32
{
    return (max_element_0(absolute_0) + (absolute_0.x + absolute_0.y + absolute_0.z)) * 0.5f;
}

struct BySide_0
{
     low_7 : vec3<f32>,
     high_4 : vec3<f32>,
};

fn BySide_x24init_0( low_8 : vec3<f32>,  high_5 : vec3<f32>) -> BySide_0
{
    var _S224 : BySide_0;
    _S224.low_7 = low_8;
    _S224.high_4 = high_5;
    return _S224;
}

fn sent_by_side_0( node_4 : LightNode_0,  point_2 : vec3<f32>,  distance_2 : f32) -> BySide_0
{
    var _S225 : vec3<f32> = vec3<f32>(0.0f);
    var _S226 : vec3<f32> = vec3<f32>(distance_2);
    return BySide_x24init_0(vec3<f32>(node_4.power_2[i32(0)], node_4.power_2[i32(2)], node_4.power_2[i32(4)]) * min(max(vector_of_0(node_4.max_2) - point_2, _S225), _S226), vec3<f32>(node_4.power_2[i32(1)], node_4.power_2[i32(3)], node_4.power_2[i32(5)]) * min(max(point_2 - vector_of_0(node_4.min_2), _S225), _S226));
}

fn BySide_sum_0( this_29 : BySide_0) -> f32
{
    var axes_0 : vec3<f32> = this_29.low_7 + this_29.high_4;
    return axes_0.x + axes_0.y + axes_0.z;
}

fn reciprocal_guess_0( x_8 : f32) -> f32
{
    var guess_2 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_8))))));
    return guess_2 * (2.0f - x_8 * guess_2);
}

fn View_x24init_0( importance_1 : f32,  is_far_3 : bool) -> View_0
{
    var _S227 : View_0;
    _S227.importance_0 = importance_1;
    _S227.is_far_2 = is_far_3;
    return _S227;
}

fn view_0( node_5 : LightNode_0,  receiver_3 : Receiver_0) -> View_0
{
    var _S228 : vec3<f32> = vector_of_0(node_5.max_2);
    var _S229 : vec3<f32> = vector_of_0(node_5.min_2);
    var _S230 : vec3<f32> = vec3<f32>(0.5f);
    var half_1 : vec3<f32> = (_S228 - _S229) * _S230;
    var toward_0 : vec3<f32> = (_S229 + _S228) * _S230 - receiver_3.point_0;
    var middle_0 : f32 = dot_product_0(toward_0, receiver_3.normal_3);
    var aside_0 : f32 = dot_product_0(half_1, abs(receiver_3.normal_3));
    var above_0 : f32 = with_slack_0(receiver_3, middle_0 + aside_0);
    var far_3 : f32 = length_squared_0(toward_0);
    var near_2 : f32 = length_squared_0(half_1);
    var is_far_4 : bool;
    if((with_slack_0(receiver_3, middle_0 - aside_0)) > 0.0f)
    {
        is_far_4 = far_3 > (near_2 * 36.0f);
    }
    else
    {
        is_far_4 = false;
    }
    var distance_3 : f32 = length_bound_0(select(half_1, abs(toward_0), vec3<bool>((far_3 > near_2))));
    var sent_0 : f32 = BySide_sum_0(sent_by_side_0(node_5, receiver_3.point_0, distance_3));
    var falloff_0 : f32 = reciprocal_guess_0(max(far_3, near_2));
    var _S231 : f32;
    if(above_0 > 0.0f)
    {
        _S231 = sent_0 * min(above_0, distance_3) * (falloff_0 * falloff_0);
    }
    else
    {
        _S231 = 0.0f;
    }
    return View_x24init_0(_S231, is_far_4);
}

fn normal_or_zero_0( weight_2 : f32) -> f32
{
    var _S232 : f32;
    if(weight_2 < 1.17549435082228751e-38f)
    {
        _S232 = 0.0f;
    }
    else
    {
        _S232 = weight_2;
    }
    return _S232;
}

fn inverse_power_of_two_0( x_9 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_9))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_0 : f32) -> vec2<f32>
{
    var _S233 : f32 = normal_or_zero_0(left_0);
    var _S234 : f32 = normal_or_zero_0(right_0);
    var unit_0 : f32 = inverse_power_of_two_0(_S233 + _S234);
    return vec2<f32>(normal_or_zero_0(_S233 * unit_0), normal_or_zero_0(_S234 * unit_0));
}

fn climb_0( receiver_4 : Receiver_0,  start_3 : u32,  descent_0 : ptr<function, Descent_0>) -> bool
{
    var node_6 : LightNode_0 = top_light_node_0(start_3);
    var at_1 : u32 = start_3;
    for(;;)
    {
        var _S235 : LightNode_0 = node_6;
        if((node_6.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S235.parent_0);
        var _S236 : u32 = _S235.parent_0 + u32(1);
        var is_left_0 : bool = at_1 == _S236;
        var _S237 : u32;
        if(is_left_0)
        {
            _S237 = parent_1.index_16;
        }
        else
        {
            _S237 = _S236;
        }
        var _S238 : View_0 = view_0(node_6, receiver_4);
        var _S239 : View_0 = view_0(top_light_node_0(_S237), receiver_4);
        var _S240 : f32;
        if(is_left_0)
        {
            _S240 = _S238.importance_0;
        }
        else
        {
            _S240 = _S239.importance_0;
        }
        var _S241 : f32;
        if(is_left_0)
        {
            _S241 = _S239.importance_0;
        }
        else
        {
            _S241 = _S238.importance_0;
        }
        var weights_0 : vec2<f32> = weights_of_0(_S240, _S241);
        var _S242 : f32 = weights_0.x;
        var _S243 : f32 = weights_0.y;
        var total_2 : f32 = _S242 + _S243;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S244 : f32;
        if(is_left_0)
        {
            _S244 = _S242;
        }
        else
        {
            _S244 = _S243;
        }
        (*descent_0).weight_0 = (*descent_0).weight_0 * _S244;
        (*descent_0).total_0 = (*descent_0).total_0 * total_2;
        node_6 = parent_1;
        at_1 = _S235.parent_0;
    }
    return ((*descent_0).weight_0) > 0.0f;
}

fn by_chance_0() -> Aim_0
{
    return Aim_x24init_0(false, vec3<f32>(0.0f), miss_0(), 0.0f);
}

fn descend_0( receiver_5 : Receiver_0,  aim_0 : Aim_0,  descent_1 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S245 : bool;
        if(((*descent_1).count_1) == u32(0))
        {
            _S245 = !(*descent_1).is_far_0;
        }
        else
        {
            _S245 = false;
        }
        if(_S245)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_1 : LightNode_0 = TopLights_node_0((*descent_1).node_0 + u32(1));
        var right_1 : LightNode_0 = TopLights_node_0((*descent_1).index_14);
        var weights_1 : vec2<f32> = weights_of_0(view_0(left_1, receiver_5).importance_0, view_0(right_1, receiver_5).importance_0);
        var _S246 : f32 = weights_1.x;
        var _S247 : f32 = weights_1.y;
        var total_3 : f32 = _S246 + _S247;
        if(!(total_3 > 0.0f))
        {
            return false;
        }
        var _S248 : bool;
        if(_S247 <= 0.0f)
        {
            _S248 = true;
        }
        else
        {
            _S248 = ((*descent_1).choice_0 * total_3) < (_S246 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_0.is_met_0)
        {
            var _S249 : vec3<f32> = vec3<f32>(aim_0.hit_3.voxel_1);
            if((all((_S249 >= (vector_of_0(left_1.min_2))))))
            {
                is_left_1 = (all((_S249 < (vector_of_0(left_1.max_2)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S248;
        }
        var _S250 : f32 = (*descent_1).choice_0 * total_3;
        var _S251 : f32;
        if(is_left_1)
        {
            _S251 = 0.0f;
        }
        else
        {
            _S251 = _S246 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S250 - _S251;
        var _S252 : u32;
        if(is_left_1)
        {
            _S252 = (*descent_1).node_0 + u32(1);
        }
        else
        {
            _S252 = (*descent_1).index_14;
        }
        (*descent_1).node_0 = _S252;
        var _S253 : u32;
        if(is_left_1)
        {
            _S253 = left_1.index_16;
        }
        else
        {
            _S253 = right_1.index_16;
        }
        (*descent_1).index_14 = _S253;
        var _S254 : u32;
        if(is_left_1)
        {
            _S254 = left_1.count_3;
        }
        else
        {
            _S254 = right_1.count_3;
        }
        (*descent_1).count_1 = _S254;
        (*descent_1).is_far_0 = false;
        var _S255 : f32;
        if(is_left_1)
        {
            _S255 = _S246;
        }
        else
        {
            _S255 = _S247;
        }
        var _S256 : f32 = (*descent_1).weight_0 * _S255;
        (*descent_1).weight_0 = _S256;
        (*descent_1).total_0 = (*descent_1).total_0 * total_3;
        if(_S256 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn normalize_vector_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vector_4 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_4))));
}

fn in_grid_0( instance_10 : u32,  receiver_6 : Receiver_0) -> Receiver_0
{
    if(IS_SINGLE_0)
    {
        return receiver_6;
    }
    return Receiver_x24init_0(Transform_point_0(instance_10, receiver_6.point_0), normalize_vector_0(Transform_direction_0(instance_10, receiver_6.normal_3)));
}

fn lights_in_pages_0() -> bool
{
    var _S257 : bool;
    if(HAS_PAGES_0)
    {
        _S257 = pages_0[u32(5)] != u32(0);
    }
    else
    {
        _S257 = false;
    }
    return _S257;
}

fn place_in_light_node_0( node_7 : u32,  word_5 : u32) -> u32
{
    var _S258 : u32 = word_in_pages_0(node_7 * u32(16) + word_5, pages_0[i32(4)]);
    return _S258;
}

fn light_node_at_0( index_19 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S259 : u32 = u32(4) * index_19;
        return light_node_of_0(light_node_rows_0[_S259], light_node_rows_0[_S259 + u32(1)], light_node_rows_0[_S259 + u32(2)], light_node_rows_0[_S259 + u32(3)]);
    }
    var at_2 : u32 = place_in_light_node_0(index_19, u32(0));
    var node_8 : LightNode_0;
    var i_0 : u32 = u32(0);
    for(;;)
    {
        if(i_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        node_8.min_2[i_0] = (bitcast<f32>((cells_0[at_2 + i_0])));
        node_8.max_2[i_0] = (bitcast<f32>((cells_0[at_2 + u32(4) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.index_16 = cells_0[at_2 + u32(3)];
    node_8.count_3 = cells_0[at_2 + u32(7)];
    i_0 = u32(0);
    for(;;)
    {
        if(i_0 < u32(6))
        {
        }
        else
        {
            break;
        }
        node_8.power_2[i_0] = (bitcast<f32>((cells_0[at_2 + u32(8) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.parent_0 = cells_0[at_2 + u32(14)];
    node_8.root_1 = cells_0[at_2 + u32(15)];
    return node_8;
}

fn GridLights_node_0( index_20 : u32) -> LightNode_0
{
    var _S260 : LightNode_0 = light_node_at_0(index_20);
    return _S260;
}

fn Descent_at_1( this_30 : ptr<function, Descent_0>,  root_3 : u32)
{
    var node_9 : LightNode_0 = GridLights_node_0(root_3);
    (*this_30).node_0 = root_3;
    (*this_30).index_14 = node_9.index_16;
    (*this_30).count_1 = node_9.count_3;
    (*this_30).is_far_0 = false;
    return;
}

fn descend_1( receiver_7 : Receiver_0,  aim_1 : Aim_0,  descent_2 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S261 : bool;
        if(((*descent_2).count_1) == u32(0))
        {
            _S261 = !(*descent_2).is_far_0;
        }
        else
        {
            _S261 = false;
        }
        if(_S261)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_2 : LightNode_0 = GridLights_node_0((*descent_2).node_0 + u32(1));
        var right_2 : LightNode_0 = GridLights_node_0((*descent_2).index_14);
        var of_left_0 : View_0 = view_0(left_2, receiver_7);
        var of_right_0 : View_0 = view_0(right_2, receiver_7);
        var weights_2 : vec2<f32> = weights_of_0(of_left_0.importance_0, of_right_0.importance_0);
        var _S262 : f32 = weights_2.x;
        var _S263 : f32 = weights_2.y;
        var total_4 : f32 = _S262 + _S263;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S264 : bool;
        if(_S263 <= 0.0f)
        {
            _S264 = true;
        }
        else
        {
            _S264 = ((*descent_2).choice_0 * total_4) < (_S262 * (*descent_2).weight_0);
        }
        var is_left_2 : bool;
        if(aim_1.is_met_0)
        {
            var _S265 : vec3<f32> = vec3<f32>(aim_1.hit_3.voxel_1);
            if((all((_S265 >= (vector_of_0(left_2.min_2))))))
            {
                is_left_2 = (all((_S265 < (vector_of_0(left_2.max_2)))));
            }
            else
            {
                is_left_2 = false;
            }
        }
        else
        {
            is_left_2 = _S264;
        }
        var _S266 : f32 = (*descent_2).choice_0 * total_4;
        var _S267 : f32;
        if(is_left_2)
        {
            _S267 = 0.0f;
        }
        else
        {
            _S267 = _S262 * (*descent_2).weight_0;
        }
        (*descent_2).choice_0 = _S266 - _S267;
        var _S268 : u32;
        if(is_left_2)
        {
            _S268 = (*descent_2).node_0 + u32(1);
        }
        else
        {
            _S268 = (*descent_2).index_14;
        }
        (*descent_2).node_0 = _S268;
        var _S269 : u32;
        if(is_left_2)
        {
            _S269 = left_2.index_16;
        }
        else
        {
            _S269 = right_2.index_16;
        }
        (*descent_2).index_14 = _S269;
        var _S270 : u32;
        if(is_left_2)
        {
            _S270 = left_2.count_3;
        }
        else
        {
            _S270 = right_2.count_3;
        }
        (*descent_2).count_1 = _S270;
        var _S271 : bool;
        if(is_left_2)
        {
            _S271 = of_left_0.is_far_2;
        }
        else
        {
            _S271 = of_right_0.is_far_2;
        }
        (*descent_2).is_far_0 = _S271;
        var _S272 : f32;
        if(is_left_2)
        {
            _S272 = _S262;
        }
        else
        {
            _S272 = _S263;
        }
        var _S273 : f32 = (*descent_2).weight_0 * _S272;
        (*descent_2).weight_0 = _S273;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        if(_S273 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_0( point_3 : vec3<f32>,  is_met_2 : bool,  way_4 : Descent_0,  side_0 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var node_10 : LightNode_0 = light_node_at_0(way_4.node_0);
    var _S274 : vec3<f32> = vector_of_0(node_10.max_2);
    var _S275 : vec3<f32> = vector_of_0(node_10.min_2);
    var _S276 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (_S274 - _S275) * _S276;
    var toward_1 : vec3<f32> = (_S275 + _S274) * _S276 - point_3;
    var sent_1 : BySide_0 = sent_by_side_0(node_10, point_3, length_bound_0(select(half_2, abs(toward_1), vec3<bool>(((length_squared_0(toward_1)) > (length_squared_0(half_2)))))));
    var sum_3 : f32 = normal_or_zero_0(BySide_sum_0(sent_1));
    var unit_1 : f32 = inverse_power_of_two_0(sum_3);
    var total_5 : f32 = sum_3 * unit_1;
    var _S277 : f32 = way_4.choice_0 * total_5;
    var _S278 : u32 = (*side_0);
    var share_0 : f32 = normal_or_zero_0(sent_1.low_7[u32(0)] * unit_1);
    var _S279 : bool;
    if(is_met_2)
    {
        _S279 = u32(0) == _S278;
    }
    else
    {
        _S279 = share_0 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S279)
    {
        (*side_0) = u32(0);
        chosen_2 = share_0;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S280 : bool = _S277 < (share_0 * way_4.weight_0);
    var share_1 : f32 = normal_or_zero_0(sent_1.high_4[u32(0)] * unit_1);
    if(is_met_2)
    {
        _S279 = u32(1) == _S278;
    }
    else
    {
        if(share_1 > 0.0f)
        {
            _S279 = !_S280;
        }
        else
        {
            _S279 = false;
        }
    }
    if(_S279)
    {
        (*side_0) = u32(1);
        chosen_2 = share_1;
    }
    var passed_0 : f32 = share_0 + share_1;
    if(_S280)
    {
        _S279 = true;
    }
    else
    {
        _S279 = _S277 < (passed_0 * way_4.weight_0);
    }
    var share_2 : f32 = normal_or_zero_0(sent_1.low_7[u32(1)] * unit_1);
    var _S281 : bool;
    if(is_met_2)
    {
        _S281 = u32(2) == _S278;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S281 = !_S279;
        }
        else
        {
            _S281 = false;
        }
    }
    if(_S281)
    {
        (*side_0) = u32(2);
        chosen_2 = share_2;
    }
    var passed_1 : f32 = passed_0 + share_2;
    if(_S279)
    {
        _S279 = true;
    }
    else
    {
        _S279 = _S277 < (passed_1 * way_4.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_1.high_4[u32(1)] * unit_1);
    if(is_met_2)
    {
        _S281 = u32(3) == _S278;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S281 = !_S279;
        }
        else
        {
            _S281 = false;
        }
    }
    if(_S281)
    {
        (*side_0) = u32(3);
        chosen_2 = share_3;
    }
    var passed_2 : f32 = passed_1 + share_3;
    if(_S279)
    {
        _S279 = true;
    }
    else
    {
        _S279 = _S277 < (passed_2 * way_4.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_1.low_7[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S281 = u32(4) == _S278;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S281 = !_S279;
        }
        else
        {
            _S281 = false;
        }
    }
    if(_S281)
    {
        (*side_0) = u32(4);
        chosen_2 = share_4;
    }
    var passed_3 : f32 = passed_2 + share_4;
    if(_S279)
    {
        _S279 = true;
    }
    else
    {
        _S279 = _S277 < (passed_3 * way_4.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_1.high_4[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S279 = u32(5) == _S278;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S279 = !_S279;
        }
        else
        {
            _S279 = false;
        }
    }
    if(_S279)
    {
        (*side_0) = u32(5);
        chosen_2 = share_5;
    }
    (*odds_0) = vec2<f32>(way_4.weight_0 * chosen_2, way_4.total_0 * total_5);
    if(sum_3 > 0.0f)
    {
        _S279 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S279 = false;
    }
    return _S279;
}

fn light_node_word_0( index_21 : u32,  word_6 : u32) -> u32
{
    return light_node_rows_0[u32(4) * index_21 + ((word_6 >> (u32(2))))][(word_6 & (u32(3)))];
}

fn light_power_at_0( index_22 : u32,  side_1 : u32) -> f32
{
    var _S282 : u32;
    if(lights_in_pages_0())
    {
        var _S283 : u32 = place_in_light_node_0(index_22, u32(8) + side_1);
        _S282 = cells_0[_S283];
    }
    else
    {
        _S282 = light_node_word_0(index_22, u32(8) + side_1);
    }
    return (bitcast<f32>((_S282)));
}

fn component_0( vector_5 : vec3<f32>,  axis_5 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_5 == u32(1)), vector_5.x, axis_5 == u32(0));
}

fn density_0( odds_1 : vec2<f32>,  luminance_3 : f32,  power_3 : f32,  toward_2 : vec3<f32>,  face_2 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_2, (face_2 >> (u32(1))));
    var in_front_0 : f32;
    if(((face_2 & (u32(1)))) == u32(1))
    {
        in_front_0 = - along_0;
    }
    else
    {
        in_front_0 = along_0;
    }
    var distance_squared_0 : f32 = length_squared_0(toward_2);
    var unit_2 : f32 = inverse_power_of_two_0(power_3);
    var share_6 : f32 = odds_1.x * (luminance_3 * unit_2) * (distance_squared_0 * square_root_0(distance_squared_0));
    if(in_front_0 > 0.0f)
    {
        in_front_0 = divide_0(share_6, odds_1.y * (power_3 * unit_2) * in_front_0);
    }
    else
    {
        in_front_0 = -1.0f;
    }
    return in_front_0;
}

struct Emitter_0
{
     voxel_18 : array<i32, i32(3)>,
     grid_1 : u32,
     faces_0 : u32,
     material_5 : u32,
     luminance_4 : f32,
     leaf_0 : u32,
};

fn below_light_node_0( index_23 : u32) -> vec2<u32>
{
    if(!lights_in_pages_0())
    {
        return vec2<u32>(light_node_word_0(index_23, u32(3)), light_node_word_0(index_23, u32(7)));
    }
    var at_3 : u32 = place_in_light_node_0(index_23, u32(0));
    return vec2<u32>(cells_0[at_3 + u32(3)], cells_0[at_3 + u32(7)]);
}

fn place_in_emitter_0( emitter_0 : u32,  word_7 : u32) -> u32
{
    var _S284 : u32 = word_in_pages_0(emitter_0 * u32(8) + word_7, pages_0[i32(3)]);
    return _S284;
}

fn emitter_word_0( index_24 : u32,  word_8 : u32) -> u32
{
    return emitter_rows_0[u32(2) * index_24 + ((word_8 >> (u32(2))))][(word_8 & (u32(3)))];
}

fn emitter_faces_at_0( index_25 : u32) -> u32
{
    var _S285 : u32;
    if(lights_in_pages_0())
    {
        var _S286 : u32 = place_in_emitter_0(index_25, u32(4));
        _S285 = cells_0[_S286];
    }
    else
    {
        _S285 = emitter_word_0(index_25, u32(4));
    }
    return _S285;
}

fn emitter_luminance_at_0( index_26 : u32) -> f32
{
    var _S287 : f32;
    if(lights_in_pages_0())
    {
        var _S288 : u32 = place_in_emitter_0(index_26, u32(6));
        _S287 = (bitcast<f32>((cells_0[_S288])));
    }
    else
    {
        _S287 = (bitcast<f32>((emitter_word_0(index_26, u32(6)))));
    }
    return _S287;
}

fn Emitter_x24init_0( voxel_19 : array<i32, i32(3)>,  grid_2 : u32,  faces_1 : u32,  material_6 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S289 : Emitter_0;
    _S289.voxel_18 = voxel_19;
    _S289.grid_1 = grid_2;
    _S289.faces_0 = faces_1;
    _S289.material_5 = material_6;
    _S289.luminance_4 = luminance_5;
    _S289.leaf_0 = leaf_1;
    return _S289;
}

fn emitter_at_0( index_27 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S290 : u32 = u32(2) * index_27;
        var a_6 : vec4<u32> = emitter_rows_0[_S290];
        var b_6 : vec4<u32> = emitter_rows_0[_S290 + u32(1)];
        var _S291 : array<i32, i32(3)> = array<i32, i32(3)>( i32(a_6.x), i32(a_6.y), i32(a_6.z) );
        return Emitter_x24init_0(_S291, a_6.w, b_6.x, b_6.y, (bitcast<f32>((b_6.z))), b_6.w);
    }
    var at_4 : u32 = place_in_emitter_0(index_27, u32(0));
    var _S292 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_0[at_4]), i32(cells_0[at_4 + u32(1)]), i32(cells_0[at_4 + u32(2)]) );
    return Emitter_x24init_0(_S292, cells_0[at_4 + u32(3)], cells_0[at_4 + u32(4)], cells_0[at_4 + u32(5)], (bitcast<f32>((cells_0[at_4 + u32(6)]))), cells_0[at_4 + u32(7)]);
}

fn choose_emitter_0( way_5 : Descent_0,  side_2 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_3 : bool;
    var is_left_3 : bool;
    var count_4 : u32 = way_5.count_1;
    var node_11 : u32 = way_5.node_0;
    var index_28 : u32 = way_5.index_14;
    var _S293 : f32 = threshold_1;
    for(;;)
    {
        if(count_4 == u32(0))
        {
            is_found_3 = !waits_for_pages_0();
        }
        else
        {
            is_found_3 = false;
        }
        if(is_found_3)
        {
        }
        else
        {
            break;
        }
        var left_3 : u32 = node_11 + u32(1);
        var power_left_0 : f32 = light_power_at_0(left_3, side_2);
        var power_right_0 : f32 = light_power_at_0(index_28, side_2);
        var below_left_0 : vec2<u32> = below_light_node_0(left_3);
        var below_right_0 : vec2<u32> = below_light_node_0(index_28);
        if(_S293 < power_left_0)
        {
            is_left_3 = true;
        }
        else
        {
            is_left_3 = power_right_0 <= 0.0f;
        }
        if(is_left_3)
        {
        }
        else
        {
            _S293 = _S293 - power_left_0;
        }
        if(is_left_3)
        {
            node_11 = left_3;
        }
        else
        {
            node_11 = index_28;
        }
        if(is_left_3)
        {
            index_28 = below_left_0.x;
        }
        else
        {
            index_28 = below_right_0.x;
        }
        if(is_left_3)
        {
            count_4 = below_left_0.y;
        }
        else
        {
            count_4 = below_right_0.y;
        }
    }
    is_found_3 = false;
    var chosen_3 : u32 = index_28;
    var at_5 : u32 = index_28;
    for(;;)
    {
        if(at_5 < (index_28 + count_4))
        {
            is_left_3 = !is_found_3;
        }
        else
        {
            is_left_3 = false;
        }
        if(is_left_3)
        {
        }
        else
        {
            break;
        }
        var _S294 : u32 = emitter_faces_at_0(at_5);
        if(((((_S294 >> (side_2))) & (u32(1)))) != u32(0))
        {
            var _S295 : f32 = emitter_luminance_at_0(at_5);
            var _S296 : bool = _S293 < _S295;
            var _S297 : f32 = emitter_luminance_at_0(at_5);
            var _S298 : f32 = _S293 - _S297;
            is_found_3 = _S296;
            chosen_3 = at_5;
            _S293 = _S298;
        }
        at_5 = at_5 + u32(1);
    }
    var _S299 : Emitter_0 = emitter_at_0(chosen_3);
    return _S299;
}

fn point_of_face_0( low_9 : vec3<f32>,  face_3 : u32,  u_7 : f32,  v_4 : f32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_3 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = 0.0f;
    }
    if(face_3 < u32(2))
    {
        return low_9 + vec3<f32>(away_0, u_7, v_4);
    }
    if(face_3 < u32(4))
    {
        return low_9 + vec3<f32>(u_7, away_0, v_4);
    }
    return low_9 + vec3<f32>(u_7, v_4, away_0);
}

fn margin_of_0( translation_1 : vec3<f32>,  low_10 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_10) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn offset_ray_origin_0( translation_2 : vec3<f32>,  low_11 : vec3<f32>,  face_4 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_11);
    var _S300 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_4, low_11 + _S300), low_11 + vec3<f32>((1.0f - margin_0)));
    var _S301 : bool = face_4 < u32(2);
    var _S302 : bool;
    if(face_4 >= u32(2))
    {
        _S302 = face_4 < u32(4);
    }
    else
    {
        _S302 = false;
    }
    var is_axis_2 : vec3<bool> = vec3<bool>(_S301, _S302, face_4 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_4 & (u32(1)))) == u32(1))
    {
        outside_0 = low_11 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_11 - _S300;
    }
    return select(moved_0, outside_0, is_axis_2);
}

fn Transform_direction_1( _S303 : u32,  _S304 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S303].world_from_grid_0.x_axis_0) * vec3<f32>(_S304.x) + vector_of_0(instances_0[_S303].world_from_grid_0.y_axis_0) * vec3<f32>(_S304.y) + vector_of_0(instances_0[_S303].world_from_grid_0.z_axis_0) * vec3<f32>(_S304.z);
}

fn Transform_point_1( _S305 : u32,  _S306 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S305, _S306) + vector_of_0(instances_0[_S305].world_from_grid_0.translation_0);
}

fn sample_emitter_0( receiver_8 : Receiver_0,  u_8 : vec4<f32>,  aim_2 : Aim_0,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    (*sample_4) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_8.x, false);
    Descent_at_0(&(descent_3), u32(0));
    var _S307 : bool;
    if(!IS_SINGLE_0)
    {
        _S307 = aim_2.is_met_0;
    }
    else
    {
        _S307 = false;
    }
    if(_S307)
    {
        var leaf_2 : u32 = instances_0[aim_2.hit_3.instance_3].light_leaf_0;
        if((instances_0[aim_2.hit_3.instance_3].light_leaf_0) == u32(4294967295))
        {
            _S307 = true;
        }
        else
        {
            var _S308 : bool = climb_0(receiver_8, leaf_2, &(descent_3));
            _S307 = !_S308;
        }
        if(_S307)
        {
            return false;
        }
        Descent_at_0(&(descent_3), leaf_2);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S309 : bool = descend_0(receiver_8, by_chance_0(), &(descent_3));
            _S307 = !_S309;
        }
        else
        {
            _S307 = false;
        }
        if(_S307)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_14;
    var local_1 : Receiver_0 = in_grid_0(descent_3.index_14, receiver_8);
    Descent_at_1(&(descent_3), top_light_node_0(descent_3.node_0).root_1);
    var _S310 : bool = descend_1(local_1, aim_2, &(descent_3));
    if(!_S310)
    {
        return false;
    }
    var side_3 : u32 = aim_2.hit_3.face_0;
    var odds_2 : vec2<f32>;
    var _S311 : bool = choose_side_0(local_1.point_0, aim_2.is_met_0, descent_3, &(side_3), &(odds_2));
    if(!_S311)
    {
        return false;
    }
    var power_4 : f32 = light_power_at_0(descent_3.node_0, side_3);
    if(aim_2.is_met_0)
    {
        var _S312 : f32 = density_0(odds_2, aim_2.luminance_1, power_4, Transform_direction_0(chosen_instance_0, aim_2.direction_22) * vec3<f32>(aim_2.hit_3.t_0), side_3);
        (*sample_4).pdf_2 = _S312;
        return _S312 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_3, u_8.y * power_4);
    var _S313 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_18));
    var on_face_0 : vec3<f32> = point_of_face_0(_S313, side_3, u_8.z, u_8.w);
    var pdf_7 : f32 = density_0(odds_2, emitter_1.luminance_4, power_4, on_face_0 - local_1.point_0, side_3);
    if(pdf_7 < 0.0f)
    {
        return false;
    }
    var direction_27 : vec3<f32> = Transform_point_1(chosen_instance_0, offset_ray_origin_0(vector_of_0(instances_0[chosen_instance_0].grid_from_world_0.translation_0), _S313, side_3, on_face_0)) - receiver_8.point_0;
    var cos_theta_4 : f32 = with_slack_0(receiver_8, divide_0(dot_product_0(receiver_8.normal_3, direction_27), square_root_0(length_squared_0(direction_27))));
    (*sample_4) = LightSample_x24init_0(Ray_x24init_0(receiver_8.point_0, 0.0f, direction_27, 1.0f), cos_theta_4, emitted_0(material_of_index_0(emitter_1.material_5)), pdf_7);
    return cos_theta_4 > 0.0f;
}

fn EmitterTree_sample_0( receiver_9 : Receiver_0,  u_9 : vec4<f32>,  aim_3 : Aim_0,  sample_5 : ptr<function, LightSample_0>) -> bool
{
    var _S314 : bool = sample_emitter_0(receiver_9, u_9, aim_3, &((*sample_5)));
    return _S314;
}

fn Lights_sample_0( receiver_10 : Receiver_0,  selection_3 : Selection_0,  u_10 : vec4<f32>,  aim_4 : Aim_0,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var is_found_4 : bool;
    if(has_sun_0())
    {
        is_found_4 = !aim_4.is_met_0;
    }
    else
    {
        is_found_4 = false;
    }
    if(is_found_4)
    {
        is_found_4 = (u_10.x) < (selection_3.sun_0);
    }
    else
    {
        is_found_4 = false;
    }
    if(is_found_4)
    {
        var _S315 : bool = SunDisc_sample_0(receiver_10, u_10, &((*sample_6)));
        (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sun_0;
        is_found_4 = _S315;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_4 = !aim_4.is_met_0;
        }
        else
        {
            is_found_4 = false;
        }
        if(is_found_4)
        {
            is_found_4 = (u_10.x) < (selection_3.sun_0 + selection_3.sky_1);
        }
        else
        {
            is_found_4 = false;
        }
        if(is_found_4)
        {
            var _S316 : bool = Sky_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - selection_3.sun_0, selection_3.sky_1), 0.99999994039535522f), u_10.yzw), &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sky_1;
            is_found_4 = _S316;
        }
        else
        {
            var _S317 : bool = EmitterTree_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - (selection_3.sun_0 + selection_3.sky_1), selection_3.emitters_0), 0.99999994039535522f), u_10.yzw), aim_4, &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.emitters_0;
            is_found_4 = _S317;
        }
    }
    return is_found_4;
}

fn ior_of_0( inside_3 : Inside_0) -> f32
{
    var _S318 : f32;
    if(Inside_is_in_0(inside_3))
    {
        _S318 = material_of_index_0(inside_3.material_0).ior_0;
    }
    else
    {
        _S318 = 1.0f;
    }
    return _S318;
}

struct Microfacets_0
{
     alpha_0 : f32,
};

struct MaterialBsdf_0
{
     kind_0 : u32,
     color_1 : vec3<f32>,
     specular_1 : f32,
     eta_0 : f32,
     facets_0 : Microfacets_0,
};

fn Microfacets_x24init_0( alpha_1 : f32) -> Microfacets_0
{
    var _S319 : Microfacets_0;
    _S319.alpha_0 = alpha_1;
    return _S319;
}

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S320 : MaterialBsdf_0;
    _S320.kind_0 = kind_1;
    _S320.color_1 = color_2;
    _S320.specular_1 = specular_2;
    _S320.eta_0 = eta_1;
    _S320.facets_0 = facets_1;
    return _S320;
}

fn bsdf_of_0( material_7 : PackedMaterial_0,  ior_1 : f32,  choice_2 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_7.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn MaterialBsdf_albedo_0( this_31 : MaterialBsdf_0) -> vec3<f32>
{
    return this_31.color_1;
}

fn roulette_0( event_1 : u32,  scattered_1 : vec3<f32>,  u_11 : f32) -> f32
{
    if(event_1 < u32(3))
    {
        return 1.0f;
    }
    var _S321 : f32 = min(max_element_0(scattered_1), 0.94999998807907104f);
    var _S322 : f32;
    if(u_11 < _S321)
    {
        _S322 = divide_0(1.0f, _S321);
    }
    else
    {
        _S322 = 0.0f;
    }
    return _S322;
}

struct Surface_0
{
     origin_10 : vec3<f32>,
     normal_5 : vec3<f32>,
     face_5 : u32,
     instance_11 : u32,
};

fn face_normal_0( face_6 : u32) -> vec3<f32>
{
    var away_1 : f32;
    if(((face_6 & (u32(1)))) == u32(1))
    {
        away_1 = 1.0f;
    }
    else
    {
        away_1 = -1.0f;
    }
    var _S323 : f32;
    if(face_6 < u32(2))
    {
        _S323 = away_1;
    }
    else
    {
        _S323 = 0.0f;
    }
    var _S324 : bool;
    if(face_6 >= u32(2))
    {
        _S324 = face_6 < u32(4);
    }
    else
    {
        _S324 = false;
    }
    var _S325 : f32;
    if(_S324)
    {
        _S325 = away_1;
    }
    else
    {
        _S325 = 0.0f;
    }
    if(face_6 >= u32(4))
    {
    }
    else
    {
        away_1 = 0.0f;
    }
    return vec3<f32>(_S323, _S325, away_1);
}

fn world_normal_0( _S326 : u32,  _S327 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S326, face_normal_0(_S327)));
}

fn surface_of_0( ray_17 : Ray_0,  hit_5 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S328 : vec3<f32> = vec3<f32>(hit_5.voxel_1);
    if(IS_SINGLE_0)
    {
        surface_0.origin_10 = offset_ray_origin_0(vec3<f32>(0.0f), _S328, hit_5.face_0, ray_17.origin_1 + ray_17.direction_0 * vec3<f32>(hit_5.t_0));
        surface_0.normal_5 = face_normal_0(hit_5.face_0);
    }
    else
    {
        surface_0.origin_10 = Transform_point_1(hit_5.instance_3, offset_ray_origin_0(vector_of_0(instances_0[hit_5.instance_3].grid_from_world_0.translation_0), _S328, hit_5.face_0, Transform_point_0(hit_5.instance_3, ray_17.origin_1) + Transform_direction_0(hit_5.instance_3, ray_17.direction_0) * vec3<f32>(hit_5.t_0)));
        surface_0.normal_5 = world_normal_0(hit_5.instance_3, hit_5.face_0);
    }
    surface_0.face_5 = hit_5.face_0;
    surface_0.instance_11 = hit_5.instance_3;
    return surface_0;
}

fn Surface_local_direction_0( this_32 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(this_32.instance_11, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_2 : vec3<f32>;
    if((this_32.face_5) < u32(2))
    {
        local_2 = in_grid_2.yzx;
    }
    else
    {
        if((this_32.face_5) < u32(4))
        {
            local_2 = in_grid_2.zxy;
        }
        else
        {
            local_2 = in_grid_2;
        }
    }
    if((((this_32.face_5) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_2;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_2.xy, - local_2.z);
    }
    return in_grid_1;
}

fn clamp_to_voxel_0( translation_3 : vec3<f32>,  low_12 : vec3<f32>,  point_5 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_12);
    return min(max(point_5, low_12 + vec3<f32>(margin_1)), low_12 + vec3<f32>((1.0f - margin_1)));
}

fn Inside_point_0( this_33 : Inside_0,  ray_18 : Ray_0,  t_10 : f32) -> vec3<f32>
{
    return Transform_point_1(this_33.instance_1, clamp_to_voxel_0(vector_of_0(instances_0[this_33.instance_1].grid_from_world_0.translation_0), vec3<f32>(this_33.voxel_0), Transform_point_0(this_33.instance_1, ray_18.origin_1) + Transform_direction_0(this_33.instance_1, ray_18.direction_0) * vec3<f32>(t_10)));
}

fn importance_of_all_0( receiver_11 : Receiver_0) -> f32
{
    if((params_0.light_node_count_0) == u32(0))
    {
        return 0.0f;
    }
    return view_0(top_light_node_0(u32(0)), receiver_11).importance_0 * params_0.light_intensity_0;
}

fn EmitterTree_importance_0( receiver_12 : Receiver_0) -> f32
{
    return importance_of_all_0(receiver_12);
}

fn Lights_sun_probability_0( receiver_13 : Receiver_0) -> f32
{
    if(!has_sun_0())
    {
        return 0.0f;
    }
    var cos_theta_5 : f32 = with_slack_0(receiver_13, dot_product_0(receiver_13.normal_3, params_0.sun_direction_0));
    if(cos_theta_5 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    var from_emitters_0 : f32 = EmitterTree_importance_0(receiver_13);
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_5, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S329 : Selection_0;
    _S329.sun_0 = sun_1;
    _S329.sky_1 = sky_2;
    _S329.emitters_0 = emitters_1;
    return _S329;
}

fn Lights_sky_probability_0( receiver_14 : Receiver_0) -> f32
{
    var cos_theta_6 : f32 = dot_product_0(receiver_14.normal_3, params_0.sun_direction_0);
    var from_sun_1 : f32;
    if(has_sun_0())
    {
        from_sun_1 = params_0.sun_irradiance_0 * max(cos_theta_6, 0.0f);
    }
    else
    {
        from_sun_1 = 0.0f;
    }
    var from_others_0 : f32 = from_sun_1 + EmitterTree_importance_0(receiver_14);
    if(from_others_0 <= 0.0f)
    {
        return 1.0f;
    }
    return clamp(divide_0(params_0.sky_irradiance_0, params_0.sky_irradiance_0 + from_others_0), 0.25f, 0.75f);
}

fn Lights_selection_0( receiver_15 : Receiver_0) -> Selection_0
{
    var sun_2 : f32 = Lights_sun_probability_0(receiver_15);
    if(!Lights_has_chosen_sky_0())
    {
        return Selection_x24init_0(sun_2, 0.0f, 1.0f - sun_2);
    }
    var sky_3 : f32 = Lights_sky_probability_0(receiver_15);
    var _S330 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S330, sky_3, (1.0f - sun_2) * _S330);
}

fn MaterialBsdf_is_delta_0( this_34 : MaterialBsdf_0) -> bool
{
    return false;
}

var<private> first_candidates_0 : u32;

fn Path_dimension_light_0( this_35 : Path_0) -> u32
{
    return u32(2) + u32(2) * Path_events_0(this_35);
}

struct BsdfEval_0
{
     weight_3 : vec3<f32>,
     pdf_8 : f32,
};

struct Diffuse_0
{
     reflectance_0 : vec3<f32>,
};

fn Diffuse_x24init_0( reflectance_1 : vec3<f32>) -> Diffuse_0
{
    var _S331 : Diffuse_0;
    _S331.reflectance_0 = reflectance_1;
    return _S331;
}

fn cosine_hemisphere_pdf_0( cos_theta_7 : f32) -> f32
{
    return max(cos_theta_7, 0.0f) * 0.31830987334251404f;
}

fn BsdfEval_x24init_0( weight_4 : vec3<f32>,  pdf_9 : f32) -> BsdfEval_0
{
    var _S332 : BsdfEval_0;
    _S332.weight_3 = weight_4;
    _S332.pdf_8 = pdf_9;
    return _S332;
}

fn Diffuse_eval_0( this_36 : Diffuse_0,  wo_0 : vec3<f32>,  wi_0 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_36.reflectance_0, cosine_hemisphere_pdf_0(wi_0.z));
}

fn MaterialBsdf_eval_0( this_37 : MaterialBsdf_0,  wo_1 : vec3<f32>,  wi_1 : vec3<f32>) -> BsdfEval_0
{
    return Diffuse_eval_0(Diffuse_x24init_0(this_37.color_1), wo_1, wi_1);
}

fn choose_light_0( path_5 : Path_0,  receiver_16 : Receiver_0,  surface_1 : Surface_0,  bsdf_0 : MaterialBsdf_0,  wo_2 : vec3<f32>,  is_scattered_0 : bool,  compensation_0 : f32,  next_0 : ptr<function, NextRays_0>)
{
    var count_5 : u32;
    if((path_5.bounce_0) == u32(0))
    {
        count_5 = first_candidates_0;
    }
    else
    {
        count_5 = u32(1);
    }
    var chosen_4 : f32 = 0.0f;
    var candidate_0 : u32 = u32(0);
    var sum_4 : f32 = 0.0f;
    for(;;)
    {
        if(candidate_0 < count_5)
        {
        }
        else
        {
            break;
        }
        var dimension_3 : u32 = u32(1073741824) + u32(64) * Path_events_0(path_5) + u32(2) * candidate_0;
        var u_12 : vec4<f32>;
        if(candidate_0 == u32(0))
        {
            u_12 = Sampler_stratified_0(path_5.sampler_0, Path_dimension_light_0(path_5));
        }
        else
        {
            u_12 = Sampler_independent_0(path_5.sampler_0, dimension_3);
        }
        var light_5 : LightSample_0 = no_light_0();
        var is_found_5 : bool = Lights_sample_0(receiver_16, path_5.selection_0, u_12, by_chance_0(), &(light_5));
        if(!is_found_5)
        {
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var _S333 : vec3<f32> = vec3<f32>(Surface_local_direction_0(surface_1, light_5.ray_15.direction_0).xy, light_5.cos_theta_0);
        var wi_2 : vec3<f32>;
        if(is_scattered_0)
        {
            wi_2 = normalize_vector_0(light_5.ray_15.direction_0);
        }
        else
        {
            wi_2 = _S333;
        }
        var eval_0 : BsdfEval_0 = MaterialBsdf_eval_0(bsdf_0, wo_2, wi_2);
        var _S334 : vec3<f32> = path_5.beta_0 * eval_0.weight_3 * vec3<f32>(compensation_0) * light_5.radiance_1 * vec3<f32>((divide_0(eval_0.pdf_8, light_5.pdf_2) * power_heuristic_0(light_5.pdf_2, eval_0.pdf_8)));
        var weight_5 : f32 = luminance_0(_S334);
        var sum_5 : f32 = sum_4 + weight_5;
        var _S335 : bool;
        if(count_5 > u32(1))
        {
            _S335 = (Sampler_independent_0(path_5.sampler_0, dimension_3 + u32(1)).x * sum_5) >= weight_5;
        }
        else
        {
            _S335 = false;
        }
        if(_S335)
        {
            sum_4 = sum_5;
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var chosen_5 : f32;
        if(weight_5 > 0.0f)
        {
            (*next_0).shadow_direction_0 = light_5.ray_15.direction_0;
            (*next_0).shadow_t_max_0 = light_5.ray_15.t_max_0;
            (*next_0).light_3 = _S334;
            chosen_5 = weight_5;
        }
        else
        {
            chosen_5 = chosen_4;
        }
        chosen_4 = chosen_5;
        sum_4 = sum_5;
        candidate_0 = candidate_0 + u32(1);
    }
    var _S336 : bool = chosen_4 > 0.0f;
    (*next_0).has_shadow_ray_0 = _S336;
    if(_S336)
    {
        (*next_0).light_3 = (*next_0).light_3 * vec3<f32>(divide_0(sum_4, chosen_4 * f32(count_5)));
    }
    return;
}

struct BsdfSample_0
{
     wi_3 : vec3<f32>,
     weight_6 : vec3<f32>,
     pdf_10 : f32,
     is_delta_0 : bool,
};

fn cosine_hemisphere_0( u_13 : f32,  v_5 : f32) -> vec3<f32>
{
    var radius_3 : f32 = square_root_0(u_13);
    var sin_cos_2 : vec2<f32> = sincos_turns_0(v_5);
    return vec3<f32>(radius_3 * sin_cos_2.y, radius_3 * sin_cos_2.x, square_root_0(1.0f - u_13));
}

fn BsdfSample_x24init_0( wi_4 : vec3<f32>,  weight_7 : vec3<f32>,  pdf_11 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S337 : BsdfSample_0;
    _S337.wi_3 = wi_4;
    _S337.weight_6 = weight_7;
    _S337.pdf_10 = pdf_11;
    _S337.is_delta_0 = is_delta_1;
    return _S337;
}

fn Diffuse_sample_0( this_38 : Diffuse_0,  wo_3 : vec3<f32>,  u_14 : vec3<f32>,  sample_7 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_5 : vec3<f32> = cosine_hemisphere_0(u_14.x, u_14.y);
    (*sample_7) = BsdfSample_x24init_0(wi_5, this_38.reflectance_0, cosine_hemisphere_pdf_0(wi_5.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_39 : MaterialBsdf_0,  wo_4 : vec3<f32>,  u_15 : vec3<f32>,  sample_8 : ptr<function, BsdfSample_0>) -> bool
{
    var _S338 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_39.color_1), wo_4, u_15, &((*sample_8)));
    return _S338;
}

fn Surface_world_direction_0( this_40 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_40.face_5) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S339 : f32 = local_3.x;
    var _S340 : f32 = local_3.y;
    var _S341 : vec3<f32> = vec3<f32>(_S339, _S340, away_2);
    var in_grid_3 : vec3<f32>;
    if((this_40.face_5) < u32(2))
    {
        in_grid_3 = vec3<f32>(away_2, _S339, _S340);
    }
    else
    {
        if((this_40.face_5) < u32(4))
        {
            in_grid_3 = vec3<f32>(_S340, away_2, _S339);
        }
        else
        {
            in_grid_3 = _S341;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_3 = Transform_direction_1(this_40.instance_11, in_grid_3);
    }
    return normalize_vector_0(in_grid_3);
}

fn PathTracingOf_advance_0( path_6 : ptr<function, Path_0>,  ray_19 : Ray_0,  hit_6 : Hit_0,  beyond_3 : u32,  radiance_5 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_1 : NextRays_0 = no_rays_0();
    var is_counted_0 : bool = Path_is_counted_0((*path_6));
    var t_11 : f32;
    if(is_counted_0)
    {
        t_11 = - (*path_6).pdf_1;
    }
    else
    {
        t_11 = (*path_6).pdf_1;
    }
    (*path_6).pdf_1 = t_11;
    var last_5 : Receiver_0 = Path_receiver_0((*path_6), ray_19);
    var is_scattered_1 : bool;
    if(Inside_is_in_0((*path_6).inside_0))
    {
        is_scattered_1 = Hit_is_miss_0(hit_6);
    }
    else
    {
        is_scattered_1 = false;
    }
    if(Inside_is_in_0((*path_6).inside_0))
    {
        if(is_scattered_1)
        {
            t_11 = scattering_t_0((*path_6), (*path_6).inside_0, ray_19);
        }
        else
        {
            t_11 = hit_6.t_0;
        }
        if(!is_counted_0)
        {
            absorb_0(&((*path_6)), (*path_6).inside_0, ray_19, t_11);
        }
    }
    else
    {
        t_11 = hit_6.t_0;
    }
    var is_weighed_0 : bool;
    if(Hit_is_miss_0(hit_6))
    {
        is_weighed_0 = !is_scattered_1;
    }
    else
    {
        is_weighed_0 = false;
    }
    var light_pdf_1 : f32;
    if(is_weighed_0)
    {
        (*radiance_5) = (*radiance_5) + (*path_6).beta_0 * Sky_le_0(ray_19.direction_0) * vec3<f32>(mis_weight_0((*path_6).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_6), last_5), ray_19.direction_0)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_1 = true;
            }
            else
            {
                is_scattered_1 = !Path_is_straight_0((*path_6));
            }
        }
        else
        {
            is_scattered_1 = false;
        }
        if(is_scattered_1)
        {
            var le_0 : vec3<f32> = SunDisc_le_0(ray_19.direction_0);
            if((max_element_0(le_0)) > 0.0f)
            {
                if(((*path_6).pdf_1) == 0.0f)
                {
                    light_pdf_1 = 0.0f;
                }
                else
                {
                    light_pdf_1 = Lights_sun_pdf_0(Path_selection_at_0((*path_6), last_5), ray_19.direction_0);
                }
                (*radiance_5) = (*radiance_5) + (*path_6).beta_0 * le_0 * vec3<f32>(mis_weight_0((*path_6).pdf_1, light_pdf_1));
            }
        }
        return next_1;
    }
    var u_16 : vec4<f32> = Sampler_stratified_0((*path_6).sampler_0, Path_dimension_scatter_0((*path_6)));
    var material_8 : PackedMaterial_0 = material_met_0((*path_6), hit_6, beyond_3);
    var _S342 : vec3<f32> = vec3<f32>(0.0f);
    var le_1 : vec3<f32>;
    if(!is_counted_0)
    {
        le_1 = EmitterTree_le_0(material_8);
    }
    else
    {
        le_1 = _S342;
    }
    var is_lit_0 : bool = (max_element_0(le_1)) > 0.0f;
    var met_0 : Aim_0 = Aim_x24init_0(true, ray_19.direction_0, hit_6, luminance_0(vector_of_0(material_8.emission_0)));
    var _S343 : bool = weighs_apart_0();
    if(_S343)
    {
        is_weighed_0 = is_lit_0;
    }
    else
    {
        is_weighed_0 = false;
    }
    if(is_weighed_0)
    {
        is_weighed_0 = ((*path_6).pdf_1) > 0.0f;
    }
    else
    {
        is_weighed_0 = false;
    }
    var is_chosen_0 : bool;
    if(is_lit_0)
    {
        is_chosen_0 = !is_weighed_0;
    }
    else
    {
        is_chosen_0 = false;
    }
    if(is_chosen_0)
    {
        var light_6 : LightSample_0 = no_light_0();
        if(!_S343)
        {
            is_chosen_0 = ((*path_6).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_0 = false;
        }
        if(is_chosen_0)
        {
            var _S344 : bool = Lights_sample_0(last_5, Path_selection_at_0((*path_6), last_5), vec4<f32>(0.0f), met_0, &(light_6));
            is_chosen_0 = _S344;
        }
        else
        {
            is_chosen_0 = false;
        }
        var _S345 : vec3<f32> = (*path_6).beta_0 * le_1;
        var _S346 : f32 = (*path_6).pdf_1;
        if(is_chosen_0)
        {
            light_pdf_1 = light_6.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + _S345 * vec3<f32>(mis_weight_0(_S346, light_pdf_1));
    }
    var _S347 : f32 = ior_of_0((*path_6).inside_0);
    var _S348 : f32 = u_16[i32(3)];
    var _S349 : MaterialBsdf_0 = bsdf_of_0(material_8, _S347, &(_S348));
    u_16[i32(3)] = _S348;
    var scattered_2 : vec3<f32> = (*path_6).beta_0 * MaterialBsdf_albedo_0(_S349);
    var _S350 : bool = ((*path_6).bounce_0) >= (params_0.max_bounces_0);
    var _S351 : bool = !is_weighed_0;
    if(_S351)
    {
        if(_S350)
        {
            is_chosen_0 = true;
        }
        else
        {
            is_chosen_0 = (max_element_0(scattered_2)) <= 0.0f;
        }
    }
    else
    {
        is_chosen_0 = false;
    }
    if(is_chosen_0)
    {
        return next_1;
    }
    var compensation_1 : f32 = roulette_0(Path_events_0((*path_6)), scattered_2, u_16.z);
    if(_S351)
    {
        is_chosen_0 = compensation_1 == 0.0f;
    }
    else
    {
        is_chosen_0 = false;
    }
    if(is_chosen_0)
    {
        return next_1;
    }
    var at_6 : Hit_0;
    if(is_scattered_1)
    {
        at_6 = Hit_x24init_0(t_11, (*path_6).inside_0.instance_1, hit_6.voxel_1, u32(0));
    }
    else
    {
        at_6 = hit_6;
    }
    var surface_2 : Surface_0 = surface_of_0(ray_19, at_6);
    var _S352 : Receiver_0 = Receiver_x24init_0(surface_2.origin_10, surface_2.normal_5);
    var _S353 : vec3<f32> = (vec3<f32>(0) - ray_19.direction_0);
    var wo_5 : vec3<f32> = Surface_local_direction_0(surface_2, _S353);
    var inside_4 : Inside_0 = in_air_0();
    var wo_6 : vec3<f32>;
    var receiver_17 : Receiver_0;
    if(is_scattered_1)
    {
        var _S354 : Inside_0 = Inside_x24init_0((*path_6).inside_0.instance_1, hit_6.voxel_1, (*path_6).inside_0.material_0);
        inside_4 = _S354;
        var _S355 : vec3<f32> = normalize_vector_0(_S353);
        receiver_17 = Receiver_x24init_0(Inside_point_0(_S354, ray_19, t_11), _S342);
        wo_6 = _S355;
    }
    else
    {
        if(Inside_is_in_0((*path_6).inside_0))
        {
            next_1.relocates_2 = (hit_6.instance_3) != ((*path_6).inside_0.instance_1);
            inside_4 = Inside_x24init_0((*path_6).inside_0.instance_1, hit_6.voxel_1, (*path_6).inside_0.material_0);
            inside_4.voxel_0 = hit_6.voxel_1 + vec3<i32>(face_normal_0(hit_6.face_0));
        }
        receiver_17 = _S352;
        wo_6 = wo_5;
    }
    next_1.origin_8 = receiver_17.point_0;
    next_1.shadow_inside_2 = inside_4;
    if(is_weighed_0)
    {
        receiver_17 = last_5;
    }
    if(_S351)
    {
        (*path_6).selection_0 = Lights_selection_0(receiver_17);
    }
    var light_7 : LightSample_0 = no_light_0();
    var _S356 : bool = !MaterialBsdf_is_delta_0(_S349);
    if(_S356)
    {
        choose_light_0((*path_6), receiver_17, surface_2, _S349, wo_6, is_scattered_1, compensation_1, &(next_1));
    }
    if(is_weighed_0)
    {
        if(next_1.has_shadow_ray_0)
        {
            light_pdf_1 = light_7.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + (*path_6).beta_0 * le_1 * vec3<f32>(mis_weight_0((*path_6).pdf_1, light_pdf_1));
        (*path_6).pdf_1 = - (*path_6).pdf_1;
        next_1.is_same_0 = true;
        return next_1;
    }
    var bounce_1 : BsdfSample_0;
    var _S357 : bool = MaterialBsdf_sample_0(_S349, wo_6, vec3<f32>(u_16.xy, u_16.w), &(bounce_1));
    if(!_S357)
    {
        return next_1;
    }
    (*path_6).beta_0 = (*path_6).beta_0 * bounce_1.weight_6 * vec3<f32>(compensation_1);
    if(bounce_1.is_delta_0)
    {
        t_11 = 0.0f;
    }
    else
    {
        t_11 = bounce_1.pdf_10;
    }
    (*path_6).pdf_1 = t_11;
    (*path_6).normal_1 = receiver_17.normal_3;
    next_1.direction_6 = bounce_1.wi_3;
    if(!is_scattered_1)
    {
        next_1.direction_6 = Surface_world_direction_0(surface_2, bounce_1.wi_3);
    }
    next_1.path_relocates_2 = next_1.relocates_2;
    (*path_6).bounce_0 = (*path_6).bounce_0 + u32(1);
    return next_1;
}

fn shading_normal_0( ray_20 : Ray_0,  hit_7 : Hit_0,  material_9 : PackedMaterial_0) -> vec3<f32>
{
    return world_normal_0(hit_7.instance_3, hit_7.face_0);
}

fn albedo_of_0( material_10 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_10.base_color_0);
}

fn show_0( path_7 : Path_0,  ray_21 : Ray_0,  hit_8 : Hit_0,  beyond_4 : u32,  sample_9 : ptr<function, Sample_0>)
{
    var _S358 : Path_0 = path_7;
    (*sample_9).is_shown_0 = true;
    if(Inside_is_in_0(_S358.inside_0))
    {
        absorb_0(&(_S358), _S358.inside_0, ray_21, hit_8.t_0);
    }
    var material_11 : PackedMaterial_0 = material_met_0(_S358, hit_8, beyond_4);
    (*sample_9).normal_0 = shading_normal_0(ray_21, hit_8, material_11);
    (*sample_9).albedo_0 = _S358.beta_0 * albedo_of_0(material_11);
    return;
}

fn follow_0( start_4 : Walker_0,  camera_ray_0 : Ray_0) -> Sample_0
{
    var at_7 : Walker_0 = start_4;
    var sample_10 : Sample_0 = no_sample_0();
    var goes_on_0 : bool = true;
    for(;;)
    {
        if(goes_on_0)
        {
        }
        else
        {
            break;
        }
        var _S359 : Ray_0 = at_7.ray_0;
        var _S360 : Path_0 = at_7.path_0;
        var _S361 : Inside_0 = at_7.shadow_inside_0;
        var _S362 : bool = at_7.relocates_0;
        var _S363 : bool = at_7.path_relocates_0;
        var beyond_5 : u32;
        var _S364 : Hit_0 = hit_of_ray_0(start_4.path_0.sampler_0, &(_S359), at_7.is_shadow_ray_0, &(_S360), &(_S361), &(_S362), &(_S363), &(beyond_5));
        at_7.ray_0 = _S359;
        at_7.path_0 = _S360;
        at_7.shadow_inside_0 = _S361;
        at_7.relocates_0 = _S362;
        at_7.path_relocates_0 = _S363;
        if(at_7.is_shadow_ray_0)
        {
            if(Hit_is_miss_0(_S364))
            {
                sample_10.light_0 = sample_10.light_0 + at_7.light_1;
            }
            at_7.is_shadow_ray_0 = false;
            if(!at_7.is_shadow_ray_0)
            {
                at_7.ray_0 = ray_from_0(at_7.ray_0.origin_1, at_7.direction_1);
                goes_on_0 = (any(((at_7.direction_1) != vec3<f32>(0.0f))));
            }
            continue;
        }
        at_7.path_0.sampler_0 = start_4.path_0.sampler_0;
        var arrived_0 : Path_0 = at_7.path_0;
        var _S365 : vec3<f32> = vec3<f32>(0.0f);
        var emitted_1 : vec3<f32> = _S365;
        var _S366 : Path_0 = at_7.path_0;
        var next_2 : NextRays_0 = PathTracingOf_advance_0(&(_S366), at_7.ray_0, _S364, beyond_5, &(emitted_1));
        at_7.path_0 = _S366;
        var goes_on_1 : bool = (any(((next_2.direction_6) != _S365)));
        if(at_7.has_shown_0)
        {
            sample_10.light_0 = sample_10.light_0 + emitted_1;
        }
        else
        {
            sample_10.direct_0 = sample_10.direct_0 + emitted_1;
            var _S367 : bool = (at_7.path_0.bounce_0) == u32(0);
            var _S368 : bool;
            if(goes_on_1)
            {
                _S368 = _S367;
            }
            else
            {
                _S368 = false;
            }
            var _S369 : bool = !_S368;
            at_7.has_shown_0 = _S369;
            if(!_S369)
            {
                at_7.way_0 = at_7.way_0 + _S364.t_0;
            }
            else
            {
                if(!Hit_is_miss_0(_S364))
                {
                    show_0(arrived_0, at_7.ray_0, _S364, beyond_5, &(sample_10));
                    sample_10.place_0 = camera_ray_0.origin_1 + camera_ray_0.direction_0 * vec3<f32>((at_7.way_0 + _S364.t_0));
                    var _S370 : u32;
                    if((at_7.way_0) > 0.0f)
                    {
                        _S370 = u32(4294967295);
                    }
                    else
                    {
                        _S370 = _S364.instance_3;
                    }
                    sample_10.instance_0 = _S370;
                }
            }
            if(at_7.has_shown_0)
            {
                break;
            }
        }
        at_7.direction_1 = next_2.direction_6;
        at_7.light_1 = next_2.light_3;
        at_7.is_shadow_ray_0 = next_2.has_shadow_ray_0;
        at_7.path_origin_0 = next_2.path_origin_1;
        at_7.ray_0 = ray_from_0(next_2.origin_8, next_2.direction_6);
        if(at_7.is_shadow_ray_0)
        {
            at_7.ray_0 = Ray_x24init_0(next_2.origin_8, 0.0f, next_2.shadow_direction_0, next_2.shadow_t_max_0);
            goes_on_0 = true;
        }
        else
        {
            goes_on_0 = goes_on_1;
        }
    }
    return sample_10;
}

fn Walk_enter_rounded_1( this_41 : Walk_0,  voxel_20 : ptr<function, vec3<i32>>,  near_3 : vec3<i32>,  far_4 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_1 : vec3<bool> = (*voxel_20) < near_3;
        if(!(any((is_before_1))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_41.speed_1) <= vec3<f32>(min_abs_direction_0()), is_before_1)))))
        {
            return false;
        }
        var t_12 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_41, near_3), is_before_1);
        var t_last_1 : f32 = max_element_0(t_12);
        if(t_last_1 > (this_41.t_end_0))
        {
            return false;
        }
        var is_x_3 : bool = (t_12.x) == t_last_1;
        var _S371 : bool = !is_x_3;
        var is_y_3 : bool;
        if(_S371)
        {
            is_y_3 = (t_12.y) == t_last_1;
        }
        else
        {
            is_y_3 = false;
        }
        var _S372 : bool;
        if(_S371)
        {
            _S372 = !is_y_3;
        }
        else
        {
            _S372 = false;
        }
        var is_axis_3 : vec3<bool> = vec3<bool>(is_x_3, is_y_3, _S372);
        (*voxel_20) = Walk_arrive_0(this_41, (*voxel_20), t_last_1, is_axis_3, select(vec3<i32>(i32(1073741823)), near_3, is_axis_3));
    }
    return (all(((*voxel_20) < far_4)));
}

fn Walk_enter_1( this_42 : Walk_0,  voxel_21 : ptr<function, vec3<i32>>,  low_13 : vec3<i32>,  high_6 : vec3<i32>) -> bool
{
    var _S373 : bool;
    var is_mirrored_2 : vec3<bool> = (this_42.mirror_0) != vec3<i32>(i32(0));
    var near_4 : vec3<i32> = select(low_13, (vec3<i32>(0) - high_6), is_mirrored_2);
    var far_5 : vec3<i32> = select(high_6, (vec3<i32>(0) - low_13), is_mirrored_2);
    if(!IS_EXACT_0)
    {
        var _S374 : bool = Walk_enter_rounded_1(this_42, &((*voxel_21)), near_4, far_5);
        return _S374;
    }
    var axis_6 : u32 = u32(0);
    for(;;)
    {
        if(axis_6 < u32(3))
        {
            _S373 = (any(((*voxel_21) < near_4)));
        }
        else
        {
            _S373 = false;
        }
        var _S375 : bool;
        if(_S373)
        {
            _S375 = (all(((*voxel_21) < far_5)));
        }
        else
        {
            _S375 = false;
        }
        if(_S375)
        {
        }
        else
        {
            break;
        }
        var _S376 : bool = Walk_leave_1(this_42, &((*voxel_21)), select(far_5, near_4, (*voxel_21) < near_4));
        if(!_S376)
        {
            return false;
        }
        axis_6 = axis_6 + u32(1);
    }
    if((all(((*voxel_21) >= near_4))))
    {
        _S373 = (all(((*voxel_21) < far_5)));
    }
    else
    {
        _S373 = false;
    }
    return _S373;
}

fn Walk_leave_rounded_1( this_43 : Walk_0,  voxel_22 : ptr<function, vec3<i32>>,  exit_6 : vec3<i32>) -> bool
{
    var t_13 : vec3<f32> = Walk_crossings_0(this_43, exit_6);
    var t_first_3 : f32 = min_element_0(t_13);
    if(t_first_3 >= (this_43.t_end_0))
    {
        return false;
    }
    (*voxel_22) = max(exit_6 - vec3<i32>(ceil((t_13 - vec3<f32>(t_first_3)) * this_43.speed_1)), (*voxel_22));
    return true;
}

fn Walk_leave_2( this_44 : Walk_0,  voxel_23 : ptr<function, vec3<i32>>,  exit_7 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S377 : bool = Walk_leave_rounded_1(this_44, &((*voxel_23)), exit_7);
        return _S377;
    }
    var t_14 : vec3<f32> = Walk_crossings_0(this_44, exit_7);
    var t_first_4 : f32 = min_element_0(t_14);
    if(t_first_4 > (this_44.t_end_0))
    {
        return false;
    }
    var is_x_4 : bool = (t_14.x) == t_first_4;
    var _S378 : bool = !is_x_4;
    var is_y_4 : bool;
    if(_S378)
    {
        is_y_4 = (t_14.y) == t_first_4;
    }
    else
    {
        is_y_4 = false;
    }
    var back_2 : vec3<f32> = (t_14 - vec3<f32>(t_first_4)) * this_44.speed_1;
    var nearest_8 : vec3<f32> = round(back_2);
    var from_nearest_4 : vec3<f32> = back_2 - nearest_8;
    var planes_4 : vec3<i32> = exit_7 - vec3<i32>(min(nearest_8, vec3<f32>(4.194304e+06f)));
    var _S379 : vec3<i32> = planes_4 - vec3<i32>(from_nearest_4 > vec3<f32>(0.0f));
    var _S380 : vec3<bool> = (abs(from_nearest_4)) <= (this_44.tolerance_0);
    var _S381 : bool;
    if(_S378)
    {
        _S381 = !is_y_4;
    }
    else
    {
        _S381 = false;
    }
    var arrival_3 : vec3<i32>;
    if((any((select(vec3<bool>(false), !vec3<bool>(is_x_4, is_y_4, _S381), _S380)))))
    {
        arrival_3 = Walk_mirrored_0(this_44, leave_box_0(this_44.ray_1, Walk_mirrored_0(this_44, (*voxel_23)) + this_44.grid_origin_0, Walk_mirrored_plane_0(this_44, exit_7) + this_44.grid_origin_0, Walk_mirrored_plane_0(this_44, planes_4) + this_44.grid_origin_0) - this_44.grid_origin_0);
    }
    else
    {
        arrival_3 = _S379;
    }
    (*voxel_23) = select(max(arrival_3, (*voxel_23)), (*voxel_23), (this_44.speed_1) == vec3<f32>(0.0f));
    return true;
}

fn first_voxel_1( _S382 : u32,  _S383 : Walk_0,  _S384 : ptr<function, vec3<i32>>) -> bool
{
    var _S385 : Walk_0 = _S383;
    var _S386 : vec3<i32> = vec3<i32>(i32(0));
    (*_S384) = _S386;
    var voxel_24 : vec3<i32> = Walk_start_voxel_0(_S383);
    var _S387 : bool = Walk_enter_1(_S383, &(voxel_24), cell_of_0(grids_0[_S382].min_1) - _S385.grid_origin_0, cell_of_0(grids_0[_S382].max_1) - _S385.grid_origin_0);
    if(!_S387)
    {
        return false;
    }
    var octant_4 : u32 = LocalRay_octant_0(_S385.ray_1);
    var _S388 : u32 = flip_of_0(octant_4);
    var top_shift_3 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_3 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_3 = grids_0[_S382].top_shift_0;
    }
    var top_size_2 : vec3<i32> = cell_of_0(grids_0[_S382].top_size_0);
    var _S389 : i32 = top_size_2.x;
    var stride_1 : vec3<i32> = vec3<i32>(i32(1), _S389, _S389 * top_size_2.y);
    var _S390 : i32 = i32(grids_0[_S382].top_offset_0) - dot_cells_0((stride_1 & ((_S385.mirror_0))), vec3<i32>(i32(1)));
    var _S391 : vec3<i32> = Walk_mirrored_plane_0(_S385, stride_1);
    var _S392 : u32 = ahead_of_0(_S385.mirror_0);
    var end_2 : vec3<i32> = select((top_size_2 << (vec3<u32>(top_shift_3))), _S386, (_S385.mirror_0) != _S386);
    if(!IS_EXACT_0)
    {
        _S385.t_end_0 = min(_S385.t_end_0, min_element_0(Walk_crossings_0(_S385, end_2)));
    }
    var is_found_6 : bool = false;
    for(;;)
    {
        var _S393 : bool;
        if(IS_EXACT_0)
        {
            _S393 = (any((voxel_24 >= end_2)));
        }
        else
        {
            _S393 = false;
        }
        if(_S393)
        {
            break;
        }
        var cell_8 : u32 = cell_word_0(u32(_S390 + dot_cells_0(_S391, (voxel_24 >> (vec3<u32>(top_shift_3))))));
        var cell_9 : u32;
        var shift_6 : u32;
        var is_found_7 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_8 & (u32(2147483648)))) != u32(0))
            {
                var _S394 : u32 = cell_word_0(((cell_8 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, u32(3))) ^ (_S388))));
                cell_9 = _S394;
                shift_6 = u32(3);
            }
            else
            {
                cell_9 = cell_8;
                shift_6 = top_shift_3;
            }
        }
        else
        {
            cell_9 = cell_8;
            shift_6 = top_shift_3;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_7 = shift_6 > u32(3);
                }
                else
                {
                    is_found_7 = false;
                }
                var _S395 : bool;
                if(is_found_7)
                {
                    _S395 = ((cell_9 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S395 = false;
                }
                if(_S395)
                {
                }
                else
                {
                    break;
                }
                var shift_7 : u32 = shift_6 - u32(2);
                var _S396 : u32 = cell_word_0(((cell_9 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, shift_7)) ^ (_S388))));
                cell_9 = _S396;
                shift_6 = shift_7;
            }
        }
        if(waits_for_pages_0())
        {
            break;
        }
        var exit_8 : vec3<i32>;
        if(((cell_9 & (u32(2147483648)))) == u32(0))
        {
            if(CELLS_SKIP_0)
            {
                exit_8 = vec3<i32>((i32(skip_distance_0(cell_9, octant_4)) - i32(1)));
            }
            else
            {
                exit_8 = extents_0(cell_9, _S392);
            }
            exit_8 = ((voxel_24 | (vec3<i32>((((i32(1) << (shift_6))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_8 << (vec3<u32>(shift_6))));
            is_found_7 = is_found_6;
        }
        else
        {
            var record_4 : u32 = record_of_cell_0(cell_9);
            var blocks_2 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_2 = blocks_of_cell_0(cell_9);
            }
            else
            {
                var _S397 : u32 = blocks_of_record_0(record_4);
                blocks_2 = _S397;
            }
            var low_bits_1 : u32 = empty_around_0(record_4, blocks_2, voxel_24, octant_4, _S388);
            var is_found_8 : bool = low_bits_1 == u32(4294967295);
            if(is_found_8)
            {
                is_found_6 = is_found_8;
                break;
            }
            exit_8 = ((voxel_24 | (vec3<i32>(i32(low_bits_1))))) + vec3<i32>(i32(1));
            is_found_7 = is_found_8;
        }
        var _S398 : bool = Walk_leave_2(_S385, &(voxel_24), exit_8);
        if(!_S398)
        {
            is_found_6 = is_found_7;
            break;
        }
        is_found_6 = is_found_7;
    }
    (*_S384) = Walk_mirrored_0(_S385, voxel_24) + _S385.grid_origin_0;
    return is_found_6;
}

fn hit_in_1( instance_12 : u32,  ray_22 : ptr<function, Ray_0>) -> Hit_0
{
    var _S399 : LocalRay_0 = local_ray_0((*ray_22), instance_12);
    if(!_S399.is_valid_0)
    {
        return miss_0();
    }
    var _S400 : Walk_0 = walk_of_0(_S399, instances_0[instance_12].grid_0);
    var voxel_25 : vec3<i32>;
    var _S401 : bool = first_voxel_1(instances_0[instance_12].grid_0, _S400, &(voxel_25));
    var _S402 : bool;
    if(IS_SINGLE_0)
    {
        _S402 = !IS_EXACT_0;
    }
    else
    {
        _S402 = false;
    }
    if(_S402)
    {
        (*ray_22) = ray_of_walk_0(_S400, (*ray_22));
    }
    if(!_S401)
    {
        return miss_0();
    }
    var hit_9 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_9 = hit_of_0(_S399, voxel_25, instance_12);
    }
    else
    {
        hit_9 = hit_of_walk_0(_S400, voxel_25, instance_12);
    }
    if((hit_9.t_0) > ((*ray_22).t_max_0))
    {
        return miss_0();
    }
    return hit_9;
}

fn visit_1( given_1 : ptr<function, Ray_0>,  is_any_enough_2 : bool,  end_3 : u32) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S403 : Hit_0 = hit_in_1(u32(0), &((*given_1)));
        return _S403;
    }
    var ray_23 : Ray_0 = (*given_1);
    var nearest_9 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_9;
    }
    var is_zero_2 : vec3<bool> = !((abs(ray_23.direction_0)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S404 : vec3<f32> = select(reciprocal_0(select(ray_23.direction_0, vec3<f32>(1.0f), is_zero_2)), vec3<f32>(3.4028234663852886e+38f), is_zero_2);
    var stack_1 : array<u32, i32(32)>;
    var index_29 : u32 = u32(0);
    var nearest_10 : Hit_0 = nearest_9;
    var depth_3 : u32 = u32(0);
    for(;;)
    {
        var depth_4 : u32;
        var is_reached_1 : bool;
        if((instance_nodes_0[index_29].is_leaf_0) != u32(0))
        {
            var _S405 : Hit_0 = hit_in_1(instance_nodes_0[index_29].index_0, &(ray_23));
            var _S406 : Hit_0 = nearest_10;
            if((_S405.t_0) < (nearest_10.t_0))
            {
                is_reached_1 = true;
            }
            else
            {
                if((_S405.t_0) == (_S406.t_0))
                {
                    is_reached_1 = (_S405.instance_3) < (nearest_10.instance_3);
                }
                else
                {
                    is_reached_1 = false;
                }
            }
            var nearest_11 : Hit_0;
            if(is_reached_1)
            {
                ray_23.t_max_0 = _S405.t_0;
                if(is_any_enough_2)
                {
                    return _S405;
                }
                nearest_11 = _S405;
            }
            else
            {
                nearest_11 = nearest_10;
            }
            nearest_10 = nearest_11;
            depth_4 = depth_3;
        }
        else
        {
            var _S407 : u32 = index_29 + u32(1);
            var _S408 : f32 = entry_0(_S407, ray_23, _S404);
            var _S409 : u32 = instance_nodes_0[index_29].index_0;
            var _S410 : f32 = entry_0(instance_nodes_0[index_29].index_0, ray_23, _S404);
            var _S411 : bool = _S408 <= _S410;
            if(_S411)
            {
                index_29 = _S407;
            }
            else
            {
                index_29 = _S409;
            }
            var far_6 : u32;
            if(_S411)
            {
                far_6 = _S409;
            }
            else
            {
                far_6 = _S407;
            }
            var INFINITY_1 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S408, _S410)) < INFINITY_1)
            {
                var _S412 : u32 = depth_3 + u32(1);
                stack_1[depth_3] = far_6;
                depth_4 = _S412;
            }
            else
            {
                depth_4 = depth_3;
            }
            if((min(_S408, _S410)) < INFINITY_1)
            {
                depth_3 = depth_4;
                continue;
            }
        }
        is_reached_1 = false;
        depth_3 = depth_4;
        for(;;)
        {
            var _S413 : bool;
            if(depth_3 > u32(0))
            {
                _S413 = !is_reached_1;
            }
            else
            {
                _S413 = false;
            }
            if(_S413)
            {
            }
            else
            {
                break;
            }
            var depth_5 : u32 = depth_3 - u32(1);
            is_reached_1 = (entry_0(stack_1[depth_5], ray_23, _S404)) < (bitcast<f32>((u32(2139095040))));
            index_29 = stack_1[depth_5];
            depth_3 = depth_5;
        }
        if(!is_reached_1)
        {
            break;
        }
    }
    return nearest_10;
}

struct CameraFrame_0
{
     lens_1 : u32,
     eye_2 : vec3<f32>,
     corner_2 : vec3<f32>,
     pixel_x_1 : vec3<f32>,
     pixel_y_1 : vec3<f32>,
     lens_x_1 : vec3<f32>,
     lens_y_1 : vec3<f32>,
     blades_1 : u32,
};

fn PathTracingOf_jitter_0( sampler_2 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_2, u32(0));
}

struct Perspective_0
{
     eye_3 : vec3<f32>,
     corner_3 : vec3<f32>,
     pixel_x_2 : vec3<f32>,
     pixel_y_2 : vec3<f32>,
};

fn Perspective_x24init_0( eye_4 : vec3<f32>,  corner_4 : vec3<f32>,  pixel_x_3 : vec3<f32>,  pixel_y_3 : vec3<f32>) -> Perspective_0
{
    var _S414 : Perspective_0;
    _S414.eye_3 = eye_4;
    _S414.corner_3 = corner_4;
    _S414.pixel_x_2 = pixel_x_3;
    _S414.pixel_y_2 = pixel_y_3;
    return _S414;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_3 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_4 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S415 : Axes_0;
    _S415.forward_0 = forward_1;
    _S415.right_3 = right_4;
    _S415.up_0 = up_1;
    return _S415;
}

struct ThinLens_0
{
     perspective_0 : Perspective_0,
     lens_x_2 : vec3<f32>,
     lens_y_2 : vec3<f32>,
     blades_2 : u32,
};

fn ThinLens_x24init_0( perspective_1 : Perspective_0,  lens_x_3 : vec3<f32>,  lens_y_3 : vec3<f32>,  blades_3 : u32) -> ThinLens_0
{
    var _S416 : ThinLens_0;
    _S416.perspective_0 = perspective_1;
    _S416.lens_x_2 = lens_x_3;
    _S416.lens_y_2 = lens_y_3;
    _S416.blades_2 = blades_3;
    return _S416;
}

fn concentric_0( square_1 : vec2<f32>) -> vec2<f32>
{
    var a_7 : f32 = 2.0f * square_1.x - 1.0f;
    var b_7 : f32 = 2.0f * square_1.y - 1.0f;
    var _S417 : bool;
    if(a_7 == 0.0f)
    {
        _S417 = b_7 == 0.0f;
    }
    else
    {
        _S417 = false;
    }
    if(_S417)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_7)) > (abs(b_7));
    var radius_4 : f32;
    if(is_across_0)
    {
        radius_4 = a_7;
    }
    else
    {
        radius_4 = b_7;
    }
    var turns_3 : f32;
    if(is_across_0)
    {
        turns_3 = divide_0(b_7, a_7) * 0.125f;
    }
    else
    {
        turns_3 = 0.25f - divide_0(a_7, b_7) * 0.125f;
    }
    if(radius_4 < 0.0f)
    {
        turns_3 = turns_3 + 0.5f;
    }
    var _S418 : f32 = abs(radius_4);
    if(turns_3 < 0.0f)
    {
        radius_4 = turns_3 + 1.0f;
    }
    else
    {
        radius_4 = turns_3;
    }
    return vec2<f32>(_S418, radius_4);
}

fn place_in_aperture_0( blades_4 : u32,  lens_2 : vec2<f32>) -> vec2<f32>
{
    var radius_turns_0 : vec2<f32> = concentric_0(lens_2);
    var radius_5 : f32 = radius_turns_0.x;
    if(blades_4 == u32(0))
    {
        var sin_cos_3 : vec2<f32> = sincos_turns_0(radius_turns_0.y);
        return vec2<f32>(radius_5 * sin_cos_3.y, radius_5 * sin_cos_3.x);
    }
    var count_6 : f32 = f32(blades_4);
    var scaled_0 : f32 = radius_turns_0.y * count_6;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_4 - u32(1)));
    var share_7 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_6));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_6));
    var _S419 : f32 = from_0.y;
    var _S420 : f32 = from_0.x;
    return vec2<f32>(_S419 + (to_0.y - _S419) * share_7, _S420 + (to_0.x - _S420) * share_7) * vec2<f32>(radius_5);
}

fn ThinLens_ray_0( this_45 : ThinLens_0,  position_3 : vec2<f32>,  lens_3 : vec2<f32>) -> Ray_0
{
    var place_5 : vec2<f32> = place_in_aperture_0(this_45.blades_2, lens_3);
    var offset_1 : vec3<f32> = this_45.lens_x_2 * vec3<f32>(place_5.x) + this_45.lens_y_2 * vec3<f32>(place_5.y);
    return ray_from_0(this_45.perspective_0.eye_3 + offset_1, normalize_vector_0(this_45.perspective_0.corner_3 + this_45.perspective_0.pixel_x_2 * vec3<f32>(position_3.x) + this_45.perspective_0.pixel_y_2 * vec3<f32>(position_3.y) - offset_1));
}

struct Orthographic_0
{
     corner_5 : vec3<f32>,
     pixel_x_4 : vec3<f32>,
     pixel_y_4 : vec3<f32>,
     forward_2 : vec3<f32>,
};

fn Orthographic_x24init_0( corner_6 : vec3<f32>,  pixel_x_5 : vec3<f32>,  pixel_y_5 : vec3<f32>,  forward_3 : vec3<f32>) -> Orthographic_0
{
    var _S421 : Orthographic_0;
    _S421.corner_5 = corner_6;
    _S421.pixel_x_4 = pixel_x_5;
    _S421.pixel_y_4 = pixel_y_5;
    _S421.forward_2 = forward_3;
    return _S421;
}

fn Orthographic_ray_0( this_46 : Orthographic_0,  position_4 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_46.corner_5 + this_46.pixel_x_4 * vec3<f32>(position_4.x) + this_46.pixel_y_4 * vec3<f32>(position_4.y), this_46.forward_2);
}

struct Panorama_0
{
     eye_5 : vec3<f32>,
     axes_1 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_6 : vec3<f32>,  axes_2 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S422 : Panorama_0;
    _S422.eye_5 = eye_6;
    _S422.axes_1 = axes_2;
    _S422.inverse_size_0 = inverse_size_1;
    _S422.half_eye_distance_0 = half_eye_distance_1;
    return _S422;
}

fn Panorama_ray_0( this_47 : Panorama_0,  position_5 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_5.y * this_47.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_4 : f32;
    if(is_right_eye_0)
    {
        side_4 = this_47.half_eye_distance_0;
    }
    else
    {
        side_4 = - this_47.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_5.x * this_47.inverse_size_0.x);
    var height_2 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S423 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S424 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_47.eye_5 + (this_47.axes_1.forward_0 * _S424 - this_47.axes_1.right_3 * _S423) * vec3<f32>(side_4), normalize_vector_0((vec3<f32>(0) - this_47.axes_1.forward_0 * _S423 + this_47.axes_1.right_3 * _S424) * vec3<f32>(height_2.x) + this_47.axes_1.up_0 * vec3<f32>(height_2.y)));
}

struct Fisheye_0
{
     eye_7 : vec3<f32>,
     axes_3 : Axes_0,
     middle_1 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_8 : vec3<f32>,  axes_4 : Axes_0,  middle_2 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S425 : Fisheye_0;
    _S425.eye_7 = eye_8;
    _S425.axes_3 = axes_4;
    _S425.middle_1 = middle_2;
    _S425.turns_per_pixel_0 = turns_per_pixel_1;
    return _S425;
}

fn Fisheye_ray_0( this_48 : Fisheye_0,  position_6 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var x_10 : f32 = position_6.x - this_48.middle_1.x;
    var y_5 : f32 = position_6.y - this_48.middle_1.y;
    var radius_6 : f32 = square_root_0(x_10 * x_10 + y_5 * y_5);
    var sin_cos_4 : vec2<f32> = sincos_turns_0(min(radius_6 * this_48.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_6 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_4.x, radius_6);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_48.eye_7, normalize_vector_0(this_48.axes_3.forward_0 * vec3<f32>(sin_cos_4.y) + this_48.axes_3.right_3 * vec3<f32>((x_10 * scale_0)) - this_48.axes_3.up_0 * vec3<f32>((y_5 * scale_0))));
}

fn Perspective_ray_0( this_49 : Perspective_0,  position_7 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_49.eye_3, normalize_vector_0(this_49.corner_3 + this_49.pixel_x_2 * vec3<f32>(position_7.x) + this_49.pixel_y_2 * vec3<f32>(position_7.y)));
}

fn CameraFrame_ray_0( this_50 : CameraFrame_0,  position_8 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_50.eye_2, this_50.corner_2, this_50.pixel_x_1, this_50.pixel_y_1);
    var axes_5 : Axes_0 = Axes_x24init_0(this_50.corner_2, this_50.pixel_x_1, this_50.pixel_y_1);
    switch(this_50.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_50.lens_x_1, this_50.lens_y_1, this_50.blades_1), position_8, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_50.corner_2, this_50.pixel_x_1, this_50.pixel_y_1, this_50.lens_x_1), position_8, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_50.eye_2, axes_5, this_50.lens_x_1.xy, this_50.lens_x_1.z), position_8, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_50.eye_2, axes_5, this_50.lens_x_1.xy, this_50.lens_x_1.z), position_8, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_8, lens_sample_0);
        }
    }
}

fn Path_x24init_0( sampler_3 : Sampler_0,  bounce_2 : u32,  event_2 : u32,  kinds_1 : u32,  scattered_3 : u32,  beta_1 : vec3<f32>,  pdf_12 : f32,  normal_6 : vec3<f32>,  selection_4 : Selection_0,  passed_t_1 : f32,  inside_5 : Inside_0,  is_clipped_1 : bool) -> Path_0
{
    var _S426 : Path_0;
    _S426.sampler_0 = sampler_3;
    _S426.bounce_0 = bounce_2;
    _S426.event_0 = event_2;
    _S426.kinds_0 = kinds_1;
    _S426.scattered_0 = scattered_3;
    _S426.beta_0 = beta_1;
    _S426.pdf_1 = pdf_12;
    _S426.normal_1 = normal_6;
    _S426.selection_0 = selection_4;
    _S426.passed_t_0 = passed_t_1;
    _S426.inside_0 = inside_5;
    _S426.is_clipped_0 = is_clipped_1;
    return _S426;
}

fn path_from_0( sampler_4 : Sampler_0) -> Path_0
{
    return Path_x24init_0(sampler_4, u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
}

fn Walker_x24init_0( path_8 : Path_0,  ray_24 : Ray_0,  is_shadow_ray_2 : bool,  light_8 : vec3<f32>,  direction_28 : vec3<f32>,  path_origin_3 : vec3<f32>,  shadow_inside_4 : Inside_0,  boundaries_1 : u32,  relocates_4 : bool,  path_relocates_4 : bool,  way_6 : f32,  has_shown_1 : bool,  asks_cache_1 : bool,  life_1 : u32) -> Walker_0
{
    var _S427 : Walker_0;
    _S427.path_0 = path_8;
    _S427.ray_0 = ray_24;
    _S427.is_shadow_ray_0 = is_shadow_ray_2;
    _S427.light_1 = light_8;
    _S427.direction_1 = direction_28;
    _S427.path_origin_0 = path_origin_3;
    _S427.shadow_inside_0 = shadow_inside_4;
    _S427.boundaries_0 = boundaries_1;
    _S427.relocates_0 = relocates_4;
    _S427.path_relocates_0 = path_relocates_4;
    _S427.way_0 = way_6;
    _S427.has_shown_0 = has_shown_1;
    _S427.asks_cache_0 = asks_cache_1;
    _S427.life_0 = life_1;
    return _S427;
}

fn sample_of_0( pixel_1 : vec2<u32>,  camera_0 : CameraFrame_0,  sampler_5 : Sampler_0,  asks_cache_2 : bool) -> Sample_0
{
    first_candidates_0 = u32(0);
    var jitter_0 : vec4<f32> = PathTracingOf_jitter_0(sampler_5);
    var camera_ray_1 : Ray_0 = CameraFrame_ray_0(camera_0, vec2<f32>(pixel_1) + jitter_0.xy, jitter_0.zw);
    var _S428 : vec3<f32> = vec3<f32>(0.0f);
    var _S429 : Sample_0 = follow_0(Walker_x24init_0(path_from_0(sampler_5), camera_ray_1, false, _S428, _S428, _S428, in_air_0(), u32(0), true, true, 0.0f, false, asks_cache_2, u32(10)), camera_ray_1);
    return _S429;
}

fn WalkTracer_trace_1( ray_25 : ptr<function, Ray_0>,  is_any_enough_3 : bool) -> Hit_0
{
    var _S430 : Hit_0 = visit_1(&((*ray_25)), is_any_enough_3, u32(0));
    return _S430;
}

fn hit_of_ray_1( sampler_6 : Sampler_0,  ray_26 : ptr<function, Ray_0>,  is_shadow_ray_3 : bool,  path_9 : ptr<function, Path_0>,  shadow_inside_5 : ptr<function, Inside_0>,  relocates_5 : ptr<function, bool>,  path_relocates_5 : ptr<function, bool>,  beyond_6 : ptr<function, u32>) -> Hit_0
{
    (*beyond_6) = u32(4294967295);
    var _S431 : Hit_0 = WalkTracer_trace_1(&((*ray_26)), is_shadow_ray_3);
    return _S431;
}

struct Key_0
{
     instance_13 : u32,
     face_and_level_0 : u32,
     cube_0 : vec3<i32>,
};

fn Key_x24init_0( instance_14 : u32,  face_and_level_1 : u32,  cube_1 : vec3<i32>) -> Key_0
{
    var _S432 : Key_0;
    _S432.instance_13 = instance_14;
    _S432.face_and_level_0 = face_and_level_1;
    _S432.cube_0 = cube_1;
    return _S432;
}

fn scramble_of_0( number_1 : u32) -> u32
{
    return pcg4d_0(vec4<u32>(number_1, u32(0), u32(0), u32(2654435769))).x;
}

fn Key_level_0( this_51 : Key_0) -> u32
{
    return ((this_51.face_and_level_0) >> (u32(3)));
}

fn Key_mask_0( this_52 : Key_0) -> u32
{
    return ((u32(1) << ((u32(3) * Key_level_0(this_52))))) - u32(1);
}

fn key_of_0( hit_10 : Hit_0,  size_1 : f32,  u_17 : f32,  code_1 : ptr<function, u32>) -> Key_0
{
    var clamped_0 : f32 = clamp(size_1, 1.0f, 128.0f);
    var power_5 : f32 = f32(((bitcast<u32>((clamped_0))) >> (u32(23)))) - 127.0f;
    var _S433 : f32;
    if(u_17 < (clamped_0 * inverse_power_of_two_0(clamped_0) - 1.0f))
    {
        _S433 = 1.0f;
    }
    else
    {
        _S433 = 0.0f;
    }
    var level_0 : u32 = u32(min(power_5 + _S433, 6.0f));
    var _S434 : vec3<u32> = vec3<u32>(u32(i32(level_0)));
    var key_0 : Key_0 = Key_x24init_0(hit_10.instance_3, ((hit_10.face_0) | (((level_0 << (u32(3)))))), ((hit_10.voxel_1) >> (_S434)));
    var _S435 : vec3<u32> = vec3<u32>(hit_10.voxel_1 - (((key_0.cube_0) << (_S434))));
    (*code_1) = u32(1) + (((((((_S435.x) | ((((_S435.y) << (level_0)))))) | ((((_S435.z) << ((u32(2) * level_0))))))) ^ ((((scramble_of_0(real_time_0.number_0)) & ((Key_mask_0(key_0))))))));
    return key_0;
}

fn Key_hash_0( this_53 : Key_0) -> vec2<u32>
{
    return pcg4d_0(vec4<u32>(vec3<u32>(this_53.cube_0), this_53.instance_13 * u32(61) + this_53.face_and_level_0)).xy;
}

fn place_of_check_0( cell_10 : u32) -> u32
{
    return u32(16) + cell_10;
}

fn find_cell_0( hash_0 : vec2<u32>) -> u32
{
    var probe_0 : u32 = u32(0);
    for(;;)
    {
        if(probe_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var cell_11 : u32 = ((hash_0.x + probe_0) & (u32(262143)));
        var _S436 : u32 = atomicLoad(&(cell_keys_0[place_of_check_0(cell_11)]));
        if(_S436 == (max(hash_0.y, u32(1))))
        {
            return cell_11;
        }
        probe_0 = probe_0 + u32(1);
    }
    return u32(262144);
}

fn cell_row_0( row_0 : u32,  cell_12 : u32) -> vec4<u32>
{
    return cell_rows_0[row_0 * u32(262144) + cell_12];
}

fn set_cell_row_0( row_1 : u32,  cell_13 : u32,  value_2 : vec4<u32>)
{
    cell_rows_0[row_1 * u32(262144) + cell_13] = value_2;
    return;
}

fn place_of_asked_0( cell_14 : u32) -> u32
{
    return u32(262160) + cell_14;
}

fn ask_cell_0( key_1 : Key_0,  asked_0 : u32) -> vec4<f32>
{
    var _S437 : bool;
    var hash_1 : vec2<u32> = Key_hash_0(key_1);
    var _S438 : u32 = max(hash_1.y, u32(1));
    var cell_15 : u32 = find_cell_0(hash_1);
    var _S439 : vec4<f32> = vec4<f32>(0.0f);
    var known_0 : vec4<f32>;
    if(cell_15 != u32(262144))
    {
        known_0 = (bitcast<vec4<f32>>((cell_row_0(u32(0), cell_15))));
    }
    else
    {
        known_0 = _S439;
    }
    var cell_16 : u32 = cell_15;
    var probe_1 : u32 = u32(0);
    for(;;)
    {
        if(probe_1 < u32(8))
        {
            _S437 = cell_16 == u32(262144);
        }
        else
        {
            _S437 = false;
        }
        if(_S437)
        {
        }
        else
        {
            break;
        }
        var place_6 : u32 = ((hash_1.x + probe_1) & (u32(262143)));
        var found_0 : u32 = atomicCompareExchangeWeak(&(cell_keys_0[place_of_check_0(place_6)]), u32(0), _S438).old_value;
        var _S440 : bool = found_0 == u32(0);
        if(_S440)
        {
            set_cell_row_0(u32(1), place_6, vec4<u32>(key_1.instance_13, key_1.face_and_level_0, u32(0), u32(0)));
            set_cell_row_0(u32(2), place_6, vec4<u32>(vec3<u32>(key_1.cube_0), u32(0)));
        }
        var _S441 : bool;
        if(_S440)
        {
            _S441 = true;
        }
        else
        {
            _S441 = found_0 == _S438;
        }
        if(_S441)
        {
            cell_16 = place_6;
        }
        probe_1 = probe_1 + u32(1);
    }
    if(cell_16 != u32(262144))
    {
        var _S442 : u32 = atomicLoad(&(cell_keys_0[place_of_asked_0(cell_16)]));
        _S437 = _S442 < asked_0;
    }
    else
    {
        _S437 = false;
    }
    if(_S437)
    {
        var _S443 : u32 = atomicMax(&(cell_keys_0[place_of_asked_0(cell_16)]), asked_0);
    }
    return known_0;
}

fn SunDisc_sample_1( receiver_18 : Receiver_0,  u_18 : vec4<f32>,  sample_11 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_1 : f32 = u_18.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_7 : f32 = square_root_0(one_minus_cos_theta_1 * (2.0f - one_minus_cos_theta_1));
    var sin_cos_5 : vec2<f32> = sincos_turns_0(u_18.w);
    var direction_29 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_1)) + (params_0.sun_tangent_0 * vec3<f32>((radius_7 * sin_cos_5.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_7 * sin_cos_5.x)));
    var cos_theta_8 : f32 = with_slack_0(receiver_18, dot_product_0(receiver_18.normal_3, direction_29));
    (*sample_11) = LightSample_x24init_0(ray_from_0(receiver_18.point_0, direction_29), cos_theta_8, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_8 > 0.0f;
}

fn Environment_choose_1( u_19 : vec4<f32>,  chosen_6 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S444 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_6) = ChosenDirection_x24init_0(_S444, _S444, 0.0f);
    var edge_1 : f32 = f32(params_0.sky_edge_0);
    var _S445 : f32 = u_19.x * edge_1;
    var _S446 : f32 = edge_1 - 1.0f;
    var _S447 : f32 = min(floor(_S445), _S446);
    var own_2 : u32 = u32(_S447) * params_0.sky_edge_0 + u32(min(floor(u_19.y * edge_1), _S446));
    var index_30 : u32;
    if((u_19.z) < (environment_0[own_2].threshold_0))
    {
        index_30 = own_2;
    }
    else
    {
        index_30 = environment_0[own_2].alias_0;
    }
    var pdf_13 : f32 = environment_0[index_30].pdf_0;
    if((environment_0[index_30].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S448 : u32 = index_30 % params_0.sky_edge_0;
    var _S449 : f32 = f32(_S448);
    var _S450 : u32 = index_30 / params_0.sky_edge_0;
    var place_7 : vec2<f32> = vec2<f32>(_S449, f32(_S450)) + vec2<f32>(min(_S445 - _S447, 1.0f), u_19.w);
    (*chosen_6) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_7 * vec2<f32>(divide_0(1.0f, edge_1)))), Environment_radiance_at_0(place_7), pdf_13);
    return true;
}

fn Sky_sample_1( receiver_19 : Receiver_0,  u_20 : vec4<f32>,  sample_12 : ptr<function, LightSample_0>) -> bool
{
    (*sample_12) = no_light_0();
    var chosen_7 : ChosenDirection_0;
    var _S451 : bool;
    if(SKY_0 != u32(1))
    {
        _S451 = true;
    }
    else
    {
        var _S452 : bool = Environment_choose_1(u_20, &(chosen_7));
        _S451 = !_S452;
    }
    if(_S451)
    {
        return false;
    }
    var cos_theta_9 : f32 = dot_product_0(receiver_19.normal_3, chosen_7.direction_25);
    (*sample_12) = LightSample_x24init_0(ray_from_0(receiver_19.point_0, chosen_7.direction_25), cos_theta_9, chosen_7.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_7.pdf_4);
    return cos_theta_9 > 0.0f;
}

fn Descent_at_2( this_54 : ptr<function, Descent_0>,  root_4 : u32)
{
    var node_12 : LightNode_0 = TopLights_node_0(root_4);
    (*this_54).node_0 = root_4;
    (*this_54).index_14 = node_12.index_16;
    (*this_54).count_1 = node_12.count_3;
    (*this_54).is_far_0 = false;
    return;
}

fn climb_1( receiver_20 : Receiver_0,  start_5 : u32,  descent_4 : ptr<function, Descent_0>) -> bool
{
    var node_13 : LightNode_0 = top_light_node_0(start_5);
    var at_8 : u32 = start_5;
    for(;;)
    {
        var _S453 : LightNode_0 = node_13;
        if((node_13.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_2 : LightNode_0 = top_light_node_0(_S453.parent_0);
        var _S454 : u32 = _S453.parent_0 + u32(1);
        var is_left_4 : bool = at_8 == _S454;
        var _S455 : u32;
        if(is_left_4)
        {
            _S455 = parent_2.index_16;
        }
        else
        {
            _S455 = _S454;
        }
        var _S456 : View_0 = view_0(node_13, receiver_20);
        var _S457 : View_0 = view_0(top_light_node_0(_S455), receiver_20);
        var _S458 : f32;
        if(is_left_4)
        {
            _S458 = _S456.importance_0;
        }
        else
        {
            _S458 = _S457.importance_0;
        }
        var _S459 : f32;
        if(is_left_4)
        {
            _S459 = _S457.importance_0;
        }
        else
        {
            _S459 = _S456.importance_0;
        }
        var weights_3 : vec2<f32> = weights_of_0(_S458, _S459);
        var _S460 : f32 = weights_3.x;
        var _S461 : f32 = weights_3.y;
        var total_6 : f32 = _S460 + _S461;
        if(!(total_6 > 0.0f))
        {
            return false;
        }
        var _S462 : f32;
        if(is_left_4)
        {
            _S462 = _S460;
        }
        else
        {
            _S462 = _S461;
        }
        (*descent_4).weight_0 = (*descent_4).weight_0 * _S462;
        (*descent_4).total_0 = (*descent_4).total_0 * total_6;
        node_13 = parent_2;
        at_8 = _S453.parent_0;
    }
    return ((*descent_4).weight_0) > 0.0f;
}

fn descend_2( receiver_21 : Receiver_0,  aim_5 : Aim_0,  descent_5 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S463 : bool;
        if(((*descent_5).count_1) == u32(0))
        {
            _S463 = !(*descent_5).is_far_0;
        }
        else
        {
            _S463 = false;
        }
        if(_S463)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_4 : LightNode_0 = TopLights_node_0((*descent_5).node_0 + u32(1));
        var right_5 : LightNode_0 = TopLights_node_0((*descent_5).index_14);
        var weights_4 : vec2<f32> = weights_of_0(view_0(left_4, receiver_21).importance_0, view_0(right_5, receiver_21).importance_0);
        var _S464 : f32 = weights_4.x;
        var _S465 : f32 = weights_4.y;
        var total_7 : f32 = _S464 + _S465;
        if(!(total_7 > 0.0f))
        {
            return false;
        }
        var _S466 : bool;
        if(_S465 <= 0.0f)
        {
            _S466 = true;
        }
        else
        {
            _S466 = ((*descent_5).choice_0 * total_7) < (_S464 * (*descent_5).weight_0);
        }
        var is_left_5 : bool;
        if(aim_5.is_met_0)
        {
            var _S467 : vec3<f32> = vec3<f32>(aim_5.hit_3.voxel_1);
            if((all((_S467 >= (vector_of_0(left_4.min_2))))))
            {
                is_left_5 = (all((_S467 < (vector_of_0(left_4.max_2)))));
            }
            else
            {
                is_left_5 = false;
            }
        }
        else
        {
            is_left_5 = _S466;
        }
        var _S468 : f32 = (*descent_5).choice_0 * total_7;
        var _S469 : f32;
        if(is_left_5)
        {
            _S469 = 0.0f;
        }
        else
        {
            _S469 = _S464 * (*descent_5).weight_0;
        }
        (*descent_5).choice_0 = _S468 - _S469;
        var _S470 : u32;
        if(is_left_5)
        {
            _S470 = (*descent_5).node_0 + u32(1);
        }
        else
        {
            _S470 = (*descent_5).index_14;
        }
        (*descent_5).node_0 = _S470;
        var _S471 : u32;
        if(is_left_5)
        {
            _S471 = left_4.index_16;
        }
        else
        {
            _S471 = right_5.index_16;
        }
        (*descent_5).index_14 = _S471;
        var _S472 : u32;
        if(is_left_5)
        {
            _S472 = left_4.count_3;
        }
        else
        {
            _S472 = right_5.count_3;
        }
        (*descent_5).count_1 = _S472;
        (*descent_5).is_far_0 = false;
        var _S473 : f32;
        if(is_left_5)
        {
            _S473 = _S464;
        }
        else
        {
            _S473 = _S465;
        }
        var _S474 : f32 = (*descent_5).weight_0 * _S473;
        (*descent_5).weight_0 = _S474;
        (*descent_5).total_0 = (*descent_5).total_0 * total_7;
        if(_S474 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Descent_at_3( this_55 : ptr<function, Descent_0>,  root_5 : u32)
{
    var node_14 : LightNode_0 = GridLights_node_0(root_5);
    (*this_55).node_0 = root_5;
    (*this_55).index_14 = node_14.index_16;
    (*this_55).count_1 = node_14.count_3;
    (*this_55).is_far_0 = false;
    return;
}

fn descend_3( receiver_22 : Receiver_0,  aim_6 : Aim_0,  descent_6 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S475 : bool;
        if(((*descent_6).count_1) == u32(0))
        {
            _S475 = !(*descent_6).is_far_0;
        }
        else
        {
            _S475 = false;
        }
        if(_S475)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_5 : LightNode_0 = GridLights_node_0((*descent_6).node_0 + u32(1));
        var right_6 : LightNode_0 = GridLights_node_0((*descent_6).index_14);
        var of_left_1 : View_0 = view_0(left_5, receiver_22);
        var of_right_1 : View_0 = view_0(right_6, receiver_22);
        var weights_5 : vec2<f32> = weights_of_0(of_left_1.importance_0, of_right_1.importance_0);
        var _S476 : f32 = weights_5.x;
        var _S477 : f32 = weights_5.y;
        var total_8 : f32 = _S476 + _S477;
        if(!(total_8 > 0.0f))
        {
            return false;
        }
        var _S478 : bool;
        if(_S477 <= 0.0f)
        {
            _S478 = true;
        }
        else
        {
            _S478 = ((*descent_6).choice_0 * total_8) < (_S476 * (*descent_6).weight_0);
        }
        var is_left_6 : bool;
        if(aim_6.is_met_0)
        {
            var _S479 : vec3<f32> = vec3<f32>(aim_6.hit_3.voxel_1);
            if((all((_S479 >= (vector_of_0(left_5.min_2))))))
            {
                is_left_6 = (all((_S479 < (vector_of_0(left_5.max_2)))));
            }
            else
            {
                is_left_6 = false;
            }
        }
        else
        {
            is_left_6 = _S478;
        }
        var _S480 : f32 = (*descent_6).choice_0 * total_8;
        var _S481 : f32;
        if(is_left_6)
        {
            _S481 = 0.0f;
        }
        else
        {
            _S481 = _S476 * (*descent_6).weight_0;
        }
        (*descent_6).choice_0 = _S480 - _S481;
        var _S482 : u32;
        if(is_left_6)
        {
            _S482 = (*descent_6).node_0 + u32(1);
        }
        else
        {
            _S482 = (*descent_6).index_14;
        }
        (*descent_6).node_0 = _S482;
        var _S483 : u32;
        if(is_left_6)
        {
            _S483 = left_5.index_16;
        }
        else
        {
            _S483 = right_6.index_16;
        }
        (*descent_6).index_14 = _S483;
        var _S484 : u32;
        if(is_left_6)
        {
            _S484 = left_5.count_3;
        }
        else
        {
            _S484 = right_6.count_3;
        }
        (*descent_6).count_1 = _S484;
        var _S485 : bool;
        if(is_left_6)
        {
            _S485 = of_left_1.is_far_2;
        }
        else
        {
            _S485 = of_right_1.is_far_2;
        }
        (*descent_6).is_far_0 = _S485;
        var _S486 : f32;
        if(is_left_6)
        {
            _S486 = _S476;
        }
        else
        {
            _S486 = _S477;
        }
        var _S487 : f32 = (*descent_6).weight_0 * _S486;
        (*descent_6).weight_0 = _S487;
        (*descent_6).total_0 = (*descent_6).total_0 * total_8;
        if(_S487 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_1( point_6 : vec3<f32>,  is_met_3 : bool,  way_7 : Descent_0,  side_5 : ptr<function, u32>,  odds_3 : ptr<function, vec2<f32>>) -> bool
{
    var node_15 : LightNode_0 = light_node_at_0(way_7.node_0);
    var _S488 : vec3<f32> = vector_of_0(node_15.max_2);
    var _S489 : vec3<f32> = vector_of_0(node_15.min_2);
    var _S490 : vec3<f32> = vec3<f32>(0.5f);
    var half_3 : vec3<f32> = (_S488 - _S489) * _S490;
    var toward_3 : vec3<f32> = (_S489 + _S488) * _S490 - point_6;
    var sent_2 : BySide_0 = sent_by_side_0(node_15, point_6, length_bound_0(select(half_3, abs(toward_3), vec3<bool>(((length_squared_0(toward_3)) > (length_squared_0(half_3)))))));
    var sum_6 : f32 = normal_or_zero_0(BySide_sum_0(sent_2));
    var unit_3 : f32 = inverse_power_of_two_0(sum_6);
    var total_9 : f32 = sum_6 * unit_3;
    var _S491 : f32 = way_7.choice_0 * total_9;
    var _S492 : u32 = (*side_5);
    var share_8 : f32 = normal_or_zero_0(sent_2.low_7[u32(0)] * unit_3);
    var _S493 : bool;
    if(is_met_3)
    {
        _S493 = u32(0) == _S492;
    }
    else
    {
        _S493 = share_8 > 0.0f;
    }
    var chosen_8 : f32;
    if(_S493)
    {
        (*side_5) = u32(0);
        chosen_8 = share_8;
    }
    else
    {
        chosen_8 = 0.0f;
    }
    var _S494 : bool = _S491 < (share_8 * way_7.weight_0);
    var share_9 : f32 = normal_or_zero_0(sent_2.high_4[u32(0)] * unit_3);
    if(is_met_3)
    {
        _S493 = u32(1) == _S492;
    }
    else
    {
        if(share_9 > 0.0f)
        {
            _S493 = !_S494;
        }
        else
        {
            _S493 = false;
        }
    }
    if(_S493)
    {
        (*side_5) = u32(1);
        chosen_8 = share_9;
    }
    var passed_4 : f32 = share_8 + share_9;
    if(_S494)
    {
        _S493 = true;
    }
    else
    {
        _S493 = _S491 < (passed_4 * way_7.weight_0);
    }
    var share_10 : f32 = normal_or_zero_0(sent_2.low_7[u32(1)] * unit_3);
    var _S495 : bool;
    if(is_met_3)
    {
        _S495 = u32(2) == _S492;
    }
    else
    {
        if(share_10 > 0.0f)
        {
            _S495 = !_S493;
        }
        else
        {
            _S495 = false;
        }
    }
    if(_S495)
    {
        (*side_5) = u32(2);
        chosen_8 = share_10;
    }
    var passed_5 : f32 = passed_4 + share_10;
    if(_S493)
    {
        _S493 = true;
    }
    else
    {
        _S493 = _S491 < (passed_5 * way_7.weight_0);
    }
    var share_11 : f32 = normal_or_zero_0(sent_2.high_4[u32(1)] * unit_3);
    if(is_met_3)
    {
        _S495 = u32(3) == _S492;
    }
    else
    {
        if(share_11 > 0.0f)
        {
            _S495 = !_S493;
        }
        else
        {
            _S495 = false;
        }
    }
    if(_S495)
    {
        (*side_5) = u32(3);
        chosen_8 = share_11;
    }
    var passed_6 : f32 = passed_5 + share_11;
    if(_S493)
    {
        _S493 = true;
    }
    else
    {
        _S493 = _S491 < (passed_6 * way_7.weight_0);
    }
    var share_12 : f32 = normal_or_zero_0(sent_2.low_7[u32(2)] * unit_3);
    if(is_met_3)
    {
        _S495 = u32(4) == _S492;
    }
    else
    {
        if(share_12 > 0.0f)
        {
            _S495 = !_S493;
        }
        else
        {
            _S495 = false;
        }
    }
    if(_S495)
    {
        (*side_5) = u32(4);
        chosen_8 = share_12;
    }
    var passed_7 : f32 = passed_6 + share_12;
    if(_S493)
    {
        _S493 = true;
    }
    else
    {
        _S493 = _S491 < (passed_7 * way_7.weight_0);
    }
    var share_13 : f32 = normal_or_zero_0(sent_2.high_4[u32(2)] * unit_3);
    if(is_met_3)
    {
        _S493 = u32(5) == _S492;
    }
    else
    {
        if(share_13 > 0.0f)
        {
            _S493 = !_S493;
        }
        else
        {
            _S493 = false;
        }
    }
    if(_S493)
    {
        (*side_5) = u32(5);
        chosen_8 = share_13;
    }
    (*odds_3) = vec2<f32>(way_7.weight_0 * chosen_8, way_7.total_0 * total_9);
    if(sum_6 > 0.0f)
    {
        _S493 = ((*odds_3).x) > 0.0f;
    }
    else
    {
        _S493 = false;
    }
    return _S493;
}

fn sample_emitter_1( receiver_23 : Receiver_0,  u_21 : vec4<f32>,  aim_7 : Aim_0,  sample_13 : ptr<function, LightSample_0>) -> bool
{
    (*sample_13) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_7 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_21.x, false);
    Descent_at_2(&(descent_7), u32(0));
    var _S496 : bool;
    if(!IS_SINGLE_0)
    {
        _S496 = aim_7.is_met_0;
    }
    else
    {
        _S496 = false;
    }
    if(_S496)
    {
        var leaf_3 : u32 = instances_0[aim_7.hit_3.instance_3].light_leaf_0;
        if((instances_0[aim_7.hit_3.instance_3].light_leaf_0) == u32(4294967295))
        {
            _S496 = true;
        }
        else
        {
            var _S497 : bool = climb_1(receiver_23, leaf_3, &(descent_7));
            _S496 = !_S497;
        }
        if(_S496)
        {
            return false;
        }
        Descent_at_2(&(descent_7), leaf_3);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S498 : bool = descend_2(receiver_23, by_chance_0(), &(descent_7));
            _S496 = !_S498;
        }
        else
        {
            _S496 = false;
        }
        if(_S496)
        {
            return false;
        }
    }
    var chosen_instance_1 : u32 = descent_7.index_14;
    var local_4 : Receiver_0 = in_grid_0(descent_7.index_14, receiver_23);
    Descent_at_3(&(descent_7), top_light_node_0(descent_7.node_0).root_1);
    var _S499 : bool = descend_3(local_4, aim_7, &(descent_7));
    if(!_S499)
    {
        return false;
    }
    var side_6 : u32 = aim_7.hit_3.face_0;
    var odds_4 : vec2<f32>;
    var _S500 : bool = choose_side_1(local_4.point_0, aim_7.is_met_0, descent_7, &(side_6), &(odds_4));
    if(!_S500)
    {
        return false;
    }
    var power_6 : f32 = light_power_at_0(descent_7.node_0, side_6);
    if(aim_7.is_met_0)
    {
        var _S501 : f32 = density_0(odds_4, aim_7.luminance_1, power_6, Transform_direction_0(chosen_instance_1, aim_7.direction_22) * vec3<f32>(aim_7.hit_3.t_0), side_6);
        (*sample_13).pdf_2 = _S501;
        return _S501 > 0.0f;
    }
    var emitter_2 : Emitter_0 = choose_emitter_0(descent_7, side_6, u_21.y * power_6);
    var _S502 : vec3<f32> = vec3<f32>(cell_of_0(emitter_2.voxel_18));
    var on_face_1 : vec3<f32> = point_of_face_0(_S502, side_6, u_21.z, u_21.w);
    var pdf_14 : f32 = density_0(odds_4, emitter_2.luminance_4, power_6, on_face_1 - local_4.point_0, side_6);
    if(pdf_14 < 0.0f)
    {
        return false;
    }
    var direction_30 : vec3<f32> = Transform_point_1(chosen_instance_1, offset_ray_origin_0(vector_of_0(instances_0[chosen_instance_1].grid_from_world_0.translation_0), _S502, side_6, on_face_1)) - receiver_23.point_0;
    var cos_theta_10 : f32 = with_slack_0(receiver_23, divide_0(dot_product_0(receiver_23.normal_3, direction_30), square_root_0(length_squared_0(direction_30))));
    (*sample_13) = LightSample_x24init_0(Ray_x24init_0(receiver_23.point_0, 0.0f, direction_30, 1.0f), cos_theta_10, emitted_0(material_of_index_0(emitter_2.material_5)), pdf_14);
    return cos_theta_10 > 0.0f;
}

fn EmitterTree_sample_1( receiver_24 : Receiver_0,  u_22 : vec4<f32>,  aim_8 : Aim_0,  sample_14 : ptr<function, LightSample_0>) -> bool
{
    var _S503 : bool = sample_emitter_1(receiver_24, u_22, aim_8, &((*sample_14)));
    return _S503;
}

fn Lights_sample_1( receiver_25 : Receiver_0,  selection_5 : Selection_0,  u_23 : vec4<f32>,  aim_9 : Aim_0,  sample_15 : ptr<function, LightSample_0>) -> bool
{
    var is_found_9 : bool;
    if(has_sun_0())
    {
        is_found_9 = !aim_9.is_met_0;
    }
    else
    {
        is_found_9 = false;
    }
    if(is_found_9)
    {
        is_found_9 = (u_23.x) < (selection_5.sun_0);
    }
    else
    {
        is_found_9 = false;
    }
    if(is_found_9)
    {
        var _S504 : bool = SunDisc_sample_1(receiver_25, u_23, &((*sample_15)));
        (*sample_15).pdf_2 = (*sample_15).pdf_2 * selection_5.sun_0;
        is_found_9 = _S504;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_9 = !aim_9.is_met_0;
        }
        else
        {
            is_found_9 = false;
        }
        if(is_found_9)
        {
            is_found_9 = (u_23.x) < (selection_5.sun_0 + selection_5.sky_1);
        }
        else
        {
            is_found_9 = false;
        }
        if(is_found_9)
        {
            var _S505 : bool = Sky_sample_1(receiver_25, vec4<f32>(min(divide_0(u_23.x - selection_5.sun_0, selection_5.sky_1), 0.99999994039535522f), u_23.yzw), &((*sample_15)));
            (*sample_15).pdf_2 = (*sample_15).pdf_2 * selection_5.sky_1;
            is_found_9 = _S505;
        }
        else
        {
            var _S506 : bool = EmitterTree_sample_1(receiver_25, vec4<f32>(min(divide_0(u_23.x - (selection_5.sun_0 + selection_5.sky_1), selection_5.emitters_0), 0.99999994039535522f), u_23.yzw), aim_9, &((*sample_15)));
            (*sample_15).pdf_2 = (*sample_15).pdf_2 * selection_5.emitters_0;
            is_found_9 = _S506;
        }
    }
    return is_found_9;
}

fn emitted_at_0( path_10 : Path_0,  ray_27 : Ray_0,  hit_11 : Hit_0,  beyond_7 : u32,  met_material_0 : PackedMaterial_0) -> vec3<f32>
{
    var le_2 : vec3<f32> = EmitterTree_le_0(met_material_0);
    if((max_element_0(le_2)) <= 0.0f)
    {
        return vec3<f32>(0.0f);
    }
    var last_6 : Receiver_0 = Path_receiver_0(path_10, ray_27);
    var met_1 : Aim_0 = Aim_x24init_0(true, ray_27.direction_0, hit_11, luminance_0(vector_of_0(met_material_0.emission_0)));
    var light_9 : LightSample_0 = no_light_0();
    var is_chosen_1 : bool;
    if((path_10.pdf_1) > 0.0f)
    {
        var _S507 : bool = Lights_sample_1(last_6, Path_selection_at_0(path_10, last_6), vec4<f32>(0.0f), met_1, &(light_9));
        is_chosen_1 = _S507;
    }
    else
    {
        is_chosen_1 = false;
    }
    var _S508 : vec3<f32> = path_10.beta_0 * le_2;
    var _S509 : f32;
    if(is_chosen_1)
    {
        _S509 = light_9.pdf_2;
    }
    else
    {
        _S509 = 0.0f;
    }
    return _S508 * vec3<f32>(mis_weight_0(path_10.pdf_1, _S509));
}

fn asks_0( path_11 : Path_0,  ray_28 : Ray_0,  hit_12 : Hit_0,  beyond_8 : u32,  life_2 : u32,  light_10 : ptr<function, vec3<f32>>) -> bool
{
    (*light_10) = vec3<f32>(0.0f);
    var _S510 : bool;
    if(Hit_is_miss_0(hit_12))
    {
        _S510 = true;
    }
    else
    {
        _S510 = Inside_is_in_0(path_11.inside_0);
    }
    if(_S510)
    {
        return false;
    }
    var material_12 : PackedMaterial_0 = material_met_0(path_11, hit_12, beyond_8);
    if((material_12.metallic_0) > 0.0f)
    {
        _S510 = true;
    }
    else
    {
        _S510 = (material_12.transmission_0) > 0.0f;
    }
    if(_S510)
    {
        return false;
    }
    var code_2 : u32;
    var key_2 : Key_0 = key_of_0(hit_12, square_root_0(length_squared_0(ray_28.origin_1 + ray_28.direction_0 * vec3<f32>(hit_12.t_0) - real_time_0.eye_1)) * real_time_0.view_angle_0 * 0.05882352963089943f, Sampler_independent_0(path_11.sampler_0, u32(3221225472) + Path_events_0(path_11)).x, &(code_2));
    var least_0 : f32 = 2.0f * f32((u32(1) << ((Key_level_0(key_2)))));
    if(life_2 == u32(0))
    {
        _S510 = true;
    }
    else
    {
        _S510 = (hit_12.t_0 * square_root_0(length_squared_0(ray_28.direction_0))) < least_0;
    }
    if(_S510)
    {
        return false;
    }
    var known_1 : vec4<f32> = ask_cell_0(key_2, ((((min(life_2, u32(10))) << (u32(20)))) | (code_2)));
    if((known_1.w) <= 0.0f)
    {
        return false;
    }
    var _S511 : vec3<f32> = path_11.beta_0 * vector_of_0(material_12.base_color_0) * known_1.xyz;
    var _S512 : vec3<f32> = emitted_at_0(path_11, ray_28, hit_12, beyond_8, material_12);
    (*light_10) = _S511 + _S512;
    return true;
}

fn absorb_1( path_12 : ptr<function, Path_0>,  inside_6 : Inside_0,  ray_29 : Ray_0,  t_15 : f32)
{
    (*path_12).beta_0 = (*path_12).beta_0 * attenuation_0(material_of_index_0(inside_6.material_0), t_15 * Inside_voxels_per_t_0(inside_6, ray_29));
    return;
}

fn SunDisc_sample_2( receiver_26 : Receiver_0,  u_24 : vec4<f32>,  sample_16 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_2 : f32 = u_24.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_8 : f32 = square_root_0(one_minus_cos_theta_2 * (2.0f - one_minus_cos_theta_2));
    var sin_cos_6 : vec2<f32> = sincos_turns_0(u_24.w);
    var direction_31 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_2)) + (params_0.sun_tangent_0 * vec3<f32>((radius_8 * sin_cos_6.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_8 * sin_cos_6.x)));
    var cos_theta_11 : f32 = with_slack_0(receiver_26, dot_product_0(receiver_26.normal_3, direction_31));
    (*sample_16) = LightSample_x24init_0(ray_from_0(receiver_26.point_0, direction_31), cos_theta_11, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_11 > 0.0f;
}

fn Environment_choose_2( u_25 : vec4<f32>,  chosen_9 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S513 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_9) = ChosenDirection_x24init_0(_S513, _S513, 0.0f);
    var edge_2 : f32 = f32(params_0.sky_edge_0);
    var _S514 : f32 = u_25.x * edge_2;
    var _S515 : f32 = edge_2 - 1.0f;
    var _S516 : f32 = min(floor(_S514), _S515);
    var own_3 : u32 = u32(_S516) * params_0.sky_edge_0 + u32(min(floor(u_25.y * edge_2), _S515));
    var index_31 : u32;
    if((u_25.z) < (environment_0[own_3].threshold_0))
    {
        index_31 = own_3;
    }
    else
    {
        index_31 = environment_0[own_3].alias_0;
    }
    var pdf_15 : f32 = environment_0[index_31].pdf_0;
    if((environment_0[index_31].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S517 : u32 = index_31 % params_0.sky_edge_0;
    var _S518 : f32 = f32(_S517);
    var _S519 : u32 = index_31 / params_0.sky_edge_0;
    var place_8 : vec2<f32> = vec2<f32>(_S518, f32(_S519)) + vec2<f32>(min(_S514 - _S516, 1.0f), u_25.w);
    (*chosen_9) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_8 * vec2<f32>(divide_0(1.0f, edge_2)))), Environment_radiance_at_0(place_8), pdf_15);
    return true;
}

fn Sky_sample_2( receiver_27 : Receiver_0,  u_26 : vec4<f32>,  sample_17 : ptr<function, LightSample_0>) -> bool
{
    (*sample_17) = no_light_0();
    var chosen_10 : ChosenDirection_0;
    var _S520 : bool;
    if(SKY_0 != u32(1))
    {
        _S520 = true;
    }
    else
    {
        var _S521 : bool = Environment_choose_2(u_26, &(chosen_10));
        _S520 = !_S521;
    }
    if(_S520)
    {
        return false;
    }
    var cos_theta_12 : f32 = dot_product_0(receiver_27.normal_3, chosen_10.direction_25);
    (*sample_17) = LightSample_x24init_0(ray_from_0(receiver_27.point_0, chosen_10.direction_25), cos_theta_12, chosen_10.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_10.pdf_4);
    return cos_theta_12 > 0.0f;
}

fn Descent_at_4( this_56 : ptr<function, Descent_0>,  root_6 : u32)
{
    var node_16 : LightNode_0 = TopLights_node_0(root_6);
    (*this_56).node_0 = root_6;
    (*this_56).index_14 = node_16.index_16;
    (*this_56).count_1 = node_16.count_3;
    (*this_56).is_far_0 = false;
    return;
}

fn climb_2( receiver_28 : Receiver_0,  start_6 : u32,  descent_8 : ptr<function, Descent_0>) -> bool
{
    var node_17 : LightNode_0 = top_light_node_0(start_6);
    var at_9 : u32 = start_6;
    for(;;)
    {
        var _S522 : LightNode_0 = node_17;
        if((node_17.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_3 : LightNode_0 = top_light_node_0(_S522.parent_0);
        var _S523 : u32 = _S522.parent_0 + u32(1);
        var is_left_7 : bool = at_9 == _S523;
        var _S524 : u32;
        if(is_left_7)
        {
            _S524 = parent_3.index_16;
        }
        else
        {
            _S524 = _S523;
        }
        var _S525 : View_0 = view_0(node_17, receiver_28);
        var _S526 : View_0 = view_0(top_light_node_0(_S524), receiver_28);
        var _S527 : f32;
        if(is_left_7)
        {
            _S527 = _S525.importance_0;
        }
        else
        {
            _S527 = _S526.importance_0;
        }
        var _S528 : f32;
        if(is_left_7)
        {
            _S528 = _S526.importance_0;
        }
        else
        {
            _S528 = _S525.importance_0;
        }
        var weights_6 : vec2<f32> = weights_of_0(_S527, _S528);
        var _S529 : f32 = weights_6.x;
        var _S530 : f32 = weights_6.y;
        var total_10 : f32 = _S529 + _S530;
        if(!(total_10 > 0.0f))
        {
            return false;
        }
        var _S531 : f32;
        if(is_left_7)
        {
            _S531 = _S529;
        }
        else
        {
            _S531 = _S530;
        }
        (*descent_8).weight_0 = (*descent_8).weight_0 * _S531;
        (*descent_8).total_0 = (*descent_8).total_0 * total_10;
        node_17 = parent_3;
        at_9 = _S522.parent_0;
    }
    return ((*descent_8).weight_0) > 0.0f;
}

fn descend_4( receiver_29 : Receiver_0,  aim_10 : Aim_0,  descent_9 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S532 : bool;
        if(((*descent_9).count_1) == u32(0))
        {
            _S532 = !(*descent_9).is_far_0;
        }
        else
        {
            _S532 = false;
        }
        if(_S532)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_6 : LightNode_0 = TopLights_node_0((*descent_9).node_0 + u32(1));
        var right_7 : LightNode_0 = TopLights_node_0((*descent_9).index_14);
        var weights_7 : vec2<f32> = weights_of_0(view_0(left_6, receiver_29).importance_0, view_0(right_7, receiver_29).importance_0);
        var _S533 : f32 = weights_7.x;
        var _S534 : f32 = weights_7.y;
        var total_11 : f32 = _S533 + _S534;
        if(!(total_11 > 0.0f))
        {
            return false;
        }
        var _S535 : bool;
        if(_S534 <= 0.0f)
        {
            _S535 = true;
        }
        else
        {
            _S535 = ((*descent_9).choice_0 * total_11) < (_S533 * (*descent_9).weight_0);
        }
        var is_left_8 : bool;
        if(aim_10.is_met_0)
        {
            var _S536 : vec3<f32> = vec3<f32>(aim_10.hit_3.voxel_1);
            if((all((_S536 >= (vector_of_0(left_6.min_2))))))
            {
                is_left_8 = (all((_S536 < (vector_of_0(left_6.max_2)))));
            }
            else
            {
                is_left_8 = false;
            }
        }
        else
        {
            is_left_8 = _S535;
        }
        var _S537 : f32 = (*descent_9).choice_0 * total_11;
        var _S538 : f32;
        if(is_left_8)
        {
            _S538 = 0.0f;
        }
        else
        {
            _S538 = _S533 * (*descent_9).weight_0;
        }
        (*descent_9).choice_0 = _S537 - _S538;
        var _S539 : u32;
        if(is_left_8)
        {
            _S539 = (*descent_9).node_0 + u32(1);
        }
        else
        {
            _S539 = (*descent_9).index_14;
        }
        (*descent_9).node_0 = _S539;
        var _S540 : u32;
        if(is_left_8)
        {
            _S540 = left_6.index_16;
        }
        else
        {
            _S540 = right_7.index_16;
        }
        (*descent_9).index_14 = _S540;
        var _S541 : u32;
        if(is_left_8)
        {
            _S541 = left_6.count_3;
        }
        else
        {
            _S541 = right_7.count_3;
        }
        (*descent_9).count_1 = _S541;
        (*descent_9).is_far_0 = false;
        var _S542 : f32;
        if(is_left_8)
        {
            _S542 = _S533;
        }
        else
        {
            _S542 = _S534;
        }
        var _S543 : f32 = (*descent_9).weight_0 * _S542;
        (*descent_9).weight_0 = _S543;
        (*descent_9).total_0 = (*descent_9).total_0 * total_11;
        if(_S543 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Descent_at_5( this_57 : ptr<function, Descent_0>,  root_7 : u32)
{
    var node_18 : LightNode_0 = GridLights_node_0(root_7);
    (*this_57).node_0 = root_7;
    (*this_57).index_14 = node_18.index_16;
    (*this_57).count_1 = node_18.count_3;
    (*this_57).is_far_0 = false;
    return;
}

fn descend_5( receiver_30 : Receiver_0,  aim_11 : Aim_0,  descent_10 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S544 : bool;
        if(((*descent_10).count_1) == u32(0))
        {
            _S544 = !(*descent_10).is_far_0;
        }
        else
        {
            _S544 = false;
        }
        if(_S544)
        {
        }
        else
        {
            break;
        }
        if(waits_for_pages_0())
        {
            return false;
        }
        var left_7 : LightNode_0 = GridLights_node_0((*descent_10).node_0 + u32(1));
        var right_8 : LightNode_0 = GridLights_node_0((*descent_10).index_14);
        var of_left_2 : View_0 = view_0(left_7, receiver_30);
        var of_right_2 : View_0 = view_0(right_8, receiver_30);
        var weights_8 : vec2<f32> = weights_of_0(of_left_2.importance_0, of_right_2.importance_0);
        var _S545 : f32 = weights_8.x;
        var _S546 : f32 = weights_8.y;
        var total_12 : f32 = _S545 + _S546;
        if(!(total_12 > 0.0f))
        {
            return false;
        }
        var _S547 : bool;
        if(_S546 <= 0.0f)
        {
            _S547 = true;
        }
        else
        {
            _S547 = ((*descent_10).choice_0 * total_12) < (_S545 * (*descent_10).weight_0);
        }
        var is_left_9 : bool;
        if(aim_11.is_met_0)
        {
            var _S548 : vec3<f32> = vec3<f32>(aim_11.hit_3.voxel_1);
            if((all((_S548 >= (vector_of_0(left_7.min_2))))))
            {
                is_left_9 = (all((_S548 < (vector_of_0(left_7.max_2)))));
            }
            else
            {
                is_left_9 = false;
            }
        }
        else
        {
            is_left_9 = _S547;
        }
        var _S549 : f32 = (*descent_10).choice_0 * total_12;
        var _S550 : f32;
        if(is_left_9)
        {
            _S550 = 0.0f;
        }
        else
        {
            _S550 = _S545 * (*descent_10).weight_0;
        }
        (*descent_10).choice_0 = _S549 - _S550;
        var _S551 : u32;
        if(is_left_9)
        {
            _S551 = (*descent_10).node_0 + u32(1);
        }
        else
        {
            _S551 = (*descent_10).index_14;
        }
        (*descent_10).node_0 = _S551;
        var _S552 : u32;
        if(is_left_9)
        {
            _S552 = left_7.index_16;
        }
        else
        {
            _S552 = right_8.index_16;
        }
        (*descent_10).index_14 = _S552;
        var _S553 : u32;
        if(is_left_9)
        {
            _S553 = left_7.count_3;
        }
        else
        {
            _S553 = right_8.count_3;
        }
        (*descent_10).count_1 = _S553;
        var _S554 : bool;
        if(is_left_9)
        {
            _S554 = of_left_2.is_far_2;
        }
        else
        {
            _S554 = of_right_2.is_far_2;
        }
        (*descent_10).is_far_0 = _S554;
        var _S555 : f32;
        if(is_left_9)
        {
            _S555 = _S545;
        }
        else
        {
            _S555 = _S546;
        }
        var _S556 : f32 = (*descent_10).weight_0 * _S555;
        (*descent_10).weight_0 = _S556;
        (*descent_10).total_0 = (*descent_10).total_0 * total_12;
        if(_S556 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_2( point_7 : vec3<f32>,  is_met_4 : bool,  way_8 : Descent_0,  side_7 : ptr<function, u32>,  odds_5 : ptr<function, vec2<f32>>) -> bool
{
    var node_19 : LightNode_0 = light_node_at_0(way_8.node_0);
    var _S557 : vec3<f32> = vector_of_0(node_19.max_2);
    var _S558 : vec3<f32> = vector_of_0(node_19.min_2);
    var _S559 : vec3<f32> = vec3<f32>(0.5f);
    var half_4 : vec3<f32> = (_S557 - _S558) * _S559;
    var toward_4 : vec3<f32> = (_S558 + _S557) * _S559 - point_7;
    var sent_3 : BySide_0 = sent_by_side_0(node_19, point_7, length_bound_0(select(half_4, abs(toward_4), vec3<bool>(((length_squared_0(toward_4)) > (length_squared_0(half_4)))))));
    var sum_7 : f32 = normal_or_zero_0(BySide_sum_0(sent_3));
    var unit_4 : f32 = inverse_power_of_two_0(sum_7);
    var total_13 : f32 = sum_7 * unit_4;
    var _S560 : f32 = way_8.choice_0 * total_13;
    var _S561 : u32 = (*side_7);
    var share_14 : f32 = normal_or_zero_0(sent_3.low_7[u32(0)] * unit_4);
    var _S562 : bool;
    if(is_met_4)
    {
        _S562 = u32(0) == _S561;
    }
    else
    {
        _S562 = share_14 > 0.0f;
    }
    var chosen_11 : f32;
    if(_S562)
    {
        (*side_7) = u32(0);
        chosen_11 = share_14;
    }
    else
    {
        chosen_11 = 0.0f;
    }
    var _S563 : bool = _S560 < (share_14 * way_8.weight_0);
    var share_15 : f32 = normal_or_zero_0(sent_3.high_4[u32(0)] * unit_4);
    if(is_met_4)
    {
        _S562 = u32(1) == _S561;
    }
    else
    {
        if(share_15 > 0.0f)
        {
            _S562 = !_S563;
        }
        else
        {
            _S562 = false;
        }
    }
    if(_S562)
    {
        (*side_7) = u32(1);
        chosen_11 = share_15;
    }
    var passed_8 : f32 = share_14 + share_15;
    if(_S563)
    {
        _S562 = true;
    }
    else
    {
        _S562 = _S560 < (passed_8 * way_8.weight_0);
    }
    var share_16 : f32 = normal_or_zero_0(sent_3.low_7[u32(1)] * unit_4);
    var _S564 : bool;
    if(is_met_4)
    {
        _S564 = u32(2) == _S561;
    }
    else
    {
        if(share_16 > 0.0f)
        {
            _S564 = !_S562;
        }
        else
        {
            _S564 = false;
        }
    }
    if(_S564)
    {
        (*side_7) = u32(2);
        chosen_11 = share_16;
    }
    var passed_9 : f32 = passed_8 + share_16;
    if(_S562)
    {
        _S562 = true;
    }
    else
    {
        _S562 = _S560 < (passed_9 * way_8.weight_0);
    }
    var share_17 : f32 = normal_or_zero_0(sent_3.high_4[u32(1)] * unit_4);
    if(is_met_4)
    {
        _S564 = u32(3) == _S561;
    }
    else
    {
        if(share_17 > 0.0f)
        {
            _S564 = !_S562;
        }
        else
        {
            _S564 = false;
        }
    }
    if(_S564)
    {
        (*side_7) = u32(3);
        chosen_11 = share_17;
    }
    var passed_10 : f32 = passed_9 + share_17;
    if(_S562)
    {
        _S562 = true;
    }
    else
    {
        _S562 = _S560 < (passed_10 * way_8.weight_0);
    }
    var share_18 : f32 = normal_or_zero_0(sent_3.low_7[u32(2)] * unit_4);
    if(is_met_4)
    {
        _S564 = u32(4) == _S561;
    }
    else
    {
        if(share_18 > 0.0f)
        {
            _S564 = !_S562;
        }
        else
        {
            _S564 = false;
        }
    }
    if(_S564)
    {
        (*side_7) = u32(4);
        chosen_11 = share_18;
    }
    var passed_11 : f32 = passed_10 + share_18;
    if(_S562)
    {
        _S562 = true;
    }
    else
    {
        _S562 = _S560 < (passed_11 * way_8.weight_0);
    }
    var share_19 : f32 = normal_or_zero_0(sent_3.high_4[u32(2)] * unit_4);
    if(is_met_4)
    {
        _S562 = u32(5) == _S561;
    }
    else
    {
        if(share_19 > 0.0f)
        {
            _S562 = !_S562;
        }
        else
        {
            _S562 = false;
        }
    }
    if(_S562)
    {
        (*side_7) = u32(5);
        chosen_11 = share_19;
    }
    (*odds_5) = vec2<f32>(way_8.weight_0 * chosen_11, way_8.total_0 * total_13);
    if(sum_7 > 0.0f)
    {
        _S562 = ((*odds_5).x) > 0.0f;
    }
    else
    {
        _S562 = false;
    }
    return _S562;
}

fn sample_emitter_2( receiver_31 : Receiver_0,  u_27 : vec4<f32>,  aim_12 : Aim_0,  sample_18 : ptr<function, LightSample_0>) -> bool
{
    (*sample_18) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_11 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_27.x, false);
    Descent_at_4(&(descent_11), u32(0));
    var _S565 : bool;
    if(!IS_SINGLE_0)
    {
        _S565 = aim_12.is_met_0;
    }
    else
    {
        _S565 = false;
    }
    if(_S565)
    {
        var leaf_4 : u32 = instances_0[aim_12.hit_3.instance_3].light_leaf_0;
        if((instances_0[aim_12.hit_3.instance_3].light_leaf_0) == u32(4294967295))
        {
            _S565 = true;
        }
        else
        {
            var _S566 : bool = climb_2(receiver_31, leaf_4, &(descent_11));
            _S565 = !_S566;
        }
        if(_S565)
        {
            return false;
        }
        Descent_at_4(&(descent_11), leaf_4);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S567 : bool = descend_4(receiver_31, by_chance_0(), &(descent_11));
            _S565 = !_S567;
        }
        else
        {
            _S565 = false;
        }
        if(_S565)
        {
            return false;
        }
    }
    var chosen_instance_2 : u32 = descent_11.index_14;
    var local_5 : Receiver_0 = in_grid_0(descent_11.index_14, receiver_31);
    Descent_at_5(&(descent_11), top_light_node_0(descent_11.node_0).root_1);
    var _S568 : bool = descend_5(local_5, aim_12, &(descent_11));
    if(!_S568)
    {
        return false;
    }
    var side_8 : u32 = aim_12.hit_3.face_0;
    var odds_6 : vec2<f32>;
    var _S569 : bool = choose_side_2(local_5.point_0, aim_12.is_met_0, descent_11, &(side_8), &(odds_6));
    if(!_S569)
    {
        return false;
    }
    var power_7 : f32 = light_power_at_0(descent_11.node_0, side_8);
    if(aim_12.is_met_0)
    {
        var _S570 : f32 = density_0(odds_6, aim_12.luminance_1, power_7, Transform_direction_0(chosen_instance_2, aim_12.direction_22) * vec3<f32>(aim_12.hit_3.t_0), side_8);
        (*sample_18).pdf_2 = _S570;
        return _S570 > 0.0f;
    }
    var emitter_3 : Emitter_0 = choose_emitter_0(descent_11, side_8, u_27.y * power_7);
    var _S571 : vec3<f32> = vec3<f32>(cell_of_0(emitter_3.voxel_18));
    var on_face_2 : vec3<f32> = point_of_face_0(_S571, side_8, u_27.z, u_27.w);
    var pdf_16 : f32 = density_0(odds_6, emitter_3.luminance_4, power_7, on_face_2 - local_5.point_0, side_8);
    if(pdf_16 < 0.0f)
    {
        return false;
    }
    var direction_32 : vec3<f32> = Transform_point_1(chosen_instance_2, offset_ray_origin_0(vector_of_0(instances_0[chosen_instance_2].grid_from_world_0.translation_0), _S571, side_8, on_face_2)) - receiver_31.point_0;
    var cos_theta_13 : f32 = with_slack_0(receiver_31, divide_0(dot_product_0(receiver_31.normal_3, direction_32), square_root_0(length_squared_0(direction_32))));
    (*sample_18) = LightSample_x24init_0(Ray_x24init_0(receiver_31.point_0, 0.0f, direction_32, 1.0f), cos_theta_13, emitted_0(material_of_index_0(emitter_3.material_5)), pdf_16);
    return cos_theta_13 > 0.0f;
}

fn EmitterTree_sample_2( receiver_32 : Receiver_0,  u_28 : vec4<f32>,  aim_13 : Aim_0,  sample_19 : ptr<function, LightSample_0>) -> bool
{
    var _S572 : bool = sample_emitter_2(receiver_32, u_28, aim_13, &((*sample_19)));
    return _S572;
}

fn Lights_sample_2( receiver_33 : Receiver_0,  selection_6 : Selection_0,  u_29 : vec4<f32>,  aim_14 : Aim_0,  sample_20 : ptr<function, LightSample_0>) -> bool
{
    var is_found_10 : bool;
    if(has_sun_0())
    {
        is_found_10 = !aim_14.is_met_0;
    }
    else
    {
        is_found_10 = false;
    }
    if(is_found_10)
    {
        is_found_10 = (u_29.x) < (selection_6.sun_0);
    }
    else
    {
        is_found_10 = false;
    }
    if(is_found_10)
    {
        var _S573 : bool = SunDisc_sample_2(receiver_33, u_29, &((*sample_20)));
        (*sample_20).pdf_2 = (*sample_20).pdf_2 * selection_6.sun_0;
        is_found_10 = _S573;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_10 = !aim_14.is_met_0;
        }
        else
        {
            is_found_10 = false;
        }
        if(is_found_10)
        {
            is_found_10 = (u_29.x) < (selection_6.sun_0 + selection_6.sky_1);
        }
        else
        {
            is_found_10 = false;
        }
        if(is_found_10)
        {
            var _S574 : bool = Sky_sample_2(receiver_33, vec4<f32>(min(divide_0(u_29.x - selection_6.sun_0, selection_6.sky_1), 0.99999994039535522f), u_29.yzw), &((*sample_20)));
            (*sample_20).pdf_2 = (*sample_20).pdf_2 * selection_6.sky_1;
            is_found_10 = _S574;
        }
        else
        {
            var _S575 : bool = EmitterTree_sample_2(receiver_33, vec4<f32>(min(divide_0(u_29.x - (selection_6.sun_0 + selection_6.sky_1), selection_6.emitters_0), 0.99999994039535522f), u_29.yzw), aim_14, &((*sample_20)));
            (*sample_20).pdf_2 = (*sample_20).pdf_2 * selection_6.emitters_0;
            is_found_10 = _S575;
        }
    }
    return is_found_10;
}

fn bsdf_of_1( material_13 : PackedMaterial_0,  ior_2 : f32,  choice_3 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_13.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn choose_light_1( path_13 : Path_0,  receiver_34 : Receiver_0,  surface_3 : Surface_0,  bsdf_1 : MaterialBsdf_0,  wo_7 : vec3<f32>,  is_scattered_2 : bool,  compensation_2 : f32,  next_3 : ptr<function, NextRays_0>)
{
    var count_7 : u32;
    if((path_13.bounce_0) == u32(0))
    {
        count_7 = first_candidates_0;
    }
    else
    {
        count_7 = u32(1);
    }
    var chosen_12 : f32 = 0.0f;
    var candidate_1 : u32 = u32(0);
    var sum_8 : f32 = 0.0f;
    for(;;)
    {
        if(candidate_1 < count_7)
        {
        }
        else
        {
            break;
        }
        var dimension_4 : u32 = u32(1073741824) + u32(64) * Path_events_0(path_13) + u32(2) * candidate_1;
        var u_30 : vec4<f32>;
        if(candidate_1 == u32(0))
        {
            u_30 = Sampler_stratified_0(path_13.sampler_0, Path_dimension_light_0(path_13));
        }
        else
        {
            u_30 = Sampler_independent_0(path_13.sampler_0, dimension_4);
        }
        var light_11 : LightSample_0 = no_light_0();
        var is_found_11 : bool = Lights_sample_2(receiver_34, path_13.selection_0, u_30, by_chance_0(), &(light_11));
        if(!is_found_11)
        {
            candidate_1 = candidate_1 + u32(1);
            continue;
        }
        var _S576 : vec3<f32> = vec3<f32>(Surface_local_direction_0(surface_3, light_11.ray_15.direction_0).xy, light_11.cos_theta_0);
        var wi_6 : vec3<f32>;
        if(is_scattered_2)
        {
            wi_6 = normalize_vector_0(light_11.ray_15.direction_0);
        }
        else
        {
            wi_6 = _S576;
        }
        var eval_1 : BsdfEval_0 = MaterialBsdf_eval_0(bsdf_1, wo_7, wi_6);
        var _S577 : vec3<f32> = path_13.beta_0 * eval_1.weight_3 * vec3<f32>(compensation_2) * light_11.radiance_1 * vec3<f32>((divide_0(eval_1.pdf_8, light_11.pdf_2) * power_heuristic_0(light_11.pdf_2, eval_1.pdf_8)));
        var weight_8 : f32 = luminance_0(_S577);
        var sum_9 : f32 = sum_8 + weight_8;
        var _S578 : bool;
        if(count_7 > u32(1))
        {
            _S578 = (Sampler_independent_0(path_13.sampler_0, dimension_4 + u32(1)).x * sum_9) >= weight_8;
        }
        else
        {
            _S578 = false;
        }
        if(_S578)
        {
            sum_8 = sum_9;
            candidate_1 = candidate_1 + u32(1);
            continue;
        }
        var chosen_13 : f32;
        if(weight_8 > 0.0f)
        {
            (*next_3).shadow_direction_0 = light_11.ray_15.direction_0;
            (*next_3).shadow_t_max_0 = light_11.ray_15.t_max_0;
            (*next_3).light_3 = _S577;
            chosen_13 = weight_8;
        }
        else
        {
            chosen_13 = chosen_12;
        }
        chosen_12 = chosen_13;
        sum_8 = sum_9;
        candidate_1 = candidate_1 + u32(1);
    }
    var _S579 : bool = chosen_12 > 0.0f;
    (*next_3).has_shadow_ray_0 = _S579;
    if(_S579)
    {
        (*next_3).light_3 = (*next_3).light_3 * vec3<f32>(divide_0(sum_8, chosen_12 * f32(count_7)));
    }
    return;
}

fn Diffuse_sample_1( this_58 : Diffuse_0,  wo_8 : vec3<f32>,  u_31 : vec3<f32>,  sample_21 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_7 : vec3<f32> = cosine_hemisphere_0(u_31.x, u_31.y);
    (*sample_21) = BsdfSample_x24init_0(wi_7, this_58.reflectance_0, cosine_hemisphere_pdf_0(wi_7.z), false);
    return true;
}

fn MaterialBsdf_sample_1( this_59 : MaterialBsdf_0,  wo_9 : vec3<f32>,  u_32 : vec3<f32>,  sample_22 : ptr<function, BsdfSample_0>) -> bool
{
    var _S580 : bool = Diffuse_sample_1(Diffuse_x24init_0(this_59.color_1), wo_9, u_32, &((*sample_22)));
    return _S580;
}

fn PathTracingOf_advance_1( path_14 : ptr<function, Path_0>,  ray_30 : Ray_0,  hit_13 : Hit_0,  beyond_9 : u32,  radiance_6 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_4 : NextRays_0 = no_rays_0();
    var is_counted_1 : bool = Path_is_counted_0((*path_14));
    var t_16 : f32;
    if(is_counted_1)
    {
        t_16 = - (*path_14).pdf_1;
    }
    else
    {
        t_16 = (*path_14).pdf_1;
    }
    (*path_14).pdf_1 = t_16;
    var last_7 : Receiver_0 = Path_receiver_0((*path_14), ray_30);
    var is_scattered_3 : bool;
    if(Inside_is_in_0((*path_14).inside_0))
    {
        is_scattered_3 = Hit_is_miss_0(hit_13);
    }
    else
    {
        is_scattered_3 = false;
    }
    if(Inside_is_in_0((*path_14).inside_0))
    {
        if(is_scattered_3)
        {
            t_16 = scattering_t_0((*path_14), (*path_14).inside_0, ray_30);
        }
        else
        {
            t_16 = hit_13.t_0;
        }
        if(!is_counted_1)
        {
            absorb_1(&((*path_14)), (*path_14).inside_0, ray_30, t_16);
        }
    }
    else
    {
        t_16 = hit_13.t_0;
    }
    var is_weighed_1 : bool;
    if(Hit_is_miss_0(hit_13))
    {
        is_weighed_1 = !is_scattered_3;
    }
    else
    {
        is_weighed_1 = false;
    }
    var light_pdf_2 : f32;
    if(is_weighed_1)
    {
        (*radiance_6) = (*radiance_6) + (*path_14).beta_0 * Sky_le_0(ray_30.direction_0) * vec3<f32>(mis_weight_0((*path_14).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_14), last_7), ray_30.direction_0)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_3 = true;
            }
            else
            {
                is_scattered_3 = !Path_is_straight_0((*path_14));
            }
        }
        else
        {
            is_scattered_3 = false;
        }
        if(is_scattered_3)
        {
            var le_3 : vec3<f32> = SunDisc_le_0(ray_30.direction_0);
            if((max_element_0(le_3)) > 0.0f)
            {
                if(((*path_14).pdf_1) == 0.0f)
                {
                    light_pdf_2 = 0.0f;
                }
                else
                {
                    light_pdf_2 = Lights_sun_pdf_0(Path_selection_at_0((*path_14), last_7), ray_30.direction_0);
                }
                (*radiance_6) = (*radiance_6) + (*path_14).beta_0 * le_3 * vec3<f32>(mis_weight_0((*path_14).pdf_1, light_pdf_2));
            }
        }
        return next_4;
    }
    var u_33 : vec4<f32> = Sampler_stratified_0((*path_14).sampler_0, Path_dimension_scatter_0((*path_14)));
    var material_14 : PackedMaterial_0 = material_met_0((*path_14), hit_13, beyond_9);
    var _S581 : vec3<f32> = vec3<f32>(0.0f);
    var le_4 : vec3<f32>;
    if(!is_counted_1)
    {
        le_4 = EmitterTree_le_0(material_14);
    }
    else
    {
        le_4 = _S581;
    }
    var is_lit_1 : bool = (max_element_0(le_4)) > 0.0f;
    var met_2 : Aim_0 = Aim_x24init_0(true, ray_30.direction_0, hit_13, luminance_0(vector_of_0(material_14.emission_0)));
    var _S582 : bool = weighs_apart_0();
    if(_S582)
    {
        is_weighed_1 = is_lit_1;
    }
    else
    {
        is_weighed_1 = false;
    }
    if(is_weighed_1)
    {
        is_weighed_1 = ((*path_14).pdf_1) > 0.0f;
    }
    else
    {
        is_weighed_1 = false;
    }
    var is_chosen_2 : bool;
    if(is_lit_1)
    {
        is_chosen_2 = !is_weighed_1;
    }
    else
    {
        is_chosen_2 = false;
    }
    if(is_chosen_2)
    {
        var light_12 : LightSample_0 = no_light_0();
        if(!_S582)
        {
            is_chosen_2 = ((*path_14).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_2 = false;
        }
        if(is_chosen_2)
        {
            var _S583 : bool = Lights_sample_2(last_7, Path_selection_at_0((*path_14), last_7), vec4<f32>(0.0f), met_2, &(light_12));
            is_chosen_2 = _S583;
        }
        else
        {
            is_chosen_2 = false;
        }
        var _S584 : vec3<f32> = (*path_14).beta_0 * le_4;
        var _S585 : f32 = (*path_14).pdf_1;
        if(is_chosen_2)
        {
            light_pdf_2 = light_12.pdf_2;
        }
        else
        {
            light_pdf_2 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + _S584 * vec3<f32>(mis_weight_0(_S585, light_pdf_2));
    }
    var _S586 : f32 = ior_of_0((*path_14).inside_0);
    var _S587 : f32 = u_33[i32(3)];
    var _S588 : MaterialBsdf_0 = bsdf_of_1(material_14, _S586, &(_S587));
    u_33[i32(3)] = _S587;
    var scattered_4 : vec3<f32> = (*path_14).beta_0 * MaterialBsdf_albedo_0(_S588);
    var _S589 : bool = ((*path_14).bounce_0) >= (params_0.max_bounces_0);
    var _S590 : bool = !is_weighed_1;
    if(_S590)
    {
        if(_S589)
        {
            is_chosen_2 = true;
        }
        else
        {
            is_chosen_2 = (max_element_0(scattered_4)) <= 0.0f;
        }
    }
    else
    {
        is_chosen_2 = false;
    }
    if(is_chosen_2)
    {
        return next_4;
    }
    var compensation_3 : f32 = roulette_0(Path_events_0((*path_14)), scattered_4, u_33.z);
    if(_S590)
    {
        is_chosen_2 = compensation_3 == 0.0f;
    }
    else
    {
        is_chosen_2 = false;
    }
    if(is_chosen_2)
    {
        return next_4;
    }
    var at_10 : Hit_0;
    if(is_scattered_3)
    {
        at_10 = Hit_x24init_0(t_16, (*path_14).inside_0.instance_1, hit_13.voxel_1, u32(0));
    }
    else
    {
        at_10 = hit_13;
    }
    var surface_4 : Surface_0 = surface_of_0(ray_30, at_10);
    var _S591 : Receiver_0 = Receiver_x24init_0(surface_4.origin_10, surface_4.normal_5);
    var _S592 : vec3<f32> = (vec3<f32>(0) - ray_30.direction_0);
    var wo_10 : vec3<f32> = Surface_local_direction_0(surface_4, _S592);
    var inside_7 : Inside_0 = in_air_0();
    var wo_11 : vec3<f32>;
    var receiver_35 : Receiver_0;
    if(is_scattered_3)
    {
        var _S593 : Inside_0 = Inside_x24init_0((*path_14).inside_0.instance_1, hit_13.voxel_1, (*path_14).inside_0.material_0);
        inside_7 = _S593;
        var _S594 : vec3<f32> = normalize_vector_0(_S592);
        receiver_35 = Receiver_x24init_0(Inside_point_0(_S593, ray_30, t_16), _S581);
        wo_11 = _S594;
    }
    else
    {
        if(Inside_is_in_0((*path_14).inside_0))
        {
            next_4.relocates_2 = (hit_13.instance_3) != ((*path_14).inside_0.instance_1);
            inside_7 = Inside_x24init_0((*path_14).inside_0.instance_1, hit_13.voxel_1, (*path_14).inside_0.material_0);
            inside_7.voxel_0 = hit_13.voxel_1 + vec3<i32>(face_normal_0(hit_13.face_0));
        }
        receiver_35 = _S591;
        wo_11 = wo_10;
    }
    next_4.origin_8 = receiver_35.point_0;
    next_4.shadow_inside_2 = inside_7;
    if(is_weighed_1)
    {
        receiver_35 = last_7;
    }
    if(_S590)
    {
        (*path_14).selection_0 = Lights_selection_0(receiver_35);
    }
    var light_13 : LightSample_0 = no_light_0();
    var _S595 : bool = !MaterialBsdf_is_delta_0(_S588);
    if(_S595)
    {
        choose_light_1((*path_14), receiver_35, surface_4, _S588, wo_11, is_scattered_3, compensation_3, &(next_4));
    }
    if(is_weighed_1)
    {
        if(next_4.has_shadow_ray_0)
        {
            light_pdf_2 = light_13.pdf_2;
        }
        else
        {
            light_pdf_2 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + (*path_14).beta_0 * le_4 * vec3<f32>(mis_weight_0((*path_14).pdf_1, light_pdf_2));
        (*path_14).pdf_1 = - (*path_14).pdf_1;
        next_4.is_same_0 = true;
        return next_4;
    }
    var bounce_3 : BsdfSample_0;
    var _S596 : bool = MaterialBsdf_sample_1(_S588, wo_11, vec3<f32>(u_33.xy, u_33.w), &(bounce_3));
    if(!_S596)
    {
        return next_4;
    }
    (*path_14).beta_0 = (*path_14).beta_0 * bounce_3.weight_6 * vec3<f32>(compensation_3);
    if(bounce_3.is_delta_0)
    {
        t_16 = 0.0f;
    }
    else
    {
        t_16 = bounce_3.pdf_10;
    }
    (*path_14).pdf_1 = t_16;
    (*path_14).normal_1 = receiver_35.normal_3;
    next_4.direction_6 = bounce_3.wi_3;
    if(!is_scattered_3)
    {
        next_4.direction_6 = Surface_world_direction_0(surface_4, bounce_3.wi_3);
    }
    next_4.path_relocates_2 = next_4.relocates_2;
    (*path_14).bounce_0 = (*path_14).bounce_0 + u32(1);
    return next_4;
}

fn show_1( path_15 : Path_0,  ray_31 : Ray_0,  hit_14 : Hit_0,  beyond_10 : u32,  sample_23 : ptr<function, Sample_0>)
{
    var _S597 : Path_0 = path_15;
    (*sample_23).is_shown_0 = true;
    if(Inside_is_in_0(_S597.inside_0))
    {
        absorb_1(&(_S597), _S597.inside_0, ray_31, hit_14.t_0);
    }
    var material_15 : PackedMaterial_0 = material_met_0(_S597, hit_14, beyond_10);
    (*sample_23).normal_0 = shading_normal_0(ray_31, hit_14, material_15);
    (*sample_23).albedo_0 = _S597.beta_0 * albedo_of_0(material_15);
    return;
}

fn follow_1( start_7 : Walker_0,  camera_ray_2 : Ray_0) -> Sample_0
{
    var at_11 : Walker_0 = start_7;
    var sample_24 : Sample_0 = no_sample_0();
    var goes_on_2 : bool = true;
    for(;;)
    {
        if(goes_on_2)
        {
        }
        else
        {
            break;
        }
        var _S598 : Ray_0 = at_11.ray_0;
        var _S599 : Path_0 = at_11.path_0;
        var _S600 : Inside_0 = at_11.shadow_inside_0;
        var _S601 : bool = at_11.relocates_0;
        var _S602 : bool = at_11.path_relocates_0;
        var beyond_11 : u32;
        var _S603 : Hit_0 = hit_of_ray_1(start_7.path_0.sampler_0, &(_S598), at_11.is_shadow_ray_0, &(_S599), &(_S600), &(_S601), &(_S602), &(beyond_11));
        at_11.ray_0 = _S598;
        at_11.path_0 = _S599;
        at_11.shadow_inside_0 = _S600;
        at_11.relocates_0 = _S601;
        at_11.path_relocates_0 = _S602;
        if(at_11.is_shadow_ray_0)
        {
            if(Hit_is_miss_0(_S603))
            {
                sample_24.light_0 = sample_24.light_0 + at_11.light_1;
            }
            at_11.is_shadow_ray_0 = false;
            if(!at_11.is_shadow_ray_0)
            {
                at_11.ray_0 = ray_from_0(at_11.ray_0.origin_1, at_11.direction_1);
                goes_on_2 = (any(((at_11.direction_1) != vec3<f32>(0.0f))));
            }
            continue;
        }
        at_11.path_0.sampler_0 = start_7.path_0.sampler_0;
        var cached_0 : vec3<f32>;
        var _S604 : bool;
        if(at_11.has_shown_0)
        {
            _S604 = at_11.asks_cache_0;
        }
        else
        {
            _S604 = false;
        }
        var _S605 : bool;
        if(_S604)
        {
            var _S606 : bool = asks_0(at_11.path_0, at_11.ray_0, _S603, beyond_11, at_11.life_0, &(cached_0));
            _S605 = _S606;
        }
        else
        {
            _S605 = false;
        }
        if(_S605)
        {
            sample_24.light_0 = sample_24.light_0 + cached_0;
            break;
        }
        var arrived_1 : Path_0 = at_11.path_0;
        var _S607 : vec3<f32> = vec3<f32>(0.0f);
        var emitted_2 : vec3<f32> = _S607;
        var _S608 : Path_0 = at_11.path_0;
        var next_5 : NextRays_0 = PathTracingOf_advance_1(&(_S608), at_11.ray_0, _S603, beyond_11, &(emitted_2));
        at_11.path_0 = _S608;
        var goes_on_3 : bool = (any(((next_5.direction_6) != _S607)));
        if(at_11.has_shown_0)
        {
            sample_24.light_0 = sample_24.light_0 + emitted_2;
        }
        else
        {
            sample_24.direct_0 = sample_24.direct_0 + emitted_2;
            var _S609 : bool = (at_11.path_0.bounce_0) == u32(0);
            var _S610 : bool;
            if(goes_on_3)
            {
                _S610 = _S609;
            }
            else
            {
                _S610 = false;
            }
            var _S611 : bool = !_S610;
            at_11.has_shown_0 = _S611;
            if(!_S611)
            {
                at_11.way_0 = at_11.way_0 + _S603.t_0;
            }
            else
            {
                if(!Hit_is_miss_0(_S603))
                {
                    show_1(arrived_1, at_11.ray_0, _S603, beyond_11, &(sample_24));
                    sample_24.place_0 = camera_ray_2.origin_1 + camera_ray_2.direction_0 * vec3<f32>((at_11.way_0 + _S603.t_0));
                    var _S612 : u32;
                    if((at_11.way_0) > 0.0f)
                    {
                        _S612 = u32(4294967295);
                    }
                    else
                    {
                        _S612 = _S603.instance_3;
                    }
                    sample_24.instance_0 = _S612;
                }
            }
        }
        at_11.direction_1 = next_5.direction_6;
        at_11.light_1 = next_5.light_3;
        at_11.is_shadow_ray_0 = next_5.has_shadow_ray_0;
        at_11.path_origin_0 = next_5.path_origin_1;
        at_11.ray_0 = ray_from_0(next_5.origin_8, next_5.direction_6);
        if(at_11.is_shadow_ray_0)
        {
            at_11.ray_0 = Ray_x24init_0(next_5.origin_8, 0.0f, next_5.shadow_direction_0, next_5.shadow_t_max_0);
            goes_on_2 = true;
        }
        else
        {
            goes_on_2 = goes_on_3;
        }
    }
    return sample_24;
}

fn sample_of_1( pixel_2 : vec2<u32>,  camera_1 : CameraFrame_0,  sampler_7 : Sampler_0,  asks_cache_3 : bool) -> Sample_0
{
    first_candidates_0 = real_time_0.candidates_0;
    var jitter_1 : vec4<f32> = PathTracingOf_jitter_0(sampler_7);
    var camera_ray_3 : Ray_0 = CameraFrame_ray_0(camera_1, vec2<f32>(pixel_2) + jitter_1.xy, jitter_1.zw);
    var _S613 : vec3<f32> = vec3<f32>(0.0f);
    var _S614 : Sample_0 = follow_1(Walker_x24init_0(path_from_0(sampler_7), camera_ray_3, false, _S613, _S613, _S613, in_air_0(), u32(0), true, true, 0.0f, false, asks_cache_3, u32(10)), camera_ray_3);
    return _S614;
}

fn place_of_chosen_0( number_2 : u32) -> u32
{
    return u32(524304) + number_2;
}

fn Sampler_x24init_0( seed_3 : u32,  pixel_3 : u32,  sample_25 : u32) -> Sampler_0
{
    var _S615 : Sampler_0;
    _S615.seed_1 = seed_3;
    _S615.pixel_0 = pixel_3;
    _S615.sample_0 = sample_25;
    return _S615;
}

fn Key_voxel_0( this_60 : Key_0,  code_3 : u32,  scramble_0 : u32) -> vec3<i32>
{
    var _S616 : u32 = Key_level_0(this_60);
    var bits_4 : u32 = ((u32(1) << (_S616))) - u32(1);
    var place_9 : u32 = ((code_3 - u32(1)) ^ (((scramble_0 & ((Key_mask_0(this_60)))))));
    return (((this_60.cube_0) << (vec3<u32>(u32(i32(_S616)))))) + vec3<i32>(i32((place_9 & (bits_4))), i32((((place_9 >> (_S616))) & (bits_4))), i32((((place_9 >> ((u32(2) * _S616)))) & (bits_4))));
}

fn orthonormal_pair_0( z_1 : vec3<f32>,  x_11 : ptr<function, vec3<f32>>,  y_6 : ptr<function, vec3<f32>>)
{
    var _S617 : f32 = z_1.z;
    var sign_1 : f32;
    if(_S617 < 0.0f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_8 : f32 = divide_0(-1.0f, sign_1 + _S617);
    var _S618 : f32 = z_1.x;
    var _S619 : f32 = z_1.y;
    var b_8 : f32 = _S618 * _S619 * a_8;
    (*x_11) = vec3<f32>(1.0f + sign_1 * _S618 * _S618 * a_8, sign_1 * b_8, - sign_1 * _S618);
    (*y_6) = vec3<f32>(b_8, sign_1 + _S619 * _S619 * a_8, - _S619);
    return;
}

fn Lights_sample_3( receiver_36 : Receiver_0,  selection_7 : Selection_0,  u_34 : vec4<f32>,  aim_15 : Aim_0,  sample_26 : ptr<function, LightSample_0>) -> bool
{
    var is_found_12 : bool;
    if(has_sun_0())
    {
        is_found_12 = !aim_15.is_met_0;
    }
    else
    {
        is_found_12 = false;
    }
    if(is_found_12)
    {
        is_found_12 = (u_34.x) < (selection_7.sun_0);
    }
    else
    {
        is_found_12 = false;
    }
    if(is_found_12)
    {
        var _S620 : bool = SunDisc_sample_0(receiver_36, u_34, &((*sample_26)));
        (*sample_26).pdf_2 = (*sample_26).pdf_2 * selection_7.sun_0;
        is_found_12 = _S620;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_12 = !aim_15.is_met_0;
        }
        else
        {
            is_found_12 = false;
        }
        if(is_found_12)
        {
            is_found_12 = (u_34.x) < (selection_7.sun_0 + selection_7.sky_1);
        }
        else
        {
            is_found_12 = false;
        }
        if(is_found_12)
        {
            var _S621 : bool = Sky_sample_0(receiver_36, vec4<f32>(min(divide_0(u_34.x - selection_7.sun_0, selection_7.sky_1), 0.99999994039535522f), u_34.yzw), &((*sample_26)));
            (*sample_26).pdf_2 = (*sample_26).pdf_2 * selection_7.sky_1;
            is_found_12 = _S621;
        }
        else
        {
            var _S622 : bool = EmitterTree_sample_0(receiver_36, vec4<f32>(min(divide_0(u_34.x - (selection_7.sun_0 + selection_7.sky_1), selection_7.emitters_0), 0.99999994039535522f), u_34.yzw), aim_15, &((*sample_26)));
            (*sample_26).pdf_2 = (*sample_26).pdf_2 * selection_7.emitters_0;
            is_found_12 = _S622;
        }
    }
    return is_found_12;
}

fn light_of_cell_0( key_3 : Key_0,  rank_3 : u32,  sampler_8 : Sampler_0) -> vec3<f32>
{
    var face_7 : u32 = ((key_3.face_and_level_0) & (u32(7)));
    var axis_7 : u32 = (face_7 >> (u32(1)));
    var u_35 : vec4<f32> = Sampler_independent_0(sampler_8, u32(0));
    var _S623 : vec3<f32> = vec3<f32>(Key_voxel_0(key_3, (rank_3 & (u32(1048575))), scramble_of_0(real_time_0.number_0 - u32(1))));
    var on_face_3 : vec3<f32>;
    if(axis_7 == u32(0))
    {
        on_face_3 = vec3<f32>(0.0f, u_35.x, u_35.y);
    }
    else
    {
        if(axis_7 == u32(1))
        {
            on_face_3 = vec3<f32>(u_35.y, 0.0f, u_35.x);
        }
        else
        {
            on_face_3 = vec3<f32>(u_35.x, u_35.y, 0.0f);
        }
    }
    var _S624 : vec3<f32> = Transform_point_1(key_3.instance_13, offset_ray_origin_0(vector_of_0(instances_0[key_3.instance_13].grid_from_world_0.translation_0), _S623, face_7, _S623 + on_face_3));
    var _S625 : vec3<f32> = world_normal_0(key_3.instance_13, face_7);
    var receiver_37 : Receiver_0 = Receiver_x24init_0(_S624, _S625);
    var path_16 : Path_0 = path_from_0(sampler_8);
    path_16.selection_0 = Lights_selection_0(receiver_37);
    var x_12 : vec3<f32>;
    var y_7 : vec3<f32>;
    orthonormal_pair_0(_S625, &(x_12), &(y_7));
    var local_6 : vec3<f32> = cosine_hemisphere_0(u_35.z, u_35.w);
    var _S626 : f32 = local_6.z;
    var direction_33 : vec3<f32> = x_12 * vec3<f32>(local_6.x) + y_7 * vec3<f32>(local_6.y) + _S625 * vec3<f32>(_S626);
    path_16.normal_1 = _S625;
    path_16.pdf_1 = cosine_hemisphere_pdf_0(_S626);
    path_16.bounce_0 = u32(1);
    path_16.event_0 = u32(1);
    path_16.scattered_0 = u32(1);
    first_candidates_0 = u32(1);
    var start_8 : Walker_0 = Walker_x24init_0(path_16, ray_from_0(_S624, direction_33), false, vec3<f32>(0.0f), direction_33, _S624, in_air_0(), u32(0), false, false, 0.0f, true, true, max((rank_3 >> (u32(20))), u32(1)) - u32(1));
    var chosen_14 : f32 = 0.0f;
    var candidate_2 : u32 = u32(0);
    var sum_10 : f32 = 0.0f;
    for(;;)
    {
        if(candidate_2 < (real_time_0.candidates_0))
        {
        }
        else
        {
            break;
        }
        var light_14 : LightSample_0 = no_light_0();
        var _S627 : u32 = u32(2) * candidate_2;
        var is_found_13 : bool = Lights_sample_3(receiver_37, path_16.selection_0, Sampler_independent_0(sampler_8, u32(1) + _S627), by_chance_0(), &(light_14));
        if(!is_found_13)
        {
            candidate_2 = candidate_2 + u32(1);
            continue;
        }
        var ratio_2 : f32 = divide_0(max(light_14.cos_theta_0, 0.0f) * 0.31830987334251404f, light_14.pdf_2);
        var arrives_0 : vec3<f32> = light_14.radiance_1 * vec3<f32>(divide_0(ratio_2, 1.0f + ratio_2 * ratio_2));
        var weight_9 : f32 = luminance_0(arrives_0);
        var sum_11 : f32 = sum_10 + weight_9;
        if((Sampler_independent_0(sampler_8, u32(2) + _S627).x * sum_11) >= weight_9)
        {
            sum_10 = sum_11;
            candidate_2 = candidate_2 + u32(1);
            continue;
        }
        start_8.light_1 = arrives_0;
        start_8.ray_0 = Ray_x24init_0(_S624, 0.0f, light_14.ray_15.direction_0, light_14.ray_15.t_max_0);
        start_8.is_shadow_ray_0 = true;
        chosen_14 = weight_9;
        sum_10 = sum_11;
        candidate_2 = candidate_2 + u32(1);
    }
    if(start_8.is_shadow_ray_0)
    {
        start_8.light_1 = start_8.light_1 * vec3<f32>(divide_0(sum_10, chosen_14 * f32(real_time_0.candidates_0)));
    }
    var _S628 : Sample_0 = follow_1(start_8, start_8.ray_0);
    return _S628.light_0;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_cells(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    first_candidates_0 = u32(1);
    is_page_missing_0 = false;
    var _S629 : u32 = id_0.x;
    var _S630 : u32 = atomicLoad(&(cell_keys_0[u32(2)]));
    if(_S629 < _S630)
    {
        var cell_17 : u32 = atomicLoad(&(cell_keys_0[place_of_chosen_0(_S629)]));
        var face_8 : vec4<u32> = cell_row_0(u32(1), cell_17);
        var key_4 : Key_0 = Key_x24init_0(face_8.x, face_8.y, vec3<i32>(cell_row_0(u32(2), cell_17).xyz));
        var _S631 : vec3<f32> = light_of_cell_0(key_4, face_8.z, Sampler_x24init_0(((params_0.seed_0) ^ (u32(1540483477))), Key_hash_0(key_4).x, real_time_0.number_0));
        set_cell_row_0(u32(3), cell_17, vec4<u32>((bitcast<vec3<u32>>((_S631))), u32(1)));
    }
    return;
}

fn has_0( flag_0 : u32) -> bool
{
    return (((real_time_0.flags_0) & (flag_0))) != u32(0);
}

fn pixel_of_thread_0( thread_0 : u32) -> vec2<u32>
{
    var tiles_0 : u32 = (params_0.width_0 + u32(7)) / u32(8);
    var tile_0 : u32 = thread_0 / u32(64);
    var in_tile_0 : u32 = (thread_0 & (u32(63)));
    var row_2 : u32 = tile_0 / tiles_0;
    return vec2<u32>((tile_0 - row_2 * tiles_0) * u32(8) + ((in_tile_0 & (u32(7)))), row_2 * u32(8) + ((in_tile_0 >> (u32(3)))));
}

fn pixel_that_traces_0( thread_1 : u32) -> vec2<u32>
{
    if(!has_0(u32(128)))
    {
        var _S632 : vec2<u32> = pixel_of_thread_0(thread_1);
        return _S632;
    }
    var tiles_1 : u32 = (params_0.width_0 + u32(15)) / u32(16);
    var tile_1 : u32 = thread_1 / u32(64);
    var in_tile_1 : u32 = (thread_1 & (u32(63)));
    var row_3 : u32 = tile_1 / tiles_1;
    var _S633 : u32 = row_3 * u32(8) + ((in_tile_1 >> (u32(3))));
    var at_12 : vec2<u32> = vec2<u32>((tile_1 - row_3 * tiles_1) * u32(16) + u32(2) * ((in_tile_1 & (u32(7)))), _S633);
    at_12[i32(0)] = at_12[i32(0)] + (((_S633 + real_time_0.number_0) & (u32(1))));
    return at_12;
}

fn is_inside_0( at_13 : vec2<i32>) -> bool
{
    var _S634 : bool;
    if((all((at_13 >= vec2<i32>(i32(0))))))
    {
        _S634 = (at_13.x) < i32(params_0.width_0);
    }
    else
    {
        _S634 = false;
    }
    if(_S634)
    {
        _S634 = (at_13.y) < i32(params_0.height_0);
    }
    else
    {
        _S634 = false;
    }
    return _S634;
}

fn index_of_0( at_14 : vec2<u32>) -> u32
{
    return at_14.y * params_0.width_0 + at_14.x;
}

fn CameraFrame_x24init_0( lens_8 : u32,  eye_9 : vec3<f32>,  corner_7 : vec3<f32>,  pixel_x_6 : vec3<f32>,  pixel_y_6 : vec3<f32>,  lens_x_4 : vec3<f32>,  lens_y_4 : vec3<f32>,  blades_5 : u32) -> CameraFrame_0
{
    var _S635 : CameraFrame_0;
    _S635.lens_1 = lens_8;
    _S635.eye_2 = eye_9;
    _S635.corner_2 = corner_7;
    _S635.pixel_x_1 = pixel_x_6;
    _S635.pixel_y_1 = pixel_y_6;
    _S635.lens_x_1 = lens_x_4;
    _S635.lens_y_1 = lens_y_4;
    _S635.blades_1 = blades_5;
    return _S635;
}

@id(5) override LENS_0 : u32 = u32(0);

fn packed_normal_0( normal_7 : vec3<f32>) -> u32
{
    var _S636 : vec3<i32> = vec3<i32>(floor(clamp(normal_7, vec3<f32>(-1.0f), vec3<f32>(1.0f)) * vec3<f32>(511.0f) + vec3<f32>(0.5f)));
    return (((((u32(_S636.x) & (u32(1023)))) | (((((u32(_S636.y) & (u32(1023)))) << (u32(10))))))) | (((((u32(_S636.z) & (u32(1023)))) << (u32(20))))));
}

fn set_scratch_row_0( row_4 : u32,  index_32 : u32,  value_3 : vec2<u32>)
{
    scratch_0[row_4 * real_time_0.pixels_0 + index_32] = value_3;
    return;
}

fn store_sample_0( index_33 : u32,  sample_27 : Sample_0)
{
    var _S637 : u32 = packed_normal_0(sample_27.normal_0);
    var _S638 : u32;
    if(sample_27.is_shown_0)
    {
        _S638 = u32(1073741824);
    }
    else
    {
        _S638 = u32(0);
    }
    var normal_8 : u32 = (_S637 | (_S638));
    set_scratch_row_0(u32(0), index_33, (bitcast<vec2<u32>>((sample_27.light_0.xy))));
    set_scratch_row_0(u32(1), index_33, vec2<u32>((bitcast<u32>((sample_27.light_0.z))), sample_27.instance_0));
    set_scratch_row_0(u32(2), index_33, (bitcast<vec2<u32>>((sample_27.direct_0.xy))));
    set_scratch_row_0(u32(3), index_33, (bitcast<vec2<u32>>((vec2<f32>(sample_27.direct_0.z, sample_27.place_0.x)))));
    set_scratch_row_0(u32(4), index_33, (bitcast<vec2<u32>>((sample_27.place_0.yz))));
    set_scratch_row_0(u32(5), index_33, (bitcast<vec2<u32>>((sample_27.albedo_0.xy))));
    set_scratch_row_0(u32(6), index_33, vec2<u32>((bitcast<u32>((sample_27.albedo_0.z))), normal_8));
    return;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0, params_0.lens_x_0, params_0.lens_y_0, params_0.blades_0);
}

@compute
@workgroup_size(64, 1, 1)
fn trace_paths(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    first_candidates_0 = u32(1);
    is_page_missing_0 = false;
    var at_15 : vec2<u32> = pixel_that_traces_0(id_1.x);
    if(is_inside_0(vec2<i32>(at_15)))
    {
        var index_34 : u32 = index_of_0(at_15);
        var _S639 : Sample_0 = sample_of_1(at_15, FrameParams_camera_0(), Sampler_x24init_0(((params_0.seed_0) ^ (u32(2654435769))), index_34, real_time_0.number_0), has_0(u32(1)));
        store_sample_0(index_34, _S639);
    }
    return;
}

struct Lit_0
{
     paths_0 : f32,
     light_15 : vec3<f32>,
     shaded_0 : vec3<f32>,
     moments_0 : vec3<f32>,
};

fn Lit_x24init_0( paths_1 : f32,  light_16 : vec3<f32>,  shaded_1 : vec3<f32>,  moments_1 : vec3<f32>) -> Lit_0
{
    var _S640 : Lit_0;
    _S640.paths_0 = paths_1;
    _S640.light_15 = light_16;
    _S640.shaded_0 = shaded_1;
    _S640.moments_0 = moments_1;
    return _S640;
}

fn not_lit_0() -> Lit_0
{
    var _S641 : vec3<f32> = vec3<f32>(0.0f);
    return Lit_x24init_0(0.0f, _S641, _S641, _S641);
}

struct Memory_0
{
     lit_0 : Lit_0,
     looks_0 : f32,
     direct_2 : vec3<f32>,
     albedo_2 : vec3<f32>,
     normal_9 : vec3<f32>,
     place_10 : vec3<f32>,
     roughness_1 : f32,
     coverage_0 : f32,
};

fn Memory_x24init_0( lit_1 : Lit_0,  looks_1 : f32,  direct_3 : vec3<f32>,  albedo_3 : vec3<f32>,  normal_10 : vec3<f32>,  place_11 : vec3<f32>,  roughness_2 : f32,  coverage_1 : f32) -> Memory_0
{
    var _S642 : Memory_0;
    _S642.lit_0 = lit_1;
    _S642.looks_0 = looks_1;
    _S642.direct_2 = direct_3;
    _S642.albedo_2 = albedo_3;
    _S642.normal_9 = normal_10;
    _S642.place_10 = place_11;
    _S642.roughness_1 = roughness_2;
    _S642.coverage_0 = coverage_1;
    return _S642;
}

fn nothing_known_0() -> Memory_0
{
    var _S643 : vec3<f32> = vec3<f32>(0.0f);
    return Memory_x24init_0(not_lit_0(), 0.0f, _S643, _S643, _S643, _S643, 0.0f, 0.0f);
}

fn memory_row_0( row_5 : u32,  index_35 : u32) -> vec4<u32>
{
    return memory_rows_0[row_5 * real_time_0.pixels_0 + index_35];
}

fn low_half_0( word_9 : u32) -> f32
{
    return unpack2x16float(word_9).x;
}

fn high_half_0( word_10 : u32) -> f32
{
    return unpack2x16float(word_10).y;
}

fn Lit_products_0( this_61 : Lit_0,  kept_0 : vec3<f32>) -> vec3<f32>
{
    var l_0 : f32 = luminance_0(this_61.light_15);
    var a_9 : f32 = luminance_0(kept_0);
    return vec3<f32>(l_0 * l_0, l_0 * a_9, a_9 * a_9);
}

fn lit_of_0( paths_2 : f32,  light_17 : vec3<f32>,  words_3 : vec3<u32>) -> Lit_0
{
    var _S644 : u32 = words_3.x;
    var _S645 : u32 = words_3.y;
    var _S646 : Lit_0 = Lit_x24init_0(paths_2, light_17, vec3<f32>(low_half_0(_S644), high_half_0(_S644), low_half_0(_S645)), vec3<f32>(0.0f));
    var lit_2 : Lit_0 = _S646;
    var _S647 : u32 = words_3.z;
    lit_2.moments_0 = Lit_products_0(_S646, lit_2.shaded_0) * (vec3<f32>(1.0f) + vec3<f32>(high_half_0(_S645), low_half_0(_S647), high_half_0(_S647)));
    return lit_2;
}

fn load_lit_0( index_36 : u32) -> Lit_0
{
    var shaded_2 : vec4<u32> = memory_row_0(u32(1), index_36);
    var light_18 : vec4<u32> = memory_row_0(u32(2), index_36);
    return lit_of_0(low_half_0(shaded_2.x), (bitcast<vec3<f32>>((light_18.xyz))), vec3<u32>(shaded_2.z, shaded_2.w, light_18.w));
}

fn normal_in_0( word_11 : u32) -> vec3<f32>
{
    return vec3<f32>(vec3<i32>((i32((word_11 << (u32(22)))) >> (u32(22))), (i32((word_11 << (u32(12)))) >> (u32(22))), (i32((word_11 << (u32(2)))) >> (u32(22))))) * vec3<f32>(0.00195694714784622f);
}

fn load_memory_0( index_37 : u32) -> Memory_0
{
    var surface_5 : vec4<u32> = memory_row_0(u32(0), index_37);
    var shaded_3 : vec4<u32> = memory_row_0(u32(1), index_37);
    var seen_0 : vec4<u32> = memory_row_0(u32(3), index_37);
    var memory_0 : Memory_0;
    memory_0.lit_0 = load_lit_0(index_37);
    memory_0.looks_0 = high_half_0(shaded_3.x);
    var _S648 : u32 = seen_0.x;
    var _S649 : u32 = seen_0.y;
    memory_0.direct_2 = vec3<f32>(low_half_0(_S648), high_half_0(_S648), low_half_0(_S649));
    var _S650 : u32 = seen_0.z;
    memory_0.albedo_2 = vec3<f32>(high_half_0(_S649), low_half_0(_S650), high_half_0(_S650));
    memory_0.normal_9 = normal_in_0(surface_5.w);
    memory_0.place_10 = (bitcast<vec3<f32>>((surface_5.xyz)));
    var _S651 : u32 = shaded_3.y;
    memory_0.roughness_1 = high_half_0(_S651);
    memory_0.coverage_0 = low_half_0(_S651);
    return memory_0;
}

fn Memory_look_anew_0( this_62 : ptr<function, Memory_0>)
{
    (*this_62).looks_0 = 0.0f;
    (*this_62).coverage_0 = 0.0f;
    (*this_62).roughness_1 = 0.0f;
    return;
}

fn scratch_row_0( row_6 : u32,  index_38 : u32) -> vec2<u32>
{
    return scratch_0[row_6 * real_time_0.pixels_0 + index_38];
}

fn load_known_0( index_39 : u32) -> Lit_0
{
    var light_19 : vec2<u32> = scratch_row_0(u32(7), index_39);
    var _S652 : u32 = light_19.y;
    var _S653 : u32 = light_19.x;
    return lit_of_0(high_half_0(_S652), vec3<f32>(low_half_0(_S653), high_half_0(_S653), low_half_0(_S652)), vec3<u32>(scratch_row_0(u32(8), index_39), scratch_row_0(u32(9), index_39).x));
}

fn memory_before_0( index_40 : u32) -> Memory_0
{
    var memory_1 : Memory_0 = nothing_known_0();
    if(!has_0(u32(4)))
    {
        return memory_1;
    }
    if(has_0(u32(16)))
    {
        memory_1 = load_memory_0(index_40);
        if(!has_0(u32(8)))
        {
            Memory_look_anew_0(&(memory_1));
        }
        return memory_1;
    }
    memory_1.lit_0 = load_known_0(index_40);
    return memory_1;
}

fn load_sample_0( index_41 : u32) -> Sample_0
{
    var b_9 : vec2<u32> = scratch_row_0(u32(1), index_41);
    var d_4 : vec2<f32> = (bitcast<vec2<f32>>((scratch_row_0(u32(3), index_41))));
    var g_0 : vec2<u32> = scratch_row_0(u32(6), index_41);
    var sample_28 : Sample_0;
    sample_28.light_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(0), index_41)))), (bitcast<f32>((b_9.x))));
    sample_28.instance_0 = b_9.y;
    sample_28.direct_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(2), index_41)))), d_4.x);
    sample_28.place_0 = vec3<f32>(d_4.y, (bitcast<vec2<f32>>((scratch_row_0(u32(4), index_41)))));
    sample_28.albedo_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(5), index_41)))), (bitcast<f32>((g_0.x))));
    var _S654 : u32 = g_0.y;
    sample_28.normal_0 = normal_in_0(_S654);
    sample_28.is_shown_0 = ((_S654 & (u32(1073741824)))) != u32(0);
    return sample_28;
}

fn Memory_look_0( this_63 : ptr<function, Memory_0>,  sample_29 : Sample_0)
{
    var _S655 : f32 = (*this_63).looks_0 + 1.0f;
    (*this_63).looks_0 = _S655;
    var share_20 : f32 = 1.0f / _S655;
    var _S656 : vec3<f32> = vec3<f32>(share_20);
    (*this_63).direct_2 = (*this_63).direct_2 + (sample_29.direct_0 - (*this_63).direct_2) * _S656;
    (*this_63).albedo_2 = (*this_63).albedo_2 + (sample_29.albedo_0 - (*this_63).albedo_2) * _S656;
    if(!sample_29.is_shown_0)
    {
        (*this_63).coverage_0 = (*this_63).coverage_0 - (*this_63).coverage_0 * share_20;
        return;
    }
    var covered_0 : f32 = (*this_63).coverage_0 * ((*this_63).looks_0 - 1.0f) + 1.0f;
    (*this_63).coverage_0 = covered_0 * share_20;
    var of_covered_0 : f32 = 1.0f / covered_0;
    var before_0 : vec3<f32> = (*this_63).place_10;
    var _S657 : vec3<f32> = vec3<f32>(of_covered_0);
    (*this_63).normal_9 = (*this_63).normal_9 + (sample_29.normal_0 - (*this_63).normal_9) * _S657;
    (*this_63).place_10 = (*this_63).place_10 + (sample_29.place_0 - (*this_63).place_10) * _S657;
    if(covered_0 > 1.0f)
    {
        var along_1 : f32 = dot_product_0((*this_63).normal_9, sample_29.place_0 - before_0);
        (*this_63).roughness_1 = (*this_63).roughness_1 + (along_1 * along_1 / max(length_squared_0((*this_63).normal_9), 9.99999997475242708e-07f) * (1.0f - of_covered_0) - (*this_63).roughness_1) * of_covered_0;
    }
    return;
}

fn Lit_add_0( this_64 : ptr<function, Lit_0>,  found_1 : vec3<f32>,  albedo_4 : vec3<f32>,  most_0 : f32)
{
    var _S658 : f32 = min((*this_64).paths_0 + 1.0f, most_0);
    (*this_64).paths_0 = _S658;
    var l_1 : f32 = luminance_0(found_1);
    var a_10 : f32 = luminance_0(albedo_4);
    var _S659 : vec3<f32> = vec3<f32>((1.0f / _S658));
    (*this_64).light_15 = (*this_64).light_15 + (found_1 - (*this_64).light_15) * _S659;
    (*this_64).shaded_0 = (*this_64).shaded_0 + (albedo_4 - (*this_64).shaded_0) * _S659;
    (*this_64).moments_0 = (*this_64).moments_0 + (vec3<f32>(l_1 * l_1, l_1 * a_10, a_10 * a_10) - (*this_64).moments_0) * _S659;
    return;
}

fn Memory_add_0( this_65 : ptr<function, Memory_0>,  sample_30 : Sample_0,  most_1 : f32)
{
    Memory_look_0(&((*this_65)), sample_30);
    var _S660 : Lit_0 = (*this_65).lit_0;
    Lit_add_0(&(_S660), sample_30.light_0, sample_30.albedo_0, most_1);
    (*this_65).lit_0 = _S660;
    return;
}

fn halves_1( low_14 : f32,  high_7 : f32) -> u32
{
    return pack2x16float(clamp(vec2<f32>(low_14, high_7), vec2<f32>(-65504.0f), vec2<f32>(65504.0f)));
}

fn Lit_beyond_0( this_66 : Lit_0,  kept_1 : vec3<f32>) -> vec3<f32>
{
    var products_0 : vec3<f32> = Lit_products_0(this_66, kept_1);
    var _S661 : vec3<f32> = vec3<f32>(1.00000000317107685e-30f);
    return select(vec3<f32>(0.0f), this_66.moments_0 / max(products_0, _S661) - vec3<f32>(1.0f), products_0 > _S661);
}

fn words_of_0( lit_3 : Lit_0) -> vec3<u32>
{
    var first_2 : u32 = halves_1(lit_3.shaded_0.x, lit_3.shaded_0.y);
    var last_8 : f32 = low_half_0(halves_1(lit_3.shaded_0.z, 0.0f));
    var beyond_12 : vec3<f32> = Lit_beyond_0(lit_3, vec3<f32>(low_half_0(first_2), high_half_0(first_2), last_8));
    return vec3<u32>(first_2, halves_1(last_8, beyond_12.x), halves_1(beyond_12.y, beyond_12.z));
}

fn store_memory_0( index_42 : u32,  memory_2 : Memory_0)
{
    var pixels_1 : u32 = real_time_0.pixels_0;
    var words_4 : vec3<u32> = words_of_0(memory_2.lit_0);
    var _S662 : u32 = packed_normal_0(memory_2.normal_9);
    var _S663 : u32;
    if((memory_2.coverage_0) > 0.0f)
    {
        _S663 = u32(1073741824);
    }
    else
    {
        _S663 = u32(0);
    }
    memory_rows_0[index_42] = vec4<u32>((bitcast<vec3<u32>>((memory_2.place_10))), (_S662 | (_S663)));
    memory_rows_0[pixels_1 + index_42] = vec4<u32>(halves_1(memory_2.lit_0.paths_0, memory_2.looks_0), halves_1(memory_2.coverage_0, memory_2.roughness_1), words_4.x, words_4.y);
    memory_rows_0[u32(2) * pixels_1 + index_42] = vec4<u32>((bitcast<vec3<u32>>((memory_2.lit_0.light_15))), words_4.z);
    memory_rows_0[u32(3) * pixels_1 + index_42] = vec4<u32>(halves_1(memory_2.direct_2.x, memory_2.direct_2.y), halves_1(memory_2.direct_2.z, memory_2.albedo_2.x), halves_1(memory_2.albedo_2.y, memory_2.albedo_2.z), u32(0));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn remember(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    first_candidates_0 = u32(1);
    is_page_missing_0 = false;
    var at_16 : vec2<u32> = pixel_that_traces_0(id_2.x);
    if(is_inside_0(vec2<i32>(at_16)))
    {
        var index_43 : u32 = index_of_0(at_16);
        var memory_3 : Memory_0 = memory_before_0(index_43);
        Memory_add_0(&(memory_3), load_sample_0(index_43), real_time_0.most_paths_0);
        var looks_2 : u32 = u32(0);
        for(;;)
        {
            var _S664 : bool;
            if(has_0(u32(2)))
            {
                _S664 = (memory_3.looks_0) < 4.0f;
            }
            else
            {
                _S664 = false;
            }
            if(_S664)
            {
            }
            else
            {
                break;
            }
            var looks_3 : u32 = looks_2 + u32(1);
            var _S665 : Sample_0 = sample_of_0(at_16, FrameParams_camera_0(), Sampler_x24init_0(((params_0.seed_0) ^ (u32(2246822507))), index_43, u32(4) * real_time_0.number_0 + looks_3), false);
            Memory_look_0(&(memory_3), _S665);
            looks_2 = looks_3;
        }
        store_memory_0(index_43, memory_3);
    }
    return;
}

fn squares_0() -> vec2<u32>
{
    var _S666 : vec2<u32> = vec2<u32>(u32(5));
    var _S667 : vec2<u32> = (vec2<u32>(params_0.width_0, params_0.height_0) + _S666 - vec2<u32>(u32(1))) / _S666;
    return _S667;
}

fn place_of_square_0( list_0 : u32,  square_2 : u32) -> u32
{
    var count_8 : vec2<u32> = squares_0();
    return u32(4) * real_time_0.pixels_0 + list_0 * count_8.x * count_8.y + square_2;
}

fn found_2( square_3 : u32,  number_3 : u32,  camera_2 : CameraFrame_0) -> vec4<u32>
{
    var columns_0 : u32 = squares_0().x;
    var _S668 : u32 = square_3 % columns_0;
    var _S669 : u32 = square_3 / columns_0;
    var at_17 : vec2<u32> = vec2<u32>(_S668, _S669);
    var _S670 : vec2<u32> = vec2<u32>(u32(5));
    var _S671 : vec2<u32> = at_17 * _S670;
    var _S672 : vec2<u32> = pcg4d_0(vec4<u32>(at_17, number_3, u32(3266489909))).xy % _S670;
    var pixel_4 : vec2<u32> = min(_S671 + _S672, vec2<u32>(params_0.width_0, params_0.height_0) - vec2<u32>(u32(1)));
    var sample_31 : Sample_0 = sample_of_1(pixel_4, camera_2, Sampler_x24init_0(((params_0.seed_0) ^ (u32(3266489909))), index_of_0(pixel_4), number_3), false);
    var light_20 : f32;
    if(sample_31.is_shown_0)
    {
        light_20 = luminance_0(sample_31.light_0) / (luminance_0(sample_31.albedo_0) + 0.00300000002607703f);
    }
    else
    {
        light_20 = 0.0f;
    }
    return vec4<u32>((bitcast<vec3<u32>>((sample_31.place_0))), (bitcast<u32>((light_20))));
}

@compute
@workgroup_size(64, 1, 1)
fn find_now(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    first_candidates_0 = u32(1);
    is_page_missing_0 = false;
    var _S673 : u32 = id_3.x;
    var _S674 : vec2<u32> = squares_0();
    if(_S673 < (_S674.x * _S674.y))
    {
        var _S675 : vec4<u32> = found_2(_S673, real_time_0.number_0, FrameParams_camera_0());
        memory_rows_0[place_of_square_0(u32(0), _S673)] = _S675;
    }
    return;
}

fn camera_before_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, real_time_0.before_eye_0, real_time_0.before_corner_0, real_time_0.before_pixel_x_0, real_time_0.before_pixel_y_0, real_time_0.before_lens_x_0, real_time_0.before_lens_y_0, real_time_0.before_blades_0);
}

@compute
@workgroup_size(64, 1, 1)
fn find_again(@builtin(global_invocation_id) id_4 : vec3<u32>)
{
    first_candidates_0 = u32(1);
    is_page_missing_0 = false;
    var _S676 : u32 = id_4.x;
    var _S677 : vec2<u32> = squares_0();
    if(_S676 < (_S677.x * _S677.y))
    {
        var _S678 : vec4<u32> = found_2(_S676, real_time_0.number_0 - u32(1), camera_before_0());
        memory_rows_0[place_of_square_0(u32(1), _S676)] = _S678;
    }
    return;
}

