//! From events of a window system, as plain values, to what they mean: keys to actions, drags and wheels to motions. Places are those
//! of the picture, pixels.

use crate::clipping::Grabbed;
use crate::keys::{self, Action, Chord, EditAction, Gesture, Key, Modifiers, Steer};
use crate::navigation::Motion;
use crate::session::Session;
use voxtrace::glam::{Vec2, Vec3};

/// Pixels that the mouse may move between press and release of a click.
const CLICK: f32 = 4.0;
/// Pixels of a trackpad that are one step of zoom or speed.
const PIXELS_A_STEP: f32 = 40.0;

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The left one.
    Left,
    /// The wheel.
    Middle,
    /// The right one.
    Right,
}

/// A drag under way.
struct Drag {
    button: Button,
    steer: Option<Steer>,
    from: Vec2,
    /// What was under the cursor when it began.
    anchor: Option<Vec3>,
    is_click: bool,
    /// Whether it is the divider of two pictures that is dragged.
    is_divider: bool,
    /// Whether it edits.
    is_edit: bool,
    /// The handle that is dragged.
    grabbed: Option<Grabbed>,
    /// Whether it changes which values are shown.
    is_of_values: bool,
}

/// What the mouse and the keyboard are doing.
#[derive(Default)]
pub struct Input {
    cursor: Option<Vec2>,
    modifiers: Modifiers,
    drag: Option<Drag>,
}

impl Input {
    /// Where the cursor is, if it is in the window.
    pub fn cursor(&self) -> Option<Vec2> {
        self.cursor
    }

    /// Whether a button is held that was pressed over the picture.
    pub fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// What is held beside keys changed.
    pub fn set_modifiers(&mut self, modifiers: Modifiers, session: &mut Session) {
        self.modifiers = modifiers;
        (session.navigator.held.is_fast, session.navigator.held.is_slow) = (modifiers.shift, modifiers.ctrl);
    }

    /// A key is pressed or let go.
    pub fn key(&mut self, key: Key, is_pressed: bool, is_repeat: bool, session: &mut Session) {
        let is_flying = session.navigator.held.is_moving() || self.drag.as_ref().is_some_and(|drag| !drag.is_click);
        let chord = Chord { key, modifiers: self.modifiers };
        if !is_pressed {
            // Whatever was held beside it when it was pressed.
            if let Some(Action::Move(movement)) = keys::action_of(Chord { key, modifiers: Modifiers::NONE }, true) {
                session.navigator.held.set(movement, false);
            }
            return;
        }
        let edit = if session.is_editing() { keys::edit_action_of(chord, is_flying) } else { None };
        match edit.or_else(|| keys::action_of(chord, is_flying)) {
            Some(Action::Move(movement)) => session.navigator.held.set(movement, true),
            Some(action) if !is_repeat || may_repeat(action) => session.act(action, self.cursor),
            _ => {}
        }
    }

    /// The window lost the keyboard.
    pub fn lose_focus(&mut self, session: &mut Session) {
        self.modifiers = Modifiers::NONE;
        session.navigator.held.clear();
        self.abandon(session);
    }

    /// The cursor left the window.
    pub fn leave(&mut self, session: &mut Session) {
        session.hover = None;
        if self.drag.is_none() {
            self.cursor = None;
        }
    }

    /// The cursor moved.
    pub fn move_to(&mut self, cursor: Vec2, session: &mut Session) {
        let last = self.cursor.replace(cursor);
        session.hover = self.drag.is_none().then_some(cursor);
        let (Some(drag), Some(last)) = (&mut self.drag, last) else { return };
        if drag.is_edit {
            return session.edit_drag(cursor);
        }
        if drag.is_divider {
            return session.move_divider((cursor.x - last.x) / session.size().0 as f32);
        }
        if drag.is_click && (cursor - drag.from).abs().max_element() <= CLICK {
            return;
        }
        let last = if std::mem::take(&mut drag.is_click) { drag.from } else { last };
        if let Some(grabbed) = &drag.grabbed {
            return session.drag_handle(grabbed, cursor, self.modifiers.shift);
        }
        let delta = cursor - last;
        if drag.is_of_values {
            return session.drag_values(delta);
        }
        match drag.steer {
            Some(Steer::Look) => session.move_by(Motion::Look(delta)),
            Some(Steer::Orbit) => session.move_by(Motion::Orbit { delta, pivot: drag.anchor }),
            Some(Steer::Pan) => session.move_by(Motion::Pan { from: last, to: cursor, anchor: drag.anchor }),
            _ => {}
        }
    }

