//! How cells of the light cache find their light: one ray to a light and one in a random direction from a random point of the face.

use super::{Cell, LightCache};
use crate::light_cache::Request;
use crate::path::{Choice, View};
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::FRAC_1_PI;
use voxtrace_core::integrator::{Path, ShadowRay};
use voxtrace_core::light::{LightSample, Receiver};
use voxtrace_core::math::{cosine_hemisphere, orthonormal_pair};
use voxtrace_core::sampler::{Sampler, pcg4d};
use voxtrace_core::surface::offset_ray_origin;
use voxtrace_scene::ray::Ray;

impl LightCache {
    /// Lets cells trace rays, those first that know nothing yet. Where there are more than the budget has room for, random numbers of their own choose: which
    /// cells lie beside which does not matter. Returns what they found, by their places, and what they asked for. What they read of each other is what was
    /// known before.
    pub(crate) fn trace(&self, view: &View, frame: u32, seed: u32) -> (Vec<(usize, Vec3)>, Vec<Request>) {
        let is_asked = |cell: &&Cell| cell.life > 0 && cell.voxel_code > 0;
        let count = |is_new: bool| self.cells.iter().filter(is_asked).filter(|cell| cell.is_new() == is_new).count();
        let (new, old) = (count(true) as u32, count(false) as u32);
        let budget = self.budget as u32;
        let (of_new, of_old) = (share(new, budget), share(old, budget - new.min(budget)));
        let is_chosen =
            |cell: &Cell| pcg4d([cell.key.hash(), frame, 1, seed])[0] <= if cell.is_new() { of_new } else { of_old };
        let chosen = |(_, cell): &(usize, &Cell)| is_asked(cell) && is_chosen(cell);
        let chosen: Vec<(usize, &Cell)> = self.cells.iter().enumerate().filter(chosen).collect();
        let trace = |&(place, cell): &(usize, &Cell)| {
            let mut requests = Vec::new();
            let sampler = Sampler { seed, pixel: cell.key.hash(), sample: frame };
            let light = cell.trace(view, self.scramble, sampler, &mut requests);
            ((place, light), requests)
        };
        let (found, requests): (Vec<_>, Vec<_>) = chosen.par_iter().map(trace).unzip();
        (found, requests.into_iter().flatten().collect())
    }
}

/// Up to which random word a cell is chosen, where there is room for `room` of `count`.
fn share(count: u32, room: u32) -> u32 {
    if count <= room { u32::MAX } else { u32::MAX / count * room }
}

impl Cell {
    /// Whether it knows nothing yet.
    fn is_new(&self) -> bool {
        self.samples == 0.0
    }

    /// A sample of what the face sends on of the light that falls on it, were it white.
    fn trace(&self, view: &View, scramble: u32, sampler: Sampler, requests: &mut Vec<Request>) -> Vec3 {
        let instance = &view.scene.instances()[self.key.instance as usize];
        let face = self.key.face();
        let [u, v, a, b] = sampler.independent(0);
        let low = self.key.voxel(self.voxel_code, scramble).as_vec3();
        let mut point = low;
        let axis = face.axis();
        point[(axis + 1) % 3] += u;
        point[(axis + 2) % 3] += v;
        let origin = instance.world_from_grid.point(offset_ray_origin(instance, low, face, point));
        let normal = instance.world_normal(face);
        let receiver = Receiver::on_surface(origin, normal);

        let (x, y) = orthonormal_pair(normal);
        let local = cosine_hemisphere(a, b);
        let mut ray = Ray::new(origin, x * local.x + y * local.y + normal * local.z);
        let mut path = Path::from_sampler(sampler);
        let mut choice = Choice::default();
        for candidate in 0..view.candidates {
            let (u, v) = view.candidate(&path, candidate, view.candidates);
            choice.add(view.lights.sample(&receiver, u).map(|light| lit(&light)), 1.0, v);
        }
        let mut light = choice.chosen().map_or(Vec3::ZERO, |shadow_ray| view.arriving(&shadow_ray).0);
        (path.normal, path.pdf) = (normal, local.z * FRAC_1_PI);
        // It stands for a path that was scattered by a surface before: what it finds is indirect light for whoever asks.
        (path.bounce, path.event, path.scattered) = (1, 1, 1);
        loop {
            let hit = view.cast(&path, &ray);
            if let Some(cached) = view.cached(&path, &ray, &hit, self.life.saturating_sub(1), requests) {
                return light + (cached + view.emitted(&path, &ray, &hit));
            }
            let Some(next) = view.advance(&mut path, (&ray, &hit), &mut light) else { return light };
            ray = next;
        }
    }
}

/// What a white matte surface sends on of a light, weighed by the power heuristic, unless something is in its way.
fn lit(light: &LightSample) -> ShadowRay {
    let ratio = light.cos_theta.max(0.0) * FRAC_1_PI / light.pdf;
    let radiance = light.radiance * (ratio * (1.0 / (1.0 + ratio * ratio)));
    ShadowRay { ray: light.ray, inside: None, is_clipped: true, radiance }
}
