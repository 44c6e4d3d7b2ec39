//! The pictures of the documentation.

use std::path::Path;
use std::process::Command;

/// Each picture: name of the scene and of the file in `docs/pictures`, and further options of `render`.
const PICTURES: [(&str, &[&str]); 3] = [
    ("church", &["--size", "880x548", "--spp", "400"]),
    ("operating-room", &["--size", "800x500", "--spp", "256"]),
    ("city", &["--size", "800x500", "--spp", "256"]),
];

/// Renders all pictures.
pub fn render() -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/pictures");
    for (scene, options) in PICTURES {
        let status = Command::new(env!("CARGO"))
            .args(["run", "--release", "--package", "voxtrace-cli", "--", "render", scene])
            .args(options)
            .arg("-o")
            .arg(folder.join(scene).with_extension("png"))
            .status();
        if !status.is_ok_and(|status| status.success()) {
            return Err(format!("the picture of {scene} failed"));
        }
    }
    Ok(())
}
