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
struct InstanceNode_std430_0
{
    @align(4) min_0 : array<f32, i32(3)>,
    @align(4) index_0 : u32,
    @align(4) max_0 : array<f32, i32(3)>,
    @align(4) is_leaf_0 : u32,
};

@binding(5) @group(0) var<storage, read> instance_nodes_0 : array<InstanceNode_std430_0>;

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

@binding(21) @group(0) var<storage, read_write> pages_0 : array<u32>;

@binding(0) @group(0) var<storage, read> cells_0 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

@binding(6) @group(0) var<storage, read> material_rows_0 : array<vec4<u32>>;

struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

struct PixelRecord_std430_0
{
    @align(4) radiance_1 : array<u32, i32(6)>,
    @align(4) samples_0 : u32,
    @align(4) covered_0 : u32,
};

@binding(10) @group(0) var<storage, read_write> pixels_0 : array<PixelRecord_std430_0>;

struct Dispatch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) count_0 : u32,
    @align(8) samples_1 : u32,
    @align(4) samples_target_0 : u32,
    @align(16) padding_0 : vec3<u32>,
    @align(4) sequence_0 : u32,
};

@binding(16) @group(0) var<uniform> dispatch_0 : Dispatch_std140_0;
@binding(15) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

@binding(17) @group(0) var<storage, read> top_light_node_rows_0 : array<vec4<u32>>;

@binding(8) @group(0) var<storage, read> light_node_rows_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read> emitter_rows_0 : array<vec4<u32>>;

struct RayRecord_std430_0
{
    @align(4) origin_1 : array<f32, i32(3)>,
    @align(4) t_min_0 : f32,
    @align(4) direction_0 : array<f32, i32(3)>,
    @align(4) t_max_0 : f32,
};

@binding(11) @group(0) var<storage, read> rays_0 : array<RayRecord_std430_0>;

struct HitRecord_std430_0
{
    @align(4) t_0 : f32,
    @align(4) instance_0 : u32,
    @align(4) voxel_0 : array<i32, i32(3)>,
    @align(4) face_0 : u32,
};

@binding(12) @group(0) var<storage, read_write> hits_0 : array<HitRecord_std430_0>;

@id(6) override SKY_0 : u32 = u32(0);

struct Hit_0
{
     t_1 : f32,
     instance_1 : u32,
     voxel_1 : vec3<i32>,
     face_1 : u32,
};

struct Sampler_0
{
     seed_1 : u32,
     pixel_0 : u32,
     sample_0 : u32,
};

struct Ray_0
{
     origin_2 : vec3<f32>,
     t_min_1 : f32,
     direction_1 : vec3<f32>,
     t_max_1 : f32,
};

struct Selection_0
{
     sun_0 : f32,
     sky_1 : f32,
     emitters_0 : f32,
};

struct Inside_0
{
     instance_2 : u32,
     voxel_2 : vec3<i32>,
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
     normal_0 : vec3<f32>,
     selection_0 : Selection_0,
     passed_t_0 : f32,
     inside_0 : Inside_0,
     is_clipped_0 : bool,
};

@id(1) override IS_SINGLE_0 : bool = false;

struct LocalRay_0
{
     origin_3 : vec3<f32>,
     direction_2 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_2 : f32,
     t_max_2 : f32,
     is_valid_0 : bool,
};

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn Transform_direction_0( _S1 : u32,  _S2 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S1].grid_from_world_0.x_axis_0) * vec3<f32>(_S2.x) + vector_of_0(instances_0[_S1].grid_from_world_0.y_axis_0) * vec3<f32>(_S2.y) + vector_of_0(instances_0[_S1].grid_from_world_0.z_axis_0) * vec3<f32>(_S2.z);
}

fn Transform_point_0( _S3 : u32,  _S4 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S3, _S4) + vector_of_0(instances_0[_S3].grid_from_world_0.translation_0);
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
    var _S5 : i32 = i32(divisor_0);
    var _S6 : i32 = i32(2) * (rest_0 - units_0 * _S5);
    return guess_0 + u32(units_0 + (i32(_S6 > _S5) - i32(_S6 < (- _S5))));
}

fn divide_0( a_0 : f32,  b_0 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_0 / b_0;
    }
    var _S7 : u32 = (bitcast<u32>((a_0)));
    var exponent_a_0 : u32 = (((_S7 >> (u32(23)))) & (u32(255)));
    var _S8 : u32 = (bitcast<u32>((b_0)));
    var exponent_b_0 : u32 = (((_S8 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S7 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S8 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_1 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S9 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S9 = true;
    }
    else
    {
        _S9 = !is_normal_0(exponent_b_0);
    }
    if(_S9)
    {
        _S9 = true;
    }
    else
    {
        _S9 = !is_normal_0(exponent_1);
    }
    if(_S9)
    {
        return a_0 / b_0;
    }
    return (bitcast<f32>(((((((_S7 ^ (_S8))) & (u32(2147483648)))) | ((((exponent_1 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn reciprocal_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_0.x), divide_0(1.0f, vector_0.y), divide_0(1.0f, vector_0.z));
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn local_ray_0( _S10 : Ray_0,  _S11 : u32) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_3 : vec3<f32>;
    var origin_4 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S12 : vec3<f32> = Transform_point_0(_S11, _S10.origin_2);
        direction_3 = Transform_direction_0(_S11, _S10.direction_1);
        origin_4 = _S12;
    }
    else
    {
        direction_3 = _S10.direction_1;
        origin_4 = _S10.origin_2;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_3)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S13 : vec3<f32> = select(direction_3, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_2 = _S13;
    local_0.inverse_0 = select(reciprocal_0(select(direction_3, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_3 = select(origin_4, floor(origin_4) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S13));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_0.origin_3)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((_S10.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S10.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S10.t_min_1) <= (_S10.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_2 = _S10.t_min_1;
    local_0.t_max_2 = _S10.t_max_1;
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

fn Hit_x24init_0( t_2 : f32,  instance_3 : u32,  voxel_3 : vec3<i32>,  face_2 : u32) -> Hit_0
{
    var _S14 : Hit_0;
    _S14.t_1 = t_2;
    _S14.instance_1 = instance_3;
    _S14.voxel_1 = voxel_3;
    _S14.face_1 = face_2;
    return _S14;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

struct Walk_0
{
     ray_0 : LocalRay_0,
     origin_5 : vec3<f32>,
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
    var _S15 : f32;
    if(IS_EXACT_0)
    {
        _S15 = 0.0f;
    }
    else
    {
        _S15 = 1.00000004581370497e-18f;
    }
    return _S15;
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

fn LocalRay_tolerance_0( this_1 : LocalRay_0,  low_0 : vec3<i32>,  high_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_1.origin_3) + (vec3<f32>(max(abs(low_0), abs(high_0))) + vec3<f32>(1.0f))) * vec3<f32>(5.36441802978515625e-07f), vec3<f32>(-1.0f), (this_1.direction_2) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_2 : LocalRay_0) -> f32
{
    return min(this_2.t_max_2 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S16 : LocalRay_0,  _S17 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_0 = _S16;
    walk_0.grid_origin_0 = cell_of_0(grids_0[_S17].origin_0);
    var is_negative_0 : vec3<bool> = (_S16.direction_2) < vec3<f32>(0.0f);
    var _S18 : vec3<i32> = vec3<i32>(i32(0));
    walk_0.mirror_0 = select(_S18, vec3<i32>(i32(-1)), is_negative_0);
    var _S19 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S19 = Walk_mirrored_plane_0(walk_0, walk_0.grid_origin_0);
    }
    else
    {
        _S19 = _S18;
    }
    walk_0.offset_0 = _S19;
    var origin_6 : vec3<f32>;
    if(IS_EXACT_0)
    {
        origin_6 = _S16.origin_3;
    }
    else
    {
        origin_6 = _S16.origin_3 - vec3<f32>(walk_0.grid_origin_0);
    }
    walk_0.origin_5 = select(origin_6, (vec3<f32>(0) - origin_6), is_negative_0);
    walk_0.speed_1 = max(abs(_S16.direction_2), vec3<f32>(min_abs_direction_0()));
    if(IS_EXACT_0)
    {
        origin_6 = abs(_S16.inverse_0);
    }
    else
    {
        origin_6 = vec3<f32>(1.0f) / walk_0.speed_1;
    }
    walk_0.inverse_1 = origin_6;
    var top_shift_1 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_1 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_1 = grids_0[_S17].top_shift_0;
    }
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S16, walk_0.grid_origin_0, walk_0.grid_origin_0 + (((cell_of_0(grids_0[_S17].top_size_0)) << (vec3<u32>(top_shift_1)))));
    walk_0.t_end_0 = LocalRay_t_end_0(_S16);
    return walk_0;
}

fn Walk_mirrored_0( this_3 : Walk_0,  voxel_4 : vec3<i32>) -> vec3<i32>
{
    return (voxel_4 ^ ((this_3.mirror_0)));
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
    var _S20 : f32 = a_parts_0.x;
    var _S21 : f32 = b_parts_0.x;
    var _S22 : f32 = b_parts_0.y;
    var _S23 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S20 * _S21 - product_0 + _S20 * _S22 + _S23 * _S21 + _S23 * _S22);
}

fn exact_start_voxel_0( ray_1 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(0)]);
    var _S24 : f32 = way_0.x;
    var sum_0 : f32 = ray_1.origin_3[u32(0)] + _S24;
    var part_0 : f32 = sum_0 - ray_1.origin_3[u32(0)];
    var low_1 : f32 = ray_1.origin_3[u32(0)] - (sum_0 - part_0) + (_S24 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_5 : vec3<i32>;
    var _S25 : i32 = i32(whole_0);
    var _S26 : bool;
    if(sum_0 == whole_0)
    {
        _S26 = low_1 < 0.0f;
    }
    else
    {
        _S26 = false;
    }
    voxel_5[u32(0)] = _S25 - i32(_S26);
    var way_1 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(1)]);
    var _S27 : f32 = way_1.x;
    var sum_1 : f32 = ray_1.origin_3[u32(1)] + _S27;
    var part_1 : f32 = sum_1 - ray_1.origin_3[u32(1)];
    var low_2 : f32 = ray_1.origin_3[u32(1)] - (sum_1 - part_1) + (_S27 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_1);
    var _S28 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S26 = low_2 < 0.0f;
    }
    else
    {
        _S26 = false;
    }
    voxel_5[u32(1)] = _S28 - i32(_S26);
    var way_2 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(2)]);
    var _S29 : f32 = way_2.x;
    var sum_2 : f32 = ray_1.origin_3[u32(2)] + _S29;
    var part_2 : f32 = sum_2 - ray_1.origin_3[u32(2)];
    var low_3 : f32 = ray_1.origin_3[u32(2)] - (sum_2 - part_2) + (_S29 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_2);
    var _S30 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S26 = low_3 < 0.0f;
    }
    else
    {
        _S26 = false;
    }
    voxel_5[u32(2)] = _S30 - i32(_S26);
    return voxel_5;
}

fn Walk_start_voxel_0( this_4 : Walk_0) -> vec3<i32>
{
    var start_0 : vec3<f32> = clamp(this_4.ray_0.origin_3 + this_4.ray_0.direction_2 * vec3<f32>(this_4.ray_0.t_min_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_4, vec3<i32>(floor(start_0)) - this_4.grid_origin_0);
    }
    var nearest_0 : vec3<f32> = round(start_0);
    var from_nearest_0 : vec3<f32> = start_0 - nearest_0;
    var _S31 : bool;
    if((this_4.ray_0.t_min_2) > 0.0f)
    {
        _S31 = (any(((abs(from_nearest_0)) <= (this_4.tolerance_0))));
    }
    else
    {
        _S31 = false;
    }
    if(_S31)
    {
        return Walk_mirrored_0(this_4, exact_start_voxel_0(this_4.ray_0) - this_4.grid_origin_0);
    }
    return Walk_mirrored_0(this_4, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_4.grid_origin_0);
}

fn Walk_crossings_0( this_5 : Walk_0,  planes_1 : vec3<i32>) -> vec3<f32>
{
    return (vec3<f32>(planes_1 + this_5.offset_0) - this_5.origin_5) * this_5.inverse_1;
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
    var _S32 : Crossing_0;
    _S32.distance_0 = distance_1;
    _S32.distance_low_0 = distance_low_1;
    _S32.speed_2 = speed_3;
    _S32.axis_0 = axis_1;
    return _S32;
}

fn crossing_of_0( ray_2 : LocalRay_0,  axis_2 : u32,  plane_1 : i32) -> Crossing_0
{
    var sign_0 : f32;
    if((ray_2.direction_2[axis_2]) < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var at_0 : f32 = f32(plane_1);
    var difference_0 : f32 = at_0 - ray_2.origin_3[axis_2];
    var part_3 : f32 = difference_0 - at_0;
    return Crossing_x24init_0(difference_0 * sign_0, (at_0 - (difference_0 - part_3) - (ray_2.origin_3[axis_2] + part_3)) * sign_0, abs(ray_2.direction_2[axis_2]), axis_2);
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
    var _S33 : bool;
    if(difference_1 < 0.0f)
    {
        _S33 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S33 = (this_6.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S33 = false;
        }
    }
    return _S33;
}

fn leave_box_0( ray_3 : LocalRay_0,  voxel_6 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_1 : vec3<i32>) -> vec3<i32>
{
    var _S34 : vec3<f32>;
    var _S35 : f32;
    var _S36 : bool;
    var is_crossed_0 : bool;
    var first_1 : Crossing_0;
    var _S37 : f32;
    var _S38 : bool;
    var _S39 : f32;
    var _S40 : bool;
    var plane_2 : i32;
    var _S41 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S34 = ray_3.direction_2;
                _S35 = ray_3.direction_2[u32(0)];
                var _S42 : bool = (ray_3.direction_2[u32(0)]) == 0.0f;
                _S36 = _S42;
                if(_S42)
                {
                    first_1 = _S41;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_3, u32(0), exit_0[u32(0)]);
                if((_S41.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_0, _S41);
                }
                if(is_crossed_0)
                {
                    first_1 = crossing_0;
                }
                else
                {
                    first_1 = _S41;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S37 = _S34[u32(1)];
                var _S43 : bool = (_S34[u32(1)]) == 0.0f;
                _S38 = _S43;
                if(_S43)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_3, u32(1), exit_0[u32(1)]);
                if((first_1.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_1, first_1);
                }
                if(is_crossed_0)
                {
                    first_1 = crossing_1;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S39 = _S34[u32(2)];
                var _S44 : bool = (_S34[u32(2)]) == 0.0f;
                _S40 = _S44;
                if(_S44)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_3, u32(2), exit_0[u32(2)]);
                if((first_1.axis_0) == u32(3))
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_2, first_1);
                }
                if(is_crossed_0)
                {
                    first_1 = crossing_2;
                }
                break;
            }
            break;
        }
        break;
    }
    var arrival_0 : vec3<i32> = voxel_6;
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if(_S36)
                {
                    break;
                }
                var _S45 : bool = u32(0) == (first_1.axis_0);
                if(_S45)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_3, u32(0), nearest_1[u32(0)]), first_1);
                }
                if(_S45)
                {
                    plane_2 = exit_0[u32(0)];
                }
                else
                {
                    plane_2 = nearest_1[u32(0)];
                }
                arrival_0[u32(0)] = plane_2 - i32(is_crossed_0 == (_S35 < 0.0f));
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S38)
                {
                    break;
                }
                var _S46 : bool = u32(1) == (first_1.axis_0);
                if(_S46)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_3, u32(1), nearest_1[u32(1)]), first_1);
                }
                if(_S46)
                {
                    plane_2 = exit_0[u32(1)];
                }
                else
                {
                    plane_2 = nearest_1[u32(1)];
                }
                arrival_0[u32(1)] = plane_2 - i32(is_crossed_0 == (_S37 < 0.0f));
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
                var _S47 : bool = u32(2) == (first_1.axis_0);
                if(_S47)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_of_0(ray_3, u32(2), nearest_1[u32(2)]), first_1);
                }
                if(_S47)
                {
                    plane_2 = exit_0[u32(2)];
                }
                else
                {
                    plane_2 = nearest_1[u32(2)];
                }
                arrival_0[u32(2)] = plane_2 - i32(is_crossed_0 == (_S39 < 0.0f));
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn Walk_arrive_0( this_7 : Walk_0,  voxel_7 : vec3<i32>,  t_3 : f32,  is_axis_0 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_0 : vec3<f32> = this_7.origin_5 + this_7.speed_1 * vec3<f32>(t_3);
    if(IS_EXACT_0)
    {
        var position_1 : vec3<f32> = clamp(position_0, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_2 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_2;
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_0, (abs(from_nearest_1)) <= (this_7.tolerance_0)))))))
        {
            return max(Walk_mirrored_0(this_7, leave_box_0(this_7.ray_0, Walk_mirrored_0(this_7, voxel_7) + this_7.grid_origin_0, Walk_mirrored_plane_0(this_7, exit_1) + this_7.grid_origin_0, Walk_mirrored_plane_0(this_7, vec3<i32>(nearest_2))) - this_7.grid_origin_0), voxel_7);
        }
        return select(vec3<i32>(nearest_2) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f)) - this_7.offset_0, exit_1, is_axis_0);
    }
    return max(vec3<i32>(floor(position_0)), select(voxel_7, exit_1, is_axis_0));
}

fn Walk_enter_rounded_0( this_8 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  near_0 : vec3<i32>,  far_0 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_8) < near_0;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_8.speed_1) <= vec3<f32>(min_abs_direction_0()), is_before_0)))))
        {
            return false;
        }
        var t_4 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_8, near_0), is_before_0);
        var t_last_0 : f32 = max_element_0(t_4);
        if(t_last_0 > (this_8.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_4.x) == t_last_0;
        var _S48 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S48)
        {
            is_y_0 = (t_4.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S49 : bool;
        if(_S48)
        {
            _S49 = !is_y_0;
        }
        else
        {
            _S49 = false;
        }
        var is_axis_1 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S49);
        (*voxel_8) = Walk_arrive_0(this_8, (*voxel_8), t_last_0, is_axis_1, select(vec3<i32>(i32(1073741823)), near_0, is_axis_1));
    }
    return (all(((*voxel_8) < far_0)));
}

fn min_element_0( vector_2 : vec3<f32>) -> f32
{
    return min(min(vector_2.x, vector_2.y), vector_2.z);
}

fn Walk_leave_rounded_0( this_9 : Walk_0,  voxel_9 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_5 : vec3<f32> = Walk_crossings_0(this_9, exit_2);
    var t_first_0 : f32 = min_element_0(t_5);
    if(t_first_0 >= (this_9.t_end_0))
    {
        return false;
    }
    (*voxel_9) = max(exit_2 - vec3<i32>(ceil((t_5 - vec3<f32>(t_first_0)) * this_9.speed_1)), (*voxel_9));
    return true;
}

fn Walk_leave_0( this_10 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S50 : bool = Walk_leave_rounded_0(this_10, &((*voxel_10)), exit_3);
        return _S50;
    }
    var t_6 : vec3<f32> = Walk_crossings_0(this_10, exit_3);
    var t_first_1 : f32 = min_element_0(t_6);
    if(t_first_1 > (this_10.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = (t_6.x) == t_first_1;
    var _S51 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S51)
    {
        is_y_1 = (t_6.y) == t_first_1;
    }
    else
    {
        is_y_1 = false;
    }
    var back_0 : vec3<f32> = (t_6 - vec3<f32>(t_first_1)) * this_10.speed_1;
    var nearest_3 : vec3<f32> = round(back_0);
    var from_nearest_2 : vec3<f32> = back_0 - nearest_3;
    var planes_2 : vec3<i32> = exit_3 - vec3<i32>(min(nearest_3, vec3<f32>(4.194304e+06f)));
    var _S52 : vec3<i32> = planes_2 - vec3<i32>(from_nearest_2 > vec3<f32>(0.0f));
    var _S53 : vec3<bool> = (abs(from_nearest_2)) <= (this_10.tolerance_0);
    var _S54 : bool;
    if(_S51)
    {
        _S54 = !is_y_1;
    }
    else
    {
        _S54 = false;
    }
    var arrival_1 : vec3<i32>;
    if((any((select(vec3<bool>(false), !vec3<bool>(is_x_1, is_y_1, _S54), _S53)))))
    {
        arrival_1 = Walk_mirrored_0(this_10, leave_box_0(this_10.ray_0, Walk_mirrored_0(this_10, (*voxel_10)) + this_10.grid_origin_0, Walk_mirrored_plane_0(this_10, exit_3) + this_10.grid_origin_0, Walk_mirrored_plane_0(this_10, planes_2) + this_10.grid_origin_0) - this_10.grid_origin_0);
    }
    else
    {
        arrival_1 = _S52;
    }
    (*voxel_10) = select(max(arrival_1, (*voxel_10)), (*voxel_10), (this_10.speed_1) == vec3<f32>(0.0f));
    return true;
}

