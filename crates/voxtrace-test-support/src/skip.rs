//! How a test says that it is skipped. The test harness takes such a test for one that passed and hides what it printed, so each
//! skip is also a line of the file that `VOXTRACE_SKIPPED` names, which `.ci/run` counts.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

/// Something that a test needs and a machine may lack. A variable says that it must be there: `VOXTRACE_REQUIRE_DATA=1` and so on.
#[derive(Clone, Copy, Debug)]
pub enum Need {
    /// The files of other programs.
    Data,
    /// An X server for a window (Xvfb) and what presses its keys (xdotool).
    Display,
    /// A Python with other programs' libraries.
    Python,
    /// A Vulkan device.
    Vulkan,
}

impl Need {
    const fn variable(self) -> &'static str {
        match self {
            Self::Data => "VOXTRACE_REQUIRE_DATA",
            Self::Display => "VOXTRACE_REQUIRE_DISPLAY",
            Self::Python => "VOXTRACE_REQUIRE_PYTHON",
            Self::Vulkan => "VOXTRACE_REQUIRE_VULKAN",
        }
    }
}

/// Says that the calling test is skipped because the machine lacks what it needs; the test returns then.
///
/// # Panics
/// Where the need's variable is 1: then a test that lacks it has failed.
pub fn skip_without(need: Need, reason: &str) {
    let is_required = std::env::var(need.variable()).is_ok_and(|value| value == "1");
    assert!(!is_required, "{}=1, but {reason}", need.variable());
    skip(reason);
}

/// Says that the calling test is skipped, on a machine that nobody promised anything else of; the test returns then.
///
/// # Panics
/// Where the file that `VOXTRACE_SKIPPED` names cannot be written.
pub fn skip(reason: &str) {
    // The harness names the thread of a test after it.
    let test = std::thread::current().name().unwrap_or("a test").to_owned();
    eprintln!("skipped: {test}: {reason}");
    if let Some(file) = std::env::var_os("VOXTRACE_SKIPPED") {
        note(Path::new(&file), &test, reason).unwrap_or_else(|error| panic!("{}: {error}", Path::new(&file).display()));
    }
}

/// Appends one line, `test<TAB>reason`, by one write, so that tests of several processes do not mix theirs.
fn note(file: &Path, test: &str, reason: &str) -> std::io::Result<()> {
    let line = format!("{test}\t{}\n", reason.replace(['\n', '\t'], " "));
    OpenOptions::new().create(true).append(true).open(file)?.write_all(line.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::note;

    #[test]
    fn each_skip_is_one_line_whatever_its_reason_says() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("skipped");
        note(&file, "walk::a_test", "no device\nnor\ta driver").unwrap();
        note(&file, "another", "no data").unwrap();
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "walk::a_test\tno device nor a driver\nanother\tno data\n");
        assert!(note(folder.path(), "a folder", "is no file").is_err());
    }
}
