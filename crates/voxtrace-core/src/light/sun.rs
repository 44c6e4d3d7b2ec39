//! The sun as a light: uniform directions of its disc.

use super::{DistantLight, LightSample, Receiver};
use crate::math::{luminance, sincos_turns};
use glam::Vec3;
use std::f32::consts::{PI, TAU};
use voxtrace_scene::ray::Ray;
use voxtrace_scene::sky::Sky;

/// The sun as a disc on the sphere of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SunDisc {
    /// Unit vector towards its centre.
    pub direction: Vec3,
    /// Unit vector at right angles to the direction.
    pub tangent: Vec3,
    /// Unit vector at right angles to both.
    pub bitangent: Vec3,
    /// 1 − cos of the angular radius.
    pub one_minus_cos_theta_max: f32,
    /// Sine of the angular radius.
    pub sin_radius: f32,
    /// Radiance of the disc.
    pub radiance: Vec3,
    /// Luminance of the irradiance.
    pub irradiance: f32,
    /// Density of a uniform direction.
    pub pdf: f32,
    /// Whether a camera sees the disc.
    pub is_visible: bool,
}

impl SunDisc {
    /// `None` where there is no sun or it does not shine.
    pub fn new(sky: &Sky) -> Option<Self> {
        let sun = sky.sun()?;
        let direction = sun.direction.try_normalize()?;
        let irradiance = sun.irradiance * sky.brightness();
        if luminance(irradiance).partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        let (sin_half, _) = sincos_turns(sun.angular_radius.clamp(1e-4, 0.5 * PI) * (0.5 / TAU));
        let one_minus_cos_theta_max = 2.0 * sin_half * sin_half;
        let sin_squared = one_minus_cos_theta_max * (2.0 - one_minus_cos_theta_max);
        let (tangent, bitangent) = direction.any_orthonormal_pair();
        Some(Self {
            direction,
            tangent,
            bitangent,
            one_minus_cos_theta_max,
            sin_radius: sin_squared.sqrt(),
            // A disc of radiance L gives a surface that faces it the irradiance π L sin².
            radiance: irradiance * (1.0 / (PI * sin_squared)),
            irradiance: luminance(irradiance),
            pdf: 1.0 / (TAU * one_minus_cos_theta_max),
            is_visible: sky.is_sun_disc_visible(),
        })
    }

    /// Whether a unit direction points into the disc.
    #[inline]
    pub fn contains(&self, direction: Vec3) -> bool {
        // The squared chord is 2 (1 − cos), without the cancellation near cos = 1.
        (direction - self.direction).length_squared() <= 2.0 * self.one_minus_cos_theta_max
    }
}

impl DistantLight for SunDisc {
    #[inline]
    fn sample(&self, receiver: &Receiver, [_, _, u, v]: [f32; 4]) -> Option<LightSample> {
        let one_minus_cos_theta = u * self.one_minus_cos_theta_max;
        let radius = (one_minus_cos_theta * (2.0 - one_minus_cos_theta)).sqrt();
        let (sin, cos) = sincos_turns(v);
        let aside = self.tangent * (radius * cos) + self.bitangent * (radius * sin);
        let direction = self.direction * (1.0 - one_minus_cos_theta) + aside;
        let cos_theta = receiver.normal.dot(direction) + receiver.slack;
        let ray = Ray::new(receiver.point, direction);
        (cos_theta > 0.0).then_some(LightSample { ray, cos_theta, radiance: self.radiance, pdf: self.pdf })
    }

    #[inline]
    fn pdf(&self, direction: Vec3) -> f32 {
        if self.contains(direction) { self.pdf } else { 0.0 }
    }

    #[inline]
    fn le(&self, direction: Vec3) -> Vec3 {
        if self.contains(direction) { self.radiance } else { Vec3::ZERO }
    }
}
