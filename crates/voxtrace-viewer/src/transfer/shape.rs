//! Another transfer function for the volume that is open: coarse voxels come first, all of them after, on threads; what was asked for last counts.

use super::{ValueCurve, ValuesSeen};
use crate::engine::Pause;
use crate::load::{Came, Loader, Loading, Reading};
use crate::session::{Command, Session};
use crate::tr;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::glam::Vec2;

/// Voxels along the longest side of what is shown first.
const COARSE: u32 = 96;
/// A drag of so many pixels makes the window twice as wide, and one of so many moves it over all values.
const DOUBLES: f32 = 160.0;
const CROSSES: f32 = 600.0;

/// The values of the volume that is open, and what of them is shown.
pub struct Values {
    /// What they are.
    pub seen: Arc<ValuesSeen>,
    /// What was chosen here; `None`: what the scene was opened with.
    pub chosen: Option<ValueCurve>,
    /// That.
    given: Option<ValueCurve>,
    /// The stop that was clicked.
    pub selected: Option<usize>,
    /// Whether dragging in the picture changes the window of the values.
    pub is_dragged: bool,
    /// Why nothing is shown of what was chosen, one line.
    pub error: Option<String>,
    /// How long the last voxels took, seconds: coarse ones, and all.
    pub took: [Option<f32>; 2],
    shaping: Option<Shaping>,
    /// What the voxels are of that are shown; `None`: of what the scene was opened with.
    shown: Option<String>,
    /// The same as a curve, to be gone back to.
    shown_curve: Option<ValueCurve>,
    /// Whether those are coarse ones, and nobody makes all of them.
    pub is_left_coarse: bool,
    /// Whether those are coarse ones.
    shows_coarse: bool,
}

/// Voxels that are being made.
struct Shaping {
    loading: Loading,
    word: String,
    curve: Option<ValueCurve>,
    is_coarse: bool,
    since: Instant,
}

impl Values {
    fn new(seen: Arc<ValuesSeen>, options: &[String]) -> Self {
        Self {
            given: seen.given(options),
            seen,
            chosen: None,
            selected: None,
            is_dragged: false,
            error: None,
            took: [None; 2],
            shaping: None,
            shown: None,
            shown_curve: None,
            is_left_coarse: false,
            shows_coarse: false,
        }
    }

    /// The curve that is chosen, else the one that the scene was opened with. `None` of labels.
    pub fn curve(&self) -> Option<ValueCurve> {
        self.chosen.clone().or_else(|| self.given.clone())
    }

    /// Whether voxels are being made.
    pub fn is_shaping(&self) -> bool {
        self.shaping.is_some()
    }
}

impl Session {
    /// Takes what is known of the values of a scene that was opened.
    pub(crate) fn take_values(&mut self, seen: Option<Arc<ValuesSeen>>, is_again: bool) {
        match (seen, &mut self.values) {
            (Some(seen), Some(values)) if is_again => {
                values.seen = seen;
                values.shown_curve = values.chosen.clone();
                (values.is_left_coarse, values.shows_coarse) = (false, false);
            }
            (seen, values) => {
                let options = &self.scene_options;
                let before = std::mem::replace(values, seen.map(|seen| Values::new(seen, options)));
                self.go_on_after(before.is_some_and(|before| before.is_shaping()));
            }
        }
    }

    /// Tracing goes on that stood still for voxels that nobody waits for any more.
    fn go_on_after(&mut self, was_shaping: bool) {
        if was_shaping {
            self.ask(Command::Pause(self.pause()));
        }
    }

    /// The transfer function that was chosen in the window, as `--transfer` has it.
    pub fn chosen_transfer(&self) -> Option<String> {
        self.values.as_ref()?.chosen.as_ref().map(ValueCurve::word)
    }

    /// Shows the volume by another curve; `None`: as it was opened.
    pub fn set_curve(&mut self, curve: Option<ValueCurve>) {
        let Some(values) = &self.values else { return };
        let curve = curve.map(|curve| curve.rounded(values.seen.range()));
        if values.chosen == curve || self.refuses_to_read_again() {
            return;
        }
        let Some(values) = &mut self.values else { return };
        if curve.is_none() {
            // What the scene was opened with is read with the options of the command line.
            let was_shaping = values.is_shaping();
            (values.chosen, values.shown, values.shaping, values.error) = (None, None, None, None);
            self.go_on_after(was_shaping);
            self.ask(Command::LoadAgain);
            return;
        }
        values.chosen = curve;
        // Where coarse voxels are under way, the last curve follows them.
        if !values.shaping.as_ref().is_some_and(|shaping| shaping.is_coarse) {
            values.shaping = None;
            // The cores are for the voxels until there are new ones.
            self.ask(Command::Pause(Pause::Everything));
            self.ask(Command::Reshape);
        }
    }

    /// Begins to make voxels of the curve that was chosen: coarse ones of a new one, else all.
    pub fn reshape(&mut self, loader: &Arc<dyn Loader>, wake: Arc<dyn Fn() + Send + Sync>) {
        let (Some(open), Some(word)) = (&self.open, self.chosen_transfer()) else { return };
        let (source, shown, is_cut) = (open.source.clone(), open.changes().1, self.render_settings.cutting.is_cut());
        let Some(values) = &mut self.values else { return };
        let is_coarse = values.shown.as_ref() != Some(&word);
        let coarse = is_coarse.then_some(COARSE);
        let reading =
            Reading { shown, is_cut, is_again: true, transfer: Some(word.clone()), coarse, ..Reading::default() };
        let loading = Loading::start(loader, &source, reading, true, wake);
        let curve = values.chosen.clone();
        values.is_left_coarse = false;
        values.shaping = Some(Shaping { loading, word, curve, is_coarse, since: Instant::now() });
    }

