//! What the filter knows without noise: the camera rays of a film's own samples, cast once more, say which part of each pixel's
//! light was seen directly, and on what surfaces the rest fell. They go on through mirrors and clear glass as the samples did. The processor
//! casts them for every tracer, so that all get the same bits.

use super::wavelet::luminance;
use crate::aov::clip;
use crate::bsdf::albedo_of;
use crate::film::Film;
use crate::frame::{Frame, Integrator};
use crate::integrator::path::Limits;
use crate::integrator::seen::{Seen, clear_medium_at, follow};
use crate::integrator::{DIMENSION_CAMERA, Path, cast_in_medium, essay};
use crate::light::Lights;
use crate::packed::PackedScene;
use crate::sampler::Sampler;
use crate::walk;
use glam::Vec3;
use rayon::prelude::*;
use std::ops::Range;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::ray::{Hit, Ray};

/// Camera rays that one thread casts at a time.
const RAYS_AT_A_TIME: usize = 4096;

/// Means over the samples of one pixel. Of samples that met nothing, albedo, normal and position are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeaturePixel {
    /// Radiance that comes without any bounce, mirrors and clear glass aside: emitters and sky.
    pub direct: Vec3,
    /// Share of light that the surfaces scatter, linear, times what mirrors and media leave of it on the way.
    pub albedo: Vec3,
    /// Normals, world space: shorter than one where the pixel shows several.
    pub normal: Vec3,
    /// Where the surfaces were met, from the camera's eye, world units.
    pub position: Vec3,
    /// Variance of those places along the normal, square world units.
    pub roughness: f32,
    /// Share of the samples that met a surface.
    pub coverage: f32,
    /// Variances of the luminances of `direct` and `albedo`, where clear glass sent some samples another way than most; else 0, because what
    /// samples of one pixel see besides differs by their places in it, which are spread evenly.
    pub chance: [f32; 2],
}

/// The features of a film's pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Features {
    /// One for each pixel of the film, row by row.
    pub pixels: Vec<FeaturePixel>,
}

impl Features {
    /// Casts the camera rays of all samples of `film`, which `frame` asked for, into the scene that it shows.
    pub fn of(scene: &PackedScene, frame: &Frame, film: &Film) -> Self {
        Self::of_film(scene, frame, film, &|| true)
    }

    /// As [`Self::of`], as long as it is `wanted`, which is asked now and then, on several threads, and which says no for good; `None` then.
    pub fn of_while(
        scene: &PackedScene,
        frame: &Frame,
        film: &Film,
        wanted: &(dyn Fn() -> bool + Sync),
    ) -> Option<Self> {
        let features = Self::of_film(scene, frame, film, wanted);
        wanted().then_some(features)
    }

    /// The features, or some of them where nobody wants them any more.
    fn of_film(scene: &PackedScene, frame: &Frame, film: &Film, wanted: &(dyn Fn() -> bool + Sync)) -> Self {
        let mut sums = vec![Sums::default(); film.pixels.len()];
        gather(scene, &frame.camera, (frame, film), 0..u32::MAX, &mut sums, wanted);
        Self { pixels: sums.iter().map(Sums::means).collect() }
    }

    /// As [`Self::of`], of a film whose samples show other moments each: `at` gives the scene and the camera of a sample.
    ///
    /// # Errors
    /// Those of `at`.
    pub fn of_moments<E>(
        frame: &Frame,
        film: &Film,
        mut at: impl FnMut(u32) -> Result<(PackedScene, Camera), E>,
    ) -> Result<Self, E> {
        let mut sums = vec![Sums::default(); film.pixels.len()];
        for sample in 0..film.sample_range().1 {
            let (scene, camera) = at(frame.first_sample + sample)?;
            gather(&scene, &camera, (frame, film), sample..sample + 1, &mut sums, &|| true);
        }
        Ok(Self { pixels: sums.iter().map(Sums::means).collect() })
    }
}

