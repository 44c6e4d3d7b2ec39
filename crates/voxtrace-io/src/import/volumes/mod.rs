//! Volumes: NRRD, MetaImage, NumPy arrays and archives of them, raw samples, OpenVDB Zarr and N5.

pub(crate) mod metaimage;
pub(crate) mod npy;
pub(crate) mod npz;
pub(crate) mod nrrd;
pub(crate) mod raw;
pub(crate) mod vdb;
pub(crate) mod zarr;
