//! How far voxelizing is, told to another thread, which may also stop it.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Work done and work in all, in pieces of triangles in tiles.
#[derive(Debug, Default)]
pub struct VoxelizeProgress {
    done: AtomicU64,
    total: AtomicU64,
    cancelled: AtomicBool,
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

    pub(super) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Relaxed)
    }

    pub(super) fn begin(&self, total: u64) {
        self.total.store(total, Relaxed);
    }

    pub(super) fn add(&self, work: u64) {
        self.done.fetch_add(work, Relaxed);
    }
}
