//! FLIP as a picture: dark where two pictures look alike, bright where they differ, in the colour map magma (S. van der Walt, N.
//! Smith, 2015) by a polynomial that fits it (M. Zucker, 2019).

use super::Difference;
use crate::output::png_error;
use glam::DVec3;
use std::io::{self, Write};

/// Coefficients of the powers 0 to 6.
const MAGMA: [DVec3; 7] = [
    DVec3::new(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933),
    DVec3::new(0.2516605407371642, 0.6775232436837668, 2.494026599312351),
    DVec3::new(8.353717279216625, -3.577719514958484, 0.3144679030132573),
    DVec3::new(-27.66873308576866, 14.26473078096533, -13.64921318813922),
    DVec3::new(52.17613981234068, -27.94360607168351, 12.94416944238394),
    DVec3::new(-50.76852536473588, 29.04658282127291, 4.23415299384598),
    DVec3::new(18.65570506591883, -11.48977351997711, -5.601961508734096),
];

/// The sRGB bytes of a value in [0, 1].
fn magma(value: f32) -> [u8; 3] {
    let color = MAGMA.iter().rev().fold(DVec3::ZERO, |sum, &coefficient| sum * f64::from(value) + coefficient);
    color.to_array().map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8)
}

impl Difference {
    /// Writes FLIP of each pixel as a PNG: black for 0, pale yellow for 1.
    ///
    /// # Errors
    /// What the writer reports.
    pub fn write_map(&self, writer: impl Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(writer, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let software = concat!("voxtrace ", env!("CARGO_PKG_VERSION")).to_owned();
        encoder.add_text_chunk("Software".into(), software).map_err(png_error)?;
        let bytes: Vec<u8> = self.flip.iter().flat_map(|&value| magma(value)).collect();
        let mut encoder = encoder.write_header().map_err(png_error)?;
        encoder.write_image_data(&bytes).map_err(png_error)?;
        encoder.finish().map_err(png_error)
    }
}

#[cfg(test)]
mod tests {
    use super::magma;

    #[test]
    fn the_map_goes_from_black_to_pale_yellow_and_ever_brighter() {
        let (black, yellow) = (magma(0.0), magma(1.0));
        assert!(black.iter().all(|&byte| byte < 8), "{black:?}");
        assert!(yellow[0] > 245 && yellow[1] > 245 && (170..210).contains(&yellow[2]), "{yellow:?}");
        let light = |value: f32| magma(value).map(u32::from).iter().zip([2, 7, 1]).map(|(a, b)| a * b).sum::<u32>();
        assert!((0..64).all(|step| light(step as f32 / 64.0) < light((step + 1) as f32 / 64.0)));
    }
}
