//! How often each value occurs, counted block by block on all threads: each has counts of its own. Runs of one value, of which most of
//! a volume may be, are counted at once.

use super::super::statistics::Look;
use super::{Block, Coding};
use rayon::prelude::*;

/// Samples that are compared with the first of them at once.
const RUN: usize = 64;

/// The counts of each thread.
pub(super) enum Tally<'a> {
    Codes { table: &'a [f32], counts: Vec<Vec<u64>> },
    Reals(Vec<Look>),
}

impl<'a> Tally<'a> {
    pub fn new(coding: &'a Coding) -> Self {
        let threads = rayon::current_num_threads();
        match coding {
            Coding::Reals => Self::Reals(vec![Look::default(); threads]),
            Coding::Bytes(table) | Coding::Words(table) => {
                Self::Codes { table, counts: vec![vec![0; table.len()]; threads] }
            }
        }
    }

    /// Counts the samples of a block from one on.
    pub fn add(&mut self, block: &Block, first: usize) {
        match (self, block) {
            (Self::Codes { counts, .. }, Block::Bytes(codes)) => {
                each(counts, codes, first, |counts, codes| count_bytes(counts, codes))
            }
            (Self::Codes { counts, .. }, Block::Words(codes)) => {
                each(counts, codes, first, |counts, codes| count_words(counts, codes))
            }
            (Self::Reals(looks), Block::Reals(values)) => each(looks, values, first, Look::add_chunk),
            _ => {}
        }
    }

    /// What all samples say.
    pub fn look(self) -> Look {
        match self {
            Self::Reals(looks) => looks.into_iter().fold(Look::default(), Look::and),
            Self::Codes { table, counts } => {
                let all = counts.into_iter().fold(vec![0; table.len()], super::super::statistics::sum);
                Look::of_codes(table, &all)
            }
        }
    }
}

/// Hands each thread its part of the samples.
fn each<T: Sync, C: Send>(counts: &mut [C], samples: &[T], first: usize, count: impl Fn(&mut C, &[T]) + Sync) {
    let samples = samples.get(first..).unwrap_or_default();
    let part = samples.len().div_ceil(counts.len()).max(1);
    counts.par_iter_mut().zip(samples.par_chunks(part)).for_each(|(counts, part)| count(counts, part));
}

/// The one value of a run, if it is one.
fn one<T: Copy + PartialEq>(run: &[T; RUN]) -> Option<T> {
    let first = run[0];
    let differ = run.iter().fold(false, |differ, &value| differ | (value != first));
    (!differ).then_some(first)
}

fn count_bytes(counts: &mut [u64], codes: &[u8]) {
    // Four tables, since adding to the same place twice in a row takes longer.
    let mut tables = [[0u64; 256]; 4];
    let (runs, rest) = codes.as_chunks::<RUN>();
    for run in runs {
        if let Some(code) = one(run) {
            counts[usize::from(code)] += RUN as u64;
            continue;
        }
        for four in run.as_chunks::<4>().0 {
            for (table, &code) in tables.iter_mut().zip(four) {
                table[usize::from(code)] = table[usize::from(code)].wrapping_add(1);
            }
        }
    }
    rest.iter().for_each(|&code| counts[usize::from(code)] += 1);
    for table in tables {
        counts.iter_mut().zip(table).for_each(|(sum, count)| *sum += count);
    }
}

fn count_words(counts: &mut [u64], codes: &[u16]) {
    let (runs, rest) = codes.as_chunks::<RUN>();
    for run in runs {
        match one(run) {
            Some(code) => counts[usize::from(code)] += RUN as u64,
            None => run.iter().for_each(|&code| counts[usize::from(code)] += 1),
        }
    }
    rest.iter().for_each(|&code| counts[usize::from(code)] += 1);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs, noise and an end that fills no run; `seed` changes one of them.
    fn codes(seed: u32) -> Vec<u16> {
        let noise = |n: u32| (n.wrapping_mul(2_654_435_761) >> 24) as u16;
        let code = |n: u32| if (n / 1000).is_multiple_of(2) { 7 + (n / 5000) as u16 } else { noise(n) };
        (0..30_021).map(|n| if n == 12_345 { code(n) ^ seed as u16 } else { code(n) }).collect()
    }

    /// The look at codes of each kind and at the values that they stand for, of which the first are left out.
    fn looks(codes: &[u16], factor: f32) -> [Look; 3] {
        let table = |count: u32| (0..count).map(|code| code as f32 * factor - 90.0).collect::<Vec<f32>>();
        let (bytes, words) = (table(256), table(65_536));
        let reals = codes.iter().map(|&code| words[usize::from(code)]).collect();
        let blocks = [
            (Coding::Bytes(bytes), Block::Bytes(codes.iter().map(|&code| code as u8).collect())),
            (Coding::Words(words), Block::Words(codes.to_vec())),
            (Coding::Reals, Block::Reals(reals)),
        ];
        blocks.map(|(coding, block)| {
            let mut tally = Tally::new(&coding);
            tally.add(&block, 0);
            tally.add(&block, 30_000);
            tally.look()
        })
    }

    #[test]
    fn codes_are_counted_as_the_values_that_they_stand_for() {
        for factor in [1.0, 0.5] {
            let [bytes, words, reals] = looks(&codes(0), factor);
            assert_eq!(
                (bytes.range(), bytes.labels(), bytes.share_from(9.0)),
                (words.range(), words.labels(), words.share_from(9.0))
            );
            assert_eq!((bytes.range(), bytes.labels()), (reals.range(), reals.labels()));
            assert_eq!(bytes.binned(-50.0, 60.0), words.binned(-50.0, 60.0));
            assert!(bytes.binned(-50.0, 60.0).is_some() && bytes.labels().is_some() == (factor == 1.0));
            if factor == 1.0 {
                assert_eq!(bytes.binned(-50.0, 60.0), reals.binned(-50.0, 60.0));
            } else {
                let all: Vec<f32> =
                    codes(0).iter().chain(&codes(0)[30_000..]).map(|&code| f32::from(code) * 0.5 - 90.0).collect();
                assert_eq!(
                    bytes.binned(-50.0, 60.0).unwrap(),
                    super::super::super::statistics::binned(&all, -50.0, 60.0)
                );
            }
            let planted = looks(&codes(1), factor);
            assert!(
                planted
                    .iter()
                    .zip([bytes, words, reals])
                    .all(|(a, b)| factor != 1.0 && a.binned(-90.0, 200.0).is_none()
                        || a.binned(-90.0, 200.0) != b.binned(-90.0, 200.0))
            );
        }
    }
}
