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

struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

@binding(0) @group(0) var<storage, read> cells_1 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

@binding(29) @group(0) var<storage, read> motions_1 : array<vec4<f32>>;

@binding(26) @group(0) var<storage, read_write> scratch_0 : array<vec2<u32>>;

@binding(25) @group(0) var<storage, read_write> memory_rows_0 : array<vec4<u32>>;

@binding(30) @group(0) var<storage, read> rest_0 : array<u32>;

@id(6) override SKY_0 : u32 = u32(0);

struct Inside_0
{
     instance_0 : u32,
     voxel_0 : vec3<i32>,
     material_0 : u32,
};

struct NextRays_0
{
     origin_0 : vec3<f32>,
     path_origin_0 : vec3<f32>,
     shadow_inside_0 : Inside_0,
     relocates_0 : bool,
     path_relocates_0 : bool,
     direction_0 : vec3<f32>,
     has_shadow_ray_0 : bool,
     shadow_direction_0 : vec3<f32>,
     shadow_t_max_0 : f32,
     light_0 : vec3<f32>,
     is_same_0 : bool,
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

struct Ray_0
{
     origin_1 : vec3<f32>,
     t_min_0 : f32,
     direction_1 : vec3<f32>,
     t_max_0 : f32,
};

struct Hit_0
{
     t_0 : f32,
     instance_1 : u32,
     voxel_1 : vec3<i32>,
     face_0 : u32,
};

fn Inside_x24init_0( instance_2 : u32,  voxel_2 : vec3<i32>,  material_1 : u32) -> Inside_0
{
    var _S1 : Inside_0;
    _S1.instance_0 = instance_2;
    _S1.voxel_0 = voxel_2;
    _S1.material_0 = material_1;
    return _S1;
}

fn in_air_0() -> Inside_0
{
    return Inside_x24init_0(u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn NextRays_x24init_0( origin_2 : vec3<f32>,  path_origin_1 : vec3<f32>,  shadow_inside_1 : Inside_0,  relocates_1 : bool,  path_relocates_1 : bool,  direction_2 : vec3<f32>,  has_shadow_ray_1 : bool,  shadow_direction_1 : vec3<f32>,  shadow_t_max_1 : f32,  light_1 : vec3<f32>,  is_same_1 : bool) -> NextRays_0
{
    var _S2 : NextRays_0;
    _S2.origin_0 = origin_2;
    _S2.path_origin_0 = path_origin_1;
    _S2.shadow_inside_0 = shadow_inside_1;
    _S2.relocates_0 = relocates_1;
    _S2.path_relocates_0 = path_relocates_1;
    _S2.direction_0 = direction_2;
    _S2.has_shadow_ray_0 = has_shadow_ray_1;
    _S2.shadow_direction_0 = shadow_direction_1;
    _S2.shadow_t_max_0 = shadow_t_max_1;
    _S2.light_0 = light_1;
    _S2.is_same_0 = is_same_1;
    return _S2;
}

fn no_rays_0() -> NextRays_0
{
    var _S3 : vec3<f32> = vec3<f32>(0.0f);
    return NextRays_x24init_0(_S3, _S3, in_air_0(), false, false, _S3, false, _S3, 0.0f, _S3, false);
}

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_1 : vec3<f32>,
};

struct Surface_0
{
     origin_3 : vec3<f32>,
     normal_2 : vec3<f32>,
     face_1 : u32,
     instance_3 : u32,
};

struct Microfacets_0
{
     alpha_0 : f32,
};

struct MaterialBsdf_0
{
     kind_0 : u32,
     color_0 : vec3<f32>,
     specular_0 : f32,
     eta_0 : f32,
     facets_0 : Microfacets_0,
};

struct Scatter_0
{
     path_0 : Path_0,
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

fn Path_is_counted_0( this_0 : Path_0) -> bool
{
    var _S4 : bool;
    if(weighs_apart_0())
    {
        _S4 = (this_0.pdf_1) < 0.0f;
    }
    else
    {
        _S4 = false;
    }
    return _S4;
}

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_3 : vec3<f32>) -> Receiver_0
{
    var _S5 : Receiver_0;
    _S5.point_0 = point_1;
    _S5.normal_1 = normal_3;
    return _S5;
}

fn Path_receiver_0( this_1 : Path_0,  ray_0 : Ray_0) -> Receiver_0
{
    return Receiver_x24init_0(ray_0.origin_1, this_1.normal_0);
}

fn Inside_is_in_0( this_2 : Inside_0) -> bool
{
    return false;
}

fn Hit_is_miss_0( this_3 : Hit_0) -> bool
{
    return (this_3.instance_1) == u32(4294967295);
}

fn Path_dimension_medium_0( this_4 : Path_0) -> u32
{
    return u32(2147483648) + this_4.event_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S6 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S6;
    v_0[i32(0)] = v_0[i32(0)] + _S6.y * _S6.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S7 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S7;
    v_0[i32(0)] = v_0[i32(0)] + _S7.y * _S7.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn unit_float_0( words_1 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_1 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_independent_0( this_5 : Sampler_0,  dimension_0 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_5.pixel_0, this_5.sample_0, dimension_0, this_5.seed_1)));
}

struct PackedMaterial_0
{
     base_color_0 : array<f32, i32(3)>,
     roughness_0 : f32,
     emission_0 : array<f32, i32(3)>,
     metallic_0 : f32,
     transmission_0 : f32,
     ior_0 : f32,
     specular_1 : f32,
     anisotropy_0 : f32,
     absorption_0 : array<f32, i32(3)>,
     scattering_0 : f32,
};

fn first_row_0( array_0 : u32) -> u32
{
    return records_0[(array_0 >> (u32(2)))][(array_0 & (u32(3)))];
}

fn Rows_operatorx5Bx5D_get_0( row_0 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(3)) + row_0];
}

