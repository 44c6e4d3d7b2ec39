//! Frames of a cell as CSV lines, and the numbers that a report draws from them.

mod interval;
mod rounds;

pub use rounds::{FEWEST_ROUNDS, ratio_of_rounds};

use interval::Intervals;
use std::io::{self, Write};

/// First line of every CSV.
pub const HEADER: &str = "frame,gpu_ms,wall_ms,rays,sequence";

/// One frame that was proved rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameLine {
    /// Its number among the frames begun; a number that is missing is a frame that was lost.
    pub frame: u32,
    /// The device's own clock; `None` on the CPU.
    pub gpu_ms: Option<f64>,
    pub wall_ms: f64,
    /// All rays, counted where they were traced; `None` in what earlier versions measured on the CPU.
    pub rays: Option<u64>,
    /// What the shaders of its last submit wrote; on the CPU the number of the sample that every pixel got.
    pub sequence: u32,
}

impl FrameLine {
    /// A frame with its times to the nanosecond and the microsecond, all that clocks know: a CSV holds them whole.
    pub fn new(frame: u32, gpu_ms: Option<f64>, wall_ms: f64, rays: Option<u64>, sequence: u32) -> Self {
        let round = |ms: f64, unit: f64| (ms * unit).round() / unit;
        let gpu_ms = gpu_ms.map(|ms| round(ms, 1e6));
        Self { frame, gpu_ms, wall_ms: round(wall_ms, 1e3), rays, sequence }
    }

    /// The time that counts: the device's where there is one.
    pub fn ms(&self) -> f64 {
        self.gpu_ms.unwrap_or(self.wall_ms)
    }
}

/// Writes frames so that reading them gives the same numbers to the bit.
pub fn write_csv(frames: &[FrameLine], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{HEADER}")?;
    for line in frames {
        let gpu_ms = line.gpu_ms.map_or(String::new(), |ms| ms.to_string());
        let rays = line.rays.map_or(String::new(), |rays| rays.to_string());
        writeln!(out, "{},{gpu_ms},{},{rays},{}", line.frame, line.wall_ms, line.sequence)?;
    }
    Ok(())
}

/// A CSV that [`write_csv`] did not write.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CsvError {
    #[error("the first line is not {HEADER}")]
    Header,
    #[error("{0:?} is no frame")]
    Line(String),
}

/// Reads what [`write_csv`] wrote.
///
/// # Errors
/// The line that is no frame.
pub fn read_csv(text: &str) -> Result<Vec<FrameLine>, CsvError> {
    let mut lines = text.lines();
    if lines.next() != Some(HEADER) {
        return Err(CsvError::Header);
    }
    let parse = |line: &str| {
        let mut fields = line.split(',');
        let mut next = || fields.next();
        let frame = next()?.parse().ok()?;
        let gpu_ms = next().map(|text| (!text.is_empty()).then(|| text.parse::<f64>()).transpose())?.ok()?;
        let wall_ms = next()?.parse().ok()?;
        let rays = next().map(|text| (!text.is_empty()).then(|| text.parse::<u64>()).transpose())?.ok()?;
        let sequence = next()?.parse().ok()?;
        next().is_none().then_some(FrameLine { frame, gpu_ms, wall_ms, rays, sequence })
    };
    lines.map(|line| parse(line).ok_or_else(|| CsvError::Line(line.to_owned()))).collect()
}

/// What the frames of a cell come to. Times are milliseconds of [`FrameLine::ms`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    pub frames: usize,
    pub mean: f64,
    pub median: f64,
    pub p1: f64,
    pub p99: f64,
    pub fps: f64,
    pub wall_mean: f64,
    /// Mean of a frame.
    pub rays: Option<f64>,
    /// Where mean and median lie with a certainty of 95 %; `None` of few frames.
    pub intervals: Option<Intervals>,
}

