//! What can be done to the voxels of a grid, as values: commands that an editor keeps, sends or repeats.

use voxtrace_scene::Shape;
use voxtrace_scene::grid::VoxelBox;

/// An edit of one grid. Materials are indices into the scene's; `None` is emptiness.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Edit {
    /// All voxels of a shape become this material, or empty.
    Fill {
        /// Which voxels.
        shape: Shape,
        /// What they become.
        material: Option<u16>,
    },
    /// The voxels of a shape that are there become another material.
    Paint {
        /// Which voxels.
        shape: Shape,
        /// What they become.
        material: u16,
    },
    /// The voxels of one material become another, or empty.
    Replace {
        /// Where, `None` for everywhere.
        within: Option<VoxelBox>,
        /// What they are.
        from: u16,
        /// What they become.
        to: Option<u16>,
    },
}

/// What an edit did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Edited {
    /// Bricks that are others now.
    pub bricks: usize,
    /// Voxels that there are more, or fewer.
    pub voxels: i64,
}

impl Edit {
    /// Materials that it names.
    pub(super) fn materials(&self) -> impl Iterator<Item = u16> {
        let (first, second) = match self {
            Self::Fill { material, .. } => (*material, None),
            Self::Paint { material, .. } => (Some(*material), None),
            Self::Replace { from, to, .. } => (Some(*from), *to),
        };
        first.into_iter().chain(second)
    }
}
