//! FLIP: how much of a difference people see who alternate between two pictures (Andersson, Nilsson, Akenine-Möller, Oskarsson,
//! Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020; the variant for pictures of low dynamic range).

use super::Shown;
use glam::{Mat3, Vec3};
use rayon::prelude::*;
use std::f32::consts::PI;

/// Pixels in a degree of what is seen: a screen 0.7 m wide with 3,840 pixels, seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 3840.0 * PI / 180.0;

/// Exponent of the difference of colours, and the part of its range below which it keeps [`KNEE_VALUE`] of the result (section 4.1).
const COLOR_EXPONENT: f32 = 0.7;
const KNEE: f32 = 0.4;
const KNEE_VALUE: f32 = 0.95;
/// Width of the features that people see, degrees, and the exponent of their difference (section 4.2).
const FEATURE_WIDTH: f32 = 0.082;
const FEATURE_EXPONENT: f32 = 0.5;

/// Contrast sensitivity (table 1): for each opponent channel the weights and the falls of two Gaussians.
const SENSITIVITY: [[(f32, f32); 2]; 3] =
    [[(1.0, 0.0047), (0.0, 1e-5)], [(1.0, 0.0053), (0.0, 1e-5)], [(34.1, 0.04), (13.5, 0.025)]];

/// FLIP of each pixel of two pictures of one size, in [0, 1].
pub fn flip(a: &Shown, b: &Shown, pixels_per_degree: f32) -> Vec<f32> {
    let spaces = Spaces::new();
    let opponents = [a, b].map(|picture| opponent(picture, &spaces));
    let [seen_a, seen_b] = opponents.each_ref().map(|picture| seen(picture, &spaces, pixels_per_degree));
    let [features_a, features_b] = opponents.each_ref().map(|picture| features(picture, pixels_per_degree));
    let most = spaces.hunt_lab(Vec3::Y).hyab(spaces.hunt_lab(Vec3::Z)).powf(COLOR_EXPONENT);
    let pixel = |index: usize| {
        let color = redistribute(seen_a[index].hyab(seen_b[index]).powf(COLOR_EXPONENT), most);
        let [edge, point] = [0, 1].map(|kind| (features_a[index][kind] - features_b[index][kind]).abs());
        let feature = (edge.max(point) / 2.0_f32.sqrt()).powf(FEATURE_EXPONENT);
        color.powf(1.0 - feature).clamp(0.0, 1.0)
    };
    (0..a.signal.len()).into_par_iter().map(pixel).collect()
}

/// Spreads differences of colours, of which `most` is the largest, over [0, 1] (equation 6).
fn redistribute(difference: f32, most: f32) -> f32 {
    let knee = KNEE * most;
    if difference < knee {
        return KNEE_VALUE / knee * difference;
    }
    KNEE_VALUE + (difference - knee) / (most - knee) * (1.0 - KNEE_VALUE)
}

/// CIELAB after the Hunt effect: colours of dark things differ less.
#[derive(Clone, Copy)]
struct HuntLab(Vec3);

impl HuntLab {
    /// The distance HyAB: lightness and chroma apart.
    fn hyab(self, other: Self) -> f32 {
        let difference = self.0 - other.0;
        difference.x.abs() + difference.y.hypot(difference.z)
    }
}

/// The colour spaces, white at D65.
struct Spaces {
    xyz_from_rgb: Mat3,
    rgb_from_xyz: Mat3,
    white: Vec3,
}

impl Spaces {
    fn new() -> Self {
        // Rec. 709 with the fractions of the authors' code.
        let row = |numbers: [f64; 3], below: f64| Vec3::from_array(numbers.map(|number| (number / below) as f32));
        let rows = [
            row([10_135_552.0, 8_788_810.0, 4_435_075.0], 24_577_794.0),
            row([2_613_072.0, 8_788_810.0, 887_015.0], 12_288_897.0),
            row([1_425_312.0, 8_788_810.0, 70_074_185.0], 73_733_382.0),
        ];
        let xyz_from_rgb = Mat3::from_cols(rows[0], rows[1], rows[2]).transpose();
        Self { xyz_from_rgb, rgb_from_xyz: xyz_from_rgb.inverse(), white: xyz_from_rgb * Vec3::ONE }
    }

