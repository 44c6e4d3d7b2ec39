//! Tiles of a scan that are one cloud: several files, or those of a folder. All are measured from one origin, so that nothing
//! depends on how many files there are.

use super::frame::{self, Joint};
use super::header::Header;
use super::records::{LeftOut, Records};
use super::reference;
use crate::import::reader::map_units::{Horizontal, MapUnits};
use crate::import::reader::{ImportOptions, none_left, same_system};
use crate::import::source::input::Input;
use glam::DVec3;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::points::{Attributes, PointCloud};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Colour of points without one among others that have one, sRGB.
const NO_COLOR: [u8; 3] = [128; 3];

/// A file whose header was read.
pub(super) struct Tile {
    pub path: PathBuf,
    /// Bytes of the file.
    pub length: u64,
    pub header: Header,
    crs: String,
    units: MapUnits,
}

/// Several files, and what is known of all their points.
pub(super) struct Tiles {
    pub tiles: Vec<Tile>,
    /// The cloud without its points.
    pub frame: PointCloud,
    /// The box around all points in the coordinates of the map, as the headers tell it.
    pub span: Option<(DVec3, DVec3)>,
    /// Points of all files, those that lie outside of what is asked for included.
    pub points: u64,
}

impl Tile {
    /// Reads the header of a file.
    pub fn open(path: &Path, limits: &Limits) -> Result<Self, ImportError> {
        Self::of(&mut Input::open(path, limits)?)
    }

    /// Reads a header, and takes nothing of the input.
    pub fn of(input: &mut Input) -> Result<Self, ImportError> {
        let header = Header::read(input)?;
        let (crs, units) = reference::read(input, &header)?;
        Ok(Self { path: input.path().into(), length: input.remaining().unwrap_or(0), header, crs, units })
    }

    /// Whether it says what its coordinates are.
    fn has_system(&self) -> bool {
        !self.crs.is_empty() || self.units != MapUnits::default()
    }

    /// Checks that the points of both may be one cloud.
    fn check_beside(&self, first: &Self, is_unit_asked: bool) -> Result<(), ImportError> {
        let other = |what: String| Err(ImportError::of_file(&self.path, ImportErrorKind::OtherTiles(what)));
        let beside = first.path.display();
        let units = |tile: &Self| {
            let heights = tile.units.vertical.suffix();
            match tile.units.horizontal {
                Horizontal::Angle(_) => format!(" degrees, heights in{heights}"),
                Horizontal::Length(unit) if heights.is_empty() => unit.suffix().to_owned(),
                Horizontal::Length(unit) => format!("{}, heights in{heights}", unit.suffix()),
            }
        };
        if self.units != first.units && !is_unit_asked {
            return other(format!("the tile is in{}, and {beside} is in{}", units(self), units(first)));
        }
        if !self.crs.is_empty() && !first.crs.is_empty() && !same_system::is_same(&self.crs, &first.crs) {
            let [own, theirs] = [self, first].map(|tile| same_system::name(&tile.crs));
            return other(format!("the tile is in the reference system {own}, and {beside} is in {theirs}"));
        }
        Ok(())
    }
}

impl Tiles {
    /// Reads the headers of several files. Those that lie outside of the box that is asked for are left out, as their headers tell.
    pub fn open(path: &Path, files: &[PathBuf], options: &ImportOptions) -> Result<Self, ImportError> {
        let headers = Limits { bytes: u64::MAX, ..options.limits };
        let tiles = files.iter().map(|file| Tile::open(file, &headers)).collect::<Result<Vec<_>, _>>()?;
        Self::join(path, tiles, options)
    }

