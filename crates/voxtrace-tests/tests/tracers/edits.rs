//! Scenes that are edited while devices trace them: hits and films are those of the scene packed from scratch, bit for bit.

use std::sync::Arc;
use voxtrace::dynamic::{DynamicScene, Edit, Patch};
use voxtrace::glam::{DVec3, IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{
    Camera, CpuTracer, Frame, Hit, Integrator, Material, PackedScene, Ray, Scene, Shape, TraceError, Tracer, Transform,
    VoxelGrid,
};
use voxtrace_test_support::skip;
use voxtrace_tests::gpu::{assert_valid, compare_hits, device, film, wanted};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_vulkan::{Device, Fault, Faults, Options, Primitive, Settings, Traversal, VulkanTracer, missing};

/// A floor with lamps, and a turned lamp above it.
pub fn example() -> Scene {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-40, -40, -3), max: IVec3::new(40, 40, 0) }, 0);
    for lamp in 0..40 {
        grid.set(IVec3::new(lamp * 7 % 60 - 30, lamp * 13 % 50 - 25, 20 + lamp % 3), 1);
    }
    let materials = vec![
        Material::diffuse(Vec3::new(0.7, 0.6, 0.5)),
        Material::emissive(Vec3::new(9.0, 7.0, 4.0)),
        Material::diffuse(Vec3::new(0.2, 0.4, 0.8)),
    ];
    let mut scene = Scene { materials, ..Scene::from_grid("edited", grid, Vec::new()) };
    let mut small = VoxelGrid::new();
    small.set(IVec3::new(3, 4, 5), 1);
    let linear = Mat3::from_rotation_x(0.3) * 2.0;
    scene.add_instance(small, Transform { linear, translation: Vec3::new(3.0, 50.0, 20.0) });
    scene
}

/// An edit; each fifth time far out, where bounds grow, and every so often all of a grid is taken away.
fn edit_of(round: usize, random: &mut Random) -> (u32, Edit) {
    let grid = (random.below(3) / 2) as u32;
    if round % 37 == 30 {
        let everything = VoxelBox { min: IVec3::splat(-2000), max: IVec3::splat(2000) };
        return (1, Edit::Fill { shape: Shape::Box(everything), material: None });
    }
    let reach = if round % 5 == 4 { 300 } else { 45 };
    let at = random.voxel(IVec3::splat(-reach), IVec3::splat(reach));
    let material = (random.below(4) > 0).then(|| random.below(3) as u16);
    let shape = match random.below(3) {
        0 => Shape::Box(VoxelBox { min: at & !7, max: (at & !7) + 1 }),
        1 => Shape::Box(VoxelBox { min: at, max: at + IVec3::new(9, 3, 14) }),
        _ => Shape::Sphere { center: at.as_dvec3() + DVec3::splat(0.3), radius: 2.0 + random.below(9) as f64 },
    };
    match random.below(8) {
        0 => (grid, Edit::Paint { shape, material: random.below(3) as u16 }),
        1 => (grid, Edit::Replace { within: None, from: random.below(3) as u16, to: material }),
        _ => (grid, Edit::Fill { shape, material }),
    }
}

pub fn frame() -> Frame {
    let camera = Camera::look_at(Vec3::new(70.0, -90.0, 60.0), Vec3::new(0.0, 0.0, 10.0));
    Frame::new(camera, 31, 17).samples(2).integrator(Integrator::Path)
}

pub fn hits_of(tracer: &mut dyn Tracer, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(rays, &mut hits).unwrap();
    hits
}

