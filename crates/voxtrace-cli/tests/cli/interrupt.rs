//! SIGINT and SIGTERM: the picture so far is kept, and can be continued.

#![cfg(unix)]

use crate::common::{Folder, Messages};
#[cfg(feature = "view")]
use crate::view::{Running, has_device};
#[cfg(feature = "view")]
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;
#[cfg(feature = "view")]
use std::time::Instant;
use voxtrace::output::FilmFile;
#[cfg(feature = "view")]
use voxtrace_test_support::{Need, skip_without};

const ARGUMENTS: [&str; 12] =
    ["render", "room.vox", "-o", "a.png", "--size", "160x120", "--spp", "1000000", "--progress", "json", "--seed", "1"];

/// Starts a render and waits until samples have been computed.
fn start(folder: &Folder, options: &[&str]) -> (Child, Messages) {
    let (child, mut lines) = folder.watch(&[&ARGUMENTS[..], options].concat());
    let is_under_way = |line: &String| {
        let event: serde_json::Value = serde_json::from_str(line).unwrap();
        event["event"] == "progress" && event["samples_done"].as_u64() > Some(0)
    };
    lines.by_ref().find(is_under_way).expect("the render ended before it began");
    (child, lines)
}

pub fn signal(child: &Child, name: &str) {
    let status = Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

/// Continued to one sample more than it has anywhere, `a.vxf` is the film that was never interrupted.
fn assert_continues(folder: &Folder, samples: u32) {
    let spp = samples.to_string();
    folder.succeed(&["render", "room.vox", "--resume", "a.vxf", "--checkpoint", "b.vxf", "--spp", &spp]);
    let whole = ["render", "room.vox", "--checkpoint", "c.vxf", "--spp", &spp, "--size", "160x120", "--seed", "1"];
    folder.succeed(&whole);
    assert_eq!(folder.bytes("b.vxf"), folder.bytes("c.vxf"));
    assert_ne!(folder.bytes("a.vxf"), folder.bytes("c.vxf"));
}

#[test]
fn an_interrupted_render_keeps_its_picture_and_its_film_and_exits_with_130() {
    for name in ["-INT", "-TERM"] {
        let folder = Folder::new();
        let (mut child, lines) = start(&folder, &["--checkpoint", "a.vxf"]);
        signal(&child, name);
        let last = lines.last().unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(130), "{last}");
        assert!(last.starts_with("error: interrupted at ") && last.contains("--resume a.vxf"), "{last}");
        assert!(last.contains("a.part.png") && !folder.exists("a.png"), "{last}");
        let picture = folder.png("a.part.png");
        assert_eq!((picture.width, picture.height), (160, 120));
        assert!(picture.mean() > 10.0);
        let film = FilmFile::open(&folder.path("a.vxf")).unwrap().film;
        let (least, most) = film.sample_range();
        assert!(least >= 1 && most < 1_000_000, "{least} {most}");

        assert_continues(&folder, most + 1);
    }
}

#[test]
fn a_render_killed_at_any_moment_leaves_a_whole_checkpoint_that_continues_to_the_same_film() {
    for wait in [0, 3, 20, 50] {
        let folder = Folder::new();
        let (mut child, _lines) = start(&folder, &["--checkpoint", "a.vxf", "--checkpoint-every", "1ms"]);
        while !folder.exists("a.vxf") {
            std::thread::yield_now();
        }
        std::thread::sleep(Duration::from_millis(wait));
        signal(&child, "-KILL");
        assert_eq!(child.wait().unwrap().code(), None);
        let film = FilmFile::open(&folder.path("a.vxf")).unwrap().film;
        assert_continues(&folder, film.sample_range().1 + 1);
    }
}

#[test]
fn after_an_interrupt_no_further_view_is_begun() {
    let folder = Folder::new();
    let (mut child, lines) = start(&folder, &["--camera", "all"]);
    signal(&child, "-INT");
    assert!(lines.last().unwrap().starts_with("error: interrupted"));
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(folder.exists("a_front.part.png") && !folder.exists("a_front.png"));
    assert!(!folder.exists("a_side.part.png") && !folder.exists("a_side.png"));
}

/// Runs the program until a file of its has so many bytes, and sends it a signal then. On a busy machine it may end before: then it begins anew,
/// without the file `out` that it has made.
pub fn interrupted(folder: &Folder, arguments: &[&str], (file, least): (&str, u64), out: &str, name: &str) -> Output {
    for _ in 0..20 {
        let mut command = folder.command(arguments);
        let mut child = command.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        let size = || std::fs::metadata(folder.path(file)).map_or(0, |metadata| metadata.len());
        let mut is_over = false;
        while !is_over && size() < least {
            is_over = child.try_wait().unwrap().is_some();
            std::thread::yield_now();
        }
        if !is_over {
            signal(&child, name);
        }
        let output = child.wait_with_output().unwrap();
        // A signal may also come between the file's being there and the end.
        if !output.status.success() && !folder.exists(out) {
            return output;
        }
        std::fs::remove_file(folder.path(out)).unwrap();
    }
    panic!("it always ended before it was interrupted");
}

