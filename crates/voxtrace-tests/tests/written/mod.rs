//! Files that other programs' libraries have written, by a script in `python/`. `VOXTRACE_PYTHON` names a Python that has the
//! libraries (else `python3`).

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use voxtrace_test_support::{Need, skip, skip_without};

/// What a script writes, once for all tests of a process.
pub struct Written {
    script: &'static str,
    libraries: &'static str,
    is_promised: bool,
    folder: OnceLock<Result<PathBuf, String>>,
}

impl Written {
    /// By a script that needs libraries which `VOXTRACE_REQUIRE_PYTHON=1` promises.
    #[allow(dead_code, reason = "each test uses one")]
    pub const fn by(script: &'static str, libraries: &'static str) -> Self {
        Self { script, libraries, is_promised: true, folder: OnceLock::new() }
    }

    /// By a script that needs libraries which no Python needs to have.
    #[allow(dead_code, reason = "each test uses one")]
    pub const fn if_possible_by(script: &'static str, libraries: &'static str) -> Self {
        Self { script, libraries, is_promised: false, folder: OnceLock::new() }
    }

    /// The folder; `None` where no Python can run the script: then the caller's test is skipped.
    ///
    /// # Panics
    /// There, where the libraries are promised.
    pub fn folder(&self) -> Option<&Path> {
        match self.folder.get_or_init(|| run(self.script)) {
            Ok(folder) => return Some(folder),
            Err(failure) => {
                let reason = format!("no Python with {} ({failure})", self.libraries);
                if self.is_promised { skip_without(Need::Python, &reason) } else { skip(&reason) }
            }
        }
        None
    }
}

/// Runs a script with an empty folder below `target/tmp`. What fails is told by the last line that Python says.
fn run(script: &str) -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(script);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let python = std::env::var_os("VOXTRACE_PYTHON").unwrap_or_else(|| "python3".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("python").join(script);
    let output = Command::new(python).arg(script).arg(&folder).output().map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(folder);
    }
    Err(String::from_utf8_lossy(&output.stderr).lines().last().unwrap_or_default().to_owned())
}
