//! What benchmarks of pictures share: the scenes, kept packed, and the choice of a device.

use std::error::Error;
use std::path::{Path, PathBuf};
use voxtrace::{PackedScene, Scene};
use voxtrace_tests::still_lifes;

pub type Outcome<T> = Result<T, Box<dyn Error>>;

/// What renders.
#[derive(clap::Args)]
pub struct DeviceArgs {
    /// Renders on the device of this number or name, with the same bits as the processor
    #[arg(long)]
    pub device: Option<String>,
    /// The pictures of many samples by the device's quick shaders, whose last digits differ
    #[arg(long, requires = "device")]
    pub fast: bool,
    // What `cargo bench` says.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The file of a built-in scene or a still life, packed into `folder` where it is not there yet.
pub fn packed_scene(folder: &Path, name: &str, voxels: Option<u64>) -> Outcome<PathBuf> {
    packed_scene_with(folder, (name, ""), voxels, |_| Ok(()))
}

/// The same with what `add` adds; `suffix` tells the file from that of the scene alone.
pub fn packed_scene_with(
    folder: &Path,
    (name, suffix): (&str, &str),
    voxels: Option<u64>,
    add: impl FnOnce(&mut Scene) -> Outcome<()>,
) -> Outcome<PathBuf> {
    let path = folder.join(format!("{name}{suffix}-{}.vxt", voxels.unwrap_or(0)));
    if !path.exists() {
        let mut scene = match still_lifes::scene(name) {
            Some(scene) => scene,
            None => voxtrace::scenes::generate(name, voxels)?,
        };
        add(&mut scene)?;
        PackedScene::pack(&scene)?.save(&path)?;
    }
    Ok(path)
}
