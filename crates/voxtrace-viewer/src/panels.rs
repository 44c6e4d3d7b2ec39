//! The panels over the picture: what is shown, how it is traced, light, and what can be done. They change the state alone.

use crate::engine::Shown;
use crate::keys::{self, Action, Group};
use crate::look::Look;
use crate::navigation::{Mode, Motion};
use crate::session::{Command, Session};
use egui::{Align2, Button, ComboBox, Grid, ProgressBar, RichText, ScrollArea, Slider, SliderClamping, Ui};
use std::collections::VecDeque;
use voxtrace::Integrator;
use voxtrace::output::Operator;
use voxtrace_vulkan::{Primitive, Traversal};

/// Text that says what went wrong: red that can be read on the dark panels.
const ERROR: egui::Color32 = egui::Color32::from_rgb(255, 128, 112);
/// The font of keys: the proportional one has no arrows.
const KEYS: egui::FontId = egui::FontId::monospace(11.0);
/// Points to which a message is as long as its text; then it is wrapped.
const WIDEST_MESSAGE: f32 = 560.0;
/// Frames of the graph.
const FRAMES: usize = 240;

/// What the engine does, for the panels.
#[derive(Default)]
pub struct Status {
    /// The last picture.
    pub shown: Option<Shown>,
    /// Milliseconds a sample of the last steps.
    pub times: VecDeque<f32>,
    /// Share of the step under way that is done.
    pub step_share: f32,
    /// What traces, for people.
    pub device: String,
    /// Scenes that need no file, with a line about each.
    pub built_in: Vec<(String, String)>,
    /// Files that were opened last.
    pub recent: Vec<String>,
}

impl Status {
    /// Takes a picture that is new.
    pub fn take(&mut self, shown: Shown) {
        // Times of a picture of another size would tell nothing.
        if self.shown.as_ref().is_some_and(|last| last.scale == 1 && last.picture.size() != shown.picture.size()) {
            self.times.clear();
        }
        if shown.scale == 1 {
            self.times.push_back((shown.step_ms / f64::from(shown.step_samples.max(1))) as f32);
            while self.times.len() > FRAMES {
                self.times.pop_front();
            }
        }
        self.shown = Some(shown);
    }

    /// The time that a share of the last samples stayed below, milliseconds.
    fn percentile(&self, share: f64) -> Option<f32> {
        let mut times: Vec<f32> = self.times.iter().copied().collect();
        times.sort_by(f32::total_cmp);
        times.get(((times.len().checked_sub(1)?) as f64 * share).round() as usize).copied()
    }
}

/// Shows everything. Returns the width of the side panel, points: the picture lies beside it.
pub fn show(ui: &mut Ui, session: &mut Session, status: &Status) -> f32 {
    let mut width = 0.0;
    if session.has_panels {
        let side = egui::Panel::right("side").resizable(true).default_size(270.0).show(ui, |ui| {
            ScrollArea::vertical().show(ui, |ui| {
                scene(ui, session);
                view(ui, session);
                light(ui, session);
                tracing(ui, session, status);
                statistics(ui, session, status);
                picked(ui, session);
            });
        });
        width = side.response.rect.width();
    }
    if session.open.is_none() && session.loading.is_none() {
        welcome(ui, session, status, width);
    }
    loading(ui, session);
    messages(ui, session);
    if session.has_help {
        help(ui, session);
    }
    width
}

/// A slider for a value that a scene or a key may have set beyond its ends, and that stays so until somebody moves it.
fn slider<'a, N: egui::emath::Numeric>(value: &'a mut N, range: std::ops::RangeInclusive<N>, name: &str) -> Slider<'a> {
    Slider::new(value, range).text(name).clamping(SliderClamping::Edits)
}

fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(text).strong());
}

fn scene(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Scene");
    if let Some(open) = &session.open {
        ui.label(&open.original.name);
        let voxels = open.voxels;
        let objects = open.original.instances().len();
        ui.label(format!("{}, {}", counted(voxels, "voxel"), counted(objects as u64, "object")));
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button("Open…").clicked() {
            session.act(Action::Open, None);
        }
        let has_scene = session.open.is_some();
        if ui.add_enabled(has_scene, Button::new("Picture to file")).clicked() {
            session.act(Action::Screenshot, None);
        }
        if ui.add_enabled(has_scene, Button::new("Copy command")).clicked() {
            session.act(Action::CopyCommand, None);
        }
        if ui.button("Keys").clicked() {
            session.act(Action::Help, None);
        }
    });
}

/// A number with its noun, as people write both: "1 object", "13,600,000 voxels".
fn counted(number: u64, noun: &str) -> String {
    let digits = number.to_string();
    let starts_group = |index: usize| index > 0 && (digits.len() - index).is_multiple_of(3);
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        text.extend(starts_group(index).then_some(','));
        text.push(digit);
    }
    format!("{text} {noun}{}", if number == 1 { "" } else { "s" })
}

