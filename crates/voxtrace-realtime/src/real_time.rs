//! Frame after frame.

use crate::antialiasing::{Rest, antialiased, word_of};
use crate::confidence::{Change, Found, paths_left};
use crate::filter::filter;
use crate::half_rate::{Rate, Samples};
use crate::light_cache::{LightCache, Request};
use crate::memory::Memory;
use crate::movers::{Movers, Stood, moved};
use crate::path::{Sample, View};
use crate::reprojection::{Before, is_cut};
use crate::visibility::Visibility;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use voxtrace_core::Frame;
use voxtrace_core::integrator::DIMENSION_CAMERA;
use voxtrace_core::integrator::path::Limits;
use voxtrace_core::light::Lights;
use voxtrace_core::packed::{PackedInstance, PackedScene};
use voxtrace_core::sampler::{Sampler, shifted};
use voxtrace_scene::Camera;
use voxtrace_scene::camera::CameraFrame;
use voxtrace_scene::transform::Transform;

/// Mixed into the user's seed, so that no sample of here is one of the film.
const SEED: u32 = 0x9e37_79b9;
/// The same, for rays that only look.
const LOOK_SEED: u32 = 0x85eb_ca6b;
/// The same, for the light cache.
const CACHE_SEED: u32 = 0x5bd1_e995;
/// Samples that cells of the light cache remember while things move.
pub(crate) const SAMPLES_WHILE_MOVING: f32 = 8.0;
/// Lights of which a surface chooses one, and where it is known how often they are seen.
pub(crate) const CANDIDATES: [u32; 2] = [8, 4];
/// Rays of the camera that a pixel has seen at least since the view moved: those beyond its paths find no light.
pub(crate) const LEAST_LOOKS: f32 = 4.0;
/// The same where they do not see the same, while nothing moves.
pub(crate) const MOST_LOOKS: f32 = 16.0;
/// Frames whose paths are in the first picture of a view of which nothing is known.
pub const FRAMES_AT_A_CUT: u32 = 4;
/// Paths that a pixel remembers while something moves, and while nothing does.
pub(crate) const MOST_PATHS: [f32; 2] = [32.0, 1e6];
/// The same of pixels that show nothing that moved, while something does.
const MOST_PATHS_AT_REST: f32 = 256.0;

/// What is used: all of it, but where one wants to know what a part is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// What the frames before know.
    pub memory: bool,
    /// The light cache.
    pub cache: bool,
    /// The filter.
    pub filter: bool,
    /// More than one candidate for the first light, and rays that only look.
    pub candidates: bool,
    /// How often rays to lights arrive, which the steps of the light cache keep; with it there are fewer candidates.
    pub visibility: bool,
    /// The paths of several frames in the first picture of a view.
    pub cuts: bool,
}

impl Parts {
    /// All.
    pub const ALL: Self =
        Self { memory: true, cache: true, filter: true, candidates: true, visibility: true, cuts: true };
    /// One path a pixel, as the integrator's.
    pub const NONE: Self =
        Self { memory: false, cache: false, filter: false, candidates: false, visibility: false, cuts: false };

    /// Whether candidates are weighed by how often rays to lights arrive.
    pub(crate) fn weigh(self) -> bool {
        self.candidates && self.cache && self.visibility
    }

    /// Lights of which a surface chooses one.
    pub(crate) fn candidates(self) -> u32 {
        if self.candidates { CANDIDATES[usize::from(self.weigh())] } else { 1 }
    }
}

impl Parts {
    /// How many frames' paths the next picture has, after one of `before`.
    #[doc(hidden)]
    pub fn frames_of_picture(&self, before: Option<&Frame>, frame: &Frame) -> u32 {
        let is_first = before.is_none_or(|before| is_cut(before, frame));
        if self.memory && self.cuts && is_first { FRAMES_AT_A_CUT } else { 1 }
    }
}

