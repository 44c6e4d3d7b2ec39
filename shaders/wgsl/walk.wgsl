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

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_1 : u32) -> u32
{
    var _S9 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S9 = u32(8388607);
    }
    else
    {
        _S9 = u32(2147483647);
    }
    return ((cell_1 & (_S9))) * u32(2);
}

fn find_brick_0( _S10 : u32,  _S11 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S11 >> (vec3<u32>(grids_0[_S10].top_shift_0)));
    var cell_2 : u32 = cells_0[grids_0[_S10].top_offset_0 + u32((top_0.z * grids_0[_S10].top_size_0[i32(1)] + top_0.y) * grids_0[_S10].top_size_0[i32(0)] + top_0.x)];
    var shift_1 : u32 = grids_0[_S10].top_shift_0;
    for(;;)
    {
        var _S12 : bool;
        if(shift_1 > u32(3))
        {
            _S12 = ((cell_2 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S12 = false;
        }
        if(_S12)
        {
        }
        else
        {
            break;
        }
        var shift_2 : u32 = shift_1 - u32(2);
        cell_2 = cells_0[((cell_2 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S11, shift_2)];
        shift_1 = shift_2;
    }
    return record_of_cell_0(cell_2);
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

fn material_at_0( _S13 : u32,  _S14 : vec3<i32>) -> u32
{
    var _S15 : u32 = find_brick_0(_S13, _S14);
    var header_0 : u32 = bricks_0[_S15];
    var bit_0 : u32 = cell_in_node_0(_S14, u32(0));
    var present_before_0 : u32 = countOneBits((header_0 & ((((u32(1) << (((((u32(((((_S14.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((_S14.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((_S14.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
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
        var _S16 : u32 = u32(2) * index_2;
        var rank_1 : u32 = rank_0 + (countOneBits(bricks_0[_S15 + u32(2) + _S16]) + countOneBits(bricks_0[_S15 + u32(3) + _S16]));
        index_2 = index_2 + u32(1);
        rank_0 = rank_1;
    }
    var _S17 : u32 = u32(2) * present_before_0;
    var low_1 : u32 = bricks_0[_S15 + u32(2) + _S17];
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_1 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_1) + countOneBits((bricks_0[_S15 + u32(3) + _S17] & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S13].material_bits_0;
    var start_1 : u32 = bricks_0[_S15 + u32(1)];
    var index_3 : u32 = read_bits_0(start_1, palette_count_0 * grids_0[_S13].material_bits_0 + rank_0 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_3;
    }
    return read_bits_0(start_1, index_3 * entry_bits_0, entry_bits_0);
}

fn material_of_0( hit_0 : Hit_0) -> PackedMaterial_0
{
    var _S18 : PackedMaterial_std430_0 = materials_0[material_at_0(instances_0[hit_0.instance_2].grid_0, hit_0.voxel_2 - cell_of_0(grids_0[instances_0[hit_0.instance_2].grid_0].origin_1))];
    var _S19 : PackedMaterial_0 = PackedMaterial_0( _S18.base_color_0, _S18.roughness_0, _S18.emission_0, _S18.metallic_0, _S18.transmission_0, _S18.ior_0 );
    return _S19;
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn is_before_0( a_1 : vec3<i32>,  b_1 : vec3<i32>) -> bool
{
    var _S20 : vec3<u32> = vec3<u32>((a_1 ^ (b_1)));
    var _S21 : i32 = a_1.z - b_1.z;
    var deciding_0 : u32 = _S20.z;
    var _S22 : u32 = _S20.y;
    var _S23 : bool;
    if(deciding_0 < _S22)
    {
        _S23 = deciding_0 < ((deciding_0 ^ (_S22)));
    }
    else
    {
        _S23 = false;
    }
    var deciding_1 : u32;
    var difference_0 : i32;
    if(_S23)
    {
        var _S24 : i32 = a_1.y - b_1.y;
        deciding_1 = _S22;
        difference_0 = _S24;
    }
    else
    {
        deciding_1 = deciding_0;
        difference_0 = _S21;
    }
    var _S25 : u32 = _S20.x;
    if(deciding_1 < _S25)
    {
        _S23 = deciding_1 < ((deciding_1 ^ (_S25)));
    }
    else
    {
        _S23 = false;
    }
    if(_S23)
    {
        difference_0 = a_1.x - b_1.x;
    }
    return difference_0 < i32(0);
}

fn find_emitter_0( hit_1 : Hit_0,  found_0 : ptr<function, u32>) -> bool
{
    var is_lower_0 : bool;
    var _S26 : vec2<u32> = vec2<u32>(arrayLength(&emitters_0), 32);
    var count_3 : u32 = _S26.x;
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
        var _S27 : u32 = emitters_0[middle_0].instance_1;
        if((emitters_0[middle_0].instance_1) < (hit_1.instance_2))
        {
            is_lower_0 = true;
        }
        else
        {
            if(_S27 == (hit_1.instance_2))
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

fn Transform_direction_0( _S28 : u32,  _S29 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S28].grid_from_world_0.x_axis_0) * vec3<f32>(_S29.x) + vector_of_0(instances_0[_S28].grid_from_world_0.y_axis_0) * vec3<f32>(_S29.y) + vector_of_0(instances_0[_S28].grid_from_world_0.z_axis_0) * vec3<f32>(_S29.z);
}

fn Transform_point_0( _S30 : u32,  _S31 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S30, _S31) + vector_of_0(instances_0[_S30].grid_from_world_0.translation_0);
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

fn face_importance_0( _S32 : u32,  _S33 : u32,  _S34 : Receiver_0) -> f32
{
    var axis_2 : u32 = (_S33 >> (u32(1)));
    var sign_0 : f32;
    if(((_S33 & (u32(1)))) == u32(1))
    {
        sign_0 = 1.0f;
    }
    else
    {
        sign_0 = -1.0f;
    }
    var toward_1 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[_S32].voxel_1)) + vec3<f32>(0.5f) - _S34.point_0;
    var toward_2 : vec3<f32> = with_component_0(toward_1, axis_2, component_0(toward_1, axis_2) + 0.5f * sign_0);
    var in_front_0 : f32 = - component_0(toward_2, axis_2) * sign_0;
    var above_1 : f32 = dot_product_0(toward_2, _S34.normal_1) + dot_product_0(with_component_0(vec3<f32>(0.5f), axis_2, 0.0f), abs(_S34.normal_1));
    var _S35 : bool;
    if(in_front_0 <= 0.0f)
    {
        _S35 = true;
    }
    else
    {
        _S35 = above_1 <= 0.0f;
    }
    if(_S35)
    {
        return 0.0f;
    }
    var _S36 : f32 = max(length_squared_0(toward_2), 0.5f);
    var distance_1 : f32 = sqrt(_S36);
    return emitters_0[_S32].luminance_0 * min(in_front_0, distance_1) * min(above_1, distance_1) / (_S36 * _S36);
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

fn node_importance_1( _S37 : u32,  _S38 : Receiver_0) -> f32
{
    var low_3 : vec3<f32> = vector_of_0(light_nodes_0[_S37].min_2);
    var high_2 : vec3<f32> = vector_of_0(light_nodes_0[_S37].max_2);
    var _S39 : vec3<f32> = vec3<f32>(0.5f);
    var half_1 : vec3<f32> = (high_2 - low_3) * _S39;
    var toward_4 : vec3<f32> = (low_3 + high_2) * _S39 - _S38.point_0;
    var above_2 : f32 = dot_product_0(toward_4, _S38.normal_1) + dot_product_0(half_1, abs(_S38.normal_1));
    if(above_2 <= 0.0f)
    {
        return 0.0f;
    }
    var _S40 : f32 = max(length_squared_0(toward_4), length_squared_0(half_1));
    var distance_2 : f32 = sqrt(_S40);
    var _S41 : vec3<f32> = vec3<f32>(0.0f);
    var _S42 : vec3<f32> = vec3<f32>(distance_2);
    var beyond_min_1 : vec3<f32> = min(max(_S38.point_0 - low_3, _S41), _S42);
    var beyond_max_1 : vec3<f32> = min(max(high_2 - _S38.point_0, _S41), _S42);
    return (light_nodes_0[_S37].power_0[i32(0)] * beyond_max_1.x + light_nodes_0[_S37].power_0[i32(1)] * beyond_min_1.x + (light_nodes_0[_S37].power_0[i32(2)] * beyond_max_1.y + light_nodes_0[_S37].power_0[i32(3)] * beyond_min_1.y) + (light_nodes_0[_S37].power_0[i32(4)] * beyond_max_1.z + light_nodes_0[_S37].power_0[i32(5)] * beyond_min_1.z)) * min(above_2, distance_2) / (_S40 * _S40);
}

fn left_probability_0( node_0 : u32,  receiver_4 : Receiver_0) -> f32
{
    var _S43 : f32 = node_importance_1(node_0 + u32(1), receiver_4);
    var _S44 : f32 = _S43 + node_importance_1(light_nodes_0[node_0].index_1, receiver_4);
    var _S45 : f32;
    if(_S44 > 0.0f)
    {
        _S45 = _S43 / _S44;
    }
    else
    {
        _S45 = -1.0f;
    }
    return _S45;
}

fn emitter_pdf_0( receiver_5 : Receiver_0,  ray_0 : Ray_0,  hit_2 : Hit_0,  found_1 : u32) -> f32
{
    var local_0 : Receiver_0 = in_grid_0(hit_2.instance_2, receiver_5);
    var toward_5 : vec3<f32> = Transform_direction_0(hit_2.instance_2, ray_0.direction_1) * vec3<f32>(hit_2.t_1);
    var _S46 : u32 = emitters_0[found_1].leaf_0;
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
    var _S47 : bool;
    if(area_pdf_0 < 0.0f)
    {
        _S47 = true;
    }
    else
    {
        _S47 = !(own_1 > 0.0f);
    }
    if(_S47)
    {
        return 0.0f;
    }
    var _S48 : f32 = own_1 / sum_2;
    var parent_1 : u32 = light_nodes_0[emitters_0[found_1].leaf_0].parent_0;
    var node_1 : u32 = _S46;
    var probability_0 : f32 = _S48;
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
    var _S49 : bool = find_emitter_0(hit_3, &(found_2));
    if(!_S49)
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
    var _S50 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S50;
    v_0[i32(0)] = v_0[i32(0)] + _S50.y * _S50.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S51 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S51;
    v_0[i32(0)] = v_0[i32(0)] + _S51.y * _S51.w;
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
    var _S52 : f32 = min(max_element_0((*path_1).beta_0), 0.94999998807907104f);
    (*path_1).beta_0 = (*path_1).beta_0 * vec3<f32>((1.0f / _S52));
    return u_0 < _S52;
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
    var _S53 : vec3<f32> = vec3<f32>(margin_0);
    var moved_0 : vec3<f32> = min(max(point_2, low_4 + _S53), low_4 + vec3<f32>((1.0f - margin_0)));
    var _S54 : bool = face_5 < u32(2);
    var _S55 : bool;
    if(face_5 >= u32(2))
    {
        _S55 = face_5 < u32(4);
    }
    else
    {
        _S55 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S54, _S55, face_5 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_5 & (u32(1)))) == u32(1))
    {
        outside_0 = low_4 + vec3<f32>((1.0f + margin_0));
    }
    else
    {
        outside_0 = low_4 - _S53;
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
    var _S56 : f32;
    if(face_6 < u32(2))
    {
        _S56 = away_0;
    }
    else
    {
        _S56 = 0.0f;
    }
    var _S57 : bool;
    if(face_6 >= u32(2))
    {
        _S57 = face_6 < u32(4);
    }
    else
    {
        _S57 = false;
    }
    var _S58 : f32;
    if(_S57)
    {
        _S58 = away_0;
    }
    else
    {
        _S58 = 0.0f;
    }
    if(face_6 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S56, _S58, away_0);
}

fn Transform_direction_1( _S59 : u32,  _S60 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S59].world_from_grid_0.x_axis_0) * vec3<f32>(_S60.x) + vector_of_0(instances_0[_S59].world_from_grid_0.y_axis_0) * vec3<f32>(_S60.y) + vector_of_0(instances_0[_S59].world_from_grid_0.z_axis_0) * vec3<f32>(_S60.z);
}

fn Transform_point_1( _S61 : u32,  _S62 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S61, _S62) + vector_of_0(instances_0[_S61].world_from_grid_0.translation_0);
}

fn world_normal_0( _S63 : u32,  _S64 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_1(_S63, face_normal_0(_S64)));
}

fn surface_of_0( ray_2 : Ray_0,  hit_4 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S65 : vec3<f32> = vec3<f32>(hit_4.voxel_2);
    if(IS_SINGLE_0)
    {
        surface_0.origin_3 = point_off_face_0(vec3<f32>(0.0f), _S65, hit_4.face_1, ray_2.origin_2 + ray_2.direction_1 * vec3<f32>(hit_4.t_1));
        surface_0.normal_3 = face_normal_0(hit_4.face_1);
    }
    else
    {
        surface_0.origin_3 = Transform_point_1(hit_4.instance_2, point_off_face_0(vector_of_0(instances_0[hit_4.instance_2].grid_from_world_0.translation_0), _S65, hit_4.face_1, Transform_point_0(hit_4.instance_2, ray_2.origin_2) + Transform_direction_0(hit_4.instance_2, ray_2.direction_1) * vec3<f32>(hit_4.t_1)));
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
    var _S66 : Ray_0;
    _S66.origin_2 = origin_4;
    _S66.t_min_1 = t_min_2;
    _S66.direction_1 = direction_4;
    _S66.t_max_1 = t_max_2;
    return _S66;
}

fn ray_from_0( origin_5 : vec3<f32>,  direction_5 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_5, 0.0f, direction_5, (bitcast<f32>((u32(2139095040)))));
}

fn LightSample_x24init_0( ray_4 : Ray_0,  cos_theta_2 : f32,  radiance_2 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S67 : LightSample_0;
    _S67.ray_3 = ray_4;
    _S67.cos_theta_1 = cos_theta_2;
    _S67.radiance_1 = radiance_2;
    _S67.pdf_1 = pdf_2;
    return _S67;
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
    var _S68 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S68, 0.0f, _S68, 0.0f), 0.0f, _S68, 0.0f);
}

struct FaceChoice_0
{
     emitter_0 : u32,
     face_7 : u32,
     importance_0 : f32,
};

fn FaceChoice_x24init_0( emitter_1 : u32,  face_8 : u32,  importance_1 : f32) -> FaceChoice_0
{
    var _S69 : FaceChoice_0;
    _S69.emitter_0 = emitter_1;
    _S69.face_7 = face_8;
    _S69.importance_0 = importance_1;
    return _S69;
}

fn choose_face_0( first_2 : u32,  count_5 : u32,  receiver_8 : Receiver_0,  threshold_0 : f32) -> FaceChoice_0
{
    var _S70 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), u32(0), 0.0f);
    var is_found_0 : bool = false;
    var chosen_0 : FaceChoice_0 = _S70;
    var index_6 : u32 = first_2;
    var passed_0 : f32 = 0.0f;
    for(;;)
    {
        var _S71 : bool;
        if(index_6 < (first_2 + count_5))
        {
            _S71 = !is_found_0;
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
        var is_found_1 : bool = is_found_0;
        var chosen_1 : FaceChoice_0 = chosen_0;
        var face_9 : u32 = u32(0);
        var passed_1 : f32 = passed_0;
        for(;;)
        {
            var _S72 : bool;
            if(face_9 < u32(6))
            {
                _S72 = !is_found_1;
            }
            else
            {
                _S72 = false;
            }
            if(_S72)
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
            var _S73 : f32 = face_importance_0(index_6, face_9, receiver_8);
            var is_found_2 : bool;
            var chosen_2 : FaceChoice_0;
            var passed_2 : f32;
            if(_S73 > 0.0f)
            {
                var _S74 : FaceChoice_0 = FaceChoice_x24init_0(index_6, face_9, _S73);
                var passed_3 : f32 = passed_1 + _S73;
                is_found_2 = threshold_0 < passed_3;
                chosen_2 = _S74;
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
        var _S75 : u32 = index_6 + u32(1);
        is_found_0 = is_found_1;
        chosen_0 = chosen_1;
        index_6 = _S75;
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
    var _S76 : f32 = u_3.x;
    var node_2 : u32 = u32(0);
    var choice_0 : f32 = _S76;
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
    var _S77 : u32 = emitters_0[chosen_3.emitter_0].instance_1;
    var _S78 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[chosen_3.emitter_0].voxel_1));
    var on_face_0 : vec3<f32> = point_of_face_0(_S78, chosen_3.face_7, u_3.z, u_3.w);
    var area_pdf_1 : f32 = face_pdf_0(on_face_0 - local_1.point_0, chosen_3.face_7);
    if(area_pdf_1 < 0.0f)
    {
        return false;
    }
    var direction_7 : vec3<f32> = Transform_point_1(_S77, point_off_face_0(vector_of_0(instances_0[emitters_0[chosen_3.emitter_0].instance_1].grid_from_world_0.translation_0), _S78, chosen_3.face_7, on_face_0)) - receiver_9.point_0;
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
        var _S79 : bool = sample_sun_0(receiver_10, u_4.z, u_4.w, &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * of_sun_0;
        is_found_3 = _S79;
    }
    else
    {
        var _S80 : f32 = 1.0f - of_sun_0;
        var _S81 : bool = sample_emitter_0(receiver_10, vec4<f32>(min((u_4.x - of_sun_0) / _S80, 0.99999994039535522f), u_4.yzw), &((*sample_4)));
        (*sample_4).pdf_1 = (*sample_4).pdf_1 * _S80;
        is_found_3 = _S81;
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

fn local_ray_0( _S82 : Ray_0,  _S83 : u32) -> LocalRay_0
{
    var local_2 : LocalRay_0;
    var direction_9 : vec3<f32>;
    var origin_7 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S84 : vec3<f32> = Transform_point_0(_S83, _S82.origin_2);
        direction_9 = Transform_direction_0(_S83, _S82.direction_1);
        origin_7 = _S84;
    }
    else
    {
        direction_9 = _S82.direction_1;
        origin_7 = _S82.origin_2;
    }
    var is_still_0 : vec3<bool> = !((abs(direction_9)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S85 : vec3<f32> = select(direction_9, vec3<f32>(0.0f), is_still_0);
    local_2.direction_8 = _S85;
    local_2.inverse_0 = select(vec3<f32>(1.0f) / select(direction_9, vec3<f32>(1.0f), is_still_0), vec3<f32>(3.4028234663852886e+38f), is_still_0);
    local_2.origin_6 = select(origin_7, floor(origin_7) + vec3<f32>(0.5f), is_still_0);
    var speed_0 : f32 = max_element_0(abs(_S85));
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
    if((_S82.t_min_1) >= 0.0f)
    {
        is_segment_0 = (_S82.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S82.t_min_1) <= (_S82.t_max_1);
    }
    else
    {
        is_segment_0 = false;
    }
    local_2.t_min_3 = _S82.t_min_1;
    local_2.t_max_3 = _S82.t_max_1;
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

fn Hit_x24init_0( t_2 : f32,  instance_5 : u32,  voxel_3 : vec3<i32>,  face_11 : u32) -> Hit_0
{
    var _S86 : Hit_0;
    _S86.t_1 = t_2;
    _S86.instance_2 = instance_5;
    _S86.voxel_2 = voxel_3;
    _S86.face_1 = face_11;
    return _S86;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
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

fn slowest_0() -> f32
{
    var _S87 : f32;
    if(IS_EXACT_0)
    {
        _S87 = 0.0f;
    }
    else
    {
        _S87 = 1.00000004581370497e-18f;
    }
    return _S87;
}

fn LocalRay_tolerance_0( this_6 : LocalRay_0,  grid_min_0 : vec3<i32>,  grid_max_0 : vec3<i32>) -> vec3<f32>
{
    return select((abs(this_6.origin_6) + (vec3<f32>(max(abs(grid_min_0), abs(grid_max_0))) + vec3<f32>(1.0f))) * vec3<f32>(3.5762786865234375e-07f), vec3<f32>(-1.0f), (this_6.direction_8) == vec3<f32>(0.0f));
}

fn LocalRay_t_end_0( this_7 : LocalRay_0) -> f32
{
    return min(this_7.t_max_3 * 1.00000095367431641f, 3.4028234663852886e+38f);
}

fn walk_of_0( _S88 : LocalRay_0,  _S89 : u32) -> Walk_0
{
    var walk_0 : Walk_0;
    walk_0.ray_5 = _S88;
    walk_0.grid_origin_0 = cell_of_0(grids_0[_S89].origin_1);
    var is_negative_0 : vec3<bool> = (_S88.direction_8) < vec3<f32>(0.0f);
    var _S90 : vec3<i32> = vec3<i32>(i32(0));
    walk_0.mirror_0 = select(_S90, vec3<i32>(i32(-1)), is_negative_0);
    var _S91 : vec3<i32>;
    if(IS_EXACT_0)
    {
        _S91 = Walk_mirrored_plane_0(walk_0, walk_0.grid_origin_0);
    }
    else
    {
        _S91 = _S90;
    }
    walk_0.offset_0 = _S91;
    var origin_9 : vec3<f32>;
    if(IS_EXACT_0)
    {
        origin_9 = _S88.origin_6;
    }
    else
    {
        origin_9 = _S88.origin_6 - vec3<f32>(walk_0.grid_origin_0);
    }
    walk_0.origin_8 = select(origin_9, (vec3<f32>(0) - origin_9), is_negative_0);
    walk_0.speed_1 = max(abs(_S88.direction_8), vec3<f32>(slowest_0()));
    if(IS_EXACT_0)
    {
        origin_9 = abs(_S88.inverse_0);
    }
    else
    {
        origin_9 = vec3<f32>(1.0f) / walk_0.speed_1;
    }
    walk_0.inverse_1 = origin_9;
    walk_0.tolerance_0 = LocalRay_tolerance_0(_S88, cell_of_0(grids_0[_S89].min_0), cell_of_0(grids_0[_S89].max_0));
    walk_0.t_end_0 = LocalRay_t_end_0(_S88);
    return walk_0;
}

fn Walk_mirrored_0( this_8 : Walk_0,  voxel_4 : vec3<i32>) -> vec3<i32>
{
    return (voxel_4 ^ ((this_8.mirror_0)));
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
    var _S92 : f32 = a_parts_0.x;
    var _S93 : f32 = b_parts_0.x;
    var _S94 : f32 = b_parts_0.y;
    var _S95 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S92 * _S93 - product_0 + _S92 * _S94 + _S95 * _S93 + _S95 * _S94);
}

fn exact_start_voxel_0( ray_6 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(0)]);
    var _S96 : f32 = way_0.x;
    var sum_4 : f32 = ray_6.origin_6[u32(0)] + _S96;
    var part_0 : f32 = sum_4 - ray_6.origin_6[u32(0)];
    var low_6 : f32 = ray_6.origin_6[u32(0)] - (sum_4 - part_0) + (_S96 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_4);
    var voxel_5 : vec3<i32>;
    var _S97 : i32 = i32(whole_0);
    var _S98 : bool;
    if(sum_4 == whole_0)
    {
        _S98 = low_6 < 0.0f;
    }
    else
    {
        _S98 = false;
    }
    voxel_5[u32(0)] = _S97 - i32(_S98);
    var way_1 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(1)]);
    var _S99 : f32 = way_1.x;
    var sum_5 : f32 = ray_6.origin_6[u32(1)] + _S99;
    var part_1 : f32 = sum_5 - ray_6.origin_6[u32(1)];
    var low_7 : f32 = ray_6.origin_6[u32(1)] - (sum_5 - part_1) + (_S99 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_5);
    var _S100 : i32 = i32(whole_1);
    if(sum_5 == whole_1)
    {
        _S98 = low_7 < 0.0f;
    }
    else
    {
        _S98 = false;
    }
    voxel_5[u32(1)] = _S100 - i32(_S98);
    var way_2 : vec2<f32> = exact_product_0(ray_6.t_min_3, ray_6.direction_8[u32(2)]);
    var _S101 : f32 = way_2.x;
    var sum_6 : f32 = ray_6.origin_6[u32(2)] + _S101;
    var part_2 : f32 = sum_6 - ray_6.origin_6[u32(2)];
    var low_8 : f32 = ray_6.origin_6[u32(2)] - (sum_6 - part_2) + (_S101 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_6);
    var _S102 : i32 = i32(whole_2);
    if(sum_6 == whole_2)
    {
        _S98 = low_8 < 0.0f;
    }
    else
    {
        _S98 = false;
    }
    voxel_5[u32(2)] = _S102 - i32(_S98);
    return voxel_5;
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
    var _S103 : bool;
    if((this_9.ray_5.t_min_3) > 0.0f)
    {
        _S103 = (any(((abs(from_nearest_0)) <= (this_9.tolerance_0))));
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
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
    var _S104 : Crossing_0;
    _S104.distance_3 = distance_4;
    _S104.distance_low_0 = distance_low_1;
    _S104.speed_2 = speed_3;
    _S104.axis_3 = axis_4;
    return _S104;
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
    var _S105 : bool;
    if(difference_2 < 0.0f)
    {
        _S105 = true;
    }
    else
    {
        if(difference_2 == 0.0f)
        {
            _S105 = (this_11.axis_3) < (other_1.axis_3);
        }
        else
        {
            _S105 = false;
        }
    }
    return _S105;
}

fn leave_box_0( ray_8 : LocalRay_0,  voxel_6 : vec3<i32>,  exit_0 : vec3<i32>,  guess_0 : vec3<i32>) -> vec3<i32>
{
    var _S106 : vec3<f32>;
    var _S107 : f32;
    var _S108 : bool;
    var _S109 : bool;
    var first_3 : Crossing_0;
    var _S110 : f32;
    var _S111 : bool;
    var _S112 : f32;
    var _S113 : bool;
    var _S114 : bool;
    var _S115 : i32;
    var cell_3 : i32;
    var i_0 : u32;
    var _S116 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S106 = ray_8.direction_8;
                _S107 = ray_8.direction_8[u32(0)];
                var _S117 : bool = (ray_8.direction_8[u32(0)]) == 0.0f;
                _S108 = _S117;
                if(_S117)
                {
                    first_3 = _S116;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_8, u32(0), exit_0[u32(0)]);
                if((_S116.axis_3) == u32(3))
                {
                    _S109 = true;
                }
                else
                {
                    _S109 = Crossing_is_before_0(crossing_0, _S116);
                }
                if(_S109)
                {
                    first_3 = crossing_0;
                }
                else
                {
                    first_3 = _S116;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S110 = _S106[u32(1)];
                var _S118 : bool = (_S106[u32(1)]) == 0.0f;
                _S111 = _S118;
                if(_S118)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_8, u32(1), exit_0[u32(1)]);
                if((first_3.axis_3) == u32(3))
                {
                    _S109 = true;
                }
                else
                {
                    _S109 = Crossing_is_before_0(crossing_1, first_3);
                }
                if(_S109)
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
                _S112 = _S106[u32(2)];
                var _S119 : bool = (_S106[u32(2)]) == 0.0f;
                _S113 = _S119;
                if(_S119)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_8, u32(2), exit_0[u32(2)]);
                if((first_3.axis_3) == u32(3))
                {
                    _S109 = true;
                }
                else
                {
                    _S109 = Crossing_is_before_0(crossing_2, first_3);
                }
                if(_S109)
                {
                    first_3 = crossing_2;
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
                if(_S108)
                {
                    break;
                }
                var is_negative_1 : bool = _S107 < 0.0f;
                if(u32(0) == (first_3.axis_3))
                {
                    arrival_0[u32(0)] = exit_0[u32(0)] - i32(is_negative_1);
                    break;
                }
                if(is_negative_1)
                {
                    _S115 = i32(-1);
                }
                else
                {
                    _S115 = i32(1);
                }
                if(is_negative_1)
                {
                    cell_3 = min(guess_0[u32(0)], voxel_6[u32(0)]);
                }
                else
                {
                    cell_3 = max(guess_0[u32(0)], voxel_6[u32(0)]);
                }
                var _S120 : i32 = i32(is_negative_1);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = cell_3 != (voxel_6[u32(0)]);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                        _S114 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(0), cell_3 + _S120), first_3);
                    }
                    else
                    {
                        _S114 = false;
                    }
                    if(_S114)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_4 : i32 = cell_3 - _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_4;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = Crossing_is_before_0(crossing_of_0(ray_8, u32(0), cell_3 + _S115 + _S120), first_3);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_5 : i32 = cell_3 + _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_5;
                }
                arrival_0[u32(0)] = cell_3;
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S111)
                {
                    break;
                }
                var is_negative_2 : bool = _S110 < 0.0f;
                if(u32(1) == (first_3.axis_3))
                {
                    arrival_0[u32(1)] = exit_0[u32(1)] - i32(is_negative_2);
                    break;
                }
                if(is_negative_2)
                {
                    _S115 = i32(-1);
                }
                else
                {
                    _S115 = i32(1);
                }
                if(is_negative_2)
                {
                    cell_3 = min(guess_0[u32(1)], voxel_6[u32(1)]);
                }
                else
                {
                    cell_3 = max(guess_0[u32(1)], voxel_6[u32(1)]);
                }
                var _S121 : i32 = i32(is_negative_2);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = cell_3 != (voxel_6[u32(1)]);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                        _S114 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(1), cell_3 + _S121), first_3);
                    }
                    else
                    {
                        _S114 = false;
                    }
                    if(_S114)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_6 : i32 = cell_3 - _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_6;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = Crossing_is_before_0(crossing_of_0(ray_8, u32(1), cell_3 + _S115 + _S121), first_3);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_7 : i32 = cell_3 + _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_7;
                }
                arrival_0[u32(1)] = cell_3;
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if(_S113)
                {
                    break;
                }
                var is_negative_3 : bool = _S112 < 0.0f;
                if(u32(2) == (first_3.axis_3))
                {
                    arrival_0[u32(2)] = exit_0[u32(2)] - i32(is_negative_3);
                    break;
                }
                if(is_negative_3)
                {
                    _S115 = i32(-1);
                }
                else
                {
                    _S115 = i32(1);
                }
                if(is_negative_3)
                {
                    cell_3 = min(guess_0[u32(2)], voxel_6[u32(2)]);
                }
                else
                {
                    cell_3 = max(guess_0[u32(2)], voxel_6[u32(2)]);
                }
                var _S122 : i32 = i32(is_negative_3);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = cell_3 != (voxel_6[u32(2)]);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                        _S114 = !Crossing_is_before_0(crossing_of_0(ray_8, u32(2), cell_3 + _S122), first_3);
                    }
                    else
                    {
                        _S114 = false;
                    }
                    if(_S114)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_8 : i32 = cell_3 - _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_8;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S109 = Crossing_is_before_0(crossing_of_0(ray_8, u32(2), cell_3 + _S115 + _S122), first_3);
                    }
                    else
                    {
                        _S109 = false;
                    }
                    if(_S109)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_9 : i32 = cell_3 + _S115;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_9;
                }
                arrival_0[u32(2)] = cell_3;
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn Walk_arrive_0( this_12 : Walk_0,  voxel_7 : vec3<i32>,  t_3 : f32,  is_axis_1 : vec3<bool>,  exit_1 : vec3<i32>) -> vec3<i32>
{
    var position_1 : vec3<f32> = this_12.origin_8 + this_12.speed_1 * vec3<f32>(t_3);
    if(IS_EXACT_0)
    {
        var position_2 : vec3<f32> = clamp(position_1, vec3<f32>(-2.097152e+06f), vec3<f32>(2.097152e+06f));
        var nearest_1 : vec3<f32> = round(position_2);
        var from_nearest_1 : vec3<f32> = position_2 - nearest_1;
        var cell_10 : vec3<i32> = vec3<i32>(nearest_1) - vec3<i32>(from_nearest_1 < vec3<f32>(0.0f));
        if((any((select(vec3<bool>(false), (abs(position_2)) < vec3<f32>(2.097152e+06f), select(vec3<bool>(false), !is_axis_1, (abs(from_nearest_1)) <= (this_12.tolerance_0)))))))
        {
            return Walk_mirrored_0(this_12, leave_box_0(this_12.ray_5, Walk_mirrored_0(this_12, voxel_7) + this_12.grid_origin_0, Walk_mirrored_plane_0(this_12, exit_1) + this_12.grid_origin_0, Walk_mirrored_0(this_12, cell_10)) - this_12.grid_origin_0);
        }
        return select(cell_10 - this_12.offset_0, exit_1, is_axis_1);
    }
    return max(vec3<i32>(floor(position_1)), select(voxel_7, exit_1, is_axis_1));
}

fn Walk_enter_0( this_13 : Walk_0,  voxel_8 : ptr<function, vec3<i32>>,  low_9 : vec3<i32>,  high_4 : vec3<i32>) -> bool
{
    var is_mirrored_0 : vec3<bool> = (this_13.mirror_0) != vec3<i32>(i32(0));
    var _S123 : vec3<i32> = select(low_9, (vec3<i32>(0) - high_4), is_mirrored_0);
    var far_0 : vec3<i32> = select(high_4, (vec3<i32>(0) - low_9), is_mirrored_0);
    for(;;)
    {
        var is_before_1 : vec3<bool> = (*voxel_8) < _S123;
        if(!(any((is_before_1))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_13.speed_1) <= vec3<f32>(slowest_0()), is_before_1)))))
        {
            return false;
        }
        var t_4 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_13, _S123), is_before_1);
        var t_last_0 : f32 = max_element_0(t_4);
        if(t_last_0 > (this_13.t_end_0))
        {
            return false;
        }
        var is_x_0 : bool = (t_4.x) == t_last_0;
        var _S124 : bool = !is_x_0;
        var is_y_0 : bool;
        if(_S124)
        {
            is_y_0 = (t_4.y) == t_last_0;
        }
        else
        {
            is_y_0 = false;
        }
        var _S125 : bool;
        if(_S124)
        {
            _S125 = !is_y_0;
        }
        else
        {
            _S125 = false;
        }
        var is_axis_2 : vec3<bool> = vec3<bool>(is_x_0, is_y_0, _S125);
        (*voxel_8) = Walk_arrive_0(this_13, (*voxel_8), t_last_0, is_axis_2, select(vec3<i32>(i32(1073741823)), _S123, is_axis_2));
    }
    return (all(((*voxel_8) < far_0)));
}

