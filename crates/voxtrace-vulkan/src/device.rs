//! One open device: its queue, its memory, its extensions.

mod waits;

use crate::allocations::{AllocationTracker, MemoryReport};
use crate::capabilities::{DeviceInfo, DeviceKind, WELCOME};
use crate::errors::ResultExt;
use crate::listing::list;
use crate::vulkan::{Options, Vulkan};
use ash::{ext, khr, vk};
use gpu_allocator::AllocationSizes;
use gpu_allocator::vulkan::{Allocator, AllocatorCreateDesc};
use std::ffi::CStr;
use std::mem::ManuallyDrop;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;
use voxtrace_core::TraceError;

const MIB: u64 = 1 << 20;

/// An open device. Everything made on it keeps it alive.
pub struct Device {
    pub(crate) raw: ash::Device,
    queue: Mutex<vk::Queue>,
    /// Where pictures are presented: a queue of its own if the device has a second one, so that a window never waits for
    /// what traces.
    present_queue: Option<Mutex<vk::Queue>>,
    pub(crate) allocator: ManuallyDrop<Mutex<Allocator>>,
    pub(crate) allocations: AllocationTracker,
    pub(crate) acceleration: Option<khr::acceleration_structure::Device>,
    pub(crate) pipelines: Option<khr::ray_tracing_pipeline::Device>,
    fault: Option<ext::device_fault::Device>,
    /// How long nobody heard of work that did not end.
    hung: OnceLock<Duration>,
    /// Of a device that was given up: whether the queue that shows pictures does nothing all the same.
    is_still: OnceLock<bool>,
    info: DeviceInfo,
    budget_bytes: Option<u64>,
    vulkan: Arc<Vulkan>,
}

/// The extensions to enable: all that is there and of use.
fn extensions_of(info: &DeviceInfo, presents: bool) -> Vec<&'static CStr> {
    let (has_query, has_pipeline) = (info.query_missing.is_none(), info.pipeline_missing.is_none());
    let mut extensions: Vec<&CStr> = WELCOME.into_iter().filter(|name| info.has(name)).collect();
    if has_query || has_pipeline {
        extensions.extend([khr::acceleration_structure::NAME, khr::deferred_host_operations::NAME]);
    }
    extensions.extend(has_query.then_some(khr::ray_query::NAME));
    extensions.extend(has_pipeline.then_some(khr::ray_tracing_pipeline::NAME));
    extensions.extend(presents.then_some(khr::swapchain::NAME));
    extensions
}

impl Device {
    /// Opens a device: by its number or a part of its name, or, where `wanted` is `None`, the best that is no software.
    /// `budget_bytes` caps what is allocated on it.
    ///
    /// # Errors
    /// [`TraceError::Unsupported`] where there is none, it is not found or cannot run the walk.
    pub fn open(options: Options, wanted: Option<&str>, budget_bytes: Option<u64>) -> Result<Arc<Self>, TraceError> {
        Self::open_on(&Vulkan::open(options)?, wanted, budget_bytes)
    }

