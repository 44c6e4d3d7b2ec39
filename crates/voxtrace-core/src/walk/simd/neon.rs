//! Vectors of sixteen with NEON, which every 64-bit ARM processor has: four registers each, the lowest lanes first. Lanes of a mask have all bits set.

#![expect(unsafe_code, reason = "vector instructions")]

use super::{Bits, LANES, Simd, quarters};
use std::arch::aarch64::*;

/// NEON. No product is fused with a sum: that would be other numbers.
#[derive(Clone, Copy)]
pub struct Neon;

/// A value of each quarter, as `quarters`, of instructions of NEON.
macro_rules! neon {
    ($($name:ident),* => $body:expr) => {
        quarters!($($name),* => {
            // SAFETY: every 64-bit ARM processor has NEON; what is read or written is said at the pointer.
            unsafe { $body }
        })
    };
}

/// The bytes of an index among the bytes of a table of words.
const BYTES_OF_WORD: i32 = 0x0302_0100;

impl Simd for Neon {
    type Ints = [int32x4_t; 4];
    type Floats = [float32x4_t; 4];
    type Mask = [uint32x4_t; 4];
    type Table = uint8x16x2_t;

    #[inline(always)]
    fn ints(self, value: i32) -> [int32x4_t; 4] {
        neon!(=> vdupq_n_s32(value))
    }
    #[inline(always)]
    fn floats(self, value: f32) -> [float32x4_t; 4] {
        neon!(=> vdupq_n_f32(value))
    }
    #[inline(always)]
    fn load(self, values: &[i32; LANES]) -> [int32x4_t; 4] {
        let at = super::quarter_starts(values);
        // Four values lie at each.
        neon!(at => vld1q_s32(at))
    }
    #[inline(always)]
    fn store(self, values: &mut [i32; LANES], vector: [int32x4_t; 4]) {
        for (values, vector) in values.chunks_exact_mut(4).zip(vector) {
            // SAFETY: there is room for four values.
            unsafe { vst1q_s32(values.as_mut_ptr(), vector) };
        }
    }
    #[inline(always)]
    fn load_floats(self, values: &[f32; LANES]) -> [float32x4_t; 4] {
        let at = super::quarter_starts(values);
        // Four values lie at each.
        neon!(at => vld1q_f32(at))
    }
    #[inline(always)]
    unsafe fn gather(
        self,
        otherwise: [int32x4_t; 4],
        mask: [uint32x4_t; 4],
        index: [int32x4_t; 4],
        words: &[u32],
    ) -> [int32x4_t; 4] {
        super::check_gather(self, mask, index, words);
        // The lanes that are left out read the first word.
        let kept = neon!(mask, index => vandq_s32(vreinterpretq_s32_u32(mask), index));
        let mut indices = [0; LANES];
        self.store(&mut indices, kept);
        // SAFETY: the caller's duty.
        let found = unsafe { super::read_each(&indices, words) };
        self.select(mask, self.load(&found), otherwise)
    }

