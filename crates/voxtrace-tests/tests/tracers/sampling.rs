//! Everything that chooses directions chooses them with the density that it says (Pearson's chi-square test), and what it says of a
//! chosen direction is what it says of a given one. A new material or light is one more line here.

use std::f64::consts::TAU;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::packed::PackedMaterial;
use voxtrace::sky::{Background, Environment};
use voxtrace::{Material, PackedScene, Ray, Scene, Sky, Sun, VoxelGrid};
use voxtrace_core::bsdf::{Bsdf, Diffuse, MaterialBsdf};
use voxtrace_core::light::{DistantLight, Lights, Receiver};
use voxtrace_core::math::normalize;
use voxtrace_core::walk;
use voxtrace_tests::environments::noise_map;
use voxtrace_tests::random::Random;

/// Rows and columns of bins.
const ROWS: usize = 12;
const COLUMNS: usize = 16;
/// Points, in a row and in a column, at which a density is looked up in a bin.
const LOOKS: usize = 24;
const SAMPLES: usize = 40_000;

/// The directions within an angle of an axis, cut into bins of equal solid angle.
struct Cap {
    axis: Vec3,
    one_minus_cos_theta_max: f32,
}

impl Cap {
    /// The direction at a row and a column, which may be fractions.
    fn direction(&self, row: f32, column: f32) -> Vec3 {
        let below = row / ROWS as f32 * self.one_minus_cos_theta_max;
        let (sin, cos) = (column / COLUMNS as f32 * TAU as f32).sin_cos();
        let (tangent, bitangent) = self.axis.any_orthonormal_pair();
        let aside = (tangent * cos + bitangent * sin) * (below * (2.0 - below)).max(0.0).sqrt();
        normalize(self.axis * (1.0 - below) + aside)
    }

    /// The bin that holds a direction, the last one for those outside.
    fn bin(&self, direction: Vec3) -> usize {
        let (tangent, bitangent) = self.axis.any_orthonormal_pair();
        let row = ((1.0 - direction.dot(self.axis)) / self.one_minus_cos_theta_max * ROWS as f32).max(0.0) as usize;
        let turn = direction.dot(bitangent).atan2(direction.dot(tangent)).rem_euclid(TAU as f32) / TAU as f32;
        if row < ROWS { row * COLUMNS + ((turn * COLUMNS as f32) as usize).min(COLUMNS - 1) } else { ROWS * COLUMNS }
    }

    /// Checks that directions that `sample` chooses fall into each bin as often as `pdf` says, and outside or nowhere otherwise.
    fn check(
        &self,
        mut sample: impl FnMut(&mut Random) -> Option<Vec3>,
        pdf: impl Fn(Vec3) -> f32,
    ) -> Result<(), String> {
        let (mut random, mut found) = (Random(7), vec![0.0; ROWS * COLUMNS + 1]);
        for _ in 0..SAMPLES {
            found[sample(&mut random).map_or(ROWS * COLUMNS, |direction| self.bin(direction))] += 1.0;
        }
        let solid_angle = TAU * f64::from(self.one_minus_cos_theta_max) / (ROWS * COLUMNS) as f64;
        let mut expected: Vec<f64> = (0..ROWS * COLUMNS)
            .map(|bin| {
                let at = |index: usize| (index as f32 + 0.5) / LOOKS as f32;
                let looks = (0..LOOKS * LOOKS).map(|look| {
                    let (row, column) = ((bin / COLUMNS) as f32, (bin % COLUMNS) as f32);
                    f64::from(pdf(self.direction(row + at(look / LOOKS), column + at(look % LOOKS))))
                });
                looks.sum::<f64>() * solid_angle * (SAMPLES as f64) / (LOOKS * LOOKS) as f64
            })
            .collect();
        expected.push((SAMPLES as f64 - expected.iter().sum::<f64>()).max(0.0));
        // Bins where next to nothing is expected count together.
        let (mut rest, mut statistic, mut freedoms) = ((0.0, 0.0), 0.0, 0.0);
        for (&found, &expected) in found.iter().zip(&expected) {
            if expected < 8.0 {
                rest = (rest.0 + found, rest.1 + expected);
            } else {
                statistic += (found - expected).powi(2) / expected;
                freedoms += 1.0;
            }
        }
        statistic += (rest.0 - rest.1).powi(2) / rest.1.max(8.0);
        // The mean and four standard deviations of the distribution of the statistic.
        let most = freedoms + 4.0 * f64::sqrt(2.0 * freedoms) + 10.0;
        if statistic > most { Err(format!("chi-square {statistic:.0} of {freedoms}, {rest:?}")) } else { Ok(()) }
    }
}

