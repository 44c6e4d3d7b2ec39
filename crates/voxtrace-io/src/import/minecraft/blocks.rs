//! What a block looks like, by its name: a colour of its own, or that of what it is made of (`oak_stairs` are oak planks,
//! `red_wool` is dyed). `docs/minecraft.md` says the rules.

use super::colors::COLORS;
use super::dyes::{DYES, WOODS};
use voxtrace_scene::material::{Material, linear_color};

/// Blocks that nobody sees.
const UNSEEN: [&str; 7] = ["air", "barrier", "cave_air", "light", "structure_void", "tripwire", "void_air"];

/// Blocks that always glow, with their light level.
const GLOWING: [(&str, u8); 26] = [
    ("beacon", 15),
    ("campfire", 15),
    ("conduit", 15),
    ("copper_lantern", 15),
    ("copper_torch", 14),
    ("crying_obsidian", 10),
    ("end_gateway", 15),
    ("end_rod", 14),
    ("fire", 15),
    ("glowstone", 15),
    ("jack_o_lantern", 15),
    ("lantern", 15),
    ("lava", 15),
    ("magma_block", 3),
    ("nether_portal", 11),
    ("ochre_froglight", 15),
    ("pearlescent_froglight", 15),
    ("redstone_torch", 7),
    ("sea_lantern", 15),
    ("shroomlight", 15),
    ("soul_campfire", 10),
    ("soul_fire", 10),
    ("soul_lantern", 10),
    ("soul_torch", 10),
    ("torch", 14),
    ("verdant_froglight", 15),
];

/// Blocks that glow when they are lit, with their light level and the colour of what glows.
const LIT: [(&str, u8, u32); 6] = [
    ("redstone_lamp", 15, 0xe8b070),
    ("copper_bulb", 15, 0xf2c27a),
    ("candle", 9, 0xf2d49a),
    ("blast_furnace", 6, 0x9a7a5a),
    ("furnace", 6, 0x9a7a5a),
    ("smoker", 6, 0x9a7a5a),
];

/// Radiance of a white block at the highest light level.
const BRIGHTEST: f32 = 8.0;

/// Words before a name that change little. `dead_` and such have colours of their own.
const PREFIXES: [&str; 14] = [
    "waxed_",
    "deepslate_",
    "small_",
    "medium_",
    "large_",
    "infested_",
    "potted_",
    "chiseled_",
    "cracked_",
    "cut_",
    "smooth_",
    "polished_",
    "mossy_",
    "stripped_",
];

/// Words after a name that say what was made of it.
const SUFFIXES: [&str; 50] = [
    "_carpet",
    "_pane",
    "_wall_hanging_sign",
    "_hanging_sign",
    "_wall_sign",
    "_wall_banner",
    "_wall_fan",
    "_wall_torch",
    "_wall_head",
    "_wall_skull",
    "_fence_gate",
    "_pressure_plate",
    "_cross_collision",
    "_candle_cake",
    "_golem_statue",
    "_trapdoor",
    "_mosaic",
    "_stairs",
    "_fence",
    "_slab",
    "_wall",
    "_door",
    "_button",
    "_sign",
    "_shelf",
    "_bush",
    "_planks",
    "_pillar",
    "_bricks",
    "_brick",
    "_tiles",
    "_tile",
    "_block",
    "_bulb",
    "_grate",
    "_bars",
    "_chain",
    "_chest",
    "_lantern",
    "_plant",
    "_plants",
    "_cauldron",
    "_cluster",
    "_bud",
    "_fan",
    "_head",
    "_crop",
    "_stem",
    "_cake",
    "_ore",
];

/// Most words that are left out.
const MOST_WORDS: usize = 4;

/// How a block looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Look {
    /// sRGB.
    pub color: u32,
    pub kind: Kind,
    /// Light level, 0 to 15.
    pub light: u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Kind {
    Plain,
    Glass,
    Water,
    Metal,
}

