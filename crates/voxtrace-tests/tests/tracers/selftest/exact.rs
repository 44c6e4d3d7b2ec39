//! Decisions that must be right, and the material of a voxel.

use super::{Group, cell, cell_words, ray, ray_words, words};
use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Material, PackedScene, Ray, Scene, Transform};
use voxtrace_core::walk::{LocalRay, exact};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_tests::scenes::noise;

/// Steps of rays through boxes of any size: the ray, the voxel where it is, the planes through which it may leave, and
/// planes of the voxel where it arrives.
fn steps() -> Vec<u32> {
    let grid = noise(IVec3::new(-20, 3, 1000), 50, 0.01, 1, 7);
    let mut random = Random(8);
    let mut inputs = Vec::new();
    for ray in mixed(&grid, 4096, 9) {
        let t_min = if random.below(3) == 0 { random.unit() * 9.0 } else { 0.0 };
        let ray = Ray { t_min, ..ray };
        let Some(local) = LocalRay::new(&ray, &Transform::IDENTITY) else { continue };
        let mut voxel = exact::start_voxel(&local);
        for _ in 0..8 {
            let shift = random.below(8);
            let cell = voxel >> shift as i32;
            let is_negative = local.direction.cmplt(Vec3::ZERO);
            let exit = IVec3::select(is_negative, cell, cell + 1) << shift as i32;
            let arrival = exact::leave_box(&local, voxel, exit).expect("a local ray moves");
            let nearest = arrival + random.voxel(IVec3::ZERO, IVec3::splat(2));
            inputs.extend(ray_words(&ray));
            inputs.extend([voxel, exit, nearest].into_iter().flat_map(cell_words));
            voxel = arrival;
        }
    }
    inputs
}

/// A scene with one instance, not moved.
fn in_place() -> Arc<PackedScene> {
    painted(2).0
}

/// Rays of which many hit nothing: at no sensible speed, too far away, not finite. None has subnormal numbers, which devices
/// may take for zero.
fn strange_rays() -> Vec<u32> {
    let values = [0.0, -0.0, 1.0, -1.0, 0.7, 1e-18, 0.9e-18, 1e18, 1.1e18, 1e30, f32::INFINITY, f32::NAN];
    let places = [0.0, 0.5, -7.25, 100.0, 2_097_152.0, -2_097_152.5, f32::INFINITY, f32::NAN];
    let mut random = Random(10);
    let mut inputs = Vec::new();
    for case in 0..16_384 {
        // Half of them odd in one respect alone.
        let respect = if case % 2 == 0 { case / 2 % 3 } else { 3 };
        let mut any = |values: &[f32], of: usize, sane: f32| {
            if respect == of || respect == 3 { values[random.below(values.len())] } else { sane }
        };
        let origin = Vec3::new(any(&places, 0, 3.5), any(&places, 0, -8.0), any(&places, 0, 0.1));
        let direction = Vec3::new(any(&values, 1, 0.3), any(&values, 1, -0.2), any(&values, 1, 0.1));
        let (t_min, t_max) = (any(&values, 2, 0.0), any(&values, 2, f32::INFINITY));
        inputs.extend(ray_words(&Ray { origin, t_min, direction, t_max }));
    }
    inputs
}

#[test]
fn rays_in_grid_space_are_the_same_and_the_same_are_refused() {
    let prepare = |ray: Ray| {
        let local = LocalRay::new(&ray, &Transform::IDENTITY);
        let vectors = local.map_or([Vec3::ZERO; 3], |local| [local.origin, local.direction, local.inverse]);
        std::iter::once(local.is_some().into()).chain(words(vectors.iter().flat_map(Vec3::to_array))).collect()
    };
    let group = Group { entry: "check_local_ray", scene: &in_place(), words: (8, 10), inputs: strange_rays() };
    group.check(|case| prepare(ray(case)), |case| prepare(Ray { t_min: ray(case).t_min.abs(), ..ray(case) }));
}

