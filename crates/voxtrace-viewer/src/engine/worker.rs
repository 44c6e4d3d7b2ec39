//! What the tracing thread does: it takes the requests that wait, traces a step of the view, and shows it. Two tracers that are compared
//! take turns.

mod loss;

use super::contrast::{Contrast, blacken, central_rays, differing_pixels, differing_voxels};
use super::pictures::Pictures;
use super::side::{Side, Stepped, Turn};
use super::{Backend, Differences, Event, Light, Pause, Request, Shared, View, locked};
use crate::memory;
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::{Duration, Instant};
use voxtrace::{PackedScene, Progress, TraceError};
use voxtrace_vulkan::Device;

/// Time between two comparisons of films that grow: both are read for one.
const BETWEEN_COMPARISONS: Duration = Duration::from_millis(250);

/// The state of the thread.
pub(super) struct Worker {
    requests: Receiver<Request>,
    shared: Arc<Shared>,
    pub(super) tell: Box<dyn Fn(Event) + Send>,
    device: Arc<Device>,
    /// The picture that is shown, and the one that it is compared with.
    pub(super) sides: Vec<Side>,
    pub(super) scene: Option<Arc<PackedScene>>,
    view: Option<View>,
    is_moving: bool,
    pause: Pause,
    has_failed: bool,
    /// When the device was lost, the last times.
    losses: VecDeque<Instant>,
    contrast: Contrast,
    light: Light,
    /// Where rays of the view meet other voxels, once that is known.
    other_voxels: Option<Vec<bool>>,
    /// When films were compared last, and of how many samples.
    compared: Option<(Instant, u32)>,
    pictures: Pictures,
}

impl Worker {
    /// A worker that has nothing to trace yet.
    pub fn new(
        requests: Receiver<Request>,
        shared: Arc<Shared>,
        tell: Box<dyn Fn(Event) + Send>,
        device: Arc<Device>,
        backend: Backend,
    ) -> Self {
        Self {
            requests,
            shared,
            tell,
            device,
            sides: vec![Side::new(backend)],
            scene: None,
            view: None,
            is_moving: false,
            pause: Pause::default(),
            has_failed: false,
            losses: VecDeque::new(),
            contrast: Contrast::default(),
            light: Light::default(),
            other_voxels: None,
            compared: None,
            pictures: Pictures::default(),
        }
    }

    /// Works until the last request.
    pub fn run(&mut self) {
        loop {
            let progress = Arc::new(Progress::default());
            *locked(&self.shared.progress) = Arc::clone(&progress);
            if !self.take_requests() {
                return;
            }
            if let Err((index, error)) = self.work(&progress) {
                self.go_on_after(index, error);
            }
        }
    }

    /// The side whose turn it is, and how many samples it may take; `None` where there is nothing to do.
    fn turn(&self) -> Option<(usize, u32)> {
        let view = self.view.as_ref()?;
        let samples = if self.pause == Pause::Samples { view.samples.min(1) } else { view.samples };
        if self.scene.is_none() || self.pause == Pause::Everything || self.has_failed {
            return None;
        }
        // Frames of real-time light come as long as the view moves on.
        if self.is_moving && self.sides[0].has_real_time(view, &self.device) {
            return Some((0, samples));
        }
        let open = (0..self.sides.len()).filter(|&index| self.sides[index].is_open(samples, self.is_moving));
        // The one that is behind; the first leads, and the second goes as far as it.
        let index = open.min_by_key(|&index| (self.sides[index].place(), index))?;
        let leader = self.sides[0].done;
        let most = if index > 0 && leader > 0 { leader.max(self.sides[index].done + 1) } else { samples };
        Some((index, most.min(samples) - self.sides[index].done))
    }

    /// Whether films or voxels are to be compared now.
    fn is_to_compare(&self) -> bool {
        let [first, second] = &self.sides[..] else { return false };
        let Some(view) = &self.view else { return false };
        // Films are compared after as many samples; which voxels rays meet, any number of them leaves the same.
        let is_even = match self.contrast {
            Contrast::Voxels => first.done > 0 && second.done > 0,
            _ => first.done == second.done && first.done > 0,
        };
        let is_late = match self.compared {
            None => true,
            Some((_, done)) if done == first.done => false,
            Some((at, _)) => at.elapsed() >= BETWEEN_COMPARISONS || first.done >= view.samples,
        };
        let can = self.scene.is_some() && !self.has_failed && !self.is_moving;
        self.contrast != Contrast::Beside && is_even && is_late && can
    }

