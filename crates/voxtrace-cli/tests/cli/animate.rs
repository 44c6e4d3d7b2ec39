//! `animate`: the same frames however they are shared, clips that other programs read, and faults of animations in one line.

use super::common::Folder;
use std::process::{Command, Stdio};
use voxtrace::output::FilmFile;
use voxtrace_test_support::{Need, data, skip, skip_without};

/// Options of small frames on the CPU.
const SMALL: [&str; 6] = ["--size", "32x24", "--spp", "4", "--traversal", "cpu"];

/// A folder whose room spins, on a path, under a sun that sinks.
fn folder() -> Folder {
    let folder = Folder::new();
    let script = "scene = \"room.vox\"\nfps = 12.5\nframes = 6\nshutter = 0.5\n\
        [camera]\npath = [{ eye = [12, -30, 18], target = [12, 12, 2] }, { eye = [50, 12, 14], target = [12, 12, 2] }]\n\
        [[object]]\nname = \"0\"\nspin = { turns_per_second = 0.5 }\n\
        [sun]\nkeys = [{ at = 0, bearing = 100, height = 40 }, { at = 0.5, height = 5 }]\n";
    std::fs::write(folder.path("turn.toml"), script).unwrap();
    folder
}

fn animate(folder: &Folder, options: &[&str]) -> String {
    // An option may not be said twice.
    let own = if options.contains(&"--spp") { &["--size", "32x24", "--traversal", "cpu"][..] } else { &SMALL[..] };
    folder.succeed(&[&["animate", "turn.toml"], options, own].concat())
}

#[test]
fn frames_are_the_same_in_one_run_in_two_and_by_two_processes_sharing_them() {
    let folder = folder();
    animate(&folder, &["-o", "one_####.png"]);
    for (name, frames) in [("two_####.png", "1-2"), ("two_####.png", "3..6")] {
        animate(&folder, &["-o", name, "--frames", frames]);
    }
    let started: Vec<_> = ["1..3", "4..6"]
        .map(|frames| {
            let arguments = [&["animate", "turn.toml", "-o", "both_####.png", "--frames", frames], &SMALL[..]].concat();
            folder.command(&arguments).stdout(Stdio::null()).spawn().unwrap()
        })
        .into();
    for mut child in started {
        assert!(child.wait().unwrap().success());
    }
    let frame = |name: &str, number: u32| folder.bytes(&format!("{name}_{number:04}.png"));
    for number in 1..=6 {
        assert!(
            frame("one", number) == frame("two", number) && frame("one", number) == frame("both", number),
            "{number}"
        );
        assert!(number == 1 || frame("one", number) != frame("one", number - 1), "every frame is another");
    }
}

#[test]
fn samples_of_a_blurred_frame_from_two_machines_merge_to_the_frame() {
    let folder = folder();
    animate(&folder, &["-o", "whole_####.vxf", "--frames", "2"]);
    animate(&folder, &["-o", "a_####.vxf", "--frames", "2", "--spp", "3"]);
    animate(&folder, &["-o", "b_####.vxf", "--frames", "2", "--spp", "1", "--first-sample", "3"]);
    folder.succeed(&["merge", "a_0002.vxf", "b_0002.vxf", "-o", "merged.vxf"]);
    let film = |name: &str| FilmFile::open(&folder.path(name)).unwrap();
    assert!(film("merged.vxf").film == film("whole_0002.vxf").film);
    // A film of another shutter is of another picture.
    animate(&folder, &["-o", "c_####.vxf", "--frames", "2", "--spp", "1", "--first-sample", "3", "--shutter", "0.4"]);
    let told = folder.fail(&["merge", "a_0002.vxf", "c_0002.vxf", "-o", "wrong.vxf"], 5);
    assert!(told.contains("scene"), "{told}");
}

