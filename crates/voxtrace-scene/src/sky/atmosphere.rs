//! The sky of a planet with an atmosphere that the sun lights: Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering
//! Technique", EGSR 2020. Light scattered once is integrated along each ray, all that is scattered more often comes from a small table
//! (section 5.5). Computed in double precision by sums, products and roots alone, so that every machine makes the same sky.

use super::environment::{Environment, EnvironmentMap};
use super::equal_area::direction_of;
use super::transmittance::{GROUND, TOP, Table, Transmittance, decay, decay_of, hits_ground, way_to_top};
use super::{Background, Sky, Sun};
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Texels along an edge of the map.
const EDGE: u32 = 512;
/// Height of the observer above the ground, km.
const EYE: f64 = 0.01;
/// Steps along a ray of the sky, one that looks down, and one of the table.
const STEPS: u32 = 32;
const STEPS_DOWN: u32 = 8;
const TABLE_STEPS: u32 = 20;
/// Rows and columns of the table, and rows of the directions that it gathers from: most light comes from a narrow band above the horizon.
const TABLE_EDGE: usize = 32;
const TABLE_ROWS: u32 = 32;
/// Texels whose directions have a z nearer to 0 than this are looked at in so many rows and columns.
const NEAR_HORIZON: f64 = 0.02;
const LOOKS: u32 = 4;
/// Where in its step a ray is looked at.
const WITHIN_STEP: f64 = 0.5;

/// What the air of a planet like the Earth consists of: coefficients at sea level in 1/km, red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Atmosphere {
    /// Scattering by molecules, which thin out by a factor of e every 8 km.
    pub rayleigh: DVec3,
    /// Scattering by haze, which thins out by a factor of e every 1.2 km.
    pub mie: DVec3,
    /// Absorption by haze.
    pub mie_absorption: DVec3,
    /// Mean cosine of the angle by which haze scatters, within ±0.99.
    pub mie_g: f64,
    /// Absorption by ozone at 25 km, where there is most; none is below 10 km or above 40 km.
    pub ozone: DVec3,
    /// Share of light that the ground reflects.
    pub ground: DVec3,
}

impl Atmosphere {
    /// The Earth's on a clear day (Hillaire, table 1).
    pub const EARTH: Self = Self {
        rayleigh: DVec3::new(5.802e-3, 13.558e-3, 33.1e-3),
        mie: DVec3::splat(3.996e-3),
        mie_absorption: DVec3::splat(0.444e-3),
        mie_g: 0.8,
        ozone: DVec3::new(0.650e-3, 1.881e-3, 0.085e-3),
        ground: DVec3::splat(0.3),
    };