fn material_of_index_0( index_0 : u32) -> PackedMaterial_0
{
    var _S8 : u32 = u32(4) * index_0;
    var _S9 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S8);
    var _S10 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S8 + u32(1));
    var _S11 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S8 + u32(2));
    var _S12 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S8 + u32(3));
    var material_2 : PackedMaterial_0;
    var _S13 : f32 = (bitcast<f32>((_S9.y)));
    var _S14 : f32 = (bitcast<f32>((_S9.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((_S9.x)));
    material_2.base_color_0[i32(1)] = _S13;
    material_2.base_color_0[i32(2)] = _S14;
    var _S15 : f32 = (bitcast<f32>((_S10.y)));
    var _S16 : f32 = (bitcast<f32>((_S10.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((_S10.x)));
    material_2.emission_0[i32(1)] = _S15;
    material_2.emission_0[i32(2)] = _S16;
    var _S17 : f32 = (bitcast<f32>((_S12.y)));
    var _S18 : f32 = (bitcast<f32>((_S12.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((_S12.x)));
    material_2.absorption_0[i32(1)] = _S17;
    material_2.absorption_0[i32(2)] = _S18;
    material_2.roughness_0 = (bitcast<f32>((_S9.w)));
    material_2.metallic_0 = (bitcast<f32>((_S10.w)));
    material_2.transmission_0 = (bitcast<f32>((_S11.x)));
    material_2.ior_0 = (bitcast<f32>((_S11.y)));
    material_2.specular_1 = (bitcast<f32>((_S11.z)));
    material_2.anisotropy_0 = (bitcast<f32>((_S11.w)));
    material_2.scattering_0 = (bitcast<f32>((_S12.w)));
    return material_2;
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
    var _S19 : i32 = i32(divisor_0);
    var _S20 : i32 = i32(2) * (rest_1 - units_0 * _S19);
    return guess_0 + u32(units_0 + (i32(_S20 > _S19) - i32(_S20 < (- _S19))));
}

fn divide_0( a_0 : f32,  b_0 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_0 / b_0;
    }
    var _S21 : u32 = (bitcast<u32>((a_0)));
    var exponent_a_0 : u32 = (((_S21 >> (u32(23)))) & (u32(255)));
    var _S22 : u32 = (bitcast<u32>((b_0)));
    var exponent_b_0 : u32 = (((_S22 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S21 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S22 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_1 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S23 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S23 = true;
    }
    else
    {
        _S23 = !is_normal_0(exponent_b_0);
    }
    if(_S23)
    {
        _S23 = true;
    }
    else
    {
        _S23 = !is_normal_0(exponent_1);
    }
    if(_S23)
    {
        return a_0 / b_0;
    }
    return (bitcast<f32>(((((((_S21 ^ (_S22))) & (u32(2147483648)))) | ((((exponent_1 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn logarithm_0( x_0 : f32) -> f32
{
    var bits_0 : u32 = (bitcast<u32>((x_0)));
    var _S24 : u32 = (bits_0 & (u32(8388607)));
    var is_upper_0 : bool = _S24 > u32(3474675);
    var power_0 : i32 = i32((bits_0 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S25 : u32;
    if(is_upper_0)
    {
        _S25 = u32(1056964608);
    }
    else
    {
        _S25 = u32(1065353216);
    }
    var mantissa_0 : f32 = (bitcast<f32>(((_S24 | (_S25)))));
    var s_0 : f32 = divide_0(mantissa_0 - 1.0f, mantissa_0 + 1.0f);
    var ss_0 : f32 = s_0 * s_0;
    var _S26 : f32 = f32(power_0);
    return _S26 * 0.693359375f + (_S26 * -0.00021219444170129f + s_0 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_0 : PackedMaterial_0,  u_0 : f32) -> f32
{
    var _S27 : f32;
    if((medium_0.scattering_0) > 0.0f)
    {
        _S27 = divide_0(- logarithm_0(1.0f - u_0), medium_0.scattering_0);
    }
    else
    {
        _S27 = (bitcast<f32>(infinity_bits_0));
    }
    return _S27;
}

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

fn Rows_operatorx5Bx5D_get_1( row_1 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(1)) + row_1];
}

fn transform_of_0( a_1 : vec4<u32>,  b_1 : vec4<u32>,  c_0 : vec4<u32>) -> Transform_0
{
    var transform_0 : Transform_0;
    var _S28 : f32 = (bitcast<f32>((a_1.y)));
    var _S29 : f32 = (bitcast<f32>((a_1.z)));
    transform_0.x_axis_0[i32(0)] = (bitcast<f32>((a_1.x)));
    transform_0.x_axis_0[i32(1)] = _S28;
    transform_0.x_axis_0[i32(2)] = _S29;
    var _S30 : f32 = (bitcast<f32>((b_1.x)));
    var _S31 : f32 = (bitcast<f32>((b_1.y)));
    transform_0.y_axis_0[i32(0)] = (bitcast<f32>((a_1.w)));
    transform_0.y_axis_0[i32(1)] = _S30;
    transform_0.y_axis_0[i32(2)] = _S31;
    var _S32 : f32 = (bitcast<f32>((b_1.w)));
    var _S33 : f32 = (bitcast<f32>((c_0.x)));
    transform_0.z_axis_0[i32(0)] = (bitcast<f32>((b_1.z)));
    transform_0.z_axis_0[i32(1)] = _S32;
    transform_0.z_axis_0[i32(2)] = _S33;
    var _S34 : f32 = (bitcast<f32>((c_0.z)));
    var _S35 : f32 = (bitcast<f32>((c_0.w)));
    transform_0.translation_0[i32(0)] = (bitcast<f32>((c_0.y)));
    transform_0.translation_0[i32(1)] = _S34;
    transform_0.translation_0[i32(2)] = _S35;
    return transform_0;
}

fn PackedInstance_x24init_0( grid_from_world_1 : Transform_0,  world_from_grid_1 : Transform_0,  grid_1 : u32,  scene_instance_1 : u32,  light_leaf_1 : u32) -> PackedInstance_0
{
    var _S36 : PackedInstance_0;
    _S36.grid_from_world_0 = grid_from_world_1;
    _S36.world_from_grid_0 = world_from_grid_1;
    _S36.grid_0 = grid_1;
    _S36.scene_instance_0 = scene_instance_1;
    _S36.light_leaf_0 = light_leaf_1;
    return _S36;
}

fn Instances_operatorx5Bx5D_get_0( index_1 : u32) -> PackedInstance_0
{
    var row_2 : u32 = u32(7) * index_1;
    var _S37 : vec4<u32> = Rows_operatorx5Bx5D_get_1(row_2 + u32(6));
    return PackedInstance_x24init_0(transform_of_0(Rows_operatorx5Bx5D_get_1(row_2), Rows_operatorx5Bx5D_get_1(row_2 + u32(1)), Rows_operatorx5Bx5D_get_1(row_2 + u32(2))), transform_of_0(Rows_operatorx5Bx5D_get_1(row_2 + u32(3)), Rows_operatorx5Bx5D_get_1(row_2 + u32(4)), Rows_operatorx5Bx5D_get_1(row_2 + u32(5))), _S37.x, _S37.y, _S37.z);
}

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn Transform_direction_0( this_6 : Transform_0,  v_1 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(this_6.x_axis_0) * vec3<f32>(v_1.x) + vector_of_0(this_6.y_axis_0) * vec3<f32>(v_1.y) + vector_of_0(this_6.z_axis_0) * vec3<f32>(v_1.z);
}

fn grid_direction_0( instance_4 : u32,  direction_3 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(Instances_operatorx5Bx5D_get_0(instance_4).grid_from_world_0, direction_3);
}

fn dot_product_0( a_2 : vec3<f32>,  b_2 : vec3<f32>) -> f32
{
    return a_2.x * b_2.x + a_2.y * b_2.y + a_2.z * b_2.z;
}

fn length_squared_0( vector_0 : vec3<f32>) -> f32
{
    return dot_product_0(vector_0, vector_0);
}

fn nearest_root_0( mantissa_1 : u32,  guess_1 : u32) -> u32
{
    var rest_2 : i32 = i32(((mantissa_1 << (u32(23)))) - guess_1 * guess_1);
    var units_1 : i32 = i32(floor(f32(rest_2) / f32(u32(2) * guess_1) + 0.5f));
    var _S38 : i32 = i32(guess_1);
    var root_0 : i32 = _S38 + units_1;
    var rest_3 : i32 = rest_2 - units_1 * (_S38 + root_0);
    return u32(root_0 + i32(rest_3 > root_0) - i32(rest_3 <= (- root_0)));
}

fn square_root_0( value_0 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_0);
    }
    var _S39 : u32 = (bitcast<u32>((value_0)));
    var exponent_2 : u32 = (_S39 >> (u32(23)));
    if(!is_normal_0(exponent_2))
    {
        return sqrt(value_0);
    }
    var mantissa_2 : u32 = (((((_S39 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_2) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_2 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_2, u32(sqrt(f32(mantissa_2) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn Inside_voxels_per_t_0( this_7 : Inside_0,  ray_1 : Ray_0) -> f32
{
    return square_root_0(length_squared_0(grid_direction_0(this_7.instance_0, ray_1.direction_1)));
}

fn scattering_t_0( path_1 : Path_0,  inside_1 : Inside_0,  ray_2 : Ray_0) -> f32
{
    return divide_0(free_path_0(material_of_index_0(inside_1.material_0), Sampler_independent_0(path_1.sampler_0, Path_dimension_medium_0(path_1)).x), Inside_voxels_per_t_0(inside_1, ray_2));
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

fn attenuation_0( medium_1 : PackedMaterial_0,  voxels_0 : f32) -> vec3<f32>
{
    var sigma_0 : vec3<f32> = vector_of_0(medium_1.absorption_0);
    return vec3<f32>(exponential_0(- (sigma_0.x * voxels_0)), exponential_0(- (sigma_0.y * voxels_0)), exponential_0(- (sigma_0.z * voxels_0)));
}

fn absorb_0( path_2 : ptr<function, Path_0>,  inside_2 : Inside_0,  ray_3 : Ray_0,  t_1 : f32)
{
    (*path_2).beta_0 = (*path_2).beta_0 * attenuation_0(material_of_index_0(inside_2.material_0), t_1 * Inside_voxels_per_t_0(inside_2, ray_3));
    return;
}

fn Environment_to_map_0( d_0 : vec3<f32>) -> vec3<f32>
{
    var sin_0 : f32 = params_0.sky_turned_0.x;
    var cos_0 : f32 = params_0.sky_turned_0.y;
    var _S40 : f32 = d_0.x;
    var _S41 : f32 = d_0.y;
    return vec3<f32>(_S40 * cos_0 - _S41 * sin_0, _S40 * sin_0 + _S41 * cos_0, d_0.z);
}

fn quarter_turns_0( x_2 : f32,  y_0 : f32) -> f32
{
    var _S42 : f32 = min(x_2, y_0);
    var _S43 : f32 = max(x_2, y_0);
    var ratio_0 : f32;
    if(_S43 > 0.0f)
    {
        ratio_0 = divide_0(_S42, _S43);
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

fn square_of_0( direction_4 : vec3<f32>) -> vec2<f32>
{
    var size_0 : vec3<f32> = abs(direction_4);
    var _S44 : f32 = size_0.x;
    var _S45 : f32 = size_0.y;
    var radius_0 : f32 = square_root_0(divide_0(_S44 * _S44 + _S45 * _S45, 1.0f + size_0.z));
    var v_2 : f32 = quarter_turns_0(_S44, _S45) * radius_0;
    var u_1 : f32 = radius_0 - v_2;
    var is_below_1 : bool = (direction_4.z) < 0.0f;
    var u_2 : f32;
    if(is_below_1)
    {
        u_2 = 1.0f - v_2;
    }
    else
    {
        u_2 = u_1;
    }
    var v_3 : f32;
    if(is_below_1)
    {
        v_3 = 1.0f - u_1;
    }
    else
    {
        v_3 = v_2;
    }
    if((direction_4.x) < 0.0f)
    {
        u_2 = - u_2;
    }
    if((direction_4.y) < 0.0f)
    {
        v_3 = - v_3;
    }
    return vec2<f32>(u_2 * 0.5f + 0.5f, v_3 * 0.5f + 0.5f);
}

fn Environment_place_of_0( direction_5 : vec3<f32>) -> vec2<f32>
{
    return square_of_0(Environment_to_map_0(direction_5)) * vec2<f32>(f32(params_0.sky_edge_0));
}

fn Environment_index_of_0( x_3 : i32,  y_1 : i32) -> u32
{
    var last_0 : i32 = i32(params_0.sky_edge_0) - i32(1);
    var is_beside_0 : bool;
    if(x_3 < i32(0))
    {
        is_beside_0 = true;
    }
    else
    {
        is_beside_0 = x_3 > last_0;
    }
    var _S46 : i32;
    if(is_beside_0)
    {
        _S46 = last_0 - y_1;
    }
    else
    {
        _S46 = y_1;
    }
    var _S47 : i32;
    if(is_beside_0)
    {
        _S47 = clamp(x_3, i32(0), last_0);
    }
    else
    {
        _S47 = x_3;
    }
    var is_beyond_0 : bool;
    if(_S46 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S46 > last_0;
    }
    if(is_beyond_0)
    {
        _S47 = last_0 - _S47;
    }
    if(is_beyond_0)
    {
        _S46 = clamp(_S46, i32(0), last_0);
    }
    return u32(_S46 * i32(params_0.sky_edge_0) + _S47);
}

fn Environment_texel_radiance_0( x_4 : i32,  y_2 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_4, y_2)].radiance_0);
}

fn Environment_radiance_at_0( place_0 : vec2<f32>) -> vec3<f32>
{
    var _S48 : vec2<f32> = place_0 - vec2<f32>(0.5f);
    var corner_1 : vec2<f32> = floor(_S48);
    var beyond_0 : vec2<f32> = _S48 - corner_1;
    var x_5 : i32 = i32(corner_1.x);
    var y_3 : i32 = i32(corner_1.y);
    var _S49 : f32 = beyond_0.x;
    var _S50 : vec3<f32> = vec3<f32>((1.0f - _S49));
    var _S51 : i32 = x_5 + i32(1);
    var _S52 : vec3<f32> = vec3<f32>(_S49);
    var _S53 : i32 = y_3 + i32(1);
    var _S54 : f32 = beyond_0.y;
    return (Environment_texel_radiance_0(x_5, y_3) * _S50 + Environment_texel_radiance_0(_S51, y_3) * _S52) * vec3<f32>((1.0f - _S54)) + (Environment_texel_radiance_0(x_5, _S53) * _S50 + Environment_texel_radiance_0(_S51, _S53) * _S52) * vec3<f32>(_S54);
}

fn Environment_radiance_0( direction_6 : vec3<f32>) -> vec3<f32>
{
    return Environment_radiance_at_0(Environment_place_of_0(direction_6));
}

struct Gradient_0
{
     nadir_0 : vec3<f32>,
     zenith_0 : vec3<f32>,
};

fn Gradient_x24init_0( nadir_1 : vec3<f32>,  zenith_1 : vec3<f32>) -> Gradient_0
{
    var _S55 : Gradient_0;
    _S55.nadir_0 = nadir_1;
    _S55.zenith_0 = zenith_1;
    return _S55;
}

fn Gradient_radiance_0( this_8 : Gradient_0,  direction_7 : vec3<f32>) -> vec3<f32>
{
    return this_8.nadir_0 + (this_8.zenith_0 - this_8.nadir_0) * vec3<f32>((0.5f * (direction_7.z + 1.0f)));
}

fn Sky_radiance_0( direction_8 : vec3<f32>) -> vec3<f32>
{
    if(SKY_0 == u32(1))
    {
        return Environment_radiance_0(direction_8) * vec3<f32>(params_0.sky_brightness_0);
    }
    return Gradient_radiance_0(Gradient_x24init_0(params_0.sky_nadir_0, params_0.sky_zenith_0), direction_8) * vec3<f32>(params_0.sky_brightness_0);
}

fn Sky_le_0( direction_9 : vec3<f32>) -> vec3<f32>
{
    return Sky_radiance_0(direction_9);
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn Lights_sun_cosine_0( receiver_1 : Receiver_0) -> f32
{
    return dot_product_0(receiver_1.normal_1, params_0.sun_direction_0);
}

struct LightNode_0
{
     min_0 : array<f32, i32(3)>,
     index_2 : u32,
     max_0 : array<f32, i32(3)>,
     count_0 : u32,
     power_2 : array<f32, i32(6)>,
     parent_0 : u32,
     root_1 : u32,
};

fn Rows_operatorx5Bx5D_get_2( row_3 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(6)) + row_3];
}

fn light_node_of_0( a_3 : vec4<u32>,  b_3 : vec4<u32>,  c_1 : vec4<u32>,  d_1 : vec4<u32>) -> LightNode_0
{
    var node_0 : LightNode_0;
    var _S56 : f32 = (bitcast<f32>((a_3.y)));
    var _S57 : f32 = (bitcast<f32>((a_3.z)));
    node_0.min_0[i32(0)] = (bitcast<f32>((a_3.x)));
    node_0.min_0[i32(1)] = _S56;
    node_0.min_0[i32(2)] = _S57;
    node_0.index_2 = a_3.w;
    var _S58 : f32 = (bitcast<f32>((b_3.y)));
    var _S59 : f32 = (bitcast<f32>((b_3.z)));
    node_0.max_0[i32(0)] = (bitcast<f32>((b_3.x)));
    node_0.max_0[i32(1)] = _S58;
    node_0.max_0[i32(2)] = _S59;
    node_0.count_0 = b_3.w;
    var _S60 : f32 = (bitcast<f32>((c_1.y)));
    var _S61 : f32 = (bitcast<f32>((c_1.z)));
    var _S62 : f32 = (bitcast<f32>((c_1.w)));
    var _S63 : f32 = (bitcast<f32>((d_1.x)));
    var _S64 : f32 = (bitcast<f32>((d_1.y)));
    node_0.power_2[i32(0)] = (bitcast<f32>((c_1.x)));
    node_0.power_2[i32(1)] = _S60;
    node_0.power_2[i32(2)] = _S61;
    node_0.power_2[i32(3)] = _S62;
    node_0.power_2[i32(4)] = _S63;
    node_0.power_2[i32(5)] = _S64;
    node_0.parent_0 = d_1.z;
    node_0.root_1 = d_1.w;
    return node_0;
}

fn top_light_node_0( index_3 : u32) -> LightNode_0
{
    var _S65 : u32 = u32(4) * index_3;
    return light_node_of_0(Rows_operatorx5Bx5D_get_2(_S65), Rows_operatorx5Bx5D_get_2(_S65 + u32(1)), Rows_operatorx5Bx5D_get_2(_S65 + u32(2)), Rows_operatorx5Bx5D_get_2(_S65 + u32(3)));
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

fn reach_of_0( toward_0 : vec3<f32>,  half_0 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_0), half_0);
}

fn reciprocal_guess_0( x_6 : f32) -> f32
{
    var guess_2 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_6))))));
    return guess_2 * (2.0f - x_6 * guess_2);
}

struct BySide_0
{
     low_0 : vec3<f32>,
     high_0 : vec3<f32>,
};

fn BySide_x24init_0( low_1 : vec3<f32>,  high_1 : vec3<f32>) -> BySide_0
{
    var _S66 : BySide_0;
    _S66.low_0 = low_1;
    _S66.high_0 = high_1;
    return _S66;
}

fn sent_by_side_0( node_1 : LightNode_0,  point_2 : vec3<f32>) -> BySide_0
{
    var _S67 : vec3<f32> = vec3<f32>(0.0f);
    return BySide_x24init_0(vec3<f32>(node_1.power_2[i32(0)], node_1.power_2[i32(2)], node_1.power_2[i32(4)]) * max(vector_of_0(node_1.max_0) - point_2, _S67), vec3<f32>(node_1.power_2[i32(1)], node_1.power_2[i32(3)], node_1.power_2[i32(5)]) * max(point_2 - vector_of_0(node_1.min_0), _S67));
}

fn BySide_sum_0( this_9 : BySide_0) -> f32
{
    var axes_0 : vec3<f32> = this_9.low_0 + this_9.high_0;
    return axes_0.x + axes_0.y + axes_0.z;
}

fn nearest_of_0( toward_1 : vec3<f32>,  half_1 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_1) - half_1, half_1 * vec3<f32>(0.03125f));
}

fn View_x24init_0( importance_1 : f32,  of_nearest_1 : f32,  is_far_1 : bool) -> View_0
{
    var _S68 : View_0;
    _S68.importance_0 = importance_1;
    _S68.of_nearest_0 = of_nearest_1;
    _S68.is_far_0 = is_far_1;
    return _S68;
}

fn view_0( node_2 : LightNode_0,  receiver_3 : Receiver_0) -> View_0
{
    var _S69 : vec3<f32> = vector_of_0(node_2.max_0);
    var _S70 : vec3<f32> = vector_of_0(node_2.min_0);
    var _S71 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (_S69 - _S70) * _S71;
    var toward_2 : vec3<f32> = (_S70 + _S69) * _S71 - receiver_3.point_0;
    var middle_0 : f32 = dot_product_0(toward_2, receiver_3.normal_1);
    var aside_0 : f32 = dot_product_0(half_2, abs(receiver_3.normal_1));
    var above_0 : f32 = with_slack_0(receiver_3, middle_0 + aside_0);
    var far_0 : f32 = length_squared_0(reach_of_0(toward_2, half_2));
    var near_0 : f32 = length_squared_0(half_2);
    var is_far_2 : bool;
    if((with_slack_0(receiver_3, middle_0 - aside_0)) > 0.0f)
    {
        is_far_2 = far_0 > (near_0 * 36.0f);
    }
    else
    {
        is_far_2 = false;
    }
    var falloff_0 : f32 = reciprocal_guess_0(far_0);
    var cosines_0 : f32;
    if(above_0 > 0.0f)
    {
        cosines_0 = BySide_sum_0(sent_by_side_0(node_2, receiver_3.point_0)) * above_0 * falloff_0;
    }
    else
    {
        cosines_0 = 0.0f;
    }
    return View_x24init_0(cosines_0 * falloff_0, cosines_0 * reciprocal_guess_0(length_squared_0(nearest_of_0(toward_2, half_2))), is_far_2);
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
    var _S72 : bool;
    if(SKY_0 == u32(1))
    {
        _S72 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S72 = false;
    }
    return _S72;
}

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S73 : Selection_0;
    _S73.sun_0 = sun_1;
    _S73.sky_1 = sky_2;
    _S73.emitters_0 = emitters_1;
    return _S73;
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
    var _S74 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S74, sky_3, (1.0f - sun_2) * _S74);
}

fn Path_selection_at_0( this_10 : Path_0,  last_1 : Receiver_0) -> Selection_0
{
    return Lights_selection_0(last_1);
}

fn Environment_pdf_0( direction_10 : vec3<f32>) -> f32
{
    var place_1 : vec2<f32> = Environment_place_of_0(direction_10);
    var last_2 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_1.x), last_2), min(i32(place_1.y), last_2))].pdf_0;
}

fn Sky_pdf_0( direction_11 : vec3<f32>) -> f32
{
    var _S75 : f32;
    if(SKY_0 == u32(1))
    {
        _S75 = Environment_pdf_0(direction_11);
    }
    else
    {
        _S75 = 0.0f;
    }
    return _S75;
}

fn Lights_sky_pdf_0( selection_1 : Selection_0,  direction_12 : vec3<f32>) -> f32
{
    var _S76 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S76 = Sky_pdf_0(direction_12) * selection_1.sky_1;
    }
    else
    {
        _S76 = 0.0f;
    }
    return _S76;
}

fn power_heuristic_0( own_0 : f32,  other_0 : f32) -> f32
{
    var ratio_1 : f32 = divide_0(other_0, own_0);
    return divide_0(1.0f, 1.0f + ratio_1 * ratio_1);
}

fn mis_weight_0( bounce_pdf_0 : f32,  light_pdf_0 : f32) -> f32
{
    var _S77 : bool;
    if(bounce_pdf_0 == 0.0f)
    {
        _S77 = true;
    }
    else
    {
        _S77 = light_pdf_0 == 0.0f;
    }
    if(_S77)
    {
        return 1.0f;
    }
    return power_heuristic_0(bounce_pdf_0, light_pdf_0);
}

fn SunDisc_is_visible_0() -> bool
{
    return (params_0.hides_sun_disc_0) == u32(0);
}

fn Path_is_straight_0( this_11 : Path_0) -> bool
{
    var _S78 : bool;
    if((this_11.bounce_0) == u32(0))
    {
        _S78 = (this_11.pdf_1) == 0.0f;
    }
    else
    {
        _S78 = false;
    }
    if(_S78)
    {
        _S78 = (all(((this_11.normal_0) == vec3<f32>(0.0f))));
    }
    else
    {
        _S78 = false;
    }
    return _S78;
}

fn SunDisc_contains_0( direction_13 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_13 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_le_0( direction_14 : vec3<f32>) -> vec3<f32>
{
    var _S79 : vec3<f32>;
    if(SunDisc_contains_0(direction_14))
    {
        _S79 = params_0.sun_radiance_0;
    }
    else
    {
        _S79 = vec3<f32>(0.0f);
    }
    return _S79;
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn SunDisc_pdf_0( direction_15 : vec3<f32>) -> f32
{
    var _S80 : f32;
    if(SunDisc_contains_0(direction_15))
    {
        _S80 = params_0.sun_pdf_0;
    }
    else
    {
        _S80 = 0.0f;
    }
    return _S80;
}

fn Lights_sun_pdf_0( selection_2 : Selection_0,  direction_16 : vec3<f32>) -> f32
{
    var _S81 : f32;
    if(has_sun_0())
    {
        _S81 = SunDisc_pdf_0(direction_16) * selection_2.sun_0;
    }
    else
    {
        _S81 = 0.0f;
    }
    return _S81;
}

fn Path_events_0( this_12 : Path_0) -> u32
{
    return this_12.bounce_0;
}

fn Path_dimension_scatter_0( this_13 : Path_0) -> u32
{
    return u32(1) + u32(2) * Path_events_0(this_13);
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
    var index_4 : u32 = owen_of_reversed_0(reverseBits(sample_1), order_0);
    var binomial_0 : u32 = (index_4 ^ (((((index_4 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_4, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_14 : Sampler_0,  dimension_1 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_2 : vec4<u32> = pcg4d_0(vec4<u32>(this_14.pixel_0, dimension_1, this_14.seed_1, which_0));
    return scrambled_sobol_0(this_14.sample_0, words_2.x, words_2.yz);
}

fn Sampler_stratified_0( this_15 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_15, dimension_2, u32(1)), Sampler_pair_0(this_15, dimension_2, u32(2))));
}

struct PackedGrid_0
{
     origin_4 : array<i32, i32(3)>,
     top_shift_0 : u32,
     top_size_0 : array<i32, i32(3)>,
     top_offset_0 : u32,
     min_1 : array<i32, i32(3)>,
     voxels_1 : array<u32, i32(2)>,
     max_1 : array<i32, i32(3)>,
     material_bits_0 : u32,
};

fn Rows_operatorx5Bx5D_get_3( row_4 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(0)) + row_4];
}

fn Grids_operatorx5Bx5D_get_0( index_5 : u32) -> PackedGrid_0
{
    var row_5 : u32 = u32(5) * index_5;
    var _S82 : vec4<u32> = Rows_operatorx5Bx5D_get_3(row_5);
    var _S83 : vec4<u32> = Rows_operatorx5Bx5D_get_3(row_5 + u32(1));
    var _S84 : vec4<u32> = Rows_operatorx5Bx5D_get_3(row_5 + u32(2));
    var _S85 : vec4<u32> = Rows_operatorx5Bx5D_get_3(row_5 + u32(3));
    var grid_2 : PackedGrid_0;
    var _S86 : i32 = i32(_S82.y);
    var _S87 : i32 = i32(_S82.z);
    grid_2.origin_4[i32(0)] = i32(_S82.x);
    grid_2.origin_4[i32(1)] = _S86;
    grid_2.origin_4[i32(2)] = _S87;
    grid_2.top_shift_0 = _S82.w;
    var _S88 : i32 = i32(_S83.y);
    var _S89 : i32 = i32(_S83.z);
    grid_2.top_size_0[i32(0)] = i32(_S83.x);
    grid_2.top_size_0[i32(1)] = _S88;
    grid_2.top_size_0[i32(2)] = _S89;
    grid_2.top_offset_0 = _S83.w;
    var _S90 : i32 = i32(_S84.y);
    var _S91 : i32 = i32(_S84.z);
    grid_2.min_1[i32(0)] = i32(_S84.x);
    grid_2.min_1[i32(1)] = _S90;
    grid_2.min_1[i32(2)] = _S91;
    var _S92 : u32 = _S85.x;
    grid_2.voxels_1[i32(0)] = _S84.w;
    grid_2.voxels_1[i32(1)] = _S92;
    var _S93 : i32 = i32(_S85.z);
    var _S94 : i32 = i32(_S85.w);
    grid_2.max_1[i32(0)] = i32(_S85.y);
    grid_2.max_1[i32(1)] = _S93;
    grid_2.max_1[i32(2)] = _S94;
    grid_2.material_bits_0 = Rows_operatorx5Bx5D_get_3(row_5 + u32(4)).x;
    return grid_2;
}

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn place_of_cell_0( index_6 : u32) -> u32
{
    return index_6;
}

fn cell_word_0( index_7 : u32) -> u32
{
    return cells_1[place_of_cell_0(index_7)];
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_1 : u32) -> u32
{
    var _S95 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S95 = u32(8388607);
    }
    else
    {
        _S95 = u32(2147483647);
    }
    return ((cell_1 & (_S95))) * u32(2);
}

fn find_brick_0( grid_3 : PackedGrid_0,  relative_1 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (relative_1 >> (vec3<u32>(grid_3.top_shift_0)));
    var _S96 : bool;
    if((any((top_0 < vec3<i32>(i32(0))))))
    {
        _S96 = true;
    }
    else
    {
        _S96 = (any((top_0 >= (cell_of_0(grid_3.top_size_0)))));
    }
    if(_S96)
    {
        return u32(4294967295);
    }
    var cell_2 : u32 = cell_word_0(grid_3.top_offset_0 + u32((top_0.z * grid_3.top_size_0[i32(1)] + top_0.y) * grid_3.top_size_0[i32(0)] + top_0.x));
    var shift_1 : u32 = grid_3.top_shift_0;
    for(;;)
    {
        if(shift_1 > u32(3))
        {
            _S96 = ((cell_2 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S96 = false;
        }
        if(_S96)
        {
        }
        else
        {
            break;
        }
        var shift_2 : u32 = shift_1 - u32(2);
        cell_2 = cell_word_0(((cell_2 & (u32(2147483647)))) * u32(64) + cell_in_node_0(relative_1, shift_2));
        shift_1 = shift_2;
    }
    if(((cell_2 & (u32(2147483648)))) == u32(0))
    {
        cell_2 = u32(4294967295);
    }
    else
    {
        cell_2 = record_of_cell_0(cell_2);
    }
    return cell_2;
}

fn place_of_brick_0( index_8 : u32) -> u32
{
    return index_8;
}

fn brick_word_0( index_9 : u32) -> u32
{
    return bricks_0[place_of_brick_0(index_9)];
}

fn rank_in_brick_0( record_0 : u32,  relative_2 : vec3<i32>) -> u32
{
    var bit_0 : u32 = cell_in_node_0(relative_2, u32(0));
    var present_before_0 : u32 = countOneBits(((brick_word_0(record_0)) & ((((u32(1) << (((((u32(((((relative_2.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_2.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_2.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_10 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_10 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S97 : u32 = u32(2) * index_10;
        var rank_1 : u32 = rank_0 + (countOneBits(brick_word_0(record_0 + u32(2) + _S97)) + countOneBits(brick_word_0(record_0 + u32(3) + _S97)));
        index_10 = index_10 + u32(1);
        rank_0 = rank_1;
    }
    var _S98 : u32 = u32(2) * present_before_0;
    var low_2 : u32 = brick_word_0(record_0 + u32(2) + _S98);
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_2 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_2) + countOneBits(((brick_word_0(record_0 + u32(3) + _S98)) & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_11 : u32) -> u32
{
    return index_11;
}

fn material_word_0( index_12 : u32) -> u32
{
    return brick_materials_0[place_of_material_0(index_12)];
}

fn read_bits_0( start_0 : u32,  position_0 : u32,  count_1 : u32) -> u32
{
    if(count_1 == u32(0))
    {
        return u32(0);
    }
    var word_4 : u32 = start_0 + ((position_0 >> (u32(5))));
    var shift_3 : u32 = (position_0 & (u32(31)));
    var bits_1 : u32 = ((material_word_0(word_4)) >> (shift_3));
    var bits_2 : u32;
    if((shift_3 + count_1) > u32(32))
    {
        bits_2 = (bits_1 | ((((material_word_0(word_4 + u32(1))) << ((u32(32) - shift_3))))));
    }
    else
    {
        bits_2 = bits_1;
    }
    return (bits_2 & ((((u32(1) << (count_1))) - u32(1))));
}

fn material_of_rank_0( grid_4 : PackedGrid_0,  record_1 : u32,  rank_2 : u32) -> u32
{
    var header_0 : u32 = brick_word_0(record_1);
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var start_1 : u32 = brick_word_0(record_1 + u32(1));
    var index_13 : u32 = read_bits_0(start_1, palette_count_0 * grid_4.material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_13;
    }
    return read_bits_0(start_1, index_13 * grid_4.material_bits_0, grid_4.material_bits_0);
}

fn material_at_0( grid_5 : PackedGrid_0,  relative_3 : vec3<i32>) -> u32
{
    var record_2 : u32 = find_brick_0(grid_5, relative_3);
    return material_of_rank_0(grid_5, record_2, rank_in_brick_0(record_2, relative_3));
}

fn material_of_0( hit_0 : Hit_0) -> PackedMaterial_0
{
    var _S99 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(hit_0.instance_1).grid_0);
    return material_of_index_0(material_at_0(_S99, hit_0.voxel_1 - cell_of_0(_S99.origin_4)));
}

fn material_met_0( path_3 : Path_0,  hit_1 : Hit_0,  beyond_1 : u32) -> PackedMaterial_0
{
    return material_of_0(hit_1);
}

fn emitted_0( material_3 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_3.emission_0) * vec3<f32>(params_0.emitter_intensity_0);
}

fn EmitterTree_le_0( material_4 : PackedMaterial_0) -> vec3<f32>
{
    return emitted_0(material_4);
}

fn luminance_0( color_1 : vec3<f32>) -> f32
{
    return color_1.x * 0.2125999927520752f + color_1.y * 0.71520000696182251f + color_1.z * 0.07220000028610229f;
}

struct Aim_0
{
     is_met_0 : bool,
     direction_17 : vec3<f32>,
     hit_2 : Hit_0,
     luminance_1 : f32,
};

fn Aim_x24init_0( is_met_1 : bool,  direction_18 : vec3<f32>,  hit_3 : Hit_0,  luminance_2 : f32) -> Aim_0
{
    var _S100 : Aim_0;
    _S100.is_met_0 = is_met_1;
    _S100.direction_17 = direction_18;
    _S100.hit_2 = hit_3;
    _S100.luminance_1 = luminance_2;
    return _S100;
}

struct LightSample_0
{
     ray_4 : Ray_0,
     cos_theta_1 : f32,
     radiance_1 : vec3<f32>,
     pdf_2 : f32,
};

fn Ray_x24init_0( origin_5 : vec3<f32>,  t_min_1 : f32,  direction_19 : vec3<f32>,  t_max_1 : f32) -> Ray_0
{
    var _S101 : Ray_0;
    _S101.origin_1 = origin_5;
    _S101.t_min_0 = t_min_1;
    _S101.direction_1 = direction_19;
    _S101.t_max_0 = t_max_1;
    return _S101;
}

fn LightSample_x24init_0( ray_5 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_3 : f32) -> LightSample_0
{
    var _S102 : LightSample_0;
    _S102.ray_4 = ray_5;
    _S102.cos_theta_1 = cos_theta_2;
    _S102.radiance_1 = radiance_2;
    _S102.pdf_2 = pdf_3;
    return _S102;
}

fn no_light_0() -> LightSample_0
{
    var _S103 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S103, 0.0f, _S103, 0.0f), 0.0f, _S103, 0.0f);
}

fn sincos_turns_0( turns_1 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_1 * 4.0f + 0.5f);
    var x_7 : f32 = (turns_1 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_7 * x_7;
    var sin_1 : f32 = x_7 + x_7 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
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

fn ray_from_0( origin_6 : vec3<f32>,  direction_20 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_6, 0.0f, direction_20, (bitcast<f32>(infinity_bits_0)));
}

fn SunDisc_sample_0( receiver_9 : Receiver_0,  u_3 : vec4<f32>,  sample_2 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_3.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_1 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_0 : vec2<f32> = sincos_turns_0(u_3.w);
    var direction_21 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_1 * sin_cos_0.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_1 * sin_cos_0.x)));
    var cos_theta_3 : f32 = with_slack_0(receiver_9, dot_product_0(receiver_9.normal_1, direction_21));
    (*sample_2) = LightSample_x24init_0(ray_from_0(receiver_9.point_0, direction_21), cos_theta_3, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_3 > 0.0f;
}

struct ChosenDirection_0
{
     direction_22 : vec3<f32>,
     radiance_3 : vec3<f32>,
     pdf_4 : f32,
};

fn ChosenDirection_x24init_0( direction_23 : vec3<f32>,  radiance_4 : vec3<f32>,  pdf_5 : f32) -> ChosenDirection_0
{
    var _S104 : ChosenDirection_0;
    _S104.direction_22 = direction_23;
    _S104.radiance_3 = radiance_4;
    _S104.pdf_4 = pdf_5;
    return _S104;
}

fn direction_of_0( square_0 : vec2<f32>) -> vec3<f32>
{
    var u_4 : f32 = square_0.x * 2.0f - 1.0f;
    var v_4 : f32 = square_0.y * 2.0f - 1.0f;
    var _S105 : f32 = abs(u_4);
    var _S106 : f32 = abs(v_4);
    var height_1 : f32 = 1.0f - (_S105 + _S106);
    var radius_2 : f32 = 1.0f - abs(height_1);
    var turns_2 : f32;
    if(radius_2 > 0.0f)
    {
        turns_2 = (divide_0(_S106 - _S105, radius_2) + 1.0f) * 0.125f;
    }
    else
    {
        turns_2 = 0.0f;
    }
    var sin_cos_1 : vec2<f32> = sincos_turns_0(turns_2);
    var _S107 : f32 = radius_2 * radius_2;
    var across_0 : f32 = radius_2 * square_root_0(2.0f - _S107);
    var x_8 : f32 = sin_cos_1.y * across_0;
    var y_4 : f32 = sin_cos_1.x * across_0;
    var z_0 : f32 = 1.0f - _S107;
    if(u_4 < 0.0f)
    {
        turns_2 = - x_8;
    }
    else
    {
        turns_2 = x_8;
    }
    var _S108 : f32;
    if(v_4 < 0.0f)
    {
        _S108 = - y_4;
    }
    else
    {
        _S108 = y_4;
    }
    var _S109 : f32;
    if(height_1 < 0.0f)
    {
        _S109 = - z_0;
    }
    else
    {
        _S109 = z_0;
    }
    return vec3<f32>(turns_2, _S108, _S109);
}

fn Environment_to_world_0( d_2 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S110 : f32 = d_2.x;
    var _S111 : f32 = d_2.y;
    return vec3<f32>(_S110 * cos_3 + _S111 * sin_2, _S111 * cos_3 - _S110 * sin_2, d_2.z);
}

fn Environment_choose_0( u_5 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S112 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S112, _S112, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S113 : f32 = u_5.x * edge_0;
    var _S114 : f32 = edge_0 - 1.0f;
    var _S115 : f32 = min(floor(_S113), _S114);
    var own_1 : u32 = u32(_S115) * params_0.sky_edge_0 + u32(min(floor(u_5.y * edge_0), _S114));
    var index_14 : u32;
    if((u_5.z) < (environment_0[own_1].threshold_0))
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
    var _S116 : u32 = index_14 % params_0.sky_edge_0;
    var _S117 : f32 = f32(_S116);
    var _S118 : u32 = index_14 / params_0.sky_edge_0;
    var place_2 : vec2<f32> = vec2<f32>(_S117, f32(_S118)) + vec2<f32>(min(_S113 - _S115, 1.0f), u_5.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_2 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_2), pdf_6);
    return true;
}

fn Sky_sample_0( receiver_10 : Receiver_0,  u_6 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S119 : bool;
    if(SKY_0 != u32(1))
    {
        _S119 = true;
    }
    else
    {
        var _S120 : bool = Environment_choose_0(u_6, &(chosen_1));
        _S119 = !_S120;
    }
    if(_S119)
    {
        return false;
    }
    var cos_theta_4 : f32 = with_slack_0(receiver_10, dot_product_0(receiver_10.normal_1, chosen_1.direction_22));
    (*sample_3) = LightSample_x24init_0(ray_from_0(receiver_10.point_0, chosen_1.direction_22), cos_theta_4, chosen_1.radiance_3 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_4);
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
    var _S121 : Descent_0;
    _S121.node_3 = node_4;
    _S121.index_15 = index_16;
    _S121.count_2 = count_3;
    _S121.weight_0 = weight_1;
    _S121.total_0 = total_1;
    _S121.choice_0 = choice_1;
    _S121.is_far_3 = is_far_4;
    return _S121;
}

fn TopLights_node_0( index_17 : u32) -> LightNode_0
{
    return top_light_node_0(index_17);
}

fn Descent_at_0( this_16 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_5 : LightNode_0 = TopLights_node_0(root_2);
    (*this_16).node_3 = root_2;
    (*this_16).index_15 = node_5.index_2;
    (*this_16).count_2 = node_5.count_0;
    (*this_16).is_far_3 = false;
    return;
}

@id(1) override IS_SINGLE_0 : bool = false;

fn normal_or_zero_0( weight_2 : f32) -> f32
{
    var _S122 : f32;
    if(weight_2 < 1.17549435082228751e-38f)
    {
        _S122 = 0.0f;
    }
    else
    {
        _S122 = weight_2;
    }
    return _S122;
}

fn inverse_power_of_two_0( x_9 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_9))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_0 : f32) -> vec2<f32>
{
    var _S123 : f32 = normal_or_zero_0(left_0);
    var _S124 : f32 = normal_or_zero_0(right_0);
    var unit_0 : f32 = inverse_power_of_two_0(_S123 + _S124);
    return vec2<f32>(normal_or_zero_0(_S123 * unit_0), normal_or_zero_0(_S124 * unit_0));
}

fn weights_of_views_0( left_1 : View_0,  right_1 : View_0) -> vec2<f32>
{
    var near_1 : vec2<f32> = weights_of_0(left_1.of_nearest_0, right_1.of_nearest_0);
    var _S125 : f32 = near_1.x;
    var _S126 : f32 = near_1.y;
    var of_near_0 : f32 = _S125 + _S126;
    var of_all_0 : f32 = (left_1.importance_0 + right_1.importance_0) * 0.5f;
    return weights_of_0(left_1.importance_0 * of_near_0 + _S125 * of_all_0, right_1.importance_0 * of_near_0 + _S126 * of_all_0);
}

fn climb_0( receiver_11 : Receiver_0,  start_2 : u32,  descent_0 : ptr<function, Descent_0>) -> bool
{
    var node_6 : LightNode_0 = top_light_node_0(start_2);
    var at_0 : u32 = start_2;
    for(;;)
    {
        var _S127 : LightNode_0 = node_6;
        if((node_6.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S127.parent_0);
        var _S128 : u32 = _S127.parent_0 + u32(1);
        var is_left_0 : bool = at_0 == _S128;
        var _S129 : u32;
        if(is_left_0)
        {
            _S129 = parent_1.index_2;
        }
        else
        {
            _S129 = _S128;
        }
        var own_2 : View_0 = view_0(node_6, receiver_11);
        var other_1 : View_0 = view_0(top_light_node_0(_S129), receiver_11);
        var weights_0 : vec2<f32>;
        if(is_left_0)
        {
            weights_0 = weights_of_views_0(own_2, other_1);
        }
        else
        {
            weights_0 = weights_of_views_0(other_1, own_2);
        }
        var _S130 : f32 = weights_0.x;
        var _S131 : f32 = weights_0.y;
        var total_2 : f32 = _S130 + _S131;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S132 : f32;
        if(is_left_0)
        {
            _S132 = _S130;
        }
        else
        {
            _S132 = _S131;
        }
        (*descent_0).weight_0 = (*descent_0).weight_0 * _S132;
        (*descent_0).total_0 = (*descent_0).total_0 * total_2;
        node_6 = parent_1;
        at_0 = _S127.parent_0;
    }
    return ((*descent_0).weight_0) > 0.0f;
}

fn Hit_x24init_0( t_2 : f32,  instance_5 : u32,  voxel_3 : vec3<i32>,  face_2 : u32) -> Hit_0
{
    var _S133 : Hit_0;
    _S133.t_0 = t_2;
    _S133.instance_1 = instance_5;
    _S133.voxel_1 = voxel_3;
    _S133.face_0 = face_2;
    return _S133;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>(infinity_bits_0)), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn by_chance_0() -> Aim_0
{
    return Aim_x24init_0(false, vec3<f32>(0.0f), miss_0(), 0.0f);
}

fn waits_for_pages_0() -> bool
{
    return false;
}

fn descend_0( receiver_12 : Receiver_0,  aim_0 : Aim_0,  descent_1 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S134 : bool;
        if(((*descent_1).count_2) == u32(0))
        {
            _S134 = !(*descent_1).is_far_3;
        }
        else
        {
            _S134 = false;
        }
        if(_S134)
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
        var _S135 : f32 = weights_1.x;
        var _S136 : f32 = weights_1.y;
        var total_3 : f32 = _S135 + _S136;
        if(!(total_3 > 0.0f))
        {
            return false;
        }
        var _S137 : bool;
        if(_S136 <= 0.0f)
        {
            _S137 = true;
        }
        else
        {
            _S137 = ((*descent_1).choice_0 * total_3) < (_S135 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_0.is_met_0)
        {
            var _S138 : vec3<f32> = vec3<f32>(aim_0.hit_2.voxel_1);
            if((all((_S138 >= (vector_of_0(left_2.min_0))))))
            {
                is_left_1 = (all((_S138 < (vector_of_0(left_2.max_0)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S137;
        }
        var _S139 : f32 = (*descent_1).choice_0 * total_3;
        var _S140 : f32;
        if(is_left_1)
        {
            _S140 = 0.0f;
        }
        else
        {
            _S140 = _S135 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S139 - _S140;
        var _S141 : u32;
        if(is_left_1)
        {
            _S141 = (*descent_1).node_3 + u32(1);
        }
        else
        {
            _S141 = (*descent_1).index_15;
        }
        (*descent_1).node_3 = _S141;
        var _S142 : u32;
        if(is_left_1)
        {
            _S142 = left_2.index_2;
        }
        else
        {
            _S142 = right_2.index_2;
        }
        (*descent_1).index_15 = _S142;
        var _S143 : u32;
        if(is_left_1)
        {
            _S143 = left_2.count_0;
        }
        else
        {
            _S143 = right_2.count_0;
        }
        (*descent_1).count_2 = _S143;
        (*descent_1).is_far_3 = false;
        var _S144 : f32;
        if(is_left_1)
        {
            _S144 = _S135;
        }
        else
        {
            _S144 = _S136;
        }
        var _S145 : f32 = (*descent_1).weight_0 * _S144;
        (*descent_1).weight_0 = _S145;
        (*descent_1).total_0 = (*descent_1).total_0 * total_3;
        if(_S145 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Transform_point_0( this_17 : Transform_0,  v_5 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(this_17, v_5) + vector_of_0(this_17.translation_0);
}

fn normalize_vector_0( vector_2 : vec3<f32>) -> vec3<f32>
{
    return vector_2 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_2))));
}

fn in_grid_0( instance_6 : u32,  receiver_13 : Receiver_0) -> Receiver_0
{
    if(IS_SINGLE_0)
    {
        return receiver_13;
    }
    var _S146 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(instance_6);
    return Receiver_x24init_0(Transform_point_0(_S146.grid_from_world_0, receiver_13.point_0), normalize_vector_0(Transform_direction_0(_S146.grid_from_world_0, receiver_13.normal_1)));
}

fn lights_in_pages_0() -> bool
{
    return false;
}

fn Rows_operatorx5Bx5D_get_4( row_6 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(5)) + row_6];
}

fn place_in_light_node_0( node_7 : u32,  word_5 : u32) -> u32
{
    return u32(0);
}

fn light_node_at_0( index_18 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S147 : u32 = u32(4) * index_18;
        return light_node_of_0(Rows_operatorx5Bx5D_get_4(_S147), Rows_operatorx5Bx5D_get_4(_S147 + u32(1)), Rows_operatorx5Bx5D_get_4(_S147 + u32(2)), Rows_operatorx5Bx5D_get_4(_S147 + u32(3)));
    }
    var at_1 : u32 = place_in_light_node_0(index_18, u32(0));
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
        node_8.min_0[i_0] = (bitcast<f32>((cells_1[at_1 + i_0])));
        node_8.max_0[i_0] = (bitcast<f32>((cells_1[at_1 + u32(4) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.index_2 = cells_1[at_1 + u32(3)];
    node_8.count_0 = cells_1[at_1 + u32(7)];
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
        node_8.power_2[i_0] = (bitcast<f32>((cells_1[at_1 + u32(8) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_8.parent_0 = cells_1[at_1 + u32(14)];
    node_8.root_1 = cells_1[at_1 + u32(15)];
    return node_8;
}

fn GridLights_node_0( index_19 : u32) -> LightNode_0
{
    return light_node_at_0(index_19);
}

fn Descent_at_1( this_18 : ptr<function, Descent_0>,  root_3 : u32)
{
    var node_9 : LightNode_0 = GridLights_node_0(root_3);
    (*this_18).node_3 = root_3;
    (*this_18).index_15 = node_9.index_2;
    (*this_18).count_2 = node_9.count_0;
    (*this_18).is_far_3 = false;
    return;
}

fn descend_1( receiver_14 : Receiver_0,  aim_1 : Aim_0,  descent_2 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S148 : bool;
        if(((*descent_2).count_2) == u32(0))
        {
            _S148 = !(*descent_2).is_far_3;
        }
        else
        {
            _S148 = false;
        }
        if(_S148)
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
        var _S149 : f32 = weights_2.x;
        var _S150 : f32 = weights_2.y;
        var total_4 : f32 = _S149 + _S150;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S151 : bool;
        if(_S150 <= 0.0f)
        {
            _S151 = true;
        }
        else
        {
            _S151 = ((*descent_2).choice_0 * total_4) < (_S149 * (*descent_2).weight_0);
        }
        var is_left_2 : bool;
        if(aim_1.is_met_0)
        {
            var _S152 : vec3<f32> = vec3<f32>(aim_1.hit_2.voxel_1);
            if((all((_S152 >= (vector_of_0(left_3.min_0))))))
            {
                is_left_2 = (all((_S152 < (vector_of_0(left_3.max_0)))));
            }
            else
            {
                is_left_2 = false;
            }
        }
        else
        {
            is_left_2 = _S151;
        }
        var _S153 : f32 = (*descent_2).choice_0 * total_4;
        var _S154 : f32;
        if(is_left_2)
        {
            _S154 = 0.0f;
        }
        else
        {
            _S154 = _S149 * (*descent_2).weight_0;
        }
        (*descent_2).choice_0 = _S153 - _S154;
        var _S155 : u32;
        if(is_left_2)
        {
            _S155 = (*descent_2).node_3 + u32(1);
        }
        else
        {
            _S155 = (*descent_2).index_15;
        }
        (*descent_2).node_3 = _S155;
        var _S156 : u32;
        if(is_left_2)
        {
            _S156 = left_3.index_2;
        }
        else
        {
            _S156 = right_3.index_2;
        }
        (*descent_2).index_15 = _S156;
        var _S157 : u32;
        if(is_left_2)
        {
            _S157 = left_3.count_0;
        }
        else
        {
            _S157 = right_3.count_0;
        }
        (*descent_2).count_2 = _S157;
        var _S158 : bool;
        if(is_left_2)
        {
            _S158 = of_left_0.is_far_0;
        }
        else
        {
            _S158 = of_right_0.is_far_0;
        }
        (*descent_2).is_far_3 = _S158;
        var _S159 : f32;
        if(is_left_2)
        {
            _S159 = _S149;
        }
        else
        {
            _S159 = _S150;
        }
        var _S160 : f32 = (*descent_2).weight_0 * _S159;
        (*descent_2).weight_0 = _S160;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        if(_S160 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn choose_side_0( point_3 : vec3<f32>,  is_met_2 : bool,  way_0 : Descent_0,  side_0 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var sent_0 : BySide_0 = sent_by_side_0(light_node_at_0(way_0.node_3), point_3);
    var sum_0 : f32 = normal_or_zero_0(BySide_sum_0(sent_0));
    var unit_1 : f32 = inverse_power_of_two_0(sum_0);
    var total_5 : f32 = sum_0 * unit_1;
    var _S161 : f32 = way_0.choice_0 * total_5;
    var _S162 : u32 = (*side_0);
    var share_1 : f32 = normal_or_zero_0(sent_0.low_0[u32(0)] * unit_1);
    var _S163 : bool;
    if(is_met_2)
    {
        _S163 = u32(0) == _S162;
    }
    else
    {
        _S163 = share_1 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S163)
    {
        (*side_0) = u32(0);
        chosen_2 = share_1;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S164 : bool = _S161 < (share_1 * way_0.weight_0);
    var share_2 : f32 = normal_or_zero_0(sent_0.high_0[u32(0)] * unit_1);
    if(is_met_2)
    {
        _S163 = u32(1) == _S162;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S163 = !_S164;
        }
        else
        {
            _S163 = false;
        }
    }
    if(_S163)
    {
        (*side_0) = u32(1);
        chosen_2 = share_2;
    }
    var passed_0 : f32 = share_1 + share_2;
    if(_S164)
    {
        _S163 = true;
    }
    else
    {
        _S163 = _S161 < (passed_0 * way_0.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_0.low_0[u32(1)] * unit_1);
    var _S165 : bool;
    if(is_met_2)
    {
        _S165 = u32(2) == _S162;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S165 = !_S163;
        }
        else
        {
            _S165 = false;
        }
    }
    if(_S165)
    {
        (*side_0) = u32(2);
        chosen_2 = share_3;
    }
    var passed_1 : f32 = passed_0 + share_3;
    if(_S163)
    {
        _S163 = true;
    }
    else
    {
        _S163 = _S161 < (passed_1 * way_0.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_0.high_0[u32(1)] * unit_1);
    if(is_met_2)
    {
        _S165 = u32(3) == _S162;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S165 = !_S163;
        }
        else
        {
            _S165 = false;
        }
    }
    if(_S165)
    {
        (*side_0) = u32(3);
        chosen_2 = share_4;
    }
    var passed_2 : f32 = passed_1 + share_4;
    if(_S163)
    {
        _S163 = true;
    }
    else
    {
        _S163 = _S161 < (passed_2 * way_0.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_0.low_0[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S165 = u32(4) == _S162;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S165 = !_S163;
        }
        else
        {
            _S165 = false;
        }
    }
    if(_S165)
    {
        (*side_0) = u32(4);
        chosen_2 = share_5;
    }
    var passed_3 : f32 = passed_2 + share_5;
    if(_S163)
    {
        _S163 = true;
    }
    else
    {
        _S163 = _S161 < (passed_3 * way_0.weight_0);
    }
    var share_6 : f32 = normal_or_zero_0(sent_0.high_0[u32(2)] * unit_1);
    if(is_met_2)
    {
        _S163 = u32(5) == _S162;
    }
    else
    {
        if(share_6 > 0.0f)
        {
            _S163 = !_S163;
        }
        else
        {
            _S163 = false;
        }
    }
    if(_S163)
    {
        (*side_0) = u32(5);
        chosen_2 = share_6;
    }
    (*odds_0) = vec2<f32>(way_0.weight_0 * chosen_2, way_0.total_0 * total_5);
    if(sum_0 > 0.0f)
    {
        _S163 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S163 = false;
    }
    return _S163;
}

fn light_node_word_0( index_20 : u32,  word_6 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_4(u32(4) * index_20 + ((word_6 >> (u32(2)))))[(word_6 & (u32(3)))];
}

fn light_power_at_0( index_21 : u32,  side_1 : u32) -> f32
{
    var _S166 : u32;
    if(lights_in_pages_0())
    {
        _S166 = cells_1[place_in_light_node_0(index_21, u32(8) + side_1)];
    }
    else
    {
        _S166 = light_node_word_0(index_21, u32(8) + side_1);
    }
    return (bitcast<f32>((_S166)));
}

fn component_0( vector_3 : vec3<f32>,  axis_0 : u32) -> f32
{
    return select(select(vector_3.z, vector_3.y, axis_0 == u32(1)), vector_3.x, axis_0 == u32(0));
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
     voxel_4 : array<i32, i32(3)>,
     grid_6 : u32,
     faces_0 : u32,
     material_5 : u32,
     luminance_4 : f32,
     leaf_0 : u32,
};

fn below_light_node_0( index_22 : u32) -> vec2<u32>
{
    if(!lights_in_pages_0())
    {
        return vec2<u32>(light_node_word_0(index_22, u32(3)), light_node_word_0(index_22, u32(7)));
    }
    var at_2 : u32 = place_in_light_node_0(index_22, u32(0));
    return vec2<u32>(cells_1[at_2 + u32(3)], cells_1[at_2 + u32(7)]);
}

fn place_in_emitter_0( emitter_0 : u32,  word_7 : u32) -> u32
{
    return u32(0);
}

fn Rows_operatorx5Bx5D_get_5( row_7 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(4)) + row_7];
}

fn emitter_word_0( index_23 : u32,  word_8 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_5(u32(2) * index_23 + ((word_8 >> (u32(2)))))[(word_8 & (u32(3)))];
}

fn emitter_faces_at_0( index_24 : u32) -> u32
{
    var _S167 : u32;
    if(lights_in_pages_0())
    {
        _S167 = cells_1[place_in_emitter_0(index_24, u32(4))];
    }
    else
    {
        _S167 = emitter_word_0(index_24, u32(4));
    }
    return _S167;
}

fn emitter_luminance_at_0( index_25 : u32) -> f32
{
    var _S168 : f32;
    if(lights_in_pages_0())
    {
        _S168 = (bitcast<f32>((cells_1[place_in_emitter_0(index_25, u32(6))])));
    }
    else
    {
        _S168 = (bitcast<f32>((emitter_word_0(index_25, u32(6)))));
    }
    return _S168;
}

fn Emitter_x24init_0( voxel_5 : array<i32, i32(3)>,  grid_7 : u32,  faces_1 : u32,  material_6 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S169 : Emitter_0;
    _S169.voxel_4 = voxel_5;
    _S169.grid_6 = grid_7;
    _S169.faces_0 = faces_1;
    _S169.material_5 = material_6;
    _S169.luminance_4 = luminance_5;
    _S169.leaf_0 = leaf_1;
    return _S169;
}

fn emitter_at_0( index_26 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S170 : u32 = u32(2) * index_26;
        var _S171 : vec4<u32> = Rows_operatorx5Bx5D_get_5(_S170);
        var _S172 : vec4<u32> = Rows_operatorx5Bx5D_get_5(_S170 + u32(1));
        var _S173 : array<i32, i32(3)> = array<i32, i32(3)>( i32(_S171.x), i32(_S171.y), i32(_S171.z) );
        return Emitter_x24init_0(_S173, _S171.w, _S172.x, _S172.y, (bitcast<f32>((_S172.z))), _S172.w);
    }
    var at_3 : u32 = place_in_emitter_0(index_26, u32(0));
    var _S174 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_1[at_3]), i32(cells_1[at_3 + u32(1)]), i32(cells_1[at_3 + u32(2)]) );
    return Emitter_x24init_0(_S174, cells_1[at_3 + u32(3)], cells_1[at_3 + u32(4)], cells_1[at_3 + u32(5)], (bitcast<f32>((cells_1[at_3 + u32(6)]))), cells_1[at_3 + u32(7)]);
}

fn choose_emitter_0( way_1 : Descent_0,  side_2 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_0 : bool;
    var is_left_3 : bool;
    var count_4 : u32 = way_1.count_2;
    var node_10 : u32 = way_1.node_3;
    var index_27 : u32 = way_1.index_15;
    var _S175 : f32 = threshold_1;
    for(;;)
    {
        if(count_4 == u32(0))
        {
            is_found_0 = !waits_for_pages_0();
        }
        else
        {
            is_found_0 = false;
        }
        if(is_found_0)
        {
        }
        else
        {
            break;
        }
        var left_4 : u32 = node_10 + u32(1);
        var power_left_0 : f32 = light_power_at_0(left_4, side_2);
        if(_S175 < power_left_0)
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
            _S175 = _S175 - power_left_0;
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
        var _S176 : u32 = below_0.x;
        count_4 = below_0.y;
        index_27 = _S176;
    }
    is_found_0 = false;
    var chosen_3 : u32 = index_27;
    var at_4 : u32 = index_27;
    for(;;)
    {
        if(at_4 < (index_27 + count_4))
        {
            is_left_3 = !is_found_0;
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
        if((((((emitter_faces_at_0(at_4)) >> (side_2))) & (u32(1)))) != u32(0))
        {
            var _S177 : f32 = _S175 - emitter_luminance_at_0(at_4);
            is_found_0 = _S175 < (emitter_luminance_at_0(at_4));
            chosen_3 = at_4;
            _S175 = _S177;
        }
        at_4 = at_4 + u32(1);
    }
    return emitter_at_0(chosen_3);
}

fn point_of_face_0( low_3 : vec3<f32>,  face_4 : u32,  u_7 : f32,  v_6 : f32) -> vec3<f32>
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
        return low_3 + vec3<f32>(away_0, u_7, v_6);
    }
    if(face_4 < u32(4))
    {
        return low_3 + vec3<f32>(u_7, away_0, v_6);
    }
    return low_3 + vec3<f32>(u_7, v_6, away_0);
}

fn margin_of_0( translation_1 : vec3<f32>,  low_4 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_4) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn offset_ray_origin_0( translation_2 : vec3<f32>,  low_5 : vec3<f32>,  face_5 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_5);
    var _S178 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_4, low_5 + _S178), low_5 + vec3<f32>((1.0f - margin_0)));
    var _S179 : bool = face_5 < u32(2);
    var _S180 : bool;
    if(face_5 >= u32(2))
    {
        _S180 = face_5 < u32(4);
    }
    else
    {
        _S180 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S179, _S180, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_5 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_5 - _S178;
    }
    return select(moved_0, outside_0, is_axis_0);
}

fn sample_emitter_0( receiver_15 : Receiver_0,  u_8 : vec4<f32>,  aim_2 : Aim_0,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    (*sample_4) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_8.x, false);
    Descent_at_0(&(descent_3), u32(0));
    var _S181 : bool;
    if(!IS_SINGLE_0)
    {
        _S181 = aim_2.is_met_0;
    }
    else
    {
        _S181 = false;
    }
    if(_S181)
    {
        var _S182 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(aim_2.hit_2.instance_1);
        if((_S182.light_leaf_0) == u32(4294967295))
        {
            _S181 = true;
        }
        else
        {
            var _S183 : bool = climb_0(receiver_15, _S182.light_leaf_0, &(descent_3));
            _S181 = !_S183;
        }
        if(_S181)
        {
            return false;
        }
        Descent_at_0(&(descent_3), _S182.light_leaf_0);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S184 : bool = descend_0(receiver_15, by_chance_0(), &(descent_3));
            _S181 = !_S184;
        }
        else
        {
            _S181 = false;
        }
        if(_S181)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_15;
    var local_0 : Receiver_0 = in_grid_0(descent_3.index_15, receiver_15);
    Descent_at_1(&(descent_3), top_light_node_0(descent_3.node_3).root_1);
    var _S185 : bool = descend_1(local_0, aim_2, &(descent_3));
    if(!_S185)
    {
        return false;
    }
    var side_3 : u32 = aim_2.hit_2.face_0;
    var odds_2 : vec2<f32>;
    var _S186 : bool = choose_side_0(local_0.point_0, aim_2.is_met_0, descent_3, &(side_3), &(odds_2));
    if(!_S186)
    {
        return false;
    }
    var power_4 : f32 = light_power_at_0(descent_3.node_3, side_3);
    var _S187 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(chosen_instance_0);
    if(aim_2.is_met_0)
    {
        var _S188 : f32 = density_0(odds_2, aim_2.luminance_1, power_4, Transform_direction_0(_S187.grid_from_world_0, aim_2.direction_17) * vec3<f32>(aim_2.hit_2.t_0), side_3);
        (*sample_4).pdf_2 = _S188;
        return _S188 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_3, u_8.y * power_4);
    var _S189 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_4));
    var on_face_0 : vec3<f32> = point_of_face_0(_S189, side_3, u_8.z, u_8.w);
    var pdf_7 : f32 = density_0(odds_2, emitter_1.luminance_4, power_4, on_face_0 - local_0.point_0, side_3);
    if(pdf_7 < 0.0f)
    {
        return false;
    }
    var direction_24 : vec3<f32> = Transform_point_0(_S187.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S187.grid_from_world_0.translation_0), _S189, side_3, on_face_0)) - receiver_15.point_0;
    var cos_theta_5 : f32 = with_slack_0(receiver_15, divide_0(dot_product_0(receiver_15.normal_1, direction_24), square_root_0(length_squared_0(direction_24))));
    (*sample_4) = LightSample_x24init_0(Ray_x24init_0(receiver_15.point_0, 0.0f, direction_24, 1.0f), cos_theta_5, emitted_0(material_of_index_0(emitter_1.material_5)), pdf_7);
    return cos_theta_5 > 0.0f;
}

fn EmitterTree_sample_0( receiver_16 : Receiver_0,  u_9 : vec4<f32>,  aim_3 : Aim_0,  sample_5 : ptr<function, LightSample_0>) -> bool
{
    var _S190 : bool = sample_emitter_0(receiver_16, u_9, aim_3, &((*sample_5)));
    return _S190;
}

fn Lights_sample_0( receiver_17 : Receiver_0,  selection_3 : Selection_0,  u_10 : vec4<f32>,  aim_4 : Aim_0,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var is_found_1 : bool;
    if(has_sun_0())
    {
        is_found_1 = !aim_4.is_met_0;
    }
    else
    {
        is_found_1 = false;
    }
    if(is_found_1)
    {
        is_found_1 = (u_10.x) < (selection_3.sun_0);
    }
    else
    {
        is_found_1 = false;
    }
    if(is_found_1)
    {
        var _S191 : bool = SunDisc_sample_0(receiver_17, u_10, &((*sample_6)));
        (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sun_0;
        is_found_1 = _S191;
    }
    else
    {
        if(Lights_has_chosen_sky_0())
        {
            is_found_1 = !aim_4.is_met_0;
        }
        else
        {
            is_found_1 = false;
        }
        if(is_found_1)
        {
            is_found_1 = (u_10.x) < (selection_3.sun_0 + selection_3.sky_1);
        }
        else
        {
            is_found_1 = false;
        }
        if(is_found_1)
        {
            var _S192 : bool = Sky_sample_0(receiver_17, vec4<f32>(min(divide_0(u_10.x - selection_3.sun_0, selection_3.sky_1), 0.99999994039535522f), u_10.yzw), &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.sky_1;
            is_found_1 = _S192;
        }
        else
        {
            var _S193 : bool = EmitterTree_sample_0(receiver_17, vec4<f32>(min(divide_0(u_10.x - (selection_3.sun_0 + selection_3.sky_1), selection_3.emitters_0), 0.99999994039535522f), u_10.yzw), aim_4, &((*sample_6)));
            (*sample_6).pdf_2 = (*sample_6).pdf_2 * selection_3.emitters_0;
            is_found_1 = _S193;
        }
    }
    return is_found_1;
}

fn ior_of_0( inside_3 : Inside_0) -> f32
{
    var _S194 : f32;
    if(Inside_is_in_0(inside_3))
    {
        _S194 = material_of_index_0(inside_3.material_0).ior_0;
    }
    else
    {
        _S194 = 1.0f;
    }
    return _S194;
}

fn Microfacets_x24init_0( alpha_1 : f32) -> Microfacets_0
{
    var _S195 : Microfacets_0;
    _S195.alpha_0 = alpha_1;
    return _S195;
}

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S196 : MaterialBsdf_0;
    _S196.kind_0 = kind_1;
    _S196.color_0 = color_2;
    _S196.specular_0 = specular_2;
    _S196.eta_0 = eta_1;
    _S196.facets_0 = facets_1;
    return _S196;
}

fn bsdf_of_0( material_7 : PackedMaterial_0,  ior_1 : f32,  choice_2 : ptr<function, f32>) -> MaterialBsdf_0
{
    return MaterialBsdf_x24init_0(u32(0), vector_of_0(material_7.base_color_0), 0.0f, 1.0f, Microfacets_x24init_0(1.0f));
}

fn MaterialBsdf_albedo_0( this_19 : MaterialBsdf_0) -> vec3<f32>
{
    return this_19.color_0;
}

var<private> ends_here_0 : bool;

fn roulette_0( event_1 : u32,  scattered_1 : vec3<f32>,  u_11 : f32) -> f32
{
    if(event_1 < u32(3))
    {
        return 1.0f;
    }
    var _S197 : f32 = min(max_element_0(scattered_1), 0.94999998807907104f);
    var _S198 : f32;
    if(u_11 < _S197)
    {
        _S198 = divide_0(1.0f, _S197);
    }
    else
    {
        _S198 = 0.0f;
    }
    return _S198;
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
    var _S199 : f32;
    if(face_6 < u32(2))
    {
        _S199 = away_1;
    }
    else
    {
        _S199 = 0.0f;
    }
    var _S200 : bool;
    if(face_6 >= u32(2))
    {
        _S200 = face_6 < u32(4);
    }
    else
    {
        _S200 = false;
    }
    var _S201 : f32;
    if(_S200)
    {
        _S201 = away_1;
    }
    else
    {
        _S201 = 0.0f;
    }
    if(face_6 >= u32(4))
    {
    }
    else
    {
        away_1 = 0.0f;
    }
    return vec3<f32>(_S199, _S201, away_1);
}

fn world_normal_0( instance_7 : PackedInstance_0,  face_7 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_0(instance_7.world_from_grid_0, face_normal_0(face_7)));
}

fn surface_of_0( ray_6 : Ray_0,  hit_4 : Hit_0) -> Surface_0
{
    var surface_1 : Surface_0;
    var _S202 : vec3<f32> = vec3<f32>(hit_4.voxel_1);
    if(IS_SINGLE_0)
    {
        surface_1.origin_3 = offset_ray_origin_0(vec3<f32>(0.0f), _S202, hit_4.face_0, ray_6.origin_1 + ray_6.direction_1 * vec3<f32>(hit_4.t_0));
        surface_1.normal_2 = face_normal_0(hit_4.face_0);
    }
    else
    {
        var _S203 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(hit_4.instance_1);
        surface_1.origin_3 = Transform_point_0(_S203.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S203.grid_from_world_0.translation_0), _S202, hit_4.face_0, Transform_point_0(_S203.grid_from_world_0, ray_6.origin_1) + Transform_direction_0(_S203.grid_from_world_0, ray_6.direction_1) * vec3<f32>(hit_4.t_0)));
        surface_1.normal_2 = world_normal_0(_S203, hit_4.face_0);
    }
    surface_1.face_1 = hit_4.face_0;
    surface_1.instance_3 = hit_4.instance_1;
    return surface_1;
}

fn Surface_local_direction_0( this_20 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_20.instance_3).grid_from_world_0, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_1 : vec3<f32>;
    if((this_20.face_1) < u32(2))
    {
        local_1 = in_grid_2.yzx;
    }
    else
    {
        if((this_20.face_1) < u32(4))
        {
            local_1 = in_grid_2.zxy;
        }
        else
        {
            local_1 = in_grid_2;
        }
    }
    if((((this_20.face_1) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_1;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_1.xy, - local_1.z);
    }
    return in_grid_1;
}

fn clamp_to_voxel_0( translation_3 : vec3<f32>,  low_6 : vec3<f32>,  point_5 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_6);
    return min(max(point_5, low_6 + vec3<f32>(margin_1)), low_6 + vec3<f32>((1.0f - margin_1)));
}

fn Inside_point_0( this_21 : Inside_0,  ray_7 : Ray_0,  t_3 : f32) -> vec3<f32>
{
    var _S204 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(this_21.instance_0);
    return Transform_point_0(_S204.world_from_grid_0, clamp_to_voxel_0(vector_of_0(_S204.grid_from_world_0.translation_0), vec3<f32>(this_21.voxel_0), Transform_point_0(_S204.grid_from_world_0, ray_7.origin_1) + Transform_direction_0(_S204.grid_from_world_0, ray_7.direction_1) * vec3<f32>(t_3)));
}

fn MaterialBsdf_is_delta_0( this_22 : MaterialBsdf_0) -> bool
{
    return false;
}

fn Scatter_x24init_0( path_4 : Path_0,  receiver_18 : Receiver_0,  surface_2 : Surface_0,  bsdf_1 : MaterialBsdf_0,  wo_1 : vec3<f32>,  compensation_1 : f32,  is_scattered_1 : bool,  wants_light_1 : bool) -> Scatter_0
{
    var _S205 : Scatter_0;
    _S205.path_0 = path_4;
    _S205.receiver_0 = receiver_18;
    _S205.surface_0 = surface_2;
    _S205.bsdf_0 = bsdf_1;
    _S205.wo_0 = wo_1;
    _S205.compensation_0 = compensation_1;
    _S205.is_scattered_0 = is_scattered_1;
    _S205.wants_light_0 = wants_light_1;
    return _S205;
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
    var _S206 : Diffuse_0;
    _S206.reflectance_0 = reflectance_1;
    return _S206;
}

fn cosine_hemisphere_0( u_12 : f32,  v_7 : f32) -> vec3<f32>
{
    var radius_3 : f32 = square_root_0(u_12);
    var sin_cos_2 : vec2<f32> = sincos_turns_0(v_7);
    return vec3<f32>(radius_3 * sin_cos_2.y, radius_3 * sin_cos_2.x, square_root_0(1.0f - u_12));
}

fn cosine_hemisphere_pdf_0( cos_theta_6 : f32) -> f32
{
    return max(cos_theta_6, 0.0f) * 0.31830987334251404f;
}

fn BsdfSample_x24init_0( wi_1 : vec3<f32>,  weight_4 : vec3<f32>,  pdf_9 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S207 : BsdfSample_0;
    _S207.wi_0 = wi_1;
    _S207.weight_3 = weight_4;
    _S207.pdf_8 = pdf_9;
    _S207.is_delta_0 = is_delta_1;
    return _S207;
}

fn Diffuse_sample_0( this_23 : Diffuse_0,  wo_2 : vec3<f32>,  u_13 : vec3<f32>,  sample_7 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_2 : vec3<f32> = cosine_hemisphere_0(u_13.x, u_13.y);
    (*sample_7) = BsdfSample_x24init_0(wi_2, this_23.reflectance_0, cosine_hemisphere_pdf_0(wi_2.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_24 : MaterialBsdf_0,  wo_3 : vec3<f32>,  u_14 : vec3<f32>,  sample_8 : ptr<function, BsdfSample_0>) -> bool
{
    var _S208 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_24.color_0), wo_3, u_14, &((*sample_8)));
    return _S208;
}

fn Surface_world_direction_0( this_25 : Surface_0,  local_2 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_25.face_1) & (u32(1)))) == u32(1))
    {
        away_2 = local_2.z;
    }
    else
    {
        away_2 = - local_2.z;
    }
    var _S209 : f32 = local_2.x;
    var _S210 : f32 = local_2.y;
    var _S211 : vec3<f32> = vec3<f32>(_S209, _S210, away_2);
    var in_grid_3 : vec3<f32>;
    if((this_25.face_1) < u32(2))
    {
        in_grid_3 = vec3<f32>(away_2, _S209, _S210);
    }
    else
    {
        if((this_25.face_1) < u32(4))
        {
            in_grid_3 = vec3<f32>(_S210, away_2, _S209);
        }
        else
        {
            in_grid_3 = _S211;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_3 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_25.instance_3).world_from_grid_0, in_grid_3);
    }
    return normalize_vector_0(in_grid_3);
}

fn PathTracingOf_advance_0( path_5 : ptr<function, Path_0>,  ray_8 : Ray_0,  hit_5 : Hit_0,  beyond_2 : u32,  radiance_5 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_0 : NextRays_0 = no_rays_0();
    scatter_of_path_0.wants_light_0 = false;
    var is_counted_0 : bool = Path_is_counted_0((*path_5));
    var t_4 : f32;
    if(is_counted_0)
    {
        t_4 = - (*path_5).pdf_1;
    }
    else
    {
        t_4 = (*path_5).pdf_1;
    }
    (*path_5).pdf_1 = t_4;
    var last_3 : Receiver_0 = Path_receiver_0((*path_5), ray_8);
    var is_scattered_2 : bool;
    if(Inside_is_in_0((*path_5).inside_0))
    {
        is_scattered_2 = Hit_is_miss_0(hit_5);
    }
    else
    {
        is_scattered_2 = false;
    }
    if(Inside_is_in_0((*path_5).inside_0))
    {
        if(is_scattered_2)
        {
            t_4 = scattering_t_0((*path_5), (*path_5).inside_0, ray_8);
        }
        else
        {
            t_4 = hit_5.t_0;
        }
        if(!is_counted_0)
        {
            absorb_0(&((*path_5)), (*path_5).inside_0, ray_8, t_4);
        }
    }
    else
    {
        t_4 = hit_5.t_0;
    }
    var is_weighed_0 : bool;
    if(Hit_is_miss_0(hit_5))
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
        (*radiance_5) = (*radiance_5) + (*path_5).beta_0 * Sky_le_0(ray_8.direction_1) * vec3<f32>(mis_weight_0((*path_5).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_5), last_3), ray_8.direction_1)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_2 = true;
            }
            else
            {
                is_scattered_2 = !Path_is_straight_0((*path_5));
            }
        }
        else
        {
            is_scattered_2 = false;
        }
        if(is_scattered_2)
        {
            var le_0 : vec3<f32> = SunDisc_le_0(ray_8.direction_1);
            if((max_element_0(le_0)) > 0.0f)
            {
                if(((*path_5).pdf_1) == 0.0f)
                {
                    light_pdf_1 = 0.0f;
                }
                else
                {
                    light_pdf_1 = Lights_sun_pdf_0(Path_selection_at_0((*path_5), last_3), ray_8.direction_1);
                }
                (*radiance_5) = (*radiance_5) + (*path_5).beta_0 * le_0 * vec3<f32>(mis_weight_0((*path_5).pdf_1, light_pdf_1));
            }
        }
        return next_0;
    }
    var u_15 : vec4<f32> = Sampler_stratified_0((*path_5).sampler_0, Path_dimension_scatter_0((*path_5)));
    var material_8 : PackedMaterial_0 = material_met_0((*path_5), hit_5, beyond_2);
    var _S212 : vec3<f32> = vec3<f32>(0.0f);
    var le_1 : vec3<f32>;
    if(!is_counted_0)
    {
        le_1 = EmitterTree_le_0(material_8);
    }
    else
    {
        le_1 = _S212;
    }
    var is_lit_0 : bool = (max_element_0(le_1)) > 0.0f;
    var met_0 : Aim_0 = Aim_x24init_0(true, ray_8.direction_1, hit_5, luminance_0(vector_of_0(material_8.emission_0)));
    var _S213 : bool = weighs_apart_0();
    if(_S213)
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
        if(!_S213)
        {
            is_chosen_0 = ((*path_5).pdf_1) > 0.0f;
        }
        else
        {
            is_chosen_0 = false;
        }
        if(is_chosen_0)
        {
            var _S214 : bool = Lights_sample_0(last_3, Path_selection_at_0((*path_5), last_3), vec4<f32>(0.0f), met_0, &(light_2));
            is_chosen_0 = _S214;
        }
        else
        {
            is_chosen_0 = false;
        }
        var _S215 : vec3<f32> = (*path_5).beta_0 * le_1;
        var _S216 : f32 = (*path_5).pdf_1;
        if(is_chosen_0)
        {
            light_pdf_1 = light_2.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + _S215 * vec3<f32>(mis_weight_0(_S216, light_pdf_1));
    }
    var _S217 : f32 = ior_of_0((*path_5).inside_0);
    var _S218 : f32 = u_15[i32(3)];
    var _S219 : MaterialBsdf_0 = bsdf_of_0(material_8, _S217, &(_S218));
    u_15[i32(3)] = _S218;
    var scattered_2 : vec3<f32> = (*path_5).beta_0 * MaterialBsdf_albedo_0(_S219);
    if(((*path_5).bounce_0) >= (params_0.max_bounces_0))
    {
        is_chosen_0 = true;
    }
    else
    {
        is_chosen_0 = ends_here_0;
    }
    var _S220 : bool = !is_weighed_0;
    if(_S220)
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
    var compensation_2 : f32 = roulette_0(Path_events_0((*path_5)), scattered_2, u_15.z);
    if(_S220)
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
    var at_5 : Hit_0;
    if(is_scattered_2)
    {
        at_5 = Hit_x24init_0(t_4, (*path_5).inside_0.instance_0, hit_5.voxel_1, u32(0));
    }
    else
    {
        at_5 = hit_5;
    }
    var surface_3 : Surface_0 = surface_of_0(ray_8, at_5);
    var _S221 : Receiver_0 = Receiver_x24init_0(surface_3.origin_3, surface_3.normal_2);
    var _S222 : vec3<f32> = (vec3<f32>(0) - ray_8.direction_1);
    var wo_4 : vec3<f32> = Surface_local_direction_0(surface_3, _S222);
    var inside_4 : Inside_0 = in_air_0();
    var wo_5 : vec3<f32>;
    var receiver_19 : Receiver_0;
    if(is_scattered_2)
    {
        var _S223 : Inside_0 = Inside_x24init_0((*path_5).inside_0.instance_0, hit_5.voxel_1, (*path_5).inside_0.material_0);
        inside_4 = _S223;
        var _S224 : vec3<f32> = normalize_vector_0(_S222);
        receiver_19 = Receiver_x24init_0(Inside_point_0(_S223, ray_8, t_4), _S212);
        wo_5 = _S224;
    }
    else
    {
        if(Inside_is_in_0((*path_5).inside_0))
        {
            next_0.relocates_0 = (hit_5.instance_1) != ((*path_5).inside_0.instance_0);
            inside_4 = Inside_x24init_0((*path_5).inside_0.instance_0, hit_5.voxel_1, (*path_5).inside_0.material_0);
            inside_4.voxel_0 = hit_5.voxel_1 + vec3<i32>(face_normal_0(hit_5.face_0));
        }
        receiver_19 = _S221;
        wo_5 = wo_4;
    }
    next_0.origin_0 = receiver_19.point_0;
    next_0.shadow_inside_0 = inside_4;
    if(is_weighed_0)
    {
        receiver_19 = last_3;
    }
    if(_S220)
    {
        (*path_5).selection_0 = Lights_selection_0(receiver_19);
    }
    var light_3 : LightSample_0 = no_light_0();
    var _S225 : bool = !MaterialBsdf_is_delta_0(_S219);
    scatter_of_path_0 = Scatter_x24init_0((*path_5), receiver_19, surface_3, _S219, wo_5, compensation_2, is_scattered_2, _S225);
    if(is_weighed_0)
    {
        if(next_0.has_shadow_ray_0)
        {
            light_pdf_1 = light_3.pdf_2;
        }
        else
        {
            light_pdf_1 = 0.0f;
        }
        (*radiance_5) = (*radiance_5) + (*path_5).beta_0 * le_1 * vec3<f32>(mis_weight_0((*path_5).pdf_1, light_pdf_1));
        (*path_5).pdf_1 = - (*path_5).pdf_1;
        next_0.is_same_0 = true;
        return next_0;
    }
    var bounce_1 : BsdfSample_0;
    var _S226 : bool = MaterialBsdf_sample_0(_S219, wo_5, vec3<f32>(u_15.xy, u_15.w), &(bounce_1));
    if(!_S226)
    {
        return next_0;
    }
    (*path_5).beta_0 = (*path_5).beta_0 * bounce_1.weight_3 * vec3<f32>(compensation_2);
    if(bounce_1.is_delta_0)
    {
        t_4 = 0.0f;
    }
    else
    {
        t_4 = bounce_1.pdf_8;
    }
    (*path_5).pdf_1 = t_4;
    (*path_5).normal_0 = receiver_19.normal_1;
    next_0.direction_0 = bounce_1.wi_0;
    if(!is_scattered_2)
    {
        next_0.direction_0 = Surface_world_direction_0(surface_3, bounce_1.wi_0);
    }
    next_0.path_relocates_0 = next_0.relocates_0;
    (*path_5).bounce_0 = (*path_5).bounce_0 + u32(1);
    return next_0;
}

fn PathTracingOf_advance_1( path_6 : ptr<function, Path_0>,  ray_9 : Ray_0,  hit_6 : Hit_0,  beyond_3 : u32,  radiance_6 : ptr<function, vec3<f32>>) -> NextRays_0
{
    var next_1 : NextRays_0 = no_rays_0();
    scatter_of_path_0.wants_light_0 = false;
    var is_counted_1 : bool = Path_is_counted_0((*path_6));
    var t_5 : f32;
    if(is_counted_1)
    {
        t_5 = - (*path_6).pdf_1;
    }
    else
    {
        t_5 = (*path_6).pdf_1;
    }
    (*path_6).pdf_1 = t_5;
    var last_4 : Receiver_0 = Path_receiver_0((*path_6), ray_9);
    var is_scattered_3 : bool;
    if(Inside_is_in_0((*path_6).inside_0))
    {
        is_scattered_3 = Hit_is_miss_0(hit_6);
    }
    else
    {
        is_scattered_3 = false;
    }
    if(Inside_is_in_0((*path_6).inside_0))
    {
        if(is_scattered_3)
        {
            t_5 = scattering_t_0((*path_6), (*path_6).inside_0, ray_9);
        }
        else
        {
            t_5 = hit_6.t_0;
        }
        if(!is_counted_1)
        {
            absorb_0(&((*path_6)), (*path_6).inside_0, ray_9, t_5);
        }
    }
    else
    {
        t_5 = hit_6.t_0;
    }
    var is_weighed_1 : bool;
    if(Hit_is_miss_0(hit_6))
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
        (*radiance_6) = (*radiance_6) + (*path_6).beta_0 * Sky_le_0(ray_9.direction_1) * vec3<f32>(mis_weight_0((*path_6).pdf_1, Lights_sky_pdf_0(Path_selection_at_0((*path_6), last_4), ray_9.direction_1)));
        if(has_sun_0())
        {
            if(SunDisc_is_visible_0())
            {
                is_scattered_3 = true;
            }
            else
            {
                is_scattered_3 = !Path_is_straight_0((*path_6));
            }
        }
        else
        {
            is_scattered_3 = false;
        }
        if(is_scattered_3)
        {
            var le_2 : vec3<f32> = SunDisc_le_0(ray_9.direction_1);
            if((max_element_0(le_2)) > 0.0f)
            {
                if(((*path_6).pdf_1) == 0.0f)
                {
                    light_pdf_2 = 0.0f;
                }
                else
                {
                    light_pdf_2 = Lights_sun_pdf_0(Path_selection_at_0((*path_6), last_4), ray_9.direction_1);
                }
                (*radiance_6) = (*radiance_6) + (*path_6).beta_0 * le_2 * vec3<f32>(mis_weight_0((*path_6).pdf_1, light_pdf_2));
            }
        }
        return next_1;
    }
    var u_16 : vec4<f32> = Sampler_stratified_0((*path_6).sampler_0, Path_dimension_scatter_0((*path_6)));
    var material_9 : PackedMaterial_0 = material_met_0((*path_6), hit_6, beyond_3);
    var _S227 : vec3<f32> = vec3<f32>(0.0f);
    var le_3 : vec3<f32>;
    if(!is_counted_1)
    {
        le_3 = EmitterTree_le_0(material_9);
    }
    else
    {
        le_3 = _S227;
    }
    var is_lit_1 : bool = (max_element_0(le_3)) > 0.0f;
    if(weighs_apart_0())
    {
        is_weighed_1 = is_lit_1;
    }
    else
    {
        is_weighed_1 = false;
    }
    if(is_weighed_1)
    {
        is_weighed_1 = ((*path_6).pdf_1) > 0.0f;
    }
    else
    {
        is_weighed_1 = false;
    }
    var _S228 : bool;
    if(is_lit_1)
    {
        _S228 = !is_weighed_1;
    }
    else
    {
        _S228 = false;
    }
    if(_S228)
    {
        (*radiance_6) = (*radiance_6) + (*path_6).beta_0 * le_3 * vec3<f32>(mis_weight_0((*path_6).pdf_1, 0.0f));
    }
    var _S229 : f32 = ior_of_0((*path_6).inside_0);
    var _S230 : f32 = u_16[i32(3)];
    var _S231 : MaterialBsdf_0 = bsdf_of_0(material_9, _S229, &(_S230));
    u_16[i32(3)] = _S230;
    var scattered_3 : vec3<f32> = (*path_6).beta_0 * MaterialBsdf_albedo_0(_S231);
    if(((*path_6).bounce_0) >= (params_0.max_bounces_0))
    {
        _S228 = true;
    }
    else
    {
        _S228 = ends_here_0;
    }
    var _S232 : bool = !is_weighed_1;
    if(_S232)
    {
        if(_S228)
        {
            _S228 = true;
        }
        else
        {
            _S228 = (max_element_0(scattered_3)) <= 0.0f;
        }
    }
    else
    {
        _S228 = false;
    }
    if(_S228)
    {
        return next_1;
    }
    var compensation_3 : f32 = roulette_0(Path_events_0((*path_6)), scattered_3, u_16.z);
    if(_S232)
    {
        _S228 = compensation_3 == 0.0f;
    }
    else
    {
        _S228 = false;
    }
    if(_S228)
    {
        return next_1;
    }
    var at_6 : Hit_0;
    if(is_scattered_3)
    {
        at_6 = Hit_x24init_0(t_5, (*path_6).inside_0.instance_0, hit_6.voxel_1, u32(0));
    }
    else
    {
        at_6 = hit_6;
    }
    var surface_4 : Surface_0 = surface_of_0(ray_9, at_6);
    var _S233 : Receiver_0 = Receiver_x24init_0(surface_4.origin_3, surface_4.normal_2);
    var _S234 : vec3<f32> = (vec3<f32>(0) - ray_9.direction_1);
    var wo_6 : vec3<f32> = Surface_local_direction_0(surface_4, _S234);
    var inside_5 : Inside_0 = in_air_0();
    var wo_7 : vec3<f32>;
    var receiver_20 : Receiver_0;
    if(is_scattered_3)
    {
        var _S235 : Inside_0 = Inside_x24init_0((*path_6).inside_0.instance_0, hit_6.voxel_1, (*path_6).inside_0.material_0);
        inside_5 = _S235;
        var _S236 : vec3<f32> = normalize_vector_0(_S234);
        receiver_20 = Receiver_x24init_0(Inside_point_0(_S235, ray_9, t_5), _S227);
        wo_7 = _S236;
    }
    else
    {
        if(Inside_is_in_0((*path_6).inside_0))
        {
            next_1.relocates_0 = (hit_6.instance_1) != ((*path_6).inside_0.instance_0);
            inside_5 = Inside_x24init_0((*path_6).inside_0.instance_0, hit_6.voxel_1, (*path_6).inside_0.material_0);
            inside_5.voxel_0 = hit_6.voxel_1 + vec3<i32>(face_normal_0(hit_6.face_0));
        }
        receiver_20 = _S233;
        wo_7 = wo_6;
    }
    next_1.origin_0 = receiver_20.point_0;
    next_1.shadow_inside_0 = inside_5;
    if(is_weighed_1)
    {
        receiver_20 = last_4;
    }
    var light_4 : LightSample_0 = no_light_0();
    scatter_of_path_0 = Scatter_x24init_0((*path_6), receiver_20, surface_4, _S231, wo_7, compensation_3, is_scattered_3, false);
    if(is_weighed_1)
    {
        if(next_1.has_shadow_ray_0)
        {
            light_pdf_2 = light_4.pdf_2;
        }
        else
        {
            light_pdf_2 = 0.0f;
        }
        (*radiance_6) = (*radiance_6) + (*path_6).beta_0 * le_3 * vec3<f32>(mis_weight_0((*path_6).pdf_1, light_pdf_2));
        (*path_6).pdf_1 = - (*path_6).pdf_1;
        next_1.is_same_0 = true;
        return next_1;
    }
    var bounce_2 : BsdfSample_0;
    var _S237 : bool = MaterialBsdf_sample_0(_S231, wo_7, vec3<f32>(u_16.xy, u_16.w), &(bounce_2));
    if(!_S237)
    {
        return next_1;
    }
    (*path_6).beta_0 = (*path_6).beta_0 * bounce_2.weight_3 * vec3<f32>(compensation_3);
    if(bounce_2.is_delta_0)
    {
        t_5 = 0.0f;
    }
    else
    {
        t_5 = bounce_2.pdf_8;
    }
    (*path_6).pdf_1 = t_5;
    (*path_6).normal_0 = receiver_20.normal_1;
    next_1.direction_0 = bounce_2.wi_0;
    if(!is_scattered_3)
    {
        next_1.direction_0 = Surface_world_direction_0(surface_4, bounce_2.wi_0);
    }
    next_1.path_relocates_0 = next_1.relocates_0;
    (*path_6).bounce_0 = (*path_6).bounce_0 + u32(1);
    return next_1;
}

struct Walker_0
{
     path_7 : Path_0,
     ray_10 : Ray_0,
     is_shadow_ray_0 : bool,
     light_5 : vec3<f32>,
     direction_25 : vec3<f32>,
     path_origin_2 : vec3<f32>,
     shadow_inside_2 : Inside_0,
     boundaries_0 : u32,
     relocates_2 : bool,
     path_relocates_2 : bool,
     camera_ray_0 : Ray_0,
     way_2 : f32,
     has_shown_0 : bool,
     asks_cache_0 : bool,
     life_0 : u32,
     is_at_cell_0 : bool,
     counts_0 : bool,
     sees_mover_0 : bool,
     by_chance_1 : bool,
};

struct Sample_0
{
     direct_0 : vec3<f32>,
     light_6 : vec3<f32>,
     is_shown_0 : bool,
     albedo_0 : vec3<f32>,
     normal_4 : vec3<f32>,
     place_3 : vec3<f32>,
     instance_8 : u32,
};

fn is_mover_0( instance_9 : u32) -> bool
{
    var _S238 : bool;
    if(instance_9 < (real_time_0.motions_0))
    {
        _S238 = (motions_1[u32(4) * instance_9 + u32(3)].x) != 0.0f;
    }
    else
    {
        _S238 = false;
    }
    return _S238;
}

fn shading_normal_0( ray_11 : Ray_0,  hit_7 : Hit_0,  material_10 : PackedMaterial_0) -> vec3<f32>
{
    return world_normal_0(Instances_operatorx5Bx5D_get_0(hit_7.instance_1), hit_7.face_0);
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

fn show_0( path_8 : Path_0,  ray_12 : Ray_0,  hit_8 : Hit_0,  beyond_4 : u32,  is_lit_2 : bool,  sample_9 : ptr<function, Sample_0>)
{
    var _S239 : Path_0 = path_8;
    (*sample_9).is_shown_0 = true;
    if(Inside_is_in_0(_S239.inside_0))
    {
        absorb_0(&(_S239), _S239.inside_0, ray_12, hit_8.t_0);
    }
    var material_12 : PackedMaterial_0 = material_met_0(_S239, hit_8, beyond_4);
    (*sample_9).normal_4 = in_ten_bits_0(shading_normal_0(ray_12, hit_8, material_12));
    var _S240 : vec3<f32> = _S239.beta_0;
    var _S241 : vec3<f32>;
    if(!is_lit_2)
    {
        _S241 = albedo_of_0(material_12);
    }
    else
    {
        _S241 = vec3<f32>(1.0f);
    }
    (*sample_9).albedo_0 = _S240 * _S241;
    return;
}

fn Walker_see_0( this_26 : ptr<function, Walker_0>,  arrived_0 : Path_0,  hit_9 : Hit_0,  beyond_5 : u32,  emitted_1 : vec3<f32>,  goes_on_0 : bool,  sample_10 : ptr<function, Sample_0>)
{
    var is_lit_3 : bool;
    if((*this_26).by_chance_1)
    {
        is_lit_3 = (max_element_0(emitted_1)) > 0.0f;
    }
    else
    {
        is_lit_3 = false;
    }
    if(is_lit_3)
    {
        (*sample_10).light_6 = (*sample_10).light_6 + emitted_1;
    }
    else
    {
        (*sample_10).direct_0 = (*sample_10).direct_0 + emitted_1;
    }
    var _S242 : bool;
    if((*this_26).sees_mover_0)
    {
        _S242 = true;
    }
    else
    {
        if(!Hit_is_miss_0(hit_9))
        {
            _S242 = is_mover_0(hit_9.instance_1);
        }
        else
        {
            _S242 = false;
        }
    }
    (*this_26).sees_mover_0 = _S242;
    var _S243 : bool = ((*this_26).path_7.bounce_0) == u32(0);
    if(goes_on_0)
    {
        _S242 = _S243;
    }
    else
    {
        _S242 = false;
    }
    var _S244 : bool = !_S242;
    (*this_26).has_shown_0 = _S244;
    if(!_S244)
    {
        if((*this_26).by_chance_1)
        {
            is_lit_3 = true;
        }
        else
        {
            if((any((((*this_26).path_7.normal_0) != vec3<f32>(0.0f)))))
            {
                if(Inside_is_in_0(arrived_0.inside_0))
                {
                    is_lit_3 = true;
                }
                else
                {
                    is_lit_3 = (material_met_0(arrived_0, hit_9, beyond_5).metallic_0) < 1.0f;
                }
            }
            else
            {
                is_lit_3 = false;
            }
        }
        (*this_26).by_chance_1 = is_lit_3;
        (*this_26).way_2 = (*this_26).way_2 + hit_9.t_0;
    }
    else
    {
        var _S245 : u32;
        if(!Hit_is_miss_0(hit_9))
        {
            show_0(arrived_0, (*this_26).ray_10, hit_9, beyond_5, is_lit_3, &((*sample_10)));
            (*sample_10).place_3 = (*this_26).camera_ray_0.origin_1 + (*this_26).camera_ray_0.direction_1 * vec3<f32>(((*this_26).way_2 + hit_9.t_0));
            if(((*this_26).way_2) > 0.0f)
            {
                if((*this_26).sees_mover_0)
                {
                    _S245 = u32(4294967295);
                }
                else
                {
                    _S245 = u32(4294967294);
                }
            }
            else
            {
                _S245 = hit_9.instance_1;
            }
            (*sample_10).instance_8 = _S245;
        }
        else
        {
            (*sample_10).albedo_0 = vec3<f32>(0.0f);
            if((*this_26).sees_mover_0)
            {
                _S245 = u32(4294967295);
            }
            else
            {
                _S245 = u32(4294967294);
            }
            (*sample_10).instance_8 = _S245;
            if(is_lit_3)
            {
                (*sample_10).is_shown_0 = true;
                (*sample_10).albedo_0 = arrived_0.beta_0;
                (*sample_10).normal_4 = in_ten_bits_0(normalize_vector_0((vec3<f32>(0) - (*this_26).camera_ray_0.direction_1)));
                (*sample_10).place_3 = (*this_26).camera_ray_0.origin_1 + (*this_26).camera_ray_0.direction_1 * vec3<f32>((*this_26).way_2);
            }
        }
    }
    return;
}

fn goes_on_from_0( at_7 : ptr<function, Walker_0>,  hit_10 : Hit_0,  beyond_6 : u32,  sample_11 : ptr<function, Sample_0>) -> bool
{
    var cached_0 : vec3<f32> = vec3<f32>(0.0f);
    ends_here_0 = false;
    var arrived_1 : Path_0 = (*at_7).path_7;
    var emitted_2 : vec3<f32> = cached_0;
    var _S246 : Path_0 = (*at_7).path_7;
    var next_2 : NextRays_0 = PathTracingOf_advance_1(&(_S246), (*at_7).ray_10, hit_10, beyond_6, &(emitted_2));
    (*at_7).path_7 = _S246;
    var goes_on_1 : bool = (any(((next_2.direction_0) != cached_0)));
    if((*at_7).has_shown_0)
    {
        (*sample_11).light_6 = (*sample_11).light_6 + emitted_2;
    }
    else
    {
        Walker_see_0(&((*at_7)), arrived_1, hit_10, beyond_6, emitted_2, goes_on_1, &((*sample_11)));
    }
    if((*at_7).has_shown_0)
    {
        return false;
    }
    (*at_7).direction_25 = next_2.direction_0;
    (*at_7).light_5 = next_2.light_0;
    (*at_7).is_shadow_ray_0 = next_2.has_shadow_ray_0;
    (*at_7).path_origin_2 = next_2.path_origin_0;
    (*at_7).ray_10 = ray_from_0(next_2.origin_0, next_2.direction_0);
    if(next_2.has_shadow_ray_0)
    {
        (*at_7).ray_10 = Ray_x24init_0(next_2.origin_0, 0.0f, next_2.shadow_direction_0, next_2.shadow_t_max_0);
    }
    var _S247 : bool;
    if(goes_on_1)
    {
        _S247 = true;
    }
    else
    {
        _S247 = (*at_7).is_shadow_ray_0;
    }
    return _S247;
}

struct Key_0
{
     instance_10 : u32,
     face_and_level_0 : u32,
     cube_0 : vec3<i32>,
};

fn Key_x24init_0( instance_11 : u32,  face_and_level_1 : u32,  cube_1 : vec3<i32>) -> Key_0
{
    var _S248 : Key_0;
    _S248.instance_10 = instance_11;
    _S248.face_and_level_0 = face_and_level_1;
    _S248.cube_0 = cube_1;
    return _S248;
}

fn scramble_of_0( number_1 : u32) -> u32
{
    return pcg4d_0(vec4<u32>(number_1, u32(0), u32(0), u32(2654435769))).x;
}

fn Key_level_0( this_27 : Key_0) -> u32
{
    return ((this_27.face_and_level_0) >> (u32(3)));
}

fn Key_mask_0( this_28 : Key_0) -> u32
{
    return ((u32(1) << ((u32(3) * Key_level_0(this_28))))) - u32(1);
}

fn key_of_0( hit_11 : Hit_0,  size_1 : f32,  u_17 : f32,  code_0 : ptr<function, u32>) -> Key_0
{
    var clamped_0 : f32 = clamp(size_1, 1.0f, 128.0f);
    var power_5 : f32 = f32(((bitcast<u32>((clamped_0))) >> (u32(23)))) - 127.0f;
    var _S249 : f32;
    if(u_17 < (clamped_0 * inverse_power_of_two_0(clamped_0) - 1.0f))
    {
        _S249 = 1.0f;
    }
    else
    {
        _S249 = 0.0f;
    }
    var level_0 : u32 = u32(min(power_5 + _S249, 6.0f));
    var _S250 : vec3<u32> = vec3<u32>(u32(i32(level_0)));
    var key_0 : Key_0 = Key_x24init_0(hit_11.instance_1, ((hit_11.face_0) | (((level_0 << (u32(3)))))), ((hit_11.voxel_1) >> (_S250)));
    var _S251 : vec3<u32> = vec3<u32>(hit_11.voxel_1 - (((key_0.cube_0) << (_S250))));
    (*code_0) = u32(1) + (((((((_S251.x) | ((((_S251.y) << (level_0)))))) | ((((_S251.z) << ((u32(2) * level_0))))))) ^ ((((scramble_of_0(real_time_0.number_0)) & ((Key_mask_0(key_0))))))));
    return key_0;
}

fn Key_hash_0( this_29 : Key_0) -> vec2<u32>
{
    return pcg4d_0(vec4<u32>(vec3<u32>(this_29.cube_0), this_29.instance_10 * u32(61) + this_29.face_and_level_0)).xy;
}

fn place_of_check_0( cell_3 : u32) -> u32
{
    return u32(16) + cell_3;
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
        var cell_4 : u32 = ((hash_0.x + probe_0) & (u32(262143)));
        var _S252 : u32 = atomicLoad(&(cell_keys_0[place_of_check_0(cell_4)]));
        if(_S252 == (max(hash_0.y, u32(1))))
        {
            return cell_4;
        }
        probe_0 = probe_0 + u32(1);
    }
    return u32(262144);
}

fn cell_row_0( row_8 : u32,  cell_5 : u32) -> vec4<u32>
{
    return cell_rows_0[row_8 * u32(262144) + cell_5];
}

fn set_cell_row_0( row_9 : u32,  cell_6 : u32,  value_1 : vec4<u32>)
{
    cell_rows_0[row_9 * u32(262144) + cell_6] = value_1;
    return;
}

fn place_of_asked_0( cell_7 : u32) -> u32
{
    return u32(262160) + cell_7;
}

fn ask_cell_0( key_1 : Key_0,  asked_0 : u32) -> vec4<f32>
{
    var _S253 : bool;
    var hash_1 : vec2<u32> = Key_hash_0(key_1);
    var _S254 : u32 = max(hash_1.y, u32(1));
    var cell_8 : u32 = find_cell_0(hash_1);
    var _S255 : vec4<f32> = vec4<f32>(0.0f);
    var known_0 : vec4<f32>;
    if(cell_8 != u32(262144))
    {
        known_0 = (bitcast<vec4<f32>>((cell_row_0(u32(0), cell_8))));
    }
    else
    {
        known_0 = _S255;
    }
    var cell_9 : u32 = cell_8;
    var probe_1 : u32 = u32(0);
    for(;;)
    {
        if(probe_1 < u32(8))
        {
            _S253 = cell_9 == u32(262144);
        }
        else
        {
            _S253 = false;
        }
        if(_S253)
        {
        }
        else
        {
            break;
        }
        var place_4 : u32 = ((hash_1.x + probe_1) & (u32(262143)));
        var found_0 : u32 = atomicCompareExchangeWeak(&(cell_keys_0[place_of_check_0(place_4)]), u32(0), _S254).old_value;
        var _S256 : bool = found_0 == u32(0);
        if(_S256)
        {
            set_cell_row_0(u32(1), place_4, vec4<u32>(key_1.instance_10, key_1.face_and_level_0, u32(0), u32(0)));
            set_cell_row_0(u32(2), place_4, vec4<u32>(vec3<u32>(key_1.cube_0), u32(0)));
        }
        var _S257 : bool;
        if(_S256)
        {
            _S257 = true;
        }
        else
        {
            _S257 = found_0 == _S254;
        }
        if(_S257)
        {
            cell_9 = place_4;
        }
        probe_1 = probe_1 + u32(1);
    }
    if(cell_9 != u32(262144))
    {
        var _S258 : u32 = atomicLoad(&(cell_keys_0[place_of_asked_0(cell_9)]));
        _S253 = _S258 < asked_0;
    }
    else
    {
        _S253 = false;
    }
    if(_S253)
    {
        var _S259 : u32 = atomicMax(&(cell_keys_0[place_of_asked_0(cell_9)]), asked_0);
    }
    return known_0;
}

fn asks_0( path_9 : Path_0,  ray_13 : Ray_0,  hit_12 : Hit_0,  beyond_7 : u32,  life_1 : u32,  light_7 : ptr<function, vec3<f32>>) -> bool
{
    (*light_7) = vec3<f32>(0.0f);
    var _S260 : bool;
    if(Hit_is_miss_0(hit_12))
    {
        _S260 = true;
    }
    else
    {
        _S260 = Inside_is_in_0(path_9.inside_0);
    }
    if(_S260)
    {
        return false;
    }
    var material_13 : PackedMaterial_0 = material_met_0(path_9, hit_12, beyond_7);
    if((material_13.metallic_0) > 0.0f)
    {
        _S260 = true;
    }
    else
    {
        _S260 = (material_13.transmission_0) > 0.0f;
    }
    if(_S260)
    {
        return false;
    }
    var code_1 : u32;
    var key_2 : Key_0 = key_of_0(hit_12, square_root_0(length_squared_0(ray_13.origin_1 + ray_13.direction_1 * vec3<f32>(hit_12.t_0) - real_time_0.eye_0)) * real_time_0.view_angle_0 * 0.05882352963089943f, Sampler_independent_0(path_9.sampler_0, u32(3221225472) + Path_events_0(path_9)).x, &(code_1));
    var _S261 : f32 = f32((u32(1) << ((Key_level_0(key_2)))));
    var is_from_first_0 : bool = (path_9.bounce_0) < u32(2);
    if(life_1 == u32(0))
    {
        _S260 = true;
    }
    else
    {
        if(is_from_first_0)
        {
            _S260 = (hit_12.t_0 * square_root_0(length_squared_0(ray_13.direction_1))) < _S261;
        }
        else
        {
            _S260 = false;
        }
    }
    if(_S260)
    {
        return false;
    }
    var known_1 : vec4<f32> = ask_cell_0(key_2, ((((min(life_1, u32(10))) << (u32(20)))) | (code_1)));
    if((known_1.w) <= 0.0f)
    {
        return false;
    }
    (*light_7) = path_9.beta_0 * vector_of_0(material_13.base_color_0) * known_1.xyz;
    return true;
}

var<private> first_candidates_0 : u32;

fn Path_dimension_light_0( this_30 : Path_0) -> u32
{
    return u32(2) + u32(2) * Path_events_0(this_30);
}

struct BsdfEval_0
{
     weight_5 : vec3<f32>,
     pdf_10 : f32,
};

fn BsdfEval_x24init_0( weight_6 : vec3<f32>,  pdf_11 : f32) -> BsdfEval_0
{
    var _S262 : BsdfEval_0;
    _S262.weight_5 = weight_6;
    _S262.pdf_10 = pdf_11;
    return _S262;
}

fn Diffuse_eval_0( this_31 : Diffuse_0,  wo_8 : vec3<f32>,  wi_3 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_31.reflectance_0, cosine_hemisphere_pdf_0(wi_3.z));
}

fn MaterialBsdf_eval_0( this_32 : MaterialBsdf_0,  wo_9 : vec3<f32>,  wi_4 : vec3<f32>) -> BsdfEval_0
{
    return Diffuse_eval_0(Diffuse_x24init_0(this_32.color_0), wo_9, wi_4);
}

var<private> weighs_candidates_0 : bool;

fn cube_of_0( point_6 : vec3<f32>,  size_squared_0 : f32,  smaller_0 : i32,  power_6 : ptr<function, i32>) -> vec3<i32>
{
    var _S263 : i32 = clamp((((i32(((bitcast<u32>((size_squared_0))) >> (u32(23)))) - i32(127)) >> (u32(1)))) - smaller_0, i32(-64), i32(64));
    (*power_6) = _S263;
    return vec3<i32>(clamp(floor(point_6 * vec3<f32>((bitcast<f32>(((u32(i32(127) - _S263) << (u32(23)))))))), vec3<f32>(-1.0e+09f), vec3<f32>(1.0e+09f)));
}

fn place_of_ray_0( ray_14 : Ray_0) -> u32
{
    var size_2 : f32 = real_time_0.view_angle_0 * 0.30000001192092896f;
    var power_7 : i32;
    var begin_0 : vec3<i32> = cube_of_0(ray_14.origin_1, length_squared_0(ray_14.origin_1 - real_time_0.eye_0) * (size_2 * size_2), i32(0), &(power_7));
    var hash_2 : vec4<u32> = pcg4d_0(vec4<u32>(vec3<u32>(begin_0), u32(power_7)));
    var _S264 : vec3<i32> = vec3<i32>(floor(ray_14.direction_1 * vec3<f32>(4.0f)));
    power_7 = i32(128);
    var end_0 : vec3<i32>;
    if((ray_14.t_max_0) <= 1.0f)
    {
        var _S265 : vec3<i32> = cube_of_0(ray_14.origin_1 + ray_14.direction_1, length_squared_0(ray_14.direction_1), i32(1), &(power_7));
        end_0 = _S265;
    }
    else
    {
        end_0 = _S264;
    }
    return ((pcg4d_0((vec4<u32>(vec3<u32>(end_0), u32(power_7)) ^ (hash_2))).x) & (u32(131071)));
}

fn place_of_known_0( place_5 : u32) -> u32
{
    return u32(786448) + place_5;
}

fn visibility_0( ray_15 : Ray_0) -> f32
{
    var known_2 : u32 = atomicLoad(&(cell_keys_0[place_of_known_0(place_of_ray_0(ray_15))]));
    return square_root_0(divide_0(f32((known_2 >> (u32(16)))) + 0.5f, f32((known_2 & (u32(65535)))) + 1.0f));
}

fn choose_light_0( scatter_0 : Scatter_0,  next_3 : ptr<function, NextRays_0>)
{
    var count_5 : u32;
    if((scatter_0.path_0.bounce_0) == u32(0))
    {
        count_5 = first_candidates_0;
    }
    else
    {
        count_5 = u32(1);
    }
    var chosen_4 : f32 = 0.0f;
    var candidate_0 : u32 = u32(0);
    var sum_1 : f32 = 0.0f;
    for(;;)
    {
        if(candidate_0 < count_5)
        {
        }
        else
        {
            break;
        }
        var dimension_3 : u32 = u32(1073741824) + u32(64) * Path_events_0(scatter_0.path_0) + u32(2) * candidate_0;
        var u_18 : vec4<f32>;
        var _S266 : vec4<f32>;
        if(candidate_0 == u32(0))
        {
            _S266 = Sampler_stratified_0(scatter_0.path_0.sampler_0, Path_dimension_light_0(scatter_0.path_0));
        }
        else
        {
            _S266 = Sampler_independent_0(scatter_0.path_0.sampler_0, dimension_3);
        }
        u_18 = _S266;
        var _S267 : bool = count_5 > u32(1);
        if(_S267)
        {
            u_18[i32(0)] = min((f32(candidate_0) + u_18.x) * divide_0(1.0f, f32(count_5)), 0.99999994039535522f);
        }
        var light_8 : LightSample_0 = no_light_0();
        var is_found_2 : bool = Lights_sample_0(scatter_0.receiver_0, scatter_0.path_0.selection_0, u_18, by_chance_0(), &(light_8));
        if(!is_found_2)
        {
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var _S268 : vec3<f32> = vec3<f32>(Surface_local_direction_0(scatter_0.surface_0, light_8.ray_4.direction_1).xy, light_8.cos_theta_1);
        var wi_5 : vec3<f32>;
        if(scatter_0.is_scattered_0)
        {
            wi_5 = normalize_vector_0(light_8.ray_4.direction_1);
        }
        else
        {
            wi_5 = _S268;
        }
        var eval_0 : BsdfEval_0 = MaterialBsdf_eval_0(scatter_0.bsdf_0, scatter_0.wo_0, wi_5);
        var _S269 : vec3<f32> = scatter_0.path_0.beta_0 * eval_0.weight_5 * vec3<f32>(scatter_0.compensation_0) * light_8.radiance_1 * vec3<f32>((divide_0(eval_0.pdf_10, light_8.pdf_2) * power_heuristic_0(light_8.pdf_2, eval_0.pdf_10)));
        var weight_7 : f32 = luminance_0(_S269);
        var _S270 : bool;
        if(weighs_candidates_0)
        {
            _S270 = _S267;
        }
        else
        {
            _S270 = false;
        }
        var weight_8 : f32;
        if(_S270)
        {
            var _S271 : f32 = visibility_0(light_8.ray_4);
            weight_8 = weight_7 * _S271;
        }
        else
        {
            weight_8 = weight_7;
        }
        var sum_2 : f32 = sum_1 + weight_8;
        var _S272 : bool;
        if(_S267)
        {
            _S272 = (Sampler_independent_0(scatter_0.path_0.sampler_0, dimension_3 + u32(1)).x * sum_2) >= weight_8;
        }
        else
        {
            _S272 = false;
        }
        if(_S272)
        {
            sum_1 = sum_2;
            candidate_0 = candidate_0 + u32(1);
            continue;
        }
        var chosen_5 : f32;
        if(weight_8 > 0.0f)
        {
            (*next_3).shadow_direction_0 = light_8.ray_4.direction_1;
            (*next_3).shadow_t_max_0 = light_8.ray_4.t_max_0;
            (*next_3).light_0 = _S269;
            chosen_5 = weight_8;
        }
        else
        {
            chosen_5 = chosen_4;
        }
        chosen_4 = chosen_5;
        sum_1 = sum_2;
        candidate_0 = candidate_0 + u32(1);
    }
    var _S273 : bool = chosen_4 > 0.0f;
    (*next_3).has_shadow_ray_0 = _S273;
    if(_S273)
    {
        (*next_3).light_0 = (*next_3).light_0 * vec3<f32>(divide_0(sum_1, chosen_4 * f32(count_5)));
    }
    return;
}

var<private> counts_arrivals_0 : bool;

fn goes_on_from_1( at_8 : ptr<function, Walker_0>,  hit_13 : Hit_0,  beyond_8 : u32,  sample_12 : ptr<function, Sample_0>) -> bool
{
    var next_4 : NextRays_0 = no_rays_0();
    var _S274 : bool = (*at_8).is_at_cell_0;
    var goes_on_2 : bool;
    if((*at_8).is_at_cell_0)
    {
        next_4.origin_0 = (*at_8).ray_10.origin_1;
        next_4.path_origin_0 = (*at_8).ray_10.origin_1;
        next_4.direction_0 = (*at_8).ray_10.direction_1;
        goes_on_2 = true;
    }
    else
    {
        var _S275 : vec3<f32> = vec3<f32>(0.0f);
        var cached_1 : vec3<f32> = _S275;
        if((*at_8).has_shown_0)
        {
            goes_on_2 = (*at_8).asks_cache_0;
        }
        else
        {
            goes_on_2 = false;
        }
        if(goes_on_2)
        {
            var _S276 : bool = asks_0((*at_8).path_7, (*at_8).ray_10, hit_13, beyond_8, (*at_8).life_0, &(cached_1));
            goes_on_2 = _S276;
        }
        else
        {
            goes_on_2 = false;
        }
        ends_here_0 = goes_on_2;
        var arrived_2 : Path_0 = (*at_8).path_7;
        var emitted_3 : vec3<f32> = _S275;
        var _S277 : Path_0 = (*at_8).path_7;
        var _S278 : NextRays_0 = PathTracingOf_advance_0(&(_S277), (*at_8).ray_10, hit_13, beyond_8, &(emitted_3));
        (*at_8).path_7 = _S277;
        next_4 = _S278;
        var goes_on_3 : bool = (any(((next_4.direction_0) != _S275)));
        if((*at_8).has_shown_0)
        {
            (*sample_12).light_6 = (*sample_12).light_6 + (cached_1 + emitted_3);
        }
        else
        {
            Walker_see_0(&((*at_8)), arrived_2, hit_13, beyond_8, emitted_3, goes_on_3, &((*sample_12)));
        }
        goes_on_2 = goes_on_3;
    }
    if(scatter_of_path_0.wants_light_0)
    {
        choose_light_0(scatter_of_path_0, &(next_4));
    }
    if(!_S274)
    {
        var _S279 : bool;
        if(counts_arrivals_0)
        {
            _S279 = next_4.has_shadow_ray_0;
        }
        else
        {
            _S279 = false;
        }
        if(_S279)
        {
            _S279 = (Path_events_0(scatter_of_path_0.path_0)) == u32(0);
        }
        else
        {
            _S279 = false;
        }
        if(_S279)
        {
            _S279 = !scatter_of_path_0.is_scattered_0;
        }
        else
        {
            _S279 = false;
        }
        if(_S279)
        {
            _S279 = !Inside_is_in_0(scatter_of_path_0.path_0.inside_0);
        }
        else
        {
            _S279 = false;
        }
        (*at_8).counts_0 = _S279;
    }
    if(_S274)
    {
        (*at_8).path_7.bounce_0 = u32(1);
        (*at_8).path_7.event_0 = u32(1);
        (*at_8).path_7.scattered_0 = u32(1);
        (*at_8).is_at_cell_0 = false;
    }
    (*at_8).direction_25 = next_4.direction_0;
    (*at_8).light_5 = next_4.light_0;
    (*at_8).is_shadow_ray_0 = next_4.has_shadow_ray_0;
    (*at_8).path_origin_2 = next_4.path_origin_0;
    (*at_8).ray_10 = ray_from_0(next_4.origin_0, next_4.direction_0);
    if((*at_8).is_shadow_ray_0)
    {
        (*at_8).ray_10 = Ray_x24init_0(next_4.origin_0, 0.0f, next_4.shadow_direction_0, next_4.shadow_t_max_0);
    }
    if(goes_on_2)
    {
        goes_on_2 = true;
    }
    else
    {
        goes_on_2 = (*at_8).is_shadow_ray_0;
    }
    return goes_on_2;
}

struct LocalRay_0
{
     origin_7 : vec3<f32>,
     direction_26 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_2 : f32,
     t_max_2 : f32,
     is_valid_0 : bool,
};

fn reciprocal_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_4.x), divide_0(1.0f, vector_4.y), divide_0(1.0f, vector_4.z));
}

