//! Scenes whose instances became one grid: hits are those of the instances.

use rayon::prelude::*;
use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::packed::PlacementError;
use voxtrace::{
    Camera, CpuTracer, Frame, Hit, Instance, Integrator, Material, PackedScene, Placement, Ray, Scene, Tracer,
    Transform, VoxelGrid,
};
use voxtrace_core::walk;
use voxtrace_tests::gpu::{
    ONE_OF_EACH, assert_valid, compare_hits, device, exact_methods, film, film_methods, for_each_tracer,
};
use voxtrace_tests::lattice::{is_same, models, owners};
use voxtrace_tests::rays::{KINDS, mixed};
use voxtrace_tests::reference::Bitmap;
use voxtrace_tests::scenes::noise;
use voxtrace_vulkan::Primitive;

/// Rays at the models near the origin, as one grid of the world.
fn rays_at(scene: &Scene, count: usize, seed: u64) -> (VoxelGrid, Vec<Ray>) {
    let mut world = VoxelGrid::new();
    for voxel in owners(scene).into_keys().filter(|voxel| voxel.abs().max_element() < 200) {
        world.set(voxel, 0);
    }
    let rays = mixed(&world, count, seed);
    (world, rays)
}

/// A face of an instance as one of the world.
fn face_in_world(scene: &PackedScene, hit: &Hit) -> IVec3 {
    scene.instance(hit).world_from_grid.direction(hit.face().normal().as_vec3()).as_ivec3()
}

/// Compares the hits of a merged scene with the brute force in double precision over the voxels of the world, and says of each whose it must
/// be. Describes the first that is wrong.
fn check_hits(
    scene: &Scene,
    merged: &PackedScene,
    rays: &[Ray],
    hits: &[Hit],
    world: &VoxelGrid,
) -> Result<(), String> {
    let (owners, bitmap) = (owners(scene), Bitmap::of(world));
    let visible: Vec<&Instance> = (scene.instances.iter())
        .filter(|instance| scene.is_visible(instance) && !scene.grids[instance.grid].is_empty())
        .collect();
    let is_right = |ray: &Ray, hit: &Hit| {
        let Some(expected) = bitmap.cast(ray) else {
            // What is far away is not in the bitmap.
            return hit.is_miss() || visible[hit.instance as usize].world_from_grid.translation.length() > 500.0;
        };
        if hit.is_miss() {
            return false;
        }
        let (instance, voxel) = owners[&expected.voxel];
        let own = visible[instance as usize];
        let near = (f64::from(hit.t) - expected.t).abs() <= 1e-4 * (1.0 + expected.t.abs());
        let face = voxtrace::ray::FACES[expected.face as usize].normal();
        (hit.instance, hit.voxel) == (instance, voxel)
            && near
            && face_in_world(merged, hit) == face
            && merged.material_index(hit) == u32::from(scene.grids[own.grid].get(voxel).unwrap())
            && merged.normal(hit).as_ivec3() == face
            && std::ptr::eq(own, &raw const scene.instances[merged.scene_instance(hit)])
    };
    match rays.iter().zip(hits).find(|(ray, hit)| !is_right(ray, hit)) {
        Some((ray, hit)) => Err(format!("{ray:?}\n got {hit:?}\n not {:?}", bitmap.cast(ray))),
        None => Ok(()),
    }
}

fn cast(scene: &Arc<PackedScene>, rays: &[Ray]) -> Vec<Hit> {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene).unwrap();
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(rays, &mut hits).unwrap();
    hits
}

/// Fails where hits of [`mixed`] rays with and without merging differ. Rays that are made to pass planes, edges and corners exactly, kinds 3 to
/// 6, are left out: which side they pass changes as grids are turned. The brute force judges those.
fn check_alike(merged: &[Hit], kept: &[Hit]) {
    let usual = |index: &usize| ![3, 4, 5, 6].contains(&(index % KINDS.len()));
    let differ = (0..merged.len()).filter(usual).filter(|&index| !is_same(&merged[index], &kept[index])).count();
    assert!(differ * 1000 <= merged.len(), "{differ} of {} hits differ", merged.len());
}

