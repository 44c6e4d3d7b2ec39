//! The paths of one tile, followed together bounce by bounce, so that the walk gets many rays at a time
//! (Laine, Karras, Aila, "Megakernels Considered Harmful", HPG 2013).

use super::ray_counts::RayCounts;
use super::shadow_rays::ShadowRays;
use super::tile::{Tile, in_blocks};
use crate::aov::clip;
use crate::cuts;
use crate::frame::{Frame, Integrator};
use crate::integrator::{DIMENSION_CAMERA, Path, cast_in_medium, essay, path};
use crate::light::many::Asked;
use crate::light::{self, LightSample, Lights};
use crate::packed::PackedScene;
use crate::sampler::Sampler;
use crate::sampler::many::{Draws, Numbers};
use crate::shadow_catcher::ShadowCatcher;
use crate::walk::{self, Instructions};
use glam::Vec3;
use std::ops::Range;
use voxtrace_scene::camera::CameraFrame;
use voxtrace_scene::ray::{Hit, Ray};

/// Paths that meet their surfaces together, for which lights are then chosen together.
const PATHS_AT_A_TIME: usize = light::many::CAPACITY;

/// What all paths of a frame share.
pub struct RenderContext<'a> {
    /// The scene.
    pub scene: &'a PackedScene,
    /// Its lights.
    pub lights: Lights<'a>,
    /// The frame.
    pub frame: &'a Frame,
    /// Its camera, made ready.
    pub camera: &'a CameraFrame,
    /// Whether paths enter voxels.
    pub has_media: bool,
    /// The ground, where it shows shadows alone.
    pub catcher: Option<ShadowCatcher<'a>>,
}

impl RenderContext<'_> {
    /// The random numbers of its paths.
    fn numbers(&self) -> Numbers {
        match self.frame.integrator {
            Integrator::Essay => Numbers::Independent,
            Integrator::Path => Numbers::Stratified,
        }
    }
}

/// Room for the paths of one tile, kept from tile to tile. `rays`, `paths` and `slots` belong to the paths still under
/// way, `samples` to all.
#[derive(Default)]
pub struct Wave {
    rays: Vec<Ray>,
    paths: Vec<Path>,
    slots: Vec<u32>,
    hits: Vec<Hit>,
    in_air: InAir,
    samples: Vec<Sample>,
    shadow_rays: ShadowRays,
    counts: RayCounts,
    /// Random numbers of paths, and those that choose lights.
    draws: Draws,
    light_draws: Draws,
    /// Places of some of these for which lights are to be chosen, and the lights.
    asked: Vec<Asked>,
    lights: Vec<Option<LightSample>>,
    room: light::many::Room,
}

/// The rays of a wave that are not in a medium, which are traced together: their places, the rays, and their hits.
#[derive(Default)]
struct InAir {
    places: Vec<usize>,
    rays: Vec<Ray>,
    hits: Vec<Hit>,
}

/// One sample of one pixel of the tile.
struct Sample {
    row: u32,
    column: u32,
    radiance: Vec3,
    covered: bool,
    /// Where the sample is one of the shadow on the ground: the threshold of [`ShadowCatcher::is_covered`]; its radiance is then what came through.
    threshold: Option<f32>,
}

impl Wave {
    /// Brings each pixel of the tile up to `target` samples. Returns the rays that it took; those of the camera are the samples that it added.
    pub fn render(&mut self, context: &RenderContext, tile: &mut Tile, target: u32) -> RayCounts {
        self.start(context, tile, target);
        self.counts = RayCounts { camera: self.rays.len() as u64, ..RayCounts::default() };
        let mut from_camera = true;
        while !self.rays.is_empty() {
            self.cast(context);
            if !from_camera {
                self.counts.bounce += self.rays.len() as u64;
            }
            if from_camera {
                for ((sample, hit), path) in self.samples.iter_mut().zip(&self.hits).zip(&self.paths) {
                    sample.covered = !hit.is_miss() || path.inside.is_some();
                }
                from_camera = false;
            }
            self.advance(context);
            self.gather_light(context);
        }
        for sample in &self.samples {
            let (radiance, covered) = match sample.threshold {
                None => (sample.radiance, sample.covered),
                Some(threshold) => (Vec3::ZERO, ShadowCatcher::is_covered(sample.radiance, threshold)),
            };
            tile.rows[sample.row as usize][sample.column as usize].add(radiance, covered);
        }
        self.counts
    }

