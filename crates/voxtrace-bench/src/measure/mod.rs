//! Measuring one cell: a frame is one sample a pixel, and counts only where the device proved that it ran.

mod backend;
mod conformance;
mod driver;
mod frames;
mod machine;
mod measured;
mod processor;
mod proof;
mod walked;

pub use backend::open_device;
pub use conformance::{Conformance, Reference, is_same_voxel};
pub use driver::probed;
pub use machine::host;
pub use measured::{Measured, Memory};
pub use processor::Processor;
pub use walked::Walked;

use crate::monitor::Monitor;
use crate::plan::Cell;
use backend::Backend;
use frames::{Amount, Run, Series};
use processor::Watch;
use serde_json::Value;
use std::sync::Arc;
use std::time::Duration;
use voxtrace::{Frame, Hit, Instructions, PackedScene, TraceError};
use voxtrace_vulkan::Traversal;

/// Frames without bounces, for the speed of camera rays.
const PRIMARY_FRAMES: u32 = 64;

/// Turns in which cells on the processor are measured, so that what else happens on the machine meets all of them.
const TURNS: u32 = 8;

/// How long and on what to measure.
#[derive(Clone, Debug)]
pub struct Effort {
    pub frames: u32,
    /// Frames that there must be although the time limit is over, within reason.
    pub least: u32,
    pub warm_up: u32,
    /// Ends warm-up at a quarter of it, and the frames at the whole; at least one of each is rendered.
    pub time_limit: Option<Duration>,
    pub is_exact: bool,
    pub device: Option<String>,
    /// Leaves out the run of camera rays and the clocks.
    pub is_brief: bool,
}

/// Cells that are measured in turns, the frames of one between those of the others: all on the processor, which need no memory of their own. On
/// a device each is measured alone.
pub fn groups(cells: &[Cell]) -> Vec<Vec<Cell>> {
    let mut groups: Vec<Vec<Cell>> = Vec::new();
    for &cell in cells {
        let is_on_processor = |group: &&mut Vec<Cell>| group[0].traversal == Traversal::Cpu;
        match groups.iter_mut().find(is_on_processor).filter(|_| cell.traversal == Traversal::Cpu) {
            Some(group) => group.push(cell),
            None => groups.push(vec![cell]),
        }
    }
    groups
}

/// Measures cells in turns, and compares what they find with the reference. What fails is told in the result, so that the other cells still run.
pub fn measure(
    cells: &[(Cell, Effort)],
    scene: &Arc<PackedScene>,
    frame: &Frame,
    reference: Option<&Reference>,
    monitor: &mut dyn Monitor,
) -> Vec<Measured> {
    let usual = Instructions::chosen();
    let mut all: Vec<Measured> = cells.iter().map(|_| Measured::default()).collect();
    let mut backends: Vec<Option<Backend>> = Vec::new();
    for ((cell, effort), measured) in cells.iter().zip(&mut all) {
        backends.push(attempt(*cell, measured, monitor, |measured, _| begin(*cell, effort, scene, measured)));
    }
    let mut subjects: Vec<Subject> = Vec::new();
    for (((cell, effort), backend), measured) in cells.iter().zip(&mut backends).zip(&mut all) {
        if let Some(backend) = backend {
            let device = backend.device_name();
            let run = Run::new(backend, frame.clone());
            subjects.push(Subject { cell: *cell, effort, device, run, measured });
        }
    }
    for subject in &mut subjects {
        subject.attempt(monitor, Subject::warm_up);
    }
    let turns = if subjects.len() > 1 { TURNS } else { 1 };
    for turn in 0..turns {
        for subject in &mut subjects {
            subject.attempt(monitor, |subject, monitor| subject.turn(turn, turns, monitor));
        }
    }
    for subject in &mut subjects {
        subject.attempt(monitor, |subject, monitor| subject.finish(scene, reference, monitor));
    }
    drop(subjects);
    usual.force();
    all
}

/// Does something with the instructions of a cell, and tells what fails in what was measured; `None` where something failed.
fn attempt<T>(
    cell: Cell,
    measured: &mut Measured,
    monitor: &mut dyn Monitor,
    work: impl FnOnce(&mut Measured, &mut dyn Monitor) -> Result<T, TraceError>,
) -> Option<T> {
    if measured.failure.is_some() {
        return None;
    }
    if let Some(missing) = cell.instructions.filter(|instructions| !instructions.force()) {
        measured.failure = Some(format!("this processor has no {}", missing.name()));
        return None;
    }
    let done = work(measured, monitor);
    done.map_err(|error| measured.failure = Some(monitor.explain(error))).ok()
}

/// Opens what a cell is measured on.
fn begin(
    cell: Cell,
    effort: &Effort,
    scene: &Arc<PackedScene>,
    measured: &mut Measured,
) -> Result<Backend, TraceError> {
    let mut backend = Backend::open(cell, effort.device.as_deref(), effort.is_exact)?;
    measured.has_gpu_clock = backend.has_clock();
    let name = || Instructions::chosen().name().to_owned();
    measured.walked = matches!(backend, Backend::Cpu(_)).then(|| Walked { instructions: name(), ..Walked::default() });
    backend.tracer().set_scene(scene)?;
    // Taken now: notes that are taken after a frame say that the device was lost, and "the scene is in pages" does not.
    measured.notes.extend(backend.tracer().take_notes());
    measured.memory = backend.memory();
    Ok(backend)
}

