//! The bricks of a packed grid, one after the other, as sets of voxels.

use glam::IVec3;
use voxtrace_core::packed::{CELL_OCCUPIED, Geometry, PackedGrid};

/// One brick of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BrickAt {
    /// Its lowest voxel, counted from the grid's origin.
    pub low: IVec3,
    /// Word position of its record.
    pub record: usize,
}

/// Calls `found` for every brick of a grid.
pub fn for_each_brick(geometry: &Geometry, grid: &PackedGrid, found: &mut impl FnMut(BrickAt)) {
    let size = grid.top_size;
    let mut index = grid.top_offset as usize;
    for z in 0..size.z {
        for y in 0..size.y {
            for x in 0..size.x {
                let low = IVec3::new(x, y, z) << grid.top_shift as i32;
                below(geometry, geometry.cells()[index], low, grid.top_shift, found);
                index += 1;
            }
        }
    }
}

fn below(geometry: &Geometry, cell: u32, low: IVec3, shift: u32, found: &mut impl FnMut(BrickAt)) {
    if cell & CELL_OCCUPIED == 0 {
        return;
    }
    let child = (cell & !CELL_OCCUPIED) as usize;
    if shift == 3 {
        found(BrickAt { low, record: child * 2 });
        return;
    }
    for (index, &cell) in geometry.cells()[child * 64..child * 64 + 64].iter().enumerate() {
        let index = index as i32;
        let offset = IVec3::new(index & 3, index >> 2 & 3, index >> 4) << (shift as i32 - 2);
        below(geometry, cell, low + offset, shift - 2, found);
    }
}

/// The voxels of a brick: bit x of `rows[z][y]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Occupancy {
    pub rows: [[u8; 8]; 8],
}

impl Occupancy {
    /// The voxels of the brick with a record at word `record`.
    pub fn of(geometry: &Geometry, record: usize) -> Self {
        let bricks = geometry.bricks();
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
        (0..64).flat_map(move |row| {
            let (y, z) = (row & 7, row >> 3);
            let mut bits = self.rows[z as usize][y as usize];
            std::iter::from_fn(move || {
                let x = bits.trailing_zeros();
                bits &= bits.wrapping_sub(1);
                (x < 8).then_some(IVec3::new(x as i32, y, z))
            })
        })
    }

    /// The lowest occupied coordinates, and one past the highest.
    pub fn bounds(&self) -> (IVec3, IVec3) {
        let (mut along_x, mut along_y, mut along_z) = (0u8, 0u8, 0u8);
        for (z, layer) in self.rows.iter().enumerate() {
            for (y, &row) in layer.iter().enumerate() {
                along_x |= row;
                along_y |= u8::from(row != 0) << y;
                along_z |= u8::from(row != 0) << z;
            }
        }
        let all = [along_x, along_y, along_z];
        let low = all.map(|bits| bits.trailing_zeros() as i32);
        (IVec3::from_array(low), IVec3::from_array(all.map(|bits| 8 - bits.leading_zeros() as i32)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_those_of_the_voxels() {
        let mut state = 1u32;
        for _ in 0..1000 {
            let mut occupancy = Occupancy::default();
            for _ in 0..3 {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let (x, y, z) = (state >> 29, state >> 26 & 7, state >> 23 & 7);
                occupancy.rows[z as usize][y as usize] |= 1 << x;
            }
            let voxels: Vec<IVec3> = occupancy.voxels().collect();
            assert!(voxels.iter().all(|&voxel| occupancy.has(voxel)));
            let low = voxels.iter().fold(IVec3::splat(8), |low, &voxel| low.min(voxel));
            let high = voxels.iter().fold(IVec3::ZERO, |high, &voxel| high.max(voxel + 1));
            assert_eq!(occupancy.bounds(), (low, high));
            let bits: u32 = occupancy.rows.iter().flatten().map(|row| row.count_ones()).sum();
            assert_eq!(voxels.len() as u32, bits);
        }
    }
}
