//! The window with its state, wired as `app` wires it: commands are carried out, threads are listened to, frames are drawn.

use super::common::headless::Headless;
use super::files::{Files, files};
use super::turn::{Longest, Turn};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};
use voxtrace_viewer::benchmark::Benchmark;
use voxtrace_viewer::dialogs::{Dialog, OpenDialog};
use voxtrace_viewer::engine::{Backend, FilmAnswer};
use voxtrace_viewer::export::{Exporting, Source};
use voxtrace_viewer::gpu::{Beside, Layer, Panels};
use voxtrace_viewer::input::Input;
use voxtrace_viewer::inspector::{Sampling, Values};
use voxtrace_viewer::load::Loading;
use voxtrace_viewer::panels::{self, Compared, Status};
use voxtrace_viewer::running::Running;
use voxtrace_viewer::session::{Command, Leaving, Session};
use voxtrace_viewer::{Loader, Reading};
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
    writing: Option<std::thread::JoinHandle<Result<Vec<String>, String>>>,
    pub files: Vec<String>,
    folder: PathBuf,
    start: Instant,
    last: Instant,
    pub saved: u64,
    /// The turn of the thread that took longest by itself.
    pub longest: Longest,
}

impl App {
    pub fn open(folder: &Path) -> Option<Self> {
        let size = (640, 420);
        let window = Headless::open(Backend::Cpu, size)?;
        let mut session = Session::new(Traversal::Cpu);
        session.traversals = vec![Traversal::Cpu, Traversal::Walk, Traversal::Query];
        session.settings_folder = Some(folder.to_path_buf());
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
            writing: None,
            files,
            folder,
            start: now,
            last: now,
            saved: 0,
            longest: Longest::default(),
        })
    }

    fn carry_out(&mut self) {
        for command in self.session.take_commands() {
            self.window.is_due = true;
            let engine = &self.window.engine;
            match command {
                Command::Load(source) => {
                    if self.session.may_leave(Leaving::Load(source.clone())) {
                        self.load(&source, Reading::default(), false);
                    }
                }
                Command::New(size) => {
                    if self.session.may_leave(Leaving::New(size)) {
                        self.session.show_new(size);
                    }
                }
                Command::LoadAgain => self.load_again(),
                Command::Reshape => self.session.reshape(&self.loader, nobody()),
                Command::SetScene => {
                    self.session.settle_edits();
                    let lit = self.session.open.as_ref().map(|open| Arc::clone(&open.lit));
                    match lit {
                        Some(lit) if self.session.has_motion() => engine.move_scene(lit),
                        lit => engine.set_scene(lit),
                    }
                    self.status.times.clear();
                }
                Command::Edit => self.session.start_editor(nobody()),
                Command::Follow(followed) => engine.follow(followed.0),
                Command::CompareWith(other) => {
                    engine.compare_with(other);
                    (self.status.other, self.status.differences) = (None, None);
                }
                Command::SetContrast(contrast) => {
                    engine.set_contrast(contrast);
                    self.status.differences = None;
                }
                Command::MakeSky => self.session.make_sky(nobody()),
                Command::Surround => self.session.make_surroundings(nobody()),
                Command::ReadValues => self.read_values(),
                Command::Benchmark => {
                    if let Some(subject) = self.session.bench_subject(None) {
                        self.session.benchmark = Some(Benchmark::start(subject, nobody()));
                    }
                }
                Command::Run(request) => self.session.running = Some(Running::start(&self.loader, *request, nobody())),
                Command::Export(request) => self.export(*request),
                Command::SaveScene(path) => self.save_scene(path),
                Command::SetBackend(backend) => engine.set_backend(backend),
                Command::SetView => engine.set_view(self.session.view(), self.session.is_moving()),
                Command::Pause(is_paused) => engine.pause(is_paused),
                Command::Save(_) => self.saving = Some((self.folder.join("picture.png"), engine.film())),
                Command::AskForFile => self.session.dialog = Some(Dialog::Open(OpenDialog::new(&self.session))),
                // It stays open, but not with edits that somebody is asked about.
                Command::Quit => _ = self.session.may_leave(Leaving::Quit),
                _ => {}
            }
        }
    }

    fn load(&mut self, source: &str, reading: Reading, is_again: bool) {
        self.session.loading = Some(Loading::start(&self.loader, source, reading, is_again, nobody()));
    }

    fn load_again(&mut self) {
        let Some(open) = &self.session.open else { return };
        let is_cut = self.session.render_settings.cutting.is_cut();
        let (transfer, points) = (self.session.chosen_transfer(), self.session.chosen_points());
        let reading =
            Reading { shown: open.changes().1, is_cut, is_again: true, points, transfer, ..Reading::default() };
        let source = open.source.clone();
        self.load(&source, reading, true);
    }

    fn read_values(&mut self) {
        let Some(open) = &self.session.open else { return };
        let (loader, source) = (Arc::clone(&self.loader), open.source.clone());
        let world = voxtrace::glam::DAffine3::IDENTITY;
        self.session.sampling =
            Sampling::start(move |wanted| Ok(loader.volume(&source, wanted)?.map(|volume| Values::new(volume, world))));
    }

    fn export(&mut self, request: voxtrace_viewer::export::ExportRequest) {
        let Some(open) = &self.session.open else { return };
        let source = Source {
            changed: Arc::clone(&open.changed),
            lit: Arc::clone(&open.lit),
            backend: self.session.backend(),
            device: Some(Arc::clone(self.window.screen.device())),
        };
        self.session.exporting = Some(Exporting::start(request, source, || {}));
    }

    fn save_scene(&mut self, path: PathBuf) {
        if self.writing.is_some() {
            return;
        }
        self.session.begin_saving(&path);
        let Some(open) = &self.session.open else { return };
        let (scene, loader) = (Arc::clone(&open.pickable), Arc::clone(&self.loader));
        self.session.saving_scene = Some(path.clone());
        self.writing = Some(std::thread::spawn(move || loader.save(&scene, &path)));
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
        if let Some(writing) = self.writing.take_if(|writing| writing.is_finished()) {
            let written = writing.join().expect("writing ends");
            session.saving_scene = None;
            session.end_saving(written.is_ok());
            written.err().into_iter().for_each(|error| session.say(error, true));
        }
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
        let turn = Turn::begin();
        let seconds = self.last.elapsed().as_secs_f32();
        self.last = Instant::now();
        self.session.advance(seconds);
        self.listen();
        self.carry_out();
        self.save();
        if let Some(shown) = self.window.engine.shown().filter(|_| self.window.is_due) {
            self.status.take(shown);
            self.status.other = self.window.engine.other_shown();
            self.status.differences = self.window.engine.differences();
        }
        if self.size.0 > 0 {
            self.draw();
        }
        self.note(&turn, self.start.elapsed(), "the turn");
        self.window.pump(Duration::from_millis(4));
        let device = self.window.screen.device();
        let is_here = |picture: &Arc<voxtrace_vulkan::Picture>| Arc::ptr_eq(picture.device(), device);
        self.status.shown = self.status.shown.take().filter(|shown| is_here(&shown.picture));
        self.status.other = self.status.other.take().filter(|shown| is_here(&shown.picture));
        self.status.differences = self.status.differences.take().filter(|shown| is_here(&shown.picture));
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
