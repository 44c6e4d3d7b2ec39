//! The window itself: what it is opened with and how, and everything of an open one. Events of winit go into the state ([`events`]), its
//! commands are carried out ([`commands`]), frames are drawn when something changed ([`frame`]).

mod commands;
mod device;
mod edits;
mod events;
mod files;
mod frame;
mod graphics;
mod keyboard;
mod saving;
mod stopwatch;
mod wake;

use crate::cutting::Cutting;
use crate::engine::{Engine, Light, RealTimeChoice};
use crate::gamepad::{self, Gamepad};
use crate::input::Input;
use crate::load::Loader;
use crate::panels::{Status, Theme};
use crate::session::{Command, Session};
use crate::settings::SettingsFile;
use crate::strings;
use crate::threads;
use crate::touch::Touch;
use edits::Recovering;
use graphics::Graphics;
use saving::Saving;
use std::path::Path;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Instant;
use stopwatch::Stopwatch;
use voxtrace::TraceError;
use voxtrace::glam::Vec2;
use voxtrace_vulkan::{Traversal, Vulkan};
use wake::{Wake, WakeDrawing};
use winit::dpi::LogicalSize;
use winit::event_loop::{ActiveEventLoop, EventLoop, EventLoopProxy};
use winit::window::Window;

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
    /// How scenes are cut open, beside the planes among those options.
    pub cutting: Cutting,
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

/// Opens the window and returns when it is closed.
///
/// # Errors
/// [`ViewerError`] where there is no screen or no device that shows pictures on it.
pub fn open_window(options: WindowOptions, loader: Arc<dyn Loader>) -> Result<(), ViewerError> {
    let refused = |error: winit::error::EventLoopError| ViewerError::Window(without_place(error.to_string()));
    let event_loop = EventLoop::<Wake>::with_user_event().build().map_err(refused)?;
    threads::let_workers_yield();
    let (settings, warning) = SettingsFile::open(SettingsFile::usual_path());
    let mut app = App::new(options, loader, settings, event_loop.create_proxy());
    if let Some(warning) = warning {
        app.session.say(warning, true);
    }
    event_loop.run_app(&mut app).map_err(refused)?;
    let (failure, instances) = (app.failure.take(), std::mem::take(&mut app.instances));
    drop(app);
    // The last word: what is wrong with how everything was taken down is among the messages.
    for vulkan in instances {
        vulkan.messages().first().iter().for_each(|message| eprintln!("validation: {message}"));
    }
    failure.map_or(Ok(()), Err)
}

/// What winit's errors begin with, before the place.
const BEFORE_PLACE: &str = "os error at ";

/// What winit says of the window system, without the place in winit's own source that it begins with.
fn without_place(said: String) -> String {
    let what = said
        .strip_prefix(BEFORE_PLACE)
        .and_then(|rest| rest.split_once(".rs:"))
        .and_then(|(_, rest)| rest.split_once(": "));
    what.map_or_else(|| said.clone(), |(_, what)| what.trim_end_matches('.').to_owned())
}

/// Everything of an open window.
struct App {
    options: WindowOptions,
    loader: Arc<dyn Loader>,
    settings: SettingsFile,
    proxy: EventLoopProxy<Wake>,
    session: Session,
    input: Input,
    touch: Touch,
    gamepad: Gamepad,
    /// Whether another window has the keyboard.
    is_away: bool,
    status: Status,
    graphics: Option<Graphics>,
    engine: Option<Engine>,
    /// A film that will be written when it comes.
    saving: Option<Saving>,
    /// Threads that write such films.
    writing: Vec<JoinHandle<()>>,
    /// The file that keeps edits that no other holds.
    recovering: Recovering,
    title: String,
    /// Whether somebody was told that closing the window ends work under way.
    may_quit: bool,
    last_advance: Instant,
    last_click: Option<(Instant, Vec2)>,
    stopwatch: Stopwatch,
    /// Whether somebody said what traces; else it follows from the device.
    is_traversal_chosen: bool,
    /// The instance of the device, and those of the devices that it was after a loss.
    instances: Vec<Arc<Vulkan>>,
    failure: Option<ViewerError>,
}

