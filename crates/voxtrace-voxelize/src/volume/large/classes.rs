//! What the transfer function says of samples as they are stored: of codes by tables, and of many at once.

use super::super::slab::{WORD, packed};
use super::super::transfer::{EMPTY, Lookup};
use super::{Block, Coding};

/// A transfer function for the samples of a source.
pub(super) struct Classes<'a> {
    pub lookup: &'a Lookup,
    table: &'a [f32],
    /// The material of each code.
    materials: Vec<u16>,
    /// How many codes before each one are seen.
    seen_before: Vec<u32>,
    /// The first code that is seen, and how many there are from it to the last one; whether all of these are.
    first: usize,
    count: usize,
    is_solid: bool,
    /// Whether real values grow or fall with their codes.
    is_monotonic: bool,
    /// The code of nothing.
    zero: Option<usize>,
}

impl<'a> Classes<'a> {
    pub fn new(lookup: &'a Lookup, coding: &'a Coding) -> Self {
        let table = coding.table();
        let materials: Vec<u16> = table.iter().map(|&value| lookup.material(value)).collect();
        let seen = |code: &usize| materials[*code] != EMPTY;
        let first = (0..table.len()).find(seen).unwrap_or(0);
        let count = (0..table.len()).rfind(seen).map_or(0, |last| last + 1 - first);
        let mut seen_before = vec![0];
        for code in 0..table.len() {
            seen_before.push(seen_before[code] + u32::from(seen(&code)));
        }
        let is_solid = seen_before[table.len()] as usize == count;
        let is_monotonic = table.is_sorted() || table.iter().rev().is_sorted();
        let zero = table.iter().position(|&value| value == 0.0);
        Self { lookup, table, materials, seen_before, first, count, is_solid, is_monotonic, zero }
    }

    /// Whether nothing is seen of any mean of `terms` values from `low` to `high`, however sums are rounded.
    fn is_quiet_between(&self, low: f32, high: f32, terms: usize) -> bool {
        let Some([least, most]) = self.lookup.interval() else {
            return low == high && self.lookup.material(low) == EMPTY;
        };
        let margin = low.abs().max(high.abs()) * (terms + 8) as f32 * f32::EPSILON + f32::MIN_POSITIVE;
        high + margin < least || low - margin > most
    }
}

/// Samples as they are stored.
pub(super) trait Stored: Copy + Send + Sync + PartialEq + 'static {
    /// Those of a block; none where it has others.
    fn of(block: &Block) -> &[Self];

    /// A bit for each of up to 64 samples that is seen, and its material, where `materials` is told any.
    fn see(classes: &Classes, samples: &[Self], materials: &mut [u16]) -> u64;

    /// Real values.
    fn reals(classes: &Classes, samples: &[Self], values: &mut [f32]);

    /// Whether all are 0.
    fn are_zero(classes: &Classes, samples: &[Self]) -> bool;

    /// The extremes of no samples.
    const NONE: [Self; 2];

    /// The least and the greatest of what was found so far and of some samples.
    fn extremes(samples: &[Self], found: [Self; 2]) -> [Self; 2];

    /// Whether nothing is seen of any mean of `terms` samples from one to another.
    fn is_quiet(classes: &Classes, extremes: [Self; 2], terms: usize) -> bool;
}

