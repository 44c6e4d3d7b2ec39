//! How often rays to lights arrive: a table of counts for pairs of a cube that a ray begins in and one that it ends in. Candidates for a pixel's light are
//! weighed by it, so that rays go rather where light comes from. Weights are never zero, so that nothing is biased: what the table knows wrong is noise alone.
//!
//! Places have no keys: pairs that come to the same place share what they know. A frame reads what was known before it, so that the order of its paths
//! does not matter.

use glam::{IVec3, Vec3};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use voxtrace_core::sampler::pcg4d;
use voxtrace_scene::ray::Ray;

/// Share of the picture's height that a cube in which rays begin is wide where it is seen, between this and half of it.
const WIDTH: f32 = 0.3;
/// Cubes of distant lights, along an axis of unit directions, from 0 on.
const DIRECTIONS: f32 = 4.0;
/// Stands for the size of these.
const DISTANT: i32 = 128;
/// The width of cubes is within two to the power of this, and its inverse.
const LARGEST: i32 = 64;
/// So far are they told apart.
const MOST_CUBES: f32 = 1e9;
/// Rays that a place remembers at most.
const MOST_RAYS: u32 = 255;
/// Pixels of a frame whose rays are counted, at most: a word counts as many.
const MOST_LEARNING: u32 = 1 << 15;

/// The table. A word counts rays in its lower half, and those that arrived in its upper one.
pub struct Visibility {
    known: Vec<u32>,
    /// What paths of this frame found.
    found: Vec<AtomicU32>,
}

impl Default for Visibility {
    /// One that knows nothing.
    fn default() -> Self {
        Self { known: vec![0; Self::PLACES], found: (0..Self::PLACES).map(|_| AtomicU32::new(0)).collect() }
    }
}

impl Visibility {
    /// Number of places: 1 MB on devices, with what a frame finds.
    pub const PLACES: usize = 1 << 17;

    /// Whether a pixel's ray is counted in a frame; one of as many as there must be.
    pub fn learns(pixel: u32, pixels: u32, number: u32) -> bool {
        let stride = pixels.div_ceil(MOST_LEARNING);
        pixel.wrapping_add(7 * (pixel / stride)).wrapping_add(number).is_multiple_of(stride)
    }

    /// The place of a ray to a light, seen by a camera at `eye` whose picture's height sees `view_angle`.
    pub fn place(ray: &Ray, eye: Vec3, view_angle: f32) -> usize {
        let size = view_angle * WIDTH;
        let (begin, size) = cube(ray.origin, (ray.origin - eye).length_squared() * (size * size), 0);
        let [x, y, z, w] = pcg4d([begin.x as u32, begin.y as u32, begin.z as u32, size as u32]);
        let (end, size) = match ray.t_max > 1.0 {
            true => ((ray.direction * DIRECTIONS).floor().as_ivec3(), DISTANT),
            false => cube(ray.origin + ray.direction, ray.direction.length_squared(), 1),
        };
        let [place, ..] = pcg4d([end.x as u32 ^ x, end.y as u32 ^ y, end.z as u32 ^ z, size as u32 ^ w]);
        place as usize & (Self::PLACES - 1)
    }

    /// The square root of the chance that a ray of a place arrives, as the second moment of what it brings asks for; the chance is that of Krichevsky and
    /// Trofimov ("The Performance of Universal Encoding", IEEE Transactions on Information Theory 27, 1981).
    pub fn weight(&self, place: usize) -> f32 {
        let known = self.known[place];
        let (rays, arrived) = (known & 0xffff, known >> 16);
        ((arrived as f32 + 0.5) / (rays as f32 + 1.0)).sqrt()
    }

    /// Counts a ray.
    pub fn count(&self, place: usize, has_arrived: bool) {
        self.found[place].fetch_add(1 + (u32::from(has_arrived) << 16), Relaxed);
    }

