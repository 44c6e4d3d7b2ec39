//! What the probes of the driver said, for the report: remembered by `voxtrace doctor --rt`, or probed now, in about two
//! seconds.

use crate::interrupt;
use crate::probes;
use crate::report::Report;
use serde_json::Value;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_vulkan::probe::{self, Cached, Effort, ProbeReport};
use voxtrace_vulkan::{Device, Traversal, missing};

/// The probes' report on a device; `None` where it traces no rays in hardware, or where the probes do not run, which is
/// no reason not to measure.
pub fn probed(device: &Arc<Device>, report: &mut Report) -> Option<Value> {
    let info = device.info();
    if [Traversal::Pipeline, Traversal::Query].into_iter().all(|traversal| missing(info, traversal).is_some()) {
        return None;
    }
    if let Some(Cached::Report(known)) = probes::cache().map(|cache| cache.load(info)) {
        return json(&known);
    }
    report.remark("probing the driver");
    let mut watch = |_: &str, _: &str| !interrupt::is_requested();
    match probe::run_on(Arc::clone(device), Effort::Quick, None, &mut watch, Instant::now()) {
        Err(error) => {
            report.warn(&format!("the probes of the driver do not run: {error}"));
            None
        }
        Ok(_) if interrupt::is_requested() => None,
        Ok(probed) => {
            if let Some(Err(error)) = probes::cache().map(|cache| cache.store(info, &probed)) {
                report.warn(&format!("the result of the probes is not remembered: {error}"));
            }
            json(&probed)
        }
    }
}

fn json(probed: &ProbeReport) -> Option<Value> {
    let mut json = serde_json::to_value(probed).ok()?;
    json["verdict"] = probed.verdict().into();
    Some(json)
}
