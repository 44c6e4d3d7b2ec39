//! Choosing a tracer for a machine.

mod several;

use crate::capabilities::DeviceKind;
use crate::device::Device;
use crate::listing::devices;
use crate::method::{Primitive, Settings, Traversal};
use crate::probe::{Cache, Cached, ProbeReport};
use crate::tracer::VulkanTracer;
use crate::vulkan::Options;
use several::Several;
use std::sync::Arc;
use voxtrace_core::{CpuTracer, PackedScene, TraceError, Tracer};

/// What is wanted; what is `None` is chosen.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// How rays find voxels.
    pub traversal: Option<Traversal>,
    /// What acceleration structures are made of.
    pub primitive: Option<Primitive>,
    /// Number of a device, or a part of its name; numbers of several, with commas between them, and `cpu` among them for the processor; or `all`, every
    /// GPU of the machine.
    pub device: Option<String>,
    /// Most bytes to allocate on the device.
    pub memory_budget: Option<u64>,
    /// Whether the driver may round as it likes ([`Settings::is_exact`]).
    pub is_fast: bool,
    /// Where reports of the driver probes are kept; `None`: nothing is known about drivers.
    #[doc(hidden)]
    pub probes: Option<Cache>,
}

impl Request {
    /// Whether neither a certain device nor a traversal was asked for, so that the CPU may take over.
    pub fn is_automatic(&self) -> bool {
        self.device.as_deref().is_none_or(|device| device == several::ALL) && self.traversal.is_none()
    }
}

/// A tracer, and why it is this one.
pub struct Choice {
    /// The tracer.
    pub tracer: Box<dyn Tracer + Send>,
    /// How it finds voxels.
    pub traversal: Traversal,
    /// One line for people: what traces, on what, and why.
    pub reason: String,
    /// One line for people about what was wanted and cannot be.
    pub warning: Option<String>,
}

impl Choice {
    /// The CPU traces.
    fn cpu(reason: String) -> Self {
        Self { tracer: Box::new(CpuTracer::new(None)), traversal: Traversal::Cpu, reason, warning: None }
    }
}

/// Chooses a tracer as [`choose`] does, and gives it the scene. Where the choice is ours and the scene is too large for the device, the CPU traces.
///
/// # Errors
/// As [`choose`] and [`Tracer::set_scene`].
pub fn choose_for(request: &Request, scene: &Arc<PackedScene>) -> Result<Choice, TraceError> {
    let mut choice = choose(request)?;
    match choice.tracer.set_scene(scene) {
        Err(error @ TraceError::OutOfMemory { .. }) if request.is_automatic() => {
            let reason = format!("tracing on the CPU: the scene does not fit the GPU ({error})");
            choice = Choice { warning: Some(reason.clone()), ..Choice::cpu(reason) };
            choice.tracer.set_scene(scene)?;
        }
        result => result?,
    }
    Ok(choice)
}

/// Chooses a tracer. What the request says holds, or is an error. The rest is chosen so:
///
/// 1. No device and no traversal asked for: the best device that is hardware, and its compute walk. Without hardware
///    the CPU: its vector walk is several times as fast as Vulkan in software.
/// 2. A traversal asked for, but no device: the best hardware, else the first software device.
/// 3. A device asked for, but no traversal: its compute walk.
/// 4. Several devices asked for: they share the work ([`crate::SharedTracer`]), and the picture is the same. All of them: those that are hardware and can do the
///    traversal; with one of them, or none, as if none had been asked for. Of several, one that does not open takes no part, with a warning.
/// 5. Acceleration structures are made of bricks. Where the driver's probes are kept and speak against that, of what they
///    trust: bricks, grids, triangles, in this order; where they trust none, the compute walk takes over. A primitive that was
///    asked for stays, and the reason says what speaks against it. Probes are never run here.
///
/// The compute walk comes before ray tracing hardware because it was 4 to 6 times as fast wherever both were measured,
/// at a twentieth of the memory (`docs/performance.md`); no card with ray tracing cores was among those yet.
///
/// # Errors
/// [`TraceError::Unsupported`] where the machine lacks what was asked for; what the driver answers.
pub fn choose(request: &Request) -> Result<Choice, TraceError> {
    let cpu = Choice::cpu;
    if request.traversal == Some(Traversal::Cpu) {
        return Ok(cpu("tracing on the CPU, as asked".into()));
    }
    let options = Options::from_environment();
    match Several::of(request, &options) {
        Several::One(device) => choose_one(&Request { device, ..request.clone() }, options),
        Several::These(numbers, with_processor) => several::choose(request, options, &numbers, with_processor),
    }
}

