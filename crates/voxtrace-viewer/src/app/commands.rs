//! Carrying out what the state asks for.

use super::App;
use super::saving::Saving;
use super::wake::wake_by;
use crate::session::{Command, Leaving, Means};
use crate::tr;
use std::io::Write;
use std::sync::Arc;
use winit::event_loop::ActiveEventLoop;
use winit::window::Fullscreen;

impl App {
    /// Does what the state asks for.
    pub(super) fn carry_out(&mut self, event_loop: &ActiveEventLoop) {
        self.stopwatch.lap("events");
        for command in self.session.take_commands() {
            let (Some(graphics), Some(engine)) = (&mut self.graphics, &self.engine) else { return };
            self.may_quit &= !matches!(command, Command::Run(_) | Command::Export(_) | Command::SaveScene(_));
            let proxy = self.proxy.clone();
            let wake = move |news| wake_by(&proxy, news);
            let (loader, device) = (&self.loader, &Arc::clone(graphics.device()));
            let mut means = Means { engine, loader, status: &mut self.status, device, wake: &wake };
            let Some(command) = self.session.carry_out(command, &mut means) else { continue };
            match command {
                Command::Copy(text) => graphics.egui.set_clipboard_text(text),
                // The terminal may be closed by now.
                Command::Print(text) => _ = writeln!(std::io::stdout(), "{}", text.trim_end()),
                Command::Save(path) => self.saving = Some(Saving::new(path)),
                Command::SetDevice(name) => self.set_device(name),
                Command::AskForFile => self.ask_for_file(),
                Command::AskForPath => self.ask_for_path(),
                Command::ToggleFullscreen => {
                    let is_full = graphics.window.fullscreen().is_some();
                    graphics.window.set_fullscreen((!is_full).then_some(Fullscreen::Borderless(None)));
                }
                Command::LeaveFullscreen => graphics.window.set_fullscreen(None),
                Command::Scale(step) => {
                    let scale = (self.settings.settings.ui_scale + 0.1 * f32::from(step)).clamp(0.5, 3.0);
                    self.settings.settings.ui_scale = scale;
                    graphics.egui.egui_ctx().set_zoom_factor(scale);
                }
                Command::Quit => self.quit(event_loop),
                // The state did it.
                _ => {}
            }
        }
        if let Some(graphics) = &self.graphics {
            graphics.window.request_redraw();
        }
        self.stopwatch.lap("commands");
    }

    /// Closes the window. Where that would end work under way, only when asked twice.
    pub(super) fn quit(&mut self, event_loop: &ActiveEventLoop) {
        let is_busy =
            self.session.exporting.is_some() || self.session.writing.is_some() || self.session.running.is_some();
        if !self.session.may_leave(Leaving::Quit) {
            return;
        }
        if is_busy && !std::mem::replace(&mut self.may_quit, true) {
            self.session.say(tr!("said.a_file_is_being_made_close"), false);
            return;
        }
        event_loop.exit();
    }

    pub(super) fn save_settings(&mut self) {
        self.settings.settings.theme = self.session.theme.name().to_owned();
        self.settings.settings.real_time = self.session.light.real_time.name().to_owned();
        self.settings.settings.bare_film = self.session.light.is_bare;
        self.settings.settings.language.clone_from(&self.session.language);
        if let Err(error) = self.settings.save() {
            self.session.say(tr!("said.the_settings_cannot_be_kept", error = error), true);
        }
    }

    /// As [`Self::carry_out`], and draws only where something was to be done.
    pub(super) fn carry_out_without_redraw(&mut self, event_loop: &ActiveEventLoop) {
        if self.session.has_commands() {
            self.carry_out(event_loop);
        }
    }
}
