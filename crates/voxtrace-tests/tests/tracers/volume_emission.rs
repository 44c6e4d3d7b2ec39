//! Media that glow within: closed forms, thermal equilibrium, that nothing about them is a surface, and those of .vox files.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::import::Limits;
use voxtrace::import::vox::{self, Body, Chunk, Dict, Numbered, VoxFile};
use voxtrace::{BounceLimits, Camera, Frame, LightGroup, Material, PackedScene, Scene, Sky, VoxelGrid};
use voxtrace_tests::estimate::{radiance, render};

/// A wide slab of so many voxels over nothing, looked at from straight above.
fn slab(thickness: i32, material: Material, sky: Sky) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-90, -90, -thickness), max: IVec3::new(90, 90, 0) }, 0);
    let scene = Scene { sky, ..Scene::from_grid("slab", grid, vec![material]) };
    let camera = Camera::look_at(Vec3::new(0.2, 0.3, 10.0), Vec3::new(0.2, 0.3, 0.0));
    let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
    (scene, Frame::new(camera, 8, 8).samples(64).max_bounces(40))
}

/// Checks the mean of each channel, and that another value would be seen.
fn check(scene: &Scene, frame: &Frame, expected: [f64; 3], tolerance: f64) {
    let estimates = radiance(scene, frame, 1);
    for (estimate, expected) in estimates.iter().zip(expected) {
        let is = |value: f64| (estimate.mean / value - 1.0).abs() < tolerance;
        assert!(is(expected), "{} and not {expected}", estimate.mean);
        assert!(!is(expected * (1.0 + 4.0 * tolerance)), "the comparison sees another value");
    }
}

const DENSITIES: [f64; 3] = [0.3, 0.02, 0.0001];

/// A medium that absorbs differently in each channel.
fn absorbing(emission: Vec3) -> Material {
    let absorption = Vec3::from_array(DENSITIES.map(|density| density as f32));
    Material { emission, absorption, ..Material::cloud(Vec3::ZERO, 0.0, 0.0) }
}

#[test]
fn a_slab_that_absorbs_and_glows_follows_its_closed_form() {
    for thickness in [1, 6, 25] {
        let (scene, frame) = slab(thickness, absorbing(Vec3::new(0.6, 0.5, 0.4)), Sky::black());
        let of = |emission: f64, density: f64| emission * (1.0 - (-density * f64::from(thickness)).exp()) / density;
        let expected = [of(0.6, DENSITIES[0]), of(0.5, DENSITIES[1]), of(0.4, DENSITIES[2])];
        // Rays begin a thousandth of a voxel behind the face that they entered.
        check(&scene, &frame, expected, 0.002);
    }
    // A flame says what it is where it is thick.
    let (scene, frame) = slab(80, Material::flame(Vec3::new(3.0, 2.0, 1.0), 0.2), Sky::black());
    check(&scene, &frame, [3.0, 2.0, 1.0], 0.001);
}

#[test]
fn what_is_scattered_away_is_lost_as_what_is_absorbed() {
    // All that is scattered is swallowed: both coefficients act alike on the way out.
    let material = Material { scattering: 0.15, ..absorbing(Vec3::splat(0.5)) };
    let (scene, frame) = slab(8, material, Sky::black());
    let of = |density: f64| 0.5 * (1.0 - (-(density + 0.15) * 8.0).exp()) / (density + 0.15);
    check(&scene, &frame.samples(256), DENSITIES.map(of), 0.01);
}

#[test]
fn in_equilibrium_with_its_sky_a_medium_is_invisible() {
    // What absorbs a share σ and emits σ times the radiance around it, whatever it scatters.
    let absorption = Vec3::new(0.3, 0.1, 0.02);
    let material = Material { emission: absorption, absorption, ..Material::cloud(Vec3::ONE, 0.2, 0.5) };
    let (scene, frame) = slab(10, material, Sky::uniform(Vec3::ONE));
    check(&scene, &frame.clone().samples(256).max_bounces(200), [1.0; 3], 0.01);
    // Without its own light it is not.
    let dark = Material { emission: Vec3::ZERO, ..material };
    let (scene, frame) = slab(10, dark, Sky::uniform(Vec3::ONE));
    assert!(radiance(&scene, &frame, 1)[0].mean < 0.7);
}

