//! `render`: a ground, fog and a background around the scene.

use crate::common::{Folder, SMALL, stderr};

#[test]
fn a_ground_lies_below_the_scene_and_the_camera_frames_the_scene_alone() {
    let folder = Folder::new();
    let auto = ["--camera", "auto"];
    let bare = folder.render("a.png", &auto);
    let green = folder.render("b.png", &[&auto[..], &["--ground", "--ground-color", "#00ff00"]].concat());
    assert_eq!(bare.text("voxtrace.camera.eye"), green.text("voxtrace.camera.eye"));
    let corner = |picture: &crate::common::Picture| picture.pixel(1, 28).to_vec();
    assert!(corner(&bare)[2] >= corner(&bare)[0], "sky: {:?}", corner(&bare));
    let seen = corner(&green);
    assert!(seen[1] > seen[0] + 40 && seen[1] > seen[2] + 40, "{seen:?}");
    // High above everything it hides it.
    let hidden = folder.render("c.png", &[&auto[..], &["--ground=100", "--ground-color", "#00ff00"]].concat());
    assert_ne!(hidden.pixel(20, 15), green.pixel(20, 15));
    let below = folder.render("d.png", &[&auto[..], &["--ground=-0.5"]].concat());
    assert_ne!(below.samples, green.samples);
    // A `.vxt` file stands on the same.
    let native = ["render", "room.vxt", "-o", "e.png", "--camera", "auto", "--ground", "--ground-color", "#00ff00"];
    folder.succeed(&[&native[..], &SMALL].concat());
    assert_eq!(folder.png("e.png").samples, green.samples);
}

#[test]
fn fog_hides_what_is_far_and_a_film_continues_only_in_the_same_fog() {
    let folder = Folder::new();
    let contrast = |options: &[&str]| {
        let picture = folder.render("a.png", options);
        let block = picture.pixel(20, 15);
        i32::from(block[0]) - i32::from(block[1])
    };
    let (clear, thick) = (contrast(&[]), contrast(&["--fog", "0.2"]));
    assert!(thick < clear / 2, "the red of the block: {clear}, {thick}");
    let fog = ["--fog", "0.01,#ffddbb,0.5", "--ground"];
    folder.succeed(&[&["render", "room.vox", "--checkpoint", "a.vxf", "-o", "part.png"][..], &fog, &SMALL].concat());
    let more = ["--resume", "a.vxf", "--spp", "6", "-o", "more.png"];
    folder.succeed(&[&["render", "room.vox"][..], &more, &fog].concat());
    folder.succeed(&[&["render", "room.vox", "--size", "40x30", "--spp", "6", "-o", "whole.png"][..], &fog].concat());
    assert_eq!(folder.png("more.png").samples, folder.png("whole.png").samples);
    let clear = folder.run(&[&["render", "room.vox"][..], &more].concat());
    assert_eq!(clear.status.code(), Some(5), "{}", stderr(&clear));
}

#[test]
fn a_background_is_seen_by_the_camera_and_lights_nothing() {
    let folder = Folder::new();
    let linear = ["--tone-map", "linear"];
    let over = |color: &str| folder.render("a.png", &[&linear[..], &["--background", color]].concat());
    let (red, black) = (over("#ff0000"), over("#000000"));
    assert_eq!((red.pixel(1, 1), red.channels), (&[255, 0, 0][..], 3));
    assert_eq!(red.pixel(20, 15), black.pixel(20, 15), "the block is as it was");
    assert_ne!(red.pixel(1, 1), black.pixel(1, 1));
    // Where it is transparent, it is what a program that lays the picture over a colour would make of it.
    let clear = folder.render("b.png", &[&linear[..], &["--transparent"]].concat());
    assert_eq!((clear.pixel(1, 1)[3], clear.pixel(20, 15)[3]), (0, 255));
    assert_eq!(clear.pixel(20, 15)[..3], *black.pixel(20, 15));
}

