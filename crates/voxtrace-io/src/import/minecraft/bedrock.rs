//! `.mcstructure`, what structure blocks of the Bedrock edition save: indices of two layers (blocks, and water around them), z fastest, then y,
//! then x; names and states of that edition, of which those about shapes become those of the Java edition.

use super::build::Build;
use super::nbt::{Compound, Tag};
use super::state::{State, without_namespace};
use super::voxels::Blocks;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::ImportError;

pub(super) fn read(
    build: &Build,
    root: &Compound,
    structure: &Compound,
    kinds: &mut Blocks,
    scene: &mut Scene,
) -> Result<(), ImportError> {
    let size = root.ints("size").and_then(|size| size.first_chunk::<3>());
    let size = size.ok_or_else(|| build.malformed("a structure without its size"))?;
    let [width, height, length] = build.checked(size.map(|edge| u64::try_from(edge).unwrap_or(u64::MAX)))?;
    let palette = structure.compound("palette").and_then(|palettes| palettes.entries().next());
    let palette = match palette {
        Some((_, Tag::Compound(palette))) => palette.list("block_palette"),
        _ => None,
    };
    let palette = palette.ok_or_else(|| build.malformed("a structure without a palette"))?;
    let states: Vec<State> = palette.iter().map(state).collect();
    let layers = structure.list("block_indices").unwrap_or_default();
    let layer = |index: usize| match layers.get(index) {
        Some(Tag::Ints(indices)) => Ok(indices.as_slice()),
        _ => Err(build.malformed("a structure without its blocks")),
    };
    let (blocks, waters) = (layer(0)?, layer(1).unwrap_or_default());
    let count = width * height * length;
    if blocks.len() < count {
        return Err(build.malformed(format!("{} blocks, where {count} are announced", blocks.len())));
    }
    if let Some(index) = blocks.iter().find(|&&index| index >= 0 && index as usize >= states.len()) {
        return Err(build.malformed(format!("the index {index} is not in the palette")));
    }
    let dry: Vec<u16> = states.iter().map(|state| kinds.number(state.clone())).collect();
    let wet: Vec<u16> = states.iter().map(|state| kinds.number(state.clone().with("waterlogged", true))).collect();
    let is_water = |index: usize| states.get(index).is_some_and(|state| state.name == "water");
    build.add(kinds, scene, [width, height, length], |place| {
        let (x, z, y) = (place % width, place / width % length, place / (width * length));
        let at = (x * height + y) * length + z;
        // −1 is a place that the structure leaves as it is.
        let Ok(index) = usize::try_from(blocks[at]) else { return 0 };
        let water = waters.get(at).and_then(|&water| usize::try_from(water).ok());
        match water {
            Some(water) if is_water(water) && dry[index] == 0 => dry[water],
            Some(water) if is_water(water) => wet[index],
            _ => dry[index],
        }
    })?;
    Ok(())
}