#[test]
fn hits_are_of_the_instances_whatever_was_merged() {
    (0..24_u64).into_par_iter().for_each(|seed| {
        let scene = models(4 + seed as usize, seed);
        let kept = Arc::new(PackedScene::pack(&scene).unwrap());
        let merged = Arc::new(PackedScene::pack_merged(&scene).unwrap());
        merged.validate().unwrap();
        assert!(merged.is_merged() && merged.instances().len() == 1, "seed {seed}");
        assert_eq!(merged.instance_count(), kept.instances().len());
        let (world, rays) = rays_at(&scene, 8000, seed);
        let mut hits = cast(&merged, &rays);
        check_hits(&scene, &merged, &rays, &hits, &world).unwrap_or_else(|wrong| panic!("seed {seed}: {wrong}"));
        for (ray, hit) in rays.iter().zip(&hits) {
            assert_eq!(merged.cast(ray), hit.found());
            assert_eq!(merged.hit_of_part(&merged.hit_of_packed(hit)), *hit);
            assert_eq!(merged.hit_of_packed(hit), walk::cast(&merged, ray));
        }
        // With instances kept a ray is rounded to the space of each: on edges another voxel, elsewhere at most the last bits of t.
        let of_kept = cast(&kept, &rays);
        check_alike(&hits, &of_kept);
        for (ray, (a, b)) in
            rays.iter().zip(hits.iter().zip(&of_kept)).filter(|(_, (a, b))| is_same(a, b) && !a.is_miss())
        {
            // Across the face, as a grazing ray meets it elsewhere for the least that its origin moves.
            let across = ray.direction.dot(face_in_world(&merged, a).as_vec3());
            let size = 1.0 + ray.origin.abs().max_element() + a.t * ray.direction.abs().max_element();
            assert!(((a.t - b.t) * across).abs() <= 2e-6 * size, "{ray:?} {a:?} {b:?}");
        }
        // Planted: a voxel, an instance and a face beside the right one.
        let first = hits.iter().position(|hit| !hit.is_miss()).unwrap();
        let right = hits[first];
        let wrong = [
            Hit { voxel: right.voxel + IVec3::X, ..right },
            Hit { instance: (right.instance + 1) % merged.instance_count() as u32, ..right },
            Hit { face: right.face ^ 1, ..right },
        ];
        for wrong in wrong {
            hits[first] = wrong;
            check_hits(&scene, &merged, &rays, &hits, &world).unwrap_err();
        }
    });
}

/// Models among which some cannot be merged: one that stands twice, one that is turned by another angle, one of another size.
fn among_others(seed: u64) -> Scene {
    let mut scene = models(9, seed);
    let mut again = scene.instances[2].clone();
    again.world_from_grid = again.world_from_grid.translated(Vec3::new(3.0, 5.0, -7.0));
    scene.instances.insert(3, again);
    scene.instances[5].world_from_grid.linear *= Mat3::from_rotation_z(0.3);
    let large = scene.instances[1].world_from_grid.scaled(2.0);
    scene.add_instance(scene.grids[0].as_ref().clone(), large);
    scene
}

#[test]
fn what_cannot_be_merged_stays_beside_what_is() {
    for seed in 100..116 {
        let scene = among_others(seed);
        let (kept, merged) = (PackedScene::pack(&scene).unwrap(), PackedScene::pack_merged(&scene).unwrap());
        merged.validate().unwrap();
        assert!(merged.is_merged() && merged.instances().len() > 3);
        let (_, rays) = rays_at(&scene, 8000, seed);
        let (hits, of_kept) = (cast(&Arc::new(merged.clone()), &rays), cast(&Arc::new(kept.clone()), &rays));
        check_alike(&hits, &of_kept);
        let met: std::collections::BTreeSet<u32> = hits.iter().map(|hit| hit.instance).collect();
        assert!(met.len() > 6, "{met:?}");
        assert_eq!(merged.split().content_hash(), kept.content_hash());
    }
}

#[test]
fn of_two_things_met_at_once_the_lowest_instance_is_the_hit() {
    // The second, which stands twice, lies where the third is: merged with the first, the third must not come before it.
    let mut block = VoxelGrid::new();
    block.set(IVec3::ZERO, 0);
    let mut scene = Scene { materials: vec![Material::default()], ..Scene::new("ties") };
    scene.add_instance(block.clone(), Transform::from_translation(Vec3::new(9.0, 0.0, 0.0)));
    let twice = scene.add_instance(block.clone(), Transform::IDENTITY);
    scene.add_instance(block.clone(), Transform::IDENTITY);
    scene.add_instance(block, Transform::from_translation(Vec3::new(0.0, 9.0, 0.0)));
    let again =
        Instance { world_from_grid: Transform::from_translation(Vec3::splat(30.0)), ..scene.instances[twice].clone() };
    scene.instances.push(again);
    let merged = PackedScene::pack_merged(&scene).unwrap();
    assert!(merged.is_merged() && merged.instances().len() == 4, "the first and the fourth are one");
    let ray = Ray::new(Vec3::new(0.3, 0.4, 9.0), Vec3::NEG_Z);
    assert_eq!(merged.cast(&ray).unwrap().instance, 1);
    // Where nothing is in between, all are merged, and the lower one keeps its place.
    scene.instances.swap(1, 4);
    scene.instances.truncate(4);
    let all = PackedScene::pack_merged(&scene).unwrap();
    assert_eq!((all.instances().len(), all.instance_count()), (1, 4));
    assert_eq!(all.cast(&ray).unwrap().instance, 2);
}

