//! FreeSurfer's MGH, plain or gzip as `.mgz` (FreeSurfer wiki, "MghFormat"): numbers in big endian behind a header of 284 bytes.

use crate::import::reader::{ImportOptions, Kind, Reader};
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::samples::{Layout, Sample, channels, checked_size, entries, place};
use crate::import::source::inflate::{GZIP, Packing};
use crate::import::source::input::Input;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "FreeSurfer",
    Kind::Volume,
    &["mgz", "mgh", "mgh.gz"],
    "FreeSurfer volume, and .mgh: the first frame, placed in the world",
    |source, options| Ok(stored(source.into_input()?.0, options)?.read(options)?.into()),
)
.with_large_volumes(|source, options| stored(source.into_input()?.0, options)?.large());

/// Bytes before the first sample.
const HEADER: usize = 284;

/// A file of this format.
fn stored<'a>(mut input: Input<'a>, options: &ImportOptions) -> Result<Stored<'a>, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let packing = if input.peek(2)? == GZIP { Packing::Gzip } else { Packing::Plain };
    input = packing.unpack(input, limits);
    let header = Fields(input.take(HEADER, "an MGH header")?.to_vec());
    if header.long(0) != 1 {
        return Err(ImportError::malformed(path, 0, "the file does not begin as MGH does"));
    }
    let [width, depth, height, frames] = [4, 8, 12, 16].map(|at| u64::try_from(header.long(at)).unwrap_or(0));
    let size = checked_size(path, 4, [width, depth, height], limits)?;
    let unsupported = |at, what| ImportError::at(path, at, ImportErrorKind::Unsupported(what));
    let sample = match header.long(20) {
        0 => Sample::U8,
        1 => Sample::I32,
        3 => Sample::F32,
        4 => Sample::I16,
        10 => Sample::U16,
        other => return Err(unsupported(20, format!("samples of MGH type {other}"))),
    };
    let layout = Layout { sample, big_endian: true, size, components: 1, rescale: (1.0, 0.0) };
    let frames = usize::try_from(frames).unwrap_or(usize::MAX).max(1);
    let (frame, note) =
        channels::entry(options.time, frames, "frame", "--time").map_err(|what| unsupported(16, what))?;
    entries::skip_volumes(&mut input, &layout, frame as u64)?;
    let mut volume = Volume { size, unit: Unit::Millimetre, ..Volume::new([1; 3], Vec::new()) };
    volume.notes.extend(note);
    let (world_from_index, spacing) = header.place(size);
    place(&mut volume, world_from_index, spacing);
    let file = Some(PackedFile { path: path.into(), packing, start: 0 });
    Ok(Stored { input, layout, is_text: false, frame: volume, file, planes: 1, channel: options.channel })
}

/// Numbers at bytes of a header.
struct Fields(Vec<u8>);

impl Fields {
    fn word(&self, at: usize) -> [u8; 4] {
        self.0.get(at..).and_then(|rest| rest.first_chunk()).copied().unwrap_or_default()
    }

    fn long(&self, at: usize) -> i32 {
        i32::from_be_bytes(self.word(at))
    }

    fn reals(&self, at: usize) -> DVec3 {
        DVec3::from_array([0, 4, 8].map(|offset| f64::from(f32::from_be_bytes(self.word(at + offset)))))
    }

    /// Where samples lie, in our axes (left, posterior, superior), and how far apart.
    fn place(&self, size: [usize; 3]) -> (DAffine3, DVec3) {
        let is_said = self.0[28..30] != [0, 0];
        let (spacing, axes, middle) = if is_said {
            (self.reals(30), [42, 54, 66].map(|at| self.reals(at)), self.reals(78))
        } else {
            // Coronal slices, as scanners made them for it.
            (DVec3::ONE, [DVec3::NEG_X, DVec3::NEG_Z, DVec3::Y], DVec3::ZERO)
        };
        let matrix3 = DMat3::from_cols(axes[0], axes[1], axes[2]) * DMat3::from_diagonal(spacing);
        // The middle is that of the sample behind it where there is an even number.
        let half = DVec3::from_array(size.map(|size| size as f64 / 2.0));
        let ras = DAffine3 { matrix3, translation: middle - matrix3 * half };
        (DAffine3::from_scale(DVec3::new(-1.0, -1.0, 1.0)) * ras, spacing)
    }
}
