//! Dropping the voxels of a scene that nobody can see. Works brick by brick: eight layers of 8 × 8 bits each, moved against each
//! other by shifts. What lets light through counts as empty.

use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::sync::Arc;
use voxtrace_scene::brick::{Brick, bits, voxel_of};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::Scene;

/// Most bricks in the box around a grid that is filled from outside: 128 MiB of bits.
const MOST_BRICKS: u64 = 1 << 30;

/// Which voxels are dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hidden {
    /// Those whose six neighbours are all solid: nobody sees them from anywhere.
    Buried,
    /// Also the walls of closed hollows: nobody sees them from outside.
    Sealed,
}

/// A grid reaches too far to be filled from outside.
#[derive(Debug, thiserror::Error)]
#[error("a box of {size} bricks is too large to be filled from outside; what is buried can still be dropped")]
pub struct TooFar {
    /// Bricks along each axis.
    pub size: IVec3,
}

/// Drops what is hidden from every grid, each looked at by itself, and returns the number of voxels dropped. Takes about 80
/// bytes for each brick, and for [`Hidden::Sealed`] one bit for each brick of the box around a grid.
///
/// # Errors
/// If a grid is too large for [`Hidden::Sealed`]; the scene is unchanged then.
pub fn cull_hidden(scene: &mut Scene, hidden: Hidden) -> Result<u64, TooFar> {
    let mut grids = Vec::new();
    let mut dropped = 0;
    for grid in &scene.grids {
        let left = without_hidden(grid, &scene.materials, hidden)?;
        dropped += grid.count() - left.count();
        grids.push(if left.count() == grid.count() { Arc::clone(grid) } else { Arc::new(left) });
    }
    scene.grids = grids;
    Ok(dropped)
}

/// A bit for each voxel of a brick: layer z, bit x + 8 y.
type Mask = [u64; 8];

const FULL: Mask = [u64::MAX; 8];
const NONE: Mask = [0; 8];
/// The columns x = 0 and x = 7 of a layer.
const FIRST: u64 = 0x0101_0101_0101_0101;
const LAST: u64 = FIRST << 7;
const STEPS: [IVec3; 6] = [IVec3::NEG_X, IVec3::X, IVec3::NEG_Y, IVec3::Y, IVec3::NEG_Z, IVec3::Z];

fn without_hidden(grid: &VoxelGrid, materials: &[Material], hidden: Hidden) -> Result<VoxelGrid, TooFar> {
    let bricks = grid.sorted_bricks();
    let is_clear = |material: u16| materials.get(usize::from(material)).is_some_and(|m| m.transmission > 0.0);
    let clear: FxHashMap<IVec3, Mask> = bricks.par_iter().map(|&(at, brick)| (at, clear_of(brick, is_clear))).collect();
    let open = match hidden {
        Hidden::Buried => Open { bricks: clear, outside: None },
        Hidden::Sealed => filled_from_outside(&bricks, &clear)?,
    };
    let left = bricks.par_iter().map(|&(at, brick)| {
        let own = open.at(at);
        let mut seen = own;
        for (side, step) in STEPS.into_iter().enumerate() {
            seen = or(seen, or(moved(&own, side), entering(&open.at(at + step), side)));
        }
        (at, kept(brick, &seen))
    });
    Ok(VoxelGrid::from_bricks(left.collect::<Vec<_>>()))
}

/// The voxels of a brick through which one sees.
fn clear_of(brick: &Brick, is_clear: impl Fn(u16) -> bool) -> Mask {
    let mut mask = FULL;
    for (local, material) in brick.voxels() {
        if !is_clear(material) {
            mask[local.z as usize] &= !(1 << (local.x + 8 * local.y));
        }
    }
    mask
}

/// The brick with those voxels alone that are in the mask.
fn kept(brick: &Brick, mask: &Mask) -> Brick {
    let mut occupancy = *brick.occupancy();
    for (block, occupied) in occupancy.iter_mut().enumerate() {
        for bit in bits(*occupied) {
            let local = voxel_of(block, bit);
            if mask[local.z as usize] >> (local.x + 8 * local.y) & 1 == 0 {
                *occupied &= !(1 << bit);
            }
        }
    }
    let is_kept = |local: IVec3| mask[local.z as usize] >> (local.x + 8 * local.y) & 1 == 1;
    let materials = brick.voxels().filter(|(local, _)| is_kept(*local)).map(|(_, material)| material);
    Brick::new(occupancy, materials.collect())
}

fn or(a: Mask, b: Mask) -> Mask {
    std::array::from_fn(|z| a[z] | b[z])
}

