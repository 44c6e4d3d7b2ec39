//! What is seen in mirrors and behind clear glass: features for filters and AOVs, as the documentation of Open Image Denoise advises for
//! surfaces that only send light on ("follow the path until the first diffuse or glossy surface"). Media that scatter are not clear:
//! the way ends on them. `docs/decisions/0052-bounces-and-mixes.md` says why filters get the sampled way and pictures the likeliest.

use super::path::{Limits, advance, met};
use super::{Path, cast_in_medium};
use crate::bsdf::{Bsdf, Conductor, Dielectric, MaterialBsdf, Microfacets, albedo_of, fresnel_dielectric};
use crate::cuts;
use crate::light::Lights;
use crate::lines::Lines;
use crate::medium::{Inside, attenuation};
use crate::packed::PackedScene;
use crate::surface::{Surface, behind_face};
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Most boundaries on the likeliest way.
const MOST_BOUNDARIES: usize = 32;

/// The surface at the end of a way through mirrors and clear glass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The last ray.
    pub ray: Ray,
    /// What it met; no miss.
    pub hit: Hit,
    /// Share of light that the surface scatters, times what mirrors and media leave of it on the way.
    pub albedo: Vec3,
    /// Whether each boundary of glass sent the path the likelier of its two ways.
    pub is_likely: bool,
}

impl Seen {
    /// What is seen of the surface where `ray` met `hit`, of whose light `throughput` arrives.
    pub fn new(
        scene: &PackedScene,
        lines: &Lines,
        (ray, hit): (&Ray, &Hit),
        throughput: Vec3,
        is_likely: bool,
    ) -> Self {
        let albedo = |index: u32| {
            let line = lines.color_at(scene, index, ray, hit);
            line.unwrap_or_else(|| albedo_of(&scene.materials()[index as usize]))
        };
        let albedo = throughput * scene.material_beyond(hit).map_or(Vec3::ONE, albedo);
        Self { ray: *ray, hit: *hit, albedo, is_likely }
    }
}

/// The medium in which a camera ray begins, if it is one that does not scatter. The place is looked up for each ray: whether there are media at all would
/// take a look at all materials.
pub fn clear_medium_at(scene: &PackedScene, ray: &Ray) -> Option<Inside> {
    let point = ray.at(ray.t_min);
    let inside = scene.cuts.keeps(point).then(|| scene.medium_at(point))??;
    (!scatters(scene, Some(&inside))).then_some(inside)
}

fn scatters(scene: &PackedScene, inside: Option<&Inside>) -> bool {
    inside.is_some_and(|inside| inside.medium(scene).scattering > 0.0)
}

/// Follows a path whose `ray` met `hit` the way that its own random numbers choose, as long as no other technique finds it, and adds
/// to `radiance` what it meets there: light that is seen directly, the same bits that the integrator gathers. `None` where it ends in
/// the sky.
pub fn follow(
    scene: &PackedScene,
    lights: &Lights,
    limits: &Limits,
    mut path: Path,
    (mut ray, mut hit): (Ray, Hit),
    radiance: &mut Vec3,
) -> Option<Seen> {
    let mut is_likely = true;
    loop {
        let mut arrived = path;
        if let Some(inside) = &path.inside {
            arrived.absorb(scene, inside, &ray, hit.t);
        }
        let here = (!hit.is_miss()).then(|| Seen::new(scene, &limits.lines, (&ray, &hit), arrived.beta, is_likely));
        let Some(reflectance) = mirror_at(scene, &limits.lines, &path, &ray, &hit) else {
            // The last bounce: what the surface emits counts, and nothing more.
            let last = Limits { max_bounces: path.bounce, ..*limits };
            advance(scene, lights, &last, &mut path, (&ray, &hit), radiance);
            return here;
        };
        let bounce = path.bounce;
        let Some(next) = advance(scene, lights, limits, &mut path, (&ray, &hit), radiance).0 else { return here };
        is_likely &= (path.bounce > bounce) == (reflectance > 0.5);
        if scatters(scene, path.inside.as_ref()) {
            return here;
        }
        ray = next;
        hit = match &path.inside {
            Some(inside) => cast_in_medium(scene, &path, inside, &ray),
            None => cuts::cast(scene, &ray, path.is_clipped),
        };
    }
}

