//! Binary glTF files that stay in their file while they become voxels: the same bytes as from memory, whatever the budget.

use crate::meshes;
use serde_json::json;
use std::path::{Path, PathBuf};
use voxtrace::glam::Vec3;
use voxtrace::import::{self, ImportOptions, LargeGeometry, Limits};
use voxtrace::mesh::{Mesh, UpAxis};
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions, VoxelizeProgress, voxelize_to_file};

/// A binary glTF file of two balls, far from the origin, the second mirrored, each with a ribbon of another material and lines
/// that are left out. What the ball looks like: one colour, or colours of its vertices over a picture in the file.
fn glb(folder: &Path, has_looks: bool) -> PathBuf {
    let Mesh { positions: corners, triangles, .. } = meshes::sphere(Vec3::ZERO, 30.0, 60);
    let mut binary: Vec<u8> = Vec::new();
    for corner in &corners {
        binary.extend(corner.to_array().iter().flat_map(|value| value.to_le_bytes()));
        binary.extend(corner.to_array().map(|value| (value * 3.0 + 128.0) as u8));
        binary.push(255);
        binary.extend([corner.x, corner.z].iter().flat_map(|v| (((v / 90.0 + 0.5) * 65_535.0) as u16).to_le_bytes()));
    }
    let views = [binary.len()];
    binary.extend(triangles.iter().flatten().flat_map(|at| at.to_le_bytes()));
    let ribbon: Vec<u16> = (0..=120).flat_map(|i| [3600 + i % 120, 3720 + i % 120]).collect();
    let views = [views[0], binary.len()];
    binary.extend(ribbon.iter().flat_map(|at| at.to_le_bytes()));
    let views = [views[0], views[1], binary.len()];
    let mut encoder = png::Encoder::new(&mut binary, 64, 64);
    encoder.set_color(png::ColorType::Rgb);
    let texels: Vec<u8> = (0..64 * 64u32).flat_map(|at| [at as u8, (at >> 4) as u8, 200]).collect();
    encoder.write_header().unwrap().write_image_data(&texels).unwrap();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let count = corners.len();
    let attributes =
        if has_looks { json!({ "POSITION": 0, "COLOR_0": 1, "TEXCOORD_0": 2 }) } else { json!({ "POSITION": 0 }) };
    let mut ball = json!({ "baseColorFactor": [0.3, 0.6, 0.1, 1.0], "metallicFactor": 0.5 });
    if has_looks {
        ball["baseColorTexture"] = json!({ "index": 0 });
    }
    let document = json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "byteLength": binary.len() }],
        "bufferViews": [
            { "buffer": 0, "byteLength": views[0], "byteStride": 20 },
            { "buffer": 0, "byteOffset": views[0], "byteLength": views[1] - views[0] },
            { "buffer": 0, "byteOffset": views[1], "byteLength": views[2] - views[1] },
            { "buffer": 0, "byteOffset": views[2], "byteLength": binary.len() - views[2] },
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3" },
            { "bufferView": 0, "byteOffset": 12, "componentType": 5121, "normalized": true, "count": count, "type": "VEC4" },
            { "bufferView": 0, "byteOffset": 16, "componentType": 5123, "normalized": true, "count": count, "type": "VEC2" },
            { "bufferView": 1, "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR" },
            { "bufferView": 2, "componentType": 5123, "count": ribbon.len(), "type": "SCALAR" },
        ],
        "images": [{ "bufferView": 3, "mimeType": "image/png" }],
        "textures": [{ "source": 0 }],
        "materials": [
            { "pbrMetallicRoughness": ball },
            { "emissiveFactor": [0.5, 0.25, 0.0], "pbrMetallicRoughness": { "baseColorFactor": [0.9, 0.1, 0.2, 1.0] } },
        ],
        "meshes": [{ "primitives": [
            { "attributes": attributes, "indices": 3, "material": 0 },
            { "attributes": { "POSITION": 0 }, "indices": 4, "mode": 5, "material": 1 },
            { "attributes": { "POSITION": 0 }, "mode": 1 },
        ] }],
        "nodes": [
            { "children": [1, 2], "translation": [5000.0, 7.0, -3.0], "rotation": [0.1, 0.2, 0.3, 0.9] },
            { "mesh": 0 },
            { "mesh": 0, "scale": [-1.0, 1.5, 1.0], "translation": [0.0, 0.0, 90.0] },
        ],
        "scenes": [{ "nodes": [0] }],
    });
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((28 + text.len() as u32 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    let path = folder.join(if has_looks { "looks.glb" } else { "plain.glb" });
    std::fs::write(&path, bytes).unwrap();
    path
}

/// A binary file as a text with its arrays in a file beside it.
fn as_text(path: &Path) -> PathBuf {
    let bytes = std::fs::read(path).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let mut document: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    document["buffers"][0]["uri"] = "arrays%20of%20it.bin".into();
    let text = path.with_extension("gltf");
    std::fs::write(&text, document.to_string()).unwrap();
    std::fs::write(path.with_file_name("arrays of it.bin"), &bytes[20 + length + 8..]).unwrap();
    text
}

/// The file that comes of a mesh that is read at once.
fn from_memory(path: &Path, import: &ImportOptions, options: &VoxelizeOptions) -> Vec<u8> {
    let mesh = import::read_mesh(path, import).unwrap();
    let out = path.with_extension("memory.vxt");
    voxelize_to_file(mesh, options, &Limits::default(), &out, &VoxelizeProgress::default()).unwrap();
    std::fs::read(out).unwrap()
}

fn open(path: &Path, import: &ImportOptions) -> LargeGeometry {
    import::open_large(path, import, 1).unwrap().expect("the file is not read piece by piece")
}

/// Files that fuzzing starts from: a house as text and binary, and packed by Draco and meshopt.
fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/gltf")
}

