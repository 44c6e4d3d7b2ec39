//! The window of the benchmark of frames: its panels, as wide as they are in a window, beside a picture of the size that is traced, and
//! the image that both are drawn into.

use crate::engine::Shown;
use crate::gpu::{DrawError, Layer, Offscreen, Panels};
use crate::panels::{self, Status};
use crate::session::Session;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, SyncSender};
use std::time::Instant;
use voxtrace::output::ToneMap;
use voxtrace::{Frame, PackedScene};
use voxtrace_vulkan::{Device, Settings};

/// Frames that the panels take to find their size.
const LAYOUT: u32 = 3;
/// Points beside the picture while the panels find theirs.
const ROOM: f32 = 1000.0;

/// A window that nobody sees.
pub struct Window {
    context: egui::Context,
    session: Session,
    status: Status,
    /// Of the picture, pixels.
    size: [f32; 2],
    /// Of the panels beside it, pixels.
    side: f32,
    start: Instant,
    /// Textures of frames that were not drawn.
    textures: Vec<egui::TexturesDelta>,
}

impl Window {
    /// The window of a scene, with panels or without, a pixel a point.
    pub fn new(
        device: &Device,
        settings: Settings,
        scene: &Arc<PackedScene>,
        frame: &Frame,
        has_panels: bool,
    ) -> Result<Self, DrawError> {
        let mut session = Session::new(settings.traversal);
        session.resize(frame.width, frame.height);
        session.show(scene.name.clone(), Arc::clone(scene));
        session.has_panels = has_panels;
        let status = Status { device: device.info().name.clone(), ..Status::default() };
        let size = [frame.width as f32, frame.height as f32];
        let context = egui::Context::default();
        let (start, textures) = (Instant::now(), Vec::new());
        let mut window = Self { context, session, status, size, side: ROOM, start, textures };
        for _ in 0..LAYOUT {
            let (mut panels, side) = window.panels();
            window.textures.push(std::mem::take(&mut panels.textures));
            window.side = side.round();
        }
        Ok(window)
    }

    /// An image of its size, with the textures of the panels.
    pub fn target(&mut self, device: &Arc<Device>) -> Result<Offscreen, DrawError> {
        let mut target = Offscreen::new(device, (self.size[0] + self.side) as u32, self.size[1] as u32)?;
        for textures in self.textures.drain(..) {
            let panels = Panels { textures, primitives: Vec::new(), pixels_per_point: 1.0 };
            target.submit(None, panels)?;
        }
        Ok(target)
    }

    /// Runs the panels, with a picture that is new, and hands the frame over. Returns how long they took, milliseconds; `None` where nobody draws
    /// any more.
    pub fn run(&mut self, shown: Shown, draw: &SyncSender<(Layer, Panels)>) -> Option<f64> {
        let start = Instant::now();
        let frame = self.frame(shown);
        let ms = start.elapsed().as_secs_f64() * 1e3;
        draw.send(frame).ok().map(|()| ms)
    }

    /// The frame of a picture that is new.
    pub fn frame(&mut self, shown: Shown) -> (Layer, Panels) {
        let picture = Arc::clone(&shown.picture);
        self.status.take(shown);
        let (panels, _) = self.panels();
        let layer = Layer { picture, corner: [0.0; 2], size: self.size, tone_map: ToneMap::default(), beside: None };
        (layer, panels)
    }

    /// Runs the panels. Returns also how wide they are.
    fn panels(&mut self) -> (Panels, f32) {
        let size = egui::vec2(self.size[0] + self.side, self.size[1]);
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            time: Some(self.start.elapsed().as_secs_f64()),
            ..egui::RawInput::default()
        };
        let (session, status) = (&mut self.session, &self.status);
        let mut side = 0.0;
        let output = self.context.run_ui(input, |ui| side = panels::show(ui, session, status));
        let pixels_per_point = output.pixels_per_point;
        let primitives = self.context.tessellate(output.shapes, pixels_per_point);
        (Panels { textures: output.textures_delta, primitives, pixels_per_point }, side)
    }
}

/// Draws each frame that comes, and tells how long the device took.
pub fn draw_all(
    target: &mut Offscreen,
    ready: &Receiver<(Layer, Panels)>,
    clock: &Sender<f64>,
) -> Result<(), DrawError> {
    while let Ok((layer, panels)) = ready.recv() {
        target.submit(Some(&layer), panels)?;
        if let Some(ms) = target.take_frame_ms() {
            // Whoever listens outlives this thread.
            let _ = clock.send(ms);
        }
    }
    Ok(())
}
