//! Small mesh files of every kind: one house of two triangles for each wall, with what each format can say about it.

use serde_json::{Value, json};

/// Corners of a box with a ridge, z up.
pub const CORNERS: [[f32; 3]; 10] = [
    [0.0, 0.0, 0.0],
    [4.0, 0.0, 0.0],
    [4.0, 3.0, 0.0],
    [0.0, 3.0, 0.0],
    [0.0, 0.0, 2.0],
    [4.0, 0.0, 2.0],
    [4.0, 3.0, 2.0],
    [0.0, 3.0, 2.0],
    [0.0, 1.5, 3.25],
    [4.0, 1.5, 3.25],
];

/// Triangles of the house, outwards.
pub const TRIANGLES: [[u32; 3]; 16] = [
    [0, 2, 1],
    [0, 3, 2],
    [0, 1, 5],
    [0, 5, 4],
    [2, 3, 7],
    [2, 7, 6],
    [1, 2, 6],
    [1, 6, 5],
    [3, 0, 4],
    [3, 4, 7],
    [4, 5, 9],
    [4, 9, 8],
    [6, 7, 8],
    [6, 8, 9],
    [5, 6, 9],
    [7, 4, 8],
];

/// The files: name and bytes.
pub fn samples() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("house.glb", glb()),
        ("house.gltf", gltf()),
        ("house.obj", obj()),
        ("text.ply", ply("ascii")),
        ("little.ply", ply("binary_little_endian")),
        ("big.ply", ply("binary_big_endian")),
        ("text.stl", stl_text()),
        ("binary.stl", stl_binary()),
    ]
}

/// The house as OBJ, with polygons, texture coordinates and vertex colours; y is up.
pub fn obj() -> Vec<u8> {
    let mut text = String::from("# a house\nmtllib house.mtl\no house\n");
    for [x, y, z] in CORNERS {
        text += &format!("v {x} {z} {} 0.8 0.7 0.6\n", -y);
    }
    text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nusemtl wall\ns off\n";
    text += "f 1/1/1 4/4/1 3/3/1 2/2/1\n";
    for [a, b, c] in &TRIANGLES[2..10] {
        text += &format!("f {}/1 {}/2 {}/3\n", a + 1, b + 1, c + 1);
    }
    text += "usemtl roof\nf -6//1 -5//1 -1//1 -2//1\nf 7 8 9 \\\n 10\nf 6 7 10\nf 8 5 9\n";
    text.into_bytes()
}

/// The house as PLY.
pub fn ply(format: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {format} 1.0\ncomment a house\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        CORNERS.len(),
        TRIANGLES.len()
    )
    .into_bytes();
    let is_big = format.ends_with("big_endian");
    for [x, y, z] in CORNERS {
        if format == "ascii" {
            bytes.extend(format!("{x} {y} {z} 200 150 100\n").bytes());
        } else {
            bytes.extend([x, y, z].map(|v| if is_big { v.to_be_bytes() } else { v.to_le_bytes() }).as_flattened());
            bytes.extend([200, 150, 100]);
        }
    }
    for triangle in TRIANGLES {
        if format == "ascii" {
            bytes.extend(format!("3 {} {} {}\n", triangle[0], triangle[1], triangle[2]).bytes());
        } else {
            bytes.push(3);
            bytes.extend(triangle.map(|v| if is_big { v.to_be_bytes() } else { v.to_le_bytes() }).as_flattened());
        }
    }
    bytes
}

