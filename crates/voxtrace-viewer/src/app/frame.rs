//! What the engine tells, and the frame that shows it.

use super::App;
use crate::engine::{Engine, Event as EngineEvent};
use crate::gpu::Drawing;
use crate::panels;
use crate::session::Command;
use crate::tr;
use std::sync::Arc;

impl App {
    pub(super) fn take_engine_event(&mut self, event: EngineEvent) {
        match event {
            EngineEvent::Picture => {
                if let Some(shown) = self.engine.as_ref().and_then(Engine::shown) {
                    self.status.take(shown);
                }
                let compared = self.engine.as_ref().map(|engine| (engine.other_shown(), engine.differences()));
                (self.status.other, self.status.differences) = compared.unwrap_or_default();
            }
            EngineEvent::Notice(text) => self.session.say(text, false),
            EngineEvent::Failed(error) => {
                self.saving = None;
                self.session.say(tr!("said.tracing_stopped", error = error), true);
            }
            EngineEvent::Stale => self.session.ask(Command::SetScene),
            // The window closes.
            EngineEvent::Gone(_) => {}
            EngineEvent::Moved(device) => {
                self.status.forget_pictures();
                self.instances.push(Arc::clone(device.vulkan()));
                let moved = self.graphics.as_mut().map(|graphics| graphics.move_to(&device));
                if let Some(Err(error)) = moved {
                    self.session.say(error.to_string(), true);
                }
            }
        }
        self.save_film();
    }

    /// Takes what the thread tells that draws.
    pub(super) fn take_drawing(&mut self, drawing: Drawing) {
        let Some(graphics) = &mut self.graphics else { return };
        match (graphics.take(drawing), &self.engine) {
            (Ok(Some(lost)), Some(engine)) => engine.lost(lost),
            (Ok(_), _) => {}
            (Err(error), _) => {
                self.session.say(error.to_string(), true);
                // The next one may do, and says why this one did not.
                graphics.window.request_redraw();
            }
        }
    }

    /// Draws a frame: panels first, since they say where the picture lies. While the last one is being drawn, it waits.
    pub(super) fn draw(&mut self) {
        let Some(graphics) = &mut self.graphics else { return };
        // A window that is minimized has no size on Windows: the picture keeps its own, and with it its film.
        let window = graphics.window.inner_size();
        if window.width == 0 || window.height == 0 {
            graphics.repaint_at = None;
            return;
        }
        if !graphics.is_ready() {
            return;
        }
        self.stopwatch.lap("events");
        if let (Some(engine), Some(shown)) = (&self.engine, &self.status.shown) {
            let (width, height) = self.session.size();
            let step = f64::from(width) * f64::from(height) * f64::from(shown.step_samples.max(1));
            self.status.step_share = (engine.samples_under_way() as f64 / step) as f32;
        }
        self.status.recent = self.settings.settings.recent.iter().map(|path| path.display().to_string()).collect();
        let (session, status) = (&mut self.session, &self.status);
        let mut side = 0.0;
        let frame = graphics.run_panels(|ui| side = panels::show(ui, session, status));
        self.stopwatch.lap("panels");
        let taken = (side * frame.pixels_per_point).round() as u32;
        let below = (self.session.below * frame.pixels_per_point).round() as u32;
        let (width, height) = (window.width.saturating_sub(taken).max(1), window.height.saturating_sub(below).max(1));
        self.session.resize(width, height);
        let shown = self.status.shown.as_ref().filter(|_| self.session.open.is_some());
        let comparison = self.session.comparison.as_ref().filter(|_| shown.is_some());
        let compared = comparison.and_then(|comparison| self.status.compared(comparison));
        graphics.draw(frame, shown, compared, (width, height), self.session.render_settings.tone_map);
        if let Some(shown) = shown {
            self.stopwatch.picture(shown.scale == 1, shown.lit.is_some());
        }
        self.note_layout();
        self.stopwatch.lap("handing over");
    }
}
