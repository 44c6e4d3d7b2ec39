//! Where the frame before showed what a pixel shows, and what it knew of it.

use crate::antialiasing::{shown_in, word_of};
use crate::memory::Memory;
use crate::path::Sample;
use glam::{Mat3, Vec2, Vec3};
use voxtrace_core::Frame;
use voxtrace_scene::camera::{CameraFrame, Orthographic, Perspective, Projection};
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::transform::Transform;

/// How far, in voxels, a place of the frame before may be from the plane of what is seen now, beside a pixel's width and the roughness there.
const PLACE_TOLERANCE: f32 = 1.5;
/// Least cosine between the normals.
const LEAST_COSINE: f32 = 0.5;
/// Share of a pixel that surfaces cover at most where it is said to show none: between what 4 to 40 rays can find, so that no rounding decides.
const MOST_COVERAGE: f32 = 0.446;
/// Least sum of the weights of pixels that show the same, of one.
const LEAST_WEIGHT: f32 = 0.02;
/// Most paths that are remembered where the frame before did not show the same at all pixels around: there light of one thing gets into that of another, the more
/// the longer it is remembered.
const MOST_AT_EDGES: f32 = 8.0;
/// How far from the middle of a row or column of pixels, in pixels, a place is at most that is taken to be there: so what stands still is remembered as it is, and no
/// rounding decides which pixels are around.
const STILL: f32 = 1e-3;
/// By how much a pixel is nearer than those before to be taken in their place, square pixels: where several are as near, no rounding decides.
const NEARER: f32 = 1e-3;

/// The frame before.
pub struct Before<'a> {
    /// What it knew.
    pub memory: &'a [Memory],
    /// Its camera.
    pub camera: &'a CameraFrame,
    /// Its size, pixels.
    pub size: [u32; 2],
    /// For each instance that was elsewhere: the world then from the world now. Shorter than the instances where the last ones did not move.
    pub motions: &'a [Option<Transform>],
}

impl Before<'_> {
    /// The light that is known to fall on what `sample` shows, of a pixel through whose middle `ray`, the camera's, goes; `width` is that of a pixel there, world units. Nothing where nothing of it was seen.
    pub fn memory_of(&self, sample: &Sample, ray: &Ray, width: f32) -> Memory {
        let motion = sample.shown.filter(|shown| shown.instance != Hit::NONE);
        let motion = motion.and_then(|shown| self.motions.get(shown.instance as usize).copied().flatten());
        let place = match &sample.shown {
            Some(shown) => motion.map_or(shown.place, |then| then.point(shown.place)),
            None => ray.at(1e7),
        };
        let normal = sample.shown.map_or(Vec3::ZERO, |shown| {
            motion.map_or(shown.normal, |then| then.direction(shown.normal).normalize_or_zero())
        });
        // What is known of a pixel is that of its middle: were it taken from where the sample was, light would wander by a part of a pixel in every frame.
        let middle = match &sample.shown {
            Some(shown) => {
                let along = ray.direction.dot(shown.place - ray.origin) / ray.direction.length_squared();
                motion.map_or(ray.at(along), |then| then.point(ray.at(along)))
            }
            None => place,
        };
        let Some(at) = position(self.camera, middle) else { return Memory::default() };
        let shows = |memory: &Memory| match &sample.shown {
            None => memory.coverage < MOST_COVERAGE,
            Some(_) => {
                let distance = normal.dot(memory.place - place).abs();
                let tolerance = PLACE_TOLERANCE + width + 2.0 * memory.roughness.sqrt();
                let cosine = normal.dot(memory.normal);
                memory.coverage > 0.0 && distance <= tolerance && cosine >= LEAST_COSINE * memory.normal.length()
            }
        };
        let place = Place::at(at);
        Memory { shown: self.shown_at(&place), ..self.gather(&place, &shows).bounded() }
    }

    /// What the frame before showed at a place of its picture, by Catmull and Rom's cubic; 0 outside of it, and where it showed nothing.
    fn shown_at(&self, place: &Place) -> u32 {
        if place.at.cmplt(Vec2::ZERO).any() || place.at.cmpge(Vec2::from(self.size.map(|length| length as f32))).any() {
            return 0;
        }
        let [right, bottom] = self.size.map(|length| length as i32 - 1);
        let (across, down) = place.cubic_weights();
        let mut sum = Vec3::ZERO;
        for (dy, down) in (-1..).zip(down) {
            for (dx, across) in (-1..).zip(across) {
                let (x, y) = ((place.x + dx).clamp(0, right), (place.y + dy).clamp(0, bottom));
                let shown = self.pixel(x, y).map_or(0, |memory| memory.shown);
                if shown == 0 {
                    return 0;
                }
                sum += shown_in(shown) * (across * down);
            }
        }
        word_of(sum)
    }

    /// The light at a position by Catmull and Rom's cubic, which keeps it sharp from frame to frame, where all sixteen pixels around show the same, or those that have a
    /// part in it; else the mean of those of four that do, and where none does, the nearest of nine that does.
    fn gather(&self, place: &Place, shows: &impl Fn(&Memory) -> bool) -> Memory {
        let &Place { at, x, y, share } = place;
        let known = |dx: i32, dy: i32| self.pixel(x + dx, y + dy).filter(|memory| shows(memory));
        if let Some(light) = cubic(place.cubic_weights(), known) {
            return light;
        }
        let (mut sum, mut weights) = (Sum::default(), 0.0);
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let Some(memory) = known(dx, dy) else { continue };
            let weight = |d: i32, share: f32| if d == 0 { 1.0 - share } else { share };
            let weight = weight(dx, share.x) * weight(dy, share.y);
            sum.add(memory, weight);
            weights += weight;
        }
        if weights >= LEAST_WEIGHT {
            return sum.mean(weights).at_an_edge();
        }
        let (x, y) = (at.x.floor() as i32, at.y.floor() as i32);
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
        let distance = |(dx, dy): (i32, i32)| (Vec2::new((x + dx) as f32, (y + dy) as f32) + 0.5 - at).length_squared();
        let (mut nearest, mut least) = (None, f32::INFINITY);
        for (dx, dy) in around {
            let Some(memory) = self.pixel(x + dx, y + dy).filter(|memory| shows(memory)) else { continue };
            if distance((dx, dy)) < least - NEARER {
                (nearest, least) = (Some(memory), distance((dx, dy)));
            }
        }
        nearest.map(Memory::light_alone).unwrap_or_default().at_an_edge()
    }

    fn pixel(&self, x: i32, y: i32) -> Option<&Memory> {
        let [width, height] = self.size.map(|length| length as i32);
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        is_inside.then(|| &self.memory[(y * width + x) as usize])
    }
}

