//! The distance at which a box fills the picture: the fit of `PackedScene::overview`, for any direction and field of view.

use super::parallel;
use super::pose::{FURTHEST, Pose};
use voxtrace::glam::DVec3;

/// Empty border, as a share of the picture's half width and height.
const MARGIN: f64 = 0.03;
/// Nearest eye to the middle of what is framed, voxels.
const NEAREST_EYE: f64 = 1.0;

/// A box in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub min: DVec3,
    pub max: DVec3,
}

impl Bounds {
    /// The box, unless it is empty, not finite, or larger than a scene can be.
    pub fn new(min: DVec3, max: DVec3) -> Option<Self> {
        let is_box = min.cmple(max).all() && min.min_element() >= -FURTHEST && max.max_element() <= FURTHEST;
        is_box.then_some(Self { min, max })
    }

    pub fn middle(&self) -> DVec3 {
        (self.min + self.max) * 0.5
    }

    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        (0..8).map(|corner| {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { self.max[axis] } else { self.min[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }

    /// Length of the diagonal, at least that of one voxel.
    pub fn diagonal(&self) -> f64 {
        (self.max - self.min).length().max(1.0)
    }
}

/// The pose that looks as `pose` does and sees the whole box as large as it can be.
pub fn framed(pose: Pose, bounds: &Bounds, aspect: f64) -> Pose {
    let (middle, basis) = (bounds.middle(), pose.basis());
    let tan_y = (f64::from(pose.fov_y).to_radians() * 0.5).tan() * (1.0 - MARGIN);
    let tan_x = tan_y * aspect;
    // Each corner asks for a distance at which it is just inside; the largest one suits all.
    let distance = bounds.corners().map(|corner| {
        let offset = basis.transpose() * (corner - middle);
        (offset.x.abs() / tan_x).max(offset.y.abs() / tan_y) - offset.z
    });
    let distance = distance.fold(NEAREST_EYE, f64::max).min(FURTHEST);
    let framed = Pose { eye: middle - basis.z_axis * distance, distance, ..pose };
    match parallel::height(&pose) {
        Some(_) => parallel::framed(framed, bounds, aspect, MARGIN),
        None => framed,
    }
}
