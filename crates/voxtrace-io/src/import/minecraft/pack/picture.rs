//! A picture of a face: 16 × 16 pixels, of an animation the first frame.

use crate::import::images::texture;
use crate::import::minecraft::looks::mean_color;
use crate::import::minecraft::shapes::EDGE;
use voxtrace_voxelize::Limits;

/// Pixels along an edge.
const SIZE: usize = EDGE as usize;
/// From this opacity on a pixel is there.
const OPAQUE: u8 = 128;

/// Pixels row by row from the top, sRGB with opacity.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::import::minecraft) struct Picture(Vec<[u8; 4]>);

impl Picture {
    /// Decodes a picture and brings it to 16 × 16: by the means of larger ones, by the pixels of smaller ones.
    pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Self, String> {
        let texture = texture::decode(bytes, limits).map_err(|refused| refused.to_string())?;
        let [width, height] = texture.size().map(|edge| edge as usize);
        // Frames of an animation stand below each other.
        let height = if height > width && height.is_multiple_of(width) { width } else { height };
        let texels = texture.texels();
        let span = |edge: usize, at: usize| {
            let first = at * edge / SIZE;
            first..((at + 1) * edge).div_ceil(SIZE).clamp(first + 1, edge.max(first + 1))
        };
        let pixel = |at: usize| {
            let (rows, columns) = (span(height, at / SIZE), span(width, at % SIZE));
            let of: Vec<[u8; 4]> =
                rows.flat_map(|row| columns.clone().map(move |column| texels[row * width + column])).collect();
            mean(&of)
        };
        Ok(Self((0..SIZE * SIZE).map(pixel).collect()))
    }

    fn at(&self, u: i32, v: i32) -> [u8; 4] {
        self.0[v.clamp(0, EDGE - 1) as usize * SIZE + u.clamp(0, EDGE - 1) as usize]
    }

    /// The colour of a pixel, `None` where it is clear.
    pub fn texel(&self, u: i32, v: i32) -> Option<u32> {
        let pixel = self.at(u, v);
        (pixel[3] >= OPAQUE).then_some(color(pixel))
    }

    /// The colour of a pixel that is clear, but not quite.
    pub fn faint(&self, u: i32, v: i32) -> Option<u32> {
        let pixel = self.at(u, v);
        (pixel[3] > 0).then_some(color(pixel))
    }

    pub fn has_holes(&self) -> bool {
        self.0.iter().any(|pixel| pixel[3] < OPAQUE)
    }

    /// The mean of what is there.
    pub fn mean(&self) -> Option<u32> {
        let colors: Vec<u32> = self.0.iter().filter(|pixel| pixel[3] >= OPAQUE).map(|&pixel| color(pixel)).collect();
        (!colors.is_empty()).then(|| mean_color(&colors))
    }

    /// Each channel times that of a tint.
    pub fn tinted(&self, tint: u32) -> Self {
        let [_, red, green, blue] = tint.to_be_bytes();
        let times = |value: u8, tint: u8| (u32::from(value) * u32::from(tint) / 255) as u8;
        Self(self.0.iter().map(|&[r, g, b, a]| [times(r, red), times(g, green), times(b, blue), a]).collect())
    }

    /// With another over it.
    pub fn under(&self, over: &Self) -> Self {
        Self(self.0.iter().zip(&over.0).map(|(&under, &over)| if over[3] >= OPAQUE { over } else { under }).collect())
    }
}

fn color([red, green, blue, _]: [u8; 4]) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

/// The mean of pixels, each as much as it is there.
fn mean(pixels: &[[u8; 4]]) -> [u8; 4] {
    if let [one] = pixels {
        return *one;
    }
    let opacity: u32 = pixels.iter().map(|pixel| u32::from(pixel[3])).sum();
    let there: Vec<u32> = pixels.iter().filter(|pixel| pixel[3] >= OPAQUE).map(|&pixel| color(pixel)).collect();
    let all: Vec<u32> = pixels.iter().map(|&pixel| color(pixel)).collect();
    let [_, red, green, blue] = mean_color(if there.is_empty() { &all } else { &there }).to_be_bytes();
    [red, green, blue, (opacity / pixels.len() as u32) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png(width: u32, height: u32, texels: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.write_header().unwrap().write_image_data(texels).unwrap();
        bytes
    }

    #[test]
    fn pictures_of_any_size_become_sixteen_pixels_wide_and_of_animations_the_first_frame() {
        let decode = |width: u32, height: u32, texel: &dyn Fn(u32, u32) -> [u8; 4]| {
            let texels: Vec<u8> = (0..width * height).flat_map(|at| texel(at % width, at / width)).collect();
            Picture::decode(&png(width, height, &texels), &Limits::default()).unwrap()
        };
        let exact = decode(16, 16, &|x, y| [x as u8, y as u8, 7, 255]);
        assert_eq!((exact.texel(3, 5), exact.texel(15, 0)), (Some(0x03_05_07), Some(0x0f_00_07)));
        let frames = decode(16, 64, &|_, y| [if y < 16 { 9 } else { 200 }; 4].map(|c| c.max(9)));
        assert_eq!(frames.faint(4, 15), Some(0x09_09_09));
        let large = decode(64, 64, &|x, _| if x < 4 { [10, 20, 30, 255] } else { [90, 90, 90, 0] });
        assert_eq!((large.texel(0, 9), large.texel(1, 9)), (Some(0x0a_14_1e), None));
        assert!(large.has_holes() && !exact.has_holes());
        let small = decode(8, 8, &|x, _| [x as u8 * 10, 0, 0, 255]);
        assert_eq!((small.texel(2, 0), small.texel(3, 0)), (Some(0x0a_00_00), Some(0x0a_00_00)));
        assert_eq!(exact.tinted(0xff_80_00).texel(8, 8), Some(0x08_04_00));
        assert!(Picture::decode(b"no picture", &Limits::default()).is_err());
    }
}
