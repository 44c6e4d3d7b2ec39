//! Functions of numbers alone: sampler, mathematics, film.

use super::{Group, empty, numbers, vector, words};
use voxtrace::film::Pixel;
use voxtrace::glam::Vec3;
use voxtrace_core::math::{cosine_hemisphere, cosine_hemisphere_pdf, luminance, normalize, sincos_turns};
use voxtrace_core::sampler::Sampler;
use voxtrace_tests::random::Random;

#[test]
fn the_sampler_gives_the_same_numbers() {
    let mut random = Random(1);
    let mut inputs: Vec<u32> = (0..4 * 4096).map(|_| random.bits() as u32).collect();
    // Small numbers, as in pictures.
    inputs.extend((0..4 * 4096).map(|_| random.below(300) as u32));
    let draw = |case: &[u32], dimension| {
        let sampler = Sampler { seed: case[0], pixel: case[1], sample: case[2] };
        words(sampler.independent(dimension).into_iter().chain(sampler.stratified(dimension))).collect::<Vec<u32>>()
    };
    let group = Group { entry: "check_sampler", scene: &empty(), words: (4, 8), inputs };
    group.check(
        |case| draw(case, case[3]),
        |case| {
            let mut drawn = draw(case, case[3]);
            // The two pairs of a dimension the wrong way round.
            drawn.swap(4, 6);
            drawn
        },
    );
}

#[test]
fn the_mathematics_gives_the_same_numbers() {
    let mut random = Random(2);
    let mut inputs: Vec<u32> = words((0..2 * 16_384).map(|_| random.unit())).collect();
    let special = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0 - f32::EPSILON / 2.0, 1e-10];
    inputs.extend(words(special.iter().flat_map(|&u| special.iter().flat_map(move |&v| [u, v]))));
    let compute = |case: &[u32], (sin, cos): (f32, f32)| {
        let [u, v] = numbers(case)[..] else { unreachable!("two words a case") };
        let direction = cosine_hemisphere(u, v);
        let other = normalize(Vec3::new(u, v, 2.0) - direction);
        let pdf = cosine_hemisphere_pdf(direction.z);
        let all = [&[sin, cos][..], &direction.to_array(), &[pdf], &other.to_array(), &[luminance(direction)]];
        words(all.concat()).collect::<Vec<u32>>()
    };
    let group = Group { entry: "check_math", scene: &empty(), words: (2, 10), inputs };
    group.check(
        |case| compute(case, sincos_turns(f32::from_bits(case[0]))),
        |case| compute(case, (f32::from_bits(case[0]) * std::f32::consts::TAU).sin_cos()),
    );
}

#[test]
fn quotients_and_square_roots_are_rounded_to_the_nearest() {
    let mut random = Random(4);
    let mut inputs = Vec::new();
    // Mantissas where rounding is hard: few bits, and all but few.
    let hard = [0, 1, 2, 3, 0x3f_ffff, 0x40_0000, 0x40_0001, 0x7f_fffc, 0x7f_fffd, 0x7f_fffe, 0x7f_ffff];
    for case in 0..65_536 {
        let mut mantissa =
            || if random.below(3) == 0 { hard[random.below(hard.len())] } else { random.bits() as u32 & 0x7f_ffff };
        let (a, b) = (mantissa(), mantissa());
        // Neither they nor their quotient are subnormal, which devices may take for zero.
        let mut number =
            |mantissa: u32| (random.below(2) as u32) << 31 | (random.below(120) as u32 + 67) << 23 | mantissa;
        inputs.extend([number(a), number(b)]);
        if case % 64 == 0 {
            let end = inputs.len();
            inputs[end - 2] = if case % 128 == 0 { 0.0f32 } else { -0.0 }.to_bits();
        }
        let (a, b) = (a | 0x80_0000, b | 0x80_0000);
        let a = if a < b { a << 1 } else { a };
        let mut wrong = |exact: f64| (exact as i32 + random.below(41) as i32 - 20) as u32;
        let (quotient, root) = (f64::from(a) / f64::from(b) * 8_388_608.0, (f64::from(a) * 8_388_608.0).sqrt());
        inputs.extend([a, b, wrong(quotient), wrong(root)]);
    }
    let compute = |case: &[u32], add: f64| {
        let (a, b) = (f32::from_bits(case[0]), f32::from_bits(case[1]));
        // Doubles hold enough bits to round in two steps.
        let quotient = (f64::from(case[2]) / f64::from(case[3]) * 8_388_608.0 + add).floor();
        let root = ((f64::from(case[2]) * 8_388_608.0).sqrt() + add).floor();
        vec![(a / b).to_bits(), a.abs().sqrt().to_bits(), quotient as u32, root as u32]
    };
    let group = Group { entry: "check_rounding", scene: &empty(), words: (6, 4), inputs };
    group.check(|case| compute(case, 0.5), |case| compute(case, 0.0));
}

#[test]
fn the_film_adds_the_same_sums() {
    let mut random = Random(3);
    let mut inputs = Vec::new();
    let special =
        [0.0, -0.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MIN_POSITIVE, 1e-45, 1e7, 1_048_576.0];
    for case in 0..16_384 {
        for _channel in 0..3 {
            // Sums that are nearly full, half full, and small.
            let sum = random.bits() >> [0, 1, 20, 34, 63][random.below(5)] | if case % 3 == 0 { !0 << 52 } else { 0 };
            inputs.extend([sum as u32, (sum >> 32) as u32]);
        }
        inputs.extend([random.below(1000) as u32, random.below(1000) as u32]);
        for _channel in 0..3 {
            let value = match random.below(4) {
                0 => special[random.below(special.len())],
                // From below the smallest unit to above the largest radiance.
                _ => random.unit() * 2f32.powi(random.below(60) as i32 - 38),
            };
            inputs.push(value.to_bits());
        }
        inputs.push(random.below(2) as u32);
    }
    let pixel = |case: &[u32]| Pixel {
        radiance: [0, 2, 4].map(|at| u64::from(case[at]) | u64::from(case[at + 1]) << 32),
        samples: case[6],
        covered: case[7],
    };
    let words_of = |pixel: Pixel| {
        let sums = pixel.radiance.iter().flat_map(|&sum| [sum as u32, (sum >> 32) as u32]);
        sums.chain([pixel.samples, pixel.covered]).collect::<Vec<u32>>()
    };
    let add = |case: &[u32]| {
        let mut pixel = pixel(case);
        pixel.add(vector(&case[8..]), case[11] != 0);
        words_of(pixel)
    };
    let group = Group { entry: "check_film", scene: &empty(), words: (12, 8), inputs };
    group.check(add, |case| {
        // Sums that start again from zero.
        let (mut before, mut addend) = (pixel(case), Pixel::default());
        addend.add(vector(&case[8..]), case[11] != 0);
        for (sum, addend) in before.radiance.iter_mut().zip(addend.radiance) {
            *sum = sum.wrapping_add(addend);
        }
        words_of(Pixel { samples: before.samples + 1, covered: before.covered + addend.covered, ..before })
    });
}
