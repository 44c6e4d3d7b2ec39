//! What the window does when the driver fails it: the device is lost, the surface is lost, images do not suit any more, memory is
//! short. It goes on, and its film is that of a render, bit for bit.

use crate::common::headless::{Headless, until};
use crate::common::{packed, rendered};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;
use voxtrace::glam::Vec3;
use voxtrace::lines::Lines;
use voxtrace::output::ToneMap;
use voxtrace::{BounceLimits, Camera, Film, Integrator};
use voxtrace_viewer::engine::{Backend, View};
use voxtrace_viewer::gpu::{Layer, Panels};
use voxtrace_vulkan::{Fault, Primitive, Settings, Traversal};

const SAMPLES: u32 = 6;

fn view(width: u32, height: u32) -> View {
    View {
        camera: Camera::look_at(Vec3::new(50.0, -20.0, 24.0), Vec3::new(12.0, 12.0, 2.0)),
        width,
        height,
        samples: SAMPLES,
        integrator: Integrator::Path,
        max_bounces: 4,
        bounce_limits: BounceLimits::default(),
        clamp_indirect: f32::INFINITY,
        clear_shadows: false,
        lines: Lines::default(),
        seed: 5,
    }
}

pub fn backends() -> [Backend; 2] {
    [
        Backend::Cpu,
        Backend::Device(Settings { traversal: Traversal::Walk, primitive: Primitive::Brick, is_exact: true }),
    ]
}

/// A window of one view, with or without something in its panels.
pub struct Shop {
    pub window: Headless,
    pub view: View,
    context: egui::Context,
    has_panels: bool,
}

impl Shop {
    pub fn open(backend: Backend) -> Option<Self> {
        let view = view(96, 64);
        let window = Headless::open(backend, (view.width, view.height))?;
        window.engine.set_scene(Some(packed()));
        window.engine.set_view(view.clone(), false);
        Some(Self { window, view, context: egui::Context::default(), has_panels: true })
    }

    /// Draws what there is, and takes what was told.
    pub fn turn(&mut self) {
        let shown = self.window.engine.shown();
        let size = [self.view.width as f32, self.view.height as f32];
        let layer = shown.map(|shown| Layer {
            picture: Arc::clone(&shown.picture),
            corner: [0.0; 2],
            size,
            tone_map: ToneMap::default(),
            beside: None,
        });
        let (context, has_panels) = (&self.context, self.has_panels);
        self.window.draw(layer, || {
            let output = context.run_ui(egui::RawInput::default(), |ui| {
                if has_panels {
                    ui.label("something to read");
                }
            });
            let primitives = context.tessellate(output.shapes, output.pixels_per_point);
            Panels { textures: output.textures_delta, primitives, pixels_per_point: output.pixels_per_point }
        });
        self.window.pump(Duration::from_millis(20));
    }

    pub fn resize(&mut self, width: u32, height: u32) {
        self.view = View { width, height, ..self.view.clone() };
        self.window.screen.resize((width, height));
        self.window.engine.set_view(self.view.clone(), false);
        self.window.is_due = true;
    }

    /// Goes on until `frames` more frames were shown.
    pub fn show(&mut self, frames: u64) {
        let wanted = self.window.shown + frames;
        until("a frame", || {
            self.window.is_due = true;
            self.turn();
            self.window.shown >= wanted
        });
    }

    /// The film once it has all samples.
    pub fn film(&mut self) -> Film {
        let frame = self.view.frame();
        let mut answer = self.window.engine.film();
        let mut film = None;
        until("the film", || {
            self.turn();
            match answer.try_recv() {
                Ok(Some((of, whole))) if of == frame => film = Some(whole),
                Ok(_) => answer = self.window.engine.film(),
                Err(_) => {}
            }
            film.is_some()
        });
        film.unwrap()
    }
}

#[test]
fn the_film_stays_that_of_a_render_when_the_device_or_the_surface_is_lost() {
    let (device, surface, stale) = (Fault::DeviceLost, Fault::SurfaceLost, Fault::OutOfDate);
    let faults = [
        ("vkQueueSubmit", device),
        ("vkWaitSemaphores", device),
        ("vkWaitForFences", device),
        ("vkQueuePresentKHR", device),
        ("vkAcquireNextImageKHR", device),
        ("vkQueuePresentKHR", surface),
        ("vkAcquireNextImageKHR", surface),
        ("vkQueuePresentKHR", stale),
        ("vkAcquireNextImageKHR", stale),
        ("vkQueueSubmit", Fault::OutOfDeviceMemory),
    ];
    let expected = rendered(&packed(), &view(96, 64).frame());
    let expected_small = rendered(&packed(), &view(50, 40).frame());
    assert_ne!(
        rendered(&packed(), &view(96, 64).frame().samples(SAMPLES - 1)),
        expected,
        "the comparison sees samples"
    );
    for backend in backends() {
        for (index, (function, fault)) in faults.into_iter().enumerate() {
            let at = format!("{backend:?}, {function} answers {fault:?}");
            let Some(mut shop) = Shop::open(backend) else { return };
            shop.show(1);
            // Now with a film that is done, now amidst of it; now with panels, now without.
            if index % 2 == 0 {
                assert_eq!(shop.film(), expected, "{at}: before");
            }
            shop.has_panels = index % 3 != 0;
            shop.window.faults.plant(function, fault);
            // Functions that the processor's films never call are called by drawing.
            until("the fault", || {
                shop.window.is_due = true;
                if function == "vkWaitSemaphores" && backend == Backend::Cpu {
                    return shop.window.faults.clear() == 1;
                }
                shop.turn();
                !shop.window.faults.fired().is_empty() || {
                    // A film that is done submits nothing: begin another.
                    let seed = shop.view.seed ^ 1;
                    shop.view.seed = seed;
                    shop.window.engine.set_view(shop.view.clone(), false);
                    false
                }
            });
            shop.view.seed = 5;
            shop.window.engine.set_view(shop.view.clone(), false);
            shop.show(2);
            assert_eq!(shop.film(), expected, "{at}");
            shop.resize(50, 40);
            assert_eq!(shop.film(), expected_small, "{at}, then another size");
            shop.show(1);
            assert_eq!(shop.window.messages(), Vec::<String>::new(), "{at}");
            // Who had it last may be a thread that is about to let go.
            until(&format!("{at}: a device that was lost is let go of, which"), || {
                shop.turn();
                shop.window.devices() == 1
            });
            if fault == device && !shop.window.faults.fired().is_empty() {
                assert!(shop.window.moves > 0, "{at}: the device was opened anew");
            }
        }
    }
}

