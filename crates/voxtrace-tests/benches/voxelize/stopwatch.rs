//! Wall-clock and processor time of the whole process (Linux); runs of ours alternate with runs of another program.

use crate::Options;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Wall-clock seconds, and processor seconds of all threads.
#[derive(Clone, Copy)]
pub struct Seconds {
    pub wall: f64,
    pub processor: f64,
}

/// Seconds of some work.
pub fn time<T, E>(work: impl FnOnce() -> Result<T, E>) -> Result<Seconds, E> {
    let (start, processor) = (Instant::now(), processor_seconds());
    work()?;
    Ok(Seconds { wall: start.elapsed().as_secs_f64(), processor: processor_seconds() - processor })
}

/// Seconds that all threads of this process have worked, in steps of a hundredth; not a number where the system does not say.
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // Behind the name, which may hold anything: times in user and kernel mode are the fields 14 and 15.
    let fields = text.rsplit_once(')').map_or("", |(_, rest)| rest);
    let ticks: Vec<f64> = fields.split_whitespace().skip(11).take(2).filter_map(|field| field.parse().ok()).collect();
    if ticks.len() == 2 { (ticks[0] + ticks[1]) / 100.0 } else { f64::NAN }
}

/// Alternates our work with reading a file by a Python library; prints the medians and the ratios of the rounds.
pub fn beside<E: Into<Box<dyn Error>>>(
    options: &Options,
    name: &str,
    file: &Path,
    mut work: impl FnMut() -> Result<(), E>,
) -> Result<Seconds, Box<dyn Error>> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/voxelize/scan_time.py");
    let (mut own, mut other) = (Vec::new(), Vec::new());
    for _ in 0..options.rounds.max(1) {
        own.push(time(&mut work).map_err(Into::into)?);
        let output = Command::new(&options.python).arg(&script).arg(file).output();
        let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
        let mut numbers = text.split_whitespace().filter_map(|word| word.parse().ok());
        if let (Some(wall), Some(processor)) = (numbers.next(), numbers.next()) {
            other.push(Seconds { wall, processor });
        }
    }
    let ratios = |pick: fn(&Seconds) -> f64| median(own.iter().zip(&other).map(|(a, b)| pick(a) / pick(b)));
    let mid = |all: &[Seconds]| Seconds {
        wall: median(all.iter().map(|s| s.wall)),
        processor: median(all.iter().map(|s| s.processor)),
    };
    let mine = mid(&own);
    print!("{name}: {:.2} s, {:.2} s of processors", mine.wall, mine.processor);
    if other.is_empty() {
        println!("; no Python that reads it");
    } else {
        let (theirs, wall, processor) = (mid(&other), ratios(|s| s.wall), ratios(|s| s.processor));
        println!(
            "; read only, by Python: {:.2} s, {:.2} s of processors; ratio {wall:.2}, of processors {processor:.2}",
            theirs.wall, theirs.processor
        );
    }
    Ok(mine)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
