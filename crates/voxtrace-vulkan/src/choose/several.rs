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
    let open = |number: &usize| {
        let device = Device::open_on(&vulkan, Some(&number.to_string()), request.memory_budget)?;
        let (settings, remark) = settings_for(request, &device);
        let tracer = VulkanTracer::new(device, settings)?.with_pages(!request.is_automatic());
        Ok((tracer, settings, remark))
    };
    let opened = numbers.iter().map(|number| (*number, open(number)));
    let (opened, failures) = those_that_open(opened, request.device.as_deref() == Some(ALL))?;
    let failures = failures.join("; ");
    if opened.is_empty() && request.is_automatic() {
        return Ok(Choice::cpu(format!("tracing on the CPU: no GPU works ({failures})")));
    }
    let (mut tracers, mut names, mut remarks) = (Vec::new(), Vec::new(), String::new());
    let (mut traversal, mut by) = (Traversal::Walk, String::new());
    for (number, (tracer, settings, remark)) in opened {
        (traversal, by) = (settings.traversal, with(settings));
        remarks += &remark;
        names.push(format!("{} ({number})", tracer.device().info().name));
        tracers.push(tracer);
    }
    if tracers.is_empty() {
        return Err(TraceError::Unsupported(failures));
    }
    names.extend(with_processor.then(|| "the processor".to_owned()));
    let count = if names.len() == 1 { "1 device".into() } else { format!("{} devices", names.len()) };
    let reason = format!("tracing on {count}: {}; {by}{remarks}", names.join(", "));
    let tracer = Box::new(SharedTracer::new(tracers, with_processor));
    Ok(Choice { tracer, traversal, reason, warning: (!failures.is_empty()).then_some(failures) })
}

/// Devices by their numbers.
type Numbered<T> = Vec<(usize, T)>;

/// Devices by their numbers, and what is wrong with those that do not open, which matters less than the others where all were asked for; else the first
/// of them is an error.
fn those_that_open<T>(
    devices: impl Iterator<Item = (usize, Result<T, TraceError>)>,
    are_all: bool,
) -> Result<(Numbered<T>, Vec<String>), TraceError> {
    let (mut opened, mut failures) = (Vec::new(), Vec::new());
    for (number, device) in devices {
        match device {
            Ok(device) => opened.push((number, device)),
            Err(error) if are_all => failures.push(format!("device {number} takes no part: {error}")),
            Err(error) => return Err(error),
        }
    }
    Ok((opened, failures))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_all_devices_those_count_that_open_and_of_those_that_were_named_each() {
        let devices = || {
            let failed = TraceError::Unsupported("no queue".into());
            [(0, Ok("a")), (1, Err(failed)), (3, Ok("b"))].into_iter()
        };
        let (opened, failures) = those_that_open(devices(), true).unwrap();
        assert_eq!(opened, [(0, "a"), (3, "b")]);
        assert_eq!(failures, ["device 1 takes no part: not supported: no queue"]);
        assert!(those_that_open(devices(), false).is_err());
    }

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
