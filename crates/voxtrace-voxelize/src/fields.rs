//! Numbers and arrays one after the other, in bytes that begin with a magic word and end with a checksum: what one process has found
//! out and another one goes on with. Little-endian, as everything that `bytemuck` casts on the systems that are supported.

use bytemuck::Pod;
use xxhash_rust::xxh3::xxh3_64;

/// Bytes in the making.
pub(crate) struct FieldWriter(Vec<u8>);

impl FieldWriter {
    pub fn new(magic: &[u8; 8]) -> Self {
        Self(magic.to_vec())
    }

    pub fn value<T: Pod>(&mut self, value: T) {
        self.0.extend_from_slice(bytemuck::bytes_of(&value));
    }

    pub fn values<T: Pod>(&mut self, values: &[T]) {
        self.value(values.len() as u64);
        self.0.extend_from_slice(bytemuck::cast_slice(values));
    }

    /// The bytes, with their checksum.
    pub fn finish(mut self) -> Vec<u8> {
        let checksum = xxh3_64(&self.0);
        self.value(checksum);
        self.0
    }
}

/// Bytes whose checksum is right, from the front. Each of the methods is `None` where there are not as many.
pub(crate) struct FieldReader<'a>(&'a [u8]);

impl<'a> FieldReader<'a> {
    /// `None` where the bytes begin with another word, or are damaged.
    pub fn open(bytes: &'a [u8], magic: &[u8; 8]) -> Option<Self> {
        let (content, checksum) = bytes.split_last_chunk::<8>()?;
        let rest = content.strip_prefix(magic)?;
        (xxh3_64(content) == u64::from_le_bytes(*checksum)).then_some(Self(rest))
    }

    pub fn value<T: Pod>(&mut self) -> Option<T> {
        let (value, rest) = self.0.split_at_checked(size_of::<T>())?;
        self.0 = rest;
        Some(bytemuck::pod_read_unaligned(value))
    }

    pub fn values<T: Pod>(&mut self) -> Option<Vec<T>> {
        let count = usize::try_from(self.value::<u64>()?).ok()?;
        let (values, rest) = self.0.split_at_checked(count.checked_mul(size_of::<T>())?)?;
        self.0 = rest;
        Some(values.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_comes_back_and_damage_does_not() {
        let mut writer = FieldWriter::new(b"numbers\0");
        writer.value(7u64);
        writer.values(&[1.5f32, -0.0]);
        writer.value(3u8);
        let bytes = writer.finish();
        let mut reader = FieldReader::open(&bytes, b"numbers\0").unwrap();
        assert_eq!(
            (reader.value(), reader.values(), reader.value()),
            (Some(7u64), Some(vec![1.5f32, -0.0]), Some(3u8))
        );
        assert!(reader.value::<u8>().is_none());
        assert!(FieldReader::open(&bytes, b"letters\0").is_none());
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 4;
            assert!(FieldReader::open(&damaged, b"numbers\0").is_none(), "{at}");
            assert!(FieldReader::open(&bytes[..at], b"numbers\0").is_none(), "{at}");
        }
    }
}
