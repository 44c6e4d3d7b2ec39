//! What a scene holds and what it costs: counts, and bytes by kind, everything that tracers read counted in full.

use super::{Geometry, PackedGrid, PackedScene, lookup::HEADER_INDEX_BITS, lookup::HEADER_PALETTE};
use glam::{IVec3, Vec3};
use voxtrace_scene::scene::Scene;

/// Counts and bytes of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Statistics {
    /// Voxels along x, y and z of the box around everything visible; 0 where there is nothing.
    pub size: [u64; 3],
    /// Voxels stored: each grid once.
    pub voxels: u64,
    /// Voxels placed: each instance's.
    pub voxels_placed: u64,
    /// Grids.
    pub models: u64,
    /// Placed grids.
    pub instances: u64,
    /// Of these, those that became one grid when the scene was packed; 0 where none did.
    pub merged_instances: u64,
    /// Materials.
    pub materials: u64,
    /// Voxels stored whose material glows.
    pub emissive_voxels: u64,
    /// Bytes of the packed scene by kind, in a fixed order.
    pub bytes: [(&'static str, u64); 8],
    /// Bytes of a packed voxel: geometry, materials of the voxels, palettes and instances; all of `bytes` but the
    /// lights.
    pub bytes_per_voxel: f64,
}

/// The kind of bytes that hold no geometry and no materials.
const LIGHTS: &str = "lights";

impl Statistics {
    /// All bytes.
    pub fn total_bytes(&self) -> u64 {
        self.bytes.iter().map(|(_, bytes)| bytes).sum()
    }

    /// The same, with the counts of a whole scene: what is hidden, and the models that only an animation shows, are in
    /// it but not in the packed scene.
    pub fn with_counts_of(self, scene: &Scene) -> Self {
        let counts: Vec<u64> = scene.grids.iter().map(|grid| grid.count()).collect();
        let glows: Vec<bool> = scene.materials.iter().map(|material| material.is_emissive()).collect();
        let glowing = |materials: &[u16]| {
            materials.iter().filter(|&&material| glows.get(usize::from(material)) == Some(&true)).count() as u64
        };
        let any = glows.contains(&true);
        let bricks = scene.grids.iter().filter(|_| any).flat_map(|grid| grid.sorted_bricks());
        Self {
            voxels: counts.iter().sum(),
            voxels_placed: scene.instances.iter().filter_map(|instance| counts.get(instance.grid)).sum(),
            models: scene.grids.len() as u64,
            instances: scene.instances.len() as u64,
            emissive_voxels: bricks.map(|(_, brick)| glowing(brick.materials())).sum(),
            ..self
        }
    }
}

impl PackedScene {
    /// Counts and bytes of what is packed: the visible instances and their grids.
    pub fn statistics(&self) -> Statistics {
        let (geometry, placement) = (&*self.geometry, &self.placement);
        let parts = geometry.parts.as_deref();
        let voxels = self.voxel_count();
        let normals = geometry.normal_bytes();
        let bytes = [
            ("tree", geometry.cells.size_bytes()),
            ("bricks", geometry.bricks.size_bytes()),
            ("brick_materials", geometry.brick_materials.size_bytes() - normals),
            ("normals", normals),
            ("materials", geometry.materials.size_bytes()),
            ("grids", geometry.grids.size_bytes()),
            (
                "instances",
                placement.instances.size_bytes()
                    + placement.instance_nodes.size_bytes()
                    + parts.map_or(0, |parts| parts.size_bytes()),
            ),
            (
                LIGHTS,
                geometry.emitters.size_bytes() + geometry.light_nodes.size_bytes() + placement.light_nodes.size_bytes(),
            ),
        ];
        let of_voxels: u64 = bytes.iter().filter(|(kind, _)| *kind != LIGHTS).map(|(_, bytes)| bytes).sum();
        Statistics {
            // A turned grid's corners may miss whole numbers by rounding.
            size: self.bounds().map_or([0; 3], |(min, max)| (max - min - 1e-3).ceil().to_array().map(|v| v as u64)),
            voxels,
            voxels_placed: (placement
                .instances
                .iter()
                .map(|instance| self.grids()[instance.grid as usize].voxel_count()))
            .sum::<u64>()
                + parts.map_or(0, |parts| parts.covered.len() as u64),
            models: (geometry.grids.len() + parts.map_or(0, |parts| parts.records.len() - 1)) as u64,
            instances: self.instance_count() as u64,
            merged_instances: parts.map_or(0, |parts| parts.records.len() as u64),
            materials: geometry.materials.len() as u64,
            emissive_voxels: geometry.count_emissive(),
            bytes,
            bytes_per_voxel: of_voxels as f64 / voxels.max(1) as f64,
        }
    }

    /// Voxels that are stored: those of each grid once, also where others cover them.
    pub fn voxel_count(&self) -> u64 {
        let covered = self.geometry.parts.as_deref().map_or(0, |parts| parts.covered.len() as u64);
        self.grids().iter().map(PackedGrid::voxel_count).sum::<u64>() + covered
    }

    /// The box around everything visible, world space; `None` where there is nothing.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let corners = self.instances().iter().flat_map(|instance| {
            let grid = &self.grids()[instance.grid as usize];
            (0..8).map(move |corner| {
                let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                instance.world_from_grid.point((grid.min + (grid.max - grid.min) * pick).as_vec3())
            })
        });
        corners.map(|point| (point, point)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }
}

