//! Levels of detail: written by `convert` and `voxelize`, listed by `info`, shown by `--level`.

use crate::common::{Folder, SMALL};

/// A city with its levels, and the same without.
fn city(folder: &Folder) {
    folder.succeed(&["convert", "city", "--voxels", "100k", "plain.vxt"]);
    folder.succeed(&["convert", "plain.vxt", "city.vxt", "--levels", "all"]);
}

#[test]
fn levels_are_written_listed_and_shown() {
    let folder = Folder::new();
    city(&folder);
    let value: serde_json::Value = serde_json::from_str(&folder.succeed(&["info", "city.vxt", "--json"])).unwrap();
    let levels = value["levels"].as_array().unwrap();
    assert!(levels.len() >= 4);
    let voxels: Vec<u64> = levels.iter().map(|level| level["voxels"].as_u64().unwrap()).collect();
    assert!(voxels.is_sorted_by(|a, b| *b < a / 2 && *a <= value["voxels"].as_u64().unwrap()), "{voxels:?}");
    let text = folder.succeed(&["info", "city.vxt"]);
    assert!(text.contains("level 1 ") && text.contains(&format!("level {} ", levels.len())), "{text}");
    assert!(!folder.succeed(&["info", "plain.vxt"]).contains("level"));

    // A level is a scene of its own: the world, the cameras and about the brightness stay.
    let of = |level: &'static str| {
        let name = format!("{level}.png");
        folder.succeed(&[&["render", "city.vxt", "--level", level, "-o", &name], &SMALL[..]].concat());
        folder.bytes(&name)
    };
    let whole = of("0");
    folder.succeed(&[&["render", "plain.vxt", "-o", "plain.png"], &SMALL[..]].concat());
    assert_eq!(folder.bytes("plain.png"), whole, "level 0 is the scene");
    let first = of("1");
    assert_ne!(first, whole);
    let mean = |name: &str| folder.png(name).mean();
    assert!((mean("1.png") / mean("0.png") - 1.0).abs() < 0.2, "{} {}", mean("1.png"), mean("0.png"));
    folder.succeed(&["convert", "city.vxt", "--level", "1", "first.vxt"]);
    folder.succeed(&[&["render", "first.vxt", "-o", "again.png"], &SMALL[..]].concat());
    assert_eq!(folder.bytes("again.png"), first);
    folder.succeed(&[&["render", "city.vxt", "--level", "1", "--in-memory", "-o", "m.png"], &SMALL[..]].concat());
    assert_eq!(folder.bytes("m.png"), first);
}

#[test]
fn a_file_for_streaming_is_the_scene_with_all_levels_for_every_verb() {
    let folder = Folder::new();
    city(&folder);
    folder.succeed(&["convert", "plain.vxt", "streamed.vxt", "--stream"]);
    assert!(folder.bytes("streamed.vxt").len() < folder.bytes("city.vxt").len());
    let info =
        |name: &str| -> serde_json::Value { serde_json::from_str(&folder.succeed(&["info", name, "--json"])).unwrap() };
    let (streamed, levels) = (info("streamed.vxt"), info("city.vxt"));
    assert_eq!(streamed["content_hash"], levels["content_hash"]);
    let voxels = |value: &serde_json::Value| -> Vec<u64> {
        value["levels"].as_array().unwrap().iter().map(|level| level["voxels"].as_u64().unwrap()).collect()
    };
    assert!(voxels(&streamed).len() >= 4);
    assert_eq!(voxels(&streamed), voxels(&levels));
    for level in ["0", "2"] {
        let of = |name: &str, out: &str| {
            folder.succeed(&[&["render", name, "--level", level, "-o", out], &SMALL[..]].concat());
            folder.png(out).samples
        };
        assert!(of("streamed.vxt", "a.png") == of("city.vxt", "b.png"), "level {level}");
    }
    // Back to a plain file, and from the voxelizer.
    folder.succeed(&["convert", "streamed.vxt", "again.vxt"]);
    assert_eq!(folder.bytes("again.vxt"), folder.bytes("plain.vxt"));
    let said = folder.fail(&["convert", "plain.vxt", "out.vox", "--stream"], 2);
    assert!(said.contains("only .vxt files can be streamed"), "{said}");
    folder.fail(&["convert", "plain.vxt", "out.vxt", "--stream", "--levels", "2"], 2);
}

