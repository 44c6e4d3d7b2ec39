//! No output takes the place of an input, of a file that an input names, or, under a name that nobody chose, of a file of
//! others.

use crate::common::{Folder, SMALL, stderr};

/// What a run reads: arguments after the verb, and the files that are read through them.
pub type Case = (&'static [&'static str], &'static [&'static str]);

/// Scenes of all kinds with what they name.
pub const SCENES: [Case; 7] = [
    (&["castle.obj", "--resolution", "16"], &["castle.obj", "castle.mtl", "castle.png"]),
    (&["triangle.gltf", "--resolution", "16"], &["triangle.gltf", "triangle.bin"]),
    (&["hill.png", "--color-image", "paint.png"], &["hill.png", "paint.png"]),
    (&["head.nhdr", "--transfer", "soft.toml"], &["head.nhdr", "head.raw", "soft.toml"]),
    (&["slices"], &["slices/000.png", "slices/001.png"]),
    (&["room.vox", "--palette-image", "paint.png"], &["room.vox", "paint.png"]),
    (&["room.vxt"], &["room.vxt"]),
];

fn png(side: u32, color: impl Fn(u32, u32) -> [u8; 3]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side, side);
    encoder.set_color(png::ColorType::Rgb);
    let pixels: Vec<u8> = (0..side * side).flat_map(|at| color(at % side, at / side)).collect();
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    bytes
}

