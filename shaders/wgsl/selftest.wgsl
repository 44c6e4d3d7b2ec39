var<private> infinity_bits_0 : u32 = 2139095040u;
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

@binding(3) @group(0) var<storage, read> records_0 : array<vec4<u32>>;

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
struct EnvironmentTexel_std430_0
{
    @align(4) radiance_0 : array<f32, i32(3)>,
    @align(4) pdf_0 : f32,
    @align(4) threshold_0 : f32,
    @align(4) alias_0 : u32,
};

@binding(19) @group(0) var<storage, read> environment_0 : array<EnvironmentTexel_std430_0>;

@id(6) override SKY_0 : u32 = u32(0);

fn first_row_0( array_0 : u32) -> u32
{
    return records_0[(array_0 >> (u32(2)))][(array_0 & (u32(3)))];
}

fn Rows_operatorx5Bx5D_get_0( row_0 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(3)) + row_0];
}

fn Rows_operatorx5Bx5D_get_1( row_1 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(4)) + row_1];
}

fn Rows_operatorx5Bx5D_get_2( row_2 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(5)) + row_2];
}

struct Receiver_0
{
     point_0 : vec3<f32>,
     normal_0 : vec3<f32>,
};

struct Hit_0
{
     t_0 : f32,
     instance_0 : u32,
     voxel_0 : vec3<i32>,
     face_0 : u32,
};

struct Aim_0
{
     is_met_0 : bool,
     direction_0 : vec3<f32>,
     hit_0 : Hit_0,
     luminance_0 : f32,
};

struct Descent_0
{
     node_0 : u32,
     index_0 : u32,
     count_1 : u32,
     weight_0 : f32,
     total_0 : f32,
     choice_0 : f32,
     is_far_0 : bool,
};

fn waits_for_pages_0() -> bool
{
    return false;
}

struct LightNode_0
{
     min_0 : array<f32, i32(3)>,
     index_1 : u32,
     max_0 : array<f32, i32(3)>,
     count_2 : u32,
     power_0 : array<f32, i32(6)>,
     parent_0 : u32,
     root_0 : u32,
};

fn lights_in_pages_0() -> bool
{
    return false;
}

fn light_node_of_0( a_0 : vec4<u32>,  b_0 : vec4<u32>,  c_0 : vec4<u32>,  d_0 : vec4<u32>) -> LightNode_0
{
    var node_1 : LightNode_0;
    var _S1 : f32 = (bitcast<f32>((a_0.y)));
    var _S2 : f32 = (bitcast<f32>((a_0.z)));
    node_1.min_0[i32(0)] = (bitcast<f32>((a_0.x)));
    node_1.min_0[i32(1)] = _S1;
    node_1.min_0[i32(2)] = _S2;
    node_1.index_1 = a_0.w;
    var _S3 : f32 = (bitcast<f32>((b_0.y)));
    var _S4 : f32 = (bitcast<f32>((b_0.z)));
    node_1.max_0[i32(0)] = (bitcast<f32>((b_0.x)));
    node_1.max_0[i32(1)] = _S3;
    node_1.max_0[i32(2)] = _S4;
    node_1.count_2 = b_0.w;
    var _S5 : f32 = (bitcast<f32>((c_0.y)));
    var _S6 : f32 = (bitcast<f32>((c_0.z)));
    var _S7 : f32 = (bitcast<f32>((c_0.w)));
    var _S8 : f32 = (bitcast<f32>((d_0.x)));
    var _S9 : f32 = (bitcast<f32>((d_0.y)));
    node_1.power_0[i32(0)] = (bitcast<f32>((c_0.x)));
    node_1.power_0[i32(1)] = _S5;
    node_1.power_0[i32(2)] = _S6;
    node_1.power_0[i32(3)] = _S7;
    node_1.power_0[i32(4)] = _S8;
    node_1.power_0[i32(5)] = _S9;
    node_1.parent_0 = d_0.z;
    node_1.root_0 = d_0.w;
    return node_1;
}

fn place_in_light_node_0( node_2 : u32,  word_0 : u32) -> u32
{
    return u32(0);
}

fn light_node_at_0( index_2 : u32) -> LightNode_0
{
    if(!lights_in_pages_0())
    {
        var _S10 : u32 = u32(4) * index_2;
        return light_node_of_0(Rows_operatorx5Bx5D_get_2(_S10), Rows_operatorx5Bx5D_get_2(_S10 + u32(1)), Rows_operatorx5Bx5D_get_2(_S10 + u32(2)), Rows_operatorx5Bx5D_get_2(_S10 + u32(3)));
    }
    var at_0 : u32 = place_in_light_node_0(index_2, u32(0));
    var node_3 : LightNode_0;
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
        node_3.min_0[i_0] = (bitcast<f32>((cells_0[at_0 + i_0])));
        node_3.max_0[i_0] = (bitcast<f32>((cells_0[at_0 + u32(4) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_3.index_1 = cells_0[at_0 + u32(3)];
    node_3.count_2 = cells_0[at_0 + u32(7)];
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
        node_3.power_0[i_0] = (bitcast<f32>((cells_0[at_0 + u32(8) + i_0])));
        i_0 = i_0 + u32(1);
    }
    node_3.parent_0 = cells_0[at_0 + u32(14)];
    node_3.root_0 = cells_0[at_0 + u32(15)];
    return node_3;
}

fn GridLights_node_0( index_3 : u32) -> LightNode_0
{
    return light_node_at_0(index_3);
}

struct View_0
{
     importance_0 : f32,
     of_nearest_0 : f32,
     is_far_1 : bool,
};

fn vector_of_0( values_0 : array<f32, i32(3)>) -> vec3<f32>
{
    return vec3<f32>(values_0[i32(0)], values_0[i32(1)], values_0[i32(2)]);
}

fn dot_product_0( a_1 : vec3<f32>,  b_1 : vec3<f32>) -> f32
{
    return a_1.x * b_1.x + a_1.y * b_1.y + a_1.z * b_1.z;
}

fn Receiver_slack_0( this_0 : Receiver_0) -> f32
{
    var _S11 : f32;
    if((all(((this_0.normal_0) == vec3<f32>(0.0f)))))
    {
        _S11 = 1.00000001504746622e+30f;
    }
    else
    {
        _S11 = 0.0f;
    }
    return _S11;
}

fn with_slack_0( receiver_0 : Receiver_0,  cos_0 : f32) -> f32
{
    return cos_0 + Receiver_slack_0(receiver_0);
}

fn reach_of_0( toward_0 : vec3<f32>,  half_0 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_0), half_0);
}

fn length_squared_0( vector_0 : vec3<f32>) -> f32
{
    return dot_product_0(vector_0, vector_0);
}

fn reciprocal_guess_0( x_0 : f32) -> f32
{
    var guess_0 : f32 = (bitcast<f32>((u32(2129859011) - (bitcast<u32>((x_0))))));
    return guess_0 * (2.0f - x_0 * guess_0);
}

struct BySide_0
{
     low_0 : vec3<f32>,
     high_0 : vec3<f32>,
};

fn BySide_x24init_0( low_1 : vec3<f32>,  high_1 : vec3<f32>) -> BySide_0
{
    var _S12 : BySide_0;
    _S12.low_0 = low_1;
    _S12.high_0 = high_1;
    return _S12;
}

fn sent_by_side_0( node_4 : LightNode_0,  point_1 : vec3<f32>) -> BySide_0
{
    var _S13 : vec3<f32> = vec3<f32>(0.0f);
    return BySide_x24init_0(vec3<f32>(node_4.power_0[i32(0)], node_4.power_0[i32(2)], node_4.power_0[i32(4)]) * max(vector_of_0(node_4.max_0) - point_1, _S13), vec3<f32>(node_4.power_0[i32(1)], node_4.power_0[i32(3)], node_4.power_0[i32(5)]) * max(point_1 - vector_of_0(node_4.min_0), _S13));
}

fn BySide_sum_0( this_1 : BySide_0) -> f32
{
    var axes_0 : vec3<f32> = this_1.low_0 + this_1.high_0;
    return axes_0.x + axes_0.y + axes_0.z;
}

fn nearest_of_0( toward_1 : vec3<f32>,  half_1 : vec3<f32>) -> vec3<f32>
{
    return max(abs(toward_1) - half_1, half_1 * vec3<f32>(0.03125f));
}

fn View_x24init_0( importance_1 : f32,  of_nearest_1 : f32,  is_far_2 : bool) -> View_0
{
    var _S14 : View_0;
    _S14.importance_0 = importance_1;
    _S14.of_nearest_0 = of_nearest_1;
    _S14.is_far_1 = is_far_2;
    return _S14;
}

fn view_0( node_5 : LightNode_0,  receiver_1 : Receiver_0) -> View_0
{
    var _S15 : vec3<f32> = vector_of_0(node_5.max_0);
    var _S16 : vec3<f32> = vector_of_0(node_5.min_0);
    var _S17 : vec3<f32> = vec3<f32>(0.5f);
    var half_2 : vec3<f32> = (_S15 - _S16) * _S17;
    var toward_2 : vec3<f32> = (_S16 + _S15) * _S17 - receiver_1.point_0;
    var middle_0 : f32 = dot_product_0(toward_2, receiver_1.normal_0);
    var aside_0 : f32 = dot_product_0(half_2, abs(receiver_1.normal_0));
    var above_0 : f32 = with_slack_0(receiver_1, middle_0 + aside_0);
    var far_0 : f32 = length_squared_0(reach_of_0(toward_2, half_2));
    var near_0 : f32 = length_squared_0(half_2);
    var is_far_3 : bool;
    if((with_slack_0(receiver_1, middle_0 - aside_0)) > 0.0f)
    {
        is_far_3 = far_0 > (near_0 * 36.0f);
    }
    else
    {
        is_far_3 = false;
    }
    var falloff_0 : f32 = reciprocal_guess_0(far_0);
    var cosines_0 : f32;
    if(above_0 > 0.0f)
    {
        cosines_0 = BySide_sum_0(sent_by_side_0(node_5, receiver_1.point_0)) * above_0 * falloff_0;
    }
    else
    {
        cosines_0 = 0.0f;
    }
    return View_x24init_0(cosines_0 * falloff_0, cosines_0 * reciprocal_guess_0(length_squared_0(nearest_of_0(toward_2, half_2))), is_far_3);
}

fn normal_or_zero_0( weight_1 : f32) -> f32
{
    var _S18 : f32;
    if(weight_1 < 1.17549435082228751e-38f)
    {
        _S18 = 0.0f;
    }
    else
    {
        _S18 = weight_1;
    }
    return _S18;
}

fn inverse_power_of_two_0( x_1 : f32) -> f32
{
    return (bitcast<f32>((((u32(254) - (((bitcast<u32>((x_1))) >> (u32(23))))) << (u32(23))))));
}

fn weights_of_0( left_0 : f32,  right_0 : f32) -> vec2<f32>
{
    var _S19 : f32 = normal_or_zero_0(left_0);
    var _S20 : f32 = normal_or_zero_0(right_0);
    var unit_0 : f32 = inverse_power_of_two_0(_S19 + _S20);
    return vec2<f32>(normal_or_zero_0(_S19 * unit_0), normal_or_zero_0(_S20 * unit_0));
}

fn weights_of_views_0( left_1 : View_0,  right_1 : View_0) -> vec2<f32>
{
    var near_1 : vec2<f32> = weights_of_0(left_1.of_nearest_0, right_1.of_nearest_0);
    var _S21 : f32 = near_1.x;
    var _S22 : f32 = near_1.y;
    var of_near_0 : f32 = _S21 + _S22;
    var of_all_0 : f32 = (left_1.importance_0 + right_1.importance_0) * 0.5f;
    return weights_of_0(left_1.importance_0 * of_near_0 + _S21 * of_all_0, right_1.importance_0 * of_near_0 + _S22 * of_all_0);
}

fn descend_0( receiver_2 : Receiver_0,  aim_0 : Aim_0,  descent_0 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S23 : bool;
        if(((*descent_0).count_1) == u32(0))
        {
            _S23 = !(*descent_0).is_far_0;
        }
        else
        {
            _S23 = false;
        }
        if(_S23)
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
        var left_2 : LightNode_0 = GridLights_node_0((*descent_0).node_0 + u32(1));
        var right_2 : LightNode_0 = GridLights_node_0((*descent_0).index_0);
        var of_left_0 : View_0 = view_0(left_2, receiver_2);
        var of_right_0 : View_0 = view_0(right_2, receiver_2);
        var weights_0 : vec2<f32> = weights_of_views_0(of_left_0, of_right_0);
        var _S24 : f32 = weights_0.x;
        var _S25 : f32 = weights_0.y;
        var total_1 : f32 = _S24 + _S25;
        if(!(total_1 > 0.0f))
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
            _S26 = ((*descent_0).choice_0 * total_1) < (_S24 * (*descent_0).weight_0);
        }
        var is_left_0 : bool;
        if(aim_0.is_met_0)
        {
            var _S27 : vec3<f32> = vec3<f32>(aim_0.hit_0.voxel_0);
            if((all((_S27 >= (vector_of_0(left_2.min_0))))))
            {
                is_left_0 = (all((_S27 < (vector_of_0(left_2.max_0)))));
            }
            else
            {
                is_left_0 = false;
            }
        }
        else
        {
            is_left_0 = _S26;
        }
        var _S28 : f32 = (*descent_0).choice_0 * total_1;
        var _S29 : f32;
        if(is_left_0)
        {
            _S29 = 0.0f;
        }
        else
        {
            _S29 = _S24 * (*descent_0).weight_0;
        }
        (*descent_0).choice_0 = _S28 - _S29;
        var _S30 : u32;
        if(is_left_0)
        {
            _S30 = (*descent_0).node_0 + u32(1);
        }
        else
        {
            _S30 = (*descent_0).index_0;
        }
        (*descent_0).node_0 = _S30;
        var _S31 : u32;
        if(is_left_0)
        {
            _S31 = left_2.index_1;
        }
        else
        {
            _S31 = right_2.index_1;
        }
        (*descent_0).index_0 = _S31;
        var _S32 : u32;
        if(is_left_0)
        {
            _S32 = left_2.count_2;
        }
        else
        {
            _S32 = right_2.count_2;
        }
        (*descent_0).count_1 = _S32;
        var _S33 : bool;
        if(is_left_0)
        {
            _S33 = of_left_0.is_far_1;
        }
        else
        {
            _S33 = of_right_0.is_far_1;
        }
        (*descent_0).is_far_0 = _S33;
        var _S34 : f32;
        if(is_left_0)
        {
            _S34 = _S24;
        }
        else
        {
            _S34 = _S25;
        }
        var _S35 : f32 = (*descent_0).weight_0 * _S34;
        (*descent_0).weight_0 = _S35;
        (*descent_0).total_0 = (*descent_0).total_0 * total_1;
        if(_S35 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

fn Descent_at_0( this_2 : ptr<function, Descent_0>,  root_1 : u32)
{
    var node_6 : LightNode_0 = GridLights_node_0(root_1);
    (*this_2).node_0 = root_1;
    (*this_2).index_0 = node_6.index_1;
    (*this_2).count_1 = node_6.count_2;
    (*this_2).is_far_0 = false;
    return;
}

fn Rows_operatorx5Bx5D_get_3( row_3 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(6)) + row_3];
}

fn top_light_node_0( index_4 : u32) -> LightNode_0
{
    var _S36 : u32 = u32(4) * index_4;
    return light_node_of_0(Rows_operatorx5Bx5D_get_3(_S36), Rows_operatorx5Bx5D_get_3(_S36 + u32(1)), Rows_operatorx5Bx5D_get_3(_S36 + u32(2)), Rows_operatorx5Bx5D_get_3(_S36 + u32(3)));
}

fn TopLights_node_0( index_5 : u32) -> LightNode_0
{
    return top_light_node_0(index_5);
}

fn descend_1( receiver_3 : Receiver_0,  aim_1 : Aim_0,  descent_1 : ptr<function, Descent_0>) -> bool
{
    for(;;)
    {
        var _S37 : bool;
        if(((*descent_1).count_1) == u32(0))
        {
            _S37 = !(*descent_1).is_far_0;
        }
        else
        {
            _S37 = false;
        }
        if(_S37)
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
        var left_3 : LightNode_0 = TopLights_node_0((*descent_1).node_0 + u32(1));
        var right_3 : LightNode_0 = TopLights_node_0((*descent_1).index_0);
        var weights_1 : vec2<f32> = weights_of_views_0(view_0(left_3, receiver_3), view_0(right_3, receiver_3));
        var _S38 : f32 = weights_1.x;
        var _S39 : f32 = weights_1.y;
        var total_2 : f32 = _S38 + _S39;
        if(!(total_2 > 0.0f))
        {
            return false;
        }
        var _S40 : bool;
        if(_S39 <= 0.0f)
        {
            _S40 = true;
        }
        else
        {
            _S40 = ((*descent_1).choice_0 * total_2) < (_S38 * (*descent_1).weight_0);
        }
        var is_left_1 : bool;
        if(aim_1.is_met_0)
        {
            var _S41 : vec3<f32> = vec3<f32>(aim_1.hit_0.voxel_0);
            if((all((_S41 >= (vector_of_0(left_3.min_0))))))
            {
                is_left_1 = (all((_S41 < (vector_of_0(left_3.max_0)))));
            }
            else
            {
                is_left_1 = false;
            }
        }
        else
        {
            is_left_1 = _S40;
        }
        var _S42 : f32 = (*descent_1).choice_0 * total_2;
        var _S43 : f32;
        if(is_left_1)
        {
            _S43 = 0.0f;
        }
        else
        {
            _S43 = _S38 * (*descent_1).weight_0;
        }
        (*descent_1).choice_0 = _S42 - _S43;
        var _S44 : u32;
        if(is_left_1)
        {
            _S44 = (*descent_1).node_0 + u32(1);
        }
        else
        {
            _S44 = (*descent_1).index_0;
        }
        (*descent_1).node_0 = _S44;
        var _S45 : u32;
        if(is_left_1)
        {
            _S45 = left_3.index_1;
        }
        else
        {
            _S45 = right_3.index_1;
        }
        (*descent_1).index_0 = _S45;
        var _S46 : u32;
        if(is_left_1)
        {
            _S46 = left_3.count_2;
        }
        else
        {
            _S46 = right_3.count_2;
        }
        (*descent_1).count_1 = _S46;
        (*descent_1).is_far_0 = false;
        var _S47 : f32;
        if(is_left_1)
        {
            _S47 = _S38;
        }
        else
        {
            _S47 = _S39;
        }
        var _S48 : f32 = (*descent_1).weight_0 * _S47;
        (*descent_1).weight_0 = _S48;
        (*descent_1).total_0 = (*descent_1).total_0 * total_2;
        if(_S48 <= 0.0f)
        {
            return false;
        }
    }
    return true;
}

@id(1) override IS_SINGLE_0 : bool = false;

fn Descent_at_1( this_3 : ptr<function, Descent_0>,  root_2 : u32)
{
    var node_7 : LightNode_0 = TopLights_node_0(root_2);
    (*this_3).node_0 = root_2;
    (*this_3).index_0 = node_7.index_1;
    (*this_3).count_1 = node_7.count_2;
    (*this_3).is_far_0 = false;
    return;
}

@id(0) override IS_EXACT_0 : bool = true;

fn Rows_operatorx5Bx5D_get_4( row_4 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(0)) + row_4];
}

fn Rows_operatorx5Bx5D_get_5( row_5 : u32) -> vec4<u32>
{
    return records_0[first_row_0(u32(1)) + row_5];
}

