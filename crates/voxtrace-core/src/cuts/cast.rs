//! Rays through what cuts keep: the walks look along the part that is kept.

use crate::medium::{self, Inside};
use crate::packed::PackedScene;
use crate::walk::{self, WalkCounts};
use voxtrace_scene::ray::{Hit, Ray};

/// Finds the first hit of a ray; where it is not clipped, in the whole scene.
pub fn cast(scene: &PackedScene, ray: &Ray, is_clipped: bool) -> Hit {
    let span = scene.cuts.span_of(ray, is_clipped);
    span.entered(walk::cast_whole(scene, &span.part(ray)))
}

/// Finds for each ray its first hit; `is_clipped` says of each whether it is clipped. Both slices have the same length.
pub(crate) fn cast_batch(
    scene: &PackedScene,
    rays: &[Ray],
    hits: &mut [Hit],
    is_clipped: impl Fn(usize) -> bool,
) -> WalkCounts {
    let spans: Vec<_> =
        rays.iter().enumerate().map(|(index, ray)| scene.cuts.span_of(ray, is_clipped(index))).collect();
    let parts: Vec<Ray> = rays.iter().zip(&spans).map(|(ray, span)| span.part(ray)).collect();
    let counts = walk::cast_batch_whole(scene, &parts, hits);
    for (hit, span) in hits.iter_mut().zip(&spans) {
        *hit = span.entered(*hit);
    }
    counts
}

/// Finds for each ray whether anything lies on the part of its segment that it sees.
pub(crate) fn occluded_batch(
    scene: &PackedScene,
    rays: &[Ray],
    blocked: &mut [bool],
    is_clipped: impl Fn(usize) -> bool,
) -> WalkCounts {
    let part = |(index, ray)| scene.cuts.span_of(ray, is_clipped(index)).part(ray);
    let parts: Vec<Ray> = rays.iter().enumerate().map(part).collect();
    walk::occluded_batch(scene, &parts, blocked)
}

/// As [`medium::cast_inside`]: where the medium is cut, the ray leaves it through the face of the cut.
pub fn cast_inside(scene: &PackedScene, ray: &Ray, inside: &Inside, is_clipped: bool) -> Hit {
    let span = scene.cuts.span_of(ray, is_clipped);
    let hit = medium::cast_inside(scene, &span.up_to_its_end(ray), inside);
    span.left(hit, ray.t_min, ray.t_max, inside)
}
