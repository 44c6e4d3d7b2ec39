//! MetaImage, `.mha` and `.mhd` ("MetaIO", Insight Software Consortium): text header, then samples raw or zlib, in the same
//! file or in one beside it.

use crate::import::reader::{ImportOptions, Kind, Reader};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, Sample, checked_size, entries};
use crate::import::samples::{detached, place};
use crate::import::source::folder::Folder;
use crate::import::source::inflate::Packing;
use crate::import::source::input::Input;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "MetaImage",
    Kind::Volume,
    &["mha", "mhd"],
    "MetaImage volume, and .mhd: raw, zlib or text",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(stored(input, &folder, options)?.read(options)?.into())
    },
)
.with_large_volumes(|source, options| {
    let (input, folder) = source.into_input()?;
    stored(input, &folder, options)?.large()
});

/// Most axes that a file may have.
const MOST_AXES: usize = 10;

/// What of a header is used.
struct Header {
    size: Vec<u64>,
    kind: Option<String>,
    channels: usize,
    big_endian: bool,
    compressed: bool,
    text: bool,
    skip: i64,
    spacing: Vec<f64>,
    /// Direction of each axis, one after the other.
    axes: Vec<f64>,
    origin: Vec<f64>,
    /// Millimetres of the unit of lengths.
    unit: f64,
    data_file: Option<String>,
}

/// A MetaImage.
fn stored<'a>(mut input: Input<'a>, folder: &Folder, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let header = Header::read(&mut input)?;
    let end = input.offset();
    let malformed = |what: &str| ImportError::malformed(path, end, what);
    let unsupported = |what: String| ImportError::at(path, end, ImportErrorKind::Unsupported(what));
    if header.size.is_empty() {
        return Err(malformed("a MetaImage header without DimSize"));
    }
    let size = std::array::from_fn(|n| header.size.get(n).copied().unwrap_or(1));
    let size = checked_size(path, input.offset(), size, limits)?;
    let kind = header.kind.as_deref().ok_or_else(|| malformed("a MetaImage header without ElementType"))?;
    let sample = sample_of(kind).ok_or_else(|| unsupported(format!("samples of type {kind:?}")))?;
    let layout =
        Layout { sample, big_endian: header.big_endian, size, components: header.channels, rescale: (1.0, 0.0) };
    let name = header.data_file.as_deref().ok_or_else(|| malformed("a MetaImage header without ElementDataFile"))?;
    let mut own = path.to_path_buf();
    if !name.eq_ignore_ascii_case("local") {
        if name.starts_with("LIST") || name.contains('%') {
            return Err(unsupported("data in several files".into()));
        }
        (input, own) = detached(path, end, folder, name, limits)?;
    }
    let volumes = header.size.iter().skip(3).try_fold(1u64, |all, &size| all.checked_mul(size)).unwrap_or(u64::MAX);
    let skip = match (header.skip, input.remaining()) {
        // From the end.
        (-1, Some(remaining)) => {
            let count = size.iter().map(|&size| size as u64).product::<u64>().saturating_mul(volumes);
            remaining.saturating_sub(count.saturating_mul((sample.size() * header.channels) as u64))
        }
        (skip, _) => u64::try_from(skip).map_err(|_| malformed("an impossible HeaderSize"))?,
    };
    let from = input.offset();
    while input.offset() - from < skip {
        let now = (skip - (input.offset() - from)).min(1 << 16) as usize;
        input.take(now, "the bytes to skip")?;
    }
    let packing = if header.compressed { Packing::Zlib } else { Packing::Plain };
    let start = if header.compressed { input.offset() } else { 0 };
    input = packing.unpack(input, limits);
    let note = entries::skip_to_time(&mut input, &layout, volumes, header.text, options)?;
    let mut frame = Volume { size, unit: Unit::Millimetre, ..Volume::new([1; 3], Vec::new()) };
    frame.notes.extend(note);
    header.place(&mut frame);
    let file = PackedFile { path: own, packing, start };
    Ok(Stored { input, layout, is_text: header.text, frame, file: Some(file), planes: 1, channel: options.channel })
}

fn sample_of(kind: &str) -> Option<Sample> {
    Some(match kind {
        "MET_CHAR" => Sample::I8,
        "MET_UCHAR" => Sample::U8,
        "MET_SHORT" => Sample::I16,
        "MET_USHORT" => Sample::U16,
        "MET_INT" | "MET_LONG" => Sample::I32,
        "MET_UINT" | "MET_ULONG" => Sample::U32,
        "MET_LONG_LONG" => Sample::I64,
        "MET_ULONG_LONG" => Sample::U64,
        "MET_FLOAT" => Sample::F32,
        "MET_DOUBLE" => Sample::F64,
        _ => return None,
    })
}