fn prove_0( thread_0 : u32)
{
    if(thread_0 == u32(0))
    {
        atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        var _S49 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

struct Reader_0
{
     at_1 : u32,
};

fn Reader_x24init_0( at_2 : u32) -> Reader_0
{
    var _S50 : Reader_0;
    _S50.at_1 = at_2;
    return _S50;
}

struct Writer_0
{
     at_3 : u32,
};

fn Writer_x24init_0( at_4 : u32) -> Writer_0
{
    var _S51 : Writer_0;
    _S51.at_3 = at_4;
    return _S51;
}

fn Reader_word_0( this_4 : ptr<function, Reader_0>) -> u32
{
    var _S52 : u32 = (*this_4).at_1 + u32(1);
    (*this_4).at_1 = _S52;
    return inputs_0[_S52 - u32(1)];
}

fn Reader_word_1( this_5 : ptr<function, Reader_0>) -> u32
{
    var _S53 : u32 = (*this_5).at_1 + u32(1);
    (*this_5).at_1 = _S53;
    return inputs_0[_S53 - u32(1)];
}

struct Sampler_0
{
     seed_1 : u32,
     pixel_0 : u32,
     sample_0 : u32,
};

fn Sampler_x24init_0( seed_2 : u32,  pixel_1 : u32,  sample_1 : u32) -> Sampler_0
{
    var _S54 : Sampler_0;
    _S54.seed_1 = seed_2;
    _S54.pixel_0 = pixel_1;
    _S54.sample_0 = sample_1;
    return _S54;
}

fn pcg4d_0( words_0 : vec4<u32>) -> vec4<u32>
{
    var _S55 : vec4<u32> = words_0 * vec4<u32>(u32(1664525)) + vec4<u32>(u32(1013904223));
    var v_0 : vec4<u32> = _S55;
    v_0[i32(0)] = v_0[i32(0)] + _S55.y * _S55.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    var _S56 : vec4<u32> = (v_0 ^ (((v_0 >> (vec4<u32>(u32(16)))))));
    v_0 = _S56;
    v_0[i32(0)] = v_0[i32(0)] + _S56.y * _S56.w;
    v_0[i32(1)] = v_0[i32(1)] + v_0.z * v_0.x;
    v_0[i32(2)] = v_0[i32(2)] + v_0.x * v_0.y;
    v_0[i32(3)] = v_0[i32(3)] + v_0.y * v_0.z;
    return v_0;
}

fn unit_float_0( words_1 : vec4<u32>) -> vec4<f32>
{
    return vec4<f32>((words_1 >> (vec4<u32>(u32(8))))) * vec4<f32>(5.9604644775390625e-08f);
}

fn Sampler_independent_0( this_6 : Sampler_0,  dimension_0 : u32) -> vec4<f32>
{
    return unit_float_0(pcg4d_0(vec4<u32>(this_6.pixel_0, this_6.sample_0, dimension_0, this_6.seed_1)));
}

fn owen_of_reversed_0( reversed_0 : u32,  seed_3 : u32) -> u32
{
    var word_1 : u32 = reversed_0 + seed_3;
    var word_2 : u32 = (word_1 ^ ((word_1 * u32(1817228412))));
    var word_3 : u32 = (word_2 ^ ((word_2 * u32(3090095698))));
    var word_4 : u32 = (word_3 ^ ((word_3 * u32(3350193720))));
    return reverseBits((word_4 ^ ((word_4 * u32(2367878886)))));
}

fn scrambled_sobol_0( sample_2 : u32,  order_0 : u32,  seeds_0 : vec2<u32>) -> vec2<u32>
{
    var index_6 : u32 = owen_of_reversed_0(reverseBits(sample_2), order_0);
    var binomial_0 : u32 = (index_6 ^ (((((index_6 >> (u32(1)))) & (u32(1431655765))))));
    var binomial_1 : u32 = (binomial_0 ^ (((((binomial_0 >> (u32(2)))) & (u32(858993459))))));
    var binomial_2 : u32 = (binomial_1 ^ (((((binomial_1 >> (u32(4)))) & (u32(252645135))))));
    var binomial_3 : u32 = (binomial_2 ^ (((((binomial_2 >> (u32(8)))) & (u32(16711935))))));
    return vec2<u32>(owen_of_reversed_0(index_6, seeds_0.x), owen_of_reversed_0((binomial_3 ^ (((((binomial_3 >> (u32(16)))) & (u32(65535)))))), seeds_0.y));
}

fn Sampler_pair_0( this_7 : Sampler_0,  dimension_1 : u32,  which_0 : u32) -> vec2<u32>
{
    var words_2 : vec4<u32> = pcg4d_0(vec4<u32>(this_7.pixel_0, dimension_1, this_7.seed_1, which_0));
    return scrambled_sobol_0(this_7.sample_0, words_2.x, words_2.yz);
}

fn Sampler_stratified_0( this_8 : Sampler_0,  dimension_2 : u32) -> vec4<f32>
{
    return unit_float_0(vec4<u32>(Sampler_pair_0(this_8, dimension_2, u32(1)), Sampler_pair_0(this_8, dimension_2, u32(2))));
}

fn Writer_word_0( this_9 : ptr<function, Writer_0>,  value_0 : u32)
{
    outputs_0[(*this_9).at_3] = value_0;
    (*this_9).at_3 = (*this_9).at_3 + u32(1);
    return;
}

fn Writer_word_1( this_10 : ptr<function, Writer_0>,  value_1 : u32)
{
    outputs_0[(*this_10).at_3] = value_1;
    (*this_10).at_3 = (*this_10).at_3 + u32(1);
    return;
}

fn Writer_number_0( this_11 : ptr<function, Writer_0>,  value_2 : f32)
{
    Writer_word_1(&((*this_11)), (bitcast<u32>((value_2))));
    return;
}

fn Writer_number_1( this_12 : ptr<function, Writer_0>,  value_3 : f32)
{
    Writer_word_1(&((*this_12)), (bitcast<u32>((value_3))));
    return;
}

fn Writer_vector_0( this_13 : ptr<function, Writer_0>,  value_4 : vec3<f32>)
{
    Writer_number_1(&((*this_13)), value_4.x);
    Writer_number_1(&((*this_13)), value_4.y);
    Writer_number_1(&((*this_13)), value_4.z);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_sampler(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_1 : u32)
{
    prove_0(thread_1);
    var _S57 : u32 = id_0.x;
    if(_S57 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_0 : Reader_0 = Reader_x24init_0(u32(4) * _S57);
    var writer_0 : Writer_0 = Writer_x24init_0(u32(8) * _S57);
    var seed_4 : u32 = Reader_word_0(&(reader_0));
    var pixel_2 : u32 = Reader_word_0(&(reader_0));
    var _S58 : u32 = Reader_word_0(&(reader_0));
    var sampler_0 : Sampler_0 = Sampler_x24init_0(seed_4, pixel_2, _S58);
    var dimension_3 : u32 = Reader_word_0(&(reader_0));
    var independent_0 : vec4<f32> = Sampler_independent_0(sampler_0, dimension_3);
    var stratified_0 : vec4<f32> = Sampler_stratified_0(sampler_0, dimension_3);
    Writer_vector_0(&(writer_0), independent_0.xyz);
    Writer_number_0(&(writer_0), independent_0.w);
    Writer_vector_0(&(writer_0), stratified_0.xyz);
    Writer_number_0(&(writer_0), stratified_0.w);
    return;
}

fn Reader_number_0( this_14 : ptr<function, Reader_0>) -> f32
{
    var _S59 : u32 = Reader_word_1(&((*this_14)));
    return (bitcast<f32>((_S59)));
}

fn Reader_number_1( this_15 : ptr<function, Reader_0>) -> f32
{
    var _S60 : u32 = Reader_word_1(&((*this_15)));
    return (bitcast<f32>((_S60)));
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

fn is_normal_0( exponent_0 : u32) -> bool
{
    return (exponent_0 - u32(1)) < u32(254);
}

fn nearest_root_0( mantissa_0 : u32,  guess_1 : u32) -> u32
{
    var rest_0 : i32 = i32(((mantissa_0 << (u32(23)))) - guess_1 * guess_1);
    var units_0 : i32 = i32(floor(f32(rest_0) / f32(u32(2) * guess_1) + 0.5f));
    var _S61 : i32 = i32(guess_1);
    var root_3 : i32 = _S61 + units_0;
    var rest_1 : i32 = rest_0 - units_0 * (_S61 + root_3);
    return u32(root_3 + i32(rest_1 > root_3) - i32(rest_1 <= (- root_3)));
}

fn square_root_0( value_5 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return sqrt(value_5);
    }
    var _S62 : u32 = (bitcast<u32>((value_5)));
    var exponent_1 : u32 = (_S62 >> (u32(23)));
    if(!is_normal_0(exponent_1))
    {
        return sqrt(value_5);
    }
    var mantissa_1 : u32 = (((((_S62 & (u32(8388607)))) | (u32(8388608)))) << ((((~exponent_1) & (u32(1))))));
    return (bitcast<f32>(((((((exponent_1 + u32(127)) >> (u32(1)))) << (u32(23)))) + (nearest_root_0(mantissa_1, u32(sqrt(f32(mantissa_1) * 1.1920928955078125e-07f) * 8.388608e+06f)) - u32(8388608)))));
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
    var units_1 : i32 = i32(floor(f32(rest_2) * (1.0f / f32(divisor_0)) + 0.5f));
    var _S63 : i32 = i32(divisor_0);
    var _S64 : i32 = i32(2) * (rest_2 - units_1 * _S63);
    return guess_2 + u32(units_1 + (i32(_S64 > _S63) - i32(_S64 < (- _S63))));
}

fn divide_0( a_2 : f32,  b_2 : f32) -> f32
{
    if(!IS_EXACT_0)
    {
        return a_2 / b_2;
    }
    var _S65 : u32 = (bitcast<u32>((a_2)));
    var exponent_a_0 : u32 = (((_S65 >> (u32(23)))) & (u32(255)));
    var _S66 : u32 = (bitcast<u32>((b_2)));
    var exponent_b_0 : u32 = (((_S66 >> (u32(23)))) & (u32(255)));
    var dividend_1 : u32 = (((_S65 & (u32(8388607)))) | (u32(8388608)));
    var divisor_1 : u32 = (((_S66 & (u32(8388607)))) | (u32(8388608)));
    var is_below_0 : u32 = u32(dividend_1 < divisor_1);
    var dividend_2 : u32 = (dividend_1 << (is_below_0));
    var exponent_2 : u32 = exponent_a_0 + u32(127) - exponent_b_0 - is_below_0;
    var _S67 : bool;
    if(!is_normal_0(exponent_a_0))
    {
        _S67 = true;
    }
    else
    {
        _S67 = !is_normal_0(exponent_b_0);
    }
    if(_S67)
    {
        _S67 = true;
    }
    else
    {
        _S67 = !is_normal_0(exponent_2);
    }
    if(_S67)
    {
        return a_2 / b_2;
    }
    return (bitcast<f32>(((((((_S65 ^ (_S66))) & (u32(2147483648)))) | ((((exponent_2 << (u32(23)))) + (nearest_quotient_0(dividend_2, divisor_1, u32(f32(dividend_2) * (1.0f / f32(divisor_1)) * 8.388608e+06f)) - u32(8388608))))))));
}

fn normalize_vector_0( vector_1 : vec3<f32>) -> vec3<f32>
{
    return vector_1 * vec3<f32>(divide_0(1.0f, square_root_0(length_squared_0(vector_1))));
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
    var _S68 : u32 = id_1.x;
    if(_S68 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_1 : Reader_0 = Reader_x24init_0(u32(2) * _S68);
    var writer_1 : Writer_0 = Writer_x24init_0(u32(10) * _S68);
    var u_1 : f32 = Reader_number_0(&(reader_1));
    var v_2 : f32 = Reader_number_0(&(reader_1));
    var sin_cos_1 : vec2<f32> = sincos_turns_0(u_1);
    var vector_2 : vec3<f32> = cosine_hemisphere_0(u_1, v_2);
    Writer_number_0(&(writer_1), sin_cos_1.x);
    Writer_number_0(&(writer_1), sin_cos_1.y);
    Writer_vector_0(&(writer_1), vector_2);
    Writer_number_0(&(writer_1), cosine_hemisphere_pdf_0(vector_2.z));
    Writer_vector_0(&(writer_1), normalize_vector_0(vec3<f32>(u_1, v_2, 2.0f) - vector_2));
    Writer_number_0(&(writer_1), luminance_1(vector_2));
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_rounding(@builtin(global_invocation_id) id_2 : vec3<u32>, @builtin(local_invocation_index) thread_3 : u32)
{
    prove_0(thread_3);
    var _S69 : u32 = id_2.x;
    if(_S69 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_2 : Reader_0 = Reader_x24init_0(u32(6) * _S69);
    var writer_2 : Writer_0 = Writer_x24init_0(u32(4) * _S69);
    var a_3 : f32 = Reader_number_0(&(reader_2));
    var _S70 : f32 = Reader_number_0(&(reader_2));
    Writer_number_0(&(writer_2), divide_0(a_3, _S70));
    Writer_number_0(&(writer_2), square_root_0(abs(a_3)));
    var dividend_3 : u32 = Reader_word_0(&(reader_2));
    var divisor_2 : u32 = Reader_word_0(&(reader_2));
    var quotient_guess_0 : u32 = Reader_word_0(&(reader_2));
    Writer_word_0(&(writer_2), nearest_quotient_0(dividend_3, divisor_2, quotient_guess_0));
    var _S71 : u32 = Reader_word_0(&(reader_2));
    Writer_word_0(&(writer_2), nearest_root_0(dividend_3, _S71));
    return;
}

fn Reader_vector_0( this_16 : ptr<function, Reader_0>) -> vec3<f32>
{
    var x_3 : f32 = Reader_number_1(&((*this_16)));
    var y_0 : f32 = Reader_number_1(&((*this_16)));
    var _S72 : f32 = Reader_number_1(&((*this_16)));
    return vec3<f32>(x_3, y_0, _S72);
}

fn Reader_vector_1( this_17 : ptr<function, Reader_0>) -> vec3<f32>
{
    var x_4 : f32 = Reader_number_1(&((*this_17)));
    var y_1 : f32 = Reader_number_1(&((*this_17)));
    var _S73 : f32 = Reader_number_1(&((*this_17)));
    return vec3<f32>(x_4, y_1, _S73);
}

fn fixed_point_0( value_6 : f32) -> vec2<u32>
{
    if(!(value_6 > 0.0f))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    var bits_0 : u32 = (bitcast<u32>((min(value_6, 1.048576e+06f))));
    var shift_0 : i32 = i32((bits_0 >> (u32(23)))) - i32(118);
    var mantissa_2 : u32 = (((bits_0 & (u32(8388607)))) | (u32(8388608)));
    if(shift_0 <= i32(-24))
    {
        return vec2<u32>(vec2<i32>(i32(0)));
    }
    if(shift_0 < i32(0))
    {
        return vec2<u32>((mantissa_2 >> (u32(- shift_0))), u32(0));
    }
    if(shift_0 < i32(32))
    {
        var _S74 : u32 = (mantissa_2 << (u32(shift_0)));
        var _S75 : u32;
        if(shift_0 == i32(0))
        {
            _S75 = u32(0);
        }
        else
        {
            _S75 = (mantissa_2 >> (u32(i32(32) - shift_0)));
        }
        return vec2<u32>(_S74, _S75);
    }
    return vec2<u32>(u32(0), (mantissa_2 << (u32(shift_0 - i32(32)))));
}

struct PixelRecord_0
{
     radiance_1 : array<u32, i32(6)>,
     samples_1 : u32,
     covered_0 : u32,
};

fn PixelRecord_add_0( this_18 : ptr<function, PixelRecord_0>,  value_7 : vec3<f32>,  is_covered_0 : bool)
{
    var addend_0 : vec2<u32> = fixed_point_0(value_7[u32(0)]);
    var _S76 : u32 = addend_0.x;
    var low_2 : u32 = (*this_18).radiance_1[u32(0)] + _S76;
    var high_2 : u32 = (*this_18).radiance_1[u32(1)] + addend_0.y + u32(low_2 < _S76);
    var is_full_0 : bool = high_2 < ((*this_18).radiance_1[u32(1)]);
    var _S77 : u32;
    if(is_full_0)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = low_2;
    }
    (*this_18).radiance_1[u32(0)] = _S77;
    if(is_full_0)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = high_2;
    }
    (*this_18).radiance_1[u32(1)] = _S77;
    var addend_1 : vec2<u32> = fixed_point_0(value_7[u32(1)]);
    var _S78 : u32 = addend_1.x;
    var low_3 : u32 = (*this_18).radiance_1[u32(2)] + _S78;
    var high_3 : u32 = (*this_18).radiance_1[u32(3)] + addend_1.y + u32(low_3 < _S78);
    var is_full_1 : bool = high_3 < ((*this_18).radiance_1[u32(3)]);
    if(is_full_1)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = low_3;
    }
    (*this_18).radiance_1[u32(2)] = _S77;
    if(is_full_1)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = high_3;
    }
    (*this_18).radiance_1[u32(3)] = _S77;
    var addend_2 : vec2<u32> = fixed_point_0(value_7[u32(2)]);
    var _S79 : u32 = addend_2.x;
    var low_4 : u32 = (*this_18).radiance_1[u32(4)] + _S79;
    var high_4 : u32 = (*this_18).radiance_1[u32(5)] + addend_2.y + u32(low_4 < _S79);
    var is_full_2 : bool = high_4 < ((*this_18).radiance_1[u32(5)]);
    if(is_full_2)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = low_4;
    }
    (*this_18).radiance_1[u32(4)] = _S77;
    if(is_full_2)
    {
        _S77 = u32(4294967295);
    }
    else
    {
        _S77 = high_4;
    }
    (*this_18).radiance_1[u32(5)] = _S77;
    (*this_18).samples_1 = (*this_18).samples_1 + u32(1);
    (*this_18).covered_0 = (*this_18).covered_0 + u32(is_covered_0);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_film(@builtin(global_invocation_id) id_3 : vec3<u32>, @builtin(local_invocation_index) thread_4 : u32)
{
    prove_0(thread_4);
    var _S80 : u32 = id_3.x;
    if(_S80 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_3 : Reader_0 = Reader_x24init_0(u32(12) * _S80);
    var writer_3 : Writer_0 = Writer_x24init_0(u32(8) * _S80);
    var pixel_3 : PixelRecord_0;
    var word_5 : u32 = u32(0);
    for(;;)
    {
        if(word_5 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S81 : u32 = Reader_word_0(&(reader_3));
        pixel_3.radiance_1[word_5] = _S81;
        word_5 = word_5 + u32(1);
    }
    var _S82 : u32 = Reader_word_0(&(reader_3));
    pixel_3.samples_1 = _S82;
    var _S83 : u32 = Reader_word_0(&(reader_3));
    pixel_3.covered_0 = _S83;
    var radiance_2 : vec3<f32> = Reader_vector_0(&(reader_3));
    var _S84 : u32 = Reader_word_0(&(reader_3));
    PixelRecord_add_0(&(pixel_3), radiance_2, _S84 != u32(0));
    word_5 = u32(0);
    for(;;)
    {
        if(word_5 < u32(6))
        {
        }
        else
        {
            break;
        }
        Writer_word_0(&(writer_3), pixel_3.radiance_1[word_5]);
        word_5 = word_5 + u32(1);
    }
    Writer_word_0(&(writer_3), pixel_3.samples_1);
    Writer_word_0(&(writer_3), pixel_3.covered_0);
    return;
}

struct Transform_0
{
     x_axis_0 : array<f32, i32(3)>,
     y_axis_0 : array<f32, i32(3)>,
     z_axis_0 : array<f32, i32(3)>,
     translation_0 : array<f32, i32(3)>,
};

fn transform_of_0( a_4 : vec4<u32>,  b_3 : vec4<u32>,  c_1 : vec4<u32>) -> Transform_0
{
    var transform_0 : Transform_0;
    var _S85 : f32 = (bitcast<f32>((a_4.y)));
    var _S86 : f32 = (bitcast<f32>((a_4.z)));
    transform_0.x_axis_0[i32(0)] = (bitcast<f32>((a_4.x)));
    transform_0.x_axis_0[i32(1)] = _S85;
    transform_0.x_axis_0[i32(2)] = _S86;
    var _S87 : f32 = (bitcast<f32>((b_3.x)));
    var _S88 : f32 = (bitcast<f32>((b_3.y)));
    transform_0.y_axis_0[i32(0)] = (bitcast<f32>((a_4.w)));
    transform_0.y_axis_0[i32(1)] = _S87;
    transform_0.y_axis_0[i32(2)] = _S88;
    var _S89 : f32 = (bitcast<f32>((b_3.w)));
    var _S90 : f32 = (bitcast<f32>((c_1.x)));
    transform_0.z_axis_0[i32(0)] = (bitcast<f32>((b_3.z)));
    transform_0.z_axis_0[i32(1)] = _S89;
    transform_0.z_axis_0[i32(2)] = _S90;
    var _S91 : f32 = (bitcast<f32>((c_1.z)));
    var _S92 : f32 = (bitcast<f32>((c_1.w)));
    transform_0.translation_0[i32(0)] = (bitcast<f32>((c_1.y)));
    transform_0.translation_0[i32(1)] = _S91;
    transform_0.translation_0[i32(2)] = _S92;
    return transform_0;
}

struct PackedInstance_0
{
     grid_from_world_0 : Transform_0,
     world_from_grid_0 : Transform_0,
     grid_0 : u32,
     scene_instance_0 : u32,
     light_leaf_0 : u32,
};

fn PackedInstance_x24init_0( grid_from_world_1 : Transform_0,  world_from_grid_1 : Transform_0,  grid_1 : u32,  scene_instance_1 : u32,  light_leaf_1 : u32) -> PackedInstance_0
{
    var _S93 : PackedInstance_0;
    _S93.grid_from_world_0 = grid_from_world_1;
    _S93.world_from_grid_0 = world_from_grid_1;
    _S93.grid_0 = grid_1;
    _S93.scene_instance_0 = scene_instance_1;
    _S93.light_leaf_0 = light_leaf_1;
    return _S93;
}

fn Instances_operatorx5Bx5D_get_0( index_7 : u32) -> PackedInstance_0
{
    var row_6 : u32 = u32(7) * index_7;
    var _S94 : vec4<u32> = Rows_operatorx5Bx5D_get_5(row_6 + u32(6));
    return PackedInstance_x24init_0(transform_of_0(Rows_operatorx5Bx5D_get_5(row_6), Rows_operatorx5Bx5D_get_5(row_6 + u32(1)), Rows_operatorx5Bx5D_get_5(row_6 + u32(2))), transform_of_0(Rows_operatorx5Bx5D_get_5(row_6 + u32(3)), Rows_operatorx5Bx5D_get_5(row_6 + u32(4)), Rows_operatorx5Bx5D_get_5(row_6 + u32(5))), _S94.x, _S94.y, _S94.z);
}

struct PackedGrid_0
{
     origin_0 : array<i32, i32(3)>,
     top_shift_0 : u32,
     top_size_0 : array<i32, i32(3)>,
     top_offset_0 : u32,
     min_1 : array<i32, i32(3)>,
     voxels_0 : array<u32, i32(2)>,
     max_1 : array<i32, i32(3)>,
     material_bits_0 : u32,
};

fn Grids_operatorx5Bx5D_get_0( index_8 : u32) -> PackedGrid_0
{
    var row_7 : u32 = u32(5) * index_8;
    var _S95 : vec4<u32> = Rows_operatorx5Bx5D_get_4(row_7);
    var _S96 : vec4<u32> = Rows_operatorx5Bx5D_get_4(row_7 + u32(1));
    var _S97 : vec4<u32> = Rows_operatorx5Bx5D_get_4(row_7 + u32(2));
    var _S98 : vec4<u32> = Rows_operatorx5Bx5D_get_4(row_7 + u32(3));
    var grid_2 : PackedGrid_0;
    var _S99 : i32 = i32(_S95.y);
    var _S100 : i32 = i32(_S95.z);
    grid_2.origin_0[i32(0)] = i32(_S95.x);
    grid_2.origin_0[i32(1)] = _S99;
    grid_2.origin_0[i32(2)] = _S100;
    grid_2.top_shift_0 = _S95.w;
    var _S101 : i32 = i32(_S96.y);
    var _S102 : i32 = i32(_S96.z);
    grid_2.top_size_0[i32(0)] = i32(_S96.x);
    grid_2.top_size_0[i32(1)] = _S101;
    grid_2.top_size_0[i32(2)] = _S102;
    grid_2.top_offset_0 = _S96.w;
    var _S103 : i32 = i32(_S97.y);
    var _S104 : i32 = i32(_S97.z);
    grid_2.min_1[i32(0)] = i32(_S97.x);
    grid_2.min_1[i32(1)] = _S103;
    grid_2.min_1[i32(2)] = _S104;
    var _S105 : u32 = _S98.x;
    grid_2.voxels_0[i32(0)] = _S97.w;
    grid_2.voxels_0[i32(1)] = _S105;
    var _S106 : i32 = i32(_S98.z);
    var _S107 : i32 = i32(_S98.w);
    grid_2.max_1[i32(0)] = i32(_S98.y);
    grid_2.max_1[i32(1)] = _S106;
    grid_2.max_1[i32(2)] = _S107;
    grid_2.material_bits_0 = Rows_operatorx5Bx5D_get_4(row_7 + u32(4)).x;
    return grid_2;
}

fn Reader_cell_0( this_19 : ptr<function, Reader_0>) -> vec3<i32>
{
    var _S108 : u32 = Reader_word_1(&((*this_19)));
    var x_5 : i32 = i32(_S108);
    var _S109 : u32 = Reader_word_1(&((*this_19)));
    var y_2 : i32 = i32(_S109);
    var _S110 : u32 = Reader_word_1(&((*this_19)));
    return vec3<i32>(x_5, y_2, i32(_S110));
}

fn Reader_cell_1( this_20 : ptr<function, Reader_0>) -> vec3<i32>
{
    var _S111 : u32 = Reader_word_1(&((*this_20)));
    var x_6 : i32 = i32(_S111);
    var _S112 : u32 = Reader_word_1(&((*this_20)));
    var y_3 : i32 = i32(_S112);
    var _S113 : u32 = Reader_word_1(&((*this_20)));
    return vec3<i32>(x_6, y_3, i32(_S113));
}

fn cell_of_0( values_1 : array<i32, i32(3)>) -> vec3<i32>
{
    return vec3<i32>(values_1[i32(0)], values_1[i32(1)], values_1[i32(2)]);
}

fn place_of_cell_0( index_9 : u32) -> u32
{
    return index_9;
}

fn cell_word_0( index_10 : u32) -> u32
{
    return cells_0[place_of_cell_0(index_10)];
}

fn cell_in_node_0( relative_0 : vec3<i32>,  shift_1 : u32) -> u32
{
    var cell_0 : vec3<u32> = (((vec3<u32>(relative_0) >> (vec3<u32>(shift_1)))) & (vec3<u32>(u32(3))));
    return ((((cell_0.x) | ((((cell_0.y) << (u32(2))))))) | ((((cell_0.z) << (u32(4))))));
}

@id(4) override CELLS_HAVE_BLOCKS_0 : bool = false;

fn record_of_cell_0( cell_1 : u32) -> u32
{
    var _S114 : u32;
    if(CELLS_HAVE_BLOCKS_0)
    {
        _S114 = u32(8388607);
    }
    else
    {
        _S114 = u32(2147483647);
    }
    return ((cell_1 & (_S114))) * u32(2);
}

fn find_brick_0( grid_3 : PackedGrid_0,  relative_1 : vec3<i32>) -> u32
{
    var top_0 : vec3<i32> = (relative_1 >> (vec3<u32>(grid_3.top_shift_0)));
    var _S115 : bool;
    if((any((top_0 < vec3<i32>(i32(0))))))
    {
        _S115 = true;
    }
    else
    {
        _S115 = (any((top_0 >= (cell_of_0(grid_3.top_size_0)))));
    }
    if(_S115)
    {
        return u32(4294967295);
    }
    var cell_2 : u32 = cell_word_0(grid_3.top_offset_0 + u32((top_0.z * grid_3.top_size_0[i32(1)] + top_0.y) * grid_3.top_size_0[i32(0)] + top_0.x));
    var shift_2 : u32 = grid_3.top_shift_0;
    for(;;)
    {
        if(shift_2 > u32(3))
        {
            _S115 = ((cell_2 & (u32(2147483648)))) != u32(0);
        }
        else
        {
            _S115 = false;
        }
        if(_S115)
        {
        }
        else
        {
            break;
        }
        var shift_3 : u32 = shift_2 - u32(2);
        cell_2 = cell_word_0(((cell_2 & (u32(2147483647)))) * u32(64) + cell_in_node_0(relative_1, shift_3));
        shift_2 = shift_3;
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

fn place_of_brick_0( index_11 : u32) -> u32
{
    return index_11;
}

fn brick_word_0( index_12 : u32) -> u32
{
    return bricks_0[place_of_brick_0(index_12)];
}

fn rank_in_brick_0( record_0 : u32,  relative_2 : vec3<i32>) -> u32
{
    var bit_0 : u32 = cell_in_node_0(relative_2, u32(0));
    var present_before_0 : u32 = countOneBits(((brick_word_0(record_0)) & ((((u32(1) << (((((u32(((((relative_2.x) >> (u32(2)))) & (i32(1)))) | (((u32(((((relative_2.y) >> (u32(2)))) & (i32(1)))) << (u32(1))))))) | (((u32(((((relative_2.z) >> (u32(2)))) & (i32(1)))) << (u32(2)))))))))) - u32(1)))));
    var index_13 : u32 = u32(0);
    var rank_0 : u32 = u32(0);
    for(;;)
    {
        if(index_13 < present_before_0)
        {
        }
        else
        {
            break;
        }
        var _S116 : u32 = u32(2) * index_13;
        var rank_1 : u32 = rank_0 + (countOneBits(brick_word_0(record_0 + u32(2) + _S116)) + countOneBits(brick_word_0(record_0 + u32(3) + _S116)));
        index_13 = index_13 + u32(1);
        rank_0 = rank_1;
    }
    var _S117 : u32 = u32(2) * present_before_0;
    var low_5 : u32 = brick_word_0(record_0 + u32(2) + _S117);
    if(bit_0 < u32(32))
    {
        rank_0 = rank_0 + countOneBits((low_5 & ((((u32(1) << (bit_0))) - u32(1)))));
    }
    else
    {
        rank_0 = rank_0 + (countOneBits(low_5) + countOneBits(((brick_word_0(record_0 + u32(3) + _S117)) & ((((u32(1) << ((bit_0 - u32(32))))) - u32(1))))));
    }
    return rank_0;
}

fn place_of_material_0( index_14 : u32) -> u32
{
    return index_14;
}

fn material_word_0( index_15 : u32) -> u32
{
    return brick_materials_0[place_of_material_0(index_15)];
}

fn read_bits_0( start_0 : u32,  position_0 : u32,  count_3 : u32) -> u32
{
    if(count_3 == u32(0))
    {
        return u32(0);
    }
    var word_6 : u32 = start_0 + ((position_0 >> (u32(5))));
    var shift_4 : u32 = (position_0 & (u32(31)));
    var bits_1 : u32 = ((material_word_0(word_6)) >> (shift_4));
    var bits_2 : u32;
    if((shift_4 + count_3) > u32(32))
    {
        bits_2 = (bits_1 | ((((material_word_0(word_6 + u32(1))) << ((u32(32) - shift_4))))));
    }
    else
    {
        bits_2 = bits_1;
    }
    return (bits_2 & ((((u32(1) << (count_3))) - u32(1))));
}

fn material_of_rank_0( grid_4 : PackedGrid_0,  record_1 : u32,  rank_2 : u32) -> u32
{
    var header_0 : u32 = brick_word_0(record_1);
    var index_bits_0 : u32 = (((header_0 >> (u32(8)))) & (u32(255)));
    var palette_count_0 : u32 = (header_0 >> (u32(16)));
    var start_1 : u32 = brick_word_0(record_1 + u32(1));
    var index_16 : u32 = read_bits_0(start_1, palette_count_0 * grid_4.material_bits_0 + rank_2 * index_bits_0, index_bits_0);
    if(palette_count_0 == u32(0))
    {
        return index_16;
    }
    return read_bits_0(start_1, index_16 * grid_4.material_bits_0, grid_4.material_bits_0);
}

fn material_at_0( grid_5 : PackedGrid_0,  relative_3 : vec3<i32>) -> u32
{
    var record_2 : u32 = find_brick_0(grid_5, relative_3);
    return material_of_rank_0(grid_5, record_2, rank_in_brick_0(record_2, relative_3));
}

@compute
@workgroup_size(64, 1, 1)
fn check_material(@builtin(global_invocation_id) id_4 : vec3<u32>, @builtin(local_invocation_index) thread_5 : u32)
{
    prove_0(thread_5);
    var _S118 : u32 = id_4.x;
    if(_S118 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_4 : Reader_0 = Reader_x24init_0(u32(4) * _S118);
    var writer_4 : Writer_0 = Writer_x24init_0(_S118);
    var _S119 : u32 = Reader_word_0(&(reader_4));
    var _S120 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(_S119).grid_0);
    var _S121 : vec3<i32> = Reader_cell_0(&(reader_4));
    Writer_word_0(&(writer_4), material_at_0(_S120, _S121 - cell_of_0(_S120.origin_0)));
    return;
}

fn blocks_of_record_0( record_3 : u32) -> u32
{
    return ((brick_word_0(record_3)) & (u32(255)));
}

fn flip_of_0( octant_0 : u32) -> u32
{
    return ((((((octant_0 & (u32(1)))) | (((((octant_0 & (u32(2)))) << (u32(1))))))) | (((((octant_0 & (u32(4)))) << (u32(2))))))) * u32(3);
}

fn empty_around_0( record_4 : u32,  blocks_0 : u32,  voxel_1 : vec3<i32>,  octant_1 : u32,  flip_0 : u32) -> u32
{
    var block_0 : u32 = (((((u32(((((voxel_1.x) >> (u32(2)))) & (i32(1)))) | (u32(((((voxel_1.y) >> (u32(1)))) & (i32(2))))))) | (u32(((voxel_1.z) & (i32(4))))))) ^ (octant_1));
    if(((((blocks_0 >> (block_0))) & (u32(1)))) == u32(0))
    {
        return u32(3);
    }
    var bit_1 : u32 = ((cell_in_node_0(voxel_1, u32(0))) ^ (flip_0));
    var half_3 : u32 = brick_word_0(record_4 + u32(2) + u32(2) * countOneBits((blocks_0 & ((((u32(1) << (block_0))) - u32(1))))) + ((bit_1 >> (u32(5)))));
    if(((((half_3 >> (((bit_1 & (u32(31))))))) & (u32(1)))) != u32(0))
    {
        return u32(4294967295);
    }
    var _S122 : i32;
    if(((((half_3 >> (((bit_1 & (u32(10))))))) & (u32(3342387)))) == u32(0))
    {
        _S122 = i32(1);
    }
    else
    {
        _S122 = i32(0);
    }
    return u32(_S122);
}

@compute
@workgroup_size(64, 1, 1)
fn check_brick(@builtin(global_invocation_id) id_5 : vec3<u32>, @builtin(local_invocation_index) thread_6 : u32)
{
    prove_0(thread_6);
    var _S123 : u32 = id_5.x;
    if(_S123 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_5 : Reader_0 = Reader_x24init_0(u32(5) * _S123);
    var writer_5 : Writer_0 = Writer_x24init_0(_S123);
    var _S124 : u32 = Reader_word_0(&(reader_5));
    var _S125 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(_S124).grid_0);
    var _S126 : vec3<i32> = Reader_cell_0(&(reader_5));
    var voxel_2 : vec3<i32> = _S126 - cell_of_0(_S125.origin_0);
    var octant_2 : u32 = Reader_word_0(&(reader_5));
    var record_5 : u32 = find_brick_0(_S125, voxel_2);
    Writer_word_0(&(writer_5), empty_around_0(record_5, blocks_of_record_0(record_5), (voxel_2 ^ ((vec3<i32>(0) - vec3<i32>(i32((octant_2 & (u32(1)))), i32((((octant_2 >> (u32(1)))) & (u32(1)))), i32((octant_2 >> (u32(2)))))))), octant_2, flip_of_0(octant_2)));
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
    var _S127 : Ray_0;
    _S127.origin_1 = origin_2;
    _S127.t_min_0 = t_min_1;
    _S127.direction_1 = direction_2;
    _S127.t_max_0 = t_max_1;
    return _S127;
}

fn Reader_ray_0( this_21 : ptr<function, Reader_0>) -> Ray_0
{
    var origin_3 : vec3<f32> = Reader_vector_1(&((*this_21)));
    var t_min_2 : f32 = Reader_number_1(&((*this_21)));
    var direction_3 : vec3<f32> = Reader_vector_1(&((*this_21)));
    var _S128 : f32 = Reader_number_1(&((*this_21)));
    return Ray_x24init_0(origin_3, t_min_2, direction_3, _S128);
}

fn Transform_direction_0( this_22 : Transform_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vector_of_0(this_22.x_axis_0) * vec3<f32>(v_3.x) + vector_of_0(this_22.y_axis_0) * vec3<f32>(v_3.y) + vector_of_0(this_22.z_axis_0) * vec3<f32>(v_3.z);
}

fn Transform_point_0( this_23 : Transform_0,  v_4 : vec3<f32>) -> vec3<f32>
{
    return Transform_direction_0(this_23, v_4) + vector_of_0(this_23.translation_0);
}

fn reciprocal_0( vector_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(divide_0(1.0f, vector_3.x), divide_0(1.0f, vector_3.y), divide_0(1.0f, vector_3.z));
}

fn max_element_0( vector_4 : vec3<f32>) -> f32
{
    return max(max(vector_4.x, vector_4.y), vector_4.z);
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

fn local_ray_0( ray_0 : Ray_0,  grid_from_world_2 : Transform_0) -> LocalRay_0
{
    var local_0 : LocalRay_0;
    var direction_5 : vec3<f32>;
    var origin_5 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        var _S129 : vec3<f32> = Transform_point_0(grid_from_world_2, ray_0.origin_1);
        direction_5 = Transform_direction_0(grid_from_world_2, ray_0.direction_1);
        origin_5 = _S129;
    }
    else
    {
        direction_5 = ray_0.direction_1;
        origin_5 = ray_0.origin_1;
    }
    var is_zero_0 : vec3<bool> = !((abs(direction_5)) >= vec3<f32>(1.17549435082228751e-38f));
    var _S130 : vec3<f32> = select(direction_5, vec3<f32>(0.0f), is_zero_0);
    local_0.direction_4 = _S130;
    local_0.inverse_0 = select(reciprocal_0(select(direction_5, vec3<f32>(1.0f), is_zero_0)), vec3<f32>(3.4028234663852886e+38f), is_zero_0);
    local_0.origin_4 = select(origin_5, floor(origin_5) + vec3<f32>(0.5f), is_zero_0);
    var speed_0 : f32 = max_element_0(abs(_S130));
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
    local_0.t_min_3 = ray_0.t_min_0;
    local_0.t_max_2 = ray_0.t_max_0;
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
    var _S131 : u32 = id_6.x;
    if(_S131 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_6 : Reader_0 = Reader_x24init_0(u32(8) * _S131);
    var writer_6 : Writer_0 = Writer_x24init_0(u32(10) * _S131);
    var _S132 : Ray_0 = Reader_ray_0(&(reader_6));
    var local_1 : LocalRay_0 = local_ray_0(_S132, Instances_operatorx5Bx5D_get_0(u32(0)).grid_from_world_0);
    Writer_word_0(&(writer_6), u32(local_1.is_valid_0));
    var _S133 : vec3<f32>;
    if(local_1.is_valid_0)
    {
        _S133 = local_1.origin_4;
    }
    else
    {
        _S133 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S133);
    if(local_1.is_valid_0)
    {
        _S133 = local_1.direction_4;
    }
    else
    {
        _S133 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S133);
    if(local_1.is_valid_0)
    {
        _S133 = local_1.inverse_0;
    }
    else
    {
        _S133 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_6), _S133);
    return;
}

fn halves_0( value_8 : f32) -> vec2<f32>
{
    var high_5 : f32 = (bitcast<f32>((((bitcast<u32>((value_8))) & (u32(4294963200))))));
    return vec2<f32>(high_5, value_8 - high_5);
}

fn exact_product_0( a_5 : f32,  b_4 : f32) -> vec2<f32>
{
    var product_0 : f32 = a_5 * b_4;
    if(!IS_EXACT_0)
    {
        return vec2<f32>(product_0, 0.0f);
    }
    var a_parts_0 : vec2<f32> = halves_0(a_5);
    var b_parts_0 : vec2<f32> = halves_0(b_4);
    var _S134 : f32 = a_parts_0.x;
    var _S135 : f32 = b_parts_0.x;
    var _S136 : f32 = b_parts_0.y;
    var _S137 : f32 = a_parts_0.y;
    return vec2<f32>(product_0, _S134 * _S135 - product_0 + _S134 * _S136 + _S137 * _S135 + _S137 * _S136);
}

fn exact_start_voxel_0( ray_1 : LocalRay_0) -> vec3<i32>
{
    var way_0 : vec2<f32> = exact_product_0(ray_1.t_min_3, ray_1.direction_4[u32(0)]);
    var _S138 : f32 = way_0.x;
    var sum_0 : f32 = ray_1.origin_4[u32(0)] + _S138;
    var part_0 : f32 = sum_0 - ray_1.origin_4[u32(0)];
    var low_6 : f32 = ray_1.origin_4[u32(0)] - (sum_0 - part_0) + (_S138 - part_0) + way_0.y;
    var whole_0 : f32 = floor(sum_0);
    var voxel_3 : vec3<i32>;
    var _S139 : i32 = i32(whole_0);
    var _S140 : bool;
    if(sum_0 == whole_0)
    {
        _S140 = low_6 < 0.0f;
    }
    else
    {
        _S140 = false;
    }
    voxel_3[u32(0)] = _S139 - i32(_S140);
    var way_1 : vec2<f32> = exact_product_0(ray_1.t_min_3, ray_1.direction_4[u32(1)]);
    var _S141 : f32 = way_1.x;
    var sum_1 : f32 = ray_1.origin_4[u32(1)] + _S141;
    var part_1 : f32 = sum_1 - ray_1.origin_4[u32(1)];
    var low_7 : f32 = ray_1.origin_4[u32(1)] - (sum_1 - part_1) + (_S141 - part_1) + way_1.y;
    var whole_1 : f32 = floor(sum_1);
    var _S142 : i32 = i32(whole_1);
    if(sum_1 == whole_1)
    {
        _S140 = low_7 < 0.0f;
    }
    else
    {
        _S140 = false;
    }
    voxel_3[u32(1)] = _S142 - i32(_S140);
    var way_2 : vec2<f32> = exact_product_0(ray_1.t_min_3, ray_1.direction_4[u32(2)]);
    var _S143 : f32 = way_2.x;
    var sum_2 : f32 = ray_1.origin_4[u32(2)] + _S143;
    var part_2 : f32 = sum_2 - ray_1.origin_4[u32(2)];
    var low_8 : f32 = ray_1.origin_4[u32(2)] - (sum_2 - part_2) + (_S143 - part_2) + way_2.y;
    var whole_2 : f32 = floor(sum_2);
    var _S144 : i32 = i32(whole_2);
    if(sum_2 == whole_2)
    {
        _S140 = low_8 < 0.0f;
    }
    else
    {
        _S140 = false;
    }
    voxel_3[u32(2)] = _S144 - i32(_S140);
    return voxel_3;
}

fn Writer_cell_0( this_24 : ptr<function, Writer_0>,  value_9 : vec3<i32>)
{
    Writer_word_1(&((*this_24)), u32(value_9.x));
    Writer_word_1(&((*this_24)), u32(value_9.y));
    Writer_word_1(&((*this_24)), u32(value_9.z));
    return;
}

struct Crossing_0
{
     distance_0 : f32,
     distance_low_0 : f32,
     speed_1 : f32,
     axis_0 : u32,
};

fn Crossing_x24init_0( distance_1 : f32,  distance_low_1 : f32,  speed_2 : f32,  axis_1 : u32) -> Crossing_0
{
    var _S145 : Crossing_0;
    _S145.distance_0 = distance_1;
    _S145.distance_low_0 = distance_low_1;
    _S145.speed_1 = speed_2;
    _S145.axis_0 = axis_1;
    return _S145;
}

fn crossing_ahead_0( origin_6 : f32,  speed_3 : f32,  axis_2 : u32,  plane_0 : i32) -> Crossing_0
{
    var at_5 : f32 = f32(plane_0);
    var difference_0 : f32 = at_5 - origin_6;
    var part_3 : f32 = difference_0 - at_5;
    return Crossing_x24init_0(difference_0, at_5 - (difference_0 - part_3) - (origin_6 + part_3), speed_3, axis_2);
}

fn Crossing_is_before_0( this_25 : Crossing_0,  other_0 : Crossing_0) -> bool
{
    var ours_0 : vec2<f32> = exact_product_0(this_25.distance_0, other_0.speed_1);
    var theirs_0 : vec2<f32> = exact_product_0(other_0.distance_0, this_25.speed_1);
    if(IS_EXACT_0)
    {
        ours_0[i32(1)] = ours_0[i32(1)] + this_25.distance_low_0 * other_0.speed_1;
        theirs_0[i32(1)] = theirs_0[i32(1)] + other_0.distance_low_0 * this_25.speed_1;
    }
    var difference_1 : f32 = ours_0.x - theirs_0.x + (ours_0.y - theirs_0.y);
    var _S146 : bool;
    if(difference_1 < 0.0f)
    {
        _S146 = true;
    }
    else
    {
        if(difference_1 == 0.0f)
        {
            _S146 = (this_25.axis_0) < (other_0.axis_0);
        }
        else
        {
            _S146 = false;
        }
    }
    return _S146;
}

fn crossing_among_0( origin_7 : vec3<f32>,  speed_4 : vec3<f32>,  planes_1 : vec3<i32>,  is_first_0 : bool) -> Crossing_0
{
    var _S147 : bool;
    var found_0 : Crossing_0;
    var _S148 : Crossing_0 = Crossing_x24init_0(0.0f, 0.0f, 0.0f, u32(3));
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if((speed_4[u32(0)]) == 0.0f)
                {
                    found_0 = _S148;
                    break;
                }
                var crossing_0 : Crossing_0 = crossing_ahead_0(origin_7[u32(0)], speed_4[u32(0)], u32(0), planes_1[u32(0)]);
                if((_S148.axis_0) == u32(3))
                {
                    _S147 = true;
                }
                else
                {
                    _S147 = (Crossing_is_before_0(crossing_0, _S148)) == is_first_0;
                }
                if(_S147)
                {
                    found_0 = crossing_0;
                }
                else
                {
                    found_0 = _S148;
                }
                break;
            }
            break;
        }
        for(;;)
        {
            for(;;)
            {
                if((speed_4[u32(1)]) == 0.0f)
                {
                    break;
                }
                var crossing_1 : Crossing_0 = crossing_ahead_0(origin_7[u32(1)], speed_4[u32(1)], u32(1), planes_1[u32(1)]);
                if((found_0.axis_0) == u32(3))
                {
                    _S147 = true;
                }
                else
                {
                    _S147 = (Crossing_is_before_0(crossing_1, found_0)) == is_first_0;
                }
                if(_S147)
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
                if((speed_4[u32(2)]) == 0.0f)
                {
                    break;
                }
                var crossing_2 : Crossing_0 = crossing_ahead_0(origin_7[u32(2)], speed_4[u32(2)], u32(2), planes_1[u32(2)]);
                if((found_0.axis_0) == u32(3))
                {
                    _S147 = true;
                }
                else
                {
                    _S147 = (Crossing_is_before_0(crossing_2, found_0)) == is_first_0;
                }
                if(_S147)
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

fn leave_box_0( origin_8 : vec3<f32>,  speed_5 : vec3<f32>,  voxel_4 : vec3<i32>,  exit_0 : vec3<i32>,  nearest_0 : vec3<i32>) -> vec3<i32>
{
    var is_crossed_0 : bool;
    var plane_1 : i32;
    var _S149 : Crossing_0 = crossing_among_0(origin_8, speed_5, exit_0, true);
    var arrival_0 : vec3<i32> = voxel_4;
    for(;;)
    {
        for(;;)
        {
            for(;;)
            {
                if((speed_5[u32(0)]) == 0.0f)
                {
                    break;
                }
                var _S150 : bool = u32(0) == (_S149.axis_0);
                if(_S150)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(0)], speed_5[u32(0)], u32(0), nearest_0[u32(0)]), _S149);
                }
                if(_S150)
                {
                    plane_1 = exit_0[u32(0)];
                }
                else
                {
                    plane_1 = nearest_0[u32(0)];
                }
                arrival_0[u32(0)] = plane_1 - i32(!is_crossed_0);
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
                var _S151 : bool = u32(1) == (_S149.axis_0);
                if(_S151)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(1)], speed_5[u32(1)], u32(1), nearest_0[u32(1)]), _S149);
                }
                if(_S151)
                {
                    plane_1 = exit_0[u32(1)];
                }
                else
                {
                    plane_1 = nearest_0[u32(1)];
                }
                arrival_0[u32(1)] = plane_1 - i32(!is_crossed_0);
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
                var _S152 : bool = u32(2) == (_S149.axis_0);
                if(_S152)
                {
                    is_crossed_0 = true;
                }
                else
                {
                    is_crossed_0 = Crossing_is_before_0(crossing_ahead_0(origin_8[u32(2)], speed_5[u32(2)], u32(2), nearest_0[u32(2)]), _S149);
                }
                if(_S152)
                {
                    plane_1 = exit_0[u32(2)];
                }
                else
                {
                    plane_1 = nearest_0[u32(2)];
                }
                arrival_0[u32(2)] = plane_1 - i32(!is_crossed_0);
                break;
            }
            break;
        }
        break;
    }
    return arrival_0;
}

