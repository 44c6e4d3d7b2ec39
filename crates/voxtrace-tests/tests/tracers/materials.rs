//! Materials and media: the same films from every tracer, energy, closed forms and published values.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer, Transform, VoxelGrid,
};
use voxtrace_tests::estimate::{check_equal, check_same, radiance};
use voxtrace_tests::gpu::{Method, ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::rooms;

fn block(size: IVec3, material_of: impl Fn(IVec3) -> u16) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for z in 0..size.z {
        for y in 0..size.y {
            (0..size.x).for_each(|x| _ = grid.set(IVec3::new(x, y, z), material_of(IVec3::new(x, y, z))));
        }
    }
    grid
}

fn ball(radius: i32) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    let size = 2 * radius;
    for index in 0..size * size * size {
        let voxel = IVec3::new(index % size, index / size % size, index / size / size) - radius;
        if (voxel.as_vec3() + 0.5).length() < radius as f32 {
            grid.set(voxel, 0);
        }
    }
    grid
}

/// One grid under a sky, seen from a corner.
fn under(sky: Sky, grid: VoxelGrid, materials: Vec<Material>) -> Scene {
    let mut scene = Scene { sky, ..Scene::from_grid("one", grid, materials) };
    scene.cameras.push(Camera::look_at(Vec3::new(14.0, 17.0, 9.0), Vec3::ZERO));
    scene
}

/// All materials, in one scene: a floor, things on it and in each other, a lamp, and a sun.
fn still_life(turns: bool) -> Scene {
    let materials = vec![
        Material::diffuse(Vec3::new(0.6, 0.5, 0.4)),
        Material::metal(Vec3::new(0.9, 0.7, 0.3), 0.4),
        Material::metal(Vec3::new(0.9, 0.9, 0.95), 0.0),
        Material::plastic(Vec3::new(0.8, 0.1, 0.1), 0.0),
        Material::plastic(Vec3::new(0.1, 0.2, 0.8), 0.5),
        Material::glass(1.5, 0.0).tinted(Vec3::new(0.4, 0.9, 0.6), 4.0),
        Material::glass(1.33, 0.3),
        Material::glass(1.31, 0.0),
        Material::cloud(Vec3::new(0.95, 0.9, 0.8), 0.4, 0.6),
        Material { transmission: 0.5, metallic: 0.3, ..Material::plastic(Vec3::new(0.3, 0.8, 0.3), 0.3) },
        Material::emissive(Vec3::new(9.0, 8.0, 6.0)),
    ];
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-12, -12, -1], [12, 12, 0], 0);
    fill([-10, 4, 0], [-6, 8, 5], 1);
    fill([-4, 6, 0], [0, 9, 6], 2);
    fill([2, 5, 0], [5, 8, 4], 3);
    fill([7, 3, 0], [10, 6, 4], 4);
    // Ice, and a lamp, in water.
    fill([-9, -8, 0], [-1, 0, 5], 6);
    fill([-7, -6, 1], [-4, -3, 4], 7);
    fill([-3, -2, 1], [-2, -1, 2], 10);
    fill([1, -8, 0], [5, -3, 5], 5);
    fill([6, -9, 1], [11, -2, 6], 8);
    fill([-11, 0, 0], [-9, 2, 3], 9);
    fill([4, 0, 6], [5, 1, 7], 10);
    let sun =
        Sun { direction: Vec3::new(0.4, -0.3, 0.8).normalize(), angular_radius: 0.05, irradiance: Vec3::splat(2.0) };
    let sky = Sky::gradient(Vec3::new(0.2, 0.15, 0.1), Vec3::new(0.4, 0.6, 0.9)).with_sun(sun);
    let mut scene = Scene { sky, ..Scene::from_grid("still life", grid, materials) };
    if turns {
        // Overlapping, adjoining and turned things: a lump of glass through the water, one beside it, a cloud around a corner of the metal.
        let lump = block(IVec3::new(4, 4, 3), |_| 5);
        scene.add_instance(lump.clone(), Transform::from_translation(Vec3::new(-2.0, -6.0, 1.0)));
        scene.add_instance(block(IVec3::new(2, 3, 3), |_| 7), Transform::from_translation(Vec3::new(-11.0, -6.0, 0.0)));
        let turned = Transform { linear: Mat3::from_rotation_z(0.6) * 0.8, translation: Vec3::new(-3.0, 2.0, 0.1) };
        scene.add_instance(lump, turned);
        scene.add_instance(block(IVec3::splat(4), |_| 8), Transform::from_translation(Vec3::new(-8.0, 6.0, 3.0)));
    }
    scene
}