    #[inline(always)]
    fn add(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vaddq_s32(a, b))
    }
    #[inline(always)]
    fn sub(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vsubq_s32(a, b))
    }
    #[inline(always)]
    fn mul(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vmulq_s32(a, b))
    }
    #[inline(always)]
    fn and(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vandq_s32(a, b))
    }
    #[inline(always)]
    fn or(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vorrq_s32(a, b))
    }
    #[inline(always)]
    fn and_not(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, b => vbicq_s32(b, a))
    }
    #[inline(always)]
    fn shl(self, a: [int32x4_t; 4], n: u32) -> [int32x4_t; 4] {
        neon!(a => vshlq_s32(a, vdupq_n_s32(n as i32)))
    }
    #[inline(always)]
    fn shr(self, a: [int32x4_t; 4], n: u32) -> [int32x4_t; 4] {
        neon!(a => vshlq_s32(a, vdupq_n_s32(-(n as i32))))
    }
    #[inline(always)]
    fn shl_each(self, a: [int32x4_t; 4], n: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, n => vshlq_s32(a, n))
    }
    #[inline(always)]
    fn shr_each(self, a: [int32x4_t; 4], n: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, n => vshlq_s32(a, vnegq_s32(n)))
    }
    #[inline(always)]
    fn shr_each_unsigned(self, a: [int32x4_t; 4], n: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a, n => vreinterpretq_s32_u32(vshlq_u32(vreinterpretq_u32_s32(a), vnegq_s32(n))))
    }
    #[inline(always)]
    fn table(self, entries: &[i32; 8]) -> uint8x16x2_t {
        let at = entries.as_ptr().cast();
        // SAFETY: the array has the bytes of two registers.
        unsafe { vld1q_u8_x2(at) }
    }
    #[inline(always)]
    fn choose(self, table: uint8x16x2_t, index: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(index => {
            let bytes = vmlaq_s32(vdupq_n_s32(BYTES_OF_WORD), index, vdupq_n_s32(0x0404_0404));
            vreinterpretq_s32_u8(vqtbl2q_u8(table, vreinterpretq_u8_s32(bytes)))
        })
    }

    #[inline(always)]
    fn eq(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vceqq_s32(a, b))
    }
    #[inline(always)]
    fn is_negative(self, a: [int32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a => vcltzq_s32(a))
    }
    #[inline(always)]
    fn is_below(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vcltq_u32(vreinterpretq_u32_s32(a), vreinterpretq_u32_s32(b)))
    }
    #[inline(always)]
    fn test(self, a: [int32x4_t; 4], b: [int32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vtstq_s32(a, b))
    }

    #[inline(always)]
    fn add_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a, b => vaddq_f32(a, b))
    }
    #[inline(always)]
    fn sub_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a, b => vsubq_f32(a, b))
    }
    #[inline(always)]
    fn mul_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a, b => vmulq_f32(a, b))
    }
    #[inline(always)]
    fn div_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a, b => vdivq_f32(a, b))
    }
    #[inline(always)]
    fn min(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [float32x4_t; 4] {
        // `vminq_f32` gives no number where either is none.
        neon!(a, b => vbslq_f32(vcltq_f32(a, b), a, b))
    }
    #[inline(always)]
    fn abs(self, a: [float32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a => vabsq_f32(a))
    }
    #[inline(always)]
    fn eq_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vceqq_f32(a, b))
    }
    #[inline(always)]
    fn lt_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vcltq_f32(a, b))
    }
    #[inline(always)]
    fn le_floats(self, a: [float32x4_t; 4], b: [float32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vcleq_f32(a, b))
    }
    #[inline(always)]
    fn to_floats(self, a: [int32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a => vcvtq_f32_s32(a))
    }
    #[inline(always)]
    fn nearest(self, a: [float32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a => vcvtnq_s32_f32(a))
    }

    #[inline(always)]
    fn mask(self, bits: Bits) -> [uint32x4_t; 4] {
        let of_lanes = self.load(&std::array::from_fn(|lane| 1 << lane));
        self.test(self.ints(i32::from(bits)), of_lanes)
    }
    #[inline(always)]
    fn bits(self, mask: [uint32x4_t; 4]) -> Bits {
        // A number for each lane, a bit of it; their sum is that of a quarter.
        let of_lanes = [1, 2, 4, 8];
        let sums = neon!(mask => vaddvq_u32(vandq_u32(mask, vld1q_u32(of_lanes.as_ptr()))));
        (sums[0] | sums[1] << 4 | sums[2] << 8 | sums[3] << 12) as Bits
    }
    #[inline(always)]
    fn both(self, a: [uint32x4_t; 4], b: [uint32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vandq_u32(a, b))
    }
    #[inline(always)]
    fn either(self, a: [uint32x4_t; 4], b: [uint32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vorrq_u32(a, b))
    }
    #[inline(always)]
    fn except(self, a: [uint32x4_t; 4], b: [uint32x4_t; 4]) -> [uint32x4_t; 4] {
        neon!(a, b => vbicq_u32(a, b))
    }
    #[inline(always)]
    fn any(self, mask: [uint32x4_t; 4]) -> bool {
        // SAFETY: every 64-bit ARM processor has NEON.
        unsafe { vmaxvq_u32(vorrq_u32(vorrq_u32(mask[0], mask[1]), vorrq_u32(mask[2], mask[3]))) != 0 }
    }
    #[inline(always)]
    fn select(self, mask: [uint32x4_t; 4], yes: [int32x4_t; 4], no: [int32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(mask, yes, no => vbslq_s32(mask, yes, no))
    }
    #[inline(always)]
    fn bits_of(self, a: [float32x4_t; 4]) -> [int32x4_t; 4] {
        neon!(a => vreinterpretq_s32_f32(a))
    }
    #[inline(always)]
    fn floats_of(self, a: [int32x4_t; 4]) -> [float32x4_t; 4] {
        neon!(a => vreinterpretq_f32_s32(a))
    }
}
