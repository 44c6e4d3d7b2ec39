//! Models of voxels: Qubicle, Slab6 and binvox.

pub(crate) mod binvox;
pub(crate) mod qubicle;
pub(crate) mod slab6;
