@binding(15) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

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
@binding(11) @group(0) var<storage, read> inputs_0 : array<u32>;

@binding(12) @group(0) var<storage, read_write> outputs_0 : array<u32>;

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
    @align(4) min_0 : array<i32, i32(3)>,
    @align(4) voxels_0 : array<u32, i32(2)>,
    @align(4) max_0 : array<i32, i32(3)>,
    @align(4) material_bits_0 : u32,
};

@binding(3) @group(0) var<storage, read> grids_0 : array<PackedGrid_std430_0>;

@binding(0) @group(0) var<storage, read> cells_0 : array<u32>;

@binding(1) @group(0) var<storage, read> bricks_0 : array<u32>;

@binding(2) @group(0) var<storage, read> brick_materials_0 : array<u32>;

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
struct LightNode_std430_0
{
    @align(4) min_1 : array<f32, i32(3)>,
    @align(4) index_0 : u32,
    @align(4) max_1 : array<f32, i32(3)>,
    @align(4) count_1 : u32,
    @align(4) power_0 : array<f32, i32(6)>,
    @align(4) parent_0 : u32,
    @align(4) root_0 : u32,
};

@binding(17) @group(0) var<storage, read> top_light_nodes_0 : array<LightNode_std430_0>;

struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

struct Emitter_std430_0
{
    @align(4) voxel_0 : array<i32, i32(3)>,
    @align(4) grid_1 : u32,
    @align(4) faces_0 : u32,
    @align(4) material_0 : u32,
    @align(4) luminance_0 : f32,
    @align(4) leaf_0 : u32,
};

@binding(7) @group(0) var<storage, read> emitters_0 : array<Emitter_std430_0>;

struct PackedMaterial_std430_0
{
    @align(4) base_color_0 : array<f32, i32(3)>,
    @align(4) roughness_0 : f32,
    @align(4) emission_0 : array<f32, i32(3)>,
    @align(4) metallic_0 : f32,
    @align(4) transmission_0 : f32,
    @align(4) ior_0 : f32,
    @align(4) specular_0 : f32,
    @align(4) anisotropy_0 : f32,
    @align(4) absorption_0 : array<f32, i32(3)>,
    @align(4) scattering_0 : f32,
};

@binding(6) @group(0) var<storage, read> materials_0 : array<PackedMaterial_std430_0>;

@binding(8) @group(0) var<storage, read> light_nodes_0 : array<LightNode_std430_0>;

@id(6) override SKY_0 : u32 = u32(0);

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_0 : vec3<f32>,
};

struct Hit_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_1 : vec3<i32>,
     face_0 : u32,
};

struct Aim_0
{
     is_met_0 : bool,
     direction_0 : vec3<f32>,
     hit_0 : Hit_0,
};

struct Descent_0
{
     node_0 : u32,
     index_1 : u32,
     count_2 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
};

struct LightNode_0
{
     min_1 : array<f32, i32(3)>,
     index_0 : u32,
     max_1 : array<f32, i32(3)>,
     count_1 : u32,
     power_0 : array<f32, i32(6)>,
     parent_0 : u32,
     root_0 : u32,
};

fn GridLights_node_0( index_2 : u32) -> LightNode_0
{
    var _S1 : LightNode_std430_0 = light_nodes_0[index_2];
    var _S2 : LightNode_0 = LightNode_0( _S1.min_1, _S1.index_0, _S1.max_1, _S1.count_1, _S1.power_0, _S1.parent_0, _S1.root_0 );
    return _S2;
}

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn dot_product_0( a_0 : vec3<f32>,  b_0 : vec3<f32>) -> f32
{
    return a_0.x * b_0.x + a_0.y * b_0.y + a_0.z * b_0.z;
}

fn Receiver_slack_0( this_0 : Receiver_0) -> f32
{
    var _S3 : f32;
    if((all(((this_0.normal_0) == vec3<f32>(0.0f)))))
    {
        _S3 = 1.00000001504746622e+30f;
    }
    else
    {
        _S3 = 0.0f;
    }
    return _S3;
}

fn with_slack_0( receiver_0 : Receiver_0,  cos_0 : f32) -> f32
{
    return cos_0 + Receiver_slack_0(receiver_0);
}

fn length_squared_0( vector_0 : vec3<f32>) -> f32
{
    return dot_product_0(vector_0, vector_0);
}

fn max_element_0( vector_1 : vec3<f32>) -> f32
{
    return max(max(vector_1.x, vector_1.y), vector_1.z);
}

fn length_bound_0( absolute_0 : vec3<f32>) -> f32
{
    return (max_element_0(absolute_0) + (absolute_0.x + absolute_0.y + absolute_0.z)) * 0.5f;
}

fn reciprocal_guess_0( x_0 : f32) -> f32
{
    var guess_0 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_0))))));
    return guess_0 * (2.0f - x_0 * guess_0);
}

fn node_importance_0( node_1 : LightNode_0,  receiver_1 : Receiver_0) -> f32
{
    var low_0 : vec3<f32> = vector_of_0(node_1.min_1);
    var high_0 : vec3<f32> = vector_of_0(node_1.max_1);
    var _S4 : vec3<f32> = vec3<f32>(0.5f);
    var half_0 : vec3<f32> = (high_0 - low_0) * _S4;
    var toward_0 : vec3<f32> = (low_0 + high_0) * _S4 - receiver_1.point_0;
    var above_0 : f32 = with_slack_0(receiver_1, dot_product_0(toward_0, receiver_1.normal_0) + dot_product_0(half_0, abs(receiver_1.normal_0)));
    var far_0 : f32 = length_squared_0(toward_0);
    var near_0 : f32 = length_squared_0(half_0);
    var distance_0 : f32 = length_bound_0(select(half_0, abs(toward_0), vec3<bool>((far_0 > near_0))));
    var _S5 : vec3<f32> = vec3<f32>(0.0f);
    var _S6 : vec3<f32> = vec3<f32>(distance_0);
    var beyond_min_0 : vec3<f32> = min(max(receiver_1.point_0 - low_0, _S5), _S6);
    var beyond_max_0 : vec3<f32> = min(max(high_0 - receiver_1.point_0, _S5), _S6);
    var sent_0 : f32 = node_1.power_0[i32(0)] * beyond_max_0.x + node_1.power_0[i32(1)] * beyond_min_0.x + (node_1.power_0[i32(2)] * beyond_max_0.y + node_1.power_0[i32(3)] * beyond_min_0.y) + (node_1.power_0[i32(4)] * beyond_max_0.z + node_1.power_0[i32(5)] * beyond_min_0.z);
    var falloff_0 : f32 = reciprocal_guess_0(max(far_0, near_0));
    var _S7 : f32;
    if(above_0 > 0.0f)
    {
        _S7 = sent_0 * min(above_0, distance_0) * (falloff_0 * falloff_0);
    }
    else
    {
        _S7 = 0.0f;
    }
    return _S7;
}

fn normal_or_zero_0( weight_1 : f32) -> f32
{
    var _S8 : f32;
    if(weight_1 < 1.17549435082228751e-38f)
    {
        _S8 = 0.0f;
    }
    else
    {
        _S8 = weight_1;
    }
    return _S8;
}

fn inverse_power_of_two_0( x_1 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_1))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_0 : f32) -> vec2<f32>
{
    var _S9 : f32 = normal_or_zero_0(left_0);
    var _S10 : f32 = normal_or_zero_0(right_0);
    var unit_0 : f32 = inverse_power_of_two_0(_S9 + _S10);
    return vec2<f32>(normal_or_zero_0(_S9 * unit_0), normal_or_zero_0(_S10 * unit_0));
}

