//! Points that tell how far a set of boxes of voxels reaches in any direction: for each octant of directions those corners of boxes that no other
//! corner is beyond along all three axes. One of them is the farthest in a direction of that octant.

use crate::packed::PackedInstance;
use crate::packed::instances::margin_of;
use glam::{IVec3, Vec3};

/// More boxes than this count as the one around them.
const MOST_BOXES: usize = 512;

/// See the module.
#[derive(Debug)]
pub struct Hull {
    /// By octant: bit a is set for directions that are negative along axis a.
    corners: [Vec<Vec3>; 8],
}

impl Hull {
    /// That of boxes, of which there is one at least.
    pub fn of(boxes: impl ExactSizeIterator<Item = (IVec3, IVec3)> + Clone) -> Self {
        if boxes.len() > MOST_BOXES {
            let around = boxes.fold((IVec3::MAX, IVec3::MIN), |all, own| (all.0.min(own.0), all.1.max(own.1)));
            return Self::of([around].into_iter());
        }
        let corners = |octant: usize| {
            let is_negative = |axis: usize| octant >> axis & 1 == 1;
            // How far the corner of a box reaches along the octant.
            let mut reach: Vec<IVec3> = (boxes.clone())
                .map(|(min, max)| {
                    IVec3::from_array(std::array::from_fn(|axis| if is_negative(axis) { -min[axis] } else { max[axis] }))
                })
                .collect();
            // What is beyond another one has a larger sum.
            reach.sort_unstable_by_key(|corner| (-corner.element_sum(), corner.to_array()));
            let mut outer: Vec<IVec3> = Vec::new();
            for corner in reach {
                if !outer.iter().any(|other| other.cmpge(corner).all()) {
                    outer.push(corner);
                }
            }
            let sign = IVec3::from_array(std::array::from_fn(|axis| if is_negative(axis) { -1 } else { 1 }));
            outer.into_iter().map(|corner| (corner * sign).as_vec3()).collect()
        };
        Self { corners: std::array::from_fn(corners) }
    }

    /// The box around an instance of it, a little larger than exact, so that rounding cannot cut a hit off.
    pub fn world_box(&self, instance: &PackedInstance) -> (Vec3, Vec3) {
        let placed = &instance.world_from_grid;
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for axis in 0..3 {
            // The coordinate grows along this direction of the grid.
            let linear = &placed.linear;
            let direction = Vec3::new(linear.x_axis[axis], linear.y_axis[axis], linear.z_axis[axis]);
            let octant = (0..3).fold(0, |bits, axis| bits | usize::from(direction[axis] < 0.0) << axis);
            for corner in &self.corners[octant] {
                high[axis] = high[axis].max(placed.point(*corner)[axis]);
            }
            for corner in &self.corners[7 ^ octant] {
                low[axis] = low[axis].min(placed.point(*corner)[axis]);
            }
        }
        let margin = margin_of(instance, low, high);
        (low - margin, high + margin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Mat3;
    use voxtrace_scene::transform::Transform;

    #[test]
    fn a_world_box_holds_all_boxes_and_is_tight() {
        let boxes: Vec<(IVec3, IVec3)> = (0..40)
            .map(|i: i32| {
                let min = IVec3::new(i * 7919 % 23, i * 104_729 % 19, i * 31 % 29) - 9;
                (min, min + 1 + IVec3::new(i % 5, i % 3, i % 7))
            })
            .collect();
        let hull = Hull::of(boxes.iter().copied());
        for turn in 0..30 {
            let linear = Mat3::from_euler(glam::EulerRot::XYZ, turn as f32, turn as f32 * 0.7, turn as f32 * 0.3);
            let mirror = Mat3::from_diagonal(Vec3::new(if turn % 2 == 0 { -1.0 } else { 1.0 }, 1.0, 1.0));
            let transform = Transform { linear: linear * mirror * 1.3, translation: Vec3::new(3.0, -70.0, 11.0) };
            let instance = PackedInstance::new(0, transform, 0);
            let (low, high) = hull.world_box(&instance);
            let (mut least, mut most) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            for (min, max) in &boxes {
                for corner in 0..8 {
                    let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                    let point = transform.point((*min + (*max - *min) * pick).as_vec3());
                    (least, most) = (least.min(point), most.max(point));
                }
            }
            assert!(low.cmplt(least).all() && high.cmpgt(most).all(), "turn {turn}");
            assert!((least - low).max(high - most).max_element() < 2e-3, "turn {turn}");
        }
        // Corners within others are left out.
        assert!(hull.corners.iter().all(|corners| corners.len() < 30));
    }
}
