//! Where things lie in a binary glTF file, or in the one beside a text, so that they can be read one by one: its document, pictures and plain arrays.

use super::accessor::{component, is_whole, size_of_component, whole, width_of};
use super::byte_cache::ByteCache;
use super::document::Buffer;
use super::document::Document;
use super::{CHUNK_BIN, CHUNK_JSON, MAGIC};
use crate::import::source::folder::Folder;
use serde::Deserialize;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::ImportError;

/// The document of a file, the file that its arrays lie in, and where there; `None` where they lie otherwise.
pub(super) struct Container {
    pub json: Vec<u8>,
    pub arrays: PathBuf,
    pub binary: Range<u64>,
}

/// Of a binary file; or of a text whose only buffer is a file beside it.
pub(super) fn container(path: &Path, folder: &Folder, bytes: u64, budget: u64) -> std::io::Result<Option<Container>> {
    let mut file = File::open(path)?;
    if let Some((json, binary)) = chunks(&mut file, bytes, budget)? {
        return Ok(Some(Container { json, arrays: path.into(), binary }));
    }
    // What describes the arrays has to fit into memory.
    if bytes > budget.max(1 << 24) {
        return Ok(None);
    }
    let mut json = Vec::new();
    file.seek(SeekFrom::Start(0))?;
    file.take(bytes).read_to_end(&mut json)?;
    let Ok(Listed { buffers }) = serde_json::from_slice(&json) else { return Ok(None) };
    let [Buffer { uri: Some(uri), byte_length }] = &buffers[..] else { return Ok(None) };
    let Ok(arrays) = folder.path_of_uri(uri) else { return Ok(None) };
    let length = *byte_length as u64;
    let is_whole = std::fs::metadata(&arrays)?.len() >= length;
    Ok(is_whole.then_some(Container { json, arrays, binary: 0..length }))
}

/// Of a document its buffers.
#[derive(Deserialize)]
struct Listed {
    #[serde(default)]
    buffers: Vec<Buffer>,
}

/// The JSON of a binary file and where its binary chunk lies; `None` where it is no whole binary glTF file.
fn chunks(file: &mut File, bytes: u64, budget: u64) -> std::io::Result<Option<(Vec<u8>, Range<u64>)>> {
    if bytes < 20 {
        return Ok(None);
    }
    let mut head = [0; 12];
    file.read_exact(&mut head)?;
    let word =
        |head: &[u8], at: usize| u64::from(u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]));
    let length = word(&head, 8);
    if !head.starts_with(MAGIC) || word(&head, 4) != 2 || length > bytes {
        return Ok(None);
    }
    let (mut json, mut binary, mut at) = (None, None, 12);
    while at + 8 <= length {
        file.seek(SeekFrom::Start(at))?;
        file.read_exact(&mut head[..8])?;
        let (start, size, kind) = (at + 8, word(&head, 0), word(&head, 4) as u32);
        if start + size > length {
            return Ok(None);
        }
        match kind {
            // What describes the arrays has to fit into memory.
            CHUNK_JSON if json.is_none() && size > budget.max(1 << 24) => return Ok(None),
            CHUNK_JSON if json.is_none() => {
                let mut text = vec![0; size as usize];
                file.read_exact(&mut text)?;
                json = Some(text);
            }
            CHUNK_BIN if binary.is_none() => binary = Some(start..start + size),
            _ => {}
        }
        at = start + size;
    }
    Ok(json.zip(binary))
}

/// The views that pictures are in, read; `None` where the document is not plain or they are larger than the budget.
pub(super) fn pictures(
    document: &Document,
    file: &mut File,
    binary: &Range<u64>,
    budget: u64,
) -> std::io::Result<Option<Vec<Option<Vec<u8>>>>> {
    let is_plain = document.buffers.len() <= 1
        && document.buffer_views.iter().all(|view| view.buffer == 0 && view.extensions.meshopt.is_none());
    if !is_plain {
        return Ok(None);
    }
    let mut views = vec![None; document.buffer_views.len()];
    let mut total = 0;
    for index in document.images.iter().filter_map(|image| image.buffer_view) {
        let Some(range) = part_of(document, index, binary) else { return Ok(None) };
        total += range.end - range.start;
        if total > budget.max(1 << 24) {
            return Ok(None);
        }
        let mut bytes = vec![0; (range.end - range.start) as usize];
        file.seek(SeekFrom::Start(range.start))?;
        file.read_exact(&mut bytes)?;
        views[index] = Some(bytes);
    }
    Ok(Some(views))
}

/// Where a view lies in the file.
fn part_of(document: &Document, view: usize, binary: &Range<u64>) -> Option<Range<u64>> {
    let view = document.buffer_views.get(view)?;
    let start = binary.start.checked_add(view.byte_offset as u64)?;
    let end = start.checked_add(view.byte_length as u64)?;
    (end <= binary.end).then_some(start..end)
}

/// Vectors at equal distances in the file.
#[derive(Clone, Copy)]
pub(super) struct Array {
    pub start: u64,
    pub stride: u64,
    pub count: u64,
    /// Bytes of a vector, and numbers in it.
    size: usize,
    width: usize,
    kind: u32,
    is_normalized: bool,
}

impl Array {
    /// The array of an accessor, if all of it lies in the binary chunk.
    pub fn of(document: &Document, index: usize, kinds: &[&str], binary: &Range<u64>) -> Option<Self> {
        let accessor = document.accessors.get(index)?;
        if !kinds.contains(&accessor.kind.as_str()) || accessor.sparse.is_some() {
            return None;
        }
        let width = width_of(&accessor.kind)?;
        let size = size_of_component(accessor.component_type).ok()? * width;
        let view = accessor.buffer_view?;
        let range = part_of(document, view, binary)?;
        let stride = document.buffer_views[view].byte_stride.unwrap_or(size);
        let start = range.start.checked_add(accessor.byte_offset as u64)?;
        let count = accessor.count as u64;
        let needed = match count {
            0 => 0,
            _ => (stride as u64).checked_mul(count - 1)?.checked_add(size as u64)?,
        };
        let is_inside = stride >= size && start.checked_add(needed)? <= range.end;
        let (kind, is_normalized) = (accessor.component_type, accessor.normalized);
        is_inside.then_some(Self { start, stride: stride as u64, count, size, width, kind, is_normalized })
    }

    pub fn holds_indices(&self) -> bool {
        is_whole(self.kind)
    }

    /// The whole number of an item that exists.
    pub fn index(&self, item: u64, cache: &mut ByteCache) -> Result<u64, ImportError> {
        let mut bytes = [0; 4];
        cache.read(self.start + item * self.stride, &mut bytes[..self.size])?;
        Ok(whole(&bytes, self.kind).into())
    }

    /// The vector of an item that exists, filled up with `missing` to four numbers.
    pub fn vector(&self, item: u64, missing: f32, cache: &mut ByteCache) -> Result<[f32; 4], ImportError> {
        let (mut bytes, mut vector) = ([0; 16], [missing; 4]);
        let bytes = &mut bytes[..self.size];
        cache.read(self.start + item * self.stride, bytes)?;
        for (value, bytes) in vector.iter_mut().zip(bytes.chunks_exact(self.size / self.width)) {
            *value = component(bytes, self.kind, self.is_normalized);
        }
        Ok(vector)
    }
}
