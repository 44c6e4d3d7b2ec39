//! What the probes of the driver said, for the report: remembered by `voxtrace doctor --rt`, or probed now, in about two
//! seconds.

use crate::doctor::probes_json;
use crate::monitor::Monitor;
use serde_json::Value;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_vulkan::probe::{self, Cache, Cached, Effort};
use voxtrace_vulkan::{Device, Traversal, missing};

/// The probes' report on a device; `None` where it traces no rays in hardware, or where the probes do not run, which is
/// no reason not to measure.
pub fn probed(device: &Arc<Device>, cache: Option<&Cache>, monitor: &mut dyn Monitor) -> Option<Value> {
    let info = device.info();
    if [Traversal::Pipeline, Traversal::Query].into_iter().all(|traversal| missing(info, traversal).is_some()) {
        return None;
    }
    if let Some(Cached::Report(known)) = cache.map(|cache| cache.load(info)) {
        return Some(probes_json(&known));
    }
    monitor.remark("probing the driver");
    let mut watch = |_: &str, _: &str| !monitor.is_interrupted();
    match probe::run_on(Arc::clone(device), Effort::Quick, None, &mut watch, Instant::now()) {
        Err(error) => {
            monitor.warn(&format!("the probes of the driver do not run: {error}"));
            None
        }
        Ok(_) if monitor.is_interrupted() => None,
        Ok(probed) => {
            if let Some(Err(error)) = cache.map(|cache| cache.store(info, &probed)) {
                monitor.warn(&format!("the result of the probes is not remembered: {error}"));
            }
            Some(probes_json(&probed))
        }
    }
}
