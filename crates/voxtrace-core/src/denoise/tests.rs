//! The filter against pictures whose truth is known.

use super::{FeaturePixel, Features, denoise, denoise_while};
use crate::film::{Film, Pixel};
use crate::frame::Region;
use crate::sampler::Sampler;
use glam::Vec3;
use std::sync::atomic::{AtomicU32, Ordering};

const SIZE: u32 = 64;
const SAMPLES: u32 = 16;

/// A film with noise, what it would be without, and its features.
struct Case {
    film: Film,
    truth: Vec<Vec3>,
    features: Features,
}

impl Case {
    /// Pixels by their truth and their features; each sample is between 0 and twice its truth where `noise` is 1.
    fn new(noise: f32, pixel: impl Fn(u32, u32) -> (Vec3, FeaturePixel)) -> Self {
        let places = || (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y)));
        let (truth, features): (Vec<Vec3>, Vec<FeaturePixel>) = places().map(|(x, y)| pixel(x, y)).unzip();
        let mut film = Film::new(SIZE, SIZE, Region::full(SIZE, SIZE), 0);
        for sample in 0..SAMPLES {
            for (index, (out, (truth, features))) in film.pixels.iter_mut().zip(truth.iter().zip(&features)).enumerate()
            {
                let sampler = Sampler { seed: 1, pixel: index as u32, sample };
                let factor = 1.0 + noise * (2.0 * sampler.independent(7)[0] - 1.0);
                out.add(features.direct + (*truth - features.direct) * factor, features.coverage > 0.0);
            }
            if sample + 1 == SAMPLES / 2 {
                film.earlier = Some(film.pixels.clone());
            }
        }
        Self { film, truth, features: Features { pixels: features } }
    }

    fn error_of(&self, radiance: impl Iterator<Item = Vec3>) -> f32 {
        radiance.zip(&self.truth).map(|(radiance, truth)| (radiance - truth).length_squared()).sum()
    }

    /// Square error after the filter over that before.
    fn ratio(&self) -> f32 {
        let clean = denoise(&self.film, &self.features);
        self.error_of(clean.into_iter()) / self.error_of(self.film.pixels.iter().map(Pixel::mean))
    }

    /// The square error must fall at least to this part.
    fn check(&self, most: f32) -> Result<(), String> {
        let ratio = self.ratio();
        if ratio <= most { Ok(()) } else { Err(format!("{ratio} of the error is left, more than {most}")) }
    }
}

/// A pixel of a floor seen from above.
fn floor(x: u32, y: u32, albedo: Vec3) -> FeaturePixel {
    FeaturePixel {
        direct: Vec3::ZERO,
        albedo,
        normal: Vec3::Z,
        position: Vec3::new(x as f32, y as f32, -50.0),
        roughness: 0.0,
        coverage: 1.0,
        chance: [0.0; 2],
    }
}

fn checkered(x: u32, y: u32) -> Vec3 {
    if (x / 2 + y / 2).is_multiple_of(2) { Vec3::new(0.8, 0.7, 0.6) } else { Vec3::new(0.1, 0.3, 0.2) }
}

#[test]
fn a_textured_floor_in_soft_light_loses_its_noise_and_keeps_its_texture() {
    let light = |x: u32| 1.0 + x as f32 / SIZE as f32;
    let case = Case::new(1.0, |x, y| (checkered(x, y) * light(x), floor(x, y, checkered(x, y))));
    case.check(0.08).unwrap();
    // Without the albedos the texture looks like light, which cannot be told from noise as well.
    Case::new(1.0, |x, y| (checkered(x, y) * light(x), floor(x, y, Vec3::ONE))).check(0.08).unwrap_err();
}

