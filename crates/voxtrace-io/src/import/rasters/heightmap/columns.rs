//! Columns of voxels as bricks: only bricks that hold a voxel are made, so high and wide maps cost what their surface does.

use crate::import::grids::dense;
use crate::import::source::input::beyond;
use glam::IVec3;
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelGrid};
use voxtrace_voxelize::{ImportError, Limits};

/// Most voxels of a column.
pub(super) const MOST_HEIGHT: i32 = 1 << 18;

/// Columns, row by row from the north.
pub(super) struct Columns {
    pub width: usize,
    pub depth: usize,
    /// The height of the uppermost voxel, −1 where there is none.
    pub tops: Vec<i32>,
    pub materials: Vec<u16>,
    pub shell: bool,
}

impl Columns {
    /// The grid, its south-western corner at the origin.
    pub fn grid(&self, path: &Path, limits: &Limits) -> Result<VoxelGrid, ImportError> {
        let edge = self.width.max(self.depth) as u64;
        if edge > MAX_COORDINATE as u64 {
            return Err(beyond(path, None, "points along an edge", edge, MAX_COORDINATE as u64));
        }
        let (width, depth) = (self.width as i32, self.depth as i32);
        // The lowest voxel that is kept, the one at the bottom aside.
        let floor = |x: i32, y: i32| {
            let Some(top) = self.top(x, y) else { return i32::MAX };
            let beside = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
            let lowest = beside.iter().map(|&(x, y)| self.top(x, y).unwrap_or(-1)).min().unwrap_or(-1);
            if self.shell { (lowest + 1).min(top) } else { 0 }
        };
        let floors: Vec<i32> =
            (0..depth).into_par_iter().flat_map_iter(|y| (0..width).map(move |x| floor(x, y))).collect();
        let floor = |x: i32, y: i32| floors[(y * width + x) as usize];
        let columns = || (0..depth).into_par_iter().flat_map_iter(move |y| (0..width).map(move |x| (x, y)));
        let count: u64 = columns()
            .filter_map(|(x, y)| Some((self.top(x, y)? - floor(x, y) + 1) as u64 + u64::from(floor(x, y) > 0)))
            .sum();
        if count > limits.voxels {
            return Err(ImportError::limit(path, None, "voxels", count, limits.voxels));
        }
        let (columns, rows) = ((width + 7) / BRICK_SIZE, (depth + 7) / BRICK_SIZE);
        let bricks = (0..columns * rows).into_par_iter().flat_map_iter(|index| {
            let corner = IVec3::new(index % columns, index / columns, 0) * BRICK_SIZE;
            // Lowest and uppermost voxel and material of the brick's columns; nothing is at or below −1.
            let mut spans = [(0, -1, 0); 64];
            for (local, span) in (0..).zip(&mut spans) {
                let (x, y) = (corner.x + (local & 7), corner.y + (local >> 3));
                if let Some(top) = self.top(x, y) {
                    *span = (floor(x, y), top, self.materials[self.place(x, y)]);
                }
            }
            let there = spans.iter().filter(|&&(_, top, _)| top >= 0);
            let (low, high) = there.fold((i32::MAX, -1), |(low, high), &(a, b, _)| (low.min(a), high.max(b)));
            // The lowest layer is always there.
            let first = if high >= 0 && low >= BRICK_SIZE { Some(0) } else { None };
            let range = if high >= 0 { low / BRICK_SIZE..high / BRICK_SIZE + 1 } else { 0..0 };
            first.into_iter().chain(range).map(move |layer| {
                let brick = dense::brick(|local| {
                    let (low, top, material) = spans[(local.x | local.y << 3) as usize];
                    let z = layer * BRICK_SIZE + local.z;
                    (z <= top && (z == 0 || z >= low)).then_some(material)
                });
                ((corner >> 3) + IVec3::Z * layer, brick)
            })
        });
        Ok(VoxelGrid::from_bricks(bricks.collect::<Vec<_>>()))
    }

    /// The index of a column; rows of the file run south, ours north.
    fn place(&self, x: i32, y: i32) -> usize {
        (self.depth - 1 - y as usize) * self.width + x as usize
    }

    fn top(&self, x: i32, y: i32) -> Option<i32> {
        let is_inside = x >= 0 && y >= 0 && (x as usize) < self.width && (y as usize) < self.depth;
        is_inside.then(|| self.tops[self.place(x, y)]).filter(|&top| top >= 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(shell: bool) -> Columns {
        let (width, depth) = (19, 21);
        let top = |i: usize| if i % 7 == 3 { -1 } else { (i * 37 % 40) as i32 };
        let tops = (0..width * depth).map(top).collect();
        Columns { width, depth, tops, materials: (0..(width * depth) as u16).collect(), shell }
    }

    #[test]
    fn solid_columns_reach_the_ground_and_a_shell_is_what_is_seen_of_them() {
        let grid = |shell| columns(shell).grid(Path::new("a"), &Limits::default()).unwrap();
        let (solid, shell) = (grid(false), grid(true));
        let columns = columns(false);
        let mut count = 0;
        for y in 0..21 {
            for x in 0..19 {
                for z in 0..42 {
                    let place = (20 - y) * 19 + x;
                    let wanted = (z <= columns.tops[place]).then_some(place as u16);
                    let at = IVec3::new(x as i32, y as i32, z);
                    assert_eq!(solid.get(at), wanted, "{at}");
                    let steps = [IVec3::X, IVec3::NEG_X, IVec3::Y, IVec3::NEG_Y, IVec3::Z, IVec3::NEG_Z];
                    let is_seen = steps.iter().any(|&step| solid.get(at + step).is_none());
                    assert_eq!(shell.get(at), wanted.filter(|_| is_seen), "{at}");
                    count += u64::from(wanted.is_some());
                }
            }
        }
        assert!(solid.count() == count && shell.count() < count);
    }

    #[test]
    fn more_voxels_than_allowed_are_refused_before_they_are_made() {
        let limits = Limits { voxels: 500, ..Limits::default() };
        assert!(columns(true).grid(Path::new("a"), &limits).is_err());
        let high = Columns { width: 2, depth: 1, tops: vec![MOST_HEIGHT; 2], materials: vec![0; 2], shell: true };
        assert_eq!(high.grid(Path::new("a"), &Limits::default()).unwrap().count(), 2 * (MOST_HEIGHT as u64 + 1));
    }
}