const SPHERE: Cap = Cap { axis: Vec3::Z, one_minus_cos_theta_max: 2.0 };

fn three(random: &mut Random) -> [f32; 3] {
    std::array::from_fn(|_| random.unit())
}

fn four(random: &mut Random) -> [f32; 4] {
    std::array::from_fn(|_| random.unit())
}

/// Checks that what a surface says of the directions that it chooses is what it says of them when they are given, and that their weights
/// come to its albedo.
fn check_consistent(bsdf: &impl Bsdf, wo: Vec3) -> Result<(), String> {
    let (mut random, mut sum) = (Random(8), Vec3::ZERO);
    for _ in 0..4096 {
        let Some(sample) = bsdf.sample(wo, three(&mut random)) else { continue };
        sum += sample.weight / 4096.0;
        let eval = bsdf.eval(wo, sample.wi);
        let is_same = (eval.weight * eval.pdf).abs_diff_eq(sample.weight * sample.pdf, 1e-4 * sample.pdf)
            && (eval.pdf / sample.pdf - 1.0).abs() < 1e-4;
        if (sample.wi.length() - 1.0).abs() > 1e-5 || !sample.is_delta && !is_same {
            return Err(format!("{sample:?}, {eval:?}"));
        }
    }
    if sum.abs_diff_eq(bsdf.albedo(), 0.02) { Ok(()) } else { Err(format!("weights {sum}, albedo {}", bsdf.albedo())) }
}

/// A surface that says what `change` makes of what the diffuse one says.
struct Planted<F: Fn(Vec3) -> f32>(Diffuse, F);

impl<F: Fn(Vec3) -> f32> Bsdf for Planted<F> {
    fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<voxtrace_core::bsdf::BsdfSample> {
        self.0.sample(wo, u)
    }

    fn eval(&self, wo: Vec3, wi: Vec3) -> voxtrace_core::bsdf::BsdfEval {
        let eval = self.0.eval(wo, wi);
        voxtrace_core::bsdf::BsdfEval { pdf: eval.pdf * (self.1)(wi), ..eval }
    }

    fn albedo(&self) -> Vec3 {
        self.0.albedo()
    }
}

#[test]
fn surfaces_choose_directions_with_the_density_that_they_say() {
    let diffuse = Diffuse { reflectance: Vec3::new(0.9, 0.5, 0.1) };
    let material = PackedMaterial::from(&Material::diffuse(diffuse.reflectance));
    let check = |bsdf: &dyn Fn(Vec3, [f32; 3]) -> Option<Vec3>, pdf: &dyn Fn(Vec3, Vec3) -> f32| {
        [Vec3::Z, Vec3::new(0.6, 0.0, 0.8), Vec3::new(-0.7, 0.7, 0.141)].into_iter().try_for_each(|wo| {
            let wo = normalize(wo);
            SPHERE.check(|random| bsdf(wo, three(random)), |wi| pdf(wo, wi))
        })
    };
    let bsdf = MaterialBsdf::new(&material, 1.0, &mut 0.5);
    check(&|wo, u| Some(bsdf.sample(wo, u)?.wi), &|wo, wi| bsdf.eval(wo, wi).pdf).unwrap();
    // A density a little too large towards the horizon, and a sample that is.
    let wrong = Planted(diffuse, |wi| 1.2 - 0.3 * wi.z);
    check(&|wo, u| Some(wrong.sample(wo, u)?.wi), &|wo, wi| wrong.eval(wo, wi).pdf).unwrap_err();
    check(&|wo, [u, v, w]| Some(bsdf.sample(wo, [u.powf(0.9), v, w])?.wi), &|wo, wi| bsdf.eval(wo, wi).pdf)
        .unwrap_err();
}

#[test]
fn surfaces_say_the_same_of_chosen_and_given_directions() {
    let diffuse = Diffuse { reflectance: Vec3::new(0.9, 0.5, 0.1) };
    let bsdf = MaterialBsdf::new(&PackedMaterial::from(&Material::diffuse(diffuse.reflectance)), 1.0, &mut 0.5);
    for wo in [Vec3::Z, Vec3::new(0.6, 0.0, 0.8)] {
        check_consistent(&bsdf, wo).unwrap();
        check_consistent(&Planted(diffuse, |_| 1.01), wo).unwrap_err();
    }
}