/// Codes of so many bits: the two implementations differ in the type alone.
macro_rules! stored_codes {
    ($code:ty, $kind:ident) => {
        impl Stored for $code {
            fn of(block: &Block) -> &[Self] {
                if let Block::$kind(codes) = block { codes } else { &[] }
            }

            fn see(classes: &Classes, codes: &[Self], materials: &mut [u16]) -> u64 {
                if classes.count == 0 {
                    return 0;
                }
                let (first, last) = (classes.first as $code, (classes.count - 1) as $code);
                let near = |code: $code| code.wrapping_sub(first) <= last;
                if !codes.iter().fold(false, |any, &code| any | near(code)) {
                    return 0;
                }
                let mut truths = [false; WORD];
                if classes.is_solid {
                    truths.iter_mut().zip(codes).for_each(|(truth, &code)| *truth = near(code));
                } else {
                    let seen = |code: $code| classes.materials[usize::from(code)] != EMPTY;
                    truths.iter_mut().zip(codes).for_each(|(truth, &code)| *truth = seen(code));
                }
                let word = packed(&truths);
                if word != 0 {
                    let looked_up = |(own, &code): (&mut u16, &$code)| *own = classes.materials[usize::from(code)];
                    materials.iter_mut().zip(codes).for_each(looked_up);
                }
                word
            }

            fn reals(classes: &Classes, codes: &[Self], values: &mut [f32]) {
                values.iter_mut().zip(codes).for_each(|(value, &code)| *value = classes.table[usize::from(code)]);
            }

            fn are_zero(classes: &Classes, codes: &[Self]) -> bool {
                let Some(zero) = classes.zero.map(|zero| zero as $code) else { return false };
                !codes.iter().fold(false, |any, &code| any | (code != zero))
            }

            const NONE: [Self; 2] = [<$code>::MAX, 0];

            fn extremes(codes: &[Self], [low, high]: [Self; 2]) -> [Self; 2] {
                // One after the other, which compilers turn into vectors.
                let low = codes.iter().fold(low, |low, &code| low.min(code));
                [low, codes.iter().fold(high, |high, &code| high.max(code))]
            }

            fn is_quiet(classes: &Classes, [low, high]: [Self; 2], terms: usize) -> bool {
                let (low, high) = (usize::from(low), usize::from(high));
                if terms == 1 || classes.lookup.interval().is_none() {
                    // Labels are never mixed.
                    return classes.seen_before[low] == classes.seen_before[high + 1];
                }
                let (a, b) = (classes.table[low], classes.table[high]);
                classes.is_monotonic && classes.is_quiet_between(a.min(b), a.max(b), terms)
            }
        }
    };
}

stored_codes!(u8, Bytes);
stored_codes!(u16, Words);

impl Stored for f32 {
    fn of(block: &Block) -> &[Self] {
        if let Block::Reals(values) = block { values } else { &[] }
    }

    fn see(classes: &Classes, values: &[Self], materials: &mut [u16]) -> u64 {
        let mut truths = [false; WORD];
        classes.lookup.see(values, &mut truths);
        let word = packed(&truths);
        if word != 0 {
            materials.iter_mut().zip(values).for_each(|(own, &value)| *own = classes.lookup.material(value));
        }
        word
    }

    fn reals(_: &Classes, samples: &[Self], values: &mut [f32]) {
        values.copy_from_slice(samples);
    }

    fn are_zero(_: &Classes, values: &[Self]) -> bool {
        !values.iter().fold(false, |any, &value| any | (value != 0.0))
    }

    const NONE: [Self; 2] = [f32::MAX, f32::MIN];

    fn extremes(values: &[Self], [low, high]: [Self; 2]) -> [Self; 2] {
        /// Numbers that are compared at once.
        const WIDE: usize = 8;
        let ([mut lows, mut highs], (wide, rest)) = ([[low; WIDE], [high; WIDE]], values.as_chunks::<WIDE>());
        // What is no number changes nothing: sums with it are not seen.
        for values in wide {
            for (at, &value) in values.iter().enumerate() {
                lows[at] = if value < lows[at] { value } else { lows[at] };
                highs[at] = if value > highs[at] { value } else { highs[at] };
            }
        }
        let low = lows.iter().chain(rest).fold(low, |low, &value| low.min(value));
        [low, highs.iter().chain(rest).fold(high, |high, &value| high.max(value))]
    }

