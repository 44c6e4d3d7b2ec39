//! Path tracing with next-event estimation: at each surface one light is chosen and asked for, and what a bounce meets by
//! chance counts as well, both weighed by the power heuristic (Veach and Guibas, "Optimally Combining Sampling
//! Techniques for Monte Carlo Rendering", SIGGRAPH 1995). Russian roulette ends dim paths without bias.

use super::in_medium::scattering_t;
use super::{Path, ShadowRay};
use crate::bounce_limits::{BounceKind, BounceLimits};
use crate::bsdf::{Bsdf, Dielectric, Diffuse, MaterialBsdf, above, straight_reflectance};
use crate::frame::Frame;
use crate::light::{DistantLight, LightSample, Lights, Receiver};
use crate::lines::Lines;
use crate::math::normalize;
use crate::medium::Inside;
use crate::packed::{PackedMaterial, PackedScene};
use crate::surface::{Surface, behind_face};
use glam::Vec3;
use voxtrace_scene::ray::{Face, Hit, Ray};

/// Bounces before Russian roulette.
const SURE_BOUNCES: u32 = 3;
/// Most that a path's survival may be likely in Russian roulette, so that even white rooms end.
const MOST_LIKELY_SURVIVAL: f32 = 0.95;

/// Most boundaries that a path passes beyond its bounces.
const MAX_PASSED: u32 = 64;

/// What a frame says about how far paths go, what counts of their light, and the style of what they meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// [`Frame::max_bounces`].
    pub max_bounces: u32,
    /// [`Frame::bounce_limits`] as one number.
    pub kinds: u32,
    /// [`Frame::clamp_indirect`].
    pub clamp_indirect: f32,
    /// [`Frame::clear_shadows`].
    pub clear_shadows: bool,
    /// [`Frame::lines`].
    pub lines: Lines,
}

impl Limits {
    /// Those of a frame.
    pub fn of(frame: &Frame) -> Self {
        let kinds = frame.bounce_limits.to_bits();
        let Frame { max_bounces, clamp_indirect, clear_shadows, lines, .. } = *frame;
        Self { max_bounces, kinds, clamp_indirect, clear_shadows, lines }
    }

    /// What counts of some light.
    #[inline]
    fn clamped(&self, light: Vec3, is_indirect: bool) -> Vec3 {
        let largest = light.max_element();
        if is_indirect && largest > self.clamp_indirect { light * (self.clamp_indirect / largest) } else { light }
    }

    /// Whether a path, of which `u` is left to choose with, passes a surface straight, towards which `wo` leads back: clear glass, once rays to lights
    /// pass it straight as well. Else clear glass reflects it.
    #[inline]
    fn goes_straight(&self, path: &Path, bsdf: &MaterialBsdf, wo: Vec3, u: f32) -> bool {
        let MaterialBsdf::Dielectric(Dielectric { eta, facets }) = bsdf else { return false };
        let is_clear = self.clear_shadows && path.scattered > 0 && facets.is_smooth();
        is_clear && u >= straight_reflectance(above(wo).z, *eta)
    }

    /// Whether a path may not be scattered in this way any more.
    #[inline]
    fn ends(&self, path: &Path, kind: BounceKind) -> bool {
        BounceLimits::is_reached(self.kinds, path.kinds, kind)
    }
}

/// What becomes of a path where its ray ended.
pub enum Arrival {
    /// It ends.
    End,
    /// It goes on straight.
    Pass(Ray),
    /// It is scattered, once a light was chosen.
    Scatter(Scatter),
}

/// A path that is to be scattered. It is kept small: waves keep one for each of their paths while lights are chosen.
pub struct Scatter {
    place: Place,
    bsdf: MaterialBsdf,
    wo: Vec3,
    /// Random numbers that choose the direction.
    u: [f32; 3],
    /// What Russian roulette makes of the light.
    compensation: f32,
    /// Whether it is in the middle of a medium, or at the boundary of one.
    is_in_medium: bool,
    is_boundary: bool,
    /// Whether lights are to be chosen.
    pub wants_light: bool,
}