    /// The sky in the light of a sun whose irradiance is that above the air, and what of the sun comes through. What is below the horizon
    /// is the ground.
    pub fn sky(&self, sun: &Sun) -> Sky {
        let direction = sun.direction.try_normalize().unwrap_or(Vec3::Z).as_dvec3();
        let lit = LitAir::new(self, direction);
        let irradiance = sun.irradiance.as_dvec3().max(DVec3::ZERO);
        let direction_at = |index: u32, within: Vec2| {
            let corner = Vec2::new((index % EDGE) as f32, (index / EDGE) as f32);
            direction_of((corner + within) / EDGE as f32).as_dvec3()
        };
        let direction_of_texel = |index: u32| direction_at(index, Vec2::splat(0.5));
        let along = |index: u32| {
            let height = direction_of_texel(index).z;
            let steps = if height < -NEAR_HORIZON { STEPS_DOWN } else { STEPS };
            // The horizon goes diagonally through its texels, and would have teeth.
            let looks = if height.abs() < NEAR_HORIZON { LOOKS } else { 1 };
            let seen = (0..looks * looks).map(|look| {
                let within = Vec2::new((look % looks) as f32 + 0.5, (look / looks) as f32 + 0.5) / looks as f32;
                lit.along(DVec3::Z * (GROUND + EYE), direction_at(index, within), steps, true)
            });
            Seen::mean(seen)
        };
        let rays: Vec<Seen> = (0..EDGE * EDGE).into_par_iter().map(along).collect();
        // What the sky sends to the ground: texels are of equal solid angle.
        let onto_ground = |(index, seen): (usize, &Seen)| seen.radiance * direction_of_texel(index as u32).z.max(0.0);
        let from_sky = rays.iter().enumerate().map(onto_ground).sum::<DVec3>() * (4.0 * PI / rays.len() as f64);
        let radiance = |seen: &Seen| {
            let ground = seen.ground * self.ground * from_sky / PI;
            ((seen.radiance + ground) * irradiance).as_vec3().clamp(Vec3::ZERO, Vec3::splat(1e9))
        };
        let texels: Vec<Vec3> = rays.iter().map(radiance).collect();
        // Densities beyond all measure give a black sky rather than none.
        let map = EnvironmentMap::new(EDGE, &texels).or_else(|_| EnvironmentMap::new(1, &[Vec3::ZERO]));
        let background = map.map(|map| Background::Environment(Environment::new(map.into(), 0.0)));
        let arriving = sun.irradiance * lit.of_sun(DVec3::Z * (GROUND + EYE)).as_vec3();
        let sun = Sun { irradiance: arriving, ..*sun };
        let background = background.unwrap_or_else(|_| Background::uniform(Vec3::ZERO));
        Sky::new(background).with_sun((arriving.max_element() > 0.0).then_some(sun))
    }

    /// What a kilometre of the air does at a height above the ground.
    pub(super) fn at(&self, height: f64) -> Air {
        let rayleigh = self.rayleigh * decay(height / 8.0);
        let haze = decay(height / 1.2);
        let ozone = self.ozone * (1.0 - (height - 25.0).abs() / 15.0).max(0.0);
        let mie = self.mie * haze;
        Air { rayleigh, mie, extinction: rayleigh + mie + self.mie_absorption * haze + ozone }
    }
}

/// Coefficients at one height, 1/km.
pub(super) struct Air {
    pub rayleigh: DVec3,
    pub mie: DVec3,
    pub extinction: DVec3,
}

/// What is seen along a ray, for a sun of irradiance 1.
struct Seen {
    radiance: DVec3,
    /// What is let through to the ground, nothing where the ray does not meet it.
    ground: DVec3,
    /// Share of light from everywhere that is scattered towards the eye.
    scattered: DVec3,
}

impl Seen {
    fn mean(all: impl ExactSizeIterator<Item = Self>) -> Self {
        let share = 1.0 / all.len() as f64;
        let none = Self { radiance: DVec3::ZERO, ground: DVec3::ZERO, scattered: DVec3::ZERO };
        all.fold(none, |sum, one| Self {
            radiance: sum.radiance + one.radiance * share,
            ground: sum.ground + one.ground * share,
            scattered: sum.scattered + one.scattered * share,
        })
    }
}

/// An atmosphere in the light of a sun.
struct LitAir<'a> {
    air: &'a Atmosphere,
    sun: DVec3,
    transmittance: Transmittance,
    /// Light scattered twice or more often, by the height and the cosine of the sun's angle from the zenith.
    multiple: Table,
}

impl<'a> LitAir<'a> {
    fn new(air: &'a Atmosphere, sun: DVec3) -> Self {
        let transmittance = Transmittance::new(air);
        let mut lit = Self { air, sun, transmittance, multiple: Table::new(1, 1, |_, _| DVec3::ZERO) };
        let multiple = Table::new(TABLE_EDGE, TABLE_EDGE, |x, y| {
            let height = y * (TOP - GROUND);
            lit.scattered_often(x * 2.0 - 1.0, height, (TABLE_ROWS, TABLE_STEPS))
        });
        lit.multiple = multiple;
        lit
    }

