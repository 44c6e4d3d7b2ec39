//! The panel of materials: those that a voxel has, each with its colour and what it emits, to be changed.

use super::{Noun, counted, name_node};
use crate::session::Session;
use crate::tr;
use egui::{CollapsingHeader, DragValue, ScrollArea, Ui};
use std::time::Duration;
use voxtrace::changes::MaterialChange;
use voxtrace::glam::Vec3;
use voxtrace::material::{linear_color, srgb_from_linear};

/// Points of the list before it scrolls.
const HEIGHT: f32 = 200.0;
/// Time until one looks again whether the materials in use are known.
const SOON: Duration = Duration::from_millis(100);

pub fn materials(ui: &mut Ui, session: &mut Session) {
    let Some(open) = &session.open else { return };
    let count = open.original.materials().len() as u64;
    let changed = open.materials.len();
    let title =
        if changed > 0 { tr!("materials.title_changed", changed = changed) } else { tr!("materials.title").into() };
    CollapsingHeader::new(title).id_salt("materials").show(ui, |ui| {
        let Some(used) = session.open.as_ref().and_then(|open| open.used_materials().map(<[usize]>::to_vec)) else {
            ui.label(tr!("materials.looking_which_are_in_use"));
            ui.ctx().request_repaint_after(SOON);
            return;
        };
        ui.label(tr!("materials.in_use", used = used.len(), all = counted(count, Noun::Material)));
        let height = ui.spacing().interact_size.y;
        let area = ScrollArea::vertical().id_salt("materials").max_height(HEIGHT).min_scrolled_height(HEIGHT);
        // As wide as there is room: its bar would lie on the rows.
        area.auto_shrink([false, true]).show_rows(ui, height, used.len(), |ui, rows| {
            for &number in &used[rows] {
                material(ui, session, number);
            }
        });
    });
}

/// The line of one material.
pub fn material(ui: &mut Ui, session: &mut Session, number: usize) {
    let Some(now) = session.material(number) else { return };
    ui.horizontal(|ui| {
        let mut srgb = now.base_color.to_array().map(srgb_from_linear);
        let picker = ui.color_edit_button_srgb(&mut srgb);
        name_node(ui, &picker, &tr!("materials.colour", number = number));
        let label = ui.monospace(format!("{number:>4}"));
        let color = format!("#{:02x}{:02x}{:02x}", srgb[0], srgb[1], srgb[2]);
        label.on_hover_text(tr!("edit.material", number = number, color = color));
        let change = MaterialChange { number, base_color: now.base_color, emission: emission_of(session, number) };
        if picker.changed() {
            session.set_material(MaterialChange { base_color: linear_color(srgb), ..change });
        }
        let strength = now.emission.max_element();
        let mut wanted = strength;
        let speed = (0.02 * strength).max(0.02);
        let drag =
            DragValue::new(&mut wanted).range(0.0..=1e6).speed(speed).prefix(tr!("materials.glows")).max_decimals(2);
        let drag = ui.add(drag);
        name_node(ui, &drag, &tr!("materials.emission", number = number));
        if drag.changed() {
            let emission = glowing(now.emission, now.base_color, wanted);
            session.set_material(MaterialChange { emission: Some(emission), ..change });
        }
        if strength > 0.0 {
            let mut srgb = (now.emission / strength).to_array().map(srgb_from_linear);
            let picker = ui.color_edit_button_srgb(&mut srgb);
            name_node(ui, &picker, &tr!("materials.emission_colour", number = number));
            if picker.changed() {
                let emission = glowing(linear_color(srgb), now.base_color, strength);
                session.set_material(MaterialChange { emission: Some(emission), ..change });
            }
        }
        let is_changed = session.open.as_ref().is_some_and(|open| open.materials.contains_key(&number));
        if is_changed && ui.small_button("↺").on_hover_text(tr!("materials.reset", number = number)).clicked() {
            session.reset_material(number);
        }
    });
}

/// The emission that was chosen for a material, `None` where it is the scene's.
fn emission_of(session: &Session, number: usize) -> Option<Vec3> {
    session.open.as_ref()?.materials.get(&number)?.emission
}

/// An emission of a hue whose largest channel is `strength`; of black, the hue of the surface.
fn glowing(hue: Vec3, base_color: Vec3, strength: f32) -> Vec3 {
    let hue = if hue.max_element() > 0.0 { hue } else { base_color };
    let hue = if hue.max_element() > 0.0 { hue } else { Vec3::ONE };
    hue / hue.max_element() * strength
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_emission_keeps_its_hue_and_takes_that_of_the_surface_where_it_has_none() {
        assert_eq!(glowing(Vec3::new(1.0, 0.5, 0.0), Vec3::ONE, 6.0), Vec3::new(6.0, 3.0, 0.0));
        assert_eq!(glowing(Vec3::ZERO, Vec3::new(0.0, 0.25, 0.5), 4.0), Vec3::new(0.0, 2.0, 4.0));
        assert_eq!(glowing(Vec3::ZERO, Vec3::ZERO, 2.0), Vec3::splat(2.0));
        assert_eq!(glowing(Vec3::ONE, Vec3::ONE, 0.0), Vec3::ZERO);
    }
}
