//! What is shown of a scene while it arrives: a device that holds it in pages gives a pixel its first sample once all that its rays come to is there. Until then the pixel
//! shows a coarser level of the scene (`packed::Levels`), which is there whole.

use crate::dynamic::Patch;
use crate::film::Film;
use crate::frame::Frame;
use crate::packed::{PackedScene, Placement};
use crate::tracer::{Progress, TraceError, Tracer};
use std::sync::Arc;
use voxtrace_scene::ray::{Hit, Ray};

/// A tracer of a scene, and one of a coarser level of it for pixels that have no sample yet. Once all have some, its film is that of the scene to the last bit.
pub struct Meanwhile<T, L> {
    tracer: T,
    of_level: L,
    /// The film of the level, once it was traced for the frame that is rendered.
    level: Option<(Frame, Film)>,
    has_level: bool,
}

impl<T: Tracer, L: Tracer> Meanwhile<T, L> {
    /// A tracer for the scene, and one for its level; neither has one yet.
    pub fn new(tracer: T, of_level: L) -> Self {
        Self { tracer, of_level, level: None, has_level: false }
    }

    /// Takes the scene and a level of it.
    ///
    /// # Errors
    /// As [`Tracer::set_scene`].
    pub fn set_scenes(&mut self, scene: &Arc<PackedScene>, level: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.tracer.set_scene(scene)?;
        self.of_level.set_scene(level)?;
        (self.level, self.has_level) = (None, true);
        Ok(())
    }

    /// The tracer of the scene.
    pub fn tracer(&self) -> &T {
        &self.tracer
    }

    /// Gives the scene to be traced alone: the level is not one of it any more.
    fn without_level(&mut self) -> &mut T {
        (self.level, self.has_level) = (None, false);
        &mut self.tracer
    }
}

impl<T: Tracer, L: Tracer> Tracer for Meanwhile<T, L> {
    /// The scene has no level until [`Meanwhile::set_scenes`] gives both.
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.without_level().set_scene(scene)
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        self.without_level().set_placement(placement)
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        if patch.is_empty() { self.tracer.patch(patch) } else { self.without_level().patch(patch) }
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        self.tracer.cast_into(rays, hits)
    }

    /// First one sample of the level, to its end however `progress` is, then the scene.
    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        let coarse = frame.clone().samples(frame.samples.min(1));
        if self.has_level && self.level.as_ref().is_none_or(|(last, _)| *last != coarse) {
            self.of_level.render(&coarse, &Progress::default())?;
            let mut film = Film::new(1, 1, crate::region::Region::full(1, 1), 0);
            self.of_level.read(&mut film)?;
            self.level = Some((coarse, film));
        }
        self.tracer.render(frame, progress)
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        self.tracer.read(film)?;
        let is_alike = |(_, level): &&(Frame, Film)| {
            (level.width, level.height, level.region) == (film.width, film.height, film.region)
        };
        let Some((_, level)) = self.level.as_ref().filter(is_alike) else { return Ok(()) };
        for (index, pixel) in film.pixels.iter_mut().enumerate().filter(|(_, pixel)| pixel.samples == 0) {
            *pixel = level.pixels[index];
            if let (Some(aovs), Some(of_level)) = (&mut film.aovs, &level.aovs) {
                aovs[index] = of_level[index];
            }
        }
        Ok(())
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        self.tracer.resume(frame, film)
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        self.without_level().set_moment(placement, frame)
    }

    fn take_notes(&mut self) -> Vec<String> {
        let mut notes = self.tracer.take_notes();
        notes.extend(self.of_level.take_notes());
        notes
    }
}
