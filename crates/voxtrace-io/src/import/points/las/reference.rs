//! The reference system of a LAS file: WKT, or the keys of GeoTIFF (OGC 19-008, "OGC GeoTIFF standard", annex B), in records
//! after the header (LAS 1.4 R15, "Coordinate reference system"); WKT also in extended records, which stand behind the points.

use super::header::{Header, array};
use crate::import::reader::geo_keys::{WORDS, of_keys};
use crate::import::reader::map_units::MapUnits;
use crate::import::source::input::Input;
use voxtrace_voxelize::{ImportError, Limits};

/// Records are looked for in so many bytes after the start of the file.
const FARTHEST: u64 = 1 << 20;
/// Bytes before the content of a record, and of an extended one.
const RECORD_HEAD: usize = 54;
const EXTENDED_HEAD: usize = 60;
/// Extended records that are looked through.
const MOST_EXTENDED: u32 = 1000;
/// Whose records these are.
const OWNER: &[u8] = b"LASF_Projection";
/// Numbers of records.
const WKT: u16 = 2112;
const KEYS: u16 = 34_735;

/// The reference system, empty where the file says none, and its units. Nothing is taken of the input.
pub(super) fn read(input: &mut Input, header: &Header) -> Result<(String, MapUnits), ImportError> {
    let bytes = input.peek(header.data.min(FARTHEST) as usize)?;
    let (mut at, mut keys, mut words) = (header.size as usize, Vec::new(), String::new());
    for _ in 0..header.records {
        let Some(head) = bytes.get(at..at.saturating_add(RECORD_HEAD)) else { break };
        let content = at + RECORD_HEAD;
        at = content + usize::from(u16::from_le_bytes(array(head, 20)));
        let Some(content) = bytes.get(content..at) else { break };
        if !head[2..].starts_with(OWNER) {
            continue;
        }
        let text = || text_of(content);
        match u16::from_le_bytes(array(head, 18)) {
            WKT if !content.is_empty() => {
                let text = text();
                let units = MapUnits::of_wkt(&text);
                return Ok((text, units));
            }
            KEYS => keys = content.as_chunks().0.iter().map(|&bytes| u16::from_le_bytes(bytes)).collect(),
            WORDS => words = text(),
            _ => {}
        }
    }
    if let Some(text) = extended(input, header) {
        let units = MapUnits::of_wkt(&text);
        return Ok((text, units));
    }
    Ok((of_keys(&keys, &words), MapUnits::of_keys(&keys)))
}

fn text_of(content: &[u8]) -> String {
    String::from_utf8_lossy(content).trim_end_matches(['\0', ' ']).to_owned()
}

/// The WKT of an extended record. Points can be read without it, so a damaged record is none; of a pipe or bytes in memory there is no way
/// there and back.
fn extended(input: &Input, header: &Header) -> Option<String> {
    let (count, start) = header.extended;
    if count == 0 || !matches!(input.file(), Ok(Some(_))) {
        return None;
    }
    let what = "an extended record";
    let mut input = Input::open_at(input.path(), start, &Limits { bytes: u64::MAX, ..Limits::default() }).ok()?;
    for _ in 0..count.min(MOST_EXTENDED) {
        let head = input.take(EXTENDED_HEAD, what).ok()?;
        let is_wkt = head[2..].starts_with(OWNER) && u16::from_le_bytes(array(head, 18)) == WKT;
        let length = u64::from_le_bytes(array(head, 20));
        if is_wkt && (1..=FARTHEST).contains(&length) {
            return input.take(length as usize, what).ok().map(text_of);
        }
        input.skip(length, what).ok()?;
    }
    None
}
