//! Vectors of sixteen with AVX-512: a register each, and masks of their own.

#![expect(clippy::needless_range_loop, reason = "a row indexes several arrays")]
#![expect(unsafe_code, reason = "vector instructions")]

use super::{Bits, LANES, Row, Simd};
use std::arch::x86_64::*;

/// AVX-512 F, DQ, BW and VL.
#[derive(Clone, Copy)]
pub struct Avx512(());

impl Avx512 {
    /// What proves that the processor has the instructions.
    ///
    /// # Safety
    /// It must have them.
    #[inline(always)]
    pub unsafe fn assume() -> Self {
        Self(())
    }
}

/// Calls intrinsics.
macro_rules! have {
    ($($body:tt)*) => {
        // SAFETY: a value of the type proves that the processor has the instructions; arrays are as large as vectors, and unaligned loads
        // and stores need no alignment.
        unsafe { $($body)* }
    };
}

impl Simd for Avx512 {
    type Ints = __m512i;
    type Floats = __m512;
    type Mask = __mmask16;
    type Table = __m512i;

    #[inline(always)]
    fn ints(self, value: i32) -> __m512i {
        have!(_mm512_set1_epi32(value))
    }
    #[inline(always)]
    fn floats(self, value: f32) -> __m512 {
        have!(_mm512_set1_ps(value))
    }
    #[inline(always)]
    fn load(self, values: &[i32; LANES]) -> __m512i {
        have!(_mm512_loadu_si512(values.as_ptr().cast()))
    }
    #[inline(always)]
    fn store(self, values: &mut [i32; LANES], vector: __m512i) {
        have!(_mm512_storeu_si512(values.as_mut_ptr().cast(), vector))
    }
    #[inline(always)]
    fn load_floats(self, values: &[f32; LANES]) -> __m512 {
        have!(_mm512_loadu_ps(values.as_ptr()))
    }
    #[inline(always)]
    unsafe fn gather(self, otherwise: __m512i, mask: __mmask16, index: __m512i, words: &[u32]) -> __m512i {
        super::check_gather(self, mask, index, words);
        have!(_mm512_mask_i32gather_epi32::<4>(otherwise, mask, index, words.as_ptr().cast()))
    }

