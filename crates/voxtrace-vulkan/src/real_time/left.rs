//! Paths of real-time light that left the waves of matte things: how many rounds the waves of their own have, and whether these are quicker than one shader that follows
//! all paths. `shaders/pass/realtime_left.slang` says how they go.

use super::Count;
use crate::buffer::Buffer;
use crate::device::Device;
use crate::records::{WAVE_COUNTS_WORDS, WAVE_ROUND_WORDS};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Place of their counts among those of the light cache: how many, workgroups for them along three axes, how many were begun in waves, and the round of the last of these.
pub const COUNTS: u64 = 9;
const COUNTED: usize = 6;
/// Rows of 16 bytes of a path.
const ROWS: u32 = 13;
/// Queues of paths, in turn.
const QUEUES: u64 = 2;
/// Rounds after the one in which the last path began: then one shader takes the few that are left to their ends.
const LAST_ROUNDS: u32 = 4;
/// Rounds of a frame, at most: their counts have room.
pub const MOST_ROUNDS: u32 = WAVE_COUNTS_WORDS / WAVE_ROUND_WORDS - 1;
/// Share of the paths that leave from which on one shader, which follows all, may be quicker.
const MOST: f64 = 0.6;

/// What frames before say of those that left.
pub struct Left {
    device: Arc<Device>,
    /// What the last frame counted.
    counts: Buffer,
    /// Paths in waves at most.
    pub most: u32,
    rounds: u32,
    quicker: Quicker,
}

impl Left {
    /// Nothing is known.
    pub fn new(device: &Arc<Device>) -> Result<Self, TraceError> {
        let (size, usage) = (4 * COUNTED as u64, vk::BufferUsageFlags::TRANSFER_DST);
        let counts = Buffer::new(device, "real-time counts", size, usage, MemoryLocation::GpuToCpu)?;
        Ok(Self {
            device: Arc::clone(device),
            counts,
            most: u32::MAX,
            rounds: LAST_ROUNDS,
            quicker: Quicker::default(),
        })
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> u64 {
        self.counts.bytes()
    }

    /// Paths that are in waves at once, where the scratch memory has so many slots.
    pub fn room(&self, slots: u32) -> u32 {
        room(slots).min(self.most)
    }

    /// Counts of rounds, and queues for that many.
    pub fn queues(device: &Arc<Device>, slots: u32) -> Result<Buffer, TraceError> {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_DST
            | vk::BufferUsageFlags::INDIRECT_BUFFER;
        let size = 4 * (u64::from(WAVE_COUNTS_WORDS) + QUEUES * u64::from(room(slots)));
        Buffer::new(device, "real-time paths", size, usage, MemoryLocation::GpuOnly)
    }

    /// Rounds of the next frame.
    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    /// The steps of the next frame.
    pub fn steps(rounds: u32) -> impl Iterator<Item = (&'static str, Count)> {
        let both = |round| ["walk_left", "shade_left"].map(|name| (name, Count::Round(round)));
        let last = [("finish_left", Count::Round(rounds)), ("trace_left", Count::Left)];
        std::iter::once(("begin_left", Count::Room)).chain((0..rounds).flat_map(both)).chain(last)
    }

    /// Whether paths are to leave waves in the next frame, and one shader is not to follow all.
    pub fn in_waves(&self) -> bool {
        self.quicker.is_first()
    }

    /// Another view: waves are tried.
    pub fn begin_anew(&mut self) {
        self.quicker = Quicker::default();
    }

    /// Records that the counts of a frame, which are written, come to the host.
    pub fn record(&self, commands: vk::CommandBuffer, cell_keys: &Buffer) {
        let copy = [vk::BufferCopy::default().src_offset(4 * COUNTS).size(self.counts.size)];
        // SAFETY: both buffers are alive and large enough; the submit lets the host see what it reads.
        unsafe { self.device.raw.cmd_copy_buffer(commands, cell_keys.handle, self.counts.handle, &copy) };
    }

    /// Learns from a frame of `paths`, which is over and took `ms` milliseconds for them, if that is known; in waves, or by one shader.
    pub fn learn(&mut self, paths: u32, in_waves: bool, ms: Option<f64>) {
        if in_waves {
            let [left, _, _, _, begun, last_round]: [u32; COUNTED] =
                bytemuck::pod_read_unaligned(&self.counts.mapped()[..4 * COUNTED]);
            self.rounds = rounds_after(self.rounds, left, begun, last_round);
            if f64::from(left) < MOST * f64::from(paths) {
                self.begin_anew();
                return;
            }
            // Where rounds were too few the next frame tells more.
            if begun < left {
                return;
            }
        }
        if let Some(ms) = ms {
            self.quicker.learn(in_waves, ms);
        }
    }
}

/// Paths that have room in the last three of the ten rows of 8 bytes that each slot of the scratch memory has.
fn room(slots: u32) -> u32 {
    (3 * slots).saturating_sub(1) / 2 / ROWS
}

/// Rounds for the next frame, where in `rounds` so many of those that left were begun, the last of them in `last_round`.
fn rounds_after(rounds: u32, left: u32, begun: u32, last_round: u32) -> u32 {
    let until_all_begin = match begun < left {
        true => (u64::from(rounds) * u64::from(left) / u64::from(begun.max(1))) as u32,
        false => last_round,
    };
    until_all_begin.saturating_add(LAST_ROUNDS).min(MOST_ROUNDS)
}

/// Which of two ways is the quicker one. Each is tried once, then the quicker one is taken for some frames, then both are tried again.
#[derive(Clone, Copy, Default)]
struct Quicker {
    first: Option<f64>,
    second: Option<f64>,
    frames: u32,
}

impl Quicker {
    /// Frames after which both are tried again.
    const FRAMES: u32 = 64;

    /// Whether the first is to be taken next.
    fn is_first(&self) -> bool {
        match (self.first, self.second) {
            (None, _) => true,
            (Some(_), None) => false,
            (Some(first), Some(second)) => first <= second,
        }
    }

    fn learn(&mut self, is_first: bool, ms: f64) {
        if let (Some(_), Some(_)) = (self.first, self.second) {
            self.frames += 1;
            if self.frames == Self::FRAMES {
                *self = Self::default();
            }
        } else if is_first {
            self.first = Some(ms);
        } else {
            self.second = Some(ms);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_are_as_many_as_it_takes_until_all_paths_begin_and_some_more() {
        assert_eq!(rounds_after(4, 1000, 5000, 0), LAST_ROUNDS, "all had room");
        assert_eq!(rounds_after(9, 30_000, 30_064, 17), 17 + LAST_ROUNDS);
        // Half of them were begun.
        assert_eq!(rounds_after(10, 40_000, 20_000, 0), 20 + LAST_ROUNDS);
        assert_eq!(rounds_after(MOST_ROUNDS, u32::MAX, 1, 0), MOST_ROUNDS);
    }

    #[test]
    fn the_quicker_way_is_taken_and_both_are_tried_again() {
        for (first, second) in [(3.0, 5.0), (5.0, 3.0)] {
            let mut quicker = Quicker::default();
            let mut taken = Vec::new();
            for _ in 0..2 * (Quicker::FRAMES + 2) {
                let is_first = quicker.is_first();
                taken.push(is_first);
                quicker.learn(is_first, if is_first { first } else { second });
            }
            let (now, later) = taken.split_at(taken.len() / 2);
            assert_eq!(now, later, "then all begins anew");
            assert_eq!(now[..2], [true, false], "each is tried");
            assert!(now[2..].iter().all(|&is_first| is_first == (first < second)));
        }
    }
}
