//! The place where a ray met a voxel: its normal, the frame for scattered directions, and the origin of the rays that
//! leave from it.

use crate::math::{normalize, orthonormal_pair};
use crate::packed::{PackedInstance, PackedScene};
use glam::{BVec3, Vec3};
use voxtrace_scene::ray::{FACES, Face, Hit, Ray};

/// A point on a face of a voxel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<'a> {
    /// Origin of rays that leave the surface, world space: just outside the face.
    pub origin: Vec3,
    /// Outward unit normal, world space.
    pub normal: Vec3,
    /// The face, in grid space; `None` on the face of a cut, whose frame is made of its normal.
    pub face: Option<Face>,
    /// The instance that it belongs to.
    pub instance: &'a PackedInstance,
}

impl<'a> Surface<'a> {
    /// The surface that `hit`, no miss, of `ray` met.
    #[inline]
    pub fn new(scene: &'a PackedScene, ray: &Ray, hit: &Hit) -> Self {
        let instance = &scene.placement.instances[hit.instance as usize];
        let point =
            instance.grid_from_world.point(ray.origin) + instance.grid_from_world.direction(ray.direction) * hit.t;
        if let Some(normal) = scene.cuts.normal(hit) {
            return Self { origin: before_cut(scene, ray, hit, normal), normal, face: None, instance };
        }
        let face = hit.face();
        let low = hit.voxel.as_vec3();
        Self {
            origin: instance.world_from_grid.point(offset_ray_origin(instance, low, face, point)),
            normal: instance.world_normal(face),
            face: Some(face),
            instance,
        }
    }

    /// The unit world direction of `local`, whose z points away from the face.
    #[inline]
    pub fn world_direction(&self, local: Vec3) -> Vec3 {
        let Some(face) = self.face else {
            let (x, y) = orthonormal_pair(self.normal);
            return normalize(x * local.x + y * local.y + self.normal * local.z);
        };
        let away = if face as u32 & 1 == 1 { local.z } else { -local.z };
        let in_grid = match face.axis() {
            0 => Vec3::new(away, local.x, local.y),
            1 => Vec3::new(local.y, away, local.x),
            _ => Vec3::new(local.x, local.y, away),
        };
        normalize(self.instance.world_from_grid.direction(in_grid))
    }

    /// The unit direction in the frame of the surface, z away from the face, of `world`: the inverse of [`Self::world_direction`].
    #[inline]
    pub fn local_direction(&self, world: Vec3) -> Vec3 {
        // Nothing here can fail, so that compilers drop it for surfaces that do not ask for it.
        let Some(face) = self.face else {
            let ((x, y), unit) = (orthonormal_pair(self.normal), normalize(world));
            return Vec3::new(x.dot(unit), y.dot(unit), self.normal.dot(unit));
        };
        let in_grid = normalize(self.instance.grid_from_world.direction(world));
        let local = match face.axis() {
            0 => Vec3::new(in_grid.y, in_grid.z, in_grid.x),
            1 => Vec3::new(in_grid.z, in_grid.x, in_grid.y),
            _ => in_grid,
        };
        if face as u32 & 1 == 1 { local } else { local.with_z(-local.z) }
    }
}

/// Margin of [`offset_ray_origin`] where f32 is coarse, relative to the largest number on the way to world space and back: 8 ulp
/// at least.
const MARGIN_SCALE: f32 = 1.0 / 2_097_152.0;
/// Least margin, voxels.
pub(crate) const MARGIN_MIN: f32 = 1.0 / 1024.0;
/// Largest margin, voxels.
pub(crate) const MARGIN_MAX: f32 = 0.25;

/// Moves `point` (grid space, on or near the `face` of the voxel whose lowest corner is `low`) strictly inside the cell
/// in front of the face. A ray from there starts in the cell from which the face is seen and in no other, and as the walk
/// is exact in integer cells, it can neither meet the voxel that it leaves nor start behind it: nothing leaks.
///
/// The margin is 1/1024 voxel, and more where f32 is coarser: at least 8 ulp of the largest number on the way
/// to world space and back. With an identity transform nothing is rounded after the clamp; otherwise the margin is what
/// keeps the rounded point in its cell.
// Modules for pages are held small.
#[cfg_attr(not(target_arch = "wasm32"), inline)]
pub fn offset_ray_origin(instance: &PackedInstance, low: Vec3, face: Face, point: Vec3) -> Vec3 {
    beside(instance, low, face, point, 1.0)
}

