//! Files that hold voxels and their colours, but no scene: Minecraft's builds and worlds, Qubicle, Slab6, binvox, heightmaps. Their readers end in a scene.

mod binvox;
mod dense;
mod heightmap;
mod minecraft;
mod paints;
mod qubicle;
mod slab;
pub(super) mod slab6;

use super::folder::Folder;
use super::input::Input;
use super::{Format, ImportError, ImportErrorKind, ImportOptions, Limits};
use glam::{IVec3, Mat3, Vec3};
use std::path::Path;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::mesh::UpAxis;

pub use heightmap::{Height, HeightOptions};

pub(super) use binvox::MAGIC as BINVOX_MAGIC;
pub(super) use minecraft::{holds_regions, read_world};
pub(super) use qubicle::is_model as is_qubicle;

/// A scene from a file of voxels, and what there is to say about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Voxels {
    /// The scene.
    pub scene: Scene,
    /// What the reader left out or put up with.
    pub notes: Vec<String>,
}

/// Reads a file of a known format.
pub(super) fn read(
    format: Format,
    input: Input,
    folder: &Folder,
    options: &ImportOptions,
) -> Result<Voxels, ImportError> {
    let limits = &options.limits;
    match format {
        Format::Schematic => minecraft::read_build(input, limits),
        Format::Qubicle => qubicle::read(input, limits),
        Format::Vox => slab6::read(input, limits),
        Format::Binvox => binvox::read(input, limits),
        Format::Heightmap => heightmap::read(input, &options.heights, limits),
        Format::Region => minecraft::read_region(input, folder, limits),
        _ => {
            let kind = ImportErrorKind::Unsupported("the file holds no voxels of this kind".into());
            Err(ImportError::at(input.path(), 0, kind))
        }
    }
}

impl Voxels {
    /// Turns the scene, which readers have turned from y up to z up, so that `up` of the file points up.
    pub(super) fn turn_up(&mut self, up: UpAxis) {
        let turned = |vector: Vec3| up.turned(UpAxis::MinusY.turned(vector));
        let turn = Transform {
            linear: Mat3::from_cols(turned(Vec3::X), turned(Vec3::Y), turned(Vec3::Z)),
            translation: Vec3::ZERO,
        };
        for instance in &mut self.scene.instances {
            instance.world_from_grid = turn.after(&instance.world_from_grid);
        }
        if let Some(georeference) = &mut self.scene.georeference {
            // The inverse of a turn is its transpose.
            georeference.coordinates_from_world.matrix3 *= turn.linear.transpose().as_dmat3();
        }
    }
}

/// The size of a box of voxels, checked: within what grids hold, and with no more places than there may be voxels.
fn checked_size(path: &Path, offset: u64, size: [u64; 3], limits: &Limits) -> Result<IVec3, ImportError> {
    let edge = size.into_iter().max().unwrap_or(0);
    if edge > MAX_COORDINATE as u64 {
        return Err(ImportError::limit(path, Some(offset), "voxels along an edge", edge, MAX_COORDINATE as u64));
    }
    let places = size.into_iter().fold(1u64, u64::saturating_mul);
    if places > limits.voxels {
        return Err(ImportError::limit(path, Some(offset), "places of voxels", places, limits.voxels));
    }
    Ok(IVec3::from_array(size.map(|edge| edge as i32)))
}
