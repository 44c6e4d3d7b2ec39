//! Reading the bytes of a film file one number after the other.

use super::FilmFileError;
use glam::Vec3;

/// Bytes not yet read.
pub struct Input<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
}

impl Input<'_> {
    pub fn damaged(&self, what: &'static str) -> FilmFileError {
        FilmFileError::Damaged { what, offset: self.at as u64 }
    }

    pub fn take(&mut self, count: usize) -> Result<&[u8], FilmFileError> {
        let end = self.at.checked_add(count).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.damaged("the file ends early"))?;
        let taken = &self.bytes[self.at..end];
        self.at = end;
        Ok(taken)
    }

    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], FilmFileError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    pub fn u32(&mut self) -> Result<u32, FilmFileError> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    pub fn u64(&mut self) -> Result<u64, FilmFileError> {
        Ok(u64::from_le_bytes(self.array()?))
    }

    pub fn f32(&mut self) -> Result<f32, FilmFileError> {
        Ok(f32::from_le_bytes(self.array()?))
    }

    pub fn vec3(&mut self) -> Result<Vec3, FilmFileError> {
        Ok(Vec3::new(self.f32()?, self.f32()?, self.f32()?))
    }

    pub fn flag(&mut self) -> Result<bool, FilmFileError> {
        Ok(self.u32()? != 0)
    }

    pub fn text(&mut self) -> Result<String, FilmFileError> {
        let length = self.u32()? as usize;
        let bytes = self.take(length)?.to_vec();
        String::from_utf8(bytes).map_err(|_| self.damaged("a name is not UTF-8"))
    }
}