#[test]
fn light_does_not_cross_the_edge_of_a_surface() {
    // A wall that stands in the light behind a floor in the shade.
    let wall = |x: u32, y: u32| {
        let position = Vec3::new(SIZE as f32 / 2.0, y as f32, x as f32 - 80.0);
        FeaturePixel { normal: Vec3::X, position, ..floor(x, y, Vec3::ONE) }
    };
    let is_wall = |x: u32| x >= SIZE / 2;
    let light = |x: u32| Vec3::splat(if is_wall(x) { 1.0 } else { 0.1 });
    Case::new(1.0, |x, y| (light(x), if is_wall(x) { wall(x, y) } else { floor(x, y, Vec3::ONE) }))
        .check(0.05)
        .unwrap();
    // So does a step of two floors, ten voxels high.
    let step = |x: u32, y: u32| {
        let pixel = floor(x, y, Vec3::ONE);
        FeaturePixel { position: pixel.position + Vec3::Z * if is_wall(x) { 10.0 } else { 0.0 }, ..pixel }
    };
    Case::new(1.0, |x, y| (light(x), step(x, y))).check(0.05).unwrap();
    // Where no surface tells, the edge is blurred.
    Case::new(1.0, |x, y| (light(x), floor(x, y, Vec3::ONE))).check(0.05).unwrap_err();
}

#[test]
fn colors_darken_none_beside_them_that_send_back_what_they_do_not() {
    // Reds and blues of palettes, one exact and one nearly so, in light of one strength.
    for [red, blue] in [[Vec3::X, Vec3::Z], [Vec3::new(0.79, 0.013, 0.013), Vec3::new(0.013, 0.045, 0.72)]] {
        let color = |x: u32, y: u32| if (x / 2 + y / 2).is_multiple_of(2) { red } else { blue };
        let case = Case::new(0.5, |x, y| (2.0 * color(x, y), floor(x, y, color(x, y))));
        let clean = denoise(&case.film, &case.features);
        let ratio = clean.iter().sum::<Vec3>() / case.film.pixels.iter().map(Pixel::mean).sum::<Vec3>();
        assert!((ratio.x - 1.0).abs() < 0.01 && (ratio.z - 1.0).abs() < 0.01, "{ratio}");
        case.check(0.1).unwrap();
    }
}

#[test]
fn black_darkens_none_beside_it() {
    // White and black stripes of three pixels, between them one of which the first half of its samples met white and the other black: what is
    // known of its noise lets it and those around take whatever light there is beside them.
    let white = |x: u32| match x % 8 {
        0..=2 => 1.0,
        4..=6 => 0.0,
        _ => 0.5,
    };
    let mut case = Case::new(0.0, |x, y| (Vec3::splat(0.8 * white(x)), floor(x, y, Vec3::splat(0.8 * white(x)))));
    for (index, pixel) in case.film.earlier.iter_mut().flatten().enumerate() {
        if white(index as u32 % SIZE) == 0.5 {
            pixel.radiance.iter_mut().for_each(|sum| *sum *= 2);
        }
    }
    let clean = denoise(&case.film, &case.features);
    let worst = clean.iter().zip(&case.truth).map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f32::max);
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn where_surfaces_say_nothing_the_picture_stays_about_as_it_was() {
    // Every pixel is lit otherwise, as where voxels are smaller than pixels, and little of that is noise.
    let light = |x: u32, y: u32| Sampler { seed: 3, pixel: y * SIZE + x, sample: 0 }.independent(0)[0];
    let mut case = Case::new(0.2, |x, y| (Vec3::splat(light(x, y)), floor(x, y, Vec3::ONE)));
    case.check(1.4).unwrap();
    // What only looks at the pixels around takes it all for noise.
    case.film.earlier = None;
    case.check(2.0).unwrap_err();
}

#[test]
fn a_film_without_noise_stays_as_it_was() {
    let light = |x: u32, y: u32| if (x + y) < SIZE { 1.0 } else { 0.2 };
    let case = Case::new(0.0, |x, y| (checkered(x, y) * light(x, y), floor(x, y, checkered(x, y))));
    let clean = denoise(&case.film, &case.features);
    let worst = clean.iter().zip(&case.truth).map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f32::max);
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn one_rare_bright_sample_leaves_no_spot() {
    let mut case = Case::new(0.5, |x, y| (Vec3::ONE, floor(x, y, Vec3::ONE)));
    let spot = (SIZE / 2 * SIZE + SIZE / 2) as usize;
    // One sample of 200 in place of one of 1.
    let more = (199.0 * 4_294_967_296.0) as u64;
    case.film.pixels[spot].radiance.iter_mut().for_each(|sum| *sum += more);
    let clean = denoise(&case.film, &case.features);
    assert!(case.film.pixels[spot].mean().x > 12.0);
    let brightest = clean.iter().map(|radiance| radiance.x).fold(0.0, f32::max);
    assert!(brightest < 2.0, "{brightest}");
}

