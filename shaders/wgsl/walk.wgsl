struct Dispatch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) count_0 : u32,
    @align(8) samples_0 : u32,
    @align(4) samples_target_0 : u32,
    @align(16) padding_0 : vec3<u32>,
    @align(4) sequence_0 : u32,
};

@binding(16) @group(0) var<uniform> dispatch_0 : Dispatch_std140_0;
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

@binding(15) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

struct HitRecord_std430_0
{
    @align(4) t_0 : f32,
    @align(4) instance_0 : u32,
    @align(4) voxel_0 : array<i32, i32(3)>,
    @align(4) face_0 : u32,
};

@binding(12) @group(0) var<storage, read_write> hits_0 : array<HitRecord_std430_0>;

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

@id(1) override IS_SINGLE_0 : bool = false;

fn point_off_face_0( translation_1 : vec3<f32>,  low_4 : vec3<f32>,  face_5 : u32,  point_2 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = clamp((max_element_0(abs(low_4) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
    var _S52 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_2, low_4 + _S52), low_4 + vec3<f32>((1.0f - margin_0)));
    var _S53 : bool = face_5 < u32(2);
    var _S54 : bool;
    if(face_5 >= u32(2))
    {
        _S54 = face_5 < u32(4);
    }
    else
    {
        _S54 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S53, _S54, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_4 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_4 - _S52;
    }
    return select(moved_0, outside_0, is_axis_0);
}

fn face_normal_0( face_6 : u32) -> vec3<f32>
{
    var away_0 : f32;
    if(((face_6 & (u32(1)))) == u32(1))
    {
        away_0 = 1.0f;
    }
    else
    {
        away_0 = -1.0f;
    }
    var _S55 : f32;
    if(face_6 < u32(2))
    {
        _S55 = away_0;
    }
    else
    {
        _S55 = 0.0f;
    }
    var _S56 : bool;
    if(face_6 >= u32(2))
    {
        _S56 = face_6 < u32(4);
    }
    else
    {
        _S56 = false;
    }
    var _S57 : f32;
    if(_S56)
    {
        _S57 = away_0;
    }
    else
    {
        _S57 = 0.0f;
    }
    if(face_6 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S55, _S57, away_0);
}

fn Transform_direction_1( _S58 : u32,  _S59 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S58].world_from_grid_0.x_axis_0) * vec3<f32>(_S59.x) + vector_of_0(instances_0[_S58].world_from_grid_0.y_axis_0) * vec3<f32>(_S59.y) + vector_of_0(instances_0[_S58].world_from_grid_0.z_axis_0) * vec3<f32>(_S59.z);
}

fn Transform_point_1( _S60 : u32,  _S61 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S60, _S61) + vector_of_0(instances_0[_S60].world_from_grid_0.translation_0);
}

fn world_normal_0( _S62 : u32,  _S63 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S62, face_normal_0(_S63)));
}

fn surface_of_0( ray_2 : Ray_0,  hit_4 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S64 : vec3<f32> = vec3<f32>(hit_4.voxel_2);
    if(IS_SINGLE_0)
    {
        surface_0.origin_3 = point_off_face_0(vec3<f32>(0.0f), _S64, hit_4.face_1, ray_2.origin_2 + ray_2.direction_1 * vec3<f32>(hit_4.t_1));
        surface_0.normal_3 = face_normal_0(hit_4.face_1);
    }
    else
    {
        surface_0.origin_3 = Transform_point_1(hit_4.instance_2, point_off_face_0(vector_of_0(instances_0[hit_4.instance_2].grid_from_world_0.translation_0), _S64, hit_4.face_1, Transform_point_0(hit_4.instance_2, ray_2.origin_2) + Transform_direction_0(hit_4.instance_2, ray_2.direction_1) * vec3<f32>(hit_4.t_1)));
        surface_0.normal_3 = world_normal_0(hit_4.instance_2, hit_4.face_1);
    }
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
    var _S65 : Ray_0;
    _S65.origin_2 = origin_4;
    _S65.t_min_1 = t_min_2;
    _S65.direction_1 = direction_4;
    _S65.t_max_1 = t_max_2;
    return _S65;
}

fn ray_from_0( origin_5 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_5, 0.0f, direction_5, (bitcast<f32>((u32(2139095040)))));
}

fn LightSample_x24init_0( ray_4 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S66 : LightSample_0;
    _S66.ray_3 = ray_4;
    _S66.cos_theta_1 = cos_theta_2;
    _S66.radiance_1 = radiance_2;
    _S66.pdf_1 = pdf_2;
    return _S66;
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
    var _S67 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S67, 0.0f, _S67, 0.0f), 0.0f, _S67, 0.0f);
}

struct FaceChoice_0
{
     emitter_0 : u32,
     face_7 : u32,
     importance_0 : f32,
};

fn FaceChoice_x24init_0( emitter_1 : u32,  face_8 : u32,  importance_1 : f32) -> FaceChoice_0
{
    var _S68 : FaceChoice_0;
    _S68.emitter_0 = emitter_1;
    _S68.face_7 = face_8;
    _S68.importance_0 = importance_1;
    return _S68;
}

fn choose_face_0( first_2 : u32,  count_5 : u32,  receiver_8 : Receiver_0,  threshold_0 : f32) -> FaceChoice_0
{
    var _S69 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), u32(0), 0.0f);
    var is_found_0 : bool = false;
    var chosen_0 : FaceChoice_0 = _S69;
    var index_6 : u32 = first_2;
    var passed_0 : f32 = 0.0f;
    for(;;)
    {
        var _S70 : bool;
        if(index_6 < (first_2 + count_5))
        {
            _S70 = !is_found_0;
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
        var is_found_1 : bool = is_found_0;
        var chosen_1 : FaceChoice_0 = chosen_0;
        var face_9 : u32 = u32(0);
        var passed_1 : f32 = passed_0;
        for(;;)
        {
            var _S71 : bool;
            if(face_9 < u32(6))
            {
                _S71 = !is_found_1;
            }
            else
            {
                _S71 = false;
            }
            if(_S71)
            {
            }
            else
            {
                break;
            }
            if((((((emitters_0[index_6].faces_0) >> (face_9))) & (u32(1)))) == u32(0))
            {
                face_9 = face_9 + u32(1);
                continue;
            }
            var _S72 : f32 = face_importance_0(index_6, face_9, receiver_8);
            var is_found_2 : bool;
            var chosen_2 : FaceChoice_0;
            var passed_2 : f32;
            if(_S72 > 0.0f)
            {
                var _S73 : FaceChoice_0 = FaceChoice_x24init_0(index_6, face_9, _S72);
                var passed_3 : f32 = passed_1 + _S72;
                is_found_2 = threshold_0 < passed_3;
                chosen_2 = _S73;
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
            face_9 = face_9 + u32(1);
        }
        var _S74 : u32 = index_6 + u32(1);
        is_found_0 = is_found_1;
        chosen_0 = chosen_1;
        index_6 = _S74;
        passed_0 = passed_1;
    }
    return chosen_0;
}

fn point_of_face_0( low_5 : vec3<f32>,  face_10 : u32,  u_2 : f32,  v_2 : f32) -> vec3<f32>
{
    var away_1 : f32;
    if(((face_10 & (u32(1)))) == u32(1))
    {
        away_1 = 1.0f;
    }
    else
    {
        away_1 = 0.0f;
    }
    if(face_10 < u32(2))
    {
        return low_5 + vec3<f32>(away_1, u_2, v_2);
    }
    if(face_10 < u32(4))
    {
        return low_5 + vec3<f32>(u_2, away_1, v_2);
    }
    return low_5 + vec3<f32>(u_2, v_2, away_1);
}

fn sample_emitter_0( receiver_9 : Receiver_0,  u_3 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    (*sample_3) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var _S75 : f32 = u_3.x;
    var node_2 : u32 = u32(0);
    var choice_0 : f32 = _S75;
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
    var _S76 : u32 = emitters_0[chosen_3.emitter_0].instance_1;
    var _S77 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[chosen_3.emitter_0].voxel_1));
    var on_face_0 : vec3<f32> = point_of_face_0(_S77, chosen_3.face_7, u_3.z, u_3.w);
    var area_pdf_1 : f32 = face_pdf_0(on_face_0 - local_1.point_0, chosen_3.face_7);
    if(area_pdf_1 < 0.0f)
    {
        return false;
    }
    var direction_7 : vec3<f32> = Transform_point_1(_S76, point_off_face_0(vector_of_0(instances_0[emitters_0[chosen_3.emitter_0].instance_1].grid_from_world_0.translation_0), _S77, chosen_3.face_7, on_face_0)) - receiver_9.point_0;
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
        var _S78 : bool = sample_sun_0(receiver_10, u_4.z, u_4.w, &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * of_sun_0;
        is_found_3 = _S78;
    }
    else
    {
        var _S79 : f32 = 1.0f - of_sun_0;
        var _S80 : bool = sample_emitter_0(receiver_10, vec4<f32>(min((u_4.x - of_sun_0) / _S79, 0.99999994039535522f), u_4.yzw), &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * _S79;
        is_found_3 = _S80;
    }
    return is_found_3;
}