    /// Sends the camera rays.
    fn start(&mut self, context: &RenderContext, tile: &Tile, target: u32) {
        let frame = context.frame;
        self.draws.begin(frame.seed);
        self.samples.clear();
        self.paths.clear();
        self.rays.clear();
        self.slots.clear();
        for (column, row) in in_blocks(tile.region.width(), tile.region.height()) {
            let (x, y) = (tile.region.x0 + column, tile.region.y0 + row);
            let first = tile.rows[row as usize][column as usize].samples;
            for sample in first..target {
                let sampler =
                    Sampler { seed: frame.seed, pixel: y * frame.width + x, sample: frame.first_sample + sample };
                self.draws.push(&sampler, DIMENSION_CAMERA);
                self.samples.push(Sample { row, column, radiance: Vec3::ZERO, covered: false, threshold: None });
            }
        }
        self.draws.draw(context.numbers(), Instructions::chosen());
        for (slot, sample) in self.samples.iter().enumerate() {
            let (x, y) = (tile.region.x0 + sample.column, tile.region.y0 + sample.row);
            let sampler = self.draws.sampler(slot);
            let (mut path, ray) = Path::from_camera(context.camera, x, y, sampler, self.draws.get(slot));
            if context.has_media {
                path = path.in_medium(context.scene, &ray);
            }
            self.slots.push(slot as u32);
            self.paths.push(path);
            self.rays.push(clip(frame, ray));
        }
    }

    /// Finds what the rays meet.
    fn cast(&mut self, context: &RenderContext) {
        self.hits.resize(self.rays.len(), Hit::MISS);
        let scene = context.scene;
        if !context.has_media {
            self.counts.walks += match scene.cuts.is_none() {
                true => walk::cast_batch_whole(scene, &self.rays, &mut self.hits),
                false => cuts::cast_batch(scene, &self.rays, &mut self.hits, |index| self.paths[index].is_clipped),
            };
            return;
        }
        let InAir { places, rays, hits } = &mut self.in_air;
        places.clear();
        rays.clear();
        for (place, (path, ray)) in self.paths.iter().zip(&self.rays).enumerate() {
            match &path.inside {
                Some(inside) => self.hits[place] = cast_in_medium(scene, path, inside, ray),
                None => {
                    places.push(place);
                    rays.push(*ray);
                }
            }
        }
        hits.resize(rays.len(), Hit::MISS);
        self.counts.walks += match scene.cuts.is_none() {
            true => walk::cast_batch_whole(scene, rays, hits),
            false => cuts::cast_batch(scene, rays, hits, |index| self.paths[places[index]].is_clipped),
        };
        for (&place, hit) in places.iter().zip(hits) {
            self.hits[place] = *hit;
        }
    }

    /// Takes every path one bounce further and compacts the active paths.
    fn advance(&mut self, context: &RenderContext) {
        let mut under_way = Vec::with_capacity(PATHS_AT_A_TIME);
        let mut alive = 0;
        for first in (0..self.rays.len()).step_by(PATHS_AT_A_TIME) {
            let end = self.rays.len().min(first + PATHS_AT_A_TIME);
            self.arrive(context, first..end, &mut under_way);
            self.leave(context, &mut under_way, &mut alive);
        }
        self.rays.truncate(alive);
        self.paths.truncate(alive);
        self.slots.truncate(alive);
    }

