//! A picture cut into squares that threads fill independently.

use crate::film::Pixel;
use crate::frame::Region;

/// A rectangle of a film's pixels.
pub struct Tile<'a> {
    /// The rectangle, pixels of the whole picture.
    pub region: Region,
    /// Its pixels, row by row.
    pub rows: Vec<&'a mut [Pixel]>,
}

/// The pixels (column, row) of a tile, block by block of 8×8 and in these of 4×4, so that rays that follow each other are
/// neighbours in both directions.
pub fn in_blocks(width: u32, height: u32) -> impl Iterator<Item = (u32, u32)> {
    let blocks = |x: (u32, u32), y: (u32, u32), size: u32| {
        let ends = move |at: u32, end: u32| (at, end.min(at.saturating_add(size)));
        let rows = (y.0..y.1).step_by(size as usize);
        rows.flat_map(move |top| (x.0..x.1).step_by(size as usize).map(move |left| (ends(left, x.1), ends(top, y.1))))
    };
    blocks((0, width), (0, height), 8)
        .flat_map(move |(x, y)| blocks(x, y, 4))
        .flat_map(|(x, y)| (y.0..y.1).flat_map(move |row| (x.0..x.1).map(move |column| (column, row))))
}

/// Cuts the pixels of a region into tiles of `tile_size`, smaller ones at the right and the bottom, row by row of tiles.
pub fn tiles_mut(pixels: &mut [Pixel], region: Region, tile_size: u32) -> Vec<Tile<'_>> {
    let mut tiles: Vec<Tile> = (region.y0..region.y1)
        .step_by(tile_size as usize)
        .flat_map(|y0| (region.x0..region.x1).step_by(tile_size as usize).map(move |x0| (x0, y0)))
        .map(|(x0, y0)| {
            let (x1, y1) = (x0.saturating_add(tile_size).min(region.x1), y0.saturating_add(tile_size).min(region.y1));
            Tile { region: Region { x0, y0, x1, y1 }, rows: Vec::new() }
        })
        .collect();
    let tiles_in_row = region.width().div_ceil(tile_size) as usize;
    for (y, row) in pixels.chunks_mut(region.width() as usize).enumerate() {
        let first = y / tile_size as usize * tiles_in_row;
        let parts = row.chunks_mut(tile_size as usize);
        for (tile, part) in tiles[first..].iter_mut().zip(parts) {
            tile.rows.push(part);
        }
    }
    tiles
}

#[cfg(test)]
mod tests {
    use super::in_blocks;

    #[test]
    fn blocks_hold_every_pixel_once() {
        for (width, height) in [(32, 32), (1, 1), (7, 13), (45, 3), (8, 9)] {
            let mut pixels: Vec<_> = in_blocks(width, height).collect();
            assert_eq!(pixels.len(), (width * height) as usize);
            pixels.sort_unstable();
            pixels.dedup();
            assert_eq!(pixels.len(), (width * height) as usize);
            assert!(pixels.iter().all(|&(x, y)| x < width && y < height));
        }
    }

    #[test]
    fn sixteen_pixels_that_follow_each_other_are_a_square() {
        let pixels: Vec<_> = in_blocks(32, 16).collect();
        for square in pixels.chunks(16) {
            let (x, y) = square[0];
            assert_eq!((x % 4, y % 4), (0, 0));
            assert!(square.iter().all(|&(column, row)| column - x < 4 && row - y < 4));
        }
    }
}
