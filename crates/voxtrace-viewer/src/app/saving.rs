//! The picture as it is, written to a file.

use super::App;
use super::wake::{Wake, WakeEngine};
use crate::engine::Event as EngineEvent;
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};

impl App {
    /// Writes a film that has come.
    pub(super) fn save_film(&mut self) {
        let Some((path, answer)) = self.saving.take() else { return };
        match answer.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => self.saving = Some((path, answer)),
            Ok(Some((frame, film))) => {
                let Some(open) = &self.session.open else { return };
                let file = FilmFile { frame, scene: SceneStamp::of(&open.lit), film };
                let options =
                    PictureOptions { tone_map: self.session.render_settings.tone_map, ..PictureOptions::default() };
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
}
