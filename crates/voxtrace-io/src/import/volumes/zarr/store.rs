//! Where the files of an array lie: in a folder, or in a ZIP archive. Nothing outside of it is read.

use super::MARKS;
use crate::import::source::archive::Archive;
use crate::import::source::folder::{Folder, Refused};
use serde_json::Value;
use std::io::{ErrorKind, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Files that are asked for by name.
pub(in crate::import::volumes) struct Store {
    pub path: PathBuf,
    files: Files,
}

enum Files {
    Folder(Folder),
    /// An archive, and the folder in it that is the store.
    Archive(Archive, String),
}

impl Store {
    /// A folder.
    pub fn at(path: &Path, limits: &Limits) -> Self {
        Self { path: path.into(), files: Files::Folder(Folder::at(path, limits)) }
    }

    /// An archive, whose outermost folder with a file of metadata is the store.
    pub fn of_archive(archive: Archive) -> Result<Self, ImportError> {
        let names = archive.names();
        let roots = names.iter().filter_map(|name| {
            let (folder, file) = name.rsplit_once('/').map_or(("", name.as_str()), |(folder, file)| (folder, file));
            MARKS.contains(&file).then_some(folder)
        });
        let root = roots.min_by_key(|folder| (folder.len(), *folder)).map(str::to_owned);
        let Some(root) = root else {
            let kind = ImportErrorKind::Unsupported("an archive that holds no Zarr".into());
            return Err(ImportError::at(archive.path(), 0, kind));
        };
        let root = if root.is_empty() { root } else { root + "/" };
        Ok(Self { path: archive.path().into(), files: Files::Archive(archive, root) })
    }

    /// The bytes of a file, `None` where there is none.
    pub fn get(&self, name: &str) -> Result<Option<Vec<u8>>, ImportError> {
        match &self.files {
            Files::Folder(folder) => self.there(folder.read(name)),
            Files::Archive(archive, root) => archive.get(&format!("{root}{name}")),
        }
    }

    /// Some bytes of a file, of whose length `range` makes a range; `None` where there is no such file. Less than asked for where it ends.
    pub fn part(&self, name: &str, range: impl Fn(u64) -> Range<u64>) -> Result<Option<Vec<u8>>, ImportError> {
        let Files::Folder(folder) = &self.files else {
            let bytes = self.get(name)?;
            return Ok(bytes.map(|bytes| {
                let Range { start, end } = range(bytes.len() as u64);
                let place = |at: u64| usize::try_from(at).unwrap_or(usize::MAX).min(bytes.len());
                bytes[place(start).min(place(end))..place(end)].to_vec()
            }));
        };
        let Some((mut file, _)) = self.there(folder.open(name))? else { return Ok(None) };
        let read = || {
            let Range { start, end } = range(file.metadata()?.len());
            file.seek(SeekFrom::Start(start))?;
            let mut bytes = Vec::new();
            file.take(end.saturating_sub(start)).read_to_end(&mut bytes)?;
            Ok(Some(bytes))
        };
        let read: std::io::Result<_> = { read }();
        read.map_err(|error| ImportError::io(&self.path.join(name), error))
    }

    fn there<T>(&self, found: Result<T, Refused>) -> Result<Option<T>, ImportError> {
        match found {
            Ok(found) => Ok(Some(found)),
            Err(Refused::Io { error, .. }) if is_absent(error.kind()) => Ok(None),
            Err(Refused::Io { name, error }) => Err(ImportError::io(&self.path.join(name), error)),
            Err(refused) => Err(self.malformed("", &refused.to_string())),
        }
    }

    /// A file of JSON, `None` where there is none.
    pub fn json(&self, name: &str) -> Result<Option<Value>, ImportError> {
        let Some(bytes) = self.get(name)? else { return Ok(None) };
        let read = serde_json::from_slice(&bytes);
        match read.or_else(|error| serde_json::from_slice(&without_numbers_of_python(&bytes)).map_err(|_| error)) {
            Ok(value) => Ok(Some(value)),
            Err(error) => Err(self.malformed(name, &error.to_string())),
        }
    }

    pub fn malformed(&self, name: &str, what: &str) -> ImportError {
        ImportError::malformed(&self.path.join(name), 0, what)
    }

    pub fn unsupported(&self, name: &str, what: String) -> ImportError {
        ImportError::at(&self.path.join(name), 0, ImportErrorKind::Unsupported(what))
    }
}

/// JSON with texts for `NaN` and `Infinity`, which are none, but which Python writes.
fn without_numbers_of_python(json: &[u8]) -> Vec<u8> {
    let (mut found, mut rest, mut is_text) = (Vec::with_capacity(json.len()), json, false);
    while let [first, after @ ..] = rest {
        let words: [&[u8]; 3] = [b"NaN", b"Infinity", b"-Infinity"];
        if let Some(word) = words.into_iter().find(|word| rest.starts_with(word)).filter(|_| !is_text) {
            found.extend([b"\"", word, b"\""].concat());
            rest = &rest[word.len()..];
            continue;
        }
        // What stands behind a backslash ends no text.
        let taken = if is_text && *first == b'\\' { rest.len().min(2) } else { 1 };
        is_text ^= *first == b'"';
        found.extend(&rest[..taken]);
        rest = &after[taken - 1..];
    }
    found
}

fn is_absent(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_python_writes_into_json_are_texts() {
        let found = without_numbers_of_python(br#"{"a": NaN, "b\"NaN": [-Infinity, Infinity, -1], "c": "NaN\\"}"#);
        assert_eq!(found, br#"{"a": "NaN", "b\"NaN": ["-Infinity", "Infinity", -1], "c": "NaN\\"}"#);
        assert_eq!(without_numbers_of_python(b"\"\\"), b"\"\\");
    }
}