/// Moves `point` as [`offset_ray_origin`] does, but into the voxel, just behind the face.
pub fn behind(instance: &PackedInstance, low: Vec3, face: Face, point: Vec3) -> Vec3 {
    beside(instance, low, face, point, -1.0)
}

/// The point beside a face, `side` margins outside of it.
#[cfg_attr(not(target_arch = "wasm32"), inline)]
fn beside(instance: &PackedInstance, low: Vec3, face: Face, point: Vec3, side: f32) -> Vec3 {
    let margin = margin(instance, low);
    let moved = point.max(low + margin).min(low + (1.0 - margin));
    let (axis, beyond) = (face.axis(), margin * side);
    let on_face = low + if face as u32 & 1 == 1 { 1.0 + beyond } else { -beyond };
    // Chosen, not put into a vector in memory, which whoever reads it whole waits for.
    Vec3::select(BVec3::new(axis == 0, axis == 1, axis == 2), on_face, moved)
}

/// Origin of rays that enter the voxel that `hit`, no miss, of `ray` met, world space: just inside the face.
pub fn behind_face(scene: &PackedScene, ray: &Ray, hit: &Hit) -> Vec3 {
    if let Some(normal) = scene.cuts.normal(hit) {
        return behind_cut(scene, ray, hit, normal);
    }
    let instance = &scene.placement.instances[hit.instance as usize];
    let point = instance.grid_from_world.point(ray.origin) + instance.grid_from_world.direction(ray.direction) * hit.t;
    instance.world_from_grid.point(behind(instance, hit.voxel.as_vec3(), hit.face(), point))
}

/// Origin of rays that stay before the face of a cut, towards `normal`: in the voxel where the ray would have left it, else in air.
fn before_cut(scene: &PackedScene, ray: &Ray, hit: &Hit, normal: Vec3) -> Vec3 {
    let point = ray.at(hit.t) + normal * scene.cuts.margin(hit);
    if hit.leaves_cut() { in_voxel(scene, hit, point) } else { point }
}

/// Origin of rays that go through the face of a cut.
fn behind_cut(scene: &PackedScene, ray: &Ray, hit: &Hit, normal: Vec3) -> Vec3 {
    let point = ray.at(hit.t) - normal * scene.cuts.margin(hit);
    if hit.leaves_cut() { point } else { in_voxel(scene, hit, point) }
}

/// The point, world space, moved into the voxel of a hit.
fn in_voxel(scene: &PackedScene, hit: &Hit, point: Vec3) -> Vec3 {
    let instance = &scene.placement.instances[hit.instance as usize];
    let local = clamp_to_voxel(instance, hit.voxel.as_vec3(), instance.grid_from_world.point(point));
    instance.world_from_grid.point(local)
}

impl PackedScene {
    /// Unit normal of the surface that `hit`, one of this scene, met, world space: of a face of a voxel, or of a cut.
    ///
    /// # Panics
    /// If the hit is not one of this scene.
    pub fn normal(&self, hit: &Hit) -> Vec3 {
        self.packed_normal(&self.hit_of_packed(hit))
    }

    /// As [`Self::normal`], of a hit as tracers find it.
    pub(crate) fn packed_normal(&self, hit: &Hit) -> Vec3 {
        let of_voxel = || self.placement.instances[hit.instance as usize].world_normal(hit.face());
        self.cuts.normal(hit).unwrap_or_else(of_voxel)
    }
}

/// Moves `point` (grid space) into the voxel whose lowest corner is `low`, off its faces.
pub fn clamp_to_voxel(instance: &PackedInstance, low: Vec3, point: Vec3) -> Vec3 {
    let margin = margin(instance, low);
    point.max(low + margin).min(low + (1.0 - margin))
}

/// How far from the faces of a voxel rays start, voxels.
#[inline]
fn margin(instance: &PackedInstance, low: Vec3) -> f32 {
    let largest = (low.abs() + instance.grid_from_world.translation.abs()).max_element() + 1.0;
    (largest * MARGIN_SCALE).clamp(MARGIN_MIN, MARGIN_MAX)
}

/// The faces of a voxel in the order of their numbers that the bits of `mask` select.
pub fn faces_of(mask: u32) -> impl Iterator<Item = Face> {
    FACES.into_iter().filter(move |&face| mask >> face as u32 & 1 != 0)
}
