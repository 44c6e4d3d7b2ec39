//! Volume files: NIfTI, NRRD, MetaImage, NumPy arrays, DICOM, slices, raw samples, OpenVDB and Zarr. All end in the same samples.

pub(super) mod dicom;
pub(super) mod inflate;
mod metaimage;
mod nifti;
mod npy;
mod nrrd;
pub(super) mod pictures;
mod raw;
mod samples;
pub(super) mod slices;
pub(super) mod vdb;
pub(super) mod zarr;

use super::folder::{Folder, Refused};
use super::input::Input;
use super::{Format, ImportError, ImportErrorKind, ImportOptions, Limits};
use glam::{DAffine3, DMat3, DVec3};
pub use raw::RawShape;
use std::path::Path;
use voxtrace_voxelize::volume::Volume;

/// Reads a volume of a known format.
pub(super) fn read(
    format: Format,
    input: Input,
    folder: &Folder,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let limits = &options.limits;
    match format {
        Format::Nifti => nifti::read(input, limits),
        Format::Nrrd => nrrd::read(input, folder, limits),
        Format::MetaImage => metaimage::read(input, folder, limits),
        Format::Vdb => vdb::read(input, limits),
        Format::Npy => npy::read(input, limits),
        Format::Dicom => dicom::read(input, limits),
        Format::Slices => slices::read(input, limits),
        Format::Raw => raw::read(input, options.raw, limits),
        _ => {
            let kind = ImportErrorKind::Unsupported("the file holds no volume".into());
            Err(ImportError::at(input.path(), 0, kind))
        }
    }
}

/// Puts the lattice into the world, or where the file's numbers make no sense, keeps the spacing and says so.
fn place(volume: &mut Volume, world_from_index: DAffine3, spacing: DVec3) {
    volume.world_from_index = world_from_index;
    if volume.validate().is_ok() {
        return;
    }
    volume.notes.push("the file's axes are impossible: samples lie along x, y and z".into());
    let is_good = |length: f64| length.is_finite() && (1e-9..1e9).contains(&length);
    let spacing = DVec3::from_array(spacing.to_array().map(|s| if is_good(s.abs()) { s.abs() } else { 1.0 }));
    volume.world_from_index = DAffine3::from_mat3(DMat3::from_diagonal(spacing));
}

/// The data of a detached header, which names it where `offset` is.
fn detached<'a>(
    path: &'a Path,
    offset: u64,
    folder: &Folder,
    name: &str,
    limits: &Limits,
) -> Result<Input<'a>, ImportError> {
    if name.starts_with("LIST") || name.contains('%') {
        let kind = ImportErrorKind::Unsupported("data in several files".into());
        return Err(ImportError::at(path, offset, kind));
    }
    let bytes = folder.read(name).map_err(|refused| {
        let kind = match refused {
            Refused::Io { name, error } => {
                ImportErrorKind::Io(std::io::Error::new(error.kind(), format!("{name}: {error}")))
            }
            refused => ImportErrorKind::Malformed(refused.to_string()),
        };
        ImportError::at(path, offset, kind)
    })?;
    Ok(Input::of_owned(bytes, path, limits))
}
