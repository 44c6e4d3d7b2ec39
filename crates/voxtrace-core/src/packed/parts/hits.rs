//! Hits of what tracers walk, the packed grids, and hits of the scene's instances: the same where nothing was merged.

use crate::packed::{PackedInstance, PackedScene};
use rayon::prelude::*;
use voxtrace_scene::ray::Hit;

/// Hits that one task turns.
const CHUNK: usize = 1 << 14;

impl PackedScene {
    /// The hit of an instance of the scene, and of the voxel in its own grid, of a hit as tracers find it, or a miss.
    #[doc(hidden)]
    pub fn hit_of_part(&self, hit: &Hit) -> Hit {
        let Some(parts) = self.geometry.parts.as_deref().filter(|_| !hit.is_miss()) else { return *hit };
        if hit.instance != parts.instance() {
            return Hit { instance: parts.kept_index(hit.instance), ..*hit };
        }
        let (_, part) = self.geometry.part_at(hit.voxel).expect("every voxel of a merged grid is of a part");
        let lattice = parts.lattice(part);
        let face = if hit.cut().is_some() { hit.face } else { lattice.face_before(hit.face()) };
        Hit { instance: parts.records[part].instance, voxel: lattice.voxel_before(hit.voxel), face, ..*hit }
    }

    /// The hit as tracers find it: the inverse of [`Self::hit_of_part`].
    #[doc(hidden)]
    pub fn hit_of_packed(&self, hit: &Hit) -> Hit {
        let Some(parts) = self.geometry.parts.as_deref().filter(|_| !hit.is_miss()) else { return *hit };
        match parts.of_instance(hit.instance) {
            Err(before) => Hit { instance: parts.packed_index(hit.instance, before), ..*hit },
            Ok(part) => {
                let lattice = parts.lattice(part);
                let face = if hit.cut().is_some() { hit.face } else { lattice.face(hit.face()) };
                Hit { instance: parts.instance(), voxel: lattice.voxel(hit.voxel), face, ..*hit }
            }
        }
    }

    /// Makes hits as tracers find them those of instances of the scene, as [`Self::hit_of_part`].
    #[doc(hidden)]
    pub fn turn_to_parts(&self, hits: &mut [Hit]) {
        if self.is_merged() {
            hits.par_chunks_mut(CHUNK).flatten().for_each(|hit| *hit = self.hit_of_part(hit));
        }
    }

    /// The placed instance that `hit`, one of this scene, met. Where it was merged with others, it names the grid that they became.
    ///
    /// # Panics
    /// If the hit is not one of this scene.
    pub fn instance(&self, hit: &Hit) -> PackedInstance {
        let packed = self.hit_of_packed(hit);
        let instance = self.placement.instances[packed.instance as usize];
        let part =
            self.geometry.parts.as_deref().and_then(|parts| Some((parts, parts.of_instance(hit.instance).ok()?)));
        match part {
            Some((parts, part)) => parts.instance_of(part, &instance),
            None => instance,
        }
    }
}
