//! `render`: what the picture shows, what it is called and what it says about itself.

use crate::common::{Folder, SMALL, stderr, stdout};

#[test]
fn a_picture_shows_the_scene_and_says_how_it_was_made() {
    let folder = Folder::new();
    let picture = folder.render("a.png", &["--seed", "5"]);
    assert_eq!((picture.width, picture.height, picture.channels, picture.bits), (40, 30, 3, 8));
    // The red block in the middle, the bluish white sky above it.
    let (block, sky) = (picture.pixel(20, 15), picture.pixel(1, 1));
    assert!(block[0] > block[1] + 40, "{block:?}");
    assert!(sky[2] >= sky[0] && sky[0] > 150, "{sky:?}");
    assert_eq!(picture.text("voxtrace.seed"), "5");
    assert_eq!(picture.text("voxtrace.samples"), "4");
    assert_eq!(picture.text("voxtrace.integrator"), "path");
    assert_eq!(picture.text("voxtrace.max_bounces"), "8");
    assert_eq!(picture.text("voxtrace.scene"), "room");
    assert_eq!(picture.text("voxtrace.scene_hash").len(), 16);
    assert_eq!(picture.text("voxtrace.camera"), "front");
    assert_eq!(picture.text("voxtrace.camera.eye"), "12,-30,18");
}

#[test]
fn without_an_output_the_picture_is_named_after_the_scene_and_has_the_documented_size() {
    let folder = Folder::new();
    assert_eq!(folder.succeed(&["render", "room.vox", "--spp", "1", "--max-bounces", "1"]), "room.png\n");
    let picture = folder.png("room.png");
    assert_eq!((picture.width, picture.height), (1280, 720));
}

#[test]
fn the_order_of_options_and_the_number_of_threads_make_no_difference() {
    let folder = Folder::new();
    let options = ["--size=40x30", "--spp=3", "--seed=1", "--camera=side", "--threads=1", "-q"];
    let mut arguments = vec!["render", "room.vox", "-o=a.png"];
    arguments.extend(options);
    folder.succeed(&arguments);
    let mut reversed = vec!["--quiet", "--threads=2", "render"];
    reversed.extend(["--camera=side", "--seed=1", "-o=b.png", "--spp=3", "--size=40x30", "room.vox"]);
    folder.succeed(&reversed);
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
    // Another seed makes another picture.
    arguments[2] = "-o=c.png";
    arguments[5] = "--seed=2";
    folder.succeed(&arguments);
    assert_ne!(folder.png("a.png").samples, folder.png("c.png").samples);
}

#[test]
fn the_native_file_and_the_original_give_the_same_picture() {
    let folder = Folder::new();
    let from_vox = folder.render("a.png", &[]);
    folder.succeed(&[&["render", "room.vxt", "-o", "b.png"], &SMALL[..]].concat());
    assert_eq!(from_vox.samples, folder.png("b.png").samples);
    assert_ne!(from_vox.samples, folder.render("c.png", &["--camera", "side"]).samples);
}

#[test]
fn several_cameras_and_several_files_come_from_one_run() {
    let folder = Folder::new();
    let outputs = ["-o", "a.png", "-o", "a.exr"];
    let written = folder.succeed(&[&["render", "room.vox", "--camera", "all"], &outputs[..], &SMALL].concat());
    assert_eq!(written, "a_front.png\na_front.exr\na_side.png\na_side.exr\n");
    assert_eq!(folder.png("a_front.png").samples, folder.render("b.png", &["--camera", "front"]).samples);
    assert_eq!(folder.png("a_side.png").samples, folder.render("b.png", &["--camera", "side"]).samples);
    assert_ne!(folder.png("a_front.png").samples, folder.png("a_side.png").samples);
    let named = folder.succeed(&[&["render", "room.vox", "--camera", "side,auto", "-o", "c.png"], &SMALL[..]].concat());
    assert_eq!(named, "c_side.png\nc_auto.png\n");
}

