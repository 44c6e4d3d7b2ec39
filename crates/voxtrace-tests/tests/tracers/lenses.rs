//! Lenses against their geometry, and the same films from every tracer.

use std::f32::consts::PI;
use std::sync::Arc;
use voxtrace::camera::{CameraFrame, Lens};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Progress, Region, Scene, Tracer, Transform,
    VoxelGrid,
};
use voxtrace_tests::gpu::{assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::rooms;
use voxtrace_vulkan::{Primitive, Traversal};

/// A scene of boxes that shine, and nothing else.
fn boxes(boxes: &[(IVec3, i32)]) -> Arc<PackedScene> {
    let mut scene = Scene { materials: vec![Material::emissive(Vec3::ONE)], ..Scene::new("boxes") };
    for &(middle, half) in boxes {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: middle - half, max: middle + half }, 0);
        scene.add_instance(grid, Transform::IDENTITY);
    }
    Arc::new(PackedScene::pack(&scene).unwrap())
}

/// Pixels whose middle shows something, sent through the middle of the lens.
fn seen(scene: &PackedScene, frame: &CameraFrame, (width, height): (u32, u32)) -> Vec<Vec2> {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5)));
    places.filter(|&place| scene.cast(&frame.central_ray(place)).is_some()).collect()
}

fn mean(places: &[Vec2]) -> Vec2 {
    places.iter().sum::<Vec2>() / places.len() as f32
}

fn forward() -> Camera {
    Camera::look_at(Vec3::ZERO, Vec3::Y)
}

#[test]
fn parallel_rays_show_near_and_far_things_equally_large() {
    let camera = forward().with_lens(Lens::Orthographic { view_height: 40.0 });
    let scale = |camera: &Camera, distance| {
        let size = (160, 80);
        seen(&boxes(&[(IVec3::new(10, distance, 0), 4)]), &camera.frame(size.0, size.1), size)
    };
    let (near, far) = (scale(&camera, 20), scale(&camera, 200));
    // Eight voxels of forty in eighty pixels: 16 × 16 pixels, 20 to the right of the middle.
    assert_eq!((near.len(), far.len()), (256, 256));
    assert!(mean(&near).abs_diff_eq(Vec2::new(100.0, 40.0), 1e-3) && mean(&far).abs_diff_eq(mean(&near), 1e-3));
    let pinhole = camera.with_lens(Lens::Pinhole);
    assert_ne!(scale(&pinhole, 20).len(), scale(&pinhole, 200).len(), "a pinhole is noticed");
}

#[test]
fn a_panorama_has_every_direction_at_its_longitude_and_latitude() {
    let (width, height) = (720, 360);
    let frame = forward().with_lens(Lens::Panorama { eye_distance: 0.0 }).frame(width, height);
    // To the right of the view, behind it, and halfway up to its left.
    for (at, longitude, latitude) in [
        (IVec3::new(100, 0, 0), 90.0, 0.0),
        (IVec3::new(0, 100, 0), 0.0, 0.0),
        (IVec3::new(-100, 0, 100), -90.0, 45.0),
        (IVec3::new(30, -100, -60), 180.0 - 16.699, -29.885),
    ] {
        let places = seen(&boxes(&[(at, 3)]), &frame, (width, height));
        let expected = Vec2::new(360.0 + longitude * 2.0, 180.0 - latitude * 2.0);
        assert!(mean(&places).abs_diff_eq(expected, 1.0), "{at}: {} and not {expected}", mean(&places));
        assert!(!mean(&places).abs_diff_eq(expected + 3.0, 1.0), "an error of a degree is noticed");
    }
}

#[test]
fn the_eyes_of_a_stereo_panorama_look_past_each_other_by_the_angle_of_their_distance() {
    let (width, height) = (1440, 1440);
    let frame = forward().with_lens(Lens::Panorama { eye_distance: 20.0 }).frame(width, height);
    // The farther a thing, the smaller the angle; the eyes turn with the view.
    for (at, distance) in
        [(IVec3::new(0, 100, 0), 100.0_f32), (IVec3::new(0, 200, 0), 200.0), (IVec3::new(150, 0, 0), 150.0)]
    {
        let places = seen(&boxes(&[(at, 3)]), &frame, (width, height));
        let (left, right): (Vec<_>, Vec<_>) = places.iter().partition(|place| place.y < 720.0);
        let parallax = mean(&left) - (mean(&right) - Vec2::Y * 720.0);
        let expected = 2.0 * (10.0 / distance).asin() / (2.0 * PI) * width as f32;
        assert!((parallax.x - expected).abs() < 1.5, "{at}: {} pixels and not {expected}", parallax.x);
        assert!(parallax.y.abs() < 0.5 && expected > 10.0);
    }
}

