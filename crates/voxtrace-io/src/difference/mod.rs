//! How much two pictures differ: as numbers (PSNR, RMSE, FLIP) and as a map of where. What is compared is what a screen
//! shows, the sRGB signal; files with radiance are tone-mapped first.

mod flip;
mod map;
mod shown;

pub use flip::{PIXELS_PER_DEGREE, flip};
#[doc(hidden)]
pub use shown::begins_as_picture;
pub use shown::{Shown, ShownError, is_picture};

use rayon::prelude::*;

/// Pictures of different sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the pictures have different sizes: {}x{} and {}x{}", .0[0].0, .0[0].1, .0[1].0, .0[1].1)]
pub struct SizesDiffer(
    /// Width and height of both, pixels.
    pub [(u32, u32); 2],
);

/// How much two pictures of one size differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Width of both, pixels.
    pub width: u32,
    /// Height of both, pixels.
    pub height: u32,
    /// Root of the mean squared difference of the channels of the sRGB signal, in [0, 1].
    pub rmse: f64,
    /// FLIP of each pixel, in [0, 1], row by row.
    pub flip: Vec<f32>,
}

impl Difference {
    /// Compares two pictures.
    ///
    /// # Errors
    /// [`SizesDiffer`].
    pub fn of(a: &Shown, b: &Shown) -> Result<Self, SizesDiffer> {
        let sizes = [(a.width, a.height), (b.width, b.height)];
        if sizes[0] != sizes[1] {
            return Err(SizesDiffer(sizes));
        }
        // Rows are added up in their order, so that the last digit does not depend on the threads.
        let rows = a.signal.par_chunks(a.width as usize).zip(b.signal.par_chunks(a.width as usize));
        let squares: Vec<f64> = rows
            .map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a.as_dvec3() - b.as_dvec3()).length_squared()).sum())
            .collect();
        let channels = 3.0 * a.signal.len().max(1) as f64;
        let rmse = (squares.iter().sum::<f64>() / channels).sqrt();
        Ok(Self { width: a.width, height: a.height, rmse, flip: flip(a, b, PIXELS_PER_DEGREE) })
    }

    /// Peak signal-to-noise ratio, dB; infinite where the pictures are the same.
    pub fn psnr(&self) -> f64 {
        -20.0 * self.rmse.log10()
    }

    /// Mean of FLIP, in [0, 1].
    pub fn mean_flip(&self) -> f64 {
        self.flip.iter().map(|&value| f64::from(value)).sum::<f64>() / self.flip.len().max(1) as f64
    }

    /// The largest FLIP of a pixel, in [0, 1].
    pub fn max_flip(&self) -> f32 {
        self.flip.iter().copied().fold(0.0, f32::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn grey(value: f32) -> Shown {
        Shown { width: 8, height: 4, signal: vec![Vec3::splat(value); 32] }
    }

    /// Checks a comparison of two even greys against the closed form.
    fn check(difference: &Difference, step: f64) -> Result<(), String> {
        let expected = -20.0 * step.log10();
        if (difference.rmse - step).abs() > 1e-6 || (difference.psnr() - expected).abs() > 1e-3 {
            return Err(format!("RMSE {}, PSNR {} instead of {step}, {expected}", difference.rmse, difference.psnr()));
        }
        Ok(())
    }

    #[test]
    fn a_step_of_grey_has_the_error_of_the_step() {
        check(&Difference::of(&grey(0.5), &grey(0.4)).unwrap(), 0.1).unwrap();
        let mut one_channel = grey(0.5);
        one_channel.signal.iter_mut().for_each(|signal| signal.x -= 0.1);
        check(&Difference::of(&grey(0.5), &one_channel).unwrap(), 0.1 / 3.0_f64.sqrt()).unwrap();
        check(&Difference::of(&grey(0.5), &one_channel).unwrap(), 0.1).unwrap_err();
    }

    #[test]
    fn the_same_picture_differs_by_nothing_and_other_sizes_are_refused() {
        let same = Difference::of(&grey(0.3), &grey(0.3)).unwrap();
        assert_eq!((same.rmse, same.psnr(), same.mean_flip(), same.max_flip()), (0.0, f64::INFINITY, 0.0, 0.0));
        let wide = Shown { width: 16, height: 2, ..grey(0.3) };
        assert_eq!(Difference::of(&grey(0.3), &wide), Err(SizesDiffer([(8, 4), (16, 2)])));
    }
}
