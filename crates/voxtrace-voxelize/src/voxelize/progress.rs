//! Progress of voxelizing, for another thread to watch and to cancel.

use std::fmt::{self, Debug, Formatter};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Work done and in all, counted in (tile, triangle) pairs, triangles or points.
#[derive(Default)]
pub struct VoxelizeProgress {
    done: AtomicU64,
    total: AtomicU64,
    cancelled: AtomicBool,
    notes: Mutex<Vec<String>>,
    /// Whether somebody still waits.
    wanted: Option<Box<dyn Fn() -> bool + Send + Sync>>,
}

impl Debug for VoxelizeProgress {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut progress = f.debug_struct("VoxelizeProgress");
        progress.field("done", &self.done).field("total", &self.total).field("cancelled", &self.cancelled);
        progress.field("notes", &self.notes).finish_non_exhaustive()
    }
}

impl VoxelizeProgress {
    /// Of work that stops soon, too, once it is not `wanted` any more, which is asked now and then, on several threads, and which says no for good.
    pub fn while_wanted(wanted: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self { wanted: Some(Box::new(wanted)), ..Self::default() }
    }

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
        self.cancelled.load(Relaxed) || self.wanted.as_ref().is_some_and(|wanted| !wanted())
    }

    pub(crate) fn begin(&self, total: u64) {
        self.total.store(total, Relaxed);
    }

    pub(crate) fn add(&self, work: u64) {
        self.done.fetch_add(work, Relaxed);
    }
}
