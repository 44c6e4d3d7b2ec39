//! How near a picture is to another: PSNR of the signal that is shown, FLIP, the ratio of all light, and how much pixels change from frame to frame.

use super::Outcome;
use super::situations::Situation;
use glam::Vec3;
use std::path::Path;
use voxtrace::Frame;
use voxtrace::difference::{Difference, Shown};
use voxtrace::output::ToneMap;

/// How near a picture is to the reference.
pub struct Quality {
    psnr: f64,
    flip: f64,
    energy: f64,
    shown: Shown,
}

fn shown(picture: &[Vec3], frame: &Frame) -> Shown {
    Shown::of_radiance(frame.width, frame.height, picture, &ToneMap::default())
}

impl Quality {
    pub fn of(reference: &[Vec3], picture: &[Vec3], frame: &Frame) -> Outcome<Self> {
        let sum = |values: &[Vec3]| values.iter().map(|value| f64::from(value.element_sum())).sum::<f64>();
        let shown = shown(picture, frame);
        let difference = Difference::of(&self::shown(reference, frame), &shown)?;
        let energy = sum(picture) / sum(reference).max(1e-30);
        Ok(Self { psnr: difference.psnr(), flip: difference.mean_flip(), energy, shown })
    }

    /// What a line of the results holds.
    pub fn values(&self) -> [f64; 4] {
        [self.psnr, self.flip, self.energy, f64::NAN]
    }

    /// Writes the picture as PPM.
    pub fn write(&self, folder: &Path, name: &str) -> Outcome<()> {
        std::fs::create_dir_all(folder)?;
        let mut ppm = format!("P6 {} {} 255\n", self.shown.width, self.shown.height).into_bytes();
        let bytes = |signal: &Vec3| (*signal * 255.0).to_array().map(|value| value.round() as u8);
        ppm.extend(self.shown.signal.iter().flat_map(bytes));
        Ok(std::fs::write(folder.join(format!("{}.ppm", name.replace([' ', ','], "-"))), ppm)?)
    }
}

/// What is added up over the frames of a situation.
#[derive(Default)]
pub struct Totals {
    before: Option<Shown>,
    flicker: f64,
    frames: u32,
    psnr: f64,
    flip: f64,
    energy: f64,
    pictures: u32,
}

impl Totals {
    /// Another frame; where nothing moves, how much it differs from the one before counts.
    pub fn follow(&mut self, picture: &[Vec3], frame: &Frame, is_still: bool) {
        let now = shown(picture, frame);
        if let Some(before) = self.before.as_ref().filter(|_| is_still) {
            let step = |(a, b): (&Vec3, &Vec3)| f64::from((*a - *b).abs().element_sum()) / 3.0;
            self.flicker += now.signal.iter().zip(&before.signal).map(step).sum::<f64>() / now.signal.len() as f64;
            self.frames += 1;
        }
        self.before = Some(now);
    }

    /// Another picture that was compared.
    pub fn add(&mut self, quality: &Quality) {
        self.psnr += quality.psnr;
        self.flip += quality.flip;
        self.energy += quality.energy;
        self.pictures += 1;
    }

    /// The means, where not each frame has a line of its own; how much pictures that follow each other differ, where nothing moves.
    pub fn values(&self, situation: Situation) -> [f64; 4] {
        let mean = |sum: f64, count: u32| if count > 0 { sum / f64::from(count) } else { f64::NAN };
        let flicker = mean(self.flicker, self.frames);
        if situation.has_each_step() {
            return [f64::NAN, f64::NAN, f64::NAN, flicker];
        }
        let [psnr, flip, energy] = [self.psnr, self.flip, self.energy].map(|sum| mean(sum, self.pictures));
        [psnr, flip, energy, flicker]
    }
}
