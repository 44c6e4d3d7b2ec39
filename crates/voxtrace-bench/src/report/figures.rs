//! The pictures of a report: what a cell rendered, the voxels that it finds with the wrong ones black (the study's
//! Figure 7), and where those are. Small enough to lie inside a page.

use crate::measure::{Reference, is_same_voxel};
use std::io;
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::material::encode_srgb;
use voxtrace::output::ToneMap;
use voxtrace::{Film, Hit, PackedScene};

/// Widest pictures and maps, pixels: nine of them and three renders make a page of less than a megabyte.
const WIDEST: usize = 495;
const WIDEST_MAP: usize = 330;
/// Quality of JPEGs.
const QUALITY: u8 = 75;
/// Brightness of the faces of a voxel, in the order of their numbers.
const SHADES: [f32; 6] = [0.62, 0.7, 0.5, 0.82, 0.4, 1.0];
/// Linear colours of the sky, and in maps of differences of right pixels, few wrong ones, and many.
const SKY: Vec3 = Vec3::new(0.45, 0.62, 0.85);
const RIGHT: Vec3 = Vec3::new(0.012, 0.014, 0.02);
const RIGHT_SKY: Vec3 = Vec3::new(0.03, 0.035, 0.05);
const WRONG: Vec3 = Vec3::new(1.0, 0.55, 0.05);

/// An 8-bit picture.
pub struct Picture {
    width: usize,
    height: usize,
    /// Red, green, blue, row by row.
    samples: Vec<u8>,
}

impl Picture {
    /// A picture a `factor`-th as large as `width` × `height` whose pixels `color` gives from blocks' upper left corners.
    fn reduced(width: usize, height: usize, factor: usize, color: impl Fn(usize, usize) -> DVec3) -> Self {
        let (w, h) = ((width / factor).max(1), (height / factor).max(1));
        let colors = (0..w * h).map(|index| color(index % w * factor, index / w * factor));
        let samples = colors.flat_map(|color| color.to_array().map(|value| (value * 255.0).round() as u8)).collect();
        Self { width: w, height: h, samples }
    }

    /// As a JPEG: for pictures with many colours, of which a page has many.
    pub fn write_jpeg(&self, out: &mut impl io::Write) -> io::Result<()> {
        let mut encoder = jpeg_encoder::Encoder::new(out, QUALITY);
        // Black voxels are single pixels: their colour must not run.
        encoder.set_sampling_factor(jpeg_encoder::SamplingFactor::R_4_4_4);
        let (width, height) = (self.width as u16, self.height as u16);
        encoder.encode(&self.samples, width, height, jpeg_encoder::ColorType::Rgb).map_err(|error| match error {
            jpeg_encoder::EncodingError::IoError(error) => error,
            other => io::Error::other(other),
        })
    }

