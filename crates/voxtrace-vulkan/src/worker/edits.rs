//! Following edits of a scene: what changed is written into arrays that have room for more, and structures of ray tracing hardware are
//! built anew only where the bounds of a grid changed.

use super::Worker;
use crate::accel::{Accel, BUILDING_TOP};
use crate::method::Primitive;
use crate::scene::SceneBuffers;
use crate::statistics::Statistics;
use crate::transfer::Record;
use std::sync::Arc;
use voxtrace_core::dynamic::Patch;
use voxtrace_core::{PackedScene, TraceError};

impl Worker {
    /// What acceleration structures are made of: of an edited scene boxes around grids, which stay as they are while voxels change.
    pub(super) fn primitive(&self) -> Primitive {
        match &self.scene {
            Some(buffers) if buffers.is_edited => Primitive::Grid,
            _ => self.settings.primitive,
        }
    }

    /// Lets go of the host's scene, so that it can be changed in place. It must be given back by [`Self::patch`] or [`Self::hold`].
    pub fn release(&mut self) {
        if let Some(buffers) = &mut self.scene {
            buffers.scene = Arc::new(PackedScene::empty());
        }
    }

    /// Takes the host's scene back as it was.
    pub fn hold(&mut self, scene: &Arc<PackedScene>) {
        if let Some(buffers) = &mut self.scene {
            buffers.scene = Arc::clone(scene);
        }
    }

    /// Takes `scene`, which differs from the last one by a patch.
    pub fn patch(&mut self, scene: &Arc<PackedScene>, patch: &Patch) -> Result<(), TraceError> {
        self.film = None;
        self.real_time.iter_mut().for_each(|state| state.frames.change());
        self.submitter.wait_for_quiet()?;
        // Where something fails nothing is left, rather than half of it.
        let (buffers, accel) = (self.scene.take().ok_or(TraceError::NoScene)?, self.accel.take());
        if !buffers.is_edited {
            drop((buffers, accel));
            return self.set_edited(scene);
        }
        let mut buffers = buffers;
        let bounds = patch.placement.is_some();
        let (written, has_moved) = buffers.patched(&self.device, scene, patch)?;
        let has_new_bounds = accel.as_ref().is_some_and(|accel| bounds && !accel.has_bounds(scene.grids()));
        let accel = if has_new_bounds { None } else { accel };
        let placed = if bounds { buffers.placed(&self.device, scene)? } else { buffers };
        let accel = match accel {
            Some(accel) if bounds => Some(accel.unbuilt(&self.device, scene.placement())?),
            accel => accel,
        };
        let mut writes = placed.patch_writes(&written);
        if bounds {
            writes.extend(placed.placement_writes());
            writes.extend(accel.iter().flat_map(|accel| accel.top().writes()));
        }
        let is_built = bounds && accel.is_some();
        let build = |commands| accel.iter().for_each(|accel| accel.top().record(commands));
        // The next frame waits for it on the device, nobody here.
        self.transfer.write_quietly(
            &mut self.submitter,
            &writes,
            is_built.then_some((BUILDING_TOP, &build as Record)),
        )?;
        drop(writes);
        self.statistics = Statistics { submits: 1, ..Statistics::default() };
        if has_moved || bounds {
            placed.bind(&self.bindings);
        }
        let accel = match has_new_bounds {
            true => {
                // The build may fail before it waits, and what is being written would be freed.
                self.submitter.wait_for_quiet()?;
                Some(self.accel_of_grids(scene)?)
            }
            false => accel,
        };
        if let Some(accel) = accel.as_ref().filter(|_| bounds) {
            self.bind_accel(accel);
        }
        (self.scene, self.accel) = (Some(placed), accel);
        Ok(())
    }

    /// Takes a scene that is being edited.
    fn set_edited(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        // As for any scene that is uploaded, paths make room.
        self.drop_waves();
        let buffers = SceneBuffers::to_edit(&self.device, &mut self.submitter, &mut self.transfer, scene)?;
        buffers.bind(&self.bindings);
        if self.settings.traversal.uses_primitives() {
            let accel = self.accel_of_grids(scene)?;
            self.bind_accel(&accel);
            self.accel = Some(accel);
        }
        self.scene = Some(buffers);
        Ok(())
    }

    fn accel_of_grids(&mut self, scene: &PackedScene) -> Result<Accel, TraceError> {
        Accel::new(&self.device, &mut self.submitter, &mut self.transfer, scene, Primitive::Grid, false)
    }
}
