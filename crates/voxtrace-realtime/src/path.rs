//! One path of one pixel, split into what is seen directly, which has no noise but that of edges, and the light that falls on what is seen. It is a path of
//! the integrator, but for two things: its first light is one of several candidates, and it ends where the light cache knows what comes from there.

use crate::light_cache::{LightCache, Request};
use crate::memory::in_ten_bits;
use crate::movers::Movers;
use crate::visibility::Visibility;
use glam::Vec3;
use voxtrace_core::cuts;
use voxtrace_core::integrator::path::{self, Arrival, Limits};
use voxtrace_core::integrator::seen::Seen;
use voxtrace_core::integrator::{DIMENSION_CAMERA, Path, ShadowRay, cast_in_medium};
use voxtrace_core::light::{BELOW_ONE, Lights};
use voxtrace_core::math::luminance;
use voxtrace_core::medium::{MAX_BOUNDARIES, Transit};
use voxtrace_core::packed::PackedScene;
use voxtrace_core::sampler::Sampler;
use voxtrace_core::walk;
use voxtrace_scene::camera::CameraFrame;
use voxtrace_scene::ray::{Hit, Ray};

/// First dimension of the sampler for candidates of lights but the first.
const DIMENSION_CANDIDATES: u32 = 1 << 30;
/// First dimension of the sampler for levels of the light cache.
const DIMENSION_LEVEL: u32 = 3 << 30;

/// How far albedos, and what is seen directly, of two rays of a pixel may be apart to be the same: a share of the larger one, and so much more.
const LOOK_TOLERANCE: [f32; 2] = [0.1, 0.01];

/// What the paths of a frame share.
pub struct View<'a> {
    /// The scene.
    pub scene: &'a PackedScene,
    /// Its lights.
    pub lights: Lights<'a>,
    /// How far paths go.
    pub limits: Limits,
    /// The camera.
    pub camera: CameraFrame,
    /// Its place, world units.
    pub eye: Vec3,
    /// What the picture's height sees, radians: cells of the light cache are a part of it.
    pub view_angle: f32,
    /// Whether paths enter voxels.
    pub has_media: bool,
    /// Lights of which a path's first surface chooses one.
    pub candidates: u32,
    /// Light on faces, where it is used.
    pub cache: Option<&'a LightCache>,
    /// Which instances have moved since the camera stands.
    pub(crate) movers: &'a Movers,
    /// How often rays to lights arrive, where that weighs candidates.
    pub visibility: Option<&'a Visibility>,
    /// [`Request::scramble_of`] of the frame.
    pub scramble: u32,
}

/// The surface that a sample shows, through mirrors and clear glass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Unit normal, world space, in ten bits an axis.
    pub normal: Vec3,
    /// Where it seems to be, world space: as far along the camera's ray as the way to it is long.
    pub place: Vec3,
    /// Its instance, where it is seen without mirror or glass.
    pub instance: u32,
}

impl Shown {
    /// What stands for the sky, which has no place, where it is seen by chance, `way` along the camera's ray: a plane before the eye, as far as what sent the ray there.
    fn sky(camera_ray: &Ray, way: f32) -> Self {
        let normal = in_ten_bits(-camera_ray.direction.normalize());
        Self { normal, place: camera_ray.at(way), instance: Hit::NONE }
    }
}

/// What one path found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Radiance that is seen directly: emitters and sky.
    pub direct: Vec3,
    /// Radiance of light that the shown surface scatters; of light that media scatter, where no surface is shown; and of emitters and sky that are seen by chance, as glass
    /// sends a ray on or back: that has noise.
    pub light: Vec3,
    /// Share of light that the shown surface scatters, times what of it arrives; 1 where a medium scatters it, 0 where nothing does. Of what is seen by chance what
    /// arrives.
    pub albedo: Vec3,
    /// The shown surface.
    pub shown: Option<Shown>,
    /// Whether something that has moved since the camera stands is in what the ray saw on its way there, or, in mist, may be.
    pub sees_mover: bool,
}

impl Sample {
    /// Whether what another ray of the pixel shows is not the same: then more of them look.
    pub(crate) fn differs(&self, other: &Self) -> bool {
        let [share, least] = LOOK_TOLERANCE;
        let is_far = |a: Vec3, b: Vec3| (a - b).abs().cmpgt(a.max(b) * share + least).any();
        self.shown.is_some() != other.shown.is_some()
            || is_far(self.direct, other.direct)
            || is_far(self.albedo, other.albedo)
    }
}

