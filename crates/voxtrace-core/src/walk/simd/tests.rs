//! Every operation of every set of instructions gives what arrays give.

use super::{Bits, LANES, Portable, Simd};

/// SplitMix64 (Steele, Lea and Flood 2014).
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

/// What operations are tried with.
struct Input {
    ints: [[i32; LANES]; 2],
    small: [i32; LANES],
    floats: [[f32; LANES]; 2],
    bits: Bits,
    n: u32,
}

impl Input {
    /// Numbers of all sizes; extremes among them.
    fn new(state: &mut u64) -> Self {
        let ints = [0, -1, 1, i32::MIN, i32::MAX, 31];
        let floats = [0.0, -0.0, 0.5, -0.5, 1.5, 2.5, -2.5, 1e-30, 1_000_000.5, f32::INFINITY, f32::NAN];
        let mut int = || match random(state) {
            word if word % 4 == 0 => ints[(word >> 8) as usize % ints.len()],
            word => (word >> 32) as i32 >> (word >> 8 & 31),
        };
        let ints = [(); 2].map(|()| std::array::from_fn(|_| int()));
        let small = std::array::from_fn(|_| int() & 31);
        let mut float = || match random(state) {
            word if word % 4 == 0 => floats[(word >> 8) as usize % floats.len()],
            word => ((word >> 40) as f32 - 8_388_608.0) * [1.0, 0.125, 1e-3, 1e-6][(word >> 8) as usize & 3],
        };
        let floats = [(); 2].map(|()| std::array::from_fn(|_| float()));
        Self { ints, small, floats, bits: random(state) as Bits, n: random(state) as u32 & 31 }
    }
}

/// The results of all operations; floats as bits.
fn results<S: Simd>(s: S, input: &Input) -> Vec<[i32; LANES]> {
    let [a, b] = [s.load(&input.ints[0]), s.load(&input.ints[1])];
    let [x, y] = [s.load_floats(&input.floats[0]), s.load_floats(&input.floats[1])];
    let (small, mask, n) = (s.load(&input.small), s.mask(input.bits), input.n);
    let table = s.table(&[3, 1, 4, 1, -5, 9, 2, 6]);
    let seven = s.and(small, s.ints(7));
    let words: Vec<u32> = (0..32).map(|word| word * 0x0101_0101).collect();
    // SAFETY: the indices are below 32.
    let gathered = unsafe { s.gather(a, mask, small, &words) };
    let of_record =
        |row: u32| [[row, row << 8 | 1, row << 16 | 2, row << 24 | 3], [row ^ 4, row ^ 5, row ^ 6, row ^ 7]];
    // SAFETY: the numbers are below 32.
    let records = unsafe { s.gather_records(small, &(0..32).map(of_record).collect::<Vec<_>>()) };
    // What is no number is never rounded, and far from the grid only that matters.
    let near = s.min(s.abs(x), s.floats(2_000_000.0));
    // Of small integers, so that nothing is rounded.
    let sum = s.multiply_add(s.to_floats(small), s.to_floats(seven), s.floats(n as f32));
    let ints = [
        s.bits_of(sum),
        s.ints(n as i32),
        gathered,
        s.add(a, b),
        s.sub(a, b),
        s.mul(a, b),
        s.and(a, b),
        s.or(a, b),
        s.and_not(a, b),
        s.shl(a, n),
        s.shr(a, n),
        s.shl_each(a, small),
        s.shr_each(a, small),
        s.shr_each_unsigned(a, small),
        s.choose(table, seven),
        s.select(mask, a, b),
        bits_of(s, s.to_floats(a)),
        bits_of(s, s.add_floats(x, y)),
        bits_of(s, s.sub_floats(x, y)),
        bits_of(s, s.mul_floats(x, y)),
        bits_of(s, s.div_floats(x, y)),
        bits_of(s, s.min(x, y)),
        bits_of(s, s.max(x, y)),
        bits_of(s, s.select_floats(mask, x, y)),
        s.bits_of(s.floats_of(a)),
        bits_of(s, s.abs(x)),
        bits_of(s, s.floats(n as f32)),
        s.nearest(near),
    ];
    let masks = [
        mask,
        s.eq(s.and(a, s.ints(1)), s.and(b, s.ints(1))),
        s.is_negative(a),
        s.is_below(a, s.and(b, s.ints(i32::MAX))),
        s.test(a, small),
        s.eq_floats(x, s.select_floats(mask, x, y)),
        s.lt_floats(x, y),
        s.le_floats(x, y),
        s.both(mask, s.is_negative(a)),
        s.either(mask, s.is_negative(a)),
        s.except(mask, s.is_negative(a)),
    ];
    let mut all = Vec::new();
    for vector in ints.into_iter().chain(records.into_iter().flatten()) {
        let mut lanes = [0; LANES];
        s.store(&mut lanes, vector);
        all.push(lanes);
    }
    all.extend(masks.map(|mask| [i32::from(s.bits(mask)) | i32::from(s.any(mask)) << 16; LANES]));
    let mut lanes = input.ints[1];
    s.expand(&mut lanes, input.bits, &input.ints[0]);
    all.push(lanes);
    let mut lanes = [0; LANES];
    s.compress(&mut lanes, input.bits, a);
    lanes[input.bits.count_ones() as usize..].fill(0);
    all.push(lanes);
    all
}

