//! Nobody's file is written over: every verb that writes, with every kind of output, on top of every kind of input, by hard links and symbolic ones
//! in turn. `outputs` tells the single cases.

use crate::common::Folder;
use crate::outputs::{SCENES, folder};

/// What a run reads: arguments after the verb, and the files that are read through them.
type Case<'a> = (Vec<&'a str>, Vec<&'a str>);

/// Puts a link to an input where an output will be.
fn link(folder: &Folder, input: &str, output: &str, is_hard: bool) {
    let (from, to) = (folder.path(input), folder.path(output));
    // Elsewhere symbolic links want rights that tests may lack.
    let is_hard = is_hard || cfg!(not(unix));
    #[cfg(unix)]
    if !is_hard {
        return std::os::unix::fs::symlink(from, to).unwrap();
    }
    assert!(is_hard);
    std::fs::hard_link(from, to).unwrap();
}

/// Runs the program, which must refuse with code 4 and leave every input as it was.
fn assert_refused(folder: &Folder, arguments: &[&str], output: &str, inputs: &[&str], turn: &mut usize) {
    let before: Vec<Vec<u8>> = inputs.iter().map(|input| folder.bytes(input)).collect();
    for input in inputs {
        *turn += 1;
        link(folder, input, output, turn.is_multiple_of(2));
        let error = folder.fail(arguments, 4);
        let is_said =
            error.contains("this run reads") || error.contains("belongs to it") || error.contains("to continue");
        assert!(is_said, "{arguments:?} on {input}: {error}");
        std::fs::remove_file(folder.path(output)).unwrap();
        for (other, bytes) in inputs.iter().zip(&before) {
            assert!(folder.bytes(other) == *bytes, "{arguments:?} on {input} changed {other}");
        }
    }
}

/// Scenes that `convert` and `voxelize` take too.
fn scenes() -> Vec<Case<'static>> {
    let of = |(arguments, inputs): &(&[&'static str], &[&'static str])| (arguments.to_vec(), inputs.to_vec());
    let mut all: Vec<Case> = SCENES.iter().map(of).collect();
    let overlaid = ["head.nhdr", "--overlay", "second.nrrd"];
    all.push((overlaid.to_vec(), vec!["head.nhdr", "head.raw", "second.nrrd"]));
    let labelled = ["head.nhdr", "--labels", "parts.nrrd", "--label-colors", "names.txt"];
    all.push((labelled.to_vec(), vec!["parts.nrrd", "names.txt"]));
    all
}

