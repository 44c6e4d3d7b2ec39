//! The timeline below the picture: an axis of time with the camera's keys and the playhead, and what can be done with them.

use super::{fit, name_node, slider};
use crate::keys::{Action, key_of};
use crate::session::Session;
use crate::timeline::{Course, MOST_FRAMES, Timeline};
use crate::tr;
use egui::{
    Align2, Button, Color32, ComboBox, DragValue, FontId, Id, Pos2, Rect, ScrollArea, Sense, Shape, Stroke, Ui, Vec2,
};
use voxtrace::animation::Ease;

/// Points of the axis, and between it and the panel's sides.
const AXIS: f32 = 46.0;
const MARGIN: f32 = 12.0;
/// Points of the slider.
const SLIDER: f32 = 60.0;
/// Points of the numbers on the axis, and from there to the tip of the playhead.
const NUMBERS: f32 = 13.0;
const TIP: f32 = 7.0;
/// Half of a key, points.
const KEY: f32 = 7.0;
/// Least points between two numbers on the axis.
const BETWEEN: f32 = 64.0;
/// Points of the window's height that the picture keeps at least.
const ABOVE: f32 = 110.0;
const SELECTED: Color32 = Color32::from_rgb(255, 196, 84);
const PLAYHEAD: Color32 = Color32::from_rgb(255, 110, 96);

/// Shows it below the picture. Returns how high it is, points.
pub fn timeline(ui: &mut Ui, session: &mut Session) -> f32 {
    if !session.timeline.is_shown || session.open.is_none() {
        end_drag(ui, session);
        return 0.0;
    }
    // Where its rows are too many for a small window they are scrolled.
    let most = (ui.ctx().content_rect().height() - ABOVE).max(AXIS);
    let panel = egui::Panel::bottom("timeline").resizable(false).show(ui, |ui| {
        let scrolled = ScrollArea::vertical().max_height(most).min_scrolled_height(most).auto_shrink([false, true]);
        scrolled.show(ui, |ui| {
            ui.horizontal_wrapped(|ui| buttons(ui, session));
            axis(ui, session);
            ui.horizontal_wrapped(|ui| settings(ui, session));
        });
    });
    panel.response.rect.height()
}

fn buttons(ui: &mut Ui, session: &mut Session) {
    let is_playing = session.timeline.is_playing();
    if ui
        .button(if is_playing { tr!("timeline.stop") } else { tr!("timeline.play") })
        .on_hover_text(tr!("timeline.space"))
        .clicked()
    {
        session.act(Action::Play, None);
    }
    let mut repeats = session.timeline.repeats;
    if ui.checkbox(&mut repeats, tr!("timeline.loop")).changed() {
        session.timeline.repeats = repeats;
    }
    let course = &session.timeline.course;
    let (mut frame, frames, fps) = (session.timeline.frame(), course.frames(), course.fps);
    let label = ui.label(tr!("timeline.frame"));
    if ui.add(DragValue::new(&mut frame).range(1..=frames).update_while_editing(false)).labelled_by(label.id).changed()
    {
        session.set_time_frame(frame);
    }
    ui.label(tr!("timeline.of", frames = frames, seconds = format!("{:.2}", f64::from(frame - 1) / fps)));
    ui.separator();
    if ui.button(tr!("timeline.set")).on_hover_text(tr!("timeline.set_about")).clicked() {
        session.add_time_key();
    }
    let has_key = session.timeline.selected.is_some_and(|index| index < session.timeline.course.keys.len());
    let about = tr!("timeline.replace_about");
    if ui.add_enabled(has_key, Button::new(tr!("timeline.replace"))).on_hover_text(about).clicked() {
        session.replace_time_key();
    }
    if ui
        .add_enabled(has_key, Button::new(tr!("timeline.delete")))
        .on_hover_text(tr!("timeline.delete_about"))
        .clicked()
    {
        session.delete_time_key();
    }
    let about = tr!("timeline.bookmarks_about");
    if ui.button(tr!("timeline.bookmarks")).on_hover_text(about).clicked() {
        session.take_bookmarks();
    }
    if ui.add_enabled(session.timeline.can_undo(), Button::new(tr!("timeline.undo"))).clicked() {
        session.undo_time();
    }
    ui.separator();
    let path = session.timeline_path().map_or(String::new(), |path| path.display().to_string());
    let name = if session.timeline.is_changed { tr!("timeline.save_changed") } else { tr!("timeline.save") };
    if ui.button(name).on_hover_text(path).clicked()
        && let Some(path) = session.save_timeline()
    {
        session.say(tr!("timeline.kept", path = path.display()), false);
    }
    if ui.button(tr!("timeline.record")).on_hover_text(key_of(Action::Record)).clicked() {
        session.act(Action::Record, None);
    }
    if ui.button(tr!("timeline.close")).on_hover_text(key_of(Action::Timeline)).clicked() {
        session.toggle_timeline();
    }
}