fn Walk_enter_0( this_11 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  low_4 : vec3<i32>,  high_2 : vec3<i32>) -> bool
{
    var _S55 : bool;
    var is_mirrored_0 : vec3<bool> = (this_11.mirror_0) != vec3<i32>(i32(0));
    var near_1 : vec3<i32> = select(low_4, (vec3<i32>(0) - high_2), is_mirrored_0);
    var far_1 : vec3<i32> = select(high_2, (vec3<i32>(0) - low_4), is_mirrored_0);
    if(!IS_EXACT_0)
    {
        var _S56 : bool = Walk_enter_rounded_0(this_11, &((*voxel_11)), near_1, far_1);
        return _S56;
    }
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
            _S55 = (any(((*voxel_11) < near_1)));
        }
        else
        {
            _S55 = false;
        }
        var _S57 : bool;
        if(_S55)
        {
            _S57 = (all(((*voxel_11) < far_1)));
        }
        else
        {
            _S57 = false;
        }
        if(_S57)
        {
        }
        else
        {
            break;
        }
        var _S58 : bool = Walk_leave_0(this_11, &((*voxel_11)), select(far_1, near_1, (*voxel_11) < near_1));
        if(!_S58)
        {
            return false;
        }
        axis_3 = axis_3 + u32(1);
    }
    if((all(((*voxel_11) >= near_1))))
    {
        _S55 = (all(((*voxel_11) < far_1)));
    }
    else
    {
        _S55 = false;
    }
    return _S55;
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

fn word_in_pages_0( index_1 : u32,  first_2 : u32) -> u32
{
    var page_0 : u32 = first_2 + ((index_1 >> (u32(10))));
    var mark_0 : u32 = u32(8) + pages_0[i32(0)] + page_0;
    if(pages_0[mark_0] == u32(0))
    {
        pages_0[mark_0] = u32(1);
    }
    var slot_0 : u32 = pages_0[u32(8) + page_0];
    var _S59 : bool;
    if(is_page_missing_0)
    {
        _S59 = true;
    }
    else
    {
        _S59 = slot_0 == u32(0);
    }
    is_page_missing_0 = _S59;
    return (((slot_0 << (u32(10)))) | (((index_1 & (u32(1023))))));
}

fn place_of_cell_0( index_2 : u32) -> u32
{
    var _S60 : u32;
    if(HAS_PAGES_0)
    {
        var _S61 : u32 = word_in_pages_0(index_2, u32(0));
        _S60 = _S61;
    }
    else
    {
        _S60 = index_2;
    }
    return _S60;
}

fn cell_word_0( index_3 : u32) -> u32
{
    var _S62 : u32 = place_of_cell_0(index_3);
    return cells_0[_S62];
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

fn waits_for_pages_0() -> bool
{
    var _S63 : bool;
    if(HAS_PAGES_0)
    {
        _S63 = is_page_missing_0;
    }
    else
    {
        _S63 = false;
    }
    return _S63;
}

@id(11) override CELLS_SKIP_0 : bool = false;

fn skip_distance_0( cell_1 : u32,  octant_1 : u32) -> u32
{
    var code_0 : u32 = (((cell_1 >> ((u32(3) * octant_1)))) & (u32(7)));
    var _S64 : u32;
    if(code_0 < u32(2))
    {
        _S64 = code_0 + u32(1);
    }
    else
    {
        _S64 = ((u32(3) + ((code_0 & (u32(1))))) << ((((code_0 >> (u32(1)))) - u32(1))));
    }
    return _S64;
}

fn extents_0( cell_2 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_2 & (ahead_0))) | (((((cell_2 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_3 : u32) -> u32
{
    var _S65 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S65 = u32(8388607);
    }
    else
    {
        _S65 = u32(2147483647);
    }
    return ((cell_3 & (_S65))) * u32(2);
}

fn blocks_of_cell_0( cell_4 : u32) -> u32
{
    return (((cell_4 >> (u32(23)))) & (u32(255)));
}

fn place_of_brick_0( index_4 : u32) -> u32
{
    var _S66 : u32;
    if(HAS_PAGES_0)
    {
        var _S67 : u32 = word_in_pages_0(index_4, pages_0[i32(1)]);
        _S66 = _S67;
    }
    else
    {
        _S66 = index_4;
    }
    return _S66;
}

fn brick_word_0( index_5 : u32) -> u32
{
    var _S68 : u32 = place_of_brick_0(index_5);
    return bricks_0[_S68];
}

fn blocks_of_record_0( record_0 : u32) -> u32
{
    var _S69 : u32 = brick_word_0(record_0);
    return (_S69 & (u32(255)));
}

fn empty_around_0( record_1 : u32,  blocks_0 : u32,  voxel_12 : vec3<i32>,  octant_2 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_12.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_12.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_12.z) & (i32(4))))))) ^ (octant_2));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_0 : u32 = ((cell_in_node_0(voxel_12, u32(0))) ^ (flip_0));
    var half_0 : u32 = brick_word_0(record_1 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_0 >> (u32(5)))));
    if(((((half_0 >> (((bit_0 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S70 : i32;
    if(((((half_0 >> (((bit_0 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S70 = i32(1);
    }
    else
    {
        _S70 = i32(0);
    }
    return u32(_S70);
}

fn Walk_leave_1( this_13 : Walk_0,  voxel_13 : ptr<function, vec3<i32>>,  exit_4 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S71 : bool = Walk_leave_rounded_0(this_13, &((*voxel_13)), exit_4);
        return _S71;
    }
    var t_7 : vec3<f32> = Walk_crossings_0(this_13, exit_4);
    var t_first_2 : f32 = min_element_0(t_7);
    if(t_first_2 > (this_13.t_end_0))
    {
        return false;
    }
    var is_x_2 : bool = (t_7.x) == t_first_2;
    var _S72 : bool = !is_x_2;
    var is_y_2 : bool;
    if(_S72)
    {
        is_y_2 = (t_7.y) == t_first_2;
    }
    else
    {
        is_y_2 = false;
    }
    var back_1 : vec3<f32> = (t_7 - vec3<f32>(t_first_2)) * this_13.speed_1;
    var nearest_4 : vec3<f32> = round(back_1);
    var from_nearest_3 : vec3<f32> = back_1 - nearest_4;
    var planes_3 : vec3<i32> = exit_4 - vec3<i32>(min(nearest_4, vec3<f32>(4.194304e+06f)));
    var _S73 : vec3<i32> = planes_3 - vec3<i32>(from_nearest_3 > vec3<f32>(0.0f));
    var _S74 : vec3<bool> = (abs(from_nearest_3)) <= (this_13.tolerance_0);
    var _S75 : bool;
    if(_S72)
    {
        _S75 = !is_y_2;
    }
    else
    {
        _S75 = false;
    }
    var arrival_2 : vec3<i32>;
    if((any((select(vec3<bool>(false), !vec3<bool>(is_x_2, is_y_2, _S75), _S74)))))
    {
        arrival_2 = Walk_mirrored_0(this_13, leave_box_0(this_13.ray_0, Walk_mirrored_0(this_13, (*voxel_13)) + this_13.grid_origin_0, Walk_mirrored_plane_0(this_13, exit_4) + this_13.grid_origin_0, Walk_mirrored_plane_0(this_13, planes_3) + this_13.grid_origin_0) - this_13.grid_origin_0);
    }
    else
    {
        arrival_2 = _S73;
    }
    (*voxel_13) = select(max(arrival_2, (*voxel_13)), (*voxel_13), (this_13.speed_1) == vec3<f32>(0.0f));
    return true;
}

fn first_voxel_0( _S76 : u32,  _S77 : Walk_0,  _S78 : ptr<function, vec3<i32>>) -> bool
{
    var _S79 : Walk_0 = _S77;
    var _S80 : vec3<i32> = vec3<i32>(i32(0));
    (*_S78) = _S80;
    var voxel_14 : vec3<i32> = Walk_start_voxel_0(_S77);
    var _S81 : bool = Walk_enter_0(_S77, &(voxel_14), cell_of_0(grids_0[_S76].min_1) - _S79.grid_origin_0, cell_of_0(grids_0[_S76].max_1) - _S79.grid_origin_0);
    if(!_S81)
    {
        return false;
    }
    var octant_3 : u32 = LocalRay_octant_0(_S79.ray_0);
    var _S82 : u32 = flip_of_0(octant_3);
    var top_shift_2 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_2 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_2 = grids_0[_S76].top_shift_0;
    }
    var top_size_1 : vec3<i32> = cell_of_0(grids_0[_S76].top_size_0);
    var _S83 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S83, _S83 * top_size_1.y);
    var _S84 : i32 = i32(grids_0[_S76].top_offset_0) - dot_cells_0((stride_0 & ((_S79.mirror_0))), vec3<i32>(i32(1)));
    var _S85 : vec3<i32> = Walk_mirrored_plane_0(_S79, stride_0);
    var _S86 : u32 = ahead_of_0(_S79.mirror_0);
    var end_0 : vec3<i32> = select((top_size_1 << (vec3<u32>(top_shift_2))), _S80, (_S79.mirror_0) != _S80);
    if(!IS_EXACT_0)
    {
        _S79.t_end_0 = min(_S79.t_end_0, min_element_0(Walk_crossings_0(_S79, end_0)));
    }
    var is_found_0 : bool = false;
    for(;;)
    {
        var _S87 : bool;
        if(IS_EXACT_0)
        {
            _S87 = (any((voxel_14 >= end_0)));
        }
        else
        {
            _S87 = false;
        }
        if(_S87)
        {
            break;
        }
        var cell_5 : u32 = cell_word_0(u32(_S84 + dot_cells_0(_S85, (voxel_14 >> (vec3<u32>(top_shift_2))))));
        var cell_6 : u32;
        var shift_1 : u32;
        var is_found_1 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_5 & (u32(2147483648)))) != u32(0))
            {
                var _S88 : u32 = cell_word_0(((cell_5 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_14, u32(3))) ^ (_S82))));
                cell_6 = _S88;
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
                var _S89 : bool;
                if(is_found_1)
                {
                    _S89 = ((cell_6 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S89 = false;
                }
                if(_S89)
                {
                }
                else
                {
                    break;
                }
                var shift_2 : u32 = shift_1 - u32(2);
                var _S90 : u32 = cell_word_0(((cell_6 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_14, shift_2)) ^ (_S82))));
                cell_6 = _S90;
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
                exit_5 = extents_0(cell_6, _S86);
            }
            exit_5 = ((voxel_14 | (vec3<i32>((((i32(1) << (shift_1))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_5 << (vec3<u32>(shift_1))));
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
                var _S91 : u32 = blocks_of_record_0(record_2);
                blocks_1 = _S91;
            }
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_14, octant_3, _S82);
            var is_found_2 : bool = low_bits_0 == u32(4294967295);
            if(is_found_2)
            {
                is_found_0 = is_found_2;
                break;
            }
            exit_5 = ((voxel_14 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_1 = is_found_2;
        }
        var _S92 : bool = Walk_leave_1(_S79, &(voxel_14), exit_5);
        if(!_S92)
        {
            is_found_0 = is_found_1;
            break;
        }
        is_found_0 = is_found_1;
    }
    (*_S78) = Walk_mirrored_0(_S79, voxel_14) + _S79.grid_origin_0;
    return is_found_0;
}

fn Ray_x24init_0( origin_7 : vec3<f32>,  t_min_3 : f32,  direction_4 : vec3<f32>,  t_max_3 : f32) -> Ray_0
{
    var _S93 : Ray_0;
    _S93.origin_2 = origin_7;
    _S93.t_min_1 = t_min_3;
    _S93.direction_1 = direction_4;
    _S93.t_max_1 = t_max_3;
    return _S93;
}

fn ray_of_walk_0( walk_1 : Walk_0,  ray_4 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (walk_1.mirror_0) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_1.origin_5, (vec3<f32>(0) - walk_1.origin_5), is_mirrored_1) + vec3<f32>(walk_1.grid_origin_0), ray_4.t_min_1, select(walk_1.speed_1, (vec3<f32>(0) - walk_1.speed_1), is_mirrored_1), ray_4.t_max_1);
}

fn hit_of_0( ray_5 : LocalRay_0,  voxel_15 : vec3<i32>,  instance_4 : u32) -> Hit_0
{
    var _S94 : vec3<f32>;
    var _S95 : bool;
    var last_0 : Crossing_0;
    var _S96 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S94 = ray_5.direction_2;
                if((ray_5.direction_2[u32(0)]) == 0.0f)
                {
                    last_0 = _S96;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_5, u32(0), voxel_15[u32(0)] + i32((ray_5.direction_2[u32(0)]) < 0.0f));
                if((_S96.axis_0) == u32(3))
                {
                    _S95 = true;
                }
                else
                {
                    _S95 = !Crossing_is_before_0(crossing_3, _S96);
                }
                if(_S95)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S96;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S97 : vec3<f32> = _S94;
                if((_S94[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_5, u32(1), voxel_15[u32(1)] + i32((_S97[u32(1)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S95 = true;
                }
                else
                {
                    _S95 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S95)
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
                var _S98 : vec3<f32> = _S94;
                if((_S94[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_5, u32(2), voxel_15[u32(2)] + i32((_S98[u32(2)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S95 = true;
                }
                else
                {
                    _S95 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S95)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S99 : Crossing_0 = last_0;
    var is_negative_1 : bool = (_S94[last_0.axis_0]) < 0.0f;
    var t_8 : f32 = (f32(voxel_15[last_0.axis_0] + i32(is_negative_1)) - ray_5.origin_3[last_0.axis_0]) * ray_5.inverse_0[last_0.axis_0];
    var _S100 : f32;
    if(t_8 > (ray_5.t_min_2))
    {
        _S100 = t_8;
    }
    else
    {
        _S100 = ray_5.t_min_2;
    }
    return Hit_x24init_0(_S100, instance_4, voxel_15, u32(2) * _S99.axis_0 + u32(is_negative_1));
}

fn hit_of_walk_0( walk_2 : Walk_0,  voxel_16 : vec3<i32>,  instance_5 : u32) -> Hit_0
{
    var t_9 : vec3<f32> = Walk_crossings_0(walk_2, Walk_mirrored_0(walk_2, voxel_16 - walk_2.grid_origin_0));
    var last_1 : f32 = max_element_0(t_9);
    var _S101 : i32;
    if((t_9.z) == last_1)
    {
        _S101 = i32(2);
    }
    else
    {
        if((t_9.y) == last_1)
        {
            _S101 = i32(1);
        }
        else
        {
            _S101 = i32(0);
        }
    }
    var axis_4 : u32 = u32(_S101);
    return Hit_x24init_0(max(last_1, walk_2.ray_0.t_min_2), instance_5, voxel_16, u32(2) * axis_4 + u32((walk_2.mirror_0[axis_4]) != i32(0)));
}

fn hit_in_0( instance_6 : u32,  ray_6 : ptr<function, Ray_0>) -> Hit_0
{
    var _S102 : LocalRay_0 = local_ray_0((*ray_6), instance_6);
    if(!_S102.is_valid_0)
    {
        return miss_0();
    }
    var _S103 : Walk_0 = walk_of_0(_S102, instances_0[instance_6].grid_0);
    var voxel_17 : vec3<i32>;
    var _S104 : bool = first_voxel_0(instances_0[instance_6].grid_0, _S103, &(voxel_17));
    var _S105 : bool;
    if(IS_SINGLE_0)
    {
        _S105 = !IS_EXACT_0;
    }
    else
    {
        _S105 = false;
    }
    if(_S105)
    {
        (*ray_6) = ray_of_walk_0(_S103, (*ray_6));
    }
    if(!_S104)
    {
        return miss_0();
    }
    var hit_0 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_0 = hit_of_0(_S102, voxel_17, instance_6);
    }
    else
    {
        hit_0 = hit_of_walk_0(_S103, voxel_17, instance_6);
    }
    if((hit_0.t_1) > ((*ray_6).t_max_1))
    {
        return miss_0();
    }
    return hit_0;
}

fn entry_0( _S106 : u32,  _S107 : Ray_0,  _S108 : vec3<f32>) -> f32
{
    var low_5 : vec3<f32> = (vector_of_0(instance_nodes_0[_S106].min_0) - _S107.origin_2) * _S108;
    var high_3 : vec3<f32> = (vector_of_0(instance_nodes_0[_S106].max_0) - _S107.origin_2) * _S108;
    var _S109 : f32 = max(_S107.t_min_1, max_element_0(min(low_5, high_3)));
    var _S110 : f32;
    if(_S109 <= (min(_S107.t_max_1, min_element_0(max(low_5, high_3)))))
    {
        _S110 = _S109;
    }
    else
    {
        _S110 = (bitcast<f32>((u32(2139095040))));
    }
    return _S110;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool,  end_1 : u32) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S111 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S111;
    }
    var ray_7 : Ray_0 = (*given_0);
    var nearest_5 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_5;
    }
    var is_zero_1 : vec3<bool> = !((abs(ray_7.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S112 : vec3<f32> = select(reciprocal_0(select(ray_7.direction_1, vec3<f32>(1.0f), is_zero_1)), vec3<f32>(3.4028234663852886e+38f), is_zero_1);
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
            var _S113 : Hit_0 = hit_in_0(instance_nodes_0[index_6].index_0, &(ray_7));
            var _S114 : Hit_0 = nearest_6;
            if((_S113.t_1) < (nearest_6.t_1))
            {
                is_reached_0 = true;
            }
            else
            {
                if((_S113.t_1) == (_S114.t_1))
                {
                    is_reached_0 = (_S113.instance_1) < (nearest_6.instance_1);
                }
                else
                {
                    is_reached_0 = false;
                }
            }
            var nearest_7 : Hit_0;
            if(is_reached_0)
            {
                ray_7.t_max_1 = _S113.t_1;
                if(is_any_enough_0)
                {
                    return _S113;
                }
                nearest_7 = _S113;
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
            var _S115 : u32 = index_6 + u32(1);
            var _S116 : f32 = entry_0(_S115, ray_7, _S112);
            var _S117 : u32 = instance_nodes_0[index_6].index_0;
            var _S118 : f32 = entry_0(instance_nodes_0[index_6].index_0, ray_7, _S112);
            var _S119 : bool = _S116 <= _S118;
            if(_S119)
            {
                index_6 = _S115;
            }
            else
            {
                index_6 = _S117;
            }
            var far_2 : u32;
            if(_S119)
            {
                far_2 = _S117;
            }
            else
            {
                far_2 = _S115;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S116, _S118)) < INFINITY_0)
            {
                var _S120 : u32 = depth_0 + u32(1);
                stack_0[depth_0] = far_2;
                depth_1 = _S120;
            }
            else
            {
                depth_1 = depth_0;
            }
            if((min(_S116, _S118)) < INFINITY_0)
            {
                depth_0 = depth_1;
                continue;
            }
        }
        is_reached_0 = false;
        depth_0 = depth_1;
        for(;;)
        {
            var _S121 : bool;
            if(depth_0 > u32(0))
            {
                _S121 = !is_reached_0;
            }
            else
            {
                _S121 = false;
            }
            if(_S121)
            {
            }
            else
            {
                break;
            }
            var depth_2 : u32 = depth_0 - u32(1);
            is_reached_0 = (entry_0(stack_0[depth_2], ray_7, _S112)) < (bitcast<f32>((u32(2139095040))));
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

fn WalkTracer_trace_0( ray_8 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    var _S122 : Hit_0 = visit_0(&((*ray_8)), is_any_enough_1, u32(0));
    return _S122;
}

fn hit_of_ray_0( sampler_1 : Sampler_0,  ray_9 : ptr<function, Ray_0>,  is_shadow_ray_0 : bool,  path_0 : ptr<function, Path_0>,  shadow_inside_0 : ptr<function, Inside_0>,  relocates_0 : ptr<function, bool>,  path_relocates_0 : ptr<function, bool>,  beyond_0 : ptr<function, u32>) -> Hit_0
{
    (*beyond_0) = u32(4294967295);
    var _S123 : Hit_0 = WalkTracer_trace_0(&((*ray_9)), is_shadow_ray_0);
    return _S123;
}

fn Sampler_x24init_0( seed_2 : u32,  pixel_1 : u32,  sample_1 : u32) -> Sampler_0
{
    var _S124 : Sampler_0;
    _S124.seed_1 = seed_2;
    _S124.pixel_0 = pixel_1;
    _S124.sample_0 = sample_1;
    return _S124;
}

fn sampler_of_0( pixel_2 : u32,  sample_2 : u32) -> Sampler_0
{
    return Sampler_x24init_0(params_0.seed_0, pixel_2, params_0.first_sample_0 + sample_2);
}

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S125 : Selection_0;
    _S125.sun_0 = sun_1;
    _S125.sky_1 = sky_2;
    _S125.emitters_0 = emitters_1;
    return _S125;
}

fn Inside_x24init_0( instance_7 : u32,  voxel_18 : vec3<i32>,  material_1 : u32) -> Inside_0
{
    var _S126 : Inside_0;
    _S126.instance_2 = instance_7;
    _S126.voxel_2 = voxel_18;
    _S126.material_0 = material_1;
    return _S126;
}

fn in_air_0() -> Inside_0
{
    return Inside_x24init_0(u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn Path_x24init_0( sampler_2 : Sampler_0,  bounce_1 : u32,  event_1 : u32,  kinds_1 : u32,  scattered_1 : u32,  beta_1 : vec3<f32>,  pdf_2 : f32,  normal_1 : vec3<f32>,  selection_1 : Selection_0,  passed_t_1 : f32,  inside_1 : Inside_0,  is_clipped_1 : bool) -> Path_0
{
    var _S127 : Path_0;
    _S127.sampler_0 = sampler_2;
    _S127.bounce_0 = bounce_1;
    _S127.event_0 = event_1;
    _S127.kinds_0 = kinds_1;
    _S127.scattered_0 = scattered_1;
    _S127.beta_0 = beta_1;
    _S127.pdf_1 = pdf_2;
    _S127.normal_0 = normal_1;
    _S127.selection_0 = selection_1;
    _S127.passed_t_0 = passed_t_1;
    _S127.inside_0 = inside_1;
    _S127.is_clipped_0 = is_clipped_1;
    return _S127;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S128 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S128;
    v_0[i32(0)] = v_0[i32(0)] + _S128.y * _S128.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S129 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S129;
    v_0[i32(0)] = v_0[i32(0)] + _S129.y * _S129.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn owen_of_reversed_0( reversed_0 : u32,  seed_3 : u32) -> u32
{
    var word_0 : u32 = reversed_0 + seed_3;
    var word_1 : u32 = (word_0 ^ ((word_0 * u32(1817228412))));
    var word_2 : u32 = (word_1 ^ ((word_1 * u32(3090095698))));
    var word_3 : u32 = (word_2 ^ ((word_2 * u32(3350193720))));
    return reverseBits((word_3 ^ ((word_3 * u32(2367878886)))));
}

fn scrambled_sobol_0( sample_3 : u32,  order_0 : u32,  seeds_0 : vec2<u32>) -> vec2<u32>
{
    var index_7 : u32 = owen_of_reversed_0(reverseBits(sample_3), order_0);
    var binomial_0 : u32 = (index_7 ^ (((((index_7 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_7, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_14 : Sampler_0,  dimension_0 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_1 : vec4<u32> = pcg4d_0(vec4<u32>(this_14.pixel_0, dimension_0, this_14.seed_1, which_0));
    return scrambled_sobol_0(this_14.sample_0, words_1.x, words_1.yz);
}

fn unit_float_0( words_2 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_2 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_stratified_0( this_15 : Sampler_0,  dimension_1 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_15, dimension_1, u32(1)), Sampler_pair_0(this_15, dimension_1, u32(2))));
}

fn PathTracingOf_jitter_0( sampler_3 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_3, u32(0));
}

struct CameraFrame_0
{
     lens_1 : u32,
     eye_1 : vec3<f32>,
     corner_1 : vec3<f32>,
     pixel_x_1 : vec3<f32>,
     pixel_y_1 : vec3<f32>,
     lens_x_1 : vec3<f32>,
     lens_y_1 : vec3<f32>,
     blades_1 : u32,
};

fn CameraFrame_x24init_0( lens_2 : u32,  eye_2 : vec3<f32>,  corner_2 : vec3<f32>,  pixel_x_2 : vec3<f32>,  pixel_y_2 : vec3<f32>,  lens_x_2 : vec3<f32>,  lens_y_2 : vec3<f32>,  blades_2 : u32) -> CameraFrame_0
{
    var _S130 : CameraFrame_0;
    _S130.lens_1 = lens_2;
    _S130.eye_1 = eye_2;
    _S130.corner_1 = corner_2;
    _S130.pixel_x_1 = pixel_x_2;
    _S130.pixel_y_1 = pixel_y_2;
    _S130.lens_x_1 = lens_x_2;
    _S130.lens_y_1 = lens_y_2;
    _S130.blades_1 = blades_2;
    return _S130;
}

@id(5) override LENS_0 : u32 = u32(0);

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0, params_0.lens_x_0, params_0.lens_y_0, params_0.blades_0);
}

fn position_of_0( pixel_3 : u32) -> vec2<u32>
{
    var y_0 : u32 = pixel_3 / params_0.width_0;
    return vec2<u32>(pixel_3 - y_0 * params_0.width_0, y_0);
}

struct Perspective_0
{
     eye_3 : vec3<f32>,
     corner_3 : vec3<f32>,
     pixel_x_3 : vec3<f32>,
     pixel_y_3 : vec3<f32>,
};

fn Perspective_x24init_0( eye_4 : vec3<f32>,  corner_4 : vec3<f32>,  pixel_x_4 : vec3<f32>,  pixel_y_4 : vec3<f32>) -> Perspective_0
{
    var _S131 : Perspective_0;
    _S131.eye_3 = eye_4;
    _S131.corner_3 = corner_4;
    _S131.pixel_x_3 = pixel_x_4;
    _S131.pixel_y_3 = pixel_y_4;
    return _S131;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_0 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_1 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S132 : Axes_0;
    _S132.forward_0 = forward_1;
    _S132.right_0 = right_1;
    _S132.up_0 = up_1;
    return _S132;
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
    var _S133 : ThinLens_0;
    _S133.perspective_0 = perspective_1;
    _S133.lens_x_3 = lens_x_4;
    _S133.lens_y_3 = lens_y_4;
    _S133.blades_3 = blades_4;
    return _S133;
}

fn concentric_0( square_0 : vec2<f32>) -> vec2<f32>
{
    var a_3 : f32 = 2.0f * square_0.x - 1.0f;
    var b_3 : f32 = 2.0f * square_0.y - 1.0f;
    var _S134 : bool;
    if(a_3 == 0.0f)
    {
        _S134 = b_3 == 0.0f;
    }
    else
    {
        _S134 = false;
    }
    if(_S134)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_3)) > (abs(b_3));
    var radius_0 : f32;
    if(is_across_0)
    {
        radius_0 = a_3;
    }
    else
    {
        radius_0 = b_3;
    }
    var turns_0 : f32;
    if(is_across_0)
    {
        turns_0 = divide_0(b_3, a_3) * 0.125f;
    }
    else
    {
        turns_0 = 0.25f - divide_0(a_3, b_3) * 0.125f;
    }
    if(radius_0 < 0.0f)
    {
        turns_0 = turns_0 + 0.5f;
    }
    var _S135 : f32 = abs(radius_0);
    if(turns_0 < 0.0f)
    {
        radius_0 = turns_0 + 1.0f;
    }
    else
    {
        radius_0 = turns_0;
    }
    return vec2<f32>(_S135, radius_0);
}

fn sincos_turns_0( turns_1 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_1 * 4.0f + 0.5f);
    var x_0 : f32 = (turns_1 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_0 * x_0;
    var sin_0 : f32 = x_0 + x_0 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
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
    var count_1 : f32 = f32(blades_5);
    var scaled_0 : f32 = radius_turns_0.y * count_1;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_5 - u32(1)));
    var share_0 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_1));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_1));
    var _S136 : f32 = from_0.y;
    var _S137 : f32 = from_0.x;
    return vec2<f32>(_S136 + (to_0.y - _S136) * share_0, _S137 + (to_0.x - _S137) * share_0) * vec2<f32>(radius_1);
}

fn dot_product_0( a_4 : vec3<f32>,  b_4 : vec3<f32>) -> f32
{
    return a_4.x * b_4.x + a_4.y * b_4.y + a_4.z * b_4.z;
}

fn length_squared_0( vector_3 : vec3<f32>) -> f32
{
    return dot_product_0(vector_3, vector_3);
}

fn nearest_root_0( mantissa_0 : u32,  guess_1 : u32) -> u32
{
    var rest_1 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_1) / f32(u32(2) * guess_1) + 0.5f));
    var _S138 : i32 = i32(guess_1);
    var root_0 : i32 = _S138 + units_1;
    var rest_2 : i32 = rest_1 - units_1 * (_S138 + root_0);
    return u32(root_0 + i32(rest_2 > root_0) - i32(rest_2 <= (- root_0)));
}

fn square_root_0( value_1 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_1);
    }
    var _S139 : u32 = (bitcast<u32>((value_1)));
    var exponent_2 : u32 = (_S139 >> (u32(23)));
    if(!is_normal_0(exponent_2))
    {
        return sqrt(value_1);
    }
    var mantissa_1 : u32 = (((((_S139 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_2) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_1, u32(sqrt(f32(mantissa_1) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn normalize_vector_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vector_4 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_4))));
}

fn ray_from_0( origin_8 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_8, 0.0f, direction_5, (bitcast<f32>((u32(2139095040)))));
}

fn ThinLens_ray_0( this_16 : ThinLens_0,  position_2 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var place_0 : vec2<f32> = place_in_aperture_0(this_16.blades_3, lens_4);
    var offset_1 : vec3<f32> = this_16.lens_x_3 * vec3<f32>(place_0.x) + this_16.lens_y_3 * vec3<f32>(place_0.y);
    return ray_from_0(this_16.perspective_0.eye_3 + offset_1, normalize_vector_0(this_16.perspective_0.corner_3 + this_16.perspective_0.pixel_x_3 * vec3<f32>(position_2.x) + this_16.perspective_0.pixel_y_3 * vec3<f32>(position_2.y) - offset_1));
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
    var _S140 : Orthographic_0;
    _S140.corner_5 = corner_6;
    _S140.pixel_x_5 = pixel_x_6;
    _S140.pixel_y_5 = pixel_y_6;
    _S140.forward_2 = forward_3;
    return _S140;
}

fn Orthographic_ray_0( this_17 : Orthographic_0,  position_3 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_17.corner_5 + this_17.pixel_x_5 * vec3<f32>(position_3.x) + this_17.pixel_y_5 * vec3<f32>(position_3.y), this_17.forward_2);
}

struct Panorama_0
{
     eye_5 : vec3<f32>,
     axes_0 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_6 : vec3<f32>,  axes_1 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S141 : Panorama_0;
    _S141.eye_5 = eye_6;
    _S141.axes_0 = axes_1;
    _S141.inverse_size_0 = inverse_size_1;
    _S141.half_eye_distance_0 = half_eye_distance_1;
    return _S141;
}

fn Panorama_ray_0( this_18 : Panorama_0,  position_4 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_4.y * this_18.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_0 : f32;
    if(is_right_eye_0)
    {
        side_0 = this_18.half_eye_distance_0;
    }
    else
    {
        side_0 = - this_18.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_4.x * this_18.inverse_size_0.x);
    var height_1 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S142 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S143 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_18.eye_5 + (this_18.axes_0.forward_0 * _S143 - this_18.axes_0.right_0 * _S142) * vec3<f32>(side_0), normalize_vector_0((vec3<f32>(0) - this_18.axes_0.forward_0 * _S142 + this_18.axes_0.right_0 * _S143) * vec3<f32>(height_1.x) + this_18.axes_0.up_0 * vec3<f32>(height_1.y)));
}

struct Fisheye_0
{
     eye_7 : vec3<f32>,
     axes_2 : Axes_0,
     middle_0 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_8 : vec3<f32>,  axes_3 : Axes_0,  middle_1 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S144 : Fisheye_0;
    _S144.eye_7 = eye_8;
    _S144.axes_2 = axes_3;
    _S144.middle_0 = middle_1;
    _S144.turns_per_pixel_0 = turns_per_pixel_1;
    return _S144;
}

fn Fisheye_ray_0( this_19 : Fisheye_0,  position_5 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    var x_1 : f32 = position_5.x - this_19.middle_0.x;
    var y_1 : f32 = position_5.y - this_19.middle_0.y;
    var radius_2 : f32 = square_root_0(x_1 * x_1 + y_1 * y_1);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(min(radius_2 * this_19.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_2 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_1.x, radius_2);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_19.eye_7, normalize_vector_0(this_19.axes_2.forward_0 * vec3<f32>(sin_cos_1.y) + this_19.axes_2.right_0 * vec3<f32>((x_1 * scale_0)) - this_19.axes_2.up_0 * vec3<f32>((y_1 * scale_0))));
}

fn Perspective_ray_0( this_20 : Perspective_0,  position_6 : vec2<f32>,  lens_8 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_20.eye_3, normalize_vector_0(this_20.corner_3 + this_20.pixel_x_3 * vec3<f32>(position_6.x) + this_20.pixel_y_3 * vec3<f32>(position_6.y)));
}

fn CameraFrame_ray_0( this_21 : CameraFrame_0,  position_7 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_21.eye_1, this_21.corner_1, this_21.pixel_x_1, this_21.pixel_y_1);
    var axes_4 : Axes_0 = Axes_x24init_0(this_21.corner_1, this_21.pixel_x_1, this_21.pixel_y_1);
    switch(this_21.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_21.lens_x_1, this_21.lens_y_1, this_21.blades_1), position_7, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_21.corner_1, this_21.pixel_x_1, this_21.pixel_y_1, this_21.lens_x_1), position_7, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_21.eye_1, axes_4, this_21.lens_x_1.xy, this_21.lens_x_1.z), position_7, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_21.eye_1, axes_4, this_21.lens_x_1.xy, this_21.lens_x_1.z), position_7, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_7, lens_sample_0);
        }
    }
}

