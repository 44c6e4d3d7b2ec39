//! Scenes of many models on the lattice of the world, and whose each voxel of the world is, found voxel by voxel.

use crate::random::Random;
use crate::scenes::noise;
use std::collections::HashMap;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::{Hit, Material, Scene, Transform, VoxelGrid};

/// One of the 48 ways to turn and mirror a cube.
fn turn(random: &mut Random) -> Mat3 {
    let [x, y, z] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]][random.below(6)];
    let mut axis = |axis: usize| Vec3::AXES[axis] * if random.below(2) == 0 { 1.0 } else { -1.0 } + Vec3::ZERO;
    Mat3::from_cols(axis(x), axis(y), axis(z))
}

/// `count` models, turned, mirrored and moved by whole voxels: some touch or lie within others, some are empty or one voxel, one is far away,
/// and one has a hidden copy. Material 2 glows.
pub fn models(count: usize, seed: u64) -> Scene {
    let mut random = Random(seed);
    let mut scene = Scene::new("models");
    scene.materials = (0..9).map(|shade| Material::diffuse(Vec3::splat(0.1 * (shade + 1) as f32))).collect();
    scene.materials[2] = Material::emissive(Vec3::new(3.0, 2.0, 1.0));
    for index in 0..count {
        let corner = random.voxel(IVec3::splat(-40), IVec3::splat(20));
        let grid = match index % 7 {
            5 if index > 7 => VoxelGrid::new(),
            6 => noise(corner, 1, 1.1, 9, random.bits()),
            _ => noise(corner, 6 + random.below(14) as i32, [0.03, 0.3, 1.1][random.below(3)], 9, random.bits()),
        };
        let linear = if index % 5 == 0 { Mat3::IDENTITY } else { turn(&mut random) };
        let far = if index == 3 { IVec3::new(3000, -2000, 900) } else { IVec3::ZERO };
        let place = random.voxel(IVec3::splat(-20), IVec3::splat(20)) * if index % 3 == 0 { 8 } else { 1 } + far;
        let middle = linear * corner.as_vec3();
        scene.add_instance(grid, Transform { linear, translation: place.as_vec3() - middle });
    }
    let mut hidden = scene.instances[0].clone();
    hidden.hidden = true;
    scene.instances.push(hidden);
    scene
}

/// For each voxel of the world that is filled the index, as hits count, of the first instance that has one there, and its own voxel.
pub fn owners(scene: &Scene) -> HashMap<IVec3, (u32, IVec3)> {
    let mut owners = HashMap::new();
    let visible = |instance: &&voxtrace::Instance| scene.is_visible(instance) && !scene.grids[instance.grid].is_empty();
    for (index, instance) in scene.instances.iter().filter(visible).enumerate() {
        for (voxel, _) in scene.grids[instance.grid].voxels() {
            let middle = instance.world_from_grid.point(voxel.as_vec3() + 0.5);
            owners.entry(middle.floor().as_ivec3()).or_insert((index as u32, voxel));
        }
    }
    owners
}

/// Whether two hits are of the same face of the same voxel.
pub fn is_same(a: &Hit, b: &Hit) -> bool {
    (a.instance, a.voxel, a.face) == (b.instance, b.voxel, b.face)
}