/// A mask one voxel further, away from the neighbour on `side` (an index of [`STEPS`]); what leaves the brick is lost.
fn moved(mask: &Mask, side: usize) -> Mask {
    match side {
        0 => mask.map(|layer| layer << 1 & !FIRST),
        1 => mask.map(|layer| layer >> 1 & !LAST),
        2 => mask.map(|layer| layer << 8),
        3 => mask.map(|layer| layer >> 8),
        4 => std::array::from_fn(|z| if z > 0 { mask[z - 1] } else { 0 }),
        _ => std::array::from_fn(|z| if z < 7 { mask[z + 1] } else { 0 }),
    }
}

/// The voxels of a brick that touch those of the mask in the neighbour on `side`.
fn entering(neighbour: &Mask, side: usize) -> Mask {
    match side {
        0 => neighbour.map(|layer| (layer & LAST) >> 7),
        1 => neighbour.map(|layer| (layer & FIRST) << 7),
        2 => neighbour.map(|layer| layer >> 56),
        3 => neighbour.map(|layer| layer << 56),
        4 => std::array::from_fn(|z| if z == 0 { neighbour[7] } else { 0 }),
        _ => std::array::from_fn(|z| if z == 7 { neighbour[0] } else { 0 }),
    }
}

/// From where voxels are seen.
struct Open {
    /// The open voxels of bricks that hold something.
    bricks: FxHashMap<IVec3, Mask>,
    /// Which bricks without a voxel are outside; `None` where all of them count.
    outside: Option<Bits>,
}

impl Open {
    fn at(&self, at: IVec3) -> Mask {
        match (self.bricks.get(&at), &self.outside) {
            (Some(mask), _) => *mask,
            (None, Some(outside)) if !outside.get(at) => NONE,
            _ => FULL,
        }
    }
}

/// A bit for each brick of a box; what lies around the box is set.
struct Bits {
    min: IVec3,
    size: IVec3,
    words: Vec<u64>,
}

impl Bits {
    fn index(&self, at: IVec3) -> Option<usize> {
        let local = at - self.min;
        let is_inside = local.cmpge(IVec3::ZERO).all() && local.cmplt(self.size).all();
        let [x, y, z] = local.to_array().map(|c| c as usize);
        is_inside.then(|| (z * self.size.y as usize + y) * self.size.x as usize + x)
    }

    fn get(&self, at: IVec3) -> bool {
        self.index(at).is_none_or(|index| self.words[index / 64] >> (index % 64) & 1 == 1)
    }

    /// Sets a bit, and says whether it was clear.
    fn set(&mut self, at: IVec3) -> bool {
        let Some(index) = self.index(at) else { return false };
        let (word, bit) = (&mut self.words[index / 64], 1 << (index % 64));
        let was_clear = *word & bit == 0;
        *word |= bit;
        was_clear
    }
}

/// What is reached from outside through the faces of clear voxels.
fn filled_from_outside(bricks: &[(IVec3, &Brick)], clear: &FxHashMap<IVec3, Mask>) -> Result<Open, TooFar> {
    let min = bricks.iter().fold(IVec3::MAX, |min, (at, _)| min.min(*at)) - 1;
    let max = bricks.iter().fold(IVec3::MIN, |max, (at, _)| max.max(*at)) + 2;
    if bricks.is_empty() {
        return Ok(Open { bricks: FxHashMap::default(), outside: None });
    }
    let size = max - min;
    let count = size.to_array().iter().fold(1u64, |count, &edge| count.saturating_mul(edge as u64));
    if count > MOST_BRICKS {
        return Err(TooFar { size });
    }
    let mut outside = Bits { min, size, words: vec![0; (count as usize).div_ceil(64)] };
    let mut reached: FxHashMap<IVec3, Mask> = bricks.iter().map(|(at, _)| (*at, NONE)).collect();
    // The box has a border of empty bricks.
    outside.set(min);
    let mut waiting = vec![min];
    while let Some(at) = waiting.pop() {
        let from = reached.get(&at).copied().unwrap_or(FULL);
        for (side, step) in STEPS.into_iter().enumerate() {
            let next = at + step;
            // Seen from the neighbour, this brick lies on the other side.
            let enters = entering(&from, side ^ 1);
            if enters == NONE || outside.index(next).is_none() {
                continue;
            }
            let Some(mask) = reached.get_mut(&next) else {
                if outside.set(next) {
                    waiting.push(next);
                }
                continue;
            };
            let clear = clear.get(&next).copied().unwrap_or(FULL);
            let spread = spread(or(*mask, and(enters, clear)), clear);
            if spread != *mask {
                *mask = spread;
                waiting.push(next);
            }
        }
    }
    Ok(Open { bricks: reached, outside: Some(outside) })
}

fn and(a: Mask, b: Mask) -> Mask {
    std::array::from_fn(|z| a[z] & b[z])
}

