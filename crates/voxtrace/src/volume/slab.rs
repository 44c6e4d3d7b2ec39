//! Eight layers of voxels at a time become bricks: samples are mixed, looked up, and where only the shell is wanted
//! compared with the layers around.

use super::Volume;
use super::resample::{Axis, Taps};
use super::transfer::{EMPTY, Lookup};
use crate::brick::{BRICK_SIZE, Brick, voxel_of};
use glam::IVec3;

/// Voxels along an edge of a brick.
const EDGE: usize = BRICK_SIZE as usize;

/// The bricks of one layer of bricks.
pub(super) fn bricks(
    volume: &Volume,
    axes: &[Axis; 3],
    layer: usize,
    lookup: &Lookup,
    shell: bool,
) -> Vec<(IVec3, Brick)> {
    let slab = Slab::new(volume, axes, layer, lookup);
    let (wide, deep) = (axes[0].count().div_ceil(EDGE), axes[1].count().div_ceil(EDGE));
    let mut bricks = Vec::new();
    for y in 0..deep {
        for x in 0..wide {
            let (mut occupancy, mut materials) = ([0u64; 8], Vec::new());
            for (block, mask) in occupancy.iter_mut().enumerate() {
                for bit in 0..64 {
                    let local = voxel_of(block, bit);
                    // One more on each side: the slab has a border.
                    let at = slab.at(x * EDGE + local.x as usize, y * EDGE + local.y as usize, local.z as usize);
                    let material = slab.materials[at];
                    if material != EMPTY && !(shell && slab.is_hidden(at)) {
                        *mask |= 1 << bit;
                        materials.push(material);
                    }
                }
            }
            if !materials.is_empty() {
                bricks.push((IVec3::new(x as i32, y as i32, layer as i32), Brick::new(occupancy, materials)));
            }
        }
    }
    bricks
}

/// Materials of eight layers, of the layer below and above, and of a border of nothing around.
struct Slab {
    materials: Vec<u16>,
    width: usize,
    area: usize,
}

impl Slab {
    fn new(volume: &Volume, axes: &[Axis; 3], layer: usize, lookup: &Lookup) -> Self {
        let padded = |axis: &Axis| axis.count().next_multiple_of(EDGE) + 2;
        let (width, depth) = (padded(&axes[0]), padded(&axes[1]));
        let area = width * depth;
        let mut slab = Self { materials: vec![EMPTY; area * (EDGE + 2)], width, area };
        for z in 0..EDGE + 2 {
            let Some(at_z) = (layer * EDGE + z).checked_sub(1).and_then(|z| axes[2].taps.get(z)) else { continue };
            for (y, at_y) in axes[1].taps.iter().enumerate() {
                let start = z * area + (y + 1) * width + 1;
                let row = &mut slab.materials[start..start + axes[0].count()];
                for (material, at_x) in row.iter_mut().zip(&axes[0].taps) {
                    *material = lookup.material(sample(volume, axes, [at_x, at_y, at_z]));
                }
            }
        }
        slab
    }

    fn at(&self, x: usize, y: usize, z: usize) -> usize {
        (z + 1) * self.area + (y + 1) * self.width + x + 1
    }

    /// Whether all six neighbours are occupied.
    fn is_hidden(&self, at: usize) -> bool {
        [1, self.width, self.area]
            .iter()
            .all(|step| self.materials[at - step] != EMPTY && self.materials[at + step] != EMPTY)
    }
}

fn sample(volume: &Volume, axes: &[Axis; 3], [x, y, z]: [&Taps; 3]) -> f32 {
    let start = x.start + y.start + z.start;
    if x.weights.len() + y.weights.len() + z.weights.len() == 3 {
        return volume.values[start];
    }
    let mut sum = 0.0;
    for (k, weight_z) in z.weights.iter().enumerate() {
        for (j, weight_y) in y.weights.iter().enumerate() {
            let row = start + k * axes[2].stride + j * axes[1].stride;
            for (i, weight_x) in x.weights.iter().enumerate() {
                sum += weight_x * weight_y * weight_z * volume.values[row + i * axes[0].stride];
            }
        }
    }
    sum
}
