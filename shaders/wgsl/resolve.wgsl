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
struct PixelRecord_std430_0
{
    @align(4) radiance_0 : array<u32, i32(6)>,
    @align(4) samples_1 : u32,
    @align(4) covered_0 : u32,
};

@binding(10) @group(0) var<storage, read_write> pixels_0 : array<PixelRecord_std430_0>;

@binding(12) @group(0) var<storage, read_write> picture_0 : array<vec2<u32>>;

@binding(15) @group(0) var<storage, read_write> counters_0 : array<atomic<u32>>;

fn sum_of_0( low_0 : u32,  high_0 : u32) -> f32
{
    return f32(high_0) + f32(low_0) * 2.32830643653869629e-10f;
}

fn half_of_0( value_0 : f32) -> u32
{
    var bits_0 : u32 = (bitcast<u32>((clamp(value_0, -65504.0f, 65504.0f))));
    var exponent_0 : i32 = i32((((bits_0 >> (u32(23)))) & (u32(255)))) - i32(112);
    var mantissa_0 : u32 = (bits_0 & (u32(8388607)));
    var magnitude_0 : u32;
    if(exponent_0 >= i32(1))
    {
        magnitude_0 = (((u32(exponent_0) << (u32(10)))) | (((mantissa_0 >> (u32(13))))));
    }
    else
    {
        if(exponent_0 >= i32(-10))
        {
            magnitude_0 = (((mantissa_0 | (u32(8388608)))) >> (u32(i32(14) - exponent_0)));
        }
        else
        {
            magnitude_0 = u32(0);
        }
    }
    return (((((bits_0 >> (u32(16)))) & (u32(32768)))) | (magnitude_0));
}

@compute
@workgroup_size(64, 1, 1)
fn resolve(@builtin(global_invocation_id) id_0 : vec3<u32>, @builtin(local_invocation_index) thread_0 : u32)
{
    var _S1 : u32 = id_0.x;
    if(_S1 < (dispatch_0.count_0))
    {
        var index_0 : u32 = dispatch_0.first_0 + _S1;
        var scale_0 : f32 = 1.0f / f32(max(pixels_0[index_0].samples_1, u32(1)));
        var red_0 : f32 = sum_of_0(pixels_0[index_0].radiance_0[i32(0)], pixels_0[index_0].radiance_0[i32(1)]) * scale_0;
        var green_0 : f32 = sum_of_0(pixels_0[index_0].radiance_0[i32(2)], pixels_0[index_0].radiance_0[i32(3)]) * scale_0;
        var blue_0 : f32 = sum_of_0(pixels_0[index_0].radiance_0[i32(4)], pixels_0[index_0].radiance_0[i32(5)]) * scale_0;
        var coverage_0 : f32;
        if((pixels_0[index_0].samples_1) == u32(0))
        {
            coverage_0 = -1.0f;
        }
        else
        {
            coverage_0 = f32(pixels_0[index_0].covered_0) * scale_0;
        }
        picture_0[dispatch_0.samples_0 + index_0] = vec2<u32>(((half_of_0(red_0)) | ((((half_of_0(green_0)) << (u32(16)))))), ((half_of_0(blue_0)) | ((((half_of_0(coverage_0)) << (u32(16)))))));
    }
    if(thread_0 == u32(0))
    {
        if(_S1 == u32(0))
        {
            atomicStore(&(counters_0[u32(0)]), dispatch_0.sequence_0);
        }
        var _S2 : u32 = atomicAdd(&(counters_0[u32(4)]), u32(1));
    }
    return;
}