#[test]
fn a_turntable_of_animate_is_that_of_render() {
    let folder = Folder::new();
    let options = ["room.vox", "--turntable=6", "--frames", "2..3"];
    folder.succeed(&[&["animate"], &options[..], &["-o", "a_####.png"], &SMALL].concat());
    folder.succeed(&[&["render"], &options[..], &["-o", "r_####.png"], &SMALL].concat());
    // One is turned by our own sine and cosine, the other by the library's.
    let difference = |a: &str, b: &str| {
        let (a, b) = (folder.png(a).samples, folder.png(b).samples);
        a.iter().zip(&b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
    };
    assert!(difference("a_0002.png", "r_0002.png") < 0.5 && difference("a_0003.png", "r_0003.png") < 0.5);
    assert!(difference("a_0002.png", "r_0003.png") > 2.0, "the comparison sees another frame");
}

#[test]
fn a_clip_that_was_broken_off_goes_on_with_its_frames_and_others_are_made_anew() {
    let folder = folder();
    let clip = |options: &[&str]| {
        let arguments = [&["animate", "turn.toml", "-o", "clip.gif"], &SMALL[..], options].concat();
        let output = folder.run(&arguments);
        assert!(output.status.success(), "{}", super::common::stderr(&output));
        (folder.bytes("clip.gif"), super::common::stderr(&output))
    };
    let (whole, _) = clip(&["--keep-frames"]);
    assert!(folder.exists("clip.gif.frames/0006.png"));
    // As after a kill: two frames are there, and no clip.
    for number in 3..=6 {
        std::fs::remove_file(folder.path(&format!("clip.gif.frames/{number:04}.png"))).unwrap();
    }
    std::fs::remove_file(folder.path("clip.gif")).unwrap();
    let (again, said) = clip(&["--keep-frames"]);
    assert!(again == whole && said.contains("2 frames of an earlier run"), "{said}");
    assert_eq!(said.matches("left out").count(), 2, "{said}");
    // A frame of another size, as another run may leave it, is named.
    folder.succeed(&["render", "room.vox", "--size", "24x32", "--spp", "1", "-o", "clip.gif.frames/0003.png"]);
    let told = folder.fail(&[&["animate", "turn.toml", "-o", "clip.gif"], &SMALL[..]].concat(), 4);
    assert!(told.contains("0003.png: 24 x 32 pixels, and the first frame has 32 x 24"), "{told}");
    // Other samples are another picture, and so is what another device rounds.
    for options in [&["--first-sample", "3", "--keep-frames"][..], &["--fast", "--keep-frames"]] {
        let (_, said) = clip(options);
        assert!(said.contains("6 frames of other settings"), "{options:?}: {said}");
    }
    let (other, said) = clip(&["--exposure", "1"]);
    assert!(other != whole && said.contains("6 frames of other settings"), "{said}");
    assert!(!folder.exists("clip.gif.frames"), "what nobody asked for is gone");
}

#[test]
fn frames_of_files_that_have_changed_since_or_of_another_turn_are_made_anew() {
    let folder = Folder::new();
    let cameras = |x: u32| {
        let text = format!(
            "[bookmarks.1]\neye = [12, -30, 18]\ntarget = [12, 12, 2]\n[bookmarks.2]\neye = [{x}, 12, 14]\ntarget = [12, 12, 2]\n"
        );
        std::fs::write(folder.path("way.cameras.toml"), text).unwrap();
    };
    let clip = |options: &[&str]| {
        let arguments = [&["animate", "room.vox", "-o", "clip.gif", "--keep-frames"], options, &SMALL[..]].concat();
        let output = folder.run(&arguments);
        assert!(output.status.success(), "{}", super::common::stderr(&output));
        (folder.bytes("clip.gif"), super::common::stderr(&output))
    };
    let flight = ["--flight", "way.cameras.toml", "--frames", "1..3"];
    cameras(50);
    let (near, _) = clip(&flight);
    let (again, said) = clip(&flight);
    assert!(again == near && said.contains("3 frames of an earlier run"), "{said}");
    // The options are the same, and the flight is another.
    cameras(150);
    let (far, said) = clip(&flight);
    assert!(far != near && said.contains("3 frames of other settings"), "{said}");
    // How far each frame is on its way depends on how many there are, unless that is said.
    let (_, said) = clip(&["--flight", "way.cameras.toml", "--frames", "1..4"]);
    assert!(said.contains("3 frames of other settings"), "{said}");
    clip(&["--turntable=8", "--frames", "1..2"]);
    let (_, said) = clip(&["--turntable=8", "--frames", "1..3"]);
    assert!(said.contains("2 frames of an earlier run"), "{said}");
}

#[test]
fn a_clip_is_transparent_where_its_first_frame_happens_to_be_opaque() {
    let folder = Folder::new();
    // Down onto the floor, then up to the sky.
    let script = "scene = \"room.vox\"\nfps = 100\nframes = 2\n[camera]\npath = [\
        { at = 0, eye = [18, 12, 6], target = [18.5, 12, 0.5] }, { at = 0.01, eye = [18, 12, 6], target = [60, 12, 40] }]\n";
    std::fs::write(folder.path("turn.toml"), script).unwrap();
    let arguments = ["animate", "turn.toml", "-o", "f_####.png", "-o", "clip.png", "-o", "clip.gif", "--transparent"];
    let said = super::common::stderr(&folder.run(&[&arguments[..], &SMALL].concat()));
    let alphas = |name: &str| folder.png(name).samples.chunks(4).map(|pixel| pixel[3]).collect::<Vec<_>>();
    assert!(
        alphas("f_0001.png").iter().all(|&alpha| alpha == 255) && alphas("f_0002.png").iter().all(|&alpha| alpha == 0)
    );
    assert_eq!(folder.png("clip.png").channels, 4);
    assert!(said.contains("clip.gif: a GIF has at most 50 frames a second"), "{said}");
}

#[test]
fn other_programs_read_the_clips_frame_by_frame() {
    let folder = folder();
    let clips = ["-o", "f_####.png", "-o", "clip.gif", "-o", "clip.png", "-o", "clip.mp4"];
    let options =
        ["--encoder", "builtin", "--clip-quality", "90", "--size", "64x48", "--spp", "16", "--traversal", "cpu"];
    folder.succeed(&[&["animate", "turn.toml"], &clips[..], &options].concat());
    let Some(told) = read_back(&folder, "f_%04d.png", &["clip.gif", "clip.png", "clip.mp4"]) else { return };
    for (line, least) in told.lines().zip([28.0, 90.0, 30.0]) {
        let words: Vec<&str> = line.split(' ').collect();
        assert_eq!(words[1..4], ["6", "64", "48"], "{line}");
        let (seconds, psnr): (f64, f64) = (words[4].parse().unwrap(), words[5].parse().unwrap());
        assert!((seconds - 0.48).abs() < 0.011 && psnr > least, "{line}");
    }
    assert_eq!(told.lines().count(), 3);
    // The comparison sees another clip.
    folder.succeed(&[
        "animate",
        "turn.toml",
        "-o",
        "o_####.png",
        "--seed",
        "9",
        "--shutter",
        "0",
        "--size",
        "64x48",
        "--spp",
        "1",
    ]);
    let other = read_back(&folder, "o_%04d.png", &["clip.png"]).unwrap();
    assert!(other.trim().rsplit(' ').next().unwrap().parse::<f64>().unwrap() < 30.0, "{other}");
}

#[test]
fn ffmpeg_makes_a_clip_of_even_sizes_where_it_is_on_the_path() {
    let folder = folder();
    if Command::new("ffmpeg").arg("-version").output().is_err() {
        return skip("there is no ffmpeg on the path");
    }
    let options = [
        "-o",
        "f_####.png",
        "-o",
        "clip.mp4",
        "--encoder",
        "ffmpeg",
        "--size",
        "63x47",
        "--spp",
        "16",
        "--traversal",
        "cpu",
    ];
    folder.succeed(&[&["animate", "turn.toml"], &options[..]].concat());
    let Some(told) = read_back(&folder, "f_%04d.png", &["clip.mp4"]) else { return };
    let words: Vec<&str> = told.trim().split(' ').collect();
    assert_eq!(words[..4], ["clip.mp4", "6", "64", "48"], "{told}");
    assert!(words[5].parse::<f64>().unwrap() > 32.0, "{told}");
}

/// What Pillow and PyAV say of clips, a line each; `None` where they are not there.
fn read_back(folder: &Folder, pattern: &str, clips: &[&str]) -> Option<String> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../voxtrace-tests/python/clips.py");
    let python = std::env::var("VOXTRACE_PYTHON").unwrap_or_else(|_| "python3".into());
    let mut command = Command::new(&python);
    command.arg(script).arg(folder.path(pattern)).arg("6").args(clips.iter().map(|clip| folder.path(clip)));
    match command.output() {
        Ok(output) if output.status.success() => Some(super::common::stdout(&output)),
        other => {
            skip_without(Need::Python, &format!("{python} reads no clips with pillow, numpy and av: {other:?}"));
            None
        }
    }
}

