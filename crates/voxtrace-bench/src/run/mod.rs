//! A whole benchmark: every cell of every scene, then the sweep, with the report written on the way, so that it can be
//! interrupted and gone on with.

mod eta;
mod size;
mod sweep;

use crate::error::BenchError;
use crate::measure::{Effort, Reference, groups, measure, open_device, probed};
use crate::monitor::{Host, LoadedScene, Monitor};
use crate::plan::{Cell, Plan, Request, SceneEntry};
use crate::report::ReportFolder;
use crate::results::{self, Origin, Results, Row, SceneFacts, verdict};
use eta::Eta;
use std::sync::Arc;
use voxtrace::scenes::SceneError;
use voxtrace::{Camera, Frame, PackedScene, scenes};
use voxtrace_vulkan::{Device, DeviceKind, Primitive};

/// Measures what is asked for and writes the report. A benchmark that the host interrupts ends well, with what was measured;
/// [`Results::is_complete`] tells. Cells that fail say so in their rows.
///
/// # Errors
/// Where the request makes no sense, the device that it names does not open, a scene cannot be read, is another one than
/// before, or the report cannot be written.
pub fn run<H: Host>(request: &Request, host: &mut H) -> Result<Results, H::Error> {
    let named = request.named_cells().map_err(BenchError::from)?;
    let device = device(request, host)?;
    let info = device.as_ref().map(|device| device.info().clone());
    check_sizes(request, &request.plan(named.clone(), info.as_ref()))?;
    let folder = ReportFolder::new(&request.output)?;
    let mut request = request.clone();
    let mut first = None;
    if request.chooses_size(&named, info.as_ref()) {
        request.size = size::before(&request.output).filter(|_| request.resume);
        if request.size.is_none() {
            let plan = request.plan(named.clone(), info.as_ref());
            let scene = load(&request.entries()[0], &plan, host)?;
            let frame = frame(&scene.scene, &plan);
            let found = size::found(&scene.scene, &frame, &plan.cells, plan.scenes.len());
            request.size = Some(found.map_err(BenchError::from)?);
            first = Some(scene);
        }
    }
    let request = &request;
    let mut results = Results::new(request.plan(named, info.as_ref()), info, Origin::now(request));
    if request.resume {
        results::load(&request.output, &mut results).map_err(BenchError::from)?;
    }
    if let (None, Some(device), false) = (&results.doctor, &device, request.skip_probes) {
        results.doctor = probed(device, request.probes.as_ref(), host);
    }
    drop(device);
    let eta = Eta::new(&results);
    if eta.before > 0 {
        host.remark(&format!("{} of {} are measured already", eta.before, eta.all));
    }
    folder.write_results(&results)?;
    let mut work = Work { request, folder, results, eta, first };
    let outcome = work.measure(host);
    let Work { folder, mut results, eta, .. } = work;
    results.is_complete = outcome.is_ok() && eta.done() == eta.all && !host.is_interrupted();
    folder.write_results(&results)?;
    folder.write_page(&results)?;
    outcome.map(|()| results)
}

/// Refuses numbers of voxels that no built-in scene has, rather than when all that comes before is measured.
fn check_sizes(request: &Request, plan: &Plan) -> Result<(), BenchError> {
    let is_sized = |entry: &SceneEntry| scenes::STUDY_NAMES.contains(&entry.name.as_str());
    let own = plan.voxels.filter(|_| request.entries().iter().any(is_sized));
    let swept = plan.sweep.iter().copied().filter(|_| !plan.sweep_scenes().is_empty());
    let mut impossible = own.into_iter().chain(swept);
    match impossible.find(|count| !(scenes::MIN_VOXELS..=scenes::MAX_VOXELS).contains(count)) {
        Some(count) => Err(SceneError::VoxelCount(count).into()),
        None => Ok(()),
    }
}

