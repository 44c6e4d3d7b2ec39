//! What the window does with its timeline: keys are set, the playhead moves the view, and the file is kept and read.

use super::file::{Cameras, EASES};
use super::{Course, Timeline, TimelineError};
use crate::motion::Plays;
use crate::session::Session;
use crate::tr;
use std::path::{Path, PathBuf};
use toml::Value;
use voxtrace::animation::Ease;
use voxtrace::glam::DAffine3;
use voxtrace::{Camera, scenes};

impl Timeline {
    /// The ways in which the camera speeds up and slows down, with their words in the file.
    pub const EASES: [(&'static str, Ease); 4] = EASES;
}

impl Session {
    /// Shows the timeline or hides it.
    pub fn toggle_timeline(&mut self) {
        if self.open.is_none() {
            self.say(tr!("said.there_is_no_scene_yet"), false);
            return;
        }
        self.timeline.is_shown = !self.timeline.is_shown;
        self.timeline.playing = None;
        if self.timeline.is_shown {
            self.ask_for_motion();
        }
    }

    /// Plays from the playhead on, from the beginning where that is at the end, or stops.
    pub fn toggle_play(&mut self) {
        if self.timeline.playing.take().is_some() {
            return;
        }
        self.timeline.is_shown |= self.open.is_some();
        if !self.has_motion() && self.timeline.course.track().is_none() {
            if !self.has_something_to_play() {
                return self.say(tr!("timeline.two_keys"), false);
            }
            // What moves is read first; it plays as soon as that is there.
            if !self.ask_for_motion() {
                return;
            }
        }
        let frame = self.timeline.frame();
        let frame = if frame >= self.timeline.course.frames() { 1 } else { frame };
        self.set_time_frame(frame);
        self.timeline.playing = Some(self.timeline.course.time_of(frame));
    }

    /// Whether what the file brings along is all that can move here, and is not read.
    fn lacks_motion(&self) -> bool {
        self.has_something_to_play() && !self.has_motion() && self.timeline.course.track().is_none()
    }

    /// A reading is over, or was stopped: what waited for it plays, or does not where it brought nothing that moves.
    pub(crate) fn play_what_was_read(&mut self) {
        if self.lacks_motion() {
            self.timeline.playing = None;
        } else if self.timeline.is_playing() {
            self.keep_moving();
        }
    }

    /// Lets time go by while the timeline plays.
    pub(crate) fn advance_timeline(&mut self, seconds: f32) {
        let Some(time) = self.timeline.playing else { return };
        if self.lacks_motion() {
            return;
        }
        let course = &self.timeline.course;
        let (frames, length) = (course.frames(), course.time_of(course.frames() + 1));
        let mut time = time + f64::from(seconds.max(0.0));
        if time >= length && self.timeline.repeats {
            time %= length;
        }
        let frame = ((time * course.fps).floor() + 1.0).min(f64::from(frames)) as u32;
        self.timeline.playing = (time < length).then_some(time);
        if frame == self.timeline.frame() {
            // The camera does not rest between two frames.
            self.keep_moving();
        } else {
            self.follow_time(frame);
        }
    }

    /// Puts the playhead on a frame, counted from 1: the view is that of the frame, where there are two keys or more. Playing ends.
    pub fn set_time_frame(&mut self, frame: u32) {
        let was_playing = self.timeline.playing.take().is_some();
        if !was_playing && self.timeline.frame() != frame {
            // One step back leads to where the camera was.
            self.navigator.begin_gesture();
            self.follow_time(frame);
            self.navigator.end_gesture();
            return;
        }
        self.follow_time(frame);
    }

    /// Shows what a camera sees, without a step of its own to go back to.
    fn show_camera(&mut self, camera: Camera) {
        if self.navigator.follow(camera) {
            self.moved();
        }
    }

    /// Shows a frame.
    fn follow_time(&mut self, frame: u32) {
        self.timeline.frame = frame.clamp(1, self.timeline.course.frames());
        if let Some(camera) = self.timeline.course.camera_of(self.timeline.frame) {
            self.show_camera(camera);
        }
        if self.has_motion() {
            self.change_light();
            self.keep_moving();
        }
    }

    /// Sets a key with the present camera at the playhead.
    pub fn add_time_key(&mut self) {
        if self.open.is_none() {
            return;
        }
        self.timeline.is_shown = true;
        self.timeline.playing = None;
        let (at, camera) = (self.timeline.course.time_of(self.timeline.frame()), self.navigator.camera().clone());
        let before = self.timeline.course.clone();
        self.timeline.selected = Some(self.timeline.course.put(at, camera));
        self.timeline.note(before);
        let number = self.timeline.selected.unwrap_or(0) + 1;
        self.say(tr!("timeline.said_key", at = format!("{at:.2}"), number = number), false);
    }

    /// Whether a key is selected and the cursor is not over the picture: then Del is for the key.
    pub(crate) fn is_on_timeline(&self) -> bool {
        self.timeline.is_shown && self.timeline.selected.is_some() && self.hover.is_none() && self.picked.is_none()
    }

    /// Gives the selected key the present camera.
    pub fn replace_time_key(&mut self) {
        let camera = self.navigator.camera().clone();
        let Some(index) = self.timeline.selected.filter(|&index| index < self.timeline.course.keys.len()) else {
            return;
        };
        self.timeline.edit(|course| course.keys[index].camera = camera);
    }

    /// Deletes the selected key.
    pub fn delete_time_key(&mut self) {
        let Some(index) = self.timeline.selected.take().filter(|&index| index < self.timeline.course.keys.len()) else {
            return;
        };
        self.timeline.edit(|course| _ = course.keys.remove(index));
    }

    /// Selects a key and goes to it.
    pub fn go_to_time_key(&mut self, index: usize) {
        let Some(at) = self.timeline.course.keys.get(index).map(|key| key.at) else { return };
        self.timeline.selected = Some(index);
        self.set_time_frame(self.timeline.course.frame_at(at));
    }

    /// Spreads the bookmarks over the clip, in place of all keys.
    pub fn take_bookmarks(&mut self) {
        let cameras: Vec<Camera> = match self.bookmarks() {
            Some(Ok(bookmarks)) => bookmarks.iter().map(|(_, camera)| camera.clone()).collect(),
            Some(Err(error)) => return self.say(error.to_string(), true),
            None => Vec::new(),
        };
        if cameras.len() < 2 {
            return self.say(tr!("timeline.two_bookmarks"), false);
        }
        self.timeline.selected = None;
        self.timeline.edit(|course| course.spread(cameras));
        self.set_time_frame(1);
    }

    /// Looks at what was picked from wherever the camera is, or no more.
    pub fn set_time_target(&mut self, has_target: bool) {
        let (width, height) = self.size();
        let middle = voxtrace::glam::Vec2::new(width as f32, height as f32) * 0.5;
        let point = self.picked.clone().or_else(|| self.pick(middle)).map(|picked| picked.point);
        match (has_target, point) {
            (false, _) => self.timeline.edit(|course| course.look_at = None),
            (true, Some(point)) => self.timeline.edit(|course| course.look_at = Some(point)),
            (true, None) => self.say(tr!("timeline.click_target"), false),
        }
    }

    /// Changes what is edited by a function, which can be taken back, and shows the frame again.
    pub fn edit_time(&mut self, change: impl FnOnce(&mut Course)) {
        self.timeline.edit(change);
        let frame = self.timeline.frame();
        self.timeline.frame = frame;
        if self.timeline.playing.is_none() {
            self.follow_time(frame);
        }
    }

    /// Takes the last change of the timeline back.
    pub fn undo_time(&mut self) {
        if self.timeline.undo() && self.timeline.playing.is_none() {
            self.follow_time(self.timeline.frame());
        }
    }

    /// Where the timeline is kept: where it was read, else beside the scene; that of a built-in scene beside the settings.
    pub fn timeline_path(&self) -> Option<PathBuf> {
        let beside = || {
            let bookmarks = self.bookmark_path()?;
            let name = bookmarks.file_name()?.to_string_lossy().into_owned();
            let stem = name.strip_suffix(".cameras.toml")?;
            Some(bookmarks.with_file_name(format!("{stem}.animation.toml")))
        };
        self.timeline.path.clone().or_else(beside)
    }

    /// The file of the timeline, where it moves more than the camera and is shown.
    pub(crate) fn timeline_that_moves(&self) -> Option<PathBuf> {
        self.timeline
            .path
            .clone()
            .filter(|_| self.timeline.moves_more() && self.open.is_some() && self.timeline.is_shown)
    }

    fn time_cameras(&self) -> Vec<Camera> {
        self.open.as_ref().map(|open| open.original.cameras.clone()).unwrap_or_default()
    }

    /// Where cameras are looked up that a file names.
    fn named_cameras<'c>(&self, of_scene: &'c [Camera]) -> Cameras<'c> {
        Cameras { of_scene, bookmarks: self.bookmark_path(), scene: self.scene_of_bookmarks() }
    }

