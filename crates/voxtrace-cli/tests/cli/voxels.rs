//! Files of voxels on the command line, and what is done to scenes once they are read.

use crate::common::{Folder, SMALL, stderr};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use voxtrace::material::srgb_from_linear;

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Copies samples from the corpus of the fuzz target.
fn copy(folder: &Folder, names: &[&str]) {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/voxels");
    for name in names {
        std::fs::copy(corpus.join(name), folder.path(name)).unwrap();
    }
}

#[test]
fn a_build_is_rendered_converted_and_voxelized_directly() {
    let folder = Folder::new();
    copy(&folder, &["second.schem", "gzip.mca", "runs.qb", "a.binvox"]);
    for name in ["second.schem", "runs.qb", "a.binvox"] {
        folder.succeed(&[&["render", name, "-o", "build.png"][..], &SMALL].concat());
        assert!(folder.bytes("build.png").starts_with(b"\x89PNG"));
        let voxels = json(&folder.succeed(&["info", name, "--json"]))["voxels"].clone();
        assert_eq!(voxels, 21, "{name}");
        folder.succeed(&["voxelize", name, "-o", "a.vxt"]);
        folder.succeed(&["convert", name, "b.vox"]);
        for out in ["a.vxt", "b.vox"] {
            assert_eq!(json(&folder.succeed(&["info", out, "--json"]))["voxels"], voxels, "{name} {out}");
        }
    }
    // Unknown blocks are warned of, but only where they are.
    assert!(!stderr(&folder.run(&["info", "second.schem"])).contains("unknown"));
    assert!(stderr(&folder.run(&["info", "gzip.mca"])).contains("14 kinds of blocks are unknown"));
}

#[test]
fn options_of_what_becomes_voxels_are_told_to_change_nothing_of_what_is_voxels() {
    let folder = Folder::new();
    let told = |options: &[&str]| stderr(&folder.run(&[&["info"], options].concat()));
    for name in ["room.vox", "room.vxt"] {
        let both = told(&[name, "--transfer", "ct-bone", "--resolution", "64"]);
        let expected = format!("--resolution, --transfer change nothing: the voxels of {name} are taken as they are");
        assert!(both.contains(&expected), "{both}");
        assert!(told(&[name, "--fill"]).contains("warning: --fill changes nothing"));
        let own = told(&[name, "--up-axis", "x", "--unit", "ft"]);
        assert!(
            own.contains("--up-axis, --unit change nothing: ") && own.contains("says itself which way is up"),
            "{own}"
        );
        let blocks = told(&[name, "--block-size", "4", "--resource-pack", "missing.zip"]);
        let expected = format!("--block-size, --resource-pack change nothing: {name} holds no blocks of Minecraft");
        assert!(blocks.contains(&expected), "{blocks}");
        assert!(told(&[name, "--surface", "thin", "--spacing", "2"]).contains("--surface, --spacing change nothing: "));
        assert_eq!(told(&[name, "--palette", "9", "--color-by", "auto"]), "");
    }
    for name in ["room.vox", "room.vxt"] {
        assert!(told(&[name, "--shell", "true"]).contains("--shell changes nothing: the voxels of "), "{name}");
    }
    let made = told(&["city", "--voxels", "5000", "--resolution", "64", "--unit", "m", "--block-size", "2"]);
    assert!(made.contains("--resolution, --unit, --block-size change nothing: city is made"), "{made}");
    assert_eq!(told(&["city", "--voxels", "5000"]), "");
}

#[test]
fn blocks_have_as_many_voxels_as_asked_for_and_those_inside_where_a_cut_shows_them() {
    let folder = Folder::new();
    copy(&folder, &["second.schem"]);
    let count = |options: &[&str]| {
        let info = folder.succeed(&[&["info", "second.schem", "--json"], options].concat());
        json(&info)["voxels"].as_u64().unwrap()
    };
    assert_eq!(count(&["--block-size", "4", "--shell", "false"]), 21 * 64);
    assert!(count(&["--block-size", "4"]) < 21 * 64);
    let line = folder.fail(&["info", "second.schem", "--block-size", "3"], 2);
    assert!(line.contains("--block-size"), "{line}");
    let line = folder.fail(&["info", "second.schem", "--resource-pack", "missing.zip"], 3);
    assert!(line.contains("missing.zip"), "{line}");
}

#[test]
fn what_is_damaged_in_part_is_told_in_one_line_or_refused() {
    let folder = Folder::new();
    copy(&folder, &["second.schem"]);
    let longer = [&folder.bytes("second.schem")[..], b"and more"].concat();
    std::fs::write(folder.path("longer.schem"), longer).unwrap();
    let output = folder.run(&["info", "longer.schem"]);
    let told = stderr(&output);
    assert!(
        output.status.success() && told.contains("warning: longer.schem: 8 bytes behind the build are left out"),
        "{told}"
    );
    let verbs: [&[&str]; 4] = [
        &["info", "longer.schem"],
        &["render", "longer.schem", "-o", "a.png"],
        &["convert", "longer.schem", "a.vxt"],
        &["voxelize", "longer.schem", "-o", "a.vxt"],
    ];
    for verb in verbs {
        let line = folder.fail(&[verb, &["--strict"]].concat(), 3);
        assert!(line.contains("8 bytes behind the build"), "{line}");
    }
}

