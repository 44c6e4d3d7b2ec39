//! Environment maps of panoramas: pictures of all directions by longitude and latitude, as files have them.

use super::environment::EnvironmentMap;
use super::equal_area::{direction_of, quarter_turns, square_of};
use crate::invalid::Invalid;
use crate::trigonometry::sincos_turns;
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;

/// Fewest and most texels along an edge of a map that a panorama becomes.
const EDGES: (u32, u32) = (16, 2048);
/// Largest radiance that is taken over: files have infinities where a sensor was overexposed.
const BRIGHTEST: f32 = 1e9;
/// What is so many times brighter than the mean is laid into the map pixel by pixel, so that a small sun keeps all of its light.
const SUN: f32 = 16.0;
/// Places, in rows and in columns, to which the light of such a pixel goes.
const PARTS: u32 = 8;

impl EnvironmentMap {
    /// The map of a panorama, whose middle is in bearing 0 (+y) and whose bearings grow to the right: the mean of what each texel covers.
    /// What is no light (negative, not a number) is black.
    ///
    /// # Errors
    /// Where it has no pixels or another number of them than its size says.
    pub fn from_panorama(width: u32, height: u32, pixels: &[Vec3]) -> Result<Self, Invalid> {
        if pixels.is_empty() || pixels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(format!("a panorama of {width} x {height} with {} pixels", pixels.len()).into());
        }
        // A panorama has half of its pixels near the poles, where they show little.
        let size = (pixels.len() as f64 * 0.5).sqrt();
        let edge = (size.ceil() as u32).clamp(EDGES.0, EDGES.1).next_power_of_two();
        let panorama = Panorama { width, height, pixels };
        // Some 25 places for each pixel at the horizon, in rows and columns.
        let looks = ((size * 5.0 / f64::from(edge)).ceil() as u32).clamp(5, 16);
        let limit = panorama.mean() * SUN;
        let texel = |index: u32| {
            let corner = Vec2::new((index % edge) as f32, (index / edge) as f32);
            let sum: Vec3 = (0..looks * looks)
                .map(|look| {
                    let within = Vec2::new((look % looks) as f32 + 0.5, (look / looks) as f32 + 0.5) / looks as f32;
                    panorama.seen(direction_of((corner + within) / edge as f32)).min(limit)
                })
                .sum();
            sum / (looks * looks) as f32
        };
        let mut radiance: Vec<Vec3> = (0..edge * edge).into_par_iter().map(texel).collect();
        panorama.add_beyond(limit, edge, &mut radiance);
        Self::new(edge, &radiance)
    }
}

/// A picture by longitude and latitude.
struct Panorama<'a> {
    width: u32,
    height: u32,
    pixels: &'a [Vec3],
}

