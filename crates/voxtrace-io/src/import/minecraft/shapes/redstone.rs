//! What moves and switches: rails, buttons, levers, pressure plates, repeaters, pistons, wires.

use super::super::state::State;
use super::building::{SIDES, goes_on};
use super::{Part, Shape, part, pointed, turned};

const GLOW: u32 = 0xd8281a;

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let facing = state.get("facing").unwrap_or("north");
    let parts = if name == "rail" || name.ends_with("_rail") {
        rail(name, state)
    } else if name.ends_with("_button") {
        let height = if state.is("powered", "true") { 1 } else { 2 };
        on_face(vec![part([5, 0, 6], [11, height, 10])], state, facing)
    } else if name.ends_with("_pressure_plate") {
        vec![part([1, 0, 1], [15, 1, 15])]
    } else {
        match name {
            "lever" => lever(state, facing),
            "repeater" | "comparator" => turned(diode(name, state), facing),
            "redstone_wire" => wire(state),
            "piston" | "sticky_piston" if state.is("extended", "true") => {
                pointed(vec![part([0, 0, 0], [16, 12, 16])], facing)
            }
            "piston_head" => {
                let rod = part([6, 0, 6], [10, 12, 10]).of("oak_planks").averaged();
                pointed(vec![part([0, 12, 0], [16, 16, 16]).of("piston"), rod], facing)
            }
            "moving_piston" => Vec::new(),
            "daylight_detector" => vec![part([0, 0, 0], [16, 6, 16])],
            "tripwire_hook" => turned(
                vec![
                    part([6, 1, 14], [10, 9, 16]).of("oak_planks").averaged(),
                    part([7, 5, 9], [9, 7, 14]).colored(0x8a8a8a),
                ],
                facing,
            ),
            "sculk_sensor" | "calibrated_sculk_sensor" => {
                let mut parts = vec![part([0, 0, 0], [16, 8, 16])];
                for (x, z) in [(2, 2), (12, 2), (2, 12), (12, 12)] {
                    parts.push(part([x, 8, z], [x + 2, 16, z + 1]).colored(0x1fa0a0));
                }
                parts
            }
            "sculk_shrieker" => vec![
                part([0, 0, 0], [16, 8, 16]),
                part([1, 8, 1], [15, 15, 2]),
                part([1, 8, 14], [15, 15, 15]),
                part([1, 8, 2], [2, 15, 14]),
                part([14, 8, 2], [15, 15, 14]),
            ],
            _ => return None,
        }
    };
    Some(Shape::Parts(parts))
}

/// What lies on the floor, turned to the wall or the ceiling that `face` says. On walls it faces away from them.
fn on_face(parts: Vec<Part>, state: &State, facing: &str) -> Vec<Part> {
    match state.get("face") {
        Some("ceiling") => turned(parts.into_iter().map(Part::flipped).collect(), facing),
        Some("floor") => turned(parts, facing),
        _ => pointed(parts, facing),
    }
}

fn lever(state: &State, facing: &str) -> Vec<Part> {
    let lean = if state.is("powered", "true") { 1 } else { -1 };
    let mut parts = vec![part([5, 0, 4], [11, 3, 12]).of("cobblestone").averaged()];
    for step in 0..4 {
        let z = 7 + lean * (step + 1);
        parts.push(part([7, 1 + 2 * step, z], [9, 4 + 2 * step, z + 2]).of("oak_planks").averaged());
    }
    on_face(parts, state, facing)
}

fn diode(name: &str, state: &State) -> Vec<Part> {
    let torch = |x: i32, z: i32, is_lit: bool| {
        let stick = part([x, 2, z], [x + 2, 7, z + 2]);
        if is_lit { stick.colored(GLOW) } else { stick.colored(0x5a1a14) }
    };
    let is_on = state.is("powered", "true");
    let mut parts = vec![part([0, 0, 0], [16, 2, 16])];
    if name == "repeater" {
        // The first torch is at the end that it gives power to.
        parts.extend([torch(7, 12, is_on), torch(7, 10 - 2 * state.number("delay", 1).clamp(1, 4), is_on)]);
    } else {
        parts.extend([torch(4, 11, is_on), torch(10, 11, is_on), torch(7, 2, state.is("mode", "subtract"))]);
    }
    parts
}

fn wire(state: &State) -> Vec<Part> {
    let color = 0x500a04 + ((state.number("power", 0).clamp(0, 15) as u32 * 10) << 16);
    let mut parts = vec![part([6, 0, 6], [10, 1, 10]).colored(color)];
    for side in SIDES.into_iter().filter(|side| goes_on(state, side)) {
        let mut arm = vec![part([7, 0, 0], [9, 1, 8]).colored(color)];
        if state.is(side, "up") {
            arm.push(part([7, 0, 0], [9, 16, 1]).colored(color));
        }
        parts.extend(turned(arm, side));
    }
    parts
}

/// Two rails on sleepers: straight, around a corner, or up in steps.
fn rail(name: &str, state: &State) -> Vec<Part> {
    let metal = match name {
        "powered_rail" => 0xc9a13a,
        "detector_rail" | "activator_rail" => 0x8f7a70,
        _ => 0x9a9a9a,
    };
    let iron = |from: [i32; 3], to: [i32; 3]| part(from, to).colored(metal);
    let sleeper = |z: i32, y: i32| part([1, y, z], [15, y + 1, z + 2]).of("spruce_planks").averaged();
    let shape = state.get("shape").unwrap_or("north_south");
    let corner = |turn: &str| {
        let parts = vec![
            iron([2, 0, 2], [16, 1, 4]),
            iron([2, 0, 4], [4, 1, 16]),
            iron([12, 0, 12], [16, 1, 14]),
            iron([12, 0, 14], [14, 1, 16]),
            sleeper(13, 0),
            part([13, 0, 1], [15, 1, 12]).of("spruce_planks").averaged(),
            part([4, 0, 9], [12, 1, 11]).of("spruce_planks").averaged(),
            part([9, 0, 4], [11, 1, 9]).of("spruce_planks").averaged(),
        ];
        turned(parts, turn)
    };
    match shape {
        "south_east" => corner("north"),
        "south_west" => corner("east"),
        "north_west" => corner("south"),
        "north_east" => corner("west"),
        _ => match shape.strip_prefix("ascending_") {
            Some(up) => {
                let parts = (0..16).flat_map(|z| {
                    let y = 15 - z;
                    let mut parts = vec![iron([2, y, z], [4, y + 1, z + 1]), iron([12, y, z], [14, y + 1, z + 1])];
                    if z % 4 == 1 || z % 4 == 2 {
                        parts.push(part([1, y, z], [15, y + 1, z + 1]).of("spruce_planks").averaged());
                    }
                    parts
                });
                turned(parts.collect(), up)
            }
            None => {
                let mut parts = vec![iron([2, 0, 0], [4, 1, 16]), iron([12, 0, 0], [14, 1, 16])];
                if name != "rail" {
                    parts.push(part([7, 0, 0], [9, 1, 16]).colored(if state.is("powered", "true") {
                        GLOW
                    } else {
                        0x6a1a14
                    }));
                }
                parts.extend([1, 5, 9, 13].map(|z| sleeper(z, 0)));
                turned(parts, if shape == "east_west" { "east" } else { "north" })
            }
        },
    }
}
