//! One picture by several devices: each gets samples as it finishes those that it had, and the films are added. Sums of samples are exact, so that the
//! picture is that of one device, whichever of them did what, and whichever were lost on the way (`docs/decisions/0200-several-devices.md`).

mod deal;
mod gather;
mod member;
mod round;

use crate::tracer::VulkanTracer;
use deal::Deal;
use gather::{Gathered, Units};
use member::{Member, State};
use rayon::prelude::*;
use round::Round;
use std::sync::Arc;
use voxtrace_core::held_film::HeldFilm;
use voxtrace_core::packed::Placement;
use voxtrace_core::{Film, Frame, PackedScene, Patch, Progress, TraceError, Tracer};
use voxtrace_scene::{Hit, Ray};

/// With fewer samples for each device than this, rows are shared instead.
const FEWEST_SAMPLES: u32 = 8;
/// Bands for each device of which nothing is known, where rows are shared.
const FIRST_BANDS: u32 = 8;

/// Traces on several devices at once.
pub struct SharedTracer {
    members: Vec<Member>,
    film: HeldFilm,
    notes: Vec<String>,
}

impl SharedTracer {
    /// A tracer on devices, each of which may be there several times, and on the processor where that is wanted too. Where all devices are lost, it is the
    /// processor that goes on.
    pub fn new(devices: Vec<VulkanTracer>, with_processor: bool) -> Self {
        let processor = (with_processor || devices.is_empty()).then(Member::processor);
        let members = devices.into_iter().map(Member::device).chain(processor).collect();
        Self { members, film: HeldFilm::default(), notes: Vec::new() }
    }

    /// The names of those that trace.
    pub fn names(&self) -> Vec<String> {
        self.members.iter().filter(|member| member.is_ready()).map(|member| member.name.clone()).collect()
    }

    fn scene(&self) -> Result<Arc<PackedScene>, TraceError> {
        let ready = || self.members.iter().filter(|member| member.is_ready());
        let scene = ready().chain(&self.members).find_map(Member::scene);
        scene.ok_or(TraceError::NoScene)
    }

    /// Lets every member do something at the same time; those that fail take no further part. The error of the last one where nobody is left.
    fn all(&mut self, work: impl Fn(&mut Member) -> Result<(), TraceError> + Sync) -> Result<(), TraceError> {
        let ready = self.members.par_iter_mut().filter(|member| member.is_ready());
        let failed = ready.filter_map(|member| {
            #[cfg(feature = "faults")]
            let of_thread = crate::Faults::of_thread();
            #[cfg(feature = "faults")]
            member.follow_faults();
            let result = work(member);
            // The thread is one of all.
            #[cfg(feature = "faults")]
            crate::Faults::restore(of_thread);
            result.err().map(|error| (member, error))
        });
        let failed: Vec<_> = failed.collect();
        let mut last = None;
        for (member, error) in failed {
            last = Some(error.clone());
            member.leave(error, &mut self.notes)?;
        }
        match last {
            Some(error) if !self.has_ready() => Err(error),
            _ => Ok(()),
        }
    }

    fn has_ready(&self) -> bool {
        self.members.iter().any(Member::is_ready)
    }

    /// Somebody to trace: the processor where all devices are lost.
    fn ensure_member(&mut self) -> Result<(), TraceError> {
        if self.has_ready() { Ok(()) } else { self.add_processor(&self.scene()?) }
    }

    fn add_processor(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        let mut processor = Member::processor();
        processor.tracer().set_scene(scene)?;
        self.notes.push("the processor goes on".into());
        self.members.push(processor);
        Ok(())
    }

