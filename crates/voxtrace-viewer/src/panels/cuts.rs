//! The panel of cuts: a box, a slice, planes in any direction, and how what is left is lit. All of it is an option of `voxtrace render`, too.

use super::{section, slider};
use crate::cutting::{Cutting, LEAST, MOST_PLANES, Slice};
use crate::session::Session;
use crate::tr;
use egui::{RichText, Ui};
use std::ops::RangeInclusive;
use voxtrace::glam::Vec3;

const AXES: [&str; 3] = ["x", "y", "z"];

pub fn cuts(ui: &mut Ui, session: &mut Session) {
    let Some([min, max]) = session.whole_box() else { return };
    let old = session.render_settings.cutting.clone();
    let mut cutting = old.clone();
    // A further plane cuts away the half that is nearer.
    let towards_eye = along_axis(session.navigator.camera().eye - 0.5 * (min + max));
    section(ui, if old.is_cut() { tr!("cuts.title_cut") } else { tr!("cuts.title") }, "cuts", |ui| {
        let mut has_box = cutting.clip_box.is_some();
        if ui.checkbox(&mut has_box, tr!("cuts.box")).changed() {
            cutting.clip_box = has_box.then_some([min, max]);
        }
        if let Some([from, to]) = &mut cutting.clip_box {
            for (axis, name) in AXES.into_iter().enumerate() {
                let range = min[axis]..=max[axis];
                side(ui, &mut from[axis], &range, &tr!("cuts.from", name = name));
                // Whichever side is moved pushes the other.
                to[axis] = to[axis].max(from[axis] + LEAST);
                side(ui, &mut to[axis], &range, &tr!("cuts.to", name = name));
                from[axis] = from[axis].min(to[axis] - LEAST);
            }
        }
        if old.clip_box.is_some() && ui.button(tr!("clip.reset")).clicked() {
            cutting.clip_box = Some([min, max]);
        }
        let mut has_slice = cutting.slice.is_some();
        if ui.checkbox(&mut has_slice, tr!("cuts.slice")).changed() {
            let middle = (0.5 * (min.z + max.z)).floor();
            cutting.slice = has_slice.then_some(Slice { axis: 2, from: middle, thickness: 1.0 });
        }
        if let Some(slice) = &mut cutting.slice {
            ui.horizontal(|ui| {
                ui.label(tr!("cuts.across"));
                for (axis, name) in AXES.into_iter().enumerate() {
                    if ui.selectable_label(slice.axis == axis, name).clicked() && slice.axis != axis {
                        (slice.axis, slice.from) = (axis, (0.5 * (min[axis] + max[axis])).floor());
                    }
                }
            });
            let length = max[slice.axis] - min[slice.axis];
            side(ui, &mut slice.from, &(min[slice.axis]..=max[slice.axis]), tr!("cuts.slice_at"));
            ui.add(
                slider(&mut slice.thickness, LEAST..=length.max(1.0), tr!("cuts.thickness"))
                    .logarithmic(true)
                    .max_decimals(1),
            );
        }
        planes(ui, &mut cutting.planes, (min, max), towards_eye);
        let has_own = session.open.as_ref().is_some_and(|open| !open.original.cuts.is_none());
        if cutting.is_cut() || has_own {
            if cutting.clip_box.is_some() || cutting.slice.is_some() {
                ui.checkbox(&mut session.clipping.has_handles, tr!("clip.handles"));
            }
            ui.checkbox(&mut cutting.shadows, tr!("cuts.light_of_the_whole_scene"));
            ui.label(RichText::new(tr!("cuts.convex")).weak());
            if ui.button(tr!("cuts.show_all_of_it")).clicked() {
                cutting = Cutting::default();
            }
        }
    });
    if cutting != old {
        session.set_cutting(cutting);
    }
}

fn side(ui: &mut Ui, value: &mut f32, range: &RangeInclusive<f32>, name: &str) {
    ui.add(slider(value, range.clone(), name).max_decimals(1));
}

