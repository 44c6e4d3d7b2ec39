//! Levels of detail: the scene with voxels of twice, four times, eight times … the edge, kept in its native file. `block` says what becomes of eight voxels, `docs/format.md`
//! how levels lie in the file, `docs/decisions/0165-levels-of-detail.md` why it is so.

mod block;
mod materials;
mod progress;
mod stored;
mod window;
mod write;

pub(super) use progress::tell;
pub use progress::{LevelListener, LevelProgress, LevelStep};
pub use stored::{LevelSummary, Levels};
pub(super) use stored::{ranges_of, scene_of};

use super::bytes::Bytes;
use super::{FileError, FileErrorKind, PackedScene, StreamError};
use crate::atomic_file::{TemporaryFile, check_replaceable};
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

/// Most levels of a file.
pub const MAX_LEVELS: u32 = 16;

/// How many levels are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelCount {
    /// So many, at most [`MAX_LEVELS`].
    Some(u32),
    /// Until no grid is larger than one brick, at most [`MAX_LEVELS`].
    All,
}

impl PackedScene {
    /// Saves the scene as [`Self::save`] does, with levels of detail, each made from the one before it brick by brick: a level takes memory for its cells and lights
    /// alone. Until they are in the file, levels lie beside `path` in files without names. `progress` hears how far each is, and stops the rest by `false`.
    ///
    /// # Errors
    /// What the operating system reports; [`std::io::ErrorKind::Interrupted`] where `progress` stops it.
    pub fn save_with_levels(&self, path: &Path, count: LevelCount, progress: LevelListener) -> Result<(), FileError> {
        if self.geometry.is_edited {
            return self.compacted().save_with_levels(path, count, progress);
        }
        let failure = |kind| FileError { path: path.into(), kind };
        check_replaceable(path).map_err(|error| failure(error.into()))?;
        let written = self.with_levels_beside(path, count, progress).map_err(failure)?;
        written.replace(path).map_err(|error| failure(error.into()))
    }

    /// The scene and its levels as one file that may take the place of `path`.
    fn with_levels_beside(
        &self,
        path: &Path,
        count: LevelCount,
        progress: LevelListener,
    ) -> Result<TemporaryFile, FileErrorKind> {
        let levels = self.levels_beside(path, count, progress)?;
        let temporary = TemporaryFile::beside(path)?;
        let mut writer = BufWriter::with_capacity(1 << 20, temporary.try_clone()?);
        self.write_with(&mut writer, &levels)?;
        writer.flush()?;
        Ok(temporary)
    }

    /// The levels as bytes of files without names beside `path`.
    pub(super) fn levels_beside(
        &self,
        path: &Path,
        count: LevelCount,
        progress: LevelListener,
    ) -> Result<Vec<Arc<Bytes>>, FileErrorKind> {
        let most = match count {
            LevelCount::Some(count) => count.min(MAX_LEVELS),
            LevelCount::All => MAX_LEVELS,
        };
        let mut made = Vec::new();
        let mut below: Option<PackedScene> = None;
        while (made.len() as u32) < most {
            let scene = below.as_ref().unwrap_or(self);
            if count == LevelCount::All && scene.is_of_bricks() {
                break;
            }
            let temporary = TemporaryFile::nameless(path)?;
            let file = temporary.try_clone()?;
            let (level, total) =
                (made.len() as u32 + 1, scene.geometry.grids().iter().map(|grid| grid.voxel_count()).sum());
            let mut told = |done: u64| {
                tell(progress, LevelProgress { step: LevelStep::Make, level, done: done.min(total), total })
            };
            write::write_level(scene, &file, path, &mut told).map_err(|error| match error {
                StreamError::Io(error) => FileErrorKind::Io(error),
                StreamError::Pack(error) => FileErrorKind::Invalid(error.to_string().into()),
            })?;
            let bytes = Arc::new(Bytes::map(&file)?);
            below = Some(scene_of(Arc::clone(&bytes), 0..bytes.len(), self)?);
            made.push(bytes);
            told(total)?;
        }
        Ok(made)
    }

    /// Whether no grid is larger than a brick.
    fn is_of_bricks(&self) -> bool {
        self.grids().iter().all(|grid| (grid.max - grid.min).max_element() <= voxtrace_scene::brick::BRICK_SIZE)
    }
}

/// Gives a native file levels of detail, in the place of those that it has. It is replaced whole or not at all.
///
/// # Errors
/// As [`PackedScene::open`] and [`PackedScene::save_with_levels`].
pub fn add_levels(path: &Path, count: LevelCount, progress: LevelListener) -> Result<(), FileError> {
    let failure = |kind| FileError { path: path.into(), kind };
    let scene = PackedScene::open(path)?;
    let written = scene.with_levels_beside(path, count, progress).map_err(failure)?;
    // Windows replaces no file that is mapped.
    drop(scene);
    written.replace(path).map_err(|error| failure(error.into()))
}

/// The tag of a level's section.
pub(super) fn tag_of(level: u32) -> [u8; 4] {
    [b'L', b'V', b'0' + (level / 10) as u8, b'0' + (level % 10) as u8]
}
