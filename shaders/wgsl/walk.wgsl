struct Dispatch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) count_0 : u32,
    @align(8) samples_0 : u32,
    @align(4) samples_target_0 : u32,
    @align(16) sequence_0 : u32,
    @align(4) is_layers_0 : u32,
    @align(8) padding_0 : vec2<u32>,
};

@binding(17) @group(0) var<uniform> dispatch_0 : Dispatch_std140_0;
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
    @align(4) samples_1 : u32,
    @align(4) covered_0 : u32,
};

@binding(10) @group(0) var<storage, read_write> pixels_0 : array<PixelRecord_std430_0>;

@binding(16) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

struct HitRecord_std430_0
{
    @align(4) t_0 : f32,
    @align(4) instance_0 : u32,
    @align(4) voxel_0 : array<i32, i32(3)>,
    @align(4) face_0 : u32,
};

@binding(13) @group(0) var<storage, read_write> hits_0 : array<HitRecord_std430_0>;

struct RayRecord_std430_0
{
    @align(4) origin_0 : array<f32, i32(3)>,
    @align(4) t_min_0 : f32,
    @align(4) direction_0 : array<f32, i32(3)>,
    @align(4) t_max_0 : f32,
};

@binding(12) @group(0) var<storage, read> rays_0 : array<RayRecord_std430_0>;

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

struct Ray_0
{
     origin_2 : vec3<f32>,
     t_min_1 : f32,
     direction_1 : vec3<f32>,
     t_max_1 : f32,
};

struct Hit_0
{
     t_1 : f32,
     instance_1 : u32,
     voxel_1 : vec3<i32>,
     face_1 : u32,
};

fn Hit_is_miss_0( this_0 : Hit_0) -> bool
{
    return (this_0.instance_1) == u32(4294967295);
}

