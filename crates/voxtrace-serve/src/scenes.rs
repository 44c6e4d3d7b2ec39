//! Scenes of the folder, read once however many clients ask, and kept as long as there is room. What cannot be read is remembered, too, until its file
//! changes.

use crate::places::Place;
use crate::refusal::Refusal;
use crate::settings::Limits;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::{OnceCell, Semaphore};
use voxtrace::PackedScene;
use voxtrace::import::{self, Content, ImportOptions};

/// Bytes of memory that a voxel, and a point or triangle, may take while a file is read.
const BYTES_PER_VOXEL: u64 = 4;
const BYTES_PER_POINT: u64 = 64;
/// Failures that are remembered.
const MOST_FAILURES: usize = 4096;

/// A scene that was read.
#[derive(Debug)]
pub struct Opened {
    pub scene: Arc<PackedScene>,
    /// What its reader left out or put up with.
    pub notes: Vec<String>,
    /// Bytes of the packed scene.
    pub bytes: u64,
}

type Read = Result<Arc<Opened>, Refusal>;

struct Entry {
    version: (u64, u128),
    read: Arc<OnceCell<Read>>,
    last_use: u64,
}

/// Scenes by their files.
pub struct Scenes {
    entries: Mutex<(HashMap<PathBuf, Entry>, u64)>,
    /// One file is read for people at a time, and one for thumbnails: what reading takes is bounded.
    for_people: Semaphore,
    for_thumbnails: Semaphore,
    options: ImportOptions,
    memory: u64,
}

/// Who waits for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum For {
    Person,
    Thumbnail,
}

impl Scenes {
    pub fn new(limits: &Limits) -> Self {
        Self {
            entries: Mutex::default(),
            for_people: Semaphore::new(1),
            for_thumbnails: Semaphore::new(1),
            options: options_for(limits.memory),
            memory: limits.memory,
        }
    }

    /// The scene of a file or folder. Reading ends when nobody waits for it any more.
    pub async fn open(&self, place: &Place, who: For) -> Read {
        let read = self.entry(place);
        let read = read.get_or_try_init(|| async {
            let turn = if who == For::Person { &self.for_people } else { &self.for_thumbnails };
            let _turn = turn.acquire().await.map_err(|_| Refusal::busy("the server stops"))?;
            let (path, name) = (place.path.clone(), place.name.clone());
            // A file that is mapped must not be changed in its place; one that there is room for is read instead.
            let in_memory = place.metadata.len() <= self.memory;
            let options = ImportOptions { in_memory, ..self.options.clone() };
            let read = while_waited_for(move |wanted| read_file(&path, &name, &options, wanted)).await?;
            Ok::<_, Refusal>(read)
        });
        let read = read.await?.clone();
        self.make_room();
        read
    }

    fn entry(&self, place: &Place) -> Arc<OnceCell<Read>> {
        let (entries, clock) = &mut *self.lock();
        *clock += 1;
        let new = || Entry { version: place.version(), read: Arc::default(), last_use: *clock };
        let entry = entries.entry(place.path.clone()).or_insert_with(new);
        if entry.version != place.version() {
            *entry = new();
        }
        entry.last_use = *clock;
        Arc::clone(&entry.read)
    }

    /// Forgets the scenes that were not asked for longest, until the others fit.
    fn make_room(&self) {
        let (entries, _) = &mut *self.lock();
        let bytes_of = |entry: &Entry| match entry.read.get() {
            Some(Ok(opened)) => opened.bytes,
            _ => 0,
        };
        let mut bytes: u64 = entries.values().map(bytes_of).sum();
        while bytes > self.memory || entries.len() > MOST_FAILURES {
            let oldest = entries.iter().filter(|(_, entry)| entry.read.initialized());
            let oldest = oldest.filter(|(_, entry)| entries.len() > MOST_FAILURES || bytes_of(entry) > 0);
            let Some(path) = oldest.min_by_key(|(_, entry)| entry.last_use).map(|(path, _)| path.clone()) else {
                break;
            };
            bytes -= entries.remove(&path).map_or(0, |entry| bytes_of(&entry));
        }
    }

    fn lock(&self) -> MutexGuard<'_, (HashMap<PathBuf, Entry>, u64)> {
        self.entries.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn options(&self) -> &ImportOptions {
        &self.options
    }
}

/// What files may take while they are read, by the memory that there is for scenes.
fn options_for(memory: u64) -> ImportOptions {
    let mut options = ImportOptions::default();
    let limits = &mut options.limits;
    limits.bytes = limits.bytes.min(memory.saturating_mul(4));
    limits.voxels = limits.voxels.min(memory / BYTES_PER_VOXEL);
    limits.points = limits.points.min(memory / BYTES_PER_POINT);
    options
}

/// Reads a file; `name` is what clients know it by.
pub fn read_file(path: &Path, name: &str, options: &ImportOptions, wanted: Arc<AtomicBool>) -> Read {
    let of_readers = Arc::clone(&wanted);
    let loaded = import::read_while(move || of_readers.load(Ordering::Relaxed), || import::load(path, options));
    // Errors name the file as the system does, which is nobody's business.
    let loaded =
        loaded.map_err(|error| Refusal::unreadable(error.to_string().replace(&*path.to_string_lossy(), name)))?;
    let scene = match loaded.content {
        Content::Packed(packed) => *packed,
        Content::Scene(scene) => PackedScene::pack_merged_while(&scene, &|| wanted.load(Ordering::Relaxed))
            .map_err(|error| Refusal::unreadable(format!("{name}: {error}")))?,
    };
    let bytes = scene.statistics().total_bytes();
    Ok(Arc::new(Opened { scene: Arc::new(scene), notes: loaded.notes, bytes }))
}

/// Does work on a thread for it, and tells it when nobody waits any more.
pub async fn while_waited_for<T: Send + 'static>(
    work: impl FnOnce(Arc<AtomicBool>) -> T + Send + 'static,
) -> Result<T, Refusal> {
    struct Wanted(Arc<AtomicBool>);
    impl Drop for Wanted {
        fn drop(&mut self) {
            self.0.store(false, Ordering::Relaxed);
        }
    }
    let wanted = Wanted(Arc::new(AtomicBool::new(true)));
    let flag = Arc::clone(&wanted.0);
    let done = tokio::task::spawn_blocking(move || work(flag)).await;
    done.map_err(|_| Refusal::failed("this could not be done; the server goes on"))
}