/// The house as STL in words.
pub fn stl_text() -> Vec<u8> {
    let mut text = String::from("solid house\n");
    for triangle in TRIANGLES {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in triangle.map(|corner| CORNERS[corner as usize]) {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text += "endsolid house\n";
    text.into_bytes()
}

/// The house as STL in bytes.
pub fn stl_binary() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((TRIANGLES.len() as u32).to_le_bytes());
    for triangle in TRIANGLES {
        bytes.extend([0; 12]);
        for corner in triangle {
            bytes.extend(CORNERS[corner as usize].map(f32::to_le_bytes).as_flattened());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Corners as glTF has them: y up.
fn corner_bytes() -> Vec<u8> {
    CORNERS.iter().flat_map(|&[x, y, z]| [x, z, -y]).flat_map(f32::to_le_bytes).collect()
}

fn index_bytes() -> Vec<u8> {
    TRIANGLES.as_flattened().iter().flat_map(|&corner| (corner as u16).to_le_bytes()).collect()
}

/// A picture of 2 × 2 texels.
fn picture() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(png::ColorType::Rgb);
    let pixels = [255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255];
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    bytes
}

fn document(buffer: Value, picture_size: usize) -> Value {
    let (corners, indices, uvs) = (corner_bytes().len(), index_bytes().len(), CORNERS.len() * 8);
    json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [
            { "name": "root", "children": [1, 2], "scale": [1, 1, 1], "rotation": [0, 0, 0, 1] },
            { "name": "house", "mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] },
            { "name": "eye", "camera": 0, "translation": [2, 1, 9] },
        ],
        "cameras": [{ "type": "perspective", "perspective": { "yfov": 0.8, "znear": 0.1 } }],
        "meshes": [{ "primitives": [
            { "attributes": { "POSITION": 0, "TEXCOORD_0": 2 }, "indices": 1, "material": 0 },
        ] }],
        "materials": [{
            "name": "wall",
            "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0, "roughnessFactor": 0.75 },
            "emissiveFactor": [0.1, 0, 0],
            "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 2 } },
        }],
        "textures": [{ "source": 0, "sampler": 0 }],
        "samplers": [{ "magFilter": 9728, "wrapS": 33071, "wrapT": 33648 }],
        "images": [{ "bufferView": 3, "mimeType": "image/png" }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": CORNERS.len(), "type": "VEC3" },
            { "bufferView": 1, "componentType": 5123, "count": TRIANGLES.len() * 3, "type": "SCALAR" },
            { "bufferView": 2, "componentType": 5126, "count": CORNERS.len(), "type": "VEC2" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": corners },
            { "buffer": 0, "byteOffset": corners, "byteLength": indices },
            { "buffer": 0, "byteOffset": corners + indices, "byteLength": uvs },
            { "buffer": 0, "byteOffset": corners + indices + uvs, "byteLength": picture_size },
        ],
        "buffers": [buffer],
    })
}

fn binary() -> (Vec<u8>, usize) {
    let uvs = CORNERS.iter().flat_map(|&[x, y, z]| [(x + y) / 7.0, 1.0 - z / 3.25]).flat_map(f32::to_le_bytes);
    let picture = picture();
    let bytes = [corner_bytes(), index_bytes(), uvs.collect(), picture.clone()].concat();
    (bytes, picture.len())
}

/// The house as binary glTF, with a picture, light and a camera.
pub fn glb() -> Vec<u8> {
    let (mut binary, picture_size) = binary();
    let mut json = document(json!({ "byteLength": binary.len() }), picture_size).to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let mut bytes = b"glTF".to_vec();
    let word = |bytes: &mut Vec<u8>, value: usize| bytes.extend((value as u32).to_le_bytes());
    word(&mut bytes, 2);
    word(&mut bytes, 12 + 8 + json.len() + 8 + binary.len());
    word(&mut bytes, json.len());
    bytes.extend(b"JSON");
    bytes.extend(&json);
    word(&mut bytes, binary.len());
    bytes.extend(b"BIN\0");
    bytes.extend(&binary);
    bytes
}

/// The house as glTF with everything in one text.
pub fn gltf() -> Vec<u8> {
    let (bytes, picture_size) = binary();
    text_of(document(Value::Null, picture_size), &bytes)
}

/// The house as glTF with a second one that slides in steps, turns by splines and grows, and a camera that goes along.
pub fn moving_gltf() -> Vec<u8> {
    let (mut bytes, picture_size) = binary();
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let mut document = document(Value::Null, picture_size);
    let times = [0.0f32, 0.5, 1.0];
    let places = [[9.0f32, 0.0, 0.0], [9.0, 2.0, 1.0], [12.0, 0.0, 0.0]];
    // Tangents on both sides of each rotation.
    let turns = (0..9).map(|at| if at % 3 == 1 { [0.0f32, 0.1 * at as f32, 0.0, 1.0] } else { [0.2, 0.0, 0.0, 0.0] });
    let turns = turns.collect::<Vec<_>>();
    let parts = [(&times[..], "SCALAR"), (places.as_flattened(), "VEC3"), (turns.as_flattened(), "VEC4")];
    for (numbers, kind) in parts {
        let width = if kind == "SCALAR" { 1 } else { kind[3..].parse().unwrap() };
        let list = |name: &str| document[name].as_array().unwrap().len();
        let (view, start) = (list("bufferViews"), bytes.len());
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        let length = bytes.len() - start;
        let count = numbers.len() / width;
        let views = document["bufferViews"].as_array_mut().unwrap();
        views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": length }));
        let accessors = document["accessors"].as_array_mut().unwrap();
        accessors.push(json!({ "bufferView": view, "componentType": 5126, "count": count, "type": kind }));
    }
    let nodes = document["nodes"].as_array_mut().unwrap();
    nodes[0]["children"] = json!([1, 3]);
    nodes.push(json!({ "name": "other", "mesh": 0, "children": [2], "translation": [9, 0, 0] }));
    let channel = |sampler: u32, path: &str| json!({ "sampler": sampler, "target": { "node": 3, "path": path } });
    document["animations"] = json!([{
        "name": "go",
        "channels": [channel(0, "translation"), channel(1, "rotation"), channel(2, "scale")],
        "samplers": [
            { "input": 3, "output": 4, "interpolation": "STEP" },
            { "input": 3, "output": 5, "interpolation": "CUBICSPLINE" },
            { "input": 3, "output": 4 },
        ],
    }]);
    text_of(document, &bytes)
}

/// A document with its one buffer, as one text.
fn text_of(mut document: Value, bytes: &[u8]) -> Vec<u8> {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::from("data:application/octet-stream;base64,");
    for part in bytes.chunks(3) {
        let word = part.iter().fold(0u32, |word, &byte| word << 8 | u32::from(byte)) << (8 * (3 - part.len()));
        for at in 0..4 {
            let sign = SIGNS[(word >> (18 - 6 * at) & 63) as usize] as char;
            text.push(if at <= part.len() { sign } else { '=' });
        }
    }
    document["buffers"] = json!([{ "uri": text, "byteLength": bytes.len() }]);
    format!("{document:#}").into_bytes()
}
