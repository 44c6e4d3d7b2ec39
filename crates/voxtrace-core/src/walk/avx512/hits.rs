//! The hits of a packet: what [`exact::hit_of`](crate::walk::exact::hit_of) makes of ray and voxel, to the bit.

use super::cells::Map;
use super::packet::Packet;
use super::shared::Shared;
use super::vectors::{Mask, load, loadf};
use std::arch::x86_64::*;

/// The words of sixteen hits, one vector for each member: t, instance, voxel, face.
pub struct Hits(pub [__m512i; 6]);

impl Hits {
    /// All miss.
    #[inline]
    #[target_feature(enable = "avx512f")]
    pub fn misses() -> Self {
        let zero = _mm512_setzero_si512();
        let infinity = _mm512_castps_si512(_mm512_set1_ps(f32::INFINITY));
        Self([infinity, _mm512_set1_epi32(-1), zero, zero, zero, zero])
    }

    /// Adds what a packet hit.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn add(&mut self, shared: &Shared, map: &Map, packet: &Packet) {
        let at = each!(axis in [0, 1, 2] => load(&packet.at[axis]));
        // Turned, the ray enters every voxel through its lower planes.
        let entry = each!(axis in [0, 1, 2] => _mm512_add_epi32(at[axis], _mm512_set1_epi32(shared.grid[axis])));
        let lower = each!(axis in [0, 1, 2] => _mm512_castsi512_si256(entry[axis]));
        let upper = each!(axis in [0, 1, 2] => _mm512_extracti64x4_epi64::<1>(entry[axis]));
        let speed = each!(axis in [0, 1, 2] => loadf(&packet.speed[axis]));
        let lower_speed = each!(axis in [0, 1, 2] => _mm512_castps512_ps256(speed[axis]));
        let upper_speed = each!(axis in [0, 1, 2] => _mm512_extractf32x8_ps::<1>(speed[axis]));
        let (y_lower, z_lower) = last_crossed(shared, lower, lower_speed);
        let (y_upper, z_upper) = last_crossed(shared, upper, upper_speed);
        let is_y = Mask::from(y_lower) | Mask::from(y_upper) << 8;
        let is_z = Mask::from(z_lower) | Mask::from(z_upper) << 8;

        let t = each!(axis in [0, 1, 2] => {
            let distance = _mm512_sub_ps(_mm512_cvtepi32_ps(entry[axis]), _mm512_set1_ps(shared.turned[axis]));
            _mm512_mul_ps(distance, loadf(&packet.inverse[axis]))
        });
        let t = _mm512_mask_mov_ps(_mm512_mask_mov_ps(t[0], is_y, t[1]), is_z, t[2]);
        let face = each!(axis in [0, 1, 2] => _mm512_set1_epi32(2 * axis as i32 - shared.turn[axis]));
        let face = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(face[0], is_y, face[1]), is_z, face[2]);
        let t = _mm512_max_ps(t, _mm512_setzero_ps());
        let is_hit = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(packet.hit, t, loadf(&packet.t_max));
        let voxel = each!(axis in [0, 1, 2] => {
            let relative = _mm512_xor_si512(at[axis], _mm512_set1_epi32(shared.turn[axis]));
            _mm512_add_epi32(relative, _mm512_set1_epi32(map.grid().origin[axis]))
        });
        let words = [_mm512_castps_si512(t), _mm512_setzero_si512(), voxel[0], voxel[1], voxel[2], face];
        for (all, word) in self.0.iter_mut().zip(words) {
            *all = _mm512_mask_mov_epi32(*all, is_hit, word);
        }
    }
}

/// Lanes whose last crossing before the voxel is that of y, or of a later axis, and those where it is that of z.
#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
fn last_crossed(shared: &Shared, entry: [__m256i; 3], speed: [__m256; 3]) -> (__mmask8, __mmask8) {
    let distance = each!(axis in [0, 1, 2] => _mm512_sub_pd(_mm512_cvtepi32_pd(entry[axis]), _mm512_set1_pd(f64::from(shared.turned[axis]))));
    let speed = each!(speed in [speed[0], speed[1], speed[2]] => _mm512_cvtps_pd(speed));
    let is_before = |distance: __m512d, speed: __m512d, other: __m512d, other_speed: __m512d| {
        _mm512_cmp_pd_mask::<_CMP_LT_OQ>(_mm512_mul_pd(distance, other_speed), _mm512_mul_pd(other, speed))
    };
    let is_y = !is_before(distance[1], speed[1], distance[0], speed[0]);
    let last = _mm512_mask_mov_pd(distance[0], is_y, distance[1]);
    let last_speed = _mm512_mask_mov_pd(speed[0], is_y, speed[1]);
    (is_y, !is_before(distance[2], speed[2], last, last_speed))
}
