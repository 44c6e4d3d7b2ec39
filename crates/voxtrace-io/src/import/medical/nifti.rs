//! NIfTI-1 and NIfTI-2 in one file or in two, plain or gzip, and Analyze 7.5 (Cox et al., "A (sort of) new image data format standard: NIfTI-1",
//! 2004; nifti1.h and nifti2.h). Where there is time, the first time point is read, or the one that is asked for.

use super::analyze;
use crate::import::reader::{ImportOptions, Kind, NotShown, Reader};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, Sample, channels, checked_size, detached, entries, place};
use crate::import::source::folder::Folder;
use crate::import::source::inflate::{GZIP, Packing};
use crate::import::source::input::Input;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "NIfTI",
    Kind::Volume,
    &["nii", "nii.gz", "hdr", "img", "hdr.gz", "img.gz"],
    "NIfTI-1 and -2 volume, .nii.gz, and pairs of .hdr and .img, also of Analyze: the first time point, placed in the world",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(stored(input, &folder, options)?.read(options)?.into())
    },
)
.with_large_volumes(|source, options| {
    let (input, folder) = source.into_input()?;
    stored(input, &folder, options)?.large()
});

/// Endings of the two files of a pair.
const HEADERS: [&str; 4] = [".hdr", ".hdr.gz", ".HDR", ".HDR.GZ"];
const IMAGES: [&str; 4] = [".img", ".img.gz", ".IMG", ".IMG.GZ"];
/// Bytes of the header of each version.
const HEADER_1: u64 = 348;
const HEADER_2: u64 = 540;
/// Kinds of samples: bytes, and three or four of them as a colour.
const BYTES: i64 = 2;
const RGB: i64 = 128;
const RGBA: i64 = 2304;
/// NIFTI_INTENT_LABEL: values are names of things.
const INTENT_LABEL: i64 = 1002;

/// The header of a volume, and its samples: of one file, or of two with names alike.
fn stored<'a>(mut input: Input<'a>, folder: &Folder, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut own = path.to_path_buf();
    let packing_of = |input: &mut Input| Ok(if input.peek(2)? == GZIP { Packing::Gzip } else { Packing::Plain });
    let header = match stem(&name, &IMAGES) {
        Some(stem) => {
            let (mut header, _) = beside(path, folder, stem, &HEADERS, limits)?;
            let packing = packing_of(&mut header)?;
            Header::read(&mut packing.unpack(header, limits))?
        }
        None => {
            let packing = packing_of(&mut input)?;
            input = packing.unpack(input, limits);
            let header = Header::read(&mut input)?;
            if header.is_pair {
                let stem = stem(&name, &HEADERS).unwrap_or(&name);
                (input, own) = beside(path, folder, stem, &IMAGES, limits)?;
            } else {
                let file = PackedFile { path: own, packing, start: 0 };
                return samples(input, header, file, options);
            }
            header
        }
    };
    let packing = packing_of(&mut input)?;
    input = packing.unpack(input, limits);
    samples(input, header, PackedFile { path: own, packing, start: 0 }, options)
}

/// A file's name without one of these endings.
fn stem<'n>(name: &'n str, endings: &[&str]) -> Option<&'n str> {
    endings.iter().find_map(|ending| name.strip_suffix(ending))
}

/// The other file of a pair.
fn beside<'a>(
    path: &'a Path,
    folder: &Folder,
    stem: &str,
    endings: &[&str],
    limits: &Limits,
) -> Result<(Input<'a>, PathBuf), ImportError> {
    let mut missing = None;
    for ending in endings {
        match detached(path, 0, folder, &format!("{stem}{ending}"), limits) {
            Ok(found) => return Ok(found),
            Err(error) => missing = missing.or(Some(error)),
        }
    }
    Err(missing.unwrap_or_else(|| ImportError::malformed(path, 0, "a pair of files without the other one")))
}