/// How much of the light the boundary that a path met reflects, where it is a mirror, smooth glass or none at all; else `None`.
fn mirror_at(scene: &PackedScene, lines: &Lines, path: &Path, ray: &Ray, hit: &Hit) -> Option<f32> {
    if hit.is_miss() {
        return None;
    }
    let [_, _, _, mut lobe] = path.sampler.stratified(path.dimension_scatter());
    match met(scene, lines, path, (ray, hit, path.material(scene, hit)), &mut lobe).1 {
        MaterialBsdf::Dielectric(Dielectric { eta: 1.0, .. }) => Some(0.0),
        MaterialBsdf::Dielectric(glass) if glass.facets.is_smooth() => {
            let wo = Surface::new(scene, ray, hit).local_direction(-ray.direction);
            Some(fresnel_dielectric(wo.z.max(0.0), glass.eta))
        }
        MaterialBsdf::Conductor(metal) if metal.facets.is_smooth() => Some(1.0),
        _ => None,
    }
}

/// What the ray of a camera, which met `hit`, sees on the likeliest way: through glass unless more than half is reflected, and of a
/// mixture what more than half of it is. `None` for the sky.
pub fn likeliest(scene: &PackedScene, lines: &Lines, ray: &Ray, hit: &Hit) -> Option<Seen> {
    let (mut ray, mut hit, mut throughput) = (*ray, *hit, Vec3::ONE);
    let mut inside = clear_medium_at(scene, &ray);
    if let Some(inside) = &inside {
        hit = cuts::cast_inside(scene, &ray, inside, true);
    }
    for _ in 0..MOST_BOUNDARIES {
        if let Some(inside) = &inside {
            throughput *= attenuation(inside.medium(scene), hit.t * inside.voxels_per_t(scene, &ray));
        }
        if hit.is_miss() {
            return None;
        }
        let here = Seen::new(scene, lines, (&ray, &hit), throughput, true);
        let Some(bsdf) = likeliest_mirror(scene, lines, inside.as_ref(), (&ray, &hit)) else { return Some(here) };
        let mut surface = Surface::new(scene, &ray, &hit);
        if matches!(bsdf, MaterialBsdf::Conductor(_)) {
            surface.smooth(scene, &ray, &hit, inside.is_none());
        }
        let is_passed = matches!(bsdf, MaterialBsdf::Dielectric(Dielectric { eta: 1.0, .. }));
        let (direction, enters) = if is_passed {
            (ray.direction, true)
        } else {
            let bounce = bsdf.sample(surface.local_direction(-ray.direction), [0.5; 3]);
            let Some(bounce) = bounce else { return Some(here) };
            throughput *= bounce.weight;
            (surface.world_direction(bounce.wi), bounce.wi.z < 0.0)
        };
        let origin = if enters { behind_face(scene, &ray, &hit) } else { surface.origin };
        inside = match enters {
            true => Inside::beyond(scene, &hit),
            false => inside.and_then(|inside| inside.in_front(scene, &hit, &surface)),
        };
        if scatters(scene, inside.as_ref()) {
            return Some(here);
        }
        ray = Ray::new(origin, direction);
        let is_clipped = scene.cuts.clips_after(&hit);
        hit = match &inside {
            Some(inside) => cuts::cast_inside(scene, &ray, inside, is_clipped),
            None => cuts::cast(scene, &ray, is_clipped),
        };
    }
    (!hit.is_miss()).then(|| Seen::new(scene, lines, (&ray, &hit), throughput, true))
}

/// The mirror or smooth glass that more than half of a boundary is.
fn likeliest_mirror(
    scene: &PackedScene,
    lines: &Lines,
    inside: Option<&Inside>,
    (ray, hit): (&Ray, &Hit),
) -> Option<MaterialBsdf> {
    let medium = inside.map(|inside| inside.medium(scene));
    let bsdf = match (scene.material_beyond(hit), medium) {
        (None, None) => return None,
        (None, Some(medium)) => MaterialBsdf::out_of(medium),
        (Some(index), _) if lines.color_at(scene, index, ray, hit).is_some() => return None,
        (Some(index), medium) => {
            let material = &scene.materials()[index as usize];
            let facets = Microfacets::of(material.roughness);
            if material.metallic > 0.5 {
                MaterialBsdf::Conductor(Conductor { f0: material.base_color, facets })
            } else if (1.0 - material.metallic) * material.transmission > 0.5 {
                let eta = material.ior / medium.map_or(1.0, |medium| medium.ior);
                MaterialBsdf::Dielectric(Dielectric { eta, facets })
            } else {
                return None;
            }
        }
    };
    let is_passed = matches!(bsdf, MaterialBsdf::Dielectric(Dielectric { eta: 1.0, .. }));
    (is_passed || bsdf.is_delta()).then_some(bsdf)
}