fn local_ray_0( ray_16 : Ray_0,  grid_from_world_2 : Transform_0) -> LocalRay_0
{
    var local_3 : LocalRay_0;
    var direction_27 : vec3<f32>;
    var origin_8 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S280 : vec3<f32> = Transform_point_0(grid_from_world_2, ray_16.origin_1);
        direction_27 = Transform_direction_0(grid_from_world_2, ray_16.direction_1);
        origin_8 = _S280;
    }
    else
    {
        direction_27 = ray_16.direction_1;
        origin_8 = ray_16.origin_1;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_27)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S281 : vec3<f32> = select(direction_27, vec3<f32>(0.0f), is_zero_0);
    local_3.direction_26 = _S281;
    local_3.inverse_0 = select(reciprocal_0(select(direction_27, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_3.origin_7 = select(origin_8, floor(origin_8) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S281));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_3.origin_7)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((ray_16.t_min_0) >= 0.0f)
    {
        is_segment_0 = (ray_16.t_min_0) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (ray_16.t_min_0) <= (ray_16.t_max_0);
    }
    else
    {
        is_segment_0 = false;
    }
    local_3.t_min_2 = ray_16.t_min_0;
    local_3.t_max_2 = ray_16.t_max_0;
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
    local_3.is_valid_0 = moves_0;
    return local_3;
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

struct Walk_0
{
     ray_17 : LocalRay_0,
     origin_9 : vec3<f32>,
     offset_0 : vec3<i32>,
     speed_1 : vec3<f32>,
     inverse_1 : vec3<f32>,
     base_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     octant_0 : u32,
     t_end_0 : f32,
};

fn LocalRay_octant_0( this_33 : LocalRay_0) -> u32
{
    return (((u32((this_33.direction_26.x) < 0.0f) | (((u32((this_33.direction_26.y) < 0.0f) << (u32(1))))))) | (((u32((this_33.direction_26.z) < 0.0f) << (u32(2))))));
}

fn Walk_mirror_0( this_34 : Walk_0) -> vec3<i32>
{
    return (vec3<i32>(0) - vec3<i32>(i32(((this_34.octant_0) & (u32(1)))), i32(((((this_34.octant_0) >> (u32(1)))) & (u32(1)))), i32(((this_34.octant_0) >> (u32(2))))));
}

fn Walk_mirrored_plane_0( this_35 : Walk_0,  plane_0 : vec3<i32>) -> vec3<i32>
{
    var _S282 : vec3<i32> = Walk_mirror_0(this_35);
    return ((plane_0 ^ (_S282))) - _S282;
}

fn LocalRay_mirrored_origin_0( this_36 : LocalRay_0) -> vec3<f32>
{
    return select(this_36.origin_7, (vec3<f32>(0) - this_36.origin_7), (this_36.direction_26) < vec3<f32>(0.0f));
}

fn min_element_0( vector_5 : vec3<f32>) -> f32
{
    return min(min(vector_5.x, vector_5.y), vector_5.z);
}

fn top_shift_of_0( grid_8 : PackedGrid_0) -> u32
{
    var _S283 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        _S283 = TOP_SHIFT_0;
    }
    else
    {
        _S283 = grid_8.top_shift_0;
    }
    return _S283;
}