impl App {
    fn new(
        options: WindowOptions,
        loader: Arc<dyn Loader>,
        settings: SettingsFile,
        proxy: EventLoopProxy<Wake>,
    ) -> Self {
        let is_traversal_chosen = options.traversal.is_some();
        let mut session = Session::new(options.traversal.unwrap_or(Traversal::Cpu));
        session.scene_options.clone_from(&options.scene_options);
        session.built_in_voxels = options.built_in_voxels;
        session.given_cutting = options.cutting.clone();
        session.settings_folder = settings.folder().map(Path::to_path_buf);
        session.navigator.is_inverted = settings.settings.invert_look;
        session.exposure_step = settings.settings.exposure_step;
        session.theme = Theme::of_name(&settings.settings.theme);
        session.light = Light {
            real_time: RealTimeChoice::of_name(&settings.settings.real_time),
            is_bare: settings.settings.bare_film,
        };
        session.language.clone_from(&settings.settings.language);
        let said = |name: &&str| std::env::var(name).ok().filter(|value| !value.is_empty());
        let of_system = || ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(said);
        if let Some(language) = session.language.clone().or_else(of_system) {
            // What nobody translated is said in English.
            strings::speak(&language);
        }
        let status = Status { built_in: loader.built_in(), ..Status::default() };
        Self {
            options,
            loader,
            settings,
            proxy,
            session,
            input: Input::default(),
            touch: Touch::default(),
            gamepad: Gamepad::default(),
            is_away: false,
            status,
            graphics: None,
            engine: None,
            saving: None,
            writing: Vec::new(),
            recovering: Recovering::default(),
            title: String::new(),
            may_quit: false,
            last_advance: Instant::now(),
            last_click: None,
            stopwatch: Stopwatch::start(),
            is_traversal_chosen,
            instances: Vec::new(),
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
        let refused = |error: winit::error::OsError| ViewerError::Window(without_place(error.to_string()));
        let window = event_loop.create_window(attributes).map_err(refused)?;
        let wanted = (self.options.device.as_deref(), self.settings.settings.device.as_deref());
        let proxy = self.proxy.clone();
        let (mut graphics, refused) =
            Graphics::new(Arc::new(window), wanted, self.options.validation, move |drawing| {
                // The window may be closed.
                let _ = proxy.send_event(Wake::Drawing(WakeDrawing(drawing)));
            })?;
        if let Some(refused) = refused {
            self.session.say(refused, false);
        }
        graphics.egui.init_accesskit(event_loop, &graphics.window, self.proxy.clone());
        graphics.egui.egui_ctx().set_zoom_factor(self.settings.settings.ui_scale);
        graphics.window.set_visible(true);
        self.instances.push(Arc::clone(graphics.device().vulkan()));
        self.graphics = Some(graphics);
        self.start_engine();
        self.list_devices();
        self.look_for_edits();
        self.stopwatch.opened();
        let proxy = self.proxy.clone();
        gamepad::listen(move |event| proxy.send_event(Wake::Pad(event)).is_ok());
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_of_the_window_system_names_no_place_in_a_source() {
        let said = "os error at /home/a/.cargo/winit-0.30.13/src/platform_impl/linux/mod.rs:765: neither DISPLAY nor WAYLAND_DISPLAY is set.";
        assert_eq!(without_place(said.into()), "neither DISPLAY nor WAYLAND_DISPLAY is set");
        assert_eq!(without_place("os error at C:\\a\\mod.rs:7: refused: no".into()), "refused: no");
        assert_eq!(without_place("Exit Failure: 1".into()), "Exit Failure: 1");
    }
}