fn PathTracingOf_clip_0( ray_10 : Ray_0) -> Ray_0
{
    return ray_10;
}

fn camera_path_0( pixel_4 : u32,  sample_4 : u32,  path_1 : ptr<function, Path_0>) -> Ray_0
{
    (*path_1) = Path_x24init_0(sampler_of_0(pixel_4, sample_4), u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
    var jitter_0 : vec4<f32> = PathTracingOf_jitter_0((*path_1).sampler_0);
    var _S145 : CameraFrame_0 = FrameParams_camera_0();
    var _S146 : vec2<u32> = position_of_0(pixel_4);
    return PathTracingOf_clip_0(CameraFrame_ray_0(_S145, vec2<f32>(_S146) + jitter_0.xy, jitter_0.zw));
}

struct RayCounts_0
{
     bounce_2 : u32,
     shadow_0 : u32,
};

struct Work_0
{
     pixel_5 : u32,
     sample_5 : u32,
     last_2 : u32,
};

fn RayCounts_x24init_0( bounce_3 : u32,  shadow_1 : u32) -> RayCounts_0
{
    var _S147 : RayCounts_0;
    _S147.bounce_2 = bounce_3;
    _S147.shadow_0 = shadow_1;
    return _S147;
}

fn Hit_is_miss_0( this_22 : Hit_0) -> bool
{
    return (this_22.instance_1) == u32(4294967295);
}

fn Path_events_0( this_23 : Path_0) -> u32
{
    return this_23.bounce_0;
}

fn Inside_is_in_0( this_24 : Inside_0) -> bool
{
    return false;
}

fn weighs_apart_0() -> bool
{
    var _S148 : bool;
    if(IS_EXACT_0)
    {
        _S148 = IS_SINGLE_0;
    }
    else
    {
        _S148 = false;
    }
    return _S148;
}

fn Path_is_counted_0( this_25 : Path_0) -> bool
{
    var _S149 : bool;
    if(weighs_apart_0())
    {
        _S149 = (this_25.pdf_1) < 0.0f;
    }
    else
    {
        _S149 = false;
    }
    return _S149;
}

struct NextRays_0
{
     origin_9 : vec3<f32>,
     path_origin_0 : vec3<f32>,
     shadow_inside_1 : Inside_0,
     relocates_1 : bool,
     path_relocates_1 : bool,
     direction_6 : vec3<f32>,
     has_shadow_ray_0 : bool,
     shadow_direction_0 : vec3<f32>,
     shadow_t_max_0 : f32,
     light_0 : vec3<f32>,
     is_same_0 : bool,
};

fn NextRays_x24init_0( origin_10 : vec3<f32>,  path_origin_1 : vec3<f32>,  shadow_inside_2 : Inside_0,  relocates_2 : bool,  path_relocates_2 : bool,  direction_7 : vec3<f32>,  has_shadow_ray_1 : bool,  shadow_direction_1 : vec3<f32>,  shadow_t_max_1 : f32,  light_1 : vec3<f32>,  is_same_1 : bool) -> NextRays_0
{
    var _S150 : NextRays_0;
    _S150.origin_9 = origin_10;
    _S150.path_origin_0 = path_origin_1;
    _S150.shadow_inside_1 = shadow_inside_2;
    _S150.relocates_1 = relocates_2;
    _S150.path_relocates_1 = path_relocates_2;
    _S150.direction_6 = direction_7;
    _S150.has_shadow_ray_0 = has_shadow_ray_1;
    _S150.shadow_direction_0 = shadow_direction_1;
    _S150.shadow_t_max_0 = shadow_t_max_1;
    _S150.light_0 = light_1;
    _S150.is_same_0 = is_same_1;
    return _S150;
}

fn no_rays_0() -> NextRays_0
{
    var _S151 : vec3<f32> = vec3<f32>(0.0f);
    return NextRays_x24init_0(_S151, _S151, in_air_0(), false, false, _S151, false, _S151, 0.0f, _S151, false);
}

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_2 : vec3<f32>,
};

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_3 : vec3<f32>) -> Receiver_0
{
    var _S152 : Receiver_0;
    _S152.point_0 = point_1;
    _S152.normal_2 = normal_3;
    return _S152;
}

fn Path_receiver_0( this_26 : Path_0,  ray_11 : Ray_0) -> Receiver_0
{
    return Receiver_x24init_0(ray_11.origin_2, this_26.normal_0);
}

fn Path_dimension_medium_0( this_27 : Path_0) -> u32
{
    return u32(2147483648) + this_27.event_0;
}

fn Sampler_independent_0( this_28 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_28.pixel_0, this_28.sample_0, dimension_2, this_28.seed_1)));
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

