//! The series in a folder: files that share a series, a size and a direction. The one with the most pictures is read.

use super::elements::{File, tag};
use super::pixels::Layout;
use super::{directions, slices, volume};
use crate::import::input::Input;
use crate::import::listing;
use crate::import::volume::samples::checked_size;
use crate::import::{ImportError, ImportErrorKind, Limits};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::volume::Volume;

/// What files of one stack share.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    series: String,
    rows: usize,
    columns: usize,
    /// Directions of columns and rows in thousandths.
    directions: [i64; 6],
}

/// A stack of files.
#[derive(Default)]
struct Stack {
    files: Vec<PathBuf>,
    pictures: u64,
    number: Option<i64>,
    description: String,
}

impl Stack {
    fn name(&self) -> String {
        let number = self.number.map_or("without a number".into(), |number| number.to_string());
        let description = if self.description.is_empty() { String::new() } else { format!(" ({})", self.description) };
        format!("{number}{description}: {} pictures", self.pictures)
    }
}

/// Reads the series of a folder, or the one that a file of it belongs to: the one with the most pictures, or of those with
/// the number that is asked for.
pub(in crate::import) fn read_series(path: &Path, number: Option<i64>, limits: &Limits) -> Result<Volume, ImportError> {
    let folder = if path.is_dir() { path } else { path.parent().unwrap_or(Path::new("")) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let mut wanted = None;
    if !path.is_dir() {
        let input = Input::open(path, limits)?;
        let file = File::read(input, limits, false)?;
        let layout = Layout::of(path, &file, limits)?;
        if layout.frames > 1 || file.main.text(tag::SERIES).is_none() {
            return super::read(Input::open(path, limits)?, limits);
        }
        wanted = Some(Key::of(&file, &layout));
    }
    let files = listing::files(folder, limits)?;
    let heads: Vec<_> = files.into_par_iter().map(|path| (head(&path, limits), path)).collect();
    let mut stacks: BTreeMap<Key, Stack> = BTreeMap::new();
    let (mut others, mut fault) = (0, None);
    for (head, path) in heads {
        match head {
            Ok((key, file, frames)) => {
                let stack = stacks.entry(key).or_default();
                stack.files.push(path);
                stack.pictures += frames as u64;
                stack.number = file.main.decimal(tag::SERIES_NUMBER).map(|number| number as i64);
                stack.description = file.main.text(tag::SERIES_DESCRIPTION).unwrap_or_default().to_owned();
            }
            Err(error) => {
                others += 1;
                fault.get_or_insert(error);
            }
        }
    }
    let count = stacks.len();
    let fits = |key: &Key, stack: &Stack| {
        wanted.as_ref().is_none_or(|wanted| wanted == key) && (number.is_none() || stack.number == number)
    };
    let mut found: Option<Stack> = None;
    let mut left_out = Vec::new();
    for (key, stack) in stacks {
        let is_better = fits(&key, &stack) && found.as_ref().is_none_or(|found| stack.pictures > found.pictures);
        let worse = if is_better { found.replace(stack) } else { Some(stack) };
        left_out.extend(worse.map(|stack| stack.name()));
    }
    let Some(stack) = found else {
        return Err(match (fault, number) {
            (_, Some(number)) if count > 0 => {
                let kind = ImportErrorKind::Unsupported(format!(
                    "no series {number} in the folder: there are {}",
                    left_out.join(", ")
                ));
                ImportError::of_file(path, kind)
            }
            (Some(fault), _) => fault,
            (None, _) => ImportError::malformed(path, 0, "a folder without DICOM pictures"),
        });
    };
    let mut volume = read_stack(&stack, limits)?;
    if wanted.is_none() && !left_out.is_empty() {
        let (chosen, rest) = (stack.name(), left_out.join(", "));
        volume.notes.push(format!("series {chosen} is read; --series chooses another: {rest}"));
    }
    if wanted.is_none() && others > 0 {
        volume.notes.push(format!(
            "{others} files of the folder are left out: {}",
            fault.map(|f| f.to_string()).unwrap_or_default()
        ));
    }
    Ok(volume)
}

/// What a file is, without its pixels.
fn head(path: &Path, limits: &Limits) -> Result<(Key, File, usize), ImportError> {
    let file = File::read(Input::open(path, limits)?, limits, false)?;
    let layout = Layout::of(path, &file, limits)?;
    Ok((Key::of(&file, &layout), file, layout.frames))
}

impl Key {
    fn of(file: &File, layout: &Layout) -> Self {
        let (x, y) = directions(file, 0);
        let directions = [x.x, x.y, x.z, y.x, y.y, y.z].map(|value| (value * 1000.0).round() as i64);
        let series = file.main.text(tag::SERIES).unwrap_or_default().to_owned();
        Self { series, rows: layout.rows, columns: layout.columns, directions }
    }
}

fn read_stack(stack: &Stack, limits: &Limits) -> Result<Volume, ImportError> {
    let first_path = &stack.files[0];
    let first = File::read(Input::open(first_path, limits)?, limits, false)?;
    let layout = Layout::of(first_path, &first, limits)?;
    let size = [layout.columns as u64, layout.rows as u64, stack.pictures];
    checked_size(first_path, first.pixels_at, size, limits)?;
    let read = |path: &PathBuf| {
        let file = File::read(Input::open(path, limits)?, limits, true)?;
        let layout = Layout::of(path, &file, limits)?;
        slices(path, &file, &layout, limits)
    };
    let parts: Result<Vec<_>, ImportError> = stack.files.par_iter().map(read).collect();
    volume(first_path, &first, parts?.into_iter().flatten().collect(), limits)
}
