//! From a merged grid back to the instances that it was made of.

use super::Parts;
use crate::packed::merge::Scatter;
use crate::packed::{Geometry, PackError, PackedInstance, PackedScene, Placement};
use glam::IVec3;
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, voxel_of};
use voxtrace_scene::grid::VoxelGrid;

impl Parts {
    /// A part as an instance, where the merged grid stands as `merged`.
    pub(super) fn instance_of(&self, part: usize, merged: &PackedInstance) -> PackedInstance {
        let world_from_part = merged.world_from_grid.after(&self.lattice(part).transform());
        PackedInstance::new(self.grid, world_from_part, self.records[part].scene_instance)
    }

    /// Takes numbers that count without parts to those that count with them, which `of_part` are.
    fn interleaved<T>(others: Vec<T>, of_part: Vec<(u32, T)>) -> Vec<T> {
        let (mut others, mut of_part) = (others.into_iter(), of_part.into_iter().peekable());
        let mut all = Vec::new();
        loop {
            let is_part = of_part.peek().is_some_and(|(number, _)| *number as usize == all.len());
            match if is_part { of_part.next().map(|(_, part)| part) } else { others.next() } {
                Some(next) => all.push(next),
                None => return all,
            }
        }
    }
}

impl PackedScene {
    /// The instances of the scene, those that were merged too, and the index of the grid of each among [`Self::kept_grids`].
    pub(in crate::packed) fn kept_instances(&self) -> Vec<PackedInstance> {
        kept_instances(&self.geometry, &self.placement)
    }

