use super::*;
use glam::{Quat, Vec3};
use std::collections::BTreeSet;
use voxtrace_scene::Material;
use voxtrace_scene::transform::Axis;

fn materials() -> Vec<Material> {
    (0..8).map(|shade| Material::diffuse(Vec3::splat(shade as f32 / 8.0))).collect()
}

/// A box of voxels, each of whose materials tells its place.
fn block(size: IVec3) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for i in 0..size.element_product() {
        let voxel = IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y));
        grid.set(voxel, (voxel.element_sum() % 8) as u16);
    }
    grid
}

fn turned(degrees: f32, about: Vec3) -> Transform {
    Transform::from_rotation(Quat::from_axis_angle(about.normalize(), degrees.to_radians()))
}

/// The world's voxels whose centre lies in a voxel of the grid, found by asking every one.
fn by_centres(grid: &VoxelGrid, placed: &Transform, reach: i32) -> Vec<(IVec3, u16)> {
    let inverse = placed.linear.as_dmat3().inverse();
    let mut found = Vec::new();
    for i in 0..(2 * reach).pow(3) {
        let edge = 2 * reach;
        let voxel = IVec3::new(i % edge, i / edge % edge, i / (edge * edge)) - reach;
        let inside = inverse * (voxel.as_dvec3() + 0.5 - placed.translation.as_dvec3());
        found.extend(grid.get(inside.floor().as_ivec3()).map(|material| (voxel, material)));
    }
    found.sort_by_key(|(voxel, _)| voxel.to_array());
    found
}

fn world_voxels(scene: &Scene) -> Vec<(IVec3, u16)> {
    let (grid, corner) = flattened(scene).unwrap();
    let mut found: Vec<_> = grid.voxels().map(|(voxel, material)| (voxel + corner, material)).collect();
    found.sort_by_key(|(voxel, _)| voxel.to_array());
    found
}

#[test]
fn a_turned_instance_has_the_voxels_whose_centres_it_covers() {
    let grid = block(IVec3::new(19, 9, 13));
    for (degrees, about, scale) in
        [(35.0, Vec3::Z, 1.0), (-80.0, Vec3::new(1.0, 2.0, 3.0), 1.0), (10.0, Vec3::X, 1.5), (0.0, Vec3::Z, 2.0)]
    {
        let placed = turned(degrees, about).scaled(scale).translated(Vec3::new(0.3, -2.7, 1.1));
        let mut scene = Scene::from_grid("turned", grid.clone(), materials());
        scene.instances[0].world_from_grid = placed;
        let wanted = by_centres(&grid, &placed, 48);
        let baked = bake(&mut scene, &Limits::default()).unwrap();
        assert_eq!((baked, scene.grids.len()), (Baked { instances: 1, stilled: 0 }, 1));
        let found = world_voxels(&scene);
        assert!(found == wanted, "{degrees} about {about}: {} voxels, not {}", found.len(), wanted.len());
        // About as many as the box is large.
        let volume = grid.count() as f64 * f64::from(scale).powi(3);
        assert!((found.len() as f64 / volume - 1.0).abs() < 0.03, "{} of {volume}", found.len());
        // One degree more is another solid.
        assert_ne!(found, by_centres(&grid, &turned(1.0, Vec3::ONE).after(&placed), 48));
    }
}

#[test]
fn what_stands_on_the_lattice_stays_as_it_is() {
    let mut scene = Scene::from_grid("still", block(IVec3::new(5, 6, 7)), materials());
    scene.instances[0].world_from_grid =
        Transform::from_quarter_turns(Axis::Y, 3).translated(Vec3::new(7.0, -3.0, 12.0));
    let before = scene.clone();
    assert_eq!(bake(&mut scene, &Limits::default()), Ok(Baked::default()));
    assert_eq!(scene, before);
    scene.instances[0].world_from_grid.translation.x += 0.5;
    assert_eq!(bake(&mut scene, &Limits::default()).unwrap().instances, 1);
}

/// Whether a path through faces leads from the one side of a plane of voxels to the other.
fn is_passed(grid: &VoxelGrid, reach: i32, side: impl Fn(IVec3) -> f32) -> bool {
    let is_inside = |voxel: IVec3| voxel.abs().max_element() < reach;
    let start = (-reach + 1..reach)
        .flat_map(|x| (-reach + 1..reach).map(move |y| IVec3::new(x, y, 1 - reach)))
        .find(|&voxel| side(voxel) < -4.0 && grid.get(voxel).is_none())
        .unwrap();
    let (mut seen, mut next) = (BTreeSet::from([start.to_array()]), vec![start]);
    while let Some(voxel) = next.pop() {
        if side(voxel) > 4.0 {
            return true;
        }
        for step in [IVec3::X, IVec3::NEG_X, IVec3::Y, IVec3::NEG_Y, IVec3::Z, IVec3::NEG_Z] {
            let beside = voxel + step;
            if is_inside(beside) && grid.get(beside).is_none() && seen.insert(beside.to_array()) {
                next.push(beside);
            }
        }
    }
    false
}