    fn is_quiet(classes: &Classes, [low, high]: [Self; 2], terms: usize) -> bool {
        classes.is_quiet_between(low, high, terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::{Ramp, Transfer};
    use glam::Vec3;

    /// Transfer functions whose codes are seen up to an end, from a begin on, or here and there.
    fn lookups() -> Vec<Lookup> {
        let between = |low, high| Ramp::Absolute { low, high, stops: vec![(low, Vec3::X), (low + 90.0, Vec3::Y)] };
        let labels = |all: &[i32]| Ramp::Labels(all.iter().map(|&label| (label, Vec3::ONE.into())).collect());
        let ramps =
            [between(40.0, f32::MAX), between(-300.0, 17.5), between(1e6, 2e6), labels(&[3, 90, 91]), labels(&[])];
        ramps.into_iter().map(|ramp| Transfer::new("", ramp).lookup()).collect()
    }

    fn codes(n: usize) -> Vec<u16> {
        (0..n as u32).map(|at| (at.wrapping_mul(2_654_435_761) >> 25) as u16 + 128 * u16::from(at % 16 == 0)).collect()
    }

    fn seen<S: Stored>(classes: &Classes, samples: &[S]) -> (u64, Vec<u16>) {
        let mut materials = vec![EMPTY; samples.len()];
        (S::see(classes, samples, &mut materials), materials)
    }

    #[test]
    fn tables_say_of_codes_what_the_transfer_function_says_of_values() {
        let mut planted = 0;
        for factor in [1.0, -2.0, 0.25] {
            let table = |count: u32| (0..count).map(|code| code as f32 * factor - 10.0).collect::<Vec<f32>>();
            for lookup in &lookups() {
                for count in [64, 33] {
                    let codes = codes(count);
                    let (bytes, words) = (Coding::Bytes(table(256)), Coding::Words(table(65_536)));
                    let values: Vec<f32> = codes.iter().map(|&code| table(256)[usize::from(code)]).collect();
                    let small: Vec<u8> = codes.iter().map(|&code| code as u8).collect();
                    let wanted = (0..count).filter(|&at| lookup.material(values[at]) != EMPTY);
                    let wanted = wanted.fold(0u64, |word, at| word | 1 << at);
                    let all = [
                        seen(&Classes::new(lookup, &bytes), &small),
                        seen(&Classes::new(lookup, &words), &codes),
                        seen(&Classes::new(lookup, &Coding::Reals), &values),
                    ];
                    for (word, materials) in all {
                        assert_eq!(word, wanted, "{factor}");
                        let is_right = |at: usize| word >> at & 1 == 0 || materials[at] == lookup.material(values[at]);
                        assert!((0..count).all(is_right));
                        planted += usize::from(word != 0 && materials[0] != materials[1]);
                    }
                }
            }
        }
        assert!(planted > 5);
    }

    #[test]
    fn what_is_quiet_has_no_mean_that_is_seen() {
        let lookup = &lookups()[0];
        let (coding, count) = (Coding::Bytes((0..256).map(|code| code as f32 - 10.0).collect()), 64);
        let (classes, reals) = (Classes::new(lookup, &coding), Classes::new(lookup, &Coding::Reals));
        let (mut quiet, mut loud) = (0, 0);
        for shift in 0..160u8 {
            let codes: Vec<u8> = codes(count).iter().map(|&code| (code % 16) as u8 + shift).collect();
            let mut values = vec![0.0; count];
            u8::reals(&classes, &codes, &mut values);
            let extremes = u8::extremes(&codes, u8::NONE);
            let of_reals = f32::extremes(&values, f32::NONE);
            assert_eq!(extremes.map(|code| f32::from(code) - 10.0), of_reals);
            for terms in [2, 64] {
                let found = u8::is_quiet(&classes, extremes, terms);
                assert_eq!(found, f32::is_quiet(&reals, of_reals, terms));
                let mean = |values: &[f32]| values.iter().map(|value| value / terms as f32).sum::<f32>();
                let is_seen = values.chunks(terms).any(|values| lookup.material(mean(values)) != EMPTY);
                assert!(!(found && is_seen), "{shift} {terms}");
                quiet += usize::from(found);
                loud += usize::from(is_seen);
            }
        }
        assert!(quiet > 20 && loud > 20, "{quiet} {loud}");
        assert!(u8::are_zero(&classes, &[10; 70]) && !u8::are_zero(&classes, &[10, 10, 11]));
        assert!(f32::are_zero(&reals, &[0.0, -0.0]) && !f32::are_zero(&reals, &[f32::NAN]));
    }
}
