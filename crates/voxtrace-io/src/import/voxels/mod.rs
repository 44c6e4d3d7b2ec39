//! Models of voxels: Qubicle, Goxel, binvox, and those of Slab6 and Voxlap.

pub(crate) mod binvox;
pub(crate) mod goxel;
pub(crate) mod qubicle;
pub(crate) mod slab6;
pub(crate) mod voxlap;
