//! The server over real sockets: what it gives, what it withstands, and how it ends.

mod client;
mod hostile;
mod page;
mod remote;
mod serving;
mod uploads;

use client::SECRET;
use std::fs;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use voxtrace::{PackedScene, scenes};
use voxtrace_serve::{Server, Settings, Viewers};

/// A server of a folder of its own, beside which lies what nobody may see.
pub(crate) struct Running {
    pub(crate) address: SocketAddr,
    pub(crate) url: String,
    pub(crate) viewers: Viewers,
    parent: tempfile::TempDir,
    is_over: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Running {
    pub(crate) fn start(change: impl FnOnce(&mut Settings)) -> Self {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("folder");
        fs::create_dir_all(folder.join("inner")).unwrap();
        fs::create_dir_all(folder.join(".hidden")).unwrap();
        fs::write(parent.path().join("secret.vox"), SECRET).unwrap();
        fs::write(folder.join(".hidden/secret.vox"), SECRET).unwrap();
        fs::write(folder.join("damaged.vox"), "VOX \u{96}\0\0\0 and nothing more").unwrap();
        fs::write(folder.join("notes.html"), SECRET).unwrap();
        city(20_000).save(&folder.join("scene.vxt")).unwrap();
        fs::copy(folder.join("scene.vxt"), folder.join("inner/copy of it.vxt")).unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::symlink;
            symlink(parent.path(), folder.join("out")).unwrap();
            symlink(parent.path().join("secret.vox"), folder.join("link.vox")).unwrap();
            symlink("/dev/zero", folder.join("zero.vox")).unwrap();
        }
        let mut settings = Settings::new(&folder, "127.0.0.1:0".parse().unwrap());
        settings.tracer.traversal = Some(voxtrace_vulkan::Traversal::Cpu);
        settings.cache = Some(parent.path().join("cache"));
        change(&mut settings);
        let server = Server::bind(settings).unwrap();
        let (address, url, viewers) = (server.address(), server.url(), server.viewers());
        let is_over = Arc::new(AtomicBool::new(false));
        let of_server = Arc::clone(&is_over);
        let run = move || server.run(|| of_server.load(Ordering::Relaxed)).unwrap();
        Self { address, url, viewers, parent, is_over, thread: Some(std::thread::spawn(run)) }
    }

    pub(crate) fn folder(&self) -> PathBuf {
        self.parent.path().join("folder")
    }

    pub(crate) fn cache(&self) -> PathBuf {
        self.parent.path().join("cache")
    }

    /// Asks it to stop and waits until it has.
    pub(crate) fn stop(&mut self) -> Duration {
        let start = Instant::now();
        self.is_over.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.join().unwrap();
        }
        start.elapsed()
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take()
            && !std::thread::panicking()
        {
            thread.join().unwrap();
        }
    }
}

/// A packed scene of so many voxels.
pub(crate) fn city(voxels: u64) -> PackedScene {
    PackedScene::pack(&scenes::generate("city", Some(voxels)).unwrap()).unwrap()
}

/// The files below a folder, hidden ones too.
pub(crate) fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_dir() {
            found.extend(files_below(&entry.path()));
        }
        found.push(entry.path());
    }
    found.sort();
    found
}

/// Waits until something is so.
pub(crate) fn until(what: &str, is_so: impl Fn() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < Duration::from_secs(300), "{what}");
        std::thread::sleep(Duration::from_millis(10));
    }
}
