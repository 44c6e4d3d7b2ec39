//! What lies on the ground and what flows: snow, paths, fields, water and lava.

use super::super::state::State;
use super::{Shape, part};

/// How high still water stands, in sixteenths.
pub(in crate::import::minecraft) const STILL: i32 = 14;

pub(super) fn shape(name: &str, state: &State) -> Option<Shape> {
    let flat = |height: i32| Some(Shape::Parts(vec![part([0, 0, 0], [16, height, 16])]));
    match name {
        "snow" => flat(2 * state.number("layers", 1).clamp(1, 8)),
        "dirt_path" | "grass_path" | "farmland" => flat(15),
        "water" | "lava" => {
            // From 8 on it falls, and fills its place.
            let level = state.number("level", 0);
            Some(Shape::Liquid(if level >= 8 { 16 } else { ((8 - level.max(0)) * 16 / 9).max(1) }))
        }
        "bubble_column" => Some(Shape::Liquid(16)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn water_stands_lower_the_farther_it_has_flowed() {
        let height = |level: i32| match shape("water", &State::new("water").with("level", level)) {
            Some(Shape::Liquid(height)) => height,
            other => panic!("{other:?}"),
        };
        assert_eq!([0, 1, 4, 7, 8, 15].map(height), [STILL, 12, 7, 1, 16, 16]);
    }
}
