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
     instance_2 : u32,
     voxel_2 : vec3<i32>,
     face_1 : u32,
};

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_1 : vec3<f32>,
};

fn Receiver_x24init_0( point_1 : vec3<f32>,  normal_2 : vec3<f32>) -> Receiver_0
{
    var _S1 : Receiver_0;
    _S1.point_0 = point_1;
    _S1.normal_1 = normal_2;
    return _S1;
}

fn Hit_is_miss_0( this_0 : Hit_0) -> bool
{
    return (this_0.instance_2) == u32(4294967295);
}

fn sky_gradient_0( direction_2 : vec3<f32>) -> vec3<f32>
{
    return (params_0.sky_nadir_0 + (params_0.sky_zenith_0 - params_0.sky_nadir_0) * vec3<f32>((0.5f * (direction_2.z + 1.0f)))) * vec3<f32>(params_0.sky_brightness_0);
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn dot_product_0( a_0 : vec3<f32>,  b_0 : vec3<f32>) -> f32
{
    return a_0.x * b_0.x + a_0.y * b_0.y + a_0.z * b_0.z;
}

fn length_squared_0( vector_0 : vec3<f32>) -> f32
{
    return dot_product_0(vector_0, vector_0);
}

fn sun_contains_0( direction_3 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_3 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_depth_0);
}

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn node_importance_0( _S2 : i32,  _S3 : Receiver_0) -> f32
{
    var low_0 : vec3<f32> = vector_of_0(light_nodes_0[_S2].min_2);
    var high_0 : vec3<f32> = vector_of_0(light_nodes_0[_S2].max_2);
    var _S4 : vec3<f32> = vec3<f32>(0.5f);
    var half_0 : vec3<f32> = (high_0 - low_0) * _S4;
    var toward_0 : vec3<f32> = (low_0 + high_0) * _S4 - _S3.point_0;
    var above_0 : f32 = dot_product_0(toward_0, _S3.normal_1) + dot_product_0(half_0, abs(_S3.normal_1));
    if(above_0 <= 0.0f)
    {
        return 0.0f;
    }
    var _S5 : f32 = max(length_squared_0(toward_0), length_squared_0(half_0));
    var distance_0 : f32 = sqrt(_S5);
    var _S6 : vec3<f32> = vec3<f32>(0.0f);
    var _S7 : vec3<f32> = vec3<f32>(distance_0);
    var beyond_min_0 : vec3<f32> = min(max(_S3.point_0 - low_0, _S6), _S7);
    var beyond_max_0 : vec3<f32> = min(max(high_0 - _S3.point_0, _S6), _S7);
    return (light_nodes_0[_S2].power_0[i32(0)] * beyond_max_0.x + light_nodes_0[_S2].power_0[i32(1)] * beyond_min_0.x + (light_nodes_0[_S2].power_0[i32(2)] * beyond_max_0.y + light_nodes_0[_S2].power_0[i32(3)] * beyond_min_0.y) + (light_nodes_0[_S2].power_0[i32(4)] * beyond_max_0.z + light_nodes_0[_S2].power_0[i32(5)] * beyond_min_0.z)) * min(above_0, distance_0) / (_S5 * _S5);
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
    return clamp(from_sun_0 / (from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn light_sun_pdf_0( receiver_1 : Receiver_0) -> f32
{
    var _S8 : f32;
    if(has_sun_0())
    {
        _S8 = params_0.sun_pdf_0 * sun_probability_0(receiver_1);
    }
    else
    {
        _S8 = 0.0f;
    }
    return _S8;
}

fn power_heuristic_0( own_0 : f32,  other_0 : f32) -> f32
{
    var ratio_0 : f32 = other_0 / own_0;
    return 1.0f / (1.0f + ratio_0 * ratio_0);
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

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_0 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_0)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

fn find_brick_0( _S9 : u32,  _S10 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S10 >> (vec3<u32>(grids_0[_S9].top_shift_0)));
    var cell_1 : u32 = cells_0[grids_0[_S9].top_offset_0 + u32((top_0.z * grids_0[_S9].top_size_0[i32(1)] + top_0.y) * grids_0[_S9].top_size_0[i32(0)] + top_0.x)];
    var shift_1 : u32 = grids_0[_S9].top_shift_0;
    for(;;)
    {
        var _S11 : bool;
        if(shift_1 > u32(3))
        {
            _S11 = ((cell_1 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S11 = false;
        }
        if(_S11)
        {
        }
        else
        {
            break;
        }
        var shift_2 : u32 = shift_1 - u32(2);
        cell_1 = cells_0[((cell_1 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S10, shift_2)];
        shift_1 = shift_2;
    }
    return ((cell_1 & (u32(2147483647)))) * u32(2);
}

fn read_bits_0( start_0 : u32,  position_0 : u32,  count_2 : u32) -> u32
{
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    var word_0 : u32 = start_0 + ((position_0 >> (u32(5))));
    var shift_3 : u32 = (position_0 & (u32(31)));
    var bits_0 : u32 = (brick_materials_0[word_0] >> (shift_3));
    var bits_1 : u32;
    if((shift_3 + count_2) > u32(32))
    {
        bits_1 = (bits_0 | (((brick_materials_0[word_0 + u32(1)] << ((u32(32) - shift_3))))));
    }
    else
    {
        bits_1 = bits_0;
    }
    return (bits_1 & ((((u32(1) << (count_2))) - u32(1))));
}

fn material_at_0( _S12 : u32,  _S13 : vec3<i32>) -> u32
{
    var _S14 : u32 = find_brick_0(_S12, _S13);
    var header_0 : u32 = bricks_0[_S14];
    var bit_0 : u32 = cell_in_node_0(_S13, u32(0));
    var present_before_0 : u32 = countOneBits((header_0 & ((((u32(1) << (((((u32(((((_S13.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((_S13.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((_S13.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
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
        var _S15 : u32 = u32(2) * index_2;
        var rank_1 : u32 = rank_0 + (countOneBits(bricks_0[_S14 + u32(2) + _S15]) + countOneBits(bricks_0[_S14 + u32(3) + _S15]));
        index_2 = index_2 + u32(1);
        rank_0 = rank_1;
    }
    var _S16 : u32 = u32(2) * present_before_0;
    var low_1 : u32 = bricks_0[_S14 + u32(2) + _S16];
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_1 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_1) + countOneBits((bricks_0[_S14 + u32(3) + _S16] & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S12].material_bits_0;
    var start_1 : u32 = bricks_0[_S14 + u32(1)];
    var index_3 : u32 = read_bits_0(start_1, palette_count_0 * grids_0[_S12].material_bits_0 + rank_0 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_3;
    }
    return read_bits_0(start_1, index_3 * entry_bits_0, entry_bits_0);
}

fn material_of_0( hit_0 : Hit_0) -> PackedMaterial_0
{
    var _S17 : PackedMaterial_std430_0 = materials_0[material_at_0(instances_0[hit_0.instance_2].grid_0, hit_0.voxel_2 - cell_of_0(grids_0[instances_0[hit_0.instance_2].grid_0].origin_1))];
    var _S18 : PackedMaterial_0 = PackedMaterial_0( _S17.base_color_0, _S17.roughness_0, _S17.emission_0, _S17.metallic_0, _S17.transmission_0, _S17.ior_0 );
    return _S18;
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn is_before_0( a_1 : vec3<i32>,  b_1 : vec3<i32>) -> bool
{
    var _S19 : vec3<u32> = vec3<u32>((a_1 ^ (b_1)));
    var _S20 : i32 = a_1.z - b_1.z;
    var deciding_0 : u32 = _S19.z;
    var _S21 : u32 = _S19.y;
    var _S22 : bool;
    if(deciding_0 < _S21)
    {
        _S22 = deciding_0 < ((deciding_0 ^ (_S21)));
    }
    else
    {
        _S22 = false;
    }
    var deciding_1 : u32;
    var difference_0 : i32;
    if(_S22)
    {
        var _S23 : i32 = a_1.y - b_1.y;
        deciding_1 = _S21;
        difference_0 = _S23;
    }
    else
    {
        deciding_1 = deciding_0;
        difference_0 = _S20;
    }
    var _S24 : u32 = _S19.x;
    if(deciding_1 < _S24)
    {
        _S22 = deciding_1 < ((deciding_1 ^ (_S24)));
    }
    else
    {
        _S22 = false;
    }
    if(_S22)
    {
        difference_0 = a_1.x - b_1.x;
    }
    return difference_0 < i32(0);
}

fn find_emitter_0( hit_1 : Hit_0,  found_0 : ptr<function, u32>) -> bool
{
    var is_lower_0 : bool;
    var _S25 : vec2<u32> = vec2<u32>(arrayLength(&emitters_0), 32);
    var count_3 : u32 = _S25.x;
    var low_2 : u32 = u32(0);
    var high_1 : u32 = count_3;
    for(;;)
    {
        if(low_2 < high_1)
        {
        }
        else
        {
            break;
        }
        var middle_0 : u32 = low_2 + (high_1 - low_2) / u32(2);
        var _S26 : u32 = emitters_0[middle_0].instance_1;
        if((emitters_0[middle_0].instance_1) < (hit_1.instance_2))
        {
            is_lower_0 = true;
        }
        else
        {
            if(_S26 == (hit_1.instance_2))
            {
                is_lower_0 = is_before_0(cell_of_0(emitters_0[middle_0].voxel_1), hit_1.voxel_2);
            }
            else
            {
                is_lower_0 = false;
            }
        }
        if(is_lower_0)
        {
            low_2 = middle_0 + u32(1);
        }
        if(is_lower_0)
        {
        }
        else
        {
            high_1 = middle_0;
        }
    }
    (*found_0) = low_2;
    if(low_2 < count_3)
    {
        is_lower_0 = (emitters_0[low_2].instance_1) == (hit_1.instance_2);
    }
    else
    {
        is_lower_0 = false;
    }
    if(is_lower_0)
    {
        is_lower_0 = (all(((cell_of_0(emitters_0[low_2].voxel_1)) == (hit_1.voxel_2))));
    }
    else
    {
        is_lower_0 = false;
    }
    return is_lower_0;
}

fn Transform_direction_0( _S27 : u32,  _S28 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S27].grid_from_world_0.x_axis_0) * vec3<f32>(_S28.x) + vector_of_0(instances_0[_S27].grid_from_world_0.y_axis_0) * vec3<f32>(_S28.y) + vector_of_0(instances_0[_S27].grid_from_world_0.z_axis_0) * vec3<f32>(_S28.z);
}

fn Transform_point_0( _S29 : u32,  _S30 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S29, _S30) + vector_of_0(instances_0[_S29].grid_from_world_0.translation_0);
}

fn normalize_vector_0( vector_2 : vec3<f32>) -> vec3<f32>
{
    return vector_2 * vec3<f32>((1.0f / sqrt(length_squared_0(vector_2))));
}

fn in_grid_0( instance_3 : u32,  receiver_2 : Receiver_0) -> Receiver_0
{
    return Receiver_x24init_0(Transform_point_0(instance_3, receiver_2.point_0), normalize_vector_0(Transform_direction_0(instance_3, receiver_2.normal_1)));
}

fn component_0( vector_3 : vec3<f32>,  axis_0 : u32) -> f32
{
    return select(select(vector_3.z, vector_3.y, axis_0 == u32(1)), vector_3.x, axis_0 == u32(0));
}

fn with_component_0( vector_4 : vec3<f32>,  axis_1 : u32,  value_0 : f32) -> vec3<f32>
{
    return select(vector_4, vec3<f32>(value_0), vec3<bool>(axis_1 == u32(0), axis_1 == u32(1), axis_1 == u32(2)));
}

fn face_importance_0( _S31 : u32,  _S32 : u32,  _S33 : Receiver_0) -> f32
{
    var axis_2 : u32 = (_S32 >> (u32(1)));
    var sign_0 : f32;
    if(((_S32 & (u32(1)))) == u32(1))
    {
        sign_0 = 1.0f;
    }
    else
    {
        sign_0 = -1.0f;
    }
    var toward_1 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[_S31].voxel_1)) + vec3<f32>(0.5f) - _S33.point_0;
    var toward_2 : vec3<f32> = with_component_0(toward_1, axis_2, component_0(toward_1, axis_2) + 0.5f * sign_0);
    var in_front_0 : f32 = - component_0(toward_2, axis_2) * sign_0;
    var above_1 : f32 = dot_product_0(toward_2, _S33.normal_1) + dot_product_0(with_component_0(vec3<f32>(0.5f), axis_2, 0.0f), abs(_S33.normal_1));
    var _S34 : bool;
    if(in_front_0 <= 0.0f)
    {
        _S34 = true;
    }
    else
    {
        _S34 = above_1 <= 0.0f;
    }
    if(_S34)
    {
        return 0.0f;
    }
    var _S35 : f32 = max(length_squared_0(toward_2), 0.5f);
    var distance_1 : f32 = sqrt(_S35);
    return emitters_0[_S31].luminance_0 * min(in_front_0, distance_1) * min(above_1, distance_1) / (_S35 * _S35);
}

fn sum_of_importances_0( first_1 : u32,  count_4 : u32,  receiver_3 : Receiver_0) -> f32
{
    var index_4 : u32 = first_1;
    var sum_0 : f32 = 0.0f;
    for(;;)
    {
        if(index_4 < (first_1 + count_4))
        {
        }
        else
        {
            break;
        }
        var face_2 : u32 = u32(0);
        var sum_1 : f32 = sum_0;
        for(;;)
        {
            if(face_2 < u32(6))
            {
            }
            else
            {
                break;
            }
            if((((((emitters_0[index_4].faces_0) >> (face_2))) & (u32(1)))) != u32(0))
            {
                sum_1 = sum_1 + face_importance_0(index_4, face_2, receiver_3);
            }
            face_2 = face_2 + u32(1);
        }
        index_4 = index_4 + u32(1);
        sum_0 = sum_1;
    }
    return sum_0;
}

fn face_pdf_0( toward_3 : vec3<f32>,  face_3 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_3, (face_3 >> (u32(1))));
    var in_front_1 : f32;
    if(((face_3 & (u32(1)))) == u32(1))
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
        in_front_1 = distance_squared_0 * sqrt(distance_squared_0) / in_front_1;
    }
    else
    {
        in_front_1 = -1.0f;
    }
    return in_front_1;
}

fn node_importance_1( _S36 : u32,  _S37 : Receiver_0) -> f32
{
    var low_3 : vec3<f32> = vector_of_0(light_nodes_0[_S36].min_2);
    var high_2 : vec3<f32> = vector_of_0(light_nodes_0[_S36].max_2);
    var _S38 : vec3<f32> = vec3<f32>(0.5f);
    var half_1 : vec3<f32> = (high_2 - low_3) * _S38;
    var toward_4 : vec3<f32> = (low_3 + high_2) * _S38 - _S37.point_0;
    var above_2 : f32 = dot_product_0(toward_4, _S37.normal_1) + dot_product_0(half_1, abs(_S37.normal_1));
    if(above_2 <= 0.0f)
    {
        return 0.0f;
    }
    var _S39 : f32 = max(length_squared_0(toward_4), length_squared_0(half_1));
    var distance_2 : f32 = sqrt(_S39);
    var _S40 : vec3<f32> = vec3<f32>(0.0f);
    var _S41 : vec3<f32> = vec3<f32>(distance_2);
    var beyond_min_1 : vec3<f32> = min(max(_S37.point_0 - low_3, _S40), _S41);
    var beyond_max_1 : vec3<f32> = min(max(high_2 - _S37.point_0, _S40), _S41);
    return (light_nodes_0[_S36].power_0[i32(0)] * beyond_max_1.x + light_nodes_0[_S36].power_0[i32(1)] * beyond_min_1.x + (light_nodes_0[_S36].power_0[i32(2)] * beyond_max_1.y + light_nodes_0[_S36].power_0[i32(3)] * beyond_min_1.y) + (light_nodes_0[_S36].power_0[i32(4)] * beyond_max_1.z + light_nodes_0[_S36].power_0[i32(5)] * beyond_min_1.z)) * min(above_2, distance_2) / (_S39 * _S39);
}

fn left_probability_0( node_0 : u32,  receiver_4 : Receiver_0) -> f32
{
    var _S42 : f32 = node_importance_1(node_0 + u32(1), receiver_4);
    var _S43 : f32 = _S42 + node_importance_1(light_nodes_0[node_0].index_1, receiver_4);
    var _S44 : f32;
    if(_S43 > 0.0f)
    {
        _S44 = _S42 / _S43;
    }
    else
    {
        _S44 = -1.0f;
    }
    return _S44;
}

fn emitter_pdf_0( receiver_5 : Receiver_0,  ray_0 : Ray_0,  hit_2 : Hit_0,  found_1 : u32) -> f32
{
    var local_0 : Receiver_0 = in_grid_0(hit_2.instance_2, receiver_5);
    var toward_5 : vec3<f32> = Transform_direction_0(hit_2.instance_2, ray_0.direction_1) * vec3<f32>(hit_2.t_1);
    var _S45 : u32 = emitters_0[found_1].leaf_0;
    var sum_2 : f32 = sum_of_importances_0(light_nodes_0[emitters_0[found_1].leaf_0].index_1, light_nodes_0[emitters_0[found_1].leaf_0].count_1, local_0);
    var own_1 : f32;
    if((((((emitters_0[found_1].faces_0) >> ((hit_2.face_1)))) & (u32(1)))) != u32(0))
    {
        own_1 = face_importance_0(found_1, hit_2.face_1, local_0);
    }
    else
    {
        own_1 = 0.0f;
    }
    var area_pdf_0 : f32 = face_pdf_0(toward_5, hit_2.face_1);
    var _S46 : bool;
    if(area_pdf_0 < 0.0f)
    {
        _S46 = true;
    }
    else
    {
        _S46 = !(own_1 > 0.0f);
    }
    if(_S46)
    {
        return 0.0f;
    }
    var _S47 : f32 = own_1 / sum_2;
    var parent_1 : u32 = light_nodes_0[emitters_0[found_1].leaf_0].parent_0;
    var node_1 : u32 = _S45;
    var probability_0 : f32 = _S47;
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

fn light_emitter_pdf_0( receiver_6 : Receiver_0,  ray_1 : Ray_0,  hit_3 : Hit_0) -> f32
{
    var found_2 : u32;
    var _S48 : bool = find_emitter_0(hit_3, &(found_2));
    if(!_S48)
    {
        return 0.0f;
    }
    return emitter_pdf_0(receiver_6, ray_1, hit_3, found_2) * (1.0f - sun_probability_0(receiver_6));
}

fn emitted_0( material_1 : PackedMaterial_0) -> vec3<f32>
{
    return vector_of_0(material_1.emission_0) * vec3<f32>(params_0.light_intensity_0);
}

fn Path_dimension_scatter_0( this_1 : Path_0) -> u32
{
    return u32(1) + u32(2) * this_1.bounce_0;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S49 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S49;
    v_0[i32(0)] = v_0[i32(0)] + _S49.y * _S49.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S50 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S50;
    v_0[i32(0)] = v_0[i32(0)] + _S50.y * _S50.w;
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

fn Sampler_pair_0( this_2 : Sampler_0,  dimension_0 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_1 : vec4<u32> = pcg4d_0(vec4<u32>(this_2.pixel_0, dimension_0, this_2.seed_1, which_0));
    return scrambled_sobol_0(this_2.sample_0, words_1.x, words_1.yz);
}

fn unit_float_0( words_2 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_2 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_stratified_0( this_3 : Sampler_0,  dimension_1 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_3, dimension_1, u32(1)), Sampler_pair_0(this_3, dimension_1, u32(2))));
}

fn survives_0( path_1 : ptr<function, Path_0>,  u_0 : f32) -> bool
{
    if(((*path_1).bounce_0) < u32(3))
    {
        return true;
    }
    var _S51 : f32 = min(max_element_0((*path_1).beta_0), 0.94999998807907104f);
    (*path_1).beta_0 = (*path_1).beta_0 * vec3<f32>((1.0f / _S51));
    return u_0 < _S51;
}

struct Surface_0
{
     origin_3 : vec3<f32>,
     normal_3 : vec3<f32>,
     face_4 : u32,
     instance_4 : u32,
};

fn point_off_face_0( _S52 : u32,  _S53 : vec3<f32>,  _S54 : u32,  _S55 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = clamp((max_element_0(abs(_S53) + abs(vector_of_0(instances_0[_S52].grid_from_world_0.translation_0))) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
    var _S56 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(_S55, _S53 + _S56), _S53 + vec3<f32>((1.0f - margin_0)));
    var _S57 : bool = _S54 < u32(2);
    var _S58 : bool;
    if(_S54 >= u32(2))
    {
        _S58 = _S54 < u32(4);
    }
    else
    {
        _S58 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S57, _S58, _S54 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((_S54 & (u32(1)))) == u32(1))
    {
        outside_0 = _S53 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = _S53 - _S56;
    }
    return select(moved_0, outside_0, is_axis_0);
}

fn Transform_direction_1( _S59 : u32,  _S60 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S59].world_from_grid_0.x_axis_0) * vec3<f32>(_S60.x) + vector_of_0(instances_0[_S59].world_from_grid_0.y_axis_0) * vec3<f32>(_S60.y) + vector_of_0(instances_0[_S59].world_from_grid_0.z_axis_0) * vec3<f32>(_S60.z);
}

fn Transform_point_1( _S61 : u32,  _S62 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S61, _S62) + vector_of_0(instances_0[_S61].world_from_grid_0.translation_0);
}

fn face_normal_0( face_5 : u32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = -1.0f;
    }
    var _S63 : f32;
    if(face_5 < u32(2))
    {
        _S63 = away_0;
    }
    else
    {
        _S63 = 0.0f;
    }
    var _S64 : bool;
    if(face_5 >= u32(2))
    {
        _S64 = face_5 < u32(4);
    }
    else
    {
        _S64 = false;
    }
    var _S65 : f32;
    if(_S64)
    {
        _S65 = away_0;
    }
    else
    {
        _S65 = 0.0f;
    }
    if(face_5 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S63, _S65, away_0);
}

fn world_normal_0( _S66 : u32,  _S67 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S66, face_normal_0(_S67)));
}

fn surface_of_0( ray_2 : Ray_0,  hit_4 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.origin_3 = Transform_point_1(hit_4.instance_2, point_off_face_0(hit_4.instance_2, vec3<f32>(hit_4.voxel_2), hit_4.face_1, Transform_point_0(hit_4.instance_2, ray_2.origin_2) + Transform_direction_0(hit_4.instance_2, ray_2.direction_1) * vec3<f32>(hit_4.t_1)));
    surface_0.normal_3 = world_normal_0(hit_4.instance_2, hit_4.face_1);
    surface_0.face_4 = hit_4.face_1;
    surface_0.instance_4 = hit_4.instance_2;
    return surface_0;
}

fn Path_dimension_light_0( this_4 : Path_0) -> u32
{
    return u32(2) + u32(2) * this_4.bounce_0;
}

struct LightSample_0
{
     ray_3 : Ray_0,
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

fn Ray_x24init_0( origin_4 : vec3<f32>,  t_min_2 : f32,  direction_4 : vec3<f32>,  t_max_2 : f32) -> Ray_0
{
    var _S68 : Ray_0;
    _S68.origin_2 = origin_4;
    _S68.t_min_1 = t_min_2;
    _S68.direction_1 = direction_4;
    _S68.t_max_1 = t_max_2;
    return _S68;
}

fn ray_from_0( origin_5 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_5, 0.0f, direction_5, (bitcast<f32>((u32(2139095040)))));
}

fn LightSample_x24init_0( ray_4 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S69 : LightSample_0;
    _S69.ray_3 = ray_4;
    _S69.cos_theta_1 = cos_theta_2;
    _S69.radiance_1 = radiance_2;
    _S69.pdf_1 = pdf_2;
    return _S69;
}

fn sample_sun_0( receiver_7 : Receiver_0,  u_1 : f32,  v_1 : f32,  sample_2 : ptr<function, LightSample_0>) -> bool
{
    var depth_0 : f32 = u_1 * params_0.sun_depth_0;
    var radius_0 : f32 = sqrt(depth_0 * (2.0f - depth_0));
    var sin_cos_0 : vec2<f32> = sincos_turns_0(v_1);
    var direction_6 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - depth_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_0 * sin_cos_0.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_0 * sin_cos_0.x)));
    var cos_theta_3 : f32 = dot_product_0(receiver_7.normal_1, direction_6);
    (*sample_2) = LightSample_x24init_0(ray_from_0(receiver_7.point_0, direction_6), cos_theta_3, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_3 > 0.0f;
}

fn no_light_0() -> LightSample_0
{
    var _S70 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S70, 0.0f, _S70, 0.0f), 0.0f, _S70, 0.0f);
}

struct FaceChoice_0
{
     emitter_0 : u32,
     face_6 : u32,
     importance_0 : f32,
};

fn FaceChoice_x24init_0( emitter_1 : u32,  face_7 : u32,  importance_1 : f32) -> FaceChoice_0
{
    var _S71 : FaceChoice_0;
    _S71.emitter_0 = emitter_1;
    _S71.face_6 = face_7;
    _S71.importance_0 = importance_1;
    return _S71;
}

fn choose_face_0( first_2 : u32,  count_5 : u32,  receiver_8 : Receiver_0,  threshold_0 : f32) -> FaceChoice_0
{
    var _S72 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), u32(0), 0.0f);
    var is_found_0 : bool = false;
    var chosen_0 : FaceChoice_0 = _S72;
    var index_6 : u32 = first_2;
    var passed_0 : f32 = 0.0f;
    for(;;)
    {
        var _S73 : bool;
        if(index_6 < (first_2 + count_5))
        {
            _S73 = !is_found_0;
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
        var is_found_1 : bool = is_found_0;
        var chosen_1 : FaceChoice_0 = chosen_0;
        var face_8 : u32 = u32(0);
        var passed_1 : f32 = passed_0;
        for(;;)
        {
            var _S74 : bool;
            if(face_8 < u32(6))
            {
                _S74 = !is_found_1;
            }
            else
            {
                _S74 = false;
            }
            if(_S74)
            {
            }
            else
            {
                break;
            }
            if((((((emitters_0[index_6].faces_0) >> (face_8))) & (u32(1)))) == u32(0))
            {
                face_8 = face_8 + u32(1);
                continue;
            }
            var _S75 : f32 = face_importance_0(index_6, face_8, receiver_8);
            var is_found_2 : bool;
            var chosen_2 : FaceChoice_0;
            var passed_2 : f32;
            if(_S75 > 0.0f)
            {
                var _S76 : FaceChoice_0 = FaceChoice_x24init_0(index_6, face_8, _S75);
                var passed_3 : f32 = passed_1 + _S75;
                is_found_2 = threshold_0 < passed_3;
                chosen_2 = _S76;
                passed_2 = passed_3;
            }
            else
            {
                is_found_2 = is_found_1;
                chosen_2 = chosen_1;
                passed_2 = passed_1;
            }
            is_found_1 = is_found_2;
            chosen_1 = chosen_2;
            passed_1 = passed_2;
            face_8 = face_8 + u32(1);
        }
        var _S77 : u32 = index_6 + u32(1);
        is_found_0 = is_found_1;
        chosen_0 = chosen_1;
        index_6 = _S77;
        passed_0 = passed_1;
    }
    return chosen_0;
}

fn point_of_face_0( low_4 : vec3<f32>,  face_9 : u32,  u_2 : f32,  v_2 : f32) -> vec3<f32>
{
    var away_1 : f32;
    if(((face_9 & (u32(1)))) == u32(1))
    {
        away_1 = 1.0f;
    }
    else
    {
        away_1 = 0.0f;
    }
    if(face_9 < u32(2))
    {
        return low_4 + vec3<f32>(away_1, u_2, v_2);
    }
    if(face_9 < u32(4))
    {
        return low_4 + vec3<f32>(u_2, away_1, v_2);
    }
    return low_4 + vec3<f32>(u_2, v_2, away_1);
}

fn sample_emitter_0( receiver_9 : Receiver_0,  u_3 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var _S78 : f32 = u_3.x;
    var node_2 : u32 = u32(0);
    var choice_0 : f32 = _S78;
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
            choice_1 = choice_0 / left_1;
            node_2 = node_3;
            probability_2 = probability_3;
        }
        else
        {
            var right_0 : f32 = 1.0f - left_1;
            var probability_4 : f32 = probability_2 * right_0;
            choice_1 = (choice_0 - left_1) / right_0;
            node_2 = light_nodes_0[node_2].index_1;
            probability_2 = probability_4;
        }
        choice_0 = min(choice_1, 0.99999994039535522f);
    }
    var local_1 : Receiver_0 = in_grid_0(emitters_0[light_nodes_0[node_2].index_1].instance_1, receiver_9);
    var sum_3 : f32 = sum_of_importances_0(light_nodes_0[node_2].index_1, light_nodes_0[node_2].count_1, local_1);
    var chosen_3 : FaceChoice_0 = choose_face_0(light_nodes_0[node_2].index_1, light_nodes_0[node_2].count_1, local_1, u_3.y * sum_3);
    if((chosen_3.importance_0) <= 0.0f)
    {
        return false;
    }
    var probability_5 : f32 = probability_2 * (chosen_3.importance_0 / sum_3);
    var _S79 : u32 = emitters_0[chosen_3.emitter_0].instance_1;
    var _S80 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[chosen_3.emitter_0].voxel_1));
    var on_face_0 : vec3<f32> = point_of_face_0(_S80, chosen_3.face_6, u_3.z, u_3.w);
    var area_pdf_1 : f32 = face_pdf_0(on_face_0 - local_1.point_0, chosen_3.face_6);
    if(area_pdf_1 < 0.0f)
    {
        return false;
    }
    var direction_7 : vec3<f32> = Transform_point_1(_S79, point_off_face_0(_S79, _S80, chosen_3.face_6, on_face_0)) - receiver_9.point_0;
    var cos_theta_4 : f32 = dot_product_0(receiver_9.normal_1, direction_7) / sqrt(length_squared_0(direction_7));
    (*sample_3) = LightSample_x24init_0(Ray_x24init_0(receiver_9.point_0, 0.0f, direction_7, 1.0f), cos_theta_4, vector_of_0(materials_0[emitters_0[chosen_3.emitter_0].material_0].emission_0) * vec3<f32>(params_0.light_intensity_0), probability_5 * area_pdf_1);
    return cos_theta_4 > 0.0f;
}

fn sample_light_0( receiver_10 : Receiver_0,  u_4 : vec4<f32>,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    var of_sun_0 : f32 = sun_probability_0(receiver_10);
    var is_found_3 : bool;
    if(has_sun_0())
    {
        is_found_3 = (u_4.x) < of_sun_0;
    }
    else
    {
        is_found_3 = false;
    }
    if(is_found_3)
    {
        var _S81 : bool = sample_sun_0(receiver_10, u_4.z, u_4.w, &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * of_sun_0;
        is_found_3 = _S81;
    }
    else
    {
        var _S82 : f32 = 1.0f - of_sun_0;
        var _S83 : bool = sample_emitter_0(receiver_10, vec4<f32>(min((u_4.x - of_sun_0) / _S82, 0.99999994039535522f), u_4.yzw), &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * _S82;
        is_found_3 = _S83;
    }
    return is_found_3;
}

fn cosine_hemisphere_pdf_0( cos_theta_5 : f32) -> f32
{
    return max(cos_theta_5, 0.0f) * 0.31830987334251404f;
}

@id(1) override IS_SINGLE_0 : bool = false;

struct LocalRay_0
{
     origin_6 : vec3<f32>,
     direction_8 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_3 : f32,
     t_max_3 : f32,
     is_valid_0 : bool,
};

fn local_ray_0( _S84 : Ray_0,  _S85 : u32) -> LocalRay_0
{
    var _S86 : vec3<f32> = Transform_point_0(_S85, _S84.origin_2);
    var _S87 : vec3<f32> = Transform_direction_0(_S85, _S84.direction_1);
    var is_still_0 : vec3<bool> = !((abs(_S87)) >= vec3<f32>(1.17549435082228751e-38f));
    var local_2 : LocalRay_0;
    var _S88 : vec3<f32> = select(_S87, vec3<f32>(0.0f), is_still_0);
    local_2.direction_8 = _S88;
    local_2.inverse_0 = select(vec3<f32>(1.0f) / select(_S87, vec3<f32>(1.0f), is_still_0), vec3<f32>(3.4028234663852886e+38f), is_still_0);
    local_2.origin_6 = select(_S86, floor(_S86) + vec3<f32>(0.5f), is_still_0);
    var speed_0 : f32 = max_element_0(abs(_S88));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_2.origin_6)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((_S84.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S84.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S84.t_min_1) <= (_S84.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_2.t_min_3 = _S84.t_min_1;
    local_2.t_max_3 = _S84.t_max_1;
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
    local_2.is_valid_0 = moves_0;
    return local_2;
}

struct Walk_0
{
     ray_5 : LocalRay_0,
     origin_7 : vec3<f32>,
     grid_origin_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     octant_0 : u32,
     is_negative_0 : vec3<i32>,
     t_end_0 : f32,
};

fn LocalRay_tolerance_0( this_5 : LocalRay_0,  grid_min_0 : vec3<i32>,  grid_max_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_5.origin_6) + (vec3<f32>(max(abs(grid_min_0), abs(grid_max_0))) + vec3<f32>(1.0f))) * vec3<f32>(3.5762786865234375e-07f), vec3<f32>(-1.0f), (this_5.direction_8) == vec3<f32>(0.0f));
}

fn LocalRay_octant_0( this_6 : LocalRay_0) -> u32
{
    return (((u32((this_6.direction_8.x) < 0.0f) | (((u32((this_6.direction_8.y) < 0.0f) << (u32(1))))))) | (((u32((this_6.direction_8.z) < 0.0f) << (u32(2))))));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_3 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S89 : LocalRay_0,  _S90 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_5 = _S89;
    var _S91 : vec3<i32> = cell_of_0(grids_0[_S90].origin_1);
    walk_0.grid_origin_0 = _S91;
    walk_0.origin_7 = _S89.origin_6 - vec3<f32>(_S91);
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S89, cell_of_0(grids_0[_S90].min_0), cell_of_0(grids_0[_S90].max_0));
    walk_0.octant_0 = LocalRay_octant_0(_S89);
    walk_0.is_negative_0 = vec3<i32>((_S89.direction_8) < vec3<f32>(0.0f));
    walk_0.t_end_0 = LocalRay_t_end_0(_S89);
    return walk_0;
}

@id(0) override IS_EXACT_0 : bool = true;

fn halves_0( value_1 : f32) -> vec2<f32>
{
    var high_3 : f32 = (bitcast<f32>((((bitcast<u32>((value_1))) & (u32(4294963200))))));
    return vec2<f32>(high_3, value_1 - high_3);
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
    var _S92 : f32 = a_parts_0.x;
    var _S93 : f32 = b_parts_0.x;
    var _S94 : f32 = b_parts_0.y;
    var _S95 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S92 * _S93 - product_0 + _S92 * _S94 + _S95 * _S93 + _S95 * _S94);
}

fn exact_start_voxel_0( ray_6 : LocalRay_0) -> vec3<i32>
{
    var voxel_3 : vec3<i32>;
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        var way_0 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[axis_3]);
        var _S96 : f32 = way_0.x;
        var sum_4 : f32 = ray_6.origin_6[axis_3] + _S96;
        var part_0 : f32 = sum_4 - ray_6.origin_6[axis_3];
        var low_5 : f32 = ray_6.origin_6[axis_3] - (sum_4 - part_0) + (_S96 - part_0) + way_0.y;
        var whole_0 : f32 = floor(sum_4);
        var _S97 : i32 = i32(whole_0);
        var _S98 : bool;
        if(sum_4 == whole_0)
        {
            _S98 = low_5 < 0.0f;
        }
        else
        {
            _S98 = false;
        }
        voxel_3[axis_3] = _S97 - i32(_S98);
        axis_3 = axis_3 + u32(1);
    }
    return voxel_3;
}

