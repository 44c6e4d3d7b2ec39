//! The panel of the lens: which one, and how it is set. All of it is an option of `voxtrace render`, too.

use super::slider;
use crate::lens::{FISHEYE_ANGLES, LensChoice};
use crate::navigation::Motion;
use crate::session::Session;
use crate::tr;
use egui::{Button, ComboBox, Ui};
use voxtrace::camera::Lens;

/// Most blades that the box lists.
const MOST_BLADES: u32 = 12;
/// Shortest length that can be chosen, voxels.
const SHORTEST: f32 = 0.001;

pub fn lens(ui: &mut Ui, session: &mut Session) {
    let now = LensChoice::of(session.navigator.camera());
    let mut choice = now;
    ComboBox::from_label(tr!("lens.lens")).selected_text(now.name()).show_ui(ui, |ui| {
        for lens in LensChoice::ALL {
            ui.selectable_value(&mut choice, lens, lens.name());
        }
    });
    if choice != now {
        session.choose_lens(choice);
    }
    let (mut lens, mut fov) = (session.navigator.camera().lens, session.navigator.camera().fov_y);
    let (old, size) = (lens, session.navigator.diagonal());
    if matches!(lens, Lens::Pinhole | Lens::Thin { .. })
        && ui.add(slider(&mut fov, 5.0..=120.0, tr!("lens.field_of_view"))).changed()
    {
        session.move_by(Motion::FieldOfView(fov));
    }
    match &mut lens {
        Lens::Thin { aperture, focus, blades, blade_rotation } => {
            length(ui, aperture, size * 0.05, tr!("lens.aperture"));
            length(ui, focus, size * 2.0, tr!("lens.focus"));
            diaphragm(ui, blades, blade_rotation);
        }
        Lens::Orthographic { view_height } => length(ui, view_height, size * 4.0, tr!("lens.height")),
        Lens::Panorama { eye_distance } => {
            let range = 0.0..=(size * 0.05).max(1.0);
            let slider = slider(eye_distance, range, tr!("lens.eyes_apart_voxels")).logarithmic(true);
            ui.add(slider.smallest_positive(SHORTEST.into()));
        }
        Lens::Fisheye { fisheye_angle } => {
            ui.add(slider(fisheye_angle, FISHEYE_ANGLES, tr!("lens.angle")));
        }
        _ => {}
    }
    if lens != old {
        session.move_by(Motion::Lens(lens));
    }
    if matches!(lens, Lens::Pinhole | Lens::Thin { .. }) {
        focus(ui, session);
    }
}

/// A length greater than 0.
fn length(ui: &mut Ui, value: &mut f32, most: f32, name: &str) {
    ui.add(slider(value, SHORTEST..=most.max(1.0), name).logarithmic(true));
}

fn diaphragm(ui: &mut Ui, blades: &mut u32, rotation: &mut f32) {
    let name =
        |blades: u32| if blades == 0 { tr!("lens.round").to_owned() } else { tr!("lens.blades", blades = blades) };
    ComboBox::from_label(tr!("lens.diaphragm")).selected_text(name(*blades)).show_ui(ui, |ui| {
        for choice in std::iter::once(0).chain(3..=MOST_BLADES) {
            ui.selectable_value(blades, choice, name(choice));
        }
    });
    if *blades > 0 {
        ui.add(slider(rotation, -180.0..=180.0, tr!("lens.turned")));
    }
}

fn focus(ui: &mut Ui, session: &mut Session) {
    let picked = session.picked.as_ref().map(|picked| picked.point);
    let text = if picked.is_some() { tr!("lens.focus_picked") } else { tr!("lens.focus_middle") };
    if ui.add_enabled(session.open.is_some(), Button::new(text)).clicked() {
        let point = picked.unwrap_or_else(|| session.middle());
        session.focus_on(point);
    }
}
