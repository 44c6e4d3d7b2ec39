//! Clouds larger than memory: points that stay in their file and are read from it in pieces, once for each pass.

use super::{Attributes, PointCloud};
use crate::import_error::ImportError;
use glam::DVec3;

/// Points that stay in their file.
pub trait PointSource: Send {
    /// The cloud without its points; complete, notes included, after the first pass.
    fn frame(&mut self) -> &mut PointCloud;
    /// Points, as the file counts them.
    fn count(&self) -> u64;
    /// The points' attributes, known after the first pass.
    fn attributes(&self) -> Attributes;
    /// The bounds that the file's header claims; they may be wrong.
    fn announced_bounds(&self) -> Option<(DVec3, DVec3)>;
    /// Makes a pass over all points. `each` gets them in pieces, with the frame's offset, and returns whether to go on. During the
    /// first pass a piece may have attributes that turn out not to be there, and colours in another scale.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError>;
}
