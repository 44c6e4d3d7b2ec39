//! The part of a packed scene that stays while things move: grids with their bricks and materials, and the emitters of each
//! grid with the tree over them, in the space of the grid.

use super::parts::Parts;
use super::{Emitter, LightNode, PackedGrid, PackedMaterial, Section};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// Grids, materials and emitters: what instances share.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// Cells: the top arrays of all grids, each padded to 64 words, and the nodes of 64 cells.
    pub(crate) cells: Section<u32>,
    /// Brick records: header, position of the materials, masks of the blocks that hold a voxel (two words each).
    pub(crate) bricks: Section<u32>,
    /// Materials of the voxels: for each brick its palette and its packed indices.
    pub(crate) brick_materials: Section<u32>,
    /// Grids.
    pub(crate) grids: Section<PackedGrid>,
    /// Materials.
    pub(crate) materials: Section<PackedMaterial>,
    /// Emissive voxels that light can leave, ordered by grid and [`super::morton_order`].
    pub(crate) emitters: Section<Emitter>,
    /// Trees over the emitters of each grid that has any, one after the other, in the space of the grid.
    pub(crate) light_nodes: Section<LightNode>,
    /// Whether the normals of voxels stand before the materials of their bricks.
    pub(crate) has_normals: bool,
    /// Whether the coverages of voxels stand there, as in levels of detail.
    pub(crate) has_coverage: bool,
    /// For each grid its index among the grids of the scene that was packed; empty where those are the same.
    pub(crate) scene_grids: Arc<[u32]>,
    /// What a merged grid was made of, where instances were merged.
    pub(crate) parts: Option<Arc<Parts>>,
    /// For each grid the root of its tree, [`LightNode::NONE`] where nothing emits.
    pub(crate) light_roots: Arc<[u32]>,
    /// Whether it was edited in place: its arrays have free places, and what follows from their order is missing.
    pub(crate) is_edited: bool,
    /// Of everything that placements depend on.
    pub(crate) fingerprint: u64,
    /// How many patches were taken of it, or applied to it.
    pub(crate) revision: u64,
}

impl Geometry {
    /// Fills in what follows from the arrays, which must be valid.
    pub(crate) fn finished(self) -> Self {
        let mut light_roots = vec![LightNode::NONE; self.grids.len()];
        let mut hash = Xxh3::new();
        hash.update(bytemuck::cast_slice(&self.grids));
        for (at, node) in self.light_nodes.iter().enumerate().filter(|(_, node)| node.parent == LightNode::NONE) {
            let emitter = self.light_nodes[at..].iter().find(|node| node.count > 0).map(|leaf| leaf.index as usize);
            if let Some(root) = emitter.and_then(|first| light_roots.get_mut(self.emitters[first].grid as usize)) {
                *root = at as u32;
            }
            hash.update(bytemuck::bytes_of(node));
        }
        hash.update(bytemuck::cast_slice(&light_roots));
        Self { light_roots: light_roots.into(), fingerprint: hash.digest(), ..self }
    }

    /// As [`Self::fingerprint`], of one that is edited: where the roots are is known.
    pub(crate) fn fingerprint_of_edited(&self) -> u64 {
        let mut hash = Xxh3::new();
        for (grid, root) in self.grids.iter().zip(&*self.light_roots) {
            hash.update(bytemuck::cast_slice(&[grid.min, grid.max]));
            hash.update(&root.to_le_bytes());
            hash.update(self.light_nodes.get(*root as usize).map_or(&[], bytemuck::bytes_of));
        }
        hash.digest()
    }

    /// What it is, for patches, each of which follows on one state.
    pub(crate) fn state(&self) -> (u64, u64) {
        (self.fingerprint, self.revision)
    }

    /// A number that two geometries share only where the same placements suit both.
    pub(super) fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// The root of the tree over a grid's emitters, `None` where nothing emits.
    #[doc(hidden)]
    pub fn light_root(&self, grid: u32) -> Option<u32> {
        self.light_roots.get(grid as usize).copied().filter(|&root| root != LightNode::NONE)
    }

    /// The grid that shows a grid of the scene that was packed, `None` where that one was hidden or empty.
    pub fn grid_of_scene(&self, scene_grid: usize) -> Option<u32> {
        let scene_grid = u32::try_from(scene_grid).ok()?;
        if self.scene_grids.is_empty() {
            return ((scene_grid as usize) < self.grids.len()).then_some(scene_grid);
        }
        self.scene_grids.binary_search(&scene_grid).ok().map(|grid| grid as u32)
    }

    /// Whether signed 32-bit numbers reach every word of the arrays that walks read.
    pub(crate) fn is_within_gather_reach(&self) -> bool {
        self.cells.len() <= i32::MAX as usize && self.bricks.len() <= i32::MAX as usize
    }
}

/// The arrays, for tracers on other devices.
impl Geometry {
    /// Top arrays of all grids, each padded to 64 words, and nodes of 64 cells.
    #[doc(hidden)]
    pub fn cells(&self) -> &[u32] {
        &self.cells
    }

    /// Brick records: header, position of the materials, masks of the blocks that hold a voxel.
    #[doc(hidden)]
    pub fn bricks(&self) -> &[u32] {
        &self.bricks
    }

    /// For each brick its palette and its packed indices.
    #[doc(hidden)]
    pub fn brick_materials(&self) -> &[u32] {
        &self.brick_materials
    }

    /// Grids.
    pub fn grids(&self) -> &[PackedGrid] {
        &self.grids
    }

    /// Materials.
    pub fn materials(&self) -> &[PackedMaterial] {
        &self.materials
    }

    /// Emissive voxels that light can leave, ordered by grid and [`super::morton_order`].
    #[doc(hidden)]
    pub fn emitters(&self) -> &[Emitter] {
        &self.emitters
    }

    /// Trees over the emitters of each grid that has any, one after the other, in the space of the grid.
    #[doc(hidden)]
    pub fn light_nodes(&self) -> &[LightNode] {
        &self.light_nodes
    }
}
