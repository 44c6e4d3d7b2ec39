//! What a frame shows, and what it is drawn into.

use super::pipeline::Placement;
use ash::vk;
use std::sync::Arc;
use voxtrace::output::ToneMap;
use voxtrace_vulkan::Picture;

/// A picture and its place in the window.
pub struct Layer {
    /// What to draw.
    pub picture: Arc<Picture>,
    /// Upper left corner, pixels.
    pub corner: [f32; 2],
    /// Width and height, pixels.
    pub size: [f32; 2],
    /// Exposure and curve.
    pub tone_map: ToneMap,
    /// Another picture at the same corner, of which the part to the right is seen.
    pub beside: Option<Beside>,
}

impl Layer {
    /// Its pictures, each with its place.
    pub(super) fn placed(&self) -> impl Iterator<Item = (&Arc<Picture>, Placement)> {
        let placement = |size| Placement { corner: self.corner, size, tone_map: self.tone_map };
        let beside = self.beside.iter().map(move |beside| (&beside.picture, placement(beside.size)));
        std::iter::once((&self.picture, placement(self.size))).chain(beside)
    }
}

/// A picture that is compared with the one to its left.
pub struct Beside {
    /// What to draw.
    pub picture: Arc<Picture>,
    /// Width and height, pixels.
    pub size: [f32; 2],
    /// Where it begins, pixels from the left of the window.
    pub split: f32,
}

/// What egui wants drawn.
pub struct Panels {
    /// Textures that are new or changed, and those that are gone.
    pub textures: egui::TexturesDelta,
    /// The triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Pixels of a point.
    pub pixels_per_point: f32,
}

impl Drop for Panels {
    fn drop(&mut self) {
        // A frame that is left out is no fault: whoever draws keeps textures by itself.
        self.textures.clear();
    }
}

/// What a frame is drawn into.
pub struct Target {
    /// The image.
    pub image: vk::Image,
    /// It, for the passes of the painter.
    pub framebuffer: vk::Framebuffer,
    /// Its size, pixels.
    pub extent: vk::Extent2D,
    /// Whether it was made to be copied into, too.
    pub can_copy: bool,
}