    /// As [`Self::open`], on an instance that is open already: the one that a window's surface belongs to.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_on(
        vulkan: &Arc<Vulkan>,
        wanted: Option<&str>,
        budget_bytes: Option<u64>,
    ) -> Result<Arc<Self>, TraceError> {
        let info = choose(list(vulkan)?, wanted)?;
        Self::new(Arc::clone(vulkan), info, budget_bytes)
    }

    fn new(vulkan: Arc<Vulkan>, info: DeviceInfo, budget_bytes: Option<u64>) -> Result<Arc<Self>, TraceError> {
        if let Some(reason) = &info.walk_missing {
            return Err(TraceError::Unsupported(format!("{}: {reason}", info.name)));
        }
        let instance = &vulkan.instance;
        let (has_query, has_pipeline) = (info.query_missing.is_none(), info.pipeline_missing.is_none());
        let has_acceleration = has_query || has_pipeline;
        let presents = !vulkan.options.surface_extensions.is_empty() && info.presents();
        let names: Vec<_> = extensions_of(&info, presents).iter().map(|name| name.as_ptr()).collect();
        let priorities = [1.0, 1.0];
        let count = if presents && info.queue_count > 1 { 2 } else { 1 };
        let queues = [vk::DeviceQueueCreateInfo::default()
            .queue_family_index(info.queue_family)
            .queue_priorities(&priorities[..count])];
        let mut features12 = vk::PhysicalDeviceVulkan12Features::default()
            .timeline_semaphore(true)
            .scalar_block_layout(info.scalar_layout)
            .buffer_device_address(has_acceleration);
        let mut acceleration =
            vk::PhysicalDeviceAccelerationStructureFeaturesKHR::default().acceleration_structure(true);
        let mut pipelines = vk::PhysicalDeviceRayTracingPipelineFeaturesKHR::default().ray_tracing_pipeline(true);
        let mut queries = vk::PhysicalDeviceRayQueryFeaturesKHR::default().ray_query(true);
        let mut faults = vk::PhysicalDeviceFaultFeaturesEXT::default().device_fault(true);
        let mut create = vk::DeviceCreateInfo::default()
            .queue_create_infos(&queues)
            .enabled_extension_names(&names)
            .push_next(&mut features12);
        if has_acceleration {
            create = create.push_next(&mut acceleration);
        }
        if has_pipeline {
            create = create.push_next(&mut pipelines);
        }
        if has_query {
            create = create.push_next(&mut queries);
        }
        if info.has(ext::device_fault::NAME) {
            create = create.push_next(&mut faults);
        }
        // SAFETY: the chain asks for what `capabilities` found, and lives until the call returns.
        let raw = unsafe { instance.create_device(info.physical, &create, None) }.context("opening the device")?;
        // SAFETY: the queues were asked for when the device was created.
        let queue = |index| Mutex::new(unsafe { raw.get_device_queue(info.queue_family, index) });
        let (first, second) = (queue(0), (count > 1).then(|| queue(1)));
        let allocator = Allocator::new(&AllocatorCreateDesc {
            instance: instance.clone(),
            device: raw.clone(),
            physical_device: info.physical,
            debug_settings: Default::default(),
            buffer_device_address: has_acceleration,
            allocation_sizes: AllocationSizes::new(64 * MIB, 16 * MIB),
        });
        let allocator = match allocator {
            Ok(allocator) => ManuallyDrop::new(Mutex::new(allocator)),
            Err(error) => {
                // SAFETY: nothing was made on the device.
                unsafe { raw.destroy_device(None) };
                return Err(TraceError::Device { step: "opening the device".into(), reason: error.to_string() });
            }
        };
        Ok(Arc::new(Self {
            acceleration: has_acceleration.then(|| khr::acceleration_structure::Device::new(instance, &raw)),
            pipelines: has_pipeline.then(|| khr::ray_tracing_pipeline::Device::new(instance, &raw)),
            fault: info.has(ext::device_fault::NAME).then(|| ext::device_fault::Device::new(instance, &raw)),
            hung: OnceLock::new(),
            is_still: OnceLock::new(),
            raw,
            queue: first,
            present_queue: second,
            allocator,
            allocations: AllocationTracker::default(),
            info,
            budget_bytes,
            vulkan,
        }))
    }

    /// The same device, opened anew after it was lost.
    ///
    /// # Errors
    /// [`TraceError::Unsupported`] where it does not come back; what the driver answers.
    pub fn reopened(&self) -> Result<Arc<Self>, TraceError> {
        // Where a window or validation made the instance it is made anew, as it may not list the device any more; the plain one, which others
        // use as well, stays open, and lists it again.
        let vulkan = Vulkan::open(self.vulkan.options.clone())?;
        let found = same_device(list(&vulkan)?, &self.info);
        let info = found.ok_or_else(|| TraceError::Unsupported(format!("{} is gone", self.info.name)))?;
        Self::new(vulkan, info, self.budget_bytes)
    }

    /// What the device is.
    pub fn info(&self) -> &DeviceInfo {
        &self.info
    }

    /// The instance that it belongs to.
    pub fn vulkan(&self) -> &Arc<Vulkan> {
        &self.vulkan
    }

    /// What is allocated on it.
    pub fn memory(&self) -> MemoryReport {
        self.allocations.report()
    }

    /// Bytes that can still be allocated, as far as the driver and the budget tell.
    pub fn available_bytes(&self) -> u64 {
        let ours = self.allocations.report().total_bytes();
        let of_device = self.heap_bytes_left().unwrap_or_else(|| self.info.memory_bytes.saturating_sub(ours));
        let of_budget = self.budget_bytes.map_or(u64::MAX, |budget| budget.saturating_sub(ours));
        of_device.min(of_budget)
    }

    /// Checks an allocation of `needed` bytes before it is made.
    pub(crate) fn check_available(&self, needed: u64) -> Result<(), TraceError> {
        let available = self.available_bytes();
        if needed > available { Err(TraceError::OutOfMemory { needed, available }) } else { Ok(()) }
    }

    /// What VK_EXT_memory_budget says about the largest heap of the device's own.
    fn heap_bytes_left(&self) -> Option<u64> {
        if !self.info.has(ext::memory_budget::NAME) {
            return None;
        }
        let mut budget = vk::PhysicalDeviceMemoryBudgetPropertiesEXT::default();
        let mut memory = vk::PhysicalDeviceMemoryProperties2::default().push_next(&mut budget);
        // SAFETY: the device has the extension; the records live until the call returns.
        unsafe { self.vulkan.instance.get_physical_device_memory_properties2(self.info.physical, &mut memory) };
        let properties = memory.memory_properties;
        let heaps = &properties.memory_heaps[..properties.memory_heap_count as usize];
        let own = |index: &usize| heaps[*index].flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL);
        let heap = (0..heaps.len()).filter(own).max_by_key(|&index| heaps[index].size)?;
        Some(budget.heap_budget[heap].saturating_sub(budget.heap_usage[heap]))
    }

    /// What the driver knows about the fault that lost the device, for people; `None` where it says nothing.
    pub fn fault_report(&self) -> Option<String> {
        // Drivers are asked about devices that they call lost.
        let fault = self.fault.as_ref().filter(|_| self.hung().is_none())?;
        let mut counts = vk::DeviceFaultCountsEXT::default();
        // SAFETY: without a record for the faults the call only counts them.
        let counted =
            unsafe { (fault.fp().get_device_fault_info_ext)(self.raw.handle(), &mut counts, std::ptr::null_mut()) };
        if counted != vk::Result::SUCCESS {
            return None;
        }
        let mut addresses = vec![vk::DeviceFaultAddressInfoEXT::default(); counts.address_info_count as usize];
        let mut vendor = vec![vk::DeviceFaultVendorInfoEXT::default(); counts.vendor_info_count as usize];
        counts.vendor_binary_size = 0;
        let mut info = vk::DeviceFaultInfoEXT {
            p_address_infos: addresses.as_mut_ptr(),
            p_vendor_infos: vendor.as_mut_ptr(),
            ..Default::default()
        };
        // SAFETY: both arrays are as long as the counts say.
        let filled = unsafe { (fault.fp().get_device_fault_info_ext)(self.raw.handle(), &mut counts, &mut info) };
        if filled != vk::Result::SUCCESS && filled != vk::Result::INCOMPLETE {
            return None;
        }
        let text = |text: Result<&CStr, _>| text.map(|text| text.to_string_lossy().into_owned()).unwrap_or_default();
        let mut report = format!("{}\n", text(info.description_as_c_str().map_err(drop)));
        for address in &addresses[..counts.address_info_count as usize] {
            let (kind, at) = (address.address_type, address.reported_address);
            report += &format!("address {at:#x}: {kind:?}, precision {}\n", address.address_precision);
        }
        for entry in &vendor[..counts.vendor_info_count as usize] {
            let (code, data) = (entry.vendor_fault_code, entry.vendor_fault_data);
            report +=
                &format!("{}: code {code:#x}, data {data:#x}\n", text(entry.description_as_c_str().map_err(drop)));
        }
        Some(report)
    }

    /// Calls that extensions of the device are made of, for whoever shows its pictures. It must not be destroyed.
    pub fn raw(&self) -> &ash::Device {
        &self.raw
    }

    /// The queue that traces, locked: nobody else may use it meanwhile.
    pub(crate) fn queue(&self) -> MutexGuard<'_, vk::Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The queue that shows pictures, locked: the one that traces where the device has no other.
    pub fn present_queue(&self) -> MutexGuard<'_, vk::Queue> {
        self.present_queue.as_ref().unwrap_or(&self.queue).lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether pictures are shown by a queue of their own.
    pub fn has_present_queue(&self) -> bool {
        self.present_queue.is_some()
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        if self.hung().is_some() {
            // The instance stays as well: it is that of a device.
            std::mem::forget(Arc::clone(&self.vulkan));
            return;
        }
        // SAFETY: whatever was made on the device kept it alive, so nothing is left; the allocator goes first.
        unsafe {
            ManuallyDrop::drop(&mut self.allocator);
            self.raw.destroy_device(None);
        }
    }
}