/// The models of rough surfaces, as a path meets them.
fn rough_models() -> Vec<MaterialBsdf> {
    let base = Vec3::new(0.9, 0.5, 0.1);
    let materials = [0.35, 0.6, 1.0].into_iter().flat_map(|roughness| {
        [Material::metal(base, roughness), Material::plastic(base, roughness), Material::glass(1.5, roughness)]
    });
    let smooth = [Material::plastic(base, 0.0), Material::cloud(base, 0.3, 0.6), Material::cloud(base, 0.3, -0.4)];
    let material = |material: Material| PackedMaterial::from(&material);
    let mut models: Vec<MaterialBsdf> =
        materials.chain([smooth[0]]).map(|it| MaterialBsdf::new(&material(it), 1.0, &mut 0.5)).collect();
    models.extend(smooth[1..].iter().map(|&it| MaterialBsdf::within(&material(it))));
    models
}

#[test]
fn rough_surfaces_and_media_choose_directions_with_the_density_that_they_say() {
    for bsdf in rough_models() {
        for wo in [Vec3::Z, Vec3::new(0.6, 0.0, 0.8), Vec3::new(-0.5, 0.7, 0.51)].map(normalize) {
            // Delta directions are found by nothing else.
            let sample = |u: [f32; 3]| Some(bsdf.sample(wo, u).filter(|sample| !sample.is_delta)?.wi);
            let check = |factor: f32| SPHERE.check(|random| sample(three(random)), |wi| bsdf.eval(wo, wi).pdf * factor);
            check(1.0).unwrap_or_else(|error| panic!("{bsdf:?} {wo}: {error}"));
            if bsdf.eval(wo, wo.with_z(0.9)).pdf > 0.05 {
                check(1.3).unwrap_err();
            }
            // What is said of a chosen direction is what is said of a given one.
            let mut random = Random(9);
            for _ in 0..2048 {
                let Some(sample) = bsdf.sample(wo, three(&mut random)).filter(|sample| !sample.is_delta) else {
                    continue;
                };
                let eval = bsdf.eval(wo, sample.wi);
                let (chosen, given) = (sample.weight * sample.pdf, eval.weight * eval.pdf);
                assert!((eval.pdf / sample.pdf - 1.0).abs() < 2e-3, "{bsdf:?}: {sample:?} {eval:?}");
                assert!(chosen.abs_diff_eq(given, 2e-3 * sample.pdf), "{bsdf:?}: {sample:?} {eval:?}");
            }
        }
    }
}

#[test]
fn surfaces_are_the_same_along_a_path_and_against_it() {
    for bsdf in rough_models() {
        let in_medium = matches!(bsdf, MaterialBsdf::Phase(_));
        let mut random = Random(10);
        for _ in 0..2048 {
            let direction = |random: &mut Random| {
                let direction = random.direction();
                if in_medium { direction } else { direction.with_z(direction.z.abs().max(1e-3)) }
            };
            let (wo, wi) = (normalize(direction(&mut random)), normalize(direction(&mut random)));
            let f = |wo: Vec3, wi: Vec3| {
                let eval = bsdf.eval(wo, wi);
                eval.weight * eval.pdf / if in_medium { 1.0 } else { wi.z }
            };
            let (there, back) = (f(wo, wi), f(wi, wo));
            assert!(there.abs_diff_eq(back, 2e-3 * there.max_element()), "{bsdf:?}: {there} and {back}");
        }
    }
    // A surface that forgets a cosine is found.
    let bsdf = MaterialBsdf::new(&PackedMaterial::from(&Material::metal(Vec3::ONE, 0.6)), 1.0, &mut 0.5);
    let f = |wo: Vec3, wi: Vec3| bsdf.eval(wo, wi).weight.x * bsdf.eval(wo, wi).pdf;
    let (wo, wi) = (normalize(Vec3::new(0.6, 0.0, 0.8)), normalize(Vec3::new(0.1, 0.2, 0.9)));
    assert!((f(wo, wi) / f(wi, wo) - 1.0).abs() > 0.05);
}

