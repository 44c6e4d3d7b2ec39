//! The panel of what traces, and how.

use super::status::Status;
use super::{heading, section, slider};
use crate::engine::Light;
use crate::render_settings::RenderSettings;
use crate::session::{Command, Session};
use crate::tr;
use egui::{ComboBox, Slider, Ui};
use voxtrace::{BounceLimits, Integrator};
use voxtrace_vulkan::{Primitive, Traversal};

/// What a clamp begins with, radiance.
const CLAMP: f32 = 4.0;

pub fn tracing(ui: &mut Ui, session: &mut Session, status: &Status) {
    heading(ui, tr!("tracing.tracing"));
    let mut settings = session.render_settings.clone();
    ComboBox::from_label(tr!("tracing.traversal")).selected_text(settings.traversal.name()).show_ui(ui, |ui| {
        for &traversal in &session.traversals {
            ui.selectable_value(&mut settings.traversal, traversal, traversal.name());
        }
    });
    if matches!(settings.traversal, Traversal::Query | Traversal::Pipeline) {
        ComboBox::from_label(tr!("tracing.primitive")).selected_text(settings.primitive.name()).show_ui(ui, |ui| {
            for primitive in Primitive::ALL {
                ui.selectable_value(&mut settings.primitive, primitive, primitive.name());
            }
        });
    }
    if settings.traversal != Traversal::Cpu {
        ui.checkbox(&mut settings.fast, tr!("tracing.fast_not_the_cpu_s"));
    }
    ui.horizontal(|ui| {
        for integrator in [Integrator::Path, Integrator::Essay] {
            if ui.selectable_label(settings.integrator == integrator, integrator.name()).clicked() {
                settings.take_integrator(integrator);
            }
        }
        let mut is_paused = session.is_paused;
        if ui.checkbox(&mut is_paused, tr!("tracing.paused")).changed() {
            session.set_paused(is_paused);
        }
    });
    light(ui, session);
    ui.add(slider(&mut settings.max_bounces, 0..=32, tr!("tracing.bounces")));
    limits(ui, &mut settings);
    ui.add(slider(&mut settings.samples, 1..=65_536, tr!("tracing.samples")).logarithmic(true));
    if status.devices.len() > 1 {
        let now = status.devices.iter().find(|device| device.index == status.device_index);
        ComboBox::from_label(tr!("tracing.device"))
            .truncate()
            .selected_text(now.map_or("", |device| &device.label))
            .show_ui(ui, |ui| {
                for device in &status.devices {
                    let is_now = device.index == status.device_index;
                    if ui.selectable_label(is_now, &device.label).clicked() && !is_now {
                        session.ask(Command::SetDevice(device.value.clone()));
                    }
                }
            });
    } else {
        ui.label(&status.device);
    }
    session.set_render_settings(settings);
}

/// Whether views that move are shown in real-time light.
fn light(ui: &mut Ui, session: &mut Session) {
    let why_not = session.no_real_time();
    ui.add_enabled_ui(why_not.is_none(), |ui| {
        let mut is_on = session.wants_real_time();
        let response = ui.checkbox(&mut is_on, tr!("real_time.title"));
        if response.on_disabled_hover_text(why_not.unwrap_or_default()).changed() {
            session.toggle_real_time();
        }
        let mut is_bare = session.light.is_bare;
        let response = ui.checkbox(&mut is_bare, tr!("real_time.bare"));
        if response.on_hover_text(tr!("real_time.bare_about")).changed() {
            session.set_light(Light { is_bare, ..session.light });
        }
    });
}

/// Bounces by kind, and the clamp of indirect light.
fn limits(ui: &mut Ui, settings: &mut RenderSettings) {
    let is_limited = settings.bounce_limits != BounceLimits::default() || settings.clamp_indirect.is_some();
    let is_limited = is_limited || settings.clear_shadows;
    let title = if is_limited { tr!("tracing.limits_some") } else { tr!("tracing.limits") };
    section(ui, title, "limits", |ui| {
        let BounceLimits { diffuse, glossy, transmitted, volume } = &mut settings.bounce_limits;
        let kinds = [
            (diffuse, tr!("tracing.bounces_matte")),
            (glossy, tr!("tracing.bounces_glossy")),
            (transmitted, tr!("tracing.bounces_glass")),
            (volume, tr!("tracing.bounces_media")),
        ];
        for (limit, name) in kinds {
            bounces(ui, limit, name);
        }
        let mut is_clamped = settings.clamp_indirect.is_some();
        if ui.checkbox(&mut is_clamped, tr!("tracing.clamp_indirect_light_less_noise")).changed() {
            settings.clamp_indirect = is_clamped.then_some(CLAMP);
        }
        if let Some(most) = &mut settings.clamp_indirect {
            ui.add(slider(most, 0.1..=100.0, tr!("tracing.most_radiance")).logarithmic(true).max_decimals(2));
        }
        ui.checkbox(&mut settings.clear_shadows, tr!("tracing.clear_shadows_light_passes_glass"));
    });
}

/// A limit of bounces; beyond the end of the slider there is none.
fn bounces(ui: &mut Ui, limit: &mut u8, name: &str) {
    const END: u8 = 33;
    let mut shown = if *limit == BounceLimits::UNLIMITED { END } else { *limit };
    let text =
        |value: f64, _| if value >= f64::from(END) { tr!("tracing.all").to_owned() } else { format!("{value:.0}") };
    let read = |text: &str| if text.trim() == tr!("tracing.all") { Some(END.into()) } else { text.trim().parse().ok() };
    let slider = Slider::new(&mut shown, 0..=END).text(name).custom_formatter(text).custom_parser(read);
    if ui.add(slider).changed() {
        *limit = if shown >= END { BounceLimits::UNLIMITED } else { shown };
    }
}