fn LocalRay_tolerance_0( this_37 : LocalRay_0,  low_7 : vec3<i32>,  high_2 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_37.origin_7) + (vec3<f32>(max(abs(low_7), abs(high_2))) + vec3<f32>(1.0f))) * vec3<f32>(5.36441802978515625e-07f), vec3<f32>(-1.0f), (this_37.direction_26) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_38 : LocalRay_0) -> f32
{
    return min(this_38.t_max_2 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_from_0( base_1 : vec3<i32>,  ray_18 : LocalRay_0,  grid_9 : PackedGrid_0) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_17 = ray_18;
    walk_0.base_0 = base_1;
    walk_0.octant_0 = LocalRay_octant_0(ray_18);
    var _S284 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S284 = Walk_mirrored_plane_0(walk_0, base_1);
    }
    else
    {
        _S284 = vec3<i32>(i32(0));
    }
    walk_0.offset_0 = _S284;
    walk_0.origin_9 = LocalRay_mirrored_origin_0(ray_18);
    var _S285 : vec3<f32> = abs(ray_18.direction_26);
    var _S286 : vec3<f32> = abs(ray_18.inverse_0);
    var is_still_0 : vec3<bool> = (ray_18.direction_26) == vec3<f32>(0.0f);
    walk_0.speed_1 = select(_S285, vec3<f32>((max_element_0(_S285) * 9.99999993922529029e-09f)), is_still_0);
    walk_0.inverse_1 = select(_S286, vec3<f32>((min_element_0(_S286) * 9.99999986991104e+14f)), is_still_0);
    if(!IS_EXACT_0)
    {
        var _S287 : vec3<f32> = vec3<f32>(base_1);
        walk_0.origin_9 = select(ray_18.origin_7 - _S287, _S287 - ray_18.origin_7, (ray_18.direction_26) < vec3<f32>(0.0f));
        var _S288 : vec3<f32> = max(_S285, vec3<f32>(1.00000004581370497e-18f));
        walk_0.speed_1 = _S288;
        walk_0.inverse_1 = vec3<f32>(1.0f) / _S288;
    }
    var low_8 : vec3<i32> = cell_of_0(grid_9.origin_4);
    walk_0.tolerance_0 = LocalRay_tolerance_0(ray_18, low_8, low_8 + (((cell_of_0(grid_9.top_size_0)) << (vec3<u32>(top_shift_of_0(grid_9))))));
    walk_0.t_end_0 = LocalRay_t_end_0(ray_18);
    return walk_0;
}

