//! Voxels that come layer by layer become bricks, eight layers at a time: a file of runs never unpacks into one large array.

use super::dense;
use crate::import::source::input::beyond;
use glam::IVec3;
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_voxelize::ImportError;

/// Most places in a layer.
const LAYER: u64 = 1 << 25;

/// A grid in the making, whose voxels come in order along one axis.
pub(crate) struct Slabs {
    size: IVec3,
    axis: usize,
    /// Which eight layers are at work.
    layer: i32,
    /// Material + 1 of each place of eight layers; 0 is empty.
    cells: Vec<u16>,
    bricks: Vec<(IVec3, Brick)>,
}

impl Slabs {
    /// A grid of `size`, whose voxels come layer by layer along `axis`, up or down.
    pub fn new(path: &Path, offset: u64, size: IVec3, axis: usize) -> Result<Self, ImportError> {
        let places = size.to_array().map(|edge| edge as u64);
        let layer = (0..3).filter(|&other| other != axis).map(|other| places[other]).product();
        if layer > LAYER {
            return Err(beyond(path, Some(offset), "places in a layer", layer, LAYER));
        }
        Ok(Self { size, axis, layer: -1, cells: Vec::new(), bricks: Vec::new() })
    }

    /// Sets a voxel within the size. Its layer is one of the eight at work, or those are done.
    pub fn set(&mut self, voxel: IVec3, material: u16) {
        let layer = voxel[self.axis] / BRICK_SIZE;
        if layer != self.layer {
            self.flush();
            self.layer = layer;
            let mut size = self.size;
            size[self.axis] = BRICK_SIZE;
            self.cells = vec![0; size.to_array().map(|edge| edge as usize).iter().product()];
        }
        let cell = self.cell(voxel);
        self.cells[cell] = material + 1;
    }

    fn cell(&self, mut voxel: IVec3) -> usize {
        let mut size = self.size;
        size[self.axis] = BRICK_SIZE;
        voxel[self.axis] %= BRICK_SIZE;
        let ([x, y, z], [width, depth, _]) =
            (voxel.to_array().map(|c| c as usize), size.to_array().map(|c| c as usize));
        (z * depth + y) * width + x
    }

    fn flush(&mut self) {
        if self.cells.is_empty() {
            return;
        }
        let mut count = (self.size + BRICK_SIZE - 1) / BRICK_SIZE;
        count[self.axis] = 1;
        let (cells, layer, axis) = (&self.cells, self.layer, self.axis);
        let mut size = self.size;
        size[axis] = BRICK_SIZE;
        let made = (0..count.element_product()).into_par_iter().map(|index| {
            let mut at = IVec3::new(index % count.x, index / count.x % count.y, index / (count.x * count.y));
            let low = at * BRICK_SIZE;
            let high = (low + BRICK_SIZE).min(size);
            at[axis] = layer;
            let row = |y: i32, z: i32| ((z * size.y + y) * size.x) as usize;
            // Most bricks of most files are empty.
            let is_empty = |y: i32, z: i32| {
                let row = row(y, z);
                cells[row + low.x as usize..row + high.x as usize].iter().all(|&cell| cell == 0)
            };
            if (low.z..high.z).all(|z| (low.y..high.y).all(|y| is_empty(y, z))) {
                return (at, Brick::default());
            }
            let material = |local: IVec3| {
                let place = low + local;
                let is_inside = place.cmplt(high).all();
                if is_inside { cells[row(place.y, place.z) + place.x as usize].checked_sub(1) } else { None }
            };
            (at, dense::brick(material))
        });
        let made: Vec<_> = made.filter(|(_, brick)| !brick.is_empty()).collect();
        self.bricks.extend(made);
        self.cells = Vec::new();
    }

    /// The grid.
    pub fn finish(mut self) -> VoxelGrid {
        self.flush();
        VoxelGrid::from_bricks(self.bricks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_along_any_axis_up_or_down_give_the_same_grid() {
        let size = IVec3::new(19, 9, 17);
        let material = |v: IVec3| ((v.x * 5 + v.y * 7 + v.z * 11) % 4 > 0).then_some((v.x + v.z) as u16);
        let wanted = dense::grid(size, material);
        for axis in 0..3 {
            for up in [true, false] {
                let mut slabs = Slabs::new(Path::new("a"), 0, size, axis).unwrap();
                for layer in 0..size[axis] {
                    let others = [(axis + 1) % 3, (axis + 2) % 3];
                    for a in 0..size[others[0]] {
                        for b in 0..size[others[1]] {
                            let mut voxel = IVec3::ZERO;
                            voxel[axis] = if up { layer } else { size[axis] - 1 - layer };
                            (voxel[others[0]], voxel[others[1]]) = (a, b);
                            if let Some(material) = material(voxel) {
                                slabs.set(voxel, material);
                            }
                        }
                    }
                }
                assert!(slabs.finish() == wanted, "{axis} {up}");
            }
        }
        assert!(Slabs::new(Path::new("a"), 0, IVec3::new(8192, 8192, 1), 2).is_err());
    }
}
