//! Parts of the command that are one thing or another: its scene, its sky, its frames.

use std::path::PathBuf;
use voxtrace::glam::Vec3;

/// The scene on the command line.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneArgument {
    /// A file, as it is to be called in the command: absolute, or relative to where that is run.
    File(PathBuf),
    /// A built-in scene, and its size if somebody chose one.
    BuiltIn {
        /// Its name.
        name: String,
        /// `--voxels`.
        voxels: Option<u64>,
    },
}

/// The sky behind its sun, in place of the scene's.
#[derive(Clone, Debug, PartialEq)]
pub enum SkySetting {
    /// `--sky-color`: one colour, linear.
    Color(Vec3),
    /// `--sky physical`: the Earth's in the light of the sun.
    Physical,
    /// `--sky FILE`: a panorama, as it is to be called in the command.
    Panorama(PathBuf),
}

/// A row of frames in place of one picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Sequence {
    /// A turn around the vertical through the camera's target, in so many frames.
    Turntable(u32),
    /// A flight through the cameras of a file.
    Flight {
        /// The bookmarks.
        file: PathBuf,
        /// Frames of the whole flight.
        frames: u32,
    },
    /// One frame of an animation, from the camera that is said; the command is `animate`.
    Frame {
        /// The TOML.
        file: PathBuf,
        /// Its number, from 1 on.
        frame: u32,
    },
    /// An animation, which names its scene: the command is `animate`.
    Animation {
        /// The TOML.
        file: PathBuf,
        /// Whether frames that are there stay.
        keeps: bool,
    },
}
