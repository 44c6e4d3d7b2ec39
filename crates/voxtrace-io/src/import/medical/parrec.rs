//! Philips' research export: a `.PAR` of text, version 4 to 4.2, a line for each picture, and a `.REC` with the pictures one behind the other.
//! Places and angles are in the scanner's axes: to the back, to the head and to the left, which its files call ap, fh and rl.

use crate::import::reader::{ImportOptions, Kind, Reader, Several};
use crate::import::samples::{Layout, Sample, channels, checked_size, detached, place};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use glam::{DAffine3, DMat3, DVec3};
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "PAR/REC",
    Kind::Volume,
    &["par", "rec"],
    "Philips' PAR and REC, of which either is named: the first volume, placed in the world",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(read(input, &folder, options)?.into())
    },
)
.with_several(&[Several::TimePoints]);

/// Endings of the two files.
const HEADERS: [&str; 2] = ["PAR", "par"];
const IMAGES: [&str; 2] = ["REC", "rec"];
/// Fewest numbers of a line that is about a picture.
const COLUMNS: usize = 30;

/// Reads a pair.
fn read(input: Input, folder: &Folder, options: &ImportOptions) -> Result<Volume, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let is_image = path.extension().is_some_and(|own| own.eq_ignore_ascii_case("rec"));
    let (mut header, mut data) =
        if is_image { (beside(path, folder, &HEADERS, limits)?, Some(input)) } else { (input, None) };
    let header = Header::read(&mut header, limits)?;
    let mut data = match data.take() {
        Some(data) => data,
        None => beside(path, folder, &IMAGES, limits)?,
    };
    let malformed = |what: &str| ImportError::malformed(path, 0, what);
    let first = header.pictures.first().ok_or_else(|| malformed("a header without pictures"))?;
    let sample = match first.bits {
        8 => Sample::U8,
        16 => Sample::U16,
        bits => {
            let kind = ImportErrorKind::Unsupported(format!("pictures of {bits} bits"));
            return Err(ImportError::at(path, 0, kind));
        }
    };
    let volumes = header.volumes();
    let (chosen, note) = channels::entry(options.time, volumes.len(), "volume", "--time")
        .map_err(|what| ImportError::at(path, 0, ImportErrorKind::Unsupported(what)))?;
    let pictures = volumes.get(chosen).ok_or_else(|| malformed("a header without a whole volume"))?;
    let [columns, rows] = first.size;
    let size = checked_size(path, 0, [columns, rows, pictures.len() as u64], limits)?;
    let area = size[0] * size[1];
    let layout = |rescale| Layout { sample, big_endian: false, size: [size[0], size[1], 1], components: 1, rescale };
    let length = layout((1.0, 0.0)).bytes();
    let mut values = vec![0.0; area * pictures.len()];
    // Pictures lie in the order of their lines, which need not be that of the slices.
    let mut places: Vec<(usize, usize)> = pictures.iter().copied().zip(0..).collect();
    places.sort_unstable();
    for (picture, slice) in places {
        let to = (picture as u64).saturating_mul(length);
        data.skip(to.saturating_sub(data.offset()), "the pictures before")?;
        let own = &header.pictures[picture];
        let found = layout((own.slope, own.intercept)).read(&mut data)?;
        values[slice * area..(slice + 1) * area].copy_from_slice(&found);
    }
    let mut volume = Volume { unit: Unit::Millimetre, ..Volume::new(size, values) };
    volume.notes.extend(note);
    let (world_from_index, spacing) = header.place(first, size);
    place(&mut volume, world_from_index, spacing);
    Ok(volume)
}

/// The other file of a pair.
fn beside<'a>(path: &'a Path, folder: &Folder, endings: &[&str], limits: &Limits) -> Result<Input<'a>, ImportError> {
    let mut missing = None;
    for ending in endings {
        let name = path.with_extension(ending);
        let name = name.file_name().unwrap_or_default().to_string_lossy();
        match detached(path, 0, folder, &name, limits) {
            Ok((input, _)) => return Ok(input),
            Err(error) => missing = missing.or(Some(error)),
        }
    }
    Err(missing.unwrap_or_else(|| ImportError::malformed(path, 0, "a pair of files without the other one")))
}

/// What of a header is used.
#[derive(Default)]
struct Header {
    /// Degrees around the axes, and millimetres along them, of the middle.
    angles: DVec3,
    middle: DVec3,
    pictures: Vec<Picture>,
}

/// A picture.
struct Picture {
    slice: u32,
    bits: u32,
    size: [u64; 2],
    slope: f64,
    intercept: f64,
    /// Between columns, rows and slices.
    spacing: DVec3,
    /// 1 from head to foot, 2 from side to side, 3 from front to back.
    orientation: u32,
}

