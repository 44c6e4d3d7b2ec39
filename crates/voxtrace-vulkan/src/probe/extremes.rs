//! P18: boxes of ±1e30, many boxes around one centre, structures without boxes, instances that no ray may see. Nothing may hang,
//! and nothing may be lost.

use super::Effort;
use super::boxes::Aabb;
use super::lab::Lab;
use super::model::{Bottom, IDENTITY, Model, Placed};
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::{IVec3, Vec3};
use voxtrace_core::TraceError;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let nested = effort.pick(2_000u32, 1_000_000);
    // A huge box around four small ones.
    let mut huge: Vec<Aabb> = (0..4).map(|index| Aabb::cell(IVec3::new(8 * index, 0, 0))).collect();
    huge.push(Aabb::new(Vec3::splat(-1e30), Vec3::splat(1e30)));
    let around = |index: u32| {
        let half = 0.5 + index as f32 / nested as f32;
        Aabb::new(Vec3::splat(-half), Vec3::splat(half))
    };
    let placed = |bottom, mask| Placed { bottom, transform: IDENTITY, mask };
    let models = [
        Model::single(huge),
        Model::single((0..nested).map(around).collect()),
        Model::of(vec![Bottom::of(Vec::new()), Bottom::of(vec![Aabb::cell(IVec3::ZERO)])]),
        Model { bottoms: vec![Bottom::of(vec![Aabb::cell(IVec3::ZERO)])], instances: vec![placed(0, 0)] },
        Model { bottoms: vec![Bottom::of(vec![Aabb::cell(IVec3::ZERO)])], instances: vec![placed(0, 0x0f)] },
        Model::default(),
    ];
    let built = models.iter().map(|model| lab.build(model)).collect::<Result<Vec<_>, _>>()?;
    let towards = |x: f32| ray([x, 0.25, -4.0], [0.0, 0.0, 1.0]);
    let small: Vec<ProbeRay> = (0..4).map(|index| towards(8.0 * index as f32 + 0.5)).collect();
    let one = [towards(0.25)];
    let with_mask = |mask| [ProbeRay { mask, ..one[0] }];
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let mut broken: Vec<String> = Vec::new();
        let in_huge = lab.cast(&built[0], traversal, &small, Reports::Nothing, 16)?;
        if !(0..4).all(|index| [index as u32, 4].iter().all(|id| in_huge.candidates(index).contains(id))) {
            broken.push("boxes of 1e30 or those within them give no candidate".into());
        }
        let in_nest = lab.cast(&built[1], traversal, &one, Reports::Nothing, nested as usize + 64)?;
        let mut seen: Vec<u32> = in_nest.candidates(0).to_vec();
        seen.sort_unstable();
        seen.dedup();
        if seen.len() != nested as usize {
            broken.push(format!("of {nested} boxes around one centre {} are candidates", seen.len()));
        }
        // The models without a box in sight, and with one.
        for (model, mask, is_hit, what) in [
            (2, 0xff, 1, "a box beside an empty structure"),
            (3, 0xff, 0, "an instance with mask 0"),
            (4, 0xf0, 0, "an instance whose mask does not fit"),
            (4, 0x08, 1, "an instance whose mask fits"),
            (5, 0xff, 0, "a scene of nothing"),
        ] {
            let answer = lab.cast(&built[model], traversal, &with_mask(mask), Reports::Exact, 0)?.answers[0];
            if answer.is_hit != is_hit {
                broken.push(format!("{what} is {}hit", if is_hit == 1 { "not " } else { "" }));
            }
        }
        let says = match broken.is_empty() {
            true => {
                format!("huge boxes, {nested} boxes around one centre, empty structures and masks: all as it should be")
            }
            false => broken.join("; "),
        };
        findings.push(Finding::judged(traversal, 10, broken.len() as u64, says));
    }
    Ok(findings)
}
