//! Fingerprint of the work, by which an interrupted run is recognized: a 128-bit hash of everything that its result depends on.

use super::VoxelizeOptions;
use crate::mesh::Mesh;
use crate::points::PointCloud;
use std::fmt::Debug;
use xxhash_rust::xxh3::Xxh3;

/// To be raised with every change of how work is cut into steps, or of the bricks that steps make.
const VERSION: u32 = 4;

/// The fingerprint of a mesh in memory.
pub(super) fn of_mesh(mesh: &Mesh, options: &VoxelizeOptions) -> u128 {
    let mut hash = begin(options);
    add_frame(mesh, &mut hash);
    hash.update(bytemuck::cast_slice(&mesh.positions));
    hash.update(bytemuck::cast_slice(&mesh.triangles));
    hash.update(bytemuck::cast_slice(&mesh.uvs));
    hash.update(bytemuck::cast_slice(&mesh.colors));
    hash.update(bytemuck::cast_slice(&mesh.material_of));
    hash.digest128()
}

/// The fingerprint of a cloud in memory.
pub(super) fn of_points(cloud: &PointCloud, options: &VoxelizeOptions) -> u128 {
    let mut hash = begin(options);
    add_cloud(cloud, &mut hash);
    hash.update(bytemuck::cast_slice(&cloud.positions));
    hash.update(bytemuck::cast_slice(&cloud.colors));
    hash.update(bytemuck::cast_slice(&cloud.intensities));
    hash.update(&cloud.classes);
    hash.digest128()
}

/// The fingerprint of a mesh in a file: of the file's stamp and the summary of its survey instead of its triangles.
pub(super) fn of_large_mesh(frame: &Mesh, stamp: &str, survey: impl Debug, options: &VoxelizeOptions) -> u128 {
    let mut hash = begin(options);
    add(&(stamp, survey), &mut hash);
    add_frame(frame, &mut hash);
    hash.digest128()
}

/// As [`of_large_mesh`], for a cloud.
pub(super) fn of_large_points(frame: &PointCloud, stamp: &str, survey: impl Debug, options: &VoxelizeOptions) -> u128 {
    let mut hash = begin(options);
    add(&(stamp, survey), &mut hash);
    add_cloud(frame, &mut hash);
    hash.digest128()
}

/// The fingerprint of work that is described by `about`, whose debug text has everything that its result depends on.
pub(crate) fn of_description(about: &impl Debug) -> u128 {
    let mut hash = Xxh3::new();
    add(&(VERSION, about), &mut hash);
    hash.digest128()
}

fn begin(options: &VoxelizeOptions) -> Xxh3 {
    let mut hash = Xxh3::new();
    add(&(VERSION, options), &mut hash);
    hash
}

/// Hashes the `Debug` text, in which Rust writes every float so that it can be read back exactly.
fn add(value: &impl Debug, hash: &mut Xxh3) {
    let text = format!("{value:?}");
    hash.update(&(text.len() as u64).to_le_bytes());
    hash.update(text.as_bytes());
}

fn add_frame(mesh: &Mesh, hash: &mut Xxh3) {
    let counts =
        [mesh.positions.len(), mesh.triangles.len(), mesh.uvs.len(), mesh.colors.len(), mesh.material_of.len()];
    add(&(counts, &mesh.name, mesh.offset, &mesh.materials, &mesh.cameras, mesh.unit), hash);
    for texture in &mesh.textures {
        add(&texture.size(), hash);
        hash.update(texture.texels().as_flattened());
    }
}

fn add_cloud(cloud: &PointCloud, hash: &mut Xxh3) {
    let counts = [cloud.positions.len(), cloud.colors.len(), cloud.intensities.len(), cloud.classes.len()];
    add(&(counts, &cloud.name, cloud.offset, &cloud.crs, cloud.crs_from_cloud, cloud.unit), hash);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxelize::Scale;
    use glam::{Vec2, Vec3, Vec4};

    #[test]
    fn every_change_of_the_mesh_or_the_options_is_other_work() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
            triangles: vec![[0, 1, 2]],
            uvs: vec![Vec2::ZERO; 4],
            colors: vec![Vec4::ONE; 4],
            material_of: vec![0],
            ..Mesh::new("mesh")
        };
        let options = VoxelizeOptions::default();
        type Change = fn(&mut Mesh, &mut VoxelizeOptions);
        let changes: [Change; 12] = [
            |_, _| {},
            |mesh, _| mesh.positions[1].x = 1.000_000_1,
            |mesh, _| mesh.triangles[0] = [0, 1, 3],
            |mesh, _| mesh.uvs[3].y = -0.0,
            |mesh, _| mesh.colors[0].w = 0.5,
            |mesh, _| mesh.material_of = Vec::new(),
            |mesh, _| mesh.materials[0].roughness = 0.5,
            |mesh, _| mesh.offset.z = 1.0,
            |_, options| options.scale = Scale::Resolution(511),
            |_, options| options.fill = true,
            |_, options| options.memory_budget = Some(1 << 30),
            |_, options| options.max_materials = 9,
        ];
        let mut prints: Vec<u128> = changes
            .iter()
            .map(|change| {
                let (mut mesh, mut options) = (mesh.clone(), options);
                change(&mut mesh, &mut options);
                of_mesh(&mesh, &options)
            })
            .collect();
        assert_eq!(prints[0], of_mesh(&mesh, &options));
        prints.sort_unstable();
        prints.dedup();
        assert_eq!(prints.len(), changes.len());
    }
}
