//! What grows: crossed planes, vines, crops, cactus, bamboo, corals, lily pads.

use super::super::state::State;
use super::building::{SIDES, goes_on};
use super::{Part, Shape, Sprout, part, pillar, pointed, turned};

const STEM: u32 = 0x4f7a2c;

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let facing = state.get("facing").unwrap_or("north");
    if name.ends_with("_leaves") || name == "leaves" {
        return Some(Shape::Leaves);
    }
    if let Some(sprout) = crossed(name, state) {
        return Some(Shape::Crossed(sprout, Vec::new()));
    }
    let parts = match name {
        "vine" | "glow_lichen" | "sculk_vein" | "resin_clump" => sheets(state),
        "cactus" => vec![part([1, 0, 1], [15, 16, 15])],
        "cactus_flower" => vec![pillar(10, 0, 3), pillar(14, 3, 6)],
        "lily_pad" => vec![part([1, 0, 1], [15, 1, 7]), part([1, 0, 9], [15, 1, 15]), part([1, 0, 7], [8, 1, 9])],
        "frogspawn" => vec![part([1, 0, 1], [15, 1, 15])],
        "pink_petals" | "wildflowers" | "leaf_litter" => turned(petals(name, state), facing),
        "sea_pickle" => {
            let places = [[6, 6, 6], [2, 10, 5], [10, 9, 6], [9, 2, 7]];
            let count = state.number("pickles", 1).clamp(1, 4) as usize;
            places.into_iter().take(count).map(|[x, z, top]| part([x, 0, z], [x + 4, top, z + 4])).collect()
        }
        "bamboo" => vec![pillar(2, 0, 16).of("bamboo_block")],
        "cocoa" => turned(cocoa(state), facing),
        "chorus_plant" => chorus(state),
        "chorus_flower" => vec![
            part([2, 2, 2], [14, 14, 14]),
            part([0, 4, 4], [16, 12, 12]),
            part([4, 4, 0], [12, 12, 16]),
            part([4, 0, 4], [12, 16, 12]),
        ],
        "azalea" | "flowering_azalea" => vec![part([0, 8, 0], [16, 16, 16]), pillar(2, 0, 8).colored(0x6a5038)],
        "big_dripleaf" => turned(big_dripleaf(state), facing),
        "big_dripleaf_stem" => turned(vec![part([6, 0, 9], [10, 16, 13])], facing),
        "small_dripleaf" if state.is("half", "lower") => vec![pillar(2, 0, 16)],
        "small_dripleaf" => vec![pillar(2, 0, 8), part([1, 8, 1], [8, 9, 8]), part([8, 11, 8], [15, 12, 15])],
        "spore_blossom" => vec![part([1, 15, 1], [15, 16, 15]), pillar(6, 12, 15), pillar(2, 9, 12).colored(0xd9b34a)],
        "pointed_dripstone" => dripstone(state),
        "tripwire" => return None,
        _ if name.ends_with("_coral_wall_fan") => turned(vec![part([0, 6, 4], [16, 8, 16])], facing),
        _ if name.ends_with("_coral_fan") => vec![part([2, 0, 2], [14, 4, 14])],
        "attached_melon_stem" | "attached_pumpkin_stem" => {
            turned(vec![pillar(2, 0, 10).colored(STEM), part([7, 8, 0], [9, 10, 7]).colored(STEM)], facing)
        }
        _ => return None,
    };
    Some(Shape::Parts(parts))
}

