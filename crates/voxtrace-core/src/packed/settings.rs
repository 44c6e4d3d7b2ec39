//! The parts of a packed scene that are no arrays, as records of the native file: light, units, cameras, names.

use super::{PackedScene, Section};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use voxtrace_scene::Invalid;
use voxtrace_scene::camera::{Camera, Lens};
use voxtrace_scene::scene::Unit;
use voxtrace_scene::sky::{Background, Environment, EnvironmentMap, Gradient, Sky, Sun};

/// Sections `SETT`, `CAMS`, `LENS`, `TEXT`, `ENVI` and `ENVT`.
pub(super) struct Settings {
    pub record: SettingsRecord,
    pub cameras: Vec<CameraRecord>,
    /// What the lens of each camera is set to; nothing where all are pinholes.
    pub lenses: Vec<LensRecord>,
    /// Names in UTF-8; records refer to parts of it.
    pub text: Vec<u8>,
    /// The environment map, where the sky is one.
    pub environment: Option<EnvironmentSections>,
}

/// An environment map.
pub(super) struct EnvironmentSections {
    pub record: EnvironmentRecord,
    /// Radiance of each texel.
    pub texels: Section<[f32; 3]>,
}

/// How an environment map stands.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct EnvironmentRecord {
    /// Texels along an edge.
    edge: u32,
    /// Degrees clockwise, seen from above.
    rotation: f32,
}

impl EnvironmentSections {
    fn of(environment: &Environment) -> Self {
        let map = environment.map();
        let texels: Vec<[f32; 3]> = map.texels().iter().map(|texel| texel.radiance.to_array()).collect();
        let record = EnvironmentRecord { edge: map.edge(), rotation: environment.rotation() };
        Self { record, texels: texels.into() }
    }

    /// Tags, sizes of a record, and bytes.
    pub(super) fn parts(&self) -> [([u8; 4], u32, &[u8]); 2] {
        let (record, texels) = (bytemuck::bytes_of(&self.record), bytemuck::cast_slice(&self.texels));
        [(*b"ENVI", size_of::<EnvironmentRecord>() as u32, record), (*b"ENVT", size_of::<[f32; 3]>() as u32, texels)]
    }

    pub(super) fn environment(&self) -> Result<Environment, Invalid> {
        let texels: Vec<Vec3> = self.texels.iter().copied().map(Vec3::from_array).collect();
        let map = EnvironmentMap::new(self.record.edge, &texels)?;
        Ok(Environment::new(map.into(), self.record.rotation))
    }
}

/// Everything that there is one of.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct SettingsRecord {
    voxel_size: f64,
    unit: u32,
    light_intensity: f32,
    sky_nadir: Vec3,
    sky_brightness: f32,
    sky_zenith: Vec3,
    /// [`HAS_SUN`] and [`HIDES_SUN_DISC`], as bits.
    sun: u32,
    sun_direction: Vec3,
    sun_angular_radius: f32,
    sun_irradiance: Vec3,
    name_length: u32,
}

/// There is a sun.
const HAS_SUN: u32 = 1;
/// A camera does not see its disc.
const HIDES_SUN_DISC: u32 = 2;

/// One camera; its name follows the scene's and the earlier cameras' in the text.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct CameraRecord {
    eye: Vec3,
    fov_y: f32,
    target: Vec3,
    name_length: u32,
    up: Vec3,
    /// The number of [`Lens::to_numbers`].
    lens: u32,
}

/// The settings of [`Lens::to_numbers`].
pub(super) type LensRecord = [f32; 4];

impl Settings {
    pub(super) fn of(scene: &PackedScene) -> Self {
        let sun =
            scene.sky.sun().copied().unwrap_or(Sun { direction: Vec3::Z, angular_radius: 0.0, irradiance: Vec3::ZERO });
        let (gradient, environment) = match scene.sky.background() {
            Background::Gradient(gradient) => (*gradient, None),
            // What a reader that knows no maps may show.
            Background::Environment(environment) => {
                let mean = environment.map().mean_radiance();
                (Gradient { nadir: mean, zenith: mean }, Some(EnvironmentSections::of(environment)))
            }
        };
        let with = |is_so: bool, bit: u32| if is_so { bit } else { 0 };
        let record = SettingsRecord {
            voxel_size: scene.voxel_size,
            unit: scene.unit as u32,
            light_intensity: scene.light_intensity,
            sky_nadir: gradient.nadir,
            sky_brightness: scene.sky.brightness(),
            sky_zenith: gradient.zenith,
            sun: with(scene.sky.sun().is_some(), HAS_SUN) + with(!scene.sky.is_sun_disc_visible(), HIDES_SUN_DISC),
            sun_direction: sun.direction,
            sun_angular_radius: sun.angular_radius,
            sun_irradiance: sun.irradiance,
            name_length: scene.name.len() as u32,
        };
        let mut text = scene.name.clone().into_bytes();
        let cameras = (scene.cameras.iter())
            .map(|camera| {
                text.extend_from_slice(camera.name.as_bytes());
                CameraRecord {
                    eye: camera.eye,
                    fov_y: camera.fov_y,
                    target: camera.target,
                    name_length: camera.name.len() as u32,
                    up: camera.up,
                    lens: camera.lens.to_numbers().0,
                }
            })
            .collect();
        let has_lenses = scene.cameras.iter().any(|camera| camera.lens != Lens::Pinhole);
        let lenses = scene.cameras.iter().filter(|_| has_lenses).map(|camera| camera.lens.to_numbers().1).collect();
        Self { record, cameras, lenses, text, environment }
    }

    /// Puts the settings into a scene.
    pub(super) fn apply(&self, scene: &mut PackedScene) -> Result<(), String> {
        let mut rest = &self.text[..];
        let mut name = |length: u32| {
            let (name, after) = rest.split_at_checked(length as usize).ok_or("a name goes beyond the text")?;
            rest = after;
            String::from_utf8(name.to_vec()).map_err(|_| "a name is not UTF-8")
        };
        let record = &self.record;
        scene.name = name(record.name_length)?;
        scene.voxel_size = record.voxel_size;
        scene.unit = match record.unit {
            0 => Unit::Voxel,
            1 => Unit::Metre,
            2 => Unit::Millimetre,
            other => return Err(format!("unit {other} is unknown")),
        };
        scene.light_intensity = record.light_intensity;
        let sun = Sun {
            direction: record.sun_direction,
            angular_radius: record.sun_angular_radius,
            irradiance: record.sun_irradiance,
        };
        let background = match &self.environment {
            Some(sections) => Background::Environment(sections.environment()?),
            None => Background::Gradient(Gradient { nadir: record.sky_nadir, zenith: record.sky_zenith }),
        };
        scene.sky = Sky::new(background)
            .with_brightness(record.sky_brightness)
            .with_sun((record.sun & HAS_SUN != 0).then_some(sun))
            .with_sun_disc_visible(record.sun & HIDES_SUN_DISC == 0);
        for (index, camera) in self.cameras.iter().enumerate() {
            let name = name(camera.name_length)?;
            let (eye, target, up, fov_y) = (camera.eye, camera.target, camera.up, camera.fov_y);
            let numbers = self.lenses.get(index).copied().unwrap_or_default();
            let lens = Lens::from_numbers(camera.lens, numbers);
            let lens = lens.ok_or_else(|| format!("camera {index} has no sound lens"))?;
            scene.cameras.push(Camera { name, eye, target, up, fov_y, lens });
        }
        Ok(())
    }
}
