//! Checkpoints, resuming and merging: however a film came to be, its bytes are the same.

use crate::common::{Folder, SMALL, stderr};
use voxtrace::glam::Vec3;
use voxtrace::output::FilmFile;

const SIZE: [&str; 2] = ["--size", "40x30"];

impl Folder {
    /// Renders into a film with these options.
    fn film(&self, name: &str, options: &[&str]) {
        self.succeed(&[&["render", "room.vox", "--checkpoint", name, "-q"], &SIZE[..], options].concat());
    }
}

#[test]
fn four_and_four_samples_resumed_are_eight_bit_for_bit() {
    let folder = Folder::new();
    folder.film("whole.vxf", &["--spp", "8", "-o", "whole.png", "--aovs"]);
    folder.film("half.vxf", &["--spp", "4", "--layers"]);
    // The film knows its settings; only what is new must be said.
    let resume = ["render", "room.vox", "--resume", "half.vxf", "--spp", "8"];
    folder.succeed(&[&resume[..], &["--checkpoint", "rest.vxf", "-o", "rest.png"]].concat());
    assert_eq!(folder.bytes("rest.vxf"), folder.bytes("whole.vxf"));
    assert_eq!(folder.bytes("rest.png"), folder.bytes("whole.png"));
    assert_ne!(folder.bytes("half.vxf"), folder.bytes("whole.vxf"));
    // One sample less is another film.
    folder.film("seven.vxf", &["--spp", "7"]);
    assert_ne!(folder.bytes("seven.vxf"), folder.bytes("whole.vxf"));
}

#[test]
fn the_film_of_a_scene_whose_file_was_renamed_goes_on() {
    let folder = Folder::new();
    folder.film("whole.vxf", &["--spp", "4"]);
    folder.film("half.vxf", &["--spp", "2"]);
    std::fs::copy(folder.path("room.vox"), folder.path("hall.vox")).unwrap();
    let resume = ["--resume", "half.vxf", "--spp", "4", "--checkpoint", "resumed.vxf"];
    folder.succeed(&[&["render", "hall.vox"], &resume[..]].concat());
    assert_eq!(folder.bytes("resumed.vxf"), folder.bytes("whole.vxf"));
    // Another scene stays another one, whatever it is called.
    assert!(folder.fail(&[&["render", "hall.vox", "--ground"], &resume[..]].concat(), 5).contains("scene "));
    // Without the scene nobody knows, and the names say what it may be.
    folder.succeed(&["render", "hall.vox", "--size", "32x24", "--spp", "2", "--first-sample", "2", "-o", "rest.vxf"]);
    folder.succeed(&["render", "room.vox", "--size", "32x24", "--spp", "2", "-o", "first.vxf"]);
    let told = folder.fail(&["merge", "first.vxf", "rest.vxf", "-o", "m.vxf"], 5);
    assert!(told.contains("the scenes are room and hall"), "{told}");
}

#[test]
fn light_groups_are_resumed_and_merged_and_become_layers() {
    let folder = Folder::new();
    let options = ["--light-groups", "--sun", "120,40"];
    folder.film("whole.vxf", &[&options[..], &["--spp", "4", "-o", "whole.exr"]].concat());
    folder.film("half.vxf", &[&options[..], &["--spp", "2"]].concat());
    // The film has groups, so that it keeps them without being asked again.
    let resume = ["render", "room.vox", "--resume", "half.vxf", "--spp", "4"];
    folder.succeed(&[&resume[..], &["--checkpoint", "resumed.vxf"]].concat());
    assert_eq!(folder.bytes("resumed.vxf"), folder.bytes("whole.vxf"));
    folder.film("rest.vxf", &[&options[..], &["--spp", "2", "--first-sample", "2"]].concat());
    folder.succeed(&["merge", "half.vxf", "rest.vxf", "-o", "merged.vxf"]);
    assert_eq!(folder.bytes("merged.vxf"), folder.bytes("whole.vxf"));

    let film = FilmFile::open(&folder.path("whole.vxf")).unwrap().film;
    let names: Vec<&str> = film.groups.iter().map(|(group, _)| group.name()).collect();
    assert_eq!(names, ["sun", "sky", "emitters"]);
    let exr = folder.bytes("whole.exr");
    for layer in ["sun.R", "sky.G", "emitters.B"] {
        assert!(exr.windows(layer.len()).any(|part| part == layer.as_bytes()), "{layer}");
    }
    // One whose last group was still gathered has not all light of its samples.
    let mut broken = FilmFile::open(&folder.path("rest.vxf")).unwrap();
    broken.film.groups[2].1.iter_mut().for_each(|pixel| pixel.samples -= 1);
    broken.save(&folder.path("broken.vxf")).unwrap();
    let told = folder.fail(&["merge", "half.vxf", "broken.vxf", "-o", "m.vxf"], 5);
    assert!(told.contains("broken.vxf was interrupted: not all samples have the light of emitters"), "{told}");
    // The picture itself is that without groups, and such a film has none to merge with.
    folder.film("plain.vxf", &["--sun", "120,40", "--spp", "4"]);
    assert_eq!(FilmFile::open(&folder.path("plain.vxf")).unwrap().film.pixels, film.pixels);
    folder.film("plain_rest.vxf", &["--sun", "120,40", "--spp", "2", "--first-sample", "2"]);
    assert!(folder.fail(&["merge", "half.vxf", "plain_rest.vxf", "-o", "m.vxf"], 5).contains("light groups"));
    let essay = folder.fail(&["render", "room.vox", "--light-groups", "--integrator", "essay"], 2);
    assert!(essay.contains("needs the integrator path"), "{essay}");
}

