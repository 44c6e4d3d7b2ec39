//! The record of a brick in the spill buffer: a byte of flags, a byte that says which 4³ blocks have voxels, the masks of these
//! blocks (8 bytes each), then one appearance key for each voxel in rank order, or a single one for all. A brick that is not finished
//! has the same blocks and masks without flags, and then the sums of each voxel.

use crate::voxelize::appearance::{AppearanceKey, MAX_BSDF_CLASSES};
use crate::voxelize::points::VoxelSums;
use glam::IVec3;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, bits, voxel_of};

/// Bias of brick coordinates where they are packed into 21 bits each.
const BIAS: i32 = 1 << 20;
/// Flag: all voxels of the brick have one appearance.
const UNIFORM: u8 = 1;
/// Flag: keys have all 8 bytes, with the emission; else the lower 4.
const EMITS: u8 = 2;

/// The encoded bricks of a tile.
#[derive(Default)]
pub struct TileRecords {
    pub bytes: Vec<u8>,
    /// Of each brick: its coordinates, and where its record ends in `bytes`.
    pub bricks: Vec<(IVec3, u32)>,
    /// Number of voxels in all of them.
    pub voxels: u64,
    /// The same of bricks that are not finished: their coordinates and where each ends in the bytes.
    pub sums: (Vec<u8>, Vec<(IVec3, u32)>),
}

impl TileRecords {
    /// Appends a brick. `keys` holds the appearance of each voxel in rank order, or a single one for all.
    pub fn push(&mut self, at: IVec3, occupancy: &[u64; 8], keys: &[AppearanceKey]) {
        let is_one = keys.iter().all(|&key| key == keys[0]);
        let emits = keys.iter().any(|&key| key >> 32 != 0);
        let blocks = (0..8).filter(|&block| occupancy[block] != 0).fold(0, |blocks, block| blocks | 1 << block);
        let flags = if is_one { UNIFORM } else { 0 } | if emits { EMITS } else { 0 };
        self.bytes.push(flags);
        self.bytes.push(blocks);
        for &mask in occupancy.iter().filter(|&&mask| mask != 0) {
            self.bytes.extend(mask.to_le_bytes());
            self.voxels += u64::from(mask.count_ones());
        }
        for &key in if is_one { &keys[..1] } else { keys } {
            self.bytes.extend(&key.to_le_bytes()[..if emits { 8 } else { 4 }]);
        }
        self.bricks.push((at, self.bytes.len() as u32));
    }
}

impl TileRecords {
    /// Appends a brick that is not finished, with the sums of its voxels by their index in the brick.
    pub fn push_sums(&mut self, at: IVec3, occupancy: &[u64; 8], sums: &[VoxelSums]) {
        let (bytes, bricks) = &mut self.sums;
        bytes.push((0..8).filter(|&block| occupancy[block] != 0).fold(0, |blocks, block| blocks | 1 << block));
        for &mask in occupancy.iter().filter(|&&mask| mask != 0) {
            bytes.extend(mask.to_le_bytes());
        }
        for (block, &mask) in occupancy.iter().enumerate() {
            for bit in bits(mask) {
                sums[block << 6 | bit as usize].iter().for_each(|sum| bytes.extend(sum.to_le_bytes()));
            }
        }
        bricks.push((at, bytes.len() as u32));
    }
}

/// Adds the sums in a record to those of a brick. `None` if the bytes are not a valid record.
pub fn add_sums(record: &[u8], occupancy: &mut [u64; 8], sums: &mut [VoxelSums]) -> Option<()> {
    let (&blocks, rest) = record.split_first()?;
    let (masks, rest) = rest.split_at_checked(8 * blocks.count_ones() as usize)?;
    let (masks, (values, after)) = (masks.as_chunks::<8>().0, rest.as_chunks::<8>());
    let mut values = values.as_chunks::<4>().0.iter();
    if rest.len() % size_of::<VoxelSums>() != 0 || !after.is_empty() {
        return None;
    }
    for (block, mask) in bits(u64::from(blocks)).zip(masks) {
        let mask = u64::from_le_bytes(*mask);
        occupancy[block as usize] |= mask;
        for bit in bits(mask) {
            let voxel = &mut sums[(block as usize) << 6 | bit as usize];
            let added = values.next()?;
            for (sum, bytes) in voxel.iter_mut().zip(added) {
                *sum = sum.checked_add(u64::from_le_bytes(*bytes))?;
            }
        }
    }
    values.next().is_none().then_some(())
}

