//! Cuts: closed forms, light, a judge in double precision (`judge`), and the same films from every tracer (`devices`).

mod devices;
mod judge;

use std::sync::Arc;
use voxtrace::cuts::Cuts;
use voxtrace::film::AovPixel;
use voxtrace::glam::{IVec3, Mat3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Frame, Hit, Integrator, Material, PackedScene, Scene, Sky, Sun, Transform, VoxelGrid};
use voxtrace_tests::estimate::{check_equal, check_same, radiance_of, render};

fn boxes(parts: &[([i32; 3], [i32; 3], u16)]) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for &(min, max, material) in parts {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    }
    grid
}

pub fn cut(scene: &Scene, cuts: &Cuts) -> Arc<PackedScene> {
    let mut packed = PackedScene::pack(scene).unwrap();
    packed.cuts = cuts.clone();
    Arc::new(packed)
}

pub fn plane(normal: [f32; 3], offset: f32) -> Cuts {
    Cuts::default().plane(Vec3::from(normal), offset).unwrap()
}

fn grey() -> Material {
    Material::diffuse(Vec3::splat(0.5))
}

/// A floor, a wall, a lamp, a block of glass with a lamp in it, a cloud, and things that are turned.
pub fn things(is_matte: bool, turns: bool) -> Scene {
    let special = |material: Material| if is_matte { grey() } else { material };
    let materials = vec![
        Material::diffuse(Vec3::new(0.7, 0.5, 0.3)),
        special(Material::metal(Vec3::new(0.9, 0.8, 0.5), 0.3)),
        special(Material::glass(1.5, 0.0).tinted(Vec3::new(0.4, 0.9, 0.6), 4.0)),
        special(Material::cloud(Vec3::new(0.9, 0.8, 0.7), 0.4, 0.5)),
        Material::emissive(Vec3::new(9.0, 8.0, 6.0)),
    ];
    let grid = boxes(&[
        ([-12, -12, -2], [12, 12, 0], 0),
        ([-12, 8, 0], [12, 12, 8], 1),
        ([-8, -6, 0], [-1, 2, 6], 2),
        ([-5, -3, 2], [-3, -1, 4], 4),
        ([2, -7, 0], [8, 0, 5], 3),
        ([3, 3, 4], [7, 6, 6], 4),
    ]);
    let direction = Vec3::new(0.4, -0.3, 0.8).normalize();
    let sun = Sun { direction, angular_radius: 0.05, irradiance: Vec3::splat(2.0) };
    let sky = Sky::gradient(Vec3::new(0.2, 0.15, 0.1), Vec3::new(0.4, 0.6, 0.9)).with_sun(sun);
    let mut scene = Scene { sky, ..Scene::from_grid("things", grid, materials) };
    if turns {
        let turned = Transform { linear: Mat3::from_rotation_z(0.6) * 0.8, translation: Vec3::new(-3.0, 2.0, 0.1) };
        scene.add_instance(boxes(&[([0, 0, 0], [6, 6, 6], 2)]), turned);
        let beside = Transform::from_translation(Vec3::new(1.0, 1.0, 1.0));
        scene.add_instance(boxes(&[([0, 0, 0], [5, 5, 5], 3), ([1, 1, 5], [4, 4, 6], 4)]), beside);
    }
    scene
}

fn frames() -> [Frame; 3] {
    let frame = |eye: [f32; 3], target: [f32; 3]| {
        Frame::new(Camera::look_at(eye.into(), target.into()), 32, 24).samples(2).max_bounces(5).aovs(true)
    };
    let outside = frame([3.0, -26.0, 17.0], [0.0, 0.0, 1.0]);
    let within = frame([-4.1, -3.6, 3.2], [4.0, 4.0, 2.0]);
    [outside.clone(), within, outside.integrator(Integrator::Essay)]
}

#[test]
fn the_cut_of_a_solid_box_is_the_plane() {
    let scene = Scene::from_grid("a box", boxes(&[([0; 3], [16; 3], 0)]), vec![grey()]);
    let eye = Vec3::new(8.0, 7.0, 60.0);
    let frame = Frame::new(Camera::look_at(eye, Vec3::new(8.0, 8.0, 8.0)), 40, 40).aovs(true);
    let normal = Vec3::new(0.3, 0.0, 1.0);
    let aovs = |offset| render(&cut(&scene, &plane(normal.to_array(), offset)), &frame).aovs.unwrap();
    let camera = frame.camera.frame(40, 40);
    // How many pixels show the plane 0.3 x + z = 10 within the box, and whether all do so where it lies.
    let seen = |aovs: &[AovPixel]| {
        let (mut seen, mut is_right) = (0, true);
        for (index, pixel) in aovs.iter().enumerate() {
            let position = Vec2::new((index % 40) as f32 + 0.5, (index / 40) as f32 + 0.5);
            let ray = camera.central_ray(position);
            let t = (10.0 - normal.dot(ray.origin)) / normal.dot(ray.direction);
            let point = ray.at(t);
            if point.cmpge(Vec3::splat(0.1)).all() && point.cmple(Vec3::splat(15.9)).all() {
                seen += 1;
                let is_near = (pixel.depth - t).abs() < 0.005 && pixel.normal.abs_diff_eq(normal.normalize(), 1e-6);
                is_right &= is_near && (pixel.voxel.as_vec3() - point + 0.5).abs().max_element() < 0.51;
            }
        }
        (seen, is_right)
    };
    assert_eq!(seen(&aovs(10.0)), (seen(&aovs(10.0)).0, true));
    assert!(seen(&aovs(10.0)).0 > 100);
    assert!(!seen(&aovs(10.02)).1, "a plane elsewhere");
}

