//! A part of a picture: some rows, some samples. What a worker adds to a film depends on the part alone, so that any worker may do any part.

use crate::error_of;
use crate::film_words::{film_from_words, film_words};
use crate::scene::{CAMERA_NUMBERS, WebScene};
use voxtrace_core::{CpuTracer, Film, Frame, Progress, Region, Tracer};
use voxtrace_scene::{Camera, Hit, Ray, camera::Lens, glam::Vec3};
use wasm_bindgen::prelude::*;

/// Numbers of a ray: origin, t_min, direction, t_max.
const RAY_NUMBERS: usize = 8;

/// What to render.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Part {
    camera: Vec<f32>,
    /// Number of the scene's camera whose lens it has; a pinhole where there is none.
    pub lens_of: usize,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// First row.
    pub y0: u32,
    /// Row after the last.
    pub y1: u32,
    /// Samples that each pixel has afterwards.
    pub samples: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Most surfaces that scatter one path.
    pub max_bounces: u32,
}

#[wasm_bindgen]
impl Part {
    /// All rows of a picture: one sample a pixel, seed 0, up to 8 bounces. `camera` has the numbers of [`WebScene::camera`].
    #[wasm_bindgen(constructor)]
    pub fn new(camera: Vec<f32>, width: u32, height: u32) -> Self {
        Self { camera, lens_of: usize::MAX, width, height, y0: 0, y1: height, samples: 1, seed: 0, max_bounces: 8 }
    }
}

impl Part {
    pub(crate) fn frame(&self, scene: &WebScene) -> Option<Frame> {
        let numbers = <&[f32; CAMERA_NUMBERS]>::try_from(self.camera.as_slice()).ok()?;
        let vector = |at: usize| Vec3::from_slice(&numbers[at..]);
        let lens = scene.packed().cameras.get(self.lens_of).map_or(Lens::Pinhole, |camera| camera.lens);
        let camera = Camera { up: vector(6), fov_y: numbers[9], lens, ..Camera::look_at(vector(0), vector(3)) };
        let frame = Frame::new(camera, self.width, self.height).samples(self.samples).seed(self.seed);
        let rows = Region { x0: 0, y0: self.y0, x1: self.width, y1: self.y1 };
        Some(frame.max_bounces(self.max_bounces).region(rows))
    }
}

/// Adds samples to a part of a film until each pixel has those that are asked for, and gives its words; `words` are those of the same rows so far, or none.
///
/// # Errors
/// Where there is no such part of a picture, or the words are of another.
#[wasm_bindgen]
pub fn render_part(scene: &WebScene, part: &Part, words: &[u8]) -> Result<Vec<u8>, JsError> {
    let frame = part.frame(scene).ok_or_else(|| JsError::new("a camera has ten numbers"))?;
    frame.check().map_err(error_of)?;
    let film = film_from_words(&frame, words).ok_or_else(|| JsError::new("the film's words are of other rows"))?;
    let mut tracer = scene.tracer()?;
    tracer.resume(&frame, film).map_err(error_of)?;
    tracer.render(&frame, &Progress::default()).map_err(error_of)?;
    let mut film = Film::new(frame.width, frame.height, frame.region, 0);
    tracer.read(&mut film).map_err(error_of)?;
    Ok(film_words(&film))
}

#[wasm_bindgen]
impl WebScene {
    /// What rays meet first. A ray is origin, t_min, direction, t_max; a hit six words: distance (the bits of a float), instance, voxel (three signed
    /// integers) and face.
    ///
    /// # Errors
    /// Where the numbers are not those of whole rays.
    pub fn cast(&self, rays: &[f32]) -> Result<Vec<u32>, JsError> {
        if !rays.len().is_multiple_of(RAY_NUMBERS) {
            return Err(JsError::new("a ray has eight numbers"));
        }
        let rays: Vec<Ray> = rays
            .chunks_exact(RAY_NUMBERS)
            .map(|ray| Ray {
                origin: Vec3::from_slice(ray),
                t_min: ray[3],
                direction: Vec3::from_slice(&ray[4..]),
                t_max: ray[7],
            })
            .collect();
        let mut hits = vec![Hit::MISS; rays.len()];
        self.tracer()?.cast_into(&rays, &mut hits).map_err(error_of)?;
        let words = hits.iter().flat_map(|hit| {
            let [x, y, z] = hit.voxel.to_array().map(|value| value as u32);
            [hit.t.to_bits(), hit.instance, x, y, z, hit.face]
        });
        Ok(words.collect())
    }
}

impl WebScene {
    /// A tracer that has it.
    fn tracer(&self) -> Result<CpuTracer, JsError> {
        let mut tracer = CpuTracer::new(None);
        tracer.set_scene(self.packed()).map_err(error_of)?;
        Ok(tracer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_samples_of_several_calls_are_the_picture_of_one() {
        let scene = WebScene::built_in("city", Some(20_000.0)).unwrap();
        let part = |y0, y1, samples| Part { y0, y1, samples, seed: 3, ..Part::new(scene.camera(0, 1.5), 24, 16) };
        let whole = render_part(&scene, &part(0, 16, 4), &[]).unwrap();
        let rows = [(0, 5), (5, 16)].map(|(y0, y1)| {
            let words = render_part(&scene, &part(y0, y1, 1), &[]).unwrap();
            render_part(&scene, &part(y0, y1, 4), &words).unwrap()
        });
        assert!(rows.concat() == whole, "the same words");
        // The samples of another seed are others.
        let other = render_part(&scene, &Part { seed: 4, ..part(0, 16, 4) }, &[]).unwrap();
        assert!(other != whole);
        // What travels to another worker gives the same picture there.
        let copy = WebScene::read(scene.to_bytes(), "copy.vxt").unwrap();
        assert!(render_part(&copy, &part(0, 16, 4), &[]).unwrap() == whole);
    }
}
