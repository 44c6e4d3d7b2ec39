//! What is chosen for many receivers at once is what is chosen for each, to the bit; materials likewise.

use super::*;
use crate::packed::PackedScene;
use crate::sampler::Sampler;
use crate::walk;
use glam::{IVec3, Vec3};
use std::sync::Arc;
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::transform::Transform;
use voxtrace_scene::{Instance, Material, Scene, VoxelGrid};

/// Lamps of several strengths among walls, once or in several places.
fn scene(instances: usize) -> PackedScene {
    let mut grid = VoxelGrid::new();
    for i in 0..3000_i32 {
        let material = if i % 3 == 0 { 1 + (i / 3 % 2) as u16 } else { 0 };
        grid.set(IVec3::new(i * 7 % 61, i * 13 % 53, i * 29 % 47), material);
    }
    let lamp = |emission: f32| Material { emission: Vec3::splat(emission), ..Material::default() };
    let mut scene = Scene::from_grid("lamps", grid.clone(), vec![Material::default(), lamp(3.0), lamp(40.0)]);
    scene.grids.push(Arc::new(grid));
    for number in 1..instances {
        let translation = Vec3::new(90.25 * number as f32, 3.5, -7.75 * number as f32);
        scene.instances.push(Instance::new(1, Transform { translation, ..Transform::IDENTITY }));
    }
    PackedScene::pack(&scene).expect("the scene is sound")
}

fn numbers(index: usize) -> [f32; 8] {
    let sampler = Sampler { seed: 3, pixel: index as u32, sample: 0 };
    let ([a, b, c, d], [e, f, g, h]) = (sampler.independent(0), sampler.independent(1));
    [a, b, c, d, e, f, g, h]
}

/// Receivers in and around the scene, some of them in media.
fn asked(count: usize) -> Vec<Asked> {
    let one = |index: usize| {
        let [x, y, z, kind, u @ ..] = numbers(index);
        let point = Vec3::new(x * 200.0 - 60.0, y * 90.0 - 20.0, z * 90.0 - 20.0);
        let normal = [Vec3::X, Vec3::NEG_Z, Vec3::Y][(kind * 3.0) as usize];
        let receiver = if kind > 0.9 { Receiver::in_medium(point) } else { Receiver::on_surface(point, normal) };
        Asked { receiver, u }
    };
    (0..count).map(one).collect()
}

/// Whether anything differs between many at once and one after the other, which get other numbers where `is_spoiled`.
fn differs(scene: &PackedScene, instructions: Instructions, is_spoiled: bool) -> bool {
    let (lights, mut asked) = (Lights::new(scene), asked(1000));
    let mut found = vec![None; asked.len()];
    sample_all(instructions, &lights, &asked, &mut Room::default(), &mut found);
    assert!(found.iter().flatten().count() > 300 && found.iter().any(Option::is_none));
    asked[777].receiver.point.x += if is_spoiled { 0.125 } else { 0.0 };
    asked.iter().zip(found).any(|(Asked { receiver, u }, found)| lights.sample(receiver, *u) != found)
}

#[test]
fn lights_chosen_for_many_at_once_are_those_chosen_for_each() {
    for instances in [1, 2, 5] {
        let scene = scene(instances);
        for instructions in Instructions::ALL.into_iter().filter(|instructions| instructions.is_available()) {
            assert!(!differs(&scene, instructions, false), "{} with {instances}", instructions.name());
        }
        assert!(differs(&scene, Instructions::best(), true), "a fault is seen");
    }
}

#[test]
fn materials_looked_up_together_are_those_of_each_hit() {
    let scene = scene(2);
    let ray = |index: usize| {
        let [x, y, z, ..] = numbers(index);
        Ray::new(Vec3::new(-20.0, 60.0 * y, 50.0 * z), Vec3::new(1.0, x - 0.5, y - 0.5))
    };
    let hits: Vec<Hit> = (0..500).map(|index| walk::cast_whole(&scene, &ray(index))).collect();
    let mut indices = vec![u32::MAX; hits.len()];
    scene.packed_material_indices(&hits, |index| !hits[index].is_miss(), &mut indices);
    let each = |hit: &Hit| if hit.is_miss() { u32::MAX } else { scene.packed_material_index(hit) };
    let expected: Vec<u32> = hits.iter().map(each).collect();
    assert_eq!(indices, expected);
    assert!((0..3).all(|material| indices.contains(&material)) && indices.contains(&u32::MAX));
}
