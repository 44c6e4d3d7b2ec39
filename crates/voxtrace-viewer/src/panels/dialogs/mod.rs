//! The dialogs over the picture, drawn.

mod frames;
mod path;
mod picture;
mod plan;
mod record;
mod scene;

use super::{Status, fit, in_sight, under_way};
use crate::dialogs::{Dialog, PRESETS, Quality, RecordDialog};
use crate::session::{Command, Session};
use crate::tr;
use egui::{Align2, Button, ComboBox, DragValue, Id, Key, ProgressBar, RichText, Ui};

/// Width of a dialog, points, and what its frame takes of that of a smaller window.
const WIDTH: f32 = 560.0;
const FRAME: f32 = 24.0;

/// What a click in a dialog asks for.
enum Click {
    Close,
    Browse,
    Go,
}

/// Shows the dialog that is open.
pub fn show(ui: &Ui, session: &mut Session, status: &Status, side: f32) {
    let Some(mut dialog) = session.dialog.take() else { return };
    let title = match &dialog {
        Dialog::Picture(_) => tr!("dialogs.picture"),
        Dialog::Frames(_) => tr!("dialogs.frames"),
        Dialog::Plan(_) => tr!("dialogs.plan"),
        Dialog::Record(_) => tr!("dialogs.record"),
        Dialog::Save(_) => tr!("dialogs.save"),
        Dialog::Open(_) => tr!("dialogs.open"),
        Dialog::New(_) => tr!("dialogs_new.title"),
    };
    let mut is_open = true;
    let mut clicked = None;
    egui::Window::new(title)
        .open(&mut is_open)
        .pivot(Align2::CENTER_CENTER)
        .default_pos(ui.ctx().content_rect().center() - egui::vec2(side / 2.0, 0.0))
        .collapsible(false)
        .resizable(false)
        .default_height(ui.ctx().content_rect().height())
        .show(ui.ctx(), |ui| {
            // All of it is in the window, however small that is: rows wrap.
            ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - FRAME));
            in_sight(ui, |ui| {
                clicked = match &mut dialog {
                    Dialog::Picture(dialog) => picture::show(ui, session, dialog, status),
                    Dialog::Frames(dialog) => frames::show(ui, session, dialog, status),
                    Dialog::Plan(dialog) => plan::show(ui, session, dialog),
                    Dialog::Record(dialog) => record::show(ui, session, dialog, status),
                    Dialog::Save(dialog) => scene::show_save(ui, dialog),
                    Dialog::Open(dialog) => scene::show_open(ui, dialog),
                    Dialog::New(size) => scene::show_new(ui, size),
                };
            });
        });
    match clicked {
        Some(Click::Go) => go(session, dialog),
        Some(Click::Close) => {}
        _ if !is_open => {}
        clicked => {
            session.dialog = Some(dialog);
            if matches!(clicked, Some(Click::Browse)) {
                session.ask(Command::AskForPath);
            }
        }
    }
}

/// Does what a dialog is for; where something is missing, it stays open and says so.
fn go(session: &mut Session, mut dialog: Dialog) {
    // Enter in a field asks for it, too, whatever is under way.
    let busy = match &dialog {
        Dialog::Picture(_) | Dialog::Frames(_) => session.busy_for_export(),
        Dialog::Plan(_) | Dialog::Record(_) => session.busy_for_command(),
        Dialog::Save(_) | Dialog::New(_) | Dialog::Open(_) => None,
    };
    let asked = match &mut dialog {
        _ if busy.is_some() => Err(busy.unwrap_or_default().to_owned()),
        Dialog::Picture(dialog) => dialog.request(session).map(|request| session.export(request)),
        Dialog::Frames(dialog) => dialog.request(session).map(|request| session.export(request)),
        Dialog::Plan(dialog) => dialog.request().map(|request| session.run_command(request)),
        Dialog::Record(dialog) => record_to(session, dialog),
        Dialog::Save(dialog) => dialog.request().map(|path| session.ask(Command::SaveScene(path))),
        Dialog::New(size) => {
            session.ask(Command::New(*size));
            Ok(())
        }
        Dialog::Open(dialog) => dialog.request().map(|path| session.ask(Command::Load(path.display().to_string()))),
    };
    match asked {
        Ok(()) => session.remember_quality(&dialog),
        Err(reason) => {
            session.say(reason, true);
            session.dialog = Some(dialog);
        }
    }
}

/// Records the timeline, which is kept in its file first.
fn record_to(session: &mut Session, dialog: &mut RecordDialog) -> Result<(), String> {
    dialog.check(session)?;
    let file = session.save_timeline().ok_or(tr!("timeline.not_kept"))?;
    dialog.request(session, file).map(|request| session.run_command(request))
}

