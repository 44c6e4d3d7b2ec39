//! The voxels of a grid in and around one brick of its next coarser level.

use crate::packed::coverage::FULL;
use crate::packed::lights::covers;
use crate::packed::{Geometry, PackedGrid, PackedMaterial};
use glam::IVec3;
use voxtrace_scene::brick::voxel_of;

/// Voxels around the brick: the next block's.
const MARGIN: i32 = 2;
/// Voxels along an edge: a brick of the level, and what is around it.
const EDGE: i32 = 16 + 2 * MARGIN;

/// A voxel.
#[derive(Clone, Copy, Default)]
pub struct Voxel {
    /// One more than its material, 0 where it is empty.
    material: u32,
    /// In sixteenths.
    coverage: u32,
}

impl Voxel {
    /// Its material.
    pub fn material(self) -> Option<usize> {
        (self.material as usize).checked_sub(1)
    }

    /// How much of it was full in the finest level, in sixteenths.
    pub fn coverage(self) -> u32 {
        self.coverage
    }
}

/// What is asked of a material again and again.
#[derive(Clone, Copy)]
pub struct Traits {
    /// Whether light does not enter.
    pub covers: bool,
    /// Whether its surface emits.
    pub emits: bool,
}

impl From<&PackedMaterial> for Traits {
    fn from(material: &PackedMaterial) -> Self {
        let emits = material.surface_emission().max_element() > 0.0;
        Self { covers: covers(material.transmission, material.metallic), emits }
    }
}

/// Voxels in and around a brick.
pub struct Window<'a> {
    geometry: &'a Geometry,
    /// Of each material.
    traits: &'a [Traits],
    voxels: Vec<Voxel>,
}

impl<'a> Window<'a> {
    pub fn new(geometry: &'a Geometry, traits: &'a [Traits]) -> Self {
        Self { geometry, traits, voxels: vec![Voxel::default(); (EDGE * EDGE * EDGE) as usize] }
    }

    /// Comes to the brick at `brick`, in bricks of the coarser level.
    pub fn load(&mut self, grid: &PackedGrid, brick: IVec3) {
        self.voxels.fill(Voxel::default());
        let corner = brick * 16;
        for index in 0..64 {
            let at = IVec3::new(index & 3, index >> 2 & 3, index >> 4) - 1;
            // Only what lies behind faces is asked for.
            let beside = at.to_array().iter().filter(|&&at| !(0..2).contains(&at)).count();
            if beside < 2
                && let Some(record) = self.geometry.find_brick(grid, corner + at * 8)
            {
                self.add(grid, record, at * 8 + MARGIN, &seen_of(at));
            }
        }
    }

    /// Enters the brick of a record, whose lowest voxel is at `corner` of the window, as far as it lies in there.
    fn add(&mut self, grid: &PackedGrid, record: usize, corner: IVec3, seen: &[u64; 8]) {
        let geometry = self.geometry;
        geometry.for_each_voxel(grid, record, seen, &mut |block, bit, rank, material| {
            let coverage = if geometry.has_coverage { geometry.coverage_of(record, rank) } else { FULL };
            self.voxels[index_of(corner + voxel_of(block, bit))] = Voxel { material: material + 1, coverage };
        });
    }

    /// The eight voxels of the block at `block`, from (0, 0, 0) to (7, 7, 7) within the brick and one beyond it, x fastest.
    pub fn block(&self, block: IVec3) -> [Voxel; 8] {
        std::array::from_fn(|child| self.voxels[index_of(place_of(block, child))])
    }

    /// Through how many of its faces light leaves the voxel `child` of a block.
    pub fn free_faces(&self, block: IVec3, child: usize) -> u32 {
        let at = place_of(block, child);
        let is_free = |side: &IVec3| {
            let material = self.voxels[index_of(at + side)].material();
            u32::from(material.is_none_or(|material| !self.traits[material].covers))
        };
        SIDES.iter().map(is_free).sum()
    }

    /// What is asked of a material.
    pub fn traits(&self, material: usize) -> Traits {
        self.traits[material]
    }
}

/// Which voxels of the brick at `at`, in bricks from the corner of the window's own, lie in the window: a bit for each, block by block.
fn seen_of(at: IVec3) -> [u64; 8] {
    // Of a brick behind a face the two layers next to it.
    const LOW: [u64; 3] = [0x3333_3333_3333_3333, 0x00ff_00ff_00ff_00ff, 0x0000_0000_ffff_ffff];
    let masks: [[u64; 2]; 3] = std::array::from_fn(|axis| match at[axis] {
        -1 => [0, !LOW[axis]],
        2 => [LOW[axis], 0],
        _ => [u64::MAX; 2],
    });
    std::array::from_fn(|block| masks[0][block & 1] & masks[1][block >> 1 & 1] & masks[2][block >> 2])
}

/// To the neighbours behind the faces.
pub const SIDES: [IVec3; 6] = [IVec3::NEG_X, IVec3::X, IVec3::NEG_Y, IVec3::Y, IVec3::NEG_Z, IVec3::Z];

fn place_of(block: IVec3, child: usize) -> IVec3 {
    let child = child as i32;
    block * 2 + MARGIN + IVec3::new(child & 1, child >> 1 & 1, child >> 2)
}

fn index_of(at: IVec3) -> usize {
    ((at.z * EDGE + at.y) * EDGE + at.x) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_bricks_around_the_layers_next_to_the_window_are_seen() {
        for index in 0..64 {
            let at = IVec3::new(index & 3, index >> 2 & 3, index >> 4) - 1;
            let seen = seen_of(at);
            for (block, bit) in (0..8).flat_map(|block| (0..64).map(move |bit| (block, bit))) {
                let place = at * 8 + MARGIN + voxel_of(block, bit);
                let is_within = place.cmpge(IVec3::ZERO).all() && place.cmplt(IVec3::splat(EDGE)).all();
                assert_eq!(seen[block] >> bit & 1 == 1, is_within, "{at}, block {block}, bit {bit}");
            }
        }
    }
}