/// From above, from within the glass, and from within the cloud.
fn frames() -> Vec<Frame> {
    let views = [
        (Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0)),
        (Vec3::new(3.1, -5.2, 2.3), Vec3::new(-3.0, 4.0, 1.0)),
        (Vec3::new(8.3, -5.4, 3.2), Vec3::new(0.0, 0.0, 2.0)),
    ];
    let frame = |(eye, target): (Vec3, Vec3)| Frame::new(Camera::look_at(eye, target), 32, 24).samples(2).aovs(true);
    let path = views.map(|view| frame(view).integrator(Integrator::Path).max_bounces(6));
    path.into_iter().chain([frame(views[0]).integrator(Integrator::Essay)]).collect()
}

/// Compares the films of the still life by some methods, of a software device by the `few`, with those of the processor.
fn compare_films(turns: bool, few: &[Method]) {
    let packed = Arc::new(PackedScene::pack(&still_life(turns)).unwrap());
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&packed).unwrap();
    let expected: Vec<Film> = frames().iter().map(|frame| film(&mut cpu, frame)).collect();
    assert!(expected.iter().all(|film| film.pixels.iter().any(|pixel| pixel.radiance[0] > 0)));
    let Some(device) = device() else { return };
    for_each_tracer(&device, &film_methods(&device, few), &packed, |tracer, traversal, primitive| {
        for (index, (frame, expected)) in frames().iter().zip(&expected).enumerate() {
            let found = film(tracer, frame);
            let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "pixels of view {index} by {traversal:?} {primitive:?}, turned things: {turns}");
            assert!(found.aovs == expected.aovs, "AOVs of view {index} by {traversal:?}, turned things: {turns}");
        }
    });
    assert_valid(&device);
}

// Software compiles each of these for half a minute: all of them for many grids, the quickest for one.
#[test]
fn every_tracer_makes_the_same_film_of_all_materials() {
    compare_films(true, &ONE_OF_EACH);
}

#[test]
fn every_tracer_makes_the_same_film_of_all_materials_in_one_grid() {
    compare_films(false, &ONE_OF_EACH[..1]);
}

/// The mean radiance of a picture of a ball in a white sky, `bounces` at most.
fn furnace(material: Material, bounces: u32) -> Vec<voxtrace_tests::estimate::Estimate> {
    let scene = under(Sky::uniform(Vec3::ONE), ball(5), vec![material]);
    let frame = rooms::frame(&scene, (12, 12), 48, Integrator::Path).max_bounces(bounces);
    radiance(&scene, &frame, 1)
}

#[test]
fn clear_glass_mirrors_and_white_clouds_are_invisible_in_a_white_sky() {
    for material in [
        Material::glass(1.5, 0.0),
        Material::glass(2.4, 0.0),
        Material::glass(1.0, 0.0),
        Material::metal(Vec3::ONE, 0.0),
        Material::cloud(Vec3::ONE, 0.3, 0.0),
        Material::cloud(Vec3::ONE, 0.8, 0.7),
    ] {
        check_equal(&furnace(material, 400), 1.0).unwrap_or_else(|error| panic!("{material:?}: {error}"));
        let grey = Material { base_color: Vec3::splat(0.97), ..material };
        let absorbing = grey.tinted(Vec3::splat(0.99), 1.0);
        check_equal(&furnace(absorbing, 400), 1.0).unwrap_err();
    }
}

#[test]
fn no_material_sends_back_more_light_than_it_gets() {
    for roughness in [0.0, 0.15, 0.4, 0.7, 1.0] {
        for material in [
            Material::metal(Vec3::ONE, roughness),
            Material::plastic(Vec3::ONE, roughness),
            Material::glass(1.5, roughness),
            Material { metallic: 0.5, transmission: 0.5, ..Material::plastic(Vec3::ONE, roughness) },
        ] {
            let mean = furnace(material, 100);
            assert!(
                mean.iter().all(|mean| mean.mean < 1.0 + 4.5 * mean.standard_error + 1e-5),
                "{material:?}: {mean:?}"
            );
            assert!(mean.iter().all(|mean| mean.mean > 0.5), "{material:?}: {mean:?}");
        }
    }
    let glowing = Material { emission: Vec3::splat(0.02), ..Material::plastic(Vec3::ONE, 0.4) };
    let (most, glowing) = (furnace(Material::diffuse(Vec3::ONE), 100), furnace(glowing, 100));
    check_same(&most, &glowing, 0.02).unwrap_err();
}

