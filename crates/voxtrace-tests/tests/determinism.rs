//! A picture depends on the frame and the scene alone: not on threads, tiles, passes, interruptions or machines.

use std::sync::Arc;
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, Region, Scene, TraceError, Tracer};
use voxtrace_tests::rooms;

const SIZE: (u32, u32) = (45, 37);

fn tracer(scene: &Scene, threads: usize, tile_size: u32) -> CpuTracer {
    let mut tracer = CpuTracer::new(Some(threads)).with_tile_size(tile_size);
    tracer.set_scene(&Arc::new(PackedScene::pack(scene).unwrap())).unwrap();
    tracer
}

/// A film of arbitrary values, so that one that was never written is noticed.
fn poisoned() -> Film {
    let mut film = Film::new(3, 3, Region::full(3, 3), 77);
    film.pixels.fill(voxtrace::film::Pixel { radiance: [99; 3], samples: 5, covered: 6 });
    film
}

fn render(tracer: &mut CpuTracer, frame: &Frame) -> Film {
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = poisoned();
    tracer.read(&mut film).unwrap();
    film
}

fn frames() -> impl Iterator<Item = (Scene, Frame)> {
    [rooms::lamp_room(), rooms::open_plain()].into_iter().flat_map(|scene| {
        [Integrator::Essay, Integrator::Path].map(|integrator| {
            let frame = rooms::frame(&scene, SIZE, 8, integrator).aovs(true);
            (scene.clone(), frame)
        })
    })
}

#[test]
fn threads_and_tiles_do_not_change_a_byte() {
    for (scene, frame) in frames() {
        let expected = render(&mut tracer(&scene, 1, 32), &frame);
        assert!(expected.pixels.iter().any(|pixel| pixel.radiance[0] > 0), "the picture is not black");
        for (threads, tile_size) in [(2, 32), (7, 32), (2, 1), (2, 5), (7, 64), (1, u32::MAX)] {
            let film = render(&mut tracer(&scene, threads, tile_size), &frame);
            assert!(film == expected, "{threads} threads, tiles of {tile_size}, {:?}", frame.integrator);
        }
        let other_seed = render(&mut tracer(&scene, 2, 32), &frame.seed(2));
        assert!(other_seed != expected, "the comparison sees another seed");
    }
}

#[test]
fn tiles_that_get_all_their_samples_at_once_do_not_change_a_byte() {
    for (scene, frame) in frames() {
        let expected = render(&mut tracer(&scene, 2, 16), &frame);
        let whole = || {
            let mut tracer = CpuTracer::new(Some(2)).with_tile_size(16).with_whole_tiles(true);
            tracer.set_scene(&Arc::new(PackedScene::pack(&scene).unwrap())).unwrap();
            tracer
        };
        assert!(render(&mut whole(), &frame) == expected);
        // Ended early and gone on with.
        let (mut tracer, progress) = (whole(), Progress::default());
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while progress.samples_done() < u64::from(2 * SIZE.0 * SIZE.1) {
                    std::thread::yield_now();
                }
                progress.cancel();
            });
            tracer.render(&frame, &progress).unwrap();
            // Where it was quicker than the other thread.
            progress.add(u64::MAX / 2);
        });
        assert!(render(&mut tracer, &frame) == expected);
    }
}

#[test]
fn four_and_four_samples_are_eight() {
    for (scene, frame) in frames() {
        let mut tracer = tracer(&scene, 2, 16);
        let expected = render(&mut tracer, &frame);

        let half = frame.clone().samples(4);
        tracer.set_scene(&Arc::new(PackedScene::pack(&scene).unwrap())).unwrap();
        assert!(render(&mut tracer, &half) != expected, "the comparison sees missing samples");
        assert!(render(&mut tracer, &frame) == expected, "more samples of the same frame");

        let mut first = render(&mut tracer, &half.clone().seed(5));
        let second = render(&mut tracer, &half.clone().first_sample(4));
        first.merge(&second).unwrap();
        assert!(first != expected, "the comparison sees a film of another seed");
        let mut first = render(&mut tracer, &half);
        first.merge(&second).unwrap();
        assert!(first == expected, "merged");

        tracer.resume(&frame, second.clone()).unwrap_err();
        tracer.resume(&frame, render(&mut self::tracer(&scene, 1, 9), &half)).unwrap();
        assert!(render(&mut tracer, &frame) == expected, "resumed");
    }
}

