//! Clouds larger than memory: points that stay in their file and are read from it in pieces, once for each pass.

use super::{Attributes, PointCloud};
use crate::import_error::ImportError;
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use std::ops::Range;

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
    /// The same points file by file, where they are in several that can be read apart.
    fn tiled(&mut self) -> Option<&mut dyn TiledPoints> {
        None
    }
}

/// Points in several files, of which several processes read some each. What must be known of all of them beforehand is found out
/// file by file and brought together.
pub trait TiledPoints: PointSource {
    /// Points of each file, as their headers say.
    fn points_of_tiles(&mut self) -> Vec<u64>;
    /// What the first point of all decides: what positions are relative to. `None` where no point is kept. Reads no further than
    /// to that point.
    ///
    /// # Errors
    /// If the files up to it cannot be read.
    fn origin(&mut self) -> Result<Option<DVec3>, ImportError>;
    /// Makes the first pass over one file; positions are relative to `origin`.
    ///
    /// # Errors
    /// As [`PointSource::for_each`].
    fn survey_tile(
        &mut self,
        tile: usize,
        origin: Option<DVec3>,
        each: &mut dyn FnMut(&PointCloud) -> bool,
    ) -> Result<TileFacts, ImportError>;
    /// What the headers and the first points of the files let expect of their points, without reading them all, in the order of the files. `None` where
    /// that is not enough: points are chosen by their class or place, or a header says no bounds.
    ///
    /// # Errors
    /// As [`PointSource::for_each`].
    fn expect(&mut self) -> Result<Option<Vec<ExpectedTile>>, ImportError>;
    /// As [`PointSource::for_each`], over one file, by what [`Self::learn`] was told; what is found is held against that by whoever asks.
    ///
    /// # Errors
    /// As [`PointSource::for_each`].
    fn visit_tile(&mut self, tile: usize, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<TileFacts, ImportError>;
    /// Takes what first passes have found in the files, in their order, as if this one had made them.
    ///
    /// # Errors
    /// If no point of all is among those that are asked for.
    fn learn(&mut self, origin: Option<DVec3>, facts: &[TileFacts]) -> Result<(), ImportError>;
    /// From now on passes are over these files alone.
    fn choose(&mut self, tiles: Range<usize>);
}

/// What is expected of the points of a file.
#[derive(Clone, Copy, Debug)]
pub struct ExpectedTile {
    /// Of all points, their number as the header says; what they say, as far as the first ones tell.
    pub facts: TileFacts,
    /// Bounds that the header announces, in the coordinates of positions with the frame's offset; empty where there are no points.
    pub bounds: (DVec3, DVec3),
}

/// What a first pass over a file has found, beside its points.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct TileFacts {
    /// Points that are kept.
    pub chosen: u64,
    /// Points that the file withholds.
    pub withheld: u64,
    /// Points whose coordinates are not finite.
    pub infinite: u64,
    /// Points that nobody asked for.
    pub not_chosen: u64,
    /// Classes of those, a bit for each.
    pub classes_not_chosen: [u64; 4],
    /// Largest channel of a colour, 0 where points have none.
    pub largest_color: u16,
    /// 1 where an intensity is not 0.
    pub has_intensities: u8,
    /// 1 where a class is not 0.
    pub has_classes: u8,
    /// 1 where points have packets of waveforms.
    pub has_waveforms: u8,
    /// Zero.
    pub unused: [u8; 3],
}