/// A place of a picture, pixels.
struct Place {
    at: Vec2,
    /// The pixel whose middle is the last one to the left and above.
    x: i32,
    y: i32,
    /// How far behind that middle.
    share: Vec2,
}

impl Place {
    /// Where it is about the middle of a row or column of pixels, it is there.
    fn at(at: Vec2) -> Self {
        let middle = at.floor() + 0.5;
        let at = Vec2::select((at - middle).abs().cmple(Vec2::splat(STILL)), middle, at);
        let corner = (at - 0.5).floor();
        Self { at, x: corner.x as i32, y: corner.y as i32, share: at - 0.5 - corner }
    }

    /// Weights of four pixels across and down, from the one before the corner on, by Catmull and Rom's cubic.
    fn cubic_weights(&self) -> ([f32; 4], [f32; 4]) {
        let weights = |t: f32| {
            let (tt, ttt) = (t * t, t * t * t);
            [
                0.5 * (2.0 * tt - ttt - t),
                0.5 * (3.0 * ttt - 5.0 * tt + 2.0),
                0.5 * (4.0 * tt - 3.0 * ttt + t),
                0.5 * (ttt - tt),
            ]
        };
        (weights(self.share.x), weights(self.share.y))
    }
}

/// Where on the picture a camera sees a place, pixels; `None` where it does not, and for lenses that bend straight lines.
pub fn position(camera: &CameraFrame, place: Vec3) -> Option<Vec2> {
    match camera {
        CameraFrame::Perspective(perspective) => position_of_perspective(perspective, place),
        CameraFrame::ThinLens(lens) => position_of_perspective(&lens.perspective, place),
        CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, .. }) => {
            let way = place - *corner;
            Some(Vec2::new(way.dot(*pixel_x) / pixel_x.length_squared(), way.dot(*pixel_y) / pixel_y.length_squared()))
        }
        CameraFrame::Panorama(_) | CameraFrame::Fisheye(_) => None,
    }
}

