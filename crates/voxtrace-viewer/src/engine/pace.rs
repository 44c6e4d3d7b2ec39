//! How much a window traces between two of its pictures: at a fraction of the resolution while the view moves and the device is
//! slow, then finer and finer while it is still, and at full resolution as many samples as fit; and how fine frames of real-time light are.

mod quality;

pub use quality::{Quality, QualityPace};

/// The coarsest picture has a pixel for this many along each side.
const COARSEST: u32 = 8;
/// Samples that take about as long as a pixel of real-time light.
const SAMPLES_OF_LIGHT: f64 = 2.5;
/// How much of a new measurement counts.
const WEIGHT: f64 = 0.5;

/// What to trace next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Pixels of the window along each side of a traced pixel: 1, 2, 4 or 8.
    pub scale: u32,
    /// Samples a pixel to add.
    pub samples: u32,
}

/// Chooses the steps of one view after the other.
#[derive(Clone, Debug)]
pub struct Pace {
    /// Milliseconds that a picture may take.
    budget_ms: f64,
    /// Samples that were traced in a millisecond; `None` before the first.
    rate: Option<f64>,
    /// The scale whose picture is shown; `None` where the view changed since.
    shown: Option<u32>,
    /// How fine frames of real-time light are.
    pub quality: QualityPace,
}

impl Pace {
    /// A pace of pictures that take `budget_ms` each.
    pub fn new(budget_ms: f64) -> Self {
        Self { budget_ms, rate: None, shown: None, quality: QualityPace::new(quality::frame_ms().unwrap_or(budget_ms)) }
    }

    /// The view changed: what is shown is of no use.
    pub fn begin(&mut self) {
        self.shown = None;
    }

    /// Whether it is known how quick the device is.
    pub fn is_measured(&self) -> bool {
        self.rate.is_some()
    }

    /// About what a frame of real-time light of so many pixels takes, milliseconds.
    pub fn guess(&self, pixels: u64) -> f64 {
        pixels as f64 * SAMPLES_OF_LIGHT / self.rate.unwrap_or(f64::INFINITY)
    }

    /// A frame of real-time light is shown: what is traced next is the film.
    pub fn lit(&mut self) {
        self.shown = Some(1);
    }

    /// Whether the next step makes the first picture of its view.
    pub fn is_first(&self) -> bool {
        self.shown.is_none()
    }

    /// Whether a coarse picture of the view is shown.
    pub fn is_coarse(&self) -> bool {
        self.shown.is_some_and(|scale| scale > 1)
    }

    /// How fine the picture is that is shown, 0 where there is none.
    pub fn fineness(&self) -> u32 {
        self.shown.map_or(0, |scale| 2 * COARSEST / scale)
    }

    /// The next step of a view of `pixels` pixels that lacks `missing` samples, at least one: finer than what is shown.
    pub fn next(&self, pixels: u64, missing: u32) -> Step {
        let rate = self.rate.unwrap_or(0.0);
        let fitting = |scale: u32| rate * self.budget_ms / (pixels as f64 / f64::from(scale * scale)).max(1.0);
        let scale = match self.shown {
            // The finest that fits, so that the first picture of a view comes in time.
            None => [1, 2, 4].into_iter().find(|&scale| fitting(scale) >= 1.0).unwrap_or(COARSEST),
            Some(shown) => (shown / 2).max(1),
        };
        let samples = if scale == 1 { (fitting(1) as u32).clamp(1, missing.max(1)) } else { 1 };
        Step { scale, samples }
    }

    /// Takes into account that a step of `pixels` window pixels took `ms`, and that its picture is shown.
    pub fn update(&mut self, step: Step, pixels: u64, ms: f64) {
        let traced = pixels as f64 / f64::from(step.scale * step.scale) * f64::from(step.samples);
        let rate = traced / ms.max(1e-3);
        self.rate = Some(self.rate.map_or(rate, |old| old + WEIGHT * (rate - old)));
        self.shown = Some(step.scale);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIXELS: u64 = 1_000_000;

    /// The steps of a still view on a device that traces so many samples in a millisecond.
    fn steps(pace: &mut Pace, rate: f64, count: usize) -> Vec<Step> {
        let mut step = || {
            let step = pace.next(PIXELS, 1000);
            let traced = PIXELS as f64 / f64::from(step.scale * step.scale) * f64::from(step.samples);
            pace.update(step, PIXELS, traced / rate);
            step
        };
        (0..count).map(|_| step()).collect()
    }

    #[test]
    fn a_slow_device_begins_coarse_and_refines() {
        let mut pace = Pace::new(100.0);
        let scales: Vec<u32> = steps(&mut pace, 250.0, 5).iter().map(|step| step.scale).collect();
        assert_eq!(scales, [8, 4, 2, 1, 1]);
        // What it learned holds for the next view.
        pace.begin();
        assert_eq!(pace.next(PIXELS, 1000), Step { scale: 8, samples: 1 });
    }

    #[test]
    fn a_fast_device_traces_several_samples_at_full_resolution() {
        let mut pace = Pace::new(10.0);
        steps(&mut pace, 500_000.0, 8);
        pace.begin();
        assert_eq!(pace.next(PIXELS, 1000), Step { scale: 1, samples: 5 });
        assert_eq!(pace.next(PIXELS, 3).samples, 3);
    }
}
