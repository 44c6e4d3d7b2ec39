//! The panel of cuts: a box, a slice, and how what is left is lit. All of it is an option of `voxtrace render`, too.

use super::slider;
use crate::cutting::{Cutting, LEAST, Slice};
use crate::session::Session;
use egui::{CollapsingHeader, Ui};
use std::ops::RangeInclusive;

const AXES: [&str; 3] = ["x", "y", "z"];

pub fn cuts(ui: &mut Ui, session: &mut Session) {
    let Some([min, max]) = session.whole_box() else { return };
    let old = session.render_settings.cutting;
    let mut cutting = old;
    let header = CollapsingHeader::new(if old.is_cut() { "Cuts (cut open)" } else { "Cuts" }).id_salt("cuts");
    header.show(ui, |ui| {
        let mut has_box = cutting.clip_box.is_some();
        if ui.checkbox(&mut has_box, "box").changed() {
            cutting.clip_box = has_box.then_some([min, max]);
        }
        if let Some([from, to]) = &mut cutting.clip_box {
            for (axis, name) in AXES.into_iter().enumerate() {
                let range = min[axis]..=max[axis];
                side(ui, &mut from[axis], &range, &format!("{name} from"));
                // Whichever side is moved pushes the other.
                to[axis] = to[axis].max(from[axis] + LEAST);
                side(ui, &mut to[axis], &range, &format!("{name} to"));
                from[axis] = from[axis].min(to[axis] - LEAST);
            }
        }
        let mut has_slice = cutting.slice.is_some();
        if ui.checkbox(&mut has_slice, "slice").changed() {
            let middle = (0.5 * (min.z + max.z)).floor();
            cutting.slice = has_slice.then_some(Slice { axis: 2, from: middle, thickness: 1.0 });
        }
        if let Some(slice) = &mut cutting.slice {
            ui.horizontal(|ui| {
                ui.label("across");
                for (axis, name) in AXES.into_iter().enumerate() {
                    if ui.selectable_label(slice.axis == axis, name).clicked() && slice.axis != axis {
                        (slice.axis, slice.from) = (axis, (0.5 * (min[axis] + max[axis])).floor());
                    }
                }
            });
            let length = max[slice.axis] - min[slice.axis];
            side(ui, &mut slice.from, &(min[slice.axis]..=max[slice.axis]), "slice at");
            ui.add(
                slider(&mut slice.thickness, LEAST..=length.max(1.0), "thickness").logarithmic(true).max_decimals(1),
            );
        }
        let has_planes = session.open.as_ref().is_some_and(|open| !open.original.cuts.is_none());
        if cutting.is_cut() || has_planes {
            ui.checkbox(&mut cutting.shadows, "light of the whole scene");
            if ui.button("show all of it").clicked() {
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
