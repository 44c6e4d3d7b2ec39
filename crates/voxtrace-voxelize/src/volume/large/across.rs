//! The fastest axis: which samples a word of voxels lies over, and their sums. Samples are added in the order in which
//! [`super::super::slab`] adds them in memory.

use super::super::resample::{Axis, Taps};
use super::super::slab::WORD;
use std::ops::Range;

/// How the voxels of a row lie over its samples.
pub(super) struct Across<'a> {
    taps: &'a [Taps],
    kind: Kind,
    /// The samples under each word of voxels.
    spans: Vec<Range<usize>>,
    /// Most samples under one voxel.
    most: usize,
    /// Of [`Kind::Any`], for each voxel of the row where its samples begin within the span of its word.
    places: Vec<usize>,
    /// The weight of the first sample of each voxel of a word, then those of the second; 0 where a voxel has fewer than others.
    weights: Vec<[f32; WORD]>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// One sample each.
    Forward,
    Backward,
    /// Two samples each, of the same weights.
    Pairs([f32; 2]),
    PairsBackward([f32; 2]),
    Any,
}

impl<'a> Across<'a> {
    /// Voxels of an axis over so many samples.
    pub fn new(axis: &'a Axis, samples: usize) -> Self {
        let (taps, count) = (axis.taps.as_slice(), axis.count());
        let lie = |wide: usize, place: &dyn Fn(usize) -> usize| {
            let is_there = |(at, own): (usize, &Taps)| own.start == place(at) && own.weights == taps[0].weights;
            taps[0].weights.len() == wide && samples == count * wide && taps.iter().enumerate().all(is_there)
        };
        let pair = || [taps[0].weights[0], taps[0].weights[1]];
        let kind = if lie(1, &|at| at) {
            Kind::Forward
        } else if lie(1, &|at| count - 1 - at) {
            Kind::Backward
        } else if lie(2, &|at| at * 2) {
            Kind::Pairs(pair())
        } else if lie(2, &|at| (count - 1 - at) * 2) {
            Kind::PairsBackward(pair())
        } else {
            Kind::Any
        };
        let span = |taps: &[Taps]| {
            let ends = taps.iter().map(|taps| taps.start..taps.start + taps.weights.len());
            ends.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end)).unwrap_or_default()
        };
        let spans: Vec<Range<usize>> = taps.chunks(WORD).map(span).collect();
        let most = taps.iter().map(|taps| taps.weights.len()).max().unwrap_or(0);
        let mut across = Self { taps, kind, spans, most, places: Vec::new(), weights: Vec::new() };
        if kind == Kind::Any {
            across.places = (0..count).map(|at| taps[at].start - across.spans[at / WORD].start).collect();
            let weight = |word: usize, tap: usize, at: usize| {
                taps.get(word * WORD + at).and_then(|taps| taps.weights.get(tap)).copied().unwrap_or(0.0)
            };
            let words = (0..across.spans.len()).flat_map(|word| (0..most).map(move |tap| (word, tap)));
            across.weights = words.map(|(word, tap)| std::array::from_fn(|at| weight(word, tap, at))).collect();
        }
        across
    }

    /// The samples under a word of voxels.
    pub fn span(&self, word: usize) -> Range<usize> {
        self.spans[word].clone()
    }

    /// Most samples under one voxel.
    pub fn most(&self) -> usize {
        self.most
    }

    /// How many zeros [`Self::add`] wants behind the samples of a span.
    pub fn room(&self) -> usize {
        if self.kind == Kind::Any { self.most } else { 0 }
    }

    /// Whether each voxel is one sample, and whether they run against each other.
    pub fn alike(&self) -> Option<bool> {
        match self.kind {
            Kind::Forward => Some(false),
            Kind::Backward => Some(true),
            _ => None,
        }
    }

    /// Adds the samples under a word of voxels, `values`, to their sums, with the weights of their row and layer.
    pub fn add(&self, word: usize, values: &[f32], [weight_y, weight_z]: [f32; 2], sums: &mut [f32]) {
        match self.kind {
            Kind::Forward => {
                let weight = weight_y * weight_z;
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
            }
            Kind::Backward => {
                let weight = weight_y * weight_z;
                sums.iter_mut().zip(values.iter().rev()).for_each(|(sum, value)| *sum += weight * value);
            }
            Kind::Pairs(weights) => {
                let [a, b] = weights.map(|weight| weight * weight_y * weight_z);
                let add = |(sum, [first, second]): (&mut f32, &[f32; 2])| *sum = *sum + a * first + b * second;
                sums.iter_mut().zip(values.as_chunks().0).for_each(add);
            }
            Kind::PairsBackward(weights) => {
                let [a, b] = weights.map(|weight| weight * weight_y * weight_z);
                let add = |(sum, [first, second]): (&mut f32, &[f32; 2])| *sum = *sum + a * first + b * second;
                sums.iter_mut().zip(values.as_chunks().0.iter().rev()).for_each(add);
            }
            Kind::Any => self.add_any(word, values, [weight_y, weight_z], sums),
        }
    }

    /// As [`Self::add`], whatever lies under each voxel: the first sample of all of them, then the second. `values` has room for samples that
    /// voxels at its end lack.
    fn add_any(&self, word: usize, values: &[f32], [weight_y, weight_z]: [f32; 2], sums: &mut [f32]) {
        let places = &self.places[word * WORD..][..sums.len()];
        // What is no finite number would not vanish with a weight of 0.
        if values.iter().fold(true, |all, value| all & value.is_finite()) {
            for (tap, weights) in self.weights[word * self.most..][..self.most].iter().enumerate() {
                for ((sum, weight), &place) in sums.iter_mut().zip(weights).zip(places) {
                    *sum += weight * weight_y * weight_z * values[place + tap];
                }
            }
            return;
        }
        for ((sum, taps), &place) in sums.iter_mut().zip(&self.taps[word * WORD..]).zip(places) {
            for (weight_x, value) in taps.weights.iter().zip(&values[place..]) {
                *sum += weight_x * weight_y * weight_z * value;
            }
        }
    }
}
