//! A scene that is edited while it is traced. It owns the arrays of a packed scene, with places in them that are free: a brick that changes
//! is encoded again, and written where it was or where there is room. What changed is a [`Patch`], which tracers apply to what they hold;
//! `docs/decisions/0140-editing-while-tracing.md` says how, and what it costs.
//!
//! At any time rays find the same voxels, and light is chosen the same, as in the scene packed from scratch.

mod apply;
mod cells;
mod clip;
mod compact;
mod dirty;
mod edit;
mod edit_error;
mod emitters;
mod fields;
mod grow;
mod history;
mod layers;
mod light_tree;
mod materials;
mod patch;
mod pieces;
mod plan;
mod pool;
mod recolor;
mod repair;
mod shorten;
mod sketch;
mod skip;
mod spread;
mod steps;
mod store;
#[cfg(test)]
mod tests;
mod validate;

pub use clip::Clip;
pub use edit::{Edit, Edited};
pub use edit_error::EditError;
pub use patch::{ArrayPatch, ChangedBrick, OutOfStep, Patch};
pub use pieces::{MassProperties, Piece};

use crate::packed::{Geometry, PackedInstance, PackedScene, Placement, PlacementError};
use emitters::Glow;
use glam::IVec3;
use history::History;
use light_tree::counts_below;
use repair::Repairs;
use rustc_hash::FxHashMap;
use std::sync::Arc;
use store::{DirtyArrays, Pools, Store};

/// A packed scene that can be edited: see the [module](self).
///
/// ```
/// use voxtrace_core::dynamic::{DynamicScene, Edit};
/// use voxtrace_core::{CpuTracer, PackedScene, Tracer};
/// use voxtrace_scene::{Material, Ray, Scene, Shape, VoxelGrid};
/// use voxtrace_scene::glam::{DVec3, IVec3, Vec3};
///
/// let mut grid = VoxelGrid::new();
/// grid.set(IVec3::ZERO, 0);
/// let packed = PackedScene::pack(&Scene::from_grid("one voxel", grid, vec![Material::default()]))?;
/// let mut tracer = CpuTracer::new(None);
/// tracer.set_scene(&packed.clone().into())?;
///
/// let mut scene = DynamicScene::new(packed)?;
/// let ball = Shape::Sphere { center: DVec3::new(40.0, 0.0, 0.0), radius: 16.0 };
/// scene.edit(0, &Edit::Fill { shape: ball, material: Some(0) })?;
/// tracer.patch(&scene.take_patch())?;
///
/// let ray = Ray::new(Vec3::new(40.0, 0.5, 90.0), Vec3::NEG_Z);
/// let hit = tracer.cast(&[ray])?[0].unwrap();
/// assert_eq!(hit.voxel, IVec3::new(40, 0, 15));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct DynamicScene {
    /// The scene as tracers see it.
    scene: PackedScene,
    pools: Pools,
    dirty: DirtyArrays,
    /// By [`store::epoch_position`].
    epochs: Vec<u16>,
    /// Of the last edit.
    epoch: u16,
    /// How many emitters are below each node of the trees over them.
    below: Vec<u32>,
    glow: Glow,
    /// Bricks of each grid.
    bricks: Vec<u64>,
    /// For each grid whether its bounds may be larger than its voxels.
    is_loose: Vec<bool>,
    history: History,
    /// Since the last patch: grid and brick.
    changed_bricks: FxHashMap<(u32, IVec3), ()>,
    regrown_grids: Vec<u32>,
    /// Whether the placement has to be made anew.
    is_placement_stale: bool,
    repairs: Repairs,
    /// Whether the placement is another one since the last patch.
    is_placed_anew: bool,
    /// Of the geometry when the last patch was taken.
    patched: (u64, u64),
}

impl DynamicScene {
    /// Takes a scene to edit. Its arrays are copied where somebody else holds them too.
    ///
    /// # Errors
    /// [`EditError::Merged`] where instances were merged: pack with instances kept, or [`PackedScene::split`] it.
    /// [`EditError::SmoothNormals`] where voxels have normals of their own.
    pub fn new(scene: PackedScene) -> Result<Self, EditError> {
        if scene.geometry.parts.is_some() {
            return Err(EditError::Merged);
        }
        if scene.geometry.has_normals() {
            return Err(EditError::SmoothNormals);
        }
        let geometry = &scene.geometry;
        let bricks: Vec<u64> = geometry.grids.iter().map(|grid| geometry.bricks_of(grid).len() as u64).collect();
        let scene = if geometry.is_edited || geometry.has_coverage { scene.compacted() } else { scene };
        let geometry = &scene.geometry;
        Ok(Self {
            pools: Pools::of(geometry),
            dirty: DirtyArrays::default(),
            epochs: vec![0; geometry.bricks.len().div_ceil(4)],
            epoch: 0,
            below: counts_below(&geometry.light_nodes),
            glow: Glow::of(&geometry.materials),
            is_loose: vec![false; bricks.len()],
            bricks,
            history: History::default(),
            changed_bricks: FxHashMap::default(),
            regrown_grids: Vec::new(),
            is_placement_stale: false,
            repairs: Repairs::new(),
            is_placed_anew: false,
            patched: geometry.state(),
            scene,
        })
    }

