//! The panel of a cloud of points: what colours them, which classes are shown, how many points make a voxel.

use super::{Noun, counted, section};
use crate::cloud::{COLORS, Points};
use crate::session::Session;
use crate::strings::text;
use crate::tr;
use egui::{ComboBox, DragValue, Ui};
use std::ops::RangeInclusive;
use voxtrace::import::ClassSet;

/// Most points that a voxel is asked for.
const MOST_POINTS: u32 = 1000;
/// Most voxels along the longest side that the panel asks for; the command line takes more.
const MOST_ACROSS: u32 = 20_000;

pub fn points(ui: &mut Ui, session: &mut Session) {
    let Some(points) = session.points.clone() else { return };
    section(ui, tr!("points.title"), "points", |ui| {
        ui.label(counted(points.seen.count, Noun::Point));
        let mut choice = points.choice.clone();
        let now = choice.color_by.unwrap_or(tr!("points.as_opened"));
        ComboBox::from_label(tr!("points.coloured_by")).selected_text(now).show_ui(ui, |ui| {
            for (word, about) in COLORS.into_iter().filter(|(word, _)| has(&points, word)) {
                if ui.selectable_label(choice.color_by == Some(word), word).on_hover_text(text(about)).clicked() {
                    choice.color_by = Some(word);
                }
            }
        });
        let least = choice.min_points.unwrap_or(1);
        if let Some(least) = number(ui, tr!("points.least"), None, least, 1..=MOST_POINTS) {
            choice.min_points = Some(least);
        }
        if let Some(across) = across(session) {
            let about = Some(tr!("points.resolution_about"));
            if let Some(wanted) = number(ui, tr!("points.resolution"), about, across, 8..=MOST_ACROSS) {
                choice.resolution = Some(wanted);
            }
        }
        for &(class, count) in &points.seen.classes {
            let mut is_shown = points.shows(class);
            let name = ClassSet::name_of(class)
                .map_or_else(|| tr!("points.class", class = class), |name| format!("{class} {name}"));
            if ui.checkbox(&mut is_shown, format!("{name}: {}", counted(count, Noun::Point))).changed() {
                choice = points.with_class(class, is_shown);
            }
        }
        if choice != points.choice {
            session.set_points(choice);
        }
    });
}

/// Voxels along the longest side of the scene.
fn across(session: &Session) -> Option<u32> {
    let (min, max) = session.open.as_ref()?.original.bounds()?;
    Some((max - min).max_element() as u32)
}

/// A number that is dragged or typed. The file is read again when the hand is done, not on the way: then it comes back.
fn number(ui: &mut Ui, name: &str, about: Option<&str>, now: u32, range: RangeInclusive<u32>) -> Option<u32> {
    ui.horizontal(|ui| {
        let id = ui.id().with(name);
        let waiting = ui.data(|data| data.get_temp::<u32>(id));
        let mut shown = waiting.unwrap_or(now);
        let drag = ui.add(DragValue::new(&mut shown).range(range).clamp_existing_to_range(false));
        let label = ui.label(name);
        let drag = drag.labelled_by(label.id);
        about.into_iter().for_each(|about| _ = label.clone().on_hover_text(about));
        if drag.changed() {
            ui.data_mut(|data| data.insert_temp(id, shown));
        }
        let wanted = if drag.changed() { Some(shown) } else { waiting };
        let is_done = wanted.is_some() && !drag.dragged() && !drag.has_focus();
        if is_done {
            ui.data_mut(|data| data.remove::<u32>(id));
        }
        wanted.filter(|_| is_done)
    })
    .inner
}

/// Whether the points have what a word of `--color-by` asks for.
fn has(points: &Points, word: &str) -> bool {
    let attributes = points.seen.attributes;
    match word {
        "rgb" => attributes.colors,
        "intensity" => attributes.intensities,
        "classification" => attributes.classes,
        _ => true,
    }
}
