//! Samples without a header.

use crate::import::reader::{Kind, RawShape, Reader, Recognition};
use crate::import::samples::{Layout, checked_size};
use crate::import::source::input::Input;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// The shape that somebody gives makes any file one of these.
pub(crate) const READER: Reader = Reader::new(
    "raw samples",
    Kind::Volume,
    &["raw"],
    "samples without a header: `--raw-shape` says how many there are, and of what kind",
    |source, options| Ok(read(source.into_input()?.0, options.raw, &options.limits)?.into()),
)
.with_recognition(|clues| if clues.options.raw.is_some() { Recognition::Sure } else { Recognition::Unknown });

/// Reads samples of a known shape.
fn read(mut input: Input, shape: Option<RawShape>, limits: &Limits) -> Result<Volume, ImportError> {
    let path = input.path();
    let Some(shape) = shape else {
        let what = "samples without a header need a shape: --raw-shape 512x512x300:u16le";
        return Err(ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into())));
    };
    let size = checked_size(path, 0, shape.size, limits)?;
    input.skip(shape.skip, "the bytes to skip")?;
    let layout =
        Layout { sample: shape.sample, big_endian: shape.big_endian, size, components: 1, rescale: (1.0, 0.0) };
    let values = layout.read(&mut input)?;
    let mut volume = Volume::new(size, values);
    if let Some(left @ 1..) = input.remaining() {
        volume.notes.push(format!("{left} bytes behind the samples are left out"));
    }
    Ok(volume)
}