    #[inline(always)]
    fn add(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_add_epi32(a, b))
    }
    #[inline(always)]
    fn sub(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_sub_epi32(a, b))
    }
    #[inline(always)]
    fn mul(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_mullo_epi32(a, b))
    }
    #[inline(always)]
    fn and(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_and_si512(a, b))
    }
    #[inline(always)]
    fn or(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_or_si512(a, b))
    }
    #[inline(always)]
    fn and_not(self, a: __m512i, b: __m512i) -> __m512i {
        have!(_mm512_andnot_si512(a, b))
    }
    #[inline(always)]
    fn shl(self, a: __m512i, n: u32) -> __m512i {
        have!(_mm512_sll_epi32(a, _mm_cvtsi32_si128(n as i32)))
    }
    #[inline(always)]
    fn shr(self, a: __m512i, n: u32) -> __m512i {
        have!(_mm512_sra_epi32(a, _mm_cvtsi32_si128(n as i32)))
    }
    #[inline(always)]
    fn shl_each(self, a: __m512i, n: __m512i) -> __m512i {
        have!(_mm512_sllv_epi32(a, n))
    }
    #[inline(always)]
    fn shr_each(self, a: __m512i, n: __m512i) -> __m512i {
        have!(_mm512_srav_epi32(a, n))
    }
    #[inline(always)]
    fn shr_each_unsigned(self, a: __m512i, n: __m512i) -> __m512i {
        have!(_mm512_srlv_epi32(a, n))
    }
    #[inline(always)]
    fn table(self, entries: &[i32; 8]) -> __m512i {
        have!(_mm512_castsi256_si512(_mm256_loadu_si256(entries.as_ptr().cast())))
    }
    #[inline(always)]
    fn choose(self, table: __m512i, index: __m512i) -> __m512i {
        have!(_mm512_permutexvar_epi32(index, table))
    }

    #[inline(always)]
    fn eq(self, a: __m512i, b: __m512i) -> __mmask16 {
        have!(_mm512_cmpeq_epi32_mask(a, b))
    }
    #[inline(always)]
    fn is_negative(self, a: __m512i) -> __mmask16 {
        have!(_mm512_movepi32_mask(a))
    }
    #[inline(always)]
    fn is_below(self, a: __m512i, b: __m512i) -> __mmask16 {
        have!(_mm512_cmplt_epu32_mask(a, b))
    }
    #[inline(always)]
    fn test(self, a: __m512i, b: __m512i) -> __mmask16 {
        have!(_mm512_test_epi32_mask(a, b))
    }

    #[inline(always)]
    fn add_floats(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_add_ps(a, b))
    }
    #[inline(always)]
    fn sub_floats(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul_floats(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_mul_ps(a, b))
    }
    #[inline(always)]
    fn div_floats(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_div_ps(a, b))
    }
    #[inline(always)]
    fn multiply_add(self, a: __m512, b: __m512, c: __m512) -> __m512 {
        have!(_mm512_fmadd_ps(a, b, c))
    }
    #[inline(always)]
    fn min(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_min_ps(a, b))
    }
    #[inline(always)]
    fn abs(self, a: __m512) -> __m512 {
        have!(_mm512_abs_ps(a))
    }
    #[inline(always)]
    fn eq_floats(self, a: __m512, b: __m512) -> __mmask16 {
        have!(_mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, b))
    }
    #[inline(always)]
    fn lt_floats(self, a: __m512, b: __m512) -> __mmask16 {
        have!(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b))
    }
    #[inline(always)]
    fn le_floats(self, a: __m512, b: __m512) -> __mmask16 {
        have!(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b))
    }
    #[inline(always)]
    fn to_floats(self, a: __m512i) -> __m512 {
        have!(_mm512_cvtepi32_ps(a))
    }
    #[inline(always)]
    fn nearest(self, a: __m512) -> __m512i {
        have!(_mm512_cvtps_epi32(a))
    }

    #[inline(always)]
    fn mask(self, bits: Bits) -> __mmask16 {
        bits
    }
    #[inline(always)]
    fn bits(self, mask: __mmask16) -> Bits {
        mask
    }
    #[inline(always)]
    fn both(self, a: __mmask16, b: __mmask16) -> __mmask16 {
        a & b
    }
    #[inline(always)]
    fn either(self, a: __mmask16, b: __mmask16) -> __mmask16 {
        a | b
    }
    #[inline(always)]
    fn except(self, a: __mmask16, b: __mmask16) -> __mmask16 {
        a & !b
    }
    #[inline(always)]
    fn any(self, mask: __mmask16) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn select(self, mask: __mmask16, yes: __m512i, no: __m512i) -> __m512i {
        have!(_mm512_mask_mov_epi32(no, mask, yes))
    }
    #[inline(always)]
    fn bits_of(self, a: __m512) -> __m512i {
        have!(_mm512_castps_si512(a))
    }
    #[inline(always)]
    fn floats_of(self, a: __m512i) -> __m512 {
        have!(_mm512_castsi512_ps(a))
    }
    #[inline(always)]
    fn max(self, a: __m512, b: __m512) -> __m512 {
        have!(_mm512_max_ps(a, b))
    }
    #[inline(always)]
    unsafe fn gather_records<const ROWS: usize>(
        self,
        number: __m512i,
        records: &[[Row; ROWS]],
    ) -> [[__m512i; 4]; ROWS] {
        let mut numbers = [0; LANES];
        self.store(&mut numbers, number);
        super::check_records(&numbers, records);
        // Rows of lanes i, i + 4, i + 8 and i + 12 side by side, so that a transposition within quarters leaves them in order.
        let mut four = [[self.floats(0.0); 4]; ROWS];
        for i in 0..4 {
            let mut at = [records.as_ptr(); 4];
            for quarter in 0..4 {
                // SAFETY: that the records are there is the caller's duty.
                at[quarter] = unsafe { records.as_ptr().add(numbers[i + 4 * quarter] as u32 as usize) };
            }
            for row in 0..ROWS {
                // SAFETY: as above, and as in `have`.
                four[row][i] = unsafe {
                    let vector = _mm512_castps128_ps512(_mm_loadu_ps(at[0].cast::<[f32; 4]>().add(row).cast()));
                    let vector =
                        _mm512_insertf32x4::<1>(vector, _mm_loadu_ps(at[1].cast::<[f32; 4]>().add(row).cast()));
                    let vector =
                        _mm512_insertf32x4::<2>(vector, _mm_loadu_ps(at[2].cast::<[f32; 4]>().add(row).cast()));
                    _mm512_insertf32x4::<3>(vector, _mm_loadu_ps(at[3].cast::<[f32; 4]>().add(row).cast()))
                };
            }
        }
        let mut words = [[self.ints(0); 4]; ROWS];
        for row in 0..ROWS {
            let [a, b, c, d] = four[row];
            words[row] = have! {
                let low = _mm512_castps_pd(_mm512_unpacklo_ps(a, b));
                let next_low = _mm512_castps_pd(_mm512_unpacklo_ps(c, d));
                let high = _mm512_castps_pd(_mm512_unpackhi_ps(a, b));
                let next_high = _mm512_castps_pd(_mm512_unpackhi_ps(c, d));
                [
                    _mm512_castpd_si512(_mm512_unpacklo_pd(low, next_low)),
                    _mm512_castpd_si512(_mm512_unpackhi_pd(low, next_low)),
                    _mm512_castpd_si512(_mm512_unpacklo_pd(high, next_high)),
                    _mm512_castpd_si512(_mm512_unpackhi_pd(high, next_high)),
                ]
            };
        }
        words
    }
    #[inline(always)]
    fn expand(self, lanes: &mut [i32; LANES], bits: Bits, values: &[i32; LANES]) {
        let filled = have!(_mm512_mask_expand_epi32(self.load(lanes), bits, self.load(values)));
        self.store(lanes, filled);
    }
    #[inline(always)]
    fn compress(self, lanes: &mut [i32; LANES], bits: Bits, values: __m512i) {
        self.store(lanes, have!(_mm512_maskz_compress_epi32(bits, values)));
    }
}