/// The device to measure. Without one, and without being asked for one, the CPU is measured alone.
fn device(request: &Request, monitor: &mut dyn Monitor) -> Result<Option<Arc<Device>>, BenchError> {
    if request.is_cpu_alone() {
        return Ok(None);
    }
    match open_device(request.device.as_deref()) {
        Err(error) if request.device.is_some() => Err(error.into()),
        Err(error) => {
            monitor.remark(&format!("no GPU: {error}"));
            Ok(None)
        }
        Ok(device) => {
            let is_software = device.info().kind == DeviceKind::Cpu;
            if is_software && request.device.is_none() && request.cells.is_empty() {
                let name = &device.info().name;
                monitor.remark(&format!("measuring the CPU: {name} is software (--device 0 measures it)"));
                return Ok(None);
            }
            monitor.remark(&format!("measuring {}, driver {}", device.info().name, device.info().driver));
            Ok(Some(device))
        }
    }
}

/// A benchmark on its way.
struct Work<'a> {
    request: &'a Request,
    folder: ReportFolder<'a>,
    results: Results,
    eta: Eta,
    /// The first scene, where it had to be loaded before.
    first: Option<Loaded>,
}

/// A scene as it is measured.
struct Loaded {
    stem: String,
    scene: Arc<PackedScene>,
}

/// A scene that is measured.
struct Subject {
    index: usize,
    stem: String,
    scene: Arc<PackedScene>,
    frame: Frame,
    reference: Reference,
}

impl Work<'_> {
    /// Measures what is missing: the scenes, then the sweep. Ends early where that is asked for.
    fn measure<H: Host>(&mut self, host: &mut H) -> Result<(), H::Error> {
        for (index, entry) in self.request.entries().iter().enumerate() {
            let is_missing = |cell: &Cell| self.results.row(index, *cell).is_none();
            let missing: Vec<Cell> = self.results.plan.cells.iter().copied().filter(is_missing).collect();
            if host.is_interrupted() {
                return Ok(());
            }
            if missing.is_empty() && index < self.results.scenes.len() {
                continue;
            }
            let subject = self.subject(index, entry, host)?;
            self.measure_scene(&subject, &missing, host)?;
            self.folder.write_page(&self.results)?;
        }
        self.measure_sweep(host)
    }

    /// Loads a scene and enters it in the results, or finds the one that was measured before.
    fn subject<H: Host>(&mut self, index: usize, entry: &SceneEntry, host: &mut H) -> Result<Subject, H::Error> {
        let Loaded { stem, scene } = match self.first.take().filter(|_| index == 0) {
            Some(first) => first,
            None => load(entry, &self.results.plan, host)?,
        };
        let frame = frame(&scene, &self.results.plan);
        let reference = Reference::of(&scene, &frame);
        let mut facts = SceneFacts::of(&stem, &scene, &frame.camera.name);
        match self.results.scenes.get(index) {
            Some(before) if before.hash != facts.hash => {
                let (before, now) = (before.hash.clone(), facts.hash);
                return Err(BenchError::OtherScene { name: entry.title(), before, now }.into());
            }
            Some(_) => {}
            None => {
                let mut cells = self.results.plan.cells.iter();
                let emulates = cells.all(|cell| cell.primitive != Some(Primitive::VoxelApprox));
                self.folder.add_figures(index, &mut facts, &scene, &reference, emulates)?;
                self.results.scenes.push(facts);
            }
        }
        Ok(Subject { index, stem, scene, frame, reference })
    }

    /// Measures the cells of a scene that are missing.
    fn measure_scene(
        &mut self,
        subject: &Subject,
        missing: &[Cell],
        monitor: &mut dyn Monitor,
    ) -> Result<(), BenchError> {
        let Subject { index, stem, scene, frame, reference } = subject;
        for group in groups(missing) {
            if monitor.is_interrupted() {
                return Ok(());
            }
            let cells: Vec<(Cell, Effort)> = group.iter().map(|&cell| (cell, self.effort(cell))).collect();
            let place = format!("{}/{}", self.eta.done() + 1, self.eta.all);
            let names = group.iter().map(|cell| cell.name()).collect::<Vec<_>>().join(", ");
            monitor.begin(&format!("{place} {stem} {names}"), self.results.plan.frames.into());
            let measured = measure(&cells, scene, frame, Some(reference), monitor);
            monitor.end();
            // The time that they took is that of all of them.
            let first = self.eta.done();
            measured.iter().filter(|measured| !measured.is_interrupted).for_each(|_| self.eta.step());
            let left = self.eta.left();
            for (index_in_group, (&cell, mut measured)) in group.iter().zip(measured).enumerate() {
                let (film, hits) = (measured.film.take(), std::mem::take(&mut measured.hits));
                let mut row = Row::new(*index, cell, measured);
                self.folder.write_row(&mut row, stem)?;
                self.folder.write_figures(&mut row, stem, scene, reference, film.as_ref(), &hits)?;
                let place = format!("{}/{}", first + index_in_group + 1, self.eta.all);
                monitor.remark(&format!("{place} {stem} {}: {}; about {left} left", cell.name(), outcome(&row)));
                self.results.insert(row);
            }
            // So that what is measured is there whatever happens to the next cell.
            self.folder.write_results(&self.results)?;
        }
        Ok(())
    }

    /// Measures the sizes of the sweep that are missing.
    fn measure_sweep<H: Host>(&mut self, host: &mut H) -> Result<(), H::Error> {
        for name in self.results.plan.sweep_scenes() {
            for wanted in self.results.plan.sweep.clone() {
                let is_missing = |cell: &Cell| self.results.sweep_row(&name, *cell, wanted).is_none();
                let missing: Vec<Cell> = self.results.plan.sweep_cells().into_iter().filter(is_missing).collect();
                if host.is_interrupted() {
                    return Ok(());
                }
                if missing.is_empty() {
                    continue;
                }
                let loaded = host.load(&SceneEntry::named(&name), voxels_of(&name, Some(wanted)))?;
                let (frame, scene) = (frame(&loaded.scene, &self.results.plan), Arc::new(loaded.scene));
                for cell in missing {
                    let effort = self.effort(cell);
                    let Some(row) = sweep::measure_size(&name, cell, wanted, &scene, &frame, &effort, host) else {
                        return Ok(());
                    };
                    self.results.sweep.push(row);
                    self.eta.step();
                    self.folder.write_results(&self.results)?;
                }
                let size = verdict::millions(wanted);
                host.remark(&format!("sweep: {name} of {size} voxels; about {} left", self.eta.left()));
            }
        }
        Ok(())
    }

    fn effort(&self, cell: Cell) -> Effort {
        let plan = &self.results.plan;
        Effort {
            frames: plan.frames,
            least: self.request.least_frames(plan.frames),
            warm_up: plan.warm_up,
            time_limit: self.request.limit_of(cell, self.results.device.as_ref()),
            is_exact: cell.is_exact.unwrap_or(plan.is_exact),
            device: self.request.device.clone(),
            is_brief: false,
        }
    }
}

