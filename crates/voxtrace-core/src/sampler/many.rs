//! The random numbers of many paths at once, by the vector instructions that the processor has: to the bit what [`Sampler`] gives each.

#![cfg_attr(target_arch = "x86_64", expect(unsafe_code, reason = "calls of functions for certain processors"))]

use super::Sampler;
use crate::walk::Instructions;
use std::iter;
use std::ops::Range;

/// Which numbers are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Numbers {
    /// [`Sampler::independent`].
    #[default]
    Independent,
    /// [`Sampler::stratified`].
    Stratified,
}

/// Dimensions of some paths of one frame, and the numbers that are drawn for them.
#[derive(Default)]
pub struct Draws {
    seed: u32,
    which: Numbers,
    pixels: Vec<u32>,
    samples: Vec<u32>,
    dimensions: Vec<u32>,
    /// One row for each of the four numbers.
    numbers: [Vec<f32>; 4],
}

impl Draws {
    /// Forgets all, for others of a seed.
    pub fn begin(&mut self, seed: u32) {
        self.seed = seed;
        self.pixels.clear();
        self.samples.clear();
        self.dimensions.clear();
    }

    /// Asks for the numbers of a dimension of a sampler with that seed.
    #[inline]
    pub fn push(&mut self, sampler: &Sampler, dimension: u32) {
        self.pixels.push(sampler.pixel);
        self.samples.push(sampler.sample);
        self.dimensions.push(dimension);
    }

    /// Asks for those of some samples of a pixel.
    pub fn push_samples(&mut self, pixel: u32, samples: Range<u32>, dimension: u32) {
        let count = samples.len();
        self.pixels.extend(iter::repeat_n(pixel, count));
        self.samples.extend(samples);
        self.dimensions.extend(iter::repeat_n(dimension, count));
    }

    /// Draws the numbers that were asked for.
    #[inline(never)]
    pub fn draw(&mut self, which: Numbers, instructions: Instructions) {
        self.which = which;
        // Modules for pages are to be small: there each is drawn when it is taken.
        if cfg!(target_arch = "wasm32") {
            return;
        }
        self.numbers.iter_mut().for_each(|row| row.resize(self.pixels.len(), 0.0));
        match instructions {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has the instructions.
            Instructions::Avx512 if instructions.is_available() => unsafe { by_avx512(self, which) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Instructions::Avx2 if instructions.is_available() => unsafe { by_avx2(self, which) },
            _ => self.draw_each(which),
        }
    }

    #[inline(always)]
    fn draw_each(&mut self, which: Numbers) {
        match which {
            Numbers::Independent => self.fill::<false>(),
            Numbers::Stratified => self.fill::<true>(),
        }
    }

    /// One loop without branches, of which compilers make vectors.
    #[inline(always)]
    fn fill<const IS_STRATIFIED: bool>(&mut self) {
        let [a, b, c, d] = &mut self.numbers;
        let asked = self.pixels.iter().zip(&self.samples).zip(&self.dimensions);
        let found = a.iter_mut().zip(b).zip(c).zip(d);
        for (((&pixel, &sample), &dimension), (((a, b), c), d)) in asked.zip(found) {
            let sampler = Sampler { seed: self.seed, pixel, sample };
            [*a, *b, *c, *d] =
                if IS_STRATIFIED { sampler.stratified_here(dimension) } else { sampler.independent_here(dimension) };
        }
    }

    /// The sampler that was asked for at a place.
    #[inline]
    pub fn sampler(&self, place: usize) -> Sampler {
        Sampler { seed: self.seed, pixel: self.pixels[place], sample: self.samples[place] }
    }

    /// The numbers of the one that was asked for at a place.
    #[inline]
    pub fn get(&self, place: usize) -> [f32; 4] {
        if cfg!(target_arch = "wasm32") {
            let (sampler, dimension) = (self.sampler(place), self.dimensions[place]);
            return match self.which {
                Numbers::Independent => sampler.independent(dimension),
                Numbers::Stratified => sampler.stratified(dimension),
            };
        }
        let [a, b, c, d] = &self.numbers;
        [a[place], b[place], c[place], d[place]]
    }
}

/// # Safety
/// The processor must have the instructions.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,avx2")]
unsafe fn by_avx512(draws: &mut Draws, which: Numbers) {
    draws.draw_each(which);
}

/// # Safety
/// The processor must have the instructions.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn by_avx2(draws: &mut Draws, which: Numbers) {
    draws.draw_each(which);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_drawn_together_are_those_of_each() {
        let samplers = (0..1000u32).map(|index| {
            let sampler = Sampler { seed: 9, pixel: index.wrapping_mul(0x9e37_79b9), sample: index % 67 };
            (sampler, index % 23)
        });
        let available = Instructions::ALL.into_iter().filter(|instructions| instructions.is_available());
        let which = [Numbers::Independent, Numbers::Stratified];
        for (instructions, which) in available.flat_map(|instructions| which.map(|which| (instructions, which))) {
            for count in [0, 1, 15, 16, 17, 1000] {
                let mut draws = Draws::default();
                draws.push(&Sampler { seed: 0, pixel: 1, sample: 2 }, 3);
                draws.begin(9);
                for (sampler, dimension) in samplers.clone().take(count) {
                    draws.push(&sampler, dimension);
                }
                draws.draw(which, instructions);
                for (place, (sampler, dimension)) in samplers.clone().take(count).enumerate() {
                    let expected = match which {
                        Numbers::Independent => sampler.independent(dimension),
                        Numbers::Stratified => sampler.stratified(dimension),
                    };
                    let found = draws.get(place).map(f32::to_bits);
                    assert_eq!(found, expected.map(f32::to_bits), "{} {which:?} {place}", instructions.name());
                    assert_eq!(draws.sampler(place), sampler);
                }
            }
        }
    }
}
