//! The pages of a TIFF as layers of a volume that stays in its file: one is decoded at a time.

use super::{slices, stack};
use crate::import::images::pages::Pages;
use crate::import::images::planes::Choice;
use crate::import::reader::ImportOptions;
use crate::import::samples::channels::entry;
use crate::import::samples::stored::{PackedFile, Stored};
use crate::import::source::Source;
use crate::import::source::inflate::Packing;
use std::ops::Range;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::volume::large::{Block, SampleSource};

/// Opens a TIFF; `None` where it is no stack of grey slices.
pub(super) fn open(source: Source, options: &ImportOptions) -> Result<Option<Box<dyn SampleSource>>, ImportError> {
    if source.is_folder() {
        return Ok(None);
    }
    let path = source.path();
    let choice = Choice { channel: options.channel, time: options.time };
    let Some(mut pages) = Pages::open(path, choice, &options.limits)? else { return Ok(None) };
    let [width, height] = pages.size;
    let layers = pages.contiguous.as_ref().map_or(pages.pages.len(), |contiguous| contiguous.layout.size[2]);
    let mut frame = Volume { size: [width, height, layers], ..Volume::new([1; 3], Vec::new()) };
    if let Some(hyperstack) = pages.stack.as_ref().filter(|stack| !stack.is_plain()) {
        let times = entry(options.time, hyperstack.sizes[2], "time point", "--time");
        let malformed = |what: String| ImportError::malformed(path, 0, what);
        frame.notes.extend(times.map_err(malformed)?.1);
    }
    slices::finish(&mut frame, pages.left_out, pages.spacing);
    if let Some(stack) = &pages.stack {
        stack::place_of(&mut frame, stack);
    }
    if let Some(contiguous) = pages.contiguous {
        let (mut input, _) = source.into_input()?;
        input.skip(contiguous.start, "what stands before its samples")?;
        let file = Some(PackedFile { path: path.into(), packing: Packing::Plain, start: 0 });
        let stored = Stored { input, layout: contiguous.layout, is_text: false, frame, file, planes: 1, channel: None };
        return stored.large();
    }
    // Colours are shown as such, and need all samples at once.
    let is_grey = pages.slice(0)?.colors.is_empty();
    Ok(if is_grey { Some(Box::new(PageSamples { pages, frame, kept: None })) } else { None })
}

/// Decoded pages.
struct PageSamples {
    pages: Pages,
    frame: Volume,
    /// The slice that was decoded last.
    kept: Option<(usize, Vec<f32>)>,
}

impl SampleSource for PageSamples {
    fn frame(&self) -> &Volume {
        &self.frame
    }

    fn frame_mut(&mut self) -> &mut Volume {
        &mut self.frame
    }

    fn bytes_of_row(&self) -> u64 {
        // Numbers as they are stored, and as they are kept.
        self.frame.size[0] as u64 * 12
    }

    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
        if self.kept.as_ref().is_none_or(|(own, _)| *own != layer) {
            self.kept = None;
            self.kept = Some((layer, self.pages.slice(layer)?.values));
        }
        let width = self.frame.size[0];
        if let (Block::Reals(values), Some((_, all))) = (block, &self.kept) {
            values.copy_from_slice(&all[rows.start * width..rows.end * width]);
        }
        Ok(())
    }
}
