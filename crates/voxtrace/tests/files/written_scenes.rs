//! Scenes that are written to meshes, Qubicle, Minecraft and heightmaps, and read again: the same voxels.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use voxtrace::export::{ExportError, WRITERS, writer_of};
use voxtrace::glam::{IVec3, Quat, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::import::{self, Height, HeightOptions, ImportOptions};
use voxtrace::material::srgb_from_linear;
use voxtrace::scene::Unit;
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions};
use voxtrace::{Axis, Material, Scene, Transform, VoxelGrid, scenes};

type Colored = BTreeMap<[i32; 3], [u8; 3]>;

/// The visible voxels in the world, from their lowest corner on, with their colours.
fn voxels(scene: &Scene) -> Colored {
    let visible = scene.instances.iter().filter(|instance| scene.is_visible(instance));
    let placed = visible.flat_map(|instance| {
        scene.grids[instance.grid].voxels().map(move |(voxel, material)| {
            let at = instance.world_from_grid.point(voxel.as_vec3() + 0.5).floor().as_ivec3();
            (at, scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear))
        })
    });
    let placed: Vec<(IVec3, [u8; 3])> = placed.collect();
    let min = placed.iter().fold(IVec3::MAX, |min, (at, _)| min.min(*at));
    placed.into_iter().map(|(at, color)| ((at - min).to_array(), color)).collect()
}

fn random(state: &mut u32) -> u32 {
    *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    *state >> 8
}

/// Instances, also turned and mirrored, of grids with holes, many colours and voxels left and right of zero.
fn scene() -> Scene {
    let mut scene = Scene::new("written");
    scene.materials =
        (0..200u32).map(|i| Material::from_srgb([i as u8, (i * 7 % 256) as u8, (255 - i * 3 % 256) as u8])).collect();
    let mut state = 3;
    for part in 0..3 {
        let mut grid = VoxelGrid::new();
        for i in 0..21 * 17 * 13 {
            let voxel = IVec3::new(i % 21, i / 21 % 17, i / 357) - 5;
            if !random(&mut state).is_multiple_of(4) {
                // Runs of one colour, so that there is something to merge.
                grid.set(voxel, ((voxel.z + 5) * 9 + voxel.x / 4 + 5 + part * 40) as u16 % 200);
            }
        }
        let turned = Transform::from_quarter_turns(Axis::X, part).after(&Transform::from_quarter_turns(Axis::Z, part));
        let mut placed = turned.translated(Vec3::new(40.0 * part as f32 - 30.0, -7.0, 11.0));
        placed.linear.y_axis *= if part == 1 { -1.0 } else { 1.0 };
        let instance = scene.add_instance(grid, placed);
        scene.instances[instance].name = format!("part {part}");
    }
    // What is hidden is not written.
    let hidden = scene.add_instance(VoxelGrid::clone(&scene.grids[0]), Transform::IDENTITY);
    scene.instances[hidden].hidden = true;
    scene
}

fn written(folder: &Path, name: &str, scene: &Scene) -> PathBuf {
    let path = folder.join(name);
    let lost = writer_of(&path).unwrap().write(&path, scene).unwrap();
    assert!(lost.iter().any(|what| what == "hidden instances (1)") || !name.ends_with(".qb"), "{name}: {lost:?}");
    path
}

fn mesh_options(edge: f64, fill: bool) -> ImportOptions {
    let scale = Scale::VoxelSize(edge);
    let voxelize = VoxelizeOptions { scale, rule: SurfaceRule::Thin, fill, ..VoxelizeOptions::default() };
    ImportOptions { voxelize, ..ImportOptions::default() }
}

/// Those of the voxels that have an empty neighbour.
fn seen(voxels: &Colored) -> Colored {
    let is_seen = |at: &[i32; 3]| {
        (0..6).any(|face| {
            let mut beside = *at;
            beside[face / 2] += if face % 2 == 0 { 1 } else { -1 };
            !voxels.contains_key(&beside)
        })
    };
    voxels.iter().filter(|(at, _)| is_seen(at)).map(|(at, color)| (*at, *color)).collect()
}

#[test]
fn meshes_are_read_again_to_the_voxels_that_are_seen_in_their_colours_and_filled_to_all() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene();
    let wanted = voxels(&scene);
    let surface = seen(&wanted);
    assert!(surface.len() > 7000 && wanted.len() > surface.len());
    for name in ["a.glb", "a.obj", "a.ply"] {
        let path = written(folder.path(), name, &scene);
        let shell = import::open(&path, &mesh_options(1.0, false)).unwrap();
        assert!(voxels(&shell) == surface, "{name}: {} voxels, not {}", voxels(&shell).len(), surface.len());
        let filled = voxels(&import::open(&path, &mesh_options(1.0, true)).unwrap());
        assert!(filled.keys().eq(wanted.keys()), "{name}: {} voxels, not {}", filled.len(), wanted.len());
        assert!(seen(&filled) == surface, "{name}");
        // Every voxel that the surface touches is no more than that.
        let conservative = import::open(
            &path,
            &ImportOptions {
                voxelize: VoxelizeOptions { rule: SurfaceRule::Conservative, ..mesh_options(1.0, false).voxelize },
                ..ImportOptions::default()
            },
        );
        assert!(voxels(&conservative.unwrap()).keys().eq(surface.keys()), "{name}");
    }
}

