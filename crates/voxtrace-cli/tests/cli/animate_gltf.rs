//! `animate` on glTF files whose nodes move: frames, clips and cameras, and what is said where nothing does.

use super::common::{Folder, stderr};
use serde_json::Value;

/// Options of small frames on the CPU.
const SMALL: [&str; 8] = ["--size", "32x24", "--spp", "64", "--traversal", "cpu", "--resolution", "24"];

/// The places of what goes.
const PLACES: [[f32; 3]; 3] = [[-2.0, 0.0, 0.0], [2.0, 0.5, 0.0], [-2.0, 0.0, 0.0]];

/// The bytes of corners, times, places and faces.
fn binary(places: [[f32; 3]; 3]) -> Vec<u8> {
    let corners: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let faces: [u16; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    let times: [f32; 3] = [0.0, 0.25, 0.5];
    let floats = corners.as_flattened().iter().chain(&times).chain(places.as_flattened());
    floats.flat_map(|n| n.to_le_bytes()).chain(faces.iter().flat_map(|n| n.to_le_bytes())).collect()
}

/// Two pyramids on a floor: one goes along x and back, with a camera on it in one of two animations; the other one stands still.
fn document(animations: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0,1,2]}}],
        "nodes":[{{"mesh":0,"name":"floor","translation":[-3,-0.2,-2],"scale":[6,0.1,5]}},
            {{"mesh":0,"name":"goer","translation":[-2,0,0],"children":[3]}},{{"mesh":0,"name":"stone"}},
            {{"camera":0,"translation":[0,1,3]}}],
        "cameras":[{{"name":"rider","type":"perspective","perspective":{{"yfov":0.9,"znear":0.1}}}}],
        {animations}
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":3}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}},
            {{"bufferView":1,"componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[0.5]}},
            {{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}},
            {{"bufferView":3,"componentType":5123,"count":12,"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":12}},
            {{"buffer":0,"byteOffset":60,"byteLength":36}},{{"buffer":0,"byteOffset":96,"byteLength":24}}],
        "buffers":[{{"uri":"goer.bin","byteLength":120}}]}}"#
    )
}

