//! The skip distances of a cell as eight fields of three bits, one for each octant, compared all at once: every other field at a time, whose
//! neighbours leave room for what is borrowed (Lamport, "Multiple Byte Processing with Full-Word Instructions", CACM 1975).

use crate::packed::CELL_OCCUPIED;

/// Skip distances of a cell from which nothing is known to lie ahead.
pub(super) const LONGEST: u32 = 0o7777_7777;
/// The fields of octants 0, 2, 4 and 6.
const EVEN: u32 = 0o0707_0707;
/// The bit above each of them.
const ABOVE: u32 = 0o1010_1010;

/// The lesser of each two fields, of which every other one is empty.
#[inline(always)]
fn lesser_even(a: u32, b: u32) -> u32 {
    let is_b = ((a | ABOVE) - b) & ABOVE;
    a ^ ((a ^ b) & (is_b - (is_b >> 3)))
}

/// The lesser of each two fields of three bits.
#[inline(always)]
pub(super) fn lesser(a: u32, b: u32) -> u32 {
    lesser_even(a & EVEN, b & EVEN) | lesser_even(a >> 3 & EVEN, b >> 3 & EVEN) << 3
}

/// Whether no distance of those of some cells that are empty is longer than these.
#[inline(always)]
pub(super) fn are_within(cells: &[u32], longest: u32) -> bool {
    let (even, odd) = (longest & EVEN | ABOVE, longest >> 3 & EVEN | ABOVE);
    let mut within = ABOVE;
    for &cell in cells {
        let empty = cell & !((cell as i32 >> 31) as u32);
        within &= (even - (empty & EVEN)) & (odd - (empty >> 3 & EVEN));
    }
    within & ABOVE == ABOVE
}

/// Shortens the distances of those of some cells that are empty. Returns the first one that changed and one past the last.
#[inline(always)]
pub(super) fn shorten_cells(cells: &mut [u32], allowed: &[u32]) -> Option<(usize, usize)> {
    let shortened = |cell: u32, allowed: u32| {
        let is_full = (cell as i32 >> 31) as u32;
        lesser(cell, allowed) & !is_full | cell & is_full
    };
    let mut differ = 0;
    for (&cell, &allowed) in cells.iter().zip(allowed) {
        differ |= shortened(cell, allowed) ^ cell;
    }
    if differ == 0 {
        return None;
    }
    let mut range = (cells.len(), 0);
    for (at, (cell, &allowed)) in cells.iter_mut().zip(allowed).enumerate() {
        let now = shortened(*cell, allowed);
        if now != *cell {
            (*cell, range) = (now, (range.0.min(at), at + 1));
        }
    }
    Some(range)
}

const _: () = assert!(CELL_OCCUPIED == 1 << 31, "the sign says whether a cell is full");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_fields_are_compared_and_full_cells_stay() {
        let mut word = 1u32;
        let mut next = || {
            word = word.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            word >> 8
        };
        for _ in 0..10_000 {
            let (a, b) = (next(), next());
            let field = |word: u32, octant: u32| word >> (3 * octant) & 7;
            let expected: u32 = (0..8).map(|octant| field(a, octant).min(field(b, octant)) << (3 * octant)).sum();
            assert_eq!(lesser(a, b), expected);
            assert_eq!(are_within(&[a, CELL_OCCUPIED | LONGEST], b), a == expected);
            let mut cells = [a, CELL_OCCUPIED | a, LONGEST, 0];
            let was = cells;
            let range = shorten_cells(&mut cells, &[b, b, LONGEST, b]);
            assert_eq!(cells, [expected, was[1], LONGEST, 0]);
            assert_eq!(range, (a != expected).then_some((0, 1)));
        }
    }
}