#[test]
fn a_plane_between_two_layers_shows_the_layer_that_is_kept() {
    let materials = vec![Material::diffuse(Vec3::X), Material::diffuse(Vec3::Y)];
    let grid = boxes(&[([0; 3], [16, 16, 8], 0), ([0, 0, 8], [16; 3], 1)]);
    let scene = Scene::from_grid("layers", grid, materials);
    let camera = Camera::look_at(Vec3::new(7.3, -30.0, 41.0), Vec3::splat(8.0));
    let frame = Frame::new(camera, 64, 64).aovs(true);
    let green = |cuts: &Cuts| {
        let aovs = render(&cut(&scene, cuts), &frame).aovs.unwrap();
        aovs.iter().filter(|pixel| pixel.normal == Vec3::Z && pixel.albedo.y > 0.0).count()
    };
    assert_eq!(green(&plane([0.0, 0.0, 1.0], 8.0)), 0);
    assert!(green(&plane([0.0, 0.0, 1.0], 8.1)) > 100);
    // A slice has its thickness: of the layers 6 and 7 both are red.
    let slice = |from, to| render(&cut(&scene, &Cuts::default().slice(2, from, to).unwrap()), &frame).aovs.unwrap();
    let voxels = |aovs: &[AovPixel]| {
        let of = |pixel: &AovPixel| (pixel.instance != Hit::NONE).then_some(pixel.voxel.z);
        aovs.iter().filter_map(of).collect::<std::collections::BTreeSet<_>>().into_iter().collect::<Vec<_>>()
    };
    assert_eq!(voxels(&slice(6.0, 8.0)), [6, 7]);
    assert_eq!(voxels(&slice(6.0, 9.0)), [6, 7, 8]);
}

#[test]
fn a_region_that_holds_everything_changes_no_bit() {
    let around = Cuts::default().clip_box(Vec3::splat(-60.0), Vec3::splat(60.0)).unwrap();
    for (is_matte, turns) in [(true, false), (true, true), (false, true)] {
        let scene = things(is_matte, turns);
        for frame in frames() {
            let whole = render(&cut(&scene, &Cuts::default()), &frame);
            for shadows in [false, true] {
                let cuts = around.clone().shadows(shadows);
                assert!(render(&cut(&scene, &cuts), &frame) == whole, "{is_matte} {turns} {shadows}");
                let cuts = cuts.plane(Vec3::new(1.0, 1.0, 1.0), 20.0).unwrap();
                // Whoever stands in a solid sees no corner of it; behind the first face of glass everything is seen with shadows.
                let sees = frame.camera.eye.z > 10.0 || !(is_matte || shadows);
                assert!(!sees || render(&cut(&scene, &cuts), &frame) != whole, "a corner is cut off");
            }
        }
    }
}

/// A closed room of 20 × 20 × 10 voxels, a lamp under its ceiling, in the dark.
fn room() -> Scene {
    let mut grid = boxes(&[([0; 3], [20, 20, 10], 0)]);
    grid.clear_box(VoxelBox { min: IVec3::ONE, max: IVec3::new(19, 19, 9) });
    grid.fill_box(VoxelBox { min: IVec3::new(4, 8, 7), max: IVec3::new(8, 12, 8) }, 1);
    let materials = vec![grey(), Material::emissive(Vec3::splat(8.0))];
    Scene { sky: Sky::black(), ..Scene::from_grid("a room", grid, materials) }
}

fn into_room() -> Frame {
    let camera = Camera::look_at(Vec3::new(14.0, 10.0, 4.5), Vec3::new(9.0, 10.0, 1.0));
    Frame::new(camera, 8, 8).samples(400).max_bounces(3)
}

#[test]
fn lamps_that_are_cut_away_give_no_light_unless_the_light_is_that_of_the_whole_scene() {
    let away = plane([-1.0, 0.0, 0.0], -8.5);
    let light = |cuts: &Cuts, integrator| {
        let film = render(&cut(&room(), cuts), &into_room().integrator(integrator).samples(4));
        film.pixels.iter().map(|pixel| f64::from(pixel.mean().x)).sum::<f64>()
    };
    for integrator in [Integrator::Path, Integrator::Essay] {
        assert_eq!(light(&away, integrator), 0.0);
        assert!(light(&away.clone().shadows(true), integrator) > 0.0);
        assert!(light(&plane([-1.0, 0.0, 0.0], -7.5), integrator) > 0.0, "a rest of the lamp");
    }
}

