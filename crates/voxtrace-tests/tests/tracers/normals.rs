//! Normals of voxels: a ball of voxels is lit as a ball, no light is lost or made, they go with instances; the same films from every tracer, and without
//! them the films that there were.

use std::f32::consts::PI;
use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::cuts::Cuts;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::normals::Normals;
use voxtrace::surroundings::{Fog, Ground};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Instance, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer, Transform,
    VoxelGrid,
};
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_vulkan::{Primitive, Traversal};

/// Radius of the ball, voxels, and its middle.
const RADIUS: f32 = 24.0;
const MIDDLE: Vec3 = Vec3::new(0.2, 0.4, -0.3);

/// The voxels within `reach` of the origin whose middles are inside, of one material.
fn filled(reach: i32, material: Material, is_inside: impl Fn(Vec3) -> bool) -> Scene {
    let mut voxels = VoxelGrid::new();
    for z in -reach..reach {
        for y in -reach..reach {
            for x in -reach..reach {
                if is_inside(IVec3::new(x, y, z).as_vec3() + 0.5) {
                    voxels.set(IVec3::new(x, y, z), 0);
                }
            }
        }
    }
    Scene { sky: Sky::uniform(Vec3::ONE), ..Scene::from_grid("voxels", voxels, vec![material]) }
}

fn ball(material: Material) -> Scene {
    filled(26, material, |p| (p - MIDDLE).length() < RADIUS)
}

fn packed(scene: &Scene, normals: Normals) -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(scene).unwrap().with_normals(normals).unwrap())
}

/// The ball from one side, without perspective, and the ball's place that the middle of a pixel shows, with the distance of the pixel from the middle.
fn view(pixels: u32) -> (Frame, impl Fn(usize) -> (Vec3, f32)) {
    let toward = Vec3::new(0.48, -0.6, 0.64);
    let camera =
        Camera::look_at(MIDDLE + toward * 90.0, MIDDLE).with_lens(Lens::Orthographic { view_height: 2.0 * RADIUS });
    let right = Vec3::Z.cross(toward).normalize();
    let up = toward.cross(right);
    let place = move |at: usize| {
        let (x, y) = (at as u32 % pixels, at as u32 / pixels);
        let across = |at: u32| (2.0 * (at as f32 + 0.5) / pixels as f32 - 1.0) * RADIUS;
        let (x, y) = (across(x), -across(y));
        let distance = x.hypot(y);
        let depth = (RADIUS * RADIUS - distance * distance).max(0.0).sqrt();
        (right * x + up * y + toward * depth, distance)
    };
    (Frame::new(camera, pixels, pixels), place)
}

#[test]
fn the_normals_of_a_ball_are_those_of_the_ball() {
    let (frame, place) = view(96);
    let mean_angle = |normals: Normals| {
        let film = render(&packed(&ball(Material::diffuse(Vec3::ONE)), normals), &frame.clone().aovs(true));
        let aovs = film.aovs.unwrap();
        let within: Vec<usize> = (0..aovs.len()).filter(|&at| place(at).1 < 0.9 * RADIUS).collect();
        let angle = |&at: &usize| place(at).0.normalize().dot(aovs[at].normal).clamp(-1.0, 1.0).acos().to_degrees();
        within.iter().map(angle).sum::<f32>() / within.len() as f32
    };
    let (smooth, faces) = (mean_angle(Normals::Smooth), mean_angle(Normals::Faces));
    assert!(smooth < 2.5, "{smooth}");
    assert!(faces > 20.0, "the comparison sees faces: {faces}");
}

#[test]
fn a_ball_in_the_sun_is_as_bright_as_lamberts_law_says() {
    let direction = Vec3::new(-0.36, -0.48, 0.8);
    let sun = Sun { direction, angular_radius: 0.02, irradiance: Vec3::splat(PI) };
    let sky = Sky::uniform(Vec3::ZERO).with_sun(Some(sun));
    let (frame, place) = view(96);
    let frame = frame.samples(64).max_bounces(1);
    let error = |normals: Normals| {
        let scene = Scene { sky: sky.clone(), ..ball(Material::diffuse(Vec3::splat(0.8))) };
        let film = render(&packed(&scene, normals), &frame);
        let squares: Vec<f64> = (0..film.pixels.len())
            .filter(|&at| place(at).1 < 0.9 * RADIUS)
            .map(|at| {
                let expected = 0.8 * place(at).0.normalize().dot(direction).max(0.0);
                f64::from(film.pixels[at].mean().y - expected).powi(2)
            })
            .collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    };
    let (smooth, faces) = (error(Normals::Smooth), error(Normals::Faces));
    assert!(smooth < 0.02, "{smooth}");
    assert!(faces > 8.0 * smooth, "the comparison sees terraces: {faces} {smooth}");
}