    /// YCxCz: CIELAB without its roots, from linear RGB.
    fn opponent(&self, rgb: Vec3) -> Vec3 {
        let xyz = self.xyz_from_rgb * rgb / self.white;
        Vec3::new(116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z))
    }

    fn rgb_of_opponent(&self, opponent: Vec3) -> Vec3 {
        let y = (opponent.x + 16.0) / 116.0;
        self.rgb_from_xyz * (Vec3::new(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * self.white)
    }

    fn hunt_lab(&self, rgb: Vec3) -> HuntLab {
        const DELTA: f32 = 6.0 / 29.0;
        let root = |value: f32| match value > DELTA * DELTA * DELTA {
            true => value.cbrt(),
            false => value / (3.0 * DELTA * DELTA) + 4.0 / 29.0,
        };
        let xyz = (self.xyz_from_rgb * rgb / self.white).map(root);
        let lightness = 116.0 * xyz.y - 16.0;
        let chroma = [500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)].map(|value| value * 0.01 * lightness);
        HuntLab(Vec3::new(lightness, chroma[0], chroma[1]))
    }
}

/// Three numbers of each pixel, row by row, as planes that are filtered one by one.
struct Planes {
    width: usize,
    planes: [Vec<f32>; 3],
}

/// Linear value of an sRGB signal.
fn decode_srgb(signal: f32) -> f32 {
    if signal <= 0.04045 { signal / 12.92 } else { ((signal + 0.055) / 1.055).powf(2.4) }
}

fn opponent(picture: &Shown, spaces: &Spaces) -> Planes {
    let pixel = |signal: &Vec3| spaces.opponent(signal.clamp(Vec3::ZERO, Vec3::ONE).map(decode_srgb));
    let pixels: Vec<Vec3> = picture.signal.par_iter().map(pixel).collect();
    let plane = |channel: usize| pixels.iter().map(|pixel| pixel[channel]).collect();
    Planes { width: picture.width as usize, planes: [plane(0), plane(1), plane(2)] }
}

/// The colours that are left of a picture at the distance from which it is seen (section 4.1).
fn seen(picture: &Planes, spaces: &Spaces, pixels_per_degree: f32) -> Vec<HuntLab> {
    // Three standard deviations of the widest Gaussian.
    let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * pixels_per_degree).ceil() as i32;
    let filtered = [0, 1, 2].map(|channel| {
        let gaussians = SENSITIVITY[channel].map(|(weight, fall)| {
            let kernel: Vec<f32> =
                (-radius..=radius).map(|x| (-(PI * x as f32 / pixels_per_degree).powi(2) / fall).exp()).collect();
            let sum: f32 = kernel.iter().sum();
            (weight * (PI / fall).sqrt() * sum * sum, kernel.iter().map(|value| value / sum).collect::<Vec<f32>>())
        });
        let all: f32 = gaussians.iter().map(|(share, _)| share).sum();
        let mut sum = vec![0.0; picture.planes[channel].len()];
        for (share, kernel) in gaussians.iter().filter(|(share, _)| *share > 0.0) {
            let part = convolve(&picture.planes[channel], picture.width, kernel, kernel);
            sum.iter_mut().zip(part).for_each(|(sum, value)| *sum += share / all * value);
        }
        sum
    });
    let pixel = |index: usize| {
        let opponent = Vec3::new(filtered[0][index], filtered[1][index], filtered[2][index]);
        spaces.hunt_lab(spaces.rgb_of_opponent(opponent).clamp(Vec3::ZERO, Vec3::ONE))
    };
    (0..filtered[0].len()).into_par_iter().map(pixel).collect()
}

/// How much of an edge and of a point each pixel is (section 4.2), from its lightness before any filter.
fn features(picture: &Planes, pixels_per_degree: f32) -> Vec<[f32; 2]> {
    let deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree;
    let radius = (3.0 * deviation).ceil() as i32;
    let kernel = |factor: &dyn Fn(f32) -> f32| -> Vec<f32> {
        let at = |x: i32| factor(x as f32) * (-((x * x) as f32) / (2.0 * deviation * deviation)).exp();
        let values: Vec<f32> = (-radius..=radius).map(at).collect();
        // Weights of either sign add up to 1, so that features of one size are as large on every screen.
        let above: f32 = values.iter().filter(|value| **value > 0.0).sum();
        let below: f32 = -values.iter().filter(|value| **value < 0.0).sum::<f32>();
        values.into_iter().map(|value| if value > 0.0 { value / above } else { value / below.max(1e-30) }).collect()
    };
    let smooth = kernel(&|_| 1.0);
    let edge = kernel(&|x| -x);
    let point = kernel(&|x| x * x / (deviation * deviation) - 1.0);
    let lightness: Vec<f32> = picture.planes[0].iter().map(|y| (y + 16.0) / 116.0).collect();
    let strength = |kernel: &[f32]| -> Vec<f32> {
        let across = convolve(&lightness, picture.width, kernel, &smooth);
        let down = convolve(&lightness, picture.width, &smooth, kernel);
        across.into_iter().zip(down).map(|(x, y)| x.hypot(y)).collect()
    };
    strength(&edge).into_iter().zip(strength(&point)).map(|(edge, point)| [edge, point]).collect()
}