fn LocalRay_octant_0( this_14 : LocalRay_0) -> u32
{
    return (((u32((this_14.direction_8.x) < 0.0f) | (((u32((this_14.direction_8.y) < 0.0f) << (u32(1))))))) | (((u32((this_14.direction_8.z) < 0.0f) << (u32(2))))));
}

fn flip_of_0( octant_0 : u32) -> u32
{
    return ((((((octant_0 & (u32(1)))) | (((((octant_0 & (u32(2)))) << (u32(1))))))) | (((((octant_0 & (u32(4)))) << (u32(2))))))) * u32(3);
}

@id(3) override TOP_SHIFT_0 : u32 = u32(0);

fn dot_cells_0( a_3 : vec3<i32>,  b_3 : vec3<i32>) -> i32
{
    return a_3.x * b_3.x + a_3.y * b_3.y + a_3.z * b_3.z;
}

fn ahead_of_0( mirror_1 : vec3<i32>) -> u32
{
    var bits_2 : vec3<u32> = (vec3<u32>(~mirror_1) & (vec3<u32>(u32(31), u32(992), u32(31744))));
    return ((((bits_2.x) | ((bits_2.y)))) | ((bits_2.z)));
}

fn min_element_0( vector_5 : vec3<f32>) -> f32
{
    return min(min(vector_5.x, vector_5.y), vector_5.z);
}