fn LocalRay_mirrored_origin_0( this_26 : LocalRay_0) -> vec3<f32>
{
    return select(this_26.origin_4, (vec3<f32>(0) - this_26.origin_4), (this_26.direction_4) < vec3<f32>(0.0f));
}

fn LocalRay_octant_0( this_27 : LocalRay_0) -> u32
{
    return (((u32((this_27.direction_4.x) < 0.0f) | (((u32((this_27.direction_4.y) < 0.0f) << (u32(1))))))) | (((u32((this_27.direction_4.z) < 0.0f) << (u32(2))))));
}

fn Hit_x24init_0( t_1 : f32,  instance_1 : u32,  voxel_5 : vec3<i32>,  face_1 : u32) -> Hit_0
{
    var _S153 : Hit_0;
    _S153.t_0 = t_1;
    _S153.instance_0 = instance_1;
    _S153.voxel_0 = voxel_5;
    _S153.face_0 = face_1;
    return _S153;
}

fn hit_at_0( last_0 : Crossing_0,  t_min_4 : f32,  inverse_1 : vec3<f32>,  voxel_6 : vec3<i32>,  instance_2 : u32,  octant_3 : u32) -> Hit_0
{
    var t_2 : f32 = last_0.distance_0 * inverse_1[last_0.axis_0];
    var _S154 : f32;
    if(t_2 > t_min_4)
    {
        _S154 = t_2;
    }
    else
    {
        _S154 = t_min_4;
    }
    return Hit_x24init_0(_S154, instance_2, voxel_6, u32(2) * last_0.axis_0 + ((((octant_3 >> ((last_0.axis_0)))) & (u32(1)))));
}

