//! Vectors of sixteen: loads, stores and the few operations that everything here shares.

use std::arch::x86_64::*;

pub use crate::walk::simd::{LANES, lanes_of};

/// A bit for each lane.
pub type Mask = __mmask16;

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
