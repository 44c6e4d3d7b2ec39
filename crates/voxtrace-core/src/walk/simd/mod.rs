//! Vectors of sixteen numbers, by the instructions that a processor has: what is written over them walks on all of them alike. The same numbers
//! come out everywhere: each operation is exact, or one rounding of IEEE 754.

#![expect(unsafe_code, reason = "the contract of gathers")]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "aarch64")]
mod neon;
// Modules for pages have no second copy of the walk.
#[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
mod portable;
#[cfg(target_feature = "simd128")]
mod simd128;

#[cfg(target_arch = "x86_64")]
pub use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub use avx512::Avx512;
#[cfg(target_arch = "aarch64")]
pub use neon::Neon;
#[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
pub use portable::Portable;
#[cfg(target_feature = "simd128")]
pub use simd128::Simd128;

/// Numbers in a vector.
pub const LANES: usize = 16;

/// A bit for each lane.
pub type Bits = u16;

/// Four words of a record.
pub type Row = [u32; 4];

/// Lets the processor fetch what lies at a place, without waiting for it. The place need not exist.
#[inline(always)]
pub fn prefetch<T>(place: *const T) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: every processor of this kind has the instruction, and it reads nothing.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = place;
}

/// A set of instructions. A value of it proves that the processor has them.
///
/// Whatever is generic over it is `#[inline(always)]` down from one function that is compiled for the instructions: only there do they become
/// single instructions.
pub trait Simd: Copy {
    /// Sixteen `i32`; sums and products wrap.
    type Ints: Copy;
    /// Sixteen `f32`.
    type Floats: Copy;
    /// Sixteen answers.
    type Mask: Copy;
    /// Eight `i32` to choose from.
    type Table: Copy;

    /// One number in all lanes.
    fn ints(self, value: i32) -> Self::Ints;
    /// One number in all lanes.
    fn floats(self, value: f32) -> Self::Floats;
    /// The lanes of an array.
    fn load(self, values: &[i32; LANES]) -> Self::Ints;
    /// Writes the lanes to an array.
    fn store(self, values: &mut [i32; LANES], vector: Self::Ints);
    /// The lanes of an array.
    fn load_floats(self, values: &[f32; LANES]) -> Self::Floats;
    /// `words[index]` for the lanes of `mask`, `otherwise` for the rest.
    ///
    /// # Safety
    /// The indices of the lanes of `mask` must lie inside `words`, and be positive as `i32`.
    unsafe fn gather(self, otherwise: Self::Ints, mask: Self::Mask, index: Self::Ints, words: &[u32]) -> Self::Ints;

