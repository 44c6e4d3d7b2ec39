//! The levels of detail of a native file: found, and opened one by one.

use super::{MAX_LEVELS, tag_of};
use crate::packed::bytes::{Access, Bytes};
use crate::packed::file_error::damaged;
use crate::packed::section_reader::{Reader, geometry_and_placement};
use crate::packed::streamed;
use crate::packed::{FileError, FileErrorKind, Outline, PackedGrid, PackedScene};
use std::fs::File;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use xxhash_rust::xxh3::xxh3_64;

/// The levels of detail of a file, and the scene itself, level 0. Nobody may write into the file meanwhile, as for [`PackedScene::open`].
pub struct Levels {
    bytes: Arc<Bytes>,
    ranges: Vec<(Range<usize>, u64)>,
}

/// What a level holds, without opening it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelSummary {
    /// Voxels stored.
    pub voxels: u64,
    /// Bytes in the file.
    pub bytes: u64,
}

impl Levels {
    /// Those of a file, which is mapped.
    ///
    /// # Errors
    /// As [`PackedScene::open`], but that what is in the levels is not looked at yet.
    pub fn open(path: &Path) -> Result<Self, FileError> {
        let opened = File::open(path).and_then(|file| Bytes::map(&file)).map_err(FileErrorKind::from);
        opened.and_then(Self::of).map_err(|kind| FileError { path: path.into(), kind })
    }

    /// Those of a file, which is read into memory, so that others may change it.
    ///
    /// # Errors
    /// As [`Self::open`], also where memory does not suffice.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        let read = |mut file: File| {
            let length = file.metadata()?.len();
            Bytes::read(&mut file, length)
        };
        let opened = File::open(path).and_then(read).map_err(FileErrorKind::from);
        opened.and_then(Self::of).map_err(|kind| FileError { path: path.into(), kind })
    }

    /// Those of the bytes of a file, which are copied.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FileErrorKind> {
        Self::of(Bytes::copy_of(bytes)?)
    }

    fn of(bytes: Bytes) -> Result<Self, FileErrorKind> {
        let bytes = Arc::new(bytes);
        let reader = Reader::new(Arc::clone(&bytes), 0..bytes.len())?;
        let ranges = if reader.is_streamed() { streamed::ranges_of(&reader) } else { ranges_of(&reader) }?;
        Ok(Self { ranges, bytes })
    }

    /// The sections of the file, where it is one for streaming.
    fn streamed(&self) -> Result<Option<Reader>, FileErrorKind> {
        let reader = Reader::new(Arc::clone(&self.bytes), 0..self.bytes.len())?;
        Ok(reader.is_streamed().then_some(reader))
    }

    /// How many there are beside the scene itself.
    pub fn count(&self) -> u32 {
        self.ranges.len() as u32
    }

    /// What a level from 1 on holds.
    ///
    /// # Errors
    /// [`FileErrorKind`] where it is damaged, or where there is none.
    pub fn summary(&self, level: u32) -> Result<LevelSummary, FileErrorKind> {
        let (range, _) = self.range(level)?;
        if let Some(streamed) = self.streamed()? {
            return Ok(LevelSummary { voxels: streamed::summary_of(&streamed, level)?, bytes: range.len() as u64 });
        }
        let grids = Reader::new(Arc::clone(&self.bytes), range.clone())?.section::<PackedGrid>(b"GRID")?;
        Ok(LevelSummary { voxels: grids.iter().map(PackedGrid::voxel_count).sum(), bytes: range.len() as u64 })
    }

    /// Opens a level: 0 is the scene, each further one has voxels of twice the edge. All have the same world, light and cameras.
    ///
    /// # Errors
    /// As [`PackedScene::open`]; [`FileErrorKind::Invalid`] where there is no such level.
    pub fn scene(&self, level: u32) -> Result<PackedScene, FileErrorKind> {
        if level == 0 {
            return PackedScene::of_shared(Arc::clone(&self.bytes));
        }
        let (range, checksum) = self.range(level)?;
        if let Some(streamed) = self.streamed()? {
            return streamed::scene_of(&streamed, level);
        }
        self.bytes.expect(Access::FromStartToEnd);
        if xxh3_64(&self.bytes[range.clone()]) != *checksum {
            return Err(damaged(format!("level {level} has a wrong checksum"), range.start as u64));
        }
        let settings = PackedScene::settings_of(&Reader::new(Arc::clone(&self.bytes), 0..self.bytes.len())?)?;
        scene_of(Arc::clone(&self.bytes), range.clone(), &settings)
    }

    fn range(&self, level: u32) -> Result<&(Range<usize>, u64), FileErrorKind> {
        let found = (level as usize).checked_sub(1).and_then(|index| self.ranges.get(index));
        found.ok_or_else(|| FileErrorKind::Invalid(format!("there is no level {level}").into()))
    }
}

/// Where the levels of a file lie, and their checksums, which are not looked at.
pub(in crate::packed) fn ranges_of(reader: &Reader) -> Result<Vec<(Range<usize>, u64)>, FileErrorKind> {
    let ranges = (1..=MAX_LEVELS).map(|level| reader.unchecked_range(&tag_of(level)));
    ranges.map_while(Result::transpose).collect()
}

/// The scene of a level, with all that is no voxel from `settings`.
pub(in crate::packed) fn scene_of(
    bytes: Arc<Bytes>,
    range: Range<usize>,
    settings: &PackedScene,
) -> Result<PackedScene, FileErrorKind> {
    let (geometry, placement) = geometry_and_placement(&Reader::new(bytes, range)?)?;
    let outline = Arc::new(Outline::of_instances(placement.instances()));
    Ok(PackedScene { geometry: Arc::new(geometry), placement, outline, ..settings.clone() })
}
