//! Every MagicaVoxel file in `shared/data` is read, comes back from its document byte for byte, and every malformed one gives
//! an error that says where.

use std::{collections::BTreeMap, fs, path::PathBuf};
use voxtrace::{
    Scene, export,
    glam::IVec3,
    import::{ImportErrorKind, Limits, vox, vox::VoxFile},
    scene::Keyframe,
};
use voxtrace_test_support::{data, files_below};

/// The files that are well-formed MagicaVoxel files.
fn good_files() -> Vec<PathBuf> {
    let Some(data) = data() else { return Vec::new() };
    let mut files = files_below(&data, &["vox"]);
    files.retain(|path| !path.starts_with(data.join("malformed")) && !path.ends_with("slab6_vox_test.vox"));
    assert!(files.len() > 50, "{} files", files.len());
    files
}

#[test]
fn the_document_of_each_file_has_the_bytes_of_the_file() {
    for path in good_files() {
        let bytes = fs::read(&path).unwrap();
        let file = VoxFile::parse(&bytes, &path, &Limits::default()).unwrap();
        assert!(file.to_bytes().unwrap() == bytes, "{}", path.display());
    }
}

#[test]
fn each_file_becomes_a_scene() {
    for path in good_files() {
        let scene = vox::read(&path, &Limits::default()).unwrap();
        let voxels: u64 = scene.grids.iter().map(|grid| grid.count()).sum();
        println!(
            "{}: {} grids, {} instances, {voxels} voxels",
            path.display(),
            scene.grids.len(),
            scene.instances.len()
        );
        assert!(voxels > 0, "{}", path.display());
        assert_eq!(scene.materials.len(), 255);
        assert!(scene.instances.iter().all(|instance| instance.world_from_grid.is_similarity()));
    }
}

/// Lowest and highest cell of the placed voxels and the sum of all cells, of the instances hidden or not.
fn placed(scene: &Scene) -> (IVec3, IVec3, [i64; 3]) {
    let (mut lowest, mut highest, mut sum) = (IVec3::MAX, IVec3::MIN, [0; 3]);
    for instance in &scene.instances {
        for (voxel, _) in scene.grids[instance.grid].voxels() {
            let cell = instance.world_from_grid.point(voxel.as_vec3() + 0.5).floor().as_ivec3();
            (lowest, highest) = (lowest.min(cell), highest.max(cell));
            sum.iter_mut().zip(cell.to_array()).for_each(|(sum, coordinate)| *sum += i64::from(coordinate));
        }
    }
    (lowest, highest, sum)
}

#[test]
fn known_files_have_their_voxels_in_their_places() {
    let Some(data) = data() else { return };
    // From a second reader of a few lines, written with 4×4 matrices for this test alone.
    for (name, instances, lowest, highest, sum) in [
        ("fastvoxels_1.vox", 30, [-129, -122, 0], [127, 121, 202], [-11279465, -16757116, 26115032]),
        ("vox/bevy_vox_scene/test.vox", 11, [-25, -43, 0], [24, 84, 40], [-42344, 491955, 154919]),
        ("vox/vengi/8ontop.vox", 72, [-213, -247, 7], [238, 243, 86], [29904, 54768, 366576]),
        ("vox/ogt/test_multiple_model_scene.vox", 104, [23, -14, 6], [128, 91, 21], [989168, 466754, 125438]),
        ("vox/ogt/test_groups.vox", 19, [6, -3, 0], [89, 4, 47], [76524, 399, 21605]),
        ("vox/vox-reader/tree.vox", 3, [-126, -113, 0], [105, 89, 255], [-8487035, -9273216, 122352769]),
        ("vox/dot_vox/axes.vox", 10, [-20, -16, 0], [239, 248, 198], [763374, 920218, 560020]),
        ("vox/arlorean/Test_cars.vox", 2, [-45, -27, 0], [23, 14, 13], [-36966, -19338, 34471]),
    ] {
        let scene = vox::read(&data.join(name), &Limits::default()).unwrap();
        assert_eq!(scene.instances.len(), instances, "{name}");
        assert_eq!(placed(&scene), (lowest.into(), highest.into(), sum), "{name}");
    }
}

#[test]
fn known_files_have_their_models_and_voxels() {
    let Some(data) = data() else { return };
    for (name, models, voxels) in [
        ("fastvoxels_1.vox", 26, 744_265),
        ("vox/bevy_vox_scene/deer.vox", 4, 1_415),
        ("vox/ephtracy/monument_monu3.vox", 1, 848_469),
        ("vox/vengi/vox_character.vox", 16, 4_598),
        ("vox/ogt/test_multiple_model_scene.vox", 41, 6_053),
    ] {
        let scene = vox::read(&data.join(name), &Limits::default()).unwrap();
        let stored: u64 = scene.grids.iter().map(|grid| grid.count()).sum();
        assert_eq!((scene.grids.len(), stored), (models, voxels), "{name}");
    }
}