/// The state of the Java edition that a state of the Bedrock edition is.
fn state(tag: &Tag) -> State {
    let Tag::Compound(tags) = tag else { return State::new("air") };
    let name = without_namespace(tags.text("name").unwrap_or("air"));
    let empty = Compound::default();
    let said = tags.compound("states").unwrap_or(&empty);
    let number = |key: &str| said.whole(key);
    // Since 1.20 some keys have the game's namespace.
    let text = |key: &str| said.text(key).or_else(|| said.text(&format!("minecraft:{key}")));
    let is = |key: &str| number(key).is_some_and(|value| value != 0);
    let mut state = State::new(renamed(name, &text));
    for (key, value) in said.entries() {
        let value = match value {
            Tag::Text(text) => text.clone(),
            Tag::Whole(number) => number.to_string(),
            _ => continue,
        };
        state = state.with(without_namespace(key), value);
    }
    let is_stairs = state.name.ends_with("_stairs");
    let directions = |number: i64, order: [&'static str; 4]| order[number.rem_euclid(4) as usize];
    if let Some(direction) = number("weirdo_direction").filter(|_| is_stairs) {
        state = state.with("facing", directions(direction, ["east", "west", "south", "north"]));
        state = state.with("half", if is("upside_down_bit") { "top" } else { "bottom" });
    }
    if let Some(direction) = number("direction") {
        let order = if state.name.ends_with("_door") {
            ["east", "south", "west", "north"]
        } else if state.name.ends_with("trapdoor") {
            ["east", "west", "south", "north"]
        } else {
            ["south", "west", "north", "east"]
        };
        state = state.with("facing", directions(direction, order));
    }
    if let Some(direction) = text("cardinal_direction").or(text("block_face")) {
        let turned = if state.name.ends_with("_door") { clockwise(direction) } else { direction };
        state = state.with("facing", turned);
    }
    if let Some(facing) = number("facing_direction") {
        let sides = ["down", "up", "north", "south", "west", "east"];
        state = state.with("facing", sides[facing.rem_euclid(6) as usize]);
    }
    if let Some(axis) = text("pillar_axis") {
        state = state.with("axis", axis);
    }
    if name.ends_with("_double_slab") {
        state = state.with("type", "double");
    } else if let Some(half) = text("vertical_half") {
        state = state.with("type", half);
    } else if state.name.ends_with("_slab") {
        state = state.with("type", if is("top_slot_bit") { "top" } else { "bottom" });
    }
    if state.name.ends_with("door") {
        state = state.with("open", is("open_bit")).with("hinge", if is("door_hinge_bit") { "right" } else { "left" });
        let (upper, lower) = if state.name.ends_with("trapdoor") { ("top", "bottom") } else { ("upper", "lower") };
        let is_upper = is("upside_down_bit") || is("upper_block_bit");
        state = state.with("half", if is_upper { upper } else { lower });
    }
    if let Some(torch) = text("torch_facing_direction").filter(|&side| side != "top" && side != "unknown") {
        // It names the side that the torch is held on by.
        state.name = state.name.replace("torch", "wall_torch");
        state = state.with("facing", opposite(torch));
    }
    if let Some(level) = number("liquid_depth") {
        state = state.with("level", level);
    }
    if let Some(layers) = number("height").filter(|_| state.name == "snow") {
        state = state.with("layers", layers.saturating_add(1));
    }
    if let Some(age) = number("growth") {
        state = state.with("age", age);
    }
    if let Some(sides) = number("vine_direction_bits") {
        for (bit, side) in ["south", "west", "north", "east"].into_iter().enumerate() {
            state = state.with(side, sides >> bit & 1 != 0);
        }
    }
    state
}

fn clockwise(side: &str) -> &str {
    match side {
        "north" => "east",
        "east" => "south",
        "south" => "west",
        "west" => "north",
        other => other,
    }
}

fn opposite(side: &str) -> &str {
    clockwise(clockwise(side))
}

/// The name that the Java edition has for a block.
fn renamed<'a>(name: &str, text: &dyn Fn(&str) -> Option<&'a str>) -> String {
    let color = || text("color").map(|color| if color == "silver" { "light_gray" } else { color });
    let wood = || {
        text("wood_type")
            .or(text("old_log_type"))
            .or(text("new_log_type"))
            .or(text("old_leaf_type"))
            .or(text("new_leaf_type"))
    };
    let plain = match name {
        "grass" => "grass_block",
        "tallgrass" => "short_grass",
        "snow_layer" => "snow",
        "snow" => "snow_block",
        "grass_path" => "dirt_path",
        "flowing_water" => "water",
        "flowing_lava" => "lava",
        "brick_block" => "bricks",
        "nether_brick" => "nether_bricks",
        "stonebrick" => "stone_bricks",
        "wooden_door" => "oak_door",
        "trapdoor" => "oak_trapdoor",
        "fence_gate" => "oak_fence_gate",
        "fence" => "oak_fence",
        "wooden_button" => "oak_button",
        "wooden_pressure_plate" => "oak_pressure_plate",
        "standing_sign" => "oak_sign",
        "wall_sign" => "oak_wall_sign",
        "stone_stairs" => "cobblestone_stairs",
        "normal_stone_stairs" => "stone_stairs",
        "lit_pumpkin" => "jack_o_lantern",
        "lit_furnace" => "furnace",
        "lit_redstone_lamp" => "redstone_lamp",
        "waterlily" => "lily_pad",
        "reeds" => "sugar_cane",
        "web" => "cobweb",
        "red_flower" => "poppy",
        "yellow_flower" => "dandelion",
        "golden_rail" => "powered_rail",
        "noteblock" => "note_block",
        "deadbush" => "dead_bush",
        "hardened_clay" => "terracotta",
        "melon_block" => "melon",
        "seaLantern" => "sea_lantern",
        "undyed_shulker_box" => "shulker_box",
        "magma" => "magma_block",
        "red_nether_brick" => "red_nether_bricks",
        "end_bricks" => "end_stone_bricks",
        "slime" => "slime_block",
        "mob_spawner" => "spawner",
        "portal" => "nether_portal",
        "unpowered_repeater" | "powered_repeater" => "repeater",
        "unpowered_comparator" | "powered_comparator" => "comparator",
        "unlit_redstone_torch" => "redstone_torch",
        other => other,
    };
    match plain {
        "wool" | "carpet" | "concrete" | "stained_glass" | "stained_glass_pane" | "shulker_box" | "bed" => {
            color().map_or_else(|| plain.to_owned(), |color| format!("{color}_{plain}"))
        }
        "concretePowder" | "concrete_powder" => format!("{}_concrete_powder", color().unwrap_or("white")),
        "stained_hardened_clay" => format!("{}_terracotta", color().unwrap_or("white")),
        "planks" => format!("{}_planks", wood().unwrap_or("oak")),
        "log" | "log2" => format!("{}_log", wood().unwrap_or("oak")),
        "leaves" | "leaves2" => format!("{}_leaves", wood().unwrap_or("oak")),
        "wooden_slab" => format!("{}_slab", wood().unwrap_or("oak")),
        "double_wooden_slab" => format!("{}_planks", wood().unwrap_or("oak")),
        "stone" => text("stone_type").map_or("stone".into(), |kind| match kind.strip_suffix("_smooth") {
            Some(of) => format!("polished_{of}"),
            None => kind.to_owned(),
        }),
        _ if plain.ends_with("_double_slab") => plain.replace("_double_slab", "_slab"),
        _ => plain.to_owned(),
    }
}