#[test]
fn keyframes_of_a_file_play_and_info_counts_them() {
    let Some(data) = data() else { return };
    let folder = Folder::new();
    let deer = data.join("vox/bevy_vox_scene/deer.vox").display().to_string();
    assert!(folder.succeed(&["info", &deer]).contains("frames            4 of keyframes"));
    let json: serde_json::Value = serde_json::from_str(&folder.succeed(&["info", &deer, "--json"])).unwrap();
    assert_eq!(json["frames"], 4);
    let frames = folder.succeed(&[&["animate", &deer, "-o", "deer_####.png"], &SMALL[..]].concat());
    assert_eq!(frames.lines().count(), 4, "{frames}");
    let played = super::common::stderr(&folder.run(&[&["animate", &deer, "-o", "x_####.png"], &SMALL[..]].concat()));
    assert!(!played.contains("keyframe"), "what is played is not counted as left out: {played}");
    let frame = |number: u32| folder.png(&format!("deer_{number:04}.png")).samples;
    assert!((2..=4).all(|number| frame(number) != frame(1)));
    // It comes again.
    folder.succeed(
        &[&["animate", &deer, "-o", "deer_####.png", "--frames", "5", "--seed", "4294967292"], &SMALL[..]].concat(),
    );
    assert_eq!(frame(5), frame(1));
    let still = data.join("vox/vengi/robo.vox").display().to_string();
    assert!(folder.succeed(&["info", &still]).find("keyframes").is_none());
    let short = "scene = \"room.vox\"\nframes = 3\n[camera]\norbit = 1";
    std::fs::write(folder.path("short.toml"), short).unwrap();
    let told = folder.fail(&["animate", "short.toml", "-o", "a_####.png", "--frames", "2..4"], 2);
    assert!(told.contains("frame 4 is behind the end of 3 frames"), "{told}");
    let told = folder.fail(&["animate", &still, "-o", "a.gif"], 2);
    assert!(told.contains("nothing moves") && told.contains("--turntable"), "{told}");
}

