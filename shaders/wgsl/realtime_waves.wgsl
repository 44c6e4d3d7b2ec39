var<private> infinity_bits_0 : u32 = 2139095040u;
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
@binding(27) @group(0) var<storage, read_write> cell_keys_0 : array<atomic<u32>>;

@binding(28) @group(0) var<storage, read_write> cell_rows_0 : array<vec4<u32>>;

@binding(3) @group(0) var<storage, read> records_0 : array<vec4<u32>>;

@binding(0) @group(0) var<storage, read> cells_1 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(26) @group(0) var<storage, read_write> scratch_0 : array<vec2<u32>>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

@binding(29) @group(0) var<storage, read> motions_1 : array<vec4<f32>>;

@binding(25) @group(0) var<storage, read_write> memory_rows_0 : array<vec4<u32>>;

@binding(30) @group(0) var<storage, read_write> rest_0 : array<u32>;

@id(6) override SKY_0 : u32 = u32(0);

struct Hit_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : vec3<i32>,
     face_0 : u32,
};

struct Ray_0
{
     origin_0 : vec3<f32>,
     t_min_0 : f32,
     direction_0 : vec3<f32>,
     t_max_0 : f32,
};

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
     origin_1 : vec3<f32>,
     direction_1 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_1 : f32,
     t_max_1 : f32,
     is_valid_0 : bool,
};

@id(1) override IS_SINGLE_0 : bool = false;

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
    var rest_1 : i32 = i32(((dividend_0 << (u32(23)))) - guess_0 * divisor_0);
    var units_0 : i32 = i32(floor(f32(rest_1) * (1.0f / f32(divisor_0)) + 0.5f));
    var _S11 : i32 = i32(divisor_0);
    var _S12 : i32 = i32(2) * (rest_1 - units_0 * _S11);
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
    var direction_2 : vec3<f32>;
    var origin_2 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S16 : vec3<f32> = Transform_point_0(grid_from_world_2, ray_0.origin_0);
        direction_2 = Transform_direction_0(grid_from_world_2, ray_0.direction_0);
        origin_2 = _S16;
    }
    else
    {
        direction_2 = ray_0.direction_0;
        origin_2 = ray_0.origin_0;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_2)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S17 : vec3<f32> = select(direction_2, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_1 = _S17;
    local_0.inverse_0 = select(reciprocal_0(select(direction_2, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_1 = select(origin_2, floor(origin_2) + vec3<f32>(0.5f), is_zero_0);
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
    var is_near_0 : bool = (all(((abs(local_0.origin_1)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((ray_0.t_min_0) >= 0.0f)
    {
        is_segment_0 = (ray_0.t_min_0) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (ray_0.t_min_0) <= (ray_0.t_max_0);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_1 = ray_0.t_min_0;
    local_0.t_max_1 = ray_0.t_max_0;
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

fn Hit_x24init_0( t_1 : f32,  instance_1 : u32,  voxel_1 : vec3<i32>,  face_1 : u32) -> Hit_0
{
    var _S18 : Hit_0;
    _S18.t_0 = t_1;
    _S18.instance_0 = instance_1;
    _S18.voxel_0 = voxel_1;
    _S18.face_0 = face_1;
    return _S18;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>(infinity_bits_0)), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

struct PackedGrid_0
{
     origin_3 : array<i32, i32(3)>,
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
    grid_2.origin_3[i32(0)] = i32(_S19.x);
    grid_2.origin_3[i32(1)] = _S23;
    grid_2.origin_3[i32(2)] = _S24;
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
     origin_4 : vec3<f32>,
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
    return (((u32((this_2.direction_1.x) < 0.0f) | (((u32((this_2.direction_1.y) < 0.0f) << (u32(1))))))) | (((u32((this_2.direction_1.z) < 0.0f) << (u32(2))))));
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
    return select(this_5.origin_1, (vec3<f32>(0) - this_5.origin_1), (this_5.direction_1) < vec3<f32>(0.0f));
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
    return select((abs(this_6.origin_1) + (vec3<f32>(max(abs(low_0), abs(high_0))) + vec3<f32>(1.0f))) * vec3<f32>(5.36441802978515625e-07f), vec3<f32>(-1.0f), (this_6.direction_1) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_1 * 1.00000095367431641f, 3.4028234663852886e+38f);
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
    walk_0.origin_4 = LocalRay_mirrored_origin_0(ray_2);
    var _S35 : vec3<f32> = abs(ray_2.direction_1);
    var _S36 : vec3<f32> = abs(ray_2.inverse_0);
    var is_still_0 : vec3<bool> = (ray_2.direction_1) == vec3<f32>(0.0f);
    walk_0.speed_1 = select(_S35, vec3<f32>((max_element_0(_S35) * 9.99999993922529029e-09f)), is_still_0);
    walk_0.inverse_1 = select(_S36, vec3<f32>((min_element_0(_S36) * 9.99999986991104e+14f)), is_still_0);
    if(!IS_EXACT_0)
    {
        var _S37 : vec3<f32> = vec3<f32>(base_1);
        walk_0.origin_4 = select(ray_2.origin_1 - _S37, _S37 - ray_2.origin_1, (ray_2.direction_1) < vec3<f32>(0.0f));
        var _S38 : vec3<f32> = max(_S35, vec3<f32>(1.00000004581370497e-18f));
        walk_0.speed_1 = _S38;
        walk_0.inverse_1 = vec3<f32>(1.0f) / _S38;
    }
    var low_1 : vec3<i32> = cell_of_0(grid_4.origin_3);
    walk_0.tolerance_0 = LocalRay_tolerance_0(ray_2, low_1, low_1 + (((cell_of_0(grid_4.top_size_0)) << (vec3<u32>(top_shift_of_0(grid_4))))));
    walk_0.t_end_0 = LocalRay_t_end_0(ray_2);
    return walk_0;
}

fn Walk_mirrored_0( this_8 : Walk_0,  voxel_2 : vec3<i32>) -> vec3<i32>
{
    return (voxel_2 ^ ((Walk_mirror_0(this_8))));
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
    var way_0 : vec2<f32> = exact_product_0(ray_3.t_min_1, ray_3.direction_1[u32(0)]);
    var _S43 : f32 = way_0.x;
    var sum_0 : f32 = ray_3.origin_1[u32(0)] + _S43;
    var part_0 : f32 = sum_0 - ray_3.origin_1[u32(0)];
    var low_2 : f32 = ray_3.origin_1[u32(0)] - (sum_0 - part_0) + (_S43 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_3 : vec3<i32>;
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
    voxel_3[u32(0)] = _S44 - i32(_S45);
    var way_1 : vec2<f32> = exact_product_0(ray_3.t_min_1, ray_3.direction_1[u32(1)]);
    var _S46 : f32 = way_1.x;
    var sum_1 : f32 = ray_3.origin_1[u32(1)] + _S46;
    var part_1 : f32 = sum_1 - ray_3.origin_1[u32(1)];
    var low_3 : f32 = ray_3.origin_1[u32(1)] - (sum_1 - part_1) + (_S46 - part_1) + way_1.y;
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
    voxel_3[u32(1)] = _S47 - i32(_S45);
    var way_2 : vec2<f32> = exact_product_0(ray_3.t_min_1, ray_3.direction_1[u32(2)]);
    var _S48 : f32 = way_2.x;
    var sum_2 : f32 = ray_3.origin_1[u32(2)] + _S48;
    var part_2 : f32 = sum_2 - ray_3.origin_1[u32(2)];
    var low_4 : f32 = ray_3.origin_1[u32(2)] - (sum_2 - part_2) + (_S48 - part_2) + way_2.y;
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
    voxel_3[u32(2)] = _S49 - i32(_S45);
    return voxel_3;
}

fn Walk_start_voxel_0( this_9 : Walk_0) -> vec3<i32>
{
    var start_0 : vec3<f32> = clamp(this_9.ray_1.origin_1 + this_9.ray_1.direction_1 * vec3<f32>(this_9.ray_1.t_min_1), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_9, vec3<i32>(floor(start_0)) - this_9.base_0);
    }
    var nearest_0 : vec3<f32> = round(start_0);
    var from_nearest_0 : vec3<f32> = start_0 - nearest_0;
    var _S50 : bool;
    if((this_9.ray_1.t_min_1) > 0.0f)
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
        return ((bitcast<vec3<f32>>((planes_1 + this_10.offset_0 + vec3<i32>(i32(1262485504))))) - vec3<f32>(1.2582912e+07f) - this_10.origin_4) * this_10.inverse_1;
    }
    return (vec3<f32>(planes_1 + this_10.offset_0) - this_10.origin_4) * this_10.inverse_1;
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

fn crossing_ahead_0( origin_5 : f32,  speed_4 : f32,  axis_2 : u32,  plane_1 : i32) -> Crossing_0
{
    var at_0 : f32 = f32(plane_1);
    var difference_0 : f32 = at_0 - origin_5;
    var part_3 : f32 = difference_0 - at_0;
    return Crossing_x24init_0(difference_0, at_0 - (difference_0 - part_3) - (origin_5 + part_3), speed_4, axis_2);
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

fn crossing_among_0( origin_6 : vec3<f32>,  speed_5 : vec3<f32>,  planes_2 : vec3<i32>,  is_first_0 : bool) -> Crossing_0
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
                var crossing_0 : Crossing_0 = crossing_ahead_0(origin_6[u32(0)], speed_5[u32(0)], u32(0), planes_2[u32(0)]);
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
                var crossing_1 : Crossing_0 = crossing_ahead_0(origin_6[u32(1)], speed_5[u32(1)], u32(1), planes_2[u32(1)]);
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
                var crossing_2 : Crossing_0 = crossing_ahead_0(origin_6[u32(2)], speed_5[u32(2)], u32(2), planes_2[u32(2)]);
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

fn leave_box_0( origin_7 : vec3<f32>,  speed_6 : vec3<f32>,  voxel_4 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_1 : vec3<i32>) -> vec3<i32>
{
    var is_crossed_0 : bool;
    var plane_2 : i32;
    var _S56 : Crossing_0 = crossing_among_0(origin_7, speed_6, exit_0, true);
    var arrival_0 : vec3<i32> = voxel_4;
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
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_7[u32(0)], speed_6[u32(0)], u32(0), nearest_1[u32(0)]), _S56);
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
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_7[u32(1)], speed_6[u32(1)], u32(1), nearest_1[u32(1)]), _S56);
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
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_7[u32(2)], speed_6[u32(2)], u32(2), nearest_1[u32(2)]), _S56);
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

fn Walk_arrive_0( this_12 : Walk_0,  voxel_5 : vec3<i32>,  t_2 : f32,  is_axis_0 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_0 : vec3<f32> = this_12.origin_4 + this_12.speed_1 * vec3<f32>(t_2);
    if(IS_EXACT_0)
    {
        var position_1 : vec3<f32> = clamp(position_0, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_2 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_2;
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_0, (abs(from_nearest_1)) <= (this_12.tolerance_0)))))))
        {
            return max(leave_box_0(this_12.origin_4, this_12.speed_1, voxel_5 + this_12.offset_0, exit_1 + this_12.offset_0, vec3<i32>(nearest_2)) - this_12.offset_0, voxel_5);
        }
        return select(vec3<i32>(nearest_2) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f)) - this_12.offset_0, exit_1, is_axis_0);
    }
    return max(vec3<i32>(floor(position_0)), select(voxel_5, exit_1, is_axis_0));
}

fn Walk_enter_rounded_0( this_13 : Walk_0,  voxel_6 : ptr<function, vec3<i32>>,  near_0 : vec3<i32>,  far_0 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_6) < near_0;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_13.speed_1) <= vec3<f32>(1.00000004581370497e-18f), is_before_0)))))
        {
            return false;
        }
        var t_3 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_13, near_0), is_before_0);
        var t_last_0 : f32 = max_element_0(t_3);
        if(t_last_0 > (this_13.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_3.x) == t_last_0;
        var _S60 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S60)
        {
            is_y_0 = (t_3.y) == t_last_0;
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
        (*voxel_6) = Walk_arrive_0(this_13, (*voxel_6), t_last_0, is_axis_1, select(vec3<i32>(i32(1073741823)), near_0, is_axis_1));
    }
    return (all(((*voxel_6) < far_0)));
}

fn Walk_leave_rounded_0( this_14 : Walk_0,  voxel_7 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_4 : vec3<f32> = Walk_crossings_0(this_14, exit_2);
    var t_first_0 : f32 = min_element_0(t_4);
    if(t_first_0 >= (this_14.t_end_0))
    {
        return false;
    }
    (*voxel_7) = max(exit_2 - vec3<i32>(ceil((t_4 - vec3<f32>(t_first_0)) * this_14.speed_1)), (*voxel_7));
    return true;
}

fn Walk_leave_0( this_15 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S62 : bool = Walk_leave_rounded_0(this_15, &((*voxel_8)), exit_3);
        return _S62;
    }
    var t_5 : vec3<f32> = Walk_crossings_0(this_15, exit_3);
    var t_first_1 : f32 = min_element_0(t_5);
    if(t_first_1 > (this_15.t_end_0))
    {
        return false;
    }
    var back_0 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_5 - vec3<f32>(t_first_1), this_15.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
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
        arrival_1 = leave_box_0(this_15.origin_4, this_15.speed_1, (*voxel_8) + this_15.offset_0, exit_3 + this_15.offset_0, exit_3 - vec3<i32>(round(back_0 - _S65)) + this_15.offset_0) - this_15.offset_0;
    }
    else
    {
        arrival_1 = _S64;
    }
    (*voxel_8) = max(arrival_1, (*voxel_8));
    return true;
}

fn Walk_enter_0( this_16 : Walk_0,  voxel_9 : ptr<function, vec3<i32>>,  low_5 : vec3<i32>,  high_2 : vec3<i32>) -> bool
{
    var _S68 : bool;
    var is_mirrored_0 : vec3<bool> = (Walk_mirror_0(this_16)) != vec3<i32>(i32(0));
    var near_1 : vec3<i32> = select(low_5, (vec3<i32>(0) - high_2), is_mirrored_0);
    var far_1 : vec3<i32> = select(high_2, (vec3<i32>(0) - low_5), is_mirrored_0);
    if(!IS_EXACT_0)
    {
        var _S69 : bool = Walk_enter_rounded_0(this_16, &((*voxel_9)), near_1, far_1);
        return _S69;
    }
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
            _S68 = (any(((*voxel_9) < near_1)));
        }
        else
        {
            _S68 = false;
        }
        var _S70 : bool;
        if(_S68)
        {
            _S70 = (all(((*voxel_9) < far_1)));
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
        var _S71 : bool = Walk_leave_0(this_16, &((*voxel_9)), select(far_1, near_1, (*voxel_9) < near_1));
        if(!_S71)
        {
            return false;
        }
        axis_3 = axis_3 + u32(1);
    }
    if((all(((*voxel_9) >= near_1))))
    {
        _S68 = (all(((*voxel_9) < far_1)));
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
    return cells_1[place_of_cell_0(index_3)];
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

fn empty_around_0( record_1 : u32,  blocks_0 : u32,  voxel_10 : vec3<i32>,  octant_3 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_10.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_10.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_10.z) & (i32(4))))))) ^ (octant_3));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_0 : u32 = ((cell_in_node_0(voxel_10, u32(0))) ^ (flip_0));
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

fn Walk_leave_rounded_1( this_17 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  exit_4 : vec3<i32>) -> bool
{
    var t_6 : vec3<f32> = Walk_crossings_0(this_17, exit_4);
    var t_first_2 : f32 = min_element_0(t_6);
    if(t_first_2 >= (this_17.t_end_0))
    {
        return false;
    }
    (*voxel_11) = max(exit_4 - vec3<i32>(ceil((t_6 - vec3<f32>(t_first_2)) * this_17.speed_1)), (*voxel_11));
    return true;
}

fn Walk_leave_1( this_18 : Walk_0,  voxel_12 : ptr<function, vec3<i32>>,  exit_5 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S75 : bool = Walk_leave_rounded_1(this_18, &((*voxel_12)), exit_5);
        return _S75;
    }
    var t_7 : vec3<f32> = Walk_crossings_0(this_18, exit_5);
    var t_first_3 : f32 = min_element_0(t_7);
    if(t_first_3 > (this_18.t_end_0))
    {
        return false;
    }
    var back_1 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_7 - vec3<f32>(t_first_3), this_18.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S76 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_1 : vec3<f32> = back_1 + _S76;
    var _S77 : vec3<i32> = exit_5 - ((bitcast<vec3<i32>>((rounded_1))) - vec3<i32>(i32(1262485504)));
    var _S78 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_1 : vec3<bool> = (abs(rounded_1 - _S76 - back_1)) >= (_S78 - this_18.tolerance_0);
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
        arrival_2 = leave_box_0(this_18.origin_4, this_18.speed_1, (*voxel_12) + this_18.offset_0, exit_5 + this_18.offset_0, exit_5 - vec3<i32>(round(back_1 - _S78)) + this_18.offset_0) - this_18.offset_0;
    }
    else
    {
        arrival_2 = _S77;
    }
    (*voxel_12) = max(arrival_2, (*voxel_12));
    return true;
}

fn first_voxel_0( grid_5 : PackedGrid_0,  walk_1 : Walk_0,  found_1 : ptr<function, vec3<i32>>) -> bool
{
    var _S81 : Walk_0 = walk_1;
    var _S82 : vec3<i32> = vec3<i32>(i32(0));
    (*found_1) = _S82;
    var voxel_13 : vec3<i32> = Walk_start_voxel_0(walk_1);
    var _S83 : bool = Walk_enter_0(walk_1, &(voxel_13), cell_of_0(grid_5.min_0) - _S81.base_0, cell_of_0(grid_5.max_0) - _S81.base_0);
    if(!_S83)
    {
        return false;
    }
    var octant_4 : u32 = _S81.octant_0;
    var _S84 : u32 = flip_of_0(_S81.octant_0);
    var top_shift_1 : u32 = top_shift_of_0(grid_5);
    var top_size_1 : vec3<i32> = cell_of_0(grid_5.top_size_0);
    var low_6 : vec3<i32> = cell_of_0(grid_5.origin_3) - _S81.base_0;
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
            _S90 = (any((voxel_13 >= end_0)));
        }
        else
        {
            _S90 = false;
        }
        if(_S90)
        {
            break;
        }
        var cell_5 : u32 = cell_word_0(u32(_S87 + dot_cells_0(_S88, (voxel_13 >> (_S86)))));
        var is_found_1 : bool;
        var cell_6 : u32;
        var shift_1 : u32;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_5 & (u32(2147483648)))) != u32(0))
            {
                cell_6 = cell_word_0(((cell_5 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_13, u32(3))) ^ (_S84))));
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
                cell_6 = cell_word_0(((cell_6 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_13, shift_2)) ^ (_S84))));
                shift_1 = shift_2;
            }
        }
        if(waits_for_pages_0())
        {
            break;
        }
        var exit_6 : vec3<i32>;
        if(((cell_6 & (u32(2147483648)))) == u32(0))
        {
            if(CELLS_SKIP_0)
            {
                exit_6 = vec3<i32>((i32(skip_distance_0(cell_6, octant_4)) - i32(1)));
            }
            else
            {
                exit_6 = extents_0(cell_6, _S89);
            }
            exit_6 = ((voxel_13 | (vec3<i32>((((i32(1) << (shift_1))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_6 << (vec3<u32>(shift_1))));
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
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_13, octant_4, _S84);
            var is_found_2 : bool = low_bits_0 == u32(4294967295);
            if(is_found_2)
            {
                is_found_0 = is_found_2;
                break;
            }
            exit_6 = ((voxel_13 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_1 = is_found_2;
        }
        var _S92 : bool = Walk_leave_1(_S81, &(voxel_13), exit_6);
        if(!_S92)
        {
            is_found_0 = is_found_1;
            break;
        }
        is_found_0 = is_found_1;
    }
    (*found_1) = Walk_mirrored_0(_S81, voxel_13) + _S81.base_0;
    return is_found_0;
}

fn Ray_x24init_0( origin_8 : vec3<f32>,  t_min_2 : f32,  direction_3 : vec3<f32>,  t_max_2 : f32) -> Ray_0
{
    var _S93 : Ray_0;
    _S93.origin_0 = origin_8;
    _S93.t_min_0 = t_min_2;
    _S93.direction_0 = direction_3;
    _S93.t_max_0 = t_max_2;
    return _S93;
}

fn ray_of_walk_0( walk_2 : Walk_0,  ray_4 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (Walk_mirror_0(walk_2)) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_2.origin_4, (vec3<f32>(0) - walk_2.origin_4), is_mirrored_1) + vec3<f32>(walk_2.base_0), ray_4.t_min_0, select(walk_2.speed_1, (vec3<f32>(0) - walk_2.speed_1), is_mirrored_1), ray_4.t_max_0);
}

fn hit_at_0( last_0 : Crossing_0,  t_min_3 : f32,  inverse_2 : vec3<f32>,  voxel_14 : vec3<i32>,  instance_2 : u32,  octant_5 : u32) -> Hit_0
{
    var t_8 : f32 = last_0.distance_0 * inverse_2[last_0.axis_0];
    var _S94 : f32;
    if(t_8 > t_min_3)
    {
        _S94 = t_8;
    }
    else
    {
        _S94 = t_min_3;
    }
    return Hit_x24init_0(_S94, instance_2, voxel_14, u32(2) * last_0.axis_0 + ((((octant_5 >> ((last_0.axis_0)))) & (u32(1)))));
}

fn hit_of_walk_0( walk_3 : Walk_0,  voxel_15 : vec3<i32>,  instance_3 : u32) -> Hit_0
{
    var planes_3 : vec3<i32> = Walk_mirrored_0(walk_3, voxel_15 - walk_3.base_0);
    if(IS_EXACT_0)
    {
        return hit_at_0(crossing_among_0(walk_3.origin_4, walk_3.speed_1, planes_3 + walk_3.offset_0, false), walk_3.ray_1.t_min_1, walk_3.inverse_1, voxel_15, instance_3, walk_3.octant_0);
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
    return Hit_x24init_0(max(last_1, walk_3.ray_1.t_min_1), instance_3, voxel_15, u32(2) * axis_4 + (((((walk_3.octant_0) >> (axis_4))) & (u32(1)))));
}

fn hit_in_0( instance_4 : u32,  ray_5 : ptr<function, Ray_0>) -> Hit_0
{
    var local_1 : LocalRay_0 = local_ray_0((*ray_5), Instances_operatorx5Bx5D_get_0(instance_4).grid_from_world_0);
    if(!local_1.is_valid_0)
    {
        return miss_0();
    }
    var _S96 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(instance_4).grid_0);
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
        base_2 = cell_of_0(_S96.origin_3);
    }
    var walk_4 : Walk_0 = walk_from_0(base_2, local_1, _S96);
    var voxel_16 : vec3<i32>;
    var is_found_3 : bool = first_voxel_0(_S96, walk_4, &(voxel_16));
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
    var hit_0 : Hit_0 = hit_of_walk_0(walk_4, voxel_16, instance_4);
    if((hit_0.t_0) > ((*ray_5).t_max_0))
    {
        return miss_0();
    }
    return hit_0;
}

fn Walk_enter_rounded_1( this_19 : Walk_0,  voxel_17 : ptr<function, vec3<i32>>,  near_2 : vec3<i32>,  far_2 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_1 : vec3<bool> = (*voxel_17) < near_2;
        if(!(any((is_before_1))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_19.speed_1) <= vec3<f32>(1.00000004581370497e-18f), is_before_1)))))
        {
            return false;
        }
        var t_10 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_19, near_2), is_before_1);
        var t_last_1 : f32 = max_element_0(t_10);
        if(t_last_1 > (this_19.t_end_0))
        {
            return false;
        }
        var is_x_1 : bool = (t_10.x) == t_last_1;
        var _S98 : bool = !is_x_1;
        var is_y_1 : bool;
        if(_S98)
        {
            is_y_1 = (t_10.y) == t_last_1;
        }
        else
        {
            is_y_1 = false;
        }
        var _S99 : bool;
        if(_S98)
        {
            _S99 = !is_y_1;
        }
        else
        {
            _S99 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_1, is_y_1, _S99);
        (*voxel_17) = Walk_arrive_0(this_19, (*voxel_17), t_last_1, is_axis_2, select(vec3<i32>(i32(1073741823)), near_2, is_axis_2));
    }
    return (all(((*voxel_17) < far_2)));
}

fn Walk_leave_2( this_20 : Walk_0,  voxel_18 : ptr<function, vec3<i32>>,  exit_7 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S100 : bool = Walk_leave_rounded_0(this_20, &((*voxel_18)), exit_7);
        return _S100;
    }
    var t_11 : vec3<f32> = Walk_crossings_0(this_20, exit_7);
    var t_first_4 : f32 = min_element_0(t_11);
    if(t_first_4 > (this_20.t_end_0))
    {
        return false;
    }
    var back_2 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_11 - vec3<f32>(t_first_4), this_20.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S101 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_2 : vec3<f32> = back_2 + _S101;
    var _S102 : vec3<i32> = exit_7 - ((bitcast<vec3<i32>>((rounded_2))) - vec3<i32>(i32(1262485504)));
    var _S103 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_2 : vec3<bool> = (abs(rounded_2 - _S101 - back_2)) >= (_S103 - this_20.tolerance_0);
    var _S104 : bool = is_unsure_2.x;
    var _S105 : bool;
    if(_S104)
    {
        _S105 = is_unsure_2.y;
    }
    else
    {
        _S105 = false;
    }
    if(_S105)
    {
        _S105 = true;
    }
    else
    {
        if(_S104)
        {
            _S105 = true;
        }
        else
        {
            _S105 = is_unsure_2.y;
        }
        if(_S105)
        {
            _S105 = is_unsure_2.z;
        }
        else
        {
            _S105 = false;
        }
    }
    var arrival_3 : vec3<i32>;
    if(_S105)
    {
        arrival_3 = leave_box_0(this_20.origin_4, this_20.speed_1, (*voxel_18) + this_20.offset_0, exit_7 + this_20.offset_0, exit_7 - vec3<i32>(round(back_2 - _S103)) + this_20.offset_0) - this_20.offset_0;
    }
    else
    {
        arrival_3 = _S102;
    }
    (*voxel_18) = max(arrival_3, (*voxel_18));
    return true;
}

fn Walk_enter_1( this_21 : Walk_0,  voxel_19 : ptr<function, vec3<i32>>,  low_7 : vec3<i32>,  high_3 : vec3<i32>) -> bool
{
    var _S106 : bool;
    var is_mirrored_2 : vec3<bool> = (Walk_mirror_0(this_21)) != vec3<i32>(i32(0));
    var near_3 : vec3<i32> = select(low_7, (vec3<i32>(0) - high_3), is_mirrored_2);
    var far_3 : vec3<i32> = select(high_3, (vec3<i32>(0) - low_7), is_mirrored_2);
    if(!IS_EXACT_0)
    {
        var _S107 : bool = Walk_enter_rounded_1(this_21, &((*voxel_19)), near_3, far_3);
        return _S107;
    }
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < u32(3))
        {
            _S106 = (any(((*voxel_19) < near_3)));
        }
        else
        {
            _S106 = false;
        }
        var _S108 : bool;
        if(_S106)
        {
            _S108 = (all(((*voxel_19) < far_3)));
        }
        else
        {
            _S108 = false;
        }
        if(_S108)
        {
        }
        else
        {
            break;
        }
        var _S109 : bool = Walk_leave_2(this_21, &((*voxel_19)), select(far_3, near_3, (*voxel_19) < near_3));
        if(!_S109)
        {
            return false;
        }
        axis_5 = axis_5 + u32(1);
    }
    if((all(((*voxel_19) >= near_3))))
    {
        _S106 = (all(((*voxel_19) < far_3)));
    }
    else
    {
        _S106 = false;
    }
    return _S106;
}

fn first_voxel_1( grid_6 : PackedGrid_0,  walk_5 : Walk_0,  found_2 : ptr<function, vec3<i32>>) -> bool
{
    var _S110 : Walk_0 = walk_5;
    var _S111 : vec3<i32> = vec3<i32>(i32(0));
    (*found_2) = _S111;
    var voxel_20 : vec3<i32> = Walk_start_voxel_0(walk_5);
    var _S112 : bool = Walk_enter_1(walk_5, &(voxel_20), cell_of_0(grid_6.min_0) - _S110.base_0, cell_of_0(grid_6.max_0) - _S110.base_0);
    if(!_S112)
    {
        return false;
    }
    var octant_6 : u32 = _S110.octant_0;
    var _S113 : u32 = flip_of_0(_S110.octant_0);
    var top_shift_2 : u32 = top_shift_of_0(grid_6);
    var top_size_2 : vec3<i32> = cell_of_0(grid_6.top_size_0);
    var low_8 : vec3<i32> = cell_of_0(grid_6.origin_3) - _S110.base_0;
    var _S114 : i32 = top_size_2.x;
    var stride_1 : vec3<i32> = vec3<i32>(i32(1), _S114, _S114 * top_size_2.y);
    var _S115 : vec3<u32> = vec3<u32>(top_shift_2);
    var _S116 : i32 = i32(grid_6.top_offset_0) - dot_cells_0((stride_1 & ((Walk_mirror_0(_S110)))), vec3<i32>(i32(1))) - dot_cells_0(stride_1, (low_8 >> (_S115)));
    var _S117 : vec3<i32> = Walk_mirrored_plane_0(_S110, stride_1);
    var _S118 : u32 = ahead_of_0(Walk_mirror_0(_S110));
    var end_1 : vec3<i32> = Walk_mirrored_plane_0(_S110, select(low_8 + ((top_size_2 << (_S115))), low_8, (Walk_mirror_0(_S110)) != _S111));
    if(!IS_EXACT_0)
    {
        _S110.t_end_0 = min(_S110.t_end_0, min_element_0(Walk_crossings_0(_S110, end_1)));
    }
    var is_found_4 : bool = false;
    for(;;)
    {
        var _S119 : bool;
        if(IS_EXACT_0)
        {
            _S119 = (any((voxel_20 >= end_1)));
        }
        else
        {
            _S119 = false;
        }
        if(_S119)
        {
            break;
        }
        var cell_7 : u32 = cell_word_0(u32(_S116 + dot_cells_0(_S117, (voxel_20 >> (_S115)))));
        var is_found_5 : bool;
        var cell_8 : u32;
        var shift_3 : u32;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_7 & (u32(2147483648)))) != u32(0))
            {
                cell_8 = cell_word_0(((cell_7 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_20, u32(3))) ^ (_S113))));
                shift_3 = u32(3);
            }
            else
            {
                cell_8 = cell_7;
                shift_3 = top_shift_2;
            }
        }
        else
        {
            cell_8 = cell_7;
            shift_3 = top_shift_2;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_5 = shift_3 > u32(3);
                }
                else
                {
                    is_found_5 = false;
                }
                var _S120 : bool;
                if(is_found_5)
                {
                    _S120 = ((cell_8 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S120 = false;
                }
                if(_S120)
                {
                }
                else
                {
                    break;
                }
                var shift_4 : u32 = shift_3 - u32(2);
                cell_8 = cell_word_0(((cell_8 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_20, shift_4)) ^ (_S113))));
                shift_3 = shift_4;
            }
        }
        if(waits_for_pages_0())
        {
            break;
        }
        var exit_8 : vec3<i32>;
        if(((cell_8 & (u32(2147483648)))) == u32(0))
        {
            if(CELLS_SKIP_0)
            {
                exit_8 = vec3<i32>((i32(skip_distance_0(cell_8, octant_6)) - i32(1)));
            }
            else
            {
                exit_8 = extents_0(cell_8, _S118);
            }
            exit_8 = ((voxel_20 | (vec3<i32>((((i32(1) << (shift_3))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_8 << (vec3<u32>(shift_3))));
            is_found_5 = is_found_4;
        }
        else
        {
            var record_3 : u32 = record_of_cell_0(cell_8);
            var blocks_2 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_2 = blocks_of_cell_0(cell_8);
            }
            else
            {
                blocks_2 = blocks_of_record_0(record_3);
            }
            var low_bits_1 : u32 = empty_around_0(record_3, blocks_2, voxel_20, octant_6, _S113);
            var is_found_6 : bool = low_bits_1 == u32(4294967295);
            if(is_found_6)
            {
                is_found_4 = is_found_6;
                break;
            }
            exit_8 = ((voxel_20 | (vec3<i32>(i32(low_bits_1))))) + vec3<i32>(i32(1));
            is_found_5 = is_found_6;
        }
        var _S121 : bool = Walk_leave_0(_S110, &(voxel_20), exit_8);
        if(!_S121)
        {
            is_found_4 = is_found_5;
            break;
        }
        is_found_4 = is_found_5;
    }
    (*found_2) = Walk_mirrored_0(_S110, voxel_20) + _S110.base_0;
    return is_found_4;
}

fn hit_in_1( instance_5 : u32,  ray_6 : ptr<function, Ray_0>) -> Hit_0
{
    var local_2 : LocalRay_0 = local_ray_0((*ray_6), Instances_operatorx5Bx5D_get_0(instance_5).grid_from_world_0);
    if(!local_2.is_valid_0)
    {
        return miss_0();
    }
    var _S122 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(instance_5).grid_0);
    var _S123 : bool;
    if(IS_EXACT_0)
    {
        _S123 = TOP_SHIFT_0 == u32(3);
    }
    else
    {
        _S123 = false;
    }
    var base_3 : vec3<i32>;
    if(_S123)
    {
        base_3 = vec3<i32>(i32(0));
    }
    else
    {
        base_3 = cell_of_0(_S122.origin_3);
    }
    var walk_6 : Walk_0 = walk_from_0(base_3, local_2, _S122);
    var voxel_21 : vec3<i32>;
    var is_found_7 : bool = first_voxel_1(_S122, walk_6, &(voxel_21));
    if(IS_SINGLE_0)
    {
        _S123 = !IS_EXACT_0;
    }
    else
    {
        _S123 = false;
    }
    if(_S123)
    {
        (*ray_6) = ray_of_walk_0(walk_6, (*ray_6));
    }
    if(!is_found_7)
    {
        return miss_0();
    }
    var hit_1 : Hit_0 = hit_of_walk_0(walk_6, voxel_21, instance_5);
    if((hit_1.t_0) > ((*ray_6).t_max_0))
    {
        return miss_0();
    }
    return hit_1;
}

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
     instance_6 : u32,
     voxel_22 : vec3<i32>,
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

struct Walker_0
{
     path_0 : Path_0,
     ray_7 : Ray_0,
     is_shadow_ray_0 : bool,
     light_0 : vec3<f32>,
     direction_4 : vec3<f32>,
     path_origin_0 : vec3<f32>,
     shadow_inside_0 : Inside_0,
     boundaries_0 : u32,
     relocates_0 : bool,
     path_relocates_0 : bool,
     camera_ray_0 : Ray_0,
     way_3 : f32,
     has_shown_0 : bool,
     asks_cache_0 : bool,
     life_0 : u32,
     is_at_cell_0 : bool,
     counts_0 : bool,
     sees_mover_0 : bool,
     by_chance_0 : bool,
};

struct Sample_0
{
     direct_0 : vec3<f32>,
     light_1 : vec3<f32>,
     is_shown_0 : bool,
     albedo_0 : vec3<f32>,
     normal_1 : vec3<f32>,
     place_0 : vec3<f32>,
     instance_7 : u32,
};

struct NextRays_0
{
     origin_9 : vec3<f32>,
     path_origin_1 : vec3<f32>,
     shadow_inside_1 : Inside_0,
     relocates_1 : bool,
     path_relocates_1 : bool,
     direction_5 : vec3<f32>,
     has_shadow_ray_0 : bool,
     shadow_direction_0 : vec3<f32>,
     shadow_t_max_0 : f32,
     light_2 : vec3<f32>,
     is_same_0 : bool,
};

fn Inside_x24init_0( instance_8 : u32,  voxel_23 : vec3<i32>,  material_1 : u32) -> Inside_0
{
    var _S124 : Inside_0;
    _S124.instance_6 = instance_8;
    _S124.voxel_22 = voxel_23;
    _S124.material_0 = material_1;
    return _S124;
}

