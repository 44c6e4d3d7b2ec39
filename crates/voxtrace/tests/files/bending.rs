//! glTF meshes that change their shape: voxels of skins that bend and of morph targets at many times, against boxes that are placed here. Each check
//! is shown a wrong answer, too.

use crate::skins::{BYTE, FLOAT, File, SHORT};
use serde_json::json;
use std::collections::BTreeSet;
use std::f32::consts::FRAC_1_SQRT_2;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::animation::{Animation, Playback};
use voxtrace::glam::{DQuat, DVec3, Vec3};
use voxtrace::import::{self, ClipChoice, ImportOptions, Limits};
use voxtrace::mesh::Mesh;
use voxtrace::voxelize::{Scale, VoxelizeOptions, VoxelizeProgress, voxelize, voxelize_with_progress};

/// Edge of a voxel.
const VOXEL: f64 = 0.25;
/// Lowest corner of everything at rest in all files here, z up.
const CORNER: DVec3 = DVec3::new(0.0, -1.0, 0.0);

/// A file of boxes in one mesh, with a node for it.
fn boxes(boxes: &[[[f32; 3]; 2]]) -> File {
    let mut file = File { json: json!({ "bufferViews": [], "accessors": [] }), binary: Vec::new() };
    let corners: Vec<[f32; 3]> = boxes
        .iter()
        .flat_map(|ends| (0..8).map(|corner| std::array::from_fn(|axis| ends[corner >> axis & 1][axis])))
        .collect();
    let sides = [[0u16, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces: Vec<u8> = (0..boxes.len() as u16)
        .flat_map(|number| sides.map(|side| side.map(|corner| corner + 8 * number)))
        .flat_map(|[a, b, c, d]| [a, b, c, a, c, d])
        .flat_map(u16::to_le_bytes)
        .collect();
    let positions = file.add_floats("VEC3", corners.len(), corners.as_flattened());
    let faces = file.add("SCALAR", (SHORT, false), 36 * boxes.len(), &faces);
    let more = json!({
        "asset": { "version": "2.0" },
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "name": "thing" }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": positions }, "indices": faces }] }],
        "animations": [{ "name": "bends", "channels": [], "samplers": [] }],
    });
    file.json.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    file
}

/// A box of 2 × 2 × 1.
fn block() -> File {
    boxes(&[[[0.0; 3], [2.0, 2.0, 1.0]]])
}

/// A bar of two boxes along y, which follow a joint at 0 and one at 4; nodes 1 and 2.
fn bar() -> File {
    let mut file = boxes(&[[[0.0; 3], [1.0, 4.0, 1.0]], [[0.0, 4.0, 0.0], [1.0, 8.0, 1.0]]]);
    let shares: Vec<_> = (0..16u16).map(|corner| ([corner / 8, 0, 0, 0], [1.0, 0.0, 0.0, 0.0])).collect();
    file.bind(0, (BYTE, FLOAT), &shares);
    let mut matrices = [[0.0f32; 16]; 2];
    for matrix in &mut matrices {
        [0, 5, 10, 15].into_iter().for_each(|diagonal| matrix[diagonal] = 1.0);
    }
    matrices[1][13] = -4.0;
    let matrices = file.add_floats("MAT4", 2, matrices.as_flattened());
    file.json["skins"] = json!([{ "joints": [1, 2], "inverseBindMatrices": matrices }]);
    file.json["scenes"] = json!([{ "nodes": [0, 1] }]);
    file.json["nodes"] = json!([
        { "mesh": 0, "skin": 0, "name": "bar" },
        { "name": "root", "children": [2] },
        { "name": "elbow", "translation": [0, 4, 0] },
    ]);
    file
}

/// Adds a target that moves vertices.
fn morph(file: &mut File, offsets: &[[f32; 3]]) {
    let offsets = file.add_floats("VEC3", offsets.len(), offsets.as_flattened());
    let primitive = file.json["meshes"][0]["primitives"][0].as_object_mut().unwrap();
    let targets = primitive.entry("targets").or_insert(json!([]));
    targets.as_array_mut().unwrap().push(json!({ "POSITION": offsets }));
}

/// Offsets of the vertices of boxes, of those on the far side of an axis of the last box.
fn stretched(boxes: usize, axis: usize, by: f32) -> Vec<[f32; 3]> {
    let is_moved = |corner: usize| corner / 8 + 1 == boxes && corner >> axis & 1 == 1;
    let offset = |corner| std::array::from_fn(|at| if at == axis && is_moved(corner) { by } else { 0.0 });
    (0..8 * boxes).map(offset).collect()
}

/// Adds a channel to the animation.
fn animate(
    file: &mut File,
    (node, path, kind): (usize, &str, &str),
    interpolation: &str,
    times: &[f32],
    values: &[f32],
) {
    let width = match kind {
        "SCALAR" => 1,
        "VEC3" => 3,
        _ => 4,
    };
    let input = file.add_floats("SCALAR", times.len(), times);
    let output = file.add_floats(kind, values.len() / width, values);
    let animation = &mut file.json["animations"][0];
    let samplers = animation["samplers"].as_array_mut().unwrap();
    samplers.push(json!({ "input": input, "output": output, "interpolation": interpolation }));
    let sampler = samplers.len() - 1;
    let channel = json!({ "sampler": sampler, "target": { "node": node, "path": path } });
    animation["channels"].as_array_mut().unwrap().push(channel);
}

/// The second joint turns by a quarter to the left within a second.
fn turn(file: &mut File) {
    let turns = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2];
    animate(file, (2, "rotation", "VEC4"), "LINEAR", &[0.0, 1.0], &turns);
}

