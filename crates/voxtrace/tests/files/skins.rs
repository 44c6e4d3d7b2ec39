//! Skins of glTF: vertices are where the joints take them, whatever the node of the mesh says; of an animation, what carries all joints carries the mesh.

use serde_json::{Value, json};
use std::f64::consts::FRAC_1_SQRT_2;
use std::path::Path;
use voxtrace::glam::Vec3;
use voxtrace::import::{self, ClipChoice, Geometry, ImportOptions};
use voxtrace::mesh::Mesh;

pub const BYTE: u32 = 5121;
pub const SHORT: u32 = 5123;
pub const FLOAT: u32 = 5126;

/// A binary glTF file in the making.
pub struct File {
    pub json: Value,
    pub binary: Vec<u8>,
}

impl File {
    /// Adds an array; returns the number of its accessor.
    pub fn add(&mut self, kind: &str, (component, normalized): (u32, bool), count: usize, bytes: &[u8]) -> usize {
        let views = self.json["bufferViews"].as_array_mut().unwrap();
        views.push(json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() }));
        let view = views.len() - 1;
        self.binary.extend(bytes);
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let accessors = self.json["accessors"].as_array_mut().unwrap();
        accessors.push(json!({
            "bufferView": view, "componentType": component, "normalized": normalized, "count": count, "type": kind,
        }));
        accessors.len() - 1
    }

    pub fn add_floats(&mut self, kind: &str, count: usize, numbers: &[f32]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.add(kind, (FLOAT, false), count, &bytes)
    }

    pub fn attributes(&mut self) -> &mut Value {
        &mut self.json["meshes"][0]["primitives"][0]["attributes"]
    }

    /// Adds joints and their shares for each vertex, as attributes of a set.
    pub fn bind(&mut self, set: usize, (joint_kind, weight_kind): (u32, u32), vertices: &[([u16; 4], [f32; 4])]) {
        let joints = vertices.iter().flat_map(|(joints, _)| joints);
        let joints: Vec<u8> = match joint_kind {
            BYTE => joints.map(|&joint| joint as u8).collect(),
            _ => joints.flat_map(|joint| joint.to_le_bytes()).collect(),
        };
        let weights = vertices.iter().flat_map(|(_, weights)| weights);
        // Whole numbers do not add up to the largest one, as they ought to.
        let weights: Vec<u8> = match weight_kind {
            BYTE => weights.map(|&weight| (weight * 100.0) as u8).collect(),
            SHORT => weights.flat_map(|&weight| ((weight * 40_000.0) as u16).to_le_bytes()).collect(),
            _ => weights.flat_map(|&weight| weight.to_le_bytes()).collect(),
        };
        let joints = self.add("VEC4", (joint_kind, false), vertices.len(), &joints);
        let weights = self.add("VEC4", (weight_kind, weight_kind != FLOAT), vertices.len(), &weights);
        self.attributes()[format!("JOINTS_{set}")] = json!(joints);
        self.attributes()[format!("WEIGHTS_{set}")] = json!(weights);
    }

    /// An animation of a property of a node.
    fn animate<const N: usize>(&mut self, node: usize, path: &str, values: [[f32; N]; 2]) {
        let times = self.add_floats("SCALAR", 2, &[0.0, 1.0]);
        let values = self.add_floats(&format!("VEC{N}"), 2, values.as_flattened());
        self.json["animations"] = json!([{
            "channels": [{ "sampler": 0, "target": { "node": node, "path": path } }],
            "samplers": [{ "input": times, "output": values }],
        }]);
    }

    pub fn bytes(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"] = json!([{ "byteLength": self.binary.len() }]);
        let mut json = json.to_string().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let word = |value: usize| (value as u32).to_le_bytes();
        let length = 12 + 8 + json.len() + 8 + self.binary.len();
        let head = [*b"glTF", word(2), word(length), word(json.len()), *b"JSON"].concat();
        [&head[..], &json, &word(self.binary.len()), b"BIN\0", &self.binary].concat()
    }

    pub fn read(&self, animation: ClipChoice) -> Mesh {
        let options = ImportOptions { animation, ..ImportOptions::default() };
        import::mesh_from_bytes(&self.bytes(), Path::new("arm.glb"), &options).unwrap()
    }

    pub fn fault(&self) -> String {
        import::mesh_from_bytes(&self.bytes(), Path::new("arm.glb"), &ImportOptions::default()).unwrap_err().to_string()
    }
}

