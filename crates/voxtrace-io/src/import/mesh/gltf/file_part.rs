//! A part of a file whose bytes are read when they are needed, so that a large file does not lie in memory beside the mesh that is made of it.

use super::Fault;
use crate::import::source::input::ReadSeek;
use std::cell::RefCell;
use std::io::{ErrorKind, SeekFrom};
use std::ops::Range;
use std::path::Path;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Bytes that are read at once where elements follow one another: 1 MiB.
const PIECE: usize = 1 << 20;

/// Bytes in a row of a file.
pub(super) struct FilePart {
    file: RefCell<Box<dyn ReadSeek>>,
    /// Where they begin, and how many they are.
    start: u64,
    length: usize,
}

impl FilePart {
    /// Those of a range of a file.
    pub fn new(file: Box<dyn ReadSeek>, range: Range<u64>) -> Self {
        let length = usize::try_from(range.end.saturating_sub(range.start)).unwrap_or(usize::MAX);
        Self { file: RefCell::new(file), start: range.start, length }
    }

    /// How many bytes there are.
    pub fn len(&self) -> usize {
        self.length
    }

    /// Fills `bytes` from a place within the part on.
    pub fn fill(&self, at: usize, bytes: &mut [u8]) -> Result<(), Fault> {
        let mut file = self.file.borrow_mut();
        let read = file.seek(SeekFrom::Start(self.start + at as u64)).and_then(|_| file.read_exact(bytes));
        read.map_err(|error| match error.kind() {
            // It has become shorter meanwhile.
            ErrorKind::UnexpectedEof => Fault { offset: 0, kind: ImportErrorKind::Truncated("a buffer".into()) },
            _ => Fault { offset: 0, kind: ImportError::io(Path::new(""), error).kind },
        })
    }

    /// The bytes of a range within the part.
    pub fn bytes(&self, range: Range<usize>) -> Result<Vec<u8>, Fault> {
        let mut bytes = vec![0; range.len()];
        self.fill(range.start, &mut bytes)?;
        Ok(bytes)
    }
}

/// Elements of one size at equal distances within a part, which are taken in ascending order; some of them are held at a time.
pub(super) struct Window<'a> {
    part: &'a FilePart,
    /// Where the first of all lies, and how many there are.
    start: usize,
    count: usize,
    stride: usize,
    size: usize,
    held: Vec<u8>,
    /// Which ones `held` has.
    items: Range<usize>,
}

impl<'a> Window<'a> {
    /// Elements that all lie within the part.
    pub fn new(part: &'a FilePart, start: usize, [stride, size, count]: [usize; 3]) -> Self {
        Self { part, start, count, stride, size, held: Vec::new(), items: 0..0 }
    }

    /// The bytes of an element that exists.
    #[inline]
    pub fn at(&mut self, item: usize) -> Result<&[u8], Fault> {
        if !self.items.contains(&item) {
            self.load(item)?;
        }
        let start = (item - self.items.start) * self.stride;
        Ok(&self.held[start..start + self.size])
    }

    #[cold]
    fn load(&mut self, first: usize) -> Result<(), Fault> {
        let count = (PIECE / self.stride.max(1)).clamp(1, self.count - first);
        self.items = 0..0;
        self.held.resize(self.stride * (count - 1) + self.size, 0);
        self.part.fill(self.start + self.stride * first, &mut self.held)?;
        self.items = first..first + count;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn elements_are_those_of_the_bytes_whatever_their_size_and_distance() {
        let whole: Vec<u8> = (0..3 * PIECE + 41).map(|at| (at % 251) as u8 ^ (at >> 16) as u8).collect();
        let part = FilePart::new(Box::new(Cursor::new(whole.clone())), 7..whole.len() as u64);
        let own = &whole[7..];
        assert_eq!(part.len(), own.len());
        for (start, stride, size) in [(0, 1, 1), (5, 12, 12), (2, 32, 8), (9, 2 * PIECE, 3)] {
            let count = (own.len() - start - size) / stride + 1;
            let mut window = Window::new(&part, start, [stride, size, count]);
            let same = |item: usize| window.at(item).is_ok_and(|found| found == &own[start + item * stride..][..size]);
            assert!((0..count).all(same), "{stride} {size}");
        }
        let Ok(bytes) = part.bytes(3..20) else { panic!("they are there") };
        assert_eq!(bytes, own[3..20]);
        assert_ne!(bytes, own[4..21], "the comparison sees bytes of another place");
    }

    #[test]
    fn a_file_that_became_shorter_is_told() {
        let part = FilePart::new(Box::new(Cursor::new(vec![0; 8])), 0..64);
        let fault = part.bytes(0..64).err().map(|fault| fault.kind);
        assert!(matches!(fault, Some(ImportErrorKind::Truncated(_))), "{fault:?}");
        let mut window = Window::new(&part, 0, [4, 4, 16]);
        assert!(window.at(0).is_err());
        assert!(part.bytes(0..8).is_ok(), "what is there is read");
    }
}
