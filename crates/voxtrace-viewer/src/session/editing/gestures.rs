//! Strokes: from pressing the button to letting it go.

use crate::editing::brush::{box_between, line};
use crate::editing::face_region::{FaceRegion, MOST};
use crate::editing::{Act, Job, MOST_FILLED, Selection, Spot, Stroke, Symmetry, Tool};
use crate::keys::EditAction;
use crate::session::Session;
use crate::tr;
use std::sync::Arc;
use voxtrace::Shape;
use voxtrace::dynamic::Edit;
use voxtrace::glam::{DVec3, IVec3, Vec2};
use voxtrace::grid::VoxelBox;

/// Most places of the cursor that are looked at between two events.
const MOST_SAMPLES: f32 = 96.0;
/// Pixels between them.
const BETWEEN: f32 = 2.0;

impl Session {
    /// A button that uses the tool is pressed. Returns whether it does; else it moves the camera.
    pub(crate) fn edit_press(&mut self, cursor: Vec2, is_erasing: bool) -> bool {
        let Some(spot) = self.edit_spot(cursor) else { return false };
        let Some(editing) = self.editing.as_mut().filter(|editing| editing.is_on) else { return false };
        if !editing.is_ready {
            self.say(tr!("edit.one_moment"), false);
            return true;
        }
        (editing.stroke, editing.last_spot) = (Some(Stroke::Nothing), Some(spot));
        if std::mem::take(&mut editing.picks_middle) {
            editing.symmetry.twice = Symmetry::middle_of_voxel(spot.voxel);
            editing.symmetry_of = Some(spot.grid);
            return true;
        }
        if editing.pasting.is_some() {
            self.put_down(&spot);
            return true;
        }
        let act = if is_erasing { Act::Erase } else { editing.act };
        if matches!(editing.tool, Tool::Brush | Tool::Line | Tool::Box | Tool::Fill | Tool::Replace)
            && act != Act::Erase
        {
            let material = editing.material;
            editing.take_material(material);
        }
        match editing.tool {
            Tool::Brush => self.begin_brush(spot, act, cursor),
            Tool::Line | Tool::Box => {
                let cell = act.cell(spot.voxel, spot.face);
                editing.stroke = Some(Stroke::Span { tool: editing.tool, act, spot, from: cell, to: cell, depth: 0 });
            }
            Tool::Select => {
                let (from, to) = (spot.voxel, spot.voxel);
                editing.stroke = Some(Stroke::Span { tool: Tool::Select, act, spot, from, to, depth: 0 });
            }
            Tool::Extrude => self.begin_extrusion(spot),
            Tool::Fill => self.fill(&spot, act),
            Tool::Replace => self.replace(&spot, act),
        }
        true
    }

    /// A button is pressed that does something while the hand edits. Returns whether it does; else it moves the camera.
    pub(crate) fn edit_press_as(&mut self, action: EditAction, cursor: Vec2) -> bool {
        match action {
            EditAction::PickMaterial => {
                self.pick_material(Some(cursor));
                true
            }
            action => self.edit_press(cursor, action == EditAction::Erase),
        }
    }

    fn begin_brush(&mut self, spot: Spot, act: Act, cursor: Vec2) {
        let cell = act.cell(spot.voxel, spot.face);
        let Some(editing) = &mut self.editing else { return };
        editing.stroke = Some(Stroke::Brush { act, spot, last: cell, cursor });
        let shape = editing.brush.shape(cell);
        self.send_shapes(&spot, act, &[shape], act.name(), false);
    }

    fn begin_extrusion(&mut self, spot: Spot) {
        let Some(open) = &self.open else { return };
        match FaceRegion::around(&open.pickable, spot.grid, spot.voxel, spot.face) {
            Some(region) => {
                if let Some(editing) = &mut self.editing {
                    editing.stroke = Some(Stroke::Extrude { spot, region: Arc::new(region), distance: 0 });
                }
            }
            None => self.say(tr!("edit.large_face", most = MOST), false),
        }
    }

    /// The cursor moved with the button held.
    pub(crate) fn edit_drag(&mut self, cursor: Vec2) {
        let Some(stroke) = self.editing.as_ref().and_then(|editing| editing.stroke.clone()) else { return };
        match stroke {
            Stroke::Brush { .. } => self.drag_brush(stroke, cursor),
            Stroke::Span { tool, act, spot, from, depth, .. } => {
                let Some(to) = self.end_of_span(&spot, act, tool, from, cursor) else { return };
                self.set_stroke(Stroke::Span { tool, act, spot, from, to, depth });
            }
            Stroke::Extrude { spot, region, .. } => {
                let Some(distance) = self.distance_along(&spot, cursor) else { return };
                self.set_stroke(Stroke::Extrude { spot, region, distance });
            }
            Stroke::Nothing => {}
        }
    }

