//! Rows of voxels from the rows of samples under them: which are seen, and in which material. Words of voxels under which nothing can be
//! seen are passed over before anything is summed.

use super::super::slab::WORD;
use super::across::Across;
use super::classes::{Classes, Stored};

/// A row of samples with the weights that it has as one of a row and of a layer of voxels.
pub(super) struct WeightedRow<'a, S> {
    pub samples: &'a [S],
    pub weights: [f32; 2],
}

/// What one thread works in.
#[derive(Default)]
pub(super) struct Scratch {
    values: Vec<f32>,
}

/// Reads rows of voxels.
pub(super) struct RowReader<'a> {
    pub across: &'a Across<'a>,
    pub classes: &'a Classes<'a>,
}

impl RowReader<'_> {
    /// A row of voxels whose samples are all here.
    pub fn read<S: Stored>(
        &self,
        rows: &[WeightedRow<S>],
        bits: &mut [u64],
        materials: &mut [u16],
        scratch: &mut Scratch,
    ) {
        if let ([only], Some(is_backward)) = (rows, self.across.alike())
            && only.weights == [1.0; 2]
        {
            return self.read_alike(only.samples, is_backward, bits, materials);
        }
        let terms = self.across.most() * rows.len();
        for (word, (bits, materials)) in bits.iter_mut().zip(materials.chunks_mut(WORD)).enumerate() {
            let span = self.across.span(word);
            let parts = rows.iter().map(|row| &row.samples[span.clone()]);
            let extremes = parts.fold(S::NONE, |found, samples| S::extremes(samples, found));
            if S::is_quiet(self.classes, extremes, terms) {
                *bits = 0;
                continue;
            }
            let mut sums = [0.0; WORD];
            let sums = &mut sums[..materials.len()];
            for row in rows {
                self.add(word, row, sums, scratch);
            }
            *bits = f32::see(self.classes, sums, materials);
        }
    }

    /// A row of voxels that are samples.
    fn read_alike<S: Stored>(&self, samples: &[S], is_backward: bool, bits: &mut [u64], materials: &mut [u16]) {
        for (word, (bits, materials)) in bits.iter_mut().zip(materials.chunks_mut(WORD)).enumerate() {
            let samples = &samples[self.across.span(word)];
            let seen = S::see(self.classes, samples, materials);
            *bits = seen;
            if is_backward && seen != 0 {
                materials.reverse();
                *bits = seen.reverse_bits() >> (WORD - samples.len());
            }
        }
    }

    /// Adds what a row of samples has of a row of voxels to its sums.
    pub fn add_all<S: Stored>(&self, row: &WeightedRow<S>, sums: &mut [f32], scratch: &mut Scratch) {
        for (word, sums) in sums.chunks_mut(WORD).enumerate() {
            // Nothing changes no sum.
            if !S::are_zero(self.classes, &row.samples[self.across.span(word)]) {
                self.add(word, row, sums, scratch);
            }
        }
    }

    /// What is seen of a row of sums.
    pub fn see(&self, sums: &[f32], bits: &mut [u64], materials: &mut [u16]) {
        for ((bits, materials), sums) in bits.iter_mut().zip(materials.chunks_mut(WORD)).zip(sums.chunks(WORD)) {
            *bits = f32::see(self.classes, sums, materials);
        }
    }

    fn add<S: Stored>(&self, word: usize, row: &WeightedRow<S>, sums: &mut [f32], scratch: &mut Scratch) {
        let samples = &row.samples[self.across.span(word)];
        // Voxels at the end that have fewer samples than others find nothing behind theirs.
        scratch.values.clear();
        scratch.values.resize(samples.len() + self.across.room(), 0.0);
        S::reals(self.classes, samples, &mut scratch.values[..samples.len()]);
        self.across.add(word, &scratch.values, row.weights, sums);
    }
}