impl Scatter {
    /// The place that a light is chosen for.
    #[inline]
    pub fn receiver(&self) -> &Receiver {
        &self.place.receiver
    }
}

/// Adds to `radiance` the light where `ray` ended. Returns the path's next ray, `None` where the path ends, and the light
/// that arrives if a shadow ray finds nothing in its way. As many surfaces scatter the path as `limits` says; the ray that
/// leaves the last of them still gathers what it meets.
pub fn advance(
    scene: &PackedScene,
    lights: &Lights,
    limits: &Limits,
    path: &mut Path,
    (ray, hit): (&Ray, &Hit),
    radiance: &mut Vec3,
) -> (Option<Ray>, Option<ShadowRay>) {
    let material = path.material(scene, hit);
    match arrive(scene, lights, limits, path, (ray, hit, material), Path::scatter_numbers, radiance) {
        Arrival::End => (None, None),
        Arrival::Pass(next) => (Some(next), None),
        Arrival::Scatter(scatter) => {
            let choose = || lights.sample(scatter.receiver(), path.sampler.stratified(path.dimension_light()));
            let light = scatter.wants_light.then(choose).flatten();
            let shadow_ray = light.and_then(|sample| shadow_ray(scene, limits, path, &scatter, &sample));
            (leave(scene, limits, path, (ray, hit), &scatter), shadow_ray)
        }
    }
}

/// The first part of [`advance`]: all that comes before a light is chosen. `material` is `Path::material`, `draw` gives what [`Path::scatter_numbers`] does.
#[inline]
pub fn arrive(
    scene: &PackedScene,
    lights: &Lights,
    limits: &Limits,
    path: &mut Path,
    (ray, hit, material): (&Ray, &Hit, u32),
    draw: impl FnOnce(&Path) -> [f32; 4],
    radiance: &mut Vec3,
) -> Arrival {
    let last = path.receiver(ray);
    let is_indirect = path.scattered > 1;
    // A path that meets nothing in a medium is scattered there.
    let is_scattered = path.inside.is_some() && hit.is_miss();
    let mut t = hit.t;
    if let Some(inside) = path.inside {
        t = if is_scattered { scattering_t(scene, path, &inside, ray) } else { t };
        let glow = path.glow(scene, lights.emitters.intensity, &inside, ray, t);
        *radiance += limits.clamped(glow, is_indirect);
        path.absorb(scene, &inside, ray, t);
    }
    if hit.is_miss() && !is_scattered {
        let direction = ray.direction;
        let sky = path.beta * lights.sky.le(direction) * mis_weight(path.pdf, || lights.sky_pdf(&last, direction));
        *radiance += limits.clamped(sky, is_indirect);
        if let Some(sun) = lights.sun.as_ref().filter(|sun| sun.is_visible || !path.is_straight()) {
            let le = sun.le(direction);
            if le.max_element() > 0.0 {
                let sun = path.beta * le * mis_weight(path.pdf, || lights.sun_pdf(&last, direction));
                *radiance += limits.clamped(sun, is_indirect);
            }
        }
        return Arrival::End;
    }
    let [u, v, survival, mut lobe] = draw(path);
    let (material, bsdf) = met(scene, &limits.lines, path, (ray, hit, material), &mut lobe);
    if let Some(material) = material {
        let le = lights.emitters.le(material);
        if le.max_element() > 0.0 {
            // From the last bounce on: boundaries that were passed lie on the same line.
            let from_last = Hit { t: hit.t + path.passed_t, ..*hit };
            let light = path.beta * le * mis_weight(path.pdf, || lights.emitter_pdf(&last, ray, &from_last));
            *radiance += limits.clamped(light, is_indirect);
        }
    }
    let scattered = path.beta * bsdf.albedo();
    let is_boundary = matches!(bsdf, MaterialBsdf::Dielectric(_));
    let is_last =
        if is_boundary { path.event >= limits.max_bounces + MAX_PASSED } else { path.bounce >= limits.max_bounces };
    if is_last || scattered.max_element() <= 0.0 {
        return Arrival::End;
    }
    if matches!(bsdf, MaterialBsdf::Dielectric(Dielectric { eta: 1.0, .. })) {
        return Arrival::Pass(pass(scene, path, ray, hit));
    }
    // Of a boundary, what it reflects: lights are looked for on its near side alone.
    let kind = kind_of(&bsdf);
    if !is_boundary && limits.ends(path, kind) {
        return Arrival::End;
    }
    let Some(compensation) = roulette(path.event, scattered, survival) else { return Arrival::End };

    let place = if is_scattered {
        Place::in_medium(scene, path, ray, hit, t)
    } else {
        Place::on_surface(scene, path, ray, hit, is_boundary)
    };
    let wo = place.local_direction(scene, -ray.direction);
    if limits.goes_straight(path, &bsdf, wo, lobe) {
        path.beta *= compensation;
        return Arrival::Pass(pass(scene, path, ray, hit));
    }
    path.is_clipped = scene.cuts.clips_after(hit);
    let wants_light = !bsdf.is_delta() && !limits.ends(path, kind);
    let (u, is_in_medium) = ([u, v, lobe], is_scattered);
    Arrival::Scatter(Scatter { place, bsdf, wo, u, compensation, is_in_medium, is_boundary, wants_light })
}

