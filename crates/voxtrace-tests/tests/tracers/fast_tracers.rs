//! The `fast` tracers, without exact decisions and with relaxed floating-point rules: right for rays that are not aimed at edges.

use std::sync::Arc;
use voxtrace::{CpuTracer, Hit, PackedScene, Ray, Tracer};
use voxtrace_test_support::skip;
use voxtrace_tests::gpu::{assert_valid, cases, device};
use voxtrace_tests::rays::KINDS;
use voxtrace_vulkan::{Primitive, Settings, Traversal, VulkanTracer, missing};

const RAYS: usize = 1 << 16;

fn cast(tracer: &mut dyn Tracer, scene: &Arc<PackedScene>, rays: &[Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit { t: -1.0, instance: 7, ..Hit::MISS }; rays.len()];
    tracer.set_scene(scene).unwrap();
    tracer.cast_into(rays, &mut hits).unwrap();
    hits
}

/// Whether both hits are of the same voxel and face, with t within 4 units in the last place.
fn is_same(a: &Hit, b: &Hit) -> bool {
    (a.instance, a.voxel, a.face) == (b.instance, b.voxel, b.face) && a.t.to_bits().abs_diff(b.t.to_bits()) <= 4
}

fn check(traversal: Traversal, primitive: Primitive) {
    let Some(device) = device() else { return };
    if let Some(reason) = missing(device.info(), traversal) {
        skip(&format!("{}: {reason}", device.info().name));
        return;
    }
    let settings = Settings { traversal, primitive, is_exact: false };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
    let is_random = |index: usize| KINDS[index % KINDS.len()].starts_with("random");
    let (mut random_rays, mut random_wrong, mut other_wrong) = (0, 0, 0);
    // The rays of "placed" come in another order.
    for case in cases(RAYS).into_iter().filter(|case| case.name != "placed") {
        let expected = cast(&mut CpuTracer::new(None), &case.scene, &case.rays);
        let hits = cast(&mut tracer, &case.scene, &case.rays);
        for (index, (hit, expected)) in hits.iter().zip(&expected).enumerate() {
            let wrong = u32::from(!is_same(hit, expected));
            if is_random(index) || case.name == "city" {
                (random_rays, random_wrong) = (random_rays + 1, random_wrong + wrong);
            } else {
                other_wrong += wrong;
            }
        }
    }
    assert!(f64::from(random_wrong) <= 1e-4 * f64::from(random_rays), "{primitive:?}: {random_wrong} of {random_rays}");
    // Rays through corners and along edges must tell the two walks apart: else both were the same one.
    assert!(other_wrong > 100, "{other_wrong} rays differ");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn the_fast_walk_is_right_on_random_rays() {
    check(Traversal::Walk, Primitive::default());
}

#[test]
fn fast_queries_are_right_on_random_rays() {
    for primitive in [Primitive::Brick, Primitive::Grid, Primitive::Triangle] {
        check(Traversal::Query, primitive);
    }
}

#[test]
fn fast_pipelines_are_right_on_random_rays() {
    for primitive in [Primitive::VoxelExact, Primitive::Brick, Primitive::Grid, Primitive::Triangle] {
        check(Traversal::Pipeline, primitive);
    }
}
