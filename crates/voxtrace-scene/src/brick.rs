//! The brick: 8×8×8 voxels as a 512-bit occupancy (eight 4×4×4 blocks of 64 bits) and one material for each
//! occupied voxel, in rank order. Empty voxels cost one bit, occupied ones a bit and a material.

use glam::IVec3;
use std::sync::Arc;

/// Voxels along one edge of a brick.
pub const BRICK_SIZE: i32 = 8;
/// Voxels along one edge of a block, the part of a brick that one 64-bit mask covers.
pub const BLOCK_SIZE: i32 = 4;

/// Index of the block (0..8, x fastest) that holds the voxel `local`, each coordinate in 0..8.
#[inline]
pub fn block_index(local: IVec3) -> usize {
    ((local.x >> 2) | (local.y >> 2) << 1 | (local.z >> 2) << 2) as usize
}

/// Bit (0..64, x fastest) of the voxel `local` within its block.
#[inline]
pub fn block_bit(local: IVec3) -> u32 {
    ((local.x & 3) | (local.y & 3) << 2 | (local.z & 3) << 4) as u32
}

/// The voxel, each coordinate in 0..8, of a block and a bit: the inverse of [`block_index`] and [`block_bit`].
#[inline]
pub fn voxel_of(block: usize, bit: u32) -> IVec3 {
    let (block, bit) = (block as i32, bit as i32);
    IVec3::new((block & 1) << 2 | bit & 3, (block >> 1 & 1) << 2 | bit >> 2 & 3, (block >> 2) << 2 | bit >> 4)
}

/// 8×8×8 voxels, editable. The rank of a voxel is the number of occupied voxels before it, block by block and
/// within a block bit by bit; `materials[rank]` is its material.
#[derive(Clone, Debug)]
pub struct Brick {
    occupancy: [u64; 8],
    materials: Materials,
}

/// Materials in rank order.
#[derive(Clone, Debug)]
enum Materials {
    Own(Vec<u16>),
    /// The first of those that several bricks share, as many as there are voxels.
    Shared(Arc<[u16]>),
}

impl Default for Brick {
    fn default() -> Self {
        Self { occupancy: [0; 8], materials: Materials::Own(Vec::new()) }
    }
}

impl PartialEq for Brick {
    fn eq(&self, other: &Self) -> bool {
        self.occupancy == other.occupancy && self.materials() == other.materials()
    }
}

impl Eq for Brick {}

impl Brick {
    /// A brick from its occupancy and the materials of the occupied voxels in rank order.
    ///
    /// # Panics
    /// If the number of materials is not the number of occupied voxels.
    pub fn new(occupancy: [u64; 8], materials: Vec<u16>) -> Self {
        let count = materials.len();
        let brick = Self { occupancy, materials: Materials::Own(materials) };
        assert_eq!(brick.count(), count, "one material for each occupied voxel");
        brick
    }

    /// A brick from its occupancy and materials in rank order that it shares with other bricks until it is changed; those beyond its last voxel do not count. Large
    /// grids have many bricks of one material.
    ///
    /// # Panics
    /// If there are fewer materials than occupied voxels.
    pub fn sharing(occupancy: [u64; 8], materials: Arc<[u16]>) -> Self {
        let length = materials.len();
        let brick = Self { occupancy, materials: Materials::Shared(materials) };
        assert!(brick.count() <= length, "a material for each occupied voxel");
        brick
    }

    /// The eight 64-bit masks, block by block.
    pub fn occupancy(&self) -> &[u64; 8] {
        &self.occupancy
    }

    /// Materials of the occupied voxels in rank order.
    pub fn materials(&self) -> &[u16] {
        match &self.materials {
            Materials::Own(materials) => materials,
            Materials::Shared(materials) => &materials[..self.count()],
        }
    }

    /// Materials of its own, to be changed.
    fn own_materials(&mut self) -> &mut Vec<u16> {
        if let Materials::Shared(materials) = &self.materials {
            self.materials = Materials::Own(materials[..self.count()].to_vec());
        }
        match &mut self.materials {
            Materials::Own(materials) => materials,
            Materials::Shared(_) => unreachable!("they are its own now"),
        }
    }

    /// Number of occupied voxels.
    pub fn count(&self) -> usize {
        self.occupancy.iter().map(|mask| mask.count_ones() as usize).sum()
    }

    /// Whether no voxel is occupied.
    pub fn is_empty(&self) -> bool {
        self.occupancy == [0; 8]
    }

    /// Number of occupied voxels before `local`.
    pub fn rank(&self, local: IVec3) -> usize {
        let block = block_index(local);
        let before = self.occupancy[..block].iter().map(|mask| mask.count_ones()).sum::<u32>();
        let mask = self.occupancy[block] & ((1 << block_bit(local)) - 1);
        (before + mask.count_ones()) as usize
    }

