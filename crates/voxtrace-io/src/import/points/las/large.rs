//! LAS and LAZ files larger than memory: points are read, or decompressed, some at a time, of one file after the other.

use super::compressed::Decompressor;
use super::records::{LeftOut, Records, Seen, facts_of, found_by};
use super::tiles::{Tile, Tiles, complete, either, joint, uncolored_note};
use super::{BATCH, check_length};
use crate::import::reader::{ImportOptions, PointFilter};
use crate::import::source::input::Input;
use glam::DVec3;
use rayon::prelude::*;
use std::fs::File;
use std::io::BufReader;
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::points::source::{ExpectedTile, PointSource, TileFacts, TiledPoints};
use voxtrace_voxelize::points::{Attributes, PointCloud};
use voxtrace_voxelize::{ImportError, Limits};

/// First points of a file, from which others are expected to say the same.
const EXPECTED_BY: u64 = 5000;
/// Bytes of points decompressed at once, about.
const DECOMPRESSED: usize = 32 << 20;

/// The points of LAS or LAZ files.
pub(crate) struct LasPoints {
    /// What names them in errors.
    path: PathBuf,
    limits: Limits,
    all: Tiles,
    /// What the points of each file have that says something, once they were read.
    seen: Vec<Seen>,
    /// What positions are relative to, once a point has decided.
    origin: Option<DVec3>,
    /// The files that passes are over.
    chosen: Range<usize>,
}

/// What a pass over the points has found.
#[derive(Default)]
struct Pass {
    seen: Vec<Seen>,
    left_out: LeftOut,
    chosen: u64,
}

impl LasPoints {
    /// Opens files. How much may come out of one that is compressed, its own length says.
    pub fn open(path: &Path, files: &[PathBuf], options: &ImportOptions) -> Result<Self, ImportError> {
        let limits = Limits { bytes: u64::MAX, points: u64::MAX, ..options.limits };
        let all = Tiles::open(path, files, options)?;
        let chosen = 0..all.tiles.len();
        let own = Self { path: path.into(), limits, all, seen: Vec::new(), origin: None, chosen };
        for tile in &own.all.tiles {
            if tile.header.is_compressed {
                own.decompressor(tile).map(drop)?;
            } else {
                check_length(&Input::open(&tile.path, &limits)?, &tile.header)?;
            }
        }
        Ok(own)
    }

    /// Bytes that the cloud would take in memory, while it is read.
    pub fn size_bytes(&self) -> u64 {
        self.count().saturating_mul(24)
    }

    fn decompressor(&self, tile: &Tile) -> Result<Decompressor, ImportError> {
        crate::import::source::opened::note(&tile.path);
        let file = File::open(&tile.path).map_err(|error| ImportError::io(&tile.path, error))?;
        Decompressor::open(&tile.path, Box::new(BufReader::new(file)), tile.length, &tile.header, &self.limits)
    }

    /// The attributes that the points of a piece get: before all are known, every one that there may be.
    fn attributes_of_pieces(&self) -> Attributes {
        if self.seen.is_empty() {
            return Attributes { colors: false, intensities: true, classes: true };
        }
        self.attributes()
    }

    /// Reads the points of a file; whether more are wanted.
    fn read(
        &self,
        tile: &Tile,
        records: &mut Records,
        each: &mut dyn FnMut(&PointCloud) -> bool,
    ) -> Result<bool, ImportError> {
        let has = self.attributes_of_pieces();
        let mut give = |records: &mut Records| {
            let piece = records.piece();
            complete(piece, has);
            let goes_on = each(piece);
            records.clear();
            goes_on
        };
        if tile.header.is_compressed {
            let mut points = self.decompressor(tile)?;
            while points.next(records, DECOMPRESSED)? {
                if !give(records) {
                    return Ok(false);
                }
            }
            return Ok(true);
        }
        let size = u64::from(tile.header.record_size);
        let mut input = Input::open_at(&tile.path, tile.header.data, &self.limits)?;
        let mut left = tile.header.points;
        while left > 0 {
            let now = left.min(BATCH);
            records.add(input.take((now * size) as usize, "the points")?);
            if !give(records) {
                return Ok(false);
            }
            left -= now;
        }
        Ok(true)
    }

    /// Makes a pass over the points of a file, of which something is known or nothing.
    fn facts_of_tile(
        &self,
        tile: &Tile,
        known: Option<Seen>,
        origin: Option<DVec3>,
        each: &mut dyn FnMut(&PointCloud) -> bool,
    ) -> Result<TileFacts, ImportError> {
        let mut records = Records::new(&tile.header, known, origin);
        self.read(tile, &mut records, each)?;
        Ok(facts_of(records.seen(), records.left_out(), records.chosen()))
    }

    /// What the header and the first points of a file let expect.
    fn expect_of(&self, tile: &Tile) -> Result<Option<ExpectedTile>, ImportError> {
        let mut records = Records::new(&tile.header, None, None);
        if tile.header.points == 0 {
            let bounds = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            return Ok(Some(ExpectedTile { facts: facts_of(records.seen(), records.left_out(), 0), bounds }));
        }
        let Some(bounds) = tile.header.span() else { return Ok(None) };
        if tile.header.is_compressed {
            self.decompressor(tile)?.first(&mut records, EXPECTED_BY as u32)?;
        } else {
            let size = u64::from(tile.header.record_size);
            let first = tile.header.points.min(EXPECTED_BY);
            let mut input = Input::open_at(&tile.path, tile.header.data, &self.limits)?;
            records.add(input.take((first * size) as usize, "the points")?);
        }
        Ok(Some(ExpectedTile { facts: facts_of(records.seen(), records.left_out(), tile.header.points), bounds }))
    }