/// The appearances in a record and how many voxels have each; `None` if the bytes are not a valid record.
pub fn appearances_of(record: &[u8]) -> Option<(Vec<AppearanceKey>, u32)> {
    let (&[flags, blocks], rest) = record.split_first_chunk::<2>()?;
    let (masks, keys) = rest.split_at_checked(8 * blocks.count_ones() as usize)?;
    let voxels: u32 = masks.iter().map(|mask| mask.count_ones()).sum();
    let size = if flags & EMITS != 0 { 8 } else { 4 };
    let (count, times) = if flags & UNIFORM != 0 { (1, voxels) } else { (voxels as usize, 1) };
    let key =
        |bytes: &[u8]| bytes.iter().rev().fold(0, |key: AppearanceKey, &byte| key << 8 | AppearanceKey::from(byte));
    let keys: Vec<AppearanceKey> = keys.chunks(size).map(key).collect();
    let is_known = keys.iter().all(|key| ((key >> 24 & 0xff) as usize) < MAX_BSDF_CLASSES);
    let is_whole = rest.len() == masks.len() + count * size && voxels > 0;
    (is_known && is_whole).then_some((keys, times))
}

/// Brick coordinates in 63 bits, z highest.
pub fn packed_coordinates(at: IVec3) -> u64 {
    let [x, y, z] = at.to_array().map(|value| (value + BIAS) as u64 & 0x1f_ffff);
    x | y << 21 | z << 42
}

/// The inverse of [`packed_coordinates`].
pub fn unpacked_coordinates(at: u64) -> IVec3 {
    IVec3::from_array([0, 21, 42].map(|shift| (at >> shift & 0x1f_ffff) as i32 - BIAS))
}

/// Decodes the brick at `at` from a valid record; `material` chooses by appearance and voxel.
pub fn decoded_brick(bytes: &[u8], at: IVec3, material: &impl Fn(AppearanceKey, IVec3) -> u16) -> Brick {
    let (flags, blocks) = (bytes[0], bytes[1]);
    let mut occupancy = [0; 8];
    let mut rest = &bytes[2..];
    for (block, mask) in occupancy.iter_mut().enumerate() {
        if blocks >> block & 1 != 0 {
            let (word, after) = rest.split_at(8);
            *mask = word.iter().rev().fold(0, |mask, &byte| mask << 8 | u64::from(byte));
            rest = after;
        }
    }
    let size = if flags & EMITS != 0 { 8 } else { 4 };
    let key = |index: usize| {
        let start = if flags & UNIFORM != 0 { 0 } else { index * size };
        rest[start..start + size].iter().rev().fold(0, |key, &byte| key << 8 | u64::from(byte))
    };
    let voxels = (0..8).flat_map(|block| bits(occupancy[block]).map(move |bit| (block, bit)));
    let materials =
        voxels.enumerate().map(|(rank, (block, bit))| material(key(rank), at * BRICK_SIZE + voxel_of(block, bit)));
    let materials = materials.collect();
    Brick::new(occupancy, materials)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_one_brick_add_up_and_invalid_ones_are_refused() {
        let (mut a, mut b) = (TileRecords::default(), TileRecords::default());
        let mut sums = vec![[0; 4]; 512];
        (sums[0], sums[63], sums[511]) = ([1, 2, 3, 1], [4, 5, 6, 2], [1 << 40, 0, 7, 9]);
        a.push_sums(IVec3::ONE, &[1 | 1 << 63, 0, 0, 0, 0, 0, 0, 1 << 63], &sums);
        b.push_sums(IVec3::ONE, &[1, 0, 0, 0, 0, 0, 0, 0], &sums);
        let (mut occupancy, mut found) = ([0; 8], vec![[0; 4]; 512]);
        for records in [&a, &b] {
            add_sums(&records.sums.0, &mut occupancy, &mut found).unwrap();
        }
        sums[0] = [2, 4, 6, 2];
        assert_eq!((occupancy, &found), ([1 | 1 << 63, 0, 0, 0, 0, 0, 0, 1 << 63], &sums));
        assert_eq!((a.bricks.len(), a.voxels, a.sums.1[0].1 as usize), (0, 0, a.sums.0.len()));
        for end in 0..a.sums.0.len() {
            assert!(add_sums(&a.sums.0[..end], &mut occupancy, &mut found).is_none(), "{end}");
        }
        found[0][2] = u64::MAX;
        assert!(add_sums(&a.sums.0, &mut occupancy, &mut found).is_none(), "beyond 64 bits");
    }

    #[test]
    fn an_invalid_record_is_refused() {
        let mut records = TileRecords::default();
        records.push(IVec3::ZERO, &[0b101, 0, 0, 0, 0, 0, 0, 1 << 63], &[7, 8, 9]);
        let end = records.bytes.len();
        records.push(IVec3::X, &[u64::MAX, 0, 0, 0, 0, 0, 0, 0], &[5]);
        let good = records.bytes;
        assert_eq!(appearances_of(&good[..end]).unwrap(), (vec![7, 8, 9], 1));
        assert_eq!(appearances_of(&good[end..]).unwrap(), (vec![5], 64));
        for end in [0, 1, 2, 9, end - 1, end + 1] {
            assert!(appearances_of(&good[..end]).is_none(), "{end}");
        }
        let mut class = good[..end].to_vec();
        class[end - 1] = MAX_BSDF_CLASSES as u8;
        assert!(appearances_of(&class).is_none());
    }
}
