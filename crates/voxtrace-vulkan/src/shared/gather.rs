//! Where the parts of a picture come together: ranges of samples are added once those before them are there, bands of rows take their place.

use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::Range;
use voxtrace_core::{Film, Frame, Region};

/// Adds the samples of a film that begins where ours ends.
fn add(film: &mut Film, part: &Film) {
    film.pixels.par_iter_mut().zip(&part.pixels).for_each(|(ours, theirs)| ours.merge(theirs));
}

/// How a picture is shared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// A unit is a sample of all pixels, counted from the first of the picture.
    Samples,
    /// A unit is a row of the region, with all that its pixels lack.
    Rows,
}

/// A film that grows by parts.
pub struct Gathered {
    pub film: Film,
    units: Units,
    /// Samples that the film has, of all pixels, where it is shared by samples.
    joined: u32,
    /// Parts that begin later: by their first sample, the end of them and their film.
    waiting: BTreeMap<u32, (u32, Film)>,
    /// Units that are still missing.
    missing: usize,
}

impl Gathered {
    pub fn new(film: Film, units: Units, all: &Range<u32>) -> Self {
        Self { film, units, joined: all.start, waiting: BTreeMap::new(), missing: all.len() }
    }

    pub fn is_complete(&self) -> bool {
        self.missing == 0
    }

    /// What a device has to do for a part, and the film that it continues, where that is not black.
    pub fn task(&self, frame: &Frame, part: &Range<u32>) -> (Frame, Option<Film>) {
        match self.units {
            Units::Samples => {
                let first = frame.first_sample + part.start;
                (frame.clone().first_sample(first).samples(part.len() as u32), None)
            }
            Units::Rows => {
                let frame = frame.clone().region(self.band(part));
                let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
                film.pixels.copy_from_slice(&self.film.pixels[self.places(part)]);
                let is_begun = film.sample_range().1 > 0;
                (frame, is_begun.then_some(film))
            }
        }
    }

    /// Takes the film of a part, whole.
    pub fn put(&mut self, part: &Range<u32>, film: Film) {
        self.missing -= part.len();
        match self.units {
            Units::Samples => {
                self.wait(part.clone(), film);
                while let Some((end, next)) = self.waiting.remove(&self.joined) {
                    // The first one takes the place of a film without samples.
                    match std::mem::replace(&mut self.joined, end) {
                        0 => self.film.pixels = next.pixels,
                        _ => add(&mut self.film, &next),
                    }
                }
            }
            Units::Rows => self.put_rows(part, &film),
        }
    }

    /// Takes what there is of a part that was broken off, where it can be of use. Of samples, nothing joins it any more.
    pub fn put_unfinished(&mut self, part: &Range<u32>, film: &Film) {
        match self.units {
            Units::Samples if part.start == self.joined => {
                self.joined = u32::MAX;
                add(&mut self.film, film);
            }
            Units::Samples => {}
            Units::Rows => self.put_rows(part, film),
        }
    }

    /// Keeps a part until those before it are there, as one with its neighbours: there are never more films than devices.
    fn wait(&mut self, part: Range<u32>, mut film: Film) {
        let mut end = part.end;
        if let Some((end_after, after)) = self.waiting.remove(&end) {
            add(&mut film, &after);
            end = end_after;
        }
        match self.waiting.range_mut(..part.start).next_back() {
            Some((_, (end_before, before))) if *end_before == part.start => {
                add(before, &film);
                *end_before = end;
            }
            _ => drop(self.waiting.insert(part.start, (end, film))),
        }
    }

    fn put_rows(&mut self, part: &Range<u32>, film: &Film) {
        let places = self.places(part);
        self.film.pixels[places].copy_from_slice(&film.pixels);
    }

    fn band(&self, rows: &Range<u32>) -> Region {
        let region = self.film.region;
        Region { y0: region.y0 + rows.start, y1: region.y0 + rows.end, ..region }
    }

    fn places(&self, rows: &Range<u32>) -> Range<usize> {
        let width = self.film.region.width() as usize;
        rows.start as usize * width..rows.end as usize * width
    }
}
