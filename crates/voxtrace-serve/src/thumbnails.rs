//! Small pictures of scenes: rendered when a client first sees the scene in its list, one after the other, and kept by what the file holds, so that a copy
//! or another name needs no other picture.

use crate::picture::Shown;
use crate::places::Place;
use crate::refusal::Refusal;
use crate::scenes::{For, Scenes, while_waited_for};
use axum::body::Bytes;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, SystemTime};
use tokio::sync::Semaphore;
use voxtrace::{CpuTracer, Frame, PackedScene, Picture, Progress, Tracer};
use xxhash_rust::xxh3::Xxh3;

/// Pixels of a thumbnail: twice what the page shows, for screens that are fine.
const SIZE: (u32, u32) = (480, 320);
const SAMPLES: u32 = 16;
const QUALITY: u8 = 85;
/// Changes when thumbnails would look different.
const VERSION: u64 = 1;
/// Clients that may wait for thumbnails.
const MOST_WAITING: usize = 64;
/// Bytes at the head and at the end of a file that tell what it holds; of a longer file also when it was written.
const TOLD_BY: u64 = 32 << 20;
/// Bytes of thumbnails that are kept between runs.
const MOST_KEPT: u64 = 256 << 20;

/// Thumbnails, and who waits for them.
pub struct Thumbnails {
    cache: Option<PathBuf>,
    turn: Semaphore,
    waiting: AtomicUsize,
}

impl Thumbnails {
    /// Keeps thumbnails below the folder `cache`.
    pub fn new(cache: Option<&Path>) -> Self {
        let cache = cache.map(|cache| cache.join("thumbnails"));
        if let Some(cache) = &cache {
            prune(cache);
        }
        Self { cache, turn: Semaphore::new(1), waiting: AtomicUsize::new(0) }
    }

    /// The thumbnail of a scene, a JPEG. Work on it ends when nobody waits for it any more.
    pub async fn of(&self, place: &Place, scenes: &Scenes) -> Result<Bytes, Refusal> {
        let _waiting = Waiting::new(&self.waiting)?;
        let of_file = place.clone();
        let key = while_waited_for(move |_| key_of(&of_file)).await?;
        let kept = key.ok().and_then(|key| Some(self.cache.as_ref()?.join(format!("{key:032x}.jpg"))));
        if let Some(bytes) = read_kept(kept.as_deref()).await {
            return Ok(bytes);
        }
        let _turn = self.turn.acquire().await.map_err(|_| Refusal::busy("the server stops"))?;
        // Those who waited for the same one find it made.
        if let Some(bytes) = read_kept(kept.as_deref()).await {
            return Ok(bytes);
        }
        let opened = scenes.open(place, For::Thumbnail).await?;
        let scene = Arc::clone(&opened.scene);
        drop(opened);
        let jpeg = while_waited_for(move |wanted| render(&scene, wanted)).await??;
        if let Some(kept) = kept {
            let bytes = jpeg.clone();
            let _ = while_waited_for(move |_| keep(&kept, &bytes)).await;
        }
        Ok(jpeg.into())
    }
}

/// A thumbnail that was kept.
async fn read_kept(path: Option<&Path>) -> Option<Bytes> {
    tokio::fs::read(path?).await.ok().map(Into::into)
}

/// One of those who wait.
struct Waiting<'a>(&'a AtomicUsize);

