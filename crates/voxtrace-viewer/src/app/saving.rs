//! The picture as it is, written to a file.

use super::App;
use super::wake::{Wake, WakeEngine};
use crate::engine::{Event as EngineEvent, FilmAnswer};
use crate::export::place;
use crate::threads;
use crate::tr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::TryRecvError;
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};

/// A picture that will be written.
pub struct Saving {
    /// The name it is to have, or the next free one of its kind.
    path: PathBuf,
    /// Whether a frame was drawn since: panels that come or go change the size of the picture then.
    is_laid_out: bool,
    /// Whether it was said that it waits for the film.
    is_told: bool,
    answer: Option<FilmAnswer>,
}

impl Saving {
    pub fn new(path: PathBuf) -> Self {
        Self { path, is_laid_out: false, is_told: false, answer: None }
    }
}

impl App {
    /// Says that a frame was drawn: from now on the picture has the size that is seen.
    pub(super) fn note_layout(&mut self) {
        if let Some(saving) = &mut self.saving {
            saving.is_laid_out = true;
        }
    }

    /// Asks for the film of a picture to write, and writes it when it has come whole and in the size that is shown.
    pub(super) fn save_film(&mut self) {
        let (Some(saving), Some(engine)) = (&mut self.saving, &self.engine) else { return };
        let Some(answer) = &saving.answer else {
            if saving.is_laid_out && !self.session.has_commands() {
                // What is seen is written when it is the film.
                match self.status.shown.as_ref().filter(|shown| shown.lit.is_some()) {
                    Some(_) if self.session.is_paused => saving.answer = Some(engine.film()),
                    Some(_) if std::mem::replace(&mut saving.is_told, true) => {}
                    Some(_) => self.session.say(tr!("real_time.waits"), false),
                    None => saving.answer = Some(engine.film()),
                }
            }
            return;
        };
        match answer.try_recv() {
            Err(TryRecvError::Empty) => {}
            Ok(Some((mut frame, film))) if (frame.width, frame.height) == self.session.size() => {
                let path = std::mem::take(&mut saving.path);
                self.saving = None;
                let Some(open) = &self.session.open else { return };
                let (changed, lit) = (Arc::clone(&open.changed), Arc::clone(&open.lit));
                // As `render` calls it in the file.
                frame.camera.name = self.session.render_camera().name;
                let tone_map = self.session.render_settings.tone_map;
                let proxy = self.proxy.clone();
                self.writing.retain(|thread| !thread.is_finished());
                // On a thread of its own: large pictures take their time, and large scenes too, until they are hashed.
                self.writing.push(std::thread::spawn(move || {
                    threads::yield_to_window();
                    let samples = film.sample_range().0;
                    let mut scene = SceneStamp::of(&changed);
                    (scene.sky, scene.light_intensity) = (lit.sky.clone(), lit.light_intensity);
                    scene.cuts = lit.cuts.clone();
                    let file = FilmFile { frame, scene, film };
                    let text = match write(&path, &file, &PictureOptions { tone_map, ..PictureOptions::default() }) {
                        Ok(path) => tr!("said.holds_samples", path = path.display(), samples = samples),
                        Err(error) => tr!("said.cannot_write", path = path.display(), error = error),
                    };
                    let _ = proxy.send_event(Wake::Engine(WakeEngine(EngineEvent::Notice(text))));
                }));
            }
            // A picture of the new size has no samples yet: it is asked for again.
            Ok(_) if self.session.open.is_some() => saving.answer = None,
            Ok(_) | Err(TryRecvError::Disconnected) => {
                self.saving = None;
                self.session.say(tr!("said.there_is_no_whole_picture_yet"), true);
            }
        }
    }
}

/// Writes whole, then under a free name: nothing is written over.
fn write(wanted: &Path, file: &FilmFile, options: &PictureOptions) -> std::io::Result<PathBuf> {
    let stem = wanted.file_stem().unwrap_or_default().to_string_lossy();
    let written = wanted.with_file_name(format!(".{stem}-{}.png", std::process::id()));
    let placed = file.save_picture(&written, options).and_then(|()| place(&written, wanted));
    if placed.is_err() {
        // Ours, and of no use without its name.
        let _ = std::fs::remove_file(&written);
    }
    placed
}
