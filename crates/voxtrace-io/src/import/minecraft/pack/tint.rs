//! Grey pictures that the game colours by the biome: here all stand in the plains.

pub(super) const GRASS: u32 = 0x91bd59;
const FOLIAGE: u32 = 0x77ab2f;
const BIRCH: u32 = 0x80a755;
const SPRUCE: u32 = 0x619961;
const WATER: u32 = 0x3f76e4;
const LILY_PAD: u32 = 0x208030;
const STEM: u32 = 0x9fae2c;

/// The tint of a picture on a block; `None` where it has its own colours.
pub(super) fn of(picture: &str, block: &str) -> Option<u32> {
    Some(match block {
        "grass_block" if picture == "grass_block_top" => GRASS,
        "grass" | "short_grass" | "tall_grass" | "fern" | "large_fern" | "sugar_cane" | "bush" | "potted_fern" => GRASS,
        "oak_leaves" | "jungle_leaves" | "acacia_leaves" | "dark_oak_leaves" | "mangrove_leaves" | "vine" => FOLIAGE,
        "birch_leaves" => BIRCH,
        "spruce_leaves" => SPRUCE,
        "water" | "bubble_column" => WATER,
        "lily_pad" => LILY_PAD,
        "melon_stem" | "pumpkin_stem" => STEM,
        _ => return None,
    })
}