    /// Makes one cloud of files whose headers were read. `path` names them in errors.
    pub fn join(path: &Path, mut tiles: Vec<Tile>, options: &ImportOptions) -> Result<Self, ImportError> {
        let mut silent = 0;
        let first = tiles.iter().position(Tile::has_system).unwrap_or(0);
        for at in 0..tiles.len() {
            if tiles[at].has_system() {
                tiles[at].check_beside(&tiles[first], options.unit.is_some())?;
            } else if tiles[first].has_system() {
                (tiles[at].crs, tiles[at].units) = (tiles[first].crs.clone(), tiles[first].units);
                silent += 1;
            }
        }
        let all = tiles.len();
        let points = tiles.iter().fold(0u64, |sum, tile| sum.saturating_add(tile.header.points));
        let span = joint(tiles.iter().filter_map(|tile| tile.header.span()));
        if let Some(wanted) = options.points.bounds {
            tiles.retain(|tile| tile.header.span().is_none_or(|span| wanted.touches(span)));
        }
        let bounds = joint(tiles.iter().filter_map(|tile| tile.header.span()));
        let (crs, units) = tiles.first().map(|tile| (tile.crs.clone(), tile.units)).unwrap_or_default();
        let Joint { origin, scale, mut frame } = frame::settle(bounds, crs, units, options.unit);
        for tile in &mut tiles {
            tile.header.filter = options.points;
            tile.header.change(origin, scale);
        }
        if silent > 0 {
            frame.notes.push(format!("{silent} of {all} tiles say no reference system: that of the others is taken"));
        }
        let own = Self { tiles, frame, span, points };
        if own.tiles.is_empty() && points > 0 { Err(own.none_left(path, &LeftOut::default())) } else { Ok(own) }
    }

    /// The error where no point is among those that are asked for.
    pub fn none_left(&self, path: &Path, left_out: &LeftOut) -> ImportError {
        let what = none_left(self.points, self.span, left_out.classes);
        ImportError::of_file(path, ImportErrorKind::NothingChosen(what))
    }

    /// The points of all files, in memory.
    pub fn read(self, path: &Path, limits: &Limits) -> Result<PointCloud, ImportError> {
        let count = self.tiles.iter().fold(0u64, |sum, tile| sum.saturating_add(tile.header.points));
        if count > limits.points {
            return Err(ImportError::limit(path, None, "points", count, limits.points));
        }
        let (mut all, mut left_out) = (Gathered::default(), LeftOut::default());
        for tile in &self.tiles {
            let mut records = Records::new(&tile.header, None, all.origin);
            super::read_points(Input::open(&tile.path, limits)?, &tile.header, limits, &mut records)?;
            left_out.join(records.left_out());
            all.origin = records.origin();
            all.add(records.finish());
        }
        if all.cloud.positions.is_empty() && left_out.not_chosen > 0 {
            return Err(self.none_left(path, &left_out));
        }
        let mut frame = self.frame;
        frame.notes.extend(left_out.notes());
        frame.notes.extend(all.note());
        Ok(super::in_frame(all.cloud, frame))
    }
}

/// The box around boxes.
pub(super) fn joint(boxes: impl Iterator<Item = (DVec3, DVec3)>) -> Option<(DVec3, DVec3)> {
    boxes.reduce(|(low, high), (other_low, other_high)| (low.min(other_low), high.max(other_high)))
}

/// Points of several files so far, each with the attributes that any has.
#[derive(Default)]
struct Gathered {
    cloud: PointCloud,
    /// What positions are relative to, once a point has decided.
    origin: Option<DVec3>,
    uncolored: u64,
}

impl Gathered {
    fn add(&mut self, mut points: PointCloud) {
        let has = either(Attributes::of(&self.cloud), Attributes::of(&points));
        self.uncolored += complete(&mut self.cloud, has) + complete(&mut points, has);
        self.cloud.offset = points.offset;
        self.cloud.positions.append(&mut points.positions);
        self.cloud.colors.append(&mut points.colors);
        self.cloud.intensities.append(&mut points.intensities);
        self.cloud.classes.append(&mut points.classes);
    }

    fn note(&self) -> Option<String> {
        uncolored_note(self.uncolored)
    }
}

/// The attributes that one of both has.
pub(super) fn either(a: Attributes, b: Attributes) -> Attributes {
    Attributes {
        colors: a.colors || b.colors,
        intensities: a.intensities || b.intensities,
        classes: a.classes || b.classes,
    }
}

/// What is said of points without a colour among others.
pub(super) fn uncolored_note(count: u64) -> Option<String> {
    (count > 0).then(|| format!("{count} points of tiles without colours are grey"))
}

/// Gives points the attributes that others have: grey, no intensity and the class 0. The number of points that became grey.
pub(super) fn complete(points: &mut PointCloud, has: Attributes) -> u64 {
    let count = points.positions.len();
    let bare = if has.colors && points.colors.is_empty() { count as u64 } else { 0 };
    points.colors.resize(if has.colors { count } else { 0 }, NO_COLOR);
    points.intensities.resize(if has.intensities { count } else { 0 }, 0);
    points.classes.resize(if has.classes { count } else { 0 }, 0);
    bare
}
