//! What several processes find out about the files of a cloud, each about some of them, and bring together: surveys, and what second
//! passes have measured. As bytes both travel from process to process.

use super::survey::{Announced, Measures, Survey};
use crate::fields::{FieldReader, FieldWriter};
use crate::points::source::{PointSource, TileFacts, TiledPoints};
use crate::points::{Attributes, ColorBy};
use crate::voxelize::fingerprint::of_description;
use crate::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use std::ops::Range;

/// First bytes of a survey and of what a second pass has measured. To be changed with what follows them.
const MAGICS: [&[u8; 8]; 2] = [b"voxsurv\x01", b"voxmeas\x01"];

/// A survey of some files of a cloud, or of all of them.
pub struct TileSurvey {
    /// The work that it is for.
    key: u128,
    /// What positions are relative to.
    origin: Option<DVec3>,
    /// Number of files of the cloud.
    count: u32,
    /// Those that were surveyed, in their order.
    tiles: Vec<SurveyedTile>,
    survey: Survey,
}

/// A file, the bounds of its points, and what else was found in it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(in crate::voxelize) struct SurveyedTile {
    pub facts: TileFacts,
    pub low: Vec3,
    pub high: Vec3,
    pub number: u32,
    unused: u32,
}

/// What a second pass over some files has measured.
struct TileMeasures {
    key: u128,
    /// The files, in their order.
    tiles: Vec<u32>,
    measures: Measures,
}

/// The work that a cloud and options are: what else makes another scene is in `stamp`.
fn key_of(stamp: &str, options: &VoxelizeOptions) -> u128 {
    of_description(&(stamp, VoxelizeOptions { memory_budget: None, ..*options }))
}

fn wrong<T>(what: impl Into<String>) -> Result<T, VoxelizeError> {
    Err(VoxelizeError::Parts(what.into()))
}

/// Checks a range of files.
pub(super) fn check_files(files: &Range<usize>, count: usize) -> Result<(), VoxelizeError> {
    if files.start < files.end && files.end <= count {
        return Ok(());
    }
    wrong(format!("there are no files {}..{} among {count}", files.start, files.end))
}

impl TileSurvey {
    /// Makes the first pass over some files. `stamp` tells the cloud from others, whoever reads it.
    ///
    /// # Errors
    /// If there are no such files, they cannot be read, or it was cancelled.
    pub fn of(
        (source, stamp): (&mut dyn TiledPoints, &str),
        files: Range<usize>,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        let headers = source.points_of_tiles();
        check_files(&files, headers.len())?;
        let origin = source.origin()?;
        let announced = Announced::of(&*source, options);
        let (mut survey, mut tiles) = (Survey::empty(&announced), Vec::new());
        progress.begin(headers[files.clone()].iter().sum());
        for number in files {
            let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let facts = source.survey_tile(number, origin, &mut |piece| {
                for &point in &piece.positions {
                    (low, high) = (low.min(point), high.max(point));
                }
                survey.add(piece, &announced);
                progress.add(piece.positions.len() as u64);
                !progress.is_cancelled()
            })?;
            if progress.is_cancelled() {
                return Err(VoxelizeError::Cancelled);
            }
            tiles.push(SurveyedTile { facts, low, high, number: number as u32, unused: 0 });
        }
        // So that the samples of all files together are no more than one is.
        survey.thin_sample(announced.points);
        let mut own = Self { key: key_of(stamp, options), origin, count: headers.len() as u32, tiles, survey };
        own.settle();
        Ok(own)
    }

    /// What was found by several processes together: of surveys one of all their files, in which `measures` of all files are taken.
    ///
    /// # Errors
    /// If they are not of one work, a file is in two of them, or measures come before the survey is whole.
    fn join(surveys: Vec<Self>, measures: Option<TileMeasures>) -> Result<Self, VoxelizeError> {
        let mut surveys = surveys.into_iter();
        let Some(mut all) = surveys.next() else { return wrong("no survey is given") };
        for other in surveys {
            if (other.key, other.origin.map(bits), other.count) != (all.key, all.origin.map(bits), all.count) {
                return wrong("two surveys are of other files, or with other options");
            }
            all.tiles.extend(other.tiles);
            all.survey.join(other.survey);
        }
        all.tiles.sort_by_key(|tile| tile.number);
        if let Some(pair) = all.tiles.windows(2).find(|pair| pair[0].number == pair[1].number) {
            return wrong(format!("file {} is in two surveys", pair[0].number));
        }
        all.settle();
        if let Some(measures) = measures {
            all.check_whole()?;
            if measures.key != all.later_key() {
                return wrong("what was measured is of other files, or after another survey");
            }
            check_all(&measures.tiles, all.count, "measured")?;
            all.survey.take(measures.measures);
        }
        Ok(all)
    }

