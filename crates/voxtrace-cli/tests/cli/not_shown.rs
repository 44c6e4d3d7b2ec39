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
    // Morph targets are shown, but for the colours that they have.
    let colors = document(r#""skins":[{"joints":[0]}],"#, r#","targets":[{"POSITION":0,"COLOR_0":0}]"#, "");
    std::fs::write(folder.path("colors.gltf"), colors.replace(r#"{"mesh":0}"#, r#"{"mesh":0,"skin":0}"#)).unwrap();
    assert_eq!(not_shown(&folder, "colors.gltf", &small), ["1 colouring morph target"]);
    let half = std::fs::read_to_string(folder.path("colors.gltf")).unwrap();
    let half = half.replace(r#","COLOR_0":0"#, "").replace(r#""attributes":{"#, r#""attributes":{"JOINTS_0":0,"#);
    std::fs::write(folder.path("half.gltf"), half).unwrap();
    assert_eq!(not_shown(&folder, "half.gltf", &small), ["1 skin"]);
    let said = not_shown(&folder, "moving.gltf", &small);
    assert_eq!(said, ["2 animations", "2 lights", "1 normal map", "KHR_materials_sheen"]);
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

/// A chunk of a .vox file.
fn chunk(name: &str, content: &[u8], children: &[u8]) -> Vec<u8> {
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    [name.as_bytes(), &length(content), &length(children), content, children].concat()
}

/// A dictionary of a .vox file.
fn dict(pairs: &[(&str, &str)]) -> Vec<u8> {
    let text = |text: &str| [&(text.len() as u32).to_le_bytes()[..], text.as_bytes()].concat();
    let pairs_of = pairs.iter().flat_map(|(key, value)| [text(key), text(value)].concat());
    (pairs.len() as u32).to_le_bytes().into_iter().chain(pairs_of).collect()
}

fn numbers(numbers: &[i32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// Two models, of which a shape shows one after the other while it moves; with as many keyframes of each.
fn moving(places: usize, models: usize) -> Vec<u8> {
    let model = [chunk("SIZE", &numbers(&[1, 1, 1]), &[]), chunk("XYZI", &[1, 0, 0, 0, 0, 0, 0, 1], &[])].concat();
    let root = [numbers(&[0]), dict(&[]), numbers(&[1, -1, -1, 1]), dict(&[])].concat();
    let group = [numbers(&[1]), dict(&[]), numbers(&[1, 2])].concat();
    let keys = (0..places).flat_map(|key| dict(&[("_t", &format!("{key} 0 0")), ("_f", &key.to_string())]));
    let place = [numbers(&[2]), dict(&[]), numbers(&[3, -1, 0, places as i32]), keys.collect()].concat();
    let shown = (0..models).flat_map(|key| [numbers(&[key as i32 % 2]), dict(&[("_f", &key.to_string())])].concat());
    let shape = [numbers(&[3]), dict(&[]), numbers(&[models as i32]), shown.collect()].concat();
    let nodes = [("nTRN", root), ("nGRP", group), ("nTRN", place), ("nSHP", shape)];
    let chunks = nodes.iter().flat_map(|(name, content)| chunk(name, content, &[]));
    let children: Vec<u8> = model.iter().chain(&model).copied().chain(chunks).collect();
    [&b"VOX "[..], &numbers(&[150]), &chunk("MAIN", &[], &children)].concat()
}

#[test]
fn keyframes_of_a_vox_file_are_counted_but_for_the_first_of_each() {
    let folder = Folder::new();
    let said = |bytes: Vec<u8>| {
        std::fs::write(folder.path("a.vox"), bytes).unwrap();
        not_shown(&folder, "a.vox", &[])
    };
    assert!(said(moving(1, 1)).is_empty());
    assert_eq!(said(moving(2, 1)), ["1 further keyframe"]);
    assert_eq!(said(moving(3, 5)), ["6 further keyframes"]);
    // Before there was a graph, models of an animation followed a number of them.
    let model = [chunk("SIZE", &numbers(&[1, 1, 1]), &[]), chunk("XYZI", &[1, 0, 0, 0, 0, 0, 0, 1], &[])].concat();
    let packed = [chunk("PACK", &numbers(&[3]), &[]), model.repeat(3)].concat();
    let packed = [&b"VOX "[..], &numbers(&[150]), &chunk("MAIN", &[], &packed)].concat();
    assert_eq!(said(packed), ["2 further keyframes"]);
}

/// A NIfTI of 2³ bytes behind extensions of so many bytes, their eight of size and kind among them.
fn nifti(extensions: &[u32]) -> Vec<u8> {
    let start = 352 + extensions.iter().sum::<u32>();
    let mut bytes = vec![0; 352];
    bytes[0] = 92;
    bytes[1] = 1;
    for n in 0..4 {
        bytes[40 + 2 * n] = if n == 0 { 3 } else { 2 };
        bytes[76 + 4 * n..80 + 4 * n].copy_from_slice(&1f32.to_le_bytes());
    }
    (bytes[70], bytes[72]) = (2, 8);
    bytes[108..112].copy_from_slice(&(start as f32).to_le_bytes());
    bytes[344..348].copy_from_slice(b"n+1\0");
    bytes[348] = u8::from(!extensions.is_empty());
    for &size in extensions {
        bytes.extend([size.to_le_bytes(), 6u32.to_le_bytes()].concat());
        bytes.extend(vec![b'x'; size as usize - 8]);
    }
    bytes.extend([0, 0, 200, 200, 0, 0, 200, 200]);
    bytes
}

#[test]
fn extensions_of_nifti_are_counted() {
    let folder = Folder::new();
    for (extensions, wanted) in
        [(&[][..], None), (&[32], Some("1 NIfTI extension")), (&[16, 64, 16], Some("3 NIfTI extensions"))]
    {
        std::fs::write(folder.path("a.nii"), nifti(extensions)).unwrap();
        assert_eq!(not_shown(&folder, "a.nii", &[]), Vec::from_iter(wanted), "{extensions:?}");
    }
}

/// A DICOM file of 2 × 2 × 2 bytes, with so many planes of an overlay.
fn dicom(overlays: u16) -> Vec<u8> {
    let element = |tag: [u16; 2], kind: &str, value: &[u8]| {
        let head = [&tag[0].to_le_bytes()[..], &tag[1].to_le_bytes(), kind.as_bytes()].concat();
        let length = match kind {
            "OW" | "OB" => [&[0, 0][..], &(value.len() as u32).to_le_bytes()].concat(),
            _ => (value.len() as u16).to_le_bytes().to_vec(),
        };
        [head, length, value.to_vec()].concat()
    };
    let short = |tag, value: u16| element(tag, "US", &value.to_le_bytes());
    let mut elements = [
        element([2, 16], "UI", b"1.2.840.10008.1.2.1\0"),
        element([0x28, 4], "CS", b"MONOCHROME2 "),
        short([0x28, 2], 1),
        element([0x28, 8], "IS", b"2 "),
        short([0x28, 16], 2),
        short([0x28, 17], 2),
        element([0x28, 0x30], "DS", b"1\\1 "),
        short([0x28, 0x100], 8),
        short([0x28, 0x101], 8),
        short([0x28, 0x102], 7),
        short([0x28, 0x103], 0),
    ]
    .concat();
    for overlay in 0..overlays {
        let group = 0x6000 + 2 * overlay;
        elements.extend(short([group, 16], 2));
        elements.extend(short([group, 17], 2));
        elements.extend(element([group, 0x3000], "OW", &[9, 0]));
    }
    elements.extend(element([0x7fe0, 16], "OB", &[0, 0, 200, 200, 0, 0, 200, 200]));
    [&[0; 128][..], b"DICM", &elements].concat()
}

#[test]
fn overlays_of_dicom_are_counted() {
    let folder = Folder::new();
    for (overlays, wanted) in [(0, None), (1, Some("1 overlay")), (3, Some("3 overlays"))] {
        std::fs::write(folder.path("a.dcm"), dicom(overlays)).unwrap();
        assert_eq!(not_shown(&folder, "a.dcm", &[]), Vec::from_iter(wanted), "{overlays}");
    }
}
