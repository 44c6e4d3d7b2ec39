//! Mesh files: the same house from every format, names that lead out of the folder, and damage of every kind. Nothing panics.
//! Also replays the corpora of the fuzz targets.

#[path = "../../../../fuzz/check/mesh.rs"]
mod check;

use crate::corpus;
use crate::damage::damaged;
use crate::mesh_samples;
use crate::mesh_samples::samples;
use crate::meshes::Random;
use std::fs;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::import::{self, ImportError, ImportErrorKind, ImportOptions, Limits};
use voxtrace::mesh::{Mesh, UpAxis};
use voxtrace::scene::Unit;
use voxtrace::voxelize::{self, Scale, VoxelizeOptions};
use voxtrace_test_support::{data, files_below};

fn options(resolution: u32) -> ImportOptions {
    let voxelize = VoxelizeOptions { scale: Scale::Resolution(resolution), ..VoxelizeOptions::default() };
    ImportOptions { voxelize, ..ImportOptions::default() }
}

fn scene_from(name: &str, bytes: &[u8], options: &ImportOptions) -> Result<Scene, ImportError> {
    let mesh = import::mesh_from_bytes(bytes, Path::new(name), options)?;
    Ok(voxelize::voxelize(&mesh, &options.voxelize, &options.limits).unwrap())
}

fn voxels(scene: &Scene) -> Vec<IVec3> {
    scene.grids[0].voxels().map(|(voxel, _)| voxel).collect()
}

#[test]
fn the_same_house_from_every_format_has_the_same_voxels() {
    let folder = tempfile::tempdir().unwrap();
    let mut first = None;
    for (name, bytes) in samples() {
        let path = folder.path().join(name);
        fs::write(&path, &bytes).unwrap();
        let scene = import::open(&path, &options(64)).unwrap();
        assert_eq!(scene.grids[0].bounds().unwrap().max, IVec3::new(64, 48, 52), "{name}");
        let found = voxels(&scene);
        assert!(*first.get_or_insert_with(|| found.clone()) == found, "{name}");
        assert_eq!(voxels(&scene_from(name, &bytes, &options(64)).unwrap()), found, "{name}");
    }
}

#[test]
fn a_glb_brings_picture_light_roughness_unit_and_camera() {
    let scene = scene_from("house.glb", &mesh_samples::glb(), &options(64)).unwrap();
    assert_eq!((scene.unit, scene.voxel_size), (Unit::Metre, 4.0 / 64.0));
    let material = |voxel: [i32; 3]| scene.materials[usize::from(scene.grids[0].get(voxel.into()).unwrap())];
    // The picture's rows run from the top: at the foot of the left wall is its lower left texel.
    assert_eq!(material([0, 1, 1]).base_color, Vec3::Z);
    assert_eq!(material([0, 1, 30]).base_color, Vec3::X);
    assert!((material([0, 1, 1]).emission - Vec3::new(0.2, 0.0, 0.0)).abs().max_element() < 1e-3);
    assert_eq!((material([0, 1, 1]).roughness, material([0, 1, 1]).metallic), (0.75, 0.0));
    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.eye), ("eye", Vec3::new(32.0, -9.0 * 16.0, 16.0)));
    assert!(camera.target.y > camera.eye.y && (camera.fov_y - 0.8f32.to_degrees()).abs() < 1e-3);
}

