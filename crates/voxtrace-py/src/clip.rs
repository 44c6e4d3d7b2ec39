//! `save_clip`: pictures as one file that plays. They wait, compressed, in a file without a name beside it until all are there, so that a clip is never in
//! memory as a whole.

use crate::arguments::Number;
use crate::errors::{argument, of_writing, other};
use crate::forks::detach;
use crate::image::PyImage;
use crate::interrupt::run;
use numpy::PyReadonlyArray3;
use pyo3::prelude::*;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use voxtrace::output::clip::ffmpeg::{self, FfmpegError};
use voxtrace::output::clip::{ClipFormat, ClipOptions, Frames};
use voxtrace::output::{check_writable, write_atomically};

/// Frames a second at most, and at least one in so many seconds.
const MOST_RATE: f64 = 1000.0;

/// Writes a clip: `.mp4` (AV1, or H.264 where ffmpeg makes it), `.gif` or `.png` (animated, lossless). The file is whole or what it was before, also where Ctrl-C
/// or an exception of `frames` ends it.
///
/// `frames`: an iterable, such as a generator, of pictures, or of what numpy makes to uint8 of shape `(H, W, 3)` or `(H, W, 4)`, sRGB; all of one size. Until the last
/// is there they wait in a file without a name in the folder of `path`. `fps`: frames a second. `quality`: of MP4, from 0 to 100. `encoder`: of MP4, `"ffmpeg"`, which has to be
/// installed, `"builtin"`, or `None`, the former where it is installed. `progress`: called with the share that is encoded, again and again.
///
/// Raises `ValueError` for another name, no frame or frames that differ, `OSError` where the file cannot be written, `VoxtraceError` where ffmpeg fails.
#[pyfunction]
#[pyo3(signature = (path, frames, *, fps=24.0, quality=Number::Fits(80), encoder=None, progress=None),
    text_signature = "(path, frames, *, fps=24.0, quality=80, encoder=None, progress=None)")]
pub fn save_clip(
    py: Python<'_>,
    path: PathBuf,
    frames: &Bound<'_, PyAny>,
    fps: f64,
    quality: Number<u32>,
    encoder: Option<&str>,
    progress: Option<Py<PyAny>>,
) -> PyResult<()> {
    let name = path.display();
    let format = ClipFormat::of(&path).ok_or_else(|| argument(format!("{name}: a clip is .mp4, .gif or .png")))?;
    if !(1.0 / MOST_RATE..=MOST_RATE).contains(&fps) {
        return Err(argument(format!("fps is a number from {} to {MOST_RATE}, not {fps}", 1.0 / MOST_RATE)));
    }
    let quality = quality.of("quality", 0)?;
    let quality = u8::try_from(quality).ok().filter(|quality| *quality <= 100);
    let quality = quality.ok_or_else(|| argument("quality is a whole number from 0 to 100"))?;
    let by_ffmpeg = match encoder {
        None => format == ClipFormat::Mp4 && ffmpeg::is_installed(),
        Some("builtin") => false,
        Some("ffmpeg") if format == ClipFormat::Mp4 => true,
        Some("ffmpeg") => return Err(argument("ffmpeg is for .mp4")),
        Some(other) => return Err(argument(format!("{other:?} is neither \"ffmpeg\" nor \"builtin\""))),
    };
    let failed = |error: io::Error| of_writing(&path, &error);
    check_writable(&path).map_err(failed)?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut kept = Kept::new(tempfile::tempfile_in(folder).map_err(failed)?);
    for frame in frames.try_iter()? {
        let frame = Pixels::of(&frame?, kept.count())?;
        detach(py, || kept.add(&frame))?.map_err(|error| match error {
            NotKept::Differs(what) => argument(what),
            NotKept::Io(error) => failed(error),
        })?;
    }
    let options = kept.options(fps, quality).ok_or_else(|| argument("a clip has at least one frame"))?;
    // A GIF has two looks at each frame: the first for its palette.
    let all = kept.count() * if format == ClipFormat::Gif { 2 } else { 1 };
    let (wanted, done) = (AtomicBool::new(true), AtomicUsize::new(0));
    let stop = || wanted.store(false, Ordering::Relaxed);
    let tell = |py: Python<'_>| match &progress {
        Some(progress) => progress.call1(py, (done.load(Ordering::Relaxed) as f64 / all as f64,)).map(drop),
        None => Ok(()),
    };
    let mut read = |frame: u32| {
        if !wanted.load(Ordering::Relaxed) {
            return Err(io::ErrorKind::Interrupted.into());
        }
        done.fetch_add(1, Ordering::Relaxed);
        kept.read(frame)
    };
    let encoded = run(py, stop, tell, || match by_ffmpeg {
        true => encode_by_ffmpeg(&path, folder, &options, &mut read),
        false => Ok(write_atomically(&path, |out| format.encode(out, &options, &mut read))?),
    })?;
    encoded.map_err(|error| match error {
        FfmpegError::Io(error) => failed(error),
        FfmpegError::Failed(_) => other(py, format!("{}: {error}", path.display())),
    })?;
    match progress {
        Some(progress) => progress.call1(py, (1.0,)).map(drop),
        None => Ok(()),
    }
}

