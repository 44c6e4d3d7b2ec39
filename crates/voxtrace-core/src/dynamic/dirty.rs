//! Which parts of an array were written since they were last asked for.

use super::patch::ArrayPatch;
use bytemuck::Pod;

/// Ranges that lie closer together than this are one: to name a range costs more than so many records.
const GAP: u32 = 16;
/// Ranges that are kept before those that touch are joined.
const MANY: usize = 1 << 16;

/// Written ranges of one array.
#[derive(Clone, Debug, Default)]
pub(super) struct Dirty {
    ranges: Vec<(u32, u32)>,
    /// Ranges there were after joining them last.
    joined: usize,
}

impl Dirty {
    /// Notes that `length` records from `start` on were written.
    #[inline]
    pub fn mark(&mut self, start: usize, length: usize) {
        let (start, end) = (start as u32, (start + length) as u32);
        match self.ranges.last_mut() {
            Some(last) if start >= last.0 && start <= last.1 + GAP => last.1 = last.1.max(end),
            _ => self.ranges.push((start, end)),
        }
        if self.ranges.len() > 2 * self.joined.max(MANY) {
            self.join();
        }
    }

    /// Whether nothing was written.
    pub fn is_clean(&self) -> bool {
        self.ranges.is_empty()
    }

    fn join(&mut self) {
        self.ranges.sort_unstable();
        let mut joined: Vec<(u32, u32)> = Vec::with_capacity(self.ranges.len());
        for &(start, end) in &self.ranges {
            match joined.last_mut() {
                Some(last) if start <= last.1.saturating_add(GAP) => last.1 = last.1.max(end),
                _ => joined.push((start, end)),
            }
        }
        self.ranges = joined;
        self.joined = self.ranges.len();
    }

    /// What was written of `array` since the last call.
    pub fn take<T: Pod>(&mut self, array: &[T]) -> ArrayPatch<T> {
        self.join();
        let length = array.len();
        let within = |&(start, end): &(u32, u32)| (start as usize, (end as usize).min(length));
        let ranges: Vec<(usize, usize)> = self.ranges.iter().map(within).filter(|&(start, end)| start < end).collect();
        *self = Self::default();
        let mut records = Vec::with_capacity(ranges.iter().map(|(start, end)| end - start).sum());
        ranges.iter().for_each(|&(start, end)| records.extend_from_slice(&array[start..end]));
        ArrayPatch { length, ranges: ranges.into_iter().map(|(start, end)| (start, end - start)).collect(), records }
    }
}
