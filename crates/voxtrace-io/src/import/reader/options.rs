//! How files are read.

use super::{PointFilter, RawShape};
use glam::DVec3;
use std::path::PathBuf;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::volume::VolumeOptions;
use voxtrace_voxelize::voxelize::VoxelizeOptions;

/// How files are read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportOptions {
    /// What a file may at most ask for.
    pub limits: Limits,
    /// The axis that points up in the file; `None` takes that of its format ([`super::Reader::up_axis`]).
    pub up: Option<UpAxis>,
    /// The unit of the file's coordinates; `None` takes what its format says.
    pub unit: Option<LengthUnit>,
    /// How meshes and points become voxels.
    pub voxelize: VoxelizeOptions,
    /// Which points are read.
    pub points: PointFilter,
    /// How heightmaps become voxels.
    pub heights: HeightOptions,
    /// How volumes become voxels.
    pub volume: VolumeOptions,
    /// Number of the DICOM series that is read where a folder holds several; `None` takes the one with the most pictures.
    pub series: Option<i64>,
    /// Number of the channel of a volume that is shown, from 1 on; `None` shows all in their colours.
    pub channel: Option<u32>,
    /// Number of the time point of a volume that is read, from 1 on; `None` takes the first.
    pub time: Option<u32>,
    /// Distance between a volume's samples along its three axes in place of what the file says, in `unit`s, or where
    /// neither says which, in millimetres.
    pub spacing: Option<DVec3>,
    /// What a file without a header holds.
    pub raw: Option<RawShape>,
    /// Whether voxtrace's own files are read into memory instead of mapped, so that other programs may change them meanwhile.
    pub in_memory: bool,
}

/// How a heightmap becomes voxels.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightOptions {
    /// How high it becomes.
    pub height: Height,
    /// A picture laid over it, PNG or JPEG, of any size.
    pub color_image: Option<PathBuf>,
    /// Keep only voxels that have an empty neighbour of six.
    pub shell: bool,
}

/// How many voxels a height is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Height {
    /// True to scale where the file says how far its points are apart, else a quarter of the longer side.
    #[default]
    Automatic,
    /// So many voxels from the lowest to the highest point, at least 1.
    Voxels(u32),
    /// So many voxels for each unit of the values, above 0.
    Scale(f64),
}

impl Default for HeightOptions {
    fn default() -> Self {
        Self { height: Height::Automatic, color_image: None, shell: true }
    }
}
