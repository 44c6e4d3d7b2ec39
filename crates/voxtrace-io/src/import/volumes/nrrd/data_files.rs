//! Where the samples of a NRRD are: behind the header, in one file beside it, or in many, which a list or a pattern of numbers names; and
//! what is to be done with each to come at them ("Definition of NRRD File Format", sections 5 and 6).

use super::Header;
use crate::import::samples::detached;
use crate::import::source::folder::Folder;
use crate::import::source::inflate::Packing;
use crate::import::source::input::Input;
use std::path::Path;
use voxtrace_voxelize::{ImportError, Limits};

/// Longest number in a file's name.
const MOST_DIGITS: usize = 20;

/// Files of samples, as the header names them.
#[derive(Default)]
pub(super) enum DataFiles {
    /// None: samples are behind the header.
    #[default]
    Here,
    /// One name, or a pattern.
    Named(String),
    /// `LIST`: lines of the header from there on.
    List(Vec<String>),
}

impl DataFiles {
    /// From the value of the field.
    pub fn of(value: &str) -> Self {
        // A number behind it says what axes a file has, which the order of all samples says too.
        if value.split_whitespace().next() == Some("LIST") { Self::List(Vec::new()) } else { Self::Named(value.into()) }
    }

    /// Whether lines are names of files.
    pub fn is_list(&self) -> bool {
        matches!(self, Self::List(_))
    }

    /// Takes a line that is a name.
    pub fn add(&mut self, line: &str) -> bool {
        let Self::List(names) = self else { return false };
        names.extend(Some(line.trim().to_owned()).filter(|name| !name.is_empty()));
        true
    }

    /// The names of all files, none where samples are behind the header.
    pub fn names(&self, limits: &Limits) -> Result<Vec<String>, &'static str> {
        let names = match self {
            Self::Here => Vec::new(),
            Self::Named(name) if name.contains('%') => numbered(name, limits)?,
            Self::Named(name) => vec![name.clone()],
            Self::List(names) if names.is_empty() => return Err("a list of data files without a name"),
            Self::List(names) => names.clone(),
        };
        if names.len() as u64 > limits.items { Err("more data files than allowed") } else { Ok(names) }
    }
}

/// `slice_%03d.raw 1 60 1`: the names with numbers from the first to the last by a step.
fn numbered(text: &str, limits: &Limits) -> Result<Vec<String>, &'static str> {
    const WRONG: &str = "data files that are no pattern with its first number, last number and step";
    let words: Vec<&str> = text.split_whitespace().collect();
    let at = words.iter().rposition(|word| word.contains('%')).ok_or(WRONG)?;
    let pattern = text[..text.rfind(words[at]).ok_or(WRONG)? + words[at].len()].trim();
    let numbers: Option<Vec<i64>> = words[at + 1..].iter().map(|word| word.parse().ok()).collect();
    let numbers = numbers.filter(|numbers| matches!(numbers.len(), 3 | 4)).ok_or(WRONG)?;
    let (first, last, step) = (numbers[0], numbers[1], numbers[2]);
    let (before, after) = pattern.split_once('%').ok_or(WRONG)?;
    let (width, after) = after.split_once('d').ok_or(WRONG)?;
    let is_padded = width.starts_with('0');
    let width = if width.is_empty() { 0 } else { width.parse::<usize>().map_err(|_| WRONG)? };
    if width > MOST_DIGITS || step == 0 || (last < first) != (step < 0) && first != last {
        return Err(WRONG);
    }
    let count = last.abs_diff(first) / step.unsigned_abs() + 1;
    if count > limits.items {
        return Err("more data files than allowed");
    }
    let name = |n: u64| {
        let number = first + n as i64 * step;
        if is_padded { format!("{before}{number:0width$}{after}") } else { format!("{before}{number:width$}{after}") }
    };
    Ok((0..count).map(name).collect())
}

/// How samples lie in each file.
pub(super) struct Samples {
    pub packing: Packing,
    pub is_text: bool,
    line_skip: u64,
    /// Negative where samples are the last bytes.
    byte_skip: i64,
    /// Bytes of all samples where they are no text.
    bytes: u64,
}

