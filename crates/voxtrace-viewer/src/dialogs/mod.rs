//! The dialogs over the picture, as plain values: what somebody has chosen so far, and what follows from it. The panels draw and change them.

mod frames;
mod open;
mod path_field;
mod picture;
mod plan;
mod quality;
mod record;

pub use frames::{FramesDialog, Route, ffmpeg_line};
pub use open::{OpenDialog, SCENE_KINDS, SaveDialog};
pub use path_field::{MOST_OFFERED, Offer, PathField};
pub use picture::{PictureDialog, PictureKind};
pub use plan::PlanDialog;
pub use quality::{LastQuality, PRESETS, Quality};
pub use record::{RecordDialog, RecordKind};

use crate::export::{End, ExportRequest, Outcome};
use crate::session::{Command, Session};
use crate::tr;
use std::path::{Path, PathBuf};

/// A dialog that is open; there is one at a time.
#[derive(Clone, Debug)]
pub enum Dialog {
    /// Rendering a picture to a file.
    Picture(PictureDialog),
    /// Rendering a turntable or a flight to numbered frames.
    Frames(Box<FramesDialog>),
    /// Playing a benchmark plan.
    Plan(Box<PlanDialog>),
    /// Recording the timeline.
    Record(Box<RecordDialog>),
    /// Writing the scene to a file.
    Save(SaveDialog),
    /// Opening a scene by its path.
    Open(OpenDialog),
    /// Beginning a scene, of so many voxels along each side.
    New([u32; 3]),
}

impl Dialog {
    /// The path that is typed in it, where one is.
    pub fn path_field(&mut self) -> Option<&mut PathField> {
        Some(match self {
            Self::New(_) => return None,
            Self::Picture(dialog) => &mut dialog.path,
            Self::Frames(dialog) => &mut dialog.folder,
            Self::Plan(dialog) => &mut dialog.plan,
            Self::Record(dialog) => &mut dialog.path,
            Self::Save(dialog) => &mut dialog.path,
            Self::Open(dialog) => &mut dialog.path,
        })
    }

    /// Takes a path that the system's dialog gave.
    pub fn take_path(&mut self, path: &Path) {
        if let Some(field) = self.path_field() {
            *field = PathField::new(path);
        }
        if let Self::Picture(dialog) = self {
            dialog.take_kind_of_path();
        }
    }
}

/// What a Tab is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TabUse {
    /// It completes the path that is typed.
    Completion,
    /// It leads to the next field of the dialog.
    NextField,
    /// It is a key of the window.
    Window,
}

impl Session {
    /// Takes a Tab that is pressed. Says what it is for.
    pub fn take_tab(&mut self) -> TabUse {
        let Some(dialog) = &mut self.dialog else { return TabUse::Window };
        let path = dialog.path_field().filter(|path| path.is_focused);
        if path.is_some_and(PathField::take_tab) { TabUse::Completion } else { TabUse::NextField }
    }

    /// Where files go whose folder nobody named: beside the scene that was opened from a file, else where the program was started.
    pub fn usual_folder(&self) -> PathBuf {
        let of_scene = self.open.as_ref().map(|open| Path::new(&open.source)).and_then(Path::parent);
        let of_scene = of_scene.filter(|folder| folder.is_absolute()).map(Path::to_path_buf);
        of_scene.or_else(|| std::env::current_dir().ok()).unwrap_or_default()
    }

    /// What files are called after: the scene's file or name.
    pub fn stem(&self) -> String {
        let source = self.open.as_ref().map_or("scene", |open| open.source.as_str());
        let stem = Path::new(source).file_stem().unwrap_or_default().to_string_lossy();
        // `head.nii.gz` is `head`, as for pictures of `render`.
        stem.strip_suffix(".nii").unwrap_or(&stem).to_owned()
    }

    /// Why no pictures can be rendered to files now: others are, or something is measured, which nothing is to disturb.
    pub fn busy_for_export(&self) -> Option<&'static str> {
        match (&self.exporting, self.is_measured()) {
            (Some(_), _) => Some(tr!("dialogs.busy")),
            (None, true) => Some(tr!("running.busy_short")),
            (None, false) => None,
        }
    }

    /// Why no command can run beside the window now.
    pub fn busy_for_command(&self) -> Option<&'static str> {
        let is_busy = self.running.is_some() || self.exporting.is_some() || self.benchmark.is_some();
        is_busy.then(|| tr!("running.busy_short"))
    }

    /// Begins an export, unless one is under way.
    pub fn export(&mut self, request: ExportRequest) {
        if self.exporting.is_some() {
            self.say(tr!("said.another_picture_is_being_rendered_wait"), true);
            return;
        }
        self.dialog = None;
        self.ask(Command::Export(Box::new(request)));
    }

    /// Takes what has come of an export.
    pub fn take_exported(&mut self) {
        let Some((name, outcome)) =
            self.exporting.as_mut().and_then(|export| Some((export.name.clone(), export.take()?)))
        else {
            return;
        };
        self.exporting = None;
        let Outcome { written, kept, notes, end } = outcome;
        notes.into_iter().for_each(|note| self.say(note, false));
        let kept = if kept > 0 { tr!("dialogs.kept", kept = kept) } else { String::new() };
        match end {
            End::Done => self.say(tr!("said.written", name = name, kept = kept), false),
            End::Cancelled => {
                self.say(tr!("said.stopped_of_written", written = written, name = name, kept = kept), false)
            }
            End::Failed(reason) => self.say(reason, true),
        }
    }
}
