//! What a block is like within its place: boxes in sixteenths of a block, modelled by us from names and states alone. Directions are the
//! game's: x east, y up, z south; what turns is modelled as it looks to the north.

mod building;
mod furniture;
mod ground;
mod plants;
mod redstone;
mod small;

pub(super) use ground::STILL;

use super::state::State;

/// Sixteenths along an edge.
pub(super) const EDGE: i32 = 16;

/// What paints a part.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Paint {
    /// The block's own look.
    Own,
    /// As another block looks.
    Of(String),
    /// sRGB.
    Color(u32),
    /// sRGB, and it glows where the block does.
    Glowing(u32),
}

/// A box within a block, from its lowest corner to one past its highest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub from: [i32; 3],
    pub to: [i32; 3],
    pub paint: Paint,
    /// Whether pixels of a texture lie where the part is in its block. Those of a part without are what its texture is on the average.
    pub is_mapped: bool,
}

/// How a plant without a texture grows on its planes, and how one with a texture stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sprout {
    Blades,
    Blossom,
    Sapling,
    Mushroom,
    /// So many sixteenths of it have grown.
    Crop(i32),
    /// Everywhere: webs, stems, kelp.
    Web,
    Flame,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// All of the place, with the faces of its block.
    Cube,
    /// As [`Self::Cube`]; with a texture, its clear pixels are holes.
    Leaves,
    Parts(Vec<Part>),
    /// Two planes across each other, and what stands around them.
    Crossed(Sprout, Vec<Part>),
    /// A liquid up to a height; the whole of its place where there is more of it above.
    Liquid(i32),
}

/// A box of the block's own look.
fn part(from: [i32; 3], to: [i32; 3]) -> Part {
    Part { from, to, paint: Paint::Own, is_mapped: true }
}

/// A box as high as `to` and `from` say, around the middle, `width` wide.
fn pillar(width: i32, bottom: i32, top: i32) -> Part {
    let (low, high) = (8 - width / 2, 8 + width / 2);
    part([low, bottom, low], [high, top, high])
}

impl Part {
    /// All of a block's place.
    pub fn whole() -> Self {
        part([0; 3], [EDGE; 3])
    }

    fn of(self, name: impl Into<String>) -> Self {
        Self { paint: Paint::Of(name.into()), ..self }
    }

    fn colored(self, color: u32) -> Self {
        Self { paint: Paint::Color(color), ..self }
    }

    fn glowing(self, color: u32) -> Self {
        Self { paint: Paint::Glowing(color), ..self }
    }

    /// With the average of its texture instead of pixels at their places.
    fn averaged(self) -> Self {
        Self { is_mapped: false, ..self }
    }

    fn moved(mut self, by: [i32; 3]) -> Self {
        for (axis, by) in by.into_iter().enumerate() {
            self.from[axis] += by;
            self.to[axis] += by;
        }
        self
    }

    /// A quarter turn, from north to east.
    fn quarter(self) -> Self {
        let ([x0, y0, z0], [x1, y1, z1]) = (self.from, self.to);
        Self { from: [EDGE - z1, y0, x0], to: [EDGE - z0, y1, x1], ..self }
    }

    /// Upside down.
    fn flipped(self) -> Self {
        let ([x0, y0, z0], [x1, y1, z1]) = (self.from, self.to);
        Self { from: [x0, EDGE - y1, z0], to: [x1, EDGE - y0, z1], ..self }
    }

    /// What stands up lies along an axis.
    fn along(self, axis: &str) -> Self {
        let ([x0, y0, z0], [x1, y1, z1]) = (self.from, self.to);
        match axis {
            "x" => Self { from: [y0, x0, z0], to: [y1, x1, z1], ..self },
            "z" => Self { from: [x0, z0, y0], to: [x1, z1, y1], ..self },
            _ => self,
        }
    }
}

/// Quarter turns from north.
pub(super) fn quarters(facing: &str) -> usize {
    match facing {
        "east" => 1,
        "south" => 2,
        "west" => 3,
        _ => 0,
    }
}

/// What is modelled to the north, turned to where it faces.
fn turned(parts: Vec<Part>, facing: &str) -> Vec<Part> {
    let turn = |part: Part| (0..quarters(facing)).fold(part, |part, _| part.quarter());
    parts.into_iter().map(turn).collect()
}

/// What points up, turned to where it faces, up and down too.
fn pointed(parts: Vec<Part>, facing: &str) -> Vec<Part> {
    match facing {
        "up" => parts,
        "down" => parts.into_iter().map(Part::flipped).collect(),
        // Up becomes south, and that is half a turn from north.
        _ => turned(parts.into_iter().map(|part| part.along("z").quarter().quarter()).collect(), facing),
    }
}

/// The shape of a block with all that its state says.
pub(super) fn shape(state: &State) -> Shape {
    let name = state.name.as_str();
    let families = [building::shape, furniture::shape, redstone::shape, small::shape, plants::shape, ground::shape];
    families.iter().find_map(|family| family(name, state)).unwrap_or(Shape::Cube)
}

/// The colours of a name before one of these words, for what is made of wood, wool or stone.
fn made_of(name: &str, word: &str) -> Option<String> {
    name.strip_suffix(word).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_quarters_are_none_and_what_points_up_points_everywhere() {
        let arrow = part([7, 0, 6], [9, 10, 12]);
        let full = (0..4).fold(arrow.clone(), |part, _| part.quarter());
        assert_eq!(full, arrow);
        let tip = |facing: &str| {
            let turned = &pointed(vec![part([7, 15, 7], [9, 16, 9])], facing)[0];
            (turned.from, turned.to)
        };
        assert_eq!(tip("up"), ([7, 15, 7], [9, 16, 9]));
        assert_eq!(tip("down"), ([7, 0, 7], [9, 1, 9]));
        assert_eq!(tip("north"), ([7, 7, 0], [9, 9, 1]));
        assert_eq!(tip("east"), ([15, 7, 7], [16, 9, 9]));
        assert_eq!(tip("south"), ([7, 7, 15], [9, 9, 16]));
        assert_eq!(tip("west"), ([0, 7, 7], [1, 9, 9]));
    }
}
