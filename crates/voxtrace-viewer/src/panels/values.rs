//! The panel of a volume's values: how often each occurs, which are shown in which colours, presets, and the window that is dragged in the picture.

use super::{Noun, counted, name_node, section};
use crate::keys::Action;
use crate::session::{Command, Session};
use crate::tr;
use crate::transfer::{ValueCurve, ValuesSeen};
use egui::{Align2, Color32, ComboBox, DragValue, FontId, Pos2, Rect, RichText, Sense, Shape, Stroke, Ui, Vec2};
use voxtrace::volume::Preset;

/// Points of the histogram, of the strip of colours below it, and half a handle.
const HEIGHT: f32 = 92.0;
const STRIP: f32 = 14.0;
const HANDLE: f32 = 6.0;
/// The shares of values between which the histogram is drawn, where that is a part of all.
const SHARES: (f64, f64) = (0.0005, 0.9995);
const BARS: Color32 = Color32::from_rgb(120, 132, 148);
const ENDS: Color32 = Color32::from_rgb(255, 110, 96);
const SELECTED: Color32 = Color32::from_rgb(255, 196, 84);

pub fn values(ui: &mut Ui, session: &mut Session) {
    let Some(values) = &session.values else { return };
    let seen = std::sync::Arc::clone(&values.seen);
    let title = if values.chosen.is_some() { tr!("values.title_changed") } else { tr!("values.title") };
    section(ui, title, "values", |ui| match session.values.as_ref().and_then(|values| values.curve()) {
        Some(curve) => edit(ui, session, &seen, curve),
        None => {
            let labels = seen.statistics.labels.as_ref().map_or(0, Vec::len) as u64;
            ui.label(tr!("values.labels", labels = counted(labels, Noun::Label)));
            presets(ui, session, &seen);
        }
    });
}

fn edit(ui: &mut Ui, session: &mut Session, seen: &ValuesSeen, old: ValueCurve) {
    let mut curve = old.clone();
    presets(ui, session, seen);
    plot(ui, session, seen, &mut curve);
    let (least, most) = seen.range();
    let speed = f64::from((most - least).max(f32::MIN_POSITIVE)) / 500.0;
    ui.horizontal(|ui| {
        let (from, to) = curve.window();
        let (mut window, mut level) = (to - from, (from + to) / 2.0);
        let label = ui.label(tr!("values.window"));
        let mut is_changed = ui.add(number(&mut window, speed)).labelled_by(label.id).changed();
        let label = ui.label(tr!("values.level"));
        is_changed |= ui.add(number(&mut level, speed)).labelled_by(label.id).changed();
        if is_changed {
            curve.set_window((level - window / 2.0, level + window / 2.0), (least, most));
        }
    });
    ui.horizontal(|ui| {
        let label = ui.label(tr!("values.shown_from"));
        ui.add(number(&mut curve.low, speed)).labelled_by(label.id);
        let mut has_end = curve.high.is_some();
        if ui.checkbox(&mut has_end, tr!("values.to")).changed() {
            curve.high = has_end.then_some(most);
        }
        if let Some(high) = &mut curve.high {
            ui.add(number(high, speed));
        }
    });
    ui.add(super::slider(&mut curve.opacity, 0.0..=1.0, tr!("values.opacity")).max_decimals(2));
    stop(ui, session, &mut curve, speed);
    let mut is_dragged = session.drags_values();
    let about = tr!("values.drag_about");
    if ui.checkbox(&mut is_dragged, tr!("values.drag")).on_hover_text(about).changed() {
        session.act(Action::Values, None);
    }
    told(ui, session, seen, &curve);
    if curve != old {
        session.set_curve(Some(curve));
    }
}

fn number(value: &mut f32, speed: f64) -> DragValue<'_> {
    DragValue::new(value).speed(speed).max_decimals(if speed > 0.01 { 2 } else { 6 })
}

/// Curves that are chosen at once.
fn presets(ui: &mut Ui, session: &mut Session, seen: &ValuesSeen) {
    // Curves that are chosen are rounded.
    let rounded = |curve: ValueCurve| curve.rounded(seen.range());
    let now = session.values.as_ref().and_then(|values| values.curve()).map(rounded);
    let shown = Preset::ALL.into_iter().find(|&preset| now.is_some() && seen.preset(preset).map(rounded) == now);
    let name = shown.map_or(tr!("values.choose"), Preset::name);
    ui.horizontal_wrapped(|ui| {
        ComboBox::from_label(tr!("values.preset")).selected_text(name).show_ui(ui, |ui| {
            for preset in Preset::ALL {
                if let Some(curve) = seen.preset(preset)
                    && ui.selectable_label(shown == Some(preset), preset.name()).clicked()
                {
                    session.set_curve(Some(curve));
                }
            }
        });
        let about = tr!("values.automatic_about");
        if ui.button(tr!("values.automatic")).on_hover_text(about).clicked() {
            session.set_curve(Some(seen.automatic()));
        }
        if ui.button(tr!("values.reset")).on_hover_text(tr!("values.reset_about")).clicked() {
            if let Some(values) = &mut session.values {
                values.selected = None;
            }
            session.set_curve(None);
        }
    });
}