    /// Takes voxels that were made. The view stays. Where coarse ones were edited meanwhile, these stay.
    pub fn take_reshaped(&mut self) {
        if self.values.as_ref().is_some_and(Values::is_shaping) && self.refuses_to_read_again() {
            self.stop_shaping();
            return;
        }
        let word = self.chosen_transfer();
        let Some(values) = &mut self.values else { return };
        let Some(shaping) = &mut values.shaping else { return };
        let Came { result, .. } = shaping.loading.take();
        let Some(result) = result else { return };
        let (made, curve, is_coarse) = (shaping.word.clone(), shaping.curve.take(), shaping.is_coarse);
        let seconds = shaping.since.elapsed().as_secs_f32();
        values.shaping = None;
        values.took[usize::from(!is_coarse)] = Some(seconds);
        match result {
            Ok(scene) => {
                let is_last = word.as_ref() == Some(&made);
                (values.error, values.shown, values.shown_curve) = (None, Some(made), curve);
                values.shows_coarse = is_coarse;
                self.show_again(scene);
                if is_coarse || !is_last {
                    self.ask(Command::Reshape);
                }
            }
            Err(error) => {
                // What was shown stays. Coarse voxels may show less than all of them do.
                values.error = Some(error);
                if word.as_ref() != Some(&made) {
                    self.ask(Command::Reshape);
                } else if is_coarse {
                    values.shown = Some(made);
                    self.ask(Command::Reshape);
                } else {
                    values.is_left_coarse = values.shows_coarse;
                }
            }
        }
        self.ask(Command::Pause(self.pause()));
    }

    /// Stops making voxels. What is shown stays, and what is chosen is what it is made of; coarse voxels stay coarse. Returns whether some were being
    /// made.
    pub(crate) fn stop_shaping(&mut self) -> bool {
        let Some(values) = &mut self.values else { return false };
        if values.shaping.take().is_none() {
            return false;
        }
        values.is_left_coarse = values.shows_coarse;
        let is_as_opened = values.shown_curve.is_none();
        values.chosen.clone_from(&values.shown_curve);
        if is_as_opened {
            (values.shown, values.is_left_coarse) = (None, false);
        }
        self.ask(Command::Pause(self.pause()));
        true
    }

    /// Reading the volume again was stopped, or failed: what is chosen is what is shown.
    pub(crate) fn keep_shown_values(&mut self) {
        let Some(values) = &mut self.values else { return };
        values.chosen.clone_from(&values.shown_curve);
        values.shown = values.chosen.as_ref().map(ValueCurve::word);
    }

    /// Lets dragging change the values that are shown, or move the camera again.
    pub fn toggle_value_drag(&mut self) {
        match &mut self.values {
            Some(values) if values.curve().is_some() => {
                values.is_dragged = !values.is_dragged;
                let text = match values.is_dragged {
                    true => tr!("values.said_drag"),
                    false => tr!("values.said_camera"),
                };
                self.say(text, false);
            }
            Some(_) => self.say(tr!("values.are_labels"), false),
            None => self.say(tr!("values.no_volume"), false),
        }
    }

    /// Whether dragging changes the values that are shown.
    pub fn drags_values(&self) -> bool {
        self.values.as_ref().is_some_and(|values| values.is_dragged)
    }

    /// Lets dragging move the camera again. Returns whether it did not.
    pub(crate) fn stop_value_drag(&mut self) -> bool {
        self.values.as_mut().is_some_and(|values| std::mem::take(&mut values.is_dragged))
    }

    /// The mouse was dragged by so many pixels: to the right the window is wider, upwards its level is higher.
    pub(crate) fn drag_values(&mut self, delta: Vec2) {
        let Some(values) = &self.values else { return };
        let Some(mut curve) = values.curve() else { return };
        let range = values.seen.range();
        curve.turn((delta.x / DOUBLES).exp2(), -delta.y / CROSSES * (range.1 - range.0), range);
        self.set_curve(Some(curve));
    }
}

/// The options with which a scene is read, with another transfer function.
pub(crate) fn with_transfer(options: &[String], word: Option<String>) -> Vec<String> {
    let Some(word) = word else { return options.to_vec() };
    let mut kept = Vec::with_capacity(options.len() + 2);
    let mut options = options.iter();
    while let Some(option) = options.next() {
        let is_ours = |name: &str| option == name || option.starts_with(&format!("{name}="));
        if !["--transfer", "--threshold"].into_iter().any(is_ours) {
            kept.push(option.clone());
        } else if !option.contains('=') {
            options.next();
        }
    }
    kept.extend(["--transfer".into(), word]);
    kept
}

#[cfg(test)]
mod tests {
    use super::with_transfer;

    #[test]
    fn the_transfer_function_of_the_window_takes_the_place_of_the_one_that_was_given() {
        let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let with = |text: &str| with_transfer(&words(text), Some("stops:1=#ffffff".into())).join(" ");
        assert_eq!(with("--transfer mri --resolution 9"), "--resolution 9 --transfer stops:1=#ffffff");
        assert_eq!(with("--transfer=mri --threshold -3 --shell true"), "--shell true --transfer stops:1=#ffffff");
        assert_eq!(with_transfer(&words("--transfer mri"), None), words("--transfer mri"));
    }
}