/// A turn of four frames, each of which takes a while.
const TURN: [&str; 11] =
    ["render", "room.vox", "--turntable", "--frames", "1..4", "--size", "96x72", "--spp", "128", "-o", "shot_####.png"];

fn shots(folder: &Folder) -> Vec<Vec<u8>> {
    (1..=4).map(|frame| folder.bytes(&format!("shot_000{frame}.png"))).collect()
}

#[test]
fn an_animation_that_was_broken_off_goes_on_and_ends_with_the_same_bytes() {
    let (folder, whole) = (Folder::new(), Folder::new());
    whole.succeed(&TURN);
    let is_third = |line: &String| {
        let event: serde_json::Value = serde_json::from_str(line).unwrap();
        event["view"].as_str().is_some_and(|view| view.ends_with("0003"))
    };
    let mut attempts = 0;
    let last = loop {
        let (mut child, mut lines) = folder.watch(&[&TURN[..], &["--progress", "json"]].concat());
        lines.by_ref().find(is_third).expect("the render ended before its third frame");
        signal(&child, "-INT");
        let (last, code) = (lines.last().unwrap_or_default(), child.wait().unwrap().code());
        attempts += 1;
        // On a busy machine the frame may be done by then.
        if !folder.exists("shot_0003.png") || attempts == 20 {
            assert_eq!(code, Some(130), "{last}");
            break last;
        }
        for entry in std::fs::read_dir(folder.path(".")).unwrap().map(|entry| entry.unwrap()) {
            if entry.file_name().to_string_lossy().starts_with("shot_") {
                std::fs::remove_file(entry.path()).unwrap();
            }
        }
    };
    // What has its final name is whole; the rest has another one.
    assert!(folder.exists("shot_0003.part.png") && last.contains("shot_0003.part.png"), "{last}");
    assert!(!folder.exists("shot_0003.png") && !folder.exists("shot_0004.png"));
    assert_ne!(folder.png("shot_0003.part.png").samples, whole.png("shot_0003.png").samples);
    assert!(folder.bytes("shot_0002.png") == whole.bytes("shot_0002.png"));

    std::fs::write(folder.path("shot_0001.png"), "kept").unwrap();
    let written = folder.succeed(&[&TURN[..], &["--skip-existing"]].concat());
    assert_eq!(written, "shot_0003.png\nshot_0004.png\n");
    assert!(!folder.exists("shot_0003.part.png"), "the whole picture takes its place");
    assert!(shots(&folder)[1..] == shots(&whole)[1..]);
    assert_eq!(folder.bytes("shot_0001.png"), b"kept", "what is there is not made again");
    assert_eq!(folder.succeed(&[&TURN[..], &["--skip-existing"]].concat()), "");
    folder.succeed(&TURN);
    assert!(shots(&folder) == shots(&whole));
}

