//! A scene in which a thousand things move: crates and lamps of three grids that turn, are mirrored and scaled above a floor.

use crate::random::Random;
use crate::scenes::noise;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Instance, Material, Scene, Sky, Sun, Transform, VoxelGrid};

/// The scene in frame `frame`; grids and materials are the same in all frames.
pub fn moving(instances: usize, frame: u32) -> Scene {
    let materials = vec![
        Material::diffuse(Vec3::new(0.7, 0.6, 0.5)),
        Material::diffuse(Vec3::new(0.2, 0.4, 0.8)),
        Material::emissive(Vec3::new(9.0, 7.0, 4.0)),
    ];
    let mut floor = VoxelGrid::new();
    floor.fill_box(VoxelBox { min: IVec3::new(-60, -60, -3), max: IVec3::new(60, 60, 0) }, 0);
    let mut scene = Scene::from_grid("moving", floor, materials);
    let sun = Sun { direction: Vec3::new(0.3, -0.4, 0.8), angular_radius: 0.02, irradiance: Vec3::splat(0.6) };
    scene.sky = Sky::study(0.2).with_sun(sun);
    let grids = [noise(IVec3::splat(-2), 5, 0.8, 2, 1), noise(IVec3::splat(-1), 3, 0.7, 3, 2), lamp()];
    scene.grids.extend(grids.map(Into::into));
    let mut random = Random(7);
    for index in 1..instances {
        let (place, axis) =
            (random.point(Vec3::new(-55.0, -55.0, 4.0), Vec3::new(55.0, 55.0, 40.0)), random.direction());
        let (step, spin, size) = (random.direction() * 1.5, random.unit() - 0.5, 0.5 + random.unit());
        let turned = Mat3::from_axis_angle(axis, spin * frame as f32) * size;
        let linear = if index % 5 == 0 { turned * -1.0 } else { turned };
        let world_from_grid = Transform { linear, translation: place + step * frame as f32 };
        scene.instances.push(Instance::new(1 + index % 3, world_from_grid));
    }
    scene.cameras = vec![Camera::look_at(Vec3::new(70.0, -90.0, 60.0), Vec3::new(0.0, 0.0, 10.0))];
    scene
}

/// A pole with a glowing head of more emitters than one leaf of their tree holds.
fn lamp() -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(0, 0, -3), max: IVec3::new(1, 1, 0) }, 1);
    grid.fill_box(VoxelBox { min: IVec3::new(-1, -1, 0), max: IVec3::new(2, 2, 3) }, 2);
    grid
}
