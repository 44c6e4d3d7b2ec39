//! Normals of voxels: kept in `.vxt` files, made and taken away by `--normals`, told by `info`.

use crate::common::{Folder, SMALL, stderr};
use serde_json::Value;

fn info(folder: &Folder, words: &[&str]) -> Value {
    serde_json::from_str(&folder.succeed(&[&["info", "--json"][..], words].concat())).unwrap()
}

/// Bytes of normals for each voxel.
fn normals(folder: &Folder, words: &[&str]) -> f64 {
    let info = info(folder, words);
    info["bytes"]["normals"].as_f64().unwrap() / info["voxels"].as_f64().unwrap()
}

fn picture(folder: &Folder, words: &[&str]) -> Vec<u16> {
    folder.succeed(&[&["render", "-o", "picture.png"][..], words, &SMALL].concat());
    folder.png("picture.png").samples
}

#[test]
fn a_scene_has_the_normals_that_are_asked_for_and_files_keep_them() {
    let folder = Folder::new();
    let faces = picture(&folder, &["room.vox"]);
    let smooth = picture(&folder, &["room.vox", "--normals", "smooth"]);
    assert_ne!(smooth, faces);
    assert_eq!(picture(&folder, &["room.vox", "--normals", "faces"]), faces);
    folder.succeed(&["convert", "room.vox", "smooth.vxt", "--normals", "smooth"]);
    assert_eq!(picture(&folder, &["smooth.vxt"]), smooth);
    assert_eq!(picture(&folder, &["smooth.vxt", "--normals", "faces"]), faces);
    // From file to file, and not without being asked.
    folder.succeed(&["convert", "smooth.vxt", "again.vxt"]);
    assert!(folder.bytes("again.vxt") == folder.bytes("smooth.vxt"));
    folder.succeed(&["convert", "smooth.vxt", "faces.vxt", "--normals", "faces"]);
    folder.succeed(&["convert", "room.vox", "plain.vxt"]);
    assert!(folder.bytes("faces.vxt") == folder.bytes("plain.vxt"));
    assert!(folder.bytes("smooth.vxt") != folder.bytes("plain.vxt"), "the comparison sees normals");
    let of_file = normals(&folder, &["smooth.vxt"]);
    assert!((1.875..2.1).contains(&of_file), "{of_file}");
    assert_eq!(normals(&folder, &["room.vxt"]), 0.0);
    assert!(folder.succeed(&["info", "smooth.vxt"]).contains("\n  normals         "));
    assert!(!folder.succeed(&["info", "room.vxt"]).contains("normals"));
}

#[test]
fn what_is_voxelized_keeps_its_normals() {
    let folder = Folder::new();
    // A wedge: its slope is steps of voxels.
    let mesh =
        "v 0 0 0\nv 9 0 0\nv 9 0 3\nv 0 7 0\nv 9 7 0\nv 9 7 3\nf 1 2 3\nf 4 6 5\nf 1 3 6 4\nf 1 4 5 2\nf 2 5 6 3\n";
    std::fs::write(folder.path("wedge.obj"), mesh).unwrap();
    let voxelize = |out: &str, more: &[&str]| {
        folder.succeed(&[&["voxelize", "wedge.obj", "-o", out, "--resolution", "48", "--up", "z"][..], more].concat());
    };
    voxelize("faces.vxt", &[]);
    voxelize("smooth.vxt", &["--normals", "smooth"]);
    assert_eq!(normals(&folder, &["faces.vxt"]), 0.0);
    assert!(normals(&folder, &["smooth.vxt"]) > 1.8);
    folder.succeed(&["convert", "smooth.vxt", "back.vxt", "--normals", "faces"]);
    assert_eq!(info(&folder, &["back.vxt"])["content_hash"], info(&folder, &["faces.vxt"])["content_hash"]);
    let refused = ["voxelize", "wedge.obj", "-o", "large.vxt", "--memory-budget", "1GB", "--normals", "smooth"];
    let refused = folder.run(&refused);
    assert_eq!(refused.status.code(), Some(2), "{}", stderr(&refused));
    assert!(stderr(&refused).contains("--normals smooth wants the whole scene in memory"), "{}", stderr(&refused));
}