/// The stop that was clicked: its value and colour.
fn stop(ui: &mut Ui, session: &mut Session, curve: &mut ValueCurve, speed: f64) {
    let Some(values) = &mut session.values else { return };
    let Some(index) = values.selected.filter(|&index| index < curve.stops.len()) else {
        ui.label(RichText::new(tr!("values.stop_hint")).weak());
        return;
    };
    ui.horizontal(|ui| {
        let (mut value, mut color) = curve.stops[index];
        let label = ui.label(tr!("values.stop"));
        if ui.add(number(&mut value, speed)).labelled_by(label.id).changed() {
            curve.move_stop(index, value);
        }
        let response = ui.color_edit_button_srgb(&mut color);
        name_node(ui, &response, tr!("values.stop_colour"));
        curve.stops[index].1 = color;
        if curve.stops.len() > 1 && ui.button(tr!("values.delete_stop")).clicked() {
            curve.stops.remove(index);
            values.selected = None;
        }
    });
}

/// What is being made, and what is in the way.
fn told(ui: &mut Ui, session: &mut Session, seen: &ValuesSeen, curve: &ValueCurve) {
    let Some(values) = &session.values else { return };
    if !curve.shows(seen.range()) {
        ui.label(RichText::new(tr!("values.none_shown")).color(super::look::error_color(ui)));
    } else if let Some(error) = &values.error {
        ui.label(RichText::new(error).color(super::look::error_color(ui)));
    }
    let text = match (values.is_shaping(), values.took) {
        (true, _) => tr!("values.making", key = crate::keys::key_of(Action::Cancel)),
        (false, _) if values.is_left_coarse => {
            if ui.button(tr!("values.make_all")).on_hover_text(tr!("values.are_coarse")).clicked() {
                session.ask(Command::Reshape);
            }
            return;
        }
        (false, [Some(coarse), Some(all)]) => {
            tr!("values.took", coarse = format!("{coarse:.2}"), all = format!("{all:.2}"))
        }
        _ => return,
    };
    ui.label(RichText::new(text).weak());
}

/// Where values are in the histogram.
#[derive(Clone, Copy)]
struct Scale {
    rect: Rect,
    from: f32,
    to: f32,
}

impl Scale {
    fn x(self, value: f32) -> f32 {
        let share = (value - self.from) / (self.to - self.from).max(f32::MIN_POSITIVE);
        self.rect.left() + share.clamp(0.0, 1.0) * self.rect.width()
    }

