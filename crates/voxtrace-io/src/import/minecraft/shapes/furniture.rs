//! What rooms are furnished with: beds, chests, signs, anvils, cauldrons, hoppers, lecterns and the like.

use super::super::state::State;
use super::{Part, Shape, made_of, part, pillar, pointed, turned};

const WOOD: &str = "oak_planks";
const STONE: &str = "smooth_stone";

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let facing = state.get("facing").unwrap_or("north");
    let parts = if name.ends_with("_bed") || name == "bed" {
        turned(bed(name, state), facing)
    } else if name.ends_with("chest") {
        turned(chest(state), facing)
    } else if name.ends_with("_wall_hanging_sign") {
        let mut parts = hanging_sign();
        parts.push(part([0, 14, 6], [16, 16, 10]));
        turned(parts, facing)
    } else if name.ends_with("_hanging_sign") {
        turned(hanging_sign(), SIXTEENTHS[nearest_quarter(state)])
    } else if name.ends_with("wall_sign") {
        turned(vec![part([0, 4, 14], [16, 12, 16]).averaged()], facing)
    } else if name.ends_with("_sign") || name == "sign" {
        turned(
            vec![part([0, 8, 7], [16, 16, 9]).averaged(), part([7, 0, 7], [9, 8, 9]).averaged()],
            SIXTEENTHS[nearest_quarter(state)],
        )
    } else if name.ends_with("wall_banner") {
        turned(vec![part([1, 0, 14], [15, 14, 16]).averaged(), part([1, 14, 14], [15, 16, 16]).of(WOOD)], facing)
    } else if name.ends_with("_banner") {
        let parts = vec![part([1, 4, 6], [15, 16, 7]).averaged(), part([7, 0, 7], [9, 16, 9]).of(WOOD).averaged()];
        turned(parts, SIXTEENTHS[nearest_quarter(state)])
    } else if name.ends_with("anvil") {
        anvil(facing)
    } else if name.ends_with("cauldron") {
        cauldron(name, state)
    } else {
        return single(name, state, facing);
    };
    Some(Shape::Parts(parts))
}

/// What has no relatives.
fn single(name: &str, state: &State, facing: &str) -> Option<Shape> {
    let parts = match name {
        "hopper" => hopper(facing),
        "lectern" => turned(lectern(), facing),
        "enchanting_table" => vec![part([0, 0, 0], [16, 12, 16]), part([4, 12, 5], [12, 14, 11]).colored(0x8a4a2a)],
        "brewing_stand" => vec![
            pillar(2, 0, 14).colored(0xd9a53a),
            part([9, 0, 5], [15, 2, 11]).of(STONE),
            part([1, 0, 1], [7, 2, 7]).of(STONE),
            part([1, 0, 9], [7, 2, 15]).of(STONE),
        ],
        "end_portal_frame" => {
            let mut parts = vec![part([0, 0, 0], [16, 13, 16])];
            if state.is("eye", "true") {
                parts.push(part([4, 13, 4], [12, 16, 12]).colored(0x2f6a50));
            }
            parts
        }
        "composter" => {
            let level = state.number("level", 0).clamp(0, 8);
            let mut parts = tub(2, 0, 2);
            if level > 0 {
                parts.push(part([2, 2, 2], [14, (level * 2).min(14) + 1, 14]).colored(0x5c4a2a));
            }
            parts
        }
        "stonecutter" => {
            let parts = vec![part([0, 0, 0], [16, 9, 16]), part([1, 9, 8], [15, 16, 9]).colored(0xb8b8b8)];
            turned(parts, facing)
        }
        "grindstone" => grindstone(state, facing),
        "bell" => bell(state, facing),
        "campfire" | "soul_campfire" => campfire(name, state, facing),
        "scaffolding" => {
            let mut parts = vec![part([0, 14, 0], [16, 16, 16])];
            for (x, z) in [(0, 0), (14, 0), (0, 14), (14, 14)] {
                parts.push(part([x, 0, z], [x + 2, 14, z + 2]));
            }
            if state.is("bottom", "true") {
                parts.push(part([0, 0, 0], [16, 2, 16]));
            }
            parts
        }
        "decorated_pot" => vec![pillar(14, 0, 16)],
        "flower_pot" => pot(None),
        _ if name.starts_with("potted_") => pot(name.strip_prefix("potted_")),
        _ if name.ends_with("_shelf") => turned(
            vec![part([0, 0, 13], [16, 16, 16]), part([0, 12, 11], [16, 16, 13]), part([0, 0, 11], [16, 4, 13])],
            facing,
        ),
        _ => return None,
    };
    Some(Shape::Parts(parts))
}

