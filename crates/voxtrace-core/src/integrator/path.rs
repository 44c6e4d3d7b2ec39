//! Path tracing with next-event estimation: at each surface one light is chosen and asked for, and what a bounce meets by
//! chance counts as well, both weighed by the power heuristic (Veach and Guibas, "Optimally Combining Sampling
//! Techniques for Monte Carlo Rendering", SIGGRAPH 1995). Russian roulette ends dim paths without bias.

use super::{Path, Shadow, emitted};
use crate::light::{Lights, Receiver};
use crate::math::{cosine_hemisphere, cosine_hemisphere_pdf};
use crate::packed::PackedScene;
use crate::surface::Surface;
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Bounces before Russian roulette.
const SURE_BOUNCES: u32 = 3;
/// Most that a path's survival may be likely in Russian roulette, so that even white rooms end.
const MOST_LIKELY_SURVIVAL: f32 = 0.95;

/// Adds to `radiance` the light where `ray` ended. Returns the path's next ray, `None` where the path ends, and the light
/// that arrives if a shadow ray finds nothing in its way. At most `max_bounces` surfaces scatter the path; the ray that
/// leaves the last of them still gathers what it meets.
pub fn advance(
    scene: &PackedScene,
    lights: &Lights,
    max_bounces: u32,
    path: &mut Path,
    ray: &Ray,
    hit: &Hit,
    radiance: &mut Vec3,
) -> (Option<Ray>, Option<Shadow>) {
    if hit.is_miss() {
        *radiance += path.beta * scene.sky.gradient(ray.direction);
        if let Some(sun) = lights.sun(ray.direction) {
            *radiance += path.beta * sun * weight_of_bounce(path, |receiver| lights.sun_pdf(receiver), ray);
        }
        return (None, None);
    }
    let material = scene.material(hit);
    if material.emission.max_element() > 0.0 {
        let weight = weight_of_bounce(path, |receiver| lights.emitter_pdf(receiver, ray, hit), ray);
        *radiance += path.beta * emitted(scene, material) * weight;
    }
    path.beta *= material.base_color;
    let [u, v, survival, _] = path.sampler.stratified(path.dimension_scatter());
    if path.bounce == max_bounces || path.beta.max_element() <= 0.0 || !survives(path, survival) {
        return (None, None);
    }

    let surface = Surface::new(scene, ray, hit);
    let receiver = Receiver { point: surface.origin, normal: surface.normal };
    let shadow = lights.sample(&receiver, path.sampler.stratified(path.dimension_light())).map(|sample| {
        let bounce_pdf = cosine_hemisphere_pdf(sample.cos_theta);
        // The reflectance over π times the cosine is the reflectance times the density of the bounce.
        let share = bounce_pdf / sample.pdf * power_heuristic(sample.pdf, bounce_pdf);
        Shadow { ray: sample.ray, radiance: path.beta * sample.radiance * share }
    });
    let local = cosine_hemisphere(u, v);
    path.pdf = cosine_hemisphere_pdf(local.z);
    path.normal = surface.normal;
    path.bounce += 1;
    (Some(Ray::new(surface.origin, surface.world_direction(scene, local))), shadow)
}

/// Plays Russian roulette with the path; the survivors carry the light of the others.
fn survives(path: &mut Path, u: f32) -> bool {
    if path.bounce < SURE_BOUNCES {
        return true;
    }
    let survival = path.beta.max_element().min(MOST_LIKELY_SURVIVAL);
    path.beta *= 1.0 / survival;
    u < survival
}

/// Weight of light that the bounce along `ray` met by chance, where `light_pdf` is the density with which it would have
/// been chosen as a light. Nobody chooses lights for the camera.
fn weight_of_bounce(path: &Path, light_pdf: impl FnOnce(&Receiver) -> f32, ray: &Ray) -> f32 {
    if path.bounce == 0 {
        return 1.0;
    }
    power_heuristic(path.pdf, light_pdf(&Receiver { point: ray.origin, normal: path.normal }))
}

/// Weight of a sample of density `own`, > 0, that another technique finds with density `other`.
fn power_heuristic(own: f32, other: f32) -> f32 {
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}