/// What is known of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Block {
    Unseen,
    Known(Look),
    /// A name that says nothing: the colour is made from its letters.
    Unknown(Look),
}

impl Look {
    /// The material where a block is so many voxels long: what tints light takes as many times the way.
    pub fn material(self, edge: f32) -> Material {
        let [_, red, green, blue] = self.color.to_be_bytes();
        let color = linear_color([red, green, blue]);
        let plain = Material::diffuse(color);
        let plain = Material { emission: color * BRIGHTEST * f32::from(self.light) / 15.0, ..plain };
        match self.kind {
            Kind::Plain => plain,
            Kind::Glass => Material { roughness: 0.0, transmission: 0.9, ior: 1.5, specular: 1.0, ..plain }
                .tinted(color, 2.0 * edge),
            Kind::Water => {
                Material { roughness: 0.05, transmission: 0.9, ior: 1.33, ..plain }.tinted(color, 6.0 * edge)
            }
            Kind::Metal => Material { roughness: 0.3, metallic: 1.0, ..plain },
        }
    }
}

/// The block of a name without its namespace, `is_lit` where its state says `lit=true`.
pub(super) fn block(name: &str, is_lit: bool) -> Block {
    if UNSEEN.contains(&name) {
        return Block::Unseen;
    }
    // The middle of `exposed_cut_copper` changes nothing.
    let plain = name.replace("wall_torch", "torch").replace("_cut_", "_").replace("_chiseled_", "_");
    let plain = plain.replace("_wall_head", "_head").replace("_wall_skull", "_skull");
    if is_lit && let Some(&(_, light, color)) = LIT.iter().find(|(suffix, ..)| plain.ends_with(suffix)) {
        return Block::Known(Look { color, kind: Kind::Plain, light });
    }
    let light = GLOWING.iter().find(|(glowing, _)| *glowing == plain).map_or(0, |&(_, light)| light);
    let kind = if name.contains("glass") || name == "ice" || name.ends_with("_ice") {
        Kind::Glass
    } else if name.contains("water") || name == "bubble_column" {
        Kind::Water
    } else if is_metal(name) {
        Kind::Metal
    } else {
        Kind::Plain
    };
    match color(&plain) {
        Some(color) => Block::Known(Look { color, kind, light }),
        None => Block::Unknown(Look { color: color_of_letters(name), kind, light }),
    }
}

/// Whether a block is of metal, copper of any age.
fn is_metal(name: &str) -> bool {
    let is_named = ["iron_", "gold_", "netherite_block", "chain"].iter().any(|metal| name.starts_with(metal))
        || ["anvil", "lightning_rod"].iter().any(|metal| name.ends_with(metal))
        || name.contains("copper");
    is_named && !name.ends_with("_ore") && !name.starts_with("raw_") && name != "chain_command_block"
}

fn color(name: &str) -> Option<u32> {
    own_color(name).or_else(|| dyed(name)).or_else(|| wooden(name)).or_else(|| without_words(name))
}

fn own_color(name: &str) -> Option<u32> {
    COLORS.iter().find(|(other, _)| *other == name).map(|&(_, color)| color)
}

fn dyed(name: &str) -> Option<u32> {
    let (rest, [wool, concrete, terracotta]) = DYES.iter().find_map(|&(dye, colors)| {
        let rest = name.strip_prefix(dye)?.strip_prefix('_')?;
        Some((rest, colors))
    })?;
    match rest {
        "concrete" => Some(concrete),
        "terracotta" => Some(terracotta),
        "concrete_powder" => Some(mixed(concrete, 0xffffff, 60)),
        "stained_glass" | "stained_glass_pane" => Some(mixed(wool, 0xffffff, 40)),
        "wool" | "carpet" | "bed" | "banner" | "wall_banner" | "candle" | "candle_cake" | "shulker_box" | "harness"
        | "glazed_terracotta" => Some(wool),
        _ => None,
    }
}

