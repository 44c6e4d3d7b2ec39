//! `--in-memory`: what happens to a `.vxt` file while it is rendered does not matter.

#![cfg(unix)]

use crate::common::{Folder, SMALL};
use std::fs::OpenOptions;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;
use voxtrace::output::FilmFile;

/// Renders `room.vxt` and shortens the file after the first samples. Whether the film has what the whole scene shows, samples that
/// were taken after that included; `false` also where the process was killed, which looked up a voxel beyond the end of the file, or panicked, since zeros
/// led it nowhere.
fn a_shortened_file_makes_no_difference(options: &[&str]) -> bool {
    let folder = Folder::new();
    let arguments = ["render", "room.vxt", "--traversal", "cpu", "--checkpoint", "a.vxf", "--progress", "json"];
    let endless = ["-o", "a.png", "--size", "160x120", "--spp", "1000000"];
    let (mut child, mut lines) = folder.watch(&[&arguments, &endless[..], options].concat());
    let samples = |line: &String| {
        let event: serde_json::Value = serde_json::from_str(line).unwrap_or_default();
        event["samples_done"].as_u64().unwrap_or(0)
    };
    let first = lines.by_ref().map(|line| samples(&line)).find(|&samples| samples > 0).expect("the render began");
    OpenOptions::new().write(true).open(folder.path("room.vxt")).unwrap().set_len(64).unwrap();
    // Messages that were waiting to be read are older than the shortening: a thousand samples are not.
    lines.by_ref().map(|line| samples(&line)).find(|&samples| samples > first + 1000);
    if child.try_wait().unwrap().is_none() {
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    }
    lines.for_each(drop);
    let status = child.wait().unwrap();
    const PANICKED: i32 = 101;
    if status.signal().is_some() || status.code() == Some(PANICKED) {
        return false;
    }
    assert_eq!(status.code(), Some(130), "{status}");
    let (_, most) = FilmFile::open(&folder.path("a.vxf")).unwrap().film.sample_range();
    let spp = (most + 1).to_string();
    folder.succeed(&["render", "room.vox", "--resume", "a.vxf", "--checkpoint", "b.vxf", "--spp", &spp]);
    folder.succeed(&["render", "room.vox", "--checkpoint", "c.vxf", "--size", "160x120", "--spp", &spp]);
    folder.bytes("b.vxf") == folder.bytes("c.vxf")
}

#[test]
fn a_file_that_is_shortened_while_it_is_rendered_does_not_change_what_is_in_memory() {
    assert!(a_shortened_file_makes_no_difference(&["--in-memory"]));
    // A file that is mapped is not there any more: beyond its end for a lookup, and as zeros up to the end of its last page.
    assert!(!a_shortened_file_makes_no_difference(&[]));
}

#[test]
fn scenes_in_memory_are_those_that_are_mapped() {
    let folder = Folder::new();
    for (name, options) in [("a.png", &["--in-memory"][..]), ("b.png", &[])] {
        folder.succeed(&[&["render", "room.vxt", "-o", name], &SMALL[..], options].concat());
    }
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
    assert_eq!(folder.succeed(&["info", "room.vxt", "--in-memory"]), folder.succeed(&["info", "room.vxt"]));
    folder.succeed(&["convert", "room.vxt", "a.vox", "--in-memory"]);
    folder.succeed(&["convert", "room.vxt", "b.vox"]);
    assert_eq!(folder.bytes("a.vox"), folder.bytes("b.vox"));
    // A file that is damaged is refused either way.
    std::fs::write(folder.path("cut.vxt"), &folder.bytes("room.vxt")[..500]).unwrap();
    for arguments in [&["info", "cut.vxt", "--in-memory"][..], &["info", "cut.vxt"]] {
        assert!(folder.fail(arguments, 3).contains("damaged"));
    }
}
