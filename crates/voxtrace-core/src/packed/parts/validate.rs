//! Checks that the parts of a merged grid hold together, as files may say anything.

use super::{Parts, SHARED};
use crate::packed::{Geometry, PackedInstance, Placement};
use glam::IVec3;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::material::MAX_MATERIALS;
use voxtrace_scene::transform::Transform;

/// Farthest voxel of a part: its bricks are whole.
const FAR: i32 = MAX_COORDINATE + BRICK_SIZE;

fn is_near(voxel: IVec3) -> bool {
    voxel.cmple(IVec3::splat(FAR)).all() && voxel.cmpge(IVec3::splat(-FAR)).all()
}

impl Geometry {
    /// Checks the parts of its merged grid, where there is one. All else must be valid.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub(in crate::packed) fn validate_parts(&self, placement: &Placement) -> Result<(), Invalid> {
        let Some(parts) = self.parts.as_deref() else { return Ok(()) };
        let (instances, records) = (&*placement.instances, &*parts.records);
        let shown = instances.iter().filter(|instance| instance.grid == parts.grid).count();
        let first = records.first().and_then(|first| instances.get(first.instance as usize));
        let stands = |first: &PackedInstance| first.grid == parts.grid && first.world_from_grid == Transform::IDENTITY;
        if parts.grid as usize >= self.grids.len() || shown != 1 || !first.is_some_and(stands) {
            return Err("the merged grid is not that of its instance".into());
        }
        let (most_instances, most_grids) = (instances.len() + records.len() - 1, self.grids.len() + records.len() - 1);
        let mut is_taken = vec![false; most_grids];
        for (index, record) in records.iter().enumerate() {
            let is_in_order = index == 0 || records[index - 1].instance < record.instance;
            let is_inside = (record.instance as usize) < most_instances && (record.grid as usize) < most_grids;
            if !is_in_order || !is_inside || std::mem::replace(&mut is_taken[record.grid as usize], true) {
                return Err(format!("part {index} of the merged grid has a number of another").into());
            }
        }
        for (index, covered) in parts.covered.iter().enumerate() {
            let is_inside =
                (covered.part as usize) < records.len() && (covered.material as usize) < self.materials.len();
            if !is_inside || !is_near(covered.voxel) {
                return Err(format!("covered voxel {index} points outside").into());
            }
        }
        if self.materials.len() > MAX_MATERIALS {
            return Err("a merged grid has more materials than its voxels can name".into());
        }
        if parts.runs.windows(2).any(|pair| pair[0].first >= pair[1].first) {
            return Err("the owners of the merged grid's bricks are out of order".into());
        }
        self.validate_owners(parts)
    }

    /// Checks that every brick of the merged grid has its owners.
    fn validate_owners(&self, parts: &Parts) -> Result<(), Invalid> {
        let grid = self.merged_grid(parts);
        let fault = || Invalid::from("a brick of the merged grid has no owner");
        for at in self.bricks_of(grid) {
            let corner = grid.origin + at * BRICK_SIZE;
            let record = self.find_brick(grid, corner).ok_or_else(fault)?;
            let run = parts.runs.partition_point(|run| run.first as usize <= record / 2).checked_sub(1);
            let run = parts.runs[run.ok_or_else(fault)?];
            let owners = [run.owner];
            let owners = if run.owner & SHARED == 0 {
                &owners[..]
            } else {
                let brick = parts.shared_brick((run.owner & !SHARED) as usize).ok_or_else(fault)?;
                let voxels = self.voxels_of_record(record);
                let has_indices = brick.indices.len() as u64 * 32 >= u64::from(voxels) * u64::from(brick.index_bits);
                if run.first as usize != record / 2 || brick.index_bits > 9 || !has_indices {
                    return Err(fault());
                }
                if (0..voxels).any(|rank| parts.owner(record, rank).is_none()) {
                    return Err(fault());
                }
                brick.parts
            };
            for &owner in owners {
                let lattice = parts.lattices.get(owner as usize).ok_or_else(fault)?;
                if ![corner, corner + (BRICK_SIZE - 1)]
                    .map(|voxel| is_near(lattice.voxel_before(voxel)))
                    .iter()
                    .all(|&near| near)
                {
                    return Err("a voxel of the merged grid is too far away in its part".into());
                }
            }
        }
        Ok(())
    }

    /// Voxels of the brick whose record is at a position.
    fn voxels_of_record(&self, record: usize) -> u32 {
        let blocks = (self.bricks[record] & 0xff).count_ones() as usize;
        self.bricks[record + 2..record + 2 + 2 * blocks].iter().map(|mask| mask.count_ones()).sum()
    }
}
