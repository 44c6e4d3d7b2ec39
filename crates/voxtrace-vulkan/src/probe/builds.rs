//! P9: a compacted structure, P10: an updated one, P11: one built again and again; each must answer like the one built once.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::grids::rays_through;
use super::lab::Lab;
use super::model::{Bottom, BuildFlags, Model, Treatment};
use super::report::Finding;
use super::shot::Reports;
use crate::records::ProbeAnswer;
use glam::Vec3;
use voxtrace_core::TraceError;

const SIZE: i32 = 10;

/// A block with holes.
fn sponge() -> Vec<Aabb> {
    let mut random = Random(9);
    block(SIZE).into_iter().filter(|_| random.unit() < 0.6).collect()
}

fn bottom(flags: BuildFlags, treatment: Treatment) -> Bottom {
    Bottom { geometries: vec![sponge()], flags, treatment }
}

/// Compares each of `others` with `reference`.
fn compare(
    lab: &mut Lab,
    effort: Effort,
    reference: Bottom,
    others: Vec<Bottom>,
    what: &str,
) -> Result<Vec<Finding>, TraceError> {
    let rays = rays_through(SIZE, effort.pick(512, 16384), &mut Random(10));
    let reference = lab.build(&Model::of(vec![reference]))?;
    let others = others.into_iter().map(|bottom| lab.build(&Model::of(vec![bottom]))).collect::<Result<Vec<_>, _>>()?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let first = lab.cast(&reference, traversal, &rays, Reports::Exact, 0)?.answers;
        let mut wrong = 0;
        for other in &others {
            let answers = lab.cast(other, traversal, &rays, Reports::Exact, 0)?.answers;
            let differ = |(a, b): &(&ProbeAnswer, &ProbeAnswer)| {
                (a.is_hit, a.primitive, a.t.to_bits()) != (b.is_hit, b.primitive, b.t.to_bits())
            };
            wrong += first.iter().zip(&answers).filter(differ).count() as u64;
        }
        let says = match wrong {
            0 => format!("{what} gives the same hits"),
            wrong => format!("{what} gives other hits for {wrong} rays"),
        };
        findings.push(Finding::judged(traversal, (rays.len() * others.len()) as u64, wrong, says));
    }
    Ok(findings)
}

pub fn compacted(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let flags = BuildFlags::PREFER_FAST_TRACE | BuildFlags::ALLOW_COMPACTION;
    compare(lab, effort, bottom(flags, Treatment::Built), vec![bottom(flags, Treatment::Compacted)], "compaction")
}

pub fn updated(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let flags = BuildFlags::PREFER_FAST_TRACE | BuildFlags::ALLOW_UPDATE;
    let mut random = Random(11);
    let elsewhere: Vec<Aabb> = sponge().into_iter().map(|aabb| aabb.moved(random.direction() + Vec3::X)).collect();
    let updated = bottom(flags, Treatment::UpdatedFrom(vec![elsewhere]));
    compare(lab, effort, bottom(flags, Treatment::Built), vec![updated], "an update")
}

pub fn repeated(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let again = || bottom(BuildFlags::PREFER_FAST_TRACE, Treatment::Built);
    compare(lab, effort, again(), vec![again(), again(), again()], "building again")
}