/// Size, samples and background.
fn quality(ui: &mut Ui, session: &Session, quality: &mut Quality) {
    let window = <[u32; 2]>::from(session.size());
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr!("dialogs.size"));
        ui.add(DragValue::new(&mut quality.size[0]).range(1..=65_536)).labelled_by(label.id);
        let label = ui.label("×");
        ui.add(DragValue::new(&mut quality.size[1]).range(1..=65_536)).labelled_by(label.id);
        let here = PRESETS.iter().find(|(_, size)| *size == quality.size).map(|(name, _)| *name);
        let here = here.unwrap_or(if quality.size == window {
            tr!("dialogs.size_of_window")
        } else {
            tr!("dialogs.another_size")
        });
        fit(ui, ui.spacing().combo_width, tr!("dialogs.preset"));
        ComboBox::from_label(tr!("dialogs.preset")).selected_text(here).show_ui(ui, |ui| {
            for (name, size) in [(tr!("dialogs.size_of_window"), window)].into_iter().chain(PRESETS) {
                if ui.selectable_label(quality.size == size, name).clicked() {
                    quality.size = size;
                }
            }
        });
    });
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr!("dialogs.samples_a_pixel"));
        ui.add(DragValue::new(&mut quality.samples).range(1..=1 << 20)).labelled_by(label.id);
        ui.checkbox(&mut quality.transparent, tr!("dialogs.transparent_background"));
    });
}

/// About how long it takes, where the window knows how quick it is.
fn estimate(ui: &mut Ui, session: &Session, quality: &Quality, status: &Status, pictures: usize) {
    if let Some(ms) = status.percentile(0.5) {
        let seconds = quality.estimate(session, ms, pictures);
        ui.label(RichText::new(tr!("dialogs.takes", time = duration(seconds))).weak());
    }
}

/// A time as people say it.
pub fn duration(seconds: f64) -> String {
    match seconds {
        seconds if seconds < 1.0 => tr!("dialogs.a_second").into(),
        seconds if seconds < 120.0 => format!("{seconds:.0} s"),
        seconds if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        seconds => format!("{:.1} h", seconds / 3600.0),
    }
}

/// What is missing yet, and the buttons below a dialog. Enter is the first of them where nothing has the keyboard.
fn buttons(ui: &mut Ui, name: &str, missing: Option<&str>, others: impl FnOnce(&mut Ui)) -> Option<Click> {
    let has_keyboard = ui.memory(|memory| memory.focused().is_some());
    // A field that Enter has just ended had it.
    let is_free = ui.data_mut(|data| !std::mem::replace(data.get_temp_mut_or(Id::NULL.with(name), true), has_keyboard));
    let is_entered = is_free && !has_keyboard && ui.input(|input| input.key_pressed(Key::Enter));
    let mut clicked = (is_entered && missing.is_none()).then_some(Click::Go);
    if let Some(missing) = missing {
        ui.label(RichText::new(missing).color(super::look::error_color(ui)));
    }
    ui.separator();
    ui.horizontal_wrapped(|ui| {
        if ui.add_enabled(missing.is_none(), Button::new(name)).clicked() {
            clicked = Some(Click::Go);
        }
        others(ui);
        if ui.button(tr!("dialogs.cancel")).clicked() {
            clicked = Some(Click::Close);
        }
    });
    clicked
}

/// How far an export is, with a button that stops it, beside the side panel, of `side` points, and `below` above the lower edge. Returns how high it is.
pub fn exporting(ui: &Ui, session: &mut Session, side: f32, below: f32) -> f32 {
    let Some(export) = &session.exporting else {
        let Some(path) = session.written_file() else { return 0.0 };
        let text = tr!("dialogs.writing_path", path = path.display());
        return under_way(ui, tr!("dialogs.writing"), side, below, |ui| {
            ui.horizontal(|ui| (ui.spinner(), ui.label(text)));
        });
    };
    let share = export.share();
    let left = export.seconds_left().map_or(String::new(), |seconds| tr!("running.left", time = duration(seconds)));
    let pictures = match export.pictures {
        1 => String::new(),
        pictures => tr!("dialogs.of_frames", done = export.done(), pictures = pictures) + " ",
    };
    let text = format!("{pictures}{:.0} %{left}", share * 100.0);
    let name = export.name.clone();
    let mut is_cancelled = false;
    let height = under_way(ui, tr!("dialogs.rendering"), side, below, |ui| {
        ui.label(name);
        ui.add(ProgressBar::new(share).desired_width(320.0).text(text));
        is_cancelled = super::stop_button(ui, tr!("dialogs.stop_rendering"));
    });
    ui.ctx().request_repaint_after(std::time::Duration::from_millis(250));
    if is_cancelled && let Some(export) = &session.exporting {
        export.cancel();
    }
    height
}
