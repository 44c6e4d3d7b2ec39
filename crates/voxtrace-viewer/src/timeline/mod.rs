//! The camera over time: keys on an axis of seconds, between them the spline of Catmull and Rom, as `docs/animation.md` has them. The window plays
//! and edits them; the file they are kept in is the one that `voxtrace animate` reads ([`file`]).

mod file;
mod play;

pub use file::{TimelineError, scene_of};

use crate::scale::Scale;
use std::path::{Path, PathBuf};
use voxtrace::animation::{CameraMotion, CameraTrack, Ease, LookAt};
use voxtrace::camera::Flight;
use voxtrace::glam::{DAffine3, Vec3};
use voxtrace::{Camera, Scene};

/// Most keys: more than anybody sets by hand.
pub const MOST_KEYS: usize = 10_000;
/// Most frames of a clip.
pub const MOST_FRAMES: u32 = 1_000_000;
/// Steps back that are kept.
const MOST_UNDO: usize = 100;

/// A camera at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeKey {
    /// Seconds from the beginning.
    pub at: f64,
    /// The camera.
    pub camera: Camera,
}

/// The scene that an animation names, where a path names one.
pub(crate) fn scene_to_open(path: &Path) -> Option<Result<String, TimelineError>> {
    let is_animation = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"));
    is_animation.then(|| scene_of(path))
}

impl TimeKey {
    /// A camera at a time. Keys have no names of their own: all have the usual one, as in their file.
    pub fn new(at: f64, camera: Camera) -> Self {
        let Camera { name, .. } = Camera::look_at(Vec3::ZERO, Vec3::Y);
        Self { at, camera: Camera { name, ..camera } }
    }
}

/// What is kept in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// The keys by rising time, no two at one.
    pub keys: Vec<TimeKey>,
    /// Frames a second.
    pub fps: f64,
    /// How long the clip lasts.
    pub seconds: f64,
    /// Share of a frame's time in which the shutter is open.
    pub shutter: f64,
    /// How the camera speeds up and slows down.
    pub ease: Ease,
    /// The point that it looks at, wherever it is.
    pub look_at: Option<Vec3>,
    /// Whether a thin lens is in focus at the target.
    pub focuses_on_target: bool,
}

impl Default for Course {
    fn default() -> Self {
        Self {
            keys: Vec::new(),
            fps: 24.0,
            seconds: 5.0,
            shutter: 0.0,
            ease: Ease::None,
            look_at: None,
            focuses_on_target: false,
        }
    }
}

impl Course {
    /// Frames of the clip, as `animate` counts them.
    pub fn frames(&self) -> u32 {
        (self.seconds * self.fps).round().clamp(1.0, f64::from(MOST_FRAMES)) as u32
    }

    /// When a frame begins, counted from 1, seconds.
    pub fn time_of(&self, frame: u32) -> f64 {
        f64::from(frame.saturating_sub(1)) / self.fps
    }

    /// The middle of a frame's exposure, seconds.
    pub fn middle_of(&self, frame: u32) -> f64 {
        self.time_of(frame) + 0.5 * (self.shutter / self.fps)
    }

    /// The frame that a time lies in, within the clip.
    pub fn frame_at(&self, seconds: f64) -> u32 {
        ((seconds * self.fps).round() + 1.0).clamp(1.0, f64::from(self.frames())) as u32
    }

    /// How the camera moves; `None` with fewer than two keys.
    pub fn track(&self) -> Option<CameraTrack> {
        let keys: Vec<(f64, Camera)> = self.keys.iter().map(|key| (key.at, key.camera.clone())).collect();
        let (start, end) = (keys.first()?.0, keys.last()?.0);
        let flight = Flight::timed(&keys).ok()?.into();
        Some(CameraTrack {
            motion: CameraMotion::Flight { flight, start, seconds: end - start, ease: self.ease },
            look_at: self.look_at.map(LookAt::Point),
            focuses_on_target: self.focuses_on_target,
        })
    }

    /// The camera in the middle of the exposure of a frame, counted from 1: what `animate` renders it from. `None` with fewer than two keys.
    pub fn camera_of(&self, frame: u32) -> Option<Camera> {
        // What it looks at are points: no scene is asked.
        self.track().map(|track| track.at(&Scene::new(""), self.middle_of(frame)))
    }

    /// Puts a key at a time; one that is there within half a frame goes. Returns its number.
    pub fn put(&mut self, at: f64, camera: Camera) -> usize {
        self.keys.retain(|key| (key.at - at).abs() * self.fps > 0.5);
        let index = self.keys.partition_point(|key| key.at < at);
        self.keys.insert(index, TimeKey::new(at, camera));
        index
    }

    /// Moves a key to the beginning of a frame, unless another is there. Returns its number, which may be another one.
    pub fn shift(&mut self, index: usize, frame: u32) -> usize {
        let at = self.time_of(frame);
        let is_taken = |(other, key): (usize, &TimeKey)| other != index && (key.at - at).abs() * self.fps <= 0.5;
        if index >= self.keys.len() || self.keys.iter().enumerate().any(is_taken) {
            return index;
        }
        let TimeKey { camera, .. } = self.keys.remove(index);
        self.put(at, camera)
    }

    /// Brings it into a world with voxels of another size, or of another place.
    pub(crate) fn transform(&mut self, new_from_old: &DAffine3) {
        let scale = Scale::times_as_long(new_from_old);
        let moved = |point: Vec3| new_from_old.transform_point3(point.as_dvec3()).as_vec3();
        for Camera { eye, target, lens, .. } in self.keys.iter_mut().map(|key| &mut key.camera) {
            (*eye, *target, *lens) = (moved(*eye), moved(*target), lens.scaled(scale));
        }
        self.look_at = self.look_at.map(moved);
    }

