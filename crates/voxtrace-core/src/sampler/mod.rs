//! Random numbers as a pure function of (seed, pixel, sample, dimension), so that any order of work gives the same
//! numbers (a counter-based generator): independent ones by the hash pcg4d (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020),
//! and low-discrepancy ones by the Sobol sequence with Owen scrambling by a hash (Burley, "Practical Hash-based Owen
//! Scrambling", JCGT 9(4), 2020).

pub(crate) mod many;

/// The random numbers of one sample of one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampler {
    /// Seed of the frame.
    pub seed: u32,
    /// Index of the pixel in the whole picture, row by row.
    pub pixel: u32,
    /// Index of the sample.
    pub sample: u32,
}

impl Sampler {
    /// The four numbers in [0, 1) of a dimension, independent of those of every other dimension, sample, pixel and
    /// seed.
    #[inline]
    pub fn independent(&self, dimension: u32) -> [f32; 4] {
        self.independent_here(dimension)
    }

    /// The same, a part of the caller's code: of a loop over many, of which compilers make vectors.
    #[inline(always)]
    fn independent_here(&self, dimension: u32) -> [f32; 4] {
        // Word by word: compilers make calls of `map`.
        let [x, y, z, w] = pcg4d([self.pixel, self.sample, dimension, self.seed]);
        [unit_f32(x), unit_f32(y), unit_f32(z), unit_f32(w)]
    }

    /// Four numbers in [0, 1) of a dimension. The first two, and the last two, of consecutive samples of a pixel are
    /// low-discrepancy points of the unit square, each by itself uniform; pairs, dimensions, pixels and seeds are independent.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline)]
    pub fn stratified(&self, dimension: u32) -> [f32; 4] {
        self.stratified_here(dimension)
    }

    /// The same, a part of the caller's code.
    #[inline(always)]
    fn stratified_here(&self, dimension: u32) -> [f32; 4] {
        // Samples are numbered from 0 in `independent`'s third place, dimensions here in its second: 1 and 2 keep the
        // inputs of the two apart.
        let ([a, b], [c, d]) = (self.pair(dimension, 1), self.pair(dimension, 2));
        [unit_f32(a), unit_f32(b), unit_f32(c), unit_f32(d)]
    }

    /// One of the two pairs of a dimension, as words.
    #[inline(always)]
    fn pair(&self, dimension: u32, which: u32) -> [u32; 2] {
        let [order, x, y, _] = pcg4d([self.pixel, dimension, self.seed, which]);
        scrambled_sobol(self.sample, order, [x, y])
    }
}

/// Numbers in [0, 1) of a dimension of [`Sampler`] that fill the unit squares of their pairs evenly together with `numbers`, which are those for 0: each is uniform
/// where those are (a digital shift of the Sobol sequence).
#[inline]
pub fn shifted(numbers: [f32; 4], by: u32) -> [f32; 4] {
    let [x, y] = scrambled_sobol(by, 0, [0; 2]);
    let shift = |number: f32, shift: u32| unit_f32(((number * 16_777_216.0) as u32) << 8 ^ shift);
    let [a, b, c, d] = numbers;
    [shift(a, x), shift(b, y), shift(c, y), shift(d, x)]
}

/// The point `index` of the two-dimensional Sobol sequence, its order and each coordinate Owen-scrambled by a seed.
#[inline(always)]
fn scrambled_sobol(index: u32, order: u32, seeds: [u32; 2]) -> [u32; 2] {
    let index = owen_of_reversed(index.reverse_bits(), order);
    // The first coordinate is the index with its bits reversed, the second one that of the index times the matrix of
    // binomial coefficients modulo 2: each bit becomes the parity of the bits whose number contains its own (Lucas).
    let mut binomial = index;
    for (shift, mask) in [(1, 0x5555_5555), (2, 0x3333_3333), (4, 0x0f0f_0f0f), (8, 0x00ff_00ff), (16, 0xffff)] {
        binomial ^= binomial >> shift & mask;
    }
    [owen_of_reversed(index, seeds[0]), owen_of_reversed(binomial, seeds[1])]
}

