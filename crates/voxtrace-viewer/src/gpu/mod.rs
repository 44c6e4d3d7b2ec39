//! Drawing on the device: the traced picture and, over it, the panels.

mod copy;
mod layer;
mod painter;
mod panel_memory;
mod panel_waits;
mod pass;
mod pipeline;
mod presenter;
mod screen;
mod swapchain;
mod target;
mod textures;
mod timestamps;
mod window_system;

pub use layer::{Beside, Layer, Panels};
pub use presenter::Drawing;
pub use screen::{Next, Screen};
pub use swapchain::Surface;
pub use target::Offscreen;
pub use window_system::surface_extensions;

use ash::vk;

/// The device, or what shows its pictures, failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// The driver answered with an error.
    #[error("{step} failed: {result}")]
    Vulkan {
        /// What it was asked to do.
        step: &'static str,
        /// What it answered.
        result: vk::Result,
    },
    /// The panels could not be drawn.
    #[error("drawing the panels failed: {0}")]
    Panels(#[from] egui_ash_renderer::RendererError),
    /// A picture could not be made.
    #[error("{0}")]
    Trace(#[from] voxtrace::TraceError),
    /// The device cannot show pictures in this window.
    #[error("{0}")]
    Unsupported(String),
}

/// What is gone and has to be made anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// The device, with everything on it.
    Device,
    /// The surface of the window.
    Surface,
}

impl DrawError {
    /// What is gone, where that is why drawing failed.
    pub fn loss(&self) -> Option<Loss> {
        use egui_ash_renderer::RendererError;
        let result = match self {
            Self::Vulkan { result, .. } | Self::Panels(RendererError::Vulkan(result)) => *result,
            Self::Trace(voxtrace::TraceError::DeviceLost { .. }) => vk::Result::ERROR_DEVICE_LOST,
            _ => return None,
        };
        match result {
            vk::Result::ERROR_DEVICE_LOST => Some(Loss::Device),
            vk::Result::ERROR_SURFACE_LOST_KHR => Some(Loss::Surface),
            _ => None,
        }
    }
}

/// Names what a call of Vulkan was for.
trait Step<T> {
    fn step(self, step: &'static str) -> Result<T, DrawError>;
}

impl<T> Step<T> for Result<T, vk::Result> {
    fn step(self, step: &'static str) -> Result<T, DrawError> {
        self.map_err(|result| DrawError::Vulkan { step, result })
    }
}
