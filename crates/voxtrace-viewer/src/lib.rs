//! The desktop window of voxtrace: fly through a voxel scene while the light gathers. [`open_window`] opens it; below it, each part by
//! itself: the state without a window ([`session`], [`navigation`], [`lens`], [`keys`], [`touch`], [`gamepad`], [`dialogs`], [`render_settings`]), what it keeps ([`bookmarks`], [`settings`]),
//! the thread that traces ([`engine`]), pictures to files ([`export`]) and the drawing ([`gpu`]).

#![allow(unsafe_code, reason = "Vulkan is a C interface; each block says why it is sound")]

mod actions;
mod app;
pub mod benchmark;
pub mod bookmarks;
pub mod camera_toml;
pub mod canvas;
mod changes;
pub mod clipping;
mod cloud;
pub mod comparison;
pub mod cutting;
pub mod dialogs;
pub mod editing;
pub mod engine;
pub mod export;
pub mod frame_bench;
pub mod gamepad;
pub mod gpu;
pub mod input;
pub mod inspector;
pub mod kept_file;
pub mod keys;
pub mod lens;
pub mod load;
pub mod measuring;
pub mod memory;
pub mod motion;
pub mod navigation;
pub mod open;
pub mod outliner;
pub mod panels;
pub mod phases;
pub mod projection;
mod real_time;
pub mod render_command;
pub mod render_settings;
pub mod running;
pub mod scale;
pub mod session;
pub mod settings;
pub mod sight;
pub mod skies;
pub mod strings;
pub mod surroundings;
pub mod threads;
mod thumbnails;
pub mod timeline;
pub mod touch;
pub mod transfer;
mod walking;

pub use app::{ViewerError, WindowOptions, open_window};
pub use cloud::{PointsChoice, PointsSeen};
pub use load::{Loader, Reading, Told, Wanted};
pub use motion::{Motion, Plays};
pub use transfer::ValuesSeen;

/// The example of the crate's page, compiled.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