/// A thick layer of flame three voxels above a floor that scatters half of its light, seen from in between.
fn under_flame(flame: Material) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    let layer = |bottom, top| VoxelBox { min: IVec3::new(-90, -90, bottom), max: IVec3::new(90, 90, top) };
    grid.fill_box(layer(-1, 0), 0);
    grid.fill_box(layer(3, 43), 1);
    let materials = vec![Material::diffuse(Vec3::splat(0.5)), flame];
    let scene = Scene { sky: Sky::black(), ..Scene::from_grid("under a flame", grid, materials) };
    let camera = Camera::look_at(Vec3::new(0.2, 0.3, 1.5), Vec3::new(0.2, 0.3, 0.0));
    let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
    (scene, Frame::new(camera, 8, 8).samples(64).max_bounces(4))
}

#[test]
fn a_flame_has_no_lamp_faces_and_lights_what_stands_around_it() {
    // From all sides but the horizon the floor sees the flame's radiance, and scatters half of it. The flame reflects nothing.
    let (scene, frame) = under_flame(Material::flame(Vec3::new(3.0, 2.0, 1.0), 0.3));
    check(&scene, &frame, [1.5, 1.0, 0.5], 0.01);
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    assert!(packed.geometry().emitters().is_empty());
    // All of it is light of emitters, one bounce after it left.
    let whole = render(&packed, &frame);
    let of = |frame: Frame| render(&packed, &frame).pixels;
    assert!(of(frame.clone().light_group(LightGroup::Emitters)) == whole.pixels);
    assert!(of(frame.clone().light_group(LightGroup::Sky)).iter().all(|pixel| pixel.radiance == [0; 3]));
    let dark = frame.bounce_limits(BounceLimits { diffuse: 0, ..BounceLimits::default() });
    assert!(of(dark).iter().all(|pixel| pixel.radiance == [0; 3]));
    // Glass that glows has a surface, which does.
    let (scene, _) = under_flame(Material { ior: 1.5, ..Material::flame(Vec3::ONE, 0.3) });
    assert!(!PackedScene::pack(&scene).unwrap().geometry().emitters().is_empty());
}

/// A .vox file of one voxel whose material has these keys, with a setting of the number of bounces.
fn vox_file(keys: &[(&'static str, &str)], bounces: &[(&'static str, &str)]) -> Scene {
    let dict = |pairs: &[(&'static str, &str)]| {
        let mut dict = Dict::default();
        pairs.iter().for_each(|(key, value)| dict.push(key, *value));
        dict
    };
    let mut grid = VoxelGrid::new();
    grid.set(IVec3::ZERO, 0);
    let plain = Scene::from_grid("a", grid, vec![Material::diffuse(Vec3::new(1.0, 0.0, 1.0))]);
    let bytes = voxtrace::export::vox::document_of(&plain).unwrap().to_bytes().unwrap();
    let path = std::path::Path::new("a.vox");
    let mut file = VoxFile::parse(&bytes, path, &Limits::default()).unwrap();
    file.chunks.retain(|chunk| !matches!(chunk.body, Body::Material(_)));
    for id in 1..=255 {
        file.chunks.push(Chunk::new(Body::Material(Numbered { id, properties: dict(keys) })));
    }
    file.chunks.push(Chunk::new(Body::RenderObject(dict(bounces))));
    vox::read_bytes(&file.to_bytes().unwrap(), path, &Limits::default()).unwrap()
}

#[test]
fn emissive_media_and_numbers_of_bounces_of_vox_files_are_read() {
    let material = |keys: &[(&'static str, &str)]| vox_file(keys, &[]).materials[0];
    let flame = Material::flame(Vec3::new(1.0, 0.0, 1.0), 0.25);
    for kind in [("_media_type", "_emit"), ("_media", "2")] {
        let read = material(&[("_type", "_media"), kind, ("_d", "0.25"), ("_emit", "9")]);
        assert_eq!((read.emission, read.absorption), (flame.emission, flame.absorption));
        assert!(read.is_without_surface() && read.scattering == 0.0);
    }
    for kind in [("_media_type", "_scatter"), ("_media", "1"), ("_media_type", "_absorb")] {
        assert_eq!(material(&[("_type", "_media"), kind, ("_d", "0.25")]).emission, Vec3::ZERO);
    }
    let bounces = [("_type", "_bounce"), ("_diffuse", "2"), ("_specular", "5"), ("_scatter", "7"), ("_energy", "3")];
    let said = vox::on_request(&vox_file(&[("_type", "_diffuse")], &bounces));
    let options = "--diffuse-bounces 2 --glossy-bounces 5 --transmitted-bounces 5 --volume-bounces 7";
    assert_eq!(said, [format!("numbers of bounces ({options})")]);
}
