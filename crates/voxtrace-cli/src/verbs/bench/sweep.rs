//! Frame time and memory against the number of voxels: a few frames of each built-in scene at growing sizes.

use super::cells::Cell;
use super::measure::{self, Effort};
use super::results::{Row, SceneFacts, SweepRow};
use crate::report::Report;
use std::sync::Arc;
use std::time::Duration;
use voxtrace::{Frame, PackedScene};
use voxtrace_vulkan::{Primitive, Traversal};

/// Sizes where none are asked for, voxels.
pub const SIZES: [u64; 6] = [500_000, 1_000_000, 2_000_000, 4_000_000, 8_000_000, 16_000_000];
/// The largest of them on the CPU and devices in software.
pub const MOST_IN_SOFTWARE: u64 = 4_000_000;
/// Frames of a size.
const FRAMES: u32 = 24;
/// Most time of a size.
const LIMIT: Duration = Duration::from_secs(4);

/// Whether a cell of the plan takes part: the study's method, the best of ours in a pipeline and outside, and the CPU
/// where there is nothing else.
pub fn takes(cell: Cell, planned: &[Cell]) -> bool {
    let is_chosen = |cell: &Cell| match cell.traversal {
        Traversal::Cpu => false,
        Traversal::Walk => true,
        _ => matches!(cell.primitive, Some(Primitive::VoxelExact | Primitive::Grid)),
    };
    if planned.iter().any(is_chosen) { is_chosen(&cell) } else { planned.first() == Some(&cell) }
}

/// Measures one cell of a scene of one size; `None` where it was interrupted.
pub fn measure(
    name: &str,
    cell: Cell,
    wanted: u64,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    effort: &Effort,
    report: &mut Report,
) -> Option<SweepRow> {
    let frames = FRAMES.min(effort.frames);
    let effort = Effort { frames, warm_up: 3, time_limit: Some(LIMIT), is_brief: true, ..effort.clone() };
    let facts = SceneFacts::of(name, scene, "");
    let measured = measure::measure(cell, scene, frame, None, &effort, report);
    if measured.is_interrupted {
        return None;
    }
    let row = Row::new(0, cell, measured);
    Some(SweepRow {
        scene: name.to_owned(),
        cell,
        wanted,
        voxels: facts.voxels,
        median: row.summary().map(|summary| summary.median),
        frames: row.measured.frames.len(),
        lost: row.measured.lost,
        bytes: row.traced_bytes(&facts),
        failure: row.measured.failure,
    })
}
