//! LAZ: chunks of points are decompressed on all threads by the crate `laz`, after the sizes that it would believe have been
//! held against the file. (Isenburg, "LASzip: lossless compression of LiDAR data", 2013, and the LAZ specification of 2022.)

use super::header::{Header, array};
use super::records::{Found, Part, Records};
use super::unsupported;
use crate::import::source::guard::guarded;
use crate::import::source::input::{Input, ReadSeek};
use laz::laszip::{ChunkTable, ChunkTableEntry};
use laz::{DecompressionSelection, LazItemType, LazVlr, par_decompress_selective};
use rayon::prelude::*;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use voxtrace_voxelize::{ImportError, Limits};

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
    let (source, length) = input.seekable()?;
    let mut points = Decompressor::open(path, source, length, header, limits)?;
    records.make_room(header.points).map_err(|what| ImportError::malformed(path, header.data, what))?;
    points.next(records, usize::MAX).map(drop)
}

/// The points of a compressed file, some chunks at a time.
pub(super) struct Decompressor {
    path: PathBuf,
    source: Box<dyn ReadSeek>,
    /// How points are compressed, if there are any.
    description: Option<LazVlr>,
    record_size: usize,
    /// Where the points begin, and where the next chunk does.
    start: u64,
    at: u64,
    /// All chunks, and how many are done.
    chunks: Vec<ChunkTableEntry>,
    done: usize,
}

/// A chunk that somebody is to decompress, and where its points go to.
struct Job<'a> {
    /// Its place among the jobs.
    number: usize,
    chunk: ChunkTableEntry,
    part: Part<'a>,
}

impl Decompressor {
    /// Holds what the file says of its points against its length, and goes to the first one.
    pub fn open(
        path: &Path,
        mut source: Box<dyn ReadSeek>,
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
            source,
            description,
            record_size: header.record_size.into(),
            start: header.data,
            // The place of the table of chunks stands before them.
            at: header.data + 8,
            chunks,
            done: 0,
        })
    }

    /// Adds the points of the next chunks, a chunk at a time on each thread, which also converts what it has decompressed. At least
    /// one, and no more than are `most` bytes; whether there were any.
    pub fn next(&mut self, records: &mut Records, most: usize) -> Result<bool, ImportError> {
        self.look_for_offset(records)?;
        let Some(description) = &self.description else { return Ok(false) };
        let (path, fault) = (&self.path, |what| ImportError::malformed(&self.path, self.start, what));
        let (mut count, mut size) = (0, 0usize);
        for chunk in &self.chunks[self.done..] {
            size = size.saturating_add(chunk.point_count as usize * self.record_size);
            if count > 0 && size > most {
                break;
            }
            count += 1;
        }
        let chunks = &self.chunks[self.done..self.done + count];
        let parts = records.places(chunks.iter().map(|chunk| chunk.point_count as usize));
        let jobs = chunks.iter().zip(parts).enumerate();
        let jobs = jobs.map(|(number, (&chunk, part))| Job { number, chunk, part });
        let source = &mut self.source;
        source.seek(SeekFrom::Start(self.at)).map_err(|error| ImportError::io(path, error))?;
        // Who takes a job also takes its bytes, so that they are read in their order.
        let queue = Mutex::new((jobs, source));
        let has_failed = AtomicBool::new(false);
        let take = |packed: &mut Vec<u8>| {
            let mut queue = queue.lock().ok()?;
            let job = queue.0.next().filter(|_| !has_failed.load(Relaxed))?;
            packed.resize(job.chunk.byte_count as usize, 0);
            let read = queue.1.read_exact(packed);
            Some((job, read))
        };
        let work = |_| {
            let (mut packed, mut points, mut done) = (Vec::new(), Vec::new(), Vec::new());
            while let Some((Job { number, chunk, part }, read)) = take(&mut packed) {
                let found = read.map_err(|error| ImportError::io(path, error)).and_then(|()| {
                    points.resize(chunk.point_count as usize * self.record_size, 0);
                    decompress(&packed, &mut points, description, chunk).map_err(fault)?;
                    Ok(part.fill(&points))
                });
                has_failed.fetch_or(found.is_err(), Relaxed);
                done.push((number, found));
            }
            done
        };
        let threads = (0..rayon::current_num_threads().min(count)).into_par_iter().with_max_len(1);
        let mut done: Vec<_> = threads.flat_map_iter(work).collect();
        // What came before the first fault was taken before it: which one is told does not depend on the threads.
        done.sort_unstable_by_key(|&(number, _)| number);
        let found: Vec<Found> = done.into_iter().map(|(_, found)| found).collect::<Result<_, _>>()?;
        records.settle(&found);
        self.at += chunks.iter().map(|chunk| chunk.byte_count).sum::<u64>();
        self.done += count;
        Ok(count > 0)
    }

    /// Adds the first points, at most so many.
    pub fn first(&mut self, records: &mut Records, most: u32) -> Result<(), ImportError> {
        let (Some(description), Some(&chunk)) = (&self.description, self.chunks.first()) else { return Ok(()) };
        let mut packed = vec![0; chunk.byte_count as usize];
        let io = |error| ImportError::io(&self.path, error);
        self.source.seek(SeekFrom::Start(self.at)).and_then(|_| self.source.read_exact(&mut packed)).map_err(io)?;
        let some = ChunkTableEntry { point_count: chunk.point_count.min(most.into()), ..chunk };
        let mut points = vec![0; some.point_count as usize * self.record_size];
        let fault = |what| ImportError::malformed(&self.path, self.start, what);
        decompress(&packed, &mut points, description, some).map_err(fault)?;
        records.add(&points);
        Ok(())
    }

    /// Looks for the first point that is kept: chunks begin with one that is not compressed.
    pub fn look_for_offset(&mut self, records: &mut Records) -> Result<(), ImportError> {
        let Some(description) = &self.description else { return Ok(()) };
        let mut at = self.at;
        for &chunk in &self.chunks[self.done..] {
            if records.has_offset() {
                break;
            }
            let io = |error| ImportError::io(&self.path, error);
            let mut packed = vec![0; chunk.byte_count as usize];
            self.source.seek(SeekFrom::Start(at)).and_then(|_| self.source.read_exact(&mut packed)).map_err(io)?;
            records.look_for_offset(packed.get(..self.record_size).unwrap_or_default());
            if !records.has_offset() {
                let mut points = vec![0; chunk.point_count as usize * self.record_size];
                let fault = |what| ImportError::malformed(&self.path, self.start, what);
                decompress(&packed, &mut points, description, chunk).map_err(fault)?;
                records.look_for_offset(&points);
            }
            at += chunk.byte_count;
        }
        Ok(())
    }
}

/// The points of a chunk.
fn decompress(packed: &[u8], points: &mut [u8], description: &LazVlr, chunk: ChunkTableEntry) -> Result<(), String> {
    let mut work = || par_decompress_selective(packed, points, description, &[chunk], WANTED);
    guarded(|| work().map_err(|error| error.to_string()))
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