/// Loads the scene that an entry of a plan names.
fn load<H: Host>(entry: &SceneEntry, plan: &Plan, host: &mut H) -> Result<Loaded, H::Error> {
    host.remark(&format!("loading {}", entry.title()));
    let LoadedScene { stem, scene } = host.load(entry, voxels_of(&entry.name, plan.voxels))?;
    Ok(Loaded { stem, scene: Arc::new(scene) })
}

/// Voxels are asked of built-in scenes alone.
fn voxels_of(name: &str, voxels: Option<u64>) -> Option<u64> {
    voxels.filter(|_| scenes::STUDY_NAMES.contains(&name))
}

/// What a cell gave, in a few words.
fn outcome(row: &Row) -> String {
    match (row.summary(), &row.measured.failure) {
        (Some(summary), None) => format!("{:.3} ms median, {:.1} fps", summary.median, summary.fps),
        (_, Some(reason)) => format!("failed: {reason}"),
        (None, None) => "interrupted".into(),
    }
}

/// The first frame of every cell of a scene.
fn frame(scene: &PackedScene, plan: &Plan) -> Frame {
    let (width, height) = (plan.width, plan.height);
    let auto = || Camera { name: "auto".into(), ..scene.overview(width as f32 / height as f32) };
    Frame::new(scene.cameras.first().cloned().unwrap_or_else(auto), width, height)
        .samples(0)
        .seed(plan.seed)
        .max_bounces(plan.max_bounces)
        .integrator(plan.integrator)
}
