//! A block as files say it: its name without the game's namespace, and its properties.

use super::nbt::{Compound, Tag};

/// Most properties of a block that are kept; the game has at most seven.
const PROPERTIES: usize = 16;

/// A block of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct State {
    pub name: String,
    /// By their keys, in order.
    properties: Vec<(String, String)>,
}

impl State {
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), properties: Vec::new() }
    }

    /// The same with a property, which takes the place of what it was.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl ToString) -> Self {
        match self.properties.binary_search_by(|(other, _)| other.as_str().cmp(key)) {
            Ok(at) => self.properties[at].1 = value.to_string(),
            Err(at) if self.properties.len() < PROPERTIES => {
                self.properties.insert(at, (key.to_owned(), value.to_string()));
            }
            Err(_) => {}
        }
        self
    }

    /// A property, if it is said.
    pub fn get(&self, key: &str) -> Option<&str> {
        let at = self.properties.binary_search_by(|(other, _)| other.as_str().cmp(key)).ok()?;
        Some(&self.properties[at].1)
    }

    /// Whether a property is said to be this.
    pub fn is(&self, key: &str, value: &str) -> bool {
        self.get(key) == Some(value)
    }

    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// A property that is a number, `other` where it is none.
    pub fn number(&self, key: &str, other: i32) -> i32 {
        self.get(key).and_then(|value| value.parse().ok()).unwrap_or(other)
    }

    /// Whether the block is lit.
    pub fn is_lit(&self) -> bool {
        self.is("lit", "true")
    }

    /// The state that a text says: `minecraft:furnace[facing=north,lit=true]`.
    pub fn of_text(text: &str) -> Self {
        let (name, properties) = text.split_once('[').unwrap_or((text, ""));
        let pairs = properties.trim_end_matches(']').split(',').filter_map(|property| property.split_once('='));
        pairs.fold(Self::new(without_namespace(name)), |state, (key, value)| state.with(key.trim(), value.trim()))
    }

    /// The state that tags say: `Name`, and `Properties` with texts.
    pub fn of_tags(tags: &Compound) -> Self {
        let state = Self::new(without_namespace(tags.text("Name").unwrap_or("air")));
        let Some(properties) = tags.compound("Properties") else { return state };
        properties.entries().fold(state, |state, (key, value)| match value {
            Tag::Text(value) => state.with(key, value),
            _ => state,
        })
    }

    /// The states of a list of tags.
    pub fn of_list(list: &[Tag]) -> Vec<Self> {
        let state = |tag: &Tag| match tag {
            Tag::Compound(tags) => Self::of_tags(tags),
            _ => Self::new("air"),
        };
        list.iter().map(state).collect()
    }
}

pub(super) fn without_namespace(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_say_names_and_properties_in_any_order() {
        let state = State::of_text("minecraft:furnace[lit=true,facing=north]");
        assert_eq!(state, State::new("furnace").with("facing", "north").with("lit", true));
        assert!(state.is_lit() && state.is("facing", "north") && !state.has("half"));
        assert_eq!(State::of_text("stone"), State::new("stone"));
        assert_eq!(State::of_text("cake[bites=3]").number("bites", 0), 3);
        assert_eq!(State::of_text("cake[bites=x").number("bites", 0), 0);
        assert_eq!(state.with("lit", false).get("lit"), Some("false"));
    }
}