fn material_of_index_0( index_8 : u32) -> PackedMaterial_0
{
    var _S153 : u32 = u32(4) * index_8;
    var a_5 : vec4<u32> = material_rows_0[_S153];
    var b_5 : vec4<u32> = material_rows_0[_S153 + u32(1)];
    var c_0 : vec4<u32> = material_rows_0[_S153 + u32(2)];
    var d_0 : vec4<u32> = material_rows_0[_S153 + u32(3)];
    var material_2 : PackedMaterial_0;
    var _S154 : f32 = (bitcast<f32>((a_5.y)));
    var _S155 : f32 = (bitcast<f32>((a_5.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((a_5.x)));
    material_2.base_color_0[i32(1)] = _S154;
    material_2.base_color_0[i32(2)] = _S155;
    var _S156 : f32 = (bitcast<f32>((b_5.y)));
    var _S157 : f32 = (bitcast<f32>((b_5.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((b_5.x)));
    material_2.emission_0[i32(1)] = _S156;
    material_2.emission_0[i32(2)] = _S157;
    var _S158 : f32 = (bitcast<f32>((d_0.y)));
    var _S159 : f32 = (bitcast<f32>((d_0.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((d_0.x)));
    material_2.absorption_0[i32(1)] = _S158;
    material_2.absorption_0[i32(2)] = _S159;
    material_2.roughness_0 = (bitcast<f32>((a_5.w)));
    material_2.metallic_0 = (bitcast<f32>((b_5.w)));
    material_2.transmission_0 = (bitcast<f32>((c_0.x)));
    material_2.ior_0 = (bitcast<f32>((c_0.y)));
    material_2.specular_0 = (bitcast<f32>((c_0.z)));
    material_2.anisotropy_0 = (bitcast<f32>((c_0.w)));
    material_2.scattering_0 = (bitcast<f32>((d_0.w)));
    return material_2;
}

fn logarithm_0( x_2 : f32) -> f32
{
    var bits_1 : u32 = (bitcast<u32>((x_2)));
    var _S160 : u32 = (bits_1 & (u32(8388607)));
    var is_upper_0 : bool = _S160 > u32(3474675);
    var power_0 : i32 = i32((bits_1 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S161 : u32;
    if(is_upper_0)
    {
        _S161 = u32(1056964608);
    }
    else
    {
        _S161 = u32(1065353216);
    }
    var mantissa_2 : f32 = (bitcast<f32>(((_S160 | (_S161)))));
    var s_0 : f32 = divide_0(mantissa_2 - 1.0f, mantissa_2 + 1.0f);
    var ss_0 : f32 = s_0 * s_0;
    var _S162 : f32 = f32(power_0);
    return _S162 * 0.693359375f + (_S162 * -0.00021219444170129f + s_0 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_0 : PackedMaterial_0,  u_0 : f32) -> f32
{
    var _S163 : f32;
    if((medium_0.scattering_0) > 0.0f)
    {
        _S163 = divide_0(- logarithm_0(1.0f - u_0), medium_0.scattering_0);
    }
    else
    {
        _S163 = (bitcast<f32>((u32(2139095040))));
    }
    return _S163;
}

fn grid_direction_0( instance_8 : u32,  direction_8 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(instance_8, direction_8);
}

fn Inside_voxels_per_t_0( this_29 : Inside_0,  ray_12 : Ray_0) -> f32
{
    return square_root_0(length_squared_0(grid_direction_0(this_29.instance_2, ray_12.direction_1)));
}

fn scattering_t_0( path_2 : Path_0,  inside_2 : Inside_0,  ray_13 : Ray_0) -> f32
{
    return divide_0(free_path_0(material_of_index_0(inside_2.material_0), Sampler_independent_0(path_2.sampler_0, Path_dimension_medium_0(path_2)).x), Inside_voxels_per_t_0(inside_2, ray_13));
}

fn exponential_0( x_3 : f32) -> f32
{
    if(x_3 < -87.0f)
    {
        return 0.0f;
    }
    var power_1 : i32 = i32(x_3 * 1.4426950216293335f - 0.5f);
    var k_0 : f32 = f32(power_1);
    var r_0 : f32 = x_3 - k_0 * 0.693359375f - k_0 * -0.00021219444170129f;
    return (1.0f + r_0 * (1.0f + r_0 * (0.5f + r_0 * (0.1666666716337204f + r_0 * (0.0416666679084301f + r_0 * (0.00833333376795053f + r_0 * (0.00138888892251998f + r_0 * 0.0001984127011383f))))))) * (bitcast<f32>(((u32(i32(127) + power_1) << (u32(23))))));
}

fn attenuation_0( medium_1 : PackedMaterial_0,  voxels_1 : f32) -> vec3<f32>
{
    var sigma_0 : vec3<f32> = vector_of_0(medium_1.absorption_0);
    return vec3<f32>(exponential_0(- (sigma_0.x * voxels_1)), exponential_0(- (sigma_0.y * voxels_1)), exponential_0(- (sigma_0.z * voxels_1)));
}

fn absorb_0( path_3 : ptr<function, Path_0>,  inside_3 : Inside_0,  ray_14 : Ray_0,  t_10 : f32)
{
    (*path_3).beta_0 = (*path_3).beta_0 * attenuation_0(material_of_index_0(inside_3.material_0), t_10 * Inside_voxels_per_t_0(inside_3, ray_14));
    return;
}

fn Environment_to_map_0( d_1 : vec3<f32>) -> vec3<f32>
{
    var sin_1 : f32 = params_0.sky_turned_0.x;
    var cos_1 : f32 = params_0.sky_turned_0.y;
    var _S164 : f32 = d_1.x;
    var _S165 : f32 = d_1.y;
    return vec3<f32>(_S164 * cos_1 - _S165 * sin_1, _S164 * sin_1 + _S165 * cos_1, d_1.z);
}

fn quarter_turns_0( x_4 : f32,  y_2 : f32) -> f32
{
    var _S166 : f32 = min(x_4, y_2);
    var _S167 : f32 = max(x_4, y_2);
    var ratio_0 : f32;
    if(_S167 > 0.0f)
    {
        ratio_0 = divide_0(_S166, _S167);
    }
    else
    {
        ratio_0 = 0.0f;
    }
    var s_1 : f32 = ratio_0 * ratio_0;
    var turns_2 : f32 = ratio_0 * (0.63661932945251465f + s_1 * (-0.21218447387218475f + s_1 * (0.12698377668857574f + s_1 * (-0.08854507654905319f + s_1 * (0.06138415634632111f + s_1 * (-0.03559486567974091f + s_1 * (0.01391837373375893f + s_1 * -0.00258121290244162f)))))));
    if(y_2 > x_4)
    {
        ratio_0 = 1.0f - turns_2;
    }
    else
    {
        ratio_0 = turns_2;
    }
    return ratio_0;
}

fn square_of_0( direction_9 : vec3<f32>) -> vec2<f32>
{
    var size_0 : vec3<f32> = abs(direction_9);
    var _S168 : f32 = size_0.x;
    var _S169 : f32 = size_0.y;
    var radius_3 : f32 = square_root_0(divide_0(_S168 * _S168 + _S169 * _S169, 1.0f + size_0.z));
    var v_1 : f32 = quarter_turns_0(_S168, _S169) * radius_3;
    var u_1 : f32 = radius_3 - v_1;
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

fn Environment_index_of_0( x_5 : i32,  y_3 : i32) -> u32
{
    var last_3 : i32 = i32(params_0.sky_edge_0) - i32(1);
    var is_beside_0 : bool;
    if(x_5 < i32(0))
    {
        is_beside_0 = true;
    }
    else
    {
        is_beside_0 = x_5 > last_3;
    }
    var _S170 : i32;
    if(is_beside_0)
    {
        _S170 = last_3 - y_3;
    }
    else
    {
        _S170 = y_3;
    }
    var _S171 : i32;
    if(is_beside_0)
    {
        _S171 = clamp(x_5, i32(0), last_3);
    }
    else
    {
        _S171 = x_5;
    }
    var is_beyond_0 : bool;
    if(_S170 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S170 > last_3;
    }
    if(is_beyond_0)
    {
        _S171 = last_3 - _S171;
    }
    if(is_beyond_0)
    {
        _S170 = clamp(_S170, i32(0), last_3);
    }
    return u32(_S170 * i32(params_0.sky_edge_0) + _S171);
}

fn Environment_texel_radiance_0( x_6 : i32,  y_4 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_6, y_4)].radiance_0);
}

fn Environment_radiance_at_0( place_1 : vec2<f32>) -> vec3<f32>
{
    var _S172 : vec2<f32> = place_1 - vec2<f32>(0.5f);
    var corner_7 : vec2<f32> = floor(_S172);
    var beyond_1 : vec2<f32> = _S172 - corner_7;
    var x_7 : i32 = i32(corner_7.x);
    var y_5 : i32 = i32(corner_7.y);
    var _S173 : f32 = beyond_1.x;
    var _S174 : vec3<f32> = vec3<f32>((1.0f - _S173));
    var _S175 : i32 = x_7 + i32(1);
    var _S176 : vec3<f32> = vec3<f32>(_S173);
    var _S177 : i32 = y_5 + i32(1);
    var _S178 : f32 = beyond_1.y;
    return (Environment_texel_radiance_0(x_7, y_5) * _S174 + Environment_texel_radiance_0(_S175, y_5) * _S176) * vec3<f32>((1.0f - _S178)) + (Environment_texel_radiance_0(x_7, _S177) * _S174 + Environment_texel_radiance_0(_S175, _S177) * _S176) * vec3<f32>(_S178);
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
    var _S179 : Gradient_0;
    _S179.nadir_0 = nadir_1;
    _S179.zenith_0 = zenith_1;
    return _S179;
}

fn Gradient_radiance_0( this_30 : Gradient_0,  direction_12 : vec3<f32>) -> vec3<f32>
{
    return this_30.nadir_0 + (this_30.zenith_0 - this_30.nadir_0) * vec3<f32>((0.5f * (direction_12.z + 1.0f)));
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

fn Path_selection_at_0( this_31 : Path_0,  last_4 : Receiver_0) -> Selection_0
{
    return this_31.selection_0;
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S180 : bool;
    if(SKY_0 == u32(1))
    {
        _S180 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S180 = false;
    }
    return _S180;
}

fn Environment_pdf_0( direction_15 : vec3<f32>) -> f32
{
    var place_2 : vec2<f32> = Environment_place_of_0(direction_15);
    var last_5 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_2.x), last_5), min(i32(place_2.y), last_5))].pdf_0;
}

fn Sky_pdf_0( direction_16 : vec3<f32>) -> f32
{
    var _S181 : f32;
    if(SKY_0 == u32(1))
    {
        _S181 = Environment_pdf_0(direction_16);
    }
    else
    {
        _S181 = 0.0f;
    }
    return _S181;
}

fn Lights_sky_pdf_0( selection_2 : Selection_0,  direction_17 : vec3<f32>) -> f32
{
    var _S182 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S182 = Sky_pdf_0(direction_17) * selection_2.sky_1;
    }
    else
    {
        _S182 = 0.0f;
    }
    return _S182;
}

fn power_heuristic_0( own_0 : f32,  other_1 : f32) -> f32
{
    var ratio_1 : f32 = divide_0(other_1, own_0);
    return divide_0(1.0f, 1.0f + ratio_1 * ratio_1);
}

fn mis_weight_0( bounce_pdf_0 : f32,  light_pdf_0 : f32) -> f32
{
    var _S183 : bool;
    if(bounce_pdf_0 == 0.0f)
    {
        _S183 = true;
    }
    else
    {
        _S183 = light_pdf_0 == 0.0f;
    }
    if(_S183)
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

fn Path_is_straight_0( this_32 : Path_0) -> bool
{
    var _S184 : bool;
    if((this_32.bounce_0) == u32(0))
    {
        _S184 = (this_32.pdf_1) == 0.0f;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        _S184 = (all(((this_32.normal_0) == vec3<f32>(0.0f))));
    }
    else
    {
        _S184 = false;
    }
    return _S184;
}

fn SunDisc_contains_0( direction_18 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_18 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_le_0( direction_19 : vec3<f32>) -> vec3<f32>
{
    var _S185 : vec3<f32>;
    if(SunDisc_contains_0(direction_19))
    {
        _S185 = params_0.sun_radiance_0;
    }
    else
    {
        _S185 = vec3<f32>(0.0f);
    }
    return _S185;
}

fn SunDisc_pdf_0( direction_20 : vec3<f32>) -> f32
{
    var _S186 : f32;
    if(SunDisc_contains_0(direction_20))
    {
        _S186 = params_0.sun_pdf_0;
    }
    else
    {
        _S186 = 0.0f;
    }
    return _S186;
}

fn Lights_sun_pdf_0( selection_3 : Selection_0,  direction_21 : vec3<f32>) -> f32
{
    var _S187 : f32;
    if(has_sun_0())
    {
        _S187 = SunDisc_pdf_0(direction_21) * selection_3.sun_0;
    }
    else
    {
        _S187 = 0.0f;
    }
    return _S187;
}

fn Path_dimension_scatter_0( this_33 : Path_0) -> u32
{
    return u32(1) + u32(2) * Path_events_0(this_33);
}

fn find_brick_0( _S188 : u32,  _S189 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S189 >> (vec3<u32>(grids_0[_S188].top_shift_0)));
    var _S190 : u32 = cell_word_0(grids_0[_S188].top_offset_0 + u32((top_0.z * grids_0[_S188].top_size_0[i32(1)] + top_0.y) * grids_0[_S188].top_size_0[i32(0)] + top_0.x));
    var cell_7 : u32 = _S190;
    var shift_3 : u32 = grids_0[_S188].top_shift_0;
    for(;;)
    {
        var _S191 : bool;
        if(shift_3 > u32(3))
        {
            _S191 = ((cell_7 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S191 = false;
        }
        if(_S191)
        {
        }
        else
        {
            break;
        }
        var shift_4 : u32 = shift_3 - u32(2);
        var _S192 : u32 = cell_word_0(((cell_7 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S189, shift_4));
        cell_7 = _S192;
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
        var _S193 : u32 = u32(2) * index_9;
        var _S194 : u32 = brick_word_0(record_3 + u32(2) + _S193);
        var _S195 : u32 = countOneBits(_S194);
        var _S196 : u32 = brick_word_0(record_3 + u32(3) + _S193);
        var rank_1 : u32 = rank_0 + (_S195 + countOneBits(_S196));
        index_9 = index_9 + u32(1);
        rank_0 = rank_1;
    }
    var _S197 : u32 = u32(2) * present_before_0;
    var low_6 : u32 = brick_word_0(record_3 + u32(2) + _S197);
    if(bit_1 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_6 & ((((u32(1) << (bit_1))) - u32(1)))));
    }
    else
    {
        var _S198 : u32 = countOneBits(low_6);
        var _S199 : u32 = brick_word_0(record_3 + u32(3) + _S197);
        rank_0 = rank_0 + (_S198 + countOneBits((_S199 & ((((u32(1) << ((bit_1 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_10 : u32) -> u32
{
    var _S200 : u32;
    if(HAS_PAGES_0)
    {
        var _S201 : u32 = word_in_pages_0(index_10, pages_0[i32(2)]);
        _S200 = _S201;
    }
    else
    {
        _S200 = index_10;
    }
    return _S200;
}

fn material_word_0( index_11 : u32) -> u32
{
    var _S202 : u32 = place_of_material_0(index_11);
    return brick_materials_0[_S202];
}

fn read_bits_0( start_1 : u32,  position_8 : u32,  count_2 : u32) -> u32
{
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    var word_4 : u32 = start_1 + ((position_8 >> (u32(5))));
    var shift_5 : u32 = (position_8 & (u32(31)));
    var _S203 : u32 = material_word_0(word_4);
    var bits_2 : u32 = (_S203 >> (shift_5));
    var bits_3 : u32;
    if((shift_5 + count_2) > u32(32))
    {
        var _S204 : u32 = material_word_0(word_4 + u32(1));
        bits_3 = (bits_2 | (((_S204 << ((u32(32) - shift_5))))));
    }
    else
    {
        bits_3 = bits_2;
    }
    return (bits_3 & ((((u32(1) << (count_2))) - u32(1))));
}

fn material_at_0( _S205 : u32,  _S206 : vec3<i32>) -> u32
{
    var _S207 : u32 = find_brick_0(_S205, _S206);
    var header_1 : u32 = brick_word_0(_S207);
    var rank_2 : u32 = rank_in_brick_0(_S207, _S206);
    var index_bits_0 : u32 = (((header_1 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_1 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S205].material_bits_0;
    var start_2 : u32 = brick_word_0(_S207 + u32(1));
    var index_12 : u32 = read_bits_0(start_2, palette_count_0 * grids_0[_S205].material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_12;
    }
    var _S208 : u32 = read_bits_0(start_2, index_12 * entry_bits_0, entry_bits_0);
    return _S208;
}

fn material_of_0( hit_1 : Hit_0) -> PackedMaterial_0
{
    var _S209 : u32 = material_at_0(instances_0[hit_1.instance_1].grid_0, hit_1.voxel_1 - cell_of_0(grids_0[instances_0[hit_1.instance_1].grid_0].origin_0));
    return material_of_index_0(_S209);
}

fn material_met_0( path_4 : Path_0,  hit_2 : Hit_0,  beyond_2 : u32) -> PackedMaterial_0
{
    var _S210 : PackedMaterial_0 = material_of_0(hit_2);
    return _S210;
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
    var _S211 : Aim_0;
    _S211.is_met_0 = is_met_1;
    _S211.direction_22 = direction_23;
    _S211.hit_3 = hit_4;
    _S211.luminance_1 = luminance_2;
    return _S211;
}

struct LightSample_0
{
     ray_15 : Ray_0,
     cos_theta_0 : f32,
     radiance_2 : vec3<f32>,
     pdf_3 : f32,
};

fn LightSample_x24init_0( ray_16 : Ray_0,  cos_theta_1 : f32,  radiance_3 : vec3<f32>,  pdf_4 : f32) -> LightSample_0
{
    var _S212 : LightSample_0;
    _S212.ray_15 = ray_16;
    _S212.cos_theta_0 = cos_theta_1;
    _S212.radiance_2 = radiance_3;
    _S212.pdf_3 = pdf_4;
    return _S212;
}

fn no_light_0() -> LightSample_0
{
    var _S213 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S213, 0.0f, _S213, 0.0f), 0.0f, _S213, 0.0f);
}

fn with_slack_0( receiver_0 : Receiver_0,  cos_2 : f32) -> f32
{
    return cos_2;
}

fn SunDisc_sample_0( receiver_1 : Receiver_0,  u_3 : vec4<f32>,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_3.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_4 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_2 : vec2<f32> = sincos_turns_0(u_3.w);
    var direction_24 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_4 * sin_cos_2.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_4 * sin_cos_2.x)));
    var cos_theta_2 : f32 = with_slack_0(receiver_1, dot_product_0(receiver_1.normal_2, direction_24));
    (*sample_6) = LightSample_x24init_0(ray_from_0(receiver_1.point_0, direction_24), cos_theta_2, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_2 > 0.0f;
}

struct ChosenDirection_0
{
     direction_25 : vec3<f32>,
     radiance_4 : vec3<f32>,
     pdf_5 : f32,
};

fn ChosenDirection_x24init_0( direction_26 : vec3<f32>,  radiance_5 : vec3<f32>,  pdf_6 : f32) -> ChosenDirection_0
{
    var _S214 : ChosenDirection_0;
    _S214.direction_25 = direction_26;
    _S214.radiance_4 = radiance_5;
    _S214.pdf_5 = pdf_6;
    return _S214;
}

fn direction_of_0( square_1 : vec2<f32>) -> vec3<f32>
{
    var u_4 : f32 = square_1.x * 2.0f - 1.0f;
    var v_3 : f32 = square_1.y * 2.0f - 1.0f;
    var _S215 : f32 = abs(u_4);
    var _S216 : f32 = abs(v_3);
    var height_2 : f32 = 1.0f - (_S215 + _S216);
    var radius_5 : f32 = 1.0f - abs(height_2);
    var turns_3 : f32;
    if(radius_5 > 0.0f)
    {
        turns_3 = (divide_0(_S216 - _S215, radius_5) + 1.0f) * 0.125f;
    }
    else
    {
        turns_3 = 0.0f;
    }
    var sin_cos_3 : vec2<f32> = sincos_turns_0(turns_3);
    var _S217 : f32 = radius_5 * radius_5;
    var across_0 : f32 = radius_5 * square_root_0(2.0f - _S217);
    var x_8 : f32 = sin_cos_3.y * across_0;
    var y_6 : f32 = sin_cos_3.x * across_0;
    var z_0 : f32 = 1.0f - _S217;
    if(u_4 < 0.0f)
    {
        turns_3 = - x_8;
    }
    else
    {
        turns_3 = x_8;
    }
    var _S218 : f32;
    if(v_3 < 0.0f)
    {
        _S218 = - y_6;
    }
    else
    {
        _S218 = y_6;
    }
    var _S219 : f32;
    if(height_2 < 0.0f)
    {
        _S219 = - z_0;
    }
    else
    {
        _S219 = z_0;
    }
    return vec3<f32>(turns_3, _S218, _S219);
}

fn Environment_to_world_0( d_2 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S220 : f32 = d_2.x;
    var _S221 : f32 = d_2.y;
    return vec3<f32>(_S220 * cos_3 + _S221 * sin_2, _S221 * cos_3 - _S220 * sin_2, d_2.z);
}

fn Environment_choose_0( u_5 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S222 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S222, _S222, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S223 : f32 = u_5.x * edge_0;
    var _S224 : f32 = edge_0 - 1.0f;
    var _S225 : f32 = min(floor(_S223), _S224);
    var own_1 : u32 = u32(_S225) * params_0.sky_edge_0 + u32(min(floor(u_5.y * edge_0), _S224));
    var index_13 : u32;
    if((u_5.z) < (environment_0[own_1].threshold_0))
    {
        index_13 = own_1;
    }
    else
    {
        index_13 = environment_0[own_1].alias_0;
    }
    var pdf_7 : f32 = environment_0[index_13].pdf_0;
    if((environment_0[index_13].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S226 : u32 = index_13 % params_0.sky_edge_0;
    var _S227 : f32 = f32(_S226);
    var _S228 : u32 = index_13 / params_0.sky_edge_0;
    var place_3 : vec2<f32> = vec2<f32>(_S227, f32(_S228)) + vec2<f32>(min(_S223 - _S225, 1.0f), u_5.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_3 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_3), pdf_7);
    return true;
}

fn Sky_sample_0( receiver_2 : Receiver_0,  u_6 : vec4<f32>,  sample_7 : ptr<function, LightSample_0>) -> bool
{
    (*sample_7) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S229 : bool;
    if(SKY_0 != u32(1))
    {
        _S229 = true;
    }
    else
    {
        var _S230 : bool = Environment_choose_0(u_6, &(chosen_1));
        _S229 = !_S230;
    }
    if(_S229)
    {
        return false;
    }
    var cos_theta_3 : f32 = dot_product_0(receiver_2.normal_2, chosen_1.direction_25);
    (*sample_7) = LightSample_x24init_0(ray_from_0(receiver_2.point_0, chosen_1.direction_25), cos_theta_3, chosen_1.radiance_4 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_5);
    return cos_theta_3 > 0.0f;
}

struct Descent_0
{
     node_0 : u32,
     index_14 : u32,
     count_3 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
     is_far_0 : bool,
};

fn Descent_x24init_0( node_1 : u32,  index_15 : u32,  count_4 : u32,  weight_1 : f32,  total_1 : f32,  choice_1 : f32,  is_far_1 : bool) -> Descent_0
{
    var _S231 : Descent_0;
    _S231.node_0 = node_1;
    _S231.index_14 = index_15;
    _S231.count_3 = count_4;
    _S231.weight_0 = weight_1;
    _S231.total_0 = total_1;
    _S231.choice_0 = choice_1;
    _S231.is_far_0 = is_far_1;
    return _S231;
}

struct LightNode_0
{
     min_2 : array<f32, i32(3)>,
     index_16 : u32,
     max_2 : array<f32, i32(3)>,
     count_5 : u32,
     power_2 : array<f32, i32(6)>,
     parent_0 : u32,
     root_1 : u32,
};

fn light_node_of_0( a_6 : vec4<u32>,  b_6 : vec4<u32>,  c_1 : vec4<u32>,  d_3 : vec4<u32>) -> LightNode_0
{
    var node_2 : LightNode_0;
    var _S232 : f32 = (bitcast<f32>((a_6.y)));
    var _S233 : f32 = (bitcast<f32>((a_6.z)));
    node_2.min_2[i32(0)] = (bitcast<f32>((a_6.x)));
    node_2.min_2[i32(1)] = _S232;
    node_2.min_2[i32(2)] = _S233;
    node_2.index_16 = a_6.w;
    var _S234 : f32 = (bitcast<f32>((b_6.y)));
    var _S235 : f32 = (bitcast<f32>((b_6.z)));
    node_2.max_2[i32(0)] = (bitcast<f32>((b_6.x)));
    node_2.max_2[i32(1)] = _S234;
    node_2.max_2[i32(2)] = _S235;
    node_2.count_5 = b_6.w;
    var _S236 : f32 = (bitcast<f32>((c_1.y)));
    var _S237 : f32 = (bitcast<f32>((c_1.z)));
    var _S238 : f32 = (bitcast<f32>((c_1.w)));
    var _S239 : f32 = (bitcast<f32>((d_3.x)));
    var _S240 : f32 = (bitcast<f32>((d_3.y)));
    node_2.power_2[i32(0)] = (bitcast<f32>((c_1.x)));
    node_2.power_2[i32(1)] = _S236;
    node_2.power_2[i32(2)] = _S237;
    node_2.power_2[i32(3)] = _S238;
    node_2.power_2[i32(4)] = _S239;
    node_2.power_2[i32(5)] = _S240;
    node_2.parent_0 = d_3.z;
    node_2.root_1 = d_3.w;
    return node_2;
}

fn top_light_node_0( index_17 : u32) -> LightNode_0
{
    var _S241 : u32 = u32(4) * index_17;
    return light_node_of_0(top_light_node_rows_0[_S241], top_light_node_rows_0[_S241 + u32(1)], top_light_node_rows_0[_S241 + u32(2)], top_light_node_rows_0[_S241 + u32(3)]);
}

fn TopLights_node_0( index_18 : u32) -> LightNode_0
{
    return top_light_node_0(index_18);
}

fn Descent_at_0( this_34 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_3 : LightNode_0 = TopLights_node_0(root_2);
    (*this_34).node_0 = root_2;
    (*this_34).index_14 = node_3.index_16;
    (*this_34).count_3 = node_3.count_5;
    (*this_34).is_far_0 = false;
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
    var _S242 : BySide_0;
    _S242.low_7 = low_8;
    _S242.high_4 = high_5;
    return _S242;
}

fn sent_by_side_0( node_4 : LightNode_0,  point_2 : vec3<f32>,  distance_2 : f32) -> BySide_0
{
    var _S243 : vec3<f32> = vec3<f32>(0.0f);
    var _S244 : vec3<f32> = vec3<f32>(distance_2);
    return BySide_x24init_0(vec3<f32>(node_4.power_2[i32(0)], node_4.power_2[i32(2)], node_4.power_2[i32(4)]) * min(max(vector_of_0(node_4.max_2) - point_2, _S243), _S244), vec3<f32>(node_4.power_2[i32(1)], node_4.power_2[i32(3)], node_4.power_2[i32(5)]) * min(max(point_2 - vector_of_0(node_4.min_2), _S243), _S244));
}

fn BySide_sum_0( this_35 : BySide_0) -> f32
{
    var axes_5 : vec3<f32> = this_35.low_7 + this_35.high_4;
    return axes_5.x + axes_5.y + axes_5.z;
}

fn reciprocal_guess_0( x_9 : f32) -> f32
{
    var guess_2 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_9))))));
    return guess_2 * (2.0f - x_9 * guess_2);
}

fn View_x24init_0( importance_1 : f32,  is_far_3 : bool) -> View_0
{
    var _S245 : View_0;
    _S245.importance_0 = importance_1;
    _S245.is_far_2 = is_far_3;
    return _S245;
}

fn view_0( node_5 : LightNode_0,  receiver_3 : Receiver_0) -> View_0
{
    var _S246 : vec3<f32> = vector_of_0(node_5.max_2);
    var _S247 : vec3<f32> = vector_of_0(node_5.min_2);
    var _S248 : vec3<f32> = vec3<f32>(0.5f);
    var half_1 : vec3<f32> = (_S246 - _S247) * _S248;
    var toward_0 : vec3<f32> = (_S247 + _S246) * _S248 - receiver_3.point_0;
    var middle_2 : f32 = dot_product_0(toward_0, receiver_3.normal_2);
    var aside_0 : f32 = dot_product_0(half_1, abs(receiver_3.normal_2));
    var above_0 : f32 = with_slack_0(receiver_3, middle_2 + aside_0);
    var far_3 : f32 = length_squared_0(toward_0);
    var near_2 : f32 = length_squared_0(half_1);
    var is_far_4 : bool;
    if((with_slack_0(receiver_3, middle_2 - aside_0)) > 0.0f)
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
    var _S249 : f32;
    if(above_0 > 0.0f)
    {
        _S249 = sent_0 * min(above_0, distance_3) * (falloff_0 * falloff_0);
    }
    else
    {
        _S249 = 0.0f;
    }
    return View_x24init_0(_S249, is_far_4);
}

fn normal_or_zero_0( weight_2 : f32) -> f32
{
    var _S250 : f32;
    if(weight_2 < 1.17549435082228751e-38f)
    {
        _S250 = 0.0f;
    }
    else
    {
        _S250 = weight_2;
    }
    return _S250;
}

fn inverse_power_of_two_0( x_10 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_10))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_2 : f32) -> vec2<f32>
{
    var _S251 : f32 = normal_or_zero_0(left_0);
    var _S252 : f32 = normal_or_zero_0(right_2);
    var unit_0 : f32 = inverse_power_of_two_0(_S251 + _S252);
    return vec2<f32>(normal_or_zero_0(_S251 * unit_0), normal_or_zero_0(_S252 * unit_0));
}

fn climb_0( receiver_4 : Receiver_0,  start_3 : u32,  descent_0 : ptr<function, Descent_0>) -> bool
{
    var node_6 : LightNode_0 = top_light_node_0(start_3);
    var at_1 : u32 = start_3;
    for(;;)
    {
        var _S253 : LightNode_0 = node_6;
        if((node_6.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S253.parent_0);
        var _S254 : u32 = _S253.parent_0 + u32(1);
        var is_left_0 : bool = at_1 == _S254;
        var _S255 : u32;
        if(is_left_0)
        {
            _S255 = parent_1.index_16;
        }
        else
        {
            _S255 = _S254;
        }
        var _S256 : View_0 = view_0(node_6, receiver_4);
        var _S257 : View_0 = view_0(top_light_node_0(_S255), receiver_4);
        var _S258 : f32;
        if(is_left_0)
        {
            _S258 = _S256.importance_0;
        }
        else
        {
            _S258 = _S257.importance_0;
        }
        var _S259 : f32;
        if(is_left_0)
        {
            _S259 = _S257.importance_0;
        }
        else
        {
            _S259 = _S256.importance_0;
        }
        var weights_0 : vec2<f32> = weights_of_0(_S258, _S259);
        var _S260 : f32 = weights_0.x;
        var _S261 : f32 = weights_0.y;
        var total_2 : f32 = _S260 + _S261;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S262 : f32;
        if(is_left_0)
        {
            _S262 = _S260;
        }
        else
        {
            _S262 = _S261;
        }
        (*descent_0).weight_0 = (*descent_0).weight_0 * _S262;
        (*descent_0).total_0 = (*descent_0).total_0 * total_2;
        node_6 = parent_1;
        at_1 = _S253.parent_0;
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
        var _S263 : bool;
        if(((*descent_1).count_3) == u32(0))
        {
            _S263 = !(*descent_1).is_far_0;
        }
        else
        {
            _S263 = false;
        }
        if(_S263)
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
        var right_3 : LightNode_0 = TopLights_node_0((*descent_1).index_14);
        var weights_1 : vec2<f32> = weights_of_0(view_0(left_1, receiver_5).importance_0, view_0(right_3, receiver_5).importance_0);
        var _S264 : f32 = weights_1.x;
        var _S265 : f32 = weights_1.y;
        var total_3 : f32 = _S264 + _S265;
        if(!(total_3 > 0.0f))
        {
            return false;
        }
        var _S266 : bool;
        if(_S265 <= 0.0f)
        {
            _S266 = true;
        }
        else
        {
            _S266 = ((*descent_1).choice_0 * total_3) < (_S264 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_0.is_met_0)
        {
            var _S267 : vec3<f32> = vec3<f32>(aim_0.hit_3.voxel_1);
            if((all((_S267 >= (vector_of_0(left_1.min_2))))))
            {
                is_left_1 = (all((_S267 < (vector_of_0(left_1.max_2)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S266;
        }
        var _S268 : f32 = (*descent_1).choice_0 * total_3;
        var _S269 : f32;
        if(is_left_1)
        {
            _S269 = 0.0f;
        }
        else
        {
            _S269 = _S264 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S268 - _S269;
        var _S270 : u32;
        if(is_left_1)
        {
            _S270 = (*descent_1).node_0 + u32(1);
        }
        else
        {
            _S270 = (*descent_1).index_14;
        }
        (*descent_1).node_0 = _S270;
        var _S271 : u32;
        if(is_left_1)
        {
            _S271 = left_1.index_16;
        }
        else
        {
            _S271 = right_3.index_16;
        }
        (*descent_1).index_14 = _S271;
        var _S272 : u32;
        if(is_left_1)
        {
            _S272 = left_1.count_5;
        }
        else
        {
            _S272 = right_3.count_5;
        }
        (*descent_1).count_3 = _S272;
        (*descent_1).is_far_0 = false;
        var _S273 : f32;
        if(is_left_1)
        {
            _S273 = _S264;
        }
        else
        {
            _S273 = _S265;
        }
        var _S274 : f32 = (*descent_1).weight_0 * _S273;
        (*descent_1).weight_0 = _S274;
        (*descent_1).total_0 = (*descent_1).total_0 * total_3;
        if(_S274 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn in_grid_0( instance_9 : u32,  receiver_6 : Receiver_0) -> Receiver_0
{
    if(IS_SINGLE_0)
    {
        return receiver_6;
    }
    return Receiver_x24init_0(Transform_point_0(instance_9, receiver_6.point_0), normalize_vector_0(Transform_direction_0(instance_9, receiver_6.normal_2)));
}

fn lights_in_pages_0() -> bool
{
    var _S275 : bool;
    if(HAS_PAGES_0)
    {
        _S275 = pages_0[u32(5)] != u32(0);
    }
    else
    {
        _S275 = false;
    }
    return _S275;
}

fn place_in_light_node_0( node_7 : u32,  word_5 : u32) -> u32
{
    var _S276 : u32 = word_in_pages_0(node_7 * u32(16) + word_5, pages_0[i32(4)]);
    return _S276;
}

fn light_node_at_0( index_19 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S277 : u32 = u32(4) * index_19;
        return light_node_of_0(light_node_rows_0[_S277], light_node_rows_0[_S277 + u32(1)], light_node_rows_0[_S277 + u32(2)], light_node_rows_0[_S277 + u32(3)]);
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
    node_8.count_5 = cells_0[at_2 + u32(7)];
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
    var _S278 : LightNode_0 = light_node_at_0(index_20);
    return _S278;
}

fn Descent_at_1( this_36 : ptr<function, Descent_0>,  root_3 : u32)
{
    var node_9 : LightNode_0 = GridLights_node_0(root_3);
    (*this_36).node_0 = root_3;
    (*this_36).index_14 = node_9.index_16;
    (*this_36).count_3 = node_9.count_5;
    (*this_36).is_far_0 = false;
    return;
}

fn descend_1( receiver_7 : Receiver_0,  aim_1 : Aim_0,  descent_2 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S279 : bool;
        if(((*descent_2).count_3) == u32(0))
        {
            _S279 = !(*descent_2).is_far_0;
        }
        else
        {
            _S279 = false;
        }
        if(_S279)
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
        var right_4 : LightNode_0 = GridLights_node_0((*descent_2).index_14);
        var of_left_0 : View_0 = view_0(left_2, receiver_7);
        var of_right_0 : View_0 = view_0(right_4, receiver_7);
        var weights_2 : vec2<f32> = weights_of_0(of_left_0.importance_0, of_right_0.importance_0);
        var _S280 : f32 = weights_2.x;
        var _S281 : f32 = weights_2.y;
        var total_4 : f32 = _S280 + _S281;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S282 : bool;
        if(_S281 <= 0.0f)
        {
            _S282 = true;
        }
        else
        {
            _S282 = ((*descent_2).choice_0 * total_4) < (_S280 * (*descent_2).weight_0);
        }
        var is_left_2 : bool;
        if(aim_1.is_met_0)
        {
            var _S283 : vec3<f32> = vec3<f32>(aim_1.hit_3.voxel_1);
            if((all((_S283 >= (vector_of_0(left_2.min_2))))))
            {
                is_left_2 = (all((_S283 < (vector_of_0(left_2.max_2)))));
            }
            else
            {
                is_left_2 = false;
            }
        }
        else
        {
            is_left_2 = _S282;
        }
        var _S284 : f32 = (*descent_2).choice_0 * total_4;
        var _S285 : f32;
        if(is_left_2)
        {
            _S285 = 0.0f;
        }
        else
        {
            _S285 = _S280 * (*descent_2).weight_0;
        }
        (*descent_2).choice_0 = _S284 - _S285;
        var _S286 : u32;
        if(is_left_2)
        {
            _S286 = (*descent_2).node_0 + u32(1);
        }
        else
        {
            _S286 = (*descent_2).index_14;
        }
        (*descent_2).node_0 = _S286;
        var _S287 : u32;
        if(is_left_2)
        {
            _S287 = left_2.index_16;
        }
        else
        {
            _S287 = right_4.index_16;
        }
        (*descent_2).index_14 = _S287;
        var _S288 : u32;
        if(is_left_2)
        {
            _S288 = left_2.count_5;
        }
        else
        {
            _S288 = right_4.count_5;
        }
        (*descent_2).count_3 = _S288;
        var _S289 : bool;
        if(is_left_2)
        {
            _S289 = of_left_0.is_far_2;
        }
        else
        {
            _S289 = of_right_0.is_far_2;
        }
        (*descent_2).is_far_0 = _S289;
        var _S290 : f32;
        if(is_left_2)
        {
            _S290 = _S280;
        }
        else
        {
            _S290 = _S281;
        }
        var _S291 : f32 = (*descent_2).weight_0 * _S290;
        (*descent_2).weight_0 = _S291;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        if(_S291 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_0( point_3 : vec3<f32>,  is_met_2 : bool,  way_3 : Descent_0,  side_1 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var node_10 : LightNode_0 = light_node_at_0(way_3.node_0);
    var _S292 : vec3<f32> = vector_of_0(node_10.max_2);
    var _S293 : vec3<f32> = vector_of_0(node_10.min_2);
    var _S294 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (_S292 - _S293) * _S294;
    var toward_1 : vec3<f32> = (_S293 + _S292) * _S294 - point_3;
    var sent_1 : BySide_0 = sent_by_side_0(node_10, point_3, length_bound_0(select(half_2, abs(toward_1), vec3<bool>(((length_squared_0(toward_1)) > (length_squared_0(half_2)))))));
    var sum_3 : f32 = normal_or_zero_0(BySide_sum_0(sent_1));
    var unit_1 : f32 = inverse_power_of_two_0(sum_3);
    var total_5 : f32 = sum_3 * unit_1;
    var _S295 : f32 = way_3.choice_0 * total_5;
    var _S296 : u32 = (*side_1);
    var share_1 : f32 = normal_or_zero_0(sent_1.low_7[u32(0)] * unit_1);
    var _S297 : bool;
    if(is_met_2)
    {
        _S297 = u32(0) == _S296;
    }
    else
    {
        _S297 = share_1 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S297)
    {
        (*side_1) = u32(0);
        chosen_2 = share_1;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S298 : bool = _S295 < (share_1 * way_3.weight_0);
    var share_2 : f32 = normal_or_zero_0(sent_1.high_4[u32(0)] * unit_1);
    if(is_met_2)
    {
        _S297 = u32(1) == _S296;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S297 = !_S298;
        }
        else
        {
            _S297 = false;
        }
    }
    if(_S297)
    {
        (*side_1) = u32(1);
        chosen_2 = share_2;
    }
    var passed_0 : f32 = share_1 + share_2;
    if(_S298)
    {
        _S297 = true;
    }
    else
    {
        _S297 = _S295 < (passed_0 * way_3.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_1.low_7[u32(1)] * unit_1);
    var _S299 : bool;
    if(is_met_2)
    {
        _S299 = u32(2) == _S296;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S299 = !_S297;
        }
        else
        {
            _S299 = false;
        }
    }
    if(_S299)
    {
        (*side_1) = u32(2);
        chosen_2 = share_3;
    }
    var passed_1 : f32 = passed_0 + share_3;
    if(_S297)
    {
        _S297 = true;
    }
    else
    {
        _S297 = _S295 < (passed_1 * way_3.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_1.high_4[u32(1)] * unit_1);
    if(is_met_2)
    {
        _S299 = u32(3) == _S296;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S299 = !_S297;
        }
        else
        {
            _S299 = false;
        }
    }
    if(_S299)
    {
        (*side_1) = u32(3);
        chosen_2 = share_4;
    }
    var passed_2 : f32 = passed_1 + share_4;
    if(_S297)
    {
        _S297 = true;
    }
    else
    {
        _S297 = _S295 < (passed_2 * way_3.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_1.low_7[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S299 = u32(4) == _S296;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S299 = !_S297;
        }
        else
        {
            _S299 = false;
        }
    }
    if(_S299)
    {
        (*side_1) = u32(4);
        chosen_2 = share_5;
    }
    var passed_3 : f32 = passed_2 + share_5;
    if(_S297)
    {
        _S297 = true;
    }
    else
    {
        _S297 = _S295 < (passed_3 * way_3.weight_0);
    }
    var share_6 : f32 = normal_or_zero_0(sent_1.high_4[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S297 = u32(5) == _S296;
    }
    else
    {
        if(share_6 > 0.0f)
        {
            _S297 = !_S297;
        }
        else
        {
            _S297 = false;
        }
    }
    if(_S297)
    {
        (*side_1) = u32(5);
        chosen_2 = share_6;
    }
    (*odds_0) = vec2<f32>(way_3.weight_0 * chosen_2, way_3.total_0 * total_5);
    if(sum_3 > 0.0f)
    {
        _S297 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S297 = false;
    }
    return _S297;
}

fn light_node_word_0( index_21 : u32,  word_6 : u32) -> u32
{
    return light_node_rows_0[u32(4) * index_21 + ((word_6 >> (u32(2))))][(word_6 & (u32(3)))];
}

fn light_power_at_0( index_22 : u32,  side_2 : u32) -> f32
{
    var _S300 : u32;
    if(lights_in_pages_0())
    {
        var _S301 : u32 = place_in_light_node_0(index_22, u32(8) + side_2);
        _S300 = cells_0[_S301];
    }
    else
    {
        _S300 = light_node_word_0(index_22, u32(8) + side_2);
    }
    return (bitcast<f32>((_S300)));
}

fn component_0( vector_5 : vec3<f32>,  axis_5 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_5 == u32(1)), vector_5.x, axis_5 == u32(0));
}

fn density_0( odds_1 : vec2<f32>,  luminance_3 : f32,  power_3 : f32,  toward_2 : vec3<f32>,  face_3 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_2, (face_3 >> (u32(1))));
    var in_front_0 : f32;
    if(((face_3 & (u32(1)))) == u32(1))
    {
        in_front_0 = - along_0;
    }
    else
    {
        in_front_0 = along_0;
    }
    var distance_squared_0 : f32 = length_squared_0(toward_2);
    var unit_2 : f32 = inverse_power_of_two_0(power_3);
    var share_7 : f32 = odds_1.x * (luminance_3 * unit_2) * (distance_squared_0 * square_root_0(distance_squared_0));
    if(in_front_0 > 0.0f)
    {
        in_front_0 = divide_0(share_7, odds_1.y * (power_3 * unit_2) * in_front_0);
    }
    else
    {
        in_front_0 = -1.0f;
    }
    return in_front_0;
}

struct Emitter_0
{
     voxel_19 : array<i32, i32(3)>,
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
    var _S302 : u32 = word_in_pages_0(emitter_0 * u32(8) + word_7, pages_0[i32(3)]);
    return _S302;
}

fn emitter_word_0( index_24 : u32,  word_8 : u32) -> u32
{
    return emitter_rows_0[u32(2) * index_24 + ((word_8 >> (u32(2))))][(word_8 & (u32(3)))];
}

fn emitter_faces_at_0( index_25 : u32) -> u32
{
    var _S303 : u32;
    if(lights_in_pages_0())
    {
        var _S304 : u32 = place_in_emitter_0(index_25, u32(4));
        _S303 = cells_0[_S304];
    }
    else
    {
        _S303 = emitter_word_0(index_25, u32(4));
    }
    return _S303;
}

fn emitter_luminance_at_0( index_26 : u32) -> f32
{
    var _S305 : f32;
    if(lights_in_pages_0())
    {
        var _S306 : u32 = place_in_emitter_0(index_26, u32(6));
        _S305 = (bitcast<f32>((cells_0[_S306])));
    }
    else
    {
        _S305 = (bitcast<f32>((emitter_word_0(index_26, u32(6)))));
    }
    return _S305;
}

fn Emitter_x24init_0( voxel_20 : array<i32, i32(3)>,  grid_2 : u32,  faces_1 : u32,  material_6 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S307 : Emitter_0;
    _S307.voxel_19 = voxel_20;
    _S307.grid_1 = grid_2;
    _S307.faces_0 = faces_1;
    _S307.material_5 = material_6;
    _S307.luminance_4 = luminance_5;
    _S307.leaf_0 = leaf_1;
    return _S307;
}

fn emitter_at_0( index_27 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S308 : u32 = u32(2) * index_27;
        var a_7 : vec4<u32> = emitter_rows_0[_S308];
        var b_7 : vec4<u32> = emitter_rows_0[_S308 + u32(1)];
        var _S309 : array<i32, i32(3)> = array<i32, i32(3)>( i32(a_7.x), i32(a_7.y), i32(a_7.z) );
        return Emitter_x24init_0(_S309, a_7.w, b_7.x, b_7.y, (bitcast<f32>((b_7.z))), b_7.w);
    }
    var at_4 : u32 = place_in_emitter_0(index_27, u32(0));
    var _S310 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_0[at_4]), i32(cells_0[at_4 + u32(1)]), i32(cells_0[at_4 + u32(2)]) );
    return Emitter_x24init_0(_S310, cells_0[at_4 + u32(3)], cells_0[at_4 + u32(4)], cells_0[at_4 + u32(5)], (bitcast<f32>((cells_0[at_4 + u32(6)]))), cells_0[at_4 + u32(7)]);
}

fn choose_emitter_0( way_4 : Descent_0,  side_3 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_3 : bool;
    var is_left_3 : bool;
    var count_6 : u32 = way_4.count_3;
    var node_11 : u32 = way_4.node_0;
    var index_28 : u32 = way_4.index_14;
    var _S311 : f32 = threshold_1;
    for(;;)
    {
        if(count_6 == u32(0))
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
        var power_left_0 : f32 = light_power_at_0(left_3, side_3);
        var power_right_0 : f32 = light_power_at_0(index_28, side_3);
        var below_left_0 : vec2<u32> = below_light_node_0(left_3);
        var below_right_0 : vec2<u32> = below_light_node_0(index_28);
        if(_S311 < power_left_0)
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
            _S311 = _S311 - power_left_0;
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
            count_6 = below_left_0.y;
        }
        else
        {
            count_6 = below_right_0.y;
        }
    }
    is_found_3 = false;
    var chosen_3 : u32 = index_28;
    var at_5 : u32 = index_28;
    for(;;)
    {
        if(at_5 < (index_28 + count_6))
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
        var _S312 : u32 = emitter_faces_at_0(at_5);
        if(((((_S312 >> (side_3))) & (u32(1)))) != u32(0))
        {
            var _S313 : f32 = emitter_luminance_at_0(at_5);
            var _S314 : bool = _S311 < _S313;
            var _S315 : f32 = emitter_luminance_at_0(at_5);
            var _S316 : f32 = _S311 - _S315;
            is_found_3 = _S314;
            chosen_3 = at_5;
            _S311 = _S316;
        }
        at_5 = at_5 + u32(1);
    }
    var _S317 : Emitter_0 = emitter_at_0(chosen_3);
    return _S317;
}

fn point_of_face_0( low_9 : vec3<f32>,  face_4 : u32,  u_7 : f32,  v_4 : f32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_4 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = 0.0f;
    }
    if(face_4 < u32(2))
    {
        return low_9 + vec3<f32>(away_0, u_7, v_4);
    }
    if(face_4 < u32(4))
    {
        return low_9 + vec3<f32>(u_7, away_0, v_4);
    }
    return low_9 + vec3<f32>(u_7, v_4, away_0);
}

fn margin_of_0( translation_1 : vec3<f32>,  low_10 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_10) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn offset_ray_origin_0( translation_2 : vec3<f32>,  low_11 : vec3<f32>,  face_5 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_11);
    var _S318 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_4, low_11 + _S318), low_11 + vec3<f32>((1.0f - margin_0)));
    var _S319 : bool = face_5 < u32(2);
    var _S320 : bool;
    if(face_5 >= u32(2))
    {
        _S320 = face_5 < u32(4);
    }
    else
    {
        _S320 = false;
    }
    var is_axis_2 : vec3<bool> = vec3<bool>(_S319, _S320, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_11 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_11 - _S318;
    }
    return select(moved_0, outside_0, is_axis_2);
}

fn Transform_direction_1( _S321 : u32,  _S322 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S321].world_from_grid_0.x_axis_0) * vec3<f32>(_S322.x) + vector_of_0(instances_0[_S321].world_from_grid_0.y_axis_0) * vec3<f32>(_S322.y) + vector_of_0(instances_0[_S321].world_from_grid_0.z_axis_0) * vec3<f32>(_S322.z);
}

fn Transform_point_1( _S323 : u32,  _S324 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S323, _S324) + vector_of_0(instances_0[_S323].world_from_grid_0.translation_0);
}

fn sample_emitter_0( receiver_8 : Receiver_0,  u_8 : vec4<f32>,  aim_2 : Aim_0,  sample_8 : ptr<function, LightSample_0>) -> bool
{
    (*sample_8) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_8.x, false);
    Descent_at_0(&(descent_3), u32(0));
    var _S325 : bool;
    if(!IS_SINGLE_0)
    {
        _S325 = aim_2.is_met_0;
    }
    else
    {
        _S325 = false;
    }
    if(_S325)
    {
        var leaf_2 : u32 = instances_0[aim_2.hit_3.instance_1].light_leaf_0;
        if((instances_0[aim_2.hit_3.instance_1].light_leaf_0) == u32(4294967295))
        {
            _S325 = true;
        }
        else
        {
            var _S326 : bool = climb_0(receiver_8, leaf_2, &(descent_3));
            _S325 = !_S326;
        }
        if(_S325)
        {
            return false;
        }
        Descent_at_0(&(descent_3), leaf_2);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S327 : bool = descend_0(receiver_8, by_chance_0(), &(descent_3));
            _S325 = !_S327;
        }
        else
        {
            _S325 = false;
        }
        if(_S325)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_14;
    var local_1 : Receiver_0 = in_grid_0(descent_3.index_14, receiver_8);
    Descent_at_1(&(descent_3), top_light_node_0(descent_3.node_0).root_1);
    var _S328 : bool = descend_1(local_1, aim_2, &(descent_3));
    if(!_S328)
    {
        return false;
    }
    var side_4 : u32 = aim_2.hit_3.face_1;
    var odds_2 : vec2<f32>;
    var _S329 : bool = choose_side_0(local_1.point_0, aim_2.is_met_0, descent_3, &(side_4), &(odds_2));
    if(!_S329)
    {
        return false;
    }
    var power_4 : f32 = light_power_at_0(descent_3.node_0, side_4);
    if(aim_2.is_met_0)
    {
        var _S330 : f32 = density_0(odds_2, aim_2.luminance_1, power_4, Transform_direction_0(chosen_instance_0, aim_2.direction_22) * vec3<f32>(aim_2.hit_3.t_1), side_4);
        (*sample_8).pdf_3 = _S330;
        return _S330 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_4, u_8.y * power_4);
    var _S331 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_19));
    var on_face_0 : vec3<f32> = point_of_face_0(_S331, side_4, u_8.z, u_8.w);
    var pdf_8 : f32 = density_0(odds_2, emitter_1.luminance_4, power_4, on_face_0 - local_1.point_0, side_4);
    if(pdf_8 < 0.0f)
    {
        return false;
    }
    var direction_27 : vec3<f32> = Transform_point_1(chosen_instance_0, offset_ray_origin_0(vector_of_0(instances_0[chosen_instance_0].grid_from_world_0.translation_0), _S331, side_4, on_face_0)) - receiver_8.point_0;
    var cos_theta_4 : f32 = with_slack_0(receiver_8, divide_0(dot_product_0(receiver_8.normal_2, direction_27), square_root_0(length_squared_0(direction_27))));
    (*sample_8) = LightSample_x24init_0(Ray_x24init_0(receiver_8.point_0, 0.0f, direction_27, 1.0f), cos_theta_4, emitted_0(material_of_index_0(emitter_1.material_5)), pdf_8);
    return cos_theta_4 > 0.0f;
}

fn EmitterTree_sample_0( receiver_9 : Receiver_0,  u_9 : vec4<f32>,  aim_3 : Aim_0,  sample_9 : ptr<function, LightSample_0>) -> bool
{
    var _S332 : bool = sample_emitter_0(receiver_9, u_9, aim_3, &((*sample_9)));
    return _S332;
}

fn Lights_sample_0( receiver_10 : Receiver_0,  selection_4 : Selection_0,  u_10 : vec4<f32>,  aim_4 : Aim_0,  sample_10 : ptr<function, LightSample_0>) -> bool
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
        is_found_4 = (u_10.x) < (selection_4.sun_0);
    }
    else
    {
        is_found_4 = false;
    }
    if(is_found_4)
    {
        var _S333 : bool = SunDisc_sample_0(receiver_10, u_10, &((*sample_10)));
        (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.sun_0;
        is_found_4 = _S333;
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
            is_found_4 = (u_10.x) < (selection_4.sun_0 + selection_4.sky_1);
        }
        else
        {
            is_found_4 = false;
        }
        if(is_found_4)
        {
            var _S334 : bool = Sky_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - selection_4.sun_0, selection_4.sky_1), 0.99999994039535522f), u_10.yzw), &((*sample_10)));
            (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.sky_1;
            is_found_4 = _S334;
        }
        else
        {
            var _S335 : bool = EmitterTree_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - (selection_4.sun_0 + selection_4.sky_1), selection_4.emitters_0), 0.99999994039535522f), u_10.yzw), aim_4, &((*sample_10)));
            (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.emitters_0;
            is_found_4 = _S335;
        }
    }
    return is_found_4;
}

