//! What several processes find out about the files of a cloud, each about some of them, and bring together: surveys, and what second
//! passes have measured. As bytes both travel from process to process.

use super::Grid;
use super::survey::{Announced, Measures, Survey};
use crate::fields::{FieldReader, FieldWriter};
use crate::points::source::{ExpectedTile, PointSource, TileFacts, TiledPoints};
use crate::points::{Attributes, ColorBy, PointCloud};
use crate::voxelize::fingerprint::of_description;
use crate::voxelize::{Placement, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use std::ops::Range;
use voxtrace_scene::brick::BRICK_SIZE;

/// First bytes of a survey and of what a second pass has measured. To be changed with what follows them.
const MAGICS: [&[u8; 8]; 2] = [b"voxsurv\x02", b"voxmeas\x01"];

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
    basis: Basis,
}

/// What a survey is of, and the parts of the work with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Basis {
    /// All points. Parts are made with it.
    Points,
    /// What headers and first points let expect. Parts are made with it, and what they find is held against it.
    Expected,
    /// All points, which have borne out what was expected: parts were made with that, and this is their key.
    BorneOut(u128),
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
pub(in crate::voxelize) fn check_files(files: &Range<usize>, count: usize) -> Result<(), VoxelizeError> {
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
        let mut look = Look::new(Announced::of(&*source, options).without_guess());
        progress.begin(headers[files.clone()].iter().sum());
        for number in files {
            let mut tile = look.begin(number);
            let facts = source.survey_tile(number, origin, &mut |piece| {
                look.add(&mut tile, piece);
                progress.add(piece.positions.len() as u64);
                !progress.is_cancelled()
            })?;
            if progress.is_cancelled() {
                return Err(VoxelizeError::Cancelled);
            }
            look.end(tile, facts);
        }
        Ok(look.survey((key_of(stamp, options), origin, headers.len() as u32)))
    }

    /// What headers and first points let expect of all files, for parts that are made before all points were seen; `None` where that is not enough:
    /// where densities, intensities or heights of all points decide something, or points are chosen.
    ///
    /// # Errors
    /// If files cannot be read.
    pub fn expected(
        (source, stamp): (&mut dyn TiledPoints, &str),
        options: &VoxelizeOptions,
    ) -> Result<Option<Self>, VoxelizeError> {
        if options.scale == Scale::Automatic {
            return Ok(None);
        }
        let (origin, Some(expected)) = (source.origin()?, source.expect()?) else { return Ok(None) };
        let offset = offset_of(origin);
        let mut survey = Survey::empty(&Announced::of(&*source, options).without_guess());
        let mut tiles = Vec::new();
        for (number, ExpectedTile { facts, bounds: (low, high) }) in expected.into_iter().enumerate() {
            let (low, high) = ((low - offset).as_vec3(), (high - offset).as_vec3());
            survey.expect(low, high, facts.chosen, source.count());
            tiles.push(SurveyedTile { facts, low, high, number: number as u32, unused: 0 });
        }
        let (key, count) = (key_of(stamp, options), tiles.len() as u32);
        let own = Self { key, origin, count, tiles, survey, basis: Basis::Expected };
        let is_enough = matches!(own.color_by(options), Ok(ColorBy::Rgb | ColorBy::Classification));
        Ok((is_enough && own.check_whole().is_ok()).then_some(own))
    }

    /// Holds what parts have found in all files against what they were made with; whether it is borne out. If so, those parts are parts of this survey;
    /// if not, parts are to be made with this survey, which is as good as any.
    ///
    /// # Errors
    /// If it is not of all files, or of other work; if there is no grid for it.
    pub fn bear_out(&mut self, expected: &Self, options: &VoxelizeOptions) -> Result<bool, VoxelizeError> {
        self.check_whole()?;
        if expected.basis != Basis::Expected || self.key != expected.key || self.count != expected.count {
            return wrong("what was expected is of other files, or with other options");
        }
        let by = self.color_by(options)?;
        let is_so = self.origin.map(bits) == expected.origin.map(bits)
            && self.placement(options)? == expected.placement(options)?
            && by == expected.color_by(options)?
            && {
                let grid = Grid::of(self.placement(options)?, self.survey.scale(options))?;
                self.tiles.iter().zip(&expected.tiles).all(|(found, expected)| found.is_within(expected, &grid, by))
            };
        if is_so {
            self.basis = Basis::BorneOut(expected.part_key());
        }
        Ok(is_so)
    }

    /// Whether it is what headers and first points let expect.
    pub fn is_expected(&self) -> bool {
        self.basis == Basis::Expected
    }

    fn placement(&self, options: &VoxelizeOptions) -> Result<Placement, VoxelizeError> {
        self.survey.placement(offset_of(self.origin), options)
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
            if [other.basis, all.basis] != [Basis::Points; 2] {
                return wrong("what is expected of files is no survey of them");
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
        match self.basis {
            Basis::BorneOut(key) => key,
            basis => of_description(&(self.later_key(), self.survey.found_later(), basis)),
        }
    }

    /// What a look at some files in this work is known by: the work, what positions are relative to, and how many files there are.
    pub(super) fn about(&self) -> (u128, Option<DVec3>, u32) {
        (self.key, self.origin, self.count)
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
        let (basis, parts) = match self.basis {
            Basis::Points => (0u8, 0),
            Basis::Expected => (1, 0),
            Basis::BorneOut(key) => (2, key),
        };
        out.value(basis);
        out.value(parts);
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
            let count = from.value()?;
            let basis = match (from.value::<u8>()?, from.value()?) {
                (0, _) => Basis::Points,
                (1, _) => Basis::Expected,
                (_, key) => Basis::BorneOut(key),
            };
            let tiles = from.values()?;
            Some(Self { key, origin, count, tiles, survey: Survey::read(&mut from)?, basis })
        };
        read().map_or_else(|| wrong("no survey of this version, or damaged"), Ok)
    }
}

