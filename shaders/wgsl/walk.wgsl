var<private> infinity_bits_0 : u32 = 2139095040u;
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
@binding(3) @group(0) var<storage, read> records_0 : array<vec4<u32>>;

@binding(0) @group(0) var<storage, read> cells_0 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

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
struct RayRecord_std430_0
{
    @align(4) origin_0 : array<f32, i32(3)>,
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
     origin_1 : vec3<f32>,
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

struct Transform_0
{
     x_axis_0 : array<f32, i32(3)>,
     y_axis_0 : array<f32, i32(3)>,
     z_axis_0 : array<f32, i32(3)>,
     translation_0 : array<f32, i32(3)>,
};

struct PackedInstance_0
{
     grid_from_world_0 : Transform_0,
     world_from_grid_0 : Transform_0,
     grid_0 : u32,
     scene_instance_0 : u32,
     light_leaf_0 : u32,
};

fn first_row_0( array_0 : u32) -> u32
{
    return records_0[(array_0 >> (u32(2)))][(array_0 & (u32(3)))];
}

fn Rows_operatorx5Bx5D_get_0( row_0 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(1)) + row_0];
}

fn transform_of_0( a_0 : vec4<u32>,  b_0 : vec4<u32>,  c_0 : vec4<u32>) -> Transform_0
{
    var transform_0 : Transform_0;
    var _S1 : f32 = (bitcast<f32>((a_0.y)));
    var _S2 : f32 = (bitcast<f32>((a_0.z)));
    transform_0.x_axis_0[i32(0)] = (bitcast<f32>((a_0.x)));
    transform_0.x_axis_0[i32(1)] = _S1;
    transform_0.x_axis_0[i32(2)] = _S2;
    var _S3 : f32 = (bitcast<f32>((b_0.x)));
    var _S4 : f32 = (bitcast<f32>((b_0.y)));
    transform_0.y_axis_0[i32(0)] = (bitcast<f32>((a_0.w)));
    transform_0.y_axis_0[i32(1)] = _S3;
    transform_0.y_axis_0[i32(2)] = _S4;
    var _S5 : f32 = (bitcast<f32>((b_0.w)));
    var _S6 : f32 = (bitcast<f32>((c_0.x)));
    transform_0.z_axis_0[i32(0)] = (bitcast<f32>((b_0.z)));
    transform_0.z_axis_0[i32(1)] = _S5;
    transform_0.z_axis_0[i32(2)] = _S6;
    var _S7 : f32 = (bitcast<f32>((c_0.z)));
    var _S8 : f32 = (bitcast<f32>((c_0.w)));
    transform_0.translation_0[i32(0)] = (bitcast<f32>((c_0.y)));
    transform_0.translation_0[i32(1)] = _S7;
    transform_0.translation_0[i32(2)] = _S8;
    return transform_0;
}

fn PackedInstance_x24init_0( grid_from_world_1 : Transform_0,  world_from_grid_1 : Transform_0,  grid_1 : u32,  scene_instance_1 : u32,  light_leaf_1 : u32) -> PackedInstance_0
{
    var _S9 : PackedInstance_0;
    _S9.grid_from_world_0 = grid_from_world_1;
    _S9.world_from_grid_0 = world_from_grid_1;
    _S9.grid_0 = grid_1;
    _S9.scene_instance_0 = scene_instance_1;
    _S9.light_leaf_0 = light_leaf_1;
    return _S9;
}

fn Instances_operatorx5Bx5D_get_0( index_0 : u32) -> PackedInstance_0
{
    var row_1 : u32 = u32(7) * index_0;
    var _S10 : vec4<u32> = Rows_operatorx5Bx5D_get_0(row_1 + u32(6));
    return PackedInstance_x24init_0(transform_of_0(Rows_operatorx5Bx5D_get_0(row_1), Rows_operatorx5Bx5D_get_0(row_1 + u32(1)), Rows_operatorx5Bx5D_get_0(row_1 + u32(2))), transform_of_0(Rows_operatorx5Bx5D_get_0(row_1 + u32(3)), Rows_operatorx5Bx5D_get_0(row_1 + u32(4)), Rows_operatorx5Bx5D_get_0(row_1 + u32(5))), _S10.x, _S10.y, _S10.z);
}

struct LocalRay_0
{
     origin_2 : vec3<f32>,
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

fn Transform_direction_0( this_0 : Transform_0,  v_0 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(this_0.x_axis_0) * vec3<f32>(v_0.x) + vector_of_0(this_0.y_axis_0) * vec3<f32>(v_0.y) + vector_of_0(this_0.z_axis_0) * vec3<f32>(v_0.z);
}

fn Transform_point_0( this_1 : Transform_0,  v_1 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(this_1, v_1) + vector_of_0(this_1.translation_0);
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
    var _S11 : i32 = i32(divisor_0);
    var _S12 : i32 = i32(2) * (rest_0 - units_0 * _S11);
    return guess_0 + u32(units_0 + (i32(_S12 > _S11) - i32(_S12 < (- _S11))));
}

fn divide_0( a_1 : f32,  b_1 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_1 / b_1;
    }
    var _S13 : u32 = (bitcast<u32>((a_1)));
    var exponent_a_0 : u32 = (((_S13 >> (u32(23)))) & (u32(255)));
    var _S14 : u32 = (bitcast<u32>((b_1)));
    var exponent_b_0 : u32 = (((_S14 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S13 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S14 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_1 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S15 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S15 = true;
    }
    else
    {
        _S15 = !is_normal_0(exponent_b_0);
    }
    if(_S15)
    {
        _S15 = true;
    }
    else
    {
        _S15 = !is_normal_0(exponent_1);
    }
    if(_S15)
    {
        return a_1 / b_1;
    }
    return (bitcast<f32>(((((((_S13 ^ (_S14))) & (u32(2147483648)))) | ((((exponent_1 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn reciprocal_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_0.x), divide_0(1.0f, vector_0.y), divide_0(1.0f, vector_0.z));
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn local_ray_0( ray_0 : Ray_0,  grid_from_world_2 : Transform_0) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_3 : vec3<f32>;
    var origin_3 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S16 : vec3<f32> = Transform_point_0(grid_from_world_2, ray_0.origin_1);
        direction_3 = Transform_direction_0(grid_from_world_2, ray_0.direction_1);
        origin_3 = _S16;
    }
    else
    {
        direction_3 = ray_0.direction_1;
        origin_3 = ray_0.origin_1;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_3)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S17 : vec3<f32> = select(direction_3, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_2 = _S17;
    local_0.inverse_0 = select(reciprocal_0(select(direction_3, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_2 = select(origin_3, floor(origin_3) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S17));
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
    if((ray_0.t_min_1) >= 0.0f)
    {
        is_segment_0 = (ray_0.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (ray_0.t_min_1) <= (ray_0.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_2 = ray_0.t_min_1;
    local_0.t_max_2 = ray_0.t_max_1;
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
    var _S18 : Hit_0;
    _S18.t_1 = t_2;
    _S18.instance_1 = instance_3;
    _S18.voxel_1 = voxel_3;
    _S18.face_1 = face_2;
    return _S18;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>(infinity_bits_0)), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

struct PackedGrid_0
{
     origin_4 : array<i32, i32(3)>,
     top_shift_0 : u32,
     top_size_0 : array<i32, i32(3)>,
     top_offset_0 : u32,
     min_0 : array<i32, i32(3)>,
     voxels_0 : array<u32, i32(2)>,
     max_0 : array<i32, i32(3)>,
     material_bits_0 : u32,
};

fn Rows_operatorx5Bx5D_get_1( row_2 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(0)) + row_2];
}

fn Grids_operatorx5Bx5D_get_0( index_1 : u32) -> PackedGrid_0
{
    var row_3 : u32 = u32(5) * index_1;
    var _S19 : vec4<u32> = Rows_operatorx5Bx5D_get_1(row_3);
    var _S20 : vec4<u32> = Rows_operatorx5Bx5D_get_1(row_3 + u32(1));
    var _S21 : vec4<u32> = Rows_operatorx5Bx5D_get_1(row_3 + u32(2));
    var _S22 : vec4<u32> = Rows_operatorx5Bx5D_get_1(row_3 + u32(3));
    var grid_2 : PackedGrid_0;
    var _S23 : i32 = i32(_S19.y);
    var _S24 : i32 = i32(_S19.z);
    grid_2.origin_4[i32(0)] = i32(_S19.x);
    grid_2.origin_4[i32(1)] = _S23;
    grid_2.origin_4[i32(2)] = _S24;
    grid_2.top_shift_0 = _S19.w;
    var _S25 : i32 = i32(_S20.y);
    var _S26 : i32 = i32(_S20.z);
    grid_2.top_size_0[i32(0)] = i32(_S20.x);
    grid_2.top_size_0[i32(1)] = _S25;
    grid_2.top_size_0[i32(2)] = _S26;
    grid_2.top_offset_0 = _S20.w;
    var _S27 : i32 = i32(_S21.y);
    var _S28 : i32 = i32(_S21.z);
    grid_2.min_0[i32(0)] = i32(_S21.x);
    grid_2.min_0[i32(1)] = _S27;
    grid_2.min_0[i32(2)] = _S28;
    var _S29 : u32 = _S22.x;
    grid_2.voxels_0[i32(0)] = _S21.w;
    grid_2.voxels_0[i32(1)] = _S29;
    var _S30 : i32 = i32(_S22.z);
    var _S31 : i32 = i32(_S22.w);
    grid_2.max_0[i32(0)] = i32(_S22.y);
    grid_2.max_0[i32(1)] = _S30;
    grid_2.max_0[i32(2)] = _S31;
    grid_2.material_bits_0 = Rows_operatorx5Bx5D_get_1(row_3 + u32(4)).x;
    return grid_2;
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

struct Walk_0
{
     ray_1 : LocalRay_0,
     origin_5 : vec3<f32>,
     offset_0 : vec3<i32>,
     speed_1 : vec3<f32>,
     inverse_1 : vec3<f32>,
     base_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     octant_0 : u32,
     t_end_0 : f32,
};

fn LocalRay_octant_0( this_2 : LocalRay_0) -> u32
{
    return (((u32((this_2.direction_2.x) < 0.0f) | (((u32((this_2.direction_2.y) < 0.0f) << (u32(1))))))) | (((u32((this_2.direction_2.z) < 0.0f) << (u32(2))))));
}

fn Walk_mirror_0( this_3 : Walk_0) -> vec3<i32>
{
    return (vec3<i32>(0) - vec3<i32>(i32(((this_3.octant_0) & (u32(1)))), i32(((((this_3.octant_0) >> (u32(1)))) & (u32(1)))), i32(((this_3.octant_0) >> (u32(2))))));
}

fn Walk_mirrored_plane_0( this_4 : Walk_0,  plane_0 : vec3<i32>) -> vec3<i32>
{
    var _S32 : vec3<i32> = Walk_mirror_0(this_4);
    return ((plane_0 ^ (_S32))) - _S32;
}

fn LocalRay_mirrored_origin_0( this_5 : LocalRay_0) -> vec3<f32>
{
    return select(this_5.origin_2, (vec3<f32>(0) - this_5.origin_2), (this_5.direction_2) < vec3<f32>(0.0f));
}

fn min_element_0( vector_2 : vec3<f32>) -> f32
{
    return min(min(vector_2.x, vector_2.y), vector_2.z);
}

fn top_shift_of_0( grid_3 : PackedGrid_0) -> u32
{
    var _S33 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        _S33 = TOP_SHIFT_0;
    }
    else
    {
        _S33 = grid_3.top_shift_0;
    }
    return _S33;
}

fn LocalRay_tolerance_0( this_6 : LocalRay_0,  low_0 : vec3<i32>,  high_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_6.origin_2) + (vec3<f32>(max(abs(low_0), abs(high_0))) + vec3<f32>(1.0f))) * vec3<f32>(5.36441802978515625e-07f), vec3<f32>(-1.0f), (this_6.direction_2) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_2 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_from_0( base_1 : vec3<i32>,  ray_2 : LocalRay_0,  grid_4 : PackedGrid_0) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_1 = ray_2;
    walk_0.base_0 = base_1;
    walk_0.octant_0 = LocalRay_octant_0(ray_2);
    var _S34 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S34 = Walk_mirrored_plane_0(walk_0, base_1);
    }
    else
    {
        _S34 = vec3<i32>(i32(0));
    }
    walk_0.offset_0 = _S34;
    walk_0.origin_5 = LocalRay_mirrored_origin_0(ray_2);
    var _S35 : vec3<f32> = abs(ray_2.direction_2);
    var _S36 : vec3<f32> = abs(ray_2.inverse_0);
    var is_still_0 : vec3<bool> = (ray_2.direction_2) == vec3<f32>(0.0f);
    walk_0.speed_1 = select(_S35, vec3<f32>((max_element_0(_S35) * 9.99999993922529029e-09f)), is_still_0);
    walk_0.inverse_1 = select(_S36, vec3<f32>((min_element_0(_S36) * 9.99999986991104e+14f)), is_still_0);
    if(!IS_EXACT_0)
    {
        var _S37 : vec3<f32> = vec3<f32>(base_1);
        walk_0.origin_5 = select(ray_2.origin_2 - _S37, _S37 - ray_2.origin_2, (ray_2.direction_2) < vec3<f32>(0.0f));
        var _S38 : vec3<f32> = max(_S35, vec3<f32>(1.00000004581370497e-18f));
        walk_0.speed_1 = _S38;
        walk_0.inverse_1 = vec3<f32>(1.0f) / _S38;
    }
    var low_1 : vec3<i32> = cell_of_0(grid_4.origin_4);
    walk_0.tolerance_0 = LocalRay_tolerance_0(ray_2, low_1, low_1 + (((cell_of_0(grid_4.top_size_0)) << (vec3<u32>(top_shift_of_0(grid_4))))));
    walk_0.t_end_0 = LocalRay_t_end_0(ray_2);
    return walk_0;
}

fn Walk_mirrored_0( this_8 : Walk_0,  voxel_4 : vec3<i32>) -> vec3<i32>
{
    return (voxel_4 ^ ((Walk_mirror_0(this_8))));
}

fn halves_0( value_0 : f32) -> vec2<f32>
{
    var high_1 : f32 = (bitcast<f32>((((bitcast<u32>((value_0))) & (u32(4294963200))))));
    return vec2<f32>(high_1, value_0 - high_1);
}

fn exact_product_0( a_2 : f32,  b_2 : f32) -> vec2<f32>
{
    var product_0 : f32 = a_2 * b_2;
    if(!IS_EXACT_0)
    {
        return vec2<f32>(product_0, 0.0f);
    }
    var a_parts_0 : vec2<f32> = halves_0(a_2);
    var b_parts_0 : vec2<f32> = halves_0(b_2);
    var _S39 : f32 = a_parts_0.x;
    var _S40 : f32 = b_parts_0.x;
    var _S41 : f32 = b_parts_0.y;
    var _S42 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S39 * _S40 - product_0 + _S39 * _S41 + _S42 * _S40 + _S42 * _S41);
}

fn exact_start_voxel_0( ray_3 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_3.t_min_2, ray_3.direction_2[u32(0)]);
    var _S43 : f32 = way_0.x;
    var sum_0 : f32 = ray_3.origin_2[u32(0)] + _S43;
    var part_0 : f32 = sum_0 - ray_3.origin_2[u32(0)];
    var low_2 : f32 = ray_3.origin_2[u32(0)] - (sum_0 - part_0) + (_S43 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_5 : vec3<i32>;
    var _S44 : i32 = i32(whole_0);
    var _S45 : bool;
    if(sum_0 == whole_0)
    {
        _S45 = low_2 < 0.0f;
    }
    else
    {
        _S45 = false;
    }
    voxel_5[u32(0)] = _S44 - i32(_S45);
    var way_1 : vec2<f32> = exact_product_0(ray_3.t_min_2, ray_3.direction_2[u32(1)]);
    var _S46 : f32 = way_1.x;
    var sum_1 : f32 = ray_3.origin_2[u32(1)] + _S46;
    var part_1 : f32 = sum_1 - ray_3.origin_2[u32(1)];
    var low_3 : f32 = ray_3.origin_2[u32(1)] - (sum_1 - part_1) + (_S46 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_1);
    var _S47 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S45 = low_3 < 0.0f;
    }
    else
    {
        _S45 = false;
    }
    voxel_5[u32(1)] = _S47 - i32(_S45);
    var way_2 : vec2<f32> = exact_product_0(ray_3.t_min_2, ray_3.direction_2[u32(2)]);
    var _S48 : f32 = way_2.x;
    var sum_2 : f32 = ray_3.origin_2[u32(2)] + _S48;
    var part_2 : f32 = sum_2 - ray_3.origin_2[u32(2)];
    var low_4 : f32 = ray_3.origin_2[u32(2)] - (sum_2 - part_2) + (_S48 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_2);
    var _S49 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S45 = low_4 < 0.0f;
    }
    else
    {
        _S45 = false;
    }
    voxel_5[u32(2)] = _S49 - i32(_S45);
    return voxel_5;
}

fn Walk_start_voxel_0( this_9 : Walk_0) -> vec3<i32>
{
    var start_0 : vec3<f32> = clamp(this_9.ray_1.origin_2 + this_9.ray_1.direction_2 * vec3<f32>(this_9.ray_1.t_min_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_9, vec3<i32>(floor(start_0)) - this_9.base_0);
    }
    var nearest_0 : vec3<f32> = round(start_0);
    var from_nearest_0 : vec3<f32> = start_0 - nearest_0;
    var _S50 : bool;
    if((this_9.ray_1.t_min_2) > 0.0f)
    {
        _S50 = (any(((abs(from_nearest_0)) <= (this_9.tolerance_0))));
    }
    else
    {
        _S50 = false;
    }
    if(_S50)
    {
        return Walk_mirrored_0(this_9, exact_start_voxel_0(this_9.ray_1) - this_9.base_0);
    }
    return Walk_mirrored_0(this_9, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_9.base_0);
}

@id(11) override CELLS_SKIP_0 : bool = false;

fn Walk_crossings_0( this_10 : Walk_0,  planes_1 : vec3<i32>) -> vec3<f32>
{
    var _S51 : bool;
    if(IS_EXACT_0)
    {
        _S51 = !CELLS_SKIP_0;
    }
    else
    {
        _S51 = false;
    }
    if(_S51)
    {
        return ((bitcast<vec3<f32>>((planes_1 + this_10.offset_0 + vec3<i32>(i32(1262485504))))) - vec3<f32>(1.2582912e+07f) - this_10.origin_5) * this_10.inverse_1;
    }
    return (vec3<f32>(planes_1 + this_10.offset_0) - this_10.origin_5) * this_10.inverse_1;
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
    var _S52 : Crossing_0;
    _S52.distance_0 = distance_1;
    _S52.distance_low_0 = distance_low_1;
    _S52.speed_2 = speed_3;
    _S52.axis_0 = axis_1;
    return _S52;
}

fn crossing_ahead_0( origin_6 : f32,  speed_4 : f32,  axis_2 : u32,  plane_1 : i32) -> Crossing_0
{
    var at_0 : f32 = f32(plane_1);
    var difference_0 : f32 = at_0 - origin_6;
    var part_3 : f32 = difference_0 - at_0;
    return Crossing_x24init_0(difference_0, at_0 - (difference_0 - part_3) - (origin_6 + part_3), speed_4, axis_2);
}

fn Crossing_is_before_0( this_11 : Crossing_0,  other_0 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_11.distance_0, other_0.speed_2);
    var theirs_0 : vec2<f32> = exact_product_0(other_0.distance_0, this_11.speed_2);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_11.distance_low_0 * other_0.speed_2;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_0.distance_low_0 * this_11.speed_2;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S53 : bool;
    if(difference_1 < 0.0f)
    {
        _S53 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S53 = (this_11.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S53 = false;
        }
    }
    return _S53;
}

fn crossing_among_0( origin_7 : vec3<f32>,  speed_5 : vec3<f32>,  planes_2 : vec3<i32>,  is_first_0 : bool) -> Crossing_0
{
    var _S54 : bool;
    var found_0 : Crossing_0;
    var _S55 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if((speed_5[u32(0)]) == 0.0f)
                {
                    found_0 = _S55;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_ahead_0(origin_7[u32(0)], speed_5[u32(0)], u32(0), planes_2[u32(0)]);
                if((_S55.axis_0) == u32(3))
                {
                    _S54 = true;
                }
                else
                {
                    _S54 = (Crossing_is_before_0(crossing_0, _S55)) == is_first_0;
                }
                if(_S54)
                {
                    found_0 = crossing_0;
                }
                else
                {
                    found_0 = _S55;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if((speed_5[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_ahead_0(origin_7[u32(1)], speed_5[u32(1)], u32(1), planes_2[u32(1)]);
                if((found_0.axis_0) == u32(3))
                {
                    _S54 = true;
                }
                else
                {
                    _S54 = (Crossing_is_before_0(crossing_1, found_0)) == is_first_0;
                }
                if(_S54)
                {
                    found_0 = crossing_1;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if((speed_5[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_ahead_0(origin_7[u32(2)], speed_5[u32(2)], u32(2), planes_2[u32(2)]);
                if((found_0.axis_0) == u32(3))
                {
                    _S54 = true;
                }
                else
                {
                    _S54 = (Crossing_is_before_0(crossing_2, found_0)) == is_first_0;
                }
                if(_S54)
                {
                    found_0 = crossing_2;
                }
                break;
            }
            break;
        }
        break;
    }
    return found_0;
}

fn leave_box_0( origin_8 : vec3<f32>,  speed_6 : vec3<f32>,  voxel_6 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_1 : vec3<i32>) -> vec3<i32>
{
    var is_crossed_0 : bool;
    var plane_2 : i32;
    var _S56 : Crossing_0 = crossing_among_0(origin_8, speed_6, exit_0, true);
    var arrival_0 : vec3<i32> = voxel_6;
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if((speed_6[u32(0)]) == 0.0f)
                {
                    break;
                }
                var _S57 : bool = u32(0) == (_S56.axis_0);
                if(_S57)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(0)], speed_6[u32(0)], u32(0), nearest_1[u32(0)]), _S56);
                }
                if(_S57)
                {
                    plane_2 = exit_0[u32(0)];
                }
                else
                {
                    plane_2 = nearest_1[u32(0)];
                }
                arrival_0[u32(0)] = plane_2 - i32(!is_crossed_0);
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if((speed_6[u32(1)]) == 0.0f)
                {
                    break;
                }
                var _S58 : bool = u32(1) == (_S56.axis_0);
                if(_S58)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(1)], speed_6[u32(1)], u32(1), nearest_1[u32(1)]), _S56);
                }
                if(_S58)
                {
                    plane_2 = exit_0[u32(1)];
                }
                else
                {
                    plane_2 = nearest_1[u32(1)];
                }
                arrival_0[u32(1)] = plane_2 - i32(!is_crossed_0);
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if((speed_6[u32(2)]) == 0.0f)
                {
                    break;
                }
                var _S59 : bool = u32(2) == (_S56.axis_0);
                if(_S59)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(2)], speed_6[u32(2)], u32(2), nearest_1[u32(2)]), _S56);
                }
                if(_S59)
                {
                    plane_2 = exit_0[u32(2)];
                }
                else
                {
                    plane_2 = nearest_1[u32(2)];
                }
                arrival_0[u32(2)] = plane_2 - i32(!is_crossed_0);
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn Walk_arrive_0( this_12 : Walk_0,  voxel_7 : vec3<i32>,  t_3 : f32,  is_axis_0 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_0 : vec3<f32> = this_12.origin_5 + this_12.speed_1 * vec3<f32>(t_3);
    if(IS_EXACT_0)
    {
        var position_1 : vec3<f32> = clamp(position_0, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_2 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_2;
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_0, (abs(from_nearest_1)) <= (this_12.tolerance_0)))))))
        {
            return max(leave_box_0(this_12.origin_5, this_12.speed_1, voxel_7 + this_12.offset_0, exit_1 + this_12.offset_0, vec3<i32>(nearest_2)) - this_12.offset_0, voxel_7);
        }
        return select(vec3<i32>(nearest_2) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f)) - this_12.offset_0, exit_1, is_axis_0);
    }
    return max(vec3<i32>(floor(position_0)), select(voxel_7, exit_1, is_axis_0));
}

