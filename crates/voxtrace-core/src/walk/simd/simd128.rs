//! Vectors of sixteen with SIMD128 of WebAssembly: four registers each, the lowest lanes first. Lanes of a mask have all bits set. A module has these
//! instructions or not, as it was compiled: `-C target-feature=+simd128`.

#![expect(unsafe_code, reason = "vector instructions")]

use super::{Bits, LANES, Simd, quarters};
use std::arch::wasm32::*;

/// SIMD128 without its relaxed instructions, whose numbers differ from machine to machine.
#[derive(Clone, Copy)]
pub struct Simd128;

/// The bytes of an index among the bytes of a table of words.
const BYTES_OF_WORD: i32 = 0x0302_0100;

impl Simd for Simd128 {
    type Ints = [v128; 4];
    type Floats = [v128; 4];
    type Mask = [v128; 4];
    type Table = [v128; 2];

    #[inline(always)]
    fn ints(self, value: i32) -> [v128; 4] {
        [i32x4_splat(value); 4]
    }
    #[inline(always)]
    fn floats(self, value: f32) -> [v128; 4] {
        [f32x4_splat(value); 4]
    }
    #[inline(always)]
    fn load(self, values: &[i32; LANES]) -> [v128; 4] {
        let at = super::quarter_starts(values);
        // SAFETY: four values lie at the start of each quarter.
        quarters!(at => unsafe { v128_load(at.cast()) })
    }
    #[inline(always)]
    fn store(self, values: &mut [i32; LANES], vector: [v128; 4]) {
        for (values, vector) in values.chunks_exact_mut(4).zip(vector) {
            // SAFETY: there is room for four values.
            unsafe { v128_store(values.as_mut_ptr().cast(), vector) };
        }
    }
    #[inline(always)]
    fn load_floats(self, values: &[f32; LANES]) -> [v128; 4] {
        let at = super::quarter_starts(values);
        // SAFETY: four values lie at the start of each quarter.
        quarters!(at => unsafe { v128_load(at.cast()) })
    }
    #[inline(always)]
    unsafe fn gather(self, otherwise: [v128; 4], mask: [v128; 4], index: [v128; 4], words: &[u32]) -> [v128; 4] {
        super::check_gather(self, mask, index, words);
        // The lanes that are left out read the first word.
        let kept = quarters!(mask, index => v128_and(mask, index));
        let mut indices = [0; LANES];
        self.store(&mut indices, kept);
        // SAFETY: the caller's duty.
        let found = unsafe { super::read_each(&indices, words) };
        self.select(mask, self.load(&found), otherwise)
    }