/// A pass over some files, of which a survey comes.
pub(super) struct Look {
    announced: Announced,
    survey: Survey,
    tiles: Vec<SurveyedTile>,
}

impl Look {
    pub fn new(announced: Announced) -> Self {
        Self { survey: Survey::empty(&announced), announced, tiles: Vec::new() }
    }

    /// A file of which no point was seen yet.
    pub fn begin(&self, number: usize) -> SurveyedTile {
        let (low, high, facts) = (Vec3::INFINITY, Vec3::NEG_INFINITY, TileFacts::default());
        SurveyedTile { facts, low, high, number: number as u32, unused: 0 }
    }

    /// Points of a file.
    pub fn add(&mut self, tile: &mut SurveyedTile, piece: &PointCloud) {
        for &point in &piece.positions {
            (tile.low, tile.high) = (tile.low.min(point), tile.high.max(point));
        }
        self.survey.add(piece, &self.announced);
    }

    /// That was the file.
    pub fn end(&mut self, tile: SurveyedTile, facts: TileFacts) {
        self.tiles.push(SurveyedTile { facts, ..tile });
    }

    /// The survey of these files, in a work, with this origin, of so many files.
    pub fn survey(mut self, (key, origin, count): (u128, Option<DVec3>, u32)) -> TileSurvey {
        // So that the samples of all files together are no more than one is.
        self.survey.thin_sample(self.announced.points);
        let Self { survey, tiles, .. } = self;
        let mut own = TileSurvey { key, origin, count, tiles, survey, basis: Basis::Points };
        own.settle();
        own
    }
}

impl SurveyedTile {
    /// Whether what was found in the file changes nothing of what was made with what was expected: its bricks, and what its points say.
    fn is_within(&self, expected: &Self, grid: &Grid, by: ColorBy) -> bool {
        if self.facts.chosen == 0 {
            return true;
        }
        let brick = |point: Vec3| grid.voxel(point) / BRICK_SIZE;
        // Whether there are colours, and whether they have more than 8 bits.
        let colors = |tile: &Self| (tile.facts.largest_color > 0, tile.facts.largest_color > 255);
        let says_the_same = match by {
            ColorBy::Classification => self.facts.has_classes == expected.facts.has_classes,
            _ => colors(self) == colors(expected),
        };
        expected.facts.chosen > 0
            && says_the_same
            && brick(expected.low).cmple(brick(self.low)).all()
            && brick(self.high).cmple(brick(expected.high)).all()
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

/// What positions that are relative to the first point have as their offset.
fn offset_of(origin: Option<DVec3>) -> DVec3 {
    origin.filter(|origin| origin.is_finite()).unwrap_or(DVec3::ZERO)
}

fn bits(place: DVec3) -> [u64; 3] {
    place.to_array().map(f64::to_bits)
}
