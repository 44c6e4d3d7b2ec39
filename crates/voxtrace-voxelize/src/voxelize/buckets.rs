//! Records sorted into buckets on the disk: each bucket collects in a small buffer, and full buffers go one behind the other
//! into a file without a name, which is gone when the process is.

use super::{VoxelizeError, VoxelizeProgress};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use voxtrace_core::atomic_file::TemporaryFile;

/// Bytes of a bucket's buffer, at least and at most.
const LEAST: u64 = 1 << 13;
const MOST: u64 = 1 << 20;

/// Buckets of records. A bucket gives its records back in the order in which they came.
pub(super) struct Buckets {
    file: TemporaryFile,
    /// Bytes in the file.
    end: u64,
    buffers: Vec<Vec<u8>>,
    capacity: usize,
    /// Where the pieces of each bucket lie, and how long they are.
    pieces: Vec<Vec<(u64, u32)>>,
}

impl Buckets {
    /// Empty buckets in a file beside the one at `path`, with buffers of about `memory` bytes together.
    pub fn beside(path: &Path, count: usize, memory: u64) -> io::Result<Self> {
        let capacity = (memory / count.max(1) as u64).clamp(LEAST, MOST) as usize;
        let file = TemporaryFile::nameless(path)?;
        Ok(Self { file, end: 0, buffers: vec![Vec::new(); count], capacity, pieces: vec![Vec::new(); count] })
    }

    /// Adds a record, which is shorter than a buffer.
    #[inline]
    pub fn push(&mut self, bucket: u32, record: &[u8]) -> io::Result<()> {
        let buffer = &mut self.buffers[bucket as usize];
        if buffer.len() + record.len() > self.capacity {
            self.flush(bucket as usize)?;
        }
        let buffer = &mut self.buffers[bucket as usize];
        if buffer.capacity() == 0 {
            buffer.reserve_exact(self.capacity);
        }
        buffer.extend_from_slice(record);
        Ok(())
    }

    /// Adds records of `size` bytes each.
    pub fn push_all(&mut self, bucket: u32, mut records: &[u8], size: usize) -> io::Result<()> {
        while !records.is_empty() {
            let room = self.capacity.saturating_sub(self.buffers[bucket as usize].len()) / size;
            let (now, rest) = records.split_at(records.len().min(room.max(1) * size));
            self.push(bucket, now)?;
            records = rest;
        }
        Ok(())
    }

    fn flush(&mut self, bucket: usize) -> io::Result<()> {
        let buffer = &mut self.buffers[bucket];
        if !buffer.is_empty() {
            self.file.file().write_all(buffer)?;
            self.pieces[bucket].push((self.end, buffer.len() as u32));
            self.end += buffer.len() as u64;
            buffer.clear();
        }
        Ok(())
    }

    /// Ends the sorting of records, unless one of them could not be written or nobody waits for them any more.
    pub fn end(&mut self, failure: Option<io::Error>, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        match failure {
            Some(error) => Err(error.into()),
            None if progress.is_cancelled() => Err(VoxelizeError::Cancelled),
            None => Ok(self.seal()?),
        }
    }

    /// Writes all buffers and gives their memory back: no record may come any more.
    fn seal(&mut self) -> io::Result<()> {
        for bucket in 0..self.buffers.len() {
            self.flush(bucket)?;
            self.buffers[bucket] = Vec::new();
        }
        Ok(())
    }

    /// Bytes in a bucket, once it is sealed.
    pub fn size(&self, bucket: usize) -> u64 {
        self.pieces[bucket].iter().map(|piece| u64::from(piece.1)).sum()
    }

    /// Hands out the records of a bucket, many at a time and each whole.
    pub fn read(&mut self, bucket: usize, mut each: impl FnMut(&[u8])) -> io::Result<()> {
        let mut bytes = Vec::new();
        for &(at, size) in &self.pieces[bucket] {
            bytes.resize(size as usize, 0);
            self.file.file().seek(SeekFrom::Start(at))?;
            self.file.file().read_exact(&mut bytes)?;
            each(&bytes);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bucket_gives_back_its_records_in_their_order() {
        let folder = tempfile::tempdir().unwrap();
        let mut buckets = Buckets::beside(&folder.path().join("out"), 5, 0).unwrap();
        #[cfg(unix)]
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        // Many times as much as the buffers hold.
        for number in 0..40_000u32 {
            buckets.push(number % 7 % 4, &number.to_le_bytes()).unwrap();
        }
        // More than a buffer at once.
        let many: Vec<[u8; 4]> = (0..5000).map(u32::to_le_bytes).collect();
        buckets.push_all(4, many.as_flattened(), 4).unwrap();
        buckets.seal().unwrap();
        let mut found = Vec::new();
        buckets.read(4, |bytes| found.extend_from_slice(bytes)).unwrap();
        assert_eq!(found, many.as_flattened());
        for bucket in 0..4u32 {
            let mut found = Vec::new();
            let records = |bytes: &[u8]| found.extend(bytes.as_chunks().0.iter().map(|&n| u32::from_le_bytes(n)));
            buckets.read(bucket as usize, records).unwrap();
            let expected: Vec<u32> = (0..40_000).filter(|number| number % 7 % 4 == bucket).collect();
            assert_eq!(found, expected);
            assert_eq!(buckets.size(bucket as usize), expected.len() as u64 * 4);
        }
    }
}
