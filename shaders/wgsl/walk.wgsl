struct FrameParams_std140_0
{
    @align(16) eye_0 : vec3<f32>,
    @align(4) width_0 : u32,
    @align(16) corner_0 : vec3<f32>,
    @align(4) height_0 : u32,
    @align(16) pixel_x_0 : vec3<f32>,
    @align(4) first_sample_0 : u32,
    @align(16) pixel_y_0 : vec3<f32>,
    @align(4) seed_0 : u32,
    @align(16) region_0 : vec4<u32>,
    @align(16) max_bounces_0 : u32,
    @align(4) is_transparent_0 : u32,
    @align(8) instance_count_0 : u32,
    @align(4) light_node_count_0 : u32,
    @align(16) sky_nadir_0 : vec3<f32>,
    @align(4) sky_brightness_0 : f32,
    @align(16) sky_zenith_0 : vec3<f32>,
    @align(4) light_intensity_0 : f32,
    @align(16) sun_direction_0 : vec3<f32>,
    @align(4) sun_depth_0 : f32,
    @align(16) sun_tangent_0 : vec3<f32>,
    @align(4) sun_sin_radius_0 : f32,
    @align(16) sun_bitangent_0 : vec3<f32>,
    @align(4) sun_irradiance_0 : f32,
    @align(16) sun_radiance_0 : vec3<f32>,
    @align(4) sun_pdf_0 : f32,
};

@binding(9) @group(0) var<uniform> params_0 : FrameParams_std140_0;
struct PixelRecord_std430_0
{
    @align(4) radiance_0 : array<u32, i32(6)>,
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

struct RayRecord_std430_0
{
    @align(4) origin_0 : array<f32, i32(3)>,
    @align(4) t_min_0 : f32,
    @align(4) direction_0 : array<f32, i32(3)>,
    @align(4) t_max_0 : f32,
};

@binding(11) @group(0) var<storage, read> rays_0 : array<RayRecord_std430_0>;

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
};

@binding(4) @group(0) var<storage, read> instances_0 : array<PackedInstance_std430_0>;

struct PackedGrid_std430_0
{
    @align(4) origin_1 : array<i32, i32(3)>,
    @align(4) top_shift_0 : u32,
    @align(4) top_size_0 : array<i32, i32(3)>,
    @align(4) top_offset_0 : u32,
    @align(4) min_0 : array<i32, i32(3)>,
    @align(4) voxels_0 : array<u32, i32(2)>,
    @align(4) max_0 : array<i32, i32(3)>,
    @align(4) material_bits_0 : u32,
};

@binding(3) @group(0) var<storage, read> grids_0 : array<PackedGrid_std430_0>;

@binding(0) @group(0) var<storage, read> cells_0 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

struct InstanceNode_std430_0
{
    @align(4) min_1 : array<f32, i32(3)>,
    @align(4) index_0 : u32,
    @align(4) max_1 : array<f32, i32(3)>,
    @align(4) is_leaf_0 : u32,
};

@binding(5) @group(0) var<storage, read> instance_nodes_0 : array<InstanceNode_std430_0>;

struct HitRecord_std430_0
{
    @align(4) t_0 : f32,
    @align(4) instance_0 : u32,
    @align(4) voxel_0 : array<i32, i32(3)>,
    @align(4) face_0 : u32,
};

@binding(12) @group(0) var<storage, read_write> hits_0 : array<HitRecord_std430_0>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

struct PackedMaterial_std430_0
{
    @align(4) base_color_0 : array<f32, i32(3)>,
    @align(4) roughness_0 : f32,
    @align(4) emission_0 : array<f32, i32(3)>,
    @align(4) metallic_0 : f32,
    @align(4) transmission_0 : f32,
    @align(4) ior_0 : f32,
};

@binding(6) @group(0) var<storage, read> materials_0 : array<PackedMaterial_std430_0>;

struct Emitter_std430_0
{
    @align(4) voxel_1 : array<i32, i32(3)>,
    @align(4) instance_1 : u32,
    @align(4) faces_0 : u32,
    @align(4) material_0 : u32,
    @align(4) luminance_0 : f32,
    @align(4) leaf_0 : u32,
};

@binding(7) @group(0) var<storage, read> emitters_0 : array<Emitter_std430_0>;

struct LightNode_std430_0
{
    @align(4) min_2 : array<f32, i32(3)>,
    @align(4) index_1 : u32,
    @align(4) max_2 : array<f32, i32(3)>,
    @align(4) count_1 : u32,
    @align(4) power_0 : array<f32, i32(6)>,
    @align(4) parent_0 : u32,
    @align(4) padding_1 : u32,
};

@binding(8) @group(0) var<storage, read> light_nodes_0 : array<LightNode_std430_0>;

struct Hit_0
{
     t_1 : f32,
     instance_2 : u32,
     voxel_2 : vec3<i32>,
     face_1 : u32,
};

struct Ray_0
{
     origin_2 : vec3<f32>,
     t_min_1 : f32,
     direction_1 : vec3<f32>,
     t_max_1 : f32,
};

struct LocalRay_0
{
     origin_3 : vec3<f32>,
     direction_2 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_2 : f32,
     t_max_2 : f32,
     is_valid_0 : bool,
};

@id(1) override IS_SINGLE_0 : bool = false;

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

fn is_normal_0( exponent_0 : i32) -> bool
{
    var _S5 : bool;
    if(exponent_0 > i32(0))
    {
        _S5 = exponent_0 < i32(255);
    }
    else
    {
        _S5 = false;
    }
    return _S5;
}

fn nearest_quotient_0( dividend_0 : u32,  divisor_0 : u32,  guess_0 : u32) -> u32
{
    var rest_0 : i32 = i32(((dividend_0 << (u32(23)))) - guess_0 * divisor_0);
    var units_0 : i32 = i32(floor(f32(rest_0) / f32(divisor_0) + 0.5f));
    var _S6 : i32 = i32(divisor_0);
    var _S7 : i32 = i32(2) * (rest_0 - units_0 * _S6);
    return guess_0 + u32(units_0 + (i32(_S7 > _S6) - i32(_S7 < (- _S6))));
}

fn divide_0( a_0 : f32,  b_0 : f32) -> f32
{
    var native_0 : f32 = a_0 / b_0;
    if(!IS_EXACT_0)
    {
        return native_0;
    }
    var _S8 : u32 = (bitcast<u32>((a_0)));
    var exponent_a_0 : i32 = i32((((_S8 >> (u32(23)))) & (u32(255))));
    var _S9 : u32 = (bitcast<u32>((b_0)));
    var exponent_b_0 : i32 = i32((((_S9 >> (u32(23)))) & (u32(255))));
    var dividend_1 : u32 = (((_S8 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S9 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : bool = dividend_1 < divisor_1;
    var dividend_2 : u32;
    if(is_below_0)
    {
        dividend_2 = (dividend_1 << (u32(1)));
    }
    else
    {
        dividend_2 = dividend_1;
    }
    var exponent_1 : i32 = exponent_a_0 - exponent_b_0 + i32(127) - i32(is_below_0);
    var _S10 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S10 = true;
    }
    else
    {
        _S10 = !is_normal_0(exponent_b_0);
    }
    if(_S10)
    {
        _S10 = true;
    }
    else
    {
        _S10 = !is_normal_0(exponent_1);
    }
    if(_S10)
    {
        return native_0;
    }
    return (bitcast<f32>(((((((_S8 ^ (_S9))) & (u32(2147483648)))) | ((((u32(exponent_1) << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) / f32(divisor_1) * 8.388608e+06f)) - u32(8388608))))))));
}

fn reciprocal_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_0.x), divide_0(1.0f, vector_0.y), divide_0(1.0f, vector_0.z));
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn local_ray_0( _S11 : Ray_0,  _S12 : u32) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_3 : vec3<f32>;
    var origin_4 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S13 : vec3<f32> = Transform_point_0(_S12, _S11.origin_2);
        direction_3 = Transform_direction_0(_S12, _S11.direction_1);
        origin_4 = _S13;
    }
    else
    {
        direction_3 = _S11.direction_1;
        origin_4 = _S11.origin_2;
    }
    var is_still_0 : vec3<bool> = !((abs(direction_3)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S14 : vec3<f32> = select(direction_3, vec3<f32>(0.0f), is_still_0);
    local_0.direction_2 = _S14;
    local_0.inverse_0 = select(reciprocal_0(select(direction_3, vec3<f32>(1.0f), is_still_0)), vec3<f32>(3.4028234663852886e+38f), is_still_0);
    local_0.origin_3 = select(origin_4, floor(origin_4) + vec3<f32>(0.5f), is_still_0);
    var speed_0 : f32 = max_element_0(abs(_S14));
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
    if((_S11.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S11.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S11.t_min_1) <= (_S11.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_2 = _S11.t_min_1;
    local_0.t_max_2 = _S11.t_max_1;
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
    var _S15 : Hit_0;
    _S15.t_1 = t_2;
    _S15.instance_2 = instance_3;
    _S15.voxel_2 = voxel_3;
    _S15.face_1 = face_2;
    return _S15;
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

fn slowest_0() -> f32
{
    var _S16 : f32;
    if(IS_EXACT_0)
    {
        _S16 = 0.0f;
    }
    else
    {
        _S16 = 1.00000004581370497e-18f;
    }
    return _S16;
}

fn LocalRay_tolerance_0( this_1 : LocalRay_0,  grid_min_0 : vec3<i32>,  grid_max_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_1.origin_3) + (vec3<f32>(max(abs(grid_min_0), abs(grid_max_0))) + vec3<f32>(1.0f))) * vec3<f32>(3.5762786865234375e-07f), vec3<f32>(-1.0f), (this_1.direction_2) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_2 : LocalRay_0) -> f32
{
    return min(this_2.t_max_2 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S17 : LocalRay_0,  _S18 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_0 = _S17;
    walk_0.grid_origin_0 = cell_of_0(grids_0[_S18].origin_1);
    var is_negative_0 : vec3<bool> = (_S17.direction_2) < vec3<f32>(0.0f);
    var _S19 : vec3<i32> = vec3<i32>(i32(0));
    walk_0.mirror_0 = select(_S19, vec3<i32>(i32(-1)), is_negative_0);
    var _S20 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S20 = Walk_mirrored_plane_0(walk_0, walk_0.grid_origin_0);
    }
    else
    {
        _S20 = _S19;
    }
    walk_0.offset_0 = _S20;
    var origin_6 : vec3<f32>;
    if(IS_EXACT_0)
    {
        origin_6 = _S17.origin_3;
    }
    else
    {
        origin_6 = _S17.origin_3 - vec3<f32>(walk_0.grid_origin_0);
    }
    walk_0.origin_5 = select(origin_6, (vec3<f32>(0) - origin_6), is_negative_0);
    walk_0.speed_1 = max(abs(_S17.direction_2), vec3<f32>(slowest_0()));
    if(IS_EXACT_0)
    {
        origin_6 = abs(_S17.inverse_0);
    }
    else
    {
        origin_6 = vec3<f32>(1.0f) / walk_0.speed_1;
    }
    walk_0.inverse_1 = origin_6;
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S17, cell_of_0(grids_0[_S18].min_0), cell_of_0(grids_0[_S18].max_0));
    walk_0.t_end_0 = LocalRay_t_end_0(_S17);
    return walk_0;
}

fn Walk_mirrored_0( this_3 : Walk_0,  voxel_4 : vec3<i32>) -> vec3<i32>
{
    return (voxel_4 ^ ((this_3.mirror_0)));
}

fn halves_0( value_0 : f32) -> vec2<f32>
{
    var high_0 : f32 = (bitcast<f32>((((bitcast<u32>((value_0))) & (u32(4294963200))))));
    return vec2<f32>(high_0, value_0 - high_0);
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
    var _S21 : f32 = a_parts_0.x;
    var _S22 : f32 = b_parts_0.x;
    var _S23 : f32 = b_parts_0.y;
    var _S24 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S21 * _S22 - product_0 + _S21 * _S23 + _S24 * _S22 + _S24 * _S23);
}

fn exact_start_voxel_0( ray_1 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(0)]);
    var _S25 : f32 = way_0.x;
    var sum_0 : f32 = ray_1.origin_3[u32(0)] + _S25;
    var part_0 : f32 = sum_0 - ray_1.origin_3[u32(0)];
    var low_0 : f32 = ray_1.origin_3[u32(0)] - (sum_0 - part_0) + (_S25 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_5 : vec3<i32>;
    var _S26 : i32 = i32(whole_0);
    var _S27 : bool;
    if(sum_0 == whole_0)
    {
        _S27 = low_0 < 0.0f;
    }
    else
    {
        _S27 = false;
    }
    voxel_5[u32(0)] = _S26 - i32(_S27);
    var way_1 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(1)]);
    var _S28 : f32 = way_1.x;
    var sum_1 : f32 = ray_1.origin_3[u32(1)] + _S28;
    var part_1 : f32 = sum_1 - ray_1.origin_3[u32(1)];
    var low_1 : f32 = ray_1.origin_3[u32(1)] - (sum_1 - part_1) + (_S28 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_1);
    var _S29 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S27 = low_1 < 0.0f;
    }
    else
    {
        _S27 = false;
    }
    voxel_5[u32(1)] = _S29 - i32(_S27);
    var way_2 : vec2<f32> = exact_product_0(ray_1.t_min_2, ray_1.direction_2[u32(2)]);
    var _S30 : f32 = way_2.x;
    var sum_2 : f32 = ray_1.origin_3[u32(2)] + _S30;
    var part_2 : f32 = sum_2 - ray_1.origin_3[u32(2)];
    var low_2 : f32 = ray_1.origin_3[u32(2)] - (sum_2 - part_2) + (_S30 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_2);
    var _S31 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S27 = low_2 < 0.0f;
    }
    else
    {
        _S27 = false;
    }
    voxel_5[u32(2)] = _S31 - i32(_S27);
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
    var _S32 : bool;
    if((this_4.ray_0.t_min_2) > 0.0f)
    {
        _S32 = (any(((abs(from_nearest_0)) <= (this_4.tolerance_0))));
    }
    else
    {
        _S32 = false;
    }
    if(_S32)
    {
        return Walk_mirrored_0(this_4, exact_start_voxel_0(this_4.ray_0) - this_4.grid_origin_0);
    }
    return Walk_mirrored_0(this_4, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_4.grid_origin_0);
}

fn Walk_crossings_0( this_5 : Walk_0,  planes_0 : vec3<i32>) -> vec3<f32>
{
    return (vec3<f32>(planes_0 + this_5.offset_0) - this_5.origin_5) * this_5.inverse_1;
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
    var _S33 : Crossing_0;
    _S33.distance_0 = distance_1;
    _S33.distance_low_0 = distance_low_1;
    _S33.speed_2 = speed_3;
    _S33.axis_0 = axis_1;
    return _S33;
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
    var _S34 : bool;
    if(difference_1 < 0.0f)
    {
        _S34 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S34 = (this_6.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S34 = false;
        }
    }
    return _S34;
}

