//! Scenes in and out: the system's dialogs, opening, writing.

use super::App;
use super::wake::Wake;
use crate::dialogs::{Dialog, OpenDialog, PictureKind, SCENE_KINDS};
use crate::export::{ExportRequest, Exporting, Source};
use crate::inspector::{Sampling, Values};
use crate::load::{Loading, Reading};
use crate::running::{RunRequest, Running};
use crate::session::Command;
use crate::tr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::scenes;

/// Nobody closes a dialog of the system within this time of asking for it: it never came.
const NO_DIALOG: Duration = Duration::from_millis(600);

impl App {
    /// Shows the system's dialog; what is chosen there is opened when it comes.
    pub(super) fn ask_for_file(&mut self) {
        let Some(graphics) = &self.graphics else { return };
        let dialog = rfd::AsyncFileDialog::new().set_title("Open a scene").set_parent(&*graphics.window).pick_file();
        let (proxy, asked) = (self.proxy.clone(), Instant::now());
        // Dialogs are made on this thread, as some systems want it, and waited for on another.
        std::thread::spawn(move || {
            let chosen = pollster::block_on(dialog).map(|file| file.path().to_path_buf());
            let _ = proxy.send_event(Wake::Chosen { path: chosen, is_quick: asked.elapsed() < NO_DIALOG });
        });
    }

    /// Takes the answer of the system's dialog; where the system has none, the window's own takes its place.
    pub(super) fn take_chosen(&mut self, path: Option<PathBuf>, is_quick: bool) {
        match path {
            Some(path) => self.session.ask(Command::Load(path.display().to_string())),
            None if is_quick => {
                self.session.say(tr!("said.the_system_has_no_dialog_for"), false);
                self.session.dialog = Some(Dialog::Open(OpenDialog::new(&self.session)));
            }
            None => self.session.say(tr!("said.no_file_was_chosen_files_can"), false),
        }
    }

    /// Shows the system's dialog for the path of the dialog that is open.
    pub(super) fn ask_for_path(&mut self) {
        let (Some(graphics), Some(dialog)) = (&self.graphics, &mut self.session.dialog) else { return };
        let mut system = rfd::AsyncFileDialog::new().set_parent(&*graphics.window);
        let path = dialog.path_field().and_then(|field| field.path()).unwrap_or_default();
        if let Some(folder) = path.ancestors().skip(1).find(|folder| folder.is_dir()) {
            system = system.set_directory(folder);
        }
        if let Some(name) = path.file_name() {
            system = system.set_file_name(name.to_string_lossy());
        }
        let proxy = self.proxy.clone();
        macro_rules! answer {
            ($asked:expr) => {{
                let (asked, since) = ($asked, Instant::now());
                std::thread::spawn(move || {
                    let chosen = pollster::block_on(asked).map(|file| file.path().to_path_buf());
                    let _ = proxy.send_event(Wake::ChosenPath { path: chosen, is_quick: since.elapsed() < NO_DIALOG });
                });
            }};
        }
        match dialog {
            Dialog::New(_) => {}
            Dialog::Plan(_) => answer!(system.add_filter("plans", &["toml"]).pick_file()),
            Dialog::Open(_) => answer!(system.pick_file()),
            Dialog::Frames(_) => answer!(system.pick_folder()),
            Dialog::Record(_) => answer!(system.save_file()),
            Dialog::Save(_) => answer!(system.add_filter("scenes", &SCENE_KINDS.map(|(ending, _)| ending)).save_file()),
            Dialog::Picture(_) => {
                answer!(system.add_filter("pictures", &PictureKind::ALL.map(PictureKind::extension)).save_file());
            }
        }
    }

    /// Takes that dialog's answer.
    pub(super) fn take_chosen_path(&mut self, path: Option<PathBuf>, is_quick: bool) {
        match (path, &mut self.session.dialog) {
            (Some(path), Some(dialog)) => dialog.take_path(&path),
            (None, Some(_)) if is_quick => {
                self.session.say(tr!("said.the_system_has_no_dialog_for"), false);
            }
            _ => {}
        }
    }

    /// Begins to render pictures to files.
    pub(super) fn export(&mut self, request: ExportRequest) {
        let (Some(open), Some(graphics)) = (&self.session.open, &self.graphics) else { return };
        let source = Source {
            changed: Arc::clone(&open.changed),
            lit: Arc::clone(&open.lit),
            backend: self.session.backend(),
            device: Some(Arc::clone(graphics.device())),
        };
        let proxy = self.proxy.clone();
        let wake = move || {
            let _ = proxy.send_event(Wake::Exported);
        };
        self.may_quit = false;
        self.session.exporting = Some(Exporting::start(request, source, wake));
    }

    /// Runs a command beside the window.
    pub(super) fn run_beside(&mut self, request: RunRequest) {
        self.may_quit = false;
        if !request.measures {
            self.session
                .say("recording beside the window; P stops the window's own samples, which makes it quicker", false);
        }
        if request.measures
            && let Some(engine) = &self.engine
        {
            engine.pause(true);
        }
        self.session.running = Some(Running::start(&self.loader, request, self.wake()));
    }

