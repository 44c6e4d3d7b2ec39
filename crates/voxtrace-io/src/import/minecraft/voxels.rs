//! From blocks to voxels: each state is modelled once, each way in which others cover it makes one variant of bricks, and these are put
//! wherever such a block stands. Voxels that blocks hide from each other are not made, so that memory goes to surfaces.

use super::blocks::{Kind, Look};
use super::looks::Looks;
use super::model::{FACES, Model, is_watered, model};
use super::neighbours::{Link, link_of, linked};
use super::palette::Palette;
use super::places::{BLOCKS, Places, SECTION, Section, index, local};
use super::state::State;
use crate::import::grids::dense;
use crate::import::reader::{NotShown, Voxels};
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::path::Path;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::{ImportError, Limits};

/// No material has this number.
const EMPTY: u16 = u16::MAX;
/// Most states, whose numbers begin at 1.
const STATES: usize = u16::MAX as usize - 1;
/// Steps to neighbours in the order of the faces' bits.
const STEPS: [IVec3; FACES] = [IVec3::NEG_X, IVec3::X, IVec3::NEG_Y, IVec3::Y, IVec3::NEG_Z, IVec3::Z];
/// In the key of a variant, above the six bits of covered faces: that its liquid goes on above.
const FLOODED: u32 = 1 << FACES;
/// Bits of a key below the state's.
const SHIFT: u32 = 7;

/// How blocks become voxels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fineness {
    /// Voxels along an edge of a block: 1, 2, 4, 8 or 16.
    pub edge: usize,
    /// Whether voxels that nobody sees are left out.
    pub shell: bool,
}

/// A state, and what is asked of it often.
struct Known {
    state: State,
    link: Link,
    /// Water or lava that it holds.
    liquid: Option<&'static str>,
}

/// A block's voxels by their materials, and which of its faces hide what lies behind them.
struct Solid {
    cells: Vec<u16>,
    /// Cells that light does not pass.
    opaque: Vec<bool>,
    hides: u32,
}

/// A block among others.
struct Variant {
    /// Voxels of blocks smaller than a brick.
    cells: Vec<u16>,
    /// Bricks of larger blocks, from the block's lowest on.
    bricks: Vec<(IVec3, Brick)>,
    voxels: u64,
}

/// Blocks in the making of voxels.
pub(super) struct Blocks {
    fineness: Fineness,
    known: Vec<Known>,
    by_state: FxHashMap<State, u16>,
    looks: Looks,
    palette: Palette,
    /// By states, and by whether they are flooded.
    solids: FxHashMap<(u16, bool), Solid>,
    /// Voxels of all grids so far.
    made: u64,
    pub notes: Vec<String>,
    /// Entities that the files hold: mobs, minecarts, item frames.
    pub entities: u64,
}

impl Blocks {
    pub fn new(fineness: Fineness, looks: Looks) -> Self {
        Self {
            fineness,
            known: Vec::new(),
            by_state: FxHashMap::default(),
            looks,
            palette: Palette::new(fineness.edge),
            solids: FxHashMap::default(),
            made: 0,
            notes: Vec::new(),
            entities: 0,
        }
    }

    /// Voxels along an edge of a block.
    pub fn edge(&self) -> i32 {
        self.fineness.edge as i32
    }

    /// The number of a state, from 1 on; 0 for what nobody sees.
    pub fn number(&mut self, state: State) -> u16 {
        if let Some(&number) = self.by_state.get(&state) {
            return number;
        }
        let number = if self.looks.seen(&state).is_none() { 0 } else { (self.known.len() + 1).min(STATES) as u16 };
        if usize::from(number) > self.known.len() {
            let liquid = match state.name.as_str() {
                "water" | "bubble_column" => Some("water"),
                "lava" => Some("lava"),
                _ => is_watered(&state).then_some("water"),
            };
            self.known.push(Known { link: link_of(&state), liquid, state: state.clone() });
        }
        self.by_state.insert(state, number);
        number
    }

    fn known(&self, number: u16) -> Option<&Known> {
        self.known.get(usize::from(number).checked_sub(1)?)
    }

