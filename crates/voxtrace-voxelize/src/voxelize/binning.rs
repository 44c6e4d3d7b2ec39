//! Binning: which triangles reach into which tile, as (tile, triangle) pairs sorted by tile and then by triangle. Each tile can
//! then be voxelized on its own, and sums its colours in the order of the file, whatever the number of threads.

use super::placement::Placement;
use super::polygon::{Pieces, Polygon, TOUCH, cells_of, for_each_cell};
use super::triangle::Triangle;
use crate::mesh::Mesh;
use glam::IVec3;
use rayon::prelude::*;
use std::ops::Range;

/// Voxels along one edge of a tile: as large as the lowest inner node (4³ bricks) of a packed grid's tree.
pub(super) const TILE: i32 = 32;
/// Edge of a voxel in tiles: a power of two, so that multiplying is exact.
const TILES_IN_VOXEL: f64 = 1.0 / TILE as f64;
/// Triangles binned by one task.
const CHUNK: usize = 1 << 14;
/// Tiles added around the mesh on each side, for faces that lie on its border.
const MARGIN: i32 = 1;

/// The tiles of a grid, numbered with x fastest and z slowest.
#[derive(Clone, Copy)]
pub(super) struct TileGrid {
    size: IVec3,
}

impl TileGrid {
    /// `None` where tile numbers do not fit into 32 bits.
    pub fn of(placement: &Placement) -> Option<Self> {
        let size = (placement.size + (TILE - 1)) / TILE + 2 * MARGIN;
        let count = size.to_array().iter().map(|&n| n as u64).product::<u64>();
        (count <= u64::from(u32::MAX)).then_some(Self { size })
    }

    /// Number of tiles along each axis, the margin included.
    pub fn size(&self) -> IVec3 {
        self.size
    }

    /// A tile's coordinates counted from the first one of the margin: never negative.
    pub fn place(&self, tile: [i32; 3]) -> IVec3 {
        IVec3::from_array(tile) + MARGIN
    }

    /// Number of layers of tiles along z, the margin included.
    pub fn layers(&self) -> usize {
        self.size.z as usize
    }

    /// The number of the tile with these coordinates.
    pub fn number(&self, tile: [i32; 3]) -> u32 {
        let at = self.place(tile);
        ((at.z as u32 * self.size.y as u32) + at.y as u32) * self.size.x as u32 + at.x as u32
    }

    /// The numbers of the tiles in some layers.
    pub fn numbers(&self, layers: &Range<usize>) -> Range<u32> {
        let in_layer = self.size.x as u32 * self.size.y as u32;
        layers.start as u32 * in_layer..layers.end as u32 * in_layer
    }

    /// Tile coordinates of a number.
    pub fn tile(&self, number: u32) -> IVec3 {
        let (x, rest) = (number % self.size.x as u32, number / self.size.x as u32);
        IVec3::new(x as i32, (rest % self.size.y as u32) as i32, (rest / self.size.y as u32) as i32) - MARGIN
    }

    /// The layer of a tile's z coordinate.
    pub fn layer(&self, tile_z: i32) -> usize {
        (tile_z + MARGIN) as usize
    }
}

/// A subset of the tiles.
pub(super) trait TileFilter: Sync {
    /// Conservative test: whether a triangle from one layer of tiles to another may reach into a tile of the subset.
    fn may_hold(&self, layers: (usize, usize)) -> bool;
    /// Whether a tile is in the subset.
    fn holds(&self, tiles: &TileGrid, tile: [i32; 3]) -> bool;
}

/// The tiles in a range of layers.
impl TileFilter for Range<usize> {
    fn may_hold(&self, layers: (usize, usize)) -> bool {
        layers.1 >= self.start && layers.0 < self.end
    }

    fn holds(&self, tiles: &TileGrid, tile: [i32; 3]) -> bool {
        self.contains(&tiles.layer(tile[2]))
    }
}

