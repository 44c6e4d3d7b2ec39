//! The series in a folder: files that share a series, a size and a direction. The one with the most pictures is read.

use super::elements::File;
use super::pixels::Layout;
use super::tag;
use super::{MAGIC, READER, are_alike, directions, place_of, slices, volume};
use crate::import::reader::{FolderClues, ImportOptions, clues};
use crate::import::samples::checked_size;
use crate::import::source::Source;
use crate::import::source::input::Input;
use crate::import::source::listing;
use glam::DVec3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::io::Seek;
use std::path::{Component, Path, PathBuf};
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What files of one stack share.
#[derive(Clone, Debug)]
struct Key {
    series: String,
    /// Rows and columns.
    size: [usize; 2],
    /// In which columns and rows are counted.
    directions: (DVec3, DVec3),
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

/// Name of the file that lists those of a medium, such as a CD.
const DIRECTORY: &str = "DICOMDIR";

/// Whether a folder, or one below it, holds a file that begins as those of the format do.
pub(super) fn is_in(clues: &FolderClues) -> Result<bool, ImportError> {
    for path in clues.files()? {
        if is_dicom(path, clues.limits())? {
            return Ok(true);
        }
    }
    // The files above are among those below, and most folders that are none of ours have few.
    for path in listing::files_below(clues.path, clues.limits())?.iter().skip(clues.files()?.len()) {
        if is_dicom(path, clues.limits())? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn is_dicom(path: &Path, limits: &Limits) -> Result<bool, ImportError> {
    if READER.extension_of(path).is_some() {
        return Ok(true);
    }
    let mut input = Input::open(path, &Limits { bytes: u64::MAX, ..*limits })?;
    Ok(MAGIC.is_in(input.peek(clues::HEAD)?))
}

/// Reads a folder, a file with the series that it belongs to, or the files that a directory of a medium names.
pub(super) fn read(source: Source, options: &ImportOptions) -> Result<Volume, ImportError> {
    let limits = &options.limits;
    let path = source.path();
    if source.is_folder() {
        return read_series(path, listing::files_below(path, limits)?, None, options);
    }
    let is_alone = source.is_in_memory();
    let (input, _) = source.into_input()?;
    let Some(mut again) = input.file()?.filter(|_| !is_alone) else { return super::read(input, options) };
    let file = File::read(input, limits, false)?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !file.referenced.is_empty() {
        return read_series(path, named_by(path, folder, &file)?, None, options);
    }
    let layout = Layout::of(path, &file, limits)?;
    if layout.frames > 1 || file.main.text(tag::SERIES).is_none() {
        again.rewind().map_err(|error| ImportError::io(path, error))?;
        return super::read(Input::of_file(again, path, limits)?, options);
    }
    read_series(path, listing::files(folder, limits)?, Some(&Key::of(&file, &layout)), options)
}

/// The files of a directory that are there, below its folder and in either case: media have capitals, and copies of them may not.
fn named_by(path: &Path, folder: &Path, directory: &File) -> Result<Vec<PathBuf>, ImportError> {
    let is_name = |part: &String| {
        let mut parts = Path::new(part).components();
        matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None))
    };
    let place = |parts: &Vec<String>| {
        let parts = parts.iter().map(String::as_str);
        let lower: PathBuf = parts.clone().map(str::to_lowercase).collect();
        [folder.join(parts.collect::<PathBuf>()), folder.join(lower)].into_iter().find(|path| path.is_file())
    };
    let files: Vec<PathBuf> =
        directory.referenced.iter().filter(|parts| parts.iter().all(is_name)).filter_map(place).collect();
    if files.is_empty() {
        let count = directory.referenced.len();
        let what = format!("none of the {count} files that this directory names is beside it");
        return Err(ImportError::of_file(path, ImportErrorKind::Malformed(what)));
    }
    Ok(files)
}

/// Reads a series of some files: the wanted one, or of all, or of those with the number that is asked for, the one with the most
/// pictures.
fn read_series(
    path: &Path,
    files: Vec<PathBuf>,
    wanted: Option<&Key>,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let (number, limits) = (options.series, &options.limits);
    let is_directory = |path: &PathBuf| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case(DIRECTORY));
    let files = files.into_par_iter().filter(|path| !is_directory(path));
    let heads: Vec<_> = files.map(|path| (head(&path, limits), path)).collect();
    // By series and size of pictures; of each those of one direction.
    let mut stacks = BTreeMap::<_, Vec<(Key, Stack)>>::new();
    let (mut others, mut fault) = (0, None);
    for (head, path) in heads {
        match head {
            Ok((key, file, frames)) => {
                let alike = stacks.entry((key.series.clone(), key.size)).or_default();
                let known = alike.iter().map(|(own, _)| own.directions);
                let place = place_of(key.directions, known).unwrap_or(alike.len());
                if place == alike.len() {
                    alike.push((key, Stack::default()));
                }
                let stack = &mut alike[place].1;
                stack.files.push(path);
                stack.pictures += frames as u64;
                stack.number = file.main.decimal(tag::SERIES_NUMBER).map(|number| number as i64);
                stack.description = file.main.text(tag::SERIES_DESCRIPTION).unwrap_or_default().to_owned();
            }
            // Other files may lie beside a series; one that begins as a picture of it is damaged.
            Err(error) if options.strict && wanted.is_none() && is_picture(&path, limits) => return Err(error),
            Err(error) => {
                others += 1;
                fault.get_or_insert(error);
            }
        }
    }
    let stacks: Vec<(Key, Stack)> = stacks.into_values().flatten().collect();
    let count = stacks.len();
    // A file that was named is in one of them; directions alone may fit two.
    let has_asked = |stack: &Stack| stack.files.iter().any(|file| file.file_name() == path.file_name());
    let is_found = wanted.is_some() && stacks.iter().any(|(_, stack)| has_asked(stack));
    let fits = |key: &Key, stack: &Stack| {
        let is_wanted = |wanted: &Key| if is_found { has_asked(stack) } else { wanted.is_same(key) };
        wanted.is_none_or(is_wanted) && (number.is_none() || stack.number == number)
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
    let mut volume = read_stack(&stack, wanted.map(|_| path), options)?;
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
        let series = file.main.text(tag::SERIES).unwrap_or_default().to_owned();
        Self { series, size: [layout.rows, layout.columns], directions: directions(file, 0) }
    }

