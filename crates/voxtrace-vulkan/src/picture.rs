//! What a window shows while a film is made: the mean radiance of its pixels as half floats, in a buffer of the device that
//! draws the window, so that nothing is read back, and beside it what that looks like through a tone curve. Twin of
//! `shaders/pass/resolve.slang` and `shaders/half.slang`.

use crate::buffer::Buffer;
use crate::device::Device;
use ash::vk;
use bytemuck::{Pod, Zeroable};
use gpu_allocator::MemoryLocation;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use voxtrace_core::film::Pixel;
use voxtrace_core::{Film, TraceError};

/// Bytes of a pixel: red, green, blue and coverage as half floats; coverage is −1 where there is no sample.
const PIXEL_BYTES: u64 = 8;
/// Largest finite half float.
const HALF_MAX: f32 = 65504.0;

/// Place of the picture in descriptor set 0 of the shaders that show it.
pub const PICTURE_BINDING: u32 = 0;
/// Place of what is to be seen of it.
pub const DISPLAY_BINDING: u32 = 1;
/// Bytes of a pixel that is to be seen: red, green, blue and opacity.
const DISPLAY_PIXEL_BYTES: u64 = 4;

/// What [`PresentParams::curve`] has besides where blue is the lowest byte of what is to be seen, as images of many windows have it, and not red.
pub const BLUE_LOWEST: u32 = 256;

/// How a picture was made visible: the factor on its radiance, and the number of the curve, as in [`PresentParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// Factor on the radiance.
    pub exposure: f32,
    /// The curve from radiance to signal.
    pub curve: u32,
}

/// How a picture is drawn: the push constants of [`crate::present_shader`].
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct PresentParams {
    /// Upper left corner of the picture in the window, pixels.
    pub corner: [f32; 2],
    /// Its size in the window, pixels.
    pub size: [f32; 2],
    /// Its own width, pixels.
    pub width: u32,
    /// Its own height, pixels.
    pub height: u32,
    /// Factor on the radiance.
    pub exposure: f32,
    /// The curve from radiance to signal: 0 AgX, 1 neutral, 2 Reinhard, 3 linear; with `BLUE_LOWEST` or without.
    pub curve: u32,
}

/// A picture that lies under a film's: it is seen until the film has as many samples as it needs.
#[derive(Clone, Copy)]
pub struct Under<'a> {
    /// It shows the same view, with as many pixels or fewer.
    pub picture: &'a Picture,
    /// How much of the film is seen, 0 to 1.
    pub film_weight: f32,
}

/// A picture of `width` × `height` pixels on a device, row by row.
pub struct Picture {
    device: Arc<Device>,
    buffer: Buffer,
    /// The signal of its pixels, for what draws.
    display: Buffer,
    /// What that was made with, `None` where it is not what the picture looks like.
    tone: Mutex<Option<Tone>>,
    width: u32,
    height: u32,
}

impl Picture {
    /// A picture whose content is undefined. The host can write one that `is_written_by_host`, as films of the CPU need.
    ///
    /// # Errors
    /// [`TraceError::OutOfMemory`]; what the driver answers.
    pub fn new(device: &Arc<Device>, width: u32, height: u32, is_written_by_host: bool) -> Result<Self, TraceError> {
        let pixels = u64::from(width) * u64::from(height);
        let bytes = pixels * PIXEL_BYTES;
        let limit = device.info().limits.max_storage_bytes();
        if bytes > limit {
            return Err(TraceError::OutOfMemory { needed: bytes, available: limit });
        }
        let location = if is_written_by_host { MemoryLocation::CpuToGpu } else { MemoryLocation::GpuOnly };
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        let buffer = Buffer::new(device, "picture", bytes, usage, location)?;
        let display = Buffer::storage(device, "picture as seen", pixels * DISPLAY_PIXEL_BYTES)?;
        Ok(Self { device: Arc::clone(device), buffer, display, tone: Mutex::new(None), width, height })
    }

    /// Width and height, pixels.
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Whether the host can write it.
    pub fn is_written_by_host(&self) -> bool {
        !self.buffer.mapped().is_empty()
    }

    /// The device that it lies on.
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// The buffer, for descriptors of whoever shows it.
    pub fn handle(&self) -> vk::Buffer {
        self.buffer.handle
    }

    /// The buffer of what is to be seen: a word for each pixel, red in its lowest byte, then green, blue and opacity, or blue in its lowest, as its
    /// tone says. It can be copied from.
    pub fn display(&self) -> vk::Buffer {
        self.display.handle
    }

    /// Whether that was made of the picture with this tone.
    pub fn has_tone(&self, tone: Tone) -> bool {
        *self.tone() == Some(tone)
    }

