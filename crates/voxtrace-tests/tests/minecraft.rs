//! A build that other programs' libraries have written in every format, read by the importers. Needs a Python with mcschematic,
//! litemapy, nbtlib and anvil-parser, else it is skipped.

mod written;

use std::collections::BTreeMap;
use std::path::Path;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, BlockOptions, BlockSize, ImportOptions};
use voxtrace::material::srgb_from_linear;
use written::Written;

static WRITTEN: Written = Written::by("builds.py", "mcschematic, litemapy, nbtlib and anvil-parser");

static COTTAGE: Written = Written::by("cottage.py", "mcschematic");

/// The voxels of a file from their lowest corner on, with their colours.
fn voxels(path: &Path) -> BTreeMap<[i32; 3], [u8; 3]> {
    let voxels = import::read_voxels(path, &ImportOptions::default()).unwrap();
    assert_eq!(voxels.notes, [] as [String; 0]);
    let scene = voxels.scene;
    let placed: Vec<(IVec3, [u8; 3])> = scene
        .instances
        .iter()
        .flat_map(|instance| scene.grids[instance.grid].voxels().map(move |voxel| (instance, voxel)))
        .map(|(instance, (voxel, material))| {
            let place = instance.world_from_grid.point(voxel.as_vec3() + 0.5).floor().as_ivec3();
            (place, scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear))
        })
        .collect();
    let min = placed.iter().fold(IVec3::MAX, |min, (at, _)| min.min(*at));
    placed.into_iter().map(|(at, color)| ((at - min).to_array(), color)).collect()
}

#[test]
fn known_blocks_are_at_known_places_in_the_files_of_four_libraries() {
    let Some(folder) = WRITTEN.folder() else { return };
    // The script's blocks; its z goes south, our y north.
    let (stone, wool, gold, lamp, planks) =
        ([0x7d; 3], [0xa1, 0x27, 0x22], [0xf6, 0xd0, 0x3d], [0xff, 0xd9, 0x8c], [0xa2, 0x83, 0x4f]);
    let mut wanted: BTreeMap<[i32; 3], [u8; 3]> = (0..24).map(|i| ([i % 6, i / 6, 0], stone)).collect();
    wanted.extend([([5, 3, 1], wool), ([0, 0, 1], gold), ([2, 2, 1], lamp)]);
    wanted.extend((1..5).map(|z| ([0, 3, z], planks)));
    for name in ["build.schem", "build.litematic", "negative.litematic", "build.schematic", "r.0.0.mca"] {
        assert_eq!(voxels(&folder.join(name)), wanted, "{name}");
    }
}

#[test]
fn the_cottage_of_the_documentation_has_blocks_with_colours_alone() {
    let Some(folder) = COTTAGE.folder() else { return };
    let blocks = BlockOptions { size: BlockSize::Sixteen, ..BlockOptions::default() };
    let options = ImportOptions { blocks, ..ImportOptions::default() };
    let voxels = import::read_voxels(&folder.join("cottage.schem"), &options).unwrap();
    assert_eq!(voxels.notes, [] as [String; 0]);
    let count = voxels.scene.grids[0].count();
    assert!((500_000..1_500_000).contains(&count), "{count}");
}
