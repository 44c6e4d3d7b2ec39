//! One level of the wavelet transform: a blur whose weights stop at edges, and which of the details that it took away are more
//! than noise.

use super::surfaces::Surfaces;
use glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;

/// How far the kernel reaches on either side, in steps.
const REACH: isize = 2;
/// The cubic B-spline, from the middle outwards.
const SPLINE: [f32; 3] = [3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];
/// Variance below which noise is not looked for, relative to the square of the light, so that exact light divides by no zero.
const LEAST_VARIANCE: f32 = 1e-6;
/// How many times its noise the energy of a detail must be before any of it is kept.
const THRESHOLD: f32 = 1.6;
/// Pixels on either side over which the energy of details is averaged.
const NEIGHBOURHOOD: usize = 2;

/// Luminance of linear Rec. 709.
pub fn luminance(color: Vec3) -> f32 {
    0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z
}

/// Light of each pixel and the variance of its luminance.
pub struct Light {
    pub width: usize,
    pub channels: [Vec<f32>; 3],
    pub variance: Vec<f32>,
}

impl Light {
    pub fn new(light: &[Vec3], variance: Vec<f32>, width: usize) -> Self {
        let channel = |channel: usize| light.par_iter().map(|light| light[channel]).collect();
        Self { width, channels: [channel(0), channel(1), channel(2)], variance }
    }
}

/// A coarser level of the light.
pub struct Coarse {
    pub light: Light,
    /// The share that each pixel of the finer level has in its own coarser value.
    pub own_share: Vec<f32>,
}

/// One place of the kernel, for a row of pixels.
pub struct Tap {
    /// The columns of the row that have a pixel there.
    pub columns: Range<usize>,
    /// How many pixels further on it is.
    pub offset: isize,
    /// The kernel's weight.
    pub weight: f32,
    /// Whether it is the pixel itself.
    pub is_centre: bool,
}

/// The places of the kernel that row `y` of a picture has, `step` pixels apart.
pub fn taps(y: usize, width: usize, height: usize, step: usize) -> impl Iterator<Item = Tap> {
    let reach = -REACH..=REACH;
    reach.clone().flat_map(move |dy| reach.clone().map(move |dx| (dx, dy))).filter_map(move |(dx, dy)| {
        let row = y.checked_add_signed(dy * step as isize).filter(|&row| row < height)?;
        let shift = dx * step as isize;
        let columns = shift.min(0).unsigned_abs()..width.saturating_sub(shift.max(0) as usize);
        let offset = (row as isize - y as isize) * width as isize + shift;
        let weight = SPLINE[dx.unsigned_abs()] * SPLINE[dy.unsigned_abs()];
        (!columns.is_empty()).then_some(Tap { columns, offset, weight, is_centre: dx == 0 && dy == 0 })
    })
}

/// What a row of pixels gathers.
struct Row {
    sums: [Vec<f32>; 3],
    variance: Vec<f32>,
    weights: Vec<f32>,
    centre: Vec<f32>,
}

/// The next coarser level, from pixels `step` apart. `tolerance` has the square standard deviations by which the light of each may differ
/// from another's before they are no longer alike.
pub fn smooth(light: &Light, surfaces: &Surfaces, tolerance: &[f32], step: usize) -> Coarse {
    let width = light.width;
    let height = light.variance.len() / width;
    let rows: Vec<Row> = (0..height).into_par_iter().map(|y| smooth_row(light, surfaces, tolerance, y, step)).collect();
    let mut channels = [0, 1, 2].map(|_| Vec::with_capacity(light.variance.len()));
    let (mut variance, mut own_share) = (Vec::with_capacity(width * height), Vec::with_capacity(width * height));
    for row in rows {
        channels.iter_mut().zip(row.sums).for_each(|(channel, sums)| channel.extend(sums));
        variance.extend(row.variance);
        own_share.extend(row.centre);
    }
    Coarse { light: Light { width, channels, variance }, own_share }
}