#[test]
fn parallel_rays_show_all_of_a_scene_where_nothing_says_how_much() {
    let folder = Folder::new();
    let view = ["render", "room.vox", "--camera", "auto", "--transparent", "--spp", "4", "--size", "150x100"];
    // Share of the picture's width and height that the room spans, and how far its middle is from the picture's.
    let spans = |name: &str| {
        let picture = folder.png(name);
        let shown = |&(x, y): &(usize, usize)| *picture.pixel(x, y).last().unwrap() > 0;
        let all = (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))).filter(shown);
        let (mut low, mut high) = ((usize::MAX, usize::MAX), (0, 0));
        all.for_each(|(x, y)| {
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x + 1), high.1.max(y + 1));
        });
        let share = |low: usize, high: usize, all: usize| (high as f32 - low as f32) / all as f32;
        let aside = |low: usize, high: usize, all: usize| (low as f32 + high as f32 - all as f32).abs() / all as f32;
        let (width, height) = (picture.width, picture.height);
        let larger = share(low.0, high.0, width).max(share(low.1, high.1, height));
        (larger, aside(low.0, high.0, width).max(aside(low.1, high.1, height)))
    };
    for projection in ["isometric", "orthographic"] {
        folder.succeed(&[&view[..], &["--projection", projection, "-o", "all.png"]].concat());
        let (larger, aside) = spans("all.png");
        assert!((larger - 0.8).abs() < 0.03 && aside < 0.03, "{projection}: {larger}, {aside}");
        // What is said is kept: a field of view of half as much does not show all.
        folder.succeed(&[&view[..], &["--projection", projection, "--fov", "12", "-o", "part.png"]].concat());
        assert!(spans("part.png").0 > 0.95, "{projection}");
    }
}

#[test]
fn a_turntable_writes_numbered_frames_that_a_second_machine_can_share() {
    let folder = Folder::new();
    let arguments = [&["render", "room.vox", "--turntable", "-o", "shot_####.png"], &SMALL[..]].concat();
    let written = folder.succeed(&[&arguments[..], &["--frames", "1..4"]].concat());
    assert_eq!(written, "shot_0001.png\nshot_0002.png\nshot_0003.png\nshot_0004.png\n");
    let frame = |number: u32| folder.bytes(&format!("shot_000{number}.png"));
    assert_ne!(folder.png("shot_0001.png").samples, folder.png("shot_0002.png").samples);
    assert_eq!(folder.png("shot_0001.png").samples, folder.render("still.png", &[]).samples);
    // Any part of the turn alone is the same.
    let (second, fourth) = (frame(2), frame(4));
    let arguments = [&["render", "room.vox", "--turntable=4", "-o", "shot_####.png"], &SMALL[..]].concat();
    folder.succeed(&[&arguments[..], &["--frames", "3..4"]].concat());
    assert_eq!(frame(4), fourth);
    folder.succeed(&[&arguments[..], &["--frames", "2"]].concat());
    assert_eq!(frame(2), second);
    assert_ne!(second, fourth);
}

#[test]
fn a_flight_goes_from_the_first_camera_of_its_file_to_the_last_and_can_be_shared() {
    let folder = Folder::new();
    let camera = |number: u32, eye: &str| format!("[bookmarks.{number}]\neye = {eye}\ntarget = [12, 12, 3]\n");
    let eyes = ["[12, -30, 18]", "[50, 12, 14]", "[12, 60, 14]"];
    let text: String = (1..).zip(eyes).map(|(number, eye)| camera(number, eye)).collect();
    std::fs::write(folder.path("tour.toml"), text).unwrap();
    let arguments = [&["render", "room.vox", "--flight", "tour.toml", "-o", "f_#.png"], &SMALL[..]].concat();
    assert_eq!(folder.succeed(&[&arguments[..], &["--frames", "1..3"]].concat()), "f_1.png\nf_2.png\nf_3.png\n");
    let still = |eye: &str, seed| {
        let eye = eye.replace(['[', ']', ' '], "");
        let options = ["--eye", &eye, "--target", "12,12,3", "--fov", "45", "--seed", seed];
        folder.render("still.png", &options).samples
    };
    let frame = |number: u32| folder.png(&format!("f_{number}.png")).samples;
    assert_eq!((frame(1), frame(3)), (still(eyes[0], "0"), still(eyes[2], "2")));
    let second = frame(2);
    assert!(second != frame(1) && second != frame(3));
    folder.succeed(&[&arguments[..], &["--flight-frames", "3", "--frames", "2"]].concat());
    assert_eq!(frame(2), second, "a part of the flight alone is the same");
    folder.succeed(&[&arguments[..], &["--flight-frames", "5", "--frames", "2"]].concat());
    assert_ne!(frame(2), second, "of a longer one it is another");
}

#[test]
fn a_crop_is_that_part_of_the_whole_picture() {
    let folder = Folder::new();
    let (whole, part) = (folder.render("a.png", &[]), folder.render("b.png", &["--crop", "10,30,5,25"]));
    assert_eq!((part.width, part.height), (20, 20));
    let equal = |dx: usize| (0..20).all(|y| (0..19).all(|x| part.pixel(x, y) == whole.pixel(x + 10 + dx, y + 5)));
    assert!(equal(0));
    assert!(!equal(1));
}