#[test]
fn a_gltf_s_texture_of_roughness_and_metalness_is_read_and_others_are_named() {
    let compact: String = String::from_utf8(mesh_samples::gltf()).unwrap().split_whitespace().collect();
    let read = |from: &str, to: &str| {
        let text = compact.replacen(from, to, 1);
        assert_ne!(text, compact);
        let loaded = import::load_bytes(text.as_bytes(), Path::new("a.gltf"), &options(64)).unwrap();
        (loaded.notes, loaded.content.into_scene())
    };
    let surface = |scene: &Scene, voxel: [i32; 3]| {
        let material = scene.materials[usize::from(scene.grids[0].get(voxel.into()).unwrap())];
        (material.roughness, material.metallic)
    };
    // Blue at the foot of the wall is metal, red above is not, and neither has green, which would be rough.
    let textured = "\"metallicFactor\":1,\"metallicRoughnessTexture\":{\"index\":0}";
    let (notes, scene) = read("\"metallicFactor\":0", textured);
    assert_eq!((surface(&scene, [0, 1, 1]), surface(&scene, [0, 1, 30])), ((0.0, 1.0), (0.0, 0.0)));
    assert!(notes.is_empty(), "{notes:?}");
    // One on other coordinates cannot be: then its factors would make all of it metal.
    let other = "\"metallicFactor\":1,\"metallicRoughnessTexture\":{\"index\":0,\"texCoord\":1}";
    let (notes, scene) = read("\"metallicFactor\":0", other);
    assert_eq!((surface(&scene, [0, 1, 1]), notes.len()), ((1.0, 0.0), 1));
    let glassy = "\"extensions\":{\"KHR_materials_transmission\":{\"transmissionFactor\":1,\"transmissionTexture\":{\"index\":0}},";
    let (notes, _) = read("\"extensions\":{\"KHR_materials", &format!("{glassy}\"KHR_materials"));
    assert!(notes.iter().any(|note| note.contains("textures of transmission are left out (1 material)")), "{notes:?}");
    // What is not lit is matte here, whatever its factors, which are metal where they are not said.
    let (_, scene) =
        read("\"extensions\":{\"KHR_materials", "\"extensions\":{\"KHR_materials_unlit\":{},\"KHR_materials");
    assert_eq!(surface(&scene, [0, 1, 1]), (1.0, 0.0));
}

#[test]
fn the_axis_that_points_up_can_be_told() {
    let size = |name: &str, bytes: &[u8], up| {
        let options = ImportOptions { up, ..options(64) };
        scene_from(name, bytes, &options).unwrap().grids[0].bounds().unwrap().size()
    };
    assert_eq!(size("a.obj", &mesh_samples::obj(), None), IVec3::new(64, 48, 52));
    assert_eq!(size("a.obj", &mesh_samples::obj(), Some(UpAxis::Z)), IVec3::new(64, 52, 48));
    assert_eq!(size("a.obj", &mesh_samples::obj(), Some(UpAxis::X)), IVec3::new(48, 52, 64));
    assert_eq!(size("a.glb", &mesh_samples::glb(), Some(UpAxis::Y)), IVec3::new(64, 48, 52));
    assert_eq!(size("a.glb", &mesh_samples::glb(), Some(UpAxis::Z)), IVec3::new(64, 52, 48));
}

#[test]
fn a_file_cut_at_any_byte_is_read_or_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            check::check(name, &bytes[..length]);
            if name.ends_with("glb") || name == "binary.stl" || name == "little.ply" || name == "big.ply" {
                let error = scene_from(name, &bytes[..length], &options(8)).unwrap_err();
                assert!(error.offset.is_some_and(|offset| offset <= length as u64), "{name} {length}: {error}");
            }
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error() {
    let numbers = [0, 1, 255, 65_535, 0x7fff_ffff, 0x8000_0000, u32::MAX, f32::NAN.to_bits(), f32::INFINITY.to_bits()];
    let texts = ["nan", "inf", "-1", "1e400", "1e38", "99999999999", "-99999", "null", "\"\"", "[]", "{}", " ", "\n"];
    let mut random = Random(3);
    for (name, bytes) in samples().into_iter().chain([("moving.gltf", mesh_samples::moving_gltf())]) {
        for _ in 0..1_500 {
            check::check(name, &damaged(&bytes, &numbers, &texts, |end| random.below(end)));
        }
    }
}

#[test]
fn sixteen_megabytes_of_noise_are_refused_in_every_format() {
    let mut random = Random(4);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    let options = options(8);
    for (name, head) in [
        ("a.glb", &b"glTF\x02\0\0\0"[..]),
        ("a.gltf", b"{\"asset\":"),
        ("a.obj", b"v 0 0 0\n"),
        (
            "a.ply",
            b"ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\n\
            property float z\nelement face 9\nproperty list uint int vertex_indices\nend_header\n",
        ),
        ("a.stl", b"solid"),
        ("b.stl", b""),
    ] {
        noise[..head.len()].copy_from_slice(head);
        assert!(import::mesh_from_bytes(&noise, Path::new(name), &options).is_err(), "{name}");
    }
}