fn descend_0( receiver_2 : Receiver_0,  aim_0 : Aim_0,  descent_0 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        if(((*descent_0).count_2) == u32(0))
        {
        }
        else
        {
            break;
        }
        var left_1 : LightNode_0 = GridLights_node_0((*descent_0).node_0 + u32(1));
        var right_1 : LightNode_0 = GridLights_node_0((*descent_0).index_1);
        var weights_0 : vec2<f32> = weights_of_0(node_importance_0(left_1, receiver_2), node_importance_0(right_1, receiver_2));
        var _S11 : f32 = weights_0.x;
        var _S12 : f32 = weights_0.y;
        var total_1 : f32 = _S11 + _S12;
        if(!(total_1 > 0.0f))
        {
            return false;
        }
        var _S13 : bool;
        if(_S12 <= 0.0f)
        {
            _S13 = true;
        }
        else
        {
            _S13 = ((*descent_0).choice_0 * total_1) < (_S11 * (*descent_0).weight_0);
        }
        var is_left_0 : bool;
        if(aim_0.is_met_0)
        {
            var _S14 : vec3<f32> = vec3<f32>(aim_0.hit_0.voxel_1);
            if((all((_S14 >= (vector_of_0(left_1.min_1))))))
            {
                is_left_0 = (all((_S14 < (vector_of_0(left_1.max_1)))));
            }
            else
            {
                is_left_0 = false;
            }
        }
        else
        {
            is_left_0 = _S13;
        }
        var _S15 : f32 = (*descent_0).choice_0 * total_1;
        var _S16 : f32;
        if(is_left_0)
        {
            _S16 = 0.0f;
        }
        else
        {
            _S16 = _S11 * (*descent_0).weight_0;
        }
        (*descent_0).choice_0 = _S15 - _S16;
        var _S17 : u32;
        if(is_left_0)
        {
            _S17 = (*descent_0).node_0 + u32(1);
        }
        else
        {
            _S17 = (*descent_0).index_1;
        }
        (*descent_0).node_0 = _S17;
        var _S18 : u32;
        if(is_left_0)
        {
            _S18 = left_1.index_0;
        }
        else
        {
            _S18 = right_1.index_0;
        }
        (*descent_0).index_1 = _S18;
        var _S19 : u32;
        if(is_left_0)
        {
            _S19 = left_1.count_1;
        }
        else
        {
            _S19 = right_1.count_1;
        }
        (*descent_0).count_2 = _S19;
        var _S20 : f32;
        if(is_left_0)
        {
            _S20 = _S11;
        }
        else
        {
            _S20 = _S12;
        }
        var _S21 : f32 = (*descent_0).weight_0 * _S20;
        (*descent_0).weight_0 = _S21;
        (*descent_0).total_0 = (*descent_0).total_0 * total_1;
        if(_S21 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Descent_at_0( this_1 : ptr<function, Descent_0>,  root_1 : u32)
{
    var node_2 : LightNode_0 = GridLights_node_0(root_1);
    (*this_1).node_0 = root_1;
    (*this_1).index_1 = node_2.index_0;
    (*this_1).count_2 = node_2.count_1;
    return;
}

fn TopLights_node_0( index_3 : u32) -> LightNode_0
{
    var _S22 : LightNode_std430_0 = top_light_nodes_0[index_3];
    var _S23 : LightNode_0 = LightNode_0( _S22.min_1, _S22.index_0, _S22.max_1, _S22.count_1, _S22.power_0, _S22.parent_0, _S22.root_0 );
    return _S23;
}

fn descend_1( receiver_3 : Receiver_0,  aim_1 : Aim_0,  descent_1 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        if(((*descent_1).count_2) == u32(0))
        {
        }
        else
        {
            break;
        }
        var left_2 : LightNode_0 = TopLights_node_0((*descent_1).node_0 + u32(1));
        var right_2 : LightNode_0 = TopLights_node_0((*descent_1).index_1);
        var weights_1 : vec2<f32> = weights_of_0(node_importance_0(left_2, receiver_3), node_importance_0(right_2, receiver_3));
        var _S24 : f32 = weights_1.x;
        var _S25 : f32 = weights_1.y;
        var total_2 : f32 = _S24 + _S25;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S26 : bool;
        if(_S25 <= 0.0f)
        {
            _S26 = true;
        }
        else
        {
            _S26 = ((*descent_1).choice_0 * total_2) < (_S24 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_1.is_met_0)
        {
            var _S27 : vec3<f32> = vec3<f32>(aim_1.hit_0.voxel_1);
            if((all((_S27 >= (vector_of_0(left_2.min_1))))))
            {
                is_left_1 = (all((_S27 < (vector_of_0(left_2.max_1)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S26;
        }
        var _S28 : f32 = (*descent_1).choice_0 * total_2;
        var _S29 : f32;
        if(is_left_1)
        {
            _S29 = 0.0f;
        }
        else
        {
            _S29 = _S24 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S28 - _S29;
        var _S30 : u32;
        if(is_left_1)
        {
            _S30 = (*descent_1).node_0 + u32(1);
        }
        else
        {
            _S30 = (*descent_1).index_1;
        }
        (*descent_1).node_0 = _S30;
        var _S31 : u32;
        if(is_left_1)
        {
            _S31 = left_2.index_0;
        }
        else
        {
            _S31 = right_2.index_0;
        }
        (*descent_1).index_1 = _S31;
        var _S32 : u32;
        if(is_left_1)
        {
            _S32 = left_2.count_1;
        }
        else
        {
            _S32 = right_2.count_1;
        }
        (*descent_1).count_2 = _S32;
        var _S33 : f32;
        if(is_left_1)
        {
            _S33 = _S24;
        }
        else
        {
            _S33 = _S25;
        }
        var _S34 : f32 = (*descent_1).weight_0 * _S33;
        (*descent_1).weight_0 = _S34;
        (*descent_1).total_0 = (*descent_1).total_0 * total_2;
        if(_S34 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

@id(1) override IS_SINGLE_0 : bool = false;

fn Descent_at_1( this_2 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_3 : LightNode_0 = TopLights_node_0(root_2);
    (*this_2).node_0 = root_2;
    (*this_2).index_1 = node_3.index_0;
    (*this_2).count_2 = node_3.count_1;
    return;
}

@id(0) override IS_EXACT_0 : bool = true;

fn prove_0( thread_0 : u32)
{
    if(thread_0 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S35 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

struct Reader_0
{
     at_0 : u32,
};

fn Reader_x24init_0( at_1 : u32) -> Reader_0
{
    var _S36 : Reader_0;
    _S36.at_0 = at_1;
    return _S36;
}

struct Writer_0
{
     at_2 : u32,
};

fn Writer_x24init_0( at_3 : u32) -> Writer_0
{
    var _S37 : Writer_0;
    _S37.at_2 = at_3;
    return _S37;
}

fn Reader_word_0( this_3 : ptr<function, Reader_0>) -> u32
{
    var _S38 : u32 = (*this_3).at_0 + u32(1);
    (*this_3).at_0 = _S38;
    return inputs_0[_S38 - u32(1)];
}

fn Reader_word_1( this_4 : ptr<function, Reader_0>) -> u32
{
    var _S39 : u32 = (*this_4).at_0 + u32(1);
    (*this_4).at_0 = _S39;
    return inputs_0[_S39 - u32(1)];
}

struct Sampler_0
{
     seed_1 : u32,
     pixel_0 : u32,
     sample_0 : u32,
};

fn Sampler_x24init_0( seed_2 : u32,  pixel_1 : u32,  sample_1 : u32) -> Sampler_0
{
    var _S40 : Sampler_0;
    _S40.seed_1 = seed_2;
    _S40.pixel_0 = pixel_1;
    _S40.sample_0 = sample_1;
    return _S40;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S41 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S41;
    v_0[i32(0)] = v_0[i32(0)] + _S41.y * _S41.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S42 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S42;
    v_0[i32(0)] = v_0[i32(0)] + _S42.y * _S42.w;
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

fn owen_of_reversed_0( reversed_0 : u32,  seed_3 : u32) -> u32
{
    var word_0 : u32 = reversed_0 + seed_3;
    var word_1 : u32 = (word_0 ^ ((word_0 * u32(1817228412))));
    var word_2 : u32 = (word_1 ^ ((word_1 * u32(3090095698))));
    var word_3 : u32 = (word_2 ^ ((word_2 * u32(3350193720))));
    return reverseBits((word_3 ^ ((word_3 * u32(2367878886)))));
}

fn scrambled_sobol_0( sample_2 : u32,  order_0 : u32,  seeds_0 : vec2<u32>) -> vec2<u32>
{
    var index_4 : u32 = owen_of_reversed_0(reverseBits(sample_2), order_0);
    var binomial_0 : u32 = (index_4 ^ (((((index_4 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_4, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_6 : Sampler_0,  dimension_1 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_2 : vec4<u32> = pcg4d_0(vec4<u32>(this_6.pixel_0, dimension_1, this_6.seed_1, which_0));
    return scrambled_sobol_0(this_6.sample_0, words_2.x, words_2.yz);
}

fn Sampler_stratified_0( this_7 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_7, dimension_2, u32(1)), Sampler_pair_0(this_7, dimension_2, u32(2))));
}

fn Writer_word_0( this_8 : ptr<function, Writer_0>,  value_0 : u32)
{
    outputs_0[(*this_8).at_2] = value_0;
    (*this_8).at_2 = (*this_8).at_2 + u32(1);
    return;
}

fn Writer_word_1( this_9 : ptr<function, Writer_0>,  value_1 : u32)
{
    outputs_0[(*this_9).at_2] = value_1;
    (*this_9).at_2 = (*this_9).at_2 + u32(1);
    return;
}

fn Writer_number_0( this_10 : ptr<function, Writer_0>,  value_2 : f32)
{
    Writer_word_1(&((*this_10)), (bitcast<u32>((value_2))));
    return;
}

fn Writer_number_1( this_11 : ptr<function, Writer_0>,  value_3 : f32)
{
    Writer_word_1(&((*this_11)), (bitcast<u32>((value_3))));
    return;
}

fn Writer_vector_0( this_12 : ptr<function, Writer_0>,  value_4 : vec3<f32>)
{
    Writer_number_1(&((*this_12)), value_4.x);
    Writer_number_1(&((*this_12)), value_4.y);
    Writer_number_1(&((*this_12)), value_4.z);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_sampler(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    prove_0(thread_1);
    var _S43 : u32 = id_0.x;
    if(_S43 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_0 : Reader_0 = Reader_x24init_0(u32(4) * _S43);
    var writer_0 : Writer_0 = Writer_x24init_0(u32(8) * _S43);
    var seed_4 : u32 = Reader_word_0(&(reader_0));
    var pixel_2 : u32 = Reader_word_0(&(reader_0));
    var _S44 : u32 = Reader_word_0(&(reader_0));
    var sampler_0 : Sampler_0 = Sampler_x24init_0(seed_4, pixel_2, _S44);
    var dimension_3 : u32 = Reader_word_0(&(reader_0));
    var independent_0 : vec4<f32> = Sampler_independent_0(sampler_0, dimension_3);
    var stratified_0 : vec4<f32> = Sampler_stratified_0(sampler_0, dimension_3);
    Writer_vector_0(&(writer_0), independent_0.xyz);
    Writer_number_0(&(writer_0), independent_0.w);
    Writer_vector_0(&(writer_0), stratified_0.xyz);
    Writer_number_0(&(writer_0), stratified_0.w);
    return;
}

fn Reader_number_0( this_13 : ptr<function, Reader_0>) -> f32
{
    var _S45 : u32 = Reader_word_1(&((*this_13)));
    return (bitcast<f32>((_S45)));
}

fn Reader_number_1( this_14 : ptr<function, Reader_0>) -> f32
{
    var _S46 : u32 = Reader_word_1(&((*this_14)));
    return (bitcast<f32>((_S46)));
}

fn sincos_turns_0( turns_0 : f32) -> vec2<f32>
{
    var quadrant_0 : i32 = i32(turns_0 * 4.0f + 0.5f);
    var x_2 : f32 = (turns_0 - f32(quadrant_0) * 0.25f) * 6.28318548202514648f;
    var xx_0 : f32 = x_2 * x_2;
    var sin_0 : f32 = x_2 + x_2 * xx_0 * (-0.1666666716337204f + xx_0 * (0.00833333376795053f + xx_0 * (-0.0001984127011383f + xx_0 * 2.75573188446287531e-06f)));
    var cos_1 : f32 = 1.0f + xx_0 * (-0.5f + xx_0 * (0.0416666679084301f + xx_0 * (-0.00138888892251998f + xx_0 * (0.00002480158764229f + xx_0 * -2.75573199814971304e-07f))));
    switch((quadrant_0 & (i32(3))))
    {
    case i32(0):
        {
            return vec2<f32>(sin_0, cos_1);
        }
    case i32(1):
        {
            return vec2<f32>(cos_1, - sin_0);
        }
    case i32(2):
        {
            return vec2<f32>(- sin_0, - cos_1);
        }
    default :
        {
            return vec2<f32>(- cos_1, sin_0);
        }
    }
}

fn is_normal_0( exponent_0 : i32) -> bool
{
    var _S47 : bool;
    if(exponent_0 > i32(0))
    {
        _S47 = exponent_0 < i32(255);
    }
    else
    {
        _S47 = false;
    }
    return _S47;
}

fn nearest_root_0( mantissa_0 : u32,  guess_1 : u32) -> u32
{
    var rest_0 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_0 : i32 = i32(floor(f32(rest_0) / f32(u32(2) * guess_1) + 0.5f));
    var _S48 : i32 = i32(guess_1);
    var root_3 : i32 = _S48 + units_0;
    var rest_1 : i32 = rest_0 - units_0 * (_S48 + root_3);
    return u32(root_3 + i32(rest_1 > root_3) - i32(rest_1 <= (- root_3)));
}

fn square_root_0( value_5 : f32) -> f32
{
    var native_0 : f32 = sqrt(value_5);
    if(!IS_EXACT_0)
    {
        return native_0;
    }
    var _S49 : u32 = (bitcast<u32>((value_5)));
    var exponent_1 : u32 = (_S49 >> (u32(23)));
    if(!is_normal_0(i32(exponent_1)))
    {
        return native_0;
    }
    var mantissa_1 : u32 = (((_S49 & (u32(8388607)))) | (u32(8388608)));
    var mantissa_2 : u32;
    if(((exponent_1 & (u32(1)))) == u32(0))
    {
        mantissa_2 = (mantissa_1 << (u32(1)));
    }
    else
    {
        mantissa_2 = mantissa_1;
    }
    return (bitcast<f32>(((((((exponent_1 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_2, u32(sqrt(f32(mantissa_2) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
}

fn cosine_hemisphere_0( u_0 : f32,  v_1 : f32) -> vec3<f32>
{
    var radius_0 : f32 = square_root_0(u_0);
    var sin_cos_0 : vec2<f32> = sincos_turns_0(v_1);
    return vec3<f32>(radius_0 * sin_cos_0.y, radius_0 * sin_cos_0.x, square_root_0(1.0f - u_0));
}

fn cosine_hemisphere_pdf_0( cos_theta_0 : f32) -> f32
{
    return max(cos_theta_0, 0.0f) * 0.31830987334251404f;
}

fn nearest_quotient_0( dividend_0 : u32,  divisor_0 : u32,  guess_2 : u32) -> u32
{
    var rest_2 : i32 = i32(((dividend_0 << (u32(23)))) - guess_2 * divisor_0);
    var units_1 : i32 = i32(floor(f32(rest_2) / f32(divisor_0) + 0.5f));
    var _S50 : i32 = i32(divisor_0);
    var _S51 : i32 = i32(2) * (rest_2 - units_1 * _S50);
    return guess_2 + u32(units_1 + (i32(_S51 > _S50) - i32(_S51 < (- _S50))));
}

fn divide_0( a_1 : f32,  b_1 : f32) -> f32
{
    var native_1 : f32 = a_1 / b_1;
    if(!IS_EXACT_0)
    {
        return native_1;
    }
    var _S52 : u32 = (bitcast<u32>((a_1)));
    var exponent_a_0 : i32 = i32((((_S52 >> (u32(23)))) & (u32(255))));
    var _S53 : u32 = (bitcast<u32>((b_1)));
    var exponent_b_0 : i32 = i32((((_S53 >> (u32(23)))) & (u32(255))));
    var dividend_1 : u32 = (((_S52 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S53 & (u32(8388607)))) | (u32(8388608)));
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
    var exponent_2 : i32 = exponent_a_0 - exponent_b_0 + i32(127) - i32(is_below_0);
    var _S54 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S54 = true;
    }
    else
    {
        _S54 = !is_normal_0(exponent_b_0);
    }
    if(_S54)
    {
        _S54 = true;
    }
    else
    {
        _S54 = !is_normal_0(exponent_2);
    }
    if(_S54)
    {
        return native_1;
    }
    return (bitcast<f32>(((((((_S52 ^ (_S53))) & (u32(2147483648)))) | ((((u32(exponent_2) << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) / f32(divisor_1) * 8.388608e+06f)) - u32(8388608))))))));
}

fn normalize_vector_0( vector_2 : vec3<f32>) -> vec3<f32>
{
    return vector_2 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_2))));
}

fn luminance_1( color_0 : vec3<f32>) -> f32
{
    return color_0.x * 0.2125999927520752f + color_0.y * 0.71520000696182251f + color_0.z * 0.07220000028610229f;
}

@compute
@workgroup_size(64, 1, 1)
fn check_math(@builtin(global_invocation_id) id_1 : vec3<u32>, @builtin(local_invocation_index) thread_2 : u32)
{
    prove_0(thread_2);
    var _S55 : u32 = id_1.x;
    if(_S55 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_1 : Reader_0 = Reader_x24init_0(u32(2) * _S55);
    var writer_1 : Writer_0 = Writer_x24init_0(u32(10) * _S55);
    var u_1 : f32 = Reader_number_0(&(reader_1));
    var v_2 : f32 = Reader_number_0(&(reader_1));
    var sin_cos_1 : vec2<f32> = sincos_turns_0(u_1);
    var vector_3 : vec3<f32> = cosine_hemisphere_0(u_1, v_2);
    Writer_number_0(&(writer_1), sin_cos_1.x);
    Writer_number_0(&(writer_1), sin_cos_1.y);
    Writer_vector_0(&(writer_1), vector_3);
    Writer_number_0(&(writer_1), cosine_hemisphere_pdf_0(vector_3.z));
    Writer_vector_0(&(writer_1), normalize_vector_0(vec3<f32>(u_1, v_2, 2.0f) - vector_3));
    Writer_number_0(&(writer_1), luminance_1(vector_3));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_rounding(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    prove_0(thread_3);
    var _S56 : u32 = id_2.x;
    if(_S56 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_2 : Reader_0 = Reader_x24init_0(u32(6) * _S56);
    var writer_2 : Writer_0 = Writer_x24init_0(u32(4) * _S56);
    var a_2 : f32 = Reader_number_0(&(reader_2));
    var _S57 : f32 = Reader_number_0(&(reader_2));
    Writer_number_0(&(writer_2), divide_0(a_2, _S57));
    Writer_number_0(&(writer_2), square_root_0(abs(a_2)));
    var dividend_3 : u32 = Reader_word_0(&(reader_2));
    var divisor_2 : u32 = Reader_word_0(&(reader_2));
    var quotient_guess_0 : u32 = Reader_word_0(&(reader_2));
    Writer_word_0(&(writer_2), nearest_quotient_0(dividend_3, divisor_2, quotient_guess_0));
    var _S58 : u32 = Reader_word_0(&(reader_2));
    Writer_word_0(&(writer_2), nearest_root_0(dividend_3, _S58));
    return;
}

fn Reader_vector_0( this_15 : ptr<function, Reader_0>) -> vec3<f32>
{
    var x_3 : f32 = Reader_number_1(&((*this_15)));
    var y_0 : f32 = Reader_number_1(&((*this_15)));
    var _S59 : f32 = Reader_number_1(&((*this_15)));
    return vec3<f32>(x_3, y_0, _S59);
}

fn Reader_vector_1( this_16 : ptr<function, Reader_0>) -> vec3<f32>
{
    var x_4 : f32 = Reader_number_1(&((*this_16)));
    var y_1 : f32 = Reader_number_1(&((*this_16)));
    var _S60 : f32 = Reader_number_1(&((*this_16)));
    return vec3<f32>(x_4, y_1, _S60);
}

fn fixed_point_0( value_6 : f32) -> vec2<u32>
{
    if(!(value_6 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_0 : u32 = (bitcast<u32>((min(value_6, 1.048576e+06f))));
    var shift_0 : i32 = i32((bits_0 >> (u32(23)))) - i32(118);
    var mantissa_3 : u32 = (((bits_0 & (u32(8388607)))) | (u32(8388608)));
    if(shift_0 <= i32(-24))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    if(shift_0 < i32(0))
    {
        return vec2<u32>((mantissa_3 >> (u32(- shift_0))), u32(0));
    }
    if(shift_0 < i32(32))
    {
        var _S61 : u32 = (mantissa_3 << (u32(shift_0)));
        var _S62 : u32;
        if(shift_0 == i32(0))
        {
            _S62 = u32(0);
        }
        else
        {
            _S62 = (mantissa_3 >> (u32(i32(32) - shift_0)));
        }
        return vec2<u32>(_S61, _S62);
    }
    return vec2<u32>(u32(0), (mantissa_3 << (u32(shift_0 - i32(32)))));
}

struct PixelRecord_0
{
     radiance_1 : array<u32, i32(6)>,
     samples_1 : u32,
     covered_0 : u32,
};

fn PixelRecord_add_0( this_17 : ptr<function, PixelRecord_0>,  value_7 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_7[u32(0)]);
    var _S63 : u32 = addend_0.x;
    var low_1 : u32 = (*this_17).radiance_1[u32(0)] + _S63;
    var high_1 : u32 = (*this_17).radiance_1[u32(1)] + addend_0.y + u32(low_1 < _S63);
    var is_full_0 : bool = high_1 < ((*this_17).radiance_1[u32(1)]);
    var _S64 : u32;
    if(is_full_0)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = low_1;
    }
    (*this_17).radiance_1[u32(0)] = _S64;
    if(is_full_0)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = high_1;
    }
    (*this_17).radiance_1[u32(1)] = _S64;
    var addend_1 : vec2<u32> = fixed_point_0(value_7[u32(1)]);
    var _S65 : u32 = addend_1.x;
    var low_2 : u32 = (*this_17).radiance_1[u32(2)] + _S65;
    var high_2 : u32 = (*this_17).radiance_1[u32(3)] + addend_1.y + u32(low_2 < _S65);
    var is_full_1 : bool = high_2 < ((*this_17).radiance_1[u32(3)]);
    if(is_full_1)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = low_2;
    }
    (*this_17).radiance_1[u32(2)] = _S64;
    if(is_full_1)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = high_2;
    }
    (*this_17).radiance_1[u32(3)] = _S64;
    var addend_2 : vec2<u32> = fixed_point_0(value_7[u32(2)]);
    var _S66 : u32 = addend_2.x;
    var low_3 : u32 = (*this_17).radiance_1[u32(4)] + _S66;
    var high_3 : u32 = (*this_17).radiance_1[u32(5)] + addend_2.y + u32(low_3 < _S66);
    var is_full_2 : bool = high_3 < ((*this_17).radiance_1[u32(5)]);
    if(is_full_2)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = low_3;
    }
    (*this_17).radiance_1[u32(4)] = _S64;
    if(is_full_2)
    {
        _S64 = u32(4294967295);
    }
    else
    {
        _S64 = high_3;
    }
    (*this_17).radiance_1[u32(5)] = _S64;
    (*this_17).samples_1 = (*this_17).samples_1 + u32(1);
    (*this_17).covered_0 = (*this_17).covered_0 + u32(is_covered_0);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_film(@builtin(global_invocation_id) id_3 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    prove_0(thread_4);
    var _S67 : u32 = id_3.x;
    if(_S67 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_3 : Reader_0 = Reader_x24init_0(u32(12) * _S67);
    var writer_3 : Writer_0 = Writer_x24init_0(u32(8) * _S67);
    var pixel_3 : PixelRecord_0;
    var word_4 : u32 = u32(0);
    for(;;)
    {
        if(word_4 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S68 : u32 = Reader_word_0(&(reader_3));
        pixel_3.radiance_1[word_4] = _S68;
        word_4 = word_4 + u32(1);
    }
    var _S69 : u32 = Reader_word_0(&(reader_3));
    pixel_3.samples_1 = _S69;
    var _S70 : u32 = Reader_word_0(&(reader_3));
    pixel_3.covered_0 = _S70;
    var radiance_2 : vec3<f32> = Reader_vector_0(&(reader_3));
    var _S71 : u32 = Reader_word_0(&(reader_3));
    PixelRecord_add_0(&(pixel_3), radiance_2, _S71 != u32(0));
    word_4 = u32(0);
    for(;;)
    {
        if(word_4 < u32(6))
        {
        }
        else
        {
            break;
        }
        Writer_word_0(&(writer_3), pixel_3.radiance_1[word_4]);
        word_4 = word_4 + u32(1);
    }
    Writer_word_0(&(writer_3), pixel_3.samples_1);
    Writer_word_0(&(writer_3), pixel_3.covered_0);
    return;
}

fn Reader_cell_0( this_18 : ptr<function, Reader_0>) -> vec3<i32>
{
    var _S72 : u32 = Reader_word_1(&((*this_18)));
    var x_5 : i32 = i32(_S72);
    var _S73 : u32 = Reader_word_1(&((*this_18)));
    var y_2 : i32 = i32(_S73);
    var _S74 : u32 = Reader_word_1(&((*this_18)));
    return vec3<i32>(x_5, y_2, i32(_S74));
}

fn Reader_cell_1( this_19 : ptr<function, Reader_0>) -> vec3<i32>
{
    var _S75 : u32 = Reader_word_1(&((*this_19)));
    var x_6 : i32 = i32(_S75);
    var _S76 : u32 = Reader_word_1(&((*this_19)));
    var y_3 : i32 = i32(_S76);
    var _S77 : u32 = Reader_word_1(&((*this_19)));
    return vec3<i32>(x_6, y_3, i32(_S77));
}

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_1 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_1)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_1 : u32) -> u32
{
    var _S78 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S78 = u32(8388607);
    }
    else
    {
        _S78 = u32(2147483647);
    }
    return ((cell_1 & (_S78))) * u32(2);
}

fn rank_in_brick_0( record_0 : u32,  relative_1 : vec3<i32>) -> u32
{
    var bit_0 : u32 = cell_in_node_0(relative_1, u32(0));
    var present_before_0 : u32 = countOneBits((bricks_0[record_0] & ((((u32(1) << (((((u32(((((relative_1.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_1.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_1.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_5 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_5 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S79 : u32 = u32(2) * index_5;
        var rank_1 : u32 = rank_0 + (countOneBits(bricks_0[record_0 + u32(2) + _S79]) + countOneBits(bricks_0[record_0 + u32(3) + _S79]));
        index_5 = index_5 + u32(1);
        rank_0 = rank_1;
    }
    var _S80 : u32 = u32(2) * present_before_0;
    var low_4 : u32 = bricks_0[record_0 + u32(2) + _S80];
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_4 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_4) + countOneBits((bricks_0[record_0 + u32(3) + _S80] & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn read_bits_0( start_0 : u32,  position_0 : u32,  count_3 : u32) -> u32
{
    if(count_3 == u32(0))
    {
        return u32(0);
    }
    var word_5 : u32 = start_0 + ((position_0 >> (u32(5))));
    var shift_2 : u32 = (position_0 & (u32(31)));
    var bits_1 : u32 = (brick_materials_0[word_5] >> (shift_2));
    var bits_2 : u32;
    if((shift_2 + count_3) > u32(32))
    {
        bits_2 = (bits_1 | (((brick_materials_0[word_5 + u32(1)] << ((u32(32) - shift_2))))));
    }
    else
    {
        bits_2 = bits_1;
    }
    return (bits_2 & ((((u32(1) << (count_3))) - u32(1))));
}

fn find_brick_0( _S81 : u32,  _S82 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (_S82 >> (vec3<u32>(grids_0[_S81].top_shift_0)));
    var cell_2 : u32 = cells_0[grids_0[_S81].top_offset_0 + u32((top_0.z * grids_0[_S81].top_size_0[i32(1)] + top_0.y) * grids_0[_S81].top_size_0[i32(0)] + top_0.x)];
    var shift_3 : u32 = grids_0[_S81].top_shift_0;
    for(;;)
    {
        var _S83 : bool;
        if(shift_3 > u32(3))
        {
            _S83 = ((cell_2 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S83 = false;
        }
        if(_S83)
        {
        }
        else
        {
            break;
        }
        var shift_4 : u32 = shift_3 - u32(2);
        cell_2 = cells_0[((cell_2 & (u32(2147483647)))) * u32(64) + cell_in_node_0(_S82, shift_4)];
        shift_3 = shift_4;
    }
    return record_of_cell_0(cell_2);
}

fn material_at_0( _S84 : u32,  _S85 : vec3<i32>) -> u32
{
    var _S86 : u32 = find_brick_0(_S84, _S85);
    var header_0 : u32 = bricks_0[_S86];
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var entry_bits_0 : u32 = grids_0[_S84].material_bits_0;
    var start_1 : u32 = bricks_0[_S86 + u32(1)];
    var index_6 : u32 = read_bits_0(start_1, palette_count_0 * grids_0[_S84].material_bits_0 + rank_in_brick_0(_S86, _S85) * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_6;
    }
    return read_bits_0(start_1, index_6 * entry_bits_0, entry_bits_0);
}

@compute
@workgroup_size(64, 1, 1)
fn check_material(@builtin(global_invocation_id) id_4 : vec3<u32>, @builtin(local_invocation_index) thread_5 : u32)
{
    prove_0(thread_5);
    var _S87 : u32 = id_4.x;
    if(_S87 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_4 : Reader_0 = Reader_x24init_0(u32(4) * _S87);
    var writer_4 : Writer_0 = Writer_x24init_0(_S87);
    var _S88 : u32 = Reader_word_0(&(reader_4));
    var _S89 : vec3<i32> = Reader_cell_0(&(reader_4));
    Writer_word_0(&(writer_4), material_at_0(instances_0[_S88].grid_0, _S89 - cell_of_0(grids_0[instances_0[_S88].grid_0].origin_0)));
    return;
}

fn blocks_of_record_0( record_1 : u32) -> u32
{
    return (bricks_0[record_1] & (u32(255)));
}

fn flip_of_0( octant_0 : u32) -> u32
{
    return ((((((octant_0 & (u32(1)))) | (((((octant_0 & (u32(2)))) << (u32(1))))))) | (((((octant_0 & (u32(4)))) << (u32(2))))))) * u32(3);
}

fn empty_around_0( record_2 : u32,  blocks_0 : u32,  voxel_2 : vec3<i32>,  octant_1 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_2.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_2.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_2.z) & (i32(4))))))) ^ (octant_1));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_1 : u32 = ((cell_in_node_0(voxel_2, u32(0))) ^ (flip_0));
    var half_1 : u32 = bricks_0[record_2 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_1 >> (u32(5))))];
    if(((((half_1 >> (((bit_1 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S90 : i32;
    if(((((half_1 >> (((bit_1 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S90 = i32(1);
    }
    else
    {
        _S90 = i32(0);
    }
    return u32(_S90);
}

@compute
@workgroup_size(64, 1, 1)
fn check_brick(@builtin(global_invocation_id) id_5 : vec3<u32>, @builtin(local_invocation_index) thread_6 : u32)
{
    prove_0(thread_6);
    var _S91 : u32 = id_5.x;
    if(_S91 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_5 : Reader_0 = Reader_x24init_0(u32(5) * _S91);
    var writer_5 : Writer_0 = Writer_x24init_0(_S91);
    var _S92 : u32 = Reader_word_0(&(reader_5));
    var _S93 : vec3<i32> = Reader_cell_0(&(reader_5));
    var voxel_3 : vec3<i32> = _S93 - cell_of_0(grids_0[instances_0[_S92].grid_0].origin_0);
    var octant_2 : u32 = Reader_word_0(&(reader_5));
    var _S94 : u32 = find_brick_0(instances_0[_S92].grid_0, voxel_3);
    Writer_word_0(&(writer_5), empty_around_0(_S94, blocks_of_record_0(_S94), (voxel_3 ^ ((vec3<i32>(0) - vec3<i32>(i32((octant_2 & (u32(1)))), i32((((octant_2 >> (u32(1)))) & (u32(1)))), i32((octant_2 >> (u32(2)))))))), octant_2, flip_of_0(octant_2)));
    return;
}

struct Ray_0
{
     origin_1 : vec3<f32>,
     t_min_0 : f32,
     direction_1 : vec3<f32>,
     t_max_0 : f32,
};

fn Ray_x24init_0( origin_2 : vec3<f32>,  t_min_1 : f32,  direction_2 : vec3<f32>,  t_max_1 : f32) -> Ray_0
{
    var _S95 : Ray_0;
    _S95.origin_1 = origin_2;
    _S95.t_min_0 = t_min_1;
    _S95.direction_1 = direction_2;
    _S95.t_max_0 = t_max_1;
    return _S95;
}

fn Reader_ray_0( this_20 : ptr<function, Reader_0>) -> Ray_0
{
    var origin_3 : vec3<f32> = Reader_vector_1(&((*this_20)));
    var t_min_2 : f32 = Reader_number_1(&((*this_20)));
    var direction_3 : vec3<f32> = Reader_vector_1(&((*this_20)));
    var _S96 : f32 = Reader_number_1(&((*this_20)));
    return Ray_x24init_0(origin_3, t_min_2, direction_3, _S96);
}

fn reciprocal_0( vector_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_4.x), divide_0(1.0f, vector_4.y), divide_0(1.0f, vector_4.z));
}

struct LocalRay_0
{
     origin_4 : vec3<f32>,
     direction_4 : vec3<f32>,
     inverse_0 : vec3<f32>,
     t_min_3 : f32,
     t_max_2 : f32,
     is_valid_0 : bool,
};

fn Transform_direction_0( _S97 : i32,  _S98 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S97].grid_from_world_0.x_axis_0) * vec3<f32>(_S98.x) + vector_of_0(instances_0[_S97].grid_from_world_0.y_axis_0) * vec3<f32>(_S98.y) + vector_of_0(instances_0[_S97].grid_from_world_0.z_axis_0) * vec3<f32>(_S98.z);
}

fn Transform_point_0( _S99 : i32,  _S100 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(_S99, _S100) + vector_of_0(instances_0[_S99].grid_from_world_0.translation_0);
}

fn local_ray_0( _S101 : Ray_0,  _S102 : i32) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_5 : vec3<f32>;
    var origin_5 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S103 : vec3<f32> = Transform_point_0(_S102, _S101.origin_1);
        direction_5 = Transform_direction_0(_S102, _S101.direction_1);
        origin_5 = _S103;
    }
    else
    {
        direction_5 = _S101.direction_1;
        origin_5 = _S101.origin_1;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_5)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S104 : vec3<f32> = select(direction_5, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_4 = _S104;
    local_0.inverse_0 = select(reciprocal_0(select(direction_5, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_4 = select(origin_5, floor(origin_5) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S104));
    var moves_0 : bool;
    if(speed_0 >= 1.00000004581370497e-18f)
    {
        moves_0 = speed_0 <= 9.9999998430674944e+17f;
    }
    else
    {
        moves_0 = false;
    }
    var is_near_0 : bool = (all(((abs(local_0.origin_4)) <= vec3<f32>(2.097152e+06f))));
    var is_segment_0 : bool;
    if((_S101.t_min_0) >= 0.0f)
    {
        is_segment_0 = (_S101.t_min_0) <= 3.4028234663852886e+38f;
    }
    else
    {
        is_segment_0 = false;
    }
    if(is_segment_0)
    {
        is_segment_0 = (_S101.t_min_0) <= (_S101.t_max_0);
    }
    else
    {
        is_segment_0 = false;
    }
    local_0.t_min_3 = _S101.t_min_0;
    local_0.t_max_2 = _S101.t_max_0;
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

@compute
@workgroup_size(64, 1, 1)
fn check_local_ray(@builtin(global_invocation_id) id_6 : vec3<u32>, @builtin(local_invocation_index) thread_7 : u32)
{
    prove_0(thread_7);
    var _S105 : u32 = id_6.x;
    if(_S105 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_6 : Reader_0 = Reader_x24init_0(u32(8) * _S105);
    var writer_6 : Writer_0 = Writer_x24init_0(u32(10) * _S105);
    var _S106 : Ray_0 = Reader_ray_0(&(reader_6));
    var _S107 : LocalRay_0 = local_ray_0(_S106, i32(0));
    Writer_word_0(&(writer_6), u32(_S107.is_valid_0));
    var _S108 : vec3<f32>;
    if(_S107.is_valid_0)
    {
        _S108 = _S107.origin_4;
    }
    else
    {
        _S108 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S108);
    if(_S107.is_valid_0)
    {
        _S108 = _S107.direction_4;
    }
    else
    {
        _S108 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S108);
    if(_S107.is_valid_0)
    {
        _S108 = _S107.inverse_0;
    }
    else
    {
        _S108 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S108);
    return;
}

fn halves_0( value_8 : f32) -> vec2<f32>
{
    var high_4 : f32 = (bitcast<f32>((((bitcast<u32>((value_8))) & (u32(4294963200))))));
    return vec2<f32>(high_4, value_8 - high_4);
}

fn exact_product_0( a_3 : f32,  b_2 : f32) -> vec2<f32>
{
    var product_0 : f32 = a_3 * b_2;
    if(!IS_EXACT_0)
    {
        return vec2<f32>(product_0, 0.0f);
    }
    var a_parts_0 : vec2<f32> = halves_0(a_3);
    var b_parts_0 : vec2<f32> = halves_0(b_2);
    var _S109 : f32 = a_parts_0.x;
    var _S110 : f32 = b_parts_0.x;
    var _S111 : f32 = b_parts_0.y;
    var _S112 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S109 * _S110 - product_0 + _S109 * _S111 + _S112 * _S110 + _S112 * _S111);
}

fn exact_start_voxel_0( ray_0 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_0.t_min_3, ray_0.direction_4[u32(0)]);
    var _S113 : f32 = way_0.x;
    var sum_0 : f32 = ray_0.origin_4[u32(0)] + _S113;
    var part_0 : f32 = sum_0 - ray_0.origin_4[u32(0)];
    var low_5 : f32 = ray_0.origin_4[u32(0)] - (sum_0 - part_0) + (_S113 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_4 : vec3<i32>;
    var _S114 : i32 = i32(whole_0);
    var _S115 : bool;
    if(sum_0 == whole_0)
    {
        _S115 = low_5 < 0.0f;
    }
    else
    {
        _S115 = false;
    }
    voxel_4[u32(0)] = _S114 - i32(_S115);
    var way_1 : vec2<f32> = exact_product_0(ray_0.t_min_3, ray_0.direction_4[u32(1)]);
    var _S116 : f32 = way_1.x;
    var sum_1 : f32 = ray_0.origin_4[u32(1)] + _S116;
    var part_1 : f32 = sum_1 - ray_0.origin_4[u32(1)];
    var low_6 : f32 = ray_0.origin_4[u32(1)] - (sum_1 - part_1) + (_S116 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_1);
    var _S117 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S115 = low_6 < 0.0f;
    }
    else
    {
        _S115 = false;
    }
    voxel_4[u32(1)] = _S117 - i32(_S115);
    var way_2 : vec2<f32> = exact_product_0(ray_0.t_min_3, ray_0.direction_4[u32(2)]);
    var _S118 : f32 = way_2.x;
    var sum_2 : f32 = ray_0.origin_4[u32(2)] + _S118;
    var part_2 : f32 = sum_2 - ray_0.origin_4[u32(2)];
    var low_7 : f32 = ray_0.origin_4[u32(2)] - (sum_2 - part_2) + (_S118 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_2);
    var _S119 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S115 = low_7 < 0.0f;
    }
    else
    {
        _S115 = false;
    }
    voxel_4[u32(2)] = _S119 - i32(_S115);
    return voxel_4;
}

fn Writer_cell_0( this_21 : ptr<function, Writer_0>,  value_9 : vec3<i32>)
{
    Writer_word_1(&((*this_21)), u32(value_9.x));
    Writer_word_1(&((*this_21)), u32(value_9.y));
    Writer_word_1(&((*this_21)), u32(value_9.z));
    return;
}

struct Crossing_0
{
     distance_1 : f32,
     distance_low_0 : f32,
     speed_1 : f32,
     axis_0 : u32,
};

fn Crossing_x24init_0( distance_2 : f32,  distance_low_1 : f32,  speed_2 : f32,  axis_1 : u32) -> Crossing_0
{
    var _S120 : Crossing_0;
    _S120.distance_1 = distance_2;
    _S120.distance_low_0 = distance_low_1;
    _S120.speed_1 = speed_2;
    _S120.axis_0 = axis_1;
    return _S120;
}

fn crossing_of_0( ray_1 : LocalRay_0,  axis_2 : u32,  plane_0 : i32) -> Crossing_0
{
    var sign_0 : f32;
    if((ray_1.direction_4[axis_2]) < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var at_4 : f32 = f32(plane_0);
    var difference_0 : f32 = at_4 - ray_1.origin_4[axis_2];
    var part_3 : f32 = difference_0 - at_4;
    return Crossing_x24init_0(difference_0 * sign_0, (at_4 - (difference_0 - part_3) - (ray_1.origin_4[axis_2] + part_3)) * sign_0, abs(ray_1.direction_4[axis_2]), axis_2);
}

fn Crossing_is_before_0( this_22 : Crossing_0,  other_0 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_22.distance_1, other_0.speed_1);
    var theirs_0 : vec2<f32> = exact_product_0(other_0.distance_1, this_22.speed_1);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_22.distance_low_0 * other_0.speed_1;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_0.distance_low_0 * this_22.speed_1;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S121 : bool;
    if(difference_1 < 0.0f)
    {
        _S121 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S121 = (this_22.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S121 = false;
        }
    }
    return _S121;
}

fn leave_box_0( ray_2 : LocalRay_0,  voxel_5 : vec3<i32>,  exit_0 : vec3<i32>,  guess_3 : vec3<i32>) -> vec3<i32>
{
    var _S122 : vec3<f32>;
    var _S123 : f32;
    var _S124 : bool;
    var _S125 : bool;
    var first_1 : Crossing_0;
    var _S126 : f32;
    var _S127 : bool;
    var _S128 : f32;
    var _S129 : bool;
    var _S130 : bool;
    var _S131 : i32;
    var cell_3 : i32;
    var i_0 : u32;
    var _S132 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S122 = ray_2.direction_4;
                _S123 = ray_2.direction_4[u32(0)];
                var _S133 : bool = (ray_2.direction_4[u32(0)]) == 0.0f;
                _S124 = _S133;
                if(_S133)
                {
                    first_1 = _S132;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_of_0(ray_2, u32(0), exit_0[u32(0)]);
                if((_S132.axis_0) == u32(3))
                {
                    _S125 = true;
                }
                else
                {
                    _S125 = Crossing_is_before_0(crossing_0, _S132);
                }
                if(_S125)
                {
                    first_1 = crossing_0;
                }
                else
                {
                    first_1 = _S132;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                _S126 = _S122[u32(1)];
                var _S134 : bool = (_S122[u32(1)]) == 0.0f;
                _S127 = _S134;
                if(_S134)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_of_0(ray_2, u32(1), exit_0[u32(1)]);
                if((first_1.axis_0) == u32(3))
                {
                    _S125 = true;
                }
                else
                {
                    _S125 = Crossing_is_before_0(crossing_1, first_1);
                }
                if(_S125)
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
                _S128 = _S122[u32(2)];
                var _S135 : bool = (_S122[u32(2)]) == 0.0f;
                _S129 = _S135;
                if(_S135)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_of_0(ray_2, u32(2), exit_0[u32(2)]);
                if((first_1.axis_0) == u32(3))
                {
                    _S125 = true;
                }
                else
                {
                    _S125 = Crossing_is_before_0(crossing_2, first_1);
                }
                if(_S125)
                {
                    first_1 = crossing_2;
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
                if(_S124)
                {
                    break;
                }
                var is_negative_0 : bool = _S123 < 0.0f;
                if(u32(0) == (first_1.axis_0))
                {
                    arrival_0[u32(0)] = exit_0[u32(0)] - i32(is_negative_0);
                    break;
                }
                if(is_negative_0)
                {
                    _S131 = i32(-1);
                }
                else
                {
                    _S131 = i32(1);
                }
                if(is_negative_0)
                {
                    cell_3 = min(guess_3[u32(0)], voxel_5[u32(0)]);
                }
                else
                {
                    cell_3 = max(guess_3[u32(0)], voxel_5[u32(0)]);
                }
                var _S136 : i32 = i32(is_negative_0);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = cell_3 != (voxel_5[u32(0)]);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                        _S130 = !Crossing_is_before_0(crossing_of_0(ray_2, u32(0), cell_3 + _S136), first_1);
                    }
                    else
                    {
                        _S130 = false;
                    }
                    if(_S130)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_4 : i32 = cell_3 - _S131;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_4;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = Crossing_is_before_0(crossing_of_0(ray_2, u32(0), cell_3 + _S131 + _S136), first_1);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_5 : i32 = cell_3 + _S131;
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
                if(_S127)
                {
                    break;
                }
                var is_negative_1 : bool = _S126 < 0.0f;
                if(u32(1) == (first_1.axis_0))
                {
                    arrival_0[u32(1)] = exit_0[u32(1)] - i32(is_negative_1);
                    break;
                }
                if(is_negative_1)
                {
                    _S131 = i32(-1);
                }
                else
                {
                    _S131 = i32(1);
                }
                if(is_negative_1)
                {
                    cell_3 = min(guess_3[u32(1)], voxel_5[u32(1)]);
                }
                else
                {
                    cell_3 = max(guess_3[u32(1)], voxel_5[u32(1)]);
                }
                var _S137 : i32 = i32(is_negative_1);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = cell_3 != (voxel_5[u32(1)]);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                        _S130 = !Crossing_is_before_0(crossing_of_0(ray_2, u32(1), cell_3 + _S137), first_1);
                    }
                    else
                    {
                        _S130 = false;
                    }
                    if(_S130)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_6 : i32 = cell_3 - _S131;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_6;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = Crossing_is_before_0(crossing_of_0(ray_2, u32(1), cell_3 + _S131 + _S137), first_1);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_7 : i32 = cell_3 + _S131;
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
                if(_S129)
                {
                    break;
                }
                var is_negative_2 : bool = _S128 < 0.0f;
                if(u32(2) == (first_1.axis_0))
                {
                    arrival_0[u32(2)] = exit_0[u32(2)] - i32(is_negative_2);
                    break;
                }
                if(is_negative_2)
                {
                    _S131 = i32(-1);
                }
                else
                {
                    _S131 = i32(1);
                }
                if(is_negative_2)
                {
                    cell_3 = min(guess_3[u32(2)], voxel_5[u32(2)]);
                }
                else
                {
                    cell_3 = max(guess_3[u32(2)], voxel_5[u32(2)]);
                }
                var _S138 : i32 = i32(is_negative_2);
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = cell_3 != (voxel_5[u32(2)]);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                        _S130 = !Crossing_is_before_0(crossing_of_0(ray_2, u32(2), cell_3 + _S138), first_1);
                    }
                    else
                    {
                        _S130 = false;
                    }
                    if(_S130)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_8 : i32 = cell_3 - _S131;
                    i_0 = i_0 + u32(1);
                    cell_3 = cell_8;
                }
                i_0 = u32(0);
                for(;;)
                {
                    if(i_0 < u32(4))
                    {
                        _S125 = Crossing_is_before_0(crossing_of_0(ray_2, u32(2), cell_3 + _S131 + _S138), first_1);
                    }
                    else
                    {
                        _S125 = false;
                    }
                    if(_S125)
                    {
                    }
                    else
                    {
                        break;
                    }
                    var cell_9 : i32 = cell_3 + _S131;
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

fn Hit_x24init_0( t_1 : f32,  instance_1 : u32,  voxel_6 : vec3<i32>,  face_1 : u32) -> Hit_0
{
    var _S139 : Hit_0;
    _S139.t_0 = t_1;
    _S139.instance_0 = instance_1;
    _S139.voxel_1 = voxel_6;
    _S139.face_0 = face_1;
    return _S139;
}

fn hit_of_0( ray_3 : LocalRay_0,  voxel_7 : vec3<i32>,  instance_2 : u32) -> Hit_0
{
    var _S140 : vec3<f32>;
    var _S141 : bool;
    var last_0 : Crossing_0;
    var _S142 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                _S140 = ray_3.direction_4;
                if((ray_3.direction_4[u32(0)]) == 0.0f)
                {
                    last_0 = _S142;
                    break;
                }
                var crossing_3 : Crossing_0 = crossing_of_0(ray_3, u32(0), voxel_7[u32(0)] + i32((ray_3.direction_4[u32(0)]) < 0.0f));
                if((_S142.axis_0) == u32(3))
                {
                    _S141 = true;
                }
                else
                {
                    _S141 = !Crossing_is_before_0(crossing_3, _S142);
                }
                if(_S141)
                {
                    last_0 = crossing_3;
                }
                else
                {
                    last_0 = _S142;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                var _S143 : vec3<f32> = _S140;
                if((_S140[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_4 : Crossing_0 = crossing_of_0(ray_3, u32(1), voxel_7[u32(1)] + i32((_S143[u32(1)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S141 = true;
                }
                else
                {
                    _S141 = !Crossing_is_before_0(crossing_4, last_0);
                }
                if(_S141)
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
                var _S144 : vec3<f32> = _S140;
                if((_S140[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_5 : Crossing_0 = crossing_of_0(ray_3, u32(2), voxel_7[u32(2)] + i32((_S144[u32(2)]) < 0.0f));
                if((last_0.axis_0) == u32(3))
                {
                    _S141 = true;
                }
                else
                {
                    _S141 = !Crossing_is_before_0(crossing_5, last_0);
                }
                if(_S141)
                {
                    last_0 = crossing_5;
                }
                break;
            }
            break;
        }
        break;
    }
    var _S145 : Crossing_0 = last_0;
    var is_negative_3 : bool = (_S140[last_0.axis_0]) < 0.0f;
    var t_2 : f32 = (f32(voxel_7[last_0.axis_0] + i32(is_negative_3)) - ray_3.origin_4[last_0.axis_0]) * ray_3.inverse_0[last_0.axis_0];
    var _S146 : f32;
    if(t_2 > (ray_3.t_min_3))
    {
        _S146 = t_2;
    }
    else
    {
        _S146 = ray_3.t_min_3;
    }
    return Hit_x24init_0(_S146, instance_2, voxel_7, u32(2) * _S145.axis_0 + u32(is_negative_3));
}

@compute
@workgroup_size(64, 1, 1)
fn check_exact(@builtin(global_invocation_id) id_7 : vec3<u32>, @builtin(local_invocation_index) thread_8 : u32)
{
    prove_0(thread_8);
    var _S147 : u32 = id_7.x;
    if(_S147 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_7 : Reader_0 = Reader_x24init_0(u32(17) * _S147);
    var writer_7 : Writer_0 = Writer_x24init_0(u32(8) * _S147);
    var _S148 : Ray_0 = Reader_ray_0(&(reader_7));
    var _S149 : LocalRay_0 = local_ray_0(_S148, i32(0));
    var voxel_8 : vec3<i32> = Reader_cell_0(&(reader_7));
    var exit_1 : vec3<i32> = Reader_cell_0(&(reader_7));
    Writer_cell_0(&(writer_7), exact_start_voxel_0(_S149));
    var _S150 : vec3<i32> = Reader_cell_0(&(reader_7));
    Writer_cell_0(&(writer_7), leave_box_0(_S149, voxel_8, exit_1, _S150));
    var hit_1 : Hit_0 = hit_of_0(_S149, voxel_8, u32(0));
    Writer_number_0(&(writer_7), hit_1.t_0);
    Writer_word_0(&(writer_7), hit_1.face_0);
    return;
}

fn Reader_hit_0( this_23 : ptr<function, Reader_0>) -> Hit_0
{
    var t_3 : f32 = Reader_number_1(&((*this_23)));
    var instance_3 : u32 = Reader_word_1(&((*this_23)));
    var voxel_9 : vec3<i32> = Reader_cell_1(&((*this_23)));
    var _S151 : u32 = Reader_word_1(&((*this_23)));
    return Hit_x24init_0(t_3, instance_3, voxel_9, _S151);
}

@id(7) override HAS_CUTS_0 : bool = false;

fn is_cut_0( hit_2 : Hit_0) -> bool
{
    return (hit_2.face_0) >= u32(6);
}

fn cut_normal_0( face_2 : u32) -> vec3<f32>
{
    var normal_1 : vec3<f32> = params_0.planes_0[((face_2 - u32(6)) >> (u32(1)))].xyz;
    var _S152 : vec3<f32>;
    if(((face_2 & (u32(1)))) == u32(1))
    {
        _S152 = (vec3<f32>(0) - normal_1);
    }
    else
    {
        _S152 = normal_1;
    }
    return _S152;
}

fn cut_margin_0( face_3 : u32) -> f32
{
    return clamp(abs(params_0.planes_0[((face_3 - u32(6)) >> (u32(1)))].w) * 9.5367431640625e-07f, 0.0009765625f, 0.25f);
}

fn leaves_cut_0( hit_3 : Hit_0) -> bool
{
    var _S153 : bool;
    if(is_cut_0(hit_3))
    {
        _S153 = (((hit_3.face_0) & (u32(1)))) == u32(1);
    }
    else
    {
        _S153 = false;
    }
    return _S153;
}

fn margin_of_0( translation_1 : vec3<f32>,  low_8 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_8) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn clamp_to_voxel_0( translation_2 : vec3<f32>,  low_9 : vec3<f32>,  point_1 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_9);
    return min(max(point_1, low_9 + vec3<f32>(margin_0)), low_9 + vec3<f32>((1.0f - margin_0)));
}

fn Transform_direction_1( _S154 : u32,  _S155 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S154].grid_from_world_0.x_axis_0) * vec3<f32>(_S155.x) + vector_of_0(instances_0[_S154].grid_from_world_0.y_axis_0) * vec3<f32>(_S155.y) + vector_of_0(instances_0[_S154].grid_from_world_0.z_axis_0) * vec3<f32>(_S155.z);
}

fn Transform_point_1( _S156 : u32,  _S157 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_1(_S156, _S157) + vector_of_0(instances_0[_S156].grid_from_world_0.translation_0);
}

fn Transform_direction_2( _S158 : u32,  _S159 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(instances_0[_S158].world_from_grid_0.x_axis_0) * vec3<f32>(_S159.x) + vector_of_0(instances_0[_S158].world_from_grid_0.y_axis_0) * vec3<f32>(_S159.y) + vector_of_0(instances_0[_S158].world_from_grid_0.z_axis_0) * vec3<f32>(_S159.z);
}

fn Transform_point_2( _S160 : u32,  _S161 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_2(_S160, _S161) + vector_of_0(instances_0[_S160].world_from_grid_0.translation_0);
}

fn in_voxel_0( hit_4 : Hit_0,  point_2 : vec3<f32>) -> vec3<f32>
{
    return Transform_point_2(hit_4.instance_0, clamp_to_voxel_0(vector_of_0(instances_0[hit_4.instance_0].grid_from_world_0.translation_0), vec3<f32>(hit_4.voxel_1), Transform_point_1(hit_4.instance_0, point_2)));
}

fn before_cut_0( ray_4 : Ray_0,  hit_5 : Hit_0,  normal_2 : vec3<f32>) -> vec3<f32>
{
    var point_3 : vec3<f32> = ray_4.origin_1 + ray_4.direction_1 * vec3<f32>(hit_5.t_0) + normal_2 * vec3<f32>(cut_margin_0(hit_5.face_0));
    var _S162 : vec3<f32>;
    if(leaves_cut_0(hit_5))
    {
        _S162 = in_voxel_0(hit_5, point_3);
    }
    else
    {
        _S162 = point_3;
    }
    return _S162;
}

fn offset_ray_origin_0( translation_3 : vec3<f32>,  low_10 : vec3<f32>,  face_4 : u32,  point_4 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_10);
    var _S163 : vec3<f32> = vec3<f32>(margin_1);
    var moved_0 : vec3<f32> = min(max(point_4, low_10 + _S163), low_10 + vec3<f32>((1.0f - margin_1)));
    var _S164 : bool = face_4 < u32(2);
    var _S165 : bool;
    if(face_4 >= u32(2))
    {
        _S165 = face_4 < u32(4);
    }
    else
    {
        _S165 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S164, _S165, face_4 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_4 & (u32(1)))) == u32(1))
    {
        outside_0 = low_10 + vec3<f32>((1.0f + margin_1));
    }
    else
    {
        outside_0 = low_10 - _S163;
    }
    return select(moved_0, outside_0, is_axis_0);
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
    var _S166 : f32;
    if(face_5 < u32(2))
    {
        _S166 = away_0;
    }
    else
    {
        _S166 = 0.0f;
    }
    var _S167 : bool;
    if(face_5 >= u32(2))
    {
        _S167 = face_5 < u32(4);
    }
    else
    {
        _S167 = false;
    }
    var _S168 : f32;
    if(_S167)
    {
        _S168 = away_0;
    }
    else
    {
        _S168 = 0.0f;
    }
    if(face_5 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S166, _S168, away_0);
}

struct Surface_0
{
     origin_6 : vec3<f32>,
     normal_3 : vec3<f32>,
     face_6 : u32,
     instance_4 : u32,
};

fn world_normal_0( _S169 : u32,  _S170 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_2(_S169, face_normal_0(_S170)));
}

fn surface_of_0( ray_5 : Ray_0,  hit_6 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S171 : vec3<f32> = vec3<f32>(hit_6.voxel_1);
    var _S172 : bool;
    if(HAS_CUTS_0)
    {
        _S172 = is_cut_0(hit_6);
    }
    else
    {
        _S172 = false;
    }
    if(_S172)
    {
        var _S173 : vec3<f32> = cut_normal_0(hit_6.face_0);
        surface_0.normal_3 = _S173;
        surface_0.origin_6 = before_cut_0(ray_5, hit_6, _S173);
    }
    else
    {
        if(IS_SINGLE_0)
        {
            surface_0.origin_6 = offset_ray_origin_0(vec3<f32>(0.0f), _S171, hit_6.face_0, ray_5.origin_1 + ray_5.direction_1 * vec3<f32>(hit_6.t_0));
            surface_0.normal_3 = face_normal_0(hit_6.face_0);
        }
        else
        {
            surface_0.origin_6 = Transform_point_2(hit_6.instance_0, offset_ray_origin_0(vector_of_0(instances_0[hit_6.instance_0].grid_from_world_0.translation_0), _S171, hit_6.face_0, Transform_point_1(hit_6.instance_0, ray_5.origin_1) + Transform_direction_1(hit_6.instance_0, ray_5.direction_1) * vec3<f32>(hit_6.t_0)));
            surface_0.normal_3 = world_normal_0(hit_6.instance_0, hit_6.face_0);
        }
    }
    surface_0.face_6 = hit_6.face_0;
    surface_0.instance_4 = hit_6.instance_0;
    return surface_0;
}

@id(10) override HAS_NORMALS_0 : bool = false;

fn orthonormal_pair_0( z_0 : vec3<f32>,  x_7 : ptr<function, vec3<f32>>,  y_4 : ptr<function, vec3<f32>>)
{
    var _S174 : f32 = z_0.z;
    var sign_1 : f32;
    if(_S174 < 0.0f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_4 : f32 = divide_0(-1.0f, sign_1 + _S174);
    var _S175 : f32 = z_0.x;
    var _S176 : f32 = z_0.y;
    var b_3 : f32 = _S175 * _S176 * a_4;
    (*x_7) = vec3<f32>(1.0f + sign_1 * _S175 * _S175 * a_4, sign_1 * b_3, - sign_1 * _S175);
    (*y_4) = vec3<f32>(b_3, sign_1 + _S176 * _S176 * a_4, - _S176);
    return;
}

fn orthonormal_pair_1( z_1 : vec3<f32>,  x_8 : ptr<function, vec3<f32>>,  y_5 : ptr<function, vec3<f32>>)
{
    var _S177 : f32 = z_1.z;
    var sign_2 : f32;
    if(_S177 < 0.0f)
    {
        sign_2 = -1.0f;
    }
    else
    {
        sign_2 = 1.0f;
    }
    var a_5 : f32 = divide_0(-1.0f, sign_2 + _S177);
    var _S178 : f32 = z_1.x;
    var _S179 : f32 = z_1.y;
    var b_4 : f32 = _S178 * _S179 * a_5;
    (*x_8) = vec3<f32>(1.0f + sign_2 * _S178 * _S178 * a_5, sign_2 * b_4, - sign_2 * _S178);
    (*y_5) = vec3<f32>(b_4, sign_2 + _S179 * _S179 * a_5, - _S179);
    return;
}

fn Surface_world_direction_0( this_24 : Surface_0,  local_1 : vec3<f32>) -> vec3<f32>
{
    var _S180 : bool;
    if(HAS_CUTS_0)
    {
        _S180 = true;
    }
    else
    {
        _S180 = HAS_NORMALS_0;
    }
    if(_S180)
    {
        _S180 = (this_24.face_6) >= u32(6);
    }
    else
    {
        _S180 = false;
    }
    if(_S180)
    {
        var x_9 : vec3<f32>;
        var y_6 : vec3<f32>;
        orthonormal_pair_0(this_24.normal_3, &(x_9), &(y_6));
        return normalize_vector_0(x_9 * vec3<f32>(local_1.x) + y_6 * vec3<f32>(local_1.y) + this_24.normal_3 * vec3<f32>(local_1.z));
    }
    var away_1 : f32;
    if((((this_24.face_6) & (u32(1)))) == u32(1))
    {
        away_1 = local_1.z;
    }
    else
    {
        away_1 = - local_1.z;
    }
    var _S181 : f32 = local_1.x;
    var _S182 : f32 = local_1.y;
    var _S183 : vec3<f32> = vec3<f32>(_S181, _S182, away_1);
    var in_grid_0 : vec3<f32>;
    if((this_24.face_6) < u32(2))
    {
        in_grid_0 = vec3<f32>(away_1, _S181, _S182);
    }
    else
    {
        if((this_24.face_6) < u32(4))
        {
            in_grid_0 = vec3<f32>(_S182, away_1, _S181);
        }
        else
        {
            in_grid_0 = _S183;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_0 = Transform_direction_2(this_24.instance_4, in_grid_0);
    }
    return normalize_vector_0(in_grid_0);
}

fn Surface_local_direction_0( this_25 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var _S184 : bool;
    if(HAS_CUTS_0)
    {
        _S184 = true;
    }
    else
    {
        _S184 = HAS_NORMALS_0;
    }
    if(_S184)
    {
        _S184 = (this_25.face_6) >= u32(6);
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        var x_10 : vec3<f32>;
        var y_7 : vec3<f32>;
        orthonormal_pair_0(this_25.normal_3, &(x_10), &(y_7));
        var unit_1 : vec3<f32> = normalize_vector_0(world_0);
        return vec3<f32>(dot_product_0(x_10, unit_1), dot_product_0(y_7, unit_1), dot_product_0(this_25.normal_3, unit_1));
    }
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_1(this_25.instance_4, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_2 : vec3<f32>;
    if((this_25.face_6) < u32(2))
    {
        local_2 = in_grid_2.yzx;
    }
    else
    {
        if((this_25.face_6) < u32(4))
        {
            local_2 = in_grid_2.zxy;
        }
        else
        {
            local_2 = in_grid_2;
        }
    }
    if((((this_25.face_6) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_2;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_2.xy, - local_2.z);
    }
    return in_grid_1;
}

@compute
@workgroup_size(64, 1, 1)
fn check_surface(@builtin(global_invocation_id) id_8 : vec3<u32>, @builtin(local_invocation_index) thread_9 : u32)
{
    prove_0(thread_9);
    var _S185 : u32 = id_8.x;
    if(_S185 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_8 : Reader_0 = Reader_x24init_0(u32(17) * _S185);
    var writer_8 : Writer_0 = Writer_x24init_0(u32(12) * _S185);
    var ray_6 : Ray_0 = Reader_ray_0(&(reader_8));
    var _S186 : Hit_0 = Reader_hit_0(&(reader_8));
    var surface_1 : Surface_0 = surface_of_0(ray_6, _S186);
    Writer_vector_0(&(writer_8), surface_1.origin_6);
    Writer_vector_0(&(writer_8), surface_1.normal_3);
    var direction_6 : vec3<f32> = Reader_vector_0(&(reader_8));
    Writer_vector_0(&(writer_8), Surface_world_direction_0(surface_1, direction_6));
    Writer_vector_0(&(writer_8), Surface_local_direction_0(surface_1, direction_6));
    return;
}

fn Receiver_x24init_0( point_5 : vec3<f32>,  normal_4 : vec3<f32>) -> Receiver_0
{
    var _S187 : Receiver_0;
    _S187.point_0 = point_5;
    _S187.normal_0 = normal_4;
    return _S187;
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>((u32(2139095040)))), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn Aim_x24init_0( is_met_1 : bool,  direction_7 : vec3<f32>,  hit_7 : Hit_0) -> Aim_0
{
    var _S188 : Aim_0;
    _S188.is_met_0 = is_met_1;
    _S188.direction_0 = direction_7;
    _S188.hit_0 = hit_7;
    return _S188;
}

fn by_chance_0() -> Aim_0
{
    return Aim_x24init_0(false, vec3<f32>(0.0f), miss_0());
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn node_importance_1( _S189 : i32,  _S190 : Receiver_0) -> f32
{
    var low_11 : vec3<f32> = vector_of_0(top_light_nodes_0[_S189].min_1);
    var high_5 : vec3<f32> = vector_of_0(top_light_nodes_0[_S189].max_1);
    var _S191 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (high_5 - low_11) * _S191;
    var toward_1 : vec3<f32> = (low_11 + high_5) * _S191 - _S190.point_0;
    var above_1 : f32 = with_slack_0(_S190, dot_product_0(toward_1, _S190.normal_0) + dot_product_0(half_2, abs(_S190.normal_0)));
    var far_1 : f32 = length_squared_0(toward_1);
    var near_1 : f32 = length_squared_0(half_2);
    var distance_3 : f32 = length_bound_0(select(half_2, abs(toward_1), vec3<bool>((far_1 > near_1))));
    var _S192 : vec3<f32> = vec3<f32>(0.0f);
    var _S193 : vec3<f32> = vec3<f32>(distance_3);
    var beyond_min_1 : vec3<f32> = min(max(_S190.point_0 - low_11, _S192), _S193);
    var beyond_max_1 : vec3<f32> = min(max(high_5 - _S190.point_0, _S192), _S193);
    var sent_1 : f32 = top_light_nodes_0[_S189].power_0[i32(0)] * beyond_max_1.x + top_light_nodes_0[_S189].power_0[i32(1)] * beyond_min_1.x + (top_light_nodes_0[_S189].power_0[i32(2)] * beyond_max_1.y + top_light_nodes_0[_S189].power_0[i32(3)] * beyond_min_1.y) + (top_light_nodes_0[_S189].power_0[i32(4)] * beyond_max_1.z + top_light_nodes_0[_S189].power_0[i32(5)] * beyond_min_1.z);
    var falloff_1 : f32 = reciprocal_guess_0(max(far_1, near_1));
    var _S194 : f32;
    if(above_1 > 0.0f)
    {
        _S194 = sent_1 * min(above_1, distance_3) * (falloff_1 * falloff_1);
    }
    else
    {
        _S194 = 0.0f;
    }
    return _S194;
}

fn importance_of_all_0( receiver_4 : Receiver_0) -> f32
{
    if((params_0.light_node_count_0) == u32(0))
    {
        return 0.0f;
    }
    return node_importance_1(i32(0), receiver_4) * params_0.light_intensity_0;
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
    var cos_theta_1 : f32 = with_slack_0(receiver_6, dot_product_0(receiver_6.normal_0, params_0.sun_direction_0));
    if(cos_theta_1 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    var from_emitters_0 : f32 = EmitterTree_importance_0(receiver_6);
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var cos_theta_2 : f32;
    if((Receiver_slack_0(receiver_6)) > 0.0f)
    {
        cos_theta_2 = 1.0f;
    }
    else
    {
        cos_theta_2 = cos_theta_1;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_2, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S195 : bool;
    if(SKY_0 == u32(1))
    {
        _S195 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S195 = false;
    }
    return _S195;
}

struct Selection_0
{
     sun_0 : f32,
     sky_1 : f32,
     emitters_1 : f32,
};

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_2 : f32) -> Selection_0
{
    var _S196 : Selection_0;
    _S196.sun_0 = sun_1;
    _S196.sky_1 = sky_2;
    _S196.emitters_1 = emitters_2;
    return _S196;
}

fn Lights_sky_probability_0( receiver_7 : Receiver_0) -> f32
{
    var cos_theta_3 : f32 = dot_product_0(receiver_7.normal_0, params_0.sun_direction_0);
    var from_sun_1 : f32;
    if(has_sun_0())
    {
        from_sun_1 = params_0.sun_irradiance_0 * max(cos_theta_3, 0.0f);
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
    var _S197 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S197, sky_3, (1.0f - sun_2) * _S197);
}

fn ray_from_0( origin_7 : vec3<f32>,  direction_8 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_7, 0.0f, direction_8, (bitcast<f32>((u32(2139095040)))));
}

struct LightSample_0
{
     ray_7 : Ray_0,
     cos_theta_4 : f32,
     radiance_3 : vec3<f32>,
     pdf_1 : f32,
};

fn LightSample_x24init_0( ray_8 : Ray_0,  cos_theta_5 : f32,  radiance_4 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S198 : LightSample_0;
    _S198.ray_7 = ray_8;
    _S198.cos_theta_4 = cos_theta_5;
    _S198.radiance_3 = radiance_4;
    _S198.pdf_1 = pdf_2;
    return _S198;
}

fn SunDisc_sample_0( receiver_9 : Receiver_0,  u_2 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_2.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_1 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_2 : vec2<f32> = sincos_turns_0(u_2.w);
    var direction_9 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_1 * sin_cos_2.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_1 * sin_cos_2.x)));
    var cos_theta_6 : f32 = with_slack_0(receiver_9, dot_product_0(receiver_9.normal_0, direction_9));
    (*sample_3) = LightSample_x24init_0(ray_from_0(receiver_9.point_0, direction_9), cos_theta_6, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_6 > 0.0f;
}

fn no_light_0() -> LightSample_0
{
    var _S199 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S199, 0.0f, _S199, 0.0f), 0.0f, _S199, 0.0f);
}

struct ChosenDirection_0
{
     direction_10 : vec3<f32>,
     radiance_5 : vec3<f32>,
     pdf_3 : f32,
};

fn ChosenDirection_x24init_0( direction_11 : vec3<f32>,  radiance_6 : vec3<f32>,  pdf_4 : f32) -> ChosenDirection_0
{
    var _S200 : ChosenDirection_0;
    _S200.direction_10 = direction_11;
    _S200.radiance_5 = radiance_6;
    _S200.pdf_3 = pdf_4;
    return _S200;
}

fn direction_of_0( square_0 : vec2<f32>) -> vec3<f32>
{
    var u_3 : f32 = square_0.x * 2.0f - 1.0f;
    var v_3 : f32 = square_0.y * 2.0f - 1.0f;
    var _S201 : f32 = abs(u_3);
    var _S202 : f32 = abs(v_3);
    var height_1 : f32 = 1.0f - (_S201 + _S202);
    var radius_2 : f32 = 1.0f - abs(height_1);
    var turns_1 : f32;
    if(radius_2 > 0.0f)
    {
        turns_1 = (divide_0(_S202 - _S201, radius_2) + 1.0f) * 0.125f;
    }
    else
    {
        turns_1 = 0.0f;
    }
    var sin_cos_3 : vec2<f32> = sincos_turns_0(turns_1);
    var _S203 : f32 = radius_2 * radius_2;
    var across_0 : f32 = radius_2 * square_root_0(2.0f - _S203);
    var x_11 : f32 = sin_cos_3.y * across_0;
    var y_8 : f32 = sin_cos_3.x * across_0;
    var z_2 : f32 = 1.0f - _S203;
    if(u_3 < 0.0f)
    {
        turns_1 = - x_11;
    }
    else
    {
        turns_1 = x_11;
    }
    var _S204 : f32;
    if(v_3 < 0.0f)
    {
        _S204 = - y_8;
    }
    else
    {
        _S204 = y_8;
    }
    var _S205 : f32;
    if(height_1 < 0.0f)
    {
        _S205 = - z_2;
    }
    else
    {
        _S205 = z_2;
    }
    return vec3<f32>(turns_1, _S204, _S205);
}

fn Environment_to_world_0( d_0 : vec3<f32>) -> vec3<f32>
{
    var sin_1 : f32 = params_0.sky_turned_0.x;
    var cos_2 : f32 = params_0.sky_turned_0.y;
    var _S206 : f32 = d_0.x;
    var _S207 : f32 = d_0.y;
    return vec3<f32>(_S206 * cos_2 + _S207 * sin_1, _S207 * cos_2 - _S206 * sin_1, d_0.z);
}

fn Environment_index_of_0( x_12 : i32,  y_9 : i32) -> u32
{
    var last_1 : i32 = i32(params_0.sky_edge_0) - i32(1);
    var is_beside_0 : bool;
    if(x_12 < i32(0))
    {
        is_beside_0 = true;
    }
    else
    {
        is_beside_0 = x_12 > last_1;
    }
    var _S208 : i32;
    if(is_beside_0)
    {
        _S208 = last_1 - y_9;
    }
    else
    {
        _S208 = y_9;
    }
    var _S209 : i32;
    if(is_beside_0)
    {
        _S209 = clamp(x_12, i32(0), last_1);
    }
    else
    {
        _S209 = x_12;
    }
    var is_beyond_0 : bool;
    if(_S208 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S208 > last_1;
    }
    if(is_beyond_0)
    {
        _S209 = last_1 - _S209;
    }
    if(is_beyond_0)
    {
        _S208 = clamp(_S208, i32(0), last_1);
    }
    return u32(_S208 * i32(params_0.sky_edge_0) + _S209);
}

fn Environment_texel_radiance_0( x_13 : i32,  y_10 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_13, y_10)].radiance_0);
}

fn Environment_radiance_at_0( place_0 : vec2<f32>) -> vec3<f32>
{
    var _S210 : vec2<f32> = place_0 - vec2<f32>(0.5f);
    var corner_1 : vec2<f32> = floor(_S210);
    var beyond_0 : vec2<f32> = _S210 - corner_1;
    var x_14 : i32 = i32(corner_1.x);
    var y_11 : i32 = i32(corner_1.y);
    var _S211 : f32 = beyond_0.x;
    var _S212 : vec3<f32> = vec3<f32>((1.0f - _S211));
    var _S213 : i32 = x_14 + i32(1);
    var _S214 : vec3<f32> = vec3<f32>(_S211);
    var _S215 : i32 = y_11 + i32(1);
    var _S216 : f32 = beyond_0.y;
    return (Environment_texel_radiance_0(x_14, y_11) * _S212 + Environment_texel_radiance_0(_S213, y_11) * _S214) * vec3<f32>((1.0f - _S216)) + (Environment_texel_radiance_0(x_14, _S215) * _S212 + Environment_texel_radiance_0(_S213, _S215) * _S214) * vec3<f32>(_S216);
}

fn Environment_choose_0( u_4 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S217 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S217, _S217, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S218 : f32 = u_4.x * edge_0;
    var _S219 : f32 = edge_0 - 1.0f;
    var _S220 : f32 = min(floor(_S218), _S219);
    var own_0 : u32 = u32(_S220) * params_0.sky_edge_0 + u32(min(floor(u_4.y * edge_0), _S219));
    var index_7 : u32;
    if((u_4.z) < (environment_0[own_0].threshold_0))
    {
        index_7 = own_0;
    }
    else
    {
        index_7 = environment_0[own_0].alias_0;
    }
    var pdf_5 : f32 = environment_0[index_7].pdf_0;
    if((environment_0[index_7].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S221 : u32 = index_7 % params_0.sky_edge_0;
    var _S222 : f32 = f32(_S221);
    var _S223 : u32 = index_7 / params_0.sky_edge_0;
    var place_1 : vec2<f32> = vec2<f32>(_S222, f32(_S223)) + vec2<f32>(min(_S218 - _S220, 1.0f), u_4.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_1 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_1), pdf_5);
    return true;
}

fn Sky_sample_0( receiver_10 : Receiver_0,  u_5 : vec4<f32>,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    (*sample_4) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S224 : bool;
    if(SKY_0 != u32(1))
    {
        _S224 = true;
    }
    else
    {
        var _S225 : bool = Environment_choose_0(u_5, &(chosen_1));
        _S224 = !_S225;
    }
    if(_S224)
    {
        return false;
    }
    var cos_theta_7 : f32 = dot_product_0(receiver_10.normal_0, chosen_1.direction_10);
    (*sample_4) = LightSample_x24init_0(ray_from_0(receiver_10.point_0, chosen_1.direction_10), cos_theta_7, chosen_1.radiance_5 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_3);
    return cos_theta_7 > 0.0f;
}

fn Descent_x24init_0( node_4 : u32,  index_8 : u32,  count_4 : u32,  weight_2 : f32,  total_3 : f32,  choice_1 : f32) -> Descent_0
{
    var _S226 : Descent_0;
    _S226.node_0 = node_4;
    _S226.index_1 = index_8;
    _S226.count_2 = count_4;
    _S226.weight_0 = weight_2;
    _S226.total_0 = total_3;
    _S226.choice_0 = choice_1;
    return _S226;
}

fn node_importance_2( _S227 : u32,  _S228 : Receiver_0) -> f32
{
    var low_12 : vec3<f32> = vector_of_0(top_light_nodes_0[_S227].min_1);
    var high_6 : vec3<f32> = vector_of_0(top_light_nodes_0[_S227].max_1);
    var _S229 : vec3<f32> = vec3<f32>(0.5f);
    var half_3 : vec3<f32> = (high_6 - low_12) * _S229;
    var toward_2 : vec3<f32> = (low_12 + high_6) * _S229 - _S228.point_0;
    var above_2 : f32 = with_slack_0(_S228, dot_product_0(toward_2, _S228.normal_0) + dot_product_0(half_3, abs(_S228.normal_0)));
    var far_2 : f32 = length_squared_0(toward_2);
    var near_2 : f32 = length_squared_0(half_3);
    var distance_4 : f32 = length_bound_0(select(half_3, abs(toward_2), vec3<bool>((far_2 > near_2))));
    var _S230 : vec3<f32> = vec3<f32>(0.0f);
    var _S231 : vec3<f32> = vec3<f32>(distance_4);
    var beyond_min_2 : vec3<f32> = min(max(_S228.point_0 - low_12, _S230), _S231);
    var beyond_max_2 : vec3<f32> = min(max(high_6 - _S228.point_0, _S230), _S231);
    var sent_2 : f32 = top_light_nodes_0[_S227].power_0[i32(0)] * beyond_max_2.x + top_light_nodes_0[_S227].power_0[i32(1)] * beyond_min_2.x + (top_light_nodes_0[_S227].power_0[i32(2)] * beyond_max_2.y + top_light_nodes_0[_S227].power_0[i32(3)] * beyond_min_2.y) + (top_light_nodes_0[_S227].power_0[i32(4)] * beyond_max_2.z + top_light_nodes_0[_S227].power_0[i32(5)] * beyond_min_2.z);
    var falloff_2 : f32 = reciprocal_guess_0(max(far_2, near_2));
    var _S232 : f32;
    if(above_2 > 0.0f)
    {
        _S232 = sent_2 * min(above_2, distance_4) * (falloff_2 * falloff_2);
    }
    else
    {
        _S232 = 0.0f;
    }
    return _S232;
}

fn climb_0( receiver_11 : Receiver_0,  start_2 : u32,  descent_2 : ptr<function, Descent_0>) -> bool
{
    var _S233 : LightNode_std430_0 = top_light_nodes_0[start_2];
    var node_5 : LightNode_0;
    node_5.min_1 = _S233.min_1;
    node_5.index_0 = _S233.index_0;
    node_5.max_1 = _S233.max_1;
    node_5.count_1 = _S233.count_1;
    node_5.power_0 = _S233.power_0;
    node_5.parent_0 = _S233.parent_0;
    node_5.root_0 = _S233.root_0;
    var at_5 : u32 = start_2;
    for(;;)
    {
        var _S234 : LightNode_0 = node_5;
        if((node_5.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_std430_0 = top_light_nodes_0[_S234.parent_0];
        var _S235 : u32 = _S234.parent_0 + u32(1);
        var is_left_2 : bool = at_5 == _S235;
        var _S236 : u32;
        if(is_left_2)
        {
            _S236 = parent_1.index_0;
        }
        else
        {
            _S236 = _S235;
        }
        var own_1 : f32 = node_importance_0(node_5, receiver_11);
        var _S237 : f32 = node_importance_2(_S236, receiver_11);
        var _S238 : f32;
        if(is_left_2)
        {
            _S238 = own_1;
        }
        else
        {
            _S238 = _S237;
        }
        var _S239 : f32;
        if(is_left_2)
        {
            _S239 = _S237;
        }
        else
        {
            _S239 = own_1;
        }
        var weights_2 : vec2<f32> = weights_of_0(_S238, _S239);
        var _S240 : f32 = weights_2.x;
        var _S241 : f32 = weights_2.y;
        var total_4 : f32 = _S240 + _S241;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S242 : f32;
        if(is_left_2)
        {
            _S242 = _S240;
        }
        else
        {
            _S242 = _S241;
        }
        (*descent_2).weight_0 = (*descent_2).weight_0 * _S242;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        node_5.min_1 = parent_1.min_1;
        node_5.index_0 = parent_1.index_0;
        node_5.max_1 = parent_1.max_1;
        node_5.count_1 = parent_1.count_1;
        node_5.power_0 = parent_1.power_0;
        node_5.parent_0 = parent_1.parent_0;
        node_5.root_0 = parent_1.root_0;
        at_5 = _S234.parent_0;
    }
    return ((*descent_2).weight_0) > 0.0f;
}

fn in_grid_3( instance_5 : u32,  receiver_12 : Receiver_0) -> Receiver_0
{
    var _S243 : bool;
    if(IS_SINGLE_0)
    {
        if(HAS_CUTS_0)
        {
            _S243 = true;
        }
        else
        {
            _S243 = HAS_NORMALS_0;
        }
    }
    else
    {
        _S243 = false;
    }
    if(_S243)
    {
        _S243 = (Receiver_slack_0(receiver_12)) <= 0.0f;
    }
    else
    {
        _S243 = false;
    }
    if(_S243)
    {
        return Receiver_x24init_0(receiver_12.point_0, normalize_vector_0(receiver_12.normal_0));
    }
    if(IS_SINGLE_0)
    {
        return receiver_12;
    }
    if((Receiver_slack_0(receiver_12)) > 0.0f)
    {
        return Receiver_x24init_0(Transform_point_1(instance_5, receiver_12.point_0), receiver_12.normal_0);
    }
    return Receiver_x24init_0(Transform_point_1(instance_5, receiver_12.point_0), normalize_vector_0(Transform_direction_1(instance_5, receiver_12.normal_0)));
}

struct FaceChoice_0
{
     emitter_0 : u32,
     axis_3 : u32,
     importance_0 : f32,
};

fn FaceChoice_x24init_0( emitter_1 : u32,  axis_4 : u32,  importance_1 : f32) -> FaceChoice_0
{
    var _S244 : FaceChoice_0;
    _S244.emitter_0 = emitter_1;
    _S244.axis_3 = axis_4;
    _S244.importance_0 = importance_1;
    return _S244;
}

fn sum_of_0( importances_0 : vec3<f32>) -> f32
{
    return importances_0.x + importances_0.y + importances_0.z;
}

fn component_0( vector_5 : vec3<f32>,  axis_5 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_5 == u32(1)), vector_5.x, axis_5 == u32(0));
}

fn choose_axis_0( importances_1 : vec3<f32>,  threshold_1 : f32) -> u32
{
    var _S245 : f32 = importances_1.x;
    if(threshold_1 < _S245)
    {
        return u32(0);
    }
    var _S246 : f32 = importances_1.y;
    if(threshold_1 < (_S245 + _S246))
    {
        return u32(1);
    }
    if((importances_1.z) > 0.0f)
    {
        return u32(2);
    }
    var _S247 : i32;
    if(_S246 > 0.0f)
    {
        _S247 = i32(1);
    }
    else
    {
        _S247 = i32(0);
    }
    return u32(_S247);
}

fn face_importances_0( _S248 : u32,  _S249 : Receiver_0) -> vec3<f32>
{
    var _S250 : vec3<f32> = vec3<f32>(0.5f);
    var toward_3 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[_S248].voxel_0)) + _S250 - _S249.point_0;
    var aside_0 : vec3<f32> = abs(toward_3);
    var in_front_0 : vec3<f32> = aside_0 - _S250;
    var squares_0 : vec3<f32> = aside_0 * aside_0;
    var height_2 : vec3<f32> = abs(_S249.normal_0) * _S250;
    var _S251 : vec3<f32> = vec3<f32>(0.0f);
    var is_upper_0 : vec3<bool> = toward_3 < _S251;
    var above_3 : vec3<f32> = vec3<f32>(with_slack_0(_S249, dot_product_0(toward_3, _S249.normal_0))) + select((vec3<f32>(0) - _S249.normal_0), _S249.normal_0, is_upper_0) * _S250 + (vec3<f32>((height_2.x + height_2.y + height_2.z)) - height_2);
    var _S252 : f32 = squares_0.y;
    var _S253 : f32 = squares_0.z;
    var _S254 : f32 = squares_0.x;
    var distance_squared_0 : vec3<f32> = max(in_front_0 * in_front_0 + vec3<f32>(_S252 + _S253, _S253 + _S254, _S254 + _S252), vec3<f32>(0.5f));
    var falloff_3 : vec3<f32> = vec3<f32>(reciprocal_guess_0(distance_squared_0.x), reciprocal_guess_0(distance_squared_0.y), reciprocal_guess_0(distance_squared_0.z));
    return select(vec3<f32>(0.0f), vec3<f32>(emitters_0[_S248].luminance_0) * in_front_0 * min(above_3, vec3<f32>(length_bound_0(aside_0))) * (falloff_3 * falloff_3), select(vec3<bool>(false), above_3 > _S251, select(vec3<bool>(false), in_front_0 > _S251, ((((vec3<u32>((emitters_0[_S248].faces_0)) >> (select(vec3<u32>(u32(0), u32(2), u32(4)), vec3<u32>(u32(1), u32(3), u32(5)), is_upper_0)))) & (vec3<u32>(u32(1))))) != vec3<u32>(u32(0)))));
}

fn choose_face_0( leaf_1 : Descent_0,  receiver_13 : Receiver_0,  threshold_2 : f32) -> FaceChoice_0
{
    var _S255 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), u32(0), 0.0f);
    var is_found_0 : bool = false;
    var chosen_2 : FaceChoice_0 = _S255;
    var index_9 : u32 = leaf_1.index_1;
    var passed_0 : f32 = 0.0f;
    for(;;)
    {
        var _S256 : bool;
        if(index_9 < (leaf_1.index_1 + leaf_1.count_2))
        {
            _S256 = !is_found_0;
        }
        else
        {
            _S256 = false;
        }
        if(_S256)
        {
        }
        else
        {
            break;
        }
        var _S257 : vec3<f32> = face_importances_0(index_9, receiver_13);
        var sum_3 : f32 = sum_of_0(_S257);
        if(sum_3 > 0.0f)
        {
            var axis_6 : u32 = choose_axis_0(_S257, threshold_2 - passed_0);
            var _S258 : FaceChoice_0 = FaceChoice_x24init_0(index_9, axis_6, component_0(_S257, axis_6));
            var passed_1 : f32 = passed_0 + sum_3;
            is_found_0 = threshold_2 < passed_1;
            chosen_2 = _S258;
            passed_0 = passed_1;
        }
        index_9 = index_9 + u32(1);
    }
    return chosen_2;
}

fn point_of_face_0( low_13 : vec3<f32>,  face_7 : u32,  u_6 : f32,  v_4 : f32) -> vec3<f32>
{
    var away_2 : f32;
    if(((face_7 & (u32(1)))) == u32(1))
    {
        away_2 = 1.0f;
    }
    else
    {
        away_2 = 0.0f;
    }
    if(face_7 < u32(2))
    {
        return low_13 + vec3<f32>(away_2, u_6, v_4);
    }
    if(face_7 < u32(4))
    {
        return low_13 + vec3<f32>(u_6, away_2, v_4);
    }
    return low_13 + vec3<f32>(u_6, v_4, away_2);
}

fn density_0( leaf_2 : Descent_0,  importance_2 : f32,  sum_4 : f32,  toward_4 : vec3<f32>,  face_8 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_4, (face_8 >> (u32(1))));
    var in_front_1 : f32;
    if(((face_8 & (u32(1)))) == u32(1))
    {
        in_front_1 = - along_0;
    }
    else
    {
        in_front_1 = along_0;
    }
    var distance_squared_1 : f32 = length_squared_0(toward_4);
    var unit_2 : f32 = inverse_power_of_two_0(sum_4);
    var share_0 : f32 = leaf_2.weight_0 * (importance_2 * unit_2) * (distance_squared_1 * square_root_0(distance_squared_1));
    if(in_front_1 > 0.0f)
    {
        in_front_1 = divide_0(share_0, leaf_2.total_0 * (sum_4 * unit_2) * in_front_1);
    }
    else
    {
        in_front_1 = -1.0f;
    }
    return in_front_1;
}

fn is_without_surface_0( _S259 : u32) -> bool
{
    var _S260 : bool;
    if((materials_0[_S259].transmission_0) >= 1.0f)
    {
        _S260 = (materials_0[_S259].ior_0) == 1.0f;
    }
    else
    {
        _S260 = false;
    }
    if(_S260)
    {
        _S260 = (materials_0[_S259].metallic_0) <= 0.0f;
    }
    else
    {
        _S260 = false;
    }
    return _S260;
}

fn emitted_0( _S261 : u32) -> vec3<f32>
{
    if(is_without_surface_0(_S261))
    {
        return vec3<f32>(0.0f);
    }
    return vector_of_0(materials_0[_S261].emission_0) * vec3<f32>(params_0.emitter_intensity_0);
}

fn sample_emitter_0( receiver_14 : Receiver_0,  u_7 : vec4<f32>,  aim_2 : Aim_0,  sample_5 : ptr<function, LightSample_0>) -> bool
{
    (*sample_5) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_7.x);
    Descent_at_1(&(descent_3), u32(0));
    var _S262 : bool;
    if(!IS_SINGLE_0)
    {
        _S262 = aim_2.is_met_0;
    }
    else
    {
        _S262 = false;
    }
    if(_S262)
    {
        var leaf_3 : u32 = instances_0[aim_2.hit_0.instance_0].light_leaf_0;
        if((instances_0[aim_2.hit_0.instance_0].light_leaf_0) == u32(4294967295))
        {
            _S262 = true;
        }
        else
        {
            var _S263 : bool = climb_0(receiver_14, leaf_3, &(descent_3));
            _S262 = !_S263;
        }
        if(_S262)
        {
            return false;
        }
        Descent_at_1(&(descent_3), leaf_3);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S264 : bool = descend_1(receiver_14, by_chance_0(), &(descent_3));
            _S262 = !_S264;
        }
        else
        {
            _S262 = false;
        }
        if(_S262)
        {
            return false;
        }
    }
    var chosen_instance_0 : u32 = descent_3.index_1;
    var local_3 : Receiver_0 = in_grid_3(descent_3.index_1, receiver_14);
    Descent_at_0(&(descent_3), top_light_nodes_0[descent_3.node_0].root_0);
    var _S265 : bool = descend_0(local_3, aim_2, &(descent_3));
    if(!_S265)
    {
        return false;
    }
    var chosen_3 : FaceChoice_0 = FaceChoice_x24init_0(u32(0), ((aim_2.hit_0.face_0) >> (u32(1))), 0.0f);
    var index_10 : u32 = descent_3.index_1;
    var sum_5 : f32 = 0.0f;
    for(;;)
    {
        if(index_10 < (descent_3.index_1 + descent_3.count_2))
        {
        }
        else
        {
            break;
        }
        var _S266 : vec3<f32> = face_importances_0(index_10, local_3);
        var sum_6 : f32 = sum_5 + sum_of_0(_S266);
        if(aim_2.is_met_0)
        {
            _S262 = (all(((cell_of_0(emitters_0[index_10].voxel_0)) == (aim_2.hit_0.voxel_1))));
        }
        else
        {
            _S262 = false;
        }
        if(_S262)
        {
            chosen_3 = FaceChoice_x24init_0(index_10, chosen_3.axis_3, component_0(_S266, chosen_3.axis_3));
        }
        index_10 = index_10 + u32(1);
        sum_5 = sum_6;
    }
    if(!aim_2.is_met_0)
    {
        chosen_3 = choose_face_0(descent_3, local_3, u_7.y * sum_5);
    }
    var _S267 : FaceChoice_0 = chosen_3;
    if((chosen_3.importance_0) <= 0.0f)
    {
        return false;
    }
    var _S268 : vec3<f32> = vec3<f32>(cell_of_0(emitters_0[chosen_3.emitter_0].voxel_0));
    var face_9 : u32 = u32(2) * chosen_3.axis_3 + u32((component_0(_S268, chosen_3.axis_3) + 0.5f) < (component_0(local_3.point_0, chosen_3.axis_3)));
    var on_face_0 : vec3<f32> = point_of_face_0(_S268, face_9, u_7.z, u_7.w);
    var _S269 : vec3<f32> = on_face_0 - local_3.point_0;
    var toward_5 : vec3<f32>;
    if(aim_2.is_met_0)
    {
        toward_5 = Transform_direction_1(chosen_instance_0, aim_2.direction_0) * vec3<f32>(aim_2.hit_0.t_0);
    }
    else
    {
        toward_5 = _S269;
    }
    var pdf_6 : f32 = density_0(descent_3, _S267.importance_0, sum_5, toward_5, face_9);
    (*sample_5).pdf_1 = pdf_6;
    if(aim_2.is_met_0)
    {
        if(pdf_6 > 0.0f)
        {
            _S262 = face_9 == (aim_2.hit_0.face_0);
        }
        else
        {
            _S262 = false;
        }
        return _S262;
    }
    if(pdf_6 < 0.0f)
    {
        return false;
    }
    var direction_12 : vec3<f32> = Transform_point_2(chosen_instance_0, offset_ray_origin_0(vector_of_0(instances_0[chosen_instance_0].grid_from_world_0.translation_0), _S268, face_9, on_face_0)) - receiver_14.point_0;
    var cos_theta_8 : f32 = with_slack_0(receiver_14, divide_0(dot_product_0(receiver_14.normal_0, direction_12), square_root_0(length_squared_0(direction_12))));
    (*sample_5) = LightSample_x24init_0(Ray_x24init_0(receiver_14.point_0, 0.0f, direction_12, 1.0f), cos_theta_8, emitted_0(emitters_0[chosen_3.emitter_0].material_0), pdf_6);
    return cos_theta_8 > 0.0f;
}

fn EmitterTree_sample_0( receiver_15 : Receiver_0,  u_8 : vec4<f32>,  aim_3 : Aim_0,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var _S270 : bool = sample_emitter_0(receiver_15, u_8, aim_3, &((*sample_6)));
    return _S270;
}

fn Lights_sample_0( receiver_16 : Receiver_0,  u_9 : vec4<f32>,  aim_4 : Aim_0,  sample_7 : ptr<function, LightSample_0>) -> bool
{
    var selection_0 : Selection_0 = Lights_selection_0(receiver_16);
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
        is_found_1 = (u_9.x) < (selection_0.sun_0);
    }
    else
    {
        is_found_1 = false;
    }
    if(is_found_1)
    {
        var _S271 : bool = SunDisc_sample_0(receiver_16, u_9, &((*sample_7)));
        (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.sun_0;
        is_found_1 = _S271;
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
            is_found_1 = (u_9.x) < (selection_0.sun_0 + selection_0.sky_1);
        }
        else
        {
            is_found_1 = false;
        }
        if(is_found_1)
        {
            var _S272 : bool = Sky_sample_0(receiver_16, vec4<f32>(min(divide_0(u_9.x - selection_0.sun_0, selection_0.sky_1), 0.99999994039535522f), u_9.yzw), &((*sample_7)));
            (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.sky_1;
            is_found_1 = _S272;
        }
        else
        {
            var _S273 : bool = EmitterTree_sample_0(receiver_16, vec4<f32>(min(divide_0(u_9.x - (selection_0.sun_0 + selection_0.sky_1), selection_0.emitters_1), 0.99999994039535522f), u_9.yzw), aim_4, &((*sample_7)));
            (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.emitters_1;
            is_found_1 = _S273;
        }
    }
    return is_found_1;
}

fn SunDisc_contains_0( direction_13 : vec3<f32>) -> bool
{
    return (length_squared_0(direction_13 - params_0.sun_direction_0)) <= (2.0f * params_0.sun_one_minus_cos_theta_max_0);
}

fn SunDisc_pdf_0( direction_14 : vec3<f32>) -> f32
{
    var _S274 : f32;
    if(SunDisc_contains_0(direction_14))
    {
        _S274 = params_0.sun_pdf_0;
    }
    else
    {
        _S274 = 0.0f;
    }
    return _S274;
}

fn Lights_sun_pdf_0( receiver_17 : Receiver_0,  direction_15 : vec3<f32>) -> f32
{
    var _S275 : f32;
    if(has_sun_0())
    {
        _S275 = SunDisc_pdf_0(direction_15) * Lights_selection_0(receiver_17).sun_0;
    }
    else
    {
        _S275 = 0.0f;
    }
    return _S275;
}

fn Hit_is_miss_0( this_26 : Hit_0) -> bool
{
    return (this_26.instance_0) == u32(4294967295);
}

@compute
@workgroup_size(64, 1, 1)
fn check_light(@builtin(global_invocation_id) id_9 : vec3<u32>, @builtin(local_invocation_index) thread_10 : u32)
{
    prove_0(thread_10);
    var _S276 : u32 = id_9.x;
    if(_S276 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_9 : Reader_0 = Reader_x24init_0(u32(24) * _S276);
    var writer_9 : Writer_0 = Writer_x24init_0(u32(12) * _S276);
    var point_6 : vec3<f32> = Reader_vector_0(&(reader_9));
    var _S277 : vec3<f32> = Reader_vector_0(&(reader_9));
    var receiver_18 : Receiver_0 = Receiver_x24init_0(point_6, _S277);
    var u_10 : vec3<f32> = Reader_vector_0(&(reader_9));
    var _S278 : f32 = Reader_number_0(&(reader_9));
    var sample_8 : LightSample_0;
    var is_found_2 : bool = Lights_sample_0(receiver_18, vec4<f32>(u_10, _S278), by_chance_0(), &(sample_8));
    if(!is_found_2)
    {
        sample_8 = no_light_0();
    }
    var ray_9 : Ray_0 = Reader_ray_0(&(reader_9));
    var hit_8 : Hit_0 = Reader_hit_0(&(reader_9));
    Writer_word_0(&(writer_9), u32(is_found_2));
    Writer_vector_0(&(writer_9), sample_8.ray_7.direction_1);
    Writer_number_0(&(writer_9), sample_8.ray_7.t_max_0);
    Writer_number_0(&(writer_9), sample_8.cos_theta_4);
    Writer_vector_0(&(writer_9), sample_8.radiance_3);
    Writer_number_0(&(writer_9), sample_8.pdf_1);
    Writer_number_0(&(writer_9), Lights_sun_pdf_0(receiver_18, sample_8.ray_7.direction_1));
    var met_0 : LightSample_0;
    var aim_5 : Aim_0 = Aim_x24init_0(true, ray_9.direction_1, hit_8);
    var is_met_2 : bool;
    if(!Hit_is_miss_0(hit_8))
    {
        var _S279 : bool = Lights_sample_0(receiver_18, vec4<f32>(0.0f), aim_5, &(met_0));
        is_met_2 = _S279;
    }
    else
    {
        is_met_2 = false;
    }
    var _S280 : f32;
    if(is_met_2)
    {
        _S280 = met_0.pdf_1;
    }
    else
    {
        _S280 = 0.0f;
    }
    Writer_number_0(&(writer_9), _S280);
    return;
}

fn SunDisc_le_0( direction_16 : vec3<f32>) -> vec3<f32>
{
    var _S281 : vec3<f32>;
    if(SunDisc_contains_0(direction_16))
    {
        _S281 = params_0.sun_radiance_0;
    }
    else
    {
        _S281 = vec3<f32>(0.0f);
    }
    return _S281;
}

fn Environment_to_map_0( d_1 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S282 : f32 = d_1.x;
    var _S283 : f32 = d_1.y;
    return vec3<f32>(_S282 * cos_3 - _S283 * sin_2, _S282 * sin_2 + _S283 * cos_3, d_1.z);
}

fn quarter_turns_0( x_15 : f32,  y_12 : f32) -> f32
{
    var _S284 : f32 = min(x_15, y_12);
    var _S285 : f32 = max(x_15, y_12);
    var ratio_0 : f32;
    if(_S285 > 0.0f)
    {
        ratio_0 = divide_0(_S284, _S285);
    }
    else
    {
        ratio_0 = 0.0f;
    }
    var s_0 : f32 = ratio_0 * ratio_0;
    var turns_2 : f32 = ratio_0 * (0.63661932945251465f + s_0 * (-0.21218447387218475f + s_0 * (0.12698377668857574f + s_0 * (-0.08854507654905319f + s_0 * (0.06138415634632111f + s_0 * (-0.03559486567974091f + s_0 * (0.01391837373375893f + s_0 * -0.00258121290244162f)))))));
    if(y_12 > x_15)
    {
        ratio_0 = 1.0f - turns_2;
    }
    else
    {
        ratio_0 = turns_2;
    }
    return ratio_0;
}

fn square_of_0( direction_17 : vec3<f32>) -> vec2<f32>
{
    var size_0 : vec3<f32> = abs(direction_17);
    var _S286 : f32 = size_0.x;
    var _S287 : f32 = size_0.y;
    var radius_3 : f32 = square_root_0(divide_0(_S286 * _S286 + _S287 * _S287, 1.0f + size_0.z));
    var v_5 : f32 = quarter_turns_0(_S286, _S287) * radius_3;
    var u_11 : f32 = radius_3 - v_5;
    var is_below_1 : bool = (direction_17.z) < 0.0f;
    var u_12 : f32;
    if(is_below_1)
    {
        u_12 = 1.0f - v_5;
    }
    else
    {
        u_12 = u_11;
    }
    var v_6 : f32;
    if(is_below_1)
    {
        v_6 = 1.0f - u_11;
    }
    else
    {
        v_6 = v_5;
    }
    if((direction_17.x) < 0.0f)
    {
        u_12 = - u_12;
    }
    if((direction_17.y) < 0.0f)
    {
        v_6 = - v_6;
    }
    return vec2<f32>(u_12 * 0.5f + 0.5f, v_6 * 0.5f + 0.5f);
}

fn Environment_place_of_0( direction_18 : vec3<f32>) -> vec2<f32>
{
    return square_of_0(Environment_to_map_0(direction_18)) * vec2<f32>(f32(params_0.sky_edge_0));
}

fn Environment_radiance_0( direction_19 : vec3<f32>) -> vec3<f32>
{
    return Environment_radiance_at_0(Environment_place_of_0(direction_19));
}

struct Gradient_0
{
     nadir_0 : vec3<f32>,
     zenith_0 : vec3<f32>,
};

fn Gradient_x24init_0( nadir_1 : vec3<f32>,  zenith_1 : vec3<f32>) -> Gradient_0
{
    var _S288 : Gradient_0;
    _S288.nadir_0 = nadir_1;
    _S288.zenith_0 = zenith_1;
    return _S288;
}

fn Gradient_radiance_0( this_27 : Gradient_0,  direction_20 : vec3<f32>) -> vec3<f32>
{
    return this_27.nadir_0 + (this_27.zenith_0 - this_27.nadir_0) * vec3<f32>((0.5f * (direction_20.z + 1.0f)));
}

fn Sky_radiance_0( direction_21 : vec3<f32>) -> vec3<f32>
{
    if(SKY_0 == u32(1))
    {
        return Environment_radiance_0(direction_21) * vec3<f32>(params_0.sky_brightness_0);
    }
    return Gradient_radiance_0(Gradient_x24init_0(params_0.sky_nadir_0, params_0.sky_zenith_0), direction_21) * vec3<f32>(params_0.sky_brightness_0);
}

fn Sky_le_0( direction_22 : vec3<f32>) -> vec3<f32>
{
    return Sky_radiance_0(direction_22);
}

fn Environment_pdf_0( direction_23 : vec3<f32>) -> f32
{
    var place_2 : vec2<f32> = Environment_place_of_0(direction_23);
    var last_2 : i32 = i32(params_0.sky_edge_0) - i32(1);
    return environment_0[Environment_index_of_0(min(i32(place_2.x), last_2), min(i32(place_2.y), last_2))].pdf_0;
}

fn Sky_pdf_0( direction_24 : vec3<f32>) -> f32
{
    var _S289 : f32;
    if(SKY_0 == u32(1))
    {
        _S289 = Environment_pdf_0(direction_24);
    }
    else
    {
        _S289 = 0.0f;
    }
    return _S289;
}

fn Lights_sky_pdf_0( receiver_19 : Receiver_0,  direction_25 : vec3<f32>) -> f32
{
    var _S290 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S290 = Sky_pdf_0(direction_25) * Lights_selection_0(receiver_19).sky_1;
    }
    else
    {
        _S290 = 0.0f;
    }
    return _S290;
}

@compute
@workgroup_size(64, 1, 1)
fn check_distant_light(@builtin(global_invocation_id) id_10 : vec3<u32>, @builtin(local_invocation_index) thread_11 : u32)
{
    prove_0(thread_11);
    var _S291 : u32 = id_10.x;
    if(_S291 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_10 : Reader_0 = Reader_x24init_0(u32(13) * _S291);
    var writer_10 : Writer_0 = Writer_x24init_0(u32(22) * _S291);
    var point_7 : vec3<f32> = Reader_vector_0(&(reader_10));
    var _S292 : vec3<f32> = Reader_vector_0(&(reader_10));
    var receiver_20 : Receiver_0 = Receiver_x24init_0(point_7, _S292);
    var u_13 : vec3<f32> = Reader_vector_0(&(reader_10));
    var _S293 : f32 = Reader_number_0(&(reader_10));
    var place_3 : vec4<f32> = vec4<f32>(u_13, _S293);
    var sample_9 : LightSample_0;
    var is_found_3 : bool = SunDisc_sample_0(receiver_20, place_3, &(sample_9));
    var of_sky_0 : LightSample_0;
    var is_found_in_sky_0 : bool = Sky_sample_0(receiver_20, place_3, &(of_sky_0));
    var direction_26 : vec3<f32> = Reader_vector_0(&(reader_10));
    Writer_word_0(&(writer_10), u32(is_found_3));
    var _S294 : vec3<f32>;
    if(is_found_3)
    {
        _S294 = sample_9.ray_7.direction_1;
    }
    else
    {
        _S294 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S294);
    Writer_vector_0(&(writer_10), SunDisc_le_0(direction_26));
    Writer_number_0(&(writer_10), SunDisc_pdf_0(direction_26));
    Writer_vector_0(&(writer_10), Sky_le_0(direction_26));
    Writer_number_0(&(writer_10), Sky_pdf_0(direction_26));
    Writer_number_0(&(writer_10), Lights_sun_pdf_0(receiver_20, direction_26));
    Writer_number_0(&(writer_10), Lights_sky_pdf_0(receiver_20, direction_26));
    Writer_word_0(&(writer_10), u32(is_found_in_sky_0));
    if(is_found_in_sky_0)
    {
        _S294 = of_sky_0.ray_7.direction_1;
    }
    else
    {
        _S294 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S294);
    if(is_found_in_sky_0)
    {
        _S294 = of_sky_0.radiance_3;
    }
    else
    {
        _S294 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S294);
    var _S295 : f32;
    if(is_found_in_sky_0)
    {
        _S295 = of_sky_0.pdf_1;
    }
    else
    {
        _S295 = 0.0f;
    }
    Writer_number_0(&(writer_10), _S295);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_equal_area(@builtin(global_invocation_id) id_11 : vec3<u32>, @builtin(local_invocation_index) thread_12 : u32)
{
    prove_0(thread_12);
    var _S296 : u32 = id_11.x;
    if(_S296 >= (dispatch_0.count_0))
    {
        return;
    }
    var _S297 : u32 = u32(5) * _S296;
    var reader_11 : Reader_0 = Reader_x24init_0(_S297);
    var writer_11 : Writer_0 = Writer_x24init_0(_S297);
    var _S298 : vec3<f32> = Reader_vector_0(&(reader_11));
    var square_1 : vec2<f32> = square_of_0(_S298);
    Writer_number_0(&(writer_11), square_1.x);
    Writer_number_0(&(writer_11), square_1.y);
    var x_16 : f32 = Reader_number_0(&(reader_11));
    var _S299 : f32 = Reader_number_0(&(reader_11));
    Writer_vector_0(&(writer_11), direction_of_0(vec2<f32>(x_16, _S299)));
    return;
}

struct Microfacets_0
{
     alpha_0 : f32,
};

fn Microfacets_x24init_0( alpha_1 : f32) -> Microfacets_0
{
    var _S300 : Microfacets_0;
    _S300.alpha_0 = alpha_1;
    return _S300;
}

struct MaterialBsdf_0
{
     kind_0 : u32,
     color_1 : vec3<f32>,
     specular_1 : f32,
     eta_0 : f32,
     facets_0 : Microfacets_0,
};

fn MaterialBsdf_x24init_0( kind_1 : u32,  color_2 : vec3<f32>,  specular_2 : f32,  eta_1 : f32,  facets_1 : Microfacets_0) -> MaterialBsdf_0
{
    var _S301 : MaterialBsdf_0;
    _S301.kind_0 = kind_1;
    _S301.color_1 = color_2;
    _S301.specular_1 = specular_2;
    _S301.eta_0 = eta_1;
    _S301.facets_0 = facets_1;
    return _S301;
}

fn facets_of_0( roughness_1 : f32) -> Microfacets_0
{
    return Microfacets_x24init_0(roughness_1 * roughness_1);
}

fn chooses_0( share_1 : f32,  choice_2 : ptr<function, f32>) -> bool
{
    if(share_1 <= 0.0f)
    {
        return false;
    }
    var is_chosen_0 : bool = (*choice_2) < share_1;
    var _S302 : f32;
    if(is_chosen_0)
    {
        _S302 = divide_0((*choice_2), share_1);
    }
    else
    {
        _S302 = divide_0((*choice_2) - share_1, 1.0f - share_1);
    }
    (*choice_2) = _S302;
    return is_chosen_0;
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

fn bsdf_of_0( material_1 : PackedMaterial_0,  ior_1 : f32,  choice_3 : ptr<function, f32>) -> MaterialBsdf_0
{
    var color_3 : vec3<f32> = vector_of_0(material_1.base_color_0);
    var facets_2 : Microfacets_0 = facets_of_0(material_1.roughness_0);
    var _S303 : bool = chooses_0(material_1.metallic_0, &((*choice_3)));
    if(_S303)
    {
        return MaterialBsdf_x24init_0(u32(1), color_3, 0.0f, 1.0f, facets_2);
    }
    var _S304 : bool = chooses_0(material_1.transmission_0, &((*choice_3)));
    if(_S304)
    {
        return MaterialBsdf_x24init_0(u32(3), color_3, 0.0f, divide_0(material_1.ior_0, ior_1), facets_2);
    }
    if((material_1.specular_0) > 0.0f)
    {
        return MaterialBsdf_x24init_0(u32(2), color_3, material_1.specular_0, divide_0(material_1.ior_0, ior_1), facets_2);
    }
    return MaterialBsdf_x24init_0(u32(0), color_3, 0.0f, 1.0f, facets_2);
}

struct Conductor_0
{
     f0_0 : vec3<f32>,
     facets_3 : Microfacets_0,
};

fn Conductor_x24init_0( f0_1 : vec3<f32>,  facets_4 : Microfacets_0) -> Conductor_0
{
    var _S305 : Conductor_0;
    _S305.f0_0 = f0_1;
    _S305.facets_3 = facets_4;
    return _S305;
}

fn above_4( wo_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(wo_0.x, wo_0.y, max(wo_0.z, 0.00009999999747379f));
}

fn Microfacets_is_smooth_0( this_28 : Microfacets_0) -> bool
{
    return (this_28.alpha_0) < 0.00999999977648258f;
}

fn fresnel_schlick_0( cos_i_0 : f32,  f0_2 : vec3<f32>) -> vec3<f32>
{
    var rest_3 : f32 = 1.0f - cos_i_0;
    var squared_0 : f32 = rest_3 * rest_3;
    return f0_2 + (vec3<f32>(1.0f) - f0_2) * vec3<f32>((squared_0 * squared_0 * rest_3));
}

struct BsdfSample_0
{
     wi_0 : vec3<f32>,
     weight_3 : vec3<f32>,
     pdf_7 : f32,
     is_delta_0 : bool,
};

fn BsdfSample_x24init_0( wi_1 : vec3<f32>,  weight_4 : vec3<f32>,  pdf_8 : f32,  is_delta_1 : bool) -> BsdfSample_0
{
    var _S306 : BsdfSample_0;
    _S306.wi_0 = wi_1;
    _S306.weight_3 = weight_4;
    _S306.pdf_7 = pdf_8;
    _S306.is_delta_0 = is_delta_1;
    return _S306;
}

fn Microfacets_sample_visible_0( this_29 : Microfacets_0,  wo_1 : vec3<f32>,  u_14 : f32,  v_7 : f32) -> vec3<f32>
{
    var stretched_0 : vec3<f32> = normalize_vector_0(vec3<f32>(this_29.alpha_0 * wo_1.x, this_29.alpha_0 * wo_1.y, wo_1.z));
    var sin_cos_4 : vec2<f32> = sincos_turns_0(u_14);
    var _S307 : f32 = stretched_0.z;
    var z_3 : f32 = (1.0f - v_7) * (1.0f + _S307) - _S307;
    var radius_4 : f32 = square_root_0(max(1.0f - z_3 * z_3, 0.0f));
    var normal_5 : vec3<f32> = vec3<f32>(radius_4 * sin_cos_4.y, radius_4 * sin_cos_4.x, z_3) + stretched_0;
    return normalize_vector_0(vec3<f32>(this_29.alpha_0 * normal_5.x, this_29.alpha_0 * normal_5.y, max(normal_5.z, 1.00000001168609742e-07f)));
}

fn reflect_by_0( wo_2 : vec3<f32>,  wm_0 : vec3<f32>) -> vec3<f32>
{
    return wm_0 * vec3<f32>((2.0f * dot_product_0(wo_2, wm_0))) - wo_2;
}

fn no_bsdf_sample_0() -> BsdfSample_0
{
    return BsdfSample_x24init_0(vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(0.0f), 0.0f, false);
}

fn Microfacets_masking_0( this_30 : Microfacets_0,  cos_4 : f32) -> f32
{
    var _S308 : f32 = this_30.alpha_0;
    var alpha_squared_0 : f32 = _S308 * _S308;
    return square_root_0(alpha_squared_0 + (1.0f - alpha_squared_0) * (cos_4 * cos_4));
}

fn Microfacets_shadowing_0( this_31 : Microfacets_0,  cos_o_0 : f32,  cos_i_1 : f32) -> f32
{
    var of_o_0 : f32 = Microfacets_masking_0(this_31, cos_o_0);
    return divide_0(cos_i_1 * (cos_o_0 + of_o_0), cos_i_1 * of_o_0 + cos_o_0 * Microfacets_masking_0(this_31, cos_i_1));
}

fn Microfacets_distribution_0( this_32 : Microfacets_0,  wm_1 : vec3<f32>) -> f32
{
    var _S309 : f32 = this_32.alpha_0;
    var alpha_squared_1 : f32 = _S309 * _S309;
    var _S310 : f32 = wm_1.z;
    var _S311 : f32 = wm_1.x;
    var _S312 : f32 = wm_1.y;
    var base_0 : f32 = alpha_squared_1 * (_S310 * _S310) + (_S311 * _S311 + _S312 * _S312);
    return divide_0(alpha_squared_1, 3.14159274101257324f * (base_0 * base_0));
}

fn Microfacets_visible_pdf_0( this_33 : Microfacets_0,  wo_3 : vec3<f32>,  wm_2 : vec3<f32>) -> f32
{
    var _S313 : f32 = wo_3.z;
    return divide_0(2.0f * max(dot_product_0(wo_3, wm_2), 0.0f) * Microfacets_distribution_0(this_33, wm_2), _S313 + Microfacets_masking_0(this_33, _S313));
}

fn Conductor_sample_0( this_34 : Conductor_0,  given_0 : vec3<f32>,  u_15 : vec3<f32>,  sample_10 : ptr<function, BsdfSample_0>) -> bool
{
    var wo_4 : vec3<f32> = above_4(given_0);
    if(Microfacets_is_smooth_0(this_34.facets_3))
    {
        var _S314 : f32 = wo_4.z;
        (*sample_10) = BsdfSample_x24init_0(vec3<f32>(- wo_4.x, - wo_4.y, _S314), fresnel_schlick_0(_S314, this_34.f0_0), 1.0f, true);
        return true;
    }
    var wm_3 : vec3<f32> = Microfacets_sample_visible_0(this_34.facets_3, wo_4, u_15.x, u_15.y);
    var wi_2 : vec3<f32> = reflect_by_0(wo_4, wm_3);
    var _S315 : f32 = wi_2.z;
    if(_S315 <= 0.0f)
    {
        (*sample_10) = no_bsdf_sample_0();
        return false;
    }
    var cos_5 : f32 = dot_product_0(wo_4, wm_3);
    (*sample_10) = BsdfSample_x24init_0(wi_2, fresnel_schlick_0(cos_5, this_34.f0_0) * vec3<f32>(Microfacets_shadowing_0(this_34.facets_3, wo_4.z, _S315)), divide_0(Microfacets_visible_pdf_0(this_34.facets_3, wo_4, wm_3), 4.0f * cos_5), false);
    return true;
}

struct Plastic_0
{
     reflectance_0 : vec3<f32>,
     specular_3 : f32,
     eta_2 : f32,
     facets_5 : Microfacets_0,
};

fn Plastic_x24init_0( reflectance_1 : vec3<f32>,  specular_4 : f32,  eta_3 : f32,  facets_6 : Microfacets_0) -> Plastic_0
{
    var _S316 : Plastic_0;
    _S316.reflectance_0 = reflectance_1;
    _S316.specular_3 = specular_4;
    _S316.eta_2 = eta_3;
    _S316.facets_5 = facets_6;
    return _S316;
}

fn refracted_cosine_0( cos_i_2 : f32,  eta_4 : f32) -> f32
{
    var squared_1 : f32 = 1.0f - divide_0(1.0f - cos_i_2 * cos_i_2, eta_4 * eta_4);
    var _S317 : f32;
    if(squared_1 > 0.0f)
    {
        _S317 = square_root_0(squared_1);
    }
    else
    {
        _S317 = -1.0f;
    }
    return _S317;
}

fn fresnel_dielectric_0( cos_i_3 : f32,  eta_5 : f32) -> f32
{
    var cos_t_0 : f32 = refracted_cosine_0(cos_i_3, eta_5);
    if(cos_t_0 < 0.0f)
    {
        return 1.0f;
    }
    var _S318 : f32 = eta_5 * cos_i_3;
    var parallel_0 : f32 = divide_0(_S318 - cos_t_0, _S318 + cos_t_0);
    var _S319 : f32 = eta_5 * cos_t_0;
    var perpendicular_0 : f32 = divide_0(cos_i_3 - _S319, cos_i_3 + _S319);
    return (parallel_0 * parallel_0 + perpendicular_0 * perpendicular_0) * 0.5f;
}

fn Plastic_coat_0( this_35 : Plastic_0,  cos_6 : f32) -> f32
{
    return this_35.specular_3 * fresnel_dielectric_0(cos_6, this_35.eta_2);
}

fn Plastic_coat_probability_0( this_36 : Plastic_0,  coat_0 : f32) -> f32
{
    var below_0 : f32 = (1.0f - coat_0) * max_element_0(this_36.reflectance_0);
    var _S320 : f32;
    if(coat_0 <= 0.0f)
    {
        _S320 = 0.0f;
    }
    else
    {
        _S320 = divide_0(coat_0, coat_0 + below_0);
    }
    return _S320;
}

struct BsdfEval_0
{
     weight_5 : vec3<f32>,
     pdf_9 : f32,
};

fn BsdfEval_x24init_0( weight_6 : vec3<f32>,  pdf_10 : f32) -> BsdfEval_0
{
    var _S321 : BsdfEval_0;
    _S321.weight_5 = weight_6;
    _S321.pdf_9 = pdf_10;
    return _S321;
}

fn no_bsdf_eval_0() -> BsdfEval_0
{
    return BsdfEval_x24init_0(vec3<f32>(0.0f), 0.0f);
}

fn Plastic_eval_lobes_0( this_37 : Plastic_0,  wo_5 : vec3<f32>,  wi_3 : vec3<f32>,  coat_1 : f32,  coat_probability_0 : f32) -> BsdfEval_0
{
    var _S322 : f32 = wi_3.z;
    var diffuse_pdf_0 : f32 = cosine_hemisphere_pdf_0(_S322);
    var pdf_11 : f32 = (1.0f - coat_probability_0) * diffuse_pdf_0;
    var scattered_0 : vec3<f32> = this_37.reflectance_0 * vec3<f32>(((1.0f - coat_1) * (1.0f - Plastic_coat_0(this_37, _S322)) * diffuse_pdf_0));
    var pdf_12 : f32;
    var scattered_1 : vec3<f32>;
    if(!Microfacets_is_smooth_0(this_37.facets_5))
    {
        var wm_4 : vec3<f32> = normalize_vector_0(wo_5 + wi_3);
        var cos_7 : f32 = dot_product_0(wo_5, wm_4);
        var facet_pdf_0 : f32 = divide_0(Microfacets_visible_pdf_0(this_37.facets_5, wo_5, wm_4), 4.0f * cos_7);
        var scattered_2 : vec3<f32> = scattered_0 + vec3<f32>((Plastic_coat_0(this_37, cos_7) * Microfacets_shadowing_0(this_37.facets_5, wo_5.z, _S322) * facet_pdf_0));
        pdf_12 = pdf_11 + coat_probability_0 * facet_pdf_0;
        scattered_1 = scattered_2;
    }
    else
    {
        pdf_12 = pdf_11;
        scattered_1 = scattered_0;
    }
    if(!(pdf_12 > 0.0f))
    {
        return no_bsdf_eval_0();
    }
    return BsdfEval_x24init_0(scattered_1 * vec3<f32>(divide_0(1.0f, pdf_12)), pdf_12);
}

fn Plastic_sample_0( this_38 : Plastic_0,  given_1 : vec3<f32>,  u_16 : vec3<f32>,  sample_11 : ptr<function, BsdfSample_0>) -> bool
{
    (*sample_11) = no_bsdf_sample_0();
    var wo_6 : vec3<f32> = above_4(given_1);
    var _S323 : f32 = wo_6.z;
    var coat_2 : f32 = Plastic_coat_0(this_38, _S323);
    var coat_probability_1 : f32 = Plastic_coat_probability_0(this_38, coat_2);
    var is_coat_0 : bool = (u_16.z) < coat_probability_1;
    var _S324 : bool;
    if(is_coat_0)
    {
        _S324 = Microfacets_is_smooth_0(this_38.facets_5);
    }
    else
    {
        _S324 = false;
    }
    if(_S324)
    {
        (*sample_11) = BsdfSample_x24init_0(vec3<f32>(- wo_6.x, - wo_6.y, _S323), vec3<f32>(divide_0(coat_2, coat_probability_1)), 1.0f, true);
        return true;
    }
    var wi_4 : vec3<f32>;
    if(is_coat_0)
    {
        wi_4 = reflect_by_0(wo_6, Microfacets_sample_visible_0(this_38.facets_5, wo_6, u_16.x, u_16.y));
    }
    else
    {
        wi_4 = cosine_hemisphere_0(u_16.x, u_16.y);
    }
    if((wi_4.z) <= 0.0f)
    {
        return false;
    }
    var eval_0 : BsdfEval_0 = Plastic_eval_lobes_0(this_38, wo_6, wi_4, coat_2, coat_probability_1);
    (*sample_11) = BsdfSample_x24init_0(wi_4, eval_0.weight_5, eval_0.pdf_9, false);
    return (eval_0.pdf_9) > 0.0f;
}

struct Dielectric_0
{
     eta_6 : f32,
     facets_7 : Microfacets_0,
};

fn Dielectric_x24init_0( eta_7 : f32,  facets_8 : Microfacets_0) -> Dielectric_0
{
    var _S325 : Dielectric_0;
    _S325.eta_6 = eta_7;
    _S325.facets_7 = facets_8;
    return _S325;
}

fn Dielectric_sample_0( this_39 : Dielectric_0,  given_2 : vec3<f32>,  u_17 : vec3<f32>,  sample_12 : ptr<function, BsdfSample_0>) -> bool
{
    (*sample_12) = no_bsdf_sample_0();
    var wo_7 : vec3<f32> = above_4(given_2);
    var is_smooth_0 : bool = Microfacets_is_smooth_0(this_39.facets_7);
    const _S326 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
    var wm_5 : vec3<f32>;
    if(!is_smooth_0)
    {
        wm_5 = Microfacets_sample_visible_0(this_39.facets_7, wo_7, u_17.x, u_17.y);
    }
    else
    {
        wm_5 = _S326;
    }
    var cos_8 : f32 = dot_product_0(wo_7, wm_5);
    var reflectance_2 : f32 = fresnel_dielectric_0(cos_8, this_39.eta_6);
    var is_reflected_0 : bool = (u_17.z) < reflectance_2;
    var wi_5 : vec3<f32>;
    if(is_reflected_0)
    {
        wi_5 = reflect_by_0(wo_7, wm_5);
    }
    else
    {
        var scale_0 : f32 = divide_0(1.0f, this_39.eta_6);
        var cos_t_1 : f32 = refracted_cosine_0(cos_8, this_39.eta_6);
        if(cos_t_1 < 0.0f)
        {
            return false;
        }
        wi_5 = wm_5 * vec3<f32>((cos_8 * scale_0 - cos_t_1)) - wo_7 * vec3<f32>(scale_0);
    }
    if(is_smooth_0)
    {
        (*sample_12) = BsdfSample_x24init_0(wi_5, vec3<f32>(1.0f), 1.0f, true);
        return true;
    }
    var _S327 : f32 = wi_5.z;
    var _S328 : bool;
    if((_S327 > 0.0f) != is_reflected_0)
    {
        _S328 = true;
    }
    else
    {
        _S328 = _S327 == 0.0f;
    }
    if(_S328)
    {
        return false;
    }
    var weight_7 : vec3<f32> = vec3<f32>(Microfacets_shadowing_0(this_39.facets_7, wo_7.z, abs(_S327)));
    var pdf_13 : f32 = divide_0(reflectance_2 * Microfacets_visible_pdf_0(this_39.facets_7, wo_7, wm_5), 4.0f * cos_8);
    var _S329 : f32;
    if(is_reflected_0)
    {
        _S329 = pdf_13;
    }
    else
    {
        _S329 = 1.0f;
    }
    (*sample_12) = BsdfSample_x24init_0(wi_5, weight_7, _S329, !is_reflected_0);
    return true;
}

struct Phase_0
{
     color_4 : vec3<f32>,
     anisotropy_1 : f32,
};

fn Phase_x24init_0( color_5 : vec3<f32>,  anisotropy_2 : f32) -> Phase_0
{
    var _S330 : Phase_0;
    _S330.color_4 = color_5;
    _S330.anisotropy_1 = anisotropy_2;
    return _S330;
}

fn sample_phase_0( anisotropy_3 : f32,  forward_0 : vec3<f32>,  u_18 : f32,  v_8 : f32,  cos_9 : ptr<function, f32>) -> vec3<f32>
{
    if((abs(anisotropy_3)) < 0.00100000004749745f)
    {
        (*cos_9) = 1.0f - 2.0f * u_18;
    }
    else
    {
        var _S331 : f32 = anisotropy_3 * anisotropy_3;
        var _S332 : f32 = 2.0f * anisotropy_3;
        var ratio_1 : f32 = divide_0(1.0f - _S331, 1.0f + anisotropy_3 - _S332 * u_18);
        (*cos_9) = divide_0(1.0f + _S331 - ratio_1 * ratio_1, _S332);
    }
    var _S333 : f32 = clamp((*cos_9), -1.0f, 1.0f);
    (*cos_9) = _S333;
    var radius_5 : f32 = square_root_0(1.0f - _S333 * _S333);
    var sin_cos_5 : vec2<f32> = sincos_turns_0(v_8);
    var x_17 : vec3<f32>;
    var y_13 : vec3<f32>;
    orthonormal_pair_1(forward_0, &(x_17), &(y_13));
    return x_17 * vec3<f32>((radius_5 * sin_cos_5.y)) + y_13 * vec3<f32>((radius_5 * sin_cos_5.x)) + forward_0 * vec3<f32>(_S333);
}

fn phase_pdf_0( anisotropy_4 : f32,  cos_10 : f32) -> f32
{
    var _S334 : f32 = anisotropy_4 * anisotropy_4;
    var base_1 : f32 = 1.0f + _S334 - 2.0f * anisotropy_4 * cos_10;
    return divide_0(1.0f - _S334, 12.56637096405029297f * (base_1 * square_root_0(base_1)));
}

fn Phase_sample_0( this_40 : Phase_0,  wo_8 : vec3<f32>,  u_19 : vec3<f32>,  sample_13 : ptr<function, BsdfSample_0>) -> bool
{
    var cos_11 : f32;
    var wi_6 : vec3<f32> = sample_phase_0(this_40.anisotropy_1, (vec3<f32>(0) - wo_8), u_19.x, u_19.y, &(cos_11));
    (*sample_13) = BsdfSample_x24init_0(wi_6, this_40.color_4, phase_pdf_0(this_40.anisotropy_1, cos_11), false);
    return true;
}

struct Diffuse_0
{
     reflectance_3 : vec3<f32>,
};

fn Diffuse_x24init_0( reflectance_4 : vec3<f32>) -> Diffuse_0
{
    var _S335 : Diffuse_0;
    _S335.reflectance_3 = reflectance_4;
    return _S335;
}

fn Diffuse_sample_0( this_41 : Diffuse_0,  wo_9 : vec3<f32>,  u_20 : vec3<f32>,  sample_14 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_7 : vec3<f32> = cosine_hemisphere_0(u_20.x, u_20.y);
    (*sample_14) = BsdfSample_x24init_0(wi_7, this_41.reflectance_3, cosine_hemisphere_pdf_0(wi_7.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_42 : MaterialBsdf_0,  wo_10 : vec3<f32>,  u_21 : vec3<f32>,  sample_15 : ptr<function, BsdfSample_0>) -> bool
{
    if((this_42.kind_0) == u32(1))
    {
        var _S336 : bool = Conductor_sample_0(Conductor_x24init_0(this_42.color_1, this_42.facets_0), wo_10, u_21, &((*sample_15)));
        return _S336;
    }
    if((this_42.kind_0) == u32(2))
    {
        var _S337 : bool = Plastic_sample_0(Plastic_x24init_0(this_42.color_1, this_42.specular_1, this_42.eta_0, this_42.facets_0), wo_10, u_21, &((*sample_15)));
        return _S337;
    }
    if((this_42.kind_0) == u32(3))
    {
        var _S338 : bool = Dielectric_sample_0(Dielectric_x24init_0(this_42.eta_0, this_42.facets_0), wo_10, u_21, &((*sample_15)));
        return _S338;
    }
    if((this_42.kind_0) == u32(4))
    {
        var _S339 : bool = Phase_sample_0(Phase_x24init_0(this_42.color_1, this_42.specular_1), wo_10, u_21, &((*sample_15)));
        return _S339;
    }
    var _S340 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_42.color_1), wo_10, u_21, &((*sample_15)));
    return _S340;
}

fn Conductor_eval_0( this_43 : Conductor_0,  given_3 : vec3<f32>,  wi_8 : vec3<f32>) -> BsdfEval_0
{
    var _S341 : bool;
    if(Microfacets_is_smooth_0(this_43.facets_3))
    {
        _S341 = true;
    }
    else
    {
        _S341 = (wi_8.z) <= 0.0f;
    }
    if(_S341)
    {
        return no_bsdf_eval_0();
    }
    var wo_11 : vec3<f32> = above_4(given_3);
    var wm_6 : vec3<f32> = normalize_vector_0(wo_11 + wi_8);
    var cos_12 : f32 = dot_product_0(wo_11, wm_6);
    return BsdfEval_x24init_0(fresnel_schlick_0(cos_12, this_43.f0_0) * vec3<f32>(Microfacets_shadowing_0(this_43.facets_3, wo_11.z, wi_8.z)), divide_0(Microfacets_visible_pdf_0(this_43.facets_3, wo_11, wm_6), 4.0f * cos_12));
}

fn Plastic_eval_0( this_44 : Plastic_0,  given_4 : vec3<f32>,  wi_9 : vec3<f32>) -> BsdfEval_0
{
    if((wi_9.z) <= 0.0f)
    {
        return no_bsdf_eval_0();
    }
    var wo_12 : vec3<f32> = above_4(given_4);
    var coat_3 : f32 = Plastic_coat_0(this_44, wo_12.z);
    return Plastic_eval_lobes_0(this_44, wo_12, wi_9, coat_3, Plastic_coat_probability_0(this_44, coat_3));
}

fn Dielectric_eval_0( this_45 : Dielectric_0,  given_5 : vec3<f32>,  wi_10 : vec3<f32>) -> BsdfEval_0
{
    var _S342 : bool;
    if(Microfacets_is_smooth_0(this_45.facets_7))
    {
        _S342 = true;
    }
    else
    {
        _S342 = (wi_10.z) <= 0.0f;
    }
    if(_S342)
    {
        return no_bsdf_eval_0();
    }
    var wo_13 : vec3<f32> = above_4(given_5);
    var wm_7 : vec3<f32> = normalize_vector_0(wo_13 + wi_10);
    var cos_13 : f32 = dot_product_0(wo_13, wm_7);
    return BsdfEval_x24init_0(vec3<f32>(Microfacets_shadowing_0(this_45.facets_7, wo_13.z, wi_10.z)), divide_0(fresnel_dielectric_0(cos_13, this_45.eta_6) * Microfacets_visible_pdf_0(this_45.facets_7, wo_13, wm_7), 4.0f * cos_13));
}

fn Phase_eval_0( this_46 : Phase_0,  wo_14 : vec3<f32>,  wi_11 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_46.color_4, phase_pdf_0(this_46.anisotropy_1, dot_product_0((vec3<f32>(0) - wo_14), wi_11)));
}

fn Diffuse_eval_0( this_47 : Diffuse_0,  wo_15 : vec3<f32>,  wi_12 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_47.reflectance_3, cosine_hemisphere_pdf_0(wi_12.z));
}

fn MaterialBsdf_eval_0( this_48 : MaterialBsdf_0,  wo_16 : vec3<f32>,  wi_13 : vec3<f32>) -> BsdfEval_0
{
    if((this_48.kind_0) == u32(1))
    {
        return Conductor_eval_0(Conductor_x24init_0(this_48.color_1, this_48.facets_0), wo_16, wi_13);
    }
    if((this_48.kind_0) == u32(2))
    {
        return Plastic_eval_0(Plastic_x24init_0(this_48.color_1, this_48.specular_1, this_48.eta_0, this_48.facets_0), wo_16, wi_13);
    }
    if((this_48.kind_0) == u32(3))
    {
        return Dielectric_eval_0(Dielectric_x24init_0(this_48.eta_0, this_48.facets_0), wo_16, wi_13);
    }
    if((this_48.kind_0) == u32(4))
    {
        return Phase_eval_0(Phase_x24init_0(this_48.color_1, this_48.specular_1), wo_16, wi_13);
    }
    return Diffuse_eval_0(Diffuse_x24init_0(this_48.color_1), wo_16, wi_13);
}

fn Plastic_albedo_0( this_49 : Plastic_0) -> vec3<f32>
{
    return max(this_49.reflectance_0, vec3<f32>(Plastic_coat_0(this_49, 1.0f)));
}

fn MaterialBsdf_albedo_0( this_50 : MaterialBsdf_0) -> vec3<f32>
{
    if((this_50.kind_0) == u32(2))
    {
        return Plastic_albedo_0(Plastic_x24init_0(this_50.color_1, this_50.specular_1, this_50.eta_0, this_50.facets_0));
    }
    if((this_50.kind_0) == u32(3))
    {
        return vec3<f32>(1.0f);
    }
    return this_50.color_1;
}

@compute
@workgroup_size(64, 1, 1)
fn check_bsdf(@builtin(global_invocation_id) id_12 : vec3<u32>, @builtin(local_invocation_index) thread_13 : u32)
{
    prove_0(thread_13);
    var _S343 : u32 = id_12.x;
    if(_S343 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_12 : Reader_0 = Reader_x24init_0(u32(25) * _S343);
    var writer_12 : Writer_0 = Writer_x24init_0(u32(16) * _S343);
    var material_2 : PackedMaterial_0;
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
        var _S344 : f32 = Reader_number_0(&(reader_12));
        material_2.base_color_0[channel_0] = _S344;
        channel_0 = channel_0 + u32(1);
    }
    var _S345 : f32 = Reader_number_0(&(reader_12));
    material_2.roughness_0 = _S345;
    channel_0 = u32(0);
    for(;;)
    {
        if(channel_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S346 : f32 = Reader_number_0(&(reader_12));
        material_2.emission_0[channel_0] = _S346;
        channel_0 = channel_0 + u32(1);
    }
    var _S347 : f32 = Reader_number_0(&(reader_12));
    material_2.metallic_0 = _S347;
    var _S348 : f32 = Reader_number_0(&(reader_12));
    material_2.transmission_0 = _S348;
    var _S349 : f32 = Reader_number_0(&(reader_12));
    material_2.ior_0 = _S349;
    var _S350 : f32 = Reader_number_0(&(reader_12));
    material_2.specular_0 = _S350;
    var _S351 : f32 = Reader_number_0(&(reader_12));
    material_2.anisotropy_0 = _S351;
    channel_0 = u32(0);
    for(;;)
    {
        if(channel_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S352 : f32 = Reader_number_0(&(reader_12));
        material_2.absorption_0[channel_0] = _S352;
        channel_0 = channel_0 + u32(1);
    }
    var _S353 : f32 = Reader_number_0(&(reader_12));
    material_2.scattering_0 = _S353;
    var wo_17 : vec3<f32> = Reader_vector_0(&(reader_12));
    var _S354 : vec3<f32> = Reader_vector_0(&(reader_12));
    var u_22 : vec3<f32> = _S354;
    var _S355 : f32 = u_22[i32(2)];
    var bsdf_0 : MaterialBsdf_0 = bsdf_of_0(material_2, 1.0f, &(_S355));
    u_22[i32(2)] = _S355;
    var sample_16 : BsdfSample_0;
    var is_found_4 : bool = MaterialBsdf_sample_0(bsdf_0, wo_17, u_22, &(sample_16));
    if(!is_found_4)
    {
        sample_16 = no_bsdf_sample_0();
    }
    var _S356 : vec3<f32> = Reader_vector_0(&(reader_12));
    var eval_1 : BsdfEval_0 = MaterialBsdf_eval_0(bsdf_0, wo_17, _S356);
    Writer_word_0(&(writer_12), u32(is_found_4));
    Writer_vector_0(&(writer_12), sample_16.wi_0);
    Writer_vector_0(&(writer_12), sample_16.weight_3);
    Writer_number_0(&(writer_12), sample_16.pdf_7);
    Writer_word_0(&(writer_12), u32(sample_16.is_delta_0));
    Writer_vector_0(&(writer_12), eval_1.weight_5);
    Writer_number_0(&(writer_12), eval_1.pdf_9);
    Writer_vector_0(&(writer_12), MaterialBsdf_albedo_0(bsdf_0));
    return;
}

fn exponential_0( x_18 : f32) -> f32
{
    if(x_18 < -87.0f)
    {
        return 0.0f;
    }
    var power_1 : i32 = i32(x_18 * 1.4426950216293335f - 0.5f);
    var k_0 : f32 = f32(power_1);
    var r_0 : f32 = x_18 - k_0 * 0.693359375f - k_0 * -0.00021219444170129f;
    return (1.0f + r_0 * (1.0f + r_0 * (0.5f + r_0 * (0.1666666716337204f + r_0 * (0.0416666679084301f + r_0 * (0.00833333376795053f + r_0 * (0.00138888892251998f + r_0 * 0.0001984127011383f))))))) * (bitcast<f32>(((u32(i32(127) + power_1) << (u32(23))))));
}

fn attenuation_0( medium_0 : PackedMaterial_0,  voxels_1 : f32) -> vec3<f32>
{
    var sigma_0 : vec3<f32> = vector_of_0(medium_0.absorption_0);
    return vec3<f32>(exponential_0(- (sigma_0.x * voxels_1)), exponential_0(- (sigma_0.y * voxels_1)), exponential_0(- (sigma_0.z * voxels_1)));
}

fn unscattered_0( medium_1 : PackedMaterial_0,  voxels_2 : f32) -> f32
{
    return exponential_0(- (medium_1.scattering_0 * voxels_2));
}

fn logarithm_0( x_19 : f32) -> f32
{
    var bits_3 : u32 = (bitcast<u32>((x_19)));
    var _S357 : u32 = (bits_3 & (u32(8388607)));
    var is_upper_1 : bool = _S357 > u32(3474675);
    var power_2 : i32 = i32((bits_3 >> (u32(23)))) - i32(127) + i32(is_upper_1);
    var _S358 : u32;
    if(is_upper_1)
    {
        _S358 = u32(1056964608);
    }
    else
    {
        _S358 = u32(1065353216);
    }
    var mantissa_4 : f32 = (bitcast<f32>(((_S357 | (_S358)))));
    var s_1 : f32 = divide_0(mantissa_4 - 1.0f, mantissa_4 + 1.0f);
    var ss_0 : f32 = s_1 * s_1;
    var _S359 : f32 = f32(power_2);
    return _S359 * 0.693359375f + (_S359 * -0.00021219444170129f + s_1 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_2 : PackedMaterial_0,  u_23 : f32) -> f32
{
    var _S360 : f32;
    if((medium_2.scattering_0) > 0.0f)
    {
        _S360 = divide_0(- logarithm_0(1.0f - u_23), medium_2.scattering_0);
    }
    else
    {
        _S360 = (bitcast<f32>((u32(2139095040))));
    }
    return _S360;
}

@compute
@workgroup_size(64, 1, 1)
fn check_medium(@builtin(global_invocation_id) id_13 : vec3<u32>, @builtin(local_invocation_index) thread_14 : u32)
{
    prove_0(thread_14);
    var _S361 : u32 = id_13.x;
    if(_S361 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_13 : Reader_0 = Reader_x24init_0(u32(12) * _S361);
    var writer_13 : Writer_0 = Writer_x24init_0(u32(10) * _S361);
    var medium_3 : PackedMaterial_0;
    var channel_1 : u32 = u32(0);
    for(;;)
    {
        if(channel_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S362 : f32 = Reader_number_0(&(reader_13));
        medium_3.absorption_0[channel_1] = _S362;
        channel_1 = channel_1 + u32(1);
    }
    var _S363 : f32 = Reader_number_0(&(reader_13));
    medium_3.scattering_0 = _S363;
    var _S364 : f32 = Reader_number_0(&(reader_13));
    medium_3.anisotropy_0 = _S364;
    var voxels_3 : f32 = Reader_number_0(&(reader_13));
    var forward_1 : vec3<f32> = Reader_vector_0(&(reader_13));
    var u_24 : f32 = Reader_number_0(&(reader_13));
    var v_9 : f32 = Reader_number_0(&(reader_13));
    Writer_vector_0(&(writer_13), attenuation_0(medium_3, voxels_3));
    Writer_number_0(&(writer_13), unscattered_0(medium_3, voxels_3));
    Writer_number_0(&(writer_13), free_path_0(medium_3, u_24));
    var cos_14 : f32;
    var _S365 : vec3<f32> = sample_phase_0(_S364, forward_1, u_24, v_9, &(cos_14));
    Writer_vector_0(&(writer_13), _S365);
    Writer_number_0(&(writer_13), cos_14);
    var _S366 : f32 = Reader_number_0(&(reader_13));
    Writer_number_0(&(writer_13), phase_pdf_0(_S364, _S366));
    return;
}

struct Perspective_0
{
     eye_1 : vec3<f32>,
     corner_2 : vec3<f32>,
     pixel_x_1 : vec3<f32>,
     pixel_y_1 : vec3<f32>,
};

fn Perspective_x24init_0( eye_2 : vec3<f32>,  corner_3 : vec3<f32>,  pixel_x_2 : vec3<f32>,  pixel_y_2 : vec3<f32>) -> Perspective_0
{
    var _S367 : Perspective_0;
    _S367.eye_1 = eye_2;
    _S367.corner_2 = corner_3;
    _S367.pixel_x_1 = pixel_x_2;
    _S367.pixel_y_1 = pixel_y_2;
    return _S367;
}

struct Axes_0
{
     forward_2 : vec3<f32>,
     right_3 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_3 : vec3<f32>,  right_4 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S368 : Axes_0;
    _S368.forward_2 = forward_3;
    _S368.right_3 = right_4;
    _S368.up_0 = up_1;
    return _S368;
}

struct ThinLens_0
{
     perspective_0 : Perspective_0,
     lens_x_1 : vec3<f32>,
     lens_y_1 : vec3<f32>,
     blades_1 : u32,
};

fn ThinLens_x24init_0( perspective_1 : Perspective_0,  lens_x_2 : vec3<f32>,  lens_y_2 : vec3<f32>,  blades_2 : u32) -> ThinLens_0
{
    var _S369 : ThinLens_0;
    _S369.perspective_0 = perspective_1;
    _S369.lens_x_1 = lens_x_2;
    _S369.lens_y_1 = lens_y_2;
    _S369.blades_1 = blades_2;
    return _S369;
}

fn concentric_0( square_2 : vec2<f32>) -> vec2<f32>
{
    var a_6 : f32 = 2.0f * square_2.x - 1.0f;
    var b_5 : f32 = 2.0f * square_2.y - 1.0f;
    var _S370 : bool;
    if(a_6 == 0.0f)
    {
        _S370 = b_5 == 0.0f;
    }
    else
    {
        _S370 = false;
    }
    if(_S370)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_6)) > (abs(b_5));
    var radius_6 : f32;
    if(is_across_0)
    {
        radius_6 = a_6;
    }
    else
    {
        radius_6 = b_5;
    }
    var turns_3 : f32;
    if(is_across_0)
    {
        turns_3 = divide_0(b_5, a_6) * 0.125f;
    }
    else
    {
        turns_3 = 0.25f - divide_0(a_6, b_5) * 0.125f;
    }
    if(radius_6 < 0.0f)
    {
        turns_3 = turns_3 + 0.5f;
    }
    var _S371 : f32 = abs(radius_6);
    if(turns_3 < 0.0f)
    {
        radius_6 = turns_3 + 1.0f;
    }
    else
    {
        radius_6 = turns_3;
    }
    return vec2<f32>(_S371, radius_6);
}

fn place_in_aperture_0( blades_3 : u32,  lens_1 : vec2<f32>) -> vec2<f32>
{
    var radius_turns_0 : vec2<f32> = concentric_0(lens_1);
    var radius_7 : f32 = radius_turns_0.x;
    if(blades_3 == u32(0))
    {
        var sin_cos_6 : vec2<f32> = sincos_turns_0(radius_turns_0.y);
        return vec2<f32>(radius_7 * sin_cos_6.y, radius_7 * sin_cos_6.x);
    }
    var count_5 : f32 = f32(blades_3);
    var scaled_0 : f32 = radius_turns_0.y * count_5;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_3 - u32(1)));
    var share_2 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_5));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_5));
    var _S372 : f32 = from_0.y;
    var _S373 : f32 = from_0.x;
    return vec2<f32>(_S372 + (to_0.y - _S372) * share_2, _S373 + (to_0.x - _S373) * share_2) * vec2<f32>(radius_7);
}

fn ThinLens_ray_0( this_51 : ThinLens_0,  position_1 : vec2<f32>,  lens_2 : vec2<f32>) -> Ray_0
{
    var place_4 : vec2<f32> = place_in_aperture_0(this_51.blades_1, lens_2);
    var offset_0 : vec3<f32> = this_51.lens_x_1 * vec3<f32>(place_4.x) + this_51.lens_y_1 * vec3<f32>(place_4.y);
    return ray_from_0(this_51.perspective_0.eye_1 + offset_0, normalize_vector_0(this_51.perspective_0.corner_2 + this_51.perspective_0.pixel_x_1 * vec3<f32>(position_1.x) + this_51.perspective_0.pixel_y_1 * vec3<f32>(position_1.y) - offset_0));
}

struct Orthographic_0
{
     corner_4 : vec3<f32>,
     pixel_x_3 : vec3<f32>,
     pixel_y_3 : vec3<f32>,
     forward_4 : vec3<f32>,
};

fn Orthographic_x24init_0( corner_5 : vec3<f32>,  pixel_x_4 : vec3<f32>,  pixel_y_4 : vec3<f32>,  forward_5 : vec3<f32>) -> Orthographic_0
{
    var _S374 : Orthographic_0;
    _S374.corner_4 = corner_5;
    _S374.pixel_x_3 = pixel_x_4;
    _S374.pixel_y_3 = pixel_y_4;
    _S374.forward_4 = forward_5;
    return _S374;
}

fn Orthographic_ray_0( this_52 : Orthographic_0,  position_2 : vec2<f32>,  lens_3 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_52.corner_4 + this_52.pixel_x_3 * vec3<f32>(position_2.x) + this_52.pixel_y_3 * vec3<f32>(position_2.y), this_52.forward_4);
}

struct Panorama_0
{
     eye_3 : vec3<f32>,
     axes_0 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_4 : vec3<f32>,  axes_1 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S375 : Panorama_0;
    _S375.eye_3 = eye_4;
    _S375.axes_0 = axes_1;
    _S375.inverse_size_0 = inverse_size_1;
    _S375.half_eye_distance_0 = half_eye_distance_1;
    return _S375;
}

fn Panorama_ray_0( this_53 : Panorama_0,  position_3 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_3.y * this_53.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_0 : f32;
    if(is_right_eye_0)
    {
        side_0 = this_53.half_eye_distance_0;
    }
    else
    {
        side_0 = - this_53.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_3.x * this_53.inverse_size_0.x);
    var height_3 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S376 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S377 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_53.eye_3 + (this_53.axes_0.forward_2 * _S377 - this_53.axes_0.right_3 * _S376) * vec3<f32>(side_0), normalize_vector_0((vec3<f32>(0) - this_53.axes_0.forward_2 * _S376 + this_53.axes_0.right_3 * _S377) * vec3<f32>(height_3.x) + this_53.axes_0.up_0 * vec3<f32>(height_3.y)));
}

struct Fisheye_0
{
     eye_5 : vec3<f32>,
     axes_2 : Axes_0,
     middle_0 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_6 : vec3<f32>,  axes_3 : Axes_0,  middle_1 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S378 : Fisheye_0;
    _S378.eye_5 = eye_6;
    _S378.axes_2 = axes_3;
    _S378.middle_0 = middle_1;
    _S378.turns_per_pixel_0 = turns_per_pixel_1;
    return _S378;
}

fn Fisheye_ray_0( this_54 : Fisheye_0,  position_4 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    var x_20 : f32 = position_4.x - this_54.middle_0.x;
    var y_14 : f32 = position_4.y - this_54.middle_0.y;
    var radius_8 : f32 = square_root_0(x_20 * x_20 + y_14 * y_14);
    var sin_cos_7 : vec2<f32> = sincos_turns_0(min(radius_8 * this_54.turns_per_pixel_0, 1.0f));
    var scale_1 : f32;
    if(radius_8 > 0.0f)
    {
        scale_1 = divide_0(sin_cos_7.x, radius_8);
    }
    else
    {
        scale_1 = 0.0f;
    }
    return ray_from_0(this_54.eye_5, normalize_vector_0(this_54.axes_2.forward_2 * vec3<f32>(sin_cos_7.y) + this_54.axes_2.right_3 * vec3<f32>((x_20 * scale_1)) - this_54.axes_2.up_0 * vec3<f32>((y_14 * scale_1))));
}

fn Perspective_ray_0( this_55 : Perspective_0,  position_5 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_55.eye_1, normalize_vector_0(this_55.corner_2 + this_55.pixel_x_1 * vec3<f32>(position_5.x) + this_55.pixel_y_1 * vec3<f32>(position_5.y)));
}

struct CameraFrame_0
{
     lens_7 : u32,
     eye_7 : vec3<f32>,
     corner_6 : vec3<f32>,
     pixel_x_5 : vec3<f32>,
     pixel_y_5 : vec3<f32>,
     lens_x_3 : vec3<f32>,
     lens_y_3 : vec3<f32>,
     blades_4 : u32,
};

fn CameraFrame_ray_0( this_56 : CameraFrame_0,  position_6 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_56.eye_7, this_56.corner_6, this_56.pixel_x_5, this_56.pixel_y_5);
    var axes_4 : Axes_0 = Axes_x24init_0(this_56.corner_6, this_56.pixel_x_5, this_56.pixel_y_5);
    switch(this_56.lens_7)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_56.lens_x_3, this_56.lens_y_3, this_56.blades_4), position_6, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_56.corner_6, this_56.pixel_x_5, this_56.pixel_y_5, this_56.lens_x_3), position_6, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_56.eye_7, axes_4, this_56.lens_x_3.xy, this_56.lens_x_3.z), position_6, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_56.eye_7, axes_4, this_56.lens_x_3.xy, this_56.lens_x_3.z), position_6, lens_sample_0);
        }
    default :
        {
            return Perspective_ray_0(perspective_2, position_6, lens_sample_0);
        }
    }
}

@compute
@workgroup_size(64, 1, 1)
fn check_camera(@builtin(global_invocation_id) id_14 : vec3<u32>, @builtin(local_invocation_index) thread_15 : u32)
{
    prove_0(thread_15);
    var _S379 : u32 = id_14.x;
    if(_S379 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_14 : Reader_0 = Reader_x24init_0(u32(24) * _S379);
    var writer_14 : Writer_0 = Writer_x24init_0(u32(8) * _S379);
    var camera_0 : CameraFrame_0;
    var _S380 : u32 = Reader_word_0(&(reader_14));
    camera_0.lens_7 = _S380;
    var _S381 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.eye_7 = _S381;
    var _S382 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.corner_6 = _S382;
    var _S383 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.pixel_x_5 = _S383;
    var _S384 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.pixel_y_5 = _S384;
    var _S385 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.lens_x_3 = _S385;
    var _S386 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.lens_y_3 = _S386;
    var _S387 : u32 = Reader_word_0(&(reader_14));
    camera_0.blades_4 = _S387;
    var x_21 : f32 = Reader_number_0(&(reader_14));
    var _S388 : f32 = Reader_number_0(&(reader_14));
    var position_7 : vec2<f32> = vec2<f32>(x_21, _S388);
    var u_25 : f32 = Reader_number_0(&(reader_14));
    var _S389 : f32 = Reader_number_0(&(reader_14));
    var ray_10 : Ray_0 = CameraFrame_ray_0(camera_0, position_7, vec2<f32>(u_25, _S389));
    Writer_vector_0(&(writer_14), ray_10.origin_1);
    Writer_number_0(&(writer_14), ray_10.t_min_0);
    Writer_vector_0(&(writer_14), ray_10.direction_1);
    Writer_number_0(&(writer_14), ray_10.t_max_0);
    return;
}

