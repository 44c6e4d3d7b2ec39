//! Estimated normals of voxels of planes, spheres and sheets against those of the surfaces themselves.

use super::super::code::decode;
use super::*;
use voxtrace_scene::brick::{block_bit, block_index};

/// The occupancy of all voxels within `reach` of the origin whose middle is inside.
fn filled(reach: i32, is_inside: impl Fn(Vec3) -> bool) -> Occupancy {
    let mut bricks = Occupancy::default();
    let each = -reach..reach;
    for z in each.clone() {
        for y in each.clone() {
            for x in each.clone() {
                let voxel = IVec3::new(x, y, z);
                if is_inside(voxel.as_vec3() + 0.5) {
                    let local = voxel & 7;
                    bricks.entry(voxel >> 3).or_default()[block_index(local)] |= 1 << block_bit(local);
                }
            }
        }
    }
    bricks
}

fn is_occupied(bricks: &Occupancy, voxel: IVec3) -> bool {
    let local = voxel & 7;
    bricks.get(&(voxel >> 3)).is_some_and(|masks| masks[block_index(local)] >> block_bit(local) & 1 == 1)
}

/// Angles in degrees, in ascending order.
struct Errors(Vec<f32>);

impl Errors {
    /// Those between the codes of the voxels that are seen and the true normals at their middles, where `expected` gives one; of two-sided normals to
    /// the nearer side. Voxels without a normal count as 180.
    fn of(bricks: &Occupancy, expected: impl Fn(Vec3) -> Option<Vec3>) -> Self {
        let mut angles = Vec::new();
        for (at, codes) in normals_of(bricks) {
            let places = (0..512).map(|place| at * 8 + voxel_of(place / 64, (place % 64) as u32));
            for (voxel, code) in places.filter(|&voxel| is_occupied(bricks, voxel)).zip(codes) {
                let is_seen = FACES.iter().any(|face| !is_occupied(bricks, voxel + face.normal()));
                let Some(normal) = expected(voxel.as_vec3() + 0.5).filter(|_| is_seen) else {
                    assert!(is_seen || u32::from(code) == NO_NORMAL, "a hidden voxel has none");
                    continue;
                };
                let found = decode(code.into());
                let cos = found.along.as_vec3().normalize().dot(normal);
                let cos = if found.is_two_sided { cos.abs() } else { cos };
                let angle = cos.clamp(-1.0, 1.0).acos().to_degrees();
                angles.push(if u32::from(code) == NO_NORMAL { 180.0 } else { angle });
            }
        }
        angles.sort_by(f32::total_cmp);
        Self(angles)
    }

    fn mean(&self) -> f32 {
        self.0.iter().sum::<f32>() / self.0.len() as f32
    }

    fn largest(&self) -> f32 {
        self.0[self.0.len() - 1]
    }
}

const SLOPES: [(f32, f32); 8] =
    [(0.0, 0.02), (0.0, 0.05), (0.03, 0.1), (0.1, 0.2), (0.2, 0.3), (0.5, 0.3), (1.0, 0.0), (1.0, 1.0)];

#[test]
fn voxels_of_a_ball_have_the_normals_of_the_ball() {
    let middle = Vec3::new(0.3, 0.1, 0.2);
    for radius in [4.0f32, 6.0, 8.0, 12.0, 20.0] {
        let ball = filled(24, |p| (p - middle).length() < radius);
        let errors = Errors::of(&ball, |p| Some((p - middle).normalize()));
        let (mean, largest) = if radius < 6.0 { (2.5, 6.0) } else { (1.3, 4.0) };
        assert!(errors.mean() < mean && errors.largest() < largest, "{radius}: {} {}", errors.mean(), errors.largest());
        // As files of scans have them: without what nobody sees within.
        let shell = filled(24, |p| {
            let is_in = |p: Vec3| (p - middle).length() < radius;
            is_in(p) && FACES.iter().any(|face| !is_in(p + face.normal().as_vec3()))
        });
        let of_shell = Errors::of(&shell, |p| Some((p - middle).normalize()));
        assert_eq!(of_shell.0, errors.0, "a hollow ball is shaped as a whole one");
    }
    let ball = filled(24, |p| (p - middle).length() < 12.0);
    let elsewhere = Errors::of(&ball, |p| Some((p - middle - Vec3::X).normalize()));
    assert!(elsewhere.mean() > 3.0, "the comparison sees a ball that is moved by a voxel: {}", elsewhere.mean());
}

#[test]
fn voxels_of_a_slope_have_its_normal_however_gentle() {
    for (x, y) in SLOPES {
        let normal = Vec3::new(-x, -y, 1.0).normalize();
        let within = |p: Vec3| (p.abs().max_element() < 8.0).then_some(normal);
        let errors = Errors::of(&filled(48, |p| p.dot(normal) < 0.3), within);
        assert!(errors.mean() < 2.0 && errors.largest() < 2.5, "{x} {y}: {} {}", errors.mean(), errors.largest());
        // One voxel thick along an axis, as thin surfaces of meshes and clouds of points are.
        let half = 0.5 * normal.abs().max_element();
        let sheet = Errors::of(&filled(48, |p| (p.dot(normal) - 0.3).abs() < half), within);
        assert!(sheet.mean() < 5.0 && sheet.largest() < 13.0, "sheet {x} {y}: {} {}", sheet.mean(), sheet.largest());
    }
}

#[test]
fn single_voxels_and_rods_have_the_normals_of_their_faces() {
    for is_inside in [|p: Vec3| p == Vec3::splat(0.5), |p: Vec3| p.x == 0.5 && p.y == 0.5 && p.z.abs() < 20.0] {
        let codes = normals_of(&filled(24, is_inside));
        let middle = codes.iter().find(|(at, _)| *at == IVec3::ZERO).unwrap();
        assert!(middle.1.iter().all(|&code| u32::from(code) == NO_NORMAL), "{middle:?}");
    }
}

#[test]
fn normals_do_not_depend_on_where_tiles_begin() {
    let inside = |p: Vec3| p.dot(Vec3::new(0.3, -0.5, 0.8)) < 1.0 && p.length() < 20.0;
    let here = normals_of(&filled(24, inside));
    let moved = Vec3::new(8.0, -16.0, 24.0);
    let there = normals_of(&filled(56, |p| inside(p - moved)));
    let by_place = |found: Vec<(IVec3, Vec<u16>)>, moved: IVec3| {
        let mut found: Vec<_> = found.into_iter().map(|(at, codes)| ((at - moved).to_array(), codes)).collect();
        found.sort();
        found
    };
    assert!(by_place(here, IVec3::ZERO) == by_place(there, moved.as_ivec3() / 8));
}