    fn set_stroke(&mut self, stroke: Stroke) {
        if let Some(editing) = &mut self.editing {
            editing.stroke = Some(stroke);
        }
    }

    /// A brush goes on along the way of the cursor, on the surface that there was when the stroke began.
    fn drag_brush(&mut self, stroke: Stroke, to: Vec2) {
        let Stroke::Brush { act, spot, mut last, cursor: from } = stroke else { return };
        let Some(editing) = &self.editing else { return };
        let brush = editing.brush;
        let samples = ((to - from).length() / BETWEEN).ceil().clamp(1.0, MOST_SAMPLES);
        // Balls overlap: with an eighth of their size between them nothing is to be seen of it.
        let least = if brush.is_round { (brush.size / 8).max(1) as i32 } else { 1 };
        let near = 2 * brush.size as i32 + 2;
        let mut shapes = Vec::new();
        for sample in 1..=samples as u32 {
            let cursor = from + (to - from) * (sample as f32 / samples);
            let Some(found) = self.edit_spot(cursor).filter(|found| found.is_with(&spot)) else { continue };
            let cell = act.cell(found.voxel, found.face);
            let step = (cell - last).abs().max_element();
            if step < least {
                continue;
            }
            // From one edge to another behind it nothing leads through the air.
            match step <= near {
                true => shapes.extend(brush.shapes_to(last, cell)),
                false => shapes.push(brush.shape(cell)),
            }
            last = cell;
        }
        self.set_stroke(Stroke::Brush { act, spot, last, cursor: to });
        if !shapes.is_empty() {
            self.send_shapes(&spot, act, &shapes, act.name(), true);
        }
    }

    /// The other end of a line or a box: the voxel under the cursor, or the place in the plane of the first face.
    fn end_of_span(&self, spot: &Spot, act: Act, tool: Tool, from: IVec3, cursor: Vec2) -> Option<IVec3> {
        let under = self.edit_spot(cursor).filter(|found| found.is_with(spot));
        if let Some(found) = under {
            return Some(if tool == Tool::Select { found.voxel } else { act.cell(found.voxel, found.face) });
        }
        let (origin, direction) = self.ray_in_grid(spot, cursor);
        let axis = spot.face.axis();
        let plane = f64::from(from[axis]) + 0.5;
        let t = (plane - origin[axis]) / direction[axis];
        let at = (origin + direction * t).floor();
        let far = 4.0 * f64::from(self.navigator.diagonal()).max(64.0);
        let is_near = t > 0.0 && at.is_finite() && (at - from.as_dvec3()).abs().max_element() < far;
        let mut to = is_near.then(|| at.as_ivec3())?;
        to[axis] = from[axis];
        Some(to)
    }

    /// The ray under the cursor, in voxels of the grid at a spot.
    fn ray_in_grid(&self, spot: &Spot, cursor: Vec2) -> (DVec3, DVec3) {
        let grid_from_world = spot.world_from_grid.inverse();
        let ray = self.navigator.ray(cursor);
        let direction = grid_from_world.direction(ray.direction).as_dvec3();
        (grid_from_world.point(ray.origin).as_dvec3(), direction.normalize_or_zero())
    }

    /// How far along the normal of a face the cursor was drawn, voxels: where the line along the normal is nearest to the ray.
    fn distance_along(&self, spot: &Spot, cursor: Vec2) -> Option<i32> {
        let (origin, direction) = self.ray_in_grid(spot, cursor);
        let normal = spot.face.normal().as_dvec3();
        let between = origin - spot.point;
        let along = normal.dot(direction);
        let squared = 1.0 - along * along;
        let distance = (normal.dot(between) - along * direction.dot(between)) / squared;
        let most = 4.0 * f64::from(self.navigator.diagonal()).max(64.0);
        (squared > 1e-6 && distance.is_finite()).then(|| distance.clamp(-most, most).round() as i32)
    }

    /// The wheel turned while a button uses a tool: a box gets deeper. Returns whether it did something.
    pub(crate) fn edit_wheel(&mut self, notches: f32) -> bool {
        let Some(editing) = &mut self.editing else { return false };
        match &mut editing.stroke {
            Some(Stroke::Span { tool: Tool::Box | Tool::Select, depth, .. }) => {
                *depth += notches.signum() as i32;
                true
            }
            stroke => stroke.is_some(),
        }
    }

    /// The wheel changes the size of the brush.
    pub(crate) fn resize_brush(&mut self, notches: f32) {
        if let Some(editing) = &mut self.editing {
            editing.brush = editing.brush.stepped(notches.signum() as i32);
        }
    }

