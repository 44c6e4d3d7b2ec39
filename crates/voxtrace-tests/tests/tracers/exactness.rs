//! The walk against the double-precision brute force: the same voxel and face for every ray.

use rayon::prelude::*;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::{Hit, Material, PackedScene, Ray, Scene, VoxelGrid};
use voxtrace_core::walk::{self, Instructions};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::{FAN, FAN_KINDS, KINDS, fans, mixed};
use voxtrace_tests::reference::Bitmap;
use voxtrace_tests::scenes::{dust, hollow_sphere, noise};

/// Compares hits with the reference. Describes the first ray that differs; the kind of ray changes every `run` rays.
fn compare(bitmap: &Bitmap, rays: &[Ray], hits: &[Hit], kinds: &[&str], run: usize) -> Result<(), String> {
    let differs = |(index, (ray, hit)): (usize, (&Ray, &Hit))| {
        let expected = bitmap.cast(ray);
        let is_same = match &expected {
            None => *hit == Hit::MISS,
            Some(expected) => {
                let t = f64::from(hit.t);
                let is_near = (t - expected.t).abs() <= 1e-4 * (1.0 + expected.t.abs());
                !hit.is_miss() && hit.voxel == expected.voxel && hit.face == expected.face && is_near
            }
        };
        (!is_same).then(|| {
            format!("ray {index} ({}): {ray:?}\n got {hit:?}\n not {expected:?}", kinds[index / run % kinds.len()])
        })
    };
    rays.par_iter().zip(hits).enumerate().find_map_first(differs).map_or(Ok(()), Err)
}

fn pack(grid: VoxelGrid) -> PackedScene {
    let largest = grid.voxels().map(|(_, material)| material).max().unwrap_or(0);
    let materials = vec![Material::default(); usize::from(largest) + 1];
    PackedScene::pack(&Scene::from_grid("test", grid, materials)).expect("the scene is sound")
}

/// The hits of all rays, found in batches by each set of instructions that this processor has, of which every 16th ray is cast alone as well.
fn cast_all(packed: &PackedScene, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit::MISS; rays.len()];
    hits.par_chunks_mut(1 << 14).zip(rays.par_chunks(1 << 14)).for_each(|(hits, rays)| {
        walk::cast_batch(packed, rays, hits);
        for (ray, hit) in rays.iter().zip(hits.iter()).step_by(16) {
            assert_eq!(walk::cast(packed, ray), *hit, "{ray:?}");
        }
        for instructions in Instructions::ALL {
            assert_eq!(first_difference(instructions, packed, rays, hits), None, "{instructions:?}");
        }
    });
    hits
}

/// The first ray for which a set of instructions, where the processor has it, finds another hit.
fn first_difference(instructions: Instructions, packed: &PackedScene, rays: &[Ray], hits: &[Hit]) -> Option<usize> {
    let is_compared = instructions.is_available();
    let mut others = vec![Hit::MISS; rays.len()];
    let differs = |(hit, other): (&Hit, &Hit)| hit != other;
    is_compared.then(|| walk::cast_batch_with(instructions, packed, rays, &mut others))?;
    hits.iter().zip(&others).position(differs)
}

#[test]
fn a_hit_of_one_lane_that_is_wrong_is_noticed() {
    let grid = noise(IVec3::ZERO, 24, 0.1, 5, 9);
    let rays = mixed(&grid, 4096, 77);
    let packed = pack(grid);
    let mut hits = cast_all(&packed, &rays);
    let hit = hits.iter().position(|hit| !hit.is_miss()).unwrap();
    hits[hit].voxel.y += 1;
    assert_eq!(first_difference(Instructions::Portable, &packed, &rays, &hits), Some(hit));
}

fn check(grid: VoxelGrid, count: usize, seed: u64) {
    let bitmap = Bitmap::of(&grid);
    let sets = [(mixed(&grid, count, seed), &KINDS[..], 1), (fans(&grid, count, seed), &FAN_KINDS[..], FAN)];
    let packed = pack(grid);
    for (rays, kinds, run) in sets {
        let hits = cast_all(&packed, &rays);
        let missed = hits.iter().filter(|hit| hit.is_miss()).count();
        assert!(missed < count / 10 * 9, "most rays miss: {missed} of {count}");
        compare(&bitmap, &rays, &hits, kinds, run).unwrap();
    }
}

#[test]
fn walk_agrees_with_brute_force_in_noise() {
    check(noise(IVec3::new(-13, 5, 100), 60, 0.002, 300, 1), 200_000, 2);
    check(noise(IVec3::ZERO, 40, 0.05, 40, 3), 200_000, 4);
    check(noise(IVec3::splat(-16), 24, 0.4, 9, 5), 200_000, 6);
}