/// By ffmpeg, into a file beside the clip that becomes the clip when it is whole.
fn encode_by_ffmpeg(path: &Path, folder: &Path, options: &ClipOptions, frames: Frames) -> Result<(), FfmpegError> {
    let part = tempfile::Builder::new().prefix(".").suffix(".part").tempfile_in(folder)?;
    ffmpeg::encode(part.path(), options, frames)?;
    Ok(write_atomically(path, |out| io::copy(&mut File::open(part.path())?, out).map(drop))?)
}

/// A frame: pixels of sRGB and alpha, row by row.
struct Pixels {
    width: usize,
    height: usize,
    /// Whether some may be transparent.
    has_alpha: bool,
    bytes: Vec<u8>,
}

impl Pixels {
    /// Those of a picture of ours, or of what numpy makes to an array of bytes.
    fn of(frame: &Bound<'_, PyAny>, number: usize) -> PyResult<Self> {
        if let Ok(image) = frame.cast::<PyImage>() {
            let image = image.get();
            let (height, width) = image.size();
            let (bytes, has_alpha) = detach(frame.py(), || image.shown())?;
            return Ok(Self { width, height, has_alpha, bytes });
        }
        let array = frame.py().import("numpy")?.call_method1("asarray", (frame,))?;
        let Ok(array) = array.extract::<PyReadonlyArray3<u8>>() else {
            let (kind, shape) = (array.getattr("dtype")?, array.getattr("shape")?);
            let wanted = "a picture, or what numpy makes to uint8 of shape (H, W, 3) or (H, W, 4), is wanted";
            return Err(argument(format!("frame {number}: {wanted}, not {kind} of shape {shape}")));
        };
        let array = array.as_array();
        let (height, width, channels) = array.dim();
        if !(3..=4).contains(&channels) || width == 0 || height == 0 {
            return Err(argument(format!(
                "frame {number}: shape (H, W, 3) or (H, W, 4) is wanted, not ({height}, {width}, {channels})"
            )));
        }
        let mut bytes = Vec::with_capacity(4 * width * height);
        for row in array.outer_iter() {
            for pixel in row.outer_iter() {
                bytes.extend(pixel.iter().copied().chain([u8::MAX]).take(4));
            }
        }
        Ok(Self { width, height, has_alpha: channels == 4, bytes })
    }
}

/// The frames that there are, in a file.
struct Kept {
    file: File,
    /// Where each ends, bytes from the start.
    ends: Vec<u64>,
    /// Width, height, and whether pixels may be transparent, of the first.
    like: Option<(usize, usize, bool)>,
}

/// Why a frame was not kept.
enum NotKept {
    /// It has another size than the first, in words.
    Differs(String),
    /// What the system says.
    Io(io::Error),
}

impl Kept {
    fn new(file: File) -> Self {
        Self { file, ends: Vec::new(), like: None }
    }

    fn count(&self) -> usize {
        self.ends.len()
    }

    fn add(&mut self, frame: &Pixels) -> Result<(), NotKept> {
        let (width, height, _) = *self.like.get_or_insert((frame.width, frame.height, frame.has_alpha));
        if (frame.width, frame.height) != (width, height) {
            let sizes = format!("{} × {} pixels, and the first has {width} × {height}", frame.width, frame.height);
            return Err(NotKept::Differs(format!("frame {} has {sizes}", self.count())));
        }
        let packed = lz4_flex::block::compress(&frame.bytes);
        self.file.write_all(&packed).map_err(NotKept::Io)?;
        self.ends.push(self.ends.last().unwrap_or(&0) + packed.len() as u64);
        Ok(())
    }

    fn read(&mut self, frame: u32) -> io::Result<Vec<[u8; 4]>> {
        let at = frame as usize;
        let start = at.checked_sub(1).map_or(0, |before| self.ends[before]);
        let mut packed = vec![0; (self.ends[at] - start) as usize];
        self.file.seek(SeekFrom::Start(start))?;
        self.file.read_exact(&mut packed)?;
        let (width, height, _) = self.like.unwrap_or_default();
        let bytes = lz4_flex::block::decompress(&packed, 4 * width * height).map_err(io::Error::other)?;
        Ok(bytes.as_chunks::<4>().0.to_vec())
    }

    /// What a clip of them is like; `None` where there is none, or there are more than a clip can have.
    fn options(&self, fps: f64, quality: u8) -> Option<ClipOptions> {
        let (width, height, alpha) = self.like?;
        let (width, height) = (u32::try_from(width).ok()?, u32::try_from(height).ok()?);
        Some(ClipOptions { width, height, frames: u32::try_from(self.count()).ok()?, fps, quality, alpha })
    }
}
