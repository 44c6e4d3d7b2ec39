//! The contract that every tracer fulfils, on whatever device it runs.

use crate::dynamic::Patch;
use crate::film::Film;
use crate::frame::Frame;
use crate::packed::{PackedScene, Placement};
pub use crate::trace_error::TraceError;
use std::sync::{
    Arc,
    atomic::{AtomicBool, AtomicU64, Ordering},
};
use voxtrace_scene::ray::Hit;
use voxtrace_scene::ray::Ray;

/// Traces rays through a packed scene and renders pictures of it.
pub trait Tracer {
    /// Takes the scene that later calls trace, and forgets the film.
    ///
    /// # Errors
    /// [`TraceError::OutOfMemory`] where the device cannot hold it.
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError>;

    /// Puts the grids of the scene elsewhere, and forgets the film: as [`Self::set_scene`] with the scene that packing anew
    /// would give, but what is large, the geometry, stays where it is.
    ///
    /// # Errors
    /// [`TraceError::NoScene`] before a scene was set; [`TraceError::Placement`] where the placement was made for another
    /// geometry, with nothing changed; [`TraceError::OutOfMemory`] where the device cannot hold it, and then a scene must
    /// be set again.
    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError>;

    /// Follows edits of the scene: see [`crate::DynamicScene`]. Forgets the film, unless nothing changed.
    ///
    /// # Errors
    /// [`TraceError::NoScene`] before a scene was set; [`TraceError::OutOfStep`] where the patch was made for another state of the scene, with
    /// nothing changed: a scene must be set again; [`TraceError::Unsupported`] where the tracer cannot follow edits;
    /// [`TraceError::OutOfMemory`] where the device cannot hold what is new, and then a scene must be set again.
    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError>;

    /// Finds for each ray its first hit, [`Hit::MISS`] where there is none: as devices answer, for millions of rays. `hits` must be as
    /// long as `rays`. Where instances were merged, hits are of those that there were.
    ///
    /// # Errors
    /// [`TraceError::NoScene`] before a scene was set.
    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError>;

    /// Finds for each ray its first hit, `None` where it meets nothing.
    ///
    /// # Errors
    /// As [`Self::cast_into`].
    fn cast(&mut self, rays: &[Ray]) -> Result<Vec<Option<Hit>>, TraceError> {
        let mut hits = vec![Hit::MISS; rays.len()];
        self.cast_into(rays, &mut hits)?;
        Ok(hits.into_iter().map(Hit::found).collect())
    }

    /// Brings the tracer's film up to the samples that `frame` asks for, adding those that it lacks. A frame that
    /// differs from the last one in anything but `samples` starts a new film. Works in passes over all pixels, the first of
    /// one sample. Returns early when `progress` is cancelled, with some pixels one pass behind the others, however often
    /// that happens; a call with fewer samples, then, evens them out: one with 1 gives each pixel at least that.
    ///
    /// # Errors
    /// [`TraceError::BadFrame`] for an empty region, a camera that is not finite, or lines where instances were merged.
    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError>;

    /// Copies the tracer's film.
    ///
    /// # Errors
    /// [`TraceError::NoFilm`] before the first render.
    fn read(&mut self, film: &mut Film) -> Result<(), TraceError>;

    /// Puts a film in the tracer's place of its own, so that the next render of `frame` continues it.
    ///
    /// # Errors
    /// [`TraceError::BadFrame`] if the film is not one of this frame: size, region or first sample differ.
    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError>;

    /// Puts the grids of the scene elsewhere, or leaves them, and keeps the film as one of `frame`, so that the next render of `frame` adds samples of
    /// things as they are now. `frame` may differ from that of the film in its camera and its samples.
    ///
    /// # Errors
    /// As [`Self::set_placement`] and [`Self::resume`]; [`TraceError::NoFilm`] before the first render. [`TraceError::DeviceLost`] from this call and
    /// from later ones of [`Self::render`] and [`Self::read`] where the film was lost with a device: the tracer goes on, but samples of earlier
    /// moments cannot be made again here.
    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError>;

    /// What went wrong and was mended since the last call, one line each, for people.
    fn take_notes(&mut self) -> Vec<String> {
        Vec::new()
    }
}

/// Shared between a render and whoever watches it: how far it is, and the request to stop it.
#[derive(Debug, Default)]
pub struct Progress {
    samples_done: AtomicU64,
    cancelled: AtomicBool,
}

impl Progress {
    /// Samples (pixels × samples of each) finished since this value was made.
    pub fn samples_done(&self) -> u64 {
        self.samples_done.load(Ordering::Relaxed)
    }

    /// Counts finished samples; for tracers.
    pub fn add(&self, samples: u64) {
        self.samples_done.fetch_add(samples, Ordering::Relaxed);
    }

    /// Asks the render to stop soon.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether somebody asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}
