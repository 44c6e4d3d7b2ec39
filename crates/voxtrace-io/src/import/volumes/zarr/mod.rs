//! Zarr, versions 2 and 3 ("Zarr storage specification version 2", "Zarr core specification version 3", zarr-specs), and
//! OME-Zarr 0.4 and 0.5 (Moore et al., "OME-Zarr: a cloud-optimized bioimaging file format", 2023): of the levels of a picture
//! the one that suits the wanted resolution. Nothing outside of the folder is read.

pub(super) mod blosc;
mod chunks;
mod codec;
mod entries;
mod metadata;
mod multiscale;
mod shard;

use crate::import::reader::{ImportOptions, Kind, Reader};
use crate::import::source::folder::{Folder, Refused};
use glam::{DAffine3, DMat3, DVec3};
use metadata::Array;
use multiscale::{Level, levels};
use serde_json::Value;
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::voxelize::Scale;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("Zarr", Kind::Volume, &["zarr"], "Zarr 2 and 3, OME-Zarr: a folder", |source, options| {
        if !source.is_folder() {
            let what = "the file holds no volume";
            return Err(ImportError::at(source.path(), 0, ImportErrorKind::Unsupported(what.into())));
        }
        Ok(read(source.path(), options)?.into())
    })
    .with_folders(|clues| Ok(MARKS.iter().any(|mark| clues.path.join(mark).is_file())));

/// Files that a folder of this format has, of either version.
const MARKS: [&str; 4] = ["zarr.json", ".zarray", ".zgroup", ".zattrs"];
/// Most samples that are read where nobody says how many voxels there are to be.
const MANY: u64 = 512 * 512 * 512;
/// Names of arrays that a group without a list is searched for.
const USUAL: [&str; 6] = ["0", "s0", "data", "volume", "image", "array"];

/// Reads a folder; the scale that is asked for helps to choose among levels.
fn read(path: &Path, options: &ImportOptions) -> Result<Volume, ImportError> {
    let (scale, limits) = (options.volume.scale, &options.limits);
    let store = Store { path, folder: Folder::at(path, limits) };
    let (level, notes, unit) = match Array::read(&store, "", limits)? {
        Some(array) => (Level::alone(array), Vec::new(), Unit::Voxel),
        None => choose(&store, scale, limits)?,
    };
    let mut volume = entries::read(&store, &level, options)?;
    let spacing = DVec3::from_array(level.spacing);
    let origin = DVec3::from_array(level.origin);
    crate::import::samples::place(
        &mut volume,
        DAffine3 { matrix3: DMat3::from_diagonal(spacing), translation: origin },
        spacing,
    );
    volume.unit = unit;
    volume.notes.splice(0..0, notes);
    Ok(volume)
}

/// The level of a group's picture that suits, or the first array with a usual name.
fn choose(store: &Store, scale: Option<Scale>, limits: &Limits) -> Result<(Level, Vec<String>, Unit), ImportError> {
    let Some((levels, unit)) = levels(store, limits)? else {
        for name in USUAL {
            if let Some(array) = Array::read(store, name, limits)? {
                return Ok((
                    Level::alone(array),
                    vec![format!("the array {name:?} of the group is read")],
                    Unit::Voxel,
                ));
            }
        }
        return Err(store.malformed("", "a group without a picture: name one of its arrays' folders"));
    };
    let suits = |level: &Level| {
        let [x, y, z] = level.size();
        let lengths = [x, y, z].map(|size| size as f64);
        let longest = lengths[0].max(lengths[1]).max(lengths[2]);
        match scale {
            Some(Scale::Resolution(count)) => longest >= f64::from(count),
            Some(Scale::VoxelSize(size)) => level.spacing.iter().all(|&spacing| spacing <= size * 1.001),
            None | Some(Scale::Automatic) => x.saturating_mul(y).saturating_mul(z) <= MANY,
        }
    };
    let count = levels.len();
    // From fine to coarse: where none is asked for, the first that is not too large, else the last that is fine enough.
    let at = match scale {
        None | Some(Scale::Automatic) => levels.iter().position(suits).unwrap_or(count - 1),
        Some(_) => levels.iter().rposition(suits).unwrap_or(0),
    };
    let notes = match levels.into_iter().nth(at) {
        Some(level) => {
            let [x, y, z] = level.size();
            let note = format!("level {at} of {count} is read: {x} x {y} x {z} samples");
            (level, if count > 1 { vec![note] } else { Vec::new() }, unit)
        }
        None => return Err(store.malformed("", "a picture without levels")),
    };
    Ok(notes)
}

/// A folder of Zarr, whose files are asked for by name.
struct Store<'a> {
    path: &'a Path,
    folder: Folder,
}

impl Store<'_> {
    /// The bytes of a file, `None` where there is none.
    fn get(&self, name: &str) -> Result<Option<Vec<u8>>, ImportError> {
        match self.folder.read(name) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(Refused::Io { error, .. }) if is_absent(error.kind()) => Ok(None),
            Err(Refused::Io { name, error }) => Err(ImportError::io(&self.path.join(name), error)),
            Err(refused) => Err(self.malformed(name, &refused.to_string())),
        }
    }

    /// A file of JSON, `None` where there is none.
    fn json(&self, name: &str) -> Result<Option<Value>, ImportError> {
        let Some(bytes) = self.get(name)? else { return Ok(None) };
        match serde_json::from_slice(&bytes) {
            Ok(value) => Ok(Some(value)),
            Err(error) => Err(self.malformed(name, &error.to_string())),
        }
    }

    fn malformed(&self, name: &str, what: &str) -> ImportError {
        ImportError::malformed(&self.path.join(name), 0, what)
    }

    fn unsupported(&self, name: &str, what: String) -> ImportError {
        ImportError::at(&self.path.join(name), 0, ImportErrorKind::Unsupported(what))
    }
}

fn is_absent(kind: std::io::ErrorKind) -> bool {
    matches!(kind, std::io::ErrorKind::NotFound | std::io::ErrorKind::NotADirectory)
}

/// The name of a file in an array's folder.
fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() { name.into() } else { format!("{}/{name}", folder.trim_end_matches('/')) }
}
