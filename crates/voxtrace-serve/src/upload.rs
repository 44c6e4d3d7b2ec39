//! Files that people drop on the page: read by the library, and written into the folder as a `.vxt` file, whole or not at all, and over no other file unless
//! that was asked for.

use crate::places::{Place, format_of};
use crate::refusal::Refusal;
use crate::scenes::{read_file, while_waited_for};
use crate::server::App;
use axum::body::{Body, HttpBody};
use axum::http::StatusCode;
use futures_util::StreamExt;
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tempfile::{TempDir, TempPath};
use tokio::io::AsyncWriteExt;
use voxtrace::import::ImportOptions;

/// How the names of folders begin that uploads are in meanwhile.
pub const HIDDEN: &str = ".voxtrace-upload-";
/// Bytes in a second that a client must send, in the mean, once it had some time.
const SLOWEST: u64 = 16 << 10;

/// What became of a file.
#[derive(Debug, Serialize)]
pub struct Uploaded {
    /// The file that was written, below the folder that is served.
    pub name: String,
    pub notes: Vec<String>,
}

/// Takes the bytes of a file and writes the scene in it.
pub async fn take(app: &App, name: &str, replace: bool, body: Body) -> Result<Uploaded, Refusal> {
    let limits = &app.settings.limits;
    if limits.upload == 0 {
        return Err(Refusal::new(StatusCode::FORBIDDEN, "this server takes no files"));
    }
    let (folder, file_name) = app.root.find_new(name)?;
    if format_of(Path::new(&file_name)).is_none() {
        let line = format!("{file_name}: no format that is read has this extension");
        return Err(Refusal::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, line));
    }
    let too_large = || {
        let line = format!("{file_name}: it is larger than the {} bytes that this server takes", limits.upload);
        Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, line)
    };
    // Programs that ask before they send need not send it.
    if body.size_hint().lower() > limits.upload {
        return Err(too_large());
    }
    let _turn = app.uploads.try_acquire().map_err(|_| Refusal::busy("other files are being uploaded"))?;
    // In the folder itself, so that the file is renamed in the end, not copied; hidden meanwhile, and removed whatever happens.
    let hidden = tempfile::Builder::new().prefix(HIDDEN).tempdir_in(&folder.path);
    let hidden = hidden.map_err(|error| cannot_write(&file_name, &error))?;
    // With its own name, which scenes are called by.
    let received = hidden.path().join(&file_name);
    receive(app, body, &received, &file_name, &too_large).await?;
    let upload = Upload { hidden, received, file_name, folder, replace, options: app.scenes.options().clone() };
    while_waited_for(move |wanted| upload.convert(&wanted)).await?
}

/// Writes the body of a request to a file.
async fn receive(
    app: &App,
    body: Body,
    path: &Path,
    name: &str,
    too_large: &(dyn Fn() -> Refusal + Sync),
) -> Result<(), Refusal> {
    let limits = &app.settings.limits;
    let failed = |error: io::Error| cannot_write(name, &error);
    let mut file = tokio::fs::File::create(path).await.map_err(failed)?;
    let (mut received, start) = (0, Instant::now());
    let mut parts = body.into_data_stream();
    loop {
        let part = tokio::time::timeout(limits.body, parts.next()).await;
        let too_slow = || Refusal::new(StatusCode::REQUEST_TIMEOUT, format!("{name}: nothing more of it came"));
        let Some(part) = part.map_err(|_| too_slow())? else { break };
        let part = part.map_err(|_| Refusal::new(StatusCode::BAD_REQUEST, format!("{name}: it came in part only")))?;
        received += part.len() as u64;
        if received > limits.upload {
            return Err(too_large());
        }
        let granted = limits.body.as_secs_f64();
        if (received as f64) < (start.elapsed().as_secs_f64() - granted) * SLOWEST as f64 {
            return Err(too_slow());
        }
        file.write_all(&part).await.map_err(failed)?;
    }
    file.flush().await.map_err(failed)
}

/// A file that was received.
struct Upload {
    hidden: TempDir,
    received: PathBuf,
    file_name: String,
    folder: Place,
    replace: bool,
    options: ImportOptions,
}

impl Upload {
    fn convert(self, wanted: &Arc<AtomicBool>) -> Result<Uploaded, Refusal> {
        let name = format!("{}.vxt", stem(&self.file_name));
        let target = self.folder.path.join(&name);
        let is_there = || Refusal::new(StatusCode::CONFLICT, format!("{name} is there already"));
        // Before a long conversion; what comes meanwhile is seen in the end.
        if !self.replace && target.symlink_metadata().is_ok() {
            return Err(is_there());
        }
        let opened = read_file(&self.received, &self.file_name, &self.options, Arc::clone(wanted))?;
        let written = self.hidden.path().join(".written.vxt");
        opened.scene.save(&written).map_err(|error| {
            Refusal::new(StatusCode::INSUFFICIENT_STORAGE, format!("{name} cannot be written: {}", error.kind))
        })?;
        if !wanted.load(Ordering::Relaxed) {
            return Err(Refusal::failed("nobody waits for it any more"));
        }
        let written = TempPath::try_from_path(written).map_err(|error| cannot_write(&name, &error))?;
        let put = match self.replace {
            true => written.persist(&target),
            false => written.persist_noclobber(&target),
        };
        put.map_err(|error| match error.error.kind() {
            io::ErrorKind::AlreadyExists => is_there(),
            _ => cannot_write(&name, &error.error),
        })?;
        let name = if self.folder.name.is_empty() { name } else { format!("{}/{name}", self.folder.name) };
        Ok(Uploaded { name, notes: opened.notes.clone() })
    }
}

/// A file's name without the extension of its format.
fn stem(name: &str) -> &str {
    let packed = [".gz", ".zip"].iter().find_map(|extension| {
        let (stem, found) = name.split_at_checked(name.len().checked_sub(extension.len())?)?;
        found.eq_ignore_ascii_case(extension).then_some(stem)
    });
    let name = packed.filter(|name| name.contains('.')).unwrap_or(name);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

fn cannot_write(name: &str, error: &io::Error) -> Refusal {
    let status = match error.kind() {
        io::ErrorKind::StorageFull => StatusCode::INSUFFICIENT_STORAGE,
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => StatusCode::FORBIDDEN,
        _ => StatusCode::INTERNAL_SERVER_ERROR,
    };
    Refusal::new(status, format!("{name} cannot be written: {}", error.kind()))
}

#[cfg(test)]
mod tests {
    use super::stem;

    #[test]
    fn the_extension_goes_and_the_name_stays() {
        let cases = [
            ("a.vox", "a"),
            ("a.b.obj", "a.b"),
            ("scan.nii.gz", "scan"),
            ("x.zarr.zip", "x"),
            ("x.zip", "x"),
            ("S.NII.GZ", "S"),
            ("ü", "ü"),
        ];
        for (name, expected) in cases {
            assert_eq!(stem(name), expected);
        }
    }
}