#[test]
fn exact_decisions_are_the_same() {
    let output = |case: &[u32], leave_box: fn(&LocalRay, IVec3, IVec3) -> Option<IVec3>| {
        let local = LocalRay::new(&ray(case), &Transform::IDENTITY).expect("only such rays are asked for");
        let (voxel, exit) = (cell(&case[8..]), cell(&case[11..]));
        let arrival = leave_box(&local, voxel, exit).expect("a local ray moves");
        let hit = exact::hit_of(&local, voxel, 0);
        let cells = [exact::start_voxel(&local), arrival].into_iter().flat_map(cell_words);
        cells.chain([hit.t.to_bits(), hit.face]).collect::<Vec<u32>>()
    };
    let group = Group { entry: "check_exact", scene: &in_place(), words: (17, 8), inputs: steps() };
    group.check(|case| output(case, exact::leave_box), |case| output(case, leave_box_in_f32));
}

/// What plain f32 makes of it.
fn leave_box_in_f32(local: &LocalRay, _voxel: IVec3, exit: IVec3) -> Option<IVec3> {
    let t = (exit.as_vec3() - local.origin) * local.inverse;
    let axis = (0..3).min_by(|&a, &b| t[a].total_cmp(&t[b]))?;
    let mut arrival = (local.origin + local.direction * t[axis]).floor().as_ivec3();
    arrival[axis] = exit[axis] - i32::from(local.direction[axis] < 0.0);
    Some(arrival)
}

/// Grids with bricks of one, a few and hundreds of materials, full and nearly empty.
fn painted(materials: usize) -> (Arc<PackedScene>, Vec<IVec3>) {
    let mut grid = noise(IVec3::new(-11, 40, 3), 40, 0.3, materials as u16, 11);
    grid.fill_box(VoxelBox { min: IVec3::splat(64), max: IVec3::splat(76) }, 1);
    let voxels = grid.voxels().map(|(voxel, _)| voxel).collect();
    let scene = Scene::from_grid("painted", grid, vec![Material::default(); materials]);
    (Arc::new(PackedScene::pack(&scene).expect("the scene is sound")), voxels)
}

#[test]
fn the_material_of_each_voxel_is_the_same() {
    // One material, palettes of 8 bits, palettes of 16 bits.
    for materials in [2, 200, 3000] {
        let (scene, voxels) = painted(materials);
        let grid = &scene.grids()[0];
        let inputs = voxels.iter().flat_map(|&voxel| [0].into_iter().chain(cell_words(voxel))).collect();
        let material = |voxel: IVec3| scene.geometry().material_at(grid, voxel).expect("the voxel is occupied");
        let group = Group { entry: "check_material", scene: &scene, words: (4, 1), inputs };
        group.check(
            |case| vec![material(cell(&case[1..]))],
            // That of the next voxel of the row, where there is one.
            |case| {
                let next = cell(&case[1..]) + IVec3::X;
                vec![scene.geometry().material_at(grid, next).unwrap_or_else(|| material(cell(&case[1..])))]
            },
        );
    }
}

#[test]
fn what_is_known_around_a_voxel_of_a_brick_is_the_same() {
    let (scene, voxels) = painted(200);
    let grid = &scene.grids()[0];
    let is_empty = |low: IVec3, edge: i32| {
        let cells = (0..edge.pow(3)).map(|at| low + IVec3::new(at % edge, at / edge % edge, at / (edge * edge)));
        cells.into_iter().all(|voxel| scene.geometry().material_at(grid, voxel).is_none())
    };
    // The low bits of the largest known empty cube, within a block; all bits where the voxel is occupied.
    let around = |voxel: IVec3| match [4, 2, 1].into_iter().find(|&edge| is_empty(voxel & -edge, edge)) {
        Some(edge) => edge as u32 - 1,
        None => u32::MAX,
    };
    let mut random = Random(5);
    let cases: Vec<IVec3> =
        voxels.iter().map(|&voxel| (voxel & -8) + random.voxel(IVec3::ZERO, IVec3::splat(8))).collect();
    for edge in [0, 1, 3, u32::MAX] {
        assert!(cases.iter().any(|&voxel| around(voxel) == edge), "a voxel with {edge:x} around it");
    }
    let inputs =
        cases.iter().flat_map(|&voxel| [0].into_iter().chain(cell_words(voxel)).chain([random.below(8) as u32]));
    let group = Group { entry: "check_brick", scene: &scene, words: (5, 1), inputs: inputs.collect() };
    group.check(|case| vec![around(cell(&case[1..]))], |case| vec![around(cell(&case[1..]) ^ 1)]);
}