    fn has_work(&self) -> bool {
        self.turn().is_some() || self.is_to_compare()
    }

    /// Takes all requests that wait, or waits for one where there is nothing to do. Returns false at the end.
    fn take_requests(&mut self) -> bool {
        if !self.has_work() {
            match self.requests.recv() {
                Ok(request) => {
                    if !self.take(request) {
                        return false;
                    }
                }
                Err(_) => return false,
            }
        }
        loop {
            match self.requests.try_recv() {
                Ok(request) => {
                    if !self.take(request) {
                        return false;
                    }
                }
                Err(TryRecvError::Empty) => return true,
                Err(TryRecvError::Disconnected) => return false,
            }
        }
    }

    /// Takes a request. Returns false where it is the last.
    fn take(&mut self, request: Request) -> bool {
        match request {
            Request::Quit => return false,
            Request::Pause(pause) => self.pause = pause,
            Request::Film(index, answer) => {
                let view = self.view.as_ref();
                let film = self.sides.get_mut(index).zip(view).and_then(|(side, view)| side.whole_film(view));
                // Whoever asked may be gone.
                let _ = answer.send(film);
            }
            Request::Lost(device) => self.lost(&device),
            Request::Follow(patch) => self.follow(&patch),
            Request::Scene(scene) => {
                let scene = self.sharing(scene);
                let old = std::mem::replace(&mut self.scene, scene);
                let scenes = old.as_ref().zip(self.scene.as_ref());
                self.sides.iter_mut().for_each(|side| side.take_scene(scenes));
                // Another light shares what is large.
                let is_other = scenes.is_none_or(|(old, new)| !Arc::ptr_eq(old.geometry(), new.geometry()));
                self.begin();
                drop(old);
                if is_other {
                    memory::give_back();
                }
            }
            Request::Backend(backend) => {
                if backend != self.sides[0].backend || self.sides[0].stands_in {
                    self.sides[0].close();
                    self.sides[0].backend = backend;
                    memory::give_back();
                }
                self.sides[0].begin();
                self.forget_differences();
            }
            Request::Other(other) => self.compare_with(other),
            Request::Contrast(contrast) => {
                self.contrast = contrast;
                self.forget_differences();
            }
            Request::Light(light) => {
                self.light = light;
                self.light_sides();
                self.show_paused();
            }
            Request::View { view, is_moving } => {
                self.is_moving = is_moving;
                let continues = self.view.as_ref().is_some_and(|last| view.frame().continues(&last.frame()));
                // Of a film with more samples than are asked for now, the step under way may be left half done for good.
                let has_more = self.sides.iter().any(|side| side.done > view.samples);
                self.view = Some(*view);
                if !continues || has_more {
                    self.begin();
                }
            }
        }
        true
    }

    /// Takes another second tracer, or none.
    fn compare_with(&mut self, other: Option<Backend>) {
        if self.sides.get(1).map(|side| side.backend) != other {
            self.sides.truncate(1);
            locked(&self.shared.shown)[1] = None;
            memory::give_back();
            self.sides.extend(other.map(Side::new));
            self.light_sides();
        }
        self.forget_differences();
    }

    /// Tracers are compared by their films alone.
    fn light_sides(&mut self) {
        let light = if self.sides.len() > 1 { Light::default() } else { self.light };
        self.sides.iter_mut().for_each(|side| side.set_light(light));
    }

    /// Shows the film that is there in another light: while samples are left out, no step comes that would.
    fn show_paused(&mut self) {
        let (Some(view), [side]) = (&self.view, &mut self.sides[..]) else { return };
        let is_alone = side.done > 0 && !side.lacks_samples(view, &self.device);
        if self.pause != Pause::Samples || self.is_moving || !is_alone {
            return;
        }
        let last = locked(&self.shared.shown)[0].clone();
        if let Some(shown) = side.shown_again(view, last, &self.device) {
            locked(&self.shared.shown)[0] = Some(shown);
            (self.tell)(Event::Picture);
        }
    }

