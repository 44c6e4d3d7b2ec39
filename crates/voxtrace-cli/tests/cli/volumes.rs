//! Volumes on the command line: voxelized into files, and on the way in every verb that takes a scene.

use crate::common::{Folder, SMALL, stderr};

/// A block of 3 × 4 × 2 samples of 700 in a volume of 6 × 8 × 4, 2 mm apart.
fn write_block(folder: &Folder) {
    let header =
        "NDims = 3\nDimSize = 6 8 4\nElementType = MET_SHORT\nElementSpacing = 2 2 2\nElementDataFile = block.raw\n";
    std::fs::write(folder.path("block.mhd"), header).unwrap();
    let value = |n: usize| {
        let (x, y, z) = (n % 6, n / 6 % 8, n / 48);
        if (1..4).contains(&x) && (2..6).contains(&y) && (1..3).contains(&z) { 700i16 } else { -1000 }
    };
    let bytes: Vec<u8> = (0..6 * 8 * 4).flat_map(|n| value(n).to_le_bytes()).collect();
    std::fs::write(folder.path("block.raw"), bytes).unwrap();
}

#[test]
fn every_verb_that_takes_a_scene_takes_a_volume() {
    let folder = Folder::new();
    write_block(&folder);
    let text = folder.succeed(&["info", "block.mhd", "--transfer", "ct-bone"]);
    assert!(text.contains("3 x 4 x 2 voxels of 2 mm"), "{text}");
    folder.succeed(&[&["render", "block.mhd", "--transfer", "ct-skin", "-o", "block.png"], &SMALL[..]].concat());
    assert!(folder.path("block.png").is_file());
    folder.succeed(&["voxelize", "block.mhd", "-o", "block.vxt", "--transfer", "ct-bone"]);
    assert_eq!(folder.succeed(&["info", "block.vxt"]), text.replace("block.mhd", "block.vxt"));
    let output = folder.run(&["info", "block.mhd", "--transfer", "ct-bone", "--threshold", "900"]);
    assert!(stderr(&output).contains("no sample is to be seen"), "{}", stderr(&output));
}