fn Walk_enter_rounded_0( this_13 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  near_0 : vec3<i32>,  far_0 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_8) < near_0;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_13.speed_1) <= vec3<f32>(1.00000004581370497e-18f), is_before_0)))))
        {
            return false;
        }
        var t_4 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_13, near_0), is_before_0);
        var t_last_0 : f32 = max_element_0(t_4);
        if(t_last_0 > (this_13.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_4.x) == t_last_0;
        var _S60 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S60)
        {
            is_y_0 = (t_4.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S61 : bool;
        if(_S60)
        {
            _S61 = !is_y_0;
        }
        else
        {
            _S61 = false;
        }
        var is_axis_1 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S61);
        (*voxel_8) = Walk_arrive_0(this_13, (*voxel_8), t_last_0, is_axis_1, select(vec3<i32>(i32(1073741823)), near_0, is_axis_1));
    }
    return (all(((*voxel_8) < far_0)));
}

fn Walk_leave_rounded_0( this_14 : Walk_0,  voxel_9 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_5 : vec3<f32> = Walk_crossings_0(this_14, exit_2);
    var t_first_0 : f32 = min_element_0(t_5);
    if(t_first_0 >= (this_14.t_end_0))
    {
        return false;
    }
    (*voxel_9) = max(exit_2 - vec3<i32>(ceil((t_5 - vec3<f32>(t_first_0)) * this_14.speed_1)), (*voxel_9));
    return true;
}

fn Walk_leave_0( this_15 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S62 : bool = Walk_leave_rounded_0(this_15, &((*voxel_10)), exit_3);
        return _S62;
    }
    var t_6 : vec3<f32> = Walk_crossings_0(this_15, exit_3);
    var t_first_1 : f32 = min_element_0(t_6);
    if(t_first_1 > (this_15.t_end_0))
    {
        return false;
    }
    var back_0 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_6 - vec3<f32>(t_first_1), this_15.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S63 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_0 : vec3<f32> = back_0 + _S63;
    var _S64 : vec3<i32> = exit_3 - ((bitcast<vec3<i32>>((rounded_0))) - vec3<i32>(i32(1262485504)));
    var _S65 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_0 : vec3<bool> = (abs(rounded_0 - _S63 - back_0)) >= (_S65 - this_15.tolerance_0);
    var _S66 : bool = is_unsure_0.x;
    var _S67 : bool;
    if(_S66)
    {
        _S67 = is_unsure_0.y;
    }
    else
    {
        _S67 = false;
    }
    if(_S67)
    {
        _S67 = true;
    }
    else
    {
        if(_S66)
        {
            _S67 = true;
        }
        else
        {
            _S67 = is_unsure_0.y;
        }
        if(_S67)
        {
            _S67 = is_unsure_0.z;
        }
        else
        {
            _S67 = false;
        }
    }
    var arrival_1 : vec3<i32>;
    if(_S67)
    {
        arrival_1 = leave_box_0(this_15.origin_5, this_15.speed_1, (*voxel_10) + this_15.offset_0, exit_3 + this_15.offset_0, exit_3 - vec3<i32>(round(back_0 - _S65)) + this_15.offset_0) - this_15.offset_0;
    }
    else
    {
        arrival_1 = _S64;
    }
    (*voxel_10) = max(arrival_1, (*voxel_10));
    return true;
}

fn Walk_enter_0( this_16 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  low_5 : vec3<i32>,  high_2 : vec3<i32>) -> bool
{
    var _S68 : bool;
    var is_mirrored_0 : vec3<bool> = (Walk_mirror_0(this_16)) != vec3<i32>(i32(0));
    var near_1 : vec3<i32> = select(low_5, (vec3<i32>(0) - high_2), is_mirrored_0);
    var far_1 : vec3<i32> = select(high_2, (vec3<i32>(0) - low_5), is_mirrored_0);
    if(!IS_EXACT_0)
    {
        var _S69 : bool = Walk_enter_rounded_0(this_16, &((*voxel_11)), near_1, far_1);
        return _S69;
    }
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
            _S68 = (any(((*voxel_11) < near_1)));
        }
        else
        {
            _S68 = false;
        }
        var _S70 : bool;
        if(_S68)
        {
            _S70 = (all(((*voxel_11) < far_1)));
        }
        else
        {
            _S70 = false;
        }
        if(_S70)
        {
        }
        else
        {
            break;
        }
        var _S71 : bool = Walk_leave_0(this_16, &((*voxel_11)), select(far_1, near_1, (*voxel_11) < near_1));
        if(!_S71)
        {
            return false;
        }
        axis_3 = axis_3 + u32(1);
    }
    if((all(((*voxel_11) >= near_1))))
    {
        _S68 = (all(((*voxel_11) < far_1)));
    }
    else
    {
        _S68 = false;
    }
    return _S68;
}

fn flip_of_0( octant_1 : u32) -> u32
{
    return ((((((octant_1 & (u32(1)))) | (((((octant_1 & (u32(2)))) << (u32(1))))))) | (((((octant_1 & (u32(4)))) << (u32(2))))))) * u32(3);
}

fn dot_cells_0( a_3 : vec3<i32>,  b_3 : vec3<i32>) -> i32
{
    return a_3.x * b_3.x + a_3.y * b_3.y + a_3.z * b_3.z;
}

fn ahead_of_0( mirror_0 : vec3<i32>) -> u32
{
    var bits_0 : vec3<u32> = (vec3<u32>(~mirror_0) & (vec3<u32>(u32(31), u32(992), u32(31744))));
    return ((((bits_0.x) | ((bits_0.y)))) | ((bits_0.z)));
}

fn place_of_cell_0( index_2 : u32) -> u32
{
    return index_2;
}

fn cell_word_0( index_3 : u32) -> u32
{
    return cells_0[place_of_cell_0(index_3)];
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

fn waits_for_pages_0() -> bool
{
    return false;
}

fn skip_distance_0( cell_1 : u32,  octant_2 : u32) -> u32
{
    var code_0 : u32 = (((cell_1 >> ((u32(3) * octant_2)))) & (u32(7)));
    var _S72 : u32;
    if(code_0 < u32(2))
    {
        _S72 = code_0 + u32(1);
    }
    else
    {
        _S72 = ((u32(3) + ((code_0 & (u32(1))))) << ((((code_0 >> (u32(1)))) - u32(1))));
    }
    return _S72;
}

fn extents_0( cell_2 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_2 & (ahead_0))) | (((((cell_2 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_3 : u32) -> u32
{
    var _S73 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S73 = u32(8388607);
    }
    else
    {
        _S73 = u32(2147483647);
    }
    return ((cell_3 & (_S73))) * u32(2);
}

fn blocks_of_cell_0( cell_4 : u32) -> u32
{
    return (((cell_4 >> (u32(23)))) & (u32(255)));
}

fn place_of_brick_0( index_4 : u32) -> u32
{
    return index_4;
}

fn brick_word_0( index_5 : u32) -> u32
{
    return bricks_0[place_of_brick_0(index_5)];
}

fn blocks_of_record_0( record_0 : u32) -> u32
{
    return ((brick_word_0(record_0)) & (u32(255)));
}

fn empty_around_0( record_1 : u32,  blocks_0 : u32,  voxel_12 : vec3<i32>,  octant_3 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_12.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_12.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_12.z) & (i32(4))))))) ^ (octant_3));
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
    var _S74 : i32;
    if(((((half_0 >> (((bit_0 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S74 = i32(1);
    }
    else
    {
        _S74 = i32(0);
    }
    return u32(_S74);
}

fn Walk_leave_1( this_17 : Walk_0,  voxel_13 : ptr<function, vec3<i32>>,  exit_4 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S75 : bool = Walk_leave_rounded_0(this_17, &((*voxel_13)), exit_4);
        return _S75;
    }
    var t_7 : vec3<f32> = Walk_crossings_0(this_17, exit_4);
    var t_first_2 : f32 = min_element_0(t_7);
    if(t_first_2 > (this_17.t_end_0))
    {
        return false;
    }
    var back_1 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_7 - vec3<f32>(t_first_2), this_17.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S76 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_1 : vec3<f32> = back_1 + _S76;
    var _S77 : vec3<i32> = exit_4 - ((bitcast<vec3<i32>>((rounded_1))) - vec3<i32>(i32(1262485504)));
    var _S78 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_1 : vec3<bool> = (abs(rounded_1 - _S76 - back_1)) >= (_S78 - this_17.tolerance_0);
    var _S79 : bool = is_unsure_1.x;
    var _S80 : bool;
    if(_S79)
    {
        _S80 = is_unsure_1.y;
    }
    else
    {
        _S80 = false;
    }
    if(_S80)
    {
        _S80 = true;
    }
    else
    {
        if(_S79)
        {
            _S80 = true;
        }
        else
        {
            _S80 = is_unsure_1.y;
        }
        if(_S80)
        {
            _S80 = is_unsure_1.z;
        }
        else
        {
            _S80 = false;
        }
    }
    var arrival_2 : vec3<i32>;
    if(_S80)
    {
        arrival_2 = leave_box_0(this_17.origin_5, this_17.speed_1, (*voxel_13) + this_17.offset_0, exit_4 + this_17.offset_0, exit_4 - vec3<i32>(round(back_1 - _S78)) + this_17.offset_0) - this_17.offset_0;
    }
    else
    {
        arrival_2 = _S77;
    }
    (*voxel_13) = max(arrival_2, (*voxel_13));
    return true;
}

fn first_voxel_0( grid_5 : PackedGrid_0,  walk_1 : Walk_0,  found_1 : ptr<function, vec3<i32>>) -> bool
{
    var _S81 : Walk_0 = walk_1;
    var _S82 : vec3<i32> = vec3<i32>(i32(0));
    (*found_1) = _S82;
    var voxel_14 : vec3<i32> = Walk_start_voxel_0(walk_1);
    var _S83 : bool = Walk_enter_0(walk_1, &(voxel_14), cell_of_0(grid_5.min_0) - _S81.base_0, cell_of_0(grid_5.max_0) - _S81.base_0);
    if(!_S83)
    {
        return false;
    }
    var octant_4 : u32 = _S81.octant_0;
    var _S84 : u32 = flip_of_0(_S81.octant_0);
    var top_shift_1 : u32 = top_shift_of_0(grid_5);
    var top_size_1 : vec3<i32> = cell_of_0(grid_5.top_size_0);
    var low_6 : vec3<i32> = cell_of_0(grid_5.origin_4) - _S81.base_0;
    var _S85 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S85, _S85 * top_size_1.y);
    var _S86 : vec3<u32> = vec3<u32>(top_shift_1);
    var _S87 : i32 = i32(grid_5.top_offset_0) - dot_cells_0((stride_0 & ((Walk_mirror_0(_S81)))), vec3<i32>(i32(1))) - dot_cells_0(stride_0, (low_6 >> (_S86)));
    var _S88 : vec3<i32> = Walk_mirrored_plane_0(_S81, stride_0);
    var _S89 : u32 = ahead_of_0(Walk_mirror_0(_S81));
    var end_0 : vec3<i32> = Walk_mirrored_plane_0(_S81, select(low_6 + ((top_size_1 << (_S86))), low_6, (Walk_mirror_0(_S81)) != _S82));
    if(!IS_EXACT_0)
    {
        _S81.t_end_0 = min(_S81.t_end_0, min_element_0(Walk_crossings_0(_S81, end_0)));
    }
    var is_found_0 : bool = false;
    for(;;)
    {
        var _S90 : bool;
        if(IS_EXACT_0)
        {
            _S90 = (any((voxel_14 >= end_0)));
        }
        else
        {
            _S90 = false;
        }
        if(_S90)
        {
            break;
        }
        var cell_5 : u32 = cell_word_0(u32(_S87 + dot_cells_0(_S88, (voxel_14 >> (_S86)))));
        var is_found_1 : bool;
        var cell_6 : u32;
        var shift_1 : u32;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_5 & (u32(2147483648)))) != u32(0))
            {
                cell_6 = cell_word_0(((cell_5 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_14, u32(3))) ^ (_S84))));
                shift_1 = u32(3);
            }
            else
            {
                cell_6 = cell_5;
                shift_1 = top_shift_1;
            }
        }
        else
        {
            cell_6 = cell_5;
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
                cell_6 = cell_word_0(((cell_6 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_14, shift_2)) ^ (_S84))));
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
                exit_5 = vec3<i32>((i32(skip_distance_0(cell_6, octant_4)) - i32(1)));
            }
            else
            {
                exit_5 = extents_0(cell_6, _S89);
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
                blocks_1 = blocks_of_record_0(record_2);
            }
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_14, octant_4, _S84);
            var is_found_2 : bool = low_bits_0 == u32(4294967295);
            if(is_found_2)
            {
                is_found_0 = is_found_2;
                break;
            }
            exit_5 = ((voxel_14 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_1 = is_found_2;
        }
        var _S92 : bool = Walk_leave_1(_S81, &(voxel_14), exit_5);
        if(!_S92)
        {
            is_found_0 = is_found_1;
            break;
        }
        is_found_0 = is_found_1;
    }
    (*found_1) = Walk_mirrored_0(_S81, voxel_14) + _S81.base_0;
    return is_found_0;
}

fn Ray_x24init_0( origin_9 : vec3<f32>,  t_min_3 : f32,  direction_4 : vec3<f32>,  t_max_3 : f32) -> Ray_0
{
    var _S93 : Ray_0;
    _S93.origin_1 = origin_9;
    _S93.t_min_1 = t_min_3;
    _S93.direction_1 = direction_4;
    _S93.t_max_1 = t_max_3;
    return _S93;
}

fn ray_of_walk_0( walk_2 : Walk_0,  ray_4 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (Walk_mirror_0(walk_2)) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_2.origin_5, (vec3<f32>(0) - walk_2.origin_5), is_mirrored_1) + vec3<f32>(walk_2.base_0), ray_4.t_min_1, select(walk_2.speed_1, (vec3<f32>(0) - walk_2.speed_1), is_mirrored_1), ray_4.t_max_1);
}