fn ior_of_0( inside_4 : Inside_0) -> f32
{
    var _S336 : f32;
    if(Inside_is_in_0(inside_4))
    {
        _S336 = material_of_index_0(inside_4.material_0).ior_0;
    }
    else
    {
        _S336 = 1.0f;
    }
    return _S336;
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
    var _S337 : Microfacets_0;
    _S337.alpha_0 = alpha_1;
    return _S337;
}

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S338 : MaterialBsdf_0;
    _S338.kind_0 = kind_1;
    _S338.color_1 = color_2;
    _S338.specular_1 = specular_2;
    _S338.eta_0 = eta_1;
    _S338.facets_0 = facets_1;
    return _S338;
}

fn bsdf_of_0( material_7 : PackedMaterial_0,  ior_1 : f32,  choice_2 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_7.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn MaterialBsdf_albedo_0( this_37 : MaterialBsdf_0) -> vec3<f32>
{
    return this_37.color_1;
}

fn roulette_0( event_2 : u32,  scattered_2 : vec3<f32>,  u_11 : f32) -> f32
{
    if(event_2 < u32(3))
    {
        return 1.0f;
    }
    var _S339 : f32 = min(max_element_0(scattered_2), 0.94999998807907104f);
    var _S340 : f32;
    if(u_11 < _S339)
    {
        _S340 = divide_0(1.0f, _S339);
    }
    else
    {
        _S340 = 0.0f;
    }
    return _S340;
}

struct Surface_0
{
     origin_11 : vec3<f32>,
     normal_4 : vec3<f32>,
     face_6 : u32,
     instance_10 : u32,
};

fn face_normal_0( face_7 : u32) -> vec3<f32>
{
    var away_1 : f32;
    if(((face_7 & (u32(1)))) == u32(1))
    {
        away_1 = 1.0f;
    }
    else
    {
        away_1 = -1.0f;
    }
    var _S341 : f32;
    if(face_7 < u32(2))
    {
        _S341 = away_1;
    }
    else
    {
        _S341 = 0.0f;
    }
    var _S342 : bool;
    if(face_7 >= u32(2))
    {
        _S342 = face_7 < u32(4);
    }
    else
    {
        _S342 = false;
    }
    var _S343 : f32;
    if(_S342)
    {
        _S343 = away_1;
    }
    else
    {
        _S343 = 0.0f;
    }
    if(face_7 >= u32(4))
    {
    }
    else
    {
        away_1 = 0.0f;
    }
    return vec3<f32>(_S341, _S343, away_1);
}

fn world_normal_0( _S344 : u32,  _S345 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S344, face_normal_0(_S345)));
}

