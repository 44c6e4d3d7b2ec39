//! Monte Carlo estimates with their standard errors: a picture is rendered with several seeds, and the variance of the results
//! tells how far their mean may be from the true value.

use std::sync::Arc;
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, Region, Scene, Tracer};

/// Number of seeds of one estimate.
const RUNS: u32 = 24;
/// Tolerance in standard errors: exceeded by chance in less than one of 10⁴ comparisons.
const CONFIDENCE: f64 = 4.5;

/// A mean with its standard error.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// Mean over the runs.
    pub mean: f64,
    /// Standard error of the mean.
    pub standard_error: f64,
}

/// Renders one film.
pub fn render(scene: &Arc<PackedScene>, frame: &Frame) -> Film {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene).unwrap();
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = Film::new(0, 0, Region::full(0, 0), 0);
    tracer.read(&mut film).unwrap();
    film
}

/// Estimates the radiance of `blocks` × `blocks` parts of a picture: red, green and blue of each part in turn.
pub fn radiance(scene: &Scene, frame: &Frame, blocks: u32) -> Vec<Estimate> {
    radiance_of(&Arc::new(PackedScene::pack(scene).unwrap()), frame, blocks)
}

/// As [`radiance`], of a packed scene.
pub fn radiance_of(scene: &Arc<PackedScene>, frame: &Frame, blocks: u32) -> Vec<Estimate> {
    let count = 3 * (blocks * blocks) as usize;
    let (mut sums, mut squares) = (vec![0.0; count], vec![0.0; count]);
    for run in 0..RUNS {
        let film = render(scene, &frame.clone().seed(frame.seed + 1000 * run));
        for (index, value) in block_means(&film, blocks).into_iter().enumerate() {
            sums[index] += value;
            squares[index] += value * value;
        }
    }
    let runs = f64::from(RUNS);
    let estimate = |(sum, square): (f64, f64)| {
        let mean = sum / runs;
        let variance = (square / runs - mean * mean).max(0.0) * runs / (runs - 1.0);
        Estimate { mean, standard_error: (variance / runs).sqrt() }
    };
    sums.into_iter().zip(squares).map(estimate).collect()
}

fn block_means(film: &Film, blocks: u32) -> Vec<f64> {
    let mut means = vec![(0.0, 0.0); 3 * (blocks * blocks) as usize];
    for (index, pixel) in film.pixels.iter().enumerate() {
        let (x, y) = (index as u32 % film.width, index as u32 / film.width);
        let block = y * blocks / film.height * blocks + x * blocks / film.width;
        for (channel, value) in pixel.mean().to_array().into_iter().enumerate() {
            let (sum, count) = &mut means[3 * block as usize + channel];
            *sum += f64::from(value);
            *count += 1.0;
        }
    }
    means.into_iter().map(|(sum, count)| sum / count).collect()
}

/// Checks that every estimate agrees with `expected` and has a standard error of at most one per cent of it.
///
/// # Errors
/// A message that names the first one that does not.
pub fn check_equal(estimates: &[Estimate], expected: f64) -> Result<(), String> {
    let exact = Estimate { mean: expected, standard_error: 0.0 };
    check_same(estimates, &vec![exact; estimates.len()], 0.01)
}

/// Checks that estimates agree pair by pair, and that the standard error of each difference is at most `precision` of their mean.
///
/// # Errors
/// A message that names the first pair that does not.
pub fn check_same(ours: &[Estimate], theirs: &[Estimate], precision: f64) -> Result<(), String> {
    assert_eq!(ours.len(), theirs.len());
    for (index, (a, b)) in ours.iter().zip(theirs).enumerate() {
        let error = a.standard_error.hypot(b.standard_error);
        let scale = 0.5 * (a.mean + b.mean);
        if CONFIDENCE * error > precision * scale {
            return Err(format!("estimate {index} is too noisy: {a:?}, {b:?}"));
        }
        // Sums of f32 products have a relative error of about 1e-6.
        if (a.mean - b.mean).abs() > CONFIDENCE * error + 2e-6 * scale {
            return Err(format!("estimate {index} differs: {a:?}, {b:?}"));
        }
    }
    Ok(())
}
