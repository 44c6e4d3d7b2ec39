//! What else there is to know about the machine: its system and processor, and clocks, heat and power where they can
//! be read. What cannot be read is left out, never an error.

use serde_json::{Map, Value, json};
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What is asked of `nvidia-smi`, and the names in the results.
const NVIDIA: [(&str, &str); 6] = [
    ("clocks.sm", "sm_mhz"),
    ("clocks.mem", "memory_mhz"),
    ("temperature.gpu", "celsius"),
    ("power.draw", "watts"),
    ("utilization.gpu", "busy_percent"),
    ("memory.used", "memory_used_mib"),
];
/// Longest wait for `nvidia-smi`.
const PATIENCE: Duration = Duration::from_secs(5);

/// System, processor and threads.
pub fn host() -> Value {
    let mut host = json!({
        "os": std::env::consts::OS, "arch": std::env::consts::ARCH,
        "threads": rayon::current_num_threads(), "simd": voxtrace::CpuTracer::simd_name(),
    });
    let release = std::fs::read_to_string("/etc/os-release").ok();
    let system = release.as_deref().and_then(|text| value_of(text, "PRETTY_NAME", '='));
    let kernel = std::fs::read_to_string("/proc/sys/kernel/osrelease").ok().map(|text| text.trim().to_owned());
    let cpuinfo = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = value_of(&cpuinfo, "model name", ':');
    for (name, value) in [("system", system), ("kernel", kernel), ("processor", processor)] {
        if let Some(value) = value {
            host[name] = value.into();
        }
    }
    host
}

/// Clocks now, of the processor and, where it is an NVIDIA card, of the device of that name; null where nothing can
/// be read.
pub fn clocks(device: Option<&str>) -> Value {
    let mut clocks = Map::new();
    let cpuinfo = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let mhz: Vec<f64> = values_of(&cpuinfo, "cpu MHz", ':').filter_map(|text| text.parse().ok()).collect();
    if !mhz.is_empty() {
        let mean = mhz.iter().sum::<f64>() / mhz.len() as f64;
        clocks.insert("cpu_mhz".into(), mean.round().into());
    }
    let load = std::fs::read_to_string("/proc/loadavg").ok();
    if let Some(load) = load.and_then(|text| text.split(' ').next()?.parse::<f64>().ok()) {
        clocks.insert("load".into(), load.into());
    }
    if let Some(name) = device.filter(|name| name.contains("NVIDIA")) {
        let fields = NVIDIA.map(|(query, _)| query).join(",");
        let arguments = [format!("--query-gpu=name,{fields}"), "--format=csv,noheader,nounits".into()];
        let told = output_of(Command::new("nvidia-smi").args(arguments));
        clocks.extend(told.and_then(|text| nvidia(&text, name)).unwrap_or_default());
    }
    if clocks.is_empty() { Value::Null } else { Value::Object(clocks) }
}

/// The line of a device of this name in what `nvidia-smi` printed.
fn nvidia(text: &str, name: &str) -> Option<Map<String, Value>> {
    let mut lines = text.lines().map(|line| line.split(',').map(str::trim).collect::<Vec<_>>());
    let line = lines.find(|line| line.first() == Some(&name))?;
    let numbers = NVIDIA.iter().zip(&line[1..]);
    let numbers = numbers.filter_map(|((_, name), text)| Some(((*name).to_owned(), text.parse::<f64>().ok()?.into())));
    Some(numbers.collect())
}

/// What a program prints, unless it is not there, fails, or takes too long.
fn output_of(command: &mut Command) -> Option<String> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?;
    let start = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) if status.success() => break,
            Ok(None) if start.elapsed() < PATIENCE => std::thread::sleep(Duration::from_millis(5)),
            _ => {
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
        }
    }
    let mut text = String::new();
    child.stdout.take()?.take(1 << 16).read_to_string(&mut text).ok()?;
    Some(text)
}

/// The values of all lines `name SEPARATOR value`, without quotation marks.
fn values_of<'a>(text: &'a str, name: &'a str, separator: char) -> impl Iterator<Item = String> + 'a {
    let lines = text.lines().filter_map(move |line| line.split_once(separator));
    lines.filter(move |(key, _)| key.trim() == name).map(|(_, value)| value.trim().trim_matches('"').to_owned())
}

fn value_of(text: &str, name: &str, separator: char) -> Option<String> {
    values_of(text, name, separator).next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_of_the_device_is_read_and_what_is_no_number_left_out() {
        let text = "NVIDIA A10, 210, 405, 30, 20.1, 0, 4\nNVIDIA H200, 1980, 3201, 44, 412.50, 98, [N/A]\n";
        let clocks = nvidia(text, "NVIDIA H200").unwrap();
        assert_eq!((&clocks["sm_mhz"], &clocks["watts"]), (&1980.0.into(), &412.5.into()));
        assert_eq!(clocks.get("memory_used_mib"), None);
        assert_eq!(nvidia(text, "NVIDIA H100"), None);
        assert_eq!(nvidia("", "NVIDIA H200"), None);
    }

    #[test]
    fn what_cannot_be_run_gives_nothing() {
        assert_eq!(output_of(&mut Command::new("/nowhere/nvidia-smi")), None);
        assert!(clocks(Some("NVIDIA of nowhere")).get("sm_mhz").is_none());
    }

    #[test]
    fn names_in_system_files_are_read_without_quotation_marks() {
        let text = "NAME=\"Some\"\nPRETTY_NAME=\"Some Linux 12\"\n";
        assert_eq!(value_of(text, "PRETTY_NAME", '=').as_deref(), Some("Some Linux 12"));
        let mhz: Vec<String> = values_of("cpu MHz\t\t: 2600.0\nflags : a\ncpu MHz : 2700.5", "cpu MHz", ':').collect();
        assert_eq!(mhz, ["2600.0", "2700.5"]);
    }
}
