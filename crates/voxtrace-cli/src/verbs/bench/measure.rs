//! Measuring one cell: a frame is one sample a pixel, and counts only where the device proved that it ran.

use super::cells::Cell;
use super::conformance::{Conformance, Reference};
use super::machine;
use super::numbers::FrameLine;
use super::proof::{self, Said};
use crate::failure::Failure;
use crate::interrupt;
use crate::report::Report;
use crate::session::trace_failure;
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::{CpuTracer, Film, Frame, Hit, PackedScene, Progress, Region, TraceError, Tracer};
use voxtrace_vulkan::{AccelReport, Device, Options, Settings, Traversal, VulkanTracer};

/// Frames without bounces, for the speed of camera rays.
const PRIMARY_FRAMES: u32 = 64;
/// A cell that loses this many frames in a row is given up.
const MOST_LOST: u32 = 8;
/// Frames between two looks at the whole film.
const FILM_EVERY: u32 = 512;

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

/// What a cell gave, whole or not.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    pub frames: Vec<FrameLine>,
    pub primary: Vec<FrameLine>,
    pub lost: u32,
    /// Why there are no frames, or no more of them.
    pub failure: Option<String>,
    pub is_interrupted: bool,
    pub notes: Vec<String>,
    pub memory: Option<Memory>,
    /// How often the whole film was read and held every frame.
    pub film_checks: u32,
    /// Clocks before the first frame and after the last, see [`machine::clocks`].
    pub clocks: [Value; 2],
    pub conformance: Option<Conformance>,
    /// Whether what the device reads of time is its own clock.
    pub has_gpu_clock: bool,
    /// The picture, and what the rays through the middles of its pixels met; not kept in the results.
    pub film: Option<Film>,
    pub hits: Vec<Hit>,
}

/// Bytes on the device by name, as the driver says that it needs them.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    pub bytes: BTreeMap<String, u64>,
    pub total: u64,
    pub peak: u64,
    pub accel: Option<AccelReport>,
}

/// What traces a cell.
enum Place {
    Device(Box<VulkanTracer>),
    Cpu(Box<CpuTracer>),
}

impl Place {
    fn open(cell: Cell, effort: &Effort) -> Result<Self, TraceError> {
        if cell.traversal == Traversal::Cpu {
            return Ok(Self::Cpu(Box::new(CpuTracer::new(None))));
        }
        let settings = Settings {
            traversal: cell.traversal,
            primitive: cell.primitive.unwrap_or_default(),
            is_exact: effort.is_exact,
        };
        let device = open_device(effort.device.as_deref())?;
        Ok(Self::Device(Box::new(VulkanTracer::new(device, settings)?)))
    }

    /// Whether the device has a clock of its own.
    fn has_clock(&self) -> bool {
        matches!(self, Self::Device(tracer) if tracer.device().info().limits.timestamp_period_ns > 0.0)
    }

    fn device_name(&self) -> Option<String> {
        match self {
            Self::Device(tracer) => Some(tracer.device().info().name.clone()),
            Self::Cpu(_) => None,
        }
    }

    fn tracer(&mut self) -> &mut dyn Tracer {
        match self {
            Self::Device(tracer) => tracer.as_mut(),
            Self::Cpu(tracer) => tracer.as_mut(),
        }
    }
}

/// The device asked for, or the best hardware, or else the first device in software.
pub fn open_device(wanted: Option<&str>) -> Result<Arc<Device>, TraceError> {
    let open = |wanted| Device::open(Options::from_environment(), wanted, None);
    match wanted {
        Some(_) => open(wanted),
        None => open(None).or_else(|error| open(Some("0")).map_err(|_| error)),
    }
}

/// Measures a cell, and compares what it finds with the reference. What fails is told in the result, so that the other
/// cells still run.
pub fn measure(
    cell: Cell,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    reference: Option<&Reference>,
    effort: &Effort,
    report: &mut Report,
) -> Measured {
    let mut measured = Measured::default();
    if let Err(error) = try_measure(cell, scene, frame, reference, effort, report, &mut measured) {
        measured.failure = Some(trace_failure(error).line().trim_start_matches("error: ").to_owned());
    }
    measured
}