fn view(ui: &mut Ui, session: &mut Session) {
    heading(ui, "View");
    let cameras: Vec<voxtrace::Camera> =
        session.open.as_ref().map(|open| open.original.cameras.clone()).unwrap_or_default();
    if !cameras.is_empty() {
        let here = session.navigator.camera().name.clone();
        ComboBox::from_label("camera").selected_text(here.as_str()).show_ui(ui, |ui| {
            for camera in &cameras {
                if ui.selectable_label(camera.name == here, &camera.name).clicked() {
                    session.move_by(Motion::GoTo(camera.clone()));
                }
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        ui.selectable_value(&mut session.navigator.mode, Mode::Orbit, "orbit");
        ui.selectable_value(&mut session.navigator.mode, Mode::Fly, "fly");
        if ui.add_enabled(session.open.is_some(), Button::new("show all")).clicked() {
            session.act(Action::FrameAll, None);
        }
        if ui.add_enabled(session.navigator.can_undo(), Button::new("back")).clicked() {
            session.act(Action::UndoCamera, None);
        }
        if ui.add_enabled(session.navigator.can_redo(), Button::new("forward")).clicked() {
            session.act(Action::RedoCamera, None);
        }
    });
    let mut fov = session.navigator.camera().fov_y;
    if ui.add(slider(&mut fov, 5.0..=120.0, "field of view °")).changed() {
        session.move_by(Motion::FieldOfView(fov));
    }
}

fn light(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Light");
    let mut look = session.look.clone();
    ui.add(slider(&mut look.tone_map.exposure, -8.0..=8.0, "exposure, stops"));
    ComboBox::from_label("curve").selected_text(look.tone_map.operator.name()).show_ui(ui, |ui| {
        for operator in Operator::ALL {
            ui.selectable_value(&mut look.tone_map.operator, operator, operator.name());
        }
    });
    if let Some(open) = &session.open {
        let mut lamps = open.lit.light_intensity;
        if ui
            .add(slider(&mut lamps, 0.0..=100.0, "lamps ×").logarithmic(true).smallest_positive(0.01).max_decimals(2))
            .changed()
        {
            look.light_intensity = Some(lamps);
        }
        let mut sky = open.lit.sky.brightness();
        if ui
            .add(
                slider(&mut sky, 0.0..=20.0, "sky and sun ×").logarithmic(true).smallest_positive(0.01).max_decimals(2),
            )
            .changed()
        {
            look.sky_brightness = Some(sky);
        }
        let mut sun = session.sun();
        let mut is_changed = ui.add(slider(&mut sun.bearing, 0.0..=360.0, "sun's bearing °")).changed();
        is_changed |= ui.add(slider(&mut sun.height, -10.0..=90.0, "sun's height °")).changed();
        is_changed |= ui.add(slider(&mut sun.strength, 0.0..=20.0, "sun's strength")).changed();
        if is_changed {
            look.sun = Some(sun);
        }
        let is_own = (look.light_intensity, look.sky_brightness, look.sun) == (None, None, None);
        if ui.add_enabled(!is_own, Button::new("the scene's own light")).clicked() {
            look = Look { light_intensity: None, sky_brightness: None, sun: None, ..look };
        }
    }
    session.set_look(look);
}

fn tracing(ui: &mut Ui, session: &mut Session, status: &Status) {
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

fn statistics(ui: &mut Ui, session: &Session, status: &Status) {
    let Some(shown) = &status.shown else { return };
    heading(ui, "Measured");
    let (width, height) = session.size();
    let scale = if shown.scale > 1 { format!(", at 1/{} of the resolution", shown.scale) } else { String::new() };
    ui.label(format!("{width} × {height}, {} of {} samples{scale}", shown.samples, session.look.samples));
    if status.step_share > 0.0 && status.step_share < 1.0 && shown.step_ms > 500.0 {
        ui.add(ProgressBar::new(status.step_share).text("next pass"));
    }
    if let (Some(median), Some(p99)) = (status.percentile(0.5), status.percentile(0.99)) {
        ui.label(format!("{median:.2} ms a sample; 99 %: {p99:.2} ms"));
        graph(ui, &status.times);
    }
    if let Some((statistics, memory)) = &shown.device {
        let rays = statistics.camera_rays + statistics.bounce_rays + statistics.shadow_rays;
        if statistics.gpu_ms > 0.0 {
            ui.label(format!("{:.1} million rays a second", rays as f64 / statistics.gpu_ms / 1e3));
        }
        egui::CollapsingHeader::new(format!("memory: {:.1} MiB", mebibytes(memory.total_bytes()))).show(ui, |ui| {
            Grid::new("memory").show(ui, |ui| {
                for (name, &bytes) in &memory.entries {
                    ui.label(name);
                    ui.label(format!("{:.2} MiB", mebibytes(bytes)));
                    ui.end_row();
                }
            });
        });
    }
}

fn mebibytes(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 20)
}

/// Times as bars, the longest as high as the graph.
fn graph(ui: &mut Ui, times: &VecDeque<f32>) {
    let (rect, _) = ui.allocate_exact_size(egui::vec2(ui.available_width().min(240.0), 36.0), egui::Sense::hover());
    let most = times.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 2.0, ui.visuals().extreme_bg_color);
    let step = rect.width() / FRAMES as f32;
    for (index, time) in times.iter().enumerate() {
        let x = rect.left() + (index as f32 + 0.5) * step;
        let top = rect.bottom() - time / most * rect.height();
        let stroke = egui::Stroke::new(step.max(1.0), ui.visuals().selection.bg_fill);
        painter.line_segment([egui::pos2(x, rect.bottom()), egui::pos2(x, top)], stroke);
    }
}

fn picked(ui: &mut Ui, session: &mut Session) {
    let (Some(picked), Some(open)) = (&session.picked, &session.open) else { return };
    heading(ui, "Picked voxel");
    let voxel = picked.hit.voxel;
    let material = &open.lit.materials()[picked.material as usize];
    let color = material.base_color;
    let srgb = color.map(|value| (voxtrace::material::encode_srgb(value.into()) * 255.0) as f32);
    ui.label(format!("voxel {}, {}, {} of object {}", voxel.x, voxel.y, voxel.z, picked.hit.instance));
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, 14.0), egui::Sense::hover());
        let fill = egui::Color32::from_rgb(srgb.x as u8, srgb.y as u8, srgb.z as u8);
        ui.painter_at(rect).rect_filled(rect, 2.0, fill);
        ui.label(format!("material {}, #{:02x}{:02x}{:02x}", picked.material, fill.r(), fill.g(), fill.b()));
    });
    let point = picked.point;
    ui.label(format!("at {:.2}, {:.2}, {:.2}", point.x, point.y, point.z));
    if ui.button("frame it").clicked() {
        session.act(Action::FramePicked, None);
    }
}