#[test]
fn no_light_is_lost_and_none_is_made() {
    let (frame, place) = view(48);
    let within = |film: &Film| -> Vec<f32> {
        let pixels = film.pixels.iter().enumerate().filter(|(at, _)| place(*at).1 < 0.93 * RADIUS);
        pixels.map(|(_, pixel)| pixel.mean().y).collect()
    };
    let mean = |light: &[f32]| light.iter().sum::<f32>() / light.len() as f32;
    // Under a white sky a convex thing is as bright as it is white: nothing of it shades another part.
    let frame = frame.samples(64);
    let grey = ball(Material::diffuse(Vec3::splat(0.5)));
    let smooth = within(&render(&packed(&grey, Normals::Smooth), &frame));
    let faces = within(&render(&packed(&grey, Normals::Faces), &frame));
    assert!((mean(&smooth) - 0.5).abs() < 0.001, "{}", mean(&smooth));
    assert!(smooth.iter().all(|light| (0.4..0.51).contains(light)), "no pixel is black: {smooth:?}");
    assert!(mean(&faces) < 0.47, "the comparison sees steps that shade each other: {}", mean(&faces));
    // A white thing cannot be seen there, whatever its shape; metals and coats lose a little between facets, and make nothing.
    let rough = |p: Vec3| (p - MIDDLE).length() < RADIUS + 2.0 * (0.7 * p.x).sin() * (0.6 * p.y).sin() - 3.0;
    for (material, least) in [
        (Material::diffuse(Vec3::ONE), 0.98),
        (Material::metal(Vec3::ONE, 0.0), 0.98),
        (Material::metal(Vec3::ONE, 0.4), 0.9),
        (Material::plastic(Vec3::ONE, 0.3), 0.7),
    ] {
        let scene = packed(&filled(26, material, rough), Normals::Smooth);
        let light = within(&render(&scene, &frame.clone().max_bounces(64)));
        assert!((least..1.01).contains(&mean(&light)), "{material:?}: {}", mean(&light));
    }
}

#[test]
fn normals_go_with_an_instance() {
    let slope = filled(12, Material::diffuse(Vec3::ONE), |p| p.dot(Vec3::new(0.3, -0.2, 0.9)) < 0.0);
    let camera = |target: Vec3, edge: f32| {
        let camera = Camera { up: Vec3::Y, ..Camera::look_at(target.with_z(90.0), target) };
        Frame::new(camera.with_lens(Lens::Orthographic { view_height: edge }), 48, 48).aovs(true)
    };
    let normals = |scene: &Scene, frame: &Frame, normals: Normals| -> Vec<Vec3> {
        render(&packed(scene, normals), frame).aovs.unwrap().iter().map(|aov| aov.normal).collect()
    };
    let plain = normals(&slope, &camera(Vec3::ZERO, 16.0), Normals::Smooth);
    let placed = |linear: Mat3, translation: Vec3| {
        let instance = Instance { world_from_grid: Transform { linear, translation }, ..slope.instances[0].clone() };
        Scene { instances: vec![instance], ..slope.clone() }
    };
    let linear = Mat3::from_rotation_z(std::f32::consts::FRAC_PI_2) * Mat3::from_diagonal(Vec3::new(-2.0, 2.0, 2.0));
    let turned = placed(linear, Vec3::new(5.0, 6.0, 0.0));
    let found = normals(&turned, &camera(Vec3::new(5.0, 6.0, 0.0), 32.0), Normals::Smooth);
    // Mirrored along x, then turned: x and y change places and signs, rows of the picture and columns change places.
    let turned_pixel = |at: usize| at % 48 * 48 + at / 48;
    let differing = |turn: &dyn Fn(Vec3) -> Vec3| {
        (0..48 * 48).filter(|&at| (found[at] - turn(plain[turned_pixel(at)])).length() > 1e-4).count()
    };
    let count = differing(&|n| Vec3::new(-n.y, -n.x, n.z));
    assert!(count < 16, "{count} pixels");
    assert!(differing(&|n| n) > 1000, "the comparison sees whether it is turned");
}

#[test]
fn a_merged_scene_has_the_film_of_its_voxels_as_one_grid() {
    let slope = |p: Vec3| p.dot(Vec3::new(0.3, -0.2, 0.9)) < 2.0;
    let whole = filled(16, Material::diffuse(Vec3::splat(0.7)), slope);
    let mut halves = Scene { grids: vec![], instances: vec![], ..whole.clone() };
    for side in 0..2 {
        let mut half = VoxelGrid::new();
        let moved = IVec3::new(16 * side - 16, 0, 0);
        let of_half = whole.grids[0].voxels().filter(|(voxel, _)| (voxel.x >= 0) == (side == 1));
        of_half.for_each(|(voxel, material)| _ = half.set(voxel - moved, material));
        halves.add_instance(half, Transform::from_translation(moved.as_vec3()));
    }
    let camera = Camera::look_at(Vec3::new(-30.0, -44.0, 40.0), Vec3::ZERO);
    let frame = Frame::new(camera, 32, 24).samples(2);
    let one = render(&packed(&whole, Normals::Smooth), &frame);
    let merged = PackedScene::pack_merged(&halves).unwrap();
    let films = [Normals::Smooth, Normals::Faces].map(|normals| {
        assert!(merged.is_merged());
        render(&Arc::new(merged.with_normals(normals).unwrap()), &frame)
    });
    assert!(films[0].pixels == one.pixels);
    assert!(films[1].pixels != one.pixels, "the comparison sees normals");
}

