//! Any file becomes a picture: `cargo run --release --example import -- castle.vox castle.png`. Without a file a mesh is
//! written first and read again.

use std::path::PathBuf;
use voxtrace::Renderer;
use voxtrace::import::{self, ImportOptions};
use voxtrace::voxelize::{Scale, VoxelizeOptions};

/// An octahedron with coloured corners, as OBJ.
const OBJ: &str = "
v 1 0 0 0.9 0.3 0.2\nv -1 0 0 0.2 0.5 0.9\nv 0 1 0 0.9 0.8 0.3\nv 0 -1 0 0.3 0.8 0.4\nv 0 0 1 0.8 0.3 0.8\nv 0 0 -1 0.9 0.9 0.9
f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6
";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let (file, picture) = match (arguments.next(), arguments.next()) {
        (Some(file), Some(picture)) => (PathBuf::from(file), picture),
        (picture, _) => {
            let file = std::env::temp_dir().join(format!("voxtrace-example-{}.obj", std::process::id()));
            std::fs::write(&file, OBJ)?;
            (file, picture.unwrap_or("import.png".into()))
        }
    };
    let voxelize = VoxelizeOptions { scale: Scale::Resolution(128), ..VoxelizeOptions::default() };
    let options = ImportOptions { voxelize, ..ImportOptions::default() };
    let scene = import::open(&file, &options)?;
    Renderer::new(&scene)?.size(480, 360).samples(32).render()?.save(&picture)?;
    println!("{picture}: {} grids, {} materials", scene.grids.len(), scene.materials.len());
    Ok(())
}