    /// The button is let go.
    pub(crate) fn edit_release(&mut self) {
        let Some(stroke) = self.editing.as_mut().and_then(|editing| editing.stroke.take()) else { return };
        match &stroke {
            Stroke::Span { tool: Tool::Select, spot, .. } => {
                let Spot { instance, grid, world_from_grid, .. } = *spot;
                let selection = stroke.region().map(|region| Selection { instance, grid, world_from_grid, region });
                if let Some(editing) = &mut self.editing {
                    editing.selection = selection;
                }
            }
            Stroke::Span { tool: Tool::Line, act, spot, from, to, .. } => {
                let shapes = self.editing.as_ref().map_or(Vec::new(), |editing| editing.brush.line(*from, *to));
                self.send_shapes(spot, *act, &shapes, tr!("edit.line"), false);
            }
            Stroke::Span { act, spot, .. } => {
                let shapes: Vec<Shape> = stroke.region().into_iter().map(Shape::Box).collect();
                self.send_shapes(spot, *act, &shapes, tr!("edit.box"), false);
            }
            Stroke::Extrude { spot, region, distance } if *distance != 0 => {
                let edits = self.symmetry_at(spot).edits(&region.edits(*distance));
                let name = if *distance > 0 { tr!("edit.pull") } else { tr!("edit.push") };
                self.send_job(Job::Edit { grid: spot.grid, edits, name, joins: false });
            }
            Stroke::Brush { .. } | Stroke::Extrude { .. } | Stroke::Nothing => {}
        }
        self.end_stroke();
    }

    /// The stroke ends where it is: what is picked in follows.
    pub(crate) fn end_stroke(&mut self) {
        if let Some(editing) = &mut self.editing {
            (editing.stroke, editing.before) = (None, None);
        }
        self.settle_edits();
        self.stay_on_top_of_surroundings();
    }

    /// The stroke is given up: nothing comes of a line or a box.
    pub(crate) fn drop_stroke(&mut self) {
        self.end_stroke();
    }

    fn send_shapes(&mut self, spot: &Spot, act: Act, shapes: &[Shape], name: &'static str, joins: bool) {
        let Some(editing) = &self.editing else { return };
        let edits: Vec<Edit> = shapes.iter().map(|&shape| act.edit(shape, editing.material)).collect();
        let edits = self.symmetry_at(spot).edits(&edits);
        self.send_job(Job::Edit { grid: spot.grid, edits, name, joins });
    }

    /// Where a fill may go: what is selected of the grid, else all of it.
    fn fillable(&self, spot: &Spot) -> Option<VoxelBox> {
        let selection = self.editing.as_ref()?.selection.filter(|selection| selection.grid == spot.grid);
        selection.map(|selection| selection.region).or_else(|| self.grid_bounds(spot.grid))
    }

    fn fill(&mut self, spot: &Spot, act: Act) {
        let (Some(editing), Some(within)) = (&self.editing, self.fillable(spot)) else { return };
        let material = (act != Act::Erase).then_some(editing.material);
        if material == Some(spot.material) {
            return self.say(tr!("edit.same_material"), false);
        }
        // A box that was selected before, and may be out of sight, is why nothing would come of it.
        if editing.selection.is_some_and(|own| own.grid == spot.grid) && !within.contains(spot.voxel) {
            return self.say(tr!("edit.beside_selection"), false);
        }
        let edit = Edit::Flood { start: spot.voxel, material, within, most: MOST_FILLED };
        let edits = self.symmetry_at(spot).edits(&[edit]);
        self.send_job(Job::Edit { grid: spot.grid, edits, name: tr!("edit.fill"), joins: false });
    }

    fn replace(&mut self, spot: &Spot, act: Act) {
        let Some(editing) = &self.editing else { return };
        let to = (act != Act::Erase).then_some(editing.material);
        if to == Some(spot.material) {
            return self.say(tr!("edit.same_material"), false);
        }
        let within = editing.selection.filter(|selection| selection.grid == spot.grid);
        let within = within.map(|selection| selection.region);
        let edits = vec![Edit::Replace { within, from: spot.material, to }];
        self.send_job(Job::Edit { grid: spot.grid, edits, name: tr!("edit.replace"), joins: false });
    }
}

/// How long a line is, and how large a box, for people.
pub fn extent(stroke: &Stroke) -> Option<String> {
    match stroke {
        Stroke::Span { tool: Tool::Line, from, to, .. } => {
            Some(tr!("edit.extent_of_line", count = line(*from, *to).len()))
        }
        Stroke::Span { .. } => {
            let size = stroke.region().unwrap_or(box_between(IVec3::ZERO, IVec3::ZERO)).size();
            Some(format!("{} × {} × {}", size.x, size.y, size.z))
        }
        Stroke::Extrude { region, distance, .. } => {
            Some(tr!("edit.extent", count = region.count(), distance = format!("{distance:+}")))
        }
        Stroke::Brush { .. } | Stroke::Nothing => None,
    }
}