fn hit_at_0( last_0 : Crossing_0,  t_min_4 : f32,  inverse_2 : vec3<f32>,  voxel_15 : vec3<i32>,  instance_4 : u32,  octant_5 : u32) -> Hit_0
{
    var t_8 : f32 = last_0.distance_0 * inverse_2[last_0.axis_0];
    var _S94 : f32;
    if(t_8 > t_min_4)
    {
        _S94 = t_8;
    }
    else
    {
        _S94 = t_min_4;
    }
    return Hit_x24init_0(_S94, instance_4, voxel_15, u32(2) * last_0.axis_0 + ((((octant_5 >> ((last_0.axis_0)))) & (u32(1)))));
}

fn hit_of_walk_0( walk_3 : Walk_0,  voxel_16 : vec3<i32>,  instance_5 : u32) -> Hit_0
{
    var planes_3 : vec3<i32> = Walk_mirrored_0(walk_3, voxel_16 - walk_3.base_0);
    if(IS_EXACT_0)
    {
        return hit_at_0(crossing_among_0(walk_3.origin_5, walk_3.speed_1, planes_3 + walk_3.offset_0, false), walk_3.ray_1.t_min_2, walk_3.inverse_1, voxel_16, instance_5, walk_3.octant_0);
    }
    var t_9 : vec3<f32> = Walk_crossings_0(walk_3, planes_3);
    var last_1 : f32 = max_element_0(t_9);
    var _S95 : i32;
    if((t_9.z) == last_1)
    {
        _S95 = i32(2);
    }
    else
    {
        if((t_9.y) == last_1)
        {
            _S95 = i32(1);
        }
        else
        {
            _S95 = i32(0);
        }
    }
    var axis_4 : u32 = u32(_S95);
    return Hit_x24init_0(max(last_1, walk_3.ray_1.t_min_2), instance_5, voxel_16, u32(2) * axis_4 + (((((walk_3.octant_0) >> (axis_4))) & (u32(1)))));
}

fn hit_in_0( instance_6 : u32,  ray_5 : ptr<function, Ray_0>) -> Hit_0
{
    var local_1 : LocalRay_0 = local_ray_0((*ray_5), Instances_operatorx5Bx5D_get_0(instance_6).grid_from_world_0);
    if(!local_1.is_valid_0)
    {
        return miss_0();
    }
    var _S96 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(instance_6).grid_0);
    var _S97 : bool;
    if(IS_EXACT_0)
    {
        _S97 = TOP_SHIFT_0 == u32(3);
    }
    else
    {
        _S97 = false;
    }
    var base_2 : vec3<i32>;
    if(_S97)
    {
        base_2 = vec3<i32>(i32(0));
    }
    else
    {
        base_2 = cell_of_0(_S96.origin_4);
    }
    var walk_4 : Walk_0 = walk_from_0(base_2, local_1, _S96);
    var voxel_17 : vec3<i32>;
    var is_found_3 : bool = first_voxel_0(_S96, walk_4, &(voxel_17));
    if(IS_SINGLE_0)
    {
        _S97 = !IS_EXACT_0;
    }
    else
    {
        _S97 = false;
    }
    if(_S97)
    {
        (*ray_5) = ray_of_walk_0(walk_4, (*ray_5));
    }
    if(!is_found_3)
    {
        return miss_0();
    }
    var hit_0 : Hit_0 = hit_of_walk_0(walk_4, voxel_17, instance_6);
    if((hit_0.t_1) > ((*ray_5).t_max_1))
    {
        return miss_0();
    }
    return hit_0;
}

struct InstanceNode_0
{
     min_1 : array<f32, i32(3)>,
     index_6 : u32,
     max_1 : array<f32, i32(3)>,
     is_leaf_0 : u32,
};

fn Rows_operatorx5Bx5D_get_2( row_4 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(2)) + row_4];
}

fn InstanceNodes_operatorx5Bx5D_get_0( index_7 : u32) -> InstanceNode_0
{
    var _S98 : u32 = u32(2) * index_7;
    var _S99 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S98);
    var _S100 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S98 + u32(1));
    var node_0 : InstanceNode_0;
    var _S101 : f32 = (bitcast<f32>((_S99.y)));
    var _S102 : f32 = (bitcast<f32>((_S99.z)));
    node_0.min_1[i32(0)] = (bitcast<f32>((_S99.x)));
    node_0.min_1[i32(1)] = _S101;
    node_0.min_1[i32(2)] = _S102;
    node_0.index_6 = _S99.w;
    var _S103 : f32 = (bitcast<f32>((_S100.y)));
    var _S104 : f32 = (bitcast<f32>((_S100.z)));
    node_0.max_1[i32(0)] = (bitcast<f32>((_S100.x)));
    node_0.max_1[i32(1)] = _S103;
    node_0.max_1[i32(2)] = _S104;
    node_0.is_leaf_0 = _S100.w;
    return node_0;
}

fn entry_0( node_1 : InstanceNode_0,  ray_6 : Ray_0,  inverse_3 : vec3<f32>) -> f32
{
    var low_7 : vec3<f32> = (vector_of_0(node_1.min_1) - ray_6.origin_1) * inverse_3;
    var high_3 : vec3<f32> = (vector_of_0(node_1.max_1) - ray_6.origin_1) * inverse_3;
    var _S105 : f32 = max(ray_6.t_min_1, max_element_0(min(low_7, high_3)));
    var _S106 : f32;
    if(_S105 <= (min(ray_6.t_max_1, min_element_0(max(low_7, high_3)))))
    {
        _S106 = _S105;
    }
    else
    {
        _S106 = (bitcast<f32>(infinity_bits_0));
    }
    return _S106;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool,  end_1 : u32) -> Hit_0
{
    var is_leaf_1 : bool;
    if(IS_SINGLE_0)
    {
        var _S107 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S107;
    }
    var ray_7 : Ray_0 = (*given_0);
    var nearest_3 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_3;
    }
    var is_zero_1 : vec3<bool> = !((abs(ray_7.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S108 : vec3<f32> = select(reciprocal_0(select(ray_7.direction_1, vec3<f32>(1.0f), is_zero_1)), vec3<f32>(3.4028234663852886e+38f), is_zero_1);
    var stack_0 : array<u32, i32(32)>;
    var entries_0 : array<f32, i32(32)>;
    var _S109 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(u32(0));
    var _S110 : bool = (InstanceNodes_operatorx5Bx5D_get_0(u32(0)).is_leaf_0) != u32(0);
    var is_done_0 : bool = false;
    var is_leaf_2 : bool = _S110;
    var index_8 : u32 = u32(0);
    var below_0 : u32 = _S109.index_6;
    var nearest_4 : Hit_0 = nearest_3;
    var depth_0 : u32 = u32(0);
    for(;;)
    {
        var is_done_1 : bool = is_done_0;
        var below_1 : u32 = below_0;
        var depth_1 : u32 = depth_0;
        for(;;)
        {
            var _S111 : bool;
            if(is_done_1)
            {
                _S111 = depth_1 > u32(0);
            }
            else
            {
                _S111 = !is_leaf_2;
            }
            if(_S111)
            {
            }
            else
            {
                break;
            }
            var index_9 : u32;
            if(is_done_1)
            {
                var depth_2 : u32 = depth_1 - u32(1);
                var _S112 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]);
                var _S113 : bool = (InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]).is_leaf_0) != u32(0);
                is_done_1 = (entries_0[depth_2]) > (ray_7.t_max_1);
                is_leaf_1 = _S113;
                index_9 = stack_0[depth_2];
                below_1 = _S112.index_6;
                depth_1 = depth_2;
            }
            else
            {
                var _S114 : u32 = index_8 + u32(1);
                var _S115 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(_S114);
                var _S116 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(below_1);
                var to_left_0 : f32 = entry_0(_S115, ray_7, _S108);
                var to_right_0 : f32 = entry_0(_S116, ray_7, _S108);
                var is_left_0 : bool = to_left_0 <= to_right_0;
                var _S117 : f32 = max(to_left_0, to_right_0);
                var INFINITY_0 : f32 = (bitcast<f32>(infinity_bits_0));
                if(_S117 < INFINITY_0)
                {
                    if(is_left_0)
                    {
                        index_9 = below_1;
                    }
                    else
                    {
                        index_9 = _S114;
                    }
                    stack_0[depth_1] = index_9;
                    entries_0[depth_1] = _S117;
                    index_9 = depth_1 + u32(1);
                }
                else
                {
                    index_9 = depth_1;
                }
                var _S118 : bool = (min(to_left_0, to_right_0)) == INFINITY_0;
                var _S119 : u32;
                if(is_left_0)
                {
                    _S119 = _S114;
                }
                else
                {
                    _S119 = below_1;
                }
                var _S120 : u32;
                if(is_left_0)
                {
                    _S120 = _S115.index_6;
                }
                else
                {
                    _S120 = _S116.index_6;
                }
                var _S121 : u32;
                if(is_left_0)
                {
                    _S121 = _S115.is_leaf_0;
                }
                else
                {
                    _S121 = _S116.is_leaf_0;
                }
                var _S122 : bool = _S121 != u32(0);
                var _S123 : u32 = index_9;
                is_done_1 = _S118;
                is_leaf_1 = _S122;
                index_9 = _S119;
                below_1 = _S120;
                depth_1 = _S123;
            }
            is_leaf_2 = is_leaf_1;
            index_8 = index_9;
        }
        if(is_done_1)
        {
            break;
        }
        var _S124 : Hit_0 = hit_in_0(below_1, &(ray_7));
        var _S125 : Hit_0 = nearest_4;
        if((_S124.t_1) < (nearest_4.t_1))
        {
            is_leaf_1 = true;
        }
        else
        {
            if((_S124.t_1) == (_S125.t_1))
            {
                is_leaf_1 = (_S124.instance_1) < (nearest_4.instance_1);
            }
            else
            {
                is_leaf_1 = false;
            }
        }
        if(is_leaf_1)
        {
            ray_7.t_max_1 = _S124.t_1;
            if(is_any_enough_0)
            {
                return _S124;
            }
            nearest_4 = _S124;
        }
        is_done_0 = true;
        below_0 = below_1;
        depth_0 = depth_1;
    }
    return nearest_4;
}

fn WalkTracer_trace_0( ray_8 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    var _S126 : Hit_0 = visit_0(&((*ray_8)), is_any_enough_1, u32(0));
    return _S126;
}

fn hit_of_ray_0( sampler_1 : Sampler_0,  ray_9 : ptr<function, Ray_0>,  is_shadow_ray_0 : bool,  path_0 : ptr<function, Path_0>,  shadow_inside_0 : ptr<function, Inside_0>,  relocates_0 : ptr<function, bool>,  path_relocates_0 : ptr<function, bool>,  beyond_0 : ptr<function, u32>) -> Hit_0
{
    (*beyond_0) = u32(4294967295);
    var _S127 : Hit_0 = WalkTracer_trace_0(&((*ray_9)), is_shadow_ray_0);
    return _S127;
}

fn Sampler_x24init_0( seed_2 : u32,  pixel_1 : u32,  sample_1 : u32) -> Sampler_0
{
    var _S128 : Sampler_0;
    _S128.seed_1 = seed_2;
    _S128.pixel_0 = pixel_1;
    _S128.sample_0 = sample_1;
    return _S128;
}

fn sampler_of_0( pixel_2 : u32,  sample_2 : u32) -> Sampler_0
{
    return Sampler_x24init_0(params_0.seed_0, pixel_2, params_0.first_sample_0 + sample_2);
}

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S129 : Selection_0;
    _S129.sun_0 = sun_1;
    _S129.sky_1 = sky_2;
    _S129.emitters_0 = emitters_1;
    return _S129;
}

fn Inside_x24init_0( instance_7 : u32,  voxel_18 : vec3<i32>,  material_1 : u32) -> Inside_0
{
    var _S130 : Inside_0;
    _S130.instance_2 = instance_7;
    _S130.voxel_2 = voxel_18;
    _S130.material_0 = material_1;
    return _S130;
}

fn in_air_0() -> Inside_0
{
    return Inside_x24init_0(u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn Path_x24init_0( sampler_2 : Sampler_0,  bounce_1 : u32,  event_1 : u32,  kinds_1 : u32,  scattered_1 : u32,  beta_1 : vec3<f32>,  pdf_2 : f32,  normal_1 : vec3<f32>,  selection_1 : Selection_0,  passed_t_1 : f32,  inside_1 : Inside_0,  is_clipped_1 : bool) -> Path_0
{
    var _S131 : Path_0;
    _S131.sampler_0 = sampler_2;
    _S131.bounce_0 = bounce_1;
    _S131.event_0 = event_1;
    _S131.kinds_0 = kinds_1;
    _S131.scattered_0 = scattered_1;
    _S131.beta_0 = beta_1;
    _S131.pdf_1 = pdf_2;
    _S131.normal_0 = normal_1;
    _S131.selection_0 = selection_1;
    _S131.passed_t_0 = passed_t_1;
    _S131.inside_0 = inside_1;
    _S131.is_clipped_0 = is_clipped_1;
    return _S131;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S132 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_2 : vec4<u32> = _S132;
    v_2[i32(0)] = v_2[i32(0)] + _S132.y * _S132.w;
    v_2[i32(1)] = v_2[i32(1)] + v_2.z * v_2.x;
    v_2[i32(2)] = v_2[i32(2)] + v_2.x * v_2.y;
    v_2[i32(3)] = v_2[i32(3)] + v_2.y * v_2.z;
    var _S133 : vec4<u32> = (v_2 ^ (((v_2 >> (vec4<u32>(u32(16)))))));
    v_2 = _S133;
    v_2[i32(0)] = v_2[i32(0)] + _S133.y * _S133.w;
    v_2[i32(1)] = v_2[i32(1)] + v_2.z * v_2.x;
    v_2[i32(2)] = v_2[i32(2)] + v_2.x * v_2.y;
    v_2[i32(3)] = v_2[i32(3)] + v_2.y * v_2.z;
    return v_2;
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
    var index_10 : u32 = owen_of_reversed_0(reverseBits(sample_3), order_0);
    var binomial_0 : u32 = (index_10 ^ (((((index_10 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_10, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_18 : Sampler_0,  dimension_0 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_1 : vec4<u32> = pcg4d_0(vec4<u32>(this_18.pixel_0, dimension_0, this_18.seed_1, which_0));
    return scrambled_sobol_0(this_18.sample_0, words_1.x, words_1.yz);
}

fn unit_float_0( words_2 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_2 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_stratified_0( this_19 : Sampler_0,  dimension_1 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_19, dimension_1, u32(1)), Sampler_pair_0(this_19, dimension_1, u32(2))));
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
    var _S134 : CameraFrame_0;
    _S134.lens_1 = lens_2;
    _S134.eye_1 = eye_2;
    _S134.corner_1 = corner_2;
    _S134.pixel_x_1 = pixel_x_2;
    _S134.pixel_y_1 = pixel_y_2;
    _S134.lens_x_1 = lens_x_2;
    _S134.lens_y_1 = lens_y_2;
    _S134.blades_1 = blades_2;
    return _S134;
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
    var _S135 : Perspective_0;
    _S135.eye_3 = eye_4;
    _S135.corner_3 = corner_4;
    _S135.pixel_x_3 = pixel_x_4;
    _S135.pixel_y_3 = pixel_y_4;
    return _S135;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_0 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_1 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S136 : Axes_0;
    _S136.forward_0 = forward_1;
    _S136.right_0 = right_1;
    _S136.up_0 = up_1;
    return _S136;
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
    var _S137 : ThinLens_0;
    _S137.perspective_0 = perspective_1;
    _S137.lens_x_3 = lens_x_4;
    _S137.lens_y_3 = lens_y_4;
    _S137.blades_3 = blades_4;
    return _S137;
}

fn concentric_0( square_0 : vec2<f32>) -> vec2<f32>
{
    var a_4 : f32 = 2.0f * square_0.x - 1.0f;
    var b_4 : f32 = 2.0f * square_0.y - 1.0f;
    var _S138 : bool;
    if(a_4 == 0.0f)
    {
        _S138 = b_4 == 0.0f;
    }
    else
    {
        _S138 = false;
    }
    if(_S138)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_4)) > (abs(b_4));
    var radius_0 : f32;
    if(is_across_0)
    {
        radius_0 = a_4;
    }
    else
    {
        radius_0 = b_4;
    }
    var turns_0 : f32;
    if(is_across_0)
    {
        turns_0 = divide_0(b_4, a_4) * 0.125f;
    }
    else
    {
        turns_0 = 0.25f - divide_0(a_4, b_4) * 0.125f;
    }
    if(radius_0 < 0.0f)
    {
        turns_0 = turns_0 + 0.5f;
    }
    var _S139 : f32 = abs(radius_0);
    if(turns_0 < 0.0f)
    {
        radius_0 = turns_0 + 1.0f;
    }
    else
    {
        radius_0 = turns_0;
    }
    return vec2<f32>(_S139, radius_0);
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
    var _S140 : f32 = from_0.y;
    var _S141 : f32 = from_0.x;
    return vec2<f32>(_S140 + (to_0.y - _S140) * share_0, _S141 + (to_0.x - _S141) * share_0) * vec2<f32>(radius_1);
}

fn dot_product_0( a_5 : vec3<f32>,  b_5 : vec3<f32>) -> f32
{
    return a_5.x * b_5.x + a_5.y * b_5.y + a_5.z * b_5.z;
}

fn length_squared_0( vector_3 : vec3<f32>) -> f32
{
    return dot_product_0(vector_3, vector_3);
}

fn nearest_root_0( mantissa_0 : u32,  guess_1 : u32) -> u32
{
    var rest_1 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_1) / f32(u32(2) * guess_1) + 0.5f));
    var _S142 : i32 = i32(guess_1);
    var root_0 : i32 = _S142 + units_1;
    var rest_2 : i32 = rest_1 - units_1 * (_S142 + root_0);
    return u32(root_0 + i32(rest_2 > root_0) - i32(rest_2 <= (- root_0)));
}

fn square_root_0( value_1 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_1);
    }
    var _S143 : u32 = (bitcast<u32>((value_1)));
    var exponent_2 : u32 = (_S143 >> (u32(23)));
    if(!is_normal_0(exponent_2))
    {
        return sqrt(value_1);
    }
    var mantissa_1 : u32 = (((((_S143 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_2) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_1, u32(sqrt(f32(mantissa_1) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn normalize_vector_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vector_4 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_4))));
}

fn ray_from_0( origin_10 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_10, 0.0f, direction_5, (bitcast<f32>(infinity_bits_0)));
}

fn ThinLens_ray_0( this_20 : ThinLens_0,  position_2 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var place_0 : vec2<f32> = place_in_aperture_0(this_20.blades_3, lens_4);
    var offset_1 : vec3<f32> = this_20.lens_x_3 * vec3<f32>(place_0.x) + this_20.lens_y_3 * vec3<f32>(place_0.y);
    return ray_from_0(this_20.perspective_0.eye_3 + offset_1, normalize_vector_0(this_20.perspective_0.corner_3 + this_20.perspective_0.pixel_x_3 * vec3<f32>(position_2.x) + this_20.perspective_0.pixel_y_3 * vec3<f32>(position_2.y) - offset_1));
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
    var _S144 : Orthographic_0;
    _S144.corner_5 = corner_6;
    _S144.pixel_x_5 = pixel_x_6;
    _S144.pixel_y_5 = pixel_y_6;
    _S144.forward_2 = forward_3;
    return _S144;
}

