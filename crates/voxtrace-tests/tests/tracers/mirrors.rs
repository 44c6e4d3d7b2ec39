//! What is seen in mirrors and behind clear glass: AOVs, the filter's features, and what denoised pictures gain by them.

use std::sync::Arc;
use voxtrace::difference::{Difference, Shown};
use voxtrace::film::Pixel;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::output::ToneMap;
use voxtrace::{Camera, Film, Frame, Integrator, Material, PackedScene, Scene, Sky, Sun, VoxelGrid};
use voxtrace_core::bsdf::fresnel_schlick;
use voxtrace_core::denoise::{Features, denoise};
use voxtrace_tests::estimate::render;
use voxtrace_tests::rooms::shell;

/// A closed room with a lamp; its floor is a pattern, its back wall (material 3) is `wall`, and a pane of `pane` stands before a red wall.
fn room(wall: Material, pane: Material) -> Scene {
    let size = IVec3::new(24, 24, 14);
    let mut grid = shell(size, |voxel| match voxel {
        IVec3 { y: 24, .. } => 3,
        IVec3 { x: 24, .. } => 2,
        IVec3 { z: -1, .. } => ((voxel.x / 4 + voxel.y / 4) % 2) as u16,
        _ => 0,
    });
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([9, 9, 13], [15, 15, 14], 4);
    fill([18, 2, 0], [19, 22, 12], 5);
    fill([21, 6, 0], [23, 9, 6], 1);
    fill([3, 12, 0], [7, 16, 8], 1);
    let materials = vec![
        Material::diffuse(Vec3::new(0.75, 0.73, 0.7)),
        Material::diffuse(Vec3::new(0.2, 0.3, 0.5)),
        Material::diffuse(Vec3::new(0.7, 0.2, 0.1)),
        wall,
        Material::emissive(Vec3::new(9.0, 8.0, 6.0)),
        pane,
    ];
    let mut scene = Scene { sky: Sky::black(), ..Scene::from_grid("room", grid, materials) };
    scene.cameras.push(Camera { fov_y: 75.0, ..Camera::look_at(Vec3::new(6.0, 1.5, 7.0), Vec3::new(14.0, 16.0, 5.5)) });
    scene
}

const SILVER: Vec3 = Vec3::new(0.95, 0.93, 0.88);

fn mirror() -> Material {
    Material::metal(SILVER, 0.0)
}

fn frame(scene: &Scene, size: (u32, u32), samples: u32) -> Frame {
    Frame::new(scene.cameras[0].clone(), size.0, size.1).samples(samples).max_bounces(8)
}

/// Looks straight at a mirror in the plane y = 20 from beside a green wall behind: the AOVs of the middle.
fn aov_in(mirror: Material) -> voxtrace::film::AovPixel {
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-20, 20, -20], [20, 21, 20], 0);
    fill([-20, -21, -20], [20, -20, 20], 1);
    let materials = vec![mirror, Material::diffuse(Vec3::new(0.1, 0.8, 0.3))];
    let scene = Scene::from_grid("mirror", grid, materials);
    let camera = Camera::look_at(Vec3::new(0.5, 0.5, 0.5), Vec3::new(0.5, 20.0, 0.5));
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let film = render(&packed, &Frame::new(camera, 3, 3).aovs(true));
    film.aovs.unwrap()[4]
}

/// That a pixel shows the green wall in a mirror at a distance of 19.5.
fn check_mirrored(aov: &voxtrace::film::AovPixel) -> Result<(), String> {
    let expected = Vec3::new(0.1, 0.8, 0.3) * fresnel_schlick(1.0, SILVER);
    let is_far = (aov.albedo - expected).length() > 1e-5 || (aov.normal - Vec3::Y).length() > 1e-6;
    // Depth, instance and voxel are those of the mirror itself.
    let is_other = (aov.depth - 19.5).abs() > 1e-3 || aov.voxel.y != 20 || aov.instance != 0;
    if is_far || is_other { Err(format!("{aov:?}")) } else { Ok(()) }
}

#[test]
fn aovs_show_what_is_in_a_mirror_at_the_mirrors_depth() {
    check_mirrored(&aov_in(mirror())).unwrap();
    check_mirrored(&aov_in(Material::metal(SILVER, 0.3))).unwrap_err();
}

/// A camera before a block of glass, behind which a wall is: what the middle shows of it.
fn albedo_behind(glass: Material) -> Vec3 {
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-9, 4, -9], [9, 8, 9], 0);
    fill([-9, 12, -9], [9, 13, 9], 1);
    let materials = vec![glass, Material::diffuse(Vec3::new(0.5, 0.4, 0.8))];
    let scene = Scene::from_grid("pane", grid, materials);
    let camera = Camera::look_at(Vec3::new(0.5, 0.5, 0.5), Vec3::new(0.5, 20.0, 0.5));
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    render(&packed, &Frame::new(camera, 3, 3).aovs(true)).aovs.unwrap()[4].albedo
}

#[test]
fn aovs_show_what_is_behind_clear_glass_with_what_the_glass_absorbs() {
    let wall = Vec3::new(0.5, 0.4, 0.8);
    let tint = Vec3::new(0.9, 0.5, 0.7);
    let tinted = albedo_behind(Material::glass(1.5, 0.0).tinted(tint, 4.0));
    // Rays begin a little behind the faces that they leave.
    assert!((tinted - wall * tint).length() < 1e-3, "{tinted}");
    let colorless = albedo_behind(Material::glass(1.5, 0.0));
    assert!((colorless - wall).length() < 1e-6, "{colorless}");
    // Rough and cloudy things are seen themselves.
    for opaque in [Material::glass(1.5, 0.4), Material::cloud(Vec3::ONE, 0.5, 0.0)] {
        assert_eq!(albedo_behind(opaque), Vec3::ONE);
    }
    let inner = Material { scattering: 0.2, ..Material::glass(1.5, 0.0) };
    assert_eq!(albedo_behind(inner), Vec3::ONE);
}