fn extents_0( cell_11 : u32,  ahead_0 : u32) -> vec3<i32>
{
    return vec3<i32>((((vec3<u32>(((((cell_11 & (ahead_0))) | (((((cell_11 >> (u32(15)))) & (((u32(32767) ^ (ahead_0)))))))))) >> (vec3<u32>(u32(0), u32(5), u32(10))))) & (vec3<u32>(u32(31)))));
}

fn blocks_of_cell_0( cell_12 : u32) -> u32
{
    return (((cell_12 >> (u32(23)))) & (u32(255)));
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
    var bit_1 : u32 = ((cell_in_node_0(voxel_9, u32(0))) ^ (flip_0));
    var half_2 : u32 = bricks_0[record_1 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_1 >> (u32(5))))];
    if(((((half_2 >> (((bit_1 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S126 : i32;
    if(((((half_2 >> (((bit_1 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S126 = i32(1);
    }
    else
    {
        _S126 = i32(0);
    }
    return u32(_S126);
}

fn Walk_leave_rounded_0( this_15 : Walk_0,  voxel_10 : ptr<function, vec3<i32>>,  exit_2 : vec3<i32>) -> bool
{
    var t_5 : vec3<f32> = Walk_crossings_0(this_15, exit_2);
    var t_first_0 : f32 = min_element_0(t_5);
    if(t_first_0 >= (this_15.t_end_0))
    {
        return false;
    }
    (*voxel_10) = max(exit_2 - vec3<i32>(ceil((t_5 - vec3<f32>(t_first_0)) * this_15.speed_1)), (*voxel_10));
    return true;
}

fn Walk_leave_0( this_16 : Walk_0,  voxel_11 : ptr<function, vec3<i32>>,  exit_3 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S127 : bool = Walk_leave_rounded_0(this_16, &((*voxel_11)), exit_3);
        return _S127;
    }
    var t_6 : vec3<f32> = Walk_crossings_0(this_16, exit_3);
    var t_first_1 : f32 = min_element_0(t_6);
    if(t_first_1 > (this_16.t_end_0))
    {
        return false;
    }
    var is_x_1 : bool = (t_6.x) == t_first_1;
    var _S128 : bool = !is_x_1;
    var is_y_1 : bool;
    if(_S128)
    {
        is_y_1 = (t_6.y) == t_first_1;
    }
    else
    {
        is_y_1 = false;
    }
    var _S129 : vec3<i32> = (*voxel_11);
    var _S130 : bool;
    if(_S128)
    {
        _S130 = !is_y_1;
    }
    else
    {
        _S130 = false;
    }
    (*voxel_11) = Walk_arrive_0(this_16, _S129, t_first_1, vec3<bool>(is_x_1, is_y_1, _S130), exit_3);
    return true;
}

fn first_voxel_0( _S131 : u32,  _S132 : Walk_0,  _S133 : ptr<function, vec3<i32>>) -> bool
{
    var _S134 : Walk_0 = _S132;
    var _S135 : vec3<i32> = vec3<i32>(i32(0));
    (*_S133) = _S135;
    var voxel_12 : vec3<i32> = Walk_start_voxel_0(_S132);
    var _S136 : bool = Walk_enter_0(_S132, &(voxel_12), cell_of_0(grids_0[_S131].min_0) - _S134.grid_origin_0, cell_of_0(grids_0[_S131].max_0) - _S134.grid_origin_0);
    if(!_S136)
    {
        return false;
    }
    var octant_2 : u32 = LocalRay_octant_0(_S134.ray_5);
    var _S137 : u32 = flip_of_0(octant_2);
    var top_shift_1 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_1 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_1 = grids_0[_S131].top_shift_0;
    }
    var top_size_1 : vec3<i32> = cell_of_0(grids_0[_S131].top_size_0);
    var _S138 : i32 = top_size_1.x;
    var stride_0 : vec3<i32> = vec3<i32>(i32(1), _S138, _S138 * top_size_1.y);
    var _S139 : i32 = i32(grids_0[_S131].top_offset_0) - dot_cells_0((stride_0 & ((_S134.mirror_0))), vec3<i32>(i32(1)));
    var _S140 : vec3<i32> = Walk_mirrored_plane_0(_S134, stride_0);
    var _S141 : u32 = ahead_of_0(_S134.mirror_0);
    var end_0 : vec3<i32> = select((top_size_1 << (vec3<u32>(top_shift_1))), _S135, (_S134.mirror_0) != _S135);
    if(!IS_EXACT_0)
    {
        _S134.t_end_0 = min(_S134.t_end_0, min_element_0(Walk_crossings_0(_S134, end_0)));
    }
    var is_found_4 : bool = false;
    for(;;)
    {
        var _S142 : bool;
        if(IS_EXACT_0)
        {
            _S142 = (any((voxel_12 >= end_0)));
        }
        else
        {
            _S142 = false;
        }
        if(_S142)
        {
            break;
        }
        var cell_13 : u32 = cells_0[_S139 + dot_cells_0(_S140, (voxel_12 >> (vec3<u32>(top_shift_1))))];
        var cell_14 : u32;
        var shift_4 : u32;
        var is_found_5 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_13 & (u32(2147483648)))) != u32(0))
            {
                cell_14 = cells_0[((cell_13 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_12, u32(3))) ^ (_S137)))];
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
                    is_found_5 = shift_4 > u32(3);
                }
                else
                {
                    is_found_5 = false;
                }
                var _S143 : bool;
                if(is_found_5)
                {
                    _S143 = ((cell_14 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S143 = false;
                }
                if(_S143)
                {
                }
                else
                {
                    break;
                }
                var shift_5 : u32 = shift_4 - u32(2);
                cell_14 = cells_0[((cell_14 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_12, shift_5)) ^ (_S137)))];
                shift_4 = shift_5;
            }
        }
        var exit_4 : vec3<i32>;
        if(((cell_14 & (u32(2147483648)))) == u32(0))
        {
            exit_4 = ((voxel_12 | (vec3<i32>((((i32(1) << (shift_4))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_14, _S141)) << (vec3<u32>(shift_4))));
            is_found_5 = is_found_4;
        }
        else
        {
            var record_2 : u32 = record_of_cell_0(cell_14);
            var blocks_1 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_1 = blocks_of_cell_0(cell_14);
            }
            else
            {
                blocks_1 = blocks_of_record_0(record_2);
            }
            var low_bits_0 : u32 = empty_around_0(record_2, blocks_1, voxel_12, octant_2, _S137);
            var is_found_6 : bool = low_bits_0 == u32(4294967295);
            if(is_found_6)
            {
                is_found_4 = is_found_6;
                break;
            }
            exit_4 = ((voxel_12 | (vec3<i32>(i32(low_bits_0))))) + vec3<i32>(i32(1));
            is_found_5 = is_found_6;
        }
        var _S144 : bool = Walk_leave_0(_S134, &(voxel_12), exit_4);
        if(!_S144)
        {
            is_found_4 = is_found_5;
            break;
        }
        is_found_4 = is_found_5;
    }
    (*_S133) = Walk_mirrored_0(_S134, voxel_12) + _S134.grid_origin_0;
    return is_found_4;
}

fn ray_of_walk_0( walk_1 : Walk_0,  ray_9 : Ray_0) -> Ray_0
{
    var is_mirrored_1 : vec3<bool> = (walk_1.mirror_0) != vec3<i32>(i32(0));
    return Ray_x24init_0(select(walk_1.origin_8, (vec3<f32>(0) - walk_1.origin_8), is_mirrored_1) + vec3<f32>(walk_1.grid_origin_0), ray_9.t_min_1, select(walk_1.speed_1, (vec3<f32>(0) - walk_1.speed_1), is_mirrored_1), ray_9.t_max_1);
}

fn hit_of_0( ray_10 : LocalRay_0,  voxel_13 : vec3<i32>,  instance_6 : u32) -> Hit_0
{
    var _S145 : vec3<f32>;
    var _S146 : bool;
    var last_0 : Crossing_0;
    var _S147 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S145 = ray_10.direction_8;
                if((ray_10.direction_8[u32(0)]) == 0.0f)
                {
                    last_0 = _S147;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_10, u32(0), voxel_13[u32(0)] + i32((ray_10.direction_8[u32(0)]) < 0.0f));
                if((_S147.axis_3) == u32(3))
                {
                    _S146 = true;
                }
                else
                {
                    _S146 = !Crossing_is_before_0(crossing_3, _S147);
                }
                if(_S146)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S147;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S148 : vec3<f32> = _S145;
                if((_S145[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_10, u32(1), voxel_13[u32(1)] + i32((_S148[u32(1)]) < 0.0f));
                if((last_0.axis_3) == u32(3))
                {
                    _S146 = true;
                }
                else
                {
                    _S146 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S146)
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
                var _S149 : vec3<f32> = _S145;
                if((_S145[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_10, u32(2), voxel_13[u32(2)] + i32((_S149[u32(2)]) < 0.0f));
                if((last_0.axis_3) == u32(3))
                {
                    _S146 = true;
                }
                else
                {
                    _S146 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S146)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S150 : Crossing_0 = last_0;
    var is_negative_4 : bool = (_S145[last_0.axis_3]) < 0.0f;
    var t_7 : f32 = (f32(voxel_13[last_0.axis_3] + i32(is_negative_4)) - ray_10.origin_6[last_0.axis_3]) * ray_10.inverse_0[last_0.axis_3];
    var _S151 : f32;
    if(t_7 > (ray_10.t_min_3))
    {
        _S151 = t_7;
    }
    else
    {
        _S151 = ray_10.t_min_3;
    }
    return Hit_x24init_0(_S151, instance_6, voxel_13, u32(2) * _S150.axis_3 + u32(is_negative_4));
}

fn hit_of_walk_0( walk_2 : Walk_0,  voxel_14 : vec3<i32>,  instance_7 : u32) -> Hit_0
{
    var t_8 : vec3<f32> = Walk_crossings_0(walk_2, Walk_mirrored_0(walk_2, voxel_14 - walk_2.grid_origin_0));
    var last_1 : f32 = max_element_0(t_8);
    var _S152 : i32;
    if((t_8.z) == last_1)
    {
        _S152 = i32(2);
    }
    else
    {
        if((t_8.y) == last_1)
        {
            _S152 = i32(1);
        }
        else
        {
            _S152 = i32(0);
        }
    }
    var axis_6 : u32 = u32(_S152);
    return Hit_x24init_0(max(last_1, walk_2.ray_5.t_min_3), instance_7, voxel_14, u32(2) * axis_6 + u32((walk_2.mirror_0[axis_6]) != i32(0)));
}

fn hit_in_0( instance_8 : u32,  ray_11 : ptr<function, Ray_0>) -> Hit_0
{
    var _S153 : LocalRay_0 = local_ray_0((*ray_11), instance_8);
    if(!_S153.is_valid_0)
    {
        return miss_0();
    }
    var _S154 : Walk_0 = walk_of_0(_S153, instances_0[instance_8].grid_0);
    var voxel_15 : vec3<i32>;
    var _S155 : bool = first_voxel_0(instances_0[instance_8].grid_0, _S154, &(voxel_15));
    var _S156 : bool;
    if(IS_SINGLE_0)
    {
        _S156 = !IS_EXACT_0;
    }
    else
    {
        _S156 = false;
    }
    if(_S156)
    {
        (*ray_11) = ray_of_walk_0(_S154, (*ray_11));
    }
    if(!_S155)
    {
        return miss_0();
    }
    var hit_5 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_5 = hit_of_0(_S153, voxel_15, instance_8);
    }
    else
    {
        hit_5 = hit_of_walk_0(_S154, voxel_15, instance_8);
    }
    if((hit_5.t_1) > ((*ray_11).t_max_1))
    {
        return miss_0();
    }
    return hit_5;
}

fn entry_0( _S157 : u32,  _S158 : Ray_0,  _S159 : vec3<f32>) -> f32
{
    var low_10 : vec3<f32> = (vector_of_0(instance_nodes_0[_S157].min_1) - _S158.origin_2) * _S159;
    var high_5 : vec3<f32> = (vector_of_0(instance_nodes_0[_S157].max_1) - _S158.origin_2) * _S159;
    var _S160 : f32 = max(_S158.t_min_1, max_element_0(min(low_10, high_5)));
    var _S161 : f32;
    if(_S160 <= (min(_S158.t_max_1, min_element_0(max(low_10, high_5)))))
    {
        _S161 = _S160;
    }
    else
    {
        _S161 = (bitcast<f32>((u32(2139095040))));
    }
    return _S161;
}

fn visit_0( given_0 : ptr<function, Ray_0>,  is_any_enough_0 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S162 : Hit_0 = hit_in_0(u32(0), &((*given_0)));
        return _S162;
    }
    var ray_12 : Ray_0 = (*given_0);
    var nearest_2 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_2;
    }
    var is_still_1 : vec3<bool> = !((abs(ray_12.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S163 : vec3<f32> = select(vec3<f32>(1.0f) / select(ray_12.direction_1, vec3<f32>(1.0f), is_still_1), vec3<f32>(3.4028234663852886e+38f), is_still_1);
    var stack_0 : array<u32, i32(32)>;
    var near_0 : u32 = u32(0);
    var nearest_3 : Hit_0 = nearest_2;
    var depth_1 : u32 = u32(0);
    for(;;)
    {
        var depth_2 : u32;
        if((instance_nodes_0[near_0].is_leaf_0) != u32(0))
        {
            var hit_6 : Hit_0 = hit_in_0(instance_nodes_0[near_0].index_0, &(ray_12));
            var _S164 : Hit_0 = nearest_3;
            var _S165 : bool;
            if((hit_6.t_1) < (nearest_3.t_1))
            {
                _S165 = true;
            }
            else
            {
                if((hit_6.t_1) == (_S164.t_1))
                {
                    _S165 = (hit_6.instance_2) < (nearest_3.instance_2);
                }
                else
                {
                    _S165 = false;
                }
            }
            var nearest_4 : Hit_0;
            if(_S165)
            {
                ray_12.t_max_1 = hit_6.t_1;
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
            var _S166 : u32 = near_0 + u32(1);
            var _S167 : f32 = entry_0(_S166, ray_12, _S163);
            var _S168 : u32 = instance_nodes_0[near_0].index_0;
            var _S169 : f32 = entry_0(instance_nodes_0[near_0].index_0, ray_12, _S163);
            var _S170 : bool = _S167 <= _S169;
            if(_S170)
            {
                near_0 = _S166;
            }
            else
            {
                near_0 = _S168;
            }
            var far_1 : u32;
            if(_S170)
            {
                far_1 = _S168;
            }
            else
            {
                far_1 = _S166;
            }
            var INFINITY_0 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S167, _S169)) < INFINITY_0)
            {
                var _S171 : u32 = depth_1 + u32(1);
                stack_0[depth_1] = far_1;
                depth_2 = _S171;
            }
            else
            {
                depth_2 = depth_1;
            }
            if((min(_S167, _S169)) < INFINITY_0)
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

fn WalkTracer_is_occluded_0( ray_13 : Ray_0) -> bool
{
    var copy_0 : Ray_0 = ray_13;
    var _S172 : Hit_0 = visit_0(&(copy_0), true);
    return !Hit_is_miss_0(_S172);
}

fn cosine_hemisphere_0( u_5 : f32,  v_3 : f32) -> vec3<f32>
{
    var radius_1 : f32 = sqrt(u_5);
    var sin_cos_1 : vec2<f32> = sincos_turns_0(v_3);
    return vec3<f32>(radius_1 * sin_cos_1.y, radius_1 * sin_cos_1.x, sqrt(1.0f - u_5));
}

fn Surface_world_direction_0( this_17 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var away_2 : f32;
    if((((this_17.face_4) & (u32(1)))) == u32(1))
    {
        away_2 = local_3.z;
    }
    else
    {
        away_2 = - local_3.z;
    }
    var _S173 : f32 = local_3.x;
    var _S174 : f32 = local_3.y;
    var _S175 : vec3<f32> = vec3<f32>(_S173, _S174, away_2);
    var in_grid_1 : vec3<f32>;
    if((this_17.face_4) < u32(2))
    {
        in_grid_1 = vec3<f32>(away_2, _S173, _S174);
    }
    else
    {
        if((this_17.face_4) < u32(4))
        {
            in_grid_1 = vec3<f32>(_S174, away_2, _S173);
        }
        else
        {
            in_grid_1 = _S175;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_1(this_17.instance_4, in_grid_1);
    }
    return normalize_vector_0(in_grid_1);
}

fn PathTracing_advance_0( path_2 : ptr<function, Path_0>,  ray_14 : Ray_0,  hit_7 : Hit_0,  radiance_3 : ptr<function, vec3<f32>>,  next_0 : ptr<function, Ray_0>,  shadow_rays_0 : ptr<function, u32>) -> bool
{
    (*next_0) = ray_14;
    var last_2 : Receiver_0 = Receiver_x24init_0(ray_14.origin_2, (*path_2).normal_0);
    var light_pdf_1 : f32;
    var _S176 : bool;
    if(Hit_is_miss_0(hit_7))
    {
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * sky_gradient_0(ray_14.direction_1);
        if(has_sun_0())
        {
            _S176 = sun_contains_0(ray_14.direction_1);
        }
        else
        {
            _S176 = false;
        }
        if(_S176)
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
            light_pdf_1 = light_emitter_pdf_0(last_2, ray_14, hit_7);
        }
        (*radiance_3) = (*radiance_3) + (*path_2).beta_0 * emitted_0(material_2) * vec3<f32>(weight_of_bounce_0((*path_2), light_pdf_1));
    }
    (*path_2).beta_0 = (*path_2).beta_0 * vector_of_0(material_2.base_color_0);
    var u_6 : vec4<f32> = Sampler_stratified_0((*path_2).sampler_0, Path_dimension_scatter_0((*path_2)));
    if(((*path_2).bounce_0) == (params_0.max_bounces_0))
    {
        _S176 = true;
    }
    else
    {
        _S176 = (max_element_0((*path_2).beta_0)) <= 0.0f;
    }
    if(_S176)
    {
        _S176 = true;
    }
    else
    {
        var _S177 : bool = survives_0(&((*path_2)), u_6.z);
        _S176 = !_S177;
    }
    if(_S176)
    {
        return false;
    }
    var surface_1 : Surface_0 = surface_of_0(ray_14, hit_7);
    var sample_5 : LightSample_0;
    var _S178 : bool = sample_light_0(Receiver_x24init_0(surface_1.origin_3, surface_1.normal_3), Sampler_stratified_0((*path_2).sampler_0, Path_dimension_light_0((*path_2))), &(sample_5));
    if(_S178)
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
    var _S179 : Sampler_0;
    _S179.seed_1 = seed_3;
    _S179.pixel_0 = pixel_1;
    _S179.sample_0 = sample_6;
    return _S179;
}

fn sampler_of_0( pixel_2 : u32,  sample_7 : u32) -> Sampler_0
{
    return Sampler_x24init_0(params_0.seed_0, pixel_2, params_0.first_sample_0 + sample_7);
}

fn Path_x24init_0( sampler_1 : Sampler_0,  bounce_1 : u32,  beta_1 : vec3<f32>,  pdf_3 : f32,  normal_4 : vec3<f32>) -> Path_0
{
    var _S180 : Path_0;
    _S180.sampler_0 = sampler_1;
    _S180.bounce_0 = bounce_1;
    _S180.beta_0 = beta_1;
    _S180.pdf_0 = pdf_3;
    _S180.normal_0 = normal_4;
    return _S180;
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
    var _S181 : CameraFrame_0;
    _S181.eye_1 = eye_2;
    _S181.corner_1 = corner_2;
    _S181.pixel_x_1 = pixel_x_2;
    _S181.pixel_y_1 = pixel_y_2;
    return _S181;
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

fn CameraFrame_ray_0( this_18 : CameraFrame_0,  position_3 : vec2<f32>) -> Ray_0
{
    var direction_10 : vec3<f32> = this_18.corner_1 + this_18.pixel_x_1 * vec3<f32>(position_3.x) + this_18.pixel_y_1 * vec3<f32>(position_3.y);
    return ray_from_0(this_18.eye_1, direction_10 * vec3<f32>((1.0f / sqrt(length_squared_0(direction_10)))));
}

fn PathTracing_clip_0( ray_15 : Ray_0) -> Ray_0
{
    return ray_15;
}

fn camera_path_0( pixel_4 : u32,  sample_8 : u32,  path_3 : ptr<function, Path_0>) -> Ray_0
{
    (*path_3) = Path_x24init_0(sampler_of_0(pixel_4, sample_8), u32(0), vec3<f32>(1.0f), 0.0f, vec3<f32>(0.0f));
    var jitter_0 : vec4<f32> = PathTracing_jitter_0((*path_3).sampler_0);
    var _S182 : CameraFrame_0 = FrameParams_camera_0();
    var _S183 : vec2<u32> = position_of_0(pixel_4);
    return PathTracing_clip_0(CameraFrame_ray_0(_S182, vec2<f32>(_S183) + jitter_0.xy));
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
    var _S184 : RayCounts_0;
    _S184.bounce_2 = bounce_3;
    _S184.shadow_0 = shadow_1;
    return _S184;
}

fn Walk_enter_1( this_19 : Walk_0,  voxel_16 : ptr<function, vec3<i32>>,  low_11 : vec3<i32>,  high_6 : vec3<i32>) -> bool
{
    var is_mirrored_2 : vec3<bool> = (this_19.mirror_0) != vec3<i32>(i32(0));
    var _S185 : vec3<i32> = select(low_11, (vec3<i32>(0) - high_6), is_mirrored_2);
    var far_2 : vec3<i32> = select(high_6, (vec3<i32>(0) - low_11), is_mirrored_2);
    for(;;)
    {
        var is_before_2 : vec3<bool> = (*voxel_16) < _S185;
        if(!(any((is_before_2))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_19.speed_1) <= vec3<f32>(slowest_0()), is_before_2)))))
        {
            return false;
        }
        var t_9 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_19, _S185), is_before_2);
        var t_last_1 : f32 = max_element_0(t_9);
        if(t_last_1 > (this_19.t_end_0))
        {
            return false;
        }
        var is_x_2 : bool = (t_9.x) == t_last_1;
        var _S186 : bool = !is_x_2;
        var is_y_2 : bool;
        if(_S186)
        {
            is_y_2 = (t_9.y) == t_last_1;
        }
        else
        {
            is_y_2 = false;
        }
        var _S187 : bool;
        if(_S186)
        {
            _S187 = !is_y_2;
        }
        else
        {
            _S187 = false;
        }
        var is_axis_3 : vec3<bool> = vec3<bool>(is_x_2, is_y_2, _S187);
        (*voxel_16) = Walk_arrive_0(this_19, (*voxel_16), t_last_1, is_axis_3, select(vec3<i32>(i32(1073741823)), _S185, is_axis_3));
    }
    return (all(((*voxel_16) < far_2)));
}

fn Walk_leave_rounded_1( this_20 : Walk_0,  voxel_17 : ptr<function, vec3<i32>>,  exit_5 : vec3<i32>) -> bool
{
    var t_10 : vec3<f32> = Walk_crossings_0(this_20, exit_5);
    var t_first_2 : f32 = min_element_0(t_10);
    if(t_first_2 >= (this_20.t_end_0))
    {
        return false;
    }
    (*voxel_17) = max(exit_5 - vec3<i32>(ceil((t_10 - vec3<f32>(t_first_2)) * this_20.speed_1)), (*voxel_17));
    return true;
}

fn Walk_leave_1( this_21 : Walk_0,  voxel_18 : ptr<function, vec3<i32>>,  exit_6 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S188 : bool = Walk_leave_rounded_1(this_21, &((*voxel_18)), exit_6);
        return _S188;
    }
    var t_11 : vec3<f32> = Walk_crossings_0(this_21, exit_6);
    var t_first_3 : f32 = min_element_0(t_11);
    if(t_first_3 > (this_21.t_end_0))
    {
        return false;
    }
    var is_x_3 : bool = (t_11.x) == t_first_3;
    var _S189 : bool = !is_x_3;
    var is_y_3 : bool;
    if(_S189)
    {
        is_y_3 = (t_11.y) == t_first_3;
    }
    else
    {
        is_y_3 = false;
    }
    var _S190 : vec3<i32> = (*voxel_18);
    var _S191 : bool;
    if(_S189)
    {
        _S191 = !is_y_3;
    }
    else
    {
        _S191 = false;
    }
    (*voxel_18) = Walk_arrive_0(this_21, _S190, t_first_3, vec3<bool>(is_x_3, is_y_3, _S191), exit_6);
    return true;
}

fn first_voxel_1( _S192 : u32,  _S193 : Walk_0,  _S194 : ptr<function, vec3<i32>>) -> bool
{
    var _S195 : Walk_0 = _S193;
    var _S196 : vec3<i32> = vec3<i32>(i32(0));
    (*_S194) = _S196;
    var voxel_19 : vec3<i32> = Walk_start_voxel_0(_S193);
    var _S197 : bool = Walk_enter_1(_S193, &(voxel_19), cell_of_0(grids_0[_S192].min_0) - _S195.grid_origin_0, cell_of_0(grids_0[_S192].max_0) - _S195.grid_origin_0);
    if(!_S197)
    {
        return false;
    }
    var octant_3 : u32 = LocalRay_octant_0(_S195.ray_5);
    var _S198 : u32 = flip_of_0(octant_3);
    var top_shift_2 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_2 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_2 = grids_0[_S192].top_shift_0;
    }
    var top_size_2 : vec3<i32> = cell_of_0(grids_0[_S192].top_size_0);
    var _S199 : i32 = top_size_2.x;
    var stride_1 : vec3<i32> = vec3<i32>(i32(1), _S199, _S199 * top_size_2.y);
    var _S200 : i32 = i32(grids_0[_S192].top_offset_0) - dot_cells_0((stride_1 & ((_S195.mirror_0))), vec3<i32>(i32(1)));
    var _S201 : vec3<i32> = Walk_mirrored_plane_0(_S195, stride_1);
    var _S202 : u32 = ahead_of_0(_S195.mirror_0);
    var end_1 : vec3<i32> = select((top_size_2 << (vec3<u32>(top_shift_2))), _S196, (_S195.mirror_0) != _S196);
    if(!IS_EXACT_0)
    {
        _S195.t_end_0 = min(_S195.t_end_0, min_element_0(Walk_crossings_0(_S195, end_1)));
    }
    var is_found_7 : bool = false;
    for(;;)
    {
        var _S203 : bool;
        if(IS_EXACT_0)
        {
            _S203 = (any((voxel_19 >= end_1)));
        }
        else
        {
            _S203 = false;
        }
        if(_S203)
        {
            break;
        }
        var cell_15 : u32 = cells_0[_S200 + dot_cells_0(_S201, (voxel_19 >> (vec3<u32>(top_shift_2))))];
        var cell_16 : u32;
        var shift_6 : u32;
        var is_found_8 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_15 & (u32(2147483648)))) != u32(0))
            {
                cell_16 = cells_0[((cell_15 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_19, u32(3))) ^ (_S198)))];
                shift_6 = u32(3);
            }
            else
            {
                cell_16 = cell_15;
                shift_6 = top_shift_2;
            }
        }
        else
        {
            cell_16 = cell_15;
            shift_6 = top_shift_2;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_8 = shift_6 > u32(3);
                }
                else
                {
                    is_found_8 = false;
                }
                var _S204 : bool;
                if(is_found_8)
                {
                    _S204 = ((cell_16 & (u32(2147483648)))) != u32(0);
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
                var shift_7 : u32 = shift_6 - u32(2);
                cell_16 = cells_0[((cell_16 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_19, shift_7)) ^ (_S198)))];
                shift_6 = shift_7;
            }
        }
        var exit_7 : vec3<i32>;
        if(((cell_16 & (u32(2147483648)))) == u32(0))
        {
            exit_7 = ((voxel_19 | (vec3<i32>((((i32(1) << (shift_6))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_16, _S202)) << (vec3<u32>(shift_6))));
            is_found_8 = is_found_7;
        }
        else
        {
            var record_3 : u32 = record_of_cell_0(cell_16);
            var blocks_2 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_2 = blocks_of_cell_0(cell_16);
            }
            else
            {
                blocks_2 = blocks_of_record_0(record_3);
            }
            var low_bits_1 : u32 = empty_around_0(record_3, blocks_2, voxel_19, octant_3, _S198);
            var is_found_9 : bool = low_bits_1 == u32(4294967295);
            if(is_found_9)
            {
                is_found_7 = is_found_9;
                break;
            }
            exit_7 = ((voxel_19 | (vec3<i32>(i32(low_bits_1))))) + vec3<i32>(i32(1));
            is_found_8 = is_found_9;
        }
        var _S205 : bool = Walk_leave_1(_S195, &(voxel_19), exit_7);
        if(!_S205)
        {
            is_found_7 = is_found_8;
            break;
        }
        is_found_7 = is_found_8;
    }
    (*_S194) = Walk_mirrored_0(_S195, voxel_19) + _S195.grid_origin_0;
    return is_found_7;
}

