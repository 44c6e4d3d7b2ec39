//! The table of the parts of a grid that was merged and packed.

use super::{CoveredVoxel, OwnerRun, PartRecord, Parts, SHARED};
use crate::packed::brick_record::BitWriter;
use crate::packed::merge::{Candidate, Merge, Owner};
use crate::packed::{Geometry, Section};
use glam::IVec3;
use std::sync::Arc;
use voxtrace_scene::brick::BRICK_SIZE;

impl Parts {
    /// The parts of grid `grid` of a geometry. `visible` says of each visible instance its index in the scene and that of its grid.
    pub(in crate::packed) fn of_merge(
        geometry: &Geometry,
        grid: u32,
        merge: &Merge,
        visible: &[(usize, usize)],
    ) -> Self {
        let mut used: Vec<usize> = visible.iter().map(|(_, grid)| *grid).collect();
        used.sort_unstable();
        used.dedup();
        let record = |part: &Candidate| {
            let (scene_instance, scene_grid) = visible[part.instance];
            let (axes, translation) = part.world_from_part.to_record();
            let grid = used.binary_search(&scene_grid).expect("used holds every visible grid") as u32;
            PartRecord {
                instance: part.instance as u32,
                grid,
                scene_instance: scene_instance as u32,
                axes,
                translation,
            }
        };
        let records: Vec<PartRecord> = merge.candidates.iter().map(record).collect();
        let covered: Vec<CoveredVoxel> = (merge.joined.covered.iter())
            .map(|of| CoveredVoxel { part: of.part, voxel: of.voxel, material: of.material.into() })
            .collect();
        let scene_grids: Arc<[u32]> = used.iter().map(|&grid| grid as u32).collect();
        let owners = owners_of(geometry, grid, merge);
        Self::new(grid, records.into(), owners, covered.into(), scene_grids).expect("candidates stand on the lattice")
    }
}

/// The runs of owners and what is said of shared bricks.
fn owners_of(geometry: &Geometry, grid: u32, merge: &Merge) -> (Section<OwnerRun>, Section<u32>) {
    let packed = &geometry.grids[grid as usize];
    let place = |at: IVec3| geometry.find_brick(packed, at * BRICK_SIZE).expect("every brick was packed") as u32 / 2;
    let mut ordered: Vec<(u32, &Owner)> = merge.joined.owners.iter().map(|(at, owner)| (place(*at), owner)).collect();
    ordered.sort_unstable_by_key(|(first, _)| *first);
    let (mut runs, mut shared): (Vec<OwnerRun>, Vec<u32>) = (Vec::new(), Vec::new());
    for (first, owner) in ordered {
        let owner = match owner {
            Owner::One(part) => *part,
            Owner::Shared(whose) => {
                let at = shared.len() as u32;
                say_whose(whose, &mut shared);
                at | SHARED
            }
        };
        if runs.last().is_none_or(|run| run.owner != owner) {
            runs.push(OwnerRun { first, owner });
        }
    }
    (runs.into(), shared.into())
}

fn say_whose(whose: &[u32], shared: &mut Vec<u32>) {
    let mut parts = whose.to_vec();
    parts.sort_unstable();
    parts.dedup();
    let index_bits = u32::BITS - (parts.len() as u32 - 1).leading_zeros();
    shared.push(parts.len() as u32);
    shared.extend_from_slice(&parts);
    let mut bits = BitWriter::new(shared);
    for part in whose {
        bits.push(parts.binary_search(part).expect("all parts are there") as u32, index_bits);
    }
    bits.flush();
}
