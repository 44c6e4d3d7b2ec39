//! The window with its device: opening both, running the panels, handing frames to the thread that draws.

use super::ViewerError;
use crate::engine::Shown;
use crate::gpu::{Beside, DrawError, Drawing, Layer, Next, Panels, Screen, Surface, surface_extensions};
use crate::panels::Compared;
use crate::phases::Phases;
use crate::tr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::TraceError;
use voxtrace::output::ToneMap;
use voxtrace_vulkan::{Device, Options, Vulkan};
use winit::window::Window;

/// A window that is open.
pub struct Graphics {
    // Dropped first: before the window.
    screen: Screen,
    pub egui: egui_winit::State,
    pub window: Arc<Window>,
    /// When the panels want to be drawn again by themselves.
    pub repaint_at: Option<Instant>,
}

/// Panels that have run.
pub struct PanelFrame {
    panels: Panels,
    pub pixels_per_point: f32,
}

impl Graphics {
    /// Opens the device for a window: the one that is asked for, else the one that was chosen in windows before, else the best that can show pictures in
    /// it, software last. `tell` is called on the thread that draws. Returns also why the one that was chosen before is not it.
    pub fn new(
        window: Arc<Window>,
        (asked, kept): (Option<&str>, Option<&str>),
        validation: bool,
        tell: impl Fn(Drawing) + Send + 'static,
    ) -> Result<(Self, Option<String>), ViewerError> {
        let names = surface_extensions(&window).map_err(|error| ViewerError::Window(error.to_string()))?;
        // SAFETY: the names are constants of the loader's headers.
        let surface_extensions = names.iter().map(|&name| unsafe { std::ffi::CStr::from_ptr(name) }).collect();
        let options = Options::for_window(validation, surface_extensions);
        let vulkan = Vulkan::open(options)?;
        let surface = Surface::new(&vulkan, &window)?;
        let (device, refused) = open_device(&vulkan, &surface, asked, kept)?;
        let context = egui::Context::default();
        context.options_mut(|options| options.zoom_with_keyboard = false);
        let scale = window.scale_factor() as f32;
        let egui =
            egui_winit::State::new(context, egui::ViewportId::ROOT, &window, Some(scale), window.theme(), Some(8192));
        let (of_surface, shown) = (Arc::clone(&window), Arc::clone(&window));
        let make_surface = move |vulkan: &Arc<Vulkan>| Surface::new(vulkan, &of_surface);
        let about_to_show = move || shown.pre_present_notify();
        let screen = Screen::new(&device, surface, size_of(&window), make_surface, about_to_show, tell)?;
        Ok((Self { screen, egui, window, repaint_at: None }, refused))
    }

    /// Opens another device, by its number or a part of its name. Whether it can show pictures in this window, [`Self::move_to`] says.
    pub fn open_other(&self, wanted: &str) -> Result<Arc<Device>, TraceError> {
        Device::open_on(self.device().vulkan(), Some(wanted), None)
    }

    pub fn device(&self) -> &Arc<Device> {
        self.screen.device()
    }

    /// Draws with another device, or the same one, opened anew.
    pub fn move_to(&mut self, device: &Arc<Device>) -> Result<(), DrawError> {
        self.screen.move_to(device)
    }

    pub fn resize(&mut self, size: (u32, u32)) {
        self.screen.resize(size);
    }

    /// Whether a frame can be drawn now. Where not, one is asked for as soon as it can.
    pub fn is_ready(&mut self) -> bool {
        let is_ready = self.screen.is_ready();
        if !is_ready {
            // The thread that draws says when; asking again and again would take a core.
            self.repaint_at = None;
        }
        is_ready
    }

    /// Takes what the drawing thread tells. Returns a device that is lost.
    ///
    /// # Errors
    /// [`DrawError`] where a frame failed, and the next one may do.
    pub fn take(&mut self, drawing: Drawing) -> Result<Option<Arc<Device>>, DrawError> {
        match self.screen.take(drawing)? {
            Next::Nothing => {}
            Next::Draw => {
                let (width, height) = size_of(&self.window);
                if width > 0 && height > 0 {
                    self.window.request_redraw();
                }
            }
            Next::Reopen(device) => return Ok(Some(device)),
        }
        Ok(None)
    }

