//! The film that a tracer holds in the memory of the host, with the frame that it is of.

use crate::film::Film;
use crate::frame::Frame;
use crate::tracer::TraceError;

/// What the methods of a tracer about its film do where that lies on the host.
#[derive(Default)]
pub struct HeldFilm(Option<(Frame, Film)>);

impl HeldFilm {
    /// Takes the film for a frame: the one that is held where the frame continues it, else a black one.
    pub fn begin(&mut self, frame: &Frame) -> Film {
        match self.0.take() {
            Some((last, film)) if frame.continues(&last) => film,
            _ => Film::new(frame.width, frame.height, frame.region, frame.first_sample),
        }
    }

    /// Holds a film.
    pub fn hold(&mut self, frame: &Frame, film: Film) {
        self.0 = Some((frame.clone(), film));
    }

    /// Holds none from now on.
    pub fn forget(&mut self) {
        self.0 = None;
    }

    /// As [`crate::Tracer::read`].
    ///
    /// # Errors
    /// [`TraceError::NoFilm`] where none is held.
    pub fn read(&self, film: &mut Film) -> Result<(), TraceError> {
        film.clone_from(&self.0.as_ref().ok_or(TraceError::NoFilm)?.1);
        Ok(())
    }

    /// As [`crate::Tracer::resume`].
    ///
    /// # Errors
    /// What [`Frame::check`] and [`Frame::check_film`] say.
    pub fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        frame.check()?;
        frame.check_film(&film)?;
        self.hold(frame, film);
        Ok(())
    }

    /// Takes the film that goes on in another moment, for [`crate::Tracer::set_moment`].
    ///
    /// # Errors
    /// [`TraceError::NoFilm`] where none is held; what [`Frame::check`] and [`Frame::check_film`] say.
    pub fn take_for(&mut self, frame: &Frame) -> Result<Film, TraceError> {
        frame.check()?;
        // A frame of another kind leaves it.
        let (_, film) = self.0.as_ref().ok_or(TraceError::NoFilm)?;
        frame.check_film(film)?;
        self.0.take().map(|(_, film)| film).ok_or(TraceError::NoFilm)
    }
}
