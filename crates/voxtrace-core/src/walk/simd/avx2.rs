//! Vectors of sixteen with AVX2: two registers each, the lower lanes first. Lanes of a mask have all bits set.

#![expect(clippy::needless_range_loop, reason = "a row indexes several arrays")]
#![expect(unsafe_code, reason = "vector instructions")]

use super::{Bits, LANES, Row, Simd};
use std::arch::x86_64::*;

/// AVX2 with BMI. No product is fused with a sum: that would be other numbers.
#[derive(Clone, Copy)]
pub struct Avx2(());

impl Avx2 {
    /// What proves that the processor has the instructions.
    ///
    /// # Safety
    /// It must have them.
    #[inline(always)]
    pub unsafe fn assume() -> Self {
        Self(())
    }
}

/// A value of each half: of one expression, in which names in front of `in` stand for their halves.
macro_rules! halves {
    ($($name:ident),* => $body:expr) => {{
        let low = {
            $(let $name = $name[0];)*
            // SAFETY: a value of the type proves that the processor has the instructions.
            unsafe { $body }
        };
        let high = {
            $(let $name = $name[1];)*
            // SAFETY: as above.
            unsafe { $body }
        };
        [low, high]
    }};
}

impl Simd for Avx2 {
    type Ints = [__m256i; 2];
    type Floats = [__m256; 2];
    type Mask = [__m256i; 2];
    type Table = __m256i;

    #[inline(always)]
    fn ints(self, value: i32) -> [__m256i; 2] {
        halves!(=> _mm256_set1_epi32(value))
    }
    #[inline(always)]
    fn floats(self, value: f32) -> [__m256; 2] {
        halves!(=> _mm256_set1_ps(value))
    }
    #[inline(always)]
    fn load(self, values: &[i32; LANES]) -> [__m256i; 2] {
        let at = [values.as_ptr(), values[LANES / 2..].as_ptr()];
        halves!(at => _mm256_loadu_si256(at.cast()))
    }
    #[inline(always)]
    fn store(self, values: &mut [i32; LANES], vector: [__m256i; 2]) {
        let (low, high) = values.split_at_mut(LANES / 2);
        let at = [low.as_mut_ptr(), high.as_mut_ptr()];
        halves!(at, vector => _mm256_storeu_si256(at.cast(), vector));
    }
    #[inline(always)]
    fn load_floats(self, values: &[f32; LANES]) -> [__m256; 2] {
        let at = [values.as_ptr(), values[LANES / 2..].as_ptr()];
        halves!(at => _mm256_loadu_ps(at))
    }
    #[inline(always)]
    unsafe fn gather(
        self,
        otherwise: [__m256i; 2],
        mask: [__m256i; 2],
        index: [__m256i; 2],
        words: &[u32],
    ) -> [__m256i; 2] {
        super::check_gather(self, mask, index, words);
        let at = words.as_ptr().cast();
        halves!(otherwise, mask, index => _mm256_mask_i32gather_epi32::<4>(otherwise, at, index, mask))
    }