fn try_measure(
    cell: Cell,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    reference: Option<&Reference>,
    effort: &Effort,
    report: &mut Report,
    measured: &mut Measured,
) -> Result<(), TraceError> {
    let mut place = Place::open(cell, effort)?;
    measured.has_gpu_clock = place.has_clock();
    place.tracer().set_scene(scene)?;
    let peak = memory_of(&place).map_or(0, |memory| memory.peak);
    let device = place.device_name();
    let mut run = Run::new(&mut place, frame.clone());
    let quarter = effort.time_limit.map(|limit| limit / 4);
    run.frames(effort.warm_up, quarter, measured, Series::WarmUp, &mut |_| {})?;
    run.begun = 0;
    let clocks = || if effort.is_brief { Value::Null } else { machine::clocks(device.as_deref()) };
    measured.clocks[0] = clocks();
    run.frames(effort.frames, effort.time_limit, measured, Series::Main, &mut |done| report.update(done, None))?;
    measured.clocks[1] = clocks();
    measured.film = run.film.take();
    measured.memory = memory_of(run.place).map(|memory| Memory { peak: memory.peak.max(peak), ..memory });
    if !measured.is_interrupted && !effort.is_brief && frame.max_bounces > 0 {
        run.frame = Frame { max_bounces: 0, samples: 0, ..frame.clone() };
        if matches!(&*run.place, Place::Cpu(_)) {
            run.sequence = 0;
        }
        run.frames(effort.warm_up.min(8), quarter, measured, Series::WarmUp, &mut |_| {})?;
        run.begun = 0;
        run.frames(effort.frames.min(PRIMARY_FRAMES), quarter, measured, Series::Primary, &mut |_| {})?;
    }
    if let Some(reference) = reference.filter(|_| !measured.is_interrupted) {
        let mut hits = vec![Hit::MISS; reference.rays.len()];
        place.tracer().cast(&reference.rays, &mut hits)?;
        measured.conformance = Some(Conformance::of(scene, reference, &hits));
        measured.hits = hits;
    }
    Ok(())
}

fn memory_of(place: &Place) -> Option<Memory> {
    let Place::Device(tracer) = place else { return None };
    let report = tracer.memory();
    Some(Memory {
        total: report.total_bytes(),
        peak: report.peak_bytes,
        bytes: report.entries,
        accel: tracer.accel_report(),
    })
}

/// Where frames go.
#[derive(Clone, Copy, PartialEq)]
enum Series {
    WarmUp,
    Main,
    Primary,
}

/// Frames of one film, one sample after the other.
struct Run<'a> {
    place: &'a mut Place,
    /// `samples` is how many every pixel of the film has.
    frame: Frame,
    begun: u32,
    /// Frames lost since the last one that was proved.
    in_a_row: u32,
    /// The last frame's sequence number.
    sequence: u32,
    /// Samples of the film, and frames of the series, when the film was last looked at.
    seen: (u32, usize),
    /// The film when it was last looked at.
    film: Option<Film>,
}

impl<'a> Run<'a> {
    fn new(place: &'a mut Place, frame: Frame) -> Self {
        Self { place, frame, begun: 0, in_a_row: 0, sequence: 0, seen: (0, 0), film: None }
    }

    fn frames(
        &mut self,
        count: u32,
        limit: Option<Duration>,
        measured: &mut Measured,
        series: Series,
        done: &mut dyn FnMut(u64),
    ) -> Result<(), TraceError> {
        let start = Instant::now();
        for index in 0..count {
            if interrupt::is_requested() {
                measured.is_interrupted = true;
                break;
            }
            if index > 0 && limit.is_some_and(|limit| start.elapsed() >= limit) {
                break;
            }
            match self.next(measured)? {
                Some(line) if series == Series::Main => measured.frames.push(line),
                Some(line) if series == Series::Primary => measured.primary.push(line),
                None if series != Series::WarmUp => measured.lost += 1,
                _ => {}
            }
            if series == Series::Main && (index + 1).is_multiple_of(FILM_EVERY) {
                self.check_film(measured)?;
            }
            done(u64::from(index) + 1);
        }
        if series == Series::Main { self.check_film(measured) } else { Ok(()) }
    }