fn leave_box_0( ray_3 : LocalRay_0,  voxel_6 : vec3<i32>,  exit_0 : vec3<i32>,  guess_1 : vec3<i32>) -> vec3<i32>
{
    var _S35 : vec3<f32>;
    var _S36 : f32;
    var _S37 : bool;
    var _S38 : bool;
    var first_1 : Crossing_0;
    var _S39 : f32;
    var _S40 : bool;
    var _S41 : f32;
    var _S42 : bool;
    var _S43 : bool;
    var _S44 : i32;
    var cell_0 : i32;
    var i_0 : u32;
    var _S45 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S35 = ray_3.direction_2;
                _S36 = ray_3.direction_2[u32(0)];
                var _S46 : bool = (ray_3.direction_2[u32(0)]) == 0.0f;
                _S37 = _S46;
                if(_S46)
                {
                    first_1 = _S45;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_3, u32(0), exit_0[u32(0)]);
                if((_S45.axis_0) == u32(3))
                {
                    _S38 = true;
                }
                else
                {
                    _S38 = Crossing_is_before_0(crossing_0, _S45);
                }
                if(_S38)
                {
                    first_1 = crossing_0;
                }
                else
                {
                    first_1 = _S45;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S39 = _S35[u32(1)];
                var _S47 : bool = (_S35[u32(1)]) == 0.0f;
                _S40 = _S47;
                if(_S47)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_3, u32(1), exit_0[u32(1)]);
                if((first_1.axis_0) == u32(3))
                {
                    _S38 = true;
                }
                else
                {
                    _S38 = Crossing_is_before_0(crossing_1, first_1);
                }
                if(_S38)
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
                _S41 = _S35[u32(2)];
                var _S48 : bool = (_S35[u32(2)]) == 0.0f;
                _S42 = _S48;
                if(_S48)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_3, u32(2), exit_0[u32(2)]);
                if((first_1.axis_0) == u32(3))
                {
                    _S38 = true;
                }
                else
                {
                    _S38 = Crossing_is_before_0(crossing_2, first_1);
                }
                if(_S38)
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
                if(_S37)
                {
                    break;
                }
                var is_negative_1 : bool = _S36 < 0.0f;
                if(u32(0) == (first_1.axis_0))
                {
                    arrival_0[u32(0)] = exit_0[u32(0)] - i32(is_negative_1);
                    break;
                }
                if(is_negative_1)
                {
                    _S44 = i32(-1);
                }
                else
                {
                    _S44 = i32(1);
                }
                if(is_negative_1)
                {
                    cell_0 = min(guess_1[u32(0)], voxel_6[u32(0)]);
                }
                else
                {
                    cell_0 = max(guess_1[u32(0)], voxel_6[u32(0)]);
                }
                var _S49 : i32 = i32(is_negative_1);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = cell_0 != (voxel_6[u32(0)]);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                        _S43 = !Crossing_is_before_0(crossing_of_0(ray_3, u32(0), cell_0 + _S49), first_1);
                    }
                    else
                    {
                        _S43 = false;
                    }
                    if(_S43)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_1 : i32 = cell_0 - _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_1;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = Crossing_is_before_0(crossing_of_0(ray_3, u32(0), cell_0 + _S44 + _S49), first_1);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_2 : i32 = cell_0 + _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_2;
                }
                arrival_0[u32(0)] = cell_0;
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
                var is_negative_2 : bool = _S39 < 0.0f;
                if(u32(1) == (first_1.axis_0))
                {
                    arrival_0[u32(1)] = exit_0[u32(1)] - i32(is_negative_2);
                    break;
                }
                if(is_negative_2)
                {
                    _S44 = i32(-1);
                }
                else
                {
                    _S44 = i32(1);
                }
                if(is_negative_2)
                {
                    cell_0 = min(guess_1[u32(1)], voxel_6[u32(1)]);
                }
                else
                {
                    cell_0 = max(guess_1[u32(1)], voxel_6[u32(1)]);
                }
                var _S50 : i32 = i32(is_negative_2);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = cell_0 != (voxel_6[u32(1)]);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                        _S43 = !Crossing_is_before_0(crossing_of_0(ray_3, u32(1), cell_0 + _S50), first_1);
                    }
                    else
                    {
                        _S43 = false;
                    }
                    if(_S43)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_3 : i32 = cell_0 - _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_3;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = Crossing_is_before_0(crossing_of_0(ray_3, u32(1), cell_0 + _S44 + _S50), first_1);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_4 : i32 = cell_0 + _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_4;
                }
                arrival_0[u32(1)] = cell_0;
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
                var is_negative_3 : bool = _S41 < 0.0f;
                if(u32(2) == (first_1.axis_0))
                {
                    arrival_0[u32(2)] = exit_0[u32(2)] - i32(is_negative_3);
                    break;
                }
                if(is_negative_3)
                {
                    _S44 = i32(-1);
                }
                else
                {
                    _S44 = i32(1);
                }
                if(is_negative_3)
                {
                    cell_0 = min(guess_1[u32(2)], voxel_6[u32(2)]);
                }
                else
                {
                    cell_0 = max(guess_1[u32(2)], voxel_6[u32(2)]);
                }
                var _S51 : i32 = i32(is_negative_3);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = cell_0 != (voxel_6[u32(2)]);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                        _S43 = !Crossing_is_before_0(crossing_of_0(ray_3, u32(2), cell_0 + _S51), first_1);
                    }
                    else
                    {
                        _S43 = false;
                    }
                    if(_S43)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_5 : i32 = cell_0 - _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_5;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S38 = Crossing_is_before_0(crossing_of_0(ray_3, u32(2), cell_0 + _S44 + _S51), first_1);
                    }
                    else
                    {
                        _S38 = false;
                    }
                    if(_S38)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_6 : i32 = cell_0 + _S44;
                    i_0 = i_0 + u32(1);
                    cell_0 = cell_6;
                }
                arrival_0[u32(2)] = cell_0;
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
        var nearest_1 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_1;
        var cell_7 : vec3<i32> = vec3<i32>(nearest_1) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f));
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_0, (abs(from_nearest_1)) <= (this_7.tolerance_0)))))))
        {
            return Walk_mirrored_0(this_7, leave_box_0(this_7.ray_0, Walk_mirrored_0(this_7, voxel_7) + this_7.grid_origin_0, Walk_mirrored_plane_0(this_7, exit_1) + this_7.grid_origin_0, Walk_mirrored_0(this_7, cell_7)) - this_7.grid_origin_0);
        }
        return select(cell_7 - this_7.offset_0, exit_1, is_axis_0);
    }
    return max(vec3<i32>(floor(position_0)), select(voxel_7, exit_1, is_axis_0));
}

fn Walk_enter_0( this_8 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  low_3 : vec3<i32>,  high_1 : vec3<i32>) -> bool
{
    var is_mirrored_0 : vec3<bool> = (this_8.mirror_0) != vec3<i32>(i32(0));
    var _S52 : vec3<i32> = select(low_3, (vec3<i32>(0) - high_1), is_mirrored_0);
    var far_0 : vec3<i32> = select(high_1, (vec3<i32>(0) - low_3), is_mirrored_0);
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_8) < _S52;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_8.speed_1) <= vec3<f32>(slowest_0()), is_before_0)))))
        {
            return false;
        }
        var t_4 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_8, _S52), is_before_0);
        var t_last_0 : f32 = max_element_0(t_4);
        if(t_last_0 > (this_8.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_4.x) == t_last_0;
        var _S53 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S53)
        {
            is_y_0 = (t_4.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S54 : bool;
        if(_S53)
        {
            _S54 = !is_y_0;
        }
        else
        {
            _S54 = false;
        }
        var is_axis_1 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S54);
        (*voxel_8) = Walk_arrive_0(this_8, (*voxel_8), t_last_0, is_axis_1, select(vec3<i32>(i32(1073741823)), _S52, is_axis_1));
    }
    return (all(((*voxel_8) < far_0)));
}

fn LocalRay_octant_0( this_9 : LocalRay_0) -> u32
{
    return (((u32((this_9.direction_2.x) < 0.0f) | (((u32((this_9.direction_2.y) < 0.0f) << (u32(1))))))) | (((u32((this_9.direction_2.z) < 0.0f) << (u32(2))))));
}

fn flip_of_0( octant_0 : u32) -> u32
{
    return ((((((octant_0 & (u32(1)))) | (((((octant_0 & (u32(2)))) << (u32(1))))))) | (((((octant_0 & (u32(4)))) << (u32(2))))))) * u32(3);
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

fn dot_cells_0( a_2 : vec3<i32>,  b_2 : vec3<i32>) -> i32
{
    return a_2.x * b_2.x + a_2.y * b_2.y + a_2.z * b_2.z;
}

fn ahead_of_0( mirror_1 : vec3<i32>) -> u32
{
    var bits_0 : vec3<u32> = (vec3<u32>(~mirror_1) & (vec3<u32>(u32(31), u32(992), u32(31744))));
    return ((((bits_0.x) | ((bits_0.y)))) | ((bits_0.z)));
}

fn min_element_0( vector_2 : vec3<f32>) -> f32
{
    return min(min(vector_2.x, vector_2.y), vector_2.z);
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_8 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_8.x) | ((((cell_8.y) << (u32(2))))))) | ((((cell_8.z) << (u32(4))))));
}

