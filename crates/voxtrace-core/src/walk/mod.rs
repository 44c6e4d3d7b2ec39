//! Finding the first voxel along a ray, exactly.
//!
//! A ray is a path of cells: it starts in the voxel that holds its first point and crosses one grid plane after the
//! other, in order of the ray parameter t, at equal t first x, then y, then z. So the path never squeezes between two
//! voxels that share an edge. `scalar` follows that path and skips empty boxes: f32 arithmetic decides
//! almost always, and where it comes too near to a plane to be sure, `exact` decides in f64. `t` and the face of a
//! hit come from `exact::hit_of` alone, whatever found the voxel.

#[cfg(target_arch = "x86_64")]
mod avx512;
mod axes;
mod batch;
mod beams;
mod counts;
pub mod exact;
mod groups;
mod instances;
mod instructions;
pub mod local_ray;
mod picking;
mod scalar;
pub(crate) mod simd;
mod stream;

pub use batch::{cast_batch, cast_batch_whole, cast_batch_with, occluded_batch, occluded_batch_with};
pub use counts::WalkCounts;
pub use instances::{cast, cast_below, cast_whole, occluded};
pub use instructions::Instructions;
pub use local_ray::{LocalRay, MAX_ORIGIN};
pub use scalar::first_voxel;