impl<'a> Waiting<'a> {
    fn new(count: &'a AtomicUsize) -> Result<Self, Refusal> {
        let waiting = Self(count);
        match count.fetch_add(1, Ordering::Relaxed) {
            before if before >= MOST_WAITING => Err(Refusal::busy("many thumbnails are waited for already")),
            _ => Ok(waiting),
        }
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

/// A hash of what a file holds; of a folder, of its files' names, lengths and times.
fn key_of(place: &Place) -> io::Result<u128> {
    let mut hash = Xxh3::with_seed(VERSION);
    let (length, written) = place.version();
    if place.metadata.is_dir() {
        let mut files: Vec<_> = fs::read_dir(&place.path)?.collect::<Result<_, _>>()?;
        files.sort_by_key(fs::DirEntry::file_name);
        for file in files {
            let metadata = file.metadata()?;
            hash.update(file.file_name().as_encoded_bytes());
            hash.update(&metadata.len().to_le_bytes());
            let age = metadata.modified()?.duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
            hash.update(&age.as_nanos().to_le_bytes());
        }
        return Ok(hash.digest128());
    }
    // The name tells the format of some files.
    hash.update(place.path.extension().unwrap_or_default().as_encoded_bytes());
    hash.update(&length.to_le_bytes());
    let mut file = File::open(&place.path)?;
    update(&mut hash, (&mut file).take(TOLD_BY))?;
    if length > 2 * TOLD_BY {
        hash.update(&written.to_le_bytes());
        file.seek(SeekFrom::End(-(TOLD_BY as i64)))?;
    }
    update(&mut hash, file.take(TOLD_BY))?;
    Ok(hash.digest128())
}

fn update(hash: &mut Xxh3, mut bytes: impl Read) -> io::Result<()> {
    let mut part = vec![0; 1 << 20];
    loop {
        match bytes.read(&mut part)? {
            0 => return Ok(()),
            count => hash.update(&part[..count]),
        }
    }
}

fn render(scene: &Arc<PackedScene>, wanted: Arc<AtomicBool>) -> Result<Vec<u8>, Refusal> {
    let failed = |error: &dyn std::fmt::Display| Refusal::failed(format!("no thumbnail: {error}"));
    let (width, height) = SIZE;
    let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.portrait(width as f32 / height as f32));
    let frame = Frame::new(camera, width, height).samples(SAMPLES);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene).map_err(|error| failed(&error))?;
    let progress = Progress::default();
    let picture = std::thread::scope(|scope| {
        let (done, is_done) = std::sync::mpsc::channel::<()>();
        let progress = &progress;
        scope.spawn(move || {
            // Until the picture is done, which hangs up.
            while is_done.recv_timeout(Duration::from_millis(50)) == Err(std::sync::mpsc::RecvTimeoutError::Timeout) {
                if !wanted.load(Ordering::Relaxed) {
                    progress.cancel();
                }
            }
        });
        let picture = Picture::trace(&mut tracer, scene, frame, true, progress);
        drop(done);
        picture
    });
    let picture = picture.map_err(|error| failed(&error))?.ok_or_else(|| failed(&"nobody waits for it"))?;
    let radiance = &picture.denoised().expect("its noise was removed").radiance;
    let shown = Shown::new(width, height, |index| radiance[index]);
    let mut jpeg = Vec::new();
    shown.append_jpeg(&mut jpeg, QUALITY).map_err(|error| failed(&error))?;
    Ok(jpeg)
}

/// Keeps a thumbnail; where that is not possible it is rendered again.
fn keep(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = path.parent().expect("a file in a folder");
    fs::create_dir_all(folder)?;
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    io::Write::write_all(&mut file, bytes)?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// Removes the oldest thumbnails beyond those that are kept.
fn prune(cache: &Path) {
    let files = fs::read_dir(cache).into_iter().flatten().flatten();
    let of_file = |file: fs::DirEntry| {
        let metadata = file.metadata().ok().filter(fs::Metadata::is_file)?;
        Some((metadata.modified().ok()?, metadata.len(), file.path()))
    };
    let mut files: Vec<_> = files.filter_map(of_file).collect();
    files.sort();
    let mut bytes: u64 = files.iter().map(|(_, length, _)| length).sum();
    for (_, length, path) in files {
        if bytes <= MOST_KEPT {
            break;
        }
        let _ = fs::remove_file(path);
        bytes -= length;
    }
}
