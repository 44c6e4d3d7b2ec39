//! Carrying out what the state asks for.

use super::App;
use super::saving::Saving;
use super::wake::Wake;
use crate::benchmark::Benchmark;
use crate::session::{Command, Leaving};
use crate::tr;
use std::sync::Arc;
use winit::event_loop::ActiveEventLoop;
use winit::window::Fullscreen;

impl App {
    /// Does what the state asks for.
    pub(super) fn carry_out(&mut self, event_loop: &ActiveEventLoop) {
        self.stopwatch.lap("events");
        for command in self.session.take_commands() {
            let (Some(graphics), Some(engine)) = (&mut self.graphics, &self.engine) else { return };
            match command {
                Command::Load(source) => {
                    if self.session.may_leave(Leaving::Load(source.clone())) {
                        self.load(&source);
                    }
                }
                Command::New(size) => {
                    if self.session.may_leave(Leaving::New(size)) {
                        self.session.show_new(size);
                    }
                }
                Command::Edit => {
                    let wake = self.wake_by(|| Wake::Edited);
                    self.session.start_editor(wake);
                }
                Command::Follow(followed) => engine.follow(followed.0),
                Command::LoadAgain => self.load_again(),
                Command::Reshape => {
                    let (wake, loader) = (self.wake(), Arc::clone(&self.loader));
                    self.session.reshape(&loader, wake);
                }
                Command::CompareWith(other) => {
                    engine.compare_with(other);
                    (self.status.other, self.status.differences) = (None, None);
                }
                Command::SetContrast(contrast) => {
                    engine.set_contrast(contrast);
                    self.status.differences = None;
                }
                Command::SetLight(light) => engine.set_light(light),
                Command::Benchmark => self.measure(),
                Command::ReadValues => self.read_values(),
                Command::SetScene => {
                    self.session.settle_edits();
                    let lit = self.session.open.as_ref().map(|open| Arc::clone(&open.lit));
                    match lit {
                        Some(lit) if self.session.has_motion() => engine.move_scene(lit),
                        lit => engine.set_scene(lit),
                    }
                    self.status.times.clear();
                }
                Command::MakeSky => {
                    let wake = self.wake_by(|| Wake::Sky);
                    self.session.make_sky(wake);
                }
                Command::Surround => {
                    let wake = self.wake_by(|| Wake::Surroundings);
                    self.session.make_surroundings(wake);
                }
                Command::SetBackend(backend) => {
                    engine.set_backend(backend);
                    self.status.times.clear();
                }
                Command::SetView => engine.set_view(self.session.view(), self.session.is_moving()),
                Command::Pause(is_paused) => engine.pause(is_paused),
                Command::Copy(text) => graphics.egui.set_clipboard_text(text),
                Command::Print(text) => println!("{}", text.trim_end()),
                Command::Save(path) => self.saving = Some(Saving::new(path)),
                Command::Export(request) => self.export(*request),
                Command::Run(request) => self.run_beside(*request),
                Command::SaveScene(path) => self.save_scene(path),
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
            }
        }
        if let Some(graphics) = &self.graphics {
            graphics.window.request_redraw();
        }
        self.stopwatch.lap("commands");
    }

    /// Begins to measure the view.
    fn measure(&mut self) {
        let device = self.graphics.as_ref().map(|graphics| graphics.device().info().name.clone());
        let Some(subject) = self.session.bench_subject(device) else { return };
        self.session.benchmark = Some(Benchmark::start(subject, self.wake()));
    }

    /// Closes the window. Where that would end work under way, only when asked twice.
    pub(super) fn quit(&mut self, event_loop: &ActiveEventLoop) {
        let is_busy =
            self.session.exporting.is_some() || self.session.saving_scene.is_some() || self.session.running.is_some();
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
