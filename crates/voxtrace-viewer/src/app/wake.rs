//! What wakes the event loop from other threads.

use crate::engine::Event as EngineEvent;
use std::path::PathBuf;

/// What wakes the event loop.
#[derive(Debug)]
pub enum Wake {
    Engine(WakeEngine),
    Loading,
    Chosen(Option<PathBuf>),
    Accessibility(egui_winit::accesskit_winit::Event),
}

/// An event of the engine that can be printed.
pub struct WakeEngine(pub EngineEvent);

impl std::fmt::Debug for WakeEngine {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("WakeEngine")
    }
}

impl From<egui_winit::accesskit_winit::Event> for Wake {
    fn from(event: egui_winit::accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}