    #[inline(always)]
    fn add(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => i32x4_add(a, b))
    }
    #[inline(always)]
    fn sub(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => i32x4_sub(a, b))
    }
    #[inline(always)]
    fn mul(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => i32x4_mul(a, b))
    }
    #[inline(always)]
    fn and(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_and(a, b))
    }
    #[inline(always)]
    fn or(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_or(a, b))
    }
    #[inline(always)]
    fn and_not(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_andnot(b, a))
    }
    #[inline(always)]
    fn shl(self, a: [v128; 4], n: u32) -> [v128; 4] {
        quarters!(a => i32x4_shl(a, n))
    }
    #[inline(always)]
    fn shr(self, a: [v128; 4], n: u32) -> [v128; 4] {
        quarters!(a => i32x4_shr(a, n))
    }
    #[inline(always)]
    fn shl_each(self, a: [v128; 4], n: [v128; 4]) -> [v128; 4] {
        quarters!(a, n => i32x4_mul(a, powers_of_two(n)))
    }
    #[inline(always)]
    fn shr_each(self, a: [v128; 4], n: [v128; 4]) -> [v128; 4] {
        quarters!(a, n => by_lanes(a, n, |a, n| a >> (n & 31)))
    }
    #[inline(always)]
    fn shr_each_unsigned(self, a: [v128; 4], n: [v128; 4]) -> [v128; 4] {
        quarters!(a, n => by_lanes(a, n, |a, n| (a as u32 >> (n & 31)) as i32))
    }
    #[inline(always)]
    fn table(self, entries: &[i32; 8]) -> [v128; 2] {
        let [low, high] = [entries.as_ptr(), entries[4..].as_ptr()];
        // SAFETY: four entries lie at each.
        unsafe { [v128_load(low.cast()), v128_load(high.cast())] }
    }
    #[inline(always)]
    fn choose(self, table: [v128; 2], index: [v128; 4]) -> [v128; 4] {
        quarters!(index => {
            let bytes = i32x4_add(i32x4_mul(index, i32x4_splat(0x0404_0404)), i32x4_splat(BYTES_OF_WORD));
            // A byte beyond the sixteen of a register is 0.
            let high = i8x16_swizzle(table[1], u8x16_sub(bytes, u8x16_splat(16)));
            v128_or(i8x16_swizzle(table[0], bytes), high)
        })
    }

    #[inline(always)]
    fn eq(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => i32x4_eq(a, b))
    }
    #[inline(always)]
    fn is_negative(self, a: [v128; 4]) -> [v128; 4] {
        quarters!(a => i32x4_shr(a, 31))
    }
    #[inline(always)]
    fn is_below(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => u32x4_lt(a, b))
    }
    #[inline(always)]
    fn test(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_not(i32x4_eq(v128_and(a, b), i32x4_splat(0))))
    }

    #[inline(always)]
    fn add_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_add(a, b))
    }
    #[inline(always)]
    fn sub_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_sub(a, b))
    }
    #[inline(always)]
    fn mul_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_mul(a, b))
    }
    #[inline(always)]
    fn div_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_div(a, b))
    }
    #[inline(always)]
    fn min(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        // `f32x4_min` gives no number where either is none.
        quarters!(a, b => f32x4_pmin(b, a))
    }
    #[inline(always)]
    fn abs(self, a: [v128; 4]) -> [v128; 4] {
        quarters!(a => f32x4_abs(a))
    }
    #[inline(always)]
    fn eq_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_eq(a, b))
    }
    #[inline(always)]
    fn lt_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_lt(a, b))
    }
    #[inline(always)]
    fn le_floats(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => f32x4_le(a, b))
    }
    #[inline(always)]
    fn to_floats(self, a: [v128; 4]) -> [v128; 4] {
        quarters!(a => f32x4_convert_i32x4(a))
    }
    #[inline(always)]
    fn nearest(self, a: [v128; 4]) -> [v128; 4] {
        quarters!(a => i32x4_trunc_sat_f32x4(f32x4_nearest(a)))
    }

    #[inline(always)]
    fn mask(self, bits: Bits) -> [v128; 4] {
        let of_lanes = self.load(&std::array::from_fn(|lane| 1 << lane));
        self.test(self.ints(i32::from(bits)), of_lanes)
    }
    #[inline(always)]
    fn bits(self, mask: [v128; 4]) -> Bits {
        let of_quarters = mask.map(|quarter| Bits::from(i32x4_bitmask(quarter)));
        of_quarters[0] | of_quarters[1] << 4 | of_quarters[2] << 8 | of_quarters[3] << 12
    }
    #[inline(always)]
    fn both(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_and(a, b))
    }
    #[inline(always)]
    fn either(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_or(a, b))
    }
    #[inline(always)]
    fn except(self, a: [v128; 4], b: [v128; 4]) -> [v128; 4] {
        quarters!(a, b => v128_andnot(a, b))
    }
    #[inline(always)]
    fn any(self, mask: [v128; 4]) -> bool {
        v128_any_true(v128_or(v128_or(mask[0], mask[1]), v128_or(mask[2], mask[3])))
    }
    #[inline(always)]
    fn select(self, mask: [v128; 4], yes: [v128; 4], no: [v128; 4]) -> [v128; 4] {
        quarters!(mask, yes, no => v128_bitselect(yes, no, mask))
    }
    #[inline(always)]
    fn bits_of(self, a: [v128; 4]) -> [v128; 4] {
        quarters!(a => a)
    }
    #[inline(always)]
    fn floats_of(self, a: [v128; 4]) -> [v128; 4] {
        a
    }
}

/// 2ⁿ of each lane, for n in 0..32: there is no shift of each lane by its own number. A float of that exponent is exact.
#[inline(always)]
fn powers_of_two(n: v128) -> v128 {
    u32x4_trunc_sat_f32x4(i32x4_shl(i32x4_add(n, i32x4_splat(127)), 23))
}

/// What `of` makes of each lane of both.
#[inline(always)]
fn by_lanes(a: v128, b: v128, of: impl Fn(i32, i32) -> i32) -> v128 {
    i32x4(
        of(i32x4_extract_lane::<0>(a), i32x4_extract_lane::<0>(b)),
        of(i32x4_extract_lane::<1>(a), i32x4_extract_lane::<1>(b)),
        of(i32x4_extract_lane::<2>(a), i32x4_extract_lane::<2>(b)),
        of(i32x4_extract_lane::<3>(a), i32x4_extract_lane::<3>(b)),
    )
}
