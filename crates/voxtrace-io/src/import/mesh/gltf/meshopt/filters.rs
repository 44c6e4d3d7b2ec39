//! What is done to attributes once they are decoded (appendix B): directions from two numbers, rotations from three, floats from
//! a mantissa and an exponent, and with `KHR_` colours from luma and chroma.

/// Applies a filter to elements of `stride` bytes.
pub(super) fn apply(filter: &str, bytes: &mut [u8], stride: usize) -> Result<(), &'static str> {
    match (filter, stride) {
        ("NONE", _) => {}
        ("OCTAHEDRAL", 4) => bytes.as_chunks_mut().0.iter_mut().for_each(|element: &mut [u8; 4]| {
            let numbers = element.map(|byte| f32::from(byte as i8));
            let [x, y, z] = direction(numbers, 127.0);
            *element = [x as i8 as u8, y as i8 as u8, z as i8 as u8, element[3]];
        }),
        ("OCTAHEDRAL", 8) => each_short(bytes, |element| {
            let [x, y, z] = direction(element.map(f32::from), 32_767.0);
            [x as i16, y as i16, z as i16, element[3]]
        }),
        ("QUATERNION", 8) => each_short(bytes, rotation),
        ("EXPONENTIAL", _) => bytes.as_chunks_mut().0.iter_mut().for_each(|element: &mut [u8; 4]| {
            let bits = i32::from_le_bytes(*element);
            let (mantissa, exponent) = (bits << 8 >> 8, bits >> 24);
            *element = ((f64::from(mantissa) * 2f64.powi(exponent)) as f32).to_le_bytes();
        }),
        ("COLOR", 4) => bytes.as_chunks_mut().0.iter_mut().for_each(|element: &mut [u8; 4]| {
            let [luma, orange, green, alpha] = *element;
            let [orange, green] = [orange, green].map(|byte| i32::from(byte as i8));
            *element = color([luma.into(), orange, green, alpha.into()], 255.0).map(|value| value as u8);
        }),
        ("COLOR", 8) => each_short(bytes, |element| {
            let [luma, orange, green, alpha] = element;
            let unsigned = |short: i16| i32::from(short as u16);
            let element = [unsigned(luma), orange.into(), green.into(), unsigned(alpha)];
            color(element, 65_535.0).map(|value| value as u16 as i16)
        }),
        _ => return Err("a filter that is unknown, or not for elements of this size"),
    }
    Ok(())
}

fn each_short(bytes: &mut [u8], change: impl Fn([i16; 4]) -> [i16; 4]) {
    for element in bytes.as_chunks_mut::<8>().0 {
        let shorts = std::array::from_fn(|n| i16::from_le_bytes([element[2 * n], element[2 * n + 1]]));
        element.copy_from_slice(change(shorts).map(i16::to_le_bytes).as_flattened());
    }
}

/// A direction of length `full` from its place on an octahedron whose size is the third number.
fn direction([x, y, size, _]: [f32; 4], full: f32) -> [f32; 3] {
    let z = size - x.abs() - y.abs();
    // The lower half is folded over the upper one.
    let fold = z.min(0.0);
    let unfolded = |c: f32| c + if c >= 0.0 { fold } else { -fold };
    let (x, y) = (unfolded(x), unfolded(y));
    let scale = full / (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|c| (c * scale).round())
}

/// A colour of red, green, blue and alpha, each up to `full`, from its luma and chroma (YCoCg) of fewer bits: how many, the highest
/// bit of the last number says, below which alpha stands with a bit less.
fn color([luma, orange, green, alpha]: [i32; 4], full: f32) -> [i32; 4] {
    let bits = 32 - alpha.leading_zeros();
    let highest = (1i32 << bits) - 1;
    let alpha = (alpha << 1 & highest) | (alpha & 1);
    let scale = full / highest.max(1) as f32;
    let channels = [luma + orange - green, luma + green, luma - orange - green, alpha];
    channels.map(|value| (value as f32 * scale).round().clamp(0.0, full) as i32)
}

