//! What reaches the screen, without a window: the engine traces, the same frames are drawn into an image, and films are those of a
//! render.

use crate::common::rendered;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::lines::Lines;
use voxtrace::output::{Operator, ToneMap};
use voxtrace::{
    BounceLimits, Camera, Integrator, Material, PackedScene, Progress, Scene, Tracer, Transform, VoxelGrid,
};
use voxtrace_test_support::{Alone, Need, skip_without};
use voxtrace_viewer::engine::{Backend, Contrast, Differences, Engine, Event, Shown, View};
use voxtrace_viewer::gpu::{Beside, Layer, Offscreen, Panels};
use voxtrace_vulkan::{Device, Options, Picture, Primitive, Settings, Traversal, VulkanTracer};

/// The first device, with the validation layer on. Without one the caller's test is skipped, or fails where `VOXTRACE_REQUIRE_VULKAN=1`.
pub fn device() -> Option<Alone<Arc<Device>>> {
    let options = Options { validation: true, ..Options::default() };
    let open =
        || Device::open(options, Some("0"), None).inspect_err(|error| skip_without(Need::Vulkan, &error.to_string()));
    Alone::new(|| open().ok()).some()
}

/// A lamp over a floor with a block on it.
pub fn scene() -> Arc<PackedScene> {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(0, 0, 0), max: IVec3::new(40, 40, 2) }, 0);
    grid.fill_box(VoxelBox { min: IVec3::new(10, 12, 2), max: IVec3::new(22, 26, 14) }, 1);
    grid.fill_box(VoxelBox { min: IVec3::new(28, 16, 18), max: IVec3::new(32, 20, 20) }, 2);
    let materials = vec![
        Material::from_srgb([200, 200, 190]),
        Material::from_srgb([190, 60, 40]),
        Material::from_srgb([255, 230, 200]).glowing(20.0),
    ];
    Arc::new(PackedScene::pack(&Scene::from_grid("lamp", grid, materials)).unwrap())
}

pub fn view(samples: u32) -> View {
    View {
        camera: Camera::look_at(Vec3::new(70.0, -40.0, 40.0), Vec3::new(18.0, 20.0, 6.0)),
        width: 96,
        height: 64,
        samples,
        integrator: Integrator::Path,
        max_bounces: 4,
        bounce_limits: BounceLimits::default(),
        clamp_indirect: f32::INFINITY,
        clear_shadows: false,
        lines: Lines::default(),
        seed: 3,
    }
}

/// The same with voxels of another size: a large one around small ones, which begin half a voxel below its surface. Who takes the voxel
/// whose centre is nearest takes the small ones for the first.
fn nested() -> Arc<PackedScene> {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(0, 0, 0), max: IVec3::new(20, 20, 20) }, 0);
    let mut scene = Scene::from_grid("nested", grid, vec![Material::from_srgb([200, 200, 190]); 2]);
    let mut large = VoxelGrid::new();
    large.set(IVec3::ZERO, 1);
    let around = Transform { linear: Mat3::from_diagonal(Vec3::splat(21.0)), translation: Vec3::splat(-0.5) };
    scene.add_instance(large, around);
    Arc::new(PackedScene::pack(&scene).unwrap())
}

/// An engine with the scene, and what it tells.
pub fn engine(device: &Arc<Device>, backend: Backend) -> (Engine, Receiver<Event>) {
    let (sender, events) = channel();
    let engine = Engine::start(Arc::clone(device), backend, move |event| {
        let _ = sender.send(event);
    });
    engine.set_scene(Some(scene()));
    (engine, events)
}

/// Waits until the picture has all samples.
pub fn finished(engine: &Engine, events: &Receiver<Event>, samples: u32) -> Shown {
    loop {
        match events.recv_timeout(Duration::from_secs(300)).expect("the engine goes on") {
            Event::Failed(error) => panic!("{error}"),
            _ => {
                if let Some(shown) = engine.shown().filter(|shown| shown.samples == samples) {
                    return shown;
                }
            }
        }
    }
}

pub fn no_panels() -> Panels {
    Panels { textures: egui::TexturesDelta::default(), primitives: Vec::new(), pixels_per_point: 1.0 }
}

fn backends() -> Vec<Backend> {
    let device = |traversal, primitive, is_exact| Backend::Device(Settings { traversal, primitive, is_exact });
    vec![
        Backend::Cpu,
        device(Traversal::Walk, Primitive::Brick, true),
        device(Traversal::Query, Primitive::Brick, true),
        device(Traversal::Pipeline, Primitive::Grid, true),
    ]
}