fn choose_one(request: &Request, options: Options) -> Result<Choice, TraceError> {
    let cpu = Choice::cpu;
    let open = |wanted: Option<&str>| Device::open(options.clone(), wanted, request.memory_budget);
    let device = match (request.device.as_deref(), request.traversal) {
        (Some(device), _) => open(Some(device))?,
        (None, Some(_)) => open(None).or_else(|error| match first_in_software(&options) {
            // Why the hardware cannot says more.
            Some(number) => open(Some(&number.to_string())).map_err(|_| error),
            None => Err(error),
        })?,
        (None, None) => match open(None) {
            Ok(device) => device,
            Err(TraceError::Unsupported(why)) => return Ok(cpu(format!("tracing on the CPU: {why}"))),
            Err(error) => return Ok(cpu(format!("tracing on the CPU: the GPU does not open ({error})"))),
        },
    };
    let (settings, remark) = settings_for(request, &device);
    let tracer = match VulkanTracer::new(Arc::clone(&device), settings) {
        // The CPU is quicker than a device that must bring a scene page by page.
        Ok(tracer) => tracer.with_pages(!request.is_automatic()),
        Err(error) if request.is_automatic() => {
            return Ok(cpu(format!("tracing on the CPU: the GPU does not work ({error})")));
        }
        Err(error) => return Err(error),
    };
    let why = match (request.traversal, device.info().kind) {
        (_, DeviceKind::Cpu) => "a device in software: the CPU tracer is quicker",
        (Some(_), _) => "as asked",
        (None, _) => "the compute walk is the quickest where measured",
    };
    let reason = format!("tracing on {}, {} ({why}){remark}", device.info().name, with(settings));
    Ok(Choice { tracer: Box::new(tracer), traversal: settings.traversal, reason, warning: None })
}

/// The number of the first software device that can trace.
fn first_in_software(options: &Options) -> Option<usize> {
    let mut devices = devices(options.clone()).ok()?.into_iter();
    devices.find(|info| info.kind == DeviceKind::Cpu && info.walk_missing.is_none()).map(|info| info.index)
}

/// The traversal of settings, in words.
fn with(settings: Settings) -> String {
    let name = settings.traversal.name();
    match settings.traversal.uses_primitives() {
        true => format!("traversal {name}, primitive {}", settings.primitive.name()),
        false => format!("traversal {name}"),
    }
}

/// What to trace with on a device, and what there is to say about it.
fn settings_for(request: &Request, device: &Device) -> (Settings, String) {
    let probed = request.probes.as_ref().map_or(Cached::Nothing, |cache| cache.load(device.info()));
    let (report, mut remark) = match probed {
        Cached::Report(report) => (Some(report), String::new()),
        Cached::Nothing => (None, String::new()),
        Cached::Unusable(why) => (None, format!("; {why}")),
    };
    let asked = request.traversal.unwrap_or(Traversal::Walk);
    let (traversal, primitive, doubt) = advised(asked, request.primitive, report.as_deref());
    if let Some(doubt) = doubt {
        remark += &format!("; {doubt}");
    }
    (Settings { traversal, primitive, is_exact: !request.is_fast }, remark)
}

/// The traversal and primitive to take, and a word about it where the probes speak against what was asked for.
fn advised(
    traversal: Traversal,
    primitive: Option<Primitive>,
    report: Option<&ProbeReport>,
) -> (Traversal, Primitive, Option<String>) {
    let wanted = primitive.unwrap_or_default();
    let doubt = report.and_then(|report| Some((report, report.distrusts(traversal, wanted)?)));
    match (doubt, primitive) {
        (None, _) => (traversal, wanted, None),
        (Some((_, why)), Some(_)) => {
            (traversal, wanted, Some(format!("the driver is not to be trusted with it ({why})")))
        }
        (Some((report, why)), None) => {
            let name = traversal.name();
            let says = |instead| Some(format!("{instead} instead of {name} with {}: {why}", wanted.name()));
            match report.trusted(traversal) {
                Some(primitive) => (traversal, primitive, says(primitive.name())),
                None => (Traversal::Walk, wanted, says("the compute walk")),
            }
        }
    }
}
