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
        // Each brick would be one box: too many are not made at all.
        let is_coarse =
            detail == Detail::Boxes && placed(&counts) > MOST_CELLS && counts.iter().any(|&count| count > 1);
        let first = if is_coarse { 2 } else { 0 };
        let mut corners: Vec<Vec<IVec3>> = Vec::new();
        for shift in (first..).step_by(2) {
            corners =
                (bricks.iter().enumerate()).map(|(grid, bricks)| self.corners(grid, bricks, shift, detail)).collect();
            let counts: Vec<u64> = corners.iter().map(|corners| corners.len() as u64 / 8).collect();
            if detail != Detail::Boxes || placed(&counts) <= MOST_CELLS || counts.iter().all(|&count| count <= 1) {
                break;
            }
        }
        let placed = |instance: &super::PackedInstance| {
            let placed = instance.world_from_grid;
            corners[instance.grid as usize].iter().map(move |corner| placed.point(corner.as_vec3()))
        };
        instances.par_iter().flat_map_iter(placed).collect()
    }

    /// Corners of what of a grid is looked at, in its space: of each brick as `detail` says, or of boxes around what is in cells of 2^`shift` bricks.
    fn corners(&self, grid: usize, bricks: &[IVec3], shift: i32, detail: Detail) -> Vec<IVec3> {
        let packed = &self.grids()[grid];
        if shift > 0 {
            let cells: FxHashSet<IVec3> = bricks.iter().map(|at| *at >> shift).collect();
            let edge = BRICK_SIZE << shift;
            let of_cell = |at: IVec3| {
                let low = packed.origin + at * edge;
                corners_of_box(low.max(packed.min), (low + edge).min(packed.max))
            };
            return cells.into_iter().flat_map(of_cell).collect();
        }
        let of_brick = |at: &IVec3| {
            let origin = packed.origin + *at * BRICK_SIZE;
            let Some(record) = self.geometry().find_brick(packed, origin) else { return Vec::new() };
            let brick = occupancy(self.geometry(), record);
            let (min, max) = brick.extent();
            let is_box = (max - min).element_product() as usize == brick.count();
            if is_box || detail == Detail::Boxes {
                return corners_of_box(origin + min, origin + max).to_vec();
            }
            let voxels: Vec<IVec3> = brick.voxels().map(|(local, _)| local).collect();
            let voxels = if detail == Detail::Outermost { outermost(&voxels) } else { voxels };
            corners_of_voxels(&voxels).map(|corner| origin + corner).collect()
        };
        bricks.par_iter().flat_map_iter(of_brick).collect()
    }
}

/// From a low corner and one beyond the highest voxel.
fn corners_of_box(min: IVec3, max: IVec3) -> [IVec3; 8] {
    std::array::from_fn(|corner| min + (max - min) * corner_of_cube(corner))
}

fn corner_of_cube(corner: usize) -> IVec3 {
    IVec3::new((corner & 1) as i32, (corner >> 1 & 1) as i32, (corner >> 2) as i32)
}

/// Those of the voxels of a brick that are the outermost ones in some direction.
fn outermost(voxels: &[IVec3]) -> Vec<IVec3> {
    let mut found = Vec::with_capacity(DIRECTIONS.len());
    for direction in DIRECTIONS {
        let voxel = voxels.iter().copied().max_by_key(|voxel| voxel.dot(direction));
        found.extend(voxel.filter(|voxel| !found.contains(voxel)));
    }
    found
}

/// Corners of voxels of a brick, none twice, given each voxel once. Those between eight voxels are left out: some voxel reaches further in each direction.
fn corners_of_voxels(voxels: &[IVec3]) -> impl Iterator<Item = IVec3> {
    const EDGE: usize = BRICK_SIZE as usize + 1;
    let mut sharing = [0u8; EDGE * EDGE * EDGE];
    for voxel in voxels {
        for corner in 0..8 {
            let at = (*voxel + corner_of_cube(corner)).as_uvec3();
            sharing[at.x as usize + EDGE * (at.y as usize + EDGE * at.z as usize)] += 1;
        }
    }
    let place = |at: usize| IVec3::new((at % EDGE) as i32, (at / EDGE % EDGE) as i32, (at / (EDGE * EDGE)) as i32);
    sharing.into_iter().enumerate().filter(|(_, count)| (1..8).contains(count)).map(move |(at, _)| place(at))
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
