//! DICOM (PS3 of the standard, 2024): one file, or the series in a folder that has the most pictures. Plain pixels, run
//! lengths, JPEG (8 and 12 bits, lossless with up to 16), JPEG-LS and JPEG 2000 are read; other compressions are errors that name them.

mod elements;
mod jpeg_12;
mod jpeg_ls;
mod markers;
mod mosaic;
mod orientations;
mod pack_bits;
mod palette;
mod pixels;
mod series;
mod stack;
mod syntax;
mod tag;
mod values;

use crate::import::reader::{ImportOptions, Kind, Magic, NotShown, Reader, Several};
use crate::import::samples::checked_size;
use crate::import::source::input::Input;
use elements::File;
use glam::DVec3;
use mosaic::Mosaic;
use palette::Palette;
use pixels::Layout;
use stack::Slice;
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::{Preset, Volume};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "DICOM",
    Kind::Volume,
    &["dcm"],
    "DICOM, or name the folder of a series, one above it, or a DICOMDIR",
    |source, options| Ok(series::read(source, options)?.into()),
)
.with_magic(&[MAGIC])
.with_folders(series::is_in)
.with_several(&[Several::Series, Several::TimePoints]);

/// First bytes after the preamble of 128.
const MAGIC: Magic = Magic { offset: 128, bytes: b"DICM" };

fn unsupported(path: &Path, at: u64, what: String) -> ImportError {
    ImportError::at(path, at, ImportErrorKind::Unsupported(what))
}

/// Plans, waveforms, reports and the like are sound, but there is nothing to see in them.
fn without_pixels(path: &Path, file: &File, at: u64) -> ImportError {
    let kind = file.main.text(tag::MODALITY).map_or(String::new(), |modality| format!(" (modality {modality})"));
    unsupported(path, at, format!("an object without pixels{kind}"))
}

/// Reads the frames of one file.
pub(super) fn read(input: Input, options: &ImportOptions) -> Result<Volume, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let file = File::read(input, limits, true)?;
    let layout = Layout::of(path, &file, limits)?;
    let size = [layout.columns, layout.rows, layout.frames].map(|size| size as u64);
    checked_size(path, file.pixels_at, size, limits)?;
    let slices = slices(path, &file, &layout, limits)?;
    volume(path, &file, slices, options.series, options)
}

/// The frames of a file, with their values rescaled.
fn slices(path: &Path, file: &File, layout: &Layout, limits: &Limits) -> Result<Vec<Slice>, ImportError> {
    let number = file.main.decimal(tag::INSTANCE_NUMBER).unwrap_or(0.0);
    // Doses have their frames at distances from the first (PS3.3, C.8.8.3.2).
    let offsets = file.main.decimals(tag::FRAME_OFFSETS).unwrap_or_default();
    let palette = Palette::of(file);
    let mosaic = Mosaic::of(file, layout.columns, layout.rows);
    let are_labels = are_labels(file);
    // A place belongs to a segment where half of it does, or where it is so at least as likely as not (PS3.3, C.8.20.2.3).
    let whole = file.main.short(tag::WHOLE_SHARE).filter(|&whole| whole > 0).unwrap_or(255);
    let half = if are_shares(file) { f32::from(whole) / 2.0 } else { 0.5 };
    let mut slices = Vec::with_capacity(layout.frames);
    for (frame, mut values) in layout.decode(path, file, limits)?.into_iter().enumerate() {
        if let Some(palette) = &palette {
            palette.apply(&mut values);
        }
        let of_frame = |tag| file.of_frame(frame, |elements| elements.decimal(tag));
        let slope = of_frame(tag::SLOPE).or(of_frame(tag::DOSE_SCALING)).filter(|&slope| slope != 0.0).unwrap_or(1.0);
        let intercept = of_frame(tag::INTERCEPT).unwrap_or(0.0);
        if (slope, intercept) != (1.0, 0.0) {
            values.iter_mut().for_each(|value| *value = (f64::from(*value) * slope + intercept) as f32);
        }
        if are_labels && let Some(segment) = file.of_frame(frame, |elements| elements.short(tag::SEGMENT)) {
            // Pixels say only whether a place belongs to the segment of the frame (PS3.3, C.8.20.2).
            values.iter_mut().for_each(|value| *value = if *value >= half { segment.into() } else { 0.0 });
        }
        let (x, y) = directions(file, frame);
        let mut position = vector(file, frame, tag::POSITION, 0);
        if let (Some(position), Some(offset)) = (&mut position, offsets.get(frame)) {
            // Those of the first kind begin with 0, others are coordinates themselves.
            *position += x.cross(y) * (offset - offsets.first().copied().unwrap_or(0.0));
        }
        let slice = Slice { position, directions: (x, y), number, frame, values };
        match mosaic {
            Some(mosaic) => {
                let ([across, down], distance) = spacing(file, frame);
                slices.extend(mosaic.slices(&slice, DVec3::new(across, down, distance.unwrap_or(across))));
            }
            None => slices.push(slice),
        }
    }
    Ok(slices)
}

