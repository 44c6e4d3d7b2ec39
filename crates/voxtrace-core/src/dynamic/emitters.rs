//! Which voxels of a few bricks emit, before and after an edit: those of the bricks that change and of the bricks beside them, whose faces they
//! may cover.

use super::layers::{Layers, in_morton_order, layers_of, uncovered};
use super::light_tree::EmitterChange;
use crate::math::luminance;
use crate::packed::{Emitter, Geometry, PackedMaterial, covers, morton_order};
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::{BRICK_SIZE, block_bit, block_index};
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

/// Bricks that one task looks at.
const CHUNK: usize = 64;

/// Bricks, each once, with those beside them, in Morton order.
pub(super) fn with_neighbours(bricks: impl Iterator<Item = IVec3>) -> Vec<IVec3> {
    let mut all: Vec<u64> = bricks
        .flat_map(|brick| FACES.iter().map(move |face| brick + face.normal()).chain([brick]))
        .map(|brick| key_of(brick))
        .collect();
    all.par_sort_unstable();
    all.dedup();
    all.into_iter().map(brick_of_key).collect()
}

/// The place of a brick in Morton order.
fn key_of(brick: IVec3) -> u64 {
    let along = |coordinate: i32| spread((coordinate + KEY_ORIGIN) as u64);
    along(brick.x) | along(brick.y) << 1 | along(brick.z) << 2
}

fn brick_of_key(key: u64) -> IVec3 {
    let along = |axis: u32| gathered(key >> axis) as i32 - KEY_ORIGIN;
    IVec3::new(along(0), along(1), along(2))
}

/// Keys have 21 bits for each axis; coordinates of bricks have fewer, and a sign.
const KEY_ORIGIN: i32 = 1 << 20;

