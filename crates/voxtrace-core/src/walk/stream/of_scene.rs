//! Rays through scenes of several instances: each lane has a ray and the grid of one of its instances. A ray that is done with one waits
//! until the next one is looked for, and is put into a free lane once it has entered that.

use super::arrivals::Arrivals;
use super::grids::OwnGrids;
use super::journeys::Journeys;
use super::kernel::Kernel;
use super::{Lanes, RAY, REFILL_AT};
use crate::packed::{PackedScene, WideTree};
use crate::walk::simd::{Simd, lanes_of};
use voxtrace_scene::ray::{Hit, Ray};

/// Vectors of rays that are stepped in turn.
pub const GROUPS: usize = 4;

/// Finds for each ray its first hit in a scene, or where `any` hit will do one that need not be the first.
///
/// # Safety
/// The scene must be valid, and `tree` its own.
#[inline(always)]
pub unsafe fn first_hits<S: Simd>(
    simd: S,
    (scene, tree): (&PackedScene, &WideTree),
    rays: &[Ray],
    any: bool,
    hits: &mut [Hit],
) {
    let kernel = Kernel::new(simd, &scene.geometry, OwnGrids);
    let mut journeys = Journeys::new((scene, tree), rays, any, hits);
    let mut arrivals = Arrivals::new();
    let mut groups = [Lanes::empty(); GROUPS];
    let mut is_under_way = true;
    while is_under_way {
        is_under_way = false;
        for lanes in &mut groups {
            if lanes.active != 0 {
                // SAFETY: the scene is valid, so every position the kernel computes lies inside its array.
                let step = unsafe { kernel.step(lanes) };
                let done = lanes.active & !step.active;
                lanes.active = step.active;
                for lane in lanes_of(step.unsure) {
                    lanes.decide(lane, lanes.grids.origin_of(lane));
                }
                if step.hit != 0 {
                    let met = kernel.meet(lanes);
                    for lane in lanes_of(step.hit) {
                        journeys.take_hit(&met, lanes, lane);
                    }
                }
                for lane in lanes_of(done) {
                    journeys.wait(lanes.integers[RAY][lane] as usize);
                }
            }
            if lanes.active.count_zeros() >= REFILL_AT {
                arrivals.fill(simd, &mut journeys, lanes);
            }
            if lanes.active != 0 {
                // SAFETY: as above.
                unsafe { kernel.look_ahead(lanes) };
                is_under_way = true;
            }
        }
    }
}
