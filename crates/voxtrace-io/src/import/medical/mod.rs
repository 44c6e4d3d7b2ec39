//! Volumes of medicine: NIfTI and Analyze, FreeSurfer, PAR/REC and DICOM.

mod analyze;
pub(crate) mod dicom;
pub(crate) mod mgh;
pub(crate) mod nifti;
pub(crate) mod parrec;