fn extents_0( cell_9 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_9 & (ahead_0))) | (((((cell_9 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_10 : u32) -> u32
{
    var _S55 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S55 = u32(8388607);
    }
    else
    {
        _S55 = u32(2147483647);
    }
    return ((cell_10 & (_S55))) * u32(2);
}

fn blocks_of_cell_0( cell_11 : u32) -> u32
{
    return (((cell_11 >> (u32(23)))) & (u32(255)));
}

fn blocks_of_record_0( record_0 : u32) -> u32
{
    return (bricks_0[record_0] & (u32(255)));
}

fn empty_around_0( record_1 : u32,  blocks_0 : u32,  voxel_9 : vec3<i32>,  octant_1 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_9.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_9.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_9.z) & (i32(4))))))) ^ (octant_1));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_0 : u32 = ((cell_in_node_0(voxel_9, u32(0))) ^ (flip_0));
    var half_0 : u32 = bricks_0[record_1 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_0 >> (u32(5))))];
    if(((((half_0 >> (((bit_0 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S56 : i32;
    if(((((half_0 >> (((bit_0 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S56 = i32(1);
    }
    else
    {
        _S56 = i32(0);
    }
    return u32(_S56);
}

fn Walk_leave_rounded_0( this_10 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_5 : vec3<f32> = Walk_crossings_0(this_10, exit_2);
    var t_first_0 : f32 = min_element_0(t_5);
    if(t_first_0 >= (this_10.t_end_0))
    {
        return false;
    }
    (*voxel_10) = max(exit_2 - vec3<i32>(ceil((t_5 - vec3<f32>(t_first_0)) * this_10.speed_1)), (*voxel_10));
    return true;
}

fn Walk_leave_0( this_11 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S57 : bool = Walk_leave_rounded_0(this_11, &((*voxel_11)), exit_3);
        return _S57;
    }
    var t_6 : vec3<f32> = Walk_crossings_0(this_11, exit_3);
    var t_first_1 : f32 = min_element_0(t_6);
    if(t_first_1 > (this_11.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = (t_6.x) == t_first_1;
    var _S58 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S58)
    {
        is_y_1 = (t_6.y) == t_first_1;
    }
    else
    {
        is_y_1 = false;
    }
    var _S59 : vec3<i32> = (*voxel_11);
    var _S60 : bool;
    if(_S58)
    {
        _S60 = !is_y_1;
    }
    else
    {
        _S60 = false;
    }
    (*voxel_11) = Walk_arrive_0(this_11, _S59, t_first_1, vec3<bool>(is_x_1, is_y_1, _S60), exit_3);
    return true;
}

fn first_voxel_0( _S61 : u32,  _S62 : Walk_0,  _S63 : ptr<function, vec3<i32>>) -> bool
{
    var _S64 : Walk_0 = _S62;
    var _S65 : vec3<i32> = vec3<i32>(i32(0));
    (*_S63) = _S65;
    var voxel_12 : vec3<i32> = Walk_start_voxel_0(_S62);
    var _S66 : bool = Walk_enter_0(_S62, &(voxel_12), cell_of_0(grids_0[_S61].min_0) - _S64.grid_origin_0, cell_of_0(grids_0[_S61].max_0) - _S64.grid_origin_0);
    if(!_S66)
    {
        return false;
    }
    var octant_2 : u32 = LocalRay_octant_0(_S64.ray_0);
    var _S67 : u32 = flip_of_0(octant_2);
    var top_shift_1 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_1 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_1 = grids_0[_S61].top_shift_0;
    }
    var top_size_1 : vec3<i32> = cell_of_0(grids_0[_S61].top_size_0);
    var _S68 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S68, _S68 * top_size_1.y);
    var _S69 : i32 = i32(grids_0[_S61].top_offset_0) - dot_cells_0((stride_0 & ((_S64.mirror_0))), vec3<i32>(i32(1)));
    var _S70 : vec3<i32> = Walk_mirrored_plane_0(_S64, stride_0);
    var _S71 : u32 = ahead_of_0(_S64.mirror_0);
    var end_0 : vec3<i32> = select((top_size_1 << (vec3<u32>(top_shift_1))), _S65, (_S64.mirror_0) != _S65);
    if(!IS_EXACT_0)
    {
        _S64.t_end_0 = min(_S64.t_end_0, min_element_0(Walk_crossings_0(_S64, end_0)));
    }
    var is_found_0 : bool = false;
    for(;;)
    {
        var _S72 : bool;
        if(IS_EXACT_0)
        {
            _S72 = (any((voxel_12 >= end_0)));
        }
        else
        {
            _S72 = false;
        }
        if(_S72)
        {
            break;
        }
        var cell_12 : u32 = cells_0[_S69 + dot_cells_0(_S70, (voxel_12 >> (vec3<u32>(top_shift_1))))];
        var cell_13 : u32;
        var shift_1 : u32;
        var is_found_1 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_12 & (u32(2147483648)))) != u32(0))
            {
                cell_13 = cells_0[((cell_12 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_12, u32(3))) ^ (_S67)))];
                shift_1 = u32(3);
            }
            else
            {
                cell_13 = cell_12;
                shift_1 = top_shift_1;
            }
        }
        else
        {
            cell_13 = cell_12;
            shift_1 = top_shift_1;
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
                var _S73 : bool;
                if(is_found_1)
                {
                    _S73 = ((cell_13 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S73 = false;
                }
                if(_S73)
                {
                }
                else
                {
                    break;
                }
                var shift_2 : u32 = shift_1 - u32(2);
                cell_13 = cells_0[((cell_13 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_12, shift_2)) ^ (_S67)))];
                shift_1 = shift_2;
            }
        }
        var exit_4 : vec3<i32>;
        if(((cell_13 & (u32(2147483648)))) == u32(0))
        {
            exit_4 = ((voxel_12 | (vec3<i32>((((i32(1) << (shift_1))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_13, _S71)) << (vec3<u32>(shift_1))));
            is_found_1 = is_found_0;
        }
        else
        {
            var record_2 : u32 = record_of_cell_0(cell_13);
            var blocks_1 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_1 = blocks_of_cell_0(cell_13);
            }
            else
            {
                blocks_1 = blocks_of_record_0(record_2);
            }
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_12, octant_2, _S67);
            var is_found_2 : bool = low_bits_0 == u32(4294967295);
            if(is_found_2)
            {
                is_found_0 = is_found_2;
                break;
            }
            exit_4 = ((voxel_12 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_1 = is_found_2;
        }
        var _S74 : bool = Walk_leave_0(_S64, &(voxel_12), exit_4);
        if(!_S74)
        {
            is_found_0 = is_found_1;
            break;
        }
        is_found_0 = is_found_1;
    }
    (*_S63) = Walk_mirrored_0(_S64, voxel_12) + _S64.grid_origin_0;
    return is_found_0;
}

fn Ray_x24init_0( origin_7 : vec3<f32>,  t_min_3 : f32,  direction_4 : vec3<f32>,  t_max_3 : f32) -> Ray_0
{
    var _S75 : Ray_0;
    _S75.origin_2 = origin_7;
    _S75.t_min_1 = t_min_3;
    _S75.direction_1 = direction_4;
    _S75.t_max_1 = t_max_3;
    return _S75;
}

fn ray_of_walk_0( walk_1 : Walk_0,  ray_4 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (walk_1.mirror_0) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_1.origin_5, (vec3<f32>(0) - walk_1.origin_5), is_mirrored_1) + vec3<f32>(walk_1.grid_origin_0), ray_4.t_min_1, select(walk_1.speed_1, (vec3<f32>(0) - walk_1.speed_1), is_mirrored_1), ray_4.t_max_1);
}

fn hit_of_0( ray_5 : LocalRay_0,  voxel_13 : vec3<i32>,  instance_4 : u32) -> Hit_0
{
    var _S76 : vec3<f32>;
    var _S77 : bool;
    var last_0 : Crossing_0;
    var _S78 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S76 = ray_5.direction_2;
                if((ray_5.direction_2[u32(0)]) == 0.0f)
                {
                    last_0 = _S78;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_5, u32(0), voxel_13[u32(0)] + i32((ray_5.direction_2[u32(0)]) < 0.0f));
                if((_S78.axis_0) == u32(3))
                {
                    _S77 = true;
                }
                else
                {
                    _S77 = !Crossing_is_before_0(crossing_3, _S78);
                }
                if(_S77)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S78;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S79 : vec3<f32> = _S76;
                if((_S76[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_5, u32(1), voxel_13[u32(1)] + i32((_S79[u32(1)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S77 = true;
                }
                else
                {
                    _S77 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S77)
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
                var _S80 : vec3<f32> = _S76;
                if((_S76[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_5, u32(2), voxel_13[u32(2)] + i32((_S80[u32(2)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S77 = true;
                }
                else
                {
                    _S77 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S77)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S81 : Crossing_0 = last_0;
    var is_negative_4 : bool = (_S76[last_0.axis_0]) < 0.0f;
    var t_7 : f32 = (f32(voxel_13[last_0.axis_0] + i32(is_negative_4)) - ray_5.origin_3[last_0.axis_0]) * ray_5.inverse_0[last_0.axis_0];
    var _S82 : f32;
    if(t_7 > (ray_5.t_min_2))
    {
        _S82 = t_7;
    }
    else
    {
        _S82 = ray_5.t_min_2;
    }
    return Hit_x24init_0(_S82, instance_4, voxel_13, u32(2) * _S81.axis_0 + u32(is_negative_4));
}

fn hit_of_walk_0( walk_2 : Walk_0,  voxel_14 : vec3<i32>,  instance_5 : u32) -> Hit_0
{
    var t_8 : vec3<f32> = Walk_crossings_0(walk_2, Walk_mirrored_0(walk_2, voxel_14 - walk_2.grid_origin_0));
    var last_1 : f32 = max_element_0(t_8);
    var _S83 : i32;
    if((t_8.z) == last_1)
    {
        _S83 = i32(2);
    }
    else
    {
        if((t_8.y) == last_1)
        {
            _S83 = i32(1);
        }
        else
        {
            _S83 = i32(0);
        }
    }
    var axis_3 : u32 = u32(_S83);
    return Hit_x24init_0(max(last_1, walk_2.ray_0.t_min_2), instance_5, voxel_14, u32(2) * axis_3 + u32((walk_2.mirror_0[axis_3]) != i32(0)));
}

fn hit_in_0( instance_6 : u32,  ray_6 : ptr<function, Ray_0>) -> Hit_0
{
    var _S84 : LocalRay_0 = local_ray_0((*ray_6), instance_6);
    if(!_S84.is_valid_0)
    {
        return miss_0();
    }
    var _S85 : Walk_0 = walk_of_0(_S84, instances_0[instance_6].grid_0);
    var voxel_15 : vec3<i32>;
    var _S86 : bool = first_voxel_0(instances_0[instance_6].grid_0, _S85, &(voxel_15));
    var _S87 : bool;
    if(IS_SINGLE_0)
    {
        _S87 = !IS_EXACT_0;
    }
    else
    {
        _S87 = false;
    }
    if(_S87)
    {
        (*ray_6) = ray_of_walk_0(_S85, (*ray_6));
    }
    if(!_S86)
    {
        return miss_0();
    }
    var hit_0 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_0 = hit_of_0(_S84, voxel_15, instance_6);
    }
    else
    {
        hit_0 = hit_of_walk_0(_S85, voxel_15, instance_6);
    }
    if((hit_0.t_1) > ((*ray_6).t_max_1))
    {
        return miss_0();
    }
    return hit_0;
}

fn Walk_enter_1( this_12 : Walk_0,  voxel_16 : ptr<function, vec3<i32>>,  low_4 : vec3<i32>,  high_2 : vec3<i32>) -> bool
{
    var is_mirrored_2 : vec3<bool> = (this_12.mirror_0) != vec3<i32>(i32(0));
    var _S88 : vec3<i32> = select(low_4, (vec3<i32>(0) - high_2), is_mirrored_2);
    var far_1 : vec3<i32> = select(high_2, (vec3<i32>(0) - low_4), is_mirrored_2);
    for(;;)
    {
        var is_before_1 : vec3<bool> = (*voxel_16) < _S88;
        if(!(any((is_before_1))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_12.speed_1) <= vec3<f32>(slowest_0()), is_before_1)))))
        {
            return false;
        }
        var t_9 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_12, _S88), is_before_1);
        var t_last_1 : f32 = max_element_0(t_9);
        if(t_last_1 > (this_12.t_end_0))
        {
            return false;
        }
        var is_x_2 : bool = (t_9.x) == t_last_1;
        var _S89 : bool = !is_x_2;
        var is_y_2 : bool;
        if(_S89)
        {
            is_y_2 = (t_9.y) == t_last_1;
        }
        else
        {
            is_y_2 = false;
        }
        var _S90 : bool;
        if(_S89)
        {
            _S90 = !is_y_2;
        }
        else
        {
            _S90 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_2, is_y_2, _S90);
        (*voxel_16) = Walk_arrive_0(this_12, (*voxel_16), t_last_1, is_axis_2, select(vec3<i32>(i32(1073741823)), _S88, is_axis_2));
    }
    return (all(((*voxel_16) < far_1)));
}

fn Walk_leave_rounded_1( this_13 : Walk_0,  voxel_17 : ptr<function, vec3<i32>>,  exit_5 : vec3<i32>) -> bool
{
    var t_10 : vec3<f32> = Walk_crossings_0(this_13, exit_5);
    var t_first_2 : f32 = min_element_0(t_10);
    if(t_first_2 >= (this_13.t_end_0))
    {
        return false;
    }
    (*voxel_17) = max(exit_5 - vec3<i32>(ceil((t_10 - vec3<f32>(t_first_2)) * this_13.speed_1)), (*voxel_17));
    return true;
}

fn Walk_leave_1( this_14 : Walk_0,  voxel_18 : ptr<function, vec3<i32>>,  exit_6 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S91 : bool = Walk_leave_rounded_1(this_14, &((*voxel_18)), exit_6);
        return _S91;
    }
    var t_11 : vec3<f32> = Walk_crossings_0(this_14, exit_6);
    var t_first_3 : f32 = min_element_0(t_11);
    if(t_first_3 > (this_14.t_end_0))
    {
        return false;
    }
    var is_x_3 : bool = (t_11.x) == t_first_3;
    var _S92 : bool = !is_x_3;
    var is_y_3 : bool;
    if(_S92)
    {
        is_y_3 = (t_11.y) == t_first_3;
    }
    else
    {
        is_y_3 = false;
    }
    var _S93 : vec3<i32> = (*voxel_18);
    var _S94 : bool;
    if(_S92)
    {
        _S94 = !is_y_3;
    }
    else
    {
        _S94 = false;
    }
    (*voxel_18) = Walk_arrive_0(this_14, _S93, t_first_3, vec3<bool>(is_x_3, is_y_3, _S94), exit_6);
    return true;
}

fn first_voxel_1( _S95 : u32,  _S96 : Walk_0,  _S97 : ptr<function, vec3<i32>>) -> bool
{
    var _S98 : Walk_0 = _S96;
    var _S99 : vec3<i32> = vec3<i32>(i32(0));
    (*_S97) = _S99;
    var voxel_19 : vec3<i32> = Walk_start_voxel_0(_S96);
    var _S100 : bool = Walk_enter_1(_S96, &(voxel_19), cell_of_0(grids_0[_S95].min_0) - _S98.grid_origin_0, cell_of_0(grids_0[_S95].max_0) - _S98.grid_origin_0);
    if(!_S100)
    {
        return false;
    }
    var octant_3 : u32 = LocalRay_octant_0(_S98.ray_0);
    var _S101 : u32 = flip_of_0(octant_3);
    var top_shift_2 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_2 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_2 = grids_0[_S95].top_shift_0;
    }
    var top_size_2 : vec3<i32> = cell_of_0(grids_0[_S95].top_size_0);
    var _S102 : i32 = top_size_2.x;
    var stride_1 : vec3<i32> = vec3<i32>(i32(1), _S102, _S102 * top_size_2.y);
    var _S103 : i32 = i32(grids_0[_S95].top_offset_0) - dot_cells_0((stride_1 & ((_S98.mirror_0))), vec3<i32>(i32(1)));
    var _S104 : vec3<i32> = Walk_mirrored_plane_0(_S98, stride_1);
    var _S105 : u32 = ahead_of_0(_S98.mirror_0);
    var end_1 : vec3<i32> = select((top_size_2 << (vec3<u32>(top_shift_2))), _S99, (_S98.mirror_0) != _S99);
    if(!IS_EXACT_0)
    {
        _S98.t_end_0 = min(_S98.t_end_0, min_element_0(Walk_crossings_0(_S98, end_1)));
    }
    var is_found_3 : bool = false;
    for(;;)
    {
        var _S106 : bool;
        if(IS_EXACT_0)
        {
            _S106 = (any((voxel_19 >= end_1)));
        }
        else
        {
            _S106 = false;
        }
        if(_S106)
        {
            break;
        }
        var cell_14 : u32 = cells_0[_S103 + dot_cells_0(_S104, (voxel_19 >> (vec3<u32>(top_shift_2))))];
        var cell_15 : u32;
        var shift_3 : u32;
        var is_found_4 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_14 & (u32(2147483648)))) != u32(0))
            {
                cell_15 = cells_0[((cell_14 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_19, u32(3))) ^ (_S101)))];
                shift_3 = u32(3);
            }
            else
            {
                cell_15 = cell_14;
                shift_3 = top_shift_2;
            }
        }
        else
        {
            cell_15 = cell_14;
            shift_3 = top_shift_2;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_4 = shift_3 > u32(3);
                }
                else
                {
                    is_found_4 = false;
                }
                var _S107 : bool;
                if(is_found_4)
                {
                    _S107 = ((cell_15 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S107 = false;
                }
                if(_S107)
                {
                }
                else
                {
                    break;
                }
                var shift_4 : u32 = shift_3 - u32(2);
                cell_15 = cells_0[((cell_15 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_19, shift_4)) ^ (_S101)))];
                shift_3 = shift_4;
            }
        }
        var exit_7 : vec3<i32>;
        if(((cell_15 & (u32(2147483648)))) == u32(0))
        {
            exit_7 = ((voxel_19 | (vec3<i32>((((i32(1) << (shift_3))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_15, _S105)) << (vec3<u32>(shift_3))));
            is_found_4 = is_found_3;
        }
        else
        {
            var record_3 : u32 = record_of_cell_0(cell_15);
            var blocks_2 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_2 = blocks_of_cell_0(cell_15);
            }
            else
            {
                blocks_2 = blocks_of_record_0(record_3);
            }
            var low_bits_1 : u32 = empty_around_0(record_3, blocks_2, voxel_19, octant_3, _S101);
            var is_found_5 : bool = low_bits_1 == u32(4294967295);
            if(is_found_5)
            {
                is_found_3 = is_found_5;
                break;
            }
            exit_7 = ((voxel_19 | (vec3<i32>(i32(low_bits_1))))) + vec3<i32>(i32(1));
            is_found_4 = is_found_5;
        }
        var _S108 : bool = Walk_leave_1(_S98, &(voxel_19), exit_7);
        if(!_S108)
        {
            is_found_3 = is_found_4;
            break;
        }
        is_found_3 = is_found_4;
    }
    (*_S97) = Walk_mirrored_0(_S98, voxel_19) + _S98.grid_origin_0;
    return is_found_3;
}

fn hit_in_1( instance_7 : u32,  ray_7 : ptr<function, Ray_0>) -> Hit_0
{
    var _S109 : LocalRay_0 = local_ray_0((*ray_7), instance_7);
    if(!_S109.is_valid_0)
    {
        return miss_0();
    }
    var _S110 : Walk_0 = walk_of_0(_S109, instances_0[instance_7].grid_0);
    var voxel_20 : vec3<i32>;
    var _S111 : bool = first_voxel_1(instances_0[instance_7].grid_0, _S110, &(voxel_20));
    var _S112 : bool;
    if(IS_SINGLE_0)
    {
        _S112 = !IS_EXACT_0;
    }
    else
    {
        _S112 = false;
    }
    if(_S112)
    {
        (*ray_7) = ray_of_walk_0(_S110, (*ray_7));
    }
    if(!_S111)
    {
        return miss_0();
    }
    var hit_1 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_1 = hit_of_0(_S109, voxel_20, instance_7);
    }
    else
    {
        hit_1 = hit_of_walk_0(_S110, voxel_20, instance_7);
    }
    if((hit_1.t_1) > ((*ray_7).t_max_1))
    {
        return miss_0();
    }
    return hit_1;
}

fn Walk_enter_2( this_15 : Walk_0,  voxel_21 : ptr<function, vec3<i32>>,  low_5 : vec3<i32>,  high_3 : vec3<i32>) -> bool
{
    var is_mirrored_3 : vec3<bool> = (this_15.mirror_0) != vec3<i32>(i32(0));
    var _S113 : vec3<i32> = select(low_5, (vec3<i32>(0) - high_3), is_mirrored_3);
    var far_2 : vec3<i32> = select(high_3, (vec3<i32>(0) - low_5), is_mirrored_3);
    for(;;)
    {
        var is_before_2 : vec3<bool> = (*voxel_21) < _S113;
        if(!(any((is_before_2))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_15.speed_1) <= vec3<f32>(slowest_0()), is_before_2)))))
        {
            return false;
        }
        var t_12 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_15, _S113), is_before_2);
        var t_last_2 : f32 = max_element_0(t_12);
        if(t_last_2 > (this_15.t_end_0))
        {
            return false;
        }
        var is_x_4 : bool = (t_12.x) == t_last_2;
        var _S114 : bool = !is_x_4;
        var is_y_4 : bool;
        if(_S114)
        {
            is_y_4 = (t_12.y) == t_last_2;
        }
        else
        {
            is_y_4 = false;
        }
        var _S115 : bool;
        if(_S114)
        {
            _S115 = !is_y_4;
        }
        else
        {
            _S115 = false;
        }
        var is_axis_3 : vec3<bool> = vec3<bool>(is_x_4, is_y_4, _S115);
        (*voxel_21) = Walk_arrive_0(this_15, (*voxel_21), t_last_2, is_axis_3, select(vec3<i32>(i32(1073741823)), _S113, is_axis_3));
    }
    return (all(((*voxel_21) < far_2)));
}

fn Walk_leave_rounded_2( this_16 : Walk_0,  voxel_22 : ptr<function, vec3<i32>>,  exit_8 : vec3<i32>) -> bool
{
    var t_13 : vec3<f32> = Walk_crossings_0(this_16, exit_8);
    var t_first_4 : f32 = min_element_0(t_13);
    if(t_first_4 >= (this_16.t_end_0))
    {
        return false;
    }
    (*voxel_22) = max(exit_8 - vec3<i32>(ceil((t_13 - vec3<f32>(t_first_4)) * this_16.speed_1)), (*voxel_22));
    return true;
}

fn Walk_leave_2( this_17 : Walk_0,  voxel_23 : ptr<function, vec3<i32>>,  exit_9 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S116 : bool = Walk_leave_rounded_2(this_17, &((*voxel_23)), exit_9);
        return _S116;
    }
    var t_14 : vec3<f32> = Walk_crossings_0(this_17, exit_9);
    var t_first_5 : f32 = min_element_0(t_14);
    if(t_first_5 > (this_17.t_end_0))
    {
        return false;
    }
    var is_x_5 : bool = (t_14.x) == t_first_5;
    var _S117 : bool = !is_x_5;
    var is_y_5 : bool;
    if(_S117)
    {
        is_y_5 = (t_14.y) == t_first_5;
    }
    else
    {
        is_y_5 = false;
    }
    var _S118 : vec3<i32> = (*voxel_23);
    var _S119 : bool;
    if(_S117)
    {
        _S119 = !is_y_5;
    }
    else
    {
        _S119 = false;
    }
    (*voxel_23) = Walk_arrive_0(this_17, _S118, t_first_5, vec3<bool>(is_x_5, is_y_5, _S119), exit_9);
    return true;
}

