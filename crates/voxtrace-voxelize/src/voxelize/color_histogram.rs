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
        self.tally().add(keys, times);
    }

    /// Counts voxels for the histogram, for one thread that has many.
    pub fn tally(&self) -> Tally<'_> {
        Tally { histogram: self, last: None, recent: [(NO_BIN, 0); RECENT] }
    }

    /// Counts voxels of a bin, which has its class above it.
    fn count(&self, (bin, times): (u32, u32)) {
        if bin != NO_BIN {
            let bin = &self.class(bin as usize / BINS).bins[bin as usize % BINS];
            if bin.load(Relaxed) < MOST_IN_BIN {
                bin.fetch_add(times.min(u32::MAX / 4), Relaxed);
            }
        }
    }

    fn class(&self, class: usize) -> &ClassHistogram {
        self.classes[class].get_or_init(ClassHistogram::new)
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

/// Bins that a [`Tally`] counts for itself.
const RECENT: usize = 1 << 8;
/// No bin.
const NO_BIN: u32 = u32::MAX;
/// Most voxels that a [`Tally`] keeps for itself, so that no number of threads counts a bin over.
const MOST_KEPT: u32 = 1 << 20;

/// Counts what a thread adds to a histogram, and brings together what lies in the same bin: all threads count in the same bins, which wait for each
/// other. What is counted is in the histogram once this is dropped.
pub(crate) struct Tally<'a> {
    histogram: &'a ColorHistogram,
    /// The appearance that came last.
    last: Option<AppearanceKey>,
    /// Bins that came not long ago, with their class above them, and the voxels that the histogram does not have yet.
    recent: [(u32, u32); RECENT],
}

impl Tally<'_> {
    /// Adds `times` voxels of each of the appearances.
    pub fn add(&mut self, keys: &[AppearanceKey], times: u32) {
        for &key in keys {
            if key >> 32 != 0 {
                if let Ok(mut emissive) = self.histogram.emissive.lock() {
                    *emissive.entry(key).or_insert(0) += u64::from(times);
                }
                continue;
            }
            let (rgb, class) = (key as u32 & 0xff_ffff, (key >> 24 & 0xff) as usize);
            if self.last != Some(key) {
                let (word, bit) = (&self.histogram.class(class).seen[rgb as usize / 64], 1u64 << (rgb % 64));
                if word.load(Relaxed) & bit == 0 {
                    word.fetch_or(bit, Relaxed);
                }
                self.last = Some(key);
            }
            let bin = (class * BINS + bin_of(rgb)) as u32;
            // Fibonacci hashing (Knuth, The Art of Computer Programming 3, section 6.4).
            let slot = (bin.wrapping_mul(0x9e37_79b9) >> (u32::BITS - RECENT.ilog2())) as usize;
            let (held, count) = self.recent[slot];
            if held == bin && count < MOST_KEPT {
                self.recent[slot].1 = count.saturating_add(times);
            } else {
                self.histogram.count(self.recent[slot]);
                self.recent[slot] = (bin, times);
            }
        }
    }
}

impl Drop for Tally<'_> {
    fn drop(&mut self) {
        self.recent.iter().for_each(|&recent| self.histogram.count(recent));
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

#[cfg(test)]
mod tests {
    use super::super::appearance::appearance_key;
    use super::*;
    use rayon::prelude::*;
    use std::collections::BTreeMap;

    #[test]
    fn what_many_threads_tally_is_what_one_counts() {
        // Few colours that come again and again, and many that drive them out; some of another class, and lamps.
        let key_of = |index: u32| match index % 7 {
            0..4 => appearance_key(0x10_2030 + (index % 5) * 0x02_0202, 0, 0),
            4 | 5 => appearance_key(index.wrapping_mul(2_654_435_761) >> 8, (index % 2) as u8, 0),
            _ => appearance_key(0xff_ffff, 0, 1 + index % 3),
        };
        let histogram = ColorHistogram::default();
        let chunks: Vec<u32> = (0..64).collect();
        chunks.par_iter().for_each(|&chunk| {
            let mut tally = histogram.tally();
            for run in 0..500 {
                let first = (chunk * 500 + run) * 4;
                let keys: Vec<AppearanceKey> = (first..first + 4).map(key_of).collect();
                tally.add(&keys, 1 + run % 3);
            }
        });
        let (mut bins, mut lamps) = ([BTreeMap::new(), BTreeMap::new()], BTreeMap::new());
        let mut seen: Vec<AppearanceKey> = Vec::new();
        for index in 0..64 * 500 * 4u32 {
            let (key, times) = (key_of(index), 1 + index / 4 % 500 % 3);
            if key >> 32 != 0 {
                *lamps.entry(key).or_insert(0u64) += u64::from(times);
            } else {
                seen.push(key);
                *bins[(key >> 24) as usize].entry(bin_of(key as u32 & 0xff_ffff)).or_insert(0) += times;
            }
        }
        seen.sort_unstable();
        seen.dedup();
        assert!(seen.len() > 10_000 && lamps.len() == 3);
        assert_eq!(histogram.appearances(), seen);
        assert_eq!(histogram.emissive(), Vec::from_iter(lamps));
        for (class, bins) in bins.into_iter().enumerate() {
            assert_eq!(histogram.bins(class), Vec::from_iter(bins));
        }
    }

    #[test]
    fn a_bin_is_not_counted_over() {
        let histogram = ColorHistogram::default();
        (0..64).into_par_iter().for_each(|_| {
            let mut tally = histogram.tally();
            (0..100).for_each(|_| tally.add(&[0x10_2030], 1 << 19));
        });
        histogram.add(&[0x10_2030], u32::MAX);
        histogram.add(&[0x40_5060], u32::MAX);
        assert_eq!(histogram.bins(0), [(bin_of(0x10_2030), MOST_IN_BIN), (bin_of(0x40_5060), u32::MAX / 4)]);
    }
}
