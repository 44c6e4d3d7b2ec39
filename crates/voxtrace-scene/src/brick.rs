//! The brick: 8×8×8 voxels as a 512-bit occupancy (eight 4×4×4 blocks of 64 bits) and one material for each
//! occupied voxel, in rank order. Empty voxels cost one bit, occupied ones a bit and a material.

use glam::IVec3;

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
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Brick {
    occupancy: [u64; 8],
    materials: Vec<u16>,
}

impl Brick {
    /// A brick from its occupancy and the materials of the occupied voxels in rank order.
    ///
    /// # Panics
    /// If the number of materials is not the number of occupied voxels.
    pub fn new(occupancy: [u64; 8], materials: Vec<u16>) -> Self {
        let brick = Self { occupancy, materials };
        assert_eq!(brick.count(), brick.materials.len(), "one material for each occupied voxel");
        brick
    }

    /// The eight 64-bit masks, block by block.
    pub fn occupancy(&self) -> &[u64; 8] {
        &self.occupancy
    }

    /// Materials of the occupied voxels in rank order.
    pub fn materials(&self) -> &[u16] {
        &self.materials
    }

    /// Number of occupied voxels.
    pub fn count(&self) -> usize {
        self.occupancy.iter().map(|mask| mask.count_ones() as usize).sum()
    }

    /// Whether no voxel is occupied.
    pub fn is_empty(&self) -> bool {
        self.materials.is_empty()
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
        occupied.then(|| self.materials[self.rank(local)])
    }

    /// Occupies the voxel `local` with `material`, or empties it with `None`. Returns what was there.
    pub fn set(&mut self, local: IVec3, material: Option<u16>) -> Option<u16> {
        let (block, bit) = (block_index(local), 1u64 << block_bit(local));
        let rank = self.rank(local);
        let was_occupied = self.occupancy[block] & bit != 0;
        match (was_occupied, material) {
            (true, Some(material)) => Some(std::mem::replace(&mut self.materials[rank], material)),
            (true, None) => {
                self.occupancy[block] &= !bit;
                Some(self.materials.remove(rank))
            }
            (false, Some(material)) => {
                self.occupancy[block] |= bit;
                self.materials.insert(rank, material);
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
        let mut rank = 0;
        (0..8).flat_map(move |block| bits(self.occupancy[block]).map(move |bit| voxel_of(block, bit))).map(
            move |local| {
                rank += 1;
                (local, self.materials[rank - 1])
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
