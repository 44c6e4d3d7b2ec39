//! Rendering in waves, where that is quicker.

use super::Worker;
use crate::capabilities::DeviceKind;
use crate::variant::{Entry, Variant};
use crate::waves::{LEAST_PATHS, LEAST_QUICK_PATHS, MOST_PATHS, STEPS, Waves};
use voxtrace_core::TraceError;

impl Worker {
    /// Least and most paths of a wave.
    fn paths_of_waves(&self) -> (u32, u32) {
        // In software more shaders only take longer to compile.
        let is_software = self.device.info().kind == DeviceKind::Cpu;
        match self.most_paths {
            Some(most) => (1, most),
            None if is_software => (1, 0),
            None if self.settings.is_exact => (LEAST_PATHS, MOST_PATHS),
            None => (LEAST_QUICK_PATHS, MOST_PATHS),
        }
    }

    /// Sets the most paths of a wave, `None` for what suits the device. Nothing may be in flight.
    pub fn set_most_paths(&mut self, most_paths: Option<u32>) {
        self.most_paths = most_paths;
        self.drop_waves();
    }

    /// Gives the memory of paths back. Nothing may be in flight.
    pub(super) fn drop_waves(&mut self) {
        if let Some(waves) = self.waves.take() {
            waves.unbind(&self.bindings, &self.nothing);
        }
    }

    /// The variant that renders so many samples in waves, ready to run: `None` where one shader does it, as it is quicker, waves do not know what the
    /// scene has, or there is no memory for them. Nothing may be in flight.
    pub(super) fn prepare_waves(&mut self, variant: Variant, samples: u64) -> Result<Option<Variant>, TraceError> {
        let is_known = variant.entry == Entry::RenderPath && !variant.has_catcher && !variant.has_pages;
        if !is_known || self.wave_passes.is_none() {
            self.drop_waves();
            return Ok(None);
        }
        if self.waves.as_ref().is_some_and(|waves| !waves.suits(variant)) {
            self.drop_waves();
        }
        let (least, most) = self.paths_of_waves();
        let wanted = samples.min(most.into()) as u32;
        if wanted < least {
            return Ok(None);
        }
        let held = self.waves.as_ref().map_or((0, 0), |waves| (waves.capacity(), waves.bytes()));
        if held.0 < wanted {
            let capacity = wanted.min(Waves::room_on(&self.device, variant, held.1));
            if capacity < least {
                return Ok(None);
            }
            // Not anew for the little that other memory comes and goes.
            if held.0 < capacity && (capacity == wanted || capacity / 5 * 4 > held.0) {
                self.drop_waves();
                let waves = match Waves::new(&self.device, variant, capacity) {
                    Err(TraceError::OutOfMemory { .. }) => return Ok(None),
                    waves => waves?,
                };
                waves.bind(&self.bindings);
                self.waves = Some(waves);
            }
        }
        if let Some(passes) = &mut self.wave_passes {
            for name in STEPS.into_iter().filter(|name| self.left_out != Some(*name)) {
                passes.prepare(variant.step(name))?;
            }
        }
        Ok(Some(variant.step(STEPS[0])))
    }
}