impl Geometry {
    /// Voxels stored whose material glows. Reads the brick records one after the other, where there is nothing else between them.
    fn count_emissive(&self) -> u64 {
        let glows: Vec<bool> = self.materials.iter().map(|material| material.emission.max_element() > 0.0).collect();
        if !glows.contains(&true) {
            return 0;
        }
        let count = |record: usize, entry_bits: u32| u64::from(self.count_glowing(record, entry_bits, &glows));
        let entry_bits = self.grids.first().map_or(8, |grid| grid.material_bits);
        // What was added behind 256 materials has longer entries than the rest.
        if self.is_edited || self.grids.iter().any(|grid| grid.material_bits != entry_bits) {
            let of_grid = |grid: &PackedGrid| {
                let bricks = self.bricks_of(grid).into_iter();
                let records = bricks.filter_map(|at| self.find_brick(grid, grid.origin + at * 8));
                records.map(|record| count(record, grid.material_bits)).sum::<u64>()
            };
            return self.grids.iter().map(of_grid).sum();
        }
        let (mut record, mut total) = (0, 0);
        while record + 1 < self.bricks.len() {
            total += count(record, entry_bits);
            record += 2 + 2 * (self.bricks[record] & 0xff).count_ones() as usize;
        }
        total
    }

    /// Voxels of a brick whose material glows.
    fn count_glowing(&self, record: usize, entry_bits: u32, glows: &[bool]) -> u32 {
        let header = self.bricks[record];
        let voxels = self.voxels_of(record);
        let (index_bits, palette) = (header >> HEADER_INDEX_BITS & 0xff, header >> HEADER_PALETTE);
        let start = u64::from(self.bricks[record + 1]) * 32;
        let glows_at =
            |position: u64, bits: u32| glows.get(self.read_bits(position, bits) as usize).copied().unwrap_or(false);
        let entries: Vec<bool> =
            (0..palette).map(|entry| glows_at(start + u64::from(entry * entry_bits), entry_bits)).collect();
        if palette > 0 && !entries.contains(&true) {
            return 0;
        }
        let glows_of_rank = |rank: &u32| {
            let position = start + u64::from(palette * entry_bits + rank * index_bits);
            match palette {
                0 => glows_at(position, index_bits),
                _ => entries.get(self.read_bits(position, index_bits) as usize) == Some(&true),
            }
        };
        (0..voxels).filter(glows_of_rank).count() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::Material;
    use voxtrace_scene::Transform;
    use voxtrace_scene::VoxelGrid;

    /// Two grids, one of them placed twice and turned, another hidden.
    fn example() -> Scene {
        let mut materials = vec![Material::default(); 40];
        materials[7] = Material::emissive(Vec3::ONE);
        materials[39] = Material::emissive(Vec3::X);
        let mut scene = Scene { materials, ..Scene::new("example") };
        let mut grid = VoxelGrid::new();
        for x in 0..20 {
            for y in 0..10 {
                // The materials 0 to 39 in turn: 7 and 39 glow.
                grid.set(IVec3::new(x, y, 0), ((x * 10 + y) % 40) as u16);
            }
        }
        let first = scene.add_instance(grid, Transform::IDENTITY);
        let mut turned = scene.instances[first].clone();
        turned.world_from_grid.linear = glam::Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z);
        turned.world_from_grid.translation = Vec3::new(0.0, 0.0, 4.0);
        scene.instances.push(turned);
        let mut lamp = VoxelGrid::new();
        lamp.set(IVec3::ZERO, 7);
        let lamp = scene.add_instance(lamp, Transform::from_translation(Vec3::splat(100.0)));
        scene.instances[lamp].hidden = true;
        scene
    }

