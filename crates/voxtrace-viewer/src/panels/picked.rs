//! The panel of the voxel that was picked.

use super::heading;
use crate::keys::Action;
use crate::session::Session;
use egui::Ui;

pub fn picked(ui: &mut Ui, session: &mut Session) {
    let (Some(picked), Some(open)) = (&session.picked, &session.open) else { return };
    heading(ui, "Picked voxel");
    let voxel = picked.hit.voxel;
    let material = &open.lit.materials()[picked.material as usize];
    let color = material.base_color;
    let srgb = color.map(|value| (voxtrace::material::encode_srgb(value.into()) * 255.0) as f32);
    ui.label(format!("voxel {}, {}, {} of object {}", voxel.x, voxel.y, voxel.z, picked.hit.instance));
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
        let fill = egui::Color32::from_rgb(srgb.x as u8, srgb.y as u8, srgb.z as u8);
        ui.painter_at(rect).rect_filled(rect, 2.0, fill);
        ui.label(format!("material {}, #{:02x}{:02x}{:02x}", picked.material, fill.r(), fill.g(), fill.b()));
    });
    let point = picked.point;
    ui.label(format!("at {:.2}, {:.2}, {:.2}", point.x, point.y, point.z));
    if ui.button("frame it").clicked() {
        session.act(Action::FramePicked, None);
    }
}