    /// The voxels of blocks.
    ///
    /// # Errors
    /// If they are more than the limits allow.
    pub fn grid(&mut self, mut places: Places, path: &Path, limits: &Limits) -> Result<VoxelGrid, ImportError> {
        if self.fineness.edge > 1 {
            self.join(&mut places);
        }
        let sections = places.sorted();
        let volume = (self.fineness.edge as u64).pow(3);
        let check = |what: &str, voxels: u64| match voxels > limits.voxels {
            true => Err(ImportError::limit(path, Some(0), what, voxels, limits.voxels)),
            false => Ok(()),
        };
        let bare = self.counts(&places, &sections, false);
        check("voxels of kinds of blocks", volume * (self.solids.len() + bare.len()) as u64)?;
        let mut keys: Vec<u32> = bare.keys().copied().collect();
        keys.sort_unstable();
        keys.iter().for_each(|&key| self.model((key >> SHIFT) as u16, key & FLOODED != 0));

        let counts = if self.covers() { self.counts(&places, &sections, true) } else { bare };
        check("voxels of kinds of blocks", volume * counts.len() as u64)?;
        let variants: FxHashMap<u32, Variant> = counts.par_iter().map(|(&key, _)| (key, self.variant(key))).collect();
        let voxels = counts.iter().map(|(key, count)| count * variants[key].voxels).fold(0, u64::saturating_add);
        self.made = self.made.saturating_add(voxels);
        check("voxels", self.made)?;
        let bricks = sections.par_iter().flat_map_iter(|&(at, of)| self.bricks(&variants, &places, at, of));
        Ok(VoxelGrid::from_bricks(bricks.collect::<Vec<_>>()))
    }

    /// Whether blocks hide parts of each other.
    fn covers(&self) -> bool {
        self.fineness.edge > 1 && self.fineness.shell
    }

    /// Gives blocks what they take from their neighbours.
    fn join(&mut self, places: &mut Places) {
        let this = &*self;
        let joined = |&(at, of): &(IVec3, &Section)| {
            let mut found = Vec::new();
            for (index, &number) in of.iter().enumerate() {
                let Some(known) = this.known(number).filter(|known| known.link != Link::Nothing) else { continue };
                let around = |step: IVec3| Some(&this.known(places.get(at, of, local(index) + step))?.state);
                found.push((at, index, linked(&known.state, &around)));
            }
            found
        };
        let changes: Vec<(IVec3, usize, State)> = places.sorted().par_iter().flat_map_iter(joined).collect();
        for (at, index, state) in changes {
            let number = self.number(state);
            if let Some(section) = places.sections.get_mut(&at) {
                section[index] = number;
            }
        }
    }

    /// The key of a block's variant; `None` where there is none.
    fn key(&self, places: &Places, at: IVec3, of: &Section, index: usize, is_covered: bool) -> Option<u32> {
        let number = of[index];
        let known = self.known(number)?;
        let mut key = u32::from(number) << SHIFT;
        if self.fineness.edge == 1 {
            return Some(key);
        }
        let place = local(index);
        if known.liquid.is_some() {
            let above = self.known(places.get(at, of, place + IVec3::Z));
            if above.is_some_and(|above| above.liquid == known.liquid) {
                key |= FLOODED;
            }
        }
        if is_covered {
            for (face, step) in STEPS.into_iter().enumerate() {
                let other = places.get(at, of, place + step);
                // Whether it is flooded changes nothing about what light does not pass.
                let hides = other != 0
                    && self
                        .solids
                        .get(&(other, false))
                        .or_else(|| self.solids.get(&(other, true)))
                        .is_some_and(|solid| solid.hides >> (face ^ 1) & 1 != 0);
                key |= u32::from(hides) << face;
            }
        }
        Some(key)
    }

    /// How many blocks there are of each variant.
    fn counts(&self, places: &Places, sections: &[(IVec3, &Section)], is_covered: bool) -> FxHashMap<u32, u64> {
        let of_section = |&(at, of): &(IVec3, &Section)| {
            let mut counts: FxHashMap<u32, u64> = FxHashMap::default();
            for key in (0..BLOCKS).filter_map(|index| self.key(places, at, of, index, is_covered)) {
                *counts.entry(key).or_default() += 1;
            }
            counts
        };
        let merged = |mut all: FxHashMap<u32, u64>, more: FxHashMap<u32, u64>| {
            more.into_iter().for_each(|(key, count)| *all.entry(key).or_default() += count);
            all
        };
        sections.par_iter().map(of_section).reduce(FxHashMap::default, merged)
    }

    /// Models a state.
    fn model(&mut self, number: u16, is_flooded: bool) {
        if self.solids.contains_key(&(number, is_flooded)) {
            return;
        }
        let Some(known) = self.known.get(usize::from(number) - 1) else { return };
        let edge = self.fineness.edge;
        let model = match self.looks.seen(&known.state) {
            // A block is a voxel, whatever its shape.
            Some(look) if edge == 1 && self.looks.pack.is_none() => Model { edge, cells: vec![Some(look)] },
            _ => model(&known.state, is_flooded, edge, &mut self.looks),
        };
        let is_opaque = |look: &Look| matches!(look.kind, Kind::Plain | Kind::Metal);
        let opaque: Vec<bool> = model.cells.iter().map(|cell| cell.as_ref().is_some_and(is_opaque)).collect();
        let palette = &mut self.palette;
        let cells = model.cells.iter().map(|cell| cell.map_or(EMPTY, |look| palette.material(look))).collect();
        let hides = (0..FACES).filter(|&face| layer(edge, face).all(|cell| opaque[cell])).map(|face| 1 << face).sum();
        self.solids.insert((number, is_flooded), Solid { cells, opaque, hides });
    }

