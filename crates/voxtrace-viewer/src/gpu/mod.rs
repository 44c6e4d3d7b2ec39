//! Drawing on the device: the traced picture and, over it, the panels.

mod painter;
mod pipeline;
mod swapchain;
mod target;
mod textures;

pub use painter::{Beside, Layer, Panels};
pub use swapchain::{Outcome, Surface, Window};
pub use target::Offscreen;
pub(crate) use textures::Textures;

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

impl DrawError {
    /// Whether the device is gone.
    pub fn is_device_lost(&self) -> bool {
        matches!(self, Self::Vulkan { result: vk::Result::ERROR_DEVICE_LOST, .. })
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
