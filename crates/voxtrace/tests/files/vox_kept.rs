//! A .vox file that is read and written again says what it said, also what voxtrace does not interpret; and what a change of
//! the scene cannot leave as it was is made anew, and told.

use crate::vox_samples;
use std::{borrow::Cow, collections::BTreeMap, fs, path::Path};
use voxtrace::{
    Camera, Material, Scene, Transform, export,
    glam::{IVec3, Vec3},
    import::{
        Limits,
        vox::{self, Body, Chunk, Dict, Numbered, VoxFile},
    },
    voxelize,
};
use voxtrace_test_support::{data, files_below};

/// The chunks of a document, models as the voxels that they end up with: their order means nothing, the last of two at one
/// place holds, and those of colour 0 are none.
fn said<'a>(file: &'a VoxFile) -> Vec<(Chunk<'a>, BTreeMap<[u8; 3], u8>)> {
    let said = |chunk: &Chunk<'a>| {
        let mut voxels = BTreeMap::new();
        let mut chunk = Chunk { offset: 0, ..chunk.clone() };
        if let Body::Voxels(list) = &mut chunk.body {
            list.iter().for_each(|&[x, y, z, color]| _ = voxels.insert([x, y, z], color));
            voxels.retain(|_, color| *color != 0);
            *list = Cow::Borrowed(&[]);
        }
        (chunk, voxels)
    };
    file.chunks.iter().map(said).collect()
}

fn parsed(bytes: &[u8]) -> VoxFile<'_> {
    VoxFile::parse(bytes, Path::new("a.vox"), &Limits::default()).unwrap()
}

fn scene_of(bytes: &[u8]) -> Scene {
    vox::read_bytes(bytes, Path::new("a.vox"), &Limits::default()).unwrap()
}

fn assert_kept(bytes: &[u8], name: &str) {
    let scene = scene_of(bytes);
    let written = export::vox::document_of(&scene).unwrap().to_bytes().unwrap();
    let (before, after) = (parsed(bytes), parsed(&written));
    assert_eq!(
        (before.version, &before.main, &before.trailing),
        (after.version, &after.main, &after.trailing),
        "{name}"
    );
    assert!(said(&before) == said(&after), "{name}");
    assert!(scene_of(&written) == scene, "{name}");
}

