//! How full the voxels of a level of detail are: four bits for each voxel, in rank order, right before the materials of its brick and counted backwards from
//! there, as normals are. So what reads materials does not know of them.

use super::{Geometry, PackedGrid};
use glam::IVec3;
use voxtrace_scene::Invalid;

/// Bits of a voxel: its coverage less one, in sixteenths.
const COVERAGE_BITS: u32 = 4;
/// The coverage of a voxel that is full.
pub(super) const FULL: u32 = 16;

/// Words of a brick of so many voxels.
pub(super) fn coverage_words(voxels: u32) -> usize {
    (voxels * COVERAGE_BITS).div_ceil(32) as usize
}

/// The coverages of a brick, each from 1 to 16, as words that its materials have to follow.
pub(super) fn words_of(coverages: &[u8]) -> Vec<u32> {
    let mut words = vec![0; coverage_words(coverages.len() as u32)];
    let end = words.len();
    for (rank, &coverage) in coverages.iter().enumerate() {
        words[end - 1 - rank / 8] |= (u32::from(coverage) - 1) << (28 - 4 * (rank % 8));
    }
    words
}

/// Whether a file's section about coverage says that there is some.
pub(super) fn is_known_kind(section: &[u32]) -> Result<bool, Invalid> {
    if section == [COVERAGE_BITS] { Ok(true) } else { Err("the coverage of voxels is of another kind".into()) }
}

impl Geometry {
    /// The section of a file that says that voxels have coverage.
    pub(super) fn coverage_section(&self) -> Option<([u8; 4], u32, &'static [u8])> {
        const RECORD: &[u8] = &COVERAGE_BITS.to_le_bytes();
        self.has_coverage.then_some((*b"COVR", RECORD.len() as u32, RECORD))
    }

    /// The coverage, in sixteenths, of the voxel of a rank in the brick of a record.
    pub(super) fn coverage_of(&self, record: usize, rank: u32) -> u32 {
        if !self.has_coverage {
            return FULL;
        }
        let word = self.bricks[record + 1] as usize - 1 - (rank / 8) as usize;
        1 + (self.brick_materials[word] >> (28 - 4 * (rank % 8)) & 15)
    }

    /// How much of a voxel of a level of detail was full in the finest one, from 1/16 to 1; `None` where it is empty. Voxels of scenes that are no level are full.
    pub fn coverage_at(&self, grid: &PackedGrid, voxel: IVec3) -> Option<f32> {
        let (record, rank) = self.rank_at(grid, voxel)?;
        Some(self.coverage_of(record, rank) as f32 / FULL as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverages_stand_backwards_before_the_materials() {
        let coverages: Vec<u8> = (0..37).map(|i| 1 + i * 5 % 16).collect();
        let mut words = words_of(&coverages);
        assert_eq!(words.len(), 5);
        words.push(0xffff_ffff);
        let geometry = Geometry {
            bricks: vec![0, 5].into(),
            brick_materials: words.into(),
            has_coverage: true,
            ..Geometry::default()
        };
        let found: Vec<u8> = (0..37).map(|rank| geometry.coverage_of(0, rank) as u8).collect();
        assert_eq!(found, coverages);
        assert_eq!(Geometry { has_coverage: false, ..geometry }.coverage_of(0, 3), FULL);
        assert!(is_known_kind(&[4]).unwrap() && is_known_kind(&[5]).is_err());
    }
}
