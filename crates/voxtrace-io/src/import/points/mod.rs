//! Clouds of points: LAS and LAZ, XYZ, PCD and E57.

pub(crate) mod e57;
pub(crate) mod las;
pub(crate) mod pcd;
pub(crate) mod xyz;

/// Intensities as whole numbers: counts of 16 bits stay as they are, shares of one become parts of 65,535, and what is neither, such as numbers
/// below zero or decibels, is spread from the least to the largest.
fn whole_intensities(values: &[f32]) -> Vec<u16> {
    const MOST: f32 = 65_535.0;
    // Numbers so large stand for none.
    let finite = || values.iter().copied().filter(|value| value.abs() < 1e30);
    let (low, high) = finite().fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    let is_count = low >= 0.0 && high <= MOST && finite().all(|value| value.fract() == 0.0);
    let (from, full) = if is_count {
        (0.0, MOST)
    } else if low >= 0.0 && high <= 1.0 {
        (0.0, 1.0)
    } else {
        (low, high)
    };
    // What is no number is dark.
    let share =
        |value: f32| ((f64::from(value) - f64::from(from)) / (f64::from(full) - f64::from(from))).clamp(0.0, 1.0);
    values.iter().map(|&value| (share(value) * f64::from(MOST)).round() as u16).collect()
}

#[cfg(test)]
mod tests {
    use super::whole_intensities;

    #[test]
    fn intensities_keep_their_differences_whatever_their_range() {
        assert_eq!(whole_intensities(&[7.0, 0.0, 65_535.0, 300.0]), [7, 0, 65_535, 300]);
        assert_eq!(whole_intensities(&[0.0, 0.25, 0.5]), [0, 16_384, 32_768]);
        assert_eq!(whole_intensities(&[1.0, 0.0]), [1, 0]);
        assert_eq!(whole_intensities(&[-2048.0, 2047.0, 0.0]), [0, 65_535, 32_776]);
        assert_eq!(whole_intensities(&[-30.5, -10.5, f32::NAN, -20.5]), [0, 65_535, 0, 32_768]);
        assert_eq!(whole_intensities(&[2.5, 2.5]), [0, 0]);
        assert_eq!(whole_intensities(&[0.5, 0.0, 1e30]), [32_768, 0, 65_535]);
        assert!(whole_intensities(&[]).is_empty());
    }
}
