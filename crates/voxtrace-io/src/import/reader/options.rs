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
    /// How blocks of Minecraft become voxels.
    pub blocks: BlockOptions,
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
    /// Which of the animations of a mesh moves it; by default it stands as at rest, in one grid.
    pub animation: ClipChoice,
    /// How many shapes a second are made of what bends in that animation: each is voxelized, and seen until the next one. `None`: 24; 0: the shape
    /// at rest alone. Where there is no room for so many, there are fewer, and a note of the mesh says so.
    pub shape_rate: Option<f64>,
    /// Whether voxtrace's own files are read into memory instead of mapped, so that other programs may change them meanwhile.
    pub in_memory: bool,
    /// Whether a file of which a part is damaged is refused. Else what is whole of it is read, and a note says what is left out.
    pub strict: bool,
}

/// Which animation of a mesh is read ([`voxtrace_scene::scene::Scene::clips`]).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum ClipChoice {
    /// None: their names and lengths alone.
    #[default]
    None,
    /// As [`Self::None`], by somebody who can read it again to play it: of what plays nothing is told as not shown, but for further animations.
    Later,
    /// The first, where there is one.
    First,
    /// The one of this name, or with this number from 1 on, where there is one.
    Named(String),
}

/// How blocks of Minecraft become voxels.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockOptions {
    /// Voxels along an edge of a block.
    pub size: BlockSize,
    /// A resource pack of the game's Java edition, a folder or a ZIP file, whose pictures colour the blocks.
    pub resource_pack: Option<PathBuf>,
    /// Keep only voxels that have an empty or clear neighbour of six, where blocks are more than one voxel.
    pub shell: bool,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self { size: BlockSize::default(), resource_pack: None, shell: true }
    }
}

/// Voxels along an edge of a block: one, or so many that blocks have their shapes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum BlockSize {
    /// Each block is one voxel, whatever its shape.
    #[default]
    One,
    /// Half a block is the smallest that is told apart.
    Two,
    /// A quarter of a block.
    Four,
    /// An eighth of a block.
    Eight,
    /// What the game's own models and pictures are made of.
    Sixteen,
}

impl BlockSize {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::One, Self::Two, Self::Four, Self::Eight, Self::Sixteen];

    /// Voxels along an edge.
    pub fn edge(self) -> usize {
        1 << self as usize
    }
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