/// The mesh of a file, with so many shapes a second of its animation, or none of it.
fn mesh(file: &File, shapes: Option<f64>) -> Mesh {
    let animation = if shapes.is_some() { ClipChoice::First } else { ClipChoice::None };
    let options = ImportOptions { animation, shape_rate: shapes, ..ImportOptions::default() };
    import::mesh_from_bytes(&file.bytes(), Path::new("thing.glb"), &options).unwrap()
}

fn options() -> VoxelizeOptions {
    VoxelizeOptions { scale: Scale::VoxelSize(VOXEL), ..VoxelizeOptions::default() }
}

fn scene(file: &File, shapes: f64) -> Scene {
    voxelize(&mesh(file, Some(shapes)), &options(), &Limits::default()).unwrap()
}

/// A box in the file's axes, turned about an axis along z.
#[derive(Clone, Copy)]
struct Turned {
    low: DVec3,
    high: DVec3,
    pivot: DVec3,
    degrees: f64,
}

impl Turned {
    fn still(low: [f64; 3], high: [f64; 3]) -> Self {
        Self { low: low.into(), high: high.into(), pivot: DVec3::ZERO, degrees: 0.0 }
    }

    fn turn(&self) -> DQuat {
        DQuat::from_rotation_z(self.degrees.to_radians())
    }

    /// Places all over the surface.
    fn places(&self) -> Vec<DVec3> {
        let grid = (0..17 * 17).map(|at| (f64::from(at % 17) / 16.0, f64::from(at / 17) / 16.0));
        let on_sides = grid.flat_map(|(u, v)| {
            (0..6).map(move |side| {
                let end = f64::from(side / 3);
                [DVec3::new(end, u, v), DVec3::new(u, end, v), DVec3::new(u, v, end)][side as usize % 3]
            })
        });
        let placed = |share: DVec3| self.pivot + self.turn() * (self.low + share * (self.high - self.low) - self.pivot);
        on_sides.map(placed).collect()
    }

    fn distance(&self, place: DVec3) -> f64 {
        let own = self.pivot + self.turn().inverse() * (place - self.pivot);
        own.distance(own.clamp(self.low, self.high))
    }
}

/// The two boxes of the bar, the second one turned and so much longer, both moved along x.
fn bent(degrees: f64, longer: f64, along: f64) -> [Turned; 2] {
    let lower = Turned::still([along, 0.0, 0.0], [along + 1.0, 4.0, 1.0]);
    let upper = Turned::still([along, 4.0, 0.0], [along + 1.0, 8.0 + longer, 1.0]);
    [lower, Turned { pivot: DVec3::new(along, 4.0, 0.0), degrees, ..upper }]
}

/// A place of the file in voxels of the world.
fn in_voxels(place: DVec3) -> Vec3 {
    ((DVec3::new(place.x, -place.z, place.y) - CORNER) / VOXEL).as_vec3()
}

fn at(scene: &Scene, clip: Playback, seconds: f64) -> Scene {
    Animation { clip, ..Animation::default() }.scene_at(scene, seconds)
}