fn in_air_0() -> Inside_0
{
    return Inside_x24init_0(u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn NextRays_x24init_0( origin_10 : vec3<f32>,  path_origin_2 : vec3<f32>,  shadow_inside_2 : Inside_0,  relocates_2 : bool,  path_relocates_2 : bool,  direction_6 : vec3<f32>,  has_shadow_ray_1 : bool,  shadow_direction_1 : vec3<f32>,  shadow_t_max_1 : f32,  light_3 : vec3<f32>,  is_same_1 : bool) -> NextRays_0
{
    var _S125 : NextRays_0;
    _S125.origin_9 = origin_10;
    _S125.path_origin_1 = path_origin_2;
    _S125.shadow_inside_1 = shadow_inside_2;
    _S125.relocates_1 = relocates_2;
    _S125.path_relocates_1 = path_relocates_2;
    _S125.direction_5 = direction_6;
    _S125.has_shadow_ray_0 = has_shadow_ray_1;
    _S125.shadow_direction_0 = shadow_direction_1;
    _S125.shadow_t_max_0 = shadow_t_max_1;
    _S125.light_2 = light_3;
    _S125.is_same_0 = is_same_1;
    return _S125;
}

fn no_rays_0() -> NextRays_0
{
    var _S126 : vec3<f32> = vec3<f32>(0.0f);
    return NextRays_x24init_0(_S126, _S126, in_air_0(), false, false, _S126, false, _S126, 0.0f, _S126, false);
}

fn Hit_is_miss_0( this_22 : Hit_0) -> bool
{
    return (this_22.instance_0) == u32(4294967295);
}

fn Inside_is_in_0( this_23 : Inside_0) -> bool
{
    return false;
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

fn find_brick_0( grid_7 : PackedGrid_0,  relative_1 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (relative_1 >> (vec3<u32>(grid_7.top_shift_0)));
    var _S127 : bool;
    if((any((top_0 < vec3<i32>(i32(0))))))
    {
        _S127 = true;
    }
    else
    {
        _S127 = (any((top_0 >= (cell_of_0(grid_7.top_size_0)))));
    }
    if(_S127)
    {
        return u32(4294967295);
    }
    var cell_9 : u32 = cell_word_0(grid_7.top_offset_0 + u32((top_0.z * grid_7.top_size_0[i32(1)] + top_0.y) * grid_7.top_size_0[i32(0)] + top_0.x));
    var shift_5 : u32 = grid_7.top_shift_0;
    for(;;)
    {
        if(shift_5 > u32(3))
        {
            _S127 = ((cell_9 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S127 = false;
        }
        if(_S127)
        {
        }
        else
        {
            break;
        }
        var shift_6 : u32 = shift_5 - u32(2);
        cell_9 = cell_word_0(((cell_9 & (u32(2147483647)))) * u32(64) + cell_in_node_0(relative_1, shift_6));
        shift_5 = shift_6;
    }
    if(((cell_9 & (u32(2147483648)))) == u32(0))
    {
        cell_9 = u32(4294967295);
    }
    else
    {
        cell_9 = record_of_cell_0(cell_9);
    }
    return cell_9;
}

fn rank_in_brick_0( record_4 : u32,  relative_2 : vec3<i32>) -> u32
{
    var bit_1 : u32 = cell_in_node_0(relative_2, u32(0));
    var present_before_0 : u32 = countOneBits(((brick_word_0(record_4)) & ((((u32(1) << (((((u32(((((relative_2.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_2.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_2.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_6 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_6 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S128 : u32 = u32(2) * index_6;
        var rank_1 : u32 = rank_0 + (countOneBits(brick_word_0(record_4 + u32(2) + _S128)) + countOneBits(brick_word_0(record_4 + u32(3) + _S128)));
        index_6 = index_6 + u32(1);
        rank_0 = rank_1;
    }
    var _S129 : u32 = u32(2) * present_before_0;
    var low_9 : u32 = brick_word_0(record_4 + u32(2) + _S129);
    if(bit_1 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_9 & ((((u32(1) << (bit_1))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_9) + countOneBits(((brick_word_0(record_4 + u32(3) + _S129)) & ((((u32(1) << ((bit_1 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_7 : u32) -> u32
{
    return index_7;
}

fn material_word_0( index_8 : u32) -> u32
{
    return brick_materials_0[place_of_material_0(index_8)];
}

fn read_bits_0( start_1 : u32,  position_2 : u32,  count_0 : u32) -> u32
{
    if(count_0 == u32(0))
    {
        return u32(0);
    }
    var word_0 : u32 = start_1 + ((position_2 >> (u32(5))));
    var shift_7 : u32 = (position_2 & (u32(31)));
    var bits_1 : u32 = ((material_word_0(word_0)) >> (shift_7));
    var bits_2 : u32;
    if((shift_7 + count_0) > u32(32))
    {
        bits_2 = (bits_1 | ((((material_word_0(word_0 + u32(1))) << ((u32(32) - shift_7))))));
    }
    else
    {
        bits_2 = bits_1;
    }
    return (bits_2 & ((((u32(1) << (count_0))) - u32(1))));
}

fn material_of_rank_0( grid_8 : PackedGrid_0,  record_5 : u32,  rank_2 : u32) -> u32
{
    var header_0 : u32 = brick_word_0(record_5);
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var start_2 : u32 = brick_word_0(record_5 + u32(1));
    var index_9 : u32 = read_bits_0(start_2, palette_count_0 * grid_8.material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_9;
    }
    return read_bits_0(start_2, index_9 * grid_8.material_bits_0, grid_8.material_bits_0);
}

fn material_at_0( grid_9 : PackedGrid_0,  relative_3 : vec3<i32>) -> u32
{
    var record_6 : u32 = find_brick_0(grid_9, relative_3);
    return material_of_rank_0(grid_9, record_6, rank_in_brick_0(record_6, relative_3));
}

fn Rows_operatorx5Bx5D_get_2( row_4 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(3)) + row_4];
}

fn material_of_index_0( index_10 : u32) -> PackedMaterial_0
{
    var _S130 : u32 = u32(4) * index_10;
    var _S131 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S130);
    var _S132 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S130 + u32(1));
    var _S133 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S130 + u32(2));
    var _S134 : vec4<u32> = Rows_operatorx5Bx5D_get_2(_S130 + u32(3));
    var material_2 : PackedMaterial_0;
    var _S135 : f32 = (bitcast<f32>((_S131.y)));
    var _S136 : f32 = (bitcast<f32>((_S131.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((_S131.x)));
    material_2.base_color_0[i32(1)] = _S135;
    material_2.base_color_0[i32(2)] = _S136;
    var _S137 : f32 = (bitcast<f32>((_S132.y)));
    var _S138 : f32 = (bitcast<f32>((_S132.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((_S132.x)));
    material_2.emission_0[i32(1)] = _S137;
    material_2.emission_0[i32(2)] = _S138;
    var _S139 : f32 = (bitcast<f32>((_S134.y)));
    var _S140 : f32 = (bitcast<f32>((_S134.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((_S134.x)));
    material_2.absorption_0[i32(1)] = _S139;
    material_2.absorption_0[i32(2)] = _S140;
    material_2.roughness_0 = (bitcast<f32>((_S131.w)));
    material_2.metallic_0 = (bitcast<f32>((_S132.w)));
    material_2.transmission_0 = (bitcast<f32>((_S133.x)));
    material_2.ior_0 = (bitcast<f32>((_S133.y)));
    material_2.specular_0 = (bitcast<f32>((_S133.z)));
    material_2.anisotropy_0 = (bitcast<f32>((_S133.w)));
    material_2.scattering_0 = (bitcast<f32>((_S134.w)));
    return material_2;
}

fn material_of_0( hit_2 : Hit_0) -> PackedMaterial_0
{
    var _S141 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(hit_2.instance_0).grid_0);
    return material_of_index_0(material_at_0(_S141, hit_2.voxel_0 - cell_of_0(_S141.origin_3)));
}

fn material_met_0( path_1 : Path_0,  hit_3 : Hit_0,  beyond_0 : u32) -> PackedMaterial_0
{
    return material_of_0(hit_3);
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
    var rest_2 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_2) / f32(u32(2) * guess_1) + 0.5f));
    var _S142 : i32 = i32(guess_1);
    var root_0 : i32 = _S142 + units_1;
    var rest_3 : i32 = rest_2 - units_1 * (_S142 + root_0);
    return u32(root_0 + i32(rest_3 > root_0) - i32(rest_3 <= (- root_0)));
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

fn Path_events_0( this_24 : Path_0) -> u32
{
    return this_24.bounce_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S144 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_2 : vec4<u32> = _S144;
    v_2[i32(0)] = v_2[i32(0)] + _S144.y * _S144.w;
    v_2[i32(1)] = v_2[i32(1)] + v_2.z * v_2.x;
    v_2[i32(2)] = v_2[i32(2)] + v_2.x * v_2.y;
    v_2[i32(3)] = v_2[i32(3)] + v_2.y * v_2.z;
    var _S145 : vec4<u32> = (v_2 ^ (((v_2 >> (vec4<u32>(u32(16)))))));
    v_2 = _S145;
    v_2[i32(0)] = v_2[i32(0)] + _S145.y * _S145.w;
    v_2[i32(1)] = v_2[i32(1)] + v_2.z * v_2.x;
    v_2[i32(2)] = v_2[i32(2)] + v_2.x * v_2.y;
    v_2[i32(3)] = v_2[i32(3)] + v_2.y * v_2.z;
    return v_2;
}

fn unit_float_0( words_1 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_1 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_independent_0( this_25 : Sampler_0,  dimension_0 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_25.pixel_0, this_25.sample_0, dimension_0, this_25.seed_1)));
}

struct Key_0
{
     instance_9 : u32,
     face_and_level_0 : u32,
     cube_0 : vec3<i32>,
};

fn inverse_power_of_two_0( x_0 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_0))) >> (u32(23))))) << (u32(23))))));
}

fn Key_x24init_0( instance_10 : u32,  face_and_level_1 : u32,  cube_1 : vec3<i32>) -> Key_0
{
    var _S146 : Key_0;
    _S146.instance_9 = instance_10;
    _S146.face_and_level_0 = face_and_level_1;
    _S146.cube_0 = cube_1;
    return _S146;
}

fn scramble_of_0( number_1 : u32) -> u32
{
    return pcg4d_0(vec4<u32>(number_1, u32(0), u32(0), u32(2654435769))).x;
}

fn Key_level_0( this_26 : Key_0) -> u32
{
    return ((this_26.face_and_level_0) >> (u32(3)));
}

fn Key_mask_0( this_27 : Key_0) -> u32
{
    return ((u32(1) << ((u32(3) * Key_level_0(this_27))))) - u32(1);
}

fn key_of_0( hit_4 : Hit_0,  size_0 : f32,  u_0 : f32,  code_1 : ptr<function, u32>) -> Key_0
{
    var clamped_0 : f32 = clamp(size_0, 1.0f, 128.0f);
    var power_0 : f32 = f32(((bitcast<u32>((clamped_0))) >> (u32(23)))) - 127.0f;
    var _S147 : f32;
    if(u_0 < (clamped_0 * inverse_power_of_two_0(clamped_0) - 1.0f))
    {
        _S147 = 1.0f;
    }
    else
    {
        _S147 = 0.0f;
    }
    var level_0 : u32 = u32(min(power_0 + _S147, 6.0f));
    var _S148 : vec3<u32> = vec3<u32>(u32(i32(level_0)));
    var key_0 : Key_0 = Key_x24init_0(hit_4.instance_0, ((hit_4.face_0) | (((level_0 << (u32(3)))))), ((hit_4.voxel_0) >> (_S148)));
    var _S149 : vec3<u32> = vec3<u32>(hit_4.voxel_0 - (((key_0.cube_0) << (_S148))));
    (*code_1) = u32(1) + (((((((_S149.x) | ((((_S149.y) << (level_0)))))) | ((((_S149.z) << ((u32(2) * level_0))))))) ^ ((((scramble_of_0(real_time_0.number_0)) & ((Key_mask_0(key_0))))))));
    return key_0;
}

fn Key_hash_0( this_28 : Key_0) -> vec2<u32>
{
    return pcg4d_0(vec4<u32>(vec3<u32>(this_28.cube_0), this_28.instance_9 * u32(61) + this_28.face_and_level_0)).xy;
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
        var _S150 : u32 = atomicLoad(&(cell_keys_0[place_of_check_0(cell_11)]));
        if(_S150 == (max(hash_0.y, u32(1))))
        {
            return cell_11;
        }
        probe_0 = probe_0 + u32(1);
    }
    return u32(262144);
}

fn cell_row_0( row_5 : u32,  cell_12 : u32) -> vec4<u32>
{
    return cell_rows_0[row_5 * u32(262144) + cell_12];
}

fn set_cell_row_0( row_6 : u32,  cell_13 : u32,  value_2 : vec4<u32>)
{
    cell_rows_0[row_6 * u32(262144) + cell_13] = value_2;
    return;
}

fn place_of_asked_0( cell_14 : u32) -> u32
{
    return u32(262160) + cell_14;
}

fn ask_cell_0( key_1 : Key_0,  asked_0 : u32) -> vec4<f32>
{
    var _S151 : bool;
    var hash_1 : vec2<u32> = Key_hash_0(key_1);
    var _S152 : u32 = max(hash_1.y, u32(1));
    var cell_15 : u32 = find_cell_0(hash_1);
    var _S153 : vec4<f32> = vec4<f32>(0.0f);
    var known_0 : vec4<f32>;
    if(cell_15 != u32(262144))
    {
        known_0 = (bitcast<vec4<f32>>((cell_row_0(u32(0), cell_15))));
    }
    else
    {
        known_0 = _S153;
    }
    var cell_16 : u32 = cell_15;
    var probe_1 : u32 = u32(0);
    for(;;)
    {
        if(probe_1 < u32(8))
        {
            _S151 = cell_16 == u32(262144);
        }
        else
        {
            _S151 = false;
        }
        if(_S151)
        {
        }
        else
        {
            break;
        }
        var place_1 : u32 = ((hash_1.x + probe_1) & (u32(262143)));
        var found_3 : u32 = atomicCompareExchangeWeak(&(cell_keys_0[place_of_check_0(place_1)]), u32(0), _S152).old_value;
        var _S154 : bool = found_3 == u32(0);
        if(_S154)
        {
            set_cell_row_0(u32(1), place_1, vec4<u32>(key_1.instance_9, key_1.face_and_level_0, u32(0), u32(0)));
            set_cell_row_0(u32(2), place_1, vec4<u32>(vec3<u32>(key_1.cube_0), u32(0)));
        }
        var _S155 : bool;
        if(_S154)
        {
            _S155 = true;
        }
        else
        {
            _S155 = found_3 == _S152;
        }
        if(_S155)
        {
            cell_16 = place_1;
        }
        probe_1 = probe_1 + u32(1);
    }
    if(cell_16 != u32(262144))
    {
        var _S156 : u32 = atomicLoad(&(cell_keys_0[place_of_asked_0(cell_16)]));
        _S151 = _S156 < asked_0;
    }
    else
    {
        _S151 = false;
    }
    if(_S151)
    {
        var _S157 : u32 = atomicMax(&(cell_keys_0[place_of_asked_0(cell_16)]), asked_0);
    }
    return known_0;
}

fn asks_0( path_2 : Path_0,  ray_8 : Ray_0,  hit_5 : Hit_0,  beyond_1 : u32,  life_1 : u32,  light_4 : ptr<function, vec3<f32>>) -> bool
{
    (*light_4) = vec3<f32>(0.0f);
    var _S158 : bool;
    if(Hit_is_miss_0(hit_5))
    {
        _S158 = true;
    }
    else
    {
        _S158 = Inside_is_in_0(path_2.inside_0);
    }
    if(_S158)
    {
        return false;
    }
    var material_3 : PackedMaterial_0 = material_met_0(path_2, hit_5, beyond_1);
    if((material_3.metallic_0) > 0.0f)
    {
        _S158 = true;
    }
    else
    {
        _S158 = (material_3.transmission_0) > 0.0f;
    }
    if(_S158)
    {
        return false;
    }
    var code_2 : u32;
    var key_2 : Key_0 = key_of_0(hit_5, square_root_0(length_squared_0(ray_8.origin_0 + ray_8.direction_0 * vec3<f32>(hit_5.t_0) - real_time_0.eye_0)) * real_time_0.view_angle_0 * 0.05882352963089943f, Sampler_independent_0(path_2.sampler_0, u32(3221225472) + Path_events_0(path_2)).x, &(code_2));
    var _S159 : f32 = f32((u32(1) << ((Key_level_0(key_2)))));
    var is_from_first_0 : bool = (path_2.bounce_0) < u32(2);
    if(life_1 == u32(0))
    {
        _S158 = true;
    }
    else
    {
        if(is_from_first_0)
        {
            _S158 = (hit_5.t_0 * square_root_0(length_squared_0(ray_8.direction_0))) < _S159;
        }
        else
        {
            _S158 = false;
        }
    }
    if(_S158)
    {
        return false;
    }
    var known_1 : vec4<f32> = ask_cell_0(key_2, ((((min(life_1, u32(10))) << (u32(20)))) | (code_2)));
    if((known_1.w) <= 0.0f)
    {
        return false;
    }
    (*light_4) = path_2.beta_0 * vector_of_0(material_3.base_color_0) * known_1.xyz;
    return true;
}

var<private> ends_here_0 : bool;

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_2 : vec3<f32>,
};

struct Surface_0
{
     origin_11 : vec3<f32>,
     normal_3 : vec3<f32>,
     face_2 : u32,
     instance_11 : u32,
};

struct Microfacets_0
{
     alpha_0 : f32,
};

struct MaterialBsdf_0
{
     kind_0 : u32,
     color_0 : vec3<f32>,
     specular_1 : f32,
     eta_0 : f32,
     facets_0 : Microfacets_0,
};

struct Scatter_0
{
     path_3 : Path_0,
     receiver_0 : Receiver_0,
     surface_0 : Surface_0,
     bsdf_0 : MaterialBsdf_0,
     wo_0 : vec3<f32>,
     compensation_0 : f32,
     is_scattered_0 : bool,
     wants_light_0 : bool,
};

var<private> scatter_of_path_0 : Scatter_0;

fn weighs_apart_0() -> bool
{
    return false;
}

fn Path_is_counted_0( this_29 : Path_0) -> bool
{
    var _S160 : bool;
    if(weighs_apart_0())
    {
        _S160 = (this_29.pdf_1) < 0.0f;
    }
    else
    {
        _S160 = false;
    }
    return _S160;
}

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_4 : vec3<f32>) -> Receiver_0
{
    var _S161 : Receiver_0;
    _S161.point_0 = point_1;
    _S161.normal_2 = normal_4;
    return _S161;
}

fn Path_receiver_0( this_30 : Path_0,  ray_9 : Ray_0) -> Receiver_0
{
    return Receiver_x24init_0(ray_9.origin_0, this_30.normal_0);
}

fn Path_dimension_medium_0( this_31 : Path_0) -> u32
{
    return u32(2147483648) + this_31.event_0;
}

fn logarithm_0( x_1 : f32) -> f32
{
    var bits_3 : u32 = (bitcast<u32>((x_1)));
    var _S162 : u32 = (bits_3 & (u32(8388607)));
    var is_upper_0 : bool = _S162 > u32(3474675);
    var power_1 : i32 = i32((bits_3 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S163 : u32;
    if(is_upper_0)
    {
        _S163 = u32(1056964608);
    }
    else
    {
        _S163 = u32(1065353216);
    }
    var mantissa_2 : f32 = (bitcast<f32>(((_S162 | (_S163)))));
    var s_0 : f32 = divide_0(mantissa_2 - 1.0f, mantissa_2 + 1.0f);
    var ss_0 : f32 = s_0 * s_0;
    var _S164 : f32 = f32(power_1);
    return _S164 * 0.693359375f + (_S164 * -0.00021219444170129f + s_0 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_0 : PackedMaterial_0,  u_1 : f32) -> f32
{
    var _S165 : f32;
    if((medium_0.scattering_0) > 0.0f)
    {
        _S165 = divide_0(- logarithm_0(1.0f - u_1), medium_0.scattering_0);
    }
    else
    {
        _S165 = (bitcast<f32>(infinity_bits_0));
    }
    return _S165;
}

fn grid_direction_0( instance_12 : u32,  direction_7 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(Instances_operatorx5Bx5D_get_0(instance_12).grid_from_world_0, direction_7);
}

fn Inside_voxels_per_t_0( this_32 : Inside_0,  ray_10 : Ray_0) -> f32
{
    return square_root_0(length_squared_0(grid_direction_0(this_32.instance_6, ray_10.direction_0)));
}

fn scattering_t_0( path_4 : Path_0,  inside_1 : Inside_0,  ray_11 : Ray_0) -> f32
{
    return divide_0(free_path_0(material_of_index_0(inside_1.material_0), Sampler_independent_0(path_4.sampler_0, Path_dimension_medium_0(path_4)).x), Inside_voxels_per_t_0(inside_1, ray_11));
}

fn exponential_0( x_2 : f32) -> f32
{
    if(x_2 < -87.0f)
    {
        return 0.0f;
    }
    var power_2 : i32 = i32(x_2 * 1.4426950216293335f - 0.5f);
    var k_0 : f32 = f32(power_2);
    var r_0 : f32 = x_2 - k_0 * 0.693359375f - k_0 * -0.00021219444170129f;
    return (1.0f + r_0 * (1.0f + r_0 * (0.5f + r_0 * (0.1666666716337204f + r_0 * (0.0416666679084301f + r_0 * (0.00833333376795053f + r_0 * (0.00138888892251998f + r_0 * 0.0001984127011383f))))))) * (bitcast<f32>(((u32(i32(127) + power_2) << (u32(23))))));
}

fn attenuation_0( medium_1 : PackedMaterial_0,  voxels_1 : f32) -> vec3<f32>
{
    var sigma_0 : vec3<f32> = vector_of_0(medium_1.absorption_0);
    return vec3<f32>(exponential_0(- (sigma_0.x * voxels_1)), exponential_0(- (sigma_0.y * voxels_1)), exponential_0(- (sigma_0.z * voxels_1)));
}

fn absorb_0( path_5 : ptr<function, Path_0>,  inside_2 : Inside_0,  ray_12 : Ray_0,  t_12 : f32)
{
    (*path_5).beta_0 = (*path_5).beta_0 * attenuation_0(material_of_index_0(inside_2.material_0), t_12 * Inside_voxels_per_t_0(inside_2, ray_12));
    return;
}

fn Environment_to_map_0( d_0 : vec3<f32>) -> vec3<f32>
{
    var sin_0 : f32 = params_0.sky_turned_0.x;
    var cos_0 : f32 = params_0.sky_turned_0.y;
    var _S166 : f32 = d_0.x;
    var _S167 : f32 = d_0.y;
    return vec3<f32>(_S166 * cos_0 - _S167 * sin_0, _S166 * sin_0 + _S167 * cos_0, d_0.z);
}

fn quarter_turns_0( x_3 : f32,  y_0 : f32) -> f32
{
    var _S168 : f32 = min(x_3, y_0);
    var _S169 : f32 = max(x_3, y_0);
    var ratio_0 : f32;
    if(_S169 > 0.0f)
    {
        ratio_0 = divide_0(_S168, _S169);
    }
    else
    {
        ratio_0 = 0.0f;
    }
    var s_1 : f32 = ratio_0 * ratio_0;
    var turns_0 : f32 = ratio_0 * (0.63661932945251465f + s_1 * (-0.21218447387218475f + s_1 * (0.12698377668857574f + s_1 * (-0.08854507654905319f + s_1 * (0.06138415634632111f + s_1 * (-0.03559486567974091f + s_1 * (0.01391837373375893f + s_1 * -0.00258121290244162f)))))));
    if(y_0 > x_3)
    {
        ratio_0 = 1.0f - turns_0;
    }
    else
    {
        ratio_0 = turns_0;
    }
    return ratio_0;
}

fn square_of_0( direction_8 : vec3<f32>) -> vec2<f32>
{
    var size_1 : vec3<f32> = abs(direction_8);
    var _S170 : f32 = size_1.x;
    var _S171 : f32 = size_1.y;
    var radius_0 : f32 = square_root_0(divide_0(_S170 * _S170 + _S171 * _S171, 1.0f + size_1.z));
    var v_3 : f32 = quarter_turns_0(_S170, _S171) * radius_0;
    var u_2 : f32 = radius_0 - v_3;
    var is_below_1 : bool = (direction_8.z) < 0.0f;
    var u_3 : f32;
    if(is_below_1)
    {
        u_3 = 1.0f - v_3;
    }
    else
    {
        u_3 = u_2;
    }
    var v_4 : f32;
    if(is_below_1)
    {
        v_4 = 1.0f - u_2;
    }
    else
    {
        v_4 = v_3;
    }
    if((direction_8.x) < 0.0f)
    {
        u_3 = - u_3;
    }
    if((direction_8.y) < 0.0f)
    {
        v_4 = - v_4;
    }
    return vec2<f32>(u_3 * 0.5f + 0.5f, v_4 * 0.5f + 0.5f);
}

fn Environment_place_of_0( direction_9 : vec3<f32>) -> vec2<f32>
{
    return square_of_0(Environment_to_map_0(direction_9)) * vec2<f32>(f32(params_0.sky_edge_0));
}

fn Environment_index_of_0( x_4 : i32,  y_1 : i32) -> u32
{
    var last_2 : i32 = i32(params_0.sky_edge_0) - i32(1);
    var is_beside_0 : bool;
    if(x_4 < i32(0))
    {
        is_beside_0 = true;
    }
    else
    {
        is_beside_0 = x_4 > last_2;
    }
    var _S172 : i32;
    if(is_beside_0)
    {
        _S172 = last_2 - y_1;
    }
    else
    {
        _S172 = y_1;
    }
    var _S173 : i32;
    if(is_beside_0)
    {
        _S173 = clamp(x_4, i32(0), last_2);
    }
    else
    {
        _S173 = x_4;
    }
    var is_beyond_0 : bool;
    if(_S172 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S172 > last_2;
    }
    if(is_beyond_0)
    {
        _S173 = last_2 - _S173;
    }
    if(is_beyond_0)
    {
        _S172 = clamp(_S172, i32(0), last_2);
    }
    return u32(_S172 * i32(params_0.sky_edge_0) + _S173);
}

fn Environment_texel_radiance_0( x_5 : i32,  y_2 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_5, y_2)].radiance_0);
}

fn Environment_radiance_at_0( place_2 : vec2<f32>) -> vec3<f32>
{
    var _S174 : vec2<f32> = place_2 - vec2<f32>(0.5f);
    var corner_1 : vec2<f32> = floor(_S174);
    var beyond_2 : vec2<f32> = _S174 - corner_1;
    var x_6 : i32 = i32(corner_1.x);
    var y_3 : i32 = i32(corner_1.y);
    var _S175 : f32 = beyond_2.x;
    var _S176 : vec3<f32> = vec3<f32>((1.0f - _S175));
    var _S177 : i32 = x_6 + i32(1);
    var _S178 : vec3<f32> = vec3<f32>(_S175);
    var _S179 : i32 = y_3 + i32(1);
    var _S180 : f32 = beyond_2.y;
    return (Environment_texel_radiance_0(x_6, y_3) * _S176 + Environment_texel_radiance_0(_S177, y_3) * _S178) * vec3<f32>((1.0f - _S180)) + (Environment_texel_radiance_0(x_6, _S179) * _S176 + Environment_texel_radiance_0(_S177, _S179) * _S178) * vec3<f32>(_S180);
}

fn Environment_radiance_0( direction_10 : vec3<f32>) -> vec3<f32>
{
    return Environment_radiance_at_0(Environment_place_of_0(direction_10));
}

struct Gradient_0
{
     nadir_0 : vec3<f32>,
     zenith_0 : vec3<f32>,
};

fn Gradient_x24init_0( nadir_1 : vec3<f32>,  zenith_1 : vec3<f32>) -> Gradient_0
{
    var _S181 : Gradient_0;
    _S181.nadir_0 = nadir_1;
    _S181.zenith_0 = zenith_1;
    return _S181;
}

fn Gradient_radiance_0( this_33 : Gradient_0,  direction_11 : vec3<f32>) -> vec3<f32>
{
    return this_33.nadir_0 + (this_33.zenith_0 - this_33.nadir_0) * vec3<f32>((0.5f * (direction_11.z + 1.0f)));
}

fn Sky_radiance_0( direction_12 : vec3<f32>) -> vec3<f32>
{
    if(SKY_0 == u32(1))
    {
        return Environment_radiance_0(direction_12) * vec3<f32>(params_0.sky_brightness_0);
    }
    return Gradient_radiance_0(Gradient_x24init_0(params_0.sky_nadir_0, params_0.sky_zenith_0), direction_12) * vec3<f32>(params_0.sky_brightness_0);
}

fn Sky_le_0( direction_13 : vec3<f32>) -> vec3<f32>
{
    return Sky_radiance_0(direction_13);
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn Lights_sun_cosine_0( receiver_1 : Receiver_0) -> f32
{
    return dot_product_0(receiver_1.normal_2, params_0.sun_direction_0);
}

struct LightNode_0
{
     min_1 : array<f32, i32(3)>,
     index_11 : u32,
     max_1 : array<f32, i32(3)>,
     count_1 : u32,
     power_3 : array<f32, i32(6)>,
     parent_0 : u32,
     root_1 : u32,
};

fn Rows_operatorx5Bx5D_get_3( row_7 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(6)) + row_7];
}

fn light_node_of_0( a_5 : vec4<u32>,  b_5 : vec4<u32>,  c_1 : vec4<u32>,  d_1 : vec4<u32>) -> LightNode_0
{
    var node_0 : LightNode_0;
    var _S182 : f32 = (bitcast<f32>((a_5.y)));
    var _S183 : f32 = (bitcast<f32>((a_5.z)));
    node_0.min_1[i32(0)] = (bitcast<f32>((a_5.x)));
    node_0.min_1[i32(1)] = _S182;
    node_0.min_1[i32(2)] = _S183;
    node_0.index_11 = a_5.w;
    var _S184 : f32 = (bitcast<f32>((b_5.y)));
    var _S185 : f32 = (bitcast<f32>((b_5.z)));
    node_0.max_1[i32(0)] = (bitcast<f32>((b_5.x)));
    node_0.max_1[i32(1)] = _S184;
    node_0.max_1[i32(2)] = _S185;
    node_0.count_1 = b_5.w;
    var _S186 : f32 = (bitcast<f32>((c_1.y)));
    var _S187 : f32 = (bitcast<f32>((c_1.z)));
    var _S188 : f32 = (bitcast<f32>((c_1.w)));
    var _S189 : f32 = (bitcast<f32>((d_1.x)));
    var _S190 : f32 = (bitcast<f32>((d_1.y)));
    node_0.power_3[i32(0)] = (bitcast<f32>((c_1.x)));
    node_0.power_3[i32(1)] = _S186;
    node_0.power_3[i32(2)] = _S187;
    node_0.power_3[i32(3)] = _S188;
    node_0.power_3[i32(4)] = _S189;
    node_0.power_3[i32(5)] = _S190;
    node_0.parent_0 = d_1.z;
    node_0.root_1 = d_1.w;
    return node_0;
}

fn top_light_node_0( index_12 : u32) -> LightNode_0
{
    var _S191 : u32 = u32(4) * index_12;
    return light_node_of_0(Rows_operatorx5Bx5D_get_3(_S191), Rows_operatorx5Bx5D_get_3(_S191 + u32(1)), Rows_operatorx5Bx5D_get_3(_S191 + u32(2)), Rows_operatorx5Bx5D_get_3(_S191 + u32(3)));
}

struct View_0
{
     importance_0 : f32,
     of_nearest_0 : f32,
     is_far_0 : bool,
};

fn with_slack_0( receiver_2 : Receiver_0,  cos_1 : f32) -> f32
{
    return cos_1;
}

fn reach_of_0( toward_0 : vec3<f32>,  half_1 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_0), half_1);
}

fn reciprocal_guess_0( x_7 : f32) -> f32
{
    var guess_2 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_7))))));
    return guess_2 * (2.0f - x_7 * guess_2);
}

struct BySide_0
{
     low_10 : vec3<f32>,
     high_4 : vec3<f32>,
};

fn BySide_x24init_0( low_11 : vec3<f32>,  high_5 : vec3<f32>) -> BySide_0
{
    var _S192 : BySide_0;
    _S192.low_10 = low_11;
    _S192.high_4 = high_5;
    return _S192;
}

fn sent_by_side_0( node_1 : LightNode_0,  point_2 : vec3<f32>) -> BySide_0
{
    var _S193 : vec3<f32> = vec3<f32>(0.0f);
    return BySide_x24init_0(vec3<f32>(node_1.power_3[i32(0)], node_1.power_3[i32(2)], node_1.power_3[i32(4)]) * max(vector_of_0(node_1.max_1) - point_2, _S193), vec3<f32>(node_1.power_3[i32(1)], node_1.power_3[i32(3)], node_1.power_3[i32(5)]) * max(point_2 - vector_of_0(node_1.min_1), _S193));
}

fn BySide_sum_0( this_34 : BySide_0) -> f32
{
    var axes_0 : vec3<f32> = this_34.low_10 + this_34.high_4;
    return axes_0.x + axes_0.y + axes_0.z;
}

fn nearest_of_0( toward_1 : vec3<f32>,  half_2 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_1) - half_2, half_2 * vec3<f32>(0.03125f));
}

fn View_x24init_0( importance_1 : f32,  of_nearest_1 : f32,  is_far_1 : bool) -> View_0
{
    var _S194 : View_0;
    _S194.importance_0 = importance_1;
    _S194.of_nearest_0 = of_nearest_1;
    _S194.is_far_0 = is_far_1;
    return _S194;
}

fn view_0( node_2 : LightNode_0,  receiver_3 : Receiver_0) -> View_0
{
    var _S195 : vec3<f32> = vector_of_0(node_2.max_1);
    var _S196 : vec3<f32> = vector_of_0(node_2.min_1);
    var _S197 : vec3<f32> = vec3<f32>(0.5f);
    var half_3 : vec3<f32> = (_S195 - _S196) * _S197;
    var toward_2 : vec3<f32> = (_S196 + _S195) * _S197 - receiver_3.point_0;
    var middle_0 : f32 = dot_product_0(toward_2, receiver_3.normal_2);
    var aside_0 : f32 = dot_product_0(half_3, abs(receiver_3.normal_2));
    var above_0 : f32 = with_slack_0(receiver_3, middle_0 + aside_0);
    var far_4 : f32 = length_squared_0(reach_of_0(toward_2, half_3));
    var near_4 : f32 = length_squared_0(half_3);
    var is_far_2 : bool;
    if((with_slack_0(receiver_3, middle_0 - aside_0)) > 0.0f)
    {
        is_far_2 = far_4 > (near_4 * 36.0f);
    }
    else
    {
        is_far_2 = false;
    }
    var falloff_0 : f32 = reciprocal_guess_0(far_4);
    var cosines_0 : f32;
    if(above_0 > 0.0f)
    {
        cosines_0 = BySide_sum_0(sent_by_side_0(node_2, receiver_3.point_0)) * above_0 * falloff_0;
    }
    else
    {
        cosines_0 = 0.0f;
    }
    return View_x24init_0(cosines_0 * falloff_0, cosines_0 * reciprocal_guess_0(length_squared_0(nearest_of_0(toward_2, half_3))), is_far_2);
}

fn importance_of_all_0( receiver_4 : Receiver_0) -> f32
{
    if((params_0.light_node_count_0) == u32(0))
    {
        return 0.0f;
    }
    return view_0(top_light_node_0(u32(0)), receiver_4).importance_0 * params_0.light_intensity_0;
}

fn EmitterTree_importance_0( receiver_5 : Receiver_0) -> f32
{
    return importance_of_all_0(receiver_5);
}

fn Lights_sun_probability_0( receiver_6 : Receiver_0) -> f32
{
    if(!has_sun_0())
    {
        return 0.0f;
    }
    var cos_theta_0 : f32 = Lights_sun_cosine_0(receiver_6);
    if(cos_theta_0 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    var from_emitters_0 : f32 = EmitterTree_importance_0(receiver_6);
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_0, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S198 : bool;
    if(SKY_0 == u32(1))
    {
        _S198 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S198 = false;
    }
    return _S198;
}

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S199 : Selection_0;
    _S199.sun_0 = sun_1;
    _S199.sky_1 = sky_2;
    _S199.emitters_0 = emitters_1;
    return _S199;
}

fn Lights_sky_probability_0( receiver_7 : Receiver_0) -> f32
{
    var from_sun_1 : f32;
    if(has_sun_0())
    {
        from_sun_1 = params_0.sun_irradiance_0 * max(Lights_sun_cosine_0(receiver_7), 0.0f);
    }
    else
    {
        from_sun_1 = 0.0f;
    }
    var from_others_0 : f32 = from_sun_1 + EmitterTree_importance_0(receiver_7);
    if(from_others_0 <= 0.0f)
    {
        return 1.0f;
    }
    return clamp(divide_0(params_0.sky_irradiance_0, params_0.sky_irradiance_0 + from_others_0), 0.25f, 0.75f);
}

fn Lights_selection_0( receiver_8 : Receiver_0) -> Selection_0
{
    var sun_2 : f32 = Lights_sun_probability_0(receiver_8);
    if(!Lights_has_chosen_sky_0())
    {
        return Selection_x24init_0(sun_2, 0.0f, 1.0f - sun_2);
    }
    var sky_3 : f32 = Lights_sky_probability_0(receiver_8);
    var _S200 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S200, sky_3, (1.0f - sun_2) * _S200);
}

fn Path_selection_at_0( this_35 : Path_0,  last_3 : Receiver_0) -> Selection_0
{
    return Lights_selection_0(last_3);
}

fn Environment_pdf_0( direction_14 : vec3<f32>) -> f32
{
    var place_3 : vec2<f32> = Environment_place_of_0(direction_14);
    var last_4 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_3.x), last_4), min(i32(place_3.y), last_4))].pdf_0;
}

fn Sky_pdf_0( direction_15 : vec3<f32>) -> f32
{
    var _S201 : f32;
    if(SKY_0 == u32(1))
    {
        _S201 = Environment_pdf_0(direction_15);
    }
    else
    {
        _S201 = 0.0f;
    }
    return _S201;
}

