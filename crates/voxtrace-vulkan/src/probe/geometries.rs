//! P14: several geometries in one structure. P15: boxes in the same place and within each other, which all are candidates.

use super::Effort;
use super::boxes::Aabb;
use super::lab::Lab;
use super::model::{Bottom, BuildFlags, Model, Treatment};
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::{ProbeAnswer, ProbeRay};
use glam::{IVec3, Vec3};
use std::collections::BTreeSet;
use voxtrace_core::TraceError;

/// Geometry g has g + 1 boxes.
pub fn several(lab: &mut Lab, _: Effort) -> Result<Vec<Finding>, TraceError> {
    let place = |geometry: i32, primitive: i32| IVec3::new(2 * primitive, 3 * geometry, 0);
    let all: Vec<(i32, i32)> = (0..8).flat_map(|g| (0..=g).map(move |p| (g, p))).collect();
    let geometries = (0..8).map(|g| (0..=g).map(|p| Aabb::cell(place(g, p))).collect()).collect();
    let bottom = Bottom { geometries, flags: BuildFlags::PREFER_FAST_TRACE, treatment: Treatment::Built };
    let built = lab.build(&Model::of(vec![bottom]))?;
    let towards = |&(g, p): &(i32, i32)| ray(place(g, p).as_vec3() + Vec3::new(0.5, 0.5, -4.0), Vec3::Z);
    let rays: Vec<ProbeRay> = all.iter().map(towards).collect();
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let answers = lab.cast(&built, traversal, &rays, Reports::Exact, 0)?.answers;
        let is_wrong = |((g, p), answer): &(&(i32, i32), &ProbeAnswer)| {
            (answer.is_hit, answer.geometry, answer.primitive) != (1, *g as u32, *p as u32)
        };
        let wrong = all.iter().zip(&answers).filter(is_wrong).count() as u64;
        let says = match wrong {
            0 => "geometries and their boxes keep their numbers".to_owned(),
            wrong => format!("{wrong} of {} boxes come out under other numbers", all.len()),
        };
        findings.push(Finding::judged(traversal, all.len() as u64, wrong, says));
    }
    Ok(findings)
}

/// Three boxes in each of four places, and eight around each other.
pub fn coincident(lab: &mut Lab, _: Effort) -> Result<Vec<Finding>, TraceError> {
    let same = (0..12).map(|index| Aabb::cell(IVec3::new(20 * (index / 3), 0, 0)));
    let nested = (0..8)
        .map(|index| Aabb::new(Vec3::new(0.0, 40.0, 0.0) - index as f32, Vec3::new(1.0, 41.0, 1.0) + index as f32));
    let boxes: Vec<Aabb> = same.chain(nested).collect();
    let rays: Vec<ProbeRay> = [[0, 0], [20, 0], [40, 0], [60, 0], [0, 40]]
        .map(|[x, y]: [i32; 2]| ray([x as f32 + 0.4, y as f32 + 0.6, -20.0], [0.0, 0.0, 1.0]))
        .to_vec();
    let wanted: Vec<BTreeSet<u32>> = (0..5u32)
        .map(|index| if index < 4 { (3 * index..3 * index + 3).collect() } else { (12..20).collect() })
        .collect();
    let built = lab.build(&Model::single(boxes.clone()))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let answers = lab.cast(&built, traversal, &rays, Reports::Nothing, 64)?;
        let missing = |(index, wanted): (usize, &BTreeSet<u32>)| {
            let seen: BTreeSet<u32> = answers.candidates(index).iter().copied().collect();
            wanted.difference(&seen).count() as u64
        };
        let missing: u64 = wanted.iter().enumerate().map(missing).sum();
        let says = match missing {
            0 => "every one of the boxes in one place is a candidate".to_owned(),
            missing => format!("{missing} of {} boxes that share their place give no candidate", boxes.len()),
        };
        findings.push(Finding::judged(traversal, boxes.len() as u64, missing, says));
    }
    Ok(findings)
}
