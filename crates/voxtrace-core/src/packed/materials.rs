//! Other materials for a packed scene: what packing the scene anew would give, without its voxels.

use super::lights::{append_lights, covers};
use super::lookup::HEADER_PALETTE;
use super::{Emitter, Geometry, PackedMaterial, morton_order};
use crate::math::luminance;
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::{BRICK_SIZE, voxel_of};
use voxtrace_scene::ray::FACES;

impl Geometry {
    /// The same grids with as many other materials. What is large is shared; emitters and the trees over them are made anew where what
    /// glows changes, and voxels are looked at only where something begins to glow.
    pub(super) fn with_materials(&self, materials: Vec<PackedMaterial>) -> Self {
        let luminances = |materials: &[PackedMaterial]| -> Vec<f32> {
            materials.iter().map(|material| luminance(material.surface_emission())).collect()
        };
        let (before, now) = (luminances(&self.materials), luminances(&materials));
        let changed = Self { materials: materials.into(), ..self.clone() };
        let covered = |materials: &[PackedMaterial]| -> Vec<bool> {
            materials.iter().map(|material| covers(material.transmission, material.metallic)).collect()
        };
        let are_covered_alike = covered(&self.materials) == covered(&changed.materials);
        if before == now && (are_covered_alike || now.iter().all(|&luminance| luminance <= 0.0)) {
            return changed;
        }
        let mut emitters: Vec<Emitter> = (self.emitters.iter())
            .filter(|emitter| are_covered_alike && now[emitter.material as usize] > 0.0)
            .map(|emitter| Emitter { luminance: now[emitter.material as usize], ..*emitter })
            .collect();
        let begins: Vec<bool> =
            before.iter().zip(&now).map(|(&before, &now)| (before <= 0.0 || !are_covered_alike) && now > 0.0).collect();
        if begins.contains(&true) {
            for grid in 0..self.grids.len() {
                emitters.extend(changed.emitters_of(grid, &begins, &now));
            }
            let order = |a: &Emitter, b: &Emitter| a.grid.cmp(&b.grid).then_with(|| morton_order(a.voxel, b.voxel));
            emitters.par_sort_unstable_by(order);
        }
        let (mut sorted, mut light_nodes) = (Vec::new(), Vec::new());
        for of_grid in emitters.chunk_by(|a, b| a.grid == b.grid) {
            append_lights(of_grid.to_vec(), &mut sorted, &mut light_nodes);
        }
        Self { emitters: sorted.into(), light_nodes: light_nodes.into(), ..changed }.finished()
    }

    /// For each material whether a voxel has it.
    pub fn used_materials(&self) -> Vec<bool> {
        let mut is_used = vec![false; self.materials.len()];
        for grid in self.grids.iter() {
            let used = (self.bricks_of(grid).into_par_iter())
                .fold(
                    || vec![false; self.materials.len()],
                    |mut used, at| {
                        self.materials_of_brick(grid.origin + at * BRICK_SIZE, grid)
                            .for_each(|material| used[material] = true);
                        used
                    },
                )
                .reduce(|| vec![false; self.materials.len()], |a, b| a.iter().zip(b).map(|(&a, b)| a || b).collect());
            is_used.iter_mut().zip(used).for_each(|(all, of_grid)| *all |= of_grid);
        }
        is_used
    }

    /// The voxels of a grid that begin to glow and that light can leave.
    fn emitters_of(&self, index: usize, begins: &[bool], luminances: &[f32]) -> Vec<Emitter> {
        let grid = &self.grids[index];
        let glows = |corner: &IVec3| self.materials_of_brick(*corner, grid).any(|material| begins[material]);
        let is_free = |voxel: IVec3| self.is_free(grid, voxel);
        let corners = self.bricks_of(grid).into_par_iter().map(|at| grid.origin + at * BRICK_SIZE).filter(glows);
        corners
            .flat_map_iter(|corner| {
                let voxels = (0..8).flat_map(|block| (0..64).map(move |bit| voxel_of(block, bit)));
                voxels.filter_map(move |local| {
                    let voxel = corner + local;
                    let material = self.material_at(grid, voxel).filter(|&material| begins[material as usize])?;
                    let faces =
                        FACES.iter().map(|&face| u32::from(is_free(voxel + face.normal())) << face as u32).sum();
                    let luminance = luminances[material as usize];
                    Some(Emitter { voxel, grid: index as u32, faces, material, luminance, leaf: 0 })
                })
            })
            .filter(|emitter| emitter.faces != 0)
            .collect()
    }

    /// The materials of the brick whose lowest voxel is `corner`, some of them twice.
    fn materials_of_brick(&self, corner: IVec3, grid: &super::PackedGrid) -> impl Iterator<Item = usize> {
        let record = self.find_brick(grid, corner);
        record.into_iter().flat_map(|record| self.materials_of_record(grid, record)).map(usize::from)
    }

    /// The materials of the brick with a record at `record`, some of them twice.
    pub(crate) fn materials_of_record(&self, grid: &super::PackedGrid, record: usize) -> impl Iterator<Item = u16> {
        let (palette, bits) = (self.bricks[record] >> HEADER_PALETTE, grid.material_bits);
        let start = u64::from(self.bricks[record + 1]) * 32;
        // Without a palette the indices are the materials.
        let count = if palette > 0 { palette } else { self.voxels_of(record) };
        (0..u64::from(count)).map(move |entry| self.read_bits(start + entry * u64::from(bits), bits) as u16)
    }
}
