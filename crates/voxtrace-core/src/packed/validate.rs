//! Checks that a packed scene holds together: every index lies inside its array and every tree ends. Tracing a valid
//! scene cannot read out of bounds.

use super::coverage::coverage_words;
use super::extent::{Extent, position};
use super::instances::{MAX_INSTANCE_DEPTH, corners_of};
use super::lights::{finds_root, validate_lights};
use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE};
use super::normals::normal_words;
use super::{CELL_OCCUPIED, Geometry, LightNode, PackedGrid, PackedInstance, Placement};
use glam::{IVec3, Vec3};
use std::ops::Range;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::transform::Transform;

/// Voxels that the cells of a grid may cover along an axis: a grid from one end of the coordinates to the other, and less than
/// one more of the largest cells. What devices keep 21 bits of, places of bricks, and 32-bit planes then suffice for all cells.
const MAX_REACH: i64 = 1 << 22;

/// Cells of one level side by side: a top array or a node.
struct Cells {
    /// Where they are in [`Geometry::cells`].
    range: Range<usize>,
    /// How many there are along each axis.
    size: IVec3,
    /// Place of the first, in cells from the grid's origin.
    first: IVec3,
    /// log₂ of the voxels along an edge of one.
    shift: u32,
}

impl Cells {
    /// Those of a node.
    fn of_node(node: usize, first: IVec3, shift: u32) -> Self {
        Self { range: node * 64..node * 64 + 64, size: IVec3::splat(4), first, shift }
    }
}

impl Placement {
    /// Checks that it holds together and suits a valid geometry.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self, geometry: &Geometry) -> Result<(), Invalid> {
        self.check_geometry(geometry).map_err(|error| error.to_string())?;
        self.validate_instances(geometry)?;
        self.validate_lights(geometry)
    }

    /// Checks the instances and the hierarchy over them.
    pub(super) fn validate_instances(&self, geometry: &Geometry) -> Result<(), Invalid> {
        validate_each(&self.instances, geometry.grids.len())?;
        self.validate_instance_nodes(geometry)
    }

    fn validate_instance_nodes(&self, geometry: &Geometry) -> Result<(), Invalid> {
        let nodes = &*self.instance_nodes;
        let mut is_in_leaf = vec![false; self.instances.len()];
        // How many inner nodes lie above each node that a parent was found for; parents come before their children.
        let mut depths: Vec<Option<usize>> = vec![None; nodes.len()];
        if let Some(root) = depths.first_mut() {
            *root = Some(0);
        }
        for (index, node) in nodes.iter().enumerate() {
            let child = node.index as usize;
            // The left child follows its parent, the right one comes later: the tree has no cycle.
            let is_sound = match node.is_leaf {
                0 => child > index + 1 && child < nodes.len(),
                1 => child < self.instances.len(),
                _ => false,
            };
            if !is_sound {
                return Err(format!("node {index} of the tree over instances points outside").into());
            }
            let depth =
                depths[index].ok_or_else(|| format!("node {index} of the tree over instances has no parent"))?;
            let is_around = |min: Vec3, max: Vec3| node.min.cmple(min).all() && node.max.cmpge(max).all();
            let too_small = || format!("node {index} of the tree over instances is too small for what it holds");
            if node.is_leaf == 1 {
                is_in_leaf[child] = true;
                let instance = &self.instances[child];
                let grid = &geometry.grids[instance.grid as usize];
                let (min, max) = corners_of(instance, grid.min, grid.max);
                if !is_around(min, max) {
                    return Err(too_small().into());
                }
                continue;
            }
            if [index + 1, child].iter().any(|&child| !is_around(nodes[child].min, nodes[child].max)) {
                return Err(too_small().into());
            }
            if depth == MAX_INSTANCE_DEPTH {
                return Err(format!("the tree over instances is more than {MAX_INSTANCE_DEPTH} levels deep").into());
            }
            for child in [index + 1, child] {
                // What is shared would be visited once for each way to it, and there may be 2³² of them.
                if depths[child].replace(depth + 1).is_some() {
                    return Err(format!("node {child} of the tree over instances has two parents").into());
                }
            }
        }
        // Devices start at the root wherever there is an instance.
        match is_in_leaf.iter().position(|&is_in_leaf| !is_in_leaf) {
            Some(instance) => Err(format!("instance {instance} is in no leaf of the tree over instances").into()),
            None => Ok(()),
        }
    }

    /// Checks the tree over the instances that emit.
    fn validate_lights(&self, geometry: &Geometry) -> Result<(), Invalid> {
        let (nodes, instances) = (&*self.light_nodes, &*self.instances);
        for (at, node) in nodes.iter().enumerate() {
            let is_sound = match node.count {
                // The left child follows its parent, the right one comes later: the tree has no cycle.
                0 => node.index as usize > at + 1 && (node.index as usize) < nodes.len(),
                1 => instances.get(node.index as usize).is_some_and(|instance| {
                    instance.light_leaf as usize == at && geometry.light_root(instance.grid) == Some(node.root)
                }),
                _ => false,
            };
            if !is_sound || !finds_root(nodes, at) || (at > 0) != (node.parent != LightNode::NONE) {
                return Err(format!("node {at} of the tree over instances that emit points outside").into());
            }
        }
        for (index, instance) in instances.iter().enumerate() {
            let leaf = nodes.get(instance.light_leaf as usize);
            let is_sound = match leaf {
                Some(leaf) => (leaf.count, leaf.index as usize) == (1, index),
                None => instance.light_leaf == LightNode::NONE && geometry.light_root(instance.grid).is_none(),
            };
            if !is_sound {
                return Err(format!("instance {index} is not in the tree over instances that emit").into());
            }
        }
        Ok(())
    }
}

