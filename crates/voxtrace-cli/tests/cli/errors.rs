//! One clear line and the documented exit code for everything that can be wrong, and no harm to what was there.

use crate::common::Folder;
use voxtrace_test_support::{data, files_below};

#[test]
fn wrong_arguments_are_explained_in_one_line_with_code_2() {
    let folder = Folder::new();
    let cases: [(&[&str], &str); 74] = [
        (&[], "a verb is missing"),
        (&["paint"], "unrecognized subcommand 'paint'"),
        (&["render"], "<SCENE>"),
        (&["render", "room.vox", "--ssp", "4"], "--ssp"),
        (&["render", "room.vox", "a.png"], "hint: -o a.png names the picture"),
        (&["devices", "extra"], "extra"),
        (&["convert", "room.vox"], "the file to write is missing"),
        (&["render", "room.vox", "--size", "0x5"], "at least one pixel"),
        (&["render", "room.vox", "--size", "100000x5"], "65536"),
        (&["render", "room.vox", "--size", "60000x60000"], "--crop"),
        (&["render", "room.vox", "--size", "big"], "1280x720"),
        (&["render", "room.vox", "--spp", "0"], "at least one sample"),
        (&["render", "room.vox", "--spp", "-4"], "-4"),
        (&["render", "room.vox", "--spp", "4000000000"], "1048576"),
        (&["render", "room.vox", "--crop", "5,5,0,9"], "empty"),
        (&["render", "room.vox", "--crop", "0,9999,0,9"], "beyond the picture"),
        (&["render", "room.vox", "--eye", "nan,0,0"], "not a finite number"),
        (&["render", "room.vox", "--fov", "180"], "between 0 and 180"),
        (&["render", "room.vox", "--eye", "1,1,1", "--target", "1,1,1"], "stands on its target"),
        (&["render", "room.vox", "--up", "0,0,0"], "no direction"),
        (&["render", "room.vox", "--camera", "nave"], "front, side, auto, all"),
        (&["render", "room.vox", "--camera", "nave"], "front, back, left, right, top, bottom"),
        (&["render", "room.vox", "--camera", "iso"], "--projection isometric"),
        (&["render", "room.vox", "--width", "64", "--height", "48"], "hint: --size 1280x720"),
        (
            &["render", "room.vox", "--height", "48"],
            "needs a heightmap, and room.vox is none; hint: the size of a picture",
        ),
        (&["render", "city", "--height", "48"], "needs a heightmap, and city is none"),
        (&["render", "room.vox", "--spp", "4", "--width", "64"], "hint: --size 1280x720"),
        (&["render", "room.vox", "-w", "64"], "hint: --size 1280x720"),
        (&["render", "room.vox", "--resolution", "640x480"], "hint: --size 640x480"),
        (&["render", "room.vox", "--quality", "high"], "hint: --noise 0.02"),
        (&["render", "room.vox", "--noise-threshold", "0.1"], "hint: --noise 0.02"),
        (&["render", "room.vox", "-n", "16"], "hint: --spp N"),
        (&["render", "room.vox", "--fps", "24"], "hint: --frames N"),
        (&["render", "room.vox", "--output-format", "png"], "the output's name says it"),
        (&["render", "room.vox", "--dof"], "hint: --aperture"),
        (&["render", "room.vox", "--turntable", "--frames", "101,105"], "hint: --frames N makes one"),
        (&["render", "room.vox", "--dof=3"], "hint: --aperture"),
        (&["render", "room.vox", "--gpu"], "--traversal walk"),
        (&["render", "room.vox", "-f", "png"], "the output's name says it"),
        (&["render", "room.vox", "--turntable", "--frames", "101,105"], "is a list"),
        (&["render", "room.vox", "-o", "fr_%04d.exr"], "write ####"),
        (&["render", "room.vox", "-o", "-"], "standard output"),
        (&["render", "room.vox", "--camera", "all", "--eye", "1,2,3"], "several were named"),
        (&["render", "room.vox", "--camera", "side", "--camera-file", "a.toml"], "cannot be used with"),
        (&["render", "room.vox", "--frames", "1..4"], "--turntable"),
        (&["render", "room.vox", "--turntable", "--frames", "4..1"], "1..240"),
        (&["render", "room.vox", "--turntable=4294967295"], "not in 0..=1000000"),
        (&["render", "room.vox", "--flight", "a.toml", "--turntable"], "cannot be used with"),
        (&["render", "room.vox", "--time-limit", "soon"], "duration"),
        (&["render", "room.vox", "--checkpoint-every", "9s"], "not provided: --checkpoint <FILE>"),
        (&["render", "room.vox", "--exposure", "inf"], "finite"),
        (&["render", "room.vox", "--voxels", "1000"], "built-in scenes"),
        (&["render", "church", "--voxels", "3"], "cannot build a scene of 3 voxels"),
        (&["render", "room.vox", "-o", "a.gif"], ".png, .exr or .vxf"),
        (&["render", "room.vox", "-o", "a.png", "--bit-depth", "32"], "8 or 16 bits"),
        (&["render", "room.vox", "-o", "a.exr", "--bit-depth", "8"], "16 or 32 bits"),
        (&["render", "room.vox", "-o", "a.png", "-o", "a.png"], "written twice"),
        (&["render", "room.vox", "-o", "a.vxf", "--checkpoint", "./a.vxf"], "written twice"),
        (&["render", "room.vox", "--threads", "0"], "--threads"),
        (&["render", "room.vox", "--material", "3"], "NUMBER=COLOR"),
        (&["render", "room.vox", "--material", "3=#ffffff,-1"], "not below 0"),
        (&["render", "room.vox", "--material", "255=#ffffff"], "numbers 0 to 254"),
        (&["render", "room.vox", "--hide", "roof"], "no part \"roof\""),
        (&["bench", "room.vox", "--cells", "cpu", "--eye", "1,1,1", "--target", "1,1,1"], "stands on its target"),
        (&["convert", "room.vox", "a.stl"], "name it .vxt, .vox"),
        (&["merge", "a.vxf"], "needs an output"),
        (&["merge", "a.vxf", "-o", "a.png", "-o", "./a.png"], "./a.png is written twice; hint: name each output once"),
        (&["animate", "room.vox", "--turntable=2", "-o", "a.gif", "-o", "./a.gif"], "./a.gif is written twice"),
        (&["info", "room.vox", "--voxel-size", "0"], "0 is no length above 0"),
        (&["info", "room.vox", "--voxel-size", "nan"], "nan is no length above 0"),
        (&["info", "room.vox", "--voxel-size", "cm"], "a length like 0.02, 2cm or 2ft"),
        (&["render", "room.vox", "--spp", "-1"], "invalid value '-1' for '--spp"),
        (&["animate", "room.vox", "--fps", "-1"], "invalid value '-1' for '--fps"),
        (&["info", "room.vox", "--spacing", "1e10"], "not from 1e-9 to 1e9"),
    ];
    for (arguments, expected) in cases {
        let line = folder.fail(arguments, 2);
        assert!(line.contains(expected), "{arguments:?}: {line}");
    }
    assert!(!folder.exists("a.png") && !folder.exists("room.png"));
}