/// Planes, each with where it looks and where it lies, as the sun's place is said: what is on its far side is cut away.
fn planes(ui: &mut Ui, planes: &mut Vec<(Vec3, f32)>, bounds: (Vec3, Vec3), towards_eye: Vec3) {
    let mut gone = None;
    for (index, (normal, offset)) in planes.iter_mut().enumerate() {
        let number = index + 1;
        let [mut bearing, mut height] = direction_of(*normal);
        let mut is_turned = ui.add(slider(&mut bearing, 0.0..=360.0, &tr!("cuts.bearing", number = number))).changed();
        is_turned |= ui.add(slider(&mut height, -90.0..=90.0, &tr!("cuts.height", number = number))).changed();
        if is_turned {
            // It turns around the middle of what it cuts.
            let length = normal.length();
            let (from, to) = span(*normal, bounds);
            let share = if to > from { (*offset - from) / (to - from) } else { 0.5 };
            *normal = normal_of([bearing, height]) * length;
            let (from, to) = span(*normal, bounds);
            *offset = from + share * (to - from);
        }
        let (from, to) = span(*normal, bounds);
        ui.add(slider(offset, from..=to, &tr!("cuts.plane_at", number = number)).max_decimals(1));
        if ui.button(tr!("clip.invert", number = number)).clicked() {
            (*normal, *offset) = (-*normal, -*offset);
        }
        if ui.button(tr!("cuts.without_plane", number = number)).clicked() {
            gone = Some(index);
        }
    }
    gone.into_iter().for_each(|index| _ = planes.remove(index));
    if planes.len() < MOST_PLANES && ui.button(tr!("cuts.cut_by_a_plane")).clicked() {
        let (from, to) = span(towards_eye, bounds);
        planes.push((towards_eye, (0.5 * (from + to)).round()));
    }
}

/// From where to where a box reaches along a normal.
fn span(normal: Vec3, (min, max): (Vec3, Vec3)) -> (f32, f32) {
    let (near, far) = (normal * min, normal * max);
    (near.min(far).element_sum(), near.max(far).element_sum())
}

/// The axis, or its opposite, that is nearest to a direction.
fn along_axis(direction: Vec3) -> Vec3 {
    let size = direction.abs();
    let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
    let mut nearest = Vec3::ZERO;
    nearest[axis] = direction[axis].signum();
    nearest
}

/// Bearing, clockwise from +y, and height of a direction, degrees; upright ones have the bearing 0.
fn direction_of(normal: Vec3) -> [f32; 2] {
    let flat = normal.truncate().length();
    let bearing = if flat > 0.0 { normal.x.atan2(normal.y).to_degrees().rem_euclid(360.0) } else { 0.0 };
    [bearing, normal.z.atan2(flat).to_degrees()]
}

/// The direction of a bearing and a height, whose quarter turns are axes.
fn normal_of([bearing, height]: [f32; 2]) -> Vec3 {
    let (sin, cos) = exact_sin_cos(bearing);
    let (up, flat) = exact_sin_cos(height);
    Vec3::new(flat * sin, flat * cos, up)
}

fn exact_sin_cos(degrees: f32) -> (f32, f32) {
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    let exact = |value: f64| if value.abs() < 1e-9 { 0.0 } else { value as f32 };
    (exact(sin), exact(cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_those_of_their_bearing_and_height() {
        for (place, normal) in [
            ([0.0, 0.0], Vec3::Y),
            ([90.0, 0.0], Vec3::X),
            ([180.0, 0.0], Vec3::NEG_Y),
            ([270.0, 0.0], Vec3::NEG_X),
            ([0.0, 90.0], Vec3::Z),
            ([0.0, -90.0], Vec3::NEG_Z),
        ] {
            assert_eq!(normal_of(place), normal, "{place:?}");
            assert_eq!(direction_of(normal), place, "{normal}");
        }
        for place in [[33.0, 21.0], [300.0, -80.0], [181.0, 45.0]] {
            let [bearing, height] = direction_of(2.0 * normal_of(place));
            assert!((bearing - place[0]).abs() + (height - place[1]).abs() < 1e-3, "{bearing} {height} {place:?}");
        }
        assert_eq!(along_axis(Vec3::new(1.0, -3.0, 2.0)), Vec3::NEG_Y);
        assert_eq!(span(Vec3::new(1.0, -1.0, 0.0), (Vec3::ZERO, Vec3::new(4.0, 3.0, 9.0))), (-3.0, 4.0));
    }
}