fn hit_in_1( instance_9 : u32,  ray_16 : ptr<function, Ray_0>) -> Hit_0
{
    var _S206 : LocalRay_0 = local_ray_0((*ray_16), instance_9);
    if(!_S206.is_valid_0)
    {
        return miss_0();
    }
    var _S207 : Walk_0 = walk_of_0(_S206, instances_0[instance_9].grid_0);
    var voxel_20 : vec3<i32>;
    var _S208 : bool = first_voxel_1(instances_0[instance_9].grid_0, _S207, &(voxel_20));
    var _S209 : bool;
    if(IS_SINGLE_0)
    {
        _S209 = !IS_EXACT_0;
    }
    else
    {
        _S209 = false;
    }
    if(_S209)
    {
        (*ray_16) = ray_of_walk_0(_S207, (*ray_16));
    }
    if(!_S208)
    {
        return miss_0();
    }
    var hit_8 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_8 = hit_of_0(_S206, voxel_20, instance_9);
    }
    else
    {
        hit_8 = hit_of_walk_0(_S207, voxel_20, instance_9);
    }
    if((hit_8.t_1) > ((*ray_16).t_max_1))
    {
        return miss_0();
    }
    return hit_8;
}

fn visit_1( given_1 : ptr<function, Ray_0>,  is_any_enough_1 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S210 : Hit_0 = hit_in_1(u32(0), &((*given_1)));
        return _S210;
    }
    var ray_17 : Ray_0 = (*given_1);
    var nearest_5 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_5;
    }
    var is_still_2 : vec3<bool> = !((abs(ray_17.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S211 : vec3<f32> = select(vec3<f32>(1.0f) / select(ray_17.direction_1, vec3<f32>(1.0f), is_still_2), vec3<f32>(3.4028234663852886e+38f), is_still_2);
    var stack_1 : array<u32, i32(32)>;
    var near_1 : u32 = u32(0);
    var nearest_6 : Hit_0 = nearest_5;
    var depth_4 : u32 = u32(0);
    for(;;)
    {
        var depth_5 : u32;
        if((instance_nodes_0[near_1].is_leaf_0) != u32(0))
        {
            var hit_9 : Hit_0 = hit_in_1(instance_nodes_0[near_1].index_0, &(ray_17));
            var _S212 : Hit_0 = nearest_6;
            var _S213 : bool;
            if((hit_9.t_1) < (nearest_6.t_1))
            {
                _S213 = true;
            }
            else
            {
                if((hit_9.t_1) == (_S212.t_1))
                {
                    _S213 = (hit_9.instance_2) < (nearest_6.instance_2);
                }
                else
                {
                    _S213 = false;
                }
            }
            var nearest_7 : Hit_0;
            if(_S213)
            {
                ray_17.t_max_1 = hit_9.t_1;
                if(is_any_enough_1)
                {
                    return hit_9;
                }
                nearest_7 = hit_9;
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
            var _S214 : u32 = near_1 + u32(1);
            var _S215 : f32 = entry_0(_S214, ray_17, _S211);
            var _S216 : u32 = instance_nodes_0[near_1].index_0;
            var _S217 : f32 = entry_0(instance_nodes_0[near_1].index_0, ray_17, _S211);
            var _S218 : bool = _S215 <= _S217;
            if(_S218)
            {
                near_1 = _S214;
            }
            else
            {
                near_1 = _S216;
            }
            var far_3 : u32;
            if(_S218)
            {
                far_3 = _S216;
            }
            else
            {
                far_3 = _S214;
            }
            var INFINITY_1 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S215, _S217)) < INFINITY_1)
            {
                var _S219 : u32 = depth_4 + u32(1);
                stack_1[depth_4] = far_3;
                depth_5 = _S219;
            }
            else
            {
                depth_5 = depth_4;
            }
            if((min(_S215, _S217)) < INFINITY_1)
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

fn WalkTracer_trace_0( ray_18 : ptr<function, Ray_0>) -> Hit_0
{
    var _S220 : Hit_0 = visit_1(&((*ray_18)), false);
    return _S220;
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

fn fixed_point_0( value_2 : f32) -> vec2<u32>
{
    if(!(value_2 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_3 : u32 = (bitcast<u32>((min(value_2, 1.048576e+06f))));
    var shift_8 : i32 = i32((bits_3 >> (u32(23)))) - i32(118);
    var mantissa_0 : u32 = (((bits_3 & (u32(8388607)))) | (u32(8388608)));
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
        var _S221 : u32 = (mantissa_0 << (u32(shift_8)));
        var _S222 : u32;
        if(shift_8 == i32(0))
        {
            _S222 = u32(0);
        }
        else
        {
            _S222 = (mantissa_0 >> (u32(i32(32) - shift_8)));
        }
        return vec2<u32>(_S221, _S222);
    }
    return vec2<u32>(u32(0), (mantissa_0 << (u32(shift_8 - i32(32)))));
}

fn PixelRecord_add_0( this_22 : ptr<function, PixelRecord_0>,  value_3 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_3[u32(0)]);
    var _S223 : u32 = addend_0.x;
    var low_12 : u32 = (*this_22).radiance_0[u32(0)] + _S223;
    var high_7 : u32 = (*this_22).radiance_0[u32(1)] + addend_0.y + u32(low_12 < _S223);
    var is_full_0 : bool = high_7 < ((*this_22).radiance_0[u32(1)]);
    var _S224 : u32;
    if(is_full_0)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = low_12;
    }
    (*this_22).radiance_0[u32(0)] = _S224;
    if(is_full_0)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = high_7;
    }
    (*this_22).radiance_0[u32(1)] = _S224;
    var addend_1 : vec2<u32> = fixed_point_0(value_3[u32(1)]);
    var _S225 : u32 = addend_1.x;
    var low_13 : u32 = (*this_22).radiance_0[u32(2)] + _S225;
    var high_8 : u32 = (*this_22).radiance_0[u32(3)] + addend_1.y + u32(low_13 < _S225);
    var is_full_1 : bool = high_8 < ((*this_22).radiance_0[u32(3)]);
    if(is_full_1)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = low_13;
    }
    (*this_22).radiance_0[u32(2)] = _S224;
    if(is_full_1)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = high_8;
    }
    (*this_22).radiance_0[u32(3)] = _S224;
    var addend_2 : vec2<u32> = fixed_point_0(value_3[u32(2)]);
    var _S226 : u32 = addend_2.x;
    var low_14 : u32 = (*this_22).radiance_0[u32(4)] + _S226;
    var high_9 : u32 = (*this_22).radiance_0[u32(5)] + addend_2.y + u32(low_14 < _S226);
    var is_full_2 : bool = high_9 < ((*this_22).radiance_0[u32(5)]);
    if(is_full_2)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = low_14;
    }
    (*this_22).radiance_0[u32(4)] = _S224;
    if(is_full_2)
    {
        _S224 = u32(4294967295);
    }
    else
    {
        _S224 = high_9;
    }
    (*this_22).radiance_0[u32(5)] = _S224;
    (*this_22).samples_0 = (*this_22).samples_0 + u32(1);
    (*this_22).covered_0 = (*this_22).covered_0 + u32(is_covered_0);
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
    var _S227 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_5 : vec3<f32> = _S227;
    var path_4 : Path_0;
    var _S228 : Ray_0 = camera_path_0(work_0.pixel_5, work_0.sample_9, &(path_4));
    var ray_19 : Ray_0 = _S228;
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
        var _S229 : Hit_0 = WalkTracer_trace_0(&(ray_19));
        if((path_4.bounce_0) == u32(0))
        {
            is_covered_2 = !Hit_is_miss_0(_S229);
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
            var _S230 : u32 = counts_0.shadow_0;
            var _S231 : bool = PathTracing_advance_0(&(path_4), ray_19, _S229, &(radiance_5), &(ray_19), &(_S230));
            counts_0.shadow_0 = _S230;
            goes_on_1 = _S231;
        }
        else
        {
            goes_on_1 = goes_on_0;
        }
        if(!goes_on_1)
        {
            var _S232 : vec2<u32> = position_of_0(work_0.pixel_5);
            add_sample_0(place_of_0(_S232), radiance_5, is_covered_2);
            radiance_5 = _S227;
            var sample_11 : u32 = sample_10 + u32(1);
            if(sample_11 == (work_0.last_3))
            {
                break;
            }
            var _S233 : Ray_0 = camera_path_0(work_0.pixel_5, sample_11, &(path_4));
            ray_19 = _S233;
            sample_10 = sample_11;
        }
    }
    return counts_0;
}