#[test]
fn a_size_in_metres_or_millimetres_is_that_of_the_mesh() {
    let folder = tempfile::tempdir().unwrap();
    for (unit, size, glb_size) in [(Unit::Metre, 0.07, 0.07), (Unit::Millimetre, 0.3, 0.0003)] {
        let scene = Scene { unit, voxel_size: size, ..scene() };
        let surface = seen(&voxels(&scene));
        for (name, edge) in [("b.glb", glb_size), ("b.obj", size), ("b.ply", size)] {
            let path = written(folder.path(), name, &scene);
            let found = import::open(&path, &mesh_options(edge, false)).unwrap();
            assert!(voxels(&found) == surface, "{name}: {} voxels, not {}", voxels(&found).len(), surface.len());
            // Another size is seen.
            assert_ne!(voxels(&import::open(&path, &mesh_options(edge * 1.1, false)).unwrap()).len(), surface.len());
        }
    }
}

#[test]
fn a_turned_instance_stands_in_a_mesh_as_it_does_in_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::splat(-20), max: IVec3::new(30, 20, 10) }, 0);
    let mut scene = Scene::from_grid("turned", grid, vec![Material::from_srgb([200, 90, 30])]);
    scene.instances[0].world_from_grid = Transform::from_rotation(Quat::from_rotation_z(35f32.to_radians()));
    let mut baked = scene.clone();
    voxtrace::bake::bake(&mut baked, &import::Limits::default()).unwrap();
    let wanted = voxels(&baked);
    for name in ["c.glb", "c.obj", "c.ply"] {
        let path = written(folder.path(), name, &scene);
        let found = voxels(&import::open(&path, &mesh_options(1.0, true)).unwrap());
        // A voxel that the surface crosses beside its centre comes besides: one along each slanted edge.
        let missing = wanted.keys().filter(|at| !found.contains_key(*at)).count();
        assert!(
            missing < wanted.len() / 500 && found.len() < wanted.len() * 27 / 25,
            "{name}: {missing} missing of {}, {} there",
            wanted.len(),
            found.len()
        );
    }
}

#[test]
fn what_shines_lets_light_through_or_is_metal_does_so_in_a_glb_again() {
    let folder = tempfile::tempdir().unwrap();
    let materials = vec![
        Material::from_srgb([90, 80, 70]),
        Material::emissive(Vec3::new(12.0, 6.0, 3.0)),
        Material::metal(Vec3::new(0.9, 0.6, 0.2), 0.25),
        Material { transmission: 0.875, ..Material::glass(1.33, 0.0) }.tinted(Vec3::new(0.5, 0.9, 0.7), 4.0),
        Material::plastic(Vec3::new(0.2, 0.3, 0.4), 0.5),
    ];
    let mut scene = Scene { materials, ..Scene::new("materials") };
    let mut grid = VoxelGrid::new();
    for material in 0..5 {
        let min = IVec3::new(4 * i32::from(material), 0, 0);
        grid.fill_box(VoxelBox { min, max: min + 4 }, material);
    }
    scene.add_instance(grid, Transform::IDENTITY);
    let path = written(folder.path(), "d.glb", &scene);
    let found = import::open(&path, &mesh_options(1.0, true)).unwrap();
    for number in 0..5 {
        let index = found.grids[0].get(IVec3::new(4 * number + 2, 2, 2)).unwrap();
        let (found, wanted) = (found.materials[usize::from(index)], scene.materials[number as usize]);
        let is_near = |a: Vec3, b: Vec3| (a - b).abs().max_element() < 0.01 * b.max_element().max(0.5);
        assert!(is_near(found.base_color, wanted.base_color), "{found:?}, not {wanted:?}");
        assert!(
            is_near(found.emission, wanted.emission) && is_near(found.absorption, wanted.absorption),
            "{found:?}, not {wanted:?}"
        );
        // A metal has no coat.
        let numbers = |m: &Material| Vec3::new(m.metallic, m.transmission, m.specular * (1.0 - m.metallic));
        assert!(is_near(numbers(&found), numbers(&wanted)), "{found:?}, not {wanted:?}");
        assert!((found.roughness - wanted.roughness).abs() < 0.02, "{found:?}, not {wanted:?}");
    }
}

