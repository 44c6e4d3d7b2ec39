//! Where two tracers differ: pixels whose films do, or rays through the middles of pixels that meet other voxels, which is what the
//! benchmark counts as wrong ones. Both are shown black in the first one's picture, as in the study's Figure 7.

use super::View;
use crate::tr;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::{Film, Hit, Ray};
use voxtrace_bench::is_same_voxel;

/// What is shown of two tracers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Contrast {
    /// Both pictures, with a divider between them.
    #[default]
    Beside,
    /// The first picture; black where the second one's film is not the same.
    Films,
    /// The first picture; black where the second tracer finds another voxel.
    Voxels,
}

impl Contrast {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Beside, Self::Films, Self::Voxels];

    /// What it is, for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Beside => tr!("comparison.beside"),
            Self::Films => tr!("comparison.films"),
            Self::Voxels => tr!("comparison.voxels"),
        }
    }
}

/// The rays through the middles of the pixels of a view, row by row.
pub(super) fn central_rays(view: &View) -> Vec<Ray> {
    let camera = view.camera.frame(view.width, view.height);
    let middle = |index: u32| Vec2::new((index % view.width) as f32 + 0.5, (index / view.width) as f32 + 0.5);
    (0..view.width * view.height).map(|index| camera.central_ray(middle(index))).collect()
}

/// For each pixel whether two tracers met different voxels.
pub(super) fn differing_voxels(first: &[Hit], second: &[Hit]) -> Vec<bool> {
    first.iter().zip(second).map(|(a, b)| !is_same_voxel(a, b)).collect()
}

/// For each pixel whether two films differ in any bit.
pub(super) fn differing_pixels(first: &Film, second: &Film) -> Vec<bool> {
    first.pixels.iter().zip(&second.pixels).map(|(a, b)| a != b).collect()
}

/// Blackens pixels of a film. Returns how many.
pub(super) fn blacken(film: &mut Film, is_black: &[bool]) -> u64 {
    let mut count = 0;
    for (pixel, _) in film.pixels.iter_mut().zip(is_black).filter(|(_, is_black)| **is_black) {
        *pixel = voxtrace::film::Pixel::default();
        pixel.add(Vec3::ZERO, true);
        count += 1;
    }
    count
}
