//! What is to be exported: frames with their files.

use crate::tr;
use std::path::{Path, PathBuf};
use voxtrace::Frame;
use voxtrace::output::{PictureOptions, ToneMap};

/// What happens to files that are there already.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Existing {
    /// They stay, and nothing else is written.
    #[default]
    Refuse,
    /// They stay, and the others are written.
    Keep,
    /// They are written over: somebody said so.
    Replace,
}

/// One picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// What is traced.
    pub frame: Frame,
    /// Where it is written; the extension says how.
    pub path: PathBuf,
}

impl Job {
    /// Samples of all its pixels.
    pub fn samples(&self) -> u64 {
        self.frame.region.pixels() as u64 * u64::from(self.frame.samples)
    }
}

/// An export.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportRequest {
    /// The pictures, all of one size.
    pub jobs: Vec<Job>,
    /// From radiance to the screen (PNG only).
    pub tone_map: ToneMap,
    /// 16 bits a channel in place of the usual number: 8 for PNG, 32 for EXR.
    pub sixteen_bits: bool,
    /// What happens to files that are there.
    pub existing: Existing,
}

impl ExportRequest {
    /// What is written, for people.
    pub fn name(&self) -> String {
        match &self.jobs[..] {
            [] => tr!("said.nothing").into(),
            [job] => job.path.display().to_string(),
            [first, .., last] => {
                let file = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                let folder = first.path.parent().unwrap_or(Path::new(""));
                tr!("said.files_to", folder = folder.display(), first = file(&first.path), last = file(&last.path))
            }
        }
    }

    /// How films become files.
    pub fn options(&self) -> PictureOptions {
        PictureOptions { tone_map: self.tone_map, sixteen_bits: self.sixteen_bits }
    }
}

/// The file of a frame, counted from 1, as `render -o FOLDER/NAME_####.png` names it.
pub fn frame_path(folder: &Path, name: &str, frame: u32) -> PathBuf {
    folder.join(format!("{name}_{frame:04}.png"))
}
