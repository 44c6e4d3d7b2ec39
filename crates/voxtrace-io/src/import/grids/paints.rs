//! Colours of voxels as materials: each colour is one, as long as there is room.

use rustc_hash::FxHashMap;
use voxtrace_scene::material::{Material, linear_color};

/// Colours that are kept as they are; what comes after them is rounded to five bits a channel, of which as many again fit.
const EXACT: usize = 32_767;

#[derive(Default)]
pub(crate) struct Paints {
    materials: Vec<Material>,
    indices: FxHashMap<[u8; 3], u16>,
}

impl Paints {
    /// The material of an sRGB colour.
    pub fn material(&mut self, color: [u8; 3]) -> u16 {
        if let Some(&index) = self.indices.get(&color) {
            return index;
        }
        let rounded = if self.is_full() { color.map(nearest_level) } else { color };
        if let Some(&index) = self.indices.get(&rounded) {
            return index;
        }
        let index = self.materials.len() as u16;
        self.materials.push(Material::diffuse(linear_color(rounded)));
        self.indices.insert(rounded, index);
        index
    }

    /// Whether further colours are rounded.
    pub fn is_full(&self) -> bool {
        self.materials.len() >= EXACT
    }

    pub fn finish(self) -> Vec<Material> {
        self.materials
    }
}

/// The nearest of 32 levels of a channel.
fn nearest_level(channel: u8) -> u8 {
    let level = (u32::from(channel) * 31 + 127) / 255;
    ((level * 255 + 15) / 31) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::material::MAX_MATERIALS;

    #[test]
    fn every_colour_there_is_finds_a_material_near_it() {
        let mut paints = Paints::default();
        assert_eq!((paints.material([1, 2, 3]), paints.material([9, 9, 9]), paints.material([1, 2, 3])), (0, 1, 0));
        let mut worst = 0.0f32;
        for red in 0..=255 {
            for green in 0..=255 {
                for blue in (0..=255).step_by(5) {
                    let index = usize::from(paints.material([red, green, blue]));
                    let error = paints.materials[index].base_color - linear_color([red, green, blue]);
                    worst = worst.max(error.abs().max_element());
                }
            }
        }
        // The fifth bit is worth 8 of 255; half of it, at white, where a step of sRGB is worth 2.3 linear ones, is 0.036.
        assert!(worst < 0.04 && paints.materials.len() <= MAX_MATERIALS, "{worst}");
    }
}
