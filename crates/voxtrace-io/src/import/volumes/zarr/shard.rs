//! Shards: files that hold several chunks and an index of where each of them lies (zarr-specs, "Sharding codec", version 1.0).

use super::Store;
use super::codec::Codec;
use super::metadata::{Array, Fault};
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex};
use voxtrace_voxelize::ImportError;

/// Offset and length of a chunk that is not there.
const ABSENT: u64 = u64::MAX;
/// Bytes of an entry of the index, and of the checksum behind it.
const ENTRY: usize = 16;
const CHECKSUM: usize = 4;

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

    /// The chunk with the number `at` along each axis of its shard; `None` where it is not there.
    fn chunk(&self, shard: &[u8], at: &[u64]) -> Result<Option<Vec<u8>>, &'static str> {
        const BROKEN: &str = "a shard whose index does not fit";
        let count = self.chunks.iter().try_fold(1usize, |count, &chunks| count.checked_mul(chunks.try_into().ok()?));
        let checksum = if self.has_checksum { CHECKSUM } else { 0 };
        let size = count.and_then(|count| count.checked_mul(ENTRY)?.checked_add(checksum)).ok_or(BROKEN)?;
        let start = if self.index_at_start { 0 } else { shard.len().checked_sub(size).ok_or(BROKEN)? };
        let index = shard.get(start..start + size).ok_or(BROKEN)?;
        let number = at.iter().zip(&self.chunks).fold(0, |number, (at, chunks)| number * chunks + at) as usize;
        let word = |at: usize| {
            let bytes = index.get(at..).and_then(|rest| rest.first_chunk()).ok_or(BROKEN)?;
            Ok(if self.big_endian { u64::from_be_bytes(*bytes) } else { u64::from_le_bytes(*bytes) })
        };
        let (offset, length) = (word(number * ENTRY)?, word(number * ENTRY + 8)?);
        if (offset, length) == (ABSENT, ABSENT) {
            return Ok(None);
        }
        let range = usize::try_from(offset).ok().zip(offset.checked_add(length).and_then(|end| end.try_into().ok()));
        let chunk = range.and_then(|(start, end)| shard.get(start..end));
        chunk.map(|chunk| Some(chunk.to_vec())).ok_or("a chunk beyond its shard")
    }
}

/// The files of an array's chunks; shards are kept until others are wanted.
pub(super) struct Files<'a> {
    store: &'a Store<'a>,
    array: &'a Array,
    shards: Mutex<FxHashMap<String, Option<Arc<Vec<u8>>>>>,
}

impl<'a> Files<'a> {
    pub fn new(store: &'a Store<'a>, array: &'a Array) -> Self {
        Self { store, array, shards: Mutex::default() }
    }

    /// Lets go of the shards that were read.
    pub fn forget(&self) {
        if let Ok(mut shards) = self.shards.lock() {
            shards.clear();
        }
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
        let Some(shard) = self.shard(&name)? else { return Ok((None, name)) };
        let chunk = sharding.chunk(&shard, &in_shard).map_err(|what| self.store.malformed(&name, what))?;
        Ok((chunk, name))
    }

    fn shard(&self, name: &str) -> Result<Option<Arc<Vec<u8>>>, ImportError> {
        // Whoever wants the same shard waits for it.
        let Ok(mut shards) = self.shards.lock() else { return Ok(self.store.get(name)?.map(Arc::new)) };
        if let Some(shard) = shards.get(name) {
            return Ok(shard.clone());
        }
        let shard = self.store.get(name)?.map(Arc::new);
        shards.insert(name.to_owned(), shard.clone());
        Ok(shard)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sharding(location: &str) -> Sharding {
        Sharding::new(&[2, 4], &[2, 2], location, false, &[Codec::Checksum]).ok().unwrap()
    }

    #[test]
    fn chunks_are_found_by_the_index_at_either_end_and_nothing_beyond_the_shard() {
        let entry = |offset: u64, length: u64| [offset.to_le_bytes(), length.to_le_bytes()].concat();
        let index = |a: Vec<u8>, b: Vec<u8>| [a, b, vec![0; 4]].concat();
        let data = [7u8, 8, 9];
        let end = [&data[..], &index(entry(ABSENT, ABSENT), entry(1, 2))].concat();
        assert_eq!(sharding("end").chunk(&end, &[0, 0]), Ok(None));
        assert_eq!(sharding("end").chunk(&end, &[0, 1]), Ok(Some(vec![8, 9])));
        let start = [&index(entry(36, 3), entry(39, 1))[..], &data].concat();
        assert_eq!(sharding("start").chunk(&start, &[0, 0]), Ok(Some(data.to_vec())));
        assert_eq!(sharding("start").chunk(&start, &[0, 1]), Err("a chunk beyond its shard"));
        let wild = [&data[..], &index(entry(u64::MAX - 1, 2), entry(0, 0))].concat();
        assert!(sharding("end").chunk(&wild, &[0, 0]).is_err() && sharding("end").chunk(&data, &[0, 0]).is_err());
        assert!(Sharding::new(&[3, 4], &[2, 2], "end", false, &[]).is_err());
        assert!(Sharding::new(&[0, 4], &[2, 2], "end", false, &[]).is_err());
        assert!(Sharding::new(&[4, 4], &[2, 2], "end", false, &[Codec::Gzip]).is_err());
    }
}
