//! Which parts of a line over the picture lie behind the scene. Rays are cast for a few places along it, at most so many a frame, and what they
//! found is kept until camera or scene are others.

use crate::projection::Projection;
use std::collections::HashMap;
use std::sync::Arc;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::{PackedScene, Ray};

/// Pixels between two places that are looked at.
const STEP: f32 = 7.0;
/// Most places of a line.
const MOST_PLACES: usize = 96;
/// Most rays of a frame: some milliseconds.
const MOST_RAYS: usize = 2500;
/// Most lines that are remembered.
const MOST_LINES: usize = 4096;
/// Lines on a surface are seen although it is as near as they are: voxels, and a share of the distance.
const BEFORE: (f32, f32) = (0.12, 2e-4);

/// A part of a line in the picture, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where it begins.
    pub from: Vec2,
    /// Where it ends.
    pub to: Vec2,
    /// Whether the scene lies before it.
    pub is_behind: bool,
}

/// What is known of lines in one view of one scene.
#[derive(Default)]
pub struct Sight {
    view: Option<(Projection, Arc<PackedScene>)>,
    lines: HashMap<[u32; 6], Arc<[Piece]>>,
    rays_left: usize,
    /// Whether some line was not looked at for want of rays.
    pub is_waiting: bool,
}

impl Sight {
    /// A frame begins, in this view.
    pub fn begin(&mut self, projection: &Projection, scene: &Arc<PackedScene>) {
        let is_same = self.view.as_ref().is_some_and(|(own, of)| own == projection && Arc::ptr_eq(of, scene));
        if !is_same || self.lines.len() > MOST_LINES {
            self.lines.clear();
        }
        if !is_same {
            self.view = Some((projection.clone(), Arc::clone(scene)));
        }
        (self.rays_left, self.is_waiting) = (MOST_RAYS, false);
    }

    /// Lets go of the scene.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// The line between two points of the world in the picture, in parts that are seen or lie behind something.
    pub fn pieces(&mut self, from: Vec3, to: Vec3) -> Arc<[Piece]> {
        let key = [from.x, from.y, from.z, to.x, to.y, to.z].map(f32::to_bits);
        if let Some(known) = self.lines.get(&key) {
            return Arc::clone(known);
        }
        let Some((projection, scene)) = self.view.clone() else { return Arc::default() };
        let Some((from, to)) = projection.before_camera(from, to) else { return Arc::default() };
        let length = match (projection.place(from), projection.place(to)) {
            (Some(from), Some(to)) => from.distance(to),
            _ => 0.0,
        };
        let steps = ((length / STEP).ceil() as usize).clamp(1, MOST_PLACES);
        let has_rays = steps <= self.rays_left;
        self.is_waiting |= !has_rays;
        let at = |index: usize| from.lerp(to, index as f32 / steps as f32);
        let piece = |index: usize| {
            let (a, b) = (projection.place(at(index))?, projection.place(at(index + 1))?);
            let middle = at(index).midpoint(at(index + 1));
            let is_behind = has_rays && is_hidden(&scene, &projection, middle);
            projection.is_joined(a, b).then_some(Piece { from: a, to: b, is_behind })
        };
        let pieces: Arc<[Piece]> = joined((0..steps).filter_map(piece)).into();
        if has_rays {
            self.rays_left -= steps;
            self.lines.insert(key, Arc::clone(&pieces));
        }
        pieces
    }

    /// Whether the scene lies before a point.
    pub fn is_behind(&self, point: Vec3) -> bool {
        self.view.as_ref().is_some_and(|(projection, scene)| is_hidden(scene, projection, point))
    }
}

/// Neighbours that are alike and go on straight are one.
fn joined(pieces: impl Iterator<Item = Piece>) -> Vec<Piece> {
    let mut all: Vec<Piece> = Vec::new();
    for piece in pieces {
        match all.last_mut() {
            Some(last) if last.is_behind == piece.is_behind && last.to == piece.from => {
                let (whole, part) = (piece.to - last.from, last.to - last.from);
                if whole.perp_dot(part).abs() <= 0.25 * whole.length() {
                    last.to = piece.to;
                    continue;
                }
                all.push(piece);
            }
            _ => all.push(piece),
        }
    }
    all
}

fn is_hidden(scene: &PackedScene, projection: &Projection, point: Vec3) -> bool {
    let eye = projection.seen_from(point);
    let distance = eye.distance(point);
    let until = distance - BEFORE.0 - BEFORE.1 * distance;
    let Some(direction) = (point - eye).try_normalize().filter(|_| until > 0.0) else { return false };
    scene.cast(&Ray { t_max: until, ..Ray::new(eye, direction) }).is_some()
}
