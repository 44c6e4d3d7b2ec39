//! Checks that an edited scene holds together: what holds for a packed one, but that skip distances may be shorter than they could be, that
//! places may be free, and that trees may lie anywhere.

use super::cells::{BRICK_SHIFT, child};
use super::grow::boxes;
use super::skip::{TILE, largest};
use super::{DynamicScene, emitters};
use crate::packed::{CELL_OCCUPIED, Emitter, Geometry, LightNode, PackedGrid, append_lights};
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashSet;
use voxtrace_scene::Invalid;

impl DynamicScene {
    /// Checks the whole scene: that every index lies inside its array, that no place is used twice or both used and free, that no skip distance
    /// reaches over something, and that emitters and the trees over them are those of packing from scratch. Takes about as long as packing.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        let geometry = self.geometry();
        geometry.validate_grids()?;
        self.validate_places()?;
        for grid in 0..geometry.grids.len() {
            geometry.validate_distances(&geometry.grids[grid])?;
            self.validate_lights(grid)?;
        }
        self.scene.placement.validate(geometry)
    }

    /// Checks that each place is used once or free, and what is counted.
    fn validate_places(&self) -> Result<(), Invalid> {
        let geometry = self.geometry();
        let (mut nodes, mut records, mut materials) = (Vec::new(), Vec::new(), Vec::new());
        for (index, grid) in geometry.grids.iter().enumerate() {
            let top = grid.top_size.element_product() as u32;
            nodes.push((grid.top_offset / 64, top.div_ceil(64)));
            let start = grid.top_offset as usize;
            let mut waiting = vec![(start, start + top as usize, grid.top_shift)];
            let (mut bricks, mut voxels) = (0, 0);
            while let Some((from, to, shift)) = waiting.pop() {
                for &cell in geometry.cells[from..to].iter().filter(|&cell| cell & CELL_OCCUPIED != 0) {
                    let place = child(cell);
                    if shift > BRICK_SHIFT {
                        nodes.push((place as u32, 1));
                        waiting.push((place * 64, place * 64 + 64, shift - 2));
                        continue;
                    }
                    let (header, count) = (geometry.bricks[place * 2], geometry.voxels_of(place * 2));
                    records.push((place as u32, 1 + (header & 0xff).count_ones()));
                    let length = geometry.material_words(grid, place * 2, count) as u32;
                    materials.push((geometry.bricks[place * 2 + 1], length));
                    (bricks, voxels) = (bricks + 1, voxels + u64::from(count));
                }
            }
            if bricks != self.bricks[index] || voxels != grid.voxel_count() {
                return Err(format!("grid {index}: its voxels are not those that were counted").into());
            }
        }
        check_places("cells", nodes, &self.pools.cells, geometry.cells.len().div_ceil(64))?;
        check_places("brick records", records, &self.pools.bricks, geometry.bricks.len() / 2)?;
        check_places("materials", materials, &self.pools.materials, geometry.brick_materials.len())?;
        let (mut leaves, mut spines) = (Vec::new(), Vec::new());
        for grid in 0..geometry.grids.len() as u32 {
            self.collect_lights(grid, &mut leaves, &mut spines)?;
        }
        check_places("emitters", leaves, &self.pools.emitters, geometry.emitters.len())?;
        check_places("nodes over emitters", spines, &self.pools.light_nodes, geometry.light_nodes.len())
    }

    /// The places of a grid's emitters and of the nodes over them.
    fn collect_lights(
        &self,
        grid: u32,
        leaves: &mut Vec<(u32, u32)>,
        spines: &mut Vec<(u32, u32)>,
    ) -> Result<(), Invalid> {
        let nodes = &self.geometry().light_nodes;
        let mut waiting: Vec<(u32, u32)> =
            self.geometry().light_root(grid).map(|root| (root, LightNode::NONE)).into_iter().collect();
        while let Some((at, parent)) = waiting.pop() {
            let node = nodes.get(at as usize).ok_or("a node over emitters lies outside")?;
            if node.parent != parent || spines.len() > nodes.len() {
                return Err(format!("node {at} over emitters does not find its parent").into());
            }
            spines.push((at, 1));
            match node.count {
                0 => waiting.extend([(at + 1, at), (node.index, at)]),
                count => leaves.push((node.index, count)),
            }
        }
        Ok(())
    }

    /// Checks that the tree over a grid's emitters is the one that packing makes, wherever its nodes lie.
    fn validate_lights(&self, grid: usize) -> Result<(), Invalid> {
        let geometry = self.geometry();
        let packed = &geometry.grids[grid];
        let bricks: Vec<IVec3> = geometry.bricks_of(packed).iter().map(|at| *at + (packed.origin >> 3)).collect();
        let found = emitters::emitters_of(geometry, grid, &bricks, &self.glow);
        let mut found: Vec<Emitter> = found.into_iter().flatten().collect();
        found.sort_unstable_by(|a, b| crate::packed::morton_order(a.voxel, b.voxel));
        let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
        append_lights(found, &mut emitters, &mut nodes);
        let mut pairs: Vec<(u32, u32)> = geometry.light_root(grid as u32).map(|root| (root, 0)).into_iter().collect();
        if pairs.is_empty() != nodes.is_empty() {
            return Err(format!("grid {grid}: there is an emitter without a tree, or a tree without emitters").into());
        }
        while let Some((own, canonical)) = pairs.pop() {
            let (a, b) = (&geometry.light_nodes[own as usize], &nodes[canonical as usize]);
            let alike = (a.min, a.max, a.power, a.count) == (b.min, b.max, b.power, b.count);
            let leaf = |node: &LightNode, emitters: &[Emitter]| -> Vec<Emitter> {
                let range = node.index as usize..(node.index + node.count) as usize;
                emitters[range].iter().map(|emitter| Emitter { leaf: 0, ..*emitter }).collect()
            };
            let is_same = alike
                && (a.count == 0 || leaf(a, &geometry.emitters) == leaf(b, &emitters))
                && geometry.emitters[a.index as usize * usize::from(a.count > 0)..][..a.count as usize]
                    .iter()
                    .all(|emitter| emitter.leaf == own);
            if !is_same {
                return Err(format!("grid {grid}: node {own} over emitters is not that of its voxels").into());
            }
            if a.count == 0 {
                pairs.extend([(own + 1, canonical + 1), (a.index, b.index)]);
            }
        }
        Ok(())
    }
}

