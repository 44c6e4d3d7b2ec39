//! The textures of the panels on the host: a device that was opened anew gets them from here, since the panels send each of them
//! once.

use egui::epaint::ImageDelta;
use egui::{ColorImage, ImageData, TextureId, TextureOptions, TexturesDelta};
use std::collections::HashMap;
use std::sync::Arc;

/// All textures that the panels have.
#[derive(Default)]
pub struct Textures {
    images: HashMap<TextureId, (Arc<ColorImage>, TextureOptions)>,
}

impl Textures {
    /// Takes what changed.
    pub fn take(&mut self, delta: &TexturesDelta) {
        for (&id, changes) in &delta.set {
            for change in changes {
                let ImageData::Color(image) = &change.image;
                match change.pos {
                    None => {
                        self.images.insert(id, (Arc::clone(image), change.options));
                    }
                    Some(corner) => {
                        if let Some((whole, _)) = self.images.get_mut(&id) {
                            patch(Arc::make_mut(whole), corner, image);
                        }
                    }
                }
            }
        }
        for id in &delta.free {
            self.images.remove(id);
        }
    }

    /// All of them, as something that is new.
    pub fn all(&self) -> TexturesDelta {
        let mut delta = TexturesDelta::default();
        for (&id, (image, options)) in &self.images {
            delta.push(id, ImageDelta::full(Arc::clone(image), *options));
        }
        delta
    }
}

/// Writes a small image into a large one; what would lie outside is left out.
fn patch(whole: &mut ColorImage, [left, top]: [usize; 2], image: &ColorImage) {
    let [width, height] = whole.size;
    let columns = image.size[0].min(width.saturating_sub(left));
    for row in 0..image.size[1].min(height.saturating_sub(top)) {
        let from = &image.pixels[row * image.size[0]..][..columns];
        whole.pixels[(top + row) * width + left..][..columns].copy_from_slice(from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::Color32;

    #[test]
    fn what_was_sent_in_pieces_comes_back_whole() {
        let id = TextureId::Managed(0);
        let (grey, red) = (Color32::GRAY, Color32::RED);
        let mut textures = Textures::default();
        let mut delta = TexturesDelta::default();
        delta.push(id, ImageDelta::full(ColorImage::filled([4, 3], grey), TextureOptions::LINEAR));
        textures.take(&delta);
        let mut delta = TexturesDelta::default();
        delta.push(id, ImageDelta::partial([3, 1], ColorImage::filled([2, 2], red), TextureOptions::LINEAR));
        textures.take(&delta);
        let all = textures.all();
        let ImageData::Color(image) = &all.set[&id][0].image;
        let is_red: Vec<bool> = image.pixels.iter().map(|&pixel| pixel == red).collect();
        let (n, y) = (false, true);
        assert_eq!(is_red, [n, n, n, n, n, n, n, y, n, n, n, y]);
        assert!(all.set[&id][0].pos.is_none());

        let mut delta = TexturesDelta::default();
        delta.free(id);
        textures.take(&delta);
        assert!(textures.all().is_empty());
    }
}
