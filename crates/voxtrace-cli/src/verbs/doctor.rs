//! `voxtrace doctor`: what this machine has to trace with, what is missing and how to get it; with `--rt` what the ray tracing of
//! its driver is worth.

mod advice;
mod host;
mod manifests;
mod tables;

use crate::failure::{Failure, Kind};
use crate::report::Report;
use crate::session::trace_failure;
use crate::{interrupt, probes};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Instant;
use voxtrace::TraceError;
use voxtrace::output::write_atomically;
use voxtrace_vulkan::probe::{self, Cached, Effort, ProbeReport};
use voxtrace_vulkan::{Device, DeviceInfo, Options, Traversal, devices, missing};

/// Check what this machine can trace with, and its GPU driver
#[derive(clap::Args, Clone, Debug)]
pub struct DoctorArgs {
    /// Probe the driver's ray tracing, P1 to P19, in about two seconds, and remember the result
    #[arg(long)]
    rt: bool,
    /// All sizes of the probes: a minute or more
    #[arg(long, requires = "rt")]
    full: bool,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Also write the probes' result to this folder, as DEVICE-DRIVER.json and .md
    #[arg(short, long, value_name = "FOLDER", requires = "rt")]
    output: Option<PathBuf>,
    /// Device by its number or a part of its name, as `voxtrace devices` lists them
    #[arg(long, value_name = "DEVICE", env = "VOXTRACE_DEVICE", hide_env_values = true)]
    device: Option<String>,
}

/// What a traversal needs beyond Vulkan 1.2.
const NEEDS: [(Traversal, &[&str]); 3] = [
    (Traversal::Walk, &[]),
    (Traversal::Query, &["VK_KHR_acceleration_structure", "VK_KHR_deferred_host_operations", "VK_KHR_ray_query"]),
    (
        Traversal::Pipeline,
        &["VK_KHR_acceleration_structure", "VK_KHR_deferred_host_operations", "VK_KHR_ray_tracing_pipeline"],
    ),
];

impl DoctorArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        if self.rt { self.probe(report) } else { self.examine() }
    }

    fn examine(&self) -> Result<(), Failure> {
        let host = host::Host::of_this_machine();
        let manifests = manifests::found();
        let found = devices(Options::from_environment());
        let devices = found.as_ref().map_or(&[][..], Vec::as_slice);
        let advice = advice::advice(&host, &found, &manifests);
        if self.json {
            let value = json!({
                "voxtrace": env!("CARGO_PKG_VERSION"),
                "host": host.to_json(),
                "vulkan": {
                    "missing": found.as_ref().err().map(ToString::to_string),
                    "drivers": manifests.iter().map(manifests::Manifest::to_json).collect::<Vec<_>>(),
                },
                "devices": devices.iter().map(device_json).collect::<Vec<_>>(),
                "tracer": advice.tracer,
                "advice": advice.lines,
            });
            crate::print(&format!("{value:#}\n"));
        } else {
            crate::print(&tables::examination(&host, &manifests, &found, &advice));
        }
        Ok(())
    }

    fn probe(&self, report: &mut Report) -> Result<(), Failure> {
        let effort = if self.full { Effort::Full } else { Effort::Quick };
        let start = Instant::now();
        let device = match self.open() {
            Ok(device) => device,
            Err(error) if self.device.is_none() => {
                // Nothing to probe is no failure: the CPU traces.
                if self.json {
                    crate::print(&format!("{:#}\n", json!({ "probes": [], "missing": error.to_string() })));
                } else {
                    crate::print(&format!("Nothing to probe: {error}. The CPU traces.\n"));
                }
                return Ok(());
            }
            Err(error) => return Err(trace_failure(error)),
        };
        let info = device.info().clone();
        report.remark(&format!("probing {}, driver {}", info.name, info.driver));
        let mut done = 0;
        report.begin_work("probing", 19);
        let mut watch = |_: &str, _: &str| {
            report.update(done, None);
            done += 1;
            !interrupt::is_requested()
        };
        let probed = probe::run_on(device, effort, None, &mut watch, start);
        report.end();
        let probed = probed.map_err(trace_failure)?;
        if self.json {
            crate::print(&format!("{:#}\n", to_json(&probed)));
        } else {
            crate::print(&tables::probes(&probed));
        }
        if interrupt::is_requested() {
            return Err(Failure::new(Kind::Interrupted, "interrupted; the probes so far are printed"));
        }
        match probes::cache().map(|cache| cache.store(&info, &probed)) {
            Some(Err(error)) => report.warn(&format!("the result is not remembered: {error}")),
            None => report.warn("the result is not remembered: there is no cache folder"),
            Some(Ok(())) => {}
        }
        match &self.output {
            Some(folder) => write(folder, &probed),
            None => Ok(()),
        }
    }

    /// The device that was named, else the best hardware, else the first.
    fn open(&self) -> Result<std::sync::Arc<Device>, TraceError> {
        let open = |wanted| Device::open(Options::from_environment(), wanted, None);
        match self.device.as_deref() {
            Some(wanted) => open(Some(wanted)),
            None => open(None).or_else(|error| open(Some("0")).map_err(|_| error)),
        }
    }
}

fn to_json(probed: &ProbeReport) -> Value {
    let mut value = serde_json::to_value(probed).unwrap_or_default();
    value["verdict"] = probed.verdict().into();
    value
}

fn write(folder: &Path, probed: &ProbeReport) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| Failure::output(folder, &error))?;
    let json = format!("{:#}\n", to_json(probed));
    for (extension, text) in [("json", json), ("md", tables::markdown(probed))] {
        let path = folder.join(format!("{}.{extension}", probed.file_stem()));
        let write = |out: &mut std::io::BufWriter<std::fs::File>| std::io::Write::write_all(out, text.as_bytes());
        write_atomically(&path, write).map_err(|error| Failure::output(&path, &error))?;
        crate::print(&format!("{}\n", path.display()));
    }
    Ok(())
}

/// What is remembered about a device, for people.
fn remembered(info: &DeviceInfo) -> (Option<ProbeReport>, String) {
    match probes::cache().map_or(Cached::Nothing, |cache| cache.load(info)) {
        Cached::Report(report) => {
            let text = format!("{} ({})", report.verdict(), report.effort);
            (Some(*report), text)
        }
        Cached::Nothing => (None, "not probed yet: voxtrace doctor --rt".into()),
        Cached::Unusable(why) => (None, why),
    }
}

fn device_json(info: &DeviceInfo) -> Value {
    let traversals: serde_json::Map<String, Value> = NEEDS
        .iter()
        .map(|(traversal, needs)| {
            let why = missing(info, *traversal);
            let needs: serde_json::Map<String, Value> =
                needs.iter().map(|&name| (name.to_owned(), info.has_extension(name).into())).collect();
            let value = json!({ "available": why.is_none(), "missing": why, "extensions": needs });
            (traversal.name().to_owned(), value)
        })
        .collect();
    let (report, says) = remembered(info);
    json!({
        "index": info.index, "name": info.name, "kind": info.kind.name(), "driver": info.driver,
        "vulkan": info.api_version, "memory_bytes": info.memory_bytes, "traversals": traversals,
        "probes": { "says": says, "effort": report.map(|report| report.effort) },
    })
}