/// Puts two zeros between each two of 21 bits.
fn spread(bits: u64) -> u64 {
    [
        (32, 0x1f_0000_0000_ffff),
        (16, 0x1f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ]
    .into_iter()
    .fold(bits, |bits, (shift, mask)| (bits | bits << shift) & mask)
}

/// The inverse of [`spread`]; the bits between do not count.
fn gathered(bits: u64) -> u64 {
    [
        (2, 0x10c3_0c30_c30c_30c3),
        (4, 0x100f_00f0_0f00_f00f),
        (8, 0x1f_0000_ff00_00ff),
        (16, 0x1f_0000_0000_ffff),
        (32, 0x1f_ffff),
    ]
    .into_iter()
    .fold(bits & 0x1249_2492_4924_9249, |bits, (shift, mask)| (bits | bits >> shift) & mask)
}

/// The emitters of each brick, in Morton order, as packing finds them.
pub(super) fn emitters_of(geometry: &Geometry, index: usize, bricks: &[IVec3], glow: &Glow) -> Vec<Vec<Emitter>> {
    bricks.par_iter().with_min_len(CHUNK).map(|&brick| emitters_of_brick(geometry, index, brick, glow)).collect()
}

fn emitters_of_brick(geometry: &Geometry, index: usize, at: IVec3, glow: &Glow) -> Vec<Emitter> {
    let (grid, corner) = (&geometry.grids[index], at * BRICK_SIZE);
    let Some(record) = geometry.find_brick(grid, corner) else { return Vec::new() };
    let mut materials = geometry.materials_of_record(grid, record);
    let first = materials.next().unwrap_or_default();
    let is_of_one = materials.all(|material| material == first);
    if !glow.emits(first) && (is_of_one || !geometry.materials_of_record(grid, record).any(|other| glow.emits(other))) {
        return Vec::new();
    }
    // Most bricks of large lamps lie within them.
    let own = covering(geometry, index, record, glow);
    let beside = FACES.map(|face| {
        let record = geometry.find_brick(grid, corner + face.normal() * BRICK_SIZE);
        record.map_or([0; 8], |record| covering(geometry, index, record, glow))
    });
    if beside.iter().chain([&own]).all(|layers| *layers == [u64::MAX; 8]) {
        return Vec::new();
    }
    let brick = (!is_of_one).then(|| geometry.decode_brick(grid, record));
    let emissive = match &brick {
        None => layers_of(&geometry.masks(record)),
        Some(brick) => {
            let mut masks = [0; 8];
            for (local, _) in brick.voxels().filter(|&(_, material)| glow.emits(material)) {
                masks[block_index(local)] |= 1 << block_bit(local);
            }
            layers_of(&masks)
        }
    };
    let free = uncovered(&own, &beside);
    let seen: Layers = std::array::from_fn(|z| emissive[z] & free.iter().fold(0, |any, layers| any | layers[z]));
    let emitter = |local: IVec3| {
        let (z, bit) = (local.z as usize, local.x | local.y << 3);
        let material = brick.as_ref().and_then(|brick| brick.get(local)).unwrap_or(first);
        Emitter {
            voxel: corner + local,
            grid: index as u32,
            faces: (0..6).map(|face| ((free[face][z] >> bit & 1) as u32) << face).sum(),
            material: material.into(),
            luminance: glow.luminances[usize::from(material)],
            leaf: 0,
        }
    };
    in_morton_order(&seen).map(emitter).collect()
}

/// The voxels of a brick that cover what is beside them.
fn covering(geometry: &Geometry, index: usize, record: usize, glow: &Glow) -> Layers {
    let grid = &geometry.grids[index];
    if geometry.materials_of_record(grid, record).all(|material| glow.covers[usize::from(material)]) {
        return layers_of(&geometry.masks(record));
    }
    let mut masks = [0; 8];
    let brick = geometry.decode_brick(grid, record);
    for (local, _) in brick.voxels().filter(|(_, material)| glow.covers[usize::from(*material)]) {
        masks[block_index(local)] |= 1 << block_bit(local);
    }
    layers_of(&masks)
}

/// What becomes of the emitters of some bricks, which are in Morton order as their emitters are.
pub(super) fn changes_of(before: Vec<Vec<Emitter>>, after: Vec<Vec<Emitter>>) -> Vec<EmitterChange> {
    before
        .into_par_iter()
        .zip(after)
        .with_min_len(CHUNK)
        .flat_map_iter(|(before, after)| changes_of_brick(&before, &after))
        .collect()
}

fn changes_of_brick(before: &[Emitter], after: &[Emitter]) -> Vec<EmitterChange> {
    let mut changes = Vec::with_capacity(before.len().max(after.len()));
    let (mut before, mut after) = (before.iter().copied().peekable(), after.iter().copied().peekable());
    loop {
        let order = match (before.peek(), after.peek()) {
            (Some(a), Some(b)) => morton_order(a.voxel, b.voxel),
            (Some(_), None) => std::cmp::Ordering::Less,
            (None, Some(_)) => std::cmp::Ordering::Greater,
            (None, None) => return changes,
        };
        let was = if order.is_le() { before.next() } else { None };
        let now = if order.is_ge() { after.next() } else { None };
        if was != now {
            let voxel = was.or(now).map_or(IVec3::ZERO, |emitter| emitter.voxel);
            changes.push(EmitterChange { voxel, was: was.is_some(), now });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_sort_as_morton_order_does_and_have_their_bricks() {
        let mut random = crate::dynamic::tests::plain::Random(3);
        let reach = (voxtrace_scene::grid::MAX_COORDINATE >> 3) + 2;
        for round in 0..20_000 {
            let reach = if round % 2 == 0 { reach } else { 3 };
            let (a, b) = (random.voxel(reach), random.voxel(reach));
            assert_eq!(brick_of_key(key_of(a)), a);
            assert_eq!(key_of(a).cmp(&key_of(b)), morton_order(a, b), "{a} {b}");
        }
    }
}
