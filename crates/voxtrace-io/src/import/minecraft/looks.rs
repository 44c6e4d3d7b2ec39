//! How blocks look: by colours of ours, or by the textures of a resource pack.

use super::blocks::{Block, Kind, Look, block};
use super::pack::Pack;
use super::pack::picture::Picture;
use super::shapes::{EDGE, Paint, Part};
use super::state::State;
use std::collections::BTreeSet;
use std::sync::Arc;
use voxtrace_scene::material::{linear_color, srgb_from_linear};

/// Opaque white, which nobody sees.
const NONE: Look = Look { color: 0xffffff, kind: Kind::Plain, light: 0 };

/// Names that a note about unknown blocks says.
const NAMED: usize = 5;

/// The six faces of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Face {
    Up,
    Down,
    North,
    East,
    South,
    West,
}

impl Face {
    pub const ALL: [Self; 6] = [Self::Up, Self::Down, Self::North, Self::East, Self::South, Self::West];

    pub fn name(self) -> &'static str {
        ["up", "down", "north", "east", "south", "west"][self as usize]
    }

    /// The axis that it is across: 0 is x, 1 is y (up), 2 is z.
    pub fn axis(self) -> usize {
        match self {
            Self::Up | Self::Down => 1,
            Self::North | Self::South => 2,
            Self::East | Self::West => 0,
        }
    }

    /// The pixel that a cell shows on it: to the right, and down.
    fn pixel(self, [x, y, z]: [i32; 3]) -> [i32; 2] {
        let last = EDGE - 1;
        match self {
            Self::Up => [x, z],
            Self::Down => [x, last - z],
            Self::North => [last - x, last - y],
            Self::East => [last - z, last - y],
            Self::South => [x, last - y],
            Self::West => [z, last - y],
        }
    }
}

/// Looks of blocks, and the names that say nothing.
#[derive(Default)]
pub(super) struct Looks {
    pub pack: Option<Pack>,
    pub unknown: BTreeSet<String>,
}

impl Looks {
    /// The look of a block by colours of ours; `None` for what nobody sees.
    pub fn seen(&mut self, state: &State) -> Option<Look> {
        let look = match block(&state.name, state.is_lit()) {
            Block::Unseen => return None,
            Block::Known(look) => look,
            Block::Unknown(look) => {
                self.unknown.insert(state.name.clone());
                look
            }
        };
        // What can be put out, and is.
        Some(if state.is("lit", "false") { Look { light: 0, ..look } } else { look })
    }

    /// What there is to say about blocks whose names say nothing.
    pub fn note(&self) -> Option<String> {
        if self.unknown.is_empty() {
            return None;
        }
        let names: Vec<&str> = self.unknown.iter().take(NAMED).map(String::as_str).collect();
        let (count, more) = (self.unknown.len(), if self.unknown.len() > NAMED { ", …" } else { "" });
        Some(format!(
            "{count} kinds of blocks are unknown, their colours are made from their names: {}{more}",
            names.join(", ")
        ))
    }

    /// As [`Self::seen`], of a block that is seen.
    pub fn of_state(&mut self, state: &State) -> Look {
        self.seen(state).unwrap_or(NONE)
    }

    /// What paints a part of a block.
    pub fn painter(&mut self, state: &State, part: &Part) -> Painter {
        let own = self.of_state(state);
        let other;
        let (look, state) = match &part.paint {
            Paint::Own => (own, state),
            Paint::Of(name) => {
                other = State::new(&**name);
                (Look { light: 0, ..self.of_state(&other) }, &other)
            }
            &Paint::Color(color) => return Painter::plain(Look { color, kind: Kind::Plain, light: 0 }),
            &Paint::Glowing(color) => return Painter::plain(Look { color, kind: Kind::Plain, light: own.light }),
        };
        let Some(pack) = &mut self.pack else { return Painter::plain(look) };
        let faces = Face::ALL.map(|face| pack.face(state, face));
        if !part.is_mapped {
            let colors: Vec<u32> = faces.iter().flatten().filter_map(|picture| picture.mean()).collect();
            let color = if colors.is_empty() { look.color } else { mean_color(&colors) };
            return Painter::plain(Look { color, ..look });
        }
        Painter { look, faces: Some(faces) }
    }

    /// The texture of a plant.
    pub fn plant(&mut self, state: &State) -> Option<Arc<Picture>> {
        self.pack.as_mut()?.face(state, Face::South)
    }

    /// Whether a block's texture has clear pixels.
    pub fn has_holes(&mut self, state: &State) -> bool {
        self.plant(state).is_some_and(|picture| picture.has_holes())
    }
}

/// What paints a part.
pub(super) struct Painter {
    look: Look,
    faces: Option<[Option<Arc<Picture>>; 6]>,
}

impl Painter {
    fn plain(look: Look) -> Self {
        Self { look, faces: None }
    }

    /// The look of a cell of a box; `None` where its texture has a hole.
    pub fn look(&self, at: [i32; 3], from: [i32; 3], to: [i32; 3]) -> Option<Look> {
        let Some(faces) = &self.faces else { return Some(self.look) };
        let face = face_of(at, from, to);
        let Some(picture) = &faces[face as usize] else { return Some(self.look) };
        let [u, v] = face.pixel(at);
        let is_clear = matches!(self.look.kind, Kind::Glass | Kind::Water);
        // The clear middle of a pane is glass, too.
        let color = match picture.texel(u, v) {
            Some(color) => color,
            None if is_clear => picture.faint(u, v).unwrap_or(self.look.color),
            None => return None,
        };
        Some(Look { color, ..self.look })
    }
}

/// The face that a cell shows: of what is thin its broad one, else the first that it is at, from above.
fn face_of(at: [i32; 3], from: [i32; 3], to: [i32; 3]) -> Face {
    let size: [i32; 3] = std::array::from_fn(|axis| to[axis] - from[axis]);
    let thin = (0..3).find(|&axis| size[axis] <= 3 && (0..3).all(|other| other == axis || size[other] >= 8));
    match thin {
        Some(0) => return Face::East,
        Some(1) => return Face::Up,
        Some(_) => return Face::South,
        None => {}
    }
    if at[1] == to[1] - 1 {
        Face::Up
    } else if at[2] == to[2] - 1 {
        Face::South
    } else if at[0] == to[0] - 1 {
        Face::East
    } else if at[2] == from[2] {
        Face::North
    } else if at[0] == from[0] {
        Face::West
    } else {
        // Below, and what only a cut shows.
        Face::Down
    }
}

/// The mean of colours, as light mixes.
pub(super) fn mean_color(colors: &[u32]) -> u32 {
    if colors.windows(2).all(|pair| pair[0] == pair[1]) {
        return colors.first().copied().unwrap_or(0);
    }
    let linear = |&color: &u32| {
        let [_, red, green, blue] = color.to_be_bytes();
        linear_color([red, green, blue])
    };
    let sum: glam::Vec3 = colors.iter().map(linear).sum();
    let [red, green, blue] = (sum / colors.len() as f32).to_array().map(srgb_from_linear);
    u32::from_be_bytes([0, red, green, blue])
}
