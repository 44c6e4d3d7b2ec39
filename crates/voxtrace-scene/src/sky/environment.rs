//! A sky as a picture of all directions: texels of equal solid angle, between which radiance is interpolated, and a table by which one
//! is chosen in proportion to the light that it sends. Twin of `shaders/environment.slang`.

use super::alias_table::alias_table;
use super::equal_area::{direction_of, square_of};
use super::from_above::FromAbove;
use crate::invalid::Invalid;
use crate::trigonometry::sincos_turns;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec2, Vec3};
use std::f64::consts::PI;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Most texels along an edge of a map.
pub const MAX_EDGE: u32 = 4096;
/// Largest radiance of a texel: sums over all texels and samples stay finite.
const MAX_RADIANCE: f32 = 1e9;

/// Radiance from all directions, in the equal-area octahedral square: texel (x, y) is in row y of `edge` texels.
pub struct EnvironmentMap {
    edge: u32,
    texels: Vec<EnvironmentTexel>,
    mean: Vec3,
    fingerprint: u64,
    from_above: OnceLock<FromAbove>,
}

/// One texel of an environment map.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct EnvironmentTexel {
    /// Radiance in its middle, linear.
    pub radiance: Vec3,
    /// Density over solid angle with which a direction within it is chosen.
    pub pdf: f32,
    /// Share of its column in the table of texels that is its own.
    pub threshold: f32,
    /// The texel to which the rest of the column belongs.
    pub alias: u32,
}

/// A place on the map, and a direction in which it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenDirection {
    /// Unit vector.
    pub direction: Vec3,
    /// Radiance from there.
    pub radiance: Vec3,
    /// Density of the choice over solid angle, > 0.
    pub pdf: f32,
}

impl EnvironmentMap {
    /// A map of `edge` × `edge` texels.
    ///
    /// # Errors
    /// Where there are more or fewer texels than that, or one that is negative, not finite, or beyond 1e9.
    pub fn new(edge: u32, radiance: &[Vec3]) -> Result<Self, Invalid> {
        if !(1..=MAX_EDGE).contains(&edge) || radiance.len() as u64 != u64::from(edge) * u64::from(edge) {
            return Err(format!("an environment of {} texels, {edge} along an edge", radiance.len()).into());
        }
        let is_light =
            |texel: &&Vec3| texel.is_finite() && texel.min_element() >= 0.0 && texel.max_element() <= MAX_RADIANCE;
        if let Some(texel) = radiance.iter().find(|texel| !is_light(texel)) {
            return Err(format!("an environment with a texel of radiance {texel}").into());
        }
        let weights = weights(edge, radiance);
        let sum: f64 = weights.iter().sum();
        let pdf_scale = f64::from(edge) * f64::from(edge) / (4.0 * PI * sum);
        let texels = match sum > 0.0 {
            true => (radiance.iter().zip(alias_table(&weights)).zip(&weights))
                .map(|((&radiance, column), weight)| {
                    let (threshold, alias) = (column.threshold, column.alias);
                    EnvironmentTexel { radiance, pdf: (weight * pdf_scale) as f32, threshold, alias }
                })
                .collect(),
            false => vec![EnvironmentTexel::zeroed(); radiance.len()],
        };
        let mean = radiance.iter().map(|texel| texel.as_dvec3()).sum::<DVec3>() / radiance.len() as f64;
        let (mean, fingerprint) = (mean.as_vec3(), fingerprint(radiance));
        Ok(Self { edge, texels, mean, fingerprint, from_above: OnceLock::new() })
    }

    /// The same map with its radiance times a factor.
    ///
    /// # Errors
    /// Where that is no radiance, as for [`Self::new`].
    pub fn scaled(self, factor: f32) -> Result<Self, Invalid> {
        if factor == 1.0 {
            return Ok(self);
        }
        let radiance: Vec<Vec3> = self.texels.iter().map(|texel| texel.radiance * factor).collect();
        Self::new(self.edge, &radiance)
    }

    /// Texels along an edge.
    pub fn edge(&self) -> u32 {
        self.edge
    }