    fn value(self, x: f32) -> f32 {
        self.from + ((x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0) * (self.to - self.from)
    }
}

fn plot(ui: &mut Ui, session: &mut Session, seen: &ValuesSeen, curve: &mut ValueCurve) {
    let size = Vec2::new(ui.available_width().min(super::WIDTH - 24.0), HEIGHT + STRIP);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    name_node(ui, &response, tr!("values.values"));
    // A few far values must not press all others into one bar; what is shown is seen in any case.
    let (least, most) = seen.range();
    let (first, last) = (curve.window().0.min(curve.low), curve.window().1.max(curve.high.unwrap_or(f32::MIN)));
    let from = seen.quantile(SHARES.0).min(first).max(least);
    let to = seen.quantile(SHARES.1).max(last).min(most);
    let (from, to) = if to > from { (from, to) } else { (least, most.max(least + 1.0)) };
    let scale = Scale { rect: rect.shrink2(Vec2::new(HANDLE, 0.0)), from, to };
    bars(ui, scale, seen, curve);
    if let Some(place) = response.interact_pointer_pos().filter(|_| response.double_clicked()) {
        let index = curve.add_stop(scale.value(place.x));
        select(session, Some(index));
    }
    let low = end(ui, scale, tr!("values.least"), curve.low);
    curve.low = low.unwrap_or(curve.low);
    if let Some(high) = curve.high {
        curve.high = Some(end(ui, scale, tr!("values.greatest"), high).unwrap_or(high));
    }
    stops(ui, session, scale, curve);
}

/// The histogram, its bars as high as the logarithm of what they count, and the colours below.
fn bars(ui: &Ui, scale: Scale, seen: &ValuesSeen, curve: &ValueCurve) {
    let painter = ui.painter();
    let rect = scale.rect;
    painter.rect_filled(rect, 2.0, ui.visuals().extreme_bg_color);
    let columns = rect.width().max(1.0) as usize;
    let (least, most) = seen.range();
    let bins = seen.histogram.len().max(1);
    let bin = |value: f32| {
        let share = (value - least) / (most - least).max(f32::MIN_POSITIVE);
        ((share.clamp(0.0, 1.0) * bins as f32) as usize).min(bins - 1)
    };
    let edge = |column: usize| scale.from + (scale.to - scale.from) * column as f32 / columns as f32;
    let count = |column: usize| {
        let (from, to) = (bin(edge(column)), bin(edge(column + 1)));
        seen.histogram.get(from..=to.max(from)).unwrap_or(&[]).iter().copied().max().unwrap_or(0)
    };
    let logs: Vec<f32> = (0..columns).map(|column| (count(column) as f32 + 1.0).ln()).collect();
    let highest = logs.iter().copied().fold(1.0, f32::max);
    let floor = rect.top() + HEIGHT;
    for (column, log) in logs.iter().enumerate() {
        let value = edge(column);
        let is_shown = value >= curve.low && curve.high.is_none_or(|high| value <= high);
        let x = rect.left() + column as f32 + 0.5;
        let color = if is_shown { BARS } else { BARS.gamma_multiply(0.35) };
        let top = floor - log / highest * (HEIGHT - 12.0);
        painter.line_segment([Pos2::new(x, floor), Pos2::new(x, top)], Stroke::new(1.0, color));
        let [r, g, b] = curve.color_at(value);
        let color = if is_shown { Color32::from_rgb(r, g, b) } else { Color32::from_black_alpha(120) };
        painter.line_segment([Pos2::new(x, floor), Pos2::new(x, floor + STRIP)], Stroke::new(1.0, color));
    }
    let weak = ui.visuals().weak_text_color();
    let font = FontId::proportional(10.0);
    painter.text(rect.left_top(), Align2::LEFT_TOP, rounded(scale.from), font.clone(), weak);
    painter.text(rect.right_top(), Align2::RIGHT_TOP, rounded(scale.to), font, weak);
}

fn rounded(value: f32) -> String {
    if value.abs() >= 100.0 { format!("{value:.0}") } else { format!("{value:.3}") }
}

/// A line at an end of what is shown. Returns where it was dragged to.
fn end(ui: &Ui, scale: Scale, name: &str, value: f32) -> Option<f32> {
    let x = scale.x(value);
    let place = Rect::from_x_y_ranges(x - 4.0..=x + 4.0, scale.rect.top()..=scale.rect.top() + HEIGHT - 2.0 * HANDLE);
    let response = ui.interact(place, ui.id().with(name), Sense::drag());
    name_node(ui, &response, name);
    let stroke = Stroke::new(if response.hovered() { 3.0 } else { 1.5 }, ENDS);
    ui.painter().line_segment([Pos2::new(x, place.top()), Pos2::new(x, place.bottom() + 2.0 * HANDLE)], stroke);
    response.interact_pointer_pos().filter(|_| response.dragged()).map(|place| scale.value(place.x))
}

/// The stops: a click selects one, a drag moves it.
fn stops(ui: &Ui, session: &mut Session, scale: Scale, curve: &mut ValueCurve) {
    let y = scale.rect.top() + HEIGHT;
    for index in 0..curve.stops.len() {
        let (value, [r, g, b]) = curve.stops[index];
        let middle = Pos2::new(scale.x(value), y);
        let response = ui.interact(
            Rect::from_center_size(middle, Vec2::splat(2.0 * HANDLE)),
            ui.id().with(("stop", index)),
            Sense::click_and_drag(),
        );
        name_node(ui, &response, &tr!("values.stop_at", number = index + 1, value = rounded(value)));
        let is_selected = session.values.as_ref().is_some_and(|values| values.selected == Some(index));
        let edge = if is_selected || response.hovered() { SELECTED } else { Color32::WHITE };
        ui.painter().add(Shape::circle_filled(middle, HANDLE, Color32::from_rgb(r, g, b)));
        ui.painter().add(Shape::circle_stroke(middle, HANDLE, Stroke::new(1.5, edge)));
        if response.clicked() || response.drag_started() {
            select(session, Some(index));
        }
        if let Some(place) = response.interact_pointer_pos().filter(|_| response.dragged()) {
            curve.move_stop(index, scale.value(place.x));
        }
    }
}

fn select(session: &mut Session, index: Option<usize>) {
    if let Some(values) = &mut session.values {
        values.selected = index;
    }
}
