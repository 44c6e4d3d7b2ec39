//! How long a frame takes on its way to the window, without a window: a sample a pixel is traced and resolved to a picture in one submit,
//! the panels run, and both are drawn into an image in another submit, by three threads as in the window, which shows each picture; beside it,
//! tracing alone, as `voxtrace bench` measures it, and drawing alone.

mod moving;
mod window;

pub use moving::{Moving, moving};

use crate::engine::Shown;
use crate::gpu::DrawError;
use crate::render_command::usual_bounces;
use ash::{ext, khr};
use std::sync::Arc;
use std::sync::mpsc::{SyncSender, channel, sync_channel};
use std::time::Instant;
use voxtrace::{Frame, Integrator, PackedScene, Progress, TraceError, Tracer};
use voxtrace_vulkan::{Device, Options, Picture, Settings, VulkanTracer};
use window::Window;

/// Frames before those that are measured: pipelines are made, and the size of submits is found.
const WARM_UP: u32 = 20;
/// Pictures: two that are drawn, one at hand there, one that waits for it, one that the panels know, one that waits for them, and one that is written.
const PICTURES: usize = 7;
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
    /// Running the panels, by the host's clock.
    pub panels_ms: Vec<f64>,
    /// The curve, the picture and the panels, by the device's clock, beside whatever else it does.
    pub draw_ms: Vec<f64>,
}

impl Times {
    /// Leaves out the first frames of each.
    fn without_warm_up(mut self) -> Self {
        let all = [&mut self.wall_ms, &mut self.trace_ms, &mut self.resolve_ms, &mut self.panels_ms, &mut self.draw_ms];
        for times in all {
            times.drain(..times.len().min(WARM_UP as usize));
        }
        self
    }
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

/// A benchmark of frames of a scene, of a sample a pixel each.
#[derive(Clone, Copy)]
pub struct FrameBench<'a> {
    /// Where they are traced and drawn.
    pub device: &'a Arc<Device>,
    /// How they are traced.
    pub settings: Settings,
    /// What is traced.
    pub scene: &'a Arc<PackedScene>,
    /// What they are like.
    pub frame: &'a Frame,
    /// How many are measured.
    pub frames: u32,
}

impl FrameBench<'_> {
    /// Traces the frames and nothing else.
    ///
    /// # Errors
    /// [`TraceError`] of the tracer.
    pub fn traced(self) -> Result<Times, TraceError> {
        let mut tracer = VulkanTracer::new(Arc::clone(self.device), self.settings)?;
        tracer.set_scene(self.scene)?;
        let mut times = Times::default();
        for index in 0..WARM_UP + self.frames {
            let start = Instant::now();
            tracer.render(&self.frame.clone().samples(index + 1), &Progress::default())?;
            times.wall_ms.push(start.elapsed().as_secs_f64() * 1e3);
            times.trace_ms.push(tracer.statistics().gpu_ms);
        }
        Ok(times.without_warm_up())
    }

    /// Traces, resolves and draws as many, each of them, in a window with panels or without. Beside them the picture has the same size as without.
    ///
    /// # Errors
    /// What the driver answers, or [`TraceError`] of the tracer.
    pub fn shown(self, has_panels: bool) -> Result<Times, DrawError> {
        let mut window = self.window(has_panels)?;
        // A picture is drawn while the next one waits and another is made.
        let (pictures, to_panels) = sync_channel(1);
        let (to_draw, ready) = sync_channel(1);
        let (clock, draw_ms) = channel();
        std::thread::scope(|scope| {
            let tracing = scope.spawn(move || self.trace_all(WARM_UP + self.frames, &pictures));
            let mut target = window.target(self.device)?;
            let drawing = scope.spawn(move || window::draw_all(&mut target, &ready, &clock));
            let panels_ms: Vec<f64> = to_panels.iter().map_while(|shown| window.run(shown, &to_draw)).collect();
            // Each of the others ends with its channel.
            drop((to_panels, to_draw));
            let drawn = joined(drawing);
            let times = joined(tracing)?;
            drawn?;
            Ok(Times { panels_ms, draw_ms: draw_ms.try_iter().collect(), ..times }.without_warm_up())
        })
    }

    /// Draws a picture again and again, each time through another curve, so that it is made anew, and traces nothing meanwhile.
    ///
    /// # Errors
    /// What the driver answers, or [`TraceError`] of the tracer.
    pub fn drawn(self, has_panels: bool) -> Result<Times, DrawError> {
        let mut window = self.window(has_panels)?;
        let mut target = window.target(self.device)?;
        let (pictures, shown) = sync_channel(1);
        self.trace_all(1, &pictures)?;
        drop(pictures);
        let Some(shown) = shown.iter().last() else { return Ok(Times::default()) };
        let mut times = Times::default();
        for index in 0..WARM_UP + self.frames {
            let start = Instant::now();
            let (mut layer, panels) = window.frame(shown.clone());
            layer.tone_map.exposure = index as f32 * 1e-3;
            times.panels_ms.push(start.elapsed().as_secs_f64() * 1e3);
            target.submit(Some(&layer), panels)?;
            times.wall_ms.push(start.elapsed().as_secs_f64() * 1e3);
            times.draw_ms.extend(target.take_frame_ms());
        }
        Ok(times.without_warm_up())
    }

    fn window(self, has_panels: bool) -> Result<Window, DrawError> {
        Window::new(self.device, self.settings, self.scene, self.frame, has_panels)
    }

    /// Traces so many frames and resolves each, as the thread of the window does.
    fn trace_all(self, frames: u32, ready: &SyncSender<Shown>) -> Result<Times, DrawError> {
        let Self { device, settings, scene, frame, .. } = self;
        let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
        tracer.set_submit_ms(SUBMIT_MS);
        tracer.set_scene(scene)?;
        let make = |_| Picture::new(device, frame.width, frame.height, false).map(Arc::new);
        let pictures = (0..PICTURES).map(make).collect::<Result<Vec<_>, _>>()?;
        let mut times = Times::default();
        for index in 0..frames {
            let start = Instant::now();
            let picture = free(&pictures);
            let frame = frame.clone().samples(index + 1);
            let resolve_ms = tracer.render_shown(&frame, &Progress::default(), &picture)?.unwrap_or_default();
            let (statistics, memory) = (tracer.statistics(), tracer.memory());
            times.trace_ms.push(statistics.gpu_ms);
            times.resolve_ms.push(resolve_ms);
            let (samples, step_ms) = (frame.samples, statistics.gpu_ms);
            let shown = Shown {
                picture,
                samples,
                scale: 1,
                step_ms,
                step_samples: 1,
                device: Some((statistics, memory)),
                lit: None,
            };
            if ready.send(shown).is_err() {
                break;
            }
            times.wall_ms.push(start.elapsed().as_secs_f64() * 1e3);
        }
        Ok(times)
    }
}

fn joined<T>(thread: std::thread::ScopedJoinHandle<'_, T>) -> T {
    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
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