/// Locks the allocator; a panic elsewhere leaves it usable.
pub(crate) fn locked(allocator: &Mutex<Allocator>) -> MutexGuard<'_, Allocator> {
    allocator.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The device of `lost` among those that are listed now, maybe in another order. Drivers in software may give all their devices one UUID: then the number decides.
fn same_device(devices: Vec<DeviceInfo>, lost: &DeviceInfo) -> Option<DeviceInfo> {
    let same = devices.into_iter().filter(|info| info.uuid == lost.uuid && info.name == lost.name);
    same.min_by_key(|info| info.index != lost.index)
}

fn choose(devices: Vec<DeviceInfo>, wanted: Option<&str>) -> Result<DeviceInfo, TraceError> {
    let names = || devices.iter().map(|info| format!("{} {}", info.index, info.name)).collect::<Vec<_>>().join(", ");
    match wanted {
        Some(wanted) => {
            let number: Option<usize> = wanted.parse().ok();
            let has_number = |info: &&DeviceInfo| Some(info.index) == number;
            let has_name = |info: &&DeviceInfo| info.name.to_lowercase().contains(&wanted.to_lowercase());
            // Models have numbers, too, and machines few devices: versions in names are not meant.
            let may_be_name = number.is_none_or(|number| number >= 100);
            let by_name = || devices.iter().find(has_name).filter(|_| may_be_name);
            let found = devices.iter().find(has_number).or_else(by_name);
            found.cloned().ok_or_else(|| {
                TraceError::Unsupported(format!("no device is called {wanted:?}; there are: {}", names()))
            })
        }
        None => {
            let able = devices.iter().filter(|info| info.walk_missing.is_none() && info.kind != DeviceKind::Cpu);
            able.min_by_key(|info| {
                // A GPU may have a driver that is Vulkan in full, and another one that is not.
                let is_part = info.has(khr::portability_subset::NAME);
                (is_part, info.kind, std::cmp::Reverse(info.memory_bytes), info.index)
            })
            .cloned()
            .ok_or_else(|| match devices.is_empty() {
                true => TraceError::Unsupported("Vulkan finds no device".into()),
                false => TraceError::Unsupported(format!("no hardware among the Vulkan devices: {}", names())),
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::listing::devices;
    use voxtrace_test_support::{Need, skip_without};

    #[test]
    fn devices_are_found_by_what_stays_and_by_what_people_call_them() {
        let listed = devices(Options::default()).unwrap_or_default();
        let Some(any) = listed.first() else {
            skip_without(Need::Vulkan, "no Vulkan device");
            return;
        };
        let device = |index, uuid: u8| DeviceInfo { index, uuid: [uuid; vk::UUID_SIZE], ..any.clone() };
        let found = |devices: Vec<DeviceInfo>, lost| same_device(devices, &lost).map(|info| info.index);
        assert_eq!(found(vec![device(0, 7), device(1, 5)], device(0, 5)), Some(1), "its number has another one");
        assert_eq!(found(vec![device(0, 5), device(1, 5)], device(1, 5)), Some(1), "all have one UUID");
        assert_eq!(found(vec![device(0, 7)], device(0, 5)), None, "it is gone");
        // By what people call them.
        let named = |index, name: &str| DeviceInfo { name: name.into(), ..device(index, 5) };
        let devices = vec![
            named(0, "NVIDIA GeForce RTX 4090"),
            named(1, "NVIDIA GeForce RTX 3090"),
            named(2, "llvmpipe (LLVM 19.1.7)"),
        ];
        let chosen = |wanted| choose(devices.clone(), Some(wanted)).map(|info| info.index);
        let wanted = ["1", "3090", "rtx 40", "LLVM"];
        assert_eq!(wanted.map(|wanted| chosen(wanted).unwrap()), [1, 1, 0, 2]);
        assert!(matches!(chosen("7"), Err(TraceError::Unsupported(_))), "neither a number nor a part of a name");
    }
}
