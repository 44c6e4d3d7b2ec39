//! The verbs that make no pictures.

use crate::common::{Folder, room};
use serde_json::Value;
use voxtrace_test_support::{data, files_below};

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn info_has_exactly_the_documented_keys_and_the_right_numbers() {
    let folder = Folder::new();
    for scene in ["room.vox", "room.vxt"] {
        let info = json(&folder.succeed(&["info", scene, "--json"]));
        let keys: Vec<&String> = info.as_object().unwrap().keys().collect();
        let expected = "name unit voxel_size content_hash cameras objects layers groups \
            georeference sky on_request ignored size bounds voxels voxels_placed models instances merged_instances materials emissive_voxels bytes bytes_per_voxel warnings frames levels animations";
        assert_eq!(keys, expected.split(' ').collect::<Vec<_>>());
        assert_eq!(info["size"], serde_json::json!({ "x": 24, "y": 24, "z": 8 }));
        let corner = |name: &str, axis: usize| info["bounds"][name][axis].as_f64().unwrap();
        assert_eq!([0, 1, 2].map(|axis| corner("max", axis) - corner("min", axis)), [24.0, 24.0, 8.0]);
        let voxels = 24 * 24 + 6 * 6 * 6 + 8;
        assert_eq!((info["voxels"].as_u64(), info["voxels_placed"].as_u64()), (Some(voxels), Some(voxels)));
        assert_eq!((info["models"].as_u64(), info["instances"].as_u64()), (Some(1), Some(1)));
        assert_eq!(info["emissive_voxels"], 8);
        let bytes = info["bytes"].as_object().unwrap();
        let total: u64 = bytes.iter().filter(|(kind, _)| *kind != "total").map(|(_, b)| b.as_u64().unwrap()).sum();
        assert_eq!(bytes["total"].as_u64(), Some(total));
        let of_voxels = total - bytes["lights"].as_u64().unwrap();
        assert_eq!(info["bytes_per_voxel"].as_f64(), Some(of_voxels as f64 / voxels as f64));
    }
}

#[test]
fn info_tells_people_the_same() {
    let folder = Folder::new();
    let text = folder.succeed(&["info", "room.vox"]);
    for line in ["24 x 24 x 8 voxels", "voxels            800", "emissive voxels   8", "cameras           front, side"]
    {
        assert!(text.contains(line), "{line}: {text}");
    }
}

#[test]
fn converting_there_and_back_keeps_the_scene() {
    let folder = Folder::new();
    assert_eq!(folder.succeed(&["convert", "room.vox", "a.vxt"]), "a.vxt\n");
    folder.succeed(&["convert", "a.vxt", "room.vox"]);
    folder.succeed(&["convert", "room.vox", "b.vxt"]);
    assert_eq!(folder.bytes("a.vxt"), folder.bytes("b.vxt"));
    let mut scene = room();
    scene.materials[1].base_color.y = 0.5;
    voxtrace::export::vox::write(&folder.path("room.vox"), &scene).unwrap();
    folder.succeed(&["convert", "room.vox", "b.vxt"]);
    assert_ne!(folder.bytes("a.vxt"), folder.bytes("b.vxt"));
}

#[test]
fn a_built_in_scene_converts_to_a_file_that_has_its_voxels() {
    let folder = Folder::new();
    let counts = |scene: &[&str]| {
        let info = json(&folder.succeed(&[&["info", "--json"], scene].concat()));
        (info["voxels"].clone(), info["size"].clone(), info["emissive_voxels"].clone())
    };
    let original = counts(&["church", "--voxels", "20k"]);
    for file in ["a.vxt", "a.vox"] {
        folder.succeed(&["convert", "church", file, "--voxels", "20k"]);
        assert_eq!(counts(&[file]), original, "{file}");
    }
    assert_ne!(counts(&["room.vox"]), original);
}

#[test]
fn scenes_formats_and_devices_list_what_there_is() {
    let folder = Folder::new();
    assert!(folder.succeed(&["scenes"]).contains("church"));
    let scenes = json(&folder.succeed(&["scenes", "--json"]));
    assert!(scenes["scenes"].as_array().unwrap().iter().any(|scene| scene["name"] == "church"));
    let formats = json(&folder.succeed(&["formats", "--json"]));
    let names: Vec<&str> =
        formats["formats"].as_array().unwrap().iter().map(|format| format["extension"].as_str().unwrap()).collect();
    assert_eq!(
        names,
        [
            "vox", "vxt", "glb", "obj", "ply", "stl", "laz", "xyz", "pcd", "e57", "schem", "mca", "qb", "kv6", "gox",
            "binvox", "nrrd", "mha", "npy", "npz", "raw", "vdb", "zarr", "asc", "tif", "nii", "mgz", "par", "dcm",
            "vxf", "png", "exr"
        ]
    );
    assert!(folder.succeed(&["formats"]).contains(".vox"));
    let devices = json(&folder.succeed(&["devices", "--json", "--threads", "2"]));
    assert_eq!(devices["devices"][0]["name"], "cpu");
    assert_eq!(devices["devices"][0]["threads"], 2);
    // Each GPU says what it can do; without any, one line says why.
    let gpus = devices["devices"].as_array().unwrap().len() - 1;
    let text = folder.succeed(&["devices"]);
    assert_eq!(text.matches("driver").count(), gpus, "{text}");
    assert!(gpus > 0 || text.contains("No GPU") || text.contains("no device"), "{text}");
}