fn Lights_sky_pdf_0( selection_1 : Selection_0,  direction_16 : vec3<f32>) -> f32
{
    var _S202 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S202 = Sky_pdf_0(direction_16) * selection_1.sky_1;
    }
    else
    {
        _S202 = 0.0f;
    }
    return _S202;
}

fn power_heuristic_0( own_0 : f32,  other_1 : f32) -> f32
{
    var ratio_1 : f32 = divide_0(other_1, own_0);
    return divide_0(1.0f, 1.0f + ratio_1 * ratio_1);
}

fn mis_weight_0( bounce_pdf_0 : f32,  light_pdf_0 : f32) -> f32
{
    var _S203 : bool;
    if(bounce_pdf_0 == 0.0f)
    {
        _S203 = true;
    }
    else
    {
        _S203 = light_pdf_0 == 0.0f;
    }
    if(_S203)
    {
        return 1.0f;
    }
    return power_heuristic_0(bounce_pdf_0, light_pdf_0);
}

fn SunDisc_is_visible_0() -> bool
{
    return (params_0.hides_sun_disc_0) == u32(0);
}

fn Path_is_straight_0( this_36 : Path_0) -> bool
{
    var _S204 : bool;
    if((this_36.bounce_0) == u32(0))
    {
        _S204 = (this_36.pdf_1) == 0.0f;
    }
    else
    {
        _S204 = false;
    }
    if(_S204)
    {
        _S204 = (all(((this_36.normal_0) == vec3<f32>(0.0f))));
    }
    else
    {
        _S204 = false;
    }
    return _S204;
}

fn SunDisc_contains_0( direction_17 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_17 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_le_0( direction_18 : vec3<f32>) -> vec3<f32>
{
    var _S205 : vec3<f32>;
    if(SunDisc_contains_0(direction_18))
    {
        _S205 = params_0.sun_radiance_0;
    }
    else
    {
        _S205 = vec3<f32>(0.0f);
    }
    return _S205;
}

fn SunDisc_pdf_0( direction_19 : vec3<f32>) -> f32
{
    var _S206 : f32;
    if(SunDisc_contains_0(direction_19))
    {
        _S206 = params_0.sun_pdf_0;
    }
    else
    {
        _S206 = 0.0f;
    }
    return _S206;
}

fn Lights_sun_pdf_0( selection_2 : Selection_0,  direction_20 : vec3<f32>) -> f32
{
    var _S207 : f32;
    if(has_sun_0())
    {
        _S207 = SunDisc_pdf_0(direction_20) * selection_2.sun_0;
    }
    else
    {
        _S207 = 0.0f;
    }
    return _S207;
}

fn Path_dimension_scatter_0( this_37 : Path_0) -> u32
{
    return u32(1) + u32(2) * Path_events_0(this_37);
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
    var index_13 : u32 = owen_of_reversed_0(reverseBits(sample_1), order_0);
    var binomial_0 : u32 = (index_13 ^ (((((index_13 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_13, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_38 : Sampler_0,  dimension_1 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_2 : vec4<u32> = pcg4d_0(vec4<u32>(this_38.pixel_0, dimension_1, this_38.seed_1, which_0));
    return scrambled_sobol_0(this_38.sample_0, words_2.x, words_2.yz);
}

fn Sampler_stratified_0( this_39 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_39, dimension_2, u32(1)), Sampler_pair_0(this_39, dimension_2, u32(2))));
}

fn emitted_0( material_4 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_4.emission_0) * vec3<f32>(params_0.emitter_intensity_0);
}

fn EmitterTree_le_0( material_5 : PackedMaterial_0) -> vec3<f32>
{
    return emitted_0(material_5);
}

fn luminance_0( color_1 : vec3<f32>) -> f32
{
    return color_1.x * 0.2125999927520752f + color_1.y * 0.71520000696182251f + color_1.z * 0.07220000028610229f;
}

struct Aim_0
{
     is_met_0 : bool,
     direction_21 : vec3<f32>,
     hit_6 : Hit_0,
     luminance_1 : f32,
};

fn Aim_x24init_0( is_met_1 : bool,  direction_22 : vec3<f32>,  hit_7 : Hit_0,  luminance_2 : f32) -> Aim_0
{
    var _S208 : Aim_0;
    _S208.is_met_0 = is_met_1;
    _S208.direction_21 = direction_22;
    _S208.hit_6 = hit_7;
    _S208.luminance_1 = luminance_2;
    return _S208;
}

struct LightSample_0
{
     ray_13 : Ray_0,
     cos_theta_1 : f32,
     radiance_1 : vec3<f32>,
     pdf_2 : f32,
};

fn LightSample_x24init_0( ray_14 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_3 : f32) -> LightSample_0
{
    var _S209 : LightSample_0;
    _S209.ray_13 = ray_14;
    _S209.cos_theta_1 = cos_theta_2;
    _S209.radiance_1 = radiance_2;
    _S209.pdf_2 = pdf_3;
    return _S209;
}

fn no_light_0() -> LightSample_0
{
    var _S210 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S210, 0.0f, _S210, 0.0f), 0.0f, _S210, 0.0f);
}

fn sincos_turns_0( turns_1 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_1 * 4.0f + 0.5f);
    var x_8 : f32 = (turns_1 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_8 * x_8;
    var sin_1 : f32 = x_8 + x_8 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
    var cos_2 : f32 = 1.0f + xx_0 * (-0.5f + xx_0 * (0.0416666679084301f + xx_0 * (-0.00138888892251998f + xx_0 * (0.00002480158764229f + xx_0 * -2.75573199814971304e-07f))));
    switch((quadrant_0 & (i32(3))))
    {
    case i32(0):
        {
            return vec2<f32>(sin_1, cos_2);
        }
    case i32(1):
        {
            return vec2<f32>(cos_2, - sin_1);
        }
    case i32(2):
        {
            return vec2<f32>(- sin_1, - cos_2);
        }
    default :
        {
            return vec2<f32>(- cos_2, sin_1);
        }
    }
}

fn ray_from_0( origin_12 : vec3<f32>,  direction_23 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_12, 0.0f, direction_23, (bitcast<f32>(infinity_bits_0)));
}

fn SunDisc_sample_0( receiver_9 : Receiver_0,  u_4 : vec4<f32>,  sample_2 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_4.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_1 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_0 : vec2<f32> = sincos_turns_0(u_4.w);
    var direction_24 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_1 * sin_cos_0.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_1 * sin_cos_0.x)));
    var cos_theta_3 : f32 = with_slack_0(receiver_9, dot_product_0(receiver_9.normal_2, direction_24));
    (*sample_2) = LightSample_x24init_0(ray_from_0(receiver_9.point_0, direction_24), cos_theta_3, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_3 > 0.0f;
}

struct ChosenDirection_0
{
     direction_25 : vec3<f32>,
     radiance_3 : vec3<f32>,
     pdf_4 : f32,
};

fn ChosenDirection_x24init_0( direction_26 : vec3<f32>,  radiance_4 : vec3<f32>,  pdf_5 : f32) -> ChosenDirection_0
{
    var _S211 : ChosenDirection_0;
    _S211.direction_25 = direction_26;
    _S211.radiance_3 = radiance_4;
    _S211.pdf_4 = pdf_5;
    return _S211;
}

fn direction_of_0( square_0 : vec2<f32>) -> vec3<f32>
{
    var u_5 : f32 = square_0.x * 2.0f - 1.0f;
    var v_5 : f32 = square_0.y * 2.0f - 1.0f;
    var _S212 : f32 = abs(u_5);
    var _S213 : f32 = abs(v_5);
    var height_1 : f32 = 1.0f - (_S212 + _S213);
    var radius_2 : f32 = 1.0f - abs(height_1);
    var turns_2 : f32;
    if(radius_2 > 0.0f)
    {
        turns_2 = (divide_0(_S213 - _S212, radius_2) + 1.0f) * 0.125f;
    }
    else
    {
        turns_2 = 0.0f;
    }
    var sin_cos_1 : vec2<f32> = sincos_turns_0(turns_2);
    var _S214 : f32 = radius_2 * radius_2;
    var across_0 : f32 = radius_2 * square_root_0(2.0f - _S214);
    var x_9 : f32 = sin_cos_1.y * across_0;
    var y_4 : f32 = sin_cos_1.x * across_0;
    var z_0 : f32 = 1.0f - _S214;
    if(u_5 < 0.0f)
    {
        turns_2 = - x_9;
    }
    else
    {
        turns_2 = x_9;
    }
    var _S215 : f32;
    if(v_5 < 0.0f)
    {
        _S215 = - y_4;
    }
    else
    {
        _S215 = y_4;
    }
    var _S216 : f32;
    if(height_1 < 0.0f)
    {
        _S216 = - z_0;
    }
    else
    {
        _S216 = z_0;
    }
    return vec3<f32>(turns_2, _S215, _S216);
}

fn Environment_to_world_0( d_2 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S217 : f32 = d_2.x;
    var _S218 : f32 = d_2.y;
    return vec3<f32>(_S217 * cos_3 + _S218 * sin_2, _S218 * cos_3 - _S217 * sin_2, d_2.z);
}

fn Environment_choose_0( u_6 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S219 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S219, _S219, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S220 : f32 = u_6.x * edge_0;
    var _S221 : f32 = edge_0 - 1.0f;
    var _S222 : f32 = min(floor(_S220), _S221);
    var own_1 : u32 = u32(_S222) * params_0.sky_edge_0 + u32(min(floor(u_6.y * edge_0), _S221));
    var index_14 : u32;
    if((u_6.z) < (environment_0[own_1].threshold_0))
    {
        index_14 = own_1;
    }
    else
    {
        index_14 = environment_0[own_1].alias_0;
    }
    var pdf_6 : f32 = environment_0[index_14].pdf_0;
    if((environment_0[index_14].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S223 : u32 = index_14 % params_0.sky_edge_0;
    var _S224 : f32 = f32(_S223);
    var _S225 : u32 = index_14 / params_0.sky_edge_0;
    var place_4 : vec2<f32> = vec2<f32>(_S224, f32(_S225)) + vec2<f32>(min(_S220 - _S222, 1.0f), u_6.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_4 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_4), pdf_6);
    return true;
}

fn Sky_sample_0( receiver_10 : Receiver_0,  u_7 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S226 : bool;
    if(SKY_0 != u32(1))
    {
        _S226 = true;
    }
    else
    {
        var _S227 : bool = Environment_choose_0(u_7, &(chosen_1));
        _S226 = !_S227;
    }
    if(_S226)
    {
        return false;
    }
    var cos_theta_4 : f32 = with_slack_0(receiver_10, dot_product_0(receiver_10.normal_2, chosen_1.direction_25));
    (*sample_3) = LightSample_x24init_0(ray_from_0(receiver_10.point_0, chosen_1.direction_25), cos_theta_4, chosen_1.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_4);
    return cos_theta_4 > 0.0f;
}

struct Descent_0
{
     node_3 : u32,
     index_15 : u32,
     count_2 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
     is_far_3 : bool,
};

fn Descent_x24init_0( node_4 : u32,  index_16 : u32,  count_3 : u32,  weight_1 : f32,  total_1 : f32,  choice_1 : f32,  is_far_4 : bool) -> Descent_0
{
    var _S228 : Descent_0;
    _S228.node_3 = node_4;
    _S228.index_15 = index_16;
    _S228.count_2 = count_3;
    _S228.weight_0 = weight_1;
    _S228.total_0 = total_1;
    _S228.choice_0 = choice_1;
    _S228.is_far_3 = is_far_4;
    return _S228;
}

fn TopLights_node_0( index_17 : u32) -> LightNode_0
{
    return top_light_node_0(index_17);
}

fn Descent_at_0( this_40 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_5 : LightNode_0 = TopLights_node_0(root_2);
    (*this_40).node_3 = root_2;
    (*this_40).index_15 = node_5.index_11;
    (*this_40).count_2 = node_5.count_1;
    (*this_40).is_far_3 = false;
    return;
}

fn normal_or_zero_0( weight_2 : f32) -> f32
{
    var _S229 : f32;
    if(weight_2 < 1.17549435082228751e-38f)
    {
        _S229 = 0.0f;
    }
    else
    {
        _S229 = weight_2;
    }
    return _S229;
}

fn weights_of_0( left_0 : f32,  right_0 : f32) -> vec2<f32>
{
    var _S230 : f32 = normal_or_zero_0(left_0);
    var _S231 : f32 = normal_or_zero_0(right_0);
    var unit_0 : f32 = inverse_power_of_two_0(_S230 + _S231);
    return vec2<f32>(normal_or_zero_0(_S230 * unit_0), normal_or_zero_0(_S231 * unit_0));
}

fn weights_of_views_0( left_1 : View_0,  right_1 : View_0) -> vec2<f32>
{
    var near_5 : vec2<f32> = weights_of_0(left_1.of_nearest_0, right_1.of_nearest_0);
    var _S232 : f32 = near_5.x;
    var _S233 : f32 = near_5.y;
    var of_near_0 : f32 = _S232 + _S233;
    var of_all_0 : f32 = (left_1.importance_0 + right_1.importance_0) * 0.5f;
    return weights_of_0(left_1.importance_0 * of_near_0 + _S232 * of_all_0, right_1.importance_0 * of_near_0 + _S233 * of_all_0);
}

fn climb_0( receiver_11 : Receiver_0,  start_3 : u32,  descent_0 : ptr<function, Descent_0>) -> bool
{
    var node_6 : LightNode_0 = top_light_node_0(start_3);
    var at_1 : u32 = start_3;
    for(;;)
    {
        var _S234 : LightNode_0 = node_6;
        if((node_6.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S234.parent_0);
        var _S235 : u32 = _S234.parent_0 + u32(1);
        var is_left_0 : bool = at_1 == _S235;
        var _S236 : u32;
        if(is_left_0)
        {
            _S236 = parent_1.index_11;
        }
        else
        {
            _S236 = _S235;
        }
        var own_2 : View_0 = view_0(node_6, receiver_11);
        var other_2 : View_0 = view_0(top_light_node_0(_S236), receiver_11);
        var weights_0 : vec2<f32>;
        if(is_left_0)
        {
            weights_0 = weights_of_views_0(own_2, other_2);
        }
        else
        {
            weights_0 = weights_of_views_0(other_2, own_2);
        }
        var _S237 : f32 = weights_0.x;
        var _S238 : f32 = weights_0.y;
        var total_2 : f32 = _S237 + _S238;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S239 : f32;
        if(is_left_0)
        {
            _S239 = _S237;
        }
        else
        {
            _S239 = _S238;
        }
        (*descent_0).weight_0 = (*descent_0).weight_0 * _S239;
        (*descent_0).total_0 = (*descent_0).total_0 * total_2;
        node_6 = parent_1;
        at_1 = _S234.parent_0;
    }
    return ((*descent_0).weight_0) > 0.0f;
}

fn by_chance_1() -> Aim_0
{
    return Aim_x24init_0(false, vec3<f32>(0.0f), miss_0(), 0.0f);
}

fn descend_0( receiver_12 : Receiver_0,  aim_0 : Aim_0,  descent_1 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S240 : bool;
        if(((*descent_1).count_2) == u32(0))
        {
            _S240 = !(*descent_1).is_far_3;
        }
        else
        {
            _S240 = false;
        }
        if(_S240)
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
        var left_2 : LightNode_0 = TopLights_node_0((*descent_1).node_3 + u32(1));
        var right_2 : LightNode_0 = TopLights_node_0((*descent_1).index_15);
        var weights_1 : vec2<f32> = weights_of_views_0(view_0(left_2, receiver_12), view_0(right_2, receiver_12));
        var _S241 : f32 = weights_1.x;
        var _S242 : f32 = weights_1.y;
        var total_3 : f32 = _S241 + _S242;
        if(!(total_3 > 0.0f))
        {
            return false;
        }
        var _S243 : bool;
        if(_S242 <= 0.0f)
        {
            _S243 = true;
        }
        else
        {
            _S243 = ((*descent_1).choice_0 * total_3) < (_S241 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_0.is_met_0)
        {
            var _S244 : vec3<f32> = vec3<f32>(aim_0.hit_6.voxel_0);
            if((all((_S244 >= (vector_of_0(left_2.min_1))))))
            {
                is_left_1 = (all((_S244 < (vector_of_0(left_2.max_1)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S243;
        }
        var _S245 : f32 = (*descent_1).choice_0 * total_3;
        var _S246 : f32;
        if(is_left_1)
        {
            _S246 = 0.0f;
        }
        else
        {
            _S246 = _S241 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S245 - _S246;
        var _S247 : u32;
        if(is_left_1)
        {
            _S247 = (*descent_1).node_3 + u32(1);
        }
        else
        {
            _S247 = (*descent_1).index_15;
        }
        (*descent_1).node_3 = _S247;
        var _S248 : u32;
        if(is_left_1)
        {
            _S248 = left_2.index_11;
        }
        else
        {
            _S248 = right_2.index_11;
        }
        (*descent_1).index_15 = _S248;
        var _S249 : u32;
        if(is_left_1)
        {
            _S249 = left_2.count_1;
        }
        else
        {
            _S249 = right_2.count_1;
        }
        (*descent_1).count_2 = _S249;
        (*descent_1).is_far_3 = false;
        var _S250 : f32;
        if(is_left_1)
        {
            _S250 = _S241;
        }
        else
        {
            _S250 = _S242;
        }
        var _S251 : f32 = (*descent_1).weight_0 * _S250;
        (*descent_1).weight_0 = _S251;
        (*descent_1).total_0 = (*descent_1).total_0 * total_3;
        if(_S251 <= 0.0f)
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

fn in_grid_0( instance_13 : u32,  receiver_13 : Receiver_0) -> Receiver_0
{
    if(IS_SINGLE_0)
    {
        return receiver_13;
    }
    var _S252 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(instance_13);
    return Receiver_x24init_0(Transform_point_0(_S252.grid_from_world_0, receiver_13.point_0), normalize_vector_0(Transform_direction_0(_S252.grid_from_world_0, receiver_13.normal_2)));
}

fn lights_in_pages_0() -> bool
{
    return false;
}

fn Rows_operatorx5Bx5D_get_4( row_8 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(5)) + row_8];
}

fn place_in_light_node_0( node_7 : u32,  word_5 : u32) -> u32
{
    return u32(0);
}

fn light_node_at_0( index_18 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S253 : u32 = u32(4) * index_18;
        return light_node_of_0(Rows_operatorx5Bx5D_get_4(_S253), Rows_operatorx5Bx5D_get_4(_S253 + u32(1)), Rows_operatorx5Bx5D_get_4(_S253 + u32(2)), Rows_operatorx5Bx5D_get_4(_S253 + u32(3)));
    }
    var at_2 : u32 = place_in_light_node_0(index_18, u32(0));
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
        node_8.min_1[i_0] = (bitcast<f32>((cells_1[at_2 + i_0])));
        node_8.max_1[i_0] = (bitcast<f32>((cells_1[at_2 + u32(4) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.index_11 = cells_1[at_2 + u32(3)];
    node_8.count_1 = cells_1[at_2 + u32(7)];
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
        node_8.power_3[i_0] = (bitcast<f32>((cells_1[at_2 + u32(8) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.parent_0 = cells_1[at_2 + u32(14)];
    node_8.root_1 = cells_1[at_2 + u32(15)];
    return node_8;
}

fn GridLights_node_0( index_19 : u32) -> LightNode_0
{
    return light_node_at_0(index_19);
}

fn Descent_at_1( this_41 : ptr<function, Descent_0>,  root_3 : u32)
{
    var node_9 : LightNode_0 = GridLights_node_0(root_3);
    (*this_41).node_3 = root_3;
    (*this_41).index_15 = node_9.index_11;
    (*this_41).count_2 = node_9.count_1;
    (*this_41).is_far_3 = false;
    return;
}

fn descend_1( receiver_14 : Receiver_0,  aim_1 : Aim_0,  descent_2 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S254 : bool;
        if(((*descent_2).count_2) == u32(0))
        {
            _S254 = !(*descent_2).is_far_3;
        }
        else
        {
            _S254 = false;
        }
        if(_S254)
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
        var left_3 : LightNode_0 = GridLights_node_0((*descent_2).node_3 + u32(1));
        var right_3 : LightNode_0 = GridLights_node_0((*descent_2).index_15);
        var of_left_0 : View_0 = view_0(left_3, receiver_14);
        var of_right_0 : View_0 = view_0(right_3, receiver_14);
        var weights_2 : vec2<f32> = weights_of_views_0(of_left_0, of_right_0);
        var _S255 : f32 = weights_2.x;
        var _S256 : f32 = weights_2.y;
        var total_4 : f32 = _S255 + _S256;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S257 : bool;
        if(_S256 <= 0.0f)
        {
            _S257 = true;
        }
        else
        {
            _S257 = ((*descent_2).choice_0 * total_4) < (_S255 * (*descent_2).weight_0);
        }
        var is_left_2 : bool;
        if(aim_1.is_met_0)
        {
            var _S258 : vec3<f32> = vec3<f32>(aim_1.hit_6.voxel_0);
            if((all((_S258 >= (vector_of_0(left_3.min_1))))))
            {
                is_left_2 = (all((_S258 < (vector_of_0(left_3.max_1)))));
            }
            else
            {
                is_left_2 = false;
            }
        }
        else
        {
            is_left_2 = _S257;
        }
        var _S259 : f32 = (*descent_2).choice_0 * total_4;
        var _S260 : f32;
        if(is_left_2)
        {
            _S260 = 0.0f;
        }
        else
        {
            _S260 = _S255 * (*descent_2).weight_0;
        }
        (*descent_2).choice_0 = _S259 - _S260;
        var _S261 : u32;
        if(is_left_2)
        {
            _S261 = (*descent_2).node_3 + u32(1);
        }
        else
        {
            _S261 = (*descent_2).index_15;
        }
        (*descent_2).node_3 = _S261;
        var _S262 : u32;
        if(is_left_2)
        {
            _S262 = left_3.index_11;
        }
        else
        {
            _S262 = right_3.index_11;
        }
        (*descent_2).index_15 = _S262;
        var _S263 : u32;
        if(is_left_2)
        {
            _S263 = left_3.count_1;
        }
        else
        {
            _S263 = right_3.count_1;
        }
        (*descent_2).count_2 = _S263;
        var _S264 : bool;
        if(is_left_2)
        {
            _S264 = of_left_0.is_far_0;
        }
        else
        {
            _S264 = of_right_0.is_far_0;
        }
        (*descent_2).is_far_3 = _S264;
        var _S265 : f32;
        if(is_left_2)
        {
            _S265 = _S255;
        }
        else
        {
            _S265 = _S256;
        }
        var _S266 : f32 = (*descent_2).weight_0 * _S265;
        (*descent_2).weight_0 = _S266;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        if(_S266 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_0( point_3 : vec3<f32>,  is_met_2 : bool,  way_4 : Descent_0,  side_0 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var sent_0 : BySide_0 = sent_by_side_0(light_node_at_0(way_4.node_3), point_3);
    var sum_3 : f32 = normal_or_zero_0(BySide_sum_0(sent_0));
    var unit_1 : f32 = inverse_power_of_two_0(sum_3);
    var total_5 : f32 = sum_3 * unit_1;
    var _S267 : f32 = way_4.choice_0 * total_5;
    var _S268 : u32 = (*side_0);
    var share_1 : f32 = normal_or_zero_0(sent_0.low_10[u32(0)] * unit_1);
    var _S269 : bool;
    if(is_met_2)
    {
        _S269 = u32(0) == _S268;
    }
    else
    {
        _S269 = share_1 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S269)
    {
        (*side_0) = u32(0);
        chosen_2 = share_1;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S270 : bool = _S267 < (share_1 * way_4.weight_0);
    var share_2 : f32 = normal_or_zero_0(sent_0.high_4[u32(0)] * unit_1);
    if(is_met_2)
    {
        _S269 = u32(1) == _S268;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S269 = !_S270;
        }
        else
        {
            _S269 = false;
        }
    }
    if(_S269)
    {
        (*side_0) = u32(1);
        chosen_2 = share_2;
    }
    var passed_0 : f32 = share_1 + share_2;
    if(_S270)
    {
        _S269 = true;
    }
    else
    {
        _S269 = _S267 < (passed_0 * way_4.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_0.low_10[u32(1)] * unit_1);
    var _S271 : bool;
    if(is_met_2)
    {
        _S271 = u32(2) == _S268;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S271 = !_S269;
        }
        else
        {
            _S271 = false;
        }
    }
    if(_S271)
    {
        (*side_0) = u32(2);
        chosen_2 = share_3;
    }
    var passed_1 : f32 = passed_0 + share_3;
    if(_S269)
    {
        _S269 = true;
    }
    else
    {
        _S269 = _S267 < (passed_1 * way_4.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_0.high_4[u32(1)] * unit_1);
    if(is_met_2)
    {
        _S271 = u32(3) == _S268;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S271 = !_S269;
        }
        else
        {
            _S271 = false;
        }
    }
    if(_S271)
    {
        (*side_0) = u32(3);
        chosen_2 = share_4;
    }
    var passed_2 : f32 = passed_1 + share_4;
    if(_S269)
    {
        _S269 = true;
    }
    else
    {
        _S269 = _S267 < (passed_2 * way_4.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_0.low_10[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S271 = u32(4) == _S268;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S271 = !_S269;
        }
        else
        {
            _S271 = false;
        }
    }
    if(_S271)
    {
        (*side_0) = u32(4);
        chosen_2 = share_5;
    }
    var passed_3 : f32 = passed_2 + share_5;
    if(_S269)
    {
        _S269 = true;
    }
    else
    {
        _S269 = _S267 < (passed_3 * way_4.weight_0);
    }
    var share_6 : f32 = normal_or_zero_0(sent_0.high_4[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S269 = u32(5) == _S268;
    }
    else
    {
        if(share_6 > 0.0f)
        {
            _S269 = !_S269;
        }
        else
        {
            _S269 = false;
        }
    }
    if(_S269)
    {
        (*side_0) = u32(5);
        chosen_2 = share_6;
    }
    (*odds_0) = vec2<f32>(way_4.weight_0 * chosen_2, way_4.total_0 * total_5);
    if(sum_3 > 0.0f)
    {
        _S269 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S269 = false;
    }
    return _S269;
}

fn light_node_word_0( index_20 : u32,  word_6 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_4(u32(4) * index_20 + ((word_6 >> (u32(2)))))[(word_6 & (u32(3)))];
}

fn light_power_at_0( index_21 : u32,  side_1 : u32) -> f32
{
    var _S272 : u32;
    if(lights_in_pages_0())
    {
        _S272 = cells_1[place_in_light_node_0(index_21, u32(8) + side_1)];
    }
    else
    {
        _S272 = light_node_word_0(index_21, u32(8) + side_1);
    }
    return (bitcast<f32>((_S272)));
}

fn component_0( vector_5 : vec3<f32>,  axis_6 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_6 == u32(1)), vector_5.x, axis_6 == u32(0));
}

fn density_0( odds_1 : vec2<f32>,  luminance_3 : f32,  power_4 : f32,  toward_3 : vec3<f32>,  face_3 : u32) -> f32
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
    var unit_2 : f32 = inverse_power_of_two_0(power_4);
    var share_7 : f32 = odds_1.x * (luminance_3 * unit_2) * (distance_squared_0 * square_root_0(distance_squared_0));
    if(in_front_0 > 0.0f)
    {
        in_front_0 = divide_0(share_7, odds_1.y * (power_4 * unit_2) * in_front_0);
    }
    else
    {
        in_front_0 = -1.0f;
    }
    return in_front_0;
}

struct Emitter_0
{
     voxel_24 : array<i32, i32(3)>,
     grid_10 : u32,
     faces_0 : u32,
     material_6 : u32,
     luminance_4 : f32,
     leaf_0 : u32,
};

fn below_light_node_0( index_22 : u32) -> vec2<u32>
{
    if(!lights_in_pages_0())
    {
        return vec2<u32>(light_node_word_0(index_22, u32(3)), light_node_word_0(index_22, u32(7)));
    }
    var at_3 : u32 = place_in_light_node_0(index_22, u32(0));
    return vec2<u32>(cells_1[at_3 + u32(3)], cells_1[at_3 + u32(7)]);
}

fn place_in_emitter_0( emitter_0 : u32,  word_7 : u32) -> u32
{
    return u32(0);
}

fn Rows_operatorx5Bx5D_get_5( row_9 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(4)) + row_9];
}

fn emitter_word_0( index_23 : u32,  word_8 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_5(u32(2) * index_23 + ((word_8 >> (u32(2)))))[(word_8 & (u32(3)))];
}

fn emitter_faces_at_0( index_24 : u32) -> u32
{
    var _S273 : u32;
    if(lights_in_pages_0())
    {
        _S273 = cells_1[place_in_emitter_0(index_24, u32(4))];
    }
    else
    {
        _S273 = emitter_word_0(index_24, u32(4));
    }
    return _S273;
}

fn emitter_luminance_at_0( index_25 : u32) -> f32
{
    var _S274 : f32;
    if(lights_in_pages_0())
    {
        _S274 = (bitcast<f32>((cells_1[place_in_emitter_0(index_25, u32(6))])));
    }
    else
    {
        _S274 = (bitcast<f32>((emitter_word_0(index_25, u32(6)))));
    }
    return _S274;
}

fn Emitter_x24init_0( voxel_25 : array<i32, i32(3)>,  grid_11 : u32,  faces_1 : u32,  material_7 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S275 : Emitter_0;
    _S275.voxel_24 = voxel_25;
    _S275.grid_10 = grid_11;
    _S275.faces_0 = faces_1;
    _S275.material_6 = material_7;
    _S275.luminance_4 = luminance_5;
    _S275.leaf_0 = leaf_1;
    return _S275;
}

fn emitter_at_0( index_26 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S276 : u32 = u32(2) * index_26;
        var _S277 : vec4<u32> = Rows_operatorx5Bx5D_get_5(_S276);
        var _S278 : vec4<u32> = Rows_operatorx5Bx5D_get_5(_S276 + u32(1));
        var _S279 : array<i32, i32(3)> = array<i32, i32(3)>( i32(_S277.x), i32(_S277.y), i32(_S277.z) );
        return Emitter_x24init_0(_S279, _S277.w, _S278.x, _S278.y, (bitcast<f32>((_S278.z))), _S278.w);
    }
    var at_4 : u32 = place_in_emitter_0(index_26, u32(0));
    var _S280 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_1[at_4]), i32(cells_1[at_4 + u32(1)]), i32(cells_1[at_4 + u32(2)]) );
    return Emitter_x24init_0(_S280, cells_1[at_4 + u32(3)], cells_1[at_4 + u32(4)], cells_1[at_4 + u32(5)], (bitcast<f32>((cells_1[at_4 + u32(6)]))), cells_1[at_4 + u32(7)]);
}

fn choose_emitter_0( way_5 : Descent_0,  side_2 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_8 : bool;
    var is_left_3 : bool;
    var count_4 : u32 = way_5.count_2;
    var node_10 : u32 = way_5.node_3;
    var index_27 : u32 = way_5.index_15;
    var _S281 : f32 = threshold_1;
    for(;;)
    {
        if(count_4 == u32(0))
        {
            is_found_8 = !waits_for_pages_0();
        }
        else
        {
            is_found_8 = false;
        }
        if(is_found_8)
        {
        }
        else
        {
            break;
        }
        var left_4 : u32 = node_10 + u32(1);
        var power_left_0 : f32 = light_power_at_0(left_4, side_2);
        if(_S281 < power_left_0)
        {
            is_left_3 = true;
        }
        else
        {
            is_left_3 = (light_power_at_0(index_27, side_2)) <= 0.0f;
        }
        if(is_left_3)
        {
        }
        else
        {
            _S281 = _S281 - power_left_0;
        }
        if(is_left_3)
        {
            node_10 = left_4;
        }
        else
        {
            node_10 = index_27;
        }
        var below_0 : vec2<u32> = below_light_node_0(node_10);
        var _S282 : u32 = below_0.x;
        count_4 = below_0.y;
        index_27 = _S282;
    }
    is_found_8 = false;
    var chosen_3 : u32 = index_27;
    var at_5 : u32 = index_27;
    for(;;)
    {
        if(at_5 < (index_27 + count_4))
        {
            is_left_3 = !is_found_8;
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
        if((((((emitter_faces_at_0(at_5)) >> (side_2))) & (u32(1)))) != u32(0))
        {
            var _S283 : f32 = _S281 - emitter_luminance_at_0(at_5);
            is_found_8 = _S281 < (emitter_luminance_at_0(at_5));
            chosen_3 = at_5;
            _S281 = _S283;
        }
        at_5 = at_5 + u32(1);
    }
    return emitter_at_0(chosen_3);
}

fn point_of_face_0( low_12 : vec3<f32>,  face_4 : u32,  u_8 : f32,  v_6 : f32) -> vec3<f32>
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
        return low_12 + vec3<f32>(away_0, u_8, v_6);
    }
    if(face_4 < u32(4))
    {
        return low_12 + vec3<f32>(u_8, away_0, v_6);
    }
    return low_12 + vec3<f32>(u_8, v_6, away_0);
}

fn margin_of_0( translation_1 : vec3<f32>,  low_13 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_13) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn offset_ray_origin_0( translation_2 : vec3<f32>,  low_14 : vec3<f32>,  face_5 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_14);
    var _S284 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_4, low_14 + _S284), low_14 + vec3<f32>((1.0f - margin_0)));
    var _S285 : bool = face_5 < u32(2);
    var _S286 : bool;
    if(face_5 >= u32(2))
    {
        _S286 = face_5 < u32(4);
    }
    else
    {
        _S286 = false;
    }
    var is_axis_3 : vec3<bool> = vec3<bool>(_S285, _S286, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_14 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_14 - _S284;
    }
    return select(moved_0, outside_0, is_axis_3);
}

fn sample_emitter_0( receiver_15 : Receiver_0,  u_9 : vec4<f32>,  aim_2 : Aim_0,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    (*sample_4) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_9.x, false);
    Descent_at_0(&(descent_3), u32(0));
    var _S287 : bool;
    if(!IS_SINGLE_0)
    {
        _S287 = aim_2.is_met_0;
    }
    else
    {
        _S287 = false;
    }
    if(_S287)
    {
        var _S288 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(aim_2.hit_6.instance_0);
        if((_S288.light_leaf_0) == u32(4294967295))
        {
            _S287 = true;
        }
        else
        {
            var _S289 : bool = climb_0(receiver_15, _S288.light_leaf_0, &(descent_3));
            _S287 = !_S289;
        }
        if(_S287)
        {
            return false;
        }
        Descent_at_0(&(descent_3), _S288.light_leaf_0);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S290 : bool = descend_0(receiver_15, by_chance_1(), &(descent_3));
            _S287 = !_S290;
        }
        else
        {
            _S287 = false;
        }
        if(_S287)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_15;
    var local_3 : Receiver_0 = in_grid_0(descent_3.index_15, receiver_15);
    Descent_at_1(&(descent_3), top_light_node_0(descent_3.node_3).root_1);
    var _S291 : bool = descend_1(local_3, aim_2, &(descent_3));
    if(!_S291)
    {
        return false;
    }
    var side_3 : u32 = aim_2.hit_6.face_0;
    var odds_2 : vec2<f32>;
    var _S292 : bool = choose_side_0(local_3.point_0, aim_2.is_met_0, descent_3, &(side_3), &(odds_2));
    if(!_S292)
    {
        return false;
    }
    var power_5 : f32 = light_power_at_0(descent_3.node_3, side_3);
    var _S293 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(chosen_instance_0);
    if(aim_2.is_met_0)
    {
        var _S294 : f32 = density_0(odds_2, aim_2.luminance_1, power_5, Transform_direction_0(_S293.grid_from_world_0, aim_2.direction_21) * vec3<f32>(aim_2.hit_6.t_0), side_3);
        (*sample_4).pdf_2 = _S294;
        return _S294 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_3, u_9.y * power_5);
    var _S295 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_24));
    var on_face_0 : vec3<f32> = point_of_face_0(_S295, side_3, u_9.z, u_9.w);
    var pdf_7 : f32 = density_0(odds_2, emitter_1.luminance_4, power_5, on_face_0 - local_3.point_0, side_3);
    if(pdf_7 < 0.0f)
    {
        return false;
    }
    var direction_27 : vec3<f32> = Transform_point_0(_S293.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S293.grid_from_world_0.translation_0), _S295, side_3, on_face_0)) - receiver_15.point_0;
    var cos_theta_5 : f32 = with_slack_0(receiver_15, divide_0(dot_product_0(receiver_15.normal_2, direction_27), square_root_0(length_squared_0(direction_27))));
    (*sample_4) = LightSample_x24init_0(Ray_x24init_0(receiver_15.point_0, 0.0f, direction_27, 1.0f), cos_theta_5, emitted_0(material_of_index_0(emitter_1.material_6)), pdf_7);
    return cos_theta_5 > 0.0f;
}

fn EmitterTree_sample_0( receiver_16 : Receiver_0,  u_10 : vec4<f32>,  aim_3 : Aim_0,  sample_5 : ptr<function, LightSample_0>) -> bool
{
    var _S296 : bool = sample_emitter_0(receiver_16, u_10, aim_3, &((*sample_5)));
    return _S296;
}

fn Lights_sample_0( receiver_17 : Receiver_0,  selection_3 : Selection_0,  u_11 : vec4<f32>,  aim_4 : Aim_0,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var is_found_9 : bool;
    if(has_sun_0())
    {
        is_found_9 = !aim_4.is_met_0;
    }
    else
    {
        is_found_9 = false;
    }
    if(is_found_9)
    {
        is_found_9 = (u_11.x) < (selection_3.sun_0);
    }
    else
    {
        is_found_9 = false;
    }
    if(is_found_9)
    {
        var _S297 : bool = SunDisc_sample_0(receiver_17, u_11, &((*sample_6)));
        (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sun_0;
        is_found_9 = _S297;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_9 = !aim_4.is_met_0;
        }
        else
        {
            is_found_9 = false;
        }
        if(is_found_9)
        {
            is_found_9 = (u_11.x) < (selection_3.sun_0 + selection_3.sky_1);
        }
        else
        {
            is_found_9 = false;
        }
        if(is_found_9)
        {
            var _S298 : bool = Sky_sample_0(receiver_17, vec4<f32>(min(divide_0(u_11.x - selection_3.sun_0, selection_3.sky_1), 0.99999994039535522f), u_11.yzw), &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sky_1;
            is_found_9 = _S298;
        }
        else
        {
            var _S299 : bool = EmitterTree_sample_0(receiver_17, vec4<f32>(min(divide_0(u_11.x - (selection_3.sun_0 + selection_3.sky_1), selection_3.emitters_0), 0.99999994039535522f), u_11.yzw), aim_4, &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.emitters_0;
            is_found_9 = _S299;
        }
    }
    return is_found_9;
}

fn ior_of_0( inside_3 : Inside_0) -> f32
{
    var _S300 : f32;
    if(Inside_is_in_0(inside_3))
    {
        _S300 = material_of_index_0(inside_3.material_0).ior_0;
    }
    else
    {
        _S300 = 1.0f;
    }
    return _S300;
}

fn Microfacets_x24init_0( alpha_1 : f32) -> Microfacets_0
{
    var _S301 : Microfacets_0;
    _S301.alpha_0 = alpha_1;
    return _S301;
}

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S302 : MaterialBsdf_0;
    _S302.kind_0 = kind_1;
    _S302.color_0 = color_2;
    _S302.specular_1 = specular_2;
    _S302.eta_0 = eta_1;
    _S302.facets_0 = facets_1;
    return _S302;
}

fn bsdf_of_0( material_8 : PackedMaterial_0,  ior_1 : f32,  choice_2 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_8.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn MaterialBsdf_albedo_0( this_42 : MaterialBsdf_0) -> vec3<f32>
{
    return this_42.color_0;
}

fn roulette_0( event_1 : u32,  scattered_1 : vec3<f32>,  u_12 : f32) -> f32
{
    if(event_1 < u32(3))
    {
        return 1.0f;
    }
    var _S303 : f32 = min(max_element_0(scattered_1), 0.94999998807907104f);
    var _S304 : f32;
    if(u_12 < _S303)
    {
        _S304 = divide_0(1.0f, _S303);
    }
    else
    {
        _S304 = 0.0f;
    }
    return _S304;
}

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
    var _S305 : f32;
    if(face_6 < u32(2))
    {
        _S305 = away_1;
    }
    else
    {
        _S305 = 0.0f;
    }
    var _S306 : bool;
    if(face_6 >= u32(2))
    {
        _S306 = face_6 < u32(4);
    }
    else
    {
        _S306 = false;
    }
    var _S307 : f32;
    if(_S306)
    {
        _S307 = away_1;
    }
    else
    {
        _S307 = 0.0f;
    }
    if(face_6 >= u32(4))
    {
    }
    else
    {
        away_1 = 0.0f;
    }
    return vec3<f32>(_S305, _S307, away_1);
}

fn world_normal_0( instance_14 : PackedInstance_0,  face_7 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_0(instance_14.world_from_grid_0, face_normal_0(face_7)));
}

fn surface_of_0( ray_15 : Ray_0,  hit_8 : Hit_0) -> Surface_0
{
    var surface_1 : Surface_0;
    var _S308 : vec3<f32> = vec3<f32>(hit_8.voxel_0);
    if(IS_SINGLE_0)
    {
        surface_1.origin_11 = offset_ray_origin_0(vec3<f32>(0.0f), _S308, hit_8.face_0, ray_15.origin_0 + ray_15.direction_0 * vec3<f32>(hit_8.t_0));
        surface_1.normal_3 = face_normal_0(hit_8.face_0);
    }
    else
    {
        var _S309 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(hit_8.instance_0);
        surface_1.origin_11 = Transform_point_0(_S309.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S309.grid_from_world_0.translation_0), _S308, hit_8.face_0, Transform_point_0(_S309.grid_from_world_0, ray_15.origin_0) + Transform_direction_0(_S309.grid_from_world_0, ray_15.direction_0) * vec3<f32>(hit_8.t_0)));
        surface_1.normal_3 = world_normal_0(_S309, hit_8.face_0);
    }
    surface_1.face_2 = hit_8.face_0;
    surface_1.instance_11 = hit_8.instance_0;
    return surface_1;
}