/// All clear voxels of a brick that are reached from those of the mask.
fn spread(mut mask: Mask, clear: Mask) -> Mask {
    loop {
        let grown = (0..6).fold(mask, |grown, side| or(grown, and(moved(&mask, side), clear)));
        if grown == mask {
            return mask;
        }
        mask = grown;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    const GLASS: u16 = 1;

    fn materials() -> Vec<Material> {
        let plain = Material::default();
        vec![plain, Material { transmission: 0.9, ..plain }]
    }

    /// What is left, found voxel by voxel.
    fn expected(grid: &VoxelGrid, hidden: Hidden) -> VoxelGrid {
        let bounds = grid.bounds().unwrap();
        let is_clear = |voxel: IVec3| grid.get(voxel).is_none_or(|material| material == GLASS);
        let (min, max) = (bounds.min - 1, bounds.max + 1);
        let inside = |voxel: IVec3| voxel.cmpge(min).all() && voxel.cmplt(max).all();
        let mut reached = BTreeSet::from([min.to_array()]);
        let mut waiting = vec![min];
        while let Some(at) = waiting.pop() {
            for next in STEPS.map(|step| at + step) {
                if inside(next) && is_clear(next) && reached.insert(next.to_array()) {
                    waiting.push(next);
                }
            }
        }
        let is_open = |voxel: IVec3| match hidden {
            Hidden::Buried => is_clear(voxel),
            Hidden::Sealed => !inside(voxel) || reached.contains(&voxel.to_array()),
        };
        let mut left = VoxelGrid::new();
        for (voxel, material) in grid.voxels() {
            if is_open(voxel) || STEPS.iter().any(|&step| is_open(voxel + step)) {
                left.set(voxel, material);
            }
        }
        left
    }

    fn noise(seed: i32, percent: i32) -> VoxelGrid {
        let mut grid = VoxelGrid::new();
        let mut state = seed as u32;
        for z in -11..17 {
            for y in -3..21 {
                for x in 5..30 {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    if (state >> 16) as i32 % 100 < percent {
                        grid.set(IVec3::new(x, y, z), u16::from(state >> 8 & 15 == 0));
                    }
                }
            }
        }
        grid
    }

    #[test]
    fn what_is_left_is_what_a_search_voxel_by_voxel_leaves() {
        for percent in [10, 60, 75, 90, 100] {
            for hidden in [Hidden::Buried, Hidden::Sealed] {
                let grid = noise(percent, percent);
                let found = without_hidden(&grid, &materials(), hidden).unwrap();
                assert!(found == expected(&grid, hidden), "{percent} {hidden:?}");
                assert!(percent < 60 || found.count() < grid.count());
            }
        }
    }

    #[test]
    fn a_closed_hollow_is_sealed_until_it_has_a_window() {
        let mut grid = VoxelGrid::new();
        for z in 0..20 {
            for y in 0..20 {
                for x in 0..20 {
                    let voxel = IVec3::new(x, y, z);
                    if voxel.cmplt(IVec3::splat(3)).any() || voxel.cmpge(IVec3::splat(17)).any() {
                        grid.set(voxel, 0);
                    }
                }
            }
        }
        let shell = |edge: i32| (edge.pow(3) - (edge - 2).pow(3)) as u64;
        let count = |grid: &VoxelGrid, hidden| without_hidden(grid, &materials(), hidden).unwrap().count();
        assert_eq!(count(&grid, Hidden::Sealed), shell(20));
        assert_eq!(count(&grid, Hidden::Buried), shell(20) + shell(16) - edges_of_a_hollow());
        for depth in 0..3 {
            grid.set(IVec3::new(10, 10, 17 + depth), GLASS);
        }
        assert_eq!(count(&grid, Hidden::Sealed), count(&grid, Hidden::Buried));
    }

    /// Voxels of a shell of 16³ that touch the hollow by an edge or a corner alone: twelve edges of 14, eight corners.
    fn edges_of_a_hollow() -> u64 {
        12 * 14 + 8
    }

    #[test]
    fn a_scene_says_how_much_was_dropped_and_a_grid_that_reaches_too_far_is_refused() {
        let mut cube = VoxelGrid::new();
        (0..125).for_each(|i| {
            cube.set(IVec3::new(i % 5, i / 5 % 5, i / 25), 0);
        });
        let mut scene = Scene::from_grid("cube", cube.clone(), materials());
        assert_eq!(cull_hidden(&mut scene, Hidden::Sealed).unwrap(), 27);
        assert_eq!(scene.grids[0].count(), 98);
        assert_eq!(cull_hidden(&mut scene, Hidden::Sealed).unwrap(), 0);
        for at in [IVec3::splat(1 << 19), IVec3::splat(-(1 << 19))] {
            cube.set(at, 0);
        }
        let mut scene = Scene::from_grid("far", cube, materials());
        assert!(cull_hidden(&mut scene, Hidden::Sealed).is_err());
        assert_eq!(cull_hidden(&mut scene, Hidden::Buried).unwrap(), 27);
        assert_eq!(cull_hidden(&mut Scene::from_grid("", VoxelGrid::new(), Vec::new()), Hidden::Sealed).unwrap(), 0);
    }
}
