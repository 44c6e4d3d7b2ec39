//! What a flight goes through: cameras as numbers.

use super::{Camera, Lens};
use glam::{DMat3, DQuat, DVec3};
use std::ops::Range;

/// Sine of the angle between view and `up` below which `up` says nothing.
const STEEP: f64 = 1e-3;

/// A camera as numbers that can be interpolated: eye, quaternion, up, distance of the target, field of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose(pub [f64; 12]);

impl Pose {
    /// What of a pose may stay while the rest changes: eye, quaternion, up, distance of the target, field of view.
    pub const PARTS: [Range<usize>; 5] = [0..3, 3..7, 7..10, 10..11, 11..12];

    pub fn of(camera: &Camera) -> Self {
        let eye = camera.eye.as_dvec3();
        let offset = camera.target.as_dvec3() - eye;
        let forward = offset.normalize_or(DVec3::Y);
        // Along `up` the picture has the side that the projection takes.
        let side = forward.cross(camera.up.as_dvec3()).try_normalize();
        let right = side.unwrap_or_else(|| forward.as_vec3().any_orthonormal_vector().as_dvec3());
        let turn = DQuat::from_mat3(&DMat3::from_cols(right, forward, right.cross(forward)));
        let up = camera.up.as_dvec3().normalize_or(DVec3::Z);
        let distance = offset.length();
        let fov_y = f64::from(camera.fov_y);
        Self([eye.x, eye.y, eye.z, turn.x, turn.y, turn.z, turn.w, up.x, up.y, up.z, distance, fov_y])
    }

    pub fn eye(&self) -> DVec3 {
        DVec3::from_slice(&self.0[..3])
    }

    pub fn turn(&self) -> DQuat {
        DQuat::from_slice(&self.0[3..7]).normalize()
    }

    /// With the one of both quaternions of its direction that is nearer to another pose's.
    pub fn beside(mut self, other: &Self) -> Self {
        let dot: f64 = (3..7).map(|index| self.0[index] * other.0[index]).sum();
        if dot < 0.0 {
            self.0[3..7].iter_mut().for_each(|part| *part = -*part);
        }
        self
    }

    /// Each number of both, combined.
    pub fn zip(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|index| combine(self.0[index], other.0[index])))
    }

    /// With another place of the eye.
    pub fn with_eye(mut self, eye: Option<DVec3>) -> Self {
        if let Some(eye) = eye {
            self.0[..3].copy_from_slice(&eye.to_array());
        }
        self
    }

    pub fn plus(&self, other: &Self, factor: f64) -> Self {
        self.zip(other, |own, other| own + other * factor)
    }

    pub fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|value| value * factor))
    }

    /// How far it is to another pose; `radius` is the length of a radian of turning.
    pub fn distance(&self, other: &Self, radius: f64) -> f64 {
        (self.eye().distance_squared(other.eye()) + (radius * self.angle(other)).powi(2)).sqrt()
    }

    /// The chord of the turning between two poses, which is its angle where that is small.
    pub fn angle(&self, other: &Self) -> f64 {
        let (own, other) = (self.turn(), other.turn());
        2.0 * (own - other).length().min((own + other).length())
    }

    /// The camera, within the fields of view and distances that the cameras of the flight have.
    pub fn camera(&self, fields: (f64, f64), distances: (f64, f64)) -> Camera {
        let (eye, turn) = (self.eye(), self.turn());
        let forward = turn * DVec3::Y;
        let up = DVec3::from_slice(&self.0[7..10]).normalize_or(DVec3::Z);
        let up = if forward.cross(up).length() < STEEP { turn * DVec3::Z } else { up };
        Camera {
            name: "flight".into(),
            eye: eye.as_vec3(),
            target: (eye + forward * self.0[10].clamp(distances.0, distances.1)).as_vec3(),
            up: up.as_vec3(),
            fov_y: self.0[11].clamp(fields.0, fields.1) as f32,
            lens: Lens::Pinhole,
        }
    }
}