#[test]
fn a_fisheye_s_radius_grows_with_the_angle() {
    let (width, height) = (720, 720);
    let frame = forward().with_lens(Lens::Fisheye { fisheye_angle: 240.0 }).frame(width, height);
    for degrees in [0.0_f32, 30.0, 60.0, 90.0, 110.0] {
        let angle = degrees.to_radians();
        let at = Vec3::new(angle.sin() * 200.0, angle.cos() * 200.0, 0.0).round().as_ivec3();
        let places = seen(&boxes(&[(at, 4)]), &frame, (width, height));
        let expected = Vec2::new(360.0 + degrees * 3.0, 360.0);
        assert!(mean(&places).abs_diff_eq(expected, 1.0), "{degrees}: {} and not {expected}", mean(&places));
    }
    let pinhole = forward().frame(width, height);
    let at = IVec3::new(100, 173, 0);
    assert!(!mean(&seen(&boxes(&[(at, 4)]), &pinhole, (width, height))).abs_diff_eq(Vec2::new(450.0, 360.0), 20.0));
}

/// Root of the mean squared distance from its middle of the light of a lamp at `distance`, pixels, and the lamp's own.
fn spread(lens: Lens, distance: i32) -> f32 {
    let (width, height) = (200, 200);
    let scene = boxes(&[(IVec3::new(0, distance, 0), 1)]);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene).unwrap();
    let camera = Camera { fov_y: 20.0, ..forward() }.with_lens(lens);
    let frame = Frame::new(camera, width, height).samples(256).integrator(Integrator::Essay);
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.render(&frame, &Progress::default()).unwrap();
    tracer.read(&mut film).unwrap();
    let (mut light, mut moment) = (0.0, 0.0);
    for (index, pixel) in film.pixels.iter().enumerate() {
        let place = Vec2::new((index as u32 % width) as f32 + 0.5, (index as u32 / width) as f32 + 0.5);
        light += f64::from(pixel.covered);
        moment += f64::from(pixel.covered) * f64::from((place - 100.0).length_squared());
    }
    assert!(light > 0.0, "the lamp is in the picture");
    (moment / light).sqrt() as f32
}

#[test]
fn the_circle_of_confusion_has_the_size_that_a_thin_lens_gives_it() {
    let pixel_at = |distance: f32| 2.0 * 10.0_f32.to_radians().tan() * distance / 200.0;
    let lens = |aperture, focus| Lens::Thin { aperture, focus, blades: 0, blade_rotation: 0.0 };
    for (aperture, focus, distance) in [(4.0, 100.0, 200), (4.0, 200.0, 100), (8.0, 300.0, 200)] {
        // On the plane in focus the cone of a point at `distance` is this wide (similar triangles).
        let circle = aperture * (distance as f32 - focus).abs() / distance as f32;
        let own = spread(Lens::Pinhole, distance);
        // A disc's mean squared radius is half its squared radius; what the lamp covers by itself is added.
        let expected = ((circle / pixel_at(focus)).powi(2) * 0.5 + own * own).sqrt();
        let measured = spread(lens(aperture, focus), distance);
        assert!((measured / expected - 1.0).abs() < 0.03, "{measured} pixels and not {expected}");
        let wider = spread(lens(aperture * 1.2, focus), distance);
        assert!((wider / expected - 1.0).abs() > 0.03, "a wider aperture is noticed: {wider}");
    }
    let sharp = spread(lens(8.0, 200.0), 200);
    assert!(sharp < spread(Lens::Pinhole, 200) * 1.2, "{sharp}");
}

const LENSES: [Lens; 6] = [
    Lens::Thin { aperture: 0.8, focus: 12.0, blades: 0, blade_rotation: 0.0 },
    Lens::Thin { aperture: 0.8, focus: 9.0, blades: 5, blade_rotation: 20.0 },
    Lens::Orthographic { view_height: 14.0 },
    Lens::Panorama { eye_distance: 0.0 },
    Lens::Panorama { eye_distance: 0.7 },
    Lens::Fisheye { fisheye_angle: 200.0 },
];

#[test]
fn every_tracer_makes_the_same_film_with_every_lens() {
    let scene = rooms::lamp_room();
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let frames: Vec<Frame> = [Integrator::Essay, Integrator::Path]
        .into_iter()
        .flat_map(|integrator| LENSES.map(|lens| (integrator, lens)))
        .map(|(integrator, lens)| {
            let frame = rooms::frame(&scene, (24, 18), 2, integrator);
            let camera = frame.camera.clone().with_lens(lens);
            frame.camera(camera)
        })
        .collect();
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&packed).unwrap();
    let expected: Vec<Film> = frames.iter().map(|frame| film(&mut cpu, frame)).collect();
    for (one, other) in expected.iter().zip(&expected[1..]) {
        assert!(one != other, "each lens and integrator makes another film");
    }
    let Some(device) = device() else { return };
    let few = [Traversal::Walk, Traversal::Query, Traversal::Pipeline].map(|traversal| (traversal, Primitive::Brick));
    for_each_tracer(&device, &film_methods(&device, &few), &packed, |tracer, traversal, primitive| {
        for (frame, expected) in frames.iter().zip(&expected) {
            assert!(film(tracer, frame) == *expected, "{traversal:?} {primitive:?} {:?}", frame.camera.lens);
        }
    });
    assert_valid(&device);
}
