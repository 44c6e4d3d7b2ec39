//! Small pictures of scenes: rendered when a client first sees the scene in its list, one after the other, and kept by what the file or the scene holds, so
//! that a copy needs no other picture.

use crate::kept::{Kept, Key};
use crate::picture::Shown;
use crate::places::Place;
use crate::refusal::Refusal;
use crate::scenes::{For, Scenes, while_waited_for};
use crate::sources;
use axum::body::Bytes;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;
use tokio::sync::Semaphore;
use voxtrace::import::ImportOptions;
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

/// Thumbnails, and who waits for them.
pub struct Thumbnails {
    kept: Kept,
    turn: Semaphore,
    waiting: AtomicUsize,
}

impl Thumbnails {
    /// Keeps thumbnails below the folder `cache`.
    pub fn new(cache: Option<&Path>) -> Self {
        let kept = Kept::new(cache.map(|cache| cache.join("thumbnails")));
        Self { kept, turn: Semaphore::new(1), waiting: AtomicUsize::new(0) }
    }

    /// The thumbnail of a scene, a JPEG. Work on it ends when nobody waits for it any more.
    ///
    /// # Errors
    /// If the scene cannot be read or traced, or too many wait.
    pub async fn of(&self, place: &Place, scenes: &Scenes) -> Result<Bytes, Refusal> {
        let _waiting = Waiting::new(&self.waiting)?;
        let (of_file, options) = (place.clone(), scenes.options().clone());
        let key = while_waited_for(move |_| key_of(&of_file, &options)).await?.ok();
        if let Some(jpeg) = self.kept_of_file(key).await? {
            return Ok(jpeg);
        }
        let _turn = self.turn.acquire().await.map_err(|_| Refusal::busy("the server stops"))?;
        // Those who waited for the same one find it made.
        if let Some(jpeg) = self.kept_of_file(key).await? {
            return Ok(jpeg);
        }
        let opened = scenes.open(place, For::Thumbnail).await?;
        let scene = Arc::clone(&opened.scene);
        drop(opened);
        let (kept, path, options) = (self.kept.clone(), place.path.clone(), scenes.options().clone());
        let jpeg = while_waited_for(move |wanted| {
            let hash = scene.content_hash() ^ VERSION;
            let jpeg = match kept.of_scene(hash) {
                Some(jpeg) => jpeg,
                None => {
                    let jpeg = render(&scene, wanted)?;
                    // Where it cannot be kept it is rendered again.
                    let _ = kept.keep(hash, &jpeg);
                    jpeg
                }
            };
            // What was written meanwhile may be another scene.
            let now = fs::metadata(&path)
                .and_then(|metadata| key_of(&Place { name: String::new(), path, metadata }, &options));
            if let Some(key) = key.filter(|key| now.is_ok_and(|now| now == *key)) {
                let _ = kept.keep_file(key, hash);
            }
            Ok::<_, Refusal>(jpeg)
        });
        Ok(jpeg.await??.into())
    }

    async fn kept_of_file(&self, key: Option<Key>) -> Result<Option<Bytes>, Refusal> {
        let kept = self.kept.clone();
        while_waited_for(move |_| key.and_then(|key| kept.of_file(key)).map(Into::into)).await
    }
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

/// What tells a file: what it holds, or where its scene needs others, where it is, and their version.
fn key_of(place: &Place, options: &ImportOptions) -> io::Result<Key> {
    let mut hash = Xxh3::with_seed(VERSION);
    if !sources::is_alone(place, options) {
        hash.update(place.path.as_os_str().as_encoded_bytes());
        return Ok(Key { file: hash.digest128(), version: sources::version(place, options) });
    }
    let (length, written) = place.version();
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
    Ok(Key { file: hash.digest128(), version: 0 })
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