fn Orthographic_ray_0( this_21 : Orthographic_0,  position_3 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_21.corner_5 + this_21.pixel_x_5 * vec3<f32>(position_3.x) + this_21.pixel_y_5 * vec3<f32>(position_3.y), this_21.forward_2);
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
    var _S145 : Panorama_0;
    _S145.eye_5 = eye_6;
    _S145.axes_0 = axes_1;
    _S145.inverse_size_0 = inverse_size_1;
    _S145.half_eye_distance_0 = half_eye_distance_1;
    return _S145;
}

fn Panorama_ray_0( this_22 : Panorama_0,  position_4 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_4.y * this_22.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_0 : f32;
    if(is_right_eye_0)
    {
        side_0 = this_22.half_eye_distance_0;
    }
    else
    {
        side_0 = - this_22.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_4.x * this_22.inverse_size_0.x);
    var height_1 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S146 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S147 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_22.eye_5 + (this_22.axes_0.forward_0 * _S147 - this_22.axes_0.right_0 * _S146) * vec3<f32>(side_0), normalize_vector_0((vec3<f32>(0) - this_22.axes_0.forward_0 * _S146 + this_22.axes_0.right_0 * _S147) * vec3<f32>(height_1.x) + this_22.axes_0.up_0 * vec3<f32>(height_1.y)));
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
    var _S148 : Fisheye_0;
    _S148.eye_7 = eye_8;
    _S148.axes_2 = axes_3;
    _S148.middle_0 = middle_1;
    _S148.turns_per_pixel_0 = turns_per_pixel_1;
    return _S148;
}

fn Fisheye_ray_0( this_23 : Fisheye_0,  position_5 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    var x_1 : f32 = position_5.x - this_23.middle_0.x;
    var y_1 : f32 = position_5.y - this_23.middle_0.y;
    var radius_2 : f32 = square_root_0(x_1 * x_1 + y_1 * y_1);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(min(radius_2 * this_23.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_2 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_1.x, radius_2);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_23.eye_7, normalize_vector_0(this_23.axes_2.forward_0 * vec3<f32>(sin_cos_1.y) + this_23.axes_2.right_0 * vec3<f32>((x_1 * scale_0)) - this_23.axes_2.up_0 * vec3<f32>((y_1 * scale_0))));
}

fn Perspective_ray_0( this_24 : Perspective_0,  position_6 : vec2<f32>,  lens_8 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_24.eye_3, normalize_vector_0(this_24.corner_3 + this_24.pixel_x_3 * vec3<f32>(position_6.x) + this_24.pixel_y_3 * vec3<f32>(position_6.y)));
}

fn CameraFrame_ray_0( this_25 : CameraFrame_0,  position_7 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_25.eye_1, this_25.corner_1, this_25.pixel_x_1, this_25.pixel_y_1);
    var axes_4 : Axes_0 = Axes_x24init_0(this_25.corner_1, this_25.pixel_x_1, this_25.pixel_y_1);
    switch(this_25.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_25.lens_x_1, this_25.lens_y_1, this_25.blades_1), position_7, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_25.corner_1, this_25.pixel_x_1, this_25.pixel_y_1, this_25.lens_x_1), position_7, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_25.eye_1, axes_4, this_25.lens_x_1.xy, this_25.lens_x_1.z), position_7, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_25.eye_1, axes_4, this_25.lens_x_1.xy, this_25.lens_x_1.z), position_7, lens_sample_0);
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
    var _S149 : CameraFrame_0 = FrameParams_camera_0();
    var _S150 : vec2<u32> = position_of_0(pixel_4);
    return PathTracingOf_clip_0(CameraFrame_ray_0(_S149, vec2<f32>(_S150) + jitter_0.xy, jitter_0.zw));
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
    var _S151 : RayCounts_0;
    _S151.bounce_2 = bounce_3;
    _S151.shadow_0 = shadow_1;
    return _S151;
}

fn Hit_is_miss_0( this_26 : Hit_0) -> bool
{
    return (this_26.instance_1) == u32(4294967295);
}

fn Path_events_0( this_27 : Path_0) -> u32
{
    return this_27.bounce_0;
}

fn Inside_is_in_0( this_28 : Inside_0) -> bool
{
    return false;
}

fn weighs_apart_0() -> bool
{
    var _S152 : bool;
    if(IS_EXACT_0)
    {
        _S152 = IS_SINGLE_0;
    }
    else
    {
        _S152 = false;
    }
    return _S152;
}

fn Path_is_counted_0( this_29 : Path_0) -> bool
{
    var _S153 : bool;
    if(weighs_apart_0())
    {
        _S153 = (this_29.pdf_1) < 0.0f;
    }
    else
    {
        _S153 = false;
    }
    return _S153;
}

struct NextRays_0
{
     origin_11 : vec3<f32>,
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

fn NextRays_x24init_0( origin_12 : vec3<f32>,  path_origin_1 : vec3<f32>,  shadow_inside_2 : Inside_0,  relocates_2 : bool,  path_relocates_2 : bool,  direction_7 : vec3<f32>,  has_shadow_ray_1 : bool,  shadow_direction_1 : vec3<f32>,  shadow_t_max_1 : f32,  light_1 : vec3<f32>,  is_same_1 : bool) -> NextRays_0
{
    var _S154 : NextRays_0;
    _S154.origin_11 = origin_12;
    _S154.path_origin_0 = path_origin_1;
    _S154.shadow_inside_1 = shadow_inside_2;
    _S154.relocates_1 = relocates_2;
    _S154.path_relocates_1 = path_relocates_2;
    _S154.direction_6 = direction_7;
    _S154.has_shadow_ray_0 = has_shadow_ray_1;
    _S154.shadow_direction_0 = shadow_direction_1;
    _S154.shadow_t_max_0 = shadow_t_max_1;
    _S154.light_0 = light_1;
    _S154.is_same_0 = is_same_1;
    return _S154;
}

fn no_rays_0() -> NextRays_0
{
    var _S155 : vec3<f32> = vec3<f32>(0.0f);
    return NextRays_x24init_0(_S155, _S155, in_air_0(), false, false, _S155, false, _S155, 0.0f, _S155, false);
}

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_2 : vec3<f32>,
};

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_3 : vec3<f32>) -> Receiver_0
{
    var _S156 : Receiver_0;
    _S156.point_0 = point_1;
    _S156.normal_2 = normal_3;
    return _S156;
}

fn Path_receiver_0( this_30 : Path_0,  ray_11 : Ray_0) -> Receiver_0
{
    return Receiver_x24init_0(ray_11.origin_1, this_30.normal_0);
}

fn Path_dimension_medium_0( this_31 : Path_0) -> u32
{
    return u32(2147483648) + this_31.event_0;
}

fn Sampler_independent_0( this_32 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_32.pixel_0, this_32.sample_0, dimension_2, this_32.seed_1)));
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

fn Rows_operatorx5Bx5D_get_3( row_5 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(3)) + row_5];
}