/// The bits of floats, of any value that is no number the same.
fn bits_of<S: Simd>(s: S, floats: S::Floats) -> S::Ints {
    s.select(s.eq_floats(floats, floats), s.bits_of(floats), s.ints(-1))
}

/// Compares a set of instructions with arrays, which see some input one bit off where `is_spoiled`.
fn differs<S: Simd>(simd: S, is_spoiled: bool) -> bool {
    let mut state = 7;
    (0..2000).any(|_| {
        let mut input = Input::new(&mut state);
        let ours = results(simd, &input);
        input.ints[0][5] ^= i32::from(is_spoiled);
        ours != results(Portable, &input)
    })
}

#[test]
fn an_operation_that_differs_in_one_bit_is_noticed() {
    assert!(!differs(Portable, false) && differs(Portable, true));
}

#[test]
#[cfg(target_arch = "x86_64")]
fn registers_give_what_arrays_give() {
    use crate::walk::Instructions;
    if Instructions::Avx2.is_available() {
        // SAFETY: the processor has them.
        let avx2 = unsafe { super::Avx2::assume() };
        assert!(!differs(avx2, false) && differs(avx2, true));
    }
    if Instructions::Avx512.is_available() {
        // SAFETY: the processor has them.
        let avx512 = unsafe { super::Avx512::assume() };
        assert!(!differs(avx512, false) && differs(avx512, true));
    }
}

#[test]
#[cfg(target_arch = "aarch64")]
fn registers_give_what_arrays_give() {
    assert!(!differs(super::Neon, false) && differs(super::Neon, true));
}

#[test]
#[cfg(target_feature = "simd128")]
fn registers_give_what_arrays_give() {
    assert!(!differs(super::Simd128, false) && differs(super::Simd128, true));
}

#[test]
fn arrays_round_to_the_nearest_and_compare_as_numbers_do() {
    let mut values = [0.0; LANES];
    values[..8].copy_from_slice(&[0.5, 1.5, 2.5, -0.5, -1.5, 1_000_000.5, -7.25, 1e30]);
    let nearest = Portable.nearest(Portable.load_floats(&values));
    assert_eq!(nearest[..8], [0, 2, 2, 0, -2, 1_000_000, -7, 2_097_152]);
    let nan = Portable.floats(f32::NAN);
    assert!(!Portable.any(Portable.eq_floats(nan, nan)) && !Portable.any(Portable.le_floats(nan, nan)));
    assert_eq!(Portable.bits(Portable.is_below([-1, 0, 4, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 9], [5; LANES])), 0x7ff6);
}
