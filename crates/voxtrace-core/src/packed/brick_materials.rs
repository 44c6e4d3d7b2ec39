//! Materials of voxels that follow one another, most of them in the same brick.

use super::lookup::HEADER_INDEX_BITS;
use super::{Geometry, PackedGrid};
use glam::IVec3;
use voxtrace_scene::grid::local_of;

/// What was found of the brick of the last voxel.
pub struct BrickMaterials<'a> {
    geometry: &'a Geometry,
    grid: &'a PackedGrid,
    /// Its place among the grid's bricks.
    brick: IVec3,
    /// Word position of its record.
    record: Option<usize>,
    /// The material of all its voxels, `None` where they have several.
    only: Option<u32>,
}

impl<'a> BrickMaterials<'a> {
    /// Of a grid; nothing is found yet.
    pub fn new(geometry: &'a Geometry, grid: &'a PackedGrid) -> Self {
        Self { geometry, grid, brick: IVec3::MIN, record: None, only: None }
    }

    /// Index of the material of a voxel, `None` where it is empty: as [`Geometry::material_at`].
    #[inline]
    pub fn at(&mut self, voxel: IVec3) -> Option<u32> {
        let relative = voxel - self.grid.origin;
        if relative >> 3 != self.brick {
            self.enter(voxel);
        }
        let record = self.record?;
        let local = local_of(relative);
        if self.only.is_some() {
            return self.geometry.block_of(record, local).and(self.only);
        }
        let rank = self.geometry.rank_in(record, local)?;
        Some(self.geometry.material_of_rank(self.grid, record, rank))
    }

    fn enter(&mut self, voxel: IVec3) {
        self.brick = (voxel - self.grid.origin) >> 3;
        self.record = self.geometry.find_brick(self.grid, voxel);
        // Without bits all have the first index.
        let is_uniform = |record: &usize| self.geometry.bricks[*record] >> HEADER_INDEX_BITS & 0xff == 0;
        self.only = self.record.filter(is_uniform).map(|record| self.geometry.material_of_rank(self.grid, record, 0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use voxtrace_scene::{Material, Scene, VoxelGrid};

    #[test]
    fn materials_on_a_way_are_those_of_single_lookups() {
        // A brick of one material, one of two, one with holes, and none.
        let mut grid = VoxelGrid::default();
        for place in 0..24 * 8 * 8 {
            let voxel = IVec3::new(place % 24, place / 24 % 8, place / 192);
            let is_there = voxel.x < 16 || voxel.element_sum() % 3 == 0;
            if is_there {
                grid.set(voxel, u16::from((8..16).contains(&voxel.x) && voxel.y > 3));
            }
        }
        let scene = Scene::from_grid("bricks", grid, vec![Material::default(); 2]);
        let packed = PackedScene::pack(&scene).unwrap();
        let (geometry, grid) = (packed.geometry(), &packed.grids()[0]);
        let mut materials = BrickMaterials::new(geometry, grid);
        let (mut found, mut uniform) = ([0; 3], 0);
        for place in 0..34 * 10 * 10 {
            // To and fro, so that bricks are left and entered again.
            let x = if place / 34 % 2 == 0 { place % 34 } else { 33 - place % 34 };
            let voxel = IVec3::new(x, place / 34 % 10, place / 340) - IVec3::new(1, 1, 1);
            let material = geometry.material_at(grid, voxel);
            assert_eq!(materials.at(voxel), material, "{voxel}");
            found[material.map_or(2, |material| material as usize)] += 1;
            uniform += u32::from(materials.only.is_some());
        }
        assert!(found.iter().all(|&count| count > 100), "{found:?}");
        assert!((500..2500).contains(&uniform), "{uniform}");
    }
}
