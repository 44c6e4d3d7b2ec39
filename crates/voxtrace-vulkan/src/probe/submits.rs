//! P19: many small submits one after the other, then longer and longer ones up to the time that our tracers allow a submit. Each
//! proves by its own number that it ran.

use super::Effort;
use super::boxes::{Random, block};
use super::grids::rays_through;
use super::lab::Lab;
use super::model::Model;
use super::report::{Finding, Outcome};
use super::shot::Reports;
use std::time::Instant;
use voxtrace_core::TraceError;

const SIZE: i32 = 8;
/// Longest time of a submit of our tracers, milliseconds.
const CEILING_MS: f64 = 250.0;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (submits, ceiling_ms) = effort.pick((64u32, 20.0), (10_000, CEILING_MS));
    let built = lab.build(&Model::single(block(SIZE)))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let few = rays_through(SIZE, 64, &mut Random(19));
        let shot = lab.load(&built, &few, Reports::Exact, 0)?;
        let (start, mut micros) = (Instant::now(), 0.0);
        for _ in 0..submits {
            micros += lab.fire(&shot, traversal, 1)? * 1e3 / f64::from(submits);
        }
        let wall_us = start.elapsed().as_secs_f64() * 1e6 / f64::from(submits);
        let many = rays_through(SIZE, effort.pick(4096, 65536), &mut Random(20));
        let shot = lab.load(&built, &many, Reports::Exact, 0)?;
        let (mut times, mut longest) = (1, 0.0f64);
        while longest < ceiling_ms && times < 1 << 16 {
            longest = longest.max(lab.fire(&shot, traversal, times)?);
            times *= 2;
        }
        let says = format!(
            "{submits} submits of 64 rays took {wall_us:.0} µs each ({micros:.0} µs on the device); the longest of the growing ones \
             {longest:.0} ms; none was lost"
        );
        let mut finding = Finding::new(Some(traversal), Outcome::Holds, says)
            .with("microseconds a submit", wall_us as u64)
            .with("milliseconds of the longest", longest as u64);
        finding.rays = u64::from(submits);
        findings.push(finding);
    }
    Ok(findings)
}