fn first_voxel_2( _S120 : u32,  _S121 : Walk_0,  _S122 : ptr<function, vec3<i32>>) -> bool
{
    var _S123 : Walk_0 = _S121;
    var _S124 : vec3<i32> = vec3<i32>(i32(0));
    (*_S122) = _S124;
    var voxel_24 : vec3<i32> = Walk_start_voxel_0(_S121);
    var _S125 : bool = Walk_enter_2(_S121, &(voxel_24), cell_of_0(grids_0[_S120].min_0) - _S123.grid_origin_0, cell_of_0(grids_0[_S120].max_0) - _S123.grid_origin_0);
    if(!_S125)
    {
        return false;
    }
    var octant_4 : u32 = LocalRay_octant_0(_S123.ray_0);
    var _S126 : u32 = flip_of_0(octant_4);
    var top_shift_3 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_3 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_3 = grids_0[_S120].top_shift_0;
    }
    var top_size_3 : vec3<i32> = cell_of_0(grids_0[_S120].top_size_0);
    var _S127 : i32 = top_size_3.x;
    var stride_2 : vec3<i32> = vec3<i32>(i32(1), _S127, _S127 * top_size_3.y);
    var _S128 : i32 = i32(grids_0[_S120].top_offset_0) - dot_cells_0((stride_2 & ((_S123.mirror_0))), vec3<i32>(i32(1)));
    var _S129 : vec3<i32> = Walk_mirrored_plane_0(_S123, stride_2);
    var _S130 : u32 = ahead_of_0(_S123.mirror_0);
    var end_2 : vec3<i32> = select((top_size_3 << (vec3<u32>(top_shift_3))), _S124, (_S123.mirror_0) != _S124);
    if(!IS_EXACT_0)
    {
        _S123.t_end_0 = min(_S123.t_end_0, min_element_0(Walk_crossings_0(_S123, end_2)));
    }
    var is_found_6 : bool = false;
    for(;;)
    {
        var _S131 : bool;
        if(IS_EXACT_0)
        {
            _S131 = (any((voxel_24 >= end_2)));
        }
        else
        {
            _S131 = false;
        }
        if(_S131)
        {
            break;
        }
        var cell_16 : u32 = cells_0[_S128 + dot_cells_0(_S129, (voxel_24 >> (vec3<u32>(top_shift_3))))];
        var cell_17 : u32;
        var shift_5 : u32;
        var is_found_7 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_16 & (u32(2147483648)))) != u32(0))
            {
                cell_17 = cells_0[((cell_16 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, u32(3))) ^ (_S126)))];
                shift_5 = u32(3);
            }
            else
            {
                cell_17 = cell_16;
                shift_5 = top_shift_3;
            }
        }
        else
        {
            cell_17 = cell_16;
            shift_5 = top_shift_3;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_7 = shift_5 > u32(3);
                }
                else
                {
                    is_found_7 = false;
                }
                var _S132 : bool;
                if(is_found_7)
                {
                    _S132 = ((cell_17 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S132 = false;
                }
                if(_S132)
                {
                }
                else
                {
                    break;
                }
                var shift_6 : u32 = shift_5 - u32(2);
                cell_17 = cells_0[((cell_17 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, shift_6)) ^ (_S126)))];
                shift_5 = shift_6;
            }
        }
        var exit_10 : vec3<i32>;
        if(((cell_17 & (u32(2147483648)))) == u32(0))
        {
            exit_10 = ((voxel_24 | (vec3<i32>((((i32(1) << (shift_5))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_17, _S130)) << (vec3<u32>(shift_5))));
            is_found_7 = is_found_6;
        }
        else
        {
            var record_4 : u32 = record_of_cell_0(cell_17);
            var blocks_3 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_3 = blocks_of_cell_0(cell_17);
            }
            else
            {
                blocks_3 = blocks_of_record_0(record_4);
            }
            var low_bits_2 : u32 = empty_around_0(record_4, blocks_3, voxel_24, octant_4, _S126);
            var is_found_8 : bool = low_bits_2 == u32(4294967295);
            if(is_found_8)
            {
                is_found_6 = is_found_8;
                break;
            }
            exit_10 = ((voxel_24 | (vec3<i32>(i32(low_bits_2))))) + vec3<i32>(i32(1));
            is_found_7 = is_found_8;
        }
        var _S133 : bool = Walk_leave_2(_S123, &(voxel_24), exit_10);
        if(!_S133)
        {
            is_found_6 = is_found_7;
            break;
        }
        is_found_6 = is_found_7;
    }
    (*_S122) = Walk_mirrored_0(_S123, voxel_24) + _S123.grid_origin_0;
    return is_found_6;
}

fn hit_in_2( instance_8 : u32,  ray_8 : ptr<function, Ray_0>) -> Hit_0
{
    var _S134 : LocalRay_0 = local_ray_0((*ray_8), instance_8);
    if(!_S134.is_valid_0)
    {
        return miss_0();
    }
    var _S135 : Walk_0 = walk_of_0(_S134, instances_0[instance_8].grid_0);
    var voxel_25 : vec3<i32>;
    var _S136 : bool = first_voxel_2(instances_0[instance_8].grid_0, _S135, &(voxel_25));
    var _S137 : bool;
    if(IS_SINGLE_0)
    {
        _S137 = !IS_EXACT_0;
    }
    else
    {
        _S137 = false;
    }
    if(_S137)
    {
        (*ray_8) = ray_of_walk_0(_S135, (*ray_8));
    }
    if(!_S136)
    {
        return miss_0();
    }
    var hit_2 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_2 = hit_of_0(_S134, voxel_25, instance_8);
    }
    else
    {
        hit_2 = hit_of_walk_0(_S135, voxel_25, instance_8);
    }
    if((hit_2.t_1) > ((*ray_8).t_max_1))
    {
        return miss_0();
    }
    return hit_2;
}

struct Sampler_0
{
     seed_1 : u32,
     pixel_0 : u32,
     sample_0 : u32,
};

struct Path_0
{
     sampler_0 : Sampler_0,
     bounce_0 : u32,
     beta_0 : vec3<f32>,
     pdf_0 : f32,
     normal_0 : vec3<f32>,
};

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_1 : vec3<f32>,
};

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_2 : vec3<f32>) -> Receiver_0
{
    var _S138 : Receiver_0;
    _S138.point_0 = point_1;
    _S138.normal_1 = normal_2;
    return _S138;
}

fn Hit_is_miss_0( this_18 : Hit_0) -> bool
{
    return (this_18.instance_2) == u32(4294967295);
}

fn sky_gradient_0( direction_5 : vec3<f32>) -> vec3<f32>
{
    return (params_0.sky_nadir_0 + (params_0.sky_zenith_0 - params_0.sky_nadir_0) * vec3<f32>((0.5f * (direction_5.z + 1.0f)))) * vec3<f32>(params_0.sky_brightness_0);
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn dot_product_0( a_3 : vec3<f32>,  b_3 : vec3<f32>) -> f32
{
    return a_3.x * b_3.x + a_3.y * b_3.y + a_3.z * b_3.z;
}

fn length_squared_0( vector_3 : vec3<f32>) -> f32
{
    return dot_product_0(vector_3, vector_3);
}

fn sun_contains_0( direction_6 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_6 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_depth_0);
}

fn nearest_root_0( mantissa_0 : u32,  guess_2 : u32) -> u32
{
    var rest_1 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_2 * guess_2);
    var units_1 : i32 = i32(floor(f32(rest_1) / f32(u32(2) * guess_2) + 0.5f));
    var _S139 : i32 = i32(guess_2);
    var root_0 : i32 = _S139 + units_1;
    var rest_2 : i32 = rest_1 - units_1 * (_S139 + root_0);
    return u32(root_0 + i32(rest_2 > root_0) - i32(rest_2 <= (- root_0)));
}