impl Header {
    fn read(input: &mut Input) -> Result<Self, ImportError> {
        let path = input.path();
        let mut header = Self {
            size: Vec::new(),
            kind: None,
            channels: 1,
            big_endian: false,
            compressed: false,
            text: false,
            skip: 0,
            spacing: Vec::new(),
            axes: Vec::new(),
            origin: Vec::new(),
            unit: 1.0,
            data_file: None,
        };
        while header.data_file.is_none() {
            let start = input.offset();
            let Some(line) = input.line()? else { break };
            let line = String::from_utf8_lossy(line).into_owned();
            if line.trim().is_empty() {
                continue;
            }
            let malformed = |what: String| ImportError::malformed(path, start, what);
            let Some((key, value)) = line.split_once('=') else {
                return Err(malformed("a line of the header without an equals sign".into()));
            };
            let (key, value) = (key.trim(), value.trim());
            let wrong = || malformed(format!("{key}: {value:?} makes no sense"));
            // As MetaIO does, which looks at the first letter.
            let is_true = value.starts_with(['T', 't', '1']);
            let reals = || {
                let all: Option<Vec<f64>> = value.split_whitespace().map(|word| word.parse().ok()).collect();
                all.filter(|all| all.len() <= MOST_AXES * MOST_AXES).ok_or_else(wrong)
            };
            match key {
                "DimSize" => {
                    let size: Option<Vec<u64>> = value.split_whitespace().map(|word| word.parse().ok()).collect();
                    header.size = size.filter(|size| (1..=MOST_AXES).contains(&size.len())).ok_or_else(wrong)?;
                }
                "ElementType" => header.kind = Some(value.into()),
                "ElementNumberOfChannels" => {
                    header.channels = value.parse().ok().filter(|n| (1..=4096).contains(n)).ok_or_else(wrong)?;
                }
                "ElementByteOrderMSB" | "BinaryDataByteOrderMSB" => header.big_endian = is_true,
                "CompressedData" => header.compressed = is_true,
                "BinaryData" => header.text = !is_true,
                "HeaderSize" => header.skip = value.parse().map_err(|_| wrong())?,
                "ElementSpacing" => header.spacing = reals()?,
                // Size is what spacing is where only it is given.
                "ElementSize" if header.spacing.is_empty() => header.spacing = reals()?,
                "TransformMatrix" | "Rotation" | "Orientation" => header.axes = reals()?,
                "Offset" | "Position" | "Origin" => header.origin = reals()?,
                "DistanceUnits" => {
                    header.unit = match value {
                        "um" => 1e-3,
                        "cm" => 10.0,
                        _ => 1.0,
                    };
                }
                "ElementDataFile" => header.data_file = Some(value.into()),
                _ => {}
            }
        }
        Ok(header)
    }

    fn place(&self, volume: &mut Volume) {
        let pick = |all: &[f64], n: usize, otherwise: f64| all.get(n).copied().unwrap_or(otherwise);
        let spacing = DVec3::from_array([0, 1, 2].map(|n| pick(&self.spacing, n, 1.0))) * self.unit;
        let dimensions = self.size.len();
        let axes = if dimensions >= 3 && self.axes.len() == dimensions * dimensions {
            // Rows of the file are the directions of the axes.
            let axis = |n: usize| DVec3::from_array([0, 1, 2].map(|m| self.axes[n * dimensions + m])) * spacing[n];
            DMat3::from_cols(axis(0), axis(1), axis(2))
        } else {
            DMat3::from_diagonal(spacing)
        };
        let origin = DVec3::from_array([0, 1, 2].map(|n| pick(&self.origin, n, 0.0))) * self.unit;
        // The world of MetaImage is left, posterior, superior, as ours.
        place(volume, DAffine3 { matrix3: axes, translation: origin }, spacing);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn truths_are_told_by_their_first_letter_and_lengths_have_their_unit() {
        let read = |fields: &str| {
            let text = format!(
                "NDims = 3\nDimSize = 2 1 1\nElementSpacing = 2 3 4\nOffset = 10 0 0\n{fields}\nElementType = MET_USHORT\nElementDataFile = LOCAL\n"
            );
            let bytes = [text.as_bytes(), &[0, 1, 2, 0]].concat();
            let (options, path) = (ImportOptions::default(), Path::new("a.mha"));
            let input = Input::of_bytes(&bytes, path, &options.limits).unwrap();
            stored(input, &Folder::none(), &options).unwrap().read(&options).unwrap()
        };
        for (truth, wanted) in [("True", [1.0, 512.0]), ("T", [1.0, 512.0]), ("1", [1.0, 512.0]), ("F", [256.0, 2.0])] {
            assert_eq!(read(&format!("ElementByteOrderMSB = {truth}")).values, wanted, "{truth}");
        }
        for (unit, factor) in [("mm", 1.0), ("um", 1e-3), ("cm", 10.0), ("?", 1.0)] {
            let place = read(&format!("DistanceUnits = {unit}")).world_from_index;
            let found = [place.matrix3.x_axis.x, place.matrix3.z_axis.z, place.translation.x];
            let wanted = [2.0, 4.0, 10.0].map(|length| length * factor);
            assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{unit}: {found:?}");
        }
    }
}
