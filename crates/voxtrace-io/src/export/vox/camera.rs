//! Cameras as rCAM chunks: the inverse of the importer's.

use crate::import::vox::{
    Body, Dict, Numbered,
    camera::{NAME_KEY, angles_of},
};
use voxtrace_scene::camera::{Camera, Lens};

/// An rCAM chunk for each camera.
pub fn cameras_of(cameras: &[Camera]) -> impl Iterator<Item = Body<'static>> + '_ {
    (0..).zip(cameras).map(|(id, camera)| camera_of(id, camera))
}

fn camera_of(id: i32, camera: &Camera) -> Body<'static> {
    let (focus, angles) = (camera.target, angles_of(camera));
    let radius = (camera.target.as_dvec3() - camera.eye.as_dvec3()).length();
    let mut properties = Dict::default();
    properties.push(NAME_KEY, camera.name.clone());
    properties.push("_mode", mode_of(camera.lens));
    properties.push("_focus", format!("{} {} {}", focus.x, focus.y, focus.z));
    properties.push("_angle", format!("{} {} {}", angles.pitch, angles.yaw, angles.roll));
    properties.push("_radius", radius.to_string());
    properties.push("_frustum", (f64::from(camera.fov_y).to_radians() * 0.5).tan().to_string());
    properties.push("_fov", camera.fov_y.to_string());
    Body::Camera(Numbered { id, properties })
}

/// The mode that is nearest to a lens; MagicaVoxel has no fisheye, and one thin lens for all cameras.
fn mode_of(lens: Lens) -> &'static str {
    match lens {
        Lens::Orthographic { .. } => "orth",
        Lens::Panorama { .. } => "pano",
        _ => "pers",
    }
}
