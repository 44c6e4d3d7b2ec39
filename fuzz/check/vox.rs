//! What must hold for any bytes that are read as a MagicaVoxel file; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::{
    Instance, Scene,
    animation::placed_at,
    export,
    import::{ImportError, Limits, vox, vox::VoxFile},
};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 16, points: 1 << 16, items: 1 << 14, depth: 64, ratio: 200 };

/// Either there is an error that says where, or the document has the bytes it was read from, and its scene comes back
/// from writing and reading as the same scene.
///
/// # Panics
/// If not.
pub fn check(bytes: &[u8]) {
    if let Err(error) = read_and_write(bytes) {
        assert!(error.offset.is_some() || bytes.len() as u64 > LIMITS.bytes, "no offset: {error}");
    }
}

fn read_and_write(bytes: &[u8]) -> Result<(), ImportError> {
    let path = Path::new("checked.vox");
    let file = VoxFile::parse(bytes, path, &LIMITS)?;
    assert!(file.to_bytes().expect("as long as the input") == bytes, "the document lost something");
    let scene = file.to_scene(path, &LIMITS)?;
    let nowhere = Scene { attachments: Vec::new(), ..scene.clone() };
    // With the document that it came from, and as if it came from nowhere.
    let kept = written_and_read(&scene, path);
    assert_eq!(kept.attachments, scene.attachments);
    assert_eq!(kept.groups, scene.groups);
    assert_same(&kept, &scene);
    // Groups are nodes of the document: without it objects stand side by side.
    let mut flat = scene;
    flat.instances.iter_mut().for_each(|instance| instance.group = None);
    assert_same(&written_and_read(&nowhere, path), &flat);
    Ok(())
}

fn written_and_read(scene: &Scene, path: &Path) -> Scene {
    let written = export::vox::document_of(scene).expect("what was read can be written");
    let written = written.to_bytes().expect("small");
    vox::read_bytes(&written, path, &Limits::default()).expect("what was written can be read")
}

fn assert_same(again: &Scene, scene: &Scene) {
    assert!(again.grids == scene.grids, "grids");
    assert_eq!(again.instances.len(), scene.instances.len());
    for (again, instance) in again.instances.iter().zip(&scene.instances) {
        // Models that shrink to their voxels have another middle, which is what key frames move evenly: there are more of them then.
        let still = |of: &Instance| Instance { keyframes: Vec::new(), repeats: None, ..of.clone() };
        assert_eq!(still(again), still(instance));
        assert_eq!(again.keyframes.is_empty(), instance.keyframes.is_empty());
        for key in &instance.keyframes {
            let shown = placed_at(again, f64::from(key.frame));
            assert_eq!(shown, (key.grid, key.world_from_grid), "frame {}", key.frame);
        }
    }
    assert_eq!(again.materials, scene.materials);
    assert_eq!(again.layers, scene.layers);
    assert_eq!(again.cameras, scene.cameras);
    assert_eq!(again.sky, scene.sky);
}
