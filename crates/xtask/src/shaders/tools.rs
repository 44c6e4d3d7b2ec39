//! The shader compiler and the SPIR-V validator, pinned by version and hash in `shaders/requirements.txt`. pip fetches, verifies and
//! unpacks them. They run on Linux with x86-64 only; the compiled shaders are committed, so nobody else needs them.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Paths of the tools.
pub struct Tools {
    root: PathBuf,
    folder: PathBuf,
}

impl Tools {
    /// Fetches the tools into `target/slang`, unless they are there already.
    pub fn fetch(root: &Path) -> Result<Self, String> {
        let tools = Self { root: root.to_path_buf(), folder: root.join("target/slang") };
        let wanted = root.join("shaders/requirements.txt");
        // The list is copied last, so its presence means that everything on it is there.
        let fetched = tools.folder.join("requirements.txt");
        let error = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
        let list = fs::read(&wanted).map_err(|e| error(&wanted, e))?;
        if fs::read(&fetched).is_ok_and(|there| there == list) {
            return Ok(tools);
        }
        if tools.folder.exists() {
            fs::remove_dir_all(&tools.folder).map_err(|e| error(&tools.folder, e))?;
        }
        let python = Path::new("python3");
        let options =
            "-m pip install --quiet --disable-pip-version-check --no-deps --only-binary :all: --require-hashes";
        tools.run(
            python,
            options.split(' ').map(OsStr::new).chain([
                OsStr::new("--target"),
                tools.folder.as_os_str(),
                OsStr::new("--requirement"),
                wanted.as_os_str(),
            ]),
        )?;
        fs::write(&fetched, list).map_err(|e| error(&fetched, e))?;
        Ok(tools)
    }

    /// Runs slangc in the folder `shaders`.
    pub fn slangc(&self, arguments: &[&OsStr]) -> Result<(), String> {
        self.run(&self.folder.join("slangtorch/bin/slangc"), arguments.iter().copied())
    }

    /// Runs spirv-val on a file.
    pub fn validate_spirv(&self, file: &Path) -> Result<(), String> {
        let program = self.folder.join("cmeel.prefix/bin/spirv-val");
        self.run(&program, ["--target-env", "vulkan1.2"].map(OsStr::new).into_iter().chain([file.as_os_str()]))
    }

    fn run<'a>(&self, program: &Path, arguments: impl Iterator<Item = &'a OsStr>) -> Result<(), String> {
        let name = program.file_name().unwrap_or_default().display();
        let output = Command::new(program)
            .args(arguments)
            .current_dir(self.root.join("shaders"))
            .output()
            .map_err(|error| format!("{name} does not start: {error}"))?;
        if output.status.success() {
            return Ok(());
        }
        let said = [output.stdout, output.stderr].concat();
        Err(format!("{name} failed:\n{}", String::from_utf8_lossy(&said)))
    }
}
