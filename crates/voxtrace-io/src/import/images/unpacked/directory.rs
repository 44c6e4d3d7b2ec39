//! The directories of a TIFF (Adobe, "TIFF Revision 6.0") and of a BigTIFF (libtiff, "BigTIFF Design"), entry by entry.

use std::io::{self, Error, ErrorKind, Read, Seek, SeekFrom};

/// Bytes of the header of a BigTIFF.
pub const HEADER: usize = 16;
/// Most entries of a directory: 16 bits number them in a TIFF.
const MOST_ENTRIES: u64 = 1 << 16;
/// Kinds of values: 16, 32 and 64 bits.
pub const SHORT: u16 = 3;
const LONG: u16 = 4;
pub const LONG8: u16 = 16;

/// The order of the bytes of a file's numbers.
#[derive(Clone, Copy)]
pub struct Order {
    pub is_big: bool,
}

impl Order {
    /// The number that up to eight bytes are.
    pub fn number(self, bytes: &[u8]) -> u64 {
        let add = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        if self.is_big { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) }
    }

    /// The lowest bytes of a number.
    pub fn bytes<const N: usize>(self, number: u64) -> [u8; N] {
        std::array::from_fn(|at| (number >> (8 * if self.is_big { N - 1 - at } else { at })) as u8)
    }
}

/// What the header says.
#[derive(Clone, Copy)]
pub struct Header {
    pub order: Order,
    /// Whether offsets have 64 bits.
    pub is_large: bool,
    /// Where the first directory is.
    pub first: u64,
}

impl Header {
    /// Reads the header at the start of a file; `None` where it is none.
    pub fn read(source: &mut (impl Read + Seek)) -> io::Result<Option<Self>> {
        source.seek(SeekFrom::Start(0))?;
        let mut bytes = Vec::new();
        source.take(HEADER as u64).read_to_end(&mut bytes)?;
        let (order, is_large) = match bytes.get(..4) {
            Some(b"II*\0") => (Order { is_big: false }, false),
            Some(b"MM\0*") => (Order { is_big: true }, false),
            Some(b"II+\0") => (Order { is_big: false }, true),
            Some(b"MM\0+") => (Order { is_big: true }, true),
            _ => return Ok(None),
        };
        let first = if is_large { bytes.get(8..16) } else { bytes.get(4..8) };
        Ok(first.map(|first| Self { order, is_large, first: order.number(first) }))
    }
}

/// An entry, as a BigTIFF has it.
#[derive(Clone)]
pub struct Entry {
    pub tag: u16,
    pub kind: u16,
    pub count: u64,
    /// The values where they fit, else their offset.
    pub value: [u8; 8],
}

impl Entry {
    pub fn new(order: Order, tag: u16, kind: u16, count: u64, value: u64) -> Self {
        let value = match kind {
            // Values begin with the first byte, whatever the order.
            SHORT => {
                let [a, b] = order.bytes::<2>(value);
                [a, b, 0, 0, 0, 0, 0, 0]
            }
            _ => order.bytes(value),
        };
        Self { tag, kind, count, value }
    }

    /// Bytes of all values; `None` where their kind is not known.
    pub fn size(&self) -> Option<u64> {
        let size = match self.kind {
            1 | 2 | 6 | 7 => 1,
            SHORT | 8 => 2,
            LONG | 9 | 11 | 13 => 4,
            5 | 10 | 12 | LONG8 | 17 | 18 => 8,
            _ => return None,
        };
        self.count.checked_mul(size)
    }

    /// The values, as whole numbers, of a file of so many bytes.
    pub fn numbers(&self, source: &mut (impl Read + Seek), order: Order, length: u64) -> io::Result<Vec<u64>> {
        let size = self.size().filter(|&size| size <= length && self.count > 0).ok_or_else(cut_off)?;
        let each = match self.kind {
            1 | SHORT | LONG | LONG8 => (size / self.count) as usize,
            _ => return Err(Error::new(ErrorKind::InvalidData, "TIFF: offsets of another kind")),
        };
        let bytes = match size {
            0..=8 => self.value[..size as usize].to_vec(),
            _ => bytes_at(source, order.number(&self.value), size)?,
        };
        Ok(bytes.chunks_exact(each).map(|number| order.number(number)).collect())
    }
}

/// A page's entries, those of kinds that nobody knows left out, and where the next directory is (0: nowhere).
pub struct Directory {
    pub entries: Vec<Entry>,
    pub next: u64,
}

impl Directory {
    /// Reads the directory at an offset.
    pub fn read(source: &mut (impl Read + Seek), header: &Header, at: u64) -> io::Result<Self> {
        let (order, width) = (header.order, if header.is_large { 8 } else { 4 });
        let count_size = if header.is_large { 8 } else { 2 };
        let count = order.number(&bytes_at(source, at, count_size)?);
        if count > MOST_ENTRIES {
            return Err(Error::new(ErrorKind::InvalidData, format!("TIFF: a directory of {count} entries")));
        }
        let entry_size = 4 + 2 * width as u64;
        let start = at.checked_add(count_size).ok_or_else(cut_off)?;
        let bytes = bytes_at(source, start, count * entry_size + width as u64)?;
        let (entries, next) = bytes.split_at((count * entry_size) as usize);
        let mut found = Vec::with_capacity(count as usize);
        for bytes in entries.chunks_exact(entry_size as usize) {
            let (tag, kind) = (order.number(&bytes[..2]) as u16, order.number(&bytes[2..4]) as u16);
            let mut value = [0; 8];
            value[..width].copy_from_slice(&bytes[4 + width..]);
            let mut entry = Entry { tag, kind, count: order.number(&bytes[4..4 + width]), value };
            let Some(size) = entry.size() else { continue };
            if !header.is_large && size > 4 {
                let at = order.number(&value[..4]);
                // What takes eight bytes has an offset in a TIFF and fits into the entry of a BigTIFF.
                entry.value = match size {
                    5..=8 => {
                        let mut short = bytes_at(source, at, size)?;
                        short.resize(8, 0);
                        *short.first_chunk().expect("eight bytes")
                    }
                    _ => order.bytes(at),
                };
            }
            found.push(entry);
        }
        Ok(Self { entries: found, next: order.number(next) })
    }

    pub fn entry(&self, tag: u16) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.tag == tag)
    }

    /// The first value of an entry.
    pub fn number(
        &self,
        source: &mut (impl Read + Seek),
        order: Order,
        length: u64,
        tag: u16,
    ) -> io::Result<Option<u64>> {
        self.entry(tag).map(|entry| Ok(entry.numbers(source, order, length)?[0])).transpose()
    }
}

/// As many bytes as are asked for, no more of which are allocated than there are.
pub fn bytes_at(source: &mut (impl Read + Seek), at: u64, count: u64) -> io::Result<Vec<u8>> {
    source.seek(SeekFrom::Start(at))?;
    let mut bytes = Vec::new();
    source.take(count).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == count { Ok(bytes) } else { Err(cut_off()) }
}

fn cut_off() -> Error {
    Error::new(ErrorKind::UnexpectedEof, "TIFF: the file is cut off")
}
