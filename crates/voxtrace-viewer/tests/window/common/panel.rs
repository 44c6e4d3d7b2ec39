//! The panels with a session, and what somebody does there: as a screen reader has them and does it.

use egui::accesskit::{Action as SetTo, ActionData, ActionRequest, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use voxtrace_viewer::panels::{self, Status};
use voxtrace_viewer::session::Session;

/// Panels of a window so high that nothing is scrolled away.
pub fn panels<'a>(session: Session, status: Status) -> Harness<'a, Session> {
    let show = move |ui: &mut egui::Ui, session: &mut Session| {
        panels::show(ui, session, &status);
    };
    let mut harness = Harness::builder().with_size([1280.0, 2400.0]).build_ui_state(show, session);
    harness.run_steps(3);
    harness
}

/// Panels of a window of 600 × 400 points.
pub fn small_panels<'a>(session: Session) -> Harness<'a, Session> {
    sized_panels(session, [600.0, 400.0])
}

/// Panels of a window of so many points.
pub fn sized_panels<'a>(session: Session, size: [f32; 2]) -> Harness<'a, Session> {
    let show = |ui: &mut egui::Ui, session: &mut Session| {
        panels::show(ui, session, &Status::default());
    };
    let mut harness = Harness::builder().with_size(size).build_ui_state(show, session);
    harness.run_steps(3);
    harness
}

pub fn click(harness: &mut Harness<Session>, name: &str) {
    harness.get_by_label(name).click();
    harness.run_steps(3);
}

/// Chooses from the box of a name.
pub fn choose(harness: &mut Harness<Session>, combo: &str, choice: &str) {
    harness.get_by_role_and_label(Role::ComboBox, combo).click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, choice).click();
    harness.run_steps(3);
}

/// Sets a slider.
pub fn set(harness: &mut Harness<Session>, slider: &str, value: f64) {
    let (target_node, target_tree) = harness.get_by_role_and_label(Role::Slider, slider).accesskit_node().locate();
    let data = Some(ActionData::NumericValue(value));
    let request = ActionRequest { action: SetTo::SetValue, target_node, target_tree, data };
    harness.event(egui::Event::AccessKitActionRequest(request));
    harness.run_steps(3);
}
