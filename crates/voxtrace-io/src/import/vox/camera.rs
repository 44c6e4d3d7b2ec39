//! Cameras of a .vox file (rCAM): an orbit around a focus by pitch, yaw and roll in degrees at a radius in voxels.
//!
//! The format text names the keys and leaves their meaning to the program. What voxtrace takes them to be: at pitch and yaw 0 the
//! camera looks along +y, positive pitch looks down, positive yaw turns the view clockwise as seen from above, positive
//! roll tilts the camera clockwise; `_fov` is the vertical field of view in degrees. The modes `orth` and `iso`
//! become parallel rays, `pano` a panorama, the others pinholes.
//! MagicaVoxel always writes ten cameras; those that still have their initial values are left out.
//!
//! Positions are rounded to 2⁻²⁰ of a voxel and roll to 1e-4 degrees, so that a camera that is written and read again is the
//! same in every bit though angles stand between.

use super::{attributes::Attributes, graph::MAX_TRANSLATION};
use glam::{DVec3, Vec3};
use voxtrace_scene::camera::{Camera, Lens};
use voxtrace_voxelize::ImportError;

/// Key in which voxtrace keeps a camera's name; MagicaVoxel has none.
pub const NAME_KEY: &str = "_name";
const POSITION_STEPS: f64 = (1 << 20) as f64;
const DEGREE_STEPS: f64 = 1e4;
/// A view whose horizontal part is shorter than this looks straight up or down.
const VERTICAL: f64 = 1e-9;

/// Pitch, yaw and roll in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// Down from the horizon.
    pub pitch: f64,
    /// Clockwise from +y, seen from above.
    pub yaw: f64,
    /// Clockwise tilt.
    pub roll: f64,
}

/// The direction of a view with this pitch and yaw, in degrees: a unit vector.
pub fn direction_of(pitch: f64, yaw: f64) -> DVec3 {
    let ((pitch_sin, pitch_cos), (yaw_sin, yaw_cos)) = (pitch.to_radians().sin_cos(), yaw.to_radians().sin_cos());
    DVec3::new(yaw_sin * pitch_cos, yaw_cos * pitch_cos, -pitch_sin)
}

/// An angle in (−180, 180] degrees, to 1e-4 degrees: the angle that f32 vectors give back.
pub fn rounded_degrees(degrees: f64) -> f64 {
    let turned = rounded(degrees % 360.0, DEGREE_STEPS);
    let turns = if turned > 180.0 {
        -360.0
    } else if turned <= -180.0 {
        360.0
    } else {
        0.0
    };
    rounded(turned + turns, DEGREE_STEPS)
}

/// The camera of an rCAM chunk, `None` for one that was never set.
///
/// # Errors
/// If a value is no number or stands too far out.
pub fn camera_of(id: i32, attributes: &Attributes) -> Result<Option<Camera>, ImportError> {
    let focus = DVec3::from_array(attributes.floats("_focus")?.unwrap_or_default());
    let [pitch, yaw, roll] = attributes.floats("_angle")?.unwrap_or_default();
    let radius = attributes.float("_radius")?.unwrap_or(0.0);
    let fov_y = attributes.float("_fov")?.unwrap_or(45.0);
    let name = attributes.text(NAME_KEY);
    let at_origin = [focus.x, focus.y, focus.z, pitch, yaw, roll].iter().all(|&value| value == 0.0);
    if name.is_none() && at_origin && (radius == 0.0 || radius == 1.0) {
        return Ok(None);
    }
    for (key, distance) in [("_focus", focus.abs().max_element()), ("_radius", radius.abs())] {
        if distance > MAX_TRANSLATION as f64 {
            return Err(attributes.wrong(key, attributes.dict.get(key).unwrap_or_default()));
        }
    }
    let direction = direction_of(pitch, yaw);
    let (mut eye, mut target) = (on_grid(focus - direction * radius.max(0.0)), on_grid(focus));
    if eye == target {
        // A radius of 0 stands at the focus and looks on.
        (eye, target) = (target, on_grid(focus + direction * 16.0));
    }
    let up = up_of(eye, target, Angles { pitch, yaw, roll });
    let name = name.unwrap_or_else(|| format!("camera-{id}"));
    let camera = Camera { name, eye, target, up, fov_y: (fov_y as f32).clamp(1.0, 179.0), lens: Lens::Pinhole };
    let lens = lens_of(&camera, &attributes.text("_mode").unwrap_or_default());
    Ok(Some(camera.with_lens(lens)))
}

/// The lens of a mode: `orth` and `iso` have parallel rays that show the focus as large as a pinhole would, `pano` all directions.
fn lens_of(camera: &Camera, mode: &str) -> Lens {
    match mode {
        "orth" | "iso" => Lens::Orthographic { view_height: camera.height_at_target() },
        "pano" => Lens::Panorama { eye_distance: 0.0 },
        _ => Lens::Pinhole,
    }
}

/// The angles of a camera whose eye and target differ.
pub fn angles_of(camera: &Camera) -> Angles {
    let view = (camera.target.as_dvec3() - camera.eye.as_dvec3()).normalize_or(DVec3::Y);
    let up = camera.up.as_dvec3();
    if view.x.hypot(view.y) < VERTICAL {
        // Straight down, the top of the picture points where the yaw does; straight up, the other way.
        let (pitch, ahead) = if view.z < 0.0 { (90.0, up) } else { (-90.0, -up) };
        return Angles { pitch, yaw: rounded_degrees(ahead.x.atan2(ahead.y).to_degrees()), roll: 0.0 };
    }
    let right = view.cross(DVec3::Z).normalize();
    let upright = right.cross(view);
    Angles {
        pitch: (-view.z).atan2(view.x.hypot(view.y)).to_degrees(),
        yaw: view.x.atan2(view.y).to_degrees(),
        roll: rounded_degrees(up.dot(right).atan2(up.dot(upright)).to_degrees()),
    }
}

/// The camera's up vector; computed from the view between the rounded positions, so that reading again gives the same.
fn up_of(eye: Vec3, target: Vec3, angles: Angles) -> Vec3 {
    let view = (target.as_dvec3() - eye.as_dvec3()).normalize_or(DVec3::Y);
    let (yaw, roll) = (rounded_degrees(angles.yaw), rounded_degrees(angles.roll));
    if view.x.hypot(view.y) < VERTICAL {
        let turn = if view.z < 0.0 { yaw + roll } else { yaw - roll };
        let (sin, cos) = rounded_degrees(turn).to_radians().sin_cos();
        return on_grid(DVec3::new(sin, cos, 0.0) * -view.z.signum());
    }
    if roll == 0.0 {
        return Vec3::Z;
    }
    let (sin, cos) = roll.to_radians().sin_cos();
    let right = view.cross(DVec3::Z).normalize();
    (right * sin + right.cross(view) * cos).as_vec3()
}

fn on_grid(position: DVec3) -> Vec3 {
    position.to_array().map(|coordinate| rounded(coordinate, POSITION_STEPS) as f32).into()
}

/// Nearest multiple of 1 / `steps`, without a negative zero.
pub fn rounded(value: f64, steps: f64) -> f64 {
    (value * steps).round() / steps + 0.0
}