fn hit_of_0( ray_2 : LocalRay_0,  voxel_7 : vec3<i32>,  instance_3 : u32) -> Hit_0
{
    return hit_at_0(crossing_among_0(LocalRay_mirrored_origin_0(ray_2), abs(ray_2.direction_4), select(voxel_7, ~voxel_7, (ray_2.direction_4) < vec3<f32>(0.0f)), false), ray_2.t_min_3, abs(ray_2.inverse_0), voxel_7, instance_3, LocalRay_octant_0(ray_2));
}

@compute
@workgroup_size(64, 1, 1)
fn check_exact(@builtin(global_invocation_id) id_7 : vec3<u32>, @builtin(local_invocation_index) thread_8 : u32)
{
    prove_0(thread_8);
    var _S155 : u32 = id_7.x;
    if(_S155 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_7 : Reader_0 = Reader_x24init_0(u32(17) * _S155);
    var writer_7 : Writer_0 = Writer_x24init_0(u32(8) * _S155);
    var _S156 : Ray_0 = Reader_ray_0(&(reader_7));
    var local_2 : LocalRay_0 = local_ray_0(_S156, Instances_operatorx5Bx5D_get_0(u32(0)).grid_from_world_0);
    var voxel_8 : vec3<i32> = Reader_cell_0(&(reader_7));
    var exit_1 : vec3<i32> = Reader_cell_0(&(reader_7));
    Writer_cell_0(&(writer_7), exact_start_voxel_0(local_2));
    var _S157 : vec3<bool> = (local_2.direction_4) < vec3<f32>(0.0f);
    var mirror_0 : vec3<i32> = select(vec3<i32>(i32(0)), vec3<i32>(i32(-1)), _S157);
    var origin_9 : vec3<f32> = select(local_2.origin_4, (vec3<f32>(0) - local_2.origin_4), _S157);
    var _S158 : vec3<f32> = abs(local_2.direction_4);
    var _S159 : vec3<i32> = (voxel_8 ^ (mirror_0));
    var _S160 : vec3<i32> = ((exit_1 ^ (mirror_0))) - mirror_0;
    var _S161 : vec3<i32> = Reader_cell_0(&(reader_7));
    Writer_cell_0(&(writer_7), ((max(leave_box_0(origin_9, _S158, _S159, _S160, ((_S161 ^ (mirror_0))) - mirror_0), _S159)) ^ (mirror_0)));
    var hit_1 : Hit_0 = hit_of_0(local_2, voxel_8, u32(0));
    Writer_number_0(&(writer_7), hit_1.t_0);
    Writer_word_0(&(writer_7), hit_1.face_0);
    return;
}

fn Reader_hit_0( this_28 : ptr<function, Reader_0>) -> Hit_0
{
    var t_3 : f32 = Reader_number_1(&((*this_28)));
    var instance_4 : u32 = Reader_word_1(&((*this_28)));
    var voxel_9 : vec3<i32> = Reader_cell_1(&((*this_28)));
    var _S162 : u32 = Reader_word_1(&((*this_28)));
    return Hit_x24init_0(t_3, instance_4, voxel_9, _S162);
}

@id(7) override HAS_CUTS_0 : bool = false;

fn is_cut_0( hit_2 : Hit_0) -> bool
{
    return (hit_2.face_0) >= u32(6);
}

fn cut_normal_0( face_2 : u32) -> vec3<f32>
{
    var normal_1 : vec3<f32> = params_0.planes_0[((face_2 - u32(6)) >> (u32(1)))].xyz;
    var _S163 : vec3<f32>;
    if(((face_2 & (u32(1)))) == u32(1))
    {
        _S163 = (vec3<f32>(0) - normal_1);
    }
    else
    {
        _S163 = normal_1;
    }
    return _S163;
}

fn cut_margin_0( face_3 : u32) -> f32
{
    return clamp(abs(params_0.planes_0[((face_3 - u32(6)) >> (u32(1)))].w) * 9.5367431640625e-07f, 0.0009765625f, 0.25f);
}

fn leaves_cut_0( hit_3 : Hit_0) -> bool
{
    var _S164 : bool;
    if(is_cut_0(hit_3))
    {
        _S164 = (((hit_3.face_0) & (u32(1)))) == u32(1);
    }
    else
    {
        _S164 = false;
    }
    return _S164;
}

fn margin_of_0( translation_1 : vec3<f32>,  low_9 : vec3<f32>) -> f32
{
    return clamp((max_element_0(abs(low_9) + abs(translation_1)) + 1.0f) * 4.76837158203125e-07f, 0.0009765625f, 0.25f);
}

fn clamp_to_voxel_0( translation_2 : vec3<f32>,  low_10 : vec3<f32>,  point_2 : vec3<f32>) -> vec3<f32>
{
    var margin_0 : f32 = margin_of_0(translation_2, low_10);
    return min(max(point_2, low_10 + vec3<f32>(margin_0)), low_10 + vec3<f32>((1.0f - margin_0)));
}

fn in_voxel_0( hit_4 : Hit_0,  point_3 : vec3<f32>) -> vec3<f32>
{
    var _S165 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(hit_4.instance_0);
    return Transform_point_0(_S165.world_from_grid_0, clamp_to_voxel_0(vector_of_0(_S165.grid_from_world_0.translation_0), vec3<f32>(hit_4.voxel_0), Transform_point_0(_S165.grid_from_world_0, point_3)));
}

fn before_cut_0( ray_3 : Ray_0,  hit_5 : Hit_0,  normal_2 : vec3<f32>) -> vec3<f32>
{
    var point_4 : vec3<f32> = ray_3.origin_1 + ray_3.direction_1 * vec3<f32>(hit_5.t_0) + normal_2 * vec3<f32>(cut_margin_0(hit_5.face_0));
    var _S166 : vec3<f32>;
    if(leaves_cut_0(hit_5))
    {
        _S166 = in_voxel_0(hit_5, point_4);
    }
    else
    {
        _S166 = point_4;
    }
    return _S166;
}

fn offset_ray_origin_0( translation_3 : vec3<f32>,  low_11 : vec3<f32>,  face_4 : u32,  point_5 : vec3<f32>) -> vec3<f32>
{
    var margin_1 : f32 = margin_of_0(translation_3, low_11);
    var _S167 : vec3<f32> = vec3<f32>(margin_1);
    var moved_0 : vec3<f32> = min(max(point_5, low_11 + _S167), low_11 + vec3<f32>((1.0f - margin_1)));
    var _S168 : bool = face_4 < u32(2);
    var _S169 : bool;
    if(face_4 >= u32(2))
    {
        _S169 = face_4 < u32(4);
    }
    else
    {
        _S169 = false;
    }
    var is_axis_0 : vec3<bool> = vec3<bool>(_S168, _S169, face_4 >= u32(4));
    var outside_0 : vec3<f32>;
    if(((face_4 & (u32(1)))) == u32(1))
    {
        outside_0 = low_11 + vec3<f32>((1.0f + margin_1));
    }
    else
    {
        outside_0 = low_11 - _S167;
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
    var _S170 : f32;
    if(face_5 < u32(2))
    {
        _S170 = away_0;
    }
    else
    {
        _S170 = 0.0f;
    }
    var _S171 : bool;
    if(face_5 >= u32(2))
    {
        _S171 = face_5 < u32(4);
    }
    else
    {
        _S171 = false;
    }
    var _S172 : f32;
    if(_S171)
    {
        _S172 = away_0;
    }
    else
    {
        _S172 = 0.0f;
    }
    if(face_5 >= u32(4))
    {
    }
    else
    {
        away_0 = 0.0f;
    }
    return vec3<f32>(_S170, _S172, away_0);
}

fn world_normal_0( instance_5 : PackedInstance_0,  face_6 : u32) -> vec3<f32>
{
    return normalize_vector_0(Transform_direction_0(instance_5.world_from_grid_0, face_normal_0(face_6)));
}

struct Surface_0
{
     origin_10 : vec3<f32>,
     normal_3 : vec3<f32>,
     face_7 : u32,
     instance_6 : u32,
};

fn surface_of_0( ray_4 : Ray_0,  hit_6 : Hit_0) -> Surface_0
{
    var surface_0 : Surface_0;
    var _S173 : vec3<f32> = vec3<f32>(hit_6.voxel_0);
    var _S174 : bool;
    if(HAS_CUTS_0)
    {
        _S174 = is_cut_0(hit_6);
    }
    else
    {
        _S174 = false;
    }
    if(_S174)
    {
        var _S175 : vec3<f32> = cut_normal_0(hit_6.face_0);
        surface_0.normal_3 = _S175;
        surface_0.origin_10 = before_cut_0(ray_4, hit_6, _S175);
    }
    else
    {
        if(IS_SINGLE_0)
        {
            surface_0.origin_10 = offset_ray_origin_0(vec3<f32>(0.0f), _S173, hit_6.face_0, ray_4.origin_1 + ray_4.direction_1 * vec3<f32>(hit_6.t_0));
            surface_0.normal_3 = face_normal_0(hit_6.face_0);
        }
        else
        {
            var _S176 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(hit_6.instance_0);
            surface_0.origin_10 = Transform_point_0(_S176.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S176.grid_from_world_0.translation_0), _S173, hit_6.face_0, Transform_point_0(_S176.grid_from_world_0, ray_4.origin_1) + Transform_direction_0(_S176.grid_from_world_0, ray_4.direction_1) * vec3<f32>(hit_6.t_0)));
            surface_0.normal_3 = world_normal_0(_S176, hit_6.face_0);
        }
    }
    surface_0.face_7 = hit_6.face_0;
    surface_0.instance_6 = hit_6.instance_0;
    return surface_0;
}

@id(10) override HAS_NORMALS_0 : bool = false;

fn orthonormal_pair_0( z_0 : vec3<f32>,  x_7 : ptr<function, vec3<f32>>,  y_4 : ptr<function, vec3<f32>>)
{
    var _S177 : f32 = z_0.z;
    var sign_0 : f32;
    if(_S177 < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_6 : f32 = divide_0(-1.0f, sign_0 + _S177);
    var _S178 : f32 = z_0.x;
    var _S179 : f32 = z_0.y;
    var b_5 : f32 = _S178 * _S179 * a_6;
    (*x_7) = vec3<f32>(1.0f + sign_0 * _S178 * _S178 * a_6, sign_0 * b_5, - sign_0 * _S178);
    (*y_4) = vec3<f32>(b_5, sign_0 + _S179 * _S179 * a_6, - _S179);
    return;
}

fn orthonormal_pair_1( z_1 : vec3<f32>,  x_8 : ptr<function, vec3<f32>>,  y_5 : ptr<function, vec3<f32>>)
{
    var _S180 : f32 = z_1.z;
    var sign_1 : f32;
    if(_S180 < 0.0f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_7 : f32 = divide_0(-1.0f, sign_1 + _S180);
    var _S181 : f32 = z_1.x;
    var _S182 : f32 = z_1.y;
    var b_6 : f32 = _S181 * _S182 * a_7;
    (*x_8) = vec3<f32>(1.0f + sign_1 * _S181 * _S181 * a_7, sign_1 * b_6, - sign_1 * _S181);
    (*y_5) = vec3<f32>(b_6, sign_1 + _S182 * _S182 * a_7, - _S182);
    return;
}

fn Surface_world_direction_0( this_29 : Surface_0,  local_3 : vec3<f32>) -> vec3<f32>
{
    var _S183 : bool;
    if(HAS_CUTS_0)
    {
        _S183 = true;
    }
    else
    {
        _S183 = HAS_NORMALS_0;
    }
    if(_S183)
    {
        _S183 = (this_29.face_7) >= u32(6);
    }
    else
    {
        _S183 = false;
    }
    if(_S183)
    {
        var x_9 : vec3<f32>;
        var y_6 : vec3<f32>;
        orthonormal_pair_0(this_29.normal_3, &(x_9), &(y_6));
        return normalize_vector_0(x_9 * vec3<f32>(local_3.x) + y_6 * vec3<f32>(local_3.y) + this_29.normal_3 * vec3<f32>(local_3.z));
    }
    var away_1 : f32;
    if((((this_29.face_7) & (u32(1)))) == u32(1))
    {
        away_1 = local_3.z;
    }
    else
    {
        away_1 = - local_3.z;
    }
    var _S184 : f32 = local_3.x;
    var _S185 : f32 = local_3.y;
    var _S186 : vec3<f32> = vec3<f32>(_S184, _S185, away_1);
    var in_grid_0 : vec3<f32>;
    if((this_29.face_7) < u32(2))
    {
        in_grid_0 = vec3<f32>(away_1, _S184, _S185);
    }
    else
    {
        if((this_29.face_7) < u32(4))
        {
            in_grid_0 = vec3<f32>(_S185, away_1, _S184);
        }
        else
        {
            in_grid_0 = _S186;
        }
    }
    if(!IS_SINGLE_0)
    {
        in_grid_0 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_29.instance_6).world_from_grid_0, in_grid_0);
    }
    return normalize_vector_0(in_grid_0);
}

fn Surface_local_direction_0( this_30 : Surface_0,  world_0 : vec3<f32>) -> vec3<f32>
{
    var _S187 : bool;
    if(HAS_CUTS_0)
    {
        _S187 = true;
    }
    else
    {
        _S187 = HAS_NORMALS_0;
    }
    if(_S187)
    {
        _S187 = (this_30.face_7) >= u32(6);
    }
    else
    {
        _S187 = false;
    }
    if(_S187)
    {
        var x_10 : vec3<f32>;
        var y_7 : vec3<f32>;
        orthonormal_pair_0(this_30.normal_3, &(x_10), &(y_7));
        var unit_1 : vec3<f32> = normalize_vector_0(world_0);
        return vec3<f32>(dot_product_0(x_10, unit_1), dot_product_0(y_7, unit_1), dot_product_0(this_30.normal_3, unit_1));
    }
    var in_grid_1 : vec3<f32>;
    if(!IS_SINGLE_0)
    {
        in_grid_1 = Transform_direction_0(Instances_operatorx5Bx5D_get_0(this_30.instance_6).grid_from_world_0, world_0);
    }
    else
    {
        in_grid_1 = world_0;
    }
    var in_grid_2 : vec3<f32> = normalize_vector_0(in_grid_1);
    var local_4 : vec3<f32>;
    if((this_30.face_7) < u32(2))
    {
        local_4 = in_grid_2.yzx;
    }
    else
    {
        if((this_30.face_7) < u32(4))
        {
            local_4 = in_grid_2.zxy;
        }
        else
        {
            local_4 = in_grid_2;
        }
    }
    if((((this_30.face_7) & (u32(1)))) == u32(1))
    {
        in_grid_1 = local_4;
    }
    else
    {
        in_grid_1 = vec3<f32>(local_4.xy, - local_4.z);
    }
    return in_grid_1;
}