#[test]
fn a_transparent_picture_lets_the_background_through_and_keeps_the_scene() {
    let folder = Folder::new();
    let picture = folder.render("a.png", &["--transparent"]);
    assert_eq!(picture.channels, 4);
    assert_eq!(picture.pixel(1, 1), [0, 0, 0, 0]);
    let opaque = folder.render("b.png", &[]);
    assert_eq!(picture.pixel(20, 15)[..3], *opaque.pixel(20, 15));
    assert_eq!(picture.pixel(20, 15)[3], 255);
    assert_ne!(picture.pixel(20, 15)[..3], *opaque.pixel(1, 1));
}

#[test]
fn sixteen_bits_hold_what_eight_bits_round() {
    let folder = Folder::new();
    let (fine, coarse) = (folder.render("a.png", &["--bit-depth", "16"]), folder.render("b.png", &[]));
    assert_eq!(fine.bits, 16);
    let rounded: Vec<u16> = fine.samples.iter().map(|&v| (f64::from(v) / 257.0).round() as u16).collect();
    let differing = rounded.iter().zip(&coarse.samples).filter(|(a, b)| a != b).count();
    assert_eq!(differing, 0);
    assert!(fine.samples.iter().any(|v| v % 257 != 0));
}

#[test]
fn cameras_from_options_and_from_a_file_are_the_same() {
    let folder = Folder::new();
    let options = ["--eye=-20,-25,30", "--target", "12,12,0", "--fov", "50", "--up=0,0.2,1"];
    let from_options = folder.render("a.png", &options);
    let toml = "eye = [-20, -25, 30]\ntarget = [12, 12, 0]\nfov_y = 50\nup = [0, 0.2, 1]\n";
    std::fs::write(folder.path("view.toml"), toml).unwrap();
    let from_file = folder.render("b.png", &["--camera-file", "view.toml"]);
    assert_eq!(from_options.samples, from_file.samples);
    assert_eq!(from_file.text("voxtrace.camera"), "view");
    assert_ne!(from_options.samples, folder.render("c.png", &options[..5]).samples);
}

#[test]
fn the_study_s_camera_files_set_the_light_and_options_have_the_last_word() {
    let folder = Folder::new();
    // Where the camera `front` stands, in the study's y-up world.
    let toml = "sky_brightness = 0.0\nlight_intensity = 0.0\n[camera]\nx = 12.0\ny = 18.0\nz = 30.0\npitch = 20.85\n\
                yaw = 0.0\nspeed = 10.0\n";
    std::fs::write(folder.path("view.toml"), toml).unwrap();
    assert_eq!(folder.render("a.png", &["--camera-file", "view.toml"]).mean(), 0.0);
    let lit = ["--camera-file", "view.toml", "--sky-brightness", "1", "--light-intensity", "1"];
    let (ours, theirs) = (folder.render("b.png", &[]), folder.render("c.png", &lit));
    assert!((ours.mean() - theirs.mean()).abs() < 2.0, "{} {}", ours.mean(), theirs.mean());
}

#[test]
fn light_options_change_the_light() {
    let folder = Folder::new();
    let normal = folder.render("a.png", &[]).mean();
    let dark = ["--sky-brightness", "0", "--light-intensity", "0"];
    assert_eq!(folder.render("b.png", &dark).mean(), 0.0);
    assert!(folder.render("c.png", &["--exposure", "-2"]).mean() < normal - 20.0);
    assert!(folder.render("d.png", &["--light-intensity", "20"]).mean() > normal);
    let red = folder.render("e.png", &["--sky-color", "#ff0000"]);
    assert!(red.pixel(1, 1)[0] > 120 && red.pixel(1, 1)[0] > red.pixel(1, 1)[1] + 60, "{:?}", red.pixel(1, 1));
    let sunny = folder.render("f.png", &["--sky-brightness", "0.5", "--sun", "200,50,6"]).mean();
    assert!(sunny > folder.render("g.png", &["--sky-brightness", "0.5"]).mean());
    let linear = folder.render("h.png", &["--tone-map", "linear"]);
    assert_eq!(linear.text("voxtrace.tone_map"), "linear");
    assert_ne!(linear.samples, folder.png("a.png").samples);
}

