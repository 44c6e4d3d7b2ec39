//! Lines on the faces of voxels: as wide as they should be where they should be, on opaque surfaces alone; the same films from every tracer.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::cuts::Cuts;
use voxtrace::denoise::{Features, denoise};
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::lines::{GridLines, Line, Lines};
use voxtrace::surroundings::Ground;
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Instance, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer, Transform,
    VoxelGrid,
};
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_vulkan::{Primitive, Traversal};

const RED: Vec3 = Vec3::X;
const GREEN: Vec3 = Vec3::Y;

fn edges(width: f32) -> Lines {
    Lines { edges: Some(Line { width, color: RED }), grid: None }
}

fn grid(width: f32, spacing: u32) -> Lines {
    Lines { edges: None, grid: Some(GridLines { line: Line { width, color: RED }, spacing }) }
}

/// A grid that is filled in these boxes, of one material, in a white sky.
fn filled(boxes: &[([i32; 3], [i32; 3])], material: Material) -> Scene {
    let mut voxels = VoxelGrid::new();
    for (min, max) in boxes {
        voxels.fill_box(VoxelBox { min: IVec3::from_array(*min), max: IVec3::from_array(*max) }, 0);
    }
    Scene { sky: Sky::uniform(Vec3::ONE), ..Scene::from_grid("voxels", voxels, vec![material]) }
}

fn packed(scene: &Scene) -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(scene).unwrap())
}

/// A square of the scene from straight above.
fn from_above(middle: [f32; 2], edge: f32, pixels: u32) -> Frame {
    let target = Vec3::new(middle[0], middle[1], 0.0);
    let camera = Camera { up: Vec3::Y, ..Camera::look_at(target.with_z(90.0), target) };
    Frame::new(camera.with_lens(Lens::Orthographic { view_height: edge }), pixels, pixels)
}

/// Share of red in the albedos of a picture whose surfaces are red or green.
fn share_of_red(scene: &Arc<PackedScene>, frame: &Frame) -> f64 {
    let film = render(scene, &frame.clone().aovs(true));
    let albedos: Vec<Vec3> = film.aovs.unwrap().iter().map(|aov| aov.albedo).collect();
    assert!(albedos.iter().all(|&albedo| albedo == RED || albedo == GREEN), "{:?}", albedos[0]);
    albedos.iter().filter(|&&albedo| albedo == RED).count() as f64 / albedos.len() as f64
}

/// Mean radiance of a film.
fn mean(film: &Film) -> Vec3 {
    film.pixels.iter().map(|pixel| pixel.mean()).sum::<Vec3>() / film.pixels.len() as f32
}

#[test]
fn a_grid_covers_the_share_of_a_plate_that_it_should() {
    // From −6 to 6, so that lines of every second and third plane end with it.
    let plate = packed(&filled(&[([-6, -6, 0], [6, 6, 1])], Material::diffuse(GREEN)));
    let frame = from_above([0.0; 2], 12.0, 96).samples(16);
    for (width, spacing) in [(0.2, 1), (0.5, 1), (1.0, 1), (0.2, 2), (1.5, 3)] {
        let expected = 1.0 - (1.0 - width / spacing as f32).powi(2);
        let light = mean(&render(&plate, &frame.clone().lines(grid(width, spacing))));
        // All light comes from the sky: a sample is red or green.
        assert!((light.x - expected).abs() < 0.003, "{width} {spacing}: {light}, {expected}");
        assert!((light.y - (1.0 - expected)).abs() < 0.003 && light.z == 0.0, "{width} {spacing}: {light}");
        let thinner = mean(&render(&plate, &frame.clone().lines(grid(width * 0.9, spacing))));
        assert!((thinner.x - expected).abs() > 0.005, "the comparison sees a line that is thinner by a tenth");
    }
    // Lines of every third plane are where that is a third of the grid's own coordinates, on both sides of 0.
    for middle in [-4.5, -3.0, -1.5, 0.0, 1.5, 3.0] {
        let share = share_of_red(&plate, &from_above([middle, 1.5], 0.1, 8).lines(grid(0.5, 3)));
        let is_line = middle % 3.0 == 0.0;
        assert_eq!(share, if is_line { 1.0 } else { 0.0 }, "{middle}");
    }
    assert!(mean(&render(&plate, &frame)).abs_diff_eq(GREEN, 1e-6), "nobody asked for any");
}

