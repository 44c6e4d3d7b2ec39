//! A synthetic CT of a chest as a NIfTI-1 file (nifti.nimh.nih.gov/nifti-1): skin, fat, muscle, lungs, heart, spine and ribs, in whole Hounsfield
//! units. All of it is made of ellipsoids and tubes: no scan of anybody is in it.

use crate::terrain::random;
use glam::{DVec2, DVec3};
use rayon::prelude::*;

/// Bytes before the samples.
const HEADER: usize = 352;

/// A NIfTI file of so many samples along each axis, with noise of at most so many Hounsfield units.
pub fn nifti(samples: usize, noise: f64) -> Vec<u8> {
    let mut bytes = vec![0; HEADER + 2 * samples.pow(3)];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, &348i32.to_le_bytes());
    for (at, value) in [3, samples as i16, samples as i16, samples as i16, 1, 1, 1, 1].into_iter().enumerate() {
        put(40 + 2 * at, &value.to_le_bytes());
    }
    // Samples of 16 bits with a sign.
    put(70, &4i16.to_le_bytes());
    put(72, &16i16.to_le_bytes());
    // The chest is 320 mm wide.
    let spacing = 320.0 / samples as f32;
    for (at, value) in [1.0f32, spacing, spacing, spacing].into_iter().enumerate() {
        put(76 + 4 * at, &value.to_le_bytes());
    }
    put(108, &(HEADER as f32).to_le_bytes());
    put(112, &1f32.to_le_bytes());
    // Millimetres.
    put(123, &[2]);
    put(344, b"n+1\0");
    let place = |at: usize| {
        let at = [at % samples, at / samples % samples, at / samples / samples];
        DVec3::from_array(at.map(|at| (at as f64 + 0.5) / samples as f64 * 2.0 - 1.0))
    };
    let row = |(row, bytes): (usize, &mut [u8])| {
        for (column, sample) in bytes.chunks_exact_mut(2).enumerate() {
            let at = row * samples + column;
            let shares = (0..3).map(|part| random(at as u64, part)).sum::<f64>() / 1.5 - 1.0;
            sample.copy_from_slice(&((hounsfield(place(at)) + noise * shares) as i16).to_le_bytes());
        }
    };
    bytes[HEADER..].par_chunks_mut(2 * samples).enumerate().for_each(row);
    bytes
}

/// What is at a place, where each coordinate is from −1 to 1: x to the left of the patient, y to the back, z up.
fn hounsfield(at: DVec3) -> f64 {
    // The trunk is open above and below, and narrower at the neck.
    let trunk = DVec2::new(at.x, at.y * 1.45).length() + 0.25 * (at.z - 0.1).max(0.0).powi(2);
    let side = |at: DVec3| DVec3::new(at.x.abs(), at.y, at.z);
    let lung = ((side(at) - DVec3::new(0.38, -0.02, 0.0)) / DVec3::new(0.27, 0.42, 0.78)).length();
    let heart = ((at - DVec3::new(0.1, -0.18, -0.2)) / DVec3::new(0.26, 0.24, 0.32)).length();
    // Twelve vertebrae, with discs between them, and the spinous processes behind.
    let (spine, vertebra) = (DVec2::new(at.x, at.y - 0.38).length(), (at.z * 6.0).rem_euclid(1.0));
    let process = DVec2::new(at.x * 2.5, at.y - 0.52).length();
    // Ribs run around the lungs and fall to the front.
    let rib = ((at.z + 0.35 * (0.4 - at.y)) * 6.0).rem_euclid(1.0);
    let cage = (DVec2::new(at.x / 0.74, (at.y - 0.02) / 0.52)).length();
    let breastbone = DVec2::new(at.x / 0.09, (at.y + 0.51) / 0.035).length();
    match () {
        () if trunk > 0.93 => -1000.0,
        () if trunk > 0.915 => 60.0,
        () if spine < 0.12 && vertebra < 0.8 => 350.0 + 350.0 * f64::from(spine > 0.1),
        () if spine < 0.11 => 90.0,
        () if process < 0.09 && vertebra < 0.45 => 600.0,
        () if breastbone < 1.0 && at.z.abs() < 0.6 => 500.0,
        () if (0.96..1.03).contains(&cage) && rib < 0.38 && at.z < 0.75 => 800.0,
        () if heart < 0.85 => 180.0,
        () if heart < 1.0 => 50.0,
        () if lung < 1.0 => -820.0,
        () if trunk > 0.85 => -95.0,
        () => 45.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chest_has_air_around_it_and_bone_lungs_and_muscle_within() {
        let bytes = nifti(48, 0.0);
        assert_eq!(bytes.len(), HEADER + 2 * 48 * 48 * 48);
        let samples: Vec<i16> =
            bytes[HEADER..].chunks_exact(2).map(|pair| i16::from_le_bytes([pair[0], pair[1]])).collect();
        let share = |least: i16, most: i16| {
            samples.iter().filter(|&&sample| (least..=most).contains(&sample)).count() as f64 / samples.len() as f64
        };
        assert!(share(-1000, -1000) > 0.3 && share(-820, -820) > 0.05);
        assert!(share(40, 60) > 0.1 && (0.01..0.1).contains(&share(300, 1000)));
        // Left and right differ by the heart alone.
        assert!(nifti(48, 30.0) != bytes);
    }
}