impl Header {
    fn read(input: &mut Input, limits: &Limits) -> Result<Self, ImportError> {
        let path = input.path();
        let (mut header, mut version) = (Self::default(), None);
        loop {
            let start = input.offset();
            let Some(line) = input.line()? else { break };
            let line = String::from_utf8_lossy(line).into_owned();
            let malformed = |what| ImportError::malformed(path, start, what);
            if let Some(text) = line.strip_prefix('#') {
                let found = text.split_whitespace().next_back().filter(|_| text.contains("image export tool"));
                version = version.or(found.map(str::to_owned));
            } else if let Some((key, value)) = line.strip_prefix('.').and_then(|line| line.split_once(':')) {
                let numbers = || {
                    let all: Option<Vec<f64>> = value.split_whitespace().map(|word| word.parse().ok()).collect();
                    all.and_then(|all| <[f64; 3]>::try_from(all).ok()).map(DVec3::from_array)
                };
                match key.trim() {
                    key if key.starts_with("Angulation midslice") => {
                        header.angles = numbers().ok_or_else(|| malformed("angles that are no numbers"))?;
                    }
                    key if key.starts_with("Off Centre midslice") => {
                        header.middle = numbers().ok_or_else(|| malformed("a place that is no numbers"))?;
                    }
                    _ => {}
                }
            } else if !line.trim().is_empty() {
                if version.as_ref().is_none_or(|version| !version.starts_with("V4")) {
                    let what =
                        format!("version {:?} of a PAR header; V4 to V4.2 are read", version.unwrap_or_default());
                    return Err(ImportError::at(path, start, ImportErrorKind::Unsupported(what)));
                }
                if header.pictures.len() as u64 >= limits.items {
                    let count = limits.items;
                    return Err(ImportError::limit(path, Some(start), "pictures", count + 1, count));
                }
                let picture = Picture::of(&line).ok_or_else(|| malformed("a line that is about no picture"))?;
                header.pictures.push(picture);
            }
        }
        let like = |picture: &Picture| (picture.bits, picture.size, picture.orientation);
        if !header.pictures.windows(2).all(|pair| like(&pair[0]) == like(&pair[1])) {
            let kind = ImportErrorKind::Unsupported("pictures of several sizes or directions".into());
            return Err(ImportError::at(path, 0, kind));
        }
        Ok(header)
    }

    /// The pictures of each whole volume, in the order of their slices: the nth of each slice is in the nth volume.
    fn volumes(&self) -> Vec<Vec<usize>> {
        let mut slices: std::collections::BTreeMap<u32, Vec<usize>> = Default::default();
        self.pictures.iter().enumerate().for_each(|(n, picture)| slices.entry(picture.slice).or_default().push(n));
        let count = slices.values().map(Vec::len).min().unwrap_or(0);
        (0..count).map(|volume| slices.values().map(|pictures| pictures[volume]).collect()).collect()
    }

    /// Where samples lie, in our axes, and how far apart.
    fn place(&self, first: &Picture, size: [usize; 3]) -> (DAffine3, DVec3) {
        // Columns of the matrix are columns, rows and slices of pictures; rows of it the scanner's axes.
        let axes = match first.orientation {
            2 => [DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z],
            3 => [DVec3::Z, DVec3::NEG_Y, DVec3::X],
            _ => [DVec3::Z, DVec3::X, DVec3::Y],
        };
        let [ap, fh, rl] = (self.angles * std::f64::consts::PI / 180.0).to_array();
        let turn = DMat3::from_rotation_z(rl) * DMat3::from_rotation_x(ap) * DMat3::from_rotation_y(fh);
        let matrix3 = turn * DMat3::from_cols(axes[0], axes[1], axes[2]) * DMat3::from_diagonal(first.spacing);
        let half = DVec3::from_array(size.map(|size| (size as f64 - 1.0) / 2.0));
        let scanner = DAffine3 { matrix3, translation: self.middle - matrix3 * half };
        // From back, head, left to left, back, head.
        (DAffine3::from_mat3(DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X)) * scanner, first.spacing)
    }
}

impl Picture {
    fn of(line: &str) -> Option<Self> {
        let numbers: Option<Vec<f64>> = line.split_whitespace().map(|word| word.parse().ok()).collect();
        let numbers = numbers.filter(|numbers| numbers.len() >= COLUMNS && numbers.iter().all(|n| n.is_finite()))?;
        let whole = |at: usize| Some(numbers[at]).filter(|n| n.fract() == 0.0 && (0.0..1e9).contains(n));
        Some(Self {
            slice: whole(0)? as u32,
            bits: whole(7)? as u32,
            size: [whole(9)? as u64, whole(10)? as u64],
            intercept: numbers[11],
            slope: numbers[12],
            spacing: DVec3::new(numbers[28], numbers[29], numbers[22] + numbers[23]),
            orientation: whole(25)? as u32,
        })
    }
}
