//! LAZ: the points come from the crate `las`, after the sizes that it would believe have been held against the file.
//! (Isenburg, "LASzip: lossless compression of LiDAR data", 2013, and the LAZ specification of 2022.)

use super::header::{Header, array};
use super::records::Records;
use super::unsupported;
use crate::import::{ImportError, Limits, guard::guarded, input::Input};
use las::Reader;
use las::point::Format;
use laz::laszip::ChunkTable;
use laz::{LazItemType, LazVlr};
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Points decompressed at once.
const BATCH: u64 = 1 << 20;
/// Most points of a chunk: writers use 50,000.
const LARGEST_CHUNK: u64 = 1 << 22;
/// Bytes before the content of a variable length record.
const RECORD_HEAD: usize = 54;

/// Decompresses all points.
pub(super) fn read(input: Input, header: &Header, limits: &Limits, records: &mut Records) -> Result<(), ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    let length = bytes.len() as u64;
    let mut points = Decompressor::open(path, Cursor::new(bytes), length, header, limits)?;
    while let Some(bytes) = points.next()? {
        records.add(bytes);
    }
    Ok(())
}

/// The points of a compressed file, some at a time.
pub(super) struct Decompressor {
    path: PathBuf,
    /// Where the points begin.
    at: u64,
    reader: Option<(Reader, las::PointData)>,
    left: u64,
}

impl Decompressor {
    /// Holds what the file says of its points against its length, and goes to the first one.
    pub fn open<R: Read + Seek + Send + Sync + 'static>(
        path: &Path,
        mut source: R,
        length: u64,
        header: &Header,
        limits: &Limits,
    ) -> Result<Self, ImportError> {
        let size = header.points.saturating_mul(header.record_size.into());
        let most = limits.bytes.min((16 << 20).max(length.saturating_mul(limits.ratio)));
        if size > most {
            return Err(ImportError::limit(path, Some(header.points_at), "bytes of points", size, most));
        }
        let mut own = Self { path: path.into(), at: header.data, reader: None, left: header.points };
        if header.points == 0 {
            return Ok(own);
        }
        let io = |error| ImportError::io(path, error);
        let description = description(path, &mut source, length, header)?;
        check_chunks(path, &mut source, length, header, &description)?;
        let mut head = vec![0; header.size.min(length) as usize];
        source.seek(SeekFrom::Start(0)).and_then(|_| source.read_exact(&mut head)).map_err(io)?;
        if header.has_long_records {
            // Long records at the end hold nothing that we want.
            head[235..247].fill(0);
            // The crate knows no 1.5, which has the points of 1.4.
            head[25] = 4;
        }
        let patched = Patched { head, source, at: 0 };
        let reader = guarded(|| Reader::new(patched).map_err(|error| error.to_string()));
        let mut reader = reader.map_err(|what| own.fault(what))?;
        let found: Format = *reader.header().point_format();
        if found.len() != header.record_size || reader.header().number_of_points() != header.points {
            return Err(own.fault("the header contradicts itself".into()));
        }
        let none = guarded(|| reader.read_points(0).map_err(|error| error.to_string()));
        let none = none.map_err(|what| own.fault(what))?;
        own.reader = Some((reader, none));
        Ok(own)
    }

    /// The bytes of the next points, `None` behind the last one.
    pub fn next(&mut self) -> Result<Option<&[u8]>, ImportError> {
        let now = self.left.min(BATCH);
        let (path, at) = (&self.path, self.at);
        let Some((reader, points)) = self.reader.as_mut().filter(|_| now > 0) else { return Ok(None) };
        guarded(|| reader.fill_points(now, points).map_err(|error| error.to_string()))
            .map_err(|what| ImportError::malformed(path, at, what))?;
        self.left -= now;
        Ok(Some(points.raw_bytes()))
    }

    fn fault(&self, what: String) -> ImportError {
        ImportError::malformed(&self.path, self.at, what)
    }
}

/// A file whose first bytes are others.
struct Patched<R> {
    head: Vec<u8>,
    source: R,
    at: u64,
}

impl<R: Read + Seek> Read for Patched<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = match self.head.get(usize::try_from(self.at).unwrap_or(usize::MAX)..) {
            Some(mut rest) if !rest.is_empty() => rest.read(buffer)?,
            _ => self.source.read(buffer)?,
        };
        self.at += count as u64;
        if self.at == self.head.len() as u64 {
            self.source.seek(SeekFrom::Start(self.at))?;
        }
        Ok(count)
    }
}

impl<R: Read + Seek> Seek for Patched<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = match to {
            SeekFrom::Current(by) => self.source.seek(SeekFrom::Start(self.at.saturating_add_signed(by)))?,
            to => self.source.seek(to)?,
        };
        Ok(self.at)
    }
}