#[test]
fn faults_of_an_animation_are_one_line_with_file_line_and_key() {
    let folder = Folder::new();
    let head = "scene = \"room.vox\"\nframes = 2\n";
    let cases = [
        ("[[object]]\nname = \"door\"\nspin = { turns_per_second = 1 }", "turn.toml:4: object[0].name: "),
        ("[[object]]\nname = \"0\"\nspin = { turns = 1 }", "turn.toml:5: object[0].spin.turns: nothing reads it"),
        ("[[object]]\nname = \"0\"", "turn.toml:3: object[0]: it does nothing"),
        (
            "[[object]]\nname = \"0\"\nkeys = [{ at = 1 }, { at = 0 }]",
            "turn.toml:5: object[0].keys[1].at: it is not after",
        ),
        (
            "[[object]]\nname = \"0\"\npath = { points = [[0, 0, 0]], seconds = 1 }",
            "object[0].path.points: a path leads",
        ),
        ("[camera]\nname = \"attic\"", "turn.toml:4: camera.name: the scene has no camera \"attic\""),
        ("[camera]\npath = [{ eye = [1, 2, 3] }]", "turn.toml:4: camera.path[0]: "),
        ("[camera]\npath = [{ bookmark = 3 }]", "room.cameras.toml"),
        (
            "[camera]\npath = [{ camera = \"front\", handle_in = [1, 0, 0], handle_out = [1, 0, 0] }]",
            "turn.toml:4: camera.path[0].handle_out: both handles are not on one line",
        ),
        ("[camera]\norbit = 1\nlook_at = \"door\"", "turn.toml:5: camera.look_at: "),
        (
            "[[object]]\nnames = [\"0..3\"]\nspin = { turns_per_second = 1 }",
            "object[0].names: there are objects 0 to 0",
        ),
        (
            "[[object]]\nname = \"0\"\npivot = \"head\"\nspin = { turns_per_second = 1 }",
            "turn.toml:5: object[0].pivot: one of \"middle\", \"foot\" is needed",
        ),
        ("[sun]\nkeys = [{ at = 0, height = 100 }]", "turn.toml:4: sun.keys[0].height: from -90 to 90"),
        ("[sky]\nkeys = []", "turn.toml:3: sky: `keys` is missing"),
        ("", "nothing moves in room"),
    ];
    for (text, expected) in cases {
        std::fs::write(folder.path("turn.toml"), format!("{head}{text}\n")).unwrap();
        let arguments = ["animate", "turn.toml", "-o", "a_####.png"];
        let output = folder.command(&[&arguments[..], &SMALL].concat()).arg("--quiet").output().unwrap();
        let told = super::common::stderr(&output);
        assert!(!output.status.success() && told.lines().count() == 1 && told.contains(expected), "{text}: {told}");
        assert!(!folder.exists("a_0001.png"));
    }
    std::fs::write(folder.path("turn.toml"), "frames = 2").unwrap();
    assert!(folder.fail(&["animate", "turn.toml", "-o", "a.gif"], 3).contains("`scene` is missing"));
    assert!(folder.fail(&["animate", "room.vox"], 2).contains("clip.mp4"));
    for name in ["clip.webm", "shot_####.jpg", "clip"] {
        let told = folder.fail(&["animate", "room.vox", "-o", name], 2);
        assert!(told.contains(name) && told.contains("clip.mp4") && told.contains("shot_####.png"), "{told}");
    }
    assert!(folder.fail(&["render", "room.vox", "-o", "clip.mp4"], 2).contains("`voxtrace animate`"));
    // Before the scene is read and frames are made.
    for size in [&["--size", "14x40"][..], &["--size", "64x64", "--crop", "0,40,8,20"]] {
        let small =
            [&["animate", "none.vox", "--turntable=2", "-o", "small.mp4", "--encoder", "builtin"], size].concat();
        let told = folder.fail(&small, 2);
        assert!(told.contains("small.mp4: the encoder within makes no pictures of less than 16x16"), "{told}");
    }
}

