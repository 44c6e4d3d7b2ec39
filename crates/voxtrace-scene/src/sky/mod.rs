//! Light from outside the scene: what every direction sends, and a sun where the scene has one. A model of the sky, as a gradient or a
//! panorama, is a variant of [`Background`] and a file of this folder; nobody else looks inside.

mod alias_table;
mod atmosphere;
mod environment;
/// For tests of other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub mod equal_area;
mod from_above;
mod gradient;
mod panorama;
mod transmittance;

pub use atmosphere::Atmosphere;
/// For the tracers in other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub use environment::{ChosenDirection, EnvironmentTexel};
pub use environment::{Environment, EnvironmentMap};
#[doc(hidden)]
pub use from_above::FromAbove;
use glam::Vec3;
pub use gradient::Gradient;

/// Light that comes from outside the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    background: Background,
    brightness: f32,
    sun: Option<Sun>,
    hides_sun_disc: bool,
}

/// What a sky shows behind its sun, before the sky's brightness.
#[derive(Clone, Debug, PartialEq)]
pub enum Background {
    /// From one colour straight down to another straight up.
    Gradient(Gradient),
    /// A picture of all directions.
    Environment(Environment),
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

/// Irradiance of a sun of strength 1, linear.
const SUN_COLOR: Vec3 = Vec3::new(1.0, 0.93, 0.83);
/// Half the angle that the disc of [`Sun::at`] spans, radians.
const SUN_RADIUS: f32 = 0.01;

impl Sun {
    /// A warm white sun at a `bearing` (clockwise from +y) and a `height` above the horizon, degrees, of irradiance `strength`;
    /// `None` where that is not above 0.
    pub fn at(bearing: f32, height: f32, strength: f32) -> Option<Self> {
        let ((height_sin, height_cos), (bearing_sin, bearing_cos)) =
            (height.to_radians().sin_cos(), bearing.to_radians().sin_cos());
        let direction = Vec3::new(height_cos * bearing_sin, height_cos * bearing_cos, height_sin).normalize();
        let irradiance = SUN_COLOR * strength;
        (strength > 0.0).then_some(Self { direction, angular_radius: SUN_RADIUS, irradiance })
    }

    /// Where it stands and how strong it is, as [`Self::at`] takes it.
    pub fn setting(&self) -> (f32, f32, f32) {
        let bearing = self.direction.x.atan2(self.direction.y).to_degrees().rem_euclid(360.0);
        (bearing, self.direction.z.clamp(-1.0, 1.0).asin().to_degrees(), self.irradiance.x / SUN_COLOR.x)
    }
}

impl Background {
    /// The same radiance from everywhere, linear.
    pub fn uniform(radiance: Vec3) -> Self {
        Self::Gradient(Gradient { nadir: radiance, zenith: radiance })
    }

    /// The picture of all directions, where it is one.
    pub fn environment(&self) -> Option<&Environment> {
        match self {
            Self::Gradient(_) => None,
            Self::Environment(environment) => Some(environment),
        }
    }

    /// Radiance from the unit vector `direction`.
    #[inline]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        match self {
            Self::Gradient(gradient) => gradient.radiance(direction),
            Self::Environment(environment) => environment.radiance(direction),
        }
    }

    /// Mean of the radiance over all directions.
    pub fn mean_radiance(&self) -> Vec3 {
        match self {
            Self::Gradient(gradient) => gradient.mean_radiance(),
            Self::Environment(environment) => environment.map().mean_radiance(),
        }
    }
}

impl Sky {
    /// A sky of brightness one without a sun.
    pub fn new(background: Background) -> Self {
        Self { background, brightness: 1.0, sun: None, hides_sun_disc: false }
    }

    /// A linear gradient in the direction's height, from the radiance straight down to that straight up.
    pub fn gradient(nadir: Vec3, zenith: Vec3) -> Self {
        Self::new(Background::Gradient(Gradient { nadir, zenith }))
    }

    /// The same radiance from everywhere, linear.
    pub fn uniform(radiance: Vec3) -> Self {
        Self::new(Background::uniform(radiance))
    }

    /// The sky of the study that voxtrace reproduces: white at the nadir, (0.5, 0.7, 1.0) at the zenith.
    pub fn study(brightness: f32) -> Self {
        Self::gradient(Vec3::ONE, Vec3::new(0.5, 0.7, 1.0)).with_brightness(brightness)
    }

    /// No light at all.
    pub fn black() -> Self {
        Self::study(0.0)
    }

    /// The same sky with this sun, or without one.
    pub fn with_sun(self, sun: impl Into<Option<Sun>>) -> Self {
        Self { sun: sun.into(), ..self }
    }

    /// The same sky at another brightness.
    pub fn with_brightness(self, brightness: f32) -> Self {
        Self { brightness, ..self }
    }

    /// Sets the sun, or takes it away.
    pub fn set_sun(&mut self, sun: impl Into<Option<Sun>>) {
        self.sun = sun.into();
    }

    /// Sets the factor on the whole sky, the sun included.
    pub fn set_brightness(&mut self, brightness: f32) {
        self.brightness = brightness;
    }

    /// Sets what is behind the sun.
    pub fn set_background(&mut self, background: Background) {
        self.background = background;
    }

    /// The same sky, of whose sun a camera sees the disc, as it does unless this says otherwise, or not. As [`Self::set_sun_disc_visible`].
    pub fn with_sun_disc_visible(self, is_visible: bool) -> Self {
        Self { hides_sun_disc: !is_visible, ..self }
    }

    /// Sets whether a camera sees the disc of the sun: whether rays that nothing reflected, refracted or scattered since they left it end there. Mirrors and
    /// glass show the disc either way, and its light is the same. Another sun does not change this.
    pub fn set_sun_disc_visible(&mut self, is_visible: bool) {
        self.hides_sun_disc = !is_visible;
    }

    /// Whether a camera sees the disc of the sun, if there is one.
    pub fn is_sun_disc_visible(&self) -> bool {
        !self.hides_sun_disc
    }

    /// The sun, if there is one, before the sky's brightness.
    pub fn sun(&self) -> Option<&Sun> {
        self.sun.as_ref()
    }

    /// Factor on the whole sky, the sun included.
    pub fn brightness(&self) -> f32 {
        self.brightness
    }

    /// What is behind the sun, before the sky's brightness.
    pub fn background(&self) -> &Background {
        &self.background
    }

    /// Radiance, without the sun, from the unit vector `direction`.
    #[inline]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        self.background.radiance(direction) * self.brightness
    }

    /// Mean of the radiance, without the sun, over all directions.
    pub fn mean_radiance(&self) -> Vec3 {
        self.background.mean_radiance() * self.brightness
    }
}

impl Default for Sky {
    fn default() -> Self {
        Self::study(1.0)
    }
}