/// Whether samples become the numbers of segments: shares of a single one stay what they are.
fn are_labels(file: &File) -> bool {
    let mut segments =
        (0..file.frames.len()).map(|frame| file.of_frame(frame, |elements| elements.short(tag::SEGMENT)));
    let first = segments.next();
    file.main.text(tag::MODALITY) == Some("SEG") && (!are_shares(file) || segments.any(|other| Some(other) != first))
}

/// Whether the samples of a segmentation say how much of a place belongs to a segment, or how likely it does.
fn are_shares(file: &File) -> bool {
    file.main.text(tag::SEGMENTATION) == Some("FRACTIONAL")
}

/// Three numbers of a frame, from the nth on.
fn vector(file: &File, frame: usize, tag: u32, from: usize) -> Option<DVec3> {
    let numbers = file.of_frame(frame, |elements| elements.decimals(tag))?;
    Some(DVec3::from_slice(numbers.get(from..from + 3)?))
}

/// The directions in which columns and rows are counted, of length 1 and perpendicular.
fn directions(file: &File, frame: usize) -> (DVec3, DVec3) {
    let x = vector(file, frame, tag::ORIENTATION, 0).and_then(DVec3::try_normalize).unwrap_or(DVec3::X);
    let y = vector(file, frame, tag::ORIENTATION, 3).unwrap_or(DVec3::Y);
    let y = (y - x * y.dot(x)).try_normalize().unwrap_or_else(|| x.any_orthonormal_vector());
    (x, y)
}

/// How far directions are apart, by their most different coordinate.
fn apart(one: (DVec3, DVec3), other: (DVec3, DVec3)) -> f64 {
    (one.0 - other.0).abs().max((one.1 - other.1).abs()).max_element()
}

/// Whether directions are one, but for the last digits that files round them to.
fn are_alike(one: (DVec3, DVec3), other: (DVec3, DVec3)) -> bool {
    apart(one, other) < 1e-3
}

/// Which of some directions these are: of several that are alike the nearest, since those two need not be one.
fn place_of(own: (DVec3, DVec3), all: impl Iterator<Item = (DVec3, DVec3)>) -> Option<usize> {
    let alike = all.enumerate().filter(|&(_, other)| are_alike(own, other));
    alike.min_by(|a, b| apart(own, a.1).total_cmp(&apart(own, b.1))).map(|(place, _)| place)
}

/// How far columns, rows and slices of a frame are apart, in millimetres, where it says so.
fn spacing(file: &File, frame: usize) -> ([f64; 2], Option<f64>) {
    let is_distance = |&distance: &f64| (1e-6..1e6).contains(&distance);
    let numbers = file.of_frame(frame, |elements| elements.decimals(tag::PIXEL_SPACING));
    // Rows are apart by the first number, columns by the second.
    let pixels = match numbers.as_deref() {
        Some([rows, columns, ..]) if is_distance(rows) && is_distance(columns) => [*columns, *rows],
        _ => [1.0, 1.0],
    };
    let of_frame = |tag| file.of_frame(frame, |elements| elements.decimal(tag)).filter(is_distance);
    (pixels, of_frame(tag::SLICE_DISTANCE).or(of_frame(tag::SLICE_THICKNESS)))
}

/// A volume of slices that all look like those of `file`. Of those in several directions `number` says which are stacked.
fn volume(
    path: &Path,
    file: &File,
    slices: Vec<Slice>,
    number: Option<i64>,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let (slices, note) =
        orientations::choose(slices, number).map_err(|what| unsupported(path, file.pixels_at, what))?;
    let Some(first) = slices.first() else {
        return Err(without_pixels(path, file, file.pixels_at));
    };
    let mut frame = first.frame;
    let short = |tag| usize::from(file.main.short(tag).unwrap_or(0));
    let (mut columns, mut rows) = (short(tag::COLUMNS), short(tag::ROWS));
    if let Some(mosaic) = Mosaic::of(file, columns, rows) {
        (columns, rows, frame) = (mosaic.columns, mosaic.rows, 0);
    }
    let (spacing, distance) = spacing(file, frame);
    let are_labels = are_labels(file);
    let plane = stack::Plane { columns, rows, directions: first.directions, spacing, distance, are_labels };
    let mut volume = stack::volume(path, file.pixels_at, &plane, slices, options)?;
    volume.notes.extend(note);
    let mut parts = NotShown::default();
    parts.count("overlay", file.overlays.into());
    volume.notes.extend(parts.note());
    volume.unit = Unit::Millimetre;
    volume.is_labels = are_labels;
    volume.suited = match file.main.text(tag::MODALITY) {
        Some("CT") => Some(Preset::CtBone),
        Some("MR") => Some(Preset::Mri),
        _ => None,
    };
    Ok(volume)
}
