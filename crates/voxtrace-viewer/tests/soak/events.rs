//! The window with its state, as `app` has it, and the events that random numbers choose for it.

use super::common::headless::Headless;
use super::common::room;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;
use voxtrace::import::{Content, ImportOptions, load};
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};
use voxtrace::{PackedScene, scenes};
use voxtrace_viewer::engine::{Backend, FilmAnswer};
use voxtrace_viewer::gpu::{Layer, Panels};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::load::Loading;
use voxtrace_viewer::panels::{self, Status};
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::{Loader, Reading, Told, Wanted};
use voxtrace_vulkan::{Fault, Traversal};

/// Time between two losses of the device, at least: five within ten seconds, and the window gives it up.
const BETWEEN_LOSSES: Duration = Duration::from_secs(3);

/// SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    fn place(&mut self, (width, height): (u32, u32)) -> Vec2 {
        Vec2::new(self.below(width.into()) as f32, self.below(height.into()) as f32)
    }
}

/// Reads files and small built-in scenes.
struct Files;

impl Loader for Files {
    fn load(
        &self,
        source: &str,
        _: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        _: &Wanted,
    ) -> Result<PackedScene, String> {
        tell(Told::Note(format!("reading {source}")));
        if scenes::NAMES.contains(&source) {
            let scene = scenes::generate(source, Some(20_000)).map_err(|error| error.to_string())?;
            return PackedScene::pack(&scene).map_err(|error| error.to_string());
        }
        let loaded = load(Path::new(source), &ImportOptions::default()).map_err(|error| error.to_string())?;
        match loaded.content {
            Content::Packed(packed) => Ok(*packed),
            Content::Scene(scene) => PackedScene::pack(&scene).map_err(|error| error.to_string()),
        }
    }

    fn save(&self, _: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        Err(format!("{} is not written here", path.display()))
    }

    fn built_in(&self) -> Vec<(String, String)> {
        scenes::NAMES.iter().map(|&name| (name.to_owned(), "a scene".to_owned())).collect()
    }
}

/// Files to open, some of them damaged.
fn files(folder: &Path) -> Vec<String> {
    let path = |name: &str| folder.join(name);
    let packed = PackedScene::pack(&room()).unwrap();
    packed.save(&path("room.vxt")).unwrap();
    let whole = std::fs::read(path("room.vxt")).unwrap();
    std::fs::write(path("short.vxt"), &whole[..whole.len() / 2]).unwrap();
    let mut changed = whole;
    let middle = changed.len() / 2;
    changed[middle] ^= 0x55;
    std::fs::write(path("changed.vxt"), &changed).unwrap();
    std::fs::write(path("noise.vox"), b"VOX \x96\0\0\0MAIN nothing of the kind").unwrap();
    let names = ["room.vxt", "room.vxt", "short.vxt", "changed.vxt", "noise.vox", "nowhere.ply"];
    let files = names.iter().map(|name| path(name).display().to_string());
    files.chain(["church", "city"].map(str::to_owned)).collect()
}