fn square_root_0( value_1 : f32) -> f32
{
    var native_1 : f32 = sqrt(value_1);
    if(!IS_EXACT_0)
    {
        return native_1;
    }
    var _S140 : u32 = (bitcast<u32>((value_1)));
    var exponent_2 : u32 = (_S140 >> (u32(23)));
    if(!is_normal_0(i32(exponent_2)))
    {
        return native_1;
    }
    var mantissa_1 : u32 = (((_S140 & (u32(8388607)))) | (u32(8388608)));
    var mantissa_2 : u32;
    if(((exponent_2 & (u32(1)))) == u32(0))
    {
        mantissa_2 = (mantissa_1 << (u32(1)));
    }
    else
    {
        mantissa_2 = mantissa_1;
    }
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_2, u32(sqrt(f32(mantissa_2) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn node_importance_0( _S141 : i32,  _S142 : Receiver_0) -> f32
{
    var low_6 : vec3<f32> = vector_of_0(light_nodes_0[_S141].min_2);
    var high_4 : vec3<f32> = vector_of_0(light_nodes_0[_S141].max_2);
    var _S143 : vec3<f32> = vec3<f32>(0.5f);
    var half_1 : vec3<f32> = (high_4 - low_6) * _S143;
    var toward_0 : vec3<f32> = (low_6 + high_4) * _S143 - _S142.point_0;
    var above_0 : f32 = dot_product_0(toward_0, _S142.normal_1) + dot_product_0(half_1, abs(_S142.normal_1));
    if(above_0 <= 0.0f)
    {
        return 0.0f;
    }
    var _S144 : f32 = max(length_squared_0(toward_0), length_squared_0(half_1));
    var distance_2 : f32 = square_root_0(_S144);
    var _S145 : vec3<f32> = vec3<f32>(0.0f);
    var _S146 : vec3<f32> = vec3<f32>(distance_2);
    var beyond_min_0 : vec3<f32> = min(max(_S142.point_0 - low_6, _S145), _S146);
    var beyond_max_0 : vec3<f32> = min(max(high_4 - _S142.point_0, _S145), _S146);
    return divide_0((light_nodes_0[_S141].power_0[i32(0)] * beyond_max_0.x + light_nodes_0[_S141].power_0[i32(1)] * beyond_min_0.x + (light_nodes_0[_S141].power_0[i32(2)] * beyond_max_0.y + light_nodes_0[_S141].power_0[i32(3)] * beyond_min_0.y) + (light_nodes_0[_S141].power_0[i32(4)] * beyond_max_0.z + light_nodes_0[_S141].power_0[i32(5)] * beyond_min_0.z)) * min(above_0, distance_2), _S144 * _S144);
}

fn sun_probability_0( receiver_0 : Receiver_0) -> f32
{
    if(!has_sun_0())
    {
        return 0.0f;
    }
    var cos_theta_0 : f32 = dot_product_0(receiver_0.normal_1, params_0.sun_direction_0);
    if(cos_theta_0 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    if((params_0.light_node_count_0) == u32(0))
    {
        return 1.0f;
    }
    var from_emitters_0 : f32 = node_importance_0(i32(0), receiver_0) * params_0.light_intensity_0;
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_0, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn light_sun_pdf_0( receiver_1 : Receiver_0) -> f32
{
    var _S147 : f32;
    if(has_sun_0())
    {
        _S147 = params_0.sun_pdf_0 * sun_probability_0(receiver_1);
    }
    else
    {
        _S147 = 0.0f;
    }
    return _S147;
}

fn power_heuristic_0( own_0 : f32,  other_1 : f32) -> f32
{
    var ratio_0 : f32 = divide_0(other_1, own_0);
    return divide_0(1.0f, 1.0f + ratio_0 * ratio_0);
}

fn weight_of_bounce_0( path_0 : Path_0,  light_pdf_0 : f32) -> f32
{
    if((path_0.bounce_0) == u32(0))
    {
        return 1.0f;
    }
    return power_heuristic_0(path_0.pdf_0, light_pdf_0);
}

struct PackedMaterial_0
{
     base_color_0 : array<f32, i32(3)>,
     roughness_0 : f32,
     emission_0 : array<f32, i32(3)>,
     metallic_0 : f32,
     transmission_0 : f32,
     ior_0 : f32,
};

fn find_brick_0( _S148 : u32,  _S149 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S149 >> (vec3<u32>(grids_0[_S148].top_shift_0)));
    var cell_18 : u32 = cells_0[grids_0[_S148].top_offset_0 + u32((top_0.z * grids_0[_S148].top_size_0[i32(1)] + top_0.y) * grids_0[_S148].top_size_0[i32(0)] + top_0.x)];
    var shift_7 : u32 = grids_0[_S148].top_shift_0;
    for(;;)
    {
        var _S150 : bool;
        if(shift_7 > u32(3))
        {
            _S150 = ((cell_18 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S150 = false;
        }
        if(_S150)
        {
        }
        else
        {
            break;
        }
        var shift_8 : u32 = shift_7 - u32(2);
        cell_18 = cells_0[((cell_18 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S149, shift_8)];
        shift_7 = shift_8;
    }
    return record_of_cell_0(cell_18);
}

fn read_bits_0( start_1 : u32,  position_2 : u32,  count_2 : u32) -> u32
{
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    var word_0 : u32 = start_1 + ((position_2 >> (u32(5))));
    var shift_9 : u32 = (position_2 & (u32(31)));
    var bits_1 : u32 = (brick_materials_0[word_0] >> (shift_9));
    var bits_2 : u32;
    if((shift_9 + count_2) > u32(32))
    {
        bits_2 = (bits_1 | (((brick_materials_0[word_0 + u32(1)] << ((u32(32) - shift_9))))));
    }
    else
    {
        bits_2 = bits_1;
    }
    return (bits_2 & ((((u32(1) << (count_2))) - u32(1))));
}

fn material_at_0( _S151 : u32,  _S152 : vec3<i32>) -> u32
{
    var _S153 : u32 = find_brick_0(_S151, _S152);
    var header_0 : u32 = bricks_0[_S153];
    var bit_1 : u32 = cell_in_node_0(_S152, u32(0));
    var present_before_0 : u32 = countOneBits((header_0 & ((((u32(1) << (((((u32(((((_S152.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((_S152.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((_S152.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_2 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_2 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S154 : u32 = u32(2) * index_2;
        var rank_1 : u32 = rank_0 + (countOneBits(bricks_0[_S153 + u32(2) + _S154]) + countOneBits(bricks_0[_S153 + u32(3) + _S154]));
        index_2 = index_2 + u32(1);
        rank_0 = rank_1;
    }
    var _S155 : u32 = u32(2) * present_before_0;
    var low_7 : u32 = bricks_0[_S153 + u32(2) + _S155];
    if(bit_1 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_7 & ((((u32(1) << (bit_1))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_7) + countOneBits((bricks_0[_S153 + u32(3) + _S155] & ((((u32(1) << ((bit_1 - u32(32))))) - u32(1))))));
    }
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S151].material_bits_0;
    var start_2 : u32 = bricks_0[_S153 + u32(1)];
    var index_3 : u32 = read_bits_0(start_2, palette_count_0 * grids_0[_S151].material_bits_0 + rank_0 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_3;
    }
    return read_bits_0(start_2, index_3 * entry_bits_0, entry_bits_0);
}

fn material_of_0( hit_3 : Hit_0) -> PackedMaterial_0
{
    var _S156 : PackedMaterial_std430_0 = materials_0[material_at_0(instances_0[hit_3.instance_2].grid_0, hit_3.voxel_2 - cell_of_0(grids_0[instances_0[hit_3.instance_2].grid_0].origin_1))];
    var _S157 : PackedMaterial_0 = PackedMaterial_0( _S156.base_color_0, _S156.roughness_0, _S156.emission_0, _S156.metallic_0, _S156.transmission_0, _S156.ior_0 );
    return _S157;
}

fn is_before_3( a_4 : vec3<i32>,  b_4 : vec3<i32>) -> bool
{
    var _S158 : vec3<u32> = vec3<u32>((a_4 ^ (b_4)));
    var _S159 : i32 = a_4.z - b_4.z;
    var deciding_0 : u32 = _S158.z;
    var _S160 : u32 = _S158.y;
    var _S161 : bool;
    if(deciding_0 < _S160)
    {
        _S161 = deciding_0 < ((deciding_0 ^ (_S160)));
    }
    else
    {
        _S161 = false;
    }
    var deciding_1 : u32;
    var difference_2 : i32;
    if(_S161)
    {
        var _S162 : i32 = a_4.y - b_4.y;
        deciding_1 = _S160;
        difference_2 = _S162;
    }
    else
    {
        deciding_1 = deciding_0;
        difference_2 = _S159;
    }
    var _S163 : u32 = _S158.x;
    if(deciding_1 < _S163)
    {
        _S161 = deciding_1 < ((deciding_1 ^ (_S163)));
    }
    else
    {
        _S161 = false;
    }
    if(_S161)
    {
        difference_2 = a_4.x - b_4.x;
    }
    return difference_2 < i32(0);
}

fn find_emitter_0( hit_4 : Hit_0,  found_0 : ptr<function, u32>) -> bool
{
    var is_lower_0 : bool;
    var _S164 : vec2<u32> = vec2<u32>(arrayLength(&emitters_0), 32);
    var count_3 : u32 = _S164.x;
    var low_8 : u32 = u32(0);
    var high_5 : u32 = count_3;
    for(;;)
    {
        if(low_8 < high_5)
        {
        }
        else
        {
            break;
        }
        var middle_0 : u32 = low_8 + (high_5 - low_8) / u32(2);
        var _S165 : u32 = emitters_0[middle_0].instance_1;
        if((emitters_0[middle_0].instance_1) < (hit_4.instance_2))
        {
            is_lower_0 = true;
        }
        else
        {
            if(_S165 == (hit_4.instance_2))
            {
                is_lower_0 = is_before_3(cell_of_0(emitters_0[middle_0].voxel_1), hit_4.voxel_2);
            }
            else
            {
                is_lower_0 = false;
            }
        }
        if(is_lower_0)
        {
            low_8 = middle_0 + u32(1);
        }
        if(is_lower_0)
        {
        }
        else
        {
            high_5 = middle_0;
        }
    }
    (*found_0) = low_8;
    if(low_8 < count_3)
    {
        is_lower_0 = (emitters_0[low_8].instance_1) == (hit_4.instance_2);
    }
    else
    {
        is_lower_0 = false;
    }
    if(is_lower_0)
    {
        is_lower_0 = (all(((cell_of_0(emitters_0[low_8].voxel_1)) == (hit_4.voxel_2))));
    }
    else
    {
        is_lower_0 = false;
    }
    return is_lower_0;
}

fn normalize_vector_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vector_4 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_4))));
}

fn in_grid_0( instance_9 : u32,  receiver_2 : Receiver_0) -> Receiver_0
{
    return Receiver_x24init_0(Transform_point_0(instance_9, receiver_2.point_0), normalize_vector_0(Transform_direction_0(instance_9, receiver_2.normal_1)));
}

fn component_0( vector_5 : vec3<f32>,  axis_4 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_4 == u32(1)), vector_5.x, axis_4 == u32(0));
}

fn with_component_0( vector_6 : vec3<f32>,  axis_5 : u32,  value_2 : f32) -> vec3<f32>
{
    return select(vector_6, vec3<f32>(value_2), vec3<bool>(axis_5 == u32(0), axis_5 == u32(1), axis_5 == u32(2)));
}

fn face_importance_0( _S166 : u32,  _S167 : u32,  _S168 : Receiver_0) -> f32
{
    var axis_6 : u32 = (_S167 >> (u32(1)));
    var sign_1 : f32;
    if(((_S167 & (u32(1)))) == u32(1))
    {
        sign_1 = 1.0f;
    }
    else
    {
        sign_1 = -1.0f;
    }
    var toward_1 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[_S166].voxel_1)) + vec3<f32>(0.5f) - _S168.point_0;
    var toward_2 : vec3<f32> = with_component_0(toward_1, axis_6, component_0(toward_1, axis_6) + 0.5f * sign_1);
    var in_front_0 : f32 = - component_0(toward_2, axis_6) * sign_1;
    var above_1 : f32 = dot_product_0(toward_2, _S168.normal_1) + dot_product_0(with_component_0(vec3<f32>(0.5f), axis_6, 0.0f), abs(_S168.normal_1));
    var _S169 : bool;
    if(in_front_0 <= 0.0f)
    {
        _S169 = true;
    }
    else
    {
        _S169 = above_1 <= 0.0f;
    }
    if(_S169)
    {
        return 0.0f;
    }
    var _S170 : f32 = max(length_squared_0(toward_2), 0.5f);
    var distance_3 : f32 = square_root_0(_S170);
    return divide_0(emitters_0[_S166].luminance_0 * min(in_front_0, distance_3) * min(above_1, distance_3), _S170 * _S170);
}

fn sum_of_importances_0( first_2 : u32,  count_4 : u32,  receiver_3 : Receiver_0) -> f32
{
    var index_4 : u32 = first_2;
    var sum_3 : f32 = 0.0f;
    for(;;)
    {
        if(index_4 < (first_2 + count_4))
        {
        }
        else
        {
            break;
        }
        var face_3 : u32 = u32(0);
        var sum_4 : f32 = sum_3;
        for(;;)
        {
            if(face_3 < u32(6))
            {
            }
            else
            {
                break;
            }
            if((((((emitters_0[index_4].faces_0) >> (face_3))) & (u32(1)))) != u32(0))
            {
                sum_4 = sum_4 + face_importance_0(index_4, face_3, receiver_3);
            }
            face_3 = face_3 + u32(1);
        }
        index_4 = index_4 + u32(1);
        sum_3 = sum_4;
    }
    return sum_3;
}

fn face_pdf_0( toward_3 : vec3<f32>,  face_4 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_3, (face_4 >> (u32(1))));
    var in_front_1 : f32;
    if(((face_4 & (u32(1)))) == u32(1))
    {
        in_front_1 = - along_0;
    }
    else
    {
        in_front_1 = along_0;
    }
    var distance_squared_0 : f32 = length_squared_0(toward_3);
    if(in_front_1 > 0.0f)
    {
        in_front_1 = divide_0(distance_squared_0 * square_root_0(distance_squared_0), in_front_1);
    }
    else
    {
        in_front_1 = -1.0f;
    }
    return in_front_1;
}

fn node_importance_1( _S171 : u32,  _S172 : Receiver_0) -> f32
{
    var low_9 : vec3<f32> = vector_of_0(light_nodes_0[_S171].min_2);
    var high_6 : vec3<f32> = vector_of_0(light_nodes_0[_S171].max_2);
    var _S173 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (high_6 - low_9) * _S173;
    var toward_4 : vec3<f32> = (low_9 + high_6) * _S173 - _S172.point_0;
    var above_2 : f32 = dot_product_0(toward_4, _S172.normal_1) + dot_product_0(half_2, abs(_S172.normal_1));
    if(above_2 <= 0.0f)
    {
        return 0.0f;
    }
    var _S174 : f32 = max(length_squared_0(toward_4), length_squared_0(half_2));
    var distance_4 : f32 = square_root_0(_S174);
    var _S175 : vec3<f32> = vec3<f32>(0.0f);
    var _S176 : vec3<f32> = vec3<f32>(distance_4);
    var beyond_min_1 : vec3<f32> = min(max(_S172.point_0 - low_9, _S175), _S176);
    var beyond_max_1 : vec3<f32> = min(max(high_6 - _S172.point_0, _S175), _S176);
    return divide_0((light_nodes_0[_S171].power_0[i32(0)] * beyond_max_1.x + light_nodes_0[_S171].power_0[i32(1)] * beyond_min_1.x + (light_nodes_0[_S171].power_0[i32(2)] * beyond_max_1.y + light_nodes_0[_S171].power_0[i32(3)] * beyond_min_1.y) + (light_nodes_0[_S171].power_0[i32(4)] * beyond_max_1.z + light_nodes_0[_S171].power_0[i32(5)] * beyond_min_1.z)) * min(above_2, distance_4), _S174 * _S174);
}

fn left_probability_0( node_0 : u32,  receiver_4 : Receiver_0) -> f32
{
    var _S177 : f32 = node_importance_1(node_0 + u32(1), receiver_4);
    var _S178 : f32 = _S177 + node_importance_1(light_nodes_0[node_0].index_1, receiver_4);
    var _S179 : f32;
    if(_S178 > 0.0f)
    {
        _S179 = divide_0(_S177, _S178);
    }
    else
    {
        _S179 = -1.0f;
    }
    return _S179;
}

fn emitter_pdf_0( receiver_5 : Receiver_0,  ray_9 : Ray_0,  hit_5 : Hit_0,  found_1 : u32) -> f32
{
    var local_1 : Receiver_0 = in_grid_0(hit_5.instance_2, receiver_5);
    var toward_5 : vec3<f32> = Transform_direction_0(hit_5.instance_2, ray_9.direction_1) * vec3<f32>(hit_5.t_1);
    var _S180 : u32 = emitters_0[found_1].leaf_0;
    var sum_5 : f32 = sum_of_importances_0(light_nodes_0[emitters_0[found_1].leaf_0].index_1, light_nodes_0[emitters_0[found_1].leaf_0].count_1, local_1);
    var own_1 : f32;
    if((((((emitters_0[found_1].faces_0) >> ((hit_5.face_1)))) & (u32(1)))) != u32(0))
    {
        own_1 = face_importance_0(found_1, hit_5.face_1, local_1);
    }
    else
    {
        own_1 = 0.0f;
    }
    var area_pdf_0 : f32 = face_pdf_0(toward_5, hit_5.face_1);
    var _S181 : bool;
    if(area_pdf_0 < 0.0f)
    {
        _S181 = true;
    }
    else
    {
        _S181 = !(own_1 > 0.0f);
    }
    if(_S181)
    {
        return 0.0f;
    }
    var _S182 : f32 = divide_0(own_1, sum_5);
    var parent_1 : u32 = light_nodes_0[emitters_0[found_1].leaf_0].parent_0;
    var node_1 : u32 = _S180;
    var probability_0 : f32 = _S182;
    for(;;)
    {
        if(parent_1 != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var left_0 : f32 = left_probability_0(parent_1, receiver_5);
        if(left_0 < 0.0f)
        {
            return 0.0f;
        }
        if(node_1 == (parent_1 + u32(1)))
        {
            own_1 = left_0;
        }
        else
        {
            own_1 = 1.0f - left_0;
        }
        var probability_1 : f32 = probability_0 * own_1;
        node_1 = parent_1;
        parent_1 = light_nodes_0[parent_1].parent_0;
        probability_0 = probability_1;
    }
    return probability_0 * area_pdf_0;
}

fn light_emitter_pdf_0( receiver_6 : Receiver_0,  ray_10 : Ray_0,  hit_6 : Hit_0) -> f32
{
    var found_2 : u32;
    var _S183 : bool = find_emitter_0(hit_6, &(found_2));
    if(!_S183)
    {
        return 0.0f;
    }
    return emitter_pdf_0(receiver_6, ray_10, hit_6, found_2) * (1.0f - sun_probability_0(receiver_6));
}

fn emitted_0( material_1 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_1.emission_0) * vec3<f32>(params_0.light_intensity_0);
}

fn Path_dimension_scatter_0( this_19 : Path_0) -> u32
{
    return u32(1) + u32(2) * this_19.bounce_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S184 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S184;
    v_0[i32(0)] = v_0[i32(0)] + _S184.y * _S184.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S185 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S185;
    v_0[i32(0)] = v_0[i32(0)] + _S185.y * _S185.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn owen_of_reversed_0( reversed_0 : u32,  seed_2 : u32) -> u32
{
    var word_1 : u32 = reversed_0 + seed_2;
    var word_2 : u32 = (word_1 ^ ((word_1 * u32(1817228412))));
    var word_3 : u32 = (word_2 ^ ((word_2 * u32(3090095698))));
    var word_4 : u32 = (word_3 ^ ((word_3 * u32(3350193720))));
    return reverseBits((word_4 ^ ((word_4 * u32(2367878886)))));
}

fn scrambled_sobol_0( sample_1 : u32,  order_0 : u32,  seeds_0 : vec2<u32>) -> vec2<u32>
{
    var index_5 : u32 = owen_of_reversed_0(reverseBits(sample_1), order_0);
    var binomial_0 : u32 = (index_5 ^ (((((index_5 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_5, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_20 : Sampler_0,  dimension_0 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_1 : vec4<u32> = pcg4d_0(vec4<u32>(this_20.pixel_0, dimension_0, this_20.seed_1, which_0));
    return scrambled_sobol_0(this_20.sample_0, words_1.x, words_1.yz);
}

fn unit_float_0( words_2 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_2 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_stratified_0( this_21 : Sampler_0,  dimension_1 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_21, dimension_1, u32(1)), Sampler_pair_0(this_21, dimension_1, u32(2))));
}

fn survives_0( path_1 : ptr<function, Path_0>,  u_0 : f32) -> bool
{
    if(((*path_1).bounce_0) < u32(3))
    {
        return true;
    }
    var _S186 : f32 = min(max_element_0((*path_1).beta_0), 0.94999998807907104f);
    (*path_1).beta_0 = (*path_1).beta_0 * vec3<f32>(divide_0(1.0f, _S186));
    return u_0 < _S186;
}

struct Surface_0
{
     origin_8 : vec3<f32>,
     normal_3 : vec3<f32>,
     face_5 : u32,
     instance_10 : u32,
};

fn point_off_face_0( translation_1 : vec3<f32>,  low_10 : vec3<f32>,  face_6 : u32,  point_2 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = clamp((max_element_0(abs(low_10) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
    var _S187 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_2, low_10 + _S187), low_10 + vec3<f32>((1.0f - margin_0)));
    var _S188 : bool = face_6 < u32(2);
    var _S189 : bool;
    if(face_6 >= u32(2))
    {
        _S189 = face_6 < u32(4);
    }
    else
    {
        _S189 = false;
    }
    var is_axis_4 : vec3<bool> = vec3<bool>(_S188, _S189, face_6 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_6 & (u32(1)))) == u32(1))
    {
        outside_0 = low_10 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_10 - _S187;
    }
    return select(moved_0, outside_0, is_axis_4);
}

fn face_normal_0( face_7 : u32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_7 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = -1.0f;
    }
    var _S190 : f32;
    if(face_7 < u32(2))
    {
        _S190 = away_0;
    }
    else
    {
        _S190 = 0.0f;
    }
    var _S191 : bool;
    if(face_7 >= u32(2))
    {
        _S191 = face_7 < u32(4);
    }
    else
    {
        _S191 = false;
    }
    var _S192 : f32;
    if(_S191)
    {
        _S192 = away_0;
    }
    else
    {
        _S192 = 0.0f;
    }
    if(face_7 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S190, _S192, away_0);
}

fn Transform_direction_1( _S193 : u32,  _S194 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S193].world_from_grid_0.x_axis_0) * vec3<f32>(_S194.x) + vector_of_0(instances_0[_S193].world_from_grid_0.y_axis_0) * vec3<f32>(_S194.y) + vector_of_0(instances_0[_S193].world_from_grid_0.z_axis_0) * vec3<f32>(_S194.z);
}

fn Transform_point_1( _S195 : u32,  _S196 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S195, _S196) + vector_of_0(instances_0[_S195].world_from_grid_0.translation_0);
}

fn world_normal_0( _S197 : u32,  _S198 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S197, face_normal_0(_S198)));
}

fn surface_of_0( ray_11 : Ray_0,  hit_7 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S199 : vec3<f32> = vec3<f32>(hit_7.voxel_2);
    if(IS_SINGLE_0)
    {
        surface_0.origin_8 = point_off_face_0(vec3<f32>(0.0f), _S199, hit_7.face_1, ray_11.origin_2 + ray_11.direction_1 * vec3<f32>(hit_7.t_1));
        surface_0.normal_3 = face_normal_0(hit_7.face_1);
    }
    else
    {
        surface_0.origin_8 = Transform_point_1(hit_7.instance_2, point_off_face_0(vector_of_0(instances_0[hit_7.instance_2].grid_from_world_0.translation_0), _S199, hit_7.face_1, Transform_point_0(hit_7.instance_2, ray_11.origin_2) + Transform_direction_0(hit_7.instance_2, ray_11.direction_1) * vec3<f32>(hit_7.t_1)));
        surface_0.normal_3 = world_normal_0(hit_7.instance_2, hit_7.face_1);
    }
    surface_0.face_5 = hit_7.face_1;
    surface_0.instance_10 = hit_7.instance_2;
    return surface_0;
}

fn Path_dimension_light_0( this_22 : Path_0) -> u32
{
    return u32(2) + u32(2) * this_22.bounce_0;
}

struct LightSample_0
{
     ray_12 : Ray_0,
     cos_theta_1 : f32,
     radiance_1 : vec3<f32>,
     pdf_1 : f32,
};

fn sincos_turns_0( turns_0 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_0 * 4.0f + 0.5f);
    var x_0 : f32 = (turns_0 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
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

fn ray_from_0( origin_9 : vec3<f32>,  direction_7 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_9, 0.0f, direction_7, (bitcast<f32>((u32(2139095040)))));
}

fn LightSample_x24init_0( ray_13 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S200 : LightSample_0;
    _S200.ray_12 = ray_13;
    _S200.cos_theta_1 = cos_theta_2;
    _S200.radiance_1 = radiance_2;
    _S200.pdf_1 = pdf_2;
    return _S200;
}

fn sample_sun_0( receiver_7 : Receiver_0,  u_1 : f32,  v_1 : f32,  sample_2 : ptr<function, LightSample_0>) -> bool
{
    var depth_0 : f32 = u_1 * params_0.sun_depth_0;
    var radius_0 : f32 = square_root_0(depth_0 * (2.0f - depth_0));
    var sin_cos_0 : vec2<f32> = sincos_turns_0(v_1);
    var direction_8 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - depth_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_0 * sin_cos_0.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_0 * sin_cos_0.x)));
    var cos_theta_3 : f32 = dot_product_0(receiver_7.normal_1, direction_8);
    (*sample_2) = LightSample_x24init_0(ray_from_0(receiver_7.point_0, direction_8), cos_theta_3, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_3 > 0.0f;
}

fn no_light_0() -> LightSample_0
{
    var _S201 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S201, 0.0f, _S201, 0.0f), 0.0f, _S201, 0.0f);
}

struct FaceChoice_0
{
     emitter_0 : u32,
     face_8 : u32,
     importance_0 : f32,
};

fn FaceChoice_x24init_0( emitter_1 : u32,  face_9 : u32,  importance_1 : f32) -> FaceChoice_0
{
    var _S202 : FaceChoice_0;
    _S202.emitter_0 = emitter_1;
    _S202.face_8 = face_9;
    _S202.importance_0 = importance_1;
    return _S202;
}

fn choose_face_0( first_3 : u32,  count_5 : u32,  receiver_8 : Receiver_0,  threshold_0 : f32) -> FaceChoice_0
{
    var _S203 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), u32(0), 0.0f);
    var is_found_9 : bool = false;
    var chosen_0 : FaceChoice_0 = _S203;
    var index_6 : u32 = first_3;
    var passed_0 : f32 = 0.0f;
    for(;;)
    {
        var _S204 : bool;
        if(index_6 < (first_3 + count_5))
        {
            _S204 = !is_found_9;
        }
        else
        {
            _S204 = false;
        }
        if(_S204)
        {
        }
        else
        {
            break;
        }
        var is_found_10 : bool = is_found_9;
        var chosen_1 : FaceChoice_0 = chosen_0;
        var face_10 : u32 = u32(0);
        var passed_1 : f32 = passed_0;
        for(;;)
        {
            var _S205 : bool;
            if(face_10 < u32(6))
            {
                _S205 = !is_found_10;
            }
            else
            {
                _S205 = false;
            }
            if(_S205)
            {
            }
            else
            {
                break;
            }
            if((((((emitters_0[index_6].faces_0) >> (face_10))) & (u32(1)))) == u32(0))
            {
                face_10 = face_10 + u32(1);
                continue;
            }
            var _S206 : f32 = face_importance_0(index_6, face_10, receiver_8);
            var is_found_11 : bool;
            var chosen_2 : FaceChoice_0;
            var passed_2 : f32;
            if(_S206 > 0.0f)
            {
                var _S207 : FaceChoice_0 = FaceChoice_x24init_0(index_6, face_10, _S206);
                var passed_3 : f32 = passed_1 + _S206;
                is_found_11 = threshold_0 < passed_3;
                chosen_2 = _S207;
                passed_2 = passed_3;
            }
            else
            {
                is_found_11 = is_found_10;
                chosen_2 = chosen_1;
                passed_2 = passed_1;
            }
            is_found_10 = is_found_11;
            chosen_1 = chosen_2;
            passed_1 = passed_2;
            face_10 = face_10 + u32(1);
        }
        var _S208 : u32 = index_6 + u32(1);
        is_found_9 = is_found_10;
        chosen_0 = chosen_1;
        index_6 = _S208;
        passed_0 = passed_1;
    }
    return chosen_0;
}

fn point_of_face_0( low_11 : vec3<f32>,  face_11 : u32,  u_2 : f32,  v_2 : f32) -> vec3<f32>
{
    var away_1 : f32;
    if(((face_11 & (u32(1)))) == u32(1))
    {
        away_1 = 1.0f;
    }
    else
    {
        away_1 = 0.0f;
    }
    if(face_11 < u32(2))
    {
        return low_11 + vec3<f32>(away_1, u_2, v_2);
    }
    if(face_11 < u32(4))
    {
        return low_11 + vec3<f32>(u_2, away_1, v_2);
    }
    return low_11 + vec3<f32>(u_2, v_2, away_1);
}

fn sample_emitter_0( receiver_9 : Receiver_0,  u_3 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var choice_0 : f32 = u_3.x;
    var node_2 : u32 = u32(0);
    var probability_2 : f32 = 1.0f;
    for(;;)
    {
        if((light_nodes_0[node_2].count_1) == u32(0))
        {
        }
        else
        {
            break;
        }
        var left_1 : f32 = left_probability_0(node_2, receiver_9);
        if(left_1 < 0.0f)
        {
            return false;
        }
        var choice_1 : f32;
        if(choice_0 < left_1)
        {
            var node_3 : u32 = node_2 + u32(1);
            var probability_3 : f32 = probability_2 * left_1;
            choice_1 = divide_0(choice_0, left_1);
            node_2 = node_3;
            probability_2 = probability_3;
        }
        else
        {
            var right_0 : f32 = 1.0f - left_1;
            var probability_4 : f32 = probability_2 * right_0;
            choice_1 = divide_0(choice_0 - left_1, right_0);
            node_2 = light_nodes_0[node_2].index_1;
            probability_2 = probability_4;
        }
        choice_0 = min(choice_1, 0.99999994039535522f);
    }
    var local_2 : Receiver_0 = in_grid_0(emitters_0[light_nodes_0[node_2].index_1].instance_1, receiver_9);
    var sum_6 : f32 = sum_of_importances_0(light_nodes_0[node_2].index_1, light_nodes_0[node_2].count_1, local_2);
    var chosen_3 : FaceChoice_0 = choose_face_0(light_nodes_0[node_2].index_1, light_nodes_0[node_2].count_1, local_2, u_3.y * sum_6);
    if((chosen_3.importance_0) <= 0.0f)
    {
        return false;
    }
    var probability_5 : f32 = probability_2 * divide_0(chosen_3.importance_0, sum_6);
    var _S209 : u32 = emitters_0[chosen_3.emitter_0].instance_1;
    var _S210 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[chosen_3.emitter_0].voxel_1));
    var on_face_0 : vec3<f32> = point_of_face_0(_S210, chosen_3.face_8, u_3.z, u_3.w);
    var area_pdf_1 : f32 = face_pdf_0(on_face_0 - local_2.point_0, chosen_3.face_8);
    if(area_pdf_1 < 0.0f)
    {
        return false;
    }
    var direction_9 : vec3<f32> = Transform_point_1(_S209, point_off_face_0(vector_of_0(instances_0[emitters_0[chosen_3.emitter_0].instance_1].grid_from_world_0.translation_0), _S210, chosen_3.face_8, on_face_0)) - receiver_9.point_0;
    var cos_theta_4 : f32 = divide_0(dot_product_0(receiver_9.normal_1, direction_9), square_root_0(length_squared_0(direction_9)));
    (*sample_3) = LightSample_x24init_0(Ray_x24init_0(receiver_9.point_0, 0.0f, direction_9, 1.0f), cos_theta_4, vector_of_0(materials_0[emitters_0[chosen_3.emitter_0].material_0].emission_0) * vec3<f32>(params_0.light_intensity_0), probability_5 * area_pdf_1);
    return cos_theta_4 > 0.0f;
}

fn sample_light_0( receiver_10 : Receiver_0,  u_4 : vec4<f32>,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    var of_sun_0 : f32 = sun_probability_0(receiver_10);
    var is_found_12 : bool;
    if(has_sun_0())
    {
        is_found_12 = (u_4.x) < of_sun_0;
    }
    else
    {
        is_found_12 = false;
    }
    if(is_found_12)
    {
        var _S211 : bool = sample_sun_0(receiver_10, u_4.z, u_4.w, &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * of_sun_0;
        is_found_12 = _S211;
    }
    else
    {
        var _S212 : f32 = 1.0f - of_sun_0;
        var _S213 : bool = sample_emitter_0(receiver_10, vec4<f32>(min(divide_0(u_4.x - of_sun_0, _S212), 0.99999994039535522f), u_4.yzw), &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * _S212;
        is_found_12 = _S213;
    }
    return is_found_12;
}

fn cosine_hemisphere_pdf_0( cos_theta_5 : f32) -> f32
{
    return max(cos_theta_5, 0.0f) * 0.31830987334251404f;
}

fn entry_0( _S214 : u32,  _S215 : Ray_0,  _S216 : vec3<f32>) -> f32
{
    var low_12 : vec3<f32> = (vector_of_0(instance_nodes_0[_S214].min_1) - _S215.origin_2) * _S216;
    var high_7 : vec3<f32> = (vector_of_0(instance_nodes_0[_S214].max_1) - _S215.origin_2) * _S216;
    var _S217 : f32 = max(_S215.t_min_1, max_element_0(min(low_12, high_7)));
    var _S218 : f32;
    if(_S217 <= (min(_S215.t_max_1, min_element_0(max(low_12, high_7)))))
    {
        _S218 = _S217;
    }
    else
    {
        _S218 = (bitcast<f32>((u32(2139095040))));
    }
    return _S218;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S219 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S219;
    }
    var ray_14 : Ray_0 = (*given_0);
    var nearest_2 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_2;
    }
    var is_still_1 : vec3<bool> = !((abs(ray_14.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S220 : vec3<f32> = select(reciprocal_0(select(ray_14.direction_1, vec3<f32>(1.0f), is_still_1)), vec3<f32>(3.4028234663852886e+38f), is_still_1);
    var stack_0 : array<u32, i32(32)>;
    var near_0 : u32 = u32(0);
    var nearest_3 : Hit_0 = nearest_2;
    var depth_1 : u32 = u32(0);
    for(;;)
    {
        var depth_2 : u32;
        if((instance_nodes_0[near_0].is_leaf_0) != u32(0))
        {
            var hit_8 : Hit_0 = hit_in_0(instance_nodes_0[near_0].index_0, &(ray_14));
            var _S221 : Hit_0 = nearest_3;
            var _S222 : bool;
            if((hit_8.t_1) < (nearest_3.t_1))
            {
                _S222 = true;
            }
            else
            {
                if((hit_8.t_1) == (_S221.t_1))
                {
                    _S222 = (hit_8.instance_2) < (nearest_3.instance_2);
                }
                else
                {
                    _S222 = false;
                }
            }
            var nearest_4 : Hit_0;
            if(_S222)
            {
                ray_14.t_max_1 = hit_8.t_1;
                if(is_any_enough_0)
                {
                    return hit_8;
                }
                nearest_4 = hit_8;
            }
            else
            {
                nearest_4 = nearest_3;
            }
            nearest_3 = nearest_4;
            depth_2 = depth_1;
        }
        else
        {
            var _S223 : u32 = near_0 + u32(1);
            var _S224 : f32 = entry_0(_S223, ray_14, _S220);
            var _S225 : u32 = instance_nodes_0[near_0].index_0;
            var _S226 : f32 = entry_0(instance_nodes_0[near_0].index_0, ray_14, _S220);
            var _S227 : bool = _S224 <= _S226;
            if(_S227)
            {
                near_0 = _S223;
            }
            else
            {
                near_0 = _S225;
            }
            var far_3 : u32;
            if(_S227)
            {
                far_3 = _S225;
            }
            else
            {
                far_3 = _S223;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S224, _S226)) < INFINITY_0)
            {
                var _S228 : u32 = depth_1 + u32(1);
                stack_0[depth_1] = far_3;
                depth_2 = _S228;
            }
            else
            {
                depth_2 = depth_1;
            }
            if((min(_S224, _S226)) < INFINITY_0)
            {
                depth_1 = depth_2;
                continue;
            }
        }
        if(depth_2 == u32(0))
        {
            break;
        }
        var depth_3 : u32 = depth_2 - u32(1);
        near_0 = stack_0[depth_3];
        depth_1 = depth_3;
    }
    return nearest_3;
}

fn WalkTracer_is_occluded_0( ray_15 : Ray_0) -> bool
{
    var copy_0 : Ray_0 = ray_15;
    var _S229 : Hit_0 = visit_0(&(copy_0), true);
    return !Hit_is_miss_0(_S229);
}

fn cosine_hemisphere_0( u_5 : f32,  v_3 : f32) -> vec3<f32>
{
    var radius_1 : f32 = square_root_0(u_5);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(v_3);
    return vec3<f32>(radius_1 * sin_cos_1.y, radius_1 * sin_cos_1.x, square_root_0(1.0f - u_5));
}

fn Surface_world_direction_0( this_23 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_23.face_5) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S230 : f32 = local_3.x;
    var _S231 : f32 = local_3.y;
    var _S232 : vec3<f32> = vec3<f32>(_S230, _S231, away_2);
    var in_grid_1 : vec3<f32>;
    if((this_23.face_5) < u32(2))
    {
        in_grid_1 = vec3<f32>(away_2, _S230, _S231);
    }
    else
    {
        if((this_23.face_5) < u32(4))
        {
            in_grid_1 = vec3<f32>(_S231, away_2, _S230);
        }
        else
        {
            in_grid_1 = _S232;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_1(this_23.instance_10, in_grid_1);
    }
    return normalize_vector_0(in_grid_1);
}

fn PathTracing_advance_0( path_2 : ptr<function, Path_0>,  ray_16 : Ray_0,  hit_9 : Hit_0,  radiance_3 : ptr<function, vec3<f32>>,  next_0 : ptr<function, Ray_0>,  shadow_rays_0 : ptr<function, u32>) -> bool
{
    (*next_0) = ray_16;
    var last_2 : Receiver_0 = Receiver_x24init_0(ray_16.origin_2, (*path_2).normal_0);
    var light_pdf_1 : f32;
    var _S233 : bool;
    if(Hit_is_miss_0(hit_9))
    {
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sky_gradient_0(ray_16.direction_1);
        if(has_sun_0())
        {
            _S233 = sun_contains_0(ray_16.direction_1);
        }
        else
        {
            _S233 = false;
        }
        if(_S233)
        {
            if(((*path_2).bounce_0) == u32(0))
            {
                light_pdf_1 = 0.0f;
            }
            else
            {
                light_pdf_1 = light_sun_pdf_0(last_2);
            }
            (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * params_0.sun_radiance_0 * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
        }
        return false;
    }
    var material_2 : PackedMaterial_0 = material_of_0(hit_9);
    if((max_element_0(vector_of_0(material_2.emission_0))) > 0.0f)
    {
        if(((*path_2).bounce_0) == u32(0))
        {
            light_pdf_1 = 0.0f;
        }
        else
        {
            light_pdf_1 = light_emitter_pdf_0(last_2, ray_16, hit_9);
        }
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * emitted_0(material_2) * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
    }
    (*path_2).beta_0 = (*path_2).beta_0 * vector_of_0(material_2.base_color_0);
    var u_6 : vec4<f32> = Sampler_stratified_0((*path_2).sampler_0, Path_dimension_scatter_0((*path_2)));
    if(((*path_2).bounce_0) == (params_0.max_bounces_0))
    {
        _S233 = true;
    }
    else
    {
        _S233 = (max_element_0((*path_2).beta_0)) <= 0.0f;
    }
    if(_S233)
    {
        _S233 = true;
    }
    else
    {
        var _S234 : bool = survives_0(&((*path_2)), u_6.z);
        _S233 = !_S234;
    }
    if(_S233)
    {
        return false;
    }
    var surface_1 : Surface_0 = surface_of_0(ray_16, hit_9);
    var sample_5 : LightSample_0;
    var _S235 : bool = sample_light_0(Receiver_x24init_0(surface_1.origin_8, surface_1.normal_3), Sampler_stratified_0((*path_2).sampler_0, Path_dimension_light_0((*path_2))), &(sample_5));
    if(_S235)
    {
        var bounce_pdf_0 : f32 = cosine_hemisphere_pdf_0(sample_5.cos_theta_1);
        var share_0 : f32 = divide_0(bounce_pdf_0, sample_5.pdf_1) * power_heuristic_0(sample_5.pdf_1, bounce_pdf_0);
        (*shadow_rays_0) = (*shadow_rays_0) + u32(1);
        if(!WalkTracer_is_occluded_0(sample_5.ray_12))
        {
            (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sample_5.radiance_1 * vec3<f32>(share_0);
        }
    }
    var local_4 : vec3<f32> = cosine_hemisphere_0(u_6.x, u_6.y);
    (*path_2).pdf_0 = cosine_hemisphere_pdf_0(local_4.z);
    (*path_2).normal_0 = surface_1.normal_3;
    (*path_2).bounce_0 = (*path_2).bounce_0 + u32(1);
    (*next_0) = ray_from_0(surface_1.origin_8, Surface_world_direction_0(surface_1, local_4));
    return true;
}

fn Sampler_x24init_0( seed_3 : u32,  pixel_1 : u32,  sample_6 : u32) -> Sampler_0
{
    var _S236 : Sampler_0;
    _S236.seed_1 = seed_3;
    _S236.pixel_0 = pixel_1;
    _S236.sample_0 = sample_6;
    return _S236;
}

fn sampler_of_0( pixel_2 : u32,  sample_7 : u32) -> Sampler_0
{
    return Sampler_x24init_0(params_0.seed_0, pixel_2, params_0.first_sample_0 + sample_7);
}

fn Path_x24init_0( sampler_1 : Sampler_0,  bounce_1 : u32,  beta_1 : vec3<f32>,  pdf_3 : f32,  normal_4 : vec3<f32>) -> Path_0
{
    var _S237 : Path_0;
    _S237.sampler_0 = sampler_1;
    _S237.bounce_0 = bounce_1;
    _S237.beta_0 = beta_1;
    _S237.pdf_0 = pdf_3;
    _S237.normal_0 = normal_4;
    return _S237;
}

fn PathTracing_jitter_0( sampler_2 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_2, u32(0));
}

struct CameraFrame_0
{
     eye_1 : vec3<f32>,
     corner_1 : vec3<f32>,
     pixel_x_1 : vec3<f32>,
     pixel_y_1 : vec3<f32>,
};

fn CameraFrame_x24init_0( eye_2 : vec3<f32>,  corner_2 : vec3<f32>,  pixel_x_2 : vec3<f32>,  pixel_y_2 : vec3<f32>) -> CameraFrame_0
{
    var _S238 : CameraFrame_0;
    _S238.eye_1 = eye_2;
    _S238.corner_1 = corner_2;
    _S238.pixel_x_1 = pixel_x_2;
    _S238.pixel_y_1 = pixel_y_2;
    return _S238;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0);
}

fn position_of_0( pixel_3 : u32) -> vec2<u32>
{
    var y_0 : u32 = pixel_3 / params_0.width_0;
    return vec2<u32>(pixel_3 - y_0 * params_0.width_0, y_0);
}

fn CameraFrame_ray_0( this_24 : CameraFrame_0,  position_3 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_24.eye_1, normalize_vector_0(this_24.corner_1 + this_24.pixel_x_1 * vec3<f32>(position_3.x) + this_24.pixel_y_1 * vec3<f32>(position_3.y)));
}

fn PathTracing_clip_0( ray_17 : Ray_0) -> Ray_0
{
    return ray_17;
}

fn camera_path_0( pixel_4 : u32,  sample_8 : u32,  path_3 : ptr<function, Path_0>) -> Ray_0
{
    (*path_3) = Path_x24init_0(sampler_of_0(pixel_4, sample_8), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f));
    var jitter_0 : vec4<f32> = PathTracing_jitter_0((*path_3).sampler_0);
    var _S239 : CameraFrame_0 = FrameParams_camera_0();
    var _S240 : vec2<u32> = position_of_0(pixel_4);
    return PathTracing_clip_0(CameraFrame_ray_0(_S239, vec2<f32>(_S240) + jitter_0.xy));
}

struct RayCounts_0
{
     bounce_2 : u32,
     shadow_0 : u32,
};

struct Work_0
{
     pixel_5 : u32,
     sample_9 : u32,
     last_3 : u32,
};

fn RayCounts_x24init_0( bounce_3 : u32,  shadow_1 : u32) -> RayCounts_0
{
    var _S241 : RayCounts_0;
    _S241.bounce_2 = bounce_3;
    _S241.shadow_0 = shadow_1;
    return _S241;
}

fn visit_1( given_1 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S242 : Hit_0 = hit_in_1(u32(0), &((*given_1)));
        return _S242;
    }
    var ray_18 : Ray_0 = (*given_1);
    var nearest_5 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_5;
    }
    var is_still_2 : vec3<bool> = !((abs(ray_18.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S243 : vec3<f32> = select(reciprocal_0(select(ray_18.direction_1, vec3<f32>(1.0f), is_still_2)), vec3<f32>(3.4028234663852886e+38f), is_still_2);
    var stack_1 : array<u32, i32(32)>;
    var near_1 : u32 = u32(0);
    var nearest_6 : Hit_0 = nearest_5;
    var depth_4 : u32 = u32(0);
    for(;;)
    {
        var depth_5 : u32;
        if((instance_nodes_0[near_1].is_leaf_0) != u32(0))
        {
            var hit_10 : Hit_0 = hit_in_1(instance_nodes_0[near_1].index_0, &(ray_18));
            var _S244 : Hit_0 = nearest_6;
            var _S245 : bool;
            if((hit_10.t_1) < (nearest_6.t_1))
            {
                _S245 = true;
            }
            else
            {
                if((hit_10.t_1) == (_S244.t_1))
                {
                    _S245 = (hit_10.instance_2) < (nearest_6.instance_2);
                }
                else
                {
                    _S245 = false;
                }
            }
            var nearest_7 : Hit_0;
            if(_S245)
            {
                ray_18.t_max_1 = hit_10.t_1;
                if(is_any_enough_1)
                {
                    return hit_10;
                }
                nearest_7 = hit_10;
            }
            else
            {
                nearest_7 = nearest_6;
            }
            nearest_6 = nearest_7;
            depth_5 = depth_4;
        }
        else
        {
            var _S246 : u32 = near_1 + u32(1);
            var _S247 : f32 = entry_0(_S246, ray_18, _S243);
            var _S248 : u32 = instance_nodes_0[near_1].index_0;
            var _S249 : f32 = entry_0(instance_nodes_0[near_1].index_0, ray_18, _S243);
            var _S250 : bool = _S247 <= _S249;
            if(_S250)
            {
                near_1 = _S246;
            }
            else
            {
                near_1 = _S248;
            }
            var far_4 : u32;
            if(_S250)
            {
                far_4 = _S248;
            }
            else
            {
                far_4 = _S246;
            }
            var INFINITY_1 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S247, _S249)) < INFINITY_1)
            {
                var _S251 : u32 = depth_4 + u32(1);
                stack_1[depth_4] = far_4;
                depth_5 = _S251;
            }
            else
            {
                depth_5 = depth_4;
            }
            if((min(_S247, _S249)) < INFINITY_1)
            {
                depth_4 = depth_5;
                continue;
            }
        }
        if(depth_5 == u32(0))
        {
            break;
        }
        var depth_6 : u32 = depth_5 - u32(1);
        near_1 = stack_1[depth_6];
        depth_4 = depth_6;
    }
    return nearest_6;
}

fn WalkTracer_trace_0( ray_19 : ptr<function, Ray_0>) -> Hit_0
{
    var _S252 : Hit_0 = visit_1(&((*ray_19)), false);
    return _S252;
}

fn place_of_0( at_1 : vec2<u32>) -> u32
{
    var relative_1 : vec2<u32> = at_1 - params_0.region_0.xy;
    return relative_1.y * (params_0.region_0.z - params_0.region_0.x) + relative_1.x;
}

struct PixelRecord_0
{
     radiance_0 : array<u32, i32(6)>,
     samples_0 : u32,
     covered_0 : u32,
};

fn fixed_point_0( value_3 : f32) -> vec2<u32>
{
    if(!(value_3 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_3 : u32 = (bitcast<u32>((min(value_3, 1.048576e+06f))));
    var shift_10 : i32 = i32((bits_3 >> (u32(23)))) - i32(118);
    var mantissa_3 : u32 = (((bits_3 & (u32(8388607)))) | (u32(8388608)));
    if(shift_10 <= i32(-24))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    if(shift_10 < i32(0))
    {
        return vec2<u32>((mantissa_3 >> (u32(- shift_10))), u32(0));
    }
    if(shift_10 < i32(32))
    {
        var _S253 : u32 = (mantissa_3 << (u32(shift_10)));
        var _S254 : u32;
        if(shift_10 == i32(0))
        {
            _S254 = u32(0);
        }
        else
        {
            _S254 = (mantissa_3 >> (u32(i32(32) - shift_10)));
        }
        return vec2<u32>(_S253, _S254);
    }
    return vec2<u32>(u32(0), (mantissa_3 << (u32(shift_10 - i32(32)))));
}

fn PixelRecord_add_0( this_25 : ptr<function, PixelRecord_0>,  value_4 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_4[u32(0)]);
    var _S255 : u32 = addend_0.x;
    var low_13 : u32 = (*this_25).radiance_0[u32(0)] + _S255;
    var high_8 : u32 = (*this_25).radiance_0[u32(1)] + addend_0.y + u32(low_13 < _S255);
    var is_full_0 : bool = high_8 < ((*this_25).radiance_0[u32(1)]);
    var _S256 : u32;
    if(is_full_0)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = low_13;
    }
    (*this_25).radiance_0[u32(0)] = _S256;
    if(is_full_0)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = high_8;
    }
    (*this_25).radiance_0[u32(1)] = _S256;
    var addend_1 : vec2<u32> = fixed_point_0(value_4[u32(1)]);
    var _S257 : u32 = addend_1.x;
    var low_14 : u32 = (*this_25).radiance_0[u32(2)] + _S257;
    var high_9 : u32 = (*this_25).radiance_0[u32(3)] + addend_1.y + u32(low_14 < _S257);
    var is_full_1 : bool = high_9 < ((*this_25).radiance_0[u32(3)]);
    if(is_full_1)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = low_14;
    }
    (*this_25).radiance_0[u32(2)] = _S256;
    if(is_full_1)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = high_9;
    }
    (*this_25).radiance_0[u32(3)] = _S256;
    var addend_2 : vec2<u32> = fixed_point_0(value_4[u32(2)]);
    var _S258 : u32 = addend_2.x;
    var low_15 : u32 = (*this_25).radiance_0[u32(4)] + _S258;
    var high_10 : u32 = (*this_25).radiance_0[u32(5)] + addend_2.y + u32(low_15 < _S258);
    var is_full_2 : bool = high_10 < ((*this_25).radiance_0[u32(5)]);
    if(is_full_2)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = low_15;
    }
    (*this_25).radiance_0[u32(4)] = _S256;
    if(is_full_2)
    {
        _S256 = u32(4294967295);
    }
    else
    {
        _S256 = high_10;
    }
    (*this_25).radiance_0[u32(5)] = _S256;
    (*this_25).samples_0 = (*this_25).samples_0 + u32(1);
    (*this_25).covered_0 = (*this_25).covered_0 + u32(is_covered_0);
    return;
}