#[test]
fn every_shell_gets_its_completions() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = folder.succeed(&["completions", shell]);
        assert!(script.contains("render") && script.contains("max-bounces"), "{shell}");
    }
}

#[test]
fn every_verb_has_a_manual_page_with_its_options() {
    let folder = Folder::new();
    folder.succeed(&["man", "pages"]);
    let page = |name: &str| std::fs::read_to_string(folder.path("pages").join(name)).unwrap();
    for verb in
        ["render", "info", "convert", "voxelize", "plan", "merge", "scenes", "formats", "devices", "doctor", "bench"]
    {
        assert!(page("voxtrace.1").contains(&format!("voxtrace\\-{verb}(1)")), "{verb} in the list of verbs");
        assert!(page(&format!("voxtrace-{verb}.1")).contains(".SH SYNOPSIS"), "{verb}");
    }
    assert!(page("voxtrace-render.1").contains("max\\-bounces"));
    assert!(folder.fail(&["man", "room.vox"], 4).contains("room.vox"), "a file stands where the folder should");
}

#[test]
fn help_documents_every_verb_and_exit_code() {
    let folder = Folder::new();
    let help = folder.succeed(&["--help"]);
    for word in [
        "render",
        "info",
        "convert",
        "plan",
        "merge",
        "scenes",
        "formats",
        "devices",
        "doctor",
        "bench",
        "completions",
        "man",
        "130",
    ] {
        assert!(help.contains(word), "{word}");
    }
    let version = folder.succeed(&["--version"]);
    assert_eq!(version, concat!("voxtrace ", env!("CARGO_PKG_VERSION"), "\n"));
    // The page lists every option of every verb.
    let page = include_str!("../../../../docs/command-line.md");
    for verb in [
        "render",
        "info",
        "convert",
        "plan",
        "merge",
        "scenes",
        "formats",
        "devices",
        "doctor",
        "bench",
        "completions",
        "man",
    ] {
        let help = folder.succeed(&[verb, "--help"]);
        for option in help.split(|c: char| !(c.is_ascii_lowercase() || c == '-')).filter(|word| word.starts_with("--"))
        {
            assert!(option == "--help" || page.contains(&format!("`{option}")), "{verb} {option}");
        }
    }
}

#[test]
fn help_of_animate_has_the_scene_among_its_arguments_and_not_among_the_options_of_clips() {
    let help = Folder::new().succeed(&["animate", "--help"]);
    assert!(help.contains("\nArguments:\n  <SCENE>"), "{help}");
    let of_clips = help.split_once("\nClip:\n").unwrap().1.split("\nMeshes and points:\n").next().unwrap();
    assert!(of_clips.contains("--keep-frames") && !of_clips.contains("--voxels"), "{of_clips}");
}

#[cfg(feature = "view")]
#[test]
fn a_device_that_is_not_there_to_measure_frames_is_not_replaced_by_the_processor_in_the_hint() {
    let error = Folder::new().fail(&["view", "room.vox", "--bench-frames", "1", "--device", "nosuch"], 1);
    assert!(error.contains("--device takes") && !error.contains("--traversal cpu"), "{error}");
}

#[test]
fn every_scene_of_the_shared_data_opens_and_has_the_voxels_that_its_manifest_says() {
    let Some(data) = data() else { return };
    let folder = Folder::new();
    let manifest = std::fs::read_to_string(data.join("MANIFEST.md")).unwrap();
    let mut checked = 0;
    for file in files_below(&data.join("vox"), &["vox"]) {
        let name = file.strip_prefix(&data).unwrap().to_string_lossy().into_owned();
        let row = manifest.lines().find(|line| line.contains(&format!("| {name} |"))).unwrap_or_default();
        let number_before = |word: &str| {
            let words: Vec<&str> = row.split([' ', ';']).collect();
            let at = words.iter().position(|found| found.starts_with(word))?;
            words[at - 1].replace(',', "").parse::<u64>().ok()
        };
        let (Some(models), Some(voxels)) = (number_before("model(s)"), number_before("voxels")) else { continue };
        let info = json(&folder.succeed(&["info", file.to_str().unwrap(), "--json"]));
        assert_eq!(info["models"].as_u64(), Some(models), "{name}");
        assert_eq!(info["voxels"].as_u64(), Some(voxels), "{name}");
        checked += 1;
    }
    assert!(checked > 40, "{checked}");
}

#[test]
fn columns_of_formats_stand_apart() {
    let folder = Folder::new();
    let text = folder.succeed(&["formats"]);
    let starts: Vec<usize> = ["read", "write", "what"].map(|name| text.find(name).unwrap()).to_vec();
    for line in text.lines().skip(1) {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert!(words[0].starts_with('.') && words[1..3].iter().all(|word| ["yes", "-"].contains(word)), "{line}");
        assert!(starts.iter().all(|&start| !line[start..].starts_with(' ') && line[..start].ends_with(' ')), "{line}");
    }
    assert!(text.contains("\n.binvox  yes   -"), "{text}");
}

