//! Whether views are shown in real-time light while they move, and why not.

use crate::engine::{Light, RealTimeChoice};
use crate::session::{Command, Session};
use crate::tr;
use voxtrace::Integrator;
use voxtrace_vulkan::Traversal;

impl Session {
    /// Whether views are to be shown in real-time light where that can be.
    pub fn wants_real_time(&self) -> bool {
        match self.light.real_time {
            RealTimeChoice::Off => false,
            RealTimeChoice::Auto => self.has_hardware,
            RealTimeChoice::On => true,
        }
    }

    /// Why no view can be shown in it, for people; `None` where they can.
    pub fn no_real_time(&self) -> Option<&'static str> {
        if self.render_settings.traversal == Traversal::Cpu {
            Some(tr!("real_time.not_on_the_processor"))
        } else if self.render_settings.integrator == Integrator::Essay {
            Some(tr!("real_time.not_with_essay"))
        } else if self.comparison.is_some() {
            Some(tr!("real_time.not_compared"))
        } else {
            None
        }
    }

    /// Shows views in another light.
    pub fn set_light(&mut self, light: Light) {
        if light != self.light {
            self.light = light;
            self.ask(Command::SetLight(light));
        }
    }

    /// Shows views that move in real-time light, or no more.
    pub fn toggle_real_time(&mut self) {
        let real_time = match (self.wants_real_time(), self.has_hardware) {
            (true, _) => RealTimeChoice::Off,
            (false, true) => RealTimeChoice::Auto,
            (false, false) => RealTimeChoice::On,
        };
        self.set_light(Light { real_time, ..self.light });
        let on = self.wants_real_time();
        let text = if on { tr!("real_time.said_on") } else { tr!("real_time.said_off") };
        self.say(self.no_real_time().filter(|_| on).unwrap_or(text), false);
    }

    /// Shows the film of a view that stands at once, or when it is clean.
    pub fn toggle_bare_film(&mut self) {
        self.set_light(Light { is_bare: !self.light.is_bare, ..self.light });
        self.say(if self.light.is_bare { tr!("real_time.said_bare") } else { tr!("real_time.said_over") }, false);
    }
}