fn add_sample_0( index_7 : u32,  radiance_4 : vec3<f32>,  is_covered_1 : bool)
{
    var pixel_6 : PixelRecord_0;
    pixel_6.radiance_0 = pixels_0[index_7].radiance_0;
    pixel_6.samples_0 = pixels_0[index_7].samples_0;
    pixel_6.covered_0 = pixels_0[index_7].covered_0;
    PixelRecord_add_0(&(pixel_6), radiance_4, is_covered_1);
    pixels_0[index_7].radiance_0 = pixel_6.radiance_0;
    pixels_0[index_7].samples_0 = pixel_6.samples_0;
    pixels_0[index_7].covered_0 = pixel_6.covered_0;
    return;
}

fn trace_pixel_0( work_0 : Work_0) -> RayCounts_0
{
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S259 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_5 : vec3<f32> = _S259;
    var path_4 : Path_0;
    var _S260 : Ray_0 = camera_path_0(work_0.pixel_5, work_0.sample_9, &(path_4));
    var ray_20 : Ray_0 = _S260;
    var is_covered_2 : bool = false;
    var sample_10 : u32 = work_0.sample_9;
    for(;;)
    {
        if(sample_10 < (work_0.last_3))
        {
        }
        else
        {
            break;
        }
        var _S261 : Hit_0 = WalkTracer_trace_0(&(ray_20));
        if((path_4.bounce_0) == u32(0))
        {
            is_covered_2 = !Hit_is_miss_0(_S261);
        }
        else
        {
            counts_0.bounce_2 = counts_0.bounce_2 + u32(1);
        }
        var goes_on_0 : bool;
        if(is_covered_2)
        {
            goes_on_0 = true;
        }
        else
        {
            goes_on_0 = (params_0.is_transparent_0) == u32(0);
        }
        path_4.sampler_0 = sampler_of_0(work_0.pixel_5, sample_10);
        var goes_on_1 : bool;
        if(goes_on_0)
        {
            var _S262 : u32 = counts_0.shadow_0;
            var _S263 : bool = PathTracing_advance_0(&(path_4), ray_20, _S261, &(radiance_5), &(ray_20), &(_S262));
            counts_0.shadow_0 = _S262;
            goes_on_1 = _S263;
        }
        else
        {
            goes_on_1 = goes_on_0;
        }
        if(!goes_on_1)
        {
            var _S264 : vec2<u32> = position_of_0(work_0.pixel_5);
            add_sample_0(place_of_0(_S264), radiance_5, is_covered_2);
            radiance_5 = _S259;
            var sample_11 : u32 = sample_10 + u32(1);
            if(sample_11 == (work_0.last_3))
            {
                break;
            }
            var _S265 : Ray_0 = camera_path_0(work_0.pixel_5, sample_11, &(path_4));
            ray_20 = _S265;
            sample_10 = sample_11;
        }
    }
    return counts_0;
}