    fn is_same(&self, other: &Self) -> bool {
        self.series == other.series && self.size == other.size && are_alike(self.directions, other.directions)
    }
}

/// Whether a file begins as those of the format do.
fn is_picture(path: &Path, limits: &Limits) -> bool {
    let head = Input::open(path, limits).and_then(|mut input| Ok(MAGIC.is_in(input.peek(clues::HEAD)?)));
    head.unwrap_or(false)
}

/// Reads the files of a stack. Those that are not whole are left out, and a note says so; but for `asked`, the file that was named, and
/// unless all have to be whole.
fn read_stack(stack: &Stack, asked: Option<&Path>, options: &ImportOptions) -> Result<Volume, ImportError> {
    let limits = &options.limits;
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
    let parts: Vec<_> = stack.files.par_iter().map(read).collect();
    let (mut whole, mut faults) = (Vec::new(), Vec::new());
    for (part, path) in parts.into_iter().zip(&stack.files) {
        match part {
            Ok(slices) => whole.extend(slices),
            Err(error) if options.strict => return Err(error),
            Err(error) if asked.is_some_and(|asked| asked.file_name() == path.file_name()) => return Err(error),
            Err(error) => faults.push(error),
        }
    }
    let (count, fault) = (faults.len(), faults.into_iter().next());
    if whole.is_empty() {
        return Err(fault.unwrap_or_else(|| ImportError::malformed(first_path, 0, "a series without pixels")));
    }
    let mut volume = volume(first_path, &first, whole, None, options)?;
    if let Some(fault) = fault {
        let all = stack.files.len();
        volume.notes.push(format!("{count} of the {all} files of the series are left out: {fault}"));
    }
    Ok(volume)
}