/// A volume of a header and an input with its samples.
fn samples<'a>(
    mut input: Input<'a>,
    header: Header,
    file: PackedFile,
    options: &ImportOptions,
) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let size = checked_size(path, input.offset(), header.size, limits)?;
    input.skip(header.start.saturating_sub(input.offset()), "what stands before its samples")?;
    let slope = if header.scl_slope != 0.0 && header.scl_slope.is_finite() { header.scl_slope } else { 1.0 };
    let rescale = if slope == 1.0 && header.scl_slope == 0.0 || !header.scl_inter.is_finite() {
        (1.0, 0.0)
    } else {
        (slope, header.scl_inter)
    };
    // Colours are bytes, which nothing rescales.
    let components = match header.kind {
        RGB => 3,
        RGBA => 4,
        _ => 1,
    };
    let (kind, rescale) = if components > 1 { (BYTES, (1.0, 0.0)) } else { (header.kind, rescale) };
    let Some(sample) = sample_of(kind) else {
        let kind = ImportErrorKind::Unsupported(format!("samples of NIfTI type {}", header.kind));
        return Err(ImportError::at(path, header.kind_at, kind));
    };
    let layout = Layout { sample, big_endian: header.big_endian, size, components, rescale };
    let unsupported = |what| ImportError::at(path, header.kind_at, ImportErrorKind::Unsupported(what));
    let [points, vectors] =
        [header.time_points, header.vectors].map(|count| usize::try_from(count).unwrap_or(usize::MAX));
    let (point, note) = channels::entry(options.time, points, "time point", "--time").map_err(unsupported)?;
    // Behind time come the numbers of vectors, each a volume by itself.
    let mut options = options.clone();
    let number = if vectors > 1 { options.channel.take() } else { None };
    let (vector, behind) = channels::entry(number, vectors, "channel", "--channel").map_err(unsupported)?;
    entries::skip_volumes(&mut input, &layout, header.time_points.saturating_mul(vector as u64) + point as u64)?;
    let mut frame = Volume { size, unit: Unit::Millimetre, ..Volume::new([1; 3], Vec::new()) };
    frame.is_labels = header.intent == INTENT_LABEL;
    let mut parts = NotShown::default();
    parts.count("NIfTI extension", header.extensions);
    frame.notes.extend(note.into_iter().chain(behind).chain(parts.note()));
    // x and y of NIfTI point to the right and to the front.
    let world_from_nifti = DMat3::from_diagonal(DVec3::new(-1.0, -1.0, 1.0)) * header.unit_size;
    place(
        &mut frame,
        DAffine3::from_mat3(world_from_nifti) * header.nifti_from_index,
        header.spacing * header.unit_size,
    );
    Ok(Stored { input, layout, is_text: false, frame, file: Some(file), planes: 1, channel: options.channel })
}

fn sample_of(kind: i64) -> Option<Sample> {
    Some(match kind {
        2 => Sample::U8,
        4 => Sample::I16,
        8 => Sample::I32,
        16 => Sample::F32,
        64 => Sample::F64,
        256 => Sample::I8,
        512 => Sample::U16,
        768 => Sample::U32,
        1024 => Sample::I64,
        1280 => Sample::U64,
        // SPM's own for Analyze.
        130 => Sample::I8,
        132 => Sample::U16,
        136 => Sample::U32,
        _ => return None,
    })
}

/// What of a header is used.
pub(super) struct Header {
    big_endian: bool,
    pub size: [u64; 3],
    /// Volumes of this size, and numbers of a vector at each place.
    time_points: u64,
    vectors: u64,
    kind: i64,
    kind_at: u64,
    pub intent: i64,
    /// Whether samples lie in another file.
    is_pair: bool,
    /// Byte of the first sample.
    pub start: u64,
    pub scl_slope: f64,
    pub scl_inter: f64,
    pub spacing: DVec3,
    /// Millimetres of a unit.
    pub unit_size: f64,
    pub nifti_from_index: DAffine3,
    /// What other programs added.
    extensions: u64,
}