fn surface_of_0( ray_17 : Ray_0,  hit_5 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S346 : vec3<f32> = vec3<f32>(hit_5.voxel_1);
    if(IS_SINGLE_0)
    {
        surface_0.origin_11 = offset_ray_origin_0(vec3<f32>(0.0f), _S346, hit_5.face_1, ray_17.origin_2 + ray_17.direction_1 * vec3<f32>(hit_5.t_1));
        surface_0.normal_4 = face_normal_0(hit_5.face_1);
    }
    else
    {
        surface_0.origin_11 = Transform_point_1(hit_5.instance_1, offset_ray_origin_0(vector_of_0(instances_0[hit_5.instance_1].grid_from_world_0.translation_0), _S346, hit_5.face_1, Transform_point_0(hit_5.instance_1, ray_17.origin_2) + Transform_direction_0(hit_5.instance_1, ray_17.direction_1) * vec3<f32>(hit_5.t_1)));
        surface_0.normal_4 = world_normal_0(hit_5.instance_1, hit_5.face_1);
    }
    surface_0.face_6 = hit_5.face_1;
    surface_0.instance_10 = hit_5.instance_1;
    return surface_0;
}

fn Surface_local_direction_0( this_38 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(this_38.instance_10, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_2 : vec3<f32>;
    if((this_38.face_6) < u32(2))
    {
        local_2 = in_grid_2.yzx;
    }
    else
    {
        if((this_38.face_6) < u32(4))
        {
            local_2 = in_grid_2.zxy;
        }
        else
        {
            local_2 = in_grid_2;
        }
    }
    if((((this_38.face_6) & (u32(1)))) == u32(1))
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

fn Inside_point_0( this_39 : Inside_0,  ray_18 : Ray_0,  t_11 : f32) -> vec3<f32>
{
    return Transform_point_1(this_39.instance_2, clamp_to_voxel_0(vector_of_0(instances_0[this_39.instance_2].grid_from_world_0.translation_0), vec3<f32>(this_39.voxel_2), Transform_point_0(this_39.instance_2, ray_18.origin_2) + Transform_direction_0(this_39.instance_2, ray_18.direction_1) * vec3<f32>(t_11)));
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
    var cos_theta_5 : f32 = with_slack_0(receiver_13, dot_product_0(receiver_13.normal_2, params_0.sun_direction_0));
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

fn Lights_sky_probability_0( receiver_14 : Receiver_0) -> f32
{
    var cos_theta_6 : f32 = dot_product_0(receiver_14.normal_2, params_0.sun_direction_0);
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
    var _S347 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S347, sky_3, (1.0f - sun_2) * _S347);
}

fn MaterialBsdf_is_delta_0( this_40 : MaterialBsdf_0) -> bool
{
    return false;
}

fn Path_dimension_light_0( this_41 : Path_0) -> u32
{
    return u32(2) + u32(2) * Path_events_0(this_41);
}

struct BsdfEval_0
{
     weight_3 : vec3<f32>,
     pdf_9 : f32,
};

struct Diffuse_0
{
     reflectance_0 : vec3<f32>,
};

fn Diffuse_x24init_0( reflectance_1 : vec3<f32>) -> Diffuse_0
{
    var _S348 : Diffuse_0;
    _S348.reflectance_0 = reflectance_1;
    return _S348;
}

fn cosine_hemisphere_pdf_0( cos_theta_7 : f32) -> f32
{
    return max(cos_theta_7, 0.0f) * 0.31830987334251404f;
}

fn BsdfEval_x24init_0( weight_4 : vec3<f32>,  pdf_10 : f32) -> BsdfEval_0
{
    var _S349 : BsdfEval_0;
    _S349.weight_3 = weight_4;
    _S349.pdf_9 = pdf_10;
    return _S349;
}

fn Diffuse_eval_0( this_42 : Diffuse_0,  wo_0 : vec3<f32>,  wi_0 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_42.reflectance_0, cosine_hemisphere_pdf_0(wi_0.z));
}

fn MaterialBsdf_eval_0( this_43 : MaterialBsdf_0,  wo_1 : vec3<f32>,  wi_1 : vec3<f32>) -> BsdfEval_0
{
    return Diffuse_eval_0(Diffuse_x24init_0(this_43.color_1), wo_1, wi_1);
}

struct BsdfSample_0
{
     wi_2 : vec3<f32>,
     weight_5 : vec3<f32>,
     pdf_11 : f32,
     is_delta_0 : bool,
};

fn cosine_hemisphere_0( u_12 : f32,  v_5 : f32) -> vec3<f32>
{
    var radius_6 : f32 = square_root_0(u_12);
    var sin_cos_4 : vec2<f32> = sincos_turns_0(v_5);
    return vec3<f32>(radius_6 * sin_cos_4.y, radius_6 * sin_cos_4.x, square_root_0(1.0f - u_12));
}

fn BsdfSample_x24init_0( wi_3 : vec3<f32>,  weight_6 : vec3<f32>,  pdf_12 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S350 : BsdfSample_0;
    _S350.wi_2 = wi_3;
    _S350.weight_5 = weight_6;
    _S350.pdf_11 = pdf_12;
    _S350.is_delta_0 = is_delta_1;
    return _S350;
}

fn Diffuse_sample_0( this_44 : Diffuse_0,  wo_2 : vec3<f32>,  u_13 : vec3<f32>,  sample_11 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_4 : vec3<f32> = cosine_hemisphere_0(u_13.x, u_13.y);
    (*sample_11) = BsdfSample_x24init_0(wi_4, this_44.reflectance_0, cosine_hemisphere_pdf_0(wi_4.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_45 : MaterialBsdf_0,  wo_3 : vec3<f32>,  u_14 : vec3<f32>,  sample_12 : ptr<function, BsdfSample_0>) -> bool
{
    var _S351 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_45.color_1), wo_3, u_14, &((*sample_12)));
    return _S351;
}

fn Surface_world_direction_0( this_46 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_46.face_6) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S352 : f32 = local_3.x;
    var _S353 : f32 = local_3.y;
    var _S354 : vec3<f32> = vec3<f32>(_S352, _S353, away_2);
    var in_grid_3 : vec3<f32>;
    if((this_46.face_6) < u32(2))
    {
        in_grid_3 = vec3<f32>(away_2, _S352, _S353);
    }
    else
    {
        if((this_46.face_6) < u32(4))
        {
            in_grid_3 = vec3<f32>(_S353, away_2, _S352);
        }
        else
        {
            in_grid_3 = _S354;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_3 = Transform_direction_1(this_46.instance_10, in_grid_3);
    }
    return normalize_vector_0(in_grid_3);
}

fn PathTracingOf_advance_0( path_5 : ptr<function, Path_0>,  ray_19 : Ray_0,  hit_6 : Hit_0,  beyond_3 : u32,  radiance_6 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_0 : NextRays_0 = no_rays_0();
    var is_counted_0 : bool = Path_is_counted_0((*path_5));
    var t_12 : f32;
    if(is_counted_0)
    {
        t_12 = - (*path_5).pdf_1;
    }
    else
    {
        t_12 = (*path_5).pdf_1;
    }
    (*path_5).pdf_1 = t_12;
    var last_6 : Receiver_0 = Path_receiver_0((*path_5), ray_19);
    var is_scattered_0 : bool;
    if(Inside_is_in_0((*path_5).inside_0))
    {
        is_scattered_0 = Hit_is_miss_0(hit_6);
    }
    else
    {
        is_scattered_0 = false;
    }
    if(Inside_is_in_0((*path_5).inside_0))
    {
        if(is_scattered_0)
        {
            t_12 = scattering_t_0((*path_5), (*path_5).inside_0, ray_19);
        }
        else
        {
            t_12 = hit_6.t_1;
        }
        if(!is_counted_0)
        {
            absorb_0(&((*path_5)), (*path_5).inside_0, ray_19, t_12);
        }
    }
    else
    {
        t_12 = hit_6.t_1;
    }
    var is_weighed_0 : bool;
    if(Hit_is_miss_0(hit_6))
    {
        is_weighed_0 = !is_scattered_0;
    }
    else
    {
        is_weighed_0 = false;
    }
    var light_pdf_1 : f32;
    if(is_weighed_0)
    {
        (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * Sky_le_0(ray_19.direction_1) * vec3<f32>(mis_weight_0((*path_5).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_5), last_6), ray_19.direction_1)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_0 = true;
            }
            else
            {
                is_scattered_0 = !Path_is_straight_0((*path_5));
            }
        }
        else
        {
            is_scattered_0 = false;
        }
        if(is_scattered_0)
        {
            var le_0 : vec3<f32> = SunDisc_le_0(ray_19.direction_1);
            if((max_element_0(le_0)) > 0.0f)
            {
                if(((*path_5).pdf_1) == 0.0f)
                {
                    light_pdf_1 = 0.0f;
                }
                else
                {
                    light_pdf_1 = Lights_sun_pdf_0(Path_selection_at_0((*path_5), last_6), ray_19.direction_1);
                }
                (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * le_0 * vec3<f32>(mis_weight_0((*path_5).pdf_1, light_pdf_1));
            }
        }
        return next_0;
    }
    var u_15 : vec4<f32> = Sampler_stratified_0((*path_5).sampler_0, Path_dimension_scatter_0((*path_5)));
    var material_8 : PackedMaterial_0 = material_met_0((*path_5), hit_6, beyond_3);
    var _S355 : vec3<f32> = vec3<f32>(0.0f);
    var le_1 : vec3<f32>;
    if(!is_counted_0)
    {
        le_1 = EmitterTree_le_0(material_8);
    }
    else
    {
        le_1 = _S355;
    }
    var is_lit_0 : bool = (max_element_0(le_1)) > 0.0f;
    var met_0 : Aim_0 = Aim_x24init_0(true, ray_19.direction_1, hit_6, luminance_0(vector_of_0(material_8.emission_0)));
    var _S356 : bool = weighs_apart_0();
    if(_S356)
    {
        is_weighed_0 = is_lit_0;
    }
    else
    {
        is_weighed_0 = false;
    }
    if(is_weighed_0)
    {
        is_weighed_0 = ((*path_5).pdf_1) > 0.0f;
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
        var light_2 : LightSample_0 = no_light_0();
        if(!_S356)
        {
            is_chosen_0 = ((*path_5).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_0 = false;
        }
        if(is_chosen_0)
        {
            var _S357 : bool = Lights_sample_0(last_6, Path_selection_at_0((*path_5), last_6), vec4<f32>(0.0f), met_0, &(light_2));
            is_chosen_0 = _S357;
        }
        else
        {
            is_chosen_0 = false;
        }
        var _S358 : vec3<f32> = (*path_5).beta_0 * le_1;
        var _S359 : f32 = (*path_5).pdf_1;
        if(is_chosen_0)
        {
            light_pdf_1 = light_2.pdf_3;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + _S358 * vec3<f32>(mis_weight_0(_S359, light_pdf_1));
    }
    var _S360 : f32 = ior_of_0((*path_5).inside_0);
    var _S361 : f32 = u_15[i32(3)];
    var _S362 : MaterialBsdf_0 = bsdf_of_0(material_8, _S360, &(_S361));
    u_15[i32(3)] = _S361;
    var scattered_3 : vec3<f32> = (*path_5).beta_0 * MaterialBsdf_albedo_0(_S362);
    var _S363 : bool = ((*path_5).bounce_0) >= (params_0.max_bounces_0);
    var _S364 : bool = !is_weighed_0;
    if(_S364)
    {
        if(_S363)
        {
            is_chosen_0 = true;
        }
        else
        {
            is_chosen_0 = (max_element_0(scattered_3)) <= 0.0f;
        }
    }
    else
    {
        is_chosen_0 = false;
    }
    if(is_chosen_0)
    {
        return next_0;
    }
    var compensation_0 : f32 = roulette_0(Path_events_0((*path_5)), scattered_3, u_15.z);
    if(_S364)
    {
        is_chosen_0 = compensation_0 == 0.0f;
    }
    else
    {
        is_chosen_0 = false;
    }
    if(is_chosen_0)
    {
        return next_0;
    }
    var at_6 : Hit_0;
    if(is_scattered_0)
    {
        at_6 = Hit_x24init_0(t_12, (*path_5).inside_0.instance_2, hit_6.voxel_1, u32(0));
    }
    else
    {
        at_6 = hit_6;
    }
    var surface_1 : Surface_0 = surface_of_0(ray_19, at_6);
    var _S365 : Receiver_0 = Receiver_x24init_0(surface_1.origin_11, surface_1.normal_4);
    var _S366 : vec3<f32> = (vec3<f32>(0) - ray_19.direction_1);
    var wo_4 : vec3<f32> = Surface_local_direction_0(surface_1, _S366);
    var inside_5 : Inside_0 = in_air_0();
    var wo_5 : vec3<f32>;
    var receiver_16 : Receiver_0;
    if(is_scattered_0)
    {
        var _S367 : Inside_0 = Inside_x24init_0((*path_5).inside_0.instance_2, hit_6.voxel_1, (*path_5).inside_0.material_0);
        inside_5 = _S367;
        var _S368 : vec3<f32> = normalize_vector_0(_S366);
        receiver_16 = Receiver_x24init_0(Inside_point_0(_S367, ray_19, t_12), _S355);
        wo_5 = _S368;
    }
    else
    {
        if(Inside_is_in_0((*path_5).inside_0))
        {
            next_0.relocates_1 = (hit_6.instance_1) != ((*path_5).inside_0.instance_2);
            inside_5 = Inside_x24init_0((*path_5).inside_0.instance_2, hit_6.voxel_1, (*path_5).inside_0.material_0);
            inside_5.voxel_2 = hit_6.voxel_1 + vec3<i32>(face_normal_0(hit_6.face_1));
        }
        receiver_16 = _S365;
        wo_5 = wo_4;
    }
    next_0.origin_9 = receiver_16.point_0;
    next_0.shadow_inside_1 = inside_5;
    var _S369 : Aim_0 = by_chance_0();
    var aim_5 : Aim_0;
    if(is_weighed_0)
    {
        receiver_16 = last_6;
        aim_5 = met_0;
    }
    else
    {
        aim_5 = _S369;
    }
    if(_S364)
    {
        (*path_5).selection_0 = Lights_selection_0(receiver_16);
    }
    var light_3 : LightSample_0 = no_light_0();
    var _S370 : bool = !MaterialBsdf_is_delta_0(_S362);
    if(is_weighed_0)
    {
        is_chosen_0 = true;
    }
    else
    {
        is_chosen_0 = _S370;
    }
    if(is_chosen_0)
    {
        var _S371 : bool = Lights_sample_0(receiver_16, (*path_5).selection_0, Sampler_stratified_0((*path_5).sampler_0, Path_dimension_light_0((*path_5))), aim_5, &(light_3));
        next_0.has_shadow_ray_0 = _S371;
    }
    if(is_weighed_0)
    {
        if(next_0.has_shadow_ray_0)
        {
            light_pdf_1 = light_3.pdf_3;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * le_1 * vec3<f32>(mis_weight_0((*path_5).pdf_1, light_pdf_1));
        (*path_5).pdf_1 = - (*path_5).pdf_1;
        next_0.is_same_0 = true;
        return next_0;
    }
    if(next_0.has_shadow_ray_0)
    {
        var _S372 : vec3<f32> = vec3<f32>(Surface_local_direction_0(surface_1, light_3.ray_15.direction_1).xy, light_3.cos_theta_0);
        var wi_5 : vec3<f32>;
        if(is_scattered_0)
        {
            wi_5 = normalize_vector_0(light_3.ray_15.direction_1);
        }
        else
        {
            wi_5 = _S372;
        }
        var eval_0 : BsdfEval_0 = MaterialBsdf_eval_0(_S362, wo_5, wi_5);
        var share_8 : f32 = divide_0(eval_0.pdf_9, light_3.pdf_3) * power_heuristic_0(light_3.pdf_3, eval_0.pdf_9);
        next_0.shadow_direction_0 = light_3.ray_15.direction_1;
        next_0.shadow_t_max_0 = light_3.ray_15.t_max_1;
        next_0.light_0 = (*path_5).beta_0 * eval_0.weight_3 * vec3<f32>(compensation_0) * light_3.radiance_2 * vec3<f32>(share_8);
    }
    var bounce_4 : BsdfSample_0;
    var _S373 : bool = MaterialBsdf_sample_0(_S362, wo_5, vec3<f32>(u_15.xy, u_15.w), &(bounce_4));
    if(!_S373)
    {
        return next_0;
    }
    (*path_5).beta_0 = (*path_5).beta_0 * bounce_4.weight_5 * vec3<f32>(compensation_0);
    if(bounce_4.is_delta_0)
    {
        t_12 = 0.0f;
    }
    else
    {
        t_12 = bounce_4.pdf_11;
    }
    (*path_5).pdf_1 = t_12;
    (*path_5).normal_0 = receiver_16.normal_2;
    next_0.direction_6 = bounce_4.wi_2;
    if(!is_scattered_0)
    {
        next_0.direction_6 = Surface_world_direction_0(surface_1, bounce_4.wi_2);
    }
    next_0.path_relocates_1 = next_0.relocates_1;
    (*path_5).bounce_0 = (*path_5).bounce_0 + u32(1);
    return next_0;
}

fn place_of_0( at_7 : vec2<u32>) -> u32
{
    var relative_2 : vec2<u32> = at_7 - params_0.region_0.xy;
    return relative_2.y * (params_0.region_0.z - params_0.region_0.x) + relative_2.x;
}

struct PixelRecord_0
{
     radiance_1 : array<u32, i32(6)>,
     samples_0 : u32,
     covered_0 : u32,
};

fn fixed_point_0( value_2 : f32) -> vec2<u32>
{
    if(!(value_2 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_4 : u32 = (bitcast<u32>((min(value_2, 1.048576e+06f))));
    var shift_6 : i32 = i32((bits_4 >> (u32(23)))) - i32(118);
    var mantissa_3 : u32 = (((bits_4 & (u32(8388607)))) | (u32(8388608)));
    if(shift_6 <= i32(-24))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    if(shift_6 < i32(0))
    {
        return vec2<u32>((mantissa_3 >> (u32(- shift_6))), u32(0));
    }
    if(shift_6 < i32(32))
    {
        var _S374 : u32 = (mantissa_3 << (u32(shift_6)));
        var _S375 : u32;
        if(shift_6 == i32(0))
        {
            _S375 = u32(0);
        }
        else
        {
            _S375 = (mantissa_3 >> (u32(i32(32) - shift_6)));
        }
        return vec2<u32>(_S374, _S375);
    }
    return vec2<u32>(u32(0), (mantissa_3 << (u32(shift_6 - i32(32)))));
}

fn PixelRecord_add_0( this_47 : ptr<function, PixelRecord_0>,  value_3 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_3[u32(0)]);
    var _S376 : u32 = addend_0.x;
    var low_13 : u32 = (*this_47).radiance_1[u32(0)] + _S376;
    var high_6 : u32 = (*this_47).radiance_1[u32(1)] + addend_0.y + u32(low_13 < _S376);
    var is_full_0 : bool = high_6 < ((*this_47).radiance_1[u32(1)]);
    var _S377 : u32;
    if(is_full_0)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = low_13;
    }
    (*this_47).radiance_1[u32(0)] = _S377;
    if(is_full_0)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = high_6;
    }
    (*this_47).radiance_1[u32(1)] = _S377;
    var addend_1 : vec2<u32> = fixed_point_0(value_3[u32(1)]);
    var _S378 : u32 = addend_1.x;
    var low_14 : u32 = (*this_47).radiance_1[u32(2)] + _S378;
    var high_7 : u32 = (*this_47).radiance_1[u32(3)] + addend_1.y + u32(low_14 < _S378);
    var is_full_1 : bool = high_7 < ((*this_47).radiance_1[u32(3)]);
    if(is_full_1)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = low_14;
    }
    (*this_47).radiance_1[u32(2)] = _S377;
    if(is_full_1)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = high_7;
    }
    (*this_47).radiance_1[u32(3)] = _S377;
    var addend_2 : vec2<u32> = fixed_point_0(value_3[u32(2)]);
    var _S379 : u32 = addend_2.x;
    var low_15 : u32 = (*this_47).radiance_1[u32(4)] + _S379;
    var high_8 : u32 = (*this_47).radiance_1[u32(5)] + addend_2.y + u32(low_15 < _S379);
    var is_full_2 : bool = high_8 < ((*this_47).radiance_1[u32(5)]);
    if(is_full_2)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = low_15;
    }
    (*this_47).radiance_1[u32(4)] = _S377;
    if(is_full_2)
    {
        _S377 = u32(4294967295);
    }
    else
    {
        _S377 = high_8;
    }
    (*this_47).radiance_1[u32(5)] = _S377;
    (*this_47).samples_0 = (*this_47).samples_0 + u32(1);
    (*this_47).covered_0 = (*this_47).covered_0 + u32(is_covered_0);
    return;
}

