//! `voxtrace merge`: films of different samples of one picture, or of different parts of it, become one film, bit for bit the film of all.

use crate::failure::{Failure, reason};
use crate::outputs;
use crate::picture::PictureArgs;
use crate::report::Report;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use voxtrace::film::JoinError;
use voxtrace::import::opened;
use voxtrace::output::{FilmFile, FilmFileError};
use voxtrace::{Film, Region};

/// Add up films of different samples of one picture, and join its crops
#[derive(clap::Args, Clone, Debug)]
pub struct MergeArgs {
    /// Films (.vxf), in any order
    #[arg(value_name = "FILM", required = true)]
    films: Vec<PathBuf>,
    #[command(flatten)]
    picture: PictureArgs,
}

/// Reads a film file.
pub fn open_film(path: &Path) -> Result<FilmFile, Failure> {
    FilmFile::open(path).map_err(|error| film_failure(path, &error))
}

/// The failure of reading a film.
pub fn film_failure(path: &Path, error: &FilmFileError) -> Failure {
    let reason = if let FilmFileError::Io(error) = error { reason(error) } else { error.to_string() };
    let failure = Failure::input(format!("cannot read the film {}: {reason}", path.display()));
    match error {
        FilmFileError::Damaged { .. } => failure.hint("render it again"),
        FilmFileError::Format(_) => failure.hint("films end in .vxf; `render --checkpoint` writes them"),
        _ => failure,
    }
}

impl MergeArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        if self.picture.output.is_empty() {
            return Err(Failure::usage("merge needs an output").hint("-o FILE.vxf, .png or .exr"));
        }
        self.films.iter().for_each(|film| opened::note(film));
        self.picture.output.iter().try_for_each(|path| outputs::refuse_inputs(path))?;
        self.picture.check(None)?;
        let mut parts = Vec::new();
        for path in &self.films {
            parts.push((path.as_path(), open_film(path)?));
        }
        let mut sum = joined(parts, report)?;
        self.picture.warn_of_needless(report);
        sum.frame.first_sample = sum.film.first_sample;
        sum.frame.samples = sum.film.sample_range().1;
        sum.frame.aovs = sum.film.aovs.is_some();
        let mut result = Ok(());
        for path in &self.picture.output {
            let written = self.picture.write(path, &sum, None, report);
            result = result.and(written);
        }
        result
    }
}

/// The film of all films: those of each crop added up, then the crops joined.
fn joined(parts: Vec<(&Path, FilmFile)>, report: &Report) -> Result<FilmFile, Failure> {
    let mut crops: BTreeMap<[u32; 4], Vec<(&Path, FilmFile)>> = BTreeMap::new();
    for (path, part) in parts {
        let Region { x0, y0, x1, y1 } = part.film.region;
        crops.entry([y0, x0, y1, x1]).or_default().push((path, part));
    }
    let mut sums: Vec<(&Path, FilmFile)> = Vec::new();
    for mut parts in crops.into_values() {
        parts.sort_by_key(|(_, part)| part.film.first_sample);
        let path = parts[0].0;
        sums.push((path, if are_prefixes(&parts) { longest(parts)? } else { added_up(parts)? }));
    }
    if sums.len() > 1 {
        for pair in sums.windows(2) {
            check_same_picture(&pair[0], &pair[1])?;
        }
        let films: Vec<&Film> = sums.iter().map(|(_, sum)| &sum.film).collect();
        let film = Film::join(&films).map_err(|error| {
            let failure = Failure::mismatch(error.clone());
            match error {
                JoinError::Gap(..) => failure.hint("crops become one film where together they fill a rectangle"),
                _ => failure,
            }
        })?;
        let (least, most) = film.sample_range();
        if least != most {
            report.warn(&format!("the crops hold {least} to {most} samples a pixel; `render --resume` evens them out"));
        }
        let (_, first) = &mut sums[0];
        (first.frame.region, first.film) = (film.region, film);
    }
    Ok(sums.swap_remove(0).1)
}

/// Whether films begin with the same sample and some have parts with more samples than others, as `--noise` makes them: then each pixel's
/// samples in one film are the first of those in the other.
fn are_prefixes(parts: &[(&Path, FilmFile)]) -> bool {
    let is_uneven = |part: &FilmFile| {
        let (least, most) = part.film.sample_range();
        least != most
    };
    let is_first = |part: &FilmFile| part.film.first_sample == parts[0].1.film.first_sample;
    parts.len() > 1 && parts.iter().all(|(_, part)| is_first(part)) && parts.iter().any(|(_, part)| is_uneven(part))
}

