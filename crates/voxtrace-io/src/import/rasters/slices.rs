//! Slices: the pages of a TIFF, or the pictures in a folder in the order in which people count. Columns run along x, rows
//! along y and slices along z, as those of a scanner do.

use super::{heightmap, large, stack};
use crate::import::images::planes;
use crate::import::images::planes::{Choice, Plane, Planes, is_picture};
use crate::import::reader::{Data, ImportOptions, Kind, Reader};
use crate::import::samples::channels::chosen;
use crate::import::samples::checked_size;
use crate::import::samples::place;
use crate::import::source::input::Input;
use crate::import::source::listing;
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "slices",
    Kind::Volume,
    &["tif", "tiff"],
    "slices: pages of a TIFF, of which a single one is a heightmap; or name a folder of TIFF or PNG",
    |source, options| {
        if source.is_folder() {
            return Ok(read_folder(source.path(), &options.limits)?.into());
        }
        let (input, _) = source.into_input()?;
        read(input, options)
    },
)
.with_folders(|clues| Ok(clues.files()?.iter().any(|path| is_picture(path))))
.with_large_volumes(large::open);

/// Files that are decoded before their samples are kept.
const BATCH: usize = 64;

/// Reads the pages of a TIFF: one is a heightmap, several are slices.
fn read(input: Input, options: &ImportOptions) -> Result<Data, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let choice = Choice { channel: options.channel, time: options.time };
    let mut found = planes::read(&input.rest()?, path, choice, limits)?;
    if found.stack.as_ref().is_some_and(|stack| !stack.is_plain()) {
        return Ok(stack::volume(path, found, choice, limits)?.into());
    }
    let refused = |what| ImportError::at(path, 0, ImportErrorKind::Unsupported(what));
    chosen(options.channel, 1, "channel").and(chosen(options.time, 1, "time point")).map_err(refused)?;
    if found.planes.len() + found.left_out == 1 {
        return Ok(heightmap::of_picture(path, found, options)?.into());
    }
    let mut slices = Slices::new(limits);
    slices.spacing = found.spacing;
    let stack = found.stack.take();
    slices.add(path, found)?;
    let mut volume = slices.finish(path)?;
    if let Some(stack) = stack {
        stack::place_of(&mut volume, &stack);
    }
    Ok(volume.into())
}

/// Reads the pictures of a folder.
fn read_folder(folder: &Path, limits: &Limits) -> Result<Volume, ImportError> {
    let (files, others): (Vec<PathBuf>, Vec<PathBuf>) =
        listing::files(folder, limits)?.into_iter().partition(|path| is_picture(path));
    let mut slices = Slices::new(limits);
    for batch in files.chunks(BATCH) {
        let read = |path: &PathBuf| planes::read(&Input::open(path, limits)?.rest()?, path, Choice::default(), limits);
        let found: Vec<Result<Planes, ImportError>> = batch.par_iter().map(read).collect();
        for (path, found) in batch.iter().zip(found) {
            slices.add(path, found?)?;
        }
    }
    let mut volume = slices.finish(folder)?;
    if !others.is_empty() {
        volume.notes.push(format!("{} files of the folder that are no pictures are left out", others.len()));
    }
    Ok(volume)
}

/// Slices so far.
struct Slices<'a> {
    limits: &'a Limits,
    size: Option<[usize; 2]>,
    count: usize,
    values: Vec<f32>,
    /// Colours of the samples so far, none where all were grey.
    colors: Vec<[u8; 3]>,
    left_out: usize,
    /// In no unit.
    spacing: Option<[f64; 3]>,
}

impl<'a> Slices<'a> {
    fn new(limits: &'a Limits) -> Self {
        Self { limits, size: None, count: 0, values: Vec::new(), colors: Vec::new(), left_out: 0, spacing: None }
    }

    fn add(&mut self, path: &Path, found: Planes) -> Result<(), ImportError> {
        self.left_out += found.left_out;
        for Plane { width, height, values, colors } in found.planes {
            let [w, h] = *self.size.get_or_insert([width, height]);
            if [w, h] != [width, height] {
                let what = format!("a picture of {width} x {height} among others of {w} x {h}");
                return Err(ImportError::malformed(path, 0, what));
            }
            self.count += 1;
            checked_size(path, 0, [w, h, self.count].map(|size| size as u64), self.limits)?;
            if !colors.is_empty() || !self.colors.is_empty() {
                // Grey ones before and after have the grey of their brightness.
                let grey = |value: &f32| [value.round() as u8; 3];
                let before = self.values.len();
                self.colors.extend(self.values[self.colors.len().min(before)..].iter().map(grey));
                self.colors.extend(colors.iter().copied());
                self.colors.extend(values[colors.len()..].iter().map(grey));
            }
            self.values.extend_from_slice(&values);
        }
        Ok(())
    }

    fn finish(self, path: &Path) -> Result<Volume, ImportError> {
        let Some([width, height]) = self.size else {
            return Err(ImportError::malformed(path, 0, "no picture among the slices"));
        };
        let mut volume = Volume::new([width, height, self.count], self.values);
        volume.colors = self.colors;
        finish(&mut volume, self.left_out, self.spacing);
        Ok(volume)
    }
}

/// Says what pages were left out, and puts the others where their distances say, in no unit.
pub(super) fn finish(volume: &mut Volume, left_out: usize, spacing: Option<[f64; 3]>) {
    if left_out > 0 {
        volume.notes.push(format!("{left_out} pages of another size than the first are left out"));
    }
    if let Some(spacing) = spacing {
        let spacing = DVec3::from_array(spacing);
        place(volume, DAffine3::from_mat3(DMat3::from_diagonal(spacing)), spacing);
    }
}
