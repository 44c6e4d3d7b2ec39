//! The same points in every format, written here, and what tests of them share.

#![allow(dead_code, reason = "each test uses some")]

use super::compressed_points::compressed;
use super::meshes::Random;
use std::io::Cursor;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, Geometry, ImportError, ImportOptions, Limits};
use voxtrace::material::{linear_from_srgb, srgb_from_linear};
use voxtrace::points::PointCloud;
use voxtrace::voxelize::{PointOptions, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, voxelize_points};

/// Points on quarters of a metre, far from the origin: position, colour, intensity, class.
pub type Point = ([i32; 3], [u8; 3], u16, u8);
pub const FAR: [f64; 3] = [691_000.0, 5_335_000.0, 500.0];

pub fn sample() -> Vec<Point> {
    let mut random = Random(7);
    let mut byte = move |end: usize| random.below(end);
    (0..300)
        .map(|_| {
            let place = [byte(64) as i32, byte(48) as i32, byte(20) as i32];
            (place, [byte(256) as u8, byte(256) as u8, 1 + byte(255) as u8], byte(4000) as u16, 1 + byte(9) as u8)
        })
        .collect()
}

/// A LAS file; `kind` is the version's minor number and the format of its points.
pub fn las(points: &[Point], (minor, format): (u8, u8)) -> Vec<u8> {
    let size: u16 = if minor >= 4 { 375 } else { 227 };
    let record: u16 = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67][usize::from(format)];
    let mut bytes = vec![0; usize::from(size)];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, minor]);
    put(94, &size.to_le_bytes());
    put(96, &u32::from(size).to_le_bytes());
    put(104, &[format]);
    put(105, &record.to_le_bytes());
    put(if minor >= 4 { 247 } else { 107 }, &(points.len() as u32).to_le_bytes());
    for (axis, far) in FAR.iter().enumerate() {
        put(131 + 8 * axis, &0.25f64.to_le_bytes());
        put(155 + 8 * axis, &far.to_le_bytes());
    }
    for (place, color, intensity, class) in points {
        let start = bytes.len();
        bytes.resize(start + usize::from(record), 0);
        let mut put = |at: usize, value: &[u8]| bytes[start + at..][..value.len()].copy_from_slice(value);
        put(0, place.map(i32::to_le_bytes).as_flattened());
        put(12, &intensity.to_le_bytes());
        put(if format >= 6 { 16 } else { 15 }, &[*class]);
        let color_at = match format {
            2 => 20,
            3 | 5 => 28,
            _ => 30,
        };
        put(color_at, color.map(|byte| (u16::from(byte) * 257).to_le_bytes()).as_flattened());
    }
    bytes
}

/// The same points compressed, by the crate that others write LAZ with.
pub fn laz(points: &[Point], (minor, format): (u8, u8)) -> Vec<u8> {
    compressed(&las(points, (minor, format)), format, 100)
}

pub fn text(points: &[Point]) -> Vec<u8> {
    let mut text = String::from("x,y,z,red,green,blue,intensity,class\n");
    for (place, [r, g, b], intensity, class) in points {
        let [x, y, z] = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        text += &format!("{x},{y},{z},{r},{g},{b},{intensity},{class}\n");
    }
    text.into_bytes()
}

pub fn ply(points: &[Point]) -> Vec<u8> {
    ply_with(points, "uchar", |byte| vec![byte])
}

/// As [`ply`], with the same bytes of colours as floating-point numbers.
pub fn float_ply(points: &[Point]) -> Vec<u8> {
    ply_with(points, "float", |byte| f32::from(byte).to_le_bytes().to_vec())
}

fn ply_with(points: &[Point], kind: &str, channel: fn(u8) -> Vec<u8>) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
        property double z\nproperty {kind} red\nproperty {kind} green\nproperty {kind} blue\nend_header\n",
        points.len()
    )
    .into_bytes();
    for (place, color, ..) in points {
        for (far, steps) in FAR.iter().zip(place) {
            bytes.extend((far + f64::from(*steps) * 0.25).to_le_bytes());
        }
        bytes.extend(color.iter().flat_map(|&byte| channel(byte)));
    }
    bytes
}

