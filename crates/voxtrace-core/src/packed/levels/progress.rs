//! What is told of levels of detail that are being made.

use std::io;

/// How far the work on a level of detail is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelProgress {
    /// What is done.
    pub step: LevelStep,
    /// The level: 0 is the scene itself.
    pub level: u32,
    /// What is done of `total`, in voxels of the level below, or in chunks. May begin anew. The last word on a level is that all of it is done.
    pub done: u64,
    /// See `done`.
    pub total: u64,
}

/// What is done with a level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelStep {
    /// It is made from the one below it.
    Make,
    /// Its chunks are compressed, in files for streaming.
    Compress,
}

/// Hears of the work on levels of detail, and stops it by `false`.
pub type LevelListener<'a> = &'a mut dyn FnMut(LevelProgress) -> bool;

/// Tells a listener. An error of the kind [`io::ErrorKind::Interrupted`] where it stops the work.
pub(in crate::packed) fn tell(listener: LevelListener, progress: LevelProgress) -> io::Result<()> {
    if listener(progress) { Ok(()) } else { Err(io::ErrorKind::Interrupted.into()) }
}
