//! First hits of rays, and the AOVs that follow from them.

use super::Worker;
use crate::buffer::Buffer;
use crate::commands::Finished;
use crate::pages::Served;
use crate::records::{Dispatch, FrameParams, LENS_PINHOLE, SKY_GRADIENT, binding};
use crate::statistics::Statistics;
use crate::variant::{Entry, Variant};
use bytemuck::{cast_slice, cast_slice_mut};
use std::sync::Arc;
use voxtrace_core::film::AovPixel;
use voxtrace_core::{Frame, TraceError, aov};
use voxtrace_scene::{Hit, Ray};

/// Most rays that are cast in one piece, and how many are at least, however little memory there is.
const RAYS_AT_A_TIME: usize = 1 << 20;
const FEWEST_RAYS: usize = 1 << 10;

impl Worker {
    /// As [`voxtrace_core::Tracer::cast_into`], with hits of the grids as they are packed.
    pub fn cast(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        assert_eq!(rays.len(), hits.len(), "one hit for each ray");
        let variant = self.variant(Entry::Cast, (LENS_PINHOLE, SKY_GRADIENT), None)?;
        self.passes.prepare(variant)?;
        self.statistics = Statistics::default();
        if rays.is_empty() {
            return Ok(());
        }
        let params = FrameParams::of_scene(self.scene()?);
        self.set_params(&params);
        let bytes = (size_of::<Ray>() + size_of::<Hit>()) as u64;
        let fitting = usize::try_from(self.device.available_bytes() / 2 / bytes).unwrap_or(usize::MAX);
        let piece = rays.len().min(RAYS_AT_A_TIME).min(fitting.max(FEWEST_RAYS));
        let ray_buffer = Buffer::storage(&self.device, "rays", (piece * size_of::<Ray>()) as u64)?;
        let hit_buffer = Buffer::storage(&self.device, "hits", (piece * size_of::<Hit>()) as u64)?;
        self.bindings.bind(binding::RAYS, &ray_buffer);
        self.bindings.bind(binding::HITS, &hit_buffer);
        self.cast_buffers = Some((ray_buffer, hit_buffer));
        let result = rays
            .chunks(piece)
            .zip(hits.chunks_mut(piece))
            .try_for_each(|(rays, hits)| self.cast_piece(variant, rays, hits));
        self.bindings.bind(binding::RAYS, &self.nothing);
        self.bindings.bind(binding::HITS, &self.nothing);
        self.cast_buffers = None;
        result
    }

    /// Casts as many rays as the buffers hold.
    fn cast_piece(&mut self, variant: Variant, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        let (ray_buffer, hit_buffer) = self.cast_buffers.take().ok_or(TraceError::NoScene)?;
        self.transfer.upload(&mut self.submitter, &ray_buffer, cast_slice(rays))?;
        let mut at = 0;
        while at < rays.len() as u64 {
            let count = self
                .cast_batches
                .units()
                .next_multiple_of(64)
                .min(rays.len() as u64 - at)
                .min(self.passes.most_items())
                .min(if variant.has_pages { self.pixels_at_a_time } else { u64::MAX });
            let dispatch = Dispatch { first: at as u32, count: count as u32, ..Dispatch::default() };
            let finished = self.submit("casting rays", variant, dispatch, count, None)?;
            self.cast_done(finished);
            if variant.has_pages {
                while let Some(finished) = self.submitter.wait()? {
                    self.cast_done(Some(finished));
                }
                match self.serve_pages()? {
                    Served::Everything => {}
                    Served::Some => continue,
                    Served::Nothing => {
                        self.pixels_at_a_time = self.fewer_pixels(count)?;
                        continue;
                    }
                }
            }
            at += count;
        }
        while let Some(finished) = self.submitter.wait()? {
            self.cast_done(Some(finished));
        }
        self.transfer.download(&mut self.submitter, &hit_buffer, 0, cast_slice_mut(hits))?;
        self.cast_buffers = Some((ray_buffer, hit_buffer));
        Ok(())
    }

    fn cast_done(&mut self, finished: Option<Finished>) {
        if let Some(finished) = finished {
            self.cast_batches.update(finished.work, finished.gpu_ms);
            self.statistics.add(&finished);
        }
    }

    /// The AOVs of a frame: rays on the device, materials on the host.
    pub(super) fn aov_pixels(&mut self, frame: &Frame) -> Result<Vec<AovPixel>, TraceError> {
        let scene = Arc::clone(self.scene()?);
        let camera = frame.camera.frame(frame.width, frame.height);
        let mut pixels = Vec::with_capacity(frame.region.pixels());
        let rows_at_a_time = (RAYS_AT_A_TIME as u32 / frame.region.width()).max(1);
        let rows: Vec<u32> = (0..frame.region.height()).collect();
        for rows in rows.chunks(rows_at_a_time as usize) {
            let rays: Vec<Ray> = rows.iter().flat_map(|&row| aov::rays_of_row(frame, &camera, row)).collect();
            let mut hits = vec![Hit::MISS; rays.len()];
            self.cast(&rays, &mut hits)?;
            pixels.extend(rays.iter().zip(&hits).map(|(ray, hit)| aov::aov_of(&scene, &frame.lines, ray, hit)));
        }
        Ok(pixels)
    }
}
