//! The built-in scenes: generated, deterministic, at any resolution, modelled as the shells that photogrammetry scans
//! leave. `generate("church", None)` gives the church at the study's voxel count.
//!
//! # How to model a scene
//! A scene is a function from the voxel size (metres) to a [`kit::Model`]: a painted solid, its palette, the box to
//! build, cameras and light, all in metres, z up. Only the surface of the solid becomes voxels, one to two thick.
//! ```
//! use voxtrace_scenes::kit::{patterns::*, *};
//! use voxtrace_scene::{Camera, Sky, glam::{Vec3, vec3}};
//!
//! fn cell(voxel: f32) -> Model {
//!     // Colours: ramps of up to 16 neighbouring shades, dark to light, at most 255 materials in all.
//!     let mut palette = Palette::default();
//!     let stone = palette.ramp(&[[120, 110, 95], [190, 180, 160]], 16);
//!     let oak = palette.ramp(&[[60, 38, 22], [120, 84, 52]], 16);
//!     let flame = palette.glow(&[[255, 200, 130]], 1, 30.0);
//!     // Paints: stock patterns, or any function of the place on the surface.
//!     let walls = ashlar(stone, 0.5, 0.6, 0.3);
//!     let planks = wood(oak, 0.5, Vec3::X);
//!     let bands = Paint::new(move |p| stone.tone(if p.at.z > 1.0 { 0.7 } else { 0.3 }));
//!     let light = Paint::plain(flame.even(0.0, 0.0));
//!     // A room is what lies around its cavity: walls have no outside. Cavities join by union.
//!     let cavity = cuboid(vec3(0.0, 0.0, 0.0), vec3(4.0, 6.0, 2.5))
//!         .and(extrude(Profile::arch(1.2, 1.0, 1.0), Axis::Y, -0.4, 0.1).at(vec3(2.0, 0.0, 0.8)));
//!     let table = block(1.2, 0.7, 0.05).z(0.7).and(row(2, vec3(1.0, 0.0, 0.0), &block(0.1, 0.5, 0.7)).x(-0.5));
//!     let column = revolve(&[(0.3, 0.0), (0.2, 0.2), (0.2, 2.3), (0.35, 2.5)]).paint(&bands);
//!     // Things thinner than two voxels get holes or vanish: give them that at least.
//!     let candle = cylinder(0.03_f32.max(1.05 * voxel), 0.2).paint(&light);
//!     let solid = union([
//!         around(cavity).paint(&walls),
//!         table.paint(&planks).at(vec3(2.0, 3.0, 0.0)),
//!         column.at(vec3(0.8, 1.0, 0.0)),
//!         candle.at(vec3(2.0, 3.0, 0.75)),
//!     ]);
//!     Model {
//!         solid,
//!         paint: walls,
//!         palette,
//!         min: vec3(-0.2, -0.6, -0.2),
//!         max: vec3(4.2, 6.2, 2.7),
//!         cameras: vec![Camera::look_at(vec3(3.0, 0.5, 1.6), vec3(2.0, 4.0, 1.0))],
//!         sky: Sky::black(),
//!         light_intensity: 1.0,
//!     }
//! }
//! let scene = cell(0.05).into_scene("cell", 0.05);
//! assert!(scene.grids[0].count() > 40_000);
//! ```
//! Rules that keep scenes honest and quick:
//! - Distances must never change faster than the point moves; all of [`kit::Shape`] and [`kit::Profile`] keep to it.
//! - Voxel decisions use + − × ÷ √ and [`kit::noise`] alone; angles go through `sin_cos_degrees`.
//! - A paint's pattern lies in the coordinates where `.paint()` was called and moves with the solid after that;
//!   `p.seed` and `p.chance()` differ from copy to copy. The innermost paint wins.
//! - A brick shows at least 12 materials in the mean and a ramp has at most 16 shades, so avoid tiny grains, and
//!   avoid more than two ramps in a place.
//! - To add a scene: a file here, a line in the table of built-in scenes with its voxel size (print
//!   `Model::count` and adjust it until the count is right), a name in [`NAMES`].

#![forbid(unsafe_code)]

// One thread has no work to divide.
#[cfg(target_arch = "wasm32")]
extern crate voxtrace_serial as rayon;

mod church;
mod city;
mod forest;
pub mod kit;
mod operating_room;
/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
mod tests;

use kit::Model;
use voxtrace_scene::scene::Scene;

/// Names of the built-in scenes.
pub const NAMES: [&str; 4] = ["city", "operating-room", "church", "forest"];
/// Names of those that stand for the study's: one grid each.
pub const STUDY_NAMES: [&str; 3] = ["city", "operating-room", "church"];
/// Name of the scene that is asked for by a number of instances; the others are by a number of voxels.
pub const FOREST: &str = "forest";
/// Instances of `forest` where no number is asked for, beside its hillside.
pub const FOREST_INSTANCES: u32 = 10_000;
/// Edge of its voxels, metres.
const FOREST_VOXEL: f32 = 0.2;

/// Fewest voxels that a built-in scene can be asked for.
pub const MIN_VOXELS: u64 = 1_000;
/// Most voxels that a built-in scene can be asked for.
pub const MAX_VOXELS: u64 = 4_000_000_000;
/// Most instances that `forest` can be asked for.
pub const MAX_INSTANCES: u32 = 1_000_000;

