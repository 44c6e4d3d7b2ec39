//! What a merged grid was made of: the instances of the scene, and whose each of its voxels is. Tracers know nothing of it; hits that
//! people see are of these instances and of the voxels in their own grids.

mod build;
mod hits;
mod split;
mod validate;

use super::lookup::bits_at;
use super::merge::Lattice;
use super::{Geometry, PackedGrid, PackedScene, Placement, Section};
use bytemuck::{Pod, Zeroable};
use glam::IVec3;
pub(super) use split::kept_instances;
use std::sync::Arc;
use voxtrace_scene::Invalid;

/// The parts of a merged grid. One grid of a geometry may be merged.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    /// The merged grid.
    pub(super) grid: u32,
    /// The instances that it was made of, in their order.
    pub(super) records: Section<PartRecord>,
    /// Whose the voxels of its bricks are, ordered by the place of the bricks: each run goes to the next one.
    pub(super) runs: Section<OwnerRun>,
    /// For each brick of several parts: how many, their indices, then one packed number of one of them for each voxel in rank order.
    pub(super) shared: Section<u32>,
    /// Voxels where one of an earlier part is.
    pub(super) covered: Section<CoveredVoxel>,
    /// How the parts stand in the merged grid.
    lattices: Arc<[Lattice]>,
    /// What [`Geometry::scene_grids`] would be with instances kept.
    pub(super) scene_grids: Arc<[u32]>,
}

/// An instance that was merged, as native files have it, the section `PART`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct PartRecord {
    /// Its index with instances kept.
    pub instance: u32,
    /// The index of its grid with instances kept.
    pub grid: u32,
    /// Index in [`voxtrace_scene::Scene::instances`].
    pub scene_instance: u32,
    /// How it is turned and mirrored, as [`Lattice::to_record`] says it.
    pub axes: u32,
    /// How far it is moved.
    pub translation: IVec3,
}

/// Bricks, one after the other in memory, whose voxels have one owner, the section `POWN`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct OwnerRun {
    /// Half the position of the first brick's record, words.
    pub first: u32,
    /// Index of the part, or [`SHARED`] and the position of what is said about the one brick in [`Parts::shared`].
    pub owner: u32,
}

/// A voxel of a part that is not in the merged grid, the section `PCOV`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct CoveredVoxel {
    /// Index of the part.
    pub part: u32,
    /// In the part's own grid.
    pub voxel: IVec3,
    /// Index of the material.
    pub material: u32,
}

/// Set in the owner of a brick of several parts.
pub(super) const SHARED: u32 = 1 << 31;

/// A brick of several parts.
struct SharedBrick<'a> {
    parts: &'a [u32],
    index_bits: u32,
    indices: &'a [u32],
}

impl Parts {
    /// Parts of the records of a file, or of packing.
    ///
    /// # Errors
    /// Where a part does not stand on the lattice.
    pub(super) fn new(
        grid: u32,
        records: Section<PartRecord>,
        (runs, shared): (Section<OwnerRun>, Section<u32>),
        covered: Section<CoveredVoxel>,
        scene_grids: Arc<[u32]>,
    ) -> Result<Self, Invalid> {
        let lattice = |(index, record): (usize, &PartRecord)| {
            Lattice::of_record(record.axes, record.translation)
                .ok_or_else(|| format!("part {index} of the merged grid does not stand on the lattice").into())
        };
        let lattices = records.iter().enumerate().map(lattice).collect::<Result<Vec<_>, Invalid>>()?;
        Ok(Self { grid, records, runs, shared, covered, lattices: lattices.into(), scene_grids })
    }

    /// Parts of the records of a file, whose instances stand as in `placement`; [`Geometry::validate_parts`] has still to check them.
    ///
    /// # Errors
    /// As [`Self::new`], or where there are none.
    pub(super) fn of_file(
        records: Section<PartRecord>,
        owners: (Section<OwnerRun>, Section<u32>),
        covered: Section<CoveredVoxel>,
        placement: &Placement,
    ) -> Result<Self, Invalid> {
        let merged = records.first().and_then(|first| placement.instances.get(first.instance as usize));
        let merged = merged.ok_or_else(|| Invalid::from("the merged grid is not that of its instance"))?;
        Self::new(merged.grid, records, owners, covered, Arc::default())
    }

