//! The panels over the picture: what is shown, how it is traced, light, and what can be done. They change the state alone.

mod benchmark;
mod clipping;
mod comparison;
mod cuts;
mod dialogs;
mod edit_preview;
mod editing;
mod help;
mod lens;
mod light;
mod lines;
mod look;
mod materials;
mod measuring;
mod messages;
mod over;
mod parts;
mod picked;
mod points;
mod running;
mod scene;
mod sky;
mod statistics;
mod status;
mod surroundings;
mod timeline;
mod times;
mod tracing;
mod unsaved;
mod values;
mod view;
mod welcome;

pub use look::Theme;
pub use status::{Compared, DeviceChoice, Status};

use crate::session::Session;
use crate::tr;
use egui::{
    Align2, CollapsingHeader, Color32, Frame, Margin, Rect, RichText, ScrollArea, Slider, SliderClamping, TextStyle,
    Ui, vec2,
};

/// Points of the side panel, as long as nobody drags it.
const WIDTH: f32 = 290.0;
/// Points below windows about what is under way.
const GAP: f32 = 24.0;
/// Points that title and frame of a window over the picture take.
const TITLE: f32 = 60.0;
/// Points beside the scroll bar of the side panel.
const BESIDE_BAR: i8 = 8;

/// Shows everything. Returns the width of the side panel, points: the picture lies beside it.
pub fn show(ui: &mut Ui, session: &mut Session, status: &Status) -> f32 {
    look::apply(ui, session);
    session.take_component();
    let mut width = 0.0;
    if session.has_panels {
        let side = egui::Panel::right("side").resizable(true).default_size(WIDTH).show(ui, |ui| {
            // It stays in sight, wherever the rest is scrolled to; and without a margin of its own, which would make the side wider, and the picture
            // another one, whenever a voxel is under the cursor.
            if let Some((picked, is_picked)) = picked::seen(session) {
                egui::Panel::bottom("voxel").resizable(false).frame(Frame::NONE).show(ui, |ui| {
                    picked::picked(ui, session, &picked, is_picked);
                });
            }
            ScrollArea::vertical().auto_shrink([false, true]).show(ui, |ui| {
                // Texts end before the bar that scrolls.
                Frame::NONE.inner_margin(Margin { right: BESIDE_BAR, ..Margin::ZERO }).show(ui, |ui| {
                    sections(ui, session, status);
                });
            });
        });
        width = side.response.rect.width();
    }
    session.below = timeline::timeline(ui, session);
    clipping::drawn(ui, session, width);
    measuring::drawn(ui, session, width);
    edit_preview::preview(ui, session, width);
    comparison::divider(ui, session, width);
    if session.open.is_none() && session.loading.is_none() && session.dialog.is_none() {
        welcome::welcome(ui, session, status, width);
    }
    dialogs::show(ui, session, status, width);
    unsaved::show(ui, session, width);
    // One above the other, and what is said above all of them.
    let mut below = session.below;
    below += dialogs::exporting(ui, session, width, below);
    below += messages::loading(ui, session, width, below);
    below += running::running(ui, session, width, below);
    messages::messages(ui, session, width, below);
    times::times(ui, session, status);
    if session.has_help {
        help::help(ui, session);
    }
    width
}

/// Where the picture lies: beside the side panel, of `side` points, and above the timeline.
fn picture(ui: &Ui, session: &Session, side: f32) -> Rect {
    let window = ui.ctx().content_rect();
    Rect::from_min_size(window.min, (window.size() - vec2(side, session.below)).max(vec2(1.0, 1.0)))
}

/// All sections of the side panel.
fn sections(ui: &mut Ui, session: &mut Session, status: &Status) {
    scene::scene(ui, session);
    if session.open.is_some() {
        editing::begin(ui, session);
        editing::editing(ui, session);
    }
    view::view(ui, session);
    lens::lens(ui, session);
    light::light(ui, session);
    if session.open.is_some() {
        heading(ui, tr!("panels.contents"));
        values::values(ui, session);
        points::points(ui, session);
        measuring::measuring(ui, session);
        parts::parts(ui, session);
        cuts::cuts(ui, session);
        surroundings::surroundings(ui, session);
        lines::lines(ui, session);
        materials::materials(ui, session);
    }
    tracing::tracing(ui, session, status);
    comparison::comparison(ui, session, status);
    statistics::statistics(ui, session, status);
    benchmark::benchmark(ui, session);
    look::look(ui, session);
}

