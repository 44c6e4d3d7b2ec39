//! Ten thousand random edits of all kinds while a device traces the scene: hits of a million rays, films and with them the choice among lights are
//! those of the scene packed from scratch. `VOXTRACE_EDITS` says how many edits there are, and `VOXTRACE_RAYS` how many rays at the end.

use crate::edits::{example, frame, hits_of};
use std::sync::Arc;
use voxtrace::dynamic::{ArrayPatch, DynamicScene, Edit, Patch};
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::FACES;
use voxtrace::{Axis, CpuTracer, Material, PackedScene, Ray, Shape, Tracer};
use voxtrace_tests::gpu::{assert_valid, compare_hits, device, film, tracer_of};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_vulkan::{Primitive, Traversal, VulkanTracer};

/// Edits between two patches, at most.
const BATCH: usize = 8;
/// How often the scenes are compared on the way, and by how many rays.
const COMPARED: usize = 8;
const RAYS_ON_THE_WAY: usize = 20_000;

fn number(variable: &str, default: usize) -> usize {
    std::env::var(variable).map_or(default, |value| value.parse().expect("a number"))
}

/// A voxel near the middle, often the first or the last one of a brick, now and then far out.
fn place(random: &mut Random) -> IVec3 {
    let reach = if random.below(60) == 0 { 400 } else { 50 };
    let at = random.voxel(IVec3::splat(-reach), IVec3::splat(reach));
    match random.below(4) {
        0 => at & !7,
        1 => at | 7,
        _ => at,
    }
}

fn region(random: &mut Random, size: i32) -> VoxelBox {
    let min = place(random);
    VoxelBox { min, max: min + random.voxel(IVec3::ONE, IVec3::splat(size)) }
}

fn shape(random: &mut Random) -> Shape {
    let (at, radius) = (place(random), 9.0 * f64::from(random.unit()));
    let center = at.as_dvec3() + DVec3::splat(0.3);
    match random.below(8) {
        0..4 => Shape::Box(VoxelBox { min: at, max: at + 1 }),
        4 => Shape::Box(region(random, 12)),
        5 => Shape::Capsule {
            from: center,
            to: center + random.voxel(IVec3::splat(-9), IVec3::splat(9)).as_dvec3(),
            radius: radius / 2.0,
        },
        _ => Shape::Sphere { center, radius },
    }
}

fn edit_of(scene: &DynamicScene, grid: u32, random: &mut Random) -> Edit {
    let materials = scene.scene().materials().len();
    let material = |random: &mut Random| random.below(materials) as u16;
    let some = (random.below(5) > 1).then(|| material(random));
    match random.below(16) {
        0 => Edit::Paint { shape: shape(random), material: material(random) },
        1 => Edit::Replace { within: Some(region(random, 24)), from: material(random), to: some },
        2 => {
            let clip = scene.copy(grid, region(random, 12)).expect("there is such a grid");
            let clip = clip.turned(Axis::Z, random.below(4) as i32).mirrored(Axis::Y);
            Edit::Paste { clip: clip.into(), at: place(random), with_empty: random.below(2) == 0 }
        }
        3 => Edit::Extrude {
            layer: region(random, 9),
            face: FACES[random.below(6)],
            distance: random.below(10) as i32 - 4,
        },
        4 => Edit::Flood { start: place(random), material: some, within: region(random, 20), most: 1 << 16 },
        _ => Edit::Fill { shape: shape(random), material: some },
    }
}

/// An edit, or one that is undone or done again, distances that are made longer, or a new material.
fn step(scene: &mut DynamicScene, random: &mut Random) {
    match random.below(12) {
        0 => _ = scene.undo().unwrap(),
        1 => _ = scene.redo().unwrap(),
        2 => _ = scene.repair(random.below(4)),
        3 if random.below(50) == 0 => scene.settle(),
        4 if random.below(100) == 0 => {
            let material = Material::diffuse(random.point(Vec3::ZERO, Vec3::ONE));
            let material = if random.below(2) == 0 { material } else { Material::emissive(Vec3::splat(3.0)) };
            scene.add_material(&material).unwrap();
        }
        _ => {
            let grid = (random.below(3) / 2) as u32;
            let edit = edit_of(scene, grid, random);
            scene.edit(grid, &edit).unwrap();
        }
    }
}

