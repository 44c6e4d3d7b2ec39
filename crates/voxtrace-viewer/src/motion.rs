//! Scenes that move by themselves: keyframes of files, and objects, sun and sky of an animation's TOML. The frame under the playhead of the timeline says where
//! everything is, by the function of time that `voxtrace animate` has.

use crate::render_command::{RenderCommand, Sequence};
use crate::session::{Command, Session};
use std::fmt;
use std::sync::Arc;
use voxtrace::animation::Animation;
use voxtrace::changes::SunSetting;
use voxtrace::packed::PackedInstance;
use voxtrace::{PackedScene, Placement, Scene};

/// What moves in a scene, and how.
pub struct Motion {
    /// The scene as it is without its motion.
    pub base: Scene,
    /// How it moves.
    pub animation: Animation,
    /// Whether a file says how many of its keyframes there are in a second; else as many as frames of the clip.
    pub has_own_rate: bool,
    /// How many shapes a second were made of what bends; `None`: nothing does.
    pub shape_rate: Option<f64>,
}

/// Keyframes a second: about as MagicaVoxel plays them.
const KEY_FPS: f64 = 10.0;
/// Frames a second of an animation in seconds.
const CLIP_FPS: f64 = 24.0;

/// What the file of a scene brings along that plays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Plays {
    /// Nothing.
    #[default]
    Nothing,
    /// Keyframes, which last so many frames.
    Keyframes(u32),
    /// An animation, which lasts so many seconds.
    Clip(f64),
}

impl Plays {
    /// Frames a second of a clip that shows all of it, and how long that is in seconds; `None`: there is nothing to play.
    pub fn course(self) -> Option<(f64, f64)> {
        match self {
            Self::Keyframes(frames) if frames > 0 => Some((KEY_FPS, f64::from(frames) / KEY_FPS)),
            // A whole number of frames, so that the last one is the end.
            Self::Clip(seconds) if seconds > 0.0 => Some((CLIP_FPS, (seconds * CLIP_FPS).round().max(1.0) / CLIP_FPS)),
            _ => None,
        }
    }
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "Motion of {:?}", self.base.name)
    }
}

/// Nothing of it is compared: it comes once.
impl PartialEq for Motion {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

/// The motion of the scene that is open.
pub struct Moving {
    motion: Arc<Motion>,
    animation: Animation,
    /// The scene of the time that is shown, changed from one to the next.
    now: Scene,
}

impl Moving {
    /// The motion of a scene.
    pub fn new(motion: Arc<Motion>) -> Self {
        Self { animation: motion.animation.clone(), now: motion.base.clone(), motion }
    }

    /// A scene as it is at a time; of what is not to be seen nothing moves. A scene whose placement cannot be made stays as it is.
    fn at(&mut self, scene: &Arc<PackedScene>, seconds: f64, is_visible: &[bool]) -> Arc<PackedScene> {
        let objects = self.motion.base.instances.len();
        // What is around the scene comes behind its objects.
        let is_further = |own: &&PackedInstance| own.scene_instance as usize >= objects;
        let further: Vec<PackedInstance> = scene.instances().iter().filter(is_further).copied().collect();
        for ((now, own), &is_visible) in self.now.instances.iter_mut().zip(&self.motion.base.instances).zip(is_visible)
        {
            now.hidden = own.hidden || !is_visible;
        }
        self.animation.apply(&self.motion.base, &mut self.now, seconds);
        // What is hidden here stays so whatever the animation says.
        for (now, _) in self.now.instances.iter_mut().zip(is_visible).filter(|(_, is_visible)| !**is_visible) {
            now.hidden = true;
        }
        let placed = Placement::of_scene_and(scene.geometry(), &self.now, &further)
            .and_then(|placement| scene.with_placement(&placement));
        let Ok(mut placed) = placed else { return Arc::clone(scene) };
        if let Some(sun) = &self.animation.sun {
            let [bearing, height, strength] = sun.at(seconds).map(|value| value as f32);
            // A spline may leave the range of its keys.
            let sun = SunSetting { bearing, height: height.clamp(-90.0, 90.0), strength: strength.max(0.0) };
            placed.sky.set_sun(sun.sun());
        }
        if let Some(brightness) = &self.animation.sky_brightness {
            placed.sky.set_brightness(brightness.at(seconds)[0].max(0.0) as f32);
        }
        Arc::new(placed)
    }
}

impl Session {
    /// Takes what moves in a scene that was opened.
    pub(crate) fn take_motion(&mut self, motion: Option<Arc<Motion>>, is_again: bool) {
        let Some(motion) = motion else {
            if !is_again {
                self.moving = None;
            }
            return;
        };
        self.moving = Some(Moving::new(motion));
    }

    /// Whether the scene moves, and not the camera alone.
    pub fn has_motion(&self) -> bool {
        self.moving.is_some()
    }

    /// Whether the file of the scene brings something along that plays.
    pub(crate) fn has_something_to_play(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.plays.course().is_some())
    }

    /// A scene whose file brings something along that plays is read again to be moved, once the timeline is shown. Returns whether that was asked for.
    pub(crate) fn ask_for_motion(&mut self) -> bool {
        let asks = self.has_something_to_play() && self.moving.is_none() && !self.refuses_to_read_again();
        if asks {
            self.wants_motion = true;
            self.ask(Command::LoadAgain);
        }
        asks
    }

    /// How many shapes a second were made of what bends in the scene.
    pub(crate) fn shape_rate(&self) -> Option<f64> {
        self.moving.as_ref()?.motion.shape_rate
    }

    /// The command that renders the picture of a scene that moves: the frame under the playhead, of the timeline as it is kept now.
    pub fn frame_command(&mut self) -> Option<RenderCommand> {
        let file = self.save_timeline()?;
        let frame = self.timeline.frame();
        let command = self.render_command()?;
        Some(RenderCommand {
            // Each frame of `animate` adds its number to the seed, which the window does not.
            seed: command.seed.wrapping_sub(frame - 1),
            sequence: Some(Sequence::Frame { file, frame }),
            outputs: vec![format!("{}_####.png", self.stem()).into()],
            usual_camera: None,
            ..command
        })
    }

    /// Puts everything where it is in the frame under the playhead.
    pub(crate) fn place_moving(&mut self) {
        let (Some(moving), Some(open)) = (&mut self.moving, &mut self.open) else { return };
        let seconds = self.timeline.course.middle_of(self.timeline.frame());
        if !moving.motion.has_own_rate && moving.animation.keyframe_rate > 0.0 {
            moving.animation.keyframe_rate = self.timeline.course.fps;
        }
        let is_alone = Arc::ptr_eq(&open.alone, &open.changed);
        open.alone = moving.at(&open.alone, seconds, &open.is_visible);
        open.changed =
            if is_alone { Arc::clone(&open.alone) } else { moving.at(&open.changed, seconds, &open.is_visible) };
    }
}