/// Real-time light of a view: what it knows from frame to frame.
pub struct RealTime {
    parts: Parts,
    rate: Rate,
    cache: LightCache,
    visibility: Visibility,
    memory: Vec<Memory>,
    /// What the paths of the last frame found.
    samples: Vec<Sample>,
    before: Option<FrameBefore>,
    /// Number of the next frame.
    number: u32,
    /// Whether light may have changed since the last frame.
    has_changed: bool,
    /// Where instances were at the last frame, where they are elsewhere now.
    stood: Option<Vec<Stood>>,
    /// Whether something else changed since the last frame.
    is_edited: bool,
    /// Those that have moved since the camera stands.
    movers: Movers,
    /// How many there were at the last frame, and whether others stood there since.
    instances: Option<usize>,
    has_other_instances: bool,
    /// Since something moved.
    rest: Rest,
}

/// What is kept of the last frame.
struct FrameBefore {
    frame: Frame,
    camera: CameraFrame,
    found: Found,
}

impl RealTime {
    /// One that knows nothing.
    pub fn new(parts: Parts) -> Self {
        let cache = LightCache::new(LightCache::CAPACITY, LightCache::BUDGET);
        Self {
            parts,
            rate: Rate::Full,
            cache,
            visibility: Visibility::default(),
            memory: Vec::new(),
            samples: Vec::new(),
            before: None,
            number: 0,
            has_changed: false,
            stood: None,
            is_edited: false,
            movers: Movers::default(),
            instances: None,
            has_other_instances: false,
            rest: Rest::LONG,
        }
    }

    /// How many pixels trace from the next frame on.
    pub fn set_rate(&mut self, rate: Rate) {
        self.rate = rate;
    }

    /// What the paths of the last frame found, for tests of what does the same.
    #[doc(hidden)]
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// Voxels, materials or lights of the scene are others now.
    pub fn change(&mut self) {
        (self.has_changed, self.is_edited) = (true, true);
        self.cache.doubt(0.0);
    }

    /// Instances stand elsewhere now; `before` is where they stood, in the same order. Where there are more or fewer of them now nothing is known any more.
    pub fn move_instances(&mut self, before: &[PackedInstance]) {
        self.has_changed = true;
        self.cache.doubt(SAMPLES_WHILE_MOVING);
        let stood = self.stood.get_or_insert_with(|| before.iter().map(Stood::of).collect());
        // Others stood there since the last frame.
        self.has_other_instances |= stood.len() != before.len();
    }

    /// What is known of each pixel.
    pub fn memory(&self) -> &[Memory] {
        &self.memory
    }

    /// Number of cells of the light cache.
    pub fn cells(&self) -> usize {
        self.cache.len()
    }

    /// The radiance of each pixel of the next frame, row by row; of `frame`, the camera, size, seed and the settings of light count.
    pub fn frame(&mut self, scene: &PackedScene, frame: &Frame) -> Vec<Vec3> {
        let instances = scene.instances().len();
        let are_others = |known: usize| known != instances;
        let before = self.stood.as_ref().map(Vec::len);
        if self.has_other_instances || before.is_some_and(are_others) || self.instances.is_some_and(are_others) {
            // Cells of the light cache and motions go by the numbers of instances.
            *self = Self { number: self.number, rate: self.rate, ..Self::new(self.parts) };
        }
        self.instances = Some(instances);
        for _ in 0..self.parts.frames_of_picture(self.before.as_ref().map(|before| &before.frame), frame) {
            self.follow(scene, frame);
        }
        let width = frame.width as usize;
        let mut picture = match self.parts.filter {
            true => filter(&self.memory, width),
            false => self.memory.par_iter().map(|memory| memory.radiance(memory.irradiance())).collect(),
        };
        if self.parts.filter && self.rest.share() < 1.0 {
            picture = antialiased(&self.memory, &picture, width, self.rest.share(), self.movers.keep());
        }
        self.memory.par_iter_mut().zip(&picture).for_each(|(memory, color)| memory.shown = word_of(*color));
        picture
    }