fn cosine_hemisphere_pdf_0( cos_theta_5 : f32) -> f32
{
    return max(cos_theta_5, 0.0f) * 0.31830987334251404f;
}

struct LocalRay_0
{
     origin_6 : vec3<f32>,
     direction_8 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_3 : f32,
     t_max_3 : f32,
     is_valid_0 : bool,
};

fn local_ray_0( _S81 : Ray_0,  _S82 : u32) -> LocalRay_0
{
    var local_2 : LocalRay_0;
    var direction_9 : vec3<f32>;
    var origin_7 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S83 : vec3<f32> = Transform_point_0(_S82, _S81.origin_2);
        direction_9 = Transform_direction_0(_S82, _S81.direction_1);
        origin_7 = _S83;
    }
    else
    {
        direction_9 = _S81.direction_1;
        origin_7 = _S81.origin_2;
    }
    var is_still_0 : vec3<bool> = !((abs(direction_9)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S84 : vec3<f32> = select(direction_9, vec3<f32>(0.0f), is_still_0);
    local_2.direction_8 = _S84;
    local_2.inverse_0 = select(vec3<f32>(1.0f) / select(direction_9, vec3<f32>(1.0f), is_still_0), vec3<f32>(3.4028234663852886e+38f), is_still_0);
    local_2.origin_6 = select(origin_7, floor(origin_7) + vec3<f32>(0.5f), is_still_0);
    var speed_0 : f32 = max_element_0(abs(_S84));
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
    if((_S81.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S81.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S81.t_min_1) <= (_S81.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_2.t_min_3 = _S81.t_min_1;
    local_2.t_max_3 = _S81.t_max_1;
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
     origin_8 : vec3<f32>,
     offset_0 : vec3<i32>,
     speed_1 : vec3<f32>,
     inverse_1 : vec3<f32>,
     grid_origin_0 : vec3<i32>,
     tolerance_0 : vec3<f32>,
     mirror_0 : vec3<i32>,
     t_end_0 : f32,
};

@id(0) override IS_EXACT_0 : bool = true;

fn Walk_mirrored_plane_0( this_5 : Walk_0,  plane_0 : vec3<i32>) -> vec3<i32>
{
    return ((plane_0 ^ ((this_5.mirror_0)))) - this_5.mirror_0;
}

fn LocalRay_tolerance_0( this_6 : LocalRay_0,  grid_min_0 : vec3<i32>,  grid_max_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_6.origin_6) + (vec3<f32>(max(abs(grid_min_0), abs(grid_max_0))) + vec3<f32>(1.0f))) * vec3<f32>(3.5762786865234375e-07f), vec3<f32>(-1.0f), (this_6.direction_8) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_3 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S85 : LocalRay_0,  _S86 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_5 = _S85;
    walk_0.grid_origin_0 = cell_of_0(grids_0[_S86].origin_1);
    var is_negative_0 : vec3<bool> = (_S85.direction_8) < vec3<f32>(0.0f);
    var _S87 : vec3<i32> = vec3<i32>(i32(0));
    walk_0.mirror_0 = select(_S87, vec3<i32>(i32(-1)), is_negative_0);
    var _S88 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S88 = Walk_mirrored_plane_0(walk_0, walk_0.grid_origin_0);
    }
    else
    {
        _S88 = _S87;
    }
    walk_0.offset_0 = _S88;
    var origin_9 : vec3<f32>;
    if(IS_EXACT_0)
    {
        origin_9 = _S85.origin_6;
    }
    else
    {
        origin_9 = _S85.origin_6 - vec3<f32>(walk_0.grid_origin_0);
    }
    walk_0.origin_8 = select(origin_9, (vec3<f32>(0) - origin_9), is_negative_0);
    walk_0.speed_1 = abs(_S85.direction_8);
    walk_0.inverse_1 = abs(_S85.inverse_0);
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S85, cell_of_0(grids_0[_S86].min_0), cell_of_0(grids_0[_S86].max_0));
    walk_0.t_end_0 = LocalRay_t_end_0(_S85);
    return walk_0;
}

fn Walk_mirrored_0( this_8 : Walk_0,  voxel_3 : vec3<i32>) -> vec3<i32>
{
    return (voxel_3 ^ ((this_8.mirror_0)));
}

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
    var _S89 : f32 = a_parts_0.x;
    var _S90 : f32 = b_parts_0.x;
    var _S91 : f32 = b_parts_0.y;
    var _S92 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S89 * _S90 - product_0 + _S89 * _S91 + _S92 * _S90 + _S92 * _S91);
}

fn exact_start_voxel_0( ray_6 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(0)]);
    var _S93 : f32 = way_0.x;
    var sum_4 : f32 = ray_6.origin_6[u32(0)] + _S93;
    var part_0 : f32 = sum_4 - ray_6.origin_6[u32(0)];
    var low_6 : f32 = ray_6.origin_6[u32(0)] - (sum_4 - part_0) + (_S93 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_4);
    var voxel_4 : vec3<i32>;
    var _S94 : i32 = i32(whole_0);
    var _S95 : bool;
    if(sum_4 == whole_0)
    {
        _S95 = low_6 < 0.0f;
    }
    else
    {
        _S95 = false;
    }
    voxel_4[u32(0)] = _S94 - i32(_S95);
    var way_1 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(1)]);
    var _S96 : f32 = way_1.x;
    var sum_5 : f32 = ray_6.origin_6[u32(1)] + _S96;
    var part_1 : f32 = sum_5 - ray_6.origin_6[u32(1)];
    var low_7 : f32 = ray_6.origin_6[u32(1)] - (sum_5 - part_1) + (_S96 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_5);
    var _S97 : i32 = i32(whole_1);
    if(sum_5 == whole_1)
    {
        _S95 = low_7 < 0.0f;
    }
    else
    {
        _S95 = false;
    }
    voxel_4[u32(1)] = _S97 - i32(_S95);
    var way_2 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(2)]);
    var _S98 : f32 = way_2.x;
    var sum_6 : f32 = ray_6.origin_6[u32(2)] + _S98;
    var part_2 : f32 = sum_6 - ray_6.origin_6[u32(2)];
    var low_8 : f32 = ray_6.origin_6[u32(2)] - (sum_6 - part_2) + (_S98 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_6);
    var _S99 : i32 = i32(whole_2);
    if(sum_6 == whole_2)
    {
        _S95 = low_8 < 0.0f;
    }
    else
    {
        _S95 = false;
    }
    voxel_4[u32(2)] = _S99 - i32(_S95);
    return voxel_4;
}

