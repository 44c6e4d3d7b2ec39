//! Films as pictures for browsers.

use rayon::prelude::*;
use std::io;
use voxtrace::glam::Vec3;
use voxtrace::output::ToneMap;

/// What a screen shows: red, green and blue of sRGB, a byte each, row by row.
pub struct Shown {
    pub width: u32,
    pub height: u32,
    pub samples: Vec<u8>,
}

impl Shown {
    /// Of the mean radiance of each pixel, by the tone mapping of pictures that are saved.
    pub fn new(width: u32, height: u32, radiance: impl Fn(usize) -> Vec3 + Sync) -> Self {
        let map = ToneMap::default();
        let mut samples = vec![0; width as usize * height as usize * 3];
        samples.par_chunks_exact_mut(3).with_min_len(1024).enumerate().for_each(|(index, pixel)| {
            let signal = map.signal(radiance(index)).to_array();
            pixel.copy_from_slice(&signal.map(|value| (value * 255.0).round() as u8));
        });
        Self { width, height, samples }
    }

    /// As a JPEG of that quality, 1 to 100, behind what `bytes` has already.
    pub fn append_jpeg(&self, bytes: &mut Vec<u8>, quality: u8) -> io::Result<()> {
        let mut encoder = jpeg_encoder::Encoder::new(bytes, quality);
        // Voxels are small and of strong colours: these must not run.
        encoder.set_sampling_factor(jpeg_encoder::SamplingFactor::R_4_4_4);
        let size = |length: u32| u16::try_from(length).map_err(io::Error::other);
        let (width, height) = (size(self.width)?, size(self.height)?);
        encoder.encode(&self.samples, width, height, jpeg_encoder::ColorType::Rgb).map_err(io::Error::other)
    }

    /// As a PNG, without loss, behind what `bytes` has already.
    pub fn append_png(&self, bytes: &mut Vec<u8>) -> io::Result<()> {
        let mut encoder = png::Encoder::new(bytes, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Fast);
        let mut writer = encoder.write_header().map_err(io::Error::other)?;
        writer.write_image_data(&self.samples).map_err(io::Error::other)?;
        writer.finish().map_err(io::Error::other)
    }
}
