//! A sun whose disc the camera does not see: gone where camera rays leave the scene, and nowhere else; the same films from every tracer.

use std::f64::consts::PI;
use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::surroundings::Fog;
use voxtrace::{Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer, VoxelGrid};
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_vulkan::{Primitive, Traversal};

const SKY: f32 = 0.25;
const IRRADIANCE: f32 = 2.0;
const RADIUS: f32 = 0.3;

/// Radiance of the disc: as a flat one it has the solid angle π sin².
fn disc() -> f64 {
    f64::from(IRRADIANCE) / (PI * f64::from(RADIUS).sin().powi(2))
}

/// A sky with a sun overhead.
fn sky() -> Sky {
    let sun = Sun { direction: Vec3::Z, angular_radius: RADIUS, irradiance: Vec3::splat(IRRADIANCE) };
    Sky::uniform(Vec3::splat(SKY)).with_sun(sun)
}

/// A plate of 16 × 16 voxels, of materials in squares of four, under that sky.
fn plate(materials: Vec<Option<Material>>) -> PackedScene {
    let mut grid = VoxelGrid::new();
    for place in 0..256 {
        let (x, y) = (place % 16, place / 16);
        let square = (x / 4 + y / 4) as usize % materials.len();
        if materials[square].is_some() {
            grid.set(IVec3::new(x, y, 0), square as u16);
        }
    }
    let materials = materials.into_iter().map(Option::unwrap_or_default).collect();
    PackedScene::pack(&Scene { sky: sky(), ..Scene::from_grid("plate", grid, materials) }).unwrap()
}

fn matte() -> Option<Material> {
    Some(Material::diffuse(Vec3::splat(0.6)))
}

/// The scene with the disc visible, and hidden.
fn both(scene: PackedScene) -> [Arc<PackedScene>; 2] {
    let mut hidden = scene.clone();
    hidden.sky.set_sun_disc_visible(false);
    [scene, hidden].map(Arc::new)
}

/// The plate from above or below, of which it fills the picture.
fn toward_plate(from_above: bool) -> Frame {
    let eye = Vec3::new(8.0, 8.0, if from_above { 20.0 } else { -20.0 });
    let camera = Camera { fov_y: 30.0, up: Vec3::Y, ..Camera::look_at(eye, Vec3::new(8.0, 8.0, 0.5)) };
    Frame::new(camera, 16, 16).samples(16).integrator(Integrator::Path).max_bounces(6)
}

/// From above the plate into the middle of the sun.
fn toward_sun() -> Frame {
    let camera =
        Camera { fov_y: 10.0, up: Vec3::Y, ..Camera::look_at(Vec3::new(8.0, 8.0, 20.0), Vec3::new(8.0, 8.0, 30.0)) };
    Frame::new(camera, 8, 8).samples(4).integrator(Integrator::Path)
}

/// Radiance of the darkest and of the brightest pixel.
fn range(film: &Film) -> [f64; 2] {
    let means = film.pixels.iter().map(|pixel| f64::from(pixel.mean().y));
    means.fold([f64::INFINITY, 0.0], |[least, most], mean| [least.min(mean), most.max(mean)])
}

fn is_all(film: &Film, radiance: f64) -> bool {
    range(film).into_iter().all(|found| (found / radiance - 1.0).abs() < 1e-5)
}

#[test]
fn a_camera_that_looks_at_the_sun_sees_the_sky_alone() {
    let [visible, hidden] = both(plate(vec![matte()]));
    let frame = toward_sun();
    let sky = f64::from(SKY);
    assert!(is_all(&render(&hidden, &frame), sky));
    assert!(is_all(&render(&visible, &frame), sky + disc()));
    assert!(!is_all(&render(&visible, &frame), sky), "the comparison sees the disc");
    // Beside the disc nothing differs; `essay` has no sun at all.
    let essay = frame.clone().integrator(Integrator::Essay);
    assert!(is_all(&render(&visible, &essay), sky) && render(&visible, &essay) == render(&hidden, &essay));
    // Another sun stays hidden, as the sky says, until that does not.
    let mut changed = (*hidden).clone();
    changed.sky.set_sun(Sun::at(0.0, 90.0, 4.0));
    assert!(is_all(&render(&Arc::new(changed.clone()), &frame.clone().region(middle())), sky));
    changed.sky.set_sun_disc_visible(true);
    assert!(!is_all(&render(&Arc::new(changed), &frame.region(middle())), sky));
}