    /// The voxels of a block that others cover in a way.
    fn variant(&self, key: u32) -> Variant {
        let solid = &self.solids[&((key >> SHIFT) as u16, key & FLOODED != 0)];
        let edge = self.fineness.edge;
        let mut cells = solid.cells.clone();
        if self.covers() {
            let size = IVec3::splat(edge as i32);
            for (index, cell) in cells.iter_mut().enumerate() {
                let at =
                    IVec3::new((index % edge) as i32, (index / edge % edge) as i32, (index / (edge * edge)) as i32);
                let is_hidden = STEPS.into_iter().enumerate().all(|(face, step)| {
                    let next = at + step;
                    if next.cmpge(IVec3::ZERO).all() && next.cmplt(size).all() {
                        solid.opaque[((next.z * size.y + next.y) * size.x + next.x) as usize]
                    } else {
                        key >> face & 1 != 0
                    }
                });
                if is_hidden {
                    *cell = EMPTY;
                }
            }
        }
        let voxels = cells.iter().filter(|&&cell| cell != EMPTY).count() as u64;
        let across = edge as i32 / BRICK_SIZE;
        let mut bricks = Vec::new();
        for part in 0..across.pow(3) {
            let corner = IVec3::new(part % across, part / across % across, part / (across * across));
            let brick = dense::brick(|at| {
                let at = corner * BRICK_SIZE + at;
                let cell = cells[((at.z * self.edge() + at.y) * self.edge() + at.x) as usize];
                (cell != EMPTY).then_some(cell)
            });
            if !brick.is_empty() {
                bricks.push((corner, brick));
            }
        }
        let cells = if across > 0 { Vec::new() } else { cells };
        Variant { cells, bricks, voxels }
    }

    /// The bricks of a section.
    fn bricks(
        &self,
        variants: &FxHashMap<u32, Variant>,
        places: &Places,
        at: IVec3,
        of: &Section,
    ) -> Vec<(IVec3, Brick)> {
        let key = |index: usize| self.key(places, at, of, index, self.covers());
        let edge = self.edge();
        let mut found = Vec::new();
        if edge >= BRICK_SIZE {
            let across = edge / BRICK_SIZE;
            for index in 0..BLOCKS {
                let Some(variant) = key(index).map(|key| &variants[&key]) else { continue };
                let corner = (at * SECTION + local(index)) * across;
                found.extend(variant.bricks.iter().map(|(part, brick)| (corner + *part, brick.clone())));
            }
            return found;
        }
        let variants: Vec<Option<&Variant>> = (0..BLOCKS).map(|index| key(index).map(|key| &variants[&key])).collect();
        let across = SECTION * edge / BRICK_SIZE;
        for part in 0..across.pow(3) {
            let corner = IVec3::new(part % across, part / across % across, part / (across * across));
            let brick = dense::brick(|voxel| {
                let voxel = corner * BRICK_SIZE + voxel;
                let (block, cell) = (voxel / edge, voxel % edge);
                let variant = variants[index(block)]?;
                let cell = variant.cells[((cell.z * edge + cell.y) * edge + cell.x) as usize];
                (cell != EMPTY).then_some(cell)
            });
            if !brick.is_empty() {
                found.push((at * across + corner, brick));
            }
        }
        found
    }

    /// The scene with its materials, and what there is to say.
    pub fn finish(mut self, mut scene: Scene) -> Voxels {
        scene.materials = self.palette.finish();
        if let Some(pack) = &self.looks.pack {
            self.notes.extend(pack.note());
            if !pack.is_used() {
                self.notes.push("no block has a picture in the resource pack; all have colours of ours".into());
            }
        }
        self.notes.extend(self.looks.note());
        let mut parts = NotShown::default();
        parts.count("entity", self.entities);
        self.notes.extend(parts.note());
        Voxels { scene, notes: self.notes }
    }
}

/// The cells of a model at one of its faces.
fn layer(edge: usize, face: usize) -> impl Iterator<Item = usize> {
    let (axis, end) = (face / 2, if face.is_multiple_of(2) { 0 } else { edge - 1 });
    (0..edge * edge).map(move |place| {
        let (a, b) = (place % edge, place / edge);
        let [x, y, z] = match axis {
            0 => [end, a, b],
            1 => [a, end, b],
            _ => [a, b, end],
        };
        (z * edge + y) * edge + x
    })
}