impl Panorama<'_> {
    fn radiance(&self, column: u32, row: u32) -> Vec3 {
        let light = |value: f32| if value > 0.0 { value.min(BRIGHTEST) } else { 0.0 };
        let pixel = self.pixels[row as usize * self.width as usize + column as usize];
        Vec3::from_array(pixel.to_array().map(light))
    }

    /// What a direction sees.
    fn seen(&self, direction: Vec3) -> Vec3 {
        let size = direction.abs();
        // Bearing and height in quarters of a turn.
        let aside = quarter_turns(size.y, size.x);
        let bearing = if direction.y < 0.0 { 2.0 - aside } else { aside }.copysign(direction.x);
        let above = quarter_turns((size.x * size.x + size.y * size.y).sqrt(), size.z).copysign(direction.z);
        let pixel = |share: f32, count: u32| ((share * count as f32) as u32).min(count - 1);
        self.radiance(pixel(bearing * 0.25 + 0.5, self.width), pixel(0.5 - above * 0.5, self.height))
    }

    /// Sines of the heights of a row's upper and lower edge: their difference is in proportion to its solid angle.
    fn sines(&self, row: u32) -> (f32, f32) {
        let sine = |row: u32| sincos_turns(row as f32 / self.height as f32 * 0.5).1;
        (sine(row), sine(row + 1))
    }

    /// Mean over the sphere.
    fn mean(&self) -> Vec3 {
        let row = |row: u32| {
            let (upper, lower) = self.sines(row);
            let sum: DVec3 = (0..self.width).map(|column| self.radiance(column, row).as_dvec3()).sum();
            sum * f64::from(upper - lower) / (2.0 * f64::from(self.width))
        };
        (0..self.height).map(row).sum::<DVec3>().as_vec3()
    }

    /// Adds to a map what its texels left out: the light of each pixel beyond `limit`, over the solid angle of the pixel.
    fn add_beyond(&self, limit: Vec3, edge: u32, radiance: &mut [Vec3]) {
        for row in 0..self.height {
            let (upper, lower) = self.sines(row);
            for column in 0..self.width {
                let beyond = (self.radiance(column, row) - limit).max(Vec3::ZERO);
                if beyond == Vec3::ZERO {
                    continue;
                }
                // Share of the sphere that a part covers, in texels.
                let area = (upper - lower) / 2.0 / self.width as f32 * (edge * edge) as f32 / (PARTS * PARTS) as f32;
                for part in 0..PARTS * PARTS {
                    let within = |part: u32| (part as f32 + 0.5) / PARTS as f32;
                    let sine = upper + (lower - upper) * within(part / PARTS);
                    // The picture begins in the bearing opposite to its middle.
                    let (x, y) = sincos_turns((column as f32 + within(part % PARTS)) / self.width as f32);
                    let across = (1.0 - sine * sine).max(0.0).sqrt();
                    let place = square_of(Vec3::new(-x * across, -y * across, sine)) * edge as f32;
                    let (x, y) = ((place.x as u32).min(edge - 1), (place.y as u32).min(edge - 1));
                    let texel = &mut radiance[(y * edge + x) as usize];
                    *texel = (*texel + beyond * area).min(Vec3::splat(BRIGHTEST));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sky::environment::Environment;

    const WIDTH: u32 = 128;
    const HEIGHT: u32 = 64;

    fn panorama(of: impl Fn(f32, f32) -> Vec3) -> Environment {
        let pixel = |index: u32| of((index % WIDTH) as f32 + 0.5, (index / WIDTH) as f32 + 0.5);
        let pixels: Vec<Vec3> = (0..WIDTH * HEIGHT).map(pixel).collect();
        Environment::new(EnvironmentMap::from_panorama(WIDTH, HEIGHT, &pixels).unwrap().into(), 0.0)
    }

    #[test]
    fn directions_see_the_pixel_of_their_bearing_and_height() {
        // Red grows to the right, green downwards.
        let environment = panorama(|x, y| Vec3::new(x / WIDTH as f32, y / HEIGHT as f32, 0.0));
        for (bearing, height) in [(0.0_f32, 0.0_f32), (90.0, 0.0), (-45.0, 30.0), (150.0, -60.0)] {
            let (sin, cos) = bearing.to_radians().sin_cos();
            let (up, across) = height.to_radians().sin_cos();
            let seen = environment.radiance(Vec3::new(sin * across, cos * across, up));
            let expected = Vec3::new(bearing / 360.0 + 0.5, 0.5 - height / 180.0, 0.0);
            assert!(seen.abs_diff_eq(expected, 0.01), "{bearing}, {height}: {seen} and not {expected}");
            let turned = Environment::new(environment.map().clone(), 20.0);
            let later = (bearing + 20.0).to_radians().sin_cos();
            let seen = turned.radiance(Vec3::new(later.0 * across, later.1 * across, up));
            assert!(seen.abs_diff_eq(expected, 0.01), "turned {bearing}, {height}: {seen} and not {expected}");
            assert!(!seen.abs_diff_eq(expected + Vec3::X * 0.03, 0.01), "ten degrees are noticed");
        }
    }

    #[test]
    fn one_bright_pixel_keeps_its_light() {
        for (column, row) in [(64, 32), (3, 10), (100, 60), (127, 0)] {
            let is_there = |x: f32, y: f32| x as u32 == column && y as u32 == row;
            let environment = panorama(|x, y| if is_there(x, y) { Vec3::splat(1e5) } else { Vec3::ZERO });
            let turns = |row: u32| (std::f64::consts::PI * f64::from(row) / f64::from(HEIGHT)).cos();
            let share = (turns(row) - turns(row + 1)) / 2.0 / f64::from(WIDTH);
            let mean = f64::from(environment.map().mean_radiance().x);
            assert!((mean / (1e5 * share) - 1.0).abs() < 0.01, "{column}, {row}: {}", mean / (1e5 * share));
        }
    }

    #[test]
    fn pixels_that_are_no_light_are_black() {
        let pixels = [Vec3::NAN, Vec3::splat(-1.0), Vec3::INFINITY, Vec3::ONE];
        let map = EnvironmentMap::from_panorama(2, 2, &pixels).unwrap();
        assert!(map.mean_radiance().is_finite() && map.mean_radiance().min_element() > 0.25);
        assert!(EnvironmentMap::from_panorama(2, 1, &pixels).is_err());
        assert!(EnvironmentMap::from_panorama(0, 0, &[]).is_err());
    }
}