fn Walk_start_voxel_0( this_8 : Walk_0) -> vec3<i32>
{
    var start_2 : vec3<f32> = clamp(this_8.ray_5.origin_6 + this_8.ray_5.direction_8 * vec3<f32>(this_8.ray_5.t_min_3), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return vec3<i32>(floor(start_2)) - this_8.grid_origin_0;
    }
    var nearest_0 : vec3<f32> = round(start_2);
    var from_nearest_0 : vec3<f32> = start_2 - nearest_0;
    var _S99 : bool;
    if((this_8.ray_5.t_min_3) > 0.0f)
    {
        _S99 = (any(((abs(from_nearest_0)) <= (this_8.tolerance_0))));
    }
    else
    {
        _S99 = false;
    }
    if(_S99)
    {
        return exact_start_voxel_0(this_8.ray_5) - this_8.grid_origin_0;
    }
    return vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_8.grid_origin_0;
}

fn Walk_crossings_0( this_9 : Walk_0,  planes_0 : vec3<i32>) -> vec3<f32>
{
    if(IS_EXACT_0)
    {
        return (vec3<f32>(planes_0 + this_9.grid_origin_0) - this_9.ray_5.origin_6) * this_9.ray_5.inverse_0;
    }
    return (vec3<f32>(planes_0) - this_9.origin_7) * this_9.ray_5.inverse_0;
}

