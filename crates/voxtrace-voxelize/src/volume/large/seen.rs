//! The window of a stripe: for ten layers of voxels, eight of bricks and one at either side, which voxels are seen and in which material.
//! Axes are those of the lattice. Values are summed in the order in which [`super::super::slab`] sums them in memory.

use super::super::resample::Axis;
use super::super::slab::{EDGE, WORD, packed};
use super::super::transfer::{EMPTY, Lookup};
use super::SampleSource;
use super::stripes::Stripe;
use crate::voxelize::{VoxelizeError, VoxelizeProgress};
use rayon::prelude::*;
use std::collections::VecDeque;

/// Layers of samples that are kept: two, between which voxels finer than samples lie.
const KEPT: usize = 2;

/// Layers of voxels around a layer of bricks.
pub(super) struct Window<'a> {
    axes: [&'a Axis; 3],
    lookup: &'a Lookup,
    pub stripe: Stripe,
    /// Layers of voxels with their number.
    layers: Vec<(usize, SeenLayer)>,
    /// Layers of samples with their number, the last one read at the back.
    samples: VecDeque<(usize, Vec<f32>)>,
    sums: Vec<f32>,
}

/// One layer of a stripe's voxels.
pub(super) struct SeenLayer {
    /// A bit for each voxel that is seen, rows in whole words.
    pub bits: Vec<u64>,
    /// Its material.
    materials: Vec<u16>,
}