/// So many bytes from a place on, `None` where the file has not as many.
fn bytes_at(source: &mut (impl Read + Seek), at: u64, count: usize) -> Option<Vec<u8>> {
    let mut bytes = vec![0; count];
    source.seek(SeekFrom::Start(at)).and_then(|_| source.read_exact(&mut bytes)).ok()?;
    Some(bytes)
}

/// The record that says how points are compressed.
fn description(
    path: &Path,
    source: &mut (impl Read + Seek),
    length: u64,
    header: &Header,
) -> Result<LazVlr, ImportError> {
    let mut at = header.size;
    for _ in 0..header.records {
        let Some(head) = bytes_at(source, at, RECORD_HEAD) else { break };
        let size = u16::from_le_bytes(array(&head, 20));
        let content = at + RECORD_HEAD as u64;
        let end = content + u64::from(size);
        if end > header.data.min(length) {
            break;
        }
        if head[2..18].starts_with(b"laszip encoded") && u16::from_le_bytes(array(&head, 18)) == 22204 {
            let Some(content) = bytes_at(source, content, size.into()) else { break };
            let description = guarded(|| LazVlr::from_buffer(&content).map_err(|error| error.to_string()));
            return description.map_err(|what| ImportError::malformed(path, at, what));
        }
        at = end;
    }
    Err(ImportError::malformed(path, at.min(length), "no record says how the points are compressed"))
}

/// Checks that the chunks of points, and the layers in them, can be in the file.
fn check_chunks(
    path: &Path,
    source: &mut (impl Read + Seek + Send),
    length: u64,
    header: &Header,
    description: &LazVlr,
) -> Result<(), ImportError> {
    let start = header.data;
    let fault = |what: &str| ImportError::malformed(path, start.min(length), what);
    if description.items_size() != u64::from(header.record_size) {
        return Err(fault("the compression describes other points than the header"));
    }
    let is_variable = description.uses_variable_size_chunks();
    if !is_variable && u64::from(description.chunk_size()) > LARGEST_CHUNK {
        return Err(unsupported(path, start, format!("chunks of {} points", description.chunk_size())));
    }
    if start > length {
        return Err(fault("the points begin beyond the file"));
    }
    let mut place_at = |at: u64| {
        let place = bytes_at(source, at, 8).map(|bytes| i64::from_le_bytes(array(&bytes, 0)));
        place.and_then(|place| u64::try_from(place).ok()).filter(|&place| place > start)
    };
    // A writer that cannot go back writes the place of the table at the end.
    let table = place_at(start).or_else(|| place_at(length.checked_sub(8)?));
    let table = table.filter(|&table| table <= length);
    let table = table.ok_or_else(|| ImportError::truncated(path, length, "the compressed points"))?;
    let count = bytes_at(source, table, 8).map(|head| u32::from_le_bytes(array(&head, 4)));
    let count = count.ok_or_else(|| ImportError::truncated(path, length, "the table of chunks"))?;
    // Each chunk begins with a whole point.
    if u64::from(count) > (table - start) / u64::from(header.record_size) {
        return Err(fault("more chunks than the file has room for"));
    }
    source.seek(SeekFrom::Start(start)).map_err(|error| ImportError::io(path, error))?;
    let chunks = guarded(|| ChunkTable::read_from(&mut *source, description).map_err(|error| error.to_string()));
    let chunks = chunks.map_err(|what| fault(&what))?;
    let layers: usize = description.items().iter().map(layers_of).sum();
    let (mut place, mut points) = (start + 8, 0u64);
    for chunk in chunks.as_ref() {
        let end = place.checked_add(chunk.byte_count).filter(|&end| end <= table);
        let end = end.ok_or_else(|| fault("a chunk that reaches beyond the points"))?;
        if chunk.point_count > LARGEST_CHUNK {
            return Err(unsupported(path, place, format!("chunks of {} points", chunk.point_count)));
        }
        if layers > 0 {
            let head = u64::from(header.record_size) + 4;
            let sizes = (head + 4 * layers as u64 <= end - place).then(|| bytes_at(source, place + head, 4 * layers));
            let sizes = sizes.flatten().ok_or_else(|| fault("a chunk without its layers"))?;
            let sum: u64 = sizes.chunks_exact(4).map(|size| u64::from(u32::from_le_bytes(array(size, 0)))).sum();
            if sum > end - place {
                return Err(fault("a layer that reaches beyond its chunk"));
            }
        }
        points = points.saturating_add(chunk.point_count);
        place = end;
    }
    if points < header.points {
        return Err(fault("fewer points in the chunks than in the header"));
    }
    if is_variable && points > header.points {
        return Err(fault("more points in the chunks than in the header"));
    }
    Ok(())
}

/// Layers of a part of points that is compressed in layers.
fn layers_of(item: &laz::LazItem) -> usize {
    match item.item_type() {
        LazItemType::Point14 => 9,
        LazItemType::RGB14 | LazItemType::WavePacket14 => 1,
        LazItemType::RGBNIR14 => 2,
        LazItemType::Byte14(count) => usize::from(count),
        _ => 0,
    }
}