#[test]
fn a_wall_of_one_voxel_stays_closed_however_it_is_turned_and_scaled() {
    let mut wall = VoxelGrid::new();
    for i in 0..120 * 120 {
        wall.set(IVec3::new(i % 120 - 60, i / 120 - 60, 0), 1);
    }
    for degrees in [7.0, 22.5, 35.0, 45.0, 54.7, 71.0] {
        for (about, scale) in [(Vec3::X, 1.0), (Vec3::new(1.0, 1.0, 0.0), 1.0), (Vec3::new(3.0, 1.0, 2.0), 0.6)] {
            let placed = turned(degrees, about).scaled(scale).translated(Vec3::new(0.1, 0.2, 0.4));
            let mut scene = Scene::from_grid("wall", wall.clone(), materials());
            scene.instances[0].world_from_grid = placed;
            bake(&mut scene, &Limits::default()).unwrap();
            let (grid, corner) = flattened(&scene).unwrap();
            assert_eq!(corner, IVec3::ZERO);
            let normal = placed.direction(Vec3::Z).normalize();
            let side = |voxel: IVec3| (voxel.as_vec3() + 0.5 - placed.translation).dot(normal);
            assert!(!is_passed(&grid, 16, side), "{degrees} degrees about {about}, scale {scale}");
            // A hole of one voxel in it is found.
            let mut holed = grid.clone();
            let near = |voxel: &IVec3| side(*voxel).abs() < 2.5 && voxel.abs().max_element() < 3;
            grid.voxels().map(|(voxel, _)| voxel).filter(near).for_each(|voxel| {
                holed.clear(voxel);
            });
            assert!(is_passed(&holed, 16, side), "{degrees} degrees about {about}, scale {scale}");
        }
    }
}

#[test]
fn the_first_of_two_instances_keeps_a_voxel_that_both_have_and_hidden_ones_are_left_out() {
    let mut scene = Scene::new("two");
    scene.materials = materials();
    for (material, x) in [(1, 0.0), (2, 2.0), (3, -9.0)] {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::splat(4) }, material);
        scene.add_instance(grid, Transform::from_translation(Vec3::new(x, 0.0, 0.0)));
    }
    scene.instances[2].hidden = true;
    let before = world_voxels(&scene);
    flatten(&mut scene).unwrap();
    assert_eq!((scene.grids.len(), scene.instances.len()), (1, 1));
    assert_eq!(world_voxels(&scene), before);
    let grid = &scene.grids[0];
    assert_eq!(grid.count(), 96);
    let shades = [0, 3, 4, 5].map(|x| grid.get(IVec3::new(x, 1, 1)));
    assert_eq!(shades, [Some(1), Some(1), Some(2), Some(2)]);
    assert_eq!(grid.get(IVec3::new(-8, 1, 1)), None);
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_changed() {
    let mut scene = Scene::from_grid("large", block(IVec3::splat(10)), materials());
    scene.instances[0].name = "tower".into();
    scene.instances[0].world_from_grid = turned(35.0, Vec3::Z);
    let before = scene.clone();
    let off = BakeError::OffLattice { instance: 0, name: "tower".into() };
    assert_eq!(flattened(&scene).unwrap_err(), off);
    let limits = Limits { voxels: 999, ..Limits::default() };
    assert_eq!(bake(&mut scene, &limits), Err(BakeError::TooLarge { needed: 1000, limit: 999 }));
    scene.instances[0].world_from_grid = turned(35.0, Vec3::Z).scaled(1e5);
    let unlimited = Limits { voxels: u64::MAX, ..Limits::default() };
    assert_eq!(bake(&mut scene, &unlimited), Err(BakeError::TooFar));
    assert_eq!(scene.grids, before.grids);
    // Two that are too far apart for one grid, each of which is far from the origin, and a near one.
    let far = Transform::from_translation(Vec3::new(1_500_000.0, 0.0, 0.0));
    scene.instances[0].world_from_grid = far;
    let (grid, corner) = flattened(&scene).unwrap();
    assert_eq!((corner, grid.get(IVec3::new(1_500_004, 1, 1) - corner)), (IVec3::new(1_500_000, 0, 0), Some(6)));
    scene.add_instance(block(IVec3::ONE), Transform::IDENTITY);
    assert_eq!(flattened(&scene).unwrap_err(), BakeError::TooFar);
}

#[test]
fn what_moves_stands_still_as_in_its_first_frame() {
    use voxtrace_scene::scene::Keyframe;
    let mut scene = Scene::from_grid("moving", block(IVec3::splat(4)), materials());
    let key = |frame, world_from_grid| Keyframe::still(frame, 0, world_from_grid);
    scene.instances[0].keyframes = vec![key(0, Transform::IDENTITY), key(9, turned(20.0, Vec3::Z))];
    let before = world_voxels(&scene);
    assert_eq!(bake(&mut scene, &Limits::default()), Ok(Baked { instances: 1, stilled: 1 }));
    assert_eq!((world_voxels(&scene), scene.instances[0].keyframes.len()), (before, 0));
}