fn smooth_row(light: &Light, surfaces: &Surfaces, tolerance: &[f32], y: usize, step: usize) -> Row {
    let width = light.width;
    let height = light.variance.len() / width;
    let zero = || vec![0.0_f32; width];
    let mut row = Row { sums: [zero(), zero(), zero()], variance: zero(), weights: zero(), centre: zero() };
    if !(surfaces.wanted)() {
        return row;
    }
    let mut alike = zero();
    let own: [&[f32]; 3] = light.channels.each_ref().map(|channel| &channel[y * width..][..width]);
    let brightness = |r: f32, g: f32, b: f32| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let luminance: Vec<f32> = (0..width).map(|x| brightness(own[0][x], own[1][x], own[2][x])).collect();
    // One over the square difference of light at which pixels are no longer alike.
    let scale: Vec<f32> = (0..width)
        .map(|x| {
            let variance = light.variance[y * width + x] + LEAST_VARIANCE * luminance[x] * luminance[x] + 1e-12;
            1.0 / (tolerance[y * width + x] * variance)
        })
        .collect();
    for tap in taps(y, width, height, step) {
        let count = tap.columns.len();
        let alike = &mut alike[..count];
        let from = y * width + tap.columns.start;
        surfaces.alike(from, tap.offset, alike);
        let to = from.wrapping_add_signed(tap.offset);
        let [r, g, b] = light.channels.each_ref().map(|channel| &channel[to..to + count]);
        let variance = &light.variance[to..to + count];
        let (luminance, scale) = (&luminance[tap.columns.clone()], &scale[tap.columns.clone()]);
        let [sum_r, sum_g, sum_b] = row.sums.each_mut().map(|sums| &mut sums[tap.columns.clone()]);
        let sum_variance = &mut row.variance[tap.columns.clone()];
        let sum_weight = &mut row.weights[tap.columns.clone()];
        let centre = &mut row.centre[tap.columns.clone()];
        for i in 0..count {
            let difference = brightness(r[i], g[i], b[i]) - luminance[i];
            let lights = (1.0 - difference * difference * scale[i]).max(0.0);
            let weight = tap.weight * if tap.is_centre { 1.0 } else { alike[i] * lights * lights };
            sum_r[i] += weight * r[i];
            sum_g[i] += weight * g[i];
            sum_b[i] += weight * b[i];
            sum_variance[i] += weight * weight * variance[i];
            sum_weight[i] += weight;
            if tap.is_centre {
                centre[i] = weight;
            }
        }
    }
    for x in 0..width {
        let scale = 1.0 / row.weights[x];
        row.sums.iter_mut().for_each(|sums| sums[x] *= scale);
        row.variance[x] *= scale * scale;
        row.centre[x] *= scale;
    }
    row
}

/// Adds to `kept` the part of what `coarse` lacks of `fine` that is more than noise.
pub fn detail_to_keep(fine: &Light, coarse: &Coarse, kept: &mut [Vec<f32>; 3]) {
    let width = fine.width;
    let detail = |index: usize| {
        [0, 1, 2].map(|channel: usize| fine.channels[channel][index] - coarse.light.channels[channel][index])
    };
    let count = fine.variance.len();
    let energy: Vec<f32> = (0..count)
        .into_par_iter()
        .map(|index| {
            let detail = luminance(Vec3::from_array(detail(index)));
            detail * detail
        })
        .collect();
    // The detail is (1 − own) · fine minus the others' shares, whose noises are independent.
    let noise: Vec<f32> = (0..count)
        .into_par_iter()
        .map(|index| {
            let own = fine.variance[index] * (1.0 - 2.0 * coarse.own_share[index]);
            (own + coarse.light.variance[index]).max(0.0)
        })
        .collect();
    let (energy, noise) = (box_mean(&energy, width, NEIGHBOURHOOD), box_mean(&noise, width, NEIGHBOURHOOD));
    let [r, g, b] = kept;
    let rows = r.par_iter_mut().zip(g.par_iter_mut()).zip(b.par_iter_mut()).enumerate();
    rows.for_each(|(index, ((r, g), b))| {
        let share = (1.0 - THRESHOLD * noise[index] / energy[index].max(1e-30)).max(0.0);
        let detail = detail(index);
        *r += share * detail[0];
        *g += share * detail[1];
        *b += share * detail[2];
    });
}

/// The mean of a square of pixels around each, `reach` on either side, smaller at the picture's edge.
pub fn box_mean(values: &[f32], width: usize, reach: usize) -> Vec<f32> {
    let height = values.len() / width;
    let mut across = vec![0.0; values.len()];
    across.par_chunks_mut(width).zip(values.par_chunks(width)).for_each(|(out, row)| {
        for (x, out) in out.iter_mut().enumerate() {
            let part = &row[x.saturating_sub(reach)..(x + reach + 1).min(width)];
            *out = part.iter().sum::<f32>() / part.len() as f32;
        }
    });
    let mut out = vec![0.0; values.len()];
    out.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
        let rows = y.saturating_sub(reach)..(y + reach + 1).min(height);
        let scale = 1.0 / rows.len() as f32;
        for row in rows {
            out.iter_mut().zip(&across[row * width..][..width]).for_each(|(out, value)| *out += scale * value);
        }
    });
    out
}