#[test]
fn edges_lie_where_a_flat_surface_ends() {
    let width = 0.5_f64;
    let share = |boxes: &[([i32; 3], [i32; 3])], middle: [f32; 2], edge: f32| {
        let scene = packed(&filled(boxes, Material::diffuse(GREEN)));
        share_of_red(&scene, &from_above(middle, edge, 160).lines(edges(width as f32)))
    };
    // The outline of a plate, whatever is below it.
    let plate = ([0, 0, 0], [5, 5, 1]);
    let outline = 1.0 - (1.0 - width / 5.0).powi(2);
    assert!((share(&[plate], [2.5; 2], 5.0) - outline).abs() < 1e-3);
    assert!((share(&[plate, ([0, 0, -3], [2, 5, 0])], [2.5; 2], 5.0) - outline).abs() < 1e-3);
    // Around a tower: its own outline, and half a line on the plate around it, corners with it.
    let around = (1.0 + width).powi(2) - 1.0;
    let within = 1.0 - (1.0 - width).powi(2);
    let with_tower = outline + (within + around) / 25.0;
    let found = share(&[plate, ([2, 2, 1], [3, 3, 3])], [2.5; 2], 5.0);
    assert!((found - with_tower).abs() < 1e-3, "{found} {with_tower}");
    // Around a hole likewise, whose floor ends at its walls.
    let walls = [([0, 0, 0], [5, 2, 1]), ([0, 3, 0], [5, 5, 1]), ([0, 2, 0], [2, 3, 1]), ([3, 2, 0], [5, 3, 1])];
    let floor = ([0, 0, -1], [5, 5, 0]);
    let found = share(&[&walls[..], &[floor]].concat(), [2.5; 2], 5.0);
    assert!((found - with_tower).abs() < 1e-3, "{found} {with_tower}");
    // The middle of a plate has none.
    assert_eq!(share(&[plate], [2.5; 2], 4.0), 0.0);
    assert!(share(&[plate, ([2, 2, 1], [3, 3, 3])], [2.5; 2], 4.0) > 0.0, "the comparison sees the tower");
}

#[test]
fn lines_go_with_an_instance() {
    let voxels = filled(&[([0, 0, 0], [4, 4, 1]), ([1, 0, 1], [2, 1, 2])], Material::diffuse(GREEN));
    let frame = |edge: f32| from_above([0.5 * edge; 2], edge, 120);
    // Of widths that end between the middles of pixels.
    let both = Lines { edges: edges(0.28).edges, ..grid(0.12, 3) };
    let picture = |scene: &Scene, frame: Frame| {
        let film = render(&packed(scene), &frame.aovs(true).lines(both));
        film.aovs.unwrap().into_iter().map(|aov| aov.albedo).collect::<Vec<_>>()
    };
    let plain = picture(&voxels, frame(4.0));
    // Twice as large and mirrored along x: the same picture, mirrored. Then turned by a right angle, and with the camera again as it was.
    let placed = |linear: Mat3, translation: Vec3| {
        let instance = Instance { world_from_grid: Transform { linear, translation }, ..voxels.instances[0].clone() };
        Scene { instances: vec![instance], ..voxels.clone() }
    };
    let mirrored = placed(Mat3::from_diagonal(Vec3::new(-2.0, 2.0, 2.0)), Vec3::new(8.0, 0.0, 0.0));
    let found = picture(&mirrored, frame(8.0));
    let differing = |expected: &dyn Fn(usize, usize) -> usize, found: &[Vec3]| {
        let differs = |at: &usize| found[*at] != plain[expected(at % 120, at / 120)];
        (0..plain.len()).filter(differs).count()
    };
    assert_eq!(differing(&|x, y| y * 120 + 119 - x, &found), 0);
    assert!(differing(&|x, y| y * 120 + x, &found) > 100, "the comparison sees whether it is mirrored");
    let turned = placed(Mat3::from_rotation_z(std::f32::consts::FRAC_PI_2), Vec3::new(4.0, 0.0, 0.0));
    let found = picture(&turned, frame(4.0));
    assert_eq!(differing(&|x, y| x * 120 + 119 - y, &found), 0);
    assert!(differing(&|x, y| y * 120 + x, &found) > 100);
}

