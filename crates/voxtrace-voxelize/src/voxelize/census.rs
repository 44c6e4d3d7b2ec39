//! Which colours the voxels have, and about how often: exact for the question whether they fit as they are, by bins of 7
//! bits a channel for choosing a palette. Its size does not grow with the voxels.

use super::key::{Key, MAX_CLASSES};
use rustc_hash::FxHashMap;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, OnceLock};

/// Colours of 24 bits.
const COLORS: usize = 1 << 24;
/// Bins of 7 bits a channel.
pub(super) const BINS: usize = 1 << 21;

/// Colours of one class of surface.
struct ClassCensus {
    /// A bit for each colour.
    seen: Vec<AtomicU64>,
    /// Voxels of each bin, up to `u32::MAX`.
    bins: Vec<AtomicU32>,
}

/// The looks of all voxels so far.
#[derive(Default)]
pub(super) struct Census {
    classes: [OnceLock<ClassCensus>; MAX_CLASSES],
    /// Voxels of each look that emits.
    emitting: Mutex<FxHashMap<Key, u64>>,
}

/// The bin of a colour: the upper 7 bits of each channel.
pub(super) fn bin_of(rgb: u32) -> usize {
    ((rgb >> 17 & 0x7f) << 14 | (rgb >> 9 & 0x7f) << 7 | rgb >> 1 & 0x7f) as usize
}

/// The colour in the middle of a bin.
pub(super) fn color_of_bin(bin: usize) -> [f32; 3] {
    [14, 7, 0].map(|shift| ((bin >> shift & 0x7f) as f32 * 2.0 + 0.5) / 255.0)
}

impl Census {
    /// Adds `times` voxels of each of the looks.
    pub fn add(&self, keys: &[Key], times: u32) {
        let mut last = None;
        for &key in keys {
            if key >> 32 != 0 {
                if let Ok(mut emitting) = self.emitting.lock() {
                    *emitting.entry(key).or_insert(0) += u64::from(times);
                }
                continue;
            }
            let (rgb, class) = (key as u32 & 0xff_ffff, (key >> 24 & 0xff) as usize);
            let census = self.classes[class].get_or_init(ClassCensus::new);
            if last != Some(key) {
                let (word, bit) = (&census.seen[rgb as usize / 64], 1u64 << (rgb % 64));
                if word.load(Relaxed) & bit == 0 {
                    word.fetch_or(bit, Relaxed);
                }
                last = Some(key);
            }
            let bin = &census.bins[bin_of(rgb)];
            if bin.load(Relaxed) < u32::MAX / 2 {
                bin.fetch_add(times.min(u32::MAX / 4), Relaxed);
            }
        }
    }

    /// The distinct looks that do not emit, class by class, colours in ascending order.
    pub fn looks(&self) -> Vec<Key> {
        let mut looks = Vec::new();
        for (class, census) in self.classes.iter().enumerate() {
            for (word, seen) in census.get().map_or(&[][..], |census| &census.seen).iter().enumerate() {
                let seen = seen.load(Relaxed);
                looks.extend(
                    voxtrace_scene::brick::bits(seen)
                        .map(|bit| (class as u64) << 24 | (word * 64) as u64 | u64::from(bit)),
                );
            }
        }
        looks
    }

    /// Number of distinct looks that do not emit.
    pub fn look_count(&self) -> u64 {
        let words = self.classes.iter().filter_map(OnceLock::get).flat_map(|census| &census.seen);
        words.map(|word| u64::from(word.load(Relaxed).count_ones())).sum()
    }

    /// Voxels in each bin of a class that has any, bins in ascending order.
    pub fn bins(&self, class: usize) -> Vec<(usize, u32)> {
        let bins = self.classes[class].get().map_or(&[][..], |census| &census.bins);
        bins.iter().enumerate().map(|(bin, count)| (bin, count.load(Relaxed))).filter(|&(_, count)| count > 0).collect()
    }

    /// The looks that emit and their voxels, ascending.
    pub fn emitting(&self) -> Vec<(Key, u64)> {
        let mut emitting: Vec<_> =
            self.emitting.lock().map(|map| map.iter().map(|(&key, &count)| (key, count)).collect()).unwrap_or_default();
        emitting.sort_unstable();
        emitting
    }
}

impl ClassCensus {
    fn new() -> Self {
        Self {
            seen: (0..COLORS / 64).map(|_| AtomicU64::new(0)).collect(),
            bins: (0..BINS).map(|_| AtomicU32::new(0)).collect(),
        }
    }
}