    /// Begins to write the scene to a file.
    pub(super) fn save_scene(&mut self, path: PathBuf) {
        if self.session.saving_scene.is_some() {
            self.session.say(tr!("said.another_scene_is_being_written_wait"), true);
            return;
        }
        self.session.begin_saving(&path);
        let Some(open) = &self.session.open else { return };
        let (scene, loader, proxy) = (Arc::clone(&open.pickable), Arc::clone(&self.loader), self.proxy.clone());
        self.may_quit = false;
        self.session.saving_scene = Some(path.clone());
        let settings = &self.session.render_settings;
        if settings.cutting.is_cut() || !settings.surroundings.is_none() {
            self.session.say(tr!("said.the_file_holds_the_whole_scene"), false);
        }
        self.writing = Some(std::thread::spawn(move || {
            let result = loader.save(&scene, &path);
            let _ = proxy.send_event(Wake::Written(result));
        }));
    }

    /// Says what came of it.
    pub(super) fn take_written(&mut self, result: Result<Vec<String>, String>) {
        let path = self.session.saving_scene.take().unwrap_or_default();
        self.writing = None;
        self.session.end_saving(result.is_ok());
        match result {
            Ok(notes) => {
                notes.into_iter().for_each(|note| self.session.say(note, false));
                self.session.say(format!("written: {}", path.display()), false);
            }
            Err(error) => self.session.say(error, true),
        }
    }

    /// Begins to open a scene; the one that is shown stays until it is there.
    pub(super) fn load(&mut self, source: &str) {
        let of_animation = crate::timeline::scene_to_open(Path::new(source));
        let whole = std::path::absolute(source).unwrap_or_else(|_| source.into());
        self.session.wanted_timeline = of_animation.as_ref().map(|_| whole);
        let of_animation = match of_animation.transpose() {
            Ok(scene) => scene,
            Err(error) => return self.session.say(error.to_string(), true),
        };
        let source = of_animation.as_deref().unwrap_or(source);
        let source = match scenes::NAMES.contains(&source) {
            true => source.to_owned(),
            false => std::path::absolute(source).map_or(source.to_owned(), |path| path.display().to_string()),
        };
        self.session.wants_motion = false;
        let reading = Reading { is_cut: self.session.given_cutting.is_cut(), ..self.motion_wanted(false) };
        self.session.loading = Some(Loading::start(&self.loader, &source, reading, false, self.wake()));
    }

    /// Reads the scene again, with what its file hides, or what lies inside, and somebody wants to see.
    pub(super) fn load_again(&mut self) {
        let Some(open) = &self.session.open else { return };
        let is_cut = self.session.render_settings.cutting.is_cut();
        let (transfer, points) = (self.session.chosen_transfer(), self.session.chosen_points());
        let reading =
            Reading { shown: open.changes().1, is_cut, is_again: true, points, transfer, ..self.motion_wanted(true) };
        self.session.loading = Some(Loading::start(&self.loader, &open.source, reading, true, self.wake()));
    }

    /// Begins to read the values of the volume that the scene was made of.
    pub(super) fn read_values(&mut self) {
        let Some(open) = &self.session.open else { return };
        let (loader, source) = (Arc::clone(&self.loader), open.source.clone());
        let world = open.original.georeference.as_ref().map(|of| of.coordinates_from_world);
        self.session.sampling = Sampling::start(move |wanted| {
            let Some(world) = world else { return Ok(None) };
            Ok(loader.volume(&source, wanted)?.map(|volume| Values::new(volume, world)))
        });
    }

    /// How what moves is read: where an animation was opened, or the timeline is shown of a scene with keyframes.
    fn motion_wanted(&self, is_again: bool) -> Reading {
        let shown = || self.session.timeline_that_moves().filter(|_| is_again);
        let animation = self.session.wanted_timeline.clone().or_else(shown);
        let moves = animation.is_some() || is_again && (self.session.wants_motion || self.session.has_motion());
        Reading { moves, animation, ..Reading::default() }
    }

    /// Wakes the window from another thread.
    pub(super) fn wake(&self) -> Arc<dyn Fn() + Send + Sync> {
        self.wake_by(|| Wake::Loading)
    }

    /// The same by another event.
    pub(super) fn wake_by(&self, event: fn() -> Wake) -> Arc<dyn Fn() + Send + Sync> {
        let proxy = self.proxy.clone();
        Arc::new(move || {
            // The window may be closed.
            let _ = proxy.send_event(event());
        })
    }

    /// Takes a scene that has come.
    pub(super) fn take_loaded(&mut self) {
        self.session.take_measured();
        self.session.take_running();
        self.session.take_reshaped();
        let before = self.session.open.as_ref().map(|open| (Arc::clone(&open.original), Arc::clone(&open.lit)));
        self.session.take_loaded();
        let Some(open) = &self.session.open else { return };
        if before.as_ref().is_some_and(|(original, _)| Arc::ptr_eq(original, &open.original)) {
            return;
        }
        // Freeing what is large takes its time.
        std::thread::spawn(move || drop(before));
        if !scenes::NAMES.contains(&open.source.as_str()) {
            self.settings.settings.add_recent(Path::new(&open.source));
            self.save_settings();
        }
    }
}
