//! A scene that comes: what is shown of it, and from where.

use super::{Command, Leaving, Open, Session};
use crate::cutting::Cutting;
use crate::load::Came;
use crate::motion::Plays;
use crate::navigation::Mode;
use crate::surroundings::Surroundings;
use crate::tr;
use std::path::Path;
use std::sync::Arc;
use voxtrace::PackedScene;

impl Session {
    /// Asks for a file to be opened. Scenes are named in text, as in commands that are copied.
    pub fn open_file(&mut self, path: &Path) {
        match path.to_str() {
            Some(text) => self.ask(Command::Load(text.to_owned())),
            None => self.say(tr!("said.path_is_no_text", path = path.display()), true),
        }
    }

    /// Takes what has come from the thread that opens a scene.
    pub fn take_loaded(&mut self) {
        let Some(loading) = &mut self.loading else { return };
        let (source, is_again) = (loading.source.clone(), loading.is_again);
        let Came { notes, result, depends_on_cuts, values, points, motion, plays } = loading.take();
        for note in notes {
            self.say(note, false);
        }
        // An animation names the scene that comes, and is to be opened with it.
        let wanted = self.wanted_timeline.as_ref().map_or_else(|| source.clone(), |path| path.display().to_string());
        match result {
            None => return,
            Some(Err(error)) => {
                self.loading = None;
                self.say(error, true);
                self.stay_as_shown(is_again);
            }
            // It was edited while its file was read.
            Some(Ok(_)) if is_again && self.refuses_to_read_again() => {
                self.loading = None;
                self.stay_as_shown(is_again);
            }
            // So was the one that is shown, or its timeline: somebody is asked before that is lost, and this one is read once more then.
            Some(Ok(_)) if !is_again && !self.may_leave(Leaving::Load(wanted)) => {
                self.loading = None;
                self.stay_as_shown(is_again);
            }
            Some(Ok(scene)) => {
                self.loading = None;
                self.take_points(points, is_again);
                self.take_motion(motion, is_again);
                if values.is_some() || !is_again {
                    self.take_values(values, is_again);
                }
                match is_again {
                    true => {
                        self.stay_in_place(&scene);
                        self.show_again(scene);
                    }
                    false => self.show(source, scene),
                }
                self.begin_motion(plays);
                if let Some(open) = &mut self.open {
                    open.plays = if plays == Plays::Nothing { open.plays } else { plays };
                    open.depends_on_cuts = depends_on_cuts || (is_again && open.depends_on_cuts);
                }
            }
        }
        self.play_what_was_read();
    }

    /// No other scene comes in the place of the one that is shown, nor, where it `is_again`, the same one read in another way.
    pub(crate) fn stay_as_shown(&mut self, is_again: bool) {
        if is_again {
            self.keep_shown_choices();
            if let Some(open) = &mut self.open {
                open.hide_unread();
            }
        } else {
            // What was to be lost with it is still there, and is asked for again.
            (self.wanted_timeline, self.is_discarding, self.timeline.is_given_up) = (None, false, false);
        }
    }

    /// Shows a scene from its first camera, or from where everything is seen, in its own light.
    pub fn show(&mut self, source: String, scene: Arc<PackedScene>) {
        self.dismiss_errors();
        let aspect = self.size.0 as f32 / self.size.1 as f32;
        let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.portrait(aspect));
        let bounds = scene.bounds();
        // In a room one looks around; around an object one goes.
        let is_inside = bounds.is_some_and(|(min, max)| camera.eye.cmpge(min).all() && camera.eye.cmple(max).all());
        self.navigator = self.navigator.in_scene(camera, bounds);
        self.navigator.mode = if is_inside { Mode::Fly } else { Mode::Orbit };
        (self.dialog, self.panorama) = (None, None);
        self.render_settings = self.render_settings.clone().without_light();
        self.render_settings.cutting = self.given_cutting.clone();
        self.render_settings.surroundings = Surroundings::default();
        let mut open = Open::new(source, scene);
        if self.given_cutting != Cutting::default() {
            match self.given_cutting.cuts(&open.original.cuts) {
                Ok(cuts) => {
                    open.set_light(&self.render_settings, None);
                    if bounds.is_some_and(|bounds| cuts.cut_away(bounds)) {
                        self.say(tr!("said.nothing_is_left_of_the_scene"), false);
                    }
                }
                Err(error) => {
                    self.render_settings.cutting = Cutting::default();
                    self.say(error.to_string(), true);
                }
            }
        }
        self.open = Some(open);
        (self.picked, self.editing, self.is_discarding) = (None, None, false);
        self.take_recovered();
        self.sight.forget();
        self.has_eye_height = false;
        self.outliner = crate::outliner::Outliner::default();
        self.sampling = crate::inspector::Sampling::default();
        self.load_measures();
        let timeline = self.wanted_timeline.take();
        self.renew_timeline(timeline);
        self.keep_apart_for_lines(false);
        self.ask(Command::SetScene);
        self.ask(Command::SetView);
    }
}
