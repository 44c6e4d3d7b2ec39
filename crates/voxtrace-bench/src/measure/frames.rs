//! Rendering frames of one cell one after the other, each proved; what is not proved is lost.

use super::backend::Backend;
use super::measured::Measured;
use super::proof::{self, Said};
use crate::monitor::Monitor;
use crate::numbers::FrameLine;
use std::time::{Duration, Instant};
use voxtrace::{Film, Frame, Progress, Region, TraceError};

/// A cell that loses this many frames in a row is given up.
const MOST_LOST: u32 = 8;
/// Frames between two looks at the whole film.
const FILM_EVERY: u32 = 512;

/// A limit of time is stretched so many times where frames are too few else.
const LONGEST: u32 = 8;

/// How many frames.
#[derive(Clone, Copy, Debug)]
pub struct Amount {
    pub count: u32,
    pub least: u32,
    pub limit: Option<Duration>,
}

impl Amount {
    /// So many, or as many as a limit lets.
    pub fn within(count: u32, limit: Option<Duration>) -> Self {
        Self { count, least: 1, limit }
    }
}

/// Where frames go.
#[derive(Clone, Copy, PartialEq)]
pub enum Series {
    WarmUp,
    Main,
    Primary,
}

/// Frames of one film, one sample after the other.
pub struct Run<'a> {
    pub backend: &'a mut Backend,
    /// `samples` is how many every pixel of the film has.
    pub frame: Frame,
    pub begun: u32,
    /// Whether the frames are of the main series.
    is_main: bool,
    /// Frames lost since the last one that was proved.
    in_a_row: u32,
    /// The last frame's sequence number.
    pub sequence: u32,
    /// Samples of the film, and frames of the series, when the film was last looked at.
    seen: (u32, usize),
    /// The film when it was last looked at.
    pub film: Option<Film>,
}

impl<'a> Run<'a> {
    pub fn new(backend: &'a mut Backend, frame: Frame) -> Self {
        Self { backend, frame, begun: 0, is_main: false, in_a_row: 0, sequence: 0, seen: (0, 0), film: None }
    }

    /// Renders up to `count` frames, as many as `limit` lets, at least one; where they are slow up to `least` beyond it, but no more than
    /// [`LONGEST`] times as long.
    pub fn frames(
        &mut self,
        Amount { count, least, limit }: Amount,
        measured: &mut Measured,
        series: Series,
        monitor: &mut dyn Monitor,
    ) -> Result<(), TraceError> {
        let start = Instant::now();
        self.is_main = series == Series::Main;
        for index in 0..count {
            if monitor.is_interrupted() {
                measured.is_interrupted = true;
                break;
            }
            let limit = limit.map(|limit| if index < least { limit.saturating_mul(LONGEST) } else { limit });
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
            if series == Series::Main {
                monitor.update(u64::from(self.begun));
            }
        }
        if series == Series::Main { self.check_film(measured) } else { Ok(()) }
    }

    /// Reads the film, which must hold every frame since it began; where it does not, those since the last look are lost.
    fn check_film(&mut self, measured: &mut Measured) -> Result<(), TraceError> {
        if self.frame.samples == self.seen.0 {
            return Ok(());
        }
        let mut film = self.film.take().unwrap_or_else(|| Film::new(0, 0, Region::full(0, 0), 0));
        self.backend.tracer().read(&mut film)?;
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
        let result = self.backend.tracer().render(&self.frame, &progress);
        let wall_ms = start.elapsed().as_secs_f64() * 1e3;
        let notes = self.backend.tracer().take_notes();
        let error = match result {
            Ok(()) => None,
            Err(error @ TraceError::Device { .. }) => Some(error.to_string()),
            Err(error) => return Err(error),
        };
        let pixels = self.frame.region.pixels() as u64;
        let said = Said { error, is_mended: !notes.is_empty(), pixels, wall_ms, ..self.said(measured) };
        measured.notes.extend(notes);
        if matches!(&*self.backend, Backend::Device(tracer) if tracer.is_on_cpu()) {
            return Err(TraceError::DeviceLost { last_pass: "the benchmark, twice".into() });
        }
        // A device that was opened anew begins to count again.
        let last = if said.is_mended { 0 } else { self.sequence };
        let Err(reason) = proof::judge(&said, last) else {
            (self.in_a_row, self.sequence) = (0, said.sequence);
            if let (Backend::Cpu(tracer), Some(walked), true) = (&*self.backend, &mut measured.walked, self.is_main) {
                walked.add(&tracer.ray_counts());
            }
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
    fn said(&self, measured: &Measured) -> Said {
        let nothing = Said {
            error: None,
            is_mended: false,
            pixels: 0,
            camera_rays: 0,
            submits: 1,
            sequence: self.frame.first_sample + self.frame.samples,
            gpu_ms: None,
            wall_ms: 0.0,
        };
        match &*self.backend {
            Backend::Cpu(tracer) => Said { camera_rays: tracer.ray_counts().camera, ..nothing },
            Backend::Device(tracer) => {
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
        let rays = match &*self.backend {
            Backend::Cpu(tracer) => tracer.ray_counts().total(),
            Backend::Device(tracer) => {
                let counted = tracer.statistics();
                counted.camera_rays + counted.bounce_rays + counted.shadow_rays
            }
        };
        FrameLine::new(number, said.gpu_ms, said.wall_ms, Some(rays), said.sequence)
    }
}