#[test]
fn qubicle_files_have_the_voxels_colours_places_and_names_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene();
    let path = written(folder.path(), "a.qb", &scene);
    let found = import::open(&path, &ImportOptions::default()).unwrap();
    assert!(voxels(&found) == voxels(&scene));
    assert_eq!(found.instances.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["part 0", "part 1", "part 2"]);
    // Instances are where they were, not only beside each other.
    let lowest = |scene: &Scene| {
        let corners = scene.instances[..3].iter().map(|one| {
            let bounds = scene.grids[one.grid].bounds().unwrap();
            let place = &one.world_from_grid;
            place.point(bounds.min.as_vec3()).min(place.point(bounds.max.as_vec3()))
        });
        corners.collect::<Vec<_>>()
    };
    assert_eq!(lowest(&found), lowest(&scene));
    let mut other = scene.clone();
    other.instances[1].world_from_grid.translation.z += 1.0;
    assert!(
        voxels(&import::open(&written(folder.path(), "b.qb", &other), &ImportOptions::default()).unwrap())
            != voxels(&scene)
    );
}

#[test]
fn schematics_have_the_voxels_of_the_scene_and_keep_what_blocks_look_like() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene();
    let path = written(folder.path(), "a.schem", &scene);
    let found = voxels(&import::open(&path, &ImportOptions::default()).unwrap());
    let wanted = voxels(&scene);
    assert!(found.keys().eq(wanted.keys()), "{} voxels, not {}", found.len(), wanted.len());
    // Colours of blocks are near to those of the scene: within a fifth of what there is.
    let off =
        |a: &[u8; 3], b: &[u8; 3]| (0..3).map(|i| (f64::from(a[i]) - f64::from(b[i])).powi(2)).sum::<f64>().sqrt();
    let mean = wanted.iter().map(|(at, color)| off(color, &found[at])).sum::<f64>() / wanted.len() as f64;
    assert!(mean < 50.0, "{mean}");
    // What is read is written again to the same blocks.
    let first = import::open(&path, &ImportOptions::default()).unwrap();
    let again = folder.path().join("b.schem");
    assert_eq!(writer_of(&again).unwrap().write(&again, &first).unwrap(), [] as [String; 0]);
    let second = import::open(&again, &ImportOptions::default()).unwrap();
    assert_eq!((&second.grids, &second.materials), (&first.grids, &first.materials));
}

/// Columns of a hill, as a heightmap would make them, with a hole.
fn hill() -> Scene {
    let mut grid = VoxelGrid::new();
    for i in 0..40 * 30 {
        let (x, y): (i32, i32) = (i % 40 - 7, i / 40 + 3);
        let top = ((x - 10).pow(2) + (y - 15).pow(2)) / 20;
        if (x, y) != (11, 12) {
            grid.fill_box(VoxelBox { min: IVec3::new(x, y, -4), max: IVec3::new(x + 1, y + 1, top - 3) }, 0);
        }
    }
    Scene::from_grid("hill", grid, vec![Material::default()])
}

#[test]
fn heightmaps_have_the_columns_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let scene = hill();
    let wanted: Vec<_> = voxels(&scene).into_keys().collect();
    let options = |height, shell| {
        let heights = HeightOptions { height, shell, ..HeightOptions::default() };
        ImportOptions { heights, ..ImportOptions::default() }
    };
    for (unit, size) in [(Unit::Voxel, 1.0), (Unit::Metre, 25.0), (Unit::Metre, 0.1)] {
        let scene = Scene { unit, voxel_size: size, ..scene.clone() };
        let path = written(folder.path(), "a.asc", &scene);
        let found = import::open(&path, &options(Height::Automatic, false)).unwrap();
        assert_eq!(found.voxel_size, size);
        assert!(voxels(&found).into_keys().eq(wanted.iter().copied()), "{size}");
    }
    // A picture has no holes: there the ground is as low as it gets.
    let path = written(folder.path(), "a.png", &scene);
    let found: Vec<_> =
        voxels(&import::open(&path, &options(Height::Scale(1.0), false)).unwrap()).into_keys().collect();
    let more: Vec<_> = found.iter().filter(|at| !wanted.contains(at)).collect();
    assert_eq!((found.len(), more), (wanted.len() + 1, vec![&[18, 9, 0]]));
}

#[test]
fn a_heightmap_lies_on_the_map_where_the_scene_does() {
    use voxtrace::georeference::Georeference;
    use voxtrace::glam::DVec3;
    let folder = tempfile::tempdir().unwrap();
    let place = Georeference::of_grid(DVec3::new(691_000.0, 5_334_000.5, 512.25), 0.5, "EPSG:25832");
    let scene = Scene { voxel_size: 0.5, unit: Unit::Metre, georeference: Some(place.clone()), ..hill() };
    let found = import::open(&written(folder.path(), "a.asc", &scene), &ImportOptions::default()).unwrap();
    let corner = |scene: &Scene| {
        let low = scene.grids[0].bounds().unwrap().min.as_dvec3();
        scene.georeference.as_ref().unwrap().coordinates_from_world.transform_point3(low)
    };
    assert!(corner(&found).distance(corner(&scene)) < 1e-3, "{} {}", corner(&found), corner(&scene));
}

