//! Small things: torches, lanterns, chains, candles, heads, rods, eggs, cakes.

use super::super::state::State;
use super::{Part, Shape, made_of, part, pillar, pointed, turned};

/// Flames of candles and torches.
const FLAME: u32 = 0xffd98a;

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let facing = state.get("facing").unwrap_or("north");
    let parts = if name.ends_with("wall_torch") {
        turned(wall_torch(name, state), facing)
    } else if name.ends_with("torch") {
        let stick = pillar(2, 0, 8).of("oak_planks").averaged();
        vec![stick, flame(name, state, pillar(2, 8, 10))]
    } else if name.ends_with("lantern") && !matches!(name, "sea_lantern" | "jack_o_lantern") {
        lantern(state)
    } else if name == "chain" || name.ends_with("_chain") {
        chain(state.get("axis").unwrap_or("y"))
    } else if name.ends_with("candle_cake") {
        let mut parts = cake(0);
        let wax = made_of(name, "_cake").unwrap_or_default();
        parts.push(pillar(2, 8, 14).of(wax).averaged());
        parts.extend(wick(state, 7, 14, 7));
        parts
    } else if name == "candle" || name.ends_with("_candle") {
        candles(name, state)
    } else if name.ends_with("wall_head") || name.ends_with("wall_skull") {
        turned(vec![part([4, 4, 8], [12, 12, 16]).averaged()], facing)
    } else if name.ends_with("_head") && name != "piston_head" || name.ends_with("_skull") || name == "skull" {
        vec![pillar(8, 0, 8).averaged()]
    } else if name.ends_with("_cluster") || name.ends_with("_bud") {
        crystal(name, facing)
    } else if name.ends_with("lightning_rod") {
        pointed(vec![pillar(2, 0, 12), pillar(4, 12, 16)], facing)
    } else if name.ends_with("_golem_statue") {
        vec![pillar(8, 0, 8), pillar(10, 8, 14)]
    } else {
        return single(name, state, facing);
    };
    Some(Shape::Parts(parts))
}

fn single(name: &str, state: &State, facing: &str) -> Option<Shape> {
    let parts = match name {
        "end_rod" => pointed(vec![pillar(4, 0, 1).colored(0x8a7a8a), pillar(2, 1, 16)], facing),
        "cake" => cake(state.number("bites", 0).clamp(0, 6)),
        "conduit" => vec![pillar(6, 5, 11)],
        "heavy_core" => vec![pillar(8, 0, 8)],
        "dragon_egg" => [(12, 0, 1), (14, 1, 8), (12, 8, 11), (8, 11, 14), (4, 14, 16)]
            .map(|(width, bottom, top)| pillar(width, bottom, top))
            .to_vec(),
        "sniffer_egg" => vec![part([1, 0, 2], [15, 16, 14])],
        "turtle_egg" => {
            let eggs =
                [([5, 0, 4], [9, 7, 8]), ([1, 0, 7], [4, 5, 10]), ([11, 0, 7], [14, 4, 10]), ([6, 0, 10], [9, 4, 13])];
            let count = state.number("eggs", 1).clamp(1, 4) as usize;
            eggs.into_iter().take(count).map(|(from, to)| part(from, to)).collect()
        }
        "dried_ghast" => vec![pillar(10, 0, 10)],
        "honey_block" => vec![part([1, 0, 1], [15, 15, 15])],
        "nether_portal" => vec![part([0, 0, 6], [16, 16, 10])]
            .into_iter()
            .map(|part| if state.is("axis", "z") { part.quarter() } else { part })
            .collect(),
        "end_portal" => vec![part([0, 6, 0], [16, 12, 16])],
        _ => return None,
    };
    Some(Shape::Parts(parts))
}

fn flame(name: &str, state: &State, tip: Part) -> Part {
    if name.starts_with("redstone") && state.is("lit", "false") {
        return tip.colored(0x5a1a14);
    }
    tip.glowing(match name {
        _ if name.starts_with("redstone") => 0xe03020,
        _ if name.starts_with("soul") => 0x7adfe2,
        _ if name.starts_with("copper") => 0x8fe0a0,
        _ => FLAME,
    })
}