fn Walk_mirrored_0( this_39 : Walk_0,  voxel_6 : vec3<i32>) -> vec3<i32>
{
    return (voxel_6 ^ ((Walk_mirror_0(this_39))));
}

fn halves_0( value_2 : f32) -> vec2<f32>
{
    var high_3 : f32 = (bitcast<f32>((((bitcast<u32>((value_2))) & (u32(4294963200))))));
    return vec2<f32>(high_3, value_2 - high_3);
}

fn exact_product_0( a_4 : f32,  b_4 : f32) -> vec2<f32>
{
    var product_0 : f32 = a_4 * b_4;
    if(!IS_EXACT_0)
    {
        return vec2<f32>(product_0, 0.0f);
    }
    var a_parts_0 : vec2<f32> = halves_0(a_4);
    var b_parts_0 : vec2<f32> = halves_0(b_4);
    var _S289 : f32 = a_parts_0.x;
    var _S290 : f32 = b_parts_0.x;
    var _S291 : f32 = b_parts_0.y;
    var _S292 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S289 * _S290 - product_0 + _S289 * _S291 + _S292 * _S290 + _S292 * _S291);
}

fn exact_start_voxel_0( ray_19 : LocalRay_0) -> vec3<i32>
{
    var way_3 : vec2<f32> = exact_product_0(ray_19.t_min_2, ray_19.direction_26[u32(0)]);
    var _S293 : f32 = way_3.x;
    var sum_3 : f32 = ray_19.origin_7[u32(0)] + _S293;
    var part_0 : f32 = sum_3 - ray_19.origin_7[u32(0)];
    var low_9 : f32 = ray_19.origin_7[u32(0)] - (sum_3 - part_0) + (_S293 - part_0) + way_3.y;
    var whole_0 : f32 = floor(sum_3);
    var voxel_7 : vec3<i32>;
    var _S294 : i32 = i32(whole_0);
    var _S295 : bool;
    if(sum_3 == whole_0)
    {
        _S295 = low_9 < 0.0f;
    }
    else
    {
        _S295 = false;
    }
    voxel_7[u32(0)] = _S294 - i32(_S295);
    var way_4 : vec2<f32> = exact_product_0(ray_19.t_min_2, ray_19.direction_26[u32(1)]);
    var _S296 : f32 = way_4.x;
    var sum_4 : f32 = ray_19.origin_7[u32(1)] + _S296;
    var part_1 : f32 = sum_4 - ray_19.origin_7[u32(1)];
    var low_10 : f32 = ray_19.origin_7[u32(1)] - (sum_4 - part_1) + (_S296 - part_1) + way_4.y;
    var whole_1 : f32 = floor(sum_4);
    var _S297 : i32 = i32(whole_1);
    if(sum_4 == whole_1)
    {
        _S295 = low_10 < 0.0f;
    }
    else
    {
        _S295 = false;
    }
    voxel_7[u32(1)] = _S297 - i32(_S295);
    var way_5 : vec2<f32> = exact_product_0(ray_19.t_min_2, ray_19.direction_26[u32(2)]);
    var _S298 : f32 = way_5.x;
    var sum_5 : f32 = ray_19.origin_7[u32(2)] + _S298;
    var part_2 : f32 = sum_5 - ray_19.origin_7[u32(2)];
    var low_11 : f32 = ray_19.origin_7[u32(2)] - (sum_5 - part_2) + (_S298 - part_2) + way_5.y;
    var whole_2 : f32 = floor(sum_5);
    var _S299 : i32 = i32(whole_2);
    if(sum_5 == whole_2)
    {
        _S295 = low_11 < 0.0f;
    }
    else
    {
        _S295 = false;
    }
    voxel_7[u32(2)] = _S299 - i32(_S295);
    return voxel_7;
}

fn Walk_start_voxel_0( this_40 : Walk_0) -> vec3<i32>
{
    var start_3 : vec3<f32> = clamp(this_40.ray_17.origin_7 + this_40.ray_17.direction_26 * vec3<f32>(this_40.ray_17.t_min_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_40, vec3<i32>(floor(start_3)) - this_40.base_0);
    }
    var nearest_0 : vec3<f32> = round(start_3);
    var from_nearest_0 : vec3<f32> = start_3 - nearest_0;
    var _S300 : bool;
    if((this_40.ray_17.t_min_2) > 0.0f)
    {
        _S300 = (any(((abs(from_nearest_0)) <= (this_40.tolerance_0))));
    }
    else
    {
        _S300 = false;
    }
    if(_S300)
    {
        return Walk_mirrored_0(this_40, exact_start_voxel_0(this_40.ray_17) - this_40.base_0);
    }
    return Walk_mirrored_0(this_40, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_40.base_0);
}

@id(11) override CELLS_SKIP_0 : bool = false;

fn Walk_crossings_0( this_41 : Walk_0,  planes_1 : vec3<i32>) -> vec3<f32>
{
    var _S301 : bool;
    if(IS_EXACT_0)
    {
        _S301 = !CELLS_SKIP_0;
    }
    else
    {
        _S301 = false;
    }
    if(_S301)
    {
        return ((bitcast<vec3<f32>>((planes_1 + this_41.offset_0 + vec3<i32>(i32(1262485504))))) - vec3<f32>(1.2582912e+07f) - this_41.origin_9) * this_41.inverse_1;
    }
    return (vec3<f32>(planes_1 + this_41.offset_0) - this_41.origin_9) * this_41.inverse_1;
}

struct Crossing_0
{
     distance_0 : f32,
     distance_low_0 : f32,
     speed_2 : f32,
     axis_1 : u32,
};

fn Crossing_x24init_0( distance_1 : f32,  distance_low_1 : f32,  speed_3 : f32,  axis_2 : u32) -> Crossing_0
{
    var _S302 : Crossing_0;
    _S302.distance_0 = distance_1;
    _S302.distance_low_0 = distance_low_1;
    _S302.speed_2 = speed_3;
    _S302.axis_1 = axis_2;
    return _S302;
}

fn crossing_ahead_0( origin_10 : f32,  speed_4 : f32,  axis_3 : u32,  plane_1 : i32) -> Crossing_0
{
    var at_9 : f32 = f32(plane_1);
    var difference_0 : f32 = at_9 - origin_10;
    var part_3 : f32 = difference_0 - at_9;
    return Crossing_x24init_0(difference_0, at_9 - (difference_0 - part_3) - (origin_10 + part_3), speed_4, axis_3);
}

fn Crossing_is_before_0( this_42 : Crossing_0,  other_2 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_42.distance_0, other_2.speed_2);
    var theirs_0 : vec2<f32> = exact_product_0(other_2.distance_0, this_42.speed_2);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_42.distance_low_0 * other_2.speed_2;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_2.distance_low_0 * this_42.speed_2;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S303 : bool;
    if(difference_1 < 0.0f)
    {
        _S303 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S303 = (this_42.axis_1) < (other_2.axis_1);
        }
        else
        {
            _S303 = false;
        }
    }
    return _S303;
}

fn crossing_among_0( origin_11 : vec3<f32>,  speed_5 : vec3<f32>,  planes_2 : vec3<i32>,  is_first_0 : bool) -> Crossing_0
{
    var _S304 : bool;
    var found_1 : Crossing_0;
    var _S305 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if((speed_5[u32(0)]) == 0.0f)
                {
                    found_1 = _S305;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_ahead_0(origin_11[u32(0)], speed_5[u32(0)], u32(0), planes_2[u32(0)]);
                if((_S305.axis_1) == u32(3))
                {
                    _S304 = true;
                }
                else
                {
                    _S304 = (Crossing_is_before_0(crossing_0, _S305)) == is_first_0;
                }
                if(_S304)
                {
                    found_1 = crossing_0;
                }
                else
                {
                    found_1 = _S305;
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
                var crossing_1 : Crossing_0 = crossing_ahead_0(origin_11[u32(1)], speed_5[u32(1)], u32(1), planes_2[u32(1)]);
                if((found_1.axis_1) == u32(3))
                {
                    _S304 = true;
                }
                else
                {
                    _S304 = (Crossing_is_before_0(crossing_1, found_1)) == is_first_0;
                }
                if(_S304)
                {
                    found_1 = crossing_1;
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
                var crossing_2 : Crossing_0 = crossing_ahead_0(origin_11[u32(2)], speed_5[u32(2)], u32(2), planes_2[u32(2)]);
                if((found_1.axis_1) == u32(3))
                {
                    _S304 = true;
                }
                else
                {
                    _S304 = (Crossing_is_before_0(crossing_2, found_1)) == is_first_0;
                }
                if(_S304)
                {
                    found_1 = crossing_2;
                }
                break;
            }
            break;
        }
        break;
    }
    return found_1;
}