fn Surface_local_direction_0( this_43 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_43.instance_11).grid_from_world_0, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_4 : vec3<f32>;
    if((this_43.face_2) < u32(2))
    {
        local_4 = in_grid_2.yzx;
    }
    else
    {
        if((this_43.face_2) < u32(4))
        {
            local_4 = in_grid_2.zxy;
        }
        else
        {
            local_4 = in_grid_2;
        }
    }
    if((((this_43.face_2) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_4;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_4.xy, - local_4.z);
    }
    return in_grid_1;
}

fn clamp_to_voxel_0( translation_3 : vec3<f32>,  low_15 : vec3<f32>,  point_5 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_15);
    return min(max(point_5, low_15 + vec3<f32>(margin_1)), low_15 + vec3<f32>((1.0f - margin_1)));
}

fn Inside_point_0( this_44 : Inside_0,  ray_16 : Ray_0,  t_13 : f32) -> vec3<f32>
{
    var _S310 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(this_44.instance_6);
    return Transform_point_0(_S310.world_from_grid_0, clamp_to_voxel_0(vector_of_0(_S310.grid_from_world_0.translation_0), vec3<f32>(this_44.voxel_22), Transform_point_0(_S310.grid_from_world_0, ray_16.origin_0) + Transform_direction_0(_S310.grid_from_world_0, ray_16.direction_0) * vec3<f32>(t_13)));
}

fn MaterialBsdf_is_delta_0( this_45 : MaterialBsdf_0) -> bool
{
    return false;
}

fn Scatter_x24init_0( path_6 : Path_0,  receiver_18 : Receiver_0,  surface_2 : Surface_0,  bsdf_1 : MaterialBsdf_0,  wo_1 : vec3<f32>,  compensation_1 : f32,  is_scattered_1 : bool,  wants_light_1 : bool) -> Scatter_0
{
    var _S311 : Scatter_0;
    _S311.path_3 = path_6;
    _S311.receiver_0 = receiver_18;
    _S311.surface_0 = surface_2;
    _S311.bsdf_0 = bsdf_1;
    _S311.wo_0 = wo_1;
    _S311.compensation_0 = compensation_1;
    _S311.is_scattered_0 = is_scattered_1;
    _S311.wants_light_0 = wants_light_1;
    return _S311;
}

struct BsdfSample_0
{
     wi_0 : vec3<f32>,
     weight_3 : vec3<f32>,
     pdf_8 : f32,
     is_delta_0 : bool,
};

struct Diffuse_0
{
     reflectance_0 : vec3<f32>,
};

fn Diffuse_x24init_0( reflectance_1 : vec3<f32>) -> Diffuse_0
{
    var _S312 : Diffuse_0;
    _S312.reflectance_0 = reflectance_1;
    return _S312;
}

fn cosine_hemisphere_0( u_13 : f32,  v_7 : f32) -> vec3<f32>
{
    var radius_3 : f32 = square_root_0(u_13);
    var sin_cos_2 : vec2<f32> = sincos_turns_0(v_7);
    return vec3<f32>(radius_3 * sin_cos_2.y, radius_3 * sin_cos_2.x, square_root_0(1.0f - u_13));
}

fn cosine_hemisphere_pdf_0( cos_theta_6 : f32) -> f32
{
    return max(cos_theta_6, 0.0f) * 0.31830987334251404f;
}

fn BsdfSample_x24init_0( wi_1 : vec3<f32>,  weight_4 : vec3<f32>,  pdf_9 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S313 : BsdfSample_0;
    _S313.wi_0 = wi_1;
    _S313.weight_3 = weight_4;
    _S313.pdf_8 = pdf_9;
    _S313.is_delta_0 = is_delta_1;
    return _S313;
}

fn Diffuse_sample_0( this_46 : Diffuse_0,  wo_2 : vec3<f32>,  u_14 : vec3<f32>,  sample_7 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_2 : vec3<f32> = cosine_hemisphere_0(u_14.x, u_14.y);
    (*sample_7) = BsdfSample_x24init_0(wi_2, this_46.reflectance_0, cosine_hemisphere_pdf_0(wi_2.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_47 : MaterialBsdf_0,  wo_3 : vec3<f32>,  u_15 : vec3<f32>,  sample_8 : ptr<function, BsdfSample_0>) -> bool
{
    var _S314 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_47.color_0), wo_3, u_15, &((*sample_8)));
    return _S314;
}

fn Surface_world_direction_0( this_48 : Surface_0,  local_5 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_48.face_2) & (u32(1)))) == u32(1))
    {
        away_2 = local_5.z;
    }
    else
    {
        away_2 = - local_5.z;
    }
    var _S315 : f32 = local_5.x;
    var _S316 : f32 = local_5.y;
    var _S317 : vec3<f32> = vec3<f32>(_S315, _S316, away_2);
    var in_grid_3 : vec3<f32>;
    if((this_48.face_2) < u32(2))
    {
        in_grid_3 = vec3<f32>(away_2, _S315, _S316);
    }
    else
    {
        if((this_48.face_2) < u32(4))
        {
            in_grid_3 = vec3<f32>(_S316, away_2, _S315);
        }
        else
        {
            in_grid_3 = _S317;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_3 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_48.instance_11).world_from_grid_0, in_grid_3);
    }
    return normalize_vector_0(in_grid_3);
}

fn PathTracingOf_advance_0( path_7 : ptr<function, Path_0>,  ray_17 : Ray_0,  hit_9 : Hit_0,  beyond_3 : u32,  radiance_5 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_0 : NextRays_0 = no_rays_0();
    scatter_of_path_0.wants_light_0 = false;
    var is_counted_0 : bool = Path_is_counted_0((*path_7));
    var t_14 : f32;
    if(is_counted_0)
    {
        t_14 = - (*path_7).pdf_1;
    }
    else
    {
        t_14 = (*path_7).pdf_1;
    }
    (*path_7).pdf_1 = t_14;
    var last_5 : Receiver_0 = Path_receiver_0((*path_7), ray_17);
    var is_scattered_2 : bool;
    if(Inside_is_in_0((*path_7).inside_0))
    {
        is_scattered_2 = Hit_is_miss_0(hit_9);
    }
    else
    {
        is_scattered_2 = false;
    }
    if(Inside_is_in_0((*path_7).inside_0))
    {
        if(is_scattered_2)
        {
            t_14 = scattering_t_0((*path_7), (*path_7).inside_0, ray_17);
        }
        else
        {
            t_14 = hit_9.t_0;
        }
        if(!is_counted_0)
        {
            absorb_0(&((*path_7)), (*path_7).inside_0, ray_17, t_14);
        }
    }
    else
    {
        t_14 = hit_9.t_0;
    }
    var is_weighed_0 : bool;
    if(Hit_is_miss_0(hit_9))
    {
        is_weighed_0 = !is_scattered_2;
    }
    else
    {
        is_weighed_0 = false;
    }
    var light_pdf_1 : f32;
    if(is_weighed_0)
    {
        (*radiance_5) = (*radiance_5) + (*path_7).beta_0 * Sky_le_0(ray_17.direction_0) * vec3<f32>(mis_weight_0((*path_7).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_7), last_5), ray_17.direction_0)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_2 = true;
            }
            else
            {
                is_scattered_2 = !Path_is_straight_0((*path_7));
            }
        }
        else
        {
            is_scattered_2 = false;
        }
        if(is_scattered_2)
        {
            var le_0 : vec3<f32> = SunDisc_le_0(ray_17.direction_0);
            if((max_element_0(le_0)) > 0.0f)
            {
                if(((*path_7).pdf_1) == 0.0f)
                {
                    light_pdf_1 = 0.0f;
                }
                else
                {
                    light_pdf_1 = Lights_sun_pdf_0(Path_selection_at_0((*path_7), last_5), ray_17.direction_0);
                }
                (*radiance_5) = (*radiance_5) + (*path_7).beta_0 * le_0 * vec3<f32>(mis_weight_0((*path_7).pdf_1, light_pdf_1));
            }
        }
        return next_0;
    }
    var u_16 : vec4<f32> = Sampler_stratified_0((*path_7).sampler_0, Path_dimension_scatter_0((*path_7)));
    var material_9 : PackedMaterial_0 = material_met_0((*path_7), hit_9, beyond_3);
    var _S318 : vec3<f32> = vec3<f32>(0.0f);
    var le_1 : vec3<f32>;
    if(!is_counted_0)
    {
        le_1 = EmitterTree_le_0(material_9);
    }
    else
    {
        le_1 = _S318;
    }
    var is_lit_0 : bool = (max_element_0(le_1)) > 0.0f;
    var met_0 : Aim_0 = Aim_x24init_0(true, ray_17.direction_0, hit_9, luminance_0(vector_of_0(material_9.emission_0)));
    var _S319 : bool = weighs_apart_0();
    if(_S319)
    {
        is_weighed_0 = is_lit_0;
    }
    else
    {
        is_weighed_0 = false;
    }
    if(is_weighed_0)
    {
        is_weighed_0 = ((*path_7).pdf_1) > 0.0f;
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
        var light_5 : LightSample_0 = no_light_0();
        if(!_S319)
        {
            is_chosen_0 = ((*path_7).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_0 = false;
        }
        if(is_chosen_0)
        {
            var _S320 : bool = Lights_sample_0(last_5, Path_selection_at_0((*path_7), last_5), vec4<f32>(0.0f), met_0, &(light_5));
            is_chosen_0 = _S320;
        }
        else
        {
            is_chosen_0 = false;
        }
        var _S321 : vec3<f32> = (*path_7).beta_0 * le_1;
        var _S322 : f32 = (*path_7).pdf_1;
        if(is_chosen_0)
        {
            light_pdf_1 = light_5.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + _S321 * vec3<f32>(mis_weight_0(_S322, light_pdf_1));
    }
    var _S323 : f32 = ior_of_0((*path_7).inside_0);
    var _S324 : f32 = u_16[i32(3)];
    var _S325 : MaterialBsdf_0 = bsdf_of_0(material_9, _S323, &(_S324));
    u_16[i32(3)] = _S324;
    var scattered_2 : vec3<f32> = (*path_7).beta_0 * MaterialBsdf_albedo_0(_S325);
    if(((*path_7).bounce_0) >= (params_0.max_bounces_0))
    {
        is_chosen_0 = true;
    }
    else
    {
        is_chosen_0 = ends_here_0;
    }
    var _S326 : bool = !is_weighed_0;
    if(_S326)
    {
        if(is_chosen_0)
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
        return next_0;
    }
    var compensation_2 : f32 = roulette_0(Path_events_0((*path_7)), scattered_2, u_16.z);
    if(_S326)
    {
        is_chosen_0 = compensation_2 == 0.0f;
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
    if(is_scattered_2)
    {
        at_6 = Hit_x24init_0(t_14, (*path_7).inside_0.instance_6, hit_9.voxel_0, u32(0));
    }
    else
    {
        at_6 = hit_9;
    }
    var surface_3 : Surface_0 = surface_of_0(ray_17, at_6);
    var _S327 : Receiver_0 = Receiver_x24init_0(surface_3.origin_11, surface_3.normal_3);
    var _S328 : vec3<f32> = (vec3<f32>(0) - ray_17.direction_0);
    var wo_4 : vec3<f32> = Surface_local_direction_0(surface_3, _S328);
    var inside_4 : Inside_0 = in_air_0();
    var wo_5 : vec3<f32>;
    var receiver_19 : Receiver_0;
    if(is_scattered_2)
    {
        var _S329 : Inside_0 = Inside_x24init_0((*path_7).inside_0.instance_6, hit_9.voxel_0, (*path_7).inside_0.material_0);
        inside_4 = _S329;
        var _S330 : vec3<f32> = normalize_vector_0(_S328);
        receiver_19 = Receiver_x24init_0(Inside_point_0(_S329, ray_17, t_14), _S318);
        wo_5 = _S330;
    }
    else
    {
        if(Inside_is_in_0((*path_7).inside_0))
        {
            next_0.relocates_1 = (hit_9.instance_0) != ((*path_7).inside_0.instance_6);
            inside_4 = Inside_x24init_0((*path_7).inside_0.instance_6, hit_9.voxel_0, (*path_7).inside_0.material_0);
            inside_4.voxel_22 = hit_9.voxel_0 + vec3<i32>(face_normal_0(hit_9.face_0));
        }
        receiver_19 = _S327;
        wo_5 = wo_4;
    }
    next_0.origin_9 = receiver_19.point_0;
    next_0.shadow_inside_1 = inside_4;
    if(is_weighed_0)
    {
        receiver_19 = last_5;
    }
    if(_S326)
    {
        (*path_7).selection_0 = Lights_selection_0(receiver_19);
    }
    var light_6 : LightSample_0 = no_light_0();
    var _S331 : bool = !MaterialBsdf_is_delta_0(_S325);
    scatter_of_path_0 = Scatter_x24init_0((*path_7), receiver_19, surface_3, _S325, wo_5, compensation_2, is_scattered_2, _S331);
    if(is_weighed_0)
    {
        if(next_0.has_shadow_ray_0)
        {
            light_pdf_1 = light_6.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + (*path_7).beta_0 * le_1 * vec3<f32>(mis_weight_0((*path_7).pdf_1, light_pdf_1));
        (*path_7).pdf_1 = - (*path_7).pdf_1;
        next_0.is_same_0 = true;
        return next_0;
    }
    var bounce_1 : BsdfSample_0;
    var _S332 : bool = MaterialBsdf_sample_0(_S325, wo_5, vec3<f32>(u_16.xy, u_16.w), &(bounce_1));
    if(!_S332)
    {
        return next_0;
    }
    (*path_7).beta_0 = (*path_7).beta_0 * bounce_1.weight_3 * vec3<f32>(compensation_2);
    if(bounce_1.is_delta_0)
    {
        t_14 = 0.0f;
    }
    else
    {
        t_14 = bounce_1.pdf_8;
    }
    (*path_7).pdf_1 = t_14;
    (*path_7).normal_0 = receiver_19.normal_2;
    next_0.direction_5 = bounce_1.wi_0;
    if(!is_scattered_2)
    {
        next_0.direction_5 = Surface_world_direction_0(surface_3, bounce_1.wi_0);
    }
    next_0.path_relocates_1 = next_0.relocates_1;
    (*path_7).bounce_0 = (*path_7).bounce_0 + u32(1);
    return next_0;
}

fn is_mover_0( instance_15 : u32) -> bool
{
    var _S333 : bool;
    if(instance_15 < (real_time_0.motions_0))
    {
        _S333 = (motions_1[u32(4) * instance_15 + u32(3)].x) != 0.0f;
    }
    else
    {
        _S333 = false;
    }
    return _S333;
}

fn shading_normal_0( ray_18 : Ray_0,  hit_10 : Hit_0,  material_10 : PackedMaterial_0) -> vec3<f32>
{
    return world_normal_0(Instances_operatorx5Bx5D_get_0(hit_10.instance_0), hit_10.face_0);
}

fn normal_steps_0( normal_5 : vec3<f32>) -> vec3<f32>
{
    return floor(clamp(normal_5, vec3<f32>(-1.0f), vec3<f32>(1.0f)) * vec3<f32>(511.0f) + vec3<f32>(0.50099998712539673f));
}

fn in_ten_bits_0( normal_6 : vec3<f32>) -> vec3<f32>
{
    return normal_steps_0(normal_6) * vec3<f32>(0.00195694714784622f);
}

fn albedo_of_0( material_11 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_11.base_color_0);
}

fn show_0( path_8 : Path_0,  ray_19 : Ray_0,  hit_11 : Hit_0,  beyond_4 : u32,  is_lit_1 : bool,  sample_9 : ptr<function, Sample_0>)
{
    var _S334 : Path_0 = path_8;
    (*sample_9).is_shown_0 = true;
    if(Inside_is_in_0(_S334.inside_0))
    {
        absorb_0(&(_S334), _S334.inside_0, ray_19, hit_11.t_0);
    }
    var material_12 : PackedMaterial_0 = material_met_0(_S334, hit_11, beyond_4);
    (*sample_9).normal_1 = in_ten_bits_0(shading_normal_0(ray_19, hit_11, material_12));
    var _S335 : vec3<f32> = _S334.beta_0;
    var _S336 : vec3<f32>;
    if(!is_lit_1)
    {
        _S336 = albedo_of_0(material_12);
    }
    else
    {
        _S336 = vec3<f32>(1.0f);
    }
    (*sample_9).albedo_0 = _S335 * _S336;
    return;
}

fn Walker_see_0( this_49 : ptr<function, Walker_0>,  arrived_0 : Path_0,  hit_12 : Hit_0,  beyond_5 : u32,  emitted_1 : vec3<f32>,  goes_on_0 : bool,  sample_10 : ptr<function, Sample_0>)
{
    var is_lit_2 : bool;
    if((*this_49).by_chance_0)
    {
        is_lit_2 = (max_element_0(emitted_1)) > 0.0f;
    }
    else
    {
        is_lit_2 = false;
    }
    if(is_lit_2)
    {
        (*sample_10).light_1 = (*sample_10).light_1 + emitted_1;
    }
    else
    {
        (*sample_10).direct_0 = (*sample_10).direct_0 + emitted_1;
    }
    var _S337 : bool;
    if((*this_49).sees_mover_0)
    {
        _S337 = true;
    }
    else
    {
        if(!Hit_is_miss_0(hit_12))
        {
            _S337 = is_mover_0(hit_12.instance_0);
        }
        else
        {
            _S337 = false;
        }
    }
    (*this_49).sees_mover_0 = _S337;
    var _S338 : bool = ((*this_49).path_0.bounce_0) == u32(0);
    if(goes_on_0)
    {
        _S337 = _S338;
    }
    else
    {
        _S337 = false;
    }
    var _S339 : bool = !_S337;
    (*this_49).has_shown_0 = _S339;
    if(!_S339)
    {
        if((*this_49).by_chance_0)
        {
            is_lit_2 = true;
        }
        else
        {
            if((any((((*this_49).path_0.normal_0) != vec3<f32>(0.0f)))))
            {
                if(Inside_is_in_0(arrived_0.inside_0))
                {
                    is_lit_2 = true;
                }
                else
                {
                    is_lit_2 = (material_met_0(arrived_0, hit_12, beyond_5).metallic_0) < 1.0f;
                }
            }
            else
            {
                is_lit_2 = false;
            }
        }
        (*this_49).by_chance_0 = is_lit_2;
        (*this_49).way_3 = (*this_49).way_3 + hit_12.t_0;
    }
    else
    {
        var _S340 : u32;
        if(!Hit_is_miss_0(hit_12))
        {
            show_0(arrived_0, (*this_49).ray_7, hit_12, beyond_5, is_lit_2, &((*sample_10)));
            (*sample_10).place_0 = (*this_49).camera_ray_0.origin_0 + (*this_49).camera_ray_0.direction_0 * vec3<f32>(((*this_49).way_3 + hit_12.t_0));
            if(((*this_49).way_3) > 0.0f)
            {
                if((*this_49).sees_mover_0)
                {
                    _S340 = u32(4294967295);
                }
                else
                {
                    _S340 = u32(4294967294);
                }
            }
            else
            {
                _S340 = hit_12.instance_0;
            }
            (*sample_10).instance_7 = _S340;
        }
        else
        {
            (*sample_10).albedo_0 = vec3<f32>(0.0f);
            if((*this_49).sees_mover_0)
            {
                _S340 = u32(4294967295);
            }
            else
            {
                _S340 = u32(4294967294);
            }
            (*sample_10).instance_7 = _S340;
            if(is_lit_2)
            {
                (*sample_10).is_shown_0 = true;
                (*sample_10).albedo_0 = arrived_0.beta_0;
                (*sample_10).normal_1 = in_ten_bits_0(normalize_vector_0((vec3<f32>(0) - (*this_49).camera_ray_0.direction_0)));
                (*sample_10).place_0 = (*this_49).camera_ray_0.origin_0 + (*this_49).camera_ray_0.direction_0 * vec3<f32>((*this_49).way_3);
            }
        }
    }
    return;
}

var<private> first_candidates_0 : u32;

fn Path_dimension_light_0( this_50 : Path_0) -> u32
{
    return u32(2) + u32(2) * Path_events_0(this_50);
}

struct BsdfEval_0
{
     weight_5 : vec3<f32>,
     pdf_10 : f32,
};

fn BsdfEval_x24init_0( weight_6 : vec3<f32>,  pdf_11 : f32) -> BsdfEval_0
{
    var _S341 : BsdfEval_0;
    _S341.weight_5 = weight_6;
    _S341.pdf_10 = pdf_11;
    return _S341;
}

fn Diffuse_eval_0( this_51 : Diffuse_0,  wo_6 : vec3<f32>,  wi_3 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_51.reflectance_0, cosine_hemisphere_pdf_0(wi_3.z));
}

fn MaterialBsdf_eval_0( this_52 : MaterialBsdf_0,  wo_7 : vec3<f32>,  wi_4 : vec3<f32>) -> BsdfEval_0
{
    return Diffuse_eval_0(Diffuse_x24init_0(this_52.color_0), wo_7, wi_4);
}

var<private> weighs_candidates_0 : bool;

fn cube_of_0( point_6 : vec3<f32>,  size_squared_0 : f32,  smaller_0 : i32,  power_6 : ptr<function, i32>) -> vec3<i32>
{
    var _S342 : i32 = clamp((((i32(((bitcast<u32>((size_squared_0))) >> (u32(23)))) - i32(127)) >> (u32(1)))) - smaller_0, i32(-64), i32(64));
    (*power_6) = _S342;
    return vec3<i32>(clamp(floor(point_6 * vec3<f32>((bitcast<f32>(((u32(i32(127) - _S342) << (u32(23)))))))), vec3<f32>(-1.0e+09f), vec3<f32>(1.0e+09f)));
}

fn place_of_ray_0( ray_20 : Ray_0) -> u32
{
    var size_2 : f32 = real_time_0.view_angle_0 * 0.30000001192092896f;
    var power_7 : i32;
    var begin_0 : vec3<i32> = cube_of_0(ray_20.origin_0, length_squared_0(ray_20.origin_0 - real_time_0.eye_0) * (size_2 * size_2), i32(0), &(power_7));
    var hash_2 : vec4<u32> = pcg4d_0(vec4<u32>(vec3<u32>(begin_0), u32(power_7)));
    var _S343 : vec3<i32> = vec3<i32>(floor(ray_20.direction_0 * vec3<f32>(4.0f)));
    power_7 = i32(128);
    var end_2 : vec3<i32>;
    if((ray_20.t_max_0) <= 1.0f)
    {
        var _S344 : vec3<i32> = cube_of_0(ray_20.origin_0 + ray_20.direction_0, length_squared_0(ray_20.direction_0), i32(1), &(power_7));
        end_2 = _S344;
    }
    else
    {
        end_2 = _S343;
    }
    return ((pcg4d_0((vec4<u32>(vec3<u32>(end_2), u32(power_7)) ^ (hash_2))).x) & (u32(131071)));
}

fn place_of_known_0( place_5 : u32) -> u32
{
    return u32(786448) + place_5;
}

fn visibility_0( ray_21 : Ray_0) -> f32
{
    var known_2 : u32 = atomicLoad(&(cell_keys_0[place_of_known_0(place_of_ray_0(ray_21))]));
    return square_root_0(divide_0(f32((known_2 >> (u32(16)))) + 0.5f, f32((known_2 & (u32(65535)))) + 1.0f));
}

fn choose_light_0( scatter_0 : Scatter_0,  next_1 : ptr<function, NextRays_0>)
{
    var count_5 : u32;
    if((scatter_0.path_3.bounce_0) == u32(0))
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
        var dimension_3 : u32 = u32(1073741824) + u32(64) * Path_events_0(scatter_0.path_3) + u32(2) * candidate_0;
        var u_17 : vec4<f32>;
        var _S345 : vec4<f32>;
        if(candidate_0 == u32(0))
        {
            _S345 = Sampler_stratified_0(scatter_0.path_3.sampler_0, Path_dimension_light_0(scatter_0.path_3));
        }
        else
        {
            _S345 = Sampler_independent_0(scatter_0.path_3.sampler_0, dimension_3);
        }
        u_17 = _S345;
        var _S346 : bool = count_5 > u32(1);
        if(_S346)
        {
            u_17[i32(0)] = min((f32(candidate_0) + u_17.x) * divide_0(1.0f, f32(count_5)), 0.99999994039535522f);
        }
        var light_7 : LightSample_0 = no_light_0();
        var is_found_10 : bool = Lights_sample_0(scatter_0.receiver_0, scatter_0.path_3.selection_0, u_17, by_chance_1(), &(light_7));
        if(!is_found_10)
        {
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var _S347 : vec3<f32> = vec3<f32>(Surface_local_direction_0(scatter_0.surface_0, light_7.ray_13.direction_0).xy, light_7.cos_theta_1);
        var wi_5 : vec3<f32>;
        if(scatter_0.is_scattered_0)
        {
            wi_5 = normalize_vector_0(light_7.ray_13.direction_0);
        }
        else
        {
            wi_5 = _S347;
        }
        var eval_0 : BsdfEval_0 = MaterialBsdf_eval_0(scatter_0.bsdf_0, scatter_0.wo_0, wi_5);
        var _S348 : vec3<f32> = scatter_0.path_3.beta_0 * eval_0.weight_5 * vec3<f32>(scatter_0.compensation_0) * light_7.radiance_1 * vec3<f32>((divide_0(eval_0.pdf_10, light_7.pdf_2) * power_heuristic_0(light_7.pdf_2, eval_0.pdf_10)));
        var weight_7 : f32 = luminance_0(_S348);
        var _S349 : bool;
        if(weighs_candidates_0)
        {
            _S349 = _S346;
        }
        else
        {
            _S349 = false;
        }
        var weight_8 : f32;
        if(_S349)
        {
            var _S350 : f32 = visibility_0(light_7.ray_13);
            weight_8 = weight_7 * _S350;
        }
        else
        {
            weight_8 = weight_7;
        }
        var sum_5 : f32 = sum_4 + weight_8;
        var _S351 : bool;
        if(_S346)
        {
            _S351 = (Sampler_independent_0(scatter_0.path_3.sampler_0, dimension_3 + u32(1)).x * sum_5) >= weight_8;
        }
        else
        {
            _S351 = false;
        }
        if(_S351)
        {
            sum_4 = sum_5;
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var chosen_5 : f32;
        if(weight_8 > 0.0f)
        {
            (*next_1).shadow_direction_0 = light_7.ray_13.direction_0;
            (*next_1).shadow_t_max_0 = light_7.ray_13.t_max_0;
            (*next_1).light_2 = _S348;
            chosen_5 = weight_8;
        }
        else
        {
            chosen_5 = chosen_4;
        }
        chosen_4 = chosen_5;
        sum_4 = sum_5;
        candidate_0 = candidate_0 + u32(1);
    }
    var _S352 : bool = chosen_4 > 0.0f;
    (*next_1).has_shadow_ray_0 = _S352;
    if(_S352)
    {
        (*next_1).light_2 = (*next_1).light_2 * vec3<f32>(divide_0(sum_4, chosen_4 * f32(count_5)));
    }
    return;
}

var<private> counts_arrivals_0 : bool;

fn goes_on_from_0( at_7 : ptr<function, Walker_0>,  hit_13 : Hit_0,  beyond_6 : u32,  sample_11 : ptr<function, Sample_0>) -> bool
{
    var next_2 : NextRays_0 = no_rays_0();
    var _S353 : bool = (*at_7).is_at_cell_0;
    var goes_on_1 : bool;
    if((*at_7).is_at_cell_0)
    {
        next_2.origin_9 = (*at_7).ray_7.origin_0;
        next_2.path_origin_1 = (*at_7).ray_7.origin_0;
        next_2.direction_5 = (*at_7).ray_7.direction_0;
        goes_on_1 = true;
    }
    else
    {
        var _S354 : vec3<f32> = vec3<f32>(0.0f);
        var cached_0 : vec3<f32> = _S354;
        if((*at_7).has_shown_0)
        {
            goes_on_1 = (*at_7).asks_cache_0;
        }
        else
        {
            goes_on_1 = false;
        }
        if(goes_on_1)
        {
            var _S355 : bool = asks_0((*at_7).path_0, (*at_7).ray_7, hit_13, beyond_6, (*at_7).life_0, &(cached_0));
            goes_on_1 = _S355;
        }
        else
        {
            goes_on_1 = false;
        }
        ends_here_0 = goes_on_1;
        var arrived_1 : Path_0 = (*at_7).path_0;
        var emitted_2 : vec3<f32> = _S354;
        var _S356 : Path_0 = (*at_7).path_0;
        var _S357 : NextRays_0 = PathTracingOf_advance_0(&(_S356), (*at_7).ray_7, hit_13, beyond_6, &(emitted_2));
        (*at_7).path_0 = _S356;
        next_2 = _S357;
        var goes_on_2 : bool = (any(((next_2.direction_5) != _S354)));
        if((*at_7).has_shown_0)
        {
            (*sample_11).light_1 = (*sample_11).light_1 + (cached_0 + emitted_2);
        }
        else
        {
            Walker_see_0(&((*at_7)), arrived_1, hit_13, beyond_6, emitted_2, goes_on_2, &((*sample_11)));
        }
        goes_on_1 = goes_on_2;
    }
    if(scatter_of_path_0.wants_light_0)
    {
        choose_light_0(scatter_of_path_0, &(next_2));
    }
    if(!_S353)
    {
        var _S358 : bool;
        if(counts_arrivals_0)
        {
            _S358 = next_2.has_shadow_ray_0;
        }
        else
        {
            _S358 = false;
        }
        if(_S358)
        {
            _S358 = (Path_events_0(scatter_of_path_0.path_3)) == u32(0);
        }
        else
        {
            _S358 = false;
        }
        if(_S358)
        {
            _S358 = !scatter_of_path_0.is_scattered_0;
        }
        else
        {
            _S358 = false;
        }
        if(_S358)
        {
            _S358 = !Inside_is_in_0(scatter_of_path_0.path_3.inside_0);
        }
        else
        {
            _S358 = false;
        }
        (*at_7).counts_0 = _S358;
    }
    if(_S353)
    {
        (*at_7).path_0.bounce_0 = u32(1);
        (*at_7).path_0.event_0 = u32(1);
        (*at_7).path_0.scattered_0 = u32(1);
        (*at_7).is_at_cell_0 = false;
    }
    (*at_7).direction_4 = next_2.direction_5;
    (*at_7).light_0 = next_2.light_2;
    (*at_7).is_shadow_ray_0 = next_2.has_shadow_ray_0;
    (*at_7).path_origin_0 = next_2.path_origin_1;
    (*at_7).ray_7 = ray_from_0(next_2.origin_9, next_2.direction_5);
    if((*at_7).is_shadow_ray_0)
    {
        (*at_7).ray_7 = Ray_x24init_0(next_2.origin_9, 0.0f, next_2.shadow_direction_0, next_2.shadow_t_max_0);
    }
    if(goes_on_1)
    {
        goes_on_1 = true;
    }
    else
    {
        goes_on_1 = (*at_7).is_shadow_ray_0;
    }
    return goes_on_1;
}

fn key_of_1( hit_14 : Hit_0,  size_3 : f32,  u_18 : f32,  code_3 : ptr<function, u32>) -> Key_0
{
    var clamped_1 : f32 = clamp(size_3, 1.0f, 128.0f);
    var power_8 : f32 = f32(((bitcast<u32>((clamped_1))) >> (u32(23)))) - 127.0f;
    var _S359 : f32;
    if(u_18 < (clamped_1 * inverse_power_of_two_0(clamped_1) - 1.0f))
    {
        _S359 = 1.0f;
    }
    else
    {
        _S359 = 0.0f;
    }
    var level_1 : u32 = u32(min(power_8 + _S359, 6.0f));
    var _S360 : vec3<u32> = vec3<u32>(u32(i32(level_1)));
    var key_3 : Key_0 = Key_x24init_0(hit_14.instance_0, ((hit_14.face_0) | (((level_1 << (u32(3)))))), ((hit_14.voxel_0) >> (_S360)));
    var _S361 : vec3<u32> = vec3<u32>(hit_14.voxel_0 - (((key_3.cube_0) << (_S360))));
    (*code_3) = u32(1) + (((((((_S361.x) | ((((_S361.y) << (level_1)))))) | ((((_S361.z) << ((u32(2) * level_1))))))) ^ ((((scramble_of_0(real_time_0.number_0)) & ((Key_mask_0(key_3))))))));
    return key_3;
}

fn asks_1( path_9 : Path_0,  ray_22 : Ray_0,  hit_15 : Hit_0,  beyond_7 : u32,  life_2 : u32,  light_8 : ptr<function, vec3<f32>>) -> bool
{
    (*light_8) = vec3<f32>(0.0f);
    var _S362 : bool;
    if(Hit_is_miss_0(hit_15))
    {
        _S362 = true;
    }
    else
    {
        _S362 = Inside_is_in_0(path_9.inside_0);
    }
    if(_S362)
    {
        return false;
    }
    var material_13 : PackedMaterial_0 = material_met_0(path_9, hit_15, beyond_7);
    if((material_13.metallic_0) > 0.0f)
    {
        _S362 = true;
    }
    else
    {
        _S362 = (material_13.transmission_0) > 0.0f;
    }
    if(_S362)
    {
        return false;
    }
    var code_4 : u32;
    var key_4 : Key_0 = key_of_1(hit_15, square_root_0(length_squared_0(ray_22.origin_0 + ray_22.direction_0 * vec3<f32>(hit_15.t_0) - real_time_0.eye_0)) * real_time_0.view_angle_0 * 0.05882352963089943f, Sampler_independent_0(path_9.sampler_0, u32(3221225472) + Path_events_0(path_9)).x, &(code_4));
    var _S363 : f32 = f32((u32(1) << ((Key_level_0(key_4)))));
    var is_from_first_1 : bool = (path_9.bounce_0) < u32(2);
    if(life_2 == u32(0))
    {
        _S362 = true;
    }
    else
    {
        if(is_from_first_1)
        {
            _S362 = (hit_15.t_0 * square_root_0(length_squared_0(ray_22.direction_0))) < _S363;
        }
        else
        {
            _S362 = false;
        }
    }
    if(_S362)
    {
        return false;
    }
    var known_3 : vec4<f32> = ask_cell_0(key_4, ((((min(life_2, u32(10))) << (u32(20)))) | (code_4)));
    if((known_3.w) <= 0.0f)
    {
        return false;
    }
    (*light_8) = path_9.beta_0 * vector_of_0(material_13.base_color_0) * known_3.xyz;
    return true;
}

fn absorb_1( path_10 : ptr<function, Path_0>,  inside_5 : Inside_0,  ray_23 : Ray_0,  t_15 : f32)
{
    (*path_10).beta_0 = (*path_10).beta_0 * attenuation_0(material_of_index_0(inside_5.material_0), t_15 * Inside_voxels_per_t_0(inside_5, ray_23));
    return;
}

fn SunDisc_sample_1( receiver_20 : Receiver_0,  u_19 : vec4<f32>,  sample_12 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_1 : f32 = u_19.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_4 : f32 = square_root_0(one_minus_cos_theta_1 * (2.0f - one_minus_cos_theta_1));
    var sin_cos_3 : vec2<f32> = sincos_turns_0(u_19.w);
    var direction_28 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_1)) + (params_0.sun_tangent_0 * vec3<f32>((radius_4 * sin_cos_3.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_4 * sin_cos_3.x)));
    var cos_theta_7 : f32 = with_slack_0(receiver_20, dot_product_0(receiver_20.normal_2, direction_28));
    (*sample_12) = LightSample_x24init_0(ray_from_0(receiver_20.point_0, direction_28), cos_theta_7, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_7 > 0.0f;
}

fn Environment_choose_1( u_20 : vec4<f32>,  chosen_6 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S364 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_6) = ChosenDirection_x24init_0(_S364, _S364, 0.0f);
    var edge_1 : f32 = f32(params_0.sky_edge_0);
    var _S365 : f32 = u_20.x * edge_1;
    var _S366 : f32 = edge_1 - 1.0f;
    var _S367 : f32 = min(floor(_S365), _S366);
    var own_3 : u32 = u32(_S367) * params_0.sky_edge_0 + u32(min(floor(u_20.y * edge_1), _S366));
    var index_28 : u32;
    if((u_20.z) < (environment_0[own_3].threshold_0))
    {
        index_28 = own_3;
    }
    else
    {
        index_28 = environment_0[own_3].alias_0;
    }
    var pdf_12 : f32 = environment_0[index_28].pdf_0;
    if((environment_0[index_28].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S368 : u32 = index_28 % params_0.sky_edge_0;
    var _S369 : f32 = f32(_S368);
    var _S370 : u32 = index_28 / params_0.sky_edge_0;
    var place_6 : vec2<f32> = vec2<f32>(_S369, f32(_S370)) + vec2<f32>(min(_S365 - _S367, 1.0f), u_20.w);
    (*chosen_6) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_6 * vec2<f32>(divide_0(1.0f, edge_1)))), Environment_radiance_at_0(place_6), pdf_12);
    return true;
}