#[test]
fn levels_that_are_not_there_or_have_no_place_are_refused_with_what_to_do() {
    let folder = Folder::new();
    folder.succeed(&["convert", "room.vox", "two.vxt", "--levels", "2"]);
    let said = folder.fail(&["render", "two.vxt", "--level", "3", "-o", "a.png"], 3);
    assert!(said.contains("up to 2") && said.contains("voxtrace info"), "{said}");
    let said = folder.fail(&["info", "room.vxt", "--level", "1"], 3);
    assert!(said.contains("no levels of detail") && said.contains("--levels all"), "{said}");
    for scene in ["room.vox", "city"] {
        let said = folder.fail(&["render", scene, "--level", "1", "-o", "a.png"], 2);
        assert!(said.contains("only .vxt files"), "{said}");
    }
    let said = folder.fail(&["convert", "room.vxt", "out.vox", "--levels", "all"], 2);
    assert!(said.contains("only .vxt files have levels"), "{said}");
    for wrong in ["0", "17", "some"] {
        folder.fail(&["convert", "room.vxt", "out.vxt", "--levels", wrong], 2);
    }
    assert!(!folder.exists("out.vxt") && !folder.exists("out.vox"));
}

#[test]
fn what_is_voxelized_brick_by_brick_gets_the_levels_that_convert_gives_it() {
    let folder = Folder::new();
    let points: String =
        (0..6000u32).map(|i| format!("{} {} {} {} 90 30\n", i % 97, i / 97, (i * i) % 23, i % 256)).collect();
    std::fs::write(folder.path("cloud.xyz"), points).unwrap();
    let options = ["--resolution", "97", "-o"];
    for (name, more) in
        [("a.vxt", &["--levels", "3"][..]), ("b.vxt", &[]), ("c.vxt", &["--levels", "3", "--memory-budget", "1MB"])]
    {
        folder.succeed(&[&["voxelize", "cloud.xyz"], &options[..], &[name], more].concat());
    }
    folder.succeed(&["convert", "b.vxt", "d.vxt", "--levels", "3"]);
    let info = |name: &str| {
        let value: serde_json::Value = serde_json::from_str(&folder.succeed(&["info", name, "--json"])).unwrap();
        (value["levels"].clone(), value["content_hash"].clone())
    };
    assert_eq!(info("a.vxt").0.as_array().unwrap().len(), 3);
    assert_eq!(info("a.vxt"), info("d.vxt"));
    assert_eq!(info("a.vxt"), info("c.vxt"));
    assert_eq!(folder.bytes("a.vxt").len(), folder.bytes("d.vxt").len());
    assert_ne!(info("a.vxt"), info("b.vxt"));
}

/// Kills the process outright at many moments.
#[cfg(unix)]
#[test]
fn killed_while_levels_are_written_the_file_is_the_old_or_the_new_one() {
    use std::time::{Duration, Instant};
    let folder = Folder::new();
    folder.succeed(&["convert", "city", "--voxels", "400k", "plain.vxt", "-q"]);
    let arguments = ["convert", "plain.vxt", "out.vxt", "--levels", "all", "-q"];
    let old = folder.bytes("room.vxt");
    let restore = || std::fs::write(folder.path("out.vxt"), &old).unwrap();
    restore();
    let start = Instant::now();
    folder.succeed(&arguments);
    let (mut whole, new) = (start.elapsed(), folder.bytes("out.vxt"));
    assert_ne!(old, new);
    let mut kept = 0;
    let mut moment = 0;
    while moment < 12 || kept <= 3 {
        assert!(moment < 200, "only {kept} were killed before the end");
        restore();
        let mut child = folder.command(&arguments).spawn().unwrap();
        std::thread::sleep(Duration::from_secs_f64(whole.as_secs_f64() * f64::from(moment % 12) / 10.0));
        child.kill().unwrap();
        child.wait().unwrap();
        let found = folder.bytes("out.vxt");
        assert!(found == old || found == new, "moment {moment}: a part of a file of {} bytes", found.len());
        if found == old {
            kept += 1;
        } else if moment % 12 < 6 {
            // The first one was held up: it takes less.
            whole = whole.mul_f64(0.7);
        }
        moment += 1;
    }
    folder.succeed(&arguments);
    assert_eq!(folder.bytes("out.vxt"), new);
}
