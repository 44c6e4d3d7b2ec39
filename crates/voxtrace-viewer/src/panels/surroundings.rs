//! The panel of what is around the scene: a ground, and fog. All of it is an option of `voxtrace render`, too.

use super::{name_node, section, slider};
use crate::session::Session;
use crate::tr;
use egui::Ui;
use voxtrace::glam::Vec3;
use voxtrace::material::linear_color;
use voxtrace::surroundings::{Fog, Ground};

/// What a ground begins with, as that of `render`.
const GREY: [u8; 3] = [80; 3];
/// How often light is scattered on its way from corner to corner by the fog that somebody begins with.
const SCATTERED: f32 = 0.1;
/// The densest fog of the slider, from corner to corner likewise; and the ends of how light goes on, which are those of `render`.
const MOST_SCATTERED: f32 = 30.0;
const MOST_G: f32 = 0.99;

pub fn surroundings(ui: &mut Ui, session: &mut Session) {
    let Some((min, max)) = session.open.as_ref().and_then(|open| open.alone.bounds()) else { return };
    let mut settings = session.render_settings.clone();
    let title = match (settings.surroundings.ground.is_some(), settings.surroundings.fog.is_some()) {
        (false, false) => tr!("surroundings.title"),
        (true, false) => tr!("surroundings.title_ground"),
        (false, true) => tr!("surroundings.title_fog"),
        (true, true) => tr!("surroundings.title_both"),
    };
    let diagonal = (max - min).length().max(1.0);
    section(ui, title, "surroundings", |ui| {
        let ground = &mut settings.surroundings.ground;
        let mut has_ground = ground.is_some();
        if ui.checkbox(&mut has_ground, tr!("surroundings.ground")).changed() {
            *ground = has_ground.then(|| Ground { height: None, color: linear_color(GREY) });
        }
        if let Some(Ground { height, color }) = ground {
            pick_color(ui, color, tr!("surroundings.ground_colour"));
            let mut shown = height.unwrap_or(min.z);
            let range = min.z - 0.5 * diagonal..=max.z;
            if ui.add(slider(&mut shown, range, tr!("surroundings.ground_s_height")).max_decimals(1)).changed() {
                *height = Some(shown);
            }
            if height.is_some() && ui.button(tr!("surroundings.below_the_lowest_voxel")).clicked() {
                *height = None;
            }
        }
        let fog = &mut settings.surroundings.fog;
        let mut has_fog = fog.is_some();
        if ui.checkbox(&mut has_fog, tr!("surroundings.fog")).changed() {
            let density = two_digits(SCATTERED / diagonal);
            *fog = has_fog.then_some(Fog { density, color: Vec3::ONE, anisotropy: 0.0 });
        }
        if let Some(Fog { density, color, anisotropy }) = fog {
            let range = two_digits(0.01 / diagonal)..=two_digits(MOST_SCATTERED / diagonal);
            ui.add(slider(density, range, tr!("surroundings.fog_s_density")).logarithmic(true));
            pick_color(ui, color, tr!("surroundings.fog_colour"));
            ui.add(slider(anisotropy, -MOST_G..=MOST_G, tr!("surroundings.light_goes_on")).max_decimals(2))
                .on_hover_text(tr!("surroundings.on_about"));
        }
        if session.is_surrounding() {
            ui.label(tr!("surroundings.the_surroundings_are_being_made"));
        }
    });
    session.set_render_settings(settings);
}

/// A colour with its name beside it. Channels are linear, from 0 to 1.
pub(super) fn pick_color(ui: &mut Ui, color: &mut Vec3, name: &str) {
    ui.horizontal(|ui| {
        let mut channels = color.to_array();
        let button = ui.color_edit_button_rgb(&mut channels);
        name_node(ui, &button, name);
        if button.changed() {
            *color = Vec3::from_array(channels).clamp(Vec3::ZERO, Vec3::ONE);
        }
        ui.label(name);
    });
}

/// A number of two digits, which a command says as shortly.
fn two_digits(value: f32) -> f32 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
