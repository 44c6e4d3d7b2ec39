//! What moves: a camera as heading and pitch above a horizon, in double precision, so that many small motions add up without drift. A
//! [`Camera`] in single precision is made of it for each picture.

use std::f64::consts::FRAC_PI_2;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::{DMat3, DVec2, DVec3, Vec3};

/// Steepest pitch that turning reaches, radians: short of the pole, where headings end.
const STEEPEST: f64 = 89.9 * std::f64::consts::PI / 180.0;
/// Nearest target, voxels.
pub const NEAREST: f64 = 1e-3;
/// Furthest target that motions lead to, voxels.
pub const FURTHEST: f64 = 1e9;
/// A target at this share of the eye's coordinates or further away keeps the direction to a twentieth of a pixel in single precision.
const TARGET_SHARE: f64 = 1.0 / 512.0;

/// A camera's place and direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub eye: DVec3,
    /// Unit vector that stays upright in the picture: the camera never rolls about its view.
    pub horizon: DVec3,
    /// Unit vector at right angles to the horizon's: the direction of view, seen from above.
    pub heading: DVec3,
    /// Angle of the view above the horizon, radians, -π/2 to π/2.
    pub pitch: f64,
    /// From the eye to the target, voxels.
    pub distance: f64,
    /// The camera's own `up`, kept as it came.
    pub up: Vec3,
    /// Vertical field of view, degrees.
    pub fov_y: f32,
    /// What the lens does, kept as it came.
    pub lens: Lens,
}

impl Pose {
    /// The pose of a camera whose numbers are finite.
    pub fn of(camera: &Camera) -> Self {
        let eye = camera.eye.as_dvec3();
        let offset = camera.target.as_dvec3() - eye;
        let up = if camera.up == Vec3::ZERO { Vec3::Z } else { camera.up };
        let pose = Self {
            eye,
            horizon: up.as_dvec3().normalize_or(DVec3::Z),
            heading: DVec3::Y,
            pitch: 0.0,
            distance: offset.length().max(NEAREST),
            up,
            fov_y: camera.fov_y,
            lens: camera.lens,
        };
        let forward = offset.normalize_or(DVec3::Y);
        // Along `up` the picture has the side that the tracer's projection takes.
        let of_picture = (camera.target - camera.eye).normalize_or(Vec3::Y);
        let side =
            of_picture.cross(up).try_normalize().is_none().then(|| of_picture.any_orthonormal_vector().as_dvec3());
        pose.towards(forward, side.map_or(pose.heading, |right| pose.horizon.cross(right)))
    }

    /// The pose that looks along the unit vector `forward`; where that is along the horizon's vector, `heading` is upwards in the picture
    /// or, looking up, downwards.
    pub fn towards(self, forward: DVec3, heading: DVec3) -> Self {
        let sine = forward.dot(self.horizon);
        let flat = forward - self.horizon * sine;
        if let Some(heading) = flat.try_normalize().filter(|_| flat.length() > 1e-9) {
            return Self { heading, pitch: sine.atan2(flat.length()), ..self };
        }
        let heading = heading.reject_from_normalized(self.horizon);
        let heading = heading.try_normalize().unwrap_or_else(|| self.horizon.any_orthonormal_vector());
        Self { heading, pitch: FRAC_PI_2.copysign(sine), ..self }
    }

    /// Columns: right, up and forward in the picture, unit vectors.
    pub fn basis(&self) -> DMat3 {
        let (sine, cosine) =
            if self.pitch.abs() >= FRAC_PI_2 { (self.pitch.signum(), 0.0) } else { self.pitch.sin_cos() };
        DMat3::from_cols(
            self.heading.cross(self.horizon),
            self.horizon * cosine - self.heading * sine,
            self.heading * cosine + self.horizon * sine,
        )
    }

    /// Unit vector of view.
    pub fn forward(&self) -> DVec3 {
        self.basis().z_axis
    }

    /// What is looked at.
    pub fn target(&self) -> DVec3 {
        self.eye + self.forward() * self.distance
    }

    /// The vector of depth 1 through a place in the picture: its part along the view is 1. `place` runs from -1 to 1, to the right and up.
    pub fn through(&self, place: DVec2, aspect: f64) -> DVec3 {
        let basis = self.basis();
        let half = (f64::from(self.fov_y).to_radians() * 0.5).tan();
        basis.z_axis + basis.x_axis * (place.x * half * aspect) + basis.y_axis * (place.y * half)
    }

    /// Turned by `right` and `up`, radians, with a level horizon.
    pub fn turned(self, right: f64, up: f64) -> Self {
        let (sine, cosine) = right.sin_cos();
        let heading = self.heading * cosine + self.heading.cross(self.horizon) * sine;
        let heading = heading.reject_from_normalized(self.horizon).normalize_or(self.heading);
        // A view on an axis, or a camera that came steeper, stays what it is until it is turned back.
        let steepest = self.pitch.abs().max(STEEPEST);
        Self { heading, pitch: (self.pitch + up).clamp(-steepest, steepest), ..self }
    }

    /// Turned likewise, and carried around `pivot`, which keeps its place in the picture.
    pub fn around(self, pivot: DVec3, right: f64, up: f64) -> Self {
        let turned = self.turned(right, up);
        let rotation = turned.basis() * self.basis().transpose();
        Self { eye: pivot + rotation * (self.eye - pivot), ..turned }
    }

    /// With z up, looking where it looks.
    pub fn levelled(self) -> Self {
        let basis = self.basis();
        let level = Self { horizon: DVec3::Z, up: Vec3::Z, ..self };
        let level = level.towards(basis.z_axis, basis.y_axis * -basis.z_axis.z.signum());
        Self { pitch: level.pitch.clamp(-STEEPEST, STEEPEST), ..level }
    }

    /// The camera for the tracer.
    pub fn camera(&self, name: &str) -> Camera {
        let basis = self.basis();
        let distance = self.distance.max(self.eye.abs().max_element() * TARGET_SHARE);
        // Near the pole `up` says little about which way is upwards in the picture.
        let is_steep = basis.z_axis.reject_from_normalized(self.horizon).length() < 1e-3;
        Camera {
            name: name.to_owned(),
            eye: self.eye.as_vec3(),
            target: (self.eye + basis.z_axis * distance).as_vec3(),
            up: if is_steep { basis.y_axis.as_vec3() } else { self.up },
            fov_y: self.fov_y,
            lens: self.lens,
        }
    }
}