struct Crossing_0
{
     distance_3 : f32,
     distance_low_0 : f32,
     speed_1 : f32,
     axis_4 : u32,
};

fn Crossing_x24init_0( distance_4 : f32,  distance_low_1 : f32,  speed_2 : f32,  axis_5 : u32) -> Crossing_0
{
    var _S100 : Crossing_0;
    _S100.distance_3 = distance_4;
    _S100.distance_low_0 = distance_low_1;
    _S100.speed_1 = speed_2;
    _S100.axis_4 = axis_5;
    return _S100;
}

fn crossing_of_0( ray_7 : LocalRay_0,  axis_6 : u32,  plane_0 : i32) -> Crossing_0
{
    var sign_1 : f32;
    if((ray_7.direction_8[axis_6]) < 0.0f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var at_0 : f32 = f32(plane_0);
    var difference_1 : f32 = at_0 - ray_7.origin_6[axis_6];
    var part_1 : f32 = difference_1 - at_0;
    return Crossing_x24init_0(difference_1 * sign_1, (at_0 - (difference_1 - part_1) - (ray_7.origin_6[axis_6] + part_1)) * sign_1, abs(ray_7.direction_8[axis_6]), axis_6);
}

fn Crossing_is_before_0( this_10 : Crossing_0,  other_1 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_10.distance_3, other_1.speed_1);
    var theirs_0 : vec2<f32> = exact_product_0(other_1.distance_3, this_10.speed_1);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_10.distance_low_0 * other_1.speed_1;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_1.distance_low_0 * this_10.speed_1;
    }
    var difference_2 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S101 : bool;
    if(difference_2 < 0.0f)
    {
        _S101 = true;
    }
    else
    {
        if(difference_2 == 0.0f)
        {
            _S101 = (this_10.axis_4) < (other_1.axis_4);
        }
        else
        {
            _S101 = false;
        }
    }
    return _S101;
}

