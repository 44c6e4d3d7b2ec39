//! The window with its state, wired as `app` wires it: commands are carried out, threads are listened to, frames are drawn.

use super::common::headless::Headless;
use super::files::{Files, files};
use super::turn::{Longest, Turn};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::Integrator;
use voxtrace::glam::Vec2;
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};
use voxtrace_viewer::Loader;
use voxtrace_viewer::dialogs::{Dialog, OpenDialog};
use voxtrace_viewer::engine::{FilmAnswer, Light, RealTimeChoice};
use voxtrace_viewer::gpu::{Beside, Layer, Panels};
use voxtrace_viewer::input::Input;
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::panels::{self, Compared, Status};
use voxtrace_viewer::session::{Command, Leaving, Means, Session};
use voxtrace_vulkan::Traversal;

/// Nothing to be woken: each turn looks.
fn nobody() -> Arc<dyn Fn() + Send + Sync> {
    Arc::new(|| {})
}

/// The window with its state, as `app` has it.
pub struct App {
    pub window: Headless,
    pub session: Session,
    pub input: Input,
    /// What the panels are told of mouse and keys with the next frame.
    pub to_panels: Vec<egui::Event>,
    status: Status,
    context: egui::Context,
    loader: Arc<dyn Loader>,
    pub size: (u32, u32),
    saving: Option<(PathBuf, FilmAnswer)>,
    pub files: Vec<String>,
    folder: PathBuf,
    start: Instant,
    last: Instant,
    pub saved: u64,
    /// Pictures in real-time light.
    pub lit: u64,
    /// The turn of the thread that took longest by itself.
    pub longest: Longest,
}

impl App {
    /// In real-time light, or by the processor first.
    pub fn open(folder: &Path, in_real_time: bool) -> Option<Self> {
        let size = (640, 420);
        let traversal = if in_real_time { Traversal::Walk } else { Traversal::Cpu };
        let mut session = Session::new(traversal);
        let window = Headless::open(session.backend(), size)?;
        session.traversals = vec![Traversal::Cpu, Traversal::Walk, Traversal::Query];
        session.settings_folder = Some(folder.to_path_buf());
        // Its device is software, on which the key alone turns real-time light on.
        session.has_hardware = false;
        if in_real_time {
            session.toggle_real_time();
        }
        let loader: Arc<dyn Loader> = Arc::new(Files);
        let status = Status { built_in: loader.built_in(), ..Status::default() };
        let (files, folder) = (files(folder), folder.to_path_buf());
        let (input, context, now) = (Input::default(), egui::Context::default(), Instant::now());
        Some(Self {
            window,
            session,
            input,
            to_panels: Vec::new(),
            status,
            context,
            loader,
            size,
            saving: None,
            files,
            folder,
            start: now,
            last: now,
            saved: 0,
            lit: 0,
            longest: Longest::default(),
        })
    }

    fn carry_out(&mut self) {
        for command in self.session.take_commands() {
            self.window.is_due = true;
            let device = Arc::clone(self.window.screen.device());
            let (engine, loader, status) = (&self.window.engine, &self.loader, &mut self.status);
            let mut means = Means { engine, loader, status, device: &device, wake: &|_| nobody() };
            match self.session.carry_out(command, &mut means) {
                Some(Command::Save(_)) => self.saving = Some((self.folder.join("picture.png"), engine.film())),
                Some(Command::AskForFile) => self.session.dialog = Some(Dialog::Open(OpenDialog::new(&self.session))),
                // It stays open, but not with edits that somebody is asked about.
                Some(Command::Quit) => _ = self.session.may_leave(Leaving::Quit),
                _ => {}
            }
        }
    }

    /// Takes what threads have told.
    fn listen(&mut self) {
        let session = &mut self.session;
        session.take_loaded();
        session.take_reshaped();
        session.take_measured();
        session.take_running();
        session.take_exported();
        session.take_edited();
        session.take_sky();
        session.take_surroundings();
        session.take_written();
    }