/// The window with its state, as `app` has it.
pub struct App {
    pub window: Headless,
    session: Session,
    input: Input,
    status: Status,
    context: egui::Context,
    loader: Arc<dyn Loader>,
    size: (u32, u32),
    saving: Option<(PathBuf, FilmAnswer)>,
    files: Vec<String>,
    folder: PathBuf,
    last: Instant,
    /// Until when nothing happens, so that a film is made.
    rests: Instant,
    /// When the device was lost last.
    lost: Instant,
    pub saved: u64,
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
            status,
            context,
            loader,
            size,
            saving: None,
            files,
            folder,
            last: now,
            rests: now,
            lost: now,
            saved: 0,
        })
    }

    fn carry_out(&mut self) {
        for command in self.session.take_commands() {
            self.window.is_due = true;
            let engine = &self.window.engine;
            match command {
                Command::Load(source) => {
                    self.session.loading =
                        Some(Loading::start(&self.loader, &source, Reading::default(), false, Arc::new(|| {})));
                }
                Command::SetScene => {
                    engine.set_scene(self.session.open.as_ref().map(|open| Arc::clone(&open.lit)));
                    self.status.times.clear();
                }
                Command::SetBackend(backend) => engine.set_backend(backend),
                Command::SetView => engine.set_view(self.session.view(), self.session.is_moving()),
                Command::Pause(is_paused) => engine.pause(is_paused),
                Command::Save(_) => self.saving = Some((self.folder.join("picture.png"), engine.film())),
                _ => {}
            }
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
                    file.save_picture(&path, &PictureOptions::default()).unwrap();
                    self.saved += 1;
                }
            }
            _ => {}
        }
    }

    pub fn turn(&mut self) {
        let seconds = self.last.elapsed().as_secs_f32();
        self.last = Instant::now();
        self.session.advance(seconds);
        self.session.take_loaded();
        self.carry_out();
        self.save();
        if let Some(shown) = self.window.engine.shown().filter(|_| self.window.is_due) {
            self.status.take(shown);
        }
        if self.size.0 > 0 {
            self.draw();
        }
        self.window.pump(Duration::from_millis(4));
        self.status.shown =
            self.status.shown.take().filter(|shown| Arc::ptr_eq(shown.picture.device(), self.window.screen.device()));
    }

    fn draw(&mut self) {
        let (session, status, size) = (&mut self.session, &self.status, self.size);
        let layer = status.shown.as_ref().filter(|_| session.open.is_some()).map(|shown| Layer {
            picture: Arc::clone(&shown.picture),
            corner: [0.0; 2],
            size: [session.size().0 as f32, session.size().1 as f32],
            tone_map: session.render_settings.tone_map,
            beside: None,
        });
        let context = &self.context;
        self.window.draw(layer, || {
            let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(size.0 as f32, size.1 as f32));
            let input = egui::RawInput { screen_rect: Some(screen), ..egui::RawInput::default() };
            let mut side = 0.0;
            let output = context.run_ui(input, |ui| side = panels::show(ui, session, status));
            session.resize(size.0.saturating_sub(side as u32).max(1), size.1);
            let primitives = context.tessellate(output.shapes, output.pixels_per_point);
            Panels { textures: output.textures_delta, primitives, pixels_per_point: output.pixels_per_point }
        });
    }

    /// Does something.
    pub fn event(&mut self, random: &mut Random) {
        if Instant::now() < self.rests {
            return;
        }
        let place = random.place(self.session.size());
        match random.below(100) {
            0..30 => self.input.move_to(place, &mut self.session),
            30..36 => {
                let button = [Button::Left, Button::Middle, Button::Right][random.below(3) as usize];
                self.input.move_to(place, &mut self.session);
                self.input.press(button, &mut self.session);
            }
            36..45 => [Button::Left, Button::Middle, Button::Right]
                .into_iter()
                .for_each(|button| self.input.release(button, &mut self.session)),
            45..52 => self.input.wheel(random.below(5) as f32 - 2.0, &mut self.session),
            52..55 => {
                let file = self.files[random.below(self.files.len() as u64) as usize].clone();
                self.session.ask(Command::Load(file));
            }
            55..59 => {
                // Minimized, too.
                self.size = if random.below(4) == 0 {
                    (0, 0)
                } else {
                    (200 + random.below(500) as u32, 150 + random.below(300) as u32)
                };
                self.window.screen.resize(self.size);
            }
            59..60 => {
                self.input.lose_focus(&mut self.session);
                self.session.act(Action::Screenshot, None);
                self.rests = Instant::now() + Duration::from_millis(400);
            }
            60..61 => self.lose(random),
            61..90 => {
                use Action::{
                    Cancel, ExposureDown, ExposureUp, FrameAll, FramePicked, Help, Level, LightDown, LightUp,
                    NextCamera, NextIntegrator, NextTraversal, Pause, Pick, RedoCamera, SkyDown, SkyUp, ToggleMode,
                    TogglePanels, UndoCamera,
                };
                let actions = [
                    Cancel,
                    ExposureDown,
                    ExposureUp,
                    FrameAll,
                    FramePicked,
                    Help,
                    Level,
                    LightDown,
                    LightUp,
                    NextCamera,
                    NextIntegrator,
                    NextTraversal,
                    Pause,
                    Pick,
                    RedoCamera,
                    SkyDown,
                    SkyUp,
                    ToggleMode,
                    TogglePanels,
                    UndoCamera,
                ];
                self.session.act(actions[random.below(actions.len() as u64) as usize], Some(place));
            }
            // Let things happen.
            _ => std::thread::sleep(Duration::from_millis(random.below(60))),
        }
    }

    /// Lets the driver fail. The window gives up a device that is lost again and again, so it is not lost more often than every few seconds.
    fn lose(&mut self, random: &mut Random) {
        let faults = [
            ("vkAcquireNextImageKHR", Fault::SurfaceLost),
            ("vkQueuePresentKHR", Fault::OutOfDate),
            ("vkCreateBuffer", Fault::OutOfDeviceMemory),
            ("vkCreateSwapchainKHR", Fault::SurfaceLost),
            ("vkQueueSubmit", Fault::DeviceLost),
            ("vkQueuePresentKHR", Fault::DeviceLost),
        ];
        self.window.faults.clear();
        let (function, fault) = faults[random.below(faults.len() as u64) as usize];
        if fault == Fault::DeviceLost {
            if self.lost.elapsed() < BETWEEN_LOSSES {
                return;
            }
            self.lost = Instant::now();
        }
        self.window.faults.plant(function, fault);
    }
}