fn wooden(name: &str) -> Option<u32> {
    let (name, is_stripped) = name.strip_prefix("stripped_").map_or((name, false), |name| (name, true));
    let (rest, [bark, planks, leaves]) = WOODS.iter().find_map(|&(wood, colors)| {
        let rest = name.strip_prefix(wood)?;
        (rest.is_empty() || rest.starts_with('_')).then_some((rest, colors))
    })?;
    match rest {
        "_log" | "_wood" | "_stem" | "_hyphae" | "_block" if is_stripped => Some(mixed(planks, 0xffffff, 20)),
        "_log" | "_wood" | "_stem" | "_hyphae" | "_block" | "_roots" => Some(bark),
        "_leaves" | "_sapling" | "_propagule" | "" => Some(leaves),
        _ if SUFFIXES.contains(&rest) => Some(planks),
        _ => None,
    }
}

/// The colour of a name without some of its first or last words, as few as can be.
fn without_words(name: &str) -> Option<u32> {
    let known = |name: &str| {
        let spelled = [name.to_owned(), format!("{name}s"), format!("{name}_block"), format!("{name}_planks")];
        spelled.iter().find_map(|name| own_color(name).or_else(|| dyed(name)).or_else(|| wooden(name)))
    };
    let mut names = vec![name];
    for _ in 0..MOST_WORDS {
        let shorter = |name| {
            let without_first = PREFIXES.iter().filter_map(move |prefix| str::strip_prefix(name, prefix));
            without_first.chain(SUFFIXES.iter().filter_map(move |suffix| str::strip_suffix(name, suffix)))
        };
        names = names.into_iter().flat_map(shorter).collect();
        if let Some(color) = names.iter().find_map(|name| known(name)) {
            return Some(color);
        }
    }
    None
}

/// `share` hundredths of the way from one colour to another.
fn mixed(from: u32, to: u32, share: u32) -> u32 {
    let channel = |shift: u32| {
        let (a, b) = (from >> shift & 0xff, to >> shift & 0xff);
        ((a * (100 - share) + b * share) / 100) << shift
    };
    channel(16) | channel(8) | channel(0)
}