#[test]
fn walk_agrees_with_brute_force_in_sparse_space() {
    check(dust(400, 300, 7), 100_000, 8);
}

#[test]
fn walk_agrees_with_brute_force_in_tiny_grids() {
    for seed in 0..40 {
        let mut grid = noise(IVec3::splat(seed - 20), 3, 0.2, 3, seed as u64);
        grid.set(IVec3::splat(seed - 20), 1);
        check(grid, 4_000, 100 + seed as u64);
    }
}

#[test]
fn walk_agrees_with_brute_force_in_the_built_in_scenes() {
    for (seed, name) in voxtrace::scenes::STUDY_NAMES.into_iter().enumerate() {
        let scene = voxtrace::scenes::generate(name, None).expect("the scene exists");
        check((*scene.grids[0]).clone(), 1_000_000, 40 + seed as u64);
    }
}

#[test]
fn no_ray_leaks_through_a_closed_shell() {
    let packed = pack(hollow_sphere(60));
    let leaks = (0..100u64).into_par_iter().map(|seed| count_leaks(&packed, 100_000, seed)).sum::<usize>();
    assert_eq!(leaks, 0);

    // The same shell with a hole of one voxel.
    let mut grid = hollow_sphere(60);
    for x in 50..62 {
        grid.clear(IVec3::new(x, 0, 0));
    }
    let packed = pack(grid);
    assert!((0..10).map(|seed| count_leaks(&packed, 100_000, seed)).sum::<usize>() > 0);
}

/// Rays from inside a shell around the origin that meet nothing; half of the origins and directions are integers.
fn count_leaks(packed: &PackedScene, count: usize, seed: u64) -> usize {
    let mut random = Random(seed);
    let rays: Vec<Ray> = (0..count)
        .map(|i| {
            let origin = random.point(Vec3::splat(-20.0), Vec3::splat(20.0));
            let origin = if i % 2 == 0 { origin.round() } else { origin };
            let direction = random.direction();
            let steps = (direction * 6.0).round();
            Ray::new(origin, if i % 4 < 2 || steps == Vec3::ZERO { direction } else { steps })
        })
        .collect();
    let mut hits = vec![Hit::MISS; count];
    walk::cast_batch(packed, &rays, &mut hits);
    hits.iter().filter(|hit| hit.is_miss()).count()
}

#[test]
fn one_flipped_occupancy_bit_is_noticed() {
    let grid = noise(IVec3::ZERO, 24, 0.1, 5, 9);
    let packed = pack(grid.clone());
    let sets = [(mixed(&grid, 200_000, 10), &KINDS[..], 1), (fans(&grid, 200_000, 10), &FAN_KINDS[..], FAN)];
    for (rays, kinds, run) in sets {
        let mut hits = vec![Hit::MISS; rays.len()];
        walk::cast_batch(&packed, &rays, &mut hits);
        for voxel in [IVec3::new(11, 12, 13), IVec3::new(3, 20, 7)] {
            let mut bitmap = Bitmap::of(&grid);
            bitmap.flip(voxel);
            let noticed = compare(&bitmap, &rays, &hits, kinds, run).is_err();
            assert!(noticed, "the flip of {voxel} went unnoticed");
        }
    }
}

#[test]
fn every_voxel_keeps_its_material() {
    for grid in [noise(IVec3::splat(-9), 30, 0.3, 700, 21), dust(3000, 200, 22)] {
        let packed = pack(grid.clone());
        for (voxel, material) in grid.voxels() {
            assert_eq!(packed.geometry().material_at(&packed.grids()[0], voxel), Some(material.into()));
        }
        assert!(grid.count() > 5000);
        assert_eq!(packed.geometry().material_at(&packed.grids()[0], IVec3::splat(100_000)), None);
    }
}

#[test]
fn extreme_rays_end() {
    let packed = pack(noise(IVec3::ZERO, 24, 0.2, 5, 31));
    let extremes = [0.0, -0.0, 1e-45, -1e-38, 1e-30, 0.5, -3.0, 1e7, 1e20, -3e38, f32::INFINITY, f32::NAN];
    let mut random = Random(32);
    let mut pick = || Vec3::from_array(std::array::from_fn(|_| extremes[random.below(extremes.len())]));
    let rays: Vec<Ray> = (0..200_000).map(|_| Ray::new(pick(), pick())).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    walk::cast_batch(&packed, &rays, &mut hits);
    for (ray, hit) in rays.iter().zip(&hits) {
        assert_eq!(walk::cast(&packed, ray), *hit, "{ray:?}");
    }
    for instructions in Instructions::ALL {
        assert_eq!(first_difference(instructions, &packed, &rays, &hits), None, "{instructions:?}");
    }
    assert!(hits.iter().any(|hit| !hit.is_miss()));
}
