//! TIFF in compressions that the crate `tiff` does not read, as a BigTIFF without any: a file that exists nowhere as a whole. Its header and
//! directories are written anew, everything else of the file stays where it is, and strips and tiles, which have places far beyond the end of
//! the file, are unpacked when they are read, one at a time.

mod directory;
mod segment;

use crate::import::images::allowance;
use directory::{Directory, Entry, HEADER, Header, LONG8, Order, SHORT, bytes_at};
use segment::{Packing, Shape, unpack};
use std::collections::HashSet;
use std::io::{self, Error, ErrorKind, Read, Seek, SeekFrom};
use voxtrace_voxelize::Limits;

/// Where strips and tiles begin: beyond the end of all files.
const SEGMENTS: u64 = 1 << 60;
/// Bytes of directories that any file may have, and for each byte of the file.
const FREE: u64 = 64 << 20;
const RATIO: u64 = 16;
/// Values of `Compression` and `PhotometricInterpretation`.
const PLAIN: u64 = 1;
const RED_GREEN_BLUE: u64 = 2;

/// Tags (TIFF 6.0).
mod tag {
    pub const WIDTH: u16 = 256;
    pub const HEIGHT: u16 = 257;
    pub const BITS: u16 = 258;
    pub const COMPRESSION: u16 = 259;
    pub const PHOTOMETRIC: u16 = 262;
    pub const STRIPS: u16 = 273;
    pub const CHANNELS: u16 = 277;
    pub const ROWS: u16 = 278;
    pub const STRIP_SIZES: u16 = 279;
    pub const PLANES: u16 = 284;
    pub const PREDICTOR: u16 = 317;
    pub const TILE_WIDTH: u16 = 322;
    pub const TILE_HEIGHT: u16 = 323;
    pub const TILES: u16 = 324;
    pub const TILE_SIZES: u16 = 325;
    pub const SUBSAMPLING: u16 = 530;
}

/// A TIFF, without compressions that the crate `tiff` does not read.
pub(crate) struct Unpacked<R> {
    source: R,
    /// Where the source is, to ask for another place only where that is needed.
    source_at: Option<u64>,
    at: u64,
    /// What is written anew, `None` where the file is read as it is.
    anew: Option<Anew>,
    /// The last segment that was unpacked.
    ready: Option<(usize, Vec<u8>)>,
}

/// What is written anew of a file.
struct Anew {
    order: Order,
    header: Vec<u8>,
    /// Where the directories begin: at the end of the file.
    start: u64,
    directories: Vec<u8>,
    /// In the order of their places.
    segments: Vec<Segment>,
}

/// A strip or a tile.
struct Segment {
    /// Its place among all, from [`SEGMENTS`] on, and its size there.
    start: u64,
    size: u64,
    /// The same in the file.
    source: u64,
    packed: u64,
    packing: Packing,
    shape: Shape,
    /// Its number in its page, from 0 on.
    number: u32,
}

impl<R: Read + Seek> Unpacked<R> {
    /// Looks at the first page: where the crate `tiff` reads it, the file stays as it is.
    ///
    /// # Errors
    /// What the source reports, or that directories are damaged.
    pub fn of(mut source: R, limits: &Limits) -> io::Result<Self> {
        let anew = match Header::read(&mut source)? {
            Some(header) => Anew::of(&mut source, &header, limits)?,
            None => None,
        };
        let mut unpacked = Self { source, source_at: None, at: 0, anew, ready: None };
        unpacked.seek(SeekFrom::Start(0))?;
        Ok(unpacked)
    }

    /// What may become of so many bytes.
    pub fn allowance(&self) -> allowance::Packing {
        if self.anew.is_some() { allowance::Packing::TiffAnew } else { allowance::Packing::Tiff }
    }

    /// Bytes of the source from a place on.
    fn read_source(&mut self, at: u64, buffer: &mut [u8]) -> io::Result<usize> {
        if self.source_at != Some(at) {
            self.source.seek(SeekFrom::Start(at))?;
        }
        self.source_at = None;
        let count = self.source.read(buffer)?;
        self.source_at = Some(at + count as u64);
        Ok(count)
    }