    #[inline(always)]
    fn add(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_add_epi32(a, b))
    }
    #[inline(always)]
    fn sub(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_sub_epi32(a, b))
    }
    #[inline(always)]
    fn mul(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_mullo_epi32(a, b))
    }
    #[inline(always)]
    fn and(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_and_si256(a, b))
    }
    #[inline(always)]
    fn or(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_or_si256(a, b))
    }
    #[inline(always)]
    fn and_not(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_andnot_si256(a, b))
    }
    #[inline(always)]
    fn shl(self, a: [__m256i; 2], n: u32) -> [__m256i; 2] {
        halves!(a => _mm256_sll_epi32(a, _mm_cvtsi32_si128(n as i32)))
    }
    #[inline(always)]
    fn shr(self, a: [__m256i; 2], n: u32) -> [__m256i; 2] {
        halves!(a => _mm256_sra_epi32(a, _mm_cvtsi32_si128(n as i32)))
    }
    #[inline(always)]
    fn shl_each(self, a: [__m256i; 2], n: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, n => _mm256_sllv_epi32(a, n))
    }
    #[inline(always)]
    fn shr_each(self, a: [__m256i; 2], n: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, n => _mm256_srav_epi32(a, n))
    }
    #[inline(always)]
    fn shr_each_unsigned(self, a: [__m256i; 2], n: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, n => _mm256_srlv_epi32(a, n))
    }
    #[inline(always)]
    fn table(self, entries: &[i32; 8]) -> __m256i {
        // SAFETY: as in `halves`; the array is as large as the register.
        unsafe { _mm256_loadu_si256(entries.as_ptr().cast()) }
    }
    #[inline(always)]
    fn choose(self, table: __m256i, index: [__m256i; 2]) -> [__m256i; 2] {
        halves!(index => _mm256_permutevar8x32_epi32(table, index))
    }

    #[inline(always)]
    fn eq(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_cmpeq_epi32(a, b))
    }
    #[inline(always)]
    fn is_negative(self, a: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a => _mm256_srai_epi32::<31>(a))
    }
    #[inline(always)]
    fn is_below(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        // What is negative is no less than b, since that is no more than `i32::MAX`.
        halves!(a, b => _mm256_andnot_si256(_mm256_srai_epi32::<31>(a), _mm256_cmpgt_epi32(b, a)))
    }
    #[inline(always)]
    fn test(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        halves!(a, b => {
            let is_zero = _mm256_cmpeq_epi32(_mm256_and_si256(a, b), _mm256_setzero_si256());
            _mm256_xor_si256(is_zero, _mm256_set1_epi32(-1))
        })
    }

    #[inline(always)]
    fn add_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_add_ps(a, b))
    }
    #[inline(always)]
    fn sub_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_mul_ps(a, b))
    }
    #[inline(always)]
    fn div_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_div_ps(a, b))
    }
    #[inline(always)]
    fn multiply_add(self, a: [__m256; 2], b: [__m256; 2], c: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b, c => _mm256_fmadd_ps(a, b, c))
    }
    #[inline(always)]
    fn min(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_min_ps(a, b))
    }
    #[inline(always)]
    fn abs(self, a: [__m256; 2]) -> [__m256; 2] {
        halves!(a => _mm256_andnot_ps(_mm256_set1_ps(-0.0), a))
    }
    #[inline(always)]
    fn eq_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_castps_si256(_mm256_cmp_ps::<_CMP_EQ_OQ>(a, b)))
    }
    #[inline(always)]
    fn lt_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b)))
    }
    #[inline(always)]
    fn le_floats(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256i; 2] {
        halves!(a, b => _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)))
    }
    #[inline(always)]
    fn to_floats(self, a: [__m256i; 2]) -> [__m256; 2] {
        halves!(a => _mm256_cvtepi32_ps(a))
    }
    #[inline(always)]
    fn nearest(self, a: [__m256; 2]) -> [__m256i; 2] {
        halves!(a => _mm256_cvtps_epi32(a))
    }

    #[inline(always)]
    fn mask(self, bits: Bits) -> [__m256i; 2] {
        let bits = [i32::from(bits & 0xff), i32::from(bits >> 8)];
        halves!(bits => {
            let own = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(bits), own), own)
        })
    }
    #[inline(always)]
    fn bits(self, mask: [__m256i; 2]) -> Bits {
        let [low, high] = halves!(mask => _mm256_movemask_ps(_mm256_castsi256_ps(mask)));
        low as Bits | (high as Bits) << 8
    }
    #[inline(always)]
    fn both(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        self.and(a, b)
    }
    #[inline(always)]
    fn either(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        self.or(a, b)
    }
    #[inline(always)]
    fn except(self, a: [__m256i; 2], b: [__m256i; 2]) -> [__m256i; 2] {
        self.and_not(b, a)
    }
    #[inline(always)]
    fn any(self, mask: [__m256i; 2]) -> bool {
        // SAFETY: as in `halves`.
        unsafe {
            let either = _mm256_or_si256(mask[0], mask[1]);
            _mm256_testz_si256(either, either) == 0
        }
    }
    #[inline(always)]
    fn select(self, mask: [__m256i; 2], yes: [__m256i; 2], no: [__m256i; 2]) -> [__m256i; 2] {
        halves!(mask, yes, no => _mm256_blendv_epi8(no, yes, mask))
    }
    #[inline(always)]
    fn bits_of(self, a: [__m256; 2]) -> [__m256i; 2] {
        halves!(a => _mm256_castps_si256(a))
    }
    #[inline(always)]
    fn floats_of(self, a: [__m256i; 2]) -> [__m256; 2] {
        halves!(a => _mm256_castsi256_ps(a))
    }
    #[inline(always)]
    fn max(self, a: [__m256; 2], b: [__m256; 2]) -> [__m256; 2] {
        halves!(a, b => _mm256_max_ps(a, b))
    }
    #[inline(always)]
    unsafe fn gather_records<const ROWS: usize>(
        self,
        number: [__m256i; 2],
        records: &[[Row; ROWS]],
    ) -> [[[__m256i; 2]; 4]; ROWS] {
        let mut numbers = [0; LANES];
        self.store(&mut numbers, number);
        super::check_records(&numbers, records);
        let mut words = [[self.ints(0); 4]; ROWS];
        for half in 0..2 {
            // Rows of lanes i and i + 4 of a half side by side, so that a transposition within quarters leaves them in order.
            let mut pairs = [[self.floats(0.0)[0]; 4]; ROWS];
            for i in 0..4 {
                let (near, far) = (numbers[8 * half + i], numbers[8 * half + i + 4]);
                // SAFETY: that the records are there is the caller's duty.
                let (near, far) =
                    unsafe { (records.as_ptr().add(near as u32 as usize), records.as_ptr().add(far as u32 as usize)) };
                for row in 0..ROWS {
                    // SAFETY: as above, and as in `halves`.
                    pairs[row][i] = unsafe {
                        let near = _mm_loadu_ps(near.cast::<[f32; 4]>().add(row).cast());
                        let far = _mm_loadu_ps(far.cast::<[f32; 4]>().add(row).cast());
                        _mm256_insertf128_ps::<1>(_mm256_castps128_ps256(near), far)
                    };
                }
            }
            for row in 0..ROWS {
                let [a, b, c, d] = pairs[row];
                // SAFETY: as in `halves`.
                unsafe {
                    let low = _mm256_castps_pd(_mm256_unpacklo_ps(a, b));
                    let next_low = _mm256_castps_pd(_mm256_unpacklo_ps(c, d));
                    let high = _mm256_castps_pd(_mm256_unpackhi_ps(a, b));
                    let next_high = _mm256_castps_pd(_mm256_unpackhi_ps(c, d));
                    words[row][0][half] = _mm256_castpd_si256(_mm256_unpacklo_pd(low, next_low));
                    words[row][1][half] = _mm256_castpd_si256(_mm256_unpackhi_pd(low, next_low));
                    words[row][2][half] = _mm256_castpd_si256(_mm256_unpacklo_pd(high, next_high));
                    words[row][3][half] = _mm256_castpd_si256(_mm256_unpackhi_pd(high, next_high));
                }
            }
        }
        words
    }
}
