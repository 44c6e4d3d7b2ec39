//! From the packed scene back to the editable one, to edit it or to write it in another format.

use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
use super::{CELL_OCCUPIED, Geometry, PackedGrid, PackedScene};
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::{Brick, bits};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::{Instance, Scene};

impl PackedScene {
    /// The scene with everything that packing keeps, each instance with a grid of its own where they were merged: names of instances, layers and
    /// keyframes are gone.
    ///
    /// # Panics
    /// Never: it is wanted to its end.
    pub fn to_scene(&self) -> Scene {
        self.to_scene_while(&|| true).expect("nobody stops it")
    }

    /// As [`Self::to_scene`], as long as it is `wanted`, which several threads ask, and which says no for good; `None` once it is not.
    pub fn to_scene_while(&self, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Scene> {
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
        Some(Scene {
            name: self.name.clone(),
            grids: self.kept_grids(wanted)?,
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
        })
    }
}

impl Geometry {
    pub(crate) fn unpack_grid(&self, grid: &PackedGrid) -> VoxelGrid {
        self.unpack_grid_while(grid, &|| true).expect("nobody stops it")
    }

    /// As [`Self::unpack_grid`], as long as it is wanted.
    pub(super) fn unpack_grid_while(&self, grid: &PackedGrid, wanted: &(dyn Fn() -> bool + Sync)) -> Option<VoxelGrid> {
        let bricks = self.bricks_of(grid);
        let unpack = |&at: &IVec3| {
            let corner = grid.origin + at * 8;
            let brick = if wanted() { self.unpack_brick(grid, corner) } else { Brick::default() };
            (corner >> 3, brick)
        };
        let bricks: Vec<_> = bricks.par_iter().map(unpack).collect();
        wanted().then(|| VoxelGrid::from_bricks(bricks))
    }

    /// Coordinates of the bricks of a grid, in bricks from its origin.
    pub(crate) fn bricks_of(&self, grid: &PackedGrid) -> Vec<IVec3> {
        let mut bricks = Vec::new();
        self.for_each_brick(grid, &mut |at| bricks.push(at));
        bricks
    }

    /// Goes through the coordinates of the bricks of a grid, in bricks from its origin, node by node.
    pub(super) fn for_each_brick(&self, grid: &PackedGrid, each: &mut dyn FnMut(IVec3)) {
        let size = grid.top_size;
        for index in 0..size.element_product() {
            let at = IVec3::new(index % size.x, index / size.x % size.y, index / (size.x * size.y));
            let cell = self.cells[grid.top_offset as usize + index as usize];
            self.for_each_brick_below(cell, at, grid.top_shift, each);
        }
    }

    /// Goes through the bricks below a cell at `at`.
    fn for_each_brick_below(&self, cell: u32, at: IVec3, shift: u32, each: &mut dyn FnMut(IVec3)) {
        if cell & CELL_OCCUPIED == 0 {
            return;
        }
        if shift == 3 {
            return each(at);
        }
        let node = (cell & !CELL_OCCUPIED) as usize * 64;
        for index in 0..64 {
            let local = IVec3::new(index & 3, index >> 2 & 3, index >> 4);
            self.for_each_brick_below(self.cells[node + index as usize], at * 4 + local, shift - 2, each);
        }
    }

    fn unpack_brick(&self, grid: &PackedGrid, corner: IVec3) -> Brick {
        self.find_brick(grid, corner).map_or_else(Brick::default, |record| self.decode_brick(grid, record))
    }

    /// Goes through those voxels of a brick that a mask has, a bit for each, block by block: their blocks, bits, ranks and materials.
    pub(super) fn for_each_voxel(
        &self,
        grid: &PackedGrid,
        record: usize,
        wanted: &[u64; 8],
        each: &mut dyn FnMut(usize, u32, u32, u32),
    ) {
        let header = self.bricks[record];
        let (index_bits, palette) = (header >> HEADER_INDEX_BITS & 0xff, header >> HEADER_PALETTE);
        let entry_bits = grid.material_bits;
        let words = &self.brick_materials[self.bricks[record + 1] as usize..];
        let first = palette * entry_bits;
        let mut before = 0;
        for (block, mask) in self.masks(record).into_iter().enumerate() {
            for bit in bits(mask & wanted[block]) {
                let rank = before + (mask & ((1 << bit) - 1)).count_ones();
                let index = bits_at(words, u64::from(first + rank * index_bits), index_bits);
                let entry =
                    if palette == 0 { index } else { bits_at(words, u64::from(index * entry_bits), entry_bits) };
                each(block, bit, rank, entry);
            }
            before += mask.count_ones();
        }
    }

    /// The brick of a record.
    pub(crate) fn decode_brick(&self, grid: &PackedGrid, record: usize) -> Brick {
        let occupancy = self.masks(record);
        let mut materials = Vec::with_capacity(occupancy.iter().map(|mask| mask.count_ones() as usize).sum());
        self.for_each_voxel(grid, record, &[u64::MAX; 8], &mut |_, _, _, material| materials.push(material as u16));
        Brick::new(occupancy, materials)
    }
}
