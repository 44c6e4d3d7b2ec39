//! Decisions that must be right: which plane a ray crosses first, and the hit of a voxel. All comparisons are of
//! products of exact differences in f64, so equal times compare as equal.

use super::local_ray::LocalRay;
use glam::IVec3;
use voxtrace_scene::ray::Hit;

/// When a ray crosses a plane: the fraction `distance / speed`, both ≥ 0 for planes ahead, and the axis, which breaks
/// ties.
#[derive(Clone, Copy)]
struct Crossing {
    distance: f64,
    speed: f64,
    axis: usize,
}

impl Crossing {
    /// The crossing of the plane `coordinate = plane` of an axis along which the ray moves.
    fn of(ray: &LocalRay, axis: usize, plane: i32) -> Self {
        let sign = if ray.direction[axis] < 0.0 { -1.0 } else { 1.0 };
        let distance = (f64::from(plane) - f64::from(ray.origin[axis])) * sign;
        Self { distance, speed: f64::from(ray.direction[axis]).abs(), axis }
    }

    /// Whether this crossing comes before another one: earlier, or at the same time on a lower axis.
    fn is_before(&self, other: &Self) -> bool {
        let (ours, theirs) = (self.distance * other.speed, other.distance * self.speed);
        ours < theirs || (ours == theirs && self.axis < other.axis)
    }
}

/// The voxel that holds the ray's first point, at `t_min`.
pub fn start_voxel(ray: &LocalRay) -> IVec3 {
    let mut voxel = IVec3::ZERO;
    for axis in 0..3 {
        // The product is exact in f64 and the sum is as near as f64 comes.
        let position = f64::from(ray.origin[axis]) + f64::from(ray.t_min) * f64::from(ray.direction[axis]);
        voxel[axis] = position.floor() as i32;
    }
    voxel
}

/// The voxel in which the ray arrives when it leaves a box through the first of the planes `exit`, which it has all
/// still ahead, or `None` where it crosses none of them. `voxel` is where it is now.
#[cold]
pub fn leave_box(ray: &LocalRay, voxel: IVec3, exit: IVec3) -> Option<IVec3> {
    let moving = (0..3).filter(|&axis| ray.direction[axis] != 0.0);
    let first = moving
        .clone()
        .map(|axis| Crossing::of(ray, axis, exit[axis]))
        .reduce(|first, other| if other.is_before(&first) { other } else { first })?;
    let mut arrival = voxel;
    for axis in moving {
        let is_negative = ray.direction[axis] < 0.0;
        if axis == first.axis {
            arrival[axis] = exit[axis] - i32::from(is_negative);
            continue;
        }
        let speed = f64::from(ray.direction[axis]);
        let position = f64::from(ray.origin[axis]) + first.distance / first.speed * speed;
        let nearest = position.round();
        let cell = if (position - nearest).abs() > 1e-5 {
            position.floor() as i32
        } else {
            let plane = nearest as i32;
            let is_crossed = Crossing::of(ray, axis, plane).is_before(&first);
            // On a positive axis the ray is beyond the plane once it crossed it, on a negative one below it.
            plane - i32::from(is_crossed == is_negative)
        };
        // A plane that the ray starts on counts as crossed where the start voxel lies beyond it: never go back.
        arrival[axis] = if is_negative { cell.min(voxel[axis]) } else { cell.max(voxel[axis]) };
    }
    Some(arrival)
}

/// The voxel that a ray enters when it leaves `voxel`, which lies on its path: through the first of the three planes ahead, at equal times
/// that of the lowest axis.
pub fn next_voxel(ray: &LocalRay, voxel: IVec3) -> IVec3 {
    let ahead = |axis: usize| voxel[axis] + i32::from(ray.direction[axis] >= 0.0);
    let first = (0..3)
        .filter(|&axis| ray.direction[axis] != 0.0)
        .map(|axis| Crossing::of(ray, axis, ahead(axis)))
        .reduce(|first, other| if other.is_before(&first) { other } else { first });
    // A local ray moves along one axis at least.
    let axis = first.map_or(0, |first| first.axis);
    let mut next = voxel;
    next[axis] += if ray.direction[axis] < 0.0 { -1 } else { 1 };
    next
}

/// The hit of a voxel that lies on the ray's path: the face is that of the last plane that the ray crosses on its way
/// into the voxel (at equal times the highest axis, which is crossed last), `t` the time of that crossing or `t_min`
/// where that was before.
pub fn hit_of(ray: &LocalRay, voxel: IVec3, instance: u32) -> Hit {
    let entry = |axis: usize| voxel[axis] + i32::from(ray.direction[axis] < 0.0);
    let mut last: Option<Crossing> = None;
    for axis in 0..3 {
        if ray.direction[axis] != 0.0 {
            let crossing = Crossing::of(ray, axis, entry(axis));
            last = last.filter(|last| crossing.is_before(last)).or(Some(crossing));
        }
    }
    // A local ray moves along one axis at least.
    let axis = last.map_or(0, |last| last.axis);
    let t = (entry(axis) as f32 - ray.origin[axis]) * ray.inverse[axis];
    let face = 2 * axis as u32 + u32::from(ray.direction[axis] < 0.0);
    // Not `max`, which may return either zero of −0 and 0.
    Hit { t: if t > ray.t_min { t } else { ray.t_min }, instance, voxel, face }
}
