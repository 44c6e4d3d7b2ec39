//! Cameras of a glTF document, placed by their nodes: they look along their −z, with +y up.

use super::document::{GltfCamera, Node};
use glam::{DAffine3, DVec3, Vec3};
use voxtrace_scene::camera::{Camera, Lens};

/// The camera of a node relative to `offset`, `None` where its numbers are no use.
pub(super) fn camera(node: &Node, camera: &GltfCamera, world: &DAffine3, offset: DVec3) -> Option<Camera> {
    let (fov_y, view_height) = match (&camera.perspective, &camera.orthographic) {
        (Some(perspective), _) => (perspective.yfov.to_degrees(), None),
        (None, Some(orthographic)) => (45.0, Some(2.0 * orthographic.ymag.abs())),
        (None, None) => return None,
    };
    let turned = |v: DVec3| DVec3::new(v.x, -v.z, v.y);
    let forward = turned(world.transform_vector3(DVec3::NEG_Z)).try_normalize()?;
    let up = turned(world.transform_vector3(DVec3::Y)).try_normalize()?;
    let eye = turned(world.translation) - offset;
    let name = if camera.name.is_empty() { &node.name } else { &camera.name };
    let lens = view_height.map_or(Lens::Pinhole, |height| {
        // The magnification does not grow with the node.
        Lens::Orthographic { view_height: height }
    });
    let is_usable = eye.as_vec3().is_finite() && (1.0..179.0).contains(&fov_y) && lens.check().is_ok();
    let placed = Camera { name: name.clone(), fov_y, lens, up: up.as_vec3(), ..Camera::look_at(Vec3::ZERO, Vec3::Y) };
    is_usable.then(|| Camera { eye: eye.as_vec3(), target: (eye + forward).as_vec3(), ..placed })
}