#[test]
fn input_that_is_missing_or_not_a_scene_has_code_3() {
    let folder = Folder::new();
    std::fs::write(folder.path("text.vox"), "no voxels here").unwrap();
    std::fs::write(folder.path("notes.txt"), "no voxels here").unwrap();
    std::fs::write(folder.path("wrong.vxt"), vec![0; 400]).unwrap();
    std::fs::write(folder.path("cut.vox"), &folder.bytes("room.vox")[..600]).unwrap();
    std::fs::write(folder.path("wrong.toml"), "eye = 3").unwrap();
    let mut flipped = folder.bytes("room.vxt");
    let last = flipped.len() - 1;
    flipped[last] ^= 1;
    std::fs::write(folder.path("flipped.vxt"), flipped).unwrap();
    let cases: [(&[&str], &str); 12] = [
        (&["compare", "room.vox", "cut.vox"], "no report of `voxtrace bench`"),
        (&["info", ""], "name is empty"),
        (&["render", "none.vox"], "cannot read none.vox"),
        (&["render", "cathedral"], "one of the built-in"),
        (&["info", "none.vxt"], "cannot read none.vxt"),
        (&["info", "text.vox"], "at byte 0"),
        (&["info", "cut.vox"], "at byte"),
        (&["info", "notes.txt"], "formats"),
        (&["convert", "wrong.vxt", "a.vox"], "at byte 0"),
        (&["info", "flipped.vxt"], "checksum"),
        (&["render", "room.vox", "--camera-file", "none.toml"], "cannot read the camera file none.toml"),
        (&["render", "room.vox", "--camera-file", "wrong.toml"], "`eye` is not [x, y, z]"),
    ];
    for (arguments, expected) in cases {
        let line = folder.fail(arguments, 3);
        assert!(line.contains(expected), "{arguments:?}: {line}");
        assert!(line.contains("hint: "), "{line}");
        assert!(!line.contains("os error"), "{line}");
    }
}