#[test]
fn lamps_glass_clouds_cuts_and_the_ground_have_none() {
    let both = Lines { edges: edges(0.3).edges, ..grid(0.3, 1) };
    let frame = from_above([2.0; 2], 5.0, 24).samples(4);
    let is_same = |scene: &Arc<PackedScene>, frame: &Frame| {
        render(scene, &frame.clone().aovs(true)) == render(scene, &frame.clone().aovs(true).lines(both))
    };
    let plate = |material: Material| filled(&[([0, 0, 0], [4, 4, 1])], material);
    let cloud = Material::cloud(Vec3::splat(0.8), 0.3, 0.2);
    for material in [Material::emissive(Vec3::ONE), Material::glass(1.5, 0.0), Material::glass(1.5, 0.3), cloud] {
        assert!(is_same(&packed(&plate(material)), &frame), "{material:?}");
    }
    let opaque = [
        Material::diffuse(GREEN),
        Material::metal(GREEN, 0.0),
        Material::metal(GREEN, 0.3),
        Material::plastic(GREEN, 0.2),
    ];
    for material in opaque {
        assert!(!is_same(&packed(&plate(material)), &frame), "{material:?}: the comparison sees lines");
        // Where everything is line, it is matte, whatever was there: to the bit.
        let all = |material: Material| {
            let whole = frame.clone().aovs(true).lines(grid(1.0, 1));
            render(&packed(&plate(material)), &whole)
        };
        assert!(all(material) == all(opaque[0]), "{material:?}");
    }
    // What a plane lays open is no face of a voxel.
    let cut = |cuts: Cuts| {
        let mut scene = PackedScene::pack(&filled(&[([0, 0, 0], [4, 4, 4])], Material::diffuse(GREEN))).unwrap();
        scene.cuts = cuts;
        Arc::new(scene)
    };
    let within = from_above([2.0; 2], 3.9, 24).samples(4);
    assert!(is_same(&cut(Cuts::default().plane(Vec3::Z, 2.5).unwrap()), &within));
    assert!(!is_same(&cut(Cuts::default().plane(Vec3::Z, 9.5).unwrap()), &within));
    // Voxels of the ground are no scene's.
    let ground = Ground { height: None, color: GREEN };
    let on_ground = PackedScene::pack(&plate(Material::diffuse(GREEN))).unwrap().with_surroundings(Some(&ground), None);
    let on_ground = Arc::new(on_ground.unwrap());
    assert!(is_same(&on_ground, &from_above([9.0; 2], 5.0, 24).samples(4).max_bounces(1)));
    assert!(!is_same(&on_ground, &frame));
}

