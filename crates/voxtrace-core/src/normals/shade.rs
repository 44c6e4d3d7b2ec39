//! Where the normal of a voxel counts: the surface that a path leaves is that of the smooth shape, and what the path meets is voxels. Twin of
//! `smooth` in `shaders/normals.slang`.
//!
//! A normal never shows a viewer, or a face, its back (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, § 5.3, says what goes
//! wrong). That alone leaves terraces, because light that grazes the smooth shape lies behind one of any two faces and in the shadow of the next step.
//! So rays do not start on the face but above it, where no voxel of a plane with this normal can be (the idea is Hanika's, "Hacking the Shadow
//! Terminator", Ray Tracing Gems II, 2021; the height is that of voxels). They start no farther than the way there is empty, so that nothing leaks
//! through walls. All directions above the smooth surface are then as they are on any surface: no light is lost, and none is made.

use super::code::{Decoded, NO_NORMAL, REACH, decode};
use crate::math::normalize;
use crate::packed::PackedScene;
use crate::surface::{Surface, clamp_to_voxel, offset_ray_origin};
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::{Face, Hit, Ray};

/// Least cosine between a shading normal and the direction to the viewer.
const LEAST_COSINE: f32 = 1.0 / 32.0;
/// How far, of [`REACH`], the normal of a solid points away from a face that is its back.
const BACK: f32 = 21.0;
/// Most faces of voxels on the way from a face to the smooth surface above it.
const MOST_CROSSED: u32 = 6;

impl<'a> Surface<'a> {
    /// Makes it the smooth surface that `hit` of `ray` met, where its voxel has a normal. Where `is_lifted`, rays start above the voxels; in a
    /// medium of the same grid, whose voxels are counted, they start at the face.
    #[inline]
    pub(crate) fn smooth(&mut self, scene: &PackedScene, ray: &Ray, hit: &Hit, is_lifted: bool) {
        if scene.geometry.has_normals() {
            self.smooth_by_normal(scene, ray, hit, is_lifted);
        }
    }

    #[inline(never)]
    fn smooth_by_normal(&mut self, scene: &PackedScene, ray: &Ray, hit: &Hit, is_lifted: bool) {
        let Some((face, along)) = normal_along(scene, ray, hit) else { return };
        let instance = self.instance;
        let wo = normalize(-ray.direction);
        let mut normal = normalize(instance.world_from_grid.direction(along));
        let cos = normal.dot(wo);
        if cos < LEAST_COSINE {
            normal = normalize(normal + wo * (LEAST_COSINE - cos));
        }
        let mut origin = self.origin;
        if is_lifted {
            let point =
                instance.grid_from_world.point(ray.origin) + instance.grid_from_world.direction(ray.direction) * hit.t;
            let start = offset_ray_origin(instance, hit.voxel.as_vec3(), face, point);
            let grid = &scene.geometry.grids[instance.grid as usize];
            let is_empty = |voxel: IVec3| scene.geometry.material_at(grid, voxel).is_none();
            let (cell, place) = lifted(is_empty, hit.voxel + face.normal(), start, along);
            origin = instance.world_from_grid.point(clamp_to_voxel(instance, cell.as_vec3(), place));
        }
        *self = Self { origin, normal, face: None, instance };
    }
}

/// The face that was hit, and a vector along the normal of its voxel in the space of its grid, on the side of that face; `None` where there is none.
fn normal_along(scene: &PackedScene, ray: &Ray, hit: &Hit) -> Option<(Face, Vec3)> {
    if hit.face >= Hit::FIRST_CUT {
        return None;
    }
    let instance = &scene.placement.instances[hit.instance as usize];
    let code = scene.geometry.normal_at(&scene.geometry.grids[instance.grid as usize], hit.voxel)?;
    if code == NO_NORMAL {
        return None;
    }
    let face = hit.face();
    let Decoded { along, is_two_sided } = decode(code);
    let wo = normalize(-instance.grid_from_world.direction(ray.direction));
    Some((face, facing(along.as_vec3(), is_two_sided, face, wo)))
}

/// A vector along the normal of a voxel on the side of the face that is seen from the direction `wo`, grid space.
#[inline]
fn facing(mut along: Vec3, is_two_sided: bool, face: Face, wo: Vec3) -> Vec3 {
    let (axis, side) = (face.axis(), if face as u32 & 1 == 1 { 1.0 } else { -1.0 });
    let outward = side * along[axis];
    // Of what is thin, the side is that of face and viewer together: risers of a sheet hardly say. Of a solid it is its own, but for one that
    // is hollow and seen from within.
    let is_back = if is_two_sided { outward + along.dot(wo) < 0.0 } else { outward < -BACK };
    if is_back {
        along = -along;
    }
    // A face that looks away from its normal still is due to noise.
    along[axis] = side * along[axis].abs();
    along
}

/// Where a way of the length |n|₁ from `start`, which is in the empty voxel `cell`, along n ends, n the unit vector along `along`: no voxel of a plane with
/// this normal is as high above another's face. It ends before the first voxel that is not empty. The place, and the voxel that it is in.
fn lifted(is_empty: impl Fn(IVec3) -> bool, mut cell: IVec3, start: Vec3, along: Vec3) -> (IVec3, Vec3) {
    let way = along * (REACH as f32 / along.length_squared());
    let mut t = 1.0;
    for _ in 0..MOST_CROSSED {
        let low = cell.as_vec3();
        let time = |axis: usize| {
            let plane = if way[axis] > 0.0 { low[axis] + 1.0 } else { low[axis] };
            if way[axis] == 0.0 { 2.0 } else { (plane - start[axis]) / way[axis] }
        };
        let times = [time(0), time(1), time(2)];
        let mut axis = 0;
        for other in 1..3 {
            if times[other] < times[axis] {
                axis = other;
            }
        }
        if times[axis] >= 1.0 {
            break;
        }
        let mut next = cell;
        next[axis] += if way[axis] > 0.0 { 1 } else { -1 };
        if !is_empty(next) {
            t = times[axis];
            break;
        }
        cell = next;
    }
    (cell, start + way * t)
}

impl PackedScene {
    /// Unit normal of the smooth surface that `hit` of `ray`, as tracers find it, met; of its face where it has none, and of glass.
    pub fn shading_normal(&self, ray: &Ray, hit: &Hit) -> Vec3 {
        let is_smooth = self.geometry.has_normals() && self.packed_material(hit).transmission < 0.5;
        let along = if is_smooth { normal_along(self, ray, hit) } else { None };
        let instance = &self.placement.instances[hit.instance as usize];
        along.map_or_else(|| self.packed_normal(hit), |(_, along)| normalize(instance.world_from_grid.direction(along)))
    }
}
