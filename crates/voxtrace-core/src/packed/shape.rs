//! Points that tell the shape of a scene as it is seen from outside: corners of its voxels where it is small, else of the outermost voxels of
//! each brick, and where it is very large of boxes around bricks or cells of bricks.

use super::{Geometry, PackedScene};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use rustc_hash::FxHashSet;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};

/// Most bricks whose voxels are looked at one by one, over all instances.
const MOST_FOR_VOXELS: u64 = 1 << 12;
/// Most bricks whose outermost voxels are looked at, over all instances.
const MOST_FOR_OUTERMOST: u64 = 1 << 15;
/// Directions in which voxels of a brick are outermost.
const DIRECTIONS: [IVec3; 14] = [
    IVec3::X,
    IVec3::Y,
    IVec3::Z,
    IVec3::NEG_X,
    IVec3::NEG_Y,
    IVec3::NEG_Z,
    IVec3::new(1, 1, 1),
    IVec3::new(-1, 1, 1),
    IVec3::new(1, -1, 1),
    IVec3::new(-1, -1, 1),
    IVec3::new(1, 1, -1),
    IVec3::new(-1, 1, -1),
    IVec3::new(1, -1, -1),
    IVec3::new(-1, -1, -1),
];
/// Most cells over all instances.
const MOST_CELLS: u64 = 1 << 20;

/// What of each brick is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Detail {
    Voxels,
    Outermost,
    Boxes,
}

/// A box of voxels, its upper corner exclusive.
type Cell = (IVec3, IVec3);

impl PackedScene {
    /// World-space points, none where nothing is there. No voxel reaches beyond the smallest box of any direction around them.
    pub(crate) fn shape_points(&self) -> Vec<Vec3> {
        let instances = self.instances();
        let mut shown = vec![0u64; self.grids().len()];
        instances.iter().for_each(|instance| shown[instance.grid as usize] += 1);
        let bricks: Vec<Vec<IVec3>> = (self.grids().iter().zip(&shown))
            .map(|(grid, &times)| if times > 0 { self.geometry().bricks_of(grid) } else { Vec::new() })
            .collect();
        let placed = |counts: &[u64]| counts.iter().zip(&shown).map(|(count, times)| count * times).sum::<u64>();
        let counts: Vec<u64> = bricks.iter().map(|bricks| bricks.len() as u64).collect();
        let detail = match placed(&counts) {
            count if count <= MOST_FOR_VOXELS => Detail::Voxels,
            count if count <= MOST_FOR_OUTERMOST => Detail::Outermost,
            _ => Detail::Boxes,
        };
        let mut cells: Vec<Vec<Cell>> = Vec::new();
        for shift in (0..).step_by(2) {
            cells = (bricks.iter().enumerate()).map(|(grid, bricks)| self.cells(grid, bricks, shift, detail)).collect();
            let counts: Vec<u64> = cells.iter().map(|cells| cells.len() as u64).collect();
            if detail != Detail::Boxes || placed(&counts) <= MOST_CELLS || cells.iter().all(|cells| cells.len() <= 1) {
                break;
            }
        }
        let corners = |instance: &super::PackedInstance| {
            let placed = instance.world_from_grid;
            cells[instance.grid as usize].iter().flat_map(move |&(min, max)| {
                (0..8).map(move |corner| {
                    let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                    placed.point((min + (max - min) * pick).as_vec3())
                })
            })
        };
        instances.par_iter().flat_map_iter(corners).collect()
    }

    /// Boxes around all voxels of a grid: of each brick as `detail` says, or what of the grid is in cells of 2^`shift` bricks.
    fn cells(&self, grid: usize, bricks: &[IVec3], shift: i32, detail: Detail) -> Vec<Cell> {
        let packed = &self.grids()[grid];
        if shift > 0 {
            let cells: FxHashSet<IVec3> = bricks.iter().map(|at| *at >> shift).collect();
            let edge = BRICK_SIZE << shift;
            let cell = |at: IVec3| {
                let low = packed.origin + at * edge;
                (low.max(packed.min), (low + edge).min(packed.max))
            };
            return cells.into_iter().map(cell).collect();
        }
        let of_brick = |at: &IVec3| {
            let corner = packed.origin + *at * BRICK_SIZE;
            let Some(record) = self.geometry().find_brick(packed, corner) else { return Vec::new() };
            let brick = occupancy(self.geometry(), record);
            let (min, max) = brick.extent();
            let is_box = (max - min).element_product() as usize == brick.count();
            if is_box || detail == Detail::Boxes {
                return vec![(corner + min, corner + max)];
            }
            let voxels: Vec<IVec3> = brick.voxels().map(|(local, _)| corner + local).collect();
            let outermost = |direction: &IVec3| voxels.iter().copied().max_by_key(|voxel| voxel.dot(*direction));
            let voxels = match detail {
                Detail::Outermost => DIRECTIONS.iter().filter_map(outermost).collect(),
                _ => voxels,
            };
            voxels.into_iter().map(|voxel| (voxel, voxel + 1)).collect()
        };
        bricks.par_iter().flat_map_iter(of_brick).collect()
    }
}

/// The voxels of the brick with a record at word `record`, all of one material.
fn occupancy(geometry: &Geometry, record: usize) -> Brick {
    let words = geometry.bricks();
    let (mut masks, mut at) = ([0u64; 8], record + 2);
    for (block, mask) in masks.iter_mut().enumerate() {
        if words[record] >> block & 1 != 0 {
            *mask = u64::from(words[at]) | u64::from(words[at + 1]) << 32;
            at += 2;
        }
    }
    let count = masks.iter().map(|mask| mask.count_ones() as usize).sum();
    Brick::new(masks, vec![0; count])
}
