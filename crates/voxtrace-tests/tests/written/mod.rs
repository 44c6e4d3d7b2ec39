//! Files that other programs' libraries have written, by a script in `python/`. `VOXTRACE_PYTHON` names a Python that has the
//! libraries (else `python3`).

use std::path::Path;
use std::process::Command;

/// A folder with what a script writes. Where no Python can run it, `None` and a line that says so.
///
/// # Panics
/// There, with `VOXTRACE_REQUIRE_PYTHON=1`.
#[allow(dead_code, reason = "each test uses one")]
pub fn written(script: &str, libraries: &str) -> Option<tempfile::TempDir> {
    let failure = match written_if_possible(script, libraries) {
        Ok(folder) => return Some(folder),
        Err(failure) => failure,
    };
    let is_required = std::env::var("VOXTRACE_REQUIRE_PYTHON").is_ok_and(|value| value == "1");
    assert!(!is_required, "a Python with {libraries} is required: {failure}");
    None
}

/// As [`written`], for libraries that no Python needs to have.
///
/// # Errors
/// What Python says.
pub fn written_if_possible(script: &str, libraries: &str) -> Result<tempfile::TempDir, String> {
    let folder = tempfile::tempdir().unwrap();
    let python = std::env::var_os("VOXTRACE_PYTHON").unwrap_or_else(|| "python3".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("python").join(script);
    let failure = match Command::new(python).arg(script).arg(folder.path()).output() {
        Ok(output) if output.status.success() => return Ok(folder),
        Ok(output) => String::from_utf8_lossy(&output.stderr).into_owned(),
        Err(error) => error.to_string(),
    };
    println!("skipped: no Python with {libraries} ({})", failure.lines().last().unwrap_or_default());
    Err(failure)
}
