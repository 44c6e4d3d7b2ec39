//! Further objects in a packed scene, behind those that it has. Its arrays are copied; what emits stays what it was.

use super::pack::{PackError, pack_grid};
use super::{Geometry, Object, Outline, PackedInstance, PackedMaterial, PackedScene, Placement};
use std::sync::Arc;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::{MAX_MATERIALS, Material};
use voxtrace_scene::transform::Transform;

/// Objects of one material, which does not emit.
pub(crate) struct Addition<'a> {
    /// Their name.
    pub name: &'a str,
    /// Their material.
    pub material: Material,
    /// Grids that are not empty, whose voxels name material [`PackedScene::next_material`].
    pub grids: &'a [VoxelGrid],
    /// For each object the index of its grid, and where it stands.
    pub places: &'a [(usize, Transform)],
}

impl PackedScene {
    /// Number of the material of an addition.
    ///
    /// # Errors
    /// [`PackError::TooManyMaterials`] where there is none left.
    pub(crate) fn next_material(&self) -> Result<u16, PackError> {
        let count = self.materials().len();
        if count < MAX_MATERIALS { Ok(count as u16) } else { Err(PackError::TooManyMaterials(count + 1)) }
    }

    /// The same scene with further objects. They come last: where they lie within others, those count.
    ///
    /// # Errors
    /// [`PackError`] when the scene gets too large.
    pub(crate) fn with_addition(&self, addition: &Addition) -> Result<Self, PackError> {
        if self.geometry.is_edited {
            return self.compacted().with_addition(addition);
        }
        let own = &*self.geometry;
        let (mut cells, mut bricks) = (own.cells.to_vec(), own.bricks.to_vec());
        let (mut brick_materials, mut grids) = (own.brick_materials.to_vec(), own.grids.to_vec());
        let mut materials = own.materials.to_vec();
        materials.push(PackedMaterial::from(&addition.material));
        let material_bits = if materials.len() <= 256 { 8 } else { 16 };
        for grid in addition.grids {
            let part = pack_grid(grid, material_bits, &|| Ok(()))?;
            part.append(&mut cells, &mut bricks, &mut brick_materials, &mut grids)?;
        }
        // Those of the scene are known by their order: what is added was none of them.
        let mut scene_grids = own.scene_grids.to_vec();
        if let Some(last) = scene_grids.last().copied() {
            scene_grids.extend((1..=addition.grids.len() as u32).map(|further| last + further));
        }
        let geometry = Geometry {
            cells: cells.into(),
            bricks: bricks.into(),
            brick_materials: brick_materials.into(),
            grids: grids.into(),
            materials: materials.into(),
            scene_grids: scene_grids.into(),
            // What is added has none.
            has_coverage: false,
            ..own.clone()
        }
        .finished();
        let geometry = if own.has_normals { geometry.with_face_normals_from(own.grids.len())? } else { geometry };
        let mut outline = Outline::clone(&self.outline);
        let mut instances = self.placement.instances.to_vec();
        for (grid, place) in addition.places {
            let grid = (own.grids.len() + grid) as u32;
            instances.push(PackedInstance::new(grid, *place, outline.objects.len() as u32));
            outline.objects.push(Object { name: addition.name.into(), ..Object::default() });
        }
        let placement = Placement::of_sound(&geometry, instances);
        Ok(Self { geometry: Arc::new(geometry), placement, outline: Arc::new(outline), ..self.clone() })
    }
}
