//! Materials that come while a scene is edited. Palettes of bricks have a byte for each entry until there are more than 256 materials; then every brick
//! is encoded anew, as packing would.

use super::emitters::Glow;
use super::plan::code_of;
use super::store::BrickCode;
use super::{DynamicScene, EditError};
use crate::packed::PackedMaterial;
use glam::IVec3;
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::material::{MAX_MATERIALS, Material};

/// Materials that entries of a byte can name.
const BYTE: usize = 256;

/// A brick that is encoded anew: the position of its record, the words of its record and of its materials, and its new words.
type Widened = (usize, usize, usize, BrickCode);

impl DynamicScene {
    /// Adds a material, for edits from now on. Returns its index. Materials stay where edits that used them are undone. The 257th one takes as long as
    /// packing, and ends the history.
    ///
    /// # Errors
    /// [`EditError::TooManyMaterials`] beyond [`MAX_MATERIALS`]; [`EditError::Full`] where the arrays have no room for longer names of materials.
    pub fn add_material(&mut self, material: &Material) -> Result<u16, EditError> {
        let count = self.geometry().materials.len();
        if count >= MAX_MATERIALS {
            return Err(EditError::TooManyMaterials);
        }
        if count >= BYTE {
            self.widen()?;
        }
        let geometry = Arc::make_mut(&mut self.scene.geometry);
        geometry.materials.set_length(count + 1);
        geometry.materials.as_mut()[count] = PackedMaterial::from(material);
        geometry.is_edited = true;
        self.glow = Glow::of(&geometry.materials);
        self.dirty.palette.mark(count, 1);
        Ok(count as u16)
    }

    /// Makes entries of palettes 16 bits long.
    fn widen(&mut self) -> Result<(), EditError> {
        let grids: Vec<usize> =
            (0..self.bricks.len()).filter(|&grid| self.geometry().grids[grid].material_bits < 16).collect();
        let bricks: u64 = grids.iter().map(|&grid| self.bricks[grid]).sum();
        // A palette of 512 entries, or as many voxels.
        if self.geometry().brick_materials.len() as u64 + 256 * bricks >= 1 << 31 {
            return Err(EditError::Full);
        }
        for grid in grids {
            let codes = self.widened(grid);
            self.history.clear();
            self.epoch = if self.epoch == u16::MAX { 1 } else { self.epoch + 1 };
            let epoch = self.epoch;
            let mut store = self.store();
            store.geometry.grids.as_mut()[grid].material_bits = 16;
            for (record, words, materials, code) in &codes {
                let now = store.put_brick(Some((*record, *words, *materials)), code, epoch);
                debug_assert_eq!(now, *record, "the voxels are the same");
            }
            let (geometry, packed) = (self.geometry(), &self.geometry().grids[grid]);
            let origin = packed.origin >> 3;
            let all: Vec<IVec3> = geometry.bricks_of(packed).iter().map(|at| *at + origin).collect();
            self.changed_bricks.extend(all.into_iter().map(|at| ((grid as u32, at), ())));
        }
        Ok(())
    }

    fn widened(&self, grid: usize) -> Vec<Widened> {
        let (geometry, packed) = (self.geometry(), &self.geometry().grids[grid]);
        let widened = |at: &IVec3| {
            let record = geometry.find_brick(packed, packed.origin + *at * BRICK_SIZE)?;
            let code = code_of(&geometry.decode_brick(packed, record), 16)?;
            let length = geometry.material_words(packed, record, geometry.voxels_of(record));
            Some((record, code.record.len(), length, code))
        };
        geometry.bricks_of(packed).par_iter().filter_map(widened).collect()
    }
}