    /// The grids of the scene, those that were merged each for itself, as long as they are wanted.
    pub(in crate::packed) fn kept_grids(&self, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Vec<Arc<VoxelGrid>>> {
        let geometry = &*self.geometry;
        let unpack = |grid| geometry.unpack_grid_while(grid, wanted).map(Arc::new);
        let Some(parts) = geometry.parts.as_deref() else { return self.grids().par_iter().map(unpack).collect() };
        let others: Option<Vec<_>> = (geometry.grids.par_iter().enumerate())
            .filter(|(index, _)| *index != parts.grid as usize)
            .map(|(_, grid)| unpack(grid))
            .collect();
        let grids = geometry.grids_of_parts(parts, wanted)?;
        let mut of_parts: Vec<(u32, Arc<VoxelGrid>)> =
            (parts.records.iter().zip(grids)).map(|(record, grid)| (record.grid, Arc::new(grid))).collect();
        of_parts.sort_unstable_by_key(|(number, _)| *number);
        Some(Parts::interleaved(others?, of_parts))
    }

    /// The same scene with the instances that it was packed with, each a grid of its own again, so that they can be moved and hidden: as
    /// packing the scene with instances kept.
    ///
    /// # Panics
    /// Never: what was packed once is packed again.
    #[must_use]
    pub fn split(&self) -> Self {
        self.split_while(&|| true).expect("nobody stops it")
    }

    /// As [`Self::split`], as long as it is `wanted`, which several threads ask, and which says no for good; `None` once it is not.
    ///
    /// # Panics
    /// As [`Self::split`].
    #[must_use]
    pub fn split_while(&self, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Self> {
        let Some(parts) = self.geometry.parts.as_deref() else { return Some(self.clone()) };
        let packed = match Self::pack_while(&self.to_scene_while(wanted)?, wanted) {
            Err(PackError::Stopped) => return None,
            packed => packed.and_then(|packed| packed.with_normals(self.normals())),
        };
        let packed = packed.expect("what was packed can be packed apart");
        let mut geometry = Geometry::clone(&packed.geometry);
        if let Some(last) = parts.scene_grids.last() {
            // What was added to the scene since comes after all of its grids.
            let known = parts.scene_grids.len() as u32;
            let number = |&grid: &u32| {
                parts.scene_grids.get(grid as usize).copied().unwrap_or(last + 1 + grid.saturating_sub(known))
            };
            geometry.scene_grids = packed.geometry.scene_grids.iter().map(number).collect();
        }
        let scene_instances: Vec<u32> = self.kept_instances().iter().map(|kept| kept.scene_instance).collect();
        let mut instances = packed.placement.instances.to_vec();
        for instance in &mut instances {
            instance.scene_instance = scene_instances[instance.scene_instance as usize];
        }
        let placement = Placement::of_sound(&geometry, instances);
        Some(Self { geometry: Arc::new(geometry), placement, ..self.clone() })
    }
}

/// As [`PackedScene::kept_instances`].
pub(crate) fn kept_instances(geometry: &Geometry, placement: &Placement) -> Vec<PackedInstance> {
    let instances = &placement.instances;
    let Some(parts) = geometry.parts.as_deref() else { return instances.to_vec() };
    let mut numbers: Vec<u32> = parts.records.iter().map(|record| record.grid).collect();
    numbers.sort_unstable();
    // Numbers of the grids that were not merged.
    let count = geometry.grids.len() + parts.records.len() - 1;
    let of_others: Vec<u32> = (0..count as u32).filter(|number| numbers.binary_search(number).is_err()).collect();
    let others = (instances.iter().enumerate())
        .filter(|(index, _)| *index != parts.instance() as usize)
        .map(|(_, instance)| {
            let among_others = instance.grid - u32::from(instance.grid > parts.grid);
            PackedInstance { grid: of_others[among_others as usize], ..*instance }
        })
        .collect();
    let merged = &instances[parts.instance() as usize];
    let part = |(index, record): (usize, &super::PartRecord)| {
        (record.instance, PackedInstance { grid: record.grid, ..parts.instance_of(index, merged) })
    };
    Parts::interleaved(others, parts.records.iter().enumerate().map(part).collect())
}

impl Geometry {
    /// The grids of the parts, with the voxels that others cover, as long as they are wanted.
    fn grids_of_parts(&self, parts: &Parts, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Vec<VoxelGrid>> {
        let grid = self.merged_grid(parts);
        let mut bricks_of: Vec<Vec<IVec3>> = vec![Vec::new(); parts.records.len()];
        for at in self.bricks_of(grid) {
            let at = (grid.origin >> 3) + at;
            parts.parts_of_brick(self.find_brick(grid, at * BRICK_SIZE)).iter().for_each(|&part| {
                bricks_of[part as usize].push(at);
            });
        }
        let whole = |part: usize, bricks: &[IVec3]| {
            let mut scatter = Scatter::default();
            for &at in bricks.iter().take_while(|_| wanted()) {
                self.scatter_part(parts, part, at, &mut scatter);
            }
            for covered in parts.covered.iter().filter(|covered| covered.part as usize == part) {
                scatter.set(covered.voxel, covered.material as u16);
            }
            VoxelGrid::from_bricks(scatter.finish())
        };
        let grids = bricks_of.par_iter().enumerate().map(|(part, bricks)| whole(part, bricks)).collect();
        wanted().then_some(grids)
    }

    /// Adds the voxels of a part in the brick of the merged grid at `at`.
    fn scatter_part(&self, parts: &Parts, part: usize, at: IVec3, scatter: &mut Scatter) {
        let grid = self.merged_grid(parts);
        for place in 0..512 {
            let voxel = at * BRICK_SIZE + voxel_of(place / 64, (place % 64) as u32);
            let Some((record, rank)) = self.rank_at(grid, voxel) else { continue };
            if parts.owner(record, rank) == Some(part) {
                let material = self.material_at(grid, voxel).expect("the voxel is there");
                scatter.set(parts.lattice(part).voxel_before(voxel), material as u16);
            }
        }
    }
}

impl Parts {
    /// The parts that have a voxel in the brick whose record is at a position.
    fn parts_of_brick(&self, record: Option<usize>) -> Vec<u32> {
        let run = record.and_then(|record| {
            let run = self.runs.partition_point(|run| run.first as usize <= record / 2).checked_sub(1)?;
            Some(self.runs[run].owner)
        });
        match run {
            None => Vec::new(),
            Some(owner) if owner & super::SHARED == 0 => vec![owner],
            Some(owner) => {
                let brick = self.shared_brick((owner & !super::SHARED) as usize);
                let mut parts = brick.map_or_else(Vec::new, |brick| brick.parts.to_vec());
                parts.sort_unstable();
                parts.dedup();
                parts
            }
        }
    }
}
