//! The table of keys and gestures that hold while the hand edits, before those of the other table.

use super::Trigger::Gesture as By;
use super::{Action, Binding, Chord, Gesture, Group, Key, Modifiers, Steer, Trigger};
use crate::editing::{Act, Tool};
use crate::navigation::Mode;
use crate::text_key;
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
    row(&[By(Gesture::LeftDrag, Modifiers::NONE, None)], EditAction::Use, text_key!("keys.use_the_tool_where")),
    row(&[By(Gesture::LeftDrag, Modifiers::CTRL, None)], EditAction::Erase, text_key!("keys.erase_with_the_brush")),
    row(
        &[By(Gesture::LeftDrag, Modifiers::ALT, None), letter('I')],
        EditAction::PickMaterial,
        text_key!("keys.take_the_material_under"),
    ),
    steer(
        &[By(Gesture::RightDrag, Modifiers::NONE, Some(Mode::Orbit))],
        Steer::Orbit,
        text_key!("keys.in_orbit_go_around"),
    ),
    row(&[digit(1)], EditAction::Choose(Act::Place), text_key!("keys.place")),
    row(&[digit(2)], EditAction::Choose(Act::Erase), text_key!("keys.erase")),
    row(&[digit(3)], EditAction::Choose(Act::Paint), text_key!("keys.paint")),
    row(&[digit(4)], EditAction::Take(Tool::Brush), text_key!("keys.brush")),
    row(&[digit(5)], EditAction::Take(Tool::Line), text_key!("keys.line")),
    row(&[digit(6)], EditAction::Take(Tool::Box), text_key!("keys.box")),
    row(&[digit(7)], EditAction::Take(Tool::Extrude), text_key!("keys.push_and_pull_a")),
    row(&[digit(8)], EditAction::Take(Tool::Fill), text_key!("keys.fill_what_is_connected")),
    row(&[digit(9)], EditAction::Take(Tool::Replace), text_key!("keys.replace_a_material")),
    row(&[digit(0)], EditAction::Take(Tool::Select), text_key!("keys.select_a_box")),
    row(&[key(Modifiers::NONE, Key::Plus)], EditAction::Larger, text_key!("keys.larger_brush")),
    row(&[key(Modifiers::NONE, Key::Minus)], EditAction::Smaller, text_key!("keys.smaller_brush")),
    row(&[By(Gesture::Wheel, Modifiers::SHIFT, None)], EditAction::Resize, text_key!("keys.size_of_the_brush")),
    row(&[ctrl('Z')], EditAction::Undo, text_key!("keys.take_the_last_edit")),
    row(&[key(Modifiers::CTRL_SHIFT, Key::Letter('Z')), ctrl('Y')], EditAction::Redo, text_key!("keys.do_it_again")),
    row(&[ctrl('C')], EditAction::Copy, text_key!("keys.copy_what_is_selected")),
    row(&[ctrl('X')], EditAction::Cut, text_key!("keys.cut_it")),
    row(&[ctrl('V')], EditAction::Paste, text_key!("keys.paste_a_click_puts")),
    row(&[letter('G')], EditAction::Move, text_key!("keys.move_what_is_selected")),
    row(&[key(Modifiers::NONE, Key::Delete)], EditAction::Clear, text_key!("keys.clear_what_is_selected")),
    row(&[letter('R')], EditAction::Turn(EditAxis::Z), text_key!("keys.turn_what_is_pasted")),
    row(&[shift('R')], EditAction::Turn(EditAxis::X), text_key!("keys.about_x")),
    row(&[ctrl('R')], EditAction::Turn(EditAxis::Y), text_key!("keys.about_y")),
    row(&[letter('M')], EditAction::Mirror(EditAxis::X), text_key!("keys.mirror_what_is_pasted")),
    row(&[shift('M')], EditAction::Mirror(EditAxis::Y), text_key!("keys.along_y")),
    row(&[ctrl('M')], EditAction::Mirror(EditAxis::Z), text_key!("keys.along_z")),
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
