//! What to do about what is missing.

use super::host::Host;
use super::manifests::{self, Manifest};
use super::remedy::{Missing, System};
use crate::quantity::counted;
use voxtrace::TraceError;
use voxtrace_vulkan::{DeviceInfo, DeviceKind, Traversal, missing};

/// What traces without options, and what would help.
pub struct Advice {
    pub tracer: String,
    pub lines: Vec<String>,
}

/// The advice for what was found.
pub fn advice(host: &Host, found: &Result<Vec<DeviceInfo>, TraceError>, manifests: &[Manifest]) -> Advice {
    let mut lines = Vec::new();
    let able = |info: &&DeviceInfo| info.walk_missing.is_none();
    let hardware = |info: &&DeviceInfo| info.kind != DeviceKind::Cpu;
    let all = found.as_ref().map_or(&[][..], Vec::as_slice);
    for manifest in manifests {
        if let Some(fault) = &manifest.fault {
            lines.push(format!("the driver of {} cannot be used: {fault}", manifest.path.display()));
        }
    }
    let best = all
        .iter()
        .filter(able)
        .filter(hardware)
        .min_by_key(|info| (info.kind, std::cmp::Reverse(info.memory_bytes), info.index));
    let tracer = match best {
        Some(info) => format!("{}, traversal walk", info.name),
        None => format!("the CPU, {}, {}", counted(host.threads as u64, "thread"), host.simd),
    };
    let libraries =
        || manifests.iter().filter(|manifest| manifest.fault.is_none()).filter_map(|one| one.library.as_deref());
    let remedies = |missing| System::this(libraries()).remedies(missing);
    let variable =
        || manifests::variable().map(|name| format!("{name} is set: other drivers than it names are not looked for"));
    match (found, best) {
        (Err(error), _) => {
            lines.push(format!("no GPU can be used: {error}"));
            lines.extend(variable());
            // A loader that is there looks at what drivers say of themselves.
            let has_loader = !error.to_string().contains("loader");
            lines.extend(remedies(if has_loader { Missing::Driver } else { Missing::Loader }));
        }
        (Ok(_), None) => {
            let why = if all.is_empty() {
                "Vulkan finds no device"
            } else {
                "there is no GPU that can compute with Vulkan 1.2, only what is listed"
            };
            lines.push(format!("no GPU can be used: {why}"));
            lines.extend(variable());
            lines.extend(remedies(Missing::Driver));
        }
        (Ok(_), Some(info)) => {
            let lacks = |traversal| missing(info, traversal);
            if let (Some(why), Some(_)) = (lacks(Traversal::Pipeline), lacks(Traversal::Query)) {
                lines.push(format!(
                    "{} has no ray tracing ({why}); nothing is lost: the compute walk is the quickest where measured",
                    info.name
                ));
            }
        }
    }
    Advice { tracer, lines }
}
