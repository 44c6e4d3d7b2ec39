//! One grid of the voxels of several, in the space of the world, and whose each of them is.

use super::choose::Candidate;
use super::lattice::Lattice;
use super::scatter::Scatter;
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, bits, voxel_of};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::scene::{Instance, Scene};

/// Whose the voxels of a brick are, by the index of the part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Owner {
    /// All of one.
    One(u32),
    /// Each of its own, in rank order.
    Shared(Vec<u32>),
}

/// A voxel of a part where one of an earlier part is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Covered {
    pub part: u32,
    /// In the part's own grid.
    pub voxel: IVec3,
    pub material: u16,
}

/// The grid of several parts.
pub struct Joined {
    pub grid: VoxelGrid,
    pub owners: Vec<(IVec3, Owner)>,
    /// Ordered by part, then by z, y and x.
    pub covered: Vec<Covered>,
}

/// A brick of a part where it lies in the world.
fn bricks_in_world(grid: &VoxelGrid, way: &Lattice) -> Vec<(IVec3, Brick)> {
    let bricks = grid.sorted_bricks();
    if let Some(moved) = way.moved_bricks() {
        return bricks.into_iter().map(|(at, brick)| (at + moved, brick.clone())).collect();
    }
    let mut scatter = Scatter::default();
    for (at, brick) in bricks {
        let corner = at * BRICK_SIZE;
        brick.voxels().for_each(|(local, material)| scatter.set(way.voxel(corner + local), material));
    }
    scatter.finish()
}

/// Puts the candidates into one grid. Where several have a voxel, the first of them keeps it.
pub fn join(scene: &Scene, visible: &[(usize, &Instance)], candidates: &[Candidate]) -> Joined {
    let of_parts: Vec<Vec<(IVec3, Brick)>> = (candidates.par_iter())
        .map(|part| bricks_in_world(&scene.grids[visible[part.instance].1.grid], &part.world_from_part))
        .collect();
    let mut places: FxHashMap<IVec3, Vec<(u32, Brick)>> = FxHashMap::default();
    for (part, bricks) in of_parts.into_iter().enumerate() {
        for (at, brick) in bricks {
            places.entry(at).or_default().push((part as u32, brick));
        }
    }
    let mut places: Vec<_> = places.into_iter().collect();
    places.par_sort_unstable_by_key(|(at, _)| (at.z, at.y, at.x));
    let bricks: Vec<_> = places.into_par_iter().map(|(at, layers)| (at, overlay(at, layers, candidates))).collect();
    let (mut grid, mut owners, mut covered) = (Vec::new(), Vec::new(), Vec::new());
    for (at, laid) in bricks {
        grid.push((at, laid.brick));
        owners.push((at, laid.owner));
        covered.extend(laid.covered);
    }
    let order = |covered: &Covered| (covered.part, covered.voxel.z, covered.voxel.y, covered.voxel.x);
    covered.par_sort_unstable_by_key(order);
    Joined { grid: VoxelGrid::from_bricks(grid), owners, covered }
}

struct Laid {
    brick: Brick,
    owner: Owner,
    covered: Vec<Covered>,
}

/// The brick of several parts at one place, which come in their order.
fn overlay(at: IVec3, mut layers: Vec<(u32, Brick)>, candidates: &[Candidate]) -> Laid {
    if let [_] = layers[..] {
        let (part, brick) = layers.swap_remove(0);
        return Laid { brick, owner: Owner::One(part), covered: Vec::new() };
    }
    let (mut occupancy, mut whose, mut materials) = ([0u64; 8], [0u32; 512], [0u16; 512]);
    let mut covered = Vec::new();
    for (part, brick) in &layers {
        let before = occupancy;
        for (rank, place) in places_of(brick.occupancy()).enumerate() {
            let (block, bit) = (place / 64, place % 64);
            let material = brick.materials()[rank];
            if before[block] >> bit & 1 == 0 {
                occupancy[block] |= 1 << bit;
                (whose[place], materials[place]) = (*part, material);
            } else {
                let voxel = at * BRICK_SIZE + voxel_of(block, bit as u32);
                let voxel = candidates[*part as usize].world_from_part.voxel_before(voxel);
                covered.push(Covered { part: *part, voxel, material });
            }
        }
    }
    let whose: Vec<u32> = places_of(&occupancy).map(|place| whose[place]).collect();
    let materials = places_of(&occupancy).map(|place| materials[place]).collect();
    let is_of_one = whose.iter().all(|part| *part == whose[0]);
    let owner = if is_of_one { Owner::One(whose[0]) } else { Owner::Shared(whose) };
    Laid { brick: Brick::new(occupancy, materials), owner, covered }
}

/// Places of the voxels, block × 64 + bit, in rank order.
fn places_of(occupancy: &[u64; 8]) -> impl Iterator<Item = usize> + '_ {
    (0..8).flat_map(|block| bits(occupancy[block]).map(move |bit| block * 64 + bit as usize))
}
