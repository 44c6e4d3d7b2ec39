//! What a machine has to trace with, for people at a terminal.

use super::examination::{Examination, Examined, NEEDS};
use crate::quantity::counted;
use voxtrace_vulkan::missing;

const GIB: f64 = (1u64 << 30) as f64;

impl Examination {
    /// Everything, for people.
    pub fn text(&self) -> String {
        let (host, advice) = (&self.host, &self.advice);
        let mut text = format!("voxtrace {} traces on {}.\n\n", env!("CARGO_PKG_VERSION"), advice.tracer);
        text += &format!("cpu      {}, instructions in use: {}", counted(host.threads as u64, "thread"), host.simd);
        if !host.features.is_empty() {
            text += &format!(" (of {})", host.features.join(" "));
        }
        text += "\n";
        if let Some((total, free)) = host.memory {
            text += &format!("memory   {:.1} GiB, {:.1} GiB available\n", total as f64 / GIB, free as f64 / GIB);
        }
        text += &match &self.found {
            Ok(found) => format!("vulkan   loader found, {}\n", counted(found.len() as u64, "device")),
            Err(error) => format!("vulkan   {error}\n"),
        };
        for manifest in &self.manifests {
            let library = manifest.library.as_deref().unwrap_or("?");
            let fault = manifest.fault.as_ref().map_or(String::new(), |fault| format!(", but {fault}"));
            text += &format!("driver   {}: {library}{fault}\n", manifest.path.display());
        }
        text.extend(self.found.iter().flatten().map(device));
        if !advice.lines.is_empty() {
            text += "\n";
            advice.lines.iter().for_each(|line| text += &format!("- {line}\n"));
        }
        text
    }
}

fn device(device: &Examined) -> String {
    let info = &device.info;
    let memory = info.memory_bytes as f64 / GIB;
    let mut text = format!("\n{}        {} ({}, {memory:.1} GiB)\n", info.index, info.name, info.kind.name());
    text += &format!("         driver {}, Vulkan {}\n", info.driver, info.api_version);
    for (traversal, needs) in NEEDS {
        let state = match missing(info, traversal) {
            None => "yes".to_owned(),
            Some(why) => {
                let lacks: Vec<&str> = needs.iter().copied().filter(|name| !info.has_extension(name)).collect();
                match lacks.is_empty() {
                    true => format!("no: {why}"),
                    false => format!("no: the driver does not offer {}", lacks.join(", ")),
                }
            }
        };
        text += &format!("         {:<9}{state}\n", traversal.name());
    }
    text + &format!("         probes   {}\n", device.says)
}
