//! LAZ: chunks of points are decompressed on all threads by the crate `laz`, after the sizes that it would believe have been
//! held against the file. (Isenburg, "LASzip: lossless compression of LiDAR data", 2013, and the LAZ specification of 2022.)

use super::header::{Header, array};
use super::records::Records;
use super::unsupported;
use crate::import::{ImportError, Limits, guard::guarded, input::Input};
use laz::laszip::{ChunkTable, ChunkTableEntry};
use laz::{DecompressionSelection, LazItemType, LazVlr, par_decompress_selective};
use std::io::{Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Bytes of points decompressed at once, about.
const BATCH: usize = 32 << 20;
/// Most points of a chunk: writers use 50,000.
const LARGEST_CHUNK: u64 = 1 << 22;
/// Bytes before the content of a variable length record.
const RECORD_HEAD: usize = 54;
/// Compressors whose points come in chunks: point by point, and in layers.
const CHUNKED: [u16; 2] = [2, 3];
/// What of points in layers is asked for; other layers are gone over.
const WANTED: DecompressionSelection = DecompressionSelection(
    DecompressionSelection::Z
        | DecompressionSelection::CLASSIFICATION
        | DecompressionSelection::FLAGS
        | DecompressionSelection::INTENSITY
        | DecompressionSelection::RGB,
);

/// Decompresses all points.
pub(super) fn read(input: Input, header: &Header, limits: &Limits, records: &mut Records) -> Result<(), ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    let length = bytes.len() as u64;
    let mut points = Decompressor::open(path, Cursor::new(bytes), length, header, limits)?;
    records.make_room(header.points).map_err(|what| ImportError::malformed(path, header.data, what))?;
    while let Some(bytes) = points.next()? {
        records.add(bytes);
    }
    Ok(())
}

/// A file or its bytes.
trait Source: Read + Seek {}
impl<R: Read + Seek> Source for R {}

/// The points of a compressed file, some chunks at a time.
pub(super) struct Decompressor {
    path: PathBuf,
    source: Box<dyn Source>,
    /// How points are compressed, if there are any.
    description: Option<LazVlr>,
    record_size: usize,
    /// Where the points begin, and where the next chunk does.
    start: u64,
    at: u64,
    /// All chunks, and how many are done.
    chunks: Vec<ChunkTableEntry>,
    done: usize,
    packed: Vec<u8>,
    points: Vec<u8>,
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
        let (mut description, mut chunks) = (None, Vec::new());
        if header.points > 0 {
            let found = self::description(path, &mut source, length, header)?;
            chunks = self::chunks(path, &mut source, length, header, &found)?;
            description = Some(found);
        }
        Ok(Self {
            path: path.into(),
            source: Box::new(source),
            description,
            record_size: header.record_size.into(),
            start: header.data,
            // The place of the table of chunks stands before them.
            at: header.data + 8,
            chunks,
            done: 0,
            packed: Vec::new(),
            points: Vec::new(),
        })
    }

    /// The bytes of the next points, `None` behind the last one.
    pub fn next(&mut self) -> Result<Option<&[u8]>, ImportError> {
        let fault = |what: String| ImportError::malformed(&self.path, self.start, what);
        let rest = &self.chunks[self.done..];
        let (mut count, mut packed, mut size) = (0, 0, 0);
        for chunk in rest {
            let more = chunk.point_count as usize * self.record_size;
            if count > 0 && size + more > BATCH {
                break;
            }
            (count, packed, size) = (count + 1, packed + chunk.byte_count as usize, size + more);
        }
        let Some(description) = self.description.as_ref().filter(|_| count > 0) else { return Ok(None) };
        self.packed.resize(packed, 0);
        let read = self.source.seek(SeekFrom::Start(self.at)).and_then(|_| self.source.read_exact(&mut self.packed));
        read.map_err(|error| ImportError::io(&self.path, error))?;
        self.points.resize(size, 0);
        let (packed, points) = (&self.packed, &mut self.points);
        let decompress = || {
            par_decompress_selective(packed, points, description, &rest[..count], WANTED)
                .map_err(|error| error.to_string())
        };
        guarded(decompress).map_err(fault)?;
        self.at += packed.len() as u64;
        self.done += count;
        Ok(Some(&self.points))
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
            let place = content;
            let Some(content) = bytes_at(source, content, size.into()) else { break };
            if let Some(compressor) = content.first_chunk().map(|&bytes| u16::from_le_bytes(bytes))
                && !CHUNKED.contains(&compressor)
            {
                return Err(unsupported(path, place, format!("points compressed in way {compressor}, not in chunks")));
            }
            let description = guarded(|| LazVlr::from_buffer(&content).map_err(|error| error.to_string()));
            return description.map_err(|what| ImportError::malformed(path, at, what));
        }
        at = end;
    }
    Err(ImportError::malformed(path, at.min(length), "no record says how the points are compressed"))
}

/// The chunks that hold the points. They, and the layers in them, are in the file.
fn chunks(
    path: &Path,
    source: &mut (impl Read + Seek + Send),
    length: u64,
    header: &Header,
    description: &LazVlr,
) -> Result<Vec<ChunkTableEntry>, ImportError> {
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
    let table_of_chunks =
        guarded(|| ChunkTable::read_from(&mut *source, description).map_err(|error| error.to_string()));
    let table_of_chunks = table_of_chunks.map_err(|what| fault(&what))?;
    let layers: usize = description.items().iter().map(layers_of).sum();
    let (mut place, mut points, mut chunks) = (start + 8, 0u64, Vec::new());
    for chunk in table_of_chunks.as_ref() {
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
        // Chunks of one size are full but the last one.
        let used = chunk.point_count.min(header.points.saturating_sub(points));
        if points < header.points {
            let mut entry = *chunk;
            entry.point_count = used;
            chunks.push(entry);
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
    Ok(chunks)
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
