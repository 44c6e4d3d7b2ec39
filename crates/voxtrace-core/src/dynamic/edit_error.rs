//! Why a scene cannot be edited so.

use glam::IVec3;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::material::MAX_MATERIALS;

/// Most bricks that one edit may touch: some gigabytes.
pub(super) const MOST_BRICKS: u64 = 1 << 23;

/// A scene cannot be edited so. Nothing has changed then.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EditError {
    /// Instances became one grid when the scene was packed.
    #[error(
        "instances of the scene were merged when it was packed; to edit it, pack it with instances kept, or split it"
    )]
    Merged,
    /// Voxels have normals of their own, which would have to follow.
    #[error("the scene has smooth normals, which edits do not follow; edit it with the normals of faces")]
    SmoothNormals,
    /// There is no such grid.
    #[error("there is no grid {grid}: the scene has {count}")]
    NoGrid {
        /// Index of the grid.
        grid: u32,
        /// Grids there are.
        count: usize,
    },
    /// There is no such material.
    #[error("there is no material {material}: the scene has {count}")]
    NoMaterial {
        /// Index of the material.
        material: u16,
        /// Materials there are.
        count: usize,
    },
    /// There are as many materials as voxels can name.
    #[error("the scene has {MAX_MATERIALS} materials, and no more can be told apart")]
    TooManyMaterials,
    /// Voxels cannot lie so far out.
    #[error("voxel {0} is out of range: coordinates go from -{MAX_COORDINATE} to {MAX_COORDINATE}")]
    OutOfRange(IVec3),
    /// A number of the edit is not finite.
    #[error("a number of the edit is not finite")]
    NotFinite,
    /// More than can be edited at once.
    #[error("{bricks} bricks are more than the {MOST_BRICKS} that one edit may touch; edit them in parts")]
    TooLarge {
        /// Bricks that it touches.
        bricks: u64,
    },
    /// A flood got further than it was allowed.
    #[error("more than {most} voxels are connected; allow more, or bound it by a smaller box")]
    FloodTooLarge {
        /// Voxels that it was allowed.
        most: u64,
    },
    /// The voxels of a piece are not there as they were when it was found.
    #[error("the piece is not there any more as it was found; look for pieces again")]
    PieceChanged,
    /// There is no such instance.
    #[error("there is no instance {instance}: the scene has {count}")]
    NoInstance {
        /// Index of the instance.
        instance: u32,
        /// Instances there are.
        count: usize,
    },
    /// An instance does not stand on the lattice of another one.
    #[error(
        "the instance does not stand on the lattice of the other one: turn it by quarters and move it by whole voxels"
    )]
    NotOnLattice,
    /// The arrays cannot get larger.
    #[error("the scene gets too large: positions have 31 bits")]
    Full,
}
