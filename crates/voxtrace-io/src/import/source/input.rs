//! Reading a file piece by piece through a small window: files need not fit into memory, and every fault knows its byte.

use super::opened;
use super::watch::{Watch, Watched};
use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::Path;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits, Stopped};

/// Bytes read at once.
const WINDOW: usize = 1 << 18;
/// Bytes of a whole file that are read between two looks at whether it is still wanted.
const PIECE: u64 = 1 << 24;
/// Longest line of a text file, and longest single piece.
const LONGEST: usize = 1 << 26;

/// A text without the mark by which programs of Windows tell UTF-8.
pub(crate) fn without_mark(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)
}

/// The error of what is larger than a bound that is none of [`Limits`], so that nobody is told to lift it.
pub(crate) fn beyond(path: &Path, offset: Option<u64>, what: &str, value: u64, most: u64) -> ImportError {
    let kind = ImportErrorKind::Unsupported(format!("{what}: {value} is more than the fixed limit of {most}"));
    ImportError::of_file(path, kind).with_offset(offset)
}

/// A file or bytes, to be read in any order.
pub(crate) trait ReadSeek: Read + Seek + Send {}
impl<R: Read + Seek + Send> ReadSeek for R {}

/// Where bytes come from.
enum Stream<'a> {
    File(File),
    Other(Box<dyn Read + 'a>),
}

impl Read for Stream<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        match self {
            Self::File(file) => file.read(buffer),
            Self::Other(other) => other.read(buffer),
        }
    }

    fn read_to_end(&mut self, bytes: &mut Vec<u8>) -> std::io::Result<usize> {
        match self {
            Self::File(file) => file.read_to_end(bytes),
            Self::Other(other) => other.read_to_end(bytes),
        }
    }
}

/// Bytes to read from the front, from a file or from memory.
pub(crate) struct Input<'a> {
    path: &'a Path,
    source: Stream<'a>,
    window: Vec<u8>,
    start: usize,
    /// Position in the file of `window[start]`.
    offset: u64,
    /// Bytes of the whole, where they are known.
    length: Option<u64>,
    limit: u64,
    has_ended: bool,
    /// Whether the bytes come out of a decoder, whose errors are the file's.
    is_decoded: bool,
    watch: Watch,
}

impl<'a> Input<'a> {
    /// A file within the limit on bytes.
    pub fn open(path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        opened::note(path);
        Self::of_file(File::open(path).map_err(|error| ImportError::io(path, error))?, path, limits)
    }

    /// An open file of which `head` was read already, all from its start on; `path` is its name.
    pub fn of_begun(head: Vec<u8>, file: File, path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        opened::note(path);
        Ok(Self { window: head, ..Self::of_file(file, path, limits)? })
    }

    /// An open file within the limit on bytes, from its current place on; `path` is its name.
    pub fn of_file(file: File, path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        let io = |error| ImportError::io(path, error);
        let metadata = file.metadata().map_err(io)?;
        if metadata.is_dir() {
            return Err(io(std::io::ErrorKind::IsADirectory.into()));
        }
        // A pipe has no length.
        let length = metadata.is_file().then_some(metadata.len());
        let mut input = Self::new(path, Stream::File(file), length, limits);
        input.set_limit(limits)?;
        Ok(input)
    }

    /// Sets the limit on bytes.
    pub fn set_limit(&mut self, limits: &Limits) -> Result<(), ImportError> {
        self.limit = limits.bytes;
        match self.length.filter(|&length| length > limits.bytes) {
            Some(length) => Err(ImportError::limit(self.path, None, "bytes of input", length, limits.bytes)),
            None => Ok(()),
        }
    }

    /// Another handle of a file that lies on the disk, and not of a pipe or of memory. Both have one place, from which they go on.
    pub fn file(&self) -> Result<Option<File>, ImportError> {
        match &self.source {
            Stream::File(file) if self.length.is_some() => {
                file.try_clone().map(Some).map_err(|error| ImportError::io(self.path, error))
            }
            _ => Ok(None),
        }
    }

    /// A file from a byte on.
    pub fn open_at(path: &'a Path, offset: u64, limits: &Limits) -> Result<Self, ImportError> {
        let io = |error| ImportError::io(path, error);
        opened::note(path);
        let mut file = File::open(path).map_err(io)?;
        let length = file.metadata().map_err(io)?.len();
        file.seek(SeekFrom::Start(offset)).map_err(io)?;
        Ok(Self { offset, ..Self::new(path, Stream::File(file), Some(length), limits) })
    }