/// A slab of `thickness` voxels, wide enough to be without end, `gap` voxels above a ground, looked at from straight above.
fn slab(thickness: i32, material: Material, (gap, ground): (i32, Material), sky: Sky) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    let half = 150;
    let layer = |bottom, top| VoxelBox { min: IVec3::new(-half, -half, bottom), max: IVec3::new(half, half, top) };
    grid.fill_box(layer(-thickness, 0), 0);
    grid.fill_box(layer(-thickness - gap - 1, -thickness - gap), 1);
    let scene = Scene { sky, ..Scene::from_grid("slab", grid, vec![material, ground]) };
    let camera = Camera::look_at(Vec3::new(0.2, 0.3, 10.0), Vec3::new(0.2, 0.3, 0.0));
    let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
    (scene, Frame::new(camera, 8, 8).integrator(Integrator::Path).samples(64).max_bounces(300))
}

#[test]
fn absorption_follows_beer_and_the_surface_of_glass_follows_fresnel() {
    let white = Material { emission: Vec3::ONE, ..Material::diffuse(Vec3::ZERO) };
    for (thickness, ior, gap) in [(1, 1.0, 3), (7, 1.0, 3), (7, 1.5, 3), (20, 1.33, 3), (7, 1.5, 0)] {
        let material = Material { absorption: Vec3::splat(0.05), ..Material::glass(ior, 0.0) };
        let (scene, frame) = slab(thickness, material, (gap, white), Sky::black());
        let beer = (-0.05 * f64::from(thickness)).exp();
        // Of what enters through a plate, a part goes to and fro between its surfaces.
        let surface = ((f64::from(ior) - 1.0) / (f64::from(ior) + 1.0)).powi(2);
        // Ground that touches the plate leaves one.
        let expected = match gap {
            0 => beer * (1.0 - surface),
            _ => beer * (1.0 - surface).powi(2) / (1.0 - (surface * beer).powi(2)),
        };
        // Rays begin a thousandth of a voxel behind the face that they entered.
        close(&radiance(&scene, &frame, 1), expected, 0.002).unwrap();
        close(&radiance(&scene, &frame, 1), expected * 1.02, 0.002).unwrap_err();
    }
}

#[test]
fn a_scattering_slab_reflects_and_transmits_what_is_published() {
    // Albedo 0.9, g = 0.75, two mean free paths, light at right angles: diffuse reflectance 0.09739 and total transmittance 0.66096 (van de
    // Hulst, "Multiple Light Scattering", 1980; table 1 of Wang, Jacques and Zheng, 1995). A path from the camera goes the way of light backwards.
    let cloud = Material::cloud(Vec3::splat(0.9), 0.25, 0.75);
    let black = Material::diffuse(Vec3::ZERO);
    let (scene, frame) = slab(8, cloud, (0, black), Sky::uniform(Vec3::ONE));
    let reflected = radiance(&scene, &frame.clone().samples(512), 1);
    close(&reflected, 0.09739, 0.01).unwrap();
    close(&reflected, 0.09739 * 1.04, 0.01).unwrap_err();
    let glowing = Material { emission: Vec3::ONE, ..black };
    let (scene, frame) = slab(8, cloud, (0, glowing), Sky::black());
    let transmitted = radiance(&scene, &frame, 1);
    close(&transmitted, 0.66096, 0.01).unwrap();
    close(&transmitted, 0.66096 * 1.03, 0.01).unwrap_err();
}

/// Whether estimates are within a relative error of a value, with noise that is smaller.
fn close(estimates: &[voxtrace_tests::estimate::Estimate], expected: f64, relative: f64) -> Result<(), String> {
    let is_close = |mean: f64, error: f64| (mean / expected - 1.0).abs() + 3.0 * error / expected < 2.0 * relative;
    match estimates.iter().all(|estimate| is_close(estimate.mean, estimate.standard_error)) {
        true => Ok(()),
        false => Err(format!("{estimates:?} and not {expected}")),
    }
}

