//! Real-time light against films of many samples, in a room with a lamp, blocks, a mirror and a window of sky.

use glam::{IVec3, Vec3};
use voxtrace_core::packed::{PackedInstance, Placement};
use voxtrace_core::{CpuTracer, Film, Frame, PackedScene, Progress, Tracer};
use voxtrace_realtime::{Parts, RealTime};
use voxtrace_scene::{Camera, Instance, Material, Scene, VoxelGrid, transform::Transform};

fn room() -> PackedScene {
    PackedScene::pack(&room_with(0)).unwrap()
}

/// A room of 48 × 48 × 32 voxels: grey walls, one of them red, a lamp, a block and a mirror; with some cubes of 3³ voxels, each an instance, in the air.
fn room_with(cubes: usize) -> Scene {
    let mut grid = VoxelGrid::default();
    for x in 0..48 {
        for y in 0..48 {
            for z in 0..32 {
                let is_wall = x == 0 || x == 47 || y == 47 || z == 0 || z == 31;
                let is_lamp = z == 31 && (20..28).contains(&x) && (20..28).contains(&y);
                let is_block = (8..20).contains(&x) && (24..36).contains(&y) && z < 14;
                let is_mirror = (30..40).contains(&x) && (30..34).contains(&y) && z < 20;
                let material = match () {
                    () if is_lamp => 2,
                    () if is_mirror => 3,
                    () if x == 0 => 1,
                    () if is_wall || is_block => 0,
                    () => continue,
                };
                grid.set(IVec3::new(x, y, z), material);
            }
        }
    }
    let mut scene = Scene::new("room");
    let matte = |color: Vec3| Material { base_color: color, ..Material::default() };
    scene.materials = vec![matte(Vec3::splat(0.7)), matte(Vec3::new(0.7, 0.1, 0.1))];
    scene.materials.push(Material { emission: Vec3::splat(20.0), ..matte(Vec3::splat(0.5)) });
    scene.materials.push(Material { metallic: 1.0, roughness: 0.0, ..matte(Vec3::splat(0.9)) });
    scene.grids.push(grid.into());
    scene.instances.push(Instance::new(0, Transform::IDENTITY));
    let mut cube = VoxelGrid::default();
    (0..27).for_each(|index| _ = cube.set(IVec3::new(index % 3, index / 3 % 3, index / 9), 1));
    scene.grids.push(cube.into());
    for number in 0..cubes {
        let place = Vec3::new(8.0, 12.0 + 4.0 * number as f32, 22.0);
        scene.instances.push(Instance::new(1, Transform::from_translation(place)));
    }
    scene
}

/// A floor of 48 × 48 voxels with a small lamp above it, and beside it a closed box with a lamp that would send a hundred times as much.
fn hidden_lamp() -> PackedScene {
    let mut grid = VoxelGrid::default();
    for x in 0..48 {
        for y in 0..48 {
            for z in 0..24 {
                let at = IVec3::new(x, y, z);
                let within = |low: IVec3, high: IVec3| at.cmpge(low).all() && at.cmplt(high).all();
                let is_shell = within(IVec3::new(30, 28, 4), IVec3::new(44, 42, 18))
                    && !within(IVec3::new(31, 29, 5), IVec3::new(43, 41, 17));
                let material = match () {
                    () if within(IVec3::new(35, 33, 9), IVec3::new(39, 37, 13)) => 2,
                    () if within(IVec3::new(12, 24, 20), IVec3::new(14, 26, 21)) => 1,
                    () if z == 0 || is_shell => 0,
                    () => continue,
                };
                grid.set(at, material);
            }
        }
    }
    let mut scene = Scene::new("a hidden lamp");
    let matte = Material { base_color: Vec3::splat(0.6), ..Material::default() };
    scene.materials = vec![matte, Material { emission: Vec3::splat(30.0), ..matte }];
    scene.materials.push(Material { emission: Vec3::splat(150.0), ..matte });
    scene.grids.push(grid.into());
    scene.instances.push(Instance::new(0, Transform::IDENTITY));
    PackedScene::pack(&scene).unwrap()
}

