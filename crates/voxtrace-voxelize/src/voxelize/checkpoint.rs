//! The checkpoint file (`OUTPUT.part`): an append-only log of frames, each a batch of finished tiles with a checksum. A killed
//! process leaves it beside the output, and the same command resumes from its intact frames.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::follow_link;
use xxhash_rust::xxh3::Xxh3;

const MAGIC: &[u8; 8] = b"voxpart\0";
const VERSION: u64 = 1;
/// Bytes of the header: magic, version, fingerprint of the work.
const HEADER: u64 = 32;
/// Bytes of a frame's header: step (8), kind (8), bytes of entries (8) and of content (8).
const FRAME: usize = 32;
/// Bytes of the checksum at the end of a frame.
const CHECKSUM: u64 = 8;

/// Progress through the work: a part and a batch in it. Parts and batches depend on the work's fingerprint alone, so steps of an
/// earlier process mean the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Step {
    pub part: u32,
    pub batch: u32,
}

/// What a frame holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FrameKind {
    /// Finished bricks.
    Bricks,
    /// Bricks that other parts of the work reach into: sums of their voxels.
    Sums,
    /// The last frame of a log that is whole.
    End,
}

impl FrameKind {
    const ALL: [Self; 3] = [Self::Bricks, Self::Sums, Self::End];
}

/// A frame of the log: one batch of finished tiles.
pub(super) struct Frame {
    pub step: Step,
    pub kind: FrameKind,
    pub entries: Vec<u8>,
    pub content: Vec<u8>,
    /// Where the content begins in the file.
    pub content_at: u64,
}

/// What stood in the file's place when the work began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Existing {
    /// Nothing.
    Nothing,
    /// The checkpoint file of the same work.
    Own,
    /// A file of other work, or no checkpoint file at all; it has been cleared.
    Other,
}

/// An open checkpoint file, locked against other processes. It is removed when dropped, unless [`Self::keep`] was called.
pub(super) struct CheckpointFile {
    file: Option<File>,
    path: PathBuf,
    end: u64,
    is_kept: bool,
}