#[test]
fn the_corpora_of_the_fuzz_targets_hold_the_samples_and_are_clean() {
    let mut samples = samples();
    samples.push(("moving.gltf", mesh_samples::moving_gltf()));
    for (target, extensions) in
        [("gltf", &["glb", "gltf"][..]), ("obj", &["obj"]), ("ply", &["ply"]), ("stl", &["stl"])]
    {
        let own = samples.iter().filter(|(name, _)| extensions.iter().any(|extension| name.ends_with(extension)));
        corpus::replay(target, own, |bytes| check::check(&format!("fuzzed.{target}"), bytes));
    }
}

#[test]
fn a_gltf_that_names_files_outside_its_folder_is_refused() {
    let outer = tempfile::tempdir().unwrap();
    let inner = outer.path().join("scene");
    fs::create_dir(&inner).unwrap();
    let text = String::from_utf8(mesh_samples::gltf()).unwrap();
    let start = text.find("data:").unwrap();
    let end = start + text[start..].find('"').unwrap();
    let secret = outer.path().join("house.bin");
    fs::write(&secret, vec![0; 4096]).unwrap();
    fs::write(inner.join("house.bin"), vec![0; 4096]).unwrap();
    let open = |uri: &str| {
        let path = inner.join("house.gltf");
        fs::write(&path, format!("{}{uri}{}", &text[..start], &text[end..])).unwrap();
        import::open(&path, &options(8))
    };
    let absolute = secret.display().to_string();
    for uri in ["../house.bin", "%2e%2e/house.bin", "%2E%2E%2fhouse.bin", "x/../../house.bin", &absolute] {
        for uri in [uri.to_owned(), format!("file://{uri}"), format!("file:{uri}")] {
            let error = open(&uri).unwrap_err();
            assert!(error.to_string().contains("leads out of the scene's folder"), "{uri}: {error}");
        }
    }
    // The same name inside the folder is read: all corners are then one point.
    let error = open("house.bin").unwrap_err();
    assert!(error.to_string().contains("no surface"), "{error}");
    let error = open("missing.bin").unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Io(_)), "{error}");
}

#[test]
fn a_gltf_behind_the_mark_of_a_text_is_the_same() {
    let marked = [b"\xef\xbb\xbf", &mesh_samples::gltf()[..]].concat();
    let read = |bytes: &[u8]| voxels(&scene_from("a.gltf", bytes, &options(8)).unwrap());
    assert_eq!(read(&marked), read(&mesh_samples::gltf()));
    let error = scene_from("a.gltf", b"\xef\xbb\xbf[]", &options(8)).unwrap_err();
    assert!(error.offset.is_some_and(|offset| (3..=5).contains(&offset)), "{error}");
}

