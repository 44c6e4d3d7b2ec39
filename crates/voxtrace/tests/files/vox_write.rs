//! Scenes written as MagicaVoxel files say what the scene says, as far as the format goes, and refuse what it cannot say.

use crate::vox_samples;
use crate::vox_samples::{scene, small_grid};
use std::{collections::BTreeMap, path::Path};
use voxtrace::camera::Lens;
use voxtrace::{
    Camera, Instance, Material, Scene, Sky, Sun, Transform, VoxelGrid,
    camera::Perspective,
    export::{self, ExportError},
    glam::{IVec3, Mat3, Quat, Vec3},
    import::{ImportErrorKind, ImportOptions, Limits, vox},
    material::linear_color,
    scene::Keyframe,
};

fn bytes_of(scene: &Scene) -> Vec<u8> {
    export::vox::document_of(scene).unwrap().to_bytes().unwrap()
}

/// The scene after writing and reading, without the document that it came from.
fn again(scene: &Scene) -> Scene {
    let scene = vox::read_bytes(&bytes_of(scene), Path::new(&scene.name), &Limits::default()).unwrap();
    Scene { attachments: Vec::new(), ..scene }
}

fn cell(transform: &Transform, voxel: IVec3) -> [i32; 3] {
    transform.point(voxel.as_vec3() + 0.5).floor().as_ivec3().to_array()
}

/// Every placed voxel and the colour it shows.
fn placed(scene: &Scene) -> BTreeMap<[i32; 3], [u32; 3]> {
    let mut cells = BTreeMap::new();
    for instance in &scene.instances {
        for (voxel, material) in scene.grids[instance.grid].voxels() {
            let color = scene.materials[usize::from(material)].base_color.to_array().map(f32::to_bits);
            cells.insert(cell(&instance.world_from_grid, voxel), color);
        }
    }
    cells
}

/// The 48 quarter turns and mirrors.
fn quarter_turns() -> Vec<Mat3> {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let signs = |bits: i32| [0, 1, 2].map(|axis| if bits >> axis & 1 == 0 { 1.0 } else { -1.0 });
    let turn = |order: [usize; 3], [x, y, z]: [f32; 3]| {
        Mat3::from_cols(axes[order[0]] * x, axes[order[1]] * y, axes[order[2]] * z)
    };
    orders.into_iter().flat_map(|order| (0..8).map(move |bits| turn(order, signs(bits)))).collect()
}

#[test]
fn a_sample_scene_comes_back_as_it_was() {
    let (before, mut after) = (scene(), again(&scene()));
    assert_eq!(after.materials.len(), 255);
    after.materials.truncate(before.materials.len());
    assert_eq!(after.materials, before.materials);
    assert_eq!(after, before);
}

#[test]
fn a_difference_in_any_part_of_a_scene_shows_after_writing_and_reading() {
    // The comparison above would catch each of these.
    let faults: [fn(&mut Scene); 9] = [
        |scene| scene.materials[0].base_color = linear_color([254, 0, 0]),
        |scene| scene.materials[1].emission *= 1.001,
        |scene| scene.instances[0].world_from_grid.translation.x += 1.0,
        |scene| scene.instances[1].hidden = false,
        |scene| scene.instances[2].keyframes[1].frame += 1,
        |scene| scene.layers[1].hidden = false,
        |scene| scene.cameras[0].fov_y = 61.0,
        |scene| scene.cameras[1].eye.z += 0.01,
        |scene| scene.sky.set_brightness(1.01),
    ];
    for (number, fault) in faults.into_iter().enumerate() {
        let mut changed = scene();
        fault(&mut changed);
        assert_ne!(again(&changed), again(&scene()), "fault {number}");
    }
}

