//! Random numbers as a pure function of (seed, pixel, sample, dimension): the four-word hash pcg4d of Jarzynski and
//! Olano, "Hash Functions for GPU Rendering" (JCGT 9(3), 2020). No state, so any order of work gives the same numbers.

/// The random numbers of one sample of one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampler {
    /// Seed of the frame.
    pub seed: u32,
    /// Number of the pixel in the whole picture, row by row.
    pub pixel: u32,
    /// Number of the sample.
    pub sample: u32,
}

impl Sampler {
    /// The four numbers in [0, 1) of a dimension, independent of those of every other dimension, sample, pixel and
    /// seed.
    #[inline]
    pub fn draw(&self, dimension: u32) -> [f32; 4] {
        pcg4d([self.pixel, self.sample, dimension, self.seed]).map(unit_f32)
    }
}

/// A permutation of four words whose every output bit depends on every input bit.
#[inline]
pub fn pcg4d(words: [u32; 4]) -> [u32; 4] {
    let [mut x, mut y, mut z, mut w] = words.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    for round in 0..2 {
        x = x.wrapping_add(y.wrapping_mul(w));
        y = y.wrapping_add(z.wrapping_mul(x));
        z = z.wrapping_add(x.wrapping_mul(y));
        w = w.wrapping_add(y.wrapping_mul(z));
        if round == 0 {
            [x, y, z, w] = [x, y, z, w].map(|word| word ^ word >> 16);
        }
    }
    [x, y, z, w]
}

/// The upper 24 bits of a word as a multiple of 2⁻²⁴ in [0, 1): every value is exact.
#[inline]
pub fn unit_f32(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn draws_are_uniform_and_neighbours_are_uncorrelated() {
        check_uniform(|sampler, dimension| sampler.draw(dimension)).unwrap();
        let ignores_the_seed = |sampler: Sampler, dimension| Sampler { seed: 0, ..sampler }.draw(dimension);
        check_uniform(ignores_the_seed).unwrap_err();
        let skewed = |sampler: Sampler, dimension| sampler.draw(dimension).map(|value| value * value);
        check_uniform(skewed).unwrap_err();
    }

    #[test]
    fn the_largest_word_stays_below_one() {
        assert!(unit_f32(u32::MAX) < 1.0);
        assert_eq!(unit_f32(0), 0.0);
    }
}