@compute
@workgroup_size(64, 1, 1)
fn check_surface(@builtin(global_invocation_id) id_8 : vec3<u32>, @builtin(local_invocation_index) thread_9 : u32)
{
    prove_0(thread_9);
    var _S188 : u32 = id_8.x;
    if(_S188 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_8 : Reader_0 = Reader_x24init_0(u32(17) * _S188);
    var writer_8 : Writer_0 = Writer_x24init_0(u32(12) * _S188);
    var ray_5 : Ray_0 = Reader_ray_0(&(reader_8));
    var _S189 : Hit_0 = Reader_hit_0(&(reader_8));
    var surface_1 : Surface_0 = surface_of_0(ray_5, _S189);
    Writer_vector_0(&(writer_8), surface_1.origin_10);
    Writer_vector_0(&(writer_8), surface_1.normal_3);
    var direction_6 : vec3<f32> = Reader_vector_0(&(reader_8));
    Writer_vector_0(&(writer_8), Surface_world_direction_0(surface_1, direction_6));
    Writer_vector_0(&(writer_8), Surface_local_direction_0(surface_1, direction_6));
    return;
}

fn Receiver_x24init_0( point_6 : vec3<f32>,  normal_4 : vec3<f32>) -> Receiver_0
{
    var _S190 : Receiver_0;
    _S190.point_0 = point_6;
    _S190.normal_0 = normal_4;
    return _S190;
}

fn has_sun_0() -> bool
{
    return (params_0.sun_irradiance_0) > 0.0f;
}

fn Lights_sun_cosine_0( receiver_4 : Receiver_0) -> f32
{
    var _S191 : f32;
    if((Receiver_slack_0(receiver_4)) > 0.0f)
    {
        _S191 = 1.0f;
    }
    else
    {
        _S191 = dot_product_0(receiver_4.normal_0, params_0.sun_direction_0);
    }
    return _S191;
}

fn importance_of_all_0( receiver_5 : Receiver_0) -> f32
{
    if((params_0.light_node_count_0) == u32(0))
    {
        return 0.0f;
    }
    return view_0(top_light_node_0(u32(0)), receiver_5).importance_0 * params_0.light_intensity_0;
}

fn EmitterTree_importance_0( receiver_6 : Receiver_0) -> f32
{
    return importance_of_all_0(receiver_6);
}

fn Lights_sun_probability_0( receiver_7 : Receiver_0) -> f32
{
    if(!has_sun_0())
    {
        return 0.0f;
    }
    var cos_theta_1 : f32 = Lights_sun_cosine_0(receiver_7);
    if(cos_theta_1 <= (- params_0.sun_sin_radius_0))
    {
        return 0.0f;
    }
    var from_emitters_0 : f32 = EmitterTree_importance_0(receiver_7);
    if(from_emitters_0 <= 0.0f)
    {
        return 1.0f;
    }
    var from_sun_0 : f32 = params_0.sun_irradiance_0 * max(cos_theta_1, 0.0f);
    return clamp(divide_0(from_sun_0, from_sun_0 + from_emitters_0), 0.25f, 0.75f);
}

fn Lights_has_chosen_sky_0() -> bool
{
    var _S192 : bool;
    if(SKY_0 == u32(1))
    {
        _S192 = (params_0.sky_irradiance_0) > 0.0f;
    }
    else
    {
        _S192 = false;
    }
    return _S192;
}

struct Selection_0
{
     sun_0 : f32,
     sky_1 : f32,
     emitters_0 : f32,
};

fn Selection_x24init_0( sun_1 : f32,  sky_2 : f32,  emitters_1 : f32) -> Selection_0
{
    var _S193 : Selection_0;
    _S193.sun_0 = sun_1;
    _S193.sky_1 = sky_2;
    _S193.emitters_0 = emitters_1;
    return _S193;
}

fn Lights_sky_probability_0( receiver_8 : Receiver_0) -> f32
{
    var from_sun_1 : f32;
    if(has_sun_0())
    {
        from_sun_1 = params_0.sun_irradiance_0 * max(Lights_sun_cosine_0(receiver_8), 0.0f);
    }
    else
    {
        from_sun_1 = 0.0f;
    }
    var from_others_0 : f32 = from_sun_1 + EmitterTree_importance_0(receiver_8);
    if(from_others_0 <= 0.0f)
    {
        return 1.0f;
    }
    return clamp(divide_0(params_0.sky_irradiance_0, params_0.sky_irradiance_0 + from_others_0), 0.25f, 0.75f);
}

fn Lights_selection_0( receiver_9 : Receiver_0) -> Selection_0
{
    var sun_2 : f32 = Lights_sun_probability_0(receiver_9);
    if(!Lights_has_chosen_sky_0())
    {
        return Selection_x24init_0(sun_2, 0.0f, 1.0f - sun_2);
    }
    var sky_3 : f32 = Lights_sky_probability_0(receiver_9);
    var _S194 : f32 = 1.0f - sky_3;
    return Selection_x24init_0(sun_2 * _S194, sky_3, (1.0f - sun_2) * _S194);
}

fn miss_0() -> Hit_0
{
    return Hit_x24init_0((bitcast<f32>(infinity_bits_0)), u32(4294967295), vec3<i32>(i32(0)), u32(0));
}

fn Aim_x24init_0( is_met_1 : bool,  direction_7 : vec3<f32>,  hit_7 : Hit_0,  luminance_2 : f32) -> Aim_0
{
    var _S195 : Aim_0;
    _S195.is_met_0 = is_met_1;
    _S195.direction_0 = direction_7;
    _S195.hit_0 = hit_7;
    _S195.luminance_0 = luminance_2;
    return _S195;
}

fn by_chance_0() -> Aim_0
{
    return Aim_x24init_0(false, vec3<f32>(0.0f), miss_0(), 0.0f);
}

fn ray_from_0( origin_11 : vec3<f32>,  direction_8 : vec3<f32>) -> Ray_0
{
    return Ray_x24init_0(origin_11, 0.0f, direction_8, (bitcast<f32>(infinity_bits_0)));
}

struct LightSample_0
{
     ray_6 : Ray_0,
     cos_theta_2 : f32,
     radiance_3 : vec3<f32>,
     pdf_1 : f32,
};

fn LightSample_x24init_0( ray_7 : Ray_0,  cos_theta_3 : f32,  radiance_4 : vec3<f32>,  pdf_2 : f32) -> LightSample_0
{
    var _S196 : LightSample_0;
    _S196.ray_6 = ray_7;
    _S196.cos_theta_2 = cos_theta_3;
    _S196.radiance_3 = radiance_4;
    _S196.pdf_1 = pdf_2;
    return _S196;
}

fn SunDisc_sample_0( receiver_10 : Receiver_0,  u_2 : vec4<f32>,  sample_3 : ptr<function, LightSample_0>) -> bool
{
    var one_minus_cos_theta_0 : f32 = u_2.z * params_0.sun_one_minus_cos_theta_max_0;
    var radius_1 : f32 = square_root_0(one_minus_cos_theta_0 * (2.0f - one_minus_cos_theta_0));
    var sin_cos_2 : vec2<f32> = sincos_turns_0(u_2.w);
    var direction_9 : vec3<f32> = params_0.sun_direction_0 * vec3<f32>((1.0f - one_minus_cos_theta_0)) + (params_0.sun_tangent_0 * vec3<f32>((radius_1 * sin_cos_2.y)) + params_0.sun_bitangent_0 * vec3<f32>((radius_1 * sin_cos_2.x)));
    var cos_theta_4 : f32 = with_slack_0(receiver_10, dot_product_0(receiver_10.normal_0, direction_9));
    (*sample_3) = LightSample_x24init_0(ray_from_0(receiver_10.point_0, direction_9), cos_theta_4, params_0.sun_radiance_0, params_0.sun_pdf_0);
    return cos_theta_4 > 0.0f;
}

fn no_light_0() -> LightSample_0
{
    var _S197 : vec3<f32> = vec3<f32>(0.0f);
    return LightSample_x24init_0(Ray_x24init_0(_S197, 0.0f, _S197, 0.0f), 0.0f, _S197, 0.0f);
}

struct ChosenDirection_0
{
     direction_10 : vec3<f32>,
     radiance_5 : vec3<f32>,
     pdf_3 : f32,
};

fn ChosenDirection_x24init_0( direction_11 : vec3<f32>,  radiance_6 : vec3<f32>,  pdf_4 : f32) -> ChosenDirection_0
{
    var _S198 : ChosenDirection_0;
    _S198.direction_10 = direction_11;
    _S198.radiance_5 = radiance_6;
    _S198.pdf_3 = pdf_4;
    return _S198;
}

fn direction_of_0( square_0 : vec2<f32>) -> vec3<f32>
{
    var u_3 : f32 = square_0.x * 2.0f - 1.0f;
    var v_5 : f32 = square_0.y * 2.0f - 1.0f;
    var _S199 : f32 = abs(u_3);
    var _S200 : f32 = abs(v_5);
    var height_1 : f32 = 1.0f - (_S199 + _S200);
    var radius_2 : f32 = 1.0f - abs(height_1);
    var turns_1 : f32;
    if(radius_2 > 0.0f)
    {
        turns_1 = (divide_0(_S200 - _S199, radius_2) + 1.0f) * 0.125f;
    }
    else
    {
        turns_1 = 0.0f;
    }
    var sin_cos_3 : vec2<f32> = sincos_turns_0(turns_1);
    var _S201 : f32 = radius_2 * radius_2;
    var across_0 : f32 = radius_2 * square_root_0(2.0f - _S201);
    var x_11 : f32 = sin_cos_3.y * across_0;
    var y_8 : f32 = sin_cos_3.x * across_0;
    var z_2 : f32 = 1.0f - _S201;
    if(u_3 < 0.0f)
    {
        turns_1 = - x_11;
    }
    else
    {
        turns_1 = x_11;
    }
    var _S202 : f32;
    if(v_5 < 0.0f)
    {
        _S202 = - y_8;
    }
    else
    {
        _S202 = y_8;
    }
    var _S203 : f32;
    if(height_1 < 0.0f)
    {
        _S203 = - z_2;
    }
    else
    {
        _S203 = z_2;
    }
    return vec3<f32>(turns_1, _S202, _S203);
}

fn Environment_to_world_0( d_1 : vec3<f32>) -> vec3<f32>
{
    var sin_1 : f32 = params_0.sky_turned_0.x;
    var cos_2 : f32 = params_0.sky_turned_0.y;
    var _S204 : f32 = d_1.x;
    var _S205 : f32 = d_1.y;
    return vec3<f32>(_S204 * cos_2 + _S205 * sin_1, _S205 * cos_2 - _S204 * sin_1, d_1.z);
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
    var _S206 : i32;
    if(is_beside_0)
    {
        _S206 = last_1 - y_9;
    }
    else
    {
        _S206 = y_9;
    }
    var _S207 : i32;
    if(is_beside_0)
    {
        _S207 = clamp(x_12, i32(0), last_1);
    }
    else
    {
        _S207 = x_12;
    }
    var is_beyond_0 : bool;
    if(_S206 < i32(0))
    {
        is_beyond_0 = true;
    }
    else
    {
        is_beyond_0 = _S206 > last_1;
    }
    if(is_beyond_0)
    {
        _S207 = last_1 - _S207;
    }
    if(is_beyond_0)
    {
        _S206 = clamp(_S206, i32(0), last_1);
    }
    return u32(_S206 * i32(params_0.sky_edge_0) + _S207);
}

fn Environment_texel_radiance_0( x_13 : i32,  y_10 : i32) -> vec3<f32>
{
    return vector_of_0(environment_0[Environment_index_of_0(x_13, y_10)].radiance_0);
}

fn Environment_radiance_at_0( place_0 : vec2<f32>) -> vec3<f32>
{
    var _S208 : vec2<f32> = place_0 - vec2<f32>(0.5f);
    var corner_1 : vec2<f32> = floor(_S208);
    var beyond_0 : vec2<f32> = _S208 - corner_1;
    var x_14 : i32 = i32(corner_1.x);
    var y_11 : i32 = i32(corner_1.y);
    var _S209 : f32 = beyond_0.x;
    var _S210 : vec3<f32> = vec3<f32>((1.0f - _S209));
    var _S211 : i32 = x_14 + i32(1);
    var _S212 : vec3<f32> = vec3<f32>(_S209);
    var _S213 : i32 = y_11 + i32(1);
    var _S214 : f32 = beyond_0.y;
    return (Environment_texel_radiance_0(x_14, y_11) * _S210 + Environment_texel_radiance_0(_S211, y_11) * _S212) * vec3<f32>((1.0f - _S214)) + (Environment_texel_radiance_0(x_14, _S213) * _S210 + Environment_texel_radiance_0(_S211, _S213) * _S212) * vec3<f32>(_S214);
}

fn Environment_choose_0( u_4 : vec4<f32>,  chosen_0 : ptr<function, ChosenDirection_0>) -> bool
{
    var _S215 : vec3<f32> = vec3<f32>(0.0f);
    (*chosen_0) = ChosenDirection_x24init_0(_S215, _S215, 0.0f);
    var edge_0 : f32 = f32(params_0.sky_edge_0);
    var _S216 : f32 = u_4.x * edge_0;
    var _S217 : f32 = edge_0 - 1.0f;
    var _S218 : f32 = min(floor(_S216), _S217);
    var own_0 : u32 = u32(_S218) * params_0.sky_edge_0 + u32(min(floor(u_4.y * edge_0), _S217));
    var index_17 : u32;
    if((u_4.z) < (environment_0[own_0].threshold_0))
    {
        index_17 = own_0;
    }
    else
    {
        index_17 = environment_0[own_0].alias_0;
    }
    var pdf_5 : f32 = environment_0[index_17].pdf_0;
    if((environment_0[index_17].pdf_0) <= 0.0f)
    {
        return false;
    }
    var _S219 : u32 = index_17 % params_0.sky_edge_0;
    var _S220 : f32 = f32(_S219);
    var _S221 : u32 = index_17 / params_0.sky_edge_0;
    var place_1 : vec2<f32> = vec2<f32>(_S220, f32(_S221)) + vec2<f32>(min(_S216 - _S218, 1.0f), u_4.w);
    (*chosen_0) = ChosenDirection_x24init_0(Environment_to_world_0(direction_of_0(place_1 * vec2<f32>(divide_0(1.0f, edge_0)))), Environment_radiance_at_0(place_1), pdf_5);
    return true;
}

fn Sky_sample_0( receiver_11 : Receiver_0,  u_5 : vec4<f32>,  sample_4 : ptr<function, LightSample_0>) -> bool
{
    (*sample_4) = no_light_0();
    var chosen_1 : ChosenDirection_0;
    var _S222 : bool;
    if(SKY_0 != u32(1))
    {
        _S222 = true;
    }
    else
    {
        var _S223 : bool = Environment_choose_0(u_5, &(chosen_1));
        _S222 = !_S223;
    }
    if(_S222)
    {
        return false;
    }
    var cos_theta_5 : f32 = with_slack_0(receiver_11, dot_product_0(receiver_11.normal_0, chosen_1.direction_10));
    (*sample_4) = LightSample_x24init_0(ray_from_0(receiver_11.point_0, chosen_1.direction_10), cos_theta_5, chosen_1.radiance_5 * vec3<f32>(params_0.sky_brightness_0), chosen_1.pdf_3);
    return cos_theta_5 > 0.0f;
}

fn Descent_x24init_0( node_8 : u32,  index_18 : u32,  count_4 : u32,  weight_2 : f32,  total_3 : f32,  choice_1 : f32,  is_far_4 : bool) -> Descent_0
{
    var _S224 : Descent_0;
    _S224.node_0 = node_8;
    _S224.index_0 = index_18;
    _S224.count_1 = count_4;
    _S224.weight_0 = weight_2;
    _S224.total_0 = total_3;
    _S224.choice_0 = choice_1;
    _S224.is_far_0 = is_far_4;
    return _S224;
}

fn climb_0( receiver_12 : Receiver_0,  start_2 : u32,  descent_2 : ptr<function, Descent_0>) -> bool
{
    var node_9 : LightNode_0 = top_light_node_0(start_2);
    var at_6 : u32 = start_2;
    for(;;)
    {
        var _S225 : LightNode_0 = node_9;
        if((node_9.parent_0) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var parent_1 : LightNode_0 = top_light_node_0(_S225.parent_0);
        var _S226 : u32 = _S225.parent_0 + u32(1);
        var is_left_2 : bool = at_6 == _S226;
        var _S227 : u32;
        if(is_left_2)
        {
            _S227 = parent_1.index_1;
        }
        else
        {
            _S227 = _S226;
        }
        var own_1 : View_0 = view_0(node_9, receiver_12);
        var other_1 : View_0 = view_0(top_light_node_0(_S227), receiver_12);
        var weights_2 : vec2<f32>;
        if(is_left_2)
        {
            weights_2 = weights_of_views_0(own_1, other_1);
        }
        else
        {
            weights_2 = weights_of_views_0(other_1, own_1);
        }
        var _S228 : f32 = weights_2.x;
        var _S229 : f32 = weights_2.y;
        var total_4 : f32 = _S228 + _S229;
        if(!(total_4 > 0.0f))
        {
            return false;
        }
        var _S230 : f32;
        if(is_left_2)
        {
            _S230 = _S228;
        }
        else
        {
            _S230 = _S229;
        }
        (*descent_2).weight_0 = (*descent_2).weight_0 * _S230;
        (*descent_2).total_0 = (*descent_2).total_0 * total_4;
        node_9 = parent_1;
        at_6 = _S225.parent_0;
    }
    return ((*descent_2).weight_0) > 0.0f;
}

fn in_grid_3( instance_7 : u32,  receiver_13 : Receiver_0) -> Receiver_0
{
    var _S231 : bool;
    if(IS_SINGLE_0)
    {
        if(HAS_CUTS_0)
        {
            _S231 = true;
        }
        else
        {
            _S231 = HAS_NORMALS_0;
        }
    }
    else
    {
        _S231 = false;
    }
    if(_S231)
    {
        _S231 = (Receiver_slack_0(receiver_13)) <= 0.0f;
    }
    else
    {
        _S231 = false;
    }
    if(_S231)
    {
        return Receiver_x24init_0(receiver_13.point_0, normalize_vector_0(receiver_13.normal_0));
    }
    if(IS_SINGLE_0)
    {
        return receiver_13;
    }
    var _S232 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(instance_7);
    if((Receiver_slack_0(receiver_13)) > 0.0f)
    {
        return Receiver_x24init_0(Transform_point_0(_S232.grid_from_world_0, receiver_13.point_0), receiver_13.normal_0);
    }
    return Receiver_x24init_0(Transform_point_0(_S232.grid_from_world_0, receiver_13.point_0), normalize_vector_0(Transform_direction_0(_S232.grid_from_world_0, receiver_13.normal_0)));
}

fn choose_side_0( point_7 : vec3<f32>,  is_met_2 : bool,  way_3 : Descent_0,  side_0 : ptr<function, u32>,  odds_0 : ptr<function, vec2<f32>>) -> bool
{
    var sent_0 : BySide_0 = sent_by_side_0(light_node_at_0(way_3.node_0), point_7);
    var sum_3 : f32 = normal_or_zero_0(BySide_sum_0(sent_0));
    var unit_2 : f32 = inverse_power_of_two_0(sum_3);
    var total_5 : f32 = sum_3 * unit_2;
    var _S233 : f32 = way_3.choice_0 * total_5;
    var _S234 : u32 = (*side_0);
    var share_0 : f32 = normal_or_zero_0(sent_0.low_0[u32(0)] * unit_2);
    var _S235 : bool;
    if(is_met_2)
    {
        _S235 = u32(0) == _S234;
    }
    else
    {
        _S235 = share_0 > 0.0f;
    }
    var chosen_2 : f32;
    if(_S235)
    {
        (*side_0) = u32(0);
        chosen_2 = share_0;
    }
    else
    {
        chosen_2 = 0.0f;
    }
    var _S236 : bool = _S233 < (share_0 * way_3.weight_0);
    var share_1 : f32 = normal_or_zero_0(sent_0.high_0[u32(0)] * unit_2);
    if(is_met_2)
    {
        _S235 = u32(1) == _S234;
    }
    else
    {
        if(share_1 > 0.0f)
        {
            _S235 = !_S236;
        }
        else
        {
            _S235 = false;
        }
    }
    if(_S235)
    {
        (*side_0) = u32(1);
        chosen_2 = share_1;
    }
    var passed_0 : f32 = share_0 + share_1;
    if(_S236)
    {
        _S235 = true;
    }
    else
    {
        _S235 = _S233 < (passed_0 * way_3.weight_0);
    }
    var share_2 : f32 = normal_or_zero_0(sent_0.low_0[u32(1)] * unit_2);
    var _S237 : bool;
    if(is_met_2)
    {
        _S237 = u32(2) == _S234;
    }
    else
    {
        if(share_2 > 0.0f)
        {
            _S237 = !_S235;
        }
        else
        {
            _S237 = false;
        }
    }
    if(_S237)
    {
        (*side_0) = u32(2);
        chosen_2 = share_2;
    }
    var passed_1 : f32 = passed_0 + share_2;
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = _S233 < (passed_1 * way_3.weight_0);
    }
    var share_3 : f32 = normal_or_zero_0(sent_0.high_0[u32(1)] * unit_2);
    if(is_met_2)
    {
        _S237 = u32(3) == _S234;
    }
    else
    {
        if(share_3 > 0.0f)
        {
            _S237 = !_S235;
        }
        else
        {
            _S237 = false;
        }
    }
    if(_S237)
    {
        (*side_0) = u32(3);
        chosen_2 = share_3;
    }
    var passed_2 : f32 = passed_1 + share_3;
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = _S233 < (passed_2 * way_3.weight_0);
    }
    var share_4 : f32 = normal_or_zero_0(sent_0.low_0[u32(2)] * unit_2);
    if(is_met_2)
    {
        _S237 = u32(4) == _S234;
    }
    else
    {
        if(share_4 > 0.0f)
        {
            _S237 = !_S235;
        }
        else
        {
            _S237 = false;
        }
    }
    if(_S237)
    {
        (*side_0) = u32(4);
        chosen_2 = share_4;
    }
    var passed_3 : f32 = passed_2 + share_4;
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = _S233 < (passed_3 * way_3.weight_0);
    }
    var share_5 : f32 = normal_or_zero_0(sent_0.high_0[u32(2)] * unit_2);
    if(is_met_2)
    {
        _S235 = u32(5) == _S234;
    }
    else
    {
        if(share_5 > 0.0f)
        {
            _S235 = !_S235;
        }
        else
        {
            _S235 = false;
        }
    }
    if(_S235)
    {
        (*side_0) = u32(5);
        chosen_2 = share_5;
    }
    (*odds_0) = vec2<f32>(way_3.weight_0 * chosen_2, way_3.total_0 * total_5);
    if(sum_3 > 0.0f)
    {
        _S235 = ((*odds_0).x) > 0.0f;
    }
    else
    {
        _S235 = false;
    }
    return _S235;
}

fn light_node_word_0( index_19 : u32,  word_7 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_2(u32(4) * index_19 + ((word_7 >> (u32(2)))))[(word_7 & (u32(3)))];
}

fn light_power_at_0( index_20 : u32,  side_1 : u32) -> f32
{
    var _S238 : u32;
    if(lights_in_pages_0())
    {
        _S238 = cells_0[place_in_light_node_0(index_20, u32(8) + side_1)];
    }
    else
    {
        _S238 = light_node_word_0(index_20, u32(8) + side_1);
    }
    return (bitcast<f32>((_S238)));
}

fn component_0( vector_5 : vec3<f32>,  axis_3 : u32) -> f32
{
    return select(select(vector_5.z, vector_5.y, axis_3 == u32(1)), vector_5.x, axis_3 == u32(0));
}

fn density_0( odds_1 : vec2<f32>,  luminance_3 : f32,  power_1 : f32,  toward_3 : vec3<f32>,  face_8 : u32) -> f32
{
    var along_0 : f32 = component_0(toward_3, (face_8 >> (u32(1))));
    var in_front_0 : f32;
    if(((face_8 & (u32(1)))) == u32(1))
    {
        in_front_0 = - along_0;
    }
    else
    {
        in_front_0 = along_0;
    }
    var distance_squared_0 : f32 = length_squared_0(toward_3);
    var unit_3 : f32 = inverse_power_of_two_0(power_1);
    var share_6 : f32 = odds_1.x * (luminance_3 * unit_3) * (distance_squared_0 * square_root_0(distance_squared_0));
    if(in_front_0 > 0.0f)
    {
        in_front_0 = divide_0(share_6, odds_1.y * (power_1 * unit_3) * in_front_0);
    }
    else
    {
        in_front_0 = -1.0f;
    }
    return in_front_0;
}

fn below_light_node_0( index_21 : u32) -> vec2<u32>
{
    if(!lights_in_pages_0())
    {
        return vec2<u32>(light_node_word_0(index_21, u32(3)), light_node_word_0(index_21, u32(7)));
    }
    var at_7 : u32 = place_in_light_node_0(index_21, u32(0));
    return vec2<u32>(cells_0[at_7 + u32(3)], cells_0[at_7 + u32(7)]);
}

fn place_in_emitter_0( emitter_0 : u32,  word_8 : u32) -> u32
{
    return u32(0);
}

fn emitter_word_0( index_22 : u32,  word_9 : u32) -> u32
{
    return Rows_operatorx5Bx5D_get_1(u32(2) * index_22 + ((word_9 >> (u32(2)))))[(word_9 & (u32(3)))];
}