/// Filters a plane by a kernel along rows and one along columns, each of odd length; beyond the edge its last pixel goes on.
fn convolve(plane: &[f32], width: usize, across: &[f32], down: &[f32]) -> Vec<f32> {
    let height = plane.len() / width.max(1);
    let mut rows = vec![0.0; plane.len()];
    rows.par_chunks_mut(width).zip(plane.par_chunks(width)).for_each(|(out, row)| {
        for (x, out) in out.iter_mut().enumerate() {
            let at = |tap: usize| row[(x + tap).saturating_sub(across.len() / 2).min(width - 1)];
            *out = across.iter().enumerate().map(|(tap, weight)| weight * at(tap)).sum();
        }
    });
    let mut filtered = vec![0.0; plane.len()];
    filtered.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
        for (tap, weight) in down.iter().enumerate() {
            let from = (y + tap).saturating_sub(down.len() / 2).min(height - 1) * width;
            out.iter_mut().zip(&rows[from..from + width]).for_each(|(out, value)| *out += weight * value);
        }
    });
    filtered
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even(color: Vec3) -> Shown {
        Shown { width: 24, height: 24, signal: vec![color; 576] }
    }

    fn noise(seed: u32) -> Shown {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        };
        let signal = (0..24 * 24).map(|_| Vec3::new(next(), next(), next())).collect();
        Shown { width: 24, height: 24, signal }
    }

    /// Checks FLIP of two even colours, which have no features, against a value worked out by hand from the paper's formulas.
    fn check_even(a: Vec3, b: Vec3, expected: f32) -> Result<(), String> {
        let map = flip(&even(a), &even(b), PIXELS_PER_DEGREE);
        let worst = map.iter().map(|value| (value - expected).abs()).fold(0.0, f32::max);
        if worst > 2e-4 { Err(format!("{a} and {b}: {} instead of {expected}", map[0])) } else { Ok(()) }
    }

    #[test]
    fn even_colours_differ_as_the_paper_s_formulas_say() {
        check_even(Vec3::splat(0.4), Vec3::splat(0.4), 0.0).unwrap();
        // The two colours that define the largest difference.
        check_even(Vec3::Y, Vec3::Z, 1.0).unwrap();
        // Black and white: HyAB is 100, the largest 203.30; both to the power 0.7 are 25.119 and 41.276, the knee 16.510:
        // 0.95 + 0.05 · (25.119 − 16.510) / (41.276 − 16.510).
        check_even(Vec3::ZERO, Vec3::ONE, 0.96738).unwrap();
        // L* of the sRGB signals 0.5 and 0.55 is 53.389 and 58.346: 0.95 / 16.510 · 4.957^0.7.
        check_even(Vec3::splat(0.5), Vec3::splat(0.55), 0.17646).unwrap();
        check_even(Vec3::splat(0.5), Vec3::splat(0.56), 0.17646).unwrap_err();
    }

    /// The paper's filters as sums over two dimensions, for one pixel in the middle.
    fn two_dimensional(plane: &[f32], width: i32, radius: i32, weight: &dyn Fn(f32, f32) -> f32) -> f32 {
        let height = plane.len() as i32 / width;
        let taps: Vec<(i32, i32, f32)> = (-radius..=radius)
            .flat_map(|y| (-radius..=radius).map(move |x| (x, y)))
            .map(|(x, y)| (x, y, weight(x as f32, y as f32)))
            .collect();
        let above: f32 = taps.iter().map(|tap| tap.2.max(0.0)).sum();
        let below: f32 = taps.iter().map(|tap| -tap.2.min(0.0)).sum();
        let at = |x: i32, y: i32| {
            plane[((y + height / 2).clamp(0, height - 1) * width + (x + width / 2).clamp(0, width - 1)) as usize]
        };
        let scaled = |weight: f32| if weight > 0.0 { weight / above } else { weight / below };
        taps.iter().filter(|tap| tap.2 != 0.0).map(|&(x, y, weight)| scaled(weight) * at(x, y)).sum()
    }

    /// Compares FLIP in the middle of two noisy pictures with the same from sums over two dimensions.
    fn check_middle(pixels_per_degree: f32) -> Result<(), String> {
        let pictures = [noise(1), noise(2)];
        let spaces = Spaces::new();
        let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
        let gauss = |x: f32, y: f32| (-(x * x + y * y) / (2.0 * deviation * deviation)).exp();
        let parts = pictures.each_ref().map(|picture| {
            let planes = opponent(picture, &spaces);
            let colors = [0, 1, 2].map(|channel| {
                let weight = |x: f32, y: f32| {
                    let z = (x * x + y * y) / (PIXELS_PER_DEGREE * PIXELS_PER_DEGREE);
                    let part = |(a, b): (f32, f32)| a * (PI / b).sqrt() * (-PI * PI * z / b).exp();
                    SENSITIVITY[channel].map(part).into_iter().sum()
                };
                two_dimensional(&planes.planes[channel], 24, 10, &weight)
            });
            let light: Vec<f32> = planes.planes[0].iter().map(|y| (y + 16.0) / 116.0).collect();
            let strength = |across: &dyn Fn(f32, f32) -> f32| {
                let down = |x: f32, y: f32| across(y, x);
                two_dimensional(&light, 24, 9, across).hypot(two_dimensional(&light, 24, 9, &down))
            };
            let edge = strength(&|x, y| -x * gauss(x, y));
            let point = strength(&|x, y| (x * x / (deviation * deviation) - 1.0) * gauss(x, y));
            let color = spaces.hunt_lab(spaces.rgb_of_opponent(Vec3::from_array(colors)).clamp(Vec3::ZERO, Vec3::ONE));
            (color, edge, point)
        });
        let [(color_a, edge_a, point_a), (color_b, edge_b, point_b)] = parts;
        let most = spaces.hunt_lab(Vec3::Y).hyab(spaces.hunt_lab(Vec3::Z)).powf(0.7);
        let color = redistribute(color_a.hyab(color_b).powf(0.7), most);
        let feature = ((edge_a - edge_b).abs().max((point_a - point_b).abs()) / 2.0_f32.sqrt()).sqrt();
        let expected = color.powf(1.0 - feature);
        let found = flip(&pictures[0], &pictures[1], pixels_per_degree)[12 * 24 + 12];
        if (found - expected).abs() > 1e-3 { Err(format!("{found} instead of {expected}")) } else { Ok(()) }
    }

    #[test]
    fn filters_along_rows_and_columns_are_those_of_the_paper_in_two_dimensions() {
        check_middle(PIXELS_PER_DEGREE).unwrap();
        check_middle(0.8 * PIXELS_PER_DEGREE).unwrap_err();
    }

    #[test]
    fn noise_that_is_too_fine_to_see_counts_less_than_a_step_of_the_same_size() {
        let mut board = even(Vec3::splat(0.5));
        for (index, signal) in board.signal.iter_mut().enumerate() {
            *signal += Vec3::splat(if (index % 24 + index / 24).is_multiple_of(2) { 0.1 } else { -0.1 });
        }
        let mean = |other: &Shown| {
            let map = flip(&even(Vec3::splat(0.5)), other, PIXELS_PER_DEGREE);
            map.iter().sum::<f32>() / map.len() as f32
        };
        assert!(mean(&board) < 0.5 * mean(&even(Vec3::splat(0.6))));
    }

    #[test]
    fn the_opponent_space_is_left_as_it_was_entered() {
        let spaces = Spaces::new();
        for color in [Vec3::new(0.2, 0.5, 0.9), Vec3::ONE, Vec3::ZERO] {
            assert!((spaces.rgb_of_opponent(spaces.opponent(color)) - color).abs().max_element() < 1e-5);
        }
        assert!(spaces.hunt_lab(Vec3::ONE).0.abs_diff_eq(Vec3::new(100.0, 0.0, 0.0), 1e-2));
    }
}