#[test]
fn animated_files_keep_their_frames() {
    let Some(data) = data() else { return };
    // (frame, model, change of the place since the first frame)
    let moving = |name: &str| {
        let scene = vox::read(&data.join(name), &Limits::default()).unwrap();
        let first = &scene.instances[0];
        assert_eq!(first.grid, first.keyframes[0].grid);
        assert_eq!(first.world_from_grid, first.keyframes[0].world_from_grid);
        let step = |key: &Keyframe| key.world_from_grid.translation - first.world_from_grid.translation;
        first.keyframes.iter().map(|key| (key.frame, key.grid, step(key).as_ivec3().to_array())).collect::<Vec<_>>()
    };
    assert_eq!(
        moving("vox/vengi/animation.0.99.7.1.vox"),
        [(0, 0, [0; 3]), (9, 0, [-43, 60, 0]), (30, 0, [-145, 0, 0])]
    );
    assert_eq!(moving("vox/ogt/test_meta_chunk.vox"), [(7, 0, [0; 3]), (16, 0, [52, 0, 0])]);
    // Models of different sizes have different corners, so only frames and models are compared.
    let models = |keys: &[(u32, usize, [i32; 3])]| keys.iter().map(|key| (key.0, key.1)).collect::<Vec<_>>();
    assert_eq!(models(&moving("vox/bevy_vox_scene/deer.vox")), [(0, 1), (1, 2), (2, 3), (3, 0)]);
    assert_eq!(moving("vox/ephtracy/anim_T-Rex.vox").len(), 8);
}

#[test]
fn hidden_nodes_and_layers_hide_their_instances() {
    let Some(data) = data() else { return };
    for (name, hidden) in [("vox/bevy_vox_scene/test.vox", 2), ("vox/bevy_vox_scene/cloud.vox", 5)] {
        let scene = vox::read(&data.join(name), &Limits::default()).unwrap();
        let count = scene.instances.iter().filter(|instance| !scene.is_visible(instance)).count();
        assert_eq!(count, hidden, "{name}");
    }
}

#[test]
fn layers_groups_and_objects_keep_their_names() {
    let Some(data) = data() else { return };
    let scene = vox::read(&data.join("vox/bevy_vox_scene/test.vox"), &Limits::default()).unwrap();
    let names: Vec<&str> = scene.groups.iter().map(|group| group.name.as_str()).collect();
    assert_eq!(names, ["outer-group", "inner-group", "inner-group"]);
    assert_eq!(scene.groups.iter().map(|group| group.parent).collect::<Vec<_>>(), [None, Some(0), Some(0)]);
    assert_eq!(scene.layers[0].name, "scenery");
    let outline = &voxtrace::PackedScene::pack(&scene).unwrap().outline;
    let in_group = |group: usize| -> Vec<&str> {
        let objects = outline.objects.iter().filter(|object| outline.is_in_group(object, group));
        objects.map(|object| object.name.as_str()).filter(|name| !name.is_empty()).collect()
    };
    let inner = ["walls", "dice", "cloud"];
    assert_eq!((in_group(1), in_group(2)), (inner.to_vec(), inner.to_vec()));
    assert_eq!(in_group(0), [&inner[..], &inner, &["floor"]].concat());
}

#[test]
fn each_malformed_file_gives_an_error_that_says_where() {
    let Some(data) = data() else { return };
    let mut errors = BTreeMap::new();
    for path in files_below(&data.join("malformed"), &["vox"]) {
        match vox::read(&path, &Limits::default()) {
            Ok(_) => errors.insert(path.file_name().unwrap().to_owned(), None),
            Err(error) => {
                println!("{error}");
                assert!(error.offset.is_some(), "{error}");
                errors.insert(path.file_name().unwrap().to_owned(), Some(error.kind))
            }
        };
    }
    assert!(errors.len() >= 15);
    let readable: Vec<_> = errors.iter().filter(|(_, error)| error.is_none()).map(|(name, _)| name.clone()).collect();
    // A model without voxels is an empty scene; the other file broke a converter, and nothing in it is wrong.
    assert_eq!(readable, ["vox_empty_model.vox", "vox_vox-to-kv6-broken.vox"]);
}

#[test]
fn a_slab6_file_is_told_apart() {
    let Some(data) = data() else { return };
    let error = vox::read(&data.join("vox/vengi/slab6_vox_test.vox"), &Limits::default()).unwrap_err();
    assert!(matches!(&error.kind, ImportErrorKind::UnknownFormat(what) if what.contains("Slab6")), "{error}");
}

#[test]
fn each_file_comes_back_from_writing_and_reading_as_the_same_scene() {
    for path in good_files() {
        let scene = vox::read(&path, &Limits::default()).unwrap();
        let bytes = export::vox::document_of(&scene).unwrap().to_bytes().unwrap();
        let again = vox::read_bytes(&bytes, &path, &Limits::default()).unwrap();
        let name = path.display();
        assert!(again.grids == scene.grids, "grids of {name}");
        assert_eq!(again.instances, scene.instances, "instances of {name}");
        assert_eq!(again.materials, scene.materials, "materials of {name}");
        assert_eq!(again.layers, scene.layers, "layers of {name}");
        assert_eq!(again.cameras, scene.cameras, "cameras of {name}");
        assert_eq!(again.sky, scene.sky, "sky of {name}");
        assert!(again == scene, "{name}");
    }
}
