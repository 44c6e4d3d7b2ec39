//! Who holds the arrays of a scene that is edited: whoever follows patches in place has copies of its own.

use super::PackedScene;
use std::sync::Arc;

impl PackedScene {
    /// The same scene with arrays that nobody else holds, and with room in them, so that patches are applied to it in place.
    #[doc(hidden)]
    #[must_use]
    pub fn unshared(&self) -> Self {
        let mut own = self.clone();
        let geometry = Arc::make_mut(&mut own.geometry);
        // Of an array that others hold it makes a copy.
        geometry.cells.set_length(geometry.cells.len());
        geometry.bricks.set_length(geometry.bricks.len());
        geometry.brick_materials.set_length(geometry.brick_materials.len());
        geometry.emitters.set_length(geometry.emitters.len());
        geometry.light_nodes.set_length(geometry.light_nodes.len());
        own
    }

    /// Takes the arrays of another scene in the place of its own, where both are one scene after the same edits. Returns whether they are.
    #[doc(hidden)]
    pub fn take_arrays_of(&mut self, other: &Self) -> bool {
        let (own, theirs) = (&*self.geometry, &*other.geometry);
        let is_same = own.is_edited
            && own.state() == theirs.state()
            && own.materials[..] == theirs.materials[..]
            && own.cells.len() == theirs.cells.len();
        if is_same {
            self.geometry = Arc::clone(&other.geometry);
        }
        is_same
    }
}