/// An arm up to 2 along y, without shares: the second of its joints is at 1, stood there when it was bound, and is turned to the left by a quarter.
/// The first joint is at x = 3, and the node of the arm somewhere else and mirrored.
fn arm() -> File {
    let arrays = json!({ "bufferViews": [], "accessors": [] });
    let mut file = File { json: arrays, binary: Vec::new() };
    let corners = [[0.0f32, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 2.0, 0.0], [1.0, 2.0, 0.0]];
    let positions = file.add_floats("VEC3", 4, corners.as_flattened());
    let faces: Vec<u8> = [0u16, 1, 2, 2, 1, 3].iter().flat_map(|corner| corner.to_le_bytes()).collect();
    let faces = file.add("SCALAR", (SHORT, false), 6, &faces);
    let mut matrices = [[0.0f32; 16]; 2];
    for matrix in &mut matrices {
        [0, 5, 10, 15].into_iter().for_each(|diagonal| matrix[diagonal] = 1.0);
    }
    matrices[1][13] = -1.0;
    let matrices = file.add_floats("MAT4", 2, matrices.as_flattened());
    let more = json!({
        "asset": { "version": "2.0" },
        "scenes": [{ "nodes": [0, 1] }],
        "nodes": [
            { "mesh": 0, "skin": 0, "translation": [50, 60, 70], "scale": [2, 2, -2] },
            { "translation": [3, 0, 0], "children": [2] },
            { "translation": [0, 1, 0], "rotation": [0, 0, FRAC_1_SQRT_2, FRAC_1_SQRT_2] },
        ],
        "skins": [{ "joints": [1, 2], "inverseBindMatrices": matrices }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": positions }, "indices": faces }] }],
    });
    file.json.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    file
}

/// The second vertex follows both joints. What has no share may name joints that are not there.
const SHARES: [([u16; 4], [f32; 4]); 4] = [
    ([0, 9, 9, 9], [1.0, 0.0, 0.0, 0.0]),
    ([0, 1, 9, 9], [0.5, 0.5, 0.0, 0.0]),
    ([9, 9, 1, 0], [0.0, 0.0, 1.0, 0.0]),
    ([1, 0, 0, 0], [1.0, 0.0, 0.0, 0.0]),
];

/// Where they are then, z up.
const POSED: [Vec3; 4] =
    [Vec3::new(3.0, 0.0, 0.0), Vec3::new(2.75, 0.0, 1.25), Vec3::new(2.0, 0.0, 1.0), Vec3::new(2.0, 0.0, 2.0)];

/// Where they are by their node alone.
const AT_NODE: [[f32; 3]; 4] = [[50.0, -70.0, 60.0], [50.0, -70.0, 63.0], [50.0, -70.0, 64.0], [52.0, -70.0, 64.0]];

fn bound() -> File {
    let mut file = arm();
    file.bind(0, (BYTE, FLOAT), &SHARES);
    file
}

fn assert_at(mesh: &Mesh, wanted: &[Vec3]) {
    let is_same = mesh.positions.iter().zip(wanted).all(|(found, wanted)| found.abs_diff_eq(*wanted, 1e-5));
    assert!(mesh.positions.len() == wanted.len() && is_same, "{:?}, not {wanted:?}", mesh.positions);
}

#[test]
fn vertices_are_where_their_joints_take_them_and_not_where_the_node_is() {
    for kinds in [(BYTE, FLOAT), (SHORT, FLOAT), (BYTE, BYTE), (SHORT, SHORT)] {
        let mut file = arm();
        file.bind(0, kinds, &SHARES);
        let mesh = file.read(ClipChoice::None);
        assert_at(&mesh, &POSED);
        assert_eq!(mesh.triangles, [[0, 1, 2], [2, 1, 3]], "the mirror of the node is none");
        assert!(mesh.notes.is_empty(), "{:?}", mesh.notes);
    }
    // A second set has what the first has no room for.
    let mut file = arm();
    let (mut first, mut second) = (SHARES, [([0; 4], [0.0; 4]); 4]);
    first[1].1 = [0.5, 0.0, 0.0, 0.0];
    second[1] = ([1, 0, 0, 0], [0.5, 0.0, 0.0, 0.0]);
    file.bind(0, (BYTE, FLOAT), &first);
    file.bind(1, (SHORT, FLOAT), &second);
    assert_at(&file.read(ClipChoice::None), &POSED);
    // Where nobody has a share, the first joint has all.
    let mut file = arm();
    let mut shares = SHARES;
    shares[3].1 = [0.0; 4];
    file.bind(0, (BYTE, FLOAT), &shares);
    assert_at(&file.read(ClipChoice::None), &POSED);
    // Without matrices the mesh was bound where the joints have their own origins.
    let mut file = bound();
    file.json["skins"][0].as_object_mut().unwrap().remove("inverseBindMatrices");
    let wanted = [POSED[0], Vec3::new(2.25, 0.0, 1.25), Vec3::new(1.0, 0.0, 1.0), Vec3::new(1.0, 0.0, 2.0)];
    assert_at(&file.read(ClipChoice::None), &wanted);
    // What names no joint has nothing but its node.
    assert_at(&arm().read(ClipChoice::None), &AT_NODE.map(Vec3::from));
}

#[test]
fn joints_without_shares_and_shares_without_joints_place_nothing_which_is_told() {
    for missing in ["WEIGHTS_0", "JOINTS_0"] {
        let mut file = bound();
        file.attributes().as_object_mut().unwrap().remove(missing);
        let mesh = file.read(ClipChoice::None);
        assert_at(&mesh, &AT_NODE.map(Vec3::from));
        assert_eq!(mesh.notes, ["not shown: 1 skin"], "{missing}");
    }
    // Those of a second set count for nothing.
    for missing in ["WEIGHTS_1", "JOINTS_1"] {
        let mut file = bound();
        file.bind(1, (BYTE, FLOAT), &SHARES);
        file.attributes().as_object_mut().unwrap().remove(missing);
        let mesh = file.read(ClipChoice::None);
        assert_at(&mesh, &POSED);
        assert!(mesh.notes.is_empty(), "{:?}", mesh.notes);
    }
}

#[test]
fn joints_outside_of_the_scene_and_mirrored_ones_place_vertices_too() {
    let mut file = bound();
    file.json["scenes"][0]["nodes"] = json!([0]);
    assert_at(&file.read(ClipChoice::None), &POSED);
    file.json["nodes"][1]["scale"] = json!([1, 1, -1]);
    let mesh = file.read(ClipChoice::None);
    assert_at(&mesh, &POSED);
    assert_eq!(mesh.triangles, [[0, 2, 1], [2, 3, 1]]);
}

#[test]
fn points_follow_joints_as_triangles_do() {
    let mut file = bound();
    file.json["meshes"][0]["primitives"][0]["mode"] = json!(0);
    let read = import::geometry_from_bytes(&file.bytes(), Path::new("arm.glb"), &ImportOptions::default()).unwrap();
    let Geometry::Points(cloud) = read else { panic!("they are points") };
    assert_eq!(cloud.positions.len(), 4);
    assert!(cloud.positions.iter().zip(POSED).all(|(found, wanted)| found.abs_diff_eq(wanted, 1e-5)));
}

#[test]
fn a_mesh_goes_with_what_carries_all_of_its_joints_and_one_that_bends_has_shapes() {
    let mut file = bound();
    file.animate(1, "translation", [[3.0, 0.0, 0.0], [5.0, 0.0, 0.0]]);
    let mesh = file.read(ClipChoice::First);
    assert!(mesh.triangles.is_empty() && mesh.notes.is_empty(), "{:?}", mesh.notes);
    let parts = mesh.moving.as_ref().unwrap();
    assert_eq!(parts.meshes.len(), 1);
    assert_at(&parts.meshes[0], &POSED.map(|at| at - 3.0 * Vec3::X));
    assert_eq!(mesh.clips[0].motion.as_ref().unwrap().instances.len(), 1);
    // It may have no size at rest.
    let mut file = bound();
    file.json["nodes"][1]["scale"] = json!([0, 0, 0]);
    file.animate(1, "scale", [[0.0; 3], [1.0; 3]]);
    let mesh = file.read(ClipChoice::First);
    assert_at(&mesh.moving.as_ref().unwrap().meshes[0], &POSED.map(|at| at - 3.0 * Vec3::X));
    // The node of the mesh takes it nowhere.
    let mut file = bound();
    file.animate(0, "translation", [[50.0, 60.0, 70.0], [0.0; 3]]);
    let mesh = file.read(ClipChoice::First);
    assert_at(&mesh, &POSED);
    assert!(mesh.moving.is_none() && mesh.notes.is_empty(), "{:?}", mesh.notes);
    // One joint alone bends it: it stands still in the world, and changes its shape.
    let mut file = bound();
    let quarter = FRAC_1_SQRT_2 as f32;
    file.animate(2, "rotation", [[0.0, 0.0, quarter, quarter], [0.0, 0.0, 0.0, 1.0]]);
    let mesh = file.read(ClipChoice::First);
    assert!(mesh.triangles.is_empty() && mesh.notes.is_empty(), "{:?}", mesh.notes);
    let parts = mesh.moving.as_ref().unwrap();
    assert_at(&parts.meshes[0], &POSED);
    let changing = &parts.changing[0];
    assert_eq!((parts.changing.len(), changing.part, changing.rate, changing.steps.len()), (1, 0, 24.0, 25));
    let straight = [POSED[0], Vec3::new(3.0, 0.0, 1.5), Vec3::new(3.0, 0.0, 2.0), Vec3::new(4.0, 0.0, 2.0)];
    for (step, wanted) in [(0, POSED), (24, straight)] {
        let positions = changing.shapes.positions(changing.steps[step] as usize);
        assert!(positions.iter().zip(wanted).all(|(found, wanted)| found.abs_diff_eq(wanted, 1e-5)), "{positions:?}");
    }
    // A still shows the skin.
    assert_eq!(file.read(ClipChoice::None).notes, ["not shown: 1 animation"]);
    let later = file.read(ClipChoice::Later);
    assert_eq!((later.notes.len(), later.positions), (0, file.read(ClipChoice::None).positions));
}

#[test]
fn faults_of_skins_are_named() {
    type Edit = fn(&mut File);
    let faults: [(&str, Edit); 8] = [
        ("skin 7 is missing", |file| file.json["nodes"][0]["skin"] = json!(7)),
        ("skin 0 has node 8 for a joint, which is missing", |file| file.json["skins"][0]["joints"] = json!([1, 8])),
        ("skin 0 has 2 inverse bind matrices for 3 joints", |file| file.json["skins"][0]["joints"] = json!([1, 2, 0])),
        ("a vertex names joint 1 of 1 of skin 0", |file| file.json["skins"][0]["joints"] = json!([1])),
        ("skin 0 has no joints", |file| file.json["skins"][0]["joints"] = json!([])),
        ("holds VEC3, not MAT4", |file| file.json["skins"][0]["inverseBindMatrices"] = json!(0)),
        ("JOINTS_0 holds no indices", |file| {
            let weights = file.attributes()["WEIGHTS_0"].clone();
            file.attributes()["JOINTS_0"] = weights;
        }),
        // A circle of nodes outside of the scene.
        ("skin 0 has node 1 for a joint, which has more than", |file| {
            file.json["scenes"][0]["nodes"] = json!([0]);
            file.json["nodes"][2]["children"] = json!([1]);
        }),
    ];
    for (wanted, edit) in faults {
        let mut file = bound();
        edit(&mut file);
        let fault = file.fault();
        assert!(fault.contains(wanted), "{fault}, not {wanted}");
    }
    let mut file = arm();
    let mut shares = SHARES;
    shares[2].1[2] = f32::NAN;
    file.bind(0, (BYTE, FLOAT), &shares);
    assert!(file.fault().contains("not finite"), "{}", file.fault());
    let mut file = arm();
    file.bind(0, (BYTE, FLOAT), &SHARES[..3]);
    assert!(file.fault().contains("3 attributes for 4 vertices"), "{}", file.fault());
    // Nobody wears it.
    let mut file = bound();
    file.json["nodes"][0].as_object_mut().unwrap().remove("skin");
    file.json["skins"][0]["joints"] = json!([100]);
    file.read(ClipChoice::None);
}

#[test]
fn a_file_with_a_skin_is_read_as_a_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("arm.glb");
    let opens = |file: &File| {
        std::fs::write(&path, file.bytes()).unwrap();
        import::open_large(&path, &ImportOptions::default(), 1).unwrap().is_some()
    };
    assert!(!opens(&bound()) && opens(&arm()));
}