/// How a surface chooses a light.
#[derive(Clone, Copy)]
pub(crate) struct Choosing {
    /// Of so many candidates.
    pub candidates: u32,
    /// Whether it is counted if the chosen one arrives.
    pub learns: bool,
}

impl Choosing {
    /// None.
    const NOTHING: Self = Self { candidates: 0, ..Self::ANY };
    /// The first that comes.
    pub const ANY: Self = Self { candidates: 1, learns: false };
}

impl View<'_> {
    /// Follows the path of a pixel, which counts whether its ray to a light arrives where it `learns`. `requests` gets the cells of the light cache that it asked for.
    pub fn sample(&self, x: u32, y: u32, sampler: Sampler, learns: bool, requests: &mut Vec<Request>) -> Sample {
        let mut sample = Sample::default();
        let numbers = (sampler, sampler.stratified(DIMENSION_CAMERA));
        let choosing = Choosing { candidates: self.candidates, learns };
        let Some((mut path, mut ray)) = self.see((x, y), numbers, choosing, &mut sample) else { return sample };
        loop {
            let hit = self.cast(&path, &ray);
            if let Some(light) = self.cached(&path, &ray, &hit, u32::MAX, requests) {
                sample.light += light + self.emitted(&path, &ray, &hit);
                return sample;
            }
            let next = self.advance(&mut path, (&ray, &hit), &mut sample.light);
            let Some(next) = next else { return sample };
            ray = next;
        }
    }

    /// What a pixel shows, by a ray of the camera that its four numbers `jitter` choose: as [`Self::sample`], without the light that falls there.
    pub fn look(&self, x: u32, y: u32, sampler: Sampler, jitter: [f32; 4]) -> Sample {
        let mut sample = Sample::default();
        self.see((x, y), (sampler, jitter), Choosing::NOTHING, &mut sample);
        sample
    }

    /// Follows the camera's ray through mirrors and clear glass to the surface that it shows. Returns how the path goes on from there.
    fn see(
        &self,
        (x, y): (u32, u32),
        (sampler, jitter): (Sampler, [f32; 4]),
        choosing: Choosing,
        sample: &mut Sample,
    ) -> Option<(Path, Ray)> {
        let (mut path, camera_ray) = Path::from_camera(&self.camera, x, y, sampler, jitter);
        if self.has_media {
            path = path.in_medium(self.scene, &camera_ray);
        }
        let (mut ray, mut way, mut by_chance) = (camera_ray, 0.0, false);
        loop {
            let hit = self.cast(&path, &ray);
            sample.sees_mover |= !hit.is_miss() && self.movers.have(hit.instance);
            let (mut arrived, mut light) = (path, Vec3::ZERO);
            let mut direct = Vec3::ZERO;
            let next = self.advance_apart(&mut path, (&ray, &hit), choosing, &mut direct, &mut light);
            let is_lit = by_chance && direct.max_element() > 0.0;
            *(if is_lit { &mut sample.light } else { &mut sample.direct }) += direct;
            sample.light += light;
            if path.scattered == 0
                && let Some(next) = next
            {
                by_chance |= self.is_by_chance(&arrived, &path, &hit);
                way += hit.t;
                ray = next;
                continue;
            }
            if !hit.is_miss() {
                if let Some(inside) = arrived.inside {
                    arrived.absorb(self.scene, &inside, &ray, hit.t);
                }
                let seen = Seen::new(self.scene, &self.limits.lines, (&ray, &hit), arrived.beta, true);
                sample.albedo = if is_lit { arrived.beta } else { seen.albedo };
                sample.shown = Some(Shown {
                    normal: in_ten_bits(self.scene.shading_normal(&ray, &hit)),
                    place: camera_ray.at(way + hit.t),
                    instance: if way > 0.0 { Hit::NONE } else { hit.instance },
                });
            } else if arrived.inside.is_some() {
                // A path that meets nothing in a medium is scattered there.
                sample.albedo = Vec3::ONE;
                sample.sees_mover |= !self.movers.moved().is_empty();
            } else if is_lit {
                sample.albedo = arrived.beta;
                sample.shown = Some(Shown::sky(&camera_ray, way));
            }
            return next.map(|next| (path, next));
        }
    }

    /// Whether chance chose where a path went straight on from `hit`: all but metal sends rays back or on, and what does not refract lets all pass.
    fn is_by_chance(&self, arrived: &Path, path: &Path, hit: &Hit) -> bool {
        let is_metal = || self.scene.materials()[arrived.material(self.scene, hit) as usize].metallic >= 1.0;
        path.normal != Vec3::ZERO && (arrived.inside.is_some() || !is_metal())
    }

    /// What a path's ray meets.
    pub fn cast(&self, path: &Path, ray: &Ray) -> Hit {
        match &path.inside {
            Some(inside) => cast_in_medium(self.scene, path, inside, ray),
            None => cuts::cast(self.scene, ray, path.is_clipped),
        }
    }

    /// Takes a path one bounce further, as the integrator does; `light` gets what arrives.
    pub fn advance(&self, path: &mut Path, at: (&Ray, &Hit), light: &mut Vec3) -> Option<Ray> {
        let (mut emitted, mut chosen) = (Vec3::ZERO, Vec3::ZERO);
        let next = self.advance_apart(path, at, Choosing::ANY, &mut emitted, &mut chosen);
        *light += emitted;
        *light += chosen;
        next
    }

    /// As [`Self::advance`]; `emitted` gets what was met, `light` what the chosen light gives.
    fn advance_apart(
        &self,
        path: &mut Path,
        (ray, hit): (&Ray, &Hit),
        choosing: Choosing,
        emitted: &mut Vec3,
        light: &mut Vec3,
    ) -> Option<Ray> {
        let scene = self.scene;
        let material = path.material(scene, hit);
        match path::arrive(
            scene,
            &self.lights,
            &self.limits,
            path,
            (ray, hit, material),
            Path::scatter_numbers,
            emitted,
        ) {
            Arrival::End => None,
            Arrival::Pass(next) => Some(next),
            Arrival::Scatter(scatter) => {
                let candidates = if scatter.wants_light { choosing.candidates } else { 0 };
                let visibility = self.visibility.filter(|_| candidates > 1);
                let mut choice = Choice::default();
                for candidate in 0..candidates {
                    let (u, v) = self.candidate(path, candidate, candidates);
                    let found = self.lights.sample(scatter.receiver(), u);
                    let shadow_ray =
                        found.and_then(|found| path::shadow_ray(scene, &self.limits, path, &scatter, &found));
                    let weight = visibility.zip(shadow_ray.as_ref()).map_or(1.0, |(visibility, shadow_ray)| {
                        visibility.weight(Visibility::place(&shadow_ray.ray, self.eye, self.view_angle))
                    });
                    choice.add(shadow_ray, weight, v);
                }
                if let Some(shadow_ray) = choice.chosen() {
                    let (arriving, has_arrived) = self.arriving(&shadow_ray);
                    *light += arriving;
                    // Of surfaces that are seen directly and matte alone, as waves on devices know no others.
                    if let Some(has_arrived) = has_arrived
                        && let Some(visibility) = visibility.filter(|_| choosing.learns && path.event == 0)
                        && !hit.is_miss()
                        && scene.materials()[material as usize].is_matte()
                    {
                        visibility.count(Visibility::place(&shadow_ray.ray, self.eye, self.view_angle), has_arrived);
                    }
                }
                path::leave(scene, &self.limits, path, (ray, hit), &scatter)
            }
        }
    }

    /// Random numbers of one of several candidates: those that choose the light, and one that chooses between it and those before. The first number, which goes down
    /// the trees of lights, is stratified among the candidates.
    pub(crate) fn candidate(&self, path: &Path, candidate: u32, candidates: u32) -> ([f32; 4], f32) {
        let dimension = DIMENSION_CANDIDATES + 64 * path.event + 2 * candidate;
        let mut light = match candidate {
            0 => path.sampler.stratified(path.dimension_light()),
            _ => path.sampler.independent(dimension),
        };
        light[0] = ((candidate as f32 + light[0]) * (1.0 / candidates as f32)).min(BELOW_ONE);
        (light, path.sampler.independent(dimension + 1)[0])
    }

    /// What the cache knows of the light that the face which `ray` met sends on along the path; `life` is that of the one who asks. Faces that are no
    /// matte ones are not asked for, nor are those that are near beside the size of a cell, seen from a path's first surface: there a cell is too coarse for what lies beside it.
    pub(crate) fn cached(
        &self,
        path: &Path,
        ray: &Ray,
        hit: &Hit,
        life: u32,
        requests: &mut Vec<Request>,
    ) -> Option<Vec3> {
        let cache = self.cache?;
        if hit.is_miss() || path.inside.is_some() || hit.cut().is_some() {
            return None;
        }
        let material = &self.scene.materials()[path.material(self.scene, hit) as usize];
        if material.metallic > 0.0 || material.transmission > 0.0 {
            return None;
        }
        let place = ray.at(hit.t);
        let size = LightCache::size(self.view_angle, (place - self.eye).length());
        let u = path.sampler.independent(DIMENSION_LEVEL + path.event)[0];
        let request = Request::of(hit, size, u, life, self.scramble);
        let is_from_first = path.scattered < 2;
        if is_from_first && hit.t * ray.direction.length() < LightCache::least_distance(&request) {
            return None;
        }
        requests.push(request);
        Some(path.beta * material.base_color * cache.light(&request.key)?)
    }

    /// What is emitted where a path's ray ended, weighed as the integrator does.
    pub(crate) fn emitted(&self, path: &Path, ray: &Ray, hit: &Hit) -> Vec3 {
        let (mut path, mut light) = (*path, Vec3::ZERO);
        let last = Limits { max_bounces: path.bounce, ..self.limits };
        let material = path.material(self.scene, hit);
        path::arrive(
            self.scene,
            &self.lights,
            &last,
            &mut path,
            (ray, hit, material),
            Path::scatter_numbers,
            &mut light,
        );
        light
    }

    /// Whether light may pass straight through what a ray to a light met.
    fn lets_light_pass(&self, hit: &Hit) -> bool {
        let material = &self.scene.materials()[self.scene.packed_material_index(hit) as usize];
        material.transmission > 0.0 && (material.ior == 1.0 || self.limits.clear_shadows)
    }

    /// What arrives along a ray to a light, and whether it meets nothing, unless what it meets first lets light pass.
    pub(crate) fn arriving(&self, shadow_ray: &ShadowRay) -> (Vec3, Option<bool>) {
        let ShadowRay { ray, inside, is_clipped, radiance } = *shadow_ray;
        if !self.has_media {
            let is_blocked = match self.scene.cuts.is_none() {
                true => walk::occluded(self.scene, &ray),
                false => !cuts::cast(self.scene, &ray, is_clipped).is_miss(),
            };
            return (if is_blocked { Vec3::ZERO } else { radiance }, Some(!is_blocked));
        }
        let mut transit = Transit { ray, inside, light: radiance, is_clipped };
        let mut has_arrived = None;
        for boundary in 0..MAX_BOUNDARIES {
            let hit = match &transit.inside {
                Some(inside) => cuts::cast_inside(self.scene, &transit.ray, inside, is_clipped),
                None => cuts::cast(self.scene, &transit.ray, is_clipped),
            };
            if boundary == 0 && inside.is_none() && (hit.is_miss() || !self.lets_light_pass(&hit)) {
                has_arrived = Some(hit.is_miss());
            }
            if !transit.advance(self.scene, &hit, self.limits.clear_shadows) {
                return (transit.light, has_arrived);
            }
        }
        (Vec3::ZERO, has_arrived)
    }
}

/// One of several candidates, chosen by what it would give were nothing in its way, and made to stand for all (Talbot, Cline, Egbert, "Importance Resampling
/// for Global Illumination", EGSR 2005).
#[derive(Default)]
pub(crate) struct Choice {
    chosen: Option<(ShadowRay, f32)>,
    sum: f32,
    candidates: u32,
}

impl Choice {
    /// Another candidate, `None` where no light was found, which counts `times` what it would give; `u`, uniform in [0, 1), chooses between it and those before.
    pub fn add(&mut self, shadow_ray: Option<ShadowRay>, times: f32, u: f32) {
        self.candidates += 1;
        let Some(shadow_ray) = shadow_ray else { return };
        let weight = luminance(shadow_ray.radiance) * times;
        self.sum += weight;
        if u * self.sum < weight {
            self.chosen = Some((shadow_ray, weight));
        }
    }

    /// The chosen one.
    pub fn chosen(self) -> Option<ShadowRay> {
        let (shadow_ray, weight) = self.chosen?;
        let radiance = shadow_ray.radiance * (self.sum / (weight * self.candidates as f32));
        Some(ShadowRay { radiance, ..shadow_ray })
    }
}