#[test]
fn info_as_json_has_unit_voxel_size_cameras_hash_and_what_the_reader_left_out() {
    let folder = Folder::new();
    let info = |arguments: &[&str]| -> Value {
        serde_json::from_str(&folder.succeed(&[&["info", "--json"], arguments].concat())).unwrap()
    };
    let room = info(&["room.vxt"]);
    assert_eq!((room["unit"].is_null(), room["voxel_size"].as_f64()), (true, Some(1.0)));
    assert_eq!(room["warnings"], serde_json::json!([]));
    let names: Vec<&str> = room["cameras"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), 2);
    assert!(room["cameras"][0]["eye"][1].as_f64().unwrap() < -20.0 && room["cameras"][0]["fov_y"].as_f64().is_some());
    let hash = room["content_hash"].as_str().unwrap();
    assert!(hash.len() == 16 && folder.succeed(&["info", "room.vxt"]).contains(hash));
    std::fs::write(folder.path("a.obj"), "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let mesh = info(&["a.obj", "--unit", "mm", "--resolution", "16"]);
    assert_eq!((mesh["unit"].as_str(), mesh["voxel_size"].as_f64()), (Some("mm"), Some(0.0625)));
    let warnings = mesh["warnings"].as_array().unwrap();
    assert!(warnings.len() == 1 && warnings[0].as_str().unwrap().contains("gone.mtl"), "{warnings:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn scenes_films_and_pictures_to_compare_come_through_a_pipe() {
    use crate::common::stderr;
    use std::io::Write;
    use std::process::{Output, Stdio};
    let folder = Folder::new();
    // The name says nothing of the format, or, by a link, that it is native and may have levels of detail.
    std::os::unix::fs::symlink("/dev/stdin", folder.path("piped.vxt")).unwrap();
    let piped = |file: &str, arguments: &[&str]| -> Output {
        let mut command = folder.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let (mut pipe, bytes) = (child.stdin.take().unwrap(), folder.bytes(file));
        // Who does not read to the end closes it.
        let writer = std::thread::spawn(move || pipe.write_all(&bytes).is_ok());
        let output = child.wait_with_output().unwrap();
        let _ = writer.join();
        output
    };
    let voxels = |json: &[u8]| serde_json::from_slice::<Value>(json).unwrap()["voxels"].clone();
    let expected = voxels(folder.succeed(&["info", "room.vox", "--json"]).as_bytes());
    for (file, name) in [("room.vox", "/dev/stdin"), ("room.vxt", "/dev/stdin"), ("room.vxt", "piped.vxt")] {
        let output = piped(file, &["info", name, "--json"]);
        assert!(output.status.success(), "{file} as {name}: {}", stderr(&output));
        assert_eq!(voxels(&output.stdout), expected, "{file} as {name}");
    }
    folder.render("a.png", &[]);
    folder.succeed(&["render", "room.vox", "-o", "b.png", "-o", "b.vxf", "--size", "40x30", "--spp", "2", "-q"]);
    let of = |json: &[u8]| serde_json::from_slice::<Value>(json).unwrap()["rmse"].as_f64().unwrap();
    for name in ["b.png", "b.vxf"] {
        let output = piped(name, &["compare", "a.png", "/dev/stdin", "--json"]);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        let expected = of(folder.succeed(&["compare", "a.png", name, "--json"]).as_bytes());
        assert!(of(&output.stdout) == expected && expected > 0.0, "{name}");
    }
    let output = piped("room.vox", &["compare", "/dev/stdin", "a.png"]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("cannot compare /dev/stdin: ") && said.contains("write what comes out of it"), "{said}");
    // Films come through pipes, too, and where a scene is to be they are told for what they are.
    folder.succeed(&["render", "room.vox", "-o", "a.vxf", "--size", "40x30", "--spp", "2", "-q"]);
    folder.succeed(&["merge", "a.vxf", "-o", "of_file.png", "-q"]);
    let output = piped("a.vxf", &["merge", "/dev/stdin", "-o", "of_pipe.png", "-q"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(folder.bytes("of_pipe.png"), folder.bytes("of_file.png"));
    let output = piped("a.vxf", &["info", "/dev/stdin"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(crate::common::stdout(&output), folder.succeed(&["info", "a.vxf"]));
    let output = piped("a.vxf", &["render", "/dev/stdin"]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("/dev/stdin: not supported: a film (.vxf)") && said.contains("voxtrace merge"), "{said}");
    // What ends within the first bytes is told as it is from a file.
    std::fs::write(folder.path("short"), "voxf").unwrap();
    let output = piped("short", &["info", "/dev/stdin"]);
    assert!(stderr(&output).contains("/dev/stdin: unknown format"), "{}", stderr(&output));
    assert!(folder.fail(&["convert", "a.vxf", "a.glb"], 3).contains("a.vxf: not supported: a film (.vxf)"));
}