#[test]
fn handles_bend_the_path_of_a_camera_and_leave_its_ends() {
    let folder = Folder::new();
    let frames = |handle: &str| {
        let path = format!("[{{ camera = \"front\"{handle} }}, {{ camera = \"side\" }}]");
        let script = format!("scene = \"room.vox\"\nframes = 3\n[camera]\npath = {path}\nlook_at = [12, 12, 2]\n");
        std::fs::write(folder.path("turn.toml"), script).unwrap();
        animate(&folder, &["-o", "h_####.png"]);
        [1, 2, 3].map(|number| folder.png(&format!("h_{number:04}.png")).samples)
    };
    let (straight, bent) = (frames(""), frames(", handle_out = [-60, 0, 30]"));
    assert!(straight[0] == bent[0] && straight[1] != bent[1] && straight[2] == bent[2]);
}

#[test]
fn what_is_hidden_stays_hidden_and_what_is_around_stays_around() {
    let folder = folder();
    animate(&folder, &["-o", "a_####.png", "--frames", "2", "--ground", "--transparent"]);
    animate(&folder, &["-o", "b_####.png", "--frames", "2", "--transparent"]);
    assert_ne!(folder.png("a_0002.png").samples, folder.png("b_0002.png").samples, "the ground is seen");
    animate(
        &folder,
        &[
            "-o",
            "c_####.png",
            "--frames",
            "2",
            "--transparent",
            "--hide",
            "0",
            "--eye",
            "12,-30,18",
            "--target",
            "12,12,2",
        ],
    );
    let alpha: u32 = folder.png("c_0002.png").samples.chunks(4).map(|pixel| u32::from(pixel[3])).sum();
    assert_eq!(alpha, 0, "nothing is left to be seen");
}

#[test]
fn the_noise_of_a_blurred_frame_can_be_removed() {
    let folder = folder();
    animate(&folder, &["-o", "noisy_####.png", "--frames", "3"]);
    animate(&folder, &["-o", "clean_####.png", "--frames", "3", "--denoise"]);
    let (noisy, clean) = (folder.png("noisy_0003.png"), folder.png("clean_0003.png"));
    assert_ne!(noisy.samples, clean.samples);
    assert!((noisy.mean() - clean.mean()).abs() < 2.0, "{} {}", noisy.mean(), clean.mean());
}

#[test]
fn the_help_of_animate_says_of_its_outputs_and_frames_what_they_are_there() {
    let folder = Folder::new();
    let option = |verb: &str, name: &str| {
        let help = folder.succeed(&[verb, "-h"]);
        let lines: Vec<&str> = help.lines().collect();
        let at = lines.iter().position(|line| line.trim_start().starts_with(name)).unwrap();
        let is_more = |line: &&&str| !line.trim_start().starts_with('-') && !line.trim().is_empty();
        let rest = lines[at + 1..].iter().take_while(is_more).map(|line| line.trim());
        std::iter::once(lines[at].trim()).chain(rest).collect::<Vec<_>>().join(" ")
    };
    let (output, frames) = (option("animate", "-o, --output"), option("animate", "--frames"));
    assert!(output.contains("Clip to write: .mp4") && output.contains("####"), "{output}");
    assert!(frames.contains("all of the animation") && !frames.contains("one turn"), "{frames}");
    // Those of `render` are as they were.
    assert!(option("render", "-o, --output").contains("or .vxf for the film itself"));
    assert!(option("render", "--frames").contains("one turn, or the whole flight"));
}
