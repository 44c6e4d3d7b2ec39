//! The clip box and the slice over the picture: their edges, handles, and lengths.

use super::over::{Over, over};
use crate::clipping::{Grip, Handle, Of};
use crate::scale::{Quantity, Scale};
use crate::session::Session;
use egui::{Color32, CursorIcon, Stroke, Ui};
use voxtrace::glam::Vec3;

const EDGES: Color32 = Color32::from_rgb(150, 200, 255);
/// Of the axes x, y and z, as most programs paint them.
const AXES: [Color32; 3] =
    [Color32::from_rgb(255, 96, 96), Color32::from_rgb(112, 220, 96), Color32::from_rgb(96, 150, 255)];
const MIDDLE: Color32 = Color32::from_rgb(240, 240, 240);
const RADIUS: f32 = 6.0;

/// Draws them, where the scene is cut open by one.
pub fn drawn(ui: &Ui, session: &mut Session, side: f32) {
    let boxes = session.clip_boxes();
    if boxes.is_empty() {
        return;
    }
    let handles = session.handles();
    let near = session.clipping.held.or_else(|| session.handle_at(session.hover?));
    if near.is_some() {
        ui.ctx().set_cursor_icon(if session.clipping.held.is_some() { CursorIcon::Grabbing } else { CursorIcon::Grab });
    }
    over(ui, session, side, |session, over| {
        let Some(scale) = session.open.as_ref().map(|open| Scale::of(&open.original)) else { return };
        for (of, corners) in boxes {
            edges(over, of, corners, session, &scale);
        }
        for handle in handles {
            let is_near = near.is_some_and(|near| near.grip == handle.grip && near.of == handle.of);
            knob(over, &handle, is_near);
        }
    });
}

fn edges(over: &mut Over, of: Of, [min, max]: [Vec3; 2], session: &Session, scale: &Scale) {
    let corner = |number: usize| Vec3::from_array([0, 1, 2].map(|axis| [min, max][number >> axis & 1][axis]));
    for from in 0..8usize {
        for axis in [1, 2, 4].into_iter().filter(|axis| from & axis == 0) {
            over.line(corner(from), corner(from | axis), 1.2, EDGES);
        }
    }
    // Of a slice its thickness alone.
    let axes = match (of, session.render_settings.cutting.slice) {
        (Of::Slice, Some(slice)) => slice.axis..slice.axis + 1,
        _ => 0..3,
    };
    // At the corner that is nearest to the eye, each length has an edge of its own.
    let eye = session.navigator.camera().eye;
    let near = (0..8usize).min_by(|&a, &b| eye.distance(corner(a)).total_cmp(&eye.distance(corner(b)))).unwrap_or(0);
    for axis in axes {
        let middle = corner(near).midpoint(corner(near ^ 1 << axis));
        over.label(middle, &scale.text(Quantity::Length, f64::from(max[axis] - min[axis])), AXES[axis]);
    }
}

fn knob(over: &Over, handle: &Handle, is_near: bool) {
    let Some(place) = over.place(handle.place) else { return };
    let color = match handle.grip {
        Grip::Side { axis, .. } => AXES[axis],
        Grip::Middle => MIDDLE,
    };
    let radius = if is_near { RADIUS + 2.5 } else { RADIUS };
    over.painter.circle(place, radius, color, Stroke::new(if is_near { 2.5 } else { 1.5 }, Color32::BLACK));
}
