//! The table of keys and gestures that hold while the hand edits, before those of the other table.

use super::Trigger::Gesture as By;
use super::{Action, Binding, Chord, Gesture, Group, Key, Modifiers, Steer, Trigger};
use crate::editing::{Act, Tool};
use crate::navigation::Mode;
use voxtrace::Axis;

/// What is done while the hand edits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EditAction {
    /// Uses the tool.
    Use,
    /// Uses the brush to erase.
    Erase,
    /// Takes the material under the cursor.
    PickMaterial,
    /// Takes the last step back.
    Undo,
    /// Does it again.
    Redo,
    /// What brush, line and box do.
    Choose(Act),
    /// Takes a tool.
    Take(Tool),
    /// A larger brush.
    Larger,
    /// A smaller one.
    Smaller,
    /// A larger brush or a smaller one, by the wheel.
    Resize,
    /// Copies what is selected.
    Copy,
    /// Copies it and clears it.
    Cut,
    /// Puts down what was copied.
    Paste,
    /// Takes what is selected, to be put down elsewhere.
    Move,
    /// Clears what is selected.
    Clear,
    /// Turns what is to be put down by a quarter.
    Turn(EditAxis),
    /// Mirrors it.
    Mirror(EditAxis),
}

/// An axis, as keys name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EditAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

impl From<EditAxis> for Axis {
    fn from(axis: EditAxis) -> Self {
        match axis {
            EditAxis::X => Self::X,
            EditAxis::Y => Self::Y,
            EditAxis::Z => Self::Z,
        }
    }
}

const fn key(modifiers: Modifiers, key: Key) -> Trigger {
    Trigger::Key(Chord { key, modifiers })
}

const fn letter(letter: char) -> Trigger {
    key(Modifiers::NONE, Key::Letter(letter))
}

const fn ctrl(letter: char) -> Trigger {
    key(Modifiers::CTRL, Key::Letter(letter))
}

const fn shift(letter: char) -> Trigger {
    key(Modifiers::SHIFT, Key::Letter(letter))
}

const fn digit(number: u8) -> Trigger {
    key(Modifiers::NONE, Key::Digit(number))
}

const fn row(triggers: &'static [Trigger], action: EditAction, about: &'static str) -> Binding {
    Binding { triggers, told: "", pad: None, action: Action::Edit(action), group: Group::Editing, about }
}

const fn steer(triggers: &'static [Trigger], what: Steer, about: &'static str) -> Binding {
    Binding { triggers, told: "", pad: None, action: Action::Steer(what), group: Group::Editing, about }
}

/// Everything that keys and gestures do while the hand edits. No trigger stands twice.
pub const EDIT_TABLE: &[Binding] = &[
    row(
        &[By(Gesture::LeftDrag, Modifiers::NONE, None)],
        EditAction::Use,
        "use the tool; where nothing is under the cursor, move the camera",
    ),
    row(&[By(Gesture::LeftDrag, Modifiers::CTRL, None)], EditAction::Erase, "erase with the brush, line or box"),
    row(
        &[By(Gesture::LeftDrag, Modifiers::ALT, None), letter('I')],
        EditAction::PickMaterial,
        "take the material under the cursor",
    ),
    steer(
        &[By(Gesture::RightDrag, Modifiers::NONE, Some(Mode::Orbit))],
        Steer::Orbit,
        "in orbit, go around what is under the cursor",
    ),
    row(&[digit(1)], EditAction::Choose(Act::Place), "place"),
    row(&[digit(2)], EditAction::Choose(Act::Erase), "erase"),
    row(&[digit(3)], EditAction::Choose(Act::Paint), "paint"),
    row(&[digit(4)], EditAction::Take(Tool::Brush), "brush"),
    row(&[digit(5)], EditAction::Take(Tool::Line), "line"),
    row(&[digit(6)], EditAction::Take(Tool::Box), "box"),
    row(&[digit(7)], EditAction::Take(Tool::Extrude), "push and pull a face"),
    row(&[digit(8)], EditAction::Take(Tool::Fill), "fill what is connected"),
    row(&[digit(9)], EditAction::Take(Tool::Replace), "replace a material"),
    row(&[digit(0)], EditAction::Take(Tool::Select), "select a box"),
    row(&[key(Modifiers::NONE, Key::Plus)], EditAction::Larger, "larger brush"),
    row(&[key(Modifiers::NONE, Key::Minus)], EditAction::Smaller, "smaller brush"),
    row(
        &[By(Gesture::Wheel, Modifiers::SHIFT, None)],
        EditAction::Resize,
        "size of the brush; while a box is dragged, the wheel alone makes it deeper",
    ),
    row(&[ctrl('Z')], EditAction::Undo, "take the last edit back"),
    row(&[key(Modifiers::CTRL_SHIFT, Key::Letter('Z')), ctrl('Y')], EditAction::Redo, "do it again"),
    row(&[ctrl('C')], EditAction::Copy, "copy what is selected"),
    row(&[ctrl('X')], EditAction::Cut, "cut it"),
    row(&[ctrl('V')], EditAction::Paste, "paste: a click puts it down, again and again until Esc"),
    row(&[letter('G')], EditAction::Move, "move what is selected: a click puts it down"),
    row(&[key(Modifiers::NONE, Key::Delete)], EditAction::Clear, "clear what is selected"),
    row(&[letter('R')], EditAction::Turn(EditAxis::Z), "turn what is pasted by a quarter about z"),
    row(&[shift('R')], EditAction::Turn(EditAxis::X), "about x"),
    row(&[ctrl('R')], EditAction::Turn(EditAxis::Y), "about y"),
    row(&[letter('M')], EditAction::Mirror(EditAxis::X), "mirror what is pasted along x"),
    row(&[shift('M')], EditAction::Mirror(EditAxis::Y), "along y"),
    row(&[ctrl('M')], EditAction::Mirror(EditAxis::Z), "along z"),
];

/// What a key does while the hand edits, `None` where it does what it does otherwise. In flight what is held beside it means the speed.
pub fn edit_action_of(chord: Chord, is_flying: bool) -> Option<Action> {
    let shift = chord.modifiers.shift && chord.key != Key::Plus;
    let chord = Chord { modifiers: Modifiers { shift, ..chord.modifiers }, ..chord };
    if is_flying && chord.modifiers != Modifiers::NONE {
        return None;
    }
    found(|trigger| matches!(trigger, Trigger::Key(own) if *own == chord))
}

/// What a gesture does while the hand edits.
pub fn edit_action_of_gesture(gesture: Gesture, modifiers: Modifiers, mode: Mode) -> Option<Action> {
    found(|trigger| match *trigger {
        By(own, with, of_mode) => own == gesture && with == modifiers && of_mode.is_none_or(|own| own == mode),
        _ => false,
    })
}

fn found(fits: impl Fn(&Trigger) -> bool) -> Option<Action> {
    EDIT_TABLE.iter().find(|binding| binding.triggers.iter().any(&fits)).map(|binding| binding.action)
}
