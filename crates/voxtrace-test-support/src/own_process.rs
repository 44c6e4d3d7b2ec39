//! A test that runs in a process of its own ([`in_own_process`]), so that it waits for no other test's turn and none waits for its.

use std::env;
use std::process::Command;
use std::thread;

/// Says to a process which of its tests is the one that it was started for.
const VARIABLE: &str = "VOXTRACE_TEST_PROCESS";

/// Runs a test in a process of its own: its one call, from the test's own thread.
///
/// # Panics
/// Where the test fails there, with all that it printed, and where the process cannot be started.
pub fn in_own_process(test: impl FnOnce()) {
    // The harness names the thread of a test after it, unless it runs tests one by one: then there is nobody to wait for.
    let name = thread::current().name().unwrap_or("main").to_owned();
    if name == "main" || env::var(VARIABLE).is_ok_and(|running| running == name) {
        return test();
    }
    let program = env::current_exe().expect("the program of the tests");
    // With two threads for its one test, the thread is named after it there too.
    let arguments = [&*name, "--exact", "--nocapture", "--test-threads=2"];
    let ended = Command::new(program).args(arguments).env(VARIABLE, &name).output().expect("its process starts");
    let printed = [ended.stdout, ended.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    eprintln!("{}{}", printed[0], printed[1]);
    let has_run = printed[0].contains("1 passed");
    assert!(ended.status.success() && has_run, "{name} failed in its own process: {}", ended.status);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where tests run one by one there is no other process.
    fn is_alone() -> bool {
        thread::current().name().is_none_or(|name| name == "main")
    }

    #[test]
    fn a_test_runs_there_and_not_here() {
        let mut has_run = false;
        in_own_process(|| has_run = true);
        assert_eq!(has_run, is_alone() || env::var(VARIABLE).is_ok());
    }

    #[test]
    #[should_panic(expected = "failed in its own process")]
    fn a_test_that_fails_there_fails_here() {
        // There the words are others, and the test fails.
        in_own_process(|| panic!("{}", if is_alone() { "failed in its own process" } else { "" }));
    }
}
