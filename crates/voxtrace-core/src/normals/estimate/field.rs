//! Blurred occupancy of a tile and what surrounds it, in cells of 1, 2, 4 or 8 voxels along an edge, and its derivatives.

use glam::{IVec3, Vec3};

/// Cells around the tile that its derivatives depend on: the window, one for differences, one for interpolation.
const HALO: i32 = 5;
/// Three times a mean of three cells: nearly a Gaussian, whose standard deviation is √2 cells.
const WINDOW: [f32; 4] = [7.0 / 27.0, 6.0 / 27.0, 3.0 / 27.0, 1.0 / 27.0];

/// First and second derivatives of a field, along its cells.
#[derive(Clone, Copy, Debug, Default)]
pub struct Jet {
    pub gradient: Vec3,
    /// xx, yy, zz, yz, zx, xy.
    pub bend: [f32; 6],
}

/// Shares of cells that are occupied, and the same blurred.
pub struct Field {
    /// Cells along an edge, the halo included.
    edge: i32,
    occupancy: Vec<f32>,
    blurred: Vec<f32>,
}

impl Field {
    /// The field around the tile of `size` voxels whose lowest is `corner`, in cells of `1 << level` voxels, at most a brick.
    pub fn of(masks_of: &dyn Fn(IVec3) -> Option<[u64; 8]>, corner: IVec3, size: i32, level: u32) -> Self {
        let edge = (size >> level) + 2 * HALO;
        let mut occupancy = vec![0.0; (edge * edge * edge) as usize];
        let low: IVec3 = (corner >> level as i32) - HALO;
        let first: IVec3 = (low << level as i32) >> 3;
        let last: IVec3 = (((low + edge) << level as i32) - 1) >> 3;
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    let at = IVec3::new(x, y, z);
                    if let Some(masks) = masks_of(at) {
                        for_each_cell(&masks, level, |cell, share| {
                            let place = ((at * 8) >> level as i32) + cell - low;
                            if place.min_element() >= 0 && place.max_element() < edge {
                                occupancy[((place.z * edge + place.y) * edge + place.x) as usize] = share;
                            }
                        });
                    }
                }
            }
        }
        let mut blurred = occupancy.clone();
        for stride in [1, edge, edge * edge] {
            blurred = blur(&blurred, stride as usize);
        }
        Self { edge, occupancy, blurred }
    }

    /// Index of a cell, counted from the tile's corner.
    fn index(&self, cell: IVec3) -> usize {
        let place = cell + HALO;
        ((place.z * self.edge + place.y) * self.edge + place.x) as usize
    }

    /// Whether there is anything in a cell.
    pub fn is_occupied(&self, cell: IVec3) -> bool {
        self.occupancy[self.index(cell)] > 0.0
    }

    /// The derivatives in the middle of a cell.
    pub fn jet_at_voxel(&self, cell: IVec3) -> Jet {
        self.jet(self.index(cell))
    }

    fn jet(&self, index: usize) -> Jet {
        let (x, y, z) = (1, self.edge as usize, (self.edge * self.edge) as usize);
        let at = |ahead: usize, behind: usize| self.blurred[index + ahead - behind];
        let slope = |a: usize| (at(a, 0) - at(0, a)) * 0.5;
        let twice = |a: usize| at(a, 0) + at(0, a) - 2.0 * at(0, 0);
        let mixed = |a: usize, b: usize| (at(a + b, 0) + at(0, a + b) - at(a, b) - at(b, a)) * 0.25;
        Jet {
            gradient: Vec3::new(slope(x), slope(y), slope(z)),
            bend: [twice(x), twice(y), twice(z), mixed(y, z), mixed(z, x), mixed(x, y)],
        }
    }
}

/// Hands out the cells of a brick that hold voxels, counted from its corner, with the share of them that is occupied.
fn for_each_cell(masks: &[u64; 8], level: u32, mut each: impl FnMut(IVec3, f32)) {
    if level == 3 {
        return each(IVec3::ZERO, masks.iter().map(|mask| mask.count_ones()).sum::<u32>() as f32 / 512.0);
    }
    // Cells along an edge of a block of four voxels, and the voxels of the first.
    let (cells, first) = match level {
        0 => (4, 1),
        1 => (2, 0x0033_0033),
        _ => (1, u64::MAX),
    };
    let voxels = 4 / cells;
    for (block, &mask) in masks.iter().enumerate().filter(|(_, mask)| **mask != 0) {
        let corner = IVec3::new(block as i32 & 1, block as i32 >> 1 & 1, block as i32 >> 2) * cells;
        for place in 0..cells * cells * cells {
            let within = IVec3::new(place % cells, place / cells % cells, place / (cells * cells));
            let shift = (within.x + 4 * within.y + 16 * within.z) * voxels;
            let count = (mask >> shift & first).count_ones();
            if count > 0 {
                each(corner + within, count as f32 / (voxels * voxels * voxels) as f32);
            }
        }
    }
}

/// The means along one axis, along which neighbours are `stride` apart; without meaning near the border.
fn blur(values: &[f32], stride: usize) -> Vec<f32> {
    let mut blurred = vec![0.0; values.len()];
    let last = values.len().saturating_sub(3 * stride);
    for index in 3 * stride..last {
        let pair = |distance: usize| values[index - distance * stride] + values[index + distance * stride];
        blurred[index] = WINDOW[0] * values[index] + WINDOW[1] * pair(1) + WINDOW[2] * pair(2) + WINDOW[3] * pair(3);
    }
    blurred
}

/// A field whose derivatives are known everywhere between the middles of its cells.
pub struct Sampled {
    field: Field,
    level: u32,
    jets: Vec<Jet>,
}

impl Sampled {
    pub fn new(field: Field, level: u32) -> Self {
        let edge = field.edge as usize;
        let reach = edge * edge + edge + 1;
        let mut jets = vec![Jet::default(); field.blurred.len()];
        for (index, jet) in jets.iter_mut().enumerate().skip(reach).take(field.blurred.len().saturating_sub(2 * reach))
        {
            *jet = field.jet(index);
        }
        Self { field, level, jets }
    }

    /// The derivatives in the middle of a voxel, counted from the tile's corner.
    pub fn at(&self, voxel: IVec3) -> Jet {
        let cell_edge = (1 << self.level) as f32;
        let place = (voxel.as_vec3() + 0.5) / cell_edge - 0.5;
        let low = place.floor();
        let share = place - low;
        let mut sum = Jet::default();
        for corner in 0..8 {
            let step = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
            let weights = share * step.as_vec3() + (1.0 - share) * (1 - step).as_vec3();
            let weight = weights.x * weights.y * weights.z;
            let jet = &self.jets[self.field.index(low.as_ivec3() + step)];
            sum.gradient += jet.gradient * weight;
            sum.bend.iter_mut().zip(&jet.bend).for_each(|(sum, bend)| *sum += bend * weight);
        }
        sum
    }
}