fn Walk_start_voxel_0( this_9 : Walk_0) -> vec3<i32>
{
    var start_2 : vec3<f32> = clamp(this_9.ray_5.origin_6 + this_9.ray_5.direction_8 * vec3<f32>(this_9.ray_5.t_min_3), vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
    if(!IS_EXACT_0)
    {
        return Walk_mirrored_0(this_9, vec3<i32>(floor(start_2)) - this_9.grid_origin_0);
    }
    var nearest_0 : vec3<f32> = round(start_2);
    var from_nearest_0 : vec3<f32> = start_2 - nearest_0;
    var _S100 : bool;
    if((this_9.ray_5.t_min_3) > 0.0f)
    {
        _S100 = (any(((abs(from_nearest_0)) <= (this_9.tolerance_0))));
    }
    else
    {
        _S100 = false;
    }
    if(_S100)
    {
        return Walk_mirrored_0(this_9, exact_start_voxel_0(this_9.ray_5) - this_9.grid_origin_0);
    }
    return Walk_mirrored_0(this_9, vec3<i32>(nearest_0) - vec3<i32>(from_nearest_0 < vec3<f32>(0.0f)) - this_9.grid_origin_0);
}

fn Walk_crossings_0( this_10 : Walk_0,  planes_0 : vec3<i32>) -> vec3<f32>
{
    return (vec3<f32>(planes_0 + this_10.offset_0) - this_10.origin_8) * this_10.inverse_1;
}

struct Crossing_0
{
     distance_3 : f32,
     distance_low_0 : f32,
     speed_2 : f32,
     axis_3 : u32,
};

fn Crossing_x24init_0( distance_4 : f32,  distance_low_1 : f32,  speed_3 : f32,  axis_4 : u32) -> Crossing_0
{
    var _S101 : Crossing_0;
    _S101.distance_3 = distance_4;
    _S101.distance_low_0 = distance_low_1;
    _S101.speed_2 = speed_3;
    _S101.axis_3 = axis_4;
    return _S101;
}

fn crossing_of_0( ray_7 : LocalRay_0,  axis_5 : u32,  plane_1 : i32) -> Crossing_0
{
    var sign_1 : f32;
    if((ray_7.direction_8[axis_5]) < 0.0f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var at_0 : f32 = f32(plane_1);
    var difference_1 : f32 = at_0 - ray_7.origin_6[axis_5];
    var part_3 : f32 = difference_1 - at_0;
    return Crossing_x24init_0(difference_1 * sign_1, (at_0 - (difference_1 - part_3) - (ray_7.origin_6[axis_5] + part_3)) * sign_1, abs(ray_7.direction_8[axis_5]), axis_5);
}

fn Crossing_is_before_0( this_11 : Crossing_0,  other_1 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_11.distance_3, other_1.speed_2);
    var theirs_0 : vec2<f32> = exact_product_0(other_1.distance_3, this_11.speed_2);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_11.distance_low_0 * other_1.speed_2;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_1.distance_low_0 * this_11.speed_2;
    }
    var difference_2 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S102 : bool;
    if(difference_2 < 0.0f)
    {
        _S102 = true;
    }
    else
    {
        if(difference_2 == 0.0f)
        {
            _S102 = (this_11.axis_3) < (other_1.axis_3);
        }
        else
        {
            _S102 = false;
        }
    }
    return _S102;
}

fn leave_box_0( ray_8 : LocalRay_0,  voxel_5 : vec3<i32>,  exit_0 : vec3<i32>,  guess_0 : vec3<i32>) -> vec3<i32>
{
    var _S103 : vec3<f32>;
    var _S104 : f32;
    var _S105 : bool;
    var _S106 : bool;
    var first_3 : Crossing_0;
    var _S107 : f32;
    var _S108 : bool;
    var _S109 : f32;
    var _S110 : bool;
    var _S111 : bool;
    var _S112 : i32;
    var cell_2 : i32;
    var i_0 : u32;
    var _S113 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S103 = ray_8.direction_8;
                _S104 = ray_8.direction_8[u32(0)];
                var _S114 : bool = (ray_8.direction_8[u32(0)]) == 0.0f;
                _S105 = _S114;
                if(_S114)
                {
                    first_3 = _S113;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_8, u32(0), exit_0[u32(0)]);
                if((_S113.axis_3) == u32(3))
                {
                    _S106 = true;
                }
                else
                {
                    _S106 = Crossing_is_before_0(crossing_0, _S113);
                }
                if(_S106)
                {
                    first_3 = crossing_0;
                }
                else
                {
                    first_3 = _S113;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S107 = _S103[u32(1)];
                var _S115 : bool = (_S103[u32(1)]) == 0.0f;
                _S108 = _S115;
                if(_S115)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_8, u32(1), exit_0[u32(1)]);
                if((first_3.axis_3) == u32(3))
                {
                    _S106 = true;
                }
                else
                {
                    _S106 = Crossing_is_before_0(crossing_1, first_3);
                }
                if(_S106)
                {
                    first_3 = crossing_1;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S109 = _S103[u32(2)];
                var _S116 : bool = (_S103[u32(2)]) == 0.0f;
                _S110 = _S116;
                if(_S116)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_8, u32(2), exit_0[u32(2)]);
                if((first_3.axis_3) == u32(3))
                {
                    _S106 = true;
                }
                else
                {
                    _S106 = Crossing_is_before_0(crossing_2, first_3);
                }
                if(_S106)
                {
                    first_3 = crossing_2;
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
                if(_S105)
                {
                    break;
                }
                var is_negative_1 : bool = _S104 < 0.0f;
                if(u32(0) == (first_3.axis_3))
                {
                    arrival_0[u32(0)] = exit_0[u32(0)] - i32(is_negative_1);
                    break;
                }
                if(is_negative_1)
                {
                    _S112 = i32(-1);
                }
                else
                {
                    _S112 = i32(1);
                }
                if(is_negative_1)
                {
                    cell_2 = min(guess_0[u32(0)], voxel_5[u32(0)]);
                }
                else
                {
                    cell_2 = max(guess_0[u32(0)], voxel_5[u32(0)]);
                }
                var _S117 : i32 = i32(is_negative_1);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = cell_2 != (voxel_5[u32(0)]);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                        _S111 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(0), cell_2 + _S117), first_3);
                    }
                    else
                    {
                        _S111 = false;
                    }
                    if(_S111)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_3 : i32 = cell_2 - _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_3;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = Crossing_is_before_0(crossing_of_0(ray_8, u32(0), cell_2 + _S112 + _S117), first_3);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_4 : i32 = cell_2 + _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_4;
                }
                arrival_0[u32(0)] = cell_2;
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S108)
                {
                    break;
                }
                var is_negative_2 : bool = _S107 < 0.0f;
                if(u32(1) == (first_3.axis_3))
                {
                    arrival_0[u32(1)] = exit_0[u32(1)] - i32(is_negative_2);
                    break;
                }
                if(is_negative_2)
                {
                    _S112 = i32(-1);
                }
                else
                {
                    _S112 = i32(1);
                }
                if(is_negative_2)
                {
                    cell_2 = min(guess_0[u32(1)], voxel_5[u32(1)]);
                }
                else
                {
                    cell_2 = max(guess_0[u32(1)], voxel_5[u32(1)]);
                }
                var _S118 : i32 = i32(is_negative_2);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = cell_2 != (voxel_5[u32(1)]);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                        _S111 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(1), cell_2 + _S118), first_3);
                    }
                    else
                    {
                        _S111 = false;
                    }
                    if(_S111)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_5 : i32 = cell_2 - _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_5;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = Crossing_is_before_0(crossing_of_0(ray_8, u32(1), cell_2 + _S112 + _S118), first_3);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_6 : i32 = cell_2 + _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_6;
                }
                arrival_0[u32(1)] = cell_2;
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S110)
                {
                    break;
                }
                var is_negative_3 : bool = _S109 < 0.0f;
                if(u32(2) == (first_3.axis_3))
                {
                    arrival_0[u32(2)] = exit_0[u32(2)] - i32(is_negative_3);
                    break;
                }
                if(is_negative_3)
                {
                    _S112 = i32(-1);
                }
                else
                {
                    _S112 = i32(1);
                }
                if(is_negative_3)
                {
                    cell_2 = min(guess_0[u32(2)], voxel_5[u32(2)]);
                }
                else
                {
                    cell_2 = max(guess_0[u32(2)], voxel_5[u32(2)]);
                }
                var _S119 : i32 = i32(is_negative_3);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = cell_2 != (voxel_5[u32(2)]);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                        _S111 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(2), cell_2 + _S119), first_3);
                    }
                    else
                    {
                        _S111 = false;
                    }
                    if(_S111)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_7 : i32 = cell_2 - _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_7;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S106 = Crossing_is_before_0(crossing_of_0(ray_8, u32(2), cell_2 + _S112 + _S119), first_3);
                    }
                    else
                    {
                        _S106 = false;
                    }
                    if(_S106)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_8 : i32 = cell_2 + _S112;
                    i_0 = i_0 + u32(1);
                    cell_2 = cell_8;
                }
                arrival_0[u32(2)] = cell_2;
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn Walk_arrive_0( this_12 : Walk_0,  voxel_6 : vec3<i32>,  t_2 : f32,  is_axis_1 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_1 : vec3<f32> = this_12.origin_8 + this_12.speed_1 * vec3<f32>(t_2);
    if(IS_EXACT_0)
    {
        var position_2 : vec3<f32> = clamp(position_1, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_1 : vec3<f32> = round(position_2);
        var from_nearest_1 : vec3<f32> = position_2 - nearest_1;
        var cell_9 : vec3<i32> = vec3<i32>(nearest_1) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f));
        if((any((select(vec3<bool>(false), (abs(position_2)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_1, (abs(from_nearest_1)) <= (this_12.tolerance_0)))))))
        {
            return Walk_mirrored_0(this_12, leave_box_0(this_12.ray_5, Walk_mirrored_0(this_12, voxel_6) + this_12.grid_origin_0, Walk_mirrored_plane_0(this_12, exit_1) + this_12.grid_origin_0, Walk_mirrored_0(this_12, cell_9)) - this_12.grid_origin_0);
        }
        return select(cell_9 - this_12.offset_0, exit_1, is_axis_1);
    }
    return max(vec3<i32>(floor(position_1)), select(voxel_6, exit_1, is_axis_1));
}

