//! Instances that stand on the lattice become one grid, unless `--keep-instances` says otherwise.

use crate::common::{Folder, SMALL, room, stderr};
use serde_json::Value;
use voxtrace::glam::IVec3;
use voxtrace::{Scene, Transform, VoxelGrid};

/// A folder that also has `models.vox`: the room as two models, side by side.
fn folder() -> Folder {
    let folder = Folder::new();
    let whole = room();
    let mut models = Scene { grids: vec![], instances: vec![], ..whole.clone() };
    for side in 0..2 {
        let mut half = VoxelGrid::new();
        let moved = IVec3::new(12 * side, 0, 0);
        let of_half = whole.grids[0].voxels().filter(|(voxel, _)| voxel.x / 12 == side);
        of_half.for_each(|(voxel, material)| _ = half.set(voxel - moved, material));
        models.add_instance(half, Transform::from_translation(moved.as_vec3()));
    }
    voxtrace::export::vox::write(&folder.path("models.vox"), &models).unwrap();
    folder
}

fn merged(folder: &Folder, words: &[&str]) -> u64 {
    let text = folder.succeed(&[&["info", "--json"][..], words].concat());
    let info: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&info["models"], &info["instances"]), (&2.into(), &2.into()), "{words:?}");
    info["merged_instances"].as_u64().unwrap()
}

fn picture(folder: &Folder, words: &[&str]) -> Vec<u16> {
    folder.succeed(&[&["render", "-o", "picture.png"][..], words, &SMALL].concat());
    folder.png("picture.png").samples
}

#[test]
fn models_are_rendered_as_one_grid_and_kept_apart_where_that_is_asked_for() {
    let folder = folder();
    assert_eq!((merged(&folder, &["models.vox"]), merged(&folder, &["models.vox", "--keep-instances"])), (2, 0));
    let text = |words: &[&str]| folder.succeed(&[&["info"][..], words].concat());
    assert!(
        text(&["models.vox"]).contains("instances         2 (2 merged into one grid)\n"),
        "{}",
        text(&["models.vox"])
    );
    assert!(text(&["models.vox", "--keep-instances"]).contains("instances         2\n"));
    assert_eq!(picture(&folder, &["models.vox"]), picture(&folder, &["room.vox"]), "the same voxels, bit for bit");
    // Films of one are not continued as the other.
    let checkpoint = |options: &[&str], film: &str| {
        folder.succeed(&[&["render", "models.vox", "--checkpoint", film][..], options, &SMALL].concat());
    };
    checkpoint(&[], "merged.vxf");
    checkpoint(&["--keep-instances"], "kept.vxf");
    let resume = |film: &str, options: &[&str]| {
        folder.run(&[&["render", "models.vox", "--resume", film, "--spp", "5", "-o", "more.png"][..], options].concat())
    };
    assert_eq!(resume("merged.vxf", &[]).status.code(), Some(0));
    assert_eq!(resume("kept.vxf", &["--keep-instances"]).status.code(), Some(0));
    let other = resume("kept.vxf", &[]);
    assert_eq!(other.status.code(), Some(5), "{}", stderr(&other));
}

#[test]
fn parts_are_hidden_and_lines_drawn_as_with_instances_apart() {
    let folder = folder();
    folder.succeed(&["convert", "models.vox", "models.vxt"]);
    for options in [&["--hide", "object:1"][..], &["--edges"], &["--grid=0.2,#000000,5"]] {
        let of = |words: &[&str]| picture(&folder, &[words, options].concat());
        let kept = of(&["models.vox", "--keep-instances"]);
        assert!(of(&["models.vox"]) == kept && of(&["models.vxt"]) == kept, "{options:?}");
        if options[0] != "--hide" {
            assert_ne!(of(&["room.vxt"]), kept, "where models end counts: {options:?}");
        }
    }
    // A film says its lines, and goes on with them.
    folder.succeed(&[&["render", "models.vox", "--edges", "--checkpoint", "a.vxf"][..], &SMALL].concat());
    folder.succeed(&["render", "models.vox", "--resume", "a.vxf", "--spp", "6", "-o", "more.png"]);
}

#[test]
fn native_files_hold_who_is_who() {
    let folder = folder();
    folder.succeed(&["convert", "models.vox", "merged.vxt"]);
    folder.succeed(&["convert", "models.vox", "kept.vxt", "--keep-instances"]);
    folder.succeed(&["convert", "merged.vxt", "split.vxt", "--keep-instances"]);
    let of = |name| merged(&folder, &[name]);
    assert_eq!((of("merged.vxt"), of("kept.vxt"), of("split.vxt")), (2, 0, 0));
    assert_eq!(merged(&folder, &["merged.vxt", "--keep-instances"]), 0);
    assert_eq!(folder.bytes("split.vxt"), folder.bytes("kept.vxt"));
    assert_eq!(picture(&folder, &["merged.vxt"]), picture(&folder, &["models.vox"]));
    folder.succeed(&["convert", "merged.vxt", "a.vox"]);
    folder.succeed(&["convert", "kept.vxt", "b.vox"]);
    assert_eq!(folder.bytes("a.vox"), folder.bytes("b.vox"));
}
