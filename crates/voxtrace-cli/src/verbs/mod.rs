//! One file for each verb of the command line.

pub mod animate;
pub mod bench;
#[cfg(feature = "view")]
pub mod beside;
pub mod compare;
pub mod completions;
pub mod convert;
pub mod devices;
pub mod doctor;
mod film_info;
pub mod formats;
pub mod info;
#[cfg(feature = "view")]
mod kept_volume;
pub mod man;
pub mod merge;
#[cfg(feature = "view")]
mod motion;
pub mod plan;
pub mod render;
pub mod scenes;
#[cfg(feature = "serve")]
pub mod serve;
pub mod tiles;
#[cfg(feature = "view")]
pub mod view;
pub mod voxelize;