/// A slider for a value that a scene or a key may have set beyond its ends, and that stays so until somebody moves it.
fn slider<'a, N: egui::emath::Numeric>(value: &'a mut N, range: std::ops::RangeInclusive<N>, name: &str) -> Slider<'a> {
    Slider::new(value, range).text(name).clamping(SliderClamping::Edits)
}

/// Says to screen readers what something is that has no text of its own.
fn name_node(ui: &Ui, response: &egui::Response, name: &str) {
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
}

/// A section that opens. Sliders in it are shorter by its indent, so that it is as wide as what it lies in: panels that became wider would make the
/// picture another one.
fn section(ui: &mut Ui, title: impl Into<egui::WidgetText>, id: &str, add: impl FnOnce(&mut Ui)) {
    CollapsingHeader::new(title).id_salt(id).show(ui, |ui| {
        ui.spacing_mut().slider_width -= ui.spacing().indent;
        add(ui);
    });
}

/// A window about something that is under way, in the middle of what the side panel leaves of the width, so many points above the lower edge. Returns how
/// high it is with the gap below it, points.
fn under_way(ui: &Ui, title: &str, side: f32, below: f32, add: impl FnOnce(&mut Ui)) -> f32 {
    let window = egui::Window::new(title)
        .anchor(Align2::CENTER_BOTTOM, [-side / 2.0, -GAP - below])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), add);
    window.map_or(0.0, |window| GAP + window.response.rect.height())
}

/// What is in a window over the picture, scrolled where it is higher than all of it.
fn in_sight(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    let most = (ui.ctx().content_rect().height() - TITLE).max(0.0);
    ScrollArea::vertical().max_height(most).show(ui, add);
}

/// Begins another line of a row that wraps where so many points and a text do not fit into this one: what is a row in itself does not wrap.
fn fit(ui: &mut Ui, points: f32, text: &str) {
    if ui.available_size_before_wrap().x < points + text_width(ui, text) + 2.0 * ui.spacing().item_spacing.x {
        ui.end_row();
    }
}

/// Points of a text in one line.
fn text_width(ui: &Ui, text: &str) -> f32 {
    let font = TextStyle::Body.resolve(ui.style());
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE).size().x
}

/// A button that stops something, and the key that does. Returns whether it was clicked.
fn stop_button(ui: &mut Ui, text: &str) -> bool {
    ui.horizontal(|ui| {
        let is_clicked = ui.button(text).clicked();
        let key = crate::keys::key_of(crate::keys::Action::Cancel);
        ui.label(RichText::new(tr!("panels.key_stops", key = key)).weak());
        is_clicked
    })
    .inner
}

fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(text).strong());
}

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Noun {
    Voxel,
    Object,
    Model,
    Material,
    Ray,
    Sample,
    Pixel,
    Point,
    Label,
}

impl Noun {
    /// The word of one, and that of several.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Voxel => [tr!("count.voxel"), tr!("count.voxels")],
            Self::Object => [tr!("count.object"), tr!("count.objects")],
            Self::Model => [tr!("count.model"), tr!("count.models")],
            Self::Material => [tr!("count.material"), tr!("count.materials")],
            Self::Ray => [tr!("count.ray"), tr!("count.rays")],
            Self::Sample => [tr!("count.sample"), tr!("count.samples")],
            Self::Pixel => [tr!("count.pixel"), tr!("count.pixels")],
            Self::Point => [tr!("count.point"), tr!("count.points")],
            Self::Label => [tr!("count.label"), tr!("count.labels")],
        }
    }
}

/// A number in groups of three digits, as people write it.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let starts_group = |index: usize| index > 0 && (digits.len() - index).is_multiple_of(3);
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if starts_group(index) {
            text.push_str(tr!("count.thousands"));
        }
        text.push(digit);
    }
    text
}

/// A number with its noun: "1 object", "13,600,000 voxels".
pub(crate) fn counted(number: u64, noun: Noun) -> String {
    let [one, several] = noun.words();
    format!("{} {}", grouped(number), if number == 1 { one } else { several })
}