#[test]
fn shapes_below_water_have_the_edges_that_they_have_in_air() {
    // A floor with a step, below water and beside glass: both are as air to edges.
    let mut voxels = VoxelGrid::new();
    voxels.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(4, 4, 1) }, 0);
    voxels.fill_box(VoxelBox { min: IVec3::new(2, 0, 1), max: IVec3::new(4, 4, 2) }, 0);
    let mut below = voxels.clone();
    for place in 0..64 {
        let voxel = IVec3::new(place % 4, place / 4 % 4, 1 + place / 16);
        if voxels.get(voxel).is_none() {
            below.set(voxel, 1);
        }
    }
    // Water that does nothing to light.
    let water = Material::glass(1.0, 0.0);
    let scene = |voxels: VoxelGrid| {
        let materials = vec![Material::diffuse(GREEN), water];
        packed(&Scene { sky: Sky::uniform(Vec3::ONE), ..Scene::from_grid("floor", voxels, materials) })
    };
    let frame = from_above([2.0; 2], 4.0, 80).lines(edges(0.5));
    let [dry, wet] = [scene(voxels), scene(below)].map(|scene| share_of_red(&scene, &frame));
    // Two rectangles of four voxels by two.
    let expected = 1.0 - (1.0 - 0.5 / 4.0) * (1.0 - 0.5 / 2.0);
    assert!((dry - expected).abs() < 1e-3, "{dry} {expected}");
    assert_eq!(wet, dry);
}

#[test]
fn denoising_keeps_lines() {
    let sun = Sun { direction: Vec3::new(0.6, 0.0, 0.8), angular_radius: 0.2, irradiance: Vec3::splat(2.0) };
    let boxes = [([0, 0, 0], [12, 12, 1]), ([5, 5, 1], [7, 7, 5])];
    let scene = filled(&boxes, Material::diffuse(Vec3::splat(0.5)));
    let scene = packed(&Scene { sky: Sky::uniform(Vec3::splat(0.5)).with_sun(Some(sun)), ..scene });
    let lines = Lines { edges: None, grid: Some(GridLines { line: Line { width: 0.2, color: RED }, spacing: 1 }) };
    let frame = from_above([6.0; 2], 12.0, 120).lines(lines);
    let truth = render(&scene, &frame.clone().samples(1024));
    let noisy = render(&scene, &frame.clone().samples(8));
    let filtered = |frame: Frame| denoise(&noisy, &Features::of(&scene, &frame, &noisy));
    let denoised = filtered(frame.clone().samples(8));
    let error = |means: &dyn Fn(usize) -> Vec3| {
        let squares =
            (0..truth.pixels.len()).map(|at| f64::from((means(at) - truth.pixels[at].mean()).length_squared()));
        (squares.sum::<f64>() / truth.pixels.len() as f64).sqrt()
    };
    let before = error(&|at| noisy.pixels[at].mean());
    let after = error(&|at| denoised[at]);
    assert!(after < 0.7 * before, "{after} {before}");
    // A filter that does not know them smears them.
    let unknown = filtered(frame.clone().samples(8).lines(Lines::default()));
    let smeared = error(&|at| unknown[at]);
    assert!(smeared > 1.5 * after, "{smeared} {after}");
}

#[test]
fn bad_lines_are_refused() {
    let frame = from_above([0.0; 2], 1.0, 4);
    let is_refused = |lines: Lines| frame.clone().lines(lines).check().is_err();
    assert!(!is_refused(Lines::default()) && !is_refused(edges(1.0)) && !is_refused(grid(7.0, 7)));
    let bright = Line { width: 0.2, color: Vec3::new(0.0, 1.5, 0.0) };
    let wrong = [edges(0.0), edges(-1.0), edges(1.1), edges(f32::NAN), grid(2.5, 2), grid(0.5, 0), grid(0.5, 1 << 17)];
    for lines in wrong.into_iter().chain([Lines { edges: Some(bright), grid: None }]) {
        assert!(is_refused(lines), "{lines:?}");
    }
    let essay = frame.integrator(Integrator::Essay);
    assert!(essay.check().is_ok() && essay.lines(edges(0.2)).check().is_err());
}

