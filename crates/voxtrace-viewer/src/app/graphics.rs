//! The window with its device: opening both, running the panels, drawing frames.

use super::ViewerError;
use crate::engine::Shown;
use crate::gpu::{Beside, DrawError, Layer, Outcome, Panels, Surface, Textures, Window as Target};
use crate::panels::Compared;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::TraceError;
use voxtrace::output::ToneMap;
use voxtrace_vulkan::{Device, Options, Vulkan};
use winit::raw_window_handle::HasDisplayHandle;
use winit::window::Window;

/// A window that is open.
pub struct Graphics {
    target: Option<Target>,
    surface: Arc<Surface>,
    device: Arc<Device>,
    pub egui: egui_winit::State,
    pub window: Arc<Window>,
    /// When the panels want to be drawn again by themselves.
    pub repaint_at: Option<Instant>,
    textures: Textures,
    /// Whether the device has none of them yet.
    lacks_textures: bool,
}

/// Panels that have run.
pub struct PanelFrame {
    panels: Panels,
    pub pixels_per_point: f32,
}

impl Graphics {
    /// Opens the device for a window: the one that is wanted, else the best that can show pictures in it, software last.
    pub fn new(window: Arc<Window>, wanted: Option<&str>, validation: bool) -> Result<Self, ViewerError> {
        let handle = window.display_handle().map_err(|error| ViewerError::Window(error.to_string()))?;
        let names = ash_window::enumerate_required_extensions(handle.as_raw())
            .map_err(|error| ViewerError::Window(format!("Vulkan does not know this window system ({error})")))?;
        // SAFETY: the names are constants of the loader's headers.
        let surface_extensions = names.iter().map(|&name| unsafe { std::ffi::CStr::from_ptr(name) }).collect();
        let options = Options::for_window(validation, surface_extensions);
        let vulkan = Vulkan::open(options)?;
        let surface = Arc::new(Surface::new(&vulkan, &window)?);
        let device = open_device(&vulkan, &surface, wanted)?;
        let context = egui::Context::default();
        context.options_mut(|options| options.zoom_with_keyboard = false);
        let scale = window.scale_factor() as f32;
        let egui =
            egui_winit::State::new(context, egui::ViewportId::ROOT, &window, Some(scale), window.theme(), Some(8192));
        let target = Some(Target::new(&device, &surface, size_of(&window))?);
        let textures = Textures::default();
        Ok(Self { target, surface, device, egui, window, repaint_at: None, textures, lacks_textures: false })
    }

    /// Opens another device, by its number or a part of its name. Whether it can show pictures in this window, [`Self::move_to`] says.
    pub fn open_other(&self, wanted: &str) -> Result<Arc<Device>, TraceError> {
        Device::open_on(self.device().vulkan(), Some(wanted), None)
    }

    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// Draws with another device, or the same one, opened anew.
    pub fn move_to(&mut self, device: &Arc<Device>) -> Result<(), DrawError> {
        self.target = None;
        self.device = Arc::clone(device);
        self.target = Some(Target::new(device, &self.surface, size_of(&self.window))?);
        self.lacks_textures = true;
        Ok(())
    }

    pub fn resize(&mut self, size: (u32, u32)) {
        if let Some(target) = &mut self.target {
            target.resize(size);
        }
    }

    /// Runs the panels with what has happened since the last frame.
    pub fn run_panels(&mut self, show: impl FnMut(&mut egui::Ui)) -> PanelFrame {
        let input = self.egui.take_egui_input(&self.window);
        let context = self.egui.egui_ctx().clone();
        let output = context.run_ui(input, show);
        self.egui.handle_platform_output(&self.window, output.platform_output);
        let delay = output.viewport_output.get(&egui::ViewportId::ROOT).map(|viewport| viewport.repaint_delay);
        self.repaint_at = delay.filter(|&delay| delay < Duration::from_secs(3600)).map(|delay| Instant::now() + delay);
        let pixels_per_point = output.pixels_per_point;
        let primitives = context.tessellate(output.shapes, pixels_per_point);
        let mut textures = output.textures_delta;
        self.textures.take(&textures);
        if std::mem::take(&mut self.lacks_textures) {
            textures = self.textures.all();
        }
        PanelFrame { panels: Panels { textures, primitives, pixels_per_point }, pixels_per_point }
    }

    /// Draws a frame: the picture in the upper left `width` × `height` pixels, and the panels.
    pub fn draw(
        &mut self,
        frame: PanelFrame,
        shown: Option<&Shown>,
        compared: Option<Compared>,
        (width, height): (u32, u32),
        tone_map: ToneMap,
    ) -> Result<(), DrawError> {
        // A picture of another size, or coarser, fills the same place.
        let size = [width as f32, height as f32];
        let layer = shown.map(|shown| {
            let (mut picture, mut beside) = (Arc::clone(&shown.picture), None);
            match compared {
                Some(Compared::Differences(differences)) => picture = Arc::clone(&differences.picture),
                Some(Compared::Beside(other, split)) => {
                    let picture = Arc::clone(&other.picture);
                    beside = Some(Beside { picture, size, split: split * width as f32 });
                }
                None => {}
            }
            Layer { picture, corner: [0.0; 2], size, tone_map, beside }
        });
        let Some(target) = &mut self.target else { return Ok(()) };
        let window = &self.window;
        match target.draw(layer.as_ref(), frame.panels, || window.pre_present_notify()) {
            Ok(Outcome::Shown) => Ok(()),
            Ok(Outcome::Again) => {
                let size = window.inner_size();
                if size.width > 0 && size.height > 0 {
                    window.request_redraw();
                }
                Ok(())
            }
            // What traces notices too, opens the device anew and says so.
            Err(error) if error.is_device_lost() => {
                self.target = None;
                Ok(())
            }
            Err(error) => Err(error),
        }
    }
}

impl Drop for Graphics {
    fn drop(&mut self) {
        // Before the window.
        self.target = None;
    }
}

fn size_of(window: &Window) -> (u32, u32) {
    let size = window.inner_size();
    (size.width, size.height)
}

fn open_device(vulkan: &Arc<Vulkan>, surface: &Surface, wanted: Option<&str>) -> Result<Arc<Device>, ViewerError> {
    if let Some(wanted) = wanted {
        let device = Device::open_on(vulkan, Some(wanted), None)?;
        return match surface.suits(&device) {
            true => Ok(device),
            false => {
                let name = &device.info().name;
                Err(TraceError::Unsupported(format!("{name} cannot show pictures in this window")).into())
            }
        };
    }
    if let Ok(device) = Device::open_on(vulkan, None, None)
        && surface.suits(&device)
    {
        return Ok(device);
    }
    // Whatever there is, software too.
    let numbers = 0..voxtrace_vulkan::devices(Options::default())?.len();
    let found = numbers
        .filter_map(|number| Device::open_on(vulkan, Some(&number.to_string()), None).ok())
        .find(|device| surface.suits(device));
    found.ok_or_else(|| TraceError::Unsupported("no Vulkan device can show pictures in this window".into()).into())
}