/// Facings by quarters; a sign says sixteenths of a turn from south.
const SIXTEENTHS: [&str; 4] = ["south", "west", "north", "east"];

fn nearest_quarter(state: &State) -> usize {
    (((state.number("rotation", 0).rem_euclid(16) + 2) / 4) % 4) as usize
}

/// Four walls so thick on a floor, open above.
fn tub(wall: i32, bottom: i32, floor: i32) -> Vec<Part> {
    let (low, high) = (wall, 16 - wall);
    vec![
        part([0, bottom, 0], [16, bottom + floor, 16]),
        part([0, bottom + floor, 0], [16, 16, low]),
        part([0, bottom + floor, high], [16, 16, 16]),
        part([0, bottom + floor, low], [low, 16, high]),
        part([high, bottom + floor, low], [16, 16, high]),
    ]
}

/// The head is where it faces; legs are at the ends.
fn bed(name: &str, state: &State) -> Vec<Part> {
    let is_head = state.is("part", "head");
    let wool = made_of(name, "_bed").map_or("red_wool".into(), |dye| format!("{dye}_wool"));
    let mut parts =
        vec![part([0, 5, 0], [16, 9, 16]).of(wool).averaged(), part([0, 3, 0], [16, 5, 16]).of(WOOD).averaged()];
    if is_head {
        parts.insert(0, part([1, 8, 1], [15, 9, 7]).colored(0xe6e6e6));
    }
    let z = if is_head { 0 } else { 13 };
    parts.extend([0, 13].map(|x| part([x, 0, z], [x + 3, 3, z + 3]).of(WOOD).averaged()));
    parts
}

/// The half of a large one goes on where its other half is, to the right of who looks at a left one.
fn chest(state: &State) -> Vec<Part> {
    let (low, high) = match state.get("type") {
        Some("left") => (1, 16),
        Some("right") => (0, 15),
        _ => (1, 15),
    };
    let middle = match state.get("type") {
        Some("left") => 15..16,
        Some("right") => 0..1,
        _ => 7..9,
    };
    vec![
        part([middle.start, 7, 0], [middle.end, 11, 1]).colored(0x8a8a8a),
        part([low, 9, 1], [high, 10, 15]).colored(0x33261a),
        part([low, 0, 1], [high, 14, 15]).averaged(),
    ]
}

fn hanging_sign() -> Vec<Part> {
    let chain = |x: i32| part([x, 10, 7], [x + 2, 16, 9]).colored(0x333a4a);
    vec![part([1, 0, 7], [15, 10, 9]).averaged(), chain(2), chain(12)]
}

/// Its long side lies across where it faces.
fn anvil(facing: &str) -> Vec<Part> {
    let parts = vec![
        part([2, 0, 2], [14, 4, 14]),
        part([4, 4, 3], [12, 5, 13]),
        part([6, 5, 4], [10, 10, 12]),
        part([3, 10, 0], [13, 16, 16]),
    ];
    turned(parts, facing)
}

fn cauldron(name: &str, state: &State) -> Vec<Part> {
    let mut parts = tub(2, 3, 1);
    for (x, z) in [(0, 0), (12, 0), (0, 12), (12, 12)] {
        parts.push(part([x, 0, z], [x + 4, 3, z + 4]));
    }
    let parts_of_iron = parts.into_iter().map(|part| part.of("cauldron"));
    let mut parts: Vec<Part> = parts_of_iron.collect();
    let content = match name {
        "water_cauldron" => Some(("water", 6 + 3 * state.number("level", 3).clamp(1, 3))),
        "powder_snow_cauldron" => Some(("powder_snow", 6 + 3 * state.number("level", 3).clamp(1, 3))),
        "lava_cauldron" => Some(("lava", 15)),
        _ => None,
    };
    if let Some((of, top)) = content {
        parts.push(part([2, 4, 2], [14, top, 14]).of(of));
    }
    parts
}

