//! Voxelizing, and a cube with a texture, for the tests of what meshes become.

#![allow(dead_code, reason = "each test uses some")]

use std::collections::BTreeSet;
use voxtrace::Scene;
use voxtrace::glam::{IVec3, Vec2, Vec3, Vec4};
use voxtrace::import::Limits;
use voxtrace::material::srgb_from_linear;
use voxtrace::mesh::{Mesh, MeshMaterial, Texture, TextureUse};
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions, voxelize};

pub fn options(scale: Scale) -> VoxelizeOptions {
    VoxelizeOptions { scale, ..VoxelizeOptions::default() }
}

/// Voxels of edge 1: a mesh whose lowest corner is in [0, 1)³ keeps its coordinates.
pub fn scene_of(mesh: &Mesh, rule: SurfaceRule) -> Scene {
    voxelize(mesh, &VoxelizeOptions { rule, ..options(Scale::VoxelSize(1.0)) }, &Limits::default()).unwrap()
}

pub fn voxels_of(scene: &Scene) -> BTreeSet<[i32; 3]> {
    scene.grids[0].voxels().map(|(voxel, _)| voxel.to_array()).collect()
}

pub fn textured_cube() -> (Mesh, impl Fn(usize, u32, u32) -> [u8; 3]) {
    let texel = |face: usize, x: u32, y: u32| [(30 * face + 20) as u8, (x * 30 + 10) as u8, (y * 30 + 5) as u8];
    let mut mesh = Mesh::new("cube");
    mesh.materials.clear();
    // For each face the origin and the directions of u and v.
    let faces = [
        [[0., 8., 0.], [0., -8., 0.], [0., 0., 8.]],
        [[8., 0., 0.], [0., 8., 0.], [0., 0., 8.]],
        [[0., 0., 0.], [8., 0., 0.], [0., 0., 8.]],
        [[8., 8., 0.], [-8., 0., 0.], [0., 0., 8.]],
        [[0., 8., 0.], [8., 0., 0.], [0., -8., 0.]],
        [[0., 0., 8.], [8., 0., 0.], [0., 8., 0.]],
    ];
    for (face, axes) in faces.into_iter().enumerate() {
        let [origin, u, v] = axes.map(Vec3::from_array);
        let first = mesh.positions.len() as u32;
        for (s, t) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            mesh.positions.push(origin + u * s + v * t);
            mesh.uvs.push(Vec2::new(s, t));
        }
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        mesh.material_of.extend([face as u16; 2]);
        let texels = (0..64).map(|i| texel(face, i % 8, i / 8)).map(|[r, g, b]| [r, g, b, 255]).collect();
        mesh.textures.push(Texture::new(8, 8, texels).unwrap());
        let texture = TextureUse { nearest: true, ..TextureUse::new(face as u32) };
        mesh.materials.push(MeshMaterial {
            base_color: Vec4::ONE,
            base_texture: Some(texture),
            ..MeshMaterial::default()
        });
    }
    mesh.validate().unwrap();
    (mesh, texel)
}

pub fn color_at(scene: &Scene, voxel: [i32; 3]) -> Option<[u8; 3]> {
    let material = scene.grids[0].get(IVec3::from_array(voxel))?;
    Some(scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear))
}
