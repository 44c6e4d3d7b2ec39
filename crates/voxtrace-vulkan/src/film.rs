//! The film on the device: the sums of its pixels, in as many buffers as the device's limits ask for.

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::transfer::Transfer;
use ash::vk;
use bytemuck::{cast_slice, cast_slice_mut};
use std::sync::Arc;
use voxtrace_core::Film;
use voxtrace_core::Frame;
use voxtrace_core::Region;
use voxtrace_core::TraceError;
use voxtrace_core::film::{AovPixel, Pixel};

const PIXEL_BYTES: u64 = size_of::<Pixel>() as u64;

/// Whole rows of the film.
pub struct Part {
    /// The rows, pixels of the whole picture.
    pub region: Region,
    pub pixels: Buffer,
    /// Samples that every pixel of the part has at least.
    pub samples: u32,
    /// How many samples the first pixels have already, and how many pixels those are, where the scene lies in pages.
    pub ahead: (u32, u64),
}

/// A film that accumulates on the device.
pub struct DeviceFilm {
    /// What it shows.
    pub frame: Frame,
    pub parts: Vec<Part>,
    /// The AOVs, once they were asked for.
    pub aovs: Option<Vec<AovPixel>>,
}

impl DeviceFilm {
    /// A black film of a frame.
    pub fn new(device: &Arc<Device>, submitter: &mut Submitter, frame: &Frame) -> Result<Self, TraceError> {
        let limit = device.info().limits.max_storage_bytes().min(u64::from(u32::MAX));
        let mut parts = Vec::new();
        for region in parts_of(frame.region, limit / PIXEL_BYTES) {
            let pixels = Buffer::storage(device, "film", region.pixels() as u64 * PIXEL_BYTES)?;
            submitter.run_commands("clearing the film", &|commands| {
                // SAFETY: the buffer is alive; the commands are being recorded.
                unsafe { device.raw.cmd_fill_buffer(commands, pixels.handle, 0, vk::WHOLE_SIZE, 0) }
            })?;
            parts.push(Part { region, pixels, samples: 0, ahead: (0, 0) });
        }
        Ok(Self { frame: frame.clone(), parts, aovs: None })
    }

    /// Overwrites the device's sums with those of `film`, which shows the same region.
    pub fn upload(
        &mut self,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        film: &Film,
    ) -> Result<(), TraceError> {
        let mut rest = &film.pixels[..];
        for part in &mut self.parts {
            let (own, others) = rest.split_at(part.region.pixels());
            rest = others;
            transfer.upload(submitter, &part.pixels, cast_slice(own))?;
            part.samples = own.iter().map(|pixel| pixel.samples).min().unwrap_or(0);
        }
        self.aovs.clone_from(&film.aovs);
        Ok(())
    }

    /// Copies the device's sums.
    pub fn download(
        &self,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        film: &mut Film,
    ) -> Result<(), TraceError> {
        let frame = &self.frame;
        let mut pixels = std::mem::take(&mut film.pixels);
        pixels.resize(frame.region.pixels(), Pixel::default());
        let mut rest = &mut pixels[..];
        for part in &self.parts {
            let (own, others) = rest.split_at_mut(part.region.pixels());
            rest = others;
            transfer.download(submitter, &part.pixels, 0, cast_slice_mut(own))?;
        }
        *film = Film {
            width: frame.width,
            height: frame.height,
            region: frame.region,
            first_sample: frame.first_sample,
            pixels,
            aovs: self.aovs.clone(),
            earlier: None,
            groups: Vec::new(),
        };
        Ok(())
    }
}

/// Cuts a region into parts of whole rows of at most `most` pixels, at least one row each.
fn parts_of(region: Region, most: u64) -> impl Iterator<Item = Region> {
    let rows = (most / u64::from(region.width().max(1))).clamp(1, u64::from(u32::MAX)) as u32;
    (region.y0..region.y1).step_by(rows as usize).map(move |y0| Region {
        y0,
        y1: y0.saturating_add(rows).min(region.y1),
        ..region
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_join_to_the_region() {
        let region = Region { x0: 3, y0: 5, x1: 103, y1: 38 };
        for most in [1, 100, 999, 1000, 1_000_000] {
            let parts: Vec<Region> = parts_of(region, most).collect();
            assert_eq!((parts[0].y0, parts[parts.len() - 1].y1), (5, 38));
            assert!(parts.windows(2).all(|pair| pair[0].y1 == pair[1].y0));
            assert!(parts.iter().all(|part| part.pixels() as u64 <= most.max(100)));
        }
        assert_eq!(parts_of(region, 1000).count(), 4);
    }
}