#[test]
fn light_groups_have_as_many_samples_as_noise_gave_each_pixel() {
    let folder = Folder::new();
    let options = ["--noise", "0.05", "--size", "96x64", "--sun", "120,40", "--max-bounces", "2"];
    let render = |name: &str, more: &[&str]| {
        folder.succeed(&[&["render", "room.vox", "--checkpoint", name][..], &options, more].concat());
        FilmFile::open(&folder.path(name)).unwrap()
    };
    let (plain, grouped) = (render("plain.vxf", &[]), render("grouped.vxf", &["--light-groups"]));
    assert_eq!(plain.film.pixels, grouped.film.pixels);
    let (least, most) = plain.film.sample_range();
    assert!(least < most, "parts of the picture have fewer samples: {least} {most}");
    assert_eq!(grouped.film.groups.len(), 3);
    let mut without_sun = 0;
    for (index, whole) in plain.film.pixels.iter().enumerate() {
        let parts = grouped.film.groups.iter().map(|(_, pixels)| &pixels[index]);
        let sum: Vec3 = parts.clone().map(|part| part.mean()).sum();
        assert!(parts.clone().all(|part| part.samples == whole.samples), "{index}");
        assert!((sum - whole.mean()).abs().max_element() < 1e-4 * (1.0 + whole.mean().max_element()), "{index}");
        without_sun += usize::from((sum - parts.clone().next().unwrap().mean()).distance(whole.mean()) > 1e-2);
    }
    assert!(without_sun > 500, "the comparison sees a group that is left out: {without_sun}");
}