fn Walk_enter_0( this_13 : Walk_0,  voxel_7 : ptr<function, vec3<i32>>,  low_9 : vec3<i32>,  high_4 : vec3<i32>) -> bool
{
    var is_mirrored_0 : vec3<bool> = (this_13.mirror_0) != vec3<i32>(i32(0));
    var _S120 : vec3<i32> = select(low_9, (vec3<i32>(0) - high_4), is_mirrored_0);
    var far_0 : vec3<i32> = select(high_4, (vec3<i32>(0) - low_9), is_mirrored_0);
    for(;;)
    {
        var is_before_1 : vec3<bool> = (*voxel_7) < _S120;
        if(!(any((is_before_1))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_13.speed_1) == vec3<f32>(0.0f), is_before_1)))))
        {
            return false;
        }
        var t_3 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_13, _S120), is_before_1);
        var t_last_0 : f32 = max_element_0(t_3);
        if(t_last_0 > (this_13.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_3.x) == t_last_0;
        var _S121 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S121)
        {
            is_y_0 = (t_3.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S122 : bool;
        if(_S121)
        {
            _S122 = !is_y_0;
        }
        else
        {
            _S122 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S122);
        (*voxel_7) = Walk_arrive_0(this_13, (*voxel_7), t_last_0, is_axis_2, select(vec3<i32>(i32(1073741823)), _S120, is_axis_2));
    }
    return (all(((*voxel_7) < far_0)));
}

fn LocalRay_octant_0( this_14 : LocalRay_0) -> u32
{
    return (((u32((this_14.direction_8.x) < 0.0f) | (((u32((this_14.direction_8.y) < 0.0f) << (u32(1))))))) | (((u32((this_14.direction_8.z) < 0.0f) << (u32(2))))));
}

fn dot_cells_0( a_3 : vec3<i32>,  b_3 : vec3<i32>) -> i32
{
    return a_3.x * b_3.x + a_3.y * b_3.y + a_3.z * b_3.z;
}

fn blocks_ahead_0( octant_0 : u32) -> vec2<u32>
{
    const bytes_0 : vec2<u32> = vec2<u32>(u32(2295114495), u32(2160107760));
    var bytes_1 : vec2<u32>;
    if(((octant_0 & (u32(1)))) != u32(0))
    {
        var _S123 : vec2<u32> = vec2<u32>(u32(1431655765));
        var _S124 : vec2<u32> = vec2<u32>(u32(1));
        var bytes_2 : vec2<u32> = (((((bytes_0 & (_S123))) << (_S124))) | (((((bytes_0 >> (_S124))) & (_S123)))));
        var _S125 : vec2<u32> = vec2<u32>(u32(16711935));
        var _S126 : vec2<u32> = vec2<u32>(u32(8));
        bytes_1 = (((((bytes_2 & (_S125))) << (_S126))) | (((((bytes_2 >> (_S126))) & (_S125)))));
    }
    else
    {
        bytes_1 = bytes_0;
    }
    if(((octant_0 & (u32(2)))) != u32(0))
    {
        var _S127 : vec2<u32> = vec2<u32>(u32(858993459));
        var _S128 : vec2<u32> = vec2<u32>(u32(2));
        var bytes_3 : vec2<u32> = (((((bytes_1 & (_S127))) << (_S128))) | (((((bytes_1 >> (_S128))) & (_S127)))));
        var _S129 : vec2<u32> = vec2<u32>(u32(16));
        bytes_1 = (((bytes_3 << (_S129))) | (((bytes_3 >> (_S129)))));
    }
    if(((octant_0 & (u32(4)))) != u32(0))
    {
        var _S130 : vec2<u32> = vec2<u32>(u32(252645135));
        var _S131 : vec2<u32> = vec2<u32>(u32(4));
        bytes_1 = ((((((bytes_1 & (_S130))) << (_S131))) | (((((bytes_1 >> (_S131))) & (_S130)))))).yx;
    }
    return bytes_1;
}

fn flip_of_0( octant_1 : u32) -> u32
{
    return ((((((octant_1 & (u32(1)))) | (((((octant_1 & (u32(2)))) << (u32(1))))))) | (((((octant_1 & (u32(4)))) << (u32(2))))))) * u32(3);
}

@id(3) override IS_DENSE_0 : bool = false;

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

