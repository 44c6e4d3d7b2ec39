//! Native files by any bytes: cut, changed with their checksums mended, noise. Nothing panics, and what is opened can be
//! traced. Also replays the corpus of the fuzz target.

#[path = "../../../../fuzz/check/native.rs"]
mod check;
#[path = "../../../../fuzz/check/checksums.rs"]
mod checksums;
#[path = "../../../../fuzz/check/forged.rs"]
mod forged;

use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use forged::{chain, forge};
use voxtrace::georeference::Georeference;
use voxtrace::glam::{DAffine3, DVec3, IVec3, Mat3, Vec3};
use voxtrace::packed::{FileErrorKind, LevelCount};
use voxtrace::{Camera, Material, PackedScene, Scene, Sun, Transform, VoxelGrid};
use voxtrace_core::packed::MAX_INSTANCE_DEPTH;

/// Three voxels, some of them twice as large and turned, that shine; with all else that a file can have.
fn lights() -> Scene {
    let mut grid = VoxelGrid::new();
    for (at, material) in [([0, 0, 0], 0), ([1, 0, 0], 1), ([9, 3, -5], 1)] {
        grid.set(at.into(), material);
    }
    let glow = Material::emissive(Vec3::new(1.0, 0.5, 0.25));
    let mut scene = Scene::from_grid("lights", grid.clone(), vec![Material::diffuse(Vec3::ONE), glow]);
    let linear = Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z) * 2.0;
    scene.add_instance(grid, Transform { linear, translation: Vec3::new(30.0, 0.5, 1.0) });
    scene.cameras = vec![Camera::look_at(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO)];
    scene.sky.set_sun(Sun { direction: Vec3::Z, angular_radius: 0.01, irradiance: Vec3::ONE });
    let coordinates_from_world = DAffine3::from_translation(DVec3::new(691_000.5, 5.0, -2.0));
    scene.georeference = Some(Georeference { coordinates_from_world, crs: "EPSG:32632".into() });
    scene
}

/// A whole brick whose voxels need no palette, and two voxels so far from it that nodes lead to their bricks.
fn deep() -> Scene {
    let mut grid = VoxelGrid::new();
    let brick = (0..512).map(|n| IVec3::new(n & 7, n >> 3 & 7, n >> 6));
    for (n, at) in brick.enumerate() {
        grid.set(at, (n % 3) as u16);
    }
    grid.set(IVec3::new(70, 3, 100), 1);
    grid.set(IVec3::new(-60, -3, 5), 2);
    Scene::from_grid("deep", grid, (1..4).map(|n| Material::diffuse(Vec3::splat(0.25 * n as f32))).collect())
}

/// Three models that meet in bricks of the world and lie within each other there, one of them mirrored, and one that stands aslant between them.
fn models() -> Scene {
    let materials = (1..4).map(|n| Material::diffuse(Vec3::splat(0.25 * n as f32))).collect();
    let mut scene = Scene { materials, ..Scene::new("models") };
    let mirrored = Mat3::from_cols(Vec3::NEG_X, Vec3::Y, Vec3::Z);
    let aslant = Mat3::from_rotation_z(0.3);
    let places =
        [(Mat3::IDENTITY, -3.0), (aslant, 40.0), (mirrored, 5.0), (Mat3::from_cols(Vec3::Y, Vec3::Z, Vec3::X), 1.0)];
    for (index, (linear, x)) in places.into_iter().enumerate() {
        let mut grid = VoxelGrid::new();
        (0..27).for_each(|n| _ = grid.set(IVec3::new(n % 3, n / 3 % 3, n / 9) * 2, (n as u16 + index as u16) % 3));
        scene.add_instance(grid, Transform { linear, translation: Vec3::new(x, 2.0, -1.0) });
    }
    scene
}

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sample.vxt");
    let mut samples = [("empty.vxt", Scene::default()), ("lights.vxt", lights()), ("deep.vxt", deep())]
        .map(|(name, scene)| {
            PackedScene::pack(&scene).unwrap().save(&path).unwrap();
            (name, std::fs::read(&path).unwrap())
        })
        .to_vec();
    // The deepest hierarchy over instances that is opened, and one that is a level too deep.
    samples.push(("chain.vxt", chain(MAX_INSTANCE_DEPTH).0));
    PackedScene::pack_merged(&models()).unwrap().save(&path).unwrap();
    samples.push(("merged.vxt", std::fs::read(&path).unwrap()));
    PackedScene::pack(&deep()).unwrap().save_with_levels(&path, LevelCount::Some(2), &mut |_| true).unwrap();
    samples.push(("levels.vxt", std::fs::read(&path).unwrap()));
    samples.push(("chain_too_deep.vxt", chain(MAX_INSTANCE_DEPTH + 1).0));
    samples.push(("beyond_the_end.vxt", beyond_the_end()));
    samples
}

/// A grid that says that it ends before most of its bricks.
fn beyond_the_end() -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep.vxt");
    let packed = PackedScene::pack(&deep()).unwrap();
    packed.save(&path).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    let end = packed.grids()[0].origin.x + 8;
    forge(&mut bytes, b"GRID", |grids| grids[52..56].copy_from_slice(&end.to_le_bytes()));
    bytes
}

/// Those that are opened.
fn sound_samples() -> Vec<(&'static str, Vec<u8>)> {
    let is_sound = |name: &str| !["chain_too_deep.vxt", "beyond_the_end.vxt"].contains(&name);
    samples().into_iter().filter(|(name, _)| is_sound(name)).collect()
}

/// A file that the first version of the format was written with: five lamps of one grid, turned and mirrored as MagicaVoxel
/// can, and a floor.
const VERSION_1: &[u8] = include_bytes!("../../../../fuzz/corpus/native/version_1.vxt");