    fn settle(&mut self) {
        if self.tiles.len() == self.count as usize && self.survey.points() > 0 {
            self.survey.settle();
        }
    }

    /// Checks that all files were surveyed, and that there are points.
    fn check_whole(&self) -> Result<(), VoxelizeError> {
        let numbers: Vec<u32> = self.tiles.iter().map(|tile| tile.number).collect();
        check_all(&numbers, self.count, "surveyed")?;
        // Where all were left out, whoever takes the facts says so.
        let is_empty = self.tiles.iter().all(|tile| tile.facts.chosen == 0 && tile.facts.not_chosen == 0);
        if is_empty { Err(VoxelizeError::NoPoints) } else { Ok(()) }
    }

    /// The work that second passes are.
    fn later_key(&self) -> u128 {
        of_description(&(self.key, self.survey.summary()))
    }

    /// The work that parts are.
    pub(super) fn part_key(&self) -> u128 {
        of_description(&(self.later_key(), self.survey.found_later()))
    }

    /// Number of points that are kept, of the files that were surveyed.
    pub fn points(&self) -> u64 {
        self.survey.points()
    }

    /// Number of files of the cloud.
    pub fn tile_count(&self) -> usize {
        self.count as usize
    }

    /// The attribute that colours the points.
    fn color_by(&self, options: &VoxelizeOptions) -> Result<ColorBy, VoxelizeError> {
        let facts = || self.tiles.iter().map(|tile| tile.facts);
        let has = Attributes {
            colors: facts().any(|facts| facts.largest_color > 0),
            intensities: facts().any(|facts| facts.has_intensities > 0),
            classes: facts().any(|facts| facts.has_classes > 0),
        };
        options.points.color_by.resolved(has).map_err(VoxelizeError::Missing)
    }

    /// Whether a second pass over all files is wanted before any is voxelized: to choose the resolution by their density where the
    /// headers announced other bounds or numbers of points, or to colour them by height.
    ///
    /// # Errors
    /// If not all files were surveyed, there are no points, or they do not have the attribute that is to colour them.
    pub fn wants_measures(&self, options: &VoxelizeOptions) -> Result<bool, VoxelizeError> {
        self.check_whole()?;
        let (wants_density, wants_heights) = self.survey.wants(options, self.color_by(options)?);
        Ok(wants_density || wants_heights)
    }

    /// Lets a source know all that was found, if it is of all of its files and with these options.
    ///
    /// # Errors
    /// If it is not, or there are no points.
    pub fn teach_all(
        &self,
        (source, stamp): (&mut dyn TiledPoints, &str),
        options: &VoxelizeOptions,
    ) -> Result<(), VoxelizeError> {
        self.teach((source, stamp), 0..self.tile_count(), options)
    }

    /// Lets a source know all that was found, and makes it pass over these files alone.
    pub(super) fn teach(
        &self,
        (source, stamp): (&mut dyn TiledPoints, &str),
        files: Range<usize>,
        options: &VoxelizeOptions,
    ) -> Result<(), VoxelizeError> {
        if self.key != key_of(stamp, options) || source.points_of_tiles().len() != self.count as usize {
            return wrong("the survey is of other files, or with other options");
        }
        self.check_whole()?;
        check_files(&files, self.count as usize)?;
        let facts: Vec<TileFacts> = self.tiles.iter().map(|tile| tile.facts).collect();
        source.learn(self.origin, &facts)?;
        source.choose(files);
        Ok(())
    }