#[test]
fn an_output_that_cannot_be_written_has_code_4_before_any_work_and_spares_what_is_there() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder.png")).unwrap();
    std::fs::write(folder.path("good.png"), "old").unwrap();
    let locked = folder.path("locked.png");
    std::fs::write(&locked, "old").unwrap();
    let mut permissions = std::fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&locked, permissions).unwrap();
    let cases: [(&[&str], &str); 6] = [
        // The scene does not even exist: the output is looked at first.
        (&["render", "none.vox", "-o", "missing/a.png"], "folder does not exist"),
        (&["render", "none.vox", "-o", "room.vox/a.png"], "room.vox/a.png"),
        (&["render", "none.vox", "-o", "folder.png"], "directory"),
        (&["render", "none.vox", "-o", "good.png", "-o", "locked.png"], "locked.png"),
        (&["render", "none.vox", "--checkpoint", "missing/a.vxf"], "missing/a.vxf"),
        (&["convert", "room.vox", "missing/a.vxt"], "missing/a.vxt"),
    ];
    for (arguments, expected) in cases {
        let line = folder.fail(arguments, 4);
        assert!(line.contains(expected) && line.contains("cannot write"), "{arguments:?}: {line}");
    }
    assert_eq!(folder.bytes("good.png"), b"old");
    assert_eq!(folder.bytes("locked.png"), b"old");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_costs_one_file_and_not_the_others() {
    use crate::common::{SMALL, stderr};
    let folder = Folder::new();
    std::os::unix::fs::symlink("/dev/full", folder.path("full.png")).unwrap();
    let arguments = [&["render", "room.vox", "-o", "full.png", "-o", "good.png"], &SMALL[..]].concat();
    let output = folder.run(&arguments);
    assert_eq!(output.status.code(), Some(4));
    let text = stderr(&output);
    assert!(text.contains("error: cannot write full.png: no space left on device"), "{text}");
    assert_eq!(folder.png("good.png").width, 40);
    // Every writer says the same of it, whatever library encodes.
    let clip = ["animate", "room.vox", "--turntable=2", "--size", "40x30", "--spp", "1", "-o", "full.png"];
    for arguments in
        [&["compare", "good.png", "good.png", "-o", "full.png"][..], &["convert", "room.vox", "full.png"], &clip]
    {
        let line = folder.fail(arguments, 4);
        let expected = "error: cannot write full.png: no space left on device; hint: free some space";
        assert!(line.starts_with(expected), "{arguments:?}: {line}");
    }
}