fn Sky_sample_1( receiver_21 : Receiver_0,  u_21 : vec4<f32>,  sample_13 : ptr<function, LightSample_0>) -> bool
{
    (*sample_13) = no_light_0();
    var chosen_7 : ChosenDirection_0;
    var _S371 : bool;
    if(SKY_0 != u32(1))
    {
        _S371 = true;
    }
    else
    {
        var _S372 : bool = Environment_choose_1(u_21, &(chosen_7));
        _S371 = !_S372;
    }
    if(_S371)
    {
        return false;
    }
    var cos_theta_8 : f32 = with_slack_0(receiver_21, dot_product_0(receiver_21.normal_2, chosen_7.direction_25));
    (*sample_13) = LightSample_x24init_0(ray_from_0(receiver_21.point_0, chosen_7.direction_25), cos_theta_8, chosen_7.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_7.pdf_4);
    return cos_theta_8 > 0.0f;
}

fn Descent_at_2( this_53 : ptr<function, Descent_0>,  root_4 : u32)
{
    var node_11 : LightNode_0 = TopLights_node_0(root_4);
    (*this_53).node_3 = root_4;
    (*this_53).index_15 = node_11.index_11;
    (*this_53).count_2 = node_11.count_1;
    (*this_53).is_far_3 = false;
    return;
}

fn climb_1( receiver_22 : Receiver_0,  start_4 : u32,  descent_4 : ptr<function, Descent_0>) -> bool
{
    var node_12 : LightNode_0 = top_light_node_0(start_4);
    var at_8 : u32 = start_4;
    for(;;)
    {
        var _S373 : LightNode_0 = node_12;
        if((node_12.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_2 : LightNode_0 = top_light_node_0(_S373.parent_0);
        var _S374 : u32 = _S373.parent_0 + u32(1);
        var is_left_4 : bool = at_8 == _S374;
        var _S375 : u32;
        if(is_left_4)
        {
            _S375 = parent_2.index_11;
        }
        else
        {
            _S375 = _S374;
        }
        var own_4 : View_0 = view_0(node_12, receiver_22);
        var other_3 : View_0 = view_0(top_light_node_0(_S375), receiver_22);
        var weights_3 : vec2<f32>;
        if(is_left_4)
        {
            weights_3 = weights_of_views_0(own_4, other_3);
        }
        else
        {
            weights_3 = weights_of_views_0(other_3, own_4);
        }
        var _S376 : f32 = weights_3.x;
        var _S377 : f32 = weights_3.y;
        var total_6 : f32 = _S376 + _S377;
        if(!(total_6 > 0.0f))
        {
            return false;
        }
        var _S378 : f32;
        if(is_left_4)
        {
            _S378 = _S376;
        }
        else
        {
            _S378 = _S377;
        }
        (*descent_4).weight_0 = (*descent_4).weight_0 * _S378;
        (*descent_4).total_0 = (*descent_4).total_0 * total_6;
        node_12 = parent_2;
        at_8 = _S373.parent_0;
    }
    return ((*descent_4).weight_0) > 0.0f;
}

fn descend_2( receiver_23 : Receiver_0,  aim_5 : Aim_0,  descent_5 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S379 : bool;
        if(((*descent_5).count_2) == u32(0))
        {
            _S379 = !(*descent_5).is_far_3;
        }
        else
        {
            _S379 = false;
        }
        if(_S379)
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
        var left_5 : LightNode_0 = TopLights_node_0((*descent_5).node_3 + u32(1));
        var right_4 : LightNode_0 = TopLights_node_0((*descent_5).index_15);
        var weights_4 : vec2<f32> = weights_of_views_0(view_0(left_5, receiver_23), view_0(right_4, receiver_23));
        var _S380 : f32 = weights_4.x;
        var _S381 : f32 = weights_4.y;
        var total_7 : f32 = _S380 + _S381;
        if(!(total_7 > 0.0f))
        {
            return false;
        }
        var _S382 : bool;
        if(_S381 <= 0.0f)
        {
            _S382 = true;
        }
        else
        {
            _S382 = ((*descent_5).choice_0 * total_7) < (_S380 * (*descent_5).weight_0);
        }
        var is_left_5 : bool;
        if(aim_5.is_met_0)
        {
            var _S383 : vec3<f32> = vec3<f32>(aim_5.hit_6.voxel_0);
            if((all((_S383 >= (vector_of_0(left_5.min_1))))))
            {
                is_left_5 = (all((_S383 < (vector_of_0(left_5.max_1)))));
            }
            else
            {
                is_left_5 = false;
            }
        }
        else
        {
            is_left_5 = _S382;
        }
        var _S384 : f32 = (*descent_5).choice_0 * total_7;
        var _S385 : f32;
        if(is_left_5)
        {
            _S385 = 0.0f;
        }
        else
        {
            _S385 = _S380 * (*descent_5).weight_0;
        }
        (*descent_5).choice_0 = _S384 - _S385;
        var _S386 : u32;
        if(is_left_5)
        {
            _S386 = (*descent_5).node_3 + u32(1);
        }
        else
        {
            _S386 = (*descent_5).index_15;
        }
        (*descent_5).node_3 = _S386;
        var _S387 : u32;
        if(is_left_5)
        {
            _S387 = left_5.index_11;
        }
        else
        {
            _S387 = right_4.index_11;
        }
        (*descent_5).index_15 = _S387;
        var _S388 : u32;
        if(is_left_5)
        {
            _S388 = left_5.count_1;
        }
        else
        {
            _S388 = right_4.count_1;
        }
        (*descent_5).count_2 = _S388;
        (*descent_5).is_far_3 = false;
        var _S389 : f32;
        if(is_left_5)
        {
            _S389 = _S380;
        }
        else
        {
            _S389 = _S381;
        }
        var _S390 : f32 = (*descent_5).weight_0 * _S389;
        (*descent_5).weight_0 = _S390;
        (*descent_5).total_0 = (*descent_5).total_0 * total_7;
        if(_S390 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Descent_at_3( this_54 : ptr<function, Descent_0>,  root_5 : u32)
{
    var node_13 : LightNode_0 = GridLights_node_0(root_5);
    (*this_54).node_3 = root_5;
    (*this_54).index_15 = node_13.index_11;
    (*this_54).count_2 = node_13.count_1;
    (*this_54).is_far_3 = false;
    return;
}

fn descend_3( receiver_24 : Receiver_0,  aim_6 : Aim_0,  descent_6 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S391 : bool;
        if(((*descent_6).count_2) == u32(0))
        {
            _S391 = !(*descent_6).is_far_3;
        }
        else
        {
            _S391 = false;
        }
        if(_S391)
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
        var left_6 : LightNode_0 = GridLights_node_0((*descent_6).node_3 + u32(1));
        var right_5 : LightNode_0 = GridLights_node_0((*descent_6).index_15);
        var of_left_1 : View_0 = view_0(left_6, receiver_24);
        var of_right_1 : View_0 = view_0(right_5, receiver_24);
        var weights_5 : vec2<f32> = weights_of_views_0(of_left_1, of_right_1);
        var _S392 : f32 = weights_5.x;
        var _S393 : f32 = weights_5.y;
        var total_8 : f32 = _S392 + _S393;
        if(!(total_8 > 0.0f))
        {
            return false;
        }
        var _S394 : bool;
        if(_S393 <= 0.0f)
        {
            _S394 = true;
        }
        else
        {
            _S394 = ((*descent_6).choice_0 * total_8) < (_S392 * (*descent_6).weight_0);
        }
        var is_left_6 : bool;
        if(aim_6.is_met_0)
        {
            var _S395 : vec3<f32> = vec3<f32>(aim_6.hit_6.voxel_0);
            if((all((_S395 >= (vector_of_0(left_6.min_1))))))
            {
                is_left_6 = (all((_S395 < (vector_of_0(left_6.max_1)))));
            }
            else
            {
                is_left_6 = false;
            }
        }
        else
        {
            is_left_6 = _S394;
        }
        var _S396 : f32 = (*descent_6).choice_0 * total_8;
        var _S397 : f32;
        if(is_left_6)
        {
            _S397 = 0.0f;
        }
        else
        {
            _S397 = _S392 * (*descent_6).weight_0;
        }
        (*descent_6).choice_0 = _S396 - _S397;
        var _S398 : u32;
        if(is_left_6)
        {
            _S398 = (*descent_6).node_3 + u32(1);
        }
        else
        {
            _S398 = (*descent_6).index_15;
        }
        (*descent_6).node_3 = _S398;
        var _S399 : u32;
        if(is_left_6)
        {
            _S399 = left_6.index_11;
        }
        else
        {
            _S399 = right_5.index_11;
        }
        (*descent_6).index_15 = _S399;
        var _S400 : u32;
        if(is_left_6)
        {
            _S400 = left_6.count_1;
        }
        else
        {
            _S400 = right_5.count_1;
        }
        (*descent_6).count_2 = _S400;
        var _S401 : bool;
        if(is_left_6)
        {
            _S401 = of_left_1.is_far_0;
        }
        else
        {
            _S401 = of_right_1.is_far_0;
        }
        (*descent_6).is_far_3 = _S401;
        var _S402 : f32;
        if(is_left_6)
        {
            _S402 = _S392;
        }
        else
        {
            _S402 = _S393;
        }
        var _S403 : f32 = (*descent_6).weight_0 * _S402;
        (*descent_6).weight_0 = _S403;
        (*descent_6).total_0 = (*descent_6).total_0 * total_8;
        if(_S403 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_1( point_7 : vec3<f32>,  is_met_3 : bool,  way_6 : Descent_0,  side_4 : ptr<function, u32>,  odds_3 : ptr<function, vec2<f32>>) -> bool
{
    var sent_1 : BySide_0 = sent_by_side_0(light_node_at_0(way_6.node_3), point_7);
    var sum_6 : f32 = normal_or_zero_0(BySide_sum_0(sent_1));
    var unit_3 : f32 = inverse_power_of_two_0(sum_6);
    var total_9 : f32 = sum_6 * unit_3;
    var _S404 : f32 = way_6.choice_0 * total_9;
    var _S405 : u32 = (*side_4);
    var share_8 : f32 = normal_or_zero_0(sent_1.low_10[u32(0)] * unit_3);
    var _S406 : bool;
    if(is_met_3)
    {
        _S406 = u32(0) == _S405;
    }
    else
    {
        _S406 = share_8 > 0.0f;
    }
    var chosen_8 : f32;
    if(_S406)
    {
        (*side_4) = u32(0);
        chosen_8 = share_8;
    }
    else
    {
        chosen_8 = 0.0f;
    }
    var _S407 : bool = _S404 < (share_8 * way_6.weight_0);
    var share_9 : f32 = normal_or_zero_0(sent_1.high_4[u32(0)] * unit_3);
    if(is_met_3)
    {
        _S406 = u32(1) == _S405;
    }
    else
    {
        if(share_9 > 0.0f)
        {
            _S406 = !_S407;
        }
        else
        {
            _S406 = false;
        }
    }
    if(_S406)
    {
        (*side_4) = u32(1);
        chosen_8 = share_9;
    }
    var passed_4 : f32 = share_8 + share_9;
    if(_S407)
    {
        _S406 = true;
    }
    else
    {
        _S406 = _S404 < (passed_4 * way_6.weight_0);
    }
    var share_10 : f32 = normal_or_zero_0(sent_1.low_10[u32(1)] * unit_3);
    var _S408 : bool;
    if(is_met_3)
    {
        _S408 = u32(2) == _S405;
    }
    else
    {
        if(share_10 > 0.0f)
        {
            _S408 = !_S406;
        }
        else
        {
            _S408 = false;
        }
    }
    if(_S408)
    {
        (*side_4) = u32(2);
        chosen_8 = share_10;
    }
    var passed_5 : f32 = passed_4 + share_10;
    if(_S406)
    {
        _S406 = true;
    }
    else
    {
        _S406 = _S404 < (passed_5 * way_6.weight_0);
    }
    var share_11 : f32 = normal_or_zero_0(sent_1.high_4[u32(1)] * unit_3);
    if(is_met_3)
    {
        _S408 = u32(3) == _S405;
    }
    else
    {
        if(share_11 > 0.0f)
        {
            _S408 = !_S406;
        }
        else
        {
            _S408 = false;
        }
    }
    if(_S408)
    {
        (*side_4) = u32(3);
        chosen_8 = share_11;
    }
    var passed_6 : f32 = passed_5 + share_11;
    if(_S406)
    {
        _S406 = true;
    }
    else
    {
        _S406 = _S404 < (passed_6 * way_6.weight_0);
    }
    var share_12 : f32 = normal_or_zero_0(sent_1.low_10[u32(2)] * unit_3);
    if(is_met_3)
    {
        _S408 = u32(4) == _S405;
    }
    else
    {
        if(share_12 > 0.0f)
        {
            _S408 = !_S406;
        }
        else
        {
            _S408 = false;
        }
    }
    if(_S408)
    {
        (*side_4) = u32(4);
        chosen_8 = share_12;
    }
    var passed_7 : f32 = passed_6 + share_12;
    if(_S406)
    {
        _S406 = true;
    }
    else
    {
        _S406 = _S404 < (passed_7 * way_6.weight_0);
    }
    var share_13 : f32 = normal_or_zero_0(sent_1.high_4[u32(2)] * unit_3);
    if(is_met_3)
    {
        _S406 = u32(5) == _S405;
    }
    else
    {
        if(share_13 > 0.0f)
        {
            _S406 = !_S406;
        }
        else
        {
            _S406 = false;
        }
    }
    if(_S406)
    {
        (*side_4) = u32(5);
        chosen_8 = share_13;
    }
    (*odds_3) = vec2<f32>(way_6.weight_0 * chosen_8, way_6.total_0 * total_9);
    if(sum_6 > 0.0f)
    {
        _S406 = ((*odds_3).x) > 0.0f;
    }
    else
    {
        _S406 = false;
    }
    return _S406;
}

fn sample_emitter_1( receiver_25 : Receiver_0,  u_22 : vec4<f32>,  aim_7 : Aim_0,  sample_14 : ptr<function, LightSample_0>) -> bool
{
    (*sample_14) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_7 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_22.x, false);
    Descent_at_2(&(descent_7), u32(0));
    var _S409 : bool;
    if(!IS_SINGLE_0)
    {
        _S409 = aim_7.is_met_0;
    }
    else
    {
        _S409 = false;
    }
    if(_S409)
    {
        var _S410 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(aim_7.hit_6.instance_0);
        if((_S410.light_leaf_0) == u32(4294967295))
        {
            _S409 = true;
        }
        else
        {
            var _S411 : bool = climb_1(receiver_25, _S410.light_leaf_0, &(descent_7));
            _S409 = !_S411;
        }
        if(_S409)
        {
            return false;
        }
        Descent_at_2(&(descent_7), _S410.light_leaf_0);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S412 : bool = descend_2(receiver_25, by_chance_1(), &(descent_7));
            _S409 = !_S412;
        }
        else
        {
            _S409 = false;
        }
        if(_S409)
        {
            return false;
        }
    }
    var chosen_instance_1 : u32 = descent_7.index_15;
    var local_6 : Receiver_0 = in_grid_0(descent_7.index_15, receiver_25);
    Descent_at_3(&(descent_7), top_light_node_0(descent_7.node_3).root_1);
    var _S413 : bool = descend_3(local_6, aim_7, &(descent_7));
    if(!_S413)
    {
        return false;
    }
    var side_5 : u32 = aim_7.hit_6.face_0;
    var odds_4 : vec2<f32>;
    var _S414 : bool = choose_side_1(local_6.point_0, aim_7.is_met_0, descent_7, &(side_5), &(odds_4));
    if(!_S414)
    {
        return false;
    }
    var power_9 : f32 = light_power_at_0(descent_7.node_3, side_5);
    var _S415 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(chosen_instance_1);
    if(aim_7.is_met_0)
    {
        var _S416 : f32 = density_0(odds_4, aim_7.luminance_1, power_9, Transform_direction_0(_S415.grid_from_world_0, aim_7.direction_21) * vec3<f32>(aim_7.hit_6.t_0), side_5);
        (*sample_14).pdf_2 = _S416;
        return _S416 > 0.0f;
    }
    var emitter_2 : Emitter_0 = choose_emitter_0(descent_7, side_5, u_22.y * power_9);
    var _S417 : vec3<f32> = vec3<f32>(cell_of_0(emitter_2.voxel_24));
    var on_face_1 : vec3<f32> = point_of_face_0(_S417, side_5, u_22.z, u_22.w);
    var pdf_13 : f32 = density_0(odds_4, emitter_2.luminance_4, power_9, on_face_1 - local_6.point_0, side_5);
    if(pdf_13 < 0.0f)
    {
        return false;
    }
    var direction_29 : vec3<f32> = Transform_point_0(_S415.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S415.grid_from_world_0.translation_0), _S417, side_5, on_face_1)) - receiver_25.point_0;
    var cos_theta_9 : f32 = with_slack_0(receiver_25, divide_0(dot_product_0(receiver_25.normal_2, direction_29), square_root_0(length_squared_0(direction_29))));
    (*sample_14) = LightSample_x24init_0(Ray_x24init_0(receiver_25.point_0, 0.0f, direction_29, 1.0f), cos_theta_9, emitted_0(material_of_index_0(emitter_2.material_6)), pdf_13);
    return cos_theta_9 > 0.0f;
}

fn EmitterTree_sample_1( receiver_26 : Receiver_0,  u_23 : vec4<f32>,  aim_8 : Aim_0,  sample_15 : ptr<function, LightSample_0>) -> bool
{
    var _S418 : bool = sample_emitter_1(receiver_26, u_23, aim_8, &((*sample_15)));
    return _S418;
}

fn Lights_sample_1( receiver_27 : Receiver_0,  selection_4 : Selection_0,  u_24 : vec4<f32>,  aim_9 : Aim_0,  sample_16 : ptr<function, LightSample_0>) -> bool
{
    var is_found_11 : bool;
    if(has_sun_0())
    {
        is_found_11 = !aim_9.is_met_0;
    }
    else
    {
        is_found_11 = false;
    }
    if(is_found_11)
    {
        is_found_11 = (u_24.x) < (selection_4.sun_0);
    }
    else
    {
        is_found_11 = false;
    }
    if(is_found_11)
    {
        var _S419 : bool = SunDisc_sample_1(receiver_27, u_24, &((*sample_16)));
        (*sample_16).pdf_2 = (*sample_16).pdf_2 * selection_4.sun_0;
        is_found_11 = _S419;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_11 = !aim_9.is_met_0;
        }
        else
        {
            is_found_11 = false;
        }
        if(is_found_11)
        {
            is_found_11 = (u_24.x) < (selection_4.sun_0 + selection_4.sky_1);
        }
        else
        {
            is_found_11 = false;
        }
        if(is_found_11)
        {
            var _S420 : bool = Sky_sample_1(receiver_27, vec4<f32>(min(divide_0(u_24.x - selection_4.sun_0, selection_4.sky_1), 0.99999994039535522f), u_24.yzw), &((*sample_16)));
            (*sample_16).pdf_2 = (*sample_16).pdf_2 * selection_4.sky_1;
            is_found_11 = _S420;
        }
        else
        {
            var _S421 : bool = EmitterTree_sample_1(receiver_27, vec4<f32>(min(divide_0(u_24.x - (selection_4.sun_0 + selection_4.sky_1), selection_4.emitters_0), 0.99999994039535522f), u_24.yzw), aim_9, &((*sample_16)));
            (*sample_16).pdf_2 = (*sample_16).pdf_2 * selection_4.emitters_0;
            is_found_11 = _S421;
        }
    }
    return is_found_11;
}

fn bsdf_of_1( material_14 : PackedMaterial_0,  ior_2 : f32,  choice_3 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_14.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn Diffuse_sample_1( this_55 : Diffuse_0,  wo_8 : vec3<f32>,  u_25 : vec3<f32>,  sample_17 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_6 : vec3<f32> = cosine_hemisphere_0(u_25.x, u_25.y);
    (*sample_17) = BsdfSample_x24init_0(wi_6, this_55.reflectance_0, cosine_hemisphere_pdf_0(wi_6.z), false);
    return true;
}

fn MaterialBsdf_sample_1( this_56 : MaterialBsdf_0,  wo_9 : vec3<f32>,  u_26 : vec3<f32>,  sample_18 : ptr<function, BsdfSample_0>) -> bool
{
    var _S422 : bool = Diffuse_sample_1(Diffuse_x24init_0(this_56.color_0), wo_9, u_26, &((*sample_18)));
    return _S422;
}

fn PathTracingOf_advance_1( path_11 : ptr<function, Path_0>,  ray_24 : Ray_0,  hit_16 : Hit_0,  beyond_8 : u32,  radiance_6 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_3 : NextRays_0 = no_rays_0();
    scatter_of_path_0.wants_light_0 = false;
    var is_counted_1 : bool = Path_is_counted_0((*path_11));
    var t_16 : f32;
    if(is_counted_1)
    {
        t_16 = - (*path_11).pdf_1;
    }
    else
    {
        t_16 = (*path_11).pdf_1;
    }
    (*path_11).pdf_1 = t_16;
    var last_6 : Receiver_0 = Path_receiver_0((*path_11), ray_24);
    var is_scattered_3 : bool;
    if(Inside_is_in_0((*path_11).inside_0))
    {
        is_scattered_3 = Hit_is_miss_0(hit_16);
    }
    else
    {
        is_scattered_3 = false;
    }
    if(Inside_is_in_0((*path_11).inside_0))
    {
        if(is_scattered_3)
        {
            t_16 = scattering_t_0((*path_11), (*path_11).inside_0, ray_24);
        }
        else
        {
            t_16 = hit_16.t_0;
        }
        if(!is_counted_1)
        {
            absorb_1(&((*path_11)), (*path_11).inside_0, ray_24, t_16);
        }
    }
    else
    {
        t_16 = hit_16.t_0;
    }
    var is_weighed_1 : bool;
    if(Hit_is_miss_0(hit_16))
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
        (*radiance_6) = (*radiance_6) + (*path_11).beta_0 * Sky_le_0(ray_24.direction_0) * vec3<f32>(mis_weight_0((*path_11).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_11), last_6), ray_24.direction_0)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_3 = true;
            }
            else
            {
                is_scattered_3 = !Path_is_straight_0((*path_11));
            }
        }
        else
        {
            is_scattered_3 = false;
        }
        if(is_scattered_3)
        {
            var le_2 : vec3<f32> = SunDisc_le_0(ray_24.direction_0);
            if((max_element_0(le_2)) > 0.0f)
            {
                if(((*path_11).pdf_1) == 0.0f)
                {
                    light_pdf_2 = 0.0f;
                }
                else
                {
                    light_pdf_2 = Lights_sun_pdf_0(Path_selection_at_0((*path_11), last_6), ray_24.direction_0);
                }
                (*radiance_6) = (*radiance_6) + (*path_11).beta_0 * le_2 * vec3<f32>(mis_weight_0((*path_11).pdf_1, light_pdf_2));
            }
        }
        return next_3;
    }
    var u_27 : vec4<f32> = Sampler_stratified_0((*path_11).sampler_0, Path_dimension_scatter_0((*path_11)));
    var material_15 : PackedMaterial_0 = material_met_0((*path_11), hit_16, beyond_8);
    var _S423 : vec3<f32> = vec3<f32>(0.0f);
    var le_3 : vec3<f32>;
    if(!is_counted_1)
    {
        le_3 = EmitterTree_le_0(material_15);
    }
    else
    {
        le_3 = _S423;
    }
    var is_lit_3 : bool = (max_element_0(le_3)) > 0.0f;
    var met_1 : Aim_0 = Aim_x24init_0(true, ray_24.direction_0, hit_16, luminance_0(vector_of_0(material_15.emission_0)));
    var _S424 : bool = weighs_apart_0();
    if(_S424)
    {
        is_weighed_1 = is_lit_3;
    }
    else
    {
        is_weighed_1 = false;
    }
    if(is_weighed_1)
    {
        is_weighed_1 = ((*path_11).pdf_1) > 0.0f;
    }
    else
    {
        is_weighed_1 = false;
    }
    var is_chosen_1 : bool;
    if(is_lit_3)
    {
        is_chosen_1 = !is_weighed_1;
    }
    else
    {
        is_chosen_1 = false;
    }
    if(is_chosen_1)
    {
        var light_9 : LightSample_0 = no_light_0();
        if(!_S424)
        {
            is_chosen_1 = ((*path_11).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_1 = false;
        }
        if(is_chosen_1)
        {
            var _S425 : bool = Lights_sample_1(last_6, Path_selection_at_0((*path_11), last_6), vec4<f32>(0.0f), met_1, &(light_9));
            is_chosen_1 = _S425;
        }
        else
        {
            is_chosen_1 = false;
        }
        var _S426 : vec3<f32> = (*path_11).beta_0 * le_3;
        var _S427 : f32 = (*path_11).pdf_1;
        if(is_chosen_1)
        {
            light_pdf_2 = light_9.pdf_2;
        }
        else
        {
            light_pdf_2 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + _S426 * vec3<f32>(mis_weight_0(_S427, light_pdf_2));
    }
    var _S428 : f32 = ior_of_0((*path_11).inside_0);
    var _S429 : f32 = u_27[i32(3)];
    var _S430 : MaterialBsdf_0 = bsdf_of_1(material_15, _S428, &(_S429));
    u_27[i32(3)] = _S429;
    var scattered_3 : vec3<f32> = (*path_11).beta_0 * MaterialBsdf_albedo_0(_S430);
    if(((*path_11).bounce_0) >= (params_0.max_bounces_0))
    {
        is_chosen_1 = true;
    }
    else
    {
        is_chosen_1 = ends_here_0;
    }
    var _S431 : bool = !is_weighed_1;
    if(_S431)
    {
        if(is_chosen_1)
        {
            is_chosen_1 = true;
        }
        else
        {
            is_chosen_1 = (max_element_0(scattered_3)) <= 0.0f;
        }
    }
    else
    {
        is_chosen_1 = false;
    }
    if(is_chosen_1)
    {
        return next_3;
    }
    var compensation_3 : f32 = roulette_0(Path_events_0((*path_11)), scattered_3, u_27.z);
    if(_S431)
    {
        is_chosen_1 = compensation_3 == 0.0f;
    }
    else
    {
        is_chosen_1 = false;
    }
    if(is_chosen_1)
    {
        return next_3;
    }
    var at_9 : Hit_0;
    if(is_scattered_3)
    {
        at_9 = Hit_x24init_0(t_16, (*path_11).inside_0.instance_6, hit_16.voxel_0, u32(0));
    }
    else
    {
        at_9 = hit_16;
    }
    var surface_4 : Surface_0 = surface_of_0(ray_24, at_9);
    var _S432 : Receiver_0 = Receiver_x24init_0(surface_4.origin_11, surface_4.normal_3);
    var _S433 : vec3<f32> = (vec3<f32>(0) - ray_24.direction_0);
    var wo_10 : vec3<f32> = Surface_local_direction_0(surface_4, _S433);
    var inside_6 : Inside_0 = in_air_0();
    var wo_11 : vec3<f32>;
    var receiver_28 : Receiver_0;
    if(is_scattered_3)
    {
        var _S434 : Inside_0 = Inside_x24init_0((*path_11).inside_0.instance_6, hit_16.voxel_0, (*path_11).inside_0.material_0);
        inside_6 = _S434;
        var _S435 : vec3<f32> = normalize_vector_0(_S433);
        receiver_28 = Receiver_x24init_0(Inside_point_0(_S434, ray_24, t_16), _S423);
        wo_11 = _S435;
    }
    else
    {
        if(Inside_is_in_0((*path_11).inside_0))
        {
            next_3.relocates_1 = (hit_16.instance_0) != ((*path_11).inside_0.instance_6);
            inside_6 = Inside_x24init_0((*path_11).inside_0.instance_6, hit_16.voxel_0, (*path_11).inside_0.material_0);
            inside_6.voxel_22 = hit_16.voxel_0 + vec3<i32>(face_normal_0(hit_16.face_0));
        }
        receiver_28 = _S432;
        wo_11 = wo_10;
    }
    next_3.origin_9 = receiver_28.point_0;
    next_3.shadow_inside_1 = inside_6;
    if(is_weighed_1)
    {
        receiver_28 = last_6;
    }
    if(_S431)
    {
        (*path_11).selection_0 = Lights_selection_0(receiver_28);
    }
    var light_10 : LightSample_0 = no_light_0();
    var _S436 : bool = !MaterialBsdf_is_delta_0(_S430);
    scatter_of_path_0 = Scatter_x24init_0((*path_11), receiver_28, surface_4, _S430, wo_11, compensation_3, is_scattered_3, _S436);
    if(is_weighed_1)
    {
        if(next_3.has_shadow_ray_0)
        {
            light_pdf_2 = light_10.pdf_2;
        }
        else
        {
            light_pdf_2 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + (*path_11).beta_0 * le_3 * vec3<f32>(mis_weight_0((*path_11).pdf_1, light_pdf_2));
        (*path_11).pdf_1 = - (*path_11).pdf_1;
        next_3.is_same_0 = true;
        return next_3;
    }
    var bounce_2 : BsdfSample_0;
    var _S437 : bool = MaterialBsdf_sample_1(_S430, wo_11, vec3<f32>(u_27.xy, u_27.w), &(bounce_2));
    if(!_S437)
    {
        return next_3;
    }
    (*path_11).beta_0 = (*path_11).beta_0 * bounce_2.weight_3 * vec3<f32>(compensation_3);
    if(bounce_2.is_delta_0)
    {
        t_16 = 0.0f;
    }
    else
    {
        t_16 = bounce_2.pdf_8;
    }
    (*path_11).pdf_1 = t_16;
    (*path_11).normal_0 = receiver_28.normal_2;
    next_3.direction_5 = bounce_2.wi_0;
    if(!is_scattered_3)
    {
        next_3.direction_5 = Surface_world_direction_0(surface_4, bounce_2.wi_0);
    }
    next_3.path_relocates_1 = next_3.relocates_1;
    (*path_11).bounce_0 = (*path_11).bounce_0 + u32(1);
    return next_3;
}

fn show_1( path_12 : Path_0,  ray_25 : Ray_0,  hit_17 : Hit_0,  beyond_9 : u32,  is_lit_4 : bool,  sample_19 : ptr<function, Sample_0>)
{
    var _S438 : Path_0 = path_12;
    (*sample_19).is_shown_0 = true;
    if(Inside_is_in_0(_S438.inside_0))
    {
        absorb_1(&(_S438), _S438.inside_0, ray_25, hit_17.t_0);
    }
    var material_16 : PackedMaterial_0 = material_met_0(_S438, hit_17, beyond_9);
    (*sample_19).normal_1 = in_ten_bits_0(shading_normal_0(ray_25, hit_17, material_16));
    var _S439 : vec3<f32> = _S438.beta_0;
    var _S440 : vec3<f32>;
    if(!is_lit_4)
    {
        _S440 = albedo_of_0(material_16);
    }
    else
    {
        _S440 = vec3<f32>(1.0f);
    }
    (*sample_19).albedo_0 = _S439 * _S440;
    return;
}

fn Walker_see_1( this_57 : ptr<function, Walker_0>,  arrived_2 : Path_0,  hit_18 : Hit_0,  beyond_10 : u32,  emitted_3 : vec3<f32>,  goes_on_3 : bool,  sample_20 : ptr<function, Sample_0>)
{
    var is_lit_5 : bool;
    if((*this_57).by_chance_0)
    {
        is_lit_5 = (max_element_0(emitted_3)) > 0.0f;
    }
    else
    {
        is_lit_5 = false;
    }
    if(is_lit_5)
    {
        (*sample_20).light_1 = (*sample_20).light_1 + emitted_3;
    }
    else
    {
        (*sample_20).direct_0 = (*sample_20).direct_0 + emitted_3;
    }
    var _S441 : bool;
    if((*this_57).sees_mover_0)
    {
        _S441 = true;
    }
    else
    {
        if(!Hit_is_miss_0(hit_18))
        {
            _S441 = is_mover_0(hit_18.instance_0);
        }
        else
        {
            _S441 = false;
        }
    }
    (*this_57).sees_mover_0 = _S441;
    var _S442 : bool = ((*this_57).path_0.bounce_0) == u32(0);
    if(goes_on_3)
    {
        _S441 = _S442;
    }
    else
    {
        _S441 = false;
    }
    var _S443 : bool = !_S441;
    (*this_57).has_shown_0 = _S443;
    if(!_S443)
    {
        if((*this_57).by_chance_0)
        {
            is_lit_5 = true;
        }
        else
        {
            if((any((((*this_57).path_0.normal_0) != vec3<f32>(0.0f)))))
            {
                if(Inside_is_in_0(arrived_2.inside_0))
                {
                    is_lit_5 = true;
                }
                else
                {
                    is_lit_5 = (material_met_0(arrived_2, hit_18, beyond_10).metallic_0) < 1.0f;
                }
            }
            else
            {
                is_lit_5 = false;
            }
        }
        (*this_57).by_chance_0 = is_lit_5;
        (*this_57).way_3 = (*this_57).way_3 + hit_18.t_0;
    }
    else
    {
        var _S444 : u32;
        if(!Hit_is_miss_0(hit_18))
        {
            show_1(arrived_2, (*this_57).ray_7, hit_18, beyond_10, is_lit_5, &((*sample_20)));
            (*sample_20).place_0 = (*this_57).camera_ray_0.origin_0 + (*this_57).camera_ray_0.direction_0 * vec3<f32>(((*this_57).way_3 + hit_18.t_0));
            if(((*this_57).way_3) > 0.0f)
            {
                if((*this_57).sees_mover_0)
                {
                    _S444 = u32(4294967295);
                }
                else
                {
                    _S444 = u32(4294967294);
                }
            }
            else
            {
                _S444 = hit_18.instance_0;
            }
            (*sample_20).instance_7 = _S444;
        }
        else
        {
            (*sample_20).albedo_0 = vec3<f32>(0.0f);
            if((*this_57).sees_mover_0)
            {
                _S444 = u32(4294967295);
            }
            else
            {
                _S444 = u32(4294967294);
            }
            (*sample_20).instance_7 = _S444;
            if(is_lit_5)
            {
                (*sample_20).is_shown_0 = true;
                (*sample_20).albedo_0 = arrived_2.beta_0;
                (*sample_20).normal_1 = in_ten_bits_0(normalize_vector_0((vec3<f32>(0) - (*this_57).camera_ray_0.direction_0)));
                (*sample_20).place_0 = (*this_57).camera_ray_0.origin_0 + (*this_57).camera_ray_0.direction_0 * vec3<f32>((*this_57).way_3);
            }
        }
    }
    return;
}

fn choose_light_1( scatter_1 : Scatter_0,  next_4 : ptr<function, NextRays_0>)
{
    var count_6 : u32;
    if((scatter_1.path_3.bounce_0) == u32(0))
    {
        count_6 = first_candidates_0;
    }
    else
    {
        count_6 = u32(1);
    }
    var chosen_9 : f32 = 0.0f;
    var candidate_1 : u32 = u32(0);
    var sum_7 : f32 = 0.0f;
    for(;;)
    {
        if(candidate_1 < count_6)
        {
        }
        else
        {
            break;
        }
        var dimension_4 : u32 = u32(1073741824) + u32(64) * Path_events_0(scatter_1.path_3) + u32(2) * candidate_1;
        var u_28 : vec4<f32>;
        var _S445 : vec4<f32>;
        if(candidate_1 == u32(0))
        {
            _S445 = Sampler_stratified_0(scatter_1.path_3.sampler_0, Path_dimension_light_0(scatter_1.path_3));
        }
        else
        {
            _S445 = Sampler_independent_0(scatter_1.path_3.sampler_0, dimension_4);
        }
        u_28 = _S445;
        var _S446 : bool = count_6 > u32(1);
        if(_S446)
        {
            u_28[i32(0)] = min((f32(candidate_1) + u_28.x) * divide_0(1.0f, f32(count_6)), 0.99999994039535522f);
        }
        var light_11 : LightSample_0 = no_light_0();
        var is_found_12 : bool = Lights_sample_1(scatter_1.receiver_0, scatter_1.path_3.selection_0, u_28, by_chance_1(), &(light_11));
        if(!is_found_12)
        {
            candidate_1 = candidate_1 + u32(1);
            continue;
        }
        var _S447 : vec3<f32> = vec3<f32>(Surface_local_direction_0(scatter_1.surface_0, light_11.ray_13.direction_0).xy, light_11.cos_theta_1);
        var wi_7 : vec3<f32>;
        if(scatter_1.is_scattered_0)
        {
            wi_7 = normalize_vector_0(light_11.ray_13.direction_0);
        }
        else
        {
            wi_7 = _S447;
        }
        var eval_1 : BsdfEval_0 = MaterialBsdf_eval_0(scatter_1.bsdf_0, scatter_1.wo_0, wi_7);
        var _S448 : vec3<f32> = scatter_1.path_3.beta_0 * eval_1.weight_5 * vec3<f32>(scatter_1.compensation_0) * light_11.radiance_1 * vec3<f32>((divide_0(eval_1.pdf_10, light_11.pdf_2) * power_heuristic_0(light_11.pdf_2, eval_1.pdf_10)));
        var weight_9 : f32 = luminance_0(_S448);
        var _S449 : bool;
        if(weighs_candidates_0)
        {
            _S449 = _S446;
        }
        else
        {
            _S449 = false;
        }
        var weight_10 : f32;
        if(_S449)
        {
            var _S450 : f32 = visibility_0(light_11.ray_13);
            weight_10 = weight_9 * _S450;
        }
        else
        {
            weight_10 = weight_9;
        }
        var sum_8 : f32 = sum_7 + weight_10;
        var _S451 : bool;
        if(_S446)
        {
            _S451 = (Sampler_independent_0(scatter_1.path_3.sampler_0, dimension_4 + u32(1)).x * sum_8) >= weight_10;
        }
        else
        {
            _S451 = false;
        }
        if(_S451)
        {
            sum_7 = sum_8;
            candidate_1 = candidate_1 + u32(1);
            continue;
        }
        var chosen_10 : f32;
        if(weight_10 > 0.0f)
        {
            (*next_4).shadow_direction_0 = light_11.ray_13.direction_0;
            (*next_4).shadow_t_max_0 = light_11.ray_13.t_max_0;
            (*next_4).light_2 = _S448;
            chosen_10 = weight_10;
        }
        else
        {
            chosen_10 = chosen_9;
        }
        chosen_9 = chosen_10;
        sum_7 = sum_8;
        candidate_1 = candidate_1 + u32(1);
    }
    var _S452 : bool = chosen_9 > 0.0f;
    (*next_4).has_shadow_ray_0 = _S452;
    if(_S452)
    {
        (*next_4).light_2 = (*next_4).light_2 * vec3<f32>(divide_0(sum_7, chosen_9 * f32(count_6)));
    }
    return;
}

fn goes_on_from_1( at_10 : ptr<function, Walker_0>,  hit_19 : Hit_0,  beyond_11 : u32,  sample_21 : ptr<function, Sample_0>) -> bool
{
    var next_5 : NextRays_0 = no_rays_0();
    var _S453 : bool = (*at_10).is_at_cell_0;
    var goes_on_4 : bool;
    if((*at_10).is_at_cell_0)
    {
        next_5.origin_9 = (*at_10).ray_7.origin_0;
        next_5.path_origin_1 = (*at_10).ray_7.origin_0;
        next_5.direction_5 = (*at_10).ray_7.direction_0;
        goes_on_4 = true;
    }
    else
    {
        var _S454 : vec3<f32> = vec3<f32>(0.0f);
        var cached_1 : vec3<f32> = _S454;
        if((*at_10).has_shown_0)
        {
            goes_on_4 = (*at_10).asks_cache_0;
        }
        else
        {
            goes_on_4 = false;
        }
        if(goes_on_4)
        {
            var _S455 : bool = asks_1((*at_10).path_0, (*at_10).ray_7, hit_19, beyond_11, (*at_10).life_0, &(cached_1));
            goes_on_4 = _S455;
        }
        else
        {
            goes_on_4 = false;
        }
        ends_here_0 = goes_on_4;
        var arrived_3 : Path_0 = (*at_10).path_0;
        var emitted_4 : vec3<f32> = _S454;
        var _S456 : Path_0 = (*at_10).path_0;
        var _S457 : NextRays_0 = PathTracingOf_advance_1(&(_S456), (*at_10).ray_7, hit_19, beyond_11, &(emitted_4));
        (*at_10).path_0 = _S456;
        next_5 = _S457;
        var goes_on_5 : bool = (any(((next_5.direction_5) != _S454)));
        if((*at_10).has_shown_0)
        {
            (*sample_21).light_1 = (*sample_21).light_1 + (cached_1 + emitted_4);
        }
        else
        {
            Walker_see_1(&((*at_10)), arrived_3, hit_19, beyond_11, emitted_4, goes_on_5, &((*sample_21)));
        }
        goes_on_4 = goes_on_5;
    }
    if(scatter_of_path_0.wants_light_0)
    {
        choose_light_1(scatter_of_path_0, &(next_5));
    }
    if(!_S453)
    {
        var _S458 : bool;
        if(counts_arrivals_0)
        {
            _S458 = next_5.has_shadow_ray_0;
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
            _S458 = (Path_events_0(scatter_of_path_0.path_3)) == u32(0);
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
            _S458 = !scatter_of_path_0.is_scattered_0;
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
            _S458 = !Inside_is_in_0(scatter_of_path_0.path_3.inside_0);
        }
        else
        {
            _S458 = false;
        }
        (*at_10).counts_0 = _S458;
    }
    if(_S453)
    {
        (*at_10).path_0.bounce_0 = u32(1);
        (*at_10).path_0.event_0 = u32(1);
        (*at_10).path_0.scattered_0 = u32(1);
        (*at_10).is_at_cell_0 = false;
    }
    (*at_10).direction_4 = next_5.direction_5;
    (*at_10).light_0 = next_5.light_2;
    (*at_10).is_shadow_ray_0 = next_5.has_shadow_ray_0;
    (*at_10).path_origin_0 = next_5.path_origin_1;
    (*at_10).ray_7 = ray_from_0(next_5.origin_9, next_5.direction_5);
    if((*at_10).is_shadow_ray_0)
    {
        (*at_10).ray_7 = Ray_x24init_0(next_5.origin_9, 0.0f, next_5.shadow_direction_0, next_5.shadow_t_max_0);
    }
    if(goes_on_4)
    {
        goes_on_4 = true;
    }
    else
    {
        goes_on_4 = (*at_10).is_shadow_ray_0;
    }
    return goes_on_4;
}

fn PathTracingOf_advance_2( path_13 : ptr<function, Path_0>,  ray_26 : Ray_0,  hit_20 : Hit_0,  beyond_12 : u32,  radiance_7 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_6 : NextRays_0 = no_rays_0();
    scatter_of_path_0.wants_light_0 = false;
    var is_counted_2 : bool = Path_is_counted_0((*path_13));
    var t_17 : f32;
    if(is_counted_2)
    {
        t_17 = - (*path_13).pdf_1;
    }
    else
    {
        t_17 = (*path_13).pdf_1;
    }
    (*path_13).pdf_1 = t_17;
    var last_7 : Receiver_0 = Path_receiver_0((*path_13), ray_26);
    var is_scattered_4 : bool;
    if(Inside_is_in_0((*path_13).inside_0))
    {
        is_scattered_4 = Hit_is_miss_0(hit_20);
    }
    else
    {
        is_scattered_4 = false;
    }
    if(Inside_is_in_0((*path_13).inside_0))
    {
        if(is_scattered_4)
        {
            t_17 = scattering_t_0((*path_13), (*path_13).inside_0, ray_26);
        }
        else
        {
            t_17 = hit_20.t_0;
        }
        if(!is_counted_2)
        {
            absorb_1(&((*path_13)), (*path_13).inside_0, ray_26, t_17);
        }
    }
    else
    {
        t_17 = hit_20.t_0;
    }
    var is_weighed_2 : bool;
    if(Hit_is_miss_0(hit_20))
    {
        is_weighed_2 = !is_scattered_4;
    }
    else
    {
        is_weighed_2 = false;
    }
    var light_pdf_3 : f32;
    if(is_weighed_2)
    {
        (*radiance_7) = (*radiance_7) + (*path_13).beta_0 * Sky_le_0(ray_26.direction_0) * vec3<f32>(mis_weight_0((*path_13).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_13), last_7), ray_26.direction_0)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_4 = true;
            }
            else
            {
                is_scattered_4 = !Path_is_straight_0((*path_13));
            }
        }
        else
        {
            is_scattered_4 = false;
        }
        if(is_scattered_4)
        {
            var le_4 : vec3<f32> = SunDisc_le_0(ray_26.direction_0);
            if((max_element_0(le_4)) > 0.0f)
            {
                if(((*path_13).pdf_1) == 0.0f)
                {
                    light_pdf_3 = 0.0f;
                }
                else
                {
                    light_pdf_3 = Lights_sun_pdf_0(Path_selection_at_0((*path_13), last_7), ray_26.direction_0);
                }
                (*radiance_7) = (*radiance_7) + (*path_13).beta_0 * le_4 * vec3<f32>(mis_weight_0((*path_13).pdf_1, light_pdf_3));
            }
        }
        return next_6;
    }
    var u_29 : vec4<f32> = Sampler_stratified_0((*path_13).sampler_0, Path_dimension_scatter_0((*path_13)));
    var material_17 : PackedMaterial_0 = material_met_0((*path_13), hit_20, beyond_12);
    var _S459 : vec3<f32> = vec3<f32>(0.0f);
    var le_5 : vec3<f32>;
    if(!is_counted_2)
    {
        le_5 = EmitterTree_le_0(material_17);
    }
    else
    {
        le_5 = _S459;
    }
    var is_lit_6 : bool = (max_element_0(le_5)) > 0.0f;
    var met_2 : Aim_0 = Aim_x24init_0(true, ray_26.direction_0, hit_20, luminance_0(vector_of_0(material_17.emission_0)));
    var _S460 : bool = weighs_apart_0();
    if(_S460)
    {
        is_weighed_2 = is_lit_6;
    }
    else
    {
        is_weighed_2 = false;
    }
    if(is_weighed_2)
    {
        is_weighed_2 = ((*path_13).pdf_1) > 0.0f;
    }
    else
    {
        is_weighed_2 = false;
    }
    var is_chosen_2 : bool;
    if(is_lit_6)
    {
        is_chosen_2 = !is_weighed_2;
    }
    else
    {
        is_chosen_2 = false;
    }
    if(is_chosen_2)
    {
        var light_12 : LightSample_0 = no_light_0();
        if(!_S460)
        {
            is_chosen_2 = ((*path_13).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_2 = false;
        }
        if(is_chosen_2)
        {
            var _S461 : bool = Lights_sample_1(last_7, Path_selection_at_0((*path_13), last_7), vec4<f32>(0.0f), met_2, &(light_12));
            is_chosen_2 = _S461;
        }
        else
        {
            is_chosen_2 = false;
        }
        var _S462 : vec3<f32> = (*path_13).beta_0 * le_5;
        var _S463 : f32 = (*path_13).pdf_1;
        if(is_chosen_2)
        {
            light_pdf_3 = light_12.pdf_2;
        }
        else
        {
            light_pdf_3 = 0.0f;
        }
        (*radiance_7) = (*radiance_7) + _S462 * vec3<f32>(mis_weight_0(_S463, light_pdf_3));
    }
    var _S464 : f32 = ior_of_0((*path_13).inside_0);
    var _S465 : f32 = u_29[i32(3)];
    var _S466 : MaterialBsdf_0 = bsdf_of_1(material_17, _S464, &(_S465));
    u_29[i32(3)] = _S465;
    var scattered_4 : vec3<f32> = (*path_13).beta_0 * MaterialBsdf_albedo_0(_S466);
    if(((*path_13).bounce_0) >= (params_0.max_bounces_0))
    {
        is_chosen_2 = true;
    }
    else
    {
        is_chosen_2 = ends_here_0;
    }
    var _S467 : bool = !is_weighed_2;
    if(_S467)
    {
        if(is_chosen_2)
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
        return next_6;
    }
    var compensation_4 : f32 = roulette_0(Path_events_0((*path_13)), scattered_4, u_29.z);
    if(_S467)
    {
        is_chosen_2 = compensation_4 == 0.0f;
    }
    else
    {
        is_chosen_2 = false;
    }
    if(is_chosen_2)
    {
        return next_6;
    }
    var at_11 : Hit_0;
    if(is_scattered_4)
    {
        at_11 = Hit_x24init_0(t_17, (*path_13).inside_0.instance_6, hit_20.voxel_0, u32(0));
    }
    else
    {
        at_11 = hit_20;
    }
    var surface_5 : Surface_0 = surface_of_0(ray_26, at_11);
    var _S468 : Receiver_0 = Receiver_x24init_0(surface_5.origin_11, surface_5.normal_3);
    var _S469 : vec3<f32> = (vec3<f32>(0) - ray_26.direction_0);
    var wo_12 : vec3<f32> = Surface_local_direction_0(surface_5, _S469);
    var inside_7 : Inside_0 = in_air_0();
    var wo_13 : vec3<f32>;
    var receiver_29 : Receiver_0;
    if(is_scattered_4)
    {
        var _S470 : Inside_0 = Inside_x24init_0((*path_13).inside_0.instance_6, hit_20.voxel_0, (*path_13).inside_0.material_0);
        inside_7 = _S470;
        var _S471 : vec3<f32> = normalize_vector_0(_S469);
        receiver_29 = Receiver_x24init_0(Inside_point_0(_S470, ray_26, t_17), _S459);
        wo_13 = _S471;
    }
    else
    {
        if(Inside_is_in_0((*path_13).inside_0))
        {
            next_6.relocates_1 = (hit_20.instance_0) != ((*path_13).inside_0.instance_6);
            inside_7 = Inside_x24init_0((*path_13).inside_0.instance_6, hit_20.voxel_0, (*path_13).inside_0.material_0);
            inside_7.voxel_22 = hit_20.voxel_0 + vec3<i32>(face_normal_0(hit_20.face_0));
        }
        receiver_29 = _S468;
        wo_13 = wo_12;
    }
    next_6.origin_9 = receiver_29.point_0;
    next_6.shadow_inside_1 = inside_7;
    if(is_weighed_2)
    {
        receiver_29 = last_7;
    }
    if(_S467)
    {
        (*path_13).selection_0 = Lights_selection_0(receiver_29);
    }
    var light_13 : LightSample_0 = no_light_0();
    var _S472 : bool = !MaterialBsdf_is_delta_0(_S466);
    scatter_of_path_0 = Scatter_x24init_0((*path_13), receiver_29, surface_5, _S466, wo_13, compensation_4, is_scattered_4, _S472);
    if(is_weighed_2)
    {
        if(next_6.has_shadow_ray_0)
        {
            light_pdf_3 = light_13.pdf_2;
        }
        else
        {
            light_pdf_3 = 0.0f;
        }
        (*radiance_7) = (*radiance_7) + (*path_13).beta_0 * le_5 * vec3<f32>(mis_weight_0((*path_13).pdf_1, light_pdf_3));
        (*path_13).pdf_1 = - (*path_13).pdf_1;
        next_6.is_same_0 = true;
        return next_6;
    }
    var bounce_3 : BsdfSample_0;
    var _S473 : bool = MaterialBsdf_sample_1(_S466, wo_13, vec3<f32>(u_29.xy, u_29.w), &(bounce_3));
    if(!_S473)
    {
        return next_6;
    }
    (*path_13).beta_0 = (*path_13).beta_0 * bounce_3.weight_3 * vec3<f32>(compensation_4);
    if(bounce_3.is_delta_0)
    {
        t_17 = 0.0f;
    }
    else
    {
        t_17 = bounce_3.pdf_8;
    }
    (*path_13).pdf_1 = t_17;
    (*path_13).normal_0 = receiver_29.normal_2;
    next_6.direction_5 = bounce_3.wi_0;
    if(!is_scattered_4)
    {
        next_6.direction_5 = Surface_world_direction_0(surface_5, bounce_3.wi_0);
    }
    next_6.path_relocates_1 = next_6.relocates_1;
    (*path_13).bounce_0 = (*path_13).bounce_0 + u32(1);
    return next_6;
}