#[test]
fn a_file_of_version_1_opens_as_the_scene_packed_anew() {
    let opened = PackedScene::from_bytes(VERSION_1).unwrap();
    let anew = PackedScene::pack(&opened.to_scene()).unwrap();
    let is_same = |scene: &PackedScene| {
        let (geometry, placement) = (scene.geometry(), scene.placement());
        geometry.emitters() == anew.geometry().emitters()
            && geometry.light_nodes() == anew.geometry().light_nodes()
            && placement.instances() == anew.instances()
            && placement.light_nodes() == anew.placement().light_nodes()
            && scene.content_hash() == anew.content_hash()
    };
    assert!(is_same(&opened));
    // 19 glowing voxels of the lamp's 21, of which two are covered; the file has them five times.
    assert_eq!((opened.grids().len(), opened.instances().len(), anew.geometry().emitters().len()), (2, 6, 17));
    // Its second word is the instance in version 1 and the grid in version 2: taken for version 2 it is refused.
    let mut forged = VERSION_1.to_vec();
    forged[8] = 2;
    assert!(matches!(PackedScene::from_bytes(&forged), Err(FileErrorKind::Invalid(_))));
    let mut moved = opened.to_scene();
    moved.instances[0].world_from_grid.translation.x += 1.0;
    assert!(!is_same(&PackedScene::pack(&moved).unwrap()));

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("saved.vxt");
    opened.save(&path).unwrap();
    assert!(is_same(&PackedScene::open(&path).unwrap()));
    assert_eq!(std::fs::read(&path).unwrap()[8], 2, "it is saved as version 2");
    // Files for streaming, version 3, have other sections.
    forged[8] = 3;
    assert!(matches!(PackedScene::from_bytes(&forged), Err(FileErrorKind::Damaged { .. })));
    for version in [0, 4] {
        forged[8] = version;
        assert!(
            matches!(PackedScene::from_bytes(&forged), Err(FileErrorKind::Version(found)) if found == u32::from(version))
        );
    }
}

/// The samples that are opened, and the old file.
fn old_and_new() -> Vec<(&'static str, Vec<u8>)> {
    sound_samples().into_iter().chain([("version_1.vxt", VERSION_1.to_vec())]).collect()
}

#[test]
fn the_samples_reach_nodes_lights_and_a_place_on_a_map() {
    let opened: Vec<PackedScene> =
        sound_samples().iter().map(|(_, bytes)| PackedScene::from_bytes(bytes).unwrap()).collect();
    assert!(opened[0].grids().is_empty());
    assert!(
        opened[1].instances().len() == 2
            && opened[1].geometry().emitters().len() == 4
            && opened[1].georeference.is_some()
    );
    assert!(opened[2].grids()[0].top_shift > 3);
    assert_eq!(opened[3].instances().len(), MAX_INSTANCE_DEPTH + 1);
    let merged = &opened[4];
    assert_eq!((merged.is_merged(), merged.instances().len(), merged.instance_count()), (true, 2, 4));
    let stored = merged.statistics().voxels - merged.grids().iter().map(|grid| u64::from(grid.voxels[0])).sum::<u64>();
    assert!(stored > 0 && merged.statistics().voxels == 4 * 27, "{stored} voxels are below others");
    assert_eq!(merged.split().content_hash(), PackedScene::pack(&merged.to_scene()).unwrap().content_hash());
    let traced = check::check(&samples()[3].1).unwrap();
    assert_eq!(traced.scene.instances().len(), opened[3].instances().len());
    assert!(traced.rays.iter().any(|ray| traced.scene.cast(ray).is_some()));
    let too_deep = chain(MAX_INSTANCE_DEPTH + 1).0;
    for refused in [too_deep, beyond_the_end()] {
        assert!(matches!(PackedScene::from_bytes(&refused), Err(FileErrorKind::Invalid(_))));
    }
}

#[test]
fn a_file_cut_at_any_byte_is_refused() {
    for (name, bytes) in old_and_new() {
        for length in 0..bytes.len() {
            check::check(&bytes[..length]);
            // The last section may be empty; then what is cut off is what lies before it.
            assert!(PackedScene::from_bytes(&bytes[..length]).is_err(), "{name} {length}");
        }
    }
}

#[test]
fn a_file_with_changed_bytes_and_mended_checksums_is_refused_or_traced() {
    let numbers = [0, 1, 2, 64, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX, f32::NAN.to_bits(), 1 << 21];
    let mut random = Random(12);
    let mut opened = 0;
    for (_, bytes) in old_and_new() {
        for _ in 0..3_000 {
            let damaged = damaged(&bytes, &numbers, &["CELL", "\0\0\0\0\0\0\0\u{1}"], |end| random.below(end));
            check::check(&damaged);
            opened += usize::from(PackedScene::from_bytes(&damaged).is_ok());
        }
    }
    // Most of the damage lies under a checksum, unless it is mended.
    assert!(opened < 7_500, "{opened} of 18000");
}

#[test]
fn sixteen_megabytes_of_noise_are_refused() {
    let mut random = Random(13);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    assert!(matches!(PackedScene::from_bytes(&noise), Err(FileErrorKind::NotVoxtrace)));
    for (name, bytes) in samples() {
        // The table is right, and what it tells of is noise.
        noise[..512].copy_from_slice(&bytes[..512]);
        assert!(matches!(PackedScene::from_bytes(&noise), Err(FileErrorKind::Damaged { .. })), "{name}");
        check::check(&noise);
    }
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    corpus::replay("native", &samples(), |bytes| _ = check::check(bytes));
}