/// Adds what some samples of a film's pixels show, as long as that is wanted.
fn gather(
    scene: &PackedScene,
    camera: &Camera,
    (frame, film): (&Frame, &Film),
    samples: Range<u32>,
    sums: &mut [Sums],
    wanted: &(dyn Fn() -> bool + Sync),
) {
    let (lights, camera) = (Lights::new(scene), camera.frame(frame.width, frame.height));
    let width = film.region.width().max(1) as usize;
    sums.par_chunks_mut(width).enumerate().for_each(|(row, sums)| {
        let ends = film.pixels[row * width..][..width].iter().map(|pixel| pixel.samples.min(samples.end));
        let gather = Gather { scene, lights: &lights, frame, camera: &camera, y: film.region.y0 + row as u32, wanted };
        gather.row(film.region.x0, ends.map(|end| samples.start..end), sums);
    });
}

/// The rays of one row of pixels.
struct Gather<'a> {
    scene: &'a PackedScene,
    lights: &'a Lights<'a>,
    frame: &'a Frame,
    camera: &'a voxtrace_scene::camera::CameraFrame,
    y: u32,
    wanted: &'a (dyn Fn() -> bool + Sync),
}

impl Gather<'_> {
    fn row(&self, x0: u32, samples: impl Iterator<Item = Range<u32>>, sums: &mut [Sums]) {
        let samples = samples.zip(x0..).flat_map(|(samples, x)| samples.map(move |sample| (x, sample)));
        let mut batch = Vec::with_capacity(RAYS_AT_A_TIME);
        for sample in samples {
            batch.push(sample);
            if batch.len() == RAYS_AT_A_TIME {
                self.cast(x0, &batch, sums);
                batch.clear();
            }
        }
        self.cast(x0, &batch, sums);
    }

    /// Casts the rays of some samples, each a column and a number.
    fn cast(&self, x0: u32, samples: &[(u32, u32)], sums: &mut [Sums]) {
        if !(self.wanted)() {
            return;
        }
        let frame = self.frame;
        let start = |&(x, sample): &(u32, u32)| {
            let sampler =
                Sampler { seed: frame.seed, pixel: self.y * frame.width + x, sample: frame.first_sample + sample };
            let jitter = match frame.integrator {
                Integrator::Essay => sampler.independent(DIMENSION_CAMERA),
                Integrator::Path => sampler.stratified(DIMENSION_CAMERA),
            };
            let (path, ray) = Path::from_camera(self.camera, x, self.y, sampler, jitter);
            (path, clip(frame, ray))
        };
        let (paths, rays): (Vec<_>, Vec<_>) = samples.iter().map(start).unzip();
        let mut hits = vec![Hit::MISS; rays.len()];
        walk::cast_batch(self.scene, &rays, &mut hits);
        for (((path, ray), hit), (x, _)) in paths.iter().zip(&rays).zip(&hits).zip(samples) {
            let sums = &mut sums[(x - x0) as usize];
            sums.samples += 1;
            if frame.transparent && hit.is_miss() {
                continue;
            }
            let mut direct = Vec3::ZERO;
            let seen = self.seen(*path, ray, hit, &mut direct);
            sums.direct.add(direct);
            sums.albedo.add(seen.as_ref().map_or(Vec3::ZERO, |seen| seen.albedo));
            if let Some(seen) = seen {
                let place = seen.ray.at(seen.hit.t) - self.frame.camera.eye;
                sums.add(&seen, self.scene.shading_normal(&seen.ray, &seen.hit), place);
            }
        }
    }

    /// The surface that a sample shows, and adds to `direct` what is seen directly.
    fn seen(&self, path: Path, ray: &Ray, hit: &Hit, direct: &mut Vec3) -> Option<Seen> {
        let Self { scene, lights, frame, .. } = self;
        match frame.integrator {
            Integrator::Essay => {
                let material = path.material(scene, hit);
                essay::advance(scene, 0, &mut path.clone(), (ray, hit, material), |_| [0.0; 4], direct);
                let albedo = || albedo_of(scene.packed_material(hit));
                (!hit.is_miss()).then(|| Seen { ray: *ray, hit: *hit, albedo: albedo(), is_likely: true })
            }
            Integrator::Path => {
                let path = Path { inside: clear_medium_at(scene, ray), ..path };
                let hit = path.inside.map_or(*hit, |inside| cast_in_medium(scene, &path, &inside, ray));
                follow(scene, lights, &Limits::of(frame), path, (*ray, hit), direct)
            }
        }
    }
}