impl CheckpointFile {
    /// Opens or creates the checkpoint file beside an output. `key` is the fingerprint of the work.
    pub fn open(output: &Path, key: u128) -> io::Result<(Self, Existing)> {
        let header = header_of(key);
        let output = follow_link(output);
        let mut name = output.file_name().ok_or(io::ErrorKind::InvalidFilename)?.to_owned();
        name.push(".part");
        let path = output.with_file_name(name);
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path)?;
        // File systems without locks are put up with.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(io::Error::new(io::ErrorKind::ResourceBusy, "another process is at work on this file"));
        }
        let length = file.metadata()?.len();
        let mut there = [0; HEADER as usize];
        let is_own = length >= HEADER && file.read_exact(&mut there).is_ok() && there == header;
        let found = match (length, is_own) {
            (0, _) => Existing::Nothing,
            (_, true) => Existing::Own,
            (_, false) => Existing::Other,
        };
        if found != Existing::Own {
            file.set_len(0)?;
            file.seek(SeekFrom::Start(0))?;
            file.write_all(&header)?;
        }
        Ok((Self { file: Some(file), path, end: HEADER, is_kept: false }, found))
    }

    /// Begins a log in an empty file, which somebody else names and removes.
    pub fn begin(mut file: File, key: u128) -> io::Result<Self> {
        file.write_all(&header_of(key))?;
        Ok(Self { file: Some(file), path: PathBuf::new(), end: HEADER, is_kept: true })
    }

    /// Opens a log that is to be read; `None` where it is of other work, or none.
    pub fn open_to_read(path: &Path, key: u128) -> io::Result<Option<Self>> {
        let mut file = File::open(path)?;
        let mut there = [0; HEADER as usize];
        let is_own = match file.read_exact(&mut there) {
            Err(error) if error.kind() != io::ErrorKind::UnexpectedEof => return Err(error),
            read => read.is_ok() && there == header_of(key),
        };
        Ok(is_own.then(|| Self { file: Some(file), path: path.into(), end: HEADER, is_kept: true }))
    }

    /// The next frame of a log that is to be whole; `None` at its end.
    ///
    /// # Errors
    /// Where it begins, if the frame is damaged or not whole.
    pub fn next_whole(&mut self) -> io::Result<Result<Option<Frame>, u64>> {
        let start = self.end;
        let length = self.file()?.metadata()?.len();
        if start == length {
            return Ok(Ok(None));
        }
        let Some(frame) = self.read(start, length)? else { return Ok(Err(start)) };
        self.end = frame.content_at + frame.content.len() as u64 + CHECKSUM;
        Ok(Ok(Some(frame)))
    }

    /// The open file, for whoever knows where its contents lie.
    pub fn into_file(mut self) -> Option<File> {
        self.file.take()
    }

    /// Where the file is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The open file.
    pub fn file(&mut self) -> io::Result<&mut File> {
        self.file.as_mut().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// Keeps the file when it is dropped, if it has any frame.
    pub fn keep(&mut self) {
        self.is_kept = self.end > HEADER;
    }

    /// The next intact frame. `None` at the end of the file, or at a damaged or incomplete frame, where the file is cut off.
    pub fn next(&mut self) -> io::Result<Option<Frame>> {
        let start = self.end;
        let length = self.file()?.metadata()?.len();
        if let Some(frame) = self.read(start, length)? {
            self.end = frame.content_at + frame.content.len() as u64 + CHECKSUM;
            return Ok(Some(frame));
        }
        self.cut()?;
        Ok(None)
    }

    /// Truncates the file behind the last accepted frame.
    pub fn cut(&mut self) -> io::Result<()> {
        let end = self.end;
        self.file()?.set_len(end)?;
        self.file()?.seek(SeekFrom::Start(end))?;
        Ok(())
    }

    /// Steps back before the frame that was read last, whose content is not valid.
    pub fn reject(&mut self, frame: &Frame) {
        self.end = frame.content_at - frame.entries.len() as u64 - FRAME as u64;
    }

    fn read(&mut self, start: u64, length: u64) -> io::Result<Option<Frame>> {
        let file = self.file()?;
        let mut head = [0; FRAME];
        if length < start + FRAME as u64 + CHECKSUM {
            return Ok(None);
        }
        file.seek(SeekFrom::Start(start))?;
        file.read_exact(&mut head)?;
        let word = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
        let size = |at: usize| u64::from(word(at)) | u64::from(word(at + 4)) << 32;
        let step = Step { part: word(0), batch: word(4) };
        let Some(&kind) = FrameKind::ALL.get(word(8) as usize) else { return Ok(None) };
        let (entry_bytes, content_bytes) = (size(16), size(24));
        let needed = entry_bytes.checked_add(content_bytes).and_then(|size| size.checked_add(CHECKSUM));
        if needed.is_none_or(|needed| needed > length - start - FRAME as u64) {
            return Ok(None);
        }
        let (mut entries, mut content) = (vec![0; entry_bytes as usize], vec![0; content_bytes as usize]);
        file.read_exact(&mut entries)?;
        file.read_exact(&mut content)?;
        let mut found = [0; CHECKSUM as usize];
        file.read_exact(&mut found)?;
        let is_whole = checksum(start, &head, &entries, &content) == u64::from_le_bytes(found);
        let content_at = start + FRAME as u64 + entry_bytes;
        Ok(is_whole.then_some(Frame { step, kind, entries, content, content_at }))
    }

    /// Appends a frame and returns where its content begins. All frames must have been read before.
    pub fn append(&mut self, step: Step, kind: FrameKind, entries: &[u8], content: &[u8]) -> io::Result<u64> {
        let start = self.end;
        let mut head = [0; FRAME];
        head[..4].copy_from_slice(&step.part.to_le_bytes());
        head[4..8].copy_from_slice(&step.batch.to_le_bytes());
        head[8] = kind as u8;
        head[16..24].copy_from_slice(&(entries.len() as u64).to_le_bytes());
        head[24..].copy_from_slice(&(content.len() as u64).to_le_bytes());
        let checksum = checksum(start, &head, entries, content).to_le_bytes();
        let file = self.file()?;
        file.write_all(&head)?;
        file.write_all(entries)?;
        file.write_all(content)?;
        file.write_all(&checksum)?;
        let content_at = start + (FRAME + entries.len()) as u64;
        self.end = content_at + content.len() as u64 + CHECKSUM;
        Ok(content_at)
    }
}