/// Things of many materials, round and thin, some of them turned and mirrored.
fn still_life(materials: Vec<Material>) -> Scene {
    let count = materials.len() as i32;
    let mut voxels = VoxelGrid::new();
    for place in 0..24 * 24 * 16 {
        let voxel = IVec3::new(place % 24, place / 24 % 24, place / 576) - IVec3::new(12, 12, 4);
        let p = voxel.as_vec3() + 0.5;
        let is_ball = (p - Vec3::new(0.0, 0.0, 4.0)).length() < 5.5;
        let is_floor = p.z < 0.15 * p.x - 1.0;
        let is_sheet = (p.x + 0.4 * p.z - 8.0).abs() < 0.6;
        if is_ball || is_floor || is_sheet {
            voxels.set(voxel, ((voxel.x / 3 + voxel.y / 4 + voxel.z / 3 + 40) % count) as u16);
        }
    }
    let sun = Sun::at(200.0, 40.0, 3.0);
    let scene = Scene { sky: Sky::study(1.0).with_sun(sun), ..Scene::from_grid("still life", voxels, materials) };
    let turned = Mat3::from_rotation_z(0.6) * Mat3::from_diagonal(Vec3::new(-1.3, 1.3, 1.3));
    let mut instances = scene.instances.clone();
    let transform = Transform { linear: turned, translation: Vec3::new(29.0, 4.0, 1.5) };
    instances.push(Instance { world_from_grid: transform, ..scene.instances[0].clone() });
    Scene { instances, ..scene }
}

#[test]
fn every_tracer_makes_the_same_films() {
    let matte = vec![Material::diffuse(Vec3::splat(0.6)), Material::diffuse(Vec3::new(0.7, 0.4, 0.2))];
    let more = [
        Material::metal(Vec3::ONE, 0.1),
        Material::metal(Vec3::ONE, 0.0),
        Material::glass(1.5, 0.0),
        Material::cloud(Vec3::splat(0.8), 0.3, 0.2),
        Material::emissive(Vec3::splat(3.0)),
        Material::plastic(Vec3::splat(0.6), 0.2),
    ];
    let all = still_life([matte, more.to_vec()].concat());
    // One grid that stands where it is; and several, around which there are others.
    let single = Scene { instances: all.instances[..1].to_vec(), ..all.clone() };
    let ground = Ground { height: None, color: Vec3::splat(0.3) };
    let fog = Fog { density: 0.004, color: Vec3::splat(0.9), anisotropy: 0.0 };
    let [scenes, with_faces] = [Normals::Smooth, Normals::Faces].map(|normals| {
        let around = packed(&all, normals).with_surroundings(Some(&ground), Some(&fog)).unwrap();
        let mut cut = PackedScene::clone(&packed(&single, normals));
        cut.cuts = Cuts::default().plane(Vec3::new(0.2, -0.1, 1.0), 5.3).unwrap();
        [Arc::new(cut), Arc::new(around)]
    });
    let camera = Camera { fov_y: 50.0, ..Camera::look_at(Vec3::new(-14.0, -34.0, 24.0), Vec3::new(9.0, 1.0, 0.0)) };
    let path = Frame::new(camera, 32, 24).samples(2).max_bounces(4).aovs(true);
    let essay = path.clone().integrator(Integrator::Essay);
    let cases = [(0, &path), (0, &essay), (1, &path)];
    let mut cpu = CpuTracer::new(None);
    let mut films = |scenes: &[Arc<PackedScene>]| {
        cases.map(|(scene, frame)| {
            cpu.set_scene(&scenes[scene]).unwrap();
            film(&mut cpu, frame)
        })
    };
    let (expected, faces) = (films(&scenes), films(&with_faces));
    for (smooth, faces) in expected.iter().zip(&faces) {
        assert!(smooth.pixels != faces.pixels, "the comparison sees normals");
    }
    assert!(expected[0].aovs != faces[0].aovs);
    let Some(device) = device() else { return };
    let few = [Traversal::Walk, Traversal::Query, Traversal::Pipeline].map(|traversal| (traversal, Primitive::Brick));
    for_each_tracer(&device, &film_methods(&device, &few), &scenes[0], |tracer, traversal, primitive| {
        for ((scene, frame), expected) in cases.iter().zip(&expected) {
            tracer.set_scene(&scenes[*scene]).unwrap();
            let integrator = frame.integrator;
            assert!(film(tracer, frame) == *expected, "{traversal:?} {primitive:?} scene {scene}: {integrator:?}");
        }
    });
    assert_valid(&device);
}