/// Upper bound of the number of pairs in each layer of tiles: those of the triangles' bounding boxes.
pub(super) fn pairs_by_layer(mesh: &Mesh, placement: &Placement, tiles: &TileGrid) -> Vec<u64> {
    let layers = tiles.layers();
    let count = |chunk: Range<usize>| {
        let mut counts = vec![0u64; layers];
        for index in chunk {
            let Some(triangle) = Triangle::of(mesh, placement, index) else { continue };
            let [x, y, z] = tile_ranges(&triangle);
            let area = (x.1 - x.0 + 1) as u64 * (y.1 - y.0 + 1) as u64;
            for layer in z.0..=z.1 {
                counts[tiles.layer(layer)] += area;
            }
        }
        counts
    };
    let add = |mut a: Vec<u64>, b: Vec<u64>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        a
    };
    chunks(mesh).into_par_iter().map(count).reduce(|| vec![0; layers], add)
}

/// The sorted pairs of a subset of tiles: the tile's number in the high 32 bits, the triangle's in the low ones.
pub(super) fn pairs_of(mesh: &Mesh, placement: &Placement, tiles: &TileGrid, filter: &impl TileFilter) -> Vec<u64> {
    let parts: Vec<Vec<u64>> = chunks(mesh)
        .into_par_iter()
        .map(|chunk| {
            let (mut pairs, mut pieces) = (Vec::with_capacity(chunk.len()), Pieces::new());
            for index in chunk {
                if let Some(triangle) = Triangle::of(mesh, placement, index) {
                    for_each_tile(&triangle, tiles, filter, &mut pieces, |tile| {
                        pairs.push(u64::from(tiles.number(tile)) << 32 | index as u64);
                    });
                }
            }
            pairs
        })
        .collect();
    let mut pairs = Vec::with_capacity(parts.iter().map(Vec::len).sum());
    for part in parts {
        pairs.extend_from_slice(&part);
    }
    pairs.par_sort_unstable();
    pairs
}

/// Calls `each` with every tile of a subset that a triangle reaches into.
#[inline]
pub(super) fn for_each_tile(
    triangle: &Triangle,
    tiles: &TileGrid,
    filter: &impl TileFilter,
    pieces: &mut Pieces,
    mut each: impl FnMut([i32; 3]),
) {
    let [x, y, z] = tile_ranges(triangle);
    if !filter.may_hold((tiles.layer(z.0), tiles.layer(z.1))) {
        return;
    }
    let mut check = |tile: [i32; 3]| {
        if filter.holds(tiles, tile) {
            each(tile);
        }
    };
    if x.0 == x.1 && y.0 == y.1 && z.0 == z.1 {
        return check([x.0, y.0, z.0]);
    }
    for_each_cell(&in_tiles(triangle), TOUCH * TILES_IN_VOXEL, pieces, |tile, _| check(tile));
}

/// The triangle in units of tiles.
fn in_tiles(triangle: &Triangle) -> Polygon {
    Polygon::new(&triangle.corners.map(|corner| corner.map(|value| value * TILES_IN_VOXEL)))
}

/// Lowest and highest tile along each axis that the triangle's bounding box reaches.
fn tile_ranges(triangle: &Triangle) -> [(i32, i32); 3] {
    let [a, b, c] = triangle.corners;
    let range = |axis: usize| {
        let low = a[axis].min(b[axis]).min(c[axis]) * TILES_IN_VOXEL;
        let high = a[axis].max(b[axis]).max(c[axis]) * TILES_IN_VOXEL;
        cells_of((low, high), TOUCH * TILES_IN_VOXEL)
    };
    [range(0), range(1), range(2)]
}

fn chunks(mesh: &Mesh) -> Vec<Range<usize>> {
    let count = mesh.triangle_count();
    (0..count).step_by(CHUNK).map(|first| first..(first + CHUNK).min(count)).collect()
}
