//! Lines, points and labels over the picture, at places of the scene: what lies behind it is drawn dimmer.

use crate::projection::Projection;
use crate::session::Session;
use crate::sight::Sight;
use egui::{Align2, Color32, FontId, LayerId, Order, Painter, Pos2, Rect, Stroke, Ui, Vec2 as Points};
use voxtrace::glam::{Vec2, Vec3};

/// How much of a colour is left of what lies behind the scene.
const DIM: f32 = 0.35;
/// A dark line below a bright one is seen on any picture.
const SHADOW: Color32 = Color32::from_black_alpha(150);

/// What draws over the picture.
pub struct Over<'a> {
    pub painter: Painter,
    pub projection: Projection,
    sight: &'a mut Sight,
    /// Pixels of the picture in a point of the panels.
    scale: f32,
}

/// Draws over the picture, beside the panel of `side` points. Nothing where there is no scene.
pub fn over<T>(ui: &Ui, session: &mut Session, side: f32, draw: impl FnOnce(&Session, &mut Over) -> T) -> Option<T> {
    let scene = std::sync::Arc::clone(&session.open.as_ref()?.pickable);
    let projection = session.projection();
    // It is put back below: what draws reads the session.
    let mut sight = std::mem::take(&mut session.sight);
    sight.begin(&projection, &scene);
    let picture = super::picture(ui, session, side);
    let painter = ui.ctx().layer_painter(LayerId::new(Order::Background, "over".into())).with_clip_rect(picture);
    let mut over = Over { painter, projection, sight: &mut sight, scale: ui.ctx().pixels_per_point() };
    let drawn = draw(session, &mut over);
    if sight.is_waiting {
        ui.ctx().request_repaint();
    }
    session.sight = sight;
    Some(drawn)
}

impl Over<'_> {
    /// A place of the picture in points of the window.
    pub fn point(&self, place: Vec2) -> Pos2 {
        self.painter.ctx().content_rect().min + Points::new(place.x, place.y) / self.scale
    }

    /// Where a point of the world is drawn.
    pub fn place(&self, point: Vec3) -> Option<Pos2> {
        Some(self.point(self.projection.place(point)?))
    }

    /// A line between two points of the world.
    pub fn line(&mut self, from: Vec3, to: Vec3, width: f32, color: Color32) {
        for piece in self.sight.pieces(from, to).iter() {
            let ends = [self.point(piece.from), self.point(piece.to)];
            if piece.is_behind {
                self.painter.line_segment(ends, Stroke::new(width * 0.75, color.gamma_multiply(DIM)));
            } else {
                self.painter.line_segment(ends, Stroke::new(width + 2.0, SHADOW));
                self.painter.line_segment(ends, Stroke::new(width, color));
            }
        }
    }

    /// A dot at a point of the world.
    pub fn dot(&self, at: Vec3, radius: f32, color: Color32) {
        let Some(place) = self.place(at) else { return };
        let color = if self.sight.is_behind(at) { color.gamma_multiply(DIM) } else { color };
        self.painter.circle(place, radius, color, Stroke::new(1.0, SHADOW));
    }

    /// A text beside a point of the world.
    pub fn label(&self, at: Vec3, text: &str, color: Color32) -> Option<Rect> {
        let place = self.place(at)?;
        if !self.painter.clip_rect().contains(place) {
            return None;
        }
        let galley = self.painter.layout_no_wrap(text.to_owned(), FontId::proportional(13.0), color);
        let rect = Align2::CENTER_BOTTOM.anchor_size(place - Points::new(0.0, 8.0), galley.size());
        self.painter.rect_filled(rect.expand2(Points::new(5.0, 2.0)), 3.0, Color32::from_black_alpha(190));
        self.painter.galley(rect.min, galley, color);
        Some(rect)
    }
}
