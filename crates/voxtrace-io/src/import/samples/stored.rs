//! A volume whose samples lie one after the other in a stream of bytes: what a header says about it, and where they begin. It is
//! read at once, or, where it is larger than memory, layer by layer.

use super::file_samples::FileSamples;
use super::{Layout, entries};
use crate::import::reader::ImportOptions;
use crate::import::source::inflate::Packing;
use crate::import::source::input::Input;
use std::path::PathBuf;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::volume::large::SampleSource;

/// What a header says, and the samples.
pub(crate) struct Stored<'a> {
    /// At the first sample.
    pub input: Input<'a>,
    pub layout: Layout,
    /// Whether samples are text.
    pub is_text: bool,
    /// The volume without its samples.
    pub frame: Volume,
    /// Where the samples lie, if it is one file.
    pub file: Option<PackedFile>,
    /// How many numbers there are at a place that lie each in a volume by itself, one behind the other; 1 as a rule.
    pub planes: usize,
    /// Number of the channel that is asked for.
    pub channel: Option<u32>,
}

/// A file with a stream of samples.
pub(crate) struct PackedFile {
    pub path: PathBuf,
    /// How the stream is packed, and the byte of the file with which it begins.
    pub packing: Packing,
    pub start: u64,
}

impl Stored<'_> {
    /// Reads all samples.
    pub fn read(mut self, options: &ImportOptions) -> Result<Volume, ImportError> {
        let options = ImportOptions { channel: self.channel, ..options.clone() };
        let found = entries::read(&mut self.input, (self.layout, self.planes), self.is_text, &options)?;
        let notes = found.notes.into_iter().chain(self.frame.notes).collect();
        Ok(Volume { values: found.values, colors: found.colors, notes, ..self.frame })
    }

    /// The samples as they are read layer by layer; `None` where that is not possible: of text, of several numbers at a place, in memory or in
    /// several files.
    ///
    /// # Errors
    /// If the file is too short for them.
    pub fn large(self) -> Result<Option<Box<dyn SampleSource>>, ImportError> {
        let is_single = !self.is_text && self.layout.components == 1 && self.planes == 1;
        let Some(file) = self.file.filter(|_| is_single) else { return Ok(None) };
        if let Some(remaining) = self.input.remaining().filter(|&remaining| remaining < self.layout.bytes()) {
            let what = format!("its samples, which take {} bytes", self.layout.bytes());
            return Err(ImportError::truncated(self.input.path(), self.input.offset() + remaining, what));
        }
        Ok(Some(Box::new(FileSamples::new(file, self.input.offset(), self.layout, self.frame))))
    }
}