/// A quaternion from its three smaller numbers; the lowest bits of the fourth say which is missing.
fn rotation([x, y, z, last]: [i16; 4]) -> [i16; 4] {
    let scale = std::f32::consts::FRAC_1_SQRT_2 / f32::from(last | 3);
    let smaller = [x, y, z].map(|c| f32::from(c) * scale);
    let largest = (1.0 - smaller.iter().map(|c| c * c).sum::<f32>()).max(0.0).sqrt();
    let missing = (last & 3) as usize;
    let mut rotation = [0; 4];
    for (step, c) in [largest, smaller[0], smaller[1], smaller[2]].into_iter().enumerate() {
        rotation[(missing + step) & 3] = (c * 32_767.0).round() as i16;
    }
    rotation
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shorts(numbers: &[[i16; 4]]) -> Vec<u8> {
        numbers.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect()
    }

    /// What meshoptimizer 1.3 gives for what it had packed; it rounds halves otherwise.
    #[test]
    fn directions_and_rotations_are_those_of_meshoptimizer() {
        let near = |found: &[u8], wanted: &[u8], step: usize| {
            let number = |bytes: &[u8]| match bytes {
                [low, high] => i32::from(i16::from_le_bytes([*low, *high])),
                _ => i32::from(bytes[0] as i8),
            };
            let pairs = found.chunks(step).zip(wanted.chunks(step));
            assert!(pairs.clone().all(|(a, b)| (number(a) - number(b)).abs() <= 1), "{found:?} {wanted:?}");
        };
        let mut bytes = [92, -83, 127, 127, -28, 37, 127, 0, 127, 127, 127, 127].map(|number: i8| number as u8);
        apply("OCTAHEDRAL", &mut bytes, 4).unwrap();
        near(&bytes, &[76, -60, -82, 127, -46, 61, 102, 0, 0, 0, -127, 127].map(|number: i8| number as u8), 1);
        let mut bytes = shorts(&[[1476, -1333, 2047, 32_767], [-449, 599, 2047, 0]]);
        apply("OCTAHEDRAL", &mut bytes, 8).unwrap();
        near(&bytes, &shorts(&[[19_658, -15_721, -20_979, 32_767], [-11_785, 15_723, 26_222, 0]]), 2);
        let mut bytes = shorts(&[[-289, 2026, 289, 2045], [289, -868, 868, 2044], [0, 0, -579, 2047]]);
        apply("QUATERNION", &mut bytes, 8).unwrap();
        let wanted = [[3271, 22_943, -3271, 22_932], [29_494, 3271, -9825, 9825], [0, 0, -6554, 32_105]];
        near(&bytes, &shorts(&wanted), 2);
        let mut bytes = [[3u8, 0, 0, 0xff], [0xff, 0xff, 0xff, 2]].concat();
        apply("EXPONENTIAL", &mut bytes, 8).unwrap();
        assert_eq!(bytes, [1.5f32.to_le_bytes(), (-4.0f32).to_le_bytes()].concat());
        assert!(apply("QUATERNION", &mut [0; 4], 4).is_err() && apply("COLOR", &mut [0; 16], 16).is_err());
    }

    /// What meshoptimizer 1.3 gives for what it had packed.
    #[test]
    fn colours_are_those_of_meshoptimizer() {
        let near = |found: &[i32], wanted: &[i32], step: i32| {
            assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= step), "{found:?} {wanted:?}");
        };
        let mut bytes = [64, 127, 193, 255, 147, 167, 6, 192, 0, 0, 0, 128, 255, 0, 0, 255, 77, 205, 205, 160];
        apply("COLOR", &mut bytes, 4).unwrap();
        let wanted = [254, 1, 0, 255, 52, 153, 230, 128, 0, 0, 0, 0, 255, 255, 255, 255, 77, 26, 179, 64];
        near(&bytes.map(i32::from), &wanted, 0);
        let packed = [[1024, 2047, -1023, 4095], [2355, -1433, 102, 3072], [0, 0, 0, 2048], [1229, -819, -819, 2560]];
        let mut bytes = shorts(&packed);
        apply("COLOR", &mut bytes, 8).unwrap();
        let found: Vec<i32> = bytes.as_chunks().0.iter().map(|&pair| u16::from_le_bytes(pair).into()).collect();
        let wanted = [65_519, 16, 0, 65_535, 13_123, 39_321, 58_990, 32_776, 0, 0, 0, 0, 19_668, 6562, 45_882, 16_388];
        near(&found, &wanted, 1);
        // No bits at all, and chroma that leads out of what there is, are some colour.
        apply("COLOR", &mut [255, 127, 127, 0, 0, 127, 128, 1], 4).unwrap();
    }
}
