//! Showing the film in pictures of a window.

use super::{Backend, VulkanTracer};
use crate::picture::{Picture, Under};
use crate::worker::Canvas;
use std::sync::Arc;
use voxtrace_core::{Frame, Progress, TraceError};

impl VulkanTracer {
    /// Writes the mean of the film's samples to a picture of its size on the tracer's device, for a window to draw.
    /// Returns the milliseconds that it took by the device's clock.
    ///
    /// # Errors
    /// [`TraceError::NoFilm`] before the first render; [`TraceError::BadFrame`] where the picture does not suit;
    /// [`TraceError::DeviceLost`] after a loss: the tracer goes on, on another device or on the CPU, and the film is read with
    /// [`Tracer::read`](voxtrace_core::Tracer::read).
    pub fn resolve(&mut self, picture: &Picture) -> Result<f64, TraceError> {
        self.resolve_over(picture, None)
    }

    /// As [`Self::resolve`], over another picture, which is seen where the film has little weight.
    ///
    /// # Errors
    /// As there.
    pub fn resolve_over(&mut self, picture: &Picture, under: Option<Under>) -> Result<f64, TraceError> {
        let result = match &mut self.backend {
            Backend::Device(worker) => worker.resolve(Canvas { picture, under }),
            _ => Err(TraceError::BadFrame("the picture lies on a device, and the film does not".into())),
        };
        if let Err(TraceError::DeviceLost { last_pass }) = &result {
            self.recover(last_pass)?;
        }
        result
    }

    /// As [`Tracer::render`](voxtrace_core::Tracer::render), and writes the picture as [`Self::resolve`] does: with the last samples where that can be, which spares a
    /// frame of a window the wait for a submit. Returns the milliseconds that showing took by the device's clock; `None` where `progress`
    /// was cancelled, or where the film went elsewhere after a loss, so that the picture is not written.
    ///
    /// # Errors
    /// As both.
    pub fn render_shown(
        &mut self,
        frame: &Frame,
        progress: &Progress,
        picture: &Picture,
    ) -> Result<Option<f64>, TraceError> {
        self.render_over(frame, progress, picture, None)
    }

    /// As [`Self::render_shown`], over another picture, which is seen where the film has little weight.
    ///
    /// # Errors
    /// As there.
    pub fn render_over(
        &mut self,
        frame: &Frame,
        progress: &Progress,
        picture: &Picture,
        under: Option<Under>,
    ) -> Result<Option<f64>, TraceError> {
        self.render_with(frame, progress, Some(Canvas { picture, under }))?;
        let Backend::Device(worker) = &mut self.backend else { return Ok(None) };
        let shown = worker.take_shown();
        if progress.is_cancelled() || !Arc::ptr_eq(picture.device(), &self.device) {
            return Ok(None);
        }
        match shown {
            Some(ms) => Ok(Some(ms)),
            None => self.resolve_over(picture, under).map(Some),
        }
    }
}