impl Samples {
    pub fn of(header: &Header, bytes: u64) -> Result<Self, String> {
        let (packing, is_text) = match header.encoding.as_deref().unwrap_or("raw") {
            "raw" => (Packing::Plain, false),
            "gzip" | "gz" => (Packing::Gzip, false),
            "bzip2" | "bz2" => (Packing::Bzip2, false),
            "ascii" | "text" | "txt" => (Packing::Plain, true),
            other => return Err(format!("the encoding {other:?}")),
        };
        Ok(Self { packing, is_text, line_skip: header.line_skip, byte_skip: header.byte_skip, bytes })
    }

    /// Goes to the first sample of a file, and says with which byte its packed stream begins.
    pub fn open<'a>(&self, input: Input<'a>, limits: &Limits) -> Result<(Input<'a>, u64), ImportError> {
        self.go(input, limits, self.bytes)
    }

    /// As [`Self::open`], where the file has so many bytes of samples.
    fn go<'a>(&self, mut input: Input<'a>, limits: &Limits, bytes: u64) -> Result<(Input<'a>, u64), ImportError> {
        let path = input.path();
        for _ in 0..self.line_skip {
            if input.line()?.is_none() {
                return Err(ImportError::truncated(path, input.offset(), "the lines to skip"));
            }
        }
        let start = if self.packing == Packing::Plain { 0 } else { input.offset() };
        input = self.packing.unpack(input, limits);
        let skip = match (self.byte_skip, input.remaining()) {
            // From the end.
            (-1, Some(remaining)) => remaining.saturating_sub(bytes),
            (skip, _) => u64::try_from(skip)
                .map_err(|_| ImportError::malformed(path, input.offset(), "an impossible byte skip"))?,
        };
        input.skip(skip, "the bytes to skip")?;
        Ok((input, start))
    }

    /// The samples of several files, one after the other, each with an equal share of them.
    pub fn join<'a>(
        &self,
        path: &'a Path,
        offset: u64,
        names: &[String],
        folder: &Folder,
        limits: &Limits,
    ) -> Result<Input<'a>, ImportError> {
        let count = names.len() as u64;
        if !self.is_text && !self.bytes.is_multiple_of(count) {
            let what = format!("{count} data files, whose samples are no whole number of bytes for each");
            return Err(ImportError::malformed(path, offset, what));
        }
        let mut all = Vec::new();
        for name in names {
            let (input, _) = detached(path, offset, folder, name, limits)?;
            let (mut input, _) = self.go(input, limits, self.bytes / count)?;
            let start = all.len();
            if self.is_text {
                all.extend(input.rest()?);
                all.push(b'\n');
            } else {
                let share = self.bytes / count;
                if start as u64 + share > limits.bytes {
                    return Err(ImportError::limit(path, Some(offset), "bytes of input", self.bytes, limits.bytes));
                }
                // As much as is there, a piece at a time: a header may promise anything.
                while ((all.len() - start) as u64) < share {
                    let piece = (share - (all.len() - start) as u64).min(1 << 20) as usize;
                    all.extend_from_slice(input.take(piece, name)?);
                }
            }
        }
        Ok(Input::of_owned(all, path, limits))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_of_numbers_name_files_and_nonsense_names_none() {
        let names = |text: &str| numbered(text, &Limits::default());
        assert_eq!(names("a%03d.raw 8 12 2").unwrap(), ["a008.raw", "a010.raw", "a012.raw"]);
        assert_eq!(names("a b%d.raw 3 1 -1 2").unwrap(), ["a b3.raw", "a b2.raw", "a b1.raw"]);
        assert_eq!(names("%2d 9 10 1").unwrap(), [" 9", "10"]);
        for wrong in
            ["a%d", "a%d 1 2", "a%d 1 2 0", "a%d 2 1 1", "a%s 1 2 1", "a%99d 1 2 1", "a%d 1 x 1", "a%d 0 99999999 1"]
        {
            assert!(names(wrong).is_err(), "{wrong}");
        }
    }
}
