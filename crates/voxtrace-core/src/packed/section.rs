//! One flat array of a packed scene: owned, or a part of a native file's bytes.

use super::bytes::Bytes;
use bytemuck::Pod;
use std::ops::Deref;
use std::sync::Arc;

/// An immutable array of plain records that is either owned or lies in the bytes of a native file.
#[derive(Clone)]
pub struct Section<T: Pod> {
    storage: Storage<T>,
}

#[derive(Clone)]
enum Storage<T> {
    Owned(Arc<[T]>),
    Shared { bytes: Arc<Bytes>, start: usize, end: usize },
}

impl<T: Pod> Section<T> {
    /// The records `bytes[start..end]`, or `None` if the range is out of bounds, misaligned or no whole number of
    /// records.
    pub(super) fn from_shared(bytes: Arc<Bytes>, start: usize, end: usize) -> Option<Self> {
        let part = bytes.get(start..end)?;
        bytemuck::try_cast_slice::<u8, T>(part).ok()?;
        Some(Self { storage: Storage::Shared { bytes, start, end } })
    }

    /// The records, to be written. They are copied first where somebody else has them too, or a file.
    pub(crate) fn as_mut(&mut self) -> &mut [T] {
        if !self.is_writable() {
            *self = self.with_room(self.len());
        }
        match &mut self.storage {
            Storage::Shared { bytes, start, end } => {
                let bytes = Arc::get_mut(bytes).and_then(Bytes::as_mut).expect("made writable above");
                bytemuck::cast_slice_mut(&mut bytes[*start..*end])
            }
            Storage::Owned(records) => Arc::get_mut(records).expect("made writable above"),
        }
    }

    /// Makes it as long as said, with zeros where it grows. Room for more is kept, so that growing word by word copies little.
    pub(crate) fn set_length(&mut self, length: usize) {
        let has_room = match &self.storage {
            Storage::Shared { bytes, start, .. } => {
                self.is_writable() && (bytes.len() - start) / size_of::<T>() >= length
            }
            Storage::Owned(_) => false,
        };
        if !has_room {
            *self = self.with_room(length + length / 8);
        }
        match &mut self.storage {
            Storage::Shared { start, end, .. } => *end = *start + length * size_of::<T>(),
            Storage::Owned(records) => {
                let mut longer = records.to_vec();
                longer.resize(length, T::zeroed());
                *records = longer.into();
            }
        }
    }

    /// Whether it can be written as it is.
    fn is_writable(&self) -> bool {
        match &self.storage {
            Storage::Shared { bytes, .. } => Arc::strong_count(bytes) == 1 && bytes.is_writable(),
            Storage::Owned(records) => Arc::strong_count(records) == 1,
        }
    }

    /// A copy that can be written, with room for so many records.
    fn with_room(&self, count: usize) -> Self {
        let size = size_of_val(&**self);
        let room = size.max(count * size_of::<T>()).next_multiple_of(64);
        let copy = Bytes::writable(room).ok().and_then(|mut bytes| {
            bytes.as_mut()?[..size].copy_from_slice(bytemuck::cast_slice(self));
            Self::from_shared(Arc::new(bytes), 0, size)
        });
        copy.unwrap_or_else(|| Self { storage: Storage::Owned(self.to_vec().into()) })
    }

    /// Bytes of it that lie in a mapped file, which the system brings and drops.
    pub(super) fn mapped_bytes(&self) -> u64 {
        match &self.storage {
            Storage::Shared { bytes, start, end } if matches!(**bytes, Bytes::Mapped(_)) => (end - start) as u64,
            _ => 0,
        }
    }

    /// Size in bytes.
    pub fn size_bytes(&self) -> u64 {
        size_of_val(&**self) as u64
    }
}

impl<T: Pod> From<Vec<T>> for Section<T> {
    /// A copy, aligned as in a file, so that no record of 64 bytes lies in two lines of the cache.
    fn from(records: Vec<T>) -> Self {
        let bytes: &[u8] = bytemuck::cast_slice(&records);
        let copy = Bytes::in_large_pages(bytes).or_else(|| Bytes::copy_of(bytes).ok());
        let shared = copy.and_then(|copy| Self::from_shared(Arc::new(copy), 0, bytes.len()));
        shared.unwrap_or_else(|| Self { storage: Storage::Owned(records.into()) })
    }
}

impl<T: Pod> Default for Section<T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<T: Pod> Deref for Section<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match &self.storage {
            Storage::Owned(records) => records,
            // The range and the alignment were checked when the section was made, and the bytes stay where they are.
            Storage::Shared { bytes, start, end } => bytemuck::cast_slice(&bytes[*start..*end]),
        }
    }
}

impl<T: Pod + std::fmt::Debug> std::fmt::Debug for Section<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "[{} records, {} bytes]", self.len(), self.size_bytes())
    }
}