fn goes_on_from_2( at_12 : ptr<function, Walker_0>,  hit_21 : Hit_0,  beyond_13 : u32,  sample_22 : ptr<function, Sample_0>) -> bool
{
    var next_7 : NextRays_0 = no_rays_0();
    var _S474 : bool = (*at_12).is_at_cell_0;
    var goes_on_6 : bool;
    if((*at_12).is_at_cell_0)
    {
        next_7.origin_9 = (*at_12).ray_7.origin_0;
        next_7.path_origin_1 = (*at_12).ray_7.origin_0;
        next_7.direction_5 = (*at_12).ray_7.direction_0;
        goes_on_6 = true;
    }
    else
    {
        var _S475 : vec3<f32> = vec3<f32>(0.0f);
        var cached_2 : vec3<f32> = _S475;
        if((*at_12).has_shown_0)
        {
            goes_on_6 = (*at_12).asks_cache_0;
        }
        else
        {
            goes_on_6 = false;
        }
        if(goes_on_6)
        {
            var _S476 : bool = asks_1((*at_12).path_0, (*at_12).ray_7, hit_21, beyond_13, (*at_12).life_0, &(cached_2));
            goes_on_6 = _S476;
        }
        else
        {
            goes_on_6 = false;
        }
        ends_here_0 = goes_on_6;
        var arrived_4 : Path_0 = (*at_12).path_0;
        var emitted_5 : vec3<f32> = _S475;
        var _S477 : Path_0 = (*at_12).path_0;
        var _S478 : NextRays_0 = PathTracingOf_advance_1(&(_S477), (*at_12).ray_7, hit_21, beyond_13, &(emitted_5));
        (*at_12).path_0 = _S477;
        next_7 = _S478;
        var goes_on_7 : bool = (any(((next_7.direction_5) != _S475)));
        if((*at_12).has_shown_0)
        {
            (*sample_22).light_1 = (*sample_22).light_1 + (cached_2 + emitted_5);
        }
        else
        {
            Walker_see_1(&((*at_12)), arrived_4, hit_21, beyond_13, emitted_5, goes_on_7, &((*sample_22)));
        }
        goes_on_6 = goes_on_7;
    }
    if(_S474)
    {
        (*at_12).path_0.bounce_0 = u32(1);
        (*at_12).path_0.event_0 = u32(1);
        (*at_12).path_0.scattered_0 = u32(1);
        (*at_12).is_at_cell_0 = false;
    }
    (*at_12).direction_4 = next_7.direction_5;
    (*at_12).light_0 = next_7.light_2;
    (*at_12).is_shadow_ray_0 = next_7.has_shadow_ray_0;
    (*at_12).path_origin_0 = next_7.path_origin_1;
    (*at_12).ray_7 = ray_from_0(next_7.origin_9, next_7.direction_5);
    if((*at_12).is_shadow_ray_0)
    {
        (*at_12).ray_7 = Ray_x24init_0(next_7.origin_9, 0.0f, next_7.shadow_direction_0, next_7.shadow_t_max_0);
    }
    if(goes_on_6)
    {
        goes_on_6 = true;
    }
    else
    {
        goes_on_6 = (*at_12).is_shadow_ray_0;
    }
    return goes_on_6;
}

struct InstanceNode_0
{
     min_2 : array<f32, i32(3)>,
     index_29 : u32,
     max_2 : array<f32, i32(3)>,
     is_leaf_0 : u32,
};

fn Rows_operatorx5Bx5D_get_6( row_10 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(2)) + row_10];
}

fn InstanceNodes_operatorx5Bx5D_get_0( index_30 : u32) -> InstanceNode_0
{
    var _S479 : u32 = u32(2) * index_30;
    var _S480 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S479);
    var _S481 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S479 + u32(1));
    var node_14 : InstanceNode_0;
    var _S482 : f32 = (bitcast<f32>((_S480.y)));
    var _S483 : f32 = (bitcast<f32>((_S480.z)));
    node_14.min_2[i32(0)] = (bitcast<f32>((_S480.x)));
    node_14.min_2[i32(1)] = _S482;
    node_14.min_2[i32(2)] = _S483;
    node_14.index_29 = _S480.w;
    var _S484 : f32 = (bitcast<f32>((_S481.y)));
    var _S485 : f32 = (bitcast<f32>((_S481.z)));
    node_14.max_2[i32(0)] = (bitcast<f32>((_S481.x)));
    node_14.max_2[i32(1)] = _S484;
    node_14.max_2[i32(2)] = _S485;
    node_14.is_leaf_0 = _S481.w;
    return node_14;
}

fn entry_0( node_15 : InstanceNode_0,  ray_27 : Ray_0,  inverse_3 : vec3<f32>) -> f32
{
    var low_16 : vec3<f32> = (vector_of_0(node_15.min_2) - ray_27.origin_0) * inverse_3;
    var high_6 : vec3<f32> = (vector_of_0(node_15.max_2) - ray_27.origin_0) * inverse_3;
    var _S486 : f32 = max(ray_27.t_min_0, max_element_0(min(low_16, high_6)));
    var _S487 : f32;
    if(_S486 <= (min(ray_27.t_max_0, min_element_0(max(low_16, high_6)))))
    {
        _S487 = _S486;
    }
    else
    {
        _S487 = (bitcast<f32>(infinity_bits_0));
    }
    return _S487;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool,  end_3 : u32) -> Hit_0
{
    var is_leaf_1 : bool;
    if(IS_SINGLE_0)
    {
        var _S488 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S488;
    }
    var ray_28 : Ray_0 = (*given_0);
    var nearest_3 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_3;
    }
    var is_zero_1 : vec3<bool> = !((abs(ray_28.direction_0)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S489 : vec3<f32> = select(reciprocal_0(select(ray_28.direction_0, vec3<f32>(1.0f), is_zero_1)), vec3<f32>(3.4028234663852886e+38f), is_zero_1);
    var stack_0 : array<u32, i32(32)>;
    var entries_0 : array<f32, i32(32)>;
    var _S490 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(u32(0));
    var _S491 : bool = (InstanceNodes_operatorx5Bx5D_get_0(u32(0)).is_leaf_0) != u32(0);
    var is_done_0 : bool = false;
    var is_leaf_2 : bool = _S491;
    var index_31 : u32 = u32(0);
    var below_1 : u32 = _S490.index_29;
    var nearest_4 : Hit_0 = nearest_3;
    var depth_0 : u32 = u32(0);
    for(;;)
    {
        var is_done_1 : bool = is_done_0;
        var below_2 : u32 = below_1;
        var depth_1 : u32 = depth_0;
        for(;;)
        {
            var _S492 : bool;
            if(is_done_1)
            {
                _S492 = depth_1 > u32(0);
            }
            else
            {
                _S492 = !is_leaf_2;
            }
            if(_S492)
            {
            }
            else
            {
                break;
            }
            var index_32 : u32;
            if(is_done_1)
            {
                var depth_2 : u32 = depth_1 - u32(1);
                var _S493 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]);
                var _S494 : bool = (InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]).is_leaf_0) != u32(0);
                is_done_1 = (entries_0[depth_2]) > (ray_28.t_max_0);
                is_leaf_1 = _S494;
                index_32 = stack_0[depth_2];
                below_2 = _S493.index_29;
                depth_1 = depth_2;
            }
            else
            {
                var _S495 : u32 = index_31 + u32(1);
                var _S496 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(_S495);
                var _S497 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(below_2);
                var to_left_0 : f32 = entry_0(_S496, ray_28, _S489);
                var to_right_0 : f32 = entry_0(_S497, ray_28, _S489);
                var is_left_7 : bool = to_left_0 <= to_right_0;
                var _S498 : f32 = max(to_left_0, to_right_0);
                var INFINITY_0 : f32 = (bitcast<f32>(infinity_bits_0));
                if(_S498 < INFINITY_0)
                {
                    if(is_left_7)
                    {
                        index_32 = below_2;
                    }
                    else
                    {
                        index_32 = _S495;
                    }
                    stack_0[depth_1] = index_32;
                    entries_0[depth_1] = _S498;
                    index_32 = depth_1 + u32(1);
                }
                else
                {
                    index_32 = depth_1;
                }
                var _S499 : bool = (min(to_left_0, to_right_0)) == INFINITY_0;
                var _S500 : u32;
                if(is_left_7)
                {
                    _S500 = _S495;
                }
                else
                {
                    _S500 = below_2;
                }
                var _S501 : u32;
                if(is_left_7)
                {
                    _S501 = _S496.index_29;
                }
                else
                {
                    _S501 = _S497.index_29;
                }
                var _S502 : u32;
                if(is_left_7)
                {
                    _S502 = _S496.is_leaf_0;
                }
                else
                {
                    _S502 = _S497.is_leaf_0;
                }
                var _S503 : bool = _S502 != u32(0);
                var _S504 : u32 = index_32;
                is_done_1 = _S499;
                is_leaf_1 = _S503;
                index_32 = _S500;
                below_2 = _S501;
                depth_1 = _S504;
            }
            is_leaf_2 = is_leaf_1;
            index_31 = index_32;
        }
        if(is_done_1)
        {
            break;
        }
        var _S505 : Hit_0 = hit_in_0(below_2, &(ray_28));
        var _S506 : Hit_0 = nearest_4;
        if((_S505.t_0) < (nearest_4.t_0))
        {
            is_leaf_1 = true;
        }
        else
        {
            if((_S505.t_0) == (_S506.t_0))
            {
                is_leaf_1 = (_S505.instance_0) < (nearest_4.instance_0);
            }
            else
            {
                is_leaf_1 = false;
            }
        }
        if(is_leaf_1)
        {
            ray_28.t_max_0 = _S505.t_0;
            if(is_any_enough_0)
            {
                return _S505;
            }
            nearest_4 = _S505;
        }
        is_done_0 = true;
        below_1 = below_2;
        depth_0 = depth_1;
    }
    return nearest_4;
}

fn visit_1( given_1 : ptr<function, Ray_0>,  is_any_enough_1 : bool,  end_4 : u32) -> Hit_0
{
    var is_leaf_3 : bool;
    if(IS_SINGLE_0)
    {
        var _S507 : Hit_0 = hit_in_1(u32(0), &((*given_1)));
        return _S507;
    }
    var ray_29 : Ray_0 = (*given_1);
    var nearest_5 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_5;
    }
    var is_zero_2 : vec3<bool> = !((abs(ray_29.direction_0)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S508 : vec3<f32> = select(reciprocal_0(select(ray_29.direction_0, vec3<f32>(1.0f), is_zero_2)), vec3<f32>(3.4028234663852886e+38f), is_zero_2);
    var stack_1 : array<u32, i32(32)>;
    var entries_1 : array<f32, i32(32)>;
    var _S509 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(u32(0));
    var _S510 : bool = (InstanceNodes_operatorx5Bx5D_get_0(u32(0)).is_leaf_0) != u32(0);
    var is_done_2 : bool = false;
    var is_leaf_4 : bool = _S510;
    var index_33 : u32 = u32(0);
    var below_3 : u32 = _S509.index_29;
    var nearest_6 : Hit_0 = nearest_5;
    var depth_3 : u32 = u32(0);
    for(;;)
    {
        var is_done_3 : bool = is_done_2;
        var below_4 : u32 = below_3;
        var depth_4 : u32 = depth_3;
        for(;;)
        {
            var _S511 : bool;
            if(is_done_3)
            {
                _S511 = depth_4 > u32(0);
            }
            else
            {
                _S511 = !is_leaf_4;
            }
            if(_S511)
            {
            }
            else
            {
                break;
            }
            var index_34 : u32;
            if(is_done_3)
            {
                var depth_5 : u32 = depth_4 - u32(1);
                var _S512 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(stack_1[depth_5]);
                var _S513 : bool = (InstanceNodes_operatorx5Bx5D_get_0(stack_1[depth_5]).is_leaf_0) != u32(0);
                is_done_3 = (entries_1[depth_5]) > (ray_29.t_max_0);
                is_leaf_3 = _S513;
                index_34 = stack_1[depth_5];
                below_4 = _S512.index_29;
                depth_4 = depth_5;
            }
            else
            {
                var _S514 : u32 = index_33 + u32(1);
                var _S515 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(_S514);
                var _S516 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(below_4);
                var to_left_1 : f32 = entry_0(_S515, ray_29, _S508);
                var to_right_1 : f32 = entry_0(_S516, ray_29, _S508);
                var is_left_8 : bool = to_left_1 <= to_right_1;
                var _S517 : f32 = max(to_left_1, to_right_1);
                var INFINITY_1 : f32 = (bitcast<f32>(infinity_bits_0));
                if(_S517 < INFINITY_1)
                {
                    if(is_left_8)
                    {
                        index_34 = below_4;
                    }
                    else
                    {
                        index_34 = _S514;
                    }
                    stack_1[depth_4] = index_34;
                    entries_1[depth_4] = _S517;
                    index_34 = depth_4 + u32(1);
                }
                else
                {
                    index_34 = depth_4;
                }
                var _S518 : bool = (min(to_left_1, to_right_1)) == INFINITY_1;
                var _S519 : u32;
                if(is_left_8)
                {
                    _S519 = _S514;
                }
                else
                {
                    _S519 = below_4;
                }
                var _S520 : u32;
                if(is_left_8)
                {
                    _S520 = _S515.index_29;
                }
                else
                {
                    _S520 = _S516.index_29;
                }
                var _S521 : u32;
                if(is_left_8)
                {
                    _S521 = _S515.is_leaf_0;
                }
                else
                {
                    _S521 = _S516.is_leaf_0;
                }
                var _S522 : bool = _S521 != u32(0);
                var _S523 : u32 = index_34;
                is_done_3 = _S518;
                is_leaf_3 = _S522;
                index_34 = _S519;
                below_4 = _S520;
                depth_4 = _S523;
            }
            is_leaf_4 = is_leaf_3;
            index_33 = index_34;
        }
        if(is_done_3)
        {
            break;
        }
        var _S524 : Hit_0 = hit_in_1(below_4, &(ray_29));
        var _S525 : Hit_0 = nearest_6;
        if((_S524.t_0) < (nearest_6.t_0))
        {
            is_leaf_3 = true;
        }
        else
        {
            if((_S524.t_0) == (_S525.t_0))
            {
                is_leaf_3 = (_S524.instance_0) < (nearest_6.instance_0);
            }
            else
            {
                is_leaf_3 = false;
            }
        }
        if(is_leaf_3)
        {
            ray_29.t_max_0 = _S524.t_0;
            if(is_any_enough_1)
            {
                return _S524;
            }
            nearest_6 = _S524;
        }
        is_done_2 = true;
        below_3 = below_4;
        depth_3 = depth_4;
    }
    return nearest_6;
}

fn PathTracingOf_jitter_0( sampler_1 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_1, u32(0));
}

fn Sampler_x24init_0( seed_3 : u32,  pixel_1 : u32,  sample_23 : u32) -> Sampler_0
{
    var _S526 : Sampler_0;
    _S526.seed_1 = seed_3;
    _S526.pixel_0 = pixel_1;
    _S526.sample_0 = sample_23;
    return _S526;
}

struct Item_0
{
     traces_0 : bool,
     kind_2 : u32,
     at_13 : vec2<u32>,
     place_7 : u32,
     slot_0 : u32,
     sampler_2 : Sampler_0,
};

fn Item_x24init_0( traces_1 : bool,  kind_3 : u32,  at_14 : vec2<u32>,  place_8 : u32,  slot_1 : u32,  sampler_3 : Sampler_0) -> Item_0
{
    var _S527 : Item_0;
    _S527.traces_0 = traces_1;
    _S527.kind_2 = kind_3;
    _S527.at_13 = at_14;
    _S527.place_7 = place_8;
    _S527.slot_0 = slot_1;
    _S527.sampler_2 = sampler_3;
    return _S527;
}

fn has_0( flag_0 : u32) -> bool
{
    return (((real_time_0.flags_0) & (flag_0))) != u32(0);
}

fn threads_that_trace_0() -> u32
{
    var columns_0 : u32;
    if(has_0(u32(128)))
    {
        columns_0 = (params_0.width_0 + u32(15)) / u32(16);
    }
    else
    {
        columns_0 = (params_0.width_0 + u32(7)) / u32(8);
    }
    return columns_0 * ((params_0.height_0 + u32(7)) / u32(8)) * u32(64);
}

fn place_of_chosen_0( number_2 : u32) -> u32
{
    return u32(524304) + number_2;
}

fn Item_key_0( this_58 : Item_0,  rank_3 : ptr<function, u32>) -> Key_0
{
    var face_8 : vec4<u32> = cell_row_0(u32(1), this_58.place_7);
    (*rank_3) = face_8.z;
    return Key_x24init_0(face_8.x, face_8.y, vec3<i32>(cell_row_0(u32(2), this_58.place_7).xyz));
}

fn Item_key_1( this_59 : Item_0,  rank_4 : ptr<function, u32>) -> Key_0
{
    var face_9 : vec4<u32> = cell_row_0(u32(1), this_59.place_7);
    (*rank_4) = face_9.z;
    return Key_x24init_0(face_9.x, face_9.y, vec3<i32>(cell_row_0(u32(2), this_59.place_7).xyz));
}

fn Item_key_2( this_60 : Item_0,  rank_5 : ptr<function, u32>) -> Key_0
{
    var face_10 : vec4<u32> = cell_row_0(u32(1), this_60.place_7);
    (*rank_5) = face_10.z;
    return Key_x24init_0(face_10.x, face_10.y, vec3<i32>(cell_row_0(u32(2), this_60.place_7).xyz));
}