    /// A button is pressed over the picture.
    pub fn press(&mut self, button: Button, session: &mut Session) {
        let (Some(cursor), None) = (self.cursor, &self.drag) else { return };
        let gesture = match button {
            Button::Left => Gesture::LeftDrag,
            Button::Middle => Gesture::MiddleDrag,
            Button::Right => Gesture::RightDrag,
        };
        let is_divider = button == Button::Left && session.is_on_divider(cursor);
        let mode = session.navigator.mode;
        let edit = match session.is_editing() && !is_divider {
            true => keys::edit_action_of_gesture(gesture, self.modifiers, mode),
            false => None,
        };
        let is_edit = match edit {
            Some(Action::Edit(action)) => session.edit_press_as(action, cursor),
            _ => false,
        };
        let edit = edit.filter(|action| matches!(action, Action::Steer(_)));
        let steer = match edit.or_else(|| keys::action_of_gesture(gesture, self.modifiers, mode)) {
            Some(Action::Steer(steer)) => Some(steer),
            _ => None,
        };
        let grabbed = if button == Button::Left && !is_divider && !is_edit { session.grab(cursor) } else { None };
        let is_free = !is_divider && !is_edit && grabbed.is_none();
        let is_plain_left = button == Button::Left && self.modifiers == Modifiers::NONE;
        let is_of_values = is_free && is_plain_left && session.drags_values();
        let anchor = session.pick(cursor).map(|picked| picked.point);
        session.navigator.begin_gesture();
        let is_click = !is_divider && !is_edit;
        self.drag =
            Some(Drag { button, steer, from: cursor, anchor, is_click, is_divider, is_edit, grabbed, is_of_values });
    }

    /// A button is let go.
    pub fn release(&mut self, button: Button, session: &mut Session) {
        let Some(drag) = self.drag.take_if(|drag| drag.button == button) else { return };
        session.navigator.end_gesture();
        if drag.is_edit {
            session.hover = self.cursor;
            return session.edit_release();
        }
        session.let_go();
        if drag.is_click && button == Button::Left {
            self.gesture(Gesture::Click, session);
        }
    }

    /// The drag ends where it is, and is no click.
    pub fn abandon(&mut self, session: &mut Session) {
        if let Some(drag) = self.drag.take() {
            session.navigator.end_gesture();
            if drag.is_edit {
                session.drop_stroke();
            }
            session.let_go();
        }
    }

    /// Moves sideways, so that what was at one place comes to lie at the other.
    pub fn pan(&mut self, from: Vec2, to: Vec2, session: &mut Session) {
        if from != to {
            let anchor = session.pick(from).map(|picked| picked.point);
            session.move_by(Motion::Pan { from, to, anchor });
        }
    }

    /// Two fingers turned on the trackpad, counter-clockwise above 0, degrees: the view goes around what is under the cursor.
    pub fn rotate(&mut self, degrees: f32, session: &mut Session) {
        let Some(cursor) = self.cursor else { return };
        let pivot = session.pick(cursor).map(|picked| picked.point);
        // A drag over the whole height carries half around.
        let delta = Vec2::new(degrees / 180.0 * session.size().1 as f32, 0.0);
        session.move_by(Motion::Orbit { delta, pivot });
    }

    /// The second press of two clicks. Letting go is no click any more: something else lies under the cursor then.
    pub fn double_click(&mut self, session: &mut Session) {
        // Two clicks of a tool are two clicks.
        if session.is_editing() {
            return;
        }
        match self.drag.take() {
            Some(Drag { is_divider: true, .. } | Drag { grabbed: Some(_), .. }) => {
                session.let_go();
                return session.navigator.end_gesture();
            }
            Some(_) => session.navigator.end_gesture(),
            None => {}
        }
        self.gesture(Gesture::DoubleClick, session);
    }