#[test]
fn a_sky_comes_from_a_panorama_or_from_air() {
    let folder = Folder::new();
    // Sixteen by eight pixels, red to the left and blue to the right, written twice: as Radiance, and as an EXR of its own panorama.
    let mut picture = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n".to_vec();
    (0..128).for_each(|pixel| picture.extend(if pixel % 16 < 8 { [200, 0, 0, 128] } else { [0, 0, 200, 128] }));
    std::fs::write(folder.path("sky.hdr"), &picture).unwrap();
    let away = ["--eye", "500,500,500", "--target", "500,600,500"];
    let panorama = ["--projection", "panorama", "--sky", "sky.hdr", "--size", "32x16", "--spp", "4", "-o", "sky.exr"];
    folder.succeed(&[&["render", "room.vox"][..], &away, &panorama].concat());
    let seen = |name: &str, more: &[&str]| {
        let picture = folder.render(name, &[&away, more].concat());
        [picture.pixel(1, 10).to_vec(), picture.pixel(30, 10).to_vec()]
    };
    for sky in ["sky.hdr", "sky.exr"] {
        let [left, right] = seen("a.png", &["--sky", sky]);
        assert!(left[0] > 150 && left[2] < 50 && right[2] > 150 && right[0] < 50, "{sky}: {left:?} {right:?}");
        let [left, _] = seen("b.png", &["--sky", sky, "--sky-rotation", "180"]);
        assert!(left[2] > 150 && left[0] < 50, "{sky}: {left:?}");
    }
    let [left, _] = seen("c.png", &["--sky", "physical", "--sun", "0,60"]);
    assert!(left[2] > left[0], "{left:?}");
    // Straight into the sun of a black sky, and of a physical one.
    for sky in [&["--sky-color", "#000000", "--sun", "0,0,50"][..], &["--sky", "physical", "--sun", "0,0,50"]] {
        let mean = |disc: &[&str]| folder.render("d.png", &[&away[..], sky, disc].concat()).mean();
        let [told, visible, hidden] = [&[][..], &["--sun-disc", "visible"], &["--sun-disc", "hidden"]].map(mean);
        assert!(told == visible && visible > hidden, "{sky:?}: {told} {visible} {hidden}");
    }
    // A film continues under the sky that it holds.
    let film = ["--sky", "sky.hdr", "--sky-rotation", "20", "--checkpoint", "a.vxf", "-o", "part.png"];
    folder.succeed(&[&["render", "room.vox"], &film[..], &SMALL].concat());
    folder.succeed(&["render", "room.vox", "--resume", "a.vxf", "--spp", "12", "-o", "resumed.png"]);
    let whole = ["--sky", "sky.hdr", "--sky-rotation", "20", "--size", "40x30", "--spp", "12", "-o", "whole.png"];
    folder.succeed(&[&["render", "room.vox"], &whole[..]].concat());
    assert_eq!(folder.png("resumed.png").samples, folder.png("whole.png").samples);
    assert_ne!(folder.png("part.png").samples, folder.png("whole.png").samples);

    std::fs::write(folder.path("broken.hdr"), &picture[..picture.len() - 3]).unwrap();
    for (options, code, expected) in [
        (&["--sky", "missing.hdr"][..], 3, "--sky takes a .hdr or .exr file"),
        (&["--sky", "broken.hdr"], 3, "row 7"),
        (&["--sky", "room.vox"], 3, "neither"),
        (&["--sky-rotation", "20"], 2, "turns a panorama"),
        (&["--sky", "physical", "--sky-rotation", "20"], 2, "--sun says"),
        (&["--sky", "physical", "--sun", "0,40,0"], 2, "needs a sun"),
    ] {
        let message = folder.fail(&[&["render", "room.vox", "-o", "x.png"], options, &SMALL].concat(), code);
        assert!(message.contains(expected), "{options:?}: {message}");
    }
}

#[test]
fn an_exr_has_the_aovs_that_were_asked_for() {
    use exr::prelude::{ReadChannels, ReadLayers};
    let folder = Folder::new();
    let options = ["--aovs", "-o", "a.exr", "--bit-depth", "16"];
    folder.succeed(&[&["render", "room.vox"], &options[..], &SMALL].concat());
    folder.succeed(&[&["render", "room.vox", "-o", "b.exr"], &SMALL[..]].concat());
    let channels = |name: &str| {
        let image = exr::prelude::read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .all_layers()
            .all_attributes()
            .from_file(folder.path(name))
            .unwrap();
        let names: Vec<String> =
            image.layer_data[0].channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
        let depth = image.layer_data[0].channel_data.list.iter().find(|channel| channel.name.eq("depth.Z"));
        let depth: Vec<f32> = depth.map(|channel| channel.sample_data.values_as_f32().collect()).unwrap_or_default();
        (names.join(" "), depth)
    };
    let (names, depth) = channels("a.exr");
    assert_eq!(
        names,
        "A B G R albedo.B albedo.G albedo.R depth.Z id.instance normal.X normal.Y normal.Z voxel.X voxel.Y voxel.Z"
    );
    // The block is some 40 voxels away, the sky nowhere.
    let middle = depth[15 * 40 + 20];
    assert!((38.0..46.0).contains(&middle), "{middle}");
    assert_eq!(depth[0], 0.0);
    assert_eq!(channels("b.exr").0, "A B G R");
}

