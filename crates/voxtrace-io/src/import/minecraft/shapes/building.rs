//! What houses are built of: slabs, stairs, fences, walls, panes, doors, trapdoors, ladders, carpets.

use super::super::state::State;
use super::{Part, Shape, part, pillar, quarters, turned};

pub(super) const SIDES: [&str; 4] = ["north", "east", "south", "west"];

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let parts = if name.ends_with("_slab") || name == "slab" {
        return Some(match state.get("type") {
            Some("double") => Shape::Cube,
            Some("top") => Shape::Parts(vec![part([0, 8, 0], [16, 16, 16])]),
            _ => Shape::Parts(vec![part([0, 0, 0], [16, 8, 16])]),
        });
    } else if name.ends_with("_stairs") {
        stairs(state)
    } else if name.ends_with("_fence") || name == "fence" {
        with_arms(state, pillar(4, 0, 16), &[part([7, 12, 0], [9, 15, 8]), part([7, 6, 0], [9, 9, 8])])
    } else if name.ends_with("_fence_gate") {
        gate(state)
    } else if name.ends_with("_wall") {
        wall(state)
    } else if name.ends_with("_pane") || name.ends_with("_bars") {
        with_arms(state, part([7, 0, 7], [9, 16, 9]), &[part([7, 0, 0], [9, 16, 8])])
    } else if name.ends_with("_trapdoor") {
        trapdoor(state)
    } else if name.ends_with("_door") {
        door(state)
    } else if name.ends_with("carpet") {
        vec![part([0, 0, 0], [16, 1, 16])]
    } else if name == "ladder" {
        ladder(state)
    } else {
        return None;
    };
    Some(Shape::Parts(parts))
}

/// Whether a side says that something goes on there.
pub(super) fn goes_on(state: &State, side: &str) -> bool {
    state.get(side).is_some_and(|value| !matches!(value, "false" | "none" | "0"))
}

/// A post with arms, modelled to the north, where the state says so.
fn with_arms(state: &State, post: Part, arms: &[Part]) -> Vec<Part> {
    let sides = SIDES.into_iter().filter(|side| goes_on(state, side));
    let mut parts: Vec<Part> = sides.flat_map(|side| turned(arms.to_vec(), side)).collect();
    parts.push(post);
    parts
}

fn stairs(state: &State) -> Vec<Part> {
    // The step is in the half that stairs face.
    let quarter = |x: i32, z: i32| part([x, 8, z], [x + 8, 16, z + 8]);
    let (left, right, left_back, right_back) = (quarter(0, 0), quarter(8, 0), quarter(0, 8), quarter(8, 8));
    let mut steps = match state.get("shape") {
        Some("outer_left") => vec![left],
        Some("outer_right") => vec![right],
        Some("inner_left") => vec![left, right, left_back],
        Some("inner_right") => vec![left, right, right_back],
        _ => vec![part([0, 8, 0], [16, 16, 8])],
    };
    steps.push(part([0, 0, 0], [16, 8, 16]));
    let steps = turned(steps, state.get("facing").unwrap_or("north"));
    if state.is("half", "top") { steps.into_iter().map(Part::flipped).collect() } else { steps }
}

fn gate(state: &State) -> Vec<Part> {
    let mut parts = vec![part([0, 5, 7], [2, 16, 9]), part([14, 5, 7], [16, 16, 9])];
    if state.is("open", "true") {
        for x in [0, 14] {
            parts.push(part([x, 6, 1], [x + 2, 9, 7]));
            parts.push(part([x, 12, 1], [x + 2, 15, 7]));
            parts.push(part([x, 6, 1], [x + 2, 15, 3]));
        }
    } else {
        parts.extend([part([6, 6, 7], [10, 15, 9]), part([2, 6, 7], [14, 9, 9]), part([2, 12, 7], [14, 15, 9])]);
    }
    if state.is("in_wall", "true") {
        parts = parts.into_iter().map(|part| part.moved([0, -3, 0])).collect();
    }
    turned(parts, state.get("facing").unwrap_or("north"))
}

fn wall(state: &State) -> Vec<Part> {
    let mut parts = Vec::new();
    for side in SIDES.into_iter().filter(|side| goes_on(state, side)) {
        let top = if state.is(side, "tall") { 16 } else { 14 };
        parts.extend(turned(vec![part([5, 0, 0], [11, top, 8])], side));
    }
    if parts.is_empty() || !state.is("up", "false") {
        parts.push(pillar(8, 0, 16));
    }
    parts
}

fn trapdoor(state: &State) -> Vec<Part> {
    if state.is("open", "true") {
        return turned(vec![part([0, 0, 13], [16, 16, 16])], state.get("facing").unwrap_or("north"));
    }
    let flat = part([0, 0, 0], [16, 3, 16]);
    vec![if state.is("half", "top") { flat.flipped() } else { flat }]
}

/// A door closes the side behind the direction that it faces; open, it stands on the side of its hinge.
fn door(state: &State) -> Vec<Part> {
    let mut turns = quarters(state.get("facing").unwrap_or("north"));
    if state.is("open", "true") {
        turns += if state.is("hinge", "right") { 3 } else { 1 };
    }
    turned(vec![part([0, 0, 13], [16, 16, 16])], SIDES[turns % 4])
}

fn ladder(state: &State) -> Vec<Part> {
    let mut parts: Vec<Part> = [1, 5, 9, 13].into_iter().map(|y| part([0, y, 15], [16, y + 2, 16])).collect();
    parts.extend([part([2, 0, 15], [4, 16, 16]), part([12, 0, 15], [14, 16, 16])]);
    turned(parts, state.get("facing").unwrap_or("north"))
}