impl Summary {
    /// The summary of frames; `None` of none.
    pub fn of(frames: &[FrameLine]) -> Option<Self> {
        if frames.is_empty() {
            return None;
        }
        let count = frames.len() as f64;
        let mut ms: Vec<f64> = frames.iter().map(FrameLine::ms).collect();
        let intervals = Intervals::of(&ms);
        ms.sort_by(f64::total_cmp);
        let mean = ms.iter().sum::<f64>() / count;
        let rays: Option<Vec<u64>> = frames.iter().map(|line| line.rays).collect();
        Some(Self {
            frames: frames.len(),
            mean,
            median: percentile(&ms, 0.5),
            p1: percentile(&ms, 0.01),
            p99: percentile(&ms, 0.99),
            fps: 1000.0 / mean,
            wall_mean: frames.iter().map(|line| line.wall_ms).sum::<f64>() / count,
            rays: rays.map(|rays| rays.iter().sum::<u64>() as f64 / count),
            intervals,
        })
    }
}

/// Between the two nearest ranks of sorted values, as most tools do.
fn percentile(sorted: &[f64], part: f64) -> f64 {
    let at = part * (sorted.len() - 1) as f64;
    let (low, high) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
    low + (high - low) * at.fract()
}

/// Billions of rays a second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Speeds {
    pub all: Option<f64>,
    pub primary: Option<f64>,
    /// Of the rays and the time that a frame has beyond one of camera rays alone.
    pub bounce: Option<f64>,
}

impl Speeds {
    /// From the summary of a cell and of the same cell without bounces.
    pub fn of(summary: &Summary, primary: Option<&Summary>) -> Self {
        // Rays a millisecond / 10⁶ = Grays a second.
        let speed = |rays: f64, ms: f64| (rays > 0.0 && ms > 0.0).then(|| rays / ms / 1e6);
        let all = summary.rays.and_then(|rays| speed(rays, summary.median));
        let primary = primary.and_then(|primary| Some((primary.rays?, primary.median)));
        Self {
            all,
            primary: primary.and_then(|(rays, ms)| speed(rays, ms)),
            bounce: primary.and_then(|(rays, ms)| speed(summary.rays? - rays, summary.median - ms)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(frame: u32, ms: f64, rays: u64) -> FrameLine {
        FrameLine { frame, gpu_ms: Some(ms), wall_ms: ms + 1.0, rays: Some(rays), sequence: frame + 7 }
    }

    #[test]
    fn percentiles_lie_between_ranks() {
        let frames: Vec<FrameLine> = (0..101).map(|i| line(i, f64::from((i * 37) % 101), 10)).collect();
        let summary = Summary::of(&frames).unwrap();
        assert_eq!((summary.p1, summary.median, summary.p99), (1.0, 50.0, 99.0));
        assert_eq!((summary.mean, summary.fps, summary.rays), (50.0, 20.0, Some(10.0)));
        assert_eq!(percentile(&[1.0, 2.0], 0.5), 1.5);
        assert_eq!(Summary::of(&[]), None);
    }

    #[test]
    fn bounces_get_the_time_and_the_rays_beyond_camera_rays() {
        let all = Summary::of(&[line(0, 4.0, 8_000_000)]).unwrap();
        let primary = Summary::of(&[line(0, 1.0, 2_000_000)]).unwrap();
        let speeds = Speeds::of(&all, Some(&primary));
        assert_eq!((speeds.all, speeds.primary, speeds.bounce), (Some(2.0), Some(2.0), Some(2.0)));
        assert_eq!(Speeds::of(&primary, Some(&all)).bounce, None);
    }

    #[test]
    fn a_csv_holds_every_digit() {
        let mut bytes = Vec::new();
        let frames = [line(3, 0.1 + 0.2, 5), FrameLine { gpu_ms: None, rays: None, ..line(4, 7.0, 0) }];
        write_csv(&frames, &mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(text, format!("{HEADER}\n3,0.30000000000000004,1.3,5,10\n4,,8,,11\n"));
        assert_eq!(read_csv(&text), Ok(frames.to_vec()));
        assert!(read_csv("frame\n").is_err());
        for wrong in ["3", "3,1,2,3", "3,1,2,3,4,5", "x,1,2,3,4", "3,1,,3,4"] {
            assert!(read_csv(&format!("{HEADER}\n{wrong}\n")).unwrap_err().to_string().contains(wrong), "{wrong}");
        }
    }

    #[test]
    fn times_are_kept_to_what_clocks_know() {
        let line = FrameLine::new(0, Some(6.854_144_000_000_001), 7.123_456_7, None, 1);
        assert_eq!((line.gpu_ms, line.wall_ms), (Some(6.854144), 7.123));
    }
}