    /// Says that it is, by what was submitted to the queue that shows pictures.
    pub fn set_tone(&self, tone: Tone) {
        *self.tone() = Some(tone);
    }

    fn tone(&self) -> MutexGuard<'_, Option<Tone>> {
        self.tone.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The buffer, for a pass that reads it.
    pub(crate) fn to_read(&self) -> &Buffer {
        &self.buffer
    }

    /// The buffer, for a pass that writes it: what is to be seen has to be made anew.
    pub(crate) fn to_write(&self) -> &Buffer {
        *self.tone() = None;
        &self.buffer
    }

    /// The radiance of its pixels, row by row, where the host can write it: for tests.
    #[doc(hidden)]
    pub fn radiance(&self) -> Vec<[f32; 3]> {
        let half = |bytes: [u8; 2]| number_of(u16::from_le_bytes(bytes));
        let pixel = |bytes: &[u8]| [0, 2, 4].map(|at| half([bytes[at], bytes[at + 1]]));
        let pixels = self.buffer.mapped().chunks_exact(PIXEL_BYTES as usize).map(pixel);
        pixels.take((self.width * self.height) as usize).collect()
    }

    /// Writes a film of the whole picture from the host.
    ///
    /// # Panics
    /// Where the film has another size, or the picture was not made to be written by the host.
    pub fn write(&mut self, film: &Film) {
        assert_eq!((film.width, film.height), self.size(), "a film of another size");
        *self.tone() = None;
        let bytes = self.buffer.mapped_mut();
        let records = bytes.chunks_exact_mut(PIXEL_BYTES as usize);
        assert!(records.len() >= film.pixels.len(), "the host cannot write this picture");
        for (record, pixel) in records.zip(&film.pixels) {
            record.copy_from_slice(bytemuck::bytes_of(&halves_of(pixel)));
        }
    }
}

/// The mean radiance and the coverage of a pixel.
fn halves_of(pixel: &Pixel) -> [u16; 4] {
    let mean = pixel.mean();
    let coverage = if pixel.samples == 0 { -1.0 } else { pixel.alpha() };
    [mean.x, mean.y, mean.z, coverage].map(half_of)
}

/// The half float of a finite number, rounded towards zero; what is larger than any becomes the largest (IEEE 754, binary16).
fn half_of(value: f32) -> u16 {
    let bits = value.clamp(-HALF_MAX, HALF_MAX).to_bits();
    let (sign, exponent, mantissa) = (bits >> 16 & 0x8000, (bits >> 23 & 0xff) as i32 - 112, bits & 0x7f_ffff);
    let magnitude = match exponent {
        1.. => (exponent as u32) << 10 | mantissa >> 13,
        // Denormal: the leading one becomes part of the mantissa.
        -10..=0 => (mantissa | 0x80_0000) >> (14 - exponent),
        _ => 0,
    };
    (sign | magnitude) as u16
}

/// The number that a finite half float stands for.
fn number_of(half: u16) -> f32 {
    let sign = if half & 0x8000 != 0 { -1.0 } else { 1.0 };
    let (exponent, mantissa) = (i32::from(half >> 10 & 0x1f), f32::from(half & 0x3ff));
    match exponent {
        0 => sign * mantissa * 2f32.powi(-24),
        _ => sign * (1.0 + mantissa / 1024.0) * 2f32.powi(exponent - 15),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::glam::Vec3;

    /// The number that a half float stands for.
    fn number_of(half: u16) -> f64 {
        super::number_of(half).into()
    }

    #[test]
    fn halves_are_within_their_precision_below_the_number() {
        for step in -1000..1000 {
            let value = (f64::from(step) * 0.021).exp2() as f32;
            let half = number_of(half_of(value));
            let expected = f64::from(value.min(HALF_MAX));
            assert!(half <= expected && expected - half <= (expected / 1024.0).max(2f64.powi(-24)), "{value} {half}");
            assert_eq!(number_of(half_of(-value)), -half);
        }
        assert_eq!((number_of(half_of(1.0)), number_of(half_of(-1.0)), half_of(0.0)), (1.0, -1.0, 0));
        assert_eq!(number_of(half_of(f32::INFINITY)), f64::from(HALF_MAX));
    }

    #[test]
    fn a_pixel_without_samples_says_so() {
        assert_eq!(number_of(halves_of(&Pixel::default())[3]), -1.0);
        let mut pixel = Pixel::default();
        pixel.add(Vec3::new(0.5, 2.0, 1e9), true);
        let halves = halves_of(&pixel).map(number_of);
        assert_eq!(halves, [0.5, 2.0, f64::from(HALF_MAX), 1.0]);
    }
}
