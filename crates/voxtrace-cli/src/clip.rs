//! Clips of frames that were rendered: which encoder makes them, and where frames are kept until they are whole.

use crate::animation::Stage;
use crate::failure::{Failure, reason};
use crate::interrupt;
use crate::outputs;
use crate::parse::Size;
use crate::picture::path_of_view;
use crate::report::Report;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Write};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;
use voxtrace::import::opened;
use voxtrace::output::clip::ffmpeg::{self, FfmpegError};
use voxtrace::output::clip::{ClipFormat, ClipOptions, Frames, has_alpha, read_png};
use voxtrace::output::write_atomically;
use voxtrace_bench::quantity::counted;

/// What the folder of frames says about how they were made.
const SETTINGS: &str = "settings.txt";
/// Frames a second of the fastest GIF that players show as it is.
const MOST_GIF_RATE: f64 = 50.0;
/// Pixels of the shortest edge that the builtin encoder of MP4 takes.
const LEAST_EDGE_OF_BUILTIN: u32 = 16;

/// Quality of MP4 where none is said.
const DEFAULT_QUALITY: u8 = 80;

/// Options about clips.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Clip")]
pub struct ClipArgs {
    /// What encodes .mp4 [default: ffmpeg where it is on the path, else builtin]
    #[arg(long, value_name = "NAME")]
    encoder: Option<EncoderArg>,
    /// Quality of .mp4, from 0 to 100
    #[arg(long, value_name = "N", default_value_t = DEFAULT_QUALITY, value_parser = clap::value_parser!(u8).range(0..=100))]
    clip_quality: u8,
    /// Keep the frames of a clip, in the folder CLIP.frames beside it
    #[arg(long)]
    keep_frames: bool,
}

/// What encodes MP4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum EncoderArg {
    /// H.264 by ffmpeg, which must be installed
    Ffmpeg,
    /// AV1 by the encoder within
    Builtin,
}

/// Clips that are made of the same frames.
pub struct Clip {
    clips: Vec<PathBuf>,
    /// Names of the frames.
    pattern: PathBuf,
    /// Where frames are that nobody asked for.
    folder: Option<PathBuf>,
    /// Frames and their rate, once they are known.
    known: Option<(RangeInclusive<u32>, f64)>,
    /// What frames are made with: the settings, and the files that were read, each with how it was then.
    settings: String,
    inputs: BTreeMap<String, String>,
}

impl ClipArgs {
    /// Refuses what cannot be encoded, before the long work starts. `size` is that of the frames, where it is known.
    pub fn check(&self, clips: &[PathBuf], size: Option<Size>) -> Result<(), Failure> {
        let Some(clip) = clips.iter().find(|clip| ClipFormat::of(clip) == Some(ClipFormat::Mp4)) else { return Ok(()) };
        let encoder = self.encoder()?;
        // Sizes are made even before they are encoded.
        let is_small = |(width, height): Size| width.min(height).next_multiple_of(2) < LEAST_EDGE_OF_BUILTIN;
        if encoder == EncoderArg::Builtin && size.is_some_and(is_small) {
            let least = LEAST_EDGE_OF_BUILTIN;
            let what = format!("{}: the encoder within makes no pictures of less than {least}x{least}", clip.display());
            return Err(Failure::usage(what).hint("a larger --size, or -o clip.gif or clip.png"));
        }
        Ok(())
    }

    /// Says which options mean nothing to the clips that are made.
    pub fn warn_of_needless(&self, clips: &[PathBuf], report: &Report) {
        let has_mp4 = clips.iter().any(|clip| ClipFormat::of(clip) == Some(ClipFormat::Mp4));
        let asked = [(self.encoder.is_some(), "--encoder"), (self.clip_quality != DEFAULT_QUALITY, "--clip-quality")];
        for (_, option) in asked.iter().filter(|(is_asked, _)| *is_asked && !has_mp4) {
            report.warn(&format!("{option} is for MP4, and there is none: add -o NAME.mp4"));
        }
        if self.keep_frames && clips.is_empty() {
            report.warn("--keep-frames is for clips, and there is none: frames that are named are kept anyway");
        }
    }

    fn encoder(&self) -> Result<EncoderArg, Failure> {
        match self.encoder {
            Some(EncoderArg::Ffmpeg) if !ffmpeg::is_installed() => {
                Err(Failure::usage("there is no ffmpeg on the path").hint("--encoder builtin needs none"))
            }
            Some(encoder) => Ok(encoder),
            None if ffmpeg::is_installed() => Ok(EncoderArg::Ffmpeg),
            None if cfg!(feature = "mp4") => Ok(EncoderArg::Builtin),
            None => Err(Failure::usage(
                "this program was built without its encoder of MP4, and there is no ffmpeg on the path",
            )
            .hint("-o clip.gif or clip.png need neither")),
        }
    }
}

