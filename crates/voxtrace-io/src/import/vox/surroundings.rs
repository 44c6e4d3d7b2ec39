//! What a .vox file says about what is around its scene, from its rOBJ chunks: `_ground`, `_fog_uni` and `_bg`. The format text names the keys
//! alone. What voxtrace takes them to be, approximately: colours are sRGB, that of the ground a diffuse reflectance, that of the background a
//! radiance that only the camera sees; light is scattered `_d` times in a voxel of fog, as in `_media`, `_k` of it goes on, by the anisotropy `_g`.

use super::ignored::Settings;
use glam::Vec3;
use voxtrace_core::surroundings::Fog;
use voxtrace_scene::scene::Scene;

/// What a file says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    /// Colour of the ground, whether the file shows it or not.
    pub ground: Option<Vec3>,
    /// The fog, where there is any.
    pub fog: Option<Fog>,
    /// Colour of the background, whether the file shows it or not.
    pub background: Option<Vec3>,
}

/// What the .vox file that a scene came from says; nothing for other scenes.
pub fn surroundings(scene: &Scene) -> Surroundings {
    Settings::with(scene, |settings| {
        let (density, fog) = settings.fog();
        let fog = Fog {
            density: density.min(1e3) as f32,
            color: settings.color(fog, "_k").unwrap_or(Vec3::ONE),
            anisotropy: settings.number(fog, "_g").clamp(-0.95, 0.95) as f32,
        };
        Surroundings {
            ground: settings.color("_ground", "_color"),
            fog: (density > 0.0).then_some(fog),
            background: settings.color("_bg", "_color"),
        }
    })
    .unwrap_or_default()
}
