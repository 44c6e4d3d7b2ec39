//! `.mcstructure`, what structure blocks of the Bedrock edition save: indices of two layers (blocks, and water around them), z fastest, then y,
//! then x; names and states of that edition, of which those about shapes become those of the Java edition.

use super::build::Build;
use super::legacy_states::RAILS;
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
    // What burns has a name, a bit or a number of its own.
    let lit = match name {
        "unlit_redstone_torch" => Some(false),
        "lit_pumpkin" => None,
        _ if name.starts_with("lit_") => Some(true),
        _ => number("extinguished").map(|bit| bit == 0).or_else(|| number("lit").map(|bit| bit != 0)),
    };
    if let Some(lit) = lit {
        state = state.with("lit", lit);
    }
    // Bedrock keeps their count less one.
    for (key, own) in [("candles", "candles"), ("cluster_count", "pickles")] {
        if let Some(more) = number(key) {
            state = state.with(own, more.saturating_add(1));
        }
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
        // The way that a door says is a quarter turn beyond the one that it faces.
        let turned = if state.name.ends_with("_door") { clockwise(opposite(direction)) } else { direction };
        state = state.with("facing", turned);
    }
    if let Some(facing) = number("facing_direction") {
        let sides = ["down", "up", "north", "south", "west", "east"];
        state = state.with("facing", sides[facing.rem_euclid(6) as usize]);
    }
    if let Some(axis) = text("pillar_axis") {
        state = state.with("axis", axis);
    }
    // Names of double slabs have that word at the beginning, in the middle, or before the last one.
    if name.contains("double_") && name.trim_end_matches(['2', '3', '4']).ends_with("_slab") {
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
    } else if number("upper_block_bit").is_some() {
        state = state.with("half", if is("upper_block_bit") { "upper" } else { "lower" });
    }
    if number("head_piece_bit").is_some() {
        state = state.with("part", if is("head_piece_bit") { "head" } else { "foot" });
    }
    if number("hanging").is_some() {
        state = state.with("hanging", is("hanging"));
    }
    if let Some(shape) = number("rail_direction").and_then(|shape| RAILS.get(usize::try_from(shape).ok()?)) {
        state = state.with("shape", shape);
    }
    if let Some(torch) = text("torch_facing_direction").filter(|&side| side != "top" && side != "unknown") {
        // It names the side that the torch is held on by.
        state.name = state.name.replace("torch", "wall_torch");
        state = state.with("facing", opposite(torch));
    }
    if let Some(rotation) = number("ground_sign_direction") {
        state = state.with("rotation", rotation);
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

/// The name that the Java edition has for a block which was a kind of another one, until 1.20 and 1.21 gave names to them all.
fn by_kind<'a>(name: &str, text: &dyn Fn(&str) -> Option<&'a str>) -> Option<String> {
    const SLABS: [&str; 4] = ["stone_slab_type", "stone_slab_type_2", "stone_slab_type_3", "stone_slab_type_4"];
    let kind = match name.trim_end_matches(['2', '3', '4']) {
        "stone_slab" | "double_stone_slab" | "stone_block_slab" | "double_stone_block_slab" => {
            let kind = match SLABS.into_iter().find_map(text)? {
                "wood" => "petrified_oak",
                "prismarine_rough" => "prismarine",
                "prismarine_dark" => "dark_prismarine",
                kind => kind,
            };
            return Some(format!("{kind}_slab"));
        }
        "cobblestone_wall" => {
            let kind = text("wall_block_type")?;
            return Some(format!("{}_wall", if kind == "end_brick" { "end_stone_brick" } else { kind }));
        }
        "fence" => return Some(format!("{}_fence", text("wood_type")?)),
        "sapling" => return Some(format!("{}_sapling", text("sapling_type")?)),
        "stonebrick" => match text("stone_brick_type")? {
            kind @ ("mossy" | "cracked" | "chiseled") => return Some(format!("{kind}_stone_bricks")),
            _ => return None,
        },
        "prismarine" => match text("prismarine_block_type")? {
            "dark" => "dark_prismarine",
            "bricks" => "prismarine_bricks",
            _ => return None,
        },
        "sand" if text("sand_type")? == "red" => "red_sand",
        "dirt" if text("dirt_type")? == "coarse" => "coarse_dirt",
        "sponge" if text("sponge_type")? == "wet" => "wet_sponge",
        "tallgrass" if text("tall_grass_type")? == "fern" => "fern",
        "double_plant" => match text("double_plant_type")? {
            "syringa" => "lilac",
            "grass" => "tall_grass",
            "fern" => "large_fern",
            "rose" => "rose_bush",
            "paeonia" => "peony",
            _ => "sunflower",
        },
        "red_flower" => match text("flower_type")? {
            "orchid" => "blue_orchid",
            "houstonia" => "azure_bluet",
            "tulip_red" => "red_tulip",
            "tulip_orange" => "orange_tulip",
            "tulip_white" => "white_tulip",
            "tulip_pink" => "pink_tulip",
            "oxeye" => "oxeye_daisy",
            kind => kind,
        },
        _ => return None,
    };
    Some(kind.to_owned())
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
        "darkoak_standing_sign" => "dark_oak_sign",
        "darkoak_wall_sign" => "dark_oak_wall_sign",
        // Their colours lie with what chests hold.
        "standing_banner" => "white_banner",
        "wall_banner" => "white_wall_banner",
        "stone_stairs" => "cobblestone_stairs",
        "normal_stone_stairs" => "stone_stairs",
        "lit_pumpkin" => "jack_o_lantern",
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
        "trip_wire" | "tripWire" => "tripwire",
        "beetroot" => "beetroots",
        "azalea_leaves_flowered" => "flowering_azalea_leaves",
        "cave_vines_body_with_berries" | "cave_vines_head_with_berries" => "cave_vines",
        "dirt_with_roots" => "rooted_dirt",
        "daylight_detector_inverted" => "daylight_detector",
        "frame" | "glow_frame" => "item_frame",
        "frog_spawn" => "frogspawn",
        "moving_block" => "moving_piston",
        "piston_arm_collision" | "sticky_piston_arm_collision" => "piston_head",
        "silver_glazed_terracotta" => "light_gray_glazed_terracotta",
        "normal_stone_slab" => "stone_slab",
        // Nobody sees these: the light of that edition has had a name for each of its levels since 1.21.
        "invisible_bedrock" => "barrier",
        light if light == "light_block" || light.starts_with("light_block_") => "light",
        // Those of the Education edition.
        torch if torch == "underwater_torch" || torch.starts_with("colored_torch") => "torch",
        other => ["lit_", "hard_", "underwater_"].iter().find_map(|start| other.strip_prefix(start)).unwrap_or(other),
    };
    if let Some(wood) = plain.strip_suffix("_standing_sign") {
        return format!("{wood}_sign");
    }
    if let Some(kind) = by_kind(name, text) {
        return kind;
    }
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
        _ if plain.contains("double_") && plain.ends_with("_slab") => plain.replace("double_", ""),
        _ => plain.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The state of a block with whole numbers as its states.
    fn of(name: &str, states: &[(&str, i64)]) -> State {
        with(name, states.iter().map(|&(key, value)| (key.to_owned(), Tag::Whole(value))).collect())
    }

    /// The state of a block with a text among its states.
    fn kind(name: &str, key: &str, kind: &str) -> State {
        with(name, vec![(key.to_owned(), Tag::Text(kind.to_owned())), ("top_slot_bit".to_owned(), Tag::Whole(1))])
    }

    fn with(name: &str, states: Vec<(String, Tag)>) -> State {
        let name = Tag::Text(format!("minecraft:{name}"));
        let tags = vec![("name".to_owned(), name), ("states".to_owned(), Tag::Compound(Compound::of(states)))];
        state(&Tag::Compound(Compound::of(tags)))
    }

    #[test]
    fn doors_face_a_quarter_turn_before_what_their_text_says() {
        for (said, number, facing) in
            [("south", 0, "east"), ("west", 1, "south"), ("north", 2, "west"), ("east", 3, "north")]
        {
            let new = kind("wooden_door", "minecraft:cardinal_direction", said);
            let old = of("wooden_door", &[("direction", number)]);
            assert_eq!((new.get("facing"), old.get("facing")), (Some(facing), Some(facing)), "{said}");
        }
        assert_eq!(kind("chest", "minecraft:cardinal_direction", "east").get("facing"), Some("east"));
    }

    #[test]
    fn what_burns_is_lit_and_what_is_out_is_not() {
        for (name, states, java, lit) in [
            ("lit_redstone_lamp", &[][..], "redstone_lamp", Some("true")),
            ("lit_furnace", &[("facing_direction", 2)], "furnace", Some("true")),
            ("lit_blast_furnace", &[], "blast_furnace", Some("true")),
            ("lit_smoker", &[], "smoker", Some("true")),
            ("lit_deepslate_redstone_ore", &[], "deepslate_redstone_ore", Some("true")),
            ("lit_pumpkin", &[], "jack_o_lantern", None),
            ("redstone_lamp", &[], "redstone_lamp", None),
            ("unlit_redstone_torch", &[], "redstone_torch", Some("false")),
            ("redstone_torch", &[], "redstone_torch", None),
            ("campfire", &[("extinguished", 0)], "campfire", Some("true")),
            ("soul_campfire", &[("extinguished", 1)], "soul_campfire", Some("false")),
            ("red_candle", &[("lit", 1)], "red_candle", Some("true")),
            ("copper_bulb", &[("lit", 0)], "copper_bulb", Some("false")),
        ] {
            let state = of(name, states);
            assert_eq!((state.name.as_str(), state.get("lit")), (java, lit), "{name}");
        }
    }

    #[test]
    fn kinds_of_one_block_are_blocks_of_their_own() {
        for (name, key, of, java, slab) in [
            ("stone_block_slab", "stone_slab_type", "sandstone", "sandstone_slab", Some("top")),
            ("stone_block_slab2", "stone_slab_type_2", "prismarine_dark", "dark_prismarine_slab", Some("top")),
            ("double_stone_block_slab3", "stone_slab_type_3", "granite", "granite_slab", Some("double")),
            ("double_stone_slab4", "stone_slab_type_4", "stone", "stone_slab", Some("double")),
            ("stone_slab", "stone_slab_type", "brick", "brick_slab", Some("top")),
            ("smooth_stone_double_slab", "vertical_half", "bottom", "smooth_stone_slab", Some("double")),
            ("exposed_double_cut_copper_slab", "vertical_half", "bottom", "exposed_cut_copper_slab", Some("double")),
            ("cobblestone_wall", "wall_block_type", "end_brick", "end_stone_brick_wall", None),
            ("cobblestone_wall", "wall_connection_type_east", "none", "cobblestone_wall", None),
            ("fence", "wood_type", "birch", "birch_fence", None),
            ("stonebrick", "stone_brick_type", "mossy", "mossy_stone_bricks", None),
            ("stonebrick", "stone_brick_type", "default", "stone_bricks", None),
            ("sand", "sand_type", "red", "red_sand", None),
            ("sand", "sand_type", "normal", "sand", None),
            ("double_plant", "double_plant_type", "rose", "rose_bush", None),
            ("red_flower", "flower_type", "tulip_pink", "pink_tulip", None),
        ] {
            let state = kind(name, key, of);
            assert_eq!((state.name.as_str(), state.get("type")), (java, slab), "{name} {of}");
            let look = super::super::blocks::block(java, false);
            assert!(matches!(look, super::super::blocks::Block::Known(_)), "{java}");
        }
    }

    #[test]
    fn names_that_only_that_edition_has_are_those_of_known_blocks() {
        for (name, java) in [
            ("spruce_standing_sign", "spruce_sign"),
            ("darkoak_standing_sign", "dark_oak_sign"),
            ("darkoak_wall_sign", "dark_oak_wall_sign"),
            ("standing_banner", "white_banner"),
            ("wall_banner", "white_wall_banner"),
            ("silver_glazed_terracotta", "light_gray_glazed_terracotta"),
            ("normal_stone_slab", "stone_slab"),
            ("dirt_with_roots", "rooted_dirt"),
            ("azalea_leaves_flowered", "flowering_azalea_leaves"),
            ("frame", "item_frame"),
            ("beetroot", "beetroots"),
            ("sticky_piston_arm_collision", "piston_head"),
            ("hard_red_stained_glass_pane", "red_stained_glass_pane"),
            ("colored_torch_blue", "torch"),
            ("underwater_tnt", "tnt"),
        ] {
            assert_eq!(of(name, &[]).name, java, "{name}");
            let look = super::super::blocks::block(java, false);
            assert!(matches!(look, super::super::blocks::Block::Known(_)), "{java}");
        }
        assert_eq!(of("acacia_standing_sign", &[("ground_sign_direction", 6)]).number("rotation", 0), 6);
    }

    #[test]
    fn parts_of_blocks_and_the_ways_of_rails_are_told() {
        assert!(of("lilac", &[("upper_block_bit", 1)]).is("half", "upper"));
        assert!(of("bed", &[("head_piece_bit", 1), ("direction", 0)]).is("part", "head"));
        assert!(of("lantern", &[("hanging", 1)]).is("hanging", "true"));
        assert!(of("rail", &[("rail_direction", 9)]).is("shape", "north_east"));
        assert!(!of("rail", &[("rail_direction", -1)]).has("shape"));
    }

    #[test]
    fn candles_and_pickles_are_counted_from_one() {
        assert_eq!(of("candle", &[("candles", 0), ("lit", 0)]).number("candles", 0), 1);
        assert_eq!(of("candle", &[("candles", 3), ("lit", 0)]).number("candles", 0), 4);
        assert_eq!(of("sea_pickle", &[("cluster_count", 2)]).number("pickles", 0), 3);
    }

    #[test]
    fn what_nobody_sees_is_not_there() {
        for name in ["light_block", "light_block_15", "invisible_bedrock", "barrier", "structure_void", "trip_wire"] {
            let name = of(name, &[]).name;
            assert!(super::super::material_of_block(&name).is_none(), "{name}");
            assert!(matches!(super::super::blocks::block(&name, false), super::super::blocks::Block::Unseen), "{name}");
        }
    }
}
