//! Pictures that readers use: textures, planes of numbers, and where they lie on maps.

#[cfg(feature = "textures")]
pub(crate) mod allowance;
#[cfg(feature = "rasters")]
mod contiguous;
#[cfg(feature = "rasters")]
pub(crate) mod geotiff;
#[cfg(feature = "rasters")]
pub(crate) mod hyperstack;
#[cfg(feature = "rasters")]
mod imagej;
#[cfg(any(feature = "medical", feature = "rasters"))]
pub(crate) mod jpeg_2000;
#[cfg(feature = "rasters")]
mod page;
#[cfg(feature = "rasters")]
pub(crate) mod pages;
#[cfg(feature = "rasters")]
pub(crate) mod planes;
#[cfg(feature = "textures")]
pub(crate) mod texture;
#[cfg(feature = "rasters")]
mod unpacked;
