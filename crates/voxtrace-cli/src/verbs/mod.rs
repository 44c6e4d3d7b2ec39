//! One file for each verb of the command line.

pub mod animate;
pub mod bench;
pub mod compare;
pub mod completions;
pub mod convert;
pub mod devices;
pub mod doctor;
mod film_info;
pub mod formats;
pub mod info;
pub mod man;
pub mod merge;
pub mod render;
pub mod scenes;
#[cfg(feature = "view")]
pub mod view;
pub mod voxelize;
