//! What a file asks for and is not shown: one line when it is read, and a line of `info`.

use crate::common::{Folder, SMALL, stderr};
use serde_json::Value;
use voxtrace_test_support::{data, files_below};

/// The phrases of `info`, which stand in one warning too, and as a line of the text.
fn not_shown(folder: &Folder, name: &str, options: &[&str]) -> Vec<String> {
    let info: Value = serde_json::from_str(&folder.succeed(&[&["info", name, "--json"], options].concat())).unwrap();
    let phrases: Vec<String> =
        info["ignored"].as_array().unwrap().iter().map(|phrase| phrase.as_str().unwrap().to_owned()).collect();
    let output = folder.run(&[&["info", name], options].concat());
    let (text, said) = (String::from_utf8(output.stdout.clone()).unwrap(), stderr(&output));
    let lines: Vec<&str> = said.lines().filter(|line| line.contains("not shown: ")).collect();
    match phrases.is_empty() {
        true => assert!(lines.is_empty() && !text.contains("not shown"), "{said} {text}"),
        false => {
            assert_eq!(lines, [format!("warning: {name}: not shown: {}", phrases.join(", "))]);
            assert!(
                text.lines().any(|line| line.starts_with("not shown ") && line.ends_with(&phrases.join(", "))),
                "{text}"
            );
        }
    }
    phrases
}

#[test]
fn a_gltf_file_that_moves_and_shines_says_what_is_not_shown_and_a_plain_one_nothing() {
    let folder = Folder::new();
    let corners = [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    std::fs::write(folder.path("triangle.bin"), corners.map(f32::to_le_bytes).concat()).unwrap();
    let document = |more: &str, primitive: &str, material: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],{more}
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"material":0{primitive}}}]}}],
            "materials":[{{"name":"m"{material}}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"uri":"triangle.bin","byteLength":36}}]}}"#
        )
    };
    std::fs::write(folder.path("plain.gltf"), document("", "", "")).unwrap();
    let more = r#""extensionsUsed":["KHR_lights_punctual","KHR_materials_sheen","KHR_materials_ior"],
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"},{"type":"spot"}]}},
        "animations":[{"channels":[],"samplers":[]},{"channels":[],"samplers":[]}],"skins":[{"joints":[0]}],"#;
    let moving = document(more, r#","targets":[{"POSITION":0}]"#, r#","normalTexture":{"index":0}"#);
    std::fs::write(folder.path("moving.gltf"), moving).unwrap();
    let small = ["--resolution", "8"];
    assert!(not_shown(&folder, "plain.gltf", &small).is_empty());
    let said = not_shown(&folder, "moving.gltf", &small);
    assert_eq!(said, ["2 animations", "1 skin", "1 morph target", "2 lights", "1 normal map", "KHR_materials_sheen"]);
    // Larger than memory, the same.
    let output = folder.run(&[&["render", "moving.gltf", "-o", "a.png"], &small[..], &SMALL[..]].concat());
    assert_eq!(stderr(&output).matches("not shown: ").count(), 1);
}

#[test]
fn meshes_say_what_of_their_statements_and_elements_nothing_comes_of() {
    let folder = Folder::new();
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    let corners = "v 0 0 0\nv 4 0 0\nv 0 4 1\n";
    write("a.obj", &format!("mtllib a.mtl\n{corners}usemtl m\nf 1 2 3\nl 1 2 3\nsurf 0 1 0 1 1\n"));
    write("a.mtl", "newmtl m\nKd 1 0 0\nmap_Bump bumps.png\nmap_Ks shine.png\n");
    let small = ["--resolution", "8"];
    let said = not_shown(&folder, "a.obj", &small);
    assert_eq!(said, ["1 free-form surface", "2 lines", "1 texture of map_Bump", "1 texture of map_Ks"]);
    write("b.obj", &format!("{corners}g part\ns off\nvn 0 0 1\nf 1//1 2//1 3//1\n"));
    assert!(not_shown(&folder, "b.obj", &small).is_empty());
    let head = |more: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
             element face 1\nproperty list uchar int vertex_indices\n{more}end_header\n0 0 0\n4 0 0\n0 4 1\n3 0 1 2\n"
        )
    };
    write("a.ply", &(head("element edge 2\nproperty int a\nproperty int b\n") + "0 1\n1 2\n"));
    assert_eq!(not_shown(&folder, "a.ply", &small), ["2 edges"]);
    write("b.ply", &head(""));
    assert!(not_shown(&folder, "b.ply", &small).is_empty());
}

#[test]
fn a_vox_file_says_in_one_warning_what_info_says() {
    let Some(data) = data() else { return };
    let folder = Folder::new();
    let mut told = 0;
    for file in files_below(&data.join("vox"), &["vox"]).into_iter().take(12) {
        if std::fs::metadata(&file).unwrap().len() < 1 << 20 {
            told += usize::from(!not_shown(&folder, file.to_str().unwrap(), &[]).is_empty());
        }
    }
    assert!(told > 0, "no file asks for bloom, a vignette or a film curve");
    assert!(not_shown(&folder, "room.vox", &[]).is_empty());
}