    /// All texels, row by row.
    pub fn texels(&self) -> &[EnvironmentTexel] {
        &self.texels
    }

    /// Mean of the radiance over all directions.
    pub fn mean_radiance(&self) -> Vec3 {
        self.mean
    }

    /// Its light on horizontal ground, made when it is first asked for.
    #[doc(hidden)]
    pub fn from_above(&self) -> &FromAbove {
        self.from_above.get_or_init(|| FromAbove::new(self))
    }

    /// The texel at a place near the map: beyond an edge the map goes on at the same edge, turned over.
    #[inline]
    fn texel(&self, x: i32, y: i32) -> &EnvironmentTexel {
        &self.texels[index_of(self.edge as i32, x, y)]
    }

    /// Radiance at a place, in texels, between the middles of the four texels around it.
    #[inline]
    fn radiance_at(&self, place: Vec2) -> Vec3 {
        let corner = (place - 0.5).floor();
        let beyond = place - 0.5 - corner;
        let (x, y) = (corner.x as i32, corner.y as i32);
        let row = |y: i32| self.texel(x, y).radiance * (1.0 - beyond.x) + self.texel(x + 1, y).radiance * beyond.x;
        row(y) * (1.0 - beyond.y) + row(y + 1) * beyond.y
    }

    /// The place of a direction, in texels.
    #[inline]
    fn place_of(&self, direction: Vec3) -> Vec2 {
        square_of(direction) * self.edge as f32
    }
}

/// Position of a texel in the list, up to one texel beyond the edges.
#[inline]
fn index_of(edge: i32, x: i32, y: i32) -> usize {
    let last = edge - 1;
    let is_beside = x < 0 || x > last;
    let (x, y) = (if is_beside { x.clamp(0, last) } else { x }, if is_beside { last - y } else { y });
    let is_beyond = y < 0 || y > last;
    let (x, y) = (if is_beyond { last - x } else { x }, if is_beyond { y.clamp(0, last) } else { y });
    (y * edge + x) as usize
}

/// How much light each texel sends: the mean of what is interpolated within it. So a texel beside a bright one is chosen for the light that
/// reaches into it.
fn weights(edge: u32, radiance: &[Vec3]) -> Vec<f64> {
    let luminance = |texel: Vec3| texel.as_dvec3().dot(DVec3::new(0.2126, 0.7152, 0.0722));
    let edge = edge as i32;
    let weight = |x: i32, y: i32| -> f64 {
        let shares = [(-1, 0.125), (0, 0.75), (1, 0.125)];
        let at = |dx: i32, dy: i32| luminance(radiance[index_of(edge, x + dx, y + dy)]);
        shares
            .iter()
            .map(|(dy, down)| down * shares.iter().map(|(dx, across)| across * at(*dx, *dy)).sum::<f64>())
            .sum()
    };
    (0..edge * edge).map(|index| weight(index % edge, index / edge)).collect()
}

/// FNV-1a over the bits of the texels.
fn fingerprint(radiance: &[Vec3]) -> u64 {
    let bits = radiance.iter().flat_map(Vec3::to_array).map(|value| u64::from(value.to_bits()));
    bits.fold(0xcbf2_9ce4_8422_2325, |hash, bits| (hash ^ bits).wrapping_mul(0x0100_0000_01b3))
}

impl PartialEq for EnvironmentMap {
    fn eq(&self, other: &Self) -> bool {
        (self.edge, self.fingerprint) == (other.edge, other.fingerprint) && self.texels == other.texels
    }
}

impl fmt::Debug for EnvironmentMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{} texels {:016x}", self.edge, self.edge, self.fingerprint)
    }
}

/// An environment map that stands in some bearing.
#[derive(Clone, Debug)]
pub struct Environment {
    map: Arc<EnvironmentMap>,
    rotation: f32,
    /// Sine and cosine of the rotation.
    turned: Vec2,
}

impl PartialEq for Environment {
    fn eq(&self, other: &Self) -> bool {
        self.rotation == other.rotation && (Arc::ptr_eq(&self.map, &other.map) || self.map == other.map)
    }
}