impl Clip {
    /// Whether an output is a clip and not a frame.
    pub fn is_clip(path: &Path) -> bool {
        let counts = path.file_name().is_some_and(|name| name.to_string_lossy().contains('#'));
        !counts && ClipFormat::of(path).is_some()
    }

    /// The clips of frames with these names, of which PNG are taken where there are any.
    pub fn new(clips: Vec<PathBuf>, frames: &[PathBuf]) -> Self {
        let png =
            frames.iter().find(|path| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png")));
        let folder = clips.first().filter(|_| png.is_none()).map(|clip| {
            let mut name = clip.file_name().unwrap_or_default().to_owned();
            name.push(".frames");
            clip.with_file_name(name)
        });
        let own = folder.as_ref().map(|folder| folder.join("####.png"));
        let pattern = own.or_else(|| png.cloned()).unwrap_or_default();
        Self { clips, pattern, folder, known: None, settings: String::new(), inputs: BTreeMap::new() }
    }

    /// Where frames are kept that nobody asked for.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Names of the frames.
    pub fn pattern(&self) -> &Path {
        &self.pattern
    }

    /// Makes the folder of frames; those in it that were made with other settings, or of files that have changed since, are removed.
    pub fn make_folder(&mut self, settings: &str, scene: &Path, report: &Report) -> Result<(), Failure> {
        let Some(folder) = self.folder.clone() else { return Ok(()) };
        let failed = |error: io::Error| Failure::output(&folder, &error);
        std::fs::create_dir_all(&folder).map_err(failed)?;
        self.settings = format!("voxtrace {}\n{settings}\nfiles\n", env!("CARGO_PKG_VERSION"));
        let path = folder.join(SETTINGS);
        let frames = self.frames_there().map_err(failed)?;
        let is_as_it_was = |line: &str| line.splitn(3, ' ').nth(2).is_some_and(|path| state_of(path) == line);
        let there = std::fs::read_to_string(&path).unwrap_or_default();
        let before = there.strip_prefix(self.settings.as_str()).filter(|files| files.lines().all(is_as_it_was));
        let is_same = before.is_some();
        // What the frames that are there were made of counts also where this run ends before it reads it.
        let lines = before.into_iter().flat_map(str::lines);
        self.inputs.extend(lines.filter_map(|line| Some((line.splitn(3, ' ').nth(2)?.to_owned(), line.to_owned()))));
        if !frames.is_empty() {
            let what = counted(frames.len() as u64, "frame");
            match is_same {
                true => report.remark(&format!("{what} of an earlier run in {}", folder.display())),
                false => report.remark(&format!("{what} of other settings in {} are made anew", folder.display())),
            }
        }
        self.add_inputs([scene.to_owned()]);
        if !is_same {
            frames.iter().try_for_each(std::fs::remove_file).map_err(failed)?;
            self.keep_made_with(&path).map_err(|error| Failure::output(&path, &error))?;
        }
        Ok(())
    }

    /// Keeps which files were read until now, beside the frames that are made of them.
    pub fn note_inputs(&mut self) {
        self.add_inputs(opened::files());
        let Some(path) = self.folder.as_ref().map(|folder| folder.join(SETTINGS)) else { return };
        if self.keep_made_with(&path).is_err() {
            // Frames are then made anew.
            let _ = std::fs::remove_file(&path);
        }
    }

    fn add_inputs(&mut self, paths: impl IntoIterator<Item = PathBuf>) {
        for path in paths {
            // A name that is no line of text is one of a file that has changed.
            let line = path.to_str().filter(|path| !path.contains('\n'));
            let state = line.map_or_else(|| "- - -".to_owned(), state_of);
            self.inputs.entry(line.unwrap_or_default().to_owned()).or_insert(state);
        }
    }

    fn keep_made_with(&self, path: &Path) -> io::Result<()> {
        write_atomically(path, |out| {
            out.write_all(self.settings.as_bytes())?;
            self.inputs.values().try_for_each(|state| writeln!(out, "{state}"))
        })
    }

    /// Takes the folder away again where no frame was made.
    pub fn drop_empty_folder(&self) {
        let Some(folder) = &self.folder else { return };
        if self.frames_there().is_ok_and(|frames| frames.is_empty()) {
            // What cannot be removed does no harm.
            let _ = std::fs::remove_file(folder.join(SETTINGS));
            let _ = std::fs::remove_dir(folder);
        }
    }

    /// The frames in the folder: pictures of ours with a number as their name.
    fn frames_there(&self) -> io::Result<Vec<PathBuf>> {
        let Some(folder) = &self.folder else { return Ok(Vec::new()) };
        let mut frames = Vec::new();
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let stem = name.strip_suffix(".png").map(|stem| stem.strip_suffix(".part").unwrap_or(stem));
            if stem.is_some_and(|stem| stem.bytes().all(|byte| byte.is_ascii_digit())) && outputs::is_ours(&path) {
                frames.push(path);
            }
        }
        Ok(frames)
    }