#[test]
fn a_built_in_scene_goes_through_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = scenes::generate("church", Some(60_000)).unwrap();
    voxtrace::bake::flatten(&mut scene).unwrap();
    let wanted = voxels(&scene);
    let surface = seen(&wanted);
    for writer in WRITERS {
        let path = folder.path().join(format!("church.{}", writer.extension));
        writer.write(&path, &scene).unwrap();
        let is_mesh = ["glb", "obj", "ply"].contains(&writer.extension);
        let found = voxels(&import::open(&path, &mesh_options(scene.voxel_size, is_mesh)).unwrap());
        match writer.extension {
            "asc" | "png" => assert!(!found.is_empty()),
            // Behind glass everything is seen.
            "glb" | "obj" | "ply" => {
                let missing = wanted.keys().filter(|at| !found.contains_key(*at)).count();
                let unseen = surface.keys().filter(|at| !found.contains_key(*at)).count();
                let more = found.keys().filter(|at| !wanted.contains_key(*at)).count();
                assert_eq!((missing, unseen, more), (0, 0, 0), "{} of {}", writer.extension, wanted.len());
            }
            _ => assert!(found.keys().eq(wanted.keys()), "{}", writer.extension),
        }
    }
}

#[test]
fn what_a_format_cannot_hold_is_one_error_and_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let mut turned = scene();
    turned.instances[1].world_from_grid = Transform::from_rotation(Quat::from_rotation_z(0.6));
    let empty = Scene::new("empty");
    let mut far = scene();
    far.instances[0].world_from_grid.translation.x = -100_000.0;
    for writer in WRITERS {
        let path = folder.path().join(format!("a.{}", writer.extension));
        match writer.write(&path, &turned) {
            Ok(_) => assert!(!writer.needs_lattice, "{}", writer.extension),
            Err(error) => {
                let text = error.to_string();
                assert!(writer.needs_lattice && matches!(error, ExportError::Placement { .. }), "{text}");
                assert!(text.contains("instance 1 \"part 1\"") && !path.exists(), "{text}");
            }
        }
        let path = folder.path().join(format!("empty.{}", writer.extension));
        match (writer.extension, writer.write(&path, &empty)) {
            ("asc" | "png" | "schem", Err(ExportError::Empty { .. })) => assert!(!path.exists()),
            ("asc" | "png" | "schem", written) => panic!("{}: {written:?}", writer.extension),
            (_, written) => assert!(written.is_ok(), "{}: {written:?}", writer.extension),
        }
    }
    let path = folder.path().join("far.schem");
    assert!(matches!(writer_of(&path).unwrap().write(&path, &far), Err(ExportError::TooLarge { .. })));
    assert!(!path.exists() && writer_of(Path::new("a.xyz")).is_none());
}

#[test]
fn writing_that_nobody_waits_for_any_more_ends_with_the_old_file() {
    let scene = scene();
    for writer in WRITERS {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(format!("a.{}", writer.extension));
        let asked = AtomicUsize::new(0);
        let until = |most: usize| {
            asked.store(0, Ordering::Relaxed);
            let asked = &asked;
            move || asked.fetch_add(1, Ordering::Relaxed) < most
        };
        let lost = writer.write_while(&path, &scene, &until(usize::MAX)).unwrap();
        assert_eq!(writer.write(&path, &scene).unwrap(), lost);
        let (whole, questions) = (std::fs::read(&path).unwrap(), asked.load(Ordering::Relaxed));
        assert!(questions > 5, "{} is asked {questions} times", writer.extension);
        for answered in [0, 1, 3, questions / 2, questions - 2, questions - 1] {
            std::fs::write(&path, "old").unwrap();
            let written = writer.write_while(&path, &scene, &until(answered));
            assert!(matches!(written, Err(ExportError::Stopped)), "{} after {answered}: {written:?}", writer.extension);
            assert_eq!(std::fs::read(&path).unwrap(), b"old", "{} after {answered}", writer.extension);
        }
        let mut expected = writer.companions(&path);
        expected.push(path.clone());
        let mut there: Vec<PathBuf> =
            std::fs::read_dir(folder.path()).unwrap().map(|file| file.unwrap().path()).collect();
        expected.sort();
        there.sort();
        assert_eq!(there, expected, "nothing is left behind");
        // One answer more, and it is written.
        writer.write_while(&path, &scene, &until(questions)).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
    }
}
