//! The window of a stripe: for ten layers of voxels, eight of bricks and one at either side, which voxels are seen and in which material.
//! Axes are those of the lattice. Where few layers of samples lie under a layer of voxels, they are kept until it is made; else they are
//! summed as they come.

use super::super::resample::Axis;
use super::super::slab::{EDGE, WORD};
use super::super::transfer::EMPTY;
use super::across::Across;
use super::ahead::Ahead;
use super::classes::{Classes, Stored};
use super::rows::{RowReader, Scratch, WeightedRow};
use super::stripes::{FEW, Stripe};
use super::tally::Tally;
use super::{Block, Coding};
use crate::voxelize::{VoxelizeError, VoxelizeProgress};
use rayon::prelude::*;
use std::collections::VecDeque;

/// Rows of voxels that are worth a task.
const ROWS: usize = 8;

/// Layers of voxels around a layer of bricks.
pub(super) struct Window<'a> {
    axes: [&'a Axis; 3],
    across: Across<'a>,
    classes: &'a Classes<'a>,
    coding: &'a Coding,
    pub stripe: Stripe,
    /// Samples of a row.
    wide: usize,
    /// Layers of voxels with their number.
    layers: Vec<(usize, SeenLayer)>,
    /// Layers of samples with their number, the last one read at the back.
    samples: VecDeque<(usize, Block)>,
    sums: Vec<f32>,
}

/// One layer of a stripe's voxels.
pub(super) struct SeenLayer {
    /// A bit for each voxel that is seen, rows in whole words.
    pub bits: Vec<u64>,
    /// Its material.
    materials: Vec<u16>,
}

/// Where layers of samples come from, and who counts them from a row on.
pub(super) struct Feed<'t, 'c> {
    pub ahead: Ahead,
    pub tally: Option<(&'t mut Tally<'c>, usize)>,
}

impl<'a> Window<'a> {
    /// The window of a stripe over rows of `wide` samples.
    pub fn new(
        axes: [&'a Axis; 3],
        (stripe, wide): (Stripe, usize),
        classes: &'a Classes<'a>,
        coding: &'a Coding,
    ) -> Self {
        let (layers, samples, sums) = (Vec::new(), VecDeque::new(), Vec::new());
        Self { axes, across: Across::new(axes[0], wide), classes, coding, stripe, wide, layers, samples, sums }
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

    /// The bits of a row, none where nobody looked.
    pub fn row<'l>(&self, layer: Option<&'l SeenLayer>, row: usize) -> &'l [u64] {
        let at = row.checked_sub(self.stripe.voxels.start).filter(|_| row < self.stripe.voxels.end);
        let words = self.words();
        layer.zip(at).map_or(&[], |(layer, at)| &layer.bits[at * words..][..words])
    }

