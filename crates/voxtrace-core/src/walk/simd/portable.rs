//! Vectors of sixteen as arrays, for processors without the instructions of the others: the compiler makes of them what there is, such as
//! NEON, and SIMD128 in the browser.

#![expect(unsafe_code, reason = "the contract of gathers")]

use super::{Bits, LANES, Simd};

/// An array of one expression in the number of a lane. Functions of the library that take closures are not inlined into large kernels.
macro_rules! lanes {
    ($i:ident => $body:expr) => {{
        let mut all = [Default::default(); LANES];
        for $i in 0..LANES {
            all[$i] = $body;
        }
        all
    }};
}

/// No instructions that not every processor has.
#[derive(Clone, Copy)]
pub struct Portable;

/// 1.5 × 2²³: added to a number, it leaves the nearest integer in the low bits.
const SHIFT: f32 = 12_582_912.0;
/// Far outside of every grid.
const LIMIT: f32 = 2_097_152.0;

impl Simd for Portable {
    type Ints = [i32; LANES];
    type Floats = [f32; LANES];
    type Mask = [i32; LANES];
    type Table = [i32; 8];

    #[inline(always)]
    fn ints(self, value: i32) -> [i32; LANES] {
        [value; LANES]
    }
    #[inline(always)]
    fn floats(self, value: f32) -> [f32; LANES] {
        [value; LANES]
    }
    #[inline(always)]
    fn load(self, values: &[i32; LANES]) -> [i32; LANES] {
        *values
    }
    #[inline(always)]
    fn store(self, values: &mut [i32; LANES], vector: [i32; LANES]) {
        *values = vector;
    }
    #[inline(always)]
    fn load_floats(self, values: &[f32; LANES]) -> [f32; LANES] {
        *values
    }
    #[inline(always)]
    unsafe fn gather(
        self,
        otherwise: [i32; LANES],
        mask: [i32; LANES],
        index: [i32; LANES],
        words: &[u32],
    ) -> [i32; LANES] {
        lanes!(i => if mask[i] != 0 { words[index[i] as usize] as i32 } else { otherwise[i] })
    }

    #[inline(always)]
    fn add(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i].wrapping_add(b[i]))
    }
    #[inline(always)]
    fn sub(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i].wrapping_sub(b[i]))
    }
    #[inline(always)]
    fn mul(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i].wrapping_mul(b[i]))
    }
    #[inline(always)]
    fn and(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i] & b[i])
    }
    #[inline(always)]
    fn or(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i] | b[i])
    }
    #[inline(always)]
    fn and_not(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => !a[i] & b[i])
    }
    #[inline(always)]
    fn shl(self, a: [i32; LANES], n: u32) -> [i32; LANES] {
        lanes!(i => a[i] << (n & 31))
    }
    #[inline(always)]
    fn shr(self, a: [i32; LANES], n: u32) -> [i32; LANES] {
        lanes!(i => a[i] >> (n & 31))
    }
    #[inline(always)]
    fn shl_each(self, a: [i32; LANES], n: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i] << (n[i] & 31))
    }
    #[inline(always)]
    fn shr_each(self, a: [i32; LANES], n: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i] >> (n[i] & 31))
    }
    #[inline(always)]
    fn shr_each_unsigned(self, a: [i32; LANES], n: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => (a[i] as u32 >> (n[i] & 31)) as i32)
    }
    #[inline(always)]
    fn table(self, entries: &[i32; 8]) -> [i32; 8] {
        *entries
    }
    #[inline(always)]
    fn choose(self, table: [i32; 8], index: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => table[index[i] as usize & 7])
    }

    #[inline(always)]
    fn eq(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] == b[i]))
    }
    #[inline(always)]
    fn is_negative(self, a: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] < 0))
    }
    #[inline(always)]
    fn is_below(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from((a[i] as u32) < b[i] as u32))
    }
    #[inline(always)]
    fn test(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] & b[i] != 0))
    }

    #[inline(always)]
    fn add_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i] + b[i])
    }
    #[inline(always)]
    fn sub_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i] - b[i])
    }
    #[inline(always)]
    fn mul_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i] * b[i])
    }
    #[inline(always)]
    fn div_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i] / b[i])
    }
    #[inline(always)]
    fn min(self, a: [f32; LANES], b: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => if a[i] < b[i] { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn abs(self, a: [f32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i].abs())
    }
    #[inline(always)]
    fn eq_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] == b[i]))
    }
    #[inline(always)]
    fn lt_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] < b[i]))
    }
    #[inline(always)]
    fn le_floats(self, a: [f32; LANES], b: [f32; LANES]) -> [i32; LANES] {
        lanes!(i => -i32::from(a[i] <= b[i]))
    }
    #[inline(always)]
    fn to_floats(self, a: [i32; LANES]) -> [f32; LANES] {
        lanes!(i => a[i] as f32)
    }
    #[inline(always)]
    fn nearest(self, a: [f32; LANES]) -> [i32; LANES] {
        lanes!(i => ((a[i].clamp(-LIMIT, LIMIT) + SHIFT).to_bits() as i32).wrapping_sub(SHIFT.to_bits() as i32))
    }

    #[inline(always)]
    fn mask(self, bits: Bits) -> [i32; LANES] {
        lanes!(i => -i32::from(bits >> i & 1))
    }
    #[inline(always)]
    fn bits(self, mask: [i32; LANES]) -> Bits {
        let mut bits = 0;
        for (i, lane) in mask.into_iter().enumerate() {
            bits |= (lane as Bits & 1) << i;
        }
        bits
    }
    #[inline(always)]
    fn both(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        self.and(a, b)
    }
    #[inline(always)]
    fn either(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        self.or(a, b)
    }
    #[inline(always)]
    fn except(self, a: [i32; LANES], b: [i32; LANES]) -> [i32; LANES] {
        self.and_not(b, a)
    }
    #[inline(always)]
    fn any(self, mask: [i32; LANES]) -> bool {
        let mut any = 0;
        for lane in mask {
            any |= lane;
        }
        any != 0
    }
    #[inline(always)]
    fn select(self, mask: [i32; LANES], yes: [i32; LANES], no: [i32; LANES]) -> [i32; LANES] {
        lanes!(i => (yes[i] & mask[i]) | (no[i] & !mask[i]))
    }
    #[inline(always)]
    fn bits_of(self, a: [f32; LANES]) -> [i32; LANES] {
        lanes!(i => a[i].to_bits() as i32)
    }
    #[inline(always)]
    fn floats_of(self, a: [i32; LANES]) -> [f32; LANES] {
        lanes!(i => f32::from_bits(a[i] as u32))
    }
}
