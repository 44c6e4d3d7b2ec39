//! Files in and out: readers and writers of scenes, readers of meshes, clouds of points and volumes, and pictures.

#![forbid(unsafe_code)]

pub mod export;
pub mod import;
pub mod output;