fn pixel_of_thread_0( thread_0 : u32) -> vec2<u32>
{
    var tiles_0 : u32 = (params_0.width_0 + u32(7)) / u32(8);
    var tile_0 : u32 = thread_0 / u32(64);
    var in_tile_0 : u32 = (thread_0 & (u32(63)));
    var row_11 : u32 = tile_0 / tiles_0;
    return vec2<u32>((tile_0 - row_11 * tiles_0) * u32(8) + ((in_tile_0 & (u32(7)))), row_11 * u32(8) + ((in_tile_0 >> (u32(3)))));
}

fn pixel_that_traces_0( thread_1 : u32) -> vec2<u32>
{
    if(!has_0(u32(128)))
    {
        var _S528 : vec2<u32> = pixel_of_thread_0(thread_1);
        return _S528;
    }
    var tiles_1 : u32 = (params_0.width_0 + u32(15)) / u32(16);
    var tile_1 : u32 = thread_1 / u32(64);
    var in_tile_1 : u32 = (thread_1 & (u32(63)));
    var row_12 : u32 = tile_1 / tiles_1;
    var _S529 : u32 = row_12 * u32(8) + ((in_tile_1 >> (u32(3))));
    var at_15 : vec2<u32> = vec2<u32>((tile_1 - row_12 * tiles_1) * u32(16) + u32(2) * ((in_tile_1 & (u32(7)))), _S529);
    at_15[i32(0)] = at_15[i32(0)] + (((_S529 + real_time_0.number_0) & (u32(1))));
    return at_15;
}

fn squares_1() -> vec2<u32>
{
    var _S530 : vec2<u32> = vec2<u32>(u32(5));
    var _S531 : vec2<u32> = (vec2<u32>(params_0.width_0, params_0.height_0) + _S530 - vec2<u32>(u32(1))) / _S530;
    return _S531;
}

fn pixel_of_square_0( square_1 : u32,  number_3 : u32) -> vec2<u32>
{
    var columns_1 : u32 = squares_1().x;
    var _S532 : u32 = square_1 % columns_1;
    var _S533 : u32 = square_1 / columns_1;
    var at_16 : vec2<u32> = vec2<u32>(_S532, _S533);
    var _S534 : vec2<u32> = vec2<u32>(u32(5));
    var _S535 : vec2<u32> = at_16 * _S534;
    var _S536 : vec2<u32> = pcg4d_0(vec4<u32>(at_16, number_3, u32(3266489909))).xy % _S534;
    return min(_S535 + _S536, vec2<u32>(params_0.width_0, params_0.height_0) - vec2<u32>(u32(1)));
}

fn is_inside_0( at_17 : vec2<i32>) -> bool
{
    var _S537 : bool;
    if((all((at_17 >= vec2<i32>(i32(0))))))
    {
        _S537 = (at_17.x) < i32(params_0.width_0);
    }
    else
    {
        _S537 = false;
    }
    if(_S537)
    {
        _S537 = (at_17.y) < i32(params_0.height_0);
    }
    else
    {
        _S537 = false;
    }
    return _S537;
}

fn place_of_square_0( list_0 : u32,  square_2 : u32) -> u32
{
    var count_7 : vec2<u32> = squares_1();
    return u32(4) * real_time_0.pixels_0 + list_0 * count_7.x * count_7.y + square_2;
}

fn index_of_0( at_18 : vec2<u32>) -> u32
{
    return at_18.y * params_0.width_0 + at_18.x;
}

fn item_of_0( number_4 : u32) -> Item_0
{
    var item_0 : Item_0 = Item_x24init_0(false, u32(0), vec2<u32>(vec2<i32>(i32(0))), u32(0), u32(0), Sampler_x24init_0(u32(0), u32(0), u32(0)));
    var cells_2 : u32 = real_time_0.cells_0;
    var pixels_1 : u32 = threads_that_trace_0();
    var count_8 : u32 = real_time_0.squares_0;
    if(number_4 < (real_time_0.cells_0))
    {
        var _S538 : u32 = atomicLoad(&(cell_keys_0[u32(2)]));
        var _S539 : bool = number_4 < _S538;
        item_0.traces_0 = _S539;
        if(_S539)
        {
            var _S540 : u32 = atomicLoad(&(cell_keys_0[place_of_chosen_0(number_4)]));
            item_0.place_7 = _S540;
            item_0.slot_0 = real_time_0.pixels_0 + count_8 + number_4;
            var rank_6 : u32;
            item_0.sampler_2 = Sampler_x24init_0(((params_0.seed_0) ^ (u32(1540483477))), Key_hash_0(Item_key_0(item_0, &(rank_6))).x, real_time_0.number_0);
        }
        return item_0;
    }
    var _S541 : u32 = number_4 - cells_2;
    var _S542 : vec2<u32> = pixel_that_traces_0(_S541);
    item_0.at_13 = _S542;
    var square_3 : u32 = _S541 - pixels_1;
    var is_square_0 : bool = number_4 >= (cells_2 + pixels_1);
    var is_again_0 : bool;
    if(is_square_0)
    {
        is_again_0 = square_3 >= count_8;
    }
    else
    {
        is_again_0 = false;
    }
    var frame_0 : u32;
    if(is_again_0)
    {
        frame_0 = count_8;
    }
    else
    {
        frame_0 = u32(0);
    }
    var square_4 : u32 = square_3 - frame_0;
    if(is_again_0)
    {
        frame_0 = real_time_0.number_0 - u32(1);
    }
    else
    {
        frame_0 = real_time_0.number_0;
    }
    var _S543 : u32;
    if(is_again_0)
    {
        _S543 = u32(3);
    }
    else
    {
        if(is_square_0)
        {
            _S543 = u32(2);
        }
        else
        {
            _S543 = u32(1);
        }
    }
    item_0.kind_2 = _S543;
    if(is_square_0)
    {
        var _S544 : vec2<u32> = pixel_of_square_0(square_4, frame_0);
        item_0.at_13 = _S544;
    }
    var _S545 : bool;
    if(is_square_0)
    {
        if(is_again_0)
        {
            _S543 = real_time_0.again_0;
        }
        else
        {
            _S543 = count_8;
        }
        _S545 = square_4 < _S543;
    }
    else
    {
        _S545 = is_inside_0(vec2<i32>(item_0.at_13));
    }
    item_0.traces_0 = _S545;
    if(is_square_0)
    {
        if(is_again_0)
        {
            _S543 = u32(2);
        }
        else
        {
            _S543 = (frame_0 & (u32(1)));
        }
        _S543 = place_of_square_0(_S543, square_4);
    }
    else
    {
        _S543 = index_of_0(item_0.at_13);
    }
    item_0.place_7 = _S543;
    if(is_square_0)
    {
        _S543 = real_time_0.pixels_0 + square_4;
    }
    else
    {
        _S543 = item_0.place_7;
    }
    item_0.slot_0 = _S543;
    var _S546 : u32 = params_0.seed_0;
    if(is_square_0)
    {
        _S543 = u32(3266489909);
    }
    else
    {
        _S543 = u32(2654435769);
    }
    item_0.sampler_2 = Sampler_x24init_0((_S546 ^ (_S543)), index_of_0(item_0.at_13), frame_0);
    return item_0;
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

fn CameraFrame_x24init_0( lens_2 : u32,  eye_3 : vec3<f32>,  corner_3 : vec3<f32>,  pixel_x_2 : vec3<f32>,  pixel_y_2 : vec3<f32>,  lens_x_2 : vec3<f32>,  lens_y_2 : vec3<f32>,  blades_2 : u32) -> CameraFrame_0
{
    var _S547 : CameraFrame_0;
    _S547.lens_1 = lens_2;
    _S547.eye_2 = eye_3;
    _S547.corner_2 = corner_3;
    _S547.pixel_x_1 = pixel_x_2;
    _S547.pixel_y_1 = pixel_y_2;
    _S547.lens_x_1 = lens_x_2;
    _S547.lens_y_1 = lens_y_2;
    _S547.blades_1 = blades_2;
    return _S547;
}

@id(5) override LENS_0 : u32 = u32(0);

struct Perspective_0
{
     eye_4 : vec3<f32>,
     corner_4 : vec3<f32>,
     pixel_x_3 : vec3<f32>,
     pixel_y_3 : vec3<f32>,
};

fn Perspective_x24init_0( eye_5 : vec3<f32>,  corner_5 : vec3<f32>,  pixel_x_4 : vec3<f32>,  pixel_y_4 : vec3<f32>) -> Perspective_0
{
    var _S548 : Perspective_0;
    _S548.eye_4 = eye_5;
    _S548.corner_4 = corner_5;
    _S548.pixel_x_3 = pixel_x_4;
    _S548.pixel_y_3 = pixel_y_4;
    return _S548;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_6 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_7 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S549 : Axes_0;
    _S549.forward_0 = forward_1;
    _S549.right_6 = right_7;
    _S549.up_0 = up_1;
    return _S549;
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
    var _S550 : ThinLens_0;
    _S550.perspective_0 = perspective_1;
    _S550.lens_x_3 = lens_x_4;
    _S550.lens_y_3 = lens_y_4;
    _S550.blades_3 = blades_4;
    return _S550;
}

fn concentric_0( square_5 : vec2<f32>) -> vec2<f32>
{
    var a_6 : f32 = 2.0f * square_5.x - 1.0f;
    var b_6 : f32 = 2.0f * square_5.y - 1.0f;
    var _S551 : bool;
    if(a_6 == 0.0f)
    {
        _S551 = b_6 == 0.0f;
    }
    else
    {
        _S551 = false;
    }
    if(_S551)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_6)) > (abs(b_6));
    var radius_5 : f32;
    if(is_across_0)
    {
        radius_5 = a_6;
    }
    else
    {
        radius_5 = b_6;
    }
    var turns_3 : f32;
    if(is_across_0)
    {
        turns_3 = divide_0(b_6, a_6) * 0.125f;
    }
    else
    {
        turns_3 = 0.25f - divide_0(a_6, b_6) * 0.125f;
    }
    if(radius_5 < 0.0f)
    {
        turns_3 = turns_3 + 0.5f;
    }
    var _S552 : f32 = abs(radius_5);
    if(turns_3 < 0.0f)
    {
        radius_5 = turns_3 + 1.0f;
    }
    else
    {
        radius_5 = turns_3;
    }
    return vec2<f32>(_S552, radius_5);
}

fn place_in_aperture_0( blades_5 : u32,  lens_3 : vec2<f32>) -> vec2<f32>
{
    var radius_turns_0 : vec2<f32> = concentric_0(lens_3);
    var radius_6 : f32 = radius_turns_0.x;
    if(blades_5 == u32(0))
    {
        var sin_cos_4 : vec2<f32> = sincos_turns_0(radius_turns_0.y);
        return vec2<f32>(radius_6 * sin_cos_4.y, radius_6 * sin_cos_4.x);
    }
    var count_9 : f32 = f32(blades_5);
    var scaled_0 : f32 = radius_turns_0.y * count_9;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_5 - u32(1)));
    var share_14 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_9));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_9));
    var _S553 : f32 = from_0.y;
    var _S554 : f32 = from_0.x;
    return vec2<f32>(_S553 + (to_0.y - _S553) * share_14, _S554 + (to_0.x - _S554) * share_14) * vec2<f32>(radius_6);
}

fn ThinLens_ray_0( this_61 : ThinLens_0,  position_3 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var place_9 : vec2<f32> = place_in_aperture_0(this_61.blades_3, lens_4);
    var offset_1 : vec3<f32> = this_61.lens_x_3 * vec3<f32>(place_9.x) + this_61.lens_y_3 * vec3<f32>(place_9.y);
    return ray_from_0(this_61.perspective_0.eye_4 + offset_1, normalize_vector_0(this_61.perspective_0.corner_4 + this_61.perspective_0.pixel_x_3 * vec3<f32>(position_3.x) + this_61.perspective_0.pixel_y_3 * vec3<f32>(position_3.y) - offset_1));
}

struct Orthographic_0
{
     corner_6 : vec3<f32>,
     pixel_x_5 : vec3<f32>,
     pixel_y_5 : vec3<f32>,
     forward_2 : vec3<f32>,
};

fn Orthographic_x24init_0( corner_7 : vec3<f32>,  pixel_x_6 : vec3<f32>,  pixel_y_6 : vec3<f32>,  forward_3 : vec3<f32>) -> Orthographic_0
{
    var _S555 : Orthographic_0;
    _S555.corner_6 = corner_7;
    _S555.pixel_x_5 = pixel_x_6;
    _S555.pixel_y_5 = pixel_y_6;
    _S555.forward_2 = forward_3;
    return _S555;
}

fn Orthographic_ray_0( this_62 : Orthographic_0,  position_4 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_62.corner_6 + this_62.pixel_x_5 * vec3<f32>(position_4.x) + this_62.pixel_y_5 * vec3<f32>(position_4.y), this_62.forward_2);
}

struct Panorama_0
{
     eye_6 : vec3<f32>,
     axes_1 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_7 : vec3<f32>,  axes_2 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S556 : Panorama_0;
    _S556.eye_6 = eye_7;
    _S556.axes_1 = axes_2;
    _S556.inverse_size_0 = inverse_size_1;
    _S556.half_eye_distance_0 = half_eye_distance_1;
    return _S556;
}

fn Panorama_ray_0( this_63 : Panorama_0,  position_5 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_5.y * this_63.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_6 : f32;
    if(is_right_eye_0)
    {
        side_6 = this_63.half_eye_distance_0;
    }
    else
    {
        side_6 = - this_63.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_5.x * this_63.inverse_size_0.x);
    var height_2 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S557 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S558 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_63.eye_6 + (this_63.axes_1.forward_0 * _S558 - this_63.axes_1.right_6 * _S557) * vec3<f32>(side_6), normalize_vector_0((vec3<f32>(0) - this_63.axes_1.forward_0 * _S557 + this_63.axes_1.right_6 * _S558) * vec3<f32>(height_2.x) + this_63.axes_1.up_0 * vec3<f32>(height_2.y)));
}

struct Fisheye_0
{
     eye_8 : vec3<f32>,
     axes_3 : Axes_0,
     middle_1 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_9 : vec3<f32>,  axes_4 : Axes_0,  middle_2 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S559 : Fisheye_0;
    _S559.eye_8 = eye_9;
    _S559.axes_3 = axes_4;
    _S559.middle_1 = middle_2;
    _S559.turns_per_pixel_0 = turns_per_pixel_1;
    return _S559;
}

fn Fisheye_ray_0( this_64 : Fisheye_0,  position_6 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    var x_10 : f32 = position_6.x - this_64.middle_1.x;
    var y_5 : f32 = position_6.y - this_64.middle_1.y;
    var radius_7 : f32 = square_root_0(x_10 * x_10 + y_5 * y_5);
    var sin_cos_5 : vec2<f32> = sincos_turns_0(min(radius_7 * this_64.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_7 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_5.x, radius_7);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_64.eye_8, normalize_vector_0(this_64.axes_3.forward_0 * vec3<f32>(sin_cos_5.y) + this_64.axes_3.right_6 * vec3<f32>((x_10 * scale_0)) - this_64.axes_3.up_0 * vec3<f32>((y_5 * scale_0))));
}

fn Perspective_ray_0( this_65 : Perspective_0,  position_7 : vec2<f32>,  lens_8 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_65.eye_4, normalize_vector_0(this_65.corner_4 + this_65.pixel_x_3 * vec3<f32>(position_7.x) + this_65.pixel_y_3 * vec3<f32>(position_7.y)));
}

fn CameraFrame_ray_0( this_66 : CameraFrame_0,  position_8 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_66.eye_2, this_66.corner_2, this_66.pixel_x_1, this_66.pixel_y_1);
    var axes_5 : Axes_0 = Axes_x24init_0(this_66.corner_2, this_66.pixel_x_1, this_66.pixel_y_1);
    switch(this_66.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_66.lens_x_1, this_66.lens_y_1, this_66.blades_1), position_8, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_66.corner_2, this_66.pixel_x_1, this_66.pixel_y_1, this_66.lens_x_1), position_8, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_66.eye_2, axes_5, this_66.lens_x_1.xy, this_66.lens_x_1.z), position_8, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_66.eye_2, axes_5, this_66.lens_x_1.xy, this_66.lens_x_1.z), position_8, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_8, lens_sample_0);
        }
    }
}

fn camera_ray_1( pixel_2 : vec2<u32>,  camera_0 : CameraFrame_0,  sampler_4 : Sampler_0) -> Ray_0
{
    var jitter_0 : vec4<f32> = PathTracingOf_jitter_0(sampler_4);
    return CameraFrame_ray_0(camera_0, vec2<f32>(pixel_2) + jitter_0.xy, jitter_0.zw);
}

fn WalkTracer_trace_0( ray_30 : ptr<function, Ray_0>,  is_any_enough_2 : bool) -> Hit_0
{
    var _S560 : Hit_0 = visit_0(&((*ray_30)), is_any_enough_2, u32(0));
    return _S560;
}

fn WalkTracer_trace_1( ray_31 : ptr<function, Ray_0>,  is_any_enough_3 : bool) -> Hit_0
{
    var _S561 : Hit_0 = visit_1(&((*ray_31)), is_any_enough_3, u32(0));
    return _S561;
}

fn set_scratch_row_0( row_13 : u32,  index_35 : u32,  value_3 : vec2<u32>)
{
    scratch_0[row_13 * real_time_0.slots_0 + index_35] = value_3;
    return;
}

fn set_words_0( slot_2 : u32,  words_3 : vec3<u32>)
{
    scratch_0[u32(8) * real_time_0.slots_0 + slot_2][i32(1)] = words_3.x;
    set_scratch_row_0(u32(9), slot_2, words_3.yz);
    return;
}

fn set_end_word_0( slot_3 : u32,  word_9 : u32)
{
    scratch_0[u32(4) * real_time_0.slots_0 + slot_3][i32(0)] = word_9;
    return;
}

fn keep_hit_0( slot_4 : u32,  hit_22 : Hit_0)
{
    set_words_0(slot_4, vec3<u32>(hit_22.voxel_0));
    set_end_word_0(slot_4, hit_22.instance_0);
    return;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, params_0.eye_1, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0, params_0.lens_x_0, params_0.lens_y_0, params_0.blades_0);
}

@compute
@workgroup_size(64, 1, 1)
fn trace_camera(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var item_1 : Item_0 = item_of_0(real_time_0.cells_0 + id_0.x);
    if(item_1.traces_0)
    {
        var ray_32 : Ray_0 = camera_ray_1(item_1.at_13, FrameParams_camera_0(), item_1.sampler_2);
        var _S562 : Hit_0 = WalkTracer_trace_1(&(ray_32), false);
        keep_hit_0(item_1.slot_0, _S562);
    }
    return;
}

fn Sample_x24init_0( direct_1 : vec3<f32>,  light_14 : vec3<f32>,  is_shown_1 : bool,  albedo_1 : vec3<f32>,  normal_7 : vec3<f32>,  place_10 : vec3<f32>,  instance_16 : u32) -> Sample_0
{
    var _S563 : Sample_0;
    _S563.direct_0 = direct_1;
    _S563.light_1 = light_14;
    _S563.is_shown_0 = is_shown_1;
    _S563.albedo_0 = albedo_1;
    _S563.normal_1 = normal_7;
    _S563.place_0 = place_10;
    _S563.instance_7 = instance_16;
    return _S563;
}

fn no_sample_0() -> Sample_0
{
    var _S564 : vec3<f32> = vec3<f32>(0.0f);
    return Sample_x24init_0(_S564, _S564, false, _S564, _S564, _S564, u32(4294967294));
}

fn Item_is_cell_0( this_67 : Item_0) -> bool
{
    return (this_67.kind_2) == u32(0);
}

fn Key_voxel_0( this_68 : Key_0,  code_5 : u32,  scramble_0 : u32) -> vec3<i32>
{
    var _S565 : u32 = Key_level_0(this_68);
    var bits_4 : u32 = ((u32(1) << (_S565))) - u32(1);
    var place_11 : u32 = ((code_5 - u32(1)) ^ (((scramble_0 & ((Key_mask_0(this_68)))))));
    return (((this_68.cube_0) << (vec3<u32>(u32(i32(_S565)))))) + vec3<i32>(i32((place_11 & (bits_4))), i32((((place_11 >> (_S565))) & (bits_4))), i32((((place_11 >> ((u32(2) * _S565)))) & (bits_4))));
}

fn Path_x24init_0( sampler_5 : Sampler_0,  bounce_4 : u32,  event_2 : u32,  kinds_1 : u32,  scattered_5 : u32,  beta_1 : vec3<f32>,  pdf_14 : f32,  normal_8 : vec3<f32>,  selection_5 : Selection_0,  passed_t_1 : f32,  inside_8 : Inside_0,  is_clipped_1 : bool) -> Path_0
{
    var _S566 : Path_0;
    _S566.sampler_0 = sampler_5;
    _S566.bounce_0 = bounce_4;
    _S566.event_0 = event_2;
    _S566.kinds_0 = kinds_1;
    _S566.scattered_0 = scattered_5;
    _S566.beta_0 = beta_1;
    _S566.pdf_1 = pdf_14;
    _S566.normal_0 = normal_8;
    _S566.selection_0 = selection_5;
    _S566.passed_t_0 = passed_t_1;
    _S566.inside_0 = inside_8;
    _S566.is_clipped_0 = is_clipped_1;
    return _S566;
}

fn path_from_0( sampler_6 : Sampler_0) -> Path_0
{
    return Path_x24init_0(sampler_6, u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
}

fn orthonormal_pair_0( z_1 : vec3<f32>,  x_11 : ptr<function, vec3<f32>>,  y_6 : ptr<function, vec3<f32>>)
{
    var _S567 : f32 = z_1.z;
    var sign_0 : f32;
    if(_S567 < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_7 : f32 = divide_0(-1.0f, sign_0 + _S567);
    var _S568 : f32 = z_1.x;
    var _S569 : f32 = z_1.y;
    var b_7 : f32 = _S568 * _S569 * a_7;
    (*x_11) = vec3<f32>(1.0f + sign_0 * _S568 * _S568 * a_7, sign_0 * b_7, - sign_0 * _S568);
    (*y_6) = vec3<f32>(b_7, sign_0 + _S569 * _S569 * a_7, - _S569);
    return;
}

fn direction_from_cell_0( sampler_7 : Sampler_0,  normal_9 : vec3<f32>,  pdf_15 : ptr<function, f32>) -> vec3<f32>
{
    var u_30 : vec4<f32> = Sampler_independent_0(sampler_7, u32(0));
    var x_12 : vec3<f32>;
    var y_7 : vec3<f32>;
    orthonormal_pair_0(normal_9, &(x_12), &(y_7));
    var local_7 : vec3<f32> = cosine_hemisphere_0(u_30.z, u_30.w);
    var _S570 : f32 = local_7.z;
    (*pdf_15) = cosine_hemisphere_pdf_0(_S570);
    return x_12 * vec3<f32>(local_7.x) + y_7 * vec3<f32>(local_7.y) + normal_9 * vec3<f32>(_S570);
}

fn direction_from_cell_1( sampler_8 : Sampler_0,  normal_10 : vec3<f32>,  pdf_16 : ptr<function, f32>) -> vec3<f32>
{
    var u_31 : vec4<f32> = Sampler_independent_0(sampler_8, u32(0));
    var x_13 : vec3<f32>;
    var y_8 : vec3<f32>;
    orthonormal_pair_0(normal_10, &(x_13), &(y_8));
    var local_8 : vec3<f32> = cosine_hemisphere_0(u_31.z, u_31.w);
    var _S571 : f32 = local_8.z;
    (*pdf_16) = cosine_hemisphere_pdf_0(_S571);
    return x_13 * vec3<f32>(local_8.x) + y_8 * vec3<f32>(local_8.y) + normal_10 * vec3<f32>(_S571);
}

fn Surface_x24init_0( origin_13 : vec3<f32>,  normal_11 : vec3<f32>,  face_11 : u32,  instance_17 : u32) -> Surface_0
{
    var _S572 : Surface_0;
    _S572.origin_11 = origin_13;
    _S572.normal_3 = normal_11;
    _S572.face_2 = face_11;
    _S572.instance_11 = instance_17;
    return _S572;
}

fn Walker_x24init_0( path_14 : Path_0,  ray_33 : Ray_0,  is_shadow_ray_1 : bool,  light_15 : vec3<f32>,  direction_30 : vec3<f32>,  path_origin_3 : vec3<f32>,  shadow_inside_3 : Inside_0,  boundaries_1 : u32,  relocates_3 : bool,  path_relocates_3 : bool,  camera_ray_2 : Ray_0,  way_7 : f32,  has_shown_1 : bool,  asks_cache_1 : bool,  life_3 : u32,  is_at_cell_1 : bool,  counts_1 : bool,  sees_mover_1 : bool,  by_chance_2 : bool) -> Walker_0
{
    var _S573 : Walker_0;
    _S573.path_0 = path_14;
    _S573.ray_7 = ray_33;
    _S573.is_shadow_ray_0 = is_shadow_ray_1;
    _S573.light_0 = light_15;
    _S573.direction_4 = direction_30;
    _S573.path_origin_0 = path_origin_3;
    _S573.shadow_inside_0 = shadow_inside_3;
    _S573.boundaries_0 = boundaries_1;
    _S573.relocates_0 = relocates_3;
    _S573.path_relocates_0 = path_relocates_3;
    _S573.camera_ray_0 = camera_ray_2;
    _S573.way_3 = way_7;
    _S573.has_shown_0 = has_shown_1;
    _S573.asks_cache_0 = asks_cache_1;
    _S573.life_0 = life_3;
    _S573.is_at_cell_0 = is_at_cell_1;
    _S573.counts_0 = counts_1;
    _S573.sees_mover_0 = sees_mover_1;
    _S573.by_chance_0 = by_chance_2;
    return _S573;
}

fn at_cell_0( key_5 : Key_0,  rank_7 : u32,  sampler_9 : Sampler_0) -> Walker_0
{
    var face_12 : u32 = ((key_5.face_and_level_0) & (u32(7)));
    var axis_7 : u32 = (face_12 >> (u32(1)));
    var u_32 : vec4<f32> = Sampler_independent_0(sampler_9, u32(0));
    var _S574 : vec3<f32> = vec3<f32>(Key_voxel_0(key_5, (rank_7 & (u32(1048575))), scramble_of_0(real_time_0.number_0 - u32(1))));
    var on_face_2 : vec3<f32>;
    if(axis_7 == u32(0))
    {
        on_face_2 = vec3<f32>(0.0f, u_32.x, u_32.y);
    }
    else
    {
        if(axis_7 == u32(1))
        {
            on_face_2 = vec3<f32>(u_32.y, 0.0f, u_32.x);
        }
        else
        {
            on_face_2 = vec3<f32>(u_32.x, u_32.y, 0.0f);
        }
    }
    var _S575 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(key_5.instance_9);
    var origin_14 : vec3<f32> = Transform_point_0(_S575.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S575.grid_from_world_0.translation_0), _S574, face_12, _S574 + on_face_2));
    var normal_12 : vec3<f32> = world_normal_0(_S575, face_12);
    var path_15 : Path_0 = path_from_0(sampler_9);
    var _S576 : f32 = path_15.pdf_1;
    var direction_31 : vec3<f32> = direction_from_cell_0(sampler_9, normal_12, &(_S576));
    path_15.pdf_1 = _S576;
    var receiver_30 : Receiver_0 = Receiver_x24init_0(origin_14, normal_12);
    path_15.selection_0 = Lights_selection_0(receiver_30);
    path_15.normal_0 = normal_12;
    var surface_6 : Surface_0 = Surface_x24init_0(origin_14, normal_12, face_12, key_5.instance_9);
    var white_0 : MaterialBsdf_0;
    white_0.kind_0 = u32(0);
    white_0.color_0 = vec3<f32>(1.0f);
    white_0.specular_1 = 0.0f;
    white_0.eta_0 = 1.0f;
    white_0.facets_0.alpha_0 = 1.0f;
    scatter_of_path_0 = Scatter_x24init_0(path_15, receiver_30, surface_6, white_0, vec3<f32>(0.0f, 0.0f, 1.0f), 1.0f, false, true);
    var ray_34 : Ray_0 = ray_from_0(origin_14, direction_31);
    return Walker_x24init_0(path_15, ray_34, false, vec3<f32>(0.0f), direction_31, origin_14, in_air_0(), u32(0), false, false, ray_34, 0.0f, true, true, max((rank_7 >> (u32(20))), u32(1)) - u32(1), true, false, false, false);
}

fn camera_before_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, real_time_0.before_eye_0, real_time_0.before_corner_0, real_time_0.before_pixel_x_0, real_time_0.before_pixel_y_0, real_time_0.before_lens_x_0, real_time_0.before_lens_y_0, real_time_0.before_blades_0);
}

fn Item_asks_cache_0( this_69 : Item_0) -> bool
{
    var _S577 : bool;
    if(Item_is_cell_0(this_69))
    {
        _S577 = true;
    }
    else
    {
        if((this_69.kind_2) == u32(1))
        {
            _S577 = has_0(u32(1));
        }
        else
        {
            _S577 = false;
        }
    }
    return _S577;
}

fn at_camera_0( ray_35 : Ray_0,  sampler_10 : Sampler_0,  asks_cache_2 : bool) -> Walker_0
{
    var _S578 : vec3<f32> = vec3<f32>(0.0f);
    return Walker_x24init_0(path_from_0(sampler_10), ray_35, false, _S578, _S578, _S578, in_air_0(), u32(0), true, true, ray_35, 0.0f, false, asks_cache_2, u32(10), false, false, false, false);
}

fn Item_start_0( this_70 : Item_0) -> Walker_0
{
    if(Item_is_cell_0(this_70))
    {
        var rank_8 : u32;
        var key_6 : Key_0 = Item_key_1(this_70, &(rank_8));
        var _S579 : Walker_0 = at_cell_0(key_6, rank_8, this_70.sampler_2);
        return _S579;
    }
    var _S580 : CameraFrame_0 = FrameParams_camera_0();
    var camera_1 : CameraFrame_0;
    if((this_70.kind_2) == u32(3))
    {
        camera_1 = camera_before_0();
    }
    else
    {
        camera_1 = _S580;
    }
    return at_camera_0(camera_ray_1(this_70.at_13, camera_1, this_70.sampler_2), this_70.sampler_2, Item_asks_cache_0(this_70));
}

fn scratch_row_0( row_14 : u32,  index_36 : u32) -> vec2<u32>
{
    return scratch_0[row_14 * real_time_0.slots_0 + index_36];
}

fn end_word_0( slot_5 : u32) -> u32
{
    return scratch_row_0(u32(4), slot_5).x;
}

fn words_in_0( slot_6 : u32) -> vec3<u32>
{
    return vec3<u32>(scratch_row_0(u32(8), slot_6).y, scratch_row_0(u32(9), slot_6));
}

fn hit_of_0( ray_36 : LocalRay_0,  voxel_26 : vec3<i32>,  instance_18 : u32) -> Hit_0
{
    return hit_at_0(crossing_among_0(LocalRay_mirrored_origin_0(ray_36), abs(ray_36.direction_1), select(voxel_26, ~voxel_26, (ray_36.direction_1) < vec3<f32>(0.0f)), false), ray_36.t_min_1, abs(ray_36.inverse_0), voxel_26, instance_18, LocalRay_octant_0(ray_36));
}

fn hit_in_slot_0( slot_7 : u32,  ray_37 : Ray_0) -> Hit_0
{
    var instance_19 : u32 = end_word_0(slot_7);
    if(instance_19 == u32(4294967295))
    {
        return miss_0();
    }
    return hit_of_0(local_ray_0(ray_37, Instances_operatorx5Bx5D_get_0(instance_19).grid_from_world_0), vec3<i32>(words_in_0(slot_7)), instance_19);
}

struct Slot_0
{
     item_2 : Item_0,
     own_5 : u32,
     lent_0 : u32,
};

fn Slot_x24init_0( item_3 : Item_0,  own_6 : u32,  lent_1 : u32) -> Slot_0
{
    var _S581 : Slot_0;
    _S581.item_2 = item_3;
    _S581.own_5 = own_6;
    _S581.lent_0 = lent_1;
    return _S581;
}

fn lets_light_pass_0( material_18 : PackedMaterial_0) -> bool
{
    var _S582 : bool;
    if((material_18.transmission_0) > 0.0f)
    {
        if((material_18.ior_0) == 1.0f)
        {
            _S582 = true;
        }
        else
        {
            _S582 = (params_0.clear_shadows_0) != u32(0);
        }
    }
    else
    {
        _S582 = false;
    }
    return _S582;
}

fn is_matte_0( material_19 : PackedMaterial_0) -> bool
{
    var _S583 : bool;
    if((material_19.transmission_0) <= 0.0f)
    {
        _S583 = (material_19.metallic_0) <= 0.0f;
    }
    else
    {
        _S583 = false;
    }
    if(_S583)
    {
        _S583 = (material_19.specular_0) <= 0.0f;
    }
    else
    {
        _S583 = false;
    }
    return _S583;
}

fn leaves_0( hit_23 : Hit_0,  is_shadow_ray_2 : bool) -> bool
{
    var _S584 : bool;
    if(!has_0(u32(1024)))
    {
        _S584 = true;
    }
    else
    {
        _S584 = Hit_is_miss_0(hit_23);
    }
    if(_S584)
    {
        return false;
    }
    var material_20 : PackedMaterial_0 = material_of_0(hit_23);
    if(is_shadow_ray_2)
    {
        _S584 = lets_light_pass_0(material_20);
    }
    else
    {
        _S584 = !is_matte_0(material_20);
    }
    return _S584;
}

fn set_left_0( slot_8 : u32)
{
    scratch_0[u32(7) * real_time_0.slots_0 + slot_8][i32(0)] = u32(4294967294);
    return;
}

fn asks_2( path_16 : Path_0,  ray_38 : Ray_0,  hit_24 : Hit_0,  beyond_14 : u32,  life_4 : u32,  light_16 : ptr<function, vec3<f32>>) -> bool
{
    (*light_16) = vec3<f32>(0.0f);
    var _S585 : bool;
    if(Hit_is_miss_0(hit_24))
    {
        _S585 = true;
    }
    else
    {
        _S585 = Inside_is_in_0(path_16.inside_0);
    }
    if(_S585)
    {
        return false;
    }
    var material_21 : PackedMaterial_0 = material_met_0(path_16, hit_24, beyond_14);
    if((material_21.metallic_0) > 0.0f)
    {
        _S585 = true;
    }
    else
    {
        _S585 = (material_21.transmission_0) > 0.0f;
    }
    if(_S585)
    {
        return false;
    }
    var code_6 : u32;
    var key_7 : Key_0 = key_of_1(hit_24, square_root_0(length_squared_0(ray_38.origin_0 + ray_38.direction_0 * vec3<f32>(hit_24.t_0) - real_time_0.eye_0)) * real_time_0.view_angle_0 * 0.05882352963089943f, Sampler_independent_0(path_16.sampler_0, u32(3221225472) + Path_events_0(path_16)).x, &(code_6));
    var _S586 : f32 = f32((u32(1) << ((Key_level_0(key_7)))));
    var is_from_first_2 : bool = (path_16.bounce_0) < u32(2);
    if(life_4 == u32(0))
    {
        _S585 = true;
    }
    else
    {
        if(is_from_first_2)
        {
            _S585 = (hit_24.t_0 * square_root_0(length_squared_0(ray_38.direction_0))) < _S586;
        }
        else
        {
            _S585 = false;
        }
    }
    if(_S585)
    {
        return false;
    }
    var known_4 : vec4<f32> = ask_cell_0(key_7, ((((min(life_4, u32(10))) << (u32(20)))) | (code_6)));
    if((known_4.w) <= 0.0f)
    {
        return false;
    }
    (*light_16) = path_16.beta_0 * vector_of_0(material_21.base_color_0) * known_4.xyz;
    return true;
}

fn packed_normal_0( normal_13 : vec3<f32>) -> u32
{
    var _S587 : vec3<i32> = vec3<i32>(normal_steps_0(normal_13));
    return (((((u32(_S587.x) & (u32(1023)))) | (((((u32(_S587.y) & (u32(1023)))) << (u32(10))))))) | (((((u32(_S587.z) & (u32(1023)))) << (u32(20))))));
}

fn store_sample_0( index_37 : u32,  sample_24 : Sample_0)
{
    var _S588 : u32 = packed_normal_0(sample_24.normal_1);
    var _S589 : u32;
    if(sample_24.is_shown_0)
    {
        _S589 = u32(1073741824);
    }
    else
    {
        _S589 = u32(0);
    }
    var normal_14 : u32 = (_S588 | (_S589));
    set_scratch_row_0(u32(0), index_37, (bitcast<vec2<u32>>((sample_24.light_1.xy))));
    set_scratch_row_0(u32(1), index_37, vec2<u32>((bitcast<u32>((sample_24.light_1.z))), sample_24.instance_7));
    set_scratch_row_0(u32(2), index_37, (bitcast<vec2<u32>>((sample_24.direct_0.xy))));
    set_scratch_row_0(u32(3), index_37, (bitcast<vec2<u32>>((vec2<f32>(sample_24.direct_0.z, sample_24.place_0.x)))));
    set_scratch_row_0(u32(4), index_37, (bitcast<vec2<u32>>((sample_24.place_0.yz))));
    set_scratch_row_0(u32(5), index_37, (bitcast<vec2<u32>>((sample_24.albedo_0.xy))));
    set_scratch_row_0(u32(6), index_37, vec2<u32>((bitcast<u32>((sample_24.albedo_0.z))), normal_14));
    return;
}