fn settings(ui: &mut Ui, session: &mut Session) {
    let mut course = session.timeline.course.clone();
    let label = ui.label(tr!("timeline.seconds"));
    let most = f64::from(MOST_FRAMES) / course.fps;
    ui.add(
        DragValue::new(&mut course.seconds)
            .range(1.0 / course.fps..=most)
            .clamp_existing_to_range(false)
            .speed(0.05)
            .max_decimals(3)
            // On the way to 0.5 there is 0: a clip of one frame.
            .update_while_editing(false),
    )
    .labelled_by(label.id);
    let label = ui.label(tr!("timeline.rate"));
    let fps = DragValue::new(&mut course.fps).range(1.0..=1000.0).clamp_existing_to_range(false);
    ui.add(fps.speed(0.5).max_decimals(3).update_while_editing(false)).labelled_by(label.id);
    let word = |ease: Ease| match ease {
        Ease::None => tr!("timeline.ease_none"),
        Ease::In => tr!("timeline.ease_in"),
        Ease::Out => tr!("timeline.ease_out"),
        Ease::InOut => tr!("timeline.ease_both"),
    };
    fit(ui, ui.spacing().combo_width, tr!("timeline.ease"));
    ComboBox::from_label(tr!("timeline.ease")).selected_text(word(course.ease)).show_ui(ui, |ui| {
        for (_, ease) in Timeline::EASES {
            ui.selectable_value(&mut course.ease, ease, word(ease));
        }
    });
    let mut shutter = course.shutter as f32;
    ui.spacing_mut().slider_width = SLIDER;
    fit(ui, SLIDER + ui.spacing().interact_size.x, tr!("timeline.blur"));
    if ui.add(slider(&mut shutter, 0.0..=1.0, tr!("timeline.blur")).max_decimals(2)).changed() {
        // Two decimals, so that the file has no 0.30000001.
        course.shutter = (f64::from(shutter) * 100.0).round() / 100.0;
    }
    ui.checkbox(&mut course.focuses_on_target, tr!("timeline.focus"));
    let mut has_target = course.look_at.is_some();
    let about = tr!("timeline.look_at_about");
    let is_asked = ui.checkbox(&mut has_target, tr!("timeline.look_at")).on_hover_text(about).changed();
    if course != session.timeline.course {
        session.edit_time(|own| *own = course);
    }
    if is_asked {
        session.set_time_target(has_target);
        session.edit_time(|_| ());
    }
}

/// Where times are on the axis.
#[derive(Clone, Copy)]
struct Scale {
    left: f32,
    width: f32,
    seconds: f64,
}

impl Scale {
    fn x(self, seconds: f64) -> f32 {
        self.left + (seconds / self.seconds) as f32 * self.width
    }

    fn seconds(self, x: f32) -> f64 {
        f64::from((x - self.left) / self.width) * self.seconds
    }
}

fn axis(ui: &mut Ui, session: &mut Session) {
    let size = Vec2::new(ui.available_width(), AXIS);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    name_node(ui, &response, tr!("timeline.time"));
    // The last key may lie behind the end of the clip.
    let course = &session.timeline.course;
    let seconds = course.keys.last().map_or(course.seconds, |key| key.at.max(course.seconds)).max(1e-3);
    let scale = Scale { left: rect.left() + MARGIN, width: (rect.width() - 2.0 * MARGIN).max(1.0), seconds };
    paint(ui, rect, scale, course);
    keys(ui, session, rect, scale);
    // What lies over a key is the key's.
    if (response.dragged() || response.clicked())
        && let Some(place) = response.interact_pointer_pos()
    {
        let course = &session.timeline.course;
        let frame = course.frame_at(scale.seconds(place.x).max(0.0));
        if frame != session.timeline.frame() || session.timeline.is_playing() {
            session.set_time_frame(frame);
        }
    }
    let x = scale.x(session.timeline.course.time_of(session.timeline.frame()));
    let painter = ui.painter();
    let top = rect.top() + NUMBERS;
    painter.line_segment([Pos2::new(x, top), Pos2::new(x, rect.bottom())], Stroke::new(1.5, PLAYHEAD));
    let head = vec![Pos2::new(x - 5.0, top), Pos2::new(x + 5.0, top), Pos2::new(x, top + TIP)];
    painter.add(Shape::convex_polygon(head, PLAYHEAD, Stroke::NONE));
}