/// The points as Gaussian splats: small, opaque discs in the colours of the points; and a haze, which is left out.
pub fn splats(points: &[Point]) -> Vec<u8> {
    let names = "x y z nx ny nz f_dc_0 f_dc_1 f_dc_2 f_rest_0 opacity scale_0 scale_1 scale_2 rot_0 rot_1 rot_2 rot_3";
    let properties: String = names.split(' ').map(|name| format!("property float {name}\n")).collect();
    let count = points.len() + 1;
    let mut bytes = format!("ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}end_header\n");
    let mut bytes = std::mem::take(&mut bytes).into_bytes();
    let haze = ([1_000_000; 3], [255; 3], 0, 0);
    for (at, (place, color, ..)) in points.iter().chain([&haze]).enumerate() {
        let opacity = if at == points.len() { -3.0 } else { 2.0 };
        let place = place.map(|steps| steps as f32 * 0.25);
        let harmonics = color.map(|byte| (f32::from(byte) / 255.0 - 0.5) / 0.282_094_8);
        let numbers =
            [&place[..], &[0.0; 3], &harmonics, &[0.3, opacity, -5.0, -5.0, -9.0, 2.0, 0.0, 0.0, 0.0]].concat();
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    }
    bytes
}

/// Vertices with colours, and no faces; y is up.
pub fn obj(points: &[Point]) -> Vec<u8> {
    let mut text = String::from("# a scan\nvn 0 0 1\n");
    for (place, color, ..) in points {
        let [x, y, z] = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        let [r, g, b] = color.map(|byte| f64::from(byte) / 255.0);
        text += &format!("v {x} {z} {} {r:.4} {g:.4} {b:.4}\n", -y);
    }
    text.into_bytes()
}

pub fn pcd(points: &[Point], data: &str) -> Vec<u8> {
    let count = points.len();
    let mut bytes = format!(
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z _ rgb intensity label\nSIZE 8 8 8 1 4 2 1\n\
        TYPE F F F U U U U\nCOUNT 1 1 1 3 1 1 1\nWIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\n\
        DATA {data}\n"
    )
    .into_bytes();
    // Bytes of each field; compressed files keep each field together.
    let mut fields: [Vec<Vec<u8>>; 7] = Default::default();
    for (place, [r, g, b], intensity, class) in points {
        let position = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        let color = u32::from_be_bytes([0, *r, *g, *b]);
        if data == "ascii" {
            let [x, y, z] = position;
            bytes.extend(format!("{x} {y} {z} 0 0 0 {color} {intensity} {class}\n").into_bytes());
        }
        (0..3).for_each(|axis| fields[axis].push(position[axis].to_le_bytes().into()));
        fields[3].push(vec![7; 3]);
        fields[4].push(color.to_le_bytes().into());
        fields[5].push(intensity.to_le_bytes().into());
        fields[6].push(vec![*class]);
    }
    match data {
        "binary" => (0..count).for_each(|n| fields.iter().for_each(|field| bytes.extend(&field[n]))),
        "binary_compressed" => {
            let plain: Vec<u8> = fields.iter().flatten().flatten().copied().collect();
            let packed: Vec<u8> = plain.chunks(32).flat_map(|run| [&[run.len() as u8 - 1], run].concat()).collect();
            bytes.extend((packed.len() as u32).to_le_bytes());
            bytes.extend((plain.len() as u32).to_le_bytes());
            bytes.extend(packed);
        }
        _ => {}
    }
    bytes
}

/// A binary glTF file of points alone; y is up, the node stands far out, and colours are linear.
pub fn glb(points: &[Point]) -> Vec<u8> {
    let mut binary = Vec::new();
    for (place, color, ..) in points {
        let [x, y, z] = place.map(|steps| steps as f32 * 0.25);
        let [r, g, b] = color.map(linear_from_srgb);
        binary.extend([x, z, -y, r, g, b].iter().flat_map(|number| number.to_le_bytes()));
    }
    let count = points.len();
    let primitive = serde_json::json!({ "mode": 0, "attributes": { "POSITION": 0, "COLOR_0": 1 } });
    gltf(&binary, count, primitive, [FAR[0], FAR[2], -FAR[1]])
}