    /// Spreads cameras evenly over the clip, in place of all keys: the last one is there in the last frame.
    pub fn spread(&mut self, cameras: Vec<Camera>) {
        let steps = cameras.len().saturating_sub(1).max(1) as f64;
        let last = f64::from(self.frames() - 1);
        let at = |index: usize| (last * index as f64 / steps).round() / self.fps;
        self.keys = cameras.into_iter().enumerate().map(|(index, camera)| TimeKey::new(at(index), camera)).collect();
        // A clip may have fewer frames than there are cameras.
        self.keys.dedup_by(|next, key| next.at <= key.at);
    }
}

/// The timeline of the window.
#[derive(Clone, Debug, Default)]
pub struct Timeline {
    /// Whether its panel is shown.
    pub is_shown: bool,
    /// What is edited.
    pub course: Course,
    /// The key that was clicked.
    pub selected: Option<usize>,
    /// Whether it begins again at its end while it plays.
    pub repeats: bool,
    /// Where it is kept.
    pub path: Option<PathBuf>,
    /// Whether it was changed since it was kept or read.
    pub is_changed: bool,
    /// The frame under the playhead, counted from 1.
    frame: u32,
    /// Seconds from the beginning while it plays.
    playing: Option<f64>,
    /// What the file says beside what is edited here.
    others: toml::Table,
    /// The text of the file, as far as it is known here.
    known: Option<String>,
    /// Whether somebody said that the changes may be lost.
    pub(crate) is_given_up: bool,
    past: Vec<Course>,
}

impl Timeline {
    /// The frame under the playhead, counted from 1.
    pub fn frame(&self) -> u32 {
        self.frame.clamp(1, self.course.frames())
    }

    /// Whether it plays.
    pub fn is_playing(&self) -> bool {
        self.playing.is_some()
    }

    /// Whether the file moves more than the camera: objects, sun or sky, or says how the scene's file plays.
    pub fn moves_more(&self) -> bool {
        ["object", "sun", "sky", "animation", "animation_repeats", "key_fps"]
            .iter()
            .any(|key| self.others.contains_key(*key))
    }

    /// Changes what is edited; [`Self::undo`] takes it back.
    pub fn edit(&mut self, change: impl FnOnce(&mut Course)) {
        let before = self.course.clone();
        change(&mut self.course);
        self.note(before);
    }

    /// Says that what is edited was changed from `before`.
    pub fn note(&mut self, before: Course) {
        if before == self.course {
            return;
        }
        (self.is_changed, self.is_given_up) = (true, false);
        if self.past.len() == MOST_UNDO {
            self.past.remove(0);
        }
        self.past.push(before);
    }

    /// Takes the last change back. Returns whether there was one.
    pub fn undo(&mut self) -> bool {
        let Some(before) = self.past.pop() else { return false };
        (self.course, self.is_changed, self.is_given_up) = (before, true, false);
        self.selected = None;
        true
    }

    /// Whether there is a change to take back.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(x: f32) -> Camera {
        Camera::look_at(Vec3::new(x, -20.0, 5.0), Vec3::ZERO)
    }

    fn times(course: &Course) -> Vec<f64> {
        course.keys.iter().map(|key| key.at).collect()
    }

    #[test]
    fn keys_stay_in_order_and_one_frame_has_one_key() {
        let mut course = Course { fps: 10.0, ..Course::default() };
        assert_eq!(
            (course.put(2.0, camera(2.0)), course.put(0.0, camera(0.0)), course.put(1.0, camera(1.0))),
            (0, 0, 1)
        );
        assert_eq!(times(&course), [0.0, 1.0, 2.0]);
        course.put(1.02, camera(9.0));
        assert_eq!((times(&course), course.keys[1].camera.eye.x), (vec![0.0, 1.02, 2.0], 9.0), "it was replaced");
        assert_eq!(course.shift(1, 31), 2, "behind the last one");
        assert_eq!(times(&course), [0.0, 2.0, 3.0]);
        assert_eq!((course.shift(2, 21), times(&course)), (2, vec![0.0, 2.0, 3.0]), "another key is there");
    }

    #[test]
    fn a_clip_begins_and_ends_at_its_cameras_to_the_bit_and_looks_where_it_is_told() {
        let mut course = Course { fps: 25.0, seconds: 4.0, ..Course::default() };
        assert!(course.camera_of(1).is_none());
        course.spread(vec![camera(0.0), camera(10.0), camera(30.0)]);
        assert_eq!((course.frames(), times(&course)), (100, vec![0.0, 2.0, 3.96]));
        assert_eq!((course.camera_of(1), course.camera_of(100)), (Some(camera(0.0)), Some(camera(30.0))));
        assert_ne!(course.camera_of(99), Some(camera(30.0)), "the comparison sees a frame");
        let even = course.camera_of(26).unwrap();
        course.ease = Ease::In;
        assert!(course.camera_of(26).unwrap().eye.x < even.eye.x, "it begins slowly");
        course.look_at = Some(Vec3::new(1.0, 2.0, 3.0));
        assert_eq!(course.camera_of(40).unwrap().target, Vec3::new(1.0, 2.0, 3.0));
    }

    #[test]
    fn changes_are_taken_back_one_by_one() {
        let mut timeline = Timeline::default();
        timeline.edit(|course| _ = course.put(0.0, camera(1.0)));
        timeline.edit(|course| course.fps = 24.0);
        timeline.edit(|course| course.fps = 30.0);
        assert!(timeline.undo() && timeline.course.fps == 24.0 && timeline.course.keys.len() == 1);
        assert!(
            timeline.undo() && timeline.course == Course::default() && !timeline.undo(),
            "what changes nothing is no step"
        );
    }
}
