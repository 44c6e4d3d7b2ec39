//! What the window does for edits: it carries patches to what traces, marks the title, and keeps edits that no file holds.

use super::App;
use super::wake::Wake;
use crate::editing::recovery::{Note, Recovery, left_behind};
use crate::threads;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Instant;
use voxtrace::PackedScene;

/// The recovery file of the window, and the thread that writes it.
#[derive(Default)]
pub struct Recovering {
    file: Option<Arc<Mutex<Recovery>>>,
    writing: Option<JoinHandle<()>>,
    /// Whether there is something in it.
    is_written: bool,
}

impl App {
    /// Looks for edits that windows left behind.
    pub(super) fn look_for_edits(&mut self) {
        let Some(folder) = self.settings.folder() else { return };
        self.recovering.file = Some(Arc::new(Mutex::new(Recovery::new(folder))));
        self.session.left_behind = left_behind(folder);
    }

    /// The title says what is shown, and whether it has edits that no file holds.
    pub(super) fn update_title(&mut self) {
        let (Some(graphics), Some(open)) = (&self.graphics, &self.session.open) else { return };
        let mark = if self.session.has_unsaved_edits() { "• " } else { "" };
        let title = format!("{mark}{} – voxtrace", open.original.name);
        if title != self.title {
            graphics.window.set_title(&title);
            self.title = title;
        }
    }

    /// Writes the recovery file where one is due, and deletes it where a file holds the edits.
    pub(super) fn keep_edits(&mut self) {
        if self.recovering.writing.as_ref().is_some_and(|writing| !writing.is_finished()) {
            return;
        }
        if let Some((scene, note)) = self.session.recovery_due(Instant::now()) {
            self.write_edits(scene, note);
        } else if self.recovering.is_written && !self.session.has_unsaved_edits() {
            self.forget_edits();
        }
    }

    fn write_edits(&mut self, scene: Arc<PackedScene>, note: Note) {
        let Some(file) = self.recovering.file.clone() else { return };
        let (proxy, before) = (self.proxy.clone(), self.session.recovered.take());
        self.recovering.is_written = true;
        self.recovering.writing = Some(std::thread::spawn(move || {
            threads::yield_to_window();
            let written = file.lock().unwrap_or_else(PoisonError::into_inner).write(&scene, &note);
            // What was opened from an earlier one is in this one now.
            if let (Ok(()), Some(before)) = (&written, before) {
                before.discard();
            }
            if let Err(error) = written {
                // The window may be closed.
                let _ = proxy.send_event(Wake::Unkept(error));
            }
        }));
    }

    /// Deletes the recovery files: a file holds the edits, or nobody wants them.
    pub(super) fn forget_edits(&mut self) {
        self.recovering.is_written = false;
        if let Some(file) = &self.recovering.file {
            file.lock().unwrap_or_else(PoisonError::into_inner).remove();
        }
        if let Some(before) = self.session.recovered.take() {
            before.discard();
        }
    }

    /// The window closes: edits that nobody said to be lost are kept, where a signal ended the program.
    pub(super) fn end_edits(&mut self) {
        if let Some(writing) = self.recovering.writing.take() {
            // A panic was printed when it happened.
            let _ = writing.join();
        }
        match self.session.recovery_now() {
            Some((scene, note)) => {
                self.write_edits(scene, note);
                self.recovering.writing.take().into_iter().for_each(|writing| _ = writing.join());
            }
            None if !self.session.has_unsaved_edits() || self.session.is_discarding => self.forget_edits(),
            None => {}
        }
    }
}
