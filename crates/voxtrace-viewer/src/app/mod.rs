//! The window itself: events of winit go into the state, its commands are carried out, frames are drawn when something changed.

mod graphics;
mod keyboard;
mod stopwatch;

use crate::engine::{Engine, Event as EngineEvent, FilmAnswer};
use crate::input::{Button, Input};
use crate::keys::Key;
use crate::load::{Loader, Loading};
use crate::panels::{self, Status};
use crate::session::{Command, Session};
use crate::settings::SettingsFile;
use graphics::Graphics;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use stopwatch::Stopwatch;
use voxtrace::glam::Vec2;
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};
use voxtrace::{TraceError, scenes};
use voxtrace_vulkan::{DeviceKind, Traversal, Vulkan, missing};
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::{ElementState, MouseButton, MouseScrollDelta, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Fullscreen, Window, WindowId};

/// Time between two frames while the camera moves by itself.
const FRAME: Duration = Duration::from_millis(8);
/// Two clicks within this time are a double click.
const DOUBLE_CLICK: Duration = Duration::from_millis(400);

/// What a window is opened with.
#[derive(Clone, Debug, Default)]
pub struct WindowOptions {
    /// The scene to open: a path, or the name of a built-in one.
    pub scene: Option<String>,
    /// How rays find voxels; `None`: the compute walk on hardware, else the processor.
    pub traversal: Option<Traversal>,
    /// Number of a device, or a part of its name.
    pub device: Option<String>,
    /// Whether to turn on the validation layer.
    pub validation: bool,
    /// Options with which scenes are read, as words of a command.
    pub scene_options: Vec<String>,
    /// How large built-in scenes are made, where that was chosen.
    pub built_in_voxels: Option<u64>,
}

