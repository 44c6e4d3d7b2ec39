//! What the thread that traces does when the device fails: it opens a lost one anew and goes on with the film as far as it was kept,
//! and where the device lacks memory, say, the processor stands in.

use super::Worker;
use crate::engine::Event;
use crate::memory;
use crate::tr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::TraceError;
use voxtrace_vulkan::Device;

/// A device that is lost so often within so short a time is given up.
const LOSSES: usize = 5;
const WITHIN: Duration = Duration::from_secs(10);

impl Worker {
    /// Goes on after an error of a side, with the processor where a device failed, or says that nothing goes on.
    pub(super) fn go_on_after(&mut self, index: usize, error: TraceError) {
        let is_of_device = matches!(error, TraceError::OutOfMemory { .. } | TraceError::Device { .. });
        let side = &mut self.sides[index];
        if side.makes_room_for(&error) {
            return;
        }
        if !is_of_device || !side.is_on_device() {
            self.has_failed = true;
            (self.tell)(Event::Failed(error));
            return;
        }
        side.stand_in();
        (self.tell)(Event::Notice(tr!("said.processor_instead", error = error)));
        self.forget_differences();
    }

    /// Goes on after whoever shows pictures found `lost` to be lost.
    pub(super) fn lost(&mut self, lost: &Arc<Device>) {
        // What traces may have noticed first, and moved.
        if !Arc::ptr_eq(lost, &self.device) {
            return;
        }
        if let Err(error) = self.recover(lost) {
            (self.tell)(Event::Gone(error));
        }
    }

    fn recover(&mut self, lost: &Arc<Device>) -> Result<(), TraceError> {
        self.losses.push_back(Instant::now());
        if self.losses.len() > LOSSES && self.losses.pop_front().is_some_and(|first| first.elapsed() < WITHIN) {
            return Err(TraceError::DeviceLost { last_pass: "showing frames, again and again".into() });
        }
        let mut reopened = None;
        for side in &mut self.sides {
            // One device for all: a second tracer on the lost one begins anew on that of the first.
            if reopened.is_none() {
                reopened = side.recover(lost)?;
                side.notes.drain(..).for_each(|note| (self.tell)(Event::Notice(note)));
            }
        }
        let device = match reopened {
            Some(device) => device,
            None => {
                (self.tell)(Event::Notice(tr!("said.lost", name = lost.info().name)));
                lost.reopened()?
            }
        };
        self.moved(device);
        memory::give_back();
        Ok(())
    }
}
