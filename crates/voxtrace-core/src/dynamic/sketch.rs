//! Voxels that are read and written one by one: the bricks that are met are decoded once, those that are written encoded at the end.

use super::DynamicScene;
use super::plan::{Change, code_of};
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, block_bit, block_index};
use voxtrace_scene::grid::{brick_of, local_of};

/// A voxel without material.
const EMPTY: u32 = u32::MAX;

/// A brick with a place for every voxel.
struct Dense {
    materials: Box<[u32; 512]>,
    is_written: bool,
}

fn index(voxel: IVec3) -> usize {
    let local = local_of(voxel);
    block_index(local) * 64 + block_bit(local) as usize
}

impl Dense {
    fn of(brick: &Brick) -> Self {
        let mut materials = Box::new([EMPTY; 512]);
        brick.voxels().for_each(|(local, material)| materials[index(local)] = material.into());
        Self { materials, is_written: false }
    }

    fn brick(&self) -> Brick {
        let (mut occupancy, mut materials) = ([0u64; 8], Vec::new());
        for (at, &material) in self.materials.iter().enumerate().filter(|(_, material)| **material != EMPTY) {
            occupancy[at / 64] |= 1 << (at % 64);
            materials.push(material as u16);
        }
        Brick::new(occupancy, materials)
    }
}

/// The voxels of a grid as an edit makes them.
pub(super) struct Sketch<'a> {
    scene: &'a DynamicScene,
    grid: u32,
    bricks: FxHashMap<IVec3, Dense>,
}

impl<'a> Sketch<'a> {
    pub fn new(scene: &'a DynamicScene, grid: u32) -> Self {
        Self { scene, grid, bricks: FxHashMap::default() }
    }

    fn brick(&mut self, voxel: IVec3) -> &mut Dense {
        let (geometry, grid) = (self.scene.geometry(), &self.scene.geometry().grids[self.grid as usize]);
        self.bricks.entry(brick_of(voxel)).or_insert_with(|| {
            let record = geometry.find_brick(grid, brick_of(voxel) * BRICK_SIZE);
            Dense::of(&record.map(|record| geometry.decode_brick(grid, record)).unwrap_or_default())
        })
    }

    /// The material of a voxel, as it is by now.
    pub fn get(&mut self, voxel: IVec3) -> Option<u16> {
        let material = self.brick(voxel).materials[index(voxel)];
        (material != EMPTY).then_some(material as u16)
    }

    pub fn set(&mut self, voxel: IVec3, material: Option<u16>) {
        let brick = self.brick(voxel);
        brick.materials[index(voxel)] = material.map_or(EMPTY, u32::from);
        brick.is_written = true;
    }

    /// The bricks that became others.
    pub fn changes(self) -> Vec<Change> {
        let (geometry, grid) = (self.scene.geometry(), &self.scene.geometry().grids[self.grid as usize]);
        let mut written: Vec<(IVec3, Dense)> = self.bricks.into_iter().filter(|(_, brick)| brick.is_written).collect();
        written.sort_unstable_by_key(|(at, _)| (at.z, at.y, at.x));
        let change = |(at, dense): &(IVec3, Dense)| {
            let record = geometry.find_brick(grid, *at * BRICK_SIZE);
            let was = record.map(|record| geometry.decode_brick(grid, record)).unwrap_or_default();
            let now = dense.brick();
            (now != was).then(|| (*at, code_of(&now, grid.material_bits)))
        };
        written.par_iter().filter_map(change).collect()
    }
}