fn leave_box_0( origin_12 : vec3<f32>,  speed_6 : vec3<f32>,  voxel_8 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_1 : vec3<i32>) -> vec3<i32>
{
    var is_crossed_0 : bool;
    var plane_2 : i32;
    var _S306 : Crossing_0 = crossing_among_0(origin_12, speed_6, exit_0, true);
    var arrival_0 : vec3<i32> = voxel_8;
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
                var _S307 : bool = u32(0) == (_S306.axis_1);
                if(_S307)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_12[u32(0)], speed_6[u32(0)], u32(0), nearest_1[u32(0)]), _S306);
                }
                if(_S307)
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
                var _S308 : bool = u32(1) == (_S306.axis_1);
                if(_S308)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_12[u32(1)], speed_6[u32(1)], u32(1), nearest_1[u32(1)]), _S306);
                }
                if(_S308)
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
                var _S309 : bool = u32(2) == (_S306.axis_1);
                if(_S309)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_12[u32(2)], speed_6[u32(2)], u32(2), nearest_1[u32(2)]), _S306);
                }
                if(_S309)
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

fn Walk_arrive_0( this_43 : Walk_0,  voxel_9 : vec3<i32>,  t_6 : f32,  is_axis_1 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_1 : vec3<f32> = this_43.origin_9 + this_43.speed_1 * vec3<f32>(t_6);
    if(IS_EXACT_0)
    {
        var position_2 : vec3<f32> = clamp(position_1, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_2 : vec3<f32> = round(position_2);
        var from_nearest_1 : vec3<f32> = position_2 - nearest_2;
        if((any((select(vec3<bool>(false), (abs(position_2)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_1, (abs(from_nearest_1)) <= (this_43.tolerance_0)))))))
        {
            return max(leave_box_0(this_43.origin_9, this_43.speed_1, voxel_9 + this_43.offset_0, exit_1 + this_43.offset_0, vec3<i32>(nearest_2)) - this_43.offset_0, voxel_9);
        }
        return select(vec3<i32>(nearest_2) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f)) - this_43.offset_0, exit_1, is_axis_1);
    }
    return max(vec3<i32>(floor(position_1)), select(voxel_9, exit_1, is_axis_1));
}

fn Walk_enter_rounded_0( this_44 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  near_2 : vec3<i32>,  far_1 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_before_0 : vec3<bool> = (*voxel_10) < near_2;
        if(!(any((is_before_0))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_44.speed_1) <= vec3<f32>(1.00000004581370497e-18f), is_before_0)))))
        {
            return false;
        }
        var t_7 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_44, near_2), is_before_0);
        var t_last_0 : f32 = max_element_0(t_7);
        if(t_last_0 > (this_44.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_7.x) == t_last_0;
        var _S310 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S310)
        {
            is_y_0 = (t_7.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S311 : bool;
        if(_S310)
        {
            _S311 = !is_y_0;
        }
        else
        {
            _S311 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S311);
        (*voxel_10) = Walk_arrive_0(this_44, (*voxel_10), t_last_0, is_axis_2, select(vec3<i32>(i32(1073741823)), near_2, is_axis_2));
    }
    return (all(((*voxel_10) < far_1)));
}

fn Walk_leave_rounded_0( this_45 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_8 : vec3<f32> = Walk_crossings_0(this_45, exit_2);
    var t_first_0 : f32 = min_element_0(t_8);
    if(t_first_0 >= (this_45.t_end_0))
    {
        return false;
    }
    (*voxel_11) = max(exit_2 - vec3<i32>(ceil((t_8 - vec3<f32>(t_first_0)) * this_45.speed_1)), (*voxel_11));
    return true;
}

fn Walk_leave_0( this_46 : Walk_0,  voxel_12 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S312 : bool = Walk_leave_rounded_0(this_46, &((*voxel_12)), exit_3);
        return _S312;
    }
    var t_9 : vec3<f32> = Walk_crossings_0(this_46, exit_3);
    var t_first_1 : f32 = min_element_0(t_9);
    if(t_first_1 > (this_46.t_end_0))
    {
        return false;
    }
    var back_0 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_9 - vec3<f32>(t_first_1), this_46.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S313 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_0 : vec3<f32> = back_0 + _S313;
    var _S314 : vec3<i32> = exit_3 - ((bitcast<vec3<i32>>((rounded_0))) - vec3<i32>(i32(1262485504)));
    var _S315 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_0 : vec3<bool> = (abs(rounded_0 - _S313 - back_0)) >= (_S315 - this_46.tolerance_0);
    var _S316 : bool = is_unsure_0.x;
    var _S317 : bool;
    if(_S316)
    {
        _S317 = is_unsure_0.y;
    }
    else
    {
        _S317 = false;
    }
    if(_S317)
    {
        _S317 = true;
    }
    else
    {
        if(_S316)
        {
            _S317 = true;
        }
        else
        {
            _S317 = is_unsure_0.y;
        }
        if(_S317)
        {
            _S317 = is_unsure_0.z;
        }
        else
        {
            _S317 = false;
        }
    }
    var arrival_1 : vec3<i32>;
    if(_S317)
    {
        arrival_1 = leave_box_0(this_46.origin_9, this_46.speed_1, (*voxel_12) + this_46.offset_0, exit_3 + this_46.offset_0, exit_3 - vec3<i32>(round(back_0 - _S315)) + this_46.offset_0) - this_46.offset_0;
    }
    else
    {
        arrival_1 = _S314;
    }
    (*voxel_12) = max(arrival_1, (*voxel_12));
    return true;
}

fn Walk_enter_0( this_47 : Walk_0,  voxel_13 : ptr<function, vec3<i32>>,  low_12 : vec3<i32>,  high_4 : vec3<i32>) -> bool
{
    var _S318 : bool;
    var is_mirrored_0 : vec3<bool> = (Walk_mirror_0(this_47)) != vec3<i32>(i32(0));
    var near_3 : vec3<i32> = select(low_12, (vec3<i32>(0) - high_4), is_mirrored_0);
    var far_2 : vec3<i32> = select(high_4, (vec3<i32>(0) - low_12), is_mirrored_0);
    if(!IS_EXACT_0)
    {
        var _S319 : bool = Walk_enter_rounded_0(this_47, &((*voxel_13)), near_3, far_2);
        return _S319;
    }
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
            _S318 = (any(((*voxel_13) < near_3)));
        }
        else
        {
            _S318 = false;
        }
        var _S320 : bool;
        if(_S318)
        {
            _S320 = (all(((*voxel_13) < far_2)));
        }
        else
        {
            _S320 = false;
        }
        if(_S320)
        {
        }
        else
        {
            break;
        }
        var _S321 : bool = Walk_leave_0(this_47, &((*voxel_13)), select(far_2, near_3, (*voxel_13) < near_3));
        if(!_S321)
        {
            return false;
        }
        axis_4 = axis_4 + u32(1);
    }
    if((all(((*voxel_13) >= near_3))))
    {
        _S318 = (all(((*voxel_13) < far_2)));
    }
    else
    {
        _S318 = false;
    }
    return _S318;
}

fn flip_of_0( octant_1 : u32) -> u32
{
    return ((((((octant_1 & (u32(1)))) | (((((octant_1 & (u32(2)))) << (u32(1))))))) | (((((octant_1 & (u32(4)))) << (u32(2))))))) * u32(3);
}

fn dot_cells_0( a_5 : vec3<i32>,  b_5 : vec3<i32>) -> i32
{
    return a_5.x * b_5.x + a_5.y * b_5.y + a_5.z * b_5.z;
}

fn ahead_of_0( mirror_0 : vec3<i32>) -> u32
{
    var bits_3 : vec3<u32> = (vec3<u32>(~mirror_0) & (vec3<u32>(u32(31), u32(992), u32(31744))));
    return ((((bits_3.x) | ((bits_3.y)))) | ((bits_3.z)));
}

fn skip_distance_0( cell_10 : u32,  octant_2 : u32) -> u32
{
    var code_2 : u32 = (((cell_10 >> ((u32(3) * octant_2)))) & (u32(7)));
    var _S322 : u32;
    if(code_2 < u32(2))
    {
        _S322 = code_2 + u32(1);
    }
    else
    {
        _S322 = ((u32(3) + ((code_2 & (u32(1))))) << ((((code_2 >> (u32(1)))) - u32(1))));
    }
    return _S322;
}

fn extents_0( cell_11 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_11 & (ahead_0))) | (((((cell_11 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

fn blocks_of_cell_0( cell_12 : u32) -> u32
{
    return (((cell_12 >> (u32(23)))) & (u32(255)));
}

fn blocks_of_record_0( record_3 : u32) -> u32
{
    return ((brick_word_0(record_3)) & (u32(255)));
}

fn empty_around_0( record_4 : u32,  blocks_0 : u32,  voxel_14 : vec3<i32>,  octant_3 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_14.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_14.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_14.z) & (i32(4))))))) ^ (octant_3));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_1 : u32 = ((cell_in_node_0(voxel_14, u32(0))) ^ (flip_0));
    var half_3 : u32 = brick_word_0(record_4 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_1 >> (u32(5)))));
    if(((((half_3 >> (((bit_1 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S323 : i32;
    if(((((half_3 >> (((bit_1 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S323 = i32(1);
    }
    else
    {
        _S323 = i32(0);
    }
    return u32(_S323);
}

fn Walk_leave_1( this_48 : Walk_0,  voxel_15 : ptr<function, vec3<i32>>,  exit_4 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S324 : bool = Walk_leave_rounded_0(this_48, &((*voxel_15)), exit_4);
        return _S324;
    }
    var t_10 : vec3<f32> = Walk_crossings_0(this_48, exit_4);
    var t_first_2 : f32 = min_element_0(t_10);
    if(t_first_2 > (this_48.t_end_0))
    {
        return false;
    }
    var back_1 : vec3<f32> = (bitcast<vec3<f32>>((min((bitcast<vec3<u32>>((fma(t_10 - vec3<f32>(t_first_2), this_48.speed_1, vec3<f32>(0.5f))))), vec3<u32>((bitcast<u32>((2.097152e+06f))))))));
    var _S325 : vec3<f32> = vec3<f32>(1.2582912e+07f);
    var rounded_1 : vec3<f32> = back_1 + _S325;
    var _S326 : vec3<i32> = exit_4 - ((bitcast<vec3<i32>>((rounded_1))) - vec3<i32>(i32(1262485504)));
    var _S327 : vec3<f32> = vec3<f32>(0.5f);
    var is_unsure_1 : vec3<bool> = (abs(rounded_1 - _S325 - back_1)) >= (_S327 - this_48.tolerance_0);
    var _S328 : bool = is_unsure_1.x;
    var _S329 : bool;
    if(_S328)
    {
        _S329 = is_unsure_1.y;
    }
    else
    {
        _S329 = false;
    }
    if(_S329)
    {
        _S329 = true;
    }
    else
    {
        if(_S328)
        {
            _S329 = true;
        }
        else
        {
            _S329 = is_unsure_1.y;
        }
        if(_S329)
        {
            _S329 = is_unsure_1.z;
        }
        else
        {
            _S329 = false;
        }
    }
    var arrival_2 : vec3<i32>;
    if(_S329)
    {
        arrival_2 = leave_box_0(this_48.origin_9, this_48.speed_1, (*voxel_15) + this_48.offset_0, exit_4 + this_48.offset_0, exit_4 - vec3<i32>(round(back_1 - _S327)) + this_48.offset_0) - this_48.offset_0;
    }
    else
    {
        arrival_2 = _S326;
    }
    (*voxel_15) = max(arrival_2, (*voxel_15));
    return true;
}

fn first_voxel_0( grid_10 : PackedGrid_0,  walk_1 : Walk_0,  found_2 : ptr<function, vec3<i32>>) -> bool
{
    var _S330 : Walk_0 = walk_1;
    var _S331 : vec3<i32> = vec3<i32>(i32(0));
    (*found_2) = _S331;
    var voxel_16 : vec3<i32> = Walk_start_voxel_0(walk_1);
    var _S332 : bool = Walk_enter_0(walk_1, &(voxel_16), cell_of_0(grid_10.min_1) - _S330.base_0, cell_of_0(grid_10.max_1) - _S330.base_0);
    if(!_S332)
    {
        return false;
    }
    var octant_4 : u32 = _S330.octant_0;
    var _S333 : u32 = flip_of_0(_S330.octant_0);
    var top_shift_1 : u32 = top_shift_of_0(grid_10);
    var top_size_1 : vec3<i32> = cell_of_0(grid_10.top_size_0);
    var low_13 : vec3<i32> = cell_of_0(grid_10.origin_4) - _S330.base_0;
    var _S334 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S334, _S334 * top_size_1.y);
    var _S335 : vec3<u32> = vec3<u32>(top_shift_1);
    var _S336 : i32 = i32(grid_10.top_offset_0) - dot_cells_0((stride_0 & ((Walk_mirror_0(_S330)))), vec3<i32>(i32(1))) - dot_cells_0(stride_0, (low_13 >> (_S335)));
    var _S337 : vec3<i32> = Walk_mirrored_plane_0(_S330, stride_0);
    var _S338 : u32 = ahead_of_0(Walk_mirror_0(_S330));
    var end_1 : vec3<i32> = Walk_mirrored_plane_0(_S330, select(low_13 + ((top_size_1 << (_S335))), low_13, (Walk_mirror_0(_S330)) != _S331));
    if(!IS_EXACT_0)
    {
        _S330.t_end_0 = min(_S330.t_end_0, min_element_0(Walk_crossings_0(_S330, end_1)));
    }
    var is_found_3 : bool = false;
    for(;;)
    {
        var _S339 : bool;
        if(IS_EXACT_0)
        {
            _S339 = (any((voxel_16 >= end_1)));
        }
        else
        {
            _S339 = false;
        }
        if(_S339)
        {
            break;
        }
        var cell_13 : u32 = cell_word_0(u32(_S336 + dot_cells_0(_S337, (voxel_16 >> (_S335)))));
        var is_found_4 : bool;
        var cell_14 : u32;
        var shift_4 : u32;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_13 & (u32(2147483648)))) != u32(0))
            {
                cell_14 = cell_word_0(((cell_13 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_16, u32(3))) ^ (_S333))));
                shift_4 = u32(3);
            }
            else
            {
                cell_14 = cell_13;
                shift_4 = top_shift_1;
            }
        }
        else
        {
            cell_14 = cell_13;
            shift_4 = top_shift_1;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_4 = shift_4 > u32(3);
                }
                else
                {
                    is_found_4 = false;
                }
                var _S340 : bool;
                if(is_found_4)
                {
                    _S340 = ((cell_14 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S340 = false;
                }
                if(_S340)
                {
                }
                else
                {
                    break;
                }
                var shift_5 : u32 = shift_4 - u32(2);
                cell_14 = cell_word_0(((cell_14 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_16, shift_5)) ^ (_S333))));
                shift_4 = shift_5;
            }
        }
        if(waits_for_pages_0())
        {
            break;
        }
        var exit_5 : vec3<i32>;
        if(((cell_14 & (u32(2147483648)))) == u32(0))
        {
            if(CELLS_SKIP_0)
            {
                exit_5 = vec3<i32>((i32(skip_distance_0(cell_14, octant_4)) - i32(1)));
            }
            else
            {
                exit_5 = extents_0(cell_14, _S338);
            }
            exit_5 = ((voxel_16 | (vec3<i32>((((i32(1) << (shift_4))) - i32(1)))))) + vec3<i32>(i32(1)) + ((exit_5 << (vec3<u32>(shift_4))));
            is_found_4 = is_found_3;
        }
        else
        {
            var record_5 : u32 = record_of_cell_0(cell_14);
            var blocks_1 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_1 = blocks_of_cell_0(cell_14);
            }
            else
            {
                blocks_1 = blocks_of_record_0(record_5);
            }
            var low_bits_0 : u32 = empty_around_0(record_5, blocks_1, voxel_16, octant_4, _S333);
            var is_found_5 : bool = low_bits_0 == u32(4294967295);
            if(is_found_5)
            {
                is_found_3 = is_found_5;
                break;
            }
            exit_5 = ((voxel_16 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_4 = is_found_5;
        }
        var _S341 : bool = Walk_leave_1(_S330, &(voxel_16), exit_5);
        if(!_S341)
        {
            is_found_3 = is_found_4;
            break;
        }
        is_found_3 = is_found_4;
    }
    (*found_2) = Walk_mirrored_0(_S330, voxel_16) + _S330.base_0;
    return is_found_3;
}

fn ray_of_walk_0( walk_2 : Walk_0,  ray_20 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (Walk_mirror_0(walk_2)) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_2.origin_9, (vec3<f32>(0) - walk_2.origin_9), is_mirrored_1) + vec3<f32>(walk_2.base_0), ray_20.t_min_0, select(walk_2.speed_1, (vec3<f32>(0) - walk_2.speed_1), is_mirrored_1), ray_20.t_max_0);
}

fn hit_at_0( last_5 : Crossing_0,  t_min_3 : f32,  inverse_2 : vec3<f32>,  voxel_17 : vec3<i32>,  instance_12 : u32,  octant_5 : u32) -> Hit_0
{
    var t_11 : f32 = last_5.distance_0 * inverse_2[last_5.axis_1];
    var _S342 : f32;
    if(t_11 > t_min_3)
    {
        _S342 = t_11;
    }
    else
    {
        _S342 = t_min_3;
    }
    return Hit_x24init_0(_S342, instance_12, voxel_17, u32(2) * last_5.axis_1 + ((((octant_5 >> ((last_5.axis_1)))) & (u32(1)))));
}

fn hit_of_walk_0( walk_3 : Walk_0,  voxel_18 : vec3<i32>,  instance_13 : u32) -> Hit_0
{
    var planes_3 : vec3<i32> = Walk_mirrored_0(walk_3, voxel_18 - walk_3.base_0);
    if(IS_EXACT_0)
    {
        return hit_at_0(crossing_among_0(walk_3.origin_9, walk_3.speed_1, planes_3 + walk_3.offset_0, false), walk_3.ray_17.t_min_2, walk_3.inverse_1, voxel_18, instance_13, walk_3.octant_0);
    }
    var t_12 : vec3<f32> = Walk_crossings_0(walk_3, planes_3);
    var last_6 : f32 = max_element_0(t_12);
    var _S343 : i32;
    if((t_12.z) == last_6)
    {
        _S343 = i32(2);
    }
    else
    {
        if((t_12.y) == last_6)
        {
            _S343 = i32(1);
        }
        else
        {
            _S343 = i32(0);
        }
    }
    var axis_5 : u32 = u32(_S343);
    return Hit_x24init_0(max(last_6, walk_3.ray_17.t_min_2), instance_13, voxel_18, u32(2) * axis_5 + (((((walk_3.octant_0) >> (axis_5))) & (u32(1)))));
}

fn hit_in_0( instance_14 : u32,  ray_21 : ptr<function, Ray_0>) -> Hit_0
{
    var local_4 : LocalRay_0 = local_ray_0((*ray_21), Instances_operatorx5Bx5D_get_0(instance_14).grid_from_world_0);
    if(!local_4.is_valid_0)
    {
        return miss_0();
    }
    var _S344 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(instance_14).grid_0);
    var _S345 : bool;
    if(IS_EXACT_0)
    {
        _S345 = TOP_SHIFT_0 == u32(3);
    }
    else
    {
        _S345 = false;
    }
    var base_2 : vec3<i32>;
    if(_S345)
    {
        base_2 = vec3<i32>(i32(0));
    }
    else
    {
        base_2 = cell_of_0(_S344.origin_4);
    }
    var walk_4 : Walk_0 = walk_from_0(base_2, local_4, _S344);
    var voxel_19 : vec3<i32>;
    var is_found_6 : bool = first_voxel_0(_S344, walk_4, &(voxel_19));
    if(IS_SINGLE_0)
    {
        _S345 = !IS_EXACT_0;
    }
    else
    {
        _S345 = false;
    }
    if(_S345)
    {
        (*ray_21) = ray_of_walk_0(walk_4, (*ray_21));
    }
    if(!is_found_6)
    {
        return miss_0();
    }
    var hit_14 : Hit_0 = hit_of_walk_0(walk_4, voxel_19, instance_14);
    if((hit_14.t_0) > ((*ray_21).t_max_0))
    {
        return miss_0();
    }
    return hit_14;
}

struct InstanceNode_0
{
     min_2 : array<f32, i32(3)>,
     index_28 : u32,
     max_2 : array<f32, i32(3)>,
     is_leaf_0 : u32,
};

fn Rows_operatorx5Bx5D_get_6( row_10 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(2)) + row_10];
}

fn InstanceNodes_operatorx5Bx5D_get_0( index_29 : u32) -> InstanceNode_0
{
    var _S346 : u32 = u32(2) * index_29;
    var _S347 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S346);
    var _S348 : vec4<u32> = Rows_operatorx5Bx5D_get_6(_S346 + u32(1));
    var node_11 : InstanceNode_0;
    var _S349 : f32 = (bitcast<f32>((_S347.y)));
    var _S350 : f32 = (bitcast<f32>((_S347.z)));
    node_11.min_2[i32(0)] = (bitcast<f32>((_S347.x)));
    node_11.min_2[i32(1)] = _S349;
    node_11.min_2[i32(2)] = _S350;
    node_11.index_28 = _S347.w;
    var _S351 : f32 = (bitcast<f32>((_S348.y)));
    var _S352 : f32 = (bitcast<f32>((_S348.z)));
    node_11.max_2[i32(0)] = (bitcast<f32>((_S348.x)));
    node_11.max_2[i32(1)] = _S351;
    node_11.max_2[i32(2)] = _S352;
    node_11.is_leaf_0 = _S348.w;
    return node_11;
}

fn entry_0( node_12 : InstanceNode_0,  ray_22 : Ray_0,  inverse_3 : vec3<f32>) -> f32
{
    var low_14 : vec3<f32> = (vector_of_0(node_12.min_2) - ray_22.origin_1) * inverse_3;
    var high_5 : vec3<f32> = (vector_of_0(node_12.max_2) - ray_22.origin_1) * inverse_3;
    var _S353 : f32 = max(ray_22.t_min_0, max_element_0(min(low_14, high_5)));
    var _S354 : f32;
    if(_S353 <= (min(ray_22.t_max_0, min_element_0(max(low_14, high_5)))))
    {
        _S354 = _S353;
    }
    else
    {
        _S354 = (bitcast<f32>(infinity_bits_0));
    }
    return _S354;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool,  end_2 : u32) -> Hit_0
{
    var is_leaf_1 : bool;
    if(IS_SINGLE_0)
    {
        var _S355 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S355;
    }
    var ray_23 : Ray_0 = (*given_0);
    var nearest_3 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_3;
    }
    var is_zero_1 : vec3<bool> = !((abs(ray_23.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S356 : vec3<f32> = select(reciprocal_0(select(ray_23.direction_1, vec3<f32>(1.0f), is_zero_1)), vec3<f32>(3.4028234663852886e+38f), is_zero_1);
    var stack_0 : array<u32, i32(32)>;
    var entries_0 : array<f32, i32(32)>;
    var _S357 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(u32(0));
    var _S358 : bool = (InstanceNodes_operatorx5Bx5D_get_0(u32(0)).is_leaf_0) != u32(0);
    var is_done_0 : bool = false;
    var is_leaf_2 : bool = _S358;
    var index_30 : u32 = u32(0);
    var below_1 : u32 = _S357.index_28;
    var nearest_4 : Hit_0 = nearest_3;
    var depth_0 : u32 = u32(0);
    for(;;)
    {
        var is_done_1 : bool = is_done_0;
        var below_2 : u32 = below_1;
        var depth_1 : u32 = depth_0;
        for(;;)
        {
            var _S359 : bool;
            if(is_done_1)
            {
                _S359 = depth_1 > u32(0);
            }
            else
            {
                _S359 = !is_leaf_2;
            }
            if(_S359)
            {
            }
            else
            {
                break;
            }
            var index_31 : u32;
            if(is_done_1)
            {
                var depth_2 : u32 = depth_1 - u32(1);
                var _S360 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]);
                var _S361 : bool = (InstanceNodes_operatorx5Bx5D_get_0(stack_0[depth_2]).is_leaf_0) != u32(0);
                is_done_1 = (entries_0[depth_2]) > (ray_23.t_max_0);
                is_leaf_1 = _S361;
                index_31 = stack_0[depth_2];
                below_2 = _S360.index_28;
                depth_1 = depth_2;
            }
            else
            {
                var _S362 : u32 = index_30 + u32(1);
                var _S363 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(_S362);
                var _S364 : InstanceNode_0 = InstanceNodes_operatorx5Bx5D_get_0(below_2);
                var to_left_0 : f32 = entry_0(_S363, ray_23, _S356);
                var to_right_0 : f32 = entry_0(_S364, ray_23, _S356);
                var is_left_4 : bool = to_left_0 <= to_right_0;
                var _S365 : f32 = max(to_left_0, to_right_0);
                var INFINITY_0 : f32 = (bitcast<f32>(infinity_bits_0));
                if(_S365 < INFINITY_0)
                {
                    if(is_left_4)
                    {
                        index_31 = below_2;
                    }
                    else
                    {
                        index_31 = _S362;
                    }
                    stack_0[depth_1] = index_31;
                    entries_0[depth_1] = _S365;
                    index_31 = depth_1 + u32(1);
                }
                else
                {
                    index_31 = depth_1;
                }
                var _S366 : bool = (min(to_left_0, to_right_0)) == INFINITY_0;
                var _S367 : u32;
                if(is_left_4)
                {
                    _S367 = _S362;
                }
                else
                {
                    _S367 = below_2;
                }
                var _S368 : u32;
                if(is_left_4)
                {
                    _S368 = _S363.index_28;
                }
                else
                {
                    _S368 = _S364.index_28;
                }
                var _S369 : u32;
                if(is_left_4)
                {
                    _S369 = _S363.is_leaf_0;
                }
                else
                {
                    _S369 = _S364.is_leaf_0;
                }
                var _S370 : bool = _S369 != u32(0);
                var _S371 : u32 = index_31;
                is_done_1 = _S366;
                is_leaf_1 = _S370;
                index_31 = _S367;
                below_2 = _S368;
                depth_1 = _S371;
            }
            is_leaf_2 = is_leaf_1;
            index_30 = index_31;
        }
        if(is_done_1)
        {
            break;
        }
        var _S372 : Hit_0 = hit_in_0(below_2, &(ray_23));
        var _S373 : Hit_0 = nearest_4;
        if((_S372.t_0) < (nearest_4.t_0))
        {
            is_leaf_1 = true;
        }
        else
        {
            if((_S372.t_0) == (_S373.t_0))
            {
                is_leaf_1 = (_S372.instance_1) < (nearest_4.instance_1);
            }
            else
            {
                is_leaf_1 = false;
            }
        }
        if(is_leaf_1)
        {
            ray_23.t_max_0 = _S372.t_0;
            if(is_any_enough_0)
            {
                return _S372;
            }
            nearest_4 = _S372;
        }
        is_done_0 = true;
        below_1 = below_2;
        depth_0 = depth_1;
    }
    return nearest_4;
}

fn WalkTracer_trace_0( ray_24 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    var _S374 : Hit_0 = visit_0(&((*ray_24)), is_any_enough_1, u32(0));
    return _S374;
}

fn hit_of_ray_0( sampler_1 : Sampler_0,  ray_25 : ptr<function, Ray_0>,  is_shadow_ray_1 : bool,  path_10 : ptr<function, Path_0>,  shadow_inside_3 : ptr<function, Inside_0>,  relocates_3 : ptr<function, bool>,  path_relocates_3 : ptr<function, bool>,  beyond_9 : ptr<function, u32>) -> Hit_0
{
    (*beyond_9) = u32(4294967295);
    var _S375 : Hit_0 = WalkTracer_trace_0(&((*ray_25)), is_shadow_ray_1);
    return _S375;
}

fn goes_on_4( at_10 : ptr<function, Walker_0>,  sample_13 : ptr<function, Sample_0>) -> bool
{
    var beyond_10 : u32 = u32(4294967295);
    var _S376 : Ray_0 = (*at_10).ray_10;
    var _S377 : Path_0 = (*at_10).path_7;
    var _S378 : Inside_0 = (*at_10).shadow_inside_2;
    var _S379 : bool = (*at_10).relocates_2;
    var _S380 : bool = (*at_10).path_relocates_2;
    var _S381 : Hit_0 = hit_of_ray_0((*at_10).path_7.sampler_0, &(_S376), false, &(_S377), &(_S378), &(_S379), &(_S380), &(beyond_10));
    (*at_10).ray_10 = _S376;
    (*at_10).path_7 = _S377;
    (*at_10).shadow_inside_2 = _S378;
    (*at_10).relocates_2 = _S379;
    (*at_10).path_relocates_2 = _S380;
    var _S382 : bool = goes_on_from_0(&((*at_10)), _S381, beyond_10, &((*sample_13)));
    return _S382;
}

