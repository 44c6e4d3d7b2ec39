//! Handles of the clip box and of the slice in the picture: sides are dragged along their axis, the middle moves all of it. They snap to whole
//! voxels, unless Shift is held.

use crate::cutting::{Cutting, LEAST, Slice};
use crate::session::Session;
use crate::tr;
use voxtrace::Ray;
use voxtrace::glam::{Vec2, Vec3};

/// Pixels within which a handle is taken.
const REACH: f32 = 12.0;

/// What a handle belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The clip box.
    Box,
    /// The slice.
    Slice,
}

/// What a handle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// The side across an axis.
    Side {
        /// 0 is x, 1 is y, 2 is z.
        axis: usize,
        /// Whether it is the upper one.
        is_upper: bool,
    },
    /// All of it.
    Middle,
}

/// A handle in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// Whose.
    pub of: Of,
    /// What it moves.
    pub grip: Grip,
    /// Where it is, world space.
    pub place: Vec3,
}

/// A handle that is dragged.
#[derive(Clone, Debug)]
pub struct Grabbed {
    /// Which.
    pub handle: Handle,
    /// The cuts when it was taken.
    before: Cutting,
    /// Where it was taken, world space.
    from: Vec3,
}

/// Handles, and whether they are shown.
#[derive(Clone, Debug)]
pub struct Clipping {
    /// Whether they are shown.
    pub has_handles: bool,
    /// The one that is dragged.
    pub held: Option<Handle>,
}

impl Default for Clipping {
    fn default() -> Self {
        Self { has_handles: true, held: None }
    }
}

/// The box of a slice in a scene of these bounds.
fn box_of(slice: &Slice, [mut min, mut max]: [Vec3; 2]) -> [Vec3; 2] {
    (min[slice.axis], max[slice.axis]) = (slice.from, slice.from + slice.thickness);
    [min, max]
}

fn handles_of(of: Of, [min, max]: [Vec3; 2], axes: &[usize]) -> Vec<Handle> {
    let middle = min.midpoint(max);
    let side = |axis: usize, is_upper: bool| {
        let mut place = middle;
        place[axis] = if is_upper { max[axis] } else { min[axis] };
        Handle { of, grip: Grip::Side { axis, is_upper }, place }
    };
    let sides = axes.iter().flat_map(|&axis| [side(axis, false), side(axis, true)]);
    sides.chain([Handle { of, grip: Grip::Middle, place: middle }]).collect()
}

/// How far along a unit vector from a point the line is nearest to a ray; `None` where both go the same way.
fn along(point: Vec3, direction: Vec3, ray: &Ray) -> Option<f32> {
    let (point, direction) = (point.as_dvec3(), direction.as_dvec3());
    let (origin, towards) = (ray.origin.as_dvec3(), ray.direction.as_dvec3().normalize());
    let (offset, cosine) = (point - origin, direction.dot(towards));
    let across = 1.0 - cosine * cosine;
    (across > 1e-6).then(|| ((cosine * towards.dot(offset) - direction.dot(offset)) / across) as f32)
}

impl Session {
    /// The boxes that have handles.
    pub fn clip_boxes(&self) -> Vec<(Of, [Vec3; 2])> {
        let Some(whole) = self.whole_box().filter(|_| self.clipping.has_handles) else { return Vec::new() };
        let cutting = &self.render_settings.cutting;
        let of_slice = cutting.slice.as_ref().map(|slice| (Of::Slice, box_of(slice, whole)));
        cutting.clip_box.map(|own| (Of::Box, own)).into_iter().chain(of_slice).collect()
    }

    /// All handles.
    pub fn handles(&self) -> Vec<Handle> {
        let axis = self.render_settings.cutting.slice.map_or(0, |slice| slice.axis);
        let of = |(of, corners): (Of, [Vec3; 2])| match of {
            Of::Box => handles_of(of, corners, &[0, 1, 2]),
            Of::Slice => handles_of(of, corners, &[axis]),
        };
        self.clip_boxes().into_iter().flat_map(of).collect()
    }

