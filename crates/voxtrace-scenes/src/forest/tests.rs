//! What the forest must be: of the number of instances that is asked for, the same on any number of threads, its things on the ground.

use crate::{MAX_INSTANCES, SceneError, generate, generate_forest_while};
use glam::{IVec3, Mat3, Vec3};
use rustc_hash::FxHashSet;
use voxtrace_scene::scene::{Instance, Scene};

fn forest(instances: u32) -> Scene {
    generate_forest_while(instances, &|| true).unwrap()
}

fn is_on_the_lattice(instance: &Instance) -> bool {
    let whole = |x: f32| x.fract() == 0.0;
    let linear = instance.world_from_grid.linear;
    linear.to_cols_array().into_iter().all(whole)
        && instance.world_from_grid.translation.to_array().into_iter().all(whole)
}

#[test]
fn a_forest_has_the_instances_asked_for_of_a_dozen_models_on_a_hillside() {
    for count in [1, 77, 78, 500, 12_345] {
        assert_eq!(forest(count).instances.len(), count as usize + 1, "the hillside is one more");
    }
    let scene = generate("forest", None).unwrap();
    assert_eq!((scene.instances.len(), scene.grids.len()), (10_001, 13));
    let used = FxHashSet::from_iter(scene.instances.iter().map(|instance| instance.grid));
    assert_eq!(used.len(), 13, "every model stands somewhere");
    assert!(scene.grids.iter().all(|grid| grid.count() > 20));
    assert!(scene.materials.len() <= 255);
    let share = |is: &dyn Fn(&Instance) -> bool| scene.instances.iter().filter(|i| is(i)).count() as f32 / 10_001.0;
    let mirrored = share(&|instance| instance.world_from_grid.linear.determinant() < 0.0);
    assert!((0.45..0.55).contains(&mirrored), "{mirrored} are mirrored");
    let aligned = share(&is_on_the_lattice);
    assert!((0.55..0.65).contains(&aligned), "{aligned} are on the lattice");
    assert!(scene.instances.iter().all(|instance| instance.world_from_grid.is_similarity()));
}

#[test]
fn threads_do_not_change_a_forest_and_another_number_does() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| forest(300))
    };
    let scene = on(1);
    assert_eq!(scene, on(3));
    assert_ne!(scene, forest(301));
}

#[test]
fn no_ray_falls_through_the_hillside() {
    let columns =
        |scene: &Scene| FxHashSet::from_iter(scene.grids[0].voxels().map(|(at, _)| (at.x, at.y))).len() as i32;
    let mut scene = forest(200);
    let size = scene.grids[0].bounds().unwrap().size();
    assert_eq!(columns(&scene), size.x * size.y);
    // Neighbouring columns overlap in height: no step between them is open.
    let grid = std::sync::Arc::make_mut(&mut scene.grids[0]);
    let bounds = grid.bounds().unwrap();
    let top = |grid: &voxtrace_scene::VoxelGrid, x, y| {
        (bounds.min.z..bounds.max.z).rev().find(|&z| grid.get(IVec3::new(x, y, z)).is_some())
    };
    for (x, y) in (0..60).flat_map(|x| (0..60).map(move |y| (x, y))) {
        let (here, next) = (top(grid, x, y).unwrap(), top(grid, x + 1, y).unwrap());
        let low = here.min(next);
        let high = IVec3::new(if here > next { x } else { x + 1 }, y, 0);
        assert!((low..=here.max(next)).all(|z| grid.get(high.with_z(z)).is_some()), "a gap at {x}, {y}");
    }
    // The check itself: a column taken out is noticed.
    for z in bounds.min.z..bounds.max.z {
        grid.clear(IVec3::new(40, 50, z));
    }
    assert_eq!(columns(&scene), size.x * size.y - 1);
}

#[test]
fn every_transform_is_of_a_turned_or_mirrored_model_and_cameras_have_names_of_their_own() {
    let scene = forest(2_000);
    assert_eq!(FxHashSet::from_iter(scene.cameras.iter().map(|camera| camera.name.clone())).len(), 3);
    let turns: FxHashSet<[i32; 9]> = scene
        .instances
        .iter()
        .filter(|i| is_on_the_lattice(i))
        .map(|instance| {
            let linear: Mat3 = instance.world_from_grid.linear;
            assert_eq!(linear * Vec3::Z, Vec3::Z, "upright");
            linear.to_cols_array().map(|value| value as i32)
        })
        .collect();
    assert_eq!(turns.len(), 8, "four quarter turns, mirrored or not");
}

#[test]
fn numbers_out_of_range_and_forests_that_nobody_wants_are_refused() {
    for count in [0, MAX_INSTANCES + 1] {
        assert_eq!(generate_forest_while(count, &|| true), Err(SceneError::InstanceCount(count)));
    }
    assert_eq!(generate("forest", Some(1_000_000)), Err(SceneError::NotOfVoxels));
    assert_eq!(generate_forest_while(40, &|| false), Err(SceneError::Stopped));
}
