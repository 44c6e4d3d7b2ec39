//! A map of Ace of Spades that the game server piqueserver has written, read by the importer; skipped where no Python has it.

use crate::written::Written;
use std::collections::BTreeMap;
use voxtrace::import::{self, ImportOptions};
use voxtrace::material::srgb_from_linear;

static WRITTEN: Written = Written::by("voxlap.py", "piqueserver");

/// A voxel by its place in the file.
type Voxels = BTreeMap<[i32; 3], [u8; 3]>;

#[test]
fn a_map_of_piqueserver_has_the_blocks_that_it_shows_from_above_and_from_below() {
    let Some(folder) = WRITTEN.folder() else { return };
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let listed: Vec<[i32; 6]> = serde_json::from_str(&text).unwrap();
    let wanted: Voxels = listed.iter().map(|&[x, y, z, r, g, b]| ([x, y, z], [r, g, b].map(|c| c as u8))).collect();
    assert!(wanted.len() > 2500, "{}", wanted.len());

    let scene = import::open(&folder.join("map.vxl"), &ImportOptions::default()).unwrap();
    let color = |material: u16| scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
    // The file has z down and y to the viewer.
    let voxels = scene.grids[0].voxels();
    let found: Voxels = voxels.map(|(at, material)| ([at.x, 511 - at.y, 63 - at.z], color(material))).collect();
    assert!(found == wanted, "{} voxels, {} are right", found.len(), wanted.len());
    // A block that stands elsewhere is told.
    let moved: Voxels = found.iter().map(|(&[x, y, z], &color)| ([x, y, 63 - z], color)).collect();
    assert!(moved != wanted);
}
