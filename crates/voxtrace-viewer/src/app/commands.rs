//! Carrying out what the state asks for.

use super::App;
use super::wake::Wake;
use crate::benchmark::Benchmark;
use crate::load::Loading;
use crate::session::Command;
use std::path::Path;
use std::sync::Arc;
use voxtrace::scenes;
use winit::event_loop::ActiveEventLoop;
use winit::window::Fullscreen;

impl App {
    /// Does what the state asks for.
    pub(super) fn carry_out(&mut self, event_loop: &ActiveEventLoop) {
        for command in self.session.take_commands() {
            let (Some(graphics), Some(engine)) = (&mut self.graphics, &self.engine) else { return };
            match command {
                Command::Load(source) => self.load(&source),
                Command::LoadAgain => self.load_again(),
                Command::CompareWith(other) => {
                    engine.compare_with(other);
                    (self.status.other, self.status.differences) = (None, None);
                }
                Command::SetContrast(contrast) => {
                    engine.set_contrast(contrast);
                    self.status.differences = None;
                }
                Command::Benchmark => self.measure(),
                Command::SetScene => {
                    engine.set_scene(self.session.open.as_ref().map(|open| Arc::clone(&open.lit)));
                    self.status.times.clear();
                }
                Command::SetBackend(backend) => {
                    engine.set_backend(backend);
                    self.status.times.clear();
                }
                Command::SetView => engine.set_view(self.session.view(), self.session.is_moving()),
                Command::Pause(is_paused) => engine.pause(is_paused),
                Command::Copy(text) => graphics.egui.set_clipboard_text(text),
                Command::Print(text) => println!("{}", text.trim_end()),
                Command::Save(path) => self.saving = Some((path, engine.film())),
                Command::AskForFile => self.ask_for_file(),
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
                Command::Quit => event_loop.exit(),
            }
        }
        if let Some(graphics) = &self.graphics {
            graphics.window.request_redraw();
        }
    }

    /// Shows the system's dialog; what is chosen there is opened when it comes.
    fn ask_for_file(&mut self) {
        let Some(graphics) = &self.graphics else { return };
        let dialog = rfd::AsyncFileDialog::new().set_title("Open a scene").set_parent(&*graphics.window).pick_file();
        let proxy = self.proxy.clone();
        // Dialogs are made on this thread, as some systems want it, and waited for on another.
        std::thread::spawn(move || {
            let chosen = pollster::block_on(dialog).map(|file| file.path().to_path_buf());
            let _ = proxy.send_event(Wake::Chosen(chosen));
        });
    }

    /// Begins to open a scene; the one that is shown stays until it is there.
    fn load(&mut self, source: &str) {
        let source = match scenes::NAMES.contains(&source) {
            true => source.to_owned(),
            false => std::path::absolute(source).map_or(source.to_owned(), |path| path.display().to_string()),
        };
        self.session.loading = Some(Loading::start(&self.loader, &source, None, self.wake()));
    }

    /// Reads the scene again, with what its file hides and somebody wants to see.
    fn load_again(&mut self) {
        let Some(open) = &self.session.open else { return };
        let (_, shown) = open.changes();
        self.session.loading = Some(Loading::start(&self.loader, &open.source, Some(shown), self.wake()));
    }

    /// Begins to measure the view.
    fn measure(&mut self) {
        let device = self.graphics.as_ref().map(|graphics| graphics.device().info().name.clone());
        let Some(subject) = self.session.bench_subject(device) else { return };
        self.session.benchmark = Some(Benchmark::start(subject, self.wake()));
    }

    /// Wakes the window from another thread.
    fn wake(&self) -> Arc<dyn Fn() + Send + Sync> {
        let proxy = self.proxy.clone();
        Arc::new(move || {
            // The window may be closed.
            let _ = proxy.send_event(Wake::Loading);
        })
    }

    /// Takes a scene that has come.
    pub(super) fn take_loaded(&mut self) {
        self.session.take_measured();
        let before = self.session.open.as_ref().map(|open| Arc::as_ptr(&open.original));
        self.session.take_loaded();
        let Some(open) = &self.session.open else { return };
        if before == Some(Arc::as_ptr(&open.original)) {
            return;
        }
        if let Some(graphics) = &self.graphics {
            graphics.window.set_title(&format!("{} – voxtrace", open.original.name));
        }
        if !scenes::NAMES.contains(&open.source.as_str()) {
            self.settings.settings.add_recent(Path::new(&open.source));
            self.save_settings();
        }
    }

    pub(super) fn save_settings(&mut self) {
        if let Err(error) = self.settings.save() {
            self.session.say(format!("the settings cannot be kept: {error}"), true);
        }
    }

    /// As [`Self::carry_out`], and draws only where something was to be done.
    pub(super) fn carry_out_without_redraw(&mut self, event_loop: &ActiveEventLoop) {
        if self.session.has_commands() {
            self.carry_out(event_loop);
        }
    }
}
