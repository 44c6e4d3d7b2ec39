//! Rasters: heightmaps, and stacks of pictures.

pub(crate) mod heightmap;
mod large;
pub(crate) mod slices;
mod stack;
