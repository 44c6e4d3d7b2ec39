//! Sets of rays that are hard on a walk: random, along axes, grazing faces, along edges and through corners, from
//! inside voxels.

use crate::random::Random;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Ray, VoxelGrid};

/// Names of the kinds that [`mixed`] cycles through.
pub const KINDS: [&str; 8] = [
    "random from outside",
    "random from inside",
    "along an axis",
    "along an axis, exactly on a plane or an edge",
    "grazing a face",
    "through a corner, rational direction",
    "in a diagonal plane, exactly through edges",
    "from inside a voxel",
];

/// `count` rays, the kind of ray `i` is `KINDS[i % 8]`.
pub fn mixed(grid: &VoxelGrid, count: usize, seed: u64) -> Vec<Ray> {
    let bounds = grid.bounds().expect("the grid holds a voxel");
    let voxels: Vec<IVec3> = grid.voxels().map(|(voxel, _)| voxel).collect();
    let mut random = Random(seed);
    (0..count).map(|i| one(&bounds, &voxels, i % KINDS.len(), &mut random)).collect()
}

fn one(bounds: &VoxelBox, voxels: &[IVec3], kind: usize, random: &mut Random) -> Ray {
    let (min, max) = (bounds.min.as_vec3(), bounds.max.as_vec3());
    let margin = (max - min) * 0.5 + 4.0;
    let inside = random.point(min, max);
    let target = voxels[random.below(voxels.len())];
    let axis = random.below(3);
    let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let along = Vec3::AXES[axis] * sign;
    match kind {
        0 => {
            let origin = random.point(min - margin, max + margin);
            Ray::new(origin, (inside - origin).normalize_or(Vec3::X))
        }
        1 => Ray::new(inside, random.direction()),
        2 => Ray::new(inside, along),
        3 => {
            let mut origin = random.voxel(bounds.min - 2, bounds.max + 2).as_vec3();
            if random.below(2) == 0 {
                origin[(axis + 1) % 3] += random.unit();
            }
            Ray::new(origin, along)
        }
        4 => {
            // Nearly within the plane of a face of an occupied voxel.
            let mut direction = random.direction();
            direction[axis] = sign * 10f32.powi(-(1 + random.below(7) as i32)) * random.unit();
            let mut through = target.as_vec3() + random.point(Vec3::ZERO, Vec3::ONE);
            through[axis] = target[axis] as f32 + random.below(2) as f32;
            Ray::new(through - direction * (random.unit() * 64.0), direction)
        }
        5 => {
            let direction = small_integers(random);
            let corner = target + random.voxel(IVec3::ZERO, IVec3::splat(2));
            let back = random.below(9) as i32;
            Ray::new((corner - direction * back).as_vec3(), direction.as_vec3())
        }
        6 => {
            let mut direction = small_integers(random);
            direction[axis] = 0;
            if direction == IVec3::ZERO {
                direction[(axis + 1) % 3] = 1;
            }
            let mut origin = (target - direction * random.below(9) as i32).as_vec3();
            origin[axis] += random.unit();
            Ray::new(origin, direction.as_vec3() * 0.375)
        }
        _ => Ray::new(target.as_vec3() + random.point(Vec3::ZERO, Vec3::ONE), random.direction()),
    }
}

/// A direction with components in −4..=4, not zero.
fn small_integers(random: &mut Random) -> IVec3 {
    loop {
        let direction = random.voxel(IVec3::splat(-4), IVec3::splat(5));
        if direction != IVec3::ZERO {
            return direction;
        }
    }
}