    /// The materials of the voxels that are seen, from one of them on; none beyond the grid.
    pub fn materials<'l>(&self, layer: Option<&'l SeenLayer>, [x, row]: [usize; 2]) -> &'l [u16] {
        let first = (row - self.stripe.voxels.start) * self.width() + x;
        layer.map_or(&[], |layer| &layer.materials[first..])
    }

    /// The layers of voxels of a layer of bricks and its neighbours, in the order of the samples.
    fn wanted(&self, layer: usize) -> Vec<usize> {
        let wanted = (layer * EDGE).saturating_sub(1)..((layer + 1) * EDGE + 1).min(self.axes[2].count());
        if self.is_backward() { wanted.rev().collect() } else { wanted.collect() }
    }

    /// The layers of samples that are needed from one layer of bricks to another, in the order of the samples; in ascending order.
    pub fn needed(&self, first: usize, last: usize) -> Vec<usize> {
        let ends = self.wanted(first).into_iter().chain(self.wanted(last));
        let (low, high) = ends.fold((usize::MAX, 0), |(low, high), at| (low.min(at), high.max(at)));
        let mut needed: Vec<usize> =
            (low..=high).flat_map(|at| self.axes[2].samples(at).map(|(number, _)| number)).collect();
        needed.sort_unstable();
        needed.dedup();
        needed
    }

    /// Looks at the layers of voxels of a layer of bricks and its neighbours.
    pub fn move_to(&mut self, layer: usize, feed: &mut Feed, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        let wanted = self.wanted(layer);
        let mut free = Vec::new();
        let mut kept = Vec::new();
        for (at, seen) in std::mem::take(&mut self.layers) {
            if wanted.contains(&at) { kept.push((at, seen)) } else { free.push(seen) }
        }
        self.layers = kept;
        for at in wanted {
            if self.layers.iter().all(|(own, _)| *own != at) {
                if progress.is_cancelled() {
                    return Err(VoxelizeError::Cancelled);
                }
                let seen = match self.coding {
                    Coding::Bytes(_) => self.look::<u8>(at, free.pop(), feed),
                    Coding::Words(_) => self.look::<u16>(at, free.pop(), feed),
                    Coding::Reals => self.look::<f32>(at, free.pop(), feed),
                };
                self.layers.push((at, seen?));
            }
        }
        Ok(())
    }

    /// Looks at one layer of voxels.
    fn look<S: Stored>(
        &mut self,
        layer: usize,
        reused: Option<SeenLayer>,
        feed: &mut Feed,
    ) -> Result<SeenLayer, VoxelizeError> {
        let (words, width, rows) = (self.words(), self.width(), self.stripe.voxels.len());
        let mut seen =
            reused.unwrap_or_else(|| SeenLayer { bits: vec![0; words * rows], materials: vec![EMPTY; width * rows] });
        let under: Vec<(usize, f32)> = self.axes[2].samples(layer).collect();
        if under.len() > FEW {
            self.sum::<S>(&under, feed)?;
        } else {
            self.forget_before(under[0].0, feed);
            for &(number, _) in &under {
                self.keep(number, feed)?;
            }
        }
        let reader = RowReader { across: &self.across, classes: self.classes };
        let all = seen.bits.par_chunks_mut(words).zip(seen.materials.par_chunks_mut(width)).with_min_len(ROWS);
        if under.len() > FEW {
            let all = all.zip(self.sums.par_chunks(width));
            all.for_each(|((bits, materials), sums)| reader.see(sums, bits, materials));
            return Ok(seen);
        }
        let layers: Vec<(&[S], f32)> =
            under.iter().filter_map(|&(number, weight)| Some((self.samples_of(number)?, weight))).collect();
        let new = || (Scratch::default(), Vec::new());
        all.enumerate().for_each_init(new, |(scratch, parts), (at, (bits, materials))| {
            parts.clear();
            for (samples, weight) in &layers {
                parts.extend(self.rows_under(at, samples, *weight));
            }
            reader.read(parts, bits, materials, scratch);
        });
        Ok(seen)
    }

    /// The values of a layer of voxels, those of the stripe's own bricks alone. Layers are asked for in the order of the samples.
    pub fn own_values(&mut self, layer: usize, feed: &mut Feed) -> Result<&[f32], VoxelizeError> {
        let under: Vec<(usize, f32)> = self.axes[2].samples(layer).collect();
        match self.coding {
            Coding::Bytes(_) => self.sum::<u8>(&under, feed),
            Coding::Words(_) => self.sum::<u16>(&under, feed),
            Coding::Reals => self.sum::<f32>(&under, feed),
        }?;
        let (width, stripe) = (self.width(), &self.stripe);
        let own = stripe.bricks.start * EDGE..(stripe.bricks.end * EDGE).min(stripe.voxels.end);
        let from = stripe.voxels.start;
        Ok(&self.sums[(own.start - from) * width..(own.end - from) * width])
    }

    /// Sums the samples under a layer of voxels as they come.
    fn sum<S: Stored>(&mut self, under: &[(usize, f32)], feed: &mut Feed) -> Result<(), VoxelizeError> {
        let width = self.width();
        let mut sums = std::mem::take(&mut self.sums);
        sums.clear();
        sums.resize(width * self.stripe.voxels.len(), 0.0);
        for &(number, weight) in under {
            // Where few are under a layer, the next one may need the same.
            self.forget_before(if under.len() > FEW { number } else { under[0].0 }, feed);
            self.keep(number, feed)?;
            let Some(samples) = self.samples_of::<S>(number) else { continue };
            let reader = RowReader { across: &self.across, classes: self.classes };
            let rows = sums.par_chunks_mut(width).enumerate().with_min_len(ROWS);
            rows.for_each_init(Scratch::default, |scratch, (at, sums)| {
                self.rows_under(at, samples, weight).for_each(|row| reader.add_all(&row, sums, scratch));
            });
        }
        self.sums = sums;
        Ok(())
    }

    /// The rows of samples under a row of the stripe's voxels, in a layer of samples.
    fn rows_under<'s, S>(
        &self,
        at: usize,
        samples: &'s [S],
        weight: f32,
    ) -> impl Iterator<Item = WeightedRow<'s, S>> + use<'_, 's, 'a, S> {
        let (first, wide) = (self.stripe.samples.start, self.wide);
        self.axes[1].samples(self.stripe.voxels.start + at).map(move |(number, weight_y)| WeightedRow {
            samples: &samples[(number - first) * wide..][..wide],
            weights: [weight_y, weight],
        })
    }

    fn samples_of<S: Stored>(&self, number: usize) -> Option<&[S]> {
        self.samples.iter().find(|(own, _)| *own == number).map(|(_, block)| S::of(block))
    }

    /// Gives layers of samples back that nobody asks for any more.
    fn forget_before(&mut self, number: usize, feed: &Feed) {
        while self.samples.front().is_some_and(|(own, _)| *own < number) {
            if let Some((_, block)) = self.samples.pop_front() {
                feed.ahead.give_back(block);
            }
        }
    }

    /// Makes a layer of samples one of those that are kept.
    fn keep(&mut self, number: usize, feed: &mut Feed) -> Result<(), VoxelizeError> {
        while self.samples.back().is_none_or(|(last, _)| *last < number) {
            let (read, block) = feed.ahead.next()?;
            if let Some((tally, first)) = &mut feed.tally {
                tally.add(&block, *first);
            }
            self.samples.push_back((read, block));
        }
        Ok(())
    }
}