#[test]
fn a_region_is_a_part_of_the_whole_picture() {
    for (scene, frame) in frames() {
        let whole = render(&mut tracer(&scene, 2, 16), &frame);
        let region = Region { x0: 7, y0: 11, x1: 30, y1: 28 };
        let part = render(&mut tracer(&scene, 2, 8), &frame.region(region));
        let mut at = 0;
        for y in region.y0..region.y1 {
            for x in region.x0..region.x1 {
                assert_eq!(part.pixels[at], whole.pixels[(y * SIZE.0 + x) as usize]);
                at += 1;
            }
        }
    }
}

#[test]
fn a_cancelled_render_goes_on_where_it_stopped() {
    for (scene, frame) in frames() {
        let frame = frame.samples(100);
        let expected = render(&mut tracer(&scene, 2, 16), &frame);

        let mut tracer = tracer(&scene, 2, 16);
        let progress = Progress::default();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while progress.samples_done() == 0 {
                    std::thread::yield_now();
                }
                progress.cancel();
            });
            tracer.render(&frame, &progress).unwrap();
        });
        let mut film = poisoned();
        tracer.read(&mut film).unwrap();
        let counted: u64 = film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
        assert_eq!(counted, progress.samples_done());
        assert!(film.sample_range().0 < frame.samples, "it was interrupted");

        assert!(render(&mut tracer, &frame) == expected);
    }
}

#[test]
fn however_often_a_render_is_cancelled_its_pixels_are_at_most_one_pass_apart() {
    let scene = rooms::lamp_room();
    let frame = rooms::frame(&scene, SIZE, 400, Integrator::Essay);
    let expected = render(&mut tracer(&scene, 1, 8), &frame);
    // Samples of a pass: 4096 paths over tiles of 8 × 8.
    let pass = 64;
    let mut tracer = tracer(&scene, 1, 8);
    let mut film = poisoned();
    let mut apart = 0;
    for _ in 0..40 {
        let progress = Progress::default();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while progress.samples_done() == 0 {
                    std::hint::spin_loop();
                }
                progress.cancel();
            });
            tracer.render(&frame, &progress).unwrap();
        });
        tracer.read(&mut film).unwrap();
        let (least, most) = film.sample_range();
        assert!(most - least <= pass, "{least} to {most}");
        apart = apart.max(most - least);
        // One with fewer samples, then, evens them out.
        if least == 0 {
            render(&mut tracer, &frame.clone().samples(1));
        }
    }
    assert!(apart > 0, "it was interrupted");
    assert!(render(&mut tracer, &frame) == expected);
}

#[test]
fn a_transparent_background_is_black_and_uncovered() {
    let scene = rooms::open_plain();
    let frame = rooms::frame(&scene, SIZE, 4, Integrator::Essay).aovs(true);
    let mut tracer = tracer(&scene, 2, 16);
    let opaque = render(&mut tracer, &frame);
    let transparent = render(&mut tracer, &frame.transparent(true));
    let mut empty = 0;
    for (with_sky, without) in opaque.pixels.iter().zip(&transparent.pixels) {
        assert_eq!(with_sky.covered, without.covered);
        if without.covered == 0 {
            assert_eq!(without.radiance, [0; 3]);
            assert!(with_sky.radiance[2] > 0);
            empty += 1;
        } else if without.covered == without.samples {
            assert_eq!(with_sky, without);
        }
    }
    assert!(empty > 10);
}

#[test]
fn a_frame_that_cannot_be_rendered_is_an_error() {
    let scene = rooms::lamp_room();
    let good = rooms::frame(&scene, SIZE, 1, Integrator::Essay);
    assert_eq!(CpuTracer::new(None).render(&good, &Progress::default()), Err(TraceError::NoScene));
    let mut tracer = tracer(&scene, 1, 32);
    assert_eq!(tracer.read(&mut poisoned()), Err(TraceError::NoFilm));
    let mut blind = good.camera.clone();
    blind.eye.x = f32::NAN;
    let bad = [
        good.clone().region(Region { x1: 0, ..good.region }),
        good.clone().region(Region { x1: SIZE.0 + 1, ..good.region }),
        good.clone().first_sample(u32::MAX).samples(2),
        good.clone().camera(blind),
        good.clone().camera(voxtrace::Camera { fov_y: 180.0, ..good.camera.clone() }),
    ];
    for frame in bad {
        let error = tracer.render(&frame, &Progress::default()).unwrap_err();
        assert!(matches!(error, TraceError::BadFrame(_)), "{error}");
    }
    tracer.render(&good, &Progress::default()).unwrap();
}
