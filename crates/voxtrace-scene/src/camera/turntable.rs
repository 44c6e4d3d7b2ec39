//! Cameras of a turntable.

use super::Camera;
use glam::DMat3;

impl Camera {
    /// The camera of frame `frame`, counted from 1, of a turn in `frames`: carried around the vertical through its target,
    /// counter-clockwise seen from above. The first is the camera itself.
    pub fn turned(&self, frame: u32, frames: u32) -> Self {
        let angle = std::f64::consts::TAU * f64::from(frame.saturating_sub(1)) / f64::from(frames.max(1));
        let rotation = DMat3::from_rotation_z(angle);
        let offset = rotation * (self.eye - self.target).as_dvec3();
        let eye = (self.target.as_dvec3() + offset).as_vec3();
        let up = (rotation * self.up.as_dvec3()).as_vec3();
        Self { eye, up, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_turntable_starts_at_the_camera_and_passes_its_opposite_half_way() {
        let camera = Camera::look_at(Vec3::new(10.0, 0.0, 5.0), Vec3::new(2.0, 1.0, 0.0));
        assert_eq!(camera.turned(1, 8), camera);
        let opposite = camera.turned(5, 8);
        assert!(opposite.eye.abs_diff_eq(Vec3::new(-6.0, 2.0, 5.0), 1e-5), "{}", opposite.eye);
        assert_eq!(opposite.target, camera.target);
        let quarter = camera.turned(3, 8);
        assert!(quarter.eye.abs_diff_eq(Vec3::new(3.0, 9.0, 5.0), 1e-5), "{}", quarter.eye);
    }
}