    /// As a PNG.
    pub fn write_png(&self, out: &mut impl io::Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(out, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let into_io = |error: png::EncodingError| match error {
            png::EncodingError::IoError(error) => error,
            other => io::Error::other(other),
        };
        let mut encoder = encoder.write_header().map_err(into_io)?;
        encoder.write_image_data(&self.samples).map_err(into_io)?;
        encoder.finish().map_err(into_io)
    }
}

/// The smallest whole number by which a width must be divided.
fn factor_of(width: usize, widest: usize) -> usize {
    width.div_ceil(widest).max(1)
}

/// What a film shows.
pub fn render(film: &Film) -> Picture {
    let (width, height) = (film.region.width() as usize, film.region.height() as usize);
    let samples = film.sample_range().0 as usize;
    // Few samples make a noisy picture: rather a smaller one.
    let factor = factor_of(width, WIDEST);
    let factor = if samples * factor * factor < 200 { 2 * factor } else { factor };
    let tone_map = ToneMap::default();
    Picture::reduced(width, height, factor, |x, y| {
        let mut sum = Vec3::ZERO;
        let mut count = 0.0;
        for (dx, dy) in block(factor, x, y, width, height) {
            sum += film.pixels[dy * width + dx].mean();
            count += 1.0;
        }
        tone_map.signal(sum / count)
    })
}

/// The voxels that `hits` found, in their own colours, and the wrong ones black.
pub fn voxels(scene: &PackedScene, reference: &Reference, hits: &[Hit]) -> Picture {
    let factor = factor_of(reference.width, WIDEST);
    let middle = factor / 2;
    Picture::reduced(reference.width, reference.height, factor, |x, y| {
        let at = (y + middle).min(reference.height - 1) * reference.width + (x + middle).min(reference.width - 1);
        let hit = &hits[at];
        let linear = if !is_same_voxel(hit, &reference.hits[at]) {
            Vec3::ZERO
        } else if hit.is_miss() {
            SKY
        } else {
            let material = &scene.materials()[scene.material_index(hit) as usize];
            let color = material.base_color.max(material.emission.min(Vec3::ONE));
            (color * SHADES[hit.face.min(5) as usize]).max(Vec3::splat(0.02))
        };
        signal(linear)
    })
}

/// Where hits are wrong: a pixel is the brighter the more of its rays are.
pub fn difference(reference: &Reference, hits: &[Hit]) -> Picture {
    let factor = factor_of(reference.width, WIDEST_MAP);
    Picture::reduced(reference.width, reference.height, factor, |x, y| {
        let (mut wrong, mut all) = (0.0, 0.0);
        for (dx, dy) in block(factor, x, y, reference.width, reference.height) {
            let at = dy * reference.width + dx;
            wrong += f32::from(u8::from(!is_same_voxel(&hits[at], &reference.hits[at])));
            all += 1.0;
        }
        let ground = if reference.hits[y * reference.width + x].is_miss() { RIGHT_SKY } else { RIGHT };
        signal(if wrong > 0.0 { ground.lerp(WRONG, (wrong / all).sqrt().max(0.35)) } else { ground })
    })
}

fn signal(linear: Vec3) -> DVec3 {
    DVec3::from_array(linear.as_dvec3().to_array().map(encode_srgb))
}

/// The pixels of a block that lie in the picture.
fn block(factor: usize, x: usize, y: usize, width: usize, height: usize) -> impl Iterator<Item = (usize, usize)> {
    (y..(y + factor).min(height)).flat_map(move |dy| (x..(x + factor).min(width)).map(move |dx| (dx, dy)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::IVec3;
    use voxtrace::{Material, Ray, Region, Scene, VoxelGrid};

    /// A wall of one material and what rays through the middles of 4 × 2 pixels meet.
    fn wall() -> (PackedScene, Reference) {
        let mut grid = VoxelGrid::new();
        for index in 0..16 {
            grid.set(IVec3::new(index % 4, 0, index / 4), 0);
        }
        let scene = Scene::from_grid("wall", grid, vec![Material::diffuse(Vec3::ONE)]);
        let scene = PackedScene::pack(&scene).unwrap();
        let rays: Vec<Ray> =
            (0..8).map(|i| Ray::new(Vec3::new((i % 4) as f32 + 0.5, -5.0, (i / 4) as f32 + 0.5), Vec3::Y)).collect();
        let hits = rays.iter().map(|ray| scene.cast(ray).unwrap_or(Hit::MISS)).collect();
        (scene, Reference { rays, hits, width: 4, height: 2 })
    }

    #[test]
    fn wrong_voxels_are_black_and_marked_and_right_ones_are_not() {
        let (scene, reference) = wall();
        assert!(reference.hits.iter().all(|hit| !hit.is_miss()));
        let right = voxels(&scene, &reference, &reference.hits);
        assert!(right.samples.iter().all(|&sample| sample > 100));
        let mut hits = reference.hits.clone();
        hits[5].voxel.x += 1;
        let picture = voxels(&scene, &reference, &hits);
        assert_eq!(picture.samples[15..18], [0, 0, 0]);
        assert_eq!(picture.samples[18..], right.samples[18..]);
        let marked = difference(&reference, &hits);
        assert!(marked.samples[15] > 200 && marked.samples[12] < 60, "{:?}", marked.samples);
    }

    #[test]
    fn pictures_are_reduced_to_the_mean_of_their_blocks() {
        let (width, height) = (1320, 6);
        let mut film = Film::new(width, height, Region::full(width, height), 0);
        assert_eq!(render(&film).width, 220);
        for (index, pixel) in film.pixels.iter_mut().enumerate() {
            (0..50).for_each(|_| pixel.add(if index % 2 == 0 { Vec3::ONE } else { Vec3::ZERO }, true));
        }
        let picture = render(&film);
        assert_eq!((picture.width, picture.height), (440, 2));
        // Three by three pixels: three or six of them white.
        let [dark, light] =
            [3.0, 6.0].map(|n: f32| (ToneMap::default().signal(Vec3::splat(n / 9.0)).x * 255.0).round() as u8);
        assert!(picture.samples.iter().all(|&sample| sample == dark || sample == light));
        let (mut png, mut jpeg) = (Vec::new(), Vec::new());
        picture.write_png(&mut png).unwrap();
        picture.write_jpeg(&mut jpeg).unwrap();
        assert_eq!((&png[1..4], &jpeg[..3]), (&b"PNG"[..], &[0xff, 0xd8, 0xff][..]));
    }
}