    /// Begins new films.
    pub(super) fn begin(&mut self) {
        self.sides.iter_mut().for_each(Side::begin);
        self.forget_differences();
    }

    fn forget_differences(&mut self) {
        self.has_failed = false;
        (self.other_voxels, self.compared) = (None, None);
        *locked(&self.shared.differences) = None;
    }

    /// Traces one step, or compares what was traced. An error comes with the number of the side that it is of.
    fn work(&mut self, progress: &Progress) -> Result<(), (usize, TraceError)> {
        if self.is_to_compare() {
            return self.compare().map_err(|error| (0, error));
        }
        match self.turn() {
            Some((index, most)) => self.step(index, most, progress).map_err(|error| (index, error)),
            None => Ok(()),
        }
    }

    /// Traces one step of a side and shows it.
    fn step(&mut self, index: usize, most: u32, progress: &Progress) -> Result<(), TraceError> {
        let (Some(view), Some(scene)) = (&self.view, &self.scene) else { return Ok(()) };
        let side = &mut self.sides[index];
        self.shared.is_first.store(side.is_first(), Ordering::Relaxed);
        let turn = Turn { most, is_moving: self.is_moving };
        let stepped = side.step(scene, view, turn, &self.device, progress);
        side.notes.drain(..).for_each(|note| (self.tell)(Event::Notice(note)));
        match stepped? {
            Stepped::Cancelled | Stepped::Lost => {}
            Stepped::Moved(device) => self.moved(device),
            Stepped::Picture(shown) => {
                locked(&self.shared.shown)[index] = Some(shown);
                (self.tell)(Event::Picture);
            }
        }
        Ok(())
    }

    /// Pictures lie on another device from now on. Films that stay are shown from there.
    fn moved(&mut self, device: Arc<Device>) {
        let last = std::mem::take(&mut *locked(&self.shared.shown));
        for side in &mut self.sides {
            side.leave_device(&device);
        }
        self.pictures = Pictures::default();
        self.forget_differences();
        self.device = Arc::clone(&device);
        (self.tell)(Event::Moved(device));
        for (index, last) in last.into_iter().enumerate() {
            let Some((side, view)) = self.sides.get_mut(index).zip(self.view.as_ref()) else { continue };
            if let Some(shown) = side.shown_again(view, last, &self.device) {
                locked(&self.shared.shown)[index] = Some(shown);
                (self.tell)(Event::Picture);
            }
        }
    }

    /// Shows where the two differ.
    fn compare(&mut self) -> Result<(), TraceError> {
        let Some(view) = self.view.clone() else { return Ok(()) };
        let [first, second] = &mut self.sides[..] else { return Ok(()) };
        self.compared = Some((Instant::now(), first.done));
        let Some((frame, mut film)) = first.whole_film(&view) else { return Ok(()) };
        let differing = match self.contrast {
            Contrast::Voxels => match self.other_voxels.take() {
                Some(known) => known,
                None => {
                    let rays = central_rays(&view);
                    differing_voxels(&first.cast(&rays)?, &second.cast(&rays)?)
                }
            },
            _ => match second.whole_film(&view) {
                Some((_, other)) => differing_pixels(&film, &other),
                None => return Ok(()),
            },
        };
        let count = blacken(&mut film, &differing);
        if self.contrast == Contrast::Voxels {
            self.other_voxels = Some(differing);
        }
        let mut picture = self.pictures.free(&self.device, frame.width, frame.height, true)?;
        // Nobody else holds a free picture.
        if let Some(picture) = Arc::get_mut(&mut picture) {
            picture.write(&film);
        }
        self.pictures.keep(&picture);
        let differences = Differences { picture, pixels: film.pixels.len() as u64, count, samples: frame.samples };
        *locked(&self.shared.differences) = Some(differences);
        (self.tell)(Event::Picture);
        Ok(())
    }
}