/// The scene with some instances a step to the right.
fn step(scene: &PackedScene, moved: impl Fn(usize) -> bool) -> PackedScene {
    let place = |(index, instance): (usize, &PackedInstance)| {
        let by = if moved(index) { Vec3::X } else { Vec3::ZERO };
        PackedInstance::new(instance.grid, instance.world_from_grid.translated(by), instance.scene_instance)
    };
    let instances: Vec<_> = scene.instances().iter().enumerate().map(place).collect();
    scene.with_placement(&Placement::new(scene.geometry(), instances).unwrap()).unwrap()
}

fn frame() -> Frame {
    Frame::new(Camera::look_at(Vec3::new(24.0, -20.0, 16.0), Vec3::new(24.0, 40.0, 13.0)), 64, 36)
}

/// The mean radiance of a film.
fn film(scene: &PackedScene, frame: &Frame, samples: u32) -> Vec<Vec3> {
    let frame = frame.clone().samples(samples).seed(1);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene.clone().into()).unwrap();
    tracer.render(&frame, &Progress::default()).unwrap();
    let mut film = Film::new(1, 1, frame.region, 0);
    tracer.read(&mut film).unwrap();
    film.pixels.iter().map(|pixel| pixel.mean()).collect()
}

/// Root of the mean square difference of what is shown.
fn difference(a: &[Vec3], b: &[Vec3]) -> f32 {
    let shown = |color: Vec3| color / (color + 1.0);
    let squares = a.iter().zip(b).map(|(a, b)| (shown(*a) - shown(*b)).length_squared()).sum::<f32>();
    (squares / (3 * a.len()) as f32).sqrt()
}

fn energy(picture: &[Vec3]) -> f32 {
    picture.iter().map(|color| color.element_sum()).sum()
}

/// The pictures of some frames in a row.
fn pictures(parts: Parts, scene: &PackedScene, frame: &Frame, count: u32) -> Vec<Vec<Vec3>> {
    let mut real_time = RealTime::new(parts);
    (0..count).map(|_| real_time.frame(scene, frame)).collect()
}

#[test]
fn pictures_are_nearer_to_the_truth_than_samples_alone_from_the_first_frame_on() {
    let (scene, frame) = (room(), Frame::new(frame().camera, 96, 54));
    let truth = film(&scene, &frame, 1024);
    let memory = Parts { memory: true, ..Parts::NONE };
    let all = pictures(Parts::ALL, &scene, &frame, 16);
    let raw = pictures(memory, &scene, &frame, 16);
    for (number, most) in [(1, 0.35), (4, 0.4), (16, 0.5)] {
        let [of_all, of_raw] = [&all, &raw].map(|pictures| difference(&truth, &pictures[number - 1]));
        assert!(of_all < most * of_raw, "frame {number}: {of_all} of {of_raw}");
    }
    assert!(difference(&truth, &raw[15]) < 0.35 * difference(&truth, &raw[0]), "samples of frames add up");
    let shifted: Vec<Vec3> = all[15].iter().skip(2).chain(&all[15][..2]).copied().collect();
    assert!(difference(&truth, &shifted) > 0.5 * difference(&truth, &raw[15]), "a fault is seen");
}

#[test]
fn lights_that_nobody_sees_are_asked_less_often_and_light_stays_as_it_is() {
    let (scene, frame) = (hidden_lamp(), Frame::new(frame().camera, 96, 54));
    let truth = film(&scene, &frame, 1024);
    let parts = |visibility| Parts { memory: true, cache: true, candidates: true, visibility, ..Parts::NONE };
    let [with, without] = [true, false].map(|visibility| pictures(parts(visibility), &scene, &frame, 48).remove(47));
    let [of_both, of_all] = [&with, &without].map(|picture| difference(&truth, picture));
    // Half as many candidates.
    assert!(of_both < 0.8 * of_all, "{of_both} of {of_all}");
    let ratio = energy(&with) / energy(&truth);
    assert!((0.98..1.02).contains(&ratio), "{ratio}");
}

#[test]
fn the_light_cache_neither_makes_nor_loses_light() {
    let (scene, frame) = (room(), frame());
    let truth = energy(&film(&scene, &frame, 256));
    let parts = Parts { memory: true, cache: true, candidates: true, visibility: true, ..Parts::NONE };
    let all = pictures(parts, &scene, &frame, 32);
    let ratio = energy(&all[31]) / truth;
    assert!((0.98..1.02).contains(&ratio), "{ratio}");
    // Without what bounces a second time it is darker: the bound is one that a fault would pass.
    let direct = energy(&film(&scene, &frame.max_bounces(1), 64)) / truth;
    assert!(direct < 0.9, "{direct}");
}

