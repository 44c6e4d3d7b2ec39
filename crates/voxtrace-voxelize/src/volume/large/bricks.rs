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

/// Rows of bits by layer and row: those of a row of bricks, and one at each side.
type Around<'a> = [[&'a [u64]; EDGE + 2]; EDGE + 2];

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
        // Rows of bits, those around the bricks too.
        let around: Around = std::array::from_fn(|z| {
            let at = |y: usize| (row * EDGE + y).checked_sub(1);
            std::array::from_fn(|y| at(y).map_or(&[][..], |row| self.window.row(self.layers[z], row)))
        });
        let mut any = vec![0; self.window.words()];
        for row in around[1..=EDGE].iter().flat_map(|rows| &rows[1..=EDGE]) {
            any.iter_mut().zip(*row).for_each(|(any, bits)| *any |= bits);
        }
        for word in (0..any.len()).filter(|&word| any[word] != 0) {
            let (mut rows, mut kept) = ([0; EDGE * EDGE], 0);
            for (at, own) in rows.iter_mut().enumerate() {
                *own = self.visible(&around, [at % EDGE + 1, at / EDGE + 1], word);
                kept |= *own;
            }
            for x in (0..EDGE).filter(|x| kept >> (x * EDGE) & 0xff != 0) {
                self.push([word * EDGE + x, row], &rows, &mut records);
            }
        }
        records
    }

    /// The voxels of a word that are kept, in a row of a layer.
    fn visible(&self, around: &Around, [y, z]: [usize; 2], word: usize) -> u64 {
        let own = around[z][y];
        let bits = own.get(word).copied().unwrap_or(0);
        if !self.shell || bits == 0 {
            return bits;
        }
        let word_of = |row: &[u64]| row.get(word).copied().unwrap_or(0);
        let before = word.checked_sub(1).map_or(0, |before| own[before]);
        let after = own.get(word + 1).copied().unwrap_or(0);
        let across = (bits << 1 | before >> (WORD - 1)) & (bits >> 1 | after << (WORD - 1));
        let beside = word_of(around[z][y - 1]) & word_of(around[z][y + 1]);
        bits & !(across & beside & word_of(around[z - 1][y]) & word_of(around[z + 1][y]))
    }

    /// Encodes a brick from the 64 rows of a word around it.
    fn push(&self, [x, row]: [usize; 2], rows: &[u64; EDGE * EDGE], records: &mut TileRecords) {
        let mut own = [0; EDGE * EDGE];
        own.iter_mut().zip(rows).for_each(|(own, bits)| *own = bits >> (x % EDGE * EDGE) & 0xff);
        let occupancy = occupancy_of(&self.turned(own), 0);
        // Layers of materials from the brick's first voxel on.
        let corner = [x * EDGE, row * EDGE];
        let layers: [&[u16]; EDGE] = std::array::from_fn(|k| self.window.materials(self.layers[k + 1], corner));
        let (width, [i, j, k]) = (self.window.width(), self.world);
        let (mut keys, mut count) = ([0; EDGE * EDGE * EDGE], 0);
        for (block, &occupied) in occupancy.iter().enumerate() {
            for bit in bits(occupied) {
                let local = voxel_of(block, bit);
                keys[count] = layers[local[k] as usize][local[j] as usize * width + local[i] as usize].into();
                count += 1;
            }
        }
        let mut at = IVec3::ZERO;
        for (axis, place) in self.world.into_iter().zip([x, row, self.layer]) {
            at[axis] = place as i32;
        }
        records.push(at, &occupancy, &keys[..count]);
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
