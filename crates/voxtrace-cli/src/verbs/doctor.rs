//! `voxtrace doctor`: what this machine has to trace with, what is missing and how to get it; with `--rt` what the ray tracing of
//! its driver is worth.

use crate::failure::{Failure, Kind};
use crate::import::warn_of_needless;
use crate::report::Report;
use crate::session::trace_failure;
use crate::tracer::DEVICE_VARIABLE;
use crate::{interrupt, outputs, probes};
use serde_json::json;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;
use voxtrace_bench::doctor::{Examination, probes_json, probes_markdown, probes_text};
use voxtrace_bench::open_device;
use voxtrace_vulkan::probe::{self, Effort, ProbeReport};

/// Check what this machine can trace with, and its GPU driver
#[derive(clap::Args, Clone, Debug)]
pub struct DoctorArgs {
    /// Probe the driver's ray tracing, P1 to P19, in about two seconds, and remember the result
    #[arg(long)]
    rt: bool,
    /// All sizes of the probes: a minute or more
    #[arg(long, requires = "rt")]
    full: bool,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
    /// Also write the probes' result to this folder, as DEVICE-DRIVER.json and .md
    #[arg(short, long, value_name = "FOLDER", requires = "rt")]
    output: Option<PathBuf>,
    /// Device that --rt probes, by its number or a part of its name, as `voxtrace devices` lists them
    #[arg(long, value_name = "DEVICE", env = DEVICE_VARIABLE, hide_env_values = true)]
    device: Option<String>,
}

impl DoctorArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        if self.rt {
            return self.probe(report);
        }
        // The variable is for all runs.
        let is_of_variable = self.device.as_deref() == std::env::var(DEVICE_VARIABLE).ok().as_deref();
        if self.device.is_some() && !is_of_variable {
            warn_of_needless(std::iter::once("--device"), "without --rt all devices are examined", report);
        }
        let found = Examination::of_this_machine(probes::cache().as_ref());
        crate::stdout::print(&if self.json { format!("{:#}\n", found.json()) } else { found.text() });
        Ok(())
    }

    fn probe(&self, report: &mut Report) -> Result<(), Failure> {
        let effort = if self.full { Effort::Full } else { Effort::Quick };
        let start = Instant::now();
        let device = match open_device(self.device.as_deref()) {
            Ok(device) => device,
            Err(error) if self.device.is_none() => {
                // Nothing to probe is no failure: the CPU traces.
                if self.json {
                    crate::stdout::print(&format!("{:#}\n", json!({ "probes": [], "missing": error.to_string() })));
                } else {
                    crate::stdout::print(&format!("Nothing to probe: {error}. The CPU traces.\n"));
                }
                return Ok(());
            }
            Err(error) => return Err(trace_failure(error)),
        };
        let info = device.info().clone();
        if let Some(folder) = &self.output {
            std::fs::create_dir_all(folder).map_err(|error| Failure::output(folder, &error))?;
        }
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
        crate::stdout::print(&if self.json { format!("{:#}\n", probes_json(&probed)) } else { probes_text(&probed) });
        if interrupt::is_requested() {
            return Err(Failure::new(Kind::Interrupted, "interrupted; the probes so far are printed"));
        }
        match probes::cache().map(|cache| cache.store(&info, &probed)) {
            Some(Err(error)) => report.warn(&format!("the result is not remembered: {error}")),
            None => report.warn("the result is not remembered: there is no cache folder"),
            Some(Ok(())) => {}
        }
        self.output.as_ref().map_or(Ok(()), |folder| self.write(folder, &probed))
    }

    fn write(&self, folder: &Path, probed: &ProbeReport) -> Result<(), Failure> {
        let json = format!("{:#}\n", probes_json(probed));
        for (extension, text) in [("json", json), ("md", probes_markdown(probed))] {
            let path = folder.join(format!("{}.{extension}", probed.file_stem()));
            let write = |out: &mut BufWriter<std::fs::File>| out.write_all(text.as_bytes());
            outputs::write(&path, write)?;
            // Behind an object they would make the output no JSON.
            if !self.json {
                crate::stdout::print(&format!("{}\n", path.display()));
            }
        }
        Ok(())
    }
}
