//! How a mesh or a cloud of points is voxelized.

use super::PointOptions;
use voxtrace_scene::material::MAX_MATERIALS;

/// How a mesh, or a cloud of points, becomes voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelizeOptions {
    /// Size of the voxels.
    pub scale: Scale,
    /// Which voxels a surface occupies.
    pub rule: SurfaceRule,
    /// Solid voxelization: also occupy the voxels inside closed surfaces.
    pub fill: bool,
    /// Most materials, 1 to [`MAX_MATERIALS`]; more colours than that are quantized.
    pub max_materials: usize,
    /// Dither between two materials where none fits, if there are at most 1,024.
    pub dither: bool,
    /// Memory to aim at in bytes, the mesh included; `None` is no limit.
    pub memory_budget: Option<u64>,
    /// Options for clouds of points alone.
    pub points: PointOptions,
}

impl Default for VoxelizeOptions {
    fn default() -> Self {
        Self {
            scale: Scale::Automatic,
            rule: SurfaceRule::Conservative,
            fill: false,
            max_materials: MAX_MATERIALS,
            dither: false,
            memory_budget: None,
            points: PointOptions::default(),
        }
    }
}

/// Size of the voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Chosen by the model: for points the finest that keeps surfaces closed
    /// ([`crate::points::PointCloud::suited_resolution`]), for a mesh 512 voxels along the longest side, for a volume one for
    /// each sample.
    Automatic,
    /// Number of voxels along the longest side of the model.
    Resolution(u32),
    /// Edge of a voxel, in the model's units.
    VoxelSize(f64),
}

/// Which voxels a surface occupies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceRule {
    /// Conservative, 26-separating: every voxel that the surface crosses. No path passes it, not even along diagonals.
    Conservative,
    /// Thin, 6-separating: no path through faces passes it. A little more than half as many voxels.
    Thin,
}
