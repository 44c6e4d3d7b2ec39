//! P16: candidates that come twice, and those that the ray does not touch. Both are allowed; the second kind is what makes
//! the study's approximate method wrong without any merging.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::grids::rays_through;
use super::lab::Lab;
use super::model::Model;
use super::reference::{Expected, Segment, cells_near};
use super::report::{Finding, Outcome};
use super::shot::Reports;
use crate::records::ProbeRay;
use std::collections::BTreeSet;
use voxtrace_core::TraceError;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (size, count) = effort.pick((12, 1024), (32, 16384));
    let mut random = Random(16);
    let solid = block(size);
    // A surface as scans have it: mostly air, boxes that touch.
    let is_there: Vec<bool> = (0..solid.len()).map(|_| random.unit() < 0.25).collect();
    let ids: Vec<usize> = (0..solid.len()).filter(|&cell| is_there[cell]).collect();
    let boxes: Vec<Aabb> = ids.iter().map(|&cell| solid[cell]).collect();
    let primitive_of = |cell: usize| ids.binary_search(&cell).ok();
    let rays = rays_through(size, count, &mut random);
    let margin = Segment::margin(f64::from(4 * size));
    let expect = |ray: &ProbeRay| {
        let ray = Segment::from(ray);
        let near = cells_near(&ray, size, margin).into_iter();
        Expected::new(&ray, near.filter_map(|cell| Some((primitive_of(cell)?, &solid[cell]))), margin)
    };
    let expected: Vec<Expected<usize>> = rays.iter().map(expect).collect();
    let built = lab.build(&Model::single(boxes))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let logged = lab.cast(&built, traversal, &rays, Reports::Nothing, 16 * size as usize)?;
        let centre = lab.cast(&built, traversal, &rays, Reports::Centre, 0)?.answers;
        let (mut candidates, mut repeats, mut untouched, mut wrong) = (0u64, 0u64, 0u64, 0u64);
        for (index, expected) in expected.iter().enumerate() {
            let all = logged.candidates(index);
            let distinct: BTreeSet<u32> = all.iter().copied().collect();
            candidates += all.len() as u64;
            repeats += (all.len() - distinct.len()) as u64;
            untouched += distinct.iter().filter(|&&id| !expected.may_meet(id as usize)).count() as u64;
            let hit = (centre[index].is_hit == 1).then_some(centre[index].primitive as usize);
            wrong += u64::from(!expected.accepts(hit));
        }
        let says = format!(
            "of {candidates} candidates {untouched} are boxes that the ray does not touch and {repeats} come again; the study's \
             approximate method, which trusts them, is wrong for {wrong} of {count} rays"
        );
        let mut finding = Finding::new(Some(traversal), Outcome::Reported, says)
            .with("candidates", candidates)
            .with("false candidates", untouched)
            .with("repeats", repeats)
            .with("approximate hits wrong", wrong);
        finding.rays = count as u64;
        findings.push(finding);
    }
    Ok(findings)
}