/// The axis with its numbers, and what lies behind the end of the clip darker.
fn paint(ui: &Ui, rect: Rect, scale: Scale, course: &Course) {
    let (painter, visuals) = (ui.painter(), ui.visuals());
    painter.rect_filled(rect, 3.0, visuals.extreme_bg_color);
    let end = scale.x(course.seconds);
    let clip = Rect::from_x_y_ranges(scale.left..=end, rect.top() + 16.0..=rect.bottom());
    painter.rect_filled(clip, 0.0, visuals.faint_bg_color);
    let step = step_of(scale.seconds * f64::from(BETWEEN / scale.width));
    let weak = visuals.weak_text_color();
    // A file may name times beyond which there are no numbers.
    let times = (0..).map(|tick: u32| f64::from(tick) * step).take_while(|time| 0.9999 * time <= scale.seconds);
    for time in times {
        let x = scale.x(time);
        let (from, to) = (rect.top() + NUMBERS, rect.bottom());
        painter.line_segment([Pos2::new(x, from), Pos2::new(x, to)], Stroke::new(0.5, weak));
        let text = format!("{} s", (time * 1000.0).round() / 1000.0);
        painter.text(Pos2::new(x, rect.top() + 6.0), Align2::CENTER_CENTER, text, FontId::proportional(10.0), weak);
    }
}

/// The least of 1, 2, 5 times a power of ten that is at least so much.
fn step_of(least: f64) -> f64 {
    let power = 10f64.powf(least.max(1e-6).log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|factor| factor * power).find(|&step| step >= least).unwrap_or(10.0 * power)
}

/// The keys: a click goes to one, a drag moves it in time.
fn keys(ui: &mut Ui, session: &mut Session, rect: Rect, scale: Scale) {
    let y = rect.top() + 16.0 + (rect.height() - 16.0) / 2.0;
    let times: Vec<f64> = session.timeline.course.keys.iter().map(|key| key.at).collect();
    for (index, &at) in times.iter().enumerate() {
        let middle = Pos2::new(scale.x(at), y);
        let place = Rect::from_center_size(middle, Vec2::splat(2.0 * KEY));
        let response = ui.interact(place, ui.id().with(("key", index)), Sense::click_and_drag());
        name_node(ui, &response, &tr!("timeline.key_at", number = index + 1, at = format!("{at:.2}")));
        let is_selected = session.timeline.selected == Some(index);
        let color = match (is_selected, response.hovered()) {
            (true, _) => SELECTED,
            (false, true) => ui.visuals().strong_text_color(),
            (false, false) => ui.visuals().text_color(),
        };
        let [x, half] = [middle.x, KEY - 1.0];
        let points =
            vec![Pos2::new(x, y - half), Pos2::new(x + half, y), Pos2::new(x, y + half), Pos2::new(x - half, y)];
        ui.painter().add(Shape::convex_polygon(points, color, Stroke::new(1.0, Color32::BLACK)));
        if response.clicked() {
            session.go_to_time_key(index);
        }
        if response.drag_started() {
            let before = session.timeline.course.clone();
            let drag = Drag { index, shown: before.clone(), before };
            ui.data_mut(|data| data.insert_temp(drag_id(), drag));
            session.timeline.selected = Some(index);
        }
    }
    drag(ui, session, scale);
}

/// A key that is dragged.
#[derive(Clone, Default)]
struct Drag {
    index: usize,
    before: Course,
    /// What the last frame made of it.
    shown: Course,
}

fn drag_id() -> Id {
    Id::new("moved key of the timeline")
}

/// The key that is dragged goes with the cursor, past others too; where it is let go, that is one change.
fn drag(ui: &Ui, session: &mut Session, scale: Scale) {
    let Some(mut drag) = ui.data(|data| data.get_temp::<Drag>(drag_id())) else { return };
    if drag.shown != session.timeline.course {
        // Another scene has come with its own timeline, or a key took back what was done.
        return ui.data_mut(|data| data.remove::<Drag>(drag_id()));
    }
    let (place, is_down) = ui.input(|input| (input.pointer.interact_pos(), input.pointer.any_down()));
    if let Some(place) = place {
        let mut course = drag.before.clone();
        let frame = course.frame_at(scale.seconds(place.x).max(0.0));
        session.timeline.selected = Some(course.shift(drag.index, frame));
        drag.shown.clone_from(&course);
        session.timeline.course = course;
        ui.data_mut(|data| data.insert_temp(drag_id(), drag));
    }
    if !is_down {
        end_drag(ui, session);
    }
}

/// Ends the drag of a key, where there is one: also where the timeline is hidden meanwhile.
fn end_drag(ui: &Ui, session: &mut Session) {
    let Some(Drag { before, shown, .. }) = ui.data_mut(|data| data.remove_temp::<Drag>(drag_id())) else { return };
    if shown == session.timeline.course {
        session.timeline.note(before);
        session.edit_time(|_| ());
    }
}

#[cfg(test)]
mod tests {
    use super::step_of;

    #[test]
    fn numbers_on_the_axis_are_round() {
        assert_eq!([0.07, 0.2, 0.21, 3.0, 11.0, 40.0].map(step_of), [0.1, 0.2, 0.5, 5.0, 20.0, 50.0]);
    }
}