fn empty_around_0( record_0 : u32,  header_1 : u32,  voxel_8 : vec3<i32>,  octant_2 : u32,  flip_0 : u32,  ahead_0 : vec2<u32>) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_8.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_8.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_8.z) & (i32(4))))))) ^ (octant_2));
    var present_0 : u32 = (header_1 & (u32(255)));
    var _S132 : u32;
    if(block_0 < u32(4))
    {
        _S132 = ahead_0.x;
    }
    else
    {
        _S132 = ahead_0.y;
    }
    if(((((_S132 >> ((u32(8) * ((block_0 & (u32(3)))))))) & (present_0))) == u32(0))
    {
        return u32(3);
    }
    if(((((present_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(2);
    }
    var bit_1 : u32 = ((cell_in_node_0(voxel_8, u32(0))) ^ (flip_0));
    var half_2 : u32 = bricks_0[record_0 + u32(2) + u32(2) * countOneBits((present_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_1 >> (u32(5))))];
    if(((((half_2 >> (((bit_1 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S133 : i32;
    if(((((half_2 >> (((bit_1 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S133 = i32(1);
    }
    else
    {
        _S133 = i32(0);
    }
    return u32(_S133);
}

fn Walk_leave_0( this_15 : Walk_0,  voxel_9 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_4 : vec3<f32> = Walk_crossings_0(this_15, exit_2);
    var _S134 : f32 = t_4.x;
    var _S135 : f32 = t_4.y;
    var _S136 : f32 = min(min(_S134, _S135), t_4.z);
    if(_S136 > (this_15.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = _S134 == _S136;
    var _S137 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S137)
    {
        is_y_1 = _S135 == _S136;
    }
    else
    {
        is_y_1 = false;
    }
    var _S138 : vec3<i32> = (*voxel_9);
    var _S139 : bool;
    if(_S137)
    {
        _S139 = !is_y_1;
    }
    else
    {
        _S139 = false;
    }
    (*voxel_9) = Walk_arrive_0(this_15, _S138, _S136, vec3<bool>(is_x_1, is_y_1, _S139), exit_2);
    return true;
}

fn first_voxel_0( _S140 : u32,  _S141 : LocalRay_0,  _S142 : ptr<function, vec3<i32>>) -> bool
{
    var _S143 : vec3<i32> = vec3<i32>(i32(0));
    (*_S142) = _S143;
    var _S144 : Walk_0 = walk_of_0(_S141, _S140);
    var voxel_10 : vec3<i32> = Walk_start_voxel_0(_S144);
    var _S145 : bool = Walk_enter_0(_S144, &(voxel_10), cell_of_0(grids_0[_S140].min_0) - _S144.grid_origin_0, cell_of_0(grids_0[_S140].max_0) - _S144.grid_origin_0);
    if(!_S145)
    {
        return false;
    }
    var octant_3 : u32 = LocalRay_octant_0(_S141);
    var top_size_1 : vec3<i32> = cell_of_0(grids_0[_S140].top_size_0);
    var _S146 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S146, _S146 * top_size_1.y);
    var _S147 : i32 = i32(grids_0[_S140].top_offset_0) - dot_cells_0((stride_0 & ((_S144.mirror_0))), vec3<i32>(i32(1)));
    var _S148 : vec3<i32> = Walk_mirrored_plane_0(_S144, stride_0);
    var _S149 : u32 = u32(3) * octant_3;
    var _S150 : vec2<u32> = blocks_ahead_0(octant_3);
    var _S151 : u32 = flip_of_0(octant_3);
    var top_shift_1 : u32;
    if(IS_DENSE_0)
    {
        top_shift_1 = u32(3);
    }
    else
    {
        top_shift_1 = grids_0[_S140].top_shift_0;
    }
    var _S152 : vec3<i32> = select((top_size_1 << (vec3<u32>(top_shift_1))), _S143, (_S144.mirror_0) != _S143);
    var is_found_4 : bool;
    if(IS_DENSE_0)
    {
        is_found_4 = true;
    }
    else
    {
        is_found_4 = top_shift_1 == u32(3);
    }
    var count_6 : i32;
    if(is_found_4)
    {
        count_6 = i32(8);
    }
    else
    {
        count_6 = i32(32);
    }
    var _S153 : u32 = u32(count_6);
    var differ_0 : u32 = u32(4294967295);
    var node_4 : u32 = u32(0);
    var header_2 : u32 = u32(0);
    var record_1 : u32 = u32(0);
    is_found_4 = false;
    for(;;)
    {
        var shift_4 : u32;
        var node_5 : u32;
        var shift_5 : u32;
        var is_found_5 : bool;
        if(differ_0 >= u32(8))
        {
            if(differ_0 < _S153)
            {
                shift_4 = cells_0[node_4 + (((cell_in_node_0(voxel_10, u32(3))) ^ (_S151)))];
                node_5 = node_4;
                shift_5 = u32(3);
            }
            else
            {
                if((any((voxel_10 >= _S152))))
                {
                    break;
                }
                shift_4 = cells_0[_S147 + dot_cells_0(_S148, (voxel_10 >> (vec3<u32>(top_shift_1))))];
                node_5 = node_4;
                shift_5 = top_shift_1;
                for(;;)
                {
                    if(!IS_DENSE_0)
                    {
                        is_found_5 = shift_5 > u32(3);
                    }
                    else
                    {
                        is_found_5 = false;
                    }
                    var _S154 : bool;
                    if(is_found_5)
                    {
                        _S154 = ((shift_4 & (u32(2147483648)))) != u32(0);
                    }
                    else
                    {
                        _S154 = false;
                    }
                    if(_S154)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var shift_6 : u32 = shift_5 - u32(2);
                    var node_6 : u32 = ((shift_4 & (u32(2147483647)))) * u32(64);
                    shift_4 = cells_0[node_6 + (((cell_in_node_0(voxel_10, shift_6)) ^ (_S151)))];
                    node_5 = node_6;
                    shift_5 = shift_6;
                }
            }
            var header_3 : u32;
            var record_2 : u32;
            if(((shift_4 & (u32(2147483648)))) != u32(0))
            {
                var record_3 : u32 = ((shift_4 & (u32(2147483647)))) * u32(2);
                header_3 = bricks_0[record_3];
                record_2 = record_3;
                count_6 = i32(1);
            }
            else
            {
                var _S155 : i32 = leap_0((((shift_4 >> (_S149))) & (u32(7))));
                header_3 = u32(0);
                record_2 = record_1;
                count_6 = _S155;
            }
            header_2 = header_3;
            record_1 = record_2;
        }
        else
        {
            count_6 = i32(1);
            node_5 = node_4;
            shift_5 = u32(3);
        }
        if(header_2 != u32(0))
        {
            var shift_7 : u32 = empty_around_0(record_1, header_2, voxel_10, octant_3, _S151, _S150);
            var is_found_6 : bool = shift_7 == u32(4294967295);
            if(is_found_6)
            {
                is_found_4 = is_found_6;
                break;
            }
            is_found_5 = is_found_6;
            shift_4 = shift_7;
        }
        else
        {
            is_found_5 = is_found_4;
            shift_4 = shift_5;
        }
        var before_0 : vec3<i32> = voxel_10;
        var _S156 : bool = Walk_leave_0(_S144, &(voxel_10), ((((voxel_10 >> (vec3<u32>(shift_4)))) + vec3<i32>(count_6)) << (vec3<u32>(shift_4))));
        if(!_S156)
        {
            is_found_4 = is_found_5;
            break;
        }
        var _S157 : vec3<u32> = vec3<u32>((before_0 ^ (voxel_10)));
        differ_0 = ((((_S157.x) | ((_S157.y)))) | ((_S157.z)));
        node_4 = node_5;
        is_found_4 = is_found_5;
    }
    (*_S142) = Walk_mirrored_0(_S144, voxel_10) + _S144.grid_origin_0;
    return is_found_4;
}

fn Hit_x24init_0( t_5 : f32,  instance_5 : u32,  voxel_11 : vec3<i32>,  face_11 : u32) -> Hit_0
{
    var _S158 : Hit_0;
    _S158.t_1 = t_5;
    _S158.instance_2 = instance_5;
    _S158.voxel_2 = voxel_11;
    _S158.face_1 = face_11;
    return _S158;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn hit_of_0( ray_9 : LocalRay_0,  voxel_12 : vec3<i32>,  instance_6 : u32) -> Hit_0
{
    var _S159 : vec3<f32>;
    var _S160 : bool;
    var last_0 : Crossing_0;
    var _S161 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S159 = ray_9.direction_8;
                if((ray_9.direction_8[u32(0)]) == 0.0f)
                {
                    last_0 = _S161;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_9, u32(0), voxel_12[u32(0)] + i32((ray_9.direction_8[u32(0)]) < 0.0f));
                if((_S161.axis_3) == u32(3))
                {
                    _S160 = true;
                }
                else
                {
                    _S160 = !Crossing_is_before_0(crossing_3, _S161);
                }
                if(_S160)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S161;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S162 : vec3<f32> = _S159;
                if((_S159[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_9, u32(1), voxel_12[u32(1)] + i32((_S162[u32(1)]) < 0.0f));
                if((last_0.axis_3) == u32(3))
                {
                    _S160 = true;
                }
                else
                {
                    _S160 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S160)
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
                var _S163 : vec3<f32> = _S159;
                if((_S159[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_9, u32(2), voxel_12[u32(2)] + i32((_S163[u32(2)]) < 0.0f));
                if((last_0.axis_3) == u32(3))
                {
                    _S160 = true;
                }
                else
                {
                    _S160 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S160)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S164 : Crossing_0 = last_0;
    var is_negative_4 : bool = (_S159[last_0.axis_3]) < 0.0f;
    var t_6 : f32 = (f32(voxel_12[last_0.axis_3] + i32(is_negative_4)) - ray_9.origin_6[last_0.axis_3]) * ray_9.inverse_0[last_0.axis_3];
    var _S165 : f32;
    if(t_6 > (ray_9.t_min_3))
    {
        _S165 = t_6;
    }
    else
    {
        _S165 = ray_9.t_min_3;
    }
    return Hit_x24init_0(_S165, instance_6, voxel_12, u32(2) * _S164.axis_3 + u32(is_negative_4));
}

fn hit_in_0( instance_7 : u32,  ray_10 : Ray_0) -> Hit_0
{
    var _S166 : LocalRay_0 = local_ray_0(ray_10, instance_7);
    var voxel_13 : vec3<i32>;
    var _S167 : bool;
    if(!_S166.is_valid_0)
    {
        _S167 = true;
    }
    else
    {
        var _S168 : bool = first_voxel_0(instances_0[instance_7].grid_0, _S166, &(voxel_13));
        _S167 = !_S168;
    }
    if(_S167)
    {
        return miss_0();
    }
    var hit_5 : Hit_0 = hit_of_0(_S166, voxel_13, instance_7);
    if((hit_5.t_1) > (ray_10.t_max_1))
    {
        return miss_0();
    }
    return hit_5;
}

fn entry_0( _S169 : u32,  _S170 : Ray_0,  _S171 : vec3<f32>) -> f32
{
    var low_10 : vec3<f32> = (vector_of_0(instance_nodes_0[_S169].min_1) - _S170.origin_2) * _S171;
    var high_5 : vec3<f32> = (vector_of_0(instance_nodes_0[_S169].max_1) - _S170.origin_2) * _S171;
    var _S172 : f32 = max(_S170.t_min_1, max_element_0(min(low_10, high_5)));
    var last_1 : vec3<f32> = max(low_10, high_5);
    var _S173 : f32;
    if(_S172 <= (min(_S170.t_max_1, min(min(last_1.x, last_1.y), last_1.z))))
    {
        _S173 = _S172;
    }
    else
    {
        _S173 = (bitcast<f32>((u32(2139095040))));
    }
    return _S173;
}

fn visit_0( ray_11 : Ray_0,  is_any_enough_0 : bool) -> Hit_0
{
    var _S174 : Ray_0 = ray_11;
    if(IS_SINGLE_0)
    {
        return hit_in_0(u32(0), _S174);
    }
    var nearest_2 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_2;
    }
    var is_still_1 : vec3<bool> = !((abs(_S174.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S175 : vec3<f32> = select(vec3<f32>(1.0f) / select(_S174.direction_1, vec3<f32>(1.0f), is_still_1), vec3<f32>(3.4028234663852886e+38f), is_still_1);
    var stack_0 : array<u32, i32(32)>;
    var near_0 : u32 = u32(0);
    var nearest_3 : Hit_0 = nearest_2;
    var depth_1 : u32 = u32(0);
    for(;;)
    {
        var depth_2 : u32;
        if((instance_nodes_0[near_0].is_leaf_0) != u32(0))
        {
            var hit_6 : Hit_0 = hit_in_0(instance_nodes_0[near_0].index_0, _S174);
            var _S176 : Hit_0 = nearest_3;
            var _S177 : bool;
            if((hit_6.t_1) < (nearest_3.t_1))
            {
                _S177 = true;
            }
            else
            {
                if((hit_6.t_1) == (_S176.t_1))
                {
                    _S177 = (hit_6.instance_2) < (nearest_3.instance_2);
                }
                else
                {
                    _S177 = false;
                }
            }
            var nearest_4 : Hit_0;
            if(_S177)
            {
                _S174.t_max_1 = hit_6.t_1;
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
            var _S178 : u32 = near_0 + u32(1);
            var _S179 : f32 = entry_0(_S178, _S174, _S175);
            var _S180 : u32 = instance_nodes_0[near_0].index_0;
            var _S181 : f32 = entry_0(instance_nodes_0[near_0].index_0, _S174, _S175);
            var _S182 : bool = _S179 <= _S181;
            if(_S182)
            {
                near_0 = _S178;
            }
            else
            {
                near_0 = _S180;
            }
            var far_1 : u32;
            if(_S182)
            {
                far_1 = _S180;
            }
            else
            {
                far_1 = _S178;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S179, _S181)) < INFINITY_0)
            {
                var _S183 : u32 = depth_1 + u32(1);
                stack_0[depth_1] = far_1;
                depth_2 = _S183;
            }
            else
            {
                depth_2 = depth_1;
            }
            if((min(_S179, _S181)) < INFINITY_0)
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

fn Surface_world_direction_0( this_16 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_16.face_4) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S184 : f32 = local_3.x;
    var _S185 : f32 = local_3.y;
    var _S186 : vec3<f32> = vec3<f32>(_S184, _S185, away_2);
    var in_grid_1 : vec3<f32>;
    if((this_16.face_4) < u32(2))
    {
        in_grid_1 = vec3<f32>(away_2, _S184, _S185);
    }
    else
    {
        if((this_16.face_4) < u32(4))
        {
            in_grid_1 = vec3<f32>(_S185, away_2, _S184);
        }
        else
        {
            in_grid_1 = _S186;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_1(this_16.instance_4, in_grid_1);
    }
    return normalize_vector_0(in_grid_1);
}

fn PathTracing_advance_0( path_2 : ptr<function, Path_0>,  ray_13 : Ray_0,  hit_7 : Hit_0,  radiance_3 : ptr<function, vec3<f32>>,  next_0 : ptr<function, Ray_0>,  shadow_rays_0 : ptr<function, u32>) -> bool
{
    (*next_0) = ray_13;
    var last_2 : Receiver_0 = Receiver_x24init_0(ray_13.origin_2, (*path_2).normal_0);
    var light_pdf_1 : f32;
    var _S187 : bool;
    if(Hit_is_miss_0(hit_7))
    {
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sky_gradient_0(ray_13.direction_1);
        if(has_sun_0())
        {
            _S187 = sun_contains_0(ray_13.direction_1);
        }
        else
        {
            _S187 = false;
        }
        if(_S187)
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
    var material_2 : PackedMaterial_0 = material_of_0(hit_7);
    if((max_element_0(vector_of_0(material_2.emission_0))) > 0.0f)
    {
        if(((*path_2).bounce_0) == u32(0))
        {
            light_pdf_1 = 0.0f;
        }
        else
        {
            light_pdf_1 = light_emitter_pdf_0(last_2, ray_13, hit_7);
        }
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * emitted_0(material_2) * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
    }
    (*path_2).beta_0 = (*path_2).beta_0 * vector_of_0(material_2.base_color_0);
    var u_6 : vec4<f32> = Sampler_stratified_0((*path_2).sampler_0, Path_dimension_scatter_0((*path_2)));
    if(((*path_2).bounce_0) == (params_0.max_bounces_0))
    {
        _S187 = true;
    }
    else
    {
        _S187 = (max_element_0((*path_2).beta_0)) <= 0.0f;
    }
    if(_S187)
    {
        _S187 = true;
    }
    else
    {
        var _S188 : bool = survives_0(&((*path_2)), u_6.z);
        _S187 = !_S188;
    }
    if(_S187)
    {
        return false;
    }
    var surface_1 : Surface_0 = surface_of_0(ray_13, hit_7);
    var sample_5 : LightSample_0;
    var _S189 : bool = sample_light_0(Receiver_x24init_0(surface_1.origin_3, surface_1.normal_3), Sampler_stratified_0((*path_2).sampler_0, Path_dimension_light_0((*path_2))), &(sample_5));
    if(_S189)
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

fn Sampler_x24init_0( seed_3 : u32,  pixel_1 : u32,  sample_6 : u32) -> Sampler_0
{
    var _S190 : Sampler_0;
    _S190.seed_1 = seed_3;
    _S190.pixel_0 = pixel_1;
    _S190.sample_0 = sample_6;
    return _S190;
}

fn Path_x24init_0( sampler_1 : Sampler_0,  bounce_1 : u32,  beta_1 : vec3<f32>,  pdf_3 : f32,  normal_4 : vec3<f32>) -> Path_0
{
    var _S191 : Path_0;
    _S191.sampler_0 = sampler_1;
    _S191.bounce_0 = bounce_1;
    _S191.beta_0 = beta_1;
    _S191.pdf_0 = pdf_3;
    _S191.normal_0 = normal_4;
    return _S191;
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
    var _S192 : CameraFrame_0;
    _S192.eye_1 = eye_2;
    _S192.corner_1 = corner_2;
    _S192.pixel_x_1 = pixel_x_2;
    _S192.pixel_y_1 = pixel_y_2;
    return _S192;
}

fn FrameParams_camera_0() -> CameraFrame_0
{
    return CameraFrame_x24init_0(params_0.eye_0, params_0.corner_0, params_0.pixel_x_0, params_0.pixel_y_0);
}

fn CameraFrame_ray_0( this_17 : CameraFrame_0,  position_3 : vec2<f32>) -> Ray_0
{
    var direction_10 : vec3<f32> = this_17.corner_1 + this_17.pixel_x_1 * vec3<f32>(position_3.x) + this_17.pixel_y_1 * vec3<f32>(position_3.y);
    return ray_from_0(this_17.eye_1, direction_10 * vec3<f32>((1.0f / sqrt(length_squared_0(direction_10)))));
}

fn PathTracing_clip_0( ray_14 : Ray_0) -> Ray_0
{
    return ray_14;
}

fn camera_path_0( at_1 : vec2<u32>,  sample_7 : u32,  path_3 : ptr<function, Path_0>) -> Ray_0
{
    var sampler_3 : Sampler_0 = Sampler_x24init_0(params_0.seed_0, at_1.y * params_0.width_0 + at_1.x, params_0.first_sample_0 + sample_7);
    (*path_3) = Path_x24init_0(sampler_3, u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f));
    return PathTracing_clip_0(CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(at_1) + PathTracing_jitter_0(sampler_3).xy));
}

fn Sampler_independent_0( this_18 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_18.pixel_0, this_18.sample_0, dimension_2, this_18.seed_1)));
}

fn Essay_clip_0( ray_15 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_15.origin_2, 0.10000000149011612f, ray_15.direction_1, 10000.0f);
}

fn Essay_advance_0( path_4 : ptr<function, Path_0>,  ray_16 : Ray_0,  hit_8 : Hit_0,  radiance_4 : ptr<function, vec3<f32>>,  next_1 : ptr<function, Ray_0>,  shadow_rays_1 : ptr<function, u32>) -> bool
{
    (*next_1) = ray_16;
    if(Hit_is_miss_0(hit_8))
    {
        (*radiance_4) = (*radiance_4) + (*path_4).beta_0 * sky_gradient_0(ray_16.direction_1);
        return false;
    }
    var material_3 : PackedMaterial_0 = material_of_0(hit_8);
    if((max_element_0(vector_of_0(material_3.emission_0))) > 0.0f)
    {
        (*radiance_4) = (*radiance_4) + (*path_4).beta_0 * emitted_0(material_3);
        return false;
    }
    if(((*path_4).bounce_0) == (params_0.max_bounces_0))
    {
        return false;
    }
    var u_7 : vec4<f32> = Sampler_independent_0((*path_4).sampler_0, Path_dimension_scatter_0((*path_4)));
    var surface_2 : Surface_0 = surface_of_0(ray_16, hit_8);
    (*path_4).beta_0 = (*path_4).beta_0 * vector_of_0(material_3.base_color_0);
    (*path_4).bounce_0 = (*path_4).bounce_0 + u32(1);
    (*next_1) = Essay_clip_0(ray_from_0(surface_2.origin_3, Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_7.x, u_7.y))));
    return true;
}

fn Essay_jitter_0( sampler_4 : Sampler_0) -> vec4<f32>
{
    return Sampler_independent_0(sampler_4, u32(0));
}

fn camera_path_1( at_2 : vec2<u32>,  sample_8 : u32,  path_5 : ptr<function, Path_0>) -> Ray_0
{
    var sampler_5 : Sampler_0 = Sampler_x24init_0(params_0.seed_0, at_2.y * params_0.width_0 + at_2.x, params_0.first_sample_0 + sample_8);
    (*path_5) = Path_x24init_0(sampler_5, u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f));
    return Essay_clip_0(CameraFrame_ray_0(FrameParams_camera_0(), vec2<f32>(at_2) + Essay_jitter_0(sampler_5).xy));
}

struct RayCounts_0
{
     camera_0 : u32,
     bounce_2 : u32,
     shadow_0 : u32,
};

fn RayCounts_x24init_0( camera_1 : u32,  bounce_3 : u32,  shadow_1 : u32) -> RayCounts_0
{
    var _S193 : RayCounts_0;
    _S193.camera_0 = camera_1;
    _S193.bounce_2 = bounce_3;
    _S193.shadow_0 = shadow_1;
    return _S193;
}

fn WalkTracer_trace_0( ray_17 : Ray_0) -> Hit_0
{
    return visit_0(ray_17, false);
}

struct PixelRecord_0
{
     radiance_0 : array<u32, i32(6)>,
     samples_1 : u32,
     covered_0 : u32,
};

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
        var _S194 : u32 = (mantissa_0 << (u32(shift_8)));
        var _S195 : u32;
        if(shift_8 == i32(0))
        {
            _S195 = u32(0);
        }
        else
        {
            _S195 = (mantissa_0 >> (u32(i32(32) - shift_8)));
        }
        return vec2<u32>(_S194, _S195);
    }
    return vec2<u32>(u32(0), (mantissa_0 << (u32(shift_8 - i32(32)))));
}

fn PixelRecord_add_0( this_19 : ptr<function, PixelRecord_0>,  value_3 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_3[u32(0)]);
    var _S196 : u32 = addend_0.x;
    var low_11 : u32 = (*this_19).radiance_0[u32(0)] + _S196;
    var high_6 : u32 = (*this_19).radiance_0[u32(1)] + addend_0.y + u32(low_11 < _S196);
    var is_full_0 : bool = high_6 < ((*this_19).radiance_0[u32(1)]);
    var _S197 : u32;
    if(is_full_0)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = low_11;
    }
    (*this_19).radiance_0[u32(0)] = _S197;
    if(is_full_0)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = high_6;
    }
    (*this_19).radiance_0[u32(1)] = _S197;
    var addend_1 : vec2<u32> = fixed_point_0(value_3[u32(1)]);
    var _S198 : u32 = addend_1.x;
    var low_12 : u32 = (*this_19).radiance_0[u32(2)] + _S198;
    var high_7 : u32 = (*this_19).radiance_0[u32(3)] + addend_1.y + u32(low_12 < _S198);
    var is_full_1 : bool = high_7 < ((*this_19).radiance_0[u32(3)]);
    if(is_full_1)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = low_12;
    }
    (*this_19).radiance_0[u32(2)] = _S197;
    if(is_full_1)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = high_7;
    }
    (*this_19).radiance_0[u32(3)] = _S197;
    var addend_2 : vec2<u32> = fixed_point_0(value_3[u32(2)]);
    var _S199 : u32 = addend_2.x;
    var low_13 : u32 = (*this_19).radiance_0[u32(4)] + _S199;
    var high_8 : u32 = (*this_19).radiance_0[u32(5)] + addend_2.y + u32(low_13 < _S199);
    var is_full_2 : bool = high_8 < ((*this_19).radiance_0[u32(5)]);
    if(is_full_2)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = low_13;
    }
    (*this_19).radiance_0[u32(4)] = _S197;
    if(is_full_2)
    {
        _S197 = u32(4294967295);
    }
    else
    {
        _S197 = high_8;
    }
    (*this_19).radiance_0[u32(5)] = _S197;
    (*this_19).samples_1 = (*this_19).samples_1 + u32(1);
    (*this_19).covered_0 = (*this_19).covered_0 + u32(is_covered_0);
    return;
}

fn add_sample_0( index_7 : u32,  radiance_5 : vec3<f32>,  is_covered_1 : bool)
{
    var pixel_2 : PixelRecord_0;
    pixel_2.radiance_0 = pixels_0[index_7].radiance_0;
    pixel_2.samples_1 = pixels_0[index_7].samples_1;
    pixel_2.covered_0 = pixels_0[index_7].covered_0;
    PixelRecord_add_0(&(pixel_2), radiance_5, is_covered_1);
    pixels_0[index_7].radiance_0 = pixel_2.radiance_0;
    pixels_0[index_7].samples_1 = pixel_2.samples_1;
    pixels_0[index_7].covered_0 = pixel_2.covered_0;
    return;
}

fn trace_pixel_0( index_8 : u32) -> RayCounts_0
{
    var size_0 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S200 : u32 = size_0.x;
    var _S201 : u32 = u32(8) * _S200;
    var band_0 : u32 = index_8 / _S201;
    var _S202 : u32 = u32(8) * band_0;
    var in_band_0 : u32 = index_8 - _S201 * band_0;
    var _S203 : u32 = u32(8) * min(u32(8), size_0.y - _S202);
    var tile_0 : u32 = in_band_0 / _S203;
    var _S204 : u32 = u32(8) * tile_0;
    var _S205 : u32 = min(u32(8), _S200 - _S204);
    var in_tile_0 : u32 = in_band_0 - _S203 * tile_0;
    var _S206 : u32 = in_tile_0 % _S205;
    var _S207 : u32 = _S204 + _S206;
    var _S208 : u32 = in_tile_0 / _S205;
    var _S209 : u32 = _S202 + _S208;
    var pixel_3 : u32 = _S209 * _S200 + _S207;
    var at_3 : vec2<u32> = vec2<u32>(_S207, _S209) + params_0.region_0.xy;
    var _S210 : u32 = min(dispatch_0.samples_target_0, pixels_0[pixel_3].samples_1 + dispatch_0.samples_0);
    var counts_0 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S211 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_6 : vec3<f32> = _S211;
    var path_6 : Path_0;
    var _S212 : Ray_0 = camera_path_0(at_3, pixels_0[pixel_3].samples_1, &(path_6));
    var ray_18 : Ray_0 = _S212;
    var is_covered_2 : bool = false;
    var sample_9 : u32 = pixels_0[pixel_3].samples_1;
    for(;;)
    {
        if(sample_9 < _S210)
        {
        }
        else
        {
            break;
        }
        var _S213 : Hit_0 = WalkTracer_trace_0(ray_18);
        var is_first_0 : bool = (path_6.bounce_0) == u32(0);
        counts_0.camera_0 = counts_0.camera_0 + u32(is_first_0);
        counts_0.bounce_2 = counts_0.bounce_2 + u32(!is_first_0);
        if(is_first_0)
        {
            is_covered_2 = !Hit_is_miss_0(_S213);
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
        var goes_on_1 : bool;
        if(goes_on_0)
        {
            var _S214 : u32 = counts_0.shadow_0;
            var _S215 : bool = PathTracing_advance_0(&(path_6), ray_18, _S213, &(radiance_6), &(ray_18), &(_S214));
            counts_0.shadow_0 = _S214;
            goes_on_1 = _S215;
        }
        else
        {
            goes_on_1 = goes_on_0;
        }
        if(!goes_on_1)
        {
            add_sample_0(pixel_3, radiance_6, is_covered_2);
            radiance_6 = _S211;
            var sample_10 : u32 = sample_9 + u32(1);
            var _S216 : Ray_0 = camera_path_0(at_3, sample_10, &(path_6));
            ray_18 = _S216;
            sample_9 = sample_10;
        }
    }
    return counts_0;
}

fn trace_pixel_1( index_9 : u32) -> RayCounts_0
{
    var size_1 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S217 : u32 = size_1.x;
    var _S218 : u32 = u32(8) * _S217;
    var band_1 : u32 = index_9 / _S218;
    var _S219 : u32 = u32(8) * band_1;
    var in_band_1 : u32 = index_9 - _S218 * band_1;
    var _S220 : u32 = u32(8) * min(u32(8), size_1.y - _S219);
    var tile_1 : u32 = in_band_1 / _S220;
    var _S221 : u32 = u32(8) * tile_1;
    var _S222 : u32 = min(u32(8), _S217 - _S221);
    var in_tile_1 : u32 = in_band_1 - _S220 * tile_1;
    var _S223 : u32 = in_tile_1 % _S222;
    var _S224 : u32 = _S221 + _S223;
    var _S225 : u32 = in_tile_1 / _S222;
    var _S226 : u32 = _S219 + _S225;
    var pixel_4 : u32 = _S226 * _S217 + _S224;
    var at_4 : vec2<u32> = vec2<u32>(_S224, _S226) + params_0.region_0.xy;
    var _S227 : u32 = min(dispatch_0.samples_target_0, pixels_0[pixel_4].samples_1 + dispatch_0.samples_0);
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S228 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_7 : vec3<f32> = _S228;
    var path_7 : Path_0;
    var _S229 : Ray_0 = camera_path_1(at_4, pixels_0[pixel_4].samples_1, &(path_7));
    var ray_19 : Ray_0 = _S229;
    var is_covered_3 : bool = false;
    var sample_11 : u32 = pixels_0[pixel_4].samples_1;
    for(;;)
    {
        if(sample_11 < _S227)
        {
        }
        else
        {
            break;
        }
        var _S230 : Hit_0 = WalkTracer_trace_0(ray_19);
        var is_first_1 : bool = (path_7.bounce_0) == u32(0);
        counts_1.camera_0 = counts_1.camera_0 + u32(is_first_1);
        counts_1.bounce_2 = counts_1.bounce_2 + u32(!is_first_1);
        if(is_first_1)
        {
            is_covered_3 = !Hit_is_miss_0(_S230);
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
        var goes_on_3 : bool;
        if(goes_on_2)
        {
            var _S231 : u32 = counts_1.shadow_0;
            var _S232 : bool = Essay_advance_0(&(path_7), ray_19, _S230, &(radiance_7), &(ray_19), &(_S231));
            counts_1.shadow_0 = _S231;
            goes_on_3 = _S232;
        }
        else
        {
            goes_on_3 = goes_on_2;
        }
        if(!goes_on_3)
        {
            add_sample_0(pixel_4, radiance_7, is_covered_3);
            radiance_7 = _S228;
            var sample_12 : u32 = sample_11 + u32(1);
            var _S233 : Ray_0 = camera_path_1(at_4, sample_12, &(path_7));
            ray_19 = _S233;
            sample_11 = sample_12;
        }
    }
    return counts_1;
}

var<workgroup> group_counts_0 : array<atomic<u32>, i32(3)>;

fn count_7( counts_2 : RayCounts_0,  thread_0 : u32)
{
    var _S234 : bool = thread_0 < u32(3);
    if(_S234)
    {
        atomicStore(&(group_counts_0[thread_0]), u32(0));
    }
    workgroupBarrier();
    var _S235 : u32 = atomicAdd(&(group_counts_0[i32(0)]), counts_2.camera_0);
    var _S236 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_2.bounce_2);
    var _S237 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_2.shadow_0);
    workgroupBarrier();
    if(_S234)
    {
        var _S238 : u32 = atomicLoad(&(group_counts_0[thread_0]));
        var _S239 : u32 = atomicAdd(&(counters_0[u32(1) + thread_0]), _S238);
    }
    if(thread_0 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S240 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_essay(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    var _S241 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S242 : u32 = id_0.x;
    var counts_3 : RayCounts_0;
    if(_S242 < (dispatch_0.count_0))
    {
        var _S243 : RayCounts_0 = trace_pixel_1(dispatch_0.first_0 + _S242);
        counts_3 = _S243;
    }
    else
    {
        counts_3 = _S241;
    }
    count_7(counts_3, thread_1);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn render_path(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_2 : u32)
{
    var _S244 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S245 : u32 = id_1.x;
    var counts_4 : RayCounts_0;
    if(_S245 < (dispatch_0.count_0))
    {
        var _S246 : RayCounts_0 = trace_pixel_0(dispatch_0.first_0 + _S245);
        counts_4 = _S246;
    }
    else
    {
        counts_4 = _S244;
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

fn HitRecord_x24init_0( t_7 : f32,  instance_8 : u32,  voxel_14 : array<i32, i32(3)>,  face_12 : u32) -> HitRecord_0
{
    var _S247 : HitRecord_0;
    _S247.t_0 = t_7;
    _S247.instance_0 = instance_8;
    _S247.voxel_0 = voxel_14;
    _S247.face_0 = face_12;
    return _S247;
}

fn record_of_0( hit_9 : Hit_0) -> HitRecord_0
{
    var _S248 : array<i32, i32(3)> = array<i32, i32(3)>( hit_9.voxel_2.x, hit_9.voxel_2.y, hit_9.voxel_2.z );
    return HitRecord_x24init_0(hit_9.t_1, hit_9.instance_2, _S248, hit_9.face_1);
}

fn ray_of_0( _S249 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S249].origin_0), rays_0[_S249].t_min_0, vector_of_0(rays_0[_S249].direction_0), rays_0[_S249].t_max_0);
}

@compute
@workgroup_size(64, 1, 1)
fn cast_rays(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    var counts_5 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0), u32(0));
    var _S250 : u32 = id_2.x;
    if(_S250 < (dispatch_0.count_0))
    {
        var _S251 : HitRecord_0 = record_of_0(WalkTracer_trace_0(ray_of_0(dispatch_0.first_0 + _S250)));
        hits_0[dispatch_0.first_0 + _S250].t_0 = _S251.t_0;
        hits_0[dispatch_0.first_0 + _S250].instance_0 = _S251.instance_0;
        hits_0[dispatch_0.first_0 + _S250].voxel_0 = _S251.voxel_0;
        hits_0[dispatch_0.first_0 + _S250].face_0 = _S251.face_0;
        counts_5.camera_0 = u32(1);
    }
    count_7(counts_5, thread_3);
    return;
}

