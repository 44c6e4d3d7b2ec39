//! Tests of counting: against a search voxel by voxel over a plain set.

use super::*;
use std::collections::HashSet;
use voxtrace::cuts::Cuts;
use voxtrace::glam::Vec3;
use voxtrace::{Material, Ray, Scene, Transform, VoxelGrid};

/// Two bodies that touch along an edge alone, over many bricks, one with a hollow, and of two materials.
fn bodies() -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    let mut fill = |min: IVec3, max: IVec3, material: u16| {
        for x in min.x..max.x {
            for y in min.y..max.y {
                for z in min.z..max.z {
                    grid.set(IVec3::new(x, y, z), material);
                }
            }
        }
    };
    fill(IVec3::new(-11, -3, -20), IVec3::new(9, 14, 5), 0);
    fill(IVec3::new(9, 14, -20), IVec3::new(20, 20, 5), 0);
    fill(IVec3::new(-11, -3, 5), IVec3::new(-9, 30, 7), 1);
    for x in -5..3 {
        for z in -9..0 {
            grid.clear(IVec3::new(x, 4, z));
        }
    }
    grid
}

fn scene(grid: &VoxelGrid, place: Transform) -> PackedScene {
    let materials = vec![Material::diffuse(Vec3::ONE), Material::diffuse(Vec3::X)];
    let mut scene = Scene::from_grid("bodies", grid.clone(), materials);
    scene.instances[0].world_from_grid = place;
    PackedScene::pack(&scene).unwrap()
}

/// Voxels and open faces of what hangs together with a voxel, by a plain search.
fn searched(
    grid: &VoxelGrid,
    from: IVec3,
    material: Option<u16>,
    keeps: impl Fn(IVec3) -> bool,
) -> (u64, u64, IVec3, IVec3) {
    let is_there = |voxel: IVec3| grid.get(voxel).is_some() && keeps(voxel);
    let may = |voxel: IVec3| is_there(voxel) && material.is_none_or(|own| grid.get(voxel) == Some(own));
    let (mut seen, mut stack) = (HashSet::from([from]), vec![from]);
    let (mut faces, mut min, mut max) = (0, from, from);
    while let Some(voxel) = stack.pop() {
        (min, max) = (min.min(voxel), max.max(voxel));
        for step in SIDES {
            faces += u64::from(!is_there(voxel + step));
            if may(voxel + step) && seen.insert(voxel + step) {
                stack.push(voxel + step);
            }
        }
    }
    (seen.len() as u64, faces, min, max)
}

/// The voxel that a ray down from far above meets.
fn hit(scene: &PackedScene, x: f32, y: f32) -> Hit {
    scene.cast(&Ray::new(Vec3::new(x, y, 500.0), Vec3::NEG_Z)).unwrap()
}

fn counted(scene: &PackedScene, hit: &Hit, by_material: bool) -> Component {
    let (found, over) = (AtomicU64::new(0), AtomicBool::new(false));
    let component = component_of(scene, hit, by_material, &found, &over).unwrap();
    assert_eq!(found.into_inner(), component.voxels);
    component
}

#[test]
fn voxels_and_open_faces_are_those_of_a_search_voxel_by_voxel() {
    let grid = bodies();
    let packed = scene(&grid, Transform::IDENTITY);
    for (x, y) in [(0.5, 0.5), (12.5, 17.5), (-9.5, 25.5)] {
        for by_material in [false, true] {
            let hit = hit(&packed, x, y);
            let material = by_material.then(|| packed.material_index(&hit) as u16);
            let (voxels, faces, min, max) = searched(&grid, hit.voxel, material, |_| true);
            let found = counted(&packed, &hit, by_material);
            assert_eq!((found.voxels, found.exposed), (voxels, faces as f64), "{x} {y} {by_material}");
            assert_eq!((found.volume, found.corner), (voxels as f64, min.as_dvec3()));
            let size = DVec3::new(found.edges[0].x, found.edges[1].y, found.edges[2].z);
            assert_eq!(size, (max + 1 - min).as_dvec3());
        }
    }
    let mut joined = grid.clone();
    joined.set(IVec3::new(9, 13, 0), 0);
    let hit = hit(&packed, 0.5, 0.5);
    let (voxels, ..) = searched(&joined, hit.voxel, None, |_| true);
    assert_ne!(counted(&packed, &hit, false).voxels, voxels, "the comparison sees a voxel that joins both");
    assert_eq!(counted(&scene(&joined, Transform::IDENTITY), &hit, false).voxels, voxels);
}

#[test]
fn a_turned_and_scaled_object_has_the_volume_of_its_scale() {
    let place = Transform::from_quarter_turns(voxtrace::Axis::X, 1).scaled(0.5).translated(Vec3::new(3.0, 4.0, 5.0));
    let packed = scene(&bodies(), place);
    let hit = hit(&packed, 3.0, 10.0);
    let (voxels, faces, ..) = searched(&bodies(), hit.voxel, None, |_| true);
    let found = counted(&packed, &hit, false);
    assert_eq!((found.voxels, found.volume, found.exposed), (voxels, voxels as f64 / 8.0, faces as f64 / 4.0));
    let y = found.edges[1];
    assert!(y.x.abs() + y.y.abs() < 1e-5 && y.z > 1.0, "the grid's y is upwards here: {y}");
}

#[test]
fn what_a_cut_takes_away_counts_as_gone() {
    let grid = bodies();
    let mut packed = scene(&grid, Transform::IDENTITY);
    packed.cuts = Cuts::default().plane(Vec3::Z, -3.0).unwrap().plane(Vec3::X, 2.0).unwrap();
    let hit = hit(&packed, 0.5, 0.5);
    let (voxels, faces, ..) = searched(&grid, hit.voxel, None, |voxel| voxel.z < -3 && voxel.x < 2);
    let found = counted(&packed, &hit, false);
    assert_eq!((found.voxels, found.exposed), (voxels, faces as f64));
    packed.cuts = Cuts::default();
    assert_ne!(counted(&packed, &hit, false).voxels, voxels, "the comparison sees the cut");
}

#[test]
fn of_merged_objects_the_one_that_was_clicked_is_counted() {
    let mut grid = VoxelGrid::new();
    (0..64).for_each(|i| _ = grid.set(IVec3::new(i % 4, i / 4 % 4, i / 16), 0));
    let mut both = Scene::from_grid("two", grid.clone(), vec![Material::diffuse(Vec3::ONE)]);
    both.add_instance(grid, Transform::from_translation(Vec3::new(4.0, 0.0, 0.0)));
    let merged = PackedScene::pack_merged(&both).unwrap();
    assert!(merged.is_merged());
    let found = counted(&merged, &hit(&merged, 5.5, 1.5), false);
    assert_eq!((found.voxels, found.exposed, found.corner), (64, 96.0, DVec3::new(4.0, 0.0, 0.0)));
}

#[test]
fn counting_ends_when_it_is_told_to() {
    let packed = scene(&bodies(), Transform::IDENTITY);
    let hit = hit(&packed, 0.5, 0.5);
    let (found, over) = (AtomicU64::new(0), AtomicBool::new(true));
    assert!(component_of(&packed, &hit, false, &found, &over).unwrap_err().contains("stopped"));
    let flood = Flood::start(Arc::new(packed), hit, DVec3::ZERO, false);
    let start = std::time::Instant::now();
    let result = loop {
        if let Some(result) = flood.take() {
            break result;
        }
        assert!(start.elapsed().as_secs() < 60, "it does not end");
        std::thread::yield_now();
    };
    assert_eq!(result.unwrap().voxels, flood.found());
}
