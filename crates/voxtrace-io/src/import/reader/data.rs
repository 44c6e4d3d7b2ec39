//! What readers give: data of one of four kinds, with what there is to say about them.

use super::Geometry;
use glam::{Mat3, Vec3};
use voxtrace_core::packed::PackedScene;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::volume::Volume;

/// What a file holds, z up.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Data {
    /// Voxels, which are a scene already.
    Voxels(Voxels),
    /// A packed scene, as tracers read it.
    Packed(Box<PackedScene>),
    /// A mesh or points, which are voxelized.
    Geometry(Geometry),
    /// A volume, which becomes voxels through a transfer function.
    Volume(Volume),
}

impl Data {
    /// What the reader left out or put up with.
    pub fn notes(&self) -> &[String] {
        match self {
            Self::Voxels(voxels) => &voxels.notes,
            Self::Packed(_) => &[],
            Self::Geometry(geometry) => geometry.notes(),
            Self::Volume(volume) => &volume.notes,
        }
    }
}

/// A scene from a file of voxels, and what there is to say about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Voxels {
    /// The scene.
    pub scene: Scene,
    /// What the reader left out or put up with.
    pub notes: Vec<String>,
}

impl From<Voxels> for Data {
    fn from(voxels: Voxels) -> Self {
        Self::Voxels(voxels)
    }
}

impl From<Geometry> for Data {
    fn from(geometry: Geometry) -> Self {
        Self::Geometry(geometry)
    }
}

impl From<Volume> for Data {
    fn from(volume: Volume) -> Self {
        Self::Volume(volume)
    }
}

impl Voxels {
    /// Turns the scene, which the reader has turned so that `from` of the file points up, so that `to` of the file does.
    pub(crate) fn change_up_axis(&mut self, from: UpAxis, to: UpAxis) {
        let turned = |vector: Vec3| to.to_z_up(from.inverse().to_z_up(vector));
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