#[test]
fn gltf_that_stays_in_its_file_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let (plain, looks) = (glb(folder.path(), false), glb(folder.path(), true));
    let text = as_text(&looks);
    for path in [plain, looks, text] {
        for (rule, scale, up) in [
            (SurfaceRule::Conservative, Scale::Resolution(250), None),
            (SurfaceRule::Thin, Scale::VoxelSize(0.5), Some(UpAxis::MinusX)),
        ] {
            let import = ImportOptions { up, ..ImportOptions::default() };
            let options = VoxelizeOptions { rule, scale, ..VoxelizeOptions::default() };
            let expected = from_memory(&path, &import, &options);
            for memory_budget in [Some(1), Some(1 << 20), None] {
                let out = path.with_extension("large.vxt");
                let options = VoxelizeOptions { memory_budget, ..options };
                let mut large = open(&path, &import);
                let progress = VoxelizeProgress::default();
                let written = large.voxelize_to_file(&options, &Limits::default(), &out, &progress).unwrap();
                assert!(std::fs::read(&out).unwrap() == expected, "{} {rule:?} {memory_budget:?}", path.display());
                assert_eq!((progress.done(), progress.total()), (2 * large.count(), 2 * large.count()));
                assert_eq!(large.notes(), ["2 primitives that are no triangles are left out"]);
                let ratio = large.estimate(&options).unwrap().voxels as f64 / written.voxels as f64;
                assert!((0.9..1.3).contains(&ratio), "{rule:?}: {ratio}");
            }
        }
    }
}

#[test]
fn a_house_of_gltf_that_stays_in_its_file_keeps_its_camera_and_its_picture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("house.glb");
    std::fs::copy(corpus().join("house.glb"), &path).unwrap();
    let options = VoxelizeOptions { scale: Scale::Resolution(64), ..VoxelizeOptions::default() };
    for up in [None, Some(UpAxis::Y), Some(UpAxis::MinusZ)] {
        let import = ImportOptions { up, ..ImportOptions::default() };
        let expected = from_memory(&path, &import, &options);
        let out = folder.path().join("large.vxt");
        let mut large = open(&path, &import);
        large.voxelize_to_file(&options, &Limits::default(), &out, &VoxelizeProgress::default()).unwrap();
        assert!(std::fs::read(&out).unwrap() == expected, "{up:?}");
        let scene = voxtrace::PackedScene::open(&out).unwrap();
        assert!(scene.cameras.len() == 1 && scene.materials().len() > 2);
    }
}

#[test]
fn gltf_that_is_not_plain_or_not_whole_is_left_to_the_reader_of_all_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.glb");
    let opens = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        import::open_large(&path, &ImportOptions::default(), 1).unwrap().is_some()
    };
    for file in std::fs::read_dir(corpus()).unwrap().map(|entry| entry.unwrap().path()) {
        let is_plain = opens(&std::fs::read(&file).unwrap());
        assert_eq!(is_plain, file.ends_with("house.glb"), "{}", file.display());
    }
    // As a text: with one file beside it that is there, whole and in its folder.
    let text = std::fs::read_to_string(as_text(&glb(folder.path(), true))).unwrap();
    assert!(opens(text.as_bytes()));
    for (from, to) in [
        ("arrays%20of%20it.bin", "none.bin"),
        ("arrays%20of%20it.bin", "../arrays of it.bin"),
        ("\"buffers\":[", "\"buffers\":[{\"byteLength\":1},"),
    ] {
        assert!(text.contains(from) && !opens(text.replace(from, to).as_bytes()), "{to}");
    }
    std::fs::write(folder.path().join("arrays of it.bin"), [0; 100]).unwrap();
    assert!(!opens(text.as_bytes()));
    let whole = std::fs::read(glb(folder.path(), true)).unwrap();
    assert!(opens(&whole));
    for length in (0..whole.len()).step_by(997) {
        assert!(!opens(&whole[..length]), "{length}");
    }
    // The last vertex of the ribbon, behind which the picture begins, is one that is not there.
    let at = whole.windows(8).position(|bytes| bytes == b"\x89PNG\r\n\x1a\n").unwrap();
    let mut wrong = whole.clone();
    wrong[at - 2..at].copy_from_slice(&u16::MAX.to_le_bytes());
    assert!(opens(&wrong));
    let (mut large, out) = (open(&path, &ImportOptions::default()), folder.path().join("out.vxt"));
    let options = VoxelizeOptions::default();
    let error = large.voxelize_to_file(&options, &Limits::default(), &out, &VoxelizeProgress::default()).unwrap_err();
    assert!(error.to_string().contains("a triangle names vertex 65535 of 7320"), "{error}");
}
