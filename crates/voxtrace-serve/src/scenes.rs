//! Scenes of the folder, read once however many clients ask, and kept as long as there is room. What cannot be read is remembered, too. Both hold until
//! one of the files changes that the scene is read from.

use crate::joint::{Joint, Work};
use crate::places::Place;
use crate::refusal::Refusal;
use crate::settings::Limits;
use crate::sources;
use futures_util::FutureExt;
use futures_util::future::Shared;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, Weak};
use tokio::sync::Semaphore;
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
    /// Its native file, while it is sent to somebody.
    file: Mutex<Weak<Vec<u8>>>,
}

impl Opened {
    /// The scene as a native file: one in memory for all to whom it is sent meanwhile.
    pub fn file(&self) -> Arc<Vec<u8>> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.upgrade().unwrap_or_else(|| {
            let bytes = Arc::new(self.scene.to_bytes());
            *file = Arc::downgrade(&bytes);
            bytes
        })
    }
}

type Read = Result<Arc<Opened>, Refusal>;

struct Entry {
    version: u128,
    read: Arc<OnceLock<Read>>,
    under_way: Joint<Read>,
    last_use: u64,
}

/// Scenes by their files.
pub struct Scenes {
    entries: Mutex<(HashMap<PathBuf, Entry>, u64)>,
    /// One file is read for people at a time, and one for thumbnails: what reading takes is bounded.
    for_people: Arc<Semaphore>,
    for_thumbnails: Arc<Semaphore>,
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
            for_people: Arc::new(Semaphore::new(1)),
            for_thumbnails: Arc::new(Semaphore::new(1)),
            options: options_for(limits.memory),
            memory: limits.memory,
        }
    }

    /// The scene of a file or folder. Reading goes on while anybody waits for it, and ends when nobody does.
    ///
    /// # Errors
    /// If it cannot be read, or the server stops.
    pub async fn open(&self, place: &Place, who: For) -> Read {
        let (of_place, options) = (place.clone(), self.options.clone());
        let version = while_waited_for(move |_| sources::version(&of_place, &options)).await?;
        let read = self.read(place, version, who).await;
        self.make_room();
        read
    }

    /// What was read of this version of a scene, or the end of reading it.
    fn read(&self, place: &Place, version: u128, who: For) -> Shared<Work<Read>> {
        let (entries, clock) = &mut *self.lock();
        *clock += 1;
        let new = || Entry { version, read: Arc::default(), under_way: Joint::default(), last_use: *clock };
        let entry = entries.entry(place.path.clone()).or_insert_with(new);
        if entry.version != version {
            *entry = new();
        }
        entry.last_use = *clock;
        if let Some(read) = entry.read.get().cloned() {
            let read: Work<Read> = Box::pin(async { read });
            return read.shared();
        }
        let read = Arc::clone(&entry.read);
        entry.under_way.join(|| self.reading(place, who, read))
    }

    /// Reads a scene in its turn, and remembers in `kept` what became of it.
    fn reading(&self, place: &Place, who: For, kept: Arc<OnceLock<Read>>) -> Work<Read> {
        let turn = Arc::clone(if who == For::Person { &self.for_people } else { &self.for_thumbnails });
        let (path, name) = (place.path.clone(), place.name.clone());
        // A file that is mapped must not be changed in its place; one that there is room for is read instead.
        let in_memory = place.metadata.len() <= self.memory;
        let options = ImportOptions { in_memory, ..self.options.clone() };
        Box::pin(async move {
            let _turn = turn.acquire_owned().await.map_err(|_| Refusal::busy("the server stops"))?;
            let read = while_waited_for(move |wanted| read_file(&path, &name, &options, wanted)).await?;
            kept.get_or_init(|| read).clone()
        })
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
            let oldest = entries.iter().filter(|(_, entry)| entry.read.get().is_some());
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
    Ok(Arc::new(Opened { scene: Arc::new(scene), notes: loaded.notes, bytes, file: Mutex::default() }))
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

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::fs::{self, File};
    use std::io::Write;
    use std::process::Command;
    use std::time::Duration;

    #[test]
    fn what_is_sent_to_several_is_in_memory_once_and_only_meanwhile() {
        let scene = PackedScene::pack(&voxtrace::scenes::generate("city", Some(20_000)).unwrap()).unwrap();
        let opened = Opened { scene: Arc::new(scene), notes: Vec::new(), bytes: 0, file: Mutex::default() };
        let first = opened.file();
        assert!(Arc::ptr_eq(&first, &opened.file()) && *first == opened.scene.to_bytes());
        let sent = Arc::downgrade(&first);
        drop(first);
        assert!(sent.upgrade().is_none());
        assert!(!opened.file().is_empty());
    }

    /// A pipe tells when it is opened, and is read as slowly as it is written.
    #[test]
    fn a_scene_is_read_on_for_others_when_the_first_who_asked_leaves() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("slow.xyz");
        assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
        let place = Place { name: "slow.xyz".into(), metadata: fs::metadata(&path).unwrap(), path: path.clone() };
        let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_all().build().unwrap();
        let read = runtime.block_on(async {
            let scenes = Scenes::new(&Limits::default());
            let first = tokio::spawn(scenes.read(&place, 0, For::Person));
            let mut writer = tokio::task::spawn_blocking(move || File::create(path).unwrap()).await.unwrap();
            writer.write_all(b"0 0 0\n5 0 0\n0 5 0\n").unwrap();
            let second = tokio::spawn(scenes.read(&place, 0, For::Person));
            first.abort();
            assert!(first.await.unwrap_err().is_cancelled());
            writer.write_all(b"0 0 5\n5 5 5\n").unwrap();
            drop(writer);
            tokio::time::timeout(Duration::from_secs(60), second).await
        });
        runtime.shutdown_background();
        let opened = read.expect("reading began anew").unwrap().unwrap();
        assert_eq!(opened.scene.statistics().voxels, 5);
    }
}
