//! What a machine has to trace with: processor, drivers, devices, what each can do, and what to do about what is missing.

use super::advice::{Advice, advice};
use super::host::Host;
use super::manifests::{self, Manifest};
use serde_json::{Value, json};
use voxtrace::TraceError;
use voxtrace_vulkan::probe::{Cache, Cached};
use voxtrace_vulkan::{DeviceInfo, Options, Traversal, devices, missing};

/// A machine that was looked at.
pub struct Examination {
    pub(super) host: Host,
    pub(super) manifests: Vec<Manifest>,
    /// The devices, or why Vulkan cannot be asked.
    pub(super) found: Result<Vec<Examined>, TraceError>,
    pub(super) advice: Advice,
}

/// A device and what is known of its driver.
pub(super) struct Examined {
    pub info: DeviceInfo,
    /// What its probes said, or why nothing is known.
    pub says: String,
    /// Effort of the probes.
    effort: Option<String>,
}

/// What a traversal needs beyond Vulkan 1.2.
pub(super) const NEEDS: [(Traversal, &[&str]); 3] = [
    (Traversal::Walk, &[]),
    (Traversal::Query, &["VK_KHR_acceleration_structure", "VK_KHR_deferred_host_operations", "VK_KHR_ray_query"]),
    (
        Traversal::Pipeline,
        &["VK_KHR_acceleration_structure", "VK_KHR_deferred_host_operations", "VK_KHR_ray_tracing_pipeline"],
    ),
];

impl Examination {
    /// Looks at this machine; `cache` is where reports of the driver probes are kept.
    pub fn of_this_machine(cache: Option<&Cache>) -> Self {
        let (host, manifests) = (Host::of_this_machine(), manifests::found());
        let found = devices(Options::from_environment());
        let advice = advice(&host, &found, &manifests);
        let found = found.map(|found| found.into_iter().map(|info| Examined::of(info, cache)).collect());
        Self { host, manifests, found, advice }
    }

    /// Everything, for programs.
    pub fn json(&self) -> Value {
        json!({
            "voxtrace": env!("CARGO_PKG_VERSION"),
            "host": self.host.to_json(),
            "vulkan": {
                "missing": self.found.as_ref().err().map(ToString::to_string),
                "drivers": self.manifests.iter().map(Manifest::to_json).collect::<Vec<_>>(),
            },
            "devices": self.found.iter().flatten().map(Examined::json).collect::<Vec<_>>(),
            "tracer": self.advice.tracer,
            "advice": self.advice.lines,
        })
    }
}

impl Examined {
    fn of(info: DeviceInfo, cache: Option<&Cache>) -> Self {
        let (says, effort) = match cache.map_or(Cached::Nothing, |cache| cache.load(&info)) {
            Cached::Report(report) => (format!("{} ({})", report.verdict(), report.effort), Some(report.effort)),
            Cached::Nothing => ("not probed yet: voxtrace doctor --rt".into(), None),
            Cached::Unusable(why) => (why, None),
        };
        Self { info, says, effort }
    }

    fn json(&self) -> Value {
        let info = &self.info;
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
        json!({
            "index": info.index, "name": info.name, "kind": info.kind.name(), "driver": info.driver,
            "vulkan": info.api_version, "memory_bytes": info.memory_bytes, "traversals": traversals,
            "probes": { "says": self.says, "effort": self.effort },
        })
    }
}
