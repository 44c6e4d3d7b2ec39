//! Waiting for a device: never without end. One whose work does not end is given up, and counts as lost.

use super::Device;
use crate::capabilities::DeviceKind;
use ash::vk;
use std::sync::PoisonError;
use std::time::Duration;

/// The host never waits longer than this in one call.
const WAIT_SLICE: Duration = Duration::from_secs(1);
/// So many times it waits for a submit: those that trace take a fraction of a second, and building acceleration structures for a large scene takes seconds.
const WAITS: u32 = 60;
/// The same in software, which compiles shaders on first use and takes long for everything.
const WAITS_IN_SOFTWARE: u32 = 300;

impl Device {
    /// Gives the device up after it was waited for so long. Its work may never end: nobody waits for that, and what it uses is not freed.
    fn give_up(&self, waited: Duration) {
        let _ = self.hung.set(waited);
    }

    /// How long it was waited for where it was given up, else `None`.
    pub(crate) fn hung(&self) -> Option<Duration> {
        self.hung.get().copied()
    }

    /// Whether the device was given up, as its work did not end. It may still use all that was made on it, which has to stay.
    pub fn is_given_up(&self) -> bool {
        self.hung().is_some()
    }

    /// Waits by calls that take a limit, nanoseconds, so that a device that hangs is given up in the end, and counts as lost: at once, where somebody
    /// else has found that. The calls are counted, as clocks go on while a machine sleeps or the program is stopped.
    pub(crate) fn wait_in_slices(&self, wait: impl Fn(u64) -> Result<(), vk::Result>) -> Result<(), vk::Result> {
        let waits = if self.info.kind == DeviceKind::Cpu { WAITS_IN_SOFTWARE } else { WAITS };
        for _ in 0..waits {
            if self.is_given_up() {
                return Err(vk::Result::ERROR_DEVICE_LOST);
            }
            match wait(WAIT_SLICE.as_nanos() as u64) {
                Err(vk::Result::TIMEOUT) => {}
                result => return result,
            }
        }
        self.give_up(waits * WAIT_SLICE);
        Err(vk::Result::ERROR_DEVICE_LOST)
    }

    /// Waits until all of the fences are signaled. A device that hangs is given up then, and counts as lost.
    ///
    /// # Errors
    /// What the driver answers.
    ///
    /// # Safety
    /// They must be fences of this device, at least one, and signaled or submitted.
    #[doc(hidden)]
    pub unsafe fn wait_for_fences(&self, fences: &[vk::Fence]) -> Result<(), vk::Result> {
        // SAFETY: as the caller says.
        self.wait_in_slices(|limit| unsafe { self.raw.wait_for_fences(fences, true, limit) })
    }

    /// Waits until a queue does nothing. A device that hangs is given up then, and counts as lost. Of one that is lost the queues do nothing.
    ///
    /// # Errors
    /// What the driver answers.
    ///
    /// # Safety
    /// It must be a queue of this device that the caller has locked.
    #[doc(hidden)]
    pub unsafe fn wait_for_queue(&self, queue: vk::Queue) -> Result<(), vk::Result> {
        if self.is_given_up() {
            return Err(vk::Result::ERROR_DEVICE_LOST);
        }
        // The driver's own wait for a queue has no limit: a fence behind all that was submitted tells whether it would end.
        // SAFETY: the device is alive, and the queue locked; null handles are destroyed in vain.
        unsafe {
            let fence = self.raw.create_fence(&vk::FenceCreateInfo::default(), None).unwrap_or_default();
            if fence != vk::Fence::null() && self.raw.queue_submit(queue, &[], fence).is_ok() {
                let _ = self.wait_for_fences(&[fence]);
            }
            if self.is_given_up() {
                // The fence stays as well.
                return Err(vk::Result::ERROR_DEVICE_LOST);
            }
            // Now there is nothing to wait for but what is being shown; or the device is lost, where no wait lasts; or there is no memory for a fence.
            let waited = self.raw.queue_wait_idle(queue);
            self.raw.destroy_fence(fence, None);
            waited
        }
    }

    /// Waits until the queue that shows pictures does nothing. What traces goes on where it has a queue of its own. Returns whether it is so:
    /// of a device that [was given up](Self::is_given_up) that queue may hang as well, and what it uses has to stay.
    pub fn wait_presented(&self) -> bool {
        let queue = self.present_queue();
        // An error means that the device is lost: then it does nothing either.
        // SAFETY: the queue is locked.
        let _ = unsafe { self.wait_for_queue(*queue) };
        !self.is_given_up() || *self.is_still.get_or_init(|| self.present_queue.is_some() && self.is_done(*queue))
    }

    /// Whether all that was submitted to a queue of a device that was given up, which is locked, is over all the same.
    fn is_done(&self, queue: vk::Queue) -> bool {
        // SAFETY: the device is alive, and the queue locked; a fence that is submitted and not signaled stays.
        unsafe {
            let Ok(fence) = self.raw.create_fence(&vk::FenceCreateInfo::default(), None) else { return false };
            let is_submitted = self.raw.queue_submit(queue, &[], fence).is_ok();
            let is_done =
                is_submitted && self.raw.wait_for_fences(&[fence], true, WAIT_SLICE.as_nanos() as u64).is_ok();
            if is_done || !is_submitted {
                self.raw.destroy_fence(fence, None);
            }
            is_done
        }
    }

    /// Waits until the device does nothing, unless it [was given up](Self::is_given_up).
    pub fn wait_idle(&self) {
        let tracing = self.queue();
        let presenting = self.present_queue.as_ref().map(|queue| queue.lock().unwrap_or_else(PoisonError::into_inner));
        for queue in std::iter::once(&tracing).chain(&presenting) {
            // An error means that the device is lost: then it does nothing either.
            // SAFETY: the queue is locked.
            let _ = unsafe { self.wait_for_queue(**queue) };
        }
    }
}
