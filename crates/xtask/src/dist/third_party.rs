//! The licences of the libraries that are compiled into the program: most ask that their text goes where the program goes.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// What `cargo metadata` says about the workspace and all that it needs on a target.
pub fn metadata(target: &str) -> Result<Value, String> {
    let arguments = ["metadata", "--locked", "--format-version", "1", "--filter-platform", target];
    let output = super::cargo().args(arguments).output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("cargo metadata: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

/// Each library with its version and licence, then each licence's text once, with those who are under it.
pub fn licenses(metadata: &Value, package: &str) -> Result<String, String> {
    let mut list = String::from("Libraries in this program, and their licences\n\n");
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for library in compiled_in(metadata, package) {
        let (name, version) = (text(&library["name"]), text(&library["version"]));
        let license = library["license"].as_str().unwrap_or("see below");
        // Those of this project stand in files of their own.
        if library["source"].is_null() {
            continue;
        }
        writeln!(list, "{name} {version}: {license}").map_err(|error| error.to_string())?;
        let folder = Path::new(text(&library["manifest_path"])).parent().unwrap_or(Path::new("."));
        for license_text in license_texts(folder) {
            texts.entry(license_text).or_default().push(format!("{name} {version}"));
        }
    }
    for (license_text, libraries) in texts {
        write!(list, "\n{}\n{}\n\n{license_text}\n", "-".repeat(80), libraries.join(", "))
            .map_err(|error| error.to_string())?;
    }
    Ok(list)
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

fn elements(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// The packages that are compiled into `package`: neither for its tests nor for build scripts alone. Sorted by name.
fn compiled_in<'a>(metadata: &'a Value, package: &str) -> Vec<&'a Value> {
    let packages: BTreeMap<&str, &Value> = elements(&metadata["packages"]).map(|p| (text(&p["id"]), p)).collect();
    let nodes: BTreeMap<&str, &Value> =
        elements(&metadata["resolve"]["nodes"]).map(|node| (text(&node["id"]), node)).collect();
    let start = packages.iter().find(|(_, found)| found["name"] == package).map(|(id, _)| *id);
    let (mut seen, mut open): (BTreeSet<&str>, Vec<&str>) = (BTreeSet::new(), start.into_iter().collect());
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        for dependency in nodes.get(id).into_iter().flat_map(|node| elements(&node["deps"])) {
            // A dependency without a kind is an ordinary one.
            if elements(&dependency["dep_kinds"]).any(|kind| kind["kind"].is_null()) {
                open.push(text(&dependency["pkg"]));
            }
        }
    }
    let mut found: Vec<&Value> = seen.iter().filter_map(|id| packages.get(id).copied()).collect();
    found.sort_by_key(|library| (text(&library["name"]), text(&library["version"])));
    found
}

/// The texts of the files in a library's folder that are named as licences are.
fn license_texts(folder: &Path) -> BTreeSet<String> {
    let is_license = |name: &str| {
        let name = name.to_ascii_uppercase();
        ["LICENSE", "LICENCE", "COPYING", "NOTICE", "COPYRIGHT", "UNLICENSE"].iter().any(|word| name.starts_with(word))
    };
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    files
        .filter(|entry| is_license(&entry.file_name().to_string_lossy()))
        .filter_map(|entry| std::fs::read_to_string(entry.path()).ok())
        .map(|license_text| license_text.replace("\r\n", "\n").trim().to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A program that needs `used`, and `tested` and `built` for tests and build scripts alone.
    fn metadata(folder: &Path) -> Value {
        let package = |name: &str| {
            let manifest = folder.join(name).join("Cargo.toml");
            json!({"id": name, "name": name, "version": "1.0.0", "license": "MIT", "source": "registry",
                   "manifest_path": manifest})
        };
        let dependency = |name: &str, kind: Value| json!({"pkg": name, "dep_kinds": [{"kind": kind}]});
        let deps =
            [dependency("used", Value::Null), dependency("tested", json!("dev")), dependency("built", json!("build"))];
        let packages = ["program", "used", "below", "tested", "built"].map(package);
        let below = [dependency("below", Value::Null)];
        json!({
            "packages": packages,
            "resolve": {"nodes": [
                {"id": "program", "deps": deps},
                {"id": "used", "deps": below},
                {"id": "tested", "deps": below},
            ]},
        })
    }

    #[test]
    fn what_is_compiled_in_is_listed_with_its_text_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["used", "below", "tested"] {
            std::fs::create_dir(folder.path().join(name)).unwrap();
            let owner = if name == "tested" { "another" } else { "somebody" };
            std::fs::write(folder.path().join(name).join("LICENSE-MIT"), format!("by {owner}\r\nas is\n")).unwrap();
            std::fs::write(folder.path().join(name).join("lib.rs"), "no licence").unwrap();
        }
        let said = licenses(&metadata(folder.path()), "program").unwrap();
        assert!(said.contains("used 1.0.0: MIT\n") && said.contains("\nbelow 1.0.0, used 1.0.0\n"), "{said}");
        assert_eq!(said.matches("by somebody\nas is").count(), 1, "{said}");
        assert!(!said.contains("tested") && !said.contains("built") && !said.contains("no licence"), "{said}");
    }
}
