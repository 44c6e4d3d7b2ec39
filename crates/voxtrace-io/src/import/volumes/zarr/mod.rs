//! Zarr, versions 2 and 3 ("Zarr storage specification version 2", "Zarr core specification version 3", zarr-specs), and
//! OME-Zarr 0.4 and 0.5 (Moore et al., "OME-Zarr: a cloud-optimized bioimaging file format", 2023): of the levels of a picture
//! the one that suits the wanted resolution. Also N5. Nothing outside of the folder or archive is read.

pub(super) mod blosc;
mod chunk_samples;
mod chunks;
mod codec;
mod entries;
mod metadata;
mod multiscale;
mod n5;
mod shard;
mod store;

use crate::import::reader::{ImportOptions, Kind, Reader};
use crate::import::source::Source;
use crate::import::source::archive::Archive;
use chunk_samples::ChunkSamples;
use glam::{DAffine3, DMat3, DVec3};
use metadata::Array;
use multiscale::{Level, levels};
use store::Store;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::volume::large::SampleSource;
use voxtrace_voxelize::voxelize::Scale;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "Zarr",
    Kind::Volume,
    &["zarr", "zarr.zip", "zip", "n5"],
    "Zarr 2 and 3, OME-Zarr and N5: a folder, or a ZIP archive of Zarr",
    |source, options| Ok(read(&store(source, options)?, options)?.into()),
)
.with_folders(|clues| Ok(MARKS.iter().any(|mark| clues.path.join(mark).is_file())))
.with_large_volumes(|source, options| large(store(source, options)?, options));

/// Files of metadata, of which a folder of this format has one.
const MARKS: [&str; 5] = ["zarr.json", ".zarray", ".zgroup", ".zattrs", n5::ATTRIBUTES];
/// Most samples that are read where nobody says how many voxels there are to be.
const MANY: u64 = 512 * 512 * 512;
/// Names of arrays that a group without a list is searched for.
const USUAL: [&str; 6] = ["0", "s0", "data", "volume", "image", "array"];

/// The files of a folder or an archive.
fn store(source: Source, options: &ImportOptions) -> Result<Store, ImportError> {
    if source.is_folder() {
        return Ok(Store::at(source.path(), &options.limits));
    }
    let path = source.path();
    let (mut input, _) = source.into_input()?;
    if !input.peek(2)?.starts_with(b"PK") {
        let what = "the file holds no volume: Zarr is a folder, or a ZIP archive of one";
        return Err(ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into())));
    }
    Store::of_archive(Archive::open(input, &options.limits)?)
}

/// The level that is read, with what there is to say about it; the scale that is asked for helps to choose.
fn level(store: &Store, options: &ImportOptions) -> Result<(Level, Vec<String>, Unit), ImportError> {
    match Array::read(store, "", &options.limits)? {
        Some(array) => Ok((Level::alone(array), Vec::new(), Unit::Voxel)),
        None => choose(store, options.volume.scale, &options.limits),
    }
}

/// Puts a volume where its level lies.
fn place(volume: &mut Volume, level: &Level, notes: Vec<String>, unit: Unit) {
    let (spacing, origin) = (DVec3::from_array(level.spacing), DVec3::from_array(level.origin));
    let world_from_index = DAffine3 { matrix3: DMat3::from_diagonal(spacing), translation: origin };
    crate::import::samples::place(volume, world_from_index, spacing);
    volume.unit = unit;
    volume.notes.splice(0..0, notes);
}

/// Reads a volume.
fn read(store: &Store, options: &ImportOptions) -> Result<Volume, ImportError> {
    let (level, notes, unit) = level(store, options)?;
    let mut volume = entries::read(store, &level, options)?;
    place(&mut volume, &level, notes, unit);
    Ok(volume)
}

/// Opens a volume of one channel that stays where it is.
fn large(store: Store, options: &ImportOptions) -> Result<Option<Box<dyn SampleSource>>, ImportError> {
    // However many chunks there are, each is held against what may be read at once.
    let bytes = options.limits.bytes.min(Limits::default().bytes);
    let options = &ImportOptions { limits: Limits { bytes, ..options.limits }, ..options.clone() };
    let (level, notes, unit) = level(&store, options)?;
    let Some((lattice, of_entry)) = entries::large(&store, &level, options)? else { return Ok(None) };
    let mut frame = Volume { size: lattice.size, notes: of_entry, ..Volume::new([1; 3], Vec::new()) };
    place(&mut frame, &level, notes, unit);
    Ok(Some(Box::new(ChunkSamples::new(store, level, lattice, frame))))
}

/// The level of a group's picture that suits, or the first array with a usual name.
fn choose(store: &Store, scale: Option<Scale>, limits: &Limits) -> Result<(Level, Vec<String>, Unit), ImportError> {
    let found = match levels(store, limits)? {
        Some(found) => Some(found),
        None => n5::levels(store, limits)?,
    };
    let Some((levels, unit)) = found else {
        for name in USUAL {
            if let Some(array) = Array::read(store, name, limits)? {
                return Ok((
                    Level::alone(array),
                    vec![format!("the array {name:?} of the group is read")],
                    Unit::Voxel,
                ));
            }
        }
        return Err(store.unsupported("", "a group without a picture: name one of its arrays' folders".into()));
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

/// The name of a file in an array's folder.
fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() { name.into() } else { format!("{}/{name}", folder.trim_end_matches('/')) }
}
