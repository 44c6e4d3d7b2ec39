//! P4: which part of a ray counts. Boxes before its start and behind its end are not hit; a start inside a box is a hit at
//! the start; what is reported at the very end is accepted (Vulkan: both ends of the interval are inclusive).

use super::Effort;
use super::boxes::Aabb;
use super::lab::Lab;
use super::model::Model;
use super::report::{Finding, Outcome};
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::{IVec3, Vec3};
use voxtrace_core::TraceError;

/// A segment in units along the axis, the box being from 5 to 6, and what must come of it: a hit at some distance, none, or
/// whatever the driver likes.
struct Case {
    t_min: f32,
    t_max: f32,
    must: Option<Option<f32>>,
    name: &'static str,
}

const CASES: [Case; 8] = [
    Case { t_min: 0.0, t_max: 100.0, must: Some(Some(5.0)), name: "ahead" },
    Case { t_min: 0.0, t_max: 4.9, must: Some(None), name: "behind the end" },
    Case { t_min: 6.1, t_max: 100.0, must: Some(None), name: "before the start" },
    Case { t_min: 5.0, t_max: 100.0, must: Some(Some(5.0)), name: "start where the box begins" },
    Case { t_min: 5.25, t_max: 100.0, must: Some(Some(5.25)), name: "start inside" },
    Case { t_min: 5.25, t_max: 5.5, must: Some(Some(5.25)), name: "start and end inside" },
    Case { t_min: 6.0, t_max: 100.0, must: None, name: "start where the box ends" },
    Case { t_min: 0.0, t_max: 5.0, must: None, name: "end where the box begins" },
];

pub fn run(lab: &mut Lab, _: Effort) -> Result<Vec<Finding>, TraceError> {
    let built = lab.build(&Model::single(vec![Aabb::cell(IVec3::ZERO)]))?;
    // Towards the box from 5 units away, along each axis both ways.
    let rays_of = |t_min: f32, t_max: f32| -> Vec<ProbeRay> {
        let towards = |side: usize| {
            let mut direction = Vec3::ZERO;
            direction[side / 2] = if side.is_multiple_of(2) { 1.0 } else { -1.0 };
            ProbeRay { t_min, t_max, ..ray(Vec3::splat(0.5) - direction * 5.5, direction) }
        };
        (0..6).map(towards).collect()
    };
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let (mut rays, mut wrong, mut broken, mut free) = (0, 0, Vec::new(), Vec::new());
        for case in &CASES {
            let given = rays_of(case.t_min, case.t_max);
            let answers = lab.cast(&built, traversal, &given, Reports::Exact, 0)?.answers;
            let hits = answers.iter().filter(|answer| answer.is_hit == 1).count();
            let Some(must) = case.must else {
                free.push(format!("{}: {hits} of 6 are hits", case.name));
                continue;
            };
            let is_right = |answer: &&crate::records::ProbeAnswer| match must {
                None => answer.is_hit == 0,
                Some(t) => answer.is_hit == 1 && answer.t == t,
            };
            let right = answers.iter().filter(is_right).count() as u64;
            rays += 6;
            wrong += 6 - right;
            if right < 6 {
                broken.push(case.name);
            }
        }
        // The centre is reported at 5.5, the end of the segment.
        let answers = lab.cast(&built, traversal, &rays_of(0.0, 5.5), Reports::Centre, 0)?.answers;
        let refused = answers.iter().filter(|answer| answer.is_hit != 1 || answer.t != 5.5).count() as u64;
        if refused > 0 {
            broken.push("report at the end");
        }
        (rays, wrong) = (rays + 6, wrong + refused);
        let free = free.join(", ");
        let says = match broken.is_empty() {
            true => format!("as specified ({free})"),
            false => format!("wrong: {} ({free})", broken.join(", ")),
        };
        let outcome = if wrong == 0 { Outcome::Holds } else { Outcome::Fails };
        findings.push(Finding { rays, wrong, ..Finding::new(Some(traversal), outcome, says) });
    }
    Ok(findings)
}
