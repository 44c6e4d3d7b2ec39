//! How noisy a film is, tile by tile, as far as it says itself: a film that keeps how its pixels stood earlier knows the difference
//! between two parts of its samples.

use voxtrace::film::Pixel;
use voxtrace::glam::Vec3;
use voxtrace::{Film, Frame};

/// Edge of a tile, pixels.
const TILE: usize = 32;

/// Some pixels that stop together.
pub struct Tile {
    /// Their indices in the film.
    pub pixels: Vec<usize>,
}

/// The tiles of a film, row by row; those at the right and at the bottom may be smaller.
pub fn tiles(film: &Film) -> Vec<Tile> {
    let (width, height) = (film.region.width() as usize, film.region.height() as usize);
    let corners = (0..height).step_by(TILE).flat_map(|y| (0..width).step_by(TILE).map(move |x| (x, y)));
    let tile = |(x0, y0): (usize, usize)| {
        let rows = y0..(y0 + TILE).min(height);
        Tile { pixels: rows.flat_map(|y| (x0..(x0 + TILE).min(width)).map(move |x| y * width + x)).collect() }
    };
    corners.map(tile).collect()
}

/// Luminance of linear Rec. 709.
fn luminance(pixel: &Pixel) -> f64 {
    f64::from(pixel.mean().dot(Vec3::new(0.2126, 0.7152, 0.0722)))
}

/// The same before white, which is dark where shadows are.
fn before_white(pixel: &Pixel) -> f64 {
    luminance(pixel) + 1.0 - f64::from(pixel.alpha())
}

/// What is looked at in the pixels of a frame's films.
fn brightness(frame: &Frame) -> fn(&Pixel) -> f64 {
    if frame.shadow_catcher { before_white } else { luminance }
}

impl Tile {
    /// The least number of samples of a pixel.
    pub fn least(&self, pixels: &[Pixel]) -> u32 {
        self.pixels.iter().map(|&index| pixels[index].samples).min().unwrap_or(0)
    }

    /// The largest number of samples of a pixel.
    pub fn most(&self, pixels: &[Pixel]) -> u32 {
        self.pixels.iter().map(|&index| pixels[index].samples).max().unwrap_or(0)
    }

    /// Estimate of the relative error: root of the mean variance of the pixels' luminance over their mean luminance; 0 for black tiles. Of films of
    /// shadows alone, that of their picture before white. `None` where a pixel has one part of its samples alone.
    pub fn error(&self, frame: &Frame, pixels: &[Pixel], earlier: &[Pixel]) -> Option<f64> {
        let brightness = brightness(frame);
        let (mut variance, mut mean) = (0.0, 0.0);
        for &index in &self.pixels {
            let (all, first) = (&pixels[index], &earlier[index]);
            if first.samples == 0 || first.samples >= all.samples {
                return None;
            }
            let step = brightness(first) - brightness(all);
            variance += step * step * f64::from(first.samples) / f64::from(all.samples - first.samples);
            mean += brightness(all);
        }
        let count = self.pixels.len().max(1) as f64;
        Some(if mean > 0.0 { (variance / count).sqrt() / (mean / count) } else { 0.0 })
    }
}

/// The errors of all tiles of a film whose error can be told.
pub fn errors(frame: &Frame, film: &Film) -> Vec<f64> {
    let Some(earlier) = &film.earlier else { return Vec::new() };
    tiles(film).iter().filter_map(|tile| tile.error(frame, &film.pixels, earlier)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::{Camera, Region};

    fn frame() -> Frame {
        Frame::new(Camera::look_at(Vec3::ONE, Vec3::ZERO), 70, 40)
    }

    /// A film of samples that are 1 ± `spread`, halved.
    fn film(spread: f32) -> Film {
        let mut film = Film::new(70, 40, Region::full(70, 40), 0);
        let mut state = 1_u32;
        let mut add = |film: &mut Film| {
            for pixel in &mut film.pixels {
                for _ in 0..8 {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let sign = if state >> 31 == 0 { -1.0 } else { 1.0 };
                    pixel.add(Vec3::splat(1.0 + sign * spread), true);
                }
            }
        };
        add(&mut film);
        film.earlier = Some(film.pixels.clone());
        add(&mut film);
        film
    }

    /// Checks that each tile's error is near that of the mean of sixteen samples.
    fn check(film: &Film, spread: f64) -> Result<(), String> {
        let errors = errors(&frame(), film);
        let expected = spread / 4.0;
        match errors.iter().find(|&&error| (error / expected - 1.0).abs() > 0.2) {
            Some(error) => Err(format!("{error} instead of {expected}")),
            None if errors.len() == 6 => Ok(()),
            None => Err(format!("{} tiles", errors.len())),
        }
    }

    #[test]
    fn the_estimated_error_is_that_of_the_mean_of_all_samples() {
        check(&film(0.4), 0.4).unwrap();
        check(&film(0.5), 0.4).unwrap_err();
    }

    #[test]
    fn shadows_are_as_noisy_as_their_picture_before_white() {
        // Half of the samples are covered, in turns of four pixels less and more.
        let mut film = film(0.0);
        for (index, pixel) in film.pixels.iter_mut().enumerate() {
            *pixel = Pixel { radiance: [0; 3], samples: 16, covered: [6, 10][index / 4 % 2] };
        }
        film.earlier =
            Some(film.pixels.iter().map(|pixel| Pixel { samples: 8, covered: pixel.covered - 3, ..*pixel }).collect());
        assert_eq!(errors(&frame(), &film), [0.0; 6], "all is black");
        let found = errors(&frame().transparent(true).shadow_catcher(true), &film);
        // From 3 and 7 of 8 to 6 and 10 of 16: steps of 0 and a fourth, the mean variance a 32nd.
        assert!(found.iter().all(|error| (error - (1.0f64 / 32.0).sqrt() / 0.5).abs() < 0.05), "{found:?}");
    }

    #[test]
    fn tiles_hold_every_pixel_once_and_one_part_alone_says_nothing() {
        let mut film = film(0.4);
        let mut all: Vec<usize> = tiles(&film).into_iter().flat_map(|tile| tile.pixels).collect();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..70 * 40));
        film.earlier = Some(film.pixels.clone());
        assert!(errors(&frame(), &film).is_empty());
    }
}