fn emitter_faces_at_0( index_23 : u32) -> u32
{
    var _S239 : u32;
    if(lights_in_pages_0())
    {
        _S239 = cells_0[place_in_emitter_0(index_23, u32(4))];
    }
    else
    {
        _S239 = emitter_word_0(index_23, u32(4));
    }
    return _S239;
}

fn emitter_luminance_at_0( index_24 : u32) -> f32
{
    var _S240 : f32;
    if(lights_in_pages_0())
    {
        _S240 = (bitcast<f32>((cells_0[place_in_emitter_0(index_24, u32(6))])));
    }
    else
    {
        _S240 = (bitcast<f32>((emitter_word_0(index_24, u32(6)))));
    }
    return _S240;
}

struct Emitter_0
{
     voxel_10 : array<i32, i32(3)>,
     grid_6 : u32,
     faces_0 : u32,
     material_0 : u32,
     luminance_4 : f32,
     leaf_0 : u32,
};

fn Emitter_x24init_0( voxel_11 : array<i32, i32(3)>,  grid_7 : u32,  faces_1 : u32,  material_1 : u32,  luminance_5 : f32,  leaf_1 : u32) -> Emitter_0
{
    var _S241 : Emitter_0;
    _S241.voxel_10 = voxel_11;
    _S241.grid_6 = grid_7;
    _S241.faces_0 = faces_1;
    _S241.material_0 = material_1;
    _S241.luminance_4 = luminance_5;
    _S241.leaf_0 = leaf_1;
    return _S241;
}

fn emitter_at_0( index_25 : u32) -> Emitter_0
{
    if(!lights_in_pages_0())
    {
        var _S242 : u32 = u32(2) * index_25;
        var _S243 : vec4<u32> = Rows_operatorx5Bx5D_get_1(_S242);
        var _S244 : vec4<u32> = Rows_operatorx5Bx5D_get_1(_S242 + u32(1));
        var _S245 : array<i32, i32(3)> = array<i32, i32(3)>( i32(_S243.x), i32(_S243.y), i32(_S243.z) );
        return Emitter_x24init_0(_S245, _S243.w, _S244.x, _S244.y, (bitcast<f32>((_S244.z))), _S244.w);
    }
    var at_8 : u32 = place_in_emitter_0(index_25, u32(0));
    var _S246 : array<i32, i32(3)> = array<i32, i32(3)>( i32(cells_0[at_8]), i32(cells_0[at_8 + u32(1)]), i32(cells_0[at_8 + u32(2)]) );
    return Emitter_x24init_0(_S246, cells_0[at_8 + u32(3)], cells_0[at_8 + u32(4)], cells_0[at_8 + u32(5)], (bitcast<f32>((cells_0[at_8 + u32(6)]))), cells_0[at_8 + u32(7)]);
}

fn choose_emitter_0( way_4 : Descent_0,  side_2 : u32,  threshold_1 : f32) -> Emitter_0
{
    var is_found_0 : bool;
    var is_left_3 : bool;
    var count_5 : u32 = way_4.count_1;
    var node_10 : u32 = way_4.node_0;
    var index_26 : u32 = way_4.index_0;
    var _S247 : f32 = threshold_1;
    for(;;)
    {
        if(count_5 == u32(0))
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
        if(_S247 < power_left_0)
        {
            is_left_3 = true;
        }
        else
        {
            is_left_3 = (light_power_at_0(index_26, side_2)) <= 0.0f;
        }
        if(is_left_3)
        {
        }
        else
        {
            _S247 = _S247 - power_left_0;
        }
        if(is_left_3)
        {
            node_10 = left_4;
        }
        else
        {
            node_10 = index_26;
        }
        var below_0 : vec2<u32> = below_light_node_0(node_10);
        var _S248 : u32 = below_0.x;
        count_5 = below_0.y;
        index_26 = _S248;
    }
    is_found_0 = false;
    var chosen_3 : u32 = index_26;
    var at_9 : u32 = index_26;
    for(;;)
    {
        if(at_9 < (index_26 + count_5))
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
        if((((((emitter_faces_at_0(at_9)) >> (side_2))) & (u32(1)))) != u32(0))
        {
            var _S249 : f32 = _S247 - emitter_luminance_at_0(at_9);
            is_found_0 = _S247 < (emitter_luminance_at_0(at_9));
            chosen_3 = at_9;
            _S247 = _S249;
        }
        at_9 = at_9 + u32(1);
    }
    return emitter_at_0(chosen_3);
}

fn point_of_face_0( low_12 : vec3<f32>,  face_9 : u32,  u_6 : f32,  v_6 : f32) -> vec3<f32>
{
    var away_2 : f32;
    if(((face_9 & (u32(1)))) == u32(1))
    {
        away_2 = 1.0f;
    }
    else
    {
        away_2 = 0.0f;
    }
    if(face_9 < u32(2))
    {
        return low_12 + vec3<f32>(away_2, u_6, v_6);
    }
    if(face_9 < u32(4))
    {
        return low_12 + vec3<f32>(u_6, away_2, v_6);
    }
    return low_12 + vec3<f32>(u_6, v_6, away_2);
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

fn material_of_index_0( index_27 : u32) -> PackedMaterial_0
{
    var _S250 : u32 = u32(4) * index_27;
    var _S251 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S250);
    var _S252 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S250 + u32(1));
    var _S253 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S250 + u32(2));
    var _S254 : vec4<u32> = Rows_operatorx5Bx5D_get_0(_S250 + u32(3));
    var material_2 : PackedMaterial_0;
    var _S255 : f32 = (bitcast<f32>((_S251.y)));
    var _S256 : f32 = (bitcast<f32>((_S251.z)));
    material_2.base_color_0[i32(0)] = (bitcast<f32>((_S251.x)));
    material_2.base_color_0[i32(1)] = _S255;
    material_2.base_color_0[i32(2)] = _S256;
    var _S257 : f32 = (bitcast<f32>((_S252.y)));
    var _S258 : f32 = (bitcast<f32>((_S252.z)));
    material_2.emission_0[i32(0)] = (bitcast<f32>((_S252.x)));
    material_2.emission_0[i32(1)] = _S257;
    material_2.emission_0[i32(2)] = _S258;
    var _S259 : f32 = (bitcast<f32>((_S254.y)));
    var _S260 : f32 = (bitcast<f32>((_S254.z)));
    material_2.absorption_0[i32(0)] = (bitcast<f32>((_S254.x)));
    material_2.absorption_0[i32(1)] = _S259;
    material_2.absorption_0[i32(2)] = _S260;
    material_2.roughness_0 = (bitcast<f32>((_S251.w)));
    material_2.metallic_0 = (bitcast<f32>((_S252.w)));
    material_2.transmission_0 = (bitcast<f32>((_S253.x)));
    material_2.ior_0 = (bitcast<f32>((_S253.y)));
    material_2.specular_0 = (bitcast<f32>((_S253.z)));
    material_2.anisotropy_0 = (bitcast<f32>((_S253.w)));
    material_2.scattering_0 = (bitcast<f32>((_S254.w)));
    return material_2;
}

fn is_without_surface_0( material_3 : PackedMaterial_0) -> bool
{
    var _S261 : bool;
    if((material_3.transmission_0) >= 1.0f)
    {
        _S261 = (material_3.ior_0) == 1.0f;
    }
    else
    {
        _S261 = false;
    }
    if(_S261)
    {
        _S261 = (material_3.metallic_0) <= 0.0f;
    }
    else
    {
        _S261 = false;
    }
    return _S261;
}

fn emitted_0( material_4 : PackedMaterial_0) -> vec3<f32>
{
    if(is_without_surface_0(material_4))
    {
        return vec3<f32>(0.0f);
    }
    return vector_of_0(material_4.emission_0) * vec3<f32>(params_0.emitter_intensity_0);
}

