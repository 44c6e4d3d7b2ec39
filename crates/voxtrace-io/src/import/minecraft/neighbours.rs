//! What a block takes from the blocks around it where its state does not say it: old files, and tools that leave properties out. So
//! fences, panes and walls reach for what they touch, stairs turn around corners, halves of doors and chests become whole.

use super::blocks::{Block, block};
use super::shapes::{Shape, quarters, shape};
use super::state::State;
use glam::IVec3;

/// The sides by quarters from north, with the steps to them (x east, y north, z up).
pub(super) const SIDES: [(&str, IVec3); 4] =
    [("north", IVec3::Y), ("east", IVec3::X), ("south", IVec3::NEG_Y), ("west", IVec3::NEG_X)];

/// What a block takes from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Link {
    Nothing,
    Fence,
    Pane,
    Wall,
    Wire,
    Stairs,
    Door,
    Chest,
    Chorus,
    TallPlant,
}

/// What a state leaves to its neighbours.
pub(super) fn link_of(state: &State) -> Link {
    let name = state.name.as_str();
    let says_sides = || SIDES.iter().any(|(side, _)| state.has(side));
    match kind(name) {
        Link::Stairs if state.has("shape") => Link::Nothing,
        Link::Door if state.has("facing") && state.has("hinge") && state.has("open") => Link::Nothing,
        Link::Chest if state.has("type") || !state.has("facing") => Link::Nothing,
        Link::TallPlant if !state.is("half", "upper") || name != "double_plant" => Link::Nothing,
        Link::Fence | Link::Pane | Link::Wall | Link::Wire | Link::Chorus if says_sides() => Link::Nothing,
        other => other,
    }
}

fn kind(name: &str) -> Link {
    match name {
        _ if name.ends_with("_fence") => Link::Fence,
        _ if name.ends_with("_pane") || name.ends_with("_bars") => Link::Pane,
        _ if name.ends_with("_wall") => Link::Wall,
        _ if name.ends_with("_stairs") => Link::Stairs,
        _ if name.ends_with("_door") => Link::Door,
        "redstone_wire" => Link::Wire,
        "chest" | "trapped_chest" => Link::Chest,
        "chorus_plant" => Link::Chorus,
        "double_plant" => Link::TallPlant,
        _ => Link::Nothing,
    }
}

/// The state with what it takes from the blocks around it, which are asked for by a step.
pub(super) fn linked<'a>(state: &State, at: &dyn Fn(IVec3) -> Option<&'a State>) -> State {
    match link_of(state) {
        Link::Nothing => state.clone(),
        Link::Stairs => {
            let turn = corner(state, at);
            state.clone().with("shape", turn)
        }
        Link::Door => door(state, at),
        Link::Chest => chest(state, at),
        Link::TallPlant => {
            at(IVec3::NEG_Z).map_or_else(|| state.clone(), |below| State::new(&*below.name).with("half", "upper"))
        }
        link => {
            let mut sides = state.clone();
            for (side, step) in SIDES {
                sides = sides.with(side, at(step).is_some_and(|other| reaches(link, state, other, side)));
            }
            match link {
                Link::Wall => with_post(sides, at(IVec3::Z)),
                Link::Chorus => {
                    let up = at(IVec3::Z).is_some_and(|other| reaches(link, state, other, "up"));
                    let below = at(IVec3::NEG_Z);
                    let down =
                        below.is_some_and(|other| reaches(link, state, other, "down") || other.name == "end_stone");
                    sides.with("up", up).with("down", down)
                }
                _ => sides,
            }
        }
    }
}

/// Whether a block of a kind reaches for another on one of its sides.
fn reaches(link: Link, state: &State, other: &State, side: &str) -> bool {
    let name = other.name.as_str();
    // A gate is between what stands left and right of where it faces.
    let is_gate = name.ends_with("_fence_gate")
        && other.get("facing").is_none_or(|facing| quarters(facing) % 2 != quarters(side) % 2);
    match link {
        Link::Wire => {
            matches!(name, "redstone_wire" | "redstone_torch" | "lever" | "repeater" | "comparator" | "redstone_block")
        }
        Link::Chorus => matches!(name, "chorus_plant" | "chorus_flower"),
        Link::Fence => {
            let is_of_nether = |name: &str| name == "nether_brick_fence";
            kind(name) == Link::Fence && is_of_nether(name) == is_of_nether(&state.name) || is_gate || is_full(other)
        }
        Link::Pane => kind(name) == Link::Pane || kind(name) == Link::Wall || is_full(other),
        Link::Wall => kind(name) == Link::Wall || kind(name) == Link::Pane || is_gate || is_full(other),
        _ => false,
    }
}

/// Whether a block is a full cube that others lean on.
fn is_full(state: &State) -> bool {
    block(&state.name, false) != Block::Unseen && shape(state) == Shape::Cube
}

/// A wall has a post unless it goes straight on with nothing above.
fn with_post(state: State, above: Option<&State>) -> State {
    let sides = SIDES.map(|(side, _)| state.is(side, "true"));
    let is_straight = sides[0] == sides[2] && sides[1] == sides[3] && sides[0] != sides[1];
    let has_burden = above.is_some_and(|above| block(&above.name, false) != Block::Unseen);
    state.with("up", !is_straight || has_burden)
}