    /// Reads a timeline. A file that is none changes nothing and is told.
    pub fn open_timeline(&mut self, path: &Path) -> bool {
        let of_scene = self.time_cameras();
        let cameras = self.named_cameras(&of_scene);
        match self.timeline.open(path, &cameras) {
            Ok(()) => true,
            Err(error) => {
                self.say(error.to_string(), true);
                false
            }
        }
    }

    /// Keeps the timeline. Returns where; where it cannot be kept, it is told why.
    pub fn save_timeline(&mut self) -> Option<PathBuf> {
        let Some(path) = self.timeline_path() else {
            if self.is_untitled() {
                self.say(tr!("said.save_the_scene_first"), false);
            }
            return None;
        };
        let source = self.open.as_ref()?.source.clone();
        if let Some(folder) = path.parent().filter(|_| scenes::NAMES.contains(&source.as_str())) {
            // That it cannot be made, writing says.
            let _ = std::fs::create_dir_all(folder);
        }
        // What is there and moves the camera in another way stays, and a way that somebody else set goes only when asked again.
        let of_scene = self.time_cameras();
        let cameras = self.named_cameras(&of_scene);
        match self.timeline.take_written(&path, &cameras) {
            Ok(true) => {}
            Ok(false) => {
                self.say(tr!("timeline.is_another", path = path.display()), true);
                return None;
            }
            Err(error) => {
                self.say(tr!("timeline.not_over", error = error), true);
                return None;
            }
        }
        // Shapes of what bends are those that are seen.
        if let Some(rate) = self.shape_rate() {
            self.timeline.others.entry("key_fps").or_insert(Value::Float(rate));
        }
        let still = self.has_motion().then(|| self.navigator.camera().clone());
        match self.timeline.save(&path, &source, still) {
            Ok(()) => Some(path),
            Err(error) => {
                self.say(error.to_string(), true);
                None
            }
        }
    }

