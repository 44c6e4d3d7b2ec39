//! Things that move: a placement that is set gives the film of the scene packed anew, bit for bit, on every tracer, and
//! nothing but the placement is written.

use std::collections::BTreeSet;
use std::sync::Arc;
use voxtrace::glam::{Mat3, Vec3};
use voxtrace::packed::{PackedInstance, PlacementError};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Instance, Integrator, PackedScene, Placement, Progress, Region, Scene, TraceError,
    Tracer, Transform, VoxelGrid,
};
use voxtrace_test_support::skip;
use voxtrace_tests::gpu::{assert_valid, device};
use voxtrace_tests::moving::moving;
use voxtrace_tests::rooms;
use voxtrace_vulkan::{MemoryReport, Primitive, Settings, Traversal, VulkanTracer, missing};

const INSTANCES: usize = 1000;
const FRAMES: u32 = 10;

/// Ten frames in which a thousand things move, then one with half of them, one where only the floor is left, and one where
/// only a lamp is, which stands where its grid is.
fn frames() -> Vec<Scene> {
    let mut frames: Vec<Scene> = (0..FRAMES).map(|frame| moving(INSTANCES, frame)).collect();
    for left in [INSTANCES / 2, 1] {
        let mut scene = moving(INSTANCES, 3);
        scene.instances[left..].iter_mut().for_each(|instance| instance.hidden = true);
        frames.push(scene);
    }
    let mut scene = frames[0].clone();
    scene.instances.iter_mut().for_each(|instance| instance.hidden = true);
    let lamp = scene.instances.iter_mut().find(|instance| instance.grid == 3).unwrap();
    (lamp.hidden, lamp.world_from_grid) = (false, Transform::IDENTITY);
    scene.cameras = vec![Camera::look_at(Vec3::new(5.0, -7.0, -4.0), Vec3::new(0.5, 0.5, 0.0))];
    frames.push(scene);
    frames
}

fn frame_of(scene: &Scene) -> Frame {
    rooms::frame(scene, (30, 17), 1, Integrator::Path)
}

fn render(tracer: &mut dyn Tracer, frame: &Frame) -> Film {
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    film
}

/// The film of a scene that is packed anew.
fn packed_anew(scene: &Scene) -> Film {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&Arc::new(PackedScene::pack(scene).unwrap())).unwrap();
    render(&mut tracer, &frame_of(scene))
}

/// Moves things through all frames on `tracer`, which may look at itself after each.
fn check_moves<T: Tracer>(tracer: &mut T, mut after: impl FnMut(&T, u32)) {
    let frames = frames();
    let first = Arc::new(PackedScene::pack(&frames[0]).unwrap());
    tracer.set_scene(&first).unwrap();
    let mut stale: Option<(Placement, Film)> = None;
    for (index, scene) in frames.iter().enumerate() {
        // From the frame before, or from nothing.
        let placement = match &stale {
            Some((before, _)) if index % 3 > 0 => before.moved_to_scene(first.geometry(), scene),
            _ => Placement::of_scene(first.geometry(), scene),
        };
        let placement = placement.unwrap();
        tracer.set_placement(&placement).unwrap();
        let (film, expected) = (render(tracer, &frame_of(scene)), packed_anew(scene));
        assert!(film == expected, "frame {index}");
        // A placement of the frame before is seen.
        if let Some((before, film_before)) = &stale {
            assert!(*film_before != expected, "frame {index} is another picture");
            if index % 4 == 1 {
                tracer.set_placement(before).unwrap();
                assert!(render(tracer, &frame_of(scene)) != expected, "frame {index} with a stale placement");
            }
        }
        stale = Some((placement, film));
        after(tracer, index as u32);
    }
}

#[test]
fn a_moved_scene_is_the_scene_packed_anew() {
    let frames = frames();
    let first = PackedScene::pack(&frames[0]).unwrap();
    let mut last: Option<Placement> = None;
    for scene in &frames {
        let placement = Placement::of_scene(first.geometry(), scene).unwrap();
        placement.validate(first.geometry()).unwrap();
        let anew = PackedScene::pack(scene).unwrap();
        let is_same = |placement: &Placement| {
            let nodes = placement.instance_nodes() == anew.placement().instance_nodes();
            if anew.grids().len() < first.grids().len() {
                // Grids that nobody shows any more are left out of what is packed anew, and the numbers of others change.
                let places = |instances: &[PackedInstance]| -> Vec<_> {
                    instances.iter().map(|instance| (instance.world_from_grid, instance.scene_instance)).collect()
                };
                return nodes && places(placement.instances()) == places(anew.instances());
            }
            let lights = placement.light_nodes() == anew.placement().light_nodes();
            nodes && lights && placement.instances() == anew.instances()
        };
        assert!(is_same(&placement));
        assert!(last.is_none_or(|last| !is_same(&last)), "the placement before is another");
        assert_eq!(first.with_placement(&placement).unwrap().instances(), placement.instances());
        last = Some(placement);
    }
}

#[test]
fn moving_on_the_cpu_renders_what_packing_anew_does() {
    check_moves(&mut CpuTracer::new(None), |_, _| {});
}

/// Names of what was uploaded since `before`, but the rays and films of the test itself.
fn written(before: &MemoryReport, now: &MemoryReport) -> BTreeSet<String> {
    let grew = |(name, bytes): (&String, &u64)| (before.uploaded.get(name) != Some(bytes)).then(|| name.clone());
    now.uploaded.iter().filter_map(grew).collect()
}

