//! What a tracer needs to follow edits: of each array the ranges that were written, and what is small as a whole.

use crate::packed::{Emitter, Geometry, LightNode, PackedGrid, PackedMaterial, PackedScene, Placement, Section};
use bytemuck::Pod;
use glam::IVec3;
use std::sync::Arc;

/// The difference between a scene as it was and as it is after edits: of [`super::DynamicScene::take_patch`], for
/// [`crate::Tracer::patch`]. Patches are taken in their order, each once by each tracer.
#[derive(Clone, Debug, Default)]
pub struct Patch {
    /// Cells: words.
    pub cells: ArrayPatch<u32>,
    /// Brick records: words.
    pub bricks: ArrayPatch<u32>,
    /// Materials of the voxels: words.
    pub brick_materials: ArrayPatch<u32>,
    /// Materials of the scene, of which there may be more.
    pub materials: ArrayPatch<PackedMaterial>,
    /// When bricks changed last: see [`super::DynamicScene::epochs`].
    pub epochs: ArrayPatch<u16>,
    /// Emitters.
    pub emitters: ArrayPatch<Emitter>,
    /// Nodes of the trees over emitters.
    pub light_nodes: ArrayPatch<LightNode>,
    /// All grids.
    pub grids: Vec<PackedGrid>,
    /// For each grid the root of its light tree, [`LightNode::NONE`] where nothing emits.
    pub light_roots: Arc<[u32]>,
    /// For each grid its index among the grids of the scene that was packed.
    pub(crate) scene_grids: Arc<[u32]>,
    /// Where things are, where that changed: the bounds of a grid, what it emits, or instances.
    pub placement: Option<Placement>,
    /// The bricks that are others now, each once, in no order of meaning.
    pub changed_bricks: Vec<ChangedBrick>,
    /// Grids whose top array is another one: its origin, its size or the width of its cells.
    pub regrown_grids: Vec<u32>,
    /// Of the geometry before, and of the one after.
    pub(crate) states: ((u64, u64), (u64, u64)),
}

/// What changed of one array.
#[derive(Clone, Debug, PartialEq)]
pub struct ArrayPatch<T> {
    /// Records that the array has now; it never gets shorter.
    pub length: usize,
    /// First record and number of records of each range that was written, in ascending order, none touching another.
    pub ranges: Vec<(usize, usize)>,
    /// The records of all ranges, one after the other.
    pub records: Vec<T>,
}

/// A brick that changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChangedBrick {
    /// Index of the grid.
    pub grid: u32,
    /// Coordinates of the brick: those of its voxels divided by 8, rounded down.
    pub brick: IVec3,
    /// The word of its cell: with the position of its record in the low 31 bits, in units of two words. `None` where it is empty now.
    pub cell: Option<u32>,
}

/// A patch that does not follow on what a tracer has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the patch does not follow on the scene that the tracer has; set the scene again")]
pub struct OutOfStep;

impl<T> Default for ArrayPatch<T> {
    fn default() -> Self {
        Self { length: 0, ranges: Vec::new(), records: Vec::new() }
    }
}

impl<T: Pod> ArrayPatch<T> {
    /// Each range: its first record and its records.
    pub fn parts(&self) -> impl Iterator<Item = (usize, &[T])> {
        let mut at = 0;
        self.ranges.iter().map(move |&(start, length)| {
            at += length;
            (start, &self.records[at - length..at])
        })
    }

    /// Bytes that are written.
    pub fn size_bytes(&self) -> u64 {
        size_of_val(&*self.records) as u64
    }

    fn apply(&self, section: &mut Section<T>) {
        if self.length != section.len() {
            section.set_length(self.length);
        }
        if !self.ranges.is_empty() {
            let array = section.as_mut();
            self.parts().for_each(|(start, records)| array[start..start + records.len()].copy_from_slice(records));
        }
    }
}

impl Patch {
    /// Of a scene in this state that did not change.
    pub(super) fn nothing(geometry: &Geometry, state: (u64, u64)) -> Self {
        fn whole<T: Pod>(array: &[T]) -> ArrayPatch<T> {
            ArrayPatch { length: array.len(), ranges: Vec::new(), records: Vec::new() }
        }
        Self {
            cells: whole(&geometry.cells),
            bricks: whole(&geometry.bricks),
            brick_materials: whole(&geometry.brick_materials),
            materials: whole(&geometry.materials),
            epochs: ArrayPatch { length: geometry.bricks.len().div_ceil(4), ..ArrayPatch::default() },
            emitters: whole(&geometry.emitters),
            light_nodes: whole(&geometry.light_nodes),
            grids: geometry.grids.to_vec(),
            light_roots: geometry.light_roots.clone(),
            scene_grids: geometry.scene_grids.clone(),
            states: (state, state),
            ..Self::default()
        }
    }

    /// Bytes that it writes, without what is small.
    pub fn size_bytes(&self) -> u64 {
        let words = self.cells.size_bytes() + self.bricks.size_bytes() + self.brick_materials.size_bytes();
        words
            + self.materials.size_bytes()
            + self.epochs.size_bytes()
            + self.emitters.size_bytes()
            + self.light_nodes.size_bytes()
    }

    /// Whether a tracer has nothing to do.
    pub fn is_empty(&self) -> bool {
        self.size_bytes() == 0 && self.placement.is_none() && self.states.0 == self.states.1
    }
}

impl PackedScene {
    /// Follows edits: in place where nobody else holds the scene's arrays, on copies where somebody does.
    ///
    /// # Errors
    /// [`OutOfStep`] where the patch was made for another state, with nothing changed.
    pub fn apply_patch(&mut self, patch: &Patch) -> Result<(), OutOfStep> {
        if patch.states.0 != self.geometry.state() {
            return Err(OutOfStep);
        }
        if patch.is_empty() {
            return Ok(());
        }
        let geometry: &mut Geometry = Arc::make_mut(&mut self.geometry);
        patch.cells.apply(&mut geometry.cells);
        patch.bricks.apply(&mut geometry.bricks);
        patch.brick_materials.apply(&mut geometry.brick_materials);
        patch.materials.apply(&mut geometry.materials);
        patch.emitters.apply(&mut geometry.emitters);
        patch.light_nodes.apply(&mut geometry.light_nodes);
        geometry.grids = patch.grids.clone().into();
        geometry.light_roots = patch.light_roots.clone();
        geometry.scene_grids = patch.scene_grids.clone();
        (geometry.fingerprint, geometry.revision) = patch.states.1;
        geometry.is_edited = true;
        if let Some(placement) = &patch.placement {
            self.placement = placement.clone();
        }
        Ok(())
    }
}
