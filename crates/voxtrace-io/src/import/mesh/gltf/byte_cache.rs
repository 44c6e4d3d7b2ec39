//! Bytes of a file by their places: blocks of it are read when they are needed and kept as long as there is room.

use std::fs::File;
use std::io::{ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use voxtrace_voxelize::ImportError;

/// Bytes of a block: 2^14.
const BLOCK_BITS: u32 = 14;
const BLOCK: u64 = 1 << BLOCK_BITS;
/// No block.
const NONE: u64 = u64::MAX;

/// A file of which some blocks are held.
pub(super) struct ByteCache {
    path: PathBuf,
    file: File,
    length: u64,
    /// Which block is in which slot; block b can only be in slot b modulo their number.
    held: Vec<u64>,
    slots: Vec<Vec<u8>>,
}

impl ByteCache {
    /// A file, in about `budget` bytes.
    pub fn open(path: &Path, budget: u64) -> Result<Self, ImportError> {
        let io = |error| ImportError::io(path, error);
        crate::import::source::opened::note(path);
        let file = File::open(path).map_err(io)?;
        let length = file.metadata().map_err(io)?.len();
        let blocks = length.div_ceil(BLOCK).max(1);
        let room = (budget / BLOCK).max(4);
        // All of them, or a power of two.
        let slots = if blocks <= room { blocks.next_power_of_two() } else { 1 << room.ilog2() } as usize;
        Ok(Self { path: path.into(), file, length, held: vec![NONE; slots], slots: vec![Vec::new(); slots] })
    }

    /// The name of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the memory back.
    pub fn release(&mut self) {
        self.held.fill(NONE);
        self.slots.iter_mut().for_each(|slot| *slot = Vec::new());
    }

    /// Fills `bytes` from a place of the file on; they may lie across blocks.
    #[inline]
    pub fn read(&mut self, mut at: u64, mut bytes: &mut [u8]) -> Result<(), ImportError> {
        while !bytes.is_empty() {
            let block = at >> BLOCK_BITS;
            let slot = block as usize & (self.slots.len() - 1);
            if self.held[slot] != block {
                self.load(block, slot)?;
            }
            let rest = self.slots[slot].get((at & (BLOCK - 1)) as usize..).filter(|rest| !rest.is_empty());
            let rest = rest.ok_or_else(|| ImportError::truncated(&self.path, self.length, "an array"))?;
            let count = rest.len().min(bytes.len());
            let (now, later) = bytes.split_at_mut(count);
            now.copy_from_slice(&rest[..count]);
            (bytes, at) = (later, at + count as u64);
        }
        Ok(())
    }

    #[cold]
    fn load(&mut self, block: u64, slot: usize) -> Result<(), ImportError> {
        let start = block << BLOCK_BITS;
        let bytes = &mut self.slots[slot];
        bytes.resize(BLOCK.min(self.length.saturating_sub(start)) as usize, 0);
        self.held[slot] = NONE;
        let read = self.file.seek(SeekFrom::Start(start)).and_then(|_| self.file.read_exact(bytes));
        read.map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => ImportError::truncated(&self.path, start, "an array"),
            _ => ImportError::io(&self.path, error),
        })?;
        self.held[slot] = block;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_those_of_the_file_in_any_order_and_across_blocks() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bytes");
        let whole: Vec<u8> = (0..10 * BLOCK + 77).map(|at| (at % 251) as u8 ^ (at >> 14) as u8).collect();
        std::fs::write(&path, &whole).unwrap();
        for budget in [0, 1 << 30] {
            let mut cache = ByteCache::open(&path, budget).unwrap();
            let mut bytes = [0; 12];
            for at in (0..whole.len() - 12).step_by(1021).chain([BLOCK as usize - 5, 4 * BLOCK as usize - 1]).rev() {
                cache.read(at as u64, &mut bytes).unwrap();
                assert_eq!(bytes, whole[at..at + 12], "{at}");
            }
            cache.release();
            cache.read(3, &mut bytes).unwrap();
            assert_eq!(bytes, whole[3..15]);
            let error = cache.read(whole.len() as u64 - 11, &mut bytes).unwrap_err();
            assert_eq!(error.offset, Some(whole.len() as u64));
        }
    }
}
