//! Chores of the repository: `cargo xtask pictures` renders the pictures of the documentation again.

use std::path::Path;
use std::process::{Command, ExitCode};

/// Name of the scene, and of the picture in `docs/pictures`; more options of `render`.
const PICTURES: [(&str, &[&str]); 3] = [
    ("church", &["--size", "900x560", "--spp", "400"]),
    ("operating-room", &["--size", "800x500", "--spp", "256"]),
    ("city", &["--size", "800x500", "--spp", "256"]),
];

fn main() -> ExitCode {
    match std::env::args().nth(1).as_deref() {
        Some("pictures") => pictures(),
        _ => {
            eprintln!("usage: cargo xtask pictures");
            ExitCode::from(2)
        }
    }
}

fn pictures() -> ExitCode {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/pictures");
    for (scene, options) in PICTURES {
        let status = Command::new(env!("CARGO"))
            .args(["run", "--release", "--package", "voxtrace-cli", "--", "render", scene])
            .args(options)
            .arg("-o")
            .arg(folder.join(scene).with_extension("png"))
            .status();
        if !status.is_ok_and(|status| status.success()) {
            eprintln!("error: the picture of {scene} failed");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
