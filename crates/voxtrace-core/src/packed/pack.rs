//! From the editable scene to the packed one.

use super::brick_record::{BrickWords, encode_bricks};
use super::lights::lights_of;
use super::lookup::cell_in_node;
use super::skip_distances::{Level, skip_distances_of};
use super::{CELL_OCCUPIED, Geometry, Outline, PackedGrid, PackedInstance, PackedMaterial, PackedScene, Placement};
use crate::cuts::Cuts;
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::{VoxelBox, VoxelGrid};
use voxtrace_scene::material::MAX_MATERIALS;
use voxtrace_scene::scene::{Instance, Scene};
use voxtrace_scene::transform::Transform;

/// A scene cannot be packed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PackError {
    /// More materials than 16 bits can name.
    #[error("{0} materials are more than the {MAX_MATERIALS} that a scene may hold")]
    TooManyMaterials(usize),
    /// A voxel names a material that the scene lacks.
    #[error("grid {grid} uses material {material}, but the scene has {count}")]
    MissingMaterial {
        /// Index of the grid.
        grid: usize,
        /// Index of the material.
        material: u16,
        /// Materials there are.
        count: usize,
    },
    /// An instance names a grid that the scene lacks.
    #[error("instance {instance} shows grid {grid}, but the scene has {count}")]
    MissingGrid {
        /// Index of the instance.
        instance: usize,
        /// Index of the grid.
        grid: usize,
        /// Grids there are.
        count: usize,
    },
    /// An instance is sheared, scaled unevenly, flattened or not finite.
    #[error("the transform of instance {0} is not a rotation, mirror, uniform scale and translation")]
    BadTransform(usize),
    /// More words, or pairs or nodes of them, than an index can reach.
    #[error("the scene is too large: {0} words of {1}")]
    TooLarge(u64, &'static str),
    /// Nobody waits for it any more: see [`PackedScene::pack_while`].
    #[error("the packed scene is not wanted any more")]
    Stopped,
}

impl PackedScene {
    /// Packs what is visible: grids of hidden instances are left out.
    ///
    /// # Errors
    /// [`PackError`] when the scene contradicts itself or is too large.
    pub fn pack(scene: &Scene) -> Result<Self, PackError> {
        Self::pack_while(scene, &|| true)
    }

    /// As [`Self::pack`], as long as it is `wanted`, which is asked between the steps, on several threads, and which says no for good.
    ///
    /// # Errors
    /// As [`Self::pack`]; [`PackError::Stopped`] once it is not wanted any more.
    pub fn pack_while(scene: &Scene, wanted: &(dyn Fn() -> bool + Sync)) -> Result<Self, PackError> {
        check(scene)?;
        let placed: Vec<Placed> =
            visible_of(scene).into_iter().map(|(index, instance)| Placed::of(index, instance)).collect();
        pack_placed(scene, &placed, wanted)
    }
}

/// Where a grid of the scene is placed.
pub(super) struct Placed {
    /// Index of the instance in the scene.
    pub scene_instance: usize,
    /// Index of the grid in the scene.
    pub grid: usize,
    /// From grid to world space.
    pub world_from_grid: Transform,
}

impl Placed {
    pub fn of(scene_instance: usize, instance: &Instance) -> Self {
        Self { scene_instance, grid: instance.grid, world_from_grid: instance.world_from_grid }
    }
}

/// The instances of a scene that are packed, with their indices.
pub(super) fn visible_of(scene: &Scene) -> Vec<(usize, &Instance)> {
    let is_packed = |instance: &Instance| scene.is_visible(instance) && !scene.grids[instance.grid].is_empty();
    scene.instances.iter().enumerate().filter(|(_, instance)| is_packed(instance)).collect()
}

