//! Measuring one cell: a frame is one sample a pixel, and counts only where the device proved that it ran.

use super::cells::Cell;
use super::numbers::FrameLine;
use crate::failure::Failure;
use crate::interrupt;
use crate::report::Report;
use crate::session::trace_failure;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::{CpuTracer, Frame, PackedScene, Progress, TraceError, Tracer};
use voxtrace_vulkan::{AccelReport, Device, Options, Settings, Traversal, VulkanTracer};

/// Frames without bounces, for the speed of camera rays.
const PRIMARY_FRAMES: u32 = 64;
/// A cell that loses this many frames in a row is given up.
const MOST_LOST: u32 = 8;

/// How long and on what to measure.
#[derive(Clone, Debug)]
pub struct Effort {
    pub frames: u32,
    pub warm_up: u32,
    /// Ends warm-up at a quarter of it, and the frames at the whole; at least one of each is rendered.
    pub time_limit: Option<Duration>,
    pub is_exact: bool,
    pub device: Option<String>,
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

/// Measures a cell. What fails is told in the result, so that the other cells still run.
pub fn measure(cell: Cell, scene: &Arc<PackedScene>, frame: &Frame, effort: &Effort, report: &mut Report) -> Measured {
    let mut measured = Measured::default();
    if let Err(error) = try_measure(cell, scene, frame, effort, report, &mut measured) {
        measured.failure = Some(trace_failure(error).line().trim_start_matches("error: ").to_owned());
    }
    measured
}

fn try_measure(
    cell: Cell,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    effort: &Effort,
    report: &mut Report,
    measured: &mut Measured,
) -> Result<(), TraceError> {
    let mut place = Place::open(cell, effort)?;
    place.tracer().set_scene(scene)?;
    let peak = memory_of(&place).map_or(0, |memory| memory.peak);
    let mut run = Run { place: &mut place, frame: frame.clone(), begun: 0, in_a_row: 0 };
    let quarter = effort.time_limit.map(|limit| limit / 4);
    run.frames(effort.warm_up, quarter, measured, Series::WarmUp, &mut |_| {})?;
    measured.lost = 0;
    run.begun = 0;
    run.frames(effort.frames, effort.time_limit, measured, Series::Main, &mut |done| report.update(done, None))?;
    measured.memory = memory_of(run.place).map(|memory| Memory { peak: memory.peak.max(peak), ..memory });
    if !measured.is_interrupted && frame.max_bounces > 0 {
        run.frame = Frame { max_bounces: 0, samples: 0, ..frame.clone() };
        run.frames(effort.warm_up.min(8), quarter, measured, Series::WarmUp, &mut |_| {})?;
        run.begun = 0;
        run.frames(effort.frames.min(PRIMARY_FRAMES), quarter, measured, Series::Primary, &mut |_| {})?;
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
}

impl Run<'_> {
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
                return Ok(());
            }
            if index > 0 && limit.is_some_and(|limit| start.elapsed() >= limit) {
                return Ok(());
            }
            match self.next(measured)? {
                Some(line) if series == Series::Main => measured.frames.push(line),
                Some(line) if series == Series::Primary => measured.primary.push(line),
                Some(_) => {}
                None => measured.lost += 1,
            }
            done(u64::from(index) + 1);
        }
        Ok(())
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
        let pixels = self.frame.region.pixels() as u64;
        let line = match (&result, &*self.place) {
            (Err(TraceError::Device { .. }), _) => None,
            (Err(error), _) => return Err(error.clone()),
            (Ok(()), Place::Device(tracer)) if tracer.is_on_cpu() => {
                measured.notes.extend(notes);
                return Err(TraceError::DeviceLost { last_pass: "the benchmark, twice".into() });
            }
            // Every submit's sequence number and workgroups were checked by the tracer; here, that every pixel got
            // its sample and no loss of the device lies between.
            (Ok(()), Place::Device(tracer)) => {
                let counted = tracer.statistics();
                (counted.camera_rays == pixels && notes.is_empty()).then(|| FrameLine {
                    frame: number,
                    gpu_ms: Some(counted.gpu_ms),
                    wall_ms,
                    rays: Some(counted.camera_rays + counted.bounce_rays + counted.shadow_rays),
                    sequence: counted.sequence,
                })
            }
            (Ok(()), Place::Cpu(_)) => (progress.samples_done() == pixels).then_some(FrameLine {
                frame: number,
                gpu_ms: None,
                wall_ms,
                rays: None,
                sequence: self.frame.samples,
            }),
        };
        measured.notes.extend(notes);
        if line.is_some() {
            self.in_a_row = 0;
            return Ok(line);
        }
        let why = result.err().map_or("not every pixel got its sample".into(), |error| error.to_string());
        measured.notes.push(format!("frame {number} was lost: {why}"));
        self.in_a_row += 1;
        if self.in_a_row >= MOST_LOST {
            return Err(TraceError::Device {
                step: "measuring".into(),
                reason: format!("{MOST_LOST} frames in a row were lost; {why}"),
            });
        }
        // Part of the film may have the sample: begin another one, at the next sample.
        self.frame.first_sample += self.frame.samples;
        self.frame.samples = 0;
        Ok(None)
    }
}

/// The failure that ends an interrupted benchmark.
pub fn interrupted(folder: &std::path::Path) -> Failure {
    Failure::new(crate::failure::Kind::Interrupted, "interrupted")
        .hint(format!("what was measured is in {}", folder.display()))
}