    /// Bytes of the segments.
    fn read_segment(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let Some(anew) = &self.anew else { return Ok(0) };
        let index = anew.segments.partition_point(|segment| segment.start <= self.at);
        let Some(index) = index.checked_sub(1) else { return Ok(0) };
        let segment = &anew.segments[index];
        let (from, left) = (self.at - segment.start, (segment.start + segment.size).saturating_sub(self.at));
        let count = buffer.len().min(usize::try_from(left).unwrap_or(usize::MAX));
        if segment.packing == Packing::Copied {
            let source = segment.source.saturating_add(from);
            return self.read_source(source, &mut buffer[..count]);
        }
        if self.ready.as_ref().is_none_or(|(ready, _)| *ready != index) {
            self.source_at = None;
            let packed = bytes_at(&mut self.source, segment.source, segment.packed);
            let unpacked = packed.and_then(|packed| {
                unpack(segment.packing, &segment.shape, &packed, anew.order)
                    .map_err(|fault| Error::new(ErrorKind::InvalidData, format!("segment {}: {fault}", segment.number)))
            });
            self.ready = Some((index, unpacked?));
        }
        let (_, samples) = self.ready.as_ref().expect("a segment that was unpacked");
        let from = usize::try_from(from).unwrap_or(usize::MAX).min(samples.len());
        let count = count.min(samples.len() - from);
        buffer[..count].copy_from_slice(&samples[from..from + count]);
        Ok(count)
    }
}

impl<R: Read + Seek> Read for Unpacked<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let Some(anew) = &self.anew else { return self.source.read(buffer) };
        let of_memory = |bytes: &[u8], from: u64, buffer: &mut [u8]| {
            let from = usize::try_from(from).unwrap_or(usize::MAX).min(bytes.len());
            let count = buffer.len().min(bytes.len() - from);
            buffer[..count].copy_from_slice(&bytes[from..from + count]);
            count
        };
        let count = if self.at < HEADER as u64 {
            of_memory(&anew.header, self.at, buffer)
        } else if self.at < anew.start {
            let count = buffer.len().min(usize::try_from(anew.start - self.at).unwrap_or(usize::MAX));
            self.read_source(self.at, &mut buffer[..count])?
        } else if self.at < SEGMENTS {
            of_memory(&anew.directories, self.at - anew.start, buffer)
        } else {
            self.read_segment(buffer)?
        };
        self.at += count as u64;
        Ok(count)
    }
}

impl<R: Read + Seek> Seek for Unpacked<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let Some(anew) = &self.anew else { return self.source.seek(to) };
        let end = anew.segments.last().map_or(SEGMENTS, |last| last.start + last.size);
        let to = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::Current(step) => self.at.checked_add_signed(step),
            SeekFrom::End(step) => end.checked_add_signed(step),
        };
        self.at = to.ok_or_else(|| Error::from(ErrorKind::InvalidInput))?;
        Ok(self.at)
    }
}

impl Anew {
    /// Writes header and directories anew; `None` where the first page needs none of it.
    fn of(source: &mut (impl Read + Seek), header: &Header, limits: &Limits) -> io::Result<Option<Self>> {
        let order = header.order;
        let length = source.seek(SeekFrom::End(0))?;
        let start = length.max(HEADER as u64).next_multiple_of(16);
        let mut anew = Self { order, header: Vec::new(), start, directories: Vec::new(), segments: Vec::new() };
        let (mut at, mut page, mut seen) = (header.first, 0u64, HashSet::new());
        let mut link = None;
        while at != 0 && seen.insert(at) && page < limits.items {
            let directory = Directory::read(source, header, at)?;
            if page == 0 {
                let compression = directory.number(source, order, length, tag::COMPRESSION)?;
                if Packing::of(compression.unwrap_or(PLAIN)) == Packing::Copied {
                    return Ok(None);
                }
            }
            let entries = anew.page(source, &directory, length)?;
            anew.link(&mut link, &entries);
            let size = anew.directories.len() + anew.segments.len() * size_of::<Segment>();
            if size as u64 > FREE + RATIO * length {
                return Err(Error::new(ErrorKind::InvalidData, "TIFF: directories that are more than the file"));
            }
            (at, page) = (directory.next, page + 1);
        }
        Ok(Some(anew))
    }

    /// Appends a directory, and writes into the one before, or the header, where it is. `link` is where it then says where the next one is.
    fn link(&mut self, link: &mut Option<usize>, entries: &[Entry]) {
        let order = self.order;
        let here = order.bytes::<8>(self.start + self.directories.len() as u64);
        match *link {
            Some(at) => self.directories[at..at + 8].copy_from_slice(&here),
            None => {
                let mark = if order.is_big { b"MM" } else { b"II" };
                self.header = [&mark[..], &order.bytes::<2>(43), &order.bytes::<2>(8), &[0; 2], &here].concat();
            }
        }
        self.directories.extend(order.bytes::<8>(entries.len() as u64));
        for entry in entries {
            self.directories.extend(order.bytes::<2>(entry.tag.into()));
            self.directories.extend(order.bytes::<2>(entry.kind.into()));
            self.directories.extend(order.bytes::<8>(entry.count));
            self.directories.extend(entry.value);
        }
        *link = Some(self.directories.len());
        self.directories.extend([0; 8]);
    }