fn Sampler_independent_0( this_26 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_26.pixel_0, this_26.sample_0, dimension_2, this_26.seed_1)));
}

fn Essay_clip_0( ray_21 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_21.origin_2, 0.10000000149011612f, ray_21.direction_1, 10000.0f);
}

fn Essay_advance_0( path_5 : ptr<function, Path_0>,  ray_22 : Ray_0,  hit_11 : Hit_0,  radiance_6 : ptr<function, vec3<f32>>,  next_1 : ptr<function, Ray_0>,  shadow_rays_1 : ptr<function, u32>) -> bool
{
    (*next_1) = ray_22;
    if(Hit_is_miss_0(hit_11))
    {
        (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * sky_gradient_0(ray_22.direction_1);
        return false;
    }
    var material_3 : PackedMaterial_0 = material_of_0(hit_11);
    if((max_element_0(vector_of_0(material_3.emission_0))) > 0.0f)
    {
        (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * emitted_0(material_3);
        return false;
    }
    if(((*path_5).bounce_0) == (params_0.max_bounces_0))
    {
        return false;
    }
    var u_7 : vec4<f32> = Sampler_independent_0((*path_5).sampler_0, Path_dimension_scatter_0((*path_5)));
    var surface_2 : Surface_0 = surface_of_0(ray_22, hit_11);
    (*path_5).beta_0 = (*path_5).beta_0 * vector_of_0(material_3.base_color_0);
    (*path_5).bounce_0 = (*path_5).bounce_0 + u32(1);
    (*next_1) = Essay_clip_0(ray_from_0(surface_2.origin_8, Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_7.x, u_7.y))));
    return true;
}