#[test]
fn all_48_turns_of_odd_and_even_sizes_come_back_exactly() {
    for size in [IVec3::new(3, 5, 7), IVec3::new(4, 1, 6), IVec3::ONE] {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 1);
        grid.set(size - 1, 2);
        let mut before = Scene::from_grid("turns", grid, vec![Material::default(); 255]);
        before.materials.iter_mut().for_each(|material| *material = Material::diffuse(Vec3::ONE));
        before.instances.clear();
        for (number, linear) in quarter_turns().into_iter().enumerate() {
            let translation = Vec3::new(number as f32 * 10.0, -7.0, 3.0);
            before.instances.push(Instance::new(0, Transform { linear, translation }));
        }
        let after = again(&before);
        assert_eq!(after, before);
        assert_eq!(placed(&after).len(), placed(&before).len());
    }
    assert_eq!(quarter_turns().len(), 48);
}

#[test]
fn a_grid_larger_than_a_model_becomes_many_that_stand_together() {
    let mut grid = VoxelGrid::new();
    let mut state = 1u32;
    for _ in 0..5_000 {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let voxel =
            IVec3::new((state >> 8) as i32 % 700 - 300, (state >> 16) as i32 % 90 - 13, (state >> 20) as i32 % 300);
        grid.set(voxel, (state >> 28) as u16);
    }
    let materials = (0..16).map(|i| Material::diffuse(linear_color([i * 16, 255 - i, 7]))).collect();
    let mut before = Scene::from_grid("large", grid, materials);
    let linear = Mat3::from_cols(Vec3::NEG_Y, Vec3::Z, Vec3::X);
    before.instances[0].world_from_grid = Transform { linear, translation: Vec3::new(5.0, 6.0, -7.0) };
    before.instances[0].name = "large".into();
    let after = again(&before);
    assert!(after.grids.len() >= 6, "{} models", after.grids.len());
    assert!(after.grids.iter().all(|grid| grid.bounds().unwrap().max.cmple(IVec3::splat(256)).all()));
    assert!(after.instances.iter().all(|instance| instance.name == "large"));
    assert_eq!(placed(&after), placed(&before));
}

#[test]
fn an_animation_between_a_large_and_a_small_grid_shows_each_in_its_frame() {
    let mut large = VoxelGrid::new();
    large.set(IVec3::ZERO, 0);
    large.set(IVec3::new(600, 0, 0), 0);
    let mut before = Scene::from_grid("frames", large, vec![Material::default()]);
    before.add_instance(small_grid(1), Transform::IDENTITY);
    before.materials.resize(5, Material::default());
    before.instances.truncate(1);
    let key = |frame, grid| Keyframe::still(frame, grid, Transform::from_translation(Vec3::splat(frame as f32)));
    before.instances[0].keyframes = vec![key(0, 0), key(1, 1)];
    let after = again(&before);
    for (frame, key) in before.instances[0].keyframes.iter().enumerate() {
        let mut cells: Vec<_> =
            before.grids[key.grid].voxels().map(|(voxel, _)| cell(&key.world_from_grid, voxel)).collect();
        let mut found: Vec<_> = after
            .instances
            .iter()
            .map(|instance| &instance.keyframes[frame])
            .flat_map(|key| after.grids[key.grid].voxels().map(|(voxel, _)| cell(&key.world_from_grid, voxel)))
            .collect();
        cells.sort_unstable();
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, cells, "frame {frame}");
    }
}

