//! The paths of one tile, followed together bounce by bounce, so that the walk gets many rays at a time
//! (Laine, Karras, Aila, "Megakernels Considered Harmful", HPG 2013).

use super::in_media::InMedia;
use super::ray_counts::RayCounts;
use super::shadow_rays::ShadowRays;
use super::tile::{Tile, in_blocks};
use crate::aov::clip;
use crate::cuts;
use crate::frame::{Frame, Integrator};
use crate::integrator::{DIMENSION_CAMERA, Path, essay, path, unscattered_part};
use crate::light::many::Asked;
use crate::light::{self, LightSample, Lights};
use crate::medium::Surrounding;
use crate::packed::PackedScene;
use crate::sampler::many::{Draws, Numbers};
use crate::shadow_catcher::ShadowCatcher;
use crate::walk::{self, Instructions};
use glam::Vec3;
use std::ops::Range;
use voxtrace_scene::camera::{CameraFrame, Projection};
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
    /// The medium around all else.
    pub surrounding: Option<&'a Surrounding>,
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
    in_media: InMedia,
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
            let added = tile.rows[row as usize][column as usize].samples..target;
            let (start, pixel) = (frame.first_sample, y * frame.width + x);
            self.draws.push_samples(pixel, start + added.start..start + added.end, DIMENSION_CAMERA);
            let samples = added.map(|_| Sample { row, column, radiance: Vec3::ZERO, covered: false, threshold: None });
            self.samples.extend(samples);
        }
        self.draws.draw(context.numbers(), Instructions::chosen());
        self.slots.extend(0..self.samples.len() as u32);
        // Which kind it is is not asked again for each ray.
        match context.camera {
            CameraFrame::Perspective(camera) => self.send(context, tile, camera),
            camera => self.send(context, tile, camera),
        }
    }

    /// Sends the rays of all samples through a camera.
    #[inline(always)]
    fn send(&mut self, context: &RenderContext, tile: &Tile, camera: &impl Projection) {
        let (draws, corner) = (&self.draws, (tile.region.x0, tile.region.y0));
        let rays = self.samples.iter().enumerate().map(|(slot, sample)| {
            let (x, y) = (corner.0 + sample.column, corner.1 + sample.row);
            clip(context.frame, Path::camera_ray(camera, x, y, draws.get(slot)))
        });
        self.rays.extend(rays);
        self.paths.extend((0..self.samples.len()).map(|slot| Path::from_sampler(draws.sampler(slot))));
        if context.has_media {
            self.paths.iter_mut().zip(&self.rays).for_each(|(path, ray)| *path = path.in_medium(context.scene, ray));
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
        let rays = self.paths.iter().zip(&self.rays).map(|(path, ray)| {
            let part = path.inside.map_or(*ray, |inside| unscattered_part(scene, path, &inside, ray));
            (part, path.inside, path.is_clipped)
        });
        self.counts.walks += self.in_media.cast(context, rays, &mut self.hits);
    }

    /// Takes every path one bounce further and compacts the active paths.
    fn advance(&mut self, context: &RenderContext) {
        let mut under_way = Vec::with_capacity(PATHS_AT_A_TIME);
        let mut alive = 0;
        for first in (0..self.rays.len()).step_by(PATHS_AT_A_TIME) {
            let range = first..self.rays.len().min(first + PATHS_AT_A_TIME);
            let materials = self.look_up(context, range.clone());
            self.arrive(context, range, &materials, &mut under_way, &mut alive);
            if !under_way.is_empty() {
                self.leave(context, &mut under_way, &mut alive);
            }
        }
        self.rays.truncate(alive);
        self.paths.truncate(alive);
        self.slots.truncate(alive);
    }

    /// Finds the materials that some paths met, and draws the random numbers that scatter them.
    fn look_up(&mut self, context: &RenderContext, range: Range<usize>) -> [u32; PATHS_AT_A_TIME] {
        let mut materials = [0; PATHS_AT_A_TIME];
        let (paths, hits) = (&self.paths[range.clone()], &self.hits[range]);
        context.scene.packed_material_indices(hits, |index| paths[index].meets_surface(&hits[index]), &mut materials);
        self.draws.begin(context.frame.seed);
        paths.iter().for_each(|path| self.draws.push(&path.sampler, path.dimension_scatter()));
        self.draws.draw(context.numbers(), Instructions::chosen());
        materials
    }

    /// Whether a path of a transparent picture ends as its camera's ray met nothing, or the ground that shows shadows alone.
    #[inline(never)]
    fn ends_transparent(&mut self, context: &RenderContext, index: usize) -> bool {
        let (path, slot, hit) = (&self.paths[index], self.slots[index], &self.hits[index]);
        if path.event > 0 || path.inside.is_some() {
            return false;
        }
        if hit.is_miss() {
            return true;
        }
        let scene = context.scene;
        let Some(catcher) = context.catcher.as_ref().filter(|catcher| catcher.is_met(scene, hit)) else { return false };
        let sample = &mut self.samples[slot as usize];
        sample.threshold = Some(ShadowCatcher::threshold(path));
        match catcher.shadow_ray(scene, path, &self.rays[index], hit) {
            Some(shadow_ray) => self.shadow_rays.push(scene, slot, &shadow_ray),
            None => sample.radiance = Vec3::ONE,
        }
        true
    }

    /// Adds the light where the rays of some paths ended. Of the integrator `essay` those that go on are kept behind the `alive` ones before them;
    /// `under_way` gets those of the integrator `path` that go on, with what becomes of them.
    fn arrive(
        &mut self,
        context: &RenderContext,
        range: Range<usize>,
        materials: &[u32],
        under_way: &mut Vec<(u32, path::Arrival)>,
        alive: &mut usize,
    ) {
        let (scene, max_bounces) = (context.scene, context.frame.max_bounces);
        let limits = path::Limits::of(context.frame);
        for (place, index) in range.enumerate() {
            if context.frame.transparent && self.ends_transparent(context, index) {
                continue;
            }
            let (path, slot) = (&mut self.paths[index], self.slots[index]);
            let met = (&self.rays[index], &self.hits[index], materials[place]);
            let (draw, radiance) = (|_: &Path| self.draws.get(place), &mut self.samples[slot as usize].radiance);
            match context.frame.integrator {
                Integrator::Essay => {
                    if let Some(next) = essay::advance(scene, max_bounces, path, met, draw, radiance) {
                        (self.rays[*alive], self.paths[*alive], self.slots[*alive]) = (next, *path, slot);
                        *alive += 1;
                    }
                }
                Integrator::Path => {
                    let arrival = path::arrive(scene, &context.lights, &limits, path, met, draw, radiance);
                    under_way.push((index as u32, arrival));
                    if let Some((_, path::Arrival::End)) = under_way.last() {
                        under_way.pop();
                    }
                }
            }
        }
    }

    /// Chooses lights for those that are to be scattered.
    fn choose_lights(&mut self, context: &RenderContext, under_way: &[(u32, path::Arrival)]) {
        self.light_draws.begin(context.frame.seed);
        let mut count = 0;
        for (index, arrival) in under_way {
            if let path::Arrival::Scatter(scatter) = arrival
                && scatter.wants_light
            {
                let path = &self.paths[*index as usize];
                self.light_draws.push(&path.sampler, path.dimension_light());
                if count == self.asked.len() {
                    self.asked.push(Asked::default());
                }
                // Written where it stays: a copy of what was just written in other pieces waits until that is in the cache.
                self.asked[count].receiver = *scatter.receiver();
                count += 1;
            }
        }
        self.asked.truncate(count);
        self.light_draws.draw(Numbers::Stratified, Instructions::chosen());
        for (place, asked) in self.asked.iter_mut().enumerate() {
            asked.u = self.light_draws.get(place);
        }
        self.lights.resize(self.asked.len(), None);
        light::many::sample_all(Instructions::chosen(), &context.lights, &self.asked, &mut self.room, &mut self.lights);
    }

    /// Lets all paths that are under way leave.
    fn leave(&mut self, context: &RenderContext, under_way: &mut Vec<(u32, path::Arrival)>, alive: &mut usize) {
        let (scene, limits) = (context.scene, path::Limits::of(context.frame));
        self.choose_lights(context, under_way);
        let mut lights = self.lights.iter();
        for &(index, ref arrival) in &*under_way {
            let index = index as usize;
            let (path, slot) = (&mut self.paths[index], self.slots[index]);
            let next = match arrival {
                path::Arrival::End => None,
                path::Arrival::Pass(next) => Some(*next),
                path::Arrival::Scatter(scatter) => {
                    let light = if scatter.wants_light { lights.next().and_then(Option::as_ref) } else { None };
                    if let Some(sample) = light
                        && let Some(shadow_ray) = path::shadow_ray(scene, &limits, path, scatter, sample)
                    {
                        self.shadow_rays.push(scene, slot, &shadow_ray);
                    }
                    path::leave(scene, &limits, path, (&self.rays[index], &self.hits[index]), scatter)
                }
            };
            if let Some(next) = next {
                (self.rays[*alive], self.paths[*alive], self.slots[*alive]) = (next, self.paths[index], slot);
                *alive += 1;
            }
        }
        under_way.clear();
    }

    /// Adds the light that arrives along the shadow rays.
    fn gather_light(&mut self, context: &RenderContext) {
        let samples = &mut self.samples;
        self.shadow_rays.gather(context, &mut self.counts, |slot, light| samples[slot as usize].radiance += light);
    }
}
