//! Typed reading of the dictionaries in a .vox file, whose numbers are decimal text.

use super::document::Dict;
use std::{path::Path, str::FromStr};
use voxtrace_voxelize::ImportError;

/// A dictionary and where it stands, for errors.
#[derive(Clone, Copy)]
pub struct Attributes<'d> {
    /// The dictionary.
    pub dict: &'d Dict<'d>,
    /// Name of the file.
    pub path: &'d Path,
    /// Byte offset of the chunk that holds it.
    pub offset: u64,
}

impl Attributes<'_> {
    /// Text, with what is not UTF-8 replaced.
    pub fn text(&self, key: &str) -> Option<String> {
        Some(String::from_utf8_lossy(self.dict.get(key)?).into_owned())
    }

    /// Whether the value is 1.
    pub fn flag(&self, key: &str) -> bool {
        self.dict.get(key) == Some(b"1")
    }

    /// One whole number.
    pub fn integer<T: FromStr>(&self, key: &str) -> Result<Option<T>, ImportError> {
        Ok(self.numbers::<T, 1>(key)?.map(|[number]| number))
    }

    /// `N` numbers between spaces, of a type that knows no infinity.
    pub fn numbers<T: FromStr, const N: usize>(&self, key: &str) -> Result<Option<[T; N]>, ImportError> {
        let Some(value) = self.dict.get(key) else { return Ok(None) };
        let parsed = str::from_utf8(value).ok().and_then(|text| {
            let numbers: Vec<T> = text.split_ascii_whitespace().map(|word| word.parse().ok()).collect::<Option<_>>()?;
            numbers.try_into().ok()
        });
        parsed.map(Some).ok_or_else(|| self.wrong(key, value))
    }

    /// One finite number.
    pub fn float(&self, key: &str) -> Result<Option<f64>, ImportError> {
        Ok(self.floats::<1>(key)?.map(|[number]| number))
    }

    /// `N` finite numbers between spaces.
    pub fn floats<const N: usize>(&self, key: &str) -> Result<Option<[f64; N]>, ImportError> {
        match self.numbers::<f64, N>(key)? {
            Some(numbers) if numbers.iter().any(|number| !number.is_finite()) => {
                Err(self.wrong(key, self.dict.get(key).unwrap_or_default()))
            }
            numbers => Ok(numbers),
        }
    }

    /// The error of a value that is not what it should be.
    pub fn wrong(&self, key: &str, value: &[u8]) -> ImportError {
        let value: String = String::from_utf8_lossy(value).chars().take(40).collect();
        ImportError::malformed(self.path, self.offset, format!("{key} is {value:?}"))
    }
}