    /// Its sections in a native file: tag, bytes of a record, and bytes.
    pub(super) fn sections(&self) -> [([u8; 4], u32, &[u8]); 4] {
        fn section<'a, T: Pod>(tag: &[u8; 4], records: &'a [T]) -> ([u8; 4], u32, &'a [u8]) {
            (*tag, size_of::<T>() as u32, bytemuck::cast_slice(records))
        }
        [
            section(b"PART", &self.records),
            section(b"POWN", &self.runs),
            section(b"PSHR", &self.shared),
            section(b"PCOV", &self.covered),
        ]
    }

    /// From the voxels of a part to those of the merged grid.
    fn lattice(&self, part: usize) -> &Lattice {
        &self.lattices[part]
    }

    /// Index of the instance that shows the merged grid: as many come before it as before its first part.
    pub(super) fn instance(&self) -> u32 {
        self.records[0].instance
    }

    pub(super) fn size_bytes(&self) -> u64 {
        self.records.size_bytes() + self.runs.size_bytes() + self.shared.size_bytes() + self.covered.size_bytes()
    }

    /// The part that an instance is, by its index with instances kept.
    fn of_instance(&self, kept: u32) -> Result<usize, usize> {
        self.records.binary_search_by_key(&kept, |record| record.instance)
    }

    /// The index, with instances kept, of the instance `index` of the packed scene, which is not the merged one.
    pub(super) fn kept_index(&self, index: u32) -> u32 {
        let among_others = index - u32::from(index > self.instance());
        // How many parts come before it.
        let mut range = (0, self.records.len());
        while range.0 < range.1 {
            let middle = (range.0 + range.1) / 2;
            if self.records[middle].instance - middle as u32 <= among_others {
                range.0 = middle + 1;
            } else {
                range.1 = middle;
            }
        }
        among_others + range.0 as u32
    }

    /// The index in the packed scene of an instance that was not merged: the inverse of [`Self::kept_index`].
    fn packed_index(&self, kept: u32, parts_before: usize) -> u32 {
        let among_others = kept - parts_before as u32;
        among_others + u32::from(among_others >= self.instance())
    }

    /// Whose the voxel with `rank` of the brick whose record is at `record` is.
    fn owner(&self, record: usize, rank: u32) -> Option<usize> {
        let run = self.runs.partition_point(|run| run.first as usize <= record / 2).checked_sub(1)?;
        let owner = self.runs[run].owner;
        if owner & SHARED == 0 {
            return Some(owner as usize);
        }
        let brick = self.shared_brick((owner & !SHARED) as usize)?;
        let index = bits_at(brick.indices, u64::from(rank * brick.index_bits), brick.index_bits);
        brick.parts.get(index as usize).map(|&part| part as usize)
    }

    fn shared_brick(&self, at: usize) -> Option<SharedBrick<'_>> {
        let count = *self.shared.get(at)? as usize;
        let parts = self.shared.get(at + 1..at.checked_add(1)?.checked_add(count)?)?;
        let index_bits = u32::BITS - (count as u32).checked_sub(1)?.leading_zeros();
        Some(SharedBrick { parts, index_bits, indices: &self.shared[at + 1 + count..] })
    }
}

impl Geometry {
    /// The part of the merged grid whose voxel is at `voxel`, and the parts; `None` where there is none.
    fn part_at(&self, voxel: IVec3) -> Option<(&Parts, usize)> {
        let parts = self.parts.as_deref()?;
        let (record, rank) = self.rank_at(self.merged_grid(parts), voxel)?;
        Some((parts, parts.owner(record, rank)?))
    }

    fn merged_grid(&self, parts: &Parts) -> &PackedGrid {
        &self.grids[parts.grid as usize]
    }
}

impl PackedScene {
    /// Whether instances of the scene became one grid when it was packed.
    pub fn is_merged(&self) -> bool {
        self.geometry.parts.is_some()
    }

    /// Visible instances, those that were merged too: what the indices of hits count.
    pub fn instance_count(&self) -> usize {
        let parts = self.geometry.parts.as_ref().map_or(0, |parts| parts.records.len() - 1);
        self.placement.instances.len() + parts
    }
}
