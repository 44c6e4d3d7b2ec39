//! The first hit in what planes keep, by brute force in double precision.

use super::{cut, grey};
use voxtrace::cuts::Cuts;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::{CpuTracer, Hit, Ray, Scene, Tracer};
use voxtrace_tests::gpu::compare_hits;
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_tests::scenes::noise;

/// The first hit of a ray by brute force in double precision: entry into the region, then the nearest voxel. `None` where it cannot be
/// told from another for rounding.
fn judged(voxels: &[IVec3], planes: &[(DVec3, f64)], ray: &Ray) -> Option<Hit> {
    const UNSURE: f64 = 2e-3;
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let speed = direction.length();
    let (mut enter, mut leave, mut by) = (f64::from(ray.t_min), f64::from(ray.t_max), None);
    for (index, &(normal, offset)) in planes.iter().enumerate() {
        let (along, ahead) = (normal.dot(direction), offset - normal.dot(origin));
        if along.abs() < 1e-4 * speed {
            return None;
        }
        let t = ahead / along;
        if (t - enter).abs() * speed < UNSURE {
            return None;
        }
        if along < 0.0 && t > enter {
            (enter, by) = (t, Some(index as u32));
        } else if along > 0.0 {
            leave = leave.min(t);
        }
    }
    if (leave - enter).abs() * speed < UNSURE {
        return None;
    }
    if leave < enter {
        return Some(Hit::MISS);
    }
    let (mut nearest, mut second) = (Hit::MISS, f64::INFINITY);
    let mut first = f64::INFINITY;
    for &voxel in voxels {
        let (mut t_in, mut t_out, mut face) = (f64::NEG_INFINITY, f64::INFINITY, 0);
        for axis in 0..3 {
            if direction[axis] == 0.0 {
                // In the cell of its coordinate, or never.
                if origin[axis].floor() as i32 != voxel[axis] {
                    t_out = f64::NEG_INFINITY;
                }
                continue;
            }
            let times = [0, 1].map(|side| (f64::from(voxel[axis] + side) - origin[axis]) / direction[axis]);
            let (near, far) = (times[0].min(times[1]), times[0].max(times[1]));
            // At equal times the highest axis counts.
            if near > t_in - 1e-12 * t_in.abs() {
                (t_in, face) = (near, 2 * axis as u32 + u32::from(direction[axis] < 0.0));
            }
            t_out = t_out.min(far);
        }
        let t = t_in.max(enter);
        let length = (t_out.min(leave) - t) * speed;
        if length <= -UNSURE || length.is_nan() {
            continue;
        }
        // A voxel that is only brushed, or in which the part just begins: rounding says.
        if length < UNSURE || (t_in - enter).abs() * speed < UNSURE {
            second = second.min(t);
            continue;
        }
        if t < first {
            let cut = by.filter(|_| t_in < enter).map(|plane| Hit::FIRST_CUT + 2 * plane);
            (second, first) = (second.min(first), t);
            nearest = Hit { t: t as f32, instance: 0, voxel, face: cut.unwrap_or(face) };
        } else {
            second = second.min(t);
        }
    }
    let is_sure = if nearest.is_miss() { second.is_infinite() } else { (second - first) * speed > UNSURE };
    is_sure.then_some(nearest)
}

/// How many rays were judged, and how many of them the walk answers otherwise, where the judge sees the planes moved by `fault`.
fn disagreements(cuts: &Cuts, fault: f64) -> (usize, usize) {
    let grid = noise(IVec3::splat(-7), 14, 0.15, 20, 5);
    let voxels: Vec<IVec3> = grid.voxels().map(|(voxel, _)| voxel).collect();
    let materials = vec![grey(); 1 + usize::from(grid.voxels().map(|(_, material)| material).max().unwrap_or(0))];
    let scene = cut(&Scene::from_grid("noise", grid.clone(), materials), cuts);
    let planes: Vec<_> =
        cuts.planes().iter().map(|plane| (plane.normal().as_dvec3(), f64::from(plane.edge()) + fault)).collect();
    let rays = mixed(&grid, 4000, 3);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene).unwrap();
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(&rays, &mut hits).unwrap();
    let single: Vec<Hit> = rays.iter().map(|ray| scene.cast(ray).unwrap_or(Hit::MISS)).collect();
    compare_hits(&rays, &hits, &single).unwrap();
    let (mut judged_rays, mut wrong) = (0, 0);
    for (ray, hit) in rays.iter().zip(&hits) {
        let Some(expected) = judged(&voxels, &planes, ray) else { continue };
        judged_rays += 1;
        let same = (hit.instance, hit.voxel, hit.face) == (expected.instance, expected.voxel, expected.face);
        let near = hit.is_miss() || (hit.t - expected.t).abs() * ray.direction.length() < 1e-3;
        wrong += usize::from(!same || !near);
    }
    (judged_rays, wrong)
}

#[test]
fn hits_in_what_random_planes_keep_are_those_of_a_brute_force_in_double_precision() {
    let mut random = Random(41);
    let (mut judged_rays, mut seen) = (0, 0);
    for index in 0..12 {
        let mut cuts = Cuts::default();
        for _ in 0..1 + index % 4 {
            cuts = cuts.plane(random.direction(), random.unit() * 6.0).unwrap();
        }
        if index % 3 == 0 {
            cuts = cuts.clip_box(random.point(Vec3::splat(-6.0), Vec3::splat(-1.0)), Vec3::splat(4.0)).unwrap();
        }
        let (rays, wrong) = disagreements(&cuts, 0.0);
        assert_eq!(wrong, 0, "of {rays} rays: {cuts:?}");
        judged_rays += rays;
        seen += disagreements(&cuts, 0.01).1;
    }
    assert!(judged_rays > 24_000 && seen > 500, "{judged_rays} rays, a hundredth of a voxel seen by {seen}");
}
