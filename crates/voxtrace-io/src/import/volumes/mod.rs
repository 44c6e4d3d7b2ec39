//! Volumes: NRRD, MetaImage, NumPy arrays, raw samples, OpenVDB and Zarr.

pub(crate) mod metaimage;
pub(crate) mod npy;
pub(crate) mod nrrd;
pub(crate) mod raw;
pub(crate) mod vdb;
pub(crate) mod zarr;