#[test]
fn the_film_of_a_window_is_that_of_a_render_whatever_traces_it() {
    let Some(device) = device() else { return };
    let expected = rendered(&scene(), &view(5).frame());
    let (engine, events) = engine(&device, Backend::Cpu);
    engine.set_view(view(5), false);
    for backend in backends() {
        engine.set_backend(backend);
        finished(&engine, &events, 5);
        let (frame, film) = engine.film().recv().unwrap().expect("the picture is whole");
        assert_eq!((frame, film), (view(5).frame(), expected.clone()), "{backend:?}");
        // More samples go on from there; a view of another size and back begins anew.
        engine.set_view(view(7), false);
        finished(&engine, &events, 7);
        let (_, film) = engine.film().recv().unwrap().unwrap();
        assert_eq!(film, rendered(&scene(), &view(7).frame()), "{backend:?}");
        assert_ne!(film, expected, "the comparison sees samples");
        // Fewer begin anew, too, also while a step adds more.
        engine.set_view(view(9), false);
        engine.set_view(view(3), false);
        finished(&engine, &events, 3);
        let fewer = engine.film().recv().unwrap().expect("the picture is whole");
        assert_eq!(fewer, (view(3).frame(), rendered(&scene(), &view(3).frame())), "{backend:?}");
        engine.set_view(View { width: 40, ..view(2) }, true);
        engine.set_view(view(5), false);
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_frame_shows_the_film_through_the_curve_of_the_picture_files() {
    let Some(device) = device() else { return };
    let mut target = Offscreen::new(&device, 96, 64).unwrap();
    for backend in [Backend::Cpu, Backend::Device(Settings::default())] {
        let (engine, events) = engine(&device, backend);
        engine.set_view(view(4), false);
        let shown = finished(&engine, &events, 4);
        let (_, film) = engine.film().recv().unwrap().unwrap();
        for operator in Operator::ALL {
            let tone_map = ToneMap { operator, exposure: 0.5 };
            let picture = Arc::clone(&shown.picture);
            let layer = Layer { picture, corner: [0.0; 2], size: [96.0, 64.0], tone_map, beside: None };
            let pixels = target.draw(Some(&layer), no_panels()).unwrap();
            let error = |tone_map: ToneMap| {
                let expected = film.pixels.iter().flat_map(|pixel| (tone_map.signal(pixel.mean()) * 255.0).to_array());
                let drawn = pixels.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
                expected.zip(drawn).map(|(expected, drawn)| (expected - f64::from(drawn)).abs()).fold(0.0, f64::max)
            };
            assert!(error(tone_map) <= 1.0, "{backend:?} {operator:?}: {}", error(tone_map));
            assert!(error(ToneMap { exposure: 0.55, ..tone_map }) > 1.0, "the comparison sees exposure");
        }
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_picture_that_is_written_with_the_last_samples_is_that_of_the_film_and_seen_anew_each_time() {
    let Some(device) = device() else { return };
    let mut target = Offscreen::new(&device, 96, 64).unwrap();
    let mut draw = |picture: &Arc<Picture>| {
        let (picture, tone_map) = (Arc::clone(picture), ToneMap::default());
        let layer = Layer { picture, corner: [0.0; 2], size: [96.0, 64.0], tone_map, beside: None };
        target.draw(Some(&layer), no_panels()).unwrap()
    };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    tracer.set_scene(&scene()).unwrap();
    let picture = || Arc::new(Picture::new(&device, 96, 64, false).unwrap());
    let (with_samples, after) = (picture(), picture());
    let mut seen: Vec<Vec<u8>> = Vec::new();
    for samples in [1, 2, 9] {
        let frame = view(samples).frame();
        assert!(tracer.render_shown(&frame, &Progress::default(), &with_samples).unwrap().is_some());
        tracer.resolve(&after).unwrap();
        let drawn = draw(&with_samples);
        assert_eq!(drawn, draw(&after), "{samples}");
        assert_eq!(drawn, draw(&with_samples), "once more, without the curve");
        assert!(!seen.contains(&drawn), "the comparison sees samples");
        seen.push(drawn);
    }
    // A film that has all samples already is shown, too, and one that was broken off is not.
    let frame = view(9).frame();
    assert!(tracer.render_shown(&frame, &Progress::default(), &after).unwrap().is_some());
    assert_eq!(Some(&draw(&after)), seen.last());
    let progress = Progress::default();
    progress.cancel();
    assert_eq!(tracer.render_shown(&view(20).frame(), &progress, &after), Ok(None));
    assert!(tracer.render_shown(&frame.size(40, 40), &Progress::default(), &after).is_err(), "another size");
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_coarse_picture_fills_its_place_and_the_rest_is_surround() {
    let Some(device) = device() else { return };
    let mut target = Offscreen::new(&device, 80, 60).unwrap();
    let (engine, events) = engine(&device, Backend::Cpu);
    engine.set_view(View { width: 16, height: 16, ..view(2) }, false);
    let picture = finished(&engine, &events, 2).picture;
    let tone_map = ToneMap::default();
    let layer = Layer { picture, corner: [8.0, 4.0], size: [64.0, 52.0], tone_map, beside: None };
    let pixels = target.draw(Some(&layer), no_panels()).unwrap();
    let at = |x: usize, y: usize| <[u8; 3]>::try_from(&pixels[4 * (80 * y + x)..][..3]).unwrap();
    let surround = at(0, 0);
    for y in 0..60 {
        for x in 0..80 {
            let is_inside = (8..72).contains(&x) && (4..56).contains(&y);
            // No pixel of this picture has the grey of the surround.
            assert_eq!(at(x, y) != surround, is_inside, "{x} {y}");
        }
    }
    // Neighbours within a coarse pixel differ little: the picture is interpolated.
    assert_eq!(target.draw(None, no_panels()).unwrap()[..3], surround);
}

/// Waits until films or voxels of so many samples were compared.
fn compared(engine: &Engine, events: &Receiver<Event>, samples: u32) -> Differences {
    loop {
        match events.recv_timeout(Duration::from_secs(300)).expect("the engine goes on") {
            Event::Failed(error) => panic!("{error}"),
            _ => {
                if let Some(found) = engine.differences().filter(|found| found.samples == samples) {
                    return found;
                }
            }
        }
    }
}

#[test]
fn both_films_of_a_comparison_are_those_of_a_render_and_the_same() {
    let Some(device) = device() else { return };
    let expected = rendered(&scene(), &view(5).frame());
    let (engine, events) = engine(&device, Backend::Cpu);
    engine.set_view(view(5), false);
    for other in backends() {
        engine.compare_with(Some(other));
        engine.set_contrast(Contrast::Films);
        let differences = compared(&engine, &events, 5);
        assert_eq!((differences.count, differences.pixels), (0, 96 * 64), "{other:?}");
        for side in [0, 1] {
            let (frame, film) = engine.film_of(side).recv().unwrap().expect("the picture is whole");
            assert_eq!((frame, film), (view(5).frame(), expected.clone()), "{other:?}, side {side}");
        }
        assert_eq!(engine.other_shown().map(|shown| shown.samples), Some(5));
        // Both go on from there, and a view that changes begins both anew.
        engine.set_view(view(8), false);
        assert_eq!(compared(&engine, &events, 8).count, 0);
        engine.set_view(View { seed: 9, ..view(5) }, false);
        engine.set_view(view(5), false);
    }
    engine.compare_with(None);
    assert!(engine.film_of(1).recv().unwrap().is_none());
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn voxels_that_are_found_wrong_are_black_and_counted() {
    let Some(device) = device() else { return };
    let settings = |primitive| Settings { traversal: Traversal::Pipeline, primitive, is_exact: true };
    // The study's approximate method takes the voxel whose centre is nearest: the fault that is to be seen.
    let approximate = Backend::Device(settings(Primitive::VoxelApprox));
    let mut target = Offscreen::new(&device, 96, 64).unwrap();
    for (other, contrast) in [
        (approximate, Contrast::Voxels),
        (approximate, Contrast::Films),
        (Backend::Device(settings(Primitive::Brick)), Contrast::Voxels),
    ] {
        let (engine, events) = engine(&device, Backend::Device(settings(Primitive::VoxelExact)));
        engine.set_scene(Some(nested()));
        engine.set_view(view(3), false);
        engine.compare_with(Some(other));
        engine.set_contrast(contrast);
        let differences = compared(&engine, &events, 3);
        let is_wrong = other == approximate;
        assert_eq!(differences.count > 0, is_wrong, "{contrast:?}: {}", differences.count);
        let films = [0, 1].map(|side| engine.film_of(side).recv().unwrap().unwrap().1);
        let picture = Arc::clone(&differences.picture);
        let tone_map = ToneMap { operator: Operator::Linear, exposure: 0.0 };
        let layer = Layer { picture, corner: [0.0; 2], size: [96.0, 64.0], tone_map, beside: None };
        let pixels = target.draw(Some(&layer), no_panels()).unwrap();
        let black = pixels.chunks_exact(4).filter(|pixel| pixel[..3] == [0, 0, 0]).count() as u64;
        assert!(black >= differences.count, "{contrast:?}: {black} of {}", differences.count);
        if contrast == Contrast::Films {
            let differing = films[0].pixels.iter().zip(&films[1].pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differences.count, differing as u64);
        }
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn the_divider_has_one_picture_to_its_left_and_the_other_to_its_right() {
    let Some(device) = device() else { return };
    let mut target = Offscreen::new(&device, 96, 64).unwrap();
    let (engine, events) = engine(&device, Backend::Cpu);
    let picture = |seed| {
        engine.set_view(View { seed, ..view(1) }, false);
        loop {
            let _ = events.recv_timeout(Duration::from_secs(300)).expect("the engine goes on");
            if engine.film().recv().unwrap().is_some_and(|(frame, _)| frame.seed == seed) {
                break engine.shown().expect("its picture came before").picture;
            }
        }
    };
    let (first, second) = (picture(1), picture(2));
    let tone_map = ToneMap::default();
    let mut draw = |picture: &Arc<_>, beside: Option<Beside>| {
        let picture = Arc::clone(picture);
        let layer = Layer { picture, corner: [0.0; 2], size: [96.0, 64.0], tone_map, beside };
        target.draw(Some(&layer), no_panels()).unwrap()
    };
    let (left, right) = (draw(&first, None), draw(&second, None));
    assert_ne!(left, right, "the pictures differ");
    for split in [0.0, 40.0, 96.0, 300.0] {
        let beside = Beside { picture: Arc::clone(&second), size: [96.0, 64.0], split };
        let both = draw(&first, Some(beside));
        for (index, pixel) in both.chunks_exact(4).enumerate() {
            let expected = if ((index % 96) as f32) < split { &left } else { &right };
            assert_eq!(pixel, &expected[4 * index..][..4], "{split} {index}");
        }
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

#[test]
fn a_picture_that_is_copied_into_its_place_is_the_one_that_is_drawn_there() {
    let Some(device) = device() else { return };
    let (engine, events) = engine(&device, Backend::Device(Settings::default()));
    engine.set_view(view(2), false);
    let shown = finished(&engine, &events, 2);
    let layer = |exposure, beside: bool| Layer {
        picture: Arc::clone(&shown.picture),
        corner: [0.0; 2],
        size: [96.0, 64.0],
        tone_map: ToneMap { exposure, ..ToneMap::default() },
        // The same once more: what is compared is drawn.
        beside: beside.then(|| Beside { picture: Arc::clone(&shown.picture), size: [96.0, 64.0], split: 30.0 }),
    };
    // As large as the picture, and larger, with what surrounds it.
    for (width, height) in [(96, 64), (120, 70)] {
        for is_blue_lowest in [false, true] {
            let mut target = Offscreen::of_order(&device, width, height, is_blue_lowest).unwrap();
            let copied = target.draw(Some(&layer(0.5, false)), no_panels()).unwrap();
            let drawn = target.draw(Some(&layer(0.5, true)), no_panels()).unwrap();
            assert!(copied == drawn, "{width} × {height}, {is_blue_lowest}");
            let other = target.draw(Some(&layer(0.6, true)), no_panels()).unwrap();
            assert!(copied != other, "the comparison sees a tenth of a stop");
            let above = target.draw(Some(&layer(0.5, false)), square()).unwrap();
            let drawn_above = target.draw(Some(&layer(0.5, true)), square()).unwrap();
            assert!(above == drawn_above && above != copied, "panels lie above either: {width} × {height}");
            if is_blue_lowest {
                let mut red = Offscreen::new(&device, width, height).unwrap();
                let expected = red.draw(Some(&layer(0.5, false)), no_panels()).unwrap();
                let swapped: Vec<u8> =
                    copied.chunks_exact(4).flat_map(|bytes| [bytes[2], bytes[1], bytes[0], bytes[3]]).collect();
                assert!(swapped == expected && copied != expected, "the same colours in another order");
            }
        }
    }
    assert_eq!(device.vulkan().messages().first(), Vec::<String>::new());
}

/// A white square over the picture, as a panel.
fn square() -> Panels {
    let corner =
        |x, y| egui::epaint::Vertex { pos: egui::pos2(x, y), uv: egui::epaint::WHITE_UV, color: egui::Color32::WHITE };
    let mesh = egui::Mesh {
        indices: vec![0, 1, 2, 2, 1, 3],
        vertices: vec![corner(10.0, 10.0), corner(30.0, 10.0), corner(10.0, 30.0), corner(30.0, 30.0)],
        texture_id: egui::TextureId::default(),
    };
    let clip_rect = egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(96.0, 64.0));
    let primitive = egui::ClippedPrimitive { clip_rect, primitive: egui::epaint::Primitive::Mesh(mesh) };
    let white = egui::epaint::ImageDelta::full(
        egui::ColorImage::filled([1, 1], egui::Color32::WHITE),
        egui::TextureOptions::NEAREST,
    );
    let mut textures = egui::TexturesDelta::default();
    textures.set.entry(egui::TextureId::default()).or_default().push(white);
    Panels { textures, primitives: vec![primitive], pixels_per_point: 1.0 }
}