fn hopper(facing: &str) -> Vec<Part> {
    let mut parts = tub(2, 10, 1);
    parts.push(part([4, 4, 4], [12, 10, 12]));
    if matches!(facing, "north" | "east" | "south" | "west") {
        parts.extend(turned(vec![part([6, 4, 0], [10, 8, 4])], facing));
    } else {
        parts.push(part([6, 0, 6], [10, 4, 10]));
    }
    parts
}

/// Its board rises away from who reads.
fn lectern() -> Vec<Part> {
    let mut parts = vec![part([0, 0, 0], [16, 2, 16]), part([4, 2, 4], [12, 14, 12])];
    for step in 0..4 {
        let (z, y) = (1 + 4 * step, 11 + step);
        parts.push(part([0, y, z], [16, y + 3, (z + 4).min(16)]).averaged());
    }
    parts
}

fn grindstone(state: &State, facing: &str) -> Vec<Part> {
    let mut parts = vec![part([4, 4, 2], [12, 16, 14]).of(STONE)];
    for x in [2, 12] {
        parts.push(part([x, 7, 5], [x + 2, 13, 11]).of("dark_oak_planks"));
        parts.push(part([x, 0, 6], [x + 2, 7, 10]).of("dark_oak_planks"));
    }
    match state.get("face") {
        Some("ceiling") => turned(parts.into_iter().map(Part::flipped).collect(), facing),
        Some("wall") => pointed(parts, facing),
        _ => turned(parts, facing),
    }
}

fn bell(state: &State, facing: &str) -> Vec<Part> {
    let gold = |part: Part| part.colored(0xf0cf4a);
    let mut parts = vec![gold(part([5, 6, 5], [11, 13, 11])), gold(part([4, 4, 4], [12, 6, 12]))];
    let bar = |from: [i32; 3], to: [i32; 3]| part(from, to).of("dark_oak_planks");
    let rest = match state.get("attachment") {
        Some("ceiling") => vec![bar([7, 13, 7], [9, 16, 9])],
        Some("single_wall") => vec![bar([7, 13, 0], [9, 15, 13])],
        Some("double_wall") => vec![bar([7, 13, 0], [9, 15, 16])],
        _ => vec![
            bar([2, 13, 7], [14, 15, 9]),
            part([0, 0, 4], [2, 16, 12]).of("stone"),
            part([14, 0, 4], [16, 16, 12]).of("stone"),
        ],
    };
    parts.extend(rest);
    turned(parts, facing)
}

fn campfire(name: &str, state: &State, facing: &str) -> Vec<Part> {
    let log = |from: [i32; 3], to: [i32; 3]| part(from, to).of("oak_log").averaged();
    let mut parts = vec![
        log([1, 0, 0], [5, 4, 16]),
        log([11, 0, 0], [15, 4, 16]),
        log([0, 3, 1], [16, 7, 5]),
        log([0, 3, 11], [16, 7, 15]),
        part([5, 0, 1], [11, 1, 15]).colored(0x3a3330),
    ];
    if !state.is("lit", "false") {
        let flame = if name == "campfire" { 0xf5a032 } else { 0x40c8d8 };
        parts.extend([
            part([5, 1, 5], [11, 4, 11]).glowing(flame),
            part([6, 4, 6], [10, 9, 10]).glowing(flame),
            part([7, 9, 7], [9, 13, 9]).glowing(flame),
        ]);
    }
    turned(parts, facing)
}

fn pot(plant: Option<&str>) -> Vec<Part> {
    let clay = |from: [i32; 3], to: [i32; 3]| part(from, to).of("flower_pot").averaged();
    let mut parts = vec![
        clay([5, 0, 5], [11, 6, 6]),
        clay([5, 0, 10], [11, 6, 11]),
        clay([5, 0, 6], [6, 6, 10]),
        clay([10, 0, 6], [11, 6, 10]),
        part([6, 0, 6], [10, 4, 10]).of("dirt"),
    ];
    match plant {
        None => {}
        Some("cactus") => parts.push(pillar(4, 4, 16).of("cactus").averaged()),
        Some(plant) => parts.extend([
            pillar(2, 4, 10).colored(0x4a7a28),
            pillar(6, 10, 14).of(plant).averaged(),
            pillar(4, 14, 16).of(plant).averaged(),
        ]),
    }
    parts
}
