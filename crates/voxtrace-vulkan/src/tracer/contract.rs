//! What every tracer does, on a device or, after losses, on the CPU.

use super::{Backend, VulkanTracer};
use std::sync::Arc;
use voxtrace_core::packed::Placement;
use voxtrace_core::{Film, Frame, PackedScene, Patch, Progress, TraceError, Tracer};
use voxtrace_scene::{Hit, Ray};

impl Tracer for VulkanTracer {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        (self.scene, self.copy, self.rendered, self.is_carried) = (None, None, None, false);
        self.attempt(|backend| match backend {
            Backend::Device(worker) => worker.set_scene(scene),
            Backend::Cpu(cpu) => cpu.set_scene(scene),
            Backend::None => Err(TraceError::NoScene),
        })?;
        self.scene = Some(Arc::clone(scene));
        if let Backend::Device(worker) = &self.backend
            && let Some((bytes, room)) = worker.room()
        {
            let gigabytes = |bytes: u64| format!("{:.3} GB", bytes as f64 * 1e-9);
            self.notes.push(format!(
                "the scene is larger than the memory of {}: rays bring what they come to of {}, {} at a time",
                self.device.info().name,
                gigabytes(bytes),
                gigabytes(room)
            ));
        }
        Ok(())
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        let scene = self.scene.as_mut().ok_or(TraceError::NoScene)?;
        if patch.is_empty() {
            return Ok(());
        }
        if let Backend::Cpu(cpu) = &mut self.backend {
            // It changes the scene in place where nobody else holds it.
            self.scene = None;
            let result = cpu.patch(patch);
            self.scene = cpu.scene().ok();
            if result.is_ok() {
                (self.copy, self.rendered, self.is_carried) = (None, None, false);
            }
            return result;
        }
        // Nobody else of ours holds the scene while it is changed, or all of it would be copied.
        if let Backend::Device(worker) = &mut self.backend {
            worker.release();
        }
        let followed = Arc::make_mut(scene).apply_patch(patch);
        let scene = Arc::clone(scene);
        if let Err(out_of_step) = followed {
            if let Backend::Device(worker) = &mut self.backend {
                worker.hold(&scene);
            }
            return Err(out_of_step.into());
        }
        (self.copy, self.rendered, self.is_carried) = (None, None, false);
        let result = match &mut self.backend {
            Backend::Device(worker) => worker.patch(&scene, patch),
            Backend::Cpu(_) | Backend::None => Err(TraceError::NoScene),
        };
        let result = match result {
            // It is opened anew with the scene as it is now.
            Err(TraceError::DeviceLost { last_pass }) => self.recover(&last_pass),
            result => result,
        };
        if result.is_err() {
            self.scene = None;
        }
        result
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        let scene = self.scene.as_ref().ok_or(TraceError::NoScene)?;
        let scene = Arc::new(scene.with_placement(placement)?);
        (self.copy, self.rendered, self.is_carried) = (None, None, false);
        // A device that is lost meanwhile is opened anew with the scene as it was, and then asked again.
        let result = self.attempt(|backend| match backend {
            Backend::Device(worker) => worker.set_placement(&scene),
            Backend::Cpu(cpu) => cpu.set_placement(placement),
            Backend::None => Err(TraceError::NoScene),
        });
        self.scene = result.is_ok().then_some(scene);
        result
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        let scene = self.scene.clone();
        self.attempt(|backend| match backend {
            Backend::Device(worker) => {
                worker.cast(rays, hits)?;
                scene.iter().for_each(|scene| scene.turn_to_parts(hits));
                Ok(())
            }
            Backend::Cpu(cpu) => cpu.cast_into(rays, hits),
            Backend::None => Err(TraceError::NoScene),
        })
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        self.render_with(frame, progress, None)
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        loop {
            let result = match &mut self.backend {
                Backend::Device(worker) => worker.read(film),
                Backend::Cpu(cpu) => cpu.read(film),
                Backend::None => Err(TraceError::NoFilm),
            };
            let Err(TraceError::DeviceLost { last_pass }) = result else { return result };
            self.recover(&last_pass)?;
            // Renders again what was not copied before.
            if let Some(frame) = self.rendered.clone() {
                self.render(&frame, &Progress::default())?;
            }
        }
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        let scene = self.scene.as_ref().ok_or(TraceError::NoScene)?;
        let moved = placement.map(|placement| scene.with_placement(placement).map(Arc::new)).transpose()?;
        // What does not suit leaves scene and film as they are.
        match &mut self.backend {
            Backend::Device(worker) => worker.check_moment(frame)?,
            Backend::Cpu(cpu) => cpu.set_moment(placement, frame)?,
            Backend::None => return Err(TraceError::NoFilm),
        }
        (self.copy, self.rendered, self.is_carried) = (None, None, true);
        let result = match &mut self.backend {
            Backend::Device(worker) => worker.set_moment(moved.as_ref(), frame),
            _ => Ok(()),
        };
        match result {
            Ok(()) => self.scene = moved.or(self.scene.take()),
            Err(TraceError::DeviceLost { last_pass }) => return self.recover(&last_pass),
            Err(_) => self.scene = None,
        }
        result
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        frame.check()?;
        frame.check_film(&film)?;
        self.is_carried = false;
        self.rendered = None;
        self.copy = Some((frame.clone(), film));
        let copy = self.copy.clone();
        let Some((frame, film)) = &copy else { return Ok(()) };
        self.attempt(|backend| match backend {
            Backend::Device(worker) => worker.resume(frame, film),
            Backend::Cpu(cpu) => cpu.resume(frame, film.clone()),
            Backend::None => Err(TraceError::NoFilm),
        })
    }

    fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }
}