#[test]
fn a_time_limit_ends_the_render_with_success() {
    let folder = Folder::new();
    let arguments = ["render", "room.vox", "-o", "a.png", "--size", "200x200", "--time-limit", "300ms"];
    folder.succeed(&arguments);
    let samples = folder.png("a.png").text("voxtrace.samples").to_owned();
    assert_ne!(samples, "1048576");
}

#[test]
fn progress_is_json_lines_on_request_and_stdout_holds_paths_alone() {
    let folder = Folder::new();
    let output = folder.run(&[&["render", "room.vox", "-o", "a.png", "--progress", "json"], &SMALL[..]].concat());
    assert!(output.status.success());
    assert_eq!(stdout(&output), "a.png\n");
    let events: Vec<serde_json::Value> =
        stderr(&output).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let progress: Vec<_> = events.iter().filter(|event| event["event"] == "progress").collect();
    assert_eq!(progress.first().unwrap()["samples_done"], 0);
    assert_eq!(progress.last().unwrap()["samples_done"], 40 * 30 * 4);
    assert_eq!(progress.last().unwrap()["samples_total"], 40 * 30 * 4);
    assert!(events.iter().any(|event| event["event"] == "wrote" && event["path"] == "a.png"));
}

#[test]
fn quiet_says_nothing_at_all() {
    let folder = Folder::new();
    let output = folder.run(&[&["render", "room.vox", "-o", "a.png", "--quiet"], &SMALL[..]].concat());
    assert!(output.status.success());
    assert_eq!((stdout(&output), stderr(&output)), (String::new(), String::new()));
    assert!(folder.exists("a.png"));
}

#[test]
fn a_built_in_scene_stands_where_a_file_may() {
    let folder = Folder::new();
    folder.succeed(&[&["render", "church", "--voxels", "20k", "-o", "a.png"], &SMALL[..]].concat());
    assert_eq!(folder.png("a.png").text("voxtrace.scene"), "church");
    assert!(folder.png("a.png").mean() > 1.0);
}

#[test]
fn without_a_gpu_the_cpu_renders_and_says_so() {
    let folder = Folder::new();
    let run = |options: &[&str]| {
        let all = [&["render", "room.vox", "-o", "a.png"], &SMALL[..], options].concat();
        // No driver is found there.
        folder.command(&all).env("VK_DRIVER_FILES", "/nonexistent").env("VK_ICD_FILENAMES", "/nonexistent").output()
    };
    let output = run(&[]).unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stderr(&output).contains("tracing on the CPU: "), "{}", stderr(&output));
    // What was asked for is not silently something else.
    let output = run(&["--traversal", "walk"]).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("hint: `voxtrace devices`"), "{}", stderr(&output));
}

#[test]
fn a_material_that_is_changed_and_a_part_that_is_hidden_are_seen_in_the_picture() {
    let folder = Folder::new();
    let before = folder.render("a.png", &[]);
    let json: serde_json::Value = serde_json::from_str(&folder.succeed(&["info", "room.vox", "--json"])).unwrap();
    assert_eq!(json["objects"].as_array().map(Vec::len), Some(1), "{json}");
    // The block is red in the middle of the picture: its material is the one whose change turns it green.
    let green = (0..3).map(|number| {
        let change = format!("{number}=#00ff00");
        let pixel = folder.render("b.png", &["--material", &change]).pixel(20, 15).to_vec();
        usize::from(pixel[1] > pixel[0] + 40)
    });
    assert_eq!(green.sum::<usize>(), 1);
    let hidden = folder.render("c.png", &["--hide", "0"]);
    assert_eq!(
        hidden.pixel(20, 29),
        folder.render("d.png", &["--hide", "object:0", "--material", "0=#123456"]).pixel(20, 29)
    );
    assert_ne!(hidden.samples, before.samples);
    // What a .vxt file leaves out cannot be shown; what it holds may be asked for.
    folder.succeed(&[&["render", "room.vxt", "--show", "0", "-o", "e.png"], &SMALL[..]].concat());
    assert_eq!(folder.png("e.png").samples, before.samples);
}