/// The last part of [`advance`]: where the path goes next, `None` where it ends. Before it comes [`shadow_ray`].
#[inline]
pub fn leave(
    scene: &PackedScene,
    limits: &Limits,
    path: &mut Path,
    (ray, hit): (&Ray, &Hit),
    scatter: &Scatter,
) -> Option<Ray> {
    let Scatter { place, bsdf, wo, u, compensation, is_boundary, .. } = scatter;
    let bounce = bsdf.sample(*wo, *u)?;
    let is_transmitted = *is_boundary && bounce.wi.z < 0.0;
    let kind = if is_transmitted { BounceKind::Transmitted } else { kind_of(bsdf) };
    if limits.ends(path, kind) {
        return None;
    }
    path.kinds = BounceLimits::counted(limits.kinds, path.kinds, kind);
    path.scattered += u32::from(path.scattered > 0 || !bounce.is_delta);
    path.beta = path.beta * bounce.weight * *compensation;
    path.pdf = if bounce.is_delta { 0.0 } else { bounce.pdf };
    path.normal = place.receiver.normal;
    path.passed_t = 0.0;
    path.event += 1;
    let direction = place.world_direction(scene, bounce.wi);
    if is_transmitted {
        path.inside = Inside::beyond(scene, hit);
        return Some(Ray::new(behind_face(scene, ray, hit), direction));
    }
    path.inside = place.inside;
    path.bounce += 1;
    Some(Ray::new(place.receiver.point, direction))
}

/// The light that a chosen light gives where a path is to be scattered, unless something lies in its way. `None` where cuts take it away.
#[inline]
pub fn shadow_ray(
    scene: &PackedScene,
    limits: &Limits,
    path: &Path,
    scatter: &Scatter,
    sample: &LightSample,
) -> Option<ShadowRay> {
    let Scatter { place, bsdf, wo, compensation, is_in_medium, .. } = scatter;
    if !scene.cuts.admits(&sample.ray, path.is_clipped) {
        return None;
    }
    let toward = place.local_direction(scene, sample.ray.direction);
    // What lies above the horizon is for the light to say: its cosine holds.
    let wi = if *is_in_medium { toward } else { toward.with_z(sample.cos_theta) };
    let eval = bsdf.eval(*wo, wi);
    let share = eval.pdf / sample.pdf * power_heuristic(sample.pdf, eval.pdf);
    let radiance = path.beta * eval.weight * *compensation * sample.radiance * share;
    let radiance = limits.clamped(radiance, path.scattered > 0);
    Some(ShadowRay { ray: sample.ray, inside: place.inside, is_clipped: path.is_clipped, radiance })
}