/// A cell on its way.
struct Subject<'a> {
    cell: Cell,
    effort: &'a Effort,
    device: Option<String>,
    run: Run<'a>,
    measured: &'a mut Measured,
}

impl Subject<'_> {
    /// Does something with it, and tells what fails in what was measured.
    fn attempt(
        &mut self,
        monitor: &mut dyn Monitor,
        work: impl FnOnce(&mut Self, &mut dyn Monitor) -> Result<(), TraceError>,
    ) {
        if self.measured.failure.is_some() || self.measured.is_interrupted {
            return;
        }
        // Available: it was opened with them.
        let usual = Instructions::chosen();
        self.cell.instructions.map(Instructions::force);
        if let Err(error) = work(self, monitor) {
            self.measured.failure = Some(monitor.explain(error));
        }
        usual.force();
    }

    fn quarter(&self) -> Option<Duration> {
        self.effort.time_limit.map(|limit| limit / 4)
    }

    fn clocks(&self) -> Value {
        if self.effort.is_brief { Value::Null } else { machine::clocks(self.device.as_deref()) }
    }

    fn warm_up(&mut self, monitor: &mut dyn Monitor) -> Result<(), TraceError> {
        let amount = Amount::within(self.effort.warm_up, self.quarter());
        self.run.frames(amount, self.measured, Series::WarmUp, monitor)?;
        self.run.begun = 0;
        Ok(())
    }

    /// Renders the frames of a turn.
    fn turn(&mut self, turn: u32, turns: u32, monitor: &mut dyn Monitor) -> Result<(), TraceError> {
        let share = |all: u32| share_of_turn(all, turn, turns);
        if turn == 0 {
            self.measured.clocks[0] = self.clocks();
        }
        if share(self.effort.frames) > 0 {
            let limit = self.effort.time_limit.map(|limit| limit / turns);
            let amount = Amount { count: share(self.effort.frames), least: share(self.effort.least), limit };
            let watch = Watch::start();
            let rendered = self.run.frames(amount, self.measured, Series::Main, monitor);
            self.measured.processor.add(watch.stop());
            rendered?;
        }
        if turn + 1 == turns {
            self.measured.clocks[1] = self.clocks();
        }
        Ok(())
    }

    /// What else there is to know: memory, camera rays alone, and whether the right voxels are found.
    fn finish(
        &mut self,
        scene: &Arc<PackedScene>,
        reference: Option<&Reference>,
        monitor: &mut dyn Monitor,
    ) -> Result<(), TraceError> {
        let (effort, measured) = (self.effort, &mut *self.measured);
        measured.film = self.run.film.take();
        let peak = measured.memory.as_ref().map_or(0, |memory| memory.peak);
        measured.memory = self.run.backend.memory().map(|memory| Memory { peak: memory.peak.max(peak), ..memory });
        if !effort.is_brief && self.run.frame.max_bounces > 0 {
            self.run.frame = self.run.frame.clone().max_bounces(0).samples(0);
            if matches!(&*self.run.backend, Backend::Cpu(_)) {
                self.run.sequence = 0;
            }
            let quarter = effort.time_limit.map(|limit| limit / 4);
            self.run.frames(Amount::within(effort.warm_up.min(8), quarter), measured, Series::WarmUp, monitor)?;
            self.run.begun = 0;
            let amount = Amount::within(effort.frames.min(PRIMARY_FRAMES), quarter);
            self.run.frames(amount, measured, Series::Primary, monitor)?;
        }
        if let Some(reference) = reference.filter(|_| !measured.is_interrupted) {
            let mut hits = vec![Hit::MISS; reference.rays.len()];
            self.run.backend.tracer().cast_into(&reference.rays, &mut hits)?;
            measured.conformance = Some(Conformance::of(scene, reference, &hits));
            measured.hits = hits;
        }
        Ok(())
    }
}

/// How many of all frames a turn has; of few frames the first turns have one each.
fn share_of_turn(all: u32, turn: u32, turns: u32) -> u32 {
    let until = |turn: u32| (u64::from(all) * u64::from(turn)).div_ceil(turns.into());
    (until(turn + 1) - until(turn)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan;

    #[test]
    fn turns_share_any_number_of_frames_evenly() {
        for all in [0, 1, 3, 8, 4096, 1_000_000_000, u32::MAX] {
            let shares: Vec<u32> = (0..TURNS).map(|turn| share_of_turn(all, turn, TURNS)).collect();
            assert_eq!(shares.iter().map(|&share| u64::from(share)).sum::<u64>(), u64::from(all));
            assert!(shares.iter().all(|share| share.abs_diff(all / TURNS) <= 1), "{all}: {shares:?}");
        }
    }

    #[test]
    fn cells_on_the_processor_take_turns_and_those_on_a_device_stand_alone() {
        let cells: Vec<Cell> =
            ["cpu:avx2", "walk", "cpu:scalar", "query"].iter().flat_map(|name| plan::parse(name).unwrap()).collect();
        let names: Vec<String> = groups(&cells)
            .iter()
            .map(|group| group.iter().map(|cell| cell.name()).collect::<Vec<_>>().join("+"))
            .collect();
        assert_eq!(names, ["cpu:avx2+cpu:scalar", "walk", "query:brick"]);
    }
}