fn Walker_arrives_0( this_49 : ptr<function, Walker_0>,  hit_15 : Hit_0,  beyond_11 : u32,  light_9 : ptr<function, vec3<f32>>) -> bool
{
    if(Hit_is_miss_0(hit_15))
    {
        (*light_9) = (*light_9) + (*this_49).light_5;
    }
    return false;
}

fn place_of_found_0( place_6 : u32) -> u32
{
    return place_of_known_0(place_6) + u32(131072);
}

fn count_arrival_0( ray_26 : Ray_0,  has_arrived_0 : bool)
{
    var _S383 : i32;
    if(has_arrived_0)
    {
        _S383 = i32(65537);
    }
    else
    {
        _S383 = i32(1);
    }
    var _S384 : u32 = atomicAdd(&(cell_keys_0[place_of_found_0(place_of_ray_0(ray_26))]), u32(_S383));
    return;
}

fn goes_on_5( at_11 : ptr<function, Walker_0>,  sample_14 : ptr<function, Sample_0>) -> bool
{
    var _S385 : Hit_0 = miss_0();
    var beyond_12 : u32 = u32(4294967295);
    var _S386 : bool = (*at_11).is_shadow_ray_0;
    var hit_16 : Hit_0;
    if(!(*at_11).is_at_cell_0)
    {
        var _S387 : Ray_0 = (*at_11).ray_10;
        var _S388 : Path_0 = (*at_11).path_7;
        var _S389 : Inside_0 = (*at_11).shadow_inside_2;
        var _S390 : bool = (*at_11).relocates_2;
        var _S391 : bool = (*at_11).path_relocates_2;
        var _S392 : Hit_0 = hit_of_ray_0((*at_11).path_7.sampler_0, &(_S387), _S386, &(_S388), &(_S389), &(_S390), &(_S391), &(beyond_12));
        (*at_11).ray_10 = _S387;
        (*at_11).path_7 = _S388;
        (*at_11).shadow_inside_2 = _S389;
        (*at_11).relocates_2 = _S390;
        (*at_11).path_relocates_2 = _S391;
        if(_S386)
        {
            var to_light_0 : Ray_0 = (*at_11).ray_10;
            var _S393 : vec3<f32> = (*sample_14).light_6;
            var _S394 : bool = Walker_arrives_0(&((*at_11)), _S392, beyond_12, &(_S393));
            (*sample_14).light_6 = _S393;
            (*at_11).is_shadow_ray_0 = _S394;
            if((*at_11).counts_0)
            {
                count_arrival_0(to_light_0, Hit_is_miss_0(_S392));
            }
            (*at_11).counts_0 = false;
            if((*at_11).is_shadow_ray_0)
            {
                return true;
            }
            (*at_11).ray_10 = ray_from_0((*at_11).ray_10.origin_1, (*at_11).direction_25);
            return (any((((*at_11).direction_25) != vec3<f32>(0.0f))));
        }
        hit_16 = _S392;
    }
    else
    {
        hit_16 = _S385;
    }
    var _S395 : bool = goes_on_from_1(&((*at_11)), hit_16, beyond_12, &((*sample_14)));
    return _S395;
}

fn PathTracingOf_jitter_0( sampler_2 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_2, u32(0));
}

fn Sampler_x24init_0( seed_3 : u32,  pixel_1 : u32,  sample_15 : u32) -> Sampler_0
{
    var _S396 : Sampler_0;
    _S396.seed_1 = seed_3;
    _S396.pixel_0 = pixel_1;
    _S396.sample_0 = sample_15;
    return _S396;
}

struct Item_0
{
     traces_0 : bool,
     kind_2 : u32,
     at_12 : vec2<u32>,
     place_7 : u32,
     slot_0 : u32,
     sampler_3 : Sampler_0,
};

fn Item_x24init_0( traces_1 : bool,  kind_3 : u32,  at_13 : vec2<u32>,  place_8 : u32,  slot_1 : u32,  sampler_4 : Sampler_0) -> Item_0
{
    var _S397 : Item_0;
    _S397.traces_0 = traces_1;
    _S397.kind_2 = kind_3;
    _S397.at_12 = at_13;
    _S397.place_7 = place_8;
    _S397.slot_0 = slot_1;
    _S397.sampler_3 = sampler_4;
    return _S397;
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

fn Item_key_0( this_50 : Item_0,  rank_3 : ptr<function, u32>) -> Key_0
{
    var face_8 : vec4<u32> = cell_row_0(u32(1), this_50.place_7);
    (*rank_3) = face_8.z;
    return Key_x24init_0(face_8.x, face_8.y, vec3<i32>(cell_row_0(u32(2), this_50.place_7).xyz));
}

fn Item_key_1( this_51 : Item_0,  rank_4 : ptr<function, u32>) -> Key_0
{
    var face_9 : vec4<u32> = cell_row_0(u32(1), this_51.place_7);
    (*rank_4) = face_9.z;
    return Key_x24init_0(face_9.x, face_9.y, vec3<i32>(cell_row_0(u32(2), this_51.place_7).xyz));
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
        var _S398 : vec2<u32> = pixel_of_thread_0(thread_1);
        return _S398;
    }
    var tiles_1 : u32 = (params_0.width_0 + u32(15)) / u32(16);
    var tile_1 : u32 = thread_1 / u32(64);
    var in_tile_1 : u32 = (thread_1 & (u32(63)));
    var row_12 : u32 = tile_1 / tiles_1;
    var _S399 : u32 = row_12 * u32(8) + ((in_tile_1 >> (u32(3))));
    var at_14 : vec2<u32> = vec2<u32>((tile_1 - row_12 * tiles_1) * u32(16) + u32(2) * ((in_tile_1 & (u32(7)))), _S399);
    at_14[i32(0)] = at_14[i32(0)] + (((_S399 + real_time_0.number_0) & (u32(1))));
    return at_14;
}

fn squares_1() -> vec2<u32>
{
    var _S400 : vec2<u32> = vec2<u32>(u32(5));
    var _S401 : vec2<u32> = (vec2<u32>(params_0.width_0, params_0.height_0) + _S400 - vec2<u32>(u32(1))) / _S400;
    return _S401;
}

fn pixel_of_square_0( square_1 : u32,  number_3 : u32) -> vec2<u32>
{
    var columns_1 : u32 = squares_1().x;
    var _S402 : u32 = square_1 % columns_1;
    var _S403 : u32 = square_1 / columns_1;
    var at_15 : vec2<u32> = vec2<u32>(_S402, _S403);
    var _S404 : vec2<u32> = vec2<u32>(u32(5));
    var _S405 : vec2<u32> = at_15 * _S404;
    var _S406 : vec2<u32> = pcg4d_0(vec4<u32>(at_15, number_3, u32(3266489909))).xy % _S404;
    return min(_S405 + _S406, vec2<u32>(params_0.width_0, params_0.height_0) - vec2<u32>(u32(1)));
}

fn is_inside_0( at_16 : vec2<i32>) -> bool
{
    var _S407 : bool;
    if((all((at_16 >= vec2<i32>(i32(0))))))
    {
        _S407 = (at_16.x) < i32(params_0.width_0);
    }
    else
    {
        _S407 = false;
    }
    if(_S407)
    {
        _S407 = (at_16.y) < i32(params_0.height_0);
    }
    else
    {
        _S407 = false;
    }
    return _S407;
}

fn place_of_square_0( list_0 : u32,  square_2 : u32) -> u32
{
    var count_6 : vec2<u32> = squares_1();
    return u32(4) * real_time_0.pixels_0 + list_0 * count_6.x * count_6.y + square_2;
}

fn index_of_0( at_17 : vec2<u32>) -> u32
{
    return at_17.y * params_0.width_0 + at_17.x;
}

fn item_of_0( number_4 : u32) -> Item_0
{
    var item_0 : Item_0 = Item_x24init_0(false, u32(0), vec2<u32>(vec2<i32>(i32(0))), u32(0), u32(0), Sampler_x24init_0(u32(0), u32(0), u32(0)));
    var cells_2 : u32 = real_time_0.cells_0;
    var pixels_1 : u32 = threads_that_trace_0();
    var count_7 : u32 = real_time_0.squares_0;
    if(number_4 < (real_time_0.cells_0))
    {
        var _S408 : u32 = atomicLoad(&(cell_keys_0[u32(2)]));
        var _S409 : bool = number_4 < _S408;
        item_0.traces_0 = _S409;
        if(_S409)
        {
            var _S410 : u32 = atomicLoad(&(cell_keys_0[place_of_chosen_0(number_4)]));
            item_0.place_7 = _S410;
            item_0.slot_0 = real_time_0.pixels_0 + count_7 + number_4;
            var rank_5 : u32;
            item_0.sampler_3 = Sampler_x24init_0(((params_0.seed_0) ^ (u32(1540483477))), Key_hash_0(Item_key_1(item_0, &(rank_5))).x, real_time_0.number_0);
        }
        return item_0;
    }
    var _S411 : u32 = number_4 - cells_2;
    var _S412 : vec2<u32> = pixel_that_traces_0(_S411);
    item_0.at_12 = _S412;
    var square_3 : u32 = _S411 - pixels_1;
    var is_square_0 : bool = number_4 >= (cells_2 + pixels_1);
    var is_again_0 : bool;
    if(is_square_0)
    {
        is_again_0 = square_3 >= count_7;
    }
    else
    {
        is_again_0 = false;
    }
    var frame_0 : u32;
    if(is_again_0)
    {
        frame_0 = count_7;
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
    var _S413 : u32;
    if(is_again_0)
    {
        _S413 = u32(3);
    }
    else
    {
        if(is_square_0)
        {
            _S413 = u32(2);
        }
        else
        {
            _S413 = u32(1);
        }
    }
    item_0.kind_2 = _S413;
    if(is_square_0)
    {
        var _S414 : vec2<u32> = pixel_of_square_0(square_4, frame_0);
        item_0.at_12 = _S414;
    }
    var _S415 : bool;
    if(is_square_0)
    {
        if(is_again_0)
        {
            _S413 = real_time_0.again_0;
        }
        else
        {
            _S413 = count_7;
        }
        _S415 = square_4 < _S413;
    }
    else
    {
        _S415 = is_inside_0(vec2<i32>(item_0.at_12));
    }
    item_0.traces_0 = _S415;
    if(is_square_0)
    {
        if(is_again_0)
        {
            _S413 = u32(2);
        }
        else
        {
            _S413 = (frame_0 & (u32(1)));
        }
        _S413 = place_of_square_0(_S413, square_4);
    }
    else
    {
        _S413 = index_of_0(item_0.at_12);
    }
    item_0.place_7 = _S413;
    if(is_square_0)
    {
        _S413 = real_time_0.pixels_0 + square_4;
    }
    else
    {
        _S413 = item_0.place_7;
    }
    item_0.slot_0 = _S413;
    var _S416 : u32 = params_0.seed_0;
    if(is_square_0)
    {
        _S413 = u32(3266489909);
    }
    else
    {
        _S413 = u32(2654435769);
    }
    item_0.sampler_3 = Sampler_x24init_0((_S416 ^ (_S413)), index_of_0(item_0.at_12), frame_0);
    return item_0;
}

fn weigh_candidates_0( is_of_pixel_0 : bool,  pixel_2 : u32,  counts_1 : bool)
{
    var _S417 : bool;
    if(is_of_pixel_0)
    {
        _S417 = has_0(u32(4096));
    }
    else
    {
        _S417 = false;
    }
    weighs_candidates_0 = _S417;
    counts_arrivals_0 = false;
    if(_S417)
    {
        _S417 = counts_1;
    }
    else
    {
        _S417 = false;
    }
    if(_S417)
    {
        var stride_1 : u32 = (real_time_0.pixels_0 + u32(32768) - u32(1)) / u32(32768);
        var _S418 : u32 = pixel_2 / stride_1;
        var _S419 : u32 = (pixel_2 + u32(7) * _S418 + real_time_0.number_0) % stride_1;
        counts_arrivals_0 = _S419 == u32(0);
    }
    return;
}

fn Sample_x24init_0( direct_1 : vec3<f32>,  light_10 : vec3<f32>,  is_shown_1 : bool,  albedo_1 : vec3<f32>,  normal_7 : vec3<f32>,  place_9 : vec3<f32>,  instance_15 : u32) -> Sample_0
{
    var _S420 : Sample_0;
    _S420.direct_0 = direct_1;
    _S420.light_6 = light_10;
    _S420.is_shown_0 = is_shown_1;
    _S420.albedo_0 = albedo_1;
    _S420.normal_4 = normal_7;
    _S420.place_3 = place_9;
    _S420.instance_8 = instance_15;
    return _S420;
}

fn no_sample_0() -> Sample_0
{
    var _S421 : vec3<f32> = vec3<f32>(0.0f);
    return Sample_x24init_0(_S421, _S421, false, _S421, _S421, _S421, u32(4294967294));
}

fn Item_is_cell_0( this_52 : Item_0) -> bool
{
    return (this_52.kind_2) == u32(0);
}

fn Key_voxel_0( this_53 : Key_0,  code_3 : u32,  scramble_0 : u32) -> vec3<i32>
{
    var _S422 : u32 = Key_level_0(this_53);
    var bits_4 : u32 = ((u32(1) << (_S422))) - u32(1);
    var place_10 : u32 = ((code_3 - u32(1)) ^ (((scramble_0 & ((Key_mask_0(this_53)))))));
    return (((this_53.cube_0) << (vec3<u32>(u32(i32(_S422)))))) + vec3<i32>(i32((place_10 & (bits_4))), i32((((place_10 >> (_S422))) & (bits_4))), i32((((place_10 >> ((u32(2) * _S422)))) & (bits_4))));
}

fn Path_x24init_0( sampler_5 : Sampler_0,  bounce_3 : u32,  event_2 : u32,  kinds_1 : u32,  scattered_4 : u32,  beta_1 : vec3<f32>,  pdf_12 : f32,  normal_8 : vec3<f32>,  selection_4 : Selection_0,  passed_t_1 : f32,  inside_6 : Inside_0,  is_clipped_1 : bool) -> Path_0
{
    var _S423 : Path_0;
    _S423.sampler_0 = sampler_5;
    _S423.bounce_0 = bounce_3;
    _S423.event_0 = event_2;
    _S423.kinds_0 = kinds_1;
    _S423.scattered_0 = scattered_4;
    _S423.beta_0 = beta_1;
    _S423.pdf_1 = pdf_12;
    _S423.normal_0 = normal_8;
    _S423.selection_0 = selection_4;
    _S423.passed_t_0 = passed_t_1;
    _S423.inside_0 = inside_6;
    _S423.is_clipped_0 = is_clipped_1;
    return _S423;
}

fn path_from_0( sampler_6 : Sampler_0) -> Path_0
{
    return Path_x24init_0(sampler_6, u32(0), u32(0), u32(0), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f), Selection_x24init_0(0.0f, 0.0f, 0.0f), 0.0f, in_air_0(), true);
}

fn orthonormal_pair_0( z_1 : vec3<f32>,  x_10 : ptr<function, vec3<f32>>,  y_5 : ptr<function, vec3<f32>>)
{
    var _S424 : f32 = z_1.z;
    var sign_0 : f32;
    if(_S424 < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_6 : f32 = divide_0(-1.0f, sign_0 + _S424);
    var _S425 : f32 = z_1.x;
    var _S426 : f32 = z_1.y;
    var b_6 : f32 = _S425 * _S426 * a_6;
    (*x_10) = vec3<f32>(1.0f + sign_0 * _S425 * _S425 * a_6, sign_0 * b_6, - sign_0 * _S425);
    (*y_5) = vec3<f32>(b_6, sign_0 + _S426 * _S426 * a_6, - _S426);
    return;
}

fn direction_from_cell_0( sampler_7 : Sampler_0,  normal_9 : vec3<f32>,  pdf_13 : ptr<function, f32>) -> vec3<f32>
{
    var u_19 : vec4<f32> = Sampler_independent_0(sampler_7, u32(0));
    var x_11 : vec3<f32>;
    var y_6 : vec3<f32>;
    orthonormal_pair_0(normal_9, &(x_11), &(y_6));
    var local_5 : vec3<f32> = cosine_hemisphere_0(u_19.z, u_19.w);
    var _S427 : f32 = local_5.z;
    (*pdf_13) = cosine_hemisphere_pdf_0(_S427);
    return x_11 * vec3<f32>(local_5.x) + y_6 * vec3<f32>(local_5.y) + normal_9 * vec3<f32>(_S427);
}

fn Surface_x24init_0( origin_13 : vec3<f32>,  normal_10 : vec3<f32>,  face_10 : u32,  instance_16 : u32) -> Surface_0
{
    var _S428 : Surface_0;
    _S428.origin_3 = origin_13;
    _S428.normal_2 = normal_10;
    _S428.face_1 = face_10;
    _S428.instance_3 = instance_16;
    return _S428;
}

fn Walker_x24init_0( path_11 : Path_0,  ray_27 : Ray_0,  is_shadow_ray_2 : bool,  light_11 : vec3<f32>,  direction_28 : vec3<f32>,  path_origin_3 : vec3<f32>,  shadow_inside_4 : Inside_0,  boundaries_1 : u32,  relocates_4 : bool,  path_relocates_4 : bool,  camera_ray_1 : Ray_0,  way_6 : f32,  has_shown_1 : bool,  asks_cache_1 : bool,  life_2 : u32,  is_at_cell_1 : bool,  counts_2 : bool,  sees_mover_1 : bool,  by_chance_2 : bool) -> Walker_0
{
    var _S429 : Walker_0;
    _S429.path_7 = path_11;
    _S429.ray_10 = ray_27;
    _S429.is_shadow_ray_0 = is_shadow_ray_2;
    _S429.light_5 = light_11;
    _S429.direction_25 = direction_28;
    _S429.path_origin_2 = path_origin_3;
    _S429.shadow_inside_2 = shadow_inside_4;
    _S429.boundaries_0 = boundaries_1;
    _S429.relocates_2 = relocates_4;
    _S429.path_relocates_2 = path_relocates_4;
    _S429.camera_ray_0 = camera_ray_1;
    _S429.way_2 = way_6;
    _S429.has_shown_0 = has_shown_1;
    _S429.asks_cache_0 = asks_cache_1;
    _S429.life_0 = life_2;
    _S429.is_at_cell_0 = is_at_cell_1;
    _S429.counts_0 = counts_2;
    _S429.sees_mover_0 = sees_mover_1;
    _S429.by_chance_1 = by_chance_2;
    return _S429;
}

fn at_cell_0( key_3 : Key_0,  rank_6 : u32,  sampler_8 : Sampler_0) -> Walker_0
{
    var face_11 : u32 = ((key_3.face_and_level_0) & (u32(7)));
    var axis_6 : u32 = (face_11 >> (u32(1)));
    var u_20 : vec4<f32> = Sampler_independent_0(sampler_8, u32(0));
    var _S430 : vec3<f32> = vec3<f32>(Key_voxel_0(key_3, (rank_6 & (u32(1048575))), scramble_of_0(real_time_0.number_0 - u32(1))));
    var on_face_1 : vec3<f32>;
    if(axis_6 == u32(0))
    {
        on_face_1 = vec3<f32>(0.0f, u_20.x, u_20.y);
    }
    else
    {
        if(axis_6 == u32(1))
        {
            on_face_1 = vec3<f32>(u_20.y, 0.0f, u_20.x);
        }
        else
        {
            on_face_1 = vec3<f32>(u_20.x, u_20.y, 0.0f);
        }
    }
    var _S431 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(key_3.instance_10);
    var origin_14 : vec3<f32> = Transform_point_0(_S431.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S431.grid_from_world_0.translation_0), _S430, face_11, _S430 + on_face_1));
    var normal_11 : vec3<f32> = world_normal_0(_S431, face_11);
    var path_12 : Path_0 = path_from_0(sampler_8);
    var _S432 : f32 = path_12.pdf_1;
    var direction_29 : vec3<f32> = direction_from_cell_0(sampler_8, normal_11, &(_S432));
    path_12.pdf_1 = _S432;
    var receiver_21 : Receiver_0 = Receiver_x24init_0(origin_14, normal_11);
    path_12.selection_0 = Lights_selection_0(receiver_21);
    path_12.normal_0 = normal_11;
    var surface_5 : Surface_0 = Surface_x24init_0(origin_14, normal_11, face_11, key_3.instance_10);
    var white_0 : MaterialBsdf_0;
    white_0.kind_0 = u32(0);
    white_0.color_0 = vec3<f32>(1.0f);
    white_0.specular_0 = 0.0f;
    white_0.eta_0 = 1.0f;
    white_0.facets_0.alpha_0 = 1.0f;
    scatter_of_path_0 = Scatter_x24init_0(path_12, receiver_21, surface_5, white_0, vec3<f32>(0.0f, 0.0f, 1.0f), 1.0f, false, true);
    var ray_28 : Ray_0 = ray_from_0(origin_14, direction_29);
    return Walker_x24init_0(path_12, ray_28, false, vec3<f32>(0.0f), direction_29, origin_14, in_air_0(), u32(0), false, false, ray_28, 0.0f, true, true, max((rank_6 >> (u32(20))), u32(1)) - u32(1), true, false, false, false);
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
    var _S433 : CameraFrame_0;
    _S433.lens_1 = lens_2;
    _S433.eye_2 = eye_3;
    _S433.corner_2 = corner_3;
    _S433.pixel_x_1 = pixel_x_2;
    _S433.pixel_y_1 = pixel_y_2;
    _S433.lens_x_1 = lens_x_2;
    _S433.lens_y_1 = lens_y_2;
    _S433.blades_1 = blades_2;
    return _S433;
}

@id(5) override LENS_0 : u32 = u32(0);

fn camera_before_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, real_time_0.before_eye_0, real_time_0.before_corner_0, real_time_0.before_pixel_x_0, real_time_0.before_pixel_y_0, real_time_0.before_lens_x_0, real_time_0.before_lens_y_0, real_time_0.before_blades_0);
}

struct Perspective_0
{
     eye_4 : vec3<f32>,
     corner_4 : vec3<f32>,
     pixel_x_3 : vec3<f32>,
     pixel_y_3 : vec3<f32>,
};

fn Perspective_x24init_0( eye_5 : vec3<f32>,  corner_5 : vec3<f32>,  pixel_x_4 : vec3<f32>,  pixel_y_4 : vec3<f32>) -> Perspective_0
{
    var _S434 : Perspective_0;
    _S434.eye_4 = eye_5;
    _S434.corner_4 = corner_5;
    _S434.pixel_x_3 = pixel_x_4;
    _S434.pixel_y_3 = pixel_y_4;
    return _S434;
}

struct Axes_0
{
     forward_0 : vec3<f32>,
     right_4 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_1 : vec3<f32>,  right_5 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S435 : Axes_0;
    _S435.forward_0 = forward_1;
    _S435.right_4 = right_5;
    _S435.up_0 = up_1;
    return _S435;
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
    var _S436 : ThinLens_0;
    _S436.perspective_0 = perspective_1;
    _S436.lens_x_3 = lens_x_4;
    _S436.lens_y_3 = lens_y_4;
    _S436.blades_3 = blades_4;
    return _S436;
}

fn concentric_0( square_5 : vec2<f32>) -> vec2<f32>
{
    var a_7 : f32 = 2.0f * square_5.x - 1.0f;
    var b_7 : f32 = 2.0f * square_5.y - 1.0f;
    var _S437 : bool;
    if(a_7 == 0.0f)
    {
        _S437 = b_7 == 0.0f;
    }
    else
    {
        _S437 = false;
    }
    if(_S437)
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
    var _S438 : f32 = abs(radius_4);
    if(turns_3 < 0.0f)
    {
        radius_4 = turns_3 + 1.0f;
    }
    else
    {
        radius_4 = turns_3;
    }
    return vec2<f32>(_S438, radius_4);
}

fn place_in_aperture_0( blades_5 : u32,  lens_3 : vec2<f32>) -> vec2<f32>
{
    var radius_turns_0 : vec2<f32> = concentric_0(lens_3);
    var radius_5 : f32 = radius_turns_0.x;
    if(blades_5 == u32(0))
    {
        var sin_cos_3 : vec2<f32> = sincos_turns_0(radius_turns_0.y);
        return vec2<f32>(radius_5 * sin_cos_3.y, radius_5 * sin_cos_3.x);
    }
    var count_8 : f32 = f32(blades_5);
    var scaled_0 : f32 = radius_turns_0.y * count_8;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_5 - u32(1)));
    var share_8 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_8));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_8));
    var _S439 : f32 = from_0.y;
    var _S440 : f32 = from_0.x;
    return vec2<f32>(_S439 + (to_0.y - _S439) * share_8, _S440 + (to_0.x - _S440) * share_8) * vec2<f32>(radius_5);
}

fn ThinLens_ray_0( this_54 : ThinLens_0,  position_3 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var place_11 : vec2<f32> = place_in_aperture_0(this_54.blades_3, lens_4);
    var offset_1 : vec3<f32> = this_54.lens_x_3 * vec3<f32>(place_11.x) + this_54.lens_y_3 * vec3<f32>(place_11.y);
    return ray_from_0(this_54.perspective_0.eye_4 + offset_1, normalize_vector_0(this_54.perspective_0.corner_4 + this_54.perspective_0.pixel_x_3 * vec3<f32>(position_3.x) + this_54.perspective_0.pixel_y_3 * vec3<f32>(position_3.y) - offset_1));
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
    var _S441 : Orthographic_0;
    _S441.corner_6 = corner_7;
    _S441.pixel_x_5 = pixel_x_6;
    _S441.pixel_y_5 = pixel_y_6;
    _S441.forward_2 = forward_3;
    return _S441;
}

fn Orthographic_ray_0( this_55 : Orthographic_0,  position_4 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_55.corner_6 + this_55.pixel_x_5 * vec3<f32>(position_4.x) + this_55.pixel_y_5 * vec3<f32>(position_4.y), this_55.forward_2);
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
    var _S442 : Panorama_0;
    _S442.eye_6 = eye_7;
    _S442.axes_1 = axes_2;
    _S442.inverse_size_0 = inverse_size_1;
    _S442.half_eye_distance_0 = half_eye_distance_1;
    return _S442;
}

fn Panorama_ray_0( this_56 : Panorama_0,  position_5 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_5.y * this_56.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_4 : f32;
    if(is_right_eye_0)
    {
        side_4 = this_56.half_eye_distance_0;
    }
    else
    {
        side_4 = - this_56.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_5.x * this_56.inverse_size_0.x);
    var height_2 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S443 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S444 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_56.eye_6 + (this_56.axes_1.forward_0 * _S444 - this_56.axes_1.right_4 * _S443) * vec3<f32>(side_4), normalize_vector_0((vec3<f32>(0) - this_56.axes_1.forward_0 * _S443 + this_56.axes_1.right_4 * _S444) * vec3<f32>(height_2.x) + this_56.axes_1.up_0 * vec3<f32>(height_2.y)));
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
    var _S445 : Fisheye_0;
    _S445.eye_8 = eye_9;
    _S445.axes_3 = axes_4;
    _S445.middle_1 = middle_2;
    _S445.turns_per_pixel_0 = turns_per_pixel_1;
    return _S445;
}

fn Fisheye_ray_0( this_57 : Fisheye_0,  position_6 : vec2<f32>,  lens_7 : vec2<f32>) -> Ray_0
{
    var x_12 : f32 = position_6.x - this_57.middle_1.x;
    var y_7 : f32 = position_6.y - this_57.middle_1.y;
    var radius_6 : f32 = square_root_0(x_12 * x_12 + y_7 * y_7);
    var sin_cos_4 : vec2<f32> = sincos_turns_0(min(radius_6 * this_57.turns_per_pixel_0, 1.0f));
    var scale_0 : f32;
    if(radius_6 > 0.0f)
    {
        scale_0 = divide_0(sin_cos_4.x, radius_6);
    }
    else
    {
        scale_0 = 0.0f;
    }
    return ray_from_0(this_57.eye_8, normalize_vector_0(this_57.axes_3.forward_0 * vec3<f32>(sin_cos_4.y) + this_57.axes_3.right_4 * vec3<f32>((x_12 * scale_0)) - this_57.axes_3.up_0 * vec3<f32>((y_7 * scale_0))));
}

fn Perspective_ray_0( this_58 : Perspective_0,  position_7 : vec2<f32>,  lens_8 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_58.eye_4, normalize_vector_0(this_58.corner_4 + this_58.pixel_x_3 * vec3<f32>(position_7.x) + this_58.pixel_y_3 * vec3<f32>(position_7.y)));
}