impl Header {
    fn read(input: &mut Input) -> Result<Self, ImportError> {
        let path = input.path();
        let head = input.peek(4)?;
        let Some(&first) = head.first_chunk::<4>() else {
            return Err(ImportError::truncated(path, head.len() as u64, "a NIfTI header"));
        };
        let (length, big_endian) = match (u32::from_le_bytes(first), u32::from_be_bytes(first)) {
            (348 | 540, _) => (u32::from_le_bytes(first), false),
            (_, 348 | 540) => (u32::from_be_bytes(first), true),
            _ => return Err(ImportError::malformed(path, 0, "the file does not begin as NIfTI does")),
        };
        let is_second = u64::from(length) == HEADER_2;
        let bytes = input.take(length as usize, "a NIfTI header")?.to_vec();
        let fields = Fields { header: &bytes, big_endian };
        let magic_at = if is_second { 4 } else { 344 };
        let is_in_pair = stem(&path.to_string_lossy(), &[HEADERS, IMAGES].concat()).is_some();
        let (is_pair, is_analyze) = match fields.text(magic_at) {
            b"n+1" | b"n+2" => (false, false),
            b"ni1" | b"ni2" => (true, false),
            _ if !is_second && is_in_pair => (true, true),
            _ => return Err(ImportError::malformed(path, magic_at as u64, "a header without NIfTI's sign")),
        };
        let wide = usize::from(is_second);
        // Offsets in both versions: the second has wider numbers in another order.
        let pick = |first: usize, second: usize| [first, second][wide];
        let dimension = |n: usize| if is_second { fields.int(16 + 8 * n, 8) } else { fields.int(40 + 2 * n, 2) };
        let real = |first: usize, second: usize, n: usize| {
            if is_second { fields.f64(second + 8 * n) } else { f64::from(fields.f32(first + 4 * n)) }
        };
        let code = |first: usize, second: usize| if is_second { fields.int(second, 4) } else { fields.int(first, 2) };
        let dimensions = dimension(0);
        if !(1..=7).contains(&dimensions) {
            let at = pick(40, 16) as u64;
            return Err(ImportError::malformed(path, at, format!("{dimensions} dimensions; 1 to 7 are possible")));
        }
        let size_along = |n: usize| {
            let size = if n as i64 <= dimensions { dimension(n) } else { 1 };
            // Axes behind the third that are announced and then left empty are none (nifti1_io).
            let size = if n > 3 && size == 0 { 1 } else { size };
            u64::try_from(size).ok().filter(|&size| size > 0).ok_or_else(|| {
                let at = pick(40 + 2 * n, 16 + 8 * n) as u64;
                ImportError::malformed(path, at, format!("a volume with {size} samples along an axis"))
            })
        };
        let time_points = size_along(4)?;
        let vectors = size_along(5)?.saturating_mul(size_along(6)?).saturating_mul(size_along(7)?);
        let spacing = DVec3::new(real(76, 104, 1), real(76, 104, 2), real(76, 104, 3)).abs();
        // Pictures alone often have nothing for their third axis (nifti1_io takes 1 there too).
        let spacing = DVec3::select(spacing.cmpgt(DVec3::ZERO), spacing, DVec3::ONE);
        let start = if is_second { fields.int(168, 8) } else { f64::from(fields.f32(108)) as i64 };
        // Some writers leave 0: samples follow the header and its four bytes of extension.
        let least = if is_pair { 0 } else { (if is_second { HEADER_2 } else { HEADER_1 }) as i64 + 4 };
        let units = if is_second { fields.int(500, 4) } else { i64::from(bytes[123]) };
        let unit_size = match units & 7 {
            1 => 1000.0,
            3 => 0.001,
            _ => 1.0,
        };
        let nifti_from_index = placement([code(254, 348), code(252, 344)], spacing, real);
        let mut header = Self {
            is_pair,
            big_endian,
            size: [size_along(1)?, size_along(2)?, size_along(3)?],
            time_points,
            vectors,
            kind: fields.int(pick(70, 12), 2),
            kind_at: pick(70, 12) as u64,
            intent: code(68, 504),
            start: u64::try_from(start.max(least)).unwrap_or(0),
            scl_slope: real(112, 176, 0),
            scl_inter: real(116, 184, 0),
            spacing,
            unit_size,
            nifti_from_index,
            extensions: 0,
        };
        if is_analyze {
            analyze::settle(&mut header, &fields);
        } else {
            header.extensions = extensions(input, big_endian, if is_pair { u64::MAX } else { header.start })?;
        }
        Ok(header)
    }
}

/// How many extensions lie behind the header, before a byte of the file: each has its size and its kind in front.
fn extensions(input: &mut Input, big_endian: bool, end: u64) -> Result<u64, ImportError> {
    if !matches!(input.peek(4)?, [1..=255, _, _, _]) || input.offset() + 4 > end {
        return Ok(0);
    }
    input.skip(4, "the sign of extensions")?;
    let mut count = 0;
    while let Some(&size) = input.peek(8)?.first_chunk::<8>().and_then(|head| head.first_chunk::<4>()) {
        let size = if big_endian { u32::from_be_bytes(size) } else { u32::from_le_bytes(size) };
        let after = input.offset() + u64::from(size);
        if size < 16 || size % 16 != 0 || after > end {
            break;
        }
        input.skip(size.into(), "an extension of the header")?;
        count += 1;
    }
    Ok(count)
}