/// Owen scrambling of the word whose bits `reversed` holds in reverse: flips each bit by a hash of those above it.
#[inline(always)]
fn owen_of_reversed(reversed: u32, seed: u32) -> u32 {
    let mut word = reversed.wrapping_add(seed);
    for factor in [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        word ^= word.wrapping_mul(factor);
    }
    word.reverse_bits()
}

/// A permutation of four words whose every output bit depends on every input bit.
#[inline(always)]
pub fn pcg4d(words: [u32; 4]) -> [u32; 4] {
    let start = |word: u32| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    let [x, y, z, w] = words;
    let [x, y, z, w] = pcg4d_round([start(x), start(y), start(z), start(w)]);
    pcg4d_round([x ^ x >> 16, y ^ y >> 16, z ^ z >> 16, w ^ w >> 16])
}

#[inline(always)]
fn pcg4d_round([mut x, mut y, mut z, mut w]: [u32; 4]) -> [u32; 4] {
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    [x, y, z, w]
}

/// The upper 24 bits of a word as a multiple of 2⁻²⁴ in [0, 1): every value is exact.
#[inline(always)]
pub fn unit_f32(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Into how many of `parts` × 16 / `parts` rectangles the pairs of shifted numbers fall, the first four, or all sixteen.
    fn filled(numbers: [f32; 4], count: u32, parts: u32, shifted: impl Fn([f32; 4], u32) -> [f32; 4]) -> usize {
        let rows = count / parts;
        let places = |pair: usize| {
            let place = |by: u32| {
                let numbers = shifted(numbers, by);
                ((numbers[2 * pair] * parts as f32) as u32, (numbers[2 * pair + 1] * rows as f32) as u32)
            };
            (0..count).map(place).collect::<std::collections::HashSet<_>>().len()
        };
        places(0).min(places(1))
    }

    #[test]
    fn shifted_numbers_fill_the_squares_of_their_pairs_evenly() {
        for pixel in 0..100 {
            let numbers = Sampler { seed: 3, pixel, sample: 5 }.stratified(0);
            assert_eq!(shifted(numbers, 0), numbers);
            for (count, parts) in [(4, 1), (4, 2), (4, 4), (16, 1), (16, 2), (16, 4), (16, 8), (16, 16)] {
                assert_eq!(filled(numbers, count, parts, shifted), count as usize, "{count} numbers, {parts} parts");
            }
            // A planted fault: those of samples that follow each other, the first apart.
            let others = |_, by| if by == 0 { numbers } else { Sampler { seed: 4, pixel, sample: by }.stratified(0) };
            let (all, some) = (16 * 8, [1, 2, 4, 8, 16].map(|parts| filled(numbers, 16, parts, others)));
            assert!(some.iter().sum::<usize>() < all * 5 / 8, "a fault is seen: {some:?}");
        }
    }

    /// Checks mean, variance and the correlation with the neighbouring sample, pixel, dimension and seed.
    fn check_uniform(draw: impl Fn(Sampler, u32) -> [f32; 4]) -> Result<(), String> {
        let count = 20_000;
        let at = |index: u32| Sampler { seed: 7, pixel: index % 100, sample: index / 100 };
        for channel in 0..4 {
            let value = |sampler: Sampler, dimension: u32| f64::from(draw(sampler, dimension)[channel]) - 0.5;
            let own = |index| value(at(index), 3);
            let mean_of = |f: &dyn Fn(u32) -> f64| (0..count).map(f).sum::<f64>() / f64::from(count);
            let tolerance = 4.0 / f64::from(count).sqrt();
            let mean = mean_of(&own);
            let variance = mean_of(&|i| own(i) * own(i));
            if mean.abs() > 0.29 * tolerance || (variance * 12.0 - 1.0).abs() > tolerance {
                return Err(format!("channel {channel}: mean {mean}, variance {variance}"));
            }
            let neighbours: [&dyn Fn(u32) -> f64; 4] = [
                &|i| value(Sampler { seed: 8, ..at(i) }, 3),
                &|i| value(Sampler { pixel: at(i).pixel + 1, ..at(i) }, 3),
                &|i| value(Sampler { sample: at(i).sample + 1, ..at(i) }, 3),
                &|i| value(at(i), 4),
            ];
            for (which, neighbour) in neighbours.iter().enumerate() {
                let correlation = mean_of(&|i| own(i) * neighbour(i) * 12.0);
                if correlation.abs() > tolerance {
                    return Err(format!("channel {channel}, neighbour {which}: correlation {correlation}"));
                }
            }
        }
        Ok(())
    }

    #[test]
    fn independent_numbers_are_uniform_and_their_neighbours_uncorrelated() {
        check_uniform(|sampler, dimension| sampler.independent(dimension)).unwrap();
        let ignores_the_seed = |sampler: Sampler, dimension| Sampler { seed: 0, ..sampler }.independent(dimension);
        check_uniform(ignores_the_seed).unwrap_err();
        let skewed = |sampler: Sampler, dimension| sampler.independent(dimension).map(|value| value * value);
        check_uniform(skewed).unwrap_err();
    }

    /// Checks that any aligned run of 2ⁿ samples has one point in each of the 2ⁿ boxes of every shape with sides 2⁻ᵏ.
    fn check_nets(pair: impl Fn(Sampler) -> [f32; 2]) -> Result<(), String> {
        for (pixel, first, log2) in [(3, 0, 4), (9, 64, 6), (1, 3072, 10), (77, 1 << 20, 8)] {
            for columns_log2 in 0..=log2 {
                let (columns, rows) = (1 << columns_log2, 1 << (log2 - columns_log2));
                let mut filled = vec![false; 1 << log2];
                for sample in first..first + (1 << log2) {
                    let [x, y] = pair(Sampler { seed: 5, pixel, sample });
                    let at = (y * rows as f32) as usize * columns + (x * columns as f32) as usize;
                    if std::mem::replace(&mut filled[at], true) {
                        return Err(format!("pixel {pixel}, samples from {first}: {columns} × {rows} boxes"));
                    }
                }
            }
        }
        Ok(())
    }

    #[test]
    fn stratified_pairs_are_nets() {
        for dimension in 0..6 {
            let draw = |sampler: Sampler| sampler.stratified(dimension);
            check_nets(|sampler| [draw(sampler)[0], draw(sampler)[1]]).unwrap();
            check_nets(|sampler| [draw(sampler)[2], draw(sampler)[3]]).unwrap();
            check_nets(|sampler| [draw(sampler)[0], draw(sampler)[2]]).unwrap_err();
            check_nets(|sampler| [sampler.independent(dimension)[0], draw(sampler)[1]]).unwrap_err();
        }
    }

    #[test]
    fn stratified_numbers_of_different_pixels_are_independent() {
        // One sample of many pixels must be as good as many samples of one: the scrambling alone makes it uniform.
        let of_pixels = |sampler: Sampler| Sampler { seed: 7, pixel: sampler.pixel * 1000 + sampler.sample, sample: 3 };
        check_uniform(|sampler, dimension| Sampler { seed: sampler.seed, ..of_pixels(sampler) }.stratified(dimension))
            .unwrap();
        check_uniform(|sampler, dimension| Sampler { pixel: 1, ..sampler }.stratified(dimension)).unwrap_err();
    }

    #[test]
    fn the_largest_word_stays_below_one() {
        assert!(unit_f32(u32::MAX) < 1.0);
        assert_eq!(unit_f32(0), 0.0);
    }
}