    /// What frames were spent on.
    pub fn phases(&self) -> Phases {
        self.screen.phases()
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
        let panels = Panels { textures: output.textures_delta, primitives, pixels_per_point };
        PanelFrame { panels, pixels_per_point }
    }

    /// Hands over a frame: the picture in the upper left `width` × `height` pixels, and the panels.
    pub fn draw(
        &mut self,
        frame: PanelFrame,
        shown: Option<&Shown>,
        compared: Option<Compared>,
        (width, height): (u32, u32),
        tone_map: ToneMap,
    ) {
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
        self.screen.draw(layer, frame.panels);
    }
}

fn size_of(window: &Window) -> (u32, u32) {
    let size = window.inner_size();
    (size.width, size.height)
}

/// Returns also why the device that was kept is not it.
fn open_device(
    vulkan: &Arc<Vulkan>,
    surface: &Surface,
    asked: Option<&str>,
    kept: Option<&str>,
) -> Result<(Arc<Device>, Option<String>), ViewerError> {
    if let Some(asked) = asked {
        return Ok((suiting(vulkan, surface, asked)?, None));
    }
    // One that was kept may be gone, or have another name with another driver: that keeps no window from opening.
    let refused = match kept.map(|kept| (kept, suiting(vulkan, surface, kept))) {
        Some((_, Ok(device))) => return Ok((device, None)),
        Some((kept, Err(error))) => Some(tr!("said.cannot_be_taken", name = kept, error = error)),
        None => None,
    };
    if let Ok(device) = Device::open_on(vulkan, None, None)
        && surface.suits(&device)
    {
        return Ok((device, refused));
    }
    // Whatever there is, software too.
    let numbers = 0..voxtrace_vulkan::devices(Options::default())?.len();
    let found = numbers
        .filter_map(|number| Device::open_on(vulkan, Some(&number.to_string()), None).ok())
        .find(|device| surface.suits(device));
    let found =
        found.ok_or_else(|| TraceError::Unsupported("no Vulkan device can show pictures in this window".into()));
    Ok((found?, refused))
}

/// The device of this name, where it can show pictures in the surface.
fn suiting(vulkan: &Arc<Vulkan>, surface: &Surface, wanted: &str) -> Result<Arc<Device>, TraceError> {
    let device = Device::open_on(vulkan, Some(wanted), None)?;
    if surface.suits(&device) {
        return Ok(device);
    }
    Err(TraceError::Unsupported(format!("{} cannot show pictures in this window", device.info().name)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ash::{ext, khr};
    use voxtrace_test_support::{Need, skip_without};

    #[test]
    fn a_device_that_was_kept_and_is_gone_keeps_no_window_from_opening() {
        let options = Options::for_window(false, vec![khr::surface::NAME, ext::headless_surface::NAME]);
        let vulkan = match Vulkan::open(options) {
            Ok(vulkan) => vulkan,
            Err(error) => return skip_without(Need::Vulkan, &error.to_string()),
        };
        let surface = Surface::headless(&vulkan).unwrap();
        let usual = match open_device(&vulkan, &surface, None, None) {
            Ok((usual, None)) => usual,
            Ok((_, Some(refused))) => panic!("{refused}"),
            Err(error) => return skip_without(Need::Vulkan, &error.to_string()),
        };
        let gone = Some("a card that was sold");
        let (device, refused) = open_device(&vulkan, &surface, None, gone).unwrap();
        assert_eq!(device.info().index, usual.info().index);
        assert!(refused.unwrap().contains("a card that was sold"));
        assert!(open_device(&vulkan, &surface, gone, None).is_err(), "what was asked for is taken or nothing");
        let kept = usual.info().index.to_string();
        let (device, refused) = open_device(&vulkan, &surface, None, Some(&kept)).unwrap();
        assert_eq!((device.info().index, refused), (usual.info().index, None));
    }
}
