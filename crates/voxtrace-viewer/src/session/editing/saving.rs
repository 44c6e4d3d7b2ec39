//! Edits that no file holds yet: where they are saved, what asks before they or changes of the timeline are lost, and the file from which edits come back after
//! a crash.

use crate::dialogs::{Dialog, SaveDialog};
use crate::editing::Saved;
use crate::editing::recovery::{Left, Note};
use crate::panels::{Noun, counted};
use crate::session::{Command, Session};
use crate::tr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::PackedScene;
use voxtrace::packed::PackedGrid;

/// What a `.vox` file holds: colours, and voxels along an edge of a model.
const MOST_COLORS: usize = 255;
const MOST_ACROSS: i32 = 256;
/// Time between two recovery files.
const BETWEEN_RECOVERIES: Duration = Duration::from_secs(60);

/// What would lose edits, or changes of the timeline, that no file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Leaving {
    /// The window is to be closed.
    Quit,
    /// Another scene is to be opened.
    Load(String),
    /// An empty one of so many voxels along each side.
    New([u32; 3]),
}

impl Leaving {
    fn command(self) -> Command {
        match self {
            Self::Quit => Command::Quit,
            Self::Load(source) => Command::Load(source),
            Self::New(size) => Command::New(size),
        }
    }
}

impl Session {
    /// Whether the scene has edits that no file holds.
    pub fn has_unsaved_edits(&self) -> bool {
        self.editing.as_ref().is_some_and(crate::editing::Editing::is_unsaved)
    }

    /// Whether the scene may be left: where no file holds its edits, or the changes of its timeline, somebody is asked first.
    pub fn may_leave(&mut self, leaving: Leaving) -> bool {
        if (!self.has_unsaved_edits() || self.is_discarding) && !self.has_unsaved_timeline() {
            return true;
        }
        self.dialog = None;
        self.leaving = Some(leaving);
        false
    }

    /// Saves the edits and the timeline, then does what was asked for. Where the timeline cannot be saved, the question stays.
    pub fn save_and_leave(&mut self) {
        if self.has_unsaved_timeline() && self.save_timeline().is_none() {
            return;
        }
        if self.has_unsaved_edits() {
            self.is_leaving_saved = true;
            self.save_edits();
        } else if let Some(leaving) = self.leaving.take() {
            self.ask(leaving.command());
        }
    }

    /// Does what was asked for without saving.
    pub fn discard_and_leave(&mut self) {
        if let Some(leaving) = self.leaving.take() {
            (self.is_discarding, self.timeline.is_given_up) = (true, true);
            self.ask(leaving.command());
        }
    }

    /// Stays.
    pub fn stay(&mut self) {
        (self.leaving, self.is_leaving_saved) = (None, false);
    }

    /// Saves the edits to the file that they were saved to before, or asks for one.
    pub fn save_edits(&mut self) {
        let saved = self.editing.as_ref().and_then(|editing| editing.saved.clone());
        match (saved, self.has_unsaved_edits()) {
            (_, false) if self.editing.as_ref().is_none_or(|editing| !editing.has_edits()) => {
                self.say(tr!("edit.nothing_edited"), false);
            }
            (Some(saved), false) => self.say(tr!("edit.all_saved", path = saved.path.display()), false),
            (Some(saved), true) => self.ask(Command::SaveScene(saved.path)),
            (None, _) => {
                self.leaving_dialog();
                self.dialog = Some(Dialog::Save(SaveDialog::new(self)));
            }
        }
    }

    /// The dialog for the file takes the place of the question.
    fn leaving_dialog(&mut self) {
        if !self.is_leaving_saved {
            self.leaving = None;
        }
    }

    /// What a `.vox` file does not keep of the scene as it is.
    fn lost_in_vox(&self) -> Vec<String> {
        let Some(open) = &self.open else { return Vec::new() };
        let mut lines = Vec::new();
        let materials = open.used_materials().map_or(open.original.materials().len(), <[usize]>::len);
        if materials > MOST_COLORS {
            lines.push(tr!("edit.vox_colours", most = MOST_COLORS, materials = materials));
        }
        let is_large = |grid: &PackedGrid| (grid.max - grid.min).max_element() > MOST_ACROSS;
        let large = open.original.grids().iter().filter(|grid| is_large(grid)).count() as u64;
        if large > 0 {
            let what = counted(large, Noun::Model);
            lines.push(tr!("edit.vox_size", most = MOST_ACROSS, what = what));
        }
        lines
    }

