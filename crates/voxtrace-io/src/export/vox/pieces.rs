//! Grids as models of at most 256³ voxels: a grid that does not fit is cut along multiples of 256 from its lowest brick.

use super::palette::Palette;
use crate::export::Wanted;
use crate::import::vox::MAX_EDGE;
use glam::IVec3;
use std::collections::BTreeMap;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;

/// A part of a grid that fits a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Voxel of the grid at the model's origin.
    pub offset: IVec3,
    /// Edges of the model.
    pub size: [u32; 3],
    /// Voxels of the model: position and colour index.
    pub voxels: Vec<[u8; 4]>,
}

/// The models of a grid: at least one, an empty one for an empty grid. A grid whose voxels fit a model as they are keeps
/// its coordinates. Where they are not wanted any more voxels are missing.
pub fn pieces_of(grid: &VoxelGrid, palette: &Palette, wanted: Wanted) -> Vec<Piece> {
    let edge = MAX_EDGE as i32;
    let Some(bounds) = grid.bounds() else {
        return vec![Piece { offset: IVec3::ZERO, size: [1; 3], voxels: Vec::new() }];
    };
    let fits_as_it_is = bounds.min.cmpge(IVec3::ZERO).all() && bounds.max.cmple(IVec3::splat(edge)).all();
    let origin = match (fits_as_it_is, bounds.size().cmple(IVec3::splat(edge)).all()) {
        (true, _) => IVec3::ZERO,
        (false, true) => bounds.min,
        (false, false) => bounds.min.div_euclid(IVec3::splat(BRICK_SIZE)) * BRICK_SIZE,
    };
    let mut cells: BTreeMap<[i32; 3], Vec<(IVec3, &Brick)>> = BTreeMap::new();
    for (at, brick) in grid.sorted_bricks() {
        // Bricks are never cut: cells begin at a brick, or there is only one.
        let lowest = (at * BRICK_SIZE).max(bounds.min);
        let cell = (lowest - origin) / edge;
        cells.entry([cell.z, cell.y, cell.x]).or_default().push((at, brick));
    }
    cells
        .into_iter()
        .map(|([z, y, x], bricks)| piece_of(origin + IVec3::new(x, y, z) * edge, &bricks, palette, wanted))
        .collect()
}

/// The voxels of a grid that fits a model as it is: position and colour index. Where they are not wanted any more some are missing.
pub fn voxels_of(grid: &VoxelGrid, palette: &Palette, wanted: Wanted) -> Vec<[u8; 4]> {
    let bricks = grid.sorted_bricks();
    piece_of(IVec3::ZERO, &bricks, palette, wanted).voxels
}

fn piece_of(offset: IVec3, bricks: &[(IVec3, &Brick)], palette: &Palette, wanted: Wanted) -> Piece {
    let mut voxels = Vec::with_capacity(bricks.iter().map(|(_, brick)| brick.materials().len()).sum());
    let mut size = IVec3::ZERO;
    for (at, brick) in bricks.iter().take_while(|_| wanted()) {
        for (local, material) in brick.voxels() {
            let voxel = *at * BRICK_SIZE + local - offset;
            size = size.max(voxel + 1);
            voxels.push([voxel.x as u8, voxel.y as u8, voxel.z as u8, palette.index(material)]);
        }
    }
    Piece { offset, size: size.as_uvec3().to_array(), voxels }
}
