//! Gathers the languages of the window: each file `src/strings/LANGUAGE.toml` is one, and adding a language is adding its file.

use std::fmt::Write;
use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=src/strings");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/strings");
    let files = std::fs::read_dir(&folder).expect("the folder of languages");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file of a language").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    let mut code = String::from("&[\n");
    for path in paths {
        let name = path.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        writeln!(code, "    ({name:?}, include_str!({:?})),", path.display().to_string()).expect("memory takes it");
    }
    code.push_str("]\n");
    let out = std::env::var_os("OUT_DIR").expect("cargo says where");
    std::fs::write(Path::new(&out).join("languages.rs"), code).expect("the folder can be written");
}