fn leave_box_0( ray_8 : LocalRay_0,  voxel_4 : vec3<i32>,  exit_0 : vec3<i32>,  guess_0 : vec3<i32>) -> vec3<i32>
{
    var _S102 : bool;
    var first_3 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    var axis_7 : u32 = u32(0);
    for(;;)
    {
        if(axis_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        if((ray_8.direction_8[axis_7]) == 0.0f)
        {
            axis_7 = axis_7 + u32(1);
            continue;
        }
        var crossing_0 : Crossing_0 = crossing_of_0(ray_8, axis_7, exit_0[axis_7]);
        if((first_3.axis_4) == u32(3))
        {
            _S102 = true;
        }
        else
        {
            _S102 = Crossing_is_before_0(crossing_0, first_3);
        }
        var first_4 : Crossing_0;
        if(_S102)
        {
            first_4 = crossing_0;
        }
        else
        {
            first_4 = first_3;
        }
        first_3 = first_4;
        axis_7 = axis_7 + u32(1);
    }
    var arrival_0 : vec3<i32> = voxel_4;
    axis_7 = u32(0);
    for(;;)
    {
        if(axis_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S103 : u32 = axis_7;
        if((ray_8.direction_8[axis_7]) == 0.0f)
        {
            axis_7 = axis_7 + u32(1);
            continue;
        }
        var is_negative_1 : bool = (ray_8.direction_8[_S103]) < 0.0f;
        if(axis_7 == (first_3.axis_4))
        {
            arrival_0[axis_7] = exit_0[axis_7] - i32(is_negative_1);
            axis_7 = axis_7 + u32(1);
            continue;
        }
        var _S104 : i32;
        if(is_negative_1)
        {
            _S104 = i32(-1);
        }
        else
        {
            _S104 = i32(1);
        }
        var _S105 : i32;
        if(is_negative_1)
        {
            _S105 = min(guess_0[axis_7], voxel_4[axis_7]);
        }
        else
        {
            _S105 = max(guess_0[axis_7], voxel_4[axis_7]);
        }
        var _S106 : i32 = i32(is_negative_1);
        var i_0 : u32 = u32(0);
        var cell_2 : i32 = _S105;
        for(;;)
        {
            if(i_0 < u32(4))
            {
                _S102 = cell_2 != (voxel_4[axis_7]);
            }
            else
            {
                _S102 = false;
            }
            var _S107 : bool;
            if(_S102)
            {
                _S107 = !Crossing_is_before_0(crossing_of_0(ray_8, axis_7, cell_2 + _S106), first_3);
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
            var cell_3 : i32 = cell_2 - _S104;
            i_0 = i_0 + u32(1);
            cell_2 = cell_3;
        }
        var i_1 : u32 = u32(0);
        var cell_4 : i32 = cell_2;
        for(;;)
        {
            var _S108 : bool;
            if(i_1 < u32(4))
            {
                _S108 = Crossing_is_before_0(crossing_of_0(ray_8, axis_7, cell_4 + _S104 + _S106), first_3);
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
            var cell_5 : i32 = cell_4 + _S104;
            i_1 = i_1 + u32(1);
            cell_4 = cell_5;
        }
        arrival_0[axis_7] = cell_4;
        axis_7 = axis_7 + u32(1);
    }
    return arrival_0;
}

fn Walk_arrive_0( this_11 : Walk_0,  voxel_5 : vec3<i32>,  t_2 : f32,  is_axis_1 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    if(IS_EXACT_0)
    {
        var position_1 : vec3<f32> = clamp(this_11.ray_5.origin_6 + this_11.ray_5.direction_8 * vec3<f32>(t_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_1 : vec3<f32> = round(position_1);
        var from_nearest_1 : vec3<f32> = position_1 - nearest_1;
        var cell_6 : vec3<i32> = vec3<i32>(nearest_1) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f));
        if((any((select(vec3<bool>(false), (abs(position_1)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_1, (abs(from_nearest_1)) <= (this_11.tolerance_0)))))))
        {
            return leave_box_0(this_11.ray_5, voxel_5 + this_11.grid_origin_0, exit_1 + this_11.grid_origin_0, cell_6) - this_11.grid_origin_0;
        }
        return select(cell_6 - this_11.grid_origin_0, exit_1 - this_11.is_negative_0, is_axis_1);
    }
    var last_0 : vec3<i32> = exit_1 - vec3<i32>(i32(1)) + this_11.is_negative_0;
    return select(clamp(vec3<i32>(floor(clamp(this_11.origin_7 + this_11.ray_5.direction_8 * vec3<f32>(t_2), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f)))), min(voxel_5, last_0), max(voxel_5, last_0)), exit_1 - this_11.is_negative_0, is_axis_1);
}

fn Walk_enter_0( this_12 : Walk_0,  voxel_6 : ptr<function, vec3<i32>>,  low_6 : vec3<i32>,  high_4 : vec3<i32>) -> bool
{
    for(;;)
    {
        var is_below_0 : vec3<bool> = (*voxel_6) < low_6;
        var is_outside_0 : vec3<bool> = select((*voxel_6) >= high_4, vec3<bool>(true), is_below_0);
        if(!(any((is_outside_0))))
        {
            break;
        }
        var _S109 : vec3<i32> = vec3<i32>(i32(0));
        var _S110 : vec3<bool> = (this_12.is_negative_0) != _S109;
        if((any((select(vec3<bool>(false), select((this_12.ray_5.direction_8) == vec3<f32>(0.0f), vec3<bool>(true), !select(_S110, (this_12.is_negative_0) == _S109, is_below_0)), is_outside_0)))))
        {
            return false;
        }
        var plane_1 : vec3<i32> = select(high_4, low_6, is_below_0);
        var t_3 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_12, plane_1), is_outside_0);
        var t_last_0 : f32 = max_element_0(t_3);
        if(t_last_0 > (this_12.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_3.x) == t_last_0;
        var _S111 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S111)
        {
            is_y_0 = (t_3.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S112 : bool;
        if(_S111)
        {
            _S112 = !is_y_0;
        }
        else
        {
            _S112 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S112);
        (*voxel_6) = Walk_arrive_0(this_12, (*voxel_6), t_last_0, is_axis_2, select(select(vec3<i32>(i32(1073741823)), vec3<i32>(i32(-1073741824)), _S110), plane_1, is_axis_2));
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
    var low_7 : u32;
    var high_5 : u32;
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
        low_7 = row_0;
        high_5 = rows_0;
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
        low_7 = row_0;
        high_5 = rows_0;
    }
    return vec2<u32>((pair_0 & (low_7)), (pair_0 & (high_5)));
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
    var _S113 : u32 = (u32(1) << (block_1));
    var at_1 : u32 = record_0 + u32(2) + u32(2) * countOneBits((header_1 & ((_S113 - u32(1)))));
    var _S114 : u32 = bricks_0[at_1];
    var _S115 : u32 = bricks_0[at_1 + u32(1)];
    var mask_0 : vec2<u32> = vec2<u32>(_S114, _S115);
    var bit_2 : u32 = cell_in_node_0(relative_1, u32(0));
    var half_2 : u32;
    if(bit_2 < u32(32))
    {
        half_2 = _S114;
    }
    else
    {
        half_2 = _S115;
    }
    if(((((half_2 >> (((bit_2 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var in_block_0 : vec2<u32> = (mask_0 & ((voxels_ahead_0(octant_3, bit_2))));
    var _S116 : i32;
    if((((in_block_0.x) | ((in_block_0.y)))) == u32(0))
    {
        if(((ahead_0 & ((~_S113)))) == u32(0))
        {
            _S116 = i32(3);
        }
        else
        {
            _S116 = i32(2);
        }
        return u32(_S116);
    }
    if(((((half_2 >> (((bit_2 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S116 = i32(1);
    }
    else
    {
        _S116 = i32(0);
    }
    return u32(_S116);
}

fn Walk_leave_0( this_13 : Walk_0,  voxel_7 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_4 : vec3<f32> = Walk_crossings_0(this_13, exit_2);
    var _S117 : f32 = t_4.x;
    var _S118 : f32 = t_4.y;
    var _S119 : f32 = min(min(_S117, _S118), t_4.z);
    if(_S119 > (this_13.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = _S117 == _S119;
    var _S120 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S120)
    {
        is_y_1 = _S118 == _S119;
    }
    else
    {
        is_y_1 = false;
    }
    var _S121 : vec3<i32> = (*voxel_7);
    var _S122 : bool;
    if(_S120)
    {
        _S122 = !is_y_1;
    }
    else
    {
        _S122 = false;
    }
    (*voxel_7) = Walk_arrive_0(this_13, _S121, _S119, vec3<bool>(is_x_1, is_y_1, _S122), exit_2);
    return true;
}

fn first_voxel_0( _S123 : u32,  _S124 : LocalRay_0,  _S125 : ptr<function, vec3<i32>>) -> bool
{
    var _S126 : vec3<i32> = vec3<i32>(i32(0));
    (*_S125) = _S126;
    var _S127 : Walk_0 = walk_of_0(_S124, _S123);
    var voxel_8 : vec3<i32> = Walk_start_voxel_0(_S127);
    var _S128 : bool = Walk_enter_0(_S127, &(voxel_8), cell_of_0(grids_0[_S123].min_0) - _S127.grid_origin_0, cell_of_0(grids_0[_S123].max_0) - _S127.grid_origin_0);
    if(!_S128)
    {
        return false;
    }
    var _S129 : vec3<i32> = cell_of_0(grids_0[_S123].top_size_0);
    var node_at_0 : vec3<i32> = vec3<i32>(i32(-1));
    var node_4 : u32 = u32(0);
    for(;;)
    {
        var _S130 : vec3<u32> = vec3<u32>(u32(5));
        var node_at_1 : vec3<i32>;
        var cell_7 : u32;
        var shift_4 : u32;
        var shift_5 : u32;
        if((all((((voxel_8 >> (_S130))) == node_at_0))))
        {
            cell_7 = cells_0[node_4 + cell_in_node_0(voxel_8, u32(3))];
            node_at_1 = node_at_0;
            shift_5 = u32(3);
        }
        else
        {
            var _S131 : u32 = grids_0[_S123].top_shift_0;
            var top_1 : vec3<i32> = (voxel_8 >> (vec3<u32>(grids_0[_S123].top_shift_0)));
            if((any((vec3<u32>(top_1) >= vec3<u32>(_S129)))))
            {
                return false;
            }
            cell_7 = cells_0[grids_0[_S123].top_offset_0 + u32((top_1.z * _S129.y + top_1.y) * _S129.x + top_1.x)];
            node_at_1 = node_at_0;
            shift_4 = node_4;
            shift_5 = _S131;
            for(;;)
            {
                var _S132 : bool;
                if(shift_5 > u32(3))
                {
                    _S132 = ((cell_7 & (u32(2147483648)))) != u32(0);
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
                var node_5 : u32 = ((cell_7 & (u32(2147483647)))) * u32(64);
                var _S133 : u32 = cells_0[node_5 + cell_in_node_0(voxel_8, shift_6)];
                if(shift_6 == u32(3))
                {
                    node_at_1 = (voxel_8 >> (_S130));
                }
                cell_7 = _S133;
                shift_4 = node_5;
                shift_5 = shift_6;
            }
            node_4 = shift_4;
        }
        var count_6 : i32;
        if(((cell_7 & (u32(2147483648)))) == u32(0))
        {
            count_6 = leap_0((((cell_7 >> ((u32(3) * _S127.octant_0)))) & (u32(7))));
            shift_4 = shift_5;
        }
        else
        {
            var shift_7 : u32 = empty_around_0(((cell_7 & (u32(2147483647)))) * u32(2), voxel_8, _S127.octant_0);
            if(shift_7 == u32(4294967295))
            {
                (*_S125) = voxel_8 + _S127.grid_origin_0;
                return true;
            }
            count_6 = i32(1);
            shift_4 = shift_7;
        }
        var _S134 : bool = Walk_leave_0(_S127, &(voxel_8), ((((voxel_8 >> (vec3<u32>(shift_4)))) + select(vec3<i32>(count_6), vec3<i32>((i32(1) - count_6)), (_S127.is_negative_0) != _S126)) << (vec3<u32>(shift_4))));
        if(!_S134)
        {
            break;
        }
        node_at_0 = node_at_1;
    }
    return false;
}

fn Hit_x24init_0( t_5 : f32,  instance_5 : u32,  voxel_9 : vec3<i32>,  face_10 : u32) -> Hit_0
{
    var _S135 : Hit_0;
    _S135.t_1 = t_5;
    _S135.instance_2 = instance_5;
    _S135.voxel_2 = voxel_9;
    _S135.face_1 = face_10;
    return _S135;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn hit_of_0( ray_9 : LocalRay_0,  voxel_10 : vec3<i32>,  instance_6 : u32) -> Hit_0
{
    var last_1 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    var axis_8 : u32 = u32(0);
    for(;;)
    {
        if(axis_8 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S136 : u32 = axis_8;
        if((ray_9.direction_8[axis_8]) == 0.0f)
        {
            axis_8 = axis_8 + u32(1);
            continue;
        }
        var crossing_1 : Crossing_0 = crossing_of_0(ray_9, axis_8, voxel_10[axis_8] + i32((ray_9.direction_8[_S136]) < 0.0f));
        var _S137 : bool;
        if((last_1.axis_4) == u32(3))
        {
            _S137 = true;
        }
        else
        {
            _S137 = !Crossing_is_before_0(crossing_1, last_1);
        }
        var last_2 : Crossing_0;
        if(_S137)
        {
            last_2 = crossing_1;
        }
        else
        {
            last_2 = last_1;
        }
        last_1 = last_2;
        axis_8 = axis_8 + u32(1);
    }
    var _S138 : Crossing_0 = last_1;
    var is_negative_2 : bool = (ray_9.direction_8[last_1.axis_4]) < 0.0f;
    var t_6 : f32 = (f32(voxel_10[last_1.axis_4] + i32(is_negative_2)) - ray_9.origin_6[last_1.axis_4]) * ray_9.inverse_0[last_1.axis_4];
    var _S139 : f32;
    if(t_6 > (ray_9.t_min_3))
    {
        _S139 = t_6;
    }
    else
    {
        _S139 = ray_9.t_min_3;
    }
    return Hit_x24init_0(_S139, instance_6, voxel_10, u32(2) * _S138.axis_4 + u32(is_negative_2));
}

fn hit_in_0( instance_7 : u32,  ray_10 : Ray_0) -> Hit_0
{
    var _S140 : LocalRay_0 = local_ray_0(ray_10, instance_7);
    var voxel_11 : vec3<i32>;
    var _S141 : bool;
    if(!_S140.is_valid_0)
    {
        _S141 = true;
    }
    else
    {
        var _S142 : bool = first_voxel_0(instances_0[instance_7].grid_0, _S140, &(voxel_11));
        _S141 = !_S142;
    }
    if(_S141)
    {
        return miss_0();
    }
    var hit_5 : Hit_0 = hit_of_0(_S140, voxel_11, instance_7);
    if((hit_5.t_1) > (ray_10.t_max_1))
    {
        return miss_0();
    }
    return hit_5;
}

fn entry_0( _S143 : u32,  _S144 : Ray_0,  _S145 : vec3<f32>) -> f32
{
    var low_8 : vec3<f32> = (vector_of_0(instance_nodes_0[_S143].min_1) - _S144.origin_2) * _S145;
    var high_6 : vec3<f32> = (vector_of_0(instance_nodes_0[_S143].max_1) - _S144.origin_2) * _S145;
    var _S146 : f32 = max(_S144.t_min_1, max_element_0(min(low_8, high_6)));
    var last_3 : vec3<f32> = max(low_8, high_6);
    var _S147 : f32;
    if(_S146 <= (min(_S144.t_max_1, min(min(last_3.x, last_3.y), last_3.z))))
    {
        _S147 = _S146;
    }
    else
    {
        _S147 = (bitcast<f32>((u32(2139095040))));
    }
    return _S147;
}

fn visit_0( ray_11 : Ray_0,  is_any_enough_0 : bool) -> Hit_0
{
    var _S148 : Ray_0 = ray_11;
    if(IS_SINGLE_0)
    {
        return hit_in_0(u32(0), _S148);
    }
    var nearest_2 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_2;
    }
    var is_still_1 : vec3<bool> = !((abs(_S148.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S149 : vec3<f32> = select(vec3<f32>(1.0f) / select(_S148.direction_1, vec3<f32>(1.0f), is_still_1), vec3<f32>(3.4028234663852886e+38f), is_still_1);
    var stack_0 : array<u32, i32(32)>;
    var near_0 : u32 = u32(0);
    var nearest_3 : Hit_0 = nearest_2;
    var depth_1 : u32 = u32(0);
    for(;;)
    {
        var depth_2 : u32;
        if((instance_nodes_0[near_0].is_leaf_0) != u32(0))
        {
            var hit_6 : Hit_0 = hit_in_0(instance_nodes_0[near_0].index_0, _S148);
            var _S150 : Hit_0 = nearest_3;
            var _S151 : bool;
            if((hit_6.t_1) < (nearest_3.t_1))
            {
                _S151 = true;
            }
            else
            {
                if((hit_6.t_1) == (_S150.t_1))
                {
                    _S151 = (hit_6.instance_2) < (nearest_3.instance_2);
                }
                else
                {
                    _S151 = false;
                }
            }
            var nearest_4 : Hit_0;
            if(_S151)
            {
                _S148.t_max_1 = hit_6.t_1;
                if(is_any_enough_0)
                {
                    return hit_6;
                }
                nearest_4 = hit_6;
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
            var _S152 : u32 = near_0 + u32(1);
            var _S153 : f32 = entry_0(_S152, _S148, _S149);
            var _S154 : u32 = instance_nodes_0[near_0].index_0;
            var _S155 : f32 = entry_0(instance_nodes_0[near_0].index_0, _S148, _S149);
            var _S156 : bool = _S153 <= _S155;
            if(_S156)
            {
                near_0 = _S152;
            }
            else
            {
                near_0 = _S154;
            }
            var far_0 : u32;
            if(_S156)
            {
                far_0 = _S154;
            }
            else
            {
                far_0 = _S152;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S153, _S155)) < INFINITY_0)
            {
                var _S157 : u32 = depth_1 + u32(1);
                stack_0[depth_1] = far_0;
                depth_2 = _S157;
            }
            else
            {
                depth_2 = depth_1;
            }
            if((min(_S153, _S155)) < INFINITY_0)
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

fn WalkTracer_is_occluded_0( ray_12 : Ray_0) -> bool
{
    return !Hit_is_miss_0(visit_0(ray_12, true));
}

fn cosine_hemisphere_0( u_5 : f32,  v_3 : f32) -> vec3<f32>
{
    var radius_1 : f32 = sqrt(u_5);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(v_3);
    return vec3<f32>(radius_1 * sin_cos_1.y, radius_1 * sin_cos_1.x, sqrt(1.0f - u_5));
}

fn Surface_world_direction_0( this_14 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_14.face_4) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S158 : f32 = local_3.x;
    var _S159 : f32 = local_3.y;
    var _S160 : vec3<f32> = vec3<f32>(_S158, _S159, away_2);
    var in_grid_1 : vec3<f32>;
    if((this_14.face_4) < u32(2))
    {
        in_grid_1 = vec3<f32>(away_2, _S158, _S159);
    }
    else
    {
        if((this_14.face_4) < u32(4))
        {
            in_grid_1 = vec3<f32>(_S159, away_2, _S158);
        }
        else
        {
            in_grid_1 = _S160;
        }
    }
    return normalize_vector_0(Transform_direction_1(this_14.instance_4, in_grid_1));
}

fn PathTracing_advance_0( path_2 : ptr<function, Path_0>,  ray_13 : Ray_0,  hit_7 : Hit_0,  radiance_3 : ptr<function, vec3<f32>>,  next_0 : ptr<function, Ray_0>,  shadow_rays_0 : ptr<function, u32>) -> bool
{
    (*next_0) = ray_13;
    var last_4 : Receiver_0 = Receiver_x24init_0(ray_13.origin_2, (*path_2).normal_0);
    var light_pdf_1 : f32;
    var _S161 : bool;
    if(Hit_is_miss_0(hit_7))
    {
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sky_gradient_0(ray_13.direction_1);
        if(has_sun_0())
        {
            _S161 = sun_contains_0(ray_13.direction_1);
        }
        else
        {
            _S161 = false;
        }
        if(_S161)
        {
            if(((*path_2).bounce_0) == u32(0))
            {
                light_pdf_1 = 0.0f;
            }
            else
            {
                light_pdf_1 = light_sun_pdf_0(last_4);
            }
            (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * params_0.sun_radiance_0 * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
        }
        return false;
    }
    var material_2 : PackedMaterial_0 = material_of_0(hit_7);
    if((max_element_0(vector_of_0(material_2.emission_0))) > 0.0f)
    {
        if(((*path_2).bounce_0) == u32(0))
        {
            light_pdf_1 = 0.0f;
        }
        else
        {
            light_pdf_1 = light_emitter_pdf_0(last_4, ray_13, hit_7);
        }
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * emitted_0(material_2) * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
    }
    (*path_2).beta_0 = (*path_2).beta_0 * vector_of_0(material_2.base_color_0);
    var u_6 : vec4<f32> = Sampler_stratified_0((*path_2).sampler_0, Path_dimension_scatter_0((*path_2)));
    if(((*path_2).bounce_0) == (params_0.max_bounces_0))
    {
        _S161 = true;
    }
    else
    {
        _S161 = (max_element_0((*path_2).beta_0)) <= 0.0f;
    }
    if(_S161)
    {
        _S161 = true;
    }
    else
    {
        var _S162 : bool = survives_0(&((*path_2)), u_6.z);
        _S161 = !_S162;
    }
    if(_S161)
    {
        return false;
    }
    var surface_1 : Surface_0 = surface_of_0(ray_13, hit_7);
    var sample_5 : LightSample_0;
    var _S163 : bool = sample_light_0(Receiver_x24init_0(surface_1.origin_3, surface_1.normal_3), Sampler_stratified_0((*path_2).sampler_0, Path_dimension_light_0((*path_2))), &(sample_5));
    if(_S163)
    {
        var bounce_pdf_0 : f32 = cosine_hemisphere_pdf_0(sample_5.cos_theta_1);
        var share_0 : f32 = bounce_pdf_0 / sample_5.pdf_1 * power_heuristic_0(sample_5.pdf_1, bounce_pdf_0);
        (*shadow_rays_0) = (*shadow_rays_0) + u32(1);
        if(!WalkTracer_is_occluded_0(sample_5.ray_3))
        {
            (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sample_5.radiance_1 * vec3<f32>(share_0);
        }
    }
    var local_4 : vec3<f32> = cosine_hemisphere_0(u_6.x, u_6.y);
    (*path_2).pdf_0 = cosine_hemisphere_pdf_0(local_4.z);
    (*path_2).normal_0 = surface_1.normal_3;
    (*path_2).bounce_0 = (*path_2).bounce_0 + u32(1);
    (*next_0) = ray_from_0(surface_1.origin_3, Surface_world_direction_0(surface_1, local_4));
    return true;
}

fn Sampler_independent_0( this_15 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_15.pixel_0, this_15.sample_0, dimension_2, this_15.seed_1)));
}

fn Essay_clip_0( ray_14 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_14.origin_2, 0.10000000149011612f, ray_14.direction_1, 10000.0f);
}

fn Essay_advance_0( path_3 : ptr<function, Path_0>,  ray_15 : Ray_0,  hit_8 : Hit_0,  radiance_4 : ptr<function, vec3<f32>>,  next_1 : ptr<function, Ray_0>,  shadow_rays_1 : ptr<function, u32>) -> bool
{
    (*next_1) = ray_15;
    if(Hit_is_miss_0(hit_8))
    {
        (*radiance_4) = (*radiance_4) + (*path_3).beta_0 * sky_gradient_0(ray_15.direction_1);
        return false;
    }
    var material_3 : PackedMaterial_0 = material_of_0(hit_8);
    if((max_element_0(vector_of_0(material_3.emission_0))) > 0.0f)
    {
        (*radiance_4) = (*radiance_4) + (*path_3).beta_0 * emitted_0(material_3);
        return false;
    }
    if(((*path_3).bounce_0) == (params_0.max_bounces_0))
    {
        return false;
    }
    var u_7 : vec4<f32> = Sampler_independent_0((*path_3).sampler_0, Path_dimension_scatter_0((*path_3)));
    var surface_2 : Surface_0 = surface_of_0(ray_15, hit_8);
    (*path_3).beta_0 = (*path_3).beta_0 * vector_of_0(material_3.base_color_0);
    (*path_3).bounce_0 = (*path_3).bounce_0 + u32(1);
    (*next_1) = Essay_clip_0(ray_from_0(surface_2.origin_3, Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_7.x, u_7.y))));
    return true;
}

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
    var _S164 : RayCounts_0;
    _S164.camera_0 = camera_1;
    _S164.bounce_1 = bounce_2;
    _S164.shadow_0 = shadow_1;
    return _S164;
}

fn Sampler_x24init_0( seed_3 : u32,  pixel_1 : u32,  sample_6 : u32) -> Sampler_0
{
    var _S165 : Sampler_0;
    _S165.seed_1 = seed_3;
    _S165.pixel_0 = pixel_1;
    _S165.sample_0 = sample_6;
    return _S165;
}

fn PathTracing_jitter_0( sampler_1 : Sampler_0) -> vec4<f32>
{
    return Sampler_stratified_0(sampler_1, u32(0));
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
    var _S166 : CameraFrame_0;
    _S166.eye_1 = eye_2;
    _S166.corner_1 = corner_2;
    _S166.pixel_x_1 = pixel_x_2;
    _S166.pixel_y_1 = pixel_y_2;
    return _S166;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0);
}

fn CameraFrame_ray_0( this_16 : CameraFrame_0,  position_2 : vec2<f32>) -> Ray_0
{
    var direction_9 : vec3<f32> = this_16.corner_1 + this_16.pixel_x_1 * vec3<f32>(position_2.x) + this_16.pixel_y_1 * vec3<f32>(position_2.y);
    return ray_from_0(this_16.eye_1, direction_9 * vec3<f32>((1.0f / sqrt(length_squared_0(direction_9)))));
}

fn PathTracing_clip_0( ray_16 : Ray_0) -> Ray_0
{
    return ray_16;
}

fn Path_x24init_0( sampler_2 : Sampler_0,  bounce_3 : u32,  beta_1 : vec3<f32>,  pdf_3 : f32,  normal_4 : vec3<f32>) -> Path_0
{
    var _S167 : Path_0;
    _S167.sampler_0 = sampler_2;
    _S167.bounce_0 = bounce_3;
    _S167.beta_0 = beta_1;
    _S167.pdf_0 = pdf_3;
    _S167.normal_0 = normal_4;
    return _S167;
}

fn WalkTracer_trace_0( ray_17 : Ray_0) -> Hit_0
{
    return visit_0(ray_17, false);
}

fn fixed_point_0( value_2 : f32) -> vec2<u32>
{
    if(!(value_2 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_2 : u32 = (bitcast<u32>((min(value_2, 1.048576e+06f))));
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
        var _S168 : u32 = (mantissa_0 << (u32(shift_8)));
        var _S169 : u32;
        if(shift_8 == i32(0))
        {
            _S169 = u32(0);
        }
        else
        {
            _S169 = (mantissa_0 >> (u32(i32(32) - shift_8)));
        }
        return vec2<u32>(_S168, _S169);
    }
    return vec2<u32>(u32(0), (mantissa_0 << (u32(shift_8 - i32(32)))));
}

fn PixelRecord_add_0( this_17 : ptr<function, PixelRecord_0>,  value_3 : vec3<f32>,  is_covered_0 : bool)
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
        var addend_0 : vec2<u32> = fixed_point_0(value_3[channel_0]);
        var _S170 : u32 = u32(2) * channel_0;
        var _S171 : u32 = addend_0.x;
        var low_9 : u32 = (*this_17).radiance_0[_S170] + _S171;
        var high_7 : u32 = (*this_17).radiance_0[_S170 + u32(1)] + addend_0.y + u32(low_9 < _S171);
        var is_full_0 : bool = high_7 < ((*this_17).radiance_0[_S170 + u32(1)]);
        var _S172 : u32;
        if(is_full_0)
        {
            _S172 = u32(4294967295);
        }
        else
        {
            _S172 = low_9;
        }
        (*this_17).radiance_0[_S170] = _S172;
        var _S173 : u32;
        if(is_full_0)
        {
            _S173 = u32(4294967295);
        }
        else
        {
            _S173 = high_7;
        }
        (*this_17).radiance_0[_S170 + u32(1)] = _S173;
        channel_0 = channel_0 + u32(1);
    }
    (*this_17).samples_1 = (*this_17).samples_1 + u32(1);
    (*this_17).covered_0 = (*this_17).covered_0 + u32(is_covered_0);
    return;
}

fn trace_pixel_0( index_7 : u32) -> RayCounts_0
{
    var region_1 : vec4<u32> = params_0.region_0;
    var _S174 : u32 = params_0.region_0.x;
    var columns_0 : u32 = params_0.region_0.z - _S174;
    var _S175 : u32 = index_7 % columns_0;
    var _S176 : u32 = _S174 + _S175;
    var _S177 : u32 = region_1.y;
    var _S178 : u32 = index_7 / columns_0;
    var _S179 : u32 = _S177 + _S178;
    var pixel_2 : PixelRecord_0;
    pixel_2.radiance_0 = pixels_0[index_7].radiance_0;
    pixel_2.samples_1 = pixels_0[index_7].samples_1;
    pixel_2.covered_0 = pixels_0[index_7].covered_0;
    var _S180 : u32 = min(dispatch_0.samples_target_0, pixel_2.samples_1 + dispatch_0.samples_0);
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    for(;;)
    {
        if((pixel_2.samples_1) < _S180)
        {
        }
        else
        {
            break;
        }
        var sampler_3 : Sampler_0 = Sampler_x24init_0(params_0.seed_0, _S179 * params_0.width_0 + _S176, params_0.first_sample_0 + pixel_2.samples_1);
        var jitter_0 : vec4<f32> = PathTracing_jitter_0(sampler_3);
        var ray_18 : Ray_0 = PathTracing_clip_0(CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(f32(_S176) + jitter_0.x, f32(_S179) + jitter_0.y)));
        var _S181 : vec3<f32> = vec3<f32>(0.0f);
        var path_4 : Path_0 = Path_x24init_0(sampler_3, u32(0), vec3<f32>(1.0f), 0.0f, _S181);
        var radiance_5 : vec3<f32> = _S181;
        counts_0.camera_0 = counts_0.camera_0 + u32(1);
        var _S182 : Hit_0 = WalkTracer_trace_0(ray_18);
        var is_covered_1 : bool = !Hit_is_miss_0(_S182);
        var _S183 : bool;
        if(is_covered_1)
        {
            _S183 = true;
        }
        else
        {
            _S183 = (params_0.is_transparent_0) == u32(0);
        }
        var goes_on_0 : bool = _S183;
        var ray_19 : Ray_0 = ray_18;
        var hit_9 : Hit_0 = _S182;
        for(;;)
        {
            if(goes_on_0)
            {
            }
            else
            {
                break;
            }
            var next_2 : Ray_0 = ray_19;
            var _S184 : u32 = counts_0.shadow_0;
            var _S185 : bool = PathTracing_advance_0(&(path_4), ray_19, hit_9, &(radiance_5), &(next_2), &(_S184));
            counts_0.shadow_0 = _S184;
            if(_S185)
            {
                counts_0.bounce_1 = counts_0.bounce_1 + u32(1);
                var _S186 : Hit_0 = WalkTracer_trace_0(next_2);
                ray_19 = next_2;
                hit_9 = _S186;
            }
            goes_on_0 = _S185;
        }
        PixelRecord_add_0(&(pixel_2), radiance_5, is_covered_1);
    }
    pixels_0[index_7].radiance_0 = pixel_2.radiance_0;
    pixels_0[index_7].samples_1 = pixel_2.samples_1;
    pixels_0[index_7].covered_0 = pixel_2.covered_0;
    return counts_0;
}

fn Essay_jitter_0( sampler_4 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_4, u32(0));
}

fn trace_pixel_1( index_8 : u32) -> RayCounts_0
{
    var region_2 : vec4<u32> = params_0.region_0;
    var _S187 : u32 = params_0.region_0.x;
    var columns_1 : u32 = params_0.region_0.z - _S187;
    var _S188 : u32 = index_8 % columns_1;
    var _S189 : u32 = _S187 + _S188;
    var _S190 : u32 = region_2.y;
    var _S191 : u32 = index_8 / columns_1;
    var _S192 : u32 = _S190 + _S191;
    var pixel_3 : PixelRecord_0;
    pixel_3.radiance_0 = pixels_0[index_8].radiance_0;
    pixel_3.samples_1 = pixels_0[index_8].samples_1;
    pixel_3.covered_0 = pixels_0[index_8].covered_0;
    var _S193 : u32 = min(dispatch_0.samples_target_0, pixel_3.samples_1 + dispatch_0.samples_0);
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    for(;;)
    {
        if((pixel_3.samples_1) < _S193)
        {
        }
        else
        {
            break;
        }
        var sampler_5 : Sampler_0 = Sampler_x24init_0(params_0.seed_0, _S192 * params_0.width_0 + _S189, params_0.first_sample_0 + pixel_3.samples_1);
        var jitter_1 : vec4<f32> = Essay_jitter_0(sampler_5);
        var ray_20 : Ray_0 = Essay_clip_0(CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(f32(_S189) + jitter_1.x, f32(_S192) + jitter_1.y)));
        var _S194 : vec3<f32> = vec3<f32>(0.0f);
        var path_5 : Path_0 = Path_x24init_0(sampler_5, u32(0), vec3<f32>(1.0f), 0.0f, _S194);
        var radiance_6 : vec3<f32> = _S194;
        counts_1.camera_0 = counts_1.camera_0 + u32(1);
        var _S195 : Hit_0 = WalkTracer_trace_0(ray_20);
        var is_covered_2 : bool = !Hit_is_miss_0(_S195);
        var _S196 : bool;
        if(is_covered_2)
        {
            _S196 = true;
        }
        else
        {
            _S196 = (params_0.is_transparent_0) == u32(0);
        }
        var goes_on_1 : bool = _S196;
        var ray_21 : Ray_0 = ray_20;
        var hit_10 : Hit_0 = _S195;
        for(;;)
        {
            if(goes_on_1)
            {
            }
            else
            {
                break;
            }
            var next_3 : Ray_0 = ray_21;
            var _S197 : u32 = counts_1.shadow_0;
            var _S198 : bool = Essay_advance_0(&(path_5), ray_21, hit_10, &(radiance_6), &(next_3), &(_S197));
            counts_1.shadow_0 = _S197;
            if(_S198)
            {
                counts_1.bounce_1 = counts_1.bounce_1 + u32(1);
                var _S199 : Hit_0 = WalkTracer_trace_0(next_3);
                ray_21 = next_3;
                hit_10 = _S199;
            }
            goes_on_1 = _S198;
        }
        PixelRecord_add_0(&(pixel_3), radiance_6, is_covered_2);
    }
    pixels_0[index_8].radiance_0 = pixel_3.radiance_0;
    pixels_0[index_8].samples_1 = pixel_3.samples_1;
    pixels_0[index_8].covered_0 = pixel_3.covered_0;
    return counts_1;
}

var<workgroup> group_counts_0 : array<atomic<u32>, i32(3)>;

fn count_7( counts_2 : RayCounts_0,  thread_0 : u32)
{
    var _S200 : bool = thread_0 < u32(3);
    if(_S200)
    {
        atomicStore(&(group_counts_0[thread_0]), u32(0));
    }
    workgroupBarrier();
    var _S201 : u32 = atomicAdd(&(group_counts_0[i32(0)]), counts_2.camera_0);
    var _S202 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_2.bounce_1);
    var _S203 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_2.shadow_0);
    workgroupBarrier();
    if(_S200)
    {
        var _S204 : u32 = atomicLoad(&(group_counts_0[thread_0]));
        var _S205 : u32 = atomicAdd(&(counters_0[u32(1) + thread_0]), _S204);
    }
    if(thread_0 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S206 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var _S207 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S208 : u32 = id_0.x;
    var counts_3 : RayCounts_0;
    if(_S208 < (dispatch_0.count_0))
    {
        var _S209 : RayCounts_0 = trace_pixel_1(dispatch_0.first_0 + _S208);
        counts_3 = _S209;
    }
    else
    {
        counts_3 = _S207;
    }
    count_7(counts_3, thread_1);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_path(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_2 : u32)
{
    var _S210 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S211 : u32 = id_1.x;
    var counts_4 : RayCounts_0;
    if(_S211 < (dispatch_0.count_0))
    {
        var _S212 : RayCounts_0 = trace_pixel_0(dispatch_0.first_0 + _S211);
        counts_4 = _S212;
    }
    else
    {
        counts_4 = _S210;
    }
    count_7(counts_4, thread_2);
    return;
}

struct HitRecord_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : array<i32, i32(3)>,
     face_0 : u32,
};

fn HitRecord_x24init_0( t_7 : f32,  instance_8 : u32,  voxel_12 : array<i32, i32(3)>,  face_11 : u32) -> HitRecord_0
{
    var _S213 : HitRecord_0;
    _S213.t_0 = t_7;
    _S213.instance_0 = instance_8;
    _S213.voxel_0 = voxel_12;
    _S213.face_0 = face_11;
    return _S213;
}

fn record_of_0( hit_11 : Hit_0) -> HitRecord_0
{
    var _S214 : array<i32, i32(3)> = array<i32, i32(3)>( hit_11.voxel_2.x, hit_11.voxel_2.y, hit_11.voxel_2.z );
    return HitRecord_x24init_0(hit_11.t_1, hit_11.instance_2, _S214, hit_11.face_1);
}

fn ray_of_0( _S215 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S215].origin_0), rays_0[_S215].t_min_0, vector_of_0(rays_0[_S215].direction_0), rays_0[_S215].t_max_0);
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    var counts_5 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S216 : u32 = id_2.x;
    if(_S216 < (dispatch_0.count_0))
    {
        var _S217 : HitRecord_0 = record_of_0(WalkTracer_trace_0(ray_of_0(dispatch_0.first_0 + _S216)));
        hits_0[dispatch_0.first_0 + _S216].t_0 = _S217.t_0;
        hits_0[dispatch_0.first_0 + _S216].instance_0 = _S217.instance_0;
        hits_0[dispatch_0.first_0 + _S216].voxel_0 = _S217.voxel_0;
        hits_0[dispatch_0.first_0 + _S216].face_0 = _S217.face_0;
        counts_5.camera_0 = u32(1);
    }
    count_7(counts_5, thread_3);
    return;
}

