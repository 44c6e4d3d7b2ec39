//! Small grids for tests: noise, hollow spheres, sparse dust in a huge space.

use crate::random::Random;
use voxtrace::VoxelGrid;
use voxtrace::glam::{IVec3, Vec3};

/// Random voxels in a box of `size`³ at `corner`, each occupied with probability `density`.
pub fn noise(corner: IVec3, size: i32, density: f32, materials: u16, seed: u64) -> VoxelGrid {
    let mut random = Random(seed);
    let mut grid = VoxelGrid::new();
    for z in 0..size {
        for y in 0..size {
            for x in 0..size {
                if random.unit() < density {
                    grid.set(corner + IVec3::new(x, y, z), random.below(materials.into()) as u16);
                }
            }
        }
    }
    grid
}

/// The voxels that the surface of a sphere passes through: every path of cells that share faces crosses them.
pub fn hollow_sphere(radius: i32) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    let r = radius as f32;
    for z in -radius - 1..=radius {
        for y in -radius - 1..=radius {
            for x in -radius - 1..=radius {
                let low = IVec3::new(x, y, z).as_vec3();
                let nearest = Vec3::ZERO.clamp(low, low + 1.0).length();
                let farthest = low.abs().max((low + 1.0).abs()).length();
                if nearest <= r && r < farthest {
                    grid.set(IVec3::new(x, y, z), 0);
                }
            }
        }
    }
    grid
}

/// Clusters of voxels far apart, so that all levels of the tree are used.
pub fn dust(extent: i32, clumps: usize, seed: u64) -> VoxelGrid {
    let mut random = Random(seed);
    let mut grid = VoxelGrid::new();
    for _ in 0..clumps {
        let center = random.voxel(IVec3::splat(-extent), IVec3::splat(extent));
        for _ in 0..40 {
            grid.set(center + random.voxel(IVec3::splat(-6), IVec3::splat(6)), random.below(500) as u16);
        }
    }
    grid
}
