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
pub struct Tiles {
    /// Tiles of a row.
    columns: usize,
    /// All of them.
    pub list: Vec<Tile>,
}

impl Tiles {
    /// Those of films of this size.
    pub fn of(film: &Film) -> Self {
        let (width, height) = (film.region.width() as usize, film.region.height() as usize);
        let corners = (0..height).step_by(TILE).flat_map(|y| (0..width).step_by(TILE).map(move |x| (x, y)));
        let tile = |(x0, y0): (usize, usize)| {
            let rows = y0..(y0 + TILE).min(height);
            Tile { pixels: rows.flat_map(|y| (x0..(x0 + TILE).min(width)).map(move |x| y * width + x)).collect() }
        };
        Self { columns: width.div_ceil(TILE), list: corners.map(tile).collect() }
    }

    /// The tiles that touch one, and itself.
    fn around(&self, index: usize) -> impl Iterator<Item = usize> {
        let (column, row, columns) = (index % self.columns, index / self.columns, self.columns);
        let rows = row.saturating_sub(1)..(row + 2).min(self.list.len() / columns);
        rows.flat_map(move |y| (column.saturating_sub(1)..(column + 2).min(columns)).map(move |x| y * columns + x))
    }

    /// Estimate of each tile's relative error: the root of the mean variance of its pixels' luminance over their mean luminance, or that of the
    /// tiles around it where that is more: bright paths that are rare, as within clouds, are missed by one tile and met by the next. The
    /// variance of a tile around counts as it would be with the tile's own number of samples, over the brighter of the two means. 0 for black
    /// tiles. Of films of shadows alone, that of their picture before white. `None` where a pixel has one part of its samples alone.
    pub fn errors(&self, frame: &Frame, pixels: &[Pixel], earlier: &[Pixel]) -> Vec<Option<f64>> {
        let brightness = brightness(frame);
        let estimates: Vec<_> = self.list.iter().map(|tile| tile.estimate(brightness, pixels, earlier)).collect();
        let error = |(index, own): (usize, &Option<Estimate>)| {
            let own = own.as_ref()?;
            let around: Vec<&Estimate> = self.around(index).filter_map(|other| estimates[other].as_ref()).collect();
            let count: f64 = around.iter().map(|other| other.pixels).sum();
            let square: f64 = around.iter().map(|other| other.pixels * other.square_error(own)).sum();
            Some((square / count).max(own.square_error(own)).sqrt())
        };
        estimates.iter().enumerate().map(error).collect()
    }
}

/// What the two parts of a tile's samples say.
struct Estimate {
    /// Number of its pixels.
    pixels: f64,
    /// Samples of a pixel.
    samples: f64,
    /// Mean luminance.
    mean: f64,
    /// Mean variance of the mean luminance of a pixel.
    variance: f64,
}

impl Estimate {
    /// Square of the relative error that this variance would be in a tile of other brightness and number of samples.
    fn square_error(&self, of: &Self) -> f64 {
        let mean = self.mean.max(of.mean);
        if mean > 0.0 { self.variance * self.samples / of.samples / (mean * mean) } else { 0.0 }
    }
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

    /// `None` where a pixel has one part of its samples alone.
    fn estimate(&self, brightness: fn(&Pixel) -> f64, pixels: &[Pixel], earlier: &[Pixel]) -> Option<Estimate> {
        let (mut variance, mut mean, mut samples) = (0.0, 0.0, 0.0);
        for &index in &self.pixels {
            let (all, first) = (&pixels[index], &earlier[index]);
            if first.samples == 0 || first.samples >= all.samples {
                return None;
            }
            let step = brightness(first) - brightness(all);
            variance += step * step * f64::from(first.samples) / f64::from(all.samples - first.samples);
            mean += brightness(all);
            samples += f64::from(all.samples);
        }
        let pixels = self.pixels.len() as f64;
        Some(Estimate { pixels, samples: samples / pixels, mean: mean / pixels, variance: variance / pixels })
    }
}

/// The errors of all tiles of a film whose error can be told.
pub fn errors(frame: &Frame, film: &Film) -> Vec<f64> {
    let Some(earlier) = &film.earlier else { return Vec::new() };
    Tiles::of(film).errors(frame, &film.pixels, earlier).into_iter().flatten().collect()
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

    /// A film of four by three tiles without noise, and one bright path in the later half of a pixel of the first tile, in a picture of
    /// brightness 1 left of `edge` and `right` from there on.
    fn rare_path(edge: usize, right: f32) -> Film {
        let mut film = Film::new(128, 96, Region::full(128, 96), 0);
        let add = |film: &mut Film, bright: Option<usize>| {
            for (index, pixel) in film.pixels.iter_mut().enumerate() {
                let light = if index % 128 < edge { 1.0 } else { right };
                (0..8).for_each(|_| pixel.add(Vec3::splat(light), true));
                if bright == Some(index) {
                    pixel.radiance.iter_mut().for_each(|sum| *sum += 512 << 32);
                }
            }
        };
        add(&mut film, None);
        film.earlier = Some(film.pixels.clone());
        add(&mut film, Some(5 * 128 + 5));
        film
    }

    #[test]
    fn a_tile_is_as_noisy_as_those_around_it() {
        // The pixel's mean is 33 after 1: a variance of 32² over the tile's 1,024 pixels.
        let mean = 1.0 + 32.0 / 1024.0;
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-3, "{found}, {expected}");
        let found = errors(&frame(), &rare_path(128, 1.0));
        near(found[0], 1.0 / mean);
        // A tile at the edge has five around it and itself, one within eight.
        near(found[1], (1.0f64 / 6.0).sqrt() / mean);
        near(found[5], (1.0f64 / 9.0).sqrt() / mean);
        assert_eq!([2, 3, 6, 7, 8, 9, 10, 11].map(|far: usize| found[far]), [0.0; 8]);
        // What is noise in the dark is little beside a bright tile, and a dark tile has nothing to see of a bright one's noise.
        near(errors(&frame(), &rare_path(32, 100.0))[1], (1.0f64 / 6.0).sqrt() / 100.0);
        near(errors(&frame(), &rare_path(32, 0.01))[1], (1.0f64 / 6.0).sqrt() / mean);
        // Four times the samples, a fourth of the variance.
        let mut film = rare_path(128, 1.0);
        for pixels in [&mut film.pixels, film.earlier.as_mut().unwrap()] {
            pixels.iter_mut().enumerate().filter(|(index, _)| index % 128 >= 32).for_each(|(_, pixel)| {
                let more = |sum: u64| 4 * sum;
                *pixel = Pixel { radiance: pixel.radiance.map(more), samples: 4 * pixel.samples, ..*pixel };
            });
        }
        near(errors(&frame(), &film)[1], (1.0f64 / 6.0 / 4.0).sqrt() / mean);
    }

    #[test]
    fn tiles_hold_every_pixel_once_and_one_part_alone_says_nothing() {
        let mut film = film(0.4);
        let mut all: Vec<usize> = Tiles::of(&film).list.into_iter().flat_map(|tile| tile.pixels).collect();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..70 * 40));
        film.earlier = Some(film.pixels.clone());
        assert!(errors(&frame(), &film).is_empty());
    }
}
