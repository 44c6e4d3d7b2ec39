//! From arrays with a value for every place to bricks: each brick is built whole, in parallel.

use glam::IVec3;
#[cfg(test)]
use rayon::prelude::*;
#[cfg(test)]
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::brick::{Brick, voxel_of};
#[cfg(test)]
use voxtrace_scene::grid::VoxelGrid;

/// The brick whose voxel `local` (each coordinate in 0..8) has the material that the function says.
pub(crate) fn brick(material_at: impl Fn(IVec3) -> Option<u16>) -> Brick {
    let (mut occupancy, mut materials) = ([0; 8], Vec::new());
    for (block, mask) in occupancy.iter_mut().enumerate() {
        for bit in 0..64 {
            if let Some(material) = material_at(voxel_of(block, bit)) {
                *mask |= 1 << bit;
                materials.push(material);
            }
        }
    }
    Brick::new(occupancy, materials)
}

/// The grid of `size` voxels from the origin on, which tests hold others against. The function is asked for places within alone.
#[cfg(test)]
pub(crate) fn grid(size: IVec3, material_at: impl Fn(IVec3) -> Option<u16> + Sync) -> VoxelGrid {
    let bricks = (size + BRICK_SIZE - 1) / BRICK_SIZE;
    let layers = (0..bricks.z).into_par_iter().flat_map_iter(|z| {
        let material_at = &material_at;
        (0..bricks.y).flat_map(move |y| (0..bricks.x).map(move |x| IVec3::new(x, y, z))).map(move |at| {
            let corner = at * BRICK_SIZE;
            let is_inside = (corner + BRICK_SIZE).cmple(size).all();
            let material = |local: IVec3| {
                let voxel = corner + local;
                if is_inside || voxel.cmplt(size).all() { material_at(voxel) } else { None }
            };
            (at, brick(material))
        })
    });
    let bricks: Vec<_> = layers.filter(|(_, brick)| !brick.is_empty()).collect();
    VoxelGrid::from_bricks(bricks)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_holds_what_the_function_says_and_nothing_beyond_its_size() {
        let size = IVec3::new(17, 8, 21);
        let at =
            |voxel: IVec3| (voxel.x * 7 + voxel.y * 3 + voxel.z).checked_rem(5).filter(|&v| v > 1).map(|v| v as u16);
        let found = grid(size, at);
        let mut count = 0;
        for z in -1..size.z + 9 {
            for y in -1..size.y + 9 {
                for x in -1..size.x + 9 {
                    let voxel = IVec3::new(x, y, z);
                    let inside = voxel.cmpge(IVec3::ZERO).all() && voxel.cmplt(size).all();
                    let wanted = if inside { at(voxel) } else { None };
                    assert_eq!(found.get(voxel), wanted, "{voxel}");
                    count += u64::from(wanted.is_some());
                }
            }
        }
        assert_eq!(found.count(), count);
    }
}
