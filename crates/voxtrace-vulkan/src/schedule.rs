//! How much work one submit gets, so that none runs long: their times say how much fits.

/// Milliseconds that a submit should take: less than half of what is allowed (250 ms), as scenes are uneven. A window asks for less.
pub const TARGET_MS: f64 = 100.0;
/// Work of the first submit.
const FIRST: u64 = 1 << 13;
/// Growth from one submit to the next.
const MOST_GROWTH: u64 = 8;

/// Sizes the batches of one kind of work.
#[derive(Clone, Copy, Debug)]
pub struct BatchSizer {
    next: u64,
    target_ms: f64,
}

impl Default for BatchSizer {
    fn default() -> Self {
        Self::new(TARGET_MS)
    }
}

impl BatchSizer {
    /// Submits that should take `target_ms` milliseconds.
    pub fn new(target_ms: f64) -> Self {
        Self { next: FIRST, target_ms }
    }

    /// Units of work that the next submit may hold.
    pub fn units(&self) -> u64 {
        self.next
    }

    /// Takes into account that `work` units took `ms`.
    pub fn update(&mut self, work: u64, ms: f64) {
        if work == 0 {
            return;
        }
        let fitting = work as f64 * self.target_ms / ms.max(1e-3);
        // A small submit, say the rest of a frame, tells nothing about large ones, unless it was slow.
        let is_telling = work >= self.next / 4 || ms > self.target_ms;
        if is_telling {
            let most = work.max(self.next / MOST_GROWTH).saturating_mul(MOST_GROWTH);
            self.next = (fitting as u64).clamp(64, most.max(64));
        }
    }
}

/// A block of pixels and how many samples each gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    pub first: u64,
    pub count: u64,
    pub samples: u32,
}

/// Cuts one round of a frame: `pixels` pixels that each lack up to `missing` samples.
pub struct Round {
    pixels: u64,
    samples: u32,
    at: u64,
}

impl Round {
    /// The next round: as many samples a pixel as fit one submit, at least one.
    pub fn new(batches: &BatchSizer, pixels: u64, missing: u32) -> Self {
        let samples = (batches.units() / pixels.max(1)).clamp(1, u64::from(missing)) as u32;
        Self { pixels, samples, at: 0 }
    }

    /// Samples that each pixel gets in this round, at most.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Whether every pixel was in a block.
    pub fn is_over(&self) -> bool {
        self.at == self.pixels
    }

    /// The next block, no longer than `most` pixels; `None` at the end of the round.
    pub fn next(&mut self, batches: &BatchSizer, most: u64) -> Option<Block> {
        let left = self.pixels - self.at;
        if left == 0 {
            return None;
        }
        // Whole workgroups, so that only the last one of a frame is not full.
        let fitting = (batches.units() / u64::from(self.samples)).next_multiple_of(64);
        let count = left.min(fitting).min(most).max(1);
        let block = Block { first: self.at, count, samples: self.samples };
        self.at += count;
        Some(block)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blocks(batches: &BatchSizer, pixels: u64, missing: u32) -> Vec<Block> {
        let mut round = Round::new(batches, pixels, missing);
        std::iter::from_fn(|| round.next(batches, u64::MAX)).collect()
    }

    #[test]
    fn a_round_covers_every_pixel_once() {
        for pixels in [1, 63, 64, 65, 8191, 8192, 100_000] {
            let blocks = blocks(&BatchSizer::default(), pixels, 1000);
            let mut at = 0;
            for block in &blocks {
                assert_eq!(block.first, at);
                at += block.count;
            }
            assert_eq!(at, pixels);
            let mut round = Round::new(&BatchSizer::default(), pixels, 1000);
            let mut is_over = || round.next(&BatchSizer::default(), u64::MAX).map(|_| round.is_over());
            let told: Vec<bool> = std::iter::from_fn(&mut is_over).collect();
            assert_eq!(told.iter().position(|&is_over| is_over), Some(blocks.len() - 1), "the last block says so");
        }
    }

    #[test]
    fn a_slow_device_gets_small_blocks() {
        let mut batches = BatchSizer::default();
        batches.update(8192, 1000.0);
        assert_eq!(batches.units(), 819);
        batches.update(819, 100.0);
        assert_eq!(batches.units(), 819);
    }

    #[test]
    fn a_fast_device_soon_gets_many_samples_at_once() {
        let mut batches = BatchSizer::default();
        for _ in 0..8 {
            let units = batches.units();
            batches.update(units, units as f64 * 1e-6);
        }
        assert_eq!(batches.units(), 100_000_000);
        assert_eq!(blocks(&batches, 2_000_000, 1000), [Block { first: 0, count: 2_000_000, samples: 50 }]);
        assert_eq!(blocks(&batches, 2_000_000, 3), [Block { first: 0, count: 2_000_000, samples: 3 }]);
    }

    #[test]
    fn the_rest_of_a_frame_does_not_slow_the_next_one() {
        let mut batches = BatchSizer { next: 1_000_000, ..BatchSizer::default() };
        batches.update(64, 0.01);
        assert_eq!(batches.units(), 1_000_000);
    }
}