/// Where samples lie, by the codes of the affine matrix and of the quaternion; `real` is a number by its offset in either version.
fn placement([affine, quaternion]: [i64; 2], spacing: DVec3, real: impl Fn(usize, usize, usize) -> f64) -> DAffine3 {
    if affine > 0 {
        let row = |n: usize| [0, 1, 2, 3].map(|column| real(280 + 16 * n, 400 + 32 * n, column));
        let rows = [row(0), row(1), row(2)];
        let column = |n: usize| DVec3::new(rows[0][n], rows[1][n], rows[2][n]);
        DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
    } else if quaternion > 0 {
        let [b, c, d] = [0, 1, 2].map(|n| real(256, 352, n));
        let a = (1.0 - (b * b + c * c + d * d)).max(0.0).sqrt();
        let turn = DQuat::from_xyzw(b, c, d, a);
        let turn = if turn.is_finite() && turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
        // pixdim[0] is −1 where the third axis is mirrored.
        let mirror = if real(76, 104, 0) < 0.0 { -1.0 } else { 1.0 };
        let offset = DVec3::from_array([0, 1, 2].map(|n| real(268, 376, n)));
        let scale = DMat3::from_diagonal(spacing * DVec3::new(1.0, 1.0, mirror));
        DAffine3 { matrix3: DMat3::from_quat(turn) * scale, translation: offset }
    } else {
        DAffine3::from_mat3(DMat3::from_diagonal(spacing))
    }
}

/// Numbers at bytes of a header.
pub(super) struct Fields<'a> {
    header: &'a [u8],
    big_endian: bool,
}

impl Fields<'_> {
    fn bytes<const N: usize>(&self, at: usize) -> [u8; N] {
        let mut bytes = self.header.get(at..).and_then(|rest| rest.first_chunk()).copied().unwrap_or([0; N]);
        if self.big_endian {
            bytes.reverse();
        }
        bytes
    }

    pub fn int(&self, at: usize, width: usize) -> i64 {
        match width {
            2 => i16::from_le_bytes(self.bytes(at)).into(),
            4 => i32::from_le_bytes(self.bytes(at)).into(),
            _ => i64::from_le_bytes(self.bytes(at)),
        }
    }

    pub fn f32(&self, at: usize) -> f32 {
        f32::from_le_bytes(self.bytes(at))
    }

    fn f64(&self, at: usize) -> f64 {
        f64::from_le_bytes(self.bytes(at))
    }

    fn text(&self, at: usize) -> &[u8] {
        self.header.get(at..at + 3).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_alone_lies_as_its_quaternion_says_also_without_a_third_spacing() {
        let mut bytes = vec![0u8; 352];
        let mut put = |at: usize, own: &[u8]| bytes[at..at + own.len()].copy_from_slice(own);
        put(0, &348u32.to_le_bytes());
        for (n, size) in [3i16, 2, 1, 1, 1, 1, 1, 1].into_iter().enumerate() {
            put(40 + 2 * n, &size.to_le_bytes());
        }
        put(70, &2i16.to_le_bytes());
        for (n, spacing) in [1f32, 2.0, 3.0, 0.0].into_iter().enumerate() {
            put(76 + 4 * n, &spacing.to_le_bytes());
        }
        put(108, &352f32.to_le_bytes());
        put(123, &[2]);
        put(252, &1i16.to_le_bytes());
        // A quarter of a turn around z.
        put(264, &std::f32::consts::FRAC_1_SQRT_2.to_le_bytes());
        put(344, b"n+1\0");
        bytes.extend([1, 2]);
        let (options, path) = (ImportOptions::default(), Path::new("a.nii"));
        let input = Input::of_bytes(&bytes, path, &options.limits).unwrap();
        let volume = stored(input, &Folder::none(), &options).unwrap().read(&options).unwrap();
        let axes = volume.world_from_index.matrix3;
        let wanted = [DVec3::new(0.0, -2.0, 0.0), DVec3::new(3.0, 0.0, 0.0), DVec3::Z];
        let pairs = [axes.x_axis, axes.y_axis, axes.z_axis].into_iter().zip(wanted);
        assert!(pairs.clone().all(|(a, b)| (a - b).length() < 1e-6), "{axes}");
        assert!(volume.notes.is_empty(), "{:?}", volume.notes);
    }
}
