//! From the packed scene back to the editable one, to edit it or to write it in another format.

use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
use super::{CELL_OCCUPIED, Geometry, PackedGrid, PackedScene};
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::Brick;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::{Instance, Scene};

impl PackedScene {
    /// The scene with everything that packing keeps, each instance with a grid of its own where they were merged: names of instances, layers and
    /// keyframes are gone.
    pub fn to_scene(&self) -> Scene {
        let materials = (self.geometry.materials.iter())
            .map(|packed| Material {
                base_color: packed.base_color,
                emission: packed.emission,
                roughness: packed.roughness,
                metallic: packed.metallic,
                transmission: packed.transmission,
                ior: packed.ior,
                specular: packed.specular,
                anisotropy: packed.anisotropy,
                absorption: packed.absorption,
                scattering: packed.scattering,
            })
            .collect();
        Scene {
            name: self.name.clone(),
            grids: self.kept_grids(),
            instances: (self.kept_instances().iter())
                .map(|instance| Instance::new(instance.grid as usize, instance.world_from_grid))
                .collect(),
            materials,
            layers: Vec::new(),
            groups: Vec::new(),
            sky: self.sky.clone(),
            light_intensity: self.light_intensity,
            cameras: self.cameras.clone(),
            voxel_size: self.voxel_size,
            unit: self.unit,
            georeference: self.georeference.clone(),
            attachments: Vec::new(),
            clips: Vec::new(),
        }
    }
}

impl Geometry {
    pub(crate) fn unpack_grid(&self, grid: &PackedGrid) -> VoxelGrid {
        let bricks = self.bricks_of(grid);
        let unpack = |&at: &IVec3| {
            let corner = grid.origin + at * 8;
            (corner >> 3, self.unpack_brick(grid, corner))
        };
        VoxelGrid::from_bricks(bricks.par_iter().map(unpack).collect::<Vec<_>>())
    }

    /// Coordinates of the bricks of a grid, in bricks from its origin.
    pub(crate) fn bricks_of(&self, grid: &PackedGrid) -> Vec<IVec3> {
        let mut bricks = Vec::new();
        let size = grid.top_size;
        for index in 0..size.element_product() {
            let at = IVec3::new(index % size.x, index / size.x % size.y, index / (size.x * size.y));
            let cell = self.cells[grid.top_offset as usize + index as usize];
            self.collect_bricks(cell, at, grid.top_shift, &mut bricks);
        }
        bricks
    }

    /// Coordinates of the bricks below a cell at `at`, in bricks from the grid's origin.
    fn collect_bricks(&self, cell: u32, at: IVec3, shift: u32, bricks: &mut Vec<IVec3>) {
        if cell & CELL_OCCUPIED == 0 {
            return;
        }
        if shift == 3 {
            bricks.push(at);
            return;
        }
        let node = (cell & !CELL_OCCUPIED) as usize * 64;
        for index in 0..64 {
            let local = IVec3::new(index & 3, index >> 2 & 3, index >> 4);
            self.collect_bricks(self.cells[node + index as usize], at * 4 + local, shift - 2, bricks);
        }
    }

    fn unpack_brick(&self, grid: &PackedGrid, corner: IVec3) -> Brick {
        self.find_brick(grid, corner).map_or_else(Brick::default, |record| self.decode_brick(grid, record))
    }

    /// The brick of a record.
    pub(crate) fn decode_brick(&self, grid: &PackedGrid, record: usize) -> Brick {
        let occupancy = self.masks(record);
        let header = self.bricks[record];
        let (index_bits, palette) = (header >> HEADER_INDEX_BITS & 0xff, header >> HEADER_PALETTE);
        let entry_bits = grid.material_bits;
        let count: u32 = occupancy.iter().map(|mask| mask.count_ones()).sum();
        let words = &self.brick_materials[self.bricks[record + 1] as usize..];
        let first = palette * entry_bits;
        let material = |rank: u32| {
            let index = bits_at(words, u64::from(first + rank * index_bits), index_bits);
            let entry = if palette == 0 { index } else { bits_at(words, u64::from(index * entry_bits), entry_bits) };
            entry as u16
        };
        Brick::new(occupancy, (0..count).map(material).collect())
    }
}
