//! The materials of a build: each look once, each name looked up once.

use super::blocks::{Block, Look, block};
use super::nbt::{Compound, Tag};
use crate::import::reader::{NotShown, Voxels};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;
use voxtrace_scene::material::{MAX_MATERIALS, Material};
use voxtrace_scene::scene::Scene;

/// Names that a note about unknown blocks says.
const NAMED: usize = 5;

/// A block of a file: its name without the game's namespace, and whether it is lit.
pub(super) type State = (String, bool);

#[derive(Default)]
pub(super) struct Palette {
    materials: Vec<Material>,
    by_look: FxHashMap<Look, u16>,
    by_state: FxHashMap<State, Option<u16>>,
    unknown: BTreeSet<String>,
    /// Entities that the files hold: mobs, minecarts, item frames.
    pub entities: u64,
}

impl Palette {
    /// The material of a block, `None` for what nobody sees.
    pub fn material(&mut self, state: State) -> Option<u16> {
        if let Some(&material) = self.by_state.get(&state) {
            return material;
        }
        let look = match block(&state.0, state.1) {
            Block::Unseen => None,
            Block::Known(look) => Some(look),
            Block::Unknown(look) => {
                self.unknown.insert(state.0.clone());
                Some(look)
            }
        };
        let material = look.map(|look| self.material_of(look));
        self.by_state.insert(state, material);
        material
    }

    fn material_of(&mut self, look: Look) -> u16 {
        let next = self.materials.len();
        if let Some(&material) = self.by_look.get(&look) {
            return material;
        }
        if next >= MAX_MATERIALS {
            // No build has so many names; what comes after them takes the last look.
            return (next - 1) as u16;
        }
        self.materials.push(look.material());
        self.by_look.insert(look, next as u16);
        next as u16
    }

    /// The scene with its materials, and a note about blocks whose names say nothing.
    pub fn finish(self, mut scene: Scene) -> Voxels {
        scene.materials = self.materials;
        let mut notes = Vec::new();
        if !self.unknown.is_empty() {
            let names: Vec<&str> = self.unknown.iter().take(NAMED).map(String::as_str).collect();
            let more = if self.unknown.len() > NAMED { ", …" } else { "" };
            let count = self.unknown.len();
            notes.push(format!(
                "{count} kinds of blocks are unknown, their colours are made from their names: {}{more}",
                names.join(", ")
            ));
        }
        let mut parts = NotShown::default();
        parts.count("entity", self.entities);
        notes.extend(parts.note());
        Voxels { scene, notes }
    }
}

/// The state that a text says: `minecraft:furnace[facing=north,lit=true]`.
pub(super) fn state_of_text(text: &str) -> State {
    let (name, properties) = text.split_once('[').unwrap_or((text, ""));
    let is_lit = properties.trim_end_matches(']').split(',').any(|property| property == "lit=true");
    (without_namespace(name), is_lit)
}

/// The state that tags say: `Name`, and `Properties` with texts.
pub(super) fn state_of_tags(tags: &Compound) -> State {
    let properties = tags.compound("Properties");
    let is_lit = properties.is_some_and(|properties| properties.text("lit") == Some("true"));
    (without_namespace(tags.text("Name").unwrap_or("air")), is_lit)
}

/// The states of a list of tags.
pub(super) fn states(list: &[Tag]) -> Vec<State> {
    let state = |tag: &Tag| match tag {
        Tag::Compound(tags) => state_of_tags(tags),
        _ => ("air".into(), false),
    };
    list.iter().map(state).collect()
}

fn without_namespace(name: &str) -> String {
    name.split_once(':').map_or(name, |(_, name)| name).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_read_from_texts_and_looks_are_shared() {
        assert_eq!(state_of_text("minecraft:furnace[facing=north,lit=true]"), ("furnace".into(), true));
        assert_eq!(state_of_text("stone"), ("stone".into(), false));
        assert_eq!(state_of_text("minecraft:candle[lit=false]"), ("candle".into(), false));
        let mut palette = Palette::default();
        let mut material = |text: &str| palette.material(state_of_text(text));
        assert_eq!(material("minecraft:air"), None);
        assert_eq!(material("minecraft:oak_stairs[facing=east]"), Some(0));
        assert_eq!(material("minecraft:oak_slab"), Some(0));
        assert_eq!(material("minecraft:stone"), Some(1));
        assert_eq!(material("mod:zorb"), Some(2));
        assert_eq!(material("minecraft:air[lit=true]"), None);
        let voxels = palette.finish(Scene::new(""));
        assert_eq!(voxels.scene.materials.len(), 3);
        assert_eq!(voxels.notes.len(), 1);
        assert!(voxels.notes[0].starts_with("1 kinds") && voxels.notes[0].ends_with("zorb"), "{:?}", voxels.notes);
    }
}