    /// Makes the second pass over some files, if one is wanted: bytes that [`joined_bytes`] takes with those of the others.
    ///
    /// # Errors
    /// As [`Self::of`]; also if the survey is not whole or of other work.
    pub fn measure(
        &self,
        (source, stamp): (&mut dyn TiledPoints, &str),
        files: Range<usize>,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<Vec<u8>, VoxelizeError> {
        let wants = self.survey.wants(options, self.color_by(options)?);
        self.teach((&mut *source, stamp), files.clone(), options)?;
        let tiles = files.map(|file| file as u32).collect();
        let source: &mut dyn PointSource = source;
        Ok(TileMeasures { key: self.later_key(), tiles, measures: self.survey.measure(source, wants, progress)? }
            .into_bytes())
    }

    pub(super) fn survey(&self) -> &Survey {
        &self.survey
    }

    pub(super) fn tiles(&self) -> &[SurveyedTile] {
        &self.tiles
    }

    /// The survey as bytes.
    pub fn to_bytes(&mut self) -> Vec<u8> {
        let mut out = FieldWriter::new(MAGICS[0]);
        out.value(self.key);
        out.value(u8::from(self.origin.is_some()));
        out.value(self.origin.unwrap_or_default());
        out.value(self.count);
        out.values(&self.tiles);
        self.survey.write(&mut out);
        out.finish()
    }

    /// The survey of such bytes.
    ///
    /// # Errors
    /// If they are none, or damaged.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, VoxelizeError> {
        let read = || {
            let mut from = FieldReader::open(bytes, MAGICS[0])?;
            let (key, has_origin, origin) = (from.value()?, from.value::<u8>()?, from.value()?);
            let origin = (has_origin > 0).then_some(origin);
            let (count, tiles) = (from.value()?, from.values()?);
            Some(Self { key, origin, count, tiles, survey: Survey::read(&mut from)? })
        };
        read().map_or_else(|| wrong("no survey of this version, or damaged"), Ok)
    }
}

impl TileMeasures {
    fn join(measures: Vec<Self>) -> Result<Option<Self>, VoxelizeError> {
        let mut measures = measures.into_iter();
        let Some(mut all) = measures.next() else { return Ok(None) };
        for other in measures {
            if other.key != all.key {
                return wrong("what was measured is of other files, or after other surveys");
            }
            all.tiles.extend(other.tiles);
            all.measures = all.measures.joined(other.measures);
        }
        all.tiles.sort_unstable();
        match all.tiles.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => wrong(format!("file {} was measured twice", pair[0])),
            None => Ok(Some(all)),
        }
    }

    fn into_bytes(mut self) -> Vec<u8> {
        let mut out = FieldWriter::new(MAGICS[1]);
        out.value(self.key);
        out.values(&self.tiles);
        self.measures.write(&mut out);
        out.finish()
    }

    fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut from = FieldReader::open(bytes, MAGICS[1])?;
        Some(Self { key: from.value()?, tiles: from.values()?, measures: Measures::read(&mut from)? })
    }
}

/// Brings together what several processes have found, surveys and what second passes have measured, in any order and in any steps.
///
/// # Errors
/// If they do not belong together, or some are damaged.
pub fn joined_bytes<'a>(found: impl IntoIterator<Item = &'a [u8]>) -> Result<Vec<u8>, VoxelizeError> {
    let (mut surveys, mut measures) = (Vec::new(), Vec::new());
    for bytes in found {
        match TileMeasures::from_bytes(bytes) {
            Some(found) => measures.push(found),
            None => surveys.push(TileSurvey::from_bytes(bytes)?),
        }
    }
    let measures = TileMeasures::join(measures)?;
    match measures {
        Some(measures) if surveys.is_empty() => Ok(measures.into_bytes()),
        measures => Ok(TileSurvey::join(surveys, measures)?.to_bytes()),
    }
}

/// Checks that of `count` files each is there; `numbers` ascend.
fn check_all(numbers: &[u32], count: u32, what: &str) -> Result<(), VoxelizeError> {
    let missing = (0..count).zip(numbers.iter().map(Some).chain(std::iter::repeat(None)));
    match missing.into_iter().find(|(wanted, there)| *there != Some(wanted)) {
        Some((file, _)) => wrong(format!("file {file} of {count} was not {what}")),
        None => Ok(()),
    }
}

fn bits(place: DVec3) -> [u64; 3] {
    place.to_array().map(f64::to_bits)
}
