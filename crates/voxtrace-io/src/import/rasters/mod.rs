//! Rasters: heightmaps, and stacks of pictures.

pub(crate) mod heightmap;
pub(crate) mod slices;
mod stack;