    /// Ends a frame: what it found is known from the next one on.
    pub fn update(&mut self) {
        for (known, found) in self.known.iter_mut().zip(&mut self.found) {
            let found = std::mem::take(found.get_mut());
            let (mut rays, mut arrived) = ((*known & 0xffff) + (found & 0xffff), (*known >> 16) + (found >> 16));
            while rays > MOST_RAYS {
                (rays, arrived) = (rays >> 1, arrived >> 1);
            }
            *known = arrived << 16 | rays;
        }
    }
}

/// The cube of a point, in cubes, and the power of two that is its width: the largest one, of its square at most `size_squared`, over two to the power of `smaller`.
fn cube(point: Vec3, size_squared: f32, smaller: i32) -> (IVec3, i32) {
    let power = ((exponent(size_squared) >> 1) - smaller).clamp(-LARGEST, LARGEST);
    let per_unit = f32::from_bits(((127 - power) as u32) << 23);
    ((point * per_unit).floor().clamp(Vec3::splat(-MOST_CUBES), Vec3::splat(MOST_CUBES)).as_ivec3(), power)
}

/// The largest power of two that is not above a positive number.
fn exponent(number: f32) -> i32 {
    (number.to_bits() >> 23) as i32 - 127
}

#[cfg(test)]
mod tests {
    use super::*;

    fn to(target: Vec3) -> Ray {
        Ray { t_max: 1.0, ..Ray::new(Vec3::new(0.5, 0.5, 0.5), target - Vec3::splat(0.5)) }
    }

    #[test]
    fn what_rays_found_is_known_from_the_next_frame_on_and_only_of_their_pair_of_cubes() {
        let place = |ray: &Ray| Visibility::place(ray, Vec3::new(0.0, -10.0, 0.0), 1.0);
        let mut visibility = Visibility::default();
        let (open, blocked) = (to(Vec3::new(40.0, 3.0, 1.0)), to(Vec3::new(1.0, 3.0, 40.0)));
        assert_eq!(visibility.weight(place(&open)), 0.5_f32.sqrt());
        for _ in 0..6 {
            visibility.count(place(&open), true);
            visibility.count(place(&blocked), false);
        }
        assert_eq!(visibility.weight(place(&open)), 0.5_f32.sqrt(), "not before the next frame");
        visibility.update();
        // A neighbour in the same cubes knows it, too.
        assert_eq!(visibility.weight(place(&to(Vec3::new(41.0, 3.5, 1.5)))), (6.5_f32 / 7.0).sqrt());
        assert_eq!(visibility.weight(place(&blocked)), (0.5_f32 / 7.0).sqrt());
        assert_eq!(visibility.weight(place(&to(Vec3::new(-40.0, 3.0, 1.0)))), 0.5_f32.sqrt());
        let sun = Ray::new(Vec3::splat(0.5), Vec3::new(0.6, 0.0, 0.8));
        assert_eq!(visibility.weight(place(&sun)), 0.5_f32.sqrt());
    }

    #[test]
    fn what_is_known_long_gives_way_to_what_changed() {
        let mut visibility = Visibility::default();
        for frame in 0..40 {
            for _ in 0..1000 {
                visibility.count(5, frame < 20);
            }
            visibility.update();
            assert!(visibility.known[5] & 0xffff <= MOST_RAYS);
        }
        assert!(visibility.weight(5) < 0.1, "{}", visibility.weight(5));
    }

    #[test]
    fn as_many_pixels_learn_in_a_frame_as_a_word_counts_and_all_of_them_in_turn() {
        for pixels in [1, 240 * 136, 1280 * 720, 3840 * 2160] {
            let stride = u32::div_ceil(pixels, MOST_LEARNING);
            let learning = |number| (0..pixels).filter(move |&pixel| Visibility::learns(pixel, pixels, number)).count();
            assert!((1..=MOST_LEARNING as usize + 1).contains(&learning(3)), "{}", learning(3));
            let turns = |pixel| (0..stride).filter(|&number| Visibility::learns(pixel, pixels, number)).count();
            assert!((0..pixels.min(5000)).all(|pixel| turns(pixel) == 1), "{pixels}");
        }
    }
}