    /// Bytes in memory; `path` names them in errors.
    pub fn of_bytes(bytes: &'a [u8], path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        let length = bytes.len() as u64;
        if length > limits.bytes {
            return Err(ImportError::limit(path, None, "bytes of input", length, limits.bytes));
        }
        Ok(Self::new(path, Stream::Other(Box::new(bytes)), Some(length), limits))
    }

    /// Bytes in memory that nobody else needs.
    pub fn of_owned(bytes: Vec<u8>, path: &'a Path, limits: &Limits) -> Self {
        let length = Some(bytes.len() as u64);
        Self::new(path, Stream::Other(Box::new(Cursor::new(bytes))), length, limits)
    }

    /// Bytes that come out of a decoder: faults are told with the byte of what comes out.
    pub fn of_decoder(decoder: Box<dyn Read + 'a>, path: &'a Path, limits: &Limits) -> Self {
        Self { is_decoded: true, ..Self::new(path, Stream::Other(decoder), None, limits) }
    }

    fn new(path: &'a Path, source: Stream<'a>, length: Option<u64>, limits: &Limits) -> Self {
        let (window, limit) = (Vec::new(), limits.bytes);
        let watch = Watch::of_thread();
        Self { path, source, window, start: 0, offset: 0, length, limit, has_ended: false, is_decoded: false, watch }
    }

