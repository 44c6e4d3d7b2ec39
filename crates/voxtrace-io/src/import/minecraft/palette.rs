//! The materials of a build: each look once.

use super::blocks::Look;
use rustc_hash::FxHashMap;
use voxtrace_scene::material::{MAX_MATERIALS, Material};

/// Looks that are kept as they are; colours of those that come after them are rounded to five bits a channel.
const EXACT: usize = 32_767;

pub(super) struct Palette {
    /// Voxels along an edge of a block.
    edge: f32,
    materials: Vec<Material>,
    by_look: FxHashMap<Look, u16>,
}

impl Palette {
    pub fn new(edge: usize) -> Self {
        Self { edge: edge as f32, materials: Vec::new(), by_look: FxHashMap::default() }
    }

    /// The material of a look.
    pub fn material(&mut self, look: Look) -> u16 {
        if let Some(&material) = self.by_look.get(&look) {
            return material;
        }
        let look = if self.materials.len() < EXACT { look } else { Look { color: rounded(look.color), ..look } };
        if let Some(&material) = self.by_look.get(&look) {
            return material;
        }
        let next = self.materials.len();
        if next >= MAX_MATERIALS {
            // Rounded colours of five bits glow in few ways; what still comes after them takes the last look.
            return (next - 1) as u16;
        }
        self.materials.push(look.material(self.edge));
        self.by_look.insert(look, next as u16);
        next as u16
    }

    pub fn finish(self) -> Vec<Material> {
        self.materials
    }
}

fn rounded(color: u32) -> u32 {
    (color & 0xf8_f8_f8) | (color >> 5 & 0x07_07_07)
}

#[cfg(test)]
mod tests {
    use super::super::blocks::Kind;
    use super::*;

    #[test]
    fn water_is_as_clear_whatever_its_blocks_are_made_of() {
        let material = |edge| {
            let mut palette = Palette::new(edge);
            palette.material(Look { color: 0x3f5fd0, kind: Kind::Water, light: 0 });
            palette.finish()[0]
        };
        // Sixteen voxels take as much of the light as one did.
        let (one, sixteen) = (material(1).absorption, material(16).absorption);
        assert!((one - sixteen * 16.0).abs().max_element() < 1e-5 && one.max_element() > 0.0, "{one} {sixteen}");
    }

    #[test]
    fn looks_are_shared_and_more_than_there_is_room_for_are_near_others() {
        let mut palette = Palette::new(1);
        let mut material = |color: u32, light: u8| palette.material(Look { color, kind: Kind::Plain, light });
        assert_eq!([material(1, 0), material(2, 0), material(1, 0), material(1, 5)], [0, 1, 0, 2]);
        for color in 0..120_000 {
            material(color * 139, 0);
        }
        let materials = palette.finish();
        assert!(materials.len() > EXACT && materials.len() <= MAX_MATERIALS, "{}", materials.len());
    }
}