/// A colour that is always the same for a name: its hash (FNV-1a) as a middling shade.
fn color_of_letters(name: &str) -> u32 {
    let hash = name.bytes().fold(0x811c_9dc5u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
    // Between 0x40 and 0xbf each: neither black nor white.
    (hash & 0x7f_7f7f) + 0x40_4040
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(name: &str) -> Look {
        match block(name, false) {
            Block::Known(look) => look,
            other => panic!("{name}: {other:?}"),
        }
    }

    #[test]
    fn what_is_made_of_something_has_its_colour() {
        for (made, of) in [
            ("oak_stairs", "oak_planks"),
            ("dark_oak_fence_gate", "dark_oak_planks"),
            ("stripped_spruce_log", "stripped_spruce_wood"),
            ("stone_brick_stairs", "stone_bricks"),
            ("polished_blackstone_brick_wall", "polished_blackstone_bricks"),
            ("cobblestone_wall", "cobblestone"),
            ("infested_cracked_stone_bricks", "stone_bricks"),
            ("waxed_exposed_cut_copper_slab", "exposed_copper"),
            ("smooth_red_sandstone_stairs", "red_sandstone"),
            ("quartz_pillar", "quartz_block"),
            ("purpur_slab", "purpur_block"),
            ("deepslate_tile_slab", "deepslate_tiles"),
            ("mossy_cobblestone_slab", "mossy_cobblestone"),
            ("red_wool", "red_carpet"),
            ("light_blue_bed", "light_blue_wool"),
            ("potted_red_tulip", "red_tulip"),
            ("birch_wall_hanging_sign", "birch_planks"),
            ("warped_fungus", "potted_warped_fungus"),
            ("chiseled_nether_bricks", "nether_brick_fence"),
            ("end_stone_brick_wall", "end_stone_bricks"),
            ("glass_pane", "glass"),
            ("tube_coral_wall_fan", "tube_coral_block"),
        ] {
            assert_eq!(look(made).color, look(of).color, "{made}");
        }
    }

    #[test]
    fn words_that_begin_alike_are_told_apart() {
        for (one, other) in [
            ("blue_wool", "light_blue_wool"),
            ("oak_planks", "dark_oak_planks"),
            ("oak_log", "oak_planks"),
            ("oak_log", "stripped_oak_log"),
            ("gray_concrete", "light_gray_concrete"),
            ("red_sand", "red_wool"),
            ("red_terracotta", "red_concrete"),
            ("red_mushroom", "red_tulip"),
            ("stone", "stone_bricks"),
            ("sandstone", "stone"),
            ("grass_block", "dirt"),
            ("red_nether_bricks", "nether_bricks"),
        ] {
            assert_ne!(look(one).color, look(other).color, "{one} {other}");
        }
    }

    #[test]
    fn air_is_empty_lamps_glow_when_lit_and_glass_lets_light_through() {
        for unseen in ["air", "cave_air", "void_air", "structure_void", "barrier", "light"] {
            assert_eq!(block(unseen, false), Block::Unseen);
        }
        assert!(look("glowstone").material(1.0).is_emissive() && look("wall_torch").light == look("torch").light);
        assert!(look("soul_wall_torch").light > 0 && look("lava").light == 15 && look("stone").light == 0);
        assert_eq!(look("redstone_lamp").light, 0);
        assert!(matches!(block("redstone_lamp", true), Block::Known(Look { light: 15, .. })));
        assert!(matches!(block("waxed_oxidized_copper_bulb", true), Block::Known(Look { light: 15, .. })));
        assert!(look("white_stained_glass_pane").material(1.0).transmission > 0.5);
        assert!(look("water").material(1.0).transmission > 0.5 && look("stone").material(1.0).transmission == 0.0);
    }

    #[test]
    fn metals_are_metallic_and_copper_is_so_waxed_cut_and_at_any_age() {
        for metal in [
            "iron_block",
            "gold_block",
            "chain",
            "iron_chain",
            "damaged_anvil",
            "copper_block",
            "cut_copper_stairs",
            "chiseled_copper",
            "waxed_copper_block",
            "waxed_weathered_cut_copper_slab",
            "exposed_copper_grate",
            "oxidized_copper",
            "waxed_oxidized_lightning_rod",
        ] {
            assert_eq!(look(metal).material(1.0).metallic, 1.0, "{metal}");
        }
        for other in ["iron_ore", "deepslate_copper_ore", "raw_copper_block", "raw_iron_block", "chain_command_block"] {
            assert_eq!(look(other).material(1.0).metallic, 0.0, "{other}");
        }
    }

    #[test]
    fn blocks_of_the_newest_versions_have_colours() {
        for (made, of) in [
            ("polished_cinnabar_stairs", "cinnabar"),
            ("cinnabar_brick_wall", "cinnabar_bricks"),
            ("sulfur_brick_slab", "sulfur_bricks"),
            ("poplar_stairs", "poplar_planks"),
            ("stripped_poplar_wood", "stripped_poplar_log"),
        ] {
            assert_eq!(look(made).color, look(of).color, "{made}");
        }
        assert_ne!(look("red_poplar_leaves").color, look("yellow_poplar_leaves").color);
        assert_ne!(look("poplar_log").color, look("poplar_planks").color);
    }

    #[test]
    fn unknown_names_have_a_colour_that_stays() {
        let Block::Unknown(first) = block("create_gearbox", false) else { panic!() };
        assert_eq!(block("create_gearbox", false), Block::Unknown(first));
        assert_ne!(block("create_gearbox_2", false), Block::Unknown(first));
        assert_eq!(first.color, 0x4e5dbe, "a change of this colour changes pictures: {:x}", first.color);
    }
}