impl Environment {
    /// A map turned clockwise, seen from above, by `rotation` degrees; what is not finite is 0.
    pub fn new(map: Arc<EnvironmentMap>, rotation: f32) -> Self {
        let rotation = if rotation.is_finite() { rotation } else { 0.0 };
        let (sin, cos) = sincos_turns(rotation.rem_euclid(360.0) / 360.0);
        Self { map, rotation, turned: Vec2::new(sin, cos) }
    }

    /// The map.
    pub fn map(&self) -> &Arc<EnvironmentMap> {
        &self.map
    }

    /// Degrees by which it is turned clockwise, seen from above.
    pub fn rotation(&self) -> f32 {
        self.rotation
    }

    /// Sine and cosine of the rotation.
    pub fn turned(&self) -> Vec2 {
        self.turned
    }

    /// A direction of the world as one of the map.
    #[inline]
    fn to_map(&self, d: Vec3) -> Vec3 {
        let Vec2 { x: sin, y: cos } = self.turned;
        Vec3::new(d.x * cos - d.y * sin, d.x * sin + d.y * cos, d.z)
    }

    /// A direction of the map as one of the world.
    #[inline]
    pub(super) fn to_world(&self, d: Vec3) -> Vec3 {
        let Vec2 { x: sin, y: cos } = self.turned;
        Vec3::new(d.x * cos + d.y * sin, d.y * cos - d.x * sin, d.z)
    }

