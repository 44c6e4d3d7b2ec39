//! What is done to attributes once they are decoded (appendix B): directions from two numbers, rotations from three, floats from
//! a mantissa and an exponent.

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
        assert!(apply("QUATERNION", &mut [0; 4], 4).is_err() && apply("COLOR", &mut [0; 4], 4).is_err());
    }
}
