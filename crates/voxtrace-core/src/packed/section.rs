//! One flat array of a packed scene: owned, or a part of a native file's bytes.

#![expect(unsafe_code, reason = "rays read records all the time: where those lie is found once")]

use super::bytes::Bytes;
use bytemuck::Pod;
use std::ops::Deref;
use std::ptr::NonNull;
use std::sync::Arc;

/// An immutable array of plain records that is either owned or lies in the bytes of a native file.
#[derive(Clone)]
pub struct Section<T: Pod> {
    /// The records, within what `storage` holds.
    records: NonNull<[T]>,
    storage: Storage<T>,
}

#[derive(Clone)]
enum Storage<T> {
    Owned(Arc<[T]>),
    /// The records begin at byte `start`.
    Shared {
        bytes: Arc<Bytes>,
        start: usize,
    },
}

// SAFETY: it is a shared array of plain records: they are written by `as_mut` and `set_length` alone, where nobody else holds the storage.
unsafe impl<T: Pod + Send + Sync> Send for Section<T> {}
// SAFETY: as above.
unsafe impl<T: Pod + Send + Sync> Sync for Section<T> {}

impl<T: Pod> Section<T> {
    /// The records `bytes[start..end]`, or `None` if the range is out of bounds, misaligned or no whole number of
    /// records.
    pub(super) fn from_shared(bytes: Arc<Bytes>, start: usize, end: usize) -> Option<Self> {
        let records = bytemuck::try_cast_slice::<u8, T>(bytes.get(start..end)?).ok()?;
        Some(Self { records: records.into(), storage: Storage::Shared { bytes, start } })
    }

    fn owned(records: Arc<[T]>) -> Self {
        Self { records: (&*records).into(), storage: Storage::Owned(records) }
    }

    /// The records, to be written. They are copied first where somebody else has them too, or a file.
    pub(crate) fn as_mut(&mut self) -> &mut [T] {
        if !self.is_writable() {
            *self = self.with_room(self.len());
        }
        let length = self.len();
        self.find(length);
        // SAFETY: nobody else holds the storage, and this borrow holds the section.
        unsafe { self.records.as_mut() }
    }

    /// Makes it as long as said, with zeros where it grows. Room for more is kept, so that growing word by word copies little.
    pub(crate) fn set_length(&mut self, length: usize) {
        let has_room = match &self.storage {
            Storage::Shared { bytes, start } => self.is_writable() && (bytes.len() - start) / size_of::<T>() >= length,
            Storage::Owned(_) => false,
        };
        if !has_room {
            *self = self.with_room(length + length / 8);
        }
        if let Storage::Owned(records) = &self.storage {
            let mut longer = records.to_vec();
            longer.resize(length, T::zeroed());
            *self = Self::owned(longer.into());
        }
        self.find(length);
    }

    /// Finds so many records anew, to be written: nobody else may hold the storage.
    fn find(&mut self, length: usize) {
        let records = match &mut self.storage {
            Storage::Shared { bytes, start } => {
                let bytes = Arc::get_mut(bytes).and_then(Bytes::as_mut).expect("it is writable");
                bytemuck::cast_slice_mut(&mut bytes[*start..*start + length * size_of::<T>()])
            }
            Storage::Owned(records) => &mut Arc::get_mut(records).expect("it is writable")[..length],
        };
        self.records = records.into();
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
        let copy = Bytes::zeroed(room as u64).ok().and_then(|mut bytes| {
            bytes.as_mut()?[..size].copy_from_slice(bytemuck::cast_slice(self));
            Self::from_shared(Arc::new(bytes), 0, size)
        });
        copy.unwrap_or_else(|| Self::owned(self.to_vec().into()))
    }

    /// Bytes of it that lie in a mapped file, which the system brings and drops.
    pub(super) fn mapped_bytes(&self) -> u64 {
        match &self.storage {
            Storage::Shared { bytes, .. } if matches!(**bytes, Bytes::Mapped(_)) => self.size_bytes(),
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
        let shared = Bytes::copy_of(bytes).ok().and_then(|copy| Self::from_shared(Arc::new(copy), 0, bytes.len()));
        shared.unwrap_or_else(|| Self::owned(records.into()))
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
        // SAFETY: the range and the alignment were checked when they were found, and the storage, which is held, stays where it is.
        unsafe { self.records.as_ref() }
    }
}

impl<T: Pod + std::fmt::Debug> std::fmt::Debug for Section<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "[{} records, {} bytes]", self.len(), self.size_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_copies_keep_what_they_had() {
        let words: Vec<u32> = (0..100).collect();
        for mut section in [words.clone().into(), Section::owned(words.into())] {
            let copy = section.clone();
            section.as_mut()[3] = 99;
            let read = section.as_mut().len();
            section.as_mut()[4] = 98;
            assert_eq!((&section[2..6], read, &copy[2..6]), (&[2, 99, 98, 5][..], 100, &[2, 3, 4, 5][..]));
            section.set_length(300);
            section.as_mut()[299] = 97;
            assert_eq!((section[3], section[98], section[299], section.len()), (99, 98, 97, 300));
            assert!(section[100..299].iter().all(|&word| word == 0));
            let longer = section.clone();
            section.set_length(4);
            assert_eq!((&*section, longer.len(), copy.len()), (&[0, 1, 2, 99][..], 300, 100));
        }
    }
}
