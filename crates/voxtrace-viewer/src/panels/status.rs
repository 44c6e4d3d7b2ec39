//! What the engine does, as the panels show it.

use crate::comparison::Comparison;
use crate::engine::{Contrast, Differences, Shown};
use std::collections::VecDeque;

/// Frames of the graph.
pub const FRAMES: usize = 240;

/// A device that can be chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceChoice {
    /// Its number.
    pub index: usize,
    /// How `--device` names it.
    pub value: String,
    /// Its number and name, for people.
    pub label: String,
}

/// What the engine does, for the panels.
#[derive(Default)]
pub struct Status {
    /// The last picture.
    pub shown: Option<Shown>,
    /// The last picture of the tracer that it is compared with.
    pub other: Option<Shown>,
    /// Where the two differ.
    pub differences: Option<Differences>,
    /// Milliseconds a sample of the last steps.
    pub times: VecDeque<f32>,
    /// Milliseconds of the last frames of real-time light.
    pub frames: VecDeque<f32>,
    /// Share of the step under way that is done.
    pub step_share: f32,
    /// What traces, for people.
    pub device: String,
    /// Its number.
    pub device_index: usize,
    /// The devices of this machine, once they are known.
    pub devices: Vec<DeviceChoice>,
    /// Scenes that need no file, with a line about each.
    pub built_in: Vec<(String, String)>,
    /// Files that were opened last.
    pub recent: Vec<String>,
}

/// What is drawn of two tracers, beside the first one's picture or in its place.
pub enum Compared<'a> {
    /// The second one's picture, from this share of the width on.
    Beside(&'a Shown, f32),
    /// Where they differ.
    Differences(&'a Differences),
}

impl Status {
    /// What is drawn of a comparison, `None` where nothing has come yet.
    pub fn compared(&self, comparison: &Comparison) -> Option<Compared<'_>> {
        match comparison.contrast {
            Contrast::Beside => self.other.as_ref().map(|other| Compared::Beside(other, comparison.split)),
            _ => self.differences.as_ref().map(Compared::Differences),
        }
    }

    /// Forgets all pictures: the device that they lie on is gone or left.
    pub fn forget_pictures(&mut self) {
        (self.shown, self.other, self.differences) = (None, None, None);
    }

    /// Takes a picture that is new.
    pub fn take(&mut self, shown: Shown) {
        // Times of a picture of another size would tell nothing.
        if self.shown.as_ref().is_some_and(|last| last.scale == 1 && last.picture.size() != shown.picture.size()) {
            self.times.clear();
            self.frames.clear();
        }
        match shown.step_samples {
            0 => push(&mut self.frames, shown.step_ms),
            samples if shown.scale == 1 || shown.lit.is_some() => {
                push(&mut self.times, shown.step_ms / f64::from(samples));
            }
            _ => {}
        }
        self.shown = Some(shown);
    }

    /// The time that a share of the last samples stayed below, milliseconds.
    pub fn percentile(&self, share: f64) -> Option<f32> {
        percentile(&self.times, share)
    }

    /// The time that a share of the last frames of real-time light stayed below, milliseconds.
    pub fn frame_percentile(&self, share: f64) -> Option<f32> {
        percentile(&self.frames, share)
    }
}

fn push(times: &mut VecDeque<f32>, ms: f64) {
    times.push_back(ms as f32);
    while times.len() > FRAMES {
        times.pop_front();
    }
}

fn percentile(times: &VecDeque<f32>, share: f64) -> Option<f32> {
    let mut times: Vec<f32> = times.iter().copied().collect();
    times.sort_by(f32::total_cmp);
    times.get(((times.len().checked_sub(1)?) as f64 * share).round() as usize).copied()
}