    /// a + b.
    fn add(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// a − b.
    fn sub(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// a × b.
    fn mul(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// Bits of both.
    fn and(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// Bits of either.
    fn or(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// Bits of b that a has not.
    fn and_not(self, a: Self::Ints, b: Self::Ints) -> Self::Ints;
    /// a × 2ⁿ.
    fn shl(self, a: Self::Ints, n: u32) -> Self::Ints;
    /// a ÷ 2ⁿ, downwards.
    fn shr(self, a: Self::Ints, n: u32) -> Self::Ints;
    /// a × 2ⁿ, lane by lane.
    fn shl_each(self, a: Self::Ints, n: Self::Ints) -> Self::Ints;
    /// a ÷ 2ⁿ, downwards, lane by lane.
    fn shr_each(self, a: Self::Ints, n: Self::Ints) -> Self::Ints;
    /// a ÷ 2ⁿ of numbers without a sign, lane by lane.
    fn shr_each_unsigned(self, a: Self::Ints, n: Self::Ints) -> Self::Ints;
    /// A table for [`Self::choose`].
    fn table(self, entries: &[i32; 8]) -> Self::Table;
    /// The entry of an index in 0..8.
    fn choose(self, table: Self::Table, index: Self::Ints) -> Self::Ints;

    /// a = b.
    fn eq(self, a: Self::Ints, b: Self::Ints) -> Self::Mask;
    /// a < 0.
    fn is_negative(self, a: Self::Ints) -> Self::Mask;
    /// 0 ≤ a < b, where b is at most `i32::MAX`.
    fn is_below(self, a: Self::Ints, b: Self::Ints) -> Self::Mask;
    /// Whether a and b share a bit.
    fn test(self, a: Self::Ints, b: Self::Ints) -> Self::Mask;

    /// a + b.
    fn add_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Floats;
    /// a − b.
    fn sub_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Floats;
    /// a × b.
    fn mul_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Floats;
    /// a ÷ b.
    fn div_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Floats;
    /// a × b + c, rounded once or twice: for bounds that are wide enough for either.
    #[inline(always)]
    fn multiply_add(self, a: Self::Floats, b: Self::Floats, c: Self::Floats) -> Self::Floats {
        self.add_floats(self.mul_floats(a, b), c)
    }
    /// The lesser one; b where one is no number.
    fn min(self, a: Self::Floats, b: Self::Floats) -> Self::Floats;
    /// |a|.
    fn abs(self, a: Self::Floats) -> Self::Floats;
    /// a = b.
    fn eq_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Mask;
    /// a < b.
    fn lt_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Mask;
    /// a ≤ b.
    fn le_floats(self, a: Self::Floats, b: Self::Floats) -> Self::Mask;
    /// The nearest floats.
    fn to_floats(self, a: Self::Ints) -> Self::Floats;
    /// The nearest integers, the even one of two. What is beyond ±2²¹ becomes some number beyond.
    fn nearest(self, a: Self::Floats) -> Self::Ints;

    /// The mask of bits.
    fn mask(self, bits: Bits) -> Self::Mask;
    /// The bits of a mask.
    fn bits(self, mask: Self::Mask) -> Bits;
    /// Lanes of both.
    fn both(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Lanes of either.
    fn either(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Lanes of a that b has not.
    fn except(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Whether there is a lane.
    fn any(self, mask: Self::Mask) -> bool;
    /// The bits of floats.
    fn bits_of(self, a: Self::Floats) -> Self::Ints;
    /// The floats of bits.
    fn floats_of(self, a: Self::Ints) -> Self::Floats;
    /// `yes` in the lanes of a mask, `no` in the rest.
    fn select(self, mask: Self::Mask, yes: Self::Ints, no: Self::Ints) -> Self::Ints;

    /// `yes` in the lanes of a mask, `no` in the rest.
    #[inline(always)]
    fn select_floats(self, mask: Self::Mask, yes: Self::Floats, no: Self::Floats) -> Self::Floats {
        self.floats_of(self.select(mask, self.bits_of(yes), self.bits_of(no)))
    }

    /// The greater one; b where one is no number.
    #[inline(always)]
    fn max(self, a: Self::Floats, b: Self::Floats) -> Self::Floats {
        self.select_floats(self.lt_floats(b, a), a, b)
    }

    /// The words of the record of each lane, which is some rows long: one vector for each.
    ///
    /// # Safety
    /// The numbers of records, of all lanes, must lie inside `records`.
    #[inline(always)]
    unsafe fn gather_records<const ROWS: usize>(
        self,
        number: Self::Ints,
        records: &[[Row; ROWS]],
    ) -> [[Self::Ints; 4]; ROWS] {
        let mut numbers = [0; LANES];
        self.store(&mut numbers, number);
        let mut all = [[self.ints(0); 4]; ROWS];
        for row in 0..ROWS {
            for word in 0..4 {
                let mut words = [0; LANES];
                for lane in 0..LANES {
                    words[lane] = records[numbers[lane] as u32 as usize][row][word] as i32;
                }
                all[row][word] = self.load(&words);
            }
        }
        all
    }

    /// Puts the first values, in order, into the lanes of `bits`.
    #[inline(always)]
    fn expand(self, lanes: &mut [i32; LANES], bits: Bits, values: &[i32; LANES]) {
        for (lane, value) in lanes_of(bits).zip(values) {
            lanes[lane] = *value;
        }
    }

    /// The lanes of `bits`, in order, in the first lanes of an array; what is in the others is undefined.
    #[inline(always)]
    fn compress(self, lanes: &mut [i32; LANES], bits: Bits, values: Self::Ints) {
        let mut all = [0; LANES];
        self.store(&mut all, values);
        for (place, lane) in lanes.iter_mut().zip(lanes_of(bits)) {
            *place = all[lane];
        }
    }
}

/// The set lanes of a mask.
#[inline(always)]
pub fn lanes_of(mut bits: Bits) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

/// The vector of an array that begins at `start`; such arrays are a vector longer than what they hold.
#[inline(always)]
pub fn window<T, const N: usize>(values: &[T; N], start: usize) -> &[T; LANES] {
    values[start..].first_chunk().expect("arrays are a vector longer than what they hold")
}

/// The same, to be written.
#[inline(always)]
pub fn window_mut<T, const N: usize>(values: &mut [T; N], start: usize) -> &mut [T; LANES] {
    values[start..].first_chunk_mut().expect("arrays are a vector longer than what they hold")
}

/// A value of each quarter: of one expression, in which names in front of `=>` stand for their quarters.
#[cfg(any(target_arch = "aarch64", target_feature = "simd128"))]
macro_rules! quarters {
    ($($name:ident),* => $body:expr) => {
        [
            { $(let $name = $name[0];)* $body },
            { $(let $name = $name[1];)* $body },
            { $(let $name = $name[2];)* $body },
            { $(let $name = $name[3];)* $body },
        ]
    };
}
#[cfg(any(target_arch = "aarch64", target_feature = "simd128"))]
use quarters;

/// Where the four values of each quarter lie.
#[cfg(any(target_arch = "aarch64", target_feature = "simd128"))]
#[inline(always)]
fn quarter_starts<T>(values: &[T; LANES]) -> [*const T; 4] {
    std::array::from_fn(|quarter| values[4 * quarter..].as_ptr())
}

/// The words at all indices; zeros where there is no word.
///
/// # Safety
/// The indices must lie inside `words`, unless that is empty.
#[cfg(any(target_arch = "aarch64", target_feature = "simd128"))]
#[inline(always)]
unsafe fn read_each(indices: &[i32; LANES], words: &[u32]) -> [i32; LANES] {
    if words.is_empty() {
        return [0; LANES];
    }
    // SAFETY: the caller's duty.
    indices.map(|index| unsafe { *words.get_unchecked(index as usize) } as i32)
}

/// Where debug assertions are on: whether all numbers of records lie inside `records`.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn check_records<T>(numbers: &[i32; LANES], records: &[T]) {
    if cfg!(debug_assertions) {
        let is_inside = |&number: &i32| (number as u32 as usize) < records.len();
        assert!(numbers.iter().all(is_inside), "a record lies outside of its array");
    }
}

/// Where debug assertions are on: whether the indices of the lanes of `mask` lie inside `words`. Sanitizers do not see what a gather reads.
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128"))]
#[inline(always)]
fn check_gather<S: Simd>(simd: S, mask: S::Mask, index: S::Ints, words: &[u32]) {
    if cfg!(debug_assertions) {
        let mut indices = [0; LANES];
        simd.store(&mut indices, index);
        let is_inside = |lane: usize| usize::try_from(indices[lane]).is_ok_and(|index| index < words.len());
        assert!(lanes_of(simd.bits(mask)).all(is_inside), "a gather leads outside of its array");
    }
}

#[cfg(test)]
mod tests;