#[test]
fn the_sky_and_lamps_are_what_they_were() {
    let sky = Vec3::new(0.3, 0.5, 0.9);
    let lamp = |x, y| FeaturePixel { direct: Vec3::splat(9.0), ..floor(x, y, Vec3::splat(0.5)) };
    let miss = FeaturePixel { direct: sky, ..FeaturePixel::default() };
    let case = Case::new(1.0, |x, y| match y {
        0..20 => (sky, miss),
        20..30 => (Vec3::splat(9.5), lamp(x, y)),
        _ => (Vec3::splat(0.5), floor(x, y, Vec3::splat(0.5))),
    });
    let clean = denoise(&case.film, &case.features);
    assert!(clean[..20 * SIZE as usize].iter().all(|radiance| radiance.abs_diff_eq(sky, 1e-6)));
    case.check(0.1).unwrap();
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let case = Case::new(1.0, |x, y| (checkered(x, y), floor(x, y, checkered(x, y))));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| denoise(&case.film, &case.features))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn where_light_varies_no_more_than_its_noise_whatever_differs_is_noise() {
    // The same light everywhere: pixels far apart in light are far apart by chance.
    let even = Case::new(1.0, |x, y| (Vec3::ONE, floor(x, y, Vec3::ONE)));
    even.check(0.03).unwrap();
    // Guessed from the pixels around, the noise is known less, and more of it stays.
    let mut guessed = even;
    guessed.film.earlier = None;
    guessed.check(0.03).unwrap_err();
}

#[test]
fn what_chance_at_glass_leaves_in_features_goes_away() {
    // A pane before a floor: each pixel has seen another share of the sky that the pane reflects.
    let share = |x: u32, y: u32| 0.2 * Sampler { seed: 4, pixel: y * SIZE + x, sample: 0 }.independent(0)[0];
    let pane = |x: u32, y: u32, chance: [f32; 2]| {
        let share = share(x, y);
        let features =
            FeaturePixel { direct: Vec3::splat(2.0 * share), chance, ..floor(x, y, Vec3::splat(1.0 - share)) };
        (features.direct + 0.5 * features.albedo, features)
    };
    // A twelfth of the square of the width is the variance of even chance.
    let [width_of_direct, width_of_albedo] = [0.4_f32, 0.2];
    let known = [width_of_direct, width_of_albedo].map(|width| width * width / 12.0);
    for (chance, goes) in [(known, true), ([0.0; 2], false)] {
        let mut case = Case::new(0.1, |x, y| pane(x, y, chance));
        case.truth = vec![Vec3::splat(0.2 + 0.5 * 0.9); case.truth.len()];
        assert_eq!(case.check(0.35).is_ok(), goes);
    }
}

#[test]
fn the_filter_ends_soon_once_nobody_wants_the_picture() {
    let case = Case::new(1.0, |x, y| (checkered(x, y), floor(x, y, checkered(x, y))));
    let asked = AtomicU32::new(0);
    let filtered = |most: u32| {
        asked.store(0, Ordering::Relaxed);
        denoise_while(&case.film, &case.features, &|| asked.fetch_add(1, Ordering::Relaxed) < most)
    };
    assert_eq!(filtered(u32::MAX).unwrap(), denoise(&case.film, &case.features));
    // Every row of every level asks: large pictures have long rows, and the levels take the time.
    let times = asked.load(Ordering::Relaxed);
    assert!(times > 4 * SIZE, "{times}");
    for most in [0, 1, times / 2, times - 1] {
        assert!(filtered(most).is_none(), "{most} of {times}");
    }
}
