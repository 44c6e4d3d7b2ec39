//! Rooms for tests of light transport: closed boxes with known radiance, and a furnished room lit by lamps.

use glam::{IVec3, Vec3};
use voxtrace::{Camera, Frame, Integrator, Material, Scene, Sky, Sun, Transform, VoxelGrid};

/// The shell, one voxel thick, of a box whose inside is the voxels `0..size`; `material_of` chooses by voxel.
pub fn shell(size: IVec3, material_of: impl Fn(IVec3) -> u16) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for z in -1..=size.z {
        for y in -1..=size.y {
            for x in -1..=size.x {
                let voxel = IVec3::new(x, y, z);
                if voxel.cmplt(IVec3::ZERO).any() || voxel.cmpge(size).any() {
                    grid.set(voxel, material_of(voxel));
                }
            }
        }
    }
    grid
}

/// A closed room of 24×20×16 voxels with red and green walls, a lamp under the ceiling, a block that stands on the
/// floor and, turned and enlarged, a second instance with a lamp of its own. No sky reaches the inside.
pub fn lamp_room() -> Scene {
    let size = IVec3::new(24, 20, 16);
    let mut room = shell(size, |voxel| match voxel.x {
        -1 => 1,
        24 => 2,
        _ => 0,
    });
    for y in 8..12 {
        for x in 10..14 {
            room.set(IVec3::new(x, y, 15), 3);
            for z in 0..6 {
                room.set(IVec3::new(x + 4, y + 3, z), 0);
            }
        }
    }
    let materials = vec![
        Material::diffuse(Vec3::splat(0.7)),
        Material::diffuse(Vec3::new(0.7, 0.2, 0.1)),
        Material::diffuse(Vec3::new(0.1, 0.6, 0.2)),
        Material::emissive(Vec3::new(9.0, 8.0, 6.0)),
        Material::emissive(Vec3::new(2.0, 3.0, 9.0)),
    ];
    let mut scene = Scene { sky: Sky::black(), ..Scene::from_grid("lamp room", room, materials) };
    let mut block = VoxelGrid::new();
    for z in 0..3 {
        block.set(IVec3::new(0, 0, z), if z == 1 { 4 } else { 0 });
        block.set(IVec3::new(1, 0, z), 0);
    }
    let turned = glam::Mat3::from_axis_angle(Vec3::new(1.0, 2.0, 2.0) / 3.0, 0.7) * 1.5;
    scene.add_instance(block, Transform { linear: turned, translation: Vec3::new(5.0, 6.0, 4.0) });
    scene
        .cameras
        .push(Camera { fov_y: 80.0, ..Camera::look_at(Vec3::new(12.0, 1.0, 8.0), Vec3::new(12.0, 12.0, 7.0)) });
    scene
}

/// A few blocks on a plain, under the study's sky and a low sun.
pub fn open_plain() -> Scene {
    let mut grid = VoxelGrid::new();
    for y in 0..40 {
        for x in 0..40 {
            grid.set(IVec3::new(x, y, 0), 0);
            if (x / 6 + y / 6) % 3 == 0 {
                (1..1 + (x / 6 * 5 + y / 6 * 3) % 9).for_each(|z| _ = grid.set(IVec3::new(x, y, z), 1));
            }
        }
    }
    let materials = vec![Material::diffuse(Vec3::splat(0.5)), Material::diffuse(Vec3::new(0.6, 0.5, 0.3))];
    let mut scene = Scene::from_grid("open plain", grid, materials);
    let direction = Vec3::new(0.6, -0.3, 0.5).normalize();
    scene.sky.set_sun(Sun { direction, angular_radius: 0.03, irradiance: Vec3::new(3.0, 2.8, 2.4) });
    scene.cameras.push(Camera::look_at(Vec3::new(-20.0, -25.0, 30.0), Vec3::new(20.0, 20.0, 2.0)));
    scene
}

/// A frame of the scene's first camera.
pub fn frame(scene: &Scene, size: (u32, u32), samples: u32, integrator: Integrator) -> Frame {
    Frame::new(scene.cameras[0].clone(), size.0, size.1).samples(samples).seed(1).max_bounces(3).integrator(integrator)
}
