//! Samples without a header.

use crate::import::reader::{ImportOptions, Kind, RawShape, Reader, Recognition};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, checked_size};
use crate::import::source::inflate::Packing;
use crate::import::source::input::Input;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// The shape that somebody gives makes any file one of these.
pub(crate) const READER: Reader = Reader::new(
    "raw samples",
    Kind::Volume,
    &["raw"],
    "samples without a header: `--raw-shape` says how many there are, and of what kind",
    |source, options| Ok(stored(source.into_input()?.0, options)?.read(options)?.into()),
)
.with_recognition(|clues| if clues.options.raw.is_some() { Recognition::Sure } else { Recognition::Unknown })
.with_large_volumes(|source, options| stored(source.into_input()?.0, options)?.large())
.with_several(&[]);

/// Samples of a known shape.
fn stored<'a>(mut input: Input<'a>, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let path = input.path();
    let Some(shape) = options.raw else {
        let what = "samples without a header need a shape: --raw-shape 512x512x300:u16le";
        return Err(ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into())));
    };
    let size = checked_size(path, 0, shape.size, &options.limits)?;
    let RawShape { sample, big_endian, skip, .. } = shape;
    let file = PackedFile { path: path.into(), packing: Packing::Plain, start: 0 };
    input.skip(skip, "the bytes to skip")?;
    let layout = Layout { sample, big_endian, size, components: 1, rescale: (1.0, 0.0) };
    let mut frame = Volume { size, ..Volume::new([1; 3], Vec::new()) };
    if let Some(left @ 1..) = input.remaining().map(|there| there.saturating_sub(layout.bytes())) {
        frame.notes.push(format!("{left} bytes behind the samples are left out"));
    }
    Ok(Stored { input, layout, is_text: false, frame, file: Some(file), planes: 1, channel: None })
}
