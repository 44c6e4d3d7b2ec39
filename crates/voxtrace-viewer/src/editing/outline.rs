//! What a tool would touch, as lines in the world that are drawn over the picture.

use super::{Act, Pasting, Selection, Spot, Stroke, Symmetry, Tool, brush};
use crate::session::Session;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Shape, Transform};

/// Sides of a circle.
const SIDES: usize = 48;

/// Voxels between lines on the floor of a box to build in.
const BETWEEN_LINES: usize = 8;

/// Most voxels of a copy that are drawn one by one.
const MOST_SHOWN: usize = 200;

/// What a line tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// What is added or painted.
    Own,
    /// What is taken away.
    Erased,
    /// The same on the other sides of the planes of symmetry.
    Mirrored,
    /// The plane across an axis.
    Plane(usize),
    /// What is selected.
    Selected,
    /// The face under the cursor.
    Face,
    /// The box to build in.
    Canvas,
    /// Lines on its floor.
    Floor,
}

/// A line from point to point, world space.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Its points.
    pub points: Vec<Vec3>,
    /// What it tells.
    pub look: Look,
}

/// Lines of a grid, brought to the world.
struct Lines<'a> {
    world_from_grid: &'a Transform,
    all: Vec<Outline>,
}

impl Lines<'_> {
    fn add(&mut self, points: impl IntoIterator<Item = Vec3>, look: Look) {
        let points = points.into_iter().map(|point| self.world_from_grid.point(point)).collect();
        self.all.push(Outline { points, look });
    }

    fn region(&mut self, region: VoxelBox, look: Look) {
        let (low, high) = (region.min.as_vec3(), region.max.as_vec3());
        let corner = |index: usize| {
            // Around a square, and back to its first corner.
            let (x, y) = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)][index % 5];
            Vec3::new([low.x, high.x][x], [low.y, high.y][y], [low.z, high.z][index / 5])
        };
        self.add((0..5).map(corner), look);
        self.add((5..10).map(corner), look);
        (0..4).for_each(|index| self.add([corner(index), corner(index + 5)], look));
    }

    /// Lines on the floor of a box, between bricks.
    fn floor(&mut self, region: VoxelBox) {
        let (low, high) = (region.min, region.max);
        for axis in 0..2 {
            for at in (low[axis]..high[axis]).step_by(BETWEEN_LINES).skip(1) {
                let (mut from, mut to) = (low, IVec3::new(high.x, high.y, low.z));
                (from[axis], to[axis]) = (at, at);
                self.add([from.as_vec3(), to.as_vec3()], Look::Floor);
            }
        }
    }

    fn ball(&mut self, center: DVec3, radius: f64, look: Look) {
        for axis in 0..3 {
            let circle = (0..=SIDES).map(|side| {
                let (sin, cos) = (side as f64 / SIDES as f64 * std::f64::consts::TAU).sin_cos();
                let mut at = center;
                at[(axis + 1) % 3] += radius * cos;
                at[(axis + 2) % 3] += radius * sin;
                at.as_vec3()
            });
            self.add(circle, look);
        }
    }

    fn shape(&mut self, shape: &Shape, look: Look) {
        match *shape {
            Shape::Box(region) => self.region(region, look),
            Shape::Sphere { center, radius } => self.ball(center, radius, look),
            Shape::Capsule { from, to, radius } => {
                self.ball(from, radius, look);
                self.ball(to, radius, look);
                let (one, other) = (to - from).normalize_or(DVec3::Z).any_orthonormal_pair();
                for side in [one, -one, other, -other] {
                    self.add([from, to].map(|end| (end + side * radius).as_vec3()), look);
                }
            }
            _ => {}
        }
    }

    /// The square of a voxel's face.
    fn face(&mut self, voxel: IVec3, face: voxtrace::Face) {
        let normal = face.normal();
        let mut region = VoxelBox { min: voxel, max: voxel + 1 };
        let axis = face.axis();
        region.min[axis] += normal[axis].max(0);
        region.max[axis] = region.min[axis];
        let (low, high) = (region.min.as_vec3(), region.max.as_vec3());
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let corner = |(a, b): (bool, bool)| {
            let mut at = low;
            at[u] = if a { high[u] } else { low[u] };
            at[v] = if b { high[v] } else { low[v] };
            at
        };
        self.add([(false, false), (true, false), (true, true), (false, true), (false, false)].map(corner), Look::Face);
    }
}

/// All lines over the picture.
pub fn outlines(session: &Session) -> Vec<Outline> {
    let Some(editing) = session.editing.as_ref().filter(|editing| editing.is_on) else { return Vec::new() };
    let mut all = Vec::new();
    if let Some(canvas) = session.open.as_ref().and_then(|open| open.canvas) {
        let mut lines = Lines { world_from_grid: &Transform::IDENTITY, all: Vec::new() };
        lines.region(canvas, Look::Canvas);
        lines.floor(canvas);
        all.append(&mut lines.all);
    }
    if let Some(Selection { world_from_grid, region, .. }) = &editing.selection {
        let mut lines = Lines { world_from_grid, all: Vec::new() };
        lines.region(*region, Look::Selected);
        all.append(&mut lines.all);
    }
    let hovered = session.hover.filter(|_| !session.is_moving()).and_then(|cursor| session.edit_spot(cursor));
    let stroke = editing.stroke();
    let spot = stroke.and_then(Stroke::spot).copied().or(hovered);
    let Some(spot) = spot else {
        let Some(last) = &editing.last_spot else { return all };
        let mut lines = Lines { world_from_grid: &last.world_from_grid, all };
        planes(session, last, &mut lines);
        return lines.all;
    };
    let mut lines = Lines { world_from_grid: &spot.world_from_grid, all };
    planes(session, &spot, &mut lines);
    match stroke {
        Some(Stroke::Brush { .. } | Stroke::Nothing) => {}
        Some(stroke) => of_stroke(session, stroke, &mut lines),
        None => of_spot(session, &spot, &mut lines),
    }
    lines.all
}