    /// Reads the film, which must hold every frame since it began; where it does not, those since the last look are lost.
    fn check_film(&mut self, measured: &mut Measured) -> Result<(), TraceError> {
        if self.frame.samples == self.seen.0 {
            return Ok(());
        }
        let mut film = self.film.take().unwrap_or_else(|| Film::new(0, 0, Region::full(0, 0), 0));
        self.place.tracer().read(&mut film)?;
        let verdict = proof::judge_film(&film, self.frame.samples);
        self.film = Some(film);
        match verdict {
            Ok(()) => measured.film_checks += 1,
            Err(reason) => {
                let lost = measured.frames.len().saturating_sub(self.seen.1);
                measured.frames.truncate(self.seen.1);
                measured.lost += lost as u32;
                measured.notes.push(format!("{lost} frames before frame {} were lost: {reason}", self.begun));
                self.begin_film();
            }
        }
        self.seen = (self.frame.samples, measured.frames.len());
        Ok(())
    }

    /// Begins another film, at the next sample.
    fn begin_film(&mut self) {
        self.frame.first_sample += self.frame.samples;
        self.frame.samples = 0;
    }

    /// Renders the next frame; `None` where nothing proves that it ran.
    fn next(&mut self, measured: &mut Measured) -> Result<Option<FrameLine>, TraceError> {
        let number = self.begun;
        self.begun += 1;
        self.frame.samples += 1;
        let progress = Progress::default();
        let start = Instant::now();
        let result = self.place.tracer().render(&self.frame, &progress);
        let wall_ms = start.elapsed().as_secs_f64() * 1e3;
        let notes = self.place.tracer().take_notes();
        let error = match result {
            Ok(()) => None,
            Err(error @ TraceError::Device { .. }) => Some(error.to_string()),
            Err(error) => return Err(error),
        };
        let pixels = self.frame.region.pixels() as u64;
        let said = Said { error, is_mended: !notes.is_empty(), pixels, wall_ms, ..self.said(&progress, measured) };
        measured.notes.extend(notes);
        if matches!(&*self.place, Place::Device(tracer) if tracer.is_on_cpu()) {
            return Err(TraceError::DeviceLost { last_pass: "the benchmark, twice".into() });
        }
        // A device that was opened anew begins to count again.
        let last = if said.is_mended { 0 } else { self.sequence };
        let Err(reason) = proof::judge(&said, last) else {
            (self.in_a_row, self.sequence) = (0, said.sequence);
            return Ok(Some(self.line(number, &said)));
        };
        self.sequence = said.sequence;
        measured.notes.push(format!("frame {number} was lost: {reason}"));
        self.in_a_row += 1;
        if self.in_a_row >= MOST_LOST {
            return Err(TraceError::Device {
                step: "measuring".into(),
                reason: format!("{MOST_LOST} frames in a row were lost; {reason}"),
            });
        }
        // Part of the film may have the sample.
        self.begin_film();
        self.seen = (0, measured.frames.len());
        Ok(None)
    }

    /// What the tracer counted in the last frame.
    fn said(&self, progress: &Progress, measured: &Measured) -> Said {
        let nothing = Said {
            error: None,
            is_mended: false,
            pixels: 0,
            camera_rays: progress.samples_done(),
            submits: 1,
            sequence: self.frame.first_sample + self.frame.samples,
            gpu_ms: None,
            wall_ms: 0.0,
        };
        match &*self.place {
            Place::Cpu(_) => nothing,
            Place::Device(tracer) => {
                let counted = tracer.statistics();
                Said {
                    camera_rays: counted.camera_rays,
                    submits: counted.submits,
                    sequence: counted.sequence,
                    gpu_ms: measured.has_gpu_clock.then_some(counted.gpu_ms),
                    ..nothing
                }
            }
        }
    }

    fn line(&self, number: u32, said: &Said) -> FrameLine {
        let rays = match &*self.place {
            Place::Cpu(_) => None,
            Place::Device(tracer) => {
                let counted = tracer.statistics();
                Some(counted.camera_rays + counted.bounce_rays + counted.shadow_rays)
            }
        };
        FrameLine::new(number, said.gpu_ms, said.wall_ms, rays, said.sequence)
    }
}

/// The failure that ends an interrupted benchmark.
pub fn interrupted(folder: &std::path::Path) -> Failure {
    Failure::new(crate::failure::Kind::Interrupted, "interrupted")
        .hint(format!("what was measured is in {}", folder.display()))
}
