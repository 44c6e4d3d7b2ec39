//! The same hits and films of what is cut from every tracer.

use super::{cut, frames, plane, things};
use std::sync::Arc;
use voxtrace::cuts::Cuts;
use voxtrace::glam::Vec3;
use voxtrace::{CpuTracer, Film, Frame, Hit, Scene, Tracer};
use voxtrace_tests::gpu::{
    Method, ONE_OF_EACH, assert_valid, compare_hits, device, exact_methods, film, film_methods, for_each_tracer,
};
use voxtrace_tests::rays::mixed;

/// Through everything: a plane along the voxels between two layers, a tilted one, and one through a lamp.
fn three_planes() -> Cuts {
    let cuts = plane([0.0, -1.0, 0.0], 4.0).plane(Vec3::new(0.3, -0.2, 1.0), 5.2).unwrap();
    cuts.plane(Vec3::X, 5.4).unwrap()
}

/// The films of some frames and the hits of some rays, by every method of a device, beside those of the processor.
fn compare_tracers(scene: &Scene, cuts: &Cuts, frames: &[Frame], few: &[Method]) {
    let packed = cut(scene, cuts);
    let grid = Arc::clone(&scene.grids[0]);
    let rays = mixed(&grid, 6000, 23);
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&packed).unwrap();
    let hits = |tracer: &mut dyn Tracer| {
        let mut hits = vec![Hit::MISS; rays.len()];
        tracer.cast_into(&rays, &mut hits).unwrap();
        hits
    };
    let expected_hits = hits(&mut cpu);
    assert!(expected_hits.iter().filter(|hit| !hit.is_miss() && hit.cut().is_some()).count() > 200);
    let expected: Vec<Film> = frames.iter().map(|frame| film(&mut cpu, frame)).collect();
    let Some(device) = device() else { return };
    for_each_tracer(&device, &film_methods(&device, few), &packed, |tracer, traversal, primitive| {
        compare_hits(&rays, &hits(tracer), &expected_hits)
            .unwrap_or_else(|error| panic!("{traversal:?} {primitive:?}: {error}"));
        for (index, (frame, expected)) in frames.iter().zip(&expected).enumerate() {
            let found = film(tracer, frame);
            let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "pixels of view {index} by {traversal:?} {primitive:?}: {cuts:?}");
            assert!(found.aovs == expected.aovs, "AOVs of view {index} by {traversal:?} {primitive:?}");
        }
    });
    assert_valid(&device);
}

#[test]
fn every_method_finds_the_same_hits_in_what_is_kept() {
    compare_tracers(&things(true, true), &three_planes(), &[], &exact_methods());
    compare_tracers(&things(true, false), &three_planes(), &[], &exact_methods());
}

#[test]
fn every_traversal_makes_the_same_films_from_within_and_by_every_integrator() {
    compare_tracers(&things(true, true), &three_planes(), &frames(), &ONE_OF_EACH);
}

#[test]
fn every_traversal_makes_the_same_films_where_what_is_cut_away_casts_shadows() {
    compare_tracers(&things(false, true), &three_planes().shadows(true), &frames(), &ONE_OF_EACH);
}

#[test]
fn the_walk_makes_the_same_films_of_one_grid_that_stands_where_its_instance_does() {
    compare_tracers(&things(false, false), &three_planes(), &frames(), &ONE_OF_EACH[..1]);
}
