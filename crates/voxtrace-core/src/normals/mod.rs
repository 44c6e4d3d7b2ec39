//! Normals of voxels beside their faces: a smooth surface that was cut into voxels is shaded as the surface, not as its terraces.
//!
//! Each voxel of a scene that has them keeps one in a few bits ([`code`]), beside its material. They are estimated from which voxels there are
//! around it (`estimate`), so that every scene can have them, wherever it came from. Hits, shadows and what covers what stay those of the
//! faces; `shade` says where a normal counts. `docs/decisions/0110-smooth-normals.md`.

#[doc(hidden)]
pub mod code;
mod estimate;
mod shade;

pub(crate) use estimate::normals_of;

use crate::packed::{PackError, PackedScene};

/// Which normals the surfaces of a scene are shaded with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// Those of the faces of voxels: right for what is made of cubes.
    #[default]
    Faces,
    /// Those of the smooth surface that the voxels stand for.
    Smooth,
}

impl PackedScene {
    /// Whether its voxels have normals of their own.
    pub fn normals(&self) -> Normals {
        if self.geometry.has_normals() { Normals::Smooth } else { Normals::Faces }
    }

    /// The same scene with these normals: smooth ones are estimated anew from its voxels, those of merged instances together.
    ///
    /// # Errors
    /// [`PackError::TooLarge`] where the scene has no room for them.
    pub fn with_normals(&self, normals: Normals) -> Result<Self, PackError> {
        if normals == Normals::Faces && !self.geometry.has_normals() {
            return Ok(self.clone());
        }
        if self.geometry.is_edited {
            return self.compacted().with_normals(normals);
        }
        let geometry = match normals {
            Normals::Faces => self.geometry.without_normals(),
            Normals::Smooth => self.geometry.with_smooth_normals(),
        }?;
        Ok(Self { geometry: geometry.into(), ..self.clone() })
    }
}