#[test]
fn a_device_that_hangs_is_left_and_the_film_stays_that_of_a_render() {
    let expected = rendered(&packed(), &view(96, 64).frame());
    for backend in backends() {
        for function in ["vkWaitForFences", "vkWaitSemaphores"] {
            // Films of the processor wait for no semaphore.
            if function == "vkWaitSemaphores" && backend == Backend::Cpu {
                continue;
            }
            let at = format!("{backend:?}, {function}");
            let Some(mut shop) = Shop::open(backend) else { return };
            shop.show(1);
            let hung = Arc::clone(shop.window.screen.device());
            shop.window.faults.plant(function, Fault::Hang);
            until("another device", || {
                shop.window.is_due = true;
                shop.turn();
                // A film that is done submits nothing: begin another.
                shop.view.seed ^= 1;
                shop.window.engine.set_view(shop.view.clone(), false);
                shop.window.moves > 0
            });
            assert!(hung.is_given_up(), "{at}");
            shop.view.seed = 5;
            shop.window.engine.set_view(shop.view.clone(), false);
            shop.show(2);
            assert_eq!(shop.film(), expected, "{at}");
            assert!(!shop.window.screen.device().is_given_up(), "{at}");
            assert_eq!(shop.window.messages(), Vec::<String>::new(), "{at}");
        }
    }
}

#[test]
fn a_surface_that_cannot_be_made_again_is_tried_until_it_can() {
    let Some(mut shop) = Shop::open(Backend::Cpu) else { return };
    let expected = shop.film();
    let lose = |shop: &mut Shop, refused: usize| {
        let before = shop.window.faults.fired().len();
        shop.window.failures.clear();
        shop.window.refused_surfaces.store(refused as u32, Ordering::Relaxed);
        shop.window.faults.plant("vkQueuePresentKHR", Fault::SurfaceLost);
        until("the loss", || {
            shop.window.is_due = true;
            shop.turn();
            shop.window.faults.fired().len() > before && shop.window.failures.len() >= refused
        });
    };
    lose(&mut shop, 2);
    assert_eq!(shop.window.failures, ["a surface is refused"; 2]);
    // Frames reach the new surface: it can be lost, too.
    lose(&mut shop, 0);
    shop.show(2);
    assert_eq!(shop.film(), expected);
    assert_eq!((shop.window.messages(), shop.window.failures.len()), (Vec::new(), 0));
}

#[test]
fn a_device_that_is_lost_while_nothing_is_traced_shows_the_same_film_again() {
    for backend in backends() {
        let Some(mut shop) = Shop::open(backend) else { return };
        let expected = shop.film();
        shop.window.faults.plant("vkQueuePresentKHR", Fault::DeviceLost);
        until("the loss", || {
            shop.window.is_due = true;
            shop.turn();
            shop.window.moves == 1
        });
        // The picture comes back although no sample is missing, or the samples are traced again.
        assert_eq!(shop.film(), expected, "{backend:?}");
        shop.show(2);
        assert_eq!(shop.window.messages(), Vec::<String>::new());
    }
}

#[test]
fn a_device_without_memory_leaves_tracing_to_the_processor_and_says_so() {
    let Some(mut shop) = Shop::open(Backend::Cpu) else { return };
    let expected = shop.film();
    shop.window.faults.plant("vkCreateDescriptorSetLayout", Fault::OutOfDeviceMemory);
    shop.window.engine.set_backend(backends()[1]);
    until("the notice", || {
        shop.turn();
        shop.window.notices.iter().any(|notice| notice.contains("the processor traces instead"))
    });
    assert_eq!(shop.film(), expected);
    // Asked for again, the device has memory again.
    shop.window.notices.clear();
    shop.window.engine.set_backend(backends()[1]);
    assert_eq!(shop.film(), expected);
    assert!(shop.window.engine.shown().is_some_and(|shown| shown.device.is_some()));
    assert_eq!((shop.window.messages(), shop.window.notices), (Vec::new(), Vec::new()));
}
