//! Meshes on the command line: voxelized into files, and on the way in every verb that takes a scene.

use crate::common::{Folder, stderr};
use serde_json::Value;

/// A box of 4 × 2 × 1 with a red floor, and its materials; y is up in the file.
fn write_box(folder: &Folder) {
    let mut text = String::from("mtllib box.mtl\n");
    for corner in 0..8 {
        text += &format!("v {} {} {}\n", 4 * (corner & 1), corner >> 2, -2 * (corner >> 1 & 1));
    }
    text += "usemtl floor\nf 1 3 4 2\nusemtl wall\nf 5 6 8 7\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n";
    std::fs::write(folder.path("box.obj"), text).unwrap();
    std::fs::write(folder.path("box.mtl"), "newmtl floor\nKd 1 0 0\nnewmtl wall\nKd 0.5 0.5 0.5\n").unwrap();
}

#[test]
fn a_mesh_becomes_a_scene_file_of_either_kind() {
    let folder = Folder::new();
    write_box(&folder);
    for out in ["box.vxt", "box.vox"] {
        let written = folder.succeed(&["voxelize", "box.obj", "-o", out, "--resolution", "40"]);
        assert_eq!(written.trim(), out);
        let info = json(&folder.succeed(&["info", out, "--json"]));
        // A shell of 40 × 20 × 10, in two colours and their mixture at the edges.
        assert_eq!(info["voxels"], 8000 - 38 * 18 * 8, "{out}");
        assert_eq!((&info["size"]["x"], &info["size"]["y"], &info["size"]["z"]), (&40.into(), &20.into(), &10.into()));
    }
    folder.succeed(&[
        "voxelize",
        "box.obj",
        "-o",
        "solid.vxt",
        "--resolution",
        "40",
        "--fill",
        "--memory-budget",
        "1MB",
    ]);
    assert_eq!(json(&folder.succeed(&["info", "solid.vxt", "--json"]))["voxels"], 8000);
    folder.succeed(&["voxelize", "box.obj", "-o", "up.vxt", "--voxel-size", "10cm", "--up", "z"]);
    let text = folder.succeed(&["info", "up.vxt"]);
    assert!(text.contains("40 x 10 x 20 voxels of 0.1 m: 4.0 x 1.0 x 2.0 m"), "{text}");
    folder.succeed(&[
        "voxelize",
        "box.obj",
        "-o",
        "one.vxt",
        "--resolution",
        "40",
        "--palette",
        "1",
        "--surface",
        "thin",
    ]);
    assert_eq!(json(&folder.succeed(&["info", "one.vxt", "--json"]))["materials"], 1);
}

#[test]
fn every_verb_that_takes_a_scene_takes_a_mesh() {
    let folder = Folder::new();
    write_box(&folder);
    folder.succeed(&["render", "box.obj", "-o", "box.png", "--size", "32x24", "--spp", "1", "--resolution", "20"]);
    assert!(folder.exists("box.png"));
    let info = json(&folder.succeed(&["info", "box.obj", "--json", "--resolution", "20", "--up-axis", "-z"]));
    assert_eq!((&info["size"]["y"], &info["size"]["z"]), (&5.into(), &10.into()));
    folder.succeed(&["convert", "box.obj", "box.vox", "--resolution", "20"]);
    assert!(folder.exists("box.vox"));
}

#[test]
fn what_cannot_be_voxelized_is_explained() {
    let folder = Folder::new();
    write_box(&folder);
    std::fs::write(folder.path("empty.obj"), "# nothing\n").unwrap();
    for (arguments, code, expected) in [
        (&["voxelize", "box.obj", "-o", "a.png"][..], 2, ".vxt or .vox"),
        (&["voxelize", "box.obj"], 2, "--output"),
        (&["voxelize", "none.obj", "-o", "a.vxt"], 3, "cannot read none.obj"),
        (&["voxelize", "empty.obj", "-o", "a.vxt"], 3, "without a face"),
        (&["voxelize", "box.obj", "-o", "a.vxt", "--voxel-size", "0.00001"], 2, "voxel"),
        (&["voxelize", "box.obj", "-o", "a.vxt", "--voxel-size", "1furlong"], 2, "unit"),
        (&["voxelize", "box.obj", "-o", "a.vxt", "--resolution", "5", "--voxel-size", "1"], 2, "--voxel-size"),
        (&["voxelize", "box.obj", "-o", "no/a.vxt"], 4, "folder"),
    ] {
        let line = folder.fail(arguments, code);
        assert!(line.contains(expected), "{arguments:?}: {line}");
    }
    assert!(!folder.exists("a.vxt"));
}