#[test]
fn a_gltf_that_wants_what_is_not_read_names_the_extension() {
    let text = String::from_utf8(mesh_samples::gltf()).unwrap();
    for name in ["KHR_texture_basisu", "VENDOR_whatever"] {
        let required = text.replacen('{', &format!("{{ \"extensionsRequired\": [\"{name}\"],"), 1);
        let error = scene_from("a.gltf", required.as_bytes(), &options(8)).unwrap_err();
        assert!(matches!(&error.kind, ImportErrorKind::Unsupported(what) if what.contains(name)), "{error}");
    }
    for name in ["KHR_mesh_quantization", "KHR_texture_transform", "EXT_meshopt_compression", "EXT_texture_webp"] {
        let known = text.replacen('{', &format!("{{ \"extensionsRequired\": [\"{name}\"],"), 1);
        assert!(scene_from("a.gltf", known.as_bytes(), &options(8)).is_ok(), "{name}");
    }
    // A texture may name its picture in an extension alone.
    let compact: String = text.split_whitespace().collect();
    let named = compact.replacen("\"source\":0", "\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}", 1);
    let foreign = compact.replacen("\"source\":0", "\"extensions\":{\"KHR_texture_basisu\":{\"source\":0}}", 1);
    assert!(named != compact && foreign != compact);
    let scene = |text: &str| scene_from("a.gltf", text.as_bytes(), &options(8)).unwrap();
    assert_eq!(scene(&named), scene(&compact));
    assert_ne!(scene(&foreign), scene(&compact));
    // What is packed and cannot be unpacked is an error.
    let view = "{ \"buffer\": 0, \"byteLength\": 96, \"byteStride\": 12, \"count\": 8, \"mode\": \"ATTRIBUTES\" }";
    for (member, extension, wanted) in [
        ("\"bufferViews\": [ {", format!("\"EXT_meshopt_compression\": {view}"), "without their header"),
        (
            "\"primitives\": [ {",
            "\"KHR_draco_mesh_compression\": { \"bufferView\": 0, \"attributes\": {} }".to_owned(),
            "KHR_draco_mesh_compression",
        ),
    ] {
        let compact = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let packed = compact.replacen(member, &format!("{member} \"extensions\": {{ {extension} }},"), 1);
        assert_ne!(packed, compact, "{member}");
        let error = scene_from("a.gltf", packed.as_bytes(), &options(8)).unwrap_err();
        assert!(error.to_string().contains(wanted), "{error}");
    }
}

#[test]
fn a_glb_whose_arrays_stay_in_the_file_until_they_are_needed_is_that_in_memory_whole_and_damaged() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("house.glb");
    let (whole, mut random) = (mesh_samples::glb(), Random(77));
    let told = |result: Result<Mesh, ImportError>| match result {
        // Numbers that are none are not equal to themselves.
        Ok(mesh) => format!("{mesh:?}"),
        Err(error) => error.to_string(),
    };
    let (mut read, mut refused, mut found) = (0, 0, Vec::new());
    for round in 0..600 {
        let mut bytes = damaged(&whole, &[0, 1, 5126, u32::MAX], &["9", "-1", "null"], |end| random.below(end));
        match round {
            0 => bytes.clone_from(&whole),
            1..40 => bytes.truncate(random.below(whole.len())),
            _ => {}
        }
        fs::write(&path, &bytes).unwrap();
        let of_file = import::read_mesh(&path, &options(8));
        if of_file.is_ok() {
            read += 1
        } else {
            refused += 1
        }
        let of_file = told(of_file);
        assert!(of_file == told(import::mesh_from_bytes(&bytes, &path, &options(8))), "round {round}: {of_file:.400}");
        found.push(of_file);
    }
    assert!(read > 20 && refused > 20, "{read} {refused}");
    found.dedup();
    assert!(found.len() > 50, "the comparison sees another mesh or fault: {}", found.len());
}

