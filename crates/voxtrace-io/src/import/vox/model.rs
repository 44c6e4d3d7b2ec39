//! Voxel lists to grids. The voxels of a model (at most 256³) are sorted into bricks by counting, and each brick is built
//! whole: no voxel costs a look-up in a hash table.

use glam::IVec3;
use voxtrace_scene::brick::{Brick, bits, block_bit, block_index};
use voxtrace_scene::grid::VoxelGrid;

/// Bricks along one edge of the largest model.
const EDGE: usize = 32;
/// Models with fewer voxels than this are set voxel by voxel: counting would cost more than it saves.
const SMALL: usize = 1024;

/// The grid of a model's voxels: x, y, z and colour index. Index 0 is empty, index i is material i − 1; where a voxel is
/// named twice, the last one holds.
pub fn grid_of(voxels: &[[u8; 4]]) -> VoxelGrid {
    if voxels.len() < SMALL { grid_by_voxel(voxels) } else { grid_by_brick(voxels) }
}

/// Index of the first voxel that lies outside the size.
pub fn first_outside(size: [u32; 3], voxels: &[[u8; 4]]) -> Option<usize> {
    voxels.iter().position(|voxel| (0..3).any(|axis| u32::from(voxel[axis]) >= size[axis]))
}

fn position(voxel: &[u8; 4]) -> IVec3 {
    IVec3::new(voxel[0].into(), voxel[1].into(), voxel[2].into())
}

fn grid_by_voxel(voxels: &[[u8; 4]]) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for voxel in voxels {
        match voxel[3].checked_sub(1) {
            Some(material) => grid.set(position(voxel), material.into()),
            None => grid.clear(position(voxel)),
        };
    }
    grid
}

fn brick_index(voxel: &[u8; 4]) -> usize {
    let [x, y, z, _] = voxel.map(|byte| usize::from(byte >> 3));
    (z * EDGE + y) * EDGE + x
}

fn grid_by_brick(voxels: &[[u8; 4]]) -> VoxelGrid {
    // ends[i] becomes the end of brick i's run in `sorted`; filling from the back keeps the order of the file.
    let mut ends = vec![0u32; EDGE * EDGE * EDGE + 1];
    for voxel in voxels {
        ends[brick_index(voxel)] += 1;
    }
    let mut sum = 0;
    for end in &mut ends {
        sum += *end;
        *end = sum;
    }
    let mut sorted = vec![[0u8; 4]; voxels.len()];
    for voxel in voxels.iter().rev() {
        let slot = &mut ends[brick_index(voxel)];
        *slot -= 1;
        sorted[*slot as usize] = *voxel;
    }
    // Now ends[i] is the start of run i, and the end of run i is the start of run i + 1.
    let runs = ends.windows(2).map(|run| &sorted[run[0] as usize..run[1] as usize]);
    VoxelGrid::from_bricks(runs.filter_map(|run| Some((position(run.first()?) >> 3, brick_of_run(run)))))
}

fn brick_of_run(run: &[[u8; 4]]) -> Brick {
    let (mut occupancy, mut colors) = ([0u64; 8], [[0u8; 64]; 8]);
    for voxel in run {
        let local = position(voxel) & 7;
        let (block, bit) = (block_index(local), block_bit(local));
        let occupied = u64::from(voxel[3] != 0);
        occupancy[block] = occupancy[block] & !(1 << bit) | occupied << bit;
        colors[block][bit as usize] = voxel[3];
    }
    let mut materials = Vec::with_capacity(occupancy.iter().map(|mask| mask.count_ones() as usize).sum());
    for (mask, colors) in occupancy.iter().zip(&colors) {
        materials.extend(bits(*mask).map(|bit| u16::from(colors[bit as usize]) - 1));
    }
    Brick::new(occupancy, materials)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(count: usize, edge: u32) -> Vec<[u8; 4]> {
        let mut state = 12345u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 16
        };
        (0..count)
            .map(|_| [(next() % edge) as u8, (next() % edge) as u8, (next() % edge) as u8, next() as u8])
            .collect()
    }

    #[test]
    fn sorting_into_bricks_gives_the_grid_of_setting_voxel_by_voxel() {
        for (count, edge) in [(0, 8), (1, 1), (5_000, 7), (20_000, 40), (50_000, 256)] {
            let mut voxels = noise(count, edge);
            let grid = grid_by_brick(&voxels);
            assert_eq!(grid, grid_by_voxel(&voxels), "{count} voxels in {edge}³");
            if let Some(last) = voxels.last_mut() {
                last[3] = last[3].wrapping_add(1).max(1);
                assert_ne!(grid, grid_by_voxel(&voxels), "a changed colour must show");
            }
        }
    }

    #[test]
    fn the_last_of_two_voxels_at_one_place_holds() {
        let voxels = [[[1, 2, 3, 7], [1, 2, 3, 9]], [[4, 2, 3, 7], [4, 2, 3, 0]]].concat();
        for grid in [grid_by_voxel(&voxels), grid_by_brick(&voxels)] {
            assert_eq!(grid.get(IVec3::new(1, 2, 3)), Some(8));
            assert_eq!(grid.get(IVec3::new(4, 2, 3)), None);
            assert_eq!(grid.count(), 1);
        }
    }

    #[test]
    fn a_voxel_on_the_upper_face_is_outside() {
        assert_eq!(first_outside([2, 3, 4], &[[1, 2, 3, 1], [0, 0, 0, 1]]), None);
        assert_eq!(first_outside([2, 3, 4], &[[1, 2, 3, 1], [2, 0, 0, 1]]), Some(1));
        assert_eq!(first_outside([2, 3, 4], &[[0, 3, 0, 1]]), Some(0));
    }
}
