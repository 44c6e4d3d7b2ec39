//! A place in the bytes of a file; what it takes is there, or the error says where the file ends.

use glam::IVec3;
use std::path::Path;
use voxtrace_voxelize::ImportError;

#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    pub at: usize,
    pub path: &'a Path,
}

impl<'a> Cursor<'a> {
    pub fn new(bytes: &'a [u8], path: &'a Path) -> Self {
        Self { bytes, at: 0, path }
    }

    /// Takes `count` bytes, which are part of `what`.
    pub fn take(&mut self, count: u64, what: &str) -> Result<&'a [u8], ImportError> {
        let rest = &self.bytes[self.at..];
        let taken = usize::try_from(count).ok().and_then(|count| rest.get(..count));
        let taken = taken.ok_or_else(|| ImportError::truncated(self.path, self.bytes.len() as u64, what))?;
        self.at += taken.len();
        Ok(taken)
    }

    pub fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], ImportError> {
        let bytes = self.take(N as u64, what)?;
        // As many as were asked for.
        Ok(*bytes.first_chunk().unwrap_or(&[0; N]))
    }

    pub fn u32(&mut self, what: &str) -> Result<u32, ImportError> {
        self.array(what).map(u32::from_le_bytes)
    }

    pub fn i64(&mut self, what: &str) -> Result<i64, ImportError> {
        self.array(what).map(i64::from_le_bytes)
    }

    pub fn f64(&mut self, what: &str) -> Result<f64, ImportError> {
        self.array(what).map(f64::from_le_bytes)
    }

    pub fn place(&mut self, what: &str) -> Result<IVec3, ImportError> {
        let mut place = [0; 3];
        for coordinate in &mut place {
            *coordinate = self.array(what).map(i32::from_le_bytes)?;
        }
        Ok(IVec3::from_array(place))
    }

    /// A text behind its length.
    pub fn text(&mut self, what: &str) -> Result<String, ImportError> {
        let length = self.u32(what)?;
        Ok(String::from_utf8_lossy(self.take(length.into(), what)?).into_owned())
    }

    /// Goes to a byte of the file.
    pub fn go(&mut self, to: i64) -> Result<(), ImportError> {
        let end = self.bytes.len();
        match usize::try_from(to) {
            Ok(to) if to <= end => self.at = to,
            Ok(_) => return Err(ImportError::truncated(self.path, end as u64, "a grid")),
            Err(_) => return Err(self.malformed("a grid at an impossible byte")),
        }
        Ok(())
    }

    pub fn malformed(&self, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.path, self.at as u64, what)
    }
}