#[test]
fn the_sun_and_the_sky_choose_directions_with_the_density_that_they_say() {
    for radius in [0.01_f32, 0.5] {
        let sun =
            Sun { direction: Vec3::new(0.1, 0.2, 0.6).normalize(), angular_radius: radius, irradiance: Vec3::ONE };
        let scene = PackedScene::pack(&Scene { sky: Sky::study(1.0).with_sun(sun), ..Scene::new("sunny") }).unwrap();
        let lights = Lights::new(&scene);
        let disc = lights.sun.as_ref().unwrap();
        let cap = Cap { axis: sun.direction, one_minus_cos_theta_max: disc.one_minus_cos_theta_max * 1.2 };
        // The sun above a place, and the horizon through its disc.
        let (_, aside) = sun.direction.any_orthonormal_pair();
        for normal in [sun.direction, normalize(aside + sun.direction * radius * 0.3)] {
            let receiver = Receiver::on_surface(Vec3::ZERO, normal);
            let check = |light: &dyn Fn(f32, f32) -> Option<Vec3>, factor: f32| {
                cap.check(
                    |random| light(random.unit(), random.unit()),
                    |direction| if normal.dot(direction) > 0.0 { disc.pdf(direction) * factor } else { 0.0 },
                )
            };
            let sample = |u: f32, v: f32| Some(disc.sample(&receiver, [0.0, 0.0, u, v])?.ray.direction);
            check(&sample, 1.0).unwrap();
            check(&sample, 1.05).unwrap_err();
            check(&|u, v| sample(u * u.sqrt(), v), 1.0).unwrap_err();
            SPHERE
                .check(
                    |random| Some(lights.sky.sample(&receiver, four(random))?.ray.direction),
                    |direction| lights.sky.pdf(direction),
                )
                .unwrap();
        }
    }
}

#[test]
fn an_environment_map_chooses_directions_with_the_density_that_it_says() {
    for (edge, rotation) in [(16, 0.0), (37, 123.0)] {
        let environment = Environment::new(noise_map(edge, 4), rotation);
        let sky = Sky::new(Background::Environment(environment.clone())).with_brightness(0.3);
        for normal in [Vec3::Z, normalize(Vec3::new(0.4, -0.8, -0.5))] {
            let receiver = Receiver::on_surface(Vec3::ZERO, normal);
            let above = |pdf: &dyn Fn(Vec3) -> f32, wi: Vec3| if normal.dot(wi) > 0.0 { pdf(wi) } else { 0.0 };
            let check = |sample: &dyn Fn([f32; 4]) -> Option<Vec3>, pdf: &dyn Fn(Vec3) -> f32| {
                SPHERE.check(|random| sample(four(random)), |wi| above(pdf, wi))
            };
            let sample = |u: [f32; 4]| Some(sky.sample(&receiver, u)?.ray.direction);
            check(&sample, &|wi| sky.pdf(wi)).unwrap();
            // One that is turned the other way, a table without aliases, and a texel that is filled unevenly.
            let other = Environment::new(environment.map().clone(), 30.0 - rotation);
            check(&sample, &|wi| other.pdf(wi)).unwrap_err();
            check(&|[a, b, _, d]| sample([a, b, 0.0, d]), &|wi| sky.pdf(wi)).unwrap_err();
            check(&|[a, b, c, _]| sample([a, b, c, 0.0]), &|wi| sky.pdf(wi)).unwrap_err();
        }
    }
}

#[test]
fn points_of_an_emitter_are_chosen_with_the_density_that_the_lights_say() {
    let mut lamp = VoxelGrid::new();
    lamp.set(IVec3::ZERO, 0);
    let sun = Sun { direction: Vec3::X, angular_radius: 0.1, irradiance: Vec3::ONE };
    let scene = Scene::from_grid("lamp", lamp, vec![Material::emissive(Vec3::splat(30.0))]);
    let scene = PackedScene::pack(&Scene { sky: Sky::study(1.0).with_sun(sun), ..scene }).unwrap();
    let lights = Lights::new(&scene);
    // A corner of the lamp is before the receiver: three faces are seen.
    let point = Vec3::new(3.0, 2.5, 2.0);
    let axis = normalize(Vec3::splat(0.5) - point);
    let cap = Cap { axis, one_minus_cos_theta_max: 0.08 };
    for normal in [axis, normalize(Vec3::new(0.3, -1.0, -0.4))] {
        let receiver = Receiver::on_surface(point, normal);
        let four = |random: &mut Random| std::array::from_fn(|_| random.unit());
        let sample = |random: &mut Random| Some(normalize(lights.sample(&receiver, four(random))?.ray.direction));
        let pdf = |direction: Vec3| {
            let ray = Ray::new(point, direction);
            let hit = walk::cast(&scene, &ray);
            if hit.is_miss() { 0.0 } else { lights.emitter_pdf(&receiver, &ray, &hit) }
        };
        cap.check(sample, pdf).unwrap();
        cap.check(sample, |direction| pdf(direction) * 1.05).unwrap_err();
    }
}
