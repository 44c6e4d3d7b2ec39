//! Packing a scene whose instances on the lattice become one grid.

use super::Merge;
use crate::packed::pack::{Placed, check, material_bits_of, pack_placed, visible_of};
use crate::packed::parts::Parts;
use crate::packed::{Geometry, PackError, PackedScene};
use std::sync::Arc;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;

impl PackedScene {
    /// Packs what is visible, as [`Self::pack`], and makes one grid of the instances that stand on the lattice of the world (turned by quarters,
    /// mirrored, moved by whole voxels, not scaled), once and without moving: rays walk it several times as fast. Hits still are of the
    /// instances and of the voxels in their own grids. Where voxels of several are at one place, that of the first counts. A scene that this changes
    /// ([`Self::is_merged`]) takes no other placements; [`Self::split`] undoes it.
    ///
    /// # Errors
    /// As [`Self::pack`].
    pub fn pack_merged(scene: &Scene) -> Result<Self, PackError> {
        Self::pack_merged_while(scene, &|| true)
    }

    /// As [`Self::pack_merged`], as long as it is `wanted`: see [`Self::pack_while`].
    ///
    /// # Errors
    /// As [`Self::pack_while`].
    pub fn pack_merged_while(scene: &Scene, wanted: &(dyn Fn() -> bool + Sync)) -> Result<Self, PackError> {
        check(scene)?;
        let visible = visible_of(scene);
        let Some(mut merge) = Merge::of(scene, &visible, material_bits_of(scene)) else {
            return Self::pack_while(scene, wanted);
        };
        if !wanted() {
            return Err(PackError::Stopped);
        }
        let grid = scene.grids.len();
        let joined = std::mem::take(&mut merge.joined.grid);
        let scene = &Scene { grids: scene.grids.iter().cloned().chain([Arc::new(joined)]).collect(), ..scene.clone() };
        let mut candidates = merge.candidates.iter().map(|part| part.instance).peekable();
        let mut placed = Vec::new();
        for (index, (scene_instance, instance)) in visible.iter().enumerate() {
            let is_part = candidates.next_if_eq(&index).is_some();
            if !is_part {
                placed.push(Placed::of(*scene_instance, instance));
            } else if index == merge.candidates[0].instance {
                placed.push(Placed { scene_instance: *scene_instance, grid, world_from_grid: Transform::IDENTITY });
            }
        }
        let packed = pack_placed(scene, &placed, wanted)?;
        let numbers: Vec<(usize, usize)> = visible.iter().map(|(index, instance)| (*index, instance.grid)).collect();
        let last = packed.geometry.grids.len() as u32 - 1;
        let parts = Parts::of_merge(&packed.geometry, last, &merge, &numbers);
        let geometry = Geometry { parts: Some(Arc::new(parts)), ..Geometry::clone(&packed.geometry) };
        Ok(Self { geometry: Arc::new(geometry), ..packed })
    }
}
