//! How long a frame takes on its way to the window, without a window: a sample a pixel is traced and resolved to a picture in one submit,
//! and drawn into an image in another, by two threads as in the window; beside it, tracing alone, as `voxtrace bench` measures it.

use crate::gpu::{DrawError, Layer, Offscreen, Panels};
use crate::render_command::usual_bounces;
use ash::{ext, khr};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, sync_channel};
use std::time::Instant;
use voxtrace::output::ToneMap;
use voxtrace::{Frame, Integrator, PackedScene, Progress, TraceError, Tracer};
use voxtrace_vulkan::{Device, Options, Picture, Settings, VulkanTracer};

/// Frames before those that are measured: pipelines are made, and the size of submits is found.
const WARM_UP: u32 = 20;
/// Pictures: two that are drawn, one at hand, one that waits, and one that is written.
const PICTURES: usize = 5;
/// Milliseconds of a submit in the window.
const SUBMIT_MS: f64 = 10.0;

/// Milliseconds of frames, in the order of their making.
#[derive(Clone, Debug, Default)]
pub struct Times {
    /// By the host's clock, from one frame to the next.
    pub wall_ms: Vec<f64>,
    /// Tracing, by the device's clock.
    pub trace_ms: Vec<f64>,
    /// Making the picture, by the device's clock.
    pub resolve_ms: Vec<f64>,
}

/// The middle and the 99th percentile of some times.
pub fn middle_and_most(times: &[f64]) -> (f64, f64) {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times.get(((times.len().max(1) - 1) as f64 * share).round() as usize).copied().unwrap_or(0.0);
    (at(0.5), at(0.99))
}

/// The frame that is measured: 1920 × 1080 pixels by `essay`, from the scene's first camera.
pub fn essay(scene: &PackedScene) -> Frame {
    let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.overview(16.0 / 9.0));
    let integrator = Integrator::Essay;
    Frame::new(camera, 1920, 1080).integrator(integrator).max_bounces(usual_bounces(integrator))
}

/// A device for frames that nobody sees: with a queue for pictures where a window would have one.
///
/// # Errors
/// [`TraceError::Unsupported`] where there is none.
pub fn open_device(wanted: Option<&str>) -> Result<Arc<Device>, TraceError> {
    let headless = Options::for_window(false, vec![khr::surface::NAME, ext::headless_surface::NAME]);
    Device::open(headless, wanted, None).or_else(|_| Device::open(Options::default(), wanted, None))
}

/// Traces `frames` frames of a sample a pixel and nothing else.
///
/// # Errors
/// [`TraceError`] of the tracer.
pub fn traced(
    device: &Arc<Device>,
    settings: Settings,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    frames: u32,
) -> Result<Times, TraceError> {
    let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
    tracer.set_scene(scene)?;
    let mut times = Times::default();
    for index in 0..WARM_UP + frames {
        let start = Instant::now();
        tracer.render(&frame.clone().samples(index + 1), &Progress::default())?;
        if index >= WARM_UP {
            times.wall_ms.push(start.elapsed().as_secs_f64() * 1e3);
            times.trace_ms.push(tracer.statistics().gpu_ms);
        }
    }
    Ok(times)
}

/// Traces, resolves and draws as many, each of them.
///
/// # Errors
/// What the driver answers, or [`TraceError`] of the tracer.
pub fn shown(
    device: &Arc<Device>,
    settings: Settings,
    scene: &Arc<PackedScene>,
    frame: &Frame,
    frames: u32,
) -> Result<Times, DrawError> {
    let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
    tracer.set_submit_ms(SUBMIT_MS);
    tracer.set_scene(scene)?;
    let mut target = Offscreen::new(device, frame.width, frame.height)?;
    let make = |_| Picture::new(device, frame.width, frame.height, false).map(Arc::new);
    let pictures = (0..PICTURES).map(make).collect::<Result<Vec<_>, _>>()?;
    std::thread::scope(|scope| {
        // One is drawn while the next one waits and another is made.
        let (sender, ready) = sync_channel(1);
        let drawing = scope.spawn(move || draw_all(&mut target, &ready));
        let mut times = Times::default();
        for index in 0..WARM_UP + frames {
            let start = Instant::now();
            let picture = free(&pictures);
            let frame = frame.clone().samples(index + 1);
            let resolve_ms = tracer.render_shown(&frame, &Progress::default(), &picture)?.unwrap_or_default();
            if sender.send(picture).is_err() {
                break;
            }
            if index >= WARM_UP {
                times.wall_ms.push(start.elapsed().as_secs_f64() * 1e3);
                times.trace_ms.push(tracer.statistics().gpu_ms);
                times.resolve_ms.push(resolve_ms);
            }
        }
        drop(sender);
        match drawing.join() {
            Ok(drawn) => drawn.map(|()| times),
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

/// A picture that no frame in flight reads. There is one soon: there are more pictures than frames on their way.
fn free(pictures: &[Arc<Picture>]) -> Arc<Picture> {
    loop {
        if let Some(picture) = pictures.iter().find(|picture| Arc::strong_count(picture) == 1) {
            return Arc::clone(picture);
        }
        std::thread::yield_now();
    }
}

fn draw_all(target: &mut Offscreen, ready: &Receiver<Arc<Picture>>) -> Result<(), DrawError> {
    while let Ok(picture) = ready.recv() {
        let (width, height) = picture.size();
        let size = [width as f32, height as f32];
        let layer = Layer { picture, corner: [0.0; 2], size, tone_map: ToneMap::default(), beside: None };
        let panels = Panels { textures: egui::TexturesDelta::default(), primitives: Vec::new(), pixels_per_point: 1.0 };
        target.submit(Some(&layer), panels)?;
    }
    Ok(())
}
