//! Every set of vector instructions that this processor has finds the hits of the walk of one ray after the other, also among instances that
//! are turned, mirrored, scaled and overlap; and whether anything is in the way.

use rayon::prelude::*;
use voxtrace::glam::Vec2;
use voxtrace::{Hit, Instructions, PackedScene, Ray};
use voxtrace_core::walk::{self, WalkCounts};
use voxtrace_tests::gpu::{Case, cases, compare_hits};
use voxtrace_tests::moving::moving;
use voxtrace_tests::random::Random;

/// Rays among a thousand small things, and the difficult ones of other tests.
fn all_cases() -> Vec<Case> {
    let mut all = cases(40_000);
    let scene = PackedScene::pack(&moving(1000, 3)).unwrap();
    let bounds = scene.bounds().unwrap();
    let mut random = Random(23);
    let mut ray = |index: usize| {
        let ray = Ray::new(random.point(bounds.0 - 5.0, bounds.1 + 5.0), random.direction());
        if index.is_multiple_of(4) { Ray { t_max: random.unit() * 20.0, ..ray } } else { ray }
    };
    let rays = (0..40_000).map(&mut ray).collect();
    all.push(Case { name: "moving", scene: scene.into(), rays });
    all
}

fn cast_with(instructions: Instructions, case: &Case) -> Vec<Hit> {
    // What nobody writes is noticed.
    let mut hits = vec![Hit { t: -1.0, ..Hit::MISS }; case.rays.len()];
    // Batches of odd lengths, long and short.
    let (first, rest) = case.rays.split_at(case.rays.len() / 4);
    let (first_hits, rest_hits) = hits.split_at_mut(first.len());
    let short = first.par_chunks(73).zip(first_hits.par_chunks_mut(73));
    let chunks = short.chain(rest.par_chunks(1021).zip(rest_hits.par_chunks_mut(1021)));
    let counts = chunks.map(|(rays, hits)| walk::cast_batch_with(instructions, &case.scene, rays, hits));
    let counts: Vec<WalkCounts> = counts.collect();
    let total = counts.iter().fold(WalkCounts::default(), |mut total, &counts| {
        total += counts;
        total
    });
    // What is said of the walk is what ran: packets in one grid alone, and with AVX-512 alone.
    assert_eq!(total.total(), case.rays.len() as u64, "{}, {instructions:?}: {total:?}", case.name);
    assert_eq!(total.scalar > 0, instructions == Instructions::Scalar, "{}, {instructions:?}: {total:?}", case.name);
    let may_be_packets = instructions == Instructions::Avx512 && case.scene.instances().len() == 1;
    assert!(total.packets == 0 || may_be_packets, "{}, {instructions:?}: {total:?}", case.name);
    hits
}

#[test]
fn all_instructions_find_the_same_hits_among_instances() {
    for case in all_cases() {
        let expected: Vec<Hit> = case.rays.par_iter().map(|ray| walk::cast(&case.scene, ray)).collect();
        assert!(expected.iter().filter(|hit| !hit.is_miss()).count() > case.rays.len() / 20, "{}", case.name);
        for instructions in Instructions::ALL.into_iter().filter(|instructions| instructions.is_available()) {
            let mut hits = cast_with(instructions, &case);
            let same = compare_hits(&case.rays, &hits, &expected);
            same.unwrap_or_else(|error| panic!("{}, {instructions:?}: {error}", case.name));
            let hit = hits.iter_mut().find(|hit| !hit.is_miss()).unwrap();
            hit.instance += 1;
            assert!(compare_hits(&case.rays, &hits, &expected).is_err(), "another instance went unnoticed");
        }
    }
}

#[test]
fn all_instructions_say_the_same_of_what_is_in_the_way() {
    for case in all_cases() {
        let expected: Vec<bool> = case.rays.par_iter().map(|ray| walk::occluded(&case.scene, ray)).collect();
        assert!(expected.contains(&true) && expected.contains(&false));
        for instructions in Instructions::ALL.into_iter().filter(|instructions| instructions.is_available()) {
            let mut blocked = vec![false; case.rays.len()];
            walk::occluded_batch_with(instructions, &case.scene, &case.rays, &mut blocked);
            assert!(blocked == expected, "{}, {instructions:?}", case.name);
        }
    }
}

#[test]
fn packets_trace_the_camera_s_rays_in_one_grid_and_streams_those_among_instances() {
    if !Instructions::Avx512.is_available() {
        return voxtrace_test_support::skip("this processor has no AVX-512");
    }
    let counts_of = |scene: &PackedScene| {
        let camera = scene.overview(1.0).frame(65, 65);
        let ray = |index: usize| camera.central_ray(Vec2::new((index % 65) as f32, (index / 65) as f32) + 0.5);
        let rays: Vec<Ray> = (0..65 * 65).map(ray).collect();
        walk::cast_batch_with(Instructions::Avx512, scene, &rays, &mut vec![Hit::MISS; rays.len()])
    };
    let one = counts_of(&cases(1)[0].scene);
    assert!(one.packets > 2000 && one.total() == 65 * 65, "{one:?}");
    let many = counts_of(&PackedScene::pack(&moving(10, 3)).unwrap());
    assert_eq!((many.packets, many.streams, many.scalar), (0, 65 * 65, 0));
}
