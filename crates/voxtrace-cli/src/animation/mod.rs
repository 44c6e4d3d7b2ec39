//! Animations on the command line: what a TOML, keyframes and options say becomes a [`Stage`], the scene as it is at any time. `cast` makes it
//! ready to be packed, `stage` puts it in motion.

mod cameras;
mod cast;
mod objects;
mod script;
mod stage;
mod table;

pub use cast::Cast;
pub use script::{Script, is_script};
pub use stage::{Setting, Stage};

use crate::failure::Failure;
use crate::parse;
use crate::views::ViewArgs;
use std::ops::RangeInclusive;

/// Frames a second of clips, where nobody says how many.
const DEFAULT_FPS: f64 = 24.0;
/// As [`DEFAULT_FPS`], where the keyframes of a file are all that moves: about as MagicaVoxel plays them.
const DEFAULT_KEY_FPS: f64 = 10.0;

/// Options about time.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Time")]
pub struct MotionArgs {
    /// Frames a second [default: 24, or 10 where only keyframes of the file move]
    #[arg(long, value_name = "N", value_parser = rate)]
    pub fps: Option<f64>,
    /// Frames a second of the keyframes that a file brings along, and shapes a second of what bends in one of glTF [default: as --fps]
    #[arg(long, value_name = "N", value_parser = rate)]
    pub key_fps: Option<f64>,
    /// Which of the animations of a glTF file, by name or number [default: the first; `info` lists them]
    #[arg(long, value_name = "NAME")]
    pub animation: Option<String>,
    /// Share of a frame's time in which the shutter is open: motion is blurred [default: 0]
    #[arg(long, value_name = "SHARE", value_parser = parse::share)]
    pub shutter: Option<f32>,
}

fn rate(text: &str) -> Result<f64, String> {
    let rate = f64::from(parse::finite(text)?);
    if rate > 0.0 && rate <= 1000.0 { Ok(rate) } else { Err("a rate is above 0 and at most 1000".into()) }
}

/// What is known of an animation before its scene is read.
pub struct Director {
    pub script: Option<Script>,
    pub args: MotionArgs,
}

impl Director {
    /// The frames to render, where that is known before the scene is.
    pub fn frames(&self, view: &ViewArgs) -> Option<RangeInclusive<u32>> {
        view.frames.clone().or_else(|| self.total(view, DEFAULT_FPS).map(|total| 1..=total))
    }

    /// The last of the frames that are asked for, where the length of the whole, and with it where things are in each frame, follows from it.
    pub fn last_of_range(&self, view: &ViewArgs) -> Option<u32> {
        let moves = view.turntable.is_some() || view.flight.is_some() || self.script.is_some();
        let last = view.frames.as_ref().map(|frames| *frames.end());
        last.filter(|_| moves && self.total(view, DEFAULT_FPS).is_none())
    }

    /// Which of the file's animations moves it.
    pub fn clip(&self) -> Option<&str> {
        self.args.animation.as_deref().or_else(|| self.script.as_ref()?.animation.as_deref())
    }

    /// How many shapes a second are made of what bends in the file's animation: those that the frames show, as far as is known before the scene is read.
    pub fn shape_rate(&self) -> f64 {
        let script = self.script.as_ref();
        let of_keys = self.args.key_fps.or_else(|| script?.key_fps);
        of_keys.or(self.args.fps).or_else(|| script?.fps).unwrap_or(DEFAULT_FPS)
    }

    /// How many frames the whole has, where the file or an option says it.
    fn total(&self, view: &ViewArgs, fps: f64) -> Option<u32> {
        let script = self.script.as_ref();
        let fps = self.args.fps.or(script.and_then(|script| script.fps)).unwrap_or(fps);
        let of_script = script.and_then(|script| {
            let of_seconds = script.seconds.map(|seconds| (seconds * fps).round().clamp(1.0, 1e6) as u32);
            script.frames.or(of_seconds)
        });
        let of_turn = view.turntable.filter(|&turn| turn > 0);
        of_script.or(of_turn).or(view.flight_frames)
    }

    /// Frames that a resume looks for.
    pub fn frames_to_resume(&self, view: &ViewArgs) -> Result<RangeInclusive<u32>, Failure> {
        self.frames(view).ok_or_else(|| {
            Failure::usage("--resume must know which frames there are before the scene is read")
                .hint("say --frames A..B")
        })
    }
}