#[test]
fn light_is_remembered_where_the_camera_moves_and_forgotten_where_it_looks_elsewhere() {
    let (scene, frame) = (room(), frame());
    let remembers = |real_time: &RealTime| {
        let known = real_time.memory().iter().filter(|memory| memory.paths > 6.0).count();
        known as f32 / real_time.memory().len() as f32
    };
    let mut real_time = RealTime::new(Parts::ALL);
    for _ in 0..8 {
        real_time.frame(&scene, &frame);
    }
    let mut moved = frame.clone();
    moved.camera.eye.x += 0.5;
    real_time.frame(&scene, &moved);
    assert!(remembers(&real_time) > 0.85, "{}", remembers(&real_time));
    // The camera turns around: nothing of what it sees was there.
    moved.camera.target = moved.camera.eye - Vec3::Y;
    real_time.frame(&scene, &moved);
    assert!(remembers(&real_time) < 0.1, "{}", remembers(&real_time));
}

#[test]
fn lamps_that_are_dimmed_leave_no_ghost() {
    let (scene, frame) = (room(), frame());
    let mut dimmed = scene.clone();
    dimmed.light_intensity *= 0.1;
    let truth = energy(&film(&dimmed, &frame, 128));
    let after = |says_so: bool| {
        let mut real_time = RealTime::new(Parts::ALL);
        for _ in 0..12 {
            real_time.frame(&scene, &frame);
        }
        if says_so {
            real_time.change();
        }
        let pictures: Vec<_> = (0..4).map(|_| real_time.frame(&dimmed, &frame)).collect();
        [0, 3].map(|number: usize| energy(&pictures[number]) / truth)
    };
    let ratios = after(true);
    assert!(ratios.iter().all(|ratio| (0.8..1.25).contains(ratio)), "{ratios:?}");
    assert!(after(false).iter().all(|&ratio| ratio > 2.0), "who does not say that light changed sees its ghost");
}

#[test]
fn pixels_in_which_nothing_moves_keep_what_they_know_and_those_that_a_thing_left_do_not() {
    let (mut scene, frame) = (PackedScene::pack(&room_with(2)).unwrap(), Frame::new(frame().camera, 96, 54));
    let mut real_time = RealTime::new(Parts::ALL);
    let mut last_seen = vec![None; 96 * 54];
    let mut next = |real_time: &mut RealTime, number: f32, moved: &dyn Fn(usize) -> bool| {
        let before = scene.instances().to_vec();
        scene = step(&scene, moved);
        real_time.move_instances(&before);
        real_time.frame(&scene, &frame);
        for (memory, last_seen) in real_time.memory().iter().zip(&mut last_seen) {
            if memory.coverage > 0.0 && memory.instance == 1 {
                *last_seen = Some(number);
                assert!(!memory.is_at_rest, "frame {number}: {memory:?}");
            }
            // A pixel is looked at four times when it has left, and once in each frame from then on. The first picture has several frames.
            let most = last_seen.filter(|_| number > 0.0).map_or(f32::INFINITY, |last| 4.0 + number - last);
            assert!(memory.looks <= most, "frame {number}, last seen in {last_seen:?}: {memory:?}");
        }
        let kept = real_time.memory().iter().filter(|memory| memory.is_at_rest && memory.looks > 4.0).count();
        kept as f32 / (96.0 * 54.0)
    };
    let first = |index: usize| index == 1;
    let kept: Vec<f32> = (0..16).map(|number| next(&mut real_time, number as f32, &first)).collect();
    // All but the cube, its edges and the mirror.
    assert!(kept.iter().skip(1).all(|kept| (0.75..0.99).contains(kept)), "{kept:?}");
    let looks = real_time.memory().iter().map(|memory| memory.looks).fold(0.0, f32::max);
    assert!(looks >= 18.0, "{looks}");
    // Where another one begins to move too, it may be in what any pixel remembers.
    assert_eq!(next(&mut real_time, 16.0, &|index| index > 0), 0.0);
    assert!(next(&mut real_time, 17.0, &|index| index == 2) > 0.7, "both are known to move");
}

/// A mirror that leans, before the sky, and a block at its side.
fn mirror_before_the_sky() -> PackedScene {
    before_the_sky(Material { metallic: 1.0, roughness: 0.0, base_color: Vec3::ONE, ..Material::default() })
}