fn material_of_index_0( index_11 : u32) -> PackedMaterial_0
{
    var _S157 : u32 = u32(4) * index_11;
    var _S158 : vec4<u32> = Rows_operatorx5Bx5D_get_3(_S157);
    var _S159 : vec4<u32> = Rows_operatorx5Bx5D_get_3(_S157 + u32(1));
    var _S160 : vec4<u32> = Rows_operatorx5Bx5D_get_3(_S157 + u32(2));
    var _S161 : vec4<u32> = Rows_operatorx5Bx5D_get_3(_S157 + u32(3));
    var material_2 : PackedMaterial_0;
    var _S162 : f32 = (bitcast<f32>((_S158.y)));
    var _S163 : f32 = (bitcast<f32>((_S158.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((_S158.x)));
    material_2.base_color_0[i32(1)] = _S162;
    material_2.base_color_0[i32(2)] = _S163;
    var _S164 : f32 = (bitcast<f32>((_S159.y)));
    var _S165 : f32 = (bitcast<f32>((_S159.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((_S159.x)));
    material_2.emission_0[i32(1)] = _S164;
    material_2.emission_0[i32(2)] = _S165;
    var _S166 : f32 = (bitcast<f32>((_S161.y)));
    var _S167 : f32 = (bitcast<f32>((_S161.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((_S161.x)));
    material_2.absorption_0[i32(1)] = _S166;
    material_2.absorption_0[i32(2)] = _S167;
    material_2.roughness_0 = (bitcast<f32>((_S158.w)));
    material_2.metallic_0 = (bitcast<f32>((_S159.w)));
    material_2.transmission_0 = (bitcast<f32>((_S160.x)));
    material_2.ior_0 = (bitcast<f32>((_S160.y)));
    material_2.specular_0 = (bitcast<f32>((_S160.z)));
    material_2.anisotropy_0 = (bitcast<f32>((_S160.w)));
    material_2.scattering_0 = (bitcast<f32>((_S161.w)));
    return material_2;
}

fn logarithm_0( x_2 : f32) -> f32
{
    var bits_1 : u32 = (bitcast<u32>((x_2)));
    var _S168 : u32 = (bits_1 & (u32(8388607)));
    var is_upper_0 : bool = _S168 > u32(3474675);
    var power_0 : i32 = i32((bits_1 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S169 : u32;
    if(is_upper_0)
    {
        _S169 = u32(1056964608);
    }
    else
    {
        _S169 = u32(1065353216);
    }
    var mantissa_2 : f32 = (bitcast<f32>(((_S168 | (_S169)))));
    var s_0 : f32 = divide_0(mantissa_2 - 1.0f, mantissa_2 + 1.0f);
    var ss_0 : f32 = s_0 * s_0;
    var _S170 : f32 = f32(power_0);
    return _S170 * 0.693359375f + (_S170 * -0.00021219444170129f + s_0 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_0 : PackedMaterial_0,  u_0 : f32) -> f32
{
    var _S171 : f32;
    if((medium_0.scattering_0) > 0.0f)
    {
        _S171 = divide_0(- logarithm_0(1.0f - u_0), medium_0.scattering_0);
    }
    else
    {
        _S171 = (bitcast<f32>(infinity_bits_0));
    }
    return _S171;
}

fn grid_direction_0( instance_8 : u32,  direction_8 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(Instances_operatorx5Bx5D_get_0(instance_8).grid_from_world_0, direction_8);
}

fn Inside_voxels_per_t_0( this_33 : Inside_0,  ray_12 : Ray_0) -> f32
{
    return square_root_0(length_squared_0(grid_direction_0(this_33.instance_2, ray_12.direction_1)));
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

fn Environment_to_map_0( d_0 : vec3<f32>) -> vec3<f32>
{
    var sin_1 : f32 = params_0.sky_turned_0.x;
    var cos_1 : f32 = params_0.sky_turned_0.y;
    var _S172 : f32 = d_0.x;
    var _S173 : f32 = d_0.y;
    return vec3<f32>(_S172 * cos_1 - _S173 * sin_1, _S172 * sin_1 + _S173 * cos_1, d_0.z);
}

fn quarter_turns_0( x_4 : f32,  y_2 : f32) -> f32
{
    var _S174 : f32 = min(x_4, y_2);
    var _S175 : f32 = max(x_4, y_2);
    var ratio_0 : f32;
    if(_S175 > 0.0f)
    {
        ratio_0 = divide_0(_S174, _S175);
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
    var _S176 : f32 = size_0.x;
    var _S177 : f32 = size_0.y;
    var radius_3 : f32 = square_root_0(divide_0(_S176 * _S176 + _S177 * _S177, 1.0f + size_0.z));
    var v_3 : f32 = quarter_turns_0(_S176, _S177) * radius_3;
    var u_1 : f32 = radius_3 - v_3;
    var is_below_1 : bool = (direction_9.z) < 0.0f;
    var u_2 : f32;
    if(is_below_1)
    {
        u_2 = 1.0f - v_3;
    }
    else
    {
        u_2 = u_1;
    }
    var v_4 : f32;
    if(is_below_1)
    {
        v_4 = 1.0f - u_1;
    }
    else
    {
        v_4 = v_3;
    }
    if((direction_9.x) < 0.0f)
    {
        u_2 = - u_2;
    }
    if((direction_9.y) < 0.0f)
    {
        v_4 = - v_4;
    }
    return vec2<f32>(u_2 * 0.5f + 0.5f, v_4 * 0.5f + 0.5f);
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
    var _S178 : i32;
    if(is_beside_0)
    {
        _S178 = last_3 - y_3;
    }
    else
    {
        _S178 = y_3;
    }
    var _S179 : i32;
    if(is_beside_0)
    {
        _S179 = clamp(x_5, i32(0), last_3);
    }
    else
    {
        _S179 = x_5;
    }
    var is_beyond_0 : bool;
    if(_S178 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S178 > last_3;
    }
    if(is_beyond_0)
    {
        _S179 = last_3 - _S179;
    }
    if(is_beyond_0)
    {
        _S178 = clamp(_S178, i32(0), last_3);
    }
    return u32(_S178 * i32(params_0.sky_edge_0) + _S179);
}

fn Environment_texel_radiance_0( x_6 : i32,  y_4 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_6, y_4)].radiance_0);
}

fn Environment_radiance_at_0( place_1 : vec2<f32>) -> vec3<f32>
{
    var _S180 : vec2<f32> = place_1 - vec2<f32>(0.5f);
    var corner_7 : vec2<f32> = floor(_S180);
    var beyond_1 : vec2<f32> = _S180 - corner_7;
    var x_7 : i32 = i32(corner_7.x);
    var y_5 : i32 = i32(corner_7.y);
    var _S181 : f32 = beyond_1.x;
    var _S182 : vec3<f32> = vec3<f32>((1.0f - _S181));
    var _S183 : i32 = x_7 + i32(1);
    var _S184 : vec3<f32> = vec3<f32>(_S181);
    var _S185 : i32 = y_5 + i32(1);
    var _S186 : f32 = beyond_1.y;
    return (Environment_texel_radiance_0(x_7, y_5) * _S182 + Environment_texel_radiance_0(_S183, y_5) * _S184) * vec3<f32>((1.0f - _S186)) + (Environment_texel_radiance_0(x_7, _S185) * _S182 + Environment_texel_radiance_0(_S183, _S185) * _S184) * vec3<f32>(_S186);
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
    var _S187 : Gradient_0;
    _S187.nadir_0 = nadir_1;
    _S187.zenith_0 = zenith_1;
    return _S187;
}

fn Gradient_radiance_0( this_34 : Gradient_0,  direction_12 : vec3<f32>) -> vec3<f32>
{
    return this_34.nadir_0 + (this_34.zenith_0 - this_34.nadir_0) * vec3<f32>((0.5f * (direction_12.z + 1.0f)));
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

fn Path_selection_at_0( this_35 : Path_0,  last_4 : Receiver_0) -> Selection_0
{
    return this_35.selection_0;
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S188 : bool;
    if(SKY_0 == u32(1))
    {
        _S188 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S188 = false;
    }
    return _S188;
}

fn Environment_pdf_0( direction_15 : vec3<f32>) -> f32
{
    var place_2 : vec2<f32> = Environment_place_of_0(direction_15);
    var last_5 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_2.x), last_5), min(i32(place_2.y), last_5))].pdf_0;
}

fn Sky_pdf_0( direction_16 : vec3<f32>) -> f32
{
    var _S189 : f32;
    if(SKY_0 == u32(1))
    {
        _S189 = Environment_pdf_0(direction_16);
    }
    else
    {
        _S189 = 0.0f;
    }
    return _S189;
}

fn Lights_sky_pdf_0( selection_2 : Selection_0,  direction_17 : vec3<f32>) -> f32
{
    var _S190 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S190 = Sky_pdf_0(direction_17) * selection_2.sky_1;
    }
    else
    {
        _S190 = 0.0f;
    }
    return _S190;
}

fn power_heuristic_0( own_0 : f32,  other_1 : f32) -> f32
{
    var ratio_1 : f32 = divide_0(other_1, own_0);
    return divide_0(1.0f, 1.0f + ratio_1 * ratio_1);
}

fn mis_weight_0( bounce_pdf_0 : f32,  light_pdf_0 : f32) -> f32
{
    var _S191 : bool;
    if(bounce_pdf_0 == 0.0f)
    {
        _S191 = true;
    }
    else
    {
        _S191 = light_pdf_0 == 0.0f;
    }
    if(_S191)
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

fn Path_is_straight_0( this_36 : Path_0) -> bool
{
    var _S192 : bool;
    if((this_36.bounce_0) == u32(0))
    {
        _S192 = (this_36.pdf_1) == 0.0f;
    }
    else
    {
        _S192 = false;
    }
    if(_S192)
    {
        _S192 = (all(((this_36.normal_0) == vec3<f32>(0.0f))));
    }
    else
    {
        _S192 = false;
    }
    return _S192;
}

fn SunDisc_contains_0( direction_18 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_18 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_le_0( direction_19 : vec3<f32>) -> vec3<f32>
{
    var _S193 : vec3<f32>;
    if(SunDisc_contains_0(direction_19))
    {
        _S193 = params_0.sun_radiance_0;
    }
    else
    {
        _S193 = vec3<f32>(0.0f);
    }
    return _S193;
}

fn SunDisc_pdf_0( direction_20 : vec3<f32>) -> f32
{
    var _S194 : f32;
    if(SunDisc_contains_0(direction_20))
    {
        _S194 = params_0.sun_pdf_0;
    }
    else
    {
        _S194 = 0.0f;
    }
    return _S194;
}

fn Lights_sun_pdf_0( selection_3 : Selection_0,  direction_21 : vec3<f32>) -> f32
{
    var _S195 : f32;
    if(has_sun_0())
    {
        _S195 = SunDisc_pdf_0(direction_21) * selection_3.sun_0;
    }
    else
    {
        _S195 = 0.0f;
    }
    return _S195;
}

fn Path_dimension_scatter_0( this_37 : Path_0) -> u32
{
    return u32(1) + u32(2) * Path_events_0(this_37);
}

fn find_brick_0( grid_6 : PackedGrid_0,  relative_1 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (relative_1 >> (vec3<u32>(grid_6.top_shift_0)));
    var _S196 : bool;
    if((any((top_0 < vec3<i32>(i32(0))))))
    {
        _S196 = true;
    }
    else
    {
        _S196 = (any((top_0 >= (cell_of_0(grid_6.top_size_0)))));
    }
    if(_S196)
    {
        return u32(4294967295);
    }
    var cell_7 : u32 = cell_word_0(grid_6.top_offset_0 + u32((top_0.z * grid_6.top_size_0[i32(1)] + top_0.y) * grid_6.top_size_0[i32(0)] + top_0.x));
    var shift_3 : u32 = grid_6.top_shift_0;
    for(;;)
    {
        if(shift_3 > u32(3))
        {
            _S196 = ((cell_7 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S196 = false;
        }
        if(_S196)
        {
        }
        else
        {
            break;
        }
        var shift_4 : u32 = shift_3 - u32(2);
        cell_7 = cell_word_0(((cell_7 & (u32(2147483647)))) * u32(64) + cell_in_node_0(relative_1, shift_4));
        shift_3 = shift_4;
    }
    if(((cell_7 & (u32(2147483648)))) == u32(0))
    {
        cell_7 = u32(4294967295);
    }
    else
    {
        cell_7 = record_of_cell_0(cell_7);
    }
    return cell_7;
}

fn rank_in_brick_0( record_3 : u32,  relative_2 : vec3<i32>) -> u32
{
    var bit_1 : u32 = cell_in_node_0(relative_2, u32(0));
    var present_before_0 : u32 = countOneBits(((brick_word_0(record_3)) & ((((u32(1) << (((((u32(((((relative_2.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_2.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_2.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_12 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_12 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S197 : u32 = u32(2) * index_12;
        var rank_1 : u32 = rank_0 + (countOneBits(brick_word_0(record_3 + u32(2) + _S197)) + countOneBits(brick_word_0(record_3 + u32(3) + _S197)));
        index_12 = index_12 + u32(1);
        rank_0 = rank_1;
    }
    var _S198 : u32 = u32(2) * present_before_0;
    var low_8 : u32 = brick_word_0(record_3 + u32(2) + _S198);
    if(bit_1 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_8 & ((((u32(1) << (bit_1))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_8) + countOneBits(((brick_word_0(record_3 + u32(3) + _S198)) & ((((u32(1) << ((bit_1 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_13 : u32) -> u32
{
    return index_13;
}

fn material_word_0( index_14 : u32) -> u32
{
    return brick_materials_0[place_of_material_0(index_14)];
}

fn read_bits_0( start_1 : u32,  position_8 : u32,  count_2 : u32) -> u32
{
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    var word_4 : u32 = start_1 + ((position_8 >> (u32(5))));
    var shift_5 : u32 = (position_8 & (u32(31)));
    var bits_2 : u32 = ((material_word_0(word_4)) >> (shift_5));
    var bits_3 : u32;
    if((shift_5 + count_2) > u32(32))
    {
        bits_3 = (bits_2 | ((((material_word_0(word_4 + u32(1))) << ((u32(32) - shift_5))))));
    }
    else
    {
        bits_3 = bits_2;
    }
    return (bits_3 & ((((u32(1) << (count_2))) - u32(1))));
}

fn material_of_rank_0( grid_7 : PackedGrid_0,  record_4 : u32,  rank_2 : u32) -> u32
{
    var header_0 : u32 = brick_word_0(record_4);
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var start_2 : u32 = brick_word_0(record_4 + u32(1));
    var index_15 : u32 = read_bits_0(start_2, palette_count_0 * grid_7.material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_15;
    }
    return read_bits_0(start_2, index_15 * grid_7.material_bits_0, grid_7.material_bits_0);
}

fn material_at_0( grid_8 : PackedGrid_0,  relative_3 : vec3<i32>) -> u32
{
    var record_5 : u32 = find_brick_0(grid_8, relative_3);
    return material_of_rank_0(grid_8, record_5, rank_in_brick_0(record_5, relative_3));
}

fn material_of_0( hit_1 : Hit_0) -> PackedMaterial_0
{
    var _S199 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(hit_1.instance_1).grid_0);
    return material_of_index_0(material_at_0(_S199, hit_1.voxel_1 - cell_of_0(_S199.origin_4)));
}

fn material_met_0( path_4 : Path_0,  hit_2 : Hit_0,  beyond_2 : u32) -> PackedMaterial_0
{
    return material_of_0(hit_2);
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
    var _S200 : Aim_0;
    _S200.is_met_0 = is_met_1;
    _S200.direction_22 = direction_23;
    _S200.hit_3 = hit_4;
    _S200.luminance_1 = luminance_2;
    return _S200;
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
    var _S201 : LightSample_0;
    _S201.ray_15 = ray_16;
    _S201.cos_theta_0 = cos_theta_1;
    _S201.radiance_2 = radiance_3;
    _S201.pdf_3 = pdf_4;
    return _S201;
}

fn no_light_0() -> LightSample_0
{
    var _S202 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S202, 0.0f, _S202, 0.0f), 0.0f, _S202, 0.0f);
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
    var _S203 : ChosenDirection_0;
    _S203.direction_25 = direction_26;
    _S203.radiance_4 = radiance_5;
    _S203.pdf_5 = pdf_6;
    return _S203;
}

fn direction_of_0( square_1 : vec2<f32>) -> vec3<f32>
{
    var u_4 : f32 = square_1.x * 2.0f - 1.0f;
    var v_5 : f32 = square_1.y * 2.0f - 1.0f;
    var _S204 : f32 = abs(u_4);
    var _S205 : f32 = abs(v_5);
    var height_2 : f32 = 1.0f - (_S204 + _S205);
    var radius_5 : f32 = 1.0f - abs(height_2);
    var turns_3 : f32;
    if(radius_5 > 0.0f)
    {
        turns_3 = (divide_0(_S205 - _S204, radius_5) + 1.0f) * 0.125f;
    }
    else
    {
        turns_3 = 0.0f;
    }
    var sin_cos_3 : vec2<f32> = sincos_turns_0(turns_3);
    var _S206 : f32 = radius_5 * radius_5;
    var across_0 : f32 = radius_5 * square_root_0(2.0f - _S206);
    var x_8 : f32 = sin_cos_3.y * across_0;
    var y_6 : f32 = sin_cos_3.x * across_0;
    var z_0 : f32 = 1.0f - _S206;
    if(u_4 < 0.0f)
    {
        turns_3 = - x_8;
    }
    else
    {
        turns_3 = x_8;
    }
    var _S207 : f32;
    if(v_5 < 0.0f)
    {
        _S207 = - y_6;
    }
    else
    {
        _S207 = y_6;
    }
    var _S208 : f32;
    if(height_2 < 0.0f)
    {
        _S208 = - z_0;
    }
    else
    {
        _S208 = z_0;
    }
    return vec3<f32>(turns_3, _S207, _S208);
}

fn Environment_to_world_0( d_1 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S209 : f32 = d_1.x;
    var _S210 : f32 = d_1.y;
    return vec3<f32>(_S209 * cos_3 + _S210 * sin_2, _S210 * cos_3 - _S209 * sin_2, d_1.z);
}

fn Environment_choose_0( u_5 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S211 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S211, _S211, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S212 : f32 = u_5.x * edge_0;
    var _S213 : f32 = edge_0 - 1.0f;
    var _S214 : f32 = min(floor(_S212), _S213);
    var own_1 : u32 = u32(_S214) * params_0.sky_edge_0 + u32(min(floor(u_5.y * edge_0), _S213));
    var index_16 : u32;
    if((u_5.z) < (environment_0[own_1].threshold_0))
    {
        index_16 = own_1;
    }
    else
    {
        index_16 = environment_0[own_1].alias_0;
    }
    var pdf_7 : f32 = environment_0[index_16].pdf_0;
    if((environment_0[index_16].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S215 : u32 = index_16 % params_0.sky_edge_0;
    var _S216 : f32 = f32(_S215);
    var _S217 : u32 = index_16 / params_0.sky_edge_0;
    var place_3 : vec2<f32> = vec2<f32>(_S216, f32(_S217)) + vec2<f32>(min(_S212 - _S214, 1.0f), u_5.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_3 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_3), pdf_7);
    return true;
}

fn Sky_sample_0( receiver_2 : Receiver_0,  u_6 : vec4<f32>,  sample_7 : ptr<function, LightSample_0>) -> bool
{
    (*sample_7) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S218 : bool;
    if(SKY_0 != u32(1))
    {
        _S218 = true;
    }
    else
    {
        var _S219 : bool = Environment_choose_0(u_6, &(chosen_1));
        _S218 = !_S219;
    }
    if(_S218)
    {
        return false;
    }
    var cos_theta_3 : f32 = with_slack_0(receiver_2, dot_product_0(receiver_2.normal_2, chosen_1.direction_25));
    (*sample_7) = LightSample_x24init_0(ray_from_0(receiver_2.point_0, chosen_1.direction_25), cos_theta_3, chosen_1.radiance_4 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_5);
    return cos_theta_3 > 0.0f;
}

struct Descent_0
{
     node_2 : u32,
     index_17 : u32,
     count_3 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
     is_far_0 : bool,
};

fn Descent_x24init_0( node_3 : u32,  index_18 : u32,  count_4 : u32,  weight_1 : f32,  total_1 : f32,  choice_1 : f32,  is_far_1 : bool) -> Descent_0
{
    var _S220 : Descent_0;
    _S220.node_2 = node_3;
    _S220.index_17 = index_18;
    _S220.count_3 = count_4;
    _S220.weight_0 = weight_1;
    _S220.total_0 = total_1;
    _S220.choice_0 = choice_1;
    _S220.is_far_0 = is_far_1;
    return _S220;
}

struct LightNode_0
{
     min_2 : array<f32, i32(3)>,
     index_19 : u32,
     max_2 : array<f32, i32(3)>,
     count_5 : u32,
     power_2 : array<f32, i32(6)>,
     parent_0 : u32,
     root_1 : u32,
};

fn Rows_operatorx5Bx5D_get_4( row_6 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(6)) + row_6];
}

fn light_node_of_0( a_6 : vec4<u32>,  b_6 : vec4<u32>,  c_1 : vec4<u32>,  d_2 : vec4<u32>) -> LightNode_0
{
    var node_4 : LightNode_0;
    var _S221 : f32 = (bitcast<f32>((a_6.y)));
    var _S222 : f32 = (bitcast<f32>((a_6.z)));
    node_4.min_2[i32(0)] = (bitcast<f32>((a_6.x)));
    node_4.min_2[i32(1)] = _S221;
    node_4.min_2[i32(2)] = _S222;
    node_4.index_19 = a_6.w;
    var _S223 : f32 = (bitcast<f32>((b_6.y)));
    var _S224 : f32 = (bitcast<f32>((b_6.z)));
    node_4.max_2[i32(0)] = (bitcast<f32>((b_6.x)));
    node_4.max_2[i32(1)] = _S223;
    node_4.max_2[i32(2)] = _S224;
    node_4.count_5 = b_6.w;
    var _S225 : f32 = (bitcast<f32>((c_1.y)));
    var _S226 : f32 = (bitcast<f32>((c_1.z)));
    var _S227 : f32 = (bitcast<f32>((c_1.w)));
    var _S228 : f32 = (bitcast<f32>((d_2.x)));
    var _S229 : f32 = (bitcast<f32>((d_2.y)));
    node_4.power_2[i32(0)] = (bitcast<f32>((c_1.x)));
    node_4.power_2[i32(1)] = _S225;
    node_4.power_2[i32(2)] = _S226;
    node_4.power_2[i32(3)] = _S227;
    node_4.power_2[i32(4)] = _S228;
    node_4.power_2[i32(5)] = _S229;
    node_4.parent_0 = d_2.z;
    node_4.root_1 = d_2.w;
    return node_4;
}

fn top_light_node_0( index_20 : u32) -> LightNode_0
{
    var _S230 : u32 = u32(4) * index_20;
    return light_node_of_0(Rows_operatorx5Bx5D_get_4(_S230), Rows_operatorx5Bx5D_get_4(_S230 + u32(1)), Rows_operatorx5Bx5D_get_4(_S230 + u32(2)), Rows_operatorx5Bx5D_get_4(_S230 + u32(3)));
}

fn TopLights_node_0( index_21 : u32) -> LightNode_0
{
    return top_light_node_0(index_21);
}

fn Descent_at_0( this_38 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_5 : LightNode_0 = TopLights_node_0(root_2);
    (*this_38).node_2 = root_2;
    (*this_38).index_17 = node_5.index_19;
    (*this_38).count_3 = node_5.count_5;
    (*this_38).is_far_0 = false;
    return;
}

struct View_0
{
     importance_0 : f32,
     of_nearest_0 : f32,
     is_far_2 : bool,
};

fn reach_of_0( toward_0 : vec3<f32>,  half_1 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_0), half_1);
}

fn reciprocal_guess_0( x_9 : f32) -> f32
{
    var guess_2 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_9))))));
    return guess_2 * (2.0f - x_9 * guess_2);
}

struct BySide_0
{
     low_9 : vec3<f32>,
     high_4 : vec3<f32>,
};

fn BySide_x24init_0( low_10 : vec3<f32>,  high_5 : vec3<f32>) -> BySide_0
{
    var _S231 : BySide_0;
    _S231.low_9 = low_10;
    _S231.high_4 = high_5;
    return _S231;
}

fn sent_by_side_0( node_6 : LightNode_0,  point_2 : vec3<f32>) -> BySide_0
{
    var _S232 : vec3<f32> = vec3<f32>(0.0f);
    return BySide_x24init_0(vec3<f32>(node_6.power_2[i32(0)], node_6.power_2[i32(2)], node_6.power_2[i32(4)]) * max(vector_of_0(node_6.max_2) - point_2, _S232), vec3<f32>(node_6.power_2[i32(1)], node_6.power_2[i32(3)], node_6.power_2[i32(5)]) * max(point_2 - vector_of_0(node_6.min_2), _S232));
}

fn BySide_sum_0( this_39 : BySide_0) -> f32
{
    var axes_5 : vec3<f32> = this_39.low_9 + this_39.high_4;
    return axes_5.x + axes_5.y + axes_5.z;
}

fn nearest_of_0( toward_1 : vec3<f32>,  half_2 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_1) - half_2, half_2 * vec3<f32>(0.03125f));
}

fn View_x24init_0( importance_1 : f32,  of_nearest_1 : f32,  is_far_3 : bool) -> View_0
{
    var _S233 : View_0;
    _S233.importance_0 = importance_1;
    _S233.of_nearest_0 = of_nearest_1;
    _S233.is_far_2 = is_far_3;
    return _S233;
}

fn view_0( node_7 : LightNode_0,  receiver_3 : Receiver_0) -> View_0
{
    var _S234 : vec3<f32> = vector_of_0(node_7.max_2);
    var _S235 : vec3<f32> = vector_of_0(node_7.min_2);
    var _S236 : vec3<f32> = vec3<f32>(0.5f);
    var half_3 : vec3<f32> = (_S234 - _S235) * _S236;
    var toward_2 : vec3<f32> = (_S235 + _S234) * _S236 - receiver_3.point_0;
    var middle_2 : f32 = dot_product_0(toward_2, receiver_3.normal_2);
    var aside_0 : f32 = dot_product_0(half_3, abs(receiver_3.normal_2));
    var above_0 : f32 = with_slack_0(receiver_3, middle_2 + aside_0);
    var far_2 : f32 = length_squared_0(reach_of_0(toward_2, half_3));
    var near_2 : f32 = length_squared_0(half_3);
    var is_far_4 : bool;
    if((with_slack_0(receiver_3, middle_2 - aside_0)) > 0.0f)
    {
        is_far_4 = far_2 > (near_2 * 36.0f);
    }
    else
    {
        is_far_4 = false;
    }
    var falloff_0 : f32 = reciprocal_guess_0(far_2);
    var cosines_0 : f32;
    if(above_0 > 0.0f)
    {
        cosines_0 = BySide_sum_0(sent_by_side_0(node_7, receiver_3.point_0)) * above_0 * falloff_0;
    }
    else
    {
        cosines_0 = 0.0f;
    }
    return View_x24init_0(cosines_0 * falloff_0, cosines_0 * reciprocal_guess_0(length_squared_0(nearest_of_0(toward_2, half_3))), is_far_4);
}

fn normal_or_zero_0( weight_2 : f32) -> f32
{
    var _S237 : f32;
    if(weight_2 < 1.17549435082228751e-38f)
    {
        _S237 = 0.0f;
    }
    else
    {
        _S237 = weight_2;
    }
    return _S237;
}

fn inverse_power_of_two_0( x_10 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_10))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_2 : f32) -> vec2<f32>
{
    var _S238 : f32 = normal_or_zero_0(left_0);
    var _S239 : f32 = normal_or_zero_0(right_2);
    var unit_0 : f32 = inverse_power_of_two_0(_S238 + _S239);
    return vec2<f32>(normal_or_zero_0(_S238 * unit_0), normal_or_zero_0(_S239 * unit_0));
}

fn weights_of_views_0( left_1 : View_0,  right_3 : View_0) -> vec2<f32>
{
    var near_3 : vec2<f32> = weights_of_0(left_1.of_nearest_0, right_3.of_nearest_0);
    var _S240 : f32 = near_3.x;
    var _S241 : f32 = near_3.y;
    var of_near_0 : f32 = _S240 + _S241;
    var of_all_0 : f32 = (left_1.importance_0 + right_3.importance_0) * 0.5f;
    return weights_of_0(left_1.importance_0 * of_near_0 + _S240 * of_all_0, right_3.importance_0 * of_near_0 + _S241 * of_all_0);
}

fn climb_0( receiver_4 : Receiver_0,  start_3 : u32,  descent_0 : ptr<function, Descent_0>) -> bool
{
    var node_8 : LightNode_0 = top_light_node_0(start_3);
    var at_1 : u32 = start_3;
    for(;;)
    {
        var _S242 : LightNode_0 = node_8;
        if((node_8.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S242.parent_0);
        var _S243 : u32 = _S242.parent_0 + u32(1);
        var is_left_1 : bool = at_1 == _S243;
        var _S244 : u32;
        if(is_left_1)
        {
            _S244 = parent_1.index_19;
        }
        else
        {
            _S244 = _S243;
        }
        var own_2 : View_0 = view_0(node_8, receiver_4);
        var other_2 : View_0 = view_0(top_light_node_0(_S244), receiver_4);
        var weights_0 : vec2<f32>;
        if(is_left_1)
        {
            weights_0 = weights_of_views_0(own_2, other_2);
        }
        else
        {
            weights_0 = weights_of_views_0(other_2, own_2);
        }
        var _S245 : f32 = weights_0.x;
        var _S246 : f32 = weights_0.y;
        var total_2 : f32 = _S245 + _S246;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S247 : f32;
        if(is_left_1)
        {
            _S247 = _S245;
        }
        else
        {
            _S247 = _S246;
        }
        (*descent_0).weight_0 = (*descent_0).weight_0 * _S247;
        (*descent_0).total_0 = (*descent_0).total_0 * total_2;
        node_8 = parent_1;
        at_1 = _S242.parent_0;
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
        var _S248 : bool;
        if(((*descent_1).count_3) == u32(0))
        {
            _S248 = !(*descent_1).is_far_0;
        }
        else
        {
            _S248 = false;
        }
        if(_S248)
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
        var left_2 : LightNode_0 = TopLights_node_0((*descent_1).node_2 + u32(1));
        var right_4 : LightNode_0 = TopLights_node_0((*descent_1).index_17);
        var weights_1 : vec2<f32> = weights_of_views_0(view_0(left_2, receiver_5), view_0(right_4, receiver_5));
        var _S249 : f32 = weights_1.x;
        var _S250 : f32 = weights_1.y;
        var total_3 : f32 = _S249 + _S250;
        if(!(total_3 > 0.0f))
        {
            return false;
        }
        var _S251 : bool;
        if(_S250 <= 0.0f)
        {
            _S251 = true;
        }
        else
        {
            _S251 = ((*descent_1).choice_0 * total_3) < (_S249 * (*descent_1).weight_0);
        }
        var is_left_2 : bool;
        if(aim_0.is_met_0)
        {
            var _S252 : vec3<f32> = vec3<f32>(aim_0.hit_3.voxel_1);
            if((all((_S252 >= (vector_of_0(left_2.min_2))))))
            {
                is_left_2 = (all((_S252 < (vector_of_0(left_2.max_2)))));
            }
            else
            {
                is_left_2 = false;
            }
        }
        else
        {
            is_left_2 = _S251;
        }
        var _S253 : f32 = (*descent_1).choice_0 * total_3;
        var _S254 : f32;
        if(is_left_2)
        {
            _S254 = 0.0f;
        }
        else
        {
            _S254 = _S249 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S253 - _S254;
        var _S255 : u32;
        if(is_left_2)
        {
            _S255 = (*descent_1).node_2 + u32(1);
        }
        else
        {
            _S255 = (*descent_1).index_17;
        }
        (*descent_1).node_2 = _S255;
        var _S256 : u32;
        if(is_left_2)
        {
            _S256 = left_2.index_19;
        }
        else
        {
            _S256 = right_4.index_19;
        }
        (*descent_1).index_17 = _S256;
        var _S257 : u32;
        if(is_left_2)
        {
            _S257 = left_2.count_5;
        }
        else
        {
            _S257 = right_4.count_5;
        }
        (*descent_1).count_3 = _S257;
        (*descent_1).is_far_0 = false;
        var _S258 : f32;
        if(is_left_2)
        {
            _S258 = _S249;
        }
        else
        {
            _S258 = _S250;
        }
        var _S259 : f32 = (*descent_1).weight_0 * _S258;
        (*descent_1).weight_0 = _S259;
        (*descent_1).total_0 = (*descent_1).total_0 * total_3;
        if(_S259 <= 0.0f)
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
    var _S260 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(instance_9);
    return Receiver_x24init_0(Transform_point_0(_S260.grid_from_world_0, receiver_6.point_0), normalize_vector_0(Transform_direction_0(_S260.grid_from_world_0, receiver_6.normal_2)));
}

fn lights_in_pages_0() -> bool
{
    return false;
}

fn Rows_operatorx5Bx5D_get_5( row_7 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(5)) + row_7];
}

fn place_in_light_node_0( node_9 : u32,  word_5 : u32) -> u32
{
    return u32(0);
}

fn light_node_at_0( index_22 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S261 : u32 = u32(4) * index_22;
        return light_node_of_0(Rows_operatorx5Bx5D_get_5(_S261), Rows_operatorx5Bx5D_get_5(_S261 + u32(1)), Rows_operatorx5Bx5D_get_5(_S261 + u32(2)), Rows_operatorx5Bx5D_get_5(_S261 + u32(3)));
    }
    var at_2 : u32 = place_in_light_node_0(index_22, u32(0));
    var node_10 : LightNode_0;
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
        node_10.min_2[i_0] = (bitcast<f32>((cells_0[at_2 + i_0])));
        node_10.max_2[i_0] = (bitcast<f32>((cells_0[at_2 + u32(4) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_10.index_19 = cells_0[at_2 + u32(3)];
    node_10.count_5 = cells_0[at_2 + u32(7)];
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
        node_10.power_2[i_0] = (bitcast<f32>((cells_0[at_2 + u32(8) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_10.parent_0 = cells_0[at_2 + u32(14)];
    node_10.root_1 = cells_0[at_2 + u32(15)];
    return node_10;
}

fn GridLights_node_0( index_23 : u32) -> LightNode_0
{
    return light_node_at_0(index_23);
}

fn Descent_at_1( this_40 : ptr<function, Descent_0>,  root_3 : u32)
{
    var node_11 : LightNode_0 = GridLights_node_0(root_3);
    (*this_40).node_2 = root_3;
    (*this_40).index_17 = node_11.index_19;
    (*this_40).count_3 = node_11.count_5;
    (*this_40).is_far_0 = false;
    return;
}

fn descend_1( receiver_7 : Receiver_0,  aim_1 : Aim_0,  descent_2 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S262 : bool;
        if(((*descent_2).count_3) == u32(0))
        {
            _S262 = !(*descent_2).is_far_0;
        }
        else
        {
            _S262 = false;
        }
        if(_S262)
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
        var left_3 : LightNode_0 = GridLights_node_0((*descent_2).node_2 + u32(1));
        var right_5 : LightNode_0 = GridLights_node_0((*descent_2).index_17);
        var of_left_0 : View_0 = view_0(left_3, receiver_7);
        var of_right_0 : View_0 = view_0(right_5, receiver_7);
        var weights_2 : vec2<f32> = weights_of_views_0(of_left_0, of_right_0);
        var _S263 : f32 = weights_2.x;
        var _S264 : f32 = weights_2.y;
        var total_4 : f32 = _S263 + _S264;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S265 : bool;
        if(_S264 <= 0.0f)
        {
            _S265 = true;
        }
        else
        {
            _S265 = ((*descent_2).choice_0 * total_4) < (_S263 * (*descent_2).weight_0);
        }
        var is_left_3 : bool;
        if(aim_1.is_met_0)
        {
            var _S266 : vec3<f32> = vec3<f32>(aim_1.hit_3.voxel_1);
            if((all((_S266 >= (vector_of_0(left_3.min_2))))))
            {
                is_left_3 = (all((_S266 < (vector_of_0(left_3.max_2)))));
            }
            else
            {
                is_left_3 = false;
            }
        }
        else
        {
            is_left_3 = _S265;
        }
        var _S267 : f32 = (*descent_2).choice_0 * total_4;
        var _S268 : f32;
        if(is_left_3)
        {
            _S268 = 0.0f;
        }
        else
        {
            _S268 = _S263 * (*descent_2).weight_0;
        }
        (*descent_2).choice_0 = _S267 - _S268;
        var _S269 : u32;
        if(is_left_3)
        {
            _S269 = (*descent_2).node_2 + u32(1);
        }
        else
        {
            _S269 = (*descent_2).index_17;
        }
        (*descent_2).node_2 = _S269;
        var _S270 : u32;
        if(is_left_3)
        {
            _S270 = left_3.index_19;
        }
        else
        {
            _S270 = right_5.index_19;
        }
        (*descent_2).index_17 = _S270;
        var _S271 : u32;
        if(is_left_3)
        {
            _S271 = left_3.count_5;
        }
        else
        {
            _S271 = right_5.count_5;
        }
        (*descent_2).count_3 = _S271;
        var _S272 : bool;
        if(is_left_3)
        {
            _S272 = of_left_0.is_far_2;
        }
        else
        {
            _S272 = of_right_0.is_far_2;
        }
        (*descent_2).is_far_0 = _S272;
        var _S273 : f32;
        if(is_left_3)
        {
            _S273 = _S263;
        }
        else
        {
            _S273 = _S264;
        }
        var _S274 : f32 = (*descent_2).weight_0 * _S273;
        (*descent_2).weight_0 = _S274;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        if(_S274 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_0( point_3 : vec3<f32>,  is_met_2 : bool,  way_3 : Descent_0,  side_1 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var sent_0 : BySide_0 = sent_by_side_0(light_node_at_0(way_3.node_2), point_3);
    var sum_3 : f32 = normal_or_zero_0(BySide_sum_0(sent_0));
    var unit_1 : f32 = inverse_power_of_two_0(sum_3);
    var total_5 : f32 = sum_3 * unit_1;
    var _S275 : f32 = way_3.choice_0 * total_5;
    var _S276 : u32 = (*side_1);
    var share_1 : f32 = normal_or_zero_0(sent_0.low_9[u32(0)] * unit_1);
    var _S277 : bool;
    if(is_met_2)
    {
        _S277 = u32(0) == _S276;
    }
    else
    {
        _S277 = share_1 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S277)
    {
        (*side_1) = u32(0);
        chosen_2 = share_1;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S278 : bool = _S275 < (share_1 * way_3.weight_0);
    var share_2 : f32 = normal_or_zero_0(sent_0.high_4[u32(0)] * unit_1);
    if(is_met_2)
    {
        _S277 = u32(1) == _S276;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S277 = !_S278;
        }
        else
        {
            _S277 = false;
        }
    }
    if(_S277)
    {
        (*side_1) = u32(1);
        chosen_2 = share_2;
    }
    var passed_0 : f32 = share_1 + share_2;
    if(_S278)
    {
        _S277 = true;
    }
    else
    {
        _S277 = _S275 < (passed_0 * way_3.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_0.low_9[u32(1)] * unit_1);
    var _S279 : bool;
    if(is_met_2)
    {
        _S279 = u32(2) == _S276;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S279 = !_S277;
        }
        else
        {
            _S279 = false;
        }
    }
    if(_S279)
    {
        (*side_1) = u32(2);
        chosen_2 = share_3;
    }
    var passed_1 : f32 = passed_0 + share_3;
    if(_S277)
    {
        _S277 = true;
    }
    else
    {
        _S277 = _S275 < (passed_1 * way_3.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_0.high_4[u32(1)] * unit_1);
    if(is_met_2)
    {
        _S279 = u32(3) == _S276;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S279 = !_S277;
        }
        else
        {
            _S279 = false;
        }
    }
    if(_S279)
    {
        (*side_1) = u32(3);
        chosen_2 = share_4;
    }
    var passed_2 : f32 = passed_1 + share_4;
    if(_S277)
    {
        _S277 = true;
    }
    else
    {
        _S277 = _S275 < (passed_2 * way_3.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_0.low_9[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S279 = u32(4) == _S276;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S279 = !_S277;
        }
        else
        {
            _S279 = false;
        }
    }
    if(_S279)
    {
        (*side_1) = u32(4);
        chosen_2 = share_5;
    }
    var passed_3 : f32 = passed_2 + share_5;
    if(_S277)
    {
        _S277 = true;
    }
    else
    {
        _S277 = _S275 < (passed_3 * way_3.weight_0);
    }
    var share_6 : f32 = normal_or_zero_0(sent_0.high_4[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S277 = u32(5) == _S276;
    }
    else
    {
        if(share_6 > 0.0f)
        {
            _S277 = !_S277;
        }
        else
        {
            _S277 = false;
        }
    }
    if(_S277)
    {
        (*side_1) = u32(5);
        chosen_2 = share_6;
    }
    (*odds_0) = vec2<f32>(way_3.weight_0 * chosen_2, way_3.total_0 * total_5);
    if(sum_3 > 0.0f)
    {
        _S277 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S277 = false;
    }
    return _S277;
}

fn light_node_word_0( index_24 : u32,  word_6 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_5(u32(4) * index_24 + ((word_6 >> (u32(2)))))[(word_6 & (u32(3)))];
}

fn light_power_at_0( index_25 : u32,  side_2 : u32) -> f32
{
    var _S280 : u32;
    if(lights_in_pages_0())
    {
        _S280 = cells_0[place_in_light_node_0(index_25, u32(8) + side_2)];
    }
    else
    {
        _S280 = light_node_word_0(index_25, u32(8) + side_2);
    }
    return (bitcast<f32>((_S280)));
}

fn component_0( vector_5 : vec3<f32>,  axis_5 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_5 == u32(1)), vector_5.x, axis_5 == u32(0));
}

fn density_0( odds_1 : vec2<f32>,  luminance_3 : f32,  power_3 : f32,  toward_3 : vec3<f32>,  face_3 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_3, (face_3 >> (u32(1))));
    var in_front_0 : f32;
    if(((face_3 & (u32(1)))) == u32(1))
    {
        in_front_0 = - along_0;
    }
    else
    {
        in_front_0 = along_0;
    }
    var distance_squared_0 : f32 = length_squared_0(toward_3);
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
     grid_9 : u32,
     faces_0 : u32,
     material_5 : u32,
     luminance_4 : f32,
     leaf_0 : u32,
};

fn below_light_node_0( index_26 : u32) -> vec2<u32>
{
    if(!lights_in_pages_0())
    {
        return vec2<u32>(light_node_word_0(index_26, u32(3)), light_node_word_0(index_26, u32(7)));
    }
    var at_3 : u32 = place_in_light_node_0(index_26, u32(0));
    return vec2<u32>(cells_0[at_3 + u32(3)], cells_0[at_3 + u32(7)]);
}

fn place_in_emitter_0( emitter_0 : u32,  word_7 : u32) -> u32
{
    return u32(0);
}

fn Rows_operatorx5Bx5D_get_6( row_8 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(4)) + row_8];
}

fn emitter_word_0( index_27 : u32,  word_8 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_6(u32(2) * index_27 + ((word_8 >> (u32(2)))))[(word_8 & (u32(3)))];
}

fn emitter_faces_at_0( index_28 : u32) -> u32
{
    var _S281 : u32;
    if(lights_in_pages_0())
    {
        _S281 = cells_0[place_in_emitter_0(index_28, u32(4))];
    }
    else
    {
        _S281 = emitter_word_0(index_28, u32(4));
    }
    return _S281;
}

fn emitter_luminance_at_0( index_29 : u32) -> f32
{
    var _S282 : f32;
    if(lights_in_pages_0())
    {
        _S282 = (bitcast<f32>((cells_0[place_in_emitter_0(index_29, u32(6))])));
    }
    else
    {
        _S282 = (bitcast<f32>((emitter_word_0(index_29, u32(6)))));
    }
    return _S282;
}

fn Emitter_x24init_0( voxel_20 : array<i32, i32(3)>,  grid_10 : u32,  faces_1 : u32,  material_6 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S283 : Emitter_0;
    _S283.voxel_19 = voxel_20;
    _S283.grid_9 = grid_10;
    _S283.faces_0 = faces_1;
    _S283.material_5 = material_6;
    _S283.luminance_4 = luminance_5;
    _S283.leaf_0 = leaf_1;
    return _S283;
}

fn emitter_at_0( index_30 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S284 : u32 = u32(2) * index_30;
        var _S285 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S284);
        var _S286 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S284 + u32(1));
        var _S287 : array<i32, i32(3)> = array<i32, i32(3)>( i32(_S285.x), i32(_S285.y), i32(_S285.z) );
        return Emitter_x24init_0(_S287, _S285.w, _S286.x, _S286.y, (bitcast<f32>((_S286.z))), _S286.w);
    }
    var at_4 : u32 = place_in_emitter_0(index_30, u32(0));
    var _S288 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_0[at_4]), i32(cells_0[at_4 + u32(1)]), i32(cells_0[at_4 + u32(2)]) );
    return Emitter_x24init_0(_S288, cells_0[at_4 + u32(3)], cells_0[at_4 + u32(4)], cells_0[at_4 + u32(5)], (bitcast<f32>((cells_0[at_4 + u32(6)]))), cells_0[at_4 + u32(7)]);
}

fn choose_emitter_0( way_4 : Descent_0,  side_3 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_4 : bool;
    var is_left_4 : bool;
    var count_6 : u32 = way_4.count_3;
    var node_12 : u32 = way_4.node_2;
    var index_31 : u32 = way_4.index_17;
    var _S289 : f32 = threshold_1;
    for(;;)
    {
        if(count_6 == u32(0))
        {
            is_found_4 = !waits_for_pages_0();
        }
        else
        {
            is_found_4 = false;
        }
        if(is_found_4)
        {
        }
        else
        {
            break;
        }
        var left_4 : u32 = node_12 + u32(1);
        var power_left_0 : f32 = light_power_at_0(left_4, side_3);
        if(_S289 < power_left_0)
        {
            is_left_4 = true;
        }
        else
        {
            is_left_4 = (light_power_at_0(index_31, side_3)) <= 0.0f;
        }
        if(is_left_4)
        {
        }
        else
        {
            _S289 = _S289 - power_left_0;
        }
        if(is_left_4)
        {
            node_12 = left_4;
        }
        else
        {
            node_12 = index_31;
        }
        var below_2 : vec2<u32> = below_light_node_0(node_12);
        var _S290 : u32 = below_2.x;
        count_6 = below_2.y;
        index_31 = _S290;
    }
    is_found_4 = false;
    var chosen_3 : u32 = index_31;
    var at_5 : u32 = index_31;
    for(;;)
    {
        if(at_5 < (index_31 + count_6))
        {
            is_left_4 = !is_found_4;
        }
        else
        {
            is_left_4 = false;
        }
        if(is_left_4)
        {
        }
        else
        {
            break;
        }
        if((((((emitter_faces_at_0(at_5)) >> (side_3))) & (u32(1)))) != u32(0))
        {
            var _S291 : f32 = _S289 - emitter_luminance_at_0(at_5);
            is_found_4 = _S289 < (emitter_luminance_at_0(at_5));
            chosen_3 = at_5;
            _S289 = _S291;
        }
        at_5 = at_5 + u32(1);
    }
    return emitter_at_0(chosen_3);
}

fn point_of_face_0( low_11 : vec3<f32>,  face_4 : u32,  u_7 : f32,  v_6 : f32) -> vec3<f32>
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
        return low_11 + vec3<f32>(away_0, u_7, v_6);
    }
    if(face_4 < u32(4))
    {
        return low_11 + vec3<f32>(u_7, away_0, v_6);
    }
    return low_11 + vec3<f32>(u_7, v_6, away_0);
}

fn margin_of_0( translation_1 : vec3<f32>,  low_12 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_12) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn offset_ray_origin_0( translation_2 : vec3<f32>,  low_13 : vec3<f32>,  face_5 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_13);
    var _S292 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_4, low_13 + _S292), low_13 + vec3<f32>((1.0f - margin_0)));
    var _S293 : bool = face_5 < u32(2);
    var _S294 : bool;
    if(face_5 >= u32(2))
    {
        _S294 = face_5 < u32(4);
    }
    else
    {
        _S294 = false;
    }
    var is_axis_2 : vec3<bool> = vec3<bool>(_S293, _S294, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_13 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_13 - _S292;
    }
    return select(moved_0, outside_0, is_axis_2);
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
    var _S295 : bool;
    if(!IS_SINGLE_0)
    {
        _S295 = aim_2.is_met_0;
    }
    else
    {
        _S295 = false;
    }
    if(_S295)
    {
        var _S296 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(aim_2.hit_3.instance_1);
        if((_S296.light_leaf_0) == u32(4294967295))
        {
            _S295 = true;
        }
        else
        {
            var _S297 : bool = climb_0(receiver_8, _S296.light_leaf_0, &(descent_3));
            _S295 = !_S297;
        }
        if(_S295)
        {
            return false;
        }
        Descent_at_0(&(descent_3), _S296.light_leaf_0);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S298 : bool = descend_0(receiver_8, by_chance_0(), &(descent_3));
            _S295 = !_S298;
        }
        else
        {
            _S295 = false;
        }
        if(_S295)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_17;
    var local_2 : Receiver_0 = in_grid_0(descent_3.index_17, receiver_8);
    Descent_at_1(&(descent_3), top_light_node_0(descent_3.node_2).root_1);
    var _S299 : bool = descend_1(local_2, aim_2, &(descent_3));
    if(!_S299)
    {
        return false;
    }
    var side_4 : u32 = aim_2.hit_3.face_1;
    var odds_2 : vec2<f32>;
    var _S300 : bool = choose_side_0(local_2.point_0, aim_2.is_met_0, descent_3, &(side_4), &(odds_2));
    if(!_S300)
    {
        return false;
    }
    var power_4 : f32 = light_power_at_0(descent_3.node_2, side_4);
    var _S301 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(chosen_instance_0);
    if(aim_2.is_met_0)
    {
        var _S302 : f32 = density_0(odds_2, aim_2.luminance_1, power_4, Transform_direction_0(_S301.grid_from_world_0, aim_2.direction_22) * vec3<f32>(aim_2.hit_3.t_1), side_4);
        (*sample_8).pdf_3 = _S302;
        return _S302 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_4, u_8.y * power_4);
    var _S303 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_19));
    var on_face_0 : vec3<f32> = point_of_face_0(_S303, side_4, u_8.z, u_8.w);
    var pdf_8 : f32 = density_0(odds_2, emitter_1.luminance_4, power_4, on_face_0 - local_2.point_0, side_4);
    if(pdf_8 < 0.0f)
    {
        return false;
    }
    var direction_27 : vec3<f32> = Transform_point_0(_S301.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S301.grid_from_world_0.translation_0), _S303, side_4, on_face_0)) - receiver_8.point_0;
    var cos_theta_4 : f32 = with_slack_0(receiver_8, divide_0(dot_product_0(receiver_8.normal_2, direction_27), square_root_0(length_squared_0(direction_27))));
    (*sample_8) = LightSample_x24init_0(Ray_x24init_0(receiver_8.point_0, 0.0f, direction_27, 1.0f), cos_theta_4, emitted_0(material_of_index_0(emitter_1.material_5)), pdf_8);
    return cos_theta_4 > 0.0f;
}

fn EmitterTree_sample_0( receiver_9 : Receiver_0,  u_9 : vec4<f32>,  aim_3 : Aim_0,  sample_9 : ptr<function, LightSample_0>) -> bool
{
    var _S304 : bool = sample_emitter_0(receiver_9, u_9, aim_3, &((*sample_9)));
    return _S304;
}

fn Lights_sample_0( receiver_10 : Receiver_0,  selection_4 : Selection_0,  u_10 : vec4<f32>,  aim_4 : Aim_0,  sample_10 : ptr<function, LightSample_0>) -> bool
{
    var is_found_5 : bool;
    if(has_sun_0())
    {
        is_found_5 = !aim_4.is_met_0;
    }
    else
    {
        is_found_5 = false;
    }
    if(is_found_5)
    {
        is_found_5 = (u_10.x) < (selection_4.sun_0);
    }
    else
    {
        is_found_5 = false;
    }
    if(is_found_5)
    {
        var _S305 : bool = SunDisc_sample_0(receiver_10, u_10, &((*sample_10)));
        (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.sun_0;
        is_found_5 = _S305;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_5 = !aim_4.is_met_0;
        }
        else
        {
            is_found_5 = false;
        }
        if(is_found_5)
        {
            is_found_5 = (u_10.x) < (selection_4.sun_0 + selection_4.sky_1);
        }
        else
        {
            is_found_5 = false;
        }
        if(is_found_5)
        {
            var _S306 : bool = Sky_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - selection_4.sun_0, selection_4.sky_1), 0.99999994039535522f), u_10.yzw), &((*sample_10)));
            (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.sky_1;
            is_found_5 = _S306;
        }
        else
        {
            var _S307 : bool = EmitterTree_sample_0(receiver_10, vec4<f32>(min(divide_0(u_10.x - (selection_4.sun_0 + selection_4.sky_1), selection_4.emitters_0), 0.99999994039535522f), u_10.yzw), aim_4, &((*sample_10)));
            (*sample_10).pdf_3 = (*sample_10).pdf_3 * selection_4.emitters_0;
            is_found_5 = _S307;
        }
    }
    return is_found_5;
}

fn ior_of_0( inside_4 : Inside_0) -> f32
{
    var _S308 : f32;
    if(Inside_is_in_0(inside_4))
    {
        _S308 = material_of_index_0(inside_4.material_0).ior_0;
    }
    else
    {
        _S308 = 1.0f;
    }
    return _S308;
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
    var _S309 : Microfacets_0;
    _S309.alpha_0 = alpha_1;
    return _S309;
}

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S310 : MaterialBsdf_0;
    _S310.kind_0 = kind_1;
    _S310.color_1 = color_2;
    _S310.specular_1 = specular_2;
    _S310.eta_0 = eta_1;
    _S310.facets_0 = facets_1;
    return _S310;
}

fn bsdf_of_0( material_7 : PackedMaterial_0,  ior_1 : f32,  choice_2 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_7.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn MaterialBsdf_albedo_0( this_41 : MaterialBsdf_0) -> vec3<f32>
{
    return this_41.color_1;
}

fn roulette_0( event_2 : u32,  scattered_2 : vec3<f32>,  u_11 : f32) -> f32
{
    if(event_2 < u32(3))
    {
        return 1.0f;
    }
    var _S311 : f32 = min(max_element_0(scattered_2), 0.94999998807907104f);
    var _S312 : f32;
    if(u_11 < _S311)
    {
        _S312 = divide_0(1.0f, _S311);
    }
    else
    {
        _S312 = 0.0f;
    }
    return _S312;
}

struct Surface_0
{
     origin_13 : vec3<f32>,
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
    var _S313 : f32;
    if(face_7 < u32(2))
    {
        _S313 = away_1;
    }
    else
    {
        _S313 = 0.0f;
    }
    var _S314 : bool;
    if(face_7 >= u32(2))
    {
        _S314 = face_7 < u32(4);
    }
    else
    {
        _S314 = false;
    }
    var _S315 : f32;
    if(_S314)
    {
        _S315 = away_1;
    }
    else
    {
        _S315 = 0.0f;
    }
    if(face_7 >= u32(4))
    {
    }
    else
    {
        away_1 = 0.0f;
    }
    return vec3<f32>(_S313, _S315, away_1);
}

fn world_normal_0( instance_11 : PackedInstance_0,  face_8 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_0(instance_11.world_from_grid_0, face_normal_0(face_8)));
}

fn surface_of_0( ray_17 : Ray_0,  hit_5 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S316 : vec3<f32> = vec3<f32>(hit_5.voxel_1);
    if(IS_SINGLE_0)
    {
        surface_0.origin_13 = offset_ray_origin_0(vec3<f32>(0.0f), _S316, hit_5.face_1, ray_17.origin_1 + ray_17.direction_1 * vec3<f32>(hit_5.t_1));
        surface_0.normal_4 = face_normal_0(hit_5.face_1);
    }
    else
    {
        var _S317 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(hit_5.instance_1);
        surface_0.origin_13 = Transform_point_0(_S317.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S317.grid_from_world_0.translation_0), _S316, hit_5.face_1, Transform_point_0(_S317.grid_from_world_0, ray_17.origin_1) + Transform_direction_0(_S317.grid_from_world_0, ray_17.direction_1) * vec3<f32>(hit_5.t_1)));
        surface_0.normal_4 = world_normal_0(_S317, hit_5.face_1);
    }
    surface_0.face_6 = hit_5.face_1;
    surface_0.instance_10 = hit_5.instance_1;
    return surface_0;
}

fn Surface_local_direction_0( this_42 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_42.instance_10).grid_from_world_0, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_3 : vec3<f32>;
    if((this_42.face_6) < u32(2))
    {
        local_3 = in_grid_2.yzx;
    }
    else
    {
        if((this_42.face_6) < u32(4))
        {
            local_3 = in_grid_2.zxy;
        }
        else
        {
            local_3 = in_grid_2;
        }
    }
    if((((this_42.face_6) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_3;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_3.xy, - local_3.z);
    }
    return in_grid_1;
}

fn clamp_to_voxel_0( translation_3 : vec3<f32>,  low_14 : vec3<f32>,  point_5 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_14);
    return min(max(point_5, low_14 + vec3<f32>(margin_1)), low_14 + vec3<f32>((1.0f - margin_1)));
}

fn Inside_point_0( this_43 : Inside_0,  ray_18 : Ray_0,  t_11 : f32) -> vec3<f32>
{
    var _S318 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(this_43.instance_2);
    return Transform_point_0(_S318.world_from_grid_0, clamp_to_voxel_0(vector_of_0(_S318.grid_from_world_0.translation_0), vec3<f32>(this_43.voxel_2), Transform_point_0(_S318.grid_from_world_0, ray_18.origin_1) + Transform_direction_0(_S318.grid_from_world_0, ray_18.direction_1) * vec3<f32>(t_11)));
}

fn Lights_sun_cosine_0( receiver_11 : Receiver_0) -> f32
{
    return dot_product_0(receiver_11.normal_2, params_0.sun_direction_0);
}

fn importance_of_all_0( receiver_12 : Receiver_0) -> f32
{
    if((params_0.light_node_count_0) == u32(0))
    {
        return 0.0f;
    }
    return view_0(top_light_node_0(u32(0)), receiver_12).importance_0 * params_0.light_intensity_0;
}

fn EmitterTree_importance_0( receiver_13 : Receiver_0) -> f32
{
    return importance_of_all_0(receiver_13);
}

fn Lights_sun_probability_0( receiver_14 : Receiver_0) -> f32
{
    if(!has_sun_0())
    {
        return 0.0f;
    }
    var cos_theta_5 : f32 = Lights_sun_cosine_0(receiver_14);
    if(cos_theta_5 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    var from_emitters_0 : f32 = EmitterTree_importance_0(receiver_14);
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_5, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn Lights_sky_probability_0( receiver_15 : Receiver_0) -> f32
{
    var from_sun_1 : f32;
    if(has_sun_0())
    {
        from_sun_1 = params_0.sun_irradiance_0 * max(Lights_sun_cosine_0(receiver_15), 0.0f);
    }
    else
    {
        from_sun_1 = 0.0f;
    }
    var from_others_0 : f32 = from_sun_1 + EmitterTree_importance_0(receiver_15);
    if(from_others_0 <= 0.0f)
    {
        return 1.0f;
    }
    return clamp(divide_0(params_0.sky_irradiance_0, params_0.sky_irradiance_0 + from_others_0), 0.25f, 0.75f);
}

fn Lights_selection_0( receiver_16 : Receiver_0) -> Selection_0
{
    var sun_2 : f32 = Lights_sun_probability_0(receiver_16);
    if(!Lights_has_chosen_sky_0())
    {
        return Selection_x24init_0(sun_2, 0.0f, 1.0f - sun_2);
    }
    var sky_3 : f32 = Lights_sky_probability_0(receiver_16);
    var _S319 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S319, sky_3, (1.0f - sun_2) * _S319);
}

fn MaterialBsdf_is_delta_0( this_44 : MaterialBsdf_0) -> bool
{
    return false;
}

fn Path_dimension_light_0( this_45 : Path_0) -> u32
{
    return u32(2) + u32(2) * Path_events_0(this_45);
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
    var _S320 : Diffuse_0;
    _S320.reflectance_0 = reflectance_1;
    return _S320;
}

fn cosine_hemisphere_pdf_0( cos_theta_6 : f32) -> f32
{
    return max(cos_theta_6, 0.0f) * 0.31830987334251404f;
}

fn BsdfEval_x24init_0( weight_4 : vec3<f32>,  pdf_10 : f32) -> BsdfEval_0
{
    var _S321 : BsdfEval_0;
    _S321.weight_3 = weight_4;
    _S321.pdf_9 = pdf_10;
    return _S321;
}

fn Diffuse_eval_0( this_46 : Diffuse_0,  wo_0 : vec3<f32>,  wi_0 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_46.reflectance_0, cosine_hemisphere_pdf_0(wi_0.z));
}

fn MaterialBsdf_eval_0( this_47 : MaterialBsdf_0,  wo_1 : vec3<f32>,  wi_1 : vec3<f32>) -> BsdfEval_0
{
    return Diffuse_eval_0(Diffuse_x24init_0(this_47.color_1), wo_1, wi_1);
}

struct BsdfSample_0
{
     wi_2 : vec3<f32>,
     weight_5 : vec3<f32>,
     pdf_11 : f32,
     is_delta_0 : bool,
};

fn cosine_hemisphere_0( u_12 : f32,  v_7 : f32) -> vec3<f32>
{
    var radius_6 : f32 = square_root_0(u_12);
    var sin_cos_4 : vec2<f32> = sincos_turns_0(v_7);
    return vec3<f32>(radius_6 * sin_cos_4.y, radius_6 * sin_cos_4.x, square_root_0(1.0f - u_12));
}

fn BsdfSample_x24init_0( wi_3 : vec3<f32>,  weight_6 : vec3<f32>,  pdf_12 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S322 : BsdfSample_0;
    _S322.wi_2 = wi_3;
    _S322.weight_5 = weight_6;
    _S322.pdf_11 = pdf_12;
    _S322.is_delta_0 = is_delta_1;
    return _S322;
}

fn Diffuse_sample_0( this_48 : Diffuse_0,  wo_2 : vec3<f32>,  u_13 : vec3<f32>,  sample_11 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_4 : vec3<f32> = cosine_hemisphere_0(u_13.x, u_13.y);
    (*sample_11) = BsdfSample_x24init_0(wi_4, this_48.reflectance_0, cosine_hemisphere_pdf_0(wi_4.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_49 : MaterialBsdf_0,  wo_3 : vec3<f32>,  u_14 : vec3<f32>,  sample_12 : ptr<function, BsdfSample_0>) -> bool
{
    var _S323 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_49.color_1), wo_3, u_14, &((*sample_12)));
    return _S323;
}

fn Surface_world_direction_0( this_50 : Surface_0,  local_4 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_50.face_6) & (u32(1)))) == u32(1))
    {
        away_2 = local_4.z;
    }
    else
    {
        away_2 = - local_4.z;
    }
    var _S324 : f32 = local_4.x;
    var _S325 : f32 = local_4.y;
    var _S326 : vec3<f32> = vec3<f32>(_S324, _S325, away_2);
    var in_grid_3 : vec3<f32>;
    if((this_50.face_6) < u32(2))
    {
        in_grid_3 = vec3<f32>(away_2, _S324, _S325);
    }
    else
    {
        if((this_50.face_6) < u32(4))
        {
            in_grid_3 = vec3<f32>(_S325, away_2, _S324);
        }
        else
        {
            in_grid_3 = _S326;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_3 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_50.instance_10).world_from_grid_0, in_grid_3);
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
    var _S327 : vec3<f32> = vec3<f32>(0.0f);
    var le_1 : vec3<f32>;
    if(!is_counted_0)
    {
        le_1 = EmitterTree_le_0(material_8);
    }
    else
    {
        le_1 = _S327;
    }
    var is_lit_0 : bool = (max_element_0(le_1)) > 0.0f;
    var met_0 : Aim_0 = Aim_x24init_0(true, ray_19.direction_1, hit_6, luminance_0(vector_of_0(material_8.emission_0)));
    var _S328 : bool = weighs_apart_0();
    if(_S328)
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
        if(!_S328)
        {
            is_chosen_0 = ((*path_5).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_0 = false;
        }
        if(is_chosen_0)
        {
            var _S329 : bool = Lights_sample_0(last_6, Path_selection_at_0((*path_5), last_6), vec4<f32>(0.0f), met_0, &(light_2));
            is_chosen_0 = _S329;
        }
        else
        {
            is_chosen_0 = false;
        }
        var _S330 : vec3<f32> = (*path_5).beta_0 * le_1;
        var _S331 : f32 = (*path_5).pdf_1;
        if(is_chosen_0)
        {
            light_pdf_1 = light_2.pdf_3;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + _S330 * vec3<f32>(mis_weight_0(_S331, light_pdf_1));
    }
    var _S332 : f32 = ior_of_0((*path_5).inside_0);
    var _S333 : f32 = u_15[i32(3)];
    var _S334 : MaterialBsdf_0 = bsdf_of_0(material_8, _S332, &(_S333));
    u_15[i32(3)] = _S333;
    var scattered_3 : vec3<f32> = (*path_5).beta_0 * MaterialBsdf_albedo_0(_S334);
    var _S335 : bool = ((*path_5).bounce_0) >= (params_0.max_bounces_0);
    var _S336 : bool = !is_weighed_0;
    if(_S336)
    {
        if(_S335)
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
    if(_S336)
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
    var _S337 : Receiver_0 = Receiver_x24init_0(surface_1.origin_13, surface_1.normal_4);
    var _S338 : vec3<f32> = (vec3<f32>(0) - ray_19.direction_1);
    var wo_4 : vec3<f32> = Surface_local_direction_0(surface_1, _S338);
    var inside_5 : Inside_0 = in_air_0();
    var wo_5 : vec3<f32>;
    var receiver_17 : Receiver_0;
    if(is_scattered_0)
    {
        var _S339 : Inside_0 = Inside_x24init_0((*path_5).inside_0.instance_2, hit_6.voxel_1, (*path_5).inside_0.material_0);
        inside_5 = _S339;
        var _S340 : vec3<f32> = normalize_vector_0(_S338);
        receiver_17 = Receiver_x24init_0(Inside_point_0(_S339, ray_19, t_12), _S327);
        wo_5 = _S340;
    }
    else
    {
        if(Inside_is_in_0((*path_5).inside_0))
        {
            next_0.relocates_1 = (hit_6.instance_1) != ((*path_5).inside_0.instance_2);
            inside_5 = Inside_x24init_0((*path_5).inside_0.instance_2, hit_6.voxel_1, (*path_5).inside_0.material_0);
            inside_5.voxel_2 = hit_6.voxel_1 + vec3<i32>(face_normal_0(hit_6.face_1));
        }
        receiver_17 = _S337;
        wo_5 = wo_4;
    }
    next_0.origin_11 = receiver_17.point_0;
    next_0.shadow_inside_1 = inside_5;
    var _S341 : Aim_0 = by_chance_0();
    var aim_5 : Aim_0;
    if(is_weighed_0)
    {
        receiver_17 = last_6;
        aim_5 = met_0;
    }
    else
    {
        aim_5 = _S341;
    }
    if(_S336)
    {
        (*path_5).selection_0 = Lights_selection_0(receiver_17);
    }
    var light_3 : LightSample_0 = no_light_0();
    var _S342 : bool = !MaterialBsdf_is_delta_0(_S334);
    if(is_weighed_0)
    {
        is_chosen_0 = true;
    }
    else
    {
        is_chosen_0 = _S342;
    }
    if(is_chosen_0)
    {
        var _S343 : bool = Lights_sample_0(receiver_17, (*path_5).selection_0, Sampler_stratified_0((*path_5).sampler_0, Path_dimension_light_0((*path_5))), aim_5, &(light_3));
        next_0.has_shadow_ray_0 = _S343;
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
        var _S344 : vec3<f32> = vec3<f32>(Surface_local_direction_0(surface_1, light_3.ray_15.direction_1).xy, light_3.cos_theta_0);
        var wi_5 : vec3<f32>;
        if(is_scattered_0)
        {
            wi_5 = normalize_vector_0(light_3.ray_15.direction_1);
        }
        else
        {
            wi_5 = _S344;
        }
        var eval_0 : BsdfEval_0 = MaterialBsdf_eval_0(_S334, wo_5, wi_5);
        var share_8 : f32 = divide_0(eval_0.pdf_9, light_3.pdf_3) * power_heuristic_0(light_3.pdf_3, eval_0.pdf_9);
        next_0.shadow_direction_0 = light_3.ray_15.direction_1;
        next_0.shadow_t_max_0 = light_3.ray_15.t_max_1;
        next_0.light_0 = (*path_5).beta_0 * eval_0.weight_3 * vec3<f32>(compensation_0) * light_3.radiance_2 * vec3<f32>(share_8);
    }
    var bounce_4 : BsdfSample_0;
    var _S345 : bool = MaterialBsdf_sample_0(_S334, wo_5, vec3<f32>(u_15.xy, u_15.w), &(bounce_4));
    if(!_S345)
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
    (*path_5).normal_0 = receiver_17.normal_2;
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
    var relative_4 : vec2<u32> = at_7 - params_0.region_0.xy;
    return relative_4.y * (params_0.region_0.z - params_0.region_0.x) + relative_4.x;
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
        var _S346 : u32 = (mantissa_3 << (u32(shift_6)));
        var _S347 : u32;
        if(shift_6 == i32(0))
        {
            _S347 = u32(0);
        }
        else
        {
            _S347 = (mantissa_3 >> (u32(i32(32) - shift_6)));
        }
        return vec2<u32>(_S346, _S347);
    }
    return vec2<u32>(u32(0), (mantissa_3 << (u32(shift_6 - i32(32)))));
}

fn PixelRecord_add_0( this_51 : ptr<function, PixelRecord_0>,  value_3 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_3[u32(0)]);
    var _S348 : u32 = addend_0.x;
    var low_15 : u32 = (*this_51).radiance_1[u32(0)] + _S348;
    var high_6 : u32 = (*this_51).radiance_1[u32(1)] + addend_0.y + u32(low_15 < _S348);
    var is_full_0 : bool = high_6 < ((*this_51).radiance_1[u32(1)]);
    var _S349 : u32;
    if(is_full_0)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = low_15;
    }
    (*this_51).radiance_1[u32(0)] = _S349;
    if(is_full_0)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = high_6;
    }
    (*this_51).radiance_1[u32(1)] = _S349;
    var addend_1 : vec2<u32> = fixed_point_0(value_3[u32(1)]);
    var _S350 : u32 = addend_1.x;
    var low_16 : u32 = (*this_51).radiance_1[u32(2)] + _S350;
    var high_7 : u32 = (*this_51).radiance_1[u32(3)] + addend_1.y + u32(low_16 < _S350);
    var is_full_1 : bool = high_7 < ((*this_51).radiance_1[u32(3)]);
    if(is_full_1)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = low_16;
    }
    (*this_51).radiance_1[u32(2)] = _S349;
    if(is_full_1)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = high_7;
    }
    (*this_51).radiance_1[u32(3)] = _S349;
    var addend_2 : vec2<u32> = fixed_point_0(value_3[u32(2)]);
    var _S351 : u32 = addend_2.x;
    var low_17 : u32 = (*this_51).radiance_1[u32(4)] + _S351;
    var high_8 : u32 = (*this_51).radiance_1[u32(5)] + addend_2.y + u32(low_17 < _S351);
    var is_full_2 : bool = high_8 < ((*this_51).radiance_1[u32(5)]);
    if(is_full_2)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = low_17;
    }
    (*this_51).radiance_1[u32(4)] = _S349;
    if(is_full_2)
    {
        _S349 = u32(4294967295);
    }
    else
    {
        _S349 = high_8;
    }
    (*this_51).radiance_1[u32(5)] = _S349;
    (*this_51).samples_0 = (*this_51).samples_0 + u32(1);
    (*this_51).covered_0 = (*this_51).covered_0 + u32(is_covered_0);
    return;
}

