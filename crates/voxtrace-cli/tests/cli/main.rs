//! The program as people run it: every verb, every exit code, from arguments to files.

mod animate;
mod animate_gltf;
mod bench;
mod bench_against;
mod bench_plans;
mod cluster;
mod common;
mod compare;
mod denoise;
mod docs;
mod doctor;
mod errors;
mod films;
mod in_memory;
mod interrupt;
mod large_volumes;
mod levels;
mod lines;
mod merging;
mod meshes;
mod never_over;
mod noise;
mod normals;
mod not_shown;
mod outputs;
mod plan;
mod render;
#[cfg(feature = "serve")]
mod serve;
mod surroundings;
mod tiles;
mod verbs;
mod view;
mod volumes;
mod voxels;
mod window_edits;
#[cfg(feature = "view")]
mod window_exports;
mod window_real_time;
mod writing;