/// The folder of the other tests, with further inputs.
fn inputs() -> Folder {
    let folder = folder();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path(name), bytes).unwrap();
    let volume =
        |bytes: &[u8]| [b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n", bytes].concat();
    write("second.nrrd", &volume(&[0, 90, 160, 0].repeat(16)));
    write("parts.nrrd", &volume(&[0, 1, 2, 0].repeat(16)));
    write("names.txt", b"1 left 255 0 0 0\n2 right 0 0 255 0\n");
    let camera =
        |number: u32| format!("[bookmarks.{number}]\neye = [{number}.0, -30.0, 18.0]\ntarget = [12.0, 12.0, 2.0]\n");
    write("flight.toml", (camera(1) + &camera(2)).as_bytes());
    // Without runs.
    let pixels = [140u8, 140, 140, 128].repeat(64);
    write("sky.hdr", &[b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 16\n", &pixels[..]].concat());
    folder
}

#[test]
fn no_scene_of_any_format_is_written_over_what_it_was_made_of() {
    let extensions = ["vxt", "vox", "glb", "obj", "ply", "qb", "schem", "asc", "png"];
    let named: serde_json::Value = serde_json::from_str(&Folder::new().succeed(&["formats", "--json"])).unwrap();
    let is_picture = |format: &&serde_json::Value| format["extension"] == "vxf" || format["extension"] == "exr";
    for format in
        named["formats"].as_array().unwrap().iter().filter(|format| format["write"] == true && !is_picture(format))
    {
        assert!(extensions.contains(&format["extension"].as_str().unwrap()), "{format} is not in this table");
    }
    std::thread::scope(|scope| {
        for (at, (scene, read)) in scenes().into_iter().enumerate() {
            scope.spawn(move || {
                let (folder, mut turn) = (inputs(), at);
                for extension in extensions {
                    let output = format!("o.{extension}");
                    let arguments = [&["convert"], &scene[..], &[&output]].concat();
                    assert_refused(&folder, &arguments, &output, &read, &mut turn);
                    // `voxelize` makes no heightmaps.
                    if !matches!(extension, "asc" | "png") {
                        let arguments = [&["voxelize"], &scene[..], &["-o", &output]].concat();
                        assert_refused(&folder, &arguments, &output, &read, &mut turn);
                    }
                }
                // The materials beside an OBJ.
                assert_refused(&folder, &[&["convert"], &scene[..], &["o.obj"]].concat(), "o.mtl", &read, &mut turn);
                assert!(!folder.exists("o.obj"));
            });
        }
    });
}

#[test]
fn no_picture_film_or_frame_is_written_over_anything_that_render_reads() {
    let all = ["--sky", "sky.hdr", "--camera-file", "camera.toml"];
    let read = ["sky.hdr", "camera.toml"];
    let flight = ["--flight", "flight.toml", "--frames", "1..2", "-o", "o_##.png"];
    std::thread::scope(|scope| {
        for (at, (scene, own)) in scenes().into_iter().enumerate() {
            scope.spawn(move || {
                let (folder, mut turn) = (inputs(), at);
                let own: Vec<&str> = own.into_iter().chain(read).collect();
                for (option, output) in [("-o", "o.png"), ("-o", "o.exr"), ("-o", "o.vxf"), ("--checkpoint", "o.vxf")] {
                    let arguments = [&["render"], &scene[..], &all, &[option, output]].concat();
                    assert_refused(&folder, &arguments, output, &own, &mut turn);
                }
                // By a name with a detour.
                let arguments = [&["render"], &scene[..], &all, &["-o", "./slices/../o.png"]].concat();
                assert_refused(&folder, &arguments, "o.png", &own, &mut turn);
                let arguments = [&["render"], &scene[..], &flight].concat();
                assert_refused(&folder, &arguments, "o_02.png", &[&own[..1], &["flight.toml"]].concat(), &mut turn);
            });
        }
    });
}

#[test]
fn no_frame_or_clip_is_written_over_what_an_animation_is_made_of() {
    let (folder, mut turn) = (inputs(), 0);
    let script = "scene = \"room.vox\"\nfps = 12\nframes = 3\n[camera]\norbit = 1\n";
    std::fs::write(folder.path("turn.toml"), script).unwrap();
    let small = ["--size", "24x16", "--spp", "1"];
    for (name, output) in [
        ("o_##.png", "o_02.png"),
        ("o_##.exr", "o_03.exr"),
        ("o_##.vxf", "o_01.vxf"),
        ("o.gif", "o.gif"),
        ("o.png", "o.png"),
        ("o.mp4", "o.mp4"),
    ] {
        let arguments = [&["animate", "turn.toml", "-o", name], &small[..]].concat();
        assert_refused(&folder, &arguments, output, &["turn.toml", "room.vox"], &mut turn);
        assert!(!folder.exists(&format!("{output}.frames")), "{output}: no folder is left");
    }
    // Where nothing is in the way they are written.
    folder.succeed(&[&["animate", "turn.toml", "-o", "o_##.png", "-o", "o.gif"], &small[..]].concat());
}

#[test]
fn no_map_merged_film_or_report_is_written_over_what_it_is_of() {
    let (folder, mut turn) = (inputs(), 0);
    let render = |outputs: &[&str]| {
        folder.succeed(&[&["render", "room.vox", "--size", "24x16", "--spp", "1"], outputs].concat());
    };
    render(&["-o", "a.png", "-o", "a.exr", "-o", "a.vxf"]);
    render(&["-o", "b.vxf", "--first-sample", "1"]);
    for (a, b) in [("a.png", "a.exr"), ("a.exr", "a.vxf"), ("a.vxf", "a.png")] {
        assert_refused(&folder, &["compare", a, b, "-o", "map.png"], "map.png", &[a, b], &mut turn);
    }
    for output in ["o.png", "o.exr", "o.vxf"] {
        assert_refused(&folder, &["merge", "a.vxf", "b.vxf", "-o", output], output, &["a.vxf", "b.vxf"], &mut turn);
    }
    assert_refused(
        &folder,
        &["render", "room.vox", "--resume", "a.vxf", "--spp", "2", "-o", "o.png"],
        "o.png",
        &["a.vxf", "room.vox"],
        &mut turn,
    );
    let bench = ["bench", "--plan", "plan.toml", "--camera-file", "camera.toml", "-o", "report"];
    let names = [
        "results.json",
        "report.md",
        "report.html",
        "1-room-cpu.csv",
        "1-room-cpu-primary.csv",
        "1-room-cpu.jpg",
        "1-room-exact-voxels.jpg",
        "frame-time-1-room.svg",
    ];
    let read = ["room.vxt", "plan.toml", "camera.toml"];
    for (at, name) in names.into_iter().enumerate() {
        // What was written before the link was met.
        let _ = std::fs::remove_dir_all(folder.path("report"));
        std::fs::create_dir(folder.path("report")).unwrap();
        assert_refused(&folder, &bench, &format!("report/{name}"), &[read[at % read.len()]], &mut turn);
    }
    // Without a link each of these files is written.
    folder.succeed(&bench);
    names.iter().for_each(|name| assert!(folder.exists(&format!("report/{name}")), "{name}"));
}
