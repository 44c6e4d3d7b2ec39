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

impl Tile<'_> {
    /// Number of pixels.
    pub fn pixels(&self) -> usize {
        self.region.pixels()
    }
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
