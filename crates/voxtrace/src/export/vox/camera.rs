//! Cameras as rCAM chunks: the inverse of the importer's.

use crate::{
    camera::Camera,
    import::vox::{
        Body, Dict, Numbered,
        camera::{NAME_KEY, angles_of, default_name},
    },
};
use std::collections::BTreeSet;

/// An rCAM chunk for each camera. A camera whose name is that of a nameless one gets the id in it.
pub fn cameras_of(cameras: &[Camera]) -> Vec<Body<'static>> {
    let mut taken = BTreeSet::new();
    let mut ids: Vec<Option<i32>> = Vec::with_capacity(cameras.len());
    for camera in cameras {
        let id = camera.name.rsplit('-').next().and_then(|id| id.parse().ok());
        ids.push(id.filter(|&id| default_name(id) == camera.name && taken.insert(id)));
    }
    let mut free = (0..).filter(|id| !taken.contains(id));
    cameras.iter().zip(ids).map(|(camera, id)| camera_of(camera, id.or_else(|| free.next()).unwrap_or(-1))).collect()
}

fn camera_of(camera: &Camera, id: i32) -> Body<'static> {
    let (focus, angles) = (camera.target, angles_of(camera));
    let radius = (camera.target.as_dvec3() - camera.eye.as_dvec3()).length();
    let mut properties = Dict::default();
    if camera.name != default_name(id) {
        properties.push(NAME_KEY, camera.name.clone());
    }
    properties.push("_mode", "pers");
    properties.push("_focus", format!("{} {} {}", focus.x, focus.y, focus.z));
    properties.push("_angle", format!("{} {} {}", angles.pitch, angles.yaw, angles.roll));
    properties.push("_radius", radius.to_string());
    properties.push("_frustum", (f64::from(camera.fov_y).to_radians() * 0.5).tan().to_string());
    properties.push("_fov", camera.fov_y.to_string());
    Body::Camera(Numbered { id, properties })
}
