//! The scene that is shown follows its edits: what is picked in and written is one scene with what is traced, patch by patch.

use crate::open::Open;
use std::sync::Arc;
use voxtrace::PackedScene;
use voxtrace::changes::SceneChanges;
use voxtrace::dynamic::{OutOfStep, Patch};
use voxtrace::packed::PackedGrid;

impl Open {
    /// Takes the scene that is edited in the place of the one that was read: with its instances apart, and with the materials as they were changed.
    /// What is seen stays.
    pub(crate) fn take_base(&mut self, base: Arc<PackedScene>) {
        let is_alone = Arc::ptr_eq(&self.changed, &self.alone);
        let materials = std::mem::take(&mut self.materials);
        self.baked.extend(materials);
        self.original = base;
        self.apart = None;
        self.show_edited(is_alone, None);
    }

    /// Whether nothing is around the scene and nothing of it is hidden: what traces it takes patches as they are.
    pub(crate) fn is_plain(&self) -> bool {
        self.is_alone() && self.alone.instances().len() == self.original.instances().len()
    }

    /// Whether nothing is around the scene.
    pub(crate) fn is_alone(&self) -> bool {
        Arc::ptr_eq(&self.changed, &self.alone)
    }

    /// Follows an edit. Returns the patch that what traces has to take: it shows what is not hidden.
    ///
    /// # Errors
    /// [`OutOfStep`] where the patch was made for another state, with nothing changed.
    pub(crate) fn follow(&mut self, patch: &Arc<Patch>) -> Result<Arc<Patch>, OutOfStep> {
        let is_alone = self.is_alone();
        let placed = (!self.is_plain() && patch.placement.is_none()).then(|| self.alone.placement().clone());
        let (sky, light_intensity, cuts) =
            (self.lit.sky.clone(), self.lit.light_intensity, std::mem::take(&mut Arc::make_mut(&mut self.lit).cuts));
        // Nobody else of ours holds the arrays while they are changed, or they would be copied.
        let nothing = Arc::new(PackedScene::empty());
        let parts = [&mut self.alone, &mut self.pickable];
        parts.into_iter().for_each(|part| *part = Arc::clone(&nothing));
        if is_alone {
            self.changed = Arc::clone(&nothing);
            self.lit = nothing;
        }
        let mut scene = std::mem::replace(&mut self.original, Arc::new(PackedScene::empty()));
        let followed = Arc::make_mut(&mut scene).apply_patch(patch);
        self.original = scene;
        // The light is that of before.
        let light = Arc::make_mut(&mut self.lit);
        (light.sky, light.light_intensity, light.cuts) = (sky, light_intensity, cuts);
        self.show_edited(is_alone, placed);
        followed?;
        if self.alone.instances().len() == self.original.instances().len() || patch.placement.is_none() {
            return Ok(Arc::clone(patch));
        }
        let mut shown = (**patch).clone();
        shown.placement = Some(self.alone.placement().clone());
        Ok(Arc::new(shown))
    }

    /// Makes what is shown of the edited scene, in the light of before, with its instances where they were `placed` if that did not change.
    fn show_edited(&mut self, is_alone: bool, placed: Option<voxtrace::Placement>) {
        let scene = &self.original;
        let hidden = self.hidden_parts();
        self.alone = match placed.and_then(|placed| scene.with_placement(&placed).ok()) {
            Some(placed) => Arc::new(placed),
            None if hidden.is_empty() => Arc::clone(scene),
            None => {
                let changes = SceneChanges { materials: Vec::new(), hidden };
                changes.apply(scene).map_or_else(|_| Arc::clone(scene), Arc::new)
            }
        };
        let (mut lit, light) = ((*self.alone).clone(), &self.lit);
        (lit.sky, lit.light_intensity, lit.cuts) = (light.sky.clone(), light.light_intensity, light.cuts.clone());
        self.pickable = Arc::new(lit);
        if is_alone {
            self.changed = Arc::clone(&self.alone);
            self.lit = Arc::clone(&self.pickable);
        }
        self.voxels = voxels_of(&self.original);
    }
}

/// Voxels of the grids of a scene, each once.
fn voxels_of(scene: &PackedScene) -> u64 {
    scene.grids().iter().map(PackedGrid::voxel_count).sum()
}