fn add_sample_0( index_32 : u32,  radiance_7 : vec3<f32>,  is_covered_1 : bool)
{
    var pixel_6 : PixelRecord_0;
    pixel_6.radiance_1 = pixels_0[index_32].radiance_1;
    pixel_6.samples_0 = pixels_0[index_32].samples_0;
    pixel_6.covered_0 = pixels_0[index_32].covered_0;
    PixelRecord_add_0(&(pixel_6), radiance_7, is_covered_1);
    pixels_0[index_32].radiance_1 = pixel_6.radiance_1;
    pixels_0[index_32].samples_0 = pixel_6.samples_0;
    pixels_0[index_32].covered_0 = pixel_6.covered_0;
    return;
}

fn trace_pixel_0( work_0 : Work_0) -> RayCounts_0
{
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S352 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_8 : vec3<f32> = _S352;
    var path_6 : Path_0;
    var _S353 : Ray_0 = camera_path_0(work_0.pixel_5, work_0.sample_5, &(path_6));
    var ray_20 : Ray_0 = _S353;
    var shadow_inside_3 : Inside_0 = in_air_0();
    var relocates_3 : bool = true;
    var path_relocates_3 : bool = true;
    var is_shadow_turn_0 : bool = true;
    var is_shadow_ray_1 : bool = false;
    var direction_28 : vec3<f32> = _S352;
    var is_covered_2 : bool = false;
    var sample_13 : u32 = work_0.sample_5;
    var light_4 : vec3<f32> = _S352;
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
        var _S354 : Sampler_0 = sampler_of_0(work_0.pixel_5, sample_13);
        var beyond_4 : u32;
        var _S355 : Hit_0 = hit_of_ray_0(_S354, &(ray_20), is_shadow_ray_1, &(path_6), &(shadow_inside_3), &(relocates_3), &(path_relocates_3), &(beyond_4));
        var _S356 : bool = waits_for_pages_0();
        if(_S356)
        {
            break;
        }
        var is_covered_3 : bool;
        if(is_shadow_ray_1)
        {
            counts_0.shadow_0 = counts_0.shadow_0 + u32(1);
            if(Hit_is_miss_0(_S355))
            {
                radiance_8 = radiance_8 + light_4;
            }
            ray_20 = PathTracingOf_clip_0(ray_from_0(ray_20.origin_1, direction_28));
            is_shadow_ray_1 = false;
        }
        else
        {
            if((Path_events_0(path_6)) == u32(0))
            {
                if(!Hit_is_miss_0(_S355))
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
            var _S357 : NextRays_0 = no_rays_0();
            path_6.sampler_0 = _S354;
            var _S358 : bool;
            if(is_covered_3)
            {
                _S358 = true;
            }
            else
            {
                _S358 = (params_0.is_transparent_0) == u32(0);
            }
            var next_1 : NextRays_0;
            if(_S358)
            {
                var _S359 : NextRays_0 = PathTracingOf_advance_0(&(path_6), ray_20, _S355, beyond_4, &(radiance_8));
                next_1 = _S359;
            }
            else
            {
                next_1 = _S357;
            }
            var _S360 : bool;
            if(weighs_apart_0())
            {
                _S360 = next_1.is_same_0;
            }
            else
            {
                _S360 = false;
            }
            if(_S360)
            {
                is_shadow_turn_0 = is_shadow_turn_1;
                is_covered_2 = is_covered_3;
                continue;
            }
            var _S361 : NextRays_0 = next_1;
            var _S362 : NextRays_0 = next_1;
            var _S363 : NextRays_0 = next_1;
            var _S364 : NextRays_0 = next_1;
            ray_20 = PathTracingOf_clip_0(ray_from_0(next_1.origin_11, next_1.direction_6));
            if(_S363.has_shadow_ray_0)
            {
                ray_20 = Ray_x24init_0(_S364.origin_11, 0.0f, next_1.shadow_direction_0, next_1.shadow_t_max_0);
            }
            is_shadow_ray_1 = _S363.has_shadow_ray_0;
            direction_28 = _S361.direction_6;
            is_covered_2 = is_covered_3;
            light_4 = _S362.light_0;
        }
        if(_S356)
        {
            break;
        }
        if(!is_shadow_ray_1)
        {
            is_covered_3 = (all((direction_28 == _S352)));
        }
        else
        {
            is_covered_3 = false;
        }
        if(is_covered_3)
        {
            var _S365 : vec2<u32> = position_of_0(work_0.pixel_5);
            add_sample_0(place_of_0(_S365), radiance_8, is_covered_2);
            radiance_8 = _S352;
            var sample_14 : u32 = sample_13 + u32(1);
            if(sample_14 == (work_0.last_2))
            {
                break;
            }
            var _S366 : Ray_0 = camera_path_0(work_0.pixel_5, sample_14, &(path_6));
            ray_20 = _S366;
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
    var _S367 : Hit_0 = WalkTracer_trace_0(&((*ray_21)), is_shadow_ray_2);
    return _S367;
}

fn Essay_jitter_0( sampler_5 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_5, u32(0));
}

fn Essay_clip_0( ray_22 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_22.origin_1, 0.10000000149011612f, ray_22.direction_1, 10000.0f);
}

