//! P13: the attribute that a closest-hit shader sees must be that of the hit it is called for (Vulkan 1.4.356 says so in so many
//! words). Some drivers hand over that of the last intersection shader that ran. Three ways are tried: trusting it;
//! putting the accepted one back after a refused report; and our tracers' own, the nearest kept in the payload by any-hit
//! shaders.

use super::Effort;
use super::boxes::{Random, block};
use super::grids::rays_through;
use super::lab::Lab;
use super::model::Model;
use super::report::{Finding, Outcome};
use super::shot::{OPAQUE, Reports};
use crate::method::Traversal;
use crate::records::{ProbeAnswer, ProbeRay};
use voxtrace_core::TraceError;

const SIZE: i32 = 16;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let rays = rays_through(SIZE, effort.pick(2048, 65536), &mut Random(13));
    let see_through: Vec<ProbeRay> = rays.iter().map(|ray| ProbeRay { flags: ray.flags & !OPAQUE, ..*ray }).collect();
    let built = lab.build(&Model::single(block(SIZE)))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        if traversal == Traversal::Query {
            let says = "a query has no hit attribute: the shader keeps what it wants";
            findings.push(Finding::new(Some(traversal), Outcome::NotApplicable, says));
            continue;
        }
        let mut count = |rays: &[ProbeRay], reports, is_wrong: &dyn Fn(&ProbeAnswer) -> bool| {
            // Planted faults need to know the candidates.
            let capacity = if lab.plant().is_some() { 8 * SIZE as usize } else { 0 };
            let answers = lab.cast(&built, traversal, rays, reports, capacity)?.answers;
            let hits = answers.iter().filter(|answer| answer.is_hit == 1);
            Ok::<u64, TraceError>(hits.filter(|answer| is_wrong(answer)).count() as u64)
        };
        let attribute = |answer: &ProbeAnswer| answer.attribute != answer.primitive || answer.attribute_t != answer.t;
        // Of two boxes at the same distance either may be kept.
        let not_kept = |answer: &ProbeAnswer| answer.kept != answer.primitive && answer.kept_t != answer.t;
        let naive = count(&rays, Reports::Exact, &attribute)?;
        let restored = count(&rays, Reports::Restoring, &attribute)?;
        let kept = count(&see_through, Reports::Exact, &not_kept)?;
        let total = rays.len() as u64;
        let ours = match (restored, kept) {
            (0, 0) => "both other ways are always right".to_owned(),
            (restored, kept) => format!("put back, {restored} are wrong; kept by any-hit shaders, {kept}"),
        };
        let says = match naive {
            0 => format!("the attribute is that of the hit; {ours}"),
            naive => format!("the attribute is that of another box for {naive} of {total} rays; {ours}"),
        };
        findings.push(
            Finding::judged(traversal, total, naive, says)
                .with("wrong when trusted", naive)
                .with("wrong when put back", restored)
                .with("wrong when kept by any-hit shaders", kept),
        );
    }
    Ok(findings)
}