fn check_moves_on_device(traversal: Traversal, primitive: Primitive) {
    let Some(device) = device() else { return };
    if let Some(reason) = missing(device.info(), traversal) {
        skip(&format!("{} has no {}: {reason}", device.info().name, traversal.name()));
        return;
    }
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings { traversal, primitive, is_exact: true }).unwrap();
    let mut allowed = BTreeSet::from(["instances", "instance nodes", "top light nodes"].map(String::from));
    if traversal != Traversal::Walk {
        allowed.insert("top level input".into());
    }
    // What entries stand for changes where others are to be seen.
    let entries = String::from("top level entries");
    let mut last: Option<MemoryReport> = None;
    check_moves(&mut tracer, |tracer, index| {
        let now = tracer.memory();
        if let Some(before) = &last {
            let mut written = written(before, &now);
            let has_entries = written.remove(&entries);
            assert!(
                written.is_subset(&allowed) && (index >= FRAMES || (written == allowed && !has_entries)),
                "frame {index}: {written:?}"
            );
            // Nothing grows where as many things move.
            let is_steady = before.entries == now.entries;
            assert!(is_steady || index >= FRAMES, "frame {index}: {:?} {:?}", before.entries, now.entries);
        }
        last = Some(now);
    });
    // Setting the scene anew writes its geometry, and the count sees that.
    let before = tracer.memory();
    tracer.set_scene(&Arc::new(PackedScene::pack(&moving(INSTANCES, 0)).unwrap())).unwrap();
    let all = written(&before, &tracer.memory());
    assert!(["cells", "bricks", "emitters", "light nodes"].iter().all(|&name| all.contains(name)), "{all:?}");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn moving_with_the_compute_walk_renders_what_packing_anew_does() {
    check_moves_on_device(Traversal::Walk, Primitive::default());
}

#[test]
fn moving_with_queries_renders_what_packing_anew_does() {
    check_moves_on_device(Traversal::Query, Primitive::Grid);
}

#[test]
fn moving_with_a_pipeline_renders_what_packing_anew_does() {
    check_moves_on_device(Traversal::Pipeline, Primitive::Brick);
}

#[test]
fn what_cannot_be_placed_is_said() {
    let mut scene = moving(20, 0);
    scene.instances.iter_mut().filter(|instance| instance.grid == 2).for_each(|instance| instance.hidden = true);
    scene.grids.push(Arc::new(VoxelGrid::new()));
    let packed = PackedScene::pack(&scene).unwrap();
    let geometry = packed.geometry();
    assert_eq!(geometry.grids().len(), 3);
    // An empty grid is nothing to see, and hides no error.
    scene.instances.push(Instance::new(4, Transform::IDENTITY));
    let placed = Placement::of_scene(geometry, &scene).unwrap();
    assert_eq!(placed.instances(), packed.instances());

    let shown = Scene { instances: vec![Instance::new(2, Transform::IDENTITY)], ..scene.clone() };
    let missing = Placement::of_scene(geometry, &shown).unwrap_err();
    assert_eq!(missing, PlacementError::NotPacked { instance: 0, grid: 2 });
    let beyond = Scene { instances: vec![Instance::new(5, Transform::IDENTITY)], ..scene.clone() };
    let missing = Placement::of_scene(geometry, &beyond).unwrap_err();
    assert_eq!(missing, PlacementError::MissingGrid { instance: 0, grid: 5, count: 5 });
    let sound = PackedInstance::new(2, Transform::IDENTITY, 0);
    let missing = Placement::new(geometry, [sound, PackedInstance { grid: 3, ..sound }]).unwrap_err();
    assert_eq!(missing, PlacementError::MissingGrid { instance: 1, grid: 3, count: 3 });
    let sheared = Transform { linear: Mat3::from_diagonal(Vec3::new(1.0, 2.0, 1.0)), translation: Vec3::ZERO };
    let bad = PackedInstance::new(0, sheared, 0);
    assert_eq!(Placement::new(geometry, [bad]).unwrap_err(), PlacementError::BadTransform(0));
    scene.instances[2].world_from_grid.translation.x = f32::NAN;
    assert_eq!(Placement::of_scene(geometry, &scene).unwrap_err(), PlacementError::BadTransform(2));
}

#[test]
fn a_placement_of_another_geometry_is_refused_and_changes_nothing() {
    let scene = moving(20, 0);
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let mut other = scene.clone();
    other.grids[1] = Arc::new(other.grids[2].as_ref().clone());
    let other = PackedScene::pack(&other).unwrap();
    let mut tracer = CpuTracer::new(None);
    assert_eq!(tracer.set_placement(packed.placement()), Err(TraceError::NoScene));
    tracer.set_scene(&packed).unwrap();
    let film = render(&mut tracer, &frame_of(&scene));
    let refused = TraceError::Placement(PlacementError::OtherGeometry);
    assert_eq!(tracer.set_placement(other.placement()), Err(refused.clone()));
    let mut kept = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut kept).unwrap();
    assert!(kept == film, "the film is still there");
    // One that is accepted forgets the film.
    tracer.set_placement(packed.placement()).unwrap();
    assert_eq!(tracer.read(&mut kept), Err(TraceError::NoFilm));
    let Some(device) = device() else { return };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    assert_eq!(tracer.set_placement(packed.placement()), Err(TraceError::NoScene));
    tracer.set_scene(&packed).unwrap();
    assert_eq!(tracer.set_placement(other.placement()), Err(refused));
    assert!(render(&mut tracer, &frame_of(&scene)) == film);
    tracer.set_placement(packed.placement()).unwrap();
    assert_eq!(tracer.read(&mut kept), Err(TraceError::NoFilm));
}
