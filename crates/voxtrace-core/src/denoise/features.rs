//! What the filter knows without noise: the camera rays of a film's own samples, cast once more, say which part of each pixel's
//! light was seen directly, and on what surfaces the rest fell. The processor casts them for every tracer, so that all get the same bits.

use crate::aov::clip;
use crate::bsdf::albedo_of;
use crate::film::Film;
use crate::frame::{Frame, Integrator};
use crate::integrator::{DIMENSION_CAMERA, Path, essay, path};
use crate::light::Lights;
use crate::packed::PackedScene;
use crate::sampler::Sampler;
use crate::walk;
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_scene::ray::Hit;

/// Camera rays that one thread casts at a time.
const RAYS_AT_A_TIME: usize = 4096;

/// Means over the samples of one pixel. Of samples that met nothing, albedo, normal and position are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeaturePixel {
    /// Radiance that comes without any bounce: emitters and sky.
    pub direct: Vec3,
    /// Share of light that the surfaces scatter, linear.
    pub albedo: Vec3,
    /// Normals, world space: shorter than one where the pixel shows several.
    pub normal: Vec3,
    /// Where the surfaces were met, from the camera's eye, world units.
    pub position: Vec3,
    /// Variance of those places along the normal, square world units.
    pub roughness: f32,
    /// Share of the samples that met a surface.
    pub coverage: f32,
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
        let camera = frame.camera.frame(frame.width, frame.height);
        let lights = Lights::new(scene);
        let width = film.region.width().max(1) as usize;
        let mut pixels = vec![FeaturePixel::default(); film.pixels.len()];
        pixels.par_chunks_mut(width).enumerate().for_each(|(row, out)| {
            let counts = film.pixels[row * width..][..width].iter().map(|pixel| pixel.samples);
            let gather = Gather { scene, lights: &lights, frame, camera: &camera, y: film.region.y0 + row as u32 };
            gather.row(film.region.x0, counts, out);
        });
        Self { pixels }
    }
}

/// The rays of one row of pixels.
struct Gather<'a> {
    scene: &'a PackedScene,
    lights: &'a Lights<'a>,
    frame: &'a Frame,
    camera: &'a voxtrace_scene::camera::CameraFrame,
    y: u32,
}

impl Gather<'_> {
    fn row(&self, x0: u32, counts: impl Iterator<Item = u32>, out: &mut [FeaturePixel]) {
        let samples = counts.zip(x0..).flat_map(|(count, x)| (0..count).map(move |sample| (x, sample)));
        let mut sums = vec![Sums::default(); out.len()];
        let mut batch = Vec::with_capacity(RAYS_AT_A_TIME);
        for sample in samples {
            batch.push(sample);
            if batch.len() == RAYS_AT_A_TIME {
                self.cast(x0, &batch, &mut sums);
                batch.clear();
            }
        }
        self.cast(x0, &batch, &mut sums);
        out.iter_mut().zip(&sums).for_each(|(out, sums)| *out = sums.means());
    }

    /// Casts the rays of some samples, each a column and a number.
    fn cast(&self, x0: u32, samples: &[(u32, u32)], sums: &mut [Sums]) {
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
        let (mut paths, rays): (Vec<_>, Vec<_>) = samples.iter().map(start).unzip();
        let mut hits = vec![Hit::MISS; rays.len()];
        walk::cast_batch(self.scene, &rays, &mut hits);
        for (((path, ray), hit), (x, _)) in paths.iter_mut().zip(&rays).zip(&hits).zip(samples) {
            let sums = &mut sums[(x - x0) as usize];
            sums.samples += 1;
            if !(frame.transparent && hit.is_miss()) {
                // A path without bounces gathers what is seen directly; what lies behind clear media stays with the rest.
                match frame.integrator {
                    Integrator::Essay => drop(essay::advance(self.scene, 0, path, ray, hit, &mut sums.direct)),
                    Integrator::Path => {
                        path::advance(self.scene, self.lights, 0, path, ray, hit, &mut sums.direct);
                    }
                }
            }
            if hit.is_miss() {
                continue;
            }
            let place = ray.at(hit.t) - self.frame.camera.eye;
            sums.add(albedo_of(self.scene.material(hit)), self.scene.normal(hit), place);
        }
    }
}

/// What is added up about a pixel.
#[derive(Clone, Copy, Default)]
struct Sums {
    samples: u32,
    hits: u32,
    direct: Vec3,
    albedo: Vec3,
    normal: Vec3,
    /// The first place; the others are added up from there, so that squares stay exact enough.
    origin: Vec3,
    place: Vec3,
    /// Products of coordinates of places: xx, yy, zz and xy, yz, zx.
    squares: Vec3,
    mixed: Vec3,
}

impl Sums {
    fn add(&mut self, albedo: Vec3, normal: Vec3, place: Vec3) {
        if self.hits == 0 {
            self.origin = place;
        }
        let place = place - self.origin;
        self.hits += 1;
        self.albedo += albedo;
        self.normal += normal;
        self.place += place;
        self.squares += place * place;
        self.mixed += place * Vec3::new(place.y, place.z, place.x);
    }

    fn means(&self) -> FeaturePixel {
        let (of_samples, of_hits) = (1.0 / self.samples.max(1) as f32, 1.0 / self.hits.max(1) as f32);
        let direct = self.direct * of_samples;
        if self.hits == 0 {
            return FeaturePixel { direct, ..FeaturePixel::default() };
        }
        let (normal, mean) = (self.normal * of_hits, self.place * of_hits);
        let squares = self.squares * of_hits - mean * mean;
        let mixed = self.mixed * of_hits - mean * Vec3::new(mean.y, mean.z, mean.x);
        let along = normal * normal;
        let across = normal * Vec3::new(normal.y, normal.z, normal.x);
        let roughness = (along.dot(squares) + 2.0 * across.dot(mixed)).max(0.0) / normal.length_squared().max(1e-6);
        FeaturePixel {
            direct,
            albedo: self.albedo * of_samples,
            normal,
            position: self.origin + mean,
            roughness,
            coverage: self.hits as f32 * of_samples,
        }
    }
}
