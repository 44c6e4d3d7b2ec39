//! How alike the surfaces of two pixels are: the weights that stop the filter at edges. Two pixels of one plane are wholly alike. Where voxels are
//! smaller than pixels a pixel shows several planes: then mean normals and places are compared, with tolerances that grow with how much
//! they vary within the pixel (Rousselle, Manzi, Zwicker, "Robust Denoising using Feature and Color Information", PG 2013).

use super::features::{FeaturePixel, Features};
use glam::Vec3;
use rayon::prelude::*;

/// Square of the distance of mean normals at which pixels are no longer alike, for pixels that show one plane, and how much each
/// unit of the normals' variance adds to it.
const NORMAL_TOLERANCE: [f32; 2] = [0.4, 1.0];
/// Square of the distance of a place from the other's plane at which pixels are no longer alike, square voxels, and how much
/// each unit of the variance of places adds to it.
const PLACE_TOLERANCE: [f32; 2] = [6.0, 1.0];
/// Length of the normals of black surfaces, which no other surface is like then: what they send back, nothing, says nothing about the light that
/// falls on those beside them.
const BLACK: f32 = 8.0;

/// The features as the filter reads them, one plane a number.
pub struct Surfaces<'a> {
    pub width: usize,
    /// Mean normals, of black surfaces longer.
    pub normal: [Vec<f32>; 3],
    /// Mean places.
    pub place: [Vec<f32>; 3],
    /// One over the square distance of normals at which pixels are no longer alike.
    pub normal_scale: Vec<f32>,
    /// One over the square distance from the plane at which pixels are no longer alike.
    pub place_scale: Vec<f32>,
    /// Share of samples that met a surface: 0 or less counts as no pixel.
    pub coverage: Vec<f32>,
    /// Whether somebody still waits for the picture.
    pub wanted: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> Surfaces<'a> {
    pub fn new(features: &Features, width: usize, wanted: &'a (dyn Fn() -> bool + Sync)) -> Self {
        let plane = |of: &(dyn Fn(&FeaturePixel) -> f32 + Sync)| features.pixels.par_iter().map(of).collect();
        let normal =
            |pixel: &FeaturePixel| if pixel.albedo == Vec3::ZERO { BLACK * pixel.normal } else { pixel.normal };
        let spread = |pixel: &FeaturePixel| (1.0 - pixel.normal.length_squared()).max(0.0);
        Self {
            width,
            normal: [plane(&|p| normal(p).x), plane(&|p| normal(p).y), plane(&|p| normal(p).z)],
            place: [plane(&|p| p.position.x), plane(&|p| p.position.y), plane(&|p| p.position.z)],
            normal_scale: plane(&|p| 1.0 / (NORMAL_TOLERANCE[0] + NORMAL_TOLERANCE[1] * spread(p))),
            place_scale: plane(&|p| 1.0 / (PLACE_TOLERANCE[0] + PLACE_TOLERANCE[1] * p.roughness)),
            coverage: plane(&|p| p.coverage),
            wanted,
        }
    }

    /// How alike the pixels `from..from + out.len()` are to those `offset` further on: in 0..=1.
    pub fn alike(&self, from: usize, offset: isize, out: &mut [f32]) {
        let count = out.len();
        let to = from.wrapping_add_signed(offset);
        let [nx, ny, nz] = self.normal.each_ref().map(|plane| &plane[from..from + count]);
        let [mx, my, mz] = self.normal.each_ref().map(|plane| &plane[to..to + count]);
        let [px, py, pz] = self.place.each_ref().map(|plane| &plane[from..from + count]);
        let [qx, qy, qz] = self.place.each_ref().map(|plane| &plane[to..to + count]);
        let normal_scale = &self.normal_scale[from..from + count];
        let place_scale = &self.place_scale[from..from + count];
        let covered = &self.coverage[to..to + count];
        for i in 0..count {
            let (dx, dy, dz) = (nx[i] - mx[i], ny[i] - my[i], nz[i] - mz[i]);
            let distance = nx[i] * (qx[i] - px[i]) + ny[i] * (qy[i] - py[i]) + nz[i] * (qz[i] - pz[i]);
            let normals = (1.0 - (dx * dx + dy * dy + dz * dz) * normal_scale[i]).max(0.0);
            let places = (1.0 - distance * distance * place_scale[i]).max(0.0);
            let there = if covered[i] > 0.0 { 1.0 } else { 0.0 };
            out[i] = normals * normals * places * places * there;
        }
    }
}