    /// Writes a film that has come.
    fn save(&mut self) {
        let Some((path, answer)) = self.saving.take() else { return };
        match answer.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => self.saving = Some((path, answer)),
            Ok(Some((frame, film))) => {
                if let Some(open) = &self.session.open {
                    let file = FilmFile { frame, scene: SceneStamp::of(&open.lit), film };
                    // As the window does, on a thread of its own.
                    std::thread::spawn(move || file.save_picture(&path, &PictureOptions::default()).unwrap());
                    self.saved += 1;
                }
            }
            _ => {}
        }
    }

    pub fn turn(&mut self) {
        let seconds = self.last.elapsed().as_secs_f32();
        self.last = Instant::now();
        self.timed("the turn", |app| {
            app.session.advance(seconds);
            app.listen();
            app.carry_out();
            app.save();
            app.show();
        });
        if let Some(told) = self.window.wait(Duration::from_millis(4)) {
            self.timed("taking what is told", |app| app.window.take_all(told));
        }
        let device = self.window.screen.device();
        let is_here = |picture: &Arc<voxtrace_vulkan::Picture>| Arc::ptr_eq(picture.device(), device);
        self.status.shown = self.status.shown.take().filter(|shown| is_here(&shown.picture));
        self.status.other = self.status.other.take().filter(|shown| is_here(&shown.picture));
        self.status.differences = self.status.differences.take().filter(|shown| is_here(&shown.picture));
    }

    /// Takes the newest picture, and draws.
    fn show(&mut self) {
        if let Some(shown) = self.window.engine.shown().filter(|_| self.window.is_due) {
            self.lit += u64::from(shown.lit.is_some());
            self.status.take(shown);
            self.status.other = self.window.engine.other_shown();
            self.status.differences = self.window.engine.differences();
        }
        if self.size.0 > 0 {
            self.draw();
        }
    }

    /// Does something, and notes how long it takes by itself.
    fn timed(&mut self, what: &str, part: impl FnOnce(&mut Self)) {
        let turn = Turn::begin();
        part(self);
        self.note(&turn, self.start.elapsed(), what);
    }

    fn draw(&mut self) {
        let (session, status, size) = (&mut self.session, &self.status, self.size);
        let compared = session.comparison.as_ref().and_then(|comparison| status.compared(comparison));
        let (width, height) = session.size();
        let layer = status.shown.as_ref().filter(|_| session.open.is_some()).map(|shown| {
            let (mut picture, mut beside) = (Arc::clone(&shown.picture), None);
            let size = [width as f32, height as f32];
            match compared {
                Some(Compared::Differences(differences)) => picture = Arc::clone(&differences.picture),
                Some(Compared::Beside(other, split)) => {
                    beside = Some(Beside { picture: Arc::clone(&other.picture), size, split: split * size[0] });
                }
                None => {}
            }
            Layer { picture, corner: [0.0; 2], size, tone_map: session.render_settings.tone_map, beside }
        });
        let (context, events) = (&self.context, &mut self.to_panels);
        let time = Some(self.start.elapsed().as_secs_f64());
        self.window.draw(layer, || {
            let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(size.0 as f32, size.1 as f32));
            let events = std::mem::take(events);
            let input = egui::RawInput { screen_rect: Some(screen), time, events, ..egui::RawInput::default() };
            let mut side = 0.0;
            let output = context.run_ui(input, |ui| side = panels::show(ui, session, status));
            let below = session.below;
            session.resize(size.0.saturating_sub(side as u32).max(1), size.1.saturating_sub(below as u32).max(1));
            let primitives = context.tessellate(output.shapes, output.pixels_per_point);
            Panels { textures: output.textures_delta, primitives, pixels_per_point: output.pixels_per_point }
        });
    }

    /// Turns real-time light on again, and all that stands in its way off.
    pub fn light_again(&mut self) {
        let session = &mut self.session;
        let mut settings = session.render_settings.clone();
        (settings.traversal, settings.integrator) = (Traversal::Walk, Integrator::Path);
        session.set_render_settings(settings);
        if session.comparison.is_some() {
            session.act(Action::Compare, None);
        }
        session.set_light(Light { real_time: RealTimeChoice::On, ..session.light });
        // Also where the device had no memory for it.
        session.ask(Command::SetLight(session.light));
        session.set_paused(false);
    }

    /// Takes down how long the thread was busy.
    pub fn note(&mut self, turn: &Turn, at: Duration, what: &str) {
        let mut longest = std::mem::take(&mut self.longest);
        longest.take(turn, at, || format!("{what} ({})", self.state()));
        self.longest = longest;
    }

    /// What the window is in the middle of, for a report.
    pub fn state(&self) -> String {
        let session = &self.session;
        let scene = session.open.as_ref().map(|open| (open.source.rsplit('/').next(), open.voxels));
        let editing = session.editing.as_ref().filter(|editing| editing.is_on);
        let tool = editing.map(|editing| (editing.tool, editing.stroke().is_some(), editing.brush.size));
        let measuring = (session.measuring.tool, session.measuring.flood.is_some());
        let cuts = (session.clipping.held, session.drags_values());
        format!("{scene:?}, editing {tool:?}, measuring {measuring:?}, held {cuts:?}, {:?}", session.navigator.mode)
    }

    /// Whether a place lies on the panels: beside the picture, or on a window over it.
    pub fn is_on_panels(&self, place: Vec2) -> bool {
        let layer = self.context.layer_id_at(egui::pos2(place.x, place.y));
        let (width, height) = self.session.size();
        place.x >= width as f32
            || place.y >= height as f32
            || layer.is_some_and(|layer| layer.order != egui::Order::Background)
    }

    /// Whether keys are those of the table: all but what is typed into a field of the panels.
    pub fn has_keyboard(&self) -> bool {
        !self.context.text_edit_focused()
    }
}