#[test]
fn a_folder_of_a_world_is_a_scene() {
    let folder = Folder::new();
    copy(&folder, &["r.0.0.mca"]);
    std::fs::create_dir_all(folder.path("world/region")).unwrap();
    for name in ["r.0.0.mca", "r.1.0.mca"] {
        std::fs::copy(folder.path("r.0.0.mca"), folder.path("world/region").join(name)).unwrap();
    }
    let info = json(&folder.succeed(&["info", "world", "--json"]));
    assert_eq!((&info["voxels"], &info["size"]["x"]), (&42.into(), &517.into()));
}

#[test]
fn hidden_voxels_are_dropped_on_request_and_the_picture_stays() {
    let folder = Folder::new();
    for scene in ["room.vox", "room.vxt"] {
        let count =
            |options: &[&str]| json(&folder.succeed(&[&["info", scene, "--json"], options].concat()))["voxels"].clone();
        // Inside the block of 6³ that stands on the floor.
        assert_eq!(count(&[]).as_u64().unwrap() - 80, count(&["--excavate"]).as_u64().unwrap());
        assert_eq!(count(&["--excavate=sealed"]), count(&["--excavate=buried"]));
        folder.succeed(&[&["render", scene, "--camera", "front", "-o", "all.png"][..], &SMALL].concat());
        folder.succeed(&[&["render", scene, "--camera", "front", "-o", "some.png", "--excavate"][..], &SMALL].concat());
        let (all, some) = (folder.png("all.png"), folder.png("some.png"));
        assert!((0..40 * 30).all(|i| all.pixel(i % 40, i / 40) == some.pixel(i % 40, i / 40)));
    }
    folder.succeed(&["voxelize", "room.vox", "-o", "shell.vxt", "--excavate"]);
    assert_eq!(json(&folder.succeed(&["info", "shell.vxt", "--json"]))["voxels"], 576 + 216 + 8 - 80);
    let refused = folder.run(&["voxelize", "room.vox", "-o", "a.vxt", "--excavate", "--memory-budget", "1MB"]);
    assert_eq!(refused.status.code(), Some(2));
}

/// The colours of the voxels of a file.
fn colors(folder: &Folder, name: &str) -> BTreeSet<[u8; 3]> {
    let scene = voxtrace::import::open(&folder.path(name), &Default::default()).unwrap();
    let materials = scene.grids.iter().flat_map(|grid| grid.voxels().map(|(_, material)| usize::from(material)));
    materials.map(|material| scene.materials[material].base_color.to_array().map(srgb_from_linear)).collect()
}

#[test]
fn a_palette_holds_for_files_of_voxels_as_for_meshes() {
    let folder = Folder::new();
    copy(&folder, &["second.schem", "runs.qb"]);
    let whole = colors(&folder, "runs.qb");
    assert!(whole.len() > 3, "{whole:?}");
    for (name, most) in [("second.schem", 3), ("runs.qb", 3), ("room.vox", 2), ("room.vxt", 2)] {
        let palette = most.to_string();
        for out in ["few.vxt", "few.vox"] {
            folder.succeed(&["voxelize", name, "-o", out, "--palette", &palette]);
            let found = colors(&folder, out);
            assert!(found.len() <= most && !found.is_empty(), "{name} {out}: {found:?}");
            folder.succeed(&["convert", name, "again.vxt", "--palette", &palette, "--dither"]);
            assert!(colors(&folder, "again.vxt").len() <= most, "{name}");
        }
        let voxels = |name: &str| json(&folder.succeed(&["info", name, "--json"]))["voxels"].clone();
        assert_eq!(voxels("few.vxt"), voxels(name), "{name}");
    }
    // As many colours as there are change nothing.
    folder.succeed(&["voxelize", "runs.qb", "-o", "same.vxt", "--palette", &whole.len().to_string()]);
    assert_eq!(colors(&folder, "same.vxt"), whole);
}

#[test]
fn a_scene_takes_the_colours_of_a_picture() {
    let folder = Folder::new();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().unwrap().write_image_data(&[0, 0, 255, 255, 255, 0]).unwrap();
    std::fs::write(folder.path("two.png"), bytes).unwrap();
    folder.succeed(&["convert", "room.vox", "two.vox", "--palette-image", "two.png"]);
    let used = colors(&folder, "two.vox");
    assert!(used.iter().all(|color| [[0, 0, 255], [255, 255, 0]].contains(color)), "{used:?}");
    std::fs::write(folder.path("bad.png"), b"no picture").unwrap();
    assert_eq!(folder.run(&["info", "room.vox", "--palette-image", "bad.png"]).status.code(), Some(3));
}