    /// Follows the paths of a frame.
    fn follow(&mut self, scene: &PackedScene, frame: &Frame) {
        let (width, height) = (frame.width, frame.height);
        let movers = self.movers_of(scene, frame);
        let view = self.view(scene, frame, &movers);
        let (light, mut requests) = match self.parts.cache {
            true => self.cache.trace(&view, self.number, frame.seed ^ CACHE_SEED),
            false => Default::default(),
        };
        let (samples, asked) = self.trace(&view, frame);
        requests.extend(asked);
        let (memory, rest) = self.remember(&view, frame, &samples);
        let found = Found::of(&View { cache: None, visibility: None, ..view }, frame, self.number);
        let scramble = view.scramble;
        if self.parts.weigh() {
            self.visibility.update();
        }
        self.cache.insert(&requests);
        self.cache.update(&light, scramble);
        let camera = frame.camera.frame(width, height);
        self.before = Some(FrameBefore { frame: frame.clone(), camera, found });
        (self.memory, self.samples, self.rest, self.movers) = (memory, samples, rest, movers);
        (self.stood, self.has_changed, self.is_edited) = (None, false, false);
        self.number += 1;
    }

    fn view<'a>(&'a self, scene: &'a PackedScene, frame: &Frame, movers: &'a Movers) -> View<'a> {
        View {
            scene,
            lights: Lights::new(scene),
            limits: Limits::of(frame),
            camera: frame.camera.frame(frame.width, frame.height),
            eye: frame.camera.eye,
            view_angle: view_angle(&frame.camera),
            has_media: scene.has_media(),
            candidates: self.parts.candidates(),
            cache: self.parts.cache.then_some(&self.cache),
            movers,
            visibility: self.parts.weigh().then_some(&self.visibility),
            scramble: Request::scramble_of(self.number),
        }
    }

    /// One path of each pixel, and what they asked of the light cache.
    fn trace(&self, view: &View, frame: &Frame) -> (Vec<Sample>, Vec<Request>) {
        let row = |y: u32| {
            let mut requests = Vec::new();
            let mut pixel = |x: u32| {
                if !self.rate.traces(x, y, self.number) {
                    return Sample::default();
                }
                let index = y * frame.width + x;
                let learns = Visibility::learns(index, frame.width * frame.height, self.number);
                view.sample(x, y, sampler(frame, self.number, index), learns, &mut requests)
            };
            let samples: Vec<Sample> = (0..frame.width).map(&mut pixel).collect();
            (samples, requests)
        };
        let (samples, requests): (Vec<_>, Vec<_>) = (0..frame.height).into_par_iter().map(row).unzip();
        (samples.into_iter().flatten().collect(), requests.into_iter().flatten().collect())
    }

    /// The frame before one of which something is known, and whether it saw the same.
    fn before_of(&self, frame: &Frame) -> (Option<&FrameBefore>, bool) {
        let before = self.before.as_ref().filter(|before| self.parts.memory && before.frame.seed == frame.seed);
        let is_same_view = before.is_some_and(|before| {
            before.frame.camera == frame.camera
                && (before.frame.width, before.frame.height) == (frame.width, frame.height)
        });
        (before, is_same_view)
    }

    /// Those that have moved by this frame since the camera stands.
    fn movers_of(&self, scene: &PackedScene, frame: &Frame) -> Movers {
        let stood = self.stood.as_deref().unwrap_or_default();
        self.movers.after(moved(stood, scene.instances()), self.before_of(frame).1 && !self.is_edited)
    }

    /// What is known of each pixel now, and since when nothing moves.
    fn remember(&self, view: &View, frame: &Frame, samples: &[Sample]) -> (Vec<Memory>, Rest) {
        let (before, is_same_view) = self.before_of(frame);
        let movers = view.movers;
        let is_still = is_same_view && !self.has_changed;
        let most = MOST_PATHS[usize::from(is_still)];
        let memory = match before {
            Some(before) if self.has_changed => self.doubted(view, before),
            _ => self.memory.clone(),
        };
        let motions = self.motions(view.scene);
        // In motion each frame would look anew, at everything.
        let is_in_motion = before.is_some() && !(is_same_view && motions.is_empty());
        let most_looks = if is_in_motion { LEAST_LOOKS } else { MOST_LOOKS };
        let pixel_width = view.view_angle / frame.height as f32;
        let size = [frame.width, frame.height];
        let samples = Samples { samples, size, rate: self.rate, number: self.number };
        let pixel = |index: usize| {
            let sample = samples.at(index);
            let (x, y) = (index as u32 % frame.width, index as u32 / frame.width);
            let mut known = match before {
                None => Memory::default(),
                Some(_) if is_still => memory[index],
                Some(_) if is_same_view && motions.is_empty() => memory[index].look_anew(),
                Some(_) if movers.keep() && memory[index].is_at_rest && !sample.sees_mover => memory[index],
                Some(before) => {
                    let ray = frame_ray(view, x, y);
                    let size = [before.frame.width, before.frame.height];
                    let distance = sample.shown.map_or(0.0, |shown| (shown.place - view.eye).length());
                    let before = Before { memory: &memory, camera: &before.camera, size, motions: &motions };
                    before.memory_of(&sample, &ray, pixel_width * distance)
                }
            };
            if !samples.traced(index) {
                let is_lit = known.paths > 0.0;
                if (is_still || known.is_at_rest) && is_lit {
                    return known;
                }
                for sample in samples.beside(index) {
                    if is_lit { known.look(&sample) } else { known.add(&sample, most) }
                }
                return known;
            }
            let is_at_rest = known.is_at_rest || known.looks == 0.0;
            // Where something moves those alone are at rest here that keep what they know.
            known.add(&sample, if known.is_at_rest { most.max(MOST_PATHS_AT_REST) } else { most });
            known.is_at_rest = is_at_rest && !sample.sees_mover;
            // Rays that only look go between the path's and each other.
            let jitter = sampler(frame, self.number, index as u32).stratified(DIMENSION_CAMERA);
            let (mut looks, mut differs) = (0, false);
            while self.parts.candidates && known.looks < if differs { most_looks } else { LEAST_LOOKS } {
                looks += 1;
                let sample_number = MOST_LOOKS as u32 * self.number + looks;
                let sampler = Sampler { seed: frame.seed ^ LOOK_SEED, pixel: index as u32, sample: sample_number };
                let seen = view.look(x, y, sampler, shifted(jitter, looks));
                differs |= seen.differs(&sample);
                known.is_at_rest &= !seen.sees_mover;
                known.look(&seen);
            }
            known
        };
        let memory = (0..samples.samples.len()).into_par_iter().map(pixel).collect();
        (memory, self.rest.after(is_in_motion, is_still))
    }

    /// What was known of each pixel of the frame before, less where light changed.
    fn doubted(&self, view: &View, before: &FrameBefore) -> Vec<Memory> {
        let then = View { camera: before.camera, eye: before.frame.camera.eye, cache: None, visibility: None, ..*view };
        let now = Found::of(&then, &before.frame, self.number.wrapping_sub(1));
        let changed = before.found.changes(&now, &then);
        let doubt = |(memory, change): (&Memory, Change)| {
            let mut memory = *memory;
            memory.doubt(paths_left(memory.paths, change.share));
            memory.darken(change.scale);
            memory
        };
        self.memory.par_iter().zip(changed).map(doubt).collect()
    }

    /// For each instance that stands elsewhere, the world then from the world now; empty where none does.
    fn motions(&self, scene: &PackedScene) -> Vec<Option<Transform>> {
        let Some(before) = &self.stood else { return Vec::new() };
        let motion = |(Stood { world_from_grid: before, .. }, now): (&Stood, &PackedInstance)| {
            (*before != now.world_from_grid).then(|| before.after(&now.grid_from_world))
        };
        before.iter().zip(scene.instances()).map(motion).collect()
    }
}

/// What the picture's height sees, radians: about, where that is much.
pub fn view_angle(camera: &Camera) -> f32 {
    2.0 * (0.5 * camera.fov_y).to_radians().tan()
}

/// The random numbers of a pixel's path.
fn sampler(frame: &Frame, number: u32, pixel: u32) -> Sampler {
    Sampler { seed: frame.seed ^ SEED, pixel, sample: number }
}

/// The ray through the middle of a pixel.
fn frame_ray(view: &View, x: u32, y: u32) -> voxtrace_scene::ray::Ray {
    use voxtrace_scene::camera::Projection;
    view.camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5), Vec2::splat(0.5))
}
