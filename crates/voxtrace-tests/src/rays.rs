//! Sets of rays that are difficult for a walk: random, axis-parallel, grazing faces, along edges, through corners, and from
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

/// Number of rays in a fan: consecutive rays with one origin.
pub const FAN: usize = 64;

/// Names of the kinds that [`fans`] cycles through.
pub const FAN_KINDS: [&str; 10] = [
    "narrow, from outside",
    "narrow, from inside",
    "wide",
    "around an axis, in all octants",
    "grazing a face",
    "from a corner, rational directions",
    "of any length, with an end",
    "in all directions",
    "narrow, segments that begin at one t",
    "narrow, segments that begin anywhere",
];

/// `count` rays in fans, the kind of fan `i` is `FAN_KINDS[i % FAN_KINDS.len()]`.
pub fn fans(grid: &VoxelGrid, count: usize, seed: u64) -> Vec<Ray> {
    let bounds = grid.bounds().expect("the grid holds a voxel");
    let voxels: Vec<IVec3> = grid.voxels().map(|(voxel, _)| voxel).collect();
    let mut random = Random(seed);
    let fan = |i: usize| fan(&bounds, &voxels, i % FAN_KINDS.len(), &mut random);
    (0..count / FAN).flat_map(fan).collect()
}

fn fan(bounds: &VoxelBox, voxels: &[IVec3], kind: usize, random: &mut Random) -> [Ray; FAN] {
    let (min, max) = (bounds.min.as_vec3(), bounds.max.as_vec3());
    let margin = (max - min) * 0.5 + 4.0;
    let target = voxels[random.below(voxels.len())];
    let axis = random.below(3);
    let mut origin = match kind {
        0 | 6 | 8 | 9 => random.point(min - margin, max + margin),
        4 => target.as_vec3() + random.direction() * 32.0,
        5 => (target + random.voxel(IVec3::splat(-9), IVec3::splat(10))).as_vec3(),
        _ => random.point(min, max),
    };
    if random.below(4) == 0 {
        origin = origin.round();
    }
    let towards = (target.as_vec3() + 0.5 - origin).normalize_or(Vec3::X);
    let width = 4f32.powi(-(random.below(7) as i32));
    let begin = random.unit() * (target.as_vec3() - origin).length();
    std::array::from_fn(|_| match kind {
        0 | 1 => Ray::new(origin, (towards + random.direction() * 0.05 * width).normalize()),
        2 => Ray::new(origin, (towards + random.direction() * 0.7).normalize()),
        3 => Ray::new(origin, Vec3::AXES[axis] + random.direction() * width * width),
        4 => {
            let mut direction = towards + random.direction() * 0.1;
            direction[axis] *= 10f32.powi(-(1 + random.below(7) as i32));
            Ray::new(origin, direction)
        }
        5 => Ray::new(origin, small_integers(random).as_vec3()),
        6 => {
            let length = 10f32.powi(random.below(7) as i32 - 3);
            let direction = (towards + random.direction() * 0.05).normalize() * length;
            Ray { t_max: random.unit() * 100.0 / length, ..Ray::new(origin, direction) }
        }
        7 => Ray::new(origin, random.direction()),
        _ => {
            let t_min = if kind == 8 { begin } else { begin * 2.0 * random.unit() };
            Ray { t_min, ..Ray::new(origin, (towards + random.direction() * 0.05 * width).normalize()) }
        }
    })
}

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
