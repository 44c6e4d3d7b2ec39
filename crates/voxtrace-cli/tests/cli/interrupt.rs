//! SIGINT and SIGTERM: the picture so far is kept, and can be continued.

#![cfg(unix)]

use crate::common::{Folder, Messages};
use std::process::{Child, Command};
use voxtrace::output::FilmFile;

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

fn signal(child: &Child, name: &str) {
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
        let picture = folder.png("a.png");
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
        std::thread::sleep(std::time::Duration::from_millis(wait));
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
    assert!(folder.exists("a_front.png") && !folder.exists("a_side.png"));
}
