//! The table for people: as rows for the list of F1, and as Markdown for `docs/viewer.md`.

use super::{Binding, EDIT_TABLE, Gesture, Group, Modifiers, TABLE, Trigger};
use crate::navigation::Mode;
use crate::{strings, tr};

/// A line of a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The keys and gestures.
    pub keys: String,
    /// What they do.
    pub about: &'static str,
}

/// The rows of a group.
pub fn rows(group: Group) -> Vec<Row> {
    rows_of(&[TABLE, EDIT_TABLE].concat(), group)
}

/// All groups as tables in Markdown.
pub fn markdown() -> String {
    markdown_of(&[TABLE, EDIT_TABLE].concat())
}

fn rows_of(table: &[Binding], group: Group) -> Vec<Row> {
    let row = |binding: &Binding| {
        let told = Some(binding.told).filter(|told| !told.is_empty()).map(|told| strings::text(told).to_owned());
        let button = binding.pad.map(|button| tr!("keys_pad.gamepad", button = button));
        // One gesture in several modes is told once.
        let same = |a: &Trigger, b: &Trigger| gesture(a).is_some() && gesture(a) == gesture(b);
        let keys: Vec<String> = binding.triggers.chunk_by(same).map(text).chain(told).chain(button).collect();
        Row { keys: keys.join(", "), about: strings::text(binding.about) }
    };
    table.iter().filter(|binding| binding.group == group).map(row).collect()
}

pub(super) fn markdown_of(table: &[Binding]) -> String {
    let group = |group: Group| {
        let rows = rows_of(table, group).into_iter().map(|row| format!("| {} | {} |\n", row.keys, row.about));
        format!("### {}\n| | |\n|---|---|\n{}", group.name(), rows.collect::<String>())
    };
    Group::ALL.map(group).join("\n")
}

/// A gesture with what is held beside it, whatever the mode.
fn gesture(trigger: &Trigger) -> Option<(Gesture, Modifiers)> {
    match *trigger {
        Trigger::Gesture(gesture, modifiers, _) => Some((gesture, modifiers)),
        _ => None,
    }
}

/// One trigger, or one gesture in several modes.
fn text(triggers: &[Trigger]) -> String {
    let mode = |trigger: &Trigger| match trigger {
        Trigger::Gesture(_, _, Some(Mode::Fly)) => Some(tr!("walk.mode_fly")),
        Trigger::Gesture(_, _, Some(Mode::Orbit)) => Some(tr!("walk.mode_orbit")),
        Trigger::Gesture(_, _, Some(Mode::Walk)) => Some(tr!("walk.mode_walk")),
        _ => None,
    };
    match triggers.first() {
        Some(Trigger::Key(chord)) => chord.to_string(),
        Some(Trigger::Digits(modifiers)) => format!("{modifiers}1 … {modifiers}9"),
        Some(Trigger::Gesture(gesture, modifiers, _)) => {
            let modes: Vec<&str> = triggers.iter().filter_map(mode).collect();
            let when = if modes.is_empty() { String::new() } else { format!(" ({})", modes.join(", ")) };
            format!("{modifiers}{gesture}{when}")
        }
        None => String::new(),
    }
}