fn Slot_keep_0( this_71 : Slot_0,  at_19 : Walker_0,  instance_20 : u32,  face_13 : u32)
{
    var word_10 : u32 = (((((instance_20 << (u32(5)))) | ((((at_19.path_0.bounce_0) << (u32(3))))))) | (face_13));
    var _S590 : u32;
    if(at_19.is_shadow_ray_0)
    {
        _S590 = (bitcast<u32>((at_19.ray_7.t_max_0)));
    }
    else
    {
        _S590 = u32(0);
    }
    set_scratch_row_0(u32(4), this_71.own_5, vec2<u32>(_S590, word_10));
    set_scratch_row_0(u32(7), this_71.own_5, (bitcast<vec2<u32>>((at_19.ray_7.origin_0.xy))));
    set_scratch_row_0(u32(8), this_71.own_5, (bitcast<vec2<u32>>((vec2<f32>(at_19.ray_7.origin_0.z, at_19.ray_7.direction_0.x)))));
    set_scratch_row_0(u32(9), this_71.own_5, (bitcast<vec2<u32>>((at_19.ray_7.direction_0.yz))));
    return;
}

fn Slot_keep_first_0( this_72 : Slot_0,  at_20 : Walker_0,  instance_21 : u32,  face_14 : u32,  t_18 : f32,  sample_25 : Sample_0)
{
    var _S591 : Sample_0 = sample_25;
    _S591.light_1 = vec3<f32>(0.0f);
    _S591.albedo_0 = at_20.path_0.beta_0;
    store_sample_0(this_72.own_5, _S591);
    scratch_0[u32(3) * real_time_0.slots_0 + this_72.own_5][i32(1)] = (bitcast<u32>((t_18)));
    Slot_keep_0(this_72, at_20, instance_21, face_14);
    return;
}

fn light_on_0( sample_26 : Sample_0) -> f32
{
    var _S592 : f32;
    if(sample_26.is_shown_0)
    {
        _S592 = luminance_0(sample_26.light_1) / (luminance_0(sample_26.albedo_0) + 0.00300000002607703f);
    }
    else
    {
        _S592 = 0.0f;
    }
    return _S592;
}

fn Item_end_0( this_73 : Item_0,  sample_27 : Sample_0)
{
    if(Item_is_cell_0(this_73))
    {
        set_cell_row_0(u32(3), this_73.place_7, vec4<u32>((bitcast<vec3<u32>>((sample_27.light_1))), u32(1)));
    }
    else
    {
        if((this_73.kind_2) == u32(1))
        {
            store_sample_0(this_73.place_7, sample_27);
        }
        else
        {
            memory_rows_0[this_73.place_7] = vec4<u32>((bitcast<vec3<u32>>((sample_27.place_0))), (bitcast<u32>((light_on_0(sample_27)))));
        }
    }
    return;
}

fn set_over_0( slot_9 : u32)
{
    scratch_0[u32(7) * real_time_0.slots_0 + slot_9][i32(0)] = u32(4294967295);
    return;
}

fn Slot_end_0( this_74 : Slot_0,  sample_28 : Sample_0)
{
    Item_end_0(this_74.item_2, sample_28);
    set_over_0(this_74.own_5);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_first(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var item_4 : Item_0 = item_of_0(id_1.x);
    if(item_4.traces_0)
    {
        scatter_of_path_0.wants_light_0 = false;
        var sample_29 : Sample_0 = no_sample_0();
        var _S593 : Walker_0 = Item_start_0(item_4);
        var at_21 : Walker_0 = _S593;
        var _S594 : Hit_0 = miss_0();
        var hit_25 : Hit_0;
        var instance_22 : u32;
        var face_15 : u32;
        if(Item_is_cell_0(item_4))
        {
            var rank_9 : u32;
            var key_8 : Key_0 = Item_key_2(item_4, &(rank_9));
            var _S595 : u32 = ((key_8.face_and_level_0) & (u32(7)));
            hit_25 = _S594;
            instance_22 = key_8.instance_9;
            face_15 = _S595;
        }
        else
        {
            var hit_26 : Hit_0 = hit_in_slot_0(item_4.slot_0, at_21.ray_7);
            hit_25 = hit_26;
            instance_22 = hit_26.instance_0;
            face_15 = hit_26.face_0;
        }
        var _S596 : u32 = item_4.slot_0;
        var slot_10 : Slot_0 = Slot_x24init_0(item_4, _S596, _S596);
        if(leaves_0(hit_25, false))
        {
            set_left_0(item_4.slot_0);
        }
        else
        {
            var _S597 : bool = goes_on_from_2(&(at_21), hit_25, u32(4294967295), &(sample_29));
            if(_S597)
            {
                Slot_keep_first_0(slot_10, at_21, instance_22, face_15, hit_25.t_0, sample_29);
            }
            else
            {
                Slot_end_0(slot_10, sample_29);
            }
        }
    }
    return;
}

fn is_over_0( slot_11 : u32) -> bool
{
    return (scratch_row_0(u32(7), slot_11).x) >= u32(4294967294);
}

fn weigh_candidates_0( is_of_pixel_0 : bool,  pixel_3 : u32,  counts_2 : bool)
{
    var _S598 : bool;
    if(is_of_pixel_0)
    {
        _S598 = has_0(u32(4096));
    }
    else
    {
        _S598 = false;
    }
    weighs_candidates_0 = _S598;
    counts_arrivals_0 = false;
    if(_S598)
    {
        _S598 = counts_2;
    }
    else
    {
        _S598 = false;
    }
    if(_S598)
    {
        var stride_2 : u32 = (real_time_0.pixels_0 + u32(32768) - u32(1)) / u32(32768);
        var _S599 : u32 = pixel_3 / stride_2;
        var _S600 : u32 = (pixel_3 + u32(7) * _S599 + real_time_0.number_0) % stride_2;
        counts_arrivals_0 = _S600 == u32(0);
    }
    return;
}

fn origin_in_0( slot_12 : u32) -> vec3<f32>
{
    return vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(7), slot_12)))), (bitcast<f32>((scratch_row_0(u32(8), slot_12).x))));
}

fn Slot_face_word_0( this_75 : Slot_0) -> u32
{
    return scratch_row_0(u32(4), this_75.own_5).y;
}

fn Slot_face_0( this_76 : Slot_0) -> u32
{
    return ((Slot_face_word_0(this_76)) & (u32(7)));
}

fn Slot_instance_0( this_77 : Slot_0) -> u32
{
    return ((Slot_face_word_0(this_77)) >> (u32(5)));
}

fn Slot_scatter_0( this_78 : Slot_0) -> Scatter_0
{
    var surface_7 : Surface_0;
    var _S601 : vec3<f32> = origin_in_0(this_78.own_5);
    surface_7.origin_11 = _S601;
    var _S602 : u32 = Slot_face_0(this_78);
    surface_7.face_2 = _S602;
    var _S603 : u32 = Slot_instance_0(this_78);
    surface_7.instance_11 = _S603;
    var _S604 : vec3<f32> = world_normal_0(Instances_operatorx5Bx5D_get_0(_S603), _S602);
    surface_7.normal_3 = _S604;
    var receiver_31 : Receiver_0 = Receiver_x24init_0(_S601, _S604);
    var path_17 : Path_0 = path_from_0(this_78.item_2.sampler_2);
    path_17.selection_0 = Lights_selection_0(receiver_31);
    var bsdf_2 : MaterialBsdf_0;
    bsdf_2.kind_0 = u32(0);
    bsdf_2.color_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(5), this_78.own_5)))), (bitcast<f32>((scratch_row_0(u32(6), this_78.own_5).x))));
    bsdf_2.specular_1 = 0.0f;
    bsdf_2.eta_0 = 1.0f;
    bsdf_2.facets_0.alpha_0 = 1.0f;
    return Scatter_x24init_0(path_17, receiver_31, surface_7, bsdf_2, vec3<f32>(0.0f, 0.0f, 1.0f), 1.0f, false, true);
}

fn Slot_keep_light_0( this_79 : Slot_0,  next_8 : NextRays_0)
{
    if(next_8.has_shadow_ray_0)
    {
        set_scratch_row_0(u32(0), this_79.own_5, (bitcast<vec2<u32>>((next_8.light_2.xy))));
        scratch_0[real_time_0.slots_0 + this_79.own_5][i32(0)] = (bitcast<u32>((next_8.light_2.z)));
        set_end_word_0(this_79.own_5, (bitcast<u32>((next_8.shadow_t_max_0))));
        set_words_0(this_79.own_5, (bitcast<vec3<u32>>((next_8.shadow_direction_0))));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_light(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var item_5 : Item_0 = item_of_0(id_2.x);
    var _S605 : u32 = item_5.slot_0;
    var slot_13 : Slot_0 = Slot_x24init_0(item_5, _S605, _S605);
    var _S606 : bool;
    if(item_5.traces_0)
    {
        _S606 = !is_over_0(item_5.slot_0);
    }
    else
    {
        _S606 = false;
    }
    if(_S606)
    {
        first_candidates_0 = real_time_0.candidates_0;
        weigh_candidates_0((item_5.kind_2) == u32(1), item_5.place_7, false);
        var next_9 : NextRays_0 = no_rays_0();
        choose_light_1(Slot_scatter_0(slot_13), &(next_9));
        Slot_keep_light_0(slot_13, next_9);
    }
    return;
}

fn Slot_bounce_0( this_80 : Slot_0) -> u32
{
    return ((((Slot_face_word_0(this_80)) >> (u32(3)))) & (u32(3)));
}

fn Slot_ray_0( this_81 : Slot_0,  pdf_17 : ptr<function, f32>) -> Ray_0
{
    var _S607 : bool;
    if(Item_is_cell_0(this_81.item_2))
    {
        _S607 = (Slot_bounce_0(this_81)) == u32(1);
    }
    else
    {
        _S607 = false;
    }
    var direction_32 : vec3<f32>;
    if(_S607)
    {
        var _S608 : vec3<f32> = direction_from_cell_1(this_81.item_2.sampler_2, world_normal_0(Instances_operatorx5Bx5D_get_0(Slot_instance_0(this_81)), Slot_face_0(this_81)), &((*pdf_17)));
        direction_32 = _S608;
    }
    else
    {
        var surface_8 : Surface_0;
        surface_8.face_2 = Slot_face_0(this_81);
        surface_8.instance_11 = Slot_instance_0(this_81);
        var u_33 : vec4<f32> = Sampler_stratified_0(this_81.item_2.sampler_2, u32(2) * Slot_bounce_0(this_81) - u32(1));
        var wi_8 : vec3<f32> = cosine_hemisphere_0(u_33.x, u_33.y);
        (*pdf_17) = cosine_hemisphere_pdf_0(wi_8.z);
        direction_32 = Surface_world_direction_0(surface_8, wi_8);
    }
    return ray_from_0(origin_in_0(this_81.own_5), direction_32);
}

fn Slot_ray_1( this_82 : Slot_0,  pdf_18 : ptr<function, f32>) -> Ray_0
{
    var _S609 : bool;
    if(Item_is_cell_0(this_82.item_2))
    {
        _S609 = (Slot_bounce_0(this_82)) == u32(1);
    }
    else
    {
        _S609 = false;
    }
    var direction_33 : vec3<f32>;
    if(_S609)
    {
        var _S610 : vec3<f32> = direction_from_cell_1(this_82.item_2.sampler_2, world_normal_0(Instances_operatorx5Bx5D_get_0(Slot_instance_0(this_82)), Slot_face_0(this_82)), &((*pdf_18)));
        direction_33 = _S610;
    }
    else
    {
        var surface_9 : Surface_0;
        surface_9.face_2 = Slot_face_0(this_82);
        surface_9.instance_11 = Slot_instance_0(this_82);
        var u_34 : vec4<f32> = Sampler_stratified_0(this_82.item_2.sampler_2, u32(2) * Slot_bounce_0(this_82) - u32(1));
        var wi_9 : vec3<f32> = cosine_hemisphere_0(u_34.x, u_34.y);
        (*pdf_18) = cosine_hemisphere_pdf_0(wi_9.z);
        direction_33 = Surface_world_direction_0(surface_9, wi_9);
    }
    return ray_from_0(origin_in_0(this_82.own_5), direction_33);
}

fn place_of_found_0( place_12 : u32) -> u32
{
    return place_of_known_0(place_12) + u32(131072);
}

fn count_arrival_0( ray_39 : Ray_0,  has_arrived_0 : bool)
{
    var _S611 : i32;
    if(has_arrived_0)
    {
        _S611 = i32(65537);
    }
    else
    {
        _S611 = i32(1);
    }
    var _S612 : u32 = atomicAdd(&(cell_keys_0[place_of_found_0(place_of_ray_0(ray_39))]), u32(_S611));
    return;
}

fn Slot_darken_0( this_83 : Slot_0)
{
    if((Slot_bounce_0(this_83)) == u32(1))
    {
        set_scratch_row_0(u32(0), this_83.own_5, vec2<u32>(vec2<i32>(i32(0))));
        scratch_0[real_time_0.slots_0 + this_83.own_5][i32(0)] = u32(0);
    }
    else
    {
        scratch_0[u32(8) * real_time_0.slots_0 + this_83.lent_0][i32(1)] = u32(0);
        set_scratch_row_0(u32(9), this_83.lent_0, vec2<u32>(vec2<i32>(i32(0))));
    }
    return;
}

fn Slot_walk_0( this_84 : Slot_0)
{
    var end_5 : u32 = end_word_0(this_84.own_5);
    var pdf_19 : f32;
    var ray_40 : Ray_0 = Ray_x24init_0(origin_in_0(this_84.own_5), 0.0f, (bitcast<vec3<f32>>((words_in_0(this_84.own_5)))), (bitcast<f32>((end_5))));
    var _S613 : i32;
    if(end_5 == u32(0))
    {
        _S613 = i32(1);
    }
    else
    {
        _S613 = i32(0);
    }
    var turn_0 : u32 = u32(_S613);
    for(;;)
    {
        if(turn_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S614 : bool = turn_0 == u32(1);
        if(_S614)
        {
            ray_40 = Slot_ray_0(this_84, &(pdf_19));
        }
        var _S615 : bool = turn_0 == u32(0);
        var ends_anywhere_0 : bool;
        if(_S615)
        {
            if(counts_arrivals_0)
            {
                ends_anywhere_0 = has_0(u32(1024));
            }
            else
            {
                ends_anywhere_0 = false;
            }
            ends_anywhere_0 = !ends_anywhere_0;
        }
        else
        {
            ends_anywhere_0 = false;
        }
        var _S616 : Hit_0 = WalkTracer_trace_0(&(ray_40), ends_anywhere_0);
        var _S617 : bool;
        if(_S615)
        {
            _S617 = leaves_0(_S616, true);
        }
        else
        {
            _S617 = false;
        }
        if(_S617)
        {
            set_left_0(this_84.own_5);
            return;
        }
        var _S618 : bool;
        if(_S615)
        {
            _S618 = counts_arrivals_0;
        }
        else
        {
            _S618 = false;
        }
        var _S619 : bool;
        if(_S618)
        {
            _S619 = (Slot_bounce_0(this_84)) == u32(1);
        }
        else
        {
            _S619 = false;
        }
        if(_S619)
        {
            count_arrival_0(ray_40, Hit_is_miss_0(_S616));
        }
        if(_S614)
        {
            keep_hit_0(this_84.own_5, _S616);
        }
        else
        {
            if(!Hit_is_miss_0(_S616))
            {
                Slot_darken_0(this_84);
            }
        }
        turn_0 = turn_0 + u32(1);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_rays(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var slot_14 : Slot_0;
    var _S620 : Item_0 = item_of_0(id_3.x);
    slot_14.item_2 = _S620;
    slot_14.own_5 = slot_14.item_2.slot_0;
    slot_14.lent_0 = slot_14.item_2.slot_0;
    var _S621 : bool;
    if(slot_14.item_2.traces_0)
    {
        _S621 = !is_over_0(slot_14.own_5);
    }
    else
    {
        _S621 = false;
    }
    if(_S621)
    {
        weigh_candidates_0((slot_14.item_2.kind_2) == u32(1), slot_14.item_2.place_7, true);
        Slot_walk_0(slot_14);
    }
    return;
}

fn normal_in_0( word_11 : u32) -> vec3<f32>
{
    return vec3<f32>(vec3<i32>((i32((word_11 << (u32(22)))) >> (u32(22))), (i32((word_11 << (u32(12)))) >> (u32(22))), (i32((word_11 << (u32(2)))) >> (u32(22))))) * vec3<f32>(0.00195694714784622f);
}

fn load_sample_0( index_38 : u32) -> Sample_0
{
    var b_8 : vec2<u32> = scratch_row_0(u32(1), index_38);
    var d_3 : vec2<f32> = (bitcast<vec2<f32>>((scratch_row_0(u32(3), index_38))));
    var g_0 : vec2<u32> = scratch_row_0(u32(6), index_38);
    var sample_30 : Sample_0;
    sample_30.light_1 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(0), index_38)))), (bitcast<f32>((b_8.x))));
    sample_30.instance_7 = b_8.y;
    sample_30.direct_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(2), index_38)))), d_3.x);
    sample_30.place_0 = vec3<f32>(d_3.y, (bitcast<vec2<f32>>((scratch_row_0(u32(4), index_38)))));
    sample_30.albedo_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(5), index_38)))), (bitcast<f32>((g_0.x))));
    var _S622 : u32 = g_0.y;
    sample_30.normal_1 = normal_in_0(_S622);
    sample_30.is_shown_0 = ((_S622 & (u32(1073741824)))) != u32(0);
    return sample_30;
}

fn Slot_walker_0( this_85 : Slot_0,  sample_31 : ptr<function, Sample_0>) -> Walker_0
{
    (*sample_31) = load_sample_0(this_85.own_5);
    var bounce_5 : u32 = Slot_bounce_0(this_85);
    var at_22 : Walker_0;
    at_22.path_0 = path_from_0(this_85.item_2.sampler_2);
    at_22.path_0.bounce_0 = bounce_5;
    at_22.path_0.event_0 = bounce_5;
    at_22.path_0.scattered_0 = bounce_5;
    at_22.path_0.beta_0 = (*sample_31).albedo_0;
    if(bounce_5 > u32(1))
    {
        at_22.path_0.beta_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(7), this_85.lent_0)))), (bitcast<f32>((scratch_row_0(u32(8), this_85.lent_0).x))));
        (*sample_31).light_1 = (*sample_31).light_1 + vec3<f32>((bitcast<f32>((scratch_row_0(u32(8), this_85.lent_0).y))), (bitcast<vec2<f32>>((scratch_row_0(u32(9), this_85.lent_0)))));
    }
    var _S623 : f32 = at_22.path_0.pdf_1;
    var _S624 : Ray_0 = Slot_ray_1(this_85, &(_S623));
    at_22.path_0.pdf_1 = _S623;
    at_22.ray_7 = _S624;
    at_22.path_0.normal_0 = world_normal_0(Instances_operatorx5Bx5D_get_0(Slot_instance_0(this_85)), Slot_face_0(this_85));
    at_22.is_shadow_ray_0 = false;
    at_22.light_0 = vec3<f32>(0.0f);
    at_22.direction_4 = at_22.ray_7.direction_0;
    at_22.path_origin_0 = at_22.ray_7.origin_0;
    at_22.shadow_inside_0 = in_air_0();
    at_22.boundaries_0 = u32(0);
    at_22.relocates_0 = false;
    at_22.path_relocates_0 = false;
    at_22.camera_ray_0 = _S624;
    at_22.way_3 = 0.0f;
    at_22.has_shown_0 = true;
    at_22.asks_cache_0 = Item_asks_cache_0(this_85.item_2);
    at_22.life_0 = u32(10);
    at_22.is_at_cell_0 = false;
    at_22.counts_0 = false;
    at_22.sees_mover_0 = false;
    at_22.by_chance_0 = false;
    if(Item_is_cell_0(this_85.item_2))
    {
        var rank_10 : u32;
        var _S625 : Key_0 = Item_key_2(this_85.item_2, &(rank_10));
        at_22.life_0 = max((rank_10 >> (u32(20))), u32(1)) - u32(1);
    }
    else
    {
        var ray_41 : Ray_0 = camera_ray_1(this_85.item_2.at_13, FrameParams_camera_0(), this_85.item_2.sampler_2);
        (*sample_31).place_0 = ray_41.origin_0 + ray_41.direction_0 * vec3<f32>((bitcast<f32>((scratch_row_0(u32(3), this_85.own_5).y))));
    }
    return at_22;
}

fn Slot_walker_1( this_86 : Slot_0,  sample_32 : ptr<function, Sample_0>) -> Walker_0
{
    (*sample_32) = load_sample_0(this_86.own_5);
    var bounce_6 : u32 = Slot_bounce_0(this_86);
    var at_23 : Walker_0;
    at_23.path_0 = path_from_0(this_86.item_2.sampler_2);
    at_23.path_0.bounce_0 = bounce_6;
    at_23.path_0.event_0 = bounce_6;
    at_23.path_0.scattered_0 = bounce_6;
    at_23.path_0.beta_0 = (*sample_32).albedo_0;
    if(bounce_6 > u32(1))
    {
        at_23.path_0.beta_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(7), this_86.lent_0)))), (bitcast<f32>((scratch_row_0(u32(8), this_86.lent_0).x))));
        (*sample_32).light_1 = (*sample_32).light_1 + vec3<f32>((bitcast<f32>((scratch_row_0(u32(8), this_86.lent_0).y))), (bitcast<vec2<f32>>((scratch_row_0(u32(9), this_86.lent_0)))));
    }
    var _S626 : f32 = at_23.path_0.pdf_1;
    var _S627 : Ray_0 = Slot_ray_1(this_86, &(_S626));
    at_23.path_0.pdf_1 = _S626;
    at_23.ray_7 = _S627;
    at_23.path_0.normal_0 = world_normal_0(Instances_operatorx5Bx5D_get_0(Slot_instance_0(this_86)), Slot_face_0(this_86));
    at_23.is_shadow_ray_0 = false;
    at_23.light_0 = vec3<f32>(0.0f);
    at_23.direction_4 = at_23.ray_7.direction_0;
    at_23.path_origin_0 = at_23.ray_7.origin_0;
    at_23.shadow_inside_0 = in_air_0();
    at_23.boundaries_0 = u32(0);
    at_23.relocates_0 = false;
    at_23.path_relocates_0 = false;
    at_23.camera_ray_0 = _S627;
    at_23.way_3 = 0.0f;
    at_23.has_shown_0 = true;
    at_23.asks_cache_0 = Item_asks_cache_0(this_86.item_2);
    at_23.life_0 = u32(10);
    at_23.is_at_cell_0 = false;
    at_23.counts_0 = false;
    at_23.sees_mover_0 = false;
    at_23.by_chance_0 = false;
    if(Item_is_cell_0(this_86.item_2))
    {
        var rank_11 : u32;
        var _S628 : Key_0 = Item_key_2(this_86.item_2, &(rank_11));
        at_23.life_0 = max((rank_11 >> (u32(20))), u32(1)) - u32(1);
    }
    else
    {
        var ray_42 : Ray_0 = camera_ray_1(this_86.item_2.at_13, FrameParams_camera_0(), this_86.item_2.sampler_2);
        (*sample_32).place_0 = ray_42.origin_0 + ray_42.direction_0 * vec3<f32>((bitcast<f32>((scratch_row_0(u32(3), this_86.own_5).y))));
    }
    return at_23;
}

fn goes_on_from_second_0( slot_15 : Slot_0) -> bool
{
    var sample_33 : Sample_0;
    var _S629 : Walker_0 = Slot_walker_0(slot_15, &(sample_33));
    var at_24 : Walker_0 = _S629;
    var hit_27 : Hit_0 = hit_in_slot_0(slot_15.own_5, at_24.ray_7);
    if(leaves_0(hit_27, false))
    {
        set_left_0(slot_15.own_5);
        return false;
    }
    var _S630 : vec3<f32> = vec3<f32>(0.0f);
    var cached_3 : vec3<f32> = _S630;
    var is_known_0 : bool;
    if(at_24.asks_cache_0)
    {
        var _S631 : bool = asks_2(at_24.path_0, at_24.ray_7, hit_27, u32(4294967295), at_24.life_0, &(cached_3));
        is_known_0 = _S631;
    }
    else
    {
        is_known_0 = false;
    }
    if(!is_known_0)
    {
        is_known_0 = !Hit_is_miss_0(hit_27);
    }
    else
    {
        is_known_0 = false;
    }
    if(is_known_0)
    {
        is_known_0 = (at_24.path_0.bounce_0) < (params_0.max_bounces_0);
    }
    else
    {
        is_known_0 = false;
    }
    if(is_known_0)
    {
        return true;
    }
    ends_here_0 = true;
    var emitted_6 : vec3<f32> = _S630;
    var _S632 : Path_0 = at_24.path_0;
    var _S633 : NextRays_0 = PathTracingOf_advance_2(&(_S632), at_24.ray_7, hit_27, u32(4294967295), &(emitted_6));
    at_24.path_0 = _S632;
    sample_33.light_1 = sample_33.light_1 + (cached_3 + emitted_6);
    Slot_end_0(slot_15, sample_33);
    return false;
}

fn is_left_9( slot_16 : u32) -> bool
{
    return (scratch_row_0(u32(7), slot_16).x) == u32(4294967294);
}

var<workgroup> appended_0 : array<atomic<u32>, i32(2)>;

var<workgroup> first_appended_0 : array<u32, i32(2)>;

fn append_0( thread_2 : u32,  item_6 : u32,  of_0 : Item_0,  goes_on_8 : bool)
{
    var _S634 : bool = thread_2 < u32(2);
    if(_S634)
    {
        atomicStore(&(appended_0[thread_2]), u32(0));
    }
    workgroupBarrier();
    var _S635 : i32;
    if(goes_on_8)
    {
        _S635 = i32(0);
    }
    else
    {
        _S635 = i32(1);
    }
    var list_1 : u32 = u32(_S635);
    var index_39 : u32;
    if(of_0.traces_0)
    {
        var _S636 : u32 = atomicAdd(&(appended_0[list_1]), u32(1));
        index_39 = _S636;
    }
    else
    {
        index_39 = u32(0);
    }
    workgroupBarrier();
    if(_S634)
    {
        var count_10 : u32 = atomicLoad(&(appended_0[thread_2]));
        var before_0 : u32;
        if(count_10 > u32(0))
        {
            if(thread_2 == u32(0))
            {
                before_0 = u32(4);
            }
            else
            {
                before_0 = u32(8);
            }
            var _S637 : u32 = atomicAdd(&(cell_keys_0[before_0]), count_10);
            before_0 = _S637;
        }
        else
        {
            before_0 = u32(0);
        }
        var more_0 : u32 = (before_0 + count_10 + u32(64) - u32(1)) / u32(64) - (before_0 + u32(64) - u32(1)) / u32(64);
        var _S638 : bool;
        if(thread_2 == u32(0))
        {
            _S638 = more_0 > u32(0);
        }
        else
        {
            _S638 = false;
        }
        if(_S638)
        {
            var _S639 : u32 = atomicAdd(&(cell_keys_0[u32(5)]), more_0);
        }
        first_appended_0[thread_2] = before_0;
    }
    workgroupBarrier();
    var at_25 : u32 = first_appended_0[list_1] + index_39;
    if(of_0.traces_0)
    {
        if(goes_on_8)
        {
            index_39 = at_25;
        }
        else
        {
            index_39 = real_time_0.slots_0 - u32(1) - at_25;
        }
        if(goes_on_8)
        {
            index_39 = item_6;
        }
        else
        {
            index_39 = of_0.slot_0;
        }
        rest_0[index_39] = index_39;
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_ends(@builtin(global_invocation_id) id_4 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var _S640 : u32 = id_4.x;
    var _S641 : Item_0 = item_of_0(_S640);
    var item_7 : Item_0 = _S641;
    var slot_17 : Slot_0 = Slot_x24init_0(_S641, item_7.slot_0, item_7.slot_0);
    var goes_on_9 : bool;
    if(item_7.traces_0)
    {
        goes_on_9 = !is_over_0(item_7.slot_0);
    }
    else
    {
        goes_on_9 = false;
    }
    if(goes_on_9)
    {
        var _S642 : bool = goes_on_from_second_0(slot_17);
        goes_on_9 = _S642;
    }
    else
    {
        goes_on_9 = false;
    }
    var _S643 : bool;
    if(item_7.traces_0)
    {
        _S643 = !is_left_9(item_7.slot_0);
    }
    else
    {
        _S643 = false;
    }
    item_7.traces_0 = _S643;
    append_0(thread_3, _S640, item_7, goes_on_9);
    return;
}

fn slot_of_rest_0( number_5 : u32,  is_lent_0 : ptr<function, bool>) -> Slot_0
{
    var slot_18 : Slot_0;
    var _S644 : u32 = atomicLoad(&(cell_keys_0[u32(4)]));
    slot_18.item_2.traces_0 = number_5 < _S644;
    var _S645 : u32 = atomicLoad(&(cell_keys_0[u32(8)]));
    (*is_lent_0) = number_5 < _S645;
    if(slot_18.item_2.traces_0)
    {
        var _S646 : Item_0 = item_of_0(rest_0[number_5]);
        slot_18.item_2 = _S646;
        slot_18.own_5 = slot_18.item_2.slot_0;
        slot_18.lent_0 = slot_18.item_2.slot_0;
        if((*is_lent_0))
        {
            slot_18.lent_0 = rest_0[real_time_0.slots_0 - u32(1) - number_5];
        }
        slot_18.item_2.traces_0 = !is_over_0(slot_18.own_5);
    }
    return slot_18;
}

fn Slot_keep_later_0( this_87 : Slot_0,  at_26 : Walker_0,  hit_28 : Hit_0,  found_4 : vec3<f32>)
{
    var light_17 : vec3<f32>;
    if(at_26.is_shadow_ray_0)
    {
        light_17 = at_26.light_0;
    }
    else
    {
        light_17 = vec3<f32>(0.0f);
    }
    set_scratch_row_0(u32(0), this_87.own_5, (bitcast<vec2<u32>>((found_4.xy))));
    scratch_0[real_time_0.slots_0 + this_87.own_5][i32(0)] = (bitcast<u32>((found_4.z)));
    Slot_keep_0(this_87, at_26, hit_28.instance_0, hit_28.face_0);
    set_scratch_row_0(u32(7), this_87.lent_0, (bitcast<vec2<u32>>((at_26.path_0.beta_0.xy))));
    set_scratch_row_0(u32(8), this_87.lent_0, (bitcast<vec2<u32>>((vec2<f32>(at_26.path_0.beta_0.z, light_17.x)))));
    set_scratch_row_0(u32(9), this_87.lent_0, (bitcast<vec2<u32>>((light_17.yz))));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_on(@builtin(global_invocation_id) id_5 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var is_lent_1 : bool;
    var slot_19 : Slot_0 = slot_of_rest_0(id_5.x, &(is_lent_1));
    var _S647 : bool;
    if(slot_19.item_2.traces_0)
    {
        _S647 = is_lent_1;
    }
    else
    {
        _S647 = false;
    }
    if(_S647)
    {
        scatter_of_path_0.wants_light_0 = false;
        first_candidates_0 = u32(1);
        var sample_34 : Sample_0;
        var _S648 : Walker_0 = Slot_walker_1(slot_19, &(sample_34));
        var at_27 : Walker_0 = _S648;
        var hit_29 : Hit_0 = hit_in_slot_0(slot_19.own_5, at_27.ray_7);
        if(leaves_0(hit_29, false))
        {
            set_left_0(slot_19.own_5);
        }
        else
        {
            var _S649 : bool = goes_on_from_1(&(at_27), hit_29, u32(4294967295), &(sample_34));
            if(_S649)
            {
                Slot_keep_later_0(slot_19, at_27, hit_29, sample_34.light_1);
            }
            else
            {
                Slot_end_0(slot_19, sample_34);
            }
        }
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_on_rays(@builtin(global_invocation_id) id_6 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var is_lent_2 : bool;
    var slot_20 : Slot_0 = slot_of_rest_0(id_6.x, &(is_lent_2));
    var _S650 : bool;
    if(slot_20.item_2.traces_0)
    {
        _S650 = is_lent_2;
    }
    else
    {
        _S650 = false;
    }
    if(_S650)
    {
        Slot_walk_0(slot_20);
    }
    return;
}

fn follow_0( item_8 : Item_0,  start_5 : Walker_0,  first_0 : Hit_0,  walks_0 : bool,  found_5 : Sample_0)
{
    var at_28 : Walker_0 = start_5;
    var sample_35 : Sample_0 = found_5;
    var _S651 : bool = !walks_0;
    var is_under_way_0 : bool = true;
    var is_met_4 : bool = _S651;
    var hit_30 : Hit_0 = first_0;
    for(;;)
    {
        if(is_under_way_0)
        {
        }
        else
        {
            break;
        }
        if(!is_met_4)
        {
            var _S652 : Ray_0 = at_28.ray_7;
            var _S653 : Hit_0 = WalkTracer_trace_0(&(_S652), at_28.is_shadow_ray_0);
            at_28.ray_7 = _S652;
            hit_30 = _S653;
        }
        if(leaves_0(hit_30, at_28.is_shadow_ray_0))
        {
            set_left_0(item_8.slot_0);
            return;
        }
        if(at_28.is_shadow_ray_0)
        {
            if(Hit_is_miss_0(hit_30))
            {
                sample_35.light_1 = sample_35.light_1 + at_28.light_0;
            }
            at_28.is_shadow_ray_0 = false;
            at_28.ray_7 = ray_from_0(at_28.ray_7.origin_0, at_28.direction_4);
            is_under_way_0 = (any(((at_28.direction_4) != vec3<f32>(0.0f))));
        }
        else
        {
            var _S654 : bool = goes_on_from_0(&(at_28), hit_30, u32(4294967295), &(sample_35));
            is_under_way_0 = _S654;
        }
        is_met_4 = false;
    }
    Item_end_0(item_8, sample_35);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_rest(@builtin(global_invocation_id) id_7 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var is_lent_3 : bool;
    var slot_21 : Slot_0 = slot_of_rest_0(id_7.x, &(is_lent_3));
    if(slot_21.item_2.traces_0)
    {
        scatter_of_path_0.wants_light_0 = false;
        first_candidates_0 = u32(1);
        var sample_36 : Sample_0;
        var at_29 : Walker_0 = Slot_walker_1(slot_21, &(sample_36));
        follow_0(slot_21.item_2, at_29, hit_in_slot_0(slot_21.own_5, at_29.ray_7), false, sample_36);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_again(@builtin(global_invocation_id) id_8 : vec3<u32>)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var item_9 : Item_0 = item_of_0(real_time_0.cells_0 + threads_that_trace_0() + real_time_0.squares_0 + id_8.x);
    if(item_9.traces_0)
    {
        scatter_of_path_0.wants_light_0 = false;
        first_candidates_0 = real_time_0.candidates_0;
        var _S655 : Walker_0 = Item_start_0(item_9);
        follow_0(item_9, _S655, miss_0(), true, no_sample_0());
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn list_left(@builtin(global_invocation_id) id_9 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    ends_here_0 = false;
    first_candidates_0 = u32(1);
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    var _S656 : bool = thread_4 == u32(0);
    if(_S656)
    {
        atomicStore(&(appended_0[i32(0)]), u32(0));
    }
    workgroupBarrier();
    var _S657 : u32 = id_9.x;
    var item_10 : Item_0 = item_of_0(_S657);
    var is_listed_0 : bool;
    if(item_10.traces_0)
    {
        is_listed_0 = is_left_9(item_10.slot_0);
    }
    else
    {
        is_listed_0 = false;
    }
    var index_40 : u32;
    if(is_listed_0)
    {
        var _S658 : u32 = atomicAdd(&(appended_0[i32(0)]), u32(1));
        index_40 = _S658;
    }
    else
    {
        index_40 = u32(0);
    }
    workgroupBarrier();
    if(_S656)
    {
        var count_11 : u32 = atomicLoad(&(appended_0[i32(0)]));
        var before_1 : u32;
        if(count_11 > u32(0))
        {
            var _S659 : u32 = atomicAdd(&(cell_keys_0[u32(9)]), count_11);
            before_1 = _S659;
        }
        else
        {
            before_1 = u32(0);
        }
        var more_1 : u32 = (before_1 + count_11 + u32(64) - u32(1)) / u32(64) - (before_1 + u32(64) - u32(1)) / u32(64);
        if(more_1 > u32(0))
        {
            var _S660 : u32 = atomicAdd(&(cell_keys_0[u32(10)]), more_1);
        }
        first_appended_0[i32(0)] = before_1;
    }
    workgroupBarrier();
    if(is_listed_0)
    {
        rest_0[first_appended_0[i32(0)] + index_40] = _S657;
    }
    return;
}

