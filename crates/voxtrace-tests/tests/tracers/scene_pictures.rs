//! The built-in scenes, with their thousands of lights, from the GPU: the pictures of the CPU, bit for bit.

use std::sync::Arc;
use voxtrace::glam::{Mat3, Vec3};
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, Region, Scene, Sky, Sun, Tracer, Transform};
use voxtrace::{film::Pixel, scenes};
use voxtrace_tests::gpu::{assert_valid, device};
use voxtrace_vulkan::{Settings, VulkanTracer};

/// Trees, rocks and lamps of the forest, a dozen lamps among them.
const FOREST_INSTANCES: u32 = 1000;

/// The built-in scenes at few voxels and instances, and one in which a room stands about, turned, mirrored and scaled, under a sun.
fn all_scenes() -> Vec<Scene> {
    let named = |name: &str| scenes::generate(name, Some(60_000)).expect("the scene is built in");
    let mut all: Vec<Scene> = ["city", "operating-room", "church"].map(named).into();
    let mut together = all[1].clone();
    together.name = "together".into();
    let sun =
        Sun { direction: Vec3::new(0.3, -0.4, 0.6).normalize(), angular_radius: 0.02, irradiance: Vec3::splat(3.0) };
    together.sky = Sky::study(0.5).with_sun(sun);
    let bounds = together.grids[0].bounds().expect("the room holds voxels");
    let middle = (bounds.min + bounds.max).as_vec3() * 0.5;
    for index in 0..5u8 {
        let turned = Mat3::from_axis_angle(Vec3::new(1.0, 2.0, 0.5).normalize(), f32::from(index));
        let linear = turned * if index % 2 == 0 { 0.4 } else { -0.3 };
        let place = Vec3::new(f32::from(index) * 11.0 - 25.0, 7.0, 40.0 + f32::from(index));
        let translation = middle + place - linear * middle;
        together.instances.push(voxtrace::Instance::new(0, Transform { linear, translation }));
    }
    all.push(together);
    all.push(scenes::generate_forest_while(FOREST_INSTANCES, &|| true).expect("the scene is built in"));
    all
}

/// Voxels that give light, those of a grid for each of its instances.
fn lights(scene: &PackedScene) -> usize {
    let of_grid = |grid: u32| scene.geometry().emitters().iter().filter(|emitter| emitter.grid == grid).count();
    let counts: Vec<usize> = (0..).take(scene.geometry().grids().len()).map(of_grid).collect();
    scene.instances().iter().map(|instance| counts[instance.grid as usize]).sum()
}

fn render(tracer: &mut dyn Tracer, scene: &Arc<PackedScene>, frame: &Frame) -> Film {
    tracer.set_scene(scene).unwrap();
    tracer.render(frame, &Progress::default()).unwrap();
    // A film of arbitrary values, so that one that was never written is noticed.
    let mut film = Film::new(3, 3, Region::full(3, 3), 77);
    film.pixels.fill(Pixel { radiance: [99; 3], samples: 5, covered: 6 });
    tracer.read(&mut film).unwrap();
    film
}

#[test]
fn built_in_scenes_look_the_same_to_the_bit() {
    let Some(device) = device() else { return };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    for scene in all_scenes() {
        let packed = Arc::new(PackedScene::pack(&scene).unwrap());
        assert!(lights(&packed) > 50, "{} has lights to choose from", scene.name);
        let frame =
            Frame::new(scene.cameras[0].clone(), 72, 45).samples(4).seed(1).max_bounces(6).integrator(Integrator::Path);
        let expected = render(&mut CpuTracer::new(None), &packed, &frame);
        let actual = render(&mut tracer, &packed, &frame);
        let differing = actual.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
        assert_eq!(differing, 0, "pixels of {} differ", scene.name);
        assert!(actual == expected);
        let mut dimmer = PackedScene::clone(&packed);
        dimmer.light_intensity *= 0.99;
        assert!(render(&mut tracer, &Arc::new(dimmer), &frame) != expected, "weaker lights of {} are seen", scene.name);
    }
    drop(tracer);
    assert_valid(&device);
}
