//! What a probe has built: boxes in geometries, geometries in structures, structures in instances.

use super::boxes::Aabb;
use ash::vk;

pub use vk::BuildAccelerationStructureFlagsKHR as BuildFlags;

/// The identity as rows.
pub const IDENTITY: [f32; 12] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];

/// How a structure gets to its final state.
#[derive(Clone, Debug, Default)]
pub enum Treatment {
    /// Built.
    #[default]
    Built,
    /// Built, then compacted.
    Compacted,
    /// Built from other boxes, as many, then updated.
    UpdatedFrom(Vec<Vec<Aabb>>),
}

/// A structure of boxes, geometry by geometry.
#[derive(Clone, Debug, Default)]
pub struct Bottom {
    pub geometries: Vec<Vec<Aabb>>,
    pub flags: BuildFlags,
    pub treatment: Treatment,
}

impl Bottom {
    /// One geometry, built as scenes are.
    pub fn of(boxes: Vec<Aabb>) -> Self {
        Self { geometries: vec![boxes], flags: BuildFlags::PREFER_FAST_TRACE, treatment: Treatment::Built }
    }
}

/// An instance of a structure.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    pub bottom: usize,
    /// Three rows of four: world from object.
    pub transform: [f32; 12],
    pub mask: u8,
}

/// What to build.
#[derive(Clone, Debug, Default)]
pub struct Model {
    pub bottoms: Vec<Bottom>,
    pub instances: Vec<Placed>,
}

impl Model {
    /// Each structure once, where it is.
    pub fn of(bottoms: Vec<Bottom>) -> Self {
        let place = |bottom| Placed { bottom, transform: IDENTITY, mask: 0xff };
        Self { instances: (0..bottoms.len()).map(place).collect(), bottoms }
    }

    /// One structure of one geometry.
    pub fn single(boxes: Vec<Aabb>) -> Self {
        Self::of(vec![Bottom::of(boxes)])
    }
}
