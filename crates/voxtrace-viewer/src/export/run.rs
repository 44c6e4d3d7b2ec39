//! The work of an export: a tracer with the scene, frame by frame.

use super::{Existing, ExportRequest, Job, Watch};
use crate::engine::Backend;
use crate::tr;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use voxtrace::import::opened::Inputs;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::{CpuTracer, Film, PackedScene, Region, TraceError, Tracer};
use voxtrace_vulkan::{Device, VulkanTracer};

/// Milliseconds of a piece of work on a device that draws the window as well.
const DEVICE_MS: f64 = 10.0;

/// What is traced, and with what.
pub struct Source {
    /// The scene with what was changed about it, in its own light: pictures carry its hash.
    pub changed: Arc<PackedScene>,
    /// The scene in its light.
    pub lit: Arc<PackedScene>,
    /// What traces.
    pub backend: Backend,
    /// The device of the window.
    pub device: Option<Arc<Device>>,
}

/// How an export ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// Everything is written.
    Done,
    /// Somebody stopped it.
    Cancelled,
    /// One line for people.
    Failed(String),
}

/// What came of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Pictures that were written.
    pub written: usize,
    /// Pictures that were there already and stayed.
    pub kept: usize,
    /// What was mended on the way.
    pub notes: Vec<String>,
    /// How it ended.
    pub end: End,
}

impl Outcome {
    /// Of an export that wrote nothing.
    pub fn failed(reason: String) -> Self {
        Self { written: 0, kept: 0, notes: Vec::new(), end: End::Failed(reason) }
    }
}

/// Does all of an export on this thread.
pub fn export(request: &ExportRequest, source: Source, watch: &Watch) -> Outcome {
    let mut outcome = Outcome { written: 0, kept: 0, notes: Vec::new(), end: End::Done };
    outcome.end = match work(request, source, watch, &mut outcome) {
        Err(reason) => End::Failed(reason),
        Ok(()) if watch.is_cancelled() && outcome.written + outcome.kept < request.jobs.len() => End::Cancelled,
        Ok(()) => End::Done,
    };
    outcome
}

fn work(request: &ExportRequest, source: Source, watch: &Watch, outcome: &mut Outcome) -> Result<(), String> {
    let inputs = Inputs::now();
    for job in &request.jobs {
        let path = job.path.display();
        inputs.refuse(&job.path).map_err(|error| tr!("said.cannot_write", path = path, error = error))?;
        if request.existing == Existing::Refuse && job.path.exists() {
            return Err(tr!("said.is_there", path = path));
        }
    }
    let folder = request.jobs.first().and_then(|job| job.path.parent()).unwrap_or(Path::new(""));
    std::fs::create_dir_all(folder)
        .map_err(|error| tr!("running.no_folder", folder = folder.display(), error = error))?;
    let mut tracer = open_tracer(&source, &mut outcome.notes).map_err(|error| error.to_string())?;
    // The light that was chosen is the picture's; the hash is that of the scene itself.
    let mut stamp = SceneStamp::of(&source.changed);
    (stamp.sky, stamp.light_intensity) = (source.lit.sky.clone(), source.lit.light_intensity);
    stamp.cuts = source.lit.cuts.clone();
    for job in &request.jobs {
        if watch.is_cancelled() {
            return Ok(());
        }
        if request.existing == Existing::Keep && job.path.exists() {
            outcome.kept += 1;
            watch.kept.fetch_add(1, Ordering::Relaxed);
        } else {
            let progress = watch.begin();
            let rendered = tracer.render(&job.frame, &progress);
            outcome.notes.extend(tracer.take_notes());
            rendered.map_err(|error| error.to_string())?;
            if progress.is_cancelled() {
                return Ok(());
            }
            write(job, tracer.as_mut(), &stamp, request)?;
            outcome.written += 1;
        }
        watch.begin();
        watch.done.fetch_add(1, Ordering::Relaxed);
    }
    Ok(())
}

/// A tracer with the scene. Where a second one does not fit the device, the processor makes the same picture.
fn open_tracer(source: &Source, notes: &mut Vec<String>) -> Result<Box<dyn Tracer>, TraceError> {
    if let (Backend::Device(settings), Some(device)) = (source.backend, &source.device) {
        let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
        tracer.set_submit_ms(DEVICE_MS);
        match tracer.set_scene(&source.lit) {
            Ok(()) => return Ok(Box::new(tracer)),
            Err(error @ TraceError::OutOfMemory { .. }) => {
                notes.push(tr!("said.traced_on_cpu", error = error));
            }
            Err(error) => return Err(error),
        }
    }
    let mut tracer = Box::new(CpuTracer::new(None));
    tracer.set_scene(&source.lit)?;
    Ok(tracer)
}

fn write(job: &Job, tracer: &mut dyn Tracer, stamp: &SceneStamp, request: &ExportRequest) -> Result<(), String> {
    let mut film = Film::new(0, 0, Region::full(0, 0), 0);
    tracer.read(&mut film).map_err(|error| error.to_string())?;
    let path = job.path.display();
    // Another program may have made it meanwhile.
    if request.existing == Existing::Refuse && job.path.exists() {
        return Err(tr!("said.is_there", path = path));
    }
    let file = FilmFile { frame: job.frame.clone(), scene: stamp.clone(), film };
    file.save_picture(&job.path, &request.options())
        .map_err(|error| tr!("said.cannot_write", path = path, error = error))
}