/// Each pixel from the film that has most of its samples.
fn longest(parts: Vec<(&Path, FilmFile)>) -> Result<FilmFile, Failure> {
    for pair in parts.windows(2) {
        check_same_picture(&pair[0], &pair[1])?;
    }
    if let Some((path, _)) = parts.iter().find(|(_, part)| !part.film.groups.is_empty()) {
        let message = format!("{} has light groups, and the films begin with the same sample", path.display());
        return Err(
            Failure::mismatch(message).hint("films with light groups are merged where one starts where another ends")
        );
    }
    let mut parts = parts.into_iter().map(|(_, part)| part);
    let mut all = parts.next().ok_or_else(|| Failure::usage("nothing to merge"))?;
    for part in parts {
        for (ours, theirs) in all.film.pixels.iter_mut().zip(&part.film.pixels) {
            if theirs.samples > ours.samples {
                *ours = *theirs;
            }
        }
        all.film.aovs = all.film.aovs.or(part.film.aovs);
    }
    all.film.earlier = None;
    Ok(all)
}

/// The film of all samples of films that follow each other.
fn added_up(parts: Vec<(&Path, FilmFile)>) -> Result<FilmFile, Failure> {
    check(&parts)?;
    let mut parts = parts.into_iter();
    let (_, mut sum) = parts.next().ok_or_else(|| Failure::usage("nothing to merge"))?;
    for (path, part) in parts {
        sum.film.merge(&part.film).map_err(|error| Failure::mismatch(format!("{}: {error}", path.display())))?;
    }
    Ok(sum)
}

/// Refuses films that differ in more than their samples and their crops.
fn check_same_picture((path, part): &(&Path, FilmFile), (next_path, next): &(&Path, FilmFile)) -> Result<(), Failure> {
    let mut frame = next.frame.clone();
    (frame.first_sample, frame.region) = (part.frame.first_sample, part.frame.region);
    match part.difference(&frame, &next.scene) {
        Some(difference) => {
            let message = format!("{} and {} are not of one picture", path.display(), next_path.display());
            let failure = Failure::mismatch(format!("{message}: {}", difference.replace("asked for", "in the other")));
            let (own, other) = (&part.scene, &next.scene);
            Err(match own.content_hash != other.content_hash && own.name != other.name {
                true => failure.hint(format!(
                    "the scenes are {} and {}: one file under two names must be rendered under one of them",
                    own.name, other.name
                )),
                false => failure,
            })
        }
        None => Ok(()),
    }
}

/// Refuses films, ordered by their first sample, that are not parts of one picture that follow each other.
fn check(parts: &[(&Path, FilmFile)]) -> Result<(), Failure> {
    for (path, part) in parts {
        let (least, most) = part.film.sample_range();
        if parts.len() > 1 && least != most {
            let message = format!("{} was interrupted: its pixels hold {least} to {most} samples", path.display());
            return Err(Failure::mismatch(message).hint("finish it with `render --resume` first"));
        }
        if let Some(group) = part.film.unfinished_group().filter(|_| parts.len() > 1) {
            let message =
                format!("{} was interrupted: not all samples have the light of {}", path.display(), group.name());
            return Err(Failure::mismatch(message).hint("finish it with `render --resume` first"));
        }
    }
    for pair in parts.windows(2) {
        let [(path, part), (next_path, next)] = pair else { continue };
        check_same_picture(&pair[0], &pair[1])?;
        let (range, next_range) = (samples_of(part), samples_of(next));
        if range.1 != next_range.0 {
            let kind = if range.1 < next_range.0 { "leave a gap" } else { "overlap" };
            let message = format!(
                "the samples {}..{} of {} and {}..{} of {} {kind}",
                range.0,
                range.1,
                path.display(),
                next_range.0,
                next_range.1,
                next_path.display()
            );
            return Err(Failure::mismatch(message).hint("each film starts (--first-sample) where another one ends"));
        }
    }
    Ok(())
}

fn samples_of(part: &FilmFile) -> (u32, u32) {
    (part.film.first_sample, part.film.first_sample.saturating_add(part.film.sample_range().1))
}