    /// Adds the light where the rays of some paths ended. `under_way` gets those that go on, with what becomes of them.
    fn arrive<'a>(
        &mut self,
        context: &RenderContext<'a>,
        range: Range<usize>,
        under_way: &mut Vec<(usize, path::Arrival<'a>)>,
    ) {
        let (scene, max_bounces) = (context.scene, context.frame.max_bounces);
        let limits = path::Limits::of(context.frame);
        self.asked.clear();
        let mut materials = [0; PATHS_AT_A_TIME];
        let (paths, hits) = (&self.paths[range.clone()], &self.hits[range.clone()]);
        scene.packed_material_indices(hits, |index| paths[index].meets_surface(&hits[index]), &mut materials);
        let seed = context.frame.seed;
        self.draws.begin(seed);
        self.light_draws.begin(seed);
        paths.iter().for_each(|path| self.draws.push(&path.sampler, path.dimension_scatter()));
        self.draws.draw(context.numbers(), Instructions::chosen());
        for (place, (index, material)) in range.zip(materials).enumerate() {
            let drawn = self.draws.get(place);
            let (path, slot) = (&mut self.paths[index], self.slots[index]);
            let sample = &mut self.samples[slot as usize];
            let (ray, hit) = (&self.rays[index], &self.hits[index]);
            if context.frame.transparent && path.event == 0 && path.inside.is_none() {
                if hit.is_miss() {
                    continue;
                }
                if let Some(catcher) = context.catcher.as_ref().filter(|catcher| catcher.is_met(scene, hit)) {
                    sample.threshold = Some(ShadowCatcher::threshold(path));
                    match catcher.shadow_ray(scene, path, ray, hit) {
                        Some(shadow_ray) => self.shadow_rays.push(scene, slot, &shadow_ray),
                        None => sample.radiance = Vec3::ONE,
                    }
                    continue;
                }
            }
            let radiance = &mut sample.radiance;
            let arrival = match context.frame.integrator {
                Integrator::Essay => {
                    match essay::advance(scene, max_bounces, path, (ray, hit, material), |_| drawn, radiance) {
                        None => path::Arrival::End,
                        Some(next) => path::Arrival::Pass(next),
                    }
                }
                Integrator::Path => {
                    path::arrive(scene, &context.lights, &limits, path, (ray, hit, material), |_| drawn, radiance)
                }
            };
            match &arrival {
                path::Arrival::End => continue,
                path::Arrival::Scatter(scatter) if scatter.wants_light => {
                    self.light_draws.push(&path.sampler, path.dimension_light());
                    self.asked.push(Asked { receiver: *scatter.receiver(), u: [0.0; 4] });
                }
                _ => {}
            }
            under_way.push((index, arrival));
        }
        self.light_draws.draw(Numbers::Stratified, Instructions::chosen());
        for (place, asked) in self.asked.iter_mut().enumerate() {
            asked.u = self.light_draws.get(place);
        }
    }

    /// Chooses lights for the paths that are to be scattered, and lets all that are under way leave.
    fn leave<'a>(
        &mut self,
        context: &RenderContext<'a>,
        under_way: &mut Vec<(usize, path::Arrival<'a>)>,
        alive: &mut usize,
    ) {
        let (scene, limits) = (context.scene, path::Limits::of(context.frame));
        self.lights.resize(self.asked.len(), None);
        light::many::sample_all(Instructions::chosen(), &context.lights, &self.asked, &mut self.room, &mut self.lights);
        let mut lights = self.lights.iter();
        for (index, arrival) in under_way.drain(..) {
            let (path, slot) = (&mut self.paths[index], self.slots[index]);
            let (next, shadow_ray) = match &arrival {
                path::Arrival::End => (None, None),
                path::Arrival::Pass(next) => (Some(*next), None),
                path::Arrival::Scatter(scatter) => {
                    let light = if scatter.wants_light { lights.next().and_then(Option::as_ref) } else { None };
                    path::leave(scene, &limits, path, (&self.rays[index], &self.hits[index]), scatter, light)
                }
            };
            if let Some(shadow_ray) = shadow_ray {
                self.shadow_rays.push(scene, slot, &shadow_ray);
            }
            if let Some(next) = next {
                (self.rays[*alive], self.paths[*alive], self.slots[*alive]) = (next, self.paths[index], slot);
                *alive += 1;
            }
        }
    }

    /// Adds the light that arrives along the shadow rays.
    fn gather_light(&mut self, context: &RenderContext) {
        let samples = &mut self.samples;
        self.shadow_rays.gather(context, &mut self.counts, |slot, light| samples[slot as usize].radiance += light);
    }
}
