//! What the rays of a wave meet that may be in media: those in air are traced together, and those in a medium around all else; others go from
//! voxel to voxel one after the other.

use super::wave::RenderContext;
use crate::cuts;
use crate::medium::{Inside, RaysWithin};
use crate::walk::{self, WalkCounts};
use voxtrace_scene::ray::{Hit, Ray};

/// Room for the rays of a wave.
#[derive(Default)]
pub(super) struct InMedia {
    within: RaysWithin,
    /// Of the rays in air: their places, whether they are clipped, and their hits.
    places: Vec<usize>,
    rays: Vec<Ray>,
    is_clipped: Vec<bool>,
    hits: Vec<Hit>,
}

impl InMedia {
    /// Finds what rays meet, each with what it is in and whether it is clipped.
    pub fn cast(
        &mut self,
        context: &RenderContext,
        rays: impl Iterator<Item = (Ray, Option<Inside>, bool)>,
        hits: &mut [Hit],
    ) -> WalkCounts {
        let scene = context.scene;
        self.places.clear();
        self.rays.clear();
        self.is_clipped.clear();
        for (place, (ray, inside, is_clipped)) in rays.enumerate() {
            match &inside {
                None => {
                    self.places.push(place);
                    self.rays.push(ray);
                    self.is_clipped.push(is_clipped);
                }
                Some(inside) if context.surrounding.is_some_and(|around| around.is_around(inside)) => {
                    self.within.push(scene, place, &ray, inside, is_clipped);
                }
                Some(inside) => hits[place] = cuts::cast_inside(scene, &ray, inside, is_clipped),
            }
        }
        self.hits.resize(self.rays.len(), Hit::MISS);
        let mut counts = match scene.cuts.is_none() {
            true => walk::cast_batch_whole(scene, &self.rays, &mut self.hits),
            false => cuts::cast_batch(scene, &self.rays, &mut self.hits, |index| self.is_clipped[index]),
        };
        for (&place, hit) in self.places.iter().zip(&self.hits) {
            hits[place] = *hit;
        }
        if let Some(surrounding) = context.surrounding {
            counts += self.within.cast(scene, surrounding, hits);
        }
        counts
    }
}
