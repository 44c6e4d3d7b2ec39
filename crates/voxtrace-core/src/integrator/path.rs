//! Path tracing with next-event estimation: at each surface one light is chosen and asked for, and what a bounce meets by
//! chance counts as well, both weighed by the power heuristic (Veach and Guibas, "Optimally Combining Sampling
//! Techniques for Monte Carlo Rendering", SIGGRAPH 1995). Russian roulette ends dim paths without bias.

use super::{Path, ShadowRay};
use crate::bsdf::{Bsdf, MaterialBsdf};
use crate::light::{DistantLight, Lights, Receiver};
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
) -> (Option<Ray>, Option<ShadowRay>) {
    let last = path.receiver(ray);
    if hit.is_miss() {
        let direction = ray.direction;
        *radiance += path.beta * lights.sky.le(direction) * mis_weight(path.pdf, || lights.sky_pdf(&last, direction));
        if let Some(sun) = &lights.sun {
            let le = sun.le(direction);
            if le.max_element() > 0.0 {
                *radiance += path.beta * le * mis_weight(path.pdf, || lights.sun_pdf(&last, direction));
            }
        }
        return (None, None);
    }
    let material = scene.material(hit);
    let le = lights.emitters.le(material);
    if le.max_element() > 0.0 {
        *radiance += path.beta * le * mis_weight(path.pdf, || lights.emitter_pdf(&last, ray, hit));
    }
    let bsdf = MaterialBsdf::new(material);
    let scattered = path.beta * bsdf.albedo();
    let [u, v, survival, lobe] = path.sampler.stratified(path.dimension_scatter());
    if path.bounce == max_bounces || scattered.max_element() <= 0.0 {
        return (None, None);
    }
    let Some(compensation) = roulette(path.bounce, scattered, survival) else { return (None, None) };

    let surface = Surface::new(scene, ray, hit);
    let wo = surface.local_direction(-ray.direction);
    let receiver = Receiver { point: surface.origin, normal: surface.normal };
    let light = lights.sample(&receiver, path.sampler.stratified(path.dimension_light())).map(|sample| {
        // What lies above the horizon is for the light to say: its cosine holds.
        let wi = surface.local_direction(sample.ray.direction).with_z(sample.cos_theta);
        let eval = bsdf.eval(wo, wi);
        let share = eval.pdf / sample.pdf * power_heuristic(sample.pdf, eval.pdf);
        ShadowRay { ray: sample.ray, radiance: path.beta * eval.weight * compensation * sample.radiance * share }
    });
    let Some(bounce) = bsdf.sample(wo, [u, v, lobe]) else { return (None, light) };
    path.beta = path.beta * bounce.weight * compensation;
    path.pdf = if bounce.is_delta { 0.0 } else { bounce.pdf };
    path.normal = surface.normal;
    path.bounce += 1;
    (Some(Ray::new(surface.origin, surface.world_direction(bounce.wi))), light)
}

/// Plays Russian roulette with a path of whose light `scattered` goes on: `None` where it ends, else the factor with which
/// the survivors carry the light of the others.
#[inline]
fn roulette(bounce: u32, scattered: Vec3, u: f32) -> Option<f32> {
    if bounce < SURE_BOUNCES {
        return Some(1.0);
    }
    let survival = scattered.max_element().min(MOST_LIKELY_SURVIVAL);
    (u < survival).then(|| 1.0 / survival)
}

/// Weight of light that a bounce of density `bounce_pdf` met by chance, where `light_pdf` is the density with which it would have
/// been chosen as a light. Nobody chooses lights for the camera and for mirrors, whose density is 0.
#[inline]
fn mis_weight(bounce_pdf: f32, light_pdf: impl FnOnce() -> f32) -> f32 {
    if bounce_pdf == 0.0 {
        return 1.0;
    }
    let light_pdf = light_pdf();
    if light_pdf == 0.0 { 1.0 } else { power_heuristic(bounce_pdf, light_pdf) }
}

/// Weight of a sample of density `own`, > 0, that another technique finds with density `other`.
#[inline]
fn power_heuristic(own: f32, other: f32) -> f32 {
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}
