//! `voxtrace devices`: what this machine can render on.

use crate::failure::Failure;
use serde_json::{Value, json};
use voxtrace::CpuTracer;
use voxtrace_bench::quantity::counted;
use voxtrace_vulkan::{DeviceInfo, Options, Traversal, devices, missing};

/// List what this machine can render on
#[derive(clap::Args, Clone, Debug)]
pub struct DevicesArgs {
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

/// The traversals of a GPU.
const OF_GPU: [Traversal; 3] = [Traversal::Walk, Traversal::Query, Traversal::Pipeline];

impl DevicesArgs {
    pub fn run(self) -> Result<(), Failure> {
        let (threads, simd) = (rayon::current_num_threads(), CpuTracer::simd_name());
        let found = devices(Options::from_environment());
        if self.json {
            let mut all = vec![json!({ "name": "cpu", "kind": "cpu", "threads": threads, "simd": simd })];
            all.extend(found.iter().flatten().map(to_json));
            let why = found.as_ref().err().map(ToString::to_string);
            let value = json!({ "devices": all, "vulkan_missing": why });
            crate::stdout::print(&format!("{value:#}\n"));
            return Ok(());
        }
        crate::stdout::print(&format!("cpu  {}, instructions in use: {simd}\n", counted(threads as u64, "thread")));
        match found {
            Ok(found) if found.is_empty() => crate::stdout::print("Vulkan finds no device.\n"),
            Ok(found) => found.iter().for_each(|info| crate::stdout::print(&to_text(info))),
            Err(error) => crate::stdout::print(&format!("No GPU: {error}\n")),
        }
        Ok(())
    }
}

fn to_text(info: &DeviceInfo) -> String {
    let gib = info.memory_bytes as f64 / f64::from(1 << 30);
    let mut text = format!("{}    {} ({}, {gib:.1} GiB)\n", info.index, info.name, info.kind.name());
    text += &format!("     driver {}, Vulkan {}\n", info.driver, info.api_version);
    for traversal in OF_GPU {
        let state = missing(info, traversal).unwrap_or("yes");
        text += &format!("     {:<9}{state}\n", traversal.name());
    }
    text
}

fn to_json(info: &DeviceInfo) -> Value {
    let (limits, rays) = (&info.limits, &info.ray_tracing);
    let traversals: serde_json::Map<String, Value> = OF_GPU
        .iter()
        .map(|&traversal| {
            let why = missing(info, traversal);
            (traversal.name().to_owned(), json!({ "available": why.is_none(), "missing": why }))
        })
        .collect();
    json!({
        "index": info.index,
        "name": info.name,
        "kind": info.kind.name(),
        "driver": info.driver,
        "vulkan": info.api_version,
        "memory_bytes": info.memory_bytes,
        "traversals": traversals,
        "limits": {
            "max_storage_buffer_range": limits.max_storage_buffer_range,
            "max_allocation_bytes": limits.max_allocation_bytes,
            "max_workgroups": limits.max_workgroups,
            "subgroup_size": limits.subgroup_size,
            "timestamp_period_ns": limits.timestamp_period_ns,
            "max_primitive_count": rays.max_primitive_count,
            "max_instance_count": rays.max_instance_count,
            "max_launch": rays.max_launch,
        },
    })
}
