//! What can be done to the voxels of a grid, as values: commands that an editor keeps, sends or repeats.

use super::Clip;
use glam::IVec3;
use std::sync::Arc;
use voxtrace_scene::brick::Brick;
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::{Face, Shape};

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
    /// The empty voxels of a shape become this material; those that are there stay.
    Add {
        /// Which voxels.
        shape: Shape,
        /// What they become.
        material: u16,
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
    /// What was copied is put somewhere: turn or mirror the clip first where it should be.
    Paste {
        /// What was copied.
        clip: Arc<Clip>,
        /// Where the lowest corner of its box comes to lie.
        at: IVec3,
        /// Whether its empty voxels count too.
        with_empty: bool,
    },
    /// The voxels of a layer that are there are drawn out along a face, or pushed in. In a layer of several voxels all count as they were before, and
    /// none of them is replaced by another one that is drawn out.
    Extrude {
        /// The layer, one voxel thick as a rule.
        layer: VoxelBox,
        /// The face whose outward normal is followed.
        face: Face,
        /// How many voxels are added above each; where it is negative, how many are taken away from it inward.
        distance: i32,
    },
    /// The voxels that are connected to one across faces, and are of its material, or empty as it is, become another material.
    Flood {
        /// Where it begins.
        start: IVec3,
        /// What they become.
        material: Option<u16>,
        /// How far it may get.
        within: VoxelBox,
        /// Most voxels; more are an error.
        most: u64,
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
    /// Materials that it names, of many the last one.
    pub(super) fn materials(&self) -> impl Iterator<Item = u16> {
        let (first, second) = match self {
            Self::Fill { material, .. } => (*material, None),
            Self::Add { material, .. } | Self::Paint { material, .. } => (Some(*material), None),
            Self::Replace { from, to, .. } => (Some(*from), *to),
            Self::Flood { material, .. } => (*material, None),
            Self::Paste { clip, .. } => {
                let of_brick = |(_, brick): (IVec3, &Brick)| brick.materials().iter().copied().max();
                (clip.voxels.sorted_bricks().into_iter().filter_map(of_brick).max(), None)
            }
            Self::Extrude { .. } => (None, None),
        };
        first.into_iter().chain(second)
    }

    /// The box in which an edit that goes voxel by voxel may write, `None` for the others.
    pub(super) fn reach(&self) -> Option<VoxelBox> {
        match self {
            Self::Paste { clip, at, .. } => Some(VoxelBox { min: *at, max: at.saturating_add(clip.size) }),
            Self::Extrude { layer, face, distance } => {
                let distance = if *distance > 0 { *distance } else { distance.saturating_add(1).min(0) };
                let along = face.normal() * distance;
                let (min, max) = (layer.min.saturating_add(along), layer.max.saturating_add(along));
                Some(VoxelBox { min: layer.min.min(min), max: layer.max.max(max) })
            }
            Self::Flood { within, .. } => Some(*within),
            _ => None,
        }
    }
}