/// Whether a frame shows nothing that the one before did, as far as the cameras tell: places as far away as the camera looks. Of another size it may show the same.
pub fn is_cut(before: &Frame, now: &Frame) -> bool {
    let of = |frame: &Frame| (frame.seed, std::mem::discriminant(&frame.camera.lens));
    if of(before) != of(now) {
        return true;
    }
    let (then, camera) = (before.camera.frame(now.width, now.height), now.camera.frame(now.width, now.height));
    if before.camera == now.camera || matches!(camera, CameraFrame::Panorama(_) | CameraFrame::Fisheye(_)) {
        return false;
    }
    let distance = (now.camera.target - now.camera.eye).length();
    let size = Vec2::new(now.width as f32, now.height as f32);
    let is_seen = |at: Vec2| {
        let place = camera.ray(at, Vec2::splat(0.5));
        let found = position(&then, place.at(distance / place.direction.length()));
        found.is_some_and(|found| found.cmpge(Vec2::ZERO).all() && found.cmplt(size).all())
    };
    let mut places = (0..9).map(|number| Vec2::new((number % 3) as f32, (number / 3) as f32));
    (now.camera.eye - before.camera.eye).length() > distance || !places.any(|place| is_seen((place + 0.5) / 3.0 * size))
}

fn position_of_perspective(camera: &Perspective, place: Vec3) -> Option<Vec2> {
    let Perspective { eye, corner, pixel_x, pixel_y } = *camera;
    // The place is on the line of x pixels to the right and y down: corner + x · pixel_x + y · pixel_y.
    let x_y_z = Mat3::from_cols(pixel_x, pixel_y, corner).inverse() * (place - eye);
    (x_y_z.z > 1e-6).then(|| Vec2::new(x_y_z.x / x_y_z.z, x_y_z.y / x_y_z.z))
}

/// The light that is known by weights of four pixels across and down.
fn cubic<'a>((across, down): ([f32; 4], [f32; 4]), known: impl Fn(i32, i32) -> Option<&'a Memory>) -> Option<Memory> {
    let (mut sum, mut least) = (Sum::default(), f32::INFINITY);
    for (dy, down) in (-1..).zip(down) {
        for (dx, across) in (-1..).zip(across) {
            if across * down == 0.0 {
                continue;
            }
            let memory = known(dx, dy)?;
            sum.add(memory, across * down);
            least = least.min(memory.paths);
        }
    }
    let mut light = sum.mean(1.0);
    // Where the cubic goes below what there was, the four pixels in the middle are to say.
    let is_sound =
        light.light.min_element() >= 0.0 && light.shaded.min_element() >= 0.0 && light.moments.min_element() >= 0.0;
    light.paths = light.paths.max(least);
    is_sound.then_some(light)
}

impl Memory {
    fn at_an_edge(self) -> Self {
        Self { paths: self.paths.min(MOST_AT_EDGES), ..self }
    }
}

/// A weighted sum of the light that pixels know.
#[derive(Default)]
struct Sum(Memory);

impl Sum {
    fn add(&mut self, memory: &Memory, weight: f32) {
        self.0.paths += memory.paths * weight;
        self.0.light += memory.light * weight;
        self.0.shaded += memory.shaded * weight;
        self.0.moments += memory.moments * weight;
    }

