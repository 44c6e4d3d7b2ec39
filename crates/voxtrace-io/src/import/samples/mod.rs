//! What readers of volumes share: samples of any kind, their place in the world, data beside a header.

pub(crate) mod channels;
mod convert;
pub(crate) mod entries;
mod file_samples;
pub(crate) mod stored;

pub(crate) use super::reader::Sample;
pub(crate) use convert::Layout;
pub(crate) use convert::checked_size;
#[cfg(feature = "volumes")]
pub(crate) use convert::real_of_half;

use super::source::folder::{Folder, Refused};
use super::source::input::Input;
use glam::{DAffine3, DMat3, DVec3};
use std::path::{Path, PathBuf};
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Puts the lattice into the world, or where the file's numbers make no sense, keeps the spacing and says so.
pub(crate) fn place(volume: &mut Volume, world_from_index: DAffine3, spacing: DVec3) {
    volume.world_from_index = world_from_index;
    if volume.validate_lattice().is_ok() {
        return;
    }
    volume.notes.push("the file's axes are impossible: samples lie along x, y and z".into());
    let is_good = |length: f64| length.is_finite() && (1e-9..1e9).contains(&length);
    let spacing = DVec3::from_array(spacing.to_array().map(|s| if is_good(s.abs()) { s.abs() } else { 1.0 }));
    volume.world_from_index = DAffine3::from_mat3(DMat3::from_diagonal(spacing));
}

/// The data of a detached header, which names it where `offset` is, and its file.
pub(crate) fn detached<'a>(
    path: &'a Path,
    offset: u64,
    folder: &Folder,
    name: &str,
    limits: &Limits,
) -> Result<(Input<'a>, PathBuf), ImportError> {
    let opened = folder.open(name).map_err(|refused| {
        let kind = match refused {
            Refused::Io { name, error } => {
                ImportErrorKind::Io(std::io::Error::new(error.kind(), format!("{name}: {error}")))
            }
            refused => ImportErrorKind::Malformed(refused.to_string()),
        };
        ImportError::at(path, offset, kind)
    });
    let (file, own) = opened?;
    Ok((Input::of_file(file, path, limits)?, own))
}