/// A folder with a file of each kind.
pub fn folder() -> Folder {
    let folder = Folder::new();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path(name), bytes).unwrap();
    write(
        "castle.obj",
        b"mtllib castle.mtl\nv 0 0 0\nv 4 0 0\nv 0 4 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n",
    );
    write("castle.mtl", b"newmtl m\nmap_Kd castle.png\n");
    write("castle.png", &png(4, |x, y| [x as u8 * 60, y as u8 * 60, 0]));
    let corners = [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    write("triangle.bin", &corners.map(f32::to_le_bytes).concat());
    write(
        "triangle.gltf",
        br#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"triangle.bin","byteLength":36}]}"#,
    );
    write("hill.png", &png(8, |x, y| [(x * y) as u8; 3]));
    write("paint.png", &png(8, |x, _| [200, x as u8 * 20, 40]));
    write("head.nhdr", b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: raw\ndata file: head.raw\n\n");
    write("head.raw", &[0, 200, 200, 0].repeat(16));
    write(
        "soft.toml",
        b"threshold = 100\n[[stop]]\nvalue = 0\ncolor = \"#804020\"\n[[stop]]\nvalue = 255\ncolor = \"#ffffff\"\n",
    );
    std::fs::create_dir(folder.path("slices")).unwrap();
    for slice in 0..3 {
        write(&format!("slices/00{slice}.png"), &png(4, |x, y| [((x + y) * 60) as u8; 3]));
    }
    write("camera.toml", b"eye = [12.0, -30.0, 18.0]\ntarget = [12.0, 12.0, 2.0]\n");
    write("plan.toml", b"scenes = [\"room.vxt\"]\ncells = [\"cpu\"]\nframes = 1\nsize = \"16x16\"\nsweep = []\n");
    folder
}

/// Runs the program with an output that leads to an input, by a link of either kind: refused, and nothing is touched.
fn assert_refused(folder: &Folder, arguments: &[&str], output: &str, input: &str) {
    let before = folder.bytes(input);
    for is_hard in [true, false] {
        let (from, to) = (folder.path(input), folder.path(output));
        if is_hard {
            std::fs::hard_link(&from, &to).unwrap();
        } else {
            #[cfg(unix)]
            std::os::unix::fs::symlink(&from, &to).unwrap();
            #[cfg(not(unix))]
            std::fs::hard_link(&from, &to).unwrap();
        }
        let error = folder.fail(arguments, 4);
        assert!(error.contains("this run reads"), "{arguments:?} on {input}: {error}");
        assert!(folder.bytes(input) == before, "{arguments:?} changed {input}");
        std::fs::remove_file(to).unwrap();
    }
}

#[test]
fn no_picture_film_or_scene_is_written_over_a_scene_or_what_it_names() {
    let folder = folder();
    for (scene, inputs) in SCENES {
        for input in inputs {
            for (output, option) in [("o.png", "-o"), ("o.exr", "-o"), ("o.vxf", "-o"), ("o.vxf", "--checkpoint")] {
                assert_refused(&folder, &[&["render"], scene, &[option, output]].concat(), output, input);
            }
            // The third frame of an animation, and the name that it has when it is broken off.
            for output in ["o_03.png", "o_03.part.png"] {
                let animation = ["--turntable", "--frames", "1..4", "-o", "o_##.png"];
                assert_refused(&folder, &[&["render"], scene, &animation].concat(), output, input);
                assert!(!folder.exists("o_01.png"), "refused before the first frame");
            }
            for output in ["o.vox", "o.vxt"] {
                assert_refused(&folder, &[&["convert"], scene, &[output]].concat(), output, input);
                assert_refused(&folder, &[&["voxelize"], scene, &["-o", output]].concat(), output, input);
            }
        }
        // Without such a link each of them does it.
        let written = folder.succeed(&[&["render"], scene, &["-o", "o.png"], &SMALL[..]].concat());
        assert_eq!(written, "o.png\n");
        for output in ["o.vox", "o.vxt"] {
            assert_eq!(folder.succeed(&[&["convert"], scene, &[output]].concat()).trim(), output);
            assert_eq!(folder.succeed(&[&["voxelize"], scene, &["-o", output]].concat()).trim(), output);
            std::fs::remove_file(folder.path(output)).unwrap();
        }
        std::fs::remove_file(folder.path("o.png")).unwrap();
    }
}

#[test]
fn what_is_larger_than_memory_is_not_written_over_either() {
    let folder = folder();
    let mut stl = vec![b' '; 80];
    stl.extend(60_000u32.to_le_bytes());
    for at in 0..60_000 {
        let (x, y) = ((at % 300) as f32, (at / 300) as f32);
        let corners = [x, y, 0.0, x + 1.0, y, 0.0, x, y + 1.0, 1.0];
        stl.extend([0; 12]);
        stl.extend(corners.iter().flat_map(|value| value.to_le_bytes()));
        stl.extend([0; 2]);
    }
    std::fs::write(folder.path("sheet.stl"), stl).unwrap();
    let arguments = ["voxelize", "sheet.stl", "--memory-budget", "1MB", "-o", "o.vxt"];
    assert_refused(&folder, &arguments, "o.vxt", "sheet.stl");
    assert_refused(&folder, &arguments, "o.vxt.part", "sheet.stl");
    assert_eq!(folder.succeed(&arguments), "o.vxt\n");
}

#[test]
fn cameras_films_and_plans_are_inputs_too() {
    let folder = folder();
    let render = |options: &[&'static str]| [&["render", "room.vox"], options, &SMALL[..]].concat();
    for output in ["o.png", "o.exr", "o.vxf"] {
        assert_refused(&folder, &render(&["--camera-file", "camera.toml", "-o", output]), output, "camera.toml");
    }
    folder.succeed(&render(&["--checkpoint", "a.vxf", "--first-sample", "0"]));
    folder.succeed(&render(&["--checkpoint", "b.vxf", "--first-sample", "4"]));
    for output in ["o.png", "o.exr", "o.vxf"] {
        for film in ["a.vxf", "b.vxf"] {
            assert_refused(&folder, &["merge", "a.vxf", "b.vxf", "-o", output], output, film);
        }
    }
    assert!(folder.fail(&["merge", "a.vxf", "b.vxf", "-o", "./slices/../a.vxf"], 4).contains("this run reads it"));
    // A film may be continued in its own file, but nothing else takes its place.
    std::fs::hard_link(folder.path("a.vxf"), folder.path("o.png")).unwrap();
    let resume = ["render", "room.vox", "--resume", "a.vxf", "--spp", "6"];
    let error = folder.fail(&[&resume[..], &["-o", "o.png"]].concat(), 4);
    assert!(error.contains("it is the film to continue"), "{error}");
    folder.succeed(&[&resume[..], &["--checkpoint", "a.vxf"]].concat());

    std::fs::create_dir(folder.path("report")).unwrap();
    for (output, input) in [("report/report.md", "room.vxt"), ("report/results.json", "plan.toml")] {
        assert_refused(&folder, &["bench", "--plan", "plan.toml", "-o", "report"], output, input);
        assert_eq!(std::fs::read_dir(folder.path("report")).unwrap().count(), 0, "refused before anything is written");
    }
}

#[test]
fn nothing_new_is_put_into_a_folder_that_is_read_whole() {
    let folder = folder();
    for output in ["slices/new.png", "./slices/../slices/new.png"] {
        let error = folder.fail(&["render", "slices", "-o", output], 4);
        assert!(error.contains("reads the whole folder"), "{error}");
    }
    folder.succeed(&[&["render", "slices/000.png", "-o", "slices/new.png"], &SMALL[..]].concat());
}

#[test]
fn a_folder_has_its_own_name_however_it_is_reached() {
    let folder = folder();
    std::fs::create_dir(folder.path("slices/below")).unwrap();
    let run =
        |below: &str, arguments: &[&str]| folder.command(arguments).current_dir(folder.path(below)).output().unwrap();
    for (below, scene) in [
        (".", "slices"),
        (".", "slices/"),
        (".", "slices/."),
        (".", "slices/below/.."),
        ("slices", "."),
        ("slices", "./"),
        ("slices/below", ".."),
        ("slices/below", "../"),
        ("slices/below", "../."),
    ] {
        let output = run(below, &["plan", scene, "--parts", "2"]);
        let plan = String::from_utf8(output.stdout).unwrap();
        assert!(
            plan.contains(r#""outputs":["slices.png"]"#) && plan.contains(r#""slices-part-0.vxf""#),
            "{scene}: {plan}"
        );
        let info: serde_json::Value = serde_json::from_slice(&run(below, &["info", scene, "--json"]).stdout).unwrap();
        assert_eq!(info["name"], "slices", "{below}, {scene}");
    }
    let output = run("slices", &["render", "."]);
    let error = stderr(&output);
    assert!(error.contains("cannot write slices.png: this run reads the whole folder"), "{error}");
    assert_eq!(folder.succeed(&[&["render", "slices/below/.."], &SMALL[..]].concat()), "slices.png\n");
}

#[test]
fn the_picture_of_a_mesh_does_not_take_the_place_of_its_texture() {
    // MagicaVoxel exports NAME.obj, NAME.mtl and NAME.png.
    let folder = folder();
    let texture = folder.bytes("castle.png");
    let render = ["render", "castle.obj", "--resolution", "16", "--size", "16x12", "--spp", "1"];
    for force in [&[][..], &["--force"], &["-o", "castle.png"], &["-o", "castle.png", "--force"]] {
        folder.fail(&[&render[..], force].concat(), 4);
        assert!(folder.bytes("castle.png") == texture);
    }
    // Nor does it become one where the texture is missing.
    std::fs::remove_file(folder.path("castle.png")).unwrap();
    let output = folder.run(&render);
    assert_eq!(output.status.code(), Some(4));
    let error = stderr(&output);
    assert!(error.contains("castle.png: this run reads it") && !folder.exists("castle.png"), "{error}");
    assert!(folder.fail(&["render", "hill.png"], 4).contains("hill.png: this run reads it"));
    assert!(folder.fail(&["convert", "room.vox", "room.vox"], 4).contains("room.vox: this run reads it"));
}

#[test]
fn a_default_name_takes_the_place_of_voxtrace_s_own_pictures_only() {
    let folder = folder();
    let render = [&["render", "room.vox"], &SMALL[..]].concat();
    assert_eq!(folder.succeed(&render), "room.png\n");
    let own = folder.bytes("room.png");
    folder.succeed(&[&render[..], &["--seed", "3"]].concat());
    assert_ne!(folder.bytes("room.png"), own);

    let foreign = folder.bytes("paint.png");
    std::fs::write(folder.path("room.png"), &foreign).unwrap();
    let error = folder.fail(&render, 4);
    assert!(error.contains("room.png is there already, and voxtrace did not write it") && error.contains("--force"));
    assert!(folder.bytes("room.png") == foreign);
    let animation = [&render[..], &["--turntable", "--frames", "1..2"]].concat();
    std::fs::write(folder.path("room_0002.png"), &foreign).unwrap();
    assert!(folder.fail(&animation, 4).contains("room_0002.png is there already"));
    assert!(!folder.exists("room_0001.png"));
    // Where somebody names it, or insists, it is replaced.
    folder.succeed(&[&render[..], &["-o", "room_0002.png"]].concat());
    folder.succeed(&animation);
    folder.succeed(&[&render[..], &["--force"]].concat());
    assert!(folder.bytes("room.png") == own);
}

#[test]
fn a_benchmark_nobody_named_a_folder_for_keeps_out_of_a_folder_of_others() {
    let folder = folder();
    std::fs::create_dir(folder.path("voxtrace-bench")).unwrap();
    std::fs::write(folder.path("voxtrace-bench/report.html"), "mine").unwrap();
    let bench = ["bench", "--plan", "plan.toml"];
    let error = folder.fail(&bench, 4);
    assert!(error.contains("no benchmark is in it") && error.contains("--force"), "{error}");
    assert_eq!(folder.bytes("voxtrace-bench/report.html"), b"mine");
    for options in [&["--force"][..], &[], &["-o", "voxtrace-bench"]] {
        folder.succeed(&[&bench[..], options].concat());
        assert_ne!(folder.bytes("voxtrace-bench/report.html"), b"mine");
    }
}
