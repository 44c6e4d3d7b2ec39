//! `render`: lines on the faces of voxels.

use crate::common::{Folder, SMALL, stderr};
use voxtrace::import::Limits;
use voxtrace::import::vox::{Body, Chunk, Dict, VoxFile};

#[test]
fn lines_are_drawn_and_a_film_goes_on_with_them() {
    let folder = Folder::new();
    let plain = folder.render("a.png", &[]);
    let edges = folder.render("b.png", &["--edges"]);
    assert_eq!(edges.text("voxtrace.lines"), "edges 0.2,0,0,0");
    assert_ne!(plain.samples, edges.samples);
    let named = folder.render("c.png", &["--edges=0.2,#000000"]);
    assert_eq!(named.samples, edges.samples);
    let grid = folder.render("d.png", &["--grid=0.5,#00ff00,2", "--edges=0.2"]);
    assert_eq!(grid.text("voxtrace.lines"), "edges 0.2,0,0,0 grid 0.5,0,1,0,2");
    let green = |picture: &crate::common::Picture| {
        let pixels = picture.samples.chunks(3);
        pixels.filter(|pixel| pixel[1] > pixel[0].max(pixel[2]) + 40).count()
    };
    assert!(green(&grid) > green(&edges) + 20, "{} {}", green(&grid), green(&edges));
    // A film says its lines: it goes on with them, and not with others.
    let asked = ["--edges=0.3,#ffffff", "--grid"];
    folder.succeed(&[&["render", "room.vox", "--checkpoint", "a.vxf", "-o", "part.png"][..], &asked, &SMALL].concat());
    let more = ["render", "room.vox", "--resume", "a.vxf", "--spp", "6", "-o", "more.png"];
    folder.succeed(&more);
    folder.succeed(&[&["render", "room.vox", "--size", "40x30", "--spp", "6", "-o", "whole.png"][..], &asked].concat());
    assert_eq!(folder.png("more.png").samples, folder.png("whole.png").samples);
    let other = folder.run(&[&more[..], &["--edges=0.1"]].concat());
    assert_eq!(other.status.code(), Some(5), "{}", stderr(&other));
    let rest = ["render", "room.vox", "--first-sample", "4", "--checkpoint", "b.vxf"];
    folder.succeed(&[&rest[..], &SMALL].concat());
    assert!(folder.fail(&["merge", "a.vxf", "b.vxf", "-o", "m.vxf"], 5).contains("lines"));
}

#[test]
fn lines_of_a_file_are_drawn_on_request() {
    let folder = Folder::new();
    let path = folder.path("room.vox");
    let bytes = std::fs::read(&path).unwrap();
    let mut file = VoxFile::parse(&bytes, &path, &Limits::default()).unwrap();
    for (kind, keys) in
        [("_edge", &[("_color", "255 0 0"), ("_width", "0.3")][..]), ("_setting", &[("_edge", "1"), ("_grid", "0")])]
    {
        let mut dict = Dict::default();
        dict.push("_type", kind);
        keys.iter().for_each(|(key, value)| dict.push(key, *value));
        file.chunks.push(Chunk::new(Body::RenderObject(dict)));
    }
    std::fs::write(folder.path("lined.vox"), file.to_bytes().unwrap()).unwrap();
    let render = |scene: &str, options: &[&str], name: &str| {
        folder.succeed(&[&["render", scene, "-o", name][..], &SMALL, options].concat());
        folder.png(name)
    };
    let lined = render("lined.vox", &["--edges=file"], "a.png");
    assert_eq!(lined.text("voxtrace.lines"), "edges 0.3,1,0,0");
    let plain = render("lined.vox", &[], "b.png");
    assert_ne!(lined.samples, plain.samples, "on request alone");
    assert_eq!(plain.samples, render("room.vox", &[], "c.png").samples);
    assert_eq!(lined.samples, render("room.vox", &["--edges=0.3,1,0,0"], "d.png").samples);
    let (said, none) = (folder.succeed(&["info", "lined.vox"]), folder.succeed(&["info", "room.vox"]));
    assert!(said.contains("edges (--edges=file)") && !said.contains("grid (") && !none.contains("--edges"), "{said}");
    assert!(folder.fail(&["render", "lined.vox", "--grid=file"], 2).contains("the file shows no grid"));
}

#[test]
fn lines_that_cannot_be_are_refused() {
    let folder = Folder::new();
    for (options, expected) in [
        (&["--edges=0"][..], "a line's width"),
        (&["--edges=2"], "a line's width"),
        (&["--edges=wide"], "not a number"),
        (&["--edges=0.2,reddish"], "not a colour"),
        (&["--edges=0.2,2,0,0"], "reflectance"),
        (&["--edges=0.2,#000000,3"], "edges have"),
        (&["--grid=0.2,#000000,0"], "apart"),
        (&["--grid=0.2,#000000,x"], "no number of voxels"),
        (&["--edges=file"], "the file shows no edges"),
        (&["--edges", "--integrator", "essay"], "need the integrator path"),
    ] {
        let said = folder.fail(&[&["render", "room.vox", "-o", "a.png"][..], options].concat(), 2);
        assert!(said.contains(expected), "{options:?}: {said}");
    }
}
