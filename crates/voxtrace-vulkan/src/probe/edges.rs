//! P3: rays in the planes between boxes, along edges and through corners of a solid block. Inside nothing may leak; of the
//! outer hull nothing is promised.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::lab::Lab;
use super::model::Model;
use super::reference::Segment;
use super::report::Finding;
use super::shot::{Reports, ray};
use glam::Vec3;
use voxtrace_core::TraceError;

const SIZE: i32 = 8;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (count, mut random) = (effort.pick(512, 16384), Random(3));
    let hull = Aabb::new(Vec3::ZERO, Vec3::splat(SIZE as f32));
    let (mut inside, mut on_hull) = (Vec::new(), Vec::new());
    while inside.len() < count {
        // Through a corner of the lattice, in a direction of small whole numbers: in faces, along edges, along diagonals.
        let corner: Vec3 = Vec3::from_array(std::array::from_fn(|_| random.below(SIZE as usize + 1) as f32));
        let direction = Vec3::from_array(std::array::from_fn(|_| random.below(5) as f32 - 2.0));
        if direction == Vec3::ZERO {
            continue;
        }
        let ray = ray(corner - direction * 16.0, direction);
        let segment = Segment::from(&ray);
        match (segment.span(&hull, -0.01), segment.span(&hull, 0.0)) {
            (Some(_), Some((enter, _))) => inside.push((ray, enter)),
            (None, Some((enter, _))) if on_hull.len() < count / 4 => on_hull.push((ray, enter)),
            _ => {}
        }
    }
    let built = lab.build(&Model::single(block(SIZE)))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let mut hits = |rays: &[_]| {
            let given: Vec<_> = rays.iter().map(|(ray, _)| *ray).collect();
            let answers = lab.cast(&built, traversal, &given, Reports::Exact, 0)?.answers;
            let is_there = |(answer, (_, enter)): (&crate::records::ProbeAnswer, &(_, f64))| {
                answer.is_hit == 1 && (f64::from(answer.t) - enter).abs() < 1e-4
            };
            let met = answers.iter().zip(rays).filter(|pair| is_there(*pair)).count() as u64;
            Ok::<u64, TraceError>(met)
        };
        let (met, met_on_hull) = (hits(&inside)?, hits(&on_hull)?);
        let (rays, on_hull) = (inside.len() as u64, on_hull.len() as u64);
        let leaks = rays - met;
        let says = match leaks {
            0 => format!("no leak between boxes; {met_on_hull} of {on_hull} rays in the outer faces are hits"),
            leaks => format!("{leaks} of {rays} rays between boxes leak"),
        };
        findings.push(
            Finding::judged(traversal, rays, leaks, says)
                .with("rays in the hull", on_hull)
                .with("hits in the hull", met_on_hull),
        );
    }
    Ok(findings)
}
