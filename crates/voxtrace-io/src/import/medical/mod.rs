//! Volumes of medicine: NIfTI and DICOM.

pub(crate) mod dicom;
mod analyze;
pub(crate) mod mgh;
pub(crate) mod nifti;
