//! What a window is shown with, as the thread has it that takes events: the thread that draws, the device, the surface; and what
//! becomes of them when one is lost.

use super::layer::{Layer, Panels};
use super::presenter::{Drawing, Presenter};
use super::swapchain::Surface;
use super::{DrawError, Loss};
use crate::phases::Phases;
use std::sync::Arc;
use voxtrace_vulkan::{Device, Vulkan};

/// Makes a surface of the window for an instance.
type MakeSurface = Box<dyn Fn(&Arc<Vulkan>) -> Result<Surface, DrawError>>;

/// What is to be done after the thread that draws told something.
pub enum Next {
    /// Nothing.
    Nothing,
    /// Draw a frame.
    Draw,
    /// The device is lost: open it anew, then [`Screen::move_to`].
    Reopen(Arc<Device>),
}

/// A window that is shown. The window must outlive it.
pub struct Screen {
    // Dropped first: its thread uses the surface.
    presenter: Presenter,
    surface: Option<Arc<Surface>>,
    device: Arc<Device>,
    make_surface: MakeSurface,
    /// Whether a frame was wanted while the last one was being drawn.
    is_waiting: bool,
    /// The device that is to draw and for which no surface could be made: it is tried again after the next frame, which shows nothing.
    wanted: Option<Arc<Device>>,
}

impl Screen {
    /// Shows a window of `size` pixels. On the thread that draws, `about_to_show` is called before a frame is shown, and `tell`
    /// after each frame.
    ///
    /// # Errors
    /// [`DrawError::Unsupported`] where the device cannot; what the driver answers.
    pub fn new(
        device: &Arc<Device>,
        surface: Surface,
        size: (u32, u32),
        make_surface: impl Fn(&Arc<Vulkan>) -> Result<Surface, DrawError> + 'static,
        about_to_show: impl Fn() + Send + 'static,
        tell: impl Fn(Drawing) + Send + 'static,
    ) -> Result<Self, DrawError> {
        let surface = Arc::new(surface);
        Ok(Self {
            presenter: Presenter::start(device, &surface, size, about_to_show, tell)?,
            surface: Some(surface),
            device: Arc::clone(device),
            make_surface: Box::new(make_surface),
            is_waiting: false,
            wanted: None,
        })
    }

    /// The device that draws.
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// The window has another size, pixels.
    pub fn resize(&self, size: (u32, u32)) {
        self.presenter.resize(size);
    }

    /// Whether a frame can be drawn now. Where not, [`Self::take`] says when.
    pub fn is_ready(&mut self) -> bool {
        self.is_waiting = self.presenter.is_busy();
        !self.is_waiting
    }

    /// Hands a frame over.
    pub fn draw(&self, layer: Option<Layer>, panels: Panels) {
        self.presenter.draw(layer, panels);
    }

    /// Draws on with another device: the same one, opened anew. Where no surface can be made, it is tried again after the next frame.
    ///
    /// # Errors
    /// What the driver answers to the making of a surface.
    pub fn move_to(&mut self, device: &Arc<Device>) -> Result<(), DrawError> {
        let moved = self.try_to_move(device);
        // A surface that does not suit the device never will.
        self.wanted = self.surface.is_none().then(|| Arc::clone(device));
        moved
    }

    fn try_to_move(&mut self, device: &Arc<Device>) -> Result<(), DrawError> {
        let vulkan = device.vulkan();
        let surface = match self.surface.take().filter(|surface| Arc::ptr_eq(surface.vulkan(), vulkan)) {
            Some(surface) => surface,
            None => Arc::new((self.make_surface)(vulkan)?),
        };
        let suits = surface.suits(device);
        if suits {
            self.presenter.move_to(device, &surface);
            self.device = Arc::clone(device);
        }
        self.surface = Some(surface);
        let name = &device.info().name;
        suits.then_some(()).ok_or_else(|| DrawError::Unsupported(format!("{name} cannot show pictures in this window")))
    }

    /// Takes what the thread tells that draws.
    ///
    /// # Errors
    /// [`DrawError`] where a frame failed, and the next one may do.
    pub fn take(&mut self, drawing: Drawing) -> Result<Next, DrawError> {
        match drawing {
            Drawing::Ready { .. } if self.wanted.is_some() => {
                let device = self.wanted.take().unwrap_or_else(|| Arc::clone(&self.device));
                self.move_to(&device).map(|()| Next::Draw)
            }
            Drawing::Ready { is_shown } if self.is_waiting || !is_shown => Ok(Next::Draw),
            Drawing::Ready { .. } => Ok(Next::Nothing),
            // Of a device that was left since.
            Drawing::Lost(_, device) if !Arc::ptr_eq(&device, &self.device) => Ok(Next::Nothing),
            Drawing::Lost(Loss::Device, device) => Ok(Next::Reopen(device)),
            Drawing::Lost(Loss::Surface, device) => {
                // The old one goes first.
                self.surface = None;
                self.move_to(&device).map(|()| Next::Nothing)
            }
            Drawing::Failed(error) => Err(error),
        }
    }

    /// What frames were spent on.
    pub fn phases(&self) -> Phases {
        self.presenter.phases()
    }
}
