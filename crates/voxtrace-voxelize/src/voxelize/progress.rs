//! Progress of voxelizing, for another thread to watch and to cancel.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Work done and in all, counted in (tile, triangle) pairs, triangles or points.
#[derive(Debug, Default)]
pub struct VoxelizeProgress {
    done: AtomicU64,
    total: AtomicU64,
    cancelled: AtomicBool,
    notes: Mutex<Vec<String>>,
}

impl VoxelizeProgress {
    /// Work done.
    pub fn done(&self) -> u64 {
        self.done.load(Relaxed)
    }

    /// Work in all, 0 as long as that is unknown.
    pub fn total(&self) -> u64 {
        self.total.load(Relaxed)
    }

    /// Asks to stop soon.
    pub fn cancel(&self) {
        self.cancelled.store(true, Relaxed);
    }

    /// The messages since the last call, one sentence each, for people.
    pub fn take_notes(&self) -> Vec<String> {
        self.notes.lock().map(|mut notes| std::mem::take(&mut *notes)).unwrap_or_default()
    }

    pub(super) fn note(&self, note: String) {
        if let Ok(mut notes) = self.notes.lock() {
            notes.push(note);
        }
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Relaxed)
    }

    pub(crate) fn begin(&self, total: u64) {
        self.total.store(total, Relaxed);
    }

    pub(crate) fn add(&self, work: u64) {
        self.done.fetch_add(work, Relaxed);
    }
}