fn add_sample_0( index_29 : u32,  radiance_7 : vec3<f32>,  is_covered_1 : bool)
{
    var pixel_6 : PixelRecord_0;
    pixel_6.radiance_1 = pixels_0[index_29].radiance_1;
    pixel_6.samples_0 = pixels_0[index_29].samples_0;
    pixel_6.covered_0 = pixels_0[index_29].covered_0;
    PixelRecord_add_0(&(pixel_6), radiance_7, is_covered_1);
    pixels_0[index_29].radiance_1 = pixel_6.radiance_1;
    pixels_0[index_29].samples_0 = pixel_6.samples_0;
    pixels_0[index_29].covered_0 = pixel_6.covered_0;
    return;
}

fn trace_pixel_0( work_0 : Work_0) -> RayCounts_0
{
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S380 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_8 : vec3<f32> = _S380;
    var path_6 : Path_0;
    var _S381 : Ray_0 = camera_path_0(work_0.pixel_5, work_0.sample_5, &(path_6));
    var ray_20 : Ray_0 = _S381;
    var shadow_inside_3 : Inside_0 = in_air_0();
    var relocates_3 : bool = true;
    var path_relocates_3 : bool = true;
    var is_shadow_turn_0 : bool = true;
    var is_shadow_ray_1 : bool = false;
    var direction_28 : vec3<f32> = _S380;
    var is_covered_2 : bool = false;
    var sample_13 : u32 = work_0.sample_5;
    var light_4 : vec3<f32> = _S380;
    for(;;)
    {
        if(sample_13 < (work_0.last_2))
        {
        }
        else
        {
            break;
        }
        var is_shadow_turn_1 : bool = !is_shadow_turn_0;
        if(is_shadow_ray_1 != is_shadow_turn_1)
        {
            is_shadow_turn_0 = is_shadow_turn_1;
            continue;
        }
        var _S382 : Sampler_0 = sampler_of_0(work_0.pixel_5, sample_13);
        var beyond_4 : u32;
        var _S383 : Hit_0 = hit_of_ray_0(_S382, &(ray_20), is_shadow_ray_1, &(path_6), &(shadow_inside_3), &(relocates_3), &(path_relocates_3), &(beyond_4));
        if(waits_for_pages_0())
        {
            break;
        }
        var is_covered_3 : bool;
        if(is_shadow_ray_1)
        {
            counts_0.shadow_0 = counts_0.shadow_0 + u32(1);
            if(Hit_is_miss_0(_S383))
            {
                radiance_8 = radiance_8 + light_4;
            }
            ray_20 = PathTracingOf_clip_0(ray_from_0(ray_20.origin_2, direction_28));
            is_shadow_ray_1 = false;
        }
        else
        {
            if((Path_events_0(path_6)) == u32(0))
            {
                if(!Hit_is_miss_0(_S383))
                {
                    is_covered_3 = true;
                }
                else
                {
                    is_covered_3 = Inside_is_in_0(path_6.inside_0);
                }
            }
            else
            {
                if(!Path_is_counted_0(path_6))
                {
                    counts_0.bounce_2 = counts_0.bounce_2 + u32(1);
                }
                is_covered_3 = is_covered_2;
            }
            var _S384 : NextRays_0 = no_rays_0();
            path_6.sampler_0 = _S382;
            var _S385 : bool;
            if(is_covered_3)
            {
                _S385 = true;
            }
            else
            {
                _S385 = (params_0.is_transparent_0) == u32(0);
            }
            var next_1 : NextRays_0;
            if(_S385)
            {
                var _S386 : NextRays_0 = PathTracingOf_advance_0(&(path_6), ray_20, _S383, beyond_4, &(radiance_8));
                next_1 = _S386;
            }
            else
            {
                next_1 = _S384;
            }
            var _S387 : bool;
            if(weighs_apart_0())
            {
                _S387 = next_1.is_same_0;
            }
            else
            {
                _S387 = false;
            }
            if(_S387)
            {
                is_shadow_turn_0 = is_shadow_turn_1;
                is_covered_2 = is_covered_3;
                continue;
            }
            var _S388 : NextRays_0 = next_1;
            var _S389 : NextRays_0 = next_1;
            var _S390 : NextRays_0 = next_1;
            var _S391 : NextRays_0 = next_1;
            ray_20 = PathTracingOf_clip_0(ray_from_0(next_1.origin_9, next_1.direction_6));
            if(_S390.has_shadow_ray_0)
            {
                ray_20 = Ray_x24init_0(_S391.origin_9, 0.0f, next_1.shadow_direction_0, next_1.shadow_t_max_0);
            }
            is_shadow_ray_1 = _S390.has_shadow_ray_0;
            direction_28 = _S388.direction_6;
            is_covered_2 = is_covered_3;
            light_4 = _S389.light_0;
        }
        if(waits_for_pages_0())
        {
            break;
        }
        if(!is_shadow_ray_1)
        {
            is_covered_3 = (all((direction_28 == _S380)));
        }
        else
        {
            is_covered_3 = false;
        }
        if(is_covered_3)
        {
            var _S392 : vec2<u32> = position_of_0(work_0.pixel_5);
            add_sample_0(place_of_0(_S392), radiance_8, is_covered_2);
            radiance_8 = _S380;
            var sample_14 : u32 = sample_13 + u32(1);
            if(sample_14 == (work_0.last_2))
            {
                break;
            }
            var _S393 : Ray_0 = camera_path_0(work_0.pixel_5, sample_14, &(path_6));
            ray_20 = _S393;
            relocates_3 = true;
            path_relocates_3 = true;
            sample_13 = sample_14;
        }
        is_shadow_turn_0 = is_shadow_turn_1;
    }
    return counts_0;
}

