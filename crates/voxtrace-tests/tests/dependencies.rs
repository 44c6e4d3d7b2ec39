//! The crates are layered, and the tracing crates depend on no file format, GPU, window or Python, so that they build anywhere.

use std::collections::{BTreeMap, BTreeSet};

/// The layers of the crates, lowest first: a crate may depend on crates of lower layers only.
const LAYERS: &[&[&str]] = &[
    &["voxtrace-serial"],
    &["voxtrace-oidn", "voxtrace-scene", "voxtrace-test-support"],
    &["voxtrace-core"],
    &["voxtrace-voxelize", "voxtrace-scenes", "voxtrace-realtime"],
    &["voxtrace-io", "voxtrace-vulkan"],
    &["voxtrace"],
    &["voxtrace-bench", "voxtrace-py", "voxtrace-serve", "voxtrace-web"],
    &["voxtrace-viewer"],
    &["voxtrace-cli"],
    &["voxtrace-tests", "xtask"],
];

/// Packages that the library must not depend on.
const FORBIDDEN: [&str; 8] = ["ash", "wgpu", "winit", "egui", "eframe", "pyo3", "gpu-allocator", "voxtrace-vulkan"];
/// Packages that the tracer must not depend on: decoders of file formats.
const FORMATS: [&str; 7] = ["draco-core", "laz", "tiff", "png", "exr", "e57", "serde_json"];

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

/// The manifests of the crates by their names.
fn manifests() -> BTreeMap<String, String> {
    let crates = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = std::fs::read_dir(crates).unwrap().map(|entry| entry.unwrap().path());
    let manifests = folders.filter_map(|folder| {
        let text = std::fs::read_to_string(folder.join("Cargo.toml")).ok()?;
        Some((folder.file_name()?.to_str()?.to_owned(), text))
    });
    manifests.collect()
}

/// The packages that a manifest names, on whatever system, but not for tests.
fn needs(manifest: &str) -> impl Iterator<Item = &str> {
    let sections = manifest.split("\n[").filter(|section| {
        let heading = section.lines().next().unwrap_or_default();
        heading.ends_with("dependencies]") && !heading.ends_with("dev-dependencies]")
    });
    let lines = sections.flat_map(|section| section.lines().skip(1)).filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split(['.', ' ', '=']).next()).filter(|name| !name.is_empty())
}

/// Dependencies of a crate on one that is not in a lower layer.
fn upward_dependencies(manifests: &BTreeMap<String, String>) -> Vec<(String, String)> {
    let layer = |name: &str| LAYERS.iter().position(|layer| layer.contains(&name));
    let dependencies = manifests.iter().flat_map(|(from, text)| needs(text).map(move |to| (from.as_str(), to)));
    let ours = dependencies.filter(|(_, to)| manifests.contains_key(*to));
    ours.filter(|(from, to)| layer(to) >= layer(from)).map(|(from, to)| (from.to_owned(), to.to_owned())).collect()
}

/// Everything that `package` needs, on any system, but not for its tests: those of our crates are left out by their manifests.
fn reachable<'a>(lock: &'a str, manifests: &'a BTreeMap<String, String>, package: &'a str) -> BTreeSet<&'a str> {
    let dependencies = dependencies_of(lock);
    let (mut seen, mut open) = (BTreeSet::new(), vec![package]);
    while let Some(name) = open.pop() {
        if !seen.insert(name) {
            continue;
        }
        match manifests.get(name) {
            Some(manifest) => open.extend(needs(manifest)),
            None => open.extend(dependencies.get(name).into_iter().flatten()),
        }
    }
    seen
}

#[test]
fn every_crate_has_a_layer_and_depends_on_lower_layers_only() {
    let mut manifests = manifests();
    for name in manifests.keys() {
        assert!(LAYERS.iter().flat_map(|layer| *layer).any(|known| known == name), "{name} is in no layer");
    }
    assert_eq!(upward_dependencies(&manifests), []);
    let of_core: Vec<&str> = needs(&manifests["voxtrace-core"]).collect();
    assert!(["voxtrace-scene", "flate2", "voxtrace-serial"].iter().all(|name| of_core.contains(name)), "{of_core:?}");
    assert!(!of_core.contains(&"tempfile"), "those of tests are not");

    let scene = manifests.get_mut("voxtrace-scene").unwrap();
    *scene = scene.replacen("\n[dependencies]\n", "\n[dependencies]\nvoxtrace-io.workspace = true\n", 1);
    assert_eq!(upward_dependencies(&manifests), [("voxtrace-scene".to_owned(), "voxtrace-io".to_owned())]);
}

/// Crates that turn on the feature with planted errors, for more than their own tests.
fn plant_errors(manifests: &BTreeMap<String, String>) -> Vec<&str> {
    let plants = |text: &str| {
        let (_, rest) = text.split_once("\n[dependencies]")?;
        let sections = rest.split("\n[").filter(|section| !section.starts_with("dev-dependencies]"));
        Some(sections.into_iter().any(|section| section.contains("\"faults\"")))
    };
    let plant = manifests.iter().filter(|(_, text)| plants(text) == Some(true));
    plant.map(|(name, _)| name.as_str()).collect()
}

#[test]
fn planted_errors_are_built_into_tests_alone() {
    let mut manifests = manifests();
    assert!(manifests["voxtrace-vulkan"].contains("\nfaults = []\n"));
    assert_eq!(plant_errors(&manifests), ["voxtrace-tests"]);
    let program = manifests.get_mut("voxtrace-cli").unwrap();
    *program = program.replacen(
        "voxtrace-vulkan.workspace = true",
        "voxtrace-vulkan = { workspace = true, features = [\"faults\"] }",
        1,
    );
    assert_eq!(plant_errors(&manifests), ["voxtrace-cli", "voxtrace-tests"]);
}

#[test]
fn library_depends_on_no_gpu_window_or_python_and_the_tracer_on_no_file_format() {
    let lock = include_str!("../../../Cargo.lock");
    let manifests = manifests();
    let needed = reachable(lock, &manifests, "voxtrace");
    assert!(needed.contains("glam") && needed.contains("bytemuck_derive"), "{needed:?}");
    let first = |needed: &BTreeSet<&str>, names: &[&'static str]| names.iter().copied().find(|n| needed.contains(n));
    assert_eq!(first(&needed, &FORBIDDEN), None);
    assert!(FORMATS.iter().all(|name| needed.contains(name)), "{needed:?}");
    let core = reachable(lock, &manifests, "voxtrace-core");
    assert_eq!(first(&core, &FORMATS), None);
    assert!(core.len() <= 40, "{} packages: {core:?}", core.len());

    let planted = lock.replacen("name = \"glam\"\n", "name = \"glam\"\ndependencies = [\n \"ash 0.38.0\",\n]\n", 1);
    assert_eq!(first(&reachable(&planted, &manifests, "voxtrace"), &FORBIDDEN), Some("ash"));
}
