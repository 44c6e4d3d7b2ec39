//! The allocation tracker: every byte on the device by the name of what it is for.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// Bytes by name, as the driver says that it needs them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MemoryReport {
    /// Name and bytes of everything that is allocated now, by name.
    pub entries: BTreeMap<String, u64>,
    /// Most bytes that were allocated at one time, scratch of builds and staging included.
    pub peak_bytes: u64,
    /// Bytes that were copied to the device since it was opened, by the name of what they are for.
    pub uploaded: BTreeMap<String, u64>,
}

impl MemoryReport {
    /// Bytes of all entries.
    pub fn total_bytes(&self) -> u64 {
        self.entries.values().sum()
    }

    /// Bytes under one name, 0 where there is none.
    pub fn bytes(&self, name: &str) -> u64 {
        self.entries.get(name).copied().unwrap_or(0)
    }
}

/// Counts what is allocated and freed.
#[derive(Default)]
pub struct AllocationTracker(Mutex<MemoryReport>);

impl AllocationTracker {
    pub fn add(&self, name: &str, bytes: u64) {
        let mut report = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *report.entries.entry(name.to_owned()).or_default() += bytes;
        report.peak_bytes = report.peak_bytes.max(report.total_bytes());
    }

    pub fn remove(&self, name: &str, bytes: u64) {
        let mut report = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(entry) = report.entries.get_mut(name) {
            *entry = entry.saturating_sub(bytes);
            if *entry == 0 {
                report.entries.remove(name);
            }
        }
    }

    /// Counts bytes that are copied to the device.
    pub fn uploaded(&self, name: &str, bytes: u64) {
        let mut report = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *report.uploaded.entry(name.to_owned()).or_default() += bytes;
    }

    pub fn report(&self) -> MemoryReport {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_freed_leaves_the_report_but_not_the_peak() {
        let tracker = AllocationTracker::default();
        tracker.add("cells", 100);
        tracker.add("scratch", 50);
        tracker.remove("scratch", 50);
        tracker.uploaded("cells", 60);
        tracker.uploaded("cells", 40);
        let report = tracker.report();
        assert_eq!((report.total_bytes(), report.peak_bytes, report.bytes("scratch")), (100, 150, 0));
        assert_eq!((report.entries.len(), report.uploaded["cells"]), (1, 100));
    }
}
