//! Views that fill the picture with the whole scene: that of a scene that brings no camera, three quarters from the front and above, and from
//! any other direction.

use crate::PackedScene;
use glam::Vec3;
use voxtrace_scene::Camera;

/// Direction from the middle of the scene towards the camera: in front (−y), to the right and above.
pub(crate) const TOWARDS_CAMERA: Vec3 = Vec3::new(0.62, -1.0, 0.55);
pub(crate) const FOV_Y: f32 = 35.0;
/// Empty border, as a share of the picture's half width and height.
const MARGIN: f32 = 0.03;

impl PackedScene {
    /// A camera that sees everything in pictures of `aspect` = width / height.
    pub fn overview(&self, aspect: f32) -> Camera {
        self.overview_from(TOWARDS_CAMERA, aspect)
    }

    /// A camera that sees everything from the direction `towards_camera`, which is not zero, in pictures of `aspect` = width / height. Up is z, from
    /// straight above y and from straight below −y, as in the window.
    pub fn overview_from(&self, towards_camera: Vec3, aspect: f32) -> Camera {
        let (min, max) = self.bounds().unwrap_or((Vec3::ZERO, Vec3::ONE));
        around(min, max, towards_camera, aspect)
    }
}

/// Which way is up where one looks from the direction `towards_camera`: z, but from straight above y and from straight below −y.
pub(crate) fn world_up(towards_camera: Vec3) -> Vec3 {
    let z = towards_camera.normalize().z;
    if z.abs() < 0.999 { Vec3::Z } else { Vec3::Y * z.signum() }
}

/// The camera that sees the whole box `min` to `max`.
fn around(min: Vec3, max: Vec3, towards_camera: Vec3, aspect: f32) -> Camera {
    let middle = (min + max) * 0.5;
    let forward = -towards_camera.normalize();
    let world_up = world_up(towards_camera);
    let right = forward.cross(world_up).normalize();
    let up = right.cross(forward);
    let tan_y = (FOV_Y.to_radians() * 0.5).tan() * (1.0 - MARGIN);
    let tan_x = tan_y * aspect;
    // Each corner asks for a distance at which it is just inside; the largest one suits all.
    let distance = (0..8).map(|corner| {
        let pick = |bit: u32, axis: usize| if corner >> bit & 1 == 1 { max[axis] } else { min[axis] };
        let offset = Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2)) - middle;
        let sideways = (offset.dot(right).abs() / tan_x).max(offset.dot(up).abs() / tan_y);
        sideways - offset.dot(forward)
    });
    let distance = distance.fold(1.0, f32::max);
    Camera { fov_y: FOV_Y, up: world_up, ..Camera::look_at(middle - forward * distance, middle) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest distance of a corner from the middle of the picture, as a share of its half width or height.
    fn reach(min: Vec3, max: Vec3, aspect: f32, camera: &Camera) -> f32 {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let up = right.cross(forward);
        let tan_y = (camera.fov_y.to_radians() * 0.5).tan();
        let corners = (0..8).map(|corner| {
            let pick = |bit: u32, axis: usize| if corner >> bit & 1 == 1 { max[axis] } else { min[axis] };
            let offset = Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2)) - camera.eye;
            let depth = offset.dot(forward);
            assert!(depth > 0.0, "a corner lies behind the camera");
            (offset.dot(right) / depth / tan_y / aspect).abs().max((offset.dot(up) / depth / tan_y).abs())
        });
        corners.fold(0.0, f32::max)
    }

    #[test]
    fn every_box_fills_the_picture_without_leaving_it() {
        let boxes = [
            (Vec3::ZERO, Vec3::ONE),
            (Vec3::new(-500.0, -1.0, 0.0), Vec3::new(500.0, 1.0, 2.0)),
            (Vec3::new(0.0, 0.0, 0.0), Vec3::new(3.0, 2000.0, 5.0)),
            (Vec3::new(10.0, 10.0, -300.0), Vec3::new(12.0, 12.0, 300.0)),
        ];
        let directions = [TOWARDS_CAMERA, Vec3::NEG_Y, Vec3::Y, Vec3::NEG_X, Vec3::X, Vec3::Z, Vec3::NEG_Z];
        for ((min, max), towards_camera) in boxes.into_iter().flat_map(|each| directions.map(|to| (each, to))) {
            for aspect in [16.0 / 9.0, 1.0, 0.5] {
                let camera = around(min, max, towards_camera, aspect);
                let from = (camera.eye - camera.target).normalize();
                assert!(from.abs_diff_eq(towards_camera.normalize(), 1e-5), "{from} {towards_camera}");
                let world_up = match towards_camera.z {
                    1.0 => Vec3::Y,
                    -1.0 => Vec3::NEG_Y,
                    _ => Vec3::Z,
                };
                assert_eq!(camera.up, world_up, "{towards_camera}");
                let reach_now = reach(min, max, aspect, &camera);
                assert!((0.95..=0.98).contains(&reach_now), "{min} {max} {aspect}: {reach_now}");
                // A box a tenth larger would not fit, nor one that is so across the view alone: a long one would reach the camera.
                let across =
                    if towards_camera == TOWARDS_CAMERA { Vec3::ONE } else { Vec3::ONE - towards_camera.abs() };
                let more = (max - min) * 0.05 * across;
                assert!(reach(min - more, max + more, aspect, &camera) > 1.0);
            }
        }
    }
}
