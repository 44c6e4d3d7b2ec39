//! `cargo xtask web`: the modules of WebAssembly for pages, each with its half in JavaScript and its types, and the shaders of pages, in `web/wasm/`.
//! `npm run build` in `web/` makes the package of them.

use std::fs;
use std::path::Path;
use std::process::Command;
use wasm_bindgen_cli_support::Bindgen;

const TARGET: &str = "wasm32-unknown-unknown";
/// The modules, and the features of `voxtrace-web` that each has: one traces, `gpu` tells WebGPU what to trace, the others make scenes, `stream` of the parts of a file as they arrive.
const MODULES: [(&str, &str); 5] =
    [("voxtrace", "tracer"), ("gpu", "gpu"), ("stream", "stream"), ("scenes", "scenes"), ("readers", "readers")];

/// What names the shaders among the modules.
const SHADERS: &str = "shaders";

/// Builds all modules and the shaders, or those that are named, and writes what binds them.
pub fn build(names: &[&str]) -> Result<(), String> {
    if let Some(name) = names.iter().find(|name| **name != SHADERS && !MODULES.iter().any(|(known, _)| known == *name))
    {
        let known = MODULES.map(|(name, _)| name).join(", ");
        return Err(format!("there is no module {name:?}; there are {known}, {SHADERS}"));
    }
    if names.is_empty() || names.contains(&SHADERS) {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
        crate::shaders::write_for_pages(&root.join("web/wasm"))?;
    }
    let wanted = MODULES.iter().filter(|(name, _)| names.is_empty() || names.contains(name));
    wanted.into_iter().try_for_each(|(name, features)| build_module(name, features))
}

fn build_module(name: &str, features: &str) -> Result<(), String> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    // A folder of its own: other flags build everything anew.
    let folder = root.join("target/web");
    let cargo = Path::new(env!("CARGO"));
    let status = Command::new(cargo)
        .current_dir(root)
        .args(["build", "--locked", "--profile", "web", "--target", TARGET, "--package", "voxtrace-web", "--lib"])
        .args(["--no-default-features", "--features", features])
        .env("CARGO_TARGET_DIR", &folder)
        .env("RUSTFLAGS", "-C target-feature=+simd128")
        // Else rustup would look for a toolchain in the folder of each library.
        .env("RUSTC", cargo.with_file_name(format!("rustc{}", std::env::consts::EXE_SUFFIX)))
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .status()
        .map_err(|error| error.to_string())?;
    if !status.success() {
        return Err(format!("the module cannot be built; `rustup target add {TARGET}` installs what it is built for"));
    }
    let built = folder.join(TARGET).join("web/voxtrace_web.wasm");
    let bytes = fs::read(&built).map_err(|error| format!("{}: {error}", built.display()))?;
    let mut bindgen = Bindgen::new();
    let bound = bindgen.input_bytes(name, bytes).out_name(name).typescript(true).omit_default_module_path(true);
    let written = bound.web(true).and_then(|bindgen| bindgen.generate(root.join("web/wasm")));
    written.map_err(|error| format!("what binds the module {name} cannot be written: {error:#}"))
}