/// Things of many materials, some of them turned and mirrored.
fn still_life(materials: Vec<Material>) -> Scene {
    let mut voxels = VoxelGrid::new();
    let count = materials.len() as i32;
    for place in 0..512 {
        let voxel = IVec3::new(place % 8, place / 8 % 8, place / 64);
        // Steps and holes, at coordinates of both signs.
        if (voxel.x * 5 + voxel.y * 3 + voxel.z * 7) % 11 < 6 && voxel.z < 6 - voxel.x / 2 {
            voxels.set(voxel - 3, ((voxel.x / 2 + voxel.y / 3 + voxel.z) % count) as u16);
        }
    }
    let sun = Sun::at(200.0, 50.0, 3.0);
    let scene = Scene { sky: Sky::study(1.0).with_sun(sun), ..Scene::from_grid("still life", voxels, materials) };
    let turned = Mat3::from_rotation_z(0.6) * Mat3::from_diagonal(Vec3::new(-1.3, 1.3, 1.3));
    let mut instances = scene.instances.clone();
    let transform = Transform { linear: turned, translation: Vec3::new(9.0, 2.0, 0.5) };
    instances.push(Instance { world_from_grid: transform, ..scene.instances[0].clone() });
    Scene { instances, ..scene }
}

#[test]
fn every_tracer_makes_the_same_films() {
    let matte = vec![Material::diffuse(Vec3::splat(0.6)), Material::diffuse(Vec3::new(0.7, 0.4, 0.2))];
    let cloud = Material::cloud(Vec3::splat(0.8), 0.3, 0.2);
    let more = [
        Material::metal(Vec3::ONE, 0.1),
        Material::metal(Vec3::ONE, 0.0),
        Material::glass(1.5, 0.0),
        cloud,
        Material::emissive(Vec3::splat(3.0)),
        Material::plastic(Vec3::splat(0.6), 0.2),
    ];
    let all = PackedScene::pack(&still_life([matte.clone(), more.to_vec()].concat())).unwrap();
    let ground = Ground { height: None, color: Vec3::splat(0.3) };
    let mut all = all.with_surroundings(Some(&ground), None).unwrap();
    all.cuts = Cuts::default().plane(Vec3::new(0.2, -0.1, 1.0), 1.3).unwrap();
    // One grid that stands where it is, all of it matte; and everything.
    let single = Scene { instances: still_life(matte.clone()).instances[..1].to_vec(), ..still_life(matte) };
    let scenes = [packed(&single), Arc::new(all)];
    let camera = Camera { fov_y: 50.0, ..Camera::look_at(Vec3::new(-6.0, -14.0, 11.0), Vec3::new(4.0, 1.0, 0.0)) };
    let frame = Frame::new(camera, 32, 24).samples(2).max_bounces(4).aovs(true);
    let green = Line { width: 0.3, color: GREEN };
    let without = frame.clone();
    let frames = [
        frame.clone().lines(Lines { edges: Some(green), grid: None }),
        frame.clone().lines(Lines { edges: Some(green), ..grid(0.1, 1) }),
        frame.lines(grid(0.4, 3)),
    ];
    let mut cpu = CpuTracer::new(None);
    let expected = scenes.each_ref().map(|scene| {
        cpu.set_scene(scene).unwrap();
        let films = frames.each_ref().map(|frame| film(&mut cpu, frame));
        let mut last = film(&mut cpu, &without);
        for film in &films {
            assert!(film.pixels != std::mem::replace(&mut last, film.clone()).pixels, "the comparison sees the lines");
        }
        films
    });
    let Some(device) = device() else { return };
    let few = [Traversal::Walk, Traversal::Query, Traversal::Pipeline].map(|traversal| (traversal, Primitive::Brick));
    for_each_tracer(&device, &film_methods(&device, &few), &scenes[0], |tracer, traversal, primitive| {
        for (scene, films) in scenes.iter().zip(&expected) {
            tracer.set_scene(scene).unwrap();
            for (frame, expected) in frames.iter().zip(films) {
                let name = &scene.name;
                assert!(film(tracer, frame) == *expected, "{traversal:?} {primitive:?} {name}: {:?}", frame.lines);
            }
        }
    });
    assert_valid(&device);
}
