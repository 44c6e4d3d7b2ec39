//! How far a benchmark is, and how long the rest will take.

use crate::quantity::clock;
use crate::results::Results;
use std::time::Instant;

/// Counts what is measured.
pub struct Eta {
    start: Instant,
    /// All there is to measure: cells of scenes, and cells of sizes of the sweep.
    pub all: usize,
    /// Measured in an earlier run, and in this one.
    pub before: usize,
    now: usize,
}

impl Eta {
    /// Begins with what the results hold already.
    pub fn new(results: &Results) -> Self {
        let plan = &results.plan;
        let sweep = plan.sweep_scenes().len() * plan.sweep.len() * plan.sweep_cells().len();
        let all = plan.scenes.len() * plan.cells.len() + sweep;
        Self { start: Instant::now(), all, before: results.rows.len() + results.sweep.len(), now: 0 }
    }

    pub fn done(&self) -> usize {
        self.before + self.now
    }

    /// One more is measured.
    pub fn step(&mut self) {
        self.now += 1;
    }

    /// The time that is left, if what is left takes as long as what was done.
    pub fn left(&self) -> String {
        let rest = self.all.saturating_sub(self.done());
        clock(self.start.elapsed().as_secs_f64() / self.now.max(1) as f64 * rest as f64)
    }
}