    /// The scene as it is now, as tracers see it: it can be cast through, and cloned to be set on a tracer, which can follow the patches that are
    /// taken afterwards, from the next one on if nothing was edited since the last. Its arrays have free places, which
    /// [`PackedScene::statistics`] counts; a file that is saved of it has none.
    pub fn scene(&self) -> &PackedScene {
        &self.scene
    }

    /// The material of a voxel of a grid, `None` where it is empty.
    pub fn voxel(&self, grid: u32, voxel: IVec3) -> Option<u16> {
        let packed = self.scene.geometry.grids.get(grid as usize)?;
        self.scene.geometry.material_at(packed, voxel).map(|material| material as u16)
    }

    /// Puts the grids elsewhere, or more or fewer instances of them. This is no edit that can be undone.
    ///
    /// # Errors
    /// As [`Placement::new`], with nothing changed.
    pub fn place(&mut self, instances: impl IntoIterator<Item = PackedInstance>) -> Result<(), PlacementError> {
        self.scene.placement = Placement::new(&self.scene.geometry, instances)?;
        self.is_placed_anew = true;
        Ok(())
    }

    /// When bricks changed last, for caches of what is on their surface: for the brick with a record at word p of the records, `epochs()[p / 4]` is
    /// another number after each edit that changed it, or moved its record; 0 where none did. Numbers come again after 65,535 edits.
    pub fn epochs(&self) -> &[u16] {
        &self.epochs
    }

    /// What changed since the last call, or since the scene was taken: for [`crate::Tracer::patch`] of each tracer that shows it.
    pub fn take_patch(&mut self) -> Patch {
        let before = self.patched;
        if self.dirty.is_clean() && !self.is_placed_anew && self.changed_bricks.is_empty() {
            return Patch::nothing(&self.scene.geometry, before);
        }
        let geometry = Arc::make_mut(&mut self.scene.geometry);
        geometry.revision += 1;
        self.patched = geometry.state();
        let cell = |&(grid, brick): &(u32, IVec3)| {
            let (position, shift) = geometry.cell_of_brick(&geometry.grids[grid as usize], brick)?;
            let cell = geometry.cells[position];
            (shift == cells::BRICK_SHIFT && cell & crate::packed::CELL_OCCUPIED != 0).then_some(cell)
        };
        let mut changed: Vec<(u32, IVec3)> = self.changed_bricks.drain().map(|(key, ())| key).collect();
        changed.sort_unstable_by_key(|(grid, brick)| (*grid, brick.z, brick.y, brick.x));
        let changed_bricks =
            (changed.iter()).map(|key| ChangedBrick { grid: key.0, brick: key.1, cell: cell(key) }).collect();
        Patch {
            cells: self.dirty.cells.take(&geometry.cells),
            bricks: self.dirty.bricks.take(&geometry.bricks),
            brick_materials: self.dirty.materials.take(&geometry.brick_materials),
            materials: self.dirty.palette.take(&geometry.materials),
            epochs: self.dirty.epochs.take(&self.epochs),
            emitters: self.dirty.emitters.take(&geometry.emitters),
            light_nodes: self.dirty.light_nodes.take(&geometry.light_nodes),
            grids: geometry.grids.to_vec(),
            light_roots: geometry.light_roots.clone(),
            scene_grids: geometry.scene_grids.clone(),
            placement: std::mem::take(&mut self.is_placed_anew).then(|| self.scene.placement.clone()),
            changed_bricks,
            regrown_grids: std::mem::take(&mut self.regrown_grids),
            states: (before, self.patched),
        }
    }

    /// The arrays, to be changed.
    fn store(&mut self) -> Store<'_> {
        Store {
            geometry: Arc::make_mut(&mut self.scene.geometry),
            pools: &mut self.pools,
            dirty: &mut self.dirty,
            epochs: &mut self.epochs,
            below: &mut self.below,
        }
    }

    fn geometry(&self) -> &Geometry {
        &self.scene.geometry
    }
}