fn Sampler_independent_0( this_23 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_23.pixel_0, this_23.sample_0, dimension_2, this_23.seed_1)));
}

fn Essay_clip_0( ray_20 : Ray_0) -> Ray_0
{
    return Ray_x24init_0(ray_20.origin_2, 0.10000000149011612f, ray_20.direction_1, 10000.0f);
}

fn Essay_advance_0( path_5 : ptr<function, Path_0>,  ray_21 : Ray_0,  hit_10 : Hit_0,  radiance_6 : ptr<function, vec3<f32>>,  next_1 : ptr<function, Ray_0>,  shadow_rays_1 : ptr<function, u32>) -> bool
{
    (*next_1) = ray_21;
    if(Hit_is_miss_0(hit_10))
    {
        (*radiance_6) = (*radiance_6) + (*path_5).beta_0 * sky_gradient_0(ray_21.direction_1);
        return false;
    }
    var material_3 : PackedMaterial_0 = material_of_0(hit_10);
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
    var surface_2 : Surface_0 = surface_of_0(ray_21, hit_10);
    (*path_5).beta_0 = (*path_5).beta_0 * vector_of_0(material_3.base_color_0);
    (*path_5).bounce_0 = (*path_5).bounce_0 + u32(1);
    (*next_1) = Essay_clip_0(ray_from_0(surface_2.origin_3, Surface_world_direction_0(surface_2, cosine_hemisphere_0(u_7.x, u_7.y))));
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
    var _S234 : CameraFrame_0 = FrameParams_camera_0();
    var _S235 : vec2<u32> = position_of_0(pixel_7);
    return Essay_clip_0(CameraFrame_ray_0(_S234, vec2<f32>(_S235) + jitter_1.xy));
}