/// A small file with all that MagicaVoxel says and voxtrace does not interpret.
fn rich() -> Vec<u8> {
    let dict = |pairs: &[(&'static str, &str)]| {
        let mut dict = Dict::default();
        pairs.iter().for_each(|(key, value)| dict.push(key, *value));
        dict
    };
    let (_, bytes) = vox_samples::samples().into_iter().find(|(name, _)| *name == "graph.vox").unwrap();
    let mut file = parsed(&bytes);
    let media = dict(&[("_type", "_media"), ("_media", "1"), ("_d", "0.05"), ("_g", "0.3"), ("_odd", "key")]);
    let lens = dict(&[("_type", "_lens"), ("_aperture", "0.25"), ("_blade_n", "6")]);
    for body in [
        Body::Material(Numbered { id: 2, properties: media }),
        Body::RenderObject(lens),
        Body::RenderObject(dict(&[("_type", "_bloom"), ("_mix", "0.5")])),
        Body::Unknown(*b"META", Cow::Borrowed(b"who knows")),
    ] {
        file.chunks.push(Chunk::new(body));
    }
    file.to_bytes().unwrap()
}

#[test]
fn every_sample_is_written_as_it_was_read() {
    assert_kept(&rich(), "rich");
    for (name, bytes) in vox_samples::samples() {
        assert_kept(&bytes, name);
    }
}

#[test]
fn every_real_file_is_written_as_it_was_read() {
    let Some(data) = data() else { return };
    let mut files = files_below(&data, &["vox"]);
    files.retain(|path| !path.starts_with(data.join("malformed")) && !path.ends_with("slab6_vox_test.vox"));
    assert!(files.len() > 50, "{} files", files.len());
    for path in files {
        assert_kept(&fs::read(&path).unwrap(), &path.display().to_string());
    }
}

#[test]
fn the_comparison_sees_a_change_of_any_chunk() {
    let bytes = rich();
    let before = parsed(&bytes);
    for at in 0..before.chunks.len() {
        let mut after = before.clone();
        after.chunks.remove(at);
        assert!(said(&after) != said(&before), "chunk {at}");
        let mut after = before.clone();
        match &mut after.chunks[at].body {
            Body::Size(size) => size[0] += 1,
            Body::Voxels(voxels) => voxels.to_mut()[0][3] ^= 3,
            Body::Palette(palette) => palette[255][3] ^= 1,
            Body::Material(numbered) | Body::Camera(numbered) | Body::Layer(numbered, _) => {
                numbered.properties.push("_new", "1");
            }
            Body::Transform(node) => node.frames[0].push("_new", "1"),
            Body::Group(node) => node.attributes.push("_new", "1"),
            Body::Shape(node) => node.models[0].1.push("_new", "1"),
            Body::RenderObject(properties) => properties.push("_new", "1"),
            Body::Notes(notes) => notes[0] = Cow::Borrowed(b"other"),
            Body::IndexMap(map) => map[9] ^= 1,
            Body::Unknown(_, content) => content.to_mut().push(0),
            Body::Pack(_) | Body::OldMaterial(_) => {}
        }
        assert!(said(&after) != said(&before), "chunk {at}");
    }
}

/// What is written of a changed scene, and what is said to be lost.
fn changed(change: impl FnOnce(&mut Scene)) -> (Scene, Vec<u8>, Vec<String>) {
    let mut scene = scene_of(&rich());
    change(&mut scene);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vox");
    let lost = export::vox::write(&path, &scene).unwrap();
    (scene, fs::read(&path).unwrap(), lost)
}

fn names(bytes: &[u8]) -> Vec<String> {
    parsed(bytes).chunks.iter().map(|chunk| String::from_utf8_lossy(&chunk.name()).into_owned()).collect()
}

#[test]
fn voxels_that_change_within_their_models_change_these_alone() {
    let (scene, bytes, lost) = changed(|scene| {
        let grid = std::sync::Arc::make_mut(&mut scene.grids[0]);
        let (voxel, material) = grid.voxels().next().unwrap();
        grid.set(voxel, material + 1);
    });
    let before = rich();
    assert_eq!(lost, Vec::<String>::new());
    let (before, after) = (parsed(&before), parsed(&bytes));
    let (before, after) = (said(&before), said(&after));
    assert!(before.iter().map(|(chunk, _)| chunk).eq(after.iter().map(|(chunk, _)| chunk)));
    assert!(before != after, "a voxel has another colour");
    assert!(scene_of(&bytes) == scene);
}

#[test]
fn one_other_material_leaves_the_others_as_they_were() {
    let (scene, bytes, lost) = changed(|scene| scene.materials[9] = Material { roughness: 0.75, ..scene.materials[9] });
    assert_eq!(lost, ["MagicaVoxel's settings of 1 materials"]);
    let again = scene_of(&bytes);
    assert_eq!(again.materials, scene.materials);
    let file = parsed(&bytes);
    let material = |id: i32| {
        file.chunks.iter().rev().find_map(|chunk| match &chunk.body {
            Body::Material(material) if material.id == id => Some(material.properties.clone()),
            _ => None,
        })
    };
    assert_eq!(material(2).unwrap().get("_odd"), Some(&b"key"[..]));
    assert_eq!(material(10).unwrap().get("_rough"), Some(&b"0.75"[..]));
    let (scene, bytes, lost) = changed(|scene| scene.materials[100] = Material::diffuse(Vec3::splat(1.0)));
    assert!(lost.is_empty() && names(&bytes).contains(&"RGBA".into()), "{lost:?}");
    assert_eq!(scene_of(&bytes).materials, scene.materials);
}

#[test]
fn a_palette_made_anew_tells_what_it_cannot_keep() {
    let (scene, bytes, lost) = changed(|scene| voxelize::quantize_palette(scene, 1, false));
    assert!(scene.materials.len() < 255, "a list of its own");
    assert_eq!(lost, ["MagicaVoxel's settings of 5 materials", "names and order of the palette"]);
    let (again, names) = (scene_of(&bytes), names(&bytes));
    assert_eq!(again.grids, scene.grids);
    assert_eq!(again.instances, scene.instances);
    assert!(["META", "rOBJ", "nTRN", "rCAM", "LAYR"].iter().all(|name| names.contains(&(*name).into())), "{names:?}");
    assert!(!names.contains(&"IMAP".into()) && !names.contains(&"NOTE".into()), "{names:?}");
}

#[test]
fn what_moves_or_grows_gets_another_graph_and_the_rest_stays() {
    let moved = |scene: &mut Scene| scene.instances[0].world_from_grid = Transform::from_translation(Vec3::splat(99.0));
    let grown = |scene: &mut Scene| {
        std::sync::Arc::make_mut(&mut scene.grids[0]).set(IVec3::new(-40, 300, 7), 3);
    };
    let added = |scene: &mut Scene| {
        scene.add_instance(vox_samples::small_grid(3), Transform::IDENTITY);
    };
    let renamed = |scene: &mut Scene| scene.layers[0].name = "other".into();
    let changes: [&dyn Fn(&mut Scene); 4] = [&moved, &grown, &added, &renamed];
    for (number, change) in changes.into_iter().enumerate() {
        let (scene, bytes, lost) = changed(change);
        assert_eq!(lost, ["the groups of the scene graph"], "change {number}");
        let again = scene_of(&bytes);
        assert_eq!(again.layers, scene.layers);
        let voxels = |scene: &Scene| scene.grids.iter().map(|grid| grid.count()).sum::<u64>();
        assert_eq!(voxels(&again), voxels(&scene), "change {number}");
        let names = names(&bytes);
        assert_eq!(names.iter().filter(|name| *name == "rOBJ").count(), 4);
        assert!(names.contains(&"META".into()) && names.contains(&"NOTE".into()));
    }
}

#[test]
fn other_light_and_cameras_take_the_place_of_theirs_alone() {
    let (scene, bytes, lost) = changed(|scene| {
        scene.sky.set_sun(None);
        scene.cameras = vec![Camera { name: "new".into(), ..Camera::look_at(Vec3::splat(30.0), Vec3::ZERO) }];
    });
    assert!(lost.is_empty());
    let again = scene_of(&bytes);
    assert_eq!((again.sky.sun(), &again.cameras[0].name), (None, &"new".to_owned()));
    assert_eq!(again.cameras.len(), scene.cameras.len());
    let file = parsed(&bytes);
    let is = |chunk: &Chunk, kind: &[u8]| matches!(&chunk.body, Body::RenderObject(properties) if properties.get("_type") == Some(kind));
    for (kind, count) in [(&b"_lens"[..], 1), (b"_bloom", 1), (b"_inf", 1), (b"_uni", 1)] {
        assert_eq!(file.chunks.iter().filter(|chunk| is(chunk, kind)).count(), count);
    }
}

#[test]
fn what_a_native_file_leaves_out_is_named() {
    let left_out = export::native::left_out(&scene_of(&rich()));
    for what in ["hidden instances", "moving instances (", "names of instances", "materials of other kinds (1)"] {
        assert!(left_out.iter().any(|phrase| phrase.starts_with(what)), "{what}: {left_out:?}");
    }
    for what in ["render settings (2)", "IMAP", "META", "NOTE"] {
        assert!(left_out.contains(&what.to_owned()), "{what}: {left_out:?}");
    }
    let plain = Scene::from_grid("plain", vox_samples::small_grid(1), vec![Material::default(); 5]);
    assert!(export::native::left_out(&plain).is_empty());
}
