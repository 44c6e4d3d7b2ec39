//! Errors planted into Vulkan's function table, for tests: a table whose fallible functions count their calls and answer the
//! n-th one with an error. A plan is in force on the thread that opened Vulkan with it, one at a time, so that tests can run side by
//! side; a lasting one on all threads that have none of their own.

use ash::vk;
use std::cell::RefCell;
use std::collections::HashMap;
use std::ffi::{CStr, c_char, c_void};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An error to answer with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The device is lost, and stays so until it is opened anew.
    DeviceLost,
    /// The device has no memory left.
    OutOfDeviceMemory,
    /// The driver finds no memory on the host.
    OutOfHostMemory,
    /// The surface of the window is gone.
    SurfaceLost,
    /// The window changed, and its images do not suit any more.
    OutOfDate,
    /// What was submitted does not end, however long one waits by this function, until the device is opened anew. Tracers wait for semaphores, the window for
    /// fences.
    Hang,
}

impl Fault {
    /// Those that have nothing to do with windows.
    pub const ALL: [Self; 3] = [Self::DeviceLost, Self::OutOfDeviceMemory, Self::OutOfHostMemory];

    fn result(self) -> vk::Result {
        match self {
            Self::DeviceLost => vk::Result::ERROR_DEVICE_LOST,
            Self::OutOfDeviceMemory => vk::Result::ERROR_OUT_OF_DEVICE_MEMORY,
            Self::OutOfHostMemory => vk::Result::ERROR_OUT_OF_HOST_MEMORY,
            Self::SurfaceLost => vk::Result::ERROR_SURFACE_LOST_KHR,
            Self::OutOfDate => vk::Result::ERROR_OUT_OF_DATE_KHR,
            Self::Hang => vk::Result::TIMEOUT,
        }
    }

    /// Whether the specification lets a function answer so.
    fn is_legal(self, function: &str) -> bool {
        const OF_WINDOWS: [&str; 3] = ["vkCreateSwapchainKHR", "vkAcquireNextImageKHR", "vkQueuePresentKHR"];
        const OF_DEVICES: [&str; 7] = [
            "vkQueueSubmit",
            "vkWaitSemaphores",
            "vkGetQueryPoolResults",
            "vkDeviceWaitIdle",
            "vkCreateDevice",
            "vkWaitForFences",
            "vkQueueWaitIdle",
        ];
        match self {
            Self::DeviceLost => OF_DEVICES.contains(&function) || OF_WINDOWS.contains(&function),
            Self::SurfaceLost => OF_WINDOWS.contains(&function),
            Self::OutOfDate => OF_WINDOWS[1..].contains(&function),
            Self::OutOfDeviceMemory | Self::OutOfHostMemory => true,
            Self::Hang => ["vkWaitSemaphores", "vkWaitForFences"].contains(&function),
        }
    }
}

/// What to plant.
#[derive(Debug, Default)]
pub struct Faults {
    state: Mutex<State>,
    /// Names of extensions to hide.
    hidden: Vec<String>,
    /// The number, from 0, of the dispatch to leave out.
    left_out: Option<u64>,
    /// Calls are not listed: a run that lasts would fill memory with them.
    is_lasting: bool,
}

