//! The way of a ray inside of a medium: voxel by voxel, with the exact decisions of the walk outside, to the first voxel of another
//! material. The walks outside are not used there, as they look for voxels and not for what they are made of.

use super::{Inside, face_towards};
use crate::packed::{BrickMaterials, InstanceNode, MAX_INSTANCE_DEPTH, PackedScene};
use crate::surface::behind;
use crate::walk::exact::{hit_of, next_voxel};
use crate::walk::local_ray::LocalRay;
use crate::walk::{MAX_ORIGIN, cast_below};
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::{Hit, Ray};

/// Where a ray that starts in the voxel of `inside` leaves its medium: the voxel beyond, which may be empty, and the face through which the
/// ray enters it. A miss where its segment ends before; then `voxel` is the last one of the medium.
pub fn cast_inside(scene: &PackedScene, ray: &Ray, inside: &Inside) -> Hit {
    let way = WayOut::of(scene, ray, inside);
    if scene.placement.instances.len() == 1 {
        return way.own;
    }
    way.met(scene, ray, inside, cast_below(scene, &way.before, inside.instance))
}

/// The way of a ray out of its medium, as if there were no other instances.
pub(super) struct WayOut {
    /// Where it leaves.
    own: Hit,
    /// Material of the voxel beyond.
    beyond: Option<u32>,
    /// The ray up to there, on which instances of lower index may begin.
    pub before: Ray,
}

impl WayOut {
    /// Follows a ray that starts in the voxel of `inside`.
    pub fn of(scene: &PackedScene, ray: &Ray, inside: &Inside) -> Self {
        let placed = &scene.placement.instances[inside.instance as usize];
        let grid = &scene.geometry.grids[placed.grid as usize];
        let ended = |voxel: IVec3| Hit { voxel, ..Hit::MISS };
        let Some(local) = LocalRay::new(ray, &placed.grid_from_world) else {
            return Self { own: ended(inside.voxel), beyond: None, before: Ray { t_max: -1.0, ..*ray } };
        };
        let mut materials = BrickMaterials::new(&scene.geometry, grid);
        let mut last = inside.voxel;
        let has_end = ray.t_max < f32::INFINITY;
        let (own, beyond) = loop {
            let voxel = next_voxel(&local, last);
            if has_end && hit_of(&local, voxel, inside.instance).t > ray.t_max {
                break (ended(last), None);
            }
            let beyond = materials.at(voxel);
            if beyond != Some(inside.material) {
                break (hit_of(&local, voxel, inside.instance), beyond);
            }
            last = voxel;
        };
        Self { own, beyond, before: Ray { t_max: own.t.min(ray.t_max), ..*ray } }
    }

    /// What the ray meets that met `lower` on the way: instances of lower index begin wherever they are, the others where this one ends.
    pub fn met(&self, scene: &PackedScene, ray: &Ray, inside: &Inside, lower: Hit) -> Hit {
        let own = self.own;
        if !lower.is_miss() {
            return lower;
        }
        if own.is_miss() || self.beyond.is_some() {
            return own;
        }
        let placed = &scene.placement.instances[inside.instance as usize];
        let Some(local) = LocalRay::new(ray, &placed.grid_from_world) else { return own };
        let point = local.origin + local.direction * own.t;
        let in_air = placed.world_from_grid.point(behind(placed, own.voxel.as_vec3(), own.face(), point));
        let Some((instance, voxel)) = voxel_at(scene, in_air, Some(inside.instance)) else { return own };
        let normal = placed.world_normal(own.face());
        let face = face_towards(&scene.placement.instances[instance as usize], normal);
        Hit { t: own.t, instance, voxel, face: face as u32 }
    }
}

/// The voxel at a point, world space, in the instance of the lowest index that has one there. `None` in air.
pub fn voxel_at(scene: &PackedScene, point: Vec3, left_out: Option<u32>) -> Option<(u32, IVec3)> {
    let nodes = &*scene.placement.instance_nodes;
    let mut stack = [0u32; MAX_INSTANCE_DEPTH];
    let mut depth = 0;
    let mut found: Option<(u32, IVec3)> = None;
    let mut next = (!nodes.is_empty()).then_some(0);
    while let Some(index) = next {
        let node = &nodes[index as usize];
        let mut after = None;
        if !contains(node, point) {
        } else if node.is_leaf == 0 {
            stack[depth] = node.index;
            depth += 1;
            after = Some(index + 1);
        } else if Some(node.index) != left_out
            && found.is_none_or(|(lowest, _)| node.index < lowest)
            && let Some(voxel) = voxel_in(scene, node.index, point)
        {
            found = Some((node.index, voxel));
        }
        next = after.or_else(|| {
            depth = depth.checked_sub(1)?;
            Some(stack[depth])
        });
    }
    found
}

fn contains(node: &InstanceNode, point: Vec3) -> bool {
    node.min.cmple(point).all() && point.cmple(node.max).all()
}

/// The occupied voxel of an instance at a point, world space.
fn voxel_in(scene: &PackedScene, instance: u32, point: Vec3) -> Option<IVec3> {
    let placed = &scene.placement.instances[instance as usize];
    let local = placed.grid_from_world.point(point);
    if !local.abs().cmple(Vec3::splat(MAX_ORIGIN)).all() {
        return None;
    }
    let voxel = local.floor().as_ivec3();
    let grid = &scene.geometry.grids[placed.grid as usize];
    scene.geometry.material_at(grid, voxel).map(|_| voxel)
}