/// Whether a place of the file, or one beside it that rounding may make of it, is in a voxel.
fn is_seen(now: &Scene, place: DVec3) -> bool {
    now.instances.iter().filter(|instance| !instance.hidden).any(|instance| {
        let own = instance.world_from_grid.inverse().point(in_voxels(place));
        (0..8).any(|bits| {
            let offset = Vec3::from_array([0, 1, 2].map(|axis| if bits >> axis & 1 == 1 { 0.05 } else { -0.05 }));
            now.grids[instance.grid].get((own + offset).floor().as_ivec3()).is_some()
        })
    })
}

/// Whether the voxels of a scene are those of boxes: their surfaces are in voxels, and no voxel is elsewhere.
fn are_voxels_of(now: &Scene, boxes: &[Turned]) -> bool {
    let mut count = 0;
    for instance in now.instances.iter().filter(|instance| !instance.hidden) {
        for (voxel, _) in now.grids[instance.grid].voxels() {
            let middle = instance.world_from_grid.point(voxel.as_vec3() + 0.5).as_dvec3() * VOXEL + CORNER;
            let place = DVec3::new(middle.x, middle.z, -middle.y);
            if boxes.iter().all(|own| own.distance(place) > 0.9 * VOXEL) {
                return false;
            }
            count += 1;
        }
    }
    count > 100 && boxes.iter().flat_map(Turned::places).all(|place| is_seen(now, place))
}

#[test]
fn a_joint_that_turns_takes_its_half_of_a_bar_along_step_by_step() {
    let mut file = bar();
    turn(&mut file);
    let scene = scene(&file, 4.0);
    let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
    assert_eq!(names, ["bar"], "one object, whatever shape it has");
    let once = |seconds: f64| at(&scene, Playback::Once, seconds);
    let wanted = [(0.0, 0.0), (0.25, 22.5), (0.3, 22.5), (0.5, 45.0), (0.74, 45.0), (1.0, 90.0), (7.0, 90.0)];
    for (seconds, degrees) in wanted {
        assert!(are_voxels_of(&once(seconds), &bent(degrees, 0.0, 0.0)), "{seconds} s");
    }
    // Five degrees off, the other way round, about another pivot, and late by a step.
    assert!(!are_voxels_of(&once(0.5), &bent(40.0, 0.0, 0.0)) && !are_voxels_of(&once(1.0), &bent(-90.0, 0.0, 0.0)));
    let [lower, upper] = bent(90.0, 0.0, 0.0);
    assert!(!are_voxels_of(&once(1.0), &[lower, Turned { pivot: DVec3::ZERO, ..upper }]));
    assert!(!are_voxels_of(&once(0.5), &bent(22.5, 0.0, 0.0)));
    let again = |seconds: f64| at(&scene, Playback::Repeated, seconds);
    for (seconds, degrees) in [(1.5, 45.0), (2.0, 0.0), (5.25, 22.5)] {
        assert!(are_voxels_of(&again(seconds), &bent(degrees, 0.0, 0.0)), "{seconds} s, repeated");
    }
    assert!(again(1.5) == once(0.5) && once(1.5) == once(1.0));
    // At rest it has the voxels of the still.
    let of = |scene: &Scene| -> BTreeSet<[i32; 3]> {
        let placed = |instance: &voxtrace::Instance| {
            let corner = instance.world_from_grid.translation.round().as_ivec3();
            let voxels = scene.grids[instance.grid].voxels().map(move |(voxel, _)| (voxel + corner).to_array());
            voxels.collect::<Vec<_>>()
        };
        scene.instances.iter().flat_map(placed).collect()
    };
    let still = voxelize(&mesh(&file, None), &options(), &Limits::default()).unwrap();
    assert!(of(&once(0.0)) == of(&still) && of(&once(0.25)) != of(&still));
}

#[test]
fn what_bends_and_is_carried_moves_between_its_steps() {
    let mut file = bar();
    turn(&mut file);
    animate(&mut file, (1, "translation", "VEC3"), "LINEAR", &[0.0, 1.0], &[0.0, 0.0, 0.0, 8.0, 0.0, 0.0]);
    let scene = scene(&file, 4.0);
    let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
    assert_eq!(names, ["root"], "that which carries all joints carries the bar");
    for (seconds, degrees) in [(0.0, 0.0), (0.5, 45.0), (0.6, 45.0), (1.0, 90.0)] {
        let now = at(&scene, Playback::Once, seconds);
        assert!(are_voxels_of(&now, &bent(degrees, 0.0, 8.0 * seconds)), "{seconds} s");
        assert!(!are_voxels_of(&now, &bent(degrees, 0.0, 8.0 * seconds + 0.5)), "the comparison sees another place");
    }
}

