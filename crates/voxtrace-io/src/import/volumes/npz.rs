//! Archives of NumPy arrays, `.npz` (`numpy.savez`, `numpy.savez_compressed`): a ZIP of `.npy` files, of which one is a volume.

use super::npy;
use crate::import::reader::{ImportOptions, Kind, Reader, Several};
use crate::import::samples::channels::entry;
use crate::import::source::archive::Archive;
use crate::import::source::input::Input;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "NumPy archive",
    Kind::Volume,
    &["npz"],
    "NumPy arrays in a ZIP: the one with the most bytes, or the one that --series numbers",
    |source, options| Ok(read(source.into_input()?.0, options)?.into()),
)
.with_several(&[Several::Series, Several::Channels, Several::TimePoints]);

/// Reads an array of an archive.
fn read(input: Input, options: &ImportOptions) -> Result<Volume, ImportError> {
    let path = input.path();
    let archive = Archive::open(input, &options.limits)?;
    let mut names = archive.names();
    names.retain(|name| name.ends_with(".npy"));
    let refused = |what: String| ImportError::at(path, 0, ImportErrorKind::Unsupported(what));
    let plain = |name: &str| name.trim_end_matches(".npy").to_owned();
    let all: Vec<String> = names.iter().map(|name| plain(name)).collect();
    let (name, note) = match options.series {
        Some(number) => {
            let (place, _) = entry(Some(u32::try_from(number).unwrap_or(0)), names.len(), "array", "--series")
                .map_err(|what| refused(format!("{what}: {}", all.join(", "))))?;
            (names[place].clone(), None)
        }
        None => {
            let largest = names.iter().rev().max_by_key(|name| archive.size(name));
            let name = largest.ok_or_else(|| refused("an archive that holds no array".into()))?.clone();
            let note = (names.len() > 1).then(|| {
                format!(
                    "the array {:?} is read; --series 1 to {} chooses one of {}",
                    plain(&name),
                    all.len(),
                    all.join(", ")
                )
            });
            (name, note)
        }
    };
    let bytes = archive.get(&name)?.ok_or_else(|| refused(format!("{name}: there is no such array")))?;
    let mut volume = npy::stored(Input::of_owned(bytes, path, &options.limits), options)?.read(options)?;
    volume.notes.extend(note);
    Ok(volume)
}