/// How stairs turn: by the stairs before and behind them, as the game does it.
fn corner<'a>(state: &State, at: &dyn Fn(IVec3) -> Option<&'a State>) -> &'static str {
    let turns = quarters(state.get("facing").unwrap_or("north"));
    let half = |state: &State| state.is("half", "top");
    // Stairs of the same half at a side, and their quarters.
    let stairs = |quarter: usize| {
        let other =
            at(SIDES[quarter % 4].1).filter(|other| kind(&other.name) == Link::Stairs && half(other) == half(state))?;
        Some(quarters(other.get("facing").unwrap_or("north")))
    };
    let goes_on = |quarter: usize| stairs(quarter) == Some(turns);
    if let Some(other) = stairs(turns).filter(|other| other % 2 != turns % 2 && !goes_on(other + 2)) {
        return if other == (turns + 3) % 4 { "outer_left" } else { "outer_right" };
    }
    if let Some(other) = stairs(turns + 2).filter(|other| other % 2 != turns % 2 && !goes_on(*other)) {
        return if other == (turns + 3) % 4 { "inner_left" } else { "inner_right" };
    }
    "straight"
}

/// The lower half of an old door says where it faces and whether it is open, the upper one where its hinge is.
fn door<'a>(state: &State, at: &dyn Fn(IVec3) -> Option<&'a State>) -> State {
    let step = if state.is("half", "upper") { IVec3::NEG_Z } else { IVec3::Z };
    let Some(other) = at(step).filter(|other| other.name == state.name) else { return state.clone() };
    ["facing", "open", "hinge"].into_iter().fold(state.clone(), |state, key| match other.get(key) {
        Some(value) if !state.has(key) => state.with(key, value),
        _ => state,
    })
}

/// Two chests of one kind, side by side, that face alike are one.
fn chest<'a>(state: &State, at: &dyn Fn(IVec3) -> Option<&'a State>) -> State {
    let turns = quarters(state.get("facing").unwrap_or("north"));
    let is_beside = |quarter: usize| {
        at(SIDES[quarter % 4].1).is_some_and(|other| {
            other.name == state.name && other.get("facing") == state.get("facing") && !other.has("type")
        })
    };
    let half = if is_beside(turns + 1) {
        "left"
    } else if is_beside(turns + 3) {
        "right"
    } else {
        "single"
    };
    state.clone().with("type", half)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block among others that stand at some of its sides.
    fn among(state: &str, others: &[(&str, &str)]) -> State {
        let others: Vec<(IVec3, State)> = others
            .iter()
            .map(|(side, text)| {
                let step = match *side {
                    "up" => IVec3::Z,
                    "down" => IVec3::NEG_Z,
                    side => SIDES.iter().find(|(name, _)| *name == side).unwrap().1,
                };
                (step, State::of_text(text))
            })
            .collect();
        linked(&State::of_text(state), &|step| others.iter().find(|(at, _)| *at == step).map(|(_, state)| state))
    }

    fn sides(state: &State) -> String {
        SIDES.iter().filter(|(side, _)| state.is(side, "true")).map(|(side, _)| &side[..1]).collect()
    }

    #[test]
    fn fences_panes_and_walls_reach_for_what_they_touch() {
        let around = [("north", "oak_fence"), ("east", "stone"), ("south", "torch"), ("west", "nether_brick_fence")];
        assert_eq!(sides(&among("birch_fence", &around)), "ne");
        assert_eq!(sides(&among("glass_pane", &around)), "e");
        assert_eq!(sides(&among("birch_fence[north=false,east=false]", &around)), "");
        let gate = [("east", "oak_fence_gate[facing=north]"), ("south", "oak_fence_gate[facing=north]")];
        assert_eq!(sides(&among("birch_fence", &gate)), "e");
        let straight = [("north", "cobblestone_wall"), ("south", "cobblestone_wall")];
        assert!(among("cobblestone_wall", &straight).is("up", "false"));
        assert!(among("cobblestone_wall", &[straight[0]]).is("up", "true"));
        assert!(among("cobblestone_wall", &[straight[0], straight[1], ("up", "torch")]).is("up", "true"));
    }

    #[test]
    fn stairs_turn_around_corners_and_halves_find_each_other() {
        let turn = |other: &str, side: &str| {
            let other = format!("oak_stairs[half=bottom,facing={other}]");
            among("oak_stairs[half=bottom,facing=north]", &[(side, other.as_str())]).get("shape").unwrap().to_owned()
        };
        assert_eq!(turn("west", "north"), "outer_left");
        assert_eq!(turn("east", "north"), "outer_right");
        assert_eq!(turn("west", "south"), "inner_left");
        assert_eq!(turn("east", "south"), "inner_right");
        assert_eq!(turn("north", "south"), "straight");
        assert_eq!(turn("south", "east"), "straight");
        let door = among("oak_door[half=lower,facing=east,open=true]", &[("up", "oak_door[half=upper,hinge=right]")]);
        assert!(door.is("hinge", "right") && door.is("facing", "east"));
        let chest =
            |side: &str| among("chest[facing=south]", &[(side, "chest[facing=south]")]).get("type").map(str::to_owned);
        assert_eq!((chest("west").unwrap().as_str(), chest("east").unwrap().as_str()), ("left", "right"));
        assert_eq!(chest("north").unwrap(), "single");
    }
}
