//! Files in and out: readers and writers of scenes, readers of meshes, clouds of points and volumes, and pictures. Families of
//! formats are features.

// What families share has no user where some are left out.
#![cfg_attr(
    not(all(
        feature = "medical",
        feature = "mesh",
        feature = "minecraft",
        feature = "points",
        feature = "rasters",
        feature = "volumes",
        feature = "voxels"
    )),
    allow(dead_code)
)]
#![forbid(unsafe_code)]

// One thread has no work to divide.
#[cfg(target_arch = "wasm32")]
extern crate voxtrace_serial as rayon;

#[cfg(feature = "pictures")]
pub mod difference;
pub mod export;
pub mod import;
pub mod output;

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
