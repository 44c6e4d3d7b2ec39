//! Holds that nothing that shaders share with the host is also written by hand: shaders have no numbers of bindings, of specialization
//! constants and of workgroups, and no constant of a name that Rust has a constant of.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Crates with twins of shaders.
const CRATES: [&str; 3] = ["voxtrace-core", "voxtrace-scene", "voxtrace-vulkan"];
/// Part of them that has none: its vectors have constants of their own.
const WITHOUT_TWINS: &str = "crates/voxtrace-core/src/walk/avx512";
/// Attributes of Slang whose first number is shared.
const ATTRIBUTES: [&str; 3] = ["vk::binding(", "vk::constant_id(", "numthreads("];

/// Texts of files by their path relative to the repository's root.
type Texts = BTreeMap<PathBuf, String>;

/// Checks all shaders that are written by hand.
pub fn check(root: &Path) -> Result<(), String> {
    let (shaders, host) = texts(root)?;
    match twice(&shaders, &host)[..] {
        [] => Ok(()),
        ref found => Err(format!(
            "{}: shaders have this by `import generated.shared`, from the table in crates/xtask/src/shaders/shared/table.rs",
            found.join(", ")
        )),
    }
}

/// The shaders that are written by hand, and the Rust files with their twins.
fn texts(root: &Path) -> Result<(Texts, Texts), String> {
    let (mut shaders, mut host) = (Texts::new(), Texts::new());
    for folder in ["shaders", "shaders/pass"] {
        collect(root, Path::new(folder), "slang", false, &mut shaders)?;
    }
    for name in CRATES {
        collect(root, &Path::new("crates").join(name).join("src"), "rs", true, &mut host)?;
    }
    host.retain(|path, _| !path.starts_with(WITHOUT_TWINS));
    Ok((shaders, host))
}

fn collect(root: &Path, folder: &Path, extension: &str, is_deep: bool, texts: &mut Texts) -> Result<(), String> {
    let error = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(root.join(folder)).map_err(error)? {
        let path = folder.join(entry.map_err(error)?.file_name());
        if is_deep && root.join(&path).is_dir() {
            collect(root, &path, extension, is_deep, texts)?;
        } else if path.extension().is_some_and(|other| other == extension) {
            let text = fs::read_to_string(root.join(&path)).map_err(error)?;
            texts.insert(path, text);
        }
    }
    Ok(())
}

/// What shaders write by hand although the host has it, too.
fn twice(shaders: &Texts, host: &Texts) -> Vec<String> {
    let of_host: BTreeSet<&str> = host.values().flat_map(|text| text.lines()).filter_map(host_constant).collect();
    let mut found = Vec::new();
    for (path, text) in shaders {
        for line in text.lines() {
            let name = shader_constant(line).filter(|name| of_host.contains(name));
            let is_numbered = ATTRIBUTES.iter().any(|attribute| {
                let rest = line.split(attribute).nth(1).unwrap_or_default();
                rest.starts_with(|first: char| first.is_ascii_digit())
            });
            if name.is_some() || is_numbered {
                found.push(format!("{}: `{}`", path.display(), line.trim()));
            }
        }
    }
    found
}

/// The name in a line `const NAME: …` of Rust, whatever its visibility.
fn host_constant(line: &str) -> Option<&str> {
    let (before, rest) = line.split_once("const ")?;
    let (name, _) = rest.split_once(':')?;
    let is_name = name.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_');
    (is_name && (before.trim().is_empty() || before.trim_start().starts_with("pub"))).then_some(name)
}

/// The name in a line `static const TYPE NAME = …` of Slang.
fn shader_constant(line: &str) -> Option<&str> {
    line.trim_start().strip_prefix("static const ")?.split_whitespace().nth(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
    }

    #[test]
    fn no_shader_writes_by_hand_what_the_host_has() {
        check(&root()).unwrap();
    }

    #[test]
    fn a_number_and_a_constant_that_are_written_twice_are_seen() {
        let (shaders, host) = texts(&root()).unwrap();
        let with = |file: &str, from: &str, to: &str| {
            let mut changed = shaders.clone();
            let text = changed.get_mut(Path::new(file)).unwrap();
            assert!(text.contains(from), "{file} has {from}");
            *text = text.replacen(from, to, 1);
            twice(&changed, &host)
        };
        let binding = with("shaders/scene.slang", "BINDING_CELLS", "0");
        assert_eq!(binding, ["shaders/scene.slang: `[[vk::binding(0, 0)]] StructuredBuffer<uint> cells;`"]);
        assert_eq!(with("shaders/variant.slang", "CONSTANT_TOP_SHIFT", "3").len(), 1);
        assert_eq!(with("shaders/pass/walk.slang", "numthreads(WORKGROUP", "numthreads(64").len(), 1);
        let constant = with("shaders/film.slang", "import", "static const float MAX_SAMPLE_RADIANCE = 1.0;\nimport");
        assert_eq!(constant, ["shaders/film.slang: `static const float MAX_SAMPLE_RADIANCE = 1.0;`"]);
        assert_eq!(with("shaders/film.slang", "import", "static const float OF_SHADERS = 1.0;\nimport"), [""; 0]);
    }
}