impl<'a> Window<'a> {
    pub fn new(axes: [&'a Axis; 3], stripe: Stripe, lookup: &'a Lookup) -> Self {
        Self { axes, lookup, stripe, layers: Vec::new(), samples: VecDeque::new(), sums: Vec::new() }
    }

    /// Whether layers of voxels run against those of samples.
    pub fn is_backward(&self) -> bool {
        let first = |at: usize| self.axes[2].taps[at].start;
        first(0) > first(self.axes[2].count() - 1)
    }

    /// Voxels of a row.
    pub fn width(&self) -> usize {
        self.axes[0].count()
    }

    /// Words of a row.
    pub fn words(&self) -> usize {
        self.width().div_ceil(WORD)
    }

    /// A layer of voxels, `None` beyond the grid.
    pub fn layer(&self, layer: usize) -> Option<&SeenLayer> {
        self.layers.iter().find(|(own, _)| *own == layer).map(|(_, seen)| seen)
    }

    /// The bits of a row, `None` where nobody looked.
    pub fn row<'l>(&self, layer: Option<&'l SeenLayer>, row: usize) -> Option<&'l [u64]> {
        let at = row.checked_sub(self.stripe.voxels.start).filter(|_| row < self.stripe.voxels.end)?;
        Some(&layer?.bits[at * self.words()..][..self.words()])
    }

    /// The material of a voxel that is seen.
    pub fn material(&self, layer: &SeenLayer, [x, row]: [usize; 2]) -> u16 {
        layer.materials[(row - self.stripe.voxels.start) * self.width() + x]
    }

    /// Looks at the layers of voxels of a layer of bricks and its neighbours.
    pub fn move_to(
        &mut self,
        layer: usize,
        source: &mut dyn SampleSource,
        progress: &VoxelizeProgress,
    ) -> Result<(), VoxelizeError> {
        let wanted = (layer * EDGE).saturating_sub(1)..((layer + 1) * EDGE + 1).min(self.axes[2].count());
        let mut free = Vec::new();
        let mut kept = Vec::new();
        for (at, seen) in std::mem::take(&mut self.layers) {
            if wanted.contains(&at) { kept.push((at, seen)) } else { free.push(seen) }
        }
        self.layers = kept;
        let is_backward = self.is_backward();
        for at in 0..wanted.len() {
            let at = if is_backward { wanted.end - 1 - at } else { wanted.start + at };
            if self.layers.iter().all(|(own, _)| *own != at) {
                if progress.is_cancelled() {
                    return Err(VoxelizeError::Cancelled);
                }
                let seen = self.look(at, free.pop(), source)?;
                self.layers.push((at, seen));
            }
        }
        Ok(())
    }

    /// The values of a layer of voxels, those of the stripe's own bricks alone.
    pub fn own_values(&mut self, layer: usize, source: &mut dyn SampleSource) -> Result<&[f32], VoxelizeError> {
        self.sum(layer, source)?;
        let (width, stripe) = (self.width(), &self.stripe);
        let own = stripe.bricks.start * EDGE..(stripe.bricks.end * EDGE).min(stripe.voxels.end);
        let from = stripe.voxels.start;
        Ok(&self.sums[(own.start - from) * width..(own.end - from) * width])
    }

    /// Sums the samples of a layer of voxels.
    fn sum(&mut self, layer: usize, source: &mut dyn SampleSource) -> Result<(), VoxelizeError> {
        let (width, rows) = (self.width(), self.stripe.voxels.len());
        self.sums.clear();
        self.sums.resize(width * rows, 0.0);
        for (number, weight) in self.axes[2].samples(layer) {
            self.read(number, source)?;
            let Some((_, samples)) = self.samples.iter().find(|(own, _)| *own == number) else { continue };
            let row = Row {
                axes: self.axes,
                first: self.stripe.samples.start,
                wide: source.frame().size[0],
                samples,
                weight,
            };
            let first = self.stripe.voxels.start;
            let rows = self.sums.par_chunks_mut(width).enumerate().with_min_len(8);
            rows.for_each(|(at, sums)| row.add(first + at, sums));
        }
        Ok(())
    }

    /// Sums the samples of a layer of voxels and asks the transfer function about each.
    fn look(
        &mut self,
        layer: usize,
        reused: Option<SeenLayer>,
        source: &mut dyn SampleSource,
    ) -> Result<SeenLayer, VoxelizeError> {
        self.sum(layer, source)?;
        let (width, words, rows) = (self.width(), self.words(), self.stripe.voxels.len());
        let mut seen =
            reused.unwrap_or_else(|| SeenLayer { bits: vec![0; words * rows], materials: vec![EMPTY; width * rows] });
        let lookup = self.lookup;
        let all =
            seen.bits.par_chunks_mut(words).zip(seen.materials.par_chunks_mut(width)).zip(self.sums.par_chunks(width));
        all.with_min_len(8).for_each(|((bits, materials), sums)| {
            for ((word, materials), sums) in bits.iter_mut().zip(materials.chunks_mut(WORD)).zip(sums.chunks(WORD)) {
                let mut truths = [false; WORD];
                lookup.see(sums, &mut truths);
                *word = packed(&truths);
                if *word != 0 {
                    materials.iter_mut().zip(sums).for_each(|(own, &value)| *own = lookup.material(value));
                }
            }
        });
        Ok(seen)
    }

    /// Makes a layer of samples one of those that are kept.
    fn read(&mut self, number: usize, source: &mut dyn SampleSource) -> Result<(), VoxelizeError> {
        if self.samples.iter().any(|(own, _)| *own == number) {
            return Ok(());
        }
        let mut values =
            if self.samples.len() < KEPT { Vec::new() } else { self.samples.pop_front().unwrap_or_default().1 };
        values.resize(self.stripe.samples.len() * source.frame().size[0], 0.0);
        source.read(number, self.stripe.samples.clone(), &mut values)?;
        self.samples.push_back((number, values));
        Ok(())
    }
}

/// A layer of samples as a part of the sums of a layer of voxels.
struct Row<'a> {
    axes: [&'a Axis; 3],
    /// The first row of samples that is here, and samples of a row.
    first: usize,
    wide: usize,
    samples: &'a [f32],
    weight: f32,
}

impl Row<'_> {
    /// Adds what it has of a row of voxels.
    fn add(&self, row: usize, sums: &mut [f32]) {
        let (across, wide) = (self.axes[0], self.wide);
        let is_alike = across.count() == wide;
        let is_backward = is_alike && wide > 1 && across.taps[0].start > 0;
        for (number, weight_y) in self.axes[1].samples(row) {
            let samples = &self.samples[(number - self.first) * wide..][..wide];
            if is_alike {
                let weight = weight_y * self.weight;
                if is_backward {
                    sums.iter_mut().zip(samples.iter().rev()).for_each(|(sum, sample)| *sum += weight * sample);
                } else {
                    sums.iter_mut().zip(samples).for_each(|(sum, sample)| *sum += weight * sample);
                }
                continue;
            }
            for (sum, taps) in sums.iter_mut().zip(&across.taps) {
                for (weight_x, sample) in taps.weights.iter().zip(&samples[taps.start..]) {
                    *sum += weight_x * weight_y * self.weight * sample;
                }
            }
        }
    }
}
