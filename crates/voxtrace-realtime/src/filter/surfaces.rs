//! How alike the surfaces of two pixels are, and the taps of kernels. As in `denoise/surfaces` of `voxtrace-core`: mean normals and places are compared, with
//! tolerances that grow with how much they vary within the pixel.

use crate::memory::Memory;
use rayon::prelude::*;

/// Square of the distance of mean normals at which pixels are no longer alike, for pixels that show one plane, and how much each
/// unit of the normals' variance adds to it.
const NORMAL_TOLERANCE: [f32; 2] = [0.4, 1.0];
/// Square of the distance of a place from the other's plane at which pixels are no longer alike, square voxels, and how much
/// each unit of the variance of places adds to it.
const PLACE_TOLERANCE: [f32; 2] = [12.0, 1.0];
/// How alike pixels are at least, times the paths that they remember: after few, one that is like no other borrows from all around.
const LEAST_ALIKE: f32 = 0.2;

/// The cubic B-spline, from the middle outwards: the kernel of means.
const SPLINE: [f32; 3] = [3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];

/// What pixels show.
pub struct Surfaces<'a> {
    pub memory: &'a [Memory],
    pub width: usize,
    scales: Vec<Scales>,
}

/// How much pixels may differ from one.
#[derive(Clone, Copy)]
struct Scales {
    /// One over the square distance of normals.
    normal: f32,
    /// One over the square distance from the plane.
    place: f32,
    /// How alike others are at least.
    least: f32,
}

impl<'a> Surfaces<'a> {
    pub fn new(memory: &'a [Memory], width: usize) -> Self {
        let scales = |pixel: &Memory| {
            let spread = (1.0 - pixel.normal.length_squared()).max(0.0);
            Scales {
                normal: 1.0 / (NORMAL_TOLERANCE[0] + NORMAL_TOLERANCE[1] * spread),
                place: 1.0 / (PLACE_TOLERANCE[0] + PLACE_TOLERANCE[1] * pixel.roughness),
                least: LEAST_ALIKE / pixel.paths.max(1.0),
            }
        };
        Self { memory, width, scales: memory.par_iter().map(scales).collect() }
    }

    /// How alike the pixel `to` is to `from`: in 0..=1, a little more where it must borrow.
    pub fn alike(&self, from: usize, to: usize) -> f32 {
        let (a, b, scales) = (&self.memory[from], &self.memory[to], &self.scales[from]);
        if a.coverage <= 0.0 || b.coverage <= 0.0 {
            return 0.0;
        }
        let distance = a.normal.dot(b.place - a.place);
        let normals = (1.0 - (a.normal - b.normal).length_squared() * scales.normal).max(0.0);
        let places = (1.0 - distance * distance * scales.place).max(0.0);
        normals * normals * places * places + scales.least
    }

    /// Calls `each` with the pixels around `of`, `reach` on either side and `step` apart, and their offsets in steps.
    pub fn around(&self, of: usize, reach: i32, step: i32, mut each: impl FnMut(usize, i32, i32)) {
        let (width, height) = (self.width as i32, (self.memory.len() / self.width) as i32);
        let (x, y) = ((of % self.width) as i32, (of / self.width) as i32);
        for dy in -reach..=reach {
            for dx in -reach..=reach {
                let (u, v) = (x + dx * step, y + dy * step);
                if (0..width).contains(&u) && (0..height).contains(&v) {
                    each((v * width + u) as usize, dx, dy);
                }
            }
        }
    }

    /// The mean of the pixels around each that are alike.
    pub fn mean(&self, values: &[f32], step: i32) -> Vec<f32> {
        let mean = |of: usize| {
            let (mut sum, mut weights) = (0.0, 0.0);
            self.around(of, 2, step, |at, dx, dy| {
                let weight =
                    SPLINE[dx.unsigned_abs() as usize] * SPLINE[dy.unsigned_abs() as usize] * self.alike(of, at);
                sum += weight * values[at];
                weights += weight;
            });
            sum / f32::max(weights, 1e-20)
        };
        (0..values.len()).into_par_iter().map(mean).collect()
    }
}