    /// Learns which frames there are, and what has been read for them.
    pub fn learn(&mut self, stage: &Stage) {
        self.note_inputs();
        self.known = Some((stage.frames.clone(), stage.fps()));
    }

    /// Makes the clips, and removes frames that nobody asked for.
    pub fn encode(self, args: &ClipArgs, report: &mut Report) -> Result<(), Failure> {
        let Some((frames, fps)) = self.known.clone().filter(|_| !self.clips.is_empty()) else { return Ok(()) };
        let path = |frame: u32| path_of_view(&self.pattern, None, Some(frame));
        let first = path(*frames.start());
        let cannot = |path: &Path, error: &io::Error| {
            Failure::input(format!("cannot read the frame {}: {}", path.display(), reason(error)))
        };
        let (width, height, _) = read_png(&first).map_err(|error| cannot(&first, &error))?;
        let alpha = has_alpha(&first).map_err(|error| cannot(&first, &error))?;
        let count = frames.end() - frames.start() + 1;
        let options = ClipOptions { width, height, frames: count, fps, quality: args.clip_quality, alpha };
        for clip in &self.clips {
            let format = ClipFormat::of(clip)
                .ok_or_else(|| Failure::usage(format!("{}: unknown kind of clip", clip.display())))?;
            if format == ClipFormat::Gif && fps > MOST_GIF_RATE {
                let most = format!("a GIF has at most {MOST_GIF_RATE} frames a second, and this one plays slower");
                report.warn(&format!("{}: {most}; .png and .mp4 keep the rate", clip.display()));
            }
            let passes = if format == ClipFormat::Gif { 2 } else { 1 };
            report.begin_work(&clip.display().to_string(), u64::from(count) * passes);
            let mut done = 0;
            let mut read = |frame: u32| {
                if interrupt::is_requested() {
                    return Err(io::ErrorKind::Interrupted.into());
                }
                let file = path(frames.start() + frame);
                let named =
                    |what: String| io::Error::new(io::ErrorKind::InvalidInput, format!("{}: {what}", file.display()));
                let (own_width, own_height, pixels) = read_png(&file).map_err(|error| named(error.to_string()))?;
                if (own_width, own_height) != (width, height) {
                    let what = format!("{own_width} x {own_height} pixels, and the first frame has {width} x {height}");
                    return Err(named(what));
                }
                done += 1;
                report.update(done, None);
                Ok(pixels)
            };
            let written = match format {
                ClipFormat::Mp4 if args.encoder()? == EncoderArg::Ffmpeg => by_ffmpeg(clip, &options, &mut read),
                _ => outputs::write(clip, |out| format.encode(out, &options, &mut read)),
            };
            report.end();
            if interrupt::is_requested() && written.is_err() {
                return Err(interrupt::failure());
            }
            written?;
            report.wrote(clip);
        }
        if let Some(folder) = self.folder.as_ref().filter(|_| !args.keep_frames) {
            // What is left behind costs nothing but room.
            let _ = self.frames_there().map(|frames| frames.iter().for_each(|frame| _ = std::fs::remove_file(frame)));
            let _ = std::fs::remove_file(folder.join(SETTINGS));
            let _ = std::fs::remove_dir(folder);
        }
        Ok(())
    }
}

/// A file as it is now: length, time of the last change and name.
fn state_of(path: &str) -> String {
    let metadata = Path::new(path).metadata().ok();
    let length = metadata.as_ref().map_or(0, std::fs::Metadata::len);
    let changed = metadata.and_then(|metadata| metadata.modified().ok()?.duration_since(UNIX_EPOCH).ok());
    format!("{length} {} {path}", changed.map_or(0, |time| time.as_nanos()))
}

/// H.264 by ffmpeg, into a file beside the clip that becomes the clip when it is whole.
fn by_ffmpeg(clip: &Path, options: &ClipOptions, frames: Frames) -> Result<(), Failure> {
    outputs::refuse_inputs(clip)?;
    let failed = |error: io::Error| Failure::output(clip, &error);
    let folder = clip.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let part = tempfile::Builder::new().prefix(".").suffix(".part").tempfile_in(folder).map_err(failed)?;
    ffmpeg::encode(part.path(), options, frames).map_err(|error| match error {
        FfmpegError::Io(error) => failed(error),
        FfmpegError::Failed(said) => Failure::other(format!("ffmpeg made no {}: {said}", clip.display()))
            .hint("--encoder builtin needs no ffmpeg"),
    })?;
    outputs::write(clip, |out| io::copy(&mut File::open(part.path())?, out).map(drop))
}