    fn mean(self, weights: f32) -> Memory {
        let (mut mean, scale) = (self.0, 1.0 / weights);
        mean.paths *= scale;
        for value in [&mut mean.light, &mut mean.shaded, &mut mean.moments] {
            *value *= scale;
        }
        mean
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::Camera;
    use voxtrace_scene::camera::Lens;

    #[test]
    fn a_camera_that_looks_elsewhere_or_stands_far_away_begins_anew() {
        let camera = Camera::look_at(Vec3::new(30.0, -50.0, 20.0), Vec3::new(3.0, 4.0, 5.0));
        let frame = |camera: &Camera| Frame::new(camera.clone(), 320, 180);
        let before = frame(&camera);
        let with = |eye: Vec3, target: Vec3| frame(&Camera { eye, target, ..camera.clone() });
        assert!(!is_cut(&before, &before));
        let aside = Vec3::new(2.0, 1.0, 0.0);
        assert!(!is_cut(&before, &with(camera.eye + aside, camera.target + aside)), "a step");
        assert!(is_cut(&before, &with(camera.eye, 2.0 * camera.eye - camera.target)), "it turned around");
        let far = Vec3::new(0.0, 300.0, 0.0);
        assert!(is_cut(&before, &with(camera.eye + far, camera.target + far)), "it is elsewhere");
        assert!(!is_cut(&before, &Frame::new(camera.clone(), 160, 90)), "another size");
        assert!(is_cut(&before, &before.clone().seed(5)), "other random numbers");
    }

    /// Memory of 8 × 8 pixels before an orthographic camera whose pixels are a unit wide, each with light of its own, and the camera.
    fn before(plane: impl Fn(u32) -> f32) -> (Vec<Memory>, Camera) {
        let camera = Camera::look_at(Vec3::new(0.0, -50.0, 0.0), Vec3::ZERO);
        let camera = camera.with_lens(Lens::Orthographic { view_height: 8.0 });
        let frame = camera.frame(8, 8);
        let pixel = |index: u32| {
            let ray = frame.ray(Vec2::new((index % 8) as f32 + 0.5, (index / 8) as f32 + 0.5), Vec2::splat(0.5));
            Memory {
                paths: 32.0,
                looks: 4.0,
                coverage: 1.0,
                normal: Vec3::NEG_Y,
                place: ray.at((plane(index) - ray.origin.y) / ray.direction.y),
                light: Vec3::splat(index as f32),
                ..Memory::default()
            }
        };
        ((0..64).map(pixel).collect(), camera)
    }

    /// What is known of the pixel at (4, 4) by a sample at `off` from its middle, on the plane y = 0, after the camera went `step` pixels to the right.
    fn known(before: &(Vec<Memory>, Camera), off: Vec2, step: f32) -> Memory {
        let (memory, camera) = before;
        let then = camera.frame(8, 8);
        let aside = camera.axes().right * step;
        let moved = Camera { eye: camera.eye + aside, target: camera.target + aside, ..camera.clone() }.frame(8, 8);
        let ray = moved.ray(Vec2::splat(4.5), Vec2::splat(0.5));
        let seen = moved.ray(Vec2::splat(4.5) + off, Vec2::splat(0.5));
        let place = seen.at(-seen.origin.y / seen.direction.y);
        let shown = Some(crate::path::Shown { normal: Vec3::NEG_Y, place, instance: 0 });
        let sample = Sample { shown, ..Sample::default() };
        Before { memory, camera: &then, size: [8, 8], motions: &[] }.memory_of(&sample, &ray, 1.0)
    }

    #[test]
    fn light_stays_where_it_is_wherever_in_the_pixel_the_sample_was() {
        let before = before(|_| 0.0);
        for off in [Vec2::ZERO, Vec2::new(0.45, -0.3), Vec2::new(-0.2, 0.49)] {
            let (still, right) = (known(&before, off, 0.0), known(&before, off, 1.0));
            assert_eq!((still.light.x, still.paths), (36.0, 32.0), "{off}");
            assert_eq!((right.light.x, right.paths), (37.0, 32.0), "{off}: a step of a pixel");
            let half = known(&before, off, 0.5);
            assert!((half.light.x - 36.5).abs() < 1e-3 && half.paths == 32.0, "{off}: {half:?}");
        }
    }

    #[test]
    fn light_beside_other_things_is_remembered_for_few_paths() {
        // The right half is farther away than anything that is the same.
        let before = before(|index| if index % 8 > 4 { 20.0 } else { 0.0 });
        let half = known(&before, Vec2::ZERO, -0.5);
        assert!((half.light.x - 35.5).abs() < 1e-3 && half.paths == MOST_AT_EDGES, "{half:?}");
        assert_eq!(known(&before, Vec2::ZERO, 0.0).paths, 32.0, "what stands still keeps all");
        assert_eq!(known(&before, Vec2::ZERO, 0.9).light.x, 36.0, "of the four pixels, that which shows the same");
        assert_eq!(known(&before, Vec2::ZERO, 2.0), Memory::default(), "what was not seen");
    }

    #[test]
    fn places_are_found_where_the_camera_sees_them() {
        let camera = Camera::look_at(Vec3::new(30.0, -50.0, 20.0), Vec3::new(3.0, 4.0, 5.0));
        for lens in [Lens::Pinhole, Lens::Orthographic { view_height: 40.0 }] {
            let frame = camera.clone().with_lens(lens).frame(320, 180);
            for at in [Vec2::new(10.5, 170.25), Vec2::new(160.0, 90.0), Vec2::new(319.0, 0.5)] {
                let ray = frame.ray(at, Vec2::ZERO);
                for t in [1.0, 50.0, 3000.0] {
                    let found = position(&frame, ray.at(t)).unwrap();
                    assert!(found.distance(at) < 0.02, "{at}: {found}");
                    assert!(
                        position(&frame, ray.at(t) + camera.axes().up * t).unwrap().distance(at) > 0.5,
                        "a fault is seen"
                    );
                }
            }
        }
        let frame = camera.frame(320, 180);
        assert_eq!(position(&frame, camera.eye - camera.axes().forward), None, "behind the camera");
    }
}
