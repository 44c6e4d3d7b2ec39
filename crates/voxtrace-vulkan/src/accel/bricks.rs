//! The bricks of a packed grid, one after the other, as sets of voxels.

use voxtrace::PackedScene;
use voxtrace::glam::IVec3;
use voxtrace::packed::{CELL_OCCUPIED, PackedGrid};

/// One brick of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BrickAt {
    /// Its lowest voxel, counted from the grid's origin.
    pub low: IVec3,
    /// Word position of its record.
    pub record: usize,
}

/// Calls `found` for every brick of a grid.
pub fn for_each_brick(scene: &PackedScene, grid: &PackedGrid, found: &mut impl FnMut(BrickAt)) {
    let size = grid.top_size;
    let mut index = grid.top_offset as usize;
    for z in 0..size.z {
        for y in 0..size.y {
            for x in 0..size.x {
                let low = IVec3::new(x, y, z) << grid.top_shift as i32;
                below(scene, scene.cells()[index], low, grid.top_shift, found);
                index += 1;
            }
        }
    }
}

fn below(scene: &PackedScene, cell: u32, low: IVec3, shift: u32, found: &mut impl FnMut(BrickAt)) {
    if cell & CELL_OCCUPIED == 0 {
        return;
    }
    let child = (cell & !CELL_OCCUPIED) as usize;
    if shift == 3 {
        found(BrickAt { low, record: child * 2 });
        return;
    }
    for (index, &cell) in scene.cells()[child * 64..child * 64 + 64].iter().enumerate() {
        let index = index as i32;
        let offset = IVec3::new(index & 3, index >> 2 & 3, index >> 4) << (shift as i32 - 2);
        below(scene, cell, low + offset, shift - 2, found);
    }
}

/// The voxels of a brick: bit x of `rows[z][y]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Occupancy {
    pub rows: [[u8; 8]; 8],
}

impl Occupancy {
    /// The voxels of the brick with a record at word `record`.
    pub fn of(scene: &PackedScene, record: usize) -> Self {
        let bricks = scene.bricks();
        let header = bricks[record];
        let mut occupancy = Self::default();
        let mut at = record + 2;
        for block in (0..8).filter(|block| header >> block & 1 != 0) {
            let mask = u64::from(bricks[at]) | u64::from(bricks[at + 1]) << 32;
            at += 2;
            let (x, y, z) = ((block & 1) * 4, (block >> 1 & 1) * 4, (block >> 2) * 4);
            for row in 0..16 {
                let bits = (mask >> (4 * row) & 0xf) as u8;
                occupancy.rows[z + row / 4][y + row % 4] |= bits << x;
            }
        }
        occupancy
    }

    /// Whether a voxel, each coordinate in 0..8, is occupied.
    pub fn has(&self, voxel: IVec3) -> bool {
        self.rows[voxel.z as usize][voxel.y as usize] >> voxel.x & 1 != 0
    }

    /// The occupied voxels.
    pub fn voxels(&self) -> impl Iterator<Item = IVec3> + '_ {
        (0..512).map(|i| IVec3::new(i & 7, i >> 3 & 7, i >> 6)).filter(|&voxel| self.has(voxel))
    }

    /// The lowest occupied coordinates, and one past the highest.
    pub fn bounds(&self) -> (IVec3, IVec3) {
        self.voxels().fold((IVec3::splat(8), IVec3::ZERO), |(low, high), voxel| (low.min(voxel), high.max(voxel + 1)))
    }
}
