//! Which voxels of a few bricks emit, before and after an edit: those of the bricks that change and of the bricks beside them, whose faces they
//! may cover.

use super::light_tree::EmitterChange;
use crate::math::luminance;
use crate::packed::{Emitter, Geometry, PackedMaterial, covers, morton_order};
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::Face;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, block_bit, block_index};
use voxtrace_scene::ray::FACES;

/// What materials are to light.
#[derive(Clone, Debug)]
pub(super) struct Glow {
    /// Luminance of what the surface emits.
    luminances: Vec<f32>,
    /// Whether it covers the faces of lamps beside it.
    covers: Vec<bool>,
}

impl Glow {
    pub fn of(materials: &[PackedMaterial]) -> Self {
        Self {
            luminances: materials.iter().map(|material| luminance(material.surface_emission())).collect(),
            covers: materials.iter().map(|material| covers(material.transmission, material.metallic)).collect(),
        }
    }

    pub fn is_dark(&self) -> bool {
        self.luminances.iter().all(|&luminance| luminance <= 0.0)
    }

    fn emits(&self, material: u16) -> bool {
        self.luminances[usize::from(material)] > 0.0
    }
}

/// Bricks, each once, with those beside them.
pub(super) fn with_neighbours(bricks: impl Iterator<Item = IVec3>) -> Vec<IVec3> {
    let mut all: Vec<[i32; 3]> = bricks
        .flat_map(|brick| FACES.iter().map(move |face| brick + face.normal()).chain([brick]))
        .map(|brick| brick.to_array())
        .collect();
    all.sort_unstable();
    all.dedup();
    all.into_iter().map(IVec3::from_array).collect()
}

/// The emitters of each brick, in Morton order, as packing finds them.
pub(super) fn emitters_of(geometry: &Geometry, index: usize, bricks: &[IVec3], glow: &Glow) -> Vec<Vec<Emitter>> {
    bricks.par_iter().with_min_len(16).map(|&brick| emitters_of_brick(geometry, index, brick, glow)).collect()
}

fn emitters_of_brick(geometry: &Geometry, index: usize, at: IVec3, glow: &Glow) -> Vec<Emitter> {
    let (grid, corner) = (&geometry.grids[index], at * BRICK_SIZE);
    let Some(record) = geometry.find_brick(grid, corner) else { return Vec::new() };
    if !geometry.materials_of_record(grid, record).any(|material| glow.emits(material)) {
        return Vec::new();
    }
    let brick = geometry.decode_brick(grid, record);
    let around = Around::of(geometry, (index, corner, &brick), glow);
    if around.is_closed() {
        return Vec::new();
    }
    let mut emitters: Vec<Emitter> = (brick.voxels())
        .filter(|&(_, material)| glow.emits(material))
        .map(|(local, material)| Emitter {
            voxel: corner + local,
            grid: index as u32,
            faces: around.free_faces(local),
            material: material.into(),
            luminance: glow.luminances[usize::from(material)],
            leaf: 0,
        })
        .filter(|emitter| emitter.faces != 0)
        .collect();
    emitters.sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
    emitters
}

/// What covers the faces of the voxels of a brick: a bit for each voxel of it that does, and of the six bricks beside it.
struct Around {
    own: [u64; 8],
    beside: [[u64; 8]; 6],
}

impl Around {
    fn of(geometry: &Geometry, (index, corner, brick): (usize, IVec3, &Brick), glow: &Glow) -> Self {
        let grid = &geometry.grids[index];
        let of_face = |face: Face| {
            let Some(record) = geometry.find_brick(grid, corner + face.normal() * BRICK_SIZE) else { return [0; 8] };
            if geometry.materials_of_record(grid, record).all(|material| glow.covers[usize::from(material)]) {
                return geometry.masks(record);
            }
            covering(&geometry.decode_brick(grid, record), glow)
        };
        Self { own: covering(brick, glow), beside: FACES.map(of_face) }
    }

    /// Whether nothing of the brick can be seen: within large bodies, most bricks.
    fn is_closed(&self) -> bool {
        self.beside.iter().chain([&self.own]).all(|masks| *masks == [u64::MAX; 8])
    }

    /// Bit f is set where nothing that covers it is at face f of a voxel.
    fn free_faces(&self, local: IVec3) -> u32 {
        let is_free = |face: Face| {
            let at = local + face.normal();
            let inside = at & (BRICK_SIZE - 1);
            let masks = if at == inside { &self.own } else { &self.beside[face as usize] };
            masks[block_index(inside)] >> block_bit(inside) & 1 == 0
        };
        FACES.iter().map(|&face| u32::from(is_free(face)) << face as u32).sum()
    }
}

/// The voxels of a brick that cover what is beside them.
fn covering(brick: &Brick, glow: &Glow) -> [u64; 8] {
    let mut masks = [0; 8];
    for (local, _) in brick.voxels().filter(|(_, material)| glow.covers[usize::from(*material)]) {
        masks[block_index(local)] |= 1 << block_bit(local);
    }
    masks
}

/// What becomes of the emitters of some bricks, in Morton order.
pub(super) fn changes_of(before: Vec<Vec<Emitter>>, after: Vec<Vec<Emitter>>) -> Vec<EmitterChange> {
    let mut changes = Vec::new();
    for (before, after) in before.into_iter().zip(after) {
        let (mut before, mut after) = (before.into_iter().peekable(), after.into_iter().peekable());
        loop {
            let order = match (before.peek(), after.peek()) {
                (Some(a), Some(b)) => morton_order(a.voxel, b.voxel),
                (Some(_), None) => std::cmp::Ordering::Less,
                (None, Some(_)) => std::cmp::Ordering::Greater,
                (None, None) => break,
            };
            let was = if order.is_le() { before.next() } else { None };
            let now = if order.is_ge() { after.next() } else { None };
            if was != now {
                let voxel = was.or(now).map_or(IVec3::ZERO, |emitter| emitter.voxel);
                changes.push(EmitterChange { voxel, was: was.is_some(), now });
            }
        }
    }
    changes.par_sort_unstable_by(|a, b| morton_order(a.voxel, b.voxel));
    changes
}
