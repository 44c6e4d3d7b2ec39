//! Scenes in and out: the system's dialogs, opening, writing.

use super::App;
use super::wake::Wake;
use crate::dialogs::{Dialog, OpenDialog, PictureKind, SCENE_KINDS};
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
        let dialog =
            rfd::AsyncFileDialog::new().set_title(tr!("dialogs.open")).set_parent(&*graphics.window).pick_file();
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
            Some(path) => self.session.open_file(&path),
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
            Dialog::Plan(_) => answer!(system.add_filter(tr!("dialogs.filter_plans"), &["toml"]).pick_file()),
            Dialog::Open(_) => answer!(system.pick_file()),
            Dialog::Frames(_) => answer!(system.pick_folder()),
            Dialog::Record(_) => answer!(system.save_file()),
            Dialog::Save(_) => answer!(
                system.add_filter(tr!("dialogs.filter_scenes"), &SCENE_KINDS.map(|(ending, _)| ending)).save_file()
            ),
            Dialog::Picture(_) => {
                answer!(
                    system
                        .add_filter(tr!("dialogs.filter_pictures"), &PictureKind::ALL.map(PictureKind::extension))
                        .save_file()
                );
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
        if !scenes::NAMES.contains(&open.source.as_str()) && !self.session.is_untitled() {
            self.settings.settings.add_recent(Path::new(&open.source));
            self.save_settings();
        }
    }
}