/// How plants of two crossed planes grow; `None` for others.
fn crossed(name: &str, state: &State) -> Option<Sprout> {
    let age = |most: i32| state.number("age", most).clamp(0, most);
    Some(match name {
        "wheat" => Sprout::Crop(2 + 14 * age(7) / 7),
        "carrots" | "potatoes" => Sprout::Crop(2 + 8 * age(7) / 7),
        "beetroots" => Sprout::Crop(2 + 8 * age(3) / 3),
        "torchflower_crop" => Sprout::Crop(4 + 8 * age(1)),
        "pitcher_crop" => Sprout::Crop(4 + 3 * age(4)),
        "nether_wart" => Sprout::Crop(5 + 8 * age(3) / 3),
        "melon_stem" | "pumpkin_stem" => Sprout::Crop(2 + 12 * age(7) / 7),
        "sweet_berry_bush" => Sprout::Crop(8 + 8 * age(3) / 3),
        "cobweb" | "sugar_cane" | "kelp" | "kelp_plant" | "pale_hanging_moss" | "hanging_roots" => Sprout::Web,
        "fire" | "soul_fire" => Sprout::Flame,
        "brown_mushroom" | "red_mushroom" | "crimson_fungus" | "warped_fungus" => Sprout::Mushroom,
        "grass" | "short_grass" | "tall_grass" | "fern" | "large_fern" | "seagrass" | "tall_seagrass" | "dead_bush"
        | "crimson_roots" | "warped_roots" | "nether_sprouts" | "short_dry_grass" | "tall_dry_grass" | "bush"
        | "firefly_bush" | "double_plant" | "mangrove_propagule" => Sprout::Blades,
        "bamboo_sapling" => Sprout::Crop(10),
        "dandelion" | "poppy" | "blue_orchid" | "allium" | "azure_bluet" | "oxeye_daisy" | "cornflower"
        | "lily_of_the_valley" | "wither_rose" | "torchflower" | "sunflower" | "lilac" | "rose_bush" | "peony"
        | "pitcher_plant" | "open_eyeblossom" | "closed_eyeblossom" => {
            // The blossom of a tall one is above.
            if state.is("half", "lower") { Sprout::Blades } else { Sprout::Blossom }
        }
        _ if name.ends_with("_tulip") => Sprout::Blossom,
        _ if name.ends_with("_sapling") => Sprout::Sapling,
        _ if name.ends_with("_coral") => Sprout::Blades,
        _ if name.contains("vines") => Sprout::Web,
        _ => return None,
    })
}

/// On each side that the state says, a sheet.
fn sheets(state: &State) -> Vec<Part> {
    let mut parts: Vec<Part> = SIDES
        .into_iter()
        .filter(|side| goes_on(state, side))
        .flat_map(|side| turned(vec![part([0, 0, 0], [16, 16, 1])], side))
        .collect();
    if goes_on(state, "up") {
        parts.push(part([0, 15, 0], [16, 16, 16]));
    }
    if goes_on(state, "down") {
        parts.push(part([0, 0, 0], [16, 1, 16]));
    }
    if parts.is_empty() {
        parts.push(part([0, 0, 15], [16, 16, 16]));
    }
    parts
}

/// One to four quarters of the ground.
fn petals(name: &str, state: &State) -> Vec<Part> {
    let amount = state.number(if name == "leaf_litter" { "segment_amount" } else { "flower_amount" }, 1).clamp(1, 4);
    let quarters = [[0, 0], [0, 8], [8, 8], [8, 0]];
    let height = if name == "leaf_litter" { 1 } else { 3 };
    let quarter = |[x, z]: [i32; 2]| {
        [[1, 1], [4, 4], [1, 5]].map(|[dx, dz]| {
            let (x, z) = (x + dx, z + dz);
            part([x, height - 1, z], [x + 3, height, z + 3])
        })
    };
    quarters.into_iter().take(amount as usize).flat_map(quarter).collect()
}

fn cocoa(state: &State) -> Vec<Part> {
    let age = state.number("age", 2).clamp(0, 2);
    let (width, bottom) = (4 + 2 * age, 7 - 2 * age);
    let low = 8 - width / 2;
    // It hangs on the log that it faces.
    vec![part([low, bottom, 1], [low + width, 12, 1 + width]), part([7, 12, 0], [9, 16, 3]).colored(STEM)]
}

fn chorus(state: &State) -> Vec<Part> {
    let mut parts = vec![part([4, 4, 4], [12, 12, 12])];
    for side in SIDES.into_iter().filter(|side| goes_on(state, side)) {
        parts.extend(turned(vec![part([4, 4, 0], [12, 12, 4])], side));
    }
    if goes_on(state, "up") {
        parts.push(pillar(8, 12, 16));
    }
    if goes_on(state, "down") {
        parts.push(pillar(8, 0, 4));
    }
    parts
}

fn big_dripleaf(state: &State) -> Vec<Part> {
    let top = match state.get("tilt") {
        Some("full") => return vec![part([6, 0, 9], [10, 15, 13])],
        Some("partial") => 13,
        _ => 15,
    };
    vec![part([0, top - 4, 0], [16, top, 16]), part([6, 0, 9], [10, top - 4, 13])]
}

/// Thinner towards its tip.
fn dripstone(state: &State) -> Vec<Part> {
    let parts = match state.get("thickness") {
        Some("tip_merge") => vec![pillar(6, 0, 16)],
        Some("frustum") => vec![pillar(8, 0, 16)],
        Some("middle") => vec![pillar(10, 0, 16)],
        Some("base") => vec![pillar(12, 0, 16)],
        _ => vec![pillar(6, 0, 5), pillar(4, 5, 9), pillar(2, 9, 11)],
    };
    if state.is("vertical_direction", "down") { pointed(parts, "down") } else { parts }
}