    /// The material of the voxel `local`, `None` where it is empty.
    pub fn get(&self, local: IVec3) -> Option<u16> {
        let occupied = self.occupancy[block_index(local)] >> block_bit(local) & 1 != 0;
        let rank = || self.rank(local);
        occupied.then(|| match &self.materials {
            Materials::Own(materials) => materials[rank()],
            Materials::Shared(materials) => materials[rank()],
        })
    }

    /// Occupies the voxel `local` with `material`, or empties it with `None`. Returns what was there.
    pub fn set(&mut self, local: IVec3, material: Option<u16>) -> Option<u16> {
        let (block, bit) = (block_index(local), 1u64 << block_bit(local));
        let rank = self.rank(local);
        let was_occupied = self.occupancy[block] & bit != 0;
        match (was_occupied, material) {
            (true, Some(material)) => Some(std::mem::replace(&mut self.own_materials()[rank], material)),
            (true, None) => {
                let was = self.own_materials().remove(rank);
                self.occupancy[block] &= !bit;
                Some(was)
            }
            (false, Some(material)) => {
                self.own_materials().insert(rank, material);
                self.occupancy[block] |= bit;
                None
            }
            (false, None) => None,
        }
    }

    /// Lowest occupied coordinates and one past the highest, 0 to 8; the lowest above the highest in an empty brick.
    pub fn extent(&self) -> (IVec3, IVec3) {
        let (mut min, mut max) = (IVec3::splat(BRICK_SIZE), IVec3::ZERO);
        for (block, &mask) in self.occupancy.iter().enumerate().filter(|(_, mask)| **mask != 0) {
            for bit in bits(mask) {
                let local = voxel_of(block, bit);
                (min, max) = (min.min(local), max.max(local + 1));
            }
        }
        (min, max)
    }

    /// The voxels of `with` inside the mask, a bit for each, block by block, and its own outside.
    pub fn replaced(&self, with: &Brick, mask: &[u64; 8]) -> Brick {
        let mut occupancy = [0; 8];
        let mut materials = Vec::new();
        let (mut old_left, mut with_left) = (self.materials(), with.materials());
        for block in 0..8 {
            let (old_block, with_block) = (self.occupancy()[block], with.occupancy()[block]);
            let (old_materials, with_materials);
            (old_materials, old_left) = old_left.split_at(old_block.count_ones() as usize);
            (with_materials, with_left) = with_left.split_at(with_block.count_ones() as usize);
            occupancy[block] = old_block & !mask[block] | with_block & mask[block];
            for bit in bits(occupancy[block]) {
                let before = (1 << bit) - 1;
                materials.push(if mask[block] >> bit & 1 != 0 {
                    with_materials[(with_block & before).count_ones() as usize]
                } else {
                    old_materials[(old_block & before).count_ones() as usize]
                });
            }
        }
        Brick::new(occupancy, materials)
    }

    /// The occupied voxels in rank order: coordinates in 0..8 and material.
    pub fn voxels(&self) -> impl Iterator<Item = (IVec3, u16)> + '_ {
        let (mut rank, materials) = (0, self.materials());
        (0..8).flat_map(move |block| bits(self.occupancy[block]).map(move |bit| voxel_of(block, bit))).map(
            move |local| {
                rank += 1;
                (local, materials[rank - 1])
            },
        )
    }
}

/// The set bits of a mask, lowest first.
pub fn bits(mut mask: u64) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let bit = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (bit < 64).then_some(bit)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bricks_that_share_materials_are_like_others_and_change_alone() {
        let shared: Arc<[u16]> = Arc::from([7; 512]);
        let occupancy = [u64::MAX, 0x0f, 0, 0, 0, 0, 0, 1 << 63];
        let own = Brick::new(occupancy, vec![7; 64 + 4 + 1]);
        let first = Brick::sharing(occupancy, shared.clone());
        assert_eq!(first, own);
        assert_eq!(first.materials(), own.materials());
        assert!(first.voxels().eq(own.voxels()));
        let mut changed = [first.clone(), own.clone()];
        for brick in &mut changed {
            assert_eq!(brick.set(IVec3::new(4, 0, 0), None), Some(7));
            assert_eq!(brick.set(IVec3::new(0, 0, 0), Some(3)), Some(7));
            assert_eq!(brick.set(IVec3::new(0, 7, 7), Some(4)), None);
        }
        assert_eq!(changed[0], changed[1]);
        assert_eq!((first.get(IVec3::ZERO), changed[0].get(IVec3::ZERO)), (Some(7), Some(3)));
        assert_ne!(first, changed[0]);
        assert_eq!(Brick::sharing(occupancy, shared), own, "what it shared is as it was");
    }
}
