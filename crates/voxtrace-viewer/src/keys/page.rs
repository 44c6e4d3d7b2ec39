//! The table for people: as rows for the list of F1, and as Markdown for `docs/viewer.md`.

use super::{Binding, EDIT_TABLE, Group, TABLE, Trigger};
use crate::navigation::Mode;

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
        let told = Some(binding.told.to_owned()).filter(|told| !told.is_empty());
        let button = binding.pad.map(|button| format!("gamepad {button}"));
        let keys: Vec<String> = binding.triggers.iter().map(text).chain(told).chain(button).collect();
        Row { keys: keys.join(", "), about: binding.about }
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

fn text(trigger: &Trigger) -> String {
    match trigger {
        Trigger::Key(chord) => chord.to_string(),
        Trigger::Digits(modifiers) => format!("{modifiers}1 … {modifiers}9"),
        Trigger::Gesture(gesture, modifiers, mode) => {
            let when = match mode {
                Some(Mode::Fly) => " (fly)",
                Some(Mode::Orbit) => " (orbit)",
                Some(Mode::Walk) => " (walk)",
                None => "",
            };
            format!("{modifiers}{gesture}{when}")
        }
    }
}