/// Why a scene cannot be generated.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// There is no such scene.
    #[error("there is no built-in scene `{0}`; there are {names}", names = NAMES.join(", "))]
    UnknownName(String),
    /// The wanted number of voxels is out of range.
    #[error("cannot build a scene of {0} voxels: from {MIN_VOXELS} to {MAX_VOXELS} are possible")]
    VoxelCount(u64),
    /// The wanted number of instances is out of range.
    #[error("cannot build a scene of {0} instances: from 1 to {MAX_INSTANCES} are possible")]
    InstanceCount(u32),
    /// The scene does not consist of instances.
    #[error("`{0}` is not made of a number of instances; `forest` is")]
    NotOfInstances(String),
    /// The scene's number of voxels follows from its instances.
    #[error("`forest` has no number of voxels to ask for: it has a number of instances")]
    NotOfVoxels,
    /// Nobody waits for it any more: see [`generate_while`].
    #[error("the scene is not wanted any more")]
    Stopped,
}

/// A built-in scene: the study's voxel count, and the voxel size in metres that gives it.
struct Builtin {
    name: &'static str,
    voxels: u64,
    voxel: f32,
    model: fn(f32) -> Model,
}

const BUILTINS: [Builtin; 3] = [
    Builtin { name: "city", voxels: 4_300_000, voxel: 0.298_15, model: city::model },
    Builtin { name: "operating-room", voxels: 5_200_000, voxel: 0.013_965_741, model: operating_room::model },
    Builtin { name: "church", voxels: 13_600_000, voxel: 0.0217238, model: church::model },
];

/// Generates `forest` with a number of instances of its models, beside the hillside that they stand on, as long as it is `wanted`.
///
/// # Errors
/// [`SceneError`] if the number is out of range; [`SceneError::Stopped`] soon after it is not wanted any more.
pub fn generate_forest_while(instances: u32, wanted: &(dyn Fn() -> bool + Sync)) -> Result<Scene, SceneError> {
    if !(1..=MAX_INSTANCES).contains(&instances) {
        return Err(SceneError::InstanceCount(instances));
    }
    let scene = forest::Forest { voxel: FOREST_VOXEL, instances }.into_scene_while(FOREST, wanted);
    if wanted() { Ok(scene) } else { Err(SceneError::Stopped) }
}

/// Generates a built-in scene with the study's number of voxels, or with about `voxels`: within 0.5 % where it has a
/// million or more, as near as the shapes allow below.
///
/// # Errors
/// [`SceneError`] if there is no scene of that name or the number is out of range.
pub fn generate(name: &str, voxels: Option<u64>) -> Result<Scene, SceneError> {
    generate_while(name, voxels, &|| true)
}

/// As [`generate`], as long as it is `wanted`, which is asked again and again, on several threads, and which says no for good.
///
/// # Errors
/// As [`generate`]; [`SceneError::Stopped`] soon after it is not wanted any more.
pub fn generate_while(
    name: &str,
    voxels: Option<u64>,
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<Scene, SceneError> {
    if name == FOREST {
        return match voxels {
            Some(_) => Err(SceneError::NotOfVoxels),
            None => generate_forest_while(FOREST_INSTANCES, wanted),
        };
    }
    let builtin =
        BUILTINS.iter().find(|builtin| builtin.name == name).ok_or_else(|| SceneError::UnknownName(name.to_owned()))?;
    let voxel = match voxels {
        Some(count) if !(MIN_VOXELS..=MAX_VOXELS).contains(&count) => return Err(SceneError::VoxelCount(count)),
        Some(count) if count != builtin.voxels => voxel_size_for(builtin, count, wanted),
        _ => builtin.voxel,
    };
    let scene = (builtin.model)(voxel).into_scene_while(name, voxel, wanted);
    if wanted() { Ok(scene) } else { Err(SceneError::Stopped) }
}

/// The number of voxels that [`generate`] makes of a scene by default; `None` if there is no such scene.
pub fn default_voxels(name: &str) -> Option<u64> {
    BUILTINS.iter().find(|builtin| builtin.name == name).map(|builtin| builtin.voxels)
}

/// The voxel size for a number of voxels. Shells grow with the inverse square of the size; what deviates from that
/// (thin parts, edges, how large planes lie in the lattice) is corrected by counting, on a sample of the bricks where
/// there are many. Counts are not monotonic in the size, so once one size gave too many voxels and another too few, the
/// guesses stay between them.
fn voxel_size_for(builtin: &Builtin, voxels: u64, wanted: &(dyn Fn() -> bool + Sync)) -> f32 {
    const SAMPLE: u64 = 4_000_000;
    const PASSES: u32 = 12;
    let stride = (voxels / SAMPLE).max(1) as u32;
    let mut voxel = builtin.voxel * (builtin.voxels as f32 / voxels as f32).sqrt();
    let (mut best, mut least_error) = (voxel, f32::INFINITY);
    let (mut too_many, mut too_few) = (None, None);
    for _ in 0..PASSES {
        if !wanted() {
            break;
        }
        let count = (builtin.model)(voxel).count(voxel, stride).max(1);
        let ratio = count as f32 / voxels as f32;
        let error = (ratio - 1.0).abs();
        if error < least_error {
            (best, least_error) = (voxel, error);
        }
        if error < 0.001 {
            break;
        }
        *(if ratio > 1.0 { &mut too_many } else { &mut too_few }) = Some((voxel, ratio));
        voxel = match (too_many, too_few) {
            (Some((a, many)), Some((b, few))) => a + (b - a) * ((many - 1.0) / (many - few)).clamp(0.1, 0.9),
            _ => voxel * ratio.sqrt(),
        };
    }
    best
}
