//! The shadow rays of a wave: those of one bounce are traced together, through media from boundary to boundary.

use super::in_media::InMedia;
use super::ray_counts::RayCounts;
use super::wave::RenderContext;
use crate::cuts;
use crate::integrator::ShadowRay;
use crate::medium::{Inside, MAX_BOUNDARIES, Transit};
use crate::packed::PackedScene;
use crate::walk;
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// The shadow rays of one bounce: rays, the light and the slot of the sample behind each, and the answers.
#[derive(Default)]
pub(super) struct ShadowRays {
    rays: Vec<Ray>,
    light: Vec<(u32, Vec3)>,
    inside: Vec<Option<Inside>>,
    /// Empty where the scene has no cuts.
    is_clipped: Vec<bool>,
    blocked: Vec<bool>,
    /// Of those on their way through media, with the slots of their samples.
    under_way: Vec<(u32, Transit)>,
    in_media: InMedia,
    hits: Vec<Hit>,
}

impl ShadowRays {
    /// Takes another one, for the sample of a slot.
    #[inline]
    pub fn push(&mut self, scene: &PackedScene, slot: u32, shadow_ray: &ShadowRay) {
        self.rays.push(shadow_ray.ray);
        self.light.push((slot, shadow_ray.radiance));
        self.inside.push(shadow_ray.inside);
        if !scene.cuts.is_none() {
            self.is_clipped.push(shadow_ray.is_clipped);
        }
    }

    /// Adds the light whose shadow ray meets nothing, and what media leave of it, and forgets all rays.
    pub fn gather(&mut self, context: &RenderContext, counts: &mut RayCounts, add: impl FnMut(u32, Vec3)) {
        if context.has_media {
            self.gather_through_media(context, counts, add);
        } else {
            self.gather_in_air(context.scene, counts, add);
        }
        self.rays.clear();
        self.light.clear();
        self.inside.clear();
        self.is_clipped.clear();
    }

    fn gather_in_air(&mut self, scene: &PackedScene, counts: &mut RayCounts, mut add: impl FnMut(u32, Vec3)) {
        let Self { rays, light, is_clipped, blocked, .. } = self;
        blocked.resize(rays.len(), false);
        counts.light += rays.len() as u64;
        counts.walks += match scene.cuts.is_none() {
            true => walk::occluded_batch(scene, rays, blocked),
            false => cuts::occluded_batch(scene, rays, blocked, |index| is_clipped[index]),
        };
        for (&(slot, radiance), _) in light.iter().zip(blocked).filter(|(_, blocked)| !**blocked) {
            add(slot, radiance);
        }
    }

    fn gather_through_media(
        &mut self,
        context: &RenderContext,
        counts: &mut RayCounts,
        mut add: impl FnMut(u32, Vec3),
    ) {
        let (scene, is_clear) = (context.scene, context.frame.clear_shadows);
        let Self { rays, light, inside, is_clipped, under_way, in_media, hits, .. } = self;
        let all = rays.iter().zip(&*light).zip(&*inside).enumerate();
        under_way.clear();
        under_way.extend(all.map(|(index, ((&ray, &(slot, light)), &inside))| {
            let is_clipped = is_clipped.get(index).is_none_or(|is_clipped| *is_clipped);
            (slot, Transit { ray, inside, light, is_clipped })
        }));
        for _ in 0..MAX_BOUNDARIES {
            if under_way.is_empty() {
                break;
            }
            counts.light += under_way.len() as u64;
            hits.resize(under_way.len(), Hit::MISS);
            let rays = under_way.iter().map(|(_, transit)| (transit.ray, transit.inside, transit.is_clipped));
            counts.walks += in_media.cast(context, rays, hits);
            let mut found = hits.iter();
            under_way.retain_mut(|(slot, transit)| {
                let hit = found.next().copied().unwrap_or(Hit::MISS);
                let goes_on = transit.advance(scene, &hit, is_clear);
                if !goes_on && transit.light != Vec3::ZERO {
                    add(*slot, transit.light);
                }
                goes_on
            });
        }
    }
}
