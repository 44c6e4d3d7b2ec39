//! Several devices for one picture.

use super::{Choice, Request, settings_for, with};
use crate::capabilities::{DeviceInfo, DeviceKind};
use crate::device::Device;
use crate::listing::list;
use crate::method::Traversal;
use crate::shared::SharedTracer;
use crate::tracer::VulkanTracer;
use crate::vulkan::{Options, Vulkan};
use ash::khr;
use voxtrace_core::TraceError;

/// Asks for every GPU.
pub const ALL: &str = "all";
/// Asks for the processor as well, among numbers of devices.
const PROCESSOR: &str = "cpu";

/// Which devices a request is about.
#[derive(Debug, PartialEq, Eq)]
pub enum Several {
    /// One, as it was named, or none.
    One(Option<String>),
    /// Those of these numbers, and whether the processor traces as well.
    These(Vec<usize>, bool),
}

impl Several {
    pub fn of(request: &Request, options: &Options) -> Self {
        match request.device.as_deref() {
            Some(ALL) => all(request.traversal.unwrap_or(Traversal::Walk), options),
            Some(names) => numbered(names),
            None => Self::One(None),
        }
    }
}

/// The devices that are hardware; as if nothing had been asked for where those are not several.
fn all(traversal: Traversal, options: &Options) -> Several {
    let devices = Vulkan::open(options.clone()).and_then(|vulkan| list(&vulkan)).unwrap_or_default();
    let is_able = |info: &&DeviceInfo| {
        let lacks = match traversal {
            Traversal::Cpu | Traversal::Walk => &info.walk_missing,
            Traversal::Query => &info.query_missing,
            Traversal::Pipeline => &info.pipeline_missing,
        };
        info.kind != DeviceKind::Cpu && info.walk_missing.is_none() && lacks.is_none()
    };
    // A GPU may have a driver that is Vulkan in full, and another one that is not: it does not share a picture with itself.
    let is_full = |info: &&DeviceInfo| !info.has(khr::portability_subset::NAME);
    let has_full = devices.iter().filter(is_able).any(|info| is_full(&info));
    let chosen = devices.iter().filter(is_able).filter(|info| !has_full || is_full(info));
    match &chosen.map(|info| info.index).collect::<Vec<_>>()[..] {
        [] | [_] => Several::One(None),
        several => Several::These(several.to_vec(), false),
    }
}

/// Numbers with commas between them; anything else is a name.
fn numbered(names: &str) -> Several {
    let words: Vec<&str> = names.split(',').map(str::trim).collect();
    let numbers = words.iter().filter(|word| **word != PROCESSOR).map(|word| word.parse());
    match numbers.collect::<Result<Vec<usize>, _>>() {
        Ok(numbers) if words.len() > 1 && !numbers.is_empty() => {
            let with_processor = numbers.len() < words.len();
            Several::These(numbers, with_processor)
        }
        _ => Several::One(Some(names.to_owned())),
    }
}

/// A tracer on all of these devices.
pub fn choose(
    request: &Request,
    options: Options,
    numbers: &[usize],
    with_processor: bool,
) -> Result<Choice, TraceError> {
    let vulkan = Vulkan::open(options)?;
    let (mut tracers, mut names, mut remarks) = (Vec::new(), Vec::new(), String::new());
    let (mut traversal, mut by) = (Traversal::Walk, String::new());
    for number in numbers {
        let device = Device::open_on(&vulkan, Some(&number.to_string()), request.memory_budget)?;
        let (settings, remark) = settings_for(request, &device);
        (traversal, by) = (settings.traversal, with(settings));
        remarks += &remark;
        names.push(format!("{} ({number})", device.info().name));
        tracers.push(VulkanTracer::new(device, settings)?.with_pages(!request.is_automatic()));
    }
    names.extend(with_processor.then(|| "the processor".to_owned()));
    let reason = format!("tracing on {} devices: {}; {by}{remarks}", names.len(), names.join(", "));
    let tracer = Box::new(SharedTracer::new(tracers, with_processor));
    Ok(Choice { tracer, traversal, reason, warning: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_devices_are_numbers_with_commas_and_names_are_names() {
        let one = |name: &str| Several::One(Some(name.into()));
        for (text, wanted) in [
            ("0,1", Several::These(vec![0, 1], false)),
            ("0, 0,cpu", Several::These(vec![0, 0], true)),
            ("1", one("1")),
            ("cpu,cpu", one("cpu,cpu")),
            ("llvmpipe (LLVM 19, 256 bits)", one("llvmpipe (LLVM 19, 256 bits)")),
            ("0,", one("0,")),
        ] {
            assert_eq!(numbered(text), wanted, "{text}");
        }
    }
}
