//! A thin lens: every point of the aperture sees the plane in focus at the same place of the picture.

use super::{Perspective, Projection};
use crate::ray::Ray;
use crate::trigonometry::sincos_turns;
use glam::{Vec2, Vec3};

/// A thin lens made ready for one picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinLens {
    /// From the middle of the lens to the plane in focus: that place of the picture lies there at `eye + corner + …`.
    pub perspective: Perspective,
    /// The radius of the aperture towards the right of the picture, turned with the blades, world space.
    pub lens_x: Vec3,
    /// The radius at right angles to it.
    pub lens_y: Vec3,
    /// Blades of the diaphragm, 0 for a round one.
    pub blades: u32,
}

impl Projection for ThinLens {
    #[inline]
    fn ray(&self, position: Vec2, lens: Vec2) -> Ray {
        let Perspective { eye, corner, pixel_x, pixel_y } = self.perspective;
        let place = place_in_aperture(self.blades, lens);
        let offset = self.lens_x * place.x + self.lens_y * place.y;
        let direction = corner + pixel_x * position.x + pixel_y * position.y - offset;
        Ray::new(eye + offset, direction * (1.0 / direction.length_squared().sqrt()))
    }
}

/// The place in an aperture of radius 1 of `lens` in [0, 1)², uniform over its area; (0.5, 0.5) is its middle.
#[inline]
pub fn place_in_aperture(blades: u32, lens: Vec2) -> Vec2 {
    let (radius, turns) = concentric(lens);
    if blades == 0 {
        let (sin, cos) = sincos_turns(turns);
        return Vec2::new(radius * cos, radius * sin);
    }
    // One of the equal triangles around the middle: its corners lie on the circle.
    let count = blades as f32;
    let scaled = turns * count;
    let blade = (scaled as u32).min(blades - 1) as f32;
    let share = scaled - blade;
    let (from_sin, from_cos) = sincos_turns(blade / count);
    let (to_sin, to_cos) = sincos_turns((blade + 1.0) / count);
    let along = Vec2::new(from_cos + (to_cos - from_cos) * share, from_sin + (to_sin - from_sin) * share);
    along * radius
}

/// Radius and angle, turns in [0, 1), of a point of the unit disc that is uniform where `square` is uniform in [0, 1)² (Shirley and Chiu, "A Low
/// Distortion Map Between Disk and Square", 1997).
#[inline]
fn concentric(square: Vec2) -> (f32, f32) {
    let (a, b) = (2.0 * square.x - 1.0, 2.0 * square.y - 1.0);
    if a == 0.0 && b == 0.0 {
        return (0.0, 0.0);
    }
    let (radius, turns) = if a.abs() > b.abs() { (a, b / a * 0.125) } else { (b, 0.25 - a / b * 0.125) };
    // A negative radius points the other way.
    let turns = if radius < 0.0 { turns + 0.5 } else { turns };
    (radius.abs(), if turns < 0.0 { turns + 1.0 } else { turns })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean square of the distance from the middle, and the largest distance, over a fine grid of samples.
    fn moments(blades: u32, map: impl Fn(Vec2) -> Vec2) -> (f32, f32) {
        let steps = 400;
        let (mut square, mut largest) = (0.0, 0.0_f32);
        for i in 0..steps * steps {
            let at = |index: i32| (index as f32 + 0.5) / steps as f32;
            let place = place_in_aperture(blades, map(Vec2::new(at(i / steps), at(i % steps))));
            square += place.length_squared() / (steps * steps) as f32;
            largest = largest.max(place.length());
        }
        (square, largest)
    }

    #[test]
    fn apertures_are_filled_evenly() {
        let (square, largest) = moments(0, |lens| lens);
        // The mean of r² over a disc is 1/2; over a regular polygon of n corners it is (2 + cos(2π/n)) / 6.
        assert!((square - 0.5).abs() < 1e-3 && (largest - 1.0).abs() < 1e-2, "{square} {largest}");
        for blades in [3, 5, 6, 8] {
            let expected = (2.0 + (std::f32::consts::TAU / blades as f32).cos()) / 6.0;
            let (square, largest) = moments(blades, |lens| lens);
            assert!((square - expected).abs() < 2e-3 && largest <= 1.0 + 1e-6, "{blades}: {square}, not {expected}");
        }
        let crowded = moments(0, |lens| Vec2::new(lens.x * lens.x, lens.y)).0;
        assert!((crowded - 0.5).abs() > 1e-2, "samples that crowd are noticed: {crowded}");
    }

    #[test]
    fn the_middle_of_the_square_is_the_middle_of_the_lens() {
        for blades in [0, 3, 7] {
            assert_eq!(place_in_aperture(blades, Vec2::splat(0.5)), Vec2::ZERO);
        }
    }
}
