//! Clouds larger than memory: points that are read from their file as often as they are needed, some at a time.

use super::{Attributes, PointCloud};
use crate::import_error::ImportError;
use glam::DVec3;

/// Points in a file.
pub trait PointSource: Send {
    /// The cloud without its points; whole, notes included, once all points were read.
    fn frame(&mut self) -> &mut PointCloud;
    /// Points, as the file counts them.
    fn count(&self) -> u64;
    /// What each point has, known once all points were read.
    fn attributes(&self) -> Attributes;
    /// The box around all points as the file says it, which nobody need believe.
    fn announced_bounds(&self) -> Option<(DVec3, DVec3)>;
    /// Reads all points. `each` gets some of them, with the frame's offset, and says whether to go on; before all points
    /// were read once, their attributes may be more than there are, and their colours those of another scale.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError>;
}