    /// Share of the sun's light that comes to a point, where the planet is not in the way.
    fn of_sun(&self, point: DVec3) -> DVec3 {
        self.of_sun_at(point.length(), point.dot(self.sun) / point.length())
    }

    fn of_sun_at(&self, radius: f64, cosine: f64) -> DVec3 {
        if hits_ground(radius, cosine) { DVec3::ZERO } else { self.transmittance.to_top(radius, cosine) }
    }

    /// An entry of the table: light scattered twice, continued as a geometric series, gathered by rays of so many steps from so many rows of
    /// directions.
    fn scattered_often(&self, cosine: f64, height: f64, (rows, steps): (u32, u32)) -> DVec3 {
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let lit = Self {
            sun: DVec3::new(sine, 0.0, cosine),
            multiple: Table::new(1, 1, |_, _| DVec3::ZERO),
            transmittance: self.transmittance.clone(),
            air: self.air,
        };
        let point = DVec3::Z * (GROUND + height.clamp(1e-3, TOP - GROUND - 1e-3));
        let (mut twice, mut share) = (DVec3::ZERO, DVec3::ZERO);
        // Eight directions of each row, of which those behind the plane of the sun see the same as those before it.
        let root = 2.0_f64.sqrt();
        let [near, far] = [(2.0 + root).sqrt() * 0.5, (2.0 - root).sqrt() * 0.5];
        let around = [(near, far), (far, near), (-far, near), (-near, far)];
        for row in 0..rows {
            let z = (f64::from(row) + 0.5) / f64::from(rows) * 2.0 - 1.0;
            let level = (1.0 - z * z).sqrt();
            for (x, y) in around {
                let seen = lit.along(point, DVec3::new(x * level, y * level, z), steps, false);
                twice += seen.radiance;
                share += seen.scattered;
            }
        }
        let count = f64::from(rows) * around.len() as f64;
        twice / count / (1.0 - (share / count).min(DVec3::splat(0.99)))
    }

    /// What a ray from a point of the air sees. Without `has_phase` light is scattered evenly, as in the table.
    fn along(&self, start: DVec3, direction: DVec3, steps: u32, has_phase: bool) -> Seen {
        let (radius, cosine) = (start.length(), start.dot(direction) / start.length());
        let meets_ground = hits_ground(radius, cosine);
        let length = if meets_ground {
            -radius * cosine - (radius * radius * (cosine * cosine - 1.0) + GROUND * GROUND).max(0.0).sqrt()
        } else {
            way_to_top(radius, cosine)
        };
        let angle = direction.dot(self.sun);
        let even = 1.0 / (4.0 * PI);
        let phases = if has_phase { (rayleigh_phase(angle), mie_phase(self.air.mie_g, angle)) } else { (even, even) };
        let (mut radiance, mut scattered, mut through) = (DVec3::ZERO, DVec3::ZERO, DVec3::ONE);
        // Steps grow with the distance: most of the air that counts is near.
        let distance = |step: f64| length * (step / f64::from(steps)).powi(2);
        for step in 0..steps {
            let (from, to) = (distance(step.into()), distance(f64::from(step) + 1.0));
            let point = start + direction * (from + (to - from) * WITHIN_STEP);
            let (radius, cosine) = (point.length(), point.dot(self.sun) / point.length());
            let air = self.air.at(radius - GROUND);
            let all = air.rayleigh + air.mie;
            let once = (air.rayleigh * phases.0 + air.mie * phases.1) * self.of_sun_at(radius, cosine);
            let often = all * self.multiple.at(cosine * 0.5 + 0.5, (radius - GROUND) / (TOP - GROUND));
            let passed = decay_of(air.extinction * (to - from));
            // The integral over the step of what thins out exponentially on its way.
            let share = through * (DVec3::ONE - passed) / air.extinction.max(DVec3::splat(1e-12));
            radiance += share * (once + often);
            scattered += share * all;
            through *= passed;
        }
        if !meets_ground {
            return Seen { radiance, ground: DVec3::ZERO, scattered };
        }
        let place = (start + direction * length).normalize();
        let lit = self.of_sun_at(GROUND, place.dot(self.sun)) * place.dot(self.sun).max(0.0);
        Seen { radiance: radiance + through * lit * self.air.ground / PI, ground: through, scattered }
    }
}