fn sky_gradient_0( direction_2 : vec3<f32>) -> vec3<f32>
{
    return (params_0.sky_nadir_0 + (params_0.sky_zenith_0 - params_0.sky_nadir_0) * vec3<f32>((0.5f * (direction_2.z + 1.0f)))) * vec3<f32>(params_0.sky_brightness_0);
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

fn cell_of_0( values_0 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

fn find_brick_0( _S1 : u32,  _S2 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S2 >> (vec3<u32>(grids_0[_S1].top_shift_0)));
    var cell_1 : u32 = cells_0[grids_0[_S1].top_offset_0 + u32((top_0.z * grids_0[_S1].top_size_0[i32(1)] + top_0.y) * grids_0[_S1].top_size_0[i32(0)] + top_0.x)];
    var shift_1 : u32 = grids_0[_S1].top_shift_0;
    for(;;)
    {
        var _S3 : bool;
        if(shift_1 > u32(3))
        {
            _S3 = ((cell_1 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S3 = false;
        }
        if(_S3)
        {
        }
        else
        {
            break;
        }
        var shift_2 : u32 = shift_1 - u32(2);
        cell_1 = cells_0[((cell_1 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S2, shift_2)];
        shift_1 = shift_2;
    }
    return ((cell_1 & (u32(2147483647)))) * u32(2);
}

fn read_bits_0( start_0 : u32,  position_0 : u32,  count_1 : u32) -> u32
{
    if(count_1 == u32(0))
    {
        return u32(0);
    }
    var word_0 : u32 = start_0 + ((position_0 >> (u32(5))));
    var shift_3 : u32 = (position_0 & (u32(31)));
    var bits_0 : u32 = (brick_materials_0[word_0] >> (shift_3));
    var bits_1 : u32;
    if((shift_3 + count_1) > u32(32))
    {
        bits_1 = (bits_0 | (((brick_materials_0[word_0 + u32(1)] << ((u32(32) - shift_3))))));
    }
    else
    {
        bits_1 = bits_0;
    }
    return (bits_1 & ((((u32(1) << (count_1))) - u32(1))));
}

fn material_at_0( _S4 : u32,  _S5 : vec3<i32>) -> u32
{
    var _S6 : u32 = find_brick_0(_S4, _S5);
    var header_0 : u32 = bricks_0[_S6];
    var bit_0 : u32 = cell_in_node_0(_S5, u32(0));
    var present_before_0 : u32 = countOneBits((header_0 & ((((u32(1) << (((((u32(((((_S5.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((_S5.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((_S5.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_1 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_1 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S7 : u32 = u32(2) * index_1;
        var rank_1 : u32 = rank_0 + (countOneBits(bricks_0[_S6 + u32(2) + _S7]) + countOneBits(bricks_0[_S6 + u32(3) + _S7]));
        index_1 = index_1 + u32(1);
        rank_0 = rank_1;
    }
    var _S8 : u32 = u32(2) * present_before_0;
    var low_0 : u32 = bricks_0[_S6 + u32(2) + _S8];
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_0 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_0) + countOneBits((bricks_0[_S6 + u32(3) + _S8] & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S4].material_bits_0;
    var start_1 : u32 = bricks_0[_S6 + u32(1)];
    var index_2 : u32 = read_bits_0(start_1, palette_count_0 * grids_0[_S4].material_bits_0 + rank_0 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_2;
    }
    return read_bits_0(start_1, index_2 * entry_bits_0, entry_bits_0);
}

fn material_of_0( hit_0 : Hit_0) -> PackedMaterial_0
{
    var _S9 : PackedMaterial_std430_0 = materials_0[material_at_0(instances_0[hit_0.instance_1].grid_0, hit_0.voxel_1 - cell_of_0(grids_0[instances_0[hit_0.instance_1].grid_0].origin_1))];
    var _S10 : PackedMaterial_0 = PackedMaterial_0( _S9.base_color_0, _S9.roughness_0, _S9.emission_0, _S9.metallic_0, _S9.transmission_0, _S9.ior_0 );
    return _S10;
}

fn vector_of_0( values_1 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn max_element_0( vector_0 : vec3<f32>) -> f32
{
    return max(max(vector_0.x, vector_0.y), vector_0.z);
}

fn emitted_0( material_0 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_0.emission_0) * vec3<f32>(params_0.light_intensity_0);
}

fn Path_dimension_scatter_0( this_1 : Path_0) -> u32
{
    return u32(1) + u32(2) * this_1.bounce_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S11 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S11;
    v_0[i32(0)] = v_0[i32(0)] + _S11.y * _S11.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S12 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S12;
    v_0[i32(0)] = v_0[i32(0)] + _S12.y * _S12.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn unit_float_0( words_1 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_1 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_independent_0( this_2 : Sampler_0,  dimension_0 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_2.pixel_0, this_2.sample_0, dimension_0, this_2.seed_1)));
}

struct Surface_0
{
     origin_3 : vec3<f32>,
     normal_1 : vec3<f32>,
     face_2 : u32,
     instance_2 : u32,
};

fn Transform_direction_0( _S13 : u32,  _S14 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S13].grid_from_world_0.x_axis_0) * vec3<f32>(_S14.x) + vector_of_0(instances_0[_S13].grid_from_world_0.y_axis_0) * vec3<f32>(_S14.y) + vector_of_0(instances_0[_S13].grid_from_world_0.z_axis_0) * vec3<f32>(_S14.z);
}

fn Transform_point_0( _S15 : u32,  _S16 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S15, _S16) + vector_of_0(instances_0[_S15].grid_from_world_0.translation_0);
}

fn point_off_face_0( _S17 : u32,  _S18 : vec3<f32>,  _S19 : u32,  _S20 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = clamp((max_element_0(abs(_S18) + abs(vector_of_0(instances_0[_S17].grid_from_world_0.translation_0))) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
    var _S21 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(_S20, _S18 + _S21), _S18 + vec3<f32>((1.0f - margin_0)));
    var _S22 : bool = _S19 < u32(2);
    var _S23 : bool;
    if(_S19 >= u32(2))
    {
        _S23 = _S19 < u32(4);
    }
    else
    {
        _S23 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S22, _S23, _S19 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((_S19 & (u32(1)))) == u32(1))
    {
        outside_0 = _S18 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = _S18 - _S21;
    }
    return select(moved_0, outside_0, is_axis_0);
}

fn Transform_direction_1( _S24 : u32,  _S25 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S24].world_from_grid_0.x_axis_0) * vec3<f32>(_S25.x) + vector_of_0(instances_0[_S24].world_from_grid_0.y_axis_0) * vec3<f32>(_S25.y) + vector_of_0(instances_0[_S24].world_from_grid_0.z_axis_0) * vec3<f32>(_S25.z);
}

fn Transform_point_1( _S26 : u32,  _S27 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S26, _S27) + vector_of_0(instances_0[_S26].world_from_grid_0.translation_0);
}

fn face_normal_0( face_3 : u32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_3 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = -1.0f;
    }
    var _S28 : f32;
    if(face_3 < u32(2))
    {
        _S28 = away_0;
    }
    else
    {
        _S28 = 0.0f;
    }
    var _S29 : bool;
    if(face_3 >= u32(2))
    {
        _S29 = face_3 < u32(4);
    }
    else
    {
        _S29 = false;
    }
    var _S30 : f32;
    if(_S29)
    {
        _S30 = away_0;
    }
    else
    {
        _S30 = 0.0f;
    }
    if(face_3 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S28, _S30, away_0);
}

fn dot_product_0( a_0 : vec3<f32>,  b_0 : vec3<f32>) -> f32
{
    return a_0.x * b_0.x + a_0.y * b_0.y + a_0.z * b_0.z;
}

fn length_squared_0( vector_1 : vec3<f32>) -> f32
{
    return dot_product_0(vector_1, vector_1);
}

fn normalize_vector_0( vector_2 : vec3<f32>) -> vec3<f32>
{
    return vector_2 * vec3<f32>((1.0f / sqrt(length_squared_0(vector_2))));
}

fn world_normal_0( _S31 : u32,  _S32 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S31, face_normal_0(_S32)));
}

fn surface_of_0( ray_0 : Ray_0,  hit_1 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.origin_3 = Transform_point_1(hit_1.instance_1, point_off_face_0(hit_1.instance_1, vec3<f32>(hit_1.voxel_1), hit_1.face_1, Transform_point_0(hit_1.instance_1, ray_0.origin_2) + Transform_direction_0(hit_1.instance_1, ray_0.direction_1) * vec3<f32>(hit_1.t_1)));
    surface_0.normal_1 = world_normal_0(hit_1.instance_1, hit_1.face_1);
    surface_0.face_2 = hit_1.face_1;
    surface_0.instance_2 = hit_1.instance_1;
    return surface_0;
}

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

fn cosine_hemisphere_0( u_0 : f32,  v_1 : f32) -> vec3<f32>
{
    var radius_0 : f32 = sqrt(u_0);
    var sin_cos_0 : vec2<f32> = sincos_turns_0(v_1);
    return vec3<f32>(radius_0 * sin_cos_0.y, radius_0 * sin_cos_0.x, sqrt(1.0f - u_0));
}

fn Surface_world_direction_0( this_3 : Surface_0,  local_0 : vec3<f32>) -> vec3<f32>
{
    var away_1 : f32;
    if((((this_3.face_2) & (u32(1)))) == u32(1))
    {
        away_1 = local_0.z;
    }
    else
    {
        away_1 = - local_0.z;
    }
    var _S33 : f32 = local_0.x;
    var _S34 : f32 = local_0.y;
    var _S35 : vec3<f32> = vec3<f32>(_S33, _S34, away_1);
    var in_grid_0 : vec3<f32>;
    if((this_3.face_2) < u32(2))
    {
        in_grid_0 = vec3<f32>(away_1, _S33, _S34);
    }
    else
    {
        if((this_3.face_2) < u32(4))
        {
            in_grid_0 = vec3<f32>(_S34, away_1, _S33);
        }
        else
        {
            in_grid_0 = _S35;
        }
    }
    return normalize_vector_0(Transform_direction_1(this_3.instance_2, in_grid_0));
}

fn Ray_x24init_0( origin_4 : vec3<f32>,  t_min_2 : f32,  direction_3 : vec3<f32>,  t_max_2 : f32) -> Ray_0
{
    var _S36 : Ray_0;
    _S36.origin_2 = origin_4;
    _S36.t_min_1 = t_min_2;
    _S36.direction_1 = direction_3;
    _S36.t_max_1 = t_max_2;
    return _S36;
}

fn ray_from_0( origin_5 : vec3<f32>,  direction_4 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_5, 0.0f, direction_4, (bitcast<f32>((u32(2139095040)))));
}

fn Essay_clip_0( ray_1 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_1.origin_2, 0.10000000149011612f, ray_1.direction_1, 10000.0f);
}

fn Essay_advance_0( path_0 : ptr<function, Path_0>,  ray_2 : Ray_0,  hit_2 : Hit_0,  radiance_1 : ptr<function, vec3<f32>>,  next_0 : ptr<function, Ray_0>,  shadow_rays_0 : ptr<function, u32>) -> bool
{
    (*next_0) = ray_2;
    if(Hit_is_miss_0(hit_2))
    {
        (*radiance_1) = (*radiance_1) + (*path_0).beta_0 * sky_gradient_0(ray_2.direction_1);
        return false;
    }
    var material_1 : PackedMaterial_0 = material_of_0(hit_2);
    if((max_element_0(vector_of_0(material_1.emission_0))) > 0.0f)
    {
        (*radiance_1) = (*radiance_1) + (*path_0).beta_0 * emitted_0(material_1);
        return false;
    }
    if(((*path_0).bounce_0) == (params_0.max_bounces_0))
    {
        return false;
    }
    var u_1 : vec4<f32> = Sampler_independent_0((*path_0).sampler_0, Path_dimension_scatter_0((*path_0)));
    var surface_1 : Surface_0 = surface_of_0(ray_2, hit_2);
    (*path_0).beta_0 = (*path_0).beta_0 * vector_of_0(material_1.base_color_0);
    (*path_0).bounce_0 = (*path_0).bounce_0 + u32(1);
    (*next_0) = Essay_clip_0(ray_from_0(surface_1.origin_3, Surface_world_direction_0(surface_1, cosine_hemisphere_0(u_1.x, u_1.y))));
    return true;
}

@id(0) override IS_EXACT_0 : bool = true;

struct RayCounts_0
{
     camera_0 : u32,
     bounce_1 : u32,
     shadow_0 : u32,
};

struct PixelRecord_0
{
     radiance_0 : array<u32, i32(6)>,
     samples_1 : u32,
     covered_0 : u32,
};

fn RayCounts_x24init_0( camera_1 : u32,  bounce_2 : u32,  shadow_1 : u32) -> RayCounts_0
{
    var _S37 : RayCounts_0;
    _S37.camera_0 = camera_1;
    _S37.bounce_1 = bounce_2;
    _S37.shadow_0 = shadow_1;
    return _S37;
}

fn Sampler_x24init_0( seed_2 : u32,  pixel_1 : u32,  sample_1 : u32) -> Sampler_0
{
    var _S38 : Sampler_0;
    _S38.seed_1 = seed_2;
    _S38.pixel_0 = pixel_1;
    _S38.sample_0 = sample_1;
    return _S38;
}

fn Essay_jitter_0( sampler_1 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_1, u32(0));
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
    var _S39 : CameraFrame_0;
    _S39.eye_1 = eye_2;
    _S39.corner_1 = corner_2;
    _S39.pixel_x_1 = pixel_x_2;
    _S39.pixel_y_1 = pixel_y_2;
    return _S39;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0);
}

fn CameraFrame_ray_0( this_4 : CameraFrame_0,  position_1 : vec2<f32>) -> Ray_0
{
    var direction_5 : vec3<f32> = this_4.corner_1 + this_4.pixel_x_1 * vec3<f32>(position_1.x) + this_4.pixel_y_1 * vec3<f32>(position_1.y);
    return ray_from_0(this_4.eye_1, direction_5 * vec3<f32>((1.0f / sqrt(length_squared_0(direction_5)))));
}

fn Path_x24init_0( sampler_2 : Sampler_0,  bounce_3 : u32,  beta_1 : vec3<f32>,  pdf_1 : f32,  normal_2 : vec3<f32>) -> Path_0
{
    var _S40 : Path_0;
    _S40.sampler_0 = sampler_2;
    _S40.bounce_0 = bounce_3;
    _S40.beta_0 = beta_1;
    _S40.pdf_0 = pdf_1;
    _S40.normal_0 = normal_2;
    return _S40;
}

@id(1) override IS_SINGLE_0 : bool = false;

struct LocalRay_0
{
     origin_6 : vec3<f32>,
     direction_6 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_3 : f32,
     t_max_3 : f32,
     is_valid_0 : bool,
};

fn local_ray_0( _S41 : Ray_0,  _S42 : u32) -> LocalRay_0
{
    var _S43 : vec3<f32> = Transform_point_0(_S42, _S41.origin_2);
    var _S44 : vec3<f32> = Transform_direction_0(_S42, _S41.direction_1);
    var is_still_0 : vec3<bool> = !((abs(_S44)) >= vec3<f32>(1.17549435082228751e-38f));
    var local_1 : LocalRay_0;
    var _S45 : vec3<f32> = select(_S44, vec3<f32>(0.0f), is_still_0);
    local_1.direction_6 = _S45;
    local_1.inverse_0 = select(vec3<f32>(1.0f) / select(_S44, vec3<f32>(1.0f), is_still_0), vec3<f32>(3.4028234663852886e+38f), is_still_0);
    local_1.origin_6 = select(_S43, floor(_S43) + vec3<f32>(0.5f), is_still_0);
    var speed_0 : f32 = max_element_0(abs(_S45));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_1.origin_6)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((_S41.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S41.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S41.t_min_1) <= (_S41.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_1.t_min_3 = _S41.t_min_1;
    local_1.t_max_3 = _S41.t_max_1;
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
    local_1.is_valid_0 = moves_0;
    return local_1;
}

struct Walk_0
{
     ray_3 : LocalRay_0,
     origin_7 : vec3<f32>,
     grid_origin_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     octant_0 : u32,
     is_negative_0 : vec3<i32>,
     t_end_0 : f32,
};

fn LocalRay_tolerance_0( this_5 : LocalRay_0,  grid_min_0 : vec3<i32>,  grid_max_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_5.origin_6) + (vec3<f32>(max(abs(grid_min_0), abs(grid_max_0))) + vec3<f32>(1.0f))) * vec3<f32>(3.5762786865234375e-07f), vec3<f32>(-1.0f), (this_5.direction_6) == vec3<f32>(0.0f));
}

fn LocalRay_octant_0( this_6 : LocalRay_0) -> u32
{
    return (((u32((this_6.direction_6.x) < 0.0f) | (((u32((this_6.direction_6.y) < 0.0f) << (u32(1))))))) | (((u32((this_6.direction_6.z) < 0.0f) << (u32(2))))));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_3 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S46 : LocalRay_0,  _S47 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_3 = _S46;
    var _S48 : vec3<i32> = cell_of_0(grids_0[_S47].origin_1);
    walk_0.grid_origin_0 = _S48;
    walk_0.origin_7 = _S46.origin_6 - vec3<f32>(_S48);
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S46, cell_of_0(grids_0[_S47].min_0), cell_of_0(grids_0[_S47].max_0));
    walk_0.octant_0 = LocalRay_octant_0(_S46);
    walk_0.is_negative_0 = vec3<i32>((_S46.direction_6) < vec3<f32>(0.0f));
    walk_0.t_end_0 = LocalRay_t_end_0(_S46);
    return walk_0;
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
    var _S49 : f32 = a_parts_0.x;
    var _S50 : f32 = b_parts_0.x;
    var _S51 : f32 = b_parts_0.y;
    var _S52 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S49 * _S50 - product_0 + _S49 * _S51 + _S52 * _S50 + _S52 * _S51);
}

fn exact_start_voxel_0( ray_4 : LocalRay_0) -> vec3<i32>
{
    var voxel_2 : vec3<i32>;
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var way_0 : vec2<f32> = exact_product_0(ray_4.t_min_3, ray_4.direction_6[axis_0]);
        var _S53 : f32 = way_0.x;
        var sum_0 : f32 = ray_4.origin_6[axis_0] + _S53;
        var part_0 : f32 = sum_0 - ray_4.origin_6[axis_0];
        var low_1 : f32 = ray_4.origin_6[axis_0] - (sum_0 - part_0) + (_S53 - part_0) + way_0.y;
        var whole_0 : f32 = floor(sum_0);
        var _S54 : i32 = i32(whole_0);
        var _S55 : bool;
        if(sum_0 == whole_0)
        {
            _S55 = low_1 < 0.0f;
        }
        else
        {
            _S55 = false;
        }
        voxel_2[axis_0] = _S54 - i32(_S55);
        axis_0 = axis_0 + u32(1);
    }
    return voxel_2;
}

fn Walk_start_voxel_0( this_8 : Walk_0) -> vec3<i32>
{
    var start_2 : vec3<f32> = clamp(this_8.ray_3.origin_6 + this_8.ray_3.direction_6 * vec3<f32>(this_8.ray_3.t_min_3), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return vec3<i32>(floor(start_2)) - this_8.grid_origin_0;
    }
    var nearest_0 : vec3<f32> = round(start_2);
    var from_nearest_0 : vec3<f32> = start_2 - nearest_0;
    var _S56 : bool;
    if((this_8.ray_3.t_min_3) > 0.0f)
    {
        _S56 = (any(((abs(from_nearest_0)) <= (this_8.tolerance_0))));
    }
    else
    {
        _S56 = false;
    }
    if(_S56)
    {
        return exact_start_voxel_0(this_8.ray_3) - this_8.grid_origin_0;
    }
    return vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_8.grid_origin_0;
}

struct Crossing_0
{
     distance_0 : f32,
     distance_low_0 : f32,
     speed_1 : f32,
     axis_1 : u32,
};

fn Crossing_x24init_0( distance_1 : f32,  distance_low_1 : f32,  speed_2 : f32,  axis_2 : u32) -> Crossing_0
{
    var _S57 : Crossing_0;
    _S57.distance_0 = distance_1;
    _S57.distance_low_0 = distance_low_1;
    _S57.speed_1 = speed_2;
    _S57.axis_1 = axis_2;
    return _S57;
}

fn crossing_of_0( ray_5 : LocalRay_0,  axis_3 : u32,  plane_0 : i32) -> Crossing_0
{
    var sign_0 : f32;
    if((ray_5.direction_6[axis_3]) < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var at_0 : f32 = f32(plane_0);
    var difference_0 : f32 = at_0 - ray_5.origin_6[axis_3];
    var part_1 : f32 = difference_0 - at_0;
    return Crossing_x24init_0(difference_0 * sign_0, (at_0 - (difference_0 - part_1) - (ray_5.origin_6[axis_3] + part_1)) * sign_0, abs(ray_5.direction_6[axis_3]), axis_3);
}

fn Crossing_is_before_0( this_9 : Crossing_0,  other_0 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_9.distance_0, other_0.speed_1);
    var theirs_0 : vec2<f32> = exact_product_0(other_0.distance_0, this_9.speed_1);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_9.distance_low_0 * other_0.speed_1;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_0.distance_low_0 * this_9.speed_1;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S58 : bool;
    if(difference_1 < 0.0f)
    {
        _S58 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S58 = (this_9.axis_1) < (other_0.axis_1);
        }
        else
        {
            _S58 = false;
        }
    }
    return _S58;
}

fn leave_box_0( ray_6 : LocalRay_0,  voxel_3 : vec3<i32>,  exit_0 : vec3<i32>,  guess_0 : vec3<i32>) -> vec3<i32>
{
    var _S59 : bool;
    var first_1 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        if((ray_6.direction_6[axis_4]) == 0.0f)
        {
            axis_4 = axis_4 + u32(1);
            continue;
        }
        var crossing_0 : Crossing_0 = crossing_of_0(ray_6, axis_4, exit_0[axis_4]);
        if((first_1.axis_1) == u32(3))
        {
            _S59 = true;
        }
        else
        {
            _S59 = Crossing_is_before_0(crossing_0, first_1);
        }
        var first_2 : Crossing_0;
        if(_S59)
        {
            first_2 = crossing_0;
        }
        else
        {
            first_2 = first_1;
        }
        first_1 = first_2;
        axis_4 = axis_4 + u32(1);
    }
    var arrival_0 : vec3<i32> = voxel_3;
    axis_4 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S60 : u32 = axis_4;
        if((ray_6.direction_6[axis_4]) == 0.0f)
        {
            axis_4 = axis_4 + u32(1);
            continue;
        }
        var is_negative_1 : bool = (ray_6.direction_6[_S60]) < 0.0f;
        if(axis_4 == (first_1.axis_1))
        {
            arrival_0[axis_4] = exit_0[axis_4] - i32(is_negative_1);
            axis_4 = axis_4 + u32(1);
            continue;
        }
        var _S61 : i32;
        if(is_negative_1)
        {
            _S61 = i32(-1);
        }
        else
        {
            _S61 = i32(1);
        }
        var _S62 : i32;
        if(is_negative_1)
        {
            _S62 = min(guess_0[axis_4], voxel_3[axis_4]);
        }
        else
        {
            _S62 = max(guess_0[axis_4], voxel_3[axis_4]);
        }
        var _S63 : i32 = i32(is_negative_1);
        var cell_2 : i32 = _S62;
        for(;;)
        {
            if(cell_2 != (voxel_3[axis_4]))
            {
                _S59 = !Crossing_is_before_0(crossing_of_0(ray_6, axis_4, cell_2 + _S63), first_1);
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
            cell_2 = cell_2 - _S61;
        }
        var cell_3 : i32 = cell_2;
        for(;;)
        {
            var _S64 : i32 = cell_3 + _S61;
            if(Crossing_is_before_0(crossing_of_0(ray_6, axis_4, _S64 + _S63), first_1))
            {
            }
            else
            {
                break;
            }
            cell_3 = _S64;
        }
        arrival_0[axis_4] = cell_3;
        axis_4 = axis_4 + u32(1);
    }
    return arrival_0;
}

fn Walk_arrive_0( this_10 : Walk_0,  voxel_4 : vec3<i32>,  t_2 : f32,  is_axis_1 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_2 : vec3<f32> = clamp(this_10.origin_7 + this_10.ray_3.direction_6 * vec3<f32>(t_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(IS_EXACT_0)
    {
        var nearest_1 : vec3<f32> = round(position_2);
        var from_nearest_1 : vec3<f32> = position_2 - nearest_1;
        var cell_4 : vec3<i32> = vec3<i32>(nearest_1) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f));
        if((any((select(vec3<bool>(false), !is_axis_1, (abs(from_nearest_1)) <= (this_10.tolerance_0))))))
        {
            return leave_box_0(this_10.ray_3, voxel_4 + this_10.grid_origin_0, exit_1 + this_10.grid_origin_0, cell_4 + this_10.grid_origin_0) - this_10.grid_origin_0;
        }
        return select(cell_4, exit_1 - this_10.is_negative_0, is_axis_1);
    }
    var last_0 : vec3<i32> = exit_1 - vec3<i32>(i32(1)) + this_10.is_negative_0;
    return select(clamp(vec3<i32>(floor(position_2)), min(voxel_4, last_0), max(voxel_4, last_0)), exit_1 - this_10.is_negative_0, is_axis_1);
}

fn Walk_enter_0( this_11 : Walk_0,  voxel_5 : ptr<function, vec3<i32>>,  low_2 : vec3<i32>,  high_1 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_below_0 : vec3<bool> = (*voxel_5) < low_2;
        var is_outside_0 : vec3<bool> = select((*voxel_5) >= high_1, vec3<bool>(true), is_below_0);
        if(!(any((is_outside_0))))
        {
            break;
        }
        var _S65 : vec3<i32> = vec3<i32>(i32(0));
        var _S66 : vec3<bool> = (this_11.is_negative_0) != _S65;
        if((any((select(vec3<bool>(false), select((this_11.ray_3.direction_6) == vec3<f32>(0.0f), vec3<bool>(true), !select(_S66, (this_11.is_negative_0) == _S65, is_below_0)), is_outside_0)))))
        {
            return false;
        }
        var plane_1 : vec3<i32> = select(high_1, low_2, is_below_0);
        var t_3 : vec3<f32> = select(vec3<f32>(-1.0f), (vec3<f32>(plane_1) - this_11.origin_7) * this_11.ray_3.inverse_0, is_outside_0);
        var t_last_0 : f32 = max_element_0(t_3);
        if(t_last_0 > (this_11.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_3.x) == t_last_0;
        var _S67 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S67)
        {
            is_y_0 = (t_3.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S68 : bool;
        if(_S67)
        {
            _S68 = !is_y_0;
        }
        else
        {
            _S68 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S68);
        (*voxel_5) = Walk_arrive_0(this_11, (*voxel_5), t_last_0, is_axis_2, select(select(vec3<i32>(i32(1073741823)), vec3<i32>(i32(-1073741824)), _S66), plane_1, is_axis_2));
    }
    return true;
}

fn leap_0( code_0 : u32) -> i32
{
    var edges_0 : u32;
    if(code_0 < u32(4))
    {
        edges_0 = u32(67305985);
    }
    else
    {
        edges_0 = u32(269223942);
    }
    return i32((((edges_0 >> ((u32(8) * ((code_0 & (u32(3)))))))) & (u32(255))));
}

fn blocks_ahead_0( octant_1 : u32,  block_0 : u32) -> u32
{
    var is_far_0 : u32 = (block_0 ^ (octant_1));
    var x_1 : u32;
    if(((is_far_0 & (u32(1)))) == u32(0))
    {
        x_1 = u32(255);
    }
    else
    {
        if(((block_0 & (u32(1)))) == u32(0))
        {
            x_1 = u32(85);
        }
        else
        {
            x_1 = u32(170);
        }
    }
    var y_0 : u32;
    if(((is_far_0 & (u32(2)))) == u32(0))
    {
        y_0 = u32(255);
    }
    else
    {
        if(((block_0 & (u32(2)))) == u32(0))
        {
            y_0 = u32(51);
        }
        else
        {
            y_0 = u32(204);
        }
    }
    var z_0 : u32;
    if(((is_far_0 & (u32(4)))) == u32(0))
    {
        z_0 = u32(255);
    }
    else
    {
        if(((block_0 & (u32(4)))) == u32(0))
        {
            z_0 = u32(15);
        }
        else
        {
            z_0 = u32(240);
        }
    }
    return (((x_1 & (y_0))) & (z_0));
}

fn voxels_ahead_0( octant_2 : u32,  bit_1 : u32) -> vec2<u32>
{
    var x_2 : u32 = (bit_1 & (u32(3)));
    var y_1 : u32 = (((bit_1 >> (u32(2)))) & (u32(3)));
    var z_1 : u32 = (bit_1 >> (u32(4)));
    var row_0 : u32;
    if(((octant_2 & (u32(1)))) != u32(0))
    {
        row_0 = ((u32(2) << (x_2))) - u32(1);
    }
    else
    {
        row_0 = (((u32(15) << (x_2))) & (u32(15)));
    }
    var rows_0 : u32;
    if(((octant_2 & (u32(2)))) != u32(0))
    {
        rows_0 = ((u32(16) << ((u32(4) * y_1)))) - u32(1);
    }
    else
    {
        rows_0 = (u32(65535) << ((u32(4) * y_1)));
    }
    var pair_0 : u32 = (((((row_0 * u32(4369)) & (rows_0))) & (u32(65535)))) * u32(65537);
    var low_3 : u32;
    var high_2 : u32;
    if(((octant_2 & (u32(4)))) != u32(0))
    {
        if(z_1 == u32(0))
        {
            row_0 = u32(65535);
        }
        else
        {
            row_0 = u32(4294967295);
        }
        if(z_1 < u32(2))
        {
            rows_0 = u32(0);
        }
        else
        {
            if(z_1 == u32(2))
            {
                rows_0 = u32(65535);
            }
            else
            {
                rows_0 = u32(4294967295);
            }
        }
        low_3 = row_0;
        high_2 = rows_0;
    }
    else
    {
        if(z_1 == u32(0))
        {
            row_0 = u32(4294967295);
        }
        else
        {
            if(z_1 == u32(1))
            {
                row_0 = u32(4294901760);
            }
            else
            {
                row_0 = u32(0);
            }
        }
        if(z_1 == u32(3))
        {
            rows_0 = u32(4294901760);
        }
        else
        {
            rows_0 = u32(4294967295);
        }
        low_3 = row_0;
        high_2 = rows_0;
    }
    return vec2<u32>((pair_0 & (low_3)), (pair_0 & (high_2)));
}

fn empty_around_0( record_0 : u32,  relative_1 : vec3<i32>,  octant_3 : u32) -> u32
{
    var header_1 : u32 = bricks_0[record_0];
    var block_1 : u32 = (((u32(((((relative_1.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_1.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_1.z) >> (u32(2)))) & (i32(1)))) << (u32(2))))));
    var ahead_0 : u32 = (header_1 & ((blocks_ahead_0(octant_3, block_1))));
    if(ahead_0 == u32(0))
    {
        return u32(3);
    }
    if(((((header_1 >> (block_1))) & (u32(1)))) == u32(0))
    {
        return u32(2);
    }
    var _S69 : u32 = (u32(1) << (block_1));
    var at_1 : u32 = record_0 + u32(2) + u32(2) * countOneBits((header_1 & ((_S69 - u32(1)))));
    var _S70 : u32 = bricks_0[at_1];
    var _S71 : u32 = bricks_0[at_1 + u32(1)];
    var mask_0 : vec2<u32> = vec2<u32>(_S70, _S71);
    var bit_2 : u32 = cell_in_node_0(relative_1, u32(0));
    var half_0 : u32;
    if(bit_2 < u32(32))
    {
        half_0 = _S70;
    }
    else
    {
        half_0 = _S71;
    }
    if(((((half_0 >> (((bit_2 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var in_block_0 : vec2<u32> = (mask_0 & ((voxels_ahead_0(octant_3, bit_2))));
    var _S72 : i32;
    if((((in_block_0.x) | ((in_block_0.y)))) == u32(0))
    {
        if(((ahead_0 & ((~_S69)))) == u32(0))
        {
            _S72 = i32(3);
        }
        else
        {
            _S72 = i32(2);
        }
        return u32(_S72);
    }
    if(((((half_0 >> (((bit_2 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S72 = i32(1);
    }
    else
    {
        _S72 = i32(0);
    }
    return u32(_S72);
}

fn Walk_leave_0( this_12 : Walk_0,  voxel_6 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_4 : vec3<f32> = (vec3<f32>(exit_2) - this_12.origin_7) * this_12.ray_3.inverse_0;
    var _S73 : f32 = t_4.x;
    var _S74 : f32 = t_4.y;
    var _S75 : f32 = min(min(_S73, _S74), t_4.z);
    if(_S75 > (this_12.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = _S73 == _S75;
    var _S76 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S76)
    {
        is_y_1 = _S74 == _S75;
    }
    else
    {
        is_y_1 = false;
    }
    var _S77 : vec3<i32> = (*voxel_6);
    var _S78 : bool;
    if(_S76)
    {
        _S78 = !is_y_1;
    }
    else
    {
        _S78 = false;
    }
    (*voxel_6) = Walk_arrive_0(this_12, _S77, _S75, vec3<bool>(is_x_1, is_y_1, _S78), exit_2);
    return true;
}

fn first_voxel_0( _S79 : u32,  _S80 : LocalRay_0,  _S81 : ptr<function, vec3<i32>>) -> bool
{
    var _S82 : vec3<i32> = vec3<i32>(i32(0));
    (*_S81) = _S82;
    var _S83 : Walk_0 = walk_of_0(_S80, _S79);
    var voxel_7 : vec3<i32> = Walk_start_voxel_0(_S83);
    var _S84 : bool = Walk_enter_0(_S83, &(voxel_7), cell_of_0(grids_0[_S79].min_0) - _S83.grid_origin_0, cell_of_0(grids_0[_S79].max_0) - _S83.grid_origin_0);
    if(!_S84)
    {
        return false;
    }
    var _S85 : vec3<i32> = cell_of_0(grids_0[_S79].top_size_0);
    var node_at_0 : vec3<i32> = vec3<i32>(i32(-1));
    var node_0 : u32 = u32(0);
    for(;;)
    {
        var _S86 : vec3<u32> = vec3<u32>(u32(5));
        var node_at_1 : vec3<i32>;
        var cell_5 : u32;
        var shift_4 : u32;
        var shift_5 : u32;
        if((all((((voxel_7 >> (_S86))) == node_at_0))))
        {
            cell_5 = cells_0[node_0 + cell_in_node_0(voxel_7, u32(3))];
            node_at_1 = node_at_0;
            shift_5 = u32(3);
        }
        else
        {
            var _S87 : u32 = grids_0[_S79].top_shift_0;
            var top_1 : vec3<i32> = (voxel_7 >> (vec3<u32>(grids_0[_S79].top_shift_0)));
            if((any((vec3<u32>(top_1) >= vec3<u32>(_S85)))))
            {
                return false;
            }
            cell_5 = cells_0[grids_0[_S79].top_offset_0 + u32((top_1.z * _S85.y + top_1.y) * _S85.x + top_1.x)];
            node_at_1 = node_at_0;
            shift_4 = node_0;
            shift_5 = _S87;
            for(;;)
            {
                var _S88 : bool;
                if(shift_5 > u32(3))
                {
                    _S88 = ((cell_5 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S88 = false;
                }
                if(_S88)
                {
                }
                else
                {
                    break;
                }
                var shift_6 : u32 = shift_5 - u32(2);
                var node_1 : u32 = ((cell_5 & (u32(2147483647)))) * u32(64);
                var _S89 : u32 = cells_0[node_1 + cell_in_node_0(voxel_7, shift_6)];
                if(shift_6 == u32(3))
                {
                    node_at_1 = (voxel_7 >> (_S86));
                }
                cell_5 = _S89;
                shift_4 = node_1;
                shift_5 = shift_6;
            }
            node_0 = shift_4;
        }
        var count_2 : i32;
        if(((cell_5 & (u32(2147483648)))) == u32(0))
        {
            count_2 = leap_0((((cell_5 >> ((u32(3) * _S83.octant_0)))) & (u32(7))));
            shift_4 = shift_5;
        }
        else
        {
            var shift_7 : u32 = empty_around_0(((cell_5 & (u32(2147483647)))) * u32(2), voxel_7, _S83.octant_0);
            if(shift_7 == u32(4294967295))
            {
                (*_S81) = voxel_7 + _S83.grid_origin_0;
                return true;
            }
            count_2 = i32(1);
            shift_4 = shift_7;
        }
        var _S90 : bool = Walk_leave_0(_S83, &(voxel_7), ((((voxel_7 >> (vec3<u32>(shift_4)))) + select(vec3<i32>(count_2), vec3<i32>((i32(1) - count_2)), (_S83.is_negative_0) != _S82)) << (vec3<u32>(shift_4))));
        if(!_S90)
        {
            break;
        }
        node_at_0 = node_at_1;
    }
    return false;
}

fn Hit_x24init_0( t_5 : f32,  instance_3 : u32,  voxel_8 : vec3<i32>,  face_4 : u32) -> Hit_0
{
    var _S91 : Hit_0;
    _S91.t_1 = t_5;
    _S91.instance_1 = instance_3;
    _S91.voxel_1 = voxel_8;
    _S91.face_1 = face_4;
    return _S91;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn hit_of_0( ray_7 : LocalRay_0,  voxel_9 : vec3<i32>,  instance_4 : u32) -> Hit_0
{
    var last_1 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S92 : u32 = axis_5;
        if((ray_7.direction_6[axis_5]) == 0.0f)
        {
            axis_5 = axis_5 + u32(1);
            continue;
        }
        var crossing_1 : Crossing_0 = crossing_of_0(ray_7, axis_5, voxel_9[axis_5] + i32((ray_7.direction_6[_S92]) < 0.0f));
        var _S93 : bool;
        if((last_1.axis_1) == u32(3))
        {
            _S93 = true;
        }
        else
        {
            _S93 = !Crossing_is_before_0(crossing_1, last_1);
        }
        var last_2 : Crossing_0;
        if(_S93)
        {
            last_2 = crossing_1;
        }
        else
        {
            last_2 = last_1;
        }
        last_1 = last_2;
        axis_5 = axis_5 + u32(1);
    }
    var is_negative_2 : bool = (ray_7.direction_6[last_1.axis_1]) < 0.0f;
    return Hit_x24init_0(max((f32(voxel_9[last_1.axis_1] + i32(is_negative_2)) - ray_7.origin_6[last_1.axis_1]) * ray_7.inverse_0[last_1.axis_1], ray_7.t_min_3), instance_4, voxel_9, u32(2) * last_1.axis_1 + u32(is_negative_2));
}

fn hit_in_0( instance_5 : u32,  ray_8 : Ray_0) -> Hit_0
{
    var _S94 : LocalRay_0 = local_ray_0(ray_8, instance_5);
    var voxel_10 : vec3<i32>;
    var _S95 : bool;
    if(!_S94.is_valid_0)
    {
        _S95 = true;
    }
    else
    {
        var _S96 : bool = first_voxel_0(instances_0[instance_5].grid_0, _S94, &(voxel_10));
        _S95 = !_S96;
    }
    if(_S95)
    {
        return miss_0();
    }
    var hit_3 : Hit_0 = hit_of_0(_S94, voxel_10, instance_5);
    if((hit_3.t_1) > (ray_8.t_max_1))
    {
        return miss_0();
    }
    return hit_3;
}

fn entry_0( _S97 : u32,  _S98 : Ray_0,  _S99 : vec3<f32>) -> f32
{
    var low_4 : vec3<f32> = (vector_of_0(instance_nodes_0[_S97].min_1) - _S98.origin_2) * _S99;
    var high_3 : vec3<f32> = (vector_of_0(instance_nodes_0[_S97].max_1) - _S98.origin_2) * _S99;
    var _S100 : f32 = max(_S98.t_min_1, max_element_0(min(low_4, high_3)));
    var last_3 : vec3<f32> = max(low_4, high_3);
    var _S101 : f32;
    if(_S100 <= (min(_S98.t_max_1, min(min(last_3.x, last_3.y), last_3.z))))
    {
        _S101 = _S100;
    }
    else
    {
        _S101 = (bitcast<f32>((u32(2139095040))));
    }
    return _S101;
}

fn visit_0( ray_9 : Ray_0,  is_any_enough_0 : bool) -> Hit_0
{
    var _S102 : Ray_0 = ray_9;
    if(IS_SINGLE_0)
    {
        return hit_in_0(u32(0), _S102);
    }
    var nearest_2 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_2;
    }
    var is_still_1 : vec3<bool> = !((abs(_S102.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S103 : vec3<f32> = select(vec3<f32>(1.0f) / select(_S102.direction_1, vec3<f32>(1.0f), is_still_1), vec3<f32>(3.4028234663852886e+38f), is_still_1);
    var stack_0 : array<u32, i32(32)>;
    var near_0 : u32 = u32(0);
    var nearest_3 : Hit_0 = nearest_2;
    var depth_0 : u32 = u32(0);
    for(;;)
    {
        var depth_1 : u32;
        if((instance_nodes_0[near_0].is_leaf_0) != u32(0))
        {
            var hit_4 : Hit_0 = hit_in_0(instance_nodes_0[near_0].index_0, _S102);
            var _S104 : Hit_0 = nearest_3;
            var _S105 : bool;
            if((hit_4.t_1) < (nearest_3.t_1))
            {
                _S105 = true;
            }
            else
            {
                if((hit_4.t_1) == (_S104.t_1))
                {
                    _S105 = (hit_4.instance_1) < (nearest_3.instance_1);
                }
                else
                {
                    _S105 = false;
                }
            }
            var nearest_4 : Hit_0;
            if(_S105)
            {
                _S102.t_max_1 = hit_4.t_1;
                if(is_any_enough_0)
                {
                    return hit_4;
                }
                nearest_4 = hit_4;
            }
            else
            {
                nearest_4 = nearest_3;
            }
            nearest_3 = nearest_4;
            depth_1 = depth_0;
        }
        else
        {
            var _S106 : u32 = near_0 + u32(1);
            var _S107 : f32 = entry_0(_S106, _S102, _S103);
            var _S108 : u32 = instance_nodes_0[near_0].index_0;
            var _S109 : f32 = entry_0(instance_nodes_0[near_0].index_0, _S102, _S103);
            var _S110 : bool = _S107 <= _S109;
            if(_S110)
            {
                near_0 = _S106;
            }
            else
            {
                near_0 = _S108;
            }
            var far_0 : u32;
            if(_S110)
            {
                far_0 = _S108;
            }
            else
            {
                far_0 = _S106;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S107, _S109)) < INFINITY_0)
            {
                var _S111 : u32 = depth_0 + u32(1);
                stack_0[depth_0] = far_0;
                depth_1 = _S111;
            }
            else
            {
                depth_1 = depth_0;
            }
            if((min(_S107, _S109)) < INFINITY_0)
            {
                depth_0 = depth_1;
                continue;
            }
        }
        if(depth_1 == u32(0))
        {
            break;
        }
        var depth_2 : u32 = depth_1 - u32(1);
        near_0 = stack_0[depth_2];
        depth_0 = depth_2;
    }
    return nearest_3;
}

fn WalkTracer_trace_0( ray_10 : Ray_0) -> Hit_0
{
    return visit_0(ray_10, false);
}

fn fixed_point_0( value_1 : f32) -> vec2<u32>
{
    if(!(value_1 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_2 : u32 = (bitcast<u32>((min(value_1, 1.048576e+06f))));
    var shift_8 : i32 = i32((bits_2 >> (u32(23)))) - i32(118);
    var mantissa_0 : u32 = (((bits_2 & (u32(8388607)))) | (u32(8388608)));
    if(shift_8 <= i32(-24))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    if(shift_8 < i32(0))
    {
        return vec2<u32>((mantissa_0 >> (u32(- shift_8))), u32(0));
    }
    if(shift_8 < i32(32))
    {
        var _S112 : u32 = (mantissa_0 << (u32(shift_8)));
        var _S113 : u32;
        if(shift_8 == i32(0))
        {
            _S113 = u32(0);
        }
        else
        {
            _S113 = (mantissa_0 >> (u32(i32(32) - shift_8)));
        }
        return vec2<u32>(_S112, _S113);
    }
    return vec2<u32>(u32(0), (mantissa_0 << (u32(shift_8 - i32(32)))));
}

fn PixelRecord_add_0( this_13 : ptr<function, PixelRecord_0>,  value_2 : vec3<f32>,  is_covered_0 : bool)
{
    var channel_0 : u32 = u32(0);
    for(;;)
    {
        if(channel_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var addend_0 : vec2<u32> = fixed_point_0(value_2[channel_0]);
        var _S114 : u32 = u32(2) * channel_0;
        var _S115 : u32 = addend_0.x;
        var low_5 : u32 = (*this_13).radiance_0[_S114] + _S115;
        var high_4 : u32 = (*this_13).radiance_0[_S114 + u32(1)] + addend_0.y + u32(low_5 < _S115);
        var is_full_0 : bool = high_4 < ((*this_13).radiance_0[_S114 + u32(1)]);
        var _S116 : u32;
        if(is_full_0)
        {
            _S116 = u32(4294967295);
        }
        else
        {
            _S116 = low_5;
        }
        (*this_13).radiance_0[_S114] = _S116;
        var _S117 : u32;
        if(is_full_0)
        {
            _S117 = u32(4294967295);
        }
        else
        {
            _S117 = high_4;
        }
        (*this_13).radiance_0[_S114 + u32(1)] = _S117;
        channel_0 = channel_0 + u32(1);
    }
    (*this_13).samples_1 = (*this_13).samples_1 + u32(1);
    (*this_13).covered_0 = (*this_13).covered_0 + u32(is_covered_0);
    return;
}

fn trace_pixel_0( index_3 : u32) -> RayCounts_0
{
    var region_1 : vec4<u32> = params_0.region_0;
    var _S118 : u32 = params_0.region_0.x;
    var columns_0 : u32 = params_0.region_0.z - _S118;
    var _S119 : u32 = index_3 % columns_0;
    var _S120 : u32 = _S118 + _S119;
    var _S121 : u32 = region_1.y;
    var _S122 : u32 = index_3 / columns_0;
    var _S123 : u32 = _S121 + _S122;
    var pixel_2 : PixelRecord_0;
    pixel_2.radiance_0 = pixels_0[index_3].radiance_0;
    pixel_2.samples_1 = pixels_0[index_3].samples_1;
    pixel_2.covered_0 = pixels_0[index_3].covered_0;
    var _S124 : u32 = min(dispatch_0.samples_target_0, pixel_2.samples_1 + dispatch_0.samples_0);
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    for(;;)
    {
        if((pixel_2.samples_1) < _S124)
        {
        }
        else
        {
            break;
        }
        var sampler_3 : Sampler_0 = Sampler_x24init_0(params_0.seed_0, _S123 * params_0.width_0 + _S120, params_0.first_sample_0 + pixel_2.samples_1);
        var jitter_0 : vec4<f32> = Essay_jitter_0(sampler_3);
        var ray_11 : Ray_0 = Essay_clip_0(CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(f32(_S120) + jitter_0.x, f32(_S123) + jitter_0.y)));
        var _S125 : vec3<f32> = vec3<f32>(0.0f);
        var path_1 : Path_0 = Path_x24init_0(sampler_3, u32(0), vec3<f32>(1.0f), 0.0f, _S125);
        var radiance_2 : vec3<f32> = _S125;
        counts_0.camera_0 = counts_0.camera_0 + u32(1);
        var _S126 : Hit_0 = WalkTracer_trace_0(ray_11);
        var is_covered_1 : bool = !Hit_is_miss_0(_S126);
        var _S127 : bool;
        if(is_covered_1)
        {
            _S127 = true;
        }
        else
        {
            _S127 = (params_0.is_transparent_0) == u32(0);
        }
        var goes_on_0 : bool = _S127;
        var ray_12 : Ray_0 = ray_11;
        var hit_5 : Hit_0 = _S126;
        for(;;)
        {
            if(goes_on_0)
            {
            }
            else
            {
                break;
            }
            var next_1 : Ray_0 = ray_12;
            var _S128 : u32 = counts_0.shadow_0;
            var _S129 : bool = Essay_advance_0(&(path_1), ray_12, hit_5, &(radiance_2), &(next_1), &(_S128));
            counts_0.shadow_0 = _S128;
            if(_S129)
            {
                counts_0.bounce_1 = counts_0.bounce_1 + u32(1);
                var _S130 : Hit_0 = WalkTracer_trace_0(next_1);
                ray_12 = next_1;
                hit_5 = _S130;
            }
            goes_on_0 = _S129;
        }
        PixelRecord_add_0(&(pixel_2), radiance_2, is_covered_1);
    }
    pixels_0[index_3].radiance_0 = pixel_2.radiance_0;
    pixels_0[index_3].samples_1 = pixel_2.samples_1;
    pixels_0[index_3].covered_0 = pixel_2.covered_0;
    return counts_0;
}

var<workgroup> group_counts_0 : array<atomic<u32>, i32(3)>;

fn count_3( counts_1 : RayCounts_0,  thread_0 : u32)
{
    var _S131 : bool = thread_0 < u32(3);
    if(_S131)
    {
        atomicStore(&(group_counts_0[thread_0]), u32(0));
    }
    workgroupBarrier();
    var _S132 : u32 = atomicAdd(&(group_counts_0[i32(0)]), counts_1.camera_0);
    var _S133 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_1.bounce_1);
    var _S134 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_1.shadow_0);
    workgroupBarrier();
    if(_S131)
    {
        var _S135 : u32 = atomicLoad(&(group_counts_0[thread_0]));
        var _S136 : u32 = atomicAdd(&(counters_0[u32(1) + thread_0]), _S135);
    }
    if(thread_0 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S137 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var _S138 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S139 : u32 = id_0.x;
    var counts_2 : RayCounts_0;
    if(_S139 < (dispatch_0.count_0))
    {
        var _S140 : RayCounts_0 = trace_pixel_0(dispatch_0.first_0 + _S139);
        counts_2 = _S140;
    }
    else
    {
        counts_2 = _S138;
    }
    count_3(counts_2, thread_1);
    return;
}

struct HitRecord_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : array<i32, i32(3)>,
     face_0 : u32,
};

fn HitRecord_x24init_0( t_6 : f32,  instance_6 : u32,  voxel_11 : array<i32, i32(3)>,  face_5 : u32) -> HitRecord_0
{
    var _S141 : HitRecord_0;
    _S141.t_0 = t_6;
    _S141.instance_0 = instance_6;
    _S141.voxel_0 = voxel_11;
    _S141.face_0 = face_5;
    return _S141;
}

fn record_of_0( hit_6 : Hit_0) -> HitRecord_0
{
    var _S142 : array<i32, i32(3)> = array<i32, i32(3)>( hit_6.voxel_1.x, hit_6.voxel_1.y, hit_6.voxel_1.z );
    return HitRecord_x24init_0(hit_6.t_1, hit_6.instance_1, _S142, hit_6.face_1);
}

fn ray_of_0( _S143 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S143].origin_0), rays_0[_S143].t_min_0, vector_of_0(rays_0[_S143].direction_0), rays_0[_S143].t_max_0);
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_2 : u32)
{
    var counts_3 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S144 : u32 = id_1.x;
    if(_S144 < (dispatch_0.count_0))
    {
        var _S145 : HitRecord_0 = record_of_0(WalkTracer_trace_0(ray_of_0(dispatch_0.first_0 + _S144)));
        hits_0[dispatch_0.first_0 + _S144].t_0 = _S145.t_0;
        hits_0[dispatch_0.first_0 + _S144].instance_0 = _S145.instance_0;
        hits_0[dispatch_0.first_0 + _S144].voxel_0 = _S145.voxel_0;
        hits_0[dispatch_0.first_0 + _S144].face_0 = _S145.face_0;
        counts_3.camera_0 = u32(1);
    }
    count_3(counts_3, thread_2);
    return;
}