/// A cube of a material that leans, before the sky, and a block at its side.
fn before_the_sky(material: Material) -> PackedScene {
    let mut scene = Scene::new("something before the sky");
    let cube = |edge: i32, material: u16| {
        let mut grid = VoxelGrid::default();
        (0..edge * edge * edge)
            .for_each(|at| _ = grid.set(IVec3::new(at % edge, at / edge % edge, at / edge / edge), material));
        grid
    };
    scene.materials = vec![Material { base_color: Vec3::splat(0.5), ..Material::default() }];
    scene.materials.push(material);
    scene.grids = vec![cube(8, 0).into(), cube(8, 1).into()];
    scene.instances.push(Instance::new(0, Transform::from_translation(Vec3::new(-30.0, 0.0, -10.0))));
    let leaning = Transform::from_rotation(glam::Quat::from_rotation_x(-0.6)).translated(Vec3::new(-16.0, 0.0, 0.0));
    scene.instances.push(Instance::new(1, leaning));
    PackedScene::pack(&scene).unwrap()
}

#[test]
fn a_mirror_that_moves_before_the_sky_leaves_no_trail() {
    let mut scene = mirror_before_the_sky();
    let frame = Frame::new(Camera::look_at(Vec3::new(0.0, -60.0, 4.0), Vec3::new(0.0, 0.0, 4.0)), 96, 54);
    let mut real_time = RealTime::new(Parts::ALL);
    let mut picture = real_time.frame(&scene, &frame);
    for _ in 0..24 {
        let before = scene.instances().to_vec();
        scene = step(&scene, |index| index == 1);
        real_time.move_instances(&before);
        picture = real_time.frame(&scene, &frame);
    }
    let truth = film(&scene, &frame, 256);
    let worst = truth.iter().zip(&picture).map(|(truth, picture)| (*truth - *picture).abs().max_element());
    // What the mirror left, to its left.
    let of_trail = worst.enumerate().filter(|(index, _)| (20..52).contains(&(index % 96))).map(|(_, worst)| worst);
    let trail = of_trail.fold(0.0, f32::max);
    assert!(trail < 0.07, "{trail}");
}

#[test]
fn the_filter_takes_the_noise_of_what_is_seen_by_chance_through_glass_and_leaves_mirrors_sharp() {
    let frame = Frame::new(Camera::look_at(Vec3::new(-12.0, -26.0, 6.0), Vec3::new(-12.0, 4.0, 4.0)), 96, 54);
    // What the filter takes of what is wrong where the cube is, two pictures after a cut.
    let left_by_filter = |material: Material| {
        let scene = before_the_sky(material);
        let truth = film(&scene, &frame, 2048);
        let cube = film(&before_the_sky(Material { base_color: Vec3::ZERO, ..Material::default() }), &frame, 16);
        let of_cube = |picture: &[Vec3]| -> Vec<Vec3> {
            let black = picture.iter().zip(&cube).filter(|(_, cube)| cube.max_element() < 1e-3);
            black.map(|(color, _)| *color).collect()
        };
        assert!(of_cube(&truth).len() > 100, "{}", of_cube(&truth).len());
        let wrong = |parts: Parts| {
            let last = pictures(parts, &scene, &frame, 2).pop().unwrap();
            difference(&of_cube(&truth), &of_cube(&last))
        };
        wrong(Parts::ALL) / wrong(Parts { filter: false, ..Parts::ALL })
    };
    let glass = Material { transmission: 1.0, ior: 1.5, base_color: Vec3::ONE, ..Material::default() };
    let mirror = Material { metallic: 1.0, roughness: 0.0, base_color: Vec3::ONE, ..Material::default() };
    let [of_glass, of_mirror] = [glass, mirror].map(left_by_filter);
    assert!(of_glass < 0.4, "{of_glass}: what glass shows by chance is noise");
    assert!((0.9..1.1).contains(&of_mirror), "{of_mirror}: a mirror's sky has none");
}

#[test]
fn pictures_do_not_depend_on_the_number_of_threads() {
    let (scene, frame) = (room(), frame());
    let of_threads = |count: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
        pool.install(|| pictures(Parts::ALL, &scene, &frame, 3))
    };
    let [one, three] = [1, 3].map(of_threads);
    assert_eq!(one, three);
    assert_ne!(one[1], one[2], "frames differ");
}
