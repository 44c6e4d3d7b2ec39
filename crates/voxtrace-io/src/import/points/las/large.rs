//! LAS and LAZ files larger than memory: points are read, or decompressed, some at a time.

use super::compressed::Decompressor;
use super::header::Header;
use super::records::{Records, Seen};
use super::{BATCH, check_length, frame, reference};
use crate::import::reader::ImportOptions;
use crate::import::source::input::Input;
use glam::DVec3;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::points::source::PointSource;
use voxtrace_voxelize::points::{Attributes, PointCloud};
use voxtrace_voxelize::{ImportError, Limits};

/// Bytes of points decompressed at once, about.
const DECOMPRESSED: usize = 32 << 20;

/// The points of a LAS or LAZ file.
pub(crate) struct LasPoints {
    path: PathBuf,
    length: u64,
    header: Header,
    limits: Limits,
    frame: PointCloud,
    /// What points have that says something, once they were read.
    seen: Option<Seen>,
}

impl LasPoints {
    /// Opens a file. How much may come out of it where it is compressed, its own length says.
    pub fn open(path: &Path, options: &ImportOptions) -> Result<Self, ImportError> {
        let limits = Limits { bytes: u64::MAX, points: u64::MAX, ..options.limits };
        let mut input = Input::open(path, &limits)?;
        let mut header = Header::read(&mut input)?;
        let (crs, units) = reference::read(&mut input, &header)?;
        let frame = frame::settle(&mut header, crs, units, options.unit);
        let length = input.remaining().unwrap_or(0);
        let own = Self { path: path.into(), length, header, limits, frame, seen: None };
        if own.header.is_compressed {
            own.decompressor().map(drop)?
        } else {
            check_length(&input, &own.header)?
        }
        Ok(own)
    }

    /// Bytes that the cloud would take in memory, while it is read.
    pub fn size_bytes(&self) -> u64 {
        self.header.points.saturating_mul(24)
    }

    fn decompressor(&self) -> Result<Decompressor, ImportError> {
        crate::import::source::opened::note(&self.path);
        let file = File::open(&self.path).map_err(|error| ImportError::io(&self.path, error))?;
        Decompressor::open(&self.path, Box::new(BufReader::new(file)), self.length, &self.header, &self.limits)
    }
}

impl PointSource for LasPoints {
    fn frame(&mut self) -> &mut PointCloud {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.header.points
    }

    fn attributes(&self) -> Attributes {
        self.seen.unwrap_or_default().attributes()
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        let (low, high) = self.header.bounds;
        (low.is_finite() && high.is_finite() && low.cmple(high).all()).then_some((low, high))
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        let mut records = Records::new(&self.header, self.seen);
        if self.header.is_compressed {
            let mut points = self.decompressor()?;
            while points.next(&mut records, DECOMPRESSED)? {
                if !each(records.piece()) {
                    return Ok(());
                }
                records.clear();
            }
        } else {
            let size = u64::from(self.header.record_size);
            let mut input = Input::open_at(&self.path, self.header.data, &self.limits)?;
            let mut left = self.header.points;
            while left > 0 {
                let now = left.min(BATCH);
                records.add(input.take((now * size) as usize, "the points")?);
                if !each(records.piece()) {
                    return Ok(());
                }
                records.clear();
                left -= now;
            }
        }
        if self.seen.is_none() {
            self.frame.offset = records.offset();
            self.frame.notes.extend(records.notes());
            self.seen = Some(records.seen());
        }
        Ok(())
    }
}
