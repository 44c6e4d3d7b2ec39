//! Cameras of a glTF document, placed by their nodes: they look along their −z, with +y up.

use super::document::{GltfCamera, Node};
use glam::{DAffine3, DVec3, Vec3};
use voxtrace_scene::camera::Camera;

/// The camera of a node relative to `offset`, `None` where it is no perspective one or its numbers are no use.
pub(super) fn camera(node: &Node, camera: &GltfCamera, world: &DAffine3, offset: DVec3) -> Option<Camera> {
    let fov_y = camera.perspective.as_ref()?.yfov.to_degrees();
    let turned = |v: DVec3| DVec3::new(v.x, -v.z, v.y);
    let forward = turned(world.transform_vector3(DVec3::NEG_Z)).try_normalize()?;
    let up = turned(world.transform_vector3(DVec3::Y)).try_normalize()?;
    let eye = turned(world.translation) - offset;
    let name = if camera.name.is_empty() { &node.name } else { &camera.name };
    let is_usable = eye.as_vec3().is_finite() && (1.0..179.0).contains(&fov_y);
    let placed = Camera { name: name.clone(), fov_y, up: up.as_vec3(), ..Camera::look_at(Vec3::ZERO, Vec3::Y) };
    is_usable.then(|| Camera { eye: eye.as_vec3(), target: (eye + forward).as_vec3(), ..placed })
}