impl Drop for CheckpointFile {
    fn drop(&mut self) {
        // Some systems cannot remove an open file.
        self.file = None;
        if !self.is_kept {
            // On an error the file stays; nothing better can be done here.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// The header of the log of work with this fingerprint.
fn header_of(key: u128) -> [u8; HEADER as usize] {
    let mut header = [0; HEADER as usize];
    header[..8].copy_from_slice(MAGIC);
    header[8..16].copy_from_slice(&VERSION.to_le_bytes());
    header[16..].copy_from_slice(&key.to_le_bytes());
    header
}

/// Checksum of a frame, seeded with its offset so that a frame moved elsewhere is invalid.
fn checksum(start: u64, head: &[u8], entries: &[u8], content: &[u8]) -> u64 {
    let mut hash = Xxh3::with_seed(start);
    [head, entries, content].iter().for_each(|bytes| hash.update(bytes));
    hash.digest()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(batch: u32) -> Step {
        Step { part: 3, batch }
    }

    /// A file with three frames, kept.
    fn written(output: &Path) -> PathBuf {
        let (mut part, found) = CheckpointFile::open(output, 7).unwrap();
        assert_eq!((found, part.next().unwrap().is_none()), (Existing::Nothing, true));
        for batch in 0..3 {
            part.append(step(batch), FrameKind::Bricks, &[batch as u8; 5], &vec![batch as u8; 1000]).unwrap();
        }
        part.keep();
        part.path().to_owned()
    }

    fn frames(output: &Path, key: u128) -> (Existing, Vec<u32>) {
        let (mut part, found) = CheckpointFile::open(output, key).unwrap();
        let mut batches = Vec::new();
        while let Some(frame) = part.next().unwrap() {
            let byte = frame.step.batch as u8;
            assert_eq!((frame.entries, frame.content), (vec![byte; 5], vec![byte; 1000]));
            batches.push(frame.step.batch);
        }
        part.keep();
        (found, batches)
    }

    #[test]
    fn frames_come_back_to_the_work_that_made_them() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let path = written(&output);
        assert_eq!(path, folder.path().join("out.vxt.part"));
        assert_eq!(frames(&output, 7), (Existing::Own, vec![0, 1, 2]));
        assert_eq!(frames(&output, 8), (Existing::Other, vec![]));
        assert!(!path.exists(), "a file without a frame is not kept");
    }

    #[test]
    fn whatever_byte_is_damaged_or_missing_no_wrong_frame_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let path = written(&output);
        let whole = fs::read(&path).unwrap();
        let size = (whole.len() - HEADER as usize) / 3;
        for at in (0..whole.len()).step_by(7) {
            let mut bytes = whole.clone();
            bytes[at] ^= 0x10;
            fs::write(&path, bytes).unwrap();
            let intact = at.saturating_sub(HEADER as usize) / size;
            // All of a frame is under the checksum, its kind too.
            assert_eq!(frames(&output, 7).1.len(), if at < HEADER as usize { 0 } else { intact }, "{at}");
            fs::write(&path, &whole[..at]).unwrap();
            assert_eq!(frames(&output, 7).1.len(), intact, "{at}");
        }
    }

    #[test]
    fn two_processes_do_not_work_on_one_file() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let (_part, _) = CheckpointFile::open(&output, 7).unwrap();
        assert_eq!(CheckpointFile::open(&output, 7).err().unwrap().kind(), io::ErrorKind::ResourceBusy);
    }
}
