//! The film's AOVs (arbitrary output variables): what the ray through the middle of each pixel meets, without noise. Whoever traces the rays.
//! Depth, instance and voxel are those of what it meets first, as compositing wants them; albedo and normal those of what is seen in a mirror
//! or behind clear glass ([`likeliest`]), as denoisers want them.

use crate::film::AovPixel;
use crate::frame::{Frame, Integrator};
use crate::integrator::essay;
use crate::integrator::seen::likeliest;
use crate::lines::Lines;
use crate::packed::PackedScene;
use glam::{Vec2, Vec3};
use voxtrace_scene::camera::CameraFrame;
use voxtrace_scene::ray::{Hit, Ray};

/// The rays through the middle of the lens and of the pixels in one row of the frame's region, counted from its top.
pub fn rays_of_row(frame: &Frame, camera: &CameraFrame, row: u32) -> Vec<Ray> {
    let region = frame.region;
    let y = (region.y0 + row) as f32 + 0.5;
    (region.x0..region.x1).map(|x| clip(frame, camera.central_ray(Vec2::new(x as f32 + 0.5, y)))).collect()
}

/// The AOVs of a pixel of a frame with `lines` whose middle `ray` met `hit`, a hit as tracers find it or a miss.
pub fn aov_of(scene: &PackedScene, lines: &Lines, ray: &Ray, hit: &Hit) -> AovPixel {
    let seen = likeliest(scene, lines, ray, hit);
    let (albedo, normal) =
        seen.map_or((Vec3::ZERO, Vec3::ZERO), |seen| (seen.albedo, scene.shading_normal(&seen.ray, &seen.hit)));
    if hit.is_miss() {
        return AovPixel { albedo, normal, ..AovPixel::MISS };
    }
    let Hit { t, instance, voxel, .. } = scene.hit_of_part(hit);
    AovPixel { albedo, normal, depth: t, instance, voxel }
}

/// Clips a camera ray to the range that the frame's integrator traces.
pub fn clip(frame: &Frame, ray: Ray) -> Ray {
    match frame.integrator {
        Integrator::Essay => essay::clip(ray),
        Integrator::Path => ray,
    }
}
