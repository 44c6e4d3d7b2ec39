//! Parts of pictures traced, and what rays meet. What a worker adds to a film depends on the part alone, so that any worker may do any part.

use crate::error_of;
use crate::film_words::{film_from_words, film_words};
use crate::part::Part;
use crate::scene::WebScene;
use std::sync::Arc;
use voxtrace_core::cuts::Cuts;
use voxtrace_core::{CpuTracer, Film, PackedScene, Progress, Tracer};
use voxtrace_scene::{Hit, Ray, glam::Vec2, glam::Vec3};
use wasm_bindgen::prelude::*;

/// Numbers of a ray: origin, t_min, direction, t_max.
const RAY_NUMBERS: usize = 8;

/// Adds samples to a part of a film until each pixel has those that are asked for, and gives its words; `words` are those of the same rows so far, or none.
///
/// # Errors
/// Where there is no such part of a picture, or the words are of another.
#[wasm_bindgen]
pub fn render_part(scene: &WebScene, part: &Part, words: &[u8]) -> Result<Vec<u8>, JsError> {
    let frame = part.frame(scene.packed())?;
    let film = film_from_words(&frame, words).ok_or_else(|| JsError::new("the film's words are of other rows"))?;
    let mut tracer = tracer_of(&scene.clipped(&part.clip)?)?;
    tracer.resume(&frame, film).map_err(error_of)?;
    tracer.render(&frame, &Progress::default()).map_err(error_of)?;
    let mut film = Film::new(frame.width, frame.height, frame.region, 0);
    tracer.read(&mut film).map_err(error_of)?;
    Ok(film_words(&film))
}

#[wasm_bindgen]
impl WebScene {
    /// What rays meet first, of what is within a box as of [`Part::set_clip`]. A ray is origin, t_min, direction, t_max; a hit six words: distance (the bits of a float), instance, voxel (three signed
    /// integers) and face.
    ///
    /// # Errors
    /// Where the numbers are not those of whole rays, or of a box.
    pub fn cast(&self, rays: &[f32], clip: &[f32]) -> Result<Vec<u32>, JsError> {
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
        tracer_of(&self.clipped(clip)?)?.cast_into(&rays, &mut hits).map_err(error_of)?;
        let words = hits.iter().flat_map(|hit| {
            let [x, y, z] = hit.voxel.to_array().map(|value| value as u32);
            [hit.t.to_bits(), hit.instance, x, y, z, hit.face]
        });
        Ok(words.collect())
    }

    /// What a part's picture shows at a place, in pixels from its upper left corner, in twelve words: its instance, its material, where the voxel is in its
    /// grid (three signed integers), and as the bits of floats the distance from the camera, where on the voxel's face that is (world units) and the
    /// normal there. Nothing where that is the sky.
    ///
    /// # Errors
    /// Where the part has no camera, or no box.
    pub fn pick(&self, part: &Part, x: f32, y: f32) -> Result<Vec<u32>, JsError> {
        let frame = part.frame(self.packed())?;
        let ray = frame.camera.frame(frame.width, frame.height).central_ray(Vec2::new(x, y));
        let mut hits = [Hit::MISS];
        // The face of a cut has its normal in the scene that is cut alone.
        let scene = self.clipped(&part.clip)?;
        tracer_of(&scene)?.cast_into(&[ray], &mut hits).map_err(error_of)?;
        let [hit] = hits;
        if hit.is_miss() {
            return Ok(Vec::new());
        }
        let [[i, j, k], at, normal] =
            [hit.voxel.to_array().map(|value| value as u32), bits(ray.at(hit.t)), bits(scene.normal(&hit))];
        let [[px, py, pz], [nx, ny, nz]] = [at, normal];
        Ok(vec![hit.instance, scene.material_index(&hit), i, j, k, hit.t.to_bits(), px, py, pz, nx, ny, nz])
    }
}

/// The bits of three floats.
fn bits(three: Vec3) -> [u32; 3] {
    three.to_array().map(f32::to_bits)
}

impl WebScene {
    /// The scene, or what of it is within a box.
    fn clipped(&self, clip: &[f32]) -> Result<Arc<PackedScene>, JsError> {
        let mut scene = Arc::clone(self.packed());
        if !clip.is_empty() {
            let cuts = match clip {
                &[a, b, c, d, e, f] => Cuts::default().clip_box(Vec3::new(a, b, c), Vec3::new(d, e, f)).ok(),
                _ => None,
            };
            let cuts = cuts.ok_or_else(|| JsError::new("a box has six numbers, its lowest corner first"))?;
            Arc::make_mut(&mut scene).cuts = cuts;
        }
        Ok(scene)
    }
}

fn tracer_of(scene: &Arc<PackedScene>) -> Result<CpuTracer, JsError> {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene).map_err(error_of)?;
    Ok(tracer)
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
        // What a box keeps is another picture, and a ray meets what it shows.
        let mut clipped = part(0, 16, 4);
        clipped.set_clip(vec![-1e3, -1e3, -1e3, 1e3, 1e3, 4.0]);
        let cut = render_part(&scene, &clipped, &[]).unwrap();
        assert!(cut != whole);
        let picked = scene.pick(&clipped, 12.0, 12.0).unwrap();
        let floats: Vec<f32> = picked[5..].iter().map(|&word| f32::from_bits(word)).collect();
        assert!(floats[3] <= 4.0 && floats[4..] == [0.0, 0.0, 1.0], "the face of the cut: {floats:?}");
        assert!(scene.pick(&part(0, 16, 4), 0.0, 0.0).unwrap().is_empty(), "the sky");
        // What travels to another worker gives the same picture there.
        let copy = WebScene::read(scene.to_bytes(), "copy.vxt").unwrap();
        assert!(render_part(&copy, &part(0, 16, 4), &[]).unwrap() == whole);
    }
}
