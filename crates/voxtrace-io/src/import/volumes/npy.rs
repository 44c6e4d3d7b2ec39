//! NumPy arrays, `.npy` versions 1 to 3 (NumPy Enhancement Proposal 1). The axis that runs fastest in memory is x.

use crate::import::reader::{ImportOptions, Kind, Magic, Reader};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, Sample, checked_size, entries};
use crate::import::source::inflate::Packing;
use crate::import::source::input::Input;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "NumPy",
    Kind::Volume,
    &["npy"],
    "NumPy array, the fastest axis is x; a fourth one is time or channels, or colours",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(stored(input, options)?.read(options)?.into())
    },
)
.with_magic(&[Magic::first(MAGIC)])
.with_large_volumes(|source, options| stored(source.into_input()?.0, options)?.large());

/// First bytes of a file.
const MAGIC: &[u8] = b"\x93NUMPY";
/// Longest header; NumPy itself refuses longer ones from strangers.
const LONGEST: usize = 10_000;

/// A NumPy array of up to four axes.
pub(super) fn stored<'a>(mut input: Input<'a>, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let head = input.take(8, "the head of an array")?;
    if !head.starts_with(MAGIC) {
        return Err(ImportError::malformed(path, 0, "the file does not begin as an array does"));
    }
    let length = match head[6] {
        1 => input.take(2, "the head of an array").map(|b| usize::from(u16::from_le_bytes([b[0], b[1]])))?,
        2 | 3 => {
            let bytes = input.take(4, "the head of an array")?;
            usize::try_from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])).unwrap_or(usize::MAX)
        }
        version => {
            let kind = ImportErrorKind::Unsupported(format!("version {version} of the format"));
            return Err(ImportError::at(path, 6, kind));
        }
    };
    let start = input.offset();
    if length > LONGEST {
        return Err(ImportError::limit(path, Some(start), "bytes of the header", length as u64, LONGEST as u64));
    }
    let header = String::from_utf8_lossy(input.take(length, "the header of an array")?).into_owned();
    let malformed = |what: &str| ImportError::malformed(path, start, what);
    let value = |key: &str| {
        let (_, after) = header.split_once(&format!("'{key}'"))?;
        Some(after.trim_start().strip_prefix(':')?.trim_start())
    };
    let kind = value("descr").and_then(|text| text.strip_prefix('\'')?.split_once('\'').map(|(kind, _)| kind));
    let kind = kind.ok_or_else(|| malformed("an array without a plain type"))?;
    let (big_endian, sample) = sample_of(kind).ok_or_else(|| {
        ImportError::at(path, start, ImportErrorKind::Unsupported(format!("an array of type {kind:?}")))
    })?;
    let is_fortran = value("fortran_order").is_some_and(|text| text.starts_with("True"));
    let shape = value("shape").and_then(|text| text.strip_prefix('(')?.split_once(')').map(|(shape, _)| shape));
    let shape = shape.ok_or_else(|| malformed("an array without a shape"))?;
    let sizes = shape.split(',').map(str::trim).filter(|word| !word.is_empty());
    let sizes: Result<Vec<u64>, _> = sizes.map(str::parse).collect();
    let mut sizes = sizes.map_err(|_| malformed("an array with an impossible shape"))?;
    if !is_fortran {
        sizes.reverse();
    }
    if sizes.is_empty() || sizes.iter().skip(4).any(|&size| size != 1) {
        let kind = ImportErrorKind::Unsupported(format!("an array of {} axes; 1 to 4 are read", sizes.len()));
        return Err(ImportError::at(path, start, kind));
    }
    // Bytes in threes or fours are the colours of samples, as pictures have them.
    let are_colors = sizes.len() == 4 && matches!((sizes[0], sample), (3 | 4, Sample::U8));
    let components = if are_colors { sizes.remove(0) as usize } else { 1 };
    let size = std::array::from_fn(|n| sizes.get(n).copied().unwrap_or(1));
    let size = checked_size(path, input.offset(), size, limits)?;
    let layout = Layout { sample, big_endian, size, components, rescale: (1.0, 0.0) };
    // Nobody says what a fourth axis is: either option chooses along it.
    let count = sizes.get(3).copied().unwrap_or(1);
    let mut options = options.clone();
    if count > 1 {
        options.time = options.time.or(options.channel.take());
    }
    let note = entries::skip_to_time(&mut input, &layout, count, false, &options)?;
    let mut frame = Volume { size, ..Volume::new([1; 3], Vec::new()) };
    frame.notes.extend(note);
    let file = PackedFile { path: path.into(), packing: Packing::Plain, start: 0 };
    Ok(Stored { input, layout, is_text: false, frame, file: Some(file), planes: 1, channel: options.channel })
}

fn sample_of(kind: &str) -> Option<(bool, Sample)> {
    let order = kind.chars().next()?;
    let sample = Sample::of_letters(kind.get(1..)?)?;
    matches!(order, '<' | '>' | '|' | '=').then_some((order == '>', sample))
}