fn planes(session: &Session, spot: &Spot, lines: &mut Lines) {
    let Some(editing) = &session.editing else { return };
    let symmetry = session.symmetry_at(spot);
    let Some(bounds) = session.grid_bounds(spot.grid).filter(|_| !symmetry.is_none() && editing.is_ready) else {
        return;
    };
    for axis in (0..3).filter(|&axis| symmetry.axes[axis]) {
        let at = symmetry.twice[axis] as f32 / 2.0;
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let corner = |a: i32, b: i32| {
            let mut corner = Vec3::ZERO;
            corner[axis] = at;
            corner[u] = a as f32;
            corner[v] = b as f32;
            corner
        };
        let (low, high) = (bounds.min - 1, bounds.max + 1);
        let around = [(low[u], low[v]), (high[u], low[v]), (high[u], high[v]), (low[u], high[v]), (low[u], low[v])];
        lines.add(around.map(|(a, b)| corner(a, b)), Look::Plane(axis));
        let (u_middle, v_middle) = ((low[u] + high[u]) / 2, (low[v] + high[v]) / 2);
        lines.add([corner(u_middle, low[v]), corner(u_middle, high[v])], Look::Plane(axis));
        lines.add([corner(low[u], v_middle), corner(high[u], v_middle)], Look::Plane(axis));
    }
}

fn of_stroke(session: &Session, stroke: &Stroke, lines: &mut Lines) {
    let (Some(editing), Some(spot)) = (&session.editing, stroke.spot()) else { return };
    let symmetry = session.symmetry_at(spot);
    match stroke {
        Stroke::Span { tool: Tool::Line, act, from, to, .. } => {
            let shapes = match editing.brush.size {
                1 => brush::runs(&brush::line(*from, *to)).into_iter().map(Shape::Box).collect(),
                _ if from == to => vec![editing.brush.shape(*from)],
                _ => editing.brush.shapes_to(*from, *to),
            };
            symmetric(&symmetry, &shapes, *act, lines);
        }
        Stroke::Span { tool: Tool::Select, .. } => {
            stroke.region().into_iter().for_each(|region| lines.region(region, Look::Selected));
        }
        Stroke::Span { act, .. } => {
            let shapes: Vec<Shape> = stroke.region().into_iter().map(Shape::Box).collect();
            symmetric(&symmetry, &shapes, *act, lines);
        }
        Stroke::Extrude { region, distance, .. } => {
            let by = (region.face.normal() * *distance).as_vec3();
            let look = if *distance < 0 { Look::Erased } else { Look::Own };
            for [from, to] in &region.outline {
                lines.add([*from, *to], Look::Face);
                lines.add([*from, *from + by, *to + by, *to], look);
            }
        }
        Stroke::Brush { .. } | Stroke::Nothing => {}
    }
}

/// What a click would begin with.
fn of_spot(session: &Session, spot: &Spot, lines: &mut Lines) {
    let Some(editing) = &session.editing else { return };
    if let Some(Pasting { clip, .. }) = &editing.pasting {
        let min = spot.paste_corner(clip.size());
        lines.region(VoxelBox { min, max: min + clip.size() }, Look::Own);
        if clip.voxels().voxels().nth(MOST_SHOWN).is_none() {
            let voxels = clip.voxels().voxels().map(|(voxel, _)| min + voxel);
            voxels.for_each(|voxel| lines.region(VoxelBox { min: voxel, max: voxel + 1 }, Look::Mirrored));
        }
        return;
    }
    lines.face(spot.voxel, spot.face);
    if editing.picks_middle || !editing.is_ready {
        return;
    }
    let act = session.act_now();
    match editing.tool {
        Tool::Brush | Tool::Line => {
            let shape = editing.brush.shape(act.cell(spot.voxel, spot.face));
            symmetric(&session.symmetry_at(spot), &[shape], act, lines);
        }
        Tool::Box => {
            let cell = act.cell(spot.voxel, spot.face);
            let shape = Shape::Box(VoxelBox { min: cell, max: cell + 1 });
            symmetric(&session.symmetry_at(spot), &[shape], act, lines);
        }
        Tool::Select => lines.region(VoxelBox { min: spot.voxel, max: spot.voxel + 1 }, Look::Selected),
        Tool::Extrude | Tool::Fill | Tool::Replace => {}
    }
}

fn symmetric(symmetry: &Symmetry, shapes: &[Shape], act: Act, lines: &mut Lines) {
    let own = if act == Act::Erase { Look::Erased } else { Look::Own };
    for image in symmetry.images() {
        let look = if image.is_itself() { own } else { Look::Mirrored };
        shapes.iter().for_each(|shape| lines.shape(&image.shape(shape), look));
    }
}
