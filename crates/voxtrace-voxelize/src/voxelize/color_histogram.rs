//! Histogram of the voxels' colours, in constant memory. A bitmap of all 2²⁴ colours tells exactly how many distinct ones
//! there are, so whether each can be a material of its own; counts in bins of 7 bits a channel feed the colour quantization.

use super::appearance::{AppearanceKey, MAX_BSDF_CLASSES};
use rustc_hash::FxHashMap;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, OnceLock};

/// Number of 24-bit colours.
const COLORS: usize = 1 << 24;
/// Number of histogram bins: 7 bits a channel.
pub(super) const BINS: usize = 1 << 21;

/// Most voxels that a bin counts.
const MOST_IN_BIN: u32 = u32::MAX / 2;

/// Histogram of the colours of one BSDF class.
struct ClassHistogram {
    /// Bitmap: one bit for each 24-bit colour that occurs.
    seen: Vec<AtomicU64>,
    /// Number of voxels in each bin; not counted further from [`MOST_IN_BIN`] on.
    bins: Vec<AtomicU32>,
}

/// Histogram of the appearances of all voxels so far, filled by many threads at once.
pub(crate) struct ColorHistogram {
    classes: [OnceLock<ClassHistogram>; MAX_BSDF_CLASSES],
    /// Number of voxels of each emissive appearance.
    emissive: Mutex<FxHashMap<AppearanceKey, u64>>,
}

/// The histogram bin of a 0xRRGGBB colour: the upper 7 bits of each channel.
pub(super) fn bin_of(rgb: u32) -> usize {
    ((rgb >> 17 & 0x7f) << 14 | (rgb >> 9 & 0x7f) << 7 | rgb >> 1 & 0x7f) as usize
}

/// The sRGB colour in the middle of a bin, each channel in [0, 1].
pub(super) fn color_of_bin(bin: usize) -> [f32; 3] {
    [14, 7, 0].map(|shift| ((bin >> shift & 0x7f) as f32 * 2.0 + 0.5) / 255.0)
}

impl Default for ColorHistogram {
    fn default() -> Self {
        Self { classes: [const { OnceLock::new() }; MAX_BSDF_CLASSES], emissive: Mutex::default() }
    }
}

impl ColorHistogram {
    /// Adds `times` voxels of each of the appearances.
    pub fn add(&self, keys: &[AppearanceKey], times: u32) {
        let mut last = None;
        for &key in keys {
            if key >> 32 != 0 {
                if let Ok(mut emissive) = self.emissive.lock() {
                    *emissive.entry(key).or_insert(0) += u64::from(times);
                }
                continue;
            }
            let (rgb, class) = (key as u32 & 0xff_ffff, (key >> 24 & 0xff) as usize);
            let histogram = self.classes[class].get_or_init(ClassHistogram::new);
            if last != Some(key) {
                let (word, bit) = (&histogram.seen[rgb as usize / 64], 1u64 << (rgb % 64));
                if word.load(Relaxed) & bit == 0 {
                    word.fetch_or(bit, Relaxed);
                }
                last = Some(key);
            }
            let bin = &histogram.bins[bin_of(rgb)];
            if bin.load(Relaxed) < MOST_IN_BIN {
                bin.fetch_add(times.min(u32::MAX / 4), Relaxed);
            }
        }
    }

    /// The distinct appearances that do not emit, class by class, colours in ascending order.
    pub fn appearances(&self) -> Vec<AppearanceKey> {
        let mut appearances = Vec::new();
        for (class, histogram) in self.classes.iter().enumerate() {
            for (word, seen) in histogram.get().map_or(&[][..], |histogram| &histogram.seen).iter().enumerate() {
                let seen = seen.load(Relaxed);
                appearances.extend(
                    voxtrace_scene::brick::bits(seen)
                        .map(|bit| (class as u64) << 24 | (word * 64) as u64 | u64::from(bit)),
                );
            }
        }
        appearances
    }

    /// Number of distinct appearances that do not emit.
    pub fn appearance_count(&self) -> u64 {
        let words = self.classes.iter().filter_map(OnceLock::get).flat_map(|histogram| &histogram.seen);
        words.map(|word| u64::from(word.load(Relaxed).count_ones())).sum()
    }

    /// The bins of a class that are not empty, ascending, with their numbers of voxels.
    pub fn bins(&self, class: usize) -> Vec<(usize, u32)> {
        let bins = self.classes[class].get().map_or(&[][..], |histogram| &histogram.bins);
        // Who counted the last ones, several threads at once, does not matter.
        let count = |bin: &AtomicU32| bin.load(Relaxed).min(MOST_IN_BIN);
        bins.iter().map(count).enumerate().filter(|&(_, count)| count > 0).collect()
    }

    /// The emissive appearances, ascending, with their numbers of voxels.
    pub fn emissive(&self) -> Vec<(AppearanceKey, u64)> {
        let mut emissive: Vec<_> =
            self.emissive.lock().map(|map| map.iter().map(|(&key, &count)| (key, count)).collect()).unwrap_or_default();
        emissive.sort_unstable();
        emissive
    }
}

impl ClassHistogram {
    fn new() -> Self {
        Self {
            seen: (0..COLORS / 64).map(|_| AtomicU64::new(0)).collect(),
            bins: (0..BINS).map(|_| AtomicU32::new(0)).collect(),
        }
    }
}