fn CameraFrame_ray_0( this_59 : CameraFrame_0,  position_8 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_59.eye_2, this_59.corner_2, this_59.pixel_x_1, this_59.pixel_y_1);
    var axes_5 : Axes_0 = Axes_x24init_0(this_59.corner_2, this_59.pixel_x_1, this_59.pixel_y_1);
    switch(this_59.lens_1)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_59.lens_x_1, this_59.lens_y_1, this_59.blades_1), position_8, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_59.corner_2, this_59.pixel_x_1, this_59.pixel_y_1, this_59.lens_x_1), position_8, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_59.eye_2, axes_5, this_59.lens_x_1.xy, this_59.lens_x_1.z), position_8, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_59.eye_2, axes_5, this_59.lens_x_1.xy, this_59.lens_x_1.z), position_8, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_8, lens_sample_0);
        }
    }
}

fn camera_ray_2( pixel_3 : vec2<u32>,  camera_0 : CameraFrame_0,  sampler_9 : Sampler_0) -> Ray_0
{
    var jitter_0 : vec4<f32> = PathTracingOf_jitter_0(sampler_9);
    return CameraFrame_ray_0(camera_0, vec2<f32>(pixel_3) + jitter_0.xy, jitter_0.zw);
}

fn Item_asks_cache_0( this_60 : Item_0) -> bool
{
    var _S446 : bool;
    if(Item_is_cell_0(this_60))
    {
        _S446 = true;
    }
    else
    {
        if((this_60.kind_2) == u32(1))
        {
            _S446 = has_0(u32(1));
        }
        else
        {
            _S446 = false;
        }
    }
    return _S446;
}

fn at_camera_0( ray_29 : Ray_0,  sampler_10 : Sampler_0,  asks_cache_2 : bool) -> Walker_0
{
    var _S447 : vec3<f32> = vec3<f32>(0.0f);
    return Walker_x24init_0(path_from_0(sampler_10), ray_29, false, _S447, _S447, _S447, in_air_0(), u32(0), true, true, ray_29, 0.0f, false, asks_cache_2, u32(10), false, false, false, false);
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(LENS_0, params_0.eye_1, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0, params_0.lens_x_0, params_0.lens_y_0, params_0.blades_0);
}

fn Item_start_0( this_61 : Item_0) -> Walker_0
{
    if(Item_is_cell_0(this_61))
    {
        var rank_7 : u32;
        var key_4 : Key_0 = Item_key_0(this_61, &(rank_7));
        var _S448 : Walker_0 = at_cell_0(key_4, rank_7, this_61.sampler_3);
        return _S448;
    }
    var _S449 : CameraFrame_0 = FrameParams_camera_0();
    var camera_1 : CameraFrame_0;
    if((this_61.kind_2) == u32(3))
    {
        camera_1 = camera_before_0();
    }
    else
    {
        camera_1 = _S449;
    }
    return at_camera_0(camera_ray_2(this_61.at_12, camera_1, this_61.sampler_3), this_61.sampler_3, Item_asks_cache_0(this_61));
}

fn packed_normal_0( normal_12 : vec3<f32>) -> u32
{
    var _S450 : vec3<i32> = vec3<i32>(normal_steps_0(normal_12));
    return (((((u32(_S450.x) & (u32(1023)))) | (((((u32(_S450.y) & (u32(1023)))) << (u32(10))))))) | (((((u32(_S450.z) & (u32(1023)))) << (u32(20))))));
}

fn set_scratch_row_0( row_13 : u32,  index_32 : u32,  value_3 : vec2<u32>)
{
    scratch_0[row_13 * real_time_0.slots_0 + index_32] = value_3;
    return;
}

fn store_sample_0( index_33 : u32,  sample_16 : Sample_0)
{
    var _S451 : u32 = packed_normal_0(sample_16.normal_4);
    var _S452 : u32;
    if(sample_16.is_shown_0)
    {
        _S452 = u32(1073741824);
    }
    else
    {
        _S452 = u32(0);
    }
    var normal_13 : u32 = (_S451 | (_S452));
    set_scratch_row_0(u32(0), index_33, (bitcast<vec2<u32>>((sample_16.light_6.xy))));
    set_scratch_row_0(u32(1), index_33, vec2<u32>((bitcast<u32>((sample_16.light_6.z))), sample_16.instance_8));
    set_scratch_row_0(u32(2), index_33, (bitcast<vec2<u32>>((sample_16.direct_0.xy))));
    set_scratch_row_0(u32(3), index_33, (bitcast<vec2<u32>>((vec2<f32>(sample_16.direct_0.z, sample_16.place_3.x)))));
    set_scratch_row_0(u32(4), index_33, (bitcast<vec2<u32>>((sample_16.place_3.yz))));
    set_scratch_row_0(u32(5), index_33, (bitcast<vec2<u32>>((sample_16.albedo_0.xy))));
    set_scratch_row_0(u32(6), index_33, vec2<u32>((bitcast<u32>((sample_16.albedo_0.z))), normal_13));
    return;
}

fn light_on_0( sample_17 : Sample_0) -> f32
{
    var _S453 : f32;
    if(sample_17.is_shown_0)
    {
        _S453 = luminance_0(sample_17.light_6) / (luminance_0(sample_17.albedo_0) + 0.00300000002607703f);
    }
    else
    {
        _S453 = 0.0f;
    }
    return _S453;
}

fn Item_end_0( this_62 : Item_0,  sample_18 : Sample_0)
{
    if(Item_is_cell_0(this_62))
    {
        set_cell_row_0(u32(3), this_62.place_7, vec4<u32>((bitcast<vec3<u32>>((sample_18.light_6))), u32(1)));
    }
    else
    {
        if((this_62.kind_2) == u32(1))
        {
            store_sample_0(this_62.place_7, sample_18);
        }
        else
        {
            memory_rows_0[this_62.place_7] = vec4<u32>((bitcast<vec3<u32>>((sample_18.place_3))), (bitcast<u32>((light_on_0(sample_18)))));
        }
    }
    return;
}

fn follow_0( item_1 : Item_0,  counts_3 : bool)
{
    weigh_candidates_0((item_1.kind_2) == u32(1), item_1.place_7, counts_3);
    scatter_of_path_0.wants_light_0 = false;
    first_candidates_0 = real_time_0.candidates_0;
    var sample_19 : Sample_0 = no_sample_0();
    var at_18 : Walker_0;
    if(item_1.traces_0)
    {
        var _S454 : Walker_0 = Item_start_0(item_1);
        at_18 = _S454;
    }
    var is_under_way_0 : bool = item_1.traces_0;
    var is_shadow_turn_0 : bool = true;
    for(;;)
    {
        if(is_under_way_0)
        {
        }
        else
        {
            break;
        }
        var is_shadow_turn_1 : bool = !is_shadow_turn_0;
        if((at_18.is_shadow_ray_0) == is_shadow_turn_1)
        {
            var _S455 : bool = goes_on_5(&(at_18), &(sample_19));
            is_under_way_0 = _S455;
        }
        is_shadow_turn_0 = is_shadow_turn_1;
    }
    if(item_1.traces_0)
    {
        Item_end_0(item_1, sample_19);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    first_candidates_0 = u32(1);
    ends_here_0 = false;
    var _S456 : Item_0 = item_of_0(id_0.x);
    follow_0(_S456, true);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_left(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    first_candidates_0 = u32(1);
    ends_here_0 = false;
    var _S457 : u32 = atomicLoad(&(cell_keys_0[u32(13)]));
    var number_5 : u32 = _S457 + id_1.x;
    var _S458 : u32 = atomicLoad(&(cell_keys_0[u32(9)]));
    if(number_5 < _S458)
    {
        var _S459 : Item_0 = item_of_0(rest_0[number_5]);
        follow_0(_S459, false);
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn trace_before(@builtin(global_invocation_id) id_2 : vec3<u32>)
{
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    first_candidates_0 = u32(1);
    ends_here_0 = false;
    var _S460 : Item_0 = item_of_0(real_time_0.cells_0 + threads_that_trace_0() + real_time_0.squares_0 + id_2.x);
    follow_0(_S460, false);
    return;
}

struct Lit_0
{
     paths_0 : f32,
     light_12 : vec3<f32>,
     shaded_0 : vec3<f32>,
     moments_0 : vec3<f32>,
};

fn Lit_x24init_0( paths_1 : f32,  light_13 : vec3<f32>,  shaded_1 : vec3<f32>,  moments_1 : vec3<f32>) -> Lit_0
{
    var _S461 : Lit_0;
    _S461.paths_0 = paths_1;
    _S461.light_12 = light_13;
    _S461.shaded_0 = shaded_1;
    _S461.moments_0 = moments_1;
    return _S461;
}

fn not_lit_0() -> Lit_0
{
    var _S462 : vec3<f32> = vec3<f32>(0.0f);
    return Lit_x24init_0(0.0f, _S462, _S462, _S462);
}

struct Memory_0
{
     lit_0 : Lit_0,
     looks_0 : f32,
     direct_2 : vec3<f32>,
     albedo_2 : vec3<f32>,
     normal_14 : vec3<f32>,
     place_12 : vec3<f32>,
     roughness_1 : f32,
     coverage_0 : f32,
     shown_0 : u32,
     is_at_rest_0 : bool,
};

fn Memory_x24init_0( lit_1 : Lit_0,  looks_1 : f32,  direct_3 : vec3<f32>,  albedo_3 : vec3<f32>,  normal_15 : vec3<f32>,  place_13 : vec3<f32>,  roughness_2 : f32,  coverage_1 : f32,  shown_1 : u32,  is_at_rest_1 : bool) -> Memory_0
{
    var _S463 : Memory_0;
    _S463.lit_0 = lit_1;
    _S463.looks_0 = looks_1;
    _S463.direct_2 = direct_3;
    _S463.albedo_2 = albedo_3;
    _S463.normal_14 = normal_15;
    _S463.place_12 = place_13;
    _S463.roughness_1 = roughness_2;
    _S463.coverage_0 = coverage_1;
    _S463.shown_0 = shown_1;
    _S463.is_at_rest_0 = is_at_rest_1;
    return _S463;
}

fn nothing_known_0() -> Memory_0
{
    var _S464 : vec3<f32> = vec3<f32>(0.0f);
    return Memory_x24init_0(not_lit_0(), 0.0f, _S464, _S464, _S464, _S464, 0.0f, 0.0f, u32(0), false);
}

fn memory_row_0( row_14 : u32,  index_34 : u32) -> vec4<u32>
{
    return memory_rows_0[row_14 * real_time_0.pixels_0 + index_34];
}

fn low_half_0( word_9 : u32) -> f32
{
    return unpack2x16float(word_9).x;
}

fn high_half_0( word_10 : u32) -> f32
{
    return unpack2x16float(word_10).y;
}

fn Lit_products_0( this_63 : Lit_0,  kept_0 : vec3<f32>) -> vec3<f32>
{
    var l_0 : f32 = luminance_0(this_63.light_12);
    var a_8 : f32 = luminance_0(kept_0);
    return vec3<f32>(l_0 * l_0, l_0 * a_8, a_8 * a_8);
}

fn lit_of_0( paths_2 : f32,  light_14 : vec3<f32>,  words_3 : vec3<u32>) -> Lit_0
{
    var _S465 : u32 = words_3.x;
    var _S466 : u32 = words_3.y;
    var _S467 : Lit_0 = Lit_x24init_0(paths_2, light_14, vec3<f32>(low_half_0(_S465), high_half_0(_S465), low_half_0(_S466)), vec3<f32>(0.0f));
    var lit_2 : Lit_0 = _S467;
    var _S468 : u32 = words_3.z;
    lit_2.moments_0 = Lit_products_0(_S467, lit_2.shaded_0) * (vec3<f32>(1.0f) + vec3<f32>(high_half_0(_S466), low_half_0(_S468), high_half_0(_S468)));
    return lit_2;
}

fn load_lit_0( index_35 : u32) -> Lit_0
{
    var shaded_2 : vec4<u32> = memory_row_0(u32(1), index_35);
    var light_15 : vec4<u32> = memory_row_0(u32(2), index_35);
    return lit_of_0(low_half_0(shaded_2.x), (bitcast<vec3<f32>>((light_15.xyz))), vec3<u32>(shaded_2.z, shaded_2.w, light_15.w));
}

fn normal_in_0( word_11 : u32) -> vec3<f32>
{
    return vec3<f32>(vec3<i32>((i32((word_11 << (u32(22)))) >> (u32(22))), (i32((word_11 << (u32(12)))) >> (u32(22))), (i32((word_11 << (u32(2)))) >> (u32(22))))) * vec3<f32>(0.00195694714784622f);
}

fn load_memory_0( index_36 : u32) -> Memory_0
{
    var surface_6 : vec4<u32> = memory_row_0(u32(0), index_36);
    var shaded_3 : vec4<u32> = memory_row_0(u32(1), index_36);
    var seen_0 : vec4<u32> = memory_row_0(u32(3), index_36);
    var memory_0 : Memory_0;
    memory_0.lit_0 = load_lit_0(index_36);
    memory_0.looks_0 = high_half_0(shaded_3.x);
    var _S469 : u32 = seen_0.x;
    var _S470 : u32 = seen_0.y;
    memory_0.direct_2 = vec3<f32>(low_half_0(_S469), high_half_0(_S469), low_half_0(_S470));
    var _S471 : u32 = seen_0.z;
    memory_0.albedo_2 = vec3<f32>(high_half_0(_S470), low_half_0(_S471), high_half_0(_S471));
    var _S472 : u32 = surface_6.w;
    memory_0.normal_14 = normal_in_0(_S472);
    memory_0.place_12 = (bitcast<vec3<f32>>((surface_6.xyz)));
    var _S473 : u32 = shaded_3.y;
    memory_0.roughness_1 = high_half_0(_S473);
    memory_0.coverage_0 = low_half_0(_S473);
    memory_0.shown_0 = seen_0.w;
    memory_0.is_at_rest_0 = ((_S472 & (u32(2147483648)))) != u32(0);
    return memory_0;
}

fn Memory_look_anew_0( this_64 : ptr<function, Memory_0>)
{
    (*this_64).looks_0 = 0.0f;
    (*this_64).coverage_0 = 0.0f;
    (*this_64).roughness_1 = 0.0f;
    (*this_64).is_at_rest_0 = false;
    return;
}

fn scratch_row_0( row_15 : u32,  index_37 : u32) -> vec2<u32>
{
    return scratch_0[row_15 * real_time_0.slots_0 + index_37];
}

fn load_known_0( index_38 : u32) -> Lit_0
{
    var light_16 : vec2<u32> = scratch_row_0(u32(7), index_38);
    var _S474 : u32 = light_16.y;
    var _S475 : u32 = light_16.x;
    return lit_of_0(high_half_0(_S474), vec3<f32>(low_half_0(_S475), high_half_0(_S475), low_half_0(_S474)), vec3<u32>(scratch_row_0(u32(8), index_38), scratch_row_0(u32(9), index_38).x));
}

fn memory_before_0( index_39 : u32) -> Memory_0
{
    var memory_1 : Memory_0 = nothing_known_0();
    if(!has_0(u32(4)))
    {
        return memory_1;
    }
    if(has_0(u32(16)))
    {
        memory_1 = load_memory_0(index_39);
        if(!has_0(u32(8)))
        {
            Memory_look_anew_0(&(memory_1));
        }
        return memory_1;
    }
    memory_1.lit_0 = load_known_0(index_39);
    if((memory_1.lit_0.paths_0) == -1.0f)
    {
        return load_memory_0(index_39);
    }
    memory_1.shown_0 = scratch_row_0(u32(9), index_39).y;
    return memory_1;
}

fn load_sample_0( index_40 : u32) -> Sample_0
{
    var b_8 : vec2<u32> = scratch_row_0(u32(1), index_40);
    var d_3 : vec2<f32> = (bitcast<vec2<f32>>((scratch_row_0(u32(3), index_40))));
    var g_0 : vec2<u32> = scratch_row_0(u32(6), index_40);
    var sample_20 : Sample_0;
    sample_20.light_6 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(0), index_40)))), (bitcast<f32>((b_8.x))));
    sample_20.instance_8 = b_8.y;
    sample_20.direct_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(2), index_40)))), d_3.x);
    sample_20.place_3 = vec3<f32>(d_3.y, (bitcast<vec2<f32>>((scratch_row_0(u32(4), index_40)))));
    sample_20.albedo_0 = vec3<f32>((bitcast<vec2<f32>>((scratch_row_0(u32(5), index_40)))), (bitcast<f32>((g_0.x))));
    var _S476 : u32 = g_0.y;
    sample_20.normal_4 = normal_in_0(_S476);
    sample_20.is_shown_0 = ((_S476 & (u32(1073741824)))) != u32(0);
    return sample_20;
}

fn Memory_look_0( this_65 : ptr<function, Memory_0>,  sample_21 : Sample_0)
{
    var _S477 : f32 = (*this_65).looks_0 + 1.0f;
    (*this_65).looks_0 = _S477;
    var share_9 : f32 = 1.0f / _S477;
    var _S478 : vec3<f32> = vec3<f32>(share_9);
    (*this_65).direct_2 = (*this_65).direct_2 + (sample_21.direct_0 - (*this_65).direct_2) * _S478;
    (*this_65).albedo_2 = (*this_65).albedo_2 + (sample_21.albedo_0 - (*this_65).albedo_2) * _S478;
    if(!sample_21.is_shown_0)
    {
        (*this_65).coverage_0 = (*this_65).coverage_0 - (*this_65).coverage_0 * share_9;
        return;
    }
    var covered_0 : f32 = (*this_65).coverage_0 * ((*this_65).looks_0 - 1.0f) + 1.0f;
    (*this_65).coverage_0 = covered_0 * share_9;
    var of_covered_0 : f32 = 1.0f / covered_0;
    var before_0 : vec3<f32> = (*this_65).place_12;
    var _S479 : vec3<f32> = vec3<f32>(of_covered_0);
    (*this_65).normal_14 = in_ten_bits_0((*this_65).normal_14 + (sample_21.normal_4 - (*this_65).normal_14) * _S479);
    (*this_65).place_12 = (*this_65).place_12 + (sample_21.place_3 - (*this_65).place_12) * _S479;
    if(covered_0 > 1.0f)
    {
        var along_1 : f32 = dot_product_0((*this_65).normal_14, sample_21.place_3 - before_0);
        (*this_65).roughness_1 = (*this_65).roughness_1 + (along_1 * along_1 / max(length_squared_0((*this_65).normal_14), 9.99999997475242708e-07f) * (1.0f - of_covered_0) - (*this_65).roughness_1) * of_covered_0;
    }
    return;
}

fn Lit_add_0( this_66 : ptr<function, Lit_0>,  found_3 : vec3<f32>,  albedo_4 : vec3<f32>,  most_0 : f32)
{
    var _S480 : f32 = min((*this_66).paths_0 + 1.0f, most_0);
    (*this_66).paths_0 = _S480;
    var l_1 : f32 = luminance_0(found_3);
    var a_9 : f32 = luminance_0(albedo_4);
    var _S481 : vec3<f32> = vec3<f32>((1.0f / _S480));
    (*this_66).light_12 = (*this_66).light_12 + (found_3 - (*this_66).light_12) * _S481;
    (*this_66).shaded_0 = (*this_66).shaded_0 + (albedo_4 - (*this_66).shaded_0) * _S481;
    (*this_66).moments_0 = (*this_66).moments_0 + (vec3<f32>(l_1 * l_1, l_1 * a_9, a_9 * a_9) - (*this_66).moments_0) * _S481;
    return;
}

fn Memory_add_0( this_67 : ptr<function, Memory_0>,  sample_22 : Sample_0,  most_1 : f32)
{
    Memory_look_0(&((*this_67)), sample_22);
    var _S482 : Lit_0 = (*this_67).lit_0;
    Lit_add_0(&(_S482), sample_22.light_6, sample_22.albedo_0, most_1);
    (*this_67).lit_0 = _S482;
    return;
}

fn shows_mover_0( sample_23 : Sample_0) -> bool
{
    var _S483 : bool;
    if((real_time_0.motions_0) != u32(0))
    {
        if((sample_23.instance_8) == u32(4294967295))
        {
            _S483 = true;
        }
        else
        {
            _S483 = is_mover_0(sample_23.instance_8);
        }
    }
    else
    {
        _S483 = false;
    }
    return _S483;
}

fn shifted_0( numbers_0 : vec4<f32>,  by_0 : u32) -> vec4<f32>
{
    return unit_float_0((((vec4<u32>(numbers_0 * vec4<f32>(1.6777216e+07f)) << (vec4<u32>(u32(8))))) ^ ((scrambled_sobol_0(by_0, u32(0), vec2<u32>(vec2<i32>(i32(0)))).xyyx))));
}

fn looking_ray_0( pixel_4 : vec2<u32>,  number_6 : u32) -> Ray_0
{
    var jitter_1 : vec4<f32> = shifted_0(PathTracingOf_jitter_0(Sampler_x24init_0(((params_0.seed_0) ^ (u32(2654435769))), index_of_0(pixel_4), real_time_0.number_0)), number_6);
    return CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(pixel_4) + jitter_1.xy, jitter_1.zw);
}

fn is_far_5( a_10 : vec3<f32>,  b_9 : vec3<f32>) -> bool
{
    return (any(((abs(a_10 - b_9)) > (max(a_10, b_9) * vec3<f32>(0.10000000149011612f) + vec3<f32>(0.00999999977648258f)))));
}

fn differ_0( a_11 : Sample_0,  b_10 : Sample_0) -> bool
{
    var _S484 : bool;
    if((a_11.is_shown_0) != (b_10.is_shown_0))
    {
        _S484 = true;
    }
    else
    {
        _S484 = is_far_5(a_11.direct_0, b_10.direct_0);
    }
    if(_S484)
    {
        _S484 = true;
    }
    else
    {
        _S484 = is_far_5(a_11.albedo_0, b_10.albedo_0);
    }
    return _S484;
}

fn halves_1( low_15 : f32,  high_6 : f32) -> u32
{
    return pack2x16float(clamp(vec2<f32>(low_15, high_6), vec2<f32>(-65504.0f), vec2<f32>(65504.0f)));
}

fn Lit_beyond_0( this_68 : Lit_0,  kept_1 : vec3<f32>) -> vec3<f32>
{
    var products_0 : vec3<f32> = Lit_products_0(this_68, kept_1);
    var _S485 : vec3<f32> = vec3<f32>(1.00000000317107685e-30f);
    return select(vec3<f32>(0.0f), min(this_68.moments_0 / max(products_0, _S485), vec3<f32>(60000.0f)) - vec3<f32>(1.0f), products_0 > _S485);
}

fn words_of_0( lit_3 : Lit_0) -> vec3<u32>
{
    var first_0 : u32 = halves_1(lit_3.shaded_0.x, lit_3.shaded_0.y);
    var last_7 : f32 = low_half_0(halves_1(lit_3.shaded_0.z, 0.0f));
    var beyond_13 : vec3<f32> = Lit_beyond_0(lit_3, vec3<f32>(low_half_0(first_0), high_half_0(first_0), last_7));
    return vec3<u32>(first_0, halves_1(last_7, beyond_13.x), halves_1(beyond_13.y, beyond_13.z));
}

fn store_memory_0( index_41 : u32,  memory_2 : Memory_0)
{
    var pixels_2 : u32 = real_time_0.pixels_0;
    var words_4 : vec3<u32> = words_of_0(memory_2.lit_0);
    var _S486 : u32 = packed_normal_0(memory_2.normal_14);
    var _S487 : u32;
    if((memory_2.coverage_0) > 0.0f)
    {
        _S487 = u32(1073741824);
    }
    else
    {
        _S487 = u32(0);
    }
    var _S488 : u32 = (_S486 | (_S487));
    if(memory_2.is_at_rest_0)
    {
        _S487 = u32(2147483648);
    }
    else
    {
        _S487 = u32(0);
    }
    memory_rows_0[index_41] = vec4<u32>((bitcast<vec3<u32>>((memory_2.place_12))), (_S488 | (_S487)));
    memory_rows_0[pixels_2 + index_41] = vec4<u32>(halves_1(memory_2.lit_0.paths_0, memory_2.looks_0), halves_1(memory_2.coverage_0, memory_2.roughness_1), words_4.x, words_4.y);
    memory_rows_0[u32(2) * pixels_2 + index_41] = vec4<u32>((bitcast<vec3<u32>>((memory_2.lit_0.light_12))), words_4.z);
    memory_rows_0[u32(3) * pixels_2 + index_41] = vec4<u32>(halves_1(memory_2.direct_2.x, memory_2.direct_2.y), halves_1(memory_2.direct_2.z, memory_2.albedo_2.x), halves_1(memory_2.albedo_2.y, memory_2.albedo_2.z), memory_2.shown_0);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn remember(@builtin(global_invocation_id) id_3 : vec3<u32>)
{
    weighs_candidates_0 = false;
    counts_arrivals_0 = false;
    first_candidates_0 = u32(1);
    ends_here_0 = false;
    var at_19 : vec2<u32> = pixel_that_traces_0(id_3.x);
    if(is_inside_0(vec2<i32>(at_19)))
    {
        var index_42 : u32 = index_of_0(at_19);
        var memory_3 : Memory_0 = memory_before_0(index_42);
        var sample_24 : Sample_0 = load_sample_0(index_42);
        var is_at_rest_2 : bool;
        if(memory_3.is_at_rest_0)
        {
            is_at_rest_2 = true;
        }
        else
        {
            is_at_rest_2 = (memory_3.looks_0) == 0.0f;
        }
        var _S489 : f32;
        if(memory_3.is_at_rest_0)
        {
            _S489 = max(real_time_0.most_paths_0, 256.0f);
        }
        else
        {
            _S489 = real_time_0.most_paths_0;
        }
        Memory_add_0(&(memory_3), sample_24, _S489);
        if(is_at_rest_2)
        {
            is_at_rest_2 = !shows_mover_0(sample_24);
        }
        else
        {
            is_at_rest_2 = false;
        }
        memory_3.is_at_rest_0 = is_at_rest_2;
        var is_in_motion_0 : bool;
        if(has_0(u32(4)))
        {
            is_in_motion_0 = !has_0(u32(16));
        }
        else
        {
            is_in_motion_0 = false;
        }
        if(is_in_motion_0)
        {
            _S489 = 4.0f;
        }
        else
        {
            _S489 = 16.0f;
        }
        var look_0 : Walker_0;
        var _S490 : Sample_0 = no_sample_0();
        var seen_1 : Sample_0 = _S490;
        var is_under_way_1 : bool = false;
        var differs_0 : bool = false;
        var looks_2 : u32 = u32(0);
        for(;;)
        {
            if(is_under_way_1)
            {
                is_at_rest_2 = true;
            }
            else
            {
                if(has_0(u32(2)))
                {
                    var _S491 : f32 = memory_3.looks_0;
                    var _S492 : f32;
                    if(differs_0)
                    {
                        _S492 = _S489;
                    }
                    else
                    {
                        _S492 = 4.0f;
                    }
                    is_at_rest_2 = _S491 < _S492;
                }
                else
                {
                    is_at_rest_2 = false;
                }
            }
            if(is_at_rest_2)
            {
            }
            else
            {
                break;
            }
            if(!is_under_way_1)
            {
                var looks_3 : u32 = looks_2 + u32(1);
                look_0 = at_camera_0(looking_ray_0(at_19, looks_3), Sampler_x24init_0(((params_0.seed_0) ^ (u32(2246822507))), index_42, u32(16) * real_time_0.number_0 + looks_3), false);
                seen_1 = _S490;
                looks_2 = looks_3;
            }
            var is_under_way_2 : bool = goes_on_4(&(look_0), &(seen_1));
            if(!is_under_way_2)
            {
                if(differs_0)
                {
                    is_in_motion_0 = true;
                }
                else
                {
                    is_in_motion_0 = differ_0(seen_1, sample_24);
                }
                Memory_look_0(&(memory_3), seen_1);
                var _S493 : bool;
                if(memory_3.is_at_rest_0)
                {
                    _S493 = !shows_mover_0(seen_1);
                }
                else
                {
                    _S493 = false;
                }
                memory_3.is_at_rest_0 = _S493;
                differs_0 = is_in_motion_0;
            }
            is_under_way_1 = is_under_way_2;
        }
        store_memory_0(index_42, memory_3);
    }
    return;
}