#[test]
fn joints_that_stay_between_keys_are_few_shapes() {
    let mut file = bar();
    let turns = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0, 0.0, 0.0, 1.0];
    animate(&mut file, (2, "rotation", "VEC4"), "STEP", &[0.0, 0.5, 1.0], &turns);
    let scene = scene(&file, 10.0);
    let shapes = &scene.clips[0].motion.as_ref().unwrap().shapes[0];
    let steps: Vec<usize> = shapes.steps.iter().flatten().copied().collect();
    assert_eq!((shapes.shapes.len(), steps), (2, vec![0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0]));
    assert_eq!(scene.grids.len(), 3, "the two, and that at rest");
    assert!(are_voxels_of(&at(&scene, Playback::Once, 0.7), &bent(90.0, 0.0, 0.0)));
    // Who asks for no shapes has the one at rest, moving or not.
    let still = self::scene(&file, 0.0);
    assert!(still.grids.len() == 1 && still.clips[0].motion.as_ref().unwrap().shapes.is_empty());
}

#[test]
fn weights_move_the_vertices_of_a_target_straight_in_steps_and_on_splines() {
    let block_to = |x: f64, y: f64| [Turned::still([0.0; 3], [x, y, 1.0])];
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    animate(&mut file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    let straight = scene(&file, 2.0);
    assert_eq!((straight.instances.len(), straight.instances[0].name.as_str()), (1, "thing"));
    for (seconds, height) in [(0.0, 2.0), (0.5, 3.0), (0.9, 3.0), (1.0, 4.0)] {
        let now = at(&straight, Playback::Once, seconds);
        assert!(are_voxels_of(&now, &block_to(2.0, height)), "{seconds} s");
        assert!(
            !are_voxels_of(&now, &block_to(2.0, height + 0.5)) && !are_voxels_of(&now, &block_to(2.0, height - 0.5))
        );
    }
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    animate(&mut file, (0, "weights", "SCALAR"), "STEP", &[0.0, 1.0], &[0.0, 1.0]);
    let jumps = scene(&file, 4.0);
    for (seconds, height) in [(0.0, 2.0), (0.75, 2.0), (1.0, 4.0)] {
        assert!(are_voxels_of(&at(&jumps, Playback::Once, seconds), &block_to(2.0, height)), "{seconds} s");
    }
    // Two targets: for each key the tangents that come in, the weights, the tangents that go out. In the middle, by Hermite's polynomials, they are
    // 0.5·0 + 0.125·2 + 0.5·1 − 0.125·(−2) = 1 and 0.5·0.5 + 0.125·0 + 0.5·0.5 − 0.125·4 = 0.
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    morph(&mut file, &stretched(1, 0, 1.0));
    let keys = [0.0, 0.0, 0.0, 0.5, 2.0, 0.0, -2.0, 4.0, 1.0, 0.5, 0.0, 0.0];
    animate(&mut file, (0, "weights", "SCALAR"), "CUBICSPLINE", &[0.0, 1.0], &keys);
    let spline = scene(&file, 2.0);
    let once = |seconds: f64| at(&spline, Playback::Once, seconds);
    for (seconds, [width, height]) in [(0.0, [2.5, 2.0]), (0.5, [2.0, 4.0]), (1.0, [2.5, 4.0])] {
        assert!(are_voxels_of(&once(seconds), &block_to(width, height)), "{seconds} s");
    }
    // Straight between the keys, and as if each target had its keys in a row.
    assert!(!are_voxels_of(&once(0.5), &block_to(2.5, 3.0)) && !are_voxels_of(&once(0.0), &block_to(2.0, 3.0)));
}

#[test]
fn targets_move_vertices_before_joints_place_them() {
    let mut file = bar();
    turn(&mut file);
    morph(&mut file, &stretched(2, 1, 2.0));
    animate(&mut file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    let scene = scene(&file, 2.0);
    for (seconds, degrees, longer) in [(0.0, 0.0, 0.0), (0.5, 45.0, 1.0), (1.0, 90.0, 2.0)] {
        let now = at(&scene, Playback::Once, seconds);
        assert!(are_voxels_of(&now, &bent(degrees, longer, 0.0)), "{seconds} s");
    }
    // The end of the bar points to the left: afterwards the target would have moved it up.
    let now = at(&scene, Playback::Once, 1.0);
    assert!(is_seen(&now, DVec3::new(-6.0, 4.5, 0.0)) && !is_seen(&now, DVec3::new(-4.0, 6.5, 0.0)));
    assert!(!are_voxels_of(&now, &bent(90.0, 0.0, 0.0)), "the comparison sees the target");
    // The same in a still, whose joint is turned and whose target has a weight.
    file.json["nodes"][2]["rotation"] = json!([0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]);
    file.json["meshes"][0]["weights"] = json!([1.0]);
    let still = mesh(&file, None);
    let farthest = still.positions.iter().copied().reduce(Vec3::min).unwrap();
    assert!(farthest.abs_diff_eq(Vec3::new(-6.0, -1.0, 0.0), 1e-5), "{farthest}");
    assert_eq!(still.notes, ["not shown: 1 animation"]);
}

#[test]
fn a_still_has_the_weights_of_its_node_else_those_of_its_mesh() {
    let highest = |file: &File| mesh(file, None).positions.iter().fold(0.0f32, |most, position| most.max(position.z));
    let mut file = block();
    file.json.as_object_mut().unwrap().remove("animations");
    morph(&mut file, &stretched(1, 1, 2.0));
    assert_eq!((highest(&file), mesh(&file, None).notes.len()), (2.0, 0));
    file.json["meshes"][0]["weights"] = json!([0.5]);
    assert_eq!(highest(&file), 3.0);
    file.json["nodes"][0]["weights"] = json!([0.25]);
    assert_eq!(highest(&file), 2.5);
    // Of two nodes with one mesh each has its own.
    file.json["nodes"].as_array_mut().unwrap().push(json!({ "mesh": 0, "translation": [9, 0, 0] }));
    file.json["scenes"] = json!([{ "nodes": [0, 1] }]);
    let positions = mesh(&file, None).positions;
    let heights = [&positions[..8], &positions[8..]].map(|own| own.iter().fold(0.0f32, |most, at| most.max(at.z)));
    assert_eq!(heights, [2.5, 3.0]);
    // A target without a weight is not looked at; one that has one must fit.
    morph(&mut file, &[[1.0; 3]; 7]);
    assert_eq!(mesh(&file, None).positions, positions);
    file.json["nodes"][0]["weights"] = json!([0.25, 1.0]);
    assert!(file.fault().contains("7 attributes for 8 vertices"), "{}", file.fault());
    // One array may be named many times, but not be added for ever.
    let limits = Limits { points: 40, ..Limits::default() };
    let few = ImportOptions { limits, ..ImportOptions::default() };
    file.json["meshes"][0]["primitives"][0]["targets"].as_array_mut().unwrap().pop();
    file.json["scenes"] = json!([{ "nodes": [0] }]);
    let target = file.json["meshes"][0]["primitives"][0]["targets"][0].clone();
    file.json["nodes"][0]["weights"] = vec![0.25; 6].into();
    let read = |file: &File| import::mesh_from_bytes(&file.bytes(), Path::new("thing.glb"), &few);
    file.json["meshes"][0]["primitives"][0]["targets"] = vec![target.clone(); 5].into();
    assert_eq!(read(&file).unwrap().positions.iter().fold(0.0f32, |most, at| most.max(at.z)), 4.5);
    file.json["meshes"][0]["primitives"][0]["targets"] = vec![target; 6].into();
    let fault = read(&file).unwrap_err().to_string();
    assert!(fault.contains("vertices of morph targets: 48 is more than the limit of 40"), "{fault}");
    let mut file = block();
    morph(&mut file, &stretched(1, 1, f32::INFINITY));
    file.json["nodes"][0]["weights"] = json!([1.0]);
    assert!(file.fault().contains("not finite"), "{}", file.fault());
}

#[test]
fn sparse_targets_move_the_vertices_that_they_name() {
    let mut file = block();
    let (places, offsets) = ([3u16, 6], [[0.0f32, 2.0, 0.0], [0.0, 3.0, 0.0]]);
    let places = file.add("SCALAR", (SHORT, false), 2, &places.map(u16::to_le_bytes).concat());
    let offsets = file.add_floats("VEC3", 2, offsets.as_flattened());
    let view = |file: &File, accessor: usize| file.json["accessors"][accessor]["bufferView"].clone();
    let sparse = json!({
        "componentType": FLOAT, "count": 8, "type": "VEC3",
        "sparse": {
            "count": 2,
            "indices": { "bufferView": view(&file, places), "componentType": SHORT },
            "values": { "bufferView": view(&file, offsets) },
        },
    });
    let accessors = file.json["accessors"].as_array_mut().unwrap();
    accessors.push(sparse);
    let target = accessors.len() - 1;
    file.json["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": target }]);
    let heights = |file: &File| -> Vec<f32> { mesh(file, None).positions.iter().map(|position| position.z).collect() };
    assert_eq!(heights(&file), [0.0, 0.0, 2.0, 2.0, 0.0, 0.0, 2.0, 2.0]);
    file.json["meshes"][0]["weights"] = json!([0.5]);
    assert_eq!(heights(&file), [0.0, 0.0, 2.0, 3.0, 0.0, 0.0, 3.5, 2.0]);
}

