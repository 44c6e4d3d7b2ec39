//! Another sun, and the sky of air that it lights: the values of `--sun` and `--sky physical`.

use glam::Vec3;
use voxtrace_scene::Sun;
use voxtrace_scene::sky::{Atmosphere, Sky};

/// From where and how strongly a sun shines. Kept as the numbers of the option, since the direction is computed from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SunSetting {
    /// Degrees clockwise from +y.
    pub bearing: f32,
    /// Degrees above the horizon, -90 to 90.
    pub height: f32,
    /// Irradiance; 0 is no sun.
    pub strength: f32,
}

impl SunSetting {
    /// That of a physical sky in a scene without a sun.
    pub const OF_PHYSICAL_SKY: Self = Self { bearing: 135.0, height: 45.0, strength: 3.0 };

    /// The setting of a sky's sun, as near as its numbers tell.
    pub fn of(sky: &Sky) -> Option<Self> {
        let (bearing, height, strength) = sky.sun()?.setting();
        Some(Self { bearing, height, strength })
    }

    /// The sun; `None` where its strength is not above 0.
    pub fn sun(self) -> Option<Sun> {
        Sun::at(self.bearing, self.height, self.strength)
    }

    /// The Earth's sky in the light of this sun, which above the air is white, of brightness one. Takes its time: about that of 100,000 paths.
    /// `None` where no sun shines.
    pub fn physical_sky(self) -> Option<Sky> {
        let sun = Sun { irradiance: Vec3::splat(self.strength), ..self.sun()? };
        Some(Atmosphere::EARTH.sky(&sun))
    }
}