/// Compares a tracer that followed with one of the scene packed from scratch.
fn compare(tracer: &mut VulkanTracer, scene: &DynamicScene, rays: usize) -> (CpuTracer, Vec<Ray>) {
    scene.validate().unwrap();
    let voxels = scene.compact().to_scene();
    let packed = PackedScene::pack(&voxels).unwrap();
    let rays = mixed(&voxels.grids[0], rays, 5);
    let mut fresh = CpuTracer::new(None);
    fresh.set_scene(&Arc::new(packed)).unwrap();
    for rays in rays.chunks(1 << 17) {
        compare_hits(rays, &hits_of(tracer, rays), &hits_of(&mut fresh, rays)).unwrap();
    }
    assert!(film(tracer, &frame()).pixels == film(&mut fresh, &frame()).pixels);
    (fresh, rays)
}

/// A patch that brings a brick and leaves the skip distances around it as they were.
fn with_stale_distances(mut patch: Patch) -> Patch {
    let record = patch.changed_bricks[0].cell.unwrap();
    let mut words = patch.cells.parts().flat_map(|(start, words)| (start..).zip(words.iter().copied()));
    let own = words.find(|(_, word)| *word == record).unwrap();
    drop(words);
    patch.cells = ArrayPatch { length: patch.cells.length, ranges: vec![(own.0, 1)], records: vec![record] };
    patch
}

fn check_many_edits(traversal: Traversal, primitive: Primitive) {
    let Some(device) = device() else { return };
    let packed = PackedScene::pack(&example()).unwrap();
    let Some(mut tracer) = tracer_of(&device, traversal, primitive, &Arc::new(packed.clone())) else { return };
    let mut scene = DynamicScene::new(packed).unwrap();
    let mut random = Random(29);
    let edits = number("VOXTRACE_EDITS", 10_000);
    let (mut made, mut next_comparison) = (0, 0);
    while made < edits {
        for _ in 0..1 + random.below(BATCH) {
            step(&mut scene, &mut random);
            made += 1;
        }
        tracer.patch(&scene.take_patch()).unwrap();
        if made >= next_comparison {
            compare(&mut tracer, &scene, RAYS_ON_THE_WAY);
            next_comparison += edits / COMPARED;
        }
    }
    let (mut fresh, rays) = compare(&mut tracer, &scene, number("VOXTRACE_RAYS", 1_000_000));
    // A voxel in the empty space above all: its brick is written, and rays leap over it.
    let top = scene.scene().grids()[0].max.z;
    let at = IVec3::new(0, 0, top + 12);
    let voxel = Shape::Box(VoxelBox { min: at, max: at + 8 });
    scene
        .edit(0, &Edit::Fill { shape: Shape::Box(VoxelBox { min: at + 40, max: at + 41 }), material: Some(0) })
        .unwrap();
    tracer.patch(&scene.take_patch()).unwrap();
    scene.edit(0, &Edit::Fill { shape: voxel, material: Some(0) }).unwrap();
    tracer.patch(&with_stale_distances(scene.take_patch())).unwrap();
    fresh.set_scene(&Arc::new(scene.compact())).unwrap();
    let down = |index: usize| {
        let aim = at.as_vec3() + Vec3::new((index % 8) as f32 + 0.5, (index / 8 % 8) as f32 + 0.5, 0.0);
        Ray::new(aim + Vec3::new(0.0, 0.0, 60.0 + (index % 40) as f32), Vec3::NEG_Z)
    };
    let rays: Vec<Ray> = (0..1024).map(down).chain(rays.into_iter().take(1024)).collect();
    let expected = hits_of(&mut fresh, &rays);
    compare_hits(&rays, &hits_of(&mut tracer, &rays), &expected).expect_err("a stale skip distance");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn ten_thousand_edits_with_the_compute_walk_give_what_packing_anew_does() {
    check_many_edits(Traversal::Walk, Primitive::default());
}

#[test]
fn ten_thousand_edits_with_queries_give_what_packing_anew_does() {
    check_many_edits(Traversal::Query, Primitive::Grid);
}

#[test]
fn ten_thousand_edits_with_a_pipeline_give_what_packing_anew_does() {
    check_many_edits(Traversal::Pipeline, Primitive::Brick);
}