#[test]
fn nothing_is_between_voxels_of_one_index_and_between_things_that_adjoin() {
    let sky = Sky::gradient(Vec3::new(0.1, 0.3, 0.2), Vec3::new(0.9, 0.7, 0.8));
    let frame = |scene: &Scene| rooms::frame(scene, (16, 16), 64, Integrator::Path).max_bounces(40);
    let glass = Material::glass(1.5, 0.0);
    let size = IVec3::new(8, 8, 6);
    let whole = under(sky.clone(), block(size, |_| 0), vec![glass]);
    let expected = radiance(&whole, &frame(&whole), 2);
    let halves = |other: Material| under(sky.clone(), block(size, |voxel| (voxel.x / 4) as u16), vec![glass, other]);
    // Two materials of one index, and two instances side by side.
    let alike = halves(Material { absorption: Vec3::splat(1e-9), ..glass });
    check_same(&expected, &radiance(&alike, &frame(&alike), 2), 0.03).unwrap();
    let mut apart = under(sky.clone(), block(IVec3::new(4, 8, 6), |_| 0), vec![glass]);
    apart.add_instance(block(IVec3::new(4, 8, 6), |_| 0), Transform::from_translation(Vec3::new(4.0, 0.0, 0.0)));
    check_same(&expected, &radiance(&apart, &frame(&apart), 2), 0.03).unwrap();
    // Instances that overlap: the lower one counts, which is the same glass.
    let mut over = under(sky.clone(), block(IVec3::new(6, 8, 6), |_| 0), vec![glass]);
    over.add_instance(block(IVec3::new(6, 8, 6), |_| 0), Transform::from_translation(Vec3::new(2.0, 0.0, 0.0)));
    check_same(&expected, &radiance(&over, &frame(&over), 2), 0.03).unwrap();
    // A gap, and another index, are seen.
    let mut gap = under(sky.clone(), block(IVec3::new(4, 8, 6), |_| 0), vec![glass]);
    gap.add_instance(block(IVec3::new(4, 8, 6), |_| 0), Transform::from_translation(Vec3::new(4.2, 0.0, 0.0)));
    check_same(&expected, &radiance(&gap, &frame(&gap), 2), 0.03).unwrap_err();
    let other = halves(Material::glass(1.2, 0.0));
    check_same(&expected, &radiance(&other, &frame(&other), 2), 0.03).unwrap_err();
}

#[test]
fn a_lamp_in_a_cloud_is_the_same_whether_lights_are_chosen_or_met() {
    // Essay knows no media: a lamp that is only met by chance is the reference, which one that lights cannot be chosen for is.
    let mut scene = under(
        Sky::black(),
        block(IVec3::splat(9), |_| 0),
        vec![Material::cloud(Vec3::splat(0.9), 0.3, 0.4), Material::emissive(Vec3::splat(5.0))],
    );
    scene.grids = vec![Arc::new({
        let mut grid = block(IVec3::splat(9), |_| 0);
        grid.fill_box(VoxelBox { min: IVec3::splat(3), max: IVec3::splat(5) }, 1);
        grid
    })];
    let frame = rooms::frame(&scene, (12, 12), 96, Integrator::Path).max_bounces(60);
    let chosen = radiance(&scene, &frame, 1);
    // Closed in by glass of nearly the same index, which shadow rays do not pass.
    let mut met = scene.clone();
    met.materials.push(Material { ior: 1.000_001, ..Material::glass(1.0, 0.0) });
    met.grids = vec![Arc::new({
        let mut grid = block(IVec3::splat(9), |_| 0);
        grid.fill_box(VoxelBox { min: IVec3::splat(2), max: IVec3::splat(6) }, 2);
        grid.fill_box(VoxelBox { min: IVec3::splat(3), max: IVec3::splat(5) }, 1);
        grid
    })];
    let mut same = scene.clone();
    same.materials.push(Material::glass(1.0, 0.0));
    same.grids = vec![Arc::clone(&met.grids[0])];
    let met = radiance(&met, &frame.clone().samples(512), 1);
    let same = radiance(&same, &frame, 1);
    check_same(&same, &met, 0.05).unwrap();
    check_same(&chosen, &met, 0.05).unwrap_err();
}

#[test]
fn plates_that_are_not_seen_take_nothing_of_a_lamps_light() {
    // Each boundary moves a ray off its face; it must still end before the lamp.
    let room = |plate: Option<Material>| {
        let mut grid = VoxelGrid::new();
        let mut fill = |min: [i32; 3], max: [i32; 3], material| {
            grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
        };
        fill([-9, -9, -1], [9, 9, 0], 0);
        fill([-2, -2, 9], [2, 2, 10], 1);
        if plate.is_some() {
            fill([-9, -9, 3], [9, 9, 4], 2);
            fill([-9, -9, 6], [9, 9, 7], 2);
            fill([-9, -9, 8], [9, 9, 9], 2);
        }
        let mut materials = vec![Material::diffuse(Vec3::splat(0.5)), Material::emissive(Vec3::splat(4.0))];
        materials.extend(plate);
        let scene = Scene { sky: Sky::black(), ..Scene::from_grid("room", grid, materials) };
        let camera = Camera::look_at(Vec3::new(0.3, -1.0, 2.5), Vec3::new(0.3, 0.2, 0.0));
        let frame = Frame::new(camera, 8, 8).samples(64).max_bounces(2);
        radiance(&scene, &frame, 1)
    };
    let (clear, bare) = (Material::glass(1.0, 0.0), room(None));
    check_same(&bare, &room(Some(clear)), 0.01).unwrap();
    check_same(&bare, &room(Some(clear.tinted(Vec3::splat(0.95), 1.0))), 0.01).unwrap_err();
}
