//! What every built-in scene must be: of the promised size, coloured like a scan, closed where it is a room, the same
//! on any number of threads.

use super::*;
use glam::IVec3;
use rustc_hash::FxHashSet;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use voxtrace_scene::ray::FACES;
use voxtrace_scene::scene::Unit;

/// Scenes that are rooms.
const ENCLOSED: [&str; 2] = ["church", "operating-room"];

fn off_by(count: u64, wanted: u64) -> f64 {
    (count as f64 / wanted as f64 - 1.0).abs()
}

/// Distinct materials in the mean brick.
fn mean_materials_of_a_brick(scene: &Scene) -> f64 {
    let bricks = scene.grids[0].sorted_bricks();
    let distinct = |brick: &voxtrace_scene::Brick| FxHashSet::from_iter(brick.materials().iter().copied()).len();
    bricks.iter().map(|(_, brick)| distinct(brick)).sum::<usize>() as f64 / bricks.len() as f64
}

#[test]
fn default_scenes_have_the_studys_count_and_the_colours_of_a_scan() {
    for name in STUDY_NAMES {
        let scene = generate(name, None).unwrap();
        let (count, wanted) = (scene.grids[0].count(), default_voxels(name).unwrap());
        assert!(off_by(count, wanted) < 0.005, "{name} has {count} voxels of {} m, not {wanted}", scene.voxel_size);
        let used = FxHashSet::from_iter(scene.grids[0].voxels().map(|(_, material)| material)).len();
        assert!(used >= 200, "{name} uses {used} materials");
        assert!(scene.materials.len() <= 255, "{name} has {} materials: .vox files hold 255", scene.materials.len());
        let mean = mean_materials_of_a_brick(&scene);
        assert!((12.0..18.0).contains(&mean), "the mean brick of {name} has {mean} materials");
        assert_eq!(scene.unit, Unit::Metre);
        assert!(scene.grids[0].bounds().unwrap().min.cmpge(IVec3::ZERO).all());
    }
}

#[test]
fn scenes_have_the_number_of_voxels_that_is_asked_for() {
    for name in STUDY_NAMES {
        for (wanted, tolerance) in [(20_000, 0.05), (300_000, 0.005), (2_000_000, 0.005)] {
            let count = generate(name, Some(wanted)).unwrap().grids[0].count();
            assert!(off_by(count, wanted) < tolerance, "{name} of {wanted} has {count}");
        }
    }
}

#[test]
fn a_sample_of_the_bricks_counts_a_large_scene() {
    for builtin in &BUILTINS {
        let voxel = builtin.voxel * 1.5;
        let model = (builtin.model)(voxel);
        let (all, sample) = (model.count(voxel, 1), model.count(voxel, 5));
        assert!(off_by(sample, all) < 0.02, "{}: {sample} for {all}", builtin.name);
    }
}

#[test]
fn threads_do_not_change_a_scene() {
    for name in STUDY_NAMES {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| generate(name, Some(200_000)).unwrap())
        };
        assert_eq!(on(1), on(3), "{name}");
    }
}

#[test]
fn cameras_stand_in_the_open_and_have_names_of_their_own() {
    for name in STUDY_NAMES {
        let scene = generate(name, Some(300_000)).unwrap();
        assert!(scene.cameras.len() >= 3);
        let names = FxHashSet::from_iter(scene.cameras.iter().map(|camera| camera.name.clone()));
        assert_eq!(names.len(), scene.cameras.len(), "{name}");
        for camera in &scene.cameras {
            let eye = camera.eye.floor().as_ivec3();
            let near = (0..27).map(|i| eye + IVec3::new(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
            assert!(near.into_iter().all(|at| scene.grids[0].get(at).is_none()), "{name}: {}", camera.name);
        }
    }
}

/// The voxels of a grid's bounds that are occupied or that a walk through faces of empty voxels reaches from `start`;
/// `None` if the walk leads outside.
fn flood(grid: &voxtrace_scene::VoxelGrid, start: IVec3) -> Option<impl Fn(IVec3) -> bool + use<>> {
    let bounds = grid.bounds().unwrap();
    let size = bounds.size();
    let index = move |at: IVec3| {
        let at = at - bounds.min;
        ((at.z * size.y + at.y) * size.x + at.x) as usize
    };
    let mut seen = vec![false; size.element_product() as usize];
    for (at, _) in grid.voxels() {
        seen[index(at)] = true;
    }
    let mut open = vec![start];
    while let Some(at) = open.pop() {
        for face in FACES {
            let next = at + face.normal();
            if !bounds.contains(next) {
                return None;
            }
            if !std::mem::replace(&mut seen[index(next)], true) {
                open.push(next);
            }
        }
    }
    Some(move |at| seen[index(at)])
}

#[test]
fn rooms_are_closed_and_every_camera_is_within() {
    for name in STUDY_NAMES.into_iter().filter(|name| ENCLOSED.contains(name)) {
        for voxels in [150_000, 500_000] {
            let mut scene = generate(name, Some(voxels)).unwrap();
            let eyes: Vec<IVec3> = scene.cameras.iter().map(|camera| camera.eye.floor().as_ivec3()).collect();
            let inside = flood(&scene.grids[0], eyes[0]).unwrap_or_else(|| panic!("{name} of {voxels} leaks"));
            assert!(eyes.iter().all(|&eye| inside(eye)), "{name} of {voxels}: a camera is shut in");
            // The check itself: a hole drilled through the floor is found.
            let mut at = eyes[0];
            let grid = std::sync::Arc::make_mut(&mut scene.grids[0]);
            while grid.bounds().unwrap().contains(at) {
                grid.clear(at);
                at.z -= 1;
            }
            assert!(flood(&scene.grids[0], eyes[0]).is_none(), "a planted hole in {name} goes unseen");
        }
    }
}

#[test]
fn a_scene_that_is_not_wanted_any_more_is_not_built_on() {
    let asked = AtomicU32::new(0);
    let until = |most: u32| {
        asked.store(0, Relaxed);
        generate_while("city", Some(30_000), &|| asked.fetch_add(1, Relaxed) < most)
    };
    let whole = until(u32::MAX).unwrap();
    let all = asked.load(Relaxed);
    assert!(all > 10, "it is asked in every tile: {all}");
    assert_eq!(whole, generate("city", Some(30_000)).unwrap());
    for most in [0, all - 1] {
        assert_eq!(until(most), Err(SceneError::Stopped), "{most}");
    }
}

#[test]
fn what_cannot_be_generated_is_refused_by_name_or_number() {
    let error = generate("cathedral", None).unwrap_err();
    assert_eq!(error, SceneError::UnknownName("cathedral".into()));
    assert!(error.to_string().contains("church"));
    for voxels in [0, MIN_VOXELS - 1, MAX_VOXELS + 1] {
        assert_eq!(generate("church", Some(voxels)), Err(SceneError::VoxelCount(voxels)));
    }
}