    /// Radiance from the unit vector `direction`.
    #[inline]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        self.map.radiance_at(self.map.place_of(self.to_map(direction)))
    }

    /// Density over solid angle with which [`Self::choose`] chooses a unit vector.
    #[inline]
    pub fn pdf(&self, direction: Vec3) -> f32 {
        let place = self.map.place_of(self.to_map(direction));
        let last = self.map.edge as i32 - 1;
        // A place on the far edge is within its last texel.
        self.map.texel((place.x as i32).min(last), (place.y as i32).min(last)).pdf
    }

    /// Chooses a direction by four numbers, each uniform in [0, 1): the first two a column of the table, the third whether it is its alias, the
    /// rest of the first and the fourth a place within the texel. `None` where the map is black.
    #[inline]
    pub fn choose(&self, u: [f32; 4]) -> Option<ChosenDirection> {
        let map = &*self.map;
        let edge = map.edge as f32;
        // The product may round up to the edge where that is no power of two.
        let (row, column) = ((u[0] * edge).floor().min(edge - 1.0), (u[1] * edge).floor().min(edge - 1.0));
        let own = row as u32 * map.edge + column as u32;
        let index = if u[2] < map.texels[own as usize].threshold { own } else { map.texels[own as usize].alias };
        let texel = &map.texels[index as usize];
        if texel.pdf <= 0.0 {
            return None;
        }
        let corner = Vec2::new((index % map.edge) as f32, (index / map.edge) as f32);
        let place = corner + Vec2::new((u[0] * edge - row).min(1.0), u[3]);
        let direction = self.to_world(direction_of(place * (1.0 / edge)));
        Some(ChosenDirection { direction, radiance: map.radiance_at(place), pdf: texel.pdf })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Dark, with a few texels that are bright, one of them on an edge and one in a corner.
    fn map(edge: u32) -> Arc<EnvironmentMap> {
        let mut radiance = vec![Vec3::splat(0.01); (edge * edge) as usize];
        for (at, value) in [(0, 50.0), (edge / 2, 9.0), (edge * edge / 2 + 3, 400.0), (edge * edge - 1, 3.0)] {
            radiance[at as usize] = Vec3::new(1.0, 0.8, 0.5) * value;
        }
        EnvironmentMap::new(edge, &radiance).unwrap().into()
    }

    /// Mean over the sphere.
    fn mean(of: impl Fn(Vec3) -> f64) -> f64 {
        // A multiple of the edges, so that densities are summed evenly.
        let steps = 960;
        let at = |step: usize| (step as f32 + 0.5) / steps as f32;
        let places = (0..steps * steps).map(|step| Vec2::new(at(step % steps), at(step / steps)));
        places.map(|place| of(direction_of(place))).sum::<f64>() / (steps * steps) as f64
    }

    #[test]
    fn densities_come_to_one_and_radiance_to_its_mean() {
        for rotation in [0.0, 77.0] {
            let environment = Environment::new(map(24), rotation);
            let sum = mean(|direction| f64::from(environment.pdf(direction))) * 4.0 * PI;
            assert!((sum - 1.0).abs() < 1e-3, "{sum}");
            let red = mean(|direction| f64::from(environment.radiance(direction).x));
            assert!((red / f64::from(environment.map().mean_radiance().x) - 1.0).abs() < 1e-3, "{red}");
        }
        // A map that takes the lower half for the upper one does not come to its mean.
        let environment = Environment::new(map(24), 0.0);
        let red = mean(|direction| f64::from(environment.radiance(direction.with_z(direction.z.abs())).x));
        assert!((red / f64::from(environment.map().mean_radiance().x) - 1.0).abs() > 1e-3);
    }

    #[test]
    fn radiance_goes_on_across_the_seams() {
        let texels: Vec<Vec3> = (0..256).map(|index| Vec3::splat((index * 37 % 101) as f32 / 10.0)).collect();
        let environment = Environment::new(EnvironmentMap::new(16, &texels).unwrap().into(), 0.0);
        let jump = |radiance: &dyn Fn(Vec3) -> Vec3| {
            let mut most = 0.0_f32;
            for step in 0..2000 {
                // A circle through the lower half, across all four seams.
                let (sin, cos) = sincos_turns(step as f32 / 2000.0);
                let (next_sin, next_cos) = sincos_turns((step as f32 + 0.01) / 2000.0);
                let at = |sin: f32, cos: f32| Vec3::new(cos * 0.6, sin * 0.6, -0.8);
                most = most.max((radiance(at(sin, cos)) - radiance(at(next_sin, next_cos))).length());
            }
            most
        };
        let own = jump(&|direction| environment.radiance(direction));
        let nearest = jump(&|direction| {
            let place = environment.map.place_of(direction);
            environment.map.texel(place.x as i32, place.y as i32).radiance
        });
        assert!(own < 0.05 && nearest > 1.0, "{own} {nearest}");
    }

    #[test]
    fn what_is_chosen_is_what_is_seen_there() {
        for (edge, rotation) in [(1, 0.0), (24, 0.0), (37, 200.0)] {
            let environment = Environment::new(map(edge.max(4)), rotation);
            let mut different = 0;
            for step in 0..10_000u32 {
                let number = |prime: u32| (step.wrapping_mul(prime) >> 8) as f32 / (1 << 24) as f32;
                let u = [number(0x9e37_79b1), number(0x85eb_ca6b), number(0xc2b2_ae35), number(0x27d4_eb2f)];
                let chosen = environment.choose(u).unwrap();
                assert!((chosen.direction.length() - 1.0).abs() < 1e-6 && chosen.pdf > 0.0);
                let seen = environment.radiance(chosen.direction);
                assert!((chosen.radiance - seen).length() <= 1e-3 * (1.0 + seen.length()), "{chosen:?}, {seen}");
                // Rounding may find the neighbour's density.
                different += u32::from(environment.pdf(chosen.direction) != chosen.pdf);
            }
            assert!(different < 10, "{different}");
        }
    }

    #[test]
    fn black_maps_choose_nothing_and_wrong_ones_are_refused() {
        let black = EnvironmentMap::new(4, &[Vec3::ZERO; 16]).unwrap();
        assert_eq!(Environment::new(black.into(), 0.0).choose([0.5; 4]), None);
        for wrong in [Vec3::NAN, Vec3::NEG_X, Vec3::INFINITY, Vec3::splat(1e10)] {
            assert!(EnvironmentMap::new(1, &[wrong]).is_err(), "{wrong}");
        }
        assert!(EnvironmentMap::new(2, &[Vec3::ONE; 3]).is_err() && EnvironmentMap::new(0, &[]).is_err());
        assert!(EnvironmentMap::new(1, &[Vec3::ONE]).is_ok());
    }
}