fn hit_of_ray_1( sampler_4 : Sampler_0,  ray_21 : ptr<function, Ray_0>,  is_shadow_ray_2 : bool,  path_7 : ptr<function, Path_0>,  shadow_inside_4 : ptr<function, Inside_0>,  relocates_4 : ptr<function, bool>,  path_relocates_4 : ptr<function, bool>,  beyond_5 : ptr<function, u32>) -> Hit_0
{
    (*beyond_5) = u32(4294967295);
    var _S394 : Hit_0 = WalkTracer_trace_0(&((*ray_21)), is_shadow_ray_2);
    return _S394;
}

fn Essay_jitter_0( sampler_5 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_5, u32(0));
}

fn Essay_clip_0( ray_22 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_22.origin_2, 0.10000000149011612f, ray_22.direction_1, 10000.0f);
}

fn camera_path_1( pixel_7 : u32,  sample_15 : u32,  path_8 : ptr<function, Path_0>) -> Ray_0
{
    (*path_8) = Path_x24init_0(sampler_of_0(pixel_7, sample_15), u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
    var jitter_1 : vec4<f32> = Essay_jitter_0((*path_8).sampler_0);
    var _S395 : CameraFrame_0 = FrameParams_camera_0();
    var _S396 : vec2<u32> = position_of_0(pixel_7);
    return Essay_clip_0(CameraFrame_ray_0(_S395, vec2<f32>(_S396) + jitter_1.xy, jitter_1.zw));
}

fn Essay_advance_0( path_9 : ptr<function, Path_0>,  ray_23 : Ray_0,  hit_7 : Hit_0,  beyond_6 : u32,  radiance_9 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_2 : NextRays_0 = no_rays_0();
    if(Hit_is_miss_0(hit_7))
    {
        (*radiance_9) = (*radiance_9) + (*path_9).beta_0 * Sky_radiance_0(ray_23.direction_1);
        return next_2;
    }
    var material_9 : PackedMaterial_0 = material_of_0(hit_7);
    if((max_element_0(vector_of_0(material_9.emission_0))) > 0.0f)
    {
        (*radiance_9) = (*radiance_9) + (*path_9).beta_0 * emitted_0(material_9);
        return next_2;
    }
    if(((*path_9).bounce_0) == (params_0.max_bounces_0))
    {
        return next_2;
    }
    var u_16 : vec4<f32> = Sampler_independent_0((*path_9).sampler_0, Path_dimension_scatter_0((*path_9)));
    var surface_2 : Surface_0 = surface_of_0(ray_23, hit_7);
    (*path_9).beta_0 = (*path_9).beta_0 * vector_of_0(material_9.base_color_0);
    (*path_9).bounce_0 = (*path_9).bounce_0 + u32(1);
    next_2.origin_9 = surface_2.origin_11;
    next_2.direction_6 = Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_16.x, u_16.y));
    return next_2;
}

fn trace_pixel_1( work_1 : Work_0) -> RayCounts_0
{
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S397 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_10 : vec3<f32> = _S397;
    var path_10 : Path_0;
    var _S398 : Ray_0 = camera_path_1(work_1.pixel_5, work_1.sample_5, &(path_10));
    var ray_24 : Ray_0 = _S398;
    var shadow_inside_5 : Inside_0 = in_air_0();
    var relocates_5 : bool = true;
    var path_relocates_5 : bool = true;
    var is_shadow_ray_3 : bool = false;
    var direction_29 : vec3<f32> = _S397;
    var is_covered_4 : bool = false;
    var sample_16 : u32 = work_1.sample_5;
    var light_5 : vec3<f32> = _S397;
    for(;;)
    {
        if(sample_16 < (work_1.last_2))
        {
        }
        else
        {
            break;
        }
        var _S399 : Sampler_0 = sampler_of_0(work_1.pixel_5, sample_16);
        var beyond_7 : u32;
        var _S400 : Hit_0 = hit_of_ray_1(_S399, &(ray_24), is_shadow_ray_3, &(path_10), &(shadow_inside_5), &(relocates_5), &(path_relocates_5), &(beyond_7));
        if(waits_for_pages_0())
        {
            break;
        }
        var is_covered_5 : bool;
        if(is_shadow_ray_3)
        {
            counts_1.shadow_0 = counts_1.shadow_0 + u32(1);
            if(Hit_is_miss_0(_S400))
            {
                radiance_10 = radiance_10 + light_5;
            }
            ray_24 = Essay_clip_0(ray_from_0(ray_24.origin_2, direction_29));
            is_shadow_ray_3 = false;
        }
        else
        {
            if((Path_events_0(path_10)) == u32(0))
            {
                if(!Hit_is_miss_0(_S400))
                {
                    is_covered_5 = true;
                }
                else
                {
                    is_covered_5 = Inside_is_in_0(path_10.inside_0);
                }
            }
            else
            {
                if(!Path_is_counted_0(path_10))
                {
                    counts_1.bounce_2 = counts_1.bounce_2 + u32(1);
                }
                is_covered_5 = is_covered_4;
            }
            var _S401 : NextRays_0 = no_rays_0();
            path_10.sampler_0 = _S399;
            var _S402 : bool;
            if(is_covered_5)
            {
                _S402 = true;
            }
            else
            {
                _S402 = (params_0.is_transparent_0) == u32(0);
            }
            var next_3 : NextRays_0;
            if(_S402)
            {
                var _S403 : NextRays_0 = Essay_advance_0(&(path_10), ray_24, _S400, beyond_7, &(radiance_10));
                next_3 = _S403;
            }
            else
            {
                next_3 = _S401;
            }
            var _S404 : bool;
            if(weighs_apart_0())
            {
                _S404 = next_3.is_same_0;
            }
            else
            {
                _S404 = false;
            }
            if(_S404)
            {
                is_covered_4 = is_covered_5;
                continue;
            }
            var _S405 : NextRays_0 = next_3;
            var _S406 : NextRays_0 = next_3;
            var _S407 : NextRays_0 = next_3;
            var _S408 : NextRays_0 = next_3;
            ray_24 = Essay_clip_0(ray_from_0(next_3.origin_9, next_3.direction_6));
            if(_S407.has_shadow_ray_0)
            {
                ray_24 = Ray_x24init_0(_S408.origin_9, 0.0f, next_3.shadow_direction_0, next_3.shadow_t_max_0);
            }
            is_shadow_ray_3 = _S407.has_shadow_ray_0;
            direction_29 = _S405.direction_6;
            is_covered_4 = is_covered_5;
            light_5 = _S406.light_0;
        }
        if(waits_for_pages_0())
        {
            break;
        }
        if(!is_shadow_ray_3)
        {
            is_covered_5 = (all((direction_29 == _S397)));
        }
        else
        {
            is_covered_5 = false;
        }
        if(is_covered_5)
        {
            var _S409 : vec2<u32> = position_of_0(work_1.pixel_5);
            add_sample_0(place_of_0(_S409), radiance_10, is_covered_4);
            radiance_10 = _S397;
            var sample_17 : u32 = sample_16 + u32(1);
            if(sample_17 == (work_1.last_2))
            {
                break;
            }
            var _S410 : Ray_0 = camera_path_1(work_1.pixel_5, sample_17, &(path_10));
            ray_24 = _S410;
            relocates_5 = true;
            path_relocates_5 = true;
            sample_16 = sample_17;
        }
    }
    return counts_1;
}

var<workgroup> group_counts_0 : array<atomic<u32>, i32(3)>;

fn begin_tally_0( thread_0 : u32)
{
    if(thread_0 < u32(3))
    {
        atomicStore(&(group_counts_0[thread_0]), u32(0));
    }
    workgroupBarrier();
    return;
}

fn Work_x24init_0( pixel_8 : u32,  sample_18 : u32,  last_7 : u32) -> Work_0
{
    var _S411 : Work_0;
    _S411.pixel_5 = pixel_8;
    _S411.sample_5 = sample_18;
    _S411.last_2 = last_7;
    return _S411;
}

fn work_of_0( index_30 : u32) -> Work_0
{
    var size_1 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S412 : u32 = size_1.x;
    var _S413 : u32 = u32(8) * _S412;
    var band_0 : u32 = index_30 / _S413;
    var _S414 : u32 = u32(8) * band_0;
    var in_band_0 : u32 = index_30 - _S413 * band_0;
    var _S415 : u32 = u32(8) * min(u32(8), size_1.y - _S414);
    var tile_0 : u32 = in_band_0 / _S415;
    var _S416 : u32 = u32(8) * tile_0;
    var _S417 : u32 = min(u32(8), _S412 - _S416);
    var in_tile_0 : u32 = in_band_0 - _S415 * tile_0;
    var _S418 : vec2<u32> = params_0.region_0.xy;
    var _S419 : u32 = in_tile_0 % _S417;
    var _S420 : u32 = _S416 + _S419;
    var _S421 : u32 = in_tile_0 / _S417;
    var at_8 : vec2<u32> = _S418 + vec2<u32>(_S420, _S414 + _S421);
    return Work_x24init_0(at_8.y * params_0.width_0 + at_8.x, pixels_0[place_of_0(at_8)].samples_0, min(dispatch_0.samples_target_0, pixels_0[place_of_0(at_8)].samples_0 + dispatch_0.samples_1));
}

fn Work_camera_rays_0( this_48 : Work_0) -> u32
{
    return max(this_48.last_2, this_48.sample_5) - this_48.sample_5;
}

fn tally_camera_rays_0( count_7 : u32)
{
    var _S422 : u32 = atomicAdd(&(group_counts_0[i32(0)]), count_7);
    return;
}

fn end_tally_0( counts_2 : RayCounts_0,  thread_1 : u32)
{
    var _S423 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_2.bounce_2);
    var _S424 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_2.shadow_0);
    workgroupBarrier();
    if(thread_1 < u32(3))
    {
        var _S425 : u32 = atomicLoad(&(group_counts_0[thread_1]));
        var _S426 : u32 = atomicAdd(&(counters_0[u32(1) + thread_1]), _S425);
    }
    if(thread_1 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S427 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

fn render_0( index_31 : u32,  thread_2 : u32)
{
    begin_tally_0(thread_2);
    var _S428 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_3 : RayCounts_0;
    if(index_31 < (dispatch_0.count_0))
    {
        var work_2 : Work_0 = work_of_0(dispatch_0.first_0 + index_31);
        tally_camera_rays_0(Work_camera_rays_0(work_2));
        var _S429 : RayCounts_0 = trace_pixel_0(work_2);
        counts_3 = _S429;
    }
    else
    {
        counts_3 = _S428;
    }
    end_tally_0(counts_3, thread_2);
    return;
}

fn render_1( index_32 : u32,  thread_3 : u32)
{
    begin_tally_0(thread_3);
    var _S430 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_4 : RayCounts_0;
    if(index_32 < (dispatch_0.count_0))
    {
        var work_3 : Work_0 = work_of_0(dispatch_0.first_0 + index_32);
        tally_camera_rays_0(Work_camera_rays_0(work_3));
        var _S431 : RayCounts_0 = trace_pixel_1(work_3);
        counts_4 = _S431;
    }
    else
    {
        counts_4 = _S430;
    }
    end_tally_0(counts_4, thread_3);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    is_page_missing_0 = false;
    render_1(id_0.x, thread_4);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_path(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_5 : u32)
{
    is_page_missing_0 = false;
    render_0(id_1.x, thread_5);
    return;
}

fn WalkTracer_trace_1( ray_25 : ptr<function, Ray_0>,  is_any_enough_2 : bool) -> Hit_0
{
    var _S432 : Hit_0 = visit_0(&((*ray_25)), is_any_enough_2, u32(0));
    return _S432;
}

struct HitRecord_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : array<i32, i32(3)>,
     face_0 : u32,
};

fn HitRecord_x24init_0( t_13 : f32,  instance_11 : u32,  voxel_21 : array<i32, i32(3)>,  face_8 : u32) -> HitRecord_0
{
    var _S433 : HitRecord_0;
    _S433.t_0 = t_13;
    _S433.instance_0 = instance_11;
    _S433.voxel_0 = voxel_21;
    _S433.face_0 = face_8;
    return _S433;
}

fn record_of_0( hit_8 : Hit_0) -> HitRecord_0
{
    var _S434 : array<i32, i32(3)> = array<i32, i32(3)>( hit_8.voxel_1.x, hit_8.voxel_1.y, hit_8.voxel_1.z );
    return HitRecord_x24init_0(hit_8.t_1, hit_8.instance_1, _S434, hit_8.face_1);
}

fn ray_of_0( _S435 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S435].origin_1), rays_0[_S435].t_min_0, vector_of_0(rays_0[_S435].direction_0), rays_0[_S435].t_max_0);
}

fn Transform_direction_2( _S436 : i32,  _S437 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S436].grid_from_world_0.x_axis_0) * vec3<f32>(_S437.x) + vector_of_0(instances_0[_S436].grid_from_world_0.y_axis_0) * vec3<f32>(_S437.y) + vector_of_0(instances_0[_S436].grid_from_world_0.z_axis_0) * vec3<f32>(_S437.z);
}

fn Transform_point_2( _S438 : i32,  _S439 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_2(_S438, _S439) + vector_of_0(instances_0[_S438].grid_from_world_0.translation_0);
}

fn local_ray_1( _S440 : Ray_0,  _S441 : i32) -> LocalRay_0
{
    var local_4 : LocalRay_0;
    var direction_30 : vec3<f32>;
    var origin_12 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S442 : vec3<f32> = Transform_point_2(_S441, _S440.origin_2);
        direction_30 = Transform_direction_2(_S441, _S440.direction_1);
        origin_12 = _S442;
    }
    else
    {
        direction_30 = _S440.direction_1;
        origin_12 = _S440.origin_2;
    }
    var is_zero_2 : vec3<bool> = !((abs(direction_30)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S443 : vec3<f32> = select(direction_30, vec3<f32>(0.0f), is_zero_2);
    local_4.direction_2 = _S443;
    local_4.inverse_0 = select(reciprocal_0(select(direction_30, vec3<f32>(1.0f), is_zero_2)), vec3<f32>(3.4028234663852886e+38f), is_zero_2);
    local_4.origin_3 = select(origin_12, floor(origin_12) + vec3<f32>(0.5f), is_zero_2);
    var speed_4 : f32 = max_element_0(abs(_S443));
    var moves_1 : bool;
    if(speed_4 >= 1.00000004581370497e-18f)
    {
        moves_1 = speed_4 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_1 = false;
    }
    var is_near_1 : bool = (all(((abs(local_4.origin_3)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_1 : bool;
    if((_S440.t_min_1) >= 0.0f)
    {
        is_segment_1 = (_S440.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_1 = false;
    }
    if(is_segment_1)
    {
        is_segment_1 = (_S440.t_min_1) <= (_S440.t_max_1);
    }
    else
    {
        is_segment_1 = false;
    }
    local_4.t_min_2 = _S440.t_min_1;
    local_4.t_max_2 = _S440.t_max_1;
    if(moves_1)
    {
        moves_1 = is_near_1;
    }
    else
    {
        moves_1 = false;
    }
    if(moves_1)
    {
        moves_1 = is_segment_1;
    }
    else
    {
        moves_1 = false;
    }
    local_4.is_valid_0 = moves_1;
    return local_4;
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_6 : u32)
{
    is_page_missing_0 = false;
    begin_tally_0(thread_6);
    var _S444 : u32 = id_2.x;
    if(_S444 < (dispatch_0.count_0))
    {
        tally_camera_rays_0(u32(1));
        var _S445 : Ray_0 = ray_of_0(dispatch_0.first_0 + _S444);
        var ray_26 : Ray_0 = _S445;
        var _S446 : Hit_0 = WalkTracer_trace_1(&(ray_26), false);
        var _S447 : bool;
        if(IS_SINGLE_0)
        {
            _S447 = !IS_EXACT_0;
        }
        else
        {
            _S447 = false;
        }
        if(_S447)
        {
            _S447 = !Hit_is_miss_0(_S446);
        }
        else
        {
            _S447 = false;
        }
        var hit_9 : Hit_0;
        if(_S447)
        {
            hit_9 = hit_of_0(local_ray_1(_S445, i32(0)), _S446.voxel_1, _S446.instance_1);
        }
        else
        {
            hit_9 = _S446;
        }
        var _S448 : HitRecord_0 = record_of_0(hit_9);
        hits_0[dispatch_0.first_0 + _S444].t_0 = _S448.t_0;
        hits_0[dispatch_0.first_0 + _S444].instance_0 = _S448.instance_0;
        hits_0[dispatch_0.first_0 + _S444].voxel_0 = _S448.voxel_0;
        hits_0[dispatch_0.first_0 + _S444].face_0 = _S448.face_0;
    }
    end_tally_0(RayCounts_x24init_0(u32(0), u32(0)), thread_6);
    return;
}

