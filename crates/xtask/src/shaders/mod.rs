//! Writes what shaders share with the host, compiles `shaders/pass/*.slang` to SPIR-V and WGSL, validates the results, and keeps all
//! of it committed, so that nobody else needs a shader compiler.

mod compile;
mod layout;
mod minify;
mod passes;
mod roundings;
mod shared;
mod shorten;
mod tools;

use layout::Layout;
use passes::PASSES;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders, relative to the repository's root, whose content is generated.
const GENERATED: [&str; 4] = ["crates/voxtrace-vulkan/spirv", "shaders/wgsl", "shaders/layout", "shaders/generated"];

/// Generated files by their path relative to the repository's root.
type Files = BTreeMap<PathBuf, Vec<u8>>;

/// Regenerates the files.
pub fn generate() -> Result<(), String> {
    let mut files = shared_file(root())?;
    // Passes import it.
    write(&files)?;
    files.extend(compile_all()?);
    for path in committed()?.keys().filter(|path| !files.contains_key(*path)) {
        fs::remove_file(root().join(path)).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    write(&files)?;
    println!("{} files written", files.len());
    Ok(())
}

/// Fails if the committed files differ from those made from the sources.
pub fn check() -> Result<(), String> {
    let committed = committed()?;
    let mut files = shared_file(root())?;
    // Passes import what is committed: where that is stale, so is what they give.
    if files.iter().any(|(path, bytes)| committed.get(path) != Some(bytes)) {
        return Err(stale(&[shared::FILE.to_string()]));
    }
    files.extend(compile_all()?);
    let differences = differences(&files, &committed);
    if !differences.is_empty() {
        return Err(stale(&differences));
    }
    println!("{} generated files are up to date", files.len());
    Ok(())
}

fn stale(paths: &[String]) -> String {
    format!("not what the sources give: {}; run `cargo xtask shaders` and commit", paths.join(", "))
}

fn write(files: &Files) -> Result<(), String> {
    for (path, bytes) in files {
        let path = root().join(path);
        fs::create_dir_all(path.parent().expect("generated files lie in folders"))
            .and_then(|()| fs::write(&path, bytes))
            .map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

/// What shaders share with the host.
fn shared_file(root: &Path) -> Result<Files, String> {
    shared::check_by_hand(root)?;
    let read = |file: &str| fs::read_to_string(root.join("crates").join(file)).map_err(|error| error.to_string());
    Ok(Files::from([(shared::FILE.into(), shared::generate(&read)?.into_bytes())]))
}

/// The order of the modules of pages in their file: films and real-time light of all materials, the steps that trace no rays, real-time light and films of matte things.
/// `web/src/gpu-device.ts` knows it.
const PAGES_ORDER: [usize; 5] = [1, 3, 4, 2, 0];

/// Compiles the shaders of pages to WGSL, made short, in a folder: one file with a line for each module, of films and of real-time light where everything is matte and for all
/// materials, and of the steps that trace no rays. What they have in common is compressed once.
pub fn write_for_pages(folder: &Path) -> Result<(), String> {
    let tools = tools::Tools::fetch(root())?;
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let variants = passes::OF_PAGES.iter().flat_map(|pass| pass.variants.iter().map(move |variant| (pass, variant)));
    let modules = variants.clone().map(|(pass, variant)| compile::wgsl(&tools, pass, variant));
    let modules = minify::minify(&modules.collect::<Result<Vec<_>, _>>()?);
    for (module, (pass, _)) in modules.iter().zip(variants) {
        let entries = compile::wgsl_entries(module).map_err(|error| format!("minified WGSL: {error}"))?;
        compile::check_entries(pass, entries)?;
    }
    // As they are compressed best: what follows finds in those before it what both have.
    let modules = PAGES_ORDER.map(|index| modules[index].as_str());
    let path = folder.join("shaders.wgsl");
    fs::write(&path, modules.join("\n")).map_err(|error| format!("{}: {error}", path.display()))
}

/// Names of the files that differ or that only one side has.
fn differences(generated: &Files, committed: &Files) -> Vec<String> {
    let paths: BTreeSet<&PathBuf> = generated.keys().chain(committed.keys()).collect();
    paths
        .into_iter()
        .filter(|path| generated.get(*path) != committed.get(*path))
        .map(|path| path.display().to_string())
        .collect()
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// Compiles and validates every pass in every variant.
fn compile_all() -> Result<Files, String> {
    passes::check_table(&root().join("shaders/pass"))?;
    let tools = tools::Tools::fetch(root())?;
    let mut files = Files::new();
    let mut layout = Layout::default();
    let [spirv_folder, wgsl_folder, layout_folder, _] = GENERATED.map(Path::new);
    for pass in PASSES {
        for variant in pass.variants {
            let spirv = compile::spirv(&tools, pass, variant)?;
            layout.add(&spirv.reflection).map_err(|error| format!("{}: {error}", pass.name))?;
            files.insert(spirv_folder.join(format!("{}{}.spv", pass.name, variant.suffix)), spirv.words);
        }
        if pass.has_wgsl {
            files.insert(
                wgsl_folder.join(format!("{}.wgsl", pass.name)),
                compile::wgsl(&tools, pass, &pass.variants[0])?.into_bytes(),
            );
        }
    }
    files.insert(layout_folder.join("records.txt"), layout.to_text().into_bytes());
    Ok(files)
}

/// The committed generated files.
fn committed() -> Result<Files, String> {
    let mut files = Files::new();
    for folder in GENERATED {
        let Ok(entries) = fs::read_dir(root().join(folder)) else { continue };
        for entry in entries.flatten() {
            let bytes = fs::read(entry.path()).map_err(|error| format!("{}: {error}", entry.path().display()))?;
            files.insert(Path::new(folder).join(entry.file_name()), bytes);
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_byte_a_missing_and_a_stale_file_are_seen() {
        let generated: Files = [("a", b"1"), ("b", b"2")].map(|(path, bytes)| (path.into(), bytes.to_vec())).into();
        assert!(differences(&generated, &generated).is_empty());
        let mut committed = generated.clone();
        committed.insert("a".into(), b"3".to_vec());
        committed.remove(Path::new("b"));
        committed.insert("c".into(), Vec::new());
        assert_eq!(differences(&generated, &committed), ["a", "b", "c"]);
    }
}
