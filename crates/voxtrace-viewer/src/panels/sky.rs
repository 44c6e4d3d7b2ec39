//! The part of the panel of light that chooses the sky.

use super::slider;
use crate::dialogs::PathField;
use crate::render_command::SkySetting;
use crate::render_settings::RenderSettings;
use crate::session::Session;
use crate::strings::text;
use crate::{text_key, tr};
use egui::{ComboBox, Key, TextEdit, Ui};
use std::path::PathBuf;
use voxtrace::Sky;
use voxtrace::glam::Vec3;

/// The choices, with what each says to whoever chooses.
const OWN: &str = text_key!("sky.own");
const COLOR: &str = text_key!("sky.one_colour");
const PHYSICAL: &str = text_key!("sky.physical");
const PANORAMA: &str = text_key!("sky.panorama");

/// Shows what the sky is and takes another; `lit` is the one that is seen.
pub fn sky(ui: &mut Ui, session: &mut Session, settings: &mut RenderSettings, lit: &Sky) {
    let field = session.panorama.as_mut();
    let is_panorama = field.is_some() || matches!(settings.sky, Some(SkySetting::Panorama(_)));
    let shown = match &settings.sky {
        _ if is_panorama => PANORAMA,
        None => OWN,
        Some(SkySetting::Color(_)) => COLOR,
        Some(_) => PHYSICAL,
    };
    let mut chosen = shown;
    ComboBox::from_label(tr!("sky.sky")).selected_text(text(shown)).show_ui(ui, |ui| {
        for choice in [OWN, COLOR, PHYSICAL, PANORAMA] {
            ui.selectable_value(&mut chosen, choice, text(choice));
        }
    });
    if chosen != shown {
        choose(session, settings, chosen, lit);
        return;
    }
    if let Some(SkySetting::Color(color)) = &mut settings.sky {
        let mut channels = color.to_array();
        let shown = ui.color_edit_button_rgb(&mut channels);
        super::name_node(ui, &shown, tr!("sky.colour_of_the_sky"));
        if shown.changed() {
            *color = Vec3::from_array(channels);
        }
    }
    if is_panorama && let Some(path) = path_field(ui, session, settings) {
        session.panorama = None;
        (settings.sky, settings.sky_rotation) = (Some(SkySetting::Panorama(path)), None);
    }
    if settings.sky != Some(SkySetting::Physical)
        && let Some(environment) = lit.background().environment()
    {
        let mut rotation = settings.sky_rotation.unwrap_or(environment.rotation());
        if ui.add(slider(&mut rotation, -180.0..=180.0, tr!("sky.sky_turned_by"))).changed() {
            settings.sky_rotation = Some(rotation);
        }
    }
    if session.skies.is_making() {
        ui.label(tr!("sky.the_sky_is_being_made"));
    }
}

/// Takes another kind of sky. A panorama needs a file first.
fn choose(session: &mut Session, settings: &mut RenderSettings, chosen: &str, lit: &Sky) {
    if chosen == PANORAMA {
        session.panorama = Some(PathField::default());
        return;
    }
    session.panorama = None;
    settings.sky_rotation = None;
    settings.sky = match chosen {
        COLOR => Some(SkySetting::Color(lit.background().mean_radiance())),
        PHYSICAL => Some(SkySetting::Physical),
        _ => None,
    };
}

/// The field of a panorama's file. Gives a path that was entered.
fn path_field(ui: &mut Ui, session: &mut Session, settings: &RenderSettings) -> Option<PathBuf> {
    let field = session.panorama.get_or_insert_with(|| match &settings.sky {
        Some(SkySetting::Panorama(path)) => PathField::new(path),
        _ => PathField::default(),
    });
    let label = ui.label(tr!("sky.file_hdr_exr_or_drop"));
    let edit = ui.add(TextEdit::singleline(&mut field.text)).labelled_by(label.id);
    let is_entered = edit.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let path = field.path().filter(|_| is_entered)?;
    Some(std::path::absolute(&path).unwrap_or(path))
}