#[test]
fn nothing_is_merged_where_there_is_nothing_to_merge() {
    let mut scene = models(1, 3);
    let one = PackedScene::pack_merged(&scene).unwrap();
    assert!(!one.is_merged());
    assert_eq!(one.content_hash(), PackedScene::pack(&scene).unwrap().content_hash());
    scene.add_instance(scene.grids[0].as_ref().clone(), Transform::from_translation(Vec3::splat(0.5)));
    assert!(!PackedScene::pack_merged(&scene).unwrap().is_merged());
    assert!(!PackedScene::pack_merged(&Scene::new("empty")).unwrap().is_merged());
}

#[test]
fn models_that_lie_within_each_other_are_not_merged_where_that_takes_more_memory() {
    let block = noise(IVec3::ZERO, 24, 1.1, 1, 1);
    let place = |x: f32| Transform::from_translation(Vec3::new(x, 0.0, 0.0));
    let packed = |x: f32| {
        let mut scene = Scene::from_grid("blocks", block.clone(), vec![Material::default()]);
        scene.add_instance(block.clone(), place(x));
        PackedScene::pack_merged(&scene).unwrap()
    };
    assert!(packed(24.0).is_merged(), "side by side");
    assert!(packed(21.0).is_merged(), "a little within each other");
    assert!(!packed(0.0).is_merged(), "at one place");
}

#[test]
fn what_was_merged_comes_apart_as_it_was() {
    for seed in 0..12 {
        let scene = models(15, seed);
        let (kept, merged) = (PackedScene::pack(&scene).unwrap(), PackedScene::pack_merged(&scene).unwrap());
        assert_eq!(merged.to_scene(), kept.to_scene(), "covered voxels too");
        let split = merged.split();
        assert!(!split.is_merged());
        split.validate().unwrap();
        assert_eq!(split.content_hash(), kept.content_hash());
        assert_ne!(merged.content_hash(), kept.content_hash());
        assert_eq!((split.outline, split.name), (kept.outline.clone(), kept.name.clone()));
        let counts = |scene: &PackedScene| {
            let counted = scene.statistics();
            (counted.voxels, counted.models, counted.instances)
        };
        assert_eq!(counts(&merged), counts(&kept));
        // Nothing of it is left in the merged scene where one of its voxels is of another instance.
        let mut other = scene.clone();
        other.instances.swap(0, 1);
        assert_ne!(PackedScene::pack_merged(&other).unwrap().to_scene(), kept.to_scene());
    }
}

#[test]
fn a_merged_scene_is_not_moved_in_part_but_a_split_one_is() {
    let scene = models(6, 5);
    let merged = PackedScene::pack_merged(&scene).unwrap();
    let refused = Placement::of_scene(merged.geometry(), &scene).unwrap_err();
    assert_eq!(refused, PlacementError::Merged);
    assert_eq!(Placement::new(merged.geometry(), []).unwrap_err(), PlacementError::Merged);
    let split = merged.split();
    let placement = Placement::of_scene(split.geometry(), &scene).unwrap();
    assert_eq!(placement.instances(), PackedScene::pack(&scene).unwrap().instances());
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&Arc::new(merged.clone())).unwrap();
    tracer.set_placement(merged.placement()).unwrap();
    tracer.set_scene(&Arc::new(split)).unwrap();
    tracer.set_placement(&placement).unwrap();
}

#[test]
fn tracers_on_a_device_find_the_hits_and_make_the_films_of_the_cpu() {
    let Some(device) = device() else { return };
    for scene in [models(12, 4), among_others(101)] {
        let merged = Arc::new(PackedScene::pack_merged(&scene).unwrap());
        let (_, rays) = rays_at(&scene, 1 << 14, 9);
        let expected = cast(&merged, &rays);
        let methods: Vec<_> =
            exact_methods().into_iter().filter(|(_, primitive)| *primitive != Primitive::Triangle).collect();
        for_each_tracer(&device, &methods, &merged, |tracer, _, _| {
            let mut hits = vec![Hit::MISS; rays.len()];
            tracer.cast_into(&rays, &mut hits).unwrap();
            compare_hits(&rays, &hits, &expected).unwrap();
            hits[7].voxel.x += 1;
            compare_hits(&rays, &hits, &expected).unwrap_err();
        });
        let frame = Frame::new(Camera::look_at(Vec3::new(90.3, -70.7, 55.1), Vec3::ZERO), 31, 17);
        let frame = frame.samples(2).aovs(true).integrator(Integrator::Path);
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(&merged).unwrap();
        let expected = film(&mut cpu, &frame);
        for_each_tracer(&device, &film_methods(&device, &ONE_OF_EACH), &merged, |tracer, traversal, primitive| {
            let found = film(tracer, &frame);
            assert!(found.pixels == expected.pixels, "{traversal:?} {primitive:?}");
            assert!(found.aovs == expected.aovs, "{traversal:?} {primitive:?}");
        });
    }
    assert_valid(&device);
}