fn Essay_jitter_0( sampler_3 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_3, u32(0));
}

fn camera_path_1( pixel_7 : u32,  sample_12 : u32,  path_6 : ptr<function, Path_0>) -> Ray_0
{
    (*path_6) = Path_x24init_0(sampler_of_0(pixel_7, sample_12), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f));
    var jitter_1 : vec4<f32> = Essay_jitter_0((*path_6).sampler_0);
    var _S266 : CameraFrame_0 = FrameParams_camera_0();
    var _S267 : vec2<u32> = position_of_0(pixel_7);
    return Essay_clip_0(CameraFrame_ray_0(_S266, vec2<f32>(_S267) + jitter_1.xy));
}

fn trace_pixel_1( work_1 : Work_0) -> RayCounts_0
{
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S268 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_7 : vec3<f32> = _S268;
    var path_7 : Path_0;
    var _S269 : Ray_0 = camera_path_1(work_1.pixel_5, work_1.sample_9, &(path_7));
    var ray_23 : Ray_0 = _S269;
    var is_covered_3 : bool = false;
    var sample_13 : u32 = work_1.sample_9;
    for(;;)
    {
        if(sample_13 < (work_1.last_3))
        {
        }
        else
        {
            break;
        }
        var _S270 : Hit_0 = WalkTracer_trace_0(&(ray_23));
        if((path_7.bounce_0) == u32(0))
        {
            is_covered_3 = !Hit_is_miss_0(_S270);
        }
        else
        {
            counts_1.bounce_2 = counts_1.bounce_2 + u32(1);
        }
        var goes_on_2 : bool;
        if(is_covered_3)
        {
            goes_on_2 = true;
        }
        else
        {
            goes_on_2 = (params_0.is_transparent_0) == u32(0);
        }
        path_7.sampler_0 = sampler_of_0(work_1.pixel_5, sample_13);
        var goes_on_3 : bool;
        if(goes_on_2)
        {
            var _S271 : u32 = counts_1.shadow_0;
            var _S272 : bool = Essay_advance_0(&(path_7), ray_23, _S270, &(radiance_7), &(ray_23), &(_S271));
            counts_1.shadow_0 = _S271;
            goes_on_3 = _S272;
        }
        else
        {
            goes_on_3 = goes_on_2;
        }
        if(!goes_on_3)
        {
            var _S273 : vec2<u32> = position_of_0(work_1.pixel_5);
            add_sample_0(place_of_0(_S273), radiance_7, is_covered_3);
            radiance_7 = _S268;
            var sample_14 : u32 = sample_13 + u32(1);
            if(sample_14 == (work_1.last_3))
            {
                break;
            }
            var _S274 : Ray_0 = camera_path_1(work_1.pixel_5, sample_14, &(path_7));
            ray_23 = _S274;
            sample_13 = sample_14;
        }
    }
    return counts_1;
}

fn visit_2( given_2 : ptr<function, Ray_0>,  is_any_enough_2 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S275 : Hit_0 = hit_in_2(u32(0), &((*given_2)));
        return _S275;
    }
    var ray_24 : Ray_0 = (*given_2);
    var nearest_8 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_8;
    }
    var is_still_3 : vec3<bool> = !((abs(ray_24.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S276 : vec3<f32> = select(reciprocal_0(select(ray_24.direction_1, vec3<f32>(1.0f), is_still_3)), vec3<f32>(3.4028234663852886e+38f), is_still_3);
    var stack_2 : array<u32, i32(32)>;
    var near_2 : u32 = u32(0);
    var nearest_9 : Hit_0 = nearest_8;
    var depth_7 : u32 = u32(0);
    for(;;)
    {
        var depth_8 : u32;
        if((instance_nodes_0[near_2].is_leaf_0) != u32(0))
        {
            var hit_12 : Hit_0 = hit_in_2(instance_nodes_0[near_2].index_0, &(ray_24));
            var _S277 : Hit_0 = nearest_9;
            var _S278 : bool;
            if((hit_12.t_1) < (nearest_9.t_1))
            {
                _S278 = true;
            }
            else
            {
                if((hit_12.t_1) == (_S277.t_1))
                {
                    _S278 = (hit_12.instance_2) < (nearest_9.instance_2);
                }
                else
                {
                    _S278 = false;
                }
            }
            var nearest_10 : Hit_0;
            if(_S278)
            {
                ray_24.t_max_1 = hit_12.t_1;
                if(is_any_enough_2)
                {
                    return hit_12;
                }
                nearest_10 = hit_12;
            }
            else
            {
                nearest_10 = nearest_9;
            }
            nearest_9 = nearest_10;
            depth_8 = depth_7;
        }
        else
        {
            var _S279 : u32 = near_2 + u32(1);
            var _S280 : f32 = entry_0(_S279, ray_24, _S276);
            var _S281 : u32 = instance_nodes_0[near_2].index_0;
            var _S282 : f32 = entry_0(instance_nodes_0[near_2].index_0, ray_24, _S276);
            var _S283 : bool = _S280 <= _S282;
            if(_S283)
            {
                near_2 = _S279;
            }
            else
            {
                near_2 = _S281;
            }
            var far_5 : u32;
            if(_S283)
            {
                far_5 = _S281;
            }
            else
            {
                far_5 = _S279;
            }
            var INFINITY_2 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S280, _S282)) < INFINITY_2)
            {
                var _S284 : u32 = depth_7 + u32(1);
                stack_2[depth_7] = far_5;
                depth_8 = _S284;
            }
            else
            {
                depth_8 = depth_7;
            }
            if((min(_S280, _S282)) < INFINITY_2)
            {
                depth_7 = depth_8;
                continue;
            }
        }
        if(depth_8 == u32(0))
        {
            break;
        }
        var depth_9 : u32 = depth_8 - u32(1);
        near_2 = stack_2[depth_9];
        depth_7 = depth_9;
    }
    return nearest_9;
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

fn Work_x24init_0( pixel_8 : u32,  sample_15 : u32,  last_4 : u32) -> Work_0
{
    var _S285 : Work_0;
    _S285.pixel_5 = pixel_8;
    _S285.sample_9 = sample_15;
    _S285.last_3 = last_4;
    return _S285;
}

fn work_of_0( index_8 : u32) -> Work_0
{
    var size_0 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S286 : u32 = size_0.x;
    var _S287 : u32 = u32(8) * _S286;
    var band_0 : u32 = index_8 / _S287;
    var _S288 : u32 = u32(8) * band_0;
    var in_band_0 : u32 = index_8 - _S287 * band_0;
    var _S289 : u32 = u32(8) * min(u32(8), size_0.y - _S288);
    var tile_0 : u32 = in_band_0 / _S289;
    var _S290 : u32 = u32(8) * tile_0;
    var _S291 : u32 = min(u32(8), _S286 - _S290);
    var in_tile_0 : u32 = in_band_0 - _S289 * tile_0;
    var _S292 : vec2<u32> = params_0.region_0.xy;
    var _S293 : u32 = in_tile_0 % _S291;
    var _S294 : u32 = _S290 + _S293;
    var _S295 : u32 = in_tile_0 / _S291;
    var at_2 : vec2<u32> = _S292 + vec2<u32>(_S294, _S288 + _S295);
    return Work_x24init_0(at_2.y * params_0.width_0 + at_2.x, pixels_0[place_of_0(at_2)].samples_0, min(dispatch_0.samples_target_0, pixels_0[place_of_0(at_2)].samples_0 + dispatch_0.samples_1));
}

fn Work_camera_rays_0( this_27 : Work_0) -> u32
{
    return max(this_27.last_3, this_27.sample_9) - this_27.sample_9;
}

fn tally_camera_rays_0( count_6 : u32)
{
    var _S296 : u32 = atomicAdd(&(group_counts_0[i32(0)]), count_6);
    return;
}

fn end_tally_0( counts_2 : RayCounts_0,  thread_1 : u32)
{
    var _S297 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_2.bounce_2);
    var _S298 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_2.shadow_0);
    workgroupBarrier();
    if(thread_1 < u32(3))
    {
        var _S299 : u32 = atomicLoad(&(group_counts_0[thread_1]));
        var _S300 : u32 = atomicAdd(&(counters_0[u32(1) + thread_1]), _S299);
    }
    if(thread_1 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S301 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

fn render_0( index_9 : u32,  thread_2 : u32)
{
    begin_tally_0(thread_2);
    var _S302 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_3 : RayCounts_0;
    if(index_9 < (dispatch_0.count_0))
    {
        var work_2 : Work_0 = work_of_0(dispatch_0.first_0 + index_9);
        tally_camera_rays_0(Work_camera_rays_0(work_2));
        var _S303 : RayCounts_0 = trace_pixel_0(work_2);
        counts_3 = _S303;
    }
    else
    {
        counts_3 = _S302;
    }
    end_tally_0(counts_3, thread_2);
    return;
}

fn render_1( index_10 : u32,  thread_3 : u32)
{
    begin_tally_0(thread_3);
    var _S304 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_4 : RayCounts_0;
    if(index_10 < (dispatch_0.count_0))
    {
        var work_3 : Work_0 = work_of_0(dispatch_0.first_0 + index_10);
        tally_camera_rays_0(Work_camera_rays_0(work_3));
        var _S305 : RayCounts_0 = trace_pixel_1(work_3);
        counts_4 = _S305;
    }
    else
    {
        counts_4 = _S304;
    }
    end_tally_0(counts_4, thread_3);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    render_1(id_0.x, thread_4);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_path(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_5 : u32)
{
    render_0(id_1.x, thread_5);
    return;
}

fn WalkTracer_trace_1( ray_25 : ptr<function, Ray_0>) -> Hit_0
{
    var _S306 : Hit_0 = visit_2(&((*ray_25)), false);
    return _S306;
}

struct HitRecord_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : array<i32, i32(3)>,
     face_0 : u32,
};

fn HitRecord_x24init_0( t_15 : f32,  instance_11 : u32,  voxel_26 : array<i32, i32(3)>,  face_12 : u32) -> HitRecord_0
{
    var _S307 : HitRecord_0;
    _S307.t_0 = t_15;
    _S307.instance_0 = instance_11;
    _S307.voxel_0 = voxel_26;
    _S307.face_0 = face_12;
    return _S307;
}

fn record_of_0( hit_13 : Hit_0) -> HitRecord_0
{
    var _S308 : array<i32, i32(3)> = array<i32, i32(3)>( hit_13.voxel_2.x, hit_13.voxel_2.y, hit_13.voxel_2.z );
    return HitRecord_x24init_0(hit_13.t_1, hit_13.instance_2, _S308, hit_13.face_1);
}

fn ray_of_0( _S309 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S309].origin_0), rays_0[_S309].t_min_0, vector_of_0(rays_0[_S309].direction_0), rays_0[_S309].t_max_0);
}

fn Transform_direction_2( _S310 : i32,  _S311 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S310].grid_from_world_0.x_axis_0) * vec3<f32>(_S311.x) + vector_of_0(instances_0[_S310].grid_from_world_0.y_axis_0) * vec3<f32>(_S311.y) + vector_of_0(instances_0[_S310].grid_from_world_0.z_axis_0) * vec3<f32>(_S311.z);
}

fn Transform_point_2( _S312 : i32,  _S313 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_2(_S312, _S313) + vector_of_0(instances_0[_S312].grid_from_world_0.translation_0);
}

fn local_ray_1( _S314 : Ray_0,  _S315 : i32) -> LocalRay_0
{
    var local_5 : LocalRay_0;
    var direction_10 : vec3<f32>;
    var origin_10 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S316 : vec3<f32> = Transform_point_2(_S315, _S314.origin_2);
        direction_10 = Transform_direction_2(_S315, _S314.direction_1);
        origin_10 = _S316;
    }
    else
    {
        direction_10 = _S314.direction_1;
        origin_10 = _S314.origin_2;
    }
    var is_still_4 : vec3<bool> = !((abs(direction_10)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S317 : vec3<f32> = select(direction_10, vec3<f32>(0.0f), is_still_4);
    local_5.direction_2 = _S317;
    local_5.inverse_0 = select(reciprocal_0(select(direction_10, vec3<f32>(1.0f), is_still_4)), vec3<f32>(3.4028234663852886e+38f), is_still_4);
    local_5.origin_3 = select(origin_10, floor(origin_10) + vec3<f32>(0.5f), is_still_4);
    var speed_4 : f32 = max_element_0(abs(_S317));
    var moves_1 : bool;
    if(speed_4 >= 1.00000004581370497e-18f)
    {
        moves_1 = speed_4 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_1 = false;
    }
    var is_near_1 : bool = (all(((abs(local_5.origin_3)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_1 : bool;
    if((_S314.t_min_1) >= 0.0f)
    {
        is_segment_1 = (_S314.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_1 = false;
    }
    if(is_segment_1)
    {
        is_segment_1 = (_S314.t_min_1) <= (_S314.t_max_1);
    }
    else
    {
        is_segment_1 = false;
    }
    local_5.t_min_2 = _S314.t_min_1;
    local_5.t_max_2 = _S314.t_max_1;
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
    local_5.is_valid_0 = moves_1;
    return local_5;
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_6 : u32)
{
    begin_tally_0(thread_6);
    var _S318 : u32 = id_2.x;
    if(_S318 < (dispatch_0.count_0))
    {
        tally_camera_rays_0(u32(1));
        var _S319 : Ray_0 = ray_of_0(dispatch_0.first_0 + _S318);
        var ray_26 : Ray_0 = _S319;
        var _S320 : Hit_0 = WalkTracer_trace_1(&(ray_26));
        var _S321 : bool;
        if(IS_SINGLE_0)
        {
            _S321 = !IS_EXACT_0;
        }
        else
        {
            _S321 = false;
        }
        if(_S321)
        {
            _S321 = !Hit_is_miss_0(_S320);
        }
        else
        {
            _S321 = false;
        }
        var hit_14 : Hit_0;
        if(_S321)
        {
            hit_14 = hit_of_0(local_ray_1(_S319, i32(0)), _S320.voxel_2, _S320.instance_2);
        }
        else
        {
            hit_14 = _S320;
        }
        var _S322 : HitRecord_0 = record_of_0(hit_14);
        hits_0[dispatch_0.first_0 + _S318].t_0 = _S322.t_0;
        hits_0[dispatch_0.first_0 + _S318].instance_0 = _S322.instance_0;
        hits_0[dispatch_0.first_0 + _S318].voxel_0 = _S322.voxel_0;
        hits_0[dispatch_0.first_0 + _S318].face_0 = _S322.face_0;
    }
    end_tally_0(RayCounts_x24init_0(u32(0), u32(0)), thread_6);
    return;
}

