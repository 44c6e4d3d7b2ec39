//! The reference: a brute-force grid traversal in double precision, voxel by voxel, over a dense bitmap. It shares no code with
//! the library's walk. Planes are crossed in order of t, computed by division; at equal t first x, then y, then z.

use voxtrace::glam::IVec3;
use voxtrace::{Ray, VoxelGrid};

/// A hit of the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceHit {
    /// The voxel.
    pub voxel: IVec3,
    /// Index of the face through which the ray's line enters.
    pub face: u32,
    /// Entry of the voxel, or `t_min` where that is later.
    pub t: f64,
}

/// A dense bitmap of a grid's voxels.
pub struct Bitmap {
    min: IVec3,
    size: IVec3,
    bits: Vec<u64>,
}

impl Bitmap {
    /// The bitmap of a grid that is not empty.
    pub fn of(grid: &VoxelGrid) -> Self {
        let bounds = grid.bounds().expect("the grid holds a voxel");
        let size = bounds.size();
        let count = size.to_array().iter().map(|&n| n as usize).product::<usize>();
        let mut bitmap = Self { min: bounds.min, size, bits: vec![0; count.div_ceil(64)] };
        for (voxel, _) in grid.voxels() {
            bitmap.flip(voxel);
        }
        bitmap
    }

    /// Flips one voxel inside the bounds.
    pub fn flip(&mut self, voxel: IVec3) {
        let index = self.index(voxel).expect("the voxel is inside the bounds");
        self.bits[index / 64] ^= 1 << (index % 64);
    }

    fn index(&self, voxel: IVec3) -> Option<usize> {
        let at = voxel - self.min;
        if at.cmplt(IVec3::ZERO).any() || at.cmpge(self.size).any() {
            return None;
        }
        Some((at.z as usize * self.size.y as usize + at.y as usize) * self.size.x as usize + at.x as usize)
    }

    /// Whether a voxel is occupied.
    pub fn contains(&self, voxel: IVec3) -> bool {
        self.index(voxel).is_some_and(|index| self.bits[index / 64] >> (index % 64) & 1 != 0)
    }

    /// The first occupied voxel on the segment of a ray.
    pub fn cast(&self, ray: &Ray) -> Option<ReferenceHit> {
        let origin = ray.origin.as_dvec3().to_array();
        let direction = ray.direction.as_dvec3().to_array();
        let t_min = f64::from(ray.t_min);
        let max = self.min + self.size;
        let mut voxel = [0i32; 3];
        for axis in 0..3 {
            voxel[axis] = (origin[axis] + t_min * direction[axis]).floor() as i32;
        }
        let time = |axis: usize, plane: i32| (f64::from(plane) - origin[axis]) / direction[axis];
        loop {
            if self.contains(IVec3::from_array(voxel)) {
                return Some(self.entry(voxel, &time, &direction, t_min));
            }
            let mut first: Option<(f64, usize)> = None;
            for axis in 0..3 {
                if direction[axis] == 0.0 {
                    continue;
                }
                let t = time(axis, voxel[axis] + i32::from(direction[axis] > 0.0));
                if first.is_none_or(|(earliest, _)| t < earliest) {
                    first = Some((t, axis));
                }
            }
            let (t, axis) = first?;
            if t > f64::from(ray.t_max) {
                return None;
            }
            voxel[axis] += if direction[axis] > 0.0 { 1 } else { -1 };
            let has_left = if direction[axis] > 0.0 { voxel[axis] >= max[axis] } else { voxel[axis] < self.min[axis] };
            if has_left {
                return None;
            }
        }
    }

    fn entry(
        &self,
        voxel: [i32; 3],
        time: &impl Fn(usize, i32) -> f64,
        direction: &[f64; 3],
        t_min: f64,
    ) -> ReferenceHit {
        let (mut latest, mut face) = (f64::NEG_INFINITY, 0);
        for axis in 0..3 {
            if direction[axis] == 0.0 {
                continue;
            }
            let is_negative = direction[axis] < 0.0;
            let t = time(axis, voxel[axis] + i32::from(is_negative));
            if t >= latest {
                latest = t;
                face = 2 * axis as u32 + u32::from(is_negative);
            }
        }
        ReferenceHit { voxel: IVec3::from_array(voxel), face, t: latest.max(t_min) }
    }
}
