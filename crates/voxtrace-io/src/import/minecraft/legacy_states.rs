//! What the four bits of data of old files (before 1.13) say about the shape of a block, as the properties of today.

use super::legacy::name;
use super::state::State;

/// Directions in the orders in which data counts them.
const BY_QUARTERS: [&str; 4] = ["south", "west", "north", "east"];
const BY_STAIRS: [&str; 4] = ["east", "west", "south", "north"];
const BY_DOORS: [&str; 4] = ["east", "south", "west", "north"];
const BY_TRAPDOORS: [&str; 4] = ["north", "south", "west", "east"];
const BY_SIDES: [&str; 6] = ["down", "up", "north", "south", "west", "east"];
pub(super) const RAILS: [&str; 10] = [
    "north_south",
    "east_west",
    "ascending_east",
    "ascending_west",
    "ascending_north",
    "ascending_south",
    "south_east",
    "south_west",
    "north_west",
    "north_east",
];

/// The state of a block of old files. `data` is below 16.
pub(super) fn state(id: u8, data: u8) -> State {
    let (name, is_lit) = name(id, data);
    let state = State::new(name);
    let state = if is_lit { state.with("lit", true) } else { state };
    let quarter = usize::from(data & 3);
    let is_fourth = data & 4 != 0;
    let is_eighth = data & 8 != 0;
    let side = BY_SIDES[usize::from(data & 7).min(5)];
    match id {
        8..=11 => state.with("level", data),
        17 | 162 => state.with("axis", ["y", "x", "z", "y"][usize::from(data >> 2 & 3)]),
        170 | 202 | 216 => state.with("axis", ["y", "x", "z", "y"][usize::from(data >> 2 & 3)]),
        155 if (2..=4).contains(&data) => {
            State::new("quartz_pillar").with("axis", ["y", "x", "z"][usize::from(data - 2)])
        }
        26 => {
            let part = if is_eighth { "head" } else { "foot" };
            state.with("facing", BY_QUARTERS[quarter]).with("part", part)
        }
        27 | 28 | 157 => state.with("shape", RAILS[usize::from(data & 7).min(5)]).with("powered", is_eighth),
        66 => state.with("shape", RAILS[usize::from(data).min(9)]),
        29 | 33 => state.with("facing", side).with("extended", is_eighth),
        34 => state.with("facing", side),
        43 | 125 | 181 | 204 => state.with("type", "double"),
        44 | 126 | 182 | 205 => state.with("type", if is_eighth { "top" } else { "bottom" }),
        50 | 75 | 76 => torch(state, id, data),
        53 | 67 | 108 | 109 | 114 | 128 | 134..=136 | 156 | 163 | 164 | 180 | 203 => {
            state.with("facing", BY_STAIRS[quarter]).with("half", if is_fourth { "top" } else { "bottom" })
        }
        23 | 54 | 61 | 62 | 65 | 68 | 130 | 146 | 154 | 158 | 177 | 198 | 218 => state.with("facing", side),
        55 => state.with("power", data),
        59 | 104 | 105 | 115 | 141 | 142 | 207 => state.with("age", data & 7),
        63 | 176 => state.with("rotation", data),
        64 | 71 | 193..=197 => door(state, data),
        69 | 77 | 143 => switch(state, data, id == 69),
        70 | 72 | 147 | 148 => state.with("powered", data > 0),
        78 => state.with("layers", (data & 7) + 1),
        90 => state.with("axis", if data & 3 == 2 { "z" } else { "x" }),
        92 => state.with("bites", data & 7),
        93 | 94 => state.with("facing", BY_QUARTERS[quarter]).with("delay", (data >> 2) + 1).with("powered", id == 94),
        149 | 150 => {
            let mode = if is_fourth { "subtract" } else { "compare" };
            state.with("facing", BY_QUARTERS[quarter]).with("mode", mode).with("powered", is_eighth || id == 150)
        }
        96 | 167 => {
            let half = if is_eighth { "top" } else { "bottom" };
            state.with("facing", BY_TRAPDOORS[quarter]).with("open", is_fourth).with("half", half)
        }
        106 => BY_QUARTERS.iter().enumerate().fold(state, |state, (bit, side)| state.with(side, data >> bit & 1 != 0)),
        107 | 183..=187 => state.with("facing", BY_QUARTERS[quarter]).with("open", is_fourth),
        86 | 91 | 131 | 145 => state.with("facing", BY_QUARTERS[quarter]),
        118 if data > 0 => State::new("water_cauldron").with("level", data.min(3)),
        120 => state.with("facing", BY_QUARTERS[quarter]).with("eye", is_fourth),
        127 => state.with("facing", BY_QUARTERS[quarter]).with("age", data >> 2),
        144 if data > 1 => State::new("skeleton_wall_skull").with("facing", side),
        // Which plant it is, the block below says.
        175 if is_eighth => State::new("double_plant").with("half", "upper"),
        175 => state.with("half", "lower"),
        _ => state,
    }
}

fn torch(state: State, id: u8, data: u8) -> State {
    let side = BY_STAIRS.get(usize::from(data).wrapping_sub(1));
    let state = match side {
        Some(side) => State::new(if id == 50 { "wall_torch" } else { "redstone_wall_torch" }).with("facing", side),
        None => state,
    };
    if id == 75 { state.with("lit", false) } else { state }
}

/// The lower half says where a door faces and whether it is open, the upper one where its hinge is.
fn door(state: State, data: u8) -> State {
    if data & 8 != 0 {
        return state.with("half", "upper").with("hinge", if data & 1 != 0 { "right" } else { "left" });
    }
    state.with("half", "lower").with("facing", BY_DOORS[usize::from(data & 3)]).with("open", data & 4 != 0)
}

/// Levers and buttons.
fn switch(state: State, data: u8, is_lever: bool) -> State {
    let state = state.with("powered", data & 8 != 0);
    let (face, facing) = match data & 7 {
        0 if is_lever => ("ceiling", "east"),
        0 => ("ceiling", "north"),
        5 => ("floor", "north"),
        6 => ("floor", "east"),
        7 => ("ceiling", "north"),
        wall => ("wall", BY_STAIRS[usize::from(wall) - 1]),
    };
    state.with("face", face).with("facing", facing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_says_what_states_say_today() {
        for (id, data, wanted) in [
            (53, 7, "oak_stairs[facing=north,half=top]"),
            (44, 8 | 3, "cobblestone_slab[type=top]"),
            (43, 0, "smooth_stone_slab[type=double]"),
            (50, 1, "wall_torch[facing=east]"),
            (50, 5, "torch"),
            (75, 5, "redstone_torch[lit=false]"),
            (64, 1 | 4, "oak_door[half=lower,facing=south,open=true]"),
            (64, 8 | 1, "oak_door[half=upper,hinge=right]"),
            (96, 3 | 4 | 8, "oak_trapdoor[facing=east,open=true,half=top]"),
            (17, 2 | 4, "birch_log[axis=x]"),
            (66, 9, "rail[shape=north_east]"),
            (78, 3, "snow[layers=4]"),
            (77, 4, "stone_button[face=wall,facing=north,powered=false]"),
            (106, 5, "vine[south=true,west=false,north=true,east=false]"),
            (62, 4, "furnace[facing=west,lit=true]"),
            (9, 3, "water[level=3]"),
            (1, 5, "andesite"),
        ] {
            assert_eq!(state(id, data), State::of_text(wanted), "{id}:{data}");
        }
        // Nothing panics.
        (0..=255).for_each(|id| (0..16).for_each(|data| drop(state(id, data))));
    }
}
