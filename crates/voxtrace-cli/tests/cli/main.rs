//! The program as people run it: every verb, every exit code, from arguments to files.

mod bench;
mod common;
mod docs;
mod doctor;
mod errors;
mod films;
mod in_memory;
mod interrupt;
mod meshes;
mod outputs;
mod render;
mod verbs;
mod view;
mod volumes;
mod voxels;
#[cfg(feature = "view")]
mod window_exports;