fn sample_emitter_0( receiver_14 : Receiver_0,  u_7 : vec4<f32>,  aim_2 : Aim_0,  sample_5 : ptr<function, LightSample_0>) -> bool
{
    (*sample_5) = no_light_0();
    if((params_0.light_node_count_0) == u32(0))
    {
        return false;
    }
    var descent_3 : Descent_0 = Descent_x24init_0(u32(0), u32(0), u32(0), 1.0f, 1.0f, u_7.x, false);
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
        var _S263 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(aim_2.hit_0.instance_0);
        if((_S263.light_leaf_0) == u32(4294967295))
        {
            _S262 = true;
        }
        else
        {
            var _S264 : bool = climb_0(receiver_14, _S263.light_leaf_0, &(descent_3));
            _S262 = !_S264;
        }
        if(_S262)
        {
            return false;
        }
        Descent_at_1(&(descent_3), _S263.light_leaf_0);
    }
    else
    {
        if(!IS_SINGLE_0)
        {
            var _S265 : bool = descend_1(receiver_14, by_chance_0(), &(descent_3));
            _S262 = !_S265;
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
    var chosen_instance_0 : u32 = descent_3.index_0;
    var local_5 : Receiver_0 = in_grid_3(descent_3.index_0, receiver_14);
    Descent_at_0(&(descent_3), top_light_node_0(descent_3.node_0).root_0);
    var _S266 : bool = descend_0(local_5, aim_2, &(descent_3));
    if(!_S266)
    {
        return false;
    }
    var side_3 : u32 = aim_2.hit_0.face_0;
    var odds_2 : vec2<f32>;
    if(HAS_CUTS_0)
    {
        _S262 = aim_2.is_met_0;
    }
    else
    {
        _S262 = false;
    }
    if(_S262)
    {
        _S262 = is_cut_0(aim_2.hit_0);
    }
    else
    {
        _S262 = false;
    }
    if(_S262)
    {
        _S262 = true;
    }
    else
    {
        var _S267 : bool = choose_side_0(local_5.point_0, aim_2.is_met_0, descent_3, &(side_3), &(odds_2));
        _S262 = !_S267;
    }
    if(_S262)
    {
        return false;
    }
    var power_2 : f32 = light_power_at_0(descent_3.node_0, side_3);
    var _S268 : PackedInstance_0 = Instances_operatorx5Bx5D_get_0(chosen_instance_0);
    if(aim_2.is_met_0)
    {
        var _S269 : f32 = density_0(odds_2, aim_2.luminance_0, power_2, Transform_direction_0(_S268.grid_from_world_0, aim_2.direction_0) * vec3<f32>(aim_2.hit_0.t_0), side_3);
        (*sample_5).pdf_1 = _S269;
        return _S269 > 0.0f;
    }
    var emitter_1 : Emitter_0 = choose_emitter_0(descent_3, side_3, u_7.y * power_2);
    var _S270 : vec3<f32> = vec3<f32>(cell_of_0(emitter_1.voxel_10));
    var on_face_0 : vec3<f32> = point_of_face_0(_S270, side_3, u_7.z, u_7.w);
    var pdf_6 : f32 = density_0(odds_2, emitter_1.luminance_4, power_2, on_face_0 - local_5.point_0, side_3);
    if(pdf_6 < 0.0f)
    {
        return false;
    }
    var direction_12 : vec3<f32> = Transform_point_0(_S268.world_from_grid_0, offset_ray_origin_0(vector_of_0(_S268.grid_from_world_0.translation_0), _S270, side_3, on_face_0)) - receiver_14.point_0;
    var cos_theta_6 : f32 = with_slack_0(receiver_14, divide_0(dot_product_0(receiver_14.normal_0, direction_12), square_root_0(length_squared_0(direction_12))));
    (*sample_5) = LightSample_x24init_0(Ray_x24init_0(receiver_14.point_0, 0.0f, direction_12, 1.0f), cos_theta_6, emitted_0(material_of_index_0(emitter_1.material_0)), pdf_6);
    return cos_theta_6 > 0.0f;
}

fn EmitterTree_sample_0( receiver_15 : Receiver_0,  u_8 : vec4<f32>,  aim_3 : Aim_0,  sample_6 : ptr<function, LightSample_0>) -> bool
{
    var _S271 : bool = sample_emitter_0(receiver_15, u_8, aim_3, &((*sample_6)));
    return _S271;
}

fn Lights_sample_0( receiver_16 : Receiver_0,  selection_0 : Selection_0,  u_9 : vec4<f32>,  aim_4 : Aim_0,  sample_7 : ptr<function, LightSample_0>) -> bool
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
        is_found_1 = (u_9.x) < (selection_0.sun_0);
    }
    else
    {
        is_found_1 = false;
    }
    if(is_found_1)
    {
        var _S272 : bool = SunDisc_sample_0(receiver_16, u_9, &((*sample_7)));
        (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.sun_0;
        is_found_1 = _S272;
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
            var _S273 : bool = Sky_sample_0(receiver_16, vec4<f32>(min(divide_0(u_9.x - selection_0.sun_0, selection_0.sky_1), 0.99999994039535522f), u_9.yzw), &((*sample_7)));
            (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.sky_1;
            is_found_1 = _S273;
        }
        else
        {
            var _S274 : bool = EmitterTree_sample_0(receiver_16, vec4<f32>(min(divide_0(u_9.x - (selection_0.sun_0 + selection_0.sky_1), selection_0.emitters_0), 0.99999994039535522f), u_9.yzw), aim_4, &((*sample_7)));
            (*sample_7).pdf_1 = (*sample_7).pdf_1 * selection_0.emitters_0;
            is_found_1 = _S274;
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
    var _S275 : f32;
    if(SunDisc_contains_0(direction_14))
    {
        _S275 = params_0.sun_pdf_0;
    }
    else
    {
        _S275 = 0.0f;
    }
    return _S275;
}

fn Lights_sun_pdf_0( selection_1 : Selection_0,  direction_15 : vec3<f32>) -> f32
{
    var _S276 : f32;
    if(has_sun_0())
    {
        _S276 = SunDisc_pdf_0(direction_15) * selection_1.sun_0;
    }
    else
    {
        _S276 = 0.0f;
    }
    return _S276;
}

fn Hit_is_miss_0( this_31 : Hit_0) -> bool
{
    return (this_31.instance_0) == u32(4294967295);
}

fn material_of_0( hit_8 : Hit_0) -> PackedMaterial_0
{
    var _S277 : PackedGrid_0 = Grids_operatorx5Bx5D_get_0(Instances_operatorx5Bx5D_get_0(hit_8.instance_0).grid_0);
    return material_of_index_0(material_at_0(_S277, hit_8.voxel_0 - cell_of_0(_S277.origin_0)));
}

@compute
@workgroup_size(64, 1, 1)
fn check_light(@builtin(global_invocation_id) id_9 : vec3<u32>, @builtin(local_invocation_index) thread_10 : u32)
{
    prove_0(thread_10);
    var _S278 : u32 = id_9.x;
    if(_S278 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_9 : Reader_0 = Reader_x24init_0(u32(24) * _S278);
    var writer_9 : Writer_0 = Writer_x24init_0(u32(12) * _S278);
    var point_8 : vec3<f32> = Reader_vector_0(&(reader_9));
    var _S279 : vec3<f32> = Reader_vector_0(&(reader_9));
    var receiver_17 : Receiver_0 = Receiver_x24init_0(point_8, _S279);
    var u_10 : vec3<f32> = Reader_vector_0(&(reader_9));
    var selection_2 : Selection_0 = Lights_selection_0(receiver_17);
    var _S280 : f32 = Reader_number_0(&(reader_9));
    var sample_8 : LightSample_0;
    var is_found_2 : bool = Lights_sample_0(receiver_17, selection_2, vec4<f32>(u_10, _S280), by_chance_0(), &(sample_8));
    if(!is_found_2)
    {
        sample_8 = no_light_0();
    }
    var ray_8 : Ray_0 = Reader_ray_0(&(reader_9));
    var hit_9 : Hit_0 = Reader_hit_0(&(reader_9));
    Writer_word_0(&(writer_9), u32(is_found_2));
    Writer_vector_0(&(writer_9), sample_8.ray_6.direction_1);
    Writer_number_0(&(writer_9), sample_8.ray_6.t_max_0);
    Writer_number_0(&(writer_9), sample_8.cos_theta_2);
    Writer_vector_0(&(writer_9), sample_8.radiance_3);
    Writer_number_0(&(writer_9), sample_8.pdf_1);
    Writer_number_0(&(writer_9), Lights_sun_pdf_0(selection_2, sample_8.ray_6.direction_1));
    var met_0 : LightSample_0;
    var aim_5 : Aim_0 = Aim_x24init_0(true, ray_8.direction_1, hit_9, 0.0f);
    var _S281 : bool = !Hit_is_miss_0(hit_9);
    var _S282 : f32;
    if(_S281)
    {
        var material_5 : PackedMaterial_0 = material_of_0(hit_9);
        if(is_without_surface_0(material_5))
        {
            _S282 = 0.0f;
        }
        else
        {
            _S282 = luminance_1(vector_of_0(material_5.emission_0));
        }
        aim_5.luminance_0 = _S282;
    }
    var is_met_3 : bool;
    if(_S281)
    {
        var _S283 : bool = Lights_sample_0(receiver_17, selection_2, vec4<f32>(0.0f), aim_5, &(met_0));
        is_met_3 = _S283;
    }
    else
    {
        is_met_3 = false;
    }
    if(is_met_3)
    {
        _S282 = met_0.pdf_1;
    }
    else
    {
        _S282 = 0.0f;
    }
    Writer_number_0(&(writer_9), _S282);
    return;
}

fn SunDisc_le_0( direction_16 : vec3<f32>) -> vec3<f32>
{
    var _S284 : vec3<f32>;
    if(SunDisc_contains_0(direction_16))
    {
        _S284 = params_0.sun_radiance_0;
    }
    else
    {
        _S284 = vec3<f32>(0.0f);
    }
    return _S284;
}

fn Environment_to_map_0( d_2 : vec3<f32>) -> vec3<f32>
{
    var sin_2 : f32 = params_0.sky_turned_0.x;
    var cos_3 : f32 = params_0.sky_turned_0.y;
    var _S285 : f32 = d_2.x;
    var _S286 : f32 = d_2.y;
    return vec3<f32>(_S285 * cos_3 - _S286 * sin_2, _S285 * sin_2 + _S286 * cos_3, d_2.z);
}

fn quarter_turns_0( x_15 : f32,  y_12 : f32) -> f32
{
    var _S287 : f32 = min(x_15, y_12);
    var _S288 : f32 = max(x_15, y_12);
    var ratio_0 : f32;
    if(_S288 > 0.0f)
    {
        ratio_0 = divide_0(_S287, _S288);
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
    var _S289 : f32 = size_0.x;
    var _S290 : f32 = size_0.y;
    var radius_3 : f32 = square_root_0(divide_0(_S289 * _S289 + _S290 * _S290, 1.0f + size_0.z));
    var v_7 : f32 = quarter_turns_0(_S289, _S290) * radius_3;
    var u_11 : f32 = radius_3 - v_7;
    var is_below_1 : bool = (direction_17.z) < 0.0f;
    var u_12 : f32;
    if(is_below_1)
    {
        u_12 = 1.0f - v_7;
    }
    else
    {
        u_12 = u_11;
    }
    var v_8 : f32;
    if(is_below_1)
    {
        v_8 = 1.0f - u_11;
    }
    else
    {
        v_8 = v_7;
    }
    if((direction_17.x) < 0.0f)
    {
        u_12 = - u_12;
    }
    if((direction_17.y) < 0.0f)
    {
        v_8 = - v_8;
    }
    return vec2<f32>(u_12 * 0.5f + 0.5f, v_8 * 0.5f + 0.5f);
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
    var _S291 : Gradient_0;
    _S291.nadir_0 = nadir_1;
    _S291.zenith_0 = zenith_1;
    return _S291;
}

fn Gradient_radiance_0( this_32 : Gradient_0,  direction_20 : vec3<f32>) -> vec3<f32>
{
    return this_32.nadir_0 + (this_32.zenith_0 - this_32.nadir_0) * vec3<f32>((0.5f * (direction_20.z + 1.0f)));
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
    var _S292 : f32;
    if(SKY_0 == u32(1))
    {
        _S292 = Environment_pdf_0(direction_24);
    }
    else
    {
        _S292 = 0.0f;
    }
    return _S292;
}

fn Lights_sky_pdf_0( selection_3 : Selection_0,  direction_25 : vec3<f32>) -> f32
{
    var _S293 : f32;
    if(Lights_has_chosen_sky_0())
    {
        _S293 = Sky_pdf_0(direction_25) * selection_3.sky_1;
    }
    else
    {
        _S293 = 0.0f;
    }
    return _S293;
}

@compute
@workgroup_size(64, 1, 1)
fn check_distant_light(@builtin(global_invocation_id) id_10 : vec3<u32>, @builtin(local_invocation_index) thread_11 : u32)
{
    prove_0(thread_11);
    var _S294 : u32 = id_10.x;
    if(_S294 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_10 : Reader_0 = Reader_x24init_0(u32(13) * _S294);
    var writer_10 : Writer_0 = Writer_x24init_0(u32(22) * _S294);
    var point_9 : vec3<f32> = Reader_vector_0(&(reader_10));
    var _S295 : vec3<f32> = Reader_vector_0(&(reader_10));
    var receiver_18 : Receiver_0 = Receiver_x24init_0(point_9, _S295);
    var u_13 : vec3<f32> = Reader_vector_0(&(reader_10));
    var _S296 : f32 = Reader_number_0(&(reader_10));
    var place_3 : vec4<f32> = vec4<f32>(u_13, _S296);
    var sample_9 : LightSample_0;
    var is_found_3 : bool = SunDisc_sample_0(receiver_18, place_3, &(sample_9));
    var of_sky_0 : LightSample_0;
    var is_found_in_sky_0 : bool = Sky_sample_0(receiver_18, place_3, &(of_sky_0));
    var direction_26 : vec3<f32> = Reader_vector_0(&(reader_10));
    Writer_word_0(&(writer_10), u32(is_found_3));
    var _S297 : vec3<f32>;
    if(is_found_3)
    {
        _S297 = sample_9.ray_6.direction_1;
    }
    else
    {
        _S297 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S297);
    Writer_vector_0(&(writer_10), SunDisc_le_0(direction_26));
    Writer_number_0(&(writer_10), SunDisc_pdf_0(direction_26));
    Writer_vector_0(&(writer_10), Sky_le_0(direction_26));
    Writer_number_0(&(writer_10), Sky_pdf_0(direction_26));
    Writer_number_0(&(writer_10), Lights_sun_pdf_0(Lights_selection_0(receiver_18), direction_26));
    Writer_number_0(&(writer_10), Lights_sky_pdf_0(Lights_selection_0(receiver_18), direction_26));
    Writer_word_0(&(writer_10), u32(is_found_in_sky_0));
    if(is_found_in_sky_0)
    {
        _S297 = of_sky_0.ray_6.direction_1;
    }
    else
    {
        _S297 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S297);
    if(is_found_in_sky_0)
    {
        _S297 = of_sky_0.radiance_3;
    }
    else
    {
        _S297 = vec3<f32>(0.0f);
    }
    Writer_vector_0(&(writer_10), _S297);
    var _S298 : f32;
    if(is_found_in_sky_0)
    {
        _S298 = of_sky_0.pdf_1;
    }
    else
    {
        _S298 = 0.0f;
    }
    Writer_number_0(&(writer_10), _S298);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn check_equal_area(@builtin(global_invocation_id) id_11 : vec3<u32>, @builtin(local_invocation_index) thread_12 : u32)
{
    prove_0(thread_12);
    var _S299 : u32 = id_11.x;
    if(_S299 >= (dispatch_0.count_0))
    {
        return;
    }
    var _S300 : u32 = u32(5) * _S299;
    var reader_11 : Reader_0 = Reader_x24init_0(_S300);
    var writer_11 : Writer_0 = Writer_x24init_0(_S300);
    var _S301 : vec3<f32> = Reader_vector_0(&(reader_11));
    var square_1 : vec2<f32> = square_of_0(_S301);
    Writer_number_0(&(writer_11), square_1.x);
    Writer_number_0(&(writer_11), square_1.y);
    var x_16 : f32 = Reader_number_0(&(reader_11));
    var _S302 : f32 = Reader_number_0(&(reader_11));
    Writer_vector_0(&(writer_11), direction_of_0(vec2<f32>(x_16, _S302)));
    return;
}

struct Microfacets_0
{
     alpha_0 : f32,
};

fn Microfacets_x24init_0( alpha_1 : f32) -> Microfacets_0
{
    var _S303 : Microfacets_0;
    _S303.alpha_0 = alpha_1;
    return _S303;
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
    var _S304 : MaterialBsdf_0;
    _S304.kind_0 = kind_1;
    _S304.color_1 = color_2;
    _S304.specular_1 = specular_2;
    _S304.eta_0 = eta_1;
    _S304.facets_0 = facets_1;
    return _S304;
}

fn facets_of_0( roughness_1 : f32) -> Microfacets_0
{
    return Microfacets_x24init_0(roughness_1 * roughness_1);
}

fn chooses_0( share_7 : f32,  choice_2 : ptr<function, f32>) -> bool
{
    if(share_7 <= 0.0f)
    {
        return false;
    }
    var is_chosen_0 : bool = (*choice_2) < share_7;
    var _S305 : f32;
    if(is_chosen_0)
    {
        _S305 = divide_0((*choice_2), share_7);
    }
    else
    {
        _S305 = divide_0((*choice_2) - share_7, 1.0f - share_7);
    }
    (*choice_2) = _S305;
    return is_chosen_0;
}

fn bsdf_of_0( material_6 : PackedMaterial_0,  ior_1 : f32,  choice_3 : ptr<function, f32>) -> MaterialBsdf_0
{
    var color_3 : vec3<f32> = vector_of_0(material_6.base_color_0);
    var facets_2 : Microfacets_0 = facets_of_0(material_6.roughness_0);
    var _S306 : bool = chooses_0(material_6.metallic_0, &((*choice_3)));
    if(_S306)
    {
        return MaterialBsdf_x24init_0(u32(1), color_3, 0.0f, 1.0f, facets_2);
    }
    var _S307 : bool = chooses_0(material_6.transmission_0, &((*choice_3)));
    if(_S307)
    {
        return MaterialBsdf_x24init_0(u32(3), color_3, 0.0f, divide_0(material_6.ior_0, ior_1), facets_2);
    }
    if((material_6.specular_0) > 0.0f)
    {
        return MaterialBsdf_x24init_0(u32(2), color_3, material_6.specular_0, divide_0(material_6.ior_0, ior_1), facets_2);
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
    var _S308 : Conductor_0;
    _S308.f0_0 = f0_1;
    _S308.facets_3 = facets_4;
    return _S308;
}

fn above_1( wo_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(wo_0.x, wo_0.y, max(wo_0.z, 0.00009999999747379f));
}

fn Microfacets_is_smooth_0( this_33 : Microfacets_0) -> bool
{
    return (this_33.alpha_0) < 0.00999999977648258f;
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
    var _S309 : BsdfSample_0;
    _S309.wi_0 = wi_1;
    _S309.weight_3 = weight_4;
    _S309.pdf_7 = pdf_8;
    _S309.is_delta_0 = is_delta_1;
    return _S309;
}

fn Microfacets_sample_visible_0( this_34 : Microfacets_0,  wo_1 : vec3<f32>,  u_14 : f32,  v_9 : f32) -> vec3<f32>
{
    var stretched_0 : vec3<f32> = normalize_vector_0(vec3<f32>(this_34.alpha_0 * wo_1.x, this_34.alpha_0 * wo_1.y, wo_1.z));
    var sin_cos_4 : vec2<f32> = sincos_turns_0(u_14);
    var _S310 : f32 = stretched_0.z;
    var z_3 : f32 = (1.0f - v_9) * (1.0f + _S310) - _S310;
    var radius_4 : f32 = square_root_0(max(1.0f - z_3 * z_3, 0.0f));
    var normal_5 : vec3<f32> = vec3<f32>(radius_4 * sin_cos_4.y, radius_4 * sin_cos_4.x, z_3) + stretched_0;
    return normalize_vector_0(vec3<f32>(this_34.alpha_0 * normal_5.x, this_34.alpha_0 * normal_5.y, max(normal_5.z, 1.00000001168609742e-07f)));
}

fn reflect_by_0( wo_2 : vec3<f32>,  wm_0 : vec3<f32>) -> vec3<f32>
{
    return wm_0 * vec3<f32>((2.0f * dot_product_0(wo_2, wm_0))) - wo_2;
}

fn no_bsdf_sample_0() -> BsdfSample_0
{
    return BsdfSample_x24init_0(vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(0.0f), 0.0f, false);
}

fn Microfacets_masking_0( this_35 : Microfacets_0,  cos_4 : f32) -> f32
{
    var _S311 : f32 = this_35.alpha_0;
    var alpha_squared_0 : f32 = _S311 * _S311;
    return square_root_0(alpha_squared_0 + (1.0f - alpha_squared_0) * (cos_4 * cos_4));
}

fn Microfacets_shadowing_0( this_36 : Microfacets_0,  cos_o_0 : f32,  cos_i_1 : f32) -> f32
{
    var of_o_0 : f32 = Microfacets_masking_0(this_36, cos_o_0);
    return divide_0(cos_i_1 * (cos_o_0 + of_o_0), cos_i_1 * of_o_0 + cos_o_0 * Microfacets_masking_0(this_36, cos_i_1));
}

fn Microfacets_distribution_0( this_37 : Microfacets_0,  wm_1 : vec3<f32>) -> f32
{
    var _S312 : f32 = this_37.alpha_0;
    var alpha_squared_1 : f32 = _S312 * _S312;
    var _S313 : f32 = wm_1.z;
    var _S314 : f32 = wm_1.x;
    var _S315 : f32 = wm_1.y;
    var base_0 : f32 = alpha_squared_1 * (_S313 * _S313) + (_S314 * _S314 + _S315 * _S315);
    return divide_0(alpha_squared_1, 3.14159274101257324f * (base_0 * base_0));
}

fn Microfacets_visible_pdf_0( this_38 : Microfacets_0,  wo_3 : vec3<f32>,  wm_2 : vec3<f32>) -> f32
{
    var _S316 : f32 = wo_3.z;
    return divide_0(2.0f * max(dot_product_0(wo_3, wm_2), 0.0f) * Microfacets_distribution_0(this_38, wm_2), _S316 + Microfacets_masking_0(this_38, _S316));
}

fn Conductor_sample_0( this_39 : Conductor_0,  given_0 : vec3<f32>,  u_15 : vec3<f32>,  sample_10 : ptr<function, BsdfSample_0>) -> bool
{
    var wo_4 : vec3<f32> = above_1(given_0);
    if(Microfacets_is_smooth_0(this_39.facets_3))
    {
        var _S317 : f32 = wo_4.z;
        (*sample_10) = BsdfSample_x24init_0(vec3<f32>(- wo_4.x, - wo_4.y, _S317), fresnel_schlick_0(_S317, this_39.f0_0), 1.0f, true);
        return true;
    }
    var wm_3 : vec3<f32> = Microfacets_sample_visible_0(this_39.facets_3, wo_4, u_15.x, u_15.y);
    var wi_2 : vec3<f32> = reflect_by_0(wo_4, wm_3);
    var _S318 : f32 = wi_2.z;
    if(_S318 <= 0.0f)
    {
        (*sample_10) = no_bsdf_sample_0();
        return false;
    }
    var cos_5 : f32 = dot_product_0(wo_4, wm_3);
    (*sample_10) = BsdfSample_x24init_0(wi_2, fresnel_schlick_0(cos_5, this_39.f0_0) * vec3<f32>(Microfacets_shadowing_0(this_39.facets_3, wo_4.z, _S318)), divide_0(Microfacets_visible_pdf_0(this_39.facets_3, wo_4, wm_3), 4.0f * cos_5), false);
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
    var _S319 : Plastic_0;
    _S319.reflectance_0 = reflectance_1;
    _S319.specular_3 = specular_4;
    _S319.eta_2 = eta_3;
    _S319.facets_5 = facets_6;
    return _S319;
}

fn refracted_cosine_0( cos_i_2 : f32,  eta_4 : f32) -> f32
{
    var squared_1 : f32 = 1.0f - divide_0(1.0f - cos_i_2 * cos_i_2, eta_4 * eta_4);
    var _S320 : f32;
    if(squared_1 > 0.0f)
    {
        _S320 = square_root_0(squared_1);
    }
    else
    {
        _S320 = -1.0f;
    }
    return _S320;
}

fn fresnel_dielectric_0( cos_i_3 : f32,  eta_5 : f32) -> f32
{
    var cos_t_0 : f32 = refracted_cosine_0(cos_i_3, eta_5);
    if(cos_t_0 < 0.0f)
    {
        return 1.0f;
    }
    var _S321 : f32 = eta_5 * cos_i_3;
    var parallel_0 : f32 = divide_0(_S321 - cos_t_0, _S321 + cos_t_0);
    var _S322 : f32 = eta_5 * cos_t_0;
    var perpendicular_0 : f32 = divide_0(cos_i_3 - _S322, cos_i_3 + _S322);
    return (parallel_0 * parallel_0 + perpendicular_0 * perpendicular_0) * 0.5f;
}

fn Plastic_coat_0( this_40 : Plastic_0,  cos_6 : f32) -> f32
{
    return this_40.specular_3 * fresnel_dielectric_0(cos_6, this_40.eta_2);
}

fn Plastic_coat_probability_0( this_41 : Plastic_0,  coat_0 : f32) -> f32
{
    var below_1 : f32 = (1.0f - coat_0) * max_element_0(this_41.reflectance_0);
    var _S323 : f32;
    if(coat_0 <= 0.0f)
    {
        _S323 = 0.0f;
    }
    else
    {
        _S323 = divide_0(coat_0, coat_0 + below_1);
    }
    return _S323;
}

struct BsdfEval_0
{
     weight_5 : vec3<f32>,
     pdf_9 : f32,
};

fn BsdfEval_x24init_0( weight_6 : vec3<f32>,  pdf_10 : f32) -> BsdfEval_0
{
    var _S324 : BsdfEval_0;
    _S324.weight_5 = weight_6;
    _S324.pdf_9 = pdf_10;
    return _S324;
}

fn no_bsdf_eval_0() -> BsdfEval_0
{
    return BsdfEval_x24init_0(vec3<f32>(0.0f), 0.0f);
}

fn Plastic_eval_lobes_0( this_42 : Plastic_0,  wo_5 : vec3<f32>,  wi_3 : vec3<f32>,  coat_1 : f32,  coat_probability_0 : f32) -> BsdfEval_0
{
    var _S325 : f32 = wi_3.z;
    var diffuse_pdf_0 : f32 = cosine_hemisphere_pdf_0(_S325);
    var pdf_11 : f32 = (1.0f - coat_probability_0) * diffuse_pdf_0;
    var scattered_0 : vec3<f32> = this_42.reflectance_0 * vec3<f32>(((1.0f - coat_1) * (1.0f - Plastic_coat_0(this_42, _S325)) * diffuse_pdf_0));
    var pdf_12 : f32;
    var scattered_1 : vec3<f32>;
    if(!Microfacets_is_smooth_0(this_42.facets_5))
    {
        var wm_4 : vec3<f32> = normalize_vector_0(wo_5 + wi_3);
        var cos_7 : f32 = dot_product_0(wo_5, wm_4);
        var facet_pdf_0 : f32 = divide_0(Microfacets_visible_pdf_0(this_42.facets_5, wo_5, wm_4), 4.0f * cos_7);
        var scattered_2 : vec3<f32> = scattered_0 + vec3<f32>((Plastic_coat_0(this_42, cos_7) * Microfacets_shadowing_0(this_42.facets_5, wo_5.z, _S325) * facet_pdf_0));
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

fn Plastic_sample_0( this_43 : Plastic_0,  given_1 : vec3<f32>,  u_16 : vec3<f32>,  sample_11 : ptr<function, BsdfSample_0>) -> bool
{
    (*sample_11) = no_bsdf_sample_0();
    var wo_6 : vec3<f32> = above_1(given_1);
    var _S326 : f32 = wo_6.z;
    var coat_2 : f32 = Plastic_coat_0(this_43, _S326);
    var coat_probability_1 : f32 = Plastic_coat_probability_0(this_43, coat_2);
    var is_coat_0 : bool = (u_16.z) < coat_probability_1;
    var _S327 : bool;
    if(is_coat_0)
    {
        _S327 = Microfacets_is_smooth_0(this_43.facets_5);
    }
    else
    {
        _S327 = false;
    }
    if(_S327)
    {
        (*sample_11) = BsdfSample_x24init_0(vec3<f32>(- wo_6.x, - wo_6.y, _S326), vec3<f32>(divide_0(coat_2, coat_probability_1)), 1.0f, true);
        return true;
    }
    var wi_4 : vec3<f32>;
    if(is_coat_0)
    {
        wi_4 = reflect_by_0(wo_6, Microfacets_sample_visible_0(this_43.facets_5, wo_6, u_16.x, u_16.y));
    }
    else
    {
        wi_4 = cosine_hemisphere_0(u_16.x, u_16.y);
    }
    if((wi_4.z) <= 0.0f)
    {
        return false;
    }
    var eval_0 : BsdfEval_0 = Plastic_eval_lobes_0(this_43, wo_6, wi_4, coat_2, coat_probability_1);
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
    var _S328 : Dielectric_0;
    _S328.eta_6 = eta_7;
    _S328.facets_7 = facets_8;
    return _S328;
}

fn Dielectric_sample_0( this_44 : Dielectric_0,  given_2 : vec3<f32>,  u_17 : vec3<f32>,  sample_12 : ptr<function, BsdfSample_0>) -> bool
{
    (*sample_12) = no_bsdf_sample_0();
    var wo_7 : vec3<f32> = above_1(given_2);
    var is_smooth_0 : bool = Microfacets_is_smooth_0(this_44.facets_7);
    const _S329 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
    var wm_5 : vec3<f32>;
    if(!is_smooth_0)
    {
        wm_5 = Microfacets_sample_visible_0(this_44.facets_7, wo_7, u_17.x, u_17.y);
    }
    else
    {
        wm_5 = _S329;
    }
    var cos_8 : f32 = dot_product_0(wo_7, wm_5);
    var reflectance_2 : f32 = fresnel_dielectric_0(cos_8, this_44.eta_6);
    var is_reflected_0 : bool = (u_17.z) < reflectance_2;
    var wi_5 : vec3<f32>;
    if(is_reflected_0)
    {
        wi_5 = reflect_by_0(wo_7, wm_5);
    }
    else
    {
        var scale_0 : f32 = divide_0(1.0f, this_44.eta_6);
        var cos_t_1 : f32 = refracted_cosine_0(cos_8, this_44.eta_6);
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
    var _S330 : f32 = wi_5.z;
    var _S331 : bool;
    if((_S330 > 0.0f) != is_reflected_0)
    {
        _S331 = true;
    }
    else
    {
        _S331 = _S330 == 0.0f;
    }
    if(_S331)
    {
        return false;
    }
    var weight_7 : vec3<f32> = vec3<f32>(Microfacets_shadowing_0(this_44.facets_7, wo_7.z, abs(_S330)));
    var pdf_13 : f32 = divide_0(reflectance_2 * Microfacets_visible_pdf_0(this_44.facets_7, wo_7, wm_5), 4.0f * cos_8);
    var _S332 : f32;
    if(is_reflected_0)
    {
        _S332 = pdf_13;
    }
    else
    {
        _S332 = 1.0f;
    }
    (*sample_12) = BsdfSample_x24init_0(wi_5, weight_7, _S332, !is_reflected_0);
    return true;
}

struct Phase_0
{
     color_4 : vec3<f32>,
     anisotropy_1 : f32,
};

fn Phase_x24init_0( color_5 : vec3<f32>,  anisotropy_2 : f32) -> Phase_0
{
    var _S333 : Phase_0;
    _S333.color_4 = color_5;
    _S333.anisotropy_1 = anisotropy_2;
    return _S333;
}

fn sample_phase_0( anisotropy_3 : f32,  forward_0 : vec3<f32>,  u_18 : f32,  v_10 : f32,  cos_9 : ptr<function, f32>) -> vec3<f32>
{
    if((abs(anisotropy_3)) < 0.00100000004749745f)
    {
        (*cos_9) = 1.0f - 2.0f * u_18;
    }
    else
    {
        var _S334 : f32 = anisotropy_3 * anisotropy_3;
        var _S335 : f32 = 2.0f * anisotropy_3;
        var ratio_1 : f32 = divide_0(1.0f - _S334, 1.0f + anisotropy_3 - _S335 * u_18);
        (*cos_9) = divide_0(1.0f + _S334 - ratio_1 * ratio_1, _S335);
    }
    var _S336 : f32 = clamp((*cos_9), -1.0f, 1.0f);
    (*cos_9) = _S336;
    var radius_5 : f32 = square_root_0(1.0f - _S336 * _S336);
    var sin_cos_5 : vec2<f32> = sincos_turns_0(v_10);
    var x_17 : vec3<f32>;
    var y_13 : vec3<f32>;
    orthonormal_pair_1(forward_0, &(x_17), &(y_13));
    return x_17 * vec3<f32>((radius_5 * sin_cos_5.y)) + y_13 * vec3<f32>((radius_5 * sin_cos_5.x)) + forward_0 * vec3<f32>(_S336);
}

fn phase_pdf_0( anisotropy_4 : f32,  cos_10 : f32) -> f32
{
    var _S337 : f32 = anisotropy_4 * anisotropy_4;
    var base_1 : f32 = 1.0f + _S337 - 2.0f * anisotropy_4 * cos_10;
    return divide_0(1.0f - _S337, 12.56637096405029297f * (base_1 * square_root_0(base_1)));
}

fn Phase_sample_0( this_45 : Phase_0,  wo_8 : vec3<f32>,  u_19 : vec3<f32>,  sample_13 : ptr<function, BsdfSample_0>) -> bool
{
    var cos_11 : f32;
    var wi_6 : vec3<f32> = sample_phase_0(this_45.anisotropy_1, (vec3<f32>(0) - wo_8), u_19.x, u_19.y, &(cos_11));
    (*sample_13) = BsdfSample_x24init_0(wi_6, this_45.color_4, phase_pdf_0(this_45.anisotropy_1, cos_11), false);
    return true;
}

struct Diffuse_0
{
     reflectance_3 : vec3<f32>,
};

fn Diffuse_x24init_0( reflectance_4 : vec3<f32>) -> Diffuse_0
{
    var _S338 : Diffuse_0;
    _S338.reflectance_3 = reflectance_4;
    return _S338;
}

fn Diffuse_sample_0( this_46 : Diffuse_0,  wo_9 : vec3<f32>,  u_20 : vec3<f32>,  sample_14 : ptr<function, BsdfSample_0>) -> bool
{
    var wi_7 : vec3<f32> = cosine_hemisphere_0(u_20.x, u_20.y);
    (*sample_14) = BsdfSample_x24init_0(wi_7, this_46.reflectance_3, cosine_hemisphere_pdf_0(wi_7.z), false);
    return true;
}

fn MaterialBsdf_sample_0( this_47 : MaterialBsdf_0,  wo_10 : vec3<f32>,  u_21 : vec3<f32>,  sample_15 : ptr<function, BsdfSample_0>) -> bool
{
    if((this_47.kind_0) == u32(1))
    {
        var _S339 : bool = Conductor_sample_0(Conductor_x24init_0(this_47.color_1, this_47.facets_0), wo_10, u_21, &((*sample_15)));
        return _S339;
    }
    if((this_47.kind_0) == u32(2))
    {
        var _S340 : bool = Plastic_sample_0(Plastic_x24init_0(this_47.color_1, this_47.specular_1, this_47.eta_0, this_47.facets_0), wo_10, u_21, &((*sample_15)));
        return _S340;
    }
    if((this_47.kind_0) == u32(3))
    {
        var _S341 : bool = Dielectric_sample_0(Dielectric_x24init_0(this_47.eta_0, this_47.facets_0), wo_10, u_21, &((*sample_15)));
        return _S341;
    }
    if((this_47.kind_0) == u32(4))
    {
        var _S342 : bool = Phase_sample_0(Phase_x24init_0(this_47.color_1, this_47.specular_1), wo_10, u_21, &((*sample_15)));
        return _S342;
    }
    var _S343 : bool = Diffuse_sample_0(Diffuse_x24init_0(this_47.color_1), wo_10, u_21, &((*sample_15)));
    return _S343;
}

fn Conductor_eval_0( this_48 : Conductor_0,  given_3 : vec3<f32>,  wi_8 : vec3<f32>) -> BsdfEval_0
{
    var _S344 : bool;
    if(Microfacets_is_smooth_0(this_48.facets_3))
    {
        _S344 = true;
    }
    else
    {
        _S344 = (wi_8.z) <= 0.0f;
    }
    if(_S344)
    {
        return no_bsdf_eval_0();
    }
    var wo_11 : vec3<f32> = above_1(given_3);
    var wm_6 : vec3<f32> = normalize_vector_0(wo_11 + wi_8);
    var cos_12 : f32 = dot_product_0(wo_11, wm_6);
    return BsdfEval_x24init_0(fresnel_schlick_0(cos_12, this_48.f0_0) * vec3<f32>(Microfacets_shadowing_0(this_48.facets_3, wo_11.z, wi_8.z)), divide_0(Microfacets_visible_pdf_0(this_48.facets_3, wo_11, wm_6), 4.0f * cos_12));
}

fn Plastic_eval_0( this_49 : Plastic_0,  given_4 : vec3<f32>,  wi_9 : vec3<f32>) -> BsdfEval_0
{
    if((wi_9.z) <= 0.0f)
    {
        return no_bsdf_eval_0();
    }
    var wo_12 : vec3<f32> = above_1(given_4);
    var coat_3 : f32 = Plastic_coat_0(this_49, wo_12.z);
    return Plastic_eval_lobes_0(this_49, wo_12, wi_9, coat_3, Plastic_coat_probability_0(this_49, coat_3));
}

fn Dielectric_eval_0( this_50 : Dielectric_0,  given_5 : vec3<f32>,  wi_10 : vec3<f32>) -> BsdfEval_0
{
    var _S345 : bool;
    if(Microfacets_is_smooth_0(this_50.facets_7))
    {
        _S345 = true;
    }
    else
    {
        _S345 = (wi_10.z) <= 0.0f;
    }
    if(_S345)
    {
        return no_bsdf_eval_0();
    }
    var wo_13 : vec3<f32> = above_1(given_5);
    var wm_7 : vec3<f32> = normalize_vector_0(wo_13 + wi_10);
    var cos_13 : f32 = dot_product_0(wo_13, wm_7);
    return BsdfEval_x24init_0(vec3<f32>(Microfacets_shadowing_0(this_50.facets_7, wo_13.z, wi_10.z)), divide_0(fresnel_dielectric_0(cos_13, this_50.eta_6) * Microfacets_visible_pdf_0(this_50.facets_7, wo_13, wm_7), 4.0f * cos_13));
}

fn Phase_eval_0( this_51 : Phase_0,  wo_14 : vec3<f32>,  wi_11 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_51.color_4, phase_pdf_0(this_51.anisotropy_1, dot_product_0((vec3<f32>(0) - wo_14), wi_11)));
}

fn Diffuse_eval_0( this_52 : Diffuse_0,  wo_15 : vec3<f32>,  wi_12 : vec3<f32>) -> BsdfEval_0
{
    return BsdfEval_x24init_0(this_52.reflectance_3, cosine_hemisphere_pdf_0(wi_12.z));
}

fn MaterialBsdf_eval_0( this_53 : MaterialBsdf_0,  wo_16 : vec3<f32>,  wi_13 : vec3<f32>) -> BsdfEval_0
{
    if((this_53.kind_0) == u32(1))
    {
        return Conductor_eval_0(Conductor_x24init_0(this_53.color_1, this_53.facets_0), wo_16, wi_13);
    }
    if((this_53.kind_0) == u32(2))
    {
        return Plastic_eval_0(Plastic_x24init_0(this_53.color_1, this_53.specular_1, this_53.eta_0, this_53.facets_0), wo_16, wi_13);
    }
    if((this_53.kind_0) == u32(3))
    {
        return Dielectric_eval_0(Dielectric_x24init_0(this_53.eta_0, this_53.facets_0), wo_16, wi_13);
    }
    if((this_53.kind_0) == u32(4))
    {
        return Phase_eval_0(Phase_x24init_0(this_53.color_1, this_53.specular_1), wo_16, wi_13);
    }
    return Diffuse_eval_0(Diffuse_x24init_0(this_53.color_1), wo_16, wi_13);
}

fn Plastic_albedo_0( this_54 : Plastic_0) -> vec3<f32>
{
    return max(this_54.reflectance_0, vec3<f32>(Plastic_coat_0(this_54, 1.0f)));
}

fn MaterialBsdf_albedo_0( this_55 : MaterialBsdf_0) -> vec3<f32>
{
    if((this_55.kind_0) == u32(2))
    {
        return Plastic_albedo_0(Plastic_x24init_0(this_55.color_1, this_55.specular_1, this_55.eta_0, this_55.facets_0));
    }
    if((this_55.kind_0) == u32(3))
    {
        return vec3<f32>(1.0f);
    }
    return this_55.color_1;
}

@compute
@workgroup_size(64, 1, 1)
fn check_bsdf(@builtin(global_invocation_id) id_12 : vec3<u32>, @builtin(local_invocation_index) thread_13 : u32)
{
    prove_0(thread_13);
    var _S346 : u32 = id_12.x;
    if(_S346 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_12 : Reader_0 = Reader_x24init_0(u32(25) * _S346);
    var writer_12 : Writer_0 = Writer_x24init_0(u32(16) * _S346);
    var material_7 : PackedMaterial_0;
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
        var _S347 : f32 = Reader_number_0(&(reader_12));
        material_7.base_color_0[channel_0] = _S347;
        channel_0 = channel_0 + u32(1);
    }
    var _S348 : f32 = Reader_number_0(&(reader_12));
    material_7.roughness_0 = _S348;
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
        var _S349 : f32 = Reader_number_0(&(reader_12));
        material_7.emission_0[channel_0] = _S349;
        channel_0 = channel_0 + u32(1);
    }
    var _S350 : f32 = Reader_number_0(&(reader_12));
    material_7.metallic_0 = _S350;
    var _S351 : f32 = Reader_number_0(&(reader_12));
    material_7.transmission_0 = _S351;
    var _S352 : f32 = Reader_number_0(&(reader_12));
    material_7.ior_0 = _S352;
    var _S353 : f32 = Reader_number_0(&(reader_12));
    material_7.specular_0 = _S353;
    var _S354 : f32 = Reader_number_0(&(reader_12));
    material_7.anisotropy_0 = _S354;
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
        var _S355 : f32 = Reader_number_0(&(reader_12));
        material_7.absorption_0[channel_0] = _S355;
        channel_0 = channel_0 + u32(1);
    }
    var _S356 : f32 = Reader_number_0(&(reader_12));
    material_7.scattering_0 = _S356;
    var wo_17 : vec3<f32> = Reader_vector_0(&(reader_12));
    var _S357 : vec3<f32> = Reader_vector_0(&(reader_12));
    var u_22 : vec3<f32> = _S357;
    var _S358 : f32 = u_22[i32(2)];
    var bsdf_0 : MaterialBsdf_0 = bsdf_of_0(material_7, 1.0f, &(_S358));
    u_22[i32(2)] = _S358;
    var sample_16 : BsdfSample_0;
    var is_found_4 : bool = MaterialBsdf_sample_0(bsdf_0, wo_17, u_22, &(sample_16));
    if(!is_found_4)
    {
        sample_16 = no_bsdf_sample_0();
    }
    var _S359 : vec3<f32> = Reader_vector_0(&(reader_12));
    var eval_1 : BsdfEval_0 = MaterialBsdf_eval_0(bsdf_0, wo_17, _S359);
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
    var power_3 : i32 = i32(x_18 * 1.4426950216293335f - 0.5f);
    var k_0 : f32 = f32(power_3);
    var r_0 : f32 = x_18 - k_0 * 0.693359375f - k_0 * -0.00021219444170129f;
    return (1.0f + r_0 * (1.0f + r_0 * (0.5f + r_0 * (0.1666666716337204f + r_0 * (0.0416666679084301f + r_0 * (0.00833333376795053f + r_0 * (0.00138888892251998f + r_0 * 0.0001984127011383f))))))) * (bitcast<f32>(((u32(i32(127) + power_3) << (u32(23))))));
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
    var _S360 : u32 = (bits_3 & (u32(8388607)));
    var is_upper_0 : bool = _S360 > u32(3474675);
    var power_4 : i32 = i32((bits_3 >> (u32(23)))) - i32(127) + i32(is_upper_0);
    var _S361 : u32;
    if(is_upper_0)
    {
        _S361 = u32(1056964608);
    }
    else
    {
        _S361 = u32(1065353216);
    }
    var mantissa_3 : f32 = (bitcast<f32>(((_S360 | (_S361)))));
    var s_1 : f32 = divide_0(mantissa_3 - 1.0f, mantissa_3 + 1.0f);
    var ss_0 : f32 = s_1 * s_1;
    var _S362 : f32 = f32(power_4);
    return _S362 * 0.693359375f + (_S362 * -0.00021219444170129f + s_1 * (2.0f + ss_0 * (0.66666668653488159f + ss_0 * (0.40000000596046448f + ss_0 * (0.28571429848670959f + ss_0 * 0.2222222238779068f)))));
}

fn free_path_0( medium_2 : PackedMaterial_0,  u_23 : f32) -> f32
{
    var _S363 : f32;
    if((medium_2.scattering_0) > 0.0f)
    {
        _S363 = divide_0(- logarithm_0(1.0f - u_23), medium_2.scattering_0);
    }
    else
    {
        _S363 = (bitcast<f32>(infinity_bits_0));
    }
    return _S363;
}

@compute
@workgroup_size(64, 1, 1)
fn check_medium(@builtin(global_invocation_id) id_13 : vec3<u32>, @builtin(local_invocation_index) thread_14 : u32)
{
    prove_0(thread_14);
    var _S364 : u32 = id_13.x;
    if(_S364 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_13 : Reader_0 = Reader_x24init_0(u32(12) * _S364);
    var writer_13 : Writer_0 = Writer_x24init_0(u32(10) * _S364);
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
        var _S365 : f32 = Reader_number_0(&(reader_13));
        medium_3.absorption_0[channel_1] = _S365;
        channel_1 = channel_1 + u32(1);
    }
    var _S366 : f32 = Reader_number_0(&(reader_13));
    medium_3.scattering_0 = _S366;
    var _S367 : f32 = Reader_number_0(&(reader_13));
    medium_3.anisotropy_0 = _S367;
    var voxels_3 : f32 = Reader_number_0(&(reader_13));
    var forward_1 : vec3<f32> = Reader_vector_0(&(reader_13));
    var u_24 : f32 = Reader_number_0(&(reader_13));
    var v_11 : f32 = Reader_number_0(&(reader_13));
    Writer_vector_0(&(writer_13), attenuation_0(medium_3, voxels_3));
    Writer_number_0(&(writer_13), unscattered_0(medium_3, voxels_3));
    Writer_number_0(&(writer_13), free_path_0(medium_3, u_24));
    var cos_14 : f32;
    var _S368 : vec3<f32> = sample_phase_0(_S367, forward_1, u_24, v_11, &(cos_14));
    Writer_vector_0(&(writer_13), _S368);
    Writer_number_0(&(writer_13), cos_14);
    var _S369 : f32 = Reader_number_0(&(reader_13));
    Writer_number_0(&(writer_13), phase_pdf_0(_S367, _S369));
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
    var _S370 : Perspective_0;
    _S370.eye_1 = eye_2;
    _S370.corner_2 = corner_3;
    _S370.pixel_x_1 = pixel_x_2;
    _S370.pixel_y_1 = pixel_y_2;
    return _S370;
}

struct Axes_0
{
     forward_2 : vec3<f32>,
     right_4 : vec3<f32>,
     up_0 : vec3<f32>,
};

fn Axes_x24init_0( forward_3 : vec3<f32>,  right_5 : vec3<f32>,  up_1 : vec3<f32>) -> Axes_0
{
    var _S371 : Axes_0;
    _S371.forward_2 = forward_3;
    _S371.right_4 = right_5;
    _S371.up_0 = up_1;
    return _S371;
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
    var _S372 : ThinLens_0;
    _S372.perspective_0 = perspective_1;
    _S372.lens_x_1 = lens_x_2;
    _S372.lens_y_1 = lens_y_2;
    _S372.blades_1 = blades_2;
    return _S372;
}

fn concentric_0( square_2 : vec2<f32>) -> vec2<f32>
{
    var a_8 : f32 = 2.0f * square_2.x - 1.0f;
    var b_7 : f32 = 2.0f * square_2.y - 1.0f;
    var _S373 : bool;
    if(a_8 == 0.0f)
    {
        _S373 = b_7 == 0.0f;
    }
    else
    {
        _S373 = false;
    }
    if(_S373)
    {
        return vec2<f32>(0.0f);
    }
    var is_across_0 : bool = (abs(a_8)) > (abs(b_7));
    var radius_6 : f32;
    if(is_across_0)
    {
        radius_6 = a_8;
    }
    else
    {
        radius_6 = b_7;
    }
    var turns_3 : f32;
    if(is_across_0)
    {
        turns_3 = divide_0(b_7, a_8) * 0.125f;
    }
    else
    {
        turns_3 = 0.25f - divide_0(a_8, b_7) * 0.125f;
    }
    if(radius_6 < 0.0f)
    {
        turns_3 = turns_3 + 0.5f;
    }
    var _S374 : f32 = abs(radius_6);
    if(turns_3 < 0.0f)
    {
        radius_6 = turns_3 + 1.0f;
    }
    else
    {
        radius_6 = turns_3;
    }
    return vec2<f32>(_S374, radius_6);
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
    var count_6 : f32 = f32(blades_3);
    var scaled_0 : f32 = radius_turns_0.y * count_6;
    var blade_0 : f32 = f32(min(u32(scaled_0), blades_3 - u32(1)));
    var share_8 : f32 = scaled_0 - blade_0;
    var from_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0, count_6));
    var to_0 : vec2<f32> = sincos_turns_0(divide_0(blade_0 + 1.0f, count_6));
    var _S375 : f32 = from_0.y;
    var _S376 : f32 = from_0.x;
    return vec2<f32>(_S375 + (to_0.y - _S375) * share_8, _S376 + (to_0.x - _S376) * share_8) * vec2<f32>(radius_7);
}

fn ThinLens_ray_0( this_56 : ThinLens_0,  position_1 : vec2<f32>,  lens_2 : vec2<f32>) -> Ray_0
{
    var place_4 : vec2<f32> = place_in_aperture_0(this_56.blades_1, lens_2);
    var offset_0 : vec3<f32> = this_56.lens_x_1 * vec3<f32>(place_4.x) + this_56.lens_y_1 * vec3<f32>(place_4.y);
    return ray_from_0(this_56.perspective_0.eye_1 + offset_0, normalize_vector_0(this_56.perspective_0.corner_2 + this_56.perspective_0.pixel_x_1 * vec3<f32>(position_1.x) + this_56.perspective_0.pixel_y_1 * vec3<f32>(position_1.y) - offset_0));
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
    var _S377 : Orthographic_0;
    _S377.corner_4 = corner_5;
    _S377.pixel_x_3 = pixel_x_4;
    _S377.pixel_y_3 = pixel_y_4;
    _S377.forward_4 = forward_5;
    return _S377;
}

fn Orthographic_ray_0( this_57 : Orthographic_0,  position_2 : vec2<f32>,  lens_3 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_57.corner_4 + this_57.pixel_x_3 * vec3<f32>(position_2.x) + this_57.pixel_y_3 * vec3<f32>(position_2.y), this_57.forward_4);
}

struct Panorama_0
{
     eye_3 : vec3<f32>,
     axes_1 : Axes_0,
     inverse_size_0 : vec2<f32>,
     half_eye_distance_0 : f32,
};

fn Panorama_x24init_0( eye_4 : vec3<f32>,  axes_2 : Axes_0,  inverse_size_1 : vec2<f32>,  half_eye_distance_1 : f32) -> Panorama_0
{
    var _S378 : Panorama_0;
    _S378.eye_3 = eye_4;
    _S378.axes_1 = axes_2;
    _S378.inverse_size_0 = inverse_size_1;
    _S378.half_eye_distance_0 = half_eye_distance_1;
    return _S378;
}

fn Panorama_ray_0( this_58 : Panorama_0,  position_3 : vec2<f32>,  lens_4 : vec2<f32>) -> Ray_0
{
    var latitude_0 : f32 = position_3.y * this_58.inverse_size_0.y;
    var is_right_eye_0 : bool = latitude_0 >= 1.0f;
    var side_4 : f32;
    if(is_right_eye_0)
    {
        side_4 = this_58.half_eye_distance_0;
    }
    else
    {
        side_4 = - this_58.half_eye_distance_0;
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
    var longitude_0 : vec2<f32> = sincos_turns_0(position_3.x * this_58.inverse_size_0.x);
    var height_2 : vec2<f32> = sincos_turns_0(latitude_1 * 0.5f);
    var _S379 : vec3<f32> = vec3<f32>(longitude_0.y);
    var _S380 : vec3<f32> = vec3<f32>(longitude_0.x);
    return ray_from_0(this_58.eye_3 + (this_58.axes_1.forward_2 * _S380 - this_58.axes_1.right_4 * _S379) * vec3<f32>(side_4), normalize_vector_0((vec3<f32>(0) - this_58.axes_1.forward_2 * _S379 + this_58.axes_1.right_4 * _S380) * vec3<f32>(height_2.x) + this_58.axes_1.up_0 * vec3<f32>(height_2.y)));
}

struct Fisheye_0
{
     eye_5 : vec3<f32>,
     axes_3 : Axes_0,
     middle_1 : vec2<f32>,
     turns_per_pixel_0 : f32,
};

fn Fisheye_x24init_0( eye_6 : vec3<f32>,  axes_4 : Axes_0,  middle_2 : vec2<f32>,  turns_per_pixel_1 : f32) -> Fisheye_0
{
    var _S381 : Fisheye_0;
    _S381.eye_5 = eye_6;
    _S381.axes_3 = axes_4;
    _S381.middle_1 = middle_2;
    _S381.turns_per_pixel_0 = turns_per_pixel_1;
    return _S381;
}

fn Fisheye_ray_0( this_59 : Fisheye_0,  position_4 : vec2<f32>,  lens_5 : vec2<f32>) -> Ray_0
{
    var x_20 : f32 = position_4.x - this_59.middle_1.x;
    var y_14 : f32 = position_4.y - this_59.middle_1.y;
    var radius_8 : f32 = square_root_0(x_20 * x_20 + y_14 * y_14);
    var sin_cos_7 : vec2<f32> = sincos_turns_0(min(radius_8 * this_59.turns_per_pixel_0, 1.0f));
    var scale_1 : f32;
    if(radius_8 > 0.0f)
    {
        scale_1 = divide_0(sin_cos_7.x, radius_8);
    }
    else
    {
        scale_1 = 0.0f;
    }
    return ray_from_0(this_59.eye_5, normalize_vector_0(this_59.axes_3.forward_2 * vec3<f32>(sin_cos_7.y) + this_59.axes_3.right_4 * vec3<f32>((x_20 * scale_1)) - this_59.axes_3.up_0 * vec3<f32>((y_14 * scale_1))));
}

fn Perspective_ray_0( this_60 : Perspective_0,  position_5 : vec2<f32>,  lens_6 : vec2<f32>) -> Ray_0
{
    return ray_from_0(this_60.eye_1, normalize_vector_0(this_60.corner_2 + this_60.pixel_x_1 * vec3<f32>(position_5.x) + this_60.pixel_y_1 * vec3<f32>(position_5.y)));
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

fn CameraFrame_ray_0( this_61 : CameraFrame_0,  position_6 : vec2<f32>,  lens_sample_0 : vec2<f32>) -> Ray_0
{
    var perspective_2 : Perspective_0 = Perspective_x24init_0(this_61.eye_7, this_61.corner_6, this_61.pixel_x_5, this_61.pixel_y_5);
    var axes_5 : Axes_0 = Axes_x24init_0(this_61.corner_6, this_61.pixel_x_5, this_61.pixel_y_5);
    switch(this_61.lens_7)
    {
    case u32(1):
        {
            return ThinLens_ray_0(ThinLens_x24init_0(perspective_2, this_61.lens_x_3, this_61.lens_y_3, this_61.blades_4), position_6, lens_sample_0);
        }
    case u32(2):
        {
            return Orthographic_ray_0(Orthographic_x24init_0(this_61.corner_6, this_61.pixel_x_5, this_61.pixel_y_5, this_61.lens_x_3), position_6, lens_sample_0);
        }
    case u32(3):
        {
            return Panorama_ray_0(Panorama_x24init_0(this_61.eye_7, axes_5, this_61.lens_x_3.xy, this_61.lens_x_3.z), position_6, lens_sample_0);
        }
    case u32(4):
        {
            return Fisheye_ray_0(Fisheye_x24init_0(this_61.eye_7, axes_5, this_61.lens_x_3.xy, this_61.lens_x_3.z), position_6, lens_sample_0);
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
    var _S382 : u32 = id_14.x;
    if(_S382 >= (dispatch_0.count_0))
    {
        return;
    }
    var reader_14 : Reader_0 = Reader_x24init_0(u32(24) * _S382);
    var writer_14 : Writer_0 = Writer_x24init_0(u32(8) * _S382);
    var camera_0 : CameraFrame_0;
    var _S383 : u32 = Reader_word_0(&(reader_14));
    camera_0.lens_7 = _S383;
    var _S384 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.eye_7 = _S384;
    var _S385 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.corner_6 = _S385;
    var _S386 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.pixel_x_5 = _S386;
    var _S387 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.pixel_y_5 = _S387;
    var _S388 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.lens_x_3 = _S388;
    var _S389 : vec3<f32> = Reader_vector_0(&(reader_14));
    camera_0.lens_y_3 = _S389;
    var _S390 : u32 = Reader_word_0(&(reader_14));
    camera_0.blades_4 = _S390;
    var x_21 : f32 = Reader_number_0(&(reader_14));
    var _S391 : f32 = Reader_number_0(&(reader_14));
    var position_7 : vec2<f32> = vec2<f32>(x_21, _S391);
    var u_25 : f32 = Reader_number_0(&(reader_14));
    var _S392 : f32 = Reader_number_0(&(reader_14));
    var ray_9 : Ray_0 = CameraFrame_ray_0(camera_0, position_7, vec2<f32>(u_25, _S392));
    Writer_vector_0(&(writer_14), ray_9.origin_1);
    Writer_number_0(&(writer_14), ray_9.t_min_0);
    Writer_vector_0(&(writer_14), ray_9.direction_1);
    Writer_number_0(&(writer_14), ray_9.t_max_0);
    return;
}

