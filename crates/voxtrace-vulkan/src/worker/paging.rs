//! Rendering where the scene lies on the device in pages: block after block of pixels, each until all its samples found their pages.

use super::Worker;
use crate::film::DeviceFilm;
use crate::pages::Served;
use crate::records::{Counter, Dispatch};
use crate::variant::Variant;
use crate::watch::Watch;
use std::time::Instant;
use voxtrace_core::{Frame, TraceError};

/// How a block of pixels ended.
enum Block {
    Finished,
    /// Its rays need more pages than there is room for.
    TooLarge,
    /// There was no more time, or nobody waits for it.
    BrokenOff,
}

impl Worker {
    /// Brings the pages that the last submit came to and did not find. Nothing may be in flight.
    pub(super) fn serve_pages(&mut self) -> Result<Served, TraceError> {
        let buffers = self.scene.as_mut().ok_or(TraceError::NoScene)?;
        let geometry = buffers.scene.geometry();
        match &mut buffers.pages {
            Some(pages) => pages.serve(&mut self.submitter, &mut self.transfer, geometry),
            None => Ok(Served::Everything),
        }
    }

    /// Half of so many pixels, whose rays need more pages than there is room for.
    pub(super) fn fewer_pixels(&self, count: u64) -> Result<u64, TraceError> {
        match count {
            0 | 1 => {
                let needed = self.scene.as_ref().map_or(0, |buffers| buffers.pages.as_ref().map_or(0, |p| p.pool.size));
                Err(TraceError::OutOfMemory { needed: 2 * needed, available: needed })
            }
            count => Ok(count / 2),
        }
    }

    /// As `render_part`. The first pass gives each pixel of the part a sample; later ones finish block after block, so that what the rays of a block come to
    /// is there for all its samples.
    pub(super) fn render_part_in_pages(
        &mut self,
        film: &mut DeviceFilm,
        (index, target): (usize, u32),
        frame: &Frame,
        progress: &mut Watch,
        until: Instant,
    ) -> Result<bool, TraceError> {
        let part = &mut film.parts[index];
        let variant = self.prepare_part(part, 0, frame)?;
        let pixels = part.region.pixels() as u64;
        while part.samples < target {
            let goal = if part.samples == 0 { 1 } else { target };
            // Blocks that a call which was broken off finished are neither gone through nor counted again.
            let mut first = if part.ahead.0 == goal { part.ahead.1 } else { 0 };
            while first < pixels {
                let count = self.pixels_at_a_time.min(pixels - first).min(self.passes.most_items());
                match self.render_block(variant, (first, count), goal, progress, until)? {
                    Block::Finished => {
                        progress.add(count * u64::from(goal - part.samples));
                        first += count;
                        part.ahead = (goal, first);
                        // Other places may need less.
                        self.pixels_at_a_time = self.pixels_at_a_time.saturating_add(self.pixels_at_a_time / 8 + 1);
                    }
                    Block::TooLarge => self.pixels_at_a_time = self.fewer_pixels(count)?,
                    Block::BrokenOff => return Ok(progress.is_cancelled()),
                }
            }
            part.samples = goal;
        }
        Ok(true)
    }

    /// Gives each of `count` pixels from `first` on `goal` samples.
    fn render_block(
        &mut self,
        variant: Variant,
        (first, count): (u64, u64),
        goal: u32,
        progress: &Watch,
        until: Instant,
    ) -> Result<Block, TraceError> {
        loop {
            if progress.is_cancelled() || Instant::now() >= until {
                return Ok(Block::BrokenOff);
            }
            let samples = (self.render_batches.units() / count).clamp(1, u64::from(goal)) as u32;
            let dispatch = Dispatch {
                first: first as u32,
                count: count as u32,
                samples,
                samples_target: goal,
                ..Dispatch::default()
            };
            self.submit("rendering", variant, dispatch, count * u64::from(samples), None)?;
            let mut rays = 0;
            while let Some(finished) = self.submitter.wait()? {
                rays = u64::from(finished.counters[Counter::CameraRays as usize]);
                self.render_batches.update(rays, finished.gpu_ms);
                self.statistics.add(&finished);
            }
            // Rays are counted for all samples that pixels lack, traced to their end or not.
            if rays == 0 {
                return Ok(Block::Finished);
            }
            if self.serve_pages()? == Served::Nothing {
                return Ok(Block::TooLarge);
            }
        }
    }
}
