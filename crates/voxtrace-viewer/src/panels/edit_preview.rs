//! What a tool would touch, drawn over the picture: lines of the world through the camera that shows it.

use crate::editing::outline::{Look, outlines};
use crate::projection::Projection;
use crate::session::Session;
use egui::{Color32, LayerId, Order, Pos2, Stroke, Ui, pos2};
use voxtrace::camera::Lens;
use voxtrace::glam::Vec3;

/// Parts of a line through a lens that bends lines.
const PARTS: u32 = 16;
/// Lines beyond which a preview would only be slow.
const MOST: usize = 20_000;

fn stroke(look: Look) -> Stroke {
    match look {
        Look::Own => Stroke::new(1.5, Color32::from_rgb(255, 255, 255)),
        Look::Erased => Stroke::new(1.5, Color32::from_rgb(255, 90, 80)),
        Look::Mirrored => Stroke::new(1.0, Color32::from_rgba_unmultiplied(180, 220, 255, 190)),
        Look::Plane(0) => Stroke::new(1.0, Color32::from_rgb(255, 110, 110)),
        Look::Plane(1) => Stroke::new(1.0, Color32::from_rgb(120, 230, 120)),
        Look::Plane(_) => Stroke::new(1.0, Color32::from_rgb(130, 160, 255)),
        Look::Selected => Stroke::new(1.5, Color32::from_rgb(255, 215, 80)),
        Look::Floor => Stroke::new(0.5, Color32::from_rgba_unmultiplied(200, 200, 200, 60)),
        Look::Canvas => Stroke::new(1.0, Color32::from_gray(205)),
        Look::Face => Stroke::new(2.0, Color32::from_rgb(255, 215, 80)),
    }
}

/// Draws it over the picture, beside the panel of `side` points.
pub fn preview(ui: &Ui, session: &Session, side: f32) {
    if !session.is_editing() || session.open.is_none() {
        return;
    }
    let lines = outlines(session);
    let window = ui.ctx().content_rect();
    let picture = super::picture(ui, session, side);
    let scale = ui.ctx().pixels_per_point();
    let painter =
        ui.ctx().layer_painter(LayerId::new(Order::Background, "edit preview".into())).with_clip_rect(picture);
    let camera = session.navigator.camera();
    let projection = Projection::new(camera, session.size());
    let is_straight = matches!(camera.lens, Lens::Pinhole | Lens::Thin { .. } | Lens::Orthographic { .. });
    let place = |point: Vec3| {
        let place = projection.place(point)?;
        Some(pos2(window.left() + place.x / scale, window.top() + place.y / scale))
    };
    let mut segments: Vec<([Pos2; 2], Look)> = Vec::new();
    for outline in lines {
        for pair in outline.points.windows(2) {
            let parts = if is_straight { 1 } else { PARTS };
            for part in 0..parts {
                let at = |part: u32| pair[0].lerp(pair[1], part as f32 / parts as f32);
                let Some((from, to)) = projection.before_camera(at(part), at(part + 1)) else { continue };
                if let (Some(from), Some(to)) = (place(from), place(to))
                    && projection.is_joined([from.x, from.y].into(), [to.x, to.y].into())
                {
                    segments.push(([from, to], outline.look));
                }
            }
        }
        if segments.len() > MOST {
            break;
        }
    }
    // A dark line around a bright one is seen on any picture.
    for (segment, look) in segments.iter().filter(|(_, look)| *look != Look::Floor) {
        painter.line_segment(*segment, Stroke::new(stroke(*look).width + 2.0, Color32::from_black_alpha(130)));
    }
    for (segment, look) in &segments {
        painter.line_segment(*segment, stroke(*look));
    }
}