/// Density over solid angle with which molecules scatter by an angle of this cosine.
fn rayleigh_phase(cosine: f64) -> f64 {
    3.0 / (16.0 * PI) * (1.0 + cosine * cosine)
}

/// Density over solid angle with which haze scatters (Cornette and Shanks, 1992).
fn mie_phase(g: f64, cosine: f64) -> f64 {
    let g = g.clamp(-0.99, 0.99);
    let base = 1.0 + g * g - 2.0 * g * cosine;
    3.0 / (8.0 * PI) * (1.0 - g * g) * (1.0 + cosine * cosine) / ((2.0 + g * g) * base * base.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sun(height: f32) -> Sun {
        Sun { irradiance: Vec3::ONE, ..Sun::at(90.0, height, 1.0).unwrap() }
    }

    #[test]
    fn phases_come_to_one() {
        let integral = |phase: &dyn Fn(f64) -> f64| {
            let steps = 200_000;
            let cosines = (0..steps).map(|step| (f64::from(step) + 0.5) / f64::from(steps) * 2.0 - 1.0);
            cosines.map(phase).sum::<f64>() * 4.0 * PI / f64::from(steps)
        };
        assert!((integral(&rayleigh_phase) - 1.0).abs() < 1e-6);
        for g in [-0.5, 0.0, 0.8] {
            assert!((integral(&|cosine| mie_phase(g, cosine)) - 1.0).abs() < 1e-4, "{g}");
            assert!((integral(&|cosine| mie_phase(g, cosine) * (1.0 + 1e-3)) - 1.0).abs() > 1e-4);
        }
    }

    /// Irradiance of the sky, without the sun, on the ground.
    fn from_sky(sky: &Sky) -> DVec3 {
        let steps = 128;
        let at = |step: u32| (step as f32 + 0.5) / steps as f32;
        let places = (0..steps * steps).map(|step| Vec2::new(at(step % steps), at(step / steps)));
        let sum: DVec3 = places.map(direction_of).map(|d| (sky.radiance(d) * d.z.max(0.0)).as_dvec3()).sum();
        sum * 4.0 * PI / f64::from(steps * steps)
    }

    #[test]
    fn a_clear_sky_is_blue_at_noon_and_red_where_the_sun_goes_down() {
        let noon = Atmosphere::EARTH.sky(&sun(70.0));
        let evening = Atmosphere::EARTH.sky(&sun(2.0));
        let zenith = noon.radiance(Vec3::Z);
        assert!(zenith.z > 2.0 * zenith.x && zenith.z > 1.5 * zenith.y, "{zenith}");
        let of = |sky: &Sky| sky.sun().unwrap().irradiance;
        // What of the light of the sun in the zenith comes through clear air: 0.7 to 0.9 of green.
        assert!((0.7..0.92).contains(&of(&noon).y), "{}", of(&noon));
        assert!(of(&evening).x > 4.0 * of(&evening).z, "{}", of(&evening));
        let (towards, away) = (Vec3::new(0.99, 0.0, 0.14), Vec3::new(-0.99, 0.0, 0.14));
        assert!(evening.radiance(towards).x > 2.0 * evening.radiance(away).x, "the light is where the sun is");
        // The sky sends a tenth to a fourth of what the sun at noon sends (Bird and Hulstrom 1981 have 0.1 to 0.2).
        let share = from_sky(&noon).y / f64::from(of(&noon).y * sun(70.0).direction.z);
        assert!((0.08..0.25).contains(&share), "{share}");
        let night = Atmosphere::EARTH.sky(&sun(-20.0));
        assert!(night.sun().is_none() && night.mean_radiance().max_element() < 1e-3 * noon.mean_radiance().x);
    }

    #[test]
    fn steps_and_directions_are_enough() {
        for height in [60.0, 10.0, 2.0] {
            let direction = sun(height).direction.as_dvec3();
            let lit = LitAir::new(&Atmosphere::EARTH, direction);
            let apart = |ours: DVec3, exact: DVec3| ((ours - exact) / exact).abs().max_element();
            // The table, above the ground and in the middle of the air.
            for above in [0.01, 5.0] {
                let of = |rows, steps| lit.scattered_often(direction.z, above, (rows, steps));
                let exact = of(240, 100);
                let ours = of(TABLE_ROWS, TABLE_STEPS);
                assert!(apart(ours, exact) < 0.05, "{height} {above}: {ours} {exact}");
                assert!(apart(of(4, TABLE_STEPS), exact) > 0.05, "{height} {above}: few directions are noticed");
            }
            for z in [1.0_f64, 0.5, 0.1] {
                let along = DVec3::new(0.0, (1.0 - z * z).sqrt(), z);
                let seen = |steps| lit.along(DVec3::Z * (GROUND + EYE), along, steps, true).radiance;
                assert!(apart(seen(STEPS), seen(4000)) < 0.02, "{height} {z}: {} {}", seen(STEPS), seen(4000));
            }
        }
    }

    #[test]
    fn no_light_is_made_in_the_air_and_none_is_lost_where_nothing_absorbs() {
        // Air that only scatters over a white ground: what comes in at noon goes back out, so that the light near the ground
        // that goes down is what goes up again.
        let white =
            Atmosphere { mie_absorption: DVec3::ZERO, ozone: DVec3::ZERO, ground: DVec3::ONE, ..Atmosphere::EARTH };
        let sky = white.sky(&sun(60.0));
        let sine = f64::from(sun(60.0).direction.z);
        let down = from_sky(&sky) + sky.sun().unwrap().irradiance.as_dvec3() * sine;
        let net = down / sine;
        // Between two white sheets light gathers: never less than comes in, and not without bound.
        assert!(net.min_element() > 0.95 && net.max_element() < 1.6, "{net}");
        let dark = Atmosphere { ground: DVec3::ZERO, ..white };
        let sky = dark.sky(&sun(60.0));
        let down = (from_sky(&sky) + sky.sun().unwrap().irradiance.as_dvec3() * sine) / sine;
        assert!(down.max_element() < 1.0 && down.min_element() > 0.6, "{down}");
    }

    #[test]
    fn no_air_is_a_black_sky_with_all_of_the_sun() {
        let none = Atmosphere {
            rayleigh: DVec3::ZERO,
            mie: DVec3::ZERO,
            mie_absorption: DVec3::ZERO,
            ozone: DVec3::ZERO,
            ..Atmosphere::EARTH
        };
        let sky = none.sky(&sun(30.0));
        assert!(sky.sun().unwrap().irradiance.abs_diff_eq(Vec3::ONE, 1e-6));
        assert_eq!(sky.radiance(Vec3::new(0.0, 0.6, 0.8)), Vec3::ZERO);
        // The ground: albedo over π times the cosine of the sun.
        let ground = sky.radiance(Vec3::NEG_Z);
        assert!((f64::from(ground.x) - 0.3 * 0.5 / PI).abs() < 1e-3, "{ground}");
    }

    #[test]
    fn densities_beyond_measure_give_some_sky() {
        for density in [1e30, f64::INFINITY, f64::NAN] {
            let thick = Atmosphere { rayleigh: DVec3::splat(density), ..Atmosphere::EARTH };
            assert!(thick.sky(&sun(30.0)).mean_radiance().is_finite(), "{density}");
        }
    }
}
