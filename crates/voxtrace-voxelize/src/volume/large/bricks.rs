//! The bricks of a stripe's layer from the window around it: of the shell alone, where that is wanted. The window has the axes of the
//! lattice, bricks those of the grid.

use super::super::slab::{EDGE, WORD, occupancy_of};
use super::seen::{SeenLayer, Window};
use crate::voxelize::TileRecords;
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::{bits, voxel_of};

/// The bricks of a layer of bricks, one record for each of its rows. `world` says which axis of the grid each axis of the lattice is.
pub(super) fn bricks_of(window: &Window, layer: usize, world: [usize; 3], shell: bool) -> Vec<TileRecords> {
    // Seven voxels are looked at around each one.
    let layers: [Option<&SeenLayer>; EDGE + 2] =
        std::array::from_fn(|at| (layer * EDGE + at).checked_sub(1).and_then(|at| window.layer(at)));
    let maker = Maker { window, layers, layer, world, shell };
    window.stripe.bricks.clone().into_par_iter().map(|row| maker.row(row)).collect()
}

struct Maker<'a> {
    window: &'a Window<'a>,
    layers: [Option<&'a SeenLayer>; EDGE + 2],
    layer: usize,
    world: [usize; 3],
    shell: bool,
}

impl Maker<'_> {
    /// The bricks of a row of bricks.
    fn row(&self, row: usize) -> TileRecords {
        let mut records = TileRecords::default();
        let count = self.window.width().div_ceil(EDGE);
        for word in 0..self.window.words() {
            let rows: [u64; EDGE * EDGE] =
                std::array::from_fn(|at| self.visible(row * EDGE + at % EDGE, at / EDGE + 1, word));
            if rows.iter().all(|&row| row == 0) {
                continue;
            }
            for x in word * EDGE..((word + 1) * EDGE).min(count) {
                self.push([x, row], &rows, &mut records);
            }
        }
        records
    }

    /// The voxels of a word that are kept, in a row of the layer `z`, of which the first is below the bricks.
    fn visible(&self, row: usize, z: usize, word: usize) -> u64 {
        let at = |row: usize, z: usize| self.window.row(self.layers[z], row).unwrap_or_default();
        let own = at(row, z);
        let bits = own.get(word).copied().unwrap_or(0);
        if !self.shell || bits == 0 {
            return bits;
        }
        let word_of = |row: &[u64]| row.get(word).copied().unwrap_or(0);
        let before = word.checked_sub(1).and_then(|before| own.get(before)).copied().unwrap_or(0);
        let after = own.get(word + 1).copied().unwrap_or(0);
        let across = (bits << 1 | before >> (WORD - 1)) & (bits >> 1 | after << (WORD - 1));
        let below = row.checked_sub(1).map_or(0, |below| word_of(at(below, z)));
        let around = below & word_of(at(row + 1, z)) & word_of(at(row, z - 1)) & word_of(at(row, z + 1));
        bits & !(across & around)
    }

    /// Encodes a brick, unless it is empty, from the 64 rows of a word around it.
    fn push(&self, [x, row]: [usize; 2], rows: &[u64; EDGE * EDGE], records: &mut TileRecords) {
        let own = rows.map(|bits| bits >> (x % EDGE * EDGE) & 0xff);
        if own == [0; EDGE * EDGE] {
            return;
        }
        let occupancy = occupancy_of(&self.turned(own), 0);
        let voxels = (0..8).flat_map(|block| bits(occupancy[block]).map(move |bit| voxel_of(block, bit)));
        let keys: Vec<u64> = voxels
            .map(|local| {
                let [i, j, k] = self.world.map(|axis| local[axis] as usize);
                let layer = self.layers[k + 1];
                layer.map_or(0, |layer| self.window.material(layer, [x * EDGE + i, row * EDGE + j]).into())
            })
            .collect();
        let mut at = IVec3::ZERO;
        for (axis, place) in self.world.into_iter().zip([x, row, self.layer]) {
            at[axis] = place as i32;
        }
        records.push(at, &occupancy, &keys);
    }

    /// Rows along the grid's first axis, from those along the lattice's.
    fn turned(&self, rows: [u64; EDGE * EDGE]) -> [u64; EDGE * EDGE] {
        if self.world == [0, 1, 2] {
            return rows;
        }
        let mut turned = [0; EDGE * EDGE];
        for (at, &row) in rows.iter().enumerate() {
            for i in bits(row) {
                let mut place = [0; 3];
                for (axis, along) in self.world.into_iter().zip([i as usize, at % EDGE, at / EDGE]) {
                    place[axis] = along;
                }
                turned[place[2] * EDGE + place[1]] |= 1 << place[0];
            }
        }
        turned
    }
}