    /// The scene begins to be written as it is now.
    pub fn begin_saving(&mut self, path: &Path) {
        self.end_stroke();
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vox")) {
            self.lost_in_vox().into_iter().for_each(|line| self.say(line, false));
        }
        let Some(open) = &self.open else { return };
        let hidden =
            open.is_visible.iter().zip(&open.original.outline.objects).filter(|(seen, own)| !**seen && !own.is_hidden);
        let hidden = hidden.count() as u64;
        if let Some(editing) = &mut self.editing {
            let (path, is_visible) = (path.to_owned(), open.is_visible.clone());
            editing.saving = Some(Saved { path, state: editing.state(), is_visible });
            if hidden > 0 && editing.is_unsaved() {
                let what = counted(hidden, Noun::Object);
                self.say(tr!("edit.hidden_not_written", what = what), false);
            }
        }
    }

    /// The scene was written, or not.
    pub fn end_saving(&mut self, is_written: bool) {
        let saving = self.editing.as_mut().and_then(|editing| editing.saving.take());
        if let (true, Some(saving), Some(editing)) = (is_written, saving, &mut self.editing) {
            // What was begun here has a place from now on, and with it bookmarks and measurements.
            let untitled = self.open.as_mut().filter(|open| open.source == crate::canvas::NAME);
            let gets_place = untitled.map(|open| open.source = saving.path.display().to_string()).is_some();
            editing.saved = Some(saving);
            let has_failed = editing.has_failed;
            if gets_place {
                self.keep_measures();
            }
            if has_failed {
                // What it asked for was done.
                let before = tr!("edit.cannot", reason = tr!("edit.fault"));
                self.say_instead(&[&before], tr!("edit.cannot", reason = tr!("edit.fault_saved")));
            }
        }
        if std::mem::take(&mut self.is_leaving_saved)
            && let Some(leaving) = self.leaving.take()
            && !self.has_unsaved_edits()
            // That of a scene that has a place from now on.
            && (!self.has_unsaved_timeline() || self.save_timeline().is_some())
        {
            self.ask(leaving.command());
        }
    }

    /// The file that holds the edited scene as it is shown, `Ok(None)` where it is the one that was opened.
    ///
    /// # Errors
    /// One line: there is none.
    pub(crate) fn edited_file(&self) -> Result<Option<PathBuf>, &'static str> {
        let (Some(editing), Some(open)) = (&self.editing, &self.open) else { return Ok(None) };
        if self.is_untitled() {
            return Err(tr!("edit.no_file"));
        }
        if !editing.has_edits() && !editing.is_recovered {
            return Ok(None);
        }
        let saved = editing.saved.as_ref().filter(|saved| saved.state == editing.state());
        let saved = saved.ok_or(tr!("edit.unsaved"))?;
        if saved.is_visible != open.is_visible {
            return Err(tr!("edit.hidden_not_in_file"));
        }
        let is_native = saved.path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vxt"));
        if !is_native {
            return Err(tr!("edit.vox_keeps"));
        }
        Ok(Some(saved.path.clone()))
    }

    /// What a recovery file is to hold now, where one is due.
    pub fn recovery_due(&mut self, now: Instant) -> Option<(Arc<PackedScene>, Note)> {
        let is_unsaved = self.has_unsaved_edits();
        let (Some(editing), Some(open)) = (&mut self.editing, &self.open) else { return None };
        if !is_unsaved || editing.stroke.is_some() {
            return None;
        }
        let state = editing.state();
        let (since, written) = *editing.recovered.get_or_insert((now, (0, 0)));
        if written == state || now.saturating_duration_since(since) < BETWEEN_RECOVERIES {
            return None;
        }
        editing.recovered = Some((now, state));
        let saved_to = editing.saved.as_ref().map(|saved| saved.path.clone());
        let note = Note { name: open.original.name.clone(), source: open.source.clone(), saved_to };
        Some((Arc::clone(&open.original), note))
    }

    /// What a recovery file holds whenever the program has to end.
    pub fn recovery_now(&mut self) -> Option<(Arc<PackedScene>, Note)> {
        if self.is_discarding {
            return None;
        }
        self.end_stroke();
        let editing = self.editing.as_mut()?;
        let (_, written) = editing.recovered?;
        editing.recovered = Some((Instant::now().checked_sub(BETWEEN_RECOVERIES)?, written));
        self.recovery_due(Instant::now())
    }

    /// Opens edits that a window left behind.
    pub fn recover(&mut self, left: Left) {
        self.ask(Command::Load(left.scene.display().to_string()));
        self.recovering = Some(left);
    }

    /// The scene that has come was left behind by a window: it goes on as the scene that was edited there.
    pub(crate) fn take_recovered(&mut self) {
        let Some(open) = &mut self.open else { return };
        let is_that = |left: &Left| {
            let whole = std::path::absolute(&left.scene);
            Path::new(&open.source) == left.scene || whole.is_ok_and(|whole| Path::new(&open.source) == whole)
        };
        let Some(left) = self.recovering.take_if(|left| is_that(left)) else { return };
        open.source = left.note.source.clone();
        self.editing = Some(crate::editing::Editing { is_recovered: true, ..Default::default() });
        self.ask(Command::Edit);
        self.say(tr!("edit.recovered"), false);
        self.recovered = Some(left);
    }
}
