//! Rays through the whole scene: instance after instance, nearest boxes first.

use super::exact;
use super::local_ray::LocalRay;
use super::scalar::first_voxel;
use crate::cuts;
use crate::packed::{InstanceNode, MAX_INSTANCE_DEPTH, PackedScene};
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Finds the first hit of a ray in what cuts keep. Of hits at the same t the one of the lowest instance counts.
pub fn cast(scene: &PackedScene, ray: &Ray) -> Hit {
    match scene.cuts.is_none() {
        true => cast_whole(scene, ray),
        false => cuts::cast(scene, ray, true),
    }
}

/// As [`cast`], in the whole scene.
pub fn cast_whole(scene: &PackedScene, ray: &Ray) -> Hit {
    cast_below(scene, ray, u32::MAX)
}

/// As [`cast_whole`], among the instances of an index below `end`.
pub fn cast_below(scene: &PackedScene, ray: &Ray, end: u32) -> Hit {
    let mut nearest = Hit::MISS;
    let mut ray = *ray;
    visit(scene, &mut ray, end, |hit, ray| {
        if hit.t < nearest.t || (hit.t == nearest.t && hit.instance < nearest.instance) {
            nearest = hit;
            ray.t_max = hit.t;
        }
        true
    });
    nearest
}

/// Whether anything of the whole scene lies on the segment of a ray.
pub fn occluded(scene: &PackedScene, ray: &Ray) -> bool {
    let mut is_blocked = false;
    visit(scene, &mut ray.clone(), u32::MAX, |_, _| {
        is_blocked = true;
        false
    });
    is_blocked
}

/// Calls `found` for the hit in each instance of an index below `end` that the ray's segment meets, until it returns false. `found` may
/// shorten the segment.
fn visit(scene: &PackedScene, ray: &mut Ray, end: u32, mut found: impl FnMut(Hit, &mut Ray) -> bool) {
    let mut instances = Nearby::new(scene, ray);
    while let Some(instance) = instances.next(scene, ray) {
        if instance < end
            && let Some(hit) = hit_in(scene, instance, ray)
            && !found(hit, ray)
        {
            return;
        }
    }
}

/// The instances whose boxes a ray's segment meets, nearest boxes first.
struct Nearby {
    inverse: Vec3,
    stack: [u32; MAX_INSTANCE_DEPTH],
    depth: usize,
    /// The node to look at, before those that wait.
    next: Option<u32>,
}

impl Nearby {
    /// Those of a ray.
    #[inline]
    fn new(scene: &PackedScene, ray: &Ray) -> Self {
        let next = (!scene.placement.instance_nodes.is_empty()).then_some(0);
        Self { inverse: Vec3::ONE / ray.direction, stack: [0; MAX_INSTANCE_DEPTH], depth: 0, next }
    }

    /// The next one, of the ray's segment as it is now.
    #[inline]
    fn next(&mut self, scene: &PackedScene, ray: &Ray) -> Option<u32> {
        let nodes = &*scene.placement.instance_nodes;
        loop {
            let index = self.next.take().or_else(|| self.pop(nodes, ray))?;
            let node = &nodes[index as usize];
            if node.is_leaf == 1 {
                return Some(node.index);
            }
            let (left, right) = (index + 1, node.index);
            let reach = |child: u32| entry(&nodes[child as usize], ray, self.inverse);
            self.next = match (reach(left), reach(right)) {
                (Some(a), Some(b)) => {
                    let (near, far) = if a <= b { (left, right) } else { (right, left) };
                    self.stack[self.depth] = far;
                    self.depth += 1;
                    Some(near)
                }
                (Some(_), None) => Some(left),
                (None, Some(_)) => Some(right),
                (None, None) => None,
            };
        }
    }

    /// The nearest of the nodes that wait, without those that lie behind what was found since.
    #[inline]
    fn pop(&mut self, nodes: &[InstanceNode], ray: &Ray) -> Option<u32> {
        while let Some(depth) = self.depth.checked_sub(1) {
            self.depth = depth;
            let index = self.stack[depth];
            if entry(&nodes[index as usize], ray, self.inverse).is_some() {
                return Some(index);
            }
        }
        None
    }
}

/// The hit of the ray's segment in one instance.
fn hit_in(scene: &PackedScene, instance: u32, ray: &Ray) -> Option<Hit> {
    let placed = &scene.placement.instances[instance as usize];
    let geometry = &*scene.geometry;
    let local = LocalRay::new(ray, &placed.grid_from_world)?;
    let voxel = first_voxel(geometry, &geometry.grids[placed.grid as usize], &local)?;
    let hit = exact::hit_of(&local, voxel, instance);
    (hit.t <= ray.t_max).then_some(hit)
}

/// Where the segment enters a node's box (with the margin that the box has), `None` where it misses it.
#[inline(always)]
pub(super) fn entry(node: &InstanceNode, ray: &Ray, inverse: Vec3) -> Option<f32> {
    let (low, high) = ((node.min - ray.origin) * inverse, (node.max - ray.origin) * inverse);
    // 0 × ∞ where the origin lies on a side of the box that the ray runs along: f32::min and max drop the NaN.
    let (mut enter, mut leave) = (ray.t_min, ray.t_max);
    for axis in 0..3 {
        enter = enter.max(low[axis].min(high[axis]));
        leave = leave.min(low[axis].max(high[axis]));
    }
    (enter <= leave).then_some(enter)
}