    fn gesture(&self, gesture: Gesture, session: &mut Session) {
        if self.modifiers == Modifiers::NONE && session.measure_by(gesture, self.cursor) {
            return;
        }
        if let Some(action) = keys::action_of_gesture(gesture, self.modifiers, session.navigator.mode) {
            session.act(action, self.cursor);
        }
    }

    /// The wheel turned by so many notches, away from the user above 0.
    pub fn wheel(&mut self, notches: f32, session: &mut Session) {
        if self.drag.as_ref().is_some_and(|drag| drag.is_edit) && session.edit_wheel(notches) {
            return;
        }
        if session.is_editing()
            && keys::edit_action_of_gesture(Gesture::Wheel, self.modifiers, session.navigator.mode)
                == Some(Action::Edit(EditAction::Resize))
        {
            return session.resize_brush(notches);
        }
        let is_right = self.drag.as_ref().is_some_and(|drag| drag.button == Button::Right);
        let gesture = if is_right { Gesture::RightWheel } else { Gesture::Wheel };
        let modifiers = if is_right { Modifiers::NONE } else { self.modifiers };
        if let Some(Action::Steer(steer)) = keys::action_of_gesture(gesture, modifiers, session.navigator.mode) {
            self.step(steer, notches, session);
        }
    }

    /// Two fingers moved on the trackpad, pixels.
    pub fn scroll(&mut self, delta: Vec2, session: &mut Session) {
        let mode = session.navigator.mode;
        let Some(cursor) = self.cursor else { return };
        match keys::action_of_gesture(Gesture::TrackpadScroll, self.modifiers, mode) {
            Some(Action::Steer(Steer::Look)) => session.move_by(Motion::Look(delta)),
            Some(Action::Steer(Steer::Orbit)) => {
                let pivot = session.pick(cursor).map(|picked| picked.point);
                session.move_by(Motion::Orbit { delta, pivot });
            }
            Some(Action::Steer(Steer::Pan)) => {
                let anchor = session.pick(cursor).map(|picked| picked.point);
                session.move_by(Motion::Pan { from: cursor, to: cursor + delta, anchor });
            }
            Some(Action::Steer(steer)) => self.step(steer, delta.y / PIXELS_A_STEP, session),
            _ => {}
        }
    }

    /// Two fingers parted, by this share of their distance.
    pub fn pinch(&mut self, share: f32, session: &mut Session) {
        let mode = session.navigator.mode;
        if let Some(Action::Steer(steer)) = keys::action_of_gesture(Gesture::Pinch, Modifiers::NONE, mode) {
            self.step(steer, crate::navigation::steps_of_pinch(1.0 + share), session);
        }
    }

    fn step(&self, steer: Steer, steps: f32, session: &mut Session) {
        match steer {
            Steer::Zoom => {
                let Some(cursor) = self.cursor else { return };
                let distance = session.pick(cursor).map(|picked| picked.hit.t);
                session.move_by(Motion::Zoom { cursor, distance, steps });
            }
            Steer::Speed => {
                session.move_by(Motion::Speed(steps));
                session.say_speed();
            }
            Steer::FieldOfView => session.widen(-2.0 * steps),
            _ => {}
        }
    }
}

/// Whether an action is done again while its key is held.
fn may_repeat(action: Action) -> bool {
    matches!(
        action,
        Action::SpeedUp
            | Action::SpeedDown
            | Action::FieldOfViewUp
            | Action::FieldOfViewDown
            | Action::ExposureUp
            | Action::ExposureDown
            | Action::LightUp
            | Action::LightDown
            | Action::SkyUp
            | Action::SkyDown
            | Action::DividerLeft
            | Action::DividerRight
            | Action::UndoCamera
            | Action::RedoCamera
            | Action::Edit(EditAction::Undo | EditAction::Redo | EditAction::Larger | EditAction::Smaller)
    )
}
