//! Shards: files that hold several chunks and an index of where each of them lies (zarr-specs, "Sharding codec", version 1.0).

use super::Store;
use super::codec::Codec;
use super::metadata::{Array, Fault};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::sync::{Arc, Mutex};
use voxtrace_voxelize::ImportError;

/// Offset and length of a chunk that is not there.
const ABSENT: u64 = u64::MAX;
/// Bytes of an entry of the index, and of the checksum behind it.
const ENTRY: usize = 16;
const CHECKSUM: usize = 4;
/// What is wrong with a chunk that is not within its shard.
const BEYOND: &str = "a chunk beyond its shard";

/// How the chunks of an array share files.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sharding {
    /// Chunks of a shard along each axis.
    pub chunks: Vec<u64>,
    pub index_at_start: bool,
    pub big_endian: bool,
    pub has_checksum: bool,
}

impl Sharding {
    /// From the shape of a shard, that of a chunk, where the index is and what it went through: bytes, and a checksum or not.
    pub fn new(
        shard: &[u64],
        chunk: &[u64],
        location: &str,
        big_endian: bool,
        codecs: &[Codec],
    ) -> Result<Self, Fault> {
        // Nothing is a multiple of everything too.
        let is_whole = |(shard, chunk): (&u64, &u64)| *chunk > 0 && *shard > 0 && shard.is_multiple_of(*chunk);
        if shard.len() != chunk.len() || !shard.iter().zip(chunk).all(is_whole) {
            return Err(Fault::Broken("shards that are not whole numbers of chunks"));
        }
        let has_checksum = match codecs {
            [] => false,
            [Codec::Checksum] => true,
            _ => return Err(Fault::Foreign("a compressed index of a shard".into())),
        };
        let index_at_start = match location {
            "start" => true,
            "end" => false,
            _ => return Err(Fault::Broken("an index of a shard that is nowhere")),
        };
        let chunks = shard.iter().zip(chunk).map(|(shard, chunk)| shard / chunk).collect();
        Ok(Self { chunks, index_at_start, big_endian, has_checksum })
    }

    /// Bytes of the index; `None` where that is more than anything can be.
    fn index_size(&self) -> Option<usize> {
        let count = self.chunks.iter().try_fold(1usize, |count, &chunks| count.checked_mul(chunks.try_into().ok()?))?;
        count.checked_mul(ENTRY)?.checked_add(if self.has_checksum { CHECKSUM } else { 0 })
    }

    /// Where the index lies in a shard of so many bytes.
    fn index_range(&self, length: u64) -> Range<u64> {
        let size = self.index_size().map_or(u64::MAX, |size| size as u64);
        if self.index_at_start { 0..size } else { length.saturating_sub(size)..length }
    }

    /// Where the chunk with the number `at` along each axis lies in its shard; `None` where it is not there.
    fn place(&self, index: &[u8], at: &[u64]) -> Result<Option<Range<u64>>, &'static str> {
        const BROKEN: &str = "a shard whose index does not fit";
        if self.index_size() != Some(index.len()) {
            return Err(BROKEN);
        }
        let number = at.iter().zip(&self.chunks).fold(0, |number, (at, chunks)| number * chunks + at) as usize;
        let word = |at: usize| {
            let bytes = index.get(at..).and_then(|rest| rest.first_chunk()).ok_or(BROKEN)?;
            Ok(if self.big_endian { u64::from_be_bytes(*bytes) } else { u64::from_le_bytes(*bytes) })
        };
        let (offset, length) = (word(number * ENTRY)?, word(number * ENTRY + 8)?);
        if (offset, length) == (ABSENT, ABSENT) {
            return Ok(None);
        }
        offset.checked_add(length).map(|end| Some(offset..end)).ok_or(BEYOND)
    }
}

/// The files of an array's chunks; the indices of shards are kept.
pub(super) struct Files<'a> {
    store: &'a Store,
    array: &'a Array,
    indices: Mutex<FxHashMap<String, Option<Arc<Vec<u8>>>>>,
}

impl<'a> Files<'a> {
    pub fn new(store: &'a Store, array: &'a Array) -> Self {
        Self { store, array, indices: Mutex::default() }
    }

    /// The stored bytes of a chunk by its number along each axis, `None` where it is not there; and its file's name.
    pub fn chunk(&self, at: &[u64]) -> Result<(Option<Vec<u8>>, String), ImportError> {
        let Some(sharding) = &self.array.sharding else {
            let name = self.array.chunk_name(at);
            return Ok((self.store.get(&name)?, name));
        };
        let of_shard: Vec<u64> = at.iter().zip(&sharding.chunks).map(|(at, chunks)| at / chunks).collect();
        let in_shard: Vec<u64> = at.iter().zip(&sharding.chunks).map(|(at, chunks)| at % chunks).collect();
        let name = self.array.chunk_name(&of_shard);
        let malformed = |what| self.store.malformed(&name, what);
        let Some(index) = self.index(sharding, &name)? else { return Ok((None, name)) };
        let Some(place) = sharding.place(&index, &in_shard).map_err(malformed)? else { return Ok((None, name)) };
        let chunk = self.store.part(&name, |_| place.clone())?.unwrap_or_default();
        if chunk.len() as u64 != place.end - place.start {
            return Err(malformed(BEYOND));
        }
        Ok((Some(chunk), name))
    }

    fn index(&self, sharding: &Sharding, name: &str) -> Result<Option<Arc<Vec<u8>>>, ImportError> {
        let known = self.indices.lock().ok().and_then(|indices| indices.get(name).cloned());
        if let Some(index) = known {
            return Ok(index);
        }
        let index = self.store.part(name, |length| sharding.index_range(length))?.map(Arc::new);
        if let Ok(mut indices) = self.indices.lock() {
            indices.insert(name.to_owned(), index.clone());
        }
        Ok(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sharding(location: &str) -> Sharding {
        Sharding::new(&[2, 4], &[2, 2], location, false, &[Codec::Checksum]).ok().unwrap()
    }

    #[test]
    fn chunks_are_found_by_the_index_at_either_end() {
        let entry = |offset: u64, length: u64| [offset.to_le_bytes(), length.to_le_bytes()].concat();
        let index = |a: Vec<u8>, b: Vec<u8>| [a, b, vec![0; 4]].concat();
        let own = index(entry(ABSENT, ABSENT), entry(1, 2));
        let end = sharding("end");
        assert_eq!((end.place(&own, &[0, 0]), end.place(&own, &[0, 1])), (Ok(None), Ok(Some(1..3))));
        assert_eq!((end.index_range(100), sharding("start").index_range(100)), (64..100, 0..36));
        assert_eq!(end.index_range(9), 0..9);
        let wild = index(entry(u64::MAX - 1, 2), entry(0, 0));
        assert_eq!(end.place(&wild, &[0, 0]), Err(BEYOND));
        assert!(end.place(&own[1..], &[0, 0]).is_err() && end.place(&[], &[0, 0]).is_err());
        assert!(Sharding::new(&[3, 4], &[2, 2], "end", false, &[]).is_err());
        assert!(Sharding::new(&[0, 4], &[2, 2], "end", false, &[]).is_err());
        assert!(Sharding::new(&[4, 4], &[2, 2], "end", false, &[Codec::Gzip]).is_err());
    }
}