fn welcome(ui: &Ui, session: &mut Session, status: &Status, side: f32) {
    // In the middle of what the side panel leaves.
    egui::Window::new("voxtrace")
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label("Drop a file here, or open one of these:");
            ui.add_space(6.0);
            for (name, about) in &status.built_in {
                ui.horizontal(|ui| {
                    if ui.button(name).clicked() {
                        session.ask(Command::Load(name.clone()));
                    }
                    ui.label(RichText::new(about).weak());
                });
            }
            ui.add_space(6.0);
            if ui.button("Open a file…").clicked() {
                session.act(Action::Open, None);
            }
            if !status.recent.is_empty() {
                ui.separator();
                ui.label("Opened last:");
                for path in &status.recent {
                    if ui.link(path).clicked() {
                        session.ask(Command::Load(path.clone()));
                    }
                }
            }
        });
}

fn loading(ui: &Ui, session: &mut Session) {
    let Some(loading) = &session.loading else { return };
    let text = match loading.seconds_left {
        Some(seconds) if seconds >= 1.0 => format!("{}, {seconds:.0} s left", loading.work),
        _ => loading.work.clone(),
    };
    let (source, share) = (loading.source.clone(), loading.share);
    let mut is_cancelled = false;
    egui::Window::new("Opening").anchor(Align2::CENTER_BOTTOM, [0.0, -24.0]).collapsible(false).resizable(false).show(
        ui.ctx(),
        |ui| {
            ui.label(source);
            match share {
                Some(share) => ui.add(ProgressBar::new(share).desired_width(260.0).text(text)),
                None => ui.horizontal(|ui| (ui.spinner(), ui.label(text)).1).inner,
            };
            is_cancelled = ui.button("Stop").clicked();
        },
    );
    if is_cancelled {
        session.act(Action::Cancel, None);
    }
}

fn messages(ui: &Ui, session: &mut Session) {
    if !session.has_messages() {
        return;
    }
    let lines: Vec<(String, bool)> =
        session.messages().map(|message| (message.text.clone(), message.is_error)).collect();
    egui::Area::new("messages".into())
        .anchor(Align2::LEFT_BOTTOM, [10.0, -10.0])
        .interactable(false)
        .default_width(WIDEST_MESSAGE)
        .show(ui.ctx(), |ui| {
            for (text, is_error) in lines {
                egui::Frame::popup(ui.style()).show(ui, |ui| {
                    let text = RichText::new(text);
                    ui.label(if is_error { text.color(ERROR) } else { text });
                });
            }
        });
}

fn help(ui: &Ui, session: &mut Session) {
    let mut is_open = true;
    egui::Window::new("Keys and gestures")
        .open(&mut is_open)
        .default_pos([24.0, 24.0])
        .default_size([880.0, 560.0])
        .show(ui.ctx(), |ui| {
            ScrollArea::both().auto_shrink(false).show(ui, |ui| {
                // One grid for all groups: their columns stand one below the other.
                Grid::new("keys").striped(true).show(ui, |ui| {
                    for group in Group::ALL {
                        heading(ui, group.name());
                        ui.end_row();
                        for row in keys::rows(group) {
                            ui.label(RichText::new(row.keys).font(KEYS).strong());
                            ui.label(row.about);
                            ui.end_row();
                        }
                    }
                });
            });
        });
    session.has_help = is_open;
}
