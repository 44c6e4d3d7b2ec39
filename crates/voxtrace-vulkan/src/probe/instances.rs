//! P7: one structure placed many times, translated, turned, mirrored, scaled and sheared, against the same boxes where double
//! precision puts them.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::lab::Lab;
use super::model::{Bottom, IDENTITY, Model, Placed};
use super::reference::{Expected, Segment};
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::{DMat3, DVec3, Mat3, Vec3};
use voxtrace_core::TraceError;

/// Boxes along an edge of the structure.
const SIZE: i32 = 3;
/// Distance of neighbours.
const APART: f32 = 16.0;

fn rows(linear: Mat3, translation: Vec3) -> [f32; 12] {
    std::array::from_fn(|i| if i % 4 == 3 { translation[i / 4] } else { linear.col(i % 4)[i / 4] })
}

fn linear(index: usize, random: &mut Random) -> Mat3 {
    let turned = Mat3::from_axis_angle(random.direction(), random.unit() * 6.0);
    let (mirror, stretch) = (Vec3::new(-1.0, 1.0, 1.0), Vec3::new(2.0, 0.5, 1.25));
    match index % 6 {
        0 => Mat3::IDENTITY,
        1 => turned,
        2 => Mat3::from_diagonal(mirror),
        3 => turned * Mat3::from_diagonal(mirror) * 0.37,
        4 => turned * Mat3::from_diagonal(stretch),
        _ => Mat3::from_cols(Vec3::X, Vec3::new(0.75, 1.0, 0.0), Vec3::new(-0.25, 0.5, 1.0)) * turned,
    }
}

/// The ray as an instance sees it, in double precision.
fn in_object(ray: &Segment, transform: &[f32; 12]) -> Segment {
    let wide = |row: usize, column: usize| f64::from(transform[4 * row + column]);
    let linear = DMat3::from_cols_array_2d(&std::array::from_fn(|c| std::array::from_fn(|r| wide(r, c))));
    let inverse = linear.inverse();
    let translation = DVec3::new(wide(0, 3), wide(1, 3), wide(2, 3));
    Segment { origin: inverse * (ray.origin - translation), direction: inverse * ray.direction, ..*ray }
}

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    // As many along an edge, 6 to 1,000 instances.
    let (edge, count) = effort.pick((10, 512), (10, 8192));
    let mut random = Random(7);
    // Apart from each other: merging is for other probes.
    let boxes: Vec<Aabb> = block(SIZE).into_iter().map(|aabb| aabb.inset(0.125)).collect();
    let instances: Vec<Placed> = (0..edge * edge * edge)
        .map(|index| {
            let cell = Vec3::new((index % edge) as f32, (index / edge % edge) as f32, (index / edge / edge) as f32);
            let transform = match index {
                0 => IDENTITY,
                _ => rows(linear(index, &mut random), cell * APART + random.point(Vec3::ZERO, Vec3::ONE)),
            };
            Placed { bottom: 0, transform, mask: 0xff }
        })
        .collect();
    let aimed = |random: &mut Random| {
        let transform = &instances[random.below(instances.len())].transform;
        let inside = random.point(Vec3::ZERO, Vec3::splat(SIZE as f32));
        let row = |row: usize| Vec3::from_slice(&transform[4 * row..]).dot(inside) + transform[4 * row + 3];
        let (target, direction) = (Vec3::new(row(0), row(1), row(2)), random.direction());
        ray(target - direction * (10.0 + 40.0 * random.unit()), direction)
    };
    let rays: Vec<ProbeRay> = (0..count).map(|_| aimed(&mut random)).collect();
    // The inverse of a transform in single precision, at 200 units, and less than half the size.
    let margin = Segment::margin(f64::from(APART) * edge as f64 * 8.0);
    let near = |ray: &ProbeRay| {
        let segment = Segment::from(ray);
        let mut expected = Expected::new(&segment, std::iter::empty(), margin);
        for (index, placed) in instances.iter().enumerate() {
            let local = in_object(&segment, &placed.transform);
            let whole = Aabb::new(Vec3::ZERO, Vec3::splat(SIZE as f32));
            if local.span(&whole, 2.0 * margin).is_some() {
                expected.add(&local, boxes.iter().enumerate().map(|(id, aabb)| ((index, id), aabb)), margin);
            }
        }
        expected
    };
    let expected: Vec<Expected<(usize, usize)>> = rays.iter().map(near).collect();
    let built = lab.build(&Model { bottoms: vec![Bottom::of(boxes.clone())], instances: instances.clone() })?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let answers = lab.cast(&built, traversal, &rays, Reports::Exact, 0)?.answers;
        let is_wrong = |(expected, answer): &(&Expected<(usize, usize)>, &crate::records::ProbeAnswer)| {
            !expected.accepts_answer(answer, (answer.instance as usize, answer.primitive as usize))
        };
        let wrong = expected.iter().zip(&answers).filter(is_wrong).count() as u64;
        let says = match wrong {
            0 => format!("{} instances of every kind are where they should be", instances.len()),
            wrong => format!("{wrong} of {count} rays at instances come out wrong"),
        };
        findings.push(Finding::judged(traversal, count as u64, wrong, says));
    }
    Ok(findings)
}
