//! The library stays free of GPU, window and Python libraries, so that it builds anywhere and embeds into anything.

use std::collections::{BTreeMap, BTreeSet};

const FORBIDDEN: [&str; 8] = ["ash", "wgpu", "winit", "egui", "eframe", "pyo3", "gpu-allocator", "voxtrace-vulkan"];

/// Names of the packages that a lock file names directly below each package.
fn dependencies_of(lock: &str) -> BTreeMap<&str, Vec<&str>> {
    lock.split("[[package]]")
        .filter_map(|block| {
            let name = block.lines().find_map(|line| line.strip_prefix("name = "))?.trim_matches('"');
            let list =
                block.split_once("dependencies = [").map_or("", |(_, rest)| rest.split(']').next().unwrap_or(""));
            // An entry is "name" or "name version".
            let names = list.lines().filter_map(|line| line.trim().trim_matches(['"', ',']).split(' ').next());
            Some((name, names.filter(|name| !name.is_empty()).collect()))
        })
        .collect()
}

/// Everything that `package` needs, on any system, for its tests as well.
fn reachable<'a>(lock: &'a str, package: &'a str) -> BTreeSet<&'a str> {
    let dependencies = dependencies_of(lock);
    let (mut seen, mut open) = (BTreeSet::new(), vec![package]);
    while let Some(name) = open.pop() {
        if seen.insert(name) {
            open.extend(dependencies.get(name).into_iter().flatten());
        }
    }
    seen
}

#[test]
fn library_depends_on_no_gpu_window_or_python() {
    let lock = include_str!("../../../Cargo.lock");
    let needed = reachable(lock, "voxtrace");
    assert!(needed.contains("glam") && needed.contains("bytemuck_derive"), "{needed:?}");
    let forbidden = |needed: &BTreeSet<&str>| FORBIDDEN.into_iter().find(|name| needed.contains(name));
    assert_eq!(forbidden(&needed), None);

    let planted = lock.replacen("name = \"glam\"\n", "name = \"glam\"\ndependencies = [\n \"ash 0.38.0\",\n]\n", 1);
    assert_eq!(forbidden(&reachable(&planted, "voxtrace")), Some("ash"));
}
