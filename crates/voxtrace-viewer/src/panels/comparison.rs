//! The panel of two tracers on one view, and the divider between their pictures.

use super::status::Status;
use super::{Noun, counted, grouped, heading};
use crate::comparison::{Comparison, tracer_name};
use crate::engine::Contrast;
use crate::keys::Action;
use crate::session::Session;
use crate::tr;
use egui::{Align2, Color32, ComboBox, CursorIcon, FontId, LayerId, Order, Stroke, Ui, pos2};
use voxtrace_vulkan::{Primitive, Traversal};

pub fn comparison(ui: &mut Ui, session: &mut Session, status: &Status) {
    heading(ui, tr!("comparison.compare"));
    let mut is_on = session.comparison.is_some();
    if ui.checkbox(&mut is_on, tr!("comparison.with_another_tracer")).changed() {
        session.act(Action::Compare, None);
    }
    let Some(mut own) = session.comparison.clone() else { return };
    ComboBox::from_label(tr!("comparison.other_traversal")).selected_text(own.traversal.name()).show_ui(ui, |ui| {
        for &traversal in &session.traversals {
            ui.selectable_value(&mut own.traversal, traversal, traversal.name());
        }
    });
    if own.traversal.uses_primitives() {
        ComboBox::from_label(tr!("comparison.other_primitive")).selected_text(own.primitive.name()).show_ui(ui, |ui| {
            for primitive in Primitive::ALL {
                ui.selectable_value(&mut own.primitive, primitive, primitive.name());
            }
        });
    }
    if own.traversal != Traversal::Cpu {
        ui.checkbox(&mut own.fast, tr!("comparison.other_fast"));
    }
    ComboBox::from_label(tr!("comparison.shown")).selected_text(own.contrast.name()).show_ui(ui, |ui| {
        for contrast in Contrast::ALL {
            ui.selectable_value(&mut own.contrast, contrast, contrast.name());
        }
    });
    let samples = status.other.as_ref().map_or(0, |other| other.samples);
    ui.label(tr!("comparison.samples", samples = samples, all = session.render_settings.samples));
    ui.label(verdict(&own, status));
    let is_changed = session.comparison.as_ref() != Some(&own);
    if is_changed {
        session.set_comparison(Some(own));
    }
    if ui.button(tr!("comparison.copy_the_other_s_command")).clicked() {
        session.copy_other_command();
    }
}

/// How many pixels differ, for people.
fn verdict(own: &Comparison, status: &Status) -> String {
    let (is_films, none) = match own.contrast {
        Contrast::Beside => return tr!("comparison.drag").into(),
        Contrast::Films => (true, tr!("comparison.no_films")),
        Contrast::Voxels => (false, tr!("comparison.no_voxels")),
    };
    let Some(differences) = &status.differences else { return none.into() };
    let share = format!("{:.3}", differences.count as f64 / differences.pixels.max(1) as f64 * 100.0);
    let (count, pixels) = (grouped(differences.count), counted(differences.pixels, Noun::Pixel));
    if is_films {
        let samples = counted(differences.samples.into(), Noun::Sample);
        tr!("comparison.films_differ", count = count, pixels = pixels, share = share, samples = samples)
    } else {
        tr!("comparison.voxels_differ", count = count, pixels = pixels, share = share)
    }
}

/// The divider over the picture, which is as wide as the window without the panel of `side` points. What drags it is the mouse over the
/// picture: see `input`.
pub fn divider(ui: &Ui, session: &Session, side: f32) {
    let Some(comparison) = session.comparison.as_ref().filter(|_| session.open.is_some()) else { return };
    if comparison.contrast != Contrast::Beside {
        return;
    }
    let picture = super::picture(ui, session, side);
    let x = picture.left() + comparison.split * picture.width();
    let is_held = session.hover.is_some_and(|cursor| session.is_on_divider(cursor));
    if is_held {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    let painter = ui.ctx().layer_painter(LayerId::new(Order::Background, "divider".into()));
    let line = Stroke::new(if is_held { 3.0 } else { 1.5 }, Color32::from_white_alpha(220));
    // A dark line around a bright one is seen on any picture.
    painter.vline(x, picture.y_range(), Stroke::new(line.width + 2.0, Color32::from_black_alpha(120)));
    painter.vline(x, picture.y_range(), line);
    painter.circle(pos2(x, picture.center().y), 7.0, Color32::from_black_alpha(160), line);
    let (left, right) = (tracer_name(session.backend()), tracer_name(comparison.backend()));
    for (text, align, dx) in [(left, Align2::RIGHT_TOP, -10.0), (right, Align2::LEFT_TOP, 10.0)] {
        let galley = painter.layout_no_wrap(text, FontId::proportional(13.0), Color32::WHITE);
        let place = align.anchor_size(pos2(x + dx, picture.top() + 8.0), galley.size());
        painter.rect_filled(place.expand(4.0), 3.0, Color32::from_black_alpha(170));
        painter.galley(place.min, galley, Color32::WHITE);
    }
}
