//! The panel of what traces, and how.

use super::status::Status;
use super::{heading, slider};
use crate::session::Session;
use egui::{ComboBox, Ui};
use voxtrace::Integrator;
use voxtrace_vulkan::{Primitive, Traversal};

pub fn tracing(ui: &mut Ui, session: &mut Session, status: &Status) {
    heading(ui, "Tracing");
    let mut look = session.look.clone();
    ComboBox::from_label("traversal").selected_text(look.traversal.name()).show_ui(ui, |ui| {
        for &traversal in &session.traversals {
            ui.selectable_value(&mut look.traversal, traversal, traversal.name());
        }
    });
    if matches!(look.traversal, Traversal::Query | Traversal::Pipeline) {
        ComboBox::from_label("primitive").selected_text(look.primitive.name()).show_ui(ui, |ui| {
            for primitive in Primitive::ALL {
                ui.selectable_value(&mut look.primitive, primitive, primitive.name());
            }
        });
    }
    if look.traversal != Traversal::Cpu {
        ui.checkbox(&mut look.fast, "fast: not the CPU's bits");
    }
    ui.horizontal(|ui| {
        for integrator in [Integrator::Path, Integrator::Essay] {
            if ui.selectable_label(look.integrator == integrator, integrator.name()).clicked() {
                look.take_integrator(integrator);
            }
        }
        let mut is_paused = session.is_paused;
        if ui.checkbox(&mut is_paused, "paused").changed() {
            session.set_paused(is_paused);
        }
    });
    ui.add(slider(&mut look.max_bounces, 0..=32, "bounces"));
    ui.add(slider(&mut look.samples, 1..=65_536, "samples").logarithmic(true));
    ui.label(&status.device);
    session.set_look(look);
}
