//! The sky: a vertical gradient, and a sun where the scene has one.

use glam::Vec3;

/// Light that comes from outside the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Radiance straight down, linear; between, the sky is a linear gradient in the direction's height.
    pub nadir: Vec3,
    /// Radiance straight up, linear.
    pub zenith: Vec3,
    /// Factor on the whole sky, the sun included.
    pub brightness: f32,
    /// The sun, if there is one.
    pub sun: Option<Sun>,
}

/// A disc of constant radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Unit vector towards the sun's centre.
    pub direction: Vec3,
    /// Half the angle that the disc spans, radians.
    pub angular_radius: f32,
    /// Irradiance on a surface that faces the sun, linear, before the sky's brightness.
    pub irradiance: Vec3,
}

impl Sky {
    /// The sky of the study that voxtrace reproduces: white at the nadir, (0.5, 0.7, 1.0) at the zenith.
    pub fn study(brightness: f32) -> Self {
        Self { nadir: Vec3::ONE, zenith: Vec3::new(0.5, 0.7, 1.0), brightness, sun: None }
    }

    /// No light at all.
    pub fn black() -> Self {
        Self::study(0.0)
    }

    /// Radiance of the gradient, without the sun, from the unit vector `direction`.
    pub fn gradient(&self, direction: Vec3) -> Vec3 {
        let height = 0.5 * (direction.z + 1.0);
        (self.nadir + (self.zenith - self.nadir) * height) * self.brightness
    }
}

impl Default for Sky {
    fn default() -> Self {
        Self::study(1.0)
    }
}
