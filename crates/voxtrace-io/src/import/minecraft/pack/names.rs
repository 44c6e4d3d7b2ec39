//! Names of the pictures of a block's faces: the game names them after the block, with a word for the face behind it.

use crate::import::minecraft::looks::Face;
use crate::import::minecraft::state::State;

/// Words at the end of a name that say what was made of it.
const MADE: [&str; 15] = [
    "_stairs",
    "_slab",
    "_wall",
    "_fence_gate",
    "_fence",
    "_button",
    "_pressure_plate",
    "_carpet",
    "_pane",
    "_hanging_sign",
    "_wall_sign",
    "_sign",
    "_bed",
    "_planks",
    "_block",
];
/// Words at the beginning that change no picture.
const BEFORE: [&str; 3] = ["waxed_", "infested_", "potted_"];

/// Names of pictures for a face, the one that suits best first.
pub(super) fn candidates(state: &State, face: Face) -> Vec<String> {
    // These have bark all around.
    for (bark, log) in [("_wood", "_log"), ("_hyphae", "_stem")] {
        if let Some(wood) = state.name.strip_suffix(bark) {
            return vec![format!("{wood}{log}")];
        }
    }
    let words = words(state, face);
    let mut found = Vec::new();
    for stem in stems(state, face) {
        found.extend(words.iter().map(|word| format!("{stem}{word}")));
    }
    found
}

/// Words for a face behind the name of a block.
fn words(state: &State, face: Face) -> Vec<String> {
    let mut words = Vec::new();
    let age = state.get("age").or_else(|| state.get("bites"));
    if let Some(age) = age {
        words.push(format!("_stage{}", stage(&state.name, age)));
    }
    match state.get("half") {
        Some("upper") => words.push("_top".into()),
        Some("lower") => words.push("_bottom".into()),
        _ => {}
    }
    if state.is("facing", face.name()) {
        if state.is_lit() {
            words.push("_front_on".into());
        }
        words.extend(["_front", "_front_side"].map(String::from));
    }
    // Logs and pillars have their ends along an axis.
    let axis = match state.get("axis") {
        Some("x") => 0,
        Some("z") => 2,
        _ => 1,
    };
    let named: &[&str] = match face {
        _ if state.has("axis") && face.axis() == axis => &["_top", ""],
        _ if state.has("axis") => &["_side", ""],
        Face::Up if state.is_lit() => &["_top_on", "_on", "_top", "", "_side"],
        Face::Up => &["_top", "_moist", "", "_side"],
        Face::Down => &["_bottom", "_top", "", "_side"],
        _ if state.is_lit() => &["_side_on", "_on", "_side", "", "_side0", "_0"],
        _ => &["_side", "", "_side0", "_0", "_1", "_top"],
    };
    words.extend(named.iter().map(|&word| word.to_owned()));
    words
}

/// The number of a plant's picture by its age; some keep one for several.
fn stage(name: &str, age: &str) -> u32 {
    let age = age.parse().unwrap_or(0);
    match name {
        "carrots" | "potatoes" => [0, 0, 1, 1, 2, 2, 2, 3][(age as usize).min(7)],
        "nether_wart" => [0, 1, 1, 2][(age as usize).min(3)],
        _ => age,
    }
}

/// What pictures may be named after.
fn stems(state: &State, face: Face) -> Vec<String> {
    let name = BEFORE.iter().fold(state.name.as_str(), |name, word| name.strip_prefix(word).unwrap_or(name));
    let is_flat = matches!(face, Face::Up | Face::Down);
    let mut stems: Vec<String> = vec![name.into()];
    match (name, face) {
        ("grass_block" | "podzol" | "mycelium" | "dirt_path" | "farmland", Face::Down) => return vec!["dirt".into()],
        ("farmland", _) if face != Face::Up => return vec!["dirt".into()],
        ("crimson_nylium" | "warped_nylium", Face::Down) => return vec!["netherrack".into()],
        ("water" | "lava", _) => stems = vec![format!("{name}_still")],
        ("bubble_column", _) => stems = vec!["water_still".into()],
        ("grass", _) => stems.push("short_grass".into()),
        ("short_grass", _) => stems.push("grass".into()),
        ("snow_block", _) => stems = vec!["snow".into()],
        ("magma_block", _) => stems.push("magma".into()),
        ("carved_pumpkin" | "jack_o_lantern", _) if !state.is("facing", face.name()) => stems = vec!["pumpkin".into()],
        ("carved_pumpkin" | "jack_o_lantern", _) => stems = vec![name.into(), "pumpkin".into()],
        ("fire" | "soul_fire", _) => stems = vec![format!("{name}_0")],
        ("dried_kelp_block", _) => stems.insert(0, "dried_kelp".into()),
        ("smooth_quartz", _) => stems.push("quartz_block_bottom".into()),
        ("smooth_sandstone" | "smooth_red_sandstone", _) => {
            stems.push(format!("{}_top", name.trim_start_matches("smooth_")));
        }
        ("quartz_slab" | "quartz_stairs", _) => stems.push("quartz_block_side".into()),
        _ => {}
    }
    let made = MADE.iter().find_map(|word| name.strip_suffix(word));
    if let Some(of) = made {
        stems.extend(["", "s", "_planks", "_wool", "_block"].map(|word| format!("{of}{word}")));
        if is_flat {
            stems.push(format!("{of}_top"));
        }
    }
    stems
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(state: &str, face: Face, there: &[&str]) -> String {
        candidates(&State::of_text(state), face)
            .into_iter()
            .find(|name| there.contains(&name.as_str()))
            .unwrap_or_default()
    }

    #[test]
    fn faces_find_the_pictures_that_the_game_shows_on_them() {
        let logs = ["oak_log", "oak_log_top"];
        assert_eq!(first("oak_log[axis=x]", Face::East, &logs), "oak_log_top");
        assert_eq!(first("oak_log[axis=x]", Face::Up, &logs), "oak_log");
        assert_eq!(first("oak_log", Face::Up, &logs), "oak_log_top");
        assert_eq!(first("oak_wood", Face::Up, &logs), "oak_log");
        let furnace = ["furnace_front", "furnace_front_on", "furnace_side", "furnace_top"];
        assert_eq!(first("furnace[facing=west,lit=false]", Face::West, &furnace), "furnace_front");
        assert_eq!(first("furnace[facing=west,lit=true]", Face::West, &furnace), "furnace_front_on");
        assert_eq!(first("furnace[facing=west]", Face::East, &furnace), "furnace_side");
        assert_eq!(first("furnace[facing=west]", Face::Up, &furnace), "furnace_top");
        let planks = ["oak_planks", "stone_bricks", "red_wool", "dirt", "grass_block_top", "grass_block_side"];
        assert_eq!(first("oak_stairs[half=top]", Face::North, &planks), "oak_planks");
        assert_eq!(first("stone_brick_slab", Face::North, &planks), "stone_bricks");
        assert_eq!(first("red_carpet", Face::Up, &planks), "red_wool");
        assert_eq!(first("grass_block", Face::Down, &planks), "dirt");
        assert_eq!(first("grass_block", Face::Up, &planks), "grass_block_top");
        let doors = ["oak_door_top", "oak_door_bottom", "wheat_stage3", "carrots_stage1"];
        assert_eq!(first("oak_door[half=upper]", Face::South, &doors), "oak_door_top");
        assert_eq!(first("oak_door[half=lower]", Face::South, &doors), "oak_door_bottom");
        assert_eq!(first("wheat[age=3]", Face::South, &doors), "wheat_stage3");
        assert_eq!(first("carrots[age=3]", Face::South, &doors), "carrots_stage1");
    }
}
