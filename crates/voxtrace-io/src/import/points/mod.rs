//! Clouds of points: LAS and LAZ, XYZ, PCD and E57.

pub(crate) mod e57;
pub(crate) mod las;
pub(crate) mod pcd;
pub(crate) mod xyz;
