//! `cargo xtask dist`: the program as people get it, with manual pages, completions and licences, in an archive named by version
//! and target.

mod archive;
mod third_party;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Files of the repository that lie beside the program.
const PAGES: [&str; 5] = ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-APACHE", "LICENSE-MIT"];

/// Shells, and how each names the file that completes a program.
const COMPLETIONS: [(&str, &str); 5] = [
    ("bash", "voxtrace.bash"),
    ("zsh", "_voxtrace"),
    ("fish", "voxtrace.fish"),
    ("powershell", "_voxtrace.ps1"),
    ("elvish", "voxtrace.elv"),
];

/// Builds and packs the program for this machine.
pub fn pack() -> Result<(), String> {
    let target = host()?;
    run(cargo().args(["build", "--locked", "--profile", "dist", "--package", "voxtrace-cli"]))?;
    let metadata = third_party::metadata(&target)?;
    let folder = PathBuf::from(metadata["target_directory"].as_str().unwrap_or("target")).join("dist");
    let program = folder.join(format!("voxtrace{}", std::env::consts::EXE_SUFFIX));

    let name = format!("voxtrace-{}-{target}", env!("CARGO_PKG_VERSION"));
    let stage = folder.join(&name);
    let _ = fs::remove_dir_all(&stage);
    make_folder(&stage.join("completions"))?;
    copy(&program, &stage)?;
    for page in PAGES {
        copy(&root().join(page), &stage)?;
    }
    write(&stage.join("LICENSES-OF-LIBRARIES.txt"), third_party::licenses(&metadata, "voxtrace-cli")?.as_bytes())?;
    run(Command::new(&program).arg("man").arg(stage.join("man")))?;
    for (shell, file) in COMPLETIONS {
        let output = Command::new(&program).args(["completions", shell]).output().map_err(|error| error.to_string())?;
        write(&stage.join("completions").join(file), &output.stdout)?;
    }

    if !copy_element(&stage.join("web"))? {
        println!("web/dist is not built: without it `voxtrace serve` traces all pictures itself");
    }

    let packed = folder.join(format!("{name}.tar.gz"));
    archive::write(&stage, &name, &packed).map_err(|error| format!("{}: {error}", packed.display()))?;
    let size = |path: &Path| fs::metadata(path).map_or(0, |metadata| metadata.len()) as f64 / 1e6;
    println!("{}: {:.1} MB, the program {:.1} MB", packed.display(), size(&packed), size(&program));
    Ok(())
}

/// Copies the viewer for pages, which `voxtrace serve` looks for beside the program; whether it was built.
fn copy_element(folder: &Path) -> Result<bool, String> {
    let Ok(files) = fs::read_dir(root().join("web/dist")) else { return Ok(false) };
    make_folder(folder)?;
    for file in files.flatten().map(|file| file.path()) {
        if file.extension().is_some_and(|extension| extension == "js" || extension == "wasm") {
            copy(&file, folder)?;
        }
    }
    Ok(true)
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn cargo() -> Command {
    let mut command = Command::new(env!("CARGO"));
    command.current_dir(root());
    command
}

/// The target triple of this machine, as rustc names it.
fn host() -> Result<String, String> {
    let output = Command::new("rustc").arg("-vV").output().map_err(|error| format!("rustc: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines()
        .find_map(|line| line.strip_prefix("host: "))
        .map(str::to_owned)
        .ok_or("rustc does not say its host".into())
}

fn run(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{}: {status}", command.get_program().display())),
        Err(error) => Err(format!("{}: {error}", command.get_program().display())),
    }
}

fn make_folder(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    if bytes.is_empty() {
        return Err(format!("{} would be empty", path.display()));
    }
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}

/// Copies a file into a folder, with its permissions.
fn copy(file: &Path, folder: &Path) -> Result<(), String> {
    let target = folder.join(file.file_name().unwrap_or_default());
    fs::copy(file, target).map(|_| ()).map_err(|error| format!("{}: {error}", file.display()))
}