fn camera_path_1( pixel_7 : u32,  sample_15 : u32,  path_8 : ptr<function, Path_0>) -> Ray_0
{
    (*path_8) = Path_x24init_0(sampler_of_0(pixel_7, sample_15), u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
    var jitter_1 : vec4<f32> = Essay_jitter_0((*path_8).sampler_0);
    var _S368 : CameraFrame_0 = FrameParams_camera_0();
    var _S369 : vec2<u32> = position_of_0(pixel_7);
    return Essay_clip_0(CameraFrame_ray_0(_S368, vec2<f32>(_S369) + jitter_1.xy, jitter_1.zw));
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
    next_2.origin_11 = surface_2.origin_13;
    next_2.direction_6 = Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_16.x, u_16.y));
    return next_2;
}

fn trace_pixel_1( work_1 : Work_0) -> RayCounts_0
{
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S370 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_10 : vec3<f32> = _S370;
    var path_10 : Path_0;
    var _S371 : Ray_0 = camera_path_1(work_1.pixel_5, work_1.sample_5, &(path_10));
    var ray_24 : Ray_0 = _S371;
    var shadow_inside_5 : Inside_0 = in_air_0();
    var relocates_5 : bool = true;
    var path_relocates_5 : bool = true;
    var is_shadow_ray_3 : bool = false;
    var direction_29 : vec3<f32> = _S370;
    var is_covered_4 : bool = false;
    var sample_16 : u32 = work_1.sample_5;
    var light_5 : vec3<f32> = _S370;
    for(;;)
    {
        if(sample_16 < (work_1.last_2))
        {
        }
        else
        {
            break;
        }
        var _S372 : Sampler_0 = sampler_of_0(work_1.pixel_5, sample_16);
        var beyond_7 : u32;
        var _S373 : Hit_0 = hit_of_ray_1(_S372, &(ray_24), is_shadow_ray_3, &(path_10), &(shadow_inside_5), &(relocates_5), &(path_relocates_5), &(beyond_7));
        var _S374 : bool = waits_for_pages_0();
        if(_S374)
        {
            break;
        }
        var is_covered_5 : bool;
        if(is_shadow_ray_3)
        {
            counts_1.shadow_0 = counts_1.shadow_0 + u32(1);
            if(Hit_is_miss_0(_S373))
            {
                radiance_10 = radiance_10 + light_5;
            }
            ray_24 = Essay_clip_0(ray_from_0(ray_24.origin_1, direction_29));
            is_shadow_ray_3 = false;
        }
        else
        {
            if((Path_events_0(path_10)) == u32(0))
            {
                if(!Hit_is_miss_0(_S373))
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
            var _S375 : NextRays_0 = no_rays_0();
            path_10.sampler_0 = _S372;
            var _S376 : bool;
            if(is_covered_5)
            {
                _S376 = true;
            }
            else
            {
                _S376 = (params_0.is_transparent_0) == u32(0);
            }
            var next_3 : NextRays_0;
            if(_S376)
            {
                var _S377 : NextRays_0 = Essay_advance_0(&(path_10), ray_24, _S373, beyond_7, &(radiance_10));
                next_3 = _S377;
            }
            else
            {
                next_3 = _S375;
            }
            var _S378 : bool;
            if(weighs_apart_0())
            {
                _S378 = next_3.is_same_0;
            }
            else
            {
                _S378 = false;
            }
            if(_S378)
            {
                is_covered_4 = is_covered_5;
                continue;
            }
            var _S379 : NextRays_0 = next_3;
            var _S380 : NextRays_0 = next_3;
            var _S381 : NextRays_0 = next_3;
            var _S382 : NextRays_0 = next_3;
            ray_24 = Essay_clip_0(ray_from_0(next_3.origin_11, next_3.direction_6));
            if(_S381.has_shadow_ray_0)
            {
                ray_24 = Ray_x24init_0(_S382.origin_11, 0.0f, next_3.shadow_direction_0, next_3.shadow_t_max_0);
            }
            is_shadow_ray_3 = _S381.has_shadow_ray_0;
            direction_29 = _S379.direction_6;
            is_covered_4 = is_covered_5;
            light_5 = _S380.light_0;
        }
        if(_S374)
        {
            break;
        }
        if(!is_shadow_ray_3)
        {
            is_covered_5 = (all((direction_29 == _S370)));
        }
        else
        {
            is_covered_5 = false;
        }
        if(is_covered_5)
        {
            var _S383 : vec2<u32> = position_of_0(work_1.pixel_5);
            add_sample_0(place_of_0(_S383), radiance_10, is_covered_4);
            radiance_10 = _S370;
            var sample_17 : u32 = sample_16 + u32(1);
            if(sample_17 == (work_1.last_2))
            {
                break;
            }
            var _S384 : Ray_0 = camera_path_1(work_1.pixel_5, sample_17, &(path_10));
            ray_24 = _S384;
            relocates_5 = true;
            path_relocates_5 = true;
            sample_16 = sample_17;
        }
    }
    return counts_1;
}

fn Work_x24init_0( pixel_8 : u32,  sample_18 : u32,  last_7 : u32) -> Work_0
{
    var _S385 : Work_0;
    _S385.pixel_5 = pixel_8;
    _S385.sample_5 = sample_18;
    _S385.last_2 = last_7;
    return _S385;
}

fn work_of_0( index_33 : u32) -> Work_0
{
    var size_1 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S386 : u32 = size_1.x;
    var _S387 : u32 = u32(8) * _S386;
    var band_0 : u32 = index_33 / _S387;
    var _S388 : u32 = u32(8) * band_0;
    var in_band_0 : u32 = index_33 - _S387 * band_0;
    var _S389 : u32 = u32(8) * min(u32(8), size_1.y - _S388);
    var tile_0 : u32 = in_band_0 / _S389;
    var _S390 : u32 = u32(8) * tile_0;
    var _S391 : u32 = min(u32(8), _S386 - _S390);
    var in_tile_0 : u32 = in_band_0 - _S389 * tile_0;
    var _S392 : vec2<u32> = params_0.region_0.xy;
    var _S393 : u32 = in_tile_0 % _S391;
    var _S394 : u32 = _S390 + _S393;
    var _S395 : u32 = in_tile_0 / _S391;
    var at_8 : vec2<u32> = _S392 + vec2<u32>(_S394, _S388 + _S395);
    return Work_x24init_0(at_8.y * params_0.width_0 + at_8.x, pixels_0[place_of_0(at_8)].samples_0, min(dispatch_0.samples_target_0, pixels_0[place_of_0(at_8)].samples_0 + dispatch_0.samples_1));
}

fn render_0( index_34 : u32,  thread_0 : u32)
{
    if(index_34 < (dispatch_0.count_0))
    {
        var work_2 : Work_0 = work_of_0(dispatch_0.first_0 + index_34);
        var _S396 : RayCounts_0 = trace_pixel_0(work_2);
    }
    return;
}

fn render_1( index_35 : u32,  thread_1 : u32)
{
    if(index_35 < (dispatch_0.count_0))
    {
        var work_3 : Work_0 = work_of_0(dispatch_0.first_0 + index_35);
        var _S397 : RayCounts_0 = trace_pixel_1(work_3);
    }
    return;
}

fn hit_of_0( ray_25 : LocalRay_0,  voxel_21 : vec3<i32>,  instance_12 : u32) -> Hit_0
{
    return hit_at_0(crossing_among_0(LocalRay_mirrored_origin_0(ray_25), abs(ray_25.direction_2), select(voxel_21, ~voxel_21, (ray_25.direction_2) < vec3<f32>(0.0f)), false), ray_25.t_min_2, abs(ray_25.inverse_0), voxel_21, instance_12, LocalRay_octant_0(ray_25));
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_2 : u32)
{
    render_1(id_0.x, thread_2);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_path(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    render_0(id_1.x, thread_3);
    return;
}

fn WalkTracer_trace_1( ray_26 : ptr<function, Ray_0>,  is_any_enough_2 : bool) -> Hit_0
{
    var _S398 : Hit_0 = visit_0(&((*ray_26)), is_any_enough_2, u32(0));
    return _S398;
}

struct HitRecord_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : array<i32, i32(3)>,
     face_0 : u32,
};

fn HitRecord_x24init_0( t_13 : f32,  instance_13 : u32,  voxel_22 : array<i32, i32(3)>,  face_9 : u32) -> HitRecord_0
{
    var _S399 : HitRecord_0;
    _S399.t_0 = t_13;
    _S399.instance_0 = instance_13;
    _S399.voxel_0 = voxel_22;
    _S399.face_0 = face_9;
    return _S399;
}

fn record_of_0( hit_8 : Hit_0) -> HitRecord_0
{
    var _S400 : array<i32, i32(3)> = array<i32, i32(3)>( hit_8.voxel_1.x, hit_8.voxel_1.y, hit_8.voxel_1.z );
    return HitRecord_x24init_0(hit_8.t_1, hit_8.instance_1, _S400, hit_8.face_1);
}

fn ray_of_0( _S401 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S401].origin_0), rays_0[_S401].t_min_0, vector_of_0(rays_0[_S401].direction_0), rays_0[_S401].t_max_0);
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    var _S402 : u32 = id_2.x;
    if(_S402 < (dispatch_0.count_0))
    {
        var _S403 : Ray_0 = ray_of_0(dispatch_0.first_0 + _S402);
        var ray_27 : Ray_0 = _S403;
        var _S404 : Hit_0 = WalkTracer_trace_1(&(ray_27), false);
        var _S405 : bool;
        if(IS_SINGLE_0)
        {
            _S405 = !IS_EXACT_0;
        }
        else
        {
            _S405 = false;
        }
        if(_S405)
        {
            _S405 = !Hit_is_miss_0(_S404);
        }
        else
        {
            _S405 = false;
        }
        var hit_9 : Hit_0;
        if(_S405)
        {
            hit_9 = hit_of_0(local_ray_0(_S403, Instances_operatorx5Bx5D_get_0(u32(0)).grid_from_world_0), _S404.voxel_1, _S404.instance_1);
        }
        else
        {
            hit_9 = _S404;
        }
        var _S406 : HitRecord_0 = record_of_0(hit_9);
        hits_0[dispatch_0.first_0 + _S402].t_0 = _S406.t_0;
        hits_0[dispatch_0.first_0 + _S402].instance_0 = _S406.instance_0;
        hits_0[dispatch_0.first_0 + _S402].voxel_0 = _S406.voxel_0;
        hits_0[dispatch_0.first_0 + _S402].face_0 = _S406.face_0;
    }
    return;
}