#[test]
fn more_than_255_materials_become_the_255_that_look_nearest() {
    let mut grid = VoxelGrid::new();
    let mut materials = Vec::new();
    for i in 0..4_000 {
        // As in a scan: many shades of few colours, in a box of 40 × 25 × 20 steps of sRGB.
        let [r, g, b] = [(100 + i % 40) as u8, (80 + i / 40 % 25) as u8, (60 + i / 1_000 * 5) as u8];
        materials.push(Material::diffuse(linear_color([r, g, b])));
        grid.set(IVec3::new(i % 64, i / 64, 0), i as u16);
    }
    materials[17] = Material { emission: materials[17].base_color * 50.0, ..materials[17] };
    materials[18] = Material { metallic: 1.0, roughness: 0.2, ..materials[18] };
    let before = Scene::from_grid("colors", grid, materials);
    let after = again(&before);
    assert_eq!(bytes_of(&before), bytes_of(&before), "the same every time");
    let mut error = 0.0;
    for (voxel, material) in before.grids[0].voxels() {
        let (was, is) = (&before.materials[usize::from(material)], after.grids[0].get(voxel).unwrap());
        let is = &after.materials[usize::from(is)];
        assert_eq!(is.is_emissive(), was.is_emissive(), "material {material}");
        assert_eq!(is.metallic, was.metallic, "material {material}");
        let perceived = |color: Vec3| color.powf(1.0 / 2.2);
        error += f64::from((perceived(was.base_color) - perceived(is.base_color)).length());
    }
    let mean_error = error / 4_000.0;
    // 255 cells of that box have an edge of 4.3 steps; the mean distance from the middle of such a cell is 0.48 of it. The
    // cells are cut for the eye in Oklab and measured here in another space: half as much again.
    assert!(mean_error < 0.48 * 4.3 / 255.0 * 1.5, "mean error {mean_error}");
    assert!(mean_error > 0.0, "4,000 colours cannot all be kept");
    assert_eq!(after.materials.iter().filter(|material| material.is_emissive()).count(), 1);
    let lamp = after.materials.iter().find(|material| material.is_emissive()).unwrap();
    assert_eq!(lamp.emission, before.materials[17].emission);
}

#[test]
fn an_instance_that_the_format_cannot_place_is_refused() {
    for world_from_grid in [
        Transform { linear: Mat3::from_quat(Quat::from_rotation_z(0.1)), translation: Vec3::ZERO },
        Transform { linear: Mat3::IDENTITY * 2.0, translation: Vec3::ZERO },
        Transform::from_translation(Vec3::new(0.5, 0.0, 0.0)),
        Transform::from_translation(Vec3::new(0.0, 1e9, 0.0)),
        Transform::from_translation(Vec3::splat(f32::NAN)),
    ] {
        let mut scene = scene();
        scene.instances[1].name = "leaning".into();
        scene.instances[1].world_from_grid = world_from_grid;
        let error = export::vox::document_of(&scene).unwrap_err();
        assert!(matches!(&error, ExportError::Placement { instance: 1, name, .. } if name == "leaning"), "{error}");
        assert!(error.to_string().contains("leaning"));
    }
}

#[test]
fn emission_is_color_times_emit_times_ten_to_the_flux() {
    let (_, graph) = vox_samples::samples().into_iter().find(|(name, _)| *name == "graph.vox").unwrap();
    let scene = vox::read_bytes(&graph, Path::new("graph"), &Limits::default()).unwrap();
    // Index 9 of the default palette is (255, 204, 153); the sample gives it _emit 0.42 and _flux 3.
    let expected = linear_color([255, 204, 153]) * 420.0;
    assert!((scene.materials[8].emission - expected).length() < 1e-3, "{}", scene.materials[8].emission);
    assert_eq!(scene.materials[9].transmission, 0.5);
    assert_eq!(scene.materials[9].ior, 1.3);
    assert_eq!(scene.materials[10].metallic, 0.7);
}

#[test]
fn a_lamp_that_reflects_nothing_keeps_its_light() {
    for light in [Vec3::new(12.0, 9.5, 3.0), Vec3::new(0.001, 0.002, 0.0), Vec3::splat(30_000.0)] {
        let mut before = Scene::from_grid("lamp", small_grid(1), vec![Material::emissive(light); 5]);
        before.light_intensity = 2.0;
        let emission = again(&before).materials[0].emission;
        let error = (emission - light * 2.0).abs().max_element() / (light * 2.0).max_element();
        assert!(error < 0.005, "{emission} for {light}");
    }
}