/// Packs those grids of a scene that are placed.
pub(super) fn pack_placed(
    scene: &Scene,
    placed: &[Placed],
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<PackedScene, PackError> {
    let go_on = || if wanted() { Ok(()) } else { Err(PackError::Stopped) };
    let material_bits = material_bits_of(scene);
    let mut used: Vec<usize> = placed.iter().map(|placed| placed.grid).collect();
    used.sort_unstable();
    used.dedup();

    let part = |&grid: &usize| pack_grid(&scene.grids[grid], material_bits, &go_on);
    let parts: Vec<GridPart> = used.par_iter().map(part).collect::<Result<_, _>>()?;
    let (mut cells, mut bricks, mut brick_materials, mut grids) = (vec![], vec![], vec![], vec![]);
    for part in parts {
        part.append(&mut cells, &mut bricks, &mut brick_materials, &mut grids)?;
    }

    go_on()?;
    let (emitters, light_nodes) = lights_of(scene, &used);
    go_on()?;
    let geometry = Geometry {
        cells: cells.into(),
        bricks: bricks.into(),
        brick_materials: brick_materials.into(),
        grids: grids.into(),
        materials: scene.materials.iter().map(PackedMaterial::from).collect::<Vec<_>>().into(),
        emitters: emitters.into(),
        light_nodes: light_nodes.into(),
        scene_grids: used.iter().map(|&grid| grid as u32).collect(),
        ..Geometry::default()
    }
    .finished();
    let place = |placed: &Placed| {
        let grid = used.binary_search(&placed.grid).expect("used holds every grid that is placed");
        PackedInstance::new(grid as u32, placed.world_from_grid, placed.scene_instance as u32)
    };
    let instances = placed.iter().map(place).collect();
    Ok(PackedScene {
        name: scene.name.clone(),
        placement: Placement::of_sound(&geometry, instances),
        geometry: Arc::new(geometry),
        sky: scene.sky.clone(),
        light_intensity: scene.light_intensity,
        cameras: scene.cameras.clone(),
        cuts: Cuts::default(),
        ground: None,
        voxel_size: scene.voxel_size,
        georeference: scene.georeference.clone(),
        unit: scene.unit,
        outline: Arc::new(Outline::of_scene(scene)),
    })
}

pub(super) fn check(scene: &Scene) -> Result<(), PackError> {
    if scene.materials.len() > MAX_MATERIALS {
        return Err(PackError::TooManyMaterials(scene.materials.len()));
    }
    for (index, instance) in scene.instances.iter().enumerate() {
        if instance.grid >= scene.grids.len() {
            let (instance, grid, count) = (index, instance.grid, scene.grids.len());
            return Err(PackError::MissingGrid { instance, grid, count });
        }
        if !instance.world_from_grid.is_similarity() {
            return Err(PackError::BadTransform(index));
        }
    }
    let count = scene.materials.len();
    for (index, grid) in scene.grids.iter().enumerate() {
        let largest = |(_, brick): &(IVec3, &Brick)| brick.materials().iter().copied().max().unwrap_or(0);
        let material = grid.sorted_bricks().par_iter().map(largest).max().unwrap_or(0);
        if usize::from(material) >= count && !grid.is_empty() {
            return Err(PackError::MissingMaterial { grid: index, material, count });
        }
    }
    Ok(())
}

/// A grid packed on its own; positions count from the start of its own arrays until it is appended.
#[derive(Clone)]
pub(crate) struct GridPart {
    grid: PackedGrid,
    /// The top cells, padded to a multiple of 64, then the nodes of the finer levels, coarse to fine.
    cells: Vec<u32>,
    /// Where `cells` hold children that are nodes, not bricks: `0..first_brick_cell`.
    first_brick_cell: usize,
    bricks: BrickWords,
}

pub(crate) fn pack_grid(
    grid: &VoxelGrid,
    material_bits: u32,
    go_on: &(dyn Fn() -> Result<(), PackError> + Sync),
) -> Result<GridPart, PackError> {
    go_on()?;
    let bounds = grid.bounds().expect("empty grids are not packed");
    let origin = bounds.min & !(BRICK_SIZE - 1);
    let mut bricks: Vec<(IVec3, &Brick)> =
        grid.sorted_bricks().into_iter().map(|(at, brick)| (at - (origin >> 3), brick)).collect();
    let coordinates: Vec<IVec3> = bricks.iter().map(|&(at, _)| at).collect();
    let levels = levels_of(&coordinates, bounds.max - origin);
    go_on()?;
    // Neighbours in space are then neighbours in memory.
    bricks.par_sort_by_cached_key(|&(at, _)| ordered_position(&levels, at));
    go_on()?;
    let encoded = encode_bricks(&bricks, material_bits);
    go_on()?;
    let CellsOfGrid { mut cells, base } = cells_of(&levels);
    name_bricks(&levels, &mut cells[base..], encoded.positions.iter().map(|&position| (position / 2) as u32));
    let top = &levels[0];
    let voxels = grid.count();
    let VoxelBox { min, max } = bounds;
    Ok(GridPart {
        grid: PackedGrid {
            origin,
            top_shift: top.shift,
            top_size: top.size,
            top_offset: 0,
            min,
            voxels: [voxels as u32, (voxels >> 32) as u32],
            max,
            material_bits,
        },
        cells,
        first_brick_cell: base,
        bricks: encoded,
    })
}

/// The cells of a grid before its bricks are known.
pub(super) struct CellsOfGrid {
    /// The top cells, padded to a multiple of 64, then the nodes of the finer levels, coarse to fine.
    pub cells: Vec<u32>,
    /// Where the cells of the finest level begin.
    pub base: usize,
}

/// The cells over the levels of a grid; those of the finest level do not yet name their bricks.
pub(super) fn cells_of(levels: &[Level]) -> CellsOfGrid {
    let top = &levels[0];
    let skip_distances = skip_distances_of(levels);
    // The top array, padded, then the nodes of each finer level; the children of a level are the nodes of the next.
    let mut cells = skip_distances[0].clone();
    cells.resize(top.occupied.len().next_multiple_of(64), 0);
    let mut base = 0;
    for (depth, pair) in levels.windows(2).enumerate() {
        let first_node = cells.len() / 64;
        for (index, &at) in pair[1].nodes.iter().enumerate() {
            cells[base + cell_position(&pair[0], at)] = CELL_OCCUPIED | (first_node + index) as u32;
        }
        base = cells.len();
        cells.extend_from_slice(&skip_distances[depth + 1]);
    }
    CellsOfGrid { cells, base }
}

/// Position of a brick's cell among the cells of the finest level: the order of bricks in memory.
pub(super) fn ordered_position(levels: &[Level], brick: IVec3) -> u64 {
    cell_position(&levels[levels.len() - 1], brick) as u64
}

/// Lets the occupied cells of the finest level name the records of their bricks, which are given in the order of [`ordered_position`]. `cells` are those of
/// this level.
pub(super) fn name_bricks(levels: &[Level], cells: &mut [u32], records: impl IntoIterator<Item = u32>) {
    let occupied = cells.iter_mut().zip(&levels[levels.len() - 1].occupied).filter(|(_, is_occupied)| **is_occupied);
    occupied.zip(records).for_each(|((cell, _), record)| *cell = CELL_OCCUPIED | record);
}

/// Bits of a palette entry: a byte where that can name every material.
pub(super) fn material_bits_of(scene: &Scene) -> u32 {
    if scene.materials.len() <= 256 { 8 } else { 16 }
}

/// Position of a cell, in cells from the grid's origin, among the cells of its level.
fn cell_position(level: &Level, cell: IVec3) -> usize {
    if level.nodes.is_empty() {
        let [[x, y, z], [wide, deep, _]] = [cell, level.size].map(|at| at.to_array().map(|n| n as usize));
        return (z * deep + y) * wide + x;
    }
    level.index_of[&(cell >> 2)] as usize * 64 + cell_in_node(cell, 0)
}

/// The levels of the tree over bricks, coarse to fine. The top array is as fine as memory allows: no more cells than
/// the grid has bricks (or 64), so that it follows the surface, not the volume.
pub(super) fn levels_of(bricks: &[IVec3], extent: IVec3) -> Vec<Level> {
    let most_cells = bricks.len().max(64) as u64;
    let size_at = |shift: u32| (extent + ((1 << shift) - 1)) >> shift as i32;
    let volume = |size: IVec3| size.to_array().iter().map(|&n| n as u64).product::<u64>();
    let top_shift = (3..).step_by(2).find(|&shift| volume(size_at(shift)) <= most_cells).expect("one cell always fits");

    let mut finer: Vec<Level> = Vec::new();
    let mut occupied_cells: Vec<IVec3> = bricks.to_vec();
    for shift in (3..top_shift).step_by(2) {
        // The cells of a node stand together then.
        occupied_cells.par_sort_unstable_by_key(|&cell| (cell.z >> 2, cell.y >> 2, cell.x >> 2));
        let of_nodes = || occupied_cells.chunk_by(|&a, &b| a >> 2 == b >> 2);
        let nodes: Vec<IVec3> = of_nodes().map(|cells| cells[0] >> 2).collect();
        let index_of: FxHashMap<IVec3, u32> = nodes.iter().enumerate().map(|(i, &at)| (at, i as u32)).collect();
        let mut occupied = vec![false; nodes.len() * 64];
        for (cells, occupied) in of_nodes().zip(occupied.as_chunks_mut::<64>().0) {
            cells.iter().for_each(|&cell| occupied[cell_in_node(cell, 0)] = true);
        }
        occupied_cells.clone_from(&nodes);
        finer.push(Level { shift, nodes, index_of, size: IVec3::ZERO, occupied });
    }
    let size = size_at(top_shift);
    let mut top = Level {
        shift: top_shift,
        nodes: Vec::new(),
        index_of: FxHashMap::default(),
        size,
        occupied: vec![false; volume(size) as usize],
    };
    for &cell in &occupied_cells {
        let position = cell_position(&top, cell);
        top.occupied[position] = true;
    }
    std::iter::once(top).chain(finer.into_iter().rev()).collect()
}

impl GridPart {
    /// Appends the grid to the scene's arrays and turns its positions into positions there.
    pub(crate) fn append(
        mut self,
        cells: &mut Vec<u32>,
        bricks: &mut Vec<u32>,
        brick_materials: &mut Vec<u32>,
        grids: &mut Vec<PackedGrid>,
    ) -> Result<(), PackError> {
        let node_offset = (cells.len() / 64) as u32;
        let brick_offset = (bricks.len() / 2) as u32;
        let material_offset = brick_materials.len() as u32;
        let sizes = [
            ("cells", (cells.len() + self.cells.len()) as u64 / 64),
            ("bricks", (bricks.len() + self.bricks.records.len()) as u64 / 2),
            ("materials", (brick_materials.len() + self.bricks.materials.len()) as u64 / 2),
        ];
        if let Some(&(name, words)) = sizes.iter().find(|(_, words)| *words >= u64::from(CELL_OCCUPIED)) {
            return Err(PackError::TooLarge(words, name));
        }
        self.grid.top_offset = top_offset(cells.len())?;
        for (index, cell) in self.cells.iter_mut().enumerate() {
            if *cell & CELL_OCCUPIED != 0 {
                *cell += if index < self.first_brick_cell { node_offset } else { brick_offset };
            }
        }
        for &position in &self.bricks.positions {
            self.bricks.records[position + 1] += material_offset;
        }
        grids.push(self.grid);
        append_or_move(cells, self.cells);
        append_or_move(bricks, self.bricks.records);
        append_or_move(brick_materials, self.bricks.materials);
        Ok(())
    }
}

/// Where the top cells of a grid begin behind so many cells. Nodes are named by their number, but top cells by that of their first word, so that less of
/// these can stand before them.
pub(super) fn top_offset(cells: usize) -> Result<u32, PackError> {
    u32::try_from(cells).map_err(|_| PackError::TooLarge(cells as u64, "cells before those of a grid"))
}

/// Appends, without a copy where there was nothing yet: the first grid may be gigabytes.
fn append_or_move(to: &mut Vec<u32>, from: Vec<u32>) {
    if to.is_empty() {
        *to = from;
    } else {
        to.extend_from_slice(&from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
    use voxtrace_scene::material::Material;

    #[cfg(target_pointer_width = "64")]
    #[test]
    fn top_cells_begin_where_32_bits_can_say_it_or_are_an_error() {
        assert_eq!(top_offset(u32::MAX as usize), Ok(u32::MAX));
        let beyond = u32::MAX as usize + 1;
        assert_eq!(top_offset(beyond), Err(PackError::TooLarge(1 << 32, "cells before those of a grid")));
    }

    #[test]
    fn packing_ends_where_nobody_waits_for_it_and_is_the_same_where_somebody_does() {
        let mut grid = VoxelGrid::new();
        for i in 0..60 {
            grid.set(IVec3::new(i, 7 * i % 60, 3), 0);
        }
        let scene = Scene::from_grid("line", grid, vec![Material::default()]);
        let asked = AtomicU32::new(0);
        let until = |most: u32| {
            asked.store(0, Relaxed);
            PackedScene::pack_while(&scene, &|| asked.fetch_add(1, Relaxed) < most)
        };
        let whole = until(u32::MAX).unwrap();
        assert_eq!(whole.geometry().bricks(), PackedScene::pack(&scene).unwrap().geometry().bricks());
        let all = asked.load(Relaxed);
        assert!(all > 4);
        for most in 0..all {
            assert_eq!(until(most).err(), Some(PackError::Stopped), "{most}");
        }
        assert!(until(all).is_ok());
    }
}
