//! Pictures of scenes whose instances became one grid: those of the same voxels as one grid, with the names of the instances.

use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::lines::{GridLines, Line, Lines};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Progress, Scene, TraceError, Tracer, Transform,
    VoxelGrid,
};
use voxtrace_tests::estimate::{check_same, radiance_of, render};
use voxtrace_tests::gpu::{ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::lattice::models;
use voxtrace_tests::rooms;
/// A room of three models: two halves with lamps, and a thing of glass and cloud that reaches into both and hides a part of itself in the
/// first.
fn room() -> Scene {
    let whole = rooms::lamp_room();
    let grid = &whole.grids[whole.instances[0].grid];
    let middle = (grid.bounds().unwrap().min + grid.bounds().unwrap().max) / 2 + IVec3::new(3, 0, 0);
    let mut scene = Scene { grids: vec![], instances: vec![], ..whole.clone() };
    let (glass, cloud) = (scene.materials.len() as u16, scene.materials.len() as u16 + 1);
    scene.materials.push(Material { transmission: 1.0, ior: 1.5, ..Material::default() });
    scene.materials.push(Material { transmission: 1.0, ior: 1.0, scattering: 0.2, ..Material::default() });
    for side in [false, true] {
        let mut half = VoxelGrid::new();
        let of_side = grid.voxels().filter(|(voxel, _)| (voxel.x >= middle.x) == side);
        of_side.for_each(|(voxel, material)| _ = half.set(voxel, material));
        for at in 0..27 {
            let local = IVec3::new(at % 3, at / 3 % 3, at / 9) + IVec3::new(if side { 0 } else { -3 }, 0, 0);
            half.set(middle + local - IVec3::new(0, 0, 1), if at % 2 == 0 { glass } else { cloud });
        }
        // Mirrored in its own grid and mirrored back in the world.
        let mut mirrored = VoxelGrid::new();
        half.voxels().for_each(|(voxel, material)| _ = mirrored.set(IVec3::new(voxel.y, voxel.x, voxel.z), material));
        let turned = Transform { linear: Mat3::from_cols(Vec3::Y, Vec3::X, Vec3::Z), translation: Vec3::ZERO };
        scene.add_instance(mirrored, turned);
    }
    scene
}

#[test]
fn light_is_the_same_in_expectation() {
    let scene = room();
    let frame = rooms::frame(&scene, (8, 8), 192, Integrator::Path);
    let kept = Arc::new(PackedScene::pack(&scene).unwrap());
    let merged = Arc::new(PackedScene::pack_merged(&scene).unwrap());
    assert!(merged.is_merged());
    let [ours, theirs] = [&merged, &kept].map(|scene| radiance_of(scene, &frame, 2));
    check_same(&ours, &theirs, 0.1).unwrap();
    let mut brighter = PackedScene::clone(&kept);
    brighter.light_intensity *= 1.2;
    let brighter = radiance_of(&Arc::new(brighter), &frame, 2);
    check_same(&ours, &brighter, 0.1).unwrap_err();
}

/// The first grid of a scene as eight models that meet in the middle of the room, each with coordinates of its own; every second one may
/// be mirrored in its grid and back in the world. Further instances come after them.
fn in_eight(whole: &Scene, has_mirrored: bool) -> Scene {
    let grid = &whole.grids[whole.instances[0].grid];
    let bounds = grid.bounds().unwrap();
    let middle = (bounds.min + bounds.max) / 2 + IVec3::new(1, 0, 2);
    let mut scene = Scene { grids: vec![], instances: vec![], ..whole.clone() };
    for corner in 0..8 {
        let is_above = |voxel: IVec3| (0..3).fold(0, |at, axis| at | i32::from(voxel[axis] >= middle[axis]) << axis);
        let moved = IVec3::new(5 * corner, -3, 100);
        let is_mirrored = has_mirrored && corner % 2 == 1;
        let mut model = VoxelGrid::new();
        for (voxel, material) in grid.voxels().filter(|(voxel, _)| is_above(*voxel) == corner) {
            let own = voxel - moved;
            model.set(if is_mirrored { own.with_x(-1 - own.x) } else { own }, material);
        }
        let linear = Mat3::from_diagonal(Vec3::new(if is_mirrored { -1.0 } else { 1.0 }, 1.0, 1.0));
        scene.add_instance(model, Transform { linear, translation: moved.as_vec3() });
    }
    for instance in &whole.instances[1..] {
        scene.add_instance(whole.grids[instance.grid].as_ref().clone(), instance.world_from_grid);
    }
    scene
}

/// Pixels of two films that are not the same, bit for bit.
fn differing(a: &Film, b: &Film) -> usize {
    a.pixels.iter().zip(&b.pixels).filter(|(a, b)| a != b).count()
}

#[test]
fn a_merged_scene_has_the_pictures_of_the_same_voxels_as_one_grid_bit_for_bit() {
    let device = device();
    for (whole, has_mirrored, integrator) in [
        (rooms::open_plain(), false, Integrator::Essay),
        (rooms::open_plain(), true, Integrator::Essay),
        (rooms::open_plain(), false, Integrator::Path),
        (rooms::lamp_room(), true, Integrator::Path),
    ] {
        let models = in_eight(&whole, has_mirrored);
        let [one, kept] = [&whole, &models].map(|scene| Arc::new(PackedScene::pack(scene).unwrap()));
        let merged = Arc::new(PackedScene::pack_merged(&models).unwrap());
        let (few, many) = (whole.instances.len(), whole.instances.len() + 7);
        assert_eq!((merged.instances().len(), merged.instance_count(), kept.instances().len()), (few, many, many));
        let frame = rooms::frame(&whole, (32, 24), 8, integrator);
        let [of_one, of_kept, of_merged] = [&one, &kept, &merged].map(|scene| render(scene, &frame));
        assert!(of_merged.pixels == of_one.pixels, "{integrator:?}");
        let other = differing(&of_merged, &render(&one, &frame.clone().seed(2)));
        assert!(other > 300, "the comparison sees another seed: {other}");
        // With instances kept, light scatters in the frame of each, a lamp is chosen by its instance first, and rays are rounded to the space
        // of each: in a scene without lamps and mirrors the last may count, and here did not.
        let differ = differing(&of_merged, &of_kept);
        assert_eq!(differ > 8, has_mirrored, "{differ} pixels, {integrator:?}");
        let Some(device) = &device else { continue };
        for_each_tracer(device, &film_methods(device, &ONE_OF_EACH), &merged, |tracer, traversal, primitive| {
            assert!(film(tracer, &frame).pixels == of_one.pixels, "{integrator:?} {traversal:?} {primitive:?}");
        });
    }
    device.iter().for_each(|device| assert_valid(device));
}

#[test]
fn lines_are_drawn_on_instances_that_are_kept_apart_alone() {
    let whole = rooms::lamp_room();
    let models = in_eight(&whole, true);
    let [one, kept] = [&whole, &models].map(|scene| Arc::new(PackedScene::pack(scene).unwrap()));
    let merged = Arc::new(PackedScene::pack_merged(&models).unwrap());
    let line = Line { width: 0.3, color: Vec3::X };
    let with_edges = Lines { edges: Some(line), grid: None };
    let with_grid = Lines { edges: None, grid: Some(GridLines { line, spacing: 7 }) };
    let device = device();
    for lines in [with_edges, with_grid] {
        let frame = rooms::frame(&whole, (32, 24), 2, Integrator::Path).lines(lines);
        let split = Arc::new(merged.split());
        assert!(render(&split, &frame).pixels == render(&kept, &frame).pixels);
        // What a merged grid would show: edges of models and the origins of their grids are elsewhere.
        let albedos = |scene| render(scene, &frame.clone().aovs(true)).aovs.unwrap();
        let differ = albedos(&one).iter().zip(&albedos(&kept)).filter(|(a, b)| a.albedo != b.albedo).count();
        assert!(differ > 20, "{differ}");
        let refuses = |tracer: &mut dyn Tracer| {
            tracer.set_scene(&merged).unwrap();
            let refused = tracer.render(&frame, &Progress::default());
            assert!(
                matches!(&refused, Err(TraceError::BadFrame(reason)) if reason.contains("kept apart")),
                "{refused:?}"
            );
            tracer.render(&frame.clone().lines(Lines::default()), &Progress::default()).unwrap();
            tracer.set_scene(&split).unwrap();
            tracer.render(&frame, &Progress::default()).unwrap();
        };
        refuses(&mut CpuTracer::new(None));
        // One kind is enough where shaders take long to compile.
        let Some(device) = device.as_ref().filter(|_| lines == with_edges) else { continue };
        let methods = film_methods(device, &ONE_OF_EACH);
        for_each_tracer(device, &methods[..1], &split, |tracer, _, _| refuses(tracer));
    }
}

#[test]
fn aovs_are_of_the_instances() {
    let scene = models(9, 7);
    let camera = Camera::look_at(Vec3::new(90.3, -70.7, 55.1), Vec3::ZERO);
    let frame = Frame::new(camera, 96, 64).samples(1).aovs(true);
    let of = |packed: PackedScene| {
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(&Arc::new(packed)).unwrap();
        film(&mut tracer, &frame).aovs.unwrap()
    };
    let (merged, kept) = (of(PackedScene::pack_merged(&scene).unwrap()), of(PackedScene::pack(&scene).unwrap()));
    let whose = |aovs: &[voxtrace::film::AovPixel]| aovs.iter().map(|of| (of.instance, of.voxel)).collect::<Vec<_>>();
    let differ = whose(&merged).iter().zip(&whose(&kept)).filter(|(a, b)| a != b).count();
    assert!(differ <= 6, "{differ} pixels differ");
    let met: std::collections::BTreeSet<u32> = merged.iter().map(|of| of.instance).collect();
    assert!(met.len() > 4, "{met:?}");
    let mut other = scene.clone();
    other.instances.swap(0, 1);
    assert_ne!(whose(&of(PackedScene::pack_merged(&other).unwrap())), whose(&merged));
}
