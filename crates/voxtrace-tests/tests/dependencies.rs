//! The library stays free of GPU, window and Python libraries, so that it builds anywhere and embeds into anything.

use std::process::Command;

const FORBIDDEN: [&str; 8] = ["ash", "wgpu", "winit", "egui", "eframe", "pyo3", "gpu-allocator", "voxtrace-vulkan"];

/// The first forbidden package in the output of `cargo tree --prefix none`.
fn forbidden_in(tree: &str) -> Option<&str> {
    tree.lines().filter_map(|line| line.split_whitespace().next()).find(|name| FORBIDDEN.contains(name))
}

#[test]
fn library_depends_on_no_gpu_window_or_python() {
    let output = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--package",
            "voxtrace",
            "--edges",
            "normal",
            "--target",
            "all",
            "--prefix",
            "none",
            "--offline",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    let tree = String::from_utf8(output.stdout).expect("cargo prints UTF-8");
    assert!(tree.contains("glam "), "{tree}{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(forbidden_in(&tree), None);
    assert_eq!(forbidden_in(&format!("{tree}ash v0.38.0+1.3.281\n")), Some("ash"));
}
