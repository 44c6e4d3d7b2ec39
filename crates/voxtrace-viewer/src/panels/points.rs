//! The panel of a cloud of points: what colours them, which classes are shown, how many points make a voxel.

use super::{Noun, counted, section};
use crate::cloud::{COLORS, Points};
use crate::session::Session;
use crate::strings::text;
use crate::tr;
use egui::{ComboBox, DragValue, Ui};
use voxtrace::import::ClassSet;

/// Most points that a voxel is asked for.
const MOST_POINTS: u32 = 1000;

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
        let mut least = choice.min_points.unwrap_or(1);
        let label = ui.label(tr!("points.least"));
        let drag = ui.add(DragValue::new(&mut least).range(1..=MOST_POINTS)).labelled_by(label.id);
        // The file is read again when the hand is done, not on the way.
        let id = ui.id().with("least points");
        if drag.changed() {
            ui.data_mut(|data| data.insert_temp(id, least));
        }
        if let Some(wanted) = ui.data(|data| data.get_temp::<u32>(id))
            && !drag.dragged()
            && !drag.has_focus()
        {
            ui.data_mut(|data| data.remove::<u32>(id));
            choice.min_points = Some(wanted);
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