/// It leans away from the wall behind it.
fn wall_torch(name: &str, state: &State) -> Vec<Part> {
    let stick = |y: i32, z: i32| part([7, y, z], [9, y + 3, z + 2]).of("oak_planks").averaged();
    let tip = flame(name, state, part([7, 11, 11], [9, 13, 13]));
    vec![tip, stick(3, 14), stick(5, 13), stick(8, 12)]
}

fn lantern(state: &State) -> Vec<Part> {
    let iron = |part: Part| part.colored(0x3a3f4a);
    let mut parts = vec![pillar(4, 1, 6), iron(pillar(6, 0, 1)), iron(pillar(6, 6, 7)), iron(pillar(4, 7, 9))];
    for (x, z) in [(5, 5), (10, 5), (5, 10), (10, 10)] {
        parts.push(iron(part([x, 1, z], [x + 1, 6, z + 1])));
    }
    parts.push(part([5, 1, 5], [11, 6, 11]));
    if state.is("hanging", "true") {
        parts = parts.into_iter().map(|part| part.moved([0, 1, 0])).collect();
        parts.push(iron(pillar(2, 10, 16)));
    } else {
        parts.push(iron(pillar(2, 9, 11)));
    }
    parts
}

/// Links that lie across each other.
fn chain(axis: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    for link in 0..4 {
        let y = 4 * link;
        if link % 2 == 0 {
            parts.extend([part([6, y, 7], [7, y + 4, 8]), part([9, y, 7], [10, y + 4, 8])]);
            parts.push(part([6, y, 7], [10, y + 1, 8]));
            parts.push(part([6, y + 3, 7], [10, y + 4, 8]));
        } else {
            parts.push(part([7, y, 6], [9, y + 4, 7]));
            parts.push(part([7, y, 9], [9, y + 4, 10]));
        }
    }
    parts.into_iter().map(|part| part.averaged().along(axis)).collect()
}

fn cake(bites: i32) -> Vec<Part> {
    let low = 1 + 2 * bites;
    vec![part([low, 7, 1], [15, 8, 15]), part([low, 0, 1], [15, 7, 15]).colored(0xb5763e)]
}

/// A wick, and its flame where it is lit.
fn wick(state: &State, x: i32, y: i32, z: i32) -> Vec<Part> {
    let wick = part([x, y, z], [x + 1, y + 1, z + 1]).colored(0x2a2220);
    let flame = part([x, y + 1, z], [x + 1, y + 2, z + 1]).glowing(FLAME);
    if state.is_lit() { vec![flame, wick] } else { vec![wick] }
}

fn candles(name: &str, state: &State) -> Vec<Part> {
    // Their western and northern edges, and heights.
    let places: &[[i32; 3]] = match state.number("candles", 1) {
        2 => &[[9, 7, 6], [5, 6, 5]],
        3 => &[[7, 9, 3], [5, 6, 5], [8, 6, 6]],
        4 => &[[5, 8, 3], [8, 8, 5], [5, 5, 5], [8, 5, 6]],
        _ => &[[7, 7, 6]],
    };
    let wax = |&[x, z, height]: &[i32; 3]| {
        let mut parts = vec![part([x, 0, z], [x + 2, height, z + 2]).of(name).averaged()];
        parts.extend(wick(state, x, height, z));
        parts
    };
    places.iter().flat_map(wax).collect()
}

fn crystal(name: &str, facing: &str) -> Vec<Part> {
    let (width, height) = match name {
        _ if name.starts_with("small") => (8, 3),
        _ if name.starts_with("medium") => (10, 4),
        _ if name.starts_with("large") => (10, 5),
        _ => (10, 7),
    };
    let low = 8 - width / 2;
    let spike = |x: i32, z: i32, top: i32| part([low + x, 0, low + z], [low + x + 2, top, low + z + 2]);
    let last = width - 2;
    let parts = vec![
        pillar(2, 0, height),
        spike(0, 0, height - 1),
        spike(last, last, height - 1),
        spike(last, 0, height / 2 + 1),
        spike(0, last, height / 2 + 1),
        pillar(width, 0, 1),
    ];
    pointed(parts, facing)
}
