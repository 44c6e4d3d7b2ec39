//! Why a tracer could not do what it was asked.

use crate::dynamic::OutOfStep;
use crate::packed::PlacementError;

/// A tracer could not do what it was asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceError {
    /// `set_scene` has not been called.
    #[error("no scene is set")]
    NoScene,
    /// The placement does not suit the scene.
    #[error("{0}")]
    Placement(#[from] PlacementError),
    /// The patch does not follow on the scene that the tracer has.
    #[error("{0}")]
    OutOfStep(#[from] OutOfStep),
    /// `render` has not been called.
    #[error("nothing has been rendered")]
    NoFilm,
    /// The frame cannot be rendered.
    #[error("the frame cannot be rendered: {0}")]
    BadFrame(String),
    /// The device or driver lacks something.
    #[error("not supported: {0}")]
    Unsupported(String),
    /// Not enough memory.
    #[error("out of memory: {needed} bytes needed, {available} available")]
    OutOfMemory {
        /// Bytes asked for.
        needed: u64,
        /// Bytes there are.
        available: u64,
    },
    /// The device stopped answering.
    #[error("the device was lost during {last_pass}")]
    DeviceLost {
        /// What it was doing.
        last_pass: String,
    },
    /// The device or its driver failed in some other way.
    #[error("{step} failed: {reason}")]
    Device {
        /// What the device was asked to do.
        step: String,
        /// What the driver answered.
        reason: String,
    },
}
