//! The panel of one voxel, below the others: the one that was picked, else the one under the cursor.

use super::{heading, materials};
use crate::keys::Action;
use crate::open::Open;
use crate::session::{Picked, Session};
use egui::Ui;
use voxtrace::scene::Unit;

/// The voxel that is told of, and whether it was picked.
pub fn seen(session: &Session) -> Option<(Picked, bool)> {
    let hovered = || session.hover.filter(|_| !session.is_moving()).and_then(|cursor| session.pick(cursor));
    session.picked.clone().map(|picked| (picked, true)).or_else(|| Some((hovered()?, false)))
}

pub fn picked(ui: &mut Ui, session: &mut Session, picked: &Picked, is_picked: bool) {
    let Some(open) = &session.open else { return };
    heading(ui, if is_picked { "Picked voxel" } else { "Voxel under the cursor" });
    for line in lines(open, picked) {
        ui.label(line);
    }
    materials::material(ui, session, picked.material as usize);
    if is_picked {
        ui.horizontal(|ui| {
            if ui.button("frame it").clicked() {
                session.act(Action::FramePicked, None);
            }
            if ui.button("hide its object").clicked() {
                session.act(Action::HidePicked, None);
            }
        });
    }
}

/// What is told of a voxel.
fn lines(open: &Open, picked: &Picked) -> Vec<String> {
    let voxel = picked.hit.voxel;
    let mut lines = vec![format!("voxel {}, {}, {}", voxel.x, voxel.y, voxel.z)];
    if let Some(index) = open.object_of(&picked.hit) {
        let object = open.outline.objects.get(index);
        let name = object.map(|object| object.name.as_str()).filter(|name| !name.is_empty());
        lines.push(name.map_or(format!("object {index}"), |name| format!("object {index}: {name}")));
        let layer = object.and_then(|object| Some((object.layer?, open.outline.layers.get(object.layer?)?)));
        lines.extend(layer.map(|(number, name)| match name.is_empty() {
            true => format!("layer {number}"),
            false => format!("layer {number}: {name}"),
        }));
    }
    let point = picked.point;
    lines.push(format!("at {:.2}, {:.2}, {:.2} voxels", point.x, point.y, point.z));
    if let Some(georeference) = &open.original.georeference {
        let at = georeference.coordinates_from_world.transform_point3(point.as_dvec3());
        // Coordinates that are degrees or feet are not in the unit of the scene.
        let step = georeference.coordinates_from_world.matrix3.x_axis.length();
        let is_in_unit = (step / open.original.voxel_size - 1.0).abs() < 1e-9;
        let unit = if is_in_unit { unit_name(open.original.unit) } else { "" };
        lines.push(format!("coordinates {:.3}, {:.3}, {:.3}{unit}", at.x, at.y, at.z));
        if !georeference.crs.is_empty() {
            lines.push(georeference.crs_name().to_owned());
        }
    } else if open.original.unit != Unit::Voxel {
        let at = point.as_dvec3() * open.original.voxel_size;
        lines.push(format!("at {:.3}, {:.3}, {:.3}{}", at.x, at.y, at.z, unit_name(open.original.unit)));
    }
    let color = open.lit.materials()[picked.material as usize].base_color;
    let [red, green, blue] = color.to_array().map(voxtrace::material::srgb_from_linear);
    lines.push(format!("material {}, #{red:02x}{green:02x}{blue:02x}", picked.material));
    lines
}

fn unit_name(unit: Unit) -> &'static str {
    match unit {
        Unit::Voxel => "",
        Unit::Metre => " m",
        Unit::Millimetre => " mm",
    }
}