/// What is added up about a pixel.
#[derive(Clone, Copy, Default)]
struct Sums {
    samples: u32,
    direct: Moments,
    albedo: Moments,
    /// Of samples that glass sent the likelier way: what a pane reflects faintly must not move the place of what is behind it.
    likely: Places,
    /// Of the others: they count where there is nothing else.
    unlikely: Places,
}

/// What is added up about colours.
#[derive(Clone, Copy, Default)]
struct Moments {
    sum: Vec3,
    /// Of the luminance.
    squares: f32,
}

impl Moments {
    fn add(&mut self, color: Vec3) {
        self.sum += color;
        self.squares += luminance(color) * luminance(color);
    }

    /// Variance of the luminance of the mean of `1 / of_samples` samples.
    fn variance(&self, of_samples: f32) -> f32 {
        let mean = luminance(self.sum) * of_samples;
        (self.squares * of_samples - mean * mean).max(0.0) * of_samples
    }
}

/// What is added up about places.
#[derive(Clone, Copy, Default)]
struct Places {
    count: u32,
    normal: Vec3,
    /// The first place; the others are added up from there, so that squares stay exact enough.
    origin: Vec3,
    place: Vec3,
    /// Products of coordinates of places: xx, yy, zz and xy, yz, zx.
    squares: Vec3,
    mixed: Vec3,
}

impl Places {
    fn add(&mut self, normal: Vec3, place: Vec3) {
        if self.count == 0 {
            self.origin = place;
        }
        let place = place - self.origin;
        self.count += 1;
        self.normal += normal;
        self.place += place;
        self.squares += place * place;
        self.mixed += place * Vec3::new(place.y, place.z, place.x);
    }
}

impl Sums {
    fn add(&mut self, seen: &Seen, normal: Vec3, place: Vec3) {
        let places = if seen.is_likely { &mut self.likely } else { &mut self.unlikely };
        places.add(normal, place);
    }

    fn means(&self) -> FeaturePixel {
        let hits = self.likely.count + self.unlikely.count;
        let of_samples = 1.0 / self.samples.max(1) as f32;
        let direct = self.direct.sum * of_samples;
        if hits == 0 {
            return FeaturePixel { direct, ..FeaturePixel::default() };
        }
        let chance = if self.unlikely.count > 0 {
            [self.direct, self.albedo].map(|moments| moments.variance(of_samples))
        } else {
            [0.0; 2]
        };
        let places = if self.likely.count > 0 { &self.likely } else { &self.unlikely };
        let of_hits = 1.0 / places.count as f32;
        let (normal, mean) = (places.normal * of_hits, places.place * of_hits);
        let squares = places.squares * of_hits - mean * mean;
        let mixed = places.mixed * of_hits - mean * Vec3::new(mean.y, mean.z, mean.x);
        let along = normal * normal;
        let across = normal * Vec3::new(normal.y, normal.z, normal.x);
        let roughness = (along.dot(squares) + 2.0 * across.dot(mixed)).max(0.0) / normal.length_squared().max(1e-6);
        FeaturePixel {
            direct,
            albedo: self.albedo.sum * of_samples,
            normal,
            position: places.origin + mean,
            roughness,
            coverage: hits as f32 * of_samples,
            chance,
        }
    }
}
