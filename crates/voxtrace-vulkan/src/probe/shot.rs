//! Rays that a probe casts, what their shaders report, and what comes back.

use crate::buffer::Buffer;
use crate::records::{ProbeAnswer, ProbeRay};

/// What intersection shaders report for a candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Reports {
    /// Nothing.
    Nothing = 0,
    /// Where the ray enters the box.
    Exact = 1,
    /// The distance of the box's centre, whether or not the ray meets the box.
    Centre = 2,
    /// As exact; where the report is refused the attribute of the last accepted one is put back.
    Restoring = 3,
}

/// `RAY_FLAG_FORCE_OPAQUE`: no any-hit shader decides.
pub const OPAQUE: u32 = 1;

/// A ray from `origin`, opaque, without end.
pub fn ray(origin: impl Into<[f32; 3]>, direction: impl Into<[f32; 3]>) -> ProbeRay {
    ProbeRay {
        origin: origin.into(),
        direction: direction.into(),
        t_max: 1e6,
        flags: OPAQUE,
        mask: 0xff,
        ..ProbeRay::default()
    }
}

/// What rays met.
pub struct Answers {
    pub answers: Vec<ProbeAnswer>,
    pub(super) log: Vec<u32>,
    pub(super) capacity: usize,
}

impl Answers {
    /// The candidates of a ray, in the order they came, as far as there was room.
    pub fn candidates(&self, ray: usize) -> &[u32] {
        let count = (self.answers[ray].candidates as usize).min(self.capacity);
        &self.log[ray * self.capacity..][..count]
    }

    /// Whether all candidates of a ray had room.
    pub fn is_whole(&self, ray: usize) -> bool {
        self.answers[ray].candidates as usize <= self.capacity
    }
}

/// Rays on the device, and room for what they meet.
pub struct Shot {
    // The memory behind the binding.
    pub(super) _rays: Buffer,
    pub(super) answers: Buffer,
    pub(super) log: Buffer,
    pub(super) count: usize,
    pub(super) capacity: usize,
}
