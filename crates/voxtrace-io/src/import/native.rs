//! voxtrace's own packed scenes, `.vxt`: a file is mapped, or read into memory where somebody asks for that.

use super::reader::{Data, ImportOptions, Kind, Magic, Reader};
use super::source::Source;
use std::path::Path;
use voxtrace_core::packed::{self, FileErrorKind, PackedScene};
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("voxtrace", Kind::Packed, &["vxt"], "voxtrace scene, packed, opened without copying", read)
        .with_magic(&[Magic::first(&packed::MAGIC)])
        .with_up_axis(None);

/// Opens a scene, of any size.
fn read(source: Source, options: &ImportOptions) -> Result<Data, ImportError> {
    let path = source.path();
    let (mut input, _) = source.into_input()?;
    let scene = match input.file()? {
        Some(file) if options.in_memory => PackedScene::read_file(&file),
        Some(file) => PackedScene::map_file(&file),
        None => {
            input.set_limit(&options.limits)?;
            PackedScene::from_bytes(&input.rest()?)
        }
    };
    Ok(Data::Packed(Box::new(scene.map_err(|kind| error_of(path, kind))?)))
}

fn error_of(path: &Path, kind: FileErrorKind) -> ImportError {
    let offset = match &kind {
        FileErrorKind::NotVoxtrace => Some(0),
        FileErrorKind::Version(_) => Some(8),
        FileErrorKind::Damaged { offset, .. } => Some(*offset),
        _ => None,
    };
    match kind {
        FileErrorKind::Io(error) => ImportError::io(path, error),
        kind => ImportError::of_file(path, ImportErrorKind::Native(kind)).with_offset(offset),
    }
}