    /// The handle under a cursor.
    pub fn handle_at(&self, cursor: Vec2) -> Option<Handle> {
        let projection = self.projection();
        let places = self.handles().into_iter().filter_map(|handle| {
            let distance = projection.place(handle.place)?.distance(cursor);
            (distance <= REACH).then_some((handle, distance))
        });
        places.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(handle, _)| handle)
    }

    /// Takes the handle under a cursor.
    pub(crate) fn grab(&mut self, cursor: Vec2) -> Option<Grabbed> {
        let handle = self.handle_at(cursor)?;
        let from = self.pulled(&handle, handle.place, cursor)?;
        self.clipping.held = Some(handle);
        Some(Grabbed { handle, before: self.render_settings.cutting.clone(), from })
    }

    /// Lets go.
    pub(crate) fn let_go(&mut self) {
        self.clipping.held = None;
    }

    /// Where a cursor pulls a handle that was at `place`.
    fn pulled(&self, handle: &Handle, place: Vec3, cursor: Vec2) -> Option<Vec3> {
        let ray = self.navigator.ray(cursor);
        let axis = match (handle.grip, handle.of, self.render_settings.cutting.slice) {
            (Grip::Side { axis, .. }, ..) => Some(axis),
            (Grip::Middle, Of::Slice, Some(slice)) => Some(slice.axis),
            _ => None,
        };
        if let Some(axis) = axis {
            let unit = Vec3::AXES[axis];
            return along(place, unit, &ray).map(|length| place + unit * length);
        }
        // In the plane of the picture.
        let forward = self.navigator.camera().axes().forward;
        let t = (place - ray.origin).dot(forward) / ray.direction.dot(forward);
        (t.is_finite() && t > 0.0).then(|| ray.at(t))
    }

    /// Drags a handle to a cursor, to whole voxels unless it `is_free`.
    pub(crate) fn drag_handle(&mut self, grabbed: &Grabbed, cursor: Vec2, is_free: bool) {
        let Some(whole) = self.whole_box() else { return };
        let Some(to) = self.pulled(&grabbed.handle, grabbed.handle.place, cursor) else { return };
        let delta = to - grabbed.from;
        let mut cutting = grabbed.before.clone();
        let whole_voxels = |value: f32| if is_free { value } else { value.round() };
        match (grabbed.handle.of, &mut cutting.clip_box, &mut cutting.slice) {
            (Of::Box, Some(corners), _) => *corners = moved(*corners, grabbed.handle.grip, delta, whole, whole_voxels),
            (Of::Slice, _, Some(slice)) => {
                let [min, max] = moved(box_of(slice, whole), grabbed.handle.grip, delta, whole, whole_voxels);
                (slice.from, slice.thickness) = (min[slice.axis], max[slice.axis] - min[slice.axis]);
            }
            _ => return,
        }
        if cutting != self.render_settings.cutting {
            self.set_cutting(cutting);
        }
    }

    /// Cuts the scene open by a box with handles, or closes it.
    pub fn toggle_clip_box(&mut self) {
        let Some(whole) = self.whole_box() else { return };
        let mut cutting = self.render_settings.cutting.clone();
        cutting.clip_box = match cutting.clip_box {
            Some(_) => None,
            None => Some(whole),
        };
        self.clipping.has_handles = true;
        if cutting.clip_box.is_some() {
            self.say(tr!("clip.hint"), false);
        }
        self.set_cutting(cutting);
    }

    /// Makes the box that of the whole scene.
    pub fn reset_clip_box(&mut self) {
        let cutting = Cutting { clip_box: self.whole_box(), ..self.render_settings.cutting.clone() };
        self.set_cutting(cutting);
    }
}

/// A box one of whose sides, or all of it, was moved, within the whole scene.
fn moved(
    [mut min, mut max]: [Vec3; 2],
    grip: Grip,
    delta: Vec3,
    [low, high]: [Vec3; 2],
    whole: impl Fn(f32) -> f32,
) -> [Vec3; 2] {
    match grip {
        Grip::Side { axis, is_upper: false } => {
            min[axis] = whole(min[axis] + delta[axis]).clamp(low[axis], (high[axis] - LEAST).max(low[axis]));
            // Whichever side is moved pushes the other.
            max[axis] = max[axis].max(min[axis] + LEAST);
        }
        Grip::Side { axis, is_upper: true } => {
            max[axis] = whole(max[axis] + delta[axis]).clamp(low[axis] + LEAST, high[axis].max(low[axis] + LEAST));
            min[axis] = min[axis].min(max[axis] - LEAST);
        }
        Grip::Middle => {
            for axis in 0..3 {
                let most = (low[axis] - min[axis]).min(0.0)..=(high[axis] - max[axis]).max(0.0);
                let by = whole(delta[axis]).clamp(*most.start(), *most.end());
                (min[axis], max[axis]) = (min[axis] + by, max[axis] + by);
            }
        }
    }
    [min, max]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: [Vec3; 2] = [Vec3::ZERO, Vec3::new(20.0, 30.0, 40.0)];

    #[test]
    fn a_side_moves_along_its_axis_to_whole_voxels_and_pushes_the_other() {
        let whole = |value: f32| value.round();
        let upper = Grip::Side { axis: 0, is_upper: true };
        let delta = Vec3::new(-7.4, 5.0, 5.0);
        assert_eq!(moved(WHOLE, upper, delta, WHOLE, whole), [Vec3::ZERO, Vec3::new(13.0, 30.0, 40.0)]);
        assert_eq!(moved(WHOLE, upper, delta, WHOLE, |value| value)[1].x, 20.0 - 7.4, "freely");
        let small = [Vec3::splat(5.0), Vec3::splat(8.0)];
        let pushed = moved(small, upper, Vec3::X * -6.0, WHOLE, whole);
        assert_eq!((pushed[1].x, pushed[0].x), (2.0, 2.0 - LEAST));
        let lower = Grip::Side { axis: 2, is_upper: false };
        assert_eq!(moved(small, lower, Vec3::Z * -90.0, WHOLE, whole)[0], Vec3::new(5.0, 5.0, 0.0), "no further");
    }

    #[test]
    fn the_middle_moves_all_of_it_within_the_scene() {
        let small = [Vec3::splat(5.0), Vec3::splat(8.0)];
        let far = moved(small, Grip::Middle, Vec3::new(2.2, -90.0, 90.0), WHOLE, f32::round);
        assert_eq!(far, [Vec3::new(7.0, 0.0, 37.0), Vec3::new(10.0, 3.0, 40.0)]);
    }

    #[test]
    fn a_ray_that_passes_an_axis_pulls_to_where_both_are_nearest() {
        let ray = Ray::new(Vec3::new(7.0, -10.0, 3.0), Vec3::Y);
        assert!((along(Vec3::ZERO, Vec3::X, &ray).unwrap() - 7.0).abs() < 1e-6);
        assert_eq!(along(Vec3::ZERO, Vec3::Y, &ray), None, "the axis points at the eye");
    }
}
