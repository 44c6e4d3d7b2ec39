//! Tiles of a scan on the command line: folders and several files as one cloud, parts of it by class and place, and what is said
//! where that cannot be.

use crate::common::Folder;
use serde_json::Value;

/// A LAS file of points a metre apart, 8 by 8, from a place on; each row has a class of its own, 1 to 8.
fn las([x, y]: [i32; 2]) -> Vec<u8> {
    let mut bytes = vec![0; 227];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &227u16.to_le_bytes());
    put(96, &227u32.to_le_bytes());
    put(105, &20u16.to_le_bytes());
    put(107, &64u32.to_le_bytes());
    (0..3).for_each(|axis| put(131 + 8 * axis, &1f64.to_le_bytes()));
    for (axis, low) in [f64::from(x), f64::from(y), 0.0].into_iter().enumerate() {
        put(179 + 16 * axis, &[low + if axis < 2 { 7.0 } else { 0.0 }, low].map(f64::to_le_bytes).concat());
    }
    for at in 0..64 {
        let mut record = [0; 20];
        record[..8].copy_from_slice([x + at % 8, y + at / 8].map(i32::to_le_bytes).as_flattened());
        record[15] = 1 + (at / 8) as u8;
        bytes.extend(record);
    }
    bytes
}

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("tiles")).unwrap();
    for (name, place) in [("tiles/west.las", [100, 50]), ("tiles/east.las", [108, 50])] {
        std::fs::write(folder.path(name), las(place)).unwrap();
    }
    folder
}

fn voxels(folder: &Folder, arguments: &[&str]) -> u64 {
    let text = folder.succeed(&[&["info", "--json", "--voxel-size", "1m"], arguments].concat());
    serde_json::from_str::<Value>(&text).unwrap()["voxels"].as_u64().unwrap()
}

#[test]
fn a_folder_and_its_files_are_one_cloud_of_which_classes_and_boxes_choose() {
    let folder = folder();
    assert_eq!(voxels(&folder, &["tiles"]), 128);
    assert_eq!(voxels(&folder, &["tiles", "--classes", "ground,6"]), 32);
    assert_eq!(voxels(&folder, &["tiles", "--bounds", "106,-1e6,109,51"]), 8);
    assert_eq!(voxels(&folder, &["tiles", "--bounds", "106,50,-1,109,51,1", "--classes=2"]), 4);
    for budget in [&[][..], &["--memory-budget", "1kB"]] {
        let inputs = ["voxelize", "tiles/west.las", "tiles/east.las", "-o", "out.vxt", "--voxel-size", "1m"];
        folder.succeed(&[&inputs[..], &["--classes", "2"], budget].concat());
        assert_eq!(voxels(&folder, &["out.vxt"]), 16, "{budget:?}");
        std::fs::remove_file(folder.path("out.vxt")).unwrap();
    }
    folder.succeed(&["render", "tiles", "-o", "out.png", "--size", "32x18", "--spp", "1"]);
}

#[test]
fn what_cannot_be_chosen_or_joined_is_one_line_that_says_why() {
    let folder = folder();
    std::fs::write(folder.path("box.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    for (arguments, code, wanted) in [
        (&["info", "tiles", "--bounds", "0,0,1,1"][..], 3, "they lie in the box 100,50,0,115,57,0"),
        (&["info", "tiles", "--classes", "30"], 3, "are of the classes 1, 2, 3, 4, 5, 6, 7, 8"),
        (&["info", "box.obj", "--classes", "2"], 2, "--classes chooses among points"),
        (&["info", "city", "--bounds", "0,0,1,1"], 2, "--bounds chooses among points"),
        (&["info", "tiles", "--classes", "house"], 2, "is no class: classes are numbers from 0 to 255, or"),
        (&["info", "tiles", "--bounds", "0,0,0,1"], 2, "is empty"),
        (
            &["voxelize", "tiles", "box.obj", "-o", "a.vxt"],
            3,
            "box.obj: several files are read as one only where all are LAS",
        ),
    ] {
        let error = folder.fail(arguments, code);
        assert!(error.contains(wanted) && error.trim().lines().count() <= 3, "{arguments:?}: {error}");
    }
}
