//! Volumes of medicine: NIfTI and DICOM.

pub(crate) mod dicom;
pub(crate) mod nifti;