#[test]
fn a_ground_that_catches_shadows_is_black_with_the_alpha_of_its_shadows() {
    let folder = Folder::new();
    let caught = ["--ground", "--shadow-catcher", "--sun", "200,12", "--sky-color", "#000000", "--camera", "auto"];
    let picture = folder.render("a.png", &caught);
    assert_eq!(picture.text("voxtrace.shadow_catcher"), "true");
    let alphas: Vec<u16> = picture.samples.chunks(4).map(|pixel| pixel[3]).collect();
    let count = |alpha: u16| alphas.iter().filter(|own| **own == alpha).count();
    // Of a sun alone there is shadow or none, but at its edge.
    assert!(count(0) > 300 && count(255) > 300 && picture.pixel(1, 28)[3] == 0, "{} {}", count(0), count(255));
    let plain = folder.render("b.png", &[&caught[2..], &["--transparent"]].concat());
    let shadow = |index: usize| alphas[index] == 255 && plain.samples[4 * index + 3] == 0;
    let shadows: Vec<usize> = (0..40 * 30).filter(|index| shadow(*index)).collect();
    assert!(!shadows.is_empty() && shadows.iter().all(|index| picture.samples[4 * index..4 * index + 3] == [0; 3]));
    // A background is dark there, and a film goes on as what it is.
    let behind = folder.render("c.png", &[&caught[..], &["--background", "#ffffff", "--tone-map", "linear"]].concat());
    let at = |index: usize| &behind.samples[3 * index..3 * index + 3];
    assert_eq!((at(shadows[0]), behind.pixel(1, 28)), (&[0; 3][..], &[255; 3][..]));
    let film = [&["render", "room.vox", "--checkpoint", "a.vxf", "-o", "part.png"][..], &caught, &SMALL].concat();
    folder.succeed(&film);
    let more = ["render", "room.vox", "--resume", "a.vxf", "--spp", "6", "-o", "more.png", "--ground"];
    folder.succeed(&[&more[..], &["--sun", "200,12", "--sky-color", "#000000"]].concat());
    let whole = ["render", "room.vox", "--size", "40x30", "--spp", "6", "-o", "whole.png"];
    folder.succeed(&[&whole[..], &caught].concat());
    assert_eq!(folder.png("more.png").samples, folder.png("whole.png").samples);
    let bare = folder.run(&[&more[..8], &["--sun", "200,12", "--sky-color", "#000000"]].concat());
    assert_eq!(bare.status.code(), Some(5), "{}", stderr(&bare));
    let rest = [&["render", "room.vox", "--first-sample", "4", "--checkpoint", "b.vxf"][..], &SMALL].concat();
    let lit = ["--ground", "--sun", "200,12", "--sky-color", "#000000", "--camera", "auto", "--transparent"];
    folder.succeed(&[&rest[..], &lit].concat());
    assert!(folder.fail(&["merge", "a.vxf", "b.vxf", "-o", "m.vxf"], 5).contains("shadow catcher"));
}

#[test]
fn what_cannot_be_is_refused() {
    let folder = Folder::new();
    for (options, expected) in [
        (&["--ground-color", "#00ff00"][..], "--ground"),
        (&["--ground=low"], "--ground"),
        (&["--fog", "0"], "density"),
        (&["--fog", "file"], "the file says no fog"),
        (&["--background", "file"], "the file says no background; hint: name one: --background '#303030'"),
        (&["--background", "#000000", "--transparent"], "--transparent"),
        (&["--shadow-catcher"], "--ground"),
        (&["--ground", "--shadow-catcher", "--fog", "0.1"], "--fog"),
        (&["--ground", "--shadow-catcher", "--integrator", "essay"], "needs the integrator path"),
    ] {
        let output = folder.run(&[&["render", "room.vox", "-o", "a.png"][..], options].concat());
        assert_eq!(output.status.code(), Some(2), "{options:?}");
        assert!(stderr(&output).contains(expected), "{options:?}: {}", stderr(&output));
    }
}