/// A binary glTF file of a primitive, whose vertices are positions and colours.
pub fn gltf(binary: &[u8], count: usize, primitive: serde_json::Value, translation: [f64; 3]) -> Vec<u8> {
    let document = serde_json::json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "byteLength": binary.len() }],
        "bufferViews": [{ "buffer": 0, "byteLength": binary.len(), "byteStride": 24 }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3" },
            { "bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": count, "type": "VEC3" },
        ],
        "materials": [{ "pbrMetallicRoughness": { "baseColorFactor": [0.5, 1.0, 1.0, 1.0] } }],
        "meshes": [{ "primitives": [primitive] }],
        "nodes": [{ "mesh": 0, "translation": translation }],
    });
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = 12 + 8 + json.len() + 8 + binary.len();
    let head = [&b"glTF"[..], &2u32.to_le_bytes(), &(length as u32).to_le_bytes()].concat();
    let chunk = |kind: &[u8; 4], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat();
    [head, chunk(b"JSON", &json), chunk(b"BIN\0", binary)].concat()
}

/// Written by the crate, at a pose that adds [`FAR`].
pub fn e57(points: &[Point]) -> Vec<u8> {
    use e57::{E57Writer, Record, RecordDataType, RecordName, RecordValue, Transform};
    let mut out = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut out, "file").unwrap();
    let steps = RecordDataType::ScaledInteger { min: 0, max: 63, scale: 0.25, offset: 0.0 };
    let place = [RecordName::CartesianX, RecordName::CartesianY, RecordName::CartesianZ];
    let mut prototype: Vec<Record> = place.into_iter().map(|name| Record { name, data_type: steps.clone() }).collect();
    prototype.extend([Record::COLOR_RED_U8, Record::COLOR_GREEN_U8, Record::COLOR_BLUE_U8, Record::INTENSITY_U16]);
    let mut scan = writer.add_pointcloud("scan", prototype).unwrap();
    let mut pose = Transform::default();
    (pose.translation.x, pose.translation.y, pose.translation.z) = (FAR[0], FAR[1], FAR[2]);
    scan.set_transform(Some(pose));
    for (place, color, intensity, _) in points {
        let mut values: Vec<RecordValue> =
            place.iter().map(|&steps| RecordValue::ScaledInteger(steps.into())).collect();
        values.extend(color.iter().map(|&byte| RecordValue::Integer(byte.into())));
        values.push(RecordValue::Integer((*intensity).into()));
        scan.add_point(values).unwrap();
    }
    scan.finalize().unwrap();
    writer.finalize().unwrap();
    drop(writer);
    out.into_inner()
}

pub fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let points = sample();
    vec![
        ("a.las", las(&points, (2, 2))),
        ("b.las", las(&points, (2, 3))),
        ("c.las", las(&points, (4, 7))),
        ("a.laz", laz(&points, (2, 2))),
        ("b.laz", laz(&points, (2, 3))),
        ("c.laz", laz(&points, (4, 7))),
        ("a.csv", text(&points)),
        ("a.ply", ply(&points)),
        ("a.obj", obj(&points)),
        ("a.glb", glb(&points)),
        ("text.pcd", pcd(&points, "ascii")),
        ("plain.pcd", pcd(&points, "binary")),
        ("packed.pcd", pcd(&points, "binary_compressed")),
        ("a.e57", e57(&points)),
    ]
}

pub fn read(name: &str, bytes: &[u8], limits: Limits) -> Result<PointCloud, ImportError> {
    let options = ImportOptions { limits, ..ImportOptions::default() };
    match import::geometry_from_bytes(bytes, Path::new(name), &options)? {
        Geometry::Points(cloud) => Ok(cloud),
        Geometry::Mesh(_) => panic!("{name} is a cloud of points"),
    }
}

pub fn options(scale: Scale, points: PointOptions) -> VoxelizeOptions {
    VoxelizeOptions { scale, points, ..VoxelizeOptions::default() }
}

pub fn scene_of(cloud: &PointCloud, options: &VoxelizeOptions) -> Result<Scene, VoxelizeError> {
    voxelize_points(cloud, options, &Limits::default(), &VoxelizeProgress::default())
}

pub fn voxels(scene: &Scene) -> Vec<(IVec3, [u8; 3])> {
    let color = |material: u16| scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
    scene.grids[0].voxels().map(|(voxel, material)| (voxel, color(material))).collect()
}
