//! The blocks of old files (before 1.13): a number from 0 to 255 and four bits of data become a name of today.

use super::legacy_names::NAMES;

/// The dyes in the order of their data.
const DYES: [&str; 16] = [
    "white",
    "orange",
    "magenta",
    "light_blue",
    "yellow",
    "lime",
    "pink",
    "gray",
    "light_gray",
    "cyan",
    "purple",
    "blue",
    "brown",
    "green",
    "red",
    "black",
];
const WOODS: [&str; 6] = ["oak", "spruce", "birch", "jungle", "acacia", "dark_oak"];
const STONES: [&str; 7] =
    ["stone", "granite", "polished_granite", "diorite", "polished_diorite", "andesite", "polished_andesite"];
const SLABS: [&str; 8] = [
    "smooth_stone_slab",
    "sandstone_slab",
    "oak_slab",
    "cobblestone_slab",
    "brick_slab",
    "stone_brick_slab",
    "nether_brick_slab",
    "quartz_slab",
];
const FLOWERS: [&str; 9] = [
    "poppy",
    "blue_orchid",
    "allium",
    "azure_bluet",
    "red_tulip",
    "orange_tulip",
    "white_tulip",
    "pink_tulip",
    "oxeye_daisy",
];
const PLANTS: [&str; 6] = ["sunflower", "lilac", "tall_grass", "large_fern", "rose_bush", "peony"];

/// The name of a block of old files, and whether it is lit. `data` is below 16.
pub(super) fn name(id: u8, data: u8) -> (String, bool) {
    let variant = usize::from(data);
    let dye = DYES[variant % 16];
    // Two bits of wood; what else is there says how a log lies or a leaf withers.
    let wood = WOODS[variant % 4];
    let newer = WOODS[4 + variant % 2];
    let name = match id {
        1 => STONES[variant % 7].into(),
        3 => ["dirt", "coarse_dirt", "podzol"].get(variant).copied().unwrap_or("dirt").into(),
        5 => format!("{}_planks", WOODS[variant % 6]),
        6 => format!("{}_sapling", WOODS[variant % 8 % 6]),
        12 if variant == 1 => "red_sand".into(),
        17 => format!("{wood}_log"),
        18 => format!("{wood}_leaves"),
        19 if variant == 1 => "wet_sponge".into(),
        31 if variant == 0 => "dead_bush".into(),
        31 if variant == 2 => "fern".into(),
        35 => format!("{dye}_wool"),
        38 => FLOWERS[variant % 9].into(),
        43 | 44 => SLABS[variant % 8].into(),
        95 => format!("{dye}_stained_glass"),
        97 if variant == 1 => "infested_cobblestone".into(),
        97 if variant > 1 => "infested_stone_bricks".into(),
        98 if variant == 1 => "mossy_stone_bricks".into(),
        125 | 126 => format!("{}_slab", WOODS[variant % 8 % 6]),
        139 if variant == 1 => "mossy_cobblestone_wall".into(),
        159 => format!("{dye}_terracotta"),
        160 => format!("{dye}_stained_glass_pane"),
        161 => format!("{newer}_leaves"),
        162 => format!("{newer}_log"),
        168 => ["prismarine", "prismarine_bricks", "dark_prismarine"][variant % 3].into(),
        171 => format!("{dye}_carpet"),
        175 => PLANTS[variant % 8 % 6].into(),
        251 => format!("{dye}_concrete"),
        252 => format!("{dye}_concrete_powder"),
        _ => NAMES[usize::from(id)].into(),
    };
    match name.strip_prefix("lit_") {
        Some(lit) => (lit.into(), true),
        None => (name, false),
    }
}

#[cfg(test)]
mod tests {
    use super::super::blocks::{Block, block};
    use super::*;

    #[test]
    fn every_number_but_the_two_unused_ones_has_a_known_look() {
        for id in 0..=255 {
            for data in 0..16 {
                let (name, is_lit) = name(id, data);
                let is_known = !matches!(block(&name, is_lit), Block::Unknown(_));
                assert_eq!(is_known, ![253, 254].contains(&id), "{id}:{data} {name}");
            }
        }
    }

    #[test]
    fn numbers_and_data_give_the_names_that_the_game_gave_them() {
        for (id, data, wanted) in [
            (0, 0, "air"),
            (1, 5, "andesite"),
            (5, 5, "dark_oak_planks"),
            (17, 2 | 4, "birch_log"),
            (29, 1, "sticky_piston"),
            (33, 1, "piston"),
            (35, 14, "red_wool"),
            (44, 3 | 8, "cobblestone_slab"),
            (53, 7, "oak_stairs"),
            (98, 1, "mossy_stone_bricks"),
            (112, 0, "nether_bricks"),
            (155, 2, "quartz_block"),
            (157, 0, "activator_rail"),
            (160, 4, "yellow_stained_glass_pane"),
            (162, 1, "dark_oak_log"),
            (172, 0, "terracotta"),
            (206, 0, "end_stone_bricks"),
            (219, 0, "white_shulker_box"),
            (251, 15, "black_concrete"),
            (255, 0, "structure_block"),
        ] {
            assert_eq!(name(id, data).0, wanted, "{id}:{data}");
        }
        assert_eq!((name(62, 0), name(124, 0)), (("furnace".into(), true), ("redstone_lamp".into(), true)));
    }
}
