//! Waits of the renderer of the panels: it waits until a whole queue does nothing whenever it has written a texture, by a call that has no limit. It gets the
//! functions of the device with one in the place of that call that has.

use ash::vk;
use std::cell::RefCell;
use std::ffi::{CStr, c_void};
use std::sync::Arc;
use voxtrace_vulkan::Device;

thread_local! {
    /// The device whose queue is waited for on this thread.
    static WAITING: RefCell<Option<Arc<Device>>> = const { RefCell::new(None) };
}

/// The functions of a device as the renderer has them. What waits for a queue has to be called within [`waiting`].
pub fn functions(device: &Device) -> ash::Device {
    let handle = device.raw().handle();
    let load = |name: &CStr| {
        if name == c"vkQueueWaitIdle" {
            return wait_for_queue as *const c_void;
        }
        // SAFETY: the device belongs to the instance; names end with zero.
        let found = unsafe { device.vulkan().instance().get_device_proc_addr(handle, name.as_ptr()) };
        found.map_or(std::ptr::null(), |function| function as *const c_void)
    };
    // SAFETY: every function is that of the device, or ours of the same type.
    unsafe { ash::Device::load_with(load, handle) }
}

/// Does what waits for a queue of `device`, which the caller has locked: a device that hangs is given up then, and counts as lost.
pub fn waiting<R>(device: &Arc<Device>, wait: impl FnOnce() -> R) -> R {
    WAITING.set(Some(Arc::clone(device)));
    let done = wait();
    WAITING.set(None);
    done
}

unsafe extern "system" fn wait_for_queue(queue: vk::Queue) -> vk::Result {
    let device = WAITING.with_borrow(Option::clone);
    let Some(device) = device else { return vk::Result::ERROR_DEVICE_LOST };
    // SAFETY: the queue is one of this device, and locked, as the caller of `waiting` sees to.
    match unsafe { device.wait_for_queue(queue) } {
        Ok(()) => vk::Result::SUCCESS,
        Err(error) => error,
    }
}
