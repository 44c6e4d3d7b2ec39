//! Vectors of sixteen: loads, stores and the few operations that everything here shares.

use std::arch::x86_64::*;

/// Rays, or other things, that one vector holds.
pub const LANES: usize = 16;

/// A bit for each lane.
pub type Mask = __mmask16;

/// The set lanes of a mask.
#[inline(always)]
pub fn lanes_of(mut mask: Mask) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

/// The lanes of an array.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn load(values: &[i32; LANES]) -> __m512i {
    // SAFETY: the array is as large as the vector; unaligned loads need no alignment.
    unsafe { _mm512_loadu_si512(values.as_ptr().cast()) }
}

/// The lanes of an array.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn loadf(values: &[f32; LANES]) -> __m512 {
    // SAFETY: as in `load`.
    unsafe { _mm512_loadu_ps(values.as_ptr()) }
}

/// The lanes of an array of eight.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn load_wide(values: &[i64; LANES / 2]) -> __m512i {
    // SAFETY: as in `load`.
    unsafe { _mm512_loadu_si512(values.as_ptr().cast()) }
}

/// Writes the lanes to an array.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn store(values: &mut [i32; LANES], vector: __m512i) {
    // SAFETY: as in `load`.
    unsafe { _mm512_storeu_si512(values.as_mut_ptr().cast(), vector) }
}

/// Writes the lanes to an array.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn storef(values: &mut [f32; LANES], vector: __m512) {
    // SAFETY: as in `load`.
    unsafe { _mm512_storeu_ps(values.as_mut_ptr(), vector) }
}

/// `words[index]` for the lanes of `mask`, `otherwise` for the rest.
///
/// # Safety
/// The indices of the lanes of `mask` must lie inside `words`.
#[inline]
#[target_feature(enable = "avx512f")]
pub unsafe fn gather(otherwise: __m512i, mask: Mask, index: __m512i, words: &[u32]) -> __m512i {
    // Sanitizers do not see what a gather reads.
    debug_assert!(are_inside(mask, index, words.len()), "a gather leads outside of its array");
    // SAFETY: the caller's duty.
    unsafe { _mm512_mask_i32gather_epi32::<4>(otherwise, mask, index, words.as_ptr().cast()) }
}

/// Whether the indices of the lanes of `mask` lie below `length`.
#[target_feature(enable = "avx512f")]
fn are_inside(mask: Mask, index: __m512i, length: usize) -> bool {
    let mut indices = [0; LANES];
    store(&mut indices, index);
    lanes_of(mask).all(|lane| usize::try_from(indices[lane]).is_ok_and(|index| index < length))
}

/// Bitwise or of three.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn or3(a: __m512i, b: __m512i, c: __m512i) -> __m512i {
    _mm512_ternarylogic_epi32::<0xfe>(a, b, c)
}

/// The value in the lowest lane of a mask.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn first_of(mask: Mask, values: __m512i) -> i32 {
    _mm_cvtsi128_si32(_mm512_castsi512_si128(_mm512_maskz_compress_epi32(mask, values)))
}

/// The largest integers that are not larger.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn floor(values: __m512) -> __m512i {
    _mm512_cvt_roundps_epi32::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(values)
}