/// Edits a scene on a device, and compares it every so often with the edited scene packed from scratch. Returns the patches.
fn check_edits(traversal: Traversal, primitive: Primitive) {
    let Some(device) = device() else { return };
    if let Some(reason) = missing(device.info(), traversal) {
        skip(&format!("{} has no {}: {reason}", device.info().name, traversal.name()));
        return;
    }
    let settings = Settings { traversal, primitive, is_exact: true };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
    let scene = example();
    let rays = mixed(&scene.grids[0], 4096, 5);
    let packed = PackedScene::pack(&scene).unwrap();
    assert_eq!(tracer.patch(&Patch::default()), Err(TraceError::NoScene));
    tracer.set_scene(&Arc::new(packed.clone())).unwrap();
    let mut edited = DynamicScene::new(packed).unwrap();
    let (mut random, mut cpu) = (Random(11), CpuTracer::new(None));
    let mut before = None;
    for round in 0..120 {
        let (grid, edit) = edit_of(round, &mut random);
        edited.edit(grid, &edit).unwrap();
        match round % 9 {
            3 => _ = edited.undo().unwrap(),
            5 => _ = edited.redo().unwrap(),
            7 => _ = edited.repair(3),
            _ => {}
        }
        // Often several edits at a time.
        if round % 3 == 0 {
            continue;
        }
        let patch = edited.take_patch();
        tracer.patch(&patch).unwrap();
        if round % 24 != 23 {
            continue;
        }
        cpu.set_scene(&Arc::new(edited.compact())).unwrap();
        let expected = hits_of(&mut cpu, &rays);
        let mut hits = hits_of(&mut tracer, &rays);
        compare_hits(&rays, &hits, &expected).unwrap();
        hits[7].voxel.x += 1;
        compare_hits(&rays, &hits, &expected).unwrap_err();
        let expected = film(&mut cpu, &frame());
        assert!(film(&mut tracer, &frame()).pixels == expected.pixels, "round {round}");
        assert!(before.is_none_or(|before| before != expected.pixels), "edits are to be seen");
        before = Some(expected.pixels);
    }
    // A patch that is left out is noticed, and nothing of the next one is taken.
    let solid = |x: i32| Edit::Fill {
        shape: Shape::Box(VoxelBox { min: IVec3::new(x, 0, 30), max: IVec3::new(x + 9, 9, 39) }),
        material: Some(2),
    };
    let now = film(&mut tracer, &frame());
    edited.edit(0, &solid(-20)).unwrap();
    let left_out = edited.take_patch();
    edited.edit(0, &solid(10)).unwrap();
    let next = edited.take_patch();
    assert!(matches!(tracer.patch(&next), Err(TraceError::OutOfStep(_))));
    assert!(film(&mut tracer, &frame()).pixels == now.pixels);
    tracer.patch(&left_out).unwrap();
    tracer.patch(&next).unwrap();
    assert!(film(&mut tracer, &frame()).pixels != now.pixels);
    // The scene as it is can be set, and followed from there.
    let mut other = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
    other.set_scene(&Arc::new(edited.scene().clone())).unwrap();
    assert!(film(&mut other, &frame()).pixels == film(&mut tracer, &frame()).pixels);
    edited.undo().unwrap();
    let patch = edited.take_patch();
    other.patch(&patch).unwrap();
    tracer.patch(&patch).unwrap();
    assert!(film(&mut other, &frame()).pixels == film(&mut tracer, &frame()).pixels);
    drop((tracer, other));
    assert_valid(&device);
}

#[test]
fn edits_with_the_compute_walk_give_what_packing_anew_does() {
    check_edits(Traversal::Walk, Primitive::default());
}

#[test]
fn edits_with_queries_give_what_packing_anew_does() {
    check_edits(Traversal::Query, Primitive::Grid);
}

#[test]
fn edits_with_a_pipeline_give_what_packing_anew_does() {
    check_edits(Traversal::Pipeline, Primitive::Brick);
}

#[test]
fn a_scene_that_the_cpu_traces_for_a_lost_device_is_edited_in_place() {
    let Some(wanted) = wanted() else { return };
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&wanted), None).unwrap();
    let mut tracer = VulkanTracer::new(device, Settings::default()).unwrap();
    let packed = PackedScene::pack(&example()).unwrap();
    tracer.set_scene(&Arc::new(packed.clone())).unwrap();
    faults.plant("vkQueueSubmit", Fault::DeviceLost);
    faults.plant("vkCreateDevice", Fault::OutOfHostMemory);
    let before = film(&mut tracer, &frame());
    assert!(tracer.is_on_cpu());
    let mut edited = DynamicScene::new(packed).unwrap();
    let shape = Shape::Box(VoxelBox { min: IVec3::new(-9, -9, 0), max: IVec3::new(9, 9, 9) });
    let mut places = Vec::new();
    for edit in [Edit::Fill { shape, material: Some(2) }, Edit::Paint { shape, material: 0 }] {
        edited.edit(0, &edit).unwrap();
        tracer.patch(&edited.take_patch()).unwrap();
        places.push(tracer.scene().unwrap().geometry().cells().as_ptr());
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(&Arc::new(edited.scene().clone())).unwrap();
        let ours = film(&mut tracer, &frame());
        assert!(ours == film(&mut cpu, &frame()) && ours != before);
    }
    assert_eq!(places[0], places[1], "the arrays were copied");
    // A patch that does not follow leaves it as it is.
    edited.edit(0, &Edit::Fill { shape, material: None }).unwrap();
    edited.take_patch();
    edited.edit(0, &Edit::Fill { shape, material: Some(1) }).unwrap();
    assert!(matches!(tracer.patch(&edited.take_patch()), Err(TraceError::OutOfStep(_))));
    assert_eq!(tracer.scene().unwrap().geometry().cells().as_ptr(), places[1]);
}
