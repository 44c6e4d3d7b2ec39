//! The church: a Gothic parish church seen from within. A nave of six bays between arcades, two vaulted aisles, a
//! chancel of two bays with a great east window, an organ over the west door. x runs to the south aisle, y to the
//! east, z up; metres; the floor of the nave is z = 0.

mod chancel;
mod fabric;
mod furniture;
mod glass;
mod lights;
mod organ;
mod paints;
mod piers;
mod vaults;
mod windows;

use super::kit::*;
use glam::{Vec3, vec3};
use voxtrace_scene::camera::Camera;
use voxtrace_scene::sky::Sky;

/// Length of a bay of the nave.
const BAY: f32 = 4.4;
/// Bays of the nave.
const BAYS: u32 = 6;
/// East end of the nave.
const NAVE_END: f32 = BAY * BAYS as f32;
/// West end of the chancel, behind the chancel arch.
const CHANCEL: f32 = NAVE_END + 0.7;
/// Length of a bay of the chancel, which has two.
const CHANCEL_BAY: f32 = 4.6;
/// Inner face of the east wall.
const EAST: f32 = CHANCEL + 2.0 * CHANCEL_BAY;
/// From the middle of the nave to the arcade wall.
const HALF_NAVE: f32 = 3.3;
/// From the middle of the nave to the aisle's face of the arcade wall.
const AISLE_INNER: f32 = 3.95;
/// From the middle of the nave to the outer wall.
const AISLE_OUTER: f32 = 6.908;
/// Where the arcade's arches and the aisle vaults spring.
const AISLE_SPRING: f32 = 4.3;
/// Where the vaults of nave and chancel spring.
const NAVE_SPRING: f32 = 8.6;
/// Height of the nave's vault above its springing.
const NAVE_RISE: f32 = 4.6;
/// Height of the aisle vaults above their springing.
const AISLE_RISE: f32 = 2.6;
/// Floor of the chancel.
const CHANCEL_FLOOR: f32 = 0.48;
/// Floor around the altar.
const SANCTUARY_FLOOR: f32 = 0.96;

/// The church at a voxel size in metres.
pub fn model(voxel: f32) -> Model {
    let (paints, palette) = paints::Paints::new(voxel);
    let solid = union([
        fabric::fabric(&paints),
        piers::arcades(&paints),
        vaults::ribs(&paints),
        furniture::pews(&paints),
        furniture::pulpit_and_lectern(&paints),
        furniture::monuments(&paints),
        chancel::chancel(&paints, voxel),
        organ::organ(&paints),
        lights::lights(&paints, voxel),
    ]);
    Model {
        solid,
        paint: paints.ashlar,
        palette,
        min: vec3(-7.6, -0.8, -0.2),
        max: vec3(7.6, EAST + 0.8, NAVE_SPRING + NAVE_RISE + 0.3),
        cameras: vec![
            camera("nave", vec3(0.12, 2.7, 1.95), vec3(0.0, 30.0, 5.2), 50.0),
            camera("altar", vec3(-0.7, 27.6, 2.2), vec3(0.05, 36.0, 3.9), 58.0),
            camera("aisle", vec3(4.9, 1.2, 1.75), vec3(5.6, 20.0, 3.1), 56.0),
            camera("organ", vec3(-0.15, 21.9, 1.95), vec3(0.0, 2.0, 5.6), 48.0),
            camera("vault", vec3(0.0, 9.0, 1.6), vec3(0.0, 15.5, 9.0), 75.0),
        ],
        sky: Sky::black(),
        light_intensity: 1.25,
    }
}

fn camera(name: &str, eye: Vec3, target: Vec3, fov_y: f32) -> Camera {
    Camera { name: name.into(), fov_y, ..Camera::look_at(eye, target) }
}