/// Largest difference between a film and what its features say is seen directly, over the largest mean.
fn not_direct(scene: &Arc<PackedScene>, frame: &Frame, of: &Frame) -> f32 {
    let film = render(scene, frame);
    let features = Features::of(scene, of, &film);
    let means: Vec<Vec3> = film.pixels.iter().map(Pixel::mean).collect();
    let largest = means.iter().map(|mean| mean.max_element()).fold(0.0, f32::max);
    let differ = means.iter().zip(&features.pixels).map(|(mean, pixel)| (*mean - pixel.direct).abs().max_element());
    differ.fold(0.0, f32::max) / largest
}

#[test]
fn light_seen_in_mirrors_and_through_glass_is_direct_light_of_the_same_samples() {
    // Nothing scatters: all light comes by mirrors and glass alone, from the sky, the sun and lamps.
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-12, -12, -1], [12, 12, 0], 0);
    fill([-6, -6, 0], [-1, 5, 6], 1);
    fill([-4, -2, 2], [-2, 2, 4], 2);
    fill([3, 0, 0], [6, 6, 5], 3);
    let materials = vec![
        mirror(),
        Material::glass(1.5, 0.0).tinted(Vec3::new(0.4, 0.9, 0.6), 4.0),
        Material::glass(1.33, 0.0),
        Material::emissive(Vec3::new(2.0, 3.0, 1.0)),
    ];
    let direction = Vec3::new(0.4, -0.3, 0.8).normalize();
    let sun = Sun { direction, angular_radius: 0.3, irradiance: Vec3::splat(2.0) };
    let sky = Sky::gradient(Vec3::new(0.2, 0.15, 0.1), Vec3::new(0.4, 0.6, 0.9)).with_sun(sun);
    let mut scene = Scene { sky, ..Scene::from_grid("glass", grid, materials) };
    scene.cameras.push(Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0)));
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let frame = frame(&scene, (48, 32), 4);
    let difference = not_direct(&packed, &frame, &frame);
    assert!(difference < 1e-6, "{difference}");
    let other_seed = not_direct(&packed, &frame, &frame.clone().seed(5));
    assert!(other_seed > 1e-3, "{other_seed}");
}

/// The scene with surfaces that scatter: its features are those of the mirrors and panes themselves.
fn blind(scene: &Scene) -> PackedScene {
    let mut scene = scene.clone();
    scene.materials.iter_mut().for_each(|material| material.roughness = 1.0);
    PackedScene::pack(&scene).unwrap()
}

/// A film of 16 samples with its earlier half.
fn noisy(scene: &Arc<PackedScene>, frame: &Frame) -> Film {
    let half = render(scene, &frame.clone().samples(frame.samples / 2));
    Film { earlier: Some(half.pixels), ..render(scene, frame) }
}

/// PSNR and FLIP of pictures of 16 samples beside one of many: as they are, filtered by the features of mirrors and panes themselves, and by those of
/// what is seen in them.
fn quality(scene: &Scene) -> [(f64, f64); 3] {
    let packed = Arc::new(PackedScene::pack(scene).unwrap());
    let frame = frame(scene, (64, 48), 16);
    let film = noisy(&packed, &frame);
    let truth: Vec<Vec3> =
        render(&packed, &frame.clone().samples(256).seed(1)).pixels.iter().map(Pixel::mean).collect();
    let shown = |radiance: &[Vec3]| Shown::of_radiance(64, 48, radiance, &ToneMap::default());
    let truth = shown(&truth);
    let of = |radiance: Vec<Vec3>| {
        let difference = Difference::of(&truth, &shown(&radiance)).unwrap();
        (difference.psnr(), difference.mean_flip())
    };
    let raw = of(film.pixels.iter().map(Pixel::mean).collect());
    let before = of(denoise(&film, &Features::of(&blind(scene), &frame, &film)));
    [raw, before, of(denoise(&film, &Features::of(&packed, &frame, &film)))]
}

#[test]
fn pictures_with_mirrors_and_panes_are_cleaner_by_what_is_seen_in_them() {
    let matte = Material::diffuse(Vec3::splat(0.7));
    let scenes = [
        ("pane", room(matte, Material::glass(1.5, 0.0)), 0.1),
        ("both", room(mirror(), Material::glass(1.5, 0.0).tinted(Vec3::new(0.8, 0.95, 0.9), 1.0)), 0.1),
    ];
    for (name, scene, least) in scenes {
        let [raw, before, after] = quality(&scene);
        println!("{name}: raw {raw:.3?}, by the panes {before:.3?}, by what is seen {after:.3?} (PSNR in dB, FLIP)");
        assert!(after.0 > before.0 + least && after.1 < before.1, "{name}: {before:?} {after:?}");
    }
    // Where nothing is seen in anything else the features are the same.
    let plain = room(matte, matte);
    let [_, before, after] = quality(&plain);
    assert_eq!(before, after);
}

#[test]
fn the_study_s_integrator_sees_no_mirrors() {
    let scene = room(mirror(), mirror());
    let frame = frame(&scene, (16, 12), 2).integrator(Integrator::Essay).max_bounces(3);
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let film = render(&packed, &frame);
    assert_eq!(Features::of(&packed, &frame, &film), Features::of(&blind(&scene), &frame, &film));
    let path = frame.clone().integrator(Integrator::Path);
    assert_ne!(Features::of(&packed, &path, &film), Features::of(&blind(&scene), &path, &film));
}