/// The window cannot be opened, or cannot go on.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ViewerError {
    /// There is no screen, or its window system refuses.
    #[error("no window can be opened: {0}")]
    Window(String),
    /// The device does not work.
    #[error("{0}")]
    Device(#[from] TraceError),
    /// Drawing failed.
    #[error("{0}")]
    Draw(#[from] crate::gpu::DrawError),
}

/// What wakes the event loop.
#[derive(Debug)]
enum Wake {
    Engine(WakeEngine),
    Loading,
    Chosen(Option<PathBuf>),
    Accessibility(egui_winit::accesskit_winit::Event),
}

/// An event of the engine that can be printed.
struct WakeEngine(EngineEvent);

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

/// Opens the window and returns when it is closed.
///
/// # Errors
/// [`ViewerError`] where there is no screen or no device that shows pictures on it.
pub fn open_window(options: WindowOptions, loader: Arc<dyn Loader>) -> Result<(), ViewerError> {
    let refused = |error: winit::error::EventLoopError| ViewerError::Window(error.to_string());
    let event_loop = EventLoop::<Wake>::with_user_event().build().map_err(refused)?;
    let (settings, warning) = SettingsFile::open(SettingsFile::usual_path());
    let mut app = App::new(options, loader, settings, event_loop.create_proxy());
    if let Some(warning) = warning {
        app.session.say(warning, true);
    }
    event_loop.run_app(&mut app).map_err(refused)?;
    let (failure, vulkan) = (app.failure.take(), app.vulkan.take());
    drop(app);
    // The last word: what is wrong with how everything was taken down is among the messages.
    if let Some(vulkan) = vulkan {
        vulkan.messages().first().iter().for_each(|message| eprintln!("validation: {message}"));
    }
    failure.map_or(Ok(()), Err)
}

/// Everything of an open window.
struct App {
    options: WindowOptions,
    loader: Arc<dyn Loader>,
    settings: SettingsFile,
    proxy: EventLoopProxy<Wake>,
    session: Session,
    input: Input,
    status: Status,
    graphics: Option<Graphics>,
    engine: Option<Engine>,
    /// A film that will be written when it comes.
    saving: Option<(PathBuf, FilmAnswer)>,
    last_advance: Instant,
    last_click: Option<(Instant, Vec2)>,
    stopwatch: Stopwatch,
    /// The instance of the device, once it was opened.
    vulkan: Option<Arc<Vulkan>>,
    failure: Option<ViewerError>,
}

impl App {
    fn new(
        options: WindowOptions,
        loader: Arc<dyn Loader>,
        settings: SettingsFile,
        proxy: EventLoopProxy<Wake>,
    ) -> Self {
        let mut session = Session::new(options.traversal.unwrap_or(Traversal::Cpu));
        session.scene_options.clone_from(&options.scene_options);
        session.built_in_voxels = options.built_in_voxels;
        session.settings_folder = settings.folder().map(Path::to_path_buf);
        session.navigator.is_inverted = settings.settings.invert_look;
        session.exposure_step = settings.settings.exposure_step;
        let status = Status { built_in: loader.built_in(), ..Status::default() };
        Self {
            options,
            loader,
            settings,
            proxy,
            session,
            input: Input::default(),
            status,
            graphics: None,
            engine: None,
            saving: None,
            last_advance: Instant::now(),
            last_click: None,
            stopwatch: Stopwatch::start(),
            vulkan: None,
            failure: None,
        }
    }

    /// Opens window and device, and starts to trace.
    fn open(&mut self, event_loop: &ActiveEventLoop) -> Result<(), ViewerError> {
        let [width, height] = self.settings.settings.window;
        let attributes = Window::default_attributes()
            .with_title("voxtrace")
            .with_inner_size(LogicalSize::new(width, height))
            .with_min_inner_size(LogicalSize::new(320, 240))
            // Screen readers have to know it from the beginning.
            .with_visible(false);
        let window = event_loop.create_window(attributes).map_err(|error| ViewerError::Window(error.to_string()))?;
        let mut graphics = Graphics::new(
            Arc::new(window),
            self.options.device.as_deref().or(self.settings.settings.device.as_deref()),
            self.options.validation,
        )?;
        graphics.egui.init_accesskit(event_loop, &graphics.window, self.proxy.clone());
        graphics.egui.egui_ctx().set_zoom_factor(self.settings.settings.ui_scale);
        graphics.window.set_visible(true);
        self.vulkan = Some(Arc::clone(graphics.device().vulkan()));
        let info = graphics.device().info();
        let has = |traversal: &Traversal| missing(info, *traversal).is_none();
        let all = [Traversal::Cpu, Traversal::Walk, Traversal::Query, Traversal::Pipeline];
        self.session.traversals = all.into_iter().filter(has).collect();
        let is_hardware = info.kind != DeviceKind::Cpu;
        if self.options.traversal.is_none() && is_hardware {
            self.session.look.traversal = Traversal::Walk;
        }
        self.status.device = format!("window on {}", info.name);
        let proxy = self.proxy.clone();
        let engine = Engine::start(Arc::clone(graphics.device()), self.session.backend(), move |event| {
            // The window may be closed.
            let _ = proxy.send_event(Wake::Engine(WakeEngine(event)));
        });
        (self.graphics, self.engine) = (Some(graphics), Some(engine));
        if let Some(scene) = self.options.scene.take() {
            self.session.ask(Command::Load(scene));
        }
        Ok(())
    }

    /// Ends the program with an error.
    fn fail(&mut self, event_loop: &ActiveEventLoop, failure: ViewerError) {
        self.failure = Some(failure);
        event_loop.exit();
    }

    /// Does what the state asks for.
    fn carry_out(&mut self, event_loop: &ActiveEventLoop) {
        for command in self.session.take_commands() {
            let (Some(graphics), Some(engine)) = (&mut self.graphics, &self.engine) else { return };
            match command {
                Command::Load(source) => self.load(&source),
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
        let proxy = self.proxy.clone();
        let wake = move || {
            let _ = proxy.send_event(Wake::Loading);
        };
        self.session.loading = Some(Loading::start(&self.loader, &source, Arc::new(wake)));
    }

    /// Takes a scene that has come.
    fn take_loaded(&mut self) {
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

    fn save_settings(&mut self) {
        if let Err(error) = self.settings.save() {
            self.session.say(format!("the settings cannot be kept: {error}"), true);
        }
    }

    /// Writes a film that has come.
    fn save_film(&mut self) {
        let Some((path, answer)) = self.saving.take() else { return };
        match answer.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => self.saving = Some((path, answer)),
            Ok(Some((frame, film))) => {
                let Some(open) = &self.session.open else { return };
                let file = FilmFile { frame, scene: SceneStamp::of(&open.lit), film };
                let options = PictureOptions { tone_map: self.session.look.tone_map, ..PictureOptions::default() };
                let proxy = self.proxy.clone();
                let samples = file.film.sample_range().0;
                // On a thread of its own: large pictures take their time.
                std::thread::spawn(move || {
                    let text = match file.save_picture(&path, &options) {
                        Ok(()) => format!("{} holds {samples} samples", path.display()),
                        Err(error) => format!("cannot write {}: {error}", path.display()),
                    };
                    let _ = proxy.send_event(Wake::Engine(WakeEngine(EngineEvent::Notice(text))));
                });
            }
            Ok(None) | Err(_) => self.session.say("there is no whole picture yet", true),
        }
    }

    fn take_engine_event(&mut self, event: EngineEvent) {
        match event {
            EngineEvent::Picture => {
                if let Some(shown) = self.engine.as_ref().and_then(Engine::shown) {
                    self.status.take(shown);
                }
            }
            EngineEvent::Notice(text) => self.session.say(text, false),
            EngineEvent::Failed(error) => {
                self.session.say(format!("tracing stopped: {error}"), true);
            }
            EngineEvent::Moved(device) => {
                self.status.shown = None;
                let moved = self.graphics.as_mut().map(|graphics| graphics.move_to(&device));
                if let Some(Err(error)) = moved {
                    self.session.say(error.to_string(), true);
                }
            }
        }
        self.save_film();
    }

    /// Draws a frame: panels first, since they say where the picture lies.
    fn draw(&mut self) -> Result<(), ViewerError> {
        let Some(graphics) = &mut self.graphics else { return Ok(()) };
        if let (Some(engine), Some(shown)) = (&self.engine, &self.status.shown) {
            let (width, height) = self.session.size();
            let step = f64::from(width) * f64::from(height) * f64::from(shown.step_samples.max(1));
            self.status.step_share = (engine.samples_under_way() as f64 / step) as f32;
        }
        self.status.recent = self.settings.settings.recent.iter().map(|path| path.display().to_string()).collect();
        let (session, status) = (&mut self.session, &self.status);
        let mut side = 0.0;
        let frame = graphics.run_panels(|ui| side = panels::show(ui, session, status));
        let window = graphics.window.inner_size();
        let taken = (side * frame.pixels_per_point).round() as u32;
        let (width, height) = (window.width.saturating_sub(taken).max(1), window.height.max(1));
        self.session.resize(width, height);
        let shown = self.status.shown.as_ref().filter(|_| self.session.open.is_some());
        graphics.draw(frame, shown, (width, height), self.session.look.tone_map)?;
        if shown.is_some() {
            self.stopwatch.picture();
        }
        Ok(())
    }

    /// Whether the panels want what the mouse does.
    fn is_over_panels(&self) -> bool {
        let wants = |graphics: &Graphics| graphics.egui.egui_ctx().egui_wants_pointer_input();
        !self.input.is_dragging() && self.graphics.as_ref().is_some_and(wants)
    }

    /// Whether keys are those of the table: all but what is typed into a field of the panels.
    fn has_keyboard(&self) -> bool {
        !self.graphics.as_ref().is_some_and(|graphics| graphics.egui.egui_ctx().text_edit_focused())
    }

    fn mouse_button(&mut self, button: MouseButton, state: ElementState) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        if state == ElementState::Released {
            self.input.release(button, &mut self.session);
            return;
        }
        if self.is_over_panels() {
            return;
        }
        self.input.press(button, &mut self.session);
        let Some(cursor) = self.input.cursor().filter(|_| button == Button::Left) else { return };
        let is_second =
            self.last_click.is_some_and(|(time, place)| time.elapsed() < DOUBLE_CLICK && place.distance(cursor) < 6.0);
        self.last_click = (!is_second).then(|| (Instant::now(), cursor));
        if is_second {
            self.input.double_click(&mut self.session);
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.graphics.is_none()
            && let Err(failure) = self.open(event_loop)
        {
            self.fail(event_loop, failure);
        }
        self.carry_out(event_loop);
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: Wake) {
        match event {
            Wake::Engine(WakeEngine(event)) => self.take_engine_event(event),
            Wake::Loading => self.take_loaded(),
            Wake::Chosen(Some(path)) => self.session.ask(Command::Load(path.display().to_string())),
            // Also where the system has no dialogs, which looks the same from here.
            Wake::Chosen(None) => {
                self.session.say("no file was chosen; files can also be dropped on the window", false);
            }
            Wake::Accessibility(event) => {
                if let (Some(graphics), egui_winit::accesskit_winit::WindowEvent::ActionRequested(request)) =
                    (&mut self.graphics, event.window_event)
                {
                    graphics.egui.on_accesskit_action_request(request);
                }
            }
        }
        self.carry_out(event_loop);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(graphics) = &mut self.graphics else { return };
        let window = Arc::clone(&graphics.window);
        // Tab shows and hides the panels; among them it would take the focus, and with it the arrows.
        let is_tab =
            matches!(&event, WindowEvent::KeyboardInput { event, .. } if keyboard::key_of(event) == Some(Key::Tab));
        let repaints = !is_tab && graphics.egui.on_window_event(&window, &event).repaint;
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                if let Err(failure) = self.draw() {
                    self.fail(event_loop, failure);
                }
                self.carry_out_without_redraw(event_loop);
                return;
            }
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                graphics.resize((width, height));
                let size = window.inner_size().to_logical::<u32>(window.scale_factor());
                if window.fullscreen().is_none() && width > 0 {
                    self.settings.settings.window = [size.width, size.height];
                }
            }
            WindowEvent::DroppedFile(path) => self.session.ask(Command::Load(path.display().to_string())),
            WindowEvent::ModifiersChanged(modifiers) => {
                self.input.set_modifiers(keyboard::modifiers_of(modifiers.state()), &mut self.session);
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let is_pressed = event.state == ElementState::Pressed;
                if let Some(key) = keyboard::key_of(&event)
                    && (self.has_keyboard() || !is_pressed)
                {
                    self.input.key(key, is_pressed, event.repeat, &mut self.session);
                }
            }
            WindowEvent::Focused(false) => self.input.lose_focus(&mut self.session),
            WindowEvent::CursorLeft { .. } => self.input.leave(),
            WindowEvent::CursorMoved { position, .. } => {
                let cursor = Vec2::new(position.x as f32, position.y as f32);
                self.input.move_to(cursor, &mut self.session);
            }
            WindowEvent::MouseInput { button, state, .. } => self.mouse_button(button, state),
            WindowEvent::MouseWheel { delta, .. } if !self.is_over_panels() => match delta {
                MouseScrollDelta::LineDelta(_, notches) => self.input.wheel(notches, &mut self.session),
                MouseScrollDelta::PixelDelta(by) => {
                    self.input.scroll(Vec2::new(by.x as f32, by.y as f32), &mut self.session);
                }
            },
            WindowEvent::PinchGesture { delta, .. } if !self.is_over_panels() => {
                self.input.pinch(delta as f32, &mut self.session);
            }
            _ => {
                if repaints {
                    window.request_redraw();
                }
                return;
            }
        }
        self.carry_out(event_loop);
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _: StartCause) {
        self.stopwatch.begin_turn();
        let now = Instant::now();
        let seconds = now.duration_since(self.last_advance).as_secs_f32();
        self.last_advance = now;
        self.session.advance(seconds);
        if self.session.is_moving() {
            self.carry_out(event_loop);
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        // A view that has come to rest is asked for once more; messages go by themselves; a film may be under way.
        let is_soon = self.session.is_moving() || self.session.navigator.held.is_moving();
        let flow = if is_soon {
            ControlFlow::WaitUntil(Instant::now() + FRAME)
        } else {
            let repaint = self.graphics.as_ref().and_then(|graphics| graphics.repaint_at);
            if repaint.is_some_and(|at| at <= Instant::now())
                && let Some(graphics) = &self.graphics
            {
                graphics.window.request_redraw();
            }
            ControlFlow::WaitUntil(Instant::now() + Duration::from_millis(200))
        };
        if self.loader.is_interrupted() {
            event_loop.exit();
        }
        self.save_film();
        self.carry_out_without_redraw(event_loop);
        event_loop.set_control_flow(flow);
        self.stopwatch.end_turn();
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        self.save_settings();
        self.stopwatch.report();
        // What traces ends before what shows it.
        (self.engine, self.status.shown) = (None, None);
        self.graphics = None;
    }
}

impl App {
    /// As [`Self::carry_out`], and draws only where something was to be done.
    fn carry_out_without_redraw(&mut self, event_loop: &ActiveEventLoop) {
        if self.session.has_commands() {
            self.carry_out(event_loop);
        }
    }
}
