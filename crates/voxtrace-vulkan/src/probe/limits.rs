//! P17: the limits that the driver states, beside those that the specification demands, and whether numbers of primitives stay
//! exact where they are large. Our tracers split what is beyond the limits.

use super::Effort;
use super::boxes::Aabb;
use super::lab::Lab;
use super::model::Model;
use super::report::{Finding, Outcome};
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::IVec3;
use voxtrace_core::TraceError;

/// Boxes along x and y of the plane that they are laid out in.
const ROW: u32 = 4096;
const QUICK_COUNT: u32 = 1 << 14;
/// Above 2²⁴, from where on single precision skips whole numbers.
const FULL_COUNT: u32 = (1 << 24) + 1024;
/// Bytes that a build of that many may take: boxes, structure and scratch.
const BYTES_PER_BOX: u64 = 24 + 64 + 128;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (limits, is_software) = (lab.device().info().ray_tracing, lab.device().info().kind == crate::DeviceKind::Cpu);
    let fits = u64::from(FULL_COUNT) <= limits.max_primitive_count
        && u64::from(FULL_COUNT) * BYTES_PER_BOX <= lab.device().available_bytes();
    // Software takes a minute for so many.
    let count = effort.pick(QUICK_COUNT, if fits && !is_software { FULL_COUNT } else { 1 << 18 });
    let cell = |id: u32| IVec3::new((2 * (id % ROW)) as i32, (2 * (id / ROW)) as i32, 0);
    let ids: Vec<u32> = (count - 256..count).collect();
    let over = |&id: &u32| ray(cell(id).as_vec3() + glam::Vec3::new(0.5, 0.5, -4.0), glam::Vec3::Z);
    let rays: Vec<ProbeRay> = ids.iter().map(over).collect();
    let built = lab.build(&Model::single((0..count).map(|id| Aabb::cell(cell(id))).collect()))?;
    let demanded = [
        ("primitives", limits.max_primitive_count, (1 << 29) - 1),
        ("instances", limits.max_instance_count, (1 << 24) - 1),
        ("geometries", limits.max_geometry_count, (1 << 24) - 1),
        ("rays a launch", limits.max_launch, 1 << 30),
    ];
    let is_low = |&&(_, is, must): &&(&str, u64, u64)| is < must && is > 0;
    let low: Vec<String> =
        demanded.iter().filter(is_low).map(|(name, is, must)| format!("{name} {is}, demanded are {must}")).collect();
    let told = match low.is_empty() {
        true => "the limits are those demanded or more".to_owned(),
        false => format!("lower limits than the specification demands ({}): our tracers split at them", low.join("; ")),
    };
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let answers = lab.cast(&built, traversal, &rays, Reports::Nothing, 8)?;
        let wrong = (0..rays.len()).filter(|&index| !answers.candidates(index).contains(&ids[index])).count() as u64;
        let says = match wrong {
            0 => format!("{told}; numbers of primitives are exact up to {}", count - 1),
            wrong => format!("{told}; {wrong} of 256 primitives below number {count} come out wrong"),
        };
        let mut finding = Finding::judged(traversal, rays.len() as u64, wrong, says);
        if wrong == 0 && !low.is_empty() {
            finding.outcome = Outcome::Reported;
        }
        for (name, is, _) in demanded {
            finding = finding.with(&format!("most {name}"), is);
        }
        findings.push(finding);
    }
    Ok(findings)
}