#[test]
fn a_gltf_of_more_files_than_stay_open_is_read() {
    let (folder, count) = (tempfile::tempdir().unwrap(), 70);
    let list = |each: fn(usize) -> String| (0..count).map(each).collect::<Vec<_>>().join(",");
    for number in 0..count {
        let x = number as f32;
        let corners = [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
        let bytes: Vec<u8> = corners.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
        fs::write(folder.path().join(format!("{number}.bin")), bytes).unwrap();
    }
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{}]}}],
        "accessors":[{}],"bufferViews":[{}],"buffers":[{}]}}"#,
        list(|number| format!(r#"{{"attributes":{{"POSITION":{number}}}}}"#)),
        list(|number| format!(r#"{{"bufferView":{number},"componentType":5126,"count":3,"type":"VEC3"}}"#)),
        list(|number| format!(r#"{{"buffer":{number},"byteLength":36}}"#)),
        list(|number| format!(r#"{{"uri":"{number}.bin","byteLength":36}}"#)),
    );
    let path = folder.path().join("many.gltf");
    fs::write(&path, text).unwrap();
    let mesh = import::read_mesh(&path, &options(8)).unwrap();
    let place = |number: usize| mesh.positions[3 * number].x - mesh.positions[0].x;
    assert_eq!(mesh.triangles.len(), count);
    assert!((0..count).all(|number| place(number) == number as f32));
}

#[test]
fn nodes_that_go_in_circles_or_too_deep_are_refused() {
    let text = String::from_utf8(mesh_samples::gltf()).unwrap();
    let circle = text.replacen("\"mesh\": 0", "\"mesh\": 0, \"children\": [0]", 1);
    assert!(scene_from("a.gltf", circle.as_bytes(), &options(8)).unwrap_err().to_string().contains("two parents"));
    let mut document: serde_json::Value = serde_json::from_str(&text).unwrap();
    let depth = 200;
    document["nodes"] = (0..depth).map(|n| serde_json::json!({ "children": [n + 1] })).collect();
    document["nodes"].as_array_mut().unwrap().push(serde_json::json!({ "mesh": 0 }));
    let error = scene_from("a.gltf", document.to_string().as_bytes(), &options(8)).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
}

#[test]
fn each_limit_holds() {
    for (name, bytes) in samples() {
        for limits in [
            Limits { bytes: bytes.len() as u64 - 1, ..Limits::default() },
            Limits { points: 9, ..Limits::default() },
            Limits { voxels: 50, ..Limits::default() },
        ] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join(name);
            fs::write(&path, &bytes).unwrap();
            let error = import::open(&path, &ImportOptions { limits, ..options(64) }).unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{name} {limits:?}: {error}");
        }
    }
}

const EXTENSIONS: [&str; 5] = ["glb", "gltf", "obj", "ply", "stl"];

#[test]
fn every_shared_mesh_is_read_or_says_why_not() {
    let Some(data) = data() else { return };
    let files = files_below(&data.join("mesh"), &EXTENSIONS);
    let mut read = 0;
    for path in &files {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        match import::open(path, &options(100)) {
            Ok(scene) => {
                // Clouds of a few points are as many voxels.
                let least = if name.contains("point") { 1 } else { 100 };
                assert!(scene.grids[0].count() > least, "{name}");
                read += 1;
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(read >= 30, "{read}");
}

#[test]
fn every_malformed_mesh_is_an_error_or_voxels_as_decided() {
    let Some(data) = data() else { return };
    let files = files_below(&data.join("malformed"), &EXTENSIONS);
    // These are whole enough: materials that are missing or empty, odd indices that exist, a face without corners, an empty solid after a full one.
    let readable = [
        "OBJ_empty_mat.obj",
        "STL_triangle_with_empty_solid.stl",
        "trimesh_negative_indices.obj",
        "trimesh_polygonfaces.obj",
        "trimesh_singlevn.obj",
        "trimesh_wallhole.obj",
        "assimp_malformed2.obj",
        // Points and lines without faces; scans whose faults are in records that say nothing about the points.
        "trimesh_obj_points.obj",
        "trimesh_obj_wireframe.obj",
        "trimesh_ply_points_ascii.ply",
        "trimesh_ply_points_bin.ply",
        "trimesh_points_ascii_with_lists.ply",
        "trimesh_points_emptyface.ply",
        "pdal_issue_2421.ply",
        "pdal_0-0-0-0.laz",
        "pdal_1.2-empty-geotiff-vlrs.las",
        "pdal_bad-geotiff-keys.las",
        "pdal_bad_vlr_count.las",
        "pdal_gps-time-nan.las",
        "pdal_hextest.las",
        "pdal_lots_of_vlr.las",
        "pdal_wontcompress3.las",
    ];
    let mut surprises = Vec::new();
    assert!(files.len() > 30);
    for path in files {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let result = import::open(&path, &options(50));
        match &result {
            Ok(scene) => println!("{name}: {} voxels", scene.grids[0].count()),
            Err(error) => println!("{error}"),
        }
        if result.is_ok() != readable.contains(&name.as_str()) {
            surprises.push(name);
        }
    }
    assert!(surprises.is_empty(), "{surprises:?}");
}
