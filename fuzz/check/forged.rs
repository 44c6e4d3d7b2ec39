//! Native files that no voxtrace wrote, with the checksums that a malicious writer would mend.

use std::ops::Range;
use voxtrace::glam::Vec3;
use voxtrace::{Instance, Material, PackedScene, Scene, Transform, VoxelGrid};
use xxhash_rust::xxh3::xxh3_64;

/// Bytes of a node of the hierarchy over instances.
const NODE: usize = 32;

/// A file of `levels` + 1 instances whose hierarchy is a chain of so many inner nodes, each with an instance to its right. All
/// boxes are that of the whole scene, so that walks meet both children of every node and go left first: their stacks get as
/// full as they can. Also the scene that was packed, whose own hierarchy halves the instances.
pub fn chain(levels: usize) -> (Vec<u8>, PackedScene) {
    let mut grid = VoxelGrid::new();
    for (at, material) in [([0, 0, 0], 0), ([1, 0, 0], 1), ([2, 3, 1], 0)] {
        grid.set(at.into(), material);
    }
    let materials = vec![Material::diffuse(Vec3::splat(0.8)), Material::emissive(Vec3::ONE)];
    let mut scene = Scene::from_grid("chain", grid, materials);
    for instance in 1..=levels {
        let place =
            Vec3::new((instance % 4) as f32 * 5.0, (instance / 4 % 4) as f32 * 4.5, (instance / 16) as f32 * 3.0);
        scene.instances.push(Instance::new(0, Transform::from_translation(place)));
    }
    let packed = PackedScene::pack(&scene).expect("the scene is sound");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("chain.vxt");
    packed.save(&path).expect("a file");
    let mut bytes = std::fs::read(&path).expect("the file");
    forge(&mut bytes, b"INOD", |nodes| {
        let count = nodes.len() / NODE;
        let root = nodes[..NODE].to_vec();
        for (index, node) in nodes.chunks_exact_mut(NODE).enumerate() {
            let is_leaf = index >= levels;
            let number = if is_leaf { index - levels } else { count - 1 - index };
            node.copy_from_slice(&root);
            node[12..16].copy_from_slice(&(number as u32).to_le_bytes());
            node[28..32].copy_from_slice(&u32::from(is_leaf).to_le_bytes());
        }
    });
    (bytes, packed)
}

/// Changes the bytes of a section, and mends the checksums.
///
/// # Panics
/// If the file has no such section.
pub fn forge(bytes: &mut [u8], tag: &[u8; 4], change: impl FnOnce(&mut [u8])) {
    let entry = table(bytes).step_by(32).find(|&at| bytes[at..at + 4] == *tag).expect("the section exists");
    let section = section(bytes, entry).expect("the section lies in the file");
    change(&mut bytes[section]);
    mend(bytes);
}

/// Writes the checksums that the sections and their table have, as far as they lie in the file.
pub fn mend(bytes: &mut [u8]) {
    if bytes.len() < 64 {
        return;
    }
    let table = table(bytes);
    for entry in table.clone().step_by(32) {
        let Some(sum) = section(bytes, entry).map(|section| xxh3_64(&bytes[section])) else { continue };
        if let Some(place) = bytes.get_mut(entry + 24..entry + 32) {
            place.copy_from_slice(&sum.to_le_bytes());
        }
    }
    if let Some(sum) = bytes.get(table).map(xxh3_64) {
        bytes[16..24].copy_from_slice(&sum.to_le_bytes());
    }
}

/// Where the section table lies; of one that is longer than the file, about as much as fits.
fn table(bytes: &[u8]) -> Range<usize> {
    let count = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    64..64 + 32 * count.min(bytes.len() / 32)
}

/// Where the section with an entry lies, if that is in the file.
fn section(bytes: &[u8], entry: usize) -> Option<Range<usize>> {
    let number = |at: usize| usize::try_from(u64::from_le_bytes(*bytes.get(at..at + 8)?.first_chunk()?)).ok();
    let (start, size) = (number(entry + 8)?, number(entry + 16)?);
    let section = start..start.checked_add(size)?;
    bytes.get(section.clone()).map(|_| section)
}
