//! Native files that no voxtrace wrote, for tests, with the checksums that a malicious writer would mend.

use super::checksums::{mend, section, table};
use voxtrace::glam::Vec3;
use voxtrace::{Instance, Material, PackedScene, Scene, Transform, VoxelGrid};

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
