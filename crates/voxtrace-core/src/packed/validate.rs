//! Checks that a packed scene holds together: every index lies inside its array and every tree ends. Tracing a valid
//! scene cannot read out of bounds.

use super::lights::validate_lights;
use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE};
use super::{CELL_OCCUPIED, PackedGrid, PackedScene};
use glam::IVec3;
use voxtrace_scene::grid::MAX_COORDINATE;

impl PackedScene {
    /// Checks the whole scene.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), String> {
        let mut cells_left = self.cells.len();
        for (index, grid) in self.grids.iter().enumerate() {
            self.validate_grid(grid, &mut cells_left).map_err(|fault| format!("grid {index}: {fault}"))?;
        }
        for (index, instance) in self.instances.iter().enumerate() {
            if instance.grid as usize >= self.grids.len() {
                return Err(format!("instance {index} shows grid {}, which is missing", instance.grid));
            }
            if !instance.world_from_grid.is_similarity() || !instance.grid_from_world.is_similarity() {
                return Err(format!("instance {index} has a transform that is no similarity"));
            }
        }
        let nodes: Vec<_> = self.instance_nodes.iter().map(|node| (node.index, node.is_leaf)).collect();
        for (index, &(child, is_leaf)) in nodes.iter().enumerate() {
            // The left child follows its parent, the right one comes later: the tree has no cycle.
            let is_sound = if is_leaf == 1 {
                (child as usize) < self.instances.len()
            } else {
                is_leaf == 0 && child as usize > index + 1 && (child as usize) < nodes.len()
            };
            if !is_sound {
                return Err(format!("node {index} of the tree over instances points outside"));
            }
        }
        if depth_of(&nodes).is_none_or(|depth| depth >= 64) {
            return Err("the tree over instances is too deep".into());
        }
        validate_lights(self)
    }

    fn validate_grid(&self, grid: &PackedGrid, cells_left: &mut usize) -> Result<(), String> {
        let far = IVec3::splat(MAX_COORDINATE + 8);
        // The smallest number has no absolute value.
        let is_near = |point: IVec3| point.cmple(far).all() && point.cmpge(-far).all();
        let is_shift = (3..=21).contains(&grid.top_shift) && grid.top_shift % 2 == 1;
        if !is_near(grid.origin) || !is_near(grid.min) || !is_near(grid.max) || grid.origin & 7 != IVec3::ZERO {
            return Err("coordinates out of range".into());
        }
        if !is_shift || grid.material_bits != 8 && grid.material_bits != 16 || grid.top_size.min_element() < 1 {
            return Err("impossible shape".into());
        }
        let reach = grid.top_size.as_i64vec3() << i64::from(grid.top_shift);
        let is_covered = (grid.max - grid.origin).as_i64vec3().cmple(reach).all();
        if !is_covered || grid.min.cmplt(grid.origin).any() || grid.min.cmpge(grid.max).any() {
            return Err("the bounds are not those of its cells".into());
        }
        let top_cells = grid.top_size.to_array().iter().try_fold(1usize, |cells, &n| cells.checked_mul(n as usize));
        let start = grid.top_offset as usize;
        let end = top_cells.and_then(|cells| start.checked_add(cells));
        let end = end.filter(|&end| end <= self.cells.len()).ok_or("cells are missing")?;
        self.validate_cells(grid, start, end, grid.top_shift, cells_left)
    }

    fn validate_cells(
        &self,
        grid: &PackedGrid,
        start: usize,
        end: usize,
        shift: u32,
        cells_left: &mut usize,
    ) -> Result<(), String> {
        // Each cell belongs to one grid and one node: visiting more than there are means that some are shared, and sharing
        // could make the visit endless.
        *cells_left = cells_left.checked_sub(end - start).ok_or("cells are shared")?;
        for &cell in self.cells[start..end].iter().filter(|&cell| cell & CELL_OCCUPIED != 0) {
            let child = (cell & !CELL_OCCUPIED) as usize;
            if shift == 3 {
                self.validate_brick(grid, child * 2)?;
                continue;
            }
            if child * 64 + 64 > self.cells.len() {
                return Err("a node lies outside".into());
            }
            self.validate_cells(grid, child * 64, child * 64 + 64, shift - 2, cells_left)?;
        }
        Ok(())
    }

    fn validate_brick(&self, grid: &PackedGrid, record: usize) -> Result<(), String> {
        let header = *self.bricks.get(record).ok_or("a brick lies outside")?;
        let blocks = (header & 0xff).count_ones() as usize;
        let words = self.bricks.get(record + 1..record + 2 + 2 * blocks).ok_or("a brick is cut off")?;
        let voxels = words[1..].iter().map(|word| u64::from(word.count_ones())).sum::<u64>();
        let index_bits = header >> HEADER_INDEX_BITS & 0xff;
        let palette = u64::from(header >> HEADER_PALETTE);
        let start = u64::from(words[0]) * 32;
        let bits = palette * u64::from(grid.material_bits) + voxels * u64::from(index_bits);
        if index_bits > 16 || start + bits > self.brick_materials.len() as u64 * 32 {
            return Err("the materials of a brick lie outside".into());
        }
        let count = self.materials.len() as u32;
        let first = start + palette * u64::from(grid.material_bits);
        // With a palette every index that its bits can say must name an entry, or be checked; without one it must name a
        // material.
        let largest_index = (0..voxels).map(|voxel| {
            let position = first + voxel * u64::from(index_bits);
            self.read_bits(position, index_bits)
        });
        let limit = if palette == 0 { count } else { palette as u32 };
        let is_safe = palette != 0 && 1 << index_bits <= palette;
        if !is_safe && largest_index.max().is_some_and(|largest| largest >= limit) {
            return Err("a voxel names a material that is missing".into());
        }
        let entry = |index: u64| self.read_bits(start + index * u64::from(grid.material_bits), grid.material_bits);
        if (0..palette).any(|index| entry(index) >= count) {
            return Err("a palette names a material that is missing".into());
        }
        Ok(())
    }
}

/// Depth of a tree whose children come after their parents; `None` for one that is no tree.
fn depth_of(nodes: &[(u32, u32)]) -> Option<u32> {
    let mut depths = vec![0u32; nodes.len()];
    for (index, &(child, is_leaf)) in nodes.iter().enumerate() {
        if is_leaf == 0 {
            let below = depths[index] + 1;
            for child in [index + 1, child as usize] {
                let depth = depths.get_mut(child)?;
                *depth = below.max(*depth);
            }
        }
    }
    Some(depths.into_iter().max().unwrap_or(0))
}