/// Checks that places of an array are used once or free, and nothing else is there.
fn check_places(name: &str, mut used: Vec<(u32, u32)>, pool: &super::pool::Pool, length: usize) -> Result<(), Invalid> {
    used.extend(pool.places());
    used.retain(|&(_, size)| size > 0);
    used.sort_unstable();
    let mut end = 0;
    for (place, size) in used {
        if place != end {
            let what = if place < end { "used twice" } else { "lost" };
            return Err(format!("{name}: place {} is {what}", place.min(end)).into());
        }
        end = place + size;
    }
    if end as usize == length && pool.end() == length {
        Ok(())
    } else {
        Err(format!("{name}: places beyond {end} are lost").into())
    }
}

impl Geometry {
    /// Checks that no skip distance of a grid reaches over something.
    fn validate_distances(&self, grid: &PackedGrid) -> Result<(), Invalid> {
        let bricks = self.bricks_of(grid);
        for shift in (BRICK_SHIFT..=grid.top_shift).step_by(2) {
            let size = grid.top_size << (grid.top_shift - shift) as i32;
            // Where there are nodes: the whole of a grid may be far larger.
            let of_node = |brick: &IVec3| {
                let node: IVec3 = *brick >> (shift - 1) as i32;
                (node * 4).map(|v| v.div_euclid(TILE) * TILE)
            };
            let tiles: Vec<IVec3> = if shift == grid.top_shift {
                boxes(size, TILE).collect()
            } else {
                bricks.iter().map(of_node).collect::<FxHashSet<IVec3>>().into_iter().collect()
            };
            let stale = tiles.par_iter().find_map_any(|&low| {
                let found = largest(self, grid, shift, low, (low + TILE).min(size));
                self.first_beyond(grid, shift, &found)
            });
            if let Some(cell) = stale {
                return Err(format!(
                    "the skip distance of cell {cell} of {} voxels reaches over something",
                    1 << shift
                )
                .into());
            }
        }
        Ok(())
    }
}