    #[test]
    fn a_packed_scene_counts_what_is_visible() {
        let packed = PackedScene::pack(&example()).unwrap();
        let statistics = packed.statistics();
        assert_eq!((statistics.models, statistics.instances, statistics.materials), (1, 2, 40));
        assert_eq!((statistics.voxels, statistics.voxels_placed, statistics.emissive_voxels), (200, 400, 10));
        assert_eq!(statistics.size, [30, 20, 5]);
    }

    #[test]
    fn a_scene_counts_what_is_hidden_too() {
        let scene = example();
        let statistics = PackedScene::pack(&scene).unwrap().statistics().with_counts_of(&scene);
        assert_eq!((statistics.models, statistics.instances), (2, 3));
        assert_eq!((statistics.voxels, statistics.voxels_placed, statistics.emissive_voxels), (201, 401, 11));
    }

    #[test]
    fn every_byte_but_those_of_lights_counts_for_the_voxels() {
        let packed = PackedScene::pack(&example()).unwrap();
        let statistics = packed.statistics();
        let lights = statistics.bytes.iter().find(|(kind, _)| *kind == LIGHTS).unwrap().1;
        let expected = (statistics.total_bytes() - lights) as f64 / 200.0;
        assert_eq!(statistics.bytes_per_voxel, expected);
        assert!(
            statistics.bytes.iter().all(|&(kind, bytes)| (bytes > 0) == (kind != "normals") || kind == LIGHTS),
            "{:?}",
            statistics.bytes
        );
    }

    #[test]
    fn a_ground_behind_256_materials_does_not_glow() {
        let mut scene = example();
        scene.materials.resize(256, Material::default());
        scene.materials[0] = Material::emissive(Vec3::ONE);
        let packed = PackedScene::pack(&scene).unwrap();
        let ground = crate::surroundings::Ground { height: None, color: Vec3::ONE };
        let on_ground = packed.with_surroundings(Some(&ground), None).unwrap();
        assert!(on_ground.grids()[0].material_bits < on_ground.grids()[1].material_bits);
        assert_eq!((packed.statistics().emissive_voxels, on_ground.statistics().emissive_voxels), (15, 15));
    }

    #[test]
    fn the_count_of_emissive_voxels_agrees_with_looking_at_every_voxel() {
        let mut scene = example();
        for count in [1, 2, 3, 30, 300] {
            // Palettes of every size, and bricks without one.
            let mut grid = VoxelGrid::new();
            let mut seed = 1_u32;
            for i in 0..4096 {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                if seed >> 31 == 1 {
                    grid.set(IVec3::new(i % 16, i / 16 % 16, i / 256), (seed >> 8) as u16 % count);
                }
            }
            scene.materials = (0..count)
                .map(|i| if i % 3 == 1 { Material::emissive(Vec3::ONE) } else { Material::default() })
                .collect();
            let expected = grid.voxels().filter(|(_, material)| material % 3 == 1).count() as u64;
            scene.instances.clear();
            scene.grids.clear();
            scene.add_instance(grid, Transform::IDENTITY);
            let statistics = PackedScene::pack(&scene).unwrap().statistics();
            assert_eq!(statistics.emissive_voxels, expected, "{count} materials");
        }
    }
}
