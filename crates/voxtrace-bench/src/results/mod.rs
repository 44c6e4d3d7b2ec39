//! The results of a benchmark: scenes, rows and sweep, written for programs and read again, and the answer that they give.

mod facts;
mod json;
mod measurement;
mod origin;
mod resume;
mod row;
pub mod verdict;

pub use facts::{Emulation, Figures, SceneFacts};
pub use measurement::{Measurement, Times};
pub use origin::Origin;
pub use resume::{ResumeError, ResumeErrorKind, load};
pub use row::{Row, SweepRow};

use crate::plan::{Cell, Plan};
use serde_json::Value;
use voxtrace_vulkan::{DeviceInfo, DeviceKind, Traversal};

/// A whole benchmark, as far as it has come.
pub struct Results {
    pub(crate) plan: Plan,
    pub(crate) device: Option<DeviceInfo>,
    pub(crate) scenes: Vec<SceneFacts>,
    pub(crate) rows: Vec<Row>,
    pub(crate) sweep: Vec<SweepRow>,
    /// What the probes of the driver said, see `voxtrace doctor`.
    pub(crate) doctor: Option<Value>,
    pub(crate) is_complete: bool,
    /// The runs that measured it, the last one last.
    pub(crate) runs: Vec<Origin>,
}

impl Results {
    /// Nothing measured yet.
    pub(crate) fn new(plan: Plan, device: Option<DeviceInfo>, run: Origin) -> Self {
        let (scenes, rows, sweep) = (Vec::new(), Vec::new(), Vec::new());
        Self { plan, device, scenes, rows, sweep, doctor: None, is_complete: false, runs: vec![run] }
    }

    /// Whether every cell of the plan was measured to its end.
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Puts a row where the plan has it.
    pub(crate) fn insert(&mut self, row: Row) {
        let place = |row: &Row| (row.scene, self.plan.cells.iter().position(|&cell| cell == row.cell));
        let at = self.rows.partition_point(|other| place(other) <= place(&row));
        self.rows.insert(at, row);
    }

    pub(crate) fn sweep_row(&self, scene: &str, cell: Cell, wanted: u64) -> Option<&SweepRow> {
        self.sweep.iter().find(|row| (row.scene.as_str(), row.cell, row.wanted) == (scene, cell, wanted))
    }

    pub(crate) fn row(&self, scene: usize, cell: Cell) -> Option<&Row> {
        self.rows.iter().find(|row| row.scene == scene && row.cell == cell)
    }

    /// How the shaders round, for the rows on a device.
    pub(crate) fn rounding(&self, cell: Cell) -> &'static str {
        match (cell.traversal, cell.is_exact.unwrap_or(self.plan.is_exact)) {
            (Traversal::Cpu, _) | (_, true) => "precise",
            _ => "fast",
        }
    }

    /// Whether the processor does the work of a cell: on itself, or as a device in software.
    pub(crate) fn is_on_processor(&self, cell: Cell) -> bool {
        let is_software = self.device.as_ref().is_some_and(|device| device.kind == DeviceKind::Cpu);
        cell.traversal == Traversal::Cpu || is_software
    }

    /// Why the times of a row say little; `None` where the machine was quiet, where the work is on a device of its own, or nothing is known.
    pub(crate) fn disturbance(&self, row: &Row) -> Option<String> {
        row.measured.processor.disturbance().filter(|_| self.is_on_processor(row.cell))
    }

    /// Median of the reference divided by the row's, so that more is faster.
    pub(crate) fn times_reference(&self, row: &Row) -> Option<f64> {
        let reference = self.row(row.scene, Cell::REFERENCE)?.summary()?;
        Some(reference.median / row.summary()?.median)
    }
}