    /// The name of what is read.
    pub fn path(&self) -> &'a Path {
        self.path
    }

    /// Position in the file of what comes next.
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// Bytes left, where the length is known.
    pub fn remaining(&self) -> Option<u64> {
        self.length.map(|length| length.saturating_sub(self.offset))
    }

    /// Fills the window up to at least `count` bytes, or to the end.
    fn fill(&mut self, count: usize) -> Result<(), ImportError> {
        if self.window.len() - self.start >= count || self.has_ended {
            return Ok(());
        }
        self.watch.check().map_err(|error| ImportError::io(self.path, error))?;
        self.window.drain(..self.start);
        self.start = 0;
        let wanted = count.max(WINDOW) - self.window.len();
        let got = (&mut self.source).take(wanted as u64).read_to_end(&mut self.window);
        let got = got.map_err(|error| self.failure(error))?;
        self.has_ended = got < wanted;
        let read = self.offset + self.window.len() as u64;
        if read > self.limit {
            return Err(ImportError::limit(self.path, Some(self.limit), "bytes of input", read, self.limit));
        }
        Ok(())
    }

    /// The error of reading on.
    fn failure(&self, error: std::io::Error) -> ImportError {
        let is_stopped = error.get_ref().is_some_and(|error| error.is::<Stopped>());
        if !self.is_decoded || is_stopped {
            return ImportError::io(self.path, error);
        }
        let read = self.offset + (self.window.len() - self.start) as u64;
        ImportError::malformed(self.path, read, format!("compressed data: {error}"))
    }

    /// What comes next, at most `count` bytes and less only at the end, without taking it.
    pub fn peek(&mut self, count: usize) -> Result<&[u8], ImportError> {
        self.fill(count)?;
        let rest = &self.window[self.start..];
        Ok(&rest[..rest.len().min(count)])
    }

    /// Takes `count` bytes, which are part of `what`.
    pub fn take(&mut self, count: usize, what: &str) -> Result<&[u8], ImportError> {
        if count > LONGEST {
            return Err(beyond(self.path, Some(self.offset), what, count as u64, LONGEST as u64));
        }
        self.fill(count)?;
        let start = self.start;
        if self.window.len() - start < count {
            let end = self.offset + (self.window.len() - start) as u64;
            return Err(ImportError::truncated(self.path, end, what));
        }
        self.start += count;
        self.offset += count as u64;
        Ok(&self.window[start..start + count])
    }

    /// Takes as many bytes as the buffer holds, which are part of `what`; those that are not in the window come straight from
    /// the source.
    pub fn take_into(&mut self, buffer: &mut [u8], what: &str) -> Result<(), ImportError> {
        let ready = buffer.len().min(self.window.len() - self.start);
        let (first, mut rest) = buffer.split_at_mut(ready);
        first.copy_from_slice(&self.window[self.start..self.start + ready]);
        self.start += ready;
        self.offset += ready as u64;
        while !rest.is_empty() {
            if self.has_ended {
                return Err(ImportError::truncated(self.path, self.offset, what));
            }
            self.watch.check().map_err(|error| ImportError::io(self.path, error))?;
            let piece = rest.len().min(PIECE as usize);
            match self.source.read(&mut rest[..piece]) {
                Ok(0) => self.has_ended = true,
                Ok(count) => {
                    self.offset += count as u64;
                    rest = &mut rest[count..];
                }
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                Err(error) => return Err(self.failure(error)),
            }
            if self.offset > self.limit {
                return Err(ImportError::limit(self.path, Some(self.limit), "bytes of input", self.offset, self.limit));
            }
        }
        Ok(())
    }

    /// Takes a line, without its end (LF or CR LF) and what marks the text as UTF-8; `None` at the end of the file.
    pub fn line(&mut self) -> Result<Option<&[u8]>, ImportError> {
        let mut searched = 0;
        let length = loop {
            let rest = &self.window[self.start..];
            if let Some(at) = rest[searched..].iter().position(|&byte| byte == b'\n') {
                break searched + at + 1;
            }
            searched = rest.len();
            if self.has_ended {
                break searched;
            }
            if searched > LONGEST {
                let at = Some(self.offset);
                return Err(beyond(self.path, at, "bytes in a line", searched as u64, LONGEST as u64));
            }
            self.fill(searched.max(WINDOW / 2) * 2)?;
        };
        if length == 0 {
            return Ok(None);
        }
        let start = self.start;
        self.start += length;
        self.offset += length as u64;
        let line = &self.window[start..start + length];
        let line = if self.offset == length as u64 { without_mark(line) } else { line };
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        Ok(Some(line.strip_suffix(b"\r").unwrap_or(line)))
    }

    /// Goes over `count` bytes, which are part of `what`; of a file without reading them.
    pub fn skip(&mut self, count: u64, what: &str) -> Result<(), ImportError> {
        let ready = (self.window.len() - self.start) as u64;
        if let (Stream::File(file), Some(length)) = (&mut self.source, self.length)
            && count > ready
        {
            let to = self.offset.saturating_add(count);
            if to > length {
                return Err(ImportError::truncated(self.path, length.max(self.offset), what));
            }
            // The file is at the end of the window.
            file.seek_relative((count - ready) as i64).map_err(|error| ImportError::io(self.path, error))?;
            self.window.clear();
            (self.start, self.offset, self.has_ended) = (0, to, false);
            return Ok(());
        }
        let mut left = count;
        while left > 0 {
            let now = left.min(WINDOW as u64);
            self.take(now as usize, what)?;
            left -= now;
        }
        Ok(())
    }

    /// Takes as many bytes as there are, at most as many as the buffer holds; none only at the end.
    pub fn copy_into(&mut self, buffer: &mut [u8]) -> Result<usize, ImportError> {
        let rest = self.peek(buffer.len().min(WINDOW))?;
        let count = rest.len();
        buffer[..count].copy_from_slice(rest);
        self.start += count;
        self.offset += count as u64;
        Ok(count)
    }

    /// All bytes, also those that were taken, to be read in any order, and how many: the file from its start where there is one,
    /// and otherwise what comes, of which nothing may have been taken.
    pub fn seekable(self) -> Result<(Box<dyn ReadSeek>, u64), ImportError> {
        let path = self.path;
        match (self.source, self.length) {
            (Stream::File(mut file), Some(length)) => {
                file.rewind().map_err(|error| ImportError::io(path, error))?;
                Ok((Box::new(BufReader::new(Watched { inner: file, watch: self.watch })), length))
            }
            (source, length) => {
                let bytes = Self { source, length, ..self }.rest()?;
                let length = bytes.len() as u64;
                Ok((Box::new(Cursor::new(bytes)), length))
            }
        }
    }

    /// Everything that is left.
    pub fn rest(mut self) -> Result<Vec<u8>, ImportError> {
        let mut bytes = self.window.split_off(self.start);
        if !self.has_ended {
            let more = self.remaining().unwrap_or(0).saturating_sub(bytes.len() as u64).min(self.limit);
            let more = usize::try_from(more).unwrap_or(0);
            let refused = |_| ImportError::io(self.path, std::io::ErrorKind::OutOfMemory.into());
            bytes.try_reserve_exact(more).map_err(refused)?;
            // One byte more than allowed shows what is too long.
            let mut allowed = self.limit.saturating_sub(self.offset).saturating_add(1);
            while allowed > 0 {
                self.watch.check().map_err(|error| ImportError::io(self.path, error))?;
                let piece = allowed.min(PIECE);
                let got = (&mut self.source).take(piece).read_to_end(&mut bytes);
                let got = got.map_err(|error| self.failure(error))? as u64;
                allowed -= got;
                if got < piece {
                    break;
                }
            }
        }
        let read = self.offset + bytes.len() as u64;
        if read > self.limit {
            return Err(ImportError::limit(self.path, Some(self.limit), "bytes of input", read, self.limit));
        }
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests;
