//! The window as Vulkan drivers get it. On X11 that is a connection to the server of their own: what a driver asks of the server, on our
//! drawing thread and on its own ones, is then apart from what winit does by Xlib. On one connection for both, an answer or an error
//! that is meant for one can reach the other, and Xlib ends the program where the count of requests is not the one that it knows.

use super::{DrawError, Step};
use ash::vk;
use std::os::raw::c_char;
use voxtrace_vulkan::Vulkan;
use winit::raw_window_handle::{HasDisplayHandle, HasWindowHandle, RawDisplayHandle, RawWindowHandle};

/// The names of the instance extensions that a surface of this window system needs.
///
/// # Errors
/// [`DrawError::Unsupported`] where the window system gives no handle or Vulkan does not know it.
pub fn surface_extensions(display: &impl HasDisplayHandle) -> Result<&'static [*const c_char], DrawError> {
    let display = display.display_handle().map_err(without_handle)?.as_raw();
    ash_window::enumerate_required_extensions(kind_for_drivers(display))
        .map_err(|error| DrawError::Unsupported(format!("Vulkan does not know this window system ({error})")))
}

/// A connection to the X server, held until its surface is gone; there is none on other window systems.
#[derive(Default)]
pub struct Connection {
    #[cfg(target_os = "linux")]
    _xcb: Option<x11rb::xcb_ffi::XCBConnection>,
}

impl Connection {
    /// Makes a surface of a window, and the connection that must outlive it.
    ///
    /// # Errors
    /// [`DrawError::Unsupported`] where the window system gives no handles or takes no further connection; what the driver answers.
    pub fn surface(
        vulkan: &Vulkan,
        window: &(impl HasDisplayHandle + HasWindowHandle),
    ) -> Result<(vk::SurfaceKHR, Self), DrawError> {
        let display = window.display_handle().map_err(without_handle)?.as_raw();
        let window = window.window_handle().map_err(without_handle)?.as_raw();
        let (connection, display, window) = Self::open(display, window)?;
        // SAFETY: both handles are those of the window, which outlives the surface, or of the connection, which is returned with it;
        // the instance has the extensions for it.
        let surface = unsafe { ash_window::create_surface(vulkan.entry(), vulkan.instance(), display, window, None) }
            .step("making the window's surface")?;
        Ok((surface, connection))
    }

    #[cfg(target_os = "linux")]
    fn open(
        display: RawDisplayHandle,
        window: RawWindowHandle,
    ) -> Result<(Self, RawDisplayHandle, RawWindowHandle), DrawError> {
        use std::{num::NonZero, ptr::NonNull};
        use winit::raw_window_handle::{XcbDisplayHandle, XcbWindowHandle};
        // Names of windows have 32 bits, in Xlib's type of any width too.
        let id = match window {
            RawWindowHandle::Xlib(xlib) => u32::try_from(xlib.window).ok().and_then(NonZero::new),
            _ => None,
        };
        let (RawDisplayHandle::Xlib(xlib), Some(id)) = (display, id) else {
            return Ok((Self::default(), display, window));
        };
        let (connection, _) = x11rb::xcb_ffi::XCBConnection::connect(None)
            .map_err(|error| DrawError::Unsupported(format!("the X server takes no second connection: {error}")))?;
        let display = XcbDisplayHandle::new(NonNull::new(connection.get_raw_xcb_connection()), xlib.screen);
        Ok((Self { _xcb: Some(connection) }, display.into(), XcbWindowHandle::new(id).into()))
    }

    #[cfg(not(target_os = "linux"))]
    fn open(
        display: RawDisplayHandle,
        window: RawWindowHandle,
    ) -> Result<(Self, RawDisplayHandle, RawWindowHandle), DrawError> {
        Ok((Self::default(), display, window))
    }
}

/// A handle of the kind that drivers get: XCB's in place of Xlib's.
fn kind_for_drivers(display: RawDisplayHandle) -> RawDisplayHandle {
    match display {
        #[cfg(target_os = "linux")]
        RawDisplayHandle::Xlib(xlib) => winit::raw_window_handle::XcbDisplayHandle::new(None, xlib.screen).into(),
        other => other,
    }
}

fn without_handle(error: impl std::fmt::Display) -> DrawError {
    DrawError::Unsupported(format!("the window system gives no handle: {error}"))
}
