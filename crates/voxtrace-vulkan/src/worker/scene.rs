//! Taking a scene, or another placement of its geometry.

use super::Worker;
use crate::accel::{Accel, BUILDING_TOP};
use crate::film::DeviceFilm;
use crate::method::{Primitive, Settings, Traversal};
use crate::records::binding;
use crate::scene::SceneBuffers;
use crate::schedule::BatchSizer;
use crate::statistics::Statistics;
use std::sync::Arc;
use voxtrace_core::{Frame, PackedScene, TraceError};

/// Most bytes that a scene in pages leaves to films and to what goes up and down.
const FOR_FILMS: u64 = 512 << 20;

impl Worker {
    pub fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.submitter.wait_for_quiet()?;
        self.film = None;
        if let Some(mut buffers) = self.scene.take_if(|buffers| buffers.holds(scene)) {
            // Another light: nothing to build, and at most an environment map to upload. Where that fails no scene is left.
            let is_lit_as =
                |other: &PackedScene| other.sky == scene.sky && other.light_intensity == scene.light_intensity;
            let has_changed = !is_lit_as(&buffers.scene);
            if buffers.light(&self.device, &mut self.submitter, &mut self.transfer, scene)? {
                buffers.bind(&self.bindings);
            }
            self.scene = Some(buffers);
            if has_changed {
                self.real_time.iter_mut().for_each(|state| state.frames.change());
            }
            return Ok(());
        }
        (self.scene, self.accel, self.pixels_at_a_time) = (None, None, u64::MAX);
        self.drop_waves();
        self.forget_real_time();
        let buffers = self.buffers_of(scene)?;
        buffers.bind(&self.bindings);
        let Settings { traversal, primitive, is_exact } = self.settings;
        if traversal.uses_primitives() {
            // Where the place on the ray says which voxel it is, hardware needs no shader to choose.
            let is_opaque = match primitive {
                Primitive::VoxelApprox => true,
                Primitive::VoxelExact => !is_exact,
                Primitive::Triangle => !is_exact && traversal == Traversal::Pipeline,
                Primitive::Brick | Primitive::Grid => false,
            };
            let (submitter, transfer) = (&mut self.submitter, &mut self.transfer);
            let accel = Accel::new(&self.device, submitter, transfer, scene, primitive, is_opaque)?;
            self.bind_accel(&accel);
            self.accel = Some(accel);
        }
        self.transfer.trim();
        self.scene = Some(buffers);
        (self.render_batches, self.cast_batches) = (BatchSizer::new(self.submit_ms), BatchSizer::new(self.submit_ms));
        Ok(())
    }

    /// The scene on the device: whole, or in pages where that needs more memory than there is and no acceleration structure, which must be whole.
    fn buffers_of(&mut self, scene: &Arc<PackedScene>) -> Result<SceneBuffers, TraceError> {
        let (device, submitter, transfer) = (&self.device, &mut self.submitter, &mut self.transfer);
        let (needed, available) = (SceneBuffers::bytes_of(scene), device.available_bytes());
        // Cells for devices are made in memory: not of what cannot fit.
        let whole = match needed <= available {
            true => SceneBuffers::new(device, submitter, transfer, scene, None),
            false => Err(TraceError::OutOfMemory { needed, available }),
        };
        match whole {
            Err(TraceError::OutOfMemory { .. }) if self.settings.traversal == Traversal::Walk && self.allows_pages => {
                let for_films = (available / 4).min(FOR_FILMS);
                let paged = SceneBuffers::new(device, submitter, transfer, scene, Some(available - for_films));
                paged.map_err(|error| match error {
                    TraceError::OutOfMemory { needed, .. } => {
                        let for_films = (needed / 3 + 2).min(FOR_FILMS);
                        TraceError::OutOfMemory { needed: needed + for_films, available }
                    }
                    error => error,
                })
            }
            result => result,
        }
    }

    /// Takes a scene that differs from the last one in its placement alone, and writes nothing else.
    pub fn set_placement(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.submitter.wait_for_quiet()?;
        // Where something fails nothing is left, rather than half of it.
        let (buffers, accel) = (self.scene.take().ok_or(TraceError::NoScene)?, self.accel.take());
        self.film = None;
        if let Some(state) = &mut self.real_time {
            let before = buffers.scene.instances();
            match before.len() == scene.instances().len() {
                true => state.frames.move_instances(before),
                // What is known names instances by their numbers.
                false => state.forget(),
            }
        }
        let buffers = buffers.placed(&self.device, scene)?;
        let accel = accel.map(|accel| accel.unbuilt(&self.device, scene.placement())).transpose()?;
        let mut writes = buffers.placement_writes();
        writes.extend(accel.iter().flat_map(|accel| accel.top().writes()));
        let build = |commands| accel.iter().for_each(|accel| accel.top().record(commands));
        let ms = self.transfer.write(&mut self.submitter, &writes, Some((BUILDING_TOP, &build)))?;
        self.statistics = Statistics { gpu_ms: ms, longest_submit_ms: ms, submits: 1, ..Statistics::default() };
        buffers.bind(&self.bindings);
        if let Some(accel) = &accel {
            self.bind_accel(accel);
        }
        (self.scene, self.accel) = (Some(buffers), accel);
        Ok(())
    }

    /// Checks that [`Self::set_moment`] can keep the film as one of `frame`.
    pub fn check_moment(&self, frame: &Frame) -> Result<(), TraceError> {
        frame.check()?;
        let film = self.film.as_ref().ok_or(TraceError::NoFilm)?;
        let shown = |frame: &Frame| (frame.width, frame.height, frame.region, frame.first_sample);
        if shown(frame) != shown(&film.frame) {
            let reason = "the film to go on with shows another size, region or first sample";
            return Err(TraceError::BadFrame(reason.into()));
        }
        Ok(())
    }

    /// As [`Self::set_placement`] where a scene is given, and keeps the film, as one of `frame`.
    pub fn set_moment(&mut self, scene: Option<&Arc<PackedScene>>, frame: &Frame) -> Result<(), TraceError> {
        let film = self.film.take().ok_or(TraceError::NoFilm)?;
        if let Some(scene) = scene {
            self.set_placement(scene)?;
        }
        self.film = Some(DeviceFilm { frame: frame.clone(), ..film });
        Ok(())
    }

    /// Uploads what a ground that shows shadows alone needs of the scene's sky, unless it is there. Nothing may be in flight.
    pub fn prepare_catcher(&mut self) -> Result<(), TraceError> {
        let buffers = self.scene.as_mut().ok_or(TraceError::NoScene)?;
        if buffers.light_from_above(&self.device, &mut self.submitter, &mut self.transfer)? {
            buffers.bind(&self.bindings);
        }
        Ok(())
    }

    pub(super) fn bind_accel(&self, accel: &Accel) {
        self.bindings.bind_top_level(accel.top_level());
        self.bindings.bind(binding::PRIMITIVES, &accel.records);
        self.bindings.bind(binding::ENTRIES, accel.entries());
    }
}
