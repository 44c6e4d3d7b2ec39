//! What traces a cell: a device, or the CPU.

use super::measured::Memory;
use crate::plan::Cell;
use std::sync::Arc;
use voxtrace::{CpuTracer, TraceError, Tracer};
use voxtrace_vulkan::{Device, Options, Settings, Traversal, VulkanTracer};

/// What traces a cell.
pub enum Backend {
    Device(Box<VulkanTracer>),
    Cpu(Box<CpuTracer>),
}

impl Backend {
    /// Opens what a cell is measured on.
    pub fn open(cell: Cell, device: Option<&str>, is_exact: bool) -> Result<Self, TraceError> {
        if cell.traversal == Traversal::Cpu {
            return Ok(Self::Cpu(Box::new(CpuTracer::new(None))));
        }
        let settings = Settings { traversal: cell.traversal, primitive: cell.primitive.unwrap_or_default(), is_exact };
        let device = open_device(device)?;
        Ok(Self::Device(Box::new(VulkanTracer::new(device, settings)?)))
    }

    /// Whether the device has a clock of its own.
    pub fn has_clock(&self) -> bool {
        matches!(self, Self::Device(tracer) if tracer.device().info().limits.timestamp_period_ns > 0.0)
    }

    /// Name of the device.
    pub fn device_name(&self) -> Option<String> {
        match self {
            Self::Device(tracer) => Some(tracer.device().info().name.clone()),
            Self::Cpu(_) => None,
        }
    }

    pub fn tracer(&mut self) -> &mut dyn Tracer {
        match self {
            Self::Device(tracer) => tracer.as_mut(),
            Self::Cpu(tracer) => tracer.as_mut(),
        }
    }

    /// What is allocated on the device.
    pub fn memory(&self) -> Option<Memory> {
        let Self::Device(tracer) = self else { return None };
        let report = tracer.memory();
        Some(Memory {
            total: report.total_bytes(),
            peak: report.peak_bytes,
            bytes: report.entries,
            accel: tracer.accel_report(),
        })
    }
}

/// The device asked for, or the best hardware, or else the first device in software.
///
/// # Errors
/// Where no device is there or the one that is named is not; what the driver answers.
pub fn open_device(wanted: Option<&str>) -> Result<Arc<Device>, TraceError> {
    let open = |wanted| Device::open(Options::from_environment(), wanted, None);
    match wanted {
        Some(_) => open(wanted),
        None => open(None).or_else(|error| open(Some("0")).map_err(|_| error)),
    }
}
