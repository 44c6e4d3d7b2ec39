//! How long frames take while the camera moves, in real-time light, and how soon a view that stands has gone over to its film: the thread of the
//! window traces, and its pictures are drawn with panels beside them, into an image.

use super::window::Window;
use crate::engine::{Backend, Engine, Event, Light, Quality, RealTimeChoice, Shown, View};
use crate::gpu::DrawError;
use crate::render_command::usual_bounces;
use std::f32::consts::TAU;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};
use voxtrace::glam::Quat;
use voxtrace::lines::Lines;
use voxtrace::{BounceLimits, Camera, Frame, Integrator, PackedScene, TraceError};
use voxtrace_vulkan::{Device, Settings};

/// Frames before those that are measured.
const WARM_UP: u32 = 20;
/// Samples after which a view that stands is looked at.
const SAMPLES: [u32; 4] = [1, 16, 64, 256];
/// A picture comes within this time, or never.
const PATIENCE: Duration = Duration::from_secs(120);

/// What frames of a camera that moves took.
#[derive(Clone, Debug, Default)]
pub struct Moving {
    /// Milliseconds from one picture to the next, by the host's clock, panels and drawing included.
    pub wall_ms: Vec<f64>,
    /// Those of all passes of a frame, by the device's clock.
    pub gpu_ms: Vec<f64>,
    /// Those of each pass, in their order.
    pub passes: Vec<(&'static str, Vec<f64>)>,
    /// Frames of each quality: pixels of the window along each side of a pixel, and whether half of the pixels have a path.
    pub qualities: Vec<(Quality, u32)>,
    /// Bytes on the device beyond the scene.
    pub bytes: u64,
    /// Samples of the film of a view that stands, and the milliseconds after which it had them.
    pub film: Vec<(u32, f64)>,
}

/// The camera at a share of its way: around what it looks at and back, nearer and back.
fn on_its_way(camera: &Camera, share: f32) -> Camera {
    let turn = Quat::from_rotation_z(0.35 * (TAU * share).sin());
    let nearer = 1.0 - 0.15 * (0.5 * TAU * share).sin();
    let eye = camera.target + turn * (camera.eye - camera.target) * nearer;
    Camera { eye, up: turn * camera.up, ..camera.clone() }
}

/// Moves the camera of a scene along its way, in so many pictures of 1920 × 1080 pixels, and lets it stand then.
///
/// # Errors
/// What the driver answers, or [`TraceError`] of the tracer.
pub fn moving(
    device: &Arc<Device>,
    settings: Settings,
    scene: &Arc<PackedScene>,
    (width, height): (u32, u32),
    frames: u32,
) -> Result<Moving, DrawError> {
    let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.overview(width as f32 / height as f32));
    let frame = Frame::new(camera.clone(), width, height);
    let mut window = Window::new(device, settings, scene, &frame, true)?;
    let mut target = window.target(device)?;
    let (sender, events) = channel();
    let engine = Engine::start(Arc::clone(device), Backend::Device(settings), move |event| {
        // Whoever listens may be gone.
        let _ = sender.send(event);
    });
    engine.set_light(Light { real_time: RealTimeChoice::On, is_bare: false });
    engine.set_scene(Some(Arc::clone(scene)));
    let mut taken = Moving::default();
    let mut last = Instant::now();
    for index in 0..WARM_UP + frames {
        let share = index.saturating_sub(WARM_UP) as f32 / frames.max(1) as f32;
        engine.set_view(view(on_its_way(&camera, share), width, height), true);
        let shown = next(&engine, &events)?;
        if index >= WARM_UP {
            taken.take(&shown, last.elapsed());
        }
        last = Instant::now();
        let (layer, panels) = window.frame(shown);
        target.submit(Some(&layer), panels)?;
    }
    let start = Instant::now();
    engine.set_view(view(camera, width, height), false);
    for samples in SAMPLES {
        loop {
            let shown = next(&engine, &events)?;
            let done = shown.samples;
            let (layer, panels) = window.frame(shown);
            target.submit(Some(&layer), panels)?;
            if done >= samples {
                taken.film.push((done, start.elapsed().as_secs_f64() * 1e3));
                break;
            }
        }
    }
    Ok(taken)
}

impl Moving {
    fn take(&mut self, shown: &Shown, since: Duration) {
        self.wall_ms.push(since.as_secs_f64() * 1e3);
        let Some(lit) = &shown.lit else { return };
        self.gpu_ms.push(lit.frame.gpu_ms);
        for (name, ms) in lit.passes() {
            match self.passes.iter_mut().find(|(known, _)| *known == name) {
                Some((_, times)) => times.push(ms),
                None => self.passes.push((name, vec![ms])),
            }
        }
        self.bytes = self.bytes.max(lit.frame.bytes);
        match self.qualities.iter_mut().find(|(quality, _)| *quality == lit.quality) {
            Some((_, count)) => *count += 1,
            None => self.qualities.push((lit.quality, 1)),
        }
    }
}

fn view(camera: Camera, width: u32, height: u32) -> View {
    View {
        camera,
        width,
        height,
        samples: 4096,
        integrator: Integrator::Path,
        max_bounces: usual_bounces(Integrator::Path),
        bounce_limits: BounceLimits::default(),
        clamp_indirect: f32::INFINITY,
        clear_shadows: false,
        lines: Lines::default(),
        seed: 0,
    }
}

/// The next picture.
fn next(engine: &Engine, events: &Receiver<Event>) -> Result<Shown, TraceError> {
    loop {
        match events.recv_timeout(PATIENCE) {
            Ok(Event::Picture) => {
                // Of several that came, the last.
                for event in events.try_iter() {
                    if let Event::Failed(error) | Event::Gone(error) = event {
                        return Err(error);
                    }
                }
                if let Some(shown) = engine.shown() {
                    return Ok(shown);
                }
            }
            Ok(Event::Failed(error) | Event::Gone(error)) => return Err(error),
            Ok(_) => {}
            Err(_) => return Err(TraceError::Unsupported("no picture came".into())),
        }
    }
}