#[test]
fn cameras_look_where_they_looked() {
    let mut before = scene();
    before.cameras.clear();
    for (number, up) in [Vec3::Z, Vec3::new(0.3, 0.1, 1.0), Vec3::NEG_Z, Vec3::X].into_iter().enumerate() {
        for eye in [Vec3::new(31.7, -12.25, 9.1), Vec3::new(-3.3, 40.0, -88.8), Vec3::new(0.1, 0.2, 99.0)] {
            let target = Vec3::new(0.1, 0.2, 5.3);
            before.cameras.push(Camera {
                name: format!("camera {number}"),
                eye,
                target,
                up,
                fov_y: 37.5,
                lens: Lens::Pinhole,
            });
        }
    }
    let after = again(&before);
    for (was, is) in before.cameras.iter().zip(&after.cameras) {
        let [a, b] = [was, is].map(|camera| Perspective::new(camera, 300, 200));
        assert!((a.eye - b.eye).length() < 1e-4, "{was:?} {is:?}");
        // Straight down, the top of the picture is where `up` points; with an upright camera it is nowhere.
        let vertical = (was.target - was.eye).truncate().length() < 1e-6;
        if !(vertical && was.up.truncate().length() == 0.0) {
            assert!((a.corner - b.corner).length() < 1e-4, "{was:?} {is:?}");
            assert!((a.pixel_x - b.pixel_x).length() < 1e-6, "{was:?} {is:?}");
        }
        assert_eq!((&was.name, was.fov_y), (&is.name, is.fov_y));
    }
    assert_eq!(again(&after).cameras, after.cameras, "the second time to the bit");
}

#[test]
fn sun_and_sky_keep_their_light() {
    let mut before = scene();
    let irradiance = Vec3::new(3.0, 2.5, 1.0);
    for direction in [Vec3::new(0.3, -0.2, 0.8).normalize(), Vec3::Z, Vec3::NEG_X] {
        let sun = Sun { direction, angular_radius: 0.1, irradiance };
        before.sky =
            Sky::gradient(Vec3::new(0.1, 0.2, 0.4), Vec3::new(0.3, 0.2, 0.4)).with_brightness(2.0).with_sun(sun);
        let after = again(&before);
        let sun = after.sky.sun().unwrap();
        assert!((sun.direction - direction).length() < 1e-5, "{}", sun.direction);
        assert!((sun.irradiance - irradiance * 2.0).abs().max_element() < 0.03, "{}", sun.irradiance);
        assert_eq!(sun.angular_radius, 0.1);
        assert!((after.sky.radiance(Vec3::Z) - Vec3::new(0.4, 0.4, 0.8)).length() < 0.01);
        assert!(after.sky.is_sun_disc_visible());
        before.sky.set_sun_disc_visible(false);
        assert_eq!(again(&before).sky, after.sky.clone().with_sun_disc_visible(false));
        assert_eq!(again(&after).sky, after.sky);
    }
    before.sky = Sky::default();
    assert_eq!(again(&before).sky, Sky::default());
}

#[test]
fn a_file_is_opened_by_its_first_bytes_or_its_extension() {
    let folder = tempfile::tempdir().unwrap();
    let [named, nameless, other, lying] = ["a.vox", "scene", "a.off", "b.VOX"].map(|name| folder.path().join(name));
    export::vox::write(&named, &scene()).unwrap();
    std::fs::copy(&named, &nameless).unwrap();
    std::fs::write(&other, "v 0 0 0").unwrap();
    std::fs::write(&lying, "v 0 0 0").unwrap();
    let open = |path| voxtrace::import::open(path, &ImportOptions::default());
    assert_eq!(open(&named).unwrap().name, "a");
    assert_eq!(open(&nameless).unwrap().grids, open(&named).unwrap().grids);
    for path in [&other, &lying] {
        let error = open(path).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::UnknownFormat(_)), "{error}");
        assert_eq!((&error.path, error.offset), (path, Some(0)));
    }
    assert!(matches!(open(&folder.path().join("none.vox")).unwrap_err().kind, ImportErrorKind::Io(_)));
    assert!(matches!(export::vox::write(&folder.path().join("no/such.vox"), &scene()), Err(ExportError::Io { .. })));
}