    /// The entries of a page without compression, its segments being those that are appended.
    fn page(&mut self, source: &mut (impl Read + Seek), directory: &Directory, length: u64) -> io::Result<Vec<Entry>> {
        let order = self.order;
        let mut number = |tag: u16| directory.number(source, order, length, tag);
        let packing = Packing::of(number(tag::COMPRESSION)?.unwrap_or(PLAIN));
        let (width, height) = (number(tag::WIDTH)?.unwrap_or(0), number(tag::HEIGHT)?.unwrap_or(0));
        let (bits, all_channels) = (number(tag::BITS)?.unwrap_or(1), number(tag::CHANNELS)?.unwrap_or(1));
        let is_apart = number(tag::PLANES)? == Some(2);
        let channels = if is_apart { 1 } else { all_channels };
        let tiles = (number(tag::TILE_WIDTH)?, number(tag::TILE_HEIGHT)?);
        let rows = number(tag::ROWS)?.unwrap_or(height).clamp(1, height.max(1));
        let per_plane = height.div_ceil(rows).max(1);
        let (offsets, sizes) = match directory.entry(tag::TILES) {
            Some(_) => (tag::TILES, tag::TILE_SIZES),
            None => (tag::STRIPS, tag::STRIP_SIZES),
        };
        let mut numbers = |tag: u16| match directory.entry(tag) {
            Some(entry) => entry.numbers(source, order, length),
            None => Ok(Vec::new()),
        };
        let (places, packed) = (numbers(offsets)?, numbers(sizes)?);
        let (mut starts, mut lengths) = (Vec::new(), Vec::new());
        for (index, (&at, &packed)) in places.iter().zip(&packed).enumerate() {
            let (width, height) = match tiles {
                (Some(width), Some(height)) => (width, height),
                _ => (width, rows.min(height - (index as u64 % per_plane * rows).min(height))),
            };
            let shape = Shape { width, height, channels, bits };
            let size = if packing == Packing::Copied { Some(packed) } else { shape.size() };
            let start = self.segments.last().map_or(SEGMENTS, |last| last.start + last.size);
            let size = size.filter(|&size| size < SEGMENTS && start < u64::MAX / 2);
            let size = size.ok_or_else(|| Error::new(ErrorKind::InvalidData, "TIFF: an impossible size"))?;
            let number = index as u32;
            self.segments.push(Segment { start, size, source: at, packed, packing, shape, number });
            starts.push(start);
            lengths.push(size);
        }
        let is_color = matches!(packing, Packing::Jpeg2000 { .. }) && !is_apart && all_channels == 3;
        let mut entries = Vec::with_capacity(directory.entries.len());
        for entry in &directory.entries {
            entries.push(match entry.tag {
                tag if tag == offsets => self.long_numbers(tag, &starts),
                tag if tag == sizes => self.long_numbers(tag, &lengths),
                tag::COMPRESSION if packing != Packing::Copied => Entry::new(order, entry.tag, SHORT, 1, PLAIN),
                tag::PHOTOMETRIC if is_color => Entry::new(order, entry.tag, SHORT, 1, RED_GREEN_BLUE),
                // Of what is no pixel any more.
                tag::PREDICTOR | tag::SUBSAMPLING if matches!(packing, Packing::Jpeg2000 { .. }) => continue,
                _ => self.kept(source, entry)?,
            });
        }
        Ok(entries)
    }

    /// An entry of numbers, which are appended where there are several.
    fn long_numbers(&mut self, tag: u16, numbers: &[u64]) -> Entry {
        let order = self.order;
        if let [number] = numbers {
            return Entry::new(order, tag, LONG8, 1, *number);
        }
        let at = self.start + self.directories.len() as u64;
        self.directories.extend(numbers.iter().flat_map(|&number| order.bytes::<8>(number)));
        Entry::new(order, tag, LONG8, numbers.len() as u64, at)
    }

    /// An entry as it is. Values that lie where the header takes more room than it did are copied.
    fn kept(&mut self, source: &mut (impl Read + Seek), entry: &Entry) -> io::Result<Entry> {
        let at = self.order.number(&entry.value);
        let size = entry.size().unwrap_or(0);
        if size <= 8 || at >= HEADER as u64 {
            return Ok(entry.clone());
        }
        let values = bytes_at(source, at, size)?;
        let value = self.order.bytes(self.start + self.directories.len() as u64);
        self.directories.extend(values);
        Ok(Entry { value, ..entry.clone() })
    }
}
