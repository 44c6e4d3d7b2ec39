//! What lies ahead within a brick, as tables for vector permutations: one set for each of the eight sign patterns of a
//! direction.

use super::vectors::LANES;
use crate::walk::scalar::blocks_ahead;

/// The tables of one octant.
#[repr(C, align(64))]
pub struct Octant {
    /// By block of a brick: the other blocks ahead of it.
    pub blocks: [i32; LANES],
    /// By column (x, y) of a block: bits of the columns ahead, for two layers.
    pub columns: [i32; LANES],
    /// By z in a block: bits of the layers ahead among the lower two and the upper two.
    pub layers: [[i32; LANES]; 2],
}

/// The tables by octant: bit a of its number says that the direction is negative along axis a.
pub static OCTANTS: [Octant; 8] = {
    let mut tables = [EMPTY; 8];
    let blocks = blocks_ahead();
    let mut octant = 0;
    while octant < 8 {
        let mut i = 0;
        while i < LANES {
            tables[octant].blocks[i] = (blocks[octant][i & 7] & !(1 << (i & 7))) as i32;
            let row = ahead(0xf, 1, i & 3, octant & 1 != 0) * 0x1111_1111;
            let column = ahead(0xffff, 4, i >> 2, octant & 2 != 0) * 0x1_0001;
            tables[octant].columns[i] = (row & column) as i32;
            let layers = ahead(u64::MAX, 16, i & 3, octant & 4 != 0);
            tables[octant].layers[0][i] = layers as i32;
            tables[octant].layers[1][i] = (layers >> 32) as i32;
            i += 1;
        }
        octant += 1;
    }
    tables
};

const EMPTY: Octant = Octant { blocks: [0; LANES], columns: [0; LANES], layers: [[0; LANES]; 2] };

/// Bits of `all` from coordinate `at` on, or up to it, where a step of the coordinate is `stride` bits.
const fn ahead(all: u64, stride: usize, at: usize, is_negative: bool) -> u64 {
    if is_negative { all >> (stride * (3 - at)) } else { all << (stride * at) & all }
}