    /// The noise-free variables of a film, by the first device that can.
    fn add_aovs(&mut self, frame: &Frame, film: &mut Film) -> Result<(), TraceError> {
        let (none, mut found) = (frame.clone().samples(0), Film::new(0, 0, frame.region, 0));
        loop {
            self.ensure_member()?;
            let Some(member) = self.members.iter_mut().find(|member| member.is_ready()) else { continue };
            let tracer = member.tracer();
            match tracer.render(&none, &Progress::default()).and_then(|()| tracer.read(&mut found)) {
                Ok(()) => break,
                Err(error) => member.leave(error, &mut self.notes)?,
            }
        }
        film.aovs = found.aovs;
        Ok(())
    }

    /// Brings a film up to the samples of a frame, or as far as devices come before they are lost.
    fn round(&mut self, frame: &Frame, film: Film, progress: &Progress) -> Result<Film, TraceError> {
        self.ensure_member()?;
        let (least, most) = film.sample_range();
        let ready = self.members.iter().filter(|member| member.is_ready()).count() as u32;
        let lacking = frame.samples.saturating_sub(least);
        let (units, all, unit, first) = if least == most && lacking >= FEWEST_SAMPLES * ready {
            (Units::Samples, least..frame.samples, 1.0, 1)
        } else {
            let rows = frame.region.height();
            (Units::Rows, 0..rows, f64::from(lacking) / f64::from(rows.max(1)), rows / (FIRST_BANDS * ready))
        };
        let gathered = Gathered::new(film, units, &all);
        let (film, notes, result) =
            Round::new(frame, Deal::new(all, unit, first), gathered, &self.members).run(&mut self.members, progress);
        self.notes.extend(notes);
        result.map(|()| film)
    }
}

impl Tracer for SharedTracer {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.film.forget();
        let too_small = self.members.iter_mut().filter(|member| member.state == State::TooSmall);
        too_small.for_each(|member| member.state = State::Ready);
        let result = self.all(|member| member.tracer().set_scene(scene));
        let are_lost = self.members.iter().all(|member| member.state == State::Lost);
        match result {
            // Now or since earlier.
            _ if are_lost => self.add_processor(scene),
            result => result,
        }
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        self.scene()?;
        self.film.forget();
        self.all(|member| member.tracer().set_placement(placement))
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        self.scene()?;
        if !patch.is_empty() {
            self.film.forget();
        }
        self.all(|member| member.tracer().patch(patch))
    }

    /// By the first device that can: rays are quick, and what takes long is to bring them there.
    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        loop {
            self.ensure_member()?;
            let Some(member) = self.members.iter_mut().find(|member| member.is_ready()) else { continue };
            match member.tracer().cast_into(rays, hits) {
                Err(error) => member.leave(error, &mut self.notes)?,
                done => return done,
            }
        }
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        frame.check()?;
        frame.check_in(&*self.scene()?)?;
        let mut film = self.film.begin(frame);
        if frame.aovs && film.aovs.is_none() {
            self.add_aovs(frame, &mut film)?;
        }
        let plain = frame.clone().aovs(false);
        loop {
            let (least, most) = film.sample_range();
            if least >= frame.samples || progress.is_cancelled() {
                break;
            }
            // A film whose pixels have different numbers of samples is evened out first.
            let next = if least == most { frame.samples } else { most.min(frame.samples) };
            film = self.round(&plain.clone().samples(next), film, progress)?;
        }
        self.film.hold(frame, film);
        Ok(())
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        self.film.read(film)
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        self.film.resume(frame, film)
    }

    /// The film is here, not on the devices: it stays what it is when they are lost.
    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        // A placement that does not fit leaves the film.
        placement.map(|placement| self.scene()?.with_placement(placement).map_err(TraceError::from)).transpose()?;
        let film = self.film.take_for(frame)?;
        if let Some(placement) = placement {
            self.set_placement(placement)?;
        }
        self.film.hold(frame, film);
        Ok(())
    }

    fn take_notes(&mut self) -> Vec<String> {
        for member in &mut self.members {
            let notes = member.tracer().take_notes();
            self.notes.extend(notes.into_iter().map(|note| format!("{}: {note}", member.name)));
        }
        std::mem::take(&mut self.notes)
    }
}