/// Checks instances of so many grids, each for itself.
pub(super) fn validate_each(instances: &[PackedInstance], grids: usize) -> Result<(), Invalid> {
    for (index, instance) in instances.iter().enumerate() {
        if instance.grid as usize >= grids {
            return Err(format!("instance {index} shows grid {}, which is missing", instance.grid).into());
        }
        if !instance.world_from_grid.is_similarity() || !instance.grid_from_world.is_similarity() {
            return Err(format!("instance {index} has a transform that is no similarity").into());
        }
        if !is_inverse(&instance.grid_from_world, &instance.world_from_grid) {
            return Err(format!("the two transforms of instance {index} are not each other's inverse").into());
        }
    }
    Ok(())
}

/// Whether one transform undoes the other, but for rounding: it is some builds' own.
fn is_inverse(transform: &Transform, of: &Transform) -> bool {
    let exact = of.inverse();
    let tolerance = 1e-3 * exact.scale();
    transform.linear.abs_diff_eq(exact.linear, tolerance)
        && transform.translation.distance(exact.translation) <= 1e-3 * exact.translation.length() + tolerance
}

impl Geometry {
    /// Checks the whole geometry.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        self.validate_grids()?;
        self.validate_lights()
    }

    /// Checks the emitters and the trees over them, for grids that are valid.
    pub(super) fn validate_lights(&self) -> Result<(), Invalid> {
        validate_lights(self)
    }

    /// Checks the grids with their bricks.
    pub(crate) fn validate_grids(&self) -> Result<(), Invalid> {
        let mut cells_left = self.cells.len();
        for (index, grid) in self.grids.iter().enumerate() {
            self.validate_grid(grid, &mut cells_left)
                .map_err(|fault| Invalid::from(format!("grid {index}: {fault}")))?;
        }
        Ok(())
    }

    fn validate_grid(&self, grid: &PackedGrid, cells_left: &mut usize) -> Result<(), Invalid> {
        let far = IVec3::splat(MAX_COORDINATE + 8);
        // The smallest number has no absolute value.
        let is_near = |point: IVec3| point.cmple(far).all() && point.cmpge(-far).all();
        let is_shift = (3..=21).contains(&grid.top_shift) && grid.top_shift % 2 == 1;
        // Top arrays that grow do so by whole cells.
        let overhang = if self.is_edited { 1 << grid.top_shift.min(21) } else { 0 };
        let is_origin_near = grid.origin.cmple(far).all() && grid.origin.cmpge(-far - overhang).all();
        if !is_origin_near || !is_near(grid.min) || !is_near(grid.max) || grid.origin & 7 != IVec3::ZERO {
            return Err("coordinates out of range".into());
        }
        if !is_shift || grid.material_bits != 8 && grid.material_bits != 16 || grid.top_size.min_element() < 1 {
            return Err("impossible shape".into());
        }
        let reach = grid.top_size.as_i64vec3() << i64::from(grid.top_shift);
        if reach.max_element() > MAX_REACH {
            return Err("its cells reach too far".into());
        }
        let is_covered = (grid.max - grid.origin).as_i64vec3().cmple(reach).all();
        if !is_covered || grid.min.cmplt(grid.origin).any() || grid.min.cmpge(grid.max).any() {
            return Err("the bounds are not those of its cells".into());
        }
        let top_cells = grid.top_size.to_array().iter().try_fold(1usize, |cells, &n| cells.checked_mul(n as usize));
        let start = grid.top_offset as usize;
        let end = top_cells.and_then(|cells| start.checked_add(cells));
        let end = end.filter(|&end| end <= self.cells.len()).ok_or("cells are missing")?;
        let mut extent = Extent::empty();
        let top = Cells { range: start..end, size: grid.top_size, first: IVec3::ZERO, shift: grid.top_shift };
        if grid.top_shift == 3 {
            *cells_left = cells_left.checked_sub(top.range.len()).ok_or("cells are shared")?;
            self.validate_bricks(grid, &top, &mut extent)?;
        } else {
            let mut finest = Vec::new();
            self.collect_finest(top, cells_left, &mut finest)?;
            // As they lie in the file, and so do their bricks: what is larger than memory is then read once.
            finest.sort_unstable_by_key(|&(node, _)| node);
            for (node, first) in finest {
                self.validate_bricks(grid, &Cells::of_node(node as usize, first, 3), &mut extent)?;
            }
        }
        extent.check(grid, self.is_edited)
    }

    /// Finds the nodes whose cells are bricks below others, with the places of their first cells.
    fn collect_finest(
        &self,
        Cells { range, size, first, shift }: Cells,
        cells_left: &mut usize,
        finest: &mut Vec<(u32, IVec3)>,
    ) -> Result<(), Invalid> {
        // Each cell belongs to one grid and one node: visiting more than there are means that some are shared, and sharing
        // could make the visit endless.
        let take = |cells_left: &mut usize, count| {
            *cells_left = cells_left.checked_sub(count).ok_or("cells are shared")?;
            Ok::<(), Invalid>(())
        };
        take(cells_left, range.len())?;
        let cells = self.cells[range].iter().enumerate();
        for (index, &cell) in cells.filter(|(_, cell)| *cell & CELL_OCCUPIED != 0) {
            let child = cell & !CELL_OCCUPIED;
            if child as usize * 64 + 64 > self.cells.len() {
                return Err("a node lies outside".into());
            }
            let first = (first + position(size, index)) * 4;
            if shift == 5 {
                take(cells_left, 64)?;
                finest.push((child, first));
            } else {
                self.collect_finest(Cells::of_node(child as usize, first, shift - 2), cells_left, finest)?;
            }
        }
        Ok(())
    }

    /// Checks the bricks of some cells.
    fn validate_bricks(&self, grid: &PackedGrid, cells: &Cells, extent: &mut Extent) -> Result<(), Invalid> {
        let occupied = self.cells[cells.range.clone()].iter().enumerate();
        for (index, &cell) in occupied.filter(|(_, cell)| *cell & CELL_OCCUPIED != 0) {
            let corner = grid.origin + (cells.first + position(cells.size, index)) * BRICK_SIZE;
            self.validate_brick(grid, (cell & !CELL_OCCUPIED) as usize * 2, corner, extent)?;
        }
        Ok(())
    }

    fn validate_brick(
        &self,
        grid: &PackedGrid,
        record: usize,
        corner: IVec3,
        extent: &mut Extent,
    ) -> Result<(), Invalid> {
        let header = *self.bricks.get(record).ok_or("a brick lies outside")?;
        let blocks = (header & 0xff).count_ones() as usize;
        let words = self.bricks.get(record + 1..record + 2 + 2 * blocks).ok_or("a brick is cut off")?;
        let voxels = extent.add(corner, header & 0xff, &words[1..])?;
        let index_bits = header >> HEADER_INDEX_BITS & 0xff;
        let palette = u64::from(header >> HEADER_PALETTE);
        let start = u64::from(words[0]) * 32;
        let bits = palette * u64::from(grid.material_bits) + voxels * u64::from(index_bits);
        if index_bits > 16 || start + bits > self.brick_materials.len() as u64 * 32 {
            return Err("the materials of a brick lie outside".into());
        }
        if self.has_normals && (words[0] as usize) < normal_words(voxels as u32) {
            return Err("the normals of a brick lie outside".into());
        }
        if self.has_coverage && (self.has_normals || (words[0] as usize) < coverage_words(voxels as u32)) {
            return Err("the coverage of a brick lies outside".into());
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