/// The pixels in the middle of [`toward_sun`], which the small disc of `Sun::at` touches.
fn middle() -> voxtrace::Region {
    voxtrace::Region { x0: 3, y0: 3, x1: 5, y1: 5 }
}

#[test]
fn surfaces_mirrors_and_glass_keep_its_light_to_the_bit() {
    let mirror = Some(Material::metal(Vec3::ONE, 0.0));
    let glass = Some(Material::glass(1.5, 0.0));
    // What each shows at its brightest: matte white in the sun, the disc in the mirror, the disc through the glass.
    let lit = 0.6 * (f64::from(IRRADIANCE) / PI + f64::from(SKY));
    let cases = [(matte(), true, 0.9 * lit), (mirror, true, 0.9 * disc()), (glass, false, 0.8 * disc())];
    for (material, from_above, brightest) in cases {
        let [visible, hidden] = both(plate(vec![material]));
        let frame = toward_plate(from_above);
        let [seen, unseen] = [&visible, &hidden].map(|scene| render(scene, &frame));
        assert!(seen == unseen, "{material:?}");
        assert!(range(&unseen)[1] > brightest, "{material:?}: {:?}", range(&unseen));
        assert!(
            render(&visible, &toward_sun()) != render(&hidden, &toward_sun()),
            "{material:?}: the comparison sees the disc"
        );
    }
}

#[test]
fn what_only_dims_camera_rays_does_not_show_it() {
    // Boundaries that do not refract are passed straight: a disc that comes and goes with the fog is none.
    let fog = Fog { density: 1e-5, color: Vec3::splat(0.5), anisotropy: 0.0 };
    let [visible, hidden] = both(plate(vec![matte()]).with_surroundings(None, Some(&fog)).unwrap());
    let [seen, unseen] = [&visible, &hidden].map(|scene| range(&render(scene, &toward_sun())));
    assert!(unseen[1] < 0.5 * disc(), "{unseen:?}");
    assert!(seen[1] > 0.9 * disc(), "the comparison sees the disc through the fog: {seen:?}");
}

#[test]
fn every_tracer_makes_the_same_films() {
    // With gaps, through which a camera below sees the sun; without and with media, and in fog.
    let cloud = Material::cloud(Vec3::splat(0.8), 0.3, 0.2);
    let all = [matte(), None, Some(Material::metal(Vec3::ONE, 0.1)), Some(Material::glass(1.5, 0.0)), Some(cloud)];
    let fog = Fog { density: 0.01, color: Vec3::splat(0.9), anisotropy: 0.3 };
    let materials = plate(all.into());
    let foggy = materials.clone().with_surroundings(None, Some(&fog)).unwrap();
    let scenes = [plate(vec![matte(), None]), materials, foggy].map(both);
    let frames = [false, true].map(toward_plate).map(|frame| frame.samples(3));
    let mut cpu = CpuTracer::new(None);
    let mut films_of = |scene: &Arc<PackedScene>| {
        cpu.set_scene(scene).unwrap();
        frames.each_ref().map(|frame| film(&mut cpu, frame))
    };
    let expected = scenes.each_ref().map(|pair| pair.each_ref().map(&mut films_of));
    for [visible, hidden] in &expected {
        assert!(visible[0] != hidden[0], "the comparison sees the disc");
        assert!(range(&visible[0])[1] > range(&hidden[0])[0], "and it is brighter");
    }
    let Some(device) = device() else { return };
    let few = [Traversal::Walk, Traversal::Query, Traversal::Pipeline].map(|traversal| (traversal, Primitive::Brick));
    for_each_tracer(&device, &film_methods(&device, &few), &scenes[0][0], |tracer, traversal, primitive| {
        for (pair, films) in scenes.iter().zip(&expected) {
            for (scene, expected) in pair.iter().zip(films) {
                tracer.set_scene(scene).unwrap();
                for (frame, expected) in frames.iter().zip(expected) {
                    let is_visible = scene.sky.is_sun_disc_visible();
                    assert!(film(tracer, frame) == *expected, "{traversal:?} {primitive:?}, visible: {is_visible}");
                }
            }
        }
    });
    assert_valid(&device);
}
