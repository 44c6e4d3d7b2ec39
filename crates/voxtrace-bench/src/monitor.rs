//! Who runs a benchmark: is told how far it is, may interrupt it, and gives the scenes. What both the benchmark and a command
//! line, a window or a script need of each other.

use crate::error::BenchError;
use crate::plan::SceneEntry;
use voxtrace::{PackedScene, TraceError};

/// Follows the work. Every method has an answer of its own, so that nobody has to follow anything.
pub trait Monitor {
    /// Something worth saying.
    fn remark(&mut self, _text: &str) {}

    /// Something that went wrong without ending the work.
    fn warn(&mut self, _text: &str) {}

    /// Begins a part of the work that has `total` steps.
    fn begin(&mut self, _name: &str, _total: u64) {}

    /// `done` steps of the part are done.
    fn update(&mut self, _done: u64) {}

    /// Ends the part.
    fn end(&mut self) {}

    /// Whether the work should end; asked between any two frames.
    fn is_interrupted(&self) -> bool {
        false
    }

    /// An error of a tracer as it stands in the report, for example with a hint.
    fn explain(&self, error: TraceError) -> String {
        error.to_string()
    }
}

/// A scene that is to be measured.
pub struct LoadedScene {
    /// What its files are called after.
    pub stem: String,
    /// The scene, with camera and light as they shall be.
    pub scene: PackedScene,
}

/// Who runs a benchmark.
pub trait Host: Monitor {
    /// What can go wrong where the scenes come from, or here.
    type Error: From<BenchError>;

    /// The scene that an entry of the plan names; a built-in one with about so many voxels, where a number is given.
    ///
    /// # Errors
    /// Whatever keeps the scene from being read.
    fn load(&mut self, entry: &SceneEntry, voxels: Option<u64>) -> Result<LoadedScene, Self::Error>;
}
