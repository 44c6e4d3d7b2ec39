//! Frame time and memory against the number of voxels: a few frames of each built-in scene at growing sizes.

use crate::measure::{Effort, measure};
use crate::monitor::Monitor;
use crate::plan::Cell;
use crate::results::{Row, SceneFacts, SweepRow};
use std::sync::Arc;
use std::time::Duration;
use voxtrace::{Frame, PackedScene};

/// Frames of a size.
const FRAMES: u32 = 24;
/// Most time of a size.
const LIMIT: Duration = Duration::from_secs(4);

/// Measures one cell of a scene of one size; `None` where it was interrupted.
pub fn measure_size(
    name: &str,
    cell: Cell,
    wanted: u64,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    effort: &Effort,
    monitor: &mut dyn Monitor,
) -> Option<SweepRow> {
    let frames = FRAMES.min(effort.frames);
    let effort = Effort { frames, least: 1, warm_up: 3, time_limit: Some(LIMIT), is_brief: true, ..effort.clone() };
    let facts = SceneFacts::of(name, scene, "");
    let measured = measure(&[(cell, effort)], scene, frame, None, monitor).pop().unwrap_or_default();
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
