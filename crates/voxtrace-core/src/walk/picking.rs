//! One ray into a scene, for those who pick, measure or collide.

use super::instances;
use crate::packed::PackedScene;
use voxtrace_scene::ray::{Hit, Ray};

impl PackedScene {
    /// The first voxel along a ray in what the scene's cuts keep, `None` where it meets nothing. A tracer is faster for many rays.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        instances::cast(self, ray).found().map(|hit| self.hit_of_part(&hit))
    }

    /// Index of the met instance in [`voxtrace_scene::Scene::instances`] of the scene that was packed.
    ///
    /// # Panics
    /// If the hit is not one of this scene.
    pub fn scene_instance(&self, hit: &Hit) -> usize {
        self.instance(hit).scene_instance as usize
    }
}
