//! External bucket sort: each bucket collects its records in a small buffer, and full buffers are appended to one unnamed
//! temporary file, which the system removes when the process ends.

use super::{VoxelizeError, VoxelizeProgress};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use voxtrace_core::atomic_file::TemporaryFile;

/// Least bytes of a bucket's buffer.
const MIN_BUFFER: u64 = 1 << 13;
/// Most bytes of a bucket's buffer.
const MAX_BUFFER: u64 = 1 << 20;

/// Buckets of records on the disk. Each bucket keeps its records in the order in which they came.
pub(super) struct DiskBuckets {
    file: TemporaryFile,
    /// Bytes in the file.
    end: u64,
    buffers: Vec<Vec<u8>>,
    capacity: usize,
    /// Offset and length in the file of each bucket's pieces.
    pieces: Vec<Vec<(u64, u32)>>,
}

impl DiskBuckets {
    /// Empty buckets in a temporary file in the folder of `path`, with buffers of about `memory` bytes together.
    pub fn beside(path: &Path, count: usize, memory: u64) -> io::Result<Self> {
        let capacity = (memory / count.max(1) as u64).clamp(MIN_BUFFER, MAX_BUFFER) as usize;
        let file = TemporaryFile::nameless(path)?;
        Ok(Self { file, end: 0, buffers: vec![Vec::new(); count], capacity, pieces: vec![Vec::new(); count] })
    }

    /// Appends a record, which is shorter than a buffer.
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

    /// Appends records of `size` bytes each.
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

    /// Ends the sorting. Fails with `failure` if a record could not be written, or if the work was cancelled.
    pub fn end(&mut self, failure: Option<io::Error>, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        match failure {
            Some(error) => Err(error.into()),
            None if progress.is_cancelled() => Err(VoxelizeError::Cancelled),
            None => Ok(self.seal()?),
        }
    }

    /// Writes all buffers and frees them; no record may follow.
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

    /// Calls `each` with the records of a bucket, in order, several whole ones at a time.
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
        let mut buckets = DiskBuckets::beside(&folder.path().join("out"), 5, 0).unwrap();
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
