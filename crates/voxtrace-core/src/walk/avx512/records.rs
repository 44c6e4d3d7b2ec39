//! Between records in memory and a vector for each of their members.

use super::vectors::{LANES, load, load_wide, store};
use std::arch::x86_64::*;
use voxtrace_scene::ray::{Hit, Ray};

/// Words of sixteen rays: origin, t_min, direction, t_max.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn load_rays(rays: &[Ray; LANES]) -> [__m512; 8] {
    let halves: &[[f32; 4]; 2 * LANES] = bytemuck::cast_ref(rays);
    let mut words = [_mm512_setzero_ps(); 8];
    for half in 0..2 {
        // Rays i, i + 4, i + 8 and i + 12 …
        let four = each!(i in [0, 1, 2, 3] => {
            let quarter = |j: usize| {
                // SAFETY: the array is as large as the vector; unaligned loads need no alignment.
                unsafe { _mm_loadu_ps(halves[2 * (i + 4 * j) + half].as_ptr()) }
            };
            let vector = _mm512_castps128_ps512(quarter(0));
            let vector = _mm512_insertf32x4::<1>(vector, quarter(1));
            let vector = _mm512_insertf32x4::<2>(vector, quarter(2));
            _mm512_insertf32x4::<3>(vector, quarter(3))
        });
        // … so that a transposition within quarters leaves them in order.
        let low = each!(i in [0, 2] => _mm512_castps_pd(_mm512_unpacklo_ps(four[i], four[i + 1])));
        let high = each!(i in [0, 2] => _mm512_castps_pd(_mm512_unpackhi_ps(four[i], four[i + 1])));
        words[4 * half] = _mm512_castpd_ps(_mm512_unpacklo_pd(low[0], low[1]));
        words[4 * half + 1] = _mm512_castpd_ps(_mm512_unpackhi_pd(low[0], low[1]));
        words[4 * half + 2] = _mm512_castpd_ps(_mm512_unpacklo_pd(high[0], high[1]));
        words[4 * half + 3] = _mm512_castpd_ps(_mm512_unpackhi_pd(high[0], high[1]));
    }
    words
}

/// Writes sixteen hits: t, instance, voxel, face.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn store_hits(words: [__m512i; 6], hits: &mut [Hit; LANES]) {
    let out: &mut [[i32; LANES]; 6] = bytemuck::cast_mut(hits);
    for half in 0..2 {
        let pairing = load(&PAIRING[half]);
        let pairs = each!(i in [0, 2, 4] => _mm512_permutex2var_epi32(words[i], pairing, words[i + 1]));
        for (out, table) in out[3 * half..].iter_mut().zip(&ORDER) {
            let all = _mm512_permutex2var_epi64(pairs[0], load_wide(&table.first_two), pairs[1]);
            let all = _mm512_mask_permutexvar_epi64(all, table.is_third, load_wide(&table.third), pairs[2]);
            store(out, all);
        }
    }
}

/// The lanes of two vectors as pairs: of the lower eight lanes, of the upper.
static PAIRING: [[i32; LANES]; 2] = {
    let mut tables = [[0; LANES]; 2];
    let mut i = 0;
    while i < LANES {
        let lane = (i / 2 + LANES * (i % 2)) as i32;
        tables[0][i] = lane;
        tables[1][i] = lane + 8;
        i += 1;
    }
    tables
};

/// Which pairs follow each other in one of the three vectors that eight records of three pairs fill.
struct Order {
    /// Lanes of the first or the second pairs.
    first_two: [i64; 8],
    /// Lanes of the third pairs, and where they go.
    third: [i64; 8],
    is_third: __mmask8,
}

static ORDER: [Order; 3] = {
    const EMPTY: Order = Order { first_two: [0; 8], third: [0; 8], is_third: 0 };
    let mut tables = [EMPTY; 3];
    let mut at = 0;
    while at < 24 {
        let (table, lane, record, pair) = (at / 8, at % 8, at / 3, at % 3);
        if pair == 2 {
            tables[table].third[lane] = record as i64;
            tables[table].is_third |= 1 << lane;
        } else {
            tables[table].first_two[lane] = (record + 8 * pair) as i64;
        }
        at += 1;
    }
    tables
};
