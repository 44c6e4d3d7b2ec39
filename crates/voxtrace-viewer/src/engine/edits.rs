//! Edits of the scene that is traced: every tracer takes the same patches, and the scene that others are made with is that of the first.

use super::Event;
use super::worker::Worker;
use crate::tr;
use std::sync::Arc;
use voxtrace::{PackedScene, Patch};

impl Worker {
    /// Follows an edit with all tracers. The films begin anew.
    pub(super) fn follow(&mut self, patch: &Patch) {
        if patch.is_empty() {
            return;
        }
        let mut is_stale = false;
        let kept = self.scene.take();
        if self.sides.iter().all(|side| side.scene().is_none()) {
            self.scene = kept.map(|mut scene| {
                is_stale = Arc::make_mut(&mut scene).apply_patch(patch).is_err();
                scene
            });
        } else {
            // Nobody else of ours holds the arrays while they are changed, or they would be copied.
            drop(kept);
            for side in &mut self.sides {
                if let Err(error) = side.follow(patch) {
                    (self.tell)(Event::Notice(tr!("said.set_anew", error = error)));
                    is_stale = true;
                }
            }
            self.scene = self.sides.iter().find_map(|side| side.scene());
        }
        self.begin();
        if is_stale {
            (self.tell)(Event::Stale);
        }
    }

    /// A scene with the arrays of the one that is traced, where both are one after the same edits: another light needs no upload then.
    pub(super) fn sharing(&self, scene: Option<Arc<PackedScene>>) -> Option<Arc<PackedScene>> {
        let own = self.scene.as_ref();
        scene.map(|scene| match own {
            Some(own) if !Arc::ptr_eq(own.geometry(), scene.geometry()) => {
                let mut shared = (*scene).clone();
                if shared.take_arrays_of(own) { Arc::new(shared) } else { scene }
            }
            _ => scene,
        })
    }
}