#[test]
fn options_that_mean_nothing_to_what_is_asked_are_said_and_end_nothing() {
    use crate::common::{SMALL, stderr};
    let folder = Folder::new();
    folder.render("a.png", &["-o", "a.vxf"]);
    let warnings = |arguments: &[&str]| {
        let output = folder.run(&[arguments, &["--quiet"]].concat());
        let text = stderr(&output);
        assert!(output.status.success(), "{arguments:?}: {text}");
        let lines =
            text.lines().map(|line| line.strip_prefix("warning: ").unwrap_or_else(|| panic!("{line}")).to_owned());
        lines.collect::<Vec<String>>()
    };
    let render = |options: &[&str]| warnings(&[&["render", "room.vox"], options, &SMALL[..]].concat());
    let tone = ["--exposure", "1", "--tone-map", "linear"];
    let device = ["--device", "another", "--fast", "--memory-budget", "1GB", "--primitive", "grid"];
    let no_png = |option: &str| format!("{option} is for PNG, and there is none: add -o NAME.png");
    assert_eq!(render(&[&tone[..], &["-o", "b.exr"]].concat()), [no_png("--exposure"), no_png("--tone-map")]);
    assert_eq!(warnings(&["merge", "a.vxf", "-o", "b.exr", "--exposure", "1"]), [no_png("--exposure")]);
    for (options, said) in [
        (&["-o", "b.vxf", "--bit-depth", "16"][..], "--bit-depth is for PNG and EXR, and there is none"),
        (
            &[&["-o", "b.png", "--traversal", "cpu"], &device[..]].concat(),
            "--primitive, --device, --fast, --memory-budget change nothing: the CPU traces",
        ),
        (&["-o", "b.png", "--traversal", "cpu", "--fast"], "--fast changes nothing: the CPU traces"),
        (
            &["-o", "b.png", "--primitive", "grid"],
            "--primitive changes nothing: it is for --traversal query and pipeline",
        ),
    ] {
        let warnings = render(options);
        assert!(warnings.len() == 1 && warnings[0].starts_with(said), "{options:?}: {warnings:?}");
    }
    let clip = [&["animate", "room.vox", "--turntable=2", "-o", "b.gif"], &SMALL[..]].concat();
    let said = warnings(&[&clip[..], &["--clip-quality", "50", "--encoder", "builtin"]].concat());
    assert_eq!(
        said,
        ["--encoder", "--clip-quality"].map(|o| format!("{o} is for MP4, and there is none: add -o NAME.mp4"))
    );
    let said = warnings(&[&["compare", "a.png", "a.png"], &tone[..]].concat());
    assert!(
        said.len() == 1 && said[0].starts_with("--exposure, --tone-map change nothing: both pictures are PNG"),
        "{said:?}"
    );
    // A film of --denoise knows how noisy it is.
    assert_eq!(render(&["-o", "b.vxf", "--denoise"]), [""; 0]);
    // Where they mean something, and what nobody said here, is nothing to talk about.
    let pictures = ["-o", "b.png", "-o", "b.exr", "--denoise", "--bit-depth", "16"];
    assert_eq!(render(&[&pictures[..], &tone].concat()), [""; 0]);
    assert_eq!(warnings(&[&["compare", "a.png", "a.vxf"], &tone[..]].concat()), [""; 0]);
    let cpu = [&["render", "room.vox", "-q", "-o", "b.png", "--traversal", "cpu"], &SMALL[..]].concat();
    let output = folder.command(&cpu).env("VOXTRACE_DEVICE", "0").output().unwrap();
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()));
}

#[cfg(target_os = "linux")]
#[test]
fn results_that_a_full_disk_loses_have_code_4_and_a_reader_that_went_away_has_none() {
    use crate::common::stderr;
    let folder = Folder::new();
    let plan = ["plan", "room.vox", "--parts", "2", "-o", "a.png", "--spp", "4"];
    let asked = [&["--help"][..], &["help", "bench"], &["--version"]];
    for arguments in [&plan[..], &["info", "room.vox", "--json"], &["formats"]].into_iter().chain(asked) {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = folder.command(arguments).stdout(full).output().unwrap();
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(4), "{arguments:?}: {text}");
        assert!(text.contains("error: cannot write to standard output: no space left on device"), "{text}");
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = folder.command(arguments).stdout(writer).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", stderr(&output));
    }
}

#[test]
fn every_malformed_file_of_the_shared_data_gives_one_line_with_an_offset() {
    let Some(data) = data() else { return };
    let folder = Folder::new();
    let files = files_below(&data.join("malformed"), &["vox"]);
    assert!(!files.is_empty());
    for file in files {
        // One holds nothing, the other only strange names: nothing in them contradicts the format.
        if ["vox_empty_model.vox", "vox_vox-to-kv6-broken.vox"].iter().any(|valid| file.ends_with(valid)) {
            continue;
        }
        let line = folder.fail(&["info", file.to_str().unwrap()], 3);
        assert!(line.contains("at byte "), "{line}");
    }
}