/// An animation of some nodes.
fn animation(name: &str, nodes: &[usize], interpolation: &str) -> String {
    let channels =
        nodes.iter().map(|node| format!(r#"{{"sampler":0,"target":{{"node":{node},"path":"translation"}}}}"#));
    let channels = channels.collect::<Vec<_>>().join(",");
    format!(
        r#"{{"name":"{name}","channels":[{channels}],"samplers":[{{"input":1,"output":2,"interpolation":"{interpolation}"}}]}}"#
    )
}

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::write(folder.path("goer.bin"), binary(PLACES)).unwrap();
    let both = [animation("go", &[1], "LINEAR"), animation("jump", &[1], "STEP")].join(",");
    std::fs::write(folder.path("goer.gltf"), document(&format!(r#""animations":[{both}],"#))).unwrap();
    folder
}

fn frames(folder: &Folder, name: &str, options: &[&str]) -> Vec<Vec<u16>> {
    let told = folder.succeed(&[&["animate", name, "-o", "f_####.png"], options, &SMALL[..]].concat());
    told.lines().map(|file| folder.png(file).samples.clone()).collect()
}

/// The mean difference of two frames.
fn difference(one: &[u16], other: &[u16]) -> f64 {
    let sum: f64 = one.iter().zip(other).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / one.len() as f64
}

#[test]
fn a_gltf_file_plays_as_long_as_its_animation_and_another_one_by_name() {
    let folder = folder();
    let go = frames(&folder, "goer.gltf", &["--fps", "16", "--camera", "front"]);
    assert_eq!(go.len(), 8, "half a second");
    // There and back: what is as far from the middle is the same but for its noise.
    assert!(difference(&go[1], &go[7]) < 0.3 && difference(&go[1], &go[4]) > 0.7);
    let jump = frames(&folder, "goer.gltf", &["--fps", "16", "--camera", "front", "--animation", "jump"]);
    assert!(difference(&jump[1], &jump[3]) < 0.3 && difference(&jump[1], &jump[4]) > 0.7, "it stays, and jumps");
    let second = frames(&folder, "goer.gltf", &["--fps", "16", "--camera", "front", "--animation", "2"]);
    assert_eq!(second, jump);
    // The camera of the file rides along: it sees the goer where it always is.
    let rider = frames(&folder, "goer.gltf", &["--fps", "8"]);
    assert!(difference(&rider[0], &rider[2]) > 5.0, "and what stands still elsewhere");
    let script = "scene = \"goer.gltf\"\nfps = 16\nseconds = 1\nanimation_repeats = true\n[camera]\nname = \"front\"";
    std::fs::write(folder.path("again.toml"), script).unwrap();
    let again = frames(&folder, "again.toml", &[]);
    assert!(again.len() == 16 && difference(&again[1], &again[9]) < 0.3 && difference(&again[4], &again[12]) < 0.3);
    assert!(difference(&again[9], &again[12]) > 0.7, "the comparison sees another frame");
}

#[test]
fn a_shape_that_changes_is_shown_at_its_time_and_is_one_object() {
    let folder = folder();
    // Corners move by themselves: at the weight 2 the goer is three times as large.
    let smile = r#""animations":[{"name":"smile","channels":[{"sampler":0,"target":{"node":1,"path":"weights"}}],"samplers":[{"input":1,"output":4}]}],"#;
    let text = document(smile).replace(r#""indices":3}"#, r#""indices":3,"targets":[{"POSITION":0}]}"#);
    let text = text.replace(
        r#""bufferView":3,"componentType":5123,"count":12,"type":"SCALAR"}"#,
        r#""bufferView":3,"componentType":5123,"count":12,"type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":3,"type":"SCALAR"}"#,
    );
    std::fs::write(folder.path("smile.gltf"), text).unwrap();
    std::fs::write(folder.path("goer.bin"), binary([[0.0, 2.0, 0.0], [0.0; 3], [0.0; 3]])).unwrap();
    let play =
        |options: &[&str]| frames(&folder, "smile.gltf", &[&["--fps", "16", "--camera", "front"], options].concat());
    let smile = play(&[]);
    assert_eq!(smile.len(), 8, "half a second");
    assert!(difference(&smile[1], &smile[7]) < 0.3 && difference(&smile[1], &smile[4]) > 0.7);
    assert!(difference(&smile[1], &smile[3]) > 0.5, "it grows in each frame");
    // Four shapes a second: each is seen for four frames.
    let slow = play(&["--key-fps", "4"]);
    assert!(difference(&slow[0], &slow[3]) < 0.3 && difference(&slow[3], &slow[4]) > 0.7);
    let hidden = play(&["--hide", "goer"]);
    assert!(difference(&hidden[1], &hidden[4]) < 0.3, "one name for all of its shapes");
    let output = folder.run(&[&["info", "smile.gltf"], &SMALL[6..]].concat());
    assert!(!stderr(&output).contains("morph"), "{}", stderr(&output));
}

#[test]
fn info_lists_the_animations_and_what_cannot_be_played_is_told() {
    let folder = folder();
    let small = ["--resolution", "8"];
    let told = folder.succeed(&[&["info", "goer.gltf"], &small[..]].concat());
    assert!(told.contains("animations        1 go (0.5 s), 2 jump (0.5 s)"), "{told}");
    let json: Value = serde_json::from_str(&folder.succeed(&["info", "goer.gltf", "--json"])).unwrap();
    assert_eq!(json["animations"][1], serde_json::json!({ "name": "jump", "seconds": 0.5 }));
    let play = |name: &str, options: &[&str]| {
        let output = folder.run(&[&["animate", name, "-o", "x.gif"], options, &SMALL[..]].concat());
        assert!(!output.status.success());
        stderr(&output)
    };
    let told = play("goer.gltf", &["--animation", "fly"]);
    assert!(told.contains("no animation \"fly\" of goer") && told.contains("1 \"go\", 2 \"jump\""), "{told}");
    let told = play("room.vox", &["--animation", "1"]);
    assert!(told.contains("no animation \"1\" of room"), "{told}");
    // Weights of a mesh without morph targets change nothing.
    let weights = r#""animations":[{"name":"smile","channels":[{"sampler":0,"target":{"node":1,"path":"weights"}}],"samplers":[{"input":1,"output":1}]}],"#;
    std::fs::write(folder.path("smile.gltf"), document(weights)).unwrap();
    let told = play("smile.gltf", &[]);
    assert!(told.contains("nothing moves in smile"), "{told}");
    // Two channels for one thing, and times that fall.
    let twice = animation("twice", &[1, 1], "LINEAR");
    std::fs::write(folder.path("twice.gltf"), document(&format!(r#""animations":[{twice}],"#))).unwrap();
    assert!(play("twice.gltf", &[]).contains("channel 1 of the animation \"twice\" moves what another one moves"));
    let cubic = animation("cubic", &[1], "CUBICSPLINE");
    std::fs::write(folder.path("cubic.gltf"), document(&format!(r#""animations":[{cubic}],"#))).unwrap();
    assert!(play("cubic.gltf", &[]).contains("not as many as their times ask for"));
    // A still of either is none of their business.
    folder.succeed(&[&["render", "cubic.gltf", "-o", "still.png"], &SMALL[..]].concat());
}

#[test]
fn a_scale_that_is_not_uniform_is_told_and_other_animations_are_counted() {
    let folder = folder();
    let scale = animation("go", &[1], "LINEAR").replace("translation", "scale");
    let both = [scale, animation("jump", &[1], "STEP")].join(",");
    // Nothing is bound to the joints of any skin.
    let skins = r#"[{"joints":[0]},{"joints":[0,1]},{"joints":[0,1]}]"#;
    let text = document(&format!(r#""skins":{skins},"animations":[{both}],"#));
    let text = text.replace("\"name\":\"stone\"", "\"name\":\"stone\",\"skin\":1");
    let text = text.replace("\"name\":\"floor\"", "\"name\":\"floor\",\"skin\":0");
    std::fs::write(folder.path("squash.gltf"), text).unwrap();
    std::fs::write(folder.path("goer.bin"), binary([[1.0; 3], [1.0, 2.0, 1.0], [1.0; 3]])).unwrap();
    let output = folder.run(&[&["animate", "squash.gltf", "-o", "x.gif", "--fps", "4"], &SMALL[..]].concat());
    let told = stderr(&output);
    assert!(output.status.success() && told.contains("not shown: 1 animation\n"), "{told}");
    assert!(told.contains("1 moving part has scales that are not uniform"), "{told}");
}