    /// Whether there are changes of the timeline that its file could hold and does not.
    pub(crate) fn has_unsaved_timeline(&self) -> bool {
        self.timeline.is_changed && !self.timeline.is_given_up && self.timeline_path().is_some()
    }

    /// The scene is about to be shown with other voxels: the camera's way stays in its place.
    pub(crate) fn time_in(&mut self, new_from_old: &DAffine3) {
        let Timeline { course, past, .. } = &mut self.timeline;
        past.iter_mut().chain([course]).for_each(|course| course.transform(new_from_old));
    }

    /// A scene whose file has something to play begins at its first frame, with a clip as long as that lasts.
    pub(crate) fn begin_motion(&mut self, plays: Plays) {
        if let Some((fps, seconds)) = plays.course() {
            if self.timeline.path.is_none() && !self.timeline.can_undo() {
                (self.timeline.course.fps, self.timeline.course.seconds) = (fps, seconds);
            }
            if !self.has_motion() {
                // Most of them are loops: a walk, a flame.
                self.timeline.repeats = true;
                self.say(
                    match plays {
                        Plays::Keyframes(frames) => tr!("timeline.keyframes", keyframes = frames),
                        _ => tr!("timeline.animation", seconds = format!("{seconds:.1}")),
                    },
                    false,
                );
            }
        }
        if self.has_motion() {
            self.change_light();
        }
    }

    /// Another scene has its own timeline: `wanted`, or the one that lies beside it.
    pub(crate) fn renew_timeline(&mut self, wanted: Option<PathBuf>) {
        let Timeline { is_shown, repeats, .. } = self.timeline;
        self.timeline = Timeline { is_shown, repeats, frame: 1, ..Timeline::default() };
        if let Some(path) = wanted {
            self.timeline.is_shown |= self.open_timeline(&path);
        } else if let Some(path) = self.timeline_path().filter(|path| path.is_file()) {
            let of_scene = self.time_cameras();
            let cameras = self.named_cameras(&of_scene);
            if let Err(error @ TimelineError::Read { .. }) = self.timeline.open(&path, &cameras) {
                self.say(error.to_string(), true);
            }
        }
    }
}