/// What a path met: the material of a surface, whose emission counts, and the model that scatters the path. Lines have no emission.
#[inline]
pub(super) fn met<'a>(
    scene: &'a PackedScene,
    lines: &Lines,
    path: &Path,
    (ray, hit, material): (&Ray, &Hit, u32),
    lobe: &mut f32,
) -> (Option<&'a PackedMaterial>, MaterialBsdf) {
    let mut surface = |index: u32, ior: f32| {
        if let Some(reflectance) = lines.color_at(scene, index, ray, hit) {
            return (None, MaterialBsdf::Diffuse(Diffuse { reflectance }));
        }
        let material = &scene.materials()[index as usize];
        (Some(material), MaterialBsdf::new(material, ior, lobe))
    };
    let Some(inside) = &path.inside else { return surface(material, 1.0) };
    let medium = inside.medium(scene);
    if hit.is_miss() {
        return (None, MaterialBsdf::within(medium));
    }
    match scene.material_beyond(hit) {
        None => (None, MaterialBsdf::out_of(medium)),
        Some(index) => surface(index, medium.ior),
    }
}

/// How a model scatters; of the boundary of a medium, what it reflects.
#[inline]
fn kind_of(bsdf: &MaterialBsdf) -> BounceKind {
    match bsdf {
        MaterialBsdf::Diffuse(_) | MaterialBsdf::Plastic(_) => BounceKind::Diffuse,
        MaterialBsdf::Conductor(_) | MaterialBsdf::Dielectric(_) => BounceKind::Glossy,
        MaterialBsdf::Phase(_) => BounceKind::Volume,
    }
}

/// Where a path is scattered: on a surface, or in the middle of a medium, whose frame is world space.
struct Place {
    receiver: Receiver,
    /// The voxel that the place is in, `None` in air.
    inside: Option<Inside>,
    /// The instance of a surface, [`Hit::NONE`] in a medium, and the face as [`Surface`] has it.
    instance: u32,
    face: Option<Face>,
}

impl Place {
    #[inline]
    fn on_surface(scene: &PackedScene, path: &Path, ray: &Ray, hit: &Hit, is_boundary: bool) -> Self {
        let mut surface = Surface::new(scene, ray, hit);
        if !is_boundary {
            let is_lifted = path.inside.is_none_or(|inside| inside.instance != hit.instance);
            surface.smooth(scene, ray, hit, is_lifted);
        }
        let inside = path.inside.and_then(|inside| inside.in_front(scene, hit, &surface));
        let Surface { origin, normal, face, .. } = surface;
        Self { receiver: Receiver::on_surface(origin, normal), inside, instance: hit.instance, face }
    }

    fn in_medium(scene: &PackedScene, path: &Path, ray: &Ray, hit: &Hit, t: f32) -> Self {
        let inside = path.inside.map(|inside| Inside { voxel: hit.voxel, ..inside });
        let point = inside.map_or(ray.at(t), |inside| inside.point(scene, ray, t));
        Self { receiver: Receiver::in_medium(point), inside, instance: Hit::NONE, face: None }
    }

    /// The surface, `None` in a medium.
    #[inline]
    fn surface<'a>(&self, scene: &'a PackedScene) -> Option<Surface<'a>> {
        let Self { receiver: Receiver { point, normal, .. }, instance, face, .. } = *self;
        let instance = scene.placement.instances.get(instance as usize)?;
        Some(Surface { origin: point, normal, face, instance })
    }

    #[inline]
    fn local_direction(&self, scene: &PackedScene, world: Vec3) -> Vec3 {
        self.surface(scene).map_or_else(|| normalize(world), |surface| surface.local_direction(world))
    }

    #[inline]
    fn world_direction(&self, scene: &PackedScene, local: Vec3) -> Vec3 {
        self.surface(scene).map_or(local, |surface| surface.world_direction(local))
    }
}

/// Lets a path pass a boundary that does not refract.
fn pass(scene: &PackedScene, path: &mut Path, ray: &Ray, hit: &Hit) -> Ray {
    path.passed_t += hit.t;
    path.event += 1;
    path.inside = Inside::beyond(scene, hit);
    Ray::new(behind_face(scene, ray, hit), ray.direction)
}

/// Plays Russian roulette with a path of whose light `scattered` goes on: `None` where it ends, else the factor with which
/// the survivors carry the light of the others.
#[inline]
fn roulette(event: u32, scattered: Vec3, u: f32) -> Option<f32> {
    if event < SURE_BOUNCES {
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
