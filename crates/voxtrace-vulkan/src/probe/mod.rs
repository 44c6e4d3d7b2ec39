//! The driver probes: what a driver makes of boxes in acceleration structures, against double precision on the host. One file
//! for each idea; `docs/drivers/README.md` says what each shows.

mod attribute;
mod boxes;
mod builds;
mod cache;
mod degenerate;
mod edges;
mod effort;
mod extremes;
mod far;
mod geometries;
mod grids;
mod instances;
mod interval;
mod lab;
mod limits;
mod merging;
mod model;
mod order;
mod plant;
mod reference;
mod repeats;
mod report;
mod shot;
mod stacks;
mod submits;
mod trust;

pub use cache::{Cache, Cached};
pub use effort::{Effort, PROBE_VERSION};
pub use plant::Plant;
pub use report::{Finding, Outcome, ProbeReport, ProbeRow, SCHEMA};

use crate::capabilities::DeviceInfo;
use crate::device::Device;
use crate::method::Traversal;
use crate::vulkan::Options;
use lab::Lab;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_core::TraceError;

/// One probe.
struct Probe {
    id: &'static str,
    name: &'static str,
    expects: &'static str,
    run: fn(&mut Lab, Effort) -> Result<Vec<Finding>, TraceError>,
}

const fn probe(
    id: &'static str,
    name: &'static str,
    expects: &'static str,
    run: fn(&mut Lab, Effort) -> Result<Vec<Finding>, TraceError>,
) -> Probe {
    Probe { id, name, expects, run }
}

const PROBES: [Probe; 19] = [
    probe("P1", "rows of touching boxes", "a candidate for every box entered, the closest is the first", stacks::run),
    probe("P2", "solid blocks", "the same with all build flags, with and without gaps", grids::run),
    probe("P3", "faces, edges, corners", "no leak between boxes", edges::run),
    probe("P4", "the ray's interval", "inclusive; a start inside is a hit", interval::run),
    probe("P5", "flat boxes", "a flat box is hit", degenerate::flat),
    probe("P6", "inactive boxes", "left out, and the other numbers stay", degenerate::inactive),
    probe("P7", "instances", "the same as boxes put there by double precision", instances::run),
    probe("P8", "far from the origin", "reported: where scenes must be moved", far::run),
    probe("P9", "compaction", "the same boxes and distances", builds::compacted),
    probe("P10", "update", "the same boxes and distances as a new build", builds::updated),
    probe("P11", "repeated builds", "the same boxes and distances", builds::repeated),
    probe("P12", "order", "the same box is first in any order", order::run),
    probe("P13", "hit attribute", "that of the hit", attribute::run),
    probe("P14", "several geometries", "the right numbers of geometry and box", geometries::several),
    probe("P15", "boxes in one place", "every one is a candidate", geometries::coincident),
    probe("P16", "repeats and false candidates", "reported: both are allowed", repeats::run),
    probe("P17", "limits", "numbers exact up to the limits", limits::run),
    probe("P18", "extremes", "no hang, nothing lost", extremes::run),
    probe("P19", "many submits", "none is lost", submits::run),
];

/// Runs all probes on a device, named as for [`Device::open`]. Errors of the driver, the loss of the device too, are outcomes:
/// the device is opened anew and the next probe goes on; after a second loss the rest is left out. `watch` is told each
/// probe's name before it runs, and ends the run where it answers `false`; what is not run is missing in the report.
///
/// # Errors
/// [`TraceError::Unsupported`] where there is no such device; what the driver answers when the device is opened.
pub fn run(
    options: Options,
    wanted: Option<&str>,
    effort: Effort,
    plant: Option<Plant>,
    watch: &mut dyn FnMut(&str, &str) -> bool,
) -> Result<ProbeReport, TraceError> {
    let start = Instant::now();
    let device = Device::open(options, wanted, None)?;
    run_on(device, effort, plant, watch, start)
}

/// As [`run`], on a device that is open.
///
/// # Errors
/// None today: errors of the driver are outcomes.
pub fn run_on(
    mut device: Arc<Device>,
    effort: Effort,
    plant: Option<Plant>,
    watch: &mut dyn FnMut(&str, &str) -> bool,
    start: Instant,
) -> Result<ProbeReport, TraceError> {
    let mut report = ProbeReport::new(device.info(), effort);
    let missing = no_ray_tracing(device.info());
    let (mut lab, mut losses) = (None, 0);
    for probe in &PROBES {
        if !watch(probe.id, probe.name) {
            break;
        }
        let begun = Instant::now();
        let findings = match (&missing, losses) {
            (Some(missing), _) => vec![Finding::new(None, Outcome::NotApplicable, missing)],
            (None, 2..) => vec![Finding::new(None, Outcome::NotApplicable, "the device was lost twice before")],
            (None, _) => {
                let result = opened(&mut lab, &device, plant).and_then(|lab| {
                    report.traversals = lab.traversals().iter().map(|traversal| traversal.name().into()).collect();
                    (probe.run)(lab, effort)
                });
                result.unwrap_or_else(|error| {
                    // Everything on a lost device must go before it is opened anew.
                    lab = None;
                    let mut says = error.to_string();
                    if matches!(error, TraceError::DeviceLost { .. }) {
                        losses += 1;
                        let fault = device.fault_report().unwrap_or_default();
                        says =
                            [&says].into_iter().map(String::as_str).chain(fault.lines()).collect::<Vec<_>>().join("; ");
                        match device.reopened() {
                            Ok(again) => device = again,
                            Err(error) => {
                                losses = 2;
                                says += &format!("; it cannot be opened anew: {error}");
                            }
                        }
                    }
                    let outcome = match error {
                        TraceError::OutOfMemory { .. } => Outcome::NotApplicable,
                        _ => Outcome::Fails,
                    };
                    vec![Finding::new(None, outcome, says)]
                })
            }
        };
        let milliseconds = (begun.elapsed().as_secs_f64() * 1e5).round() / 100.0;
        report.probes.push(ProbeRow::new(probe.id, probe.name, probe.expects, findings, milliseconds));
    }
    drop(lab);
    report.seconds = (start.elapsed().as_secs_f64() * 1e3).round() / 1e3;
    Ok(report)
}

/// The laboratory, made where there is none.
fn opened<'a>(lab: &'a mut Option<Lab>, device: &Arc<Device>, plant: Option<Plant>) -> Result<&'a mut Lab, TraceError> {
    match lab {
        Some(lab) => Ok(lab),
        none => Ok(none.insert(Lab::new(device, plant)?)),
    }
}

/// Why nothing can be probed, `None` where something can.
fn no_ray_tracing(info: &DeviceInfo) -> Option<String> {
    let by = |traversal| crate::capabilities::missing(info, traversal);
    match (by(Traversal::Pipeline), by(Traversal::Query)) {
        (Some(pipeline), Some(query)) if pipeline == query => Some(format!("the device has no ray tracing: {query}")),
        (Some(pipeline), Some(query)) => Some(format!("the device has no ray tracing: {pipeline}, {query}")),
        _ => None,
    }
}