#[test]
fn what_a_mesh_lacks_is_said_and_long_work_is_announced() {
    let folder = Folder::new();
    write_box(&folder);
    std::fs::remove_file(folder.path("box.mtl")).unwrap();
    let errors = folder.run(&["voxelize", "box.obj", "-o", "box.vxt", "--resolution", "64"]);
    let errors = stderr(&errors);
    assert!(
        errors.contains("warning: box.obj: materials are left out") && errors.contains("64 x 32 x 16 voxels"),
        "{errors}"
    );
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_unit_of_the_file_and_one_of_the_voxels_are_told_apart() {
    let folder = Folder::new();
    write_box(&folder);
    let size = |options: &[&str]| {
        folder.succeed(&[&["voxelize", "box.obj", "-o", "unit.vxt"], options].concat());
        let text = folder.succeed(&["info", "unit.vxt"]);
        text.lines().find_map(|line| line.strip_prefix("size")).unwrap().trim().to_owned()
    };
    // A box of 4 x 2 x 1.
    assert_eq!(size(&["--unit", "ft", "--voxel-size", "0.5"]), "8 x 4 x 2 voxels of 0.1524 m: 1.2 x 0.6 x 0.3 m");
    assert_eq!(size(&["--unit", "ft", "--voxel-size", "0.5ft"]), size(&["--unit", "ft", "--voxel-size", "0.5"]));
    assert_eq!(size(&["--unit", "cm", "--voxel-size", "1mm"]), "40 x 20 x 10 voxels of 0.001 m: 0.0 x 0.0 x 0.0 m");
    assert_eq!(
        size(&["--unit", "km", "--voxel-size", "100m"]),
        "40 x 20 x 10 voxels of 100 m: 4000.0 x 2000.0 x 1000.0 m"
    );
    assert_eq!(size(&["--unit", "us-ft", "--resolution", "4"]), "4 x 2 x 1 voxels of 0.3048006 m: 1.2 x 0.6 x 0.3 m");
    assert_eq!(size(&["--voxel-size", "1ft"]), "14 x 7 x 4 voxels of 0.3048 m: 4.3 x 2.1 x 1.2 m");
    for wrong in [["--unit", "yd"], ["--voxel-size", "2yd"]] {
        let message = folder.fail(&[&["voxelize", "box.obj", "-o", "unit.vxt"], &wrong[..]].concat(), 2);
        assert!(message.contains("is no unit of length; m, mm, cm, km, ft, us-ft are"), "{message}");
    }
    // A cloud and a volume are scaled as a mesh is.
    std::fs::write(folder.path("a.xyz"), "0 0 0\n10 0 0\n0 10 0\n").unwrap();
    let text = folder.succeed(&["info", "a.xyz", "--unit", "ft", "--voxel-size", "1ft"]);
    assert!(text.contains("11 x 11 x 1 voxels of 0.3048 m"), "{text}");
    std::fs::write(folder.path("a.raw"), [9u8; 24]).unwrap();
    let raw = ["info", "a.raw", "--raw-shape", "4x3x2:u8", "--transfer", "surface", "--threshold", "1"];
    let text = folder.succeed(&[&raw[..], &["--unit", "cm", "--spacing", "2"]].concat());
    assert!(text.contains("4 x 3 x 2 voxels of 0.02 m"), "{text}");
    let text = folder.succeed(&[&raw[..], &["--unit", "cm", "--spacing", "2", "--voxel-size", "1"]].concat());
    assert!(text.contains("8 x 6 x 4 voxels of 0.01 m"), "{text}");
}

/// A command of `tiles`.
fn tiles<'a>(stage: &[&'a str]) -> Vec<&'a str> {
    [&["tiles"], stage].concat()
}

#[test]
fn meshes_of_one_name_and_different_units_are_told_by_their_paths() {
    let folder = Folder::new();
    for path in ["a/s.glb", "b/s.glb", "c/s.obj"] {
        std::fs::create_dir(folder.path(&path[..1])).unwrap();
        folder.succeed(&["convert", "room.vox", path, "-q"]);
    }
    // glTF is in metres, and OBJ says no unit.
    let all = ["a/s.glb", "b/s.glb", "c/s.obj"];
    let expected = "error: c/s.obj: this mesh and a/s.glb have different units; hint: --unit says";
    let large = ["-o", "t.vxt", "--resolution", "30", "--memory-budget", "1"];
    for arguments in [
        [&["info"], &all[..], &["--resolution", "30"]].concat(),
        [&["voxelize"], &all[..], &large[..4]].concat(),
        [&["voxelize"], &all[..], &large[..]].concat(),
    ] {
        let said = folder.fail(&arguments, 3);
        assert!(said.starts_with(expected), "{arguments:?}: {said}");
        assert!(!folder.exists("t.vxt"), "{arguments:?}");
    }
    folder.succeed(&[&["voxelize"], &all[..], &large[..], &["--unit", "m"]].concat());
    // Processes that know some of the files each.
    for (file, found) in [("0..1", "0.found"), ("1..3", "1.found")] {
        folder.succeed(&tiles(&[&["survey"], &all[..], &["--files", file, "-o", found]].concat()));
    }
    folder.succeed(&tiles(&["join", "0.found", "1.found", "-o", "all.found"]));
    let part = [&["voxelize"], &all[..], &["--survey", "all.found", "--share", "0/2", "-o", "0.part"]].concat();
    let said = folder.fail(&tiles(&part), 3);
    assert!(said.starts_with(expected), "{said}");
}