#[test]
fn names_of_files_stay_as_they_are_in_messages() {
    let folder = Folder::new();
    std::fs::write(folder.path("Castle Tower.VOX"), "no voxels here").unwrap();
    assert!(folder.fail(&["info", "Castle Tower.VOX"], 3).contains("Castle Tower.VOX"));
    assert!(folder.fail(&["info", "Keep/Gate.OBJ"], 3).contains("cannot read Keep/Gate.OBJ: no such file"));
    std::fs::create_dir(folder.path("Folder.PNG")).unwrap();
    assert!(folder.fail(&["render", "room.vox", "-o", "Folder.PNG"], 4).contains("Folder.PNG"));
    let said = folder.fail(&["bench", "room.vox", "--plan", "My Plan.TOML"], 3);
    assert!(said.contains("My Plan.TOML") && !said.contains("os error"), "{said}");
    std::fs::write(folder.path("Points.PCD"), "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA Zipped\n0 0 0\n").unwrap();
    let said = folder.fail(&["info", "Points.PCD"], 3);
    assert!(said.contains("Points.PCD") && said.contains("\"Zipped\"") && !said.contains("Some("), "{said}");
}

#[test]
fn a_film_of_another_picture_says_what_differs_in_the_words_of_options() {
    let folder = Folder::new();
    folder.render("a.png", &["--checkpoint", "a.vxf"]);
    let resume = |options: &[&str]| {
        folder.fail(&[&["render", "room.vox", "--resume", "a.vxf", "--spp", "8", "-o", "b.png"], options].concat(), 5)
    };
    for (options, expected) in [
        (&["--eye", "1,2,30"][..], "--eye 1,2,30"),
        (&["--projection", "orthographic"], "lens pinhole in the film, orthographic, view height"),
        (&["--sun", "40,30"], "sky of the film, another one asked for"),
    ] {
        let said = resume(options);
        let is_of_rust = ["Some(", "None", "Vec3", "{ "].iter().any(|word| said.contains(word));
        assert!(said.contains(expected) && !is_of_rust, "{said}");
    }
    let turntable = [&["render", "room.vox", "--turntable", "-o", "t_#.png"], &crate::common::SMALL[..]].concat();
    folder.succeed(&[&turntable[..], &["--frames", "1..2", "--checkpoint", "t_#.vxf"]].concat());
    let resume = ["render", "room.vox", "--turntable", "--resume", "t_#.vxf", "--spp", "8", "-o", "t_#.png"];
    let said = folder.fail(&resume, 5);
    assert!(
        said.contains("cannot continue t_2.vxf: camera --eye") && said.contains("say --frames as before"),
        "{said}"
    );
    folder.succeed(&[&resume[..], &["--frames", "1..2"]].concat());
}

#[test]
fn what_is_sound_and_empty_is_not_called_damaged() {
    let folder = Folder::new();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path(name), bytes).unwrap();
    write("empty.obj", b"# nothing\n");
    write(
        "empty.ply",
        b"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
    );
    write("empty.stl", b"solid nothing\nendsolid nothing\n");
    write("empty.gltf", br#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[]}]}"#);
    let element = |group: u16, number: u16, kind: &[u8; 2], value: &[u8]| {
        let head = [group.to_le_bytes(), number.to_le_bytes()].concat();
        [&head[..], kind, &(value.len() as u16).to_le_bytes(), value].concat()
    };
    let plan = [
        [0; 128].to_vec(),
        b"DICM".to_vec(),
        element(2, 0x10, b"UI", b"1.2.840.10008.1.2.1\0"),
        element(8, 0x60, b"CS", b"RTPLAN"),
        element(0x10, 0x10, b"PN", b"A^B "),
    ];
    write("plan.dcm", &plan.concat());
    for name in ["empty.obj", "empty.ply", "empty.stl", "empty.gltf", "plan.dcm"] {
        let said = folder.fail(&["info", name], 3);
        assert!(!said.contains("damaged") && !said.contains("export it again"), "{said}");
    }
    assert!(folder.fail(&["info", "plan.dcm"], 3).contains("(RTPLAN) without a picture"));
    // A file that is cut off is.
    write("cut.ply", b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n");
    assert!(folder.fail(&["info", "cut.ply"], 3).contains("the file is damaged"));
}
