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
use std::io::Cursor;
use std::path::Path;

/// Points decompressed at once.
const BATCH: u64 = 1 << 20;
/// Most points of a chunk: writers use 50,000.
const LARGEST_CHUNK: u64 = 1 << 22;
/// Beyond 16 MiB, a file may not become larger than so many times itself.
const RATIO: u64 = 200;
/// Bytes before the content of a variable length record.
const RECORD_HEAD: usize = 54;

/// Decompresses all points.
pub(super) fn read(input: Input, header: &Header, limits: &Limits, records: &mut Records) -> Result<(), ImportError> {
    let path = input.path();
    let mut bytes = input.rest()?;
    let length = bytes.len() as u64;
    let size = header.points.saturating_mul(header.record_size.into());
    let most = limits.bytes.min((16 << 20).max(length.saturating_mul(RATIO)));
    if size > most {
        return Err(ImportError::limit(path, Some(header.points_at), "bytes of points", size, most));
    }
    if header.points == 0 {
        return Ok(());
    }
    let description = description(path, &bytes, header)?;
    check_chunks(path, &bytes, header, &description)?;
    if header.has_long_records {
        // Long records at the end hold nothing that we want.
        bytes[235..247].fill(0);
        // The crate knows no 1.5, which has the points of 1.4.
        bytes[25] = 4;
    }
    let fault = |what: String| ImportError::malformed(path, header.data, what);
    let mut reader = guarded(|| Reader::new(Cursor::new(bytes)).map_err(|error| error.to_string())).map_err(fault)?;
    let found: Format = *reader.header().point_format();
    if found.len() != header.record_size || reader.header().number_of_points() != header.points {
        return Err(fault("the header contradicts itself".into()));
    }
    let mut points = guarded(|| reader.read_points(0).map_err(|error| error.to_string())).map_err(fault)?;
    let mut left = header.points;
    while left > 0 {
        let now = left.min(BATCH);
        guarded(|| reader.fill_points(now, &mut points).map_err(|error| error.to_string())).map_err(fault)?;
        records.add(points.raw_bytes());
        left -= now;
    }
    Ok(())
}

/// The record that says how points are compressed.
fn description(path: &Path, bytes: &[u8], header: &Header) -> Result<LazVlr, ImportError> {
    let mut at = header.size as usize;
    for _ in 0..header.records {
        let Some(head) = bytes.get(at..at + RECORD_HEAD) else { break };
        let length = usize::from(u16::from_le_bytes(array(head, 20)));
        let end = at + RECORD_HEAD + length;
        if end as u64 > header.data.min(bytes.len() as u64) {
            break;
        }
        if head[2..18].starts_with(b"laszip encoded") && u16::from_le_bytes(array(head, 18)) == 22204 {
            let content = &bytes[at + RECORD_HEAD..end];
            let description = guarded(|| LazVlr::from_buffer(content).map_err(|error| error.to_string()));
            return description.map_err(|what| ImportError::malformed(path, at as u64, what));
        }
        at = end;
    }
    Err(ImportError::malformed(path, at.min(bytes.len()) as u64, "no record says how the points are compressed"))
}

/// Checks that the chunks of points, and the layers in them, can be in the file.
fn check_chunks(path: &Path, bytes: &[u8], header: &Header, description: &LazVlr) -> Result<(), ImportError> {
    let at = header.data;
    let fault = |what: &str| ImportError::malformed(path, at.min(bytes.len() as u64), what);
    if description.items_size() != u64::from(header.record_size) {
        return Err(fault("the compression describes other points than the header"));
    }
    let is_variable = description.uses_variable_size_chunks();
    if !is_variable && u64::from(description.chunk_size()) > LARGEST_CHUNK {
        return Err(unsupported(path, at, format!("chunks of {} points", description.chunk_size())));
    }
    let start = usize::try_from(at).map_err(|_| fault("the points begin beyond the file"))?;
    let read = |at: usize| bytes.get(at..at.checked_add(8)?).map(|bytes| i64::from_le_bytes(array(bytes, 0)));
    let behind = |&place: &i64| place > start as i64;
    // A writer that cannot go back writes the place of the table at the end.
    let table = read(start).filter(behind).or_else(|| read(bytes.len().checked_sub(8)?).filter(behind));
    let table = table.and_then(|table| usize::try_from(table).ok()).filter(|&table| table <= bytes.len());
    let table = table.ok_or_else(|| ImportError::truncated(path, bytes.len() as u64, "the compressed points"))?;
    let count = bytes.get(table..table + 8).map(|head| u32::from_le_bytes(array(head, 4)));
    let count = count.ok_or_else(|| ImportError::truncated(path, bytes.len() as u64, "the table of chunks"))?;
    // Each chunk begins with a whole point.
    if u64::from(count) > (table - start) as u64 / u64::from(header.record_size) {
        return Err(fault("more chunks than the file has room for"));
    }
    let mut source = Cursor::new(bytes);
    source.set_position(at);
    let chunks = guarded(|| ChunkTable::read_from(&mut source, description).map_err(|error| error.to_string()));
    let chunks = chunks.map_err(|what| fault(&what))?;
    let layers: usize = description.items().iter().map(layers_of).sum();
    let (mut place, mut points) = (start + 8, 0u64);
    for chunk in chunks.as_ref() {
        let end = usize::try_from(chunk.byte_count).ok().and_then(|size| place.checked_add(size));
        let end = end.filter(|&end| end <= table).ok_or_else(|| fault("a chunk that reaches beyond the points"))?;
        if chunk.point_count > LARGEST_CHUNK {
            return Err(unsupported(path, place as u64, format!("chunks of {} points", chunk.point_count)));
        }
        if layers > 0 {
            let head = usize::from(header.record_size) + 4;
            let sizes = bytes[place..end].get(head..head + 4 * layers);
            let sizes = sizes.ok_or_else(|| fault("a chunk without its layers"))?;
            let sum: u64 = sizes.chunks_exact(4).map(|size| u64::from(u32::from_le_bytes(array(size, 0)))).sum();
            if sum > (end - place) as u64 {
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