fn trace_pixel_1( work_1 : Work_0) -> RayCounts_0
{
    var counts_1 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var _S236 : vec3<f32> = vec3<f32>(0.0f);
    var radiance_7 : vec3<f32> = _S236;
    var path_7 : Path_0;
    var _S237 : Ray_0 = camera_path_1(work_1.pixel_5, work_1.sample_9, &(path_7));
    var ray_22 : Ray_0 = _S237;
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
        var _S238 : Hit_0 = WalkTracer_trace_0(&(ray_22));
        if((path_7.bounce_0) == u32(0))
        {
            is_covered_3 = !Hit_is_miss_0(_S238);
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
            var _S239 : u32 = counts_1.shadow_0;
            var _S240 : bool = Essay_advance_0(&(path_7), ray_22, _S238, &(radiance_7), &(ray_22), &(_S239));
            counts_1.shadow_0 = _S239;
            goes_on_3 = _S240;
        }
        else
        {
            goes_on_3 = goes_on_2;
        }
        if(!goes_on_3)
        {
            var _S241 : vec2<u32> = position_of_0(work_1.pixel_5);
            add_sample_0(place_of_0(_S241), radiance_7, is_covered_3);
            radiance_7 = _S236;
            var sample_14 : u32 = sample_13 + u32(1);
            if(sample_14 == (work_1.last_3))
            {
                break;
            }
            var _S242 : Ray_0 = camera_path_1(work_1.pixel_5, sample_14, &(path_7));
            ray_22 = _S242;
            sample_13 = sample_14;
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

fn Work_x24init_0( pixel_8 : u32,  sample_15 : u32,  last_4 : u32) -> Work_0
{
    var _S243 : Work_0;
    _S243.pixel_5 = pixel_8;
    _S243.sample_9 = sample_15;
    _S243.last_3 = last_4;
    return _S243;
}

fn work_of_0( index_8 : u32) -> Work_0
{
    var size_0 : vec2<u32> = params_0.region_0.zw - params_0.region_0.xy;
    var _S244 : u32 = size_0.x;
    var _S245 : u32 = u32(8) * _S244;
    var band_0 : u32 = index_8 / _S245;
    var _S246 : u32 = u32(8) * band_0;
    var in_band_0 : u32 = index_8 - _S245 * band_0;
    var _S247 : u32 = u32(8) * min(u32(8), size_0.y - _S246);
    var tile_0 : u32 = in_band_0 / _S247;
    var _S248 : u32 = u32(8) * tile_0;
    var _S249 : u32 = min(u32(8), _S244 - _S248);
    var in_tile_0 : u32 = in_band_0 - _S247 * tile_0;
    var _S250 : vec2<u32> = params_0.region_0.xy;
    var _S251 : u32 = in_tile_0 % _S249;
    var _S252 : u32 = _S248 + _S251;
    var _S253 : u32 = in_tile_0 / _S249;
    var at_2 : vec2<u32> = _S250 + vec2<u32>(_S252, _S246 + _S253);
    return Work_x24init_0(at_2.y * params_0.width_0 + at_2.x, pixels_0[place_of_0(at_2)].samples_0, min(dispatch_0.samples_target_0, pixels_0[place_of_0(at_2)].samples_0 + dispatch_0.samples_1));
}

fn Work_camera_rays_0( this_24 : Work_0) -> u32
{
    return max(this_24.last_3, this_24.sample_9) - this_24.sample_9;
}

fn tally_camera_rays_0( count_6 : u32)
{
    var _S254 : u32 = atomicAdd(&(group_counts_0[i32(0)]), count_6);
    return;
}

fn end_tally_0( counts_2 : RayCounts_0,  thread_1 : u32)
{
    var _S255 : u32 = atomicAdd(&(group_counts_0[i32(1)]), counts_2.bounce_2);
    var _S256 : u32 = atomicAdd(&(group_counts_0[i32(2)]), counts_2.shadow_0);
    workgroupBarrier();
    if(thread_1 < u32(3))
    {
        var _S257 : u32 = atomicLoad(&(group_counts_0[thread_1]));
        var _S258 : u32 = atomicAdd(&(counters_0[u32(1) + thread_1]), _S257);
    }
    if(thread_1 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S259 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

fn render_0( index_9 : u32,  thread_2 : u32)
{
    begin_tally_0(thread_2);
    var _S260 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_3 : RayCounts_0;
    if(index_9 < (dispatch_0.count_0))
    {
        var work_2 : Work_0 = work_of_0(dispatch_0.first_0 + index_9);
        tally_camera_rays_0(Work_camera_rays_0(work_2));
        var _S261 : RayCounts_0 = trace_pixel_0(work_2);
        counts_3 = _S261;
    }
    else
    {
        counts_3 = _S260;
    }
    end_tally_0(counts_3, thread_2);
    return;
}

fn render_1( index_10 : u32,  thread_3 : u32)
{
    begin_tally_0(thread_3);
    var _S262 : RayCounts_0 = RayCounts_x24init_0(u32(0), u32(0));
    var counts_4 : RayCounts_0;
    if(index_10 < (dispatch_0.count_0))
    {
        var work_3 : Work_0 = work_of_0(dispatch_0.first_0 + index_10);
        tally_camera_rays_0(Work_camera_rays_0(work_3));
        var _S263 : RayCounts_0 = trace_pixel_1(work_3);
        counts_4 = _S263;
    }
    else
    {
        counts_4 = _S262;
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

fn Walk_enter_2( this_25 : Walk_0,  voxel_21 : ptr<function, vec3<i32>>,  low_15 : vec3<i32>,  high_10 : vec3<i32>) -> bool
{
    var is_mirrored_3 : vec3<bool> = (this_25.mirror_0) != vec3<i32>(i32(0));
    var _S264 : vec3<i32> = select(low_15, (vec3<i32>(0) - high_10), is_mirrored_3);
    var far_4 : vec3<i32> = select(high_10, (vec3<i32>(0) - low_15), is_mirrored_3);
    for(;;)
    {
        var is_before_3 : vec3<bool> = (*voxel_21) < _S264;
        if(!(any((is_before_3))))
        {
            break;
        }
        if((any((select(vec3<bool>(false), (this_25.speed_1) <= vec3<f32>(slowest_0()), is_before_3)))))
        {
            return false;
        }
        var t_12 : vec3<f32> = select(vec3<f32>(-1.0f), Walk_crossings_0(this_25, _S264), is_before_3);
        var t_last_2 : f32 = max_element_0(t_12);
        if(t_last_2 > (this_25.t_end_0))
        {
            return false;
        }
        var is_x_4 : bool = (t_12.x) == t_last_2;
        var _S265 : bool = !is_x_4;
        var is_y_4 : bool;
        if(_S265)
        {
            is_y_4 = (t_12.y) == t_last_2;
        }
        else
        {
            is_y_4 = false;
        }
        var _S266 : bool;
        if(_S265)
        {
            _S266 = !is_y_4;
        }
        else
        {
            _S266 = false;
        }
        var is_axis_4 : vec3<bool> = vec3<bool>(is_x_4, is_y_4, _S266);
        (*voxel_21) = Walk_arrive_0(this_25, (*voxel_21), t_last_2, is_axis_4, select(vec3<i32>(i32(1073741823)), _S264, is_axis_4));
    }
    return (all(((*voxel_21) < far_4)));
}

fn Walk_leave_rounded_2( this_26 : Walk_0,  voxel_22 : ptr<function, vec3<i32>>,  exit_8 : vec3<i32>) -> bool
{
    var t_13 : vec3<f32> = Walk_crossings_0(this_26, exit_8);
    var t_first_4 : f32 = min_element_0(t_13);
    if(t_first_4 >= (this_26.t_end_0))
    {
        return false;
    }
    (*voxel_22) = max(exit_8 - vec3<i32>(ceil((t_13 - vec3<f32>(t_first_4)) * this_26.speed_1)), (*voxel_22));
    return true;
}

fn Walk_leave_2( this_27 : Walk_0,  voxel_23 : ptr<function, vec3<i32>>,  exit_9 : vec3<i32>) -> bool
{
    if(!IS_EXACT_0)
    {
        var _S267 : bool = Walk_leave_rounded_2(this_27, &((*voxel_23)), exit_9);
        return _S267;
    }
    var t_14 : vec3<f32> = Walk_crossings_0(this_27, exit_9);
    var t_first_5 : f32 = min_element_0(t_14);
    if(t_first_5 > (this_27.t_end_0))
    {
        return false;
    }
    var is_x_5 : bool = (t_14.x) == t_first_5;
    var _S268 : bool = !is_x_5;
    var is_y_5 : bool;
    if(_S268)
    {
        is_y_5 = (t_14.y) == t_first_5;
    }
    else
    {
        is_y_5 = false;
    }
    var _S269 : vec3<i32> = (*voxel_23);
    var _S270 : bool;
    if(_S268)
    {
        _S270 = !is_y_5;
    }
    else
    {
        _S270 = false;
    }
    (*voxel_23) = Walk_arrive_0(this_27, _S269, t_first_5, vec3<bool>(is_x_5, is_y_5, _S270), exit_9);
    return true;
}

fn first_voxel_2( _S271 : u32,  _S272 : Walk_0,  _S273 : ptr<function, vec3<i32>>) -> bool
{
    var _S274 : Walk_0 = _S272;
    var _S275 : vec3<i32> = vec3<i32>(i32(0));
    (*_S273) = _S275;
    var voxel_24 : vec3<i32> = Walk_start_voxel_0(_S272);
    var _S276 : bool = Walk_enter_2(_S272, &(voxel_24), cell_of_0(grids_0[_S271].min_0) - _S274.grid_origin_0, cell_of_0(grids_0[_S271].max_0) - _S274.grid_origin_0);
    if(!_S276)
    {
        return false;
    }
    var octant_4 : u32 = LocalRay_octant_0(_S274.ray_5);
    var _S277 : u32 = flip_of_0(octant_4);
    var top_shift_3 : u32;
    if(TOP_SHIFT_0 != u32(0))
    {
        top_shift_3 = TOP_SHIFT_0;
    }
    else
    {
        top_shift_3 = grids_0[_S271].top_shift_0;
    }
    var top_size_3 : vec3<i32> = cell_of_0(grids_0[_S271].top_size_0);
    var _S278 : i32 = top_size_3.x;
    var stride_2 : vec3<i32> = vec3<i32>(i32(1), _S278, _S278 * top_size_3.y);
    var _S279 : i32 = i32(grids_0[_S271].top_offset_0) - dot_cells_0((stride_2 & ((_S274.mirror_0))), vec3<i32>(i32(1)));
    var _S280 : vec3<i32> = Walk_mirrored_plane_0(_S274, stride_2);
    var _S281 : u32 = ahead_of_0(_S274.mirror_0);
    var end_2 : vec3<i32> = select((top_size_3 << (vec3<u32>(top_shift_3))), _S275, (_S274.mirror_0) != _S275);
    if(!IS_EXACT_0)
    {
        _S274.t_end_0 = min(_S274.t_end_0, min_element_0(Walk_crossings_0(_S274, end_2)));
    }
    var is_found_10 : bool = false;
    for(;;)
    {
        var _S282 : bool;
        if(IS_EXACT_0)
        {
            _S282 = (any((voxel_24 >= end_2)));
        }
        else
        {
            _S282 = false;
        }
        if(_S282)
        {
            break;
        }
        var cell_17 : u32 = cells_0[_S279 + dot_cells_0(_S280, (voxel_24 >> (vec3<u32>(top_shift_3))))];
        var cell_18 : u32;
        var shift_9 : u32;
        var is_found_11 : bool;
        if(TOP_SHIFT_0 == u32(5))
        {
            if(((cell_17 & (u32(2147483648)))) != u32(0))
            {
                cell_18 = cells_0[((cell_17 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, u32(3))) ^ (_S277)))];
                shift_9 = u32(3);
            }
            else
            {
                cell_18 = cell_17;
                shift_9 = top_shift_3;
            }
        }
        else
        {
            cell_18 = cell_17;
            shift_9 = top_shift_3;
            for(;;)
            {
                if(TOP_SHIFT_0 != u32(3))
                {
                    is_found_11 = shift_9 > u32(3);
                }
                else
                {
                    is_found_11 = false;
                }
                var _S283 : bool;
                if(is_found_11)
                {
                    _S283 = ((cell_18 & (u32(2147483648)))) != u32(0);
                }
                else
                {
                    _S283 = false;
                }
                if(_S283)
                {
                }
                else
                {
                    break;
                }
                var shift_10 : u32 = shift_9 - u32(2);
                cell_18 = cells_0[((cell_18 & (u32(2147483647)))) * u32(64) + (((cell_in_node_0(voxel_24, shift_10)) ^ (_S277)))];
                shift_9 = shift_10;
            }
        }
        var exit_10 : vec3<i32>;
        if(((cell_18 & (u32(2147483648)))) == u32(0))
        {
            exit_10 = ((voxel_24 | (vec3<i32>((((i32(1) << (shift_9))) - i32(1)))))) + vec3<i32>(i32(1)) + (((extents_0(cell_18, _S281)) << (vec3<u32>(shift_9))));
            is_found_11 = is_found_10;
        }
        else
        {
            var record_4 : u32 = record_of_cell_0(cell_18);
            var blocks_3 : u32;
            if(CELLS_HAVE_BLOCKS_0)
            {
                blocks_3 = blocks_of_cell_0(cell_18);
            }
            else
            {
                blocks_3 = blocks_of_record_0(record_4);
            }
            var low_bits_2 : u32 = empty_around_0(record_4, blocks_3, voxel_24, octant_4, _S277);
            var is_found_12 : bool = low_bits_2 == u32(4294967295);
            if(is_found_12)
            {
                is_found_10 = is_found_12;
                break;
            }
            exit_10 = ((voxel_24 | (vec3<i32>(i32(low_bits_2))))) + vec3<i32>(i32(1));
            is_found_11 = is_found_12;
        }
        var _S284 : bool = Walk_leave_2(_S274, &(voxel_24), exit_10);
        if(!_S284)
        {
            is_found_10 = is_found_11;
            break;
        }
        is_found_10 = is_found_11;
    }
    (*_S273) = Walk_mirrored_0(_S274, voxel_24) + _S274.grid_origin_0;
    return is_found_10;
}

fn hit_in_2( instance_10 : u32,  ray_23 : ptr<function, Ray_0>) -> Hit_0
{
    var _S285 : LocalRay_0 = local_ray_0((*ray_23), instance_10);
    if(!_S285.is_valid_0)
    {
        return miss_0();
    }
    var _S286 : Walk_0 = walk_of_0(_S285, instances_0[instance_10].grid_0);
    var voxel_25 : vec3<i32>;
    var _S287 : bool = first_voxel_2(instances_0[instance_10].grid_0, _S286, &(voxel_25));
    var _S288 : bool;
    if(IS_SINGLE_0)
    {
        _S288 = !IS_EXACT_0;
    }
    else
    {
        _S288 = false;
    }
    if(_S288)
    {
        (*ray_23) = ray_of_walk_0(_S286, (*ray_23));
    }
    if(!_S287)
    {
        return miss_0();
    }
    var hit_11 : Hit_0;
    if(IS_EXACT_0)
    {
        hit_11 = hit_of_0(_S285, voxel_25, instance_10);
    }
    else
    {
        hit_11 = hit_of_walk_0(_S286, voxel_25, instance_10);
    }
    if((hit_11.t_1) > ((*ray_23).t_max_1))
    {
        return miss_0();
    }
    return hit_11;
}

fn visit_2( given_2 : ptr<function, Ray_0>,  is_any_enough_2 : bool) -> Hit_0
{
    if(IS_SINGLE_0)
    {
        var _S289 : Hit_0 = hit_in_2(u32(0), &((*given_2)));
        return _S289;
    }
    var ray_24 : Ray_0 = (*given_2);
    var nearest_8 : Hit_0 = miss_0();
    if((params_0.instance_count_0) == u32(0))
    {
        return nearest_8;
    }
    var is_still_3 : vec3<bool> = !((abs(ray_24.direction_1)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S290 : vec3<f32> = select(vec3<f32>(1.0f) / select(ray_24.direction_1, vec3<f32>(1.0f), is_still_3), vec3<f32>(3.4028234663852886e+38f), is_still_3);
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
            var _S291 : Hit_0 = nearest_9;
            var _S292 : bool;
            if((hit_12.t_1) < (nearest_9.t_1))
            {
                _S292 = true;
            }
            else
            {
                if((hit_12.t_1) == (_S291.t_1))
                {
                    _S292 = (hit_12.instance_2) < (nearest_9.instance_2);
                }
                else
                {
                    _S292 = false;
                }
            }
            var nearest_10 : Hit_0;
            if(_S292)
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
            var _S293 : u32 = near_2 + u32(1);
            var _S294 : f32 = entry_0(_S293, ray_24, _S290);
            var _S295 : u32 = instance_nodes_0[near_2].index_0;
            var _S296 : f32 = entry_0(instance_nodes_0[near_2].index_0, ray_24, _S290);
            var _S297 : bool = _S294 <= _S296;
            if(_S297)
            {
                near_2 = _S293;
            }
            else
            {
                near_2 = _S295;
            }
            var far_5 : u32;
            if(_S297)
            {
                far_5 = _S295;
            }
            else
            {
                far_5 = _S293;
            }
            var INFINITY_2 : f32 = (bitcast<f32>((u32(2139095040))));
            if((max(_S294, _S296)) < INFINITY_2)
            {
                var _S298 : u32 = depth_7 + u32(1);
                stack_2[depth_7] = far_5;
                depth_8 = _S298;
            }
            else
            {
                depth_8 = depth_7;
            }
            if((min(_S294, _S296)) < INFINITY_2)
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

fn WalkTracer_trace_1( ray_25 : ptr<function, Ray_0>) -> Hit_0
{
    var _S299 : Hit_0 = visit_2(&((*ray_25)), false);
    return _S299;
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
    var _S300 : HitRecord_0;
    _S300.t_0 = t_15;
    _S300.instance_0 = instance_11;
    _S300.voxel_0 = voxel_26;
    _S300.face_0 = face_12;
    return _S300;
}

fn record_of_0( hit_13 : Hit_0) -> HitRecord_0
{
    var _S301 : array<i32, i32(3)> = array<i32, i32(3)>( hit_13.voxel_2.x, hit_13.voxel_2.y, hit_13.voxel_2.z );
    return HitRecord_x24init_0(hit_13.t_1, hit_13.instance_2, _S301, hit_13.face_1);
}

fn ray_of_0( _S302 : u32) -> Ray_0
{
    return Ray_x24init_0(vector_of_0(rays_0[_S302].origin_0), rays_0[_S302].t_min_0, vector_of_0(rays_0[_S302].direction_0), rays_0[_S302].t_max_0);
}

fn Transform_direction_2( _S303 : i32,  _S304 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S303].grid_from_world_0.x_axis_0) * vec3<f32>(_S304.x) + vector_of_0(instances_0[_S303].grid_from_world_0.y_axis_0) * vec3<f32>(_S304.y) + vector_of_0(instances_0[_S303].grid_from_world_0.z_axis_0) * vec3<f32>(_S304.z);
}

fn Transform_point_2( _S305 : i32,  _S306 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_2(_S305, _S306) + vector_of_0(instances_0[_S305].grid_from_world_0.translation_0);
}

fn local_ray_1( _S307 : Ray_0,  _S308 : i32) -> LocalRay_0
{
    var local_5 : LocalRay_0;
    var direction_11 : vec3<f32>;
    var origin_10 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S309 : vec3<f32> = Transform_point_2(_S308, _S307.origin_2);
        direction_11 = Transform_direction_2(_S308, _S307.direction_1);
        origin_10 = _S309;
    }
    else
    {
        direction_11 = _S307.direction_1;
        origin_10 = _S307.origin_2;
    }
    var is_still_4 : vec3<bool> = !((abs(direction_11)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S310 : vec3<f32> = select(direction_11, vec3<f32>(0.0f), is_still_4);
    local_5.direction_8 = _S310;
    local_5.inverse_0 = select(vec3<f32>(1.0f) / select(direction_11, vec3<f32>(1.0f), is_still_4), vec3<f32>(3.4028234663852886e+38f), is_still_4);
    local_5.origin_6 = select(origin_10, floor(origin_10) + vec3<f32>(0.5f), is_still_4);
    var speed_4 : f32 = max_element_0(abs(_S310));
    var moves_1 : bool;
    if(speed_4 >= 1.00000004581370497e-18f)
    {
        moves_1 = speed_4 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_1 = false;
    }
    var is_near_1 : bool = (all(((abs(local_5.origin_6)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_1 : bool;
    if((_S307.t_min_1) >= 0.0f)
    {
        is_segment_1 = (_S307.t_min_1) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_1 = false;
    }
    if(is_segment_1)
    {
        is_segment_1 = (_S307.t_min_1) <= (_S307.t_max_1);
    }
    else
    {
        is_segment_1 = false;
    }
    local_5.t_min_3 = _S307.t_min_1;
    local_5.t_max_3 = _S307.t_max_1;
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
    var _S311 : u32 = id_2.x;
    if(_S311 < (dispatch_0.count_0))
    {
        tally_camera_rays_0(u32(1));
        var _S312 : Ray_0 = ray_of_0(dispatch_0.first_0 + _S311);
        var ray_26 : Ray_0 = _S312;
        var _S313 : Hit_0 = WalkTracer_trace_1(&(ray_26));
        var _S314 : bool;
        if(IS_SINGLE_0)
        {
            _S314 = !IS_EXACT_0;
        }
        else
        {
            _S314 = false;
        }
        if(_S314)
        {
            _S314 = !Hit_is_miss_0(_S313);
        }
        else
        {
            _S314 = false;
        }
        var hit_14 : Hit_0;
        if(_S314)
        {
            hit_14 = hit_of_0(local_ray_1(_S312, i32(0)), _S313.voxel_2, _S313.instance_2);
        }
        else
        {
            hit_14 = _S313;
        }
        var _S315 : HitRecord_0 = record_of_0(hit_14);
        hits_0[dispatch_0.first_0 + _S311].t_0 = _S315.t_0;
        hits_0[dispatch_0.first_0 + _S311].instance_0 = _S315.instance_0;
        hits_0[dispatch_0.first_0 + _S311].voxel_0 = _S315.voxel_0;
        hits_0[dispatch_0.first_0 + _S311].face_0 = _S315.face_0;
    }
    end_tally_0(RayCounts_x24init_0(u32(0), u32(0)), thread_6);
    return;
}