#[test]
fn faults_of_weights_over_time_are_named_and_needless_ones_move_nothing() {
    let fault = |edit: fn(&mut File)| {
        let mut file = block();
        morph(&mut file, &stretched(1, 1, 2.0));
        edit(&mut file);
        let options = ImportOptions { animation: ClipChoice::First, ..ImportOptions::default() };
        import::mesh_from_bytes(&file.bytes(), Path::new("thing.glb"), &options).map_err(|error| error.to_string())
    };
    let weights = (0, "weights", "SCALAR");
    let few = fault(|file| animate(file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0, 2.0], &[0.0, 1.0]));
    assert!(few.unwrap_err().contains("not as many as their times ask for"));
    let wide = fault(|file| animate(file, (0, "weights", "VEC3"), "LINEAR", &[0.0], &[0.0; 3]));
    assert!(wide.unwrap_err().contains("holds VEC3, not SCALAR"));
    let twice = fault(|file| {
        animate(file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
        animate(file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    });
    assert!(twice.unwrap_err().contains("channel 1 of the animation \"bends\" moves what another one moves"));
    // Weights that say what the mesh has anyway.
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    file.json["meshes"][0]["weights"] = json!([0.5]);
    animate(&mut file, weights, "LINEAR", &[0.0, 1.0], &[0.5, 0.5]);
    let rest = mesh(&file, Some(4.0));
    assert!(rest.moving.is_none() && rest.positions.len() == 8);
}

#[test]
fn what_hangs_below_a_node_that_changes_its_shape_alone_stands_still() {
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    animate(&mut file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    file.json["nodes"][0]["children"] = json!([1]);
    file.json["nodes"].as_array_mut().unwrap().push(json!({ "mesh": 0, "name": "below", "translation": [0, 9, 0] }));
    let still = mesh(&file, Some(2.0));
    let parts = still.moving.as_ref().unwrap();
    assert_eq!((still.positions.len(), parts.meshes.len(), parts.meshes[0].positions.len()), (8, 1, 8));
    // Where the node moves as well, it takes along what is below it, which goes into its part.
    animate(&mut file, (0, "translation", "VEC3"), "LINEAR", &[0.0, 1.0], &[0.0, 0.0, 0.0, 4.0, 0.0, 0.0]);
    let moved = mesh(&file, Some(2.0));
    let parts = moved.moving.as_ref().unwrap();
    assert_eq!((moved.positions.len(), parts.meshes.len(), parts.meshes[0].positions.len()), (0, 1, 16));
    let last = parts.changing[0].shapes.positions(parts.changing[0].steps[2] as usize);
    let heights = [&last[..8], &last[8..]].map(|own| own.iter().fold(0.0f32, |most, at| most.max(at.z)));
    assert_eq!(heights, [4.0, 11.0]);
}

#[test]
fn too_many_joints_stay_as_at_rest_which_is_told_and_arrays_named_many_times_are_refused() {
    let mut file = bar();
    turn(&mut file);
    // As many joints as two steps have no room for.
    let mut joints = vec![1; (1 << 20) + 1];
    joints[1] = 2;
    file.json["skins"] = json!([{ "joints": joints }]);
    let still = mesh(&file, Some(24.0));
    assert!(still.moving.as_ref().unwrap().changing.is_empty());
    assert!(
        still.notes.len() == 1 && still.notes[0].starts_with("what bends stays as it is at rest"),
        "{:?}",
        still.notes
    );
    // Two nodes, each with five targets that move all of its eight vertices.
    let mut file = block();
    (0..5).for_each(|_| morph(&mut file, &[[0.0, 1.0, 0.0]; 8]));
    file.json["nodes"].as_array_mut().unwrap().push(json!({ "mesh": 0 }));
    file.json["scenes"] = json!([{ "nodes": [0, 1] }]);
    let weights = [[0.0; 5], [1.0; 5]].concat();
    for node in [0, 1] {
        animate(&mut file, (node, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &weights);
    }
    let read = |points: u64| {
        let limits = Limits { points, ..Limits::default() };
        let options = ImportOptions { animation: ClipChoice::First, limits, ..ImportOptions::default() };
        import::mesh_from_bytes(&file.bytes(), Path::new("thing.glb"), &options).map_err(|error| error.to_string())
    };
    assert_eq!(read(80).unwrap().moving.unwrap().changing.len(), 2);
    let fault = read(60).unwrap_err();
    assert!(fault.contains("morph targets and of joints: 80 is more than the limit of 60"), "{fault}");
}

#[test]
fn long_animations_and_many_voxels_have_fewer_shapes_a_second() {
    let mut file = bar();
    let turns = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2];
    animate(&mut file, (2, "rotation", "VEC4"), "STEP", &[0.0, 1e6], &turns);
    let long = mesh(&file, Some(24.0));
    let changing = &long.moving.as_ref().unwrap().changing[0];
    assert!(changing.steps.len() <= 1 << 16 && changing.rate < 24.0 && changing.rate > 0.01, "{}", changing.rate);
    let note = format!("what bends has {:.3} shapes a second: 24 are too many", changing.rate);
    assert!(long.notes.len() == 1 && long.notes[0].starts_with(&note), "{:?}", long.notes);
    // The last one is not before the end, and steps that are alike are one shape.
    assert!((changing.steps.len() - 1) as f64 / changing.rate >= 1e6 && changing.shapes.count() == 2);
    let mut file = bar();
    turn(&mut file);
    let voxels = |scene: &Scene| scene.grids.iter().map(|grid| grid.count()).sum::<u64>();
    let (mesh, all) = (mesh(&file, Some(8.0)), scene(&file, 8.0));
    let limits = Limits { voxels: voxels(&all), ..Limits::default() };
    let progress = VoxelizeProgress::default();
    let few = voxelize_with_progress(&mesh, &options(), &limits, &progress).unwrap();
    let notes = progress.take_notes();
    assert!(notes.len() == 1 && notes[0].starts_with("what bends has "), "{notes:?}");
    let shapes = &few.clips[0].motion.as_ref().unwrap().shapes[0];
    assert!([4.0, 2.0].contains(&shapes.rate) && voxels(&few) < voxels(&all), "{}", shapes.rate);
    assert!(are_voxels_of(&at(&few, Playback::Once, 0.5), &bent(45.0, 0.0, 0.0)));
    let nothing = Limits { voxels: 10, ..Limits::default() };
    assert!(voxelize(&mesh, &options(), &nothing).is_err());
    // What is filled has most of its voxels inside.
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    animate(&mut file, (0, "weights", "SCALAR"), "LINEAR", &[0.0, 1.0], &[0.0, 1.0]);
    let filled = VoxelizeOptions { scale: Scale::VoxelSize(0.05), fill: true, ..VoxelizeOptions::default() };
    let mesh = self::mesh(&file, Some(8.0));
    let all = voxelize(&mesh, &filled, &Limits::default()).unwrap();
    let limits = Limits { voxels: voxels(&all), ..Limits::default() };
    let few = voxelize(&mesh, &filled, &limits).unwrap();
    let rates = [&all, &few].map(|scene| scene.clips[0].motion.as_ref().unwrap().shapes[0].rate);
    assert!(rates[0] == 8.0 && [4.0, 2.0].contains(&rates[1]), "{rates:?}");
}

#[test]
fn a_file_whose_targets_have_weights_is_read_as_a_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("block.glb");
    let opens = |file: &File| {
        std::fs::write(&path, file.bytes()).unwrap();
        import::open_large(&path, &ImportOptions::default(), 1).unwrap().is_some()
    };
    let mut file = block();
    morph(&mut file, &stretched(1, 1, 2.0));
    assert!(opens(&file));
    file.json["meshes"][0]["weights"] = json!([0.5]);
    assert!(!opens(&file));
}
