//! The panel of light: exposure, curve, what glows, sky and sun.

use super::{heading, sky, slider};
use crate::session::Session;
use crate::tr;
use egui::{Button, ComboBox, Ui};
use voxtrace::output::Operator;

pub fn light(ui: &mut Ui, session: &mut Session) {
    heading(ui, tr!("light.light"));
    let mut settings = session.render_settings.clone();
    ui.add(slider(&mut settings.tone_map.exposure, -8.0..=8.0, tr!("light.exposure_stops")));
    ComboBox::from_label(tr!("light.curve")).selected_text(settings.tone_map.operator.name()).show_ui(ui, |ui| {
        for operator in Operator::ALL {
            ui.selectable_value(&mut settings.tone_map.operator, operator, operator.name());
        }
    });
    if let Some(open) = &session.open {
        let mut lamps = open.lit.light_intensity;
        if ui
            .add(
                slider(&mut lamps, 0.0..=100.0, tr!("light.lamps"))
                    .logarithmic(true)
                    .smallest_positive(0.01)
                    .max_decimals(2),
            )
            .changed()
        {
            settings.light_intensity = Some(lamps);
        }
        let mut brightness = open.lit.sky.brightness();
        if ui
            .add(
                slider(&mut brightness, 0.0..=20.0, tr!("light.sky_and_sun"))
                    .logarithmic(true)
                    .smallest_positive(0.01)
                    .max_decimals(2),
            )
            .changed()
        {
            settings.sky_brightness = Some(brightness);
        }
        let lit = open.lit.sky.clone();
        sky::sky(ui, session, &mut settings, &lit);
        let mut sun = session.sun();
        let mut is_changed = ui.add(slider(&mut sun.bearing, 0.0..=360.0, tr!("light.sun_s_bearing"))).changed();
        is_changed |= ui.add(slider(&mut sun.height, -10.0..=90.0, tr!("light.sun_s_height"))).changed();
        is_changed |= ui.add(slider(&mut sun.strength, 0.0..=20.0, tr!("light.sun_s_strength"))).changed();
        if is_changed {
            settings.sun = Some(sun);
        }
        let mut is_visible = lit.is_sun_disc_visible();
        if ui.checkbox(&mut is_visible, tr!("light.the_camera_sees_the_sun")).changed() {
            settings.sun_disc = Some(is_visible);
        }
        let own = settings.clone().without_light();
        if ui.add_enabled(!settings.has_light_of(&own), Button::new(tr!("light.the_scene_s_own_light"))).clicked() {
            settings = own;
            session.panorama = None;
        }
    }
    session.set_render_settings(settings);
}