#[test]
fn processes_that_share_an_animation_end_with_the_bytes_of_one() {
    let (folder, whole) = (Folder::new(), Folder::new());
    whole.succeed(&TURN);
    let turn = [&TURN[..], &["--turntable=4", "--skip-existing", "--quiet"]].concat();
    let turn: Vec<&str> = turn.into_iter().filter(|&argument| argument != "--turntable").collect();
    let children: Vec<Child> = (0..3).map(|_| folder.command(&turn).spawn().unwrap()).collect();
    for mut child in children {
        assert!(child.wait().unwrap().success());
    }
    assert!(shots(&folder) == shots(&whole));
    let left: Vec<_> = std::fs::read_dir(folder.path(".")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(left.iter().all(|name| !name.to_string_lossy().ends_with(".tmp")), "{left:?}");
}

#[cfg(feature = "view")]
#[test]
fn a_benchmark_of_frames_ends_at_the_first_signal() {
    let folder = Folder::new();
    if !has_device(&folder) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let mut command = folder.command(&["view", "room.vxt", "--device", "0", "--bench-frames", "1000000"]);
    let mut bench = Running(command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap());
    let mut lines = BufReader::new(bench.0.stdout.take().unwrap()).lines().map(Result::unwrap);
    lines.by_ref().find(|line| line.starts_with("arithmetic")).expect("it ended before it began");
    signal(&bench.0, "-TERM");
    let since = Instant::now();
    let status = loop {
        if let Some(status) = bench.0.try_wait().unwrap() {
            break status;
        }
        assert!(since.elapsed() < Duration::from_secs(300), "it goes on");
        std::thread::sleep(Duration::from_millis(10));
    };
    assert_eq!(status.code(), Some(130));
}

#[test]
fn a_picture_that_is_left_out_needs_a_name() {
    let folder = Folder::new();
    let error = folder.fail(&["render", "room.vox", "--checkpoint", "a.vxf", "--skip-existing"], 2);
    assert!(error.contains("--skip-existing looks for pictures"), "{error}");
}

#[test]
fn a_picture_that_is_ended_early_has_no_pixel_without_a_sample() {
    let folder = Folder::new();
    let devices: serde_json::Value = serde_json::from_str(&folder.succeed(&["devices", "--json"])).unwrap();
    let has_device = devices["devices"].as_array().unwrap().len() > 1;
    assert!(has_device || std::env::var_os("VOXTRACE_REQUIRE_VULKAN").is_none(), "no Vulkan device");
    for traversal in ["cpu", "walk"].into_iter().filter(|name| has_device || *name == "cpu") {
        // Far more pixels than the first look at the clock leaves time for.
        let size = ["--size", "1280x960", "--threads", "1", "--traversal", traversal];
        folder.succeed(&[&["render", "room.vox", "-o", "a.vxf", "--time-limit", "1ms"], &size[..]].concat());
        let (least, most) = FilmFile::open(&folder.path("a.vxf")).unwrap().film.sample_range();
        assert!(least >= 1 && most - least <= 4, "{traversal}: {least} to {most}");

        let endless = ["render", "room.vox", "-o", "b.vxf", "--spp", "1000000", "--progress", "json"];
        let (mut child, mut lines) = folder.watch(&[&endless[..], &size].concat());
        let is_begun = |line: &String| serde_json::from_str::<serde_json::Value>(line).unwrap()["event"] == "progress";
        lines.by_ref().find(is_begun).expect("the render ended before it began");
        signal(&child, "-INT");
        let last = lines.last().unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(130), "{last}");
        let (least, most) = FilmFile::open(&folder.path("b.part.vxf")).unwrap().film.sample_range();
        assert!(least >= 1 && most - least <= 4, "{traversal}: {least} to {most}");
    }
}

/// A bumpy sheet as a binary STL file.
fn write_sheet(folder: &Folder, side: u32) {
    let height = |x: u32, y: u32| ((x as f32 / 9.0).sin() + (y as f32 / 7.0).cos()) * 20.0;
    let corner = |x: u32, y: u32| [x as f32, y as f32, height(x, y)];
    let mut bytes = vec![b' '; 80];
    bytes.extend((2 * side * side).to_le_bytes());
    for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
        let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
        for triangle in [[a, b, c], [a, c, d]] {
            bytes.extend([0; 12]);
            bytes.extend(triangle.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
            bytes.extend([0; 2]);
        }
    }
    std::fs::write(folder.path("sheet.stl"), bytes).unwrap();
}

#[test]
fn voxelizing_that_is_interrupted_or_killed_goes_on_and_ends_with_the_same_file() {
    let folder = Folder::new();
    write_sheet(&folder, 300);
    // In memory part by part, and sorted on the disk.
    for budget in ["1GB", "1MB"] {
        let arguments = |out: &'static str, resolution: &'static str| {
            ["voxelize", "sheet.stl", "-o", out, "--resolution", resolution, "--memory-budget", budget]
        };
        folder.succeed(&arguments("whole.vxt", "3000"));
        for name in ["-KILL", "-INT", "-TERM"] {
            let part = ("a.vxt.part", 200_000);
            let output = interrupted(&folder, &arguments("a.vxt", "3000"), part, "a.vxt", name);
            let said = String::from_utf8(output.stderr).unwrap();
            if name == "-KILL" {
                assert_eq!(output.status.code(), None);
            } else {
                assert_eq!(output.status.code(), Some(130), "{said}");
                assert!(said.contains("a.vxt.part: the same command goes on from there"), "{said}");
            }
            assert!(!folder.exists("a.vxt") && folder.exists("a.vxt.part"));
            let names: Vec<_> = std::fs::read_dir(folder.path(".")).unwrap().map(|e| e.unwrap().file_name()).collect();
            assert!(names.iter().all(|name| !name.to_string_lossy().ends_with(".tmp")), "{name}: {names:?}");

            let output = folder.run(&arguments("a.vxt", "3000"));
            let said = String::from_utf8(output.stderr).unwrap();
            assert!(output.status.success() && said.contains("going on from"), "{said}");
            assert!(folder.bytes("a.vxt") == folder.bytes("whole.vxt"), "{name} {budget}");
            assert!(!folder.exists("a.vxt.part"));
            std::fs::remove_file(folder.path("a.vxt")).unwrap();
        }
    }
}
