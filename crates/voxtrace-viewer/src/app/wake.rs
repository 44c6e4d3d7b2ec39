//! What wakes the event loop from other threads.

use crate::engine::Event as EngineEvent;
use crate::gamepad::PadEvent;
use crate::gpu::Drawing;
use crate::panels::DeviceChoice;
use crate::session::{News, Waker};
use std::path::PathBuf;
use std::sync::Arc;
use winit::event_loop::EventLoopProxy;

/// What wakes the event loop.
#[derive(Debug)]
pub enum Wake {
    Engine(WakeEngine),
    Drawing(WakeDrawing),
    /// A thread of the state has something to tell.
    News(News),
    /// The system's dialog for a scene to open was answered, so soon that it cannot have been shown if `is_quick`.
    Chosen {
        path: Option<PathBuf>,
        is_quick: bool,
    },
    /// The same of the dialog for a path.
    ChosenPath {
        path: Option<PathBuf>,
        is_quick: bool,
    },
    /// Edits cannot be kept, and why.
    Unkept(String),
    /// What a gamepad tells.
    Pad(PadEvent),
    /// The devices of this machine.
    Devices(Vec<DeviceChoice>),
    Accessibility(egui_winit::accesskit_winit::Event),
}

/// An event of the engine that can be printed.
pub struct WakeEngine(pub EngineEvent);

impl std::fmt::Debug for WakeEngine {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("WakeEngine")
    }
}

/// What the thread that draws tells, and that can be printed.
pub struct WakeDrawing(pub Drawing);

impl std::fmt::Debug for WakeDrawing {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("WakeDrawing")
    }
}

impl From<egui_winit::accesskit_winit::Event> for Wake {
    fn from(event: egui_winit::accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}

/// Wakes the window from another thread with what it has to tell.
pub fn wake_by(proxy: &EventLoopProxy<Wake>, news: News) -> Waker {
    let proxy = proxy.clone();
    Arc::new(move || {
        // The window may be closed.
        let _ = proxy.send_event(Wake::News(news));
    })
}