#[test]
fn limits_of_paths_are_part_of_the_film_and_need_not_be_said_again() {
    let folder = Folder::new();
    let limits = ["--diffuse-bounces", "2", "--glossy-bounces", "1", "--clamp-indirect", "0.5"];
    folder.film("whole.vxf", &[&limits[..], &["--spp", "4"]].concat());
    folder.film("half.vxf", &[&limits[..], &["--spp", "2"]].concat());
    let resume = |more: &[&'static str]| [&["render", "room.vox", "--resume", "half.vxf", "--spp", "4"], more].concat();
    folder.succeed(&resume(&["--checkpoint", "rest.vxf"]));
    assert_eq!(folder.bytes("rest.vxf"), folder.bytes("whole.vxf"));
    assert!(folder.fail(&resume(&["--diffuse-bounces", "3", "-o", "a.png"]), 5).contains("bounces by kind 2,1,-,- in"));
    assert!(folder.fail(&resume(&["--clamp-indirect", "2", "-o", "a.png"]), 5).contains("clamp of indirect light 0.5"));
    for (option, value) in [("--clamp-indirect", "0"), ("--volume-bounces", "255"), ("--glossy-bounces", "-1")] {
        folder.fail(&["render", "room.vox", &format!("{option}={value}"), "-o", "a.png"], 2);
    }
}

#[test]
fn pausing_for_checkpoints_changes_nothing() {
    let folder = Folder::new();
    let options = ["--spp", "600", "--max-bounces", "2"];
    folder.film("a.vxf", &options);
    folder.film("b.vxf", &[&options[..], &["--checkpoint-every", "1ms", "--threads", "1"]].concat());
    assert_eq!(folder.bytes("a.vxf"), folder.bytes("b.vxf"));
}

#[test]
fn a_film_that_was_cut_short_anywhere_continues_to_the_same_bytes() {
    let folder = Folder::new();
    folder.film("whole.vxf", &["--spp", "300", "--seed", "3"]);
    let limited = ["--spp", "300", "--seed", "3", "--time-limit", "50ms"];
    folder.film("part.vxf", &limited);
    folder.succeed(&["render", "room.vox", "--resume", "part.vxf", "--checkpoint", "rest.vxf"]);
    assert_eq!(folder.bytes("rest.vxf"), folder.bytes("whole.vxf"));
}

#[test]
fn cuts_are_part_of_the_film_and_need_not_be_said_again() {
    let folder = Folder::new();
    let cuts = ["--clip-plane", "0,0.2,1,4.5", "--slice", "x=1,6"];
    folder.film("whole.vxf", &[&cuts[..], &["--spp", "4"]].concat());
    folder.film("half.vxf", &[&cuts[..], &["--spp", "2"]].concat());
    folder.film("uncut.vxf", &["--spp", "4"]);
    assert_ne!(folder.bytes("uncut.vxf"), folder.bytes("whole.vxf"));
    let resume = ["render", "room.vox", "--resume", "half.vxf", "--spp", "4", "--checkpoint", "half.vxf"];
    let other = folder.fail(&[&resume[..], &["--slice", "x=1,5"]].concat(), 5);
    assert!(other.contains("cuts") && other.contains("in the film"), "{other}");
    folder.succeed(&resume);
    assert_eq!(folder.bytes("half.vxf"), folder.bytes("whole.vxf"));
    folder.film("rest.vxf", &["--spp", "4", "--first-sample", "4", "--clip-shadows", "--slice", "x=1,6"]);
    let merged = folder.fail(&["merge", "whole.vxf", "rest.vxf", "-o", "all.vxf"], 5);
    assert!(merged.contains("cuts"), "{merged}");
}

#[test]
fn light_options_are_part_of_the_film_and_need_not_be_said_again() {
    let folder = Folder::new();
    let light = ["--sky-brightness", "0.25", "--transparent", "--camera", "side"];
    folder.film("whole.vxf", &[&light[..], &["--spp", "4"]].concat());
    folder.film("half.vxf", &[&light[..], &["--spp", "2"]].concat());
    folder.succeed(&["render", "room.vox", "--resume", "half.vxf", "--spp", "4", "--checkpoint", "half.vxf"]);
    assert_eq!(folder.bytes("half.vxf"), folder.bytes("whole.vxf"));
}

#[test]
fn a_film_of_another_scene_or_other_settings_is_refused_by_name() {
    let folder = Folder::new();
    folder.film("a.vxf", &["--spp", "4", "--seed", "3"]);
    let resume = |options: &[&str]| {
        let arguments = [&["render", "room.vox", "--resume", "a.vxf", "-o", "a.png"], options].concat();
        folder.fail(&arguments, 5)
    };
    assert!(resume(&["--seed", "4"]).contains("seed 3 in the film, 4 asked for"));
    assert!(resume(&["--size", "40x31"]).contains("size 40x30 in the film, 40x31 asked for"));
    assert!(resume(&["--camera", "side"]).contains("camera"));
    assert!(resume(&["--integrator", "essay"]).contains("integrator path in the film, essay asked for"));
    assert!(resume(&["--max-bounces", "3"]).contains("maximum of bounces 8 in the film, 3"));
    assert!(resume(&["--first-sample", "4"]).contains("first sample"));
    assert!(resume(&["--light-intensity", "3"]).contains("light intensity 1 in the film, 3"));
    assert!(resume(&["--sky-brightness", "3"]).contains("sky"));
    assert!(resume(&["--transparent"]).contains("transparency"));
    assert!(resume(&["--crop", "0,4,0,4"]).contains("crop"));
    assert!(resume(&["--spp", "2"]).contains("holds 4 samples already, 2 were asked for"));
    let mut scene = crate::common::room();
    scene.materials[0].base_color.x = 0.25;
    voxtrace::export::vox::write(&folder.path("room.vox"), &scene).unwrap();
    assert!(resume(&[]).contains("scene"));
    assert!(!folder.exists("a.png"));
}

#[test]
fn films_of_different_samples_merge_in_any_order_to_the_film_of_all() {
    let folder = Folder::new();
    folder.film("whole.vxf", &["--spp", "9", "-o", "whole.png"]);
    folder.film("a.vxf", &["--spp", "2"]);
    folder.film("b.vxf", &["--spp", "4", "--first-sample", "2"]);
    folder.film("c.vxf", &["--spp", "3", "--first-sample", "6"]);
    for order in [["a.vxf", "b.vxf", "c.vxf"], ["c.vxf", "a.vxf", "b.vxf"], ["b.vxf", "c.vxf", "a.vxf"]] {
        let outputs = ["-o", "sum.vxf", "-o", "sum.png"];
        assert_eq!(folder.succeed(&[&["merge"], &order[..], &outputs].concat()), "sum.vxf\nsum.png\n");
        assert_eq!(folder.bytes("sum.vxf"), folder.bytes("whole.vxf"));
        assert_eq!(folder.bytes("sum.png"), folder.bytes("whole.png"));
    }
    folder.succeed(&["merge", "a.vxf", "b.vxf", "-o", "sum.vxf"]);
    assert_ne!(folder.bytes("sum.vxf"), folder.bytes("whole.vxf"));
}

#[test]
fn a_single_film_becomes_a_picture_with_other_exposure() {
    let folder = Folder::new();
    folder.film("a.vxf", &["--spp", "4", "-o", "a.png"]);
    folder.succeed(&["merge", "a.vxf", "-o", "same.png", "-o", "a.exr"]);
    assert_eq!(folder.bytes("same.png"), folder.bytes("a.png"));
    folder.succeed(&["merge", "a.vxf", "-o", "bright.png", "--exposure", "1"]);
    assert!(folder.png("bright.png").mean() > folder.png("a.png").mean() + 5.0);
}

#[test]
fn gaps_overlaps_and_strangers_are_refused_with_their_ranges() {
    let folder = Folder::new();
    folder.film("a.vxf", &["--spp", "4"]);
    folder.film("b.vxf", &["--spp", "4", "--first-sample", "6"]);
    folder.film("c.vxf", &["--spp", "4", "--first-sample", "2"]);
    folder.film("d.vxf", &["--spp", "4", "--first-sample", "4", "--seed", "9"]);
    let merge = |a: &str, b: &str| folder.fail(&["merge", a, b, "-o", "sum.vxf"], 5);
    assert!(merge("b.vxf", "a.vxf").contains("0..4 of a.vxf and 6..10 of b.vxf leave a gap"));
    assert!(merge("a.vxf", "c.vxf").contains("0..4 of a.vxf and 2..6 of c.vxf overlap"));
    assert!(merge("a.vxf", "a.vxf").contains("overlap"));
    assert!(merge("a.vxf", "d.vxf").contains("seed 0 in the film, 9 in the other"));
    assert!(!folder.exists("sum.vxf"));
}

#[test]
fn an_incomplete_film_must_be_resumed_before_it_is_merged() {
    let folder = Folder::new();
    folder.film("a.vxf", &["--spp", "4"]);
    folder.film("b.vxf", &["--spp", "4", "--first-sample", "4"]);
    let mut film = FilmFile::open(&folder.path("a.vxf")).unwrap();
    film.film.pixels[7].samples = 3;
    film.save(&folder.path("a.vxf")).unwrap();
    let error = folder.fail(&["merge", "a.vxf", "b.vxf", "-o", "sum.vxf"], 5);
    assert!(error.contains("a.vxf was interrupted: its pixels hold 3 to 4 samples"), "{error}");
}

#[test]
fn a_damaged_film_is_unreadable_input() {
    let folder = Folder::new();
    folder.film("a.vxf", &["--spp", "2"]);
    let mut bytes = folder.bytes("a.vxf");
    bytes[5000] ^= 4;
    std::fs::write(folder.path("a.vxf"), bytes).unwrap();
    let error = folder.fail(&["merge", "a.vxf", "-o", "a.png"], 3);
    assert!(error.contains("a.vxf: damaged: the checksum does not match (at byte"), "{error}");
    assert!(folder.fail(&["render", "room.vox", "--resume", "a.vxf"], 3).contains("damaged"));
    assert!(folder.fail(&["render", "room.vox", "--resume", "room.vox"], 3).contains("not a film file"));
    assert!(folder.fail(&["merge", "none.vxf", "-o", "a.png"], 3).contains("cannot read the film none.vxf"));
}

#[test]
fn crops_are_merged_to_the_film_of_the_whole_picture() {
    let folder = Folder::new();
    folder.film("whole.vxf", &["--spp", "4", "-o", "whole.png", "--aovs"]);
    let crops = [("a.vxf", "0,25,0,30"), ("b.vxf", "25,40,0,12"), ("c.vxf", "25,40,12,30")];
    for (name, crop) in crops {
        folder.film(name, &["--spp", "4", "--crop", crop, "--aovs"]);
    }
    for order in [["a.vxf", "b.vxf", "c.vxf"], ["c.vxf", "a.vxf", "b.vxf"]] {
        folder.succeed(&[&["merge"], &order[..], &["-o", "all.vxf", "-o", "all.png"]].concat());
        assert_eq!(folder.bytes("all.vxf"), folder.bytes("whole.vxf"));
        assert_eq!(folder.bytes("all.png"), folder.bytes("whole.png"));
    }
    // A crop of other samples is added up first, and the rest of the picture is missed.
    folder.film("d.vxf", &["--spp", "2", "--crop", "25,40,0,12", "--aovs", "--first-sample", "4"]);
    let gap = folder.fail(&["merge", "a.vxf", "c.vxf", "d.vxf", "-o", "gap.vxf"], 5);
    assert!(gap.contains("begin with different samples"), "{gap}");
    let gap = folder.fail(&["merge", "a.vxf", "c.vxf", "-o", "gap.vxf"], 5);
    assert!(gap.contains("no film has the pixel 25,0") && gap.contains("fill a rectangle"), "{gap}");
    folder.film("e.vxf", &["--spp", "4", "--crop", "25,40,0,12", "--seed", "1"]);
    let stranger = folder.fail(&["merge", "a.vxf", "c.vxf", "e.vxf", "-o", "gap.vxf"], 5);
    assert!(stranger.contains("seed") && !folder.exists("gap.vxf"), "{stranger}");
    // With the samples that follow, parts and all.
    folder.succeed(&["merge", "a.vxf", "c.vxf", "b.vxf", "d.vxf", "-o", "uneven.vxf"]);
    assert_eq!(FilmFile::open(&folder.path("uneven.vxf")).unwrap().film.sample_range(), (4, 6));
    let resume = ["render", "room.vox", "--resume", "uneven.vxf", "--spp", "6", "--checkpoint", "even.vxf"];
    folder.succeed(&resume);
    folder.film("six.vxf", &["--spp", "6", "--aovs"]);
    assert_eq!(folder.bytes("even.vxf"), folder.bytes("six.vxf"));
}

#[test]
fn a_turntable_is_resumed_frame_by_frame_and_frames_without_a_film_begin_anew() {
    let folder = Folder::new();
    let turn = ["--turntable=8", "--seed", "5", "--sun", "120,40"];
    let frames = |frames: &'static str| ["--frames", frames];
    folder.film("whole_##.vxf", &[&turn[..], &frames("2..4"), &["--spp", "6", "-o", "whole_##.png"]].concat());
    folder.film("part_##.vxf", &[&turn[..], &frames("2..3"), &["--spp", "2"]].concat());
    let resume = ["render", "room.vox", "--resume", "part_##.vxf", "--turntable=8", "--frames", "2..4", "--spp", "6"];
    folder.succeed(&[&resume[..], &["--checkpoint", "part_##.vxf", "-o", "part_##.png"]].concat());
    for frame in ["02", "03", "04"] {
        for kind in ["vxf", "png"] {
            let (part, whole) = (format!("part_{frame}.{kind}"), format!("whole_{frame}.{kind}"));
            assert_eq!(folder.bytes(&part), folder.bytes(&whole), "{part}");
        }
    }
    assert_ne!(folder.bytes("whole_02.vxf"), folder.bytes("whole_03.vxf"));
    // Films of other frames are refused by name, and so is a pattern that no film has.
    std::fs::copy(folder.path("whole_04.vxf"), folder.path("part_03.vxf")).unwrap();
    let wrong = folder.fail(&[&resume[..], &["-o", "x_##.png"]].concat(), 5);
    assert!(wrong.contains("part_03.vxf") && wrong.contains("camera"), "{wrong}");
    let none = ["render", "room.vox", "--resume", "none_##.vxf", "--turntable=8", "-o", "x_##.png"];
    let none = folder.fail(&none, 3);
    assert!(none.contains("no none_01.vxf") && none.contains("####"), "{none}");
}

#[test]
fn layers_that_no_output_holds_are_warned_of() {
    let folder = Folder::new();
    let warned = |option: &str, outputs: &[&str]| {
        let output = folder.run(&[&["render", "room.vox", option], &SMALL[..], outputs].concat());
        assert!(output.status.success());
        stderr(&output).contains(&format!("warning: {option} is for EXR and films"))
    };
    for option in ["--aovs", "--light-groups"] {
        assert!(warned(option, &["-o", "a.png"]));
        for outputs in [&["-o", "a.png", "-o", "a.exr"][..], &["-o", "a.vxf"], &["--checkpoint", "a.vxf"]] {
            assert!(!warned(option, outputs), "{option} {outputs:?}");
        }
    }
}
