//! Directions of an environment map as horizontal ground sees them: chosen in proportion to the light that it gets from them, by the texel.
//! Twin of `FromAbove` in `shaders/shadow_catcher.slang`.

use super::alias_table::alias_table;
use super::environment::{Environment, EnvironmentMap, EnvironmentTexel};
use super::equal_area::direction_of;
use bytemuck::Zeroable;
use glam::{DVec3, Vec2, Vec3};
use std::f64::consts::PI;

/// Places along an edge of a texel at which its cosine is looked at.
const PLACES: u32 = 4;

/// The light of a map on horizontal ground. Turning the map around the vertical changes nothing about it.
#[derive(Debug)]
pub struct FromAbove {
    /// The columns of the table, in the order of the map's texels, whose radiance and densities are not repeated.
    pub columns: Vec<EnvironmentTexel>,
    /// Luminance of the irradiance.
    pub irradiance: f64,
}

impl FromAbove {
    /// That of a map.
    pub(super) fn new(map: &EnvironmentMap) -> Self {
        let edge = map.edge();
        let weight = |(index, texel): (u32, &EnvironmentTexel)| {
            f64::from(texel.pdf) * cosine_of_texel(edge, index % edge, index / edge)
        };
        let weights: Vec<f64> = (0..).zip(map.texels()).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        if sum <= 0.0 {
            return Self { columns: vec![EnvironmentTexel::zeroed(); weights.len()], irradiance: 0.0 };
        }
        let column = |column: super::alias_table::Column| EnvironmentTexel {
            threshold: column.threshold,
            alias: column.alias,
            ..EnvironmentTexel::zeroed()
        };
        // Densities say which share of the light comes from a solid angle; all of it is 4 pi times the mean.
        let all = 4.0 * PI * map.mean_radiance().as_dvec3().dot(DVec3::new(0.2126, 0.7152, 0.0722));
        let mean_cosine = sum * 4.0 * PI / weights.len() as f64;
        Self { columns: alias_table(&weights).into_iter().map(column).collect(), irradiance: all * mean_cosine }
    }
}

/// Mean over a texel of the cosine with the vertical, 0 for what is below the horizon.
fn cosine_of_texel(edge: u32, x: u32, y: u32) -> f64 {
    let at = |texel: u32, step: u32| 2.0 * (f64::from(texel * PLACES + step) + 0.5) / f64::from(edge * PLACES) - 1.0;
    let cosine = |step: u32| {
        // As `direction_of` has it.
        let radius = at(x, step % PLACES).abs() + at(y, step / PLACES).abs();
        if radius < 1.0 { 1.0 - radius * radius } else { 0.0 }
    };
    (0..PLACES * PLACES).map(cosine).sum::<f64>() / f64::from(PLACES * PLACES)
}

impl Environment {
    /// Chooses a direction from above in proportion to what it sends to horizontal ground, by four numbers, each uniform in [0, 1), as
    /// [`Self::choose`] takes them. Texels that the horizon cuts are seen above it with all that they send.
    #[inline]
    pub fn choose_from_above(&self, u: [f32; 4]) -> Vec3 {
        let map = &**self.map();
        let columns = &map.from_above().columns;
        let edge = map.edge() as f32;
        let (row, column) = ((u[0] * edge).floor().min(edge - 1.0), (u[1] * edge).floor().min(edge - 1.0));
        let own = row as u32 * map.edge() + column as u32;
        let index = if u[2] < columns[own as usize].threshold { own } else { columns[own as usize].alias };
        let corner = Vec2::new((index % map.edge()) as f32, (index / map.edge()) as f32);
        let place = corner + Vec2::new((u[0] * edge - row).min(1.0), u[3]);
        let direction = self.to_world(direction_of(place * (1.0 / edge)));
        direction.with_z(direction.z.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    #[test]
    fn directions_from_above_are_as_likely_as_the_light_that_ground_gets_from_them() {
        // Bright in one quarter of the sky, and in all that is below the horizon, where the ground sees nothing.
        let edge = 64;
        let radiance_of = |direction: Vec3| match direction {
            Vec3 { z, .. } if z < 0.0 => 3.0,
            Vec3 { x, y, .. } if x > 0.0 && y > 0.0 => 5.0,
            _ => 1.0,
        };
        let middle = |texel: u32| (texel as f32 + 0.5) / edge as f32;
        let texels: Vec<Vec3> = (0..edge * edge)
            .map(|index| Vec3::splat(radiance_of(direction_of(Vec2::new(middle(index % edge), middle(index / edge))))))
            .collect();
        let map = Arc::new(EnvironmentMap::new(edge, &texels).unwrap());
        // A hemisphere of radiance 1 sends pi.
        assert!((map.from_above().irradiance / (2.0 * PI) - 1.0).abs() < 0.02, "{}", map.from_above().irradiance);
        // Each column once, and its alias as often as it should be.
        let at = |step: u32| (step as f32 + 0.5) / edge as f32;
        let mean = |rotation: f32, of: &dyn Fn(Vec3) -> f64| {
            let environment = Environment::new(Arc::clone(&map), rotation);
            let u = |index: u32| [at(index % edge), at(index / edge % edge), at(index / edge / edge), 0.5];
            (0..edge.pow(3)).map(|index| of(environment.choose_from_above(u(index)))).sum::<f64>()
                / f64::from(edge.pow(3))
        };
        // Each quarter of a hemisphere has the same cosines, whose mean is 2/3. Between texels light is interpolated, across the quarter's sides.
        let in_quarter = |direction: Vec3| f64::from(u8::from(direction.x > 0.0 && direction.y > 0.0));
        let is_near = |found: f64, expected: f64| (found - expected).abs() < 0.015;
        assert!(is_near(mean(0.0, &in_quarter), 5.0 / 8.0), "{}", mean(0.0, &in_quarter));
        assert!(is_near(mean(180.0, &in_quarter), 1.0 / 8.0), "{}", mean(180.0, &in_quarter));
        let height = mean(0.0, &|direction| direction.z.into());
        assert!(
            is_near(height, 2.0 / 3.0) && !is_near(height, 1.0 / 2.0),
            "by solid angle alone it would be a half: {height}"
        );
        let black = EnvironmentMap::new(2, &[Vec3::ZERO; 4]).unwrap();
        assert_eq!(black.from_above().irradiance, 0.0);
    }
}
