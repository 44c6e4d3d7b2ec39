//! The panel of what traces, and how.

use super::status::Status;
use super::{heading, slider};
use crate::session::{Command, Session};
use egui::{ComboBox, Ui};
use voxtrace::Integrator;
use voxtrace_vulkan::{Primitive, Traversal};

pub fn tracing(ui: &mut Ui, session: &mut Session, status: &Status) {
    heading(ui, "Tracing");
    let mut settings = session.render_settings.clone();
    ComboBox::from_label("traversal").selected_text(settings.traversal.name()).show_ui(ui, |ui| {
        for &traversal in &session.traversals {
            ui.selectable_value(&mut settings.traversal, traversal, traversal.name());
        }
    });
    if matches!(settings.traversal, Traversal::Query | Traversal::Pipeline) {
        ComboBox::from_label("primitive").selected_text(settings.primitive.name()).show_ui(ui, |ui| {
            for primitive in Primitive::ALL {
                ui.selectable_value(&mut settings.primitive, primitive, primitive.name());
            }
        });
    }
    if settings.traversal != Traversal::Cpu {
        ui.checkbox(&mut settings.fast, "fast: not the CPU's bits");
    }
    ui.horizontal(|ui| {
        for integrator in [Integrator::Path, Integrator::Essay] {
            if ui.selectable_label(settings.integrator == integrator, integrator.name()).clicked() {
                settings.take_integrator(integrator);
            }
        }
        let mut is_paused = session.is_paused;
        if ui.checkbox(&mut is_paused, "paused").changed() {
            session.set_paused(is_paused);
        }
    });
    ui.add(slider(&mut settings.max_bounces, 0..=32, "bounces"));
    ui.add(slider(&mut settings.samples, 1..=65_536, "samples").logarithmic(true));
    if status.devices.len() > 1 {
        let now = status.devices.iter().find(|device| device.index == status.device_index);
        ComboBox::from_label("device").truncate().selected_text(now.map_or("", |device| &device.label)).show_ui(
            ui,
            |ui| {
                for device in &status.devices {
                    let is_now = device.index == status.device_index;
                    if ui.selectable_label(is_now, &device.label).clicked() && !is_now {
                        session.ask(Command::SetDevice(device.value.clone()));
                    }
                }
            },
        );
    } else {
        ui.label(&status.device);
    }
    session.set_render_settings(settings);
}