#[test]
fn light_of_a_lamp_that_is_cut_in_two_is_the_same_by_chance_and_by_choice() {
    let half = plane([-1.0, 0.0, 0.0], -6.3);
    let light = |cuts: &Cuts, integrator| {
        let frame = into_room().integrator(integrator);
        // The study's rays begin at t = 0.1; the room is wide enough for that.
        radiance_of(&cut(&room(), cuts), &frame, 1)
    };
    let by_choice = light(&half, Integrator::Path);
    check_same(&by_choice, &light(&half, Integrator::Essay), 0.25).unwrap();
    check_same(&by_choice, &light(&plane([-1.0, 0.0, 0.0], -4.7), Integrator::Essay), 0.25).unwrap_err();
}

#[test]
fn a_roof_that_is_cut_away_casts_a_shadow_only_where_it_is_asked_to() {
    let grid = boxes(&[([-20, -20, -1], [20, 20, 0], 0), ([-20, -20, 10], [20, 20, 11], 0)]);
    let sun = Sun { direction: Vec3::Z, angular_radius: 0.0, irradiance: Vec3::splat(2.0) };
    let scene = Scene { sky: Sky::uniform(Vec3::ZERO).with_sun(sun), ..Scene::from_grid("a roof", grid, vec![grey()]) };
    let frame = Frame::new(Camera::look_at(Vec3::new(1.0, -9.0, 30.0), Vec3::ZERO), 16, 12).max_bounces(1);
    let light = |cuts: &Cuts| {
        let film = render(&cut(&scene, cuts), &frame);
        film.pixels[6 * 16 + 8].mean().x
    };
    let below = plane([0.0, 0.0, 1.0], 8.0);
    let expected = 0.5 / std::f32::consts::PI * 2.0;
    assert!((light(&below) - expected).abs() < 1e-4, "{}", light(&below));
    assert_eq!(light(&below.clone().shadows(true)), 0.0);
    // The face of a cut through the roof is lit in either case: before it lies only what is cut away.
    for cuts in [plane([0.0, 0.0, 1.0], 10.5), plane([0.0, 0.0, 1.0], 10.5).shadows(true)] {
        assert!((light(&cuts) - expected).abs() < 1e-4, "{}", light(&cuts));
    }
}

#[test]
fn light_through_a_medium_that_is_cut_on_both_sides_follows_beer() {
    let tinted = Material::glass(1.0, 0.0).tinted(Vec3::new(0.5, 0.25, 1.0), 4.0);
    let grid = boxes(&[([-20, -20, 0], [20, 20, 16], 0)]);
    let scene = Scene { sky: Sky::uniform(Vec3::ONE), ..Scene::from_grid("a slab", grid, vec![tinted]) };
    let camera = Camera::look_at(Vec3::new(0.3, 0.2, 4000.0), Vec3::new(0.3, 0.2, 0.0));
    let frame = Frame::new(Camera { fov_y: 0.05, up: Vec3::Y, ..camera }, 4, 4);
    let through = |from, to| {
        let film = render(&cut(&scene, &Cuts::default().slice(2, from, to).unwrap()), &frame);
        film.pixels[5].mean()
    };
    assert!(through(3.0, 11.0).abs_diff_eq(Vec3::new(0.25, 0.0625, 1.0), 1e-3), "{}", through(3.0, 11.0));
    assert!(through(5.25, 9.25).abs_diff_eq(Vec3::new(0.5, 0.25, 1.0), 1e-3), "{}", through(5.25, 9.25));
    assert!(!through(5.25, 9.5).abs_diff_eq(Vec3::new(0.5, 0.25, 1.0), 1e-3));
}

#[test]
fn clear_glass_that_is_cut_is_invisible_in_a_white_sky() {
    let light = |material| {
        let scene = Scene {
            sky: Sky::uniform(Vec3::ONE),
            ..Scene::from_grid("a block", boxes(&[([-5; 3], [5; 3], 0)]), vec![material])
        };
        let cuts = plane([0.5, -0.4, 1.0], 2.3).slice(0, -3.7, 4.0).unwrap();
        let frame = Frame::new(Camera::look_at(Vec3::new(14.0, -17.0, 11.0), Vec3::ZERO), 12, 12);
        radiance_of(&cut(&scene, &cuts), &frame.samples(48).max_bounces(400), 1)
    };
    for material in [Material::glass(1.5, 0.0), Material::glass(1.0, 0.0), Material::cloud(Vec3::ONE, 0.4, 0.3)] {
        check_equal(&light(material), 1.0).unwrap_or_else(|error| panic!("{material:?}: {error}"));
        check_equal(&light(material.tinted(Vec3::splat(0.99), 1.0)), 1.0).unwrap_err();
    }
}