    /// Keeps what the first pass has found; so many points are kept of each file.
    fn keep(&mut self, pass: Pass, chosen_of: &[u64]) {
        let has_colors = pass.seen.iter().any(|seen| seen.attributes().colors);
        let bare = pass.seen.iter().zip(chosen_of).filter(|(seen, _)| !seen.attributes().colors);
        let uncolored = if has_colors { bare.map(|(_, chosen)| chosen).sum() } else { 0 };
        let frame = &mut self.all.frame;
        frame.offset = self.origin.filter(|offset| offset.is_finite()).unwrap_or(DVec3::ZERO);
        frame.notes.extend(pass.left_out.notes());
        frame.notes.extend(uncolored_note(uncolored));
        self.seen = pass.seen;
    }
}

impl PointSource for LasPoints {
    fn frame(&mut self) -> &mut PointCloud {
        &mut self.all.frame
    }

    fn count(&self) -> u64 {
        self.all.tiles.iter().fold(0, |sum, tile| sum.saturating_add(tile.header.points))
    }

    fn attributes(&self) -> Attributes {
        self.seen.iter().fold(Attributes::default(), |has, seen| either(has, seen.attributes()))
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        let spans = self.all.tiles.iter().filter_map(|tile| tile.header.span());
        let (mut low, mut high) = joint(spans)?;
        if let Some(wanted) = self.all.tiles.first().and_then(|tile| tile.header.filter.bounds) {
            (low, high) = (low.max(wanted.low), high.min(wanted.high));
        }
        low.cmple(high).all().then_some((low, high))
    }

    fn tiled(&mut self) -> Option<&mut dyn TiledPoints> {
        Some(self)
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        let mut pass = Pass::default();
        let mut chosen_of = Vec::new();
        for at in self.chosen.clone() {
            let tile = &self.all.tiles[at];
            let mut records = Records::new(&tile.header, self.seen.get(at).copied(), self.origin);
            let goes_on = self.read(tile, &mut records, each)?;
            pass.seen.push(records.seen());
            pass.left_out.join(records.left_out());
            pass.chosen += records.chosen();
            chosen_of.push(records.chosen());
            self.origin = records.origin();
            if !goes_on {
                return Ok(());
            }
        }
        if pass.chosen == 0 && pass.left_out.not_chosen > 0 && self.chosen.len() == self.all.tiles.len() {
            return Err(self.all.none_left(&self.path, &pass.left_out));
        }
        if self.seen.is_empty() {
            self.keep(pass, &chosen_of);
        }
        Ok(())
    }
}

impl TiledPoints for LasPoints {
    fn points_of_tiles(&mut self) -> Vec<u64> {
        self.all.tiles.iter().map(|tile| tile.header.points).collect()
    }

    fn origin(&mut self) -> Result<Option<DVec3>, ImportError> {
        for tile in &self.all.tiles {
            if self.origin.is_some() {
                break;
            }
            let mut records = Records::new(&tile.header, None, None);
            if tile.header.is_compressed {
                self.decompressor(tile)?.look_for_offset(&mut records)?;
            } else {
                self.read(tile, &mut records, &mut |piece| piece.positions.is_empty())?;
            }
            self.origin = records.origin();
        }
        Ok(self.origin)
    }

    fn survey_tile(
        &mut self,
        tile: usize,
        origin: Option<DVec3>,
        each: &mut dyn FnMut(&PointCloud) -> bool,
    ) -> Result<TileFacts, ImportError> {
        self.facts_of_tile(&self.all.tiles[tile], None, origin, each)
    }

    fn expect(&mut self) -> Result<Option<Vec<ExpectedTile>>, ImportError> {
        if self.all.tiles.iter().any(|tile| tile.header.filter != PointFilter::default()) {
            return Ok(None);
        }
        let expected: Result<Vec<Option<ExpectedTile>>, ImportError> =
            self.all.tiles.par_iter().map(|tile| self.expect_of(tile)).collect();
        Ok(expected?.into_iter().collect())
    }

    fn visit_tile(&mut self, tile: usize, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<TileFacts, ImportError> {
        self.facts_of_tile(&self.all.tiles[tile], self.seen.get(tile).copied(), self.origin, each)
    }

    fn learn(&mut self, origin: Option<DVec3>, facts: &[TileFacts]) -> Result<(), ImportError> {
        let mut pass = Pass::default();
        for (seen, left_out) in facts.iter().map(found_by) {
            pass.seen.push(seen);
            pass.left_out.join(left_out);
        }
        let chosen_of: Vec<u64> = facts.iter().map(|facts| facts.chosen).collect();
        pass.chosen = chosen_of.iter().sum();
        if pass.chosen == 0 && pass.left_out.not_chosen > 0 {
            return Err(self.all.none_left(&self.path, &pass.left_out));
        }
        self.origin = origin;
        if self.seen.is_empty() {
            self.keep(pass, &chosen_of);
        }
        Ok(())
    }

    fn choose(&mut self, tiles: Range<usize>) {
        self.chosen = tiles;
    }
}
