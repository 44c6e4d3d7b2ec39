//! The bytes of a native file: mapped, or read into memory of our own. Where they lie, and how many there are, is fixed when they
//! are made. Nobody else's code is asked for them again, so that what was validated is what is traced.

use std::fs::File;
use std::io::{self, Read};

/// Bytes that nothing changes while they are held. The first one is aligned to 64, as the sections of a file are.
pub(super) enum Bytes {
    /// A file.
    Mapped(memmap2::Mmap),
    /// Memory of our own, in large pages where the system has any.
    #[cfg(target_os = "linux")]
    LargePages(memmap2::MmapMut),
    /// The same where that would fill none: whole blocks, and how many bytes of them count.
    Owned(Box<[Block]>, usize),
}

/// How bytes are read. It decides how much around a page that is missing the system reads with it, which may be megabytes: where a file is larger than
/// memory that is the time of all rays that come to it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Access {
    /// Once, one after the other.
    FromStartToEnd,
    /// At a few places at a time that go from start to end.
    InOrder,
    /// As rays do.
    HereAndThere,
}

/// As many bytes as sections are aligned to.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
pub(super) struct Block([u8; 64]);

/// Bytes of a large page on most processors.
#[cfg(target_os = "linux")]
const LARGE_PAGE: usize = 2 << 20;

impl Bytes {
    /// Maps a file.
    #[expect(unsafe_code, reason = "mapping is the point of the format")]
    pub fn map(file: &File) -> io::Result<Self> {
        // SAFETY: the map is read-only and private to us. That nobody writes into the file meanwhile is the documented
        // duty of the caller, as for every memory-mapped file; `save` replaces files, it never writes into them. Who cannot
        // vouch for it reads the file into memory.
        unsafe { memmap2::Mmap::map(file) }.map(Self::Mapped)
    }

    /// Tells the system how a mapped file is read from now on. What it makes of it changes no byte.
    pub fn expect(&self, access: Access) {
        #[cfg(unix)]
        if let Self::Mapped(map) = self {
            let advice = match access {
                Access::FromStartToEnd => memmap2::Advice::Sequential,
                Access::InOrder => memmap2::Advice::Normal,
                Access::HereAndThere => memmap2::Advice::Random,
            };
            // Without it reading is only slower.
            let _ = map.advise(advice);
        }
        #[cfg(not(unix))]
        let _ = access;
    }

    /// Reads a file of so many bytes into memory.
    pub fn read(file: &mut impl Read, length: u64) -> io::Result<Self> {
        let mut bytes = Self::zeroed(length)?;
        file.read_exact(bytes.as_mut().unwrap_or_default())?;
        Ok(bytes)
    }

    /// A copy.
    pub fn copy_of(bytes: &[u8]) -> io::Result<Self> {
        Self::read(&mut &*bytes, bytes.len() as u64)
    }

    /// Whether they may be written while nobody else holds them.
    pub fn is_writable(&self) -> bool {
        match self {
            Self::Mapped(_) => false,
            #[cfg(target_os = "linux")]
            Self::LargePages(_) => true,
            Self::Owned(..) => true,
        }
    }

    /// The bytes, to be written; `None` where they may not.
    pub fn as_mut(&mut self) -> Option<&mut [u8]> {
        match self {
            Self::Mapped(_) => None,
            #[cfg(target_os = "linux")]
            Self::LargePages(map) => Some(map),
            Self::Owned(blocks, length) => Some(&mut bytemuck::cast_slice_mut(blocks)[..*length]),
        }
    }

    /// Zeros that may be written, in large pages where they would fill any: arrays that rays read here and there otherwise wait for the tables of
    /// small ones.
    pub fn zeroed(length: u64) -> io::Result<Self> {
        let too_large = || io::Error::new(io::ErrorKind::OutOfMemory, format!("no memory for {length} bytes"));
        let count = usize::try_from(length).map_err(|_| too_large())?;
        #[cfg(target_os = "linux")]
        if count >= LARGE_PAGE {
            let map = memmap2::MmapMut::map_anon(count).map_err(|_| too_large())?;
            // Where the system refuses, these are small pages.
            let _ = map.advise(memmap2::Advice::HugePage);
            return Ok(Self::LargePages(map));
        }
        let blocks = bytemuck::allocation::try_zeroed_slice_box(count.div_ceil(size_of::<Block>()));
        Ok(Self::Owned(blocks.map_err(|()| too_large())?, count))
    }
}

impl std::ops::Deref for Bytes {
    type Target = [u8];

    #[inline]
    fn deref(&self) -> &[u8] {
        match self {
            Self::Mapped(map) => map,
            #[cfg(target_os = "linux")]
            Self::LargePages(map) => map,
            Self::Owned(blocks, length) => &bytemuck::cast_slice(blocks)[..*length],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::Section;
    use std::sync::Arc;

    #[test]
    fn bytes_are_aligned_as_sections_are_and_stay_where_they_are() {
        for length in [0, 1, 63, 64, 65, 1000] {
            let source: Vec<u8> = (0..length).map(|i| i as u8).collect();
            let bytes = Bytes::copy_of(&source).unwrap();
            assert_eq!(&*bytes, source);
            assert!(bytes.as_ptr().cast::<Block>().is_aligned());
            assert_eq!(bytes.as_ptr(), bytes.as_ptr());
        }
        let source: Vec<u8> = (0..3_000_001).map(|i| (i * 7 % 251) as u8).collect();
        let large = Bytes::copy_of(&source).unwrap();
        assert!(*large == *source && large.as_ptr().cast::<Block>().is_aligned());
    }

    #[test]
    fn a_file_that_is_shorter_than_announced_or_larger_than_memory_is_an_error() {
        let short = Bytes::read(&mut &[1, 2, 3][..], 4).map(|_| ()).unwrap_err();
        assert_eq!(short.kind(), io::ErrorKind::UnexpectedEof);
        for length in [u64::MAX, u64::MAX - 63, 1 << 63] {
            let large = Bytes::read(&mut &[1, 2, 3][..], length).map(|_| ()).unwrap_err();
            assert_eq!(large.kind(), io::ErrorKind::OutOfMemory, "{length}");
        }
    }

    #[test]
    fn sections_are_whole_aligned_records_within_the_bytes() {
        let words: Vec<u32> = (0..100).collect();
        let bytes = Arc::new(Bytes::copy_of(bytemuck::cast_slice(&words)).unwrap());
        let section = |start, end| Section::<u64>::from_shared(Arc::clone(&bytes), start, end);
        let found = section(8, 24).unwrap();
        assert_eq!(*found, [2 | 3 << 32, 4 | 5 << 32]);
        let copy = found.clone();
        drop(found);
        assert_eq!(copy.as_ptr().cast(), bytes[8..].as_ptr());
        for (start, end) in [(4, 20), (8, 20), (8, 408), (16, 8), (usize::MAX, 0)] {
            assert!(section(start, end).is_none(), "{start}..{end}");
        }
        assert!(section(400, 400).unwrap().is_empty());
    }
}
