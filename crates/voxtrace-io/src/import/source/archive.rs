//! Files in a ZIP archive (PKWARE, "APPNOTE.TXT"), by the crate `zip`: asked for by name, each unpacked as a whole, stored or deflated.

use super::guard::guarded;
use super::input::{Input, ReadSeek};
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use voxtrace_voxelize::{ImportError, Limits};
use zip::ZipArchive;
use zip::result::ZipError;

/// Most bytes that Deflate makes of one, with room for the shortest files.
const RATIO: u64 = 1_100;

/// An archive whose files are read one by one.
pub(crate) struct Archive {
    path: PathBuf,
    zip: Mutex<ZipArchive<BufReader<Box<dyn ReadSeek>>>>,
    limit: u64,
}

impl Archive {
    /// Reads the list of an archive's files.
    pub fn open(input: Input, limits: &Limits) -> Result<Self, ImportError> {
        let path = input.path();
        let (stream, _) = input.seekable()?;
        let zip = guarded(|| ZipArchive::new(BufReader::new(stream)).map_err(|error| error.to_string()));
        let zip = zip.map_err(|what| ImportError::malformed(path, 0, format!("ZIP: {what}")))?;
        if zip.len() as u64 > limits.items {
            return Err(ImportError::limit(path, None, "files of the archive", zip.len() as u64, limits.items));
        }
        Ok(Self { path: path.into(), zip: Mutex::new(zip), limit: limits.bytes })
    }

    /// The archive's own name.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The names of all files.
    pub fn names(&self) -> Vec<String> {
        let names = |zip: &ZipArchive<_>| zip.file_names().filter_map(|name| Some(name.ok()?.into_owned())).collect();
        self.zip.lock().map_or_else(|_| Vec::new(), |zip| names(&zip))
    }

    /// How long a file says that it is, 0 where there is none.
    pub fn size(&self, name: &str) -> u64 {
        let mut zip = match self.zip.lock() {
            Ok(zip) => zip,
            Err(_) => return 0,
        };
        zip.by_name(name).map_or(0, |file| file.size())
    }

    /// The bytes of a file, `None` where there is none of that name.
    pub fn get(&self, name: &str) -> Result<Option<Vec<u8>>, ImportError> {
        let broken = |what: String| ImportError::malformed(&self.path.join(name), 0, format!("ZIP: {what}"));
        let mut zip = self.zip.lock().map_err(|_| broken("an earlier file was damaged".into()))?;
        let bytes = guarded(|| {
            let file = match zip.by_name(name) {
                Ok(file) => file,
                Err(ZipError::FileNotFound) => return Ok(None),
                Err(error) => return Err(error.to_string()),
            };
            let most = file.compressed_size().saturating_add(1).saturating_mul(RATIO).min(self.limit);
            let mut bytes = Vec::new();
            file.take(most.saturating_add(1)).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
            Ok(Some(bytes))
        });
        let bytes = bytes.map_err(broken)?;
        match &bytes {
            Some(all) if all.len() as u64 > self.limit => {
                let (path, count) = (self.path.join(name), all.len() as u64);
                Err(ImportError::limit(&path, None, "bytes of input", count, self.limit))
            }
            _ => Ok(bytes),
        }
    }
}
