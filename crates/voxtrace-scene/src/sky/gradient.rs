//! A sky that is a linear gradient in the direction's height, as in the study.

use glam::Vec3;

/// A vertical gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient {
    /// Radiance straight down, linear.
    pub nadir: Vec3,
    /// Radiance straight up, linear.
    pub zenith: Vec3,
}

impl Gradient {
    /// Radiance from the unit vector `direction`.
    #[inline]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let height = 0.5 * (direction.z + 1.0);
        self.nadir + (self.zenith - self.nadir) * height
    }

    /// Mean of the radiance over all directions.
    pub fn mean_radiance(&self) -> Vec3 {
        (self.nadir + self.zenith) * 0.5
    }
}