#[derive(Debug, Default)]
struct State {
    /// The number, from 0, of the call to answer with each error; the same call may stand for several in turn.
    plan: Vec<(u64, Fault)>,
    /// The error for the next call of a function.
    planted: Vec<(&'static str, Fault)>,
    calls: Vec<&'static str>,
    fired: Vec<(&'static str, Fault)>,
    is_lost: bool,
    /// The function by which one waits in vain.
    hangs: Option<&'static str>,
    dispatches: u64,
}

impl Faults {
    /// Only counts calls.
    pub fn none() -> Arc<Self> {
        Arc::default()
    }

    /// Answers each of the calls named by their number with an error, where that is legal.
    pub fn at(plan: &[(u64, Fault)]) -> Arc<Self> {
        let faults = Self::default();
        faults.locked().plan = plan.to_vec();
        Arc::new(faults)
    }

    /// For a run that lasts, on whatever threads: calls are not listed, and errors are planted while it goes on, by [`Self::plant`].
    pub fn lasting() -> Arc<Self> {
        Arc::new(Self { is_lasting: true, ..Self::default() })
    }

    /// Answers the next call of a function with an error.
    ///
    /// # Panics
    /// Where the specification does not let it answer so.
    pub fn plant(&self, function: &'static str, fault: Fault) {
        assert!(fault.is_legal(function), "{function} never answers {fault:?}");
        self.locked().planted.push((function, fault));
    }

    /// Takes back the errors that were planted and not given. Returns how many.
    pub fn clear(&self) -> usize {
        std::mem::take(&mut self.locked().planted).len()
    }

    /// Hides extensions.
    pub fn without(extensions: &[&str]) -> Arc<Self> {
        Arc::new(Self { hidden: extensions.iter().map(ToString::to_string).collect(), ..Self::default() })
    }

    /// Leaves out one dispatch of a compute shader, without a word: a driver that does not do its work.
    pub fn without_dispatch(dispatch: u64) -> Arc<Self> {
        Arc::new(Self { left_out: Some(dispatch), ..Self::default() })
    }

    /// The fallible calls so far, by name.
    pub fn calls(&self) -> Vec<&'static str> {
        self.locked().calls.clone()
    }

    /// The errors that were given.
    pub fn fired(&self) -> Vec<(&'static str, Fault)> {
        self.locked().fired.clone()
    }

    /// Whether `fault` is a legal answer to call number `call` of a run.
    pub fn is_legal(calls: &[&'static str], call: usize, fault: Fault) -> bool {
        calls.get(call).is_some_and(|function| fault.is_legal(function))
    }

    /// Puts the plan in force on this thread as well, for work that another one hands over.
    pub(crate) fn follow(self: &Arc<Self>) {
        OF_THREAD.set((!self.is_lasting).then(|| Arc::clone(self)));
    }

    /// The plan that this thread follows, if it has one of its own.
    pub(crate) fn of_thread() -> Option<Arc<Self>> {
        OF_THREAD.with_borrow(Option::clone)
    }

    /// Lets this thread follow a plan that [`Self::of_thread`] gave.
    pub(crate) fn restore(plan: Option<Arc<Self>>) {
        OF_THREAD.set(plan);
    }

    fn locked(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The error for the next call, which is one of `function`.
    fn next(&self, function: &'static str) -> Option<Fault> {
        let mut state = self.locked();
        let call = state.calls.len() as u64;
        if !self.is_lasting {
            state.calls.push(function);
        }
        // A new device is a healthy one.
        if function == "vkCreateDevice" {
            (state.is_lost, state.hangs) = (false, None);
        }
        let planted = state.planted.iter().position(|(planted, _)| *planted == function);
        let planned = match planted {
            Some(index) => Some((call, state.planted.swap_remove(index).1)),
            None => state.plan.iter().find(|(at, fault)| *at == call && fault.is_legal(function)).copied(),
        };
        if let Some((_, fault)) = planned {
            state.fired.push((function, fault));
            state.is_lost |= fault == Fault::DeviceLost && function != "vkCreateDevice";
            if fault == Fault::Hang {
                state.hangs = Some(function);
            }
            return Some(fault);
        }
        if state.hangs == Some(function) {
            return Some(Fault::Hang);
        }
        (state.is_lost && Fault::DeviceLost.is_legal(function)).then_some(Fault::DeviceLost)
    }
}

/// The lasting plan, and the real functions behind ours.
struct Table {
    faults: Option<Arc<Faults>>,
    real: Option<HashMap<&'static str, usize>>,
}

thread_local! {
    /// The plan of this thread.
    static OF_THREAD: RefCell<Option<Arc<Faults>>> = const { RefCell::new(None) };
}

static TABLE: Mutex<Table> = Mutex::new(Table { faults: None, real: None });

fn table() -> MutexGuard<'static, Table> {
    TABLE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The address of the real function, and the error to answer with instead of calling it.
fn next_call(function: &'static str) -> (usize, Option<Fault>) {
    (real_function(function), plan_in_force().and_then(|faults| faults.next(function)))
}

fn real_function(function: &str) -> usize {
    table().real.as_ref().and_then(|real| real.get(function)).copied().unwrap_or(0)
}

fn plan_in_force() -> Option<Arc<Faults>> {
    Faults::of_thread().or_else(|| table().faults.clone())
}

/// Defines a stand-in for each function, and `stand_in`, which finds them by name.
macro_rules! stand_ins {
    ($($name:ident = $function:literal ($($argument:ident: $kind:ty),+)),+ $(,)?) => {
        $(unsafe extern "system" fn $name($($argument: $kind),+) -> vk::Result {
            let (real, fault) = next_call($function);
            // Work that is under way when a device is lost must end before its memory is freed.
            let must_call =
                matches!($function, "vkDeviceWaitIdle" | "vkWaitSemaphores" | "vkWaitForFences" | "vkQueueWaitIdle");
            if let Some(fault) = fault && (!must_call || fault == Fault::Hang) {
                return fault.result();
            }
            // SAFETY: `stand_in` stored the address of the function of this name, whose type the specification gives.
            let result = unsafe {
                let real: unsafe extern "system" fn($($kind),+) -> vk::Result = std::mem::transmute(real);
                real($($argument),+)
            };
            fault.map_or(result, Fault::result)
        })+

        /// Our function in place of the real one, which it remembers; `None` for functions that do not fail.
        fn stand_in(name: &CStr, real: usize) -> Option<usize> {
            if real == 0 {
                return None;
            }
            let (function, ours) = match name.to_bytes() {
                $(bytes if bytes == $function.as_bytes() => ($function, $name as *const c_void as usize),)+
                _ => return None,
            };
            table().real.get_or_insert_default().insert(function, real);
            Some(ours)
        }
    };
}

type Pointer = *const c_void;
type Output = *mut c_void;

stand_ins! {
    create_device = "vkCreateDevice"(physical: vk::PhysicalDevice, info: Pointer, callbacks: Pointer, made: Output),
    list_devices = "vkEnumeratePhysicalDevices"(instance: vk::Instance, count: *mut u32, devices: Output),
    list_extensions = "vkEnumerateDeviceExtensionProperties"(
        physical: vk::PhysicalDevice, layer: *const c_char, count: *mut u32, properties: *mut vk::ExtensionProperties),
    create_buffer = "vkCreateBuffer"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    bind_buffer = "vkBindBufferMemory"(
        device: vk::Device, buffer: vk::Buffer, memory: vk::DeviceMemory, offset: vk::DeviceSize),
    allocate = "vkAllocateMemory"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    map = "vkMapMemory"(
        device: vk::Device, memory: vk::DeviceMemory, offset: vk::DeviceSize, size: vk::DeviceSize, flags: u32,
        mapped: Output),
    create_pool = "vkCreateCommandPool"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_commands = "vkAllocateCommandBuffers"(device: vk::Device, info: Pointer, made: Output),
    begin = "vkBeginCommandBuffer"(commands: vk::CommandBuffer, info: Pointer),
    end = "vkEndCommandBuffer"(commands: vk::CommandBuffer),
    submit = "vkQueueSubmit"(queue: vk::Queue, count: u32, submits: Pointer, fence: vk::Fence),
    wait = "vkWaitSemaphores"(device: vk::Device, info: Pointer, timeout: u64),
    wait_idle = "vkDeviceWaitIdle"(device: vk::Device),
    wait_fences = "vkWaitForFences"(
        device: vk::Device, count: u32, fences: Pointer, waits_for_all: vk::Bool32, timeout: u64),
    wait_queue = "vkQueueWaitIdle"(queue: vk::Queue),
    create_swapchain = "vkCreateSwapchainKHR"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    acquire = "vkAcquireNextImageKHR"(
        device: vk::Device, chain: vk::SwapchainKHR, timeout: u64, semaphore: vk::Semaphore, fence: vk::Fence,
        image: *mut u32),
    present = "vkQueuePresentKHR"(queue: vk::Queue, info: Pointer),
    query_results = "vkGetQueryPoolResults"(
        device: vk::Device, pool: vk::QueryPool, first: u32, count: u32, size: usize, data: Output,
        stride: vk::DeviceSize, flags: u32),
    create_queries = "vkCreateQueryPool"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_semaphore = "vkCreateSemaphore"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_set_layout = "vkCreateDescriptorSetLayout"(
        device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_layout = "vkCreatePipelineLayout"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_set_pool = "vkCreateDescriptorPool"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_sets = "vkAllocateDescriptorSets"(device: vk::Device, info: Pointer, made: Output),
    create_module = "vkCreateShaderModule"(device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
    create_compute = "vkCreateComputePipelines"(
        device: vk::Device, cache: vk::PipelineCache, count: u32, infos: Pointer, callbacks: Pointer, made: Output),
    create_rays = "vkCreateRayTracingPipelinesKHR"(
        device: vk::Device, operation: vk::DeferredOperationKHR, cache: vk::PipelineCache, count: u32, infos: Pointer,
        callbacks: Pointer, made: Output),
    handles = "vkGetRayTracingShaderGroupHandlesKHR"(
        device: vk::Device, pipeline: vk::Pipeline, first: u32, count: u32, size: usize, data: Output),
    create_structure = "vkCreateAccelerationStructureKHR"(
        device: vk::Device, info: Pointer, callbacks: Pointer, made: Output),
}

/// A dispatch, unless it is the one to leave out.
unsafe extern "system" fn dispatch(commands: vk::CommandBuffer, x: u32, y: u32, z: u32) {
    let real = real_function("vkCmdDispatch");
    if let Some(faults) = plan_in_force() {
        let mut state = faults.locked();
        state.dispatches += 1;
        if faults.left_out == Some(state.dispatches - 1) {
            return;
        }
    }
    // SAFETY: the address is that of the real `vkCmdDispatch`.
    unsafe {
        let real: vk::PFN_vkCmdDispatch = std::mem::transmute(real);
        real(commands, x, y, z);
    }
}

/// The list of extensions without the hidden ones.
unsafe extern "system" fn list_visible(
    physical: vk::PhysicalDevice,
    layer: *const c_char,
    count: *mut u32,
    properties: *mut vk::ExtensionProperties,
) -> vk::Result {
    // SAFETY: the caller's pointers go on as they are; the list that comes back is as long as the count says.
    unsafe {
        let result = list_extensions(physical, layer, count, properties);
        if properties.is_null() || result != vk::Result::SUCCESS {
            return result;
        }
        let hidden = plan_in_force().map(|faults| faults.hidden.clone()).unwrap_or_default();
        let list = std::slice::from_raw_parts_mut(properties, *count as usize);
        for entry in list {
            let name = entry.extension_name_as_c_str().unwrap_or_default().to_string_lossy().into_owned();
            if hidden.contains(&name) {
                entry.extension_name[0] = 0;
            }
        }
        result
    }
}

/// Gives out our functions in place of the device's.
unsafe extern "system" fn get_device_function(device: vk::Device, name: *const c_char) -> vk::PFN_vkVoidFunction {
    let real = real_function("vkGetDeviceProcAddr");
    // SAFETY: the address is that of the real `vkGetDeviceProcAddr`; names end with zero; stand-ins have the type of what
    // they stand for.
    unsafe {
        let get: vk::PFN_vkGetDeviceProcAddr = std::mem::transmute(real);
        let found = get(device, name);
        let address = found.map_or(0, |function| function as *const c_void as usize);
        let name = CStr::from_ptr(name);
        if name == c"vkCmdDispatch" && address != 0 {
            table().real.get_or_insert_default().insert("vkCmdDispatch", address);
            let ours = dispatch as *const c_void as usize;
            return std::mem::transmute::<usize, vk::PFN_vkVoidFunction>(ours);
        }
        match stand_in(name, address) {
            Some(ours) => std::mem::transmute::<usize, vk::PFN_vkVoidFunction>(ours),
            None => found,
        }
    }
}

/// The same instance, with a table that plants errors.
pub fn instance_with_faults(entry: &ash::Entry, instance: ash::Instance, faults: &Arc<Faults>) -> ash::Instance {
    faults.follow();
    if faults.is_lasting {
        table().faults = Some(Arc::clone(faults));
    }
    let handle = instance.handle();
    let load = |name: &CStr| {
        // SAFETY: the instance is alive.
        let found = unsafe { entry.get_instance_proc_addr(handle, name.as_ptr()) };
        let address = found.map_or(0, |function| function as *const c_void as usize);
        let ours = match name.to_bytes() {
            b"vkGetDeviceProcAddr" => {
                table().real.get_or_insert_default().insert("vkGetDeviceProcAddr", address);
                Some(get_device_function as *const c_void as usize)
            }
            b"vkEnumerateDeviceExtensionProperties" => {
                stand_in(name, address).map(|_| list_visible as *const c_void as usize)
            }
            _ => stand_in(name, address),
        };
        ours.unwrap_or(address) as *const c_void
    };
    // SAFETY: every function is that of the instance, or ours of the same type, which calls it.
    unsafe { ash::Instance::load_with(load, handle) }
}
