//! Measuring one cell: a frame is one sample a pixel, and counts only where the device proved that it ran.

mod backend;
mod conformance;
mod driver;
mod frames;
mod machine;
mod measured;
mod proof;

pub use backend::open_device;
pub use conformance::{Conformance, Reference, is_same_voxel};
pub use driver::probed;
pub use machine::host;
pub use measured::{Measured, Memory};

use crate::monitor::Monitor;
use crate::plan::Cell;
use backend::Backend;
use frames::{Run, Series};
use serde_json::Value;
use std::sync::Arc;
use std::time::Duration;
use voxtrace::{Frame, Hit, Instructions, PackedScene, TraceError};

/// Frames without bounces, for the speed of camera rays.
const PRIMARY_FRAMES: u32 = 64;

/// How long and on what to measure.
#[derive(Clone, Debug)]
pub struct Effort {
    pub frames: u32,
    pub warm_up: u32,
    /// Ends warm-up at a quarter of it, and the frames at the whole; at least one of each is rendered.
    pub time_limit: Option<Duration>,
    pub is_exact: bool,
    pub device: Option<String>,
    /// Leaves out the run of camera rays and the clocks.
    pub is_brief: bool,
}

/// Measures a cell, and compares what it finds with the reference. What fails is told in the result, so that the other
/// cells still run.
pub fn measure(
    cell: Cell,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    reference: Option<&Reference>,
    effort: &Effort,
    monitor: &mut dyn Monitor,
) -> Measured {
    let mut measured = Measured::default();
    let usual = Instructions::chosen();
    if let Some(missing) = cell.instructions.filter(|instructions| !instructions.force()) {
        measured.failure = Some(format!("this processor has no {}", missing.name()));
        return measured;
    }
    if let Err(error) = try_measure(cell, scene, frame, reference, effort, monitor, &mut measured) {
        measured.failure = Some(monitor.explain(error));
    }
    usual.force();
    measured
}

fn try_measure(
    cell: Cell,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    reference: Option<&Reference>,
    effort: &Effort,
    monitor: &mut dyn Monitor,
    measured: &mut Measured,
) -> Result<(), TraceError> {
    let mut backend = Backend::open(cell, effort.device.as_deref(), effort.is_exact)?;
    measured.has_gpu_clock = backend.has_clock();
    backend.tracer().set_scene(scene)?;
    let peak = backend.memory().map_or(0, |memory| memory.peak);
    let device = backend.device_name();
    let mut run = Run::new(&mut backend, frame.clone());
    let quarter = effort.time_limit.map(|limit| limit / 4);
    run.frames(effort.warm_up, quarter, measured, Series::WarmUp, monitor)?;
    run.begun = 0;
    let clocks = || if effort.is_brief { Value::Null } else { machine::clocks(device.as_deref()) };
    measured.clocks[0] = clocks();
    run.frames(effort.frames, effort.time_limit, measured, Series::Main, monitor)?;
    measured.clocks[1] = clocks();
    measured.film = run.film.take();
    measured.memory = run.backend.memory().map(|memory| Memory { peak: memory.peak.max(peak), ..memory });
    if !measured.is_interrupted && !effort.is_brief && frame.max_bounces > 0 {
        run.frame = frame.clone().max_bounces(0).samples(0);
        if matches!(&*run.backend, Backend::Cpu(_)) {
            run.sequence = 0;
        }
        run.frames(effort.warm_up.min(8), quarter, measured, Series::WarmUp, monitor)?;
        run.begun = 0;
        run.frames(effort.frames.min(PRIMARY_FRAMES), quarter, measured, Series::Primary, monitor)?;
    }
    if let Some(reference) = reference.filter(|_| !measured.is_interrupted) {
        let mut hits = vec![Hit::MISS; reference.rays.len()];
        backend.tracer().cast_into(&reference.rays, &mut hits)?;
        measured.conformance = Some(Conformance::of(scene, reference, &hits));
        measured.hits = hits;
    }
    Ok(())
}
