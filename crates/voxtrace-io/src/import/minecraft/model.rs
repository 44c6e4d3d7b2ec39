//! A block with its state as voxels: parts become cells of 16³, and where blocks are of fewer voxels, those become larger ones.

use super::blocks::Look;
use super::looks::Looks;
use super::shapes::{EDGE, Part, Shape, Sprout, shape};
use super::sprouts;
use super::state::State;

/// Cells along an edge before they are made fewer.
pub(super) const CELLS: usize = EDGE as usize;

/// Faces of a block, in the order of their bits: where x, y and z are lowest and highest in our directions.
pub(super) const FACES: usize = 6;

/// A block as `edge`³ voxels, x (east) fastest, then y (north), then z (up).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Model {
    pub edge: usize,
    pub cells: Vec<Option<Look>>,
}

/// The place of a cell of the game's directions (x east, y up, z south) in a block of 16³ of ours.
fn place([x, y, z]: [usize; 3]) -> usize {
    (y * CELLS + (CELLS - 1 - z)) * CELLS + x
}

/// The voxels of a block whose state says all; `is_liquid_above` where the same liquid stands above.
pub(super) fn model(state: &State, is_liquid_above: bool, edge: usize, looks: &mut Looks) -> Model {
    let mut cells = Cells { of: vec![None; CELLS * CELLS * CELLS], looks, state };
    match shape(state) {
        Shape::Cube => cells.paint(&Part::whole(), false),
        Shape::Leaves => {
            let is_holed = cells.looks.has_holes(state);
            cells.paint(&Part::whole(), is_holed);
        }
        Shape::Parts(parts) => parts.iter().for_each(|part| cells.paint(part, false)),
        Shape::Crossed(sprout, parts) => {
            parts.iter().for_each(|part| cells.paint(part, false));
            cells.cross(sprout);
        }
        Shape::Liquid(height) => cells.flood(state, if is_liquid_above { EDGE } else { height }),
    }
    if is_watered(state) {
        let height = if is_liquid_above { EDGE } else { super::shapes::STILL };
        cells.flood(&State::new("water"), height);
    }
    let cells = cells.of;
    Model { edge, cells: if edge == CELLS { cells } else { fewer(&cells, edge) } }
}

/// Whether water stands around what a block is.
pub(super) fn is_watered(state: &State) -> bool {
    state.is("waterlogged", "true")
        || matches!(state.name.as_str(), "seagrass" | "tall_seagrass" | "kelp" | "kelp_plant")
}

struct Cells<'a> {
    of: Vec<Option<Look>>,
    looks: &'a mut Looks,
    state: &'a State,
}

impl Cells<'_> {
    /// Fills a part where nothing is yet; of one that is hollow its faces alone.
    fn paint(&mut self, part: &Part, is_hollow: bool) {
        let painter = self.looks.painter(self.state, part);
        let [from, to] = [part.from, part.to].map(|corner| corner.map(|edge| edge.clamp(0, EDGE)));
        for y in from[1]..to[1] {
            for z in from[2]..to[2] {
                for x in from[0]..to[0] {
                    let at = [x, y, z];
                    let is_face = (0..3).any(|axis| at[axis] == from[axis] || at[axis] == to[axis] - 1);
                    let cell = &mut self.of[place(at.map(|c| c as usize))];
                    if cell.is_none() && (is_face || !is_hollow) {
                        *cell = painter.look(at, from, to);
                    }
                }
            }
        }
    }

    /// Two planes from corner to corner.
    fn cross(&mut self, sprout: Sprout) {
        let texture = self.looks.plant(self.state);
        let own = self.looks.of_state(self.state);
        for v in 0..EDGE {
            for u in 0..EDGE {
                let look = match &texture {
                    Some(texture) => texture.texel(u, EDGE - 1 - v).map(|color| Look { color, ..own }),
                    None => sprouts::look(sprout, &self.state.name, u, v, own),
                };
                let Some(look) = look else { continue };
                for at in [[u, v, u], [u, v, EDGE - 1 - u]] {
                    self.of[place(at.map(|c| c as usize))].get_or_insert(look);
                }
            }
        }
    }

    /// Liquid everywhere up to a height where nothing is yet.
    fn flood(&mut self, liquid: &State, height: i32) {
        let painter = self.looks.painter(liquid, &Part::whole());
        let (from, to) = ([0; 3], [EDGE, height, EDGE]);
        for y in 0..height {
            for z in 0..EDGE {
                for x in 0..EDGE {
                    let cell = &mut self.of[place([x, y, z].map(|c| c as usize))];
                    *cell = cell.or_else(|| painter.look([x, y, z], from, to));
                }
            }
        }
    }
}

/// Larger cells: filled where at least a quarter of what they hold is, or, in blocks with no such cell, where anything is. Their look is
/// that of most of what is seen, their colour the mean.
fn fewer(cells: &[Option<Look>], edge: usize) -> Vec<Option<Look>> {
    let size = CELLS / edge;
    let index = |x: usize, y: usize, z: usize| (z * CELLS + y) * CELLS + x;
    let is_full = |x: usize, y: usize, z: usize| cells[index(x, y, z)].is_some();
    let is_seen = |x: usize, y: usize, z: usize| {
        let ends = [x, y, z].iter().any(|&c| c == 0 || c == CELLS - 1);
        ends || !(is_full(x - 1, y, z)
            && is_full(x + 1, y, z)
            && is_full(x, y - 1, z)
            && is_full(x, y + 1, z)
            && is_full(x, y, z - 1)
            && is_full(x, y, z + 1))
    };
    let mut found = Vec::with_capacity(edge * edge * edge);
    for at in 0..edge * edge * edge {
        let corner = [at % edge, at / edge % edge, at / (edge * edge)].map(|c| c * size);
        let (mut seen, mut hidden) = (Vec::new(), Vec::new());
        for inner in 0..size * size * size {
            let [x, y, z] =
                [corner[0] + inner % size, corner[1] + inner / size % size, corner[2] + inner / (size * size)];
            if let Some(look) = cells[index(x, y, z)] {
                if is_seen(x, y, z) { seen.push(look) } else { hidden.push(look) }
            }
        }
        let count = seen.len() + hidden.len();
        found.push((count, mean(if seen.is_empty() { &hidden } else { &seen })));
    }
    let quarter = (size * size * size).div_ceil(4);
    let has_quarters = found.iter().any(|(count, _)| *count >= quarter);
    let least = if has_quarters { quarter } else { 1 };
    found.into_iter().map(|(count, look)| look.filter(|_| count >= least)).collect()
}

/// The look of most, in the mean of their colours.
fn mean(looks: &[Look]) -> Option<Look> {
    let alike = |a: &Look, b: &Look| (a.kind, a.light) == (b.kind, b.light);
    let most = looks.iter().max_by_key(|look| looks.iter().filter(|other| alike(look, other)).count())?;
    let colors: Vec<u32> = looks.iter().filter(|look| alike(look, most)).map(|look| look.color).collect();
    Some(Look { color: super::looks::mean_color(&colors), ..*most })
}
